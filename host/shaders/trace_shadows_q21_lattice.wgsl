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

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: f32,
    member_1: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<i32>,
}

struct type_53 {
    member: array<array<u32, 7>>,
}

struct type_58 {
    member: type_30,
    member_1: u32,
}

struct type_59 {
    member: array<vec4<f32>, 3>,
    member_1: type_58,
    member_2: type_58,
}

struct type_64 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<uniform> global_4: type_44;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_47;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_64;
@group(0) @binding(3) 
var<storage> global_8: type_53;
@group(0) @binding(7) 
var<storage> global_9: type_33;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var phi_343_: u32;
    var phi_387_: i32;
    var phi_527_: type_36;
    var phi_677_: i32;
    var phi_678_: i32;
    var phi_688_: bool;
    var phi_698_: u32;
    var phi_699_: u32;
    var phi_701_: bool;
    var phi_706_: u32;
    var phi_739_: i32;
    var phi_757_: f32;
    var phi_763_: f32;
    var phi_803_: f32;
    var phi_809_: f32;
    var phi_861_: f32;
    var phi_873_: f32;
    var phi_882_: f32;
    var phi_888_: f32;
    var phi_928_: f32;
    var phi_934_: f32;
    var phi_986_: f32;
    var phi_998_: f32;
    var phi_1007_: f32;
    var phi_1013_: f32;
    var phi_1053_: f32;
    var phi_1059_: f32;
    var phi_1111_: f32;
    var phi_1123_: f32;
    var phi_1178_: i32;
    var phi_1200_: u32;
    var phi_1201_: u32;
    var phi_1238_: i32;
    var phi_1260_: u32;
    var phi_1261_: u32;
    var phi_1269_: f32;
    var phi_1270_: f32;
    var phi_5042_: bool;
    var phi_1366_: type_42;
    var phi_1369_: bool;
    var phi_1371_: u32;
    var phi_1373_: u32;
    var phi_1375_: type_58;
    var phi_1386_: bool;
    var phi_1472_: bool;
    var phi_1473_: u32;
    var phi_1474_: type_58;
    var phi_4006_: u32;
    var phi_4012_: u32;
    var phi_4266_: u32;
    var phi_4267_: u32;
    var phi_4277_: u32;
    var phi_4279_: u32;
    var phi_4280_: bool;
    var phi_4300_: u32;
    var phi_4301_: u32;
    var phi_4305_: type_59;
    var phi_4667_: type_58;
    var phi_4744_: type_58;
    var phi_4745_: u32;
    var phi_4746_: type_58;
    var phi_4748_: u32;
    var phi_4749_: type_58;
    var phi_4750_: bool;
    var phi_4759_: type_58;
    var phi_4764_: bool;
    var phi_4766_: type_58;
    var phi_1493_: type_42;
    var phi_1496_: type_8;
    var phi_1497_: type_8;
    var phi_1519_: type_8;
    var phi_1560_: u32;
    var phi_1566_: u32;
    var phi_1576_: u32;
    var phi_1592_: u32;
    var phi_1625_: u32;
    var phi_1631_: u32;
    var phi_2097_: u32;
    var phi_2115_: u32;
    var phi_2133_: u32;
    var phi_2156_: u32;
    var phi_2174_: u32;
    var phi_2192_: u32;
    var phi_2215_: u32;
    var phi_2233_: u32;
    var phi_2251_: u32;
    var phi_1805_: u32;
    var phi_1820_: u32;
    var phi_1830_: u32;
    var phi_1851_: u32;
    var phi_1872_: u32;
    var phi_1902_: u32;
    var phi_1917_: u32;
    var phi_1927_: u32;
    var phi_1948_: u32;
    var phi_1969_: u32;
    var phi_1999_: u32;
    var phi_2014_: u32;
    var phi_2024_: u32;
    var phi_2045_: u32;
    var phi_2066_: u32;
    var phi_1658_: u32;
    var phi_1707_: u32;
    var phi_1756_: u32;
    var phi_2257_: array<array<f32, 3>, 3>;
    var phi_2409_: bool;
    var phi_2438_: bool;
    var phi_2857_: f32;
    var phi_2858_: f32;
    var phi_2859_: f32;
    var phi_2860_: f32;
    var phi_2861_: vec3<f32>;
    var phi_2862_: vec3<f32>;
    var phi_2863_: vec3<f32>;
    var phi_2864_: vec3<f32>;
    var phi_2901_: bool;
    var phi_2910_: vec3<f32>;
    var phi_3075_: f32;
    var phi_3077_: f32;
    var phi_3078_: bool;
    var phi_3098_: f32;
    var phi_3099_: f32;
    var phi_3122_: type_21;
    var phi_3124_: type_21;
    var phi_3125_: bool;
    var phi_3129_: type_21;
    var phi_3130_: type_21;
    var phi_3131_: type_21;
    var phi_3132_: bool;
    var phi_3136_: type_21;
    var phi_3137_: bool;
    var phi_3138_: type_21;
    var phi_3139_: bool;
    var phi_3140_: bool;
    var phi_3141_: type_21;
    var phi_3142_: bool;
    var phi_3143_: bool;
    var phi_3151_: type_21;
    var phi_3152_: bool;
    var phi_3156_: type_21;
    var phi_3179_: u32;
    var phi_3193_: i32;
    var phi_3215_: vec3<f32>;
    var phi_3216_: vec3<f32>;
    var phi_3234_: vec3<f32>;
    var phi_3235_: vec3<f32>;
    var phi_3253_: vec3<f32>;
    var phi_3254_: vec3<f32>;
    var phi_3290_: vec3<f32>;
    var phi_3472_: f32;
    var phi_3490_: bool;
    var phi_3491_: bool;
    var phi_3496_: type_42;
    var phi_3497_: type_42;
    var phi_1494_: type_42;
    var phi_5036_: bool;
    var local_10: type_42;
    var phi_5279_: bool;
    var phi_4770_: type_42;
    var phi_4771_: bool;
    var phi_4772_: u32;
    var phi_4773_: type_58;
    var phi_5278_: bool;
    var phi_4774_: type_42;
    var phi_4775_: bool;
    var phi_4776_: u32;
    var phi_4777_: u32;
    var phi_4778_: type_58;
    var phi_5277_: bool;
    var phi_4779_: type_42;
    var phi_4780_: bool;
    var phi_4781_: u32;
    var phi_4782_: u32;
    var phi_4783_: type_58;
    var phi_5276_: bool;
    var phi_1367_: type_42;
    var phi_1370_: bool;
    var phi_1372_: u32;
    var phi_1374_: u32;
    var phi_1376_: type_58;
    var phi_4784_: bool;
    var phi_5275_: bool;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_8.member));
            let _e106 = arrayLength((&global_10.member));
            let _e118 = arrayLength((&global_7.member));
            let _e122 = global_4.member[0u][0u];
            let _e126 = global_4.member[0u][1u];
            let _e130 = global_4.member[0u][2u];
            let _e134 = global_4.member[0u][3u];
            let _e138 = global_4.member[1u][0u];
            let _e142 = global_4.member[1u][1u];
            let _e146 = global_4.member[1u][2u];
            let _e150 = (_e101.x + (_e101.y * 2097152u));
            let _e162 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e134) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            local = array<i32, 3>(bitcast<i32>(_e138), bitcast<i32>(_e142), bitcast<i32>(_e146));
            let _e165 = (_e150 < arrayLength((&global_9.member)));
            if _e165 {
                if _e165 {
                } else {
                    break;
                }
                let _e169 = global_9.member[_e150].member_2;
                phi_343_ = _e169;
            } else {
                phi_343_ = 4294967295u;
            }
            let _e171 = phi_343_;
            let _e174 = global_1.member[0u];
            let _e178 = global_3.member[0u][0u];
            let _e182 = global_3.member[0u][1u];
            let _e186 = global_3.member[0u][2u];
            let _e190 = global_3.member[0u][3u];
            let _e194 = global_3.member[1u][0u];
            let _e198 = global_3.member[1u][1u];
            let _e202 = global_3.member[1u][2u];
            let _e206 = global_3.member[1u][3u];
            let _e207 = bitcast<f32>(_e178);
            let _e208 = bitcast<f32>(_e182);
            let _e209 = bitcast<f32>(_e186);
            let _e211 = bitcast<f32>(_e194);
            let _e212 = array<u32, 3>(_e198, _e202, _e206);
            let _e214 = bitcast<i32>(_e174);
            if (_e214 < -126i) {
                phi_387_ = -126i;
            } else {
                phi_387_ = select(_e214, 127i, (_e214 > 127i));
            }
            let _e219 = phi_387_;
            let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
            let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
            if (_e190 == 0u) {
                phi_527_ = type_36(array<f32, 3>(_e207, _e208, _e209), _e190, _e211, _e212);
            } else {
                let _e232 = bitcast<u32>(_e207);
                let _e234 = ((_e232 & 2139095040u) != 0u);
                let _e249 = bitcast<u32>(_e208);
                let _e251 = ((_e249 & 2139095040u) != 0u);
                let _e266 = bitcast<u32>(_e209);
                let _e268 = ((_e266 & 2139095040u) != 0u);
                let _e284 = bitcast<u32>(_e211);
                let _e286 = ((_e284 & 2139095040u) != 0u);
                phi_527_ = type_36(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e232 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e232 & 2147483648u))), _e207, _e234) * _e224) * select(0.00000011920929f, 1f, _e234)) * _e230), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e249 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e249 & 2147483648u))), _e208, _e251) * _e224) * select(0.00000011920929f, 1f, _e251)) * _e230), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e266 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e266 & 2147483648u))), _e209, _e268) * _e224) * select(0.00000011920929f, 1f, _e268)) * _e230)), _e190, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e284 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e284 & 2147483648u))), _e211, _e286) * _e224) * select(0.00000011920929f, 1f, _e286)) * _e230), _e212);
            }
            let _e303 = phi_527_;
            if _e165 {
                let _e304 = (_e150 < arrayLength((&global_2.member)));
                if _e304 {
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e309 = global_9.member[_e150].member.member_1;
                    let _e314 = global_9.member[_e150].member.member_3;
                    if (_e309 <= _e314) {
                        let _e316 = (1u < _e118);
                        if _e316 {
                            if (0u < _e118) {
                            } else {
                                break;
                            }
                            let _e320 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e320 + 1u) < _e320) {
                                if _e316 {
                                } else {
                                    break;
                                }
                                let _e325 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e165 {
                        } else {
                            break;
                        }
                        let _e335 = global_9.member[_e150].member.member_2[0u];
                        let _e337 = (bitcast<u32>(_e335) & 2147483647u);
                        let _e343 = global_9.member[_e150].member.member_2[1u];
                        let _e345 = (bitcast<u32>(_e343) & 2147483647u);
                        let _e351 = global_9.member[_e150].member.member_2[2u];
                        let _e353 = (bitcast<u32>(_e351) & 2147483647u);
                        let _e359 = global_9.member[_e150].member.member[0u];
                        let _e361 = (bitcast<u32>(_e359) & 2147483647u);
                        let _e367 = global_9.member[_e150].member.member[1u];
                        let _e369 = (bitcast<u32>(_e367) & 2147483647u);
                        let _e375 = global_9.member[_e150].member.member[2u];
                        let _e377 = (bitcast<u32>(_e375) & 2147483647u);
                        let _e379 = select(_e345, _e337, (_e345 < _e337));
                        let _e381 = select(_e353, _e379, (_e353 < _e379));
                        let _e383 = select(_e361, _e381, (_e361 < _e381));
                        let _e385 = select(_e369, _e383, (_e369 < _e383));
                        let _e387 = select(_e377, _e385, (_e377 < _e385));
                        let _e388 = bitcast<u32>(_e309);
                        let _e389 = (_e388 & 2147483647u);
                        let _e393 = bitcast<u32>(_e314);
                        let _e394 = (_e393 & 2147483647u);
                        let _e398 = (((select(_e389, _e387, (_e389 < _e387)) < 2139095040u) && (_e394 <= 2139095040u)) && (_e381 > 0u));
                        if _e398 {
                            let _e401 = (bitcast<u32>(bitcast<f32>(_e381)) & 2147483647u);
                            if (_e401 >= 8388608u) {
                                phi_677_ = (bitcast<i32>((_e401 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_677_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e401)), 32u, (_e401 == 0u))));
                            }
                            let _e415 = phi_677_;
                            phi_678_ = _e415;
                        } else {
                            phi_678_ = 0i;
                        }
                        let _e417 = phi_678_;
                        let _e418 = (_e337 == _e381);
                        if _e418 {
                            phi_688_ = true;
                        } else {
                            phi_688_ = (_e345 == _e381);
                        }
                        let _e421 = phi_688_;
                        let _e422 = select(1u, 0u, _e418);
                        if _e421 {
                            let _e423 = (_e422 + 1u);
                            phi_698_ = _e423;
                            phi_699_ = _e423;
                            phi_701_ = select(true, false, (_e423 == 2u));
                        } else {
                            phi_698_ = u32();
                            phi_699_ = 0u;
                            phi_701_ = true;
                        }
                        let _e427 = phi_698_;
                        let _e429 = phi_699_;
                        let _e431 = phi_701_;
                        if _e431 {
                            phi_706_ = (_e429 + 1u);
                        } else {
                            phi_706_ = 0u;
                        }
                        let _e435 = phi_706_;
                        let _e436 = select(_e427, _e429, _e431);
                        let _e437 = select(_e422, select(2u, _e422, _e421), _e431);
                        let _e438 = -(_e417);
                        if (_e438 < -126i) {
                            phi_739_ = -126i;
                        } else {
                            phi_739_ = select(_e438, 127i, (_e438 > 127i));
                        }
                        let _e443 = phi_739_;
                        let _e448 = bitcast<f32>((bitcast<u32>((_e443 + 127i)) << bitcast<u32>(23i)));
                        let _e454 = bitcast<f32>((bitcast<u32>(((_e438 - _e443) + 127i)) << bitcast<u32>(23i)));
                        let _e459 = global_9.member[_e150].member.member;
                        let _e460 = (_e436 == 0u);
                        if _e460 {
                            phi_757_ = _e459[0];
                        } else {
                            phi_757_ = _e459[1];
                        }
                        let _e464 = phi_757_;
                        let _e465 = (_e436 == 2u);
                        if _e465 {
                            phi_763_ = _e459[2];
                        } else {
                            phi_763_ = _e464;
                        }
                        let _e468 = phi_763_;
                        let _e469 = bitcast<u32>(_e468);
                        let _e471 = ((_e469 & 2139095040u) != 0u);
                        let _e483 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e469 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e469 & 2147483648u))), _e468, _e471) * select(0.00000011920929f, 1f, _e471));
                        let _e484 = global_9.member[_e150].member.member_2;
                        if _e460 {
                            phi_803_ = _e484[0];
                        } else {
                            phi_803_ = _e484[1];
                        }
                        let _e488 = phi_803_;
                        if _e465 {
                            phi_809_ = _e484[2];
                        } else {
                            phi_809_ = _e488;
                        }
                        let _e491 = phi_809_;
                        let _e492 = bitcast<u32>(_e491);
                        let _e494 = ((_e492 & 2139095040u) != 0u);
                        let _e508 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e492 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e492 & 2147483648u))), _e491, _e494) * _e448) * select(0.00000011920929f, 1f, _e494)) * _e454);
                        let _e512 = (bitcast<f32>((bitcast<u32>(_e508) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e512 {
                            let _e516 = (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) * 0.00000011920929f);
                            phi_861_ = select(0.00000000000011368684f, _e516, (_e516 > 0.00000000000011368684f));
                        } else {
                            phi_861_ = 0f;
                        }
                        let _e520 = phi_861_;
                        let _e521 = (_e483 + _e520);
                        let _e522 = (_e483 - _e520);
                        let _e523 = select(_e508, 0f, _e512);
                        if _e512 {
                            phi_873_ = 38685626000000000000000000f;
                        } else {
                            phi_873_ = (1f / _e508);
                        }
                        let _e526 = phi_873_;
                        let _e527 = (_e435 == 0u);
                        if _e527 {
                            phi_882_ = _e459[0];
                        } else {
                            phi_882_ = _e459[1];
                        }
                        let _e531 = phi_882_;
                        let _e532 = (_e435 == 2u);
                        if _e532 {
                            phi_888_ = _e459[2];
                        } else {
                            phi_888_ = _e531;
                        }
                        let _e535 = phi_888_;
                        let _e536 = bitcast<u32>(_e535);
                        let _e538 = ((_e536 & 2139095040u) != 0u);
                        let _e550 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e536 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e536 & 2147483648u))), _e535, _e538) * select(0.00000011920929f, 1f, _e538));
                        if _e527 {
                            phi_928_ = _e484[0];
                        } else {
                            phi_928_ = _e484[1];
                        }
                        let _e554 = phi_928_;
                        if _e532 {
                            phi_934_ = _e484[2];
                        } else {
                            phi_934_ = _e554;
                        }
                        let _e557 = phi_934_;
                        let _e558 = bitcast<u32>(_e557);
                        let _e560 = ((_e558 & 2139095040u) != 0u);
                        let _e574 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e558 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e558 & 2147483648u))), _e557, _e560) * _e448) * select(0.00000011920929f, 1f, _e560)) * _e454);
                        let _e578 = (bitcast<f32>((bitcast<u32>(_e574) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e578 {
                            let _e582 = (bitcast<f32>((bitcast<u32>(_e550) & 2147483647u)) * 0.00000011920929f);
                            phi_986_ = select(0.00000000000011368684f, _e582, (_e582 > 0.00000000000011368684f));
                        } else {
                            phi_986_ = 0f;
                        }
                        let _e586 = phi_986_;
                        let _e587 = (_e550 + _e586);
                        let _e588 = (_e550 - _e586);
                        let _e589 = select(_e574, 0f, _e578);
                        if _e578 {
                            phi_998_ = 38685626000000000000000000f;
                        } else {
                            phi_998_ = (1f / _e574);
                        }
                        let _e592 = phi_998_;
                        let _e593 = (_e437 == 0u);
                        if _e593 {
                            phi_1007_ = _e459[0];
                        } else {
                            phi_1007_ = _e459[1];
                        }
                        let _e597 = phi_1007_;
                        let _e598 = (_e437 == 2u);
                        if _e598 {
                            phi_1013_ = _e459[2];
                        } else {
                            phi_1013_ = _e597;
                        }
                        let _e601 = phi_1013_;
                        let _e602 = bitcast<u32>(_e601);
                        let _e604 = ((_e602 & 2139095040u) != 0u);
                        let _e616 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e602 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e602 & 2147483648u))), _e601, _e604) * select(0.00000011920929f, 1f, _e604));
                        if _e593 {
                            phi_1053_ = _e484[0];
                        } else {
                            phi_1053_ = _e484[1];
                        }
                        let _e620 = phi_1053_;
                        if _e598 {
                            phi_1059_ = _e484[2];
                        } else {
                            phi_1059_ = _e620;
                        }
                        let _e623 = phi_1059_;
                        let _e624 = bitcast<u32>(_e623);
                        let _e626 = ((_e624 & 2139095040u) != 0u);
                        let _e640 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e624 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e624 & 2147483648u))), _e623, _e626) * _e448) * select(0.00000011920929f, 1f, _e626)) * _e454);
                        let _e644 = (bitcast<f32>((bitcast<u32>(_e640) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e644 {
                            let _e648 = (bitcast<f32>((bitcast<u32>(_e616) & 2147483647u)) * 0.00000011920929f);
                            phi_1111_ = select(0.00000000000011368684f, _e648, (_e648 > 0.00000000000011368684f));
                        } else {
                            phi_1111_ = 0f;
                        }
                        let _e652 = phi_1111_;
                        let _e653 = (_e616 + _e652);
                        let _e654 = (_e616 - _e652);
                        let _e655 = select(_e640, 0f, _e644);
                        if _e644 {
                            phi_1123_ = 38685626000000000000000000f;
                        } else {
                            phi_1123_ = (1f / _e640);
                        }
                        let _e658 = phi_1123_;
                        let _e661 = bitcast<f32>((bitcast<u32>(_e483) & 2147483647u));
                        let _e664 = bitcast<f32>((bitcast<u32>(_e550) & 2147483647u));
                        let _e666 = select(_e664, _e661, (_e661 > _e664));
                        let _e669 = bitcast<f32>((bitcast<u32>(_e616) & 2147483647u));
                        if (_e398 && (select(_e669, _e666, (_e666 > _e669)) <= 1099511600000f)) {
                            let _e681 = ((_e389 & 8388607u) | (select(0u, 1u, ((_e389 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e684 = bitcast<i32>((_e389 >> bitcast<u32>(23i)));
                            let _e688 = (_e681 == 0u);
                            let _e691 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e681)), 32u, _e688)) - 8i);
                            if (_e684 == 255i) {
                                phi_1178_ = 255i;
                            } else {
                                phi_1178_ = (((_e684 + select(0i, 1i, (_e684 == 0i))) - _e691) + _e417);
                            }
                            let _e699 = phi_1178_;
                            let _e709 = (_e699 <= 0i);
                            if _e709 {
                                phi_1201_ = u32();
                            } else {
                                if _e688 {
                                    phi_1200_ = u32();
                                } else {
                                    phi_1200_ = select(((bitcast<u32>(_e699) << bitcast<u32>(23i)) | ((_e681 << bitcast<u32>(((_e691 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e699 >= 255i));
                                }
                                let _e713 = phi_1200_;
                                phi_1201_ = _e713;
                            }
                            let _e715 = phi_1201_;
                            let _e727 = ((_e394 & 8388607u) | (select(0u, 1u, ((_e394 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e730 = bitcast<i32>((_e394 >> bitcast<u32>(23i)));
                            let _e734 = (_e727 == 0u);
                            let _e737 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e727)), 32u, _e734)) - 8i);
                            if (_e730 == 255i) {
                                phi_1238_ = 255i;
                            } else {
                                phi_1238_ = (((_e730 + select(0i, 1i, (_e730 == 0i))) - _e737) + _e417);
                            }
                            let _e745 = phi_1238_;
                            let _e755 = (_e745 <= 0i);
                            if _e755 {
                                phi_1261_ = u32();
                            } else {
                                if _e734 {
                                    phi_1260_ = u32();
                                } else {
                                    phi_1260_ = select(((bitcast<u32>(_e745) << bitcast<u32>(23i)) | ((_e727 << bitcast<u32>(((_e737 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e745 >= 255i));
                                }
                                let _e759 = phi_1260_;
                                phi_1261_ = _e759;
                            }
                            let _e761 = phi_1261_;
                            phi_1269_ = bitcast<f32>(((_e393 & 2147483648u) | select(_e761, 0u, select(_e734, true, _e755))));
                            phi_1270_ = bitcast<f32>(((_e388 & 2147483648u) | select(_e715, 0u, select(_e688, true, _e709))));
                        } else {
                            phi_1269_ = 0f;
                            phi_1270_ = 1f;
                        }
                        let _e767 = phi_1269_;
                        let _e769 = phi_1270_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e773 = (_e436 % 3u);
                        let _e774 = (_e773 < 3u);
                        if _e774 {
                        } else {
                            break;
                        }
                        let _e776 = local_1[_e773];
                        let _e779 = (_e435 % 3u);
                        let _e780 = (_e779 < 3u);
                        if _e780 {
                        } else {
                            break;
                        }
                        let _e782 = local_1[_e779];
                        let _e785 = (_e437 % 3u);
                        let _e786 = (_e785 < 3u);
                        if _e786 {
                        } else {
                            break;
                        }
                        let _e788 = local_1[_e785];
                        if _e774 {
                        } else {
                            break;
                        }
                        let _e793 = local[_e773];
                        if _e780 {
                        } else {
                            break;
                        }
                        let _e797 = local[_e779];
                        if _e786 {
                        } else {
                            break;
                        }
                        let _e801 = local[_e785];
                        phi_5042_ = false;
                        phi_1366_ = type_42(_e767, false);
                        phi_1369_ = (_e769 <= _e767);
                        phi_1371_ = ((3u * _e103) + 1u);
                        phi_1373_ = 0u;
                        phi_1375_ = type_58(type_30(vec4<f32>((f32(_e776) * _e162), (f32(_e782) * _e162), (f32(_e788) * _e162), 0f), vec4<f32>((f32(_e793) * _e162), (f32(_e797) * _e162), (f32(_e801) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                        loop {
                            let _e811 = phi_5042_;
                            let _e813 = phi_1366_;
                            let _e815 = phi_1369_;
                            let _e817 = phi_1371_;
                            let _e819 = phi_1373_;
                            let _e821 = phi_1375_;
                            local_11 = _e813;
                            if _e815 {
                                phi_1386_ = true;
                            } else {
                                phi_1386_ = (_e819 > 0u);
                            }
                            let _e824 = phi_1386_;
                            if _e824 {
                                let _e825 = (_e817 > 0u);
                                if _e825 {
                                    if _e815 {
                                        phi_1472_ = _e815;
                                        phi_1473_ = _e819;
                                        phi_1474_ = _e821;
                                    } else {
                                        let _e826 = (_e819 - 1u);
                                        let _e827 = (_e826 % 128u);
                                        let _e828 = (_e827 < 128u);
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e830 = local_7[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e832 = local_6[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e834 = local_5[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e836 = local_4[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e838 = local_3[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e840 = local_2[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e845 = local_8[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e848 = local_9[_e827];
                                        phi_1472_ = (_e848 <= _e813.member);
                                        phi_1473_ = _e826;
                                        phi_1474_ = type_58(type_30(vec4<f32>(_e830, _e832, _e834, 0f), vec4<f32>(_e836, _e838, _e840, 0f)), _e845);
                                    }
                                    let _e852 = phi_1472_;
                                    let _e854 = phi_1473_;
                                    let _e856 = phi_1474_;
                                    if _e852 {
                                        let _e861 = (_e856.member_1 & 268435455u);
                                        if ((_e856.member_1 & 2147483648u) != 0u) {
                                            phi_1493_ = _e813;
                                            phi_1496_ = type_8(0u, ((_e856.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1345 = phi_1493_;
                                                let _e1347 = phi_1496_;
                                                local_10 = _e1345;
                                                local_12 = _e1345;
                                                if (_e1347.member < _e1347.member_1) {
                                                    phi_1497_ = type_8((_e1347.member + 1u), _e1347.member_1);
                                                    phi_1519_ = type_8(1u, _e1347.member);
                                                } else {
                                                    phi_1497_ = _e1347;
                                                    phi_1519_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1360 = phi_1497_;
                                                let _e1362 = phi_1519_;
                                                let _e1366 = (bitcast<i32>(_e1362.member) != 0i);
                                                if _e1366 {
                                                    let _e1371 = (_e856.member.member_1.x - _e856.member.member.x);
                                                    let _e1374 = (_e856.member.member_1.y - _e856.member.member.y);
                                                    let _e1377 = (_e856.member.member_1.z - _e856.member.member.z);
                                                    let _e1379 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                    let _e1381 = select(_e1377, _e1379, (_e1379 > _e1377));
                                                    let _e1383 = (_e1381 < (1024f * _e162));
                                                    if _e1383 {
                                                        phi_1560_ = 0u;
                                                    } else {
                                                        phi_1560_ = select(2u, 1u, (_e1381 < (2097152f * _e162)));
                                                    }
                                                    let _e1388 = phi_1560_;
                                                    switch bitcast<i32>(_e1388) {
                                                        case 0: {
                                                            phi_1566_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1566_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1566_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1566_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1391 = phi_1566_;
                                                    switch bitcast<i32>(_e1388) {
                                                        case 0: {
                                                            phi_1576_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1576_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1576_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1576_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1398 = phi_1576_;
                                                    let _e1400 = ((_e861 + (_e1362.member_1 * ((3u * _e1391) + 1u))) + (3u * _e1398));
                                                    let _e1401 = (_e1400 < _e106);
                                                    if _e1401 {
                                                        if _e1401 {
                                                        } else {
                                                            phi_5036_ = true;
                                                            break;
                                                        }
                                                        let _e1403 = global_10.member[_e1400];
                                                        phi_1592_ = _e1403;
                                                    } else {
                                                        phi_1592_ = 4294967295u;
                                                    }
                                                    let _e1405 = phi_1592_;
                                                    if _e1383 {
                                                        phi_1625_ = 0u;
                                                    } else {
                                                        phi_1625_ = select(2u, 1u, (_e1381 < (2097152f * _e162)));
                                                    }
                                                    let _e1410 = phi_1625_;
                                                    switch bitcast<i32>(_e1410) {
                                                        case 0: {
                                                            phi_1631_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1631_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1631_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1631_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1413 = phi_1631_;
                                                    let _e1417 = (_e861 + (_e1362.member_1 * ((3u * _e1413) + 1u)));
                                                    switch bitcast<i32>(_e1410) {
                                                        case 0: {
                                                            let _e1692 = (_e1417 < _e106);
                                                            if _e1692 {
                                                                if _e1692 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1694 = global_10.member[_e1417];
                                                                phi_1658_ = _e1694;
                                                            } else {
                                                                phi_1658_ = 0u;
                                                            }
                                                            let _e1696 = phi_1658_;
                                                            let _e1698 = ((10u * _e436) & 31u);
                                                            let _e1708 = ((10u * _e435) & 31u);
                                                            let _e1718 = ((10u * _e437) & 31u);
                                                            let _e1728 = (_e1417 + 1u);
                                                            let _e1729 = (_e1728 < _e106);
                                                            if _e1729 {
                                                                if _e1729 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1731 = global_10.member[_e1728];
                                                                phi_1707_ = _e1731;
                                                            } else {
                                                                phi_1707_ = 0u;
                                                            }
                                                            let _e1733 = phi_1707_;
                                                            let _e1759 = (_e1417 + 2u);
                                                            let _e1760 = (_e1759 < _e106);
                                                            if _e1760 {
                                                                if _e1760 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1762 = global_10.member[_e1759];
                                                                phi_1756_ = _e1762;
                                                            } else {
                                                                phi_1756_ = 0u;
                                                            }
                                                            let _e1764 = phi_1756_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | ((_e1696 >> bitcast<u32>(_e1698)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | ((_e1696 >> bitcast<u32>(_e1708)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | ((_e1696 >> bitcast<u32>(_e1718)) & 1023u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | ((_e1733 >> bitcast<u32>(_e1698)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | ((_e1733 >> bitcast<u32>(_e1708)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | ((_e1733 >> bitcast<u32>(_e1718)) & 1023u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | ((_e1764 >> bitcast<u32>(_e1698)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | ((_e1764 >> bitcast<u32>(_e1708)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | ((_e1764 >> bitcast<u32>(_e1718)) & 1023u))) - 8388608f) * _e162))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1506 = (_e1417 < _e106);
                                                            if _e1506 {
                                                                if _e1506 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1508 = global_10.member[_e1417];
                                                                phi_1805_ = _e1508;
                                                            } else {
                                                                phi_1805_ = 0u;
                                                            }
                                                            let _e1510 = phi_1805_;
                                                            let _e1511 = (_e1417 + 1u);
                                                            let _e1512 = (_e1511 < _e106);
                                                            if _e1512 {
                                                                if _e1512 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1514 = global_10.member[_e1511];
                                                                phi_1820_ = _e1514;
                                                            } else {
                                                                phi_1820_ = 0u;
                                                            }
                                                            let _e1516 = phi_1820_;
                                                            let _e1517 = (_e436 == 1u);
                                                            if _e1517 {
                                                                phi_1830_ = ((_e1510 >> bitcast<u32>(21i)) | (_e1516 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1830_ = (_e1516 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1526 = phi_1830_;
                                                            let _e1534 = (_e435 == 1u);
                                                            if _e1534 {
                                                                phi_1851_ = ((_e1510 >> bitcast<u32>(21i)) | (_e1516 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1851_ = (_e1516 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1543 = phi_1851_;
                                                            let _e1551 = (_e437 == 1u);
                                                            if _e1551 {
                                                                phi_1872_ = ((_e1510 >> bitcast<u32>(21i)) | (_e1516 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1872_ = (_e1516 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1560 = phi_1872_;
                                                            let _e1569 = (_e1417 + 2u);
                                                            let _e1570 = (_e1569 < _e106);
                                                            if _e1570 {
                                                                if _e1570 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1572 = global_10.member[_e1569];
                                                                phi_1902_ = _e1572;
                                                            } else {
                                                                phi_1902_ = 0u;
                                                            }
                                                            let _e1574 = phi_1902_;
                                                            let _e1575 = (_e1417 + 3u);
                                                            let _e1576 = (_e1575 < _e106);
                                                            if _e1576 {
                                                                if _e1576 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1578 = global_10.member[_e1575];
                                                                phi_1917_ = _e1578;
                                                            } else {
                                                                phi_1917_ = 0u;
                                                            }
                                                            let _e1580 = phi_1917_;
                                                            if _e1517 {
                                                                phi_1927_ = ((_e1574 >> bitcast<u32>(21i)) | (_e1580 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1927_ = (_e1580 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1589 = phi_1927_;
                                                            if _e1534 {
                                                                phi_1948_ = ((_e1574 >> bitcast<u32>(21i)) | (_e1580 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1948_ = (_e1580 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1605 = phi_1948_;
                                                            if _e1551 {
                                                                phi_1969_ = ((_e1574 >> bitcast<u32>(21i)) | (_e1580 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1969_ = (_e1580 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1621 = phi_1969_;
                                                            let _e1630 = (_e1417 + 4u);
                                                            let _e1631 = (_e1630 < _e106);
                                                            if _e1631 {
                                                                if _e1631 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1633 = global_10.member[_e1630];
                                                                phi_1999_ = _e1633;
                                                            } else {
                                                                phi_1999_ = 0u;
                                                            }
                                                            let _e1635 = phi_1999_;
                                                            let _e1636 = (_e1417 + 5u);
                                                            let _e1637 = (_e1636 < _e106);
                                                            if _e1637 {
                                                                if _e1637 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1639 = global_10.member[_e1636];
                                                                phi_2014_ = _e1639;
                                                            } else {
                                                                phi_2014_ = 0u;
                                                            }
                                                            let _e1641 = phi_2014_;
                                                            if _e1517 {
                                                                phi_2024_ = ((_e1635 >> bitcast<u32>(21i)) | (_e1641 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2024_ = (_e1641 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1650 = phi_2024_;
                                                            if _e1534 {
                                                                phi_2045_ = ((_e1635 >> bitcast<u32>(21i)) | (_e1641 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2045_ = (_e1641 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1666 = phi_2045_;
                                                            if _e1551 {
                                                                phi_2066_ = ((_e1635 >> bitcast<u32>(21i)) | (_e1641 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2066_ = (_e1641 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1682 = phi_2066_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1526, _e1510, _e460) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1543, _e1510, _e527) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1560, _e1510, _e593) & 2097151u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1589, _e1574, _e460) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1605, _e1574, _e527) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1621, _e1574, _e593) & 2097151u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1650, _e1635, _e460) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1666, _e1635, _e527) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1682, _e1635, _e593) & 2097151u))) - 8388608f) * _e162))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1419 = (_e1417 + _e436);
                                                            let _e1420 = (_e1419 < _e106);
                                                            if _e1420 {
                                                                if _e1420 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1422 = global_10.member[_e1419];
                                                                phi_2097_ = _e1422;
                                                            } else {
                                                                phi_2097_ = 0u;
                                                            }
                                                            let _e1424 = phi_2097_;
                                                            let _e1428 = (_e1417 + _e435);
                                                            let _e1429 = (_e1428 < _e106);
                                                            if _e1429 {
                                                                if _e1429 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1431 = global_10.member[_e1428];
                                                                phi_2115_ = _e1431;
                                                            } else {
                                                                phi_2115_ = 0u;
                                                            }
                                                            let _e1433 = phi_2115_;
                                                            let _e1437 = (_e1417 + _e437);
                                                            let _e1438 = (_e1437 < _e106);
                                                            if _e1438 {
                                                                if _e1438 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1440 = global_10.member[_e1437];
                                                                phi_2133_ = _e1440;
                                                            } else {
                                                                phi_2133_ = 0u;
                                                            }
                                                            let _e1442 = phi_2133_;
                                                            let _e1447 = (_e1417 + 3u);
                                                            let _e1448 = (_e1447 + _e436);
                                                            let _e1449 = (_e1448 < _e106);
                                                            if _e1449 {
                                                                if _e1449 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1451 = global_10.member[_e1448];
                                                                phi_2156_ = _e1451;
                                                            } else {
                                                                phi_2156_ = 0u;
                                                            }
                                                            let _e1453 = phi_2156_;
                                                            let _e1457 = (_e1447 + _e435);
                                                            let _e1458 = (_e1457 < _e106);
                                                            if _e1458 {
                                                                if _e1458 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1460 = global_10.member[_e1457];
                                                                phi_2174_ = _e1460;
                                                            } else {
                                                                phi_2174_ = 0u;
                                                            }
                                                            let _e1462 = phi_2174_;
                                                            let _e1466 = (_e1447 + _e437);
                                                            let _e1467 = (_e1466 < _e106);
                                                            if _e1467 {
                                                                if _e1467 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1469 = global_10.member[_e1466];
                                                                phi_2192_ = _e1469;
                                                            } else {
                                                                phi_2192_ = 0u;
                                                            }
                                                            let _e1471 = phi_2192_;
                                                            let _e1476 = (_e1417 + 6u);
                                                            let _e1477 = (_e1476 + _e436);
                                                            let _e1478 = (_e1477 < _e106);
                                                            if _e1478 {
                                                                if _e1478 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1480 = global_10.member[_e1477];
                                                                phi_2215_ = _e1480;
                                                            } else {
                                                                phi_2215_ = 0u;
                                                            }
                                                            let _e1482 = phi_2215_;
                                                            let _e1486 = (_e1476 + _e435);
                                                            let _e1487 = (_e1486 < _e106);
                                                            if _e1487 {
                                                                if _e1487 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1489 = global_10.member[_e1486];
                                                                phi_2233_ = _e1489;
                                                            } else {
                                                                phi_2233_ = 0u;
                                                            }
                                                            let _e1491 = phi_2233_;
                                                            let _e1495 = (_e1476 + _e437);
                                                            let _e1496 = (_e1495 < _e106);
                                                            if _e1496 {
                                                                if _e1496 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1498 = global_10.member[_e1495];
                                                                phi_2251_ = _e1498;
                                                            } else {
                                                                phi_2251_ = 0u;
                                                            }
                                                            let _e1500 = phi_2251_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1424)) * _e162), (f32(bitcast<i32>(_e1433)) * _e162), (f32(bitcast<i32>(_e1442)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1453)) * _e162), (f32(bitcast<i32>(_e1462)) * _e162), (f32(bitcast<i32>(_e1471)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1482)) * _e162), (f32(bitcast<i32>(_e1491)) * _e162), (f32(bitcast<i32>(_e1500)) * _e162)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2257_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1792 = phi_2257_;
                                                    let _e1800 = (_e1792[0][2] - _e616);
                                                    let _e1803 = (((_e1792[0][0] - _e483) * _e655) - (_e1800 * _e523));
                                                    let _e1806 = (((_e1792[0][1] - _e550) * _e655) - (_e1800 * _e589));
                                                    let _e1813 = (_e1792[1][2] - _e616);
                                                    let _e1816 = (((_e1792[1][0] - _e483) * _e655) - (_e1813 * _e523));
                                                    let _e1819 = (((_e1792[1][1] - _e550) * _e655) - (_e1813 * _e589));
                                                    let _e1826 = (_e1792[2][2] - _e616);
                                                    let _e1829 = (((_e1792[2][0] - _e483) * _e655) - (_e1826 * _e523));
                                                    let _e1832 = (((_e1792[2][1] - _e550) * _e655) - (_e1826 * _e589));
                                                    let _e1833 = (_e1829 * _e1819);
                                                    let _e1834 = (_e1832 * _e1816);
                                                    let _e1835 = (_e1803 * _e1832);
                                                    let _e1836 = (_e1806 * _e1829);
                                                    let _e1837 = (_e1816 * _e1806);
                                                    let _e1838 = (_e1819 * _e1803);
                                                    let _e1843 = (((_e1833 >= _e1834) && (_e1835 >= _e1836)) && (_e1837 >= _e1838));
                                                    if (_e1843 || (((_e1833 <= _e1834) && (_e1835 <= _e1836)) && (_e1837 <= _e1838))) {
                                                        let _e1850 = select(-1f, 1f, _e1843);
                                                        let _e1852 = ((_e1833 - _e1834) * _e1850);
                                                        let _e1854 = select(0f, _e1852, (_e1852 > 0f));
                                                        let _e1856 = ((_e1835 - _e1836) * _e1850);
                                                        let _e1858 = select(0f, _e1856, (_e1856 > 0f));
                                                        let _e1860 = ((_e1837 - _e1838) * _e1850);
                                                        let _e1862 = select(0f, _e1860, (_e1860 > 0f));
                                                        let _e1864 = ((_e1854 + _e1858) + _e1862);
                                                        if (_e1864 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3141_ = type_21();
                                                            phi_3142_ = true;
                                                            phi_3143_ = false;
                                                        } else {
                                                            let _e1867 = select(_e1816, _e1803, (_e1803 < _e1816));
                                                            if (select(_e1829, _e1867, (_e1867 < _e1829)) > 0f) {
                                                                phi_2409_ = true;
                                                            } else {
                                                                let _e1872 = select(_e1816, _e1803, (_e1803 > _e1816));
                                                                phi_2409_ = (select(_e1829, _e1872, (_e1872 > _e1829)) < 0f);
                                                            }
                                                            let _e1877 = phi_2409_;
                                                            if _e1877 {
                                                                phi_3138_ = type_21();
                                                                phi_3139_ = true;
                                                                phi_3140_ = false;
                                                            } else {
                                                                let _e1879 = select(_e1819, _e1806, (_e1806 < _e1819));
                                                                if (select(_e1832, _e1879, (_e1879 < _e1832)) > 0f) {
                                                                    phi_2438_ = true;
                                                                } else {
                                                                    let _e1884 = select(_e1819, _e1806, (_e1806 > _e1819));
                                                                    phi_2438_ = (select(_e1832, _e1884, (_e1884 > _e1832)) < 0f);
                                                                }
                                                                let _e1889 = phi_2438_;
                                                                if _e1889 {
                                                                    phi_3136_ = type_21();
                                                                    phi_3137_ = false;
                                                                } else {
                                                                    let _e1891 = select(_e1792[1][0], _e1792[0][0], (_e1792[0][0] < _e1792[1][0]));
                                                                    let _e1895 = select(_e1792[1][0], _e1792[0][0], (_e1792[0][0] > _e1792[1][0]));
                                                                    let _e1899 = select(_e1792[1][1], _e1792[0][1], (_e1792[0][1] < _e1792[1][1]));
                                                                    let _e1903 = select(_e1792[1][1], _e1792[0][1], (_e1792[0][1] > _e1792[1][1]));
                                                                    let _e1907 = select(_e1792[1][2], _e1792[0][2], (_e1792[0][2] < _e1792[1][2]));
                                                                    let _e1911 = select(_e1792[1][2], _e1792[0][2], (_e1792[0][2] > _e1792[1][2]));
                                                                    let _e1916 = ((select(_e1792[2][0], _e1891, (_e1891 < _e1792[2][0])) - _e521) * _e526);
                                                                    let _e1917 = ((select(_e1792[2][0], _e1895, (_e1895 > _e1792[2][0])) - _e522) * _e526);
                                                                    let _e1920 = ((select(_e1792[2][1], _e1899, (_e1899 < _e1792[2][1])) - _e587) * _e592);
                                                                    let _e1921 = ((select(_e1792[2][1], _e1903, (_e1903 > _e1792[2][1])) - _e588) * _e592);
                                                                    let _e1924 = ((select(_e1792[2][2], _e1907, (_e1907 < _e1792[2][2])) - _e653) * _e658);
                                                                    let _e1925 = ((select(_e1792[2][2], _e1911, (_e1911 > _e1792[2][2])) - _e654) * _e658);
                                                                    let _e1927 = select(_e1925, _e1924, (_e1924 < _e1925));
                                                                    let _e1929 = select(_e1925, _e1924, (_e1924 > _e1925));
                                                                    let _e1931 = select(_e1917, _e1916, (_e1916 < _e1917));
                                                                    let _e1933 = select(_e1921, _e1920, (_e1920 < _e1921));
                                                                    let _e1935 = select(_e1933, _e1931, (_e1931 > _e1933));
                                                                    let _e1937 = select(_e1927, _e1935, (_e1935 > _e1927));
                                                                    let _e1939 = select(_e1917, _e1916, (_e1916 > _e1917));
                                                                    let _e1941 = select(_e1921, _e1920, (_e1920 > _e1921));
                                                                    let _e1943 = select(_e1941, _e1939, (_e1939 < _e1941));
                                                                    let _e1945 = select(_e1929, _e1943, (_e1943 < _e1929));
                                                                    let _e1946 = -(_e1927);
                                                                    let _e1952 = select(_e769, _e1937, (_e1937 > _e769));
                                                                    if (_e1952 > (_e1945 + (select(_e1946, _e1929, (_e1929 > _e1946)) * 0.0000019073523f))) {
                                                                        phi_3131_ = type_21();
                                                                        phi_3132_ = true;
                                                                    } else {
                                                                        let _e1954 = (_e1952 > _e1345.member);
                                                                        if _e1954 {
                                                                            phi_3130_ = type_21();
                                                                        } else {
                                                                            let _e1955 = vec3<f32>(_e1792[0][0], _e1792[0][1], _e1792[0][2]);
                                                                            let _e1956 = vec3<f32>(_e1792[1][0], _e1792[1][1], _e1792[1][2]);
                                                                            let _e1957 = vec3<f32>(_e1792[2][0], _e1792[2][1], _e1792[2][2]);
                                                                            let _e1958 = (_e1792[1][0] - _e1792[0][0]);
                                                                            let _e1959 = (_e1792[1][1] - _e1792[0][1]);
                                                                            let _e1960 = (_e1792[1][2] - _e1792[0][2]);
                                                                            let _e1961 = vec3<f32>(_e1958, _e1959, _e1960);
                                                                            let _e1962 = (_e1792[2][0] - _e1792[1][0]);
                                                                            let _e1963 = (_e1792[2][1] - _e1792[1][1]);
                                                                            let _e1964 = (_e1792[2][2] - _e1792[1][2]);
                                                                            let _e1965 = vec3<f32>(_e1962, _e1963, _e1964);
                                                                            let _e1966 = (_e1792[0][0] - _e1792[2][0]);
                                                                            let _e1967 = (_e1792[0][1] - _e1792[2][1]);
                                                                            let _e1968 = (_e1792[0][2] - _e1792[2][2]);
                                                                            let _e1969 = vec3<f32>(_e1966, _e1967, _e1968);
                                                                            let _e1972 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                                            let _e1975 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                                            let _e1977 = select(_e1975, _e1972, (_e1972 > _e1975));
                                                                            let _e1980 = bitcast<f32>((bitcast<u32>(_e1960) & 2147483647u));
                                                                            let _e1982 = select(_e1980, _e1977, (_e1977 > _e1980));
                                                                            let _e1985 = bitcast<f32>((bitcast<u32>(_e1962) & 2147483647u));
                                                                            let _e1988 = bitcast<f32>((bitcast<u32>(_e1963) & 2147483647u));
                                                                            let _e1990 = select(_e1988, _e1985, (_e1985 > _e1988));
                                                                            let _e1993 = bitcast<f32>((bitcast<u32>(_e1964) & 2147483647u));
                                                                            let _e1995 = select(_e1993, _e1990, (_e1990 > _e1993));
                                                                            let _e1998 = bitcast<f32>((bitcast<u32>(_e1966) & 2147483647u));
                                                                            let _e2001 = bitcast<f32>((bitcast<u32>(_e1967) & 2147483647u));
                                                                            let _e2003 = select(_e2001, _e1998, (_e1998 > _e2001));
                                                                            let _e2006 = bitcast<f32>((bitcast<u32>(_e1968) & 2147483647u));
                                                                            let _e2008 = select(_e2006, _e2003, (_e2003 > _e2006));
                                                                            let _e2010 = select(_e1995, _e1982, (_e1982 > _e1995));
                                                                            let _e2012 = select(_e2008, _e2010, (_e2010 > _e2008));
                                                                            if (_e1982 == _e2012) {
                                                                                phi_2857_ = _e1819;
                                                                                phi_2858_ = _e1816;
                                                                                phi_2859_ = _e1806;
                                                                                phi_2860_ = _e1803;
                                                                                phi_2861_ = _e1955;
                                                                                phi_2862_ = _e1969;
                                                                                phi_2863_ = _e1965;
                                                                                phi_2864_ = _e1961;
                                                                            } else {
                                                                                let _e2014 = (_e1995 == _e2012);
                                                                                let _e2019 = vec3(_e2014);
                                                                                phi_2857_ = select(_e1806, _e1832, _e2014);
                                                                                phi_2858_ = select(_e1803, _e1829, _e2014);
                                                                                phi_2859_ = select(_e1832, _e1819, _e2014);
                                                                                phi_2860_ = select(_e1829, _e1816, _e2014);
                                                                                phi_2861_ = select(_e1957, _e1956, _e2019);
                                                                                phi_2862_ = select(_e1965, _e1961, _e2019);
                                                                                phi_2863_ = select(_e1961, _e1969, _e2019);
                                                                                phi_2864_ = select(_e1969, _e1965, _e2019);
                                                                            }
                                                                            let _e2025 = phi_2857_;
                                                                            let _e2027 = phi_2858_;
                                                                            let _e2029 = phi_2859_;
                                                                            let _e2031 = phi_2860_;
                                                                            let _e2033 = phi_2861_;
                                                                            let _e2035 = phi_2862_;
                                                                            let _e2037 = phi_2863_;
                                                                            let _e2039 = phi_2864_;
                                                                            let _e2046 = ((_e2037.y * _e2035.z) - (_e2035.y * _e2037.z));
                                                                            let _e2051 = ((_e2037.z * _e2035.x) - (_e2035.z * _e2037.x));
                                                                            let _e2054 = ((_e2037.x * _e2035.y) - (_e2035.x * _e2037.y));
                                                                            if (_e1854 >= _e1858) {
                                                                                phi_2901_ = select(true, false, (_e1854 >= _e1862));
                                                                            } else {
                                                                                phi_2901_ = true;
                                                                            }
                                                                            let _e2059 = phi_2901_;
                                                                            if _e2059 {
                                                                                phi_2910_ = select(_e1957, _e1956, vec3((_e1858 >= _e1862)));
                                                                            } else {
                                                                                phi_2910_ = _e1955;
                                                                            }
                                                                            let _e2064 = phi_2910_;
                                                                            let _e2075 = (((_e2046 * (_e2064.x - _e483)) + (_e2051 * (_e2064.y - _e550))) + (_e2054 * (_e2064.z - _e616)));
                                                                            let _e2080 = (((_e2046 * _e523) + (_e2051 * _e589)) + (_e2054 * _e655));
                                                                            let _e2081 = (_e2027 - _e2031);
                                                                            let _e2082 = (_e2025 - _e2029);
                                                                            let _e2090 = (-(((_e2031 * _e2081) + (_e2029 * _e2082))) / ((_e2081 * _e2081) + (_e2082 * _e2082)));
                                                                            let _e2092 = select(1f, _e2090, (_e2090 < 1f));
                                                                            let _e2094 = select(0f, _e2092, (_e2092 > 0f));
                                                                            let _e2107 = ((_e2033.x + (_e2039.x * _e2094)) - _e483);
                                                                            let _e2108 = ((_e2033.y + (_e2039.y * _e2094)) - _e550);
                                                                            let _e2109 = ((_e2033.z + (_e2039.z * _e2094)) - _e616);
                                                                            let _e2110 = (_e2109 / _e655);
                                                                            let _e2122 = bitcast<f32>((bitcast<u32>(_e2107) & 2147483647u));
                                                                            let _e2125 = bitcast<f32>((bitcast<u32>(_e2108) & 2147483647u));
                                                                            let _e2127 = select(_e2125, _e2122, (_e2122 > _e2125));
                                                                            let _e2130 = bitcast<f32>((bitcast<u32>(_e2109) & 2147483647u));
                                                                            let _e2132 = select(_e2130, _e2127, (_e2127 > _e2130));
                                                                            let _e2138 = bitcast<f32>((bitcast<u32>(_e2046) & 2147483647u));
                                                                            let _e2141 = bitcast<f32>((bitcast<u32>(_e2051) & 2147483647u));
                                                                            let _e2143 = select(_e2141, _e2138, (_e2138 > _e2141));
                                                                            let _e2146 = bitcast<f32>((bitcast<u32>(_e2054) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e2046 * _e2107) + (_e2051 * _e2108)) + (_e2054 * _e2109)) - _e2075)) & 2147483647u)) <= ((0.0000009536743f * select(_e2012, _e2132, (_e2132 > _e2012))) * select(_e2146, _e2143, (_e2143 > _e2146)))) {
                                                                                let _e2156 = bitcast<f32>((bitcast<u32>(_e2037.x) & 2147483647u));
                                                                                let _e2159 = bitcast<f32>((bitcast<u32>(_e2037.y) & 2147483647u));
                                                                                let _e2161 = select(_e2159, _e2156, (_e2156 > _e2159));
                                                                                let _e2164 = bitcast<f32>((bitcast<u32>(_e2037.z) & 2147483647u));
                                                                                let _e2170 = bitcast<f32>((bitcast<u32>(_e2035.x) & 2147483647u));
                                                                                let _e2173 = bitcast<f32>((bitcast<u32>(_e2035.y) & 2147483647u));
                                                                                let _e2175 = select(_e2173, _e2170, (_e2170 > _e2173));
                                                                                let _e2178 = bitcast<f32>((bitcast<u32>(_e2035.z) & 2147483647u));
                                                                                let _e2182 = (bitcast<f32>((bitcast<u32>(_e2080) & 2147483647u)) > ((0.0000038146973f * select(_e2164, _e2161, (_e2161 > _e2164))) * select(_e2178, _e2175, (_e2175 > _e2178))));
                                                                                if _e2182 {
                                                                                    phi_3075_ = (_e2075 / _e2080);
                                                                                } else {
                                                                                    phi_3075_ = f32();
                                                                                }
                                                                                let _e2185 = phi_3075_;
                                                                                phi_3077_ = _e2185;
                                                                                phi_3078_ = select(true, false, _e2182);
                                                                            } else {
                                                                                phi_3077_ = f32();
                                                                                phi_3078_ = true;
                                                                            }
                                                                            let _e2188 = phi_3077_;
                                                                            let _e2190 = phi_3078_;
                                                                            if _e2190 {
                                                                                let _e2198 = (((_e2046 * (_e2107 - (_e523 * _e2110))) + (_e2051 * (_e2108 - (_e589 * _e2110)))) / _e2080);
                                                                                if (bitcast<f32>((bitcast<u32>(_e2198) & 2147483647u)) <= _e2012) {
                                                                                    phi_3098_ = (_e2110 + _e2198);
                                                                                } else {
                                                                                    phi_3098_ = _e2110;
                                                                                }
                                                                                let _e2205 = phi_3098_;
                                                                                phi_3099_ = _e2205;
                                                                            } else {
                                                                                phi_3099_ = _e2188;
                                                                            }
                                                                            let _e2207 = phi_3099_;
                                                                            let _e2209 = select(_e1945, _e2207, (_e2207 < _e1945));
                                                                            let _e2211 = select(_e1937, _e2209, (_e2209 > _e1937));
                                                                            if (_e2211 >= _e769) {
                                                                                let _e2213 = (_e2211 <= _e1345.member);
                                                                                if _e2213 {
                                                                                    let _e2214 = (1f / _e1864);
                                                                                    phi_3122_ = type_21(_e2211, (_e1858 * _e2214), (_e1862 * _e2214), _e1405);
                                                                                } else {
                                                                                    phi_3122_ = type_21();
                                                                                }
                                                                                let _e2219 = phi_3122_;
                                                                                phi_3124_ = _e2219;
                                                                                phi_3125_ = select(true, false, _e2213);
                                                                            } else {
                                                                                phi_3124_ = type_21();
                                                                                phi_3125_ = true;
                                                                            }
                                                                            let _e2222 = phi_3124_;
                                                                            let _e2224 = phi_3125_;
                                                                            if _e2224 {
                                                                                phi_3129_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_3129_ = _e2222;
                                                                            }
                                                                            let _e2226 = phi_3129_;
                                                                            phi_3130_ = _e2226;
                                                                        }
                                                                        let _e2228 = phi_3130_;
                                                                        phi_3131_ = _e2228;
                                                                        phi_3132_ = _e1954;
                                                                    }
                                                                    let _e2230 = phi_3131_;
                                                                    let _e2232 = phi_3132_;
                                                                    phi_3136_ = _e2230;
                                                                    phi_3137_ = _e2232;
                                                                }
                                                                let _e2234 = phi_3136_;
                                                                let _e2236 = phi_3137_;
                                                                phi_3138_ = _e2234;
                                                                phi_3139_ = _e1889;
                                                                phi_3140_ = _e2236;
                                                            }
                                                            let _e2238 = phi_3138_;
                                                            let _e2240 = phi_3139_;
                                                            let _e2242 = phi_3140_;
                                                            phi_3141_ = _e2238;
                                                            phi_3142_ = _e2240;
                                                            phi_3143_ = _e2242;
                                                        }
                                                        let _e2244 = phi_3141_;
                                                        let _e2246 = phi_3142_;
                                                        let _e2248 = phi_3143_;
                                                        phi_3151_ = _e2244;
                                                        phi_3152_ = select(_e2248, true, _e2246);
                                                    } else {
                                                        phi_3151_ = type_21();
                                                        phi_3152_ = true;
                                                    }
                                                    let _e2251 = phi_3151_;
                                                    let _e2253 = phi_3152_;
                                                    if _e2253 {
                                                        phi_3156_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3156_ = _e2251;
                                                    }
                                                    let _e2255 = phi_3156_;
                                                    if (_e2255.member_3 != 4294967295u) {
                                                        if (_e1405 == _e171) {
                                                            phi_3491_ = false;
                                                        } else {
                                                            let _e2259 = (_e1405 < arrayLength((&global_5.member)));
                                                            if _e2259 {
                                                                if _e2259 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e2261 = global_5.member[_e1405];
                                                                phi_3179_ = _e2261;
                                                            } else {
                                                                phi_3179_ = 4294967295u;
                                                            }
                                                            let _e2263 = phi_3179_;
                                                            let _e2264 = (_e2263 < arrayLength((&global_6.member)));
                                                            if _e2264 {
                                                                if _e2264 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e2266 = global_6.member[_e2263];
                                                                phi_3193_ = _e2266;
                                                            } else {
                                                                phi_3193_ = 0i;
                                                            }
                                                            let _e2268 = phi_3193_;
                                                            let _e2269 = (_e2268 == 0i);
                                                            if _e2269 {
                                                                phi_3490_ = true;
                                                            } else {
                                                                if _e460 {
                                                                    phi_3216_ = vec3<f32>(_e1792[0][0], _e1792[0][1], _e1792[0][2]);
                                                                } else {
                                                                    if (_e436 == 1u) {
                                                                        phi_3215_ = vec3<f32>(_e1792[0][2], _e1792[0][0], _e1792[0][1]);
                                                                    } else {
                                                                        phi_3215_ = vec3<f32>(_e1792[0][1], _e1792[0][2], _e1792[0][0]);
                                                                    }
                                                                    let _e2274 = phi_3215_;
                                                                    phi_3216_ = _e2274;
                                                                }
                                                                let _e2277 = phi_3216_;
                                                                if _e460 {
                                                                    phi_3235_ = vec3<f32>(_e1792[1][0], _e1792[1][1], _e1792[1][2]);
                                                                } else {
                                                                    if (_e436 == 1u) {
                                                                        phi_3234_ = vec3<f32>(_e1792[1][2], _e1792[1][0], _e1792[1][1]);
                                                                    } else {
                                                                        phi_3234_ = vec3<f32>(_e1792[1][1], _e1792[1][2], _e1792[1][0]);
                                                                    }
                                                                    let _e2282 = phi_3234_;
                                                                    phi_3235_ = _e2282;
                                                                }
                                                                let _e2285 = phi_3235_;
                                                                if _e460 {
                                                                    phi_3254_ = vec3<f32>(_e1792[2][0], _e1792[2][1], _e1792[2][2]);
                                                                } else {
                                                                    if (_e436 == 1u) {
                                                                        phi_3253_ = vec3<f32>(_e1792[2][2], _e1792[2][0], _e1792[2][1]);
                                                                    } else {
                                                                        phi_3253_ = vec3<f32>(_e1792[2][1], _e1792[2][2], _e1792[2][0]);
                                                                    }
                                                                    let _e2290 = phi_3253_;
                                                                    phi_3254_ = _e2290;
                                                                }
                                                                let _e2293 = phi_3254_;
                                                                let _e2296 = (_e2285.x - _e2277.x);
                                                                let _e2299 = (_e2285.y - _e2277.y);
                                                                let _e2302 = (_e2285.z - _e2277.z);
                                                                let _e2304 = (_e2293.x - _e2277.x);
                                                                let _e2306 = (_e2293.y - _e2277.y);
                                                                let _e2308 = (_e2293.z - _e2277.z);
                                                                if (_e303.member_1 == 1u) {
                                                                    phi_3290_ = (vec3<f32>(_e303.member[0], _e303.member[1], _e303.member[2]) - _e2277);
                                                                } else {
                                                                    phi_3290_ = vec3<f32>(_e303.member[0], _e303.member[1], _e303.member[2]);
                                                                }
                                                                let _e2323 = phi_3290_;
                                                                let _e2329 = bitcast<f32>((bitcast<u32>((_e2296 * _e2306)) ^ _e303.member_3[0]));
                                                                let _e2333 = bitcast<f32>((bitcast<u32>((_e2299 * _e2304)) ^ _e303.member_3[0]));
                                                                let _e2337 = bitcast<f32>((bitcast<u32>((_e2299 * _e2308)) ^ _e303.member_3[0]));
                                                                let _e2341 = bitcast<f32>((bitcast<u32>((_e2302 * _e2306)) ^ _e303.member_3[0]));
                                                                let _e2345 = bitcast<f32>((bitcast<u32>((_e2302 * _e2304)) ^ _e303.member_3[0]));
                                                                let _e2349 = bitcast<f32>((bitcast<u32>((_e2296 * _e2308)) ^ _e303.member_3[0]));
                                                                let _e2350 = (_e2337 - _e2341);
                                                                let _e2351 = (_e2345 - _e2349);
                                                                let _e2352 = (_e2329 - _e2333);
                                                                let _e2376 = (bitcast<f32>((bitcast<u32>(_e2337) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2341) & 2147483647u)));
                                                                let _e2383 = (bitcast<f32>((bitcast<u32>(_e2345) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2349) & 2147483647u)));
                                                                let _e2390 = (bitcast<f32>((bitcast<u32>(_e2329) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2333) & 2147483647u)));
                                                                if (_e303.member_2 == 0f) {
                                                                    phi_3472_ = 0f;
                                                                } else {
                                                                    let _e2420 = bitcast<f32>((bitcast<u32>(_e2350) & 2147483647u));
                                                                    let _e2423 = bitcast<f32>((bitcast<u32>(_e2351) & 2147483647u));
                                                                    let _e2426 = bitcast<f32>((bitcast<u32>(_e2352) & 2147483647u));
                                                                    let _e2428 = select(_e2426, _e2423, (_e2423 > _e2426));
                                                                    let _e2432 = select(_e2426, _e2423, (_e2423 < _e2426));
                                                                    let _e2436 = select(_e2423, _e2420, (_e2420 < _e2423));
                                                                    let _e2438 = select(_e2423, _e2420, (_e2420 > _e2423));
                                                                    let _e2440 = select(_e2426, _e2438, (_e2438 < _e2426));
                                                                    phi_3472_ = bitcast<f32>((bitcast<u32>((_e303.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2428, _e2420, (_e2420 > _e2428)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2440, _e2436, (_e2436 > _e2440)))) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2432, _e2420, (_e2420 < _e2432)))) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2376 + _e2383) + _e2390))) ^ _e303.member_3[0]))) * 1.0000005f)) ^ _e303.member_3[0])))) ^ _e303.member_3[0]));
                                                                }
                                                                let _e2467 = phi_3472_;
                                                                phi_3490_ = (_e2269 || !(((((bitcast<f32>((bitcast<u32>((_e2323.x * _e2350)) ^ _e303.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2323.y * _e2351)) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2323.z * _e2352)) ^ _e303.member_3[0]))) * f32(-(_e2268))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2323.x) & 2147483647u)) * _e2376)) ^ _e303.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2323.y) & 2147483647u)) * _e2383)) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2323.z) & 2147483647u)) * _e2390)) ^ _e303.member_3[0]))))) ^ _e303.member_3[0])) + _e2467) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2481 = phi_3490_;
                                                            phi_3491_ = _e2481;
                                                        }
                                                        let _e2483 = phi_3491_;
                                                        if _e2483 {
                                                            phi_3496_ = type_42(_e1345.member, true);
                                                        } else {
                                                            phi_3496_ = _e1345;
                                                        }
                                                        let _e2488 = phi_3496_;
                                                        phi_3497_ = _e2488;
                                                    } else {
                                                        phi_3497_ = _e1345;
                                                    }
                                                    let _e2490 = phi_3497_;
                                                    phi_1494_ = _e2490;
                                                } else {
                                                    phi_1494_ = type_42();
                                                }
                                                let _e2492 = phi_1494_;
                                                continue;
                                                continuing {
                                                    phi_1493_ = _e2492;
                                                    phi_1496_ = _e1360;
                                                    phi_5036_ = _e811;
                                                    break if !(_e1366);
                                                }
                                            }
                                            let _e2495 = phi_5036_;
                                            phi_5275_ = _e2495;
                                            if _e2495 {
                                                break;
                                            }
                                            let _e2497 = local_10;
                                            phi_5279_ = _e2495;
                                            let _e2743 = local_12;
                                            phi_4770_ = _e2743;
                                            phi_4771_ = false;
                                            phi_4772_ = select(_e854, 0u, _e2497.member_1);
                                            phi_4773_ = _e856;
                                        } else {
                                            if (_e856.member_1 >= _e103) {
                                                phi_4305_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e856.member_1 < _e103) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e868 = (_e436 * 2u);
                                                let _e870 = ((1u + _e868) % 7u);
                                                if (_e870 < 7u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e875 = global_8.member[_e856.member_1][_e870];
                                                let _e877 = ((_e868 + 2u) % 7u);
                                                if (_e877 < 7u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e882 = global_8.member[_e856.member_1][_e877];
                                                let _e883 = (_e435 * 2u);
                                                let _e885 = ((1u + _e883) % 7u);
                                                if (_e885 < 7u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e890 = global_8.member[_e856.member_1][_e885];
                                                let _e892 = ((_e883 + 2u) % 7u);
                                                if (_e892 < 7u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e897 = global_8.member[_e856.member_1][_e892];
                                                let _e898 = (_e437 * 2u);
                                                let _e900 = ((1u + _e898) % 7u);
                                                if (_e900 < 7u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e905 = global_8.member[_e856.member_1][_e900];
                                                let _e907 = ((_e898 + 2u) % 7u);
                                                if (_e907 < 7u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e912 = global_8.member[_e856.member_1][_e907];
                                                let _e935 = (bitcast<f32>((bitcast<u32>((_e856.member.member_1.x - _e856.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e936 = (bitcast<f32>((bitcast<u32>((_e856.member.member_1.y - _e856.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e937 = (bitcast<f32>((bitcast<u32>((_e856.member.member_1.z - _e856.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e939 = select(_e162, _e935, (_e935 > _e162));
                                                let _e941 = select(_e162, _e936, (_e936 > _e162));
                                                let _e943 = select(_e162, _e937, (_e937 > _e162));
                                                let _e974 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e875 & 2097151u))) - 8388608f) * _e939));
                                                let _e979 = (bitcast<i32>((_e875 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e982 = bitcast<f32>((_e974 & bitcast<u32>(_e979)));
                                                let _e983 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e890 & 2097151u))) - 8388608f) * _e941));
                                                let _e988 = (bitcast<i32>((_e890 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e991 = bitcast<f32>((_e983 & bitcast<u32>(_e988)));
                                                let _e992 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e905 & 2097151u))) - 8388608f) * _e943));
                                                let _e997 = (bitcast<i32>((_e905 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1000 = bitcast<f32>((_e992 & bitcast<u32>(_e997)));
                                                let _e1004 = bitcast<f32>((_e974 & bitcast<u32>(~(_e979))));
                                                let _e1008 = bitcast<f32>((_e983 & bitcast<u32>(~(_e988))));
                                                let _e1012 = bitcast<f32>((_e992 & bitcast<u32>(~(_e997))));
                                                let _e1013 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e882 & 2097151u))) - 8388608f) * _e939));
                                                let _e1018 = (bitcast<i32>((_e882 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1021 = bitcast<f32>((_e1013 & bitcast<u32>(_e1018)));
                                                let _e1022 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e897 & 2097151u))) - 8388608f) * _e941));
                                                let _e1027 = (bitcast<i32>((_e897 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1030 = bitcast<f32>((_e1022 & bitcast<u32>(_e1027)));
                                                let _e1031 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e912 & 2097151u))) - 8388608f) * _e943));
                                                let _e1036 = (bitcast<i32>((_e912 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1039 = bitcast<f32>((_e1031 & bitcast<u32>(_e1036)));
                                                let _e1043 = bitcast<f32>((_e1013 & bitcast<u32>(~(_e1018))));
                                                let _e1047 = bitcast<f32>((_e1022 & bitcast<u32>(~(_e1027))));
                                                let _e1051 = bitcast<f32>((_e1031 & bitcast<u32>(~(_e1036))));
                                                let _e1052 = (_e856.member.member.x + _e982);
                                                let _e1053 = (_e856.member.member.y + _e991);
                                                let _e1054 = (_e856.member.member.z + _e1000);
                                                let _e1057 = (_e856.member.member_1.x - _e1021);
                                                let _e1058 = (_e856.member.member_1.y - _e1030);
                                                let _e1059 = (_e856.member.member_1.z - _e1039);
                                                let _e1078 = (_e1057 - _e1052);
                                                let _e1079 = (_e1058 - _e1053);
                                                let _e1080 = (_e1059 - _e1054);
                                                let _e1082 = select(_e1079, _e1078, (_e1078 > _e1079));
                                                let _e1084 = select(_e1080, _e1082, (_e1082 > _e1080));
                                                if (_e1084 < (1024f * _e162)) {
                                                    phi_4006_ = 0u;
                                                } else {
                                                    phi_4006_ = select(2u, 1u, (_e1084 < (2097152f * _e162)));
                                                }
                                                let _e1091 = phi_4006_;
                                                switch bitcast<i32>(_e1091) {
                                                    case 0: {
                                                        phi_4012_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_4012_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_4012_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_4012_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1094 = phi_4012_;
                                                let _e1100 = global_8.member[_e856.member_1][0u];
                                                let _e1104 = global_8.member[_e856.member_1][2u];
                                                let _e1108 = global_8.member[_e856.member_1][4u];
                                                let _e1112 = global_8.member[_e856.member_1][6u];
                                                let _e1124 = (((_e1104 >> bitcast<u32>(22i)) | ((_e1108 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1112 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1125 = (_e1100 & 268435455u);
                                                let _e1126 = (_e1124 & 268435455u);
                                                let _e1129 = ((_e1100 >> bitcast<u32>(28u)) & 7u);
                                                let _e1137 = ((_e1100 >> bitcast<u32>(31i)) | (((_e1124 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1138 = (_e1129 != 0u);
                                                if (_e1129 == 0u) {
                                                    phi_4267_ = _e1125;
                                                } else {
                                                    if (_e1129 == 7u) {
                                                        phi_4266_ = 2147483648u;
                                                    } else {
                                                        phi_4266_ = ((2147483648u | (_e1129 << bitcast<u32>(28u))) | (_e1126 & 268435455u));
                                                    }
                                                    let _e1147 = phi_4266_;
                                                    phi_4267_ = _e1147;
                                                }
                                                let _e1149 = phi_4267_;
                                                if _e1138 {
                                                    let _e1150 = (_e1129 != 7u);
                                                    if _e1150 {
                                                        phi_4277_ = (_e1126 + (_e1129 * ((3u * _e1094) + 1u)));
                                                    } else {
                                                        phi_4277_ = u32();
                                                    }
                                                    let _e1154 = phi_4277_;
                                                    phi_4279_ = _e1154;
                                                    phi_4280_ = select(true, false, _e1150);
                                                } else {
                                                    phi_4279_ = u32();
                                                    phi_4280_ = true;
                                                }
                                                let _e1157 = phi_4279_;
                                                let _e1159 = phi_4280_;
                                                if (_e1137 == 0u) {
                                                    phi_4301_ = (_e1125 + select(0u, 1u, !(_e1138)));
                                                } else {
                                                    if (_e1137 == 7u) {
                                                        phi_4300_ = 2147483648u;
                                                    } else {
                                                        phi_4300_ = ((2147483648u | (_e1137 << bitcast<u32>(28u))) | (select(_e1157, _e1126, _e1159) & 268435455u));
                                                    }
                                                    let _e1172 = phi_4300_;
                                                    phi_4301_ = _e1172;
                                                }
                                                let _e1174 = phi_4301_;
                                                phi_4305_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e1052, (_e856.member.member.x + _e1004), _e1057, (_e856.member.member_1.x - _e1043)), vec4<f32>(_e1053, (_e856.member.member.y + _e1008), _e1058, (_e856.member.member_1.y - _e1047)), vec4<f32>(_e1054, (_e856.member.member.z + _e1012), _e1059, (_e856.member.member_1.z - _e1051))), type_58(type_30((_e856.member.member + vec4<f32>(_e982, _e991, _e1000, 0f)), (_e856.member.member_1 - vec4<f32>(_e1021, _e1030, _e1039, 0f))), _e1149), type_58(type_30((_e856.member.member + vec4<f32>(_e1004, _e1008, _e1012, 0f)), (_e856.member.member_1 - vec4<f32>(_e1043, _e1047, _e1051, 0f))), _e1174));
                                            }
                                            let _e1179 = phi_4305_;
                                            let _e1191 = ((_e1179.member[0].x - _e521) * _e526);
                                            let _e1192 = ((_e1179.member[0].y - _e521) * _e526);
                                            let _e1193 = ((_e1179.member[0].z - _e522) * _e526);
                                            let _e1194 = ((_e1179.member[0].w - _e522) * _e526);
                                            let _e1204 = ((_e1179.member[1].x - _e587) * _e592);
                                            let _e1205 = ((_e1179.member[1].y - _e587) * _e592);
                                            let _e1206 = ((_e1179.member[1].z - _e588) * _e592);
                                            let _e1207 = ((_e1179.member[1].w - _e588) * _e592);
                                            let _e1217 = ((_e1179.member[2].x - _e653) * _e658);
                                            let _e1218 = ((_e1179.member[2].y - _e653) * _e658);
                                            let _e1219 = ((_e1179.member[2].z - _e654) * _e658);
                                            let _e1220 = ((_e1179.member[2].w - _e654) * _e658);
                                            let _e1222 = select(_e1219, _e1217, (_e1217 < _e1219));
                                            let _e1224 = select(_e1220, _e1218, (_e1218 < _e1220));
                                            let _e1226 = select(_e1219, _e1217, (_e1217 > _e1219));
                                            let _e1228 = select(_e1220, _e1218, (_e1218 > _e1220));
                                            let _e1230 = select(_e1193, _e1191, (_e1191 < _e1193));
                                            let _e1232 = select(_e1194, _e1192, (_e1192 < _e1194));
                                            let _e1234 = select(_e1206, _e1204, (_e1204 < _e1206));
                                            let _e1236 = select(_e1207, _e1205, (_e1205 < _e1207));
                                            let _e1238 = select(_e1234, _e1230, (_e1230 > _e1234));
                                            let _e1240 = select(_e1236, _e1232, (_e1232 > _e1236));
                                            let _e1242 = select(_e1222, _e1238, (_e1238 > _e1222));
                                            let _e1244 = select(_e1224, _e1240, (_e1240 > _e1224));
                                            let _e1246 = select(_e1193, _e1191, (_e1191 > _e1193));
                                            let _e1248 = select(_e1194, _e1192, (_e1192 > _e1194));
                                            let _e1250 = select(_e1206, _e1204, (_e1204 > _e1206));
                                            let _e1252 = select(_e1207, _e1205, (_e1205 > _e1207));
                                            let _e1254 = select(_e1250, _e1246, (_e1246 < _e1250));
                                            let _e1256 = select(_e1252, _e1248, (_e1248 < _e1252));
                                            let _e1261 = -(_e1222);
                                            let _e1262 = -(_e1224);
                                            let _e1269 = (select(_e1226, _e1254, (_e1254 < _e1226)) + (select(_e1261, _e1226, (_e1226 > _e1261)) * 0.0000019073523f));
                                            let _e1270 = (select(_e1228, _e1256, (_e1256 < _e1228)) + (select(_e1262, _e1228, (_e1228 > _e1262)) * 0.0000019073523f));
                                            let _e1272 = select(_e769, _e1242, (_e1242 > _e769));
                                            let _e1274 = select(_e769, _e1244, (_e1244 > _e769));
                                            let _e1279 = (_e1272 <= select(_e813.member, _e1269, (_e1269 < _e813.member)));
                                            let _e1280 = (_e1274 <= select(_e813.member, _e1270, (_e1270 < _e813.member)));
                                            let _e1281 = (_e1272 <= _e1274);
                                            if _e1279 {
                                                if _e1280 {
                                                    if _e1281 {
                                                        phi_4667_ = _e1179.member_2;
                                                    } else {
                                                        phi_4667_ = _e1179.member_1;
                                                    }
                                                    let _e1285 = phi_4667_;
                                                    let _e1307 = (_e854 % 128u);
                                                    let _e1308 = (_e1307 < 128u);
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1307] = _e1285.member_1;
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1307] = _e1285.member.member.x;
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1307] = _e1285.member.member.y;
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1307] = _e1285.member.member.z;
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1307] = _e1285.member.member_1.x;
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1307] = _e1285.member.member_1.y;
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1307] = _e1285.member.member_1.z;
                                                    if _e1308 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1307] = select(_e1274, _e1272, !(_e1281));
                                                    if _e1281 {
                                                        phi_4744_ = _e1179.member_1;
                                                    } else {
                                                        phi_4744_ = _e1179.member_2;
                                                    }
                                                    let _e1321 = phi_4744_;
                                                    phi_4745_ = (_e854 + 1u);
                                                    phi_4746_ = _e1321;
                                                } else {
                                                    phi_4745_ = u32();
                                                    phi_4746_ = type_58();
                                                }
                                                let _e1323 = phi_4745_;
                                                let _e1325 = phi_4746_;
                                                phi_4748_ = _e1323;
                                                phi_4749_ = _e1325;
                                                phi_4750_ = select(true, false, _e1280);
                                            } else {
                                                phi_4748_ = u32();
                                                phi_4749_ = type_58();
                                                phi_4750_ = true;
                                            }
                                            let _e1328 = phi_4748_;
                                            let _e1330 = phi_4749_;
                                            let _e1332 = phi_4750_;
                                            if _e1332 {
                                                if _e1279 {
                                                    phi_4759_ = _e1179.member_1;
                                                } else {
                                                    phi_4759_ = _e1179.member_2;
                                                }
                                                let _e1336 = phi_4759_;
                                                phi_4764_ = select(_e1280, true, _e1279);
                                                phi_4766_ = _e1336;
                                            } else {
                                                phi_4764_ = _e852;
                                                phi_4766_ = _e1330;
                                            }
                                            let _e1339 = phi_4764_;
                                            let _e1341 = phi_4766_;
                                            phi_5279_ = _e811;
                                            phi_4770_ = _e813;
                                            phi_4771_ = _e1339;
                                            phi_4772_ = select(_e1328, _e854, _e1332);
                                            phi_4773_ = _e1341;
                                        }
                                        let _e2501 = phi_5279_;
                                        let _e2503 = phi_4770_;
                                        let _e2505 = phi_4771_;
                                        let _e2507 = phi_4772_;
                                        let _e2509 = phi_4773_;
                                        phi_5278_ = _e2501;
                                        phi_4774_ = _e2503;
                                        phi_4775_ = _e2505;
                                        phi_4776_ = (_e817 - 1u);
                                        phi_4777_ = _e2507;
                                        phi_4778_ = _e2509;
                                    } else {
                                        phi_5278_ = _e811;
                                        phi_4774_ = _e813;
                                        phi_4775_ = _e852;
                                        phi_4776_ = _e817;
                                        phi_4777_ = _e854;
                                        phi_4778_ = _e856;
                                    }
                                    let _e2511 = phi_5278_;
                                    let _e2513 = phi_4774_;
                                    let _e2515 = phi_4775_;
                                    let _e2517 = phi_4776_;
                                    let _e2519 = phi_4777_;
                                    let _e2521 = phi_4778_;
                                    phi_5277_ = _e2511;
                                    phi_4779_ = _e2513;
                                    phi_4780_ = _e2515;
                                    phi_4781_ = _e2517;
                                    phi_4782_ = _e2519;
                                    phi_4783_ = _e2521;
                                } else {
                                    phi_5277_ = _e811;
                                    phi_4779_ = type_42();
                                    phi_4780_ = bool();
                                    phi_4781_ = u32();
                                    phi_4782_ = u32();
                                    phi_4783_ = type_58();
                                }
                                let _e2523 = phi_5277_;
                                let _e2525 = phi_4779_;
                                let _e2527 = phi_4780_;
                                let _e2529 = phi_4781_;
                                let _e2531 = phi_4782_;
                                let _e2533 = phi_4783_;
                                phi_5276_ = _e2523;
                                phi_1367_ = _e2525;
                                phi_1370_ = _e2527;
                                phi_1372_ = _e2529;
                                phi_1374_ = _e2531;
                                phi_1376_ = _e2533;
                                phi_4784_ = _e825;
                            } else {
                                phi_5276_ = _e811;
                                phi_1367_ = type_42();
                                phi_1370_ = bool();
                                phi_1372_ = u32();
                                phi_1374_ = u32();
                                phi_1376_ = type_58();
                                phi_4784_ = false;
                            }
                            let _e2535 = phi_5276_;
                            let _e2537 = phi_1367_;
                            let _e2539 = phi_1370_;
                            let _e2541 = phi_1372_;
                            let _e2543 = phi_1374_;
                            let _e2545 = phi_1376_;
                            let _e2547 = phi_4784_;
                            continue;
                            continuing {
                                phi_5042_ = _e2535;
                                phi_1366_ = _e2537;
                                phi_1369_ = _e2539;
                                phi_1371_ = _e2541;
                                phi_1373_ = _e2543;
                                phi_1375_ = _e2545;
                                phi_5275_ = _e2535;
                                break if !(_e2547);
                            }
                        }
                        let _e2550 = phi_5275_;
                        if _e2550 {
                            break;
                        }
                        let _e2552 = local_11;
                        if _e2552.member_1 {
                        } else {
                            if _e304 {
                            } else {
                                break;
                            }
                            let _e2556 = global_2.member[_e150];
                            if _e165 {
                            } else {
                                break;
                            }
                            let _e2560 = global_9.member[_e150].member_1;
                            if _e304 {
                            } else {
                                break;
                            }
                            global_2.member[_e150] = type_23(_e2556.member, _e2556.member_1, _e2556.member_2, array<f32, 3>((_e2556.member_3[0] + (_e2560[0] * _e2556.member_1[0])), (_e2556.member_3[1] + (_e2560[1] * _e2556.member_1[1])), (_e2556.member_3[2] + (_e2560[2] * _e2556.member_1[2]))), _e2556.member_4);
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
fn trace_shadows_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
