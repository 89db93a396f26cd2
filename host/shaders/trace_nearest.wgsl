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

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_39 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_40 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<type_24>,
}

struct type_46 {
    member: array<array<type_23, 8>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_29;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_42;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_46;

fn function_() {
    var local: array<type_23, 8>;
    var local_1: array<f32, 128>;
    var local_2: array<u32, 128>;
    var phi_393_: i32;
    var phi_394_: i32;
    var phi_404_: bool;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_417_: bool;
    var phi_422_: u32;
    var phi_435_: i32;
    var phi_455_: i32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_644_: f32;
    var phi_650_: f32;
    var phi_723_: f32;
    var phi_729_: f32;
    var phi_769_: f32;
    var phi_775_: f32;
    var phi_894_: i32;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_954_: i32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_3154_: bool;
    var phi_3134_: f32;
    var phi_1054_: u32;
    var phi_1057_: bool;
    var phi_1059_: u32;
    var phi_1061_: u32;
    var phi_1072_: bool;
    var phi_1105_: bool;
    var phi_1106_: u32;
    var phi_1107_: u32;
    var phi_3151_: bool;
    var phi_3139_: f32;
    var phi_1122_: type_4;
    var phi_1123_: type_4;
    var phi_1146_: type_4;
    var phi_1167_: u32;
    var phi_1259_: array<array<f32, 3>, 3>;
    var phi_2875_: bool;
    var phi_2890_: bool;
    var phi_2905_: bool;
    var phi_2920_: bool;
    var phi_2935_: bool;
    var phi_2950_: bool;
    var phi_1802_: f32;
    var phi_1803_: f32;
    var phi_1804_: f32;
    var phi_1805_: f32;
    var phi_1806_: vec3<f32>;
    var phi_1807_: vec3<f32>;
    var phi_1808_: vec3<f32>;
    var phi_1809_: vec3<f32>;
    var phi_2965_: bool;
    var phi_2980_: bool;
    var phi_2995_: bool;
    var phi_3010_: bool;
    var phi_3025_: bool;
    var phi_3040_: bool;
    var phi_2017_: f32;
    var phi_2037_: type_39;
    var phi_2038_: type_39;
    var phi_2041_: type_39;
    var phi_2042_: type_39;
    var phi_2043_: bool;
    var phi_2047_: type_39;
    var phi_2056_: type_23;
    var phi_2068_: type_4;
    var phi_2071_: type_23;
    var phi_2069_: type_4;
    var phi_2094_: type_4;
    var phi_2126_: bool;
    var phi_2127_: bool;
    var phi_2148_: type_23;
    var phi_2072_: type_23;
    var phi_3141_: bool;
    var phi_3409_: f32;
    var phi_3408_: f32;
    var phi_3309_: bool;
    var phi_3407_: f32;
    var phi_3308_: bool;
    var phi_3406_: f32;
    var phi_3307_: bool;
    var phi_3313_: f32;
    var phi_3306_: bool;
    var phi_3445_: bool;
    var phi_3312_: f32;
    var phi_2224_: type_40;
    var phi_2587_: u32;
    var phi_2614_: u32;
    var phi_2615_: u32;
    var phi_2616_: u32;
    var phi_2618_: u32;
    var phi_2619_: u32;
    var phi_2620_: bool;
    var phi_2629_: u32;
    var phi_2634_: bool;
    var phi_2636_: u32;
    var phi_2640_: bool;
    var phi_2641_: u32;
    var phi_2642_: u32;
    var phi_3472_: f32;
    var phi_3413_: bool;
    var phi_2653_: u32;
    var phi_2654_: bool;
    var phi_2655_: u32;
    var phi_2656_: u32;
    var phi_3471_: f32;
    var phi_3412_: bool;
    var phi_2657_: u32;
    var phi_2658_: bool;
    var phi_2659_: u32;
    var phi_2660_: u32;
    var phi_3470_: f32;
    var phi_3411_: bool;
    var phi_1055_: u32;
    var phi_1058_: bool;
    var phi_1060_: u32;
    var phi_1062_: u32;
    var phi_2661_: bool;
    var phi_3410_: bool;
    var phi_2668_: type_4;
    var phi_2669_: type_4;
    var phi_2692_: type_4;
    var phi_2744_: f32;
    var phi_2746_: f32;
    var phi_2747_: bool;
    var phi_2748_: f32;
    var phi_2749_: bool;
    var phi_3068_: u32;
    var phi_3086_: bool;
    var phi_3089_: bool;
    var phi_3102_: f32;
    var phi_3103_: f32;
    var phi_3108_: f32;
    var phi_3109_: f32;
    var phi_3110_: bool;
    var phi_3118_: f32;
    var phi_2764_: f32;
    var phi_2765_: f32;
    var phi_2777_: f32;
    var phi_2782_: type_23;
    var phi_3452_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = global;
            let _e79 = arrayLength((&global_2.member));
            let _e81 = arrayLength((&global_3.member));
            let _e89 = (_e77.x + (_e77.y * 2097152u));
            let _e92 = global_1.member[0u];
            let _e93 = bitcast<i32>(_e92);
            let _e94 = (_e89 < arrayLength((&global_4.member)));
            if _e94 {
                let _e95 = (_e89 < arrayLength((&global_5.member)));
                if _e95 {
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e103 = global_4.member[_e89].member_2[0u];
                    let _e105 = (bitcast<u32>(_e103) & 2147483647u);
                    let _e110 = global_4.member[_e89].member_2[1u];
                    let _e112 = (bitcast<u32>(_e110) & 2147483647u);
                    let _e117 = global_4.member[_e89].member_2[2u];
                    let _e119 = (bitcast<u32>(_e117) & 2147483647u);
                    let _e124 = global_4.member[_e89].member[0u];
                    let _e126 = (bitcast<u32>(_e124) & 2147483647u);
                    let _e131 = global_4.member[_e89].member[1u];
                    let _e133 = (bitcast<u32>(_e131) & 2147483647u);
                    let _e138 = global_4.member[_e89].member[2u];
                    let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                    let _e142 = select(_e112, _e105, (_e112 < _e105));
                    let _e144 = select(_e119, _e142, (_e119 < _e142));
                    let _e146 = select(_e126, _e144, (_e126 < _e144));
                    let _e148 = select(_e133, _e146, (_e133 < _e146));
                    let _e150 = select(_e140, _e148, (_e140 < _e148));
                    let _e154 = global_4.member[_e89].member_1;
                    let _e155 = bitcast<u32>(_e154);
                    let _e156 = (_e155 & 2147483647u);
                    let _e163 = global_4.member[_e89].member_3;
                    let _e164 = bitcast<u32>(_e163);
                    let _e165 = (_e164 & 2147483647u);
                    let _e169 = (((select(_e156, _e150, (_e156 < _e150)) < 2139095040u) && (_e165 <= 2139095040u)) && (_e144 > 0u));
                    if _e169 {
                        let _e172 = (bitcast<u32>(bitcast<f32>(_e144)) & 2147483647u);
                        if (_e172 >= 8388608u) {
                            phi_393_ = (bitcast<i32>((_e172 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_393_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e172)), 32u, (_e172 == 0u))));
                        }
                        let _e186 = phi_393_;
                        phi_394_ = _e186;
                    } else {
                        phi_394_ = 0i;
                    }
                    let _e188 = phi_394_;
                    let _e189 = (_e105 == _e144);
                    if _e189 {
                        phi_404_ = true;
                    } else {
                        phi_404_ = (_e112 == _e144);
                    }
                    let _e192 = phi_404_;
                    let _e193 = select(1u, 0u, _e189);
                    if _e192 {
                        let _e194 = (_e193 + 1u);
                        phi_414_ = _e194;
                        phi_415_ = _e194;
                        phi_417_ = select(true, false, (_e194 == 2u));
                    } else {
                        phi_414_ = u32();
                        phi_415_ = 0u;
                        phi_417_ = true;
                    }
                    let _e198 = phi_414_;
                    let _e200 = phi_415_;
                    let _e202 = phi_417_;
                    if _e202 {
                        phi_422_ = (_e200 + 1u);
                    } else {
                        phi_422_ = 0u;
                    }
                    let _e206 = phi_422_;
                    let _e207 = select(_e198, _e200, _e202);
                    let _e208 = select(_e193, select(2u, _e193, _e192), _e202);
                    if (_e93 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e93, 127i, (_e93 > 127i));
                    }
                    let _e213 = phi_435_;
                    let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
                    let _e224 = bitcast<f32>((bitcast<u32>(((_e93 - _e213) + 127i)) << bitcast<u32>(23i)));
                    let _e225 = -(_e188);
                    if (_e225 < -126i) {
                        phi_455_ = -126i;
                    } else {
                        phi_455_ = select(_e225, 127i, (_e225 > 127i));
                    }
                    let _e230 = phi_455_;
                    let _e235 = bitcast<f32>((bitcast<u32>((_e230 + 127i)) << bitcast<u32>(23i)));
                    let _e241 = bitcast<f32>((bitcast<u32>(((_e225 - _e230) + 127i)) << bitcast<u32>(23i)));
                    let _e245 = global_4.member[_e89].member;
                    let _e246 = (_e207 == 0u);
                    if _e246 {
                        phi_473_ = _e245[0];
                    } else {
                        phi_473_ = _e245[1];
                    }
                    let _e250 = phi_473_;
                    let _e251 = (_e207 == 2u);
                    if _e251 {
                        phi_479_ = _e245[2];
                    } else {
                        phi_479_ = _e250;
                    }
                    let _e254 = phi_479_;
                    let _e255 = bitcast<u32>(_e254);
                    let _e257 = ((_e255 & 2139095040u) != 0u);
                    let _e271 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e255 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e255 & 2147483648u))), _e254, _e257) * _e218) * select(0.00000011920929f, 1f, _e257)) * _e224);
                    let _e272 = global_4.member[_e89].member_2;
                    if _e246 {
                        phi_519_ = _e272[0];
                    } else {
                        phi_519_ = _e272[1];
                    }
                    let _e276 = phi_519_;
                    if _e251 {
                        phi_525_ = _e272[2];
                    } else {
                        phi_525_ = _e276;
                    }
                    let _e279 = phi_525_;
                    let _e280 = bitcast<u32>(_e279);
                    let _e282 = ((_e280 & 2139095040u) != 0u);
                    let _e296 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e280 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e280 & 2147483648u))), _e279, _e282) * _e235) * select(0.00000011920929f, 1f, _e282)) * _e241);
                    let _e300 = (bitcast<f32>((bitcast<u32>(_e296) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e303 = bitcast<f32>((bitcast<u32>(_e271) & 2147483647u));
                    let _e304 = (_e303 * 0.00000011920929f);
                    let _e307 = select(select(0.00000000000011368684f, _e304, (_e304 > 0.00000000000011368684f)), 0f, _e300);
                    let _e308 = select(0f, _e296, _e300);
                    let _e309 = (_e271 + _e307);
                    let _e310 = (_e271 - _e307);
                    let _e312 = select(38685626000000000000000000f, (1f / _e296), _e300);
                    let _e313 = (_e206 == 0u);
                    if _e313 {
                        phi_598_ = _e245[0];
                    } else {
                        phi_598_ = _e245[1];
                    }
                    let _e317 = phi_598_;
                    let _e318 = (_e206 == 2u);
                    if _e318 {
                        phi_604_ = _e245[2];
                    } else {
                        phi_604_ = _e317;
                    }
                    let _e321 = phi_604_;
                    let _e322 = bitcast<u32>(_e321);
                    let _e324 = ((_e322 & 2139095040u) != 0u);
                    let _e338 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e322 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e322 & 2147483648u))), _e321, _e324) * _e218) * select(0.00000011920929f, 1f, _e324)) * _e224);
                    if _e313 {
                        phi_644_ = _e272[0];
                    } else {
                        phi_644_ = _e272[1];
                    }
                    let _e342 = phi_644_;
                    if _e318 {
                        phi_650_ = _e272[2];
                    } else {
                        phi_650_ = _e342;
                    }
                    let _e345 = phi_650_;
                    let _e346 = bitcast<u32>(_e345);
                    let _e348 = ((_e346 & 2139095040u) != 0u);
                    let _e362 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e346 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e346 & 2147483648u))), _e345, _e348) * _e235) * select(0.00000011920929f, 1f, _e348)) * _e241);
                    let _e366 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e369 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                    let _e370 = (_e369 * 0.00000011920929f);
                    let _e373 = select(select(0.00000000000011368684f, _e370, (_e370 > 0.00000000000011368684f)), 0f, _e366);
                    let _e374 = select(0f, _e362, _e366);
                    let _e375 = (_e338 + _e373);
                    let _e376 = (_e338 - _e373);
                    let _e378 = select(38685626000000000000000000f, (1f / _e362), _e366);
                    let _e379 = (_e208 == 0u);
                    if _e379 {
                        phi_723_ = _e245[0];
                    } else {
                        phi_723_ = _e245[1];
                    }
                    let _e383 = phi_723_;
                    let _e384 = (_e208 == 2u);
                    if _e384 {
                        phi_729_ = _e245[2];
                    } else {
                        phi_729_ = _e383;
                    }
                    let _e387 = phi_729_;
                    let _e388 = bitcast<u32>(_e387);
                    let _e390 = ((_e388 & 2139095040u) != 0u);
                    let _e404 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e388 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e388 & 2147483648u))), _e387, _e390) * _e218) * select(0.00000011920929f, 1f, _e390)) * _e224);
                    if _e379 {
                        phi_769_ = _e272[0];
                    } else {
                        phi_769_ = _e272[1];
                    }
                    let _e408 = phi_769_;
                    if _e384 {
                        phi_775_ = _e272[2];
                    } else {
                        phi_775_ = _e408;
                    }
                    let _e411 = phi_775_;
                    let _e412 = bitcast<u32>(_e411);
                    let _e414 = ((_e412 & 2139095040u) != 0u);
                    let _e428 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e412 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e412 & 2147483648u))), _e411, _e414) * _e235) * select(0.00000011920929f, 1f, _e414)) * _e241);
                    let _e432 = (bitcast<f32>((bitcast<u32>(_e428) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e435 = bitcast<f32>((bitcast<u32>(_e404) & 2147483647u));
                    let _e436 = (_e435 * 0.00000011920929f);
                    let _e439 = select(select(0.00000000000011368684f, _e436, (_e436 > 0.00000000000011368684f)), 0f, _e432);
                    let _e440 = select(0f, _e428, _e432);
                    let _e441 = (_e404 + _e439);
                    let _e442 = (_e404 - _e439);
                    let _e444 = select(38685626000000000000000000f, (1f / _e428), _e432);
                    let _e446 = select(_e369, _e303, (_e303 > _e369));
                    let _e449 = (_e93 + _e188);
                    if (_e169 && (select(_e435, _e446, (_e446 > _e435)) <= 1099511600000f)) {
                        let _e459 = ((_e156 & 8388607u) | (select(0u, 1u, ((_e156 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e462 = bitcast<i32>((_e156 >> bitcast<u32>(23i)));
                        let _e466 = (_e459 == 0u);
                        let _e469 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e459)), 32u, _e466)) - 8i);
                        if (_e462 == 255i) {
                            phi_894_ = 255i;
                        } else {
                            phi_894_ = (((_e462 + select(0i, 1i, (_e462 == 0i))) - _e469) + _e449);
                        }
                        let _e477 = phi_894_;
                        let _e487 = (_e477 <= 0i);
                        if _e487 {
                            phi_917_ = u32();
                        } else {
                            if _e466 {
                                phi_916_ = u32();
                            } else {
                                phi_916_ = select(((bitcast<u32>(_e477) << bitcast<u32>(23i)) | ((_e459 << bitcast<u32>(((_e469 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e477 >= 255i));
                            }
                            let _e491 = phi_916_;
                            phi_917_ = _e491;
                        }
                        let _e493 = phi_917_;
                        let _e505 = ((_e165 & 8388607u) | (select(0u, 1u, ((_e165 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e508 = bitcast<i32>((_e165 >> bitcast<u32>(23i)));
                        let _e512 = (_e505 == 0u);
                        let _e515 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e505)), 32u, _e512)) - 8i);
                        if (_e508 == 255i) {
                            phi_954_ = 255i;
                        } else {
                            phi_954_ = (((_e508 + select(0i, 1i, (_e508 == 0i))) - _e515) + _e449);
                        }
                        let _e523 = phi_954_;
                        let _e533 = (_e523 <= 0i);
                        if _e533 {
                            phi_977_ = u32();
                        } else {
                            if _e512 {
                                phi_976_ = u32();
                            } else {
                                phi_976_ = select(((bitcast<u32>(_e523) << bitcast<u32>(23i)) | ((_e505 << bitcast<u32>(((_e515 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e523 >= 255i));
                            }
                            let _e537 = phi_976_;
                            phi_977_ = _e537;
                        }
                        let _e539 = phi_977_;
                        phi_985_ = bitcast<f32>(((_e164 & 2147483648u) | select(_e539, 0u, select(_e512, true, _e533))));
                        phi_986_ = bitcast<f32>(((_e155 & 2147483648u) | select(_e493, 0u, select(_e466, true, _e487))));
                    } else {
                        phi_985_ = 0f;
                        phi_986_ = 1f;
                    }
                    let _e545 = phi_985_;
                    let _e547 = phi_986_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_3154_ = false;
                    phi_3134_ = _e545;
                    phi_1054_ = ((3u * _e79) + 1u);
                    phi_1057_ = (_e547 <= _e545);
                    phi_1059_ = 0u;
                    phi_1061_ = select(0u, 2147483648u, (_e79 == 0u));
                    loop {
                        let _e554 = phi_3154_;
                        let _e556 = phi_3134_;
                        let _e558 = phi_1054_;
                        let _e560 = phi_1057_;
                        let _e562 = phi_1059_;
                        let _e564 = phi_1061_;
                        if _e560 {
                            phi_1072_ = true;
                        } else {
                            phi_1072_ = (_e562 > 0u);
                        }
                        let _e567 = phi_1072_;
                        if _e567 {
                            let _e568 = (_e558 > 0u);
                            if _e568 {
                                if _e560 {
                                    phi_1105_ = _e560;
                                    phi_1106_ = _e562;
                                    phi_1107_ = _e564;
                                } else {
                                    let _e569 = (_e562 - 1u);
                                    let _e570 = (_e569 % 128u);
                                    let _e571 = (_e570 < 128u);
                                    if _e571 {
                                    } else {
                                        phi_3410_ = true;
                                        break;
                                    }
                                    let _e573 = local_2[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3410_ = true;
                                        break;
                                    }
                                    let _e575 = local_1[_e570];
                                    phi_1105_ = (_e575 <= _e556);
                                    phi_1106_ = _e569;
                                    phi_1107_ = _e573;
                                }
                                let _e578 = phi_1105_;
                                let _e580 = phi_1106_;
                                let _e582 = phi_1107_;
                                if _e578 {
                                    let _e585 = ((_e582 & 2147483648u) != 0u);
                                    if _e585 {
                                        phi_3151_ = _e554;
                                        phi_3139_ = _e556;
                                        phi_1122_ = type_4(0u, ((_e582 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e592 = phi_3151_;
                                            let _e594 = phi_3139_;
                                            let _e596 = phi_1122_;
                                            if (_e596.member < _e596.member_1) {
                                                phi_1123_ = type_4((_e596.member + 1u), _e596.member_1);
                                                phi_1146_ = type_4(1u, _e596.member);
                                            } else {
                                                phi_1123_ = _e596;
                                                phi_1146_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e609 = phi_1123_;
                                            let _e611 = phi_1146_;
                                            let _e615 = (bitcast<i32>(_e611.member) != 0i);
                                            if _e615 {
                                                let _e616 = ((_e582 & 268435455u) + _e611.member_1);
                                                let _e617 = (_e616 < _e81);
                                                if _e617 {
                                                    if _e617 {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e621 = global_3.member[_e616].member_1;
                                                    phi_1167_ = _e621;
                                                } else {
                                                    phi_1167_ = 4294967295u;
                                                }
                                                let _e623 = phi_1167_;
                                                if (_e616 >= _e81) {
                                                    phi_1259_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e617 {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e625 = (_e207 % 3u);
                                                    let _e626 = (_e206 % 3u);
                                                    let _e627 = (_e208 % 3u);
                                                    if (_e625 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e633 = global_3.member[_e616].member[_e625];
                                                    if (_e626 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e639 = global_3.member[_e616].member[_e626];
                                                    if (_e627 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e645 = global_3.member[_e616].member[_e627];
                                                    let _e647 = (3u + _e625);
                                                    if (_e647 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e653 = global_3.member[_e616].member[_e647];
                                                    let _e654 = (3u + _e626);
                                                    if (_e654 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_3.member[_e616].member[_e654];
                                                    let _e661 = (3u + _e627);
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e667 = global_3.member[_e616].member[_e661];
                                                    let _e669 = (6u + _e625);
                                                    if (_e669 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e675 = global_3.member[_e616].member[_e669];
                                                    let _e676 = (6u + _e626);
                                                    if (_e676 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e682 = global_3.member[_e616].member[_e676];
                                                    let _e683 = (6u + _e627);
                                                    if (_e683 < 9u) {
                                                    } else {
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e689 = global_3.member[_e616].member[_e683];
                                                    phi_1259_ = array<array<f32, 3>, 3>(array<f32, 3>(_e633, _e639, _e645), array<f32, 3>(_e653, _e660, _e667), array<f32, 3>(_e675, _e682, _e689));
                                                }
                                                let _e693 = phi_1259_;
                                                let _e708 = (_e693[0][2] - _e404);
                                                let _e711 = (((_e693[0][0] - _e271) * _e440) - (_e708 * _e308));
                                                let _e714 = (((_e693[0][1] - _e338) * _e440) - (_e708 * _e374));
                                                let _e717 = (_e693[1][2] - _e404);
                                                let _e720 = (((_e693[1][0] - _e271) * _e440) - (_e717 * _e308));
                                                let _e723 = (((_e693[1][1] - _e338) * _e440) - (_e717 * _e374));
                                                let _e726 = (_e693[2][2] - _e404);
                                                let _e729 = (((_e693[2][0] - _e271) * _e440) - (_e726 * _e308));
                                                let _e732 = (((_e693[2][1] - _e338) * _e440) - (_e726 * _e374));
                                                let _e733 = (_e729 * _e723);
                                                let _e734 = (_e732 * _e720);
                                                let _e735 = (_e711 * _e732);
                                                let _e736 = (_e714 * _e729);
                                                let _e737 = (_e720 * _e714);
                                                let _e738 = (_e723 * _e711);
                                                let _e743 = (((_e733 >= _e734) && (_e735 >= _e736)) && (_e737 >= _e738));
                                                let _e749 = (_e743 || (((_e733 <= _e734) && (_e735 <= _e736)) && (_e737 <= _e738)));
                                                if _e749 {
                                                    let _e751 = select(-1f, 1f, _e743);
                                                    let _e753 = ((_e733 - _e734) * _e751);
                                                    let _e755 = select(0f, _e753, (_e753 > 0f));
                                                    let _e757 = ((_e735 - _e736) * _e751);
                                                    let _e759 = select(0f, _e757, (_e757 > 0f));
                                                    let _e761 = ((_e737 - _e738) * _e751);
                                                    let _e763 = select(0f, _e761, (_e761 > 0f));
                                                    let _e765 = ((_e755 + _e759) + _e763);
                                                    let _e767 = select(_e693[1][0], _e693[0][0], (_e693[0][0] < _e693[1][0]));
                                                    let _e771 = select(_e693[1][0], _e693[0][0], (_e693[0][0] > _e693[1][0]));
                                                    let _e775 = select(_e693[1][1], _e693[0][1], (_e693[0][1] < _e693[1][1]));
                                                    let _e779 = select(_e693[1][1], _e693[0][1], (_e693[0][1] > _e693[1][1]));
                                                    let _e783 = select(_e693[1][2], _e693[0][2], (_e693[0][2] < _e693[1][2]));
                                                    let _e787 = select(_e693[1][2], _e693[0][2], (_e693[0][2] > _e693[1][2]));
                                                    let _e792 = ((select(_e693[2][0], _e767, (_e767 < _e693[2][0])) - _e309) * _e312);
                                                    let _e793 = ((select(_e693[2][0], _e771, (_e771 > _e693[2][0])) - _e310) * _e312);
                                                    let _e796 = ((select(_e693[2][1], _e775, (_e775 < _e693[2][1])) - _e375) * _e378);
                                                    let _e797 = ((select(_e693[2][1], _e779, (_e779 > _e693[2][1])) - _e376) * _e378);
                                                    let _e800 = ((select(_e693[2][2], _e783, (_e783 < _e693[2][2])) - _e441) * _e444);
                                                    let _e801 = ((select(_e693[2][2], _e787, (_e787 > _e693[2][2])) - _e442) * _e444);
                                                    let _e803 = select(_e801, _e800, (_e800 < _e801));
                                                    let _e805 = select(_e801, _e800, (_e800 > _e801));
                                                    let _e807 = select(_e793, _e792, (_e792 < _e793));
                                                    let _e809 = select(_e797, _e796, (_e796 < _e797));
                                                    let _e811 = select(_e809, _e807, (_e807 > _e809));
                                                    let _e813 = select(_e803, _e811, (_e811 > _e803));
                                                    let _e815 = select(_e793, _e792, (_e792 > _e793));
                                                    let _e817 = select(_e797, _e796, (_e796 > _e797));
                                                    let _e819 = select(_e817, _e815, (_e815 < _e817));
                                                    let _e821 = select(_e805, _e819, (_e819 < _e805));
                                                    let _e822 = -(_e803);
                                                    let _e828 = select(_e547, _e813, (_e813 > _e547));
                                                    let _e832 = select(_e720, _e711, (_e711 < _e720));
                                                    let _e837 = select(_e720, _e711, (_e711 > _e720));
                                                    let _e844 = select(_e723, _e714, (_e714 < _e723));
                                                    let _e849 = select(_e723, _e714, (_e714 > _e723));
                                                    let _e858 = (((((_e749 && (_e765 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e729, _e832, (_e832 < _e729)) <= 0f) && (select(_e729, _e837, (_e837 > _e729)) >= 0f))) && ((select(_e732, _e844, (_e844 < _e732)) <= 0f) && (select(_e732, _e849, (_e849 > _e732)) >= 0f))) && (_e828 <= (_e821 + (select(_e822, _e805, (_e805 > _e822)) * 0.0000019073523f)))) && (_e828 <= _e594));
                                                    if _e858 {
                                                        let _e863 = (_e693[1][0] - _e693[0][0]);
                                                        let _e864 = (_e693[1][1] - _e693[0][1]);
                                                        let _e865 = (_e693[1][2] - _e693[0][2]);
                                                        let _e866 = vec3<f32>(_e863, _e864, _e865);
                                                        let _e867 = (_e693[2][0] - _e693[1][0]);
                                                        let _e868 = (_e693[2][1] - _e693[1][1]);
                                                        let _e869 = (_e693[2][2] - _e693[1][2]);
                                                        let _e870 = vec3<f32>(_e867, _e868, _e869);
                                                        let _e871 = (_e693[0][0] - _e693[2][0]);
                                                        let _e872 = (_e693[0][1] - _e693[2][1]);
                                                        let _e873 = (_e693[0][2] - _e693[2][2]);
                                                        let _e874 = vec3<f32>(_e871, _e872, _e873);
                                                        let _e875 = abs(_e863);
                                                        let _e876 = abs(_e864);
                                                        if (_e875 != _e875) {
                                                            phi_2875_ = true;
                                                        } else {
                                                            phi_2875_ = (_e876 >= _e875);
                                                        }
                                                        let _e880 = phi_2875_;
                                                        let _e881 = select(_e875, _e876, _e880);
                                                        let _e882 = abs(_e865);
                                                        if (_e881 != _e881) {
                                                            phi_2890_ = true;
                                                        } else {
                                                            phi_2890_ = (_e882 >= _e881);
                                                        }
                                                        let _e886 = phi_2890_;
                                                        let _e887 = select(_e881, _e882, _e886);
                                                        let _e888 = abs(_e867);
                                                        let _e889 = abs(_e868);
                                                        if (_e888 != _e888) {
                                                            phi_2905_ = true;
                                                        } else {
                                                            phi_2905_ = (_e889 >= _e888);
                                                        }
                                                        let _e893 = phi_2905_;
                                                        let _e894 = select(_e888, _e889, _e893);
                                                        let _e895 = abs(_e869);
                                                        if (_e894 != _e894) {
                                                            phi_2920_ = true;
                                                        } else {
                                                            phi_2920_ = (_e895 >= _e894);
                                                        }
                                                        let _e899 = phi_2920_;
                                                        let _e900 = select(_e894, _e895, _e899);
                                                        let _e901 = abs(_e871);
                                                        let _e902 = abs(_e872);
                                                        if (_e901 != _e901) {
                                                            phi_2935_ = true;
                                                        } else {
                                                            phi_2935_ = (_e902 >= _e901);
                                                        }
                                                        let _e906 = phi_2935_;
                                                        let _e907 = select(_e901, _e902, _e906);
                                                        let _e908 = abs(_e873);
                                                        if (_e907 != _e907) {
                                                            phi_2950_ = true;
                                                        } else {
                                                            phi_2950_ = (_e908 >= _e907);
                                                        }
                                                        let _e912 = phi_2950_;
                                                        let _e913 = select(_e907, _e908, _e912);
                                                        let _e915 = select(_e900, _e887, (_e887 > _e900));
                                                        let _e917 = select(_e913, _e915, (_e915 > _e913));
                                                        if (_e887 == _e917) {
                                                            phi_1802_ = _e723;
                                                            phi_1803_ = _e720;
                                                            phi_1804_ = _e714;
                                                            phi_1805_ = _e711;
                                                            phi_1806_ = vec3<f32>(_e693[0][0], _e693[0][1], _e693[0][2]);
                                                            phi_1807_ = _e874;
                                                            phi_1808_ = _e870;
                                                            phi_1809_ = _e866;
                                                        } else {
                                                            let _e919 = (_e900 == _e917);
                                                            let _e924 = vec3(_e919);
                                                            phi_1802_ = select(_e714, _e732, _e919);
                                                            phi_1803_ = select(_e711, _e729, _e919);
                                                            phi_1804_ = select(_e732, _e723, _e919);
                                                            phi_1805_ = select(_e729, _e720, _e919);
                                                            phi_1806_ = select(vec3<f32>(_e693[2][0], _e693[2][1], _e693[2][2]), vec3<f32>(_e693[1][0], _e693[1][1], _e693[1][2]), _e924);
                                                            phi_1807_ = select(_e870, _e866, _e924);
                                                            phi_1808_ = select(_e866, _e874, _e924);
                                                            phi_1809_ = select(_e874, _e870, _e924);
                                                        }
                                                        let _e930 = phi_1802_;
                                                        let _e932 = phi_1803_;
                                                        let _e934 = phi_1804_;
                                                        let _e936 = phi_1805_;
                                                        let _e938 = phi_1806_;
                                                        let _e940 = phi_1807_;
                                                        let _e942 = phi_1808_;
                                                        let _e944 = phi_1809_;
                                                        let _e951 = ((_e942.y * _e940.z) - (_e940.y * _e942.z));
                                                        let _e956 = ((_e942.z * _e940.x) - (_e940.z * _e942.x));
                                                        let _e959 = ((_e942.x * _e940.y) - (_e940.x * _e942.y));
                                                        let _e962 = ((_e755 >= _e759) && (_e755 >= _e763));
                                                        let _e963 = (_e759 >= _e763);
                                                        let _e977 = (((_e951 * (select(select(_e693[2][0], _e693[1][0], _e963), _e693[0][0], _e962) - _e271)) + (_e956 * (select(select(_e693[2][1], _e693[1][1], _e963), _e693[0][1], _e962) - _e338))) + (_e959 * (select(select(_e693[2][2], _e693[1][2], _e963), _e693[0][2], _e962) - _e404)));
                                                        let _e982 = (((_e951 * _e308) + (_e956 * _e374)) + (_e959 * _e440));
                                                        let _e983 = (_e932 - _e936);
                                                        let _e984 = (_e930 - _e934);
                                                        let _e987 = ((_e983 * _e983) + (_e984 * _e984));
                                                        let _e994 = (-(((_e936 * _e983) + (_e934 * _e984))) / select(0.000000000000000000000000000000000000011754944f, _e987, (_e987 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e996 = select(1f, _e994, (_e994 < 1f));
                                                        let _e998 = select(0f, _e996, (_e996 > 0f));
                                                        let _e1007 = ((_e938.x + (_e944.x * _e998)) - _e271);
                                                        let _e1010 = ((_e938.y + (_e944.y * _e998)) - _e338);
                                                        let _e1013 = ((_e938.z + (_e944.z * _e998)) - _e404);
                                                        let _e1016 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                        let _e1019 = bitcast<f32>((bitcast<u32>(_e1010) & 2147483647u));
                                                        let _e1021 = select(_e1019, _e1016, (_e1016 > _e1019));
                                                        let _e1024 = bitcast<f32>((bitcast<u32>(_e1013) & 2147483647u));
                                                        let _e1026 = select(_e1024, _e1021, (_e1021 > _e1024));
                                                        let _e1030 = abs(_e951);
                                                        let _e1031 = abs(_e956);
                                                        if (_e1030 != _e1030) {
                                                            phi_2965_ = true;
                                                        } else {
                                                            phi_2965_ = (_e1031 >= _e1030);
                                                        }
                                                        let _e1035 = phi_2965_;
                                                        let _e1036 = select(_e1030, _e1031, _e1035);
                                                        let _e1037 = abs(_e959);
                                                        if (_e1036 != _e1036) {
                                                            phi_2980_ = true;
                                                        } else {
                                                            phi_2980_ = (_e1037 >= _e1036);
                                                        }
                                                        let _e1041 = phi_2980_;
                                                        let _e1057 = abs(_e942.x);
                                                        let _e1058 = abs(_e942.y);
                                                        if (_e1057 != _e1057) {
                                                            phi_2995_ = true;
                                                        } else {
                                                            phi_2995_ = (_e1058 >= _e1057);
                                                        }
                                                        let _e1062 = phi_2995_;
                                                        let _e1063 = select(_e1057, _e1058, _e1062);
                                                        let _e1064 = abs(_e942.z);
                                                        if (_e1063 != _e1063) {
                                                            phi_3010_ = true;
                                                        } else {
                                                            phi_3010_ = (_e1064 >= _e1063);
                                                        }
                                                        let _e1068 = phi_3010_;
                                                        let _e1071 = abs(_e940.x);
                                                        let _e1072 = abs(_e940.y);
                                                        if (_e1071 != _e1071) {
                                                            phi_3025_ = true;
                                                        } else {
                                                            phi_3025_ = (_e1072 >= _e1071);
                                                        }
                                                        let _e1076 = phi_3025_;
                                                        let _e1077 = select(_e1071, _e1072, _e1076);
                                                        let _e1078 = abs(_e940.z);
                                                        if (_e1077 != _e1077) {
                                                            phi_3040_ = true;
                                                        } else {
                                                            phi_3040_ = (_e1078 >= _e1077);
                                                        }
                                                        let _e1082 = phi_3040_;
                                                        let _e1087 = ((bitcast<f32>((bitcast<u32>(((((_e951 * _e1007) + (_e956 * _e1010)) + (_e959 * _e1013)) - _e977)) & 2147483647u)) <= ((0.0000009536743f * select(_e917, _e1026, (_e1026 > _e917))) * select(_e1036, _e1037, _e1041))) && !((bitcast<f32>((bitcast<u32>(_e982) & 2147483647u)) <= ((0.0000038146973f * select(_e1063, _e1064, _e1068)) * select(_e1077, _e1078, _e1082)))));
                                                        let _e1088 = (_e977 / _e982);
                                                        if (_e858 && !(_e1087)) {
                                                            let _e1091 = (_e1013 / _e440);
                                                            let _e1099 = (((_e951 * (_e1007 - (_e308 * _e1091))) + (_e956 * (_e1010 - (_e374 * _e1091)))) / _e982);
                                                            phi_2017_ = select(select(_e1091, (_e1091 + _e1099), (bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u)) <= _e917)), _e1088, _e1087);
                                                        } else {
                                                            phi_2017_ = _e1088;
                                                        }
                                                        let _e1108 = phi_2017_;
                                                        let _e1110 = select(_e821, _e1108, (_e1108 < _e821));
                                                        let _e1112 = select(_e813, _e1110, (_e1110 > _e813));
                                                        let _e1113 = (1f / _e765);
                                                        phi_2037_ = type_39(_e1112, (_e759 * _e1113), (_e763 * _e1113), ((_e858 && (_e1112 >= _e547)) && (_e1112 <= _e594)));
                                                        phi_2038_ = type_39();
                                                    } else {
                                                        phi_2037_ = type_39();
                                                        phi_2038_ = type_39(0f, 0f, 0f, _e858);
                                                    }
                                                    let _e1122 = phi_2037_;
                                                    let _e1124 = phi_2038_;
                                                    phi_2041_ = _e1122;
                                                    phi_2042_ = _e1124;
                                                    phi_2043_ = select(true, false, _e858);
                                                } else {
                                                    phi_2041_ = type_39();
                                                    phi_2042_ = type_39(0f, 0f, 0f, _e749);
                                                    phi_2043_ = true;
                                                }
                                                let _e1127 = phi_2041_;
                                                let _e1129 = phi_2042_;
                                                let _e1131 = phi_2043_;
                                                if _e1131 {
                                                    phi_2047_ = _e1129;
                                                } else {
                                                    phi_2047_ = _e1127;
                                                }
                                                let _e1133 = phi_2047_;
                                                if _e1133.member_3 {
                                                    phi_2056_ = type_23(_e1133.member, _e1133.member_1, _e1133.member_2, _e623);
                                                } else {
                                                    phi_2056_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1140 = phi_2056_;
                                                if (_e1140.member_3 != 4294967295u) {
                                                    if (_e623 != 4294967295u) {
                                                        phi_2068_ = type_4(0u, 8u);
                                                        phi_2071_ = _e1140;
                                                        loop {
                                                            let _e1145 = phi_2068_;
                                                            let _e1147 = phi_2071_;
                                                            if (_e1145.member < _e1145.member_1) {
                                                                phi_2069_ = type_4((_e1145.member + 1u), _e1145.member_1);
                                                                phi_2094_ = type_4(1u, _e1145.member);
                                                            } else {
                                                                phi_2069_ = _e1145;
                                                                phi_2094_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1160 = phi_2069_;
                                                            let _e1162 = phi_2094_;
                                                            let _e1166 = (bitcast<i32>(_e1162.member) != 0i);
                                                            if _e1166 {
                                                                let _e1167 = (_e1162.member_1 < 8u);
                                                                if _e1167 {
                                                                } else {
                                                                    phi_3141_ = true;
                                                                    break;
                                                                }
                                                                let _e1172 = local[_e1162.member_1].member;
                                                                if (_e1147.member < _e1172) {
                                                                    phi_2127_ = true;
                                                                } else {
                                                                    let _e1174 = local[_e1162.member_1].member;
                                                                    if (_e1147.member == _e1174) {
                                                                        let _e1179 = local[_e1162.member_1].member_3;
                                                                        phi_2126_ = (_e1147.member_3 < _e1179);
                                                                    } else {
                                                                        phi_2126_ = false;
                                                                    }
                                                                    let _e1182 = phi_2126_;
                                                                    phi_2127_ = _e1182;
                                                                }
                                                                let _e1184 = phi_2127_;
                                                                if _e1184 {
                                                                    if _e1167 {
                                                                    } else {
                                                                        phi_3141_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1185 = local[_e1162.member_1];
                                                                    local[_e1162.member_1] = type_23(_e1147.member, _e1147.member_1, _e1147.member_2, _e1147.member_3);
                                                                    phi_2148_ = type_23(_e1185.member, _e1185.member_1, _e1185.member_2, _e1185.member_3);
                                                                } else {
                                                                    phi_2148_ = _e1147;
                                                                }
                                                                let _e1196 = phi_2148_;
                                                                phi_2072_ = _e1196;
                                                            } else {
                                                                phi_2072_ = type_23();
                                                            }
                                                            let _e1198 = phi_2072_;
                                                            continue;
                                                            continuing {
                                                                phi_2068_ = _e1160;
                                                                phi_2071_ = _e1198;
                                                                phi_3141_ = _e592;
                                                                break if !(_e1166);
                                                            }
                                                        }
                                                        let _e1201 = phi_3141_;
                                                        phi_3313_ = _e594;
                                                        phi_3306_ = _e1201;
                                                        if _e1201 {
                                                            break;
                                                        }
                                                        let _e1204 = local[7u].member_3;
                                                        if (_e1204 != 4294967295u) {
                                                            let _e1208 = local[7u].member;
                                                            phi_3409_ = _e1208;
                                                        } else {
                                                            phi_3409_ = _e594;
                                                        }
                                                        let _e1210 = phi_3409_;
                                                        phi_3408_ = _e1210;
                                                        phi_3309_ = _e1201;
                                                    } else {
                                                        phi_3408_ = _e594;
                                                        phi_3309_ = _e592;
                                                    }
                                                    let _e1212 = phi_3408_;
                                                    let _e1214 = phi_3309_;
                                                    phi_3407_ = _e1212;
                                                    phi_3308_ = _e1214;
                                                } else {
                                                    phi_3407_ = _e594;
                                                    phi_3308_ = _e592;
                                                }
                                                let _e1216 = phi_3407_;
                                                let _e1218 = phi_3308_;
                                                phi_3406_ = _e1216;
                                                phi_3307_ = _e1218;
                                            } else {
                                                phi_3406_ = _e594;
                                                phi_3307_ = _e592;
                                            }
                                            let _e1220 = phi_3406_;
                                            let _e1222 = phi_3307_;
                                            continue;
                                            continuing {
                                                phi_3151_ = _e1222;
                                                phi_3139_ = _e1220;
                                                phi_1122_ = _e609;
                                                phi_3313_ = _e1220;
                                                phi_3306_ = _e1222;
                                                break if !(_e615);
                                            }
                                        }
                                        let _e1225 = phi_3313_;
                                        let _e1227 = phi_3306_;
                                        phi_3410_ = _e1227;
                                        if _e1227 {
                                            break;
                                        }
                                        phi_3445_ = _e1227;
                                        phi_3312_ = _e1225;
                                    } else {
                                        phi_3445_ = _e554;
                                        phi_3312_ = _e556;
                                    }
                                    let _e1229 = phi_3445_;
                                    let _e1231 = phi_3312_;
                                    if _e585 {
                                        phi_2640_ = bool();
                                        phi_2641_ = u32();
                                        phi_2642_ = u32();
                                    } else {
                                        if (_e582 >= _e79) {
                                            phi_2224_ = type_40(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e582 < _e79) {
                                            } else {
                                                phi_3410_ = true;
                                                break;
                                            }
                                            let _e1234 = (_e207 % 3u);
                                            if (_e1234 < 3u) {
                                            } else {
                                                phi_3410_ = true;
                                                break;
                                            }
                                            let _e1240 = global_2.member[_e582].member[_e1234];
                                            let _e1246 = (_e206 % 3u);
                                            if (_e1246 < 3u) {
                                            } else {
                                                phi_3410_ = true;
                                                break;
                                            }
                                            let _e1252 = global_2.member[_e582].member[_e1246];
                                            let _e1258 = (_e208 % 3u);
                                            if (_e1258 < 3u) {
                                            } else {
                                                phi_3410_ = true;
                                                break;
                                            }
                                            let _e1264 = global_2.member[_e582].member[_e1258];
                                            let _e1274 = global_2.member[_e582].member_1;
                                            let _e1278 = global_2.member[_e582].member_2;
                                            phi_2224_ = type_40(array<vec4<f32>, 3>(vec4<f32>(_e1240[0], _e1240[1], _e1240[2], _e1240[3]), vec4<f32>(_e1252[0], _e1252[1], _e1252[2], _e1252[3]), vec4<f32>(_e1264[0], _e1264[1], _e1264[2], _e1264[3])), _e1274, _e1278);
                                        }
                                        let _e1281 = phi_2224_;
                                        let _e1292 = ((_e1281.member[0].x - _e309) * _e312);
                                        let _e1293 = ((_e1281.member[0].y - _e309) * _e312);
                                        let _e1294 = ((_e1281.member[0].z - _e310) * _e312);
                                        let _e1295 = ((_e1281.member[0].w - _e310) * _e312);
                                        let _e1305 = ((_e1281.member[1].x - _e375) * _e378);
                                        let _e1306 = ((_e1281.member[1].y - _e375) * _e378);
                                        let _e1307 = ((_e1281.member[1].z - _e376) * _e378);
                                        let _e1308 = ((_e1281.member[1].w - _e376) * _e378);
                                        let _e1318 = ((_e1281.member[2].x - _e441) * _e444);
                                        let _e1319 = ((_e1281.member[2].y - _e441) * _e444);
                                        let _e1320 = ((_e1281.member[2].z - _e442) * _e444);
                                        let _e1321 = ((_e1281.member[2].w - _e442) * _e444);
                                        let _e1323 = select(_e1320, _e1318, (_e1318 < _e1320));
                                        let _e1325 = select(_e1321, _e1319, (_e1319 < _e1321));
                                        let _e1327 = select(_e1320, _e1318, (_e1318 > _e1320));
                                        let _e1329 = select(_e1321, _e1319, (_e1319 > _e1321));
                                        let _e1331 = select(_e1294, _e1292, (_e1292 < _e1294));
                                        let _e1333 = select(_e1295, _e1293, (_e1293 < _e1295));
                                        let _e1335 = select(_e1307, _e1305, (_e1305 < _e1307));
                                        let _e1337 = select(_e1308, _e1306, (_e1306 < _e1308));
                                        let _e1339 = select(_e1335, _e1331, (_e1331 > _e1335));
                                        let _e1341 = select(_e1337, _e1333, (_e1333 > _e1337));
                                        let _e1343 = select(_e1323, _e1339, (_e1339 > _e1323));
                                        let _e1345 = select(_e1325, _e1341, (_e1341 > _e1325));
                                        let _e1347 = select(_e1294, _e1292, (_e1292 > _e1294));
                                        let _e1349 = select(_e1295, _e1293, (_e1293 > _e1295));
                                        let _e1351 = select(_e1307, _e1305, (_e1305 > _e1307));
                                        let _e1353 = select(_e1308, _e1306, (_e1306 > _e1308));
                                        let _e1355 = select(_e1351, _e1347, (_e1347 < _e1351));
                                        let _e1357 = select(_e1353, _e1349, (_e1349 < _e1353));
                                        let _e1362 = -(_e1323);
                                        let _e1363 = -(_e1325);
                                        let _e1370 = (select(_e1327, _e1355, (_e1355 < _e1327)) + (select(_e1362, _e1327, (_e1327 > _e1362)) * 0.0000019073523f));
                                        let _e1371 = (select(_e1329, _e1357, (_e1357 < _e1329)) + (select(_e1363, _e1329, (_e1329 > _e1363)) * 0.0000019073523f));
                                        let _e1373 = select(_e547, _e1343, (_e1343 > _e547));
                                        let _e1375 = select(_e547, _e1345, (_e1345 > _e547));
                                        let _e1380 = (_e1373 <= select(_e1231, _e1370, (_e1370 < _e1231)));
                                        let _e1381 = (_e1375 <= select(_e1231, _e1371, (_e1371 < _e1231)));
                                        let _e1382 = (_e1373 <= _e1375);
                                        if _e1380 {
                                            if _e1381 {
                                                if _e1382 {
                                                    phi_2587_ = _e1281.member_2;
                                                } else {
                                                    phi_2587_ = _e1281.member_1;
                                                }
                                                let _e1386 = phi_2587_;
                                                let _e1388 = (_e580 % 128u);
                                                let _e1389 = (_e1388 < 128u);
                                                if _e1389 {
                                                } else {
                                                    phi_3410_ = true;
                                                    break;
                                                }
                                                local_2[_e1388] = _e1386;
                                                if _e1389 {
                                                } else {
                                                    phi_3410_ = true;
                                                    break;
                                                }
                                                local_1[_e1388] = select(_e1373, _e1375, _e1382);
                                                if _e1382 {
                                                    phi_2614_ = _e1281.member_1;
                                                } else {
                                                    phi_2614_ = _e1281.member_2;
                                                }
                                                let _e1396 = phi_2614_;
                                                phi_2615_ = (_e580 + 1u);
                                                phi_2616_ = _e1396;
                                            } else {
                                                phi_2615_ = u32();
                                                phi_2616_ = u32();
                                            }
                                            let _e1398 = phi_2615_;
                                            let _e1400 = phi_2616_;
                                            phi_2618_ = _e1398;
                                            phi_2619_ = _e1400;
                                            phi_2620_ = select(true, false, _e1381);
                                        } else {
                                            phi_2618_ = u32();
                                            phi_2619_ = u32();
                                            phi_2620_ = true;
                                        }
                                        let _e1403 = phi_2618_;
                                        let _e1405 = phi_2619_;
                                        let _e1407 = phi_2620_;
                                        if _e1407 {
                                            if _e1380 {
                                                phi_2629_ = _e1281.member_1;
                                            } else {
                                                phi_2629_ = _e1281.member_2;
                                            }
                                            let _e1411 = phi_2629_;
                                            phi_2634_ = select(_e1381, true, _e1380);
                                            phi_2636_ = _e1411;
                                        } else {
                                            phi_2634_ = _e578;
                                            phi_2636_ = _e1405;
                                        }
                                        let _e1414 = phi_2634_;
                                        let _e1416 = phi_2636_;
                                        phi_2640_ = _e1414;
                                        phi_2641_ = select(_e1403, _e580, _e1407);
                                        phi_2642_ = _e1416;
                                    }
                                    let _e1419 = phi_2640_;
                                    let _e1421 = phi_2641_;
                                    let _e1423 = phi_2642_;
                                    phi_3472_ = _e1231;
                                    phi_3413_ = _e1229;
                                    phi_2653_ = (_e558 - 1u);
                                    phi_2654_ = select(_e1419, false, _e585);
                                    phi_2655_ = select(_e1421, _e580, _e585);
                                    phi_2656_ = select(_e1423, _e582, _e585);
                                } else {
                                    phi_3472_ = _e556;
                                    phi_3413_ = _e554;
                                    phi_2653_ = _e558;
                                    phi_2654_ = _e578;
                                    phi_2655_ = _e580;
                                    phi_2656_ = _e582;
                                }
                                let _e1428 = phi_3472_;
                                let _e1430 = phi_3413_;
                                let _e1432 = phi_2653_;
                                let _e1434 = phi_2654_;
                                let _e1436 = phi_2655_;
                                let _e1438 = phi_2656_;
                                phi_3471_ = _e1428;
                                phi_3412_ = _e1430;
                                phi_2657_ = _e1432;
                                phi_2658_ = _e1434;
                                phi_2659_ = _e1436;
                                phi_2660_ = _e1438;
                            } else {
                                phi_3471_ = _e556;
                                phi_3412_ = _e554;
                                phi_2657_ = u32();
                                phi_2658_ = bool();
                                phi_2659_ = u32();
                                phi_2660_ = u32();
                            }
                            let _e1440 = phi_3471_;
                            let _e1442 = phi_3412_;
                            let _e1444 = phi_2657_;
                            let _e1446 = phi_2658_;
                            let _e1448 = phi_2659_;
                            let _e1450 = phi_2660_;
                            phi_3470_ = _e1440;
                            phi_3411_ = _e1442;
                            phi_1055_ = _e1444;
                            phi_1058_ = _e1446;
                            phi_1060_ = _e1448;
                            phi_1062_ = _e1450;
                            phi_2661_ = _e568;
                        } else {
                            phi_3470_ = _e556;
                            phi_3411_ = _e554;
                            phi_1055_ = u32();
                            phi_1058_ = bool();
                            phi_1060_ = u32();
                            phi_1062_ = u32();
                            phi_2661_ = false;
                        }
                        let _e1452 = phi_3470_;
                        let _e1454 = phi_3411_;
                        let _e1456 = phi_1055_;
                        let _e1458 = phi_1058_;
                        let _e1460 = phi_1060_;
                        let _e1462 = phi_1062_;
                        let _e1464 = phi_2661_;
                        continue;
                        continuing {
                            phi_3154_ = _e1454;
                            phi_3134_ = _e1452;
                            phi_1054_ = _e1456;
                            phi_1057_ = _e1458;
                            phi_1059_ = _e1460;
                            phi_1061_ = _e1462;
                            phi_3410_ = _e1454;
                            break if !(_e1464);
                        }
                    }
                    let _e1467 = phi_3410_;
                    if _e1467 {
                        break;
                    }
                    phi_2668_ = type_4(0u, 8u);
                    loop {
                        let _e1469 = phi_2668_;
                        if (_e1469.member < _e1469.member_1) {
                            phi_2669_ = type_4((_e1469.member + 1u), _e1469.member_1);
                            phi_2692_ = type_4(1u, _e1469.member);
                        } else {
                            phi_2669_ = _e1469;
                            phi_2692_ = type_4(0u, type_4().member_1);
                        }
                        let _e1482 = phi_2669_;
                        let _e1484 = phi_2692_;
                        let _e1488 = (bitcast<i32>(_e1484.member) != 0i);
                        if _e1488 {
                            let _e1489 = (_e1484.member_1 < 8u);
                            if _e1489 {
                            } else {
                                phi_3452_ = true;
                                break;
                            }
                            let _e1491 = local[_e1484.member_1];
                            if (_e1491.member_3 != 4294967295u) {
                                let _e1497 = -(_e449);
                                let _e1498 = bitcast<u32>(_e1491.member);
                                let _e1502 = (bitcast<i32>((_e1498 >> bitcast<u32>(23i))) & 255i);
                                let _e1503 = (_e1502 + _e1497);
                                if (_e1502 == 255i) {
                                    phi_2765_ = _e1491.member;
                                } else {
                                    if (_e1502 > 0i) {
                                        if (_e1503 > 0i) {
                                            let _e1507 = (_e1503 < 255i);
                                            if _e1507 {
                                                phi_2744_ = bitcast<f32>((_e1498 + bitcast<u32>((_e1497 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_2744_ = f32();
                                            }
                                            let _e1514 = phi_2744_;
                                            phi_2746_ = _e1514;
                                            phi_2747_ = select(true, false, _e1507);
                                        } else {
                                            phi_2746_ = f32();
                                            phi_2747_ = true;
                                        }
                                        let _e1517 = phi_2746_;
                                        let _e1519 = phi_2747_;
                                        phi_2748_ = _e1517;
                                        phi_2749_ = _e1519;
                                    } else {
                                        phi_2748_ = f32();
                                        phi_2749_ = true;
                                    }
                                    let _e1521 = phi_2748_;
                                    let _e1523 = phi_2749_;
                                    if _e1523 {
                                        let _e1524 = (_e1498 & 2147483648u);
                                        let _e1531 = ((_e1498 & 8388607u) | (select(0u, 1u, ((_e1498 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1535 = (_e1531 == 0u);
                                        if _e1535 {
                                            phi_3118_ = bitcast<f32>(_e1524);
                                        } else {
                                            let _e1540 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1531)), 32u, _e1535) - 8u);
                                            let _e1543 = (_e1531 << bitcast<u32>((_e1540 & 31u)));
                                            let _e1545 = ((_e1503 + select(0i, 1i, (_e1502 == 0i))) - bitcast<i32>(_e1540));
                                            if (_e1545 >= 255i) {
                                                phi_3108_ = bitcast<f32>((_e1524 | 2139095040u));
                                                phi_3109_ = f32();
                                                phi_3110_ = true;
                                            } else {
                                                let _e1547 = (_e1545 > 0i);
                                                if _e1547 {
                                                    phi_3102_ = bitcast<f32>(((_e1524 | (bitcast<u32>(_e1545) << bitcast<u32>(23i))) | (_e1543 & 8388607u)));
                                                    phi_3103_ = f32();
                                                } else {
                                                    if (_e1545 < -24i) {
                                                        phi_3068_ = 26u;
                                                    } else {
                                                        phi_3068_ = bitcast<u32>((1i - _e1545));
                                                    }
                                                    let _e1552 = phi_3068_;
                                                    let _e1553 = (_e1552 & 31u);
                                                    let _e1555 = (_e1543 >> bitcast<u32>(_e1553));
                                                    let _e1559 = (_e1543 & ((1u << bitcast<u32>(_e1553)) - 1u));
                                                    let _e1563 = (1u << bitcast<u32>(((_e1552 - 1u) & 31u)));
                                                    if (_e1559 > _e1563) {
                                                        phi_3089_ = true;
                                                    } else {
                                                        if (_e1559 == _e1563) {
                                                            phi_3086_ = ((_e1555 & 1u) == 1u);
                                                        } else {
                                                            phi_3086_ = false;
                                                        }
                                                        let _e1569 = phi_3086_;
                                                        phi_3089_ = _e1569;
                                                    }
                                                    let _e1571 = phi_3089_;
                                                    phi_3102_ = f32();
                                                    phi_3103_ = bitcast<f32>((_e1524 | (_e1555 + select(0u, 1u, _e1571))));
                                                }
                                                let _e1584 = phi_3102_;
                                                let _e1586 = phi_3103_;
                                                phi_3108_ = _e1584;
                                                phi_3109_ = _e1586;
                                                phi_3110_ = _e1547;
                                            }
                                            let _e1590 = phi_3108_;
                                            let _e1592 = phi_3109_;
                                            let _e1594 = phi_3110_;
                                            phi_3118_ = select(_e1592, _e1590, _e1594);
                                        }
                                        let _e1598 = phi_3118_;
                                        phi_2764_ = _e1598;
                                    } else {
                                        phi_2764_ = _e1521;
                                    }
                                    let _e1600 = phi_2764_;
                                    phi_2765_ = _e1600;
                                }
                                let _e1602 = phi_2765_;
                                let _e1603 = bitcast<u32>(_e1602);
                                if ((_e1603 & 2147483647u) >= 2139095040u) {
                                    phi_2777_ = bitcast<f32>(((_e1603 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_2777_ = _e1602;
                                }
                                let _e1610 = phi_2777_;
                                phi_2782_ = type_23(_e1610, _e1491.member_1, _e1491.member_2, _e1491.member_3);
                            } else {
                                phi_2782_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1613 = phi_2782_;
                            if _e1489 {
                            } else {
                                phi_3452_ = true;
                                break;
                            }
                            local[_e1484.member_1] = type_23(_e1613.member, _e1613.member_1, _e1613.member_2, _e1613.member_3);
                        }
                        continue;
                        continuing {
                            phi_2668_ = _e1482;
                            phi_3452_ = _e1467;
                            break if !(_e1488);
                        }
                    }
                    let _e1621 = phi_3452_;
                    if _e1621 {
                        break;
                    }
                    let _e1622 = local;
                    if _e95 {
                    } else {
                        break;
                    }
                    global_5.member[_e89] = array<type_23, 8>(type_23(_e1622[0].member, _e1622[0].member_1, _e1622[0].member_2, _e1622[0].member_3), type_23(_e1622[1].member, _e1622[1].member_1, _e1622[1].member_2, _e1622[1].member_3), type_23(_e1622[2].member, _e1622[2].member_1, _e1622[2].member_2, _e1622[2].member_3), type_23(_e1622[3].member, _e1622[3].member_1, _e1622[3].member_2, _e1622[3].member_3), type_23(_e1622[4].member, _e1622[4].member_1, _e1622[4].member_2, _e1622[4].member_3), type_23(_e1622[5].member, _e1622[5].member_1, _e1622[5].member_2, _e1622[5].member_3), type_23(_e1622[6].member, _e1622[6].member_1, _e1622[6].member_2, _e1622[6].member_3), type_23(_e1622[7].member, _e1622[7].member_1, _e1622[7].member_2, _e1622[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
