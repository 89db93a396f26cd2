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
    var phi_400_: i32;
    var phi_401_: i32;
    var phi_411_: bool;
    var phi_421_: u32;
    var phi_422_: u32;
    var phi_424_: bool;
    var phi_429_: u32;
    var phi_442_: i32;
    var phi_462_: i32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_605_: f32;
    var phi_611_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_730_: f32;
    var phi_736_: f32;
    var phi_776_: f32;
    var phi_782_: f32;
    var phi_901_: i32;
    var phi_923_: u32;
    var phi_924_: u32;
    var phi_961_: i32;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_992_: f32;
    var phi_993_: f32;
    var phi_3085_: bool;
    var phi_3064_: f32;
    var phi_1061_: bool;
    var phi_1064_: u32;
    var phi_1066_: u32;
    var phi_1068_: u32;
    var phi_1079_: bool;
    var phi_1112_: bool;
    var phi_1113_: u32;
    var phi_1114_: u32;
    var phi_2203_: type_40;
    var phi_2566_: u32;
    var phi_2593_: u32;
    var phi_2594_: u32;
    var phi_2595_: u32;
    var phi_2597_: u32;
    var phi_2598_: u32;
    var phi_2599_: bool;
    var phi_2608_: u32;
    var phi_2613_: bool;
    var phi_2614_: u32;
    var phi_3082_: bool;
    var phi_3071_: f32;
    var phi_1129_: type_4;
    var phi_1130_: type_4;
    var phi_1153_: type_4;
    var phi_1174_: u32;
    var phi_1266_: array<array<f32, 3>, 3>;
    var phi_1797_: f32;
    var phi_1798_: f32;
    var phi_1799_: f32;
    var phi_1800_: f32;
    var phi_1801_: vec3<f32>;
    var phi_1802_: vec3<f32>;
    var phi_1803_: vec3<f32>;
    var phi_1804_: vec3<f32>;
    var phi_1995_: f32;
    var phi_2015_: type_39;
    var phi_2016_: type_39;
    var phi_2019_: type_39;
    var phi_2020_: type_39;
    var phi_2021_: bool;
    var phi_2025_: type_39;
    var phi_2034_: type_23;
    var phi_2046_: type_4;
    var phi_2049_: type_23;
    var phi_2047_: type_4;
    var phi_2072_: type_4;
    var phi_2104_: bool;
    var phi_2105_: bool;
    var phi_2126_: type_23;
    var phi_2050_: type_23;
    var phi_3072_: bool;
    var phi_3314_: f32;
    var phi_3313_: f32;
    var phi_3228_: bool;
    var phi_3312_: f32;
    var phi_3227_: bool;
    var phi_3311_: f32;
    var phi_3226_: bool;
    var phi_3230_: f32;
    var phi_3225_: bool;
    var phi_3377_: f32;
    var phi_3319_: bool;
    var phi_2616_: bool;
    var phi_2617_: u32;
    var phi_2618_: u32;
    var phi_3376_: f32;
    var phi_3318_: bool;
    var phi_2619_: bool;
    var phi_2620_: u32;
    var phi_2621_: u32;
    var phi_2622_: u32;
    var phi_3375_: f32;
    var phi_3317_: bool;
    var phi_2623_: bool;
    var phi_2624_: u32;
    var phi_2625_: u32;
    var phi_2626_: u32;
    var phi_3374_: f32;
    var phi_3316_: bool;
    var phi_1062_: bool;
    var phi_1065_: u32;
    var phi_1067_: u32;
    var phi_1069_: u32;
    var phi_2627_: bool;
    var phi_3315_: bool;
    var phi_2634_: type_4;
    var phi_2635_: type_4;
    var phi_2658_: type_4;
    var phi_2710_: f32;
    var phi_2712_: f32;
    var phi_2713_: bool;
    var phi_2714_: f32;
    var phi_2715_: bool;
    var phi_2998_: u32;
    var phi_3016_: bool;
    var phi_3019_: bool;
    var phi_3032_: f32;
    var phi_3033_: f32;
    var phi_3038_: f32;
    var phi_3039_: f32;
    var phi_3040_: bool;
    var phi_3048_: f32;
    var phi_2730_: f32;
    var phi_2731_: f32;
    var phi_2743_: f32;
    var phi_2748_: type_23;
    var phi_3356_: bool;

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
                            phi_400_ = (bitcast<i32>((_e172 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_400_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e172)), 32u, (_e172 == 0u))));
                        }
                        let _e186 = phi_400_;
                        phi_401_ = _e186;
                    } else {
                        phi_401_ = 0i;
                    }
                    let _e188 = phi_401_;
                    let _e189 = (_e105 == _e144);
                    if _e189 {
                        phi_411_ = true;
                    } else {
                        phi_411_ = (_e112 == _e144);
                    }
                    let _e192 = phi_411_;
                    let _e193 = select(1u, 0u, _e189);
                    if _e192 {
                        let _e194 = (_e193 + 1u);
                        phi_421_ = _e194;
                        phi_422_ = _e194;
                        phi_424_ = select(true, false, (_e194 == 2u));
                    } else {
                        phi_421_ = u32();
                        phi_422_ = 0u;
                        phi_424_ = true;
                    }
                    let _e198 = phi_421_;
                    let _e200 = phi_422_;
                    let _e202 = phi_424_;
                    if _e202 {
                        phi_429_ = (_e200 + 1u);
                    } else {
                        phi_429_ = 0u;
                    }
                    let _e206 = phi_429_;
                    let _e207 = select(_e198, _e200, _e202);
                    let _e208 = select(_e193, select(2u, _e193, _e192), _e202);
                    if (_e93 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e93, 127i, (_e93 > 127i));
                    }
                    let _e213 = phi_442_;
                    let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
                    let _e224 = bitcast<f32>((bitcast<u32>(((_e93 - _e213) + 127i)) << bitcast<u32>(23i)));
                    let _e225 = -(_e188);
                    if (_e225 < -126i) {
                        phi_462_ = -126i;
                    } else {
                        phi_462_ = select(_e225, 127i, (_e225 > 127i));
                    }
                    let _e230 = phi_462_;
                    let _e235 = bitcast<f32>((bitcast<u32>((_e230 + 127i)) << bitcast<u32>(23i)));
                    let _e241 = bitcast<f32>((bitcast<u32>(((_e225 - _e230) + 127i)) << bitcast<u32>(23i)));
                    let _e245 = global_4.member[_e89].member;
                    let _e246 = (_e207 == 0u);
                    if _e246 {
                        phi_480_ = _e245[0];
                    } else {
                        phi_480_ = _e245[1];
                    }
                    let _e250 = phi_480_;
                    let _e251 = (_e207 == 2u);
                    if _e251 {
                        phi_486_ = _e245[2];
                    } else {
                        phi_486_ = _e250;
                    }
                    let _e254 = phi_486_;
                    let _e255 = bitcast<u32>(_e254);
                    let _e257 = ((_e255 & 2139095040u) != 0u);
                    let _e271 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e255 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e255 & 2147483648u))), _e254, _e257) * _e218) * select(0.00000011920929f, 1f, _e257)) * _e224);
                    let _e272 = global_4.member[_e89].member_2;
                    if _e246 {
                        phi_526_ = _e272[0];
                    } else {
                        phi_526_ = _e272[1];
                    }
                    let _e276 = phi_526_;
                    if _e251 {
                        phi_532_ = _e272[2];
                    } else {
                        phi_532_ = _e276;
                    }
                    let _e279 = phi_532_;
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
                        phi_605_ = _e245[0];
                    } else {
                        phi_605_ = _e245[1];
                    }
                    let _e317 = phi_605_;
                    let _e318 = (_e206 == 2u);
                    if _e318 {
                        phi_611_ = _e245[2];
                    } else {
                        phi_611_ = _e317;
                    }
                    let _e321 = phi_611_;
                    let _e322 = bitcast<u32>(_e321);
                    let _e324 = ((_e322 & 2139095040u) != 0u);
                    let _e338 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e322 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e322 & 2147483648u))), _e321, _e324) * _e218) * select(0.00000011920929f, 1f, _e324)) * _e224);
                    if _e313 {
                        phi_651_ = _e272[0];
                    } else {
                        phi_651_ = _e272[1];
                    }
                    let _e342 = phi_651_;
                    if _e318 {
                        phi_657_ = _e272[2];
                    } else {
                        phi_657_ = _e342;
                    }
                    let _e345 = phi_657_;
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
                        phi_730_ = _e245[0];
                    } else {
                        phi_730_ = _e245[1];
                    }
                    let _e383 = phi_730_;
                    let _e384 = (_e208 == 2u);
                    if _e384 {
                        phi_736_ = _e245[2];
                    } else {
                        phi_736_ = _e383;
                    }
                    let _e387 = phi_736_;
                    let _e388 = bitcast<u32>(_e387);
                    let _e390 = ((_e388 & 2139095040u) != 0u);
                    let _e404 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e388 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e388 & 2147483648u))), _e387, _e390) * _e218) * select(0.00000011920929f, 1f, _e390)) * _e224);
                    if _e379 {
                        phi_776_ = _e272[0];
                    } else {
                        phi_776_ = _e272[1];
                    }
                    let _e408 = phi_776_;
                    if _e384 {
                        phi_782_ = _e272[2];
                    } else {
                        phi_782_ = _e408;
                    }
                    let _e411 = phi_782_;
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
                            phi_901_ = 255i;
                        } else {
                            phi_901_ = (((_e462 + select(0i, 1i, (_e462 == 0i))) - _e469) + _e449);
                        }
                        let _e477 = phi_901_;
                        let _e487 = (_e477 <= 0i);
                        if _e487 {
                            phi_924_ = u32();
                        } else {
                            if _e466 {
                                phi_923_ = u32();
                            } else {
                                phi_923_ = select(((bitcast<u32>(_e477) << bitcast<u32>(23i)) | ((_e459 << bitcast<u32>(((_e469 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e477 >= 255i));
                            }
                            let _e491 = phi_923_;
                            phi_924_ = _e491;
                        }
                        let _e493 = phi_924_;
                        let _e505 = ((_e165 & 8388607u) | (select(0u, 1u, ((_e165 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e508 = bitcast<i32>((_e165 >> bitcast<u32>(23i)));
                        let _e512 = (_e505 == 0u);
                        let _e515 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e505)), 32u, _e512)) - 8i);
                        if (_e508 == 255i) {
                            phi_961_ = 255i;
                        } else {
                            phi_961_ = (((_e508 + select(0i, 1i, (_e508 == 0i))) - _e515) + _e449);
                        }
                        let _e523 = phi_961_;
                        let _e533 = (_e523 <= 0i);
                        if _e533 {
                            phi_984_ = u32();
                        } else {
                            if _e512 {
                                phi_983_ = u32();
                            } else {
                                phi_983_ = select(((bitcast<u32>(_e523) << bitcast<u32>(23i)) | ((_e505 << bitcast<u32>(((_e515 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e523 >= 255i));
                            }
                            let _e537 = phi_983_;
                            phi_984_ = _e537;
                        }
                        let _e539 = phi_984_;
                        phi_992_ = bitcast<f32>(((_e164 & 2147483648u) | select(_e539, 0u, select(_e512, true, _e533))));
                        phi_993_ = bitcast<f32>(((_e155 & 2147483648u) | select(_e493, 0u, select(_e466, true, _e487))));
                    } else {
                        phi_992_ = 0f;
                        phi_993_ = 1f;
                    }
                    let _e545 = phi_992_;
                    let _e547 = phi_993_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_3085_ = false;
                    phi_3064_ = _e545;
                    phi_1061_ = (_e547 <= _e545);
                    phi_1064_ = select(0u, 2147483648u, (_e79 == 0u));
                    phi_1066_ = 0u;
                    phi_1068_ = ((3u * _e79) + 1u);
                    loop {
                        let _e554 = phi_3085_;
                        let _e556 = phi_3064_;
                        let _e558 = phi_1061_;
                        let _e560 = phi_1064_;
                        let _e562 = phi_1066_;
                        let _e564 = phi_1068_;
                        if _e558 {
                            phi_1079_ = true;
                        } else {
                            phi_1079_ = (_e562 > 0u);
                        }
                        let _e567 = phi_1079_;
                        if _e567 {
                            let _e568 = (_e564 > 0u);
                            if _e568 {
                                if _e558 {
                                    phi_1112_ = _e558;
                                    phi_1113_ = _e560;
                                    phi_1114_ = _e562;
                                } else {
                                    let _e569 = (_e562 - 1u);
                                    let _e570 = (_e569 % 128u);
                                    let _e571 = (_e570 < 128u);
                                    if _e571 {
                                    } else {
                                        phi_3315_ = true;
                                        break;
                                    }
                                    let _e573 = local_2[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3315_ = true;
                                        break;
                                    }
                                    let _e575 = local_1[_e570];
                                    phi_1112_ = (_e575 <= _e556);
                                    phi_1113_ = _e573;
                                    phi_1114_ = _e569;
                                }
                                let _e578 = phi_1112_;
                                let _e580 = phi_1113_;
                                let _e582 = phi_1114_;
                                if _e578 {
                                    if ((_e580 & 2147483648u) != 0u) {
                                        phi_3082_ = _e554;
                                        phi_3071_ = _e556;
                                        phi_1129_ = type_4(0u, ((_e580 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e778 = phi_3082_;
                                            let _e780 = phi_3071_;
                                            let _e782 = phi_1129_;
                                            if (_e782.member < _e782.member_1) {
                                                phi_1130_ = type_4((_e782.member + 1u), _e782.member_1);
                                                phi_1153_ = type_4(1u, _e782.member);
                                            } else {
                                                phi_1130_ = _e782;
                                                phi_1153_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e795 = phi_1130_;
                                            let _e797 = phi_1153_;
                                            let _e801 = (bitcast<i32>(_e797.member) != 0i);
                                            if _e801 {
                                                let _e802 = ((_e580 & 268435455u) + _e797.member_1);
                                                let _e803 = (_e802 < _e81);
                                                if _e803 {
                                                    if _e803 {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e807 = global_3.member[_e802].member_1;
                                                    phi_1174_ = _e807;
                                                } else {
                                                    phi_1174_ = 4294967295u;
                                                }
                                                let _e809 = phi_1174_;
                                                if (_e802 >= _e81) {
                                                    phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e803 {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e811 = (_e207 % 3u);
                                                    let _e812 = (_e206 % 3u);
                                                    let _e813 = (_e208 % 3u);
                                                    if (_e811 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e819 = global_3.member[_e802].member[_e811];
                                                    if (_e812 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e825 = global_3.member[_e802].member[_e812];
                                                    if (_e813 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e831 = global_3.member[_e802].member[_e813];
                                                    let _e833 = (3u + _e811);
                                                    if (_e833 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e839 = global_3.member[_e802].member[_e833];
                                                    let _e840 = (3u + _e812);
                                                    if (_e840 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e846 = global_3.member[_e802].member[_e840];
                                                    let _e847 = (3u + _e813);
                                                    if (_e847 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e853 = global_3.member[_e802].member[_e847];
                                                    let _e855 = (6u + _e811);
                                                    if (_e855 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e861 = global_3.member[_e802].member[_e855];
                                                    let _e862 = (6u + _e812);
                                                    if (_e862 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e868 = global_3.member[_e802].member[_e862];
                                                    let _e869 = (6u + _e813);
                                                    if (_e869 < 9u) {
                                                    } else {
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = true;
                                                        break;
                                                    }
                                                    let _e875 = global_3.member[_e802].member[_e869];
                                                    phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(_e819, _e825, _e831), array<f32, 3>(_e839, _e846, _e853), array<f32, 3>(_e861, _e868, _e875));
                                                }
                                                let _e879 = phi_1266_;
                                                let _e894 = (_e879[0][2] - _e404);
                                                let _e897 = (((_e879[0][0] - _e271) * _e440) - (_e894 * _e308));
                                                let _e900 = (((_e879[0][1] - _e338) * _e440) - (_e894 * _e374));
                                                let _e903 = (_e879[1][2] - _e404);
                                                let _e906 = (((_e879[1][0] - _e271) * _e440) - (_e903 * _e308));
                                                let _e909 = (((_e879[1][1] - _e338) * _e440) - (_e903 * _e374));
                                                let _e912 = (_e879[2][2] - _e404);
                                                let _e915 = (((_e879[2][0] - _e271) * _e440) - (_e912 * _e308));
                                                let _e918 = (((_e879[2][1] - _e338) * _e440) - (_e912 * _e374));
                                                let _e919 = (_e915 * _e909);
                                                let _e920 = (_e918 * _e906);
                                                let _e921 = (_e897 * _e918);
                                                let _e922 = (_e900 * _e915);
                                                let _e923 = (_e906 * _e900);
                                                let _e924 = (_e909 * _e897);
                                                let _e929 = (((_e919 >= _e920) && (_e921 >= _e922)) && (_e923 >= _e924));
                                                let _e935 = (_e929 || (((_e919 <= _e920) && (_e921 <= _e922)) && (_e923 <= _e924)));
                                                if _e935 {
                                                    let _e937 = select(-1f, 1f, _e929);
                                                    let _e939 = ((_e919 - _e920) * _e937);
                                                    let _e941 = select(0f, _e939, (_e939 > 0f));
                                                    let _e943 = ((_e921 - _e922) * _e937);
                                                    let _e945 = select(0f, _e943, (_e943 > 0f));
                                                    let _e947 = ((_e923 - _e924) * _e937);
                                                    let _e949 = select(0f, _e947, (_e947 > 0f));
                                                    let _e951 = ((_e941 + _e945) + _e949);
                                                    let _e953 = select(_e879[1][0], _e879[0][0], (_e879[0][0] < _e879[1][0]));
                                                    let _e957 = select(_e879[1][0], _e879[0][0], (_e879[0][0] > _e879[1][0]));
                                                    let _e961 = select(_e879[1][1], _e879[0][1], (_e879[0][1] < _e879[1][1]));
                                                    let _e965 = select(_e879[1][1], _e879[0][1], (_e879[0][1] > _e879[1][1]));
                                                    let _e969 = select(_e879[1][2], _e879[0][2], (_e879[0][2] < _e879[1][2]));
                                                    let _e973 = select(_e879[1][2], _e879[0][2], (_e879[0][2] > _e879[1][2]));
                                                    let _e978 = ((select(_e879[2][0], _e953, (_e953 < _e879[2][0])) - _e309) * _e312);
                                                    let _e979 = ((select(_e879[2][0], _e957, (_e957 > _e879[2][0])) - _e310) * _e312);
                                                    let _e982 = ((select(_e879[2][1], _e961, (_e961 < _e879[2][1])) - _e375) * _e378);
                                                    let _e983 = ((select(_e879[2][1], _e965, (_e965 > _e879[2][1])) - _e376) * _e378);
                                                    let _e986 = ((select(_e879[2][2], _e969, (_e969 < _e879[2][2])) - _e441) * _e444);
                                                    let _e987 = ((select(_e879[2][2], _e973, (_e973 > _e879[2][2])) - _e442) * _e444);
                                                    let _e989 = select(_e987, _e986, (_e986 < _e987));
                                                    let _e991 = select(_e987, _e986, (_e986 > _e987));
                                                    let _e993 = select(_e979, _e978, (_e978 < _e979));
                                                    let _e995 = select(_e983, _e982, (_e982 < _e983));
                                                    let _e997 = select(_e995, _e993, (_e993 > _e995));
                                                    let _e999 = select(_e989, _e997, (_e997 > _e989));
                                                    let _e1001 = select(_e979, _e978, (_e978 > _e979));
                                                    let _e1003 = select(_e983, _e982, (_e982 > _e983));
                                                    let _e1005 = select(_e1003, _e1001, (_e1001 < _e1003));
                                                    let _e1007 = select(_e991, _e1005, (_e1005 < _e991));
                                                    let _e1008 = -(_e989);
                                                    let _e1014 = select(_e547, _e999, (_e999 > _e547));
                                                    let _e1018 = select(_e906, _e897, (_e897 < _e906));
                                                    let _e1023 = select(_e906, _e897, (_e897 > _e906));
                                                    let _e1030 = select(_e909, _e900, (_e900 < _e909));
                                                    let _e1035 = select(_e909, _e900, (_e900 > _e909));
                                                    let _e1044 = (((((_e935 && (_e951 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e915, _e1018, (_e1018 < _e915)) <= 0f) && (select(_e915, _e1023, (_e1023 > _e915)) >= 0f))) && ((select(_e918, _e1030, (_e1030 < _e918)) <= 0f) && (select(_e918, _e1035, (_e1035 > _e918)) >= 0f))) && (_e1014 <= (_e1007 + (select(_e1008, _e991, (_e991 > _e1008)) * 0.0000019073523f)))) && (_e1014 <= _e780));
                                                    if _e1044 {
                                                        let _e1049 = (_e879[1][0] - _e879[0][0]);
                                                        let _e1050 = (_e879[1][1] - _e879[0][1]);
                                                        let _e1051 = (_e879[1][2] - _e879[0][2]);
                                                        let _e1052 = vec3<f32>(_e1049, _e1050, _e1051);
                                                        let _e1053 = (_e879[2][0] - _e879[1][0]);
                                                        let _e1054 = (_e879[2][1] - _e879[1][1]);
                                                        let _e1055 = (_e879[2][2] - _e879[1][2]);
                                                        let _e1056 = vec3<f32>(_e1053, _e1054, _e1055);
                                                        let _e1057 = (_e879[0][0] - _e879[2][0]);
                                                        let _e1058 = (_e879[0][1] - _e879[2][1]);
                                                        let _e1059 = (_e879[0][2] - _e879[2][2]);
                                                        let _e1060 = vec3<f32>(_e1057, _e1058, _e1059);
                                                        let _e1063 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                        let _e1066 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                        let _e1068 = select(_e1066, _e1063, (_e1063 > _e1066));
                                                        let _e1071 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                        let _e1073 = select(_e1071, _e1068, (_e1068 > _e1071));
                                                        let _e1076 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                        let _e1079 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                        let _e1081 = select(_e1079, _e1076, (_e1076 > _e1079));
                                                        let _e1084 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                        let _e1086 = select(_e1084, _e1081, (_e1081 > _e1084));
                                                        let _e1089 = bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u));
                                                        let _e1092 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                        let _e1094 = select(_e1092, _e1089, (_e1089 > _e1092));
                                                        let _e1097 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                        let _e1099 = select(_e1097, _e1094, (_e1094 > _e1097));
                                                        let _e1101 = select(_e1086, _e1073, (_e1073 > _e1086));
                                                        let _e1103 = select(_e1099, _e1101, (_e1101 > _e1099));
                                                        if (_e1073 == _e1103) {
                                                            phi_1797_ = _e909;
                                                            phi_1798_ = _e906;
                                                            phi_1799_ = _e900;
                                                            phi_1800_ = _e897;
                                                            phi_1801_ = vec3<f32>(_e879[0][0], _e879[0][1], _e879[0][2]);
                                                            phi_1802_ = _e1060;
                                                            phi_1803_ = _e1056;
                                                            phi_1804_ = _e1052;
                                                        } else {
                                                            let _e1105 = (_e1086 == _e1103);
                                                            let _e1110 = vec3(_e1105);
                                                            phi_1797_ = select(_e900, _e918, _e1105);
                                                            phi_1798_ = select(_e897, _e915, _e1105);
                                                            phi_1799_ = select(_e918, _e909, _e1105);
                                                            phi_1800_ = select(_e915, _e906, _e1105);
                                                            phi_1801_ = select(vec3<f32>(_e879[2][0], _e879[2][1], _e879[2][2]), vec3<f32>(_e879[1][0], _e879[1][1], _e879[1][2]), _e1110);
                                                            phi_1802_ = select(_e1056, _e1052, _e1110);
                                                            phi_1803_ = select(_e1052, _e1060, _e1110);
                                                            phi_1804_ = select(_e1060, _e1056, _e1110);
                                                        }
                                                        let _e1116 = phi_1797_;
                                                        let _e1118 = phi_1798_;
                                                        let _e1120 = phi_1799_;
                                                        let _e1122 = phi_1800_;
                                                        let _e1124 = phi_1801_;
                                                        let _e1126 = phi_1802_;
                                                        let _e1128 = phi_1803_;
                                                        let _e1130 = phi_1804_;
                                                        let _e1137 = ((_e1128.y * _e1126.z) - (_e1126.y * _e1128.z));
                                                        let _e1142 = ((_e1128.z * _e1126.x) - (_e1126.z * _e1128.x));
                                                        let _e1145 = ((_e1128.x * _e1126.y) - (_e1126.x * _e1128.y));
                                                        let _e1148 = ((_e941 >= _e945) && (_e941 >= _e949));
                                                        let _e1149 = (_e945 >= _e949);
                                                        let _e1163 = (((_e1137 * (select(select(_e879[2][0], _e879[1][0], _e1149), _e879[0][0], _e1148) - _e271)) + (_e1142 * (select(select(_e879[2][1], _e879[1][1], _e1149), _e879[0][1], _e1148) - _e338))) + (_e1145 * (select(select(_e879[2][2], _e879[1][2], _e1149), _e879[0][2], _e1148) - _e404)));
                                                        let _e1168 = (((_e1137 * _e308) + (_e1142 * _e374)) + (_e1145 * _e440));
                                                        let _e1169 = (_e1118 - _e1122);
                                                        let _e1170 = (_e1116 - _e1120);
                                                        let _e1173 = ((_e1169 * _e1169) + (_e1170 * _e1170));
                                                        let _e1180 = (-(((_e1122 * _e1169) + (_e1120 * _e1170))) / select(0.000000000000000000000000000000000000011754944f, _e1173, (_e1173 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1182 = select(1f, _e1180, (_e1180 < 1f));
                                                        let _e1184 = select(0f, _e1182, (_e1182 > 0f));
                                                        let _e1193 = ((_e1124.x + (_e1130.x * _e1184)) - _e271);
                                                        let _e1196 = ((_e1124.y + (_e1130.y * _e1184)) - _e338);
                                                        let _e1199 = ((_e1124.z + (_e1130.z * _e1184)) - _e404);
                                                        let _e1202 = bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u));
                                                        let _e1205 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                        let _e1207 = select(_e1205, _e1202, (_e1202 > _e1205));
                                                        let _e1210 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                        let _e1212 = select(_e1210, _e1207, (_e1207 > _e1210));
                                                        let _e1218 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                        let _e1221 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                        let _e1223 = select(_e1221, _e1218, (_e1218 > _e1221));
                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                        let _e1245 = bitcast<f32>((bitcast<u32>(_e1128.x) & 2147483647u));
                                                        let _e1248 = bitcast<f32>((bitcast<u32>(_e1128.y) & 2147483647u));
                                                        let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                        let _e1253 = bitcast<f32>((bitcast<u32>(_e1128.z) & 2147483647u));
                                                        let _e1259 = bitcast<f32>((bitcast<u32>(_e1126.x) & 2147483647u));
                                                        let _e1262 = bitcast<f32>((bitcast<u32>(_e1126.y) & 2147483647u));
                                                        let _e1264 = select(_e1262, _e1259, (_e1259 > _e1262));
                                                        let _e1267 = bitcast<f32>((bitcast<u32>(_e1126.z) & 2147483647u));
                                                        let _e1273 = ((bitcast<f32>((bitcast<u32>(((((_e1137 * _e1193) + (_e1142 * _e1196)) + (_e1145 * _e1199)) - _e1163)) & 2147483647u)) <= ((0.0000009536743f * select(_e1103, _e1212, (_e1212 > _e1103))) * select(_e1226, _e1223, (_e1223 > _e1226)))) && !((bitcast<f32>((bitcast<u32>(_e1168) & 2147483647u)) <= ((0.0000038146973f * select(_e1253, _e1250, (_e1250 > _e1253))) * select(_e1267, _e1264, (_e1264 > _e1267))))));
                                                        let _e1274 = (_e1163 / _e1168);
                                                        if (_e1044 && !(_e1273)) {
                                                            let _e1277 = (_e1199 / _e440);
                                                            let _e1285 = (((_e1137 * (_e1193 - (_e308 * _e1277))) + (_e1142 * (_e1196 - (_e374 * _e1277)))) / _e1168);
                                                            phi_1995_ = select(select(_e1277, (_e1277 + _e1285), (bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u)) <= _e1103)), _e1274, _e1273);
                                                        } else {
                                                            phi_1995_ = _e1274;
                                                        }
                                                        let _e1294 = phi_1995_;
                                                        let _e1296 = select(_e1007, _e1294, (_e1294 < _e1007));
                                                        let _e1298 = select(_e999, _e1296, (_e1296 > _e999));
                                                        let _e1299 = (1f / _e951);
                                                        phi_2015_ = type_39(_e1298, (_e945 * _e1299), (_e949 * _e1299), ((_e1044 && (_e1298 >= _e547)) && (_e1298 <= _e780)));
                                                        phi_2016_ = type_39();
                                                    } else {
                                                        phi_2015_ = type_39();
                                                        phi_2016_ = type_39(0f, 0f, 0f, _e1044);
                                                    }
                                                    let _e1308 = phi_2015_;
                                                    let _e1310 = phi_2016_;
                                                    phi_2019_ = _e1308;
                                                    phi_2020_ = _e1310;
                                                    phi_2021_ = select(true, false, _e1044);
                                                } else {
                                                    phi_2019_ = type_39();
                                                    phi_2020_ = type_39(0f, 0f, 0f, _e935);
                                                    phi_2021_ = true;
                                                }
                                                let _e1313 = phi_2019_;
                                                let _e1315 = phi_2020_;
                                                let _e1317 = phi_2021_;
                                                if _e1317 {
                                                    phi_2025_ = _e1315;
                                                } else {
                                                    phi_2025_ = _e1313;
                                                }
                                                let _e1319 = phi_2025_;
                                                if _e1319.member_3 {
                                                    phi_2034_ = type_23(_e1319.member, _e1319.member_1, _e1319.member_2, _e809);
                                                } else {
                                                    phi_2034_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1326 = phi_2034_;
                                                if (_e1326.member_3 != 4294967295u) {
                                                    if (_e809 != 4294967295u) {
                                                        phi_2046_ = type_4(0u, 8u);
                                                        phi_2049_ = _e1326;
                                                        loop {
                                                            let _e1331 = phi_2046_;
                                                            let _e1333 = phi_2049_;
                                                            if (_e1331.member < _e1331.member_1) {
                                                                phi_2047_ = type_4((_e1331.member + 1u), _e1331.member_1);
                                                                phi_2072_ = type_4(1u, _e1331.member);
                                                            } else {
                                                                phi_2047_ = _e1331;
                                                                phi_2072_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1346 = phi_2047_;
                                                            let _e1348 = phi_2072_;
                                                            let _e1352 = (bitcast<i32>(_e1348.member) != 0i);
                                                            if _e1352 {
                                                                let _e1353 = (_e1348.member_1 < 8u);
                                                                if _e1353 {
                                                                } else {
                                                                    phi_3072_ = true;
                                                                    break;
                                                                }
                                                                let _e1358 = local[_e1348.member_1].member;
                                                                if (_e1333.member < _e1358) {
                                                                    phi_2105_ = true;
                                                                } else {
                                                                    let _e1360 = local[_e1348.member_1].member;
                                                                    if (_e1333.member == _e1360) {
                                                                        let _e1365 = local[_e1348.member_1].member_3;
                                                                        phi_2104_ = (_e1333.member_3 < _e1365);
                                                                    } else {
                                                                        phi_2104_ = false;
                                                                    }
                                                                    let _e1368 = phi_2104_;
                                                                    phi_2105_ = _e1368;
                                                                }
                                                                let _e1370 = phi_2105_;
                                                                if _e1370 {
                                                                    if _e1353 {
                                                                    } else {
                                                                        phi_3072_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1371 = local[_e1348.member_1];
                                                                    local[_e1348.member_1] = type_23(_e1333.member, _e1333.member_1, _e1333.member_2, _e1333.member_3);
                                                                    phi_2126_ = type_23(_e1371.member, _e1371.member_1, _e1371.member_2, _e1371.member_3);
                                                                } else {
                                                                    phi_2126_ = _e1333;
                                                                }
                                                                let _e1382 = phi_2126_;
                                                                phi_2050_ = _e1382;
                                                            } else {
                                                                phi_2050_ = type_23();
                                                            }
                                                            let _e1384 = phi_2050_;
                                                            continue;
                                                            continuing {
                                                                phi_2046_ = _e1346;
                                                                phi_2049_ = _e1384;
                                                                phi_3072_ = _e778;
                                                                break if !(_e1352);
                                                            }
                                                        }
                                                        let _e1387 = phi_3072_;
                                                        phi_3230_ = _e780;
                                                        phi_3225_ = _e1387;
                                                        if _e1387 {
                                                            break;
                                                        }
                                                        let _e1390 = local[7u].member_3;
                                                        if (_e1390 != 4294967295u) {
                                                            let _e1394 = local[7u].member;
                                                            phi_3314_ = _e1394;
                                                        } else {
                                                            phi_3314_ = _e780;
                                                        }
                                                        let _e1396 = phi_3314_;
                                                        phi_3313_ = _e1396;
                                                        phi_3228_ = _e1387;
                                                    } else {
                                                        phi_3313_ = _e780;
                                                        phi_3228_ = _e778;
                                                    }
                                                    let _e1398 = phi_3313_;
                                                    let _e1400 = phi_3228_;
                                                    phi_3312_ = _e1398;
                                                    phi_3227_ = _e1400;
                                                } else {
                                                    phi_3312_ = _e780;
                                                    phi_3227_ = _e778;
                                                }
                                                let _e1402 = phi_3312_;
                                                let _e1404 = phi_3227_;
                                                phi_3311_ = _e1402;
                                                phi_3226_ = _e1404;
                                            } else {
                                                phi_3311_ = _e780;
                                                phi_3226_ = _e778;
                                            }
                                            let _e1406 = phi_3311_;
                                            let _e1408 = phi_3226_;
                                            continue;
                                            continuing {
                                                phi_3082_ = _e1408;
                                                phi_3071_ = _e1406;
                                                phi_1129_ = _e795;
                                                phi_3230_ = _e1406;
                                                phi_3225_ = _e1408;
                                                break if !(_e801);
                                            }
                                        }
                                        let _e1411 = phi_3230_;
                                        let _e1413 = phi_3225_;
                                        phi_3315_ = _e1413;
                                        if _e1413 {
                                            break;
                                        }
                                        phi_3377_ = _e1411;
                                        phi_3319_ = _e1413;
                                        phi_2616_ = false;
                                        phi_2617_ = _e580;
                                        phi_2618_ = select(_e582, 0u, (_e547 > _e1411));
                                    } else {
                                        if (_e580 >= _e79) {
                                            phi_2203_ = type_40(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e580 < _e79) {
                                            } else {
                                                phi_3315_ = true;
                                                break;
                                            }
                                            let _e592 = (_e207 % 3u);
                                            if (_e592 < 3u) {
                                            } else {
                                                phi_3315_ = true;
                                                break;
                                            }
                                            let _e598 = global_2.member[_e580].member[_e592];
                                            let _e604 = (_e206 % 3u);
                                            if (_e604 < 3u) {
                                            } else {
                                                phi_3315_ = true;
                                                break;
                                            }
                                            let _e610 = global_2.member[_e580].member[_e604];
                                            let _e616 = (_e208 % 3u);
                                            if (_e616 < 3u) {
                                            } else {
                                                phi_3315_ = true;
                                                break;
                                            }
                                            let _e622 = global_2.member[_e580].member[_e616];
                                            let _e632 = global_2.member[_e580].member_1;
                                            let _e636 = global_2.member[_e580].member_2;
                                            phi_2203_ = type_40(array<vec4<f32>, 3>(vec4<f32>(_e598[0], _e598[1], _e598[2], _e598[3]), vec4<f32>(_e610[0], _e610[1], _e610[2], _e610[3]), vec4<f32>(_e622[0], _e622[1], _e622[2], _e622[3])), _e632, _e636);
                                        }
                                        let _e639 = phi_2203_;
                                        let _e650 = ((_e639.member[0].x - _e309) * _e312);
                                        let _e651 = ((_e639.member[0].y - _e309) * _e312);
                                        let _e652 = ((_e639.member[0].z - _e310) * _e312);
                                        let _e653 = ((_e639.member[0].w - _e310) * _e312);
                                        let _e663 = ((_e639.member[1].x - _e375) * _e378);
                                        let _e664 = ((_e639.member[1].y - _e375) * _e378);
                                        let _e665 = ((_e639.member[1].z - _e376) * _e378);
                                        let _e666 = ((_e639.member[1].w - _e376) * _e378);
                                        let _e676 = ((_e639.member[2].x - _e441) * _e444);
                                        let _e677 = ((_e639.member[2].y - _e441) * _e444);
                                        let _e678 = ((_e639.member[2].z - _e442) * _e444);
                                        let _e679 = ((_e639.member[2].w - _e442) * _e444);
                                        let _e681 = select(_e678, _e676, (_e676 < _e678));
                                        let _e683 = select(_e679, _e677, (_e677 < _e679));
                                        let _e685 = select(_e678, _e676, (_e676 > _e678));
                                        let _e687 = select(_e679, _e677, (_e677 > _e679));
                                        let _e689 = select(_e652, _e650, (_e650 < _e652));
                                        let _e691 = select(_e653, _e651, (_e651 < _e653));
                                        let _e693 = select(_e665, _e663, (_e663 < _e665));
                                        let _e695 = select(_e666, _e664, (_e664 < _e666));
                                        let _e697 = select(_e693, _e689, (_e689 > _e693));
                                        let _e699 = select(_e695, _e691, (_e691 > _e695));
                                        let _e701 = select(_e681, _e697, (_e697 > _e681));
                                        let _e703 = select(_e683, _e699, (_e699 > _e683));
                                        let _e705 = select(_e652, _e650, (_e650 > _e652));
                                        let _e707 = select(_e653, _e651, (_e651 > _e653));
                                        let _e709 = select(_e665, _e663, (_e663 > _e665));
                                        let _e711 = select(_e666, _e664, (_e664 > _e666));
                                        let _e713 = select(_e709, _e705, (_e705 < _e709));
                                        let _e715 = select(_e711, _e707, (_e707 < _e711));
                                        let _e720 = -(_e681);
                                        let _e721 = -(_e683);
                                        let _e728 = (select(_e685, _e713, (_e713 < _e685)) + (select(_e720, _e685, (_e685 > _e720)) * 0.0000019073523f));
                                        let _e729 = (select(_e687, _e715, (_e715 < _e687)) + (select(_e721, _e687, (_e687 > _e721)) * 0.0000019073523f));
                                        let _e731 = select(_e547, _e701, (_e701 > _e547));
                                        let _e733 = select(_e547, _e703, (_e703 > _e547));
                                        let _e738 = (_e731 <= select(_e556, _e728, (_e728 < _e556)));
                                        let _e739 = (_e733 <= select(_e556, _e729, (_e729 < _e556)));
                                        let _e740 = (_e731 <= _e733);
                                        if _e738 {
                                            if _e739 {
                                                if _e740 {
                                                    phi_2566_ = _e639.member_2;
                                                } else {
                                                    phi_2566_ = _e639.member_1;
                                                }
                                                let _e744 = phi_2566_;
                                                let _e746 = (_e582 % 128u);
                                                let _e747 = (_e746 < 128u);
                                                if _e747 {
                                                } else {
                                                    phi_3315_ = true;
                                                    break;
                                                }
                                                local_2[_e746] = _e744;
                                                if _e747 {
                                                } else {
                                                    phi_3315_ = true;
                                                    break;
                                                }
                                                local_1[_e746] = select(_e731, _e733, _e740);
                                                if _e740 {
                                                    phi_2593_ = _e639.member_1;
                                                } else {
                                                    phi_2593_ = _e639.member_2;
                                                }
                                                let _e754 = phi_2593_;
                                                phi_2594_ = _e754;
                                                phi_2595_ = (_e582 + 1u);
                                            } else {
                                                phi_2594_ = u32();
                                                phi_2595_ = u32();
                                            }
                                            let _e756 = phi_2594_;
                                            let _e758 = phi_2595_;
                                            phi_2597_ = _e756;
                                            phi_2598_ = _e758;
                                            phi_2599_ = select(true, false, _e739);
                                        } else {
                                            phi_2597_ = u32();
                                            phi_2598_ = u32();
                                            phi_2599_ = true;
                                        }
                                        let _e761 = phi_2597_;
                                        let _e763 = phi_2598_;
                                        let _e765 = phi_2599_;
                                        if _e765 {
                                            if _e738 {
                                                phi_2608_ = _e639.member_1;
                                            } else {
                                                phi_2608_ = _e639.member_2;
                                            }
                                            let _e769 = phi_2608_;
                                            phi_2613_ = select(_e739, true, _e738);
                                            phi_2614_ = _e769;
                                        } else {
                                            phi_2613_ = _e578;
                                            phi_2614_ = _e761;
                                        }
                                        let _e772 = phi_2613_;
                                        let _e774 = phi_2614_;
                                        phi_3377_ = _e556;
                                        phi_3319_ = _e554;
                                        phi_2616_ = _e772;
                                        phi_2617_ = _e774;
                                        phi_2618_ = select(_e763, _e582, _e765);
                                    }
                                    let _e1417 = phi_3377_;
                                    let _e1419 = phi_3319_;
                                    let _e1421 = phi_2616_;
                                    let _e1423 = phi_2617_;
                                    let _e1425 = phi_2618_;
                                    phi_3376_ = _e1417;
                                    phi_3318_ = _e1419;
                                    phi_2619_ = _e1421;
                                    phi_2620_ = _e1423;
                                    phi_2621_ = _e1425;
                                    phi_2622_ = (_e564 - 1u);
                                } else {
                                    phi_3376_ = _e556;
                                    phi_3318_ = _e554;
                                    phi_2619_ = _e578;
                                    phi_2620_ = _e580;
                                    phi_2621_ = _e582;
                                    phi_2622_ = _e564;
                                }
                                let _e1427 = phi_3376_;
                                let _e1429 = phi_3318_;
                                let _e1431 = phi_2619_;
                                let _e1433 = phi_2620_;
                                let _e1435 = phi_2621_;
                                let _e1437 = phi_2622_;
                                phi_3375_ = _e1427;
                                phi_3317_ = _e1429;
                                phi_2623_ = _e1431;
                                phi_2624_ = _e1433;
                                phi_2625_ = _e1435;
                                phi_2626_ = _e1437;
                            } else {
                                phi_3375_ = _e556;
                                phi_3317_ = _e554;
                                phi_2623_ = bool();
                                phi_2624_ = u32();
                                phi_2625_ = u32();
                                phi_2626_ = u32();
                            }
                            let _e1439 = phi_3375_;
                            let _e1441 = phi_3317_;
                            let _e1443 = phi_2623_;
                            let _e1445 = phi_2624_;
                            let _e1447 = phi_2625_;
                            let _e1449 = phi_2626_;
                            phi_3374_ = _e1439;
                            phi_3316_ = _e1441;
                            phi_1062_ = _e1443;
                            phi_1065_ = _e1445;
                            phi_1067_ = _e1447;
                            phi_1069_ = _e1449;
                            phi_2627_ = _e568;
                        } else {
                            phi_3374_ = _e556;
                            phi_3316_ = _e554;
                            phi_1062_ = bool();
                            phi_1065_ = u32();
                            phi_1067_ = u32();
                            phi_1069_ = u32();
                            phi_2627_ = false;
                        }
                        let _e1451 = phi_3374_;
                        let _e1453 = phi_3316_;
                        let _e1455 = phi_1062_;
                        let _e1457 = phi_1065_;
                        let _e1459 = phi_1067_;
                        let _e1461 = phi_1069_;
                        let _e1463 = phi_2627_;
                        continue;
                        continuing {
                            phi_3085_ = _e1453;
                            phi_3064_ = _e1451;
                            phi_1061_ = _e1455;
                            phi_1064_ = _e1457;
                            phi_1066_ = _e1459;
                            phi_1068_ = _e1461;
                            phi_3315_ = _e1453;
                            break if !(_e1463);
                        }
                    }
                    let _e1466 = phi_3315_;
                    if _e1466 {
                        break;
                    }
                    phi_2634_ = type_4(0u, 8u);
                    loop {
                        let _e1468 = phi_2634_;
                        if (_e1468.member < _e1468.member_1) {
                            phi_2635_ = type_4((_e1468.member + 1u), _e1468.member_1);
                            phi_2658_ = type_4(1u, _e1468.member);
                        } else {
                            phi_2635_ = _e1468;
                            phi_2658_ = type_4(0u, type_4().member_1);
                        }
                        let _e1481 = phi_2635_;
                        let _e1483 = phi_2658_;
                        let _e1487 = (bitcast<i32>(_e1483.member) != 0i);
                        if _e1487 {
                            let _e1488 = (_e1483.member_1 < 8u);
                            if _e1488 {
                            } else {
                                phi_3356_ = true;
                                break;
                            }
                            let _e1490 = local[_e1483.member_1];
                            if (_e1490.member_3 != 4294967295u) {
                                let _e1496 = -(_e449);
                                let _e1497 = bitcast<u32>(_e1490.member);
                                let _e1501 = (bitcast<i32>((_e1497 >> bitcast<u32>(23i))) & 255i);
                                let _e1502 = (_e1501 + _e1496);
                                if (_e1501 == 255i) {
                                    phi_2731_ = _e1490.member;
                                } else {
                                    if (_e1501 > 0i) {
                                        if (_e1502 > 0i) {
                                            let _e1506 = (_e1502 < 255i);
                                            if _e1506 {
                                                phi_2710_ = bitcast<f32>((_e1497 + bitcast<u32>((_e1496 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_2710_ = f32();
                                            }
                                            let _e1513 = phi_2710_;
                                            phi_2712_ = _e1513;
                                            phi_2713_ = select(true, false, _e1506);
                                        } else {
                                            phi_2712_ = f32();
                                            phi_2713_ = true;
                                        }
                                        let _e1516 = phi_2712_;
                                        let _e1518 = phi_2713_;
                                        phi_2714_ = _e1516;
                                        phi_2715_ = _e1518;
                                    } else {
                                        phi_2714_ = f32();
                                        phi_2715_ = true;
                                    }
                                    let _e1520 = phi_2714_;
                                    let _e1522 = phi_2715_;
                                    if _e1522 {
                                        let _e1523 = (_e1497 & 2147483648u);
                                        let _e1530 = ((_e1497 & 8388607u) | (select(0u, 1u, ((_e1497 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1534 = (_e1530 == 0u);
                                        if _e1534 {
                                            phi_3048_ = bitcast<f32>(_e1523);
                                        } else {
                                            let _e1539 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1530)), 32u, _e1534) - 8u);
                                            let _e1542 = (_e1530 << bitcast<u32>((_e1539 & 31u)));
                                            let _e1544 = ((_e1502 + select(0i, 1i, (_e1501 == 0i))) - bitcast<i32>(_e1539));
                                            if (_e1544 >= 255i) {
                                                phi_3038_ = bitcast<f32>((_e1523 | 2139095040u));
                                                phi_3039_ = f32();
                                                phi_3040_ = true;
                                            } else {
                                                let _e1546 = (_e1544 > 0i);
                                                if _e1546 {
                                                    phi_3032_ = bitcast<f32>(((_e1523 | (bitcast<u32>(_e1544) << bitcast<u32>(23i))) | (_e1542 & 8388607u)));
                                                    phi_3033_ = f32();
                                                } else {
                                                    if (_e1544 < -24i) {
                                                        phi_2998_ = 26u;
                                                    } else {
                                                        phi_2998_ = bitcast<u32>((1i - _e1544));
                                                    }
                                                    let _e1551 = phi_2998_;
                                                    let _e1552 = (_e1551 & 31u);
                                                    let _e1554 = (_e1542 >> bitcast<u32>(_e1552));
                                                    let _e1558 = (_e1542 & ((1u << bitcast<u32>(_e1552)) - 1u));
                                                    let _e1562 = (1u << bitcast<u32>(((_e1551 - 1u) & 31u)));
                                                    if (_e1558 > _e1562) {
                                                        phi_3019_ = true;
                                                    } else {
                                                        if (_e1558 == _e1562) {
                                                            phi_3016_ = ((_e1554 & 1u) == 1u);
                                                        } else {
                                                            phi_3016_ = false;
                                                        }
                                                        let _e1568 = phi_3016_;
                                                        phi_3019_ = _e1568;
                                                    }
                                                    let _e1570 = phi_3019_;
                                                    phi_3032_ = f32();
                                                    phi_3033_ = bitcast<f32>((_e1523 | (_e1554 + select(0u, 1u, _e1570))));
                                                }
                                                let _e1583 = phi_3032_;
                                                let _e1585 = phi_3033_;
                                                phi_3038_ = _e1583;
                                                phi_3039_ = _e1585;
                                                phi_3040_ = _e1546;
                                            }
                                            let _e1589 = phi_3038_;
                                            let _e1591 = phi_3039_;
                                            let _e1593 = phi_3040_;
                                            phi_3048_ = select(_e1591, _e1589, _e1593);
                                        }
                                        let _e1597 = phi_3048_;
                                        phi_2730_ = _e1597;
                                    } else {
                                        phi_2730_ = _e1520;
                                    }
                                    let _e1599 = phi_2730_;
                                    phi_2731_ = _e1599;
                                }
                                let _e1601 = phi_2731_;
                                let _e1602 = bitcast<u32>(_e1601);
                                if ((_e1602 & 2147483647u) >= 2139095040u) {
                                    phi_2743_ = bitcast<f32>(((_e1602 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_2743_ = _e1601;
                                }
                                let _e1609 = phi_2743_;
                                phi_2748_ = type_23(_e1609, _e1490.member_1, _e1490.member_2, _e1490.member_3);
                            } else {
                                phi_2748_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1612 = phi_2748_;
                            if _e1488 {
                            } else {
                                phi_3356_ = true;
                                break;
                            }
                            local[_e1483.member_1] = type_23(_e1612.member, _e1612.member_1, _e1612.member_2, _e1612.member_3);
                        }
                        continue;
                        continuing {
                            phi_2634_ = _e1481;
                            phi_3356_ = _e1466;
                            break if !(_e1487);
                        }
                    }
                    let _e1620 = phi_3356_;
                    if _e1620 {
                        break;
                    }
                    let _e1621 = local;
                    if _e95 {
                    } else {
                        break;
                    }
                    global_5.member[_e89] = array<type_23, 8>(type_23(_e1621[0].member, _e1621[0].member_1, _e1621[0].member_2, _e1621[0].member_3), type_23(_e1621[1].member, _e1621[1].member_1, _e1621[1].member_2, _e1621[1].member_3), type_23(_e1621[2].member, _e1621[2].member_1, _e1621[2].member_2, _e1621[2].member_3), type_23(_e1621[3].member, _e1621[3].member_1, _e1621[3].member_2, _e1621[3].member_3), type_23(_e1621[4].member, _e1621[4].member_1, _e1621[4].member_2, _e1621[4].member_3), type_23(_e1621[5].member, _e1621[5].member_1, _e1621[5].member_2, _e1621[5].member_3), type_23(_e1621[6].member, _e1621[6].member_1, _e1621[6].member_2, _e1621[6].member_3), type_23(_e1621[7].member, _e1621[7].member_1, _e1621[7].member_2, _e1621[7].member_3));
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
