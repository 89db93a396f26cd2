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
    var phi_5045_: bool;
    var phi_1366_: type_42;
    var phi_1369_: u32;
    var phi_1371_: bool;
    var phi_1373_: u32;
    var phi_1375_: type_58;
    var phi_1386_: bool;
    var phi_1472_: bool;
    var phi_1473_: u32;
    var phi_1474_: type_58;
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
    var phi_5039_: bool;
    var phi_5369_: bool;
    var phi_3498_: type_42;
    var phi_4000_: u32;
    var phi_4006_: u32;
    var phi_4260_: u32;
    var phi_4261_: u32;
    var phi_4271_: u32;
    var phi_4273_: u32;
    var phi_4274_: bool;
    var phi_4294_: u32;
    var phi_4295_: u32;
    var phi_4299_: type_59;
    var phi_4661_: type_58;
    var phi_4737_: type_58;
    var phi_4738_: u32;
    var phi_4739_: type_58;
    var phi_4741_: u32;
    var phi_4742_: type_58;
    var phi_4743_: bool;
    var phi_4752_: type_58;
    var phi_4757_: bool;
    var phi_4759_: type_58;
    var phi_4763_: bool;
    var phi_4764_: u32;
    var phi_4765_: type_58;
    var phi_4775_: u32;
    var phi_4776_: type_58;
    var phi_5281_: bool;
    var phi_4777_: type_42;
    var phi_4778_: u32;
    var phi_4779_: bool;
    var phi_4780_: u32;
    var phi_4781_: type_58;
    var phi_5280_: bool;
    var phi_4782_: type_42;
    var phi_4783_: u32;
    var phi_4784_: bool;
    var phi_4785_: u32;
    var phi_4786_: type_58;
    var phi_5279_: bool;
    var phi_1367_: type_42;
    var phi_1370_: u32;
    var phi_1372_: bool;
    var phi_1374_: u32;
    var phi_1376_: type_58;
    var phi_4787_: bool;
    var phi_5278_: bool;
    var local_10: type_42;
    var local_11: type_42;

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
                        phi_5045_ = false;
                        phi_1366_ = type_42(_e767, false);
                        phi_1369_ = ((3u * _e103) + 1u);
                        phi_1371_ = (_e769 <= _e767);
                        phi_1373_ = 0u;
                        phi_1375_ = type_58(type_30(vec4<f32>((f32(_e776) * _e162), (f32(_e782) * _e162), (f32(_e788) * _e162), 0f), vec4<f32>((f32(_e793) * _e162), (f32(_e797) * _e162), (f32(_e801) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                        loop {
                            let _e811 = phi_5045_;
                            let _e813 = phi_1366_;
                            let _e815 = phi_1369_;
                            let _e817 = phi_1371_;
                            let _e819 = phi_1373_;
                            let _e821 = phi_1375_;
                            local_10 = _e813;
                            if _e817 {
                                phi_1386_ = true;
                            } else {
                                phi_1386_ = (_e819 > 0u);
                            }
                            let _e824 = phi_1386_;
                            if _e824 {
                                let _e825 = (_e815 > 0u);
                                if _e825 {
                                    if _e817 {
                                        phi_1472_ = _e817;
                                        phi_1473_ = _e819;
                                        phi_1474_ = _e821;
                                    } else {
                                        let _e826 = (_e819 - 1u);
                                        let _e827 = (_e826 % 128u);
                                        let _e828 = (_e827 < 128u);
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e830 = local_7[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e832 = local_6[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e834 = local_5[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e836 = local_4[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e838 = local_3[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e840 = local_2[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e845 = local_8[_e827];
                                        if _e828 {
                                        } else {
                                            phi_5278_ = true;
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
                                        let _e860 = ((_e856.member_1 & 2147483648u) != 0u);
                                        let _e861 = (_e856.member_1 & 268435455u);
                                        if _e860 {
                                            phi_1493_ = _e813;
                                            phi_1496_ = type_8(0u, ((_e856.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e868 = phi_1493_;
                                                let _e870 = phi_1496_;
                                                local_11 = _e868;
                                                if (_e870.member < _e870.member_1) {
                                                    phi_1497_ = type_8((_e870.member + 1u), _e870.member_1);
                                                    phi_1519_ = type_8(1u, _e870.member);
                                                } else {
                                                    phi_1497_ = _e870;
                                                    phi_1519_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e883 = phi_1497_;
                                                let _e885 = phi_1519_;
                                                let _e889 = (bitcast<i32>(_e885.member) != 0i);
                                                if _e889 {
                                                    let _e894 = (_e856.member.member_1.x - _e856.member.member.x);
                                                    let _e897 = (_e856.member.member_1.y - _e856.member.member.y);
                                                    let _e900 = (_e856.member.member_1.z - _e856.member.member.z);
                                                    let _e902 = select(_e897, _e894, (_e894 > _e897));
                                                    let _e904 = select(_e900, _e902, (_e902 > _e900));
                                                    let _e906 = (_e904 < (1024f * _e162));
                                                    if _e906 {
                                                        phi_1560_ = 0u;
                                                    } else {
                                                        phi_1560_ = select(2u, 1u, (_e904 < (2097152f * _e162)));
                                                    }
                                                    let _e911 = phi_1560_;
                                                    switch bitcast<i32>(_e911) {
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
                                                    let _e914 = phi_1566_;
                                                    switch bitcast<i32>(_e911) {
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
                                                    let _e921 = phi_1576_;
                                                    let _e923 = ((_e861 + (_e885.member_1 * ((3u * _e914) + 1u))) + (3u * _e921));
                                                    let _e924 = (_e923 < _e106);
                                                    if _e924 {
                                                        if _e924 {
                                                        } else {
                                                            phi_5039_ = true;
                                                            break;
                                                        }
                                                        let _e926 = global_10.member[_e923];
                                                        phi_1592_ = _e926;
                                                    } else {
                                                        phi_1592_ = 4294967295u;
                                                    }
                                                    let _e928 = phi_1592_;
                                                    if _e906 {
                                                        phi_1625_ = 0u;
                                                    } else {
                                                        phi_1625_ = select(2u, 1u, (_e904 < (2097152f * _e162)));
                                                    }
                                                    let _e933 = phi_1625_;
                                                    switch bitcast<i32>(_e933) {
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
                                                    let _e936 = phi_1631_;
                                                    let _e940 = (_e861 + (_e885.member_1 * ((3u * _e936) + 1u)));
                                                    switch bitcast<i32>(_e933) {
                                                        case 0: {
                                                            let _e1215 = (_e940 < _e106);
                                                            if _e1215 {
                                                                if _e1215 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1217 = global_10.member[_e940];
                                                                phi_1658_ = _e1217;
                                                            } else {
                                                                phi_1658_ = 0u;
                                                            }
                                                            let _e1219 = phi_1658_;
                                                            let _e1221 = ((10u * _e436) & 31u);
                                                            let _e1231 = ((10u * _e435) & 31u);
                                                            let _e1241 = ((10u * _e437) & 31u);
                                                            let _e1251 = (_e940 + 1u);
                                                            let _e1252 = (_e1251 < _e106);
                                                            if _e1252 {
                                                                if _e1252 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1254 = global_10.member[_e1251];
                                                                phi_1707_ = _e1254;
                                                            } else {
                                                                phi_1707_ = 0u;
                                                            }
                                                            let _e1256 = phi_1707_;
                                                            let _e1282 = (_e940 + 2u);
                                                            let _e1283 = (_e1282 < _e106);
                                                            if _e1283 {
                                                                if _e1283 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1285 = global_10.member[_e1282];
                                                                phi_1756_ = _e1285;
                                                            } else {
                                                                phi_1756_ = 0u;
                                                            }
                                                            let _e1287 = phi_1756_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | ((_e1219 >> bitcast<u32>(_e1221)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | ((_e1219 >> bitcast<u32>(_e1231)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | ((_e1219 >> bitcast<u32>(_e1241)) & 1023u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | ((_e1256 >> bitcast<u32>(_e1221)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | ((_e1256 >> bitcast<u32>(_e1231)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | ((_e1256 >> bitcast<u32>(_e1241)) & 1023u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | ((_e1287 >> bitcast<u32>(_e1221)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | ((_e1287 >> bitcast<u32>(_e1231)) & 1023u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | ((_e1287 >> bitcast<u32>(_e1241)) & 1023u))) - 8388608f) * _e162))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1029 = (_e940 < _e106);
                                                            if _e1029 {
                                                                if _e1029 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1031 = global_10.member[_e940];
                                                                phi_1805_ = _e1031;
                                                            } else {
                                                                phi_1805_ = 0u;
                                                            }
                                                            let _e1033 = phi_1805_;
                                                            let _e1034 = (_e940 + 1u);
                                                            let _e1035 = (_e1034 < _e106);
                                                            if _e1035 {
                                                                if _e1035 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1037 = global_10.member[_e1034];
                                                                phi_1820_ = _e1037;
                                                            } else {
                                                                phi_1820_ = 0u;
                                                            }
                                                            let _e1039 = phi_1820_;
                                                            let _e1040 = (_e436 == 1u);
                                                            if _e1040 {
                                                                phi_1830_ = ((_e1033 >> bitcast<u32>(21i)) | (_e1039 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1830_ = (_e1039 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1049 = phi_1830_;
                                                            let _e1057 = (_e435 == 1u);
                                                            if _e1057 {
                                                                phi_1851_ = ((_e1033 >> bitcast<u32>(21i)) | (_e1039 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1851_ = (_e1039 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1066 = phi_1851_;
                                                            let _e1074 = (_e437 == 1u);
                                                            if _e1074 {
                                                                phi_1872_ = ((_e1033 >> bitcast<u32>(21i)) | (_e1039 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1872_ = (_e1039 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1083 = phi_1872_;
                                                            let _e1092 = (_e940 + 2u);
                                                            let _e1093 = (_e1092 < _e106);
                                                            if _e1093 {
                                                                if _e1093 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1095 = global_10.member[_e1092];
                                                                phi_1902_ = _e1095;
                                                            } else {
                                                                phi_1902_ = 0u;
                                                            }
                                                            let _e1097 = phi_1902_;
                                                            let _e1098 = (_e940 + 3u);
                                                            let _e1099 = (_e1098 < _e106);
                                                            if _e1099 {
                                                                if _e1099 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1101 = global_10.member[_e1098];
                                                                phi_1917_ = _e1101;
                                                            } else {
                                                                phi_1917_ = 0u;
                                                            }
                                                            let _e1103 = phi_1917_;
                                                            if _e1040 {
                                                                phi_1927_ = ((_e1097 >> bitcast<u32>(21i)) | (_e1103 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1927_ = (_e1103 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1112 = phi_1927_;
                                                            if _e1057 {
                                                                phi_1948_ = ((_e1097 >> bitcast<u32>(21i)) | (_e1103 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1948_ = (_e1103 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1128 = phi_1948_;
                                                            if _e1074 {
                                                                phi_1969_ = ((_e1097 >> bitcast<u32>(21i)) | (_e1103 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1969_ = (_e1103 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1144 = phi_1969_;
                                                            let _e1153 = (_e940 + 4u);
                                                            let _e1154 = (_e1153 < _e106);
                                                            if _e1154 {
                                                                if _e1154 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1156 = global_10.member[_e1153];
                                                                phi_1999_ = _e1156;
                                                            } else {
                                                                phi_1999_ = 0u;
                                                            }
                                                            let _e1158 = phi_1999_;
                                                            let _e1159 = (_e940 + 5u);
                                                            let _e1160 = (_e1159 < _e106);
                                                            if _e1160 {
                                                                if _e1160 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1162 = global_10.member[_e1159];
                                                                phi_2014_ = _e1162;
                                                            } else {
                                                                phi_2014_ = 0u;
                                                            }
                                                            let _e1164 = phi_2014_;
                                                            if _e1040 {
                                                                phi_2024_ = ((_e1158 >> bitcast<u32>(21i)) | (_e1164 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2024_ = (_e1164 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1173 = phi_2024_;
                                                            if _e1057 {
                                                                phi_2045_ = ((_e1158 >> bitcast<u32>(21i)) | (_e1164 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2045_ = (_e1164 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1189 = phi_2045_;
                                                            if _e1074 {
                                                                phi_2066_ = ((_e1158 >> bitcast<u32>(21i)) | (_e1164 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2066_ = (_e1164 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1205 = phi_2066_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1049, _e1033, _e460) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1066, _e1033, _e527) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1083, _e1033, _e593) & 2097151u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1112, _e1097, _e460) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1128, _e1097, _e527) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1144, _e1097, _e593) & 2097151u))) - 8388608f) * _e162))), array<f32, 3>((_e856.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1173, _e1158, _e460) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1189, _e1158, _e527) & 2097151u))) - 8388608f) * _e162)), (_e856.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1205, _e1158, _e593) & 2097151u))) - 8388608f) * _e162))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e942 = (_e940 + _e436);
                                                            let _e943 = (_e942 < _e106);
                                                            if _e943 {
                                                                if _e943 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e945 = global_10.member[_e942];
                                                                phi_2097_ = _e945;
                                                            } else {
                                                                phi_2097_ = 0u;
                                                            }
                                                            let _e947 = phi_2097_;
                                                            let _e951 = (_e940 + _e435);
                                                            let _e952 = (_e951 < _e106);
                                                            if _e952 {
                                                                if _e952 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e954 = global_10.member[_e951];
                                                                phi_2115_ = _e954;
                                                            } else {
                                                                phi_2115_ = 0u;
                                                            }
                                                            let _e956 = phi_2115_;
                                                            let _e960 = (_e940 + _e437);
                                                            let _e961 = (_e960 < _e106);
                                                            if _e961 {
                                                                if _e961 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e963 = global_10.member[_e960];
                                                                phi_2133_ = _e963;
                                                            } else {
                                                                phi_2133_ = 0u;
                                                            }
                                                            let _e965 = phi_2133_;
                                                            let _e970 = (_e940 + 3u);
                                                            let _e971 = (_e970 + _e436);
                                                            let _e972 = (_e971 < _e106);
                                                            if _e972 {
                                                                if _e972 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e974 = global_10.member[_e971];
                                                                phi_2156_ = _e974;
                                                            } else {
                                                                phi_2156_ = 0u;
                                                            }
                                                            let _e976 = phi_2156_;
                                                            let _e980 = (_e970 + _e435);
                                                            let _e981 = (_e980 < _e106);
                                                            if _e981 {
                                                                if _e981 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e983 = global_10.member[_e980];
                                                                phi_2174_ = _e983;
                                                            } else {
                                                                phi_2174_ = 0u;
                                                            }
                                                            let _e985 = phi_2174_;
                                                            let _e989 = (_e970 + _e437);
                                                            let _e990 = (_e989 < _e106);
                                                            if _e990 {
                                                                if _e990 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e992 = global_10.member[_e989];
                                                                phi_2192_ = _e992;
                                                            } else {
                                                                phi_2192_ = 0u;
                                                            }
                                                            let _e994 = phi_2192_;
                                                            let _e999 = (_e940 + 6u);
                                                            let _e1000 = (_e999 + _e436);
                                                            let _e1001 = (_e1000 < _e106);
                                                            if _e1001 {
                                                                if _e1001 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1003 = global_10.member[_e1000];
                                                                phi_2215_ = _e1003;
                                                            } else {
                                                                phi_2215_ = 0u;
                                                            }
                                                            let _e1005 = phi_2215_;
                                                            let _e1009 = (_e999 + _e435);
                                                            let _e1010 = (_e1009 < _e106);
                                                            if _e1010 {
                                                                if _e1010 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1012 = global_10.member[_e1009];
                                                                phi_2233_ = _e1012;
                                                            } else {
                                                                phi_2233_ = 0u;
                                                            }
                                                            let _e1014 = phi_2233_;
                                                            let _e1018 = (_e999 + _e437);
                                                            let _e1019 = (_e1018 < _e106);
                                                            if _e1019 {
                                                                if _e1019 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1021 = global_10.member[_e1018];
                                                                phi_2251_ = _e1021;
                                                            } else {
                                                                phi_2251_ = 0u;
                                                            }
                                                            let _e1023 = phi_2251_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e947)) * _e162), (f32(bitcast<i32>(_e956)) * _e162), (f32(bitcast<i32>(_e965)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e976)) * _e162), (f32(bitcast<i32>(_e985)) * _e162), (f32(bitcast<i32>(_e994)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1005)) * _e162), (f32(bitcast<i32>(_e1014)) * _e162), (f32(bitcast<i32>(_e1023)) * _e162)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2257_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1315 = phi_2257_;
                                                    let _e1323 = (_e1315[0][2] - _e616);
                                                    let _e1326 = (((_e1315[0][0] - _e483) * _e655) - (_e1323 * _e523));
                                                    let _e1329 = (((_e1315[0][1] - _e550) * _e655) - (_e1323 * _e589));
                                                    let _e1336 = (_e1315[1][2] - _e616);
                                                    let _e1339 = (((_e1315[1][0] - _e483) * _e655) - (_e1336 * _e523));
                                                    let _e1342 = (((_e1315[1][1] - _e550) * _e655) - (_e1336 * _e589));
                                                    let _e1349 = (_e1315[2][2] - _e616);
                                                    let _e1352 = (((_e1315[2][0] - _e483) * _e655) - (_e1349 * _e523));
                                                    let _e1355 = (((_e1315[2][1] - _e550) * _e655) - (_e1349 * _e589));
                                                    let _e1356 = (_e1352 * _e1342);
                                                    let _e1357 = (_e1355 * _e1339);
                                                    let _e1358 = (_e1326 * _e1355);
                                                    let _e1359 = (_e1329 * _e1352);
                                                    let _e1360 = (_e1339 * _e1329);
                                                    let _e1361 = (_e1342 * _e1326);
                                                    let _e1366 = (((_e1356 >= _e1357) && (_e1358 >= _e1359)) && (_e1360 >= _e1361));
                                                    if (_e1366 || (((_e1356 <= _e1357) && (_e1358 <= _e1359)) && (_e1360 <= _e1361))) {
                                                        let _e1373 = select(-1f, 1f, _e1366);
                                                        let _e1375 = ((_e1356 - _e1357) * _e1373);
                                                        let _e1377 = select(0f, _e1375, (_e1375 > 0f));
                                                        let _e1379 = ((_e1358 - _e1359) * _e1373);
                                                        let _e1381 = select(0f, _e1379, (_e1379 > 0f));
                                                        let _e1383 = ((_e1360 - _e1361) * _e1373);
                                                        let _e1385 = select(0f, _e1383, (_e1383 > 0f));
                                                        let _e1387 = ((_e1377 + _e1381) + _e1385);
                                                        if (_e1387 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3141_ = type_21();
                                                            phi_3142_ = true;
                                                            phi_3143_ = false;
                                                        } else {
                                                            let _e1390 = select(_e1339, _e1326, (_e1326 < _e1339));
                                                            if (select(_e1352, _e1390, (_e1390 < _e1352)) > 0f) {
                                                                phi_2409_ = true;
                                                            } else {
                                                                let _e1395 = select(_e1339, _e1326, (_e1326 > _e1339));
                                                                phi_2409_ = (select(_e1352, _e1395, (_e1395 > _e1352)) < 0f);
                                                            }
                                                            let _e1400 = phi_2409_;
                                                            if _e1400 {
                                                                phi_3138_ = type_21();
                                                                phi_3139_ = true;
                                                                phi_3140_ = false;
                                                            } else {
                                                                let _e1402 = select(_e1342, _e1329, (_e1329 < _e1342));
                                                                if (select(_e1355, _e1402, (_e1402 < _e1355)) > 0f) {
                                                                    phi_2438_ = true;
                                                                } else {
                                                                    let _e1407 = select(_e1342, _e1329, (_e1329 > _e1342));
                                                                    phi_2438_ = (select(_e1355, _e1407, (_e1407 > _e1355)) < 0f);
                                                                }
                                                                let _e1412 = phi_2438_;
                                                                if _e1412 {
                                                                    phi_3136_ = type_21();
                                                                    phi_3137_ = false;
                                                                } else {
                                                                    let _e1414 = select(_e1315[1][0], _e1315[0][0], (_e1315[0][0] < _e1315[1][0]));
                                                                    let _e1418 = select(_e1315[1][0], _e1315[0][0], (_e1315[0][0] > _e1315[1][0]));
                                                                    let _e1422 = select(_e1315[1][1], _e1315[0][1], (_e1315[0][1] < _e1315[1][1]));
                                                                    let _e1426 = select(_e1315[1][1], _e1315[0][1], (_e1315[0][1] > _e1315[1][1]));
                                                                    let _e1430 = select(_e1315[1][2], _e1315[0][2], (_e1315[0][2] < _e1315[1][2]));
                                                                    let _e1434 = select(_e1315[1][2], _e1315[0][2], (_e1315[0][2] > _e1315[1][2]));
                                                                    let _e1439 = ((select(_e1315[2][0], _e1414, (_e1414 < _e1315[2][0])) - _e521) * _e526);
                                                                    let _e1440 = ((select(_e1315[2][0], _e1418, (_e1418 > _e1315[2][0])) - _e522) * _e526);
                                                                    let _e1443 = ((select(_e1315[2][1], _e1422, (_e1422 < _e1315[2][1])) - _e587) * _e592);
                                                                    let _e1444 = ((select(_e1315[2][1], _e1426, (_e1426 > _e1315[2][1])) - _e588) * _e592);
                                                                    let _e1447 = ((select(_e1315[2][2], _e1430, (_e1430 < _e1315[2][2])) - _e653) * _e658);
                                                                    let _e1448 = ((select(_e1315[2][2], _e1434, (_e1434 > _e1315[2][2])) - _e654) * _e658);
                                                                    let _e1450 = select(_e1448, _e1447, (_e1447 < _e1448));
                                                                    let _e1452 = select(_e1448, _e1447, (_e1447 > _e1448));
                                                                    let _e1454 = select(_e1440, _e1439, (_e1439 < _e1440));
                                                                    let _e1456 = select(_e1444, _e1443, (_e1443 < _e1444));
                                                                    let _e1458 = select(_e1456, _e1454, (_e1454 > _e1456));
                                                                    let _e1460 = select(_e1450, _e1458, (_e1458 > _e1450));
                                                                    let _e1462 = select(_e1440, _e1439, (_e1439 > _e1440));
                                                                    let _e1464 = select(_e1444, _e1443, (_e1443 > _e1444));
                                                                    let _e1466 = select(_e1464, _e1462, (_e1462 < _e1464));
                                                                    let _e1468 = select(_e1452, _e1466, (_e1466 < _e1452));
                                                                    let _e1469 = -(_e1450);
                                                                    let _e1475 = select(_e769, _e1460, (_e1460 > _e769));
                                                                    if (_e1475 > (_e1468 + (select(_e1469, _e1452, (_e1452 > _e1469)) * 0.0000019073523f))) {
                                                                        phi_3131_ = type_21();
                                                                        phi_3132_ = true;
                                                                    } else {
                                                                        let _e1477 = (_e1475 > _e868.member);
                                                                        if _e1477 {
                                                                            phi_3130_ = type_21();
                                                                        } else {
                                                                            let _e1478 = vec3<f32>(_e1315[0][0], _e1315[0][1], _e1315[0][2]);
                                                                            let _e1479 = vec3<f32>(_e1315[1][0], _e1315[1][1], _e1315[1][2]);
                                                                            let _e1480 = vec3<f32>(_e1315[2][0], _e1315[2][1], _e1315[2][2]);
                                                                            let _e1481 = (_e1315[1][0] - _e1315[0][0]);
                                                                            let _e1482 = (_e1315[1][1] - _e1315[0][1]);
                                                                            let _e1483 = (_e1315[1][2] - _e1315[0][2]);
                                                                            let _e1484 = vec3<f32>(_e1481, _e1482, _e1483);
                                                                            let _e1485 = (_e1315[2][0] - _e1315[1][0]);
                                                                            let _e1486 = (_e1315[2][1] - _e1315[1][1]);
                                                                            let _e1487 = (_e1315[2][2] - _e1315[1][2]);
                                                                            let _e1488 = vec3<f32>(_e1485, _e1486, _e1487);
                                                                            let _e1489 = (_e1315[0][0] - _e1315[2][0]);
                                                                            let _e1490 = (_e1315[0][1] - _e1315[2][1]);
                                                                            let _e1491 = (_e1315[0][2] - _e1315[2][2]);
                                                                            let _e1492 = vec3<f32>(_e1489, _e1490, _e1491);
                                                                            let _e1495 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                            let _e1498 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                                            let _e1500 = select(_e1498, _e1495, (_e1495 > _e1498));
                                                                            let _e1503 = bitcast<f32>((bitcast<u32>(_e1483) & 2147483647u));
                                                                            let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                            let _e1508 = bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u));
                                                                            let _e1511 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                                            let _e1513 = select(_e1511, _e1508, (_e1508 > _e1511));
                                                                            let _e1516 = bitcast<f32>((bitcast<u32>(_e1487) & 2147483647u));
                                                                            let _e1518 = select(_e1516, _e1513, (_e1513 > _e1516));
                                                                            let _e1521 = bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u));
                                                                            let _e1524 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                            let _e1526 = select(_e1524, _e1521, (_e1521 > _e1524));
                                                                            let _e1529 = bitcast<f32>((bitcast<u32>(_e1491) & 2147483647u));
                                                                            let _e1531 = select(_e1529, _e1526, (_e1526 > _e1529));
                                                                            let _e1533 = select(_e1518, _e1505, (_e1505 > _e1518));
                                                                            let _e1535 = select(_e1531, _e1533, (_e1533 > _e1531));
                                                                            if (_e1505 == _e1535) {
                                                                                phi_2857_ = _e1342;
                                                                                phi_2858_ = _e1339;
                                                                                phi_2859_ = _e1329;
                                                                                phi_2860_ = _e1326;
                                                                                phi_2861_ = _e1478;
                                                                                phi_2862_ = _e1492;
                                                                                phi_2863_ = _e1488;
                                                                                phi_2864_ = _e1484;
                                                                            } else {
                                                                                let _e1537 = (_e1518 == _e1535);
                                                                                let _e1542 = vec3(_e1537);
                                                                                phi_2857_ = select(_e1329, _e1355, _e1537);
                                                                                phi_2858_ = select(_e1326, _e1352, _e1537);
                                                                                phi_2859_ = select(_e1355, _e1342, _e1537);
                                                                                phi_2860_ = select(_e1352, _e1339, _e1537);
                                                                                phi_2861_ = select(_e1480, _e1479, _e1542);
                                                                                phi_2862_ = select(_e1488, _e1484, _e1542);
                                                                                phi_2863_ = select(_e1484, _e1492, _e1542);
                                                                                phi_2864_ = select(_e1492, _e1488, _e1542);
                                                                            }
                                                                            let _e1548 = phi_2857_;
                                                                            let _e1550 = phi_2858_;
                                                                            let _e1552 = phi_2859_;
                                                                            let _e1554 = phi_2860_;
                                                                            let _e1556 = phi_2861_;
                                                                            let _e1558 = phi_2862_;
                                                                            let _e1560 = phi_2863_;
                                                                            let _e1562 = phi_2864_;
                                                                            let _e1569 = ((_e1560.y * _e1558.z) - (_e1558.y * _e1560.z));
                                                                            let _e1574 = ((_e1560.z * _e1558.x) - (_e1558.z * _e1560.x));
                                                                            let _e1577 = ((_e1560.x * _e1558.y) - (_e1558.x * _e1560.y));
                                                                            if (_e1377 >= _e1381) {
                                                                                phi_2901_ = select(true, false, (_e1377 >= _e1385));
                                                                            } else {
                                                                                phi_2901_ = true;
                                                                            }
                                                                            let _e1582 = phi_2901_;
                                                                            if _e1582 {
                                                                                phi_2910_ = select(_e1480, _e1479, vec3((_e1381 >= _e1385)));
                                                                            } else {
                                                                                phi_2910_ = _e1478;
                                                                            }
                                                                            let _e1587 = phi_2910_;
                                                                            let _e1598 = (((_e1569 * (_e1587.x - _e483)) + (_e1574 * (_e1587.y - _e550))) + (_e1577 * (_e1587.z - _e616)));
                                                                            let _e1603 = (((_e1569 * _e523) + (_e1574 * _e589)) + (_e1577 * _e655));
                                                                            let _e1604 = (_e1550 - _e1554);
                                                                            let _e1605 = (_e1548 - _e1552);
                                                                            let _e1613 = (-(((_e1554 * _e1604) + (_e1552 * _e1605))) / ((_e1604 * _e1604) + (_e1605 * _e1605)));
                                                                            let _e1615 = select(1f, _e1613, (_e1613 < 1f));
                                                                            let _e1617 = select(0f, _e1615, (_e1615 > 0f));
                                                                            let _e1630 = ((_e1556.x + (_e1562.x * _e1617)) - _e483);
                                                                            let _e1631 = ((_e1556.y + (_e1562.y * _e1617)) - _e550);
                                                                            let _e1632 = ((_e1556.z + (_e1562.z * _e1617)) - _e616);
                                                                            let _e1633 = (_e1632 / _e655);
                                                                            let _e1645 = bitcast<f32>((bitcast<u32>(_e1630) & 2147483647u));
                                                                            let _e1648 = bitcast<f32>((bitcast<u32>(_e1631) & 2147483647u));
                                                                            let _e1650 = select(_e1648, _e1645, (_e1645 > _e1648));
                                                                            let _e1653 = bitcast<f32>((bitcast<u32>(_e1632) & 2147483647u));
                                                                            let _e1655 = select(_e1653, _e1650, (_e1650 > _e1653));
                                                                            let _e1661 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                            let _e1664 = bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u));
                                                                            let _e1666 = select(_e1664, _e1661, (_e1661 > _e1664));
                                                                            let _e1669 = bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1569 * _e1630) + (_e1574 * _e1631)) + (_e1577 * _e1632)) - _e1598)) & 2147483647u)) <= ((0.0000009536743f * select(_e1535, _e1655, (_e1655 > _e1535))) * select(_e1669, _e1666, (_e1666 > _e1669)))) {
                                                                                let _e1679 = bitcast<f32>((bitcast<u32>(_e1560.x) & 2147483647u));
                                                                                let _e1682 = bitcast<f32>((bitcast<u32>(_e1560.y) & 2147483647u));
                                                                                let _e1684 = select(_e1682, _e1679, (_e1679 > _e1682));
                                                                                let _e1687 = bitcast<f32>((bitcast<u32>(_e1560.z) & 2147483647u));
                                                                                let _e1693 = bitcast<f32>((bitcast<u32>(_e1558.x) & 2147483647u));
                                                                                let _e1696 = bitcast<f32>((bitcast<u32>(_e1558.y) & 2147483647u));
                                                                                let _e1698 = select(_e1696, _e1693, (_e1693 > _e1696));
                                                                                let _e1701 = bitcast<f32>((bitcast<u32>(_e1558.z) & 2147483647u));
                                                                                let _e1705 = (bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u)) > ((0.0000038146973f * select(_e1687, _e1684, (_e1684 > _e1687))) * select(_e1701, _e1698, (_e1698 > _e1701))));
                                                                                if _e1705 {
                                                                                    phi_3075_ = (_e1598 / _e1603);
                                                                                } else {
                                                                                    phi_3075_ = f32();
                                                                                }
                                                                                let _e1708 = phi_3075_;
                                                                                phi_3077_ = _e1708;
                                                                                phi_3078_ = select(true, false, _e1705);
                                                                            } else {
                                                                                phi_3077_ = f32();
                                                                                phi_3078_ = true;
                                                                            }
                                                                            let _e1711 = phi_3077_;
                                                                            let _e1713 = phi_3078_;
                                                                            if _e1713 {
                                                                                let _e1721 = (((_e1569 * (_e1630 - (_e523 * _e1633))) + (_e1574 * (_e1631 - (_e589 * _e1633)))) / _e1603);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u)) <= _e1535) {
                                                                                    phi_3098_ = (_e1633 + _e1721);
                                                                                } else {
                                                                                    phi_3098_ = _e1633;
                                                                                }
                                                                                let _e1728 = phi_3098_;
                                                                                phi_3099_ = _e1728;
                                                                            } else {
                                                                                phi_3099_ = _e1711;
                                                                            }
                                                                            let _e1730 = phi_3099_;
                                                                            let _e1732 = select(_e1468, _e1730, (_e1730 < _e1468));
                                                                            let _e1734 = select(_e1460, _e1732, (_e1732 > _e1460));
                                                                            if (_e1734 >= _e769) {
                                                                                let _e1736 = (_e1734 <= _e868.member);
                                                                                if _e1736 {
                                                                                    let _e1737 = (1f / _e1387);
                                                                                    phi_3122_ = type_21(_e1734, (_e1381 * _e1737), (_e1385 * _e1737), _e928);
                                                                                } else {
                                                                                    phi_3122_ = type_21();
                                                                                }
                                                                                let _e1742 = phi_3122_;
                                                                                phi_3124_ = _e1742;
                                                                                phi_3125_ = select(true, false, _e1736);
                                                                            } else {
                                                                                phi_3124_ = type_21();
                                                                                phi_3125_ = true;
                                                                            }
                                                                            let _e1745 = phi_3124_;
                                                                            let _e1747 = phi_3125_;
                                                                            if _e1747 {
                                                                                phi_3129_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_3129_ = _e1745;
                                                                            }
                                                                            let _e1749 = phi_3129_;
                                                                            phi_3130_ = _e1749;
                                                                        }
                                                                        let _e1751 = phi_3130_;
                                                                        phi_3131_ = _e1751;
                                                                        phi_3132_ = _e1477;
                                                                    }
                                                                    let _e1753 = phi_3131_;
                                                                    let _e1755 = phi_3132_;
                                                                    phi_3136_ = _e1753;
                                                                    phi_3137_ = _e1755;
                                                                }
                                                                let _e1757 = phi_3136_;
                                                                let _e1759 = phi_3137_;
                                                                phi_3138_ = _e1757;
                                                                phi_3139_ = _e1412;
                                                                phi_3140_ = _e1759;
                                                            }
                                                            let _e1761 = phi_3138_;
                                                            let _e1763 = phi_3139_;
                                                            let _e1765 = phi_3140_;
                                                            phi_3141_ = _e1761;
                                                            phi_3142_ = _e1763;
                                                            phi_3143_ = _e1765;
                                                        }
                                                        let _e1767 = phi_3141_;
                                                        let _e1769 = phi_3142_;
                                                        let _e1771 = phi_3143_;
                                                        phi_3151_ = _e1767;
                                                        phi_3152_ = select(_e1771, true, _e1769);
                                                    } else {
                                                        phi_3151_ = type_21();
                                                        phi_3152_ = true;
                                                    }
                                                    let _e1774 = phi_3151_;
                                                    let _e1776 = phi_3152_;
                                                    if _e1776 {
                                                        phi_3156_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3156_ = _e1774;
                                                    }
                                                    let _e1778 = phi_3156_;
                                                    if (_e1778.member_3 != 4294967295u) {
                                                        if (_e928 == _e171) {
                                                            phi_3491_ = false;
                                                        } else {
                                                            let _e1782 = (_e928 < arrayLength((&global_5.member)));
                                                            if _e1782 {
                                                                if _e1782 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1784 = global_5.member[_e928];
                                                                phi_3179_ = _e1784;
                                                            } else {
                                                                phi_3179_ = 4294967295u;
                                                            }
                                                            let _e1786 = phi_3179_;
                                                            let _e1787 = (_e1786 < arrayLength((&global_6.member)));
                                                            if _e1787 {
                                                                if _e1787 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1789 = global_6.member[_e1786];
                                                                phi_3193_ = _e1789;
                                                            } else {
                                                                phi_3193_ = 0i;
                                                            }
                                                            let _e1791 = phi_3193_;
                                                            let _e1792 = (_e1791 == 0i);
                                                            if _e1792 {
                                                                phi_3490_ = true;
                                                            } else {
                                                                if _e460 {
                                                                    phi_3216_ = vec3<f32>(_e1315[0][0], _e1315[0][1], _e1315[0][2]);
                                                                } else {
                                                                    if (_e436 == 1u) {
                                                                        phi_3215_ = vec3<f32>(_e1315[0][2], _e1315[0][0], _e1315[0][1]);
                                                                    } else {
                                                                        phi_3215_ = vec3<f32>(_e1315[0][1], _e1315[0][2], _e1315[0][0]);
                                                                    }
                                                                    let _e1797 = phi_3215_;
                                                                    phi_3216_ = _e1797;
                                                                }
                                                                let _e1800 = phi_3216_;
                                                                if _e460 {
                                                                    phi_3235_ = vec3<f32>(_e1315[1][0], _e1315[1][1], _e1315[1][2]);
                                                                } else {
                                                                    if (_e436 == 1u) {
                                                                        phi_3234_ = vec3<f32>(_e1315[1][2], _e1315[1][0], _e1315[1][1]);
                                                                    } else {
                                                                        phi_3234_ = vec3<f32>(_e1315[1][1], _e1315[1][2], _e1315[1][0]);
                                                                    }
                                                                    let _e1805 = phi_3234_;
                                                                    phi_3235_ = _e1805;
                                                                }
                                                                let _e1808 = phi_3235_;
                                                                if _e460 {
                                                                    phi_3254_ = vec3<f32>(_e1315[2][0], _e1315[2][1], _e1315[2][2]);
                                                                } else {
                                                                    if (_e436 == 1u) {
                                                                        phi_3253_ = vec3<f32>(_e1315[2][2], _e1315[2][0], _e1315[2][1]);
                                                                    } else {
                                                                        phi_3253_ = vec3<f32>(_e1315[2][1], _e1315[2][2], _e1315[2][0]);
                                                                    }
                                                                    let _e1813 = phi_3253_;
                                                                    phi_3254_ = _e1813;
                                                                }
                                                                let _e1816 = phi_3254_;
                                                                let _e1819 = (_e1808.x - _e1800.x);
                                                                let _e1822 = (_e1808.y - _e1800.y);
                                                                let _e1825 = (_e1808.z - _e1800.z);
                                                                let _e1827 = (_e1816.x - _e1800.x);
                                                                let _e1829 = (_e1816.y - _e1800.y);
                                                                let _e1831 = (_e1816.z - _e1800.z);
                                                                if (_e303.member_1 == 1u) {
                                                                    phi_3290_ = (vec3<f32>(_e303.member[0], _e303.member[1], _e303.member[2]) - _e1800);
                                                                } else {
                                                                    phi_3290_ = vec3<f32>(_e303.member[0], _e303.member[1], _e303.member[2]);
                                                                }
                                                                let _e1846 = phi_3290_;
                                                                let _e1852 = bitcast<f32>((bitcast<u32>((_e1819 * _e1829)) ^ _e303.member_3[0]));
                                                                let _e1856 = bitcast<f32>((bitcast<u32>((_e1822 * _e1827)) ^ _e303.member_3[0]));
                                                                let _e1860 = bitcast<f32>((bitcast<u32>((_e1822 * _e1831)) ^ _e303.member_3[0]));
                                                                let _e1864 = bitcast<f32>((bitcast<u32>((_e1825 * _e1829)) ^ _e303.member_3[0]));
                                                                let _e1868 = bitcast<f32>((bitcast<u32>((_e1825 * _e1827)) ^ _e303.member_3[0]));
                                                                let _e1872 = bitcast<f32>((bitcast<u32>((_e1819 * _e1831)) ^ _e303.member_3[0]));
                                                                let _e1873 = (_e1860 - _e1864);
                                                                let _e1874 = (_e1868 - _e1872);
                                                                let _e1875 = (_e1852 - _e1856);
                                                                let _e1899 = (bitcast<f32>((bitcast<u32>(_e1860) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1864) & 2147483647u)));
                                                                let _e1906 = (bitcast<f32>((bitcast<u32>(_e1868) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1872) & 2147483647u)));
                                                                let _e1913 = (bitcast<f32>((bitcast<u32>(_e1852) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1856) & 2147483647u)));
                                                                if (_e303.member_2 == 0f) {
                                                                    phi_3472_ = 0f;
                                                                } else {
                                                                    let _e1943 = bitcast<f32>((bitcast<u32>(_e1873) & 2147483647u));
                                                                    let _e1946 = bitcast<f32>((bitcast<u32>(_e1874) & 2147483647u));
                                                                    let _e1949 = bitcast<f32>((bitcast<u32>(_e1875) & 2147483647u));
                                                                    let _e1951 = select(_e1949, _e1946, (_e1946 > _e1949));
                                                                    let _e1955 = select(_e1949, _e1946, (_e1946 < _e1949));
                                                                    let _e1959 = select(_e1946, _e1943, (_e1943 < _e1946));
                                                                    let _e1961 = select(_e1946, _e1943, (_e1943 > _e1946));
                                                                    let _e1963 = select(_e1949, _e1961, (_e1961 < _e1949));
                                                                    phi_3472_ = bitcast<f32>((bitcast<u32>((_e303.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1951, _e1943, (_e1943 > _e1951)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1963, _e1959, (_e1959 > _e1963)))) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1955, _e1943, (_e1943 < _e1955)))) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1899 + _e1906) + _e1913))) ^ _e303.member_3[0]))) * 1.0000005f)) ^ _e303.member_3[0])))) ^ _e303.member_3[0]));
                                                                }
                                                                let _e1990 = phi_3472_;
                                                                phi_3490_ = (_e1792 || !(((((bitcast<f32>((bitcast<u32>((_e1846.x * _e1873)) ^ _e303.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1846.y * _e1874)) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1846.z * _e1875)) ^ _e303.member_3[0]))) * f32(-(_e1791))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1846.x) & 2147483647u)) * _e1899)) ^ _e303.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1846.y) & 2147483647u)) * _e1906)) ^ _e303.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1846.z) & 2147483647u)) * _e1913)) ^ _e303.member_3[0]))))) ^ _e303.member_3[0])) + _e1990) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2004 = phi_3490_;
                                                            phi_3491_ = _e2004;
                                                        }
                                                        let _e2006 = phi_3491_;
                                                        if _e2006 {
                                                            phi_3496_ = type_42(_e868.member, true);
                                                        } else {
                                                            phi_3496_ = _e868;
                                                        }
                                                        let _e2011 = phi_3496_;
                                                        phi_3497_ = _e2011;
                                                    } else {
                                                        phi_3497_ = _e868;
                                                    }
                                                    let _e2013 = phi_3497_;
                                                    phi_1494_ = _e2013;
                                                } else {
                                                    phi_1494_ = type_42();
                                                }
                                                let _e2015 = phi_1494_;
                                                continue;
                                                continuing {
                                                    phi_1493_ = _e2015;
                                                    phi_1496_ = _e883;
                                                    phi_5039_ = _e811;
                                                    break if !(_e889);
                                                }
                                            }
                                            let _e2018 = phi_5039_;
                                            phi_5278_ = _e2018;
                                            if _e2018 {
                                                break;
                                            }
                                            phi_5369_ = _e2018;
                                            let _e2724 = local_11;
                                            phi_3498_ = _e2724;
                                        } else {
                                            phi_5369_ = _e811;
                                            phi_3498_ = _e813;
                                        }
                                        let _e2020 = phi_5369_;
                                        let _e2022 = phi_3498_;
                                        if _e860 {
                                            phi_4763_ = bool();
                                            phi_4764_ = u32();
                                            phi_4765_ = type_58();
                                        } else {
                                            if (_e856.member_1 >= _e103) {
                                                phi_4299_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e856.member_1 < _e103) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2025 = (_e436 * 2u);
                                                let _e2027 = ((1u + _e2025) % 7u);
                                                if (_e2027 < 7u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2032 = global_8.member[_e856.member_1][_e2027];
                                                let _e2034 = ((_e2025 + 2u) % 7u);
                                                if (_e2034 < 7u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2039 = global_8.member[_e856.member_1][_e2034];
                                                let _e2040 = (_e435 * 2u);
                                                let _e2042 = ((1u + _e2040) % 7u);
                                                if (_e2042 < 7u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2047 = global_8.member[_e856.member_1][_e2042];
                                                let _e2049 = ((_e2040 + 2u) % 7u);
                                                if (_e2049 < 7u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2054 = global_8.member[_e856.member_1][_e2049];
                                                let _e2055 = (_e437 * 2u);
                                                let _e2057 = ((1u + _e2055) % 7u);
                                                if (_e2057 < 7u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2062 = global_8.member[_e856.member_1][_e2057];
                                                let _e2064 = ((_e2055 + 2u) % 7u);
                                                if (_e2064 < 7u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2069 = global_8.member[_e856.member_1][_e2064];
                                                let _e2092 = (bitcast<f32>((bitcast<u32>((_e856.member.member_1.x - _e856.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e2093 = (bitcast<f32>((bitcast<u32>((_e856.member.member_1.y - _e856.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e2094 = (bitcast<f32>((bitcast<u32>((_e856.member.member_1.z - _e856.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e2096 = select(_e162, _e2092, (_e2092 > _e162));
                                                let _e2098 = select(_e162, _e2093, (_e2093 > _e162));
                                                let _e2100 = select(_e162, _e2094, (_e2094 > _e162));
                                                let _e2131 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2032 & 2097151u))) - 8388608f) * _e2096));
                                                let _e2136 = (bitcast<i32>((_e2032 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2139 = bitcast<f32>((_e2131 & bitcast<u32>(_e2136)));
                                                let _e2140 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2047 & 2097151u))) - 8388608f) * _e2098));
                                                let _e2145 = (bitcast<i32>((_e2047 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2148 = bitcast<f32>((_e2140 & bitcast<u32>(_e2145)));
                                                let _e2149 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2062 & 2097151u))) - 8388608f) * _e2100));
                                                let _e2154 = (bitcast<i32>((_e2062 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2157 = bitcast<f32>((_e2149 & bitcast<u32>(_e2154)));
                                                let _e2161 = bitcast<f32>((_e2131 & bitcast<u32>(~(_e2136))));
                                                let _e2165 = bitcast<f32>((_e2140 & bitcast<u32>(~(_e2145))));
                                                let _e2169 = bitcast<f32>((_e2149 & bitcast<u32>(~(_e2154))));
                                                let _e2170 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2039 & 2097151u))) - 8388608f) * _e2096));
                                                let _e2175 = (bitcast<i32>((_e2039 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2178 = bitcast<f32>((_e2170 & bitcast<u32>(_e2175)));
                                                let _e2179 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2054 & 2097151u))) - 8388608f) * _e2098));
                                                let _e2184 = (bitcast<i32>((_e2054 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2187 = bitcast<f32>((_e2179 & bitcast<u32>(_e2184)));
                                                let _e2188 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2069 & 2097151u))) - 8388608f) * _e2100));
                                                let _e2193 = (bitcast<i32>((_e2069 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2196 = bitcast<f32>((_e2188 & bitcast<u32>(_e2193)));
                                                let _e2200 = bitcast<f32>((_e2170 & bitcast<u32>(~(_e2175))));
                                                let _e2204 = bitcast<f32>((_e2179 & bitcast<u32>(~(_e2184))));
                                                let _e2208 = bitcast<f32>((_e2188 & bitcast<u32>(~(_e2193))));
                                                let _e2209 = (_e856.member.member.x + _e2139);
                                                let _e2210 = (_e856.member.member.y + _e2148);
                                                let _e2211 = (_e856.member.member.z + _e2157);
                                                let _e2214 = (_e856.member.member_1.x - _e2178);
                                                let _e2215 = (_e856.member.member_1.y - _e2187);
                                                let _e2216 = (_e856.member.member_1.z - _e2196);
                                                let _e2235 = (_e2214 - _e2209);
                                                let _e2236 = (_e2215 - _e2210);
                                                let _e2237 = (_e2216 - _e2211);
                                                let _e2239 = select(_e2236, _e2235, (_e2235 > _e2236));
                                                let _e2241 = select(_e2237, _e2239, (_e2239 > _e2237));
                                                if (_e2241 < (1024f * _e162)) {
                                                    phi_4000_ = 0u;
                                                } else {
                                                    phi_4000_ = select(2u, 1u, (_e2241 < (2097152f * _e162)));
                                                }
                                                let _e2248 = phi_4000_;
                                                switch bitcast<i32>(_e2248) {
                                                    case 0: {
                                                        phi_4006_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_4006_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_4006_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_4006_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e2251 = phi_4006_;
                                                let _e2257 = global_8.member[_e856.member_1][0u];
                                                let _e2261 = global_8.member[_e856.member_1][2u];
                                                let _e2265 = global_8.member[_e856.member_1][4u];
                                                let _e2269 = global_8.member[_e856.member_1][6u];
                                                let _e2281 = (((_e2261 >> bitcast<u32>(22i)) | ((_e2265 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2269 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e2282 = (_e2257 & 268435455u);
                                                let _e2283 = (_e2281 & 268435455u);
                                                let _e2286 = ((_e2257 >> bitcast<u32>(28u)) & 7u);
                                                let _e2294 = ((_e2257 >> bitcast<u32>(31i)) | (((_e2281 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e2295 = (_e2286 != 0u);
                                                if (_e2286 == 0u) {
                                                    phi_4261_ = _e2282;
                                                } else {
                                                    if (_e2286 == 7u) {
                                                        phi_4260_ = 2147483648u;
                                                    } else {
                                                        phi_4260_ = ((2147483648u | (_e2286 << bitcast<u32>(28u))) | (_e2283 & 268435455u));
                                                    }
                                                    let _e2304 = phi_4260_;
                                                    phi_4261_ = _e2304;
                                                }
                                                let _e2306 = phi_4261_;
                                                if _e2295 {
                                                    let _e2307 = (_e2286 != 7u);
                                                    if _e2307 {
                                                        phi_4271_ = (_e2283 + (_e2286 * ((3u * _e2251) + 1u)));
                                                    } else {
                                                        phi_4271_ = u32();
                                                    }
                                                    let _e2311 = phi_4271_;
                                                    phi_4273_ = _e2311;
                                                    phi_4274_ = select(true, false, _e2307);
                                                } else {
                                                    phi_4273_ = u32();
                                                    phi_4274_ = true;
                                                }
                                                let _e2314 = phi_4273_;
                                                let _e2316 = phi_4274_;
                                                if (_e2294 == 0u) {
                                                    phi_4295_ = (_e2282 + select(0u, 1u, !(_e2295)));
                                                } else {
                                                    if (_e2294 == 7u) {
                                                        phi_4294_ = 2147483648u;
                                                    } else {
                                                        phi_4294_ = ((2147483648u | (_e2294 << bitcast<u32>(28u))) | (select(_e2314, _e2283, _e2316) & 268435455u));
                                                    }
                                                    let _e2329 = phi_4294_;
                                                    phi_4295_ = _e2329;
                                                }
                                                let _e2331 = phi_4295_;
                                                phi_4299_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e2209, (_e856.member.member.x + _e2161), _e2214, (_e856.member.member_1.x - _e2200)), vec4<f32>(_e2210, (_e856.member.member.y + _e2165), _e2215, (_e856.member.member_1.y - _e2204)), vec4<f32>(_e2211, (_e856.member.member.z + _e2169), _e2216, (_e856.member.member_1.z - _e2208))), type_58(type_30((_e856.member.member + vec4<f32>(_e2139, _e2148, _e2157, 0f)), (_e856.member.member_1 - vec4<f32>(_e2178, _e2187, _e2196, 0f))), _e2306), type_58(type_30((_e856.member.member + vec4<f32>(_e2161, _e2165, _e2169, 0f)), (_e856.member.member_1 - vec4<f32>(_e2200, _e2204, _e2208, 0f))), _e2331));
                                            }
                                            let _e2336 = phi_4299_;
                                            let _e2348 = ((_e2336.member[0].x - _e521) * _e526);
                                            let _e2349 = ((_e2336.member[0].y - _e521) * _e526);
                                            let _e2350 = ((_e2336.member[0].z - _e522) * _e526);
                                            let _e2351 = ((_e2336.member[0].w - _e522) * _e526);
                                            let _e2361 = ((_e2336.member[1].x - _e587) * _e592);
                                            let _e2362 = ((_e2336.member[1].y - _e587) * _e592);
                                            let _e2363 = ((_e2336.member[1].z - _e588) * _e592);
                                            let _e2364 = ((_e2336.member[1].w - _e588) * _e592);
                                            let _e2374 = ((_e2336.member[2].x - _e653) * _e658);
                                            let _e2375 = ((_e2336.member[2].y - _e653) * _e658);
                                            let _e2376 = ((_e2336.member[2].z - _e654) * _e658);
                                            let _e2377 = ((_e2336.member[2].w - _e654) * _e658);
                                            let _e2379 = select(_e2376, _e2374, (_e2374 < _e2376));
                                            let _e2381 = select(_e2377, _e2375, (_e2375 < _e2377));
                                            let _e2383 = select(_e2376, _e2374, (_e2374 > _e2376));
                                            let _e2385 = select(_e2377, _e2375, (_e2375 > _e2377));
                                            let _e2387 = select(_e2350, _e2348, (_e2348 < _e2350));
                                            let _e2389 = select(_e2351, _e2349, (_e2349 < _e2351));
                                            let _e2391 = select(_e2363, _e2361, (_e2361 < _e2363));
                                            let _e2393 = select(_e2364, _e2362, (_e2362 < _e2364));
                                            let _e2395 = select(_e2391, _e2387, (_e2387 > _e2391));
                                            let _e2397 = select(_e2393, _e2389, (_e2389 > _e2393));
                                            let _e2399 = select(_e2379, _e2395, (_e2395 > _e2379));
                                            let _e2401 = select(_e2381, _e2397, (_e2397 > _e2381));
                                            let _e2403 = select(_e2350, _e2348, (_e2348 > _e2350));
                                            let _e2405 = select(_e2351, _e2349, (_e2349 > _e2351));
                                            let _e2407 = select(_e2363, _e2361, (_e2361 > _e2363));
                                            let _e2409 = select(_e2364, _e2362, (_e2362 > _e2364));
                                            let _e2411 = select(_e2407, _e2403, (_e2403 < _e2407));
                                            let _e2413 = select(_e2409, _e2405, (_e2405 < _e2409));
                                            let _e2418 = -(_e2379);
                                            let _e2419 = -(_e2381);
                                            let _e2426 = (select(_e2383, _e2411, (_e2411 < _e2383)) + (select(_e2418, _e2383, (_e2383 > _e2418)) * 0.0000019073523f));
                                            let _e2427 = (select(_e2385, _e2413, (_e2413 < _e2385)) + (select(_e2419, _e2385, (_e2385 > _e2419)) * 0.0000019073523f));
                                            let _e2429 = select(_e769, _e2399, (_e2399 > _e769));
                                            let _e2431 = select(_e769, _e2401, (_e2401 > _e769));
                                            let _e2436 = (_e2429 <= select(_e2022.member, _e2426, (_e2426 < _e2022.member)));
                                            let _e2437 = (_e2431 <= select(_e2022.member, _e2427, (_e2427 < _e2022.member)));
                                            let _e2438 = (_e2429 <= _e2431);
                                            if _e2436 {
                                                if _e2437 {
                                                    if _e2438 {
                                                        phi_4661_ = _e2336.member_2;
                                                    } else {
                                                        phi_4661_ = _e2336.member_1;
                                                    }
                                                    let _e2442 = phi_4661_;
                                                    let _e2463 = (_e854 % 128u);
                                                    let _e2464 = (_e2463 < 128u);
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2463] = _e2442.member_1;
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2463] = _e2442.member.member.x;
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2463] = _e2442.member.member.y;
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2463] = _e2442.member.member.z;
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2463] = _e2442.member.member_1.x;
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2463] = _e2442.member.member_1.y;
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2463] = _e2442.member.member_1.z;
                                                    if _e2464 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2463] = select(_e2429, _e2431, _e2438);
                                                    if _e2438 {
                                                        phi_4737_ = _e2336.member_1;
                                                    } else {
                                                        phi_4737_ = _e2336.member_2;
                                                    }
                                                    let _e2477 = phi_4737_;
                                                    phi_4738_ = (_e854 + 1u);
                                                    phi_4739_ = _e2477;
                                                } else {
                                                    phi_4738_ = u32();
                                                    phi_4739_ = type_58();
                                                }
                                                let _e2479 = phi_4738_;
                                                let _e2481 = phi_4739_;
                                                phi_4741_ = _e2479;
                                                phi_4742_ = _e2481;
                                                phi_4743_ = select(true, false, _e2437);
                                            } else {
                                                phi_4741_ = u32();
                                                phi_4742_ = type_58();
                                                phi_4743_ = true;
                                            }
                                            let _e2484 = phi_4741_;
                                            let _e2486 = phi_4742_;
                                            let _e2488 = phi_4743_;
                                            if _e2488 {
                                                if _e2436 {
                                                    phi_4752_ = _e2336.member_1;
                                                } else {
                                                    phi_4752_ = _e2336.member_2;
                                                }
                                                let _e2492 = phi_4752_;
                                                phi_4757_ = select(_e2437, true, _e2436);
                                                phi_4759_ = _e2492;
                                            } else {
                                                phi_4757_ = _e852;
                                                phi_4759_ = _e2486;
                                            }
                                            let _e2495 = phi_4757_;
                                            let _e2497 = phi_4759_;
                                            phi_4763_ = _e2495;
                                            phi_4764_ = select(_e2484, _e854, _e2488);
                                            phi_4765_ = _e2497;
                                        }
                                        let _e2500 = phi_4763_;
                                        let _e2502 = phi_4764_;
                                        let _e2504 = phi_4765_;
                                        if _e860 {
                                            phi_4775_ = select(_e854, 0u, _e2022.member_1);
                                            phi_4776_ = _e856;
                                        } else {
                                            phi_4775_ = _e2502;
                                            phi_4776_ = _e2504;
                                        }
                                        let _e2508 = phi_4775_;
                                        let _e2510 = phi_4776_;
                                        phi_5281_ = _e2020;
                                        phi_4777_ = _e2022;
                                        phi_4778_ = (_e815 - 1u);
                                        phi_4779_ = select(_e2500, false, _e860);
                                        phi_4780_ = _e2508;
                                        phi_4781_ = _e2510;
                                    } else {
                                        phi_5281_ = _e811;
                                        phi_4777_ = _e813;
                                        phi_4778_ = _e815;
                                        phi_4779_ = _e852;
                                        phi_4780_ = _e854;
                                        phi_4781_ = _e856;
                                    }
                                    let _e2513 = phi_5281_;
                                    let _e2515 = phi_4777_;
                                    let _e2517 = phi_4778_;
                                    let _e2519 = phi_4779_;
                                    let _e2521 = phi_4780_;
                                    let _e2523 = phi_4781_;
                                    phi_5280_ = _e2513;
                                    phi_4782_ = _e2515;
                                    phi_4783_ = _e2517;
                                    phi_4784_ = _e2519;
                                    phi_4785_ = _e2521;
                                    phi_4786_ = _e2523;
                                } else {
                                    phi_5280_ = _e811;
                                    phi_4782_ = type_42();
                                    phi_4783_ = u32();
                                    phi_4784_ = bool();
                                    phi_4785_ = u32();
                                    phi_4786_ = type_58();
                                }
                                let _e2525 = phi_5280_;
                                let _e2527 = phi_4782_;
                                let _e2529 = phi_4783_;
                                let _e2531 = phi_4784_;
                                let _e2533 = phi_4785_;
                                let _e2535 = phi_4786_;
                                phi_5279_ = _e2525;
                                phi_1367_ = _e2527;
                                phi_1370_ = _e2529;
                                phi_1372_ = _e2531;
                                phi_1374_ = _e2533;
                                phi_1376_ = _e2535;
                                phi_4787_ = _e825;
                            } else {
                                phi_5279_ = _e811;
                                phi_1367_ = type_42();
                                phi_1370_ = u32();
                                phi_1372_ = bool();
                                phi_1374_ = u32();
                                phi_1376_ = type_58();
                                phi_4787_ = false;
                            }
                            let _e2537 = phi_5279_;
                            let _e2539 = phi_1367_;
                            let _e2541 = phi_1370_;
                            let _e2543 = phi_1372_;
                            let _e2545 = phi_1374_;
                            let _e2547 = phi_1376_;
                            let _e2549 = phi_4787_;
                            continue;
                            continuing {
                                phi_5045_ = _e2537;
                                phi_1366_ = _e2539;
                                phi_1369_ = _e2541;
                                phi_1371_ = _e2543;
                                phi_1373_ = _e2545;
                                phi_1375_ = _e2547;
                                phi_5278_ = _e2537;
                                break if !(_e2549);
                            }
                        }
                        let _e2552 = phi_5278_;
                        if _e2552 {
                            break;
                        }
                        let _e2554 = local_10;
                        if _e2554.member_1 {
                        } else {
                            if _e304 {
                            } else {
                                break;
                            }
                            let _e2558 = global_2.member[_e150];
                            if _e165 {
                            } else {
                                break;
                            }
                            let _e2562 = global_9.member[_e150].member_1;
                            if _e304 {
                            } else {
                                break;
                            }
                            global_2.member[_e150] = type_23(_e2558.member, _e2558.member_1, _e2558.member_2, array<f32, 3>((_e2558.member_3[0] + (_e2562[0] * _e2558.member_1[0])), (_e2558.member_3[1] + (_e2562[1] * _e2558.member_1[1])), (_e2558.member_3[2] + (_e2562[2] * _e2558.member_1[2]))), _e2558.member_4);
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
