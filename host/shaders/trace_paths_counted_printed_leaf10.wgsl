struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_34 {
    member: type_19,
    member_1: f32,
}

struct type_36 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_38 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_48 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_54 {
    member: type_46,
    member_1: u32,
}

struct type_61 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_38;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_61;
@group(0) @binding(1) 
var<storage> global_6: type_42;
@group(0) @binding(2) 
var<storage> global_7: type_50;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 128>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<u32, 3>;
    var local_17: array<u32, 3>;
    var local_18: array<u32, 3>;
    var local_19: array<array<f32, 3>, 3>;
    var local_20: array<u32, 3>;
    var local_21: array<f32, 3>;
    var local_22: array<f32, 3>;
    var phi_359_: i32;
    var phi_360_: i32;
    var phi_370_: bool;
    var phi_380_: u32;
    var phi_381_: u32;
    var phi_383_: bool;
    var phi_388_: u32;
    var phi_421_: i32;
    var phi_439_: f32;
    var phi_445_: f32;
    var phi_456_: f32;
    var phi_462_: f32;
    var phi_485_: f32;
    var phi_496_: f32;
    var phi_505_: f32;
    var phi_511_: f32;
    var phi_522_: f32;
    var phi_528_: f32;
    var phi_551_: f32;
    var phi_562_: f32;
    var phi_571_: f32;
    var phi_577_: f32;
    var phi_588_: f32;
    var phi_594_: f32;
    var phi_617_: f32;
    var phi_628_: f32;
    var phi_728_: f32;
    var phi_729_: f32;
    var phi_2966_: bool;
    var phi_811_: type_36;
    var phi_814_: type_54;
    var phi_816_: u32;
    var phi_818_: bool;
    var phi_820_: u32;
    var phi_831_: bool;
    var phi_917_: type_54;
    var phi_918_: bool;
    var phi_919_: u32;
    var phi_1842_: type_40;
    var phi_1851_: type_7;
    var phi_1852_: type_7;
    var phi_1875_: type_7;
    var phi_2959_: bool;
    var phi_2005_: type_7;
    var phi_2006_: type_7;
    var phi_2029_: type_7;
    var phi_3019_: bool;
    var phi_2592_: type_54;
    var phi_2669_: type_54;
    var phi_2670_: type_54;
    var phi_2671_: u32;
    var phi_2673_: type_54;
    var phi_2674_: u32;
    var phi_2675_: bool;
    var phi_2682_: type_54;
    var phi_2687_: type_54;
    var phi_2688_: bool;
    var phi_3036_: bool;
    var phi_938_: type_36;
    var phi_941_: type_7;
    var phi_942_: type_7;
    var phi_964_: type_7;
    var phi_1009_: u32;
    var phi_1033_: type_48;
    var phi_3032_: bool;
    var phi_1044_: type_7;
    var phi_1045_: type_7;
    var phi_1068_: type_7;
    var phi_1078_: type_7;
    var phi_1079_: type_7;
    var phi_1102_: type_7;
    var phi_3027_: bool;
    var phi_3040_: bool;
    var phi_3039_: bool;
    var phi_1665_: vec3<f32>;
    var phi_1666_: vec3<f32>;
    var phi_1697_: bool;
    var phi_1706_: vec3<f32>;
    var phi_1746_: type_19;
    var phi_1748_: type_19;
    var phi_1749_: bool;
    var phi_1753_: type_19;
    var phi_1754_: type_19;
    var phi_1755_: type_19;
    var phi_1756_: bool;
    var phi_1760_: type_19;
    var phi_1761_: bool;
    var phi_1765_: type_19;
    var phi_1766_: bool;
    var phi_1770_: type_19;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var phi_1803_: type_36;
    var phi_1804_: type_36;
    var phi_1805_: type_36;
    var phi_3042_: bool;
    var phi_939_: type_36;
    var phi_3041_: bool;
    var phi_3104_: bool;
    var phi_2690_: type_36;
    var phi_2691_: type_54;
    var phi_2692_: bool;
    var phi_2693_: u32;
    var phi_3103_: bool;
    var phi_2694_: type_36;
    var phi_2695_: type_54;
    var phi_2696_: u32;
    var phi_2697_: bool;
    var phi_2698_: u32;
    var phi_3102_: bool;
    var phi_2699_: type_36;
    var phi_2700_: type_54;
    var phi_2701_: u32;
    var phi_2702_: bool;
    var phi_2703_: u32;
    var phi_3101_: bool;
    var phi_812_: type_36;
    var phi_815_: type_54;
    var phi_817_: u32;
    var phi_819_: bool;
    var phi_821_: u32;
    var phi_2704_: bool;
    var phi_3100_: bool;
    var local_23: type_36;
    var phi_2756_: type_19;
    var local_24: type_36;
    var local_25: type_36;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e93 = arrayLength((&global_6.member));
            let _e104 = arrayLength((&global_5.member));
            let _e108 = global_2.member[0u][0u];
            let _e112 = global_2.member[0u][1u];
            let _e116 = global_2.member[0u][2u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e132 = global_2.member[1u][3u];
            let _e136 = (_e90.x + (_e90.y * 2097152u));
            let _e143 = (_e136 < arrayLength((&global_3.member)));
            if _e143 {
                let _e144 = (_e136 < arrayLength((&global_1.member)));
                if _e144 {
                    let _e145 = (_e136 < arrayLength((&global_4.member)));
                    if _e145 {
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e155 = global_3.member[_e136].member.member_2[0u];
                        let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                        let _e163 = global_3.member[_e136].member.member_2[1u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_3.member[_e136].member.member_2[2u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_3.member[_e136].member.member[0u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_3.member[_e136].member.member[1u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e195 = global_3.member[_e136].member.member[2u];
                        let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                        let _e199 = select(_e165, _e157, (_e165 < _e157));
                        let _e201 = select(_e173, _e199, (_e173 < _e199));
                        let _e203 = select(_e181, _e201, (_e181 < _e201));
                        let _e205 = select(_e189, _e203, (_e189 < _e203));
                        let _e207 = select(_e197, _e205, (_e197 < _e205));
                        let _e212 = global_3.member[_e136].member.member_1;
                        let _e214 = (bitcast<u32>(_e212) & 2147483647u);
                        let _e222 = global_3.member[_e136].member.member_3;
                        let _e228 = (((select(_e214, _e207, (_e214 < _e207)) < 2139095040u) && ((bitcast<u32>(_e222) & 2147483647u) <= 2139095040u)) && (_e201 > 0u));
                        if _e228 {
                            let _e231 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                            if (_e231 >= 8388608u) {
                                phi_359_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_359_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                            }
                            let _e245 = phi_359_;
                            phi_360_ = _e245;
                        } else {
                            phi_360_ = 0i;
                        }
                        let _e247 = phi_360_;
                        let _e248 = (_e157 == _e201);
                        if _e248 {
                            phi_370_ = true;
                        } else {
                            phi_370_ = (_e165 == _e201);
                        }
                        let _e251 = phi_370_;
                        let _e252 = select(1u, 0u, _e248);
                        if _e251 {
                            let _e253 = (_e252 + 1u);
                            phi_380_ = _e253;
                            phi_381_ = _e253;
                            phi_383_ = select(true, false, (_e253 == 2u));
                        } else {
                            phi_380_ = u32();
                            phi_381_ = 0u;
                            phi_383_ = true;
                        }
                        let _e257 = phi_380_;
                        let _e259 = phi_381_;
                        let _e261 = phi_383_;
                        if _e261 {
                            phi_388_ = (_e259 + 1u);
                        } else {
                            phi_388_ = 0u;
                        }
                        let _e265 = phi_388_;
                        let _e266 = select(_e257, _e259, _e261);
                        let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                        let _e268 = -(_e247);
                        if (_e268 < -126i) {
                            phi_421_ = -126i;
                        } else {
                            phi_421_ = select(_e268, 127i, (_e268 > 127i));
                        }
                        let _e273 = phi_421_;
                        let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                        let _e284 = bitcast<f32>((bitcast<u32>(((_e268 - _e273) + 127i)) << bitcast<u32>(23i)));
                        let _e289 = global_3.member[_e136].member.member;
                        let _e290 = (_e266 == 0u);
                        if _e290 {
                            phi_439_ = _e289[0];
                        } else {
                            phi_439_ = _e289[1];
                        }
                        let _e294 = phi_439_;
                        let _e295 = (_e266 == 2u);
                        if _e295 {
                            phi_445_ = _e289[2];
                        } else {
                            phi_445_ = _e294;
                        }
                        let _e298 = phi_445_;
                        let _e299 = global_3.member[_e136].member.member_2;
                        if _e290 {
                            phi_456_ = _e299[0];
                        } else {
                            phi_456_ = _e299[1];
                        }
                        let _e303 = phi_456_;
                        if _e295 {
                            phi_462_ = _e299[2];
                        } else {
                            phi_462_ = _e303;
                        }
                        let _e306 = phi_462_;
                        let _e308 = ((_e306 * _e278) * _e284);
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e312 {
                            let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                            phi_485_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                        } else {
                            phi_485_ = 0f;
                        }
                        let _e320 = phi_485_;
                        let _e321 = (_e298 + _e320);
                        let _e322 = (_e298 - _e320);
                        let _e323 = select(_e308, 0f, _e312);
                        if _e312 {
                            phi_496_ = 38685626000000000000000000f;
                        } else {
                            phi_496_ = (1f / _e308);
                        }
                        let _e326 = phi_496_;
                        let _e327 = (_e265 == 0u);
                        if _e327 {
                            phi_505_ = _e289[0];
                        } else {
                            phi_505_ = _e289[1];
                        }
                        let _e331 = phi_505_;
                        let _e332 = (_e265 == 2u);
                        if _e332 {
                            phi_511_ = _e289[2];
                        } else {
                            phi_511_ = _e331;
                        }
                        let _e335 = phi_511_;
                        if _e327 {
                            phi_522_ = _e299[0];
                        } else {
                            phi_522_ = _e299[1];
                        }
                        let _e339 = phi_522_;
                        if _e332 {
                            phi_528_ = _e299[2];
                        } else {
                            phi_528_ = _e339;
                        }
                        let _e342 = phi_528_;
                        let _e344 = ((_e342 * _e278) * _e284);
                        let _e348 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e348 {
                            let _e352 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) * 0.00000011920929f);
                            phi_551_ = select(0.00000000000011368684f, _e352, (_e352 > 0.00000000000011368684f));
                        } else {
                            phi_551_ = 0f;
                        }
                        let _e356 = phi_551_;
                        let _e357 = (_e335 + _e356);
                        let _e358 = (_e335 - _e356);
                        let _e359 = select(_e344, 0f, _e348);
                        if _e348 {
                            phi_562_ = 38685626000000000000000000f;
                        } else {
                            phi_562_ = (1f / _e344);
                        }
                        let _e362 = phi_562_;
                        let _e363 = (_e267 == 0u);
                        if _e363 {
                            phi_571_ = _e289[0];
                        } else {
                            phi_571_ = _e289[1];
                        }
                        let _e367 = phi_571_;
                        let _e368 = (_e267 == 2u);
                        if _e368 {
                            phi_577_ = _e289[2];
                        } else {
                            phi_577_ = _e367;
                        }
                        let _e371 = phi_577_;
                        if _e363 {
                            phi_588_ = _e299[0];
                        } else {
                            phi_588_ = _e299[1];
                        }
                        let _e375 = phi_588_;
                        if _e368 {
                            phi_594_ = _e299[2];
                        } else {
                            phi_594_ = _e375;
                        }
                        let _e378 = phi_594_;
                        let _e380 = ((_e378 * _e278) * _e284);
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e384 {
                            let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                            phi_617_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                        } else {
                            phi_617_ = 0f;
                        }
                        let _e392 = phi_617_;
                        let _e393 = (_e371 + _e392);
                        let _e394 = (_e371 - _e392);
                        let _e395 = select(_e380, 0f, _e384);
                        if _e384 {
                            phi_628_ = 38685626000000000000000000f;
                        } else {
                            phi_628_ = (1f / _e380);
                        }
                        let _e398 = phi_628_;
                        let _e401 = bitcast<f32>((bitcast<u32>(_e298) & 2147483647u));
                        let _e404 = bitcast<f32>((bitcast<u32>(_e335) & 2147483647u));
                        let _e406 = select(_e404, _e401, (_e401 > _e404));
                        let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                        if (_e228 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                            let _e414 = (_e247 / 3i);
                            let _e421 = bitcast<f32>((bitcast<u32>((_e414 + 127i)) << bitcast<u32>(23i)));
                            let _e428 = bitcast<f32>((bitcast<u32>(((_e247 - (2i * _e414)) + 127i)) << bitcast<u32>(23i)));
                            let _e429 = (((_e212 * _e421) * _e421) * _e428);
                            let _e431 = select(340282350000000000000000000000000000000f, _e429, (_e429 < 340282350000000000000000000000000000000f));
                            let _e436 = (((_e222 * _e421) * _e421) * _e428);
                            let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                            phi_728_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                            phi_729_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_728_ = 0f;
                            phi_729_ = 1f;
                        }
                        let _e442 = phi_728_;
                        let _e444 = phi_729_;
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e450 = global_3.member[_e136].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_11 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_22 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                        let _e454 = (_e266 % 3u);
                        let _e455 = (_e454 < 3u);
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e457 = local_22[_e454];
                        let _e458 = (_e265 % 3u);
                        let _e459 = (_e458 < 3u);
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e461 = local_22[_e458];
                        let _e462 = (_e267 % 3u);
                        let _e463 = (_e462 < 3u);
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e465 = local_22[_e462];
                        local_21 = array<f32, 3>(bitcast<f32>(_e120), bitcast<f32>(_e124), bitcast<f32>(_e128));
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e469 = local_21[_e454];
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e471 = local_21[_e458];
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e473 = local_21[_e462];
                        phi_2966_ = false;
                        phi_811_ = type_36(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e442), 0u, 0u);
                        phi_814_ = type_54(type_46(array<f32, 3>(_e457, _e461, _e465), array<f32, 3>(_e469, _e471, _e473)), select(0u, 2147483648u, (_e93 == 0u)));
                        phi_816_ = ((3u * _e93) + 1u);
                        phi_818_ = (_e444 <= _e442);
                        phi_820_ = 0u;
                        loop {
                            let _e481 = phi_2966_;
                            let _e483 = phi_811_;
                            let _e485 = phi_814_;
                            let _e487 = phi_816_;
                            let _e489 = phi_818_;
                            let _e491 = phi_820_;
                            local_23 = _e483;
                            local_24 = _e483;
                            if _e489 {
                                phi_831_ = true;
                            } else {
                                phi_831_ = (_e491 > 0u);
                            }
                            let _e494 = phi_831_;
                            if _e494 {
                                let _e495 = (_e487 > 0u);
                                if _e495 {
                                    if _e489 {
                                        phi_917_ = _e485;
                                        phi_918_ = _e489;
                                        phi_919_ = _e491;
                                    } else {
                                        let _e496 = (_e491 - 1u);
                                        let _e497 = (_e496 % 128u);
                                        let _e498 = (_e497 < 128u);
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e500 = local_6[_e497];
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e502 = local_5[_e497];
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e504 = local_4[_e497];
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e506 = local_3[_e497];
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e509 = local_2[_e497];
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e511 = local_1[_e497];
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e513 = local[_e497];
                                        if _e498 {
                                        } else {
                                            phi_3100_ = true;
                                            break;
                                        }
                                        let _e518 = local_11[_e497];
                                        phi_917_ = type_54(type_46(array<f32, 3>(_e502, _e504, _e506), array<f32, 3>(_e509, _e511, _e513)), _e500);
                                        phi_918_ = (_e518 <= _e483.member.member_1);
                                        phi_919_ = _e496;
                                    }
                                    let _e523 = phi_917_;
                                    let _e525 = phi_918_;
                                    let _e527 = phi_919_;
                                    if _e525 {
                                        if ((_e523.member_1 & 2147483648u) != 0u) {
                                            phi_3036_ = _e481;
                                            phi_938_ = _e483;
                                            phi_941_ = type_7(0u, ((_e523.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e859 = phi_3036_;
                                                let _e861 = phi_938_;
                                                let _e863 = phi_941_;
                                                local_25 = _e861;
                                                if (_e863.member < _e863.member_1) {
                                                    phi_942_ = type_7((_e863.member + 1u), _e863.member_1);
                                                    phi_964_ = type_7(1u, _e863.member);
                                                } else {
                                                    phi_942_ = _e863;
                                                    phi_964_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e876 = phi_942_;
                                                let _e878 = phi_964_;
                                                let _e882 = (bitcast<i32>(_e878.member) != 0i);
                                                if _e882 {
                                                    let _e888 = type_36(_e861.member, _e861.member_1, (_e861.member_2 + 1u));
                                                    local_8 = array<f32, 3>(_e523.member.member[0], _e523.member.member[1], _e523.member.member[2]);
                                                    local_7 = array<f32, 3>(_e523.member.member_1[0], _e523.member.member_1[1], _e523.member.member_1[2]);
                                                    let _e899 = ((_e523.member_1 & 268435455u) + _e878.member_1);
                                                    let _e900 = (_e899 < arrayLength((&global_7.member)));
                                                    if _e900 {
                                                        if _e900 {
                                                        } else {
                                                            phi_3041_ = true;
                                                            break;
                                                        }
                                                        let _e903 = global_7.member[_e899].member_1;
                                                        phi_1009_ = _e903;
                                                    } else {
                                                        phi_1009_ = 4294967295u;
                                                    }
                                                    let _e905 = phi_1009_;
                                                    local_18 = array<u32, 3>(_e266, _e265, _e267);
                                                    if _e900 {
                                                        if _e900 {
                                                        } else {
                                                            phi_3041_ = true;
                                                            break;
                                                        }
                                                        let _e908 = global_7.member[_e899];
                                                        phi_1033_ = _e908;
                                                    } else {
                                                        phi_1033_ = type_48(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e910 = phi_1033_;
                                                    local_20 = array<u32, 3>(_e910.member[0], _e910.member[1], _e910.member[2]);
                                                    local_19[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_19[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_19[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3032_ = _e859;
                                                    phi_1044_ = type_7(0u, 3u);
                                                    loop {
                                                        let _e920 = phi_3032_;
                                                        let _e922 = phi_1044_;
                                                        if (_e922.member < _e922.member_1) {
                                                            phi_1045_ = type_7((_e922.member + 1u), _e922.member_1);
                                                            phi_1068_ = type_7(1u, _e922.member);
                                                        } else {
                                                            phi_1045_ = _e922;
                                                            phi_1068_ = type_7(0u, type_7().member_1);
                                                        }
                                                        let _e935 = phi_1045_;
                                                        let _e937 = phi_1068_;
                                                        let _e941 = (bitcast<i32>(_e937.member) != 0i);
                                                        if _e941 {
                                                            phi_1078_ = type_7(0u, 3u);
                                                            loop {
                                                                let _e943 = phi_1078_;
                                                                if (_e943.member < _e943.member_1) {
                                                                    phi_1079_ = type_7((_e943.member + 1u), _e943.member_1);
                                                                    phi_1102_ = type_7(1u, _e943.member);
                                                                } else {
                                                                    phi_1079_ = _e943;
                                                                    phi_1102_ = type_7(0u, type_7().member_1);
                                                                }
                                                                let _e956 = phi_1079_;
                                                                let _e958 = phi_1102_;
                                                                let _e962 = (bitcast<i32>(_e958.member) != 0i);
                                                                if _e962 {
                                                                    let _e963 = (_e937.member_1 < 3u);
                                                                    if _e963 {
                                                                    } else {
                                                                        phi_3027_ = true;
                                                                        break;
                                                                    }
                                                                    let _e965 = local_20[_e937.member_1];
                                                                    let _e966 = (_e958.member_1 < 3u);
                                                                    if _e966 {
                                                                    } else {
                                                                        phi_3027_ = true;
                                                                        break;
                                                                    }
                                                                    let _e968 = local_18[_e958.member_1];
                                                                    let _e973 = ((_e965 >> bitcast<u32>(((10u * _e968) & 31u))) & 1023u);
                                                                    if _e966 {
                                                                    } else {
                                                                        phi_3027_ = true;
                                                                        break;
                                                                    }
                                                                    let _e975 = local_8[_e958.member_1];
                                                                    if _e966 {
                                                                    } else {
                                                                        phi_3027_ = true;
                                                                        break;
                                                                    }
                                                                    let _e977 = local_7[_e958.member_1];
                                                                    let _e988 = (_e975 + bitcast<f32>((bitcast<u32>((f32(_e973) * bitcast<f32>((bitcast<u32>(((_e977 - _e975) * 0.0009775171f)) ^ _e132)))) ^ _e132)));
                                                                    if _e963 {
                                                                    } else {
                                                                        phi_3027_ = true;
                                                                        break;
                                                                    }
                                                                    if _e966 {
                                                                    } else {
                                                                        phi_3027_ = true;
                                                                        break;
                                                                    }
                                                                    local_19[_e937.member_1][_e958.member_1] = select(select(_e977, _e988, (_e988 < _e977)), _e977, (_e973 == 1023u));
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1078_ = _e956;
                                                                    phi_3027_ = _e920;
                                                                    break if !(_e962);
                                                                }
                                                            }
                                                            let _e997 = phi_3027_;
                                                            phi_3039_ = _e997;
                                                            if _e997 {
                                                                break;
                                                            }
                                                            phi_3040_ = _e997;
                                                        } else {
                                                            phi_3040_ = _e920;
                                                        }
                                                        let _e999 = phi_3040_;
                                                        continue;
                                                        continuing {
                                                            phi_3032_ = _e999;
                                                            phi_1044_ = _e935;
                                                            phi_3039_ = _e999;
                                                            break if !(_e941);
                                                        }
                                                    }
                                                    let _e1002 = phi_3039_;
                                                    phi_3041_ = _e1002;
                                                    if _e1002 {
                                                        break;
                                                    }
                                                    let _e1003 = local_19;
                                                    let _e1020 = (_e1003[0][2] - _e371);
                                                    let _e1023 = (((_e1003[0][0] - _e298) * _e395) - (_e1020 * _e323));
                                                    let _e1026 = (((_e1003[0][1] - _e335) * _e395) - (_e1020 * _e359));
                                                    let _e1029 = (_e1003[1][2] - _e371);
                                                    let _e1032 = (((_e1003[1][0] - _e298) * _e395) - (_e1029 * _e323));
                                                    let _e1035 = (((_e1003[1][1] - _e335) * _e395) - (_e1029 * _e359));
                                                    let _e1038 = (_e1003[2][2] - _e371);
                                                    let _e1041 = (((_e1003[2][0] - _e298) * _e395) - (_e1038 * _e323));
                                                    let _e1044 = (((_e1003[2][1] - _e335) * _e395) - (_e1038 * _e359));
                                                    let _e1045 = (_e1041 * _e1035);
                                                    let _e1046 = (_e1044 * _e1032);
                                                    let _e1047 = (_e1023 * _e1044);
                                                    let _e1048 = (_e1026 * _e1041);
                                                    let _e1049 = (_e1032 * _e1026);
                                                    let _e1050 = (_e1035 * _e1023);
                                                    let _e1055 = (((_e1045 >= _e1046) && (_e1047 >= _e1048)) && (_e1049 >= _e1050));
                                                    if (_e1055 || (((_e1045 <= _e1046) && (_e1047 <= _e1048)) && (_e1049 <= _e1050))) {
                                                        let _e1062 = select(-1f, 1f, _e1055);
                                                        let _e1064 = ((_e1045 - _e1046) * _e1062);
                                                        let _e1066 = select(0f, _e1064, (_e1064 > 0f));
                                                        let _e1068 = ((_e1047 - _e1048) * _e1062);
                                                        let _e1070 = select(0f, _e1068, (_e1068 > 0f));
                                                        let _e1072 = ((_e1049 - _e1050) * _e1062);
                                                        let _e1074 = select(0f, _e1072, (_e1072 > 0f));
                                                        let _e1076 = ((_e1066 + _e1070) + _e1074);
                                                        if (_e1076 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1760_ = type_19();
                                                            phi_1761_ = true;
                                                        } else {
                                                            let _e1079 = select(_e1003[1][0], _e1003[0][0], (_e1003[0][0] < _e1003[1][0]));
                                                            let _e1083 = select(_e1003[1][0], _e1003[0][0], (_e1003[0][0] > _e1003[1][0]));
                                                            let _e1087 = select(_e1003[1][1], _e1003[0][1], (_e1003[0][1] < _e1003[1][1]));
                                                            let _e1091 = select(_e1003[1][1], _e1003[0][1], (_e1003[0][1] > _e1003[1][1]));
                                                            let _e1095 = select(_e1003[1][2], _e1003[0][2], (_e1003[0][2] < _e1003[1][2]));
                                                            let _e1099 = select(_e1003[1][2], _e1003[0][2], (_e1003[0][2] > _e1003[1][2]));
                                                            let _e1104 = ((select(_e1003[2][0], _e1079, (_e1079 < _e1003[2][0])) - _e321) * _e326);
                                                            let _e1105 = ((select(_e1003[2][0], _e1083, (_e1083 > _e1003[2][0])) - _e322) * _e326);
                                                            let _e1108 = ((select(_e1003[2][1], _e1087, (_e1087 < _e1003[2][1])) - _e357) * _e362);
                                                            let _e1109 = ((select(_e1003[2][1], _e1091, (_e1091 > _e1003[2][1])) - _e358) * _e362);
                                                            let _e1112 = ((select(_e1003[2][2], _e1095, (_e1095 < _e1003[2][2])) - _e393) * _e398);
                                                            let _e1113 = ((select(_e1003[2][2], _e1099, (_e1099 > _e1003[2][2])) - _e394) * _e398);
                                                            let _e1115 = select(_e1113, _e1112, (_e1112 < _e1113));
                                                            let _e1117 = select(_e1113, _e1112, (_e1112 > _e1113));
                                                            let _e1119 = select(_e1105, _e1104, (_e1104 < _e1105));
                                                            let _e1121 = select(_e1109, _e1108, (_e1108 < _e1109));
                                                            let _e1123 = select(_e1121, _e1119, (_e1119 > _e1121));
                                                            let _e1125 = select(_e1115, _e1123, (_e1123 > _e1115));
                                                            let _e1127 = select(_e1105, _e1104, (_e1104 > _e1105));
                                                            let _e1129 = select(_e1109, _e1108, (_e1108 > _e1109));
                                                            let _e1131 = select(_e1129, _e1127, (_e1127 < _e1129));
                                                            let _e1133 = select(_e1117, _e1131, (_e1131 < _e1117));
                                                            let _e1134 = -(_e1115);
                                                            let _e1140 = select(_e444, _e1125, (_e1125 > _e444));
                                                            if (_e1140 > (_e1133 + (select(_e1134, _e1117, (_e1117 > _e1134)) * 0.0000019073523f))) {
                                                                phi_1755_ = type_19();
                                                                phi_1756_ = true;
                                                            } else {
                                                                let _e1142 = (_e1140 > _e861.member.member_1);
                                                                if _e1142 {
                                                                    phi_1754_ = type_19();
                                                                } else {
                                                                    let _e1146 = (_e1003[1][0] - _e1003[0][0]);
                                                                    let _e1147 = (_e1003[1][1] - _e1003[0][1]);
                                                                    let _e1148 = (_e1003[1][2] - _e1003[0][2]);
                                                                    let _e1149 = vec3<f32>(_e1146, _e1147, _e1148);
                                                                    let _e1150 = (_e1003[2][0] - _e1003[1][0]);
                                                                    let _e1151 = (_e1003[2][1] - _e1003[1][1]);
                                                                    let _e1152 = (_e1003[2][2] - _e1003[1][2]);
                                                                    let _e1153 = vec3<f32>(_e1150, _e1151, _e1152);
                                                                    let _e1154 = (_e1003[0][0] - _e1003[2][0]);
                                                                    let _e1155 = (_e1003[0][1] - _e1003[2][1]);
                                                                    let _e1156 = (_e1003[0][2] - _e1003[2][2]);
                                                                    let _e1157 = vec3<f32>(_e1154, _e1155, _e1156);
                                                                    let _e1160 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                    let _e1163 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
                                                                    let _e1165 = select(_e1163, _e1160, (_e1160 > _e1163));
                                                                    let _e1168 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
                                                                    let _e1170 = select(_e1168, _e1165, (_e1165 > _e1168));
                                                                    let _e1173 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                    let _e1176 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                    let _e1178 = select(_e1176, _e1173, (_e1173 > _e1176));
                                                                    let _e1181 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                    let _e1183 = select(_e1181, _e1178, (_e1178 > _e1181));
                                                                    let _e1186 = bitcast<f32>((bitcast<u32>(_e1154) & 2147483647u));
                                                                    let _e1189 = bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u));
                                                                    let _e1191 = select(_e1189, _e1186, (_e1186 > _e1189));
                                                                    let _e1194 = bitcast<f32>((bitcast<u32>(_e1156) & 2147483647u));
                                                                    let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                                                                    let _e1198 = select(_e1183, _e1170, (_e1170 > _e1183));
                                                                    let _e1200 = select(_e1196, _e1198, (_e1198 > _e1196));
                                                                    if (_e1170 == _e1200) {
                                                                        phi_1665_ = _e1153;
                                                                        phi_1666_ = _e1157;
                                                                    } else {
                                                                        let _e1203 = vec3((_e1183 == _e1200));
                                                                        phi_1665_ = select(_e1149, _e1157, _e1203);
                                                                        phi_1666_ = select(_e1153, _e1149, _e1203);
                                                                    }
                                                                    let _e1207 = phi_1665_;
                                                                    let _e1209 = phi_1666_;
                                                                    let _e1216 = ((_e1207.y * _e1209.z) - (_e1209.y * _e1207.z));
                                                                    let _e1221 = ((_e1207.z * _e1209.x) - (_e1209.z * _e1207.x));
                                                                    let _e1224 = ((_e1207.x * _e1209.y) - (_e1209.x * _e1207.y));
                                                                    if (_e1066 >= _e1070) {
                                                                        phi_1697_ = select(true, false, (_e1066 >= _e1074));
                                                                    } else {
                                                                        phi_1697_ = true;
                                                                    }
                                                                    let _e1229 = phi_1697_;
                                                                    if _e1229 {
                                                                        phi_1706_ = select(vec3<f32>(_e1003[2][0], _e1003[2][1], _e1003[2][2]), vec3<f32>(_e1003[1][0], _e1003[1][1], _e1003[1][2]), vec3((_e1070 >= _e1074)));
                                                                    } else {
                                                                        phi_1706_ = vec3<f32>(_e1003[0][0], _e1003[0][1], _e1003[0][2]);
                                                                    }
                                                                    let _e1234 = phi_1706_;
                                                                    let _e1251 = ((((_e1216 * (_e1234.x - _e298)) + (_e1221 * (_e1234.y - _e335))) + (_e1224 * (_e1234.z - _e371))) / (((_e1216 * _e323) + (_e1221 * _e359)) + (_e1224 * _e395)));
                                                                    let _e1253 = select(_e1133, _e1251, (_e1251 < _e1133));
                                                                    let _e1255 = select(_e1125, _e1253, (_e1253 > _e1125));
                                                                    if (_e1255 >= _e444) {
                                                                        let _e1257 = (_e1255 <= _e861.member.member_1);
                                                                        if _e1257 {
                                                                            let _e1258 = (1f / _e1076);
                                                                            phi_1746_ = type_19(_e1255, (_e1070 * _e1258), (_e1074 * _e1258), _e905);
                                                                        } else {
                                                                            phi_1746_ = type_19();
                                                                        }
                                                                        let _e1263 = phi_1746_;
                                                                        phi_1748_ = _e1263;
                                                                        phi_1749_ = select(true, false, _e1257);
                                                                    } else {
                                                                        phi_1748_ = type_19();
                                                                        phi_1749_ = true;
                                                                    }
                                                                    let _e1266 = phi_1748_;
                                                                    let _e1268 = phi_1749_;
                                                                    if _e1268 {
                                                                        phi_1753_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1753_ = _e1266;
                                                                    }
                                                                    let _e1270 = phi_1753_;
                                                                    phi_1754_ = _e1270;
                                                                }
                                                                let _e1272 = phi_1754_;
                                                                phi_1755_ = _e1272;
                                                                phi_1756_ = _e1142;
                                                            }
                                                            let _e1274 = phi_1755_;
                                                            let _e1276 = phi_1756_;
                                                            phi_1760_ = _e1274;
                                                            phi_1761_ = _e1276;
                                                        }
                                                        let _e1278 = phi_1760_;
                                                        let _e1280 = phi_1761_;
                                                        phi_1765_ = _e1278;
                                                        phi_1766_ = _e1280;
                                                    } else {
                                                        phi_1765_ = type_19();
                                                        phi_1766_ = true;
                                                    }
                                                    let _e1282 = phi_1765_;
                                                    let _e1284 = phi_1766_;
                                                    if _e1284 {
                                                        phi_1770_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1770_ = _e1282;
                                                    }
                                                    let _e1286 = phi_1770_;
                                                    if (_e1286.member_3 != 4294967295u) {
                                                        if (_e905 != _e450) {
                                                            if (_e1286.member < _e861.member.member.member) {
                                                                phi_1796_ = true;
                                                            } else {
                                                                if (_e1286.member == _e861.member.member.member) {
                                                                    phi_1795_ = (_e1286.member_3 < _e861.member.member.member_3);
                                                                } else {
                                                                    phi_1795_ = false;
                                                                }
                                                                let _e1301 = phi_1795_;
                                                                phi_1796_ = _e1301;
                                                            }
                                                            let _e1303 = phi_1796_;
                                                            if _e1303 {
                                                                phi_1803_ = type_36(type_34(_e1286, _e1286.member), _e888.member_1, _e888.member_2);
                                                            } else {
                                                                phi_1803_ = _e888;
                                                            }
                                                            let _e1310 = phi_1803_;
                                                            phi_1804_ = _e1310;
                                                        } else {
                                                            phi_1804_ = _e888;
                                                        }
                                                        let _e1312 = phi_1804_;
                                                        phi_1805_ = _e1312;
                                                    } else {
                                                        phi_1805_ = _e888;
                                                    }
                                                    let _e1314 = phi_1805_;
                                                    phi_3042_ = _e1002;
                                                    phi_939_ = _e1314;
                                                } else {
                                                    phi_3042_ = _e859;
                                                    phi_939_ = type_36();
                                                }
                                                let _e1316 = phi_3042_;
                                                let _e1318 = phi_939_;
                                                continue;
                                                continuing {
                                                    phi_3036_ = _e1316;
                                                    phi_938_ = _e1318;
                                                    phi_941_ = _e876;
                                                    phi_3041_ = _e1316;
                                                    break if !(_e882);
                                                }
                                            }
                                            let _e1321 = phi_3041_;
                                            phi_3100_ = _e1321;
                                            if _e1321 {
                                                break;
                                            }
                                            phi_3104_ = _e1321;
                                            let _e1551 = local_25;
                                            phi_2690_ = _e1551;
                                            phi_2691_ = _e523;
                                            phi_2692_ = false;
                                            phi_2693_ = _e527;
                                        } else {
                                            local_10 = array<f32, 3>(_e523.member.member[0], _e523.member.member[1], _e523.member.member[2]);
                                            local_9 = array<f32, 3>(_e523.member.member_1[0], _e523.member.member_1[1], _e523.member.member_1[2]);
                                            let _e553 = (_e523.member_1 < _e93);
                                            if _e553 {
                                                if _e553 {
                                                } else {
                                                    phi_3100_ = true;
                                                    break;
                                                }
                                                let _e555 = global_6.member[_e523.member_1];
                                                phi_1842_ = _e555;
                                            } else {
                                                phi_1842_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e557 = phi_1842_;
                                            let _e559 = array<u32, 3>(_e266, _e265, _e267);
                                            local_17 = _e559;
                                            local_13 = array<f32, 3>(0f, 0f, 0f);
                                            local_12 = array<f32, 3>(0f, 0f, 0f);
                                            phi_1851_ = type_7(0u, 3u);
                                            loop {
                                                let _e561 = phi_1851_;
                                                if (_e561.member < _e561.member_1) {
                                                    phi_1852_ = type_7((_e561.member + 1u), _e561.member_1);
                                                    phi_1875_ = type_7(1u, _e561.member);
                                                } else {
                                                    phi_1852_ = _e561;
                                                    phi_1875_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e574 = phi_1852_;
                                                let _e576 = phi_1875_;
                                                let _e580 = (bitcast<i32>(_e576.member) != 0i);
                                                if _e580 {
                                                    let _e581 = (_e576.member_1 < 3u);
                                                    if _e581 {
                                                    } else {
                                                        phi_2959_ = true;
                                                        break;
                                                    }
                                                    let _e583 = local_17[_e576.member_1];
                                                    if _e581 {
                                                    } else {
                                                        phi_2959_ = true;
                                                        break;
                                                    }
                                                    let _e585 = local_10[_e576.member_1];
                                                    if _e581 {
                                                    } else {
                                                        phi_2959_ = true;
                                                        break;
                                                    }
                                                    let _e587 = local_9[_e576.member_1];
                                                    let _e590 = ((10u * _e583) & 31u);
                                                    let _e593 = ((_e557.member[0] >> bitcast<u32>(_e590)) & 1023u);
                                                    let _e598 = bitcast<f32>((bitcast<u32>(((_e587 - _e585) * 0.0009775171f)) ^ _e132));
                                                    let _e604 = (_e585 + bitcast<f32>((bitcast<u32>((f32(_e593) * _e598)) ^ _e132)));
                                                    if _e581 {
                                                    } else {
                                                        phi_2959_ = true;
                                                        break;
                                                    }
                                                    local_13[_e576.member_1] = select(select(_e587, _e604, (_e604 < _e587)), _e587, (_e593 == 1023u));
                                                    let _e613 = ((_e557.member[1] >> bitcast<u32>(_e590)) & 1023u);
                                                    let _e619 = (_e585 + bitcast<f32>((bitcast<u32>((f32(_e613) * _e598)) ^ _e132)));
                                                    if _e581 {
                                                    } else {
                                                        phi_2959_ = true;
                                                        break;
                                                    }
                                                    local_12[_e576.member_1] = select(select(_e587, _e619, (_e619 < _e587)), _e587, (_e613 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_1851_ = _e574;
                                                    phi_2959_ = _e481;
                                                    break if !(_e580);
                                                }
                                            }
                                            let _e627 = phi_2959_;
                                            phi_3100_ = _e627;
                                            if _e627 {
                                                break;
                                            }
                                            let _e628 = local_12;
                                            let _e629 = local_13;
                                            local_16 = _e559;
                                            local_15 = array<f32, 3>(0f, 0f, 0f);
                                            local_14 = array<f32, 3>(0f, 0f, 0f);
                                            phi_2005_ = type_7(0u, 3u);
                                            loop {
                                                let _e638 = phi_2005_;
                                                if (_e638.member < _e638.member_1) {
                                                    phi_2006_ = type_7((_e638.member + 1u), _e638.member_1);
                                                    phi_2029_ = type_7(1u, _e638.member);
                                                } else {
                                                    phi_2006_ = _e638;
                                                    phi_2029_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e651 = phi_2006_;
                                                let _e653 = phi_2029_;
                                                let _e657 = (bitcast<i32>(_e653.member) != 0i);
                                                if _e657 {
                                                    let _e658 = (_e653.member_1 < 3u);
                                                    if _e658 {
                                                    } else {
                                                        phi_3019_ = true;
                                                        break;
                                                    }
                                                    let _e660 = local_16[_e653.member_1];
                                                    if _e658 {
                                                    } else {
                                                        phi_3019_ = true;
                                                        break;
                                                    }
                                                    let _e662 = local_10[_e653.member_1];
                                                    if _e658 {
                                                    } else {
                                                        phi_3019_ = true;
                                                        break;
                                                    }
                                                    let _e664 = local_9[_e653.member_1];
                                                    let _e667 = ((10u * _e660) & 31u);
                                                    let _e670 = ((_e557.member_1[0] >> bitcast<u32>(_e667)) & 1023u);
                                                    let _e675 = bitcast<f32>((bitcast<u32>(((_e664 - _e662) * 0.0009775171f)) ^ _e132));
                                                    let _e681 = (_e662 + bitcast<f32>((bitcast<u32>((f32(_e670) * _e675)) ^ _e132)));
                                                    if _e658 {
                                                    } else {
                                                        phi_3019_ = true;
                                                        break;
                                                    }
                                                    local_15[_e653.member_1] = select(select(_e664, _e681, (_e681 < _e664)), _e664, (_e670 == 1023u));
                                                    let _e690 = ((_e557.member_1[1] >> bitcast<u32>(_e667)) & 1023u);
                                                    let _e696 = (_e662 + bitcast<f32>((bitcast<u32>((f32(_e690) * _e675)) ^ _e132)));
                                                    if _e658 {
                                                    } else {
                                                        phi_3019_ = true;
                                                        break;
                                                    }
                                                    local_14[_e653.member_1] = select(select(_e664, _e696, (_e696 < _e664)), _e664, (_e690 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_2005_ = _e651;
                                                    phi_3019_ = _e627;
                                                    break if !(_e657);
                                                }
                                            }
                                            let _e704 = phi_3019_;
                                            phi_3100_ = _e704;
                                            if _e704 {
                                                break;
                                            }
                                            let _e705 = local_14;
                                            let _e706 = local_15;
                                            let _e717 = type_54(type_46(array<f32, 3>(_e629[0], _e629[1], _e629[2]), array<f32, 3>(_e628[0], _e628[1], _e628[2])), _e557.member_2);
                                            let _e722 = type_54(type_46(array<f32, 3>(_e706[0], _e706[1], _e706[2]), array<f32, 3>(_e705[0], _e705[1], _e705[2])), _e557.member_3);
                                            let _e729 = ((_e629[0] - _e321) * _e326);
                                            let _e730 = ((_e706[0] - _e321) * _e326);
                                            let _e731 = ((_e628[0] - _e322) * _e326);
                                            let _e732 = ((_e705[0] - _e322) * _e326);
                                            let _e737 = ((_e629[1] - _e357) * _e362);
                                            let _e738 = ((_e706[1] - _e357) * _e362);
                                            let _e739 = ((_e628[1] - _e358) * _e362);
                                            let _e740 = ((_e705[1] - _e358) * _e362);
                                            let _e745 = ((_e629[2] - _e393) * _e398);
                                            let _e746 = ((_e706[2] - _e393) * _e398);
                                            let _e747 = ((_e628[2] - _e394) * _e398);
                                            let _e748 = ((_e705[2] - _e394) * _e398);
                                            let _e750 = select(_e747, _e745, (_e745 < _e747));
                                            let _e752 = select(_e748, _e746, (_e746 < _e748));
                                            let _e754 = select(_e747, _e745, (_e745 > _e747));
                                            let _e756 = select(_e748, _e746, (_e746 > _e748));
                                            let _e758 = select(_e731, _e729, (_e729 < _e731));
                                            let _e760 = select(_e732, _e730, (_e730 < _e732));
                                            let _e762 = select(_e739, _e737, (_e737 < _e739));
                                            let _e764 = select(_e740, _e738, (_e738 < _e740));
                                            let _e766 = select(_e762, _e758, (_e758 > _e762));
                                            let _e768 = select(_e764, _e760, (_e760 > _e764));
                                            let _e770 = select(_e750, _e766, (_e766 > _e750));
                                            let _e772 = select(_e752, _e768, (_e768 > _e752));
                                            let _e774 = select(_e731, _e729, (_e729 > _e731));
                                            let _e776 = select(_e732, _e730, (_e730 > _e732));
                                            let _e778 = select(_e739, _e737, (_e737 > _e739));
                                            let _e780 = select(_e740, _e738, (_e738 > _e740));
                                            let _e782 = select(_e778, _e774, (_e774 < _e778));
                                            let _e784 = select(_e780, _e776, (_e776 < _e780));
                                            let _e789 = -(_e750);
                                            let _e790 = -(_e752);
                                            let _e797 = (select(_e754, _e782, (_e782 < _e754)) + (select(_e789, _e754, (_e754 > _e789)) * 0.0000019073523f));
                                            let _e798 = (select(_e756, _e784, (_e784 < _e756)) + (select(_e790, _e756, (_e756 > _e790)) * 0.0000019073523f));
                                            let _e800 = select(_e444, _e770, (_e770 > _e444));
                                            let _e802 = select(_e444, _e772, (_e772 > _e444));
                                            let _e807 = (_e800 <= select(_e483.member.member_1, _e797, (_e797 < _e483.member.member_1)));
                                            let _e808 = (_e802 <= select(_e483.member.member_1, _e798, (_e798 < _e483.member.member_1)));
                                            let _e809 = (_e800 <= _e802);
                                            if _e807 {
                                                if _e808 {
                                                    if _e809 {
                                                        phi_2592_ = _e722;
                                                    } else {
                                                        phi_2592_ = _e717;
                                                    }
                                                    let _e811 = phi_2592_;
                                                    let _e819 = (_e527 % 128u);
                                                    let _e820 = (_e819 < 128u);
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local_6[_e819] = _e811.member_1;
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local_5[_e819] = _e811.member.member[0];
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local_4[_e819] = _e811.member.member[1];
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local_3[_e819] = _e811.member.member[2];
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local_2[_e819] = _e811.member.member_1[0];
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local_1[_e819] = _e811.member.member_1[1];
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local[_e819] = _e811.member.member_1[2];
                                                    if _e820 {
                                                    } else {
                                                        phi_3100_ = true;
                                                        break;
                                                    }
                                                    local_11[_e819] = select(_e802, _e800, (_e800 > _e802));
                                                    if _e809 {
                                                        phi_2669_ = _e717;
                                                    } else {
                                                        phi_2669_ = _e722;
                                                    }
                                                    let _e837 = phi_2669_;
                                                    phi_2670_ = _e837;
                                                    phi_2671_ = (_e527 + 1u);
                                                } else {
                                                    phi_2670_ = type_54();
                                                    phi_2671_ = u32();
                                                }
                                                let _e839 = phi_2670_;
                                                let _e841 = phi_2671_;
                                                phi_2673_ = _e839;
                                                phi_2674_ = _e841;
                                                phi_2675_ = select(true, false, _e808);
                                            } else {
                                                phi_2673_ = type_54();
                                                phi_2674_ = u32();
                                                phi_2675_ = true;
                                            }
                                            let _e844 = phi_2673_;
                                            let _e846 = phi_2674_;
                                            let _e848 = phi_2675_;
                                            if _e848 {
                                                if _e807 {
                                                    phi_2682_ = _e717;
                                                } else {
                                                    phi_2682_ = _e722;
                                                }
                                                let _e850 = phi_2682_;
                                                phi_2687_ = _e850;
                                                phi_2688_ = select(_e808, true, _e807);
                                            } else {
                                                phi_2687_ = _e844;
                                                phi_2688_ = _e525;
                                            }
                                            let _e853 = phi_2687_;
                                            let _e855 = phi_2688_;
                                            phi_3104_ = _e704;
                                            phi_2690_ = type_36(_e483.member, (_e483.member_1 + 1u), _e483.member_2);
                                            phi_2691_ = _e853;
                                            phi_2692_ = _e855;
                                            phi_2693_ = select(_e846, _e527, _e848);
                                        }
                                        let _e1323 = phi_3104_;
                                        let _e1325 = phi_2690_;
                                        let _e1327 = phi_2691_;
                                        let _e1329 = phi_2692_;
                                        let _e1331 = phi_2693_;
                                        phi_3103_ = _e1323;
                                        phi_2694_ = _e1325;
                                        phi_2695_ = _e1327;
                                        phi_2696_ = (_e487 - 1u);
                                        phi_2697_ = _e1329;
                                        phi_2698_ = _e1331;
                                    } else {
                                        phi_3103_ = _e481;
                                        phi_2694_ = _e483;
                                        phi_2695_ = _e523;
                                        phi_2696_ = _e487;
                                        phi_2697_ = _e525;
                                        phi_2698_ = _e527;
                                    }
                                    let _e1333 = phi_3103_;
                                    let _e1335 = phi_2694_;
                                    let _e1337 = phi_2695_;
                                    let _e1339 = phi_2696_;
                                    let _e1341 = phi_2697_;
                                    let _e1343 = phi_2698_;
                                    phi_3102_ = _e1333;
                                    phi_2699_ = _e1335;
                                    phi_2700_ = _e1337;
                                    phi_2701_ = _e1339;
                                    phi_2702_ = _e1341;
                                    phi_2703_ = _e1343;
                                } else {
                                    phi_3102_ = _e481;
                                    phi_2699_ = type_36();
                                    phi_2700_ = type_54();
                                    phi_2701_ = u32();
                                    phi_2702_ = bool();
                                    phi_2703_ = u32();
                                }
                                let _e1345 = phi_3102_;
                                let _e1347 = phi_2699_;
                                let _e1349 = phi_2700_;
                                let _e1351 = phi_2701_;
                                let _e1353 = phi_2702_;
                                let _e1355 = phi_2703_;
                                phi_3101_ = _e1345;
                                phi_812_ = _e1347;
                                phi_815_ = _e1349;
                                phi_817_ = _e1351;
                                phi_819_ = _e1353;
                                phi_821_ = _e1355;
                                phi_2704_ = _e495;
                            } else {
                                phi_3101_ = _e481;
                                phi_812_ = type_36();
                                phi_815_ = type_54();
                                phi_817_ = u32();
                                phi_819_ = bool();
                                phi_821_ = u32();
                                phi_2704_ = false;
                            }
                            let _e1357 = phi_3101_;
                            let _e1359 = phi_812_;
                            let _e1361 = phi_815_;
                            let _e1363 = phi_817_;
                            let _e1365 = phi_819_;
                            let _e1367 = phi_821_;
                            let _e1369 = phi_2704_;
                            continue;
                            continuing {
                                phi_2966_ = _e1357;
                                phi_811_ = _e1359;
                                phi_814_ = _e1361;
                                phi_816_ = _e1363;
                                phi_818_ = _e1365;
                                phi_820_ = _e1367;
                                phi_3100_ = _e1357;
                                break if !(_e1369);
                            }
                        }
                        let _e1372 = phi_3100_;
                        if _e1372 {
                            break;
                        }
                        let _e1374 = local_23;
                        if (_e1374.member.member.member_3 != 4294967295u) {
                            let _e1380 = (_e268 / 3i);
                            let _e1387 = bitcast<f32>((bitcast<u32>((_e1380 + 127i)) << bitcast<u32>(23i)));
                            let _e1395 = (((_e1374.member.member.member * _e1387) * _e1387) * bitcast<f32>((bitcast<u32>(((_e268 - (2i * _e1380)) + 127i)) << bitcast<u32>(23i))));
                            let _e1397 = select(340282350000000000000000000000000000000f, _e1395, (_e1395 < 340282350000000000000000000000000000000f));
                            phi_2756_ = type_19(select(-340282350000000000000000000000000000000f, _e1397, (_e1397 > -340282350000000000000000000000000000000f)), _e1374.member.member.member_1, _e1374.member.member.member_2, _e1374.member.member.member_3);
                        } else {
                            phi_2756_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1404 = phi_2756_;
                        if _e144 {
                        } else {
                            break;
                        }
                        global_1.member[_e136] = _e1404;
                        let _e1408 = local_24;
                        if _e145 {
                        } else {
                            break;
                        }
                        global_4.member[_e136] = _e1408.member_1;
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e1413 = select(0u, 1u, (_e212 <= _e222));
                        if (_e1413 > 0u) {
                            let _e1415 = (1u < _e104);
                            if _e1415 {
                                if (0u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1419 = atomicAdd((&global_5.member[0u]), _e1413);
                                if ((_e1419 + _e1413) < _e1419) {
                                    if _e1415 {
                                    } else {
                                        break;
                                    }
                                    let _e1424 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1427 = select(0u, 1u, (_e1404.member_3 != 4294967295u));
                        if (_e1427 > 0u) {
                            let _e1429 = (3u < _e104);
                            if _e1429 {
                                if (2u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1433 = atomicAdd((&global_5.member[2u]), _e1427);
                                if ((_e1433 + _e1427) < _e1433) {
                                    if _e1429 {
                                    } else {
                                        break;
                                    }
                                    let _e1438 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1408.member_1 > 0u) {
                            let _e1440 = (5u < _e104);
                            if _e1440 {
                                if (4u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1444 = atomicAdd((&global_5.member[4u]), _e1408.member_1);
                                if ((_e1444 + _e1408.member_1) < _e1444) {
                                    if _e1440 {
                                    } else {
                                        break;
                                    }
                                    let _e1449 = atomicAdd((&global_5.member[5u]), 1u);
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
