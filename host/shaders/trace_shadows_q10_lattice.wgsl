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

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_58 {
    member: type_34,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<uniform> global_4: type_48;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_51;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_64;
@group(0) @binding(7) 
var<storage> global_9: type_37;
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
    var phi_527_: type_40;
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
    var phi_1366_: type_46;
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
    var phi_1493_: type_46;
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
    var phi_3122_: type_25;
    var phi_3124_: type_25;
    var phi_3125_: bool;
    var phi_3129_: type_25;
    var phi_3130_: type_25;
    var phi_3131_: type_25;
    var phi_3132_: bool;
    var phi_3136_: type_25;
    var phi_3137_: bool;
    var phi_3138_: type_25;
    var phi_3139_: bool;
    var phi_3140_: bool;
    var phi_3141_: type_25;
    var phi_3142_: bool;
    var phi_3143_: bool;
    var phi_3151_: type_25;
    var phi_3152_: bool;
    var phi_3156_: type_25;
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
    var phi_3496_: type_46;
    var phi_3497_: type_46;
    var phi_1494_: type_46;
    var phi_5036_: bool;
    var local_10: type_46;
    var phi_5279_: bool;
    var phi_4770_: type_46;
    var phi_4771_: bool;
    var phi_4772_: u32;
    var phi_4773_: type_58;
    var phi_5278_: bool;
    var phi_4774_: type_46;
    var phi_4775_: bool;
    var phi_4776_: u32;
    var phi_4777_: u32;
    var phi_4778_: type_58;
    var phi_5277_: bool;
    var phi_4779_: type_46;
    var phi_4780_: bool;
    var phi_4781_: u32;
    var phi_4782_: u32;
    var phi_4783_: type_58;
    var phi_5276_: bool;
    var phi_1367_: type_46;
    var phi_1370_: bool;
    var phi_1372_: u32;
    var phi_1374_: u32;
    var phi_1376_: type_58;
    var phi_4784_: bool;
    var phi_5275_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e104 = global;
            let _e106 = arrayLength((&global_5.member));
            let _e109 = arrayLength((&global_10.member));
            let _e121 = arrayLength((&global_8.member));
            let _e125 = global_4.member[0u][0u];
            let _e129 = global_4.member[0u][1u];
            let _e133 = global_4.member[0u][2u];
            let _e137 = global_4.member[0u][3u];
            let _e141 = global_4.member[1u][0u];
            let _e145 = global_4.member[1u][1u];
            let _e149 = global_4.member[1u][2u];
            let _e153 = (_e104.x + (_e104.y * 2097152u));
            let _e165 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e137) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e125), bitcast<i32>(_e129), bitcast<i32>(_e133));
            local = array<i32, 3>(bitcast<i32>(_e141), bitcast<i32>(_e145), bitcast<i32>(_e149));
            let _e168 = (_e153 < arrayLength((&global_9.member)));
            if _e168 {
                if _e168 {
                } else {
                    break;
                }
                let _e172 = global_9.member[_e153].member_2;
                phi_343_ = _e172;
            } else {
                phi_343_ = 4294967295u;
            }
            let _e174 = phi_343_;
            let _e177 = global_1.member[0u];
            let _e181 = global_3.member[0u][0u];
            let _e185 = global_3.member[0u][1u];
            let _e189 = global_3.member[0u][2u];
            let _e193 = global_3.member[0u][3u];
            let _e197 = global_3.member[1u][0u];
            let _e201 = global_3.member[1u][1u];
            let _e205 = global_3.member[1u][2u];
            let _e209 = global_3.member[1u][3u];
            let _e210 = bitcast<f32>(_e181);
            let _e211 = bitcast<f32>(_e185);
            let _e212 = bitcast<f32>(_e189);
            let _e214 = bitcast<f32>(_e197);
            let _e215 = array<u32, 3>(_e201, _e205, _e209);
            let _e217 = bitcast<i32>(_e177);
            if (_e217 < -126i) {
                phi_387_ = -126i;
            } else {
                phi_387_ = select(_e217, 127i, (_e217 > 127i));
            }
            let _e222 = phi_387_;
            let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
            let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
            if (_e193 == 0u) {
                phi_527_ = type_40(array<f32, 3>(_e210, _e211, _e212), _e193, _e214, _e215);
            } else {
                let _e235 = bitcast<u32>(_e210);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e211);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e212);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                let _e287 = bitcast<u32>(_e214);
                let _e289 = ((_e287 & 2139095040u) != 0u);
                phi_527_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e210, _e237) * _e227) * select(0.00000011920929f, 1f, _e237)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e211, _e254) * _e227) * select(0.00000011920929f, 1f, _e254)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e212, _e271) * _e227) * select(0.00000011920929f, 1f, _e271)) * _e233)), _e193, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e287 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e287 & 2147483648u))), _e214, _e289) * _e227) * select(0.00000011920929f, 1f, _e289)) * _e233), _e215);
            }
            let _e306 = phi_527_;
            if _e168 {
                let _e307 = (_e153 < arrayLength((&global_2.member)));
                if _e307 {
                    if _e168 {
                    } else {
                        break;
                    }
                    let _e312 = global_9.member[_e153].member.member_1;
                    let _e317 = global_9.member[_e153].member.member_3;
                    if (_e312 <= _e317) {
                        let _e319 = (1u < _e121);
                        if _e319 {
                            if (0u < _e121) {
                            } else {
                                break;
                            }
                            let _e323 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e323 + 1u) < _e323) {
                                if _e319 {
                                } else {
                                    break;
                                }
                                let _e328 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e168 {
                        } else {
                            break;
                        }
                        let _e338 = global_9.member[_e153].member.member_2[0u];
                        let _e340 = (bitcast<u32>(_e338) & 2147483647u);
                        let _e346 = global_9.member[_e153].member.member_2[1u];
                        let _e348 = (bitcast<u32>(_e346) & 2147483647u);
                        let _e354 = global_9.member[_e153].member.member_2[2u];
                        let _e356 = (bitcast<u32>(_e354) & 2147483647u);
                        let _e362 = global_9.member[_e153].member.member[0u];
                        let _e364 = (bitcast<u32>(_e362) & 2147483647u);
                        let _e370 = global_9.member[_e153].member.member[1u];
                        let _e372 = (bitcast<u32>(_e370) & 2147483647u);
                        let _e378 = global_9.member[_e153].member.member[2u];
                        let _e380 = (bitcast<u32>(_e378) & 2147483647u);
                        let _e382 = select(_e348, _e340, (_e348 < _e340));
                        let _e384 = select(_e356, _e382, (_e356 < _e382));
                        let _e386 = select(_e364, _e384, (_e364 < _e384));
                        let _e388 = select(_e372, _e386, (_e372 < _e386));
                        let _e390 = select(_e380, _e388, (_e380 < _e388));
                        let _e391 = bitcast<u32>(_e312);
                        let _e392 = (_e391 & 2147483647u);
                        let _e396 = bitcast<u32>(_e317);
                        let _e397 = (_e396 & 2147483647u);
                        let _e401 = (((select(_e392, _e390, (_e392 < _e390)) < 2139095040u) && (_e397 <= 2139095040u)) && (_e384 > 0u));
                        if _e401 {
                            let _e404 = (bitcast<u32>(bitcast<f32>(_e384)) & 2147483647u);
                            if (_e404 >= 8388608u) {
                                phi_677_ = (bitcast<i32>((_e404 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_677_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e404)), 32u, (_e404 == 0u))));
                            }
                            let _e418 = phi_677_;
                            phi_678_ = _e418;
                        } else {
                            phi_678_ = 0i;
                        }
                        let _e420 = phi_678_;
                        let _e421 = (_e340 == _e384);
                        if _e421 {
                            phi_688_ = true;
                        } else {
                            phi_688_ = (_e348 == _e384);
                        }
                        let _e424 = phi_688_;
                        let _e425 = select(1u, 0u, _e421);
                        if _e424 {
                            let _e426 = (_e425 + 1u);
                            phi_698_ = _e426;
                            phi_699_ = _e426;
                            phi_701_ = select(true, false, (_e426 == 2u));
                        } else {
                            phi_698_ = u32();
                            phi_699_ = 0u;
                            phi_701_ = true;
                        }
                        let _e430 = phi_698_;
                        let _e432 = phi_699_;
                        let _e434 = phi_701_;
                        if _e434 {
                            phi_706_ = (_e432 + 1u);
                        } else {
                            phi_706_ = 0u;
                        }
                        let _e438 = phi_706_;
                        let _e439 = select(_e430, _e432, _e434);
                        let _e440 = select(_e425, select(2u, _e425, _e424), _e434);
                        let _e441 = -(_e420);
                        if (_e441 < -126i) {
                            phi_739_ = -126i;
                        } else {
                            phi_739_ = select(_e441, 127i, (_e441 > 127i));
                        }
                        let _e446 = phi_739_;
                        let _e451 = bitcast<f32>((bitcast<u32>((_e446 + 127i)) << bitcast<u32>(23i)));
                        let _e457 = bitcast<f32>((bitcast<u32>(((_e441 - _e446) + 127i)) << bitcast<u32>(23i)));
                        let _e462 = global_9.member[_e153].member.member;
                        let _e463 = (_e439 == 0u);
                        if _e463 {
                            phi_757_ = _e462[0];
                        } else {
                            phi_757_ = _e462[1];
                        }
                        let _e467 = phi_757_;
                        let _e468 = (_e439 == 2u);
                        if _e468 {
                            phi_763_ = _e462[2];
                        } else {
                            phi_763_ = _e467;
                        }
                        let _e471 = phi_763_;
                        let _e472 = bitcast<u32>(_e471);
                        let _e474 = ((_e472 & 2139095040u) != 0u);
                        let _e486 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e472 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e472 & 2147483648u))), _e471, _e474) * select(0.00000011920929f, 1f, _e474));
                        let _e487 = global_9.member[_e153].member.member_2;
                        if _e463 {
                            phi_803_ = _e487[0];
                        } else {
                            phi_803_ = _e487[1];
                        }
                        let _e491 = phi_803_;
                        if _e468 {
                            phi_809_ = _e487[2];
                        } else {
                            phi_809_ = _e491;
                        }
                        let _e494 = phi_809_;
                        let _e495 = bitcast<u32>(_e494);
                        let _e497 = ((_e495 & 2139095040u) != 0u);
                        let _e511 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e495 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e495 & 2147483648u))), _e494, _e497) * _e451) * select(0.00000011920929f, 1f, _e497)) * _e457);
                        let _e515 = (bitcast<f32>((bitcast<u32>(_e511) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e515 {
                            let _e519 = (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) * 0.00000011920929f);
                            phi_861_ = select(0.00000000000011368684f, _e519, (_e519 > 0.00000000000011368684f));
                        } else {
                            phi_861_ = 0f;
                        }
                        let _e523 = phi_861_;
                        let _e524 = (_e486 + _e523);
                        let _e525 = (_e486 - _e523);
                        let _e526 = select(_e511, 0f, _e515);
                        if _e515 {
                            phi_873_ = 38685626000000000000000000f;
                        } else {
                            phi_873_ = (1f / _e511);
                        }
                        let _e529 = phi_873_;
                        let _e530 = (_e438 == 0u);
                        if _e530 {
                            phi_882_ = _e462[0];
                        } else {
                            phi_882_ = _e462[1];
                        }
                        let _e534 = phi_882_;
                        let _e535 = (_e438 == 2u);
                        if _e535 {
                            phi_888_ = _e462[2];
                        } else {
                            phi_888_ = _e534;
                        }
                        let _e538 = phi_888_;
                        let _e539 = bitcast<u32>(_e538);
                        let _e541 = ((_e539 & 2139095040u) != 0u);
                        let _e553 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e539 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e539 & 2147483648u))), _e538, _e541) * select(0.00000011920929f, 1f, _e541));
                        if _e530 {
                            phi_928_ = _e487[0];
                        } else {
                            phi_928_ = _e487[1];
                        }
                        let _e557 = phi_928_;
                        if _e535 {
                            phi_934_ = _e487[2];
                        } else {
                            phi_934_ = _e557;
                        }
                        let _e560 = phi_934_;
                        let _e561 = bitcast<u32>(_e560);
                        let _e563 = ((_e561 & 2139095040u) != 0u);
                        let _e577 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e561 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e561 & 2147483648u))), _e560, _e563) * _e451) * select(0.00000011920929f, 1f, _e563)) * _e457);
                        let _e581 = (bitcast<f32>((bitcast<u32>(_e577) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e581 {
                            let _e585 = (bitcast<f32>((bitcast<u32>(_e553) & 2147483647u)) * 0.00000011920929f);
                            phi_986_ = select(0.00000000000011368684f, _e585, (_e585 > 0.00000000000011368684f));
                        } else {
                            phi_986_ = 0f;
                        }
                        let _e589 = phi_986_;
                        let _e590 = (_e553 + _e589);
                        let _e591 = (_e553 - _e589);
                        let _e592 = select(_e577, 0f, _e581);
                        if _e581 {
                            phi_998_ = 38685626000000000000000000f;
                        } else {
                            phi_998_ = (1f / _e577);
                        }
                        let _e595 = phi_998_;
                        let _e596 = (_e440 == 0u);
                        if _e596 {
                            phi_1007_ = _e462[0];
                        } else {
                            phi_1007_ = _e462[1];
                        }
                        let _e600 = phi_1007_;
                        let _e601 = (_e440 == 2u);
                        if _e601 {
                            phi_1013_ = _e462[2];
                        } else {
                            phi_1013_ = _e600;
                        }
                        let _e604 = phi_1013_;
                        let _e605 = bitcast<u32>(_e604);
                        let _e607 = ((_e605 & 2139095040u) != 0u);
                        let _e619 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e605 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e605 & 2147483648u))), _e604, _e607) * select(0.00000011920929f, 1f, _e607));
                        if _e596 {
                            phi_1053_ = _e487[0];
                        } else {
                            phi_1053_ = _e487[1];
                        }
                        let _e623 = phi_1053_;
                        if _e601 {
                            phi_1059_ = _e487[2];
                        } else {
                            phi_1059_ = _e623;
                        }
                        let _e626 = phi_1059_;
                        let _e627 = bitcast<u32>(_e626);
                        let _e629 = ((_e627 & 2139095040u) != 0u);
                        let _e643 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e627 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e627 & 2147483648u))), _e626, _e629) * _e451) * select(0.00000011920929f, 1f, _e629)) * _e457);
                        let _e647 = (bitcast<f32>((bitcast<u32>(_e643) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e647 {
                            let _e651 = (bitcast<f32>((bitcast<u32>(_e619) & 2147483647u)) * 0.00000011920929f);
                            phi_1111_ = select(0.00000000000011368684f, _e651, (_e651 > 0.00000000000011368684f));
                        } else {
                            phi_1111_ = 0f;
                        }
                        let _e655 = phi_1111_;
                        let _e656 = (_e619 + _e655);
                        let _e657 = (_e619 - _e655);
                        let _e658 = select(_e643, 0f, _e647);
                        if _e647 {
                            phi_1123_ = 38685626000000000000000000f;
                        } else {
                            phi_1123_ = (1f / _e643);
                        }
                        let _e661 = phi_1123_;
                        let _e664 = bitcast<f32>((bitcast<u32>(_e486) & 2147483647u));
                        let _e667 = bitcast<f32>((bitcast<u32>(_e553) & 2147483647u));
                        let _e669 = select(_e667, _e664, (_e664 > _e667));
                        let _e672 = bitcast<f32>((bitcast<u32>(_e619) & 2147483647u));
                        if (_e401 && (select(_e672, _e669, (_e669 > _e672)) <= 1099511600000f)) {
                            let _e684 = ((_e392 & 8388607u) | (select(0u, 1u, ((_e392 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e687 = bitcast<i32>((_e392 >> bitcast<u32>(23i)));
                            let _e691 = (_e684 == 0u);
                            let _e694 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e684)), 32u, _e691)) - 8i);
                            if (_e687 == 255i) {
                                phi_1178_ = 255i;
                            } else {
                                phi_1178_ = (((_e687 + select(0i, 1i, (_e687 == 0i))) - _e694) + _e420);
                            }
                            let _e702 = phi_1178_;
                            let _e712 = (_e702 <= 0i);
                            if _e712 {
                                phi_1201_ = u32();
                            } else {
                                if _e691 {
                                    phi_1200_ = u32();
                                } else {
                                    phi_1200_ = select(((bitcast<u32>(_e702) << bitcast<u32>(23i)) | ((_e684 << bitcast<u32>(((_e694 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e702 >= 255i));
                                }
                                let _e716 = phi_1200_;
                                phi_1201_ = _e716;
                            }
                            let _e718 = phi_1201_;
                            let _e730 = ((_e397 & 8388607u) | (select(0u, 1u, ((_e397 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e733 = bitcast<i32>((_e397 >> bitcast<u32>(23i)));
                            let _e737 = (_e730 == 0u);
                            let _e740 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e730)), 32u, _e737)) - 8i);
                            if (_e733 == 255i) {
                                phi_1238_ = 255i;
                            } else {
                                phi_1238_ = (((_e733 + select(0i, 1i, (_e733 == 0i))) - _e740) + _e420);
                            }
                            let _e748 = phi_1238_;
                            let _e758 = (_e748 <= 0i);
                            if _e758 {
                                phi_1261_ = u32();
                            } else {
                                if _e737 {
                                    phi_1260_ = u32();
                                } else {
                                    phi_1260_ = select(((bitcast<u32>(_e748) << bitcast<u32>(23i)) | ((_e730 << bitcast<u32>(((_e740 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e748 >= 255i));
                                }
                                let _e762 = phi_1260_;
                                phi_1261_ = _e762;
                            }
                            let _e764 = phi_1261_;
                            phi_1269_ = bitcast<f32>(((_e396 & 2147483648u) | select(_e764, 0u, select(_e737, true, _e758))));
                            phi_1270_ = bitcast<f32>(((_e391 & 2147483648u) | select(_e718, 0u, select(_e691, true, _e712))));
                        } else {
                            phi_1269_ = 0f;
                            phi_1270_ = 1f;
                        }
                        let _e770 = phi_1269_;
                        let _e772 = phi_1270_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e776 = (_e439 % 3u);
                        let _e777 = (_e776 < 3u);
                        if _e777 {
                        } else {
                            break;
                        }
                        let _e779 = local_1[_e776];
                        let _e782 = (_e438 % 3u);
                        let _e783 = (_e782 < 3u);
                        if _e783 {
                        } else {
                            break;
                        }
                        let _e785 = local_1[_e782];
                        let _e788 = (_e440 % 3u);
                        let _e789 = (_e788 < 3u);
                        if _e789 {
                        } else {
                            break;
                        }
                        let _e791 = local_1[_e788];
                        if _e777 {
                        } else {
                            break;
                        }
                        let _e796 = local[_e776];
                        if _e783 {
                        } else {
                            break;
                        }
                        let _e800 = local[_e782];
                        if _e789 {
                        } else {
                            break;
                        }
                        let _e804 = local[_e788];
                        phi_5042_ = false;
                        phi_1366_ = type_46(_e770, false);
                        phi_1369_ = (_e772 <= _e770);
                        phi_1371_ = ((3u * _e106) + 1u);
                        phi_1373_ = 0u;
                        phi_1375_ = type_58(type_34(vec4<f32>((f32(_e779) * _e165), (f32(_e785) * _e165), (f32(_e791) * _e165), 0f), vec4<f32>((f32(_e796) * _e165), (f32(_e800) * _e165), (f32(_e804) * _e165), 0f)), select(0u, 2147483648u, (_e106 == 0u)));
                        loop {
                            let _e814 = phi_5042_;
                            let _e816 = phi_1366_;
                            let _e818 = phi_1369_;
                            let _e820 = phi_1371_;
                            let _e822 = phi_1373_;
                            let _e824 = phi_1375_;
                            local_11 = _e816;
                            if _e818 {
                                phi_1386_ = true;
                            } else {
                                phi_1386_ = (_e822 > 0u);
                            }
                            let _e827 = phi_1386_;
                            if _e827 {
                                let _e828 = (_e820 > 0u);
                                if _e828 {
                                    if _e818 {
                                        phi_1472_ = _e818;
                                        phi_1473_ = _e822;
                                        phi_1474_ = _e824;
                                    } else {
                                        let _e829 = (_e822 - 1u);
                                        let _e830 = (_e829 % 128u);
                                        let _e831 = (_e830 < 128u);
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e833 = local_7[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e835 = local_6[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e837 = local_5[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e839 = local_4[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e841 = local_3[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e843 = local_2[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e848 = local_8[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5275_ = true;
                                            break;
                                        }
                                        let _e851 = local_9[_e830];
                                        phi_1472_ = (_e851 <= _e816.member);
                                        phi_1473_ = _e829;
                                        phi_1474_ = type_58(type_34(vec4<f32>(_e833, _e835, _e837, 0f), vec4<f32>(_e839, _e841, _e843, 0f)), _e848);
                                    }
                                    let _e855 = phi_1472_;
                                    let _e857 = phi_1473_;
                                    let _e859 = phi_1474_;
                                    if _e855 {
                                        let _e864 = (_e859.member_1 & 268435455u);
                                        if ((_e859.member_1 & 2147483648u) != 0u) {
                                            phi_1493_ = _e816;
                                            phi_1496_ = type_8(0u, ((_e859.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1330 = phi_1493_;
                                                let _e1332 = phi_1496_;
                                                local_10 = _e1330;
                                                local_12 = _e1330;
                                                if (_e1332.member < _e1332.member_1) {
                                                    phi_1497_ = type_8((_e1332.member + 1u), _e1332.member_1);
                                                    phi_1519_ = type_8(1u, _e1332.member);
                                                } else {
                                                    phi_1497_ = _e1332;
                                                    phi_1519_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1345 = phi_1497_;
                                                let _e1347 = phi_1519_;
                                                let _e1351 = (bitcast<i32>(_e1347.member) != 0i);
                                                if _e1351 {
                                                    let _e1356 = (_e859.member.member_1.x - _e859.member.member.x);
                                                    let _e1359 = (_e859.member.member_1.y - _e859.member.member.y);
                                                    let _e1362 = (_e859.member.member_1.z - _e859.member.member.z);
                                                    let _e1364 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                    let _e1366 = select(_e1362, _e1364, (_e1364 > _e1362));
                                                    let _e1368 = (_e1366 < (1024f * _e165));
                                                    if _e1368 {
                                                        phi_1560_ = 0u;
                                                    } else {
                                                        phi_1560_ = select(2u, 1u, (_e1366 < (2097152f * _e165)));
                                                    }
                                                    let _e1373 = phi_1560_;
                                                    switch bitcast<i32>(_e1373) {
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
                                                    let _e1376 = phi_1566_;
                                                    switch bitcast<i32>(_e1373) {
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
                                                    let _e1383 = phi_1576_;
                                                    let _e1385 = ((_e864 + (_e1347.member_1 * ((3u * _e1376) + 1u))) + (3u * _e1383));
                                                    let _e1386 = (_e1385 < _e109);
                                                    if _e1386 {
                                                        if _e1386 {
                                                        } else {
                                                            phi_5036_ = true;
                                                            break;
                                                        }
                                                        let _e1388 = global_10.member[_e1385];
                                                        phi_1592_ = _e1388;
                                                    } else {
                                                        phi_1592_ = 4294967295u;
                                                    }
                                                    let _e1390 = phi_1592_;
                                                    if _e1368 {
                                                        phi_1625_ = 0u;
                                                    } else {
                                                        phi_1625_ = select(2u, 1u, (_e1366 < (2097152f * _e165)));
                                                    }
                                                    let _e1395 = phi_1625_;
                                                    switch bitcast<i32>(_e1395) {
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
                                                    let _e1398 = phi_1631_;
                                                    let _e1402 = (_e864 + (_e1347.member_1 * ((3u * _e1398) + 1u)));
                                                    switch bitcast<i32>(_e1395) {
                                                        case 0: {
                                                            let _e1677 = (_e1402 < _e109);
                                                            if _e1677 {
                                                                if _e1677 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1679 = global_10.member[_e1402];
                                                                phi_1658_ = _e1679;
                                                            } else {
                                                                phi_1658_ = 0u;
                                                            }
                                                            let _e1681 = phi_1658_;
                                                            let _e1683 = ((10u * _e439) & 31u);
                                                            let _e1693 = ((10u * _e438) & 31u);
                                                            let _e1703 = ((10u * _e440) & 31u);
                                                            let _e1713 = (_e1402 + 1u);
                                                            let _e1714 = (_e1713 < _e109);
                                                            if _e1714 {
                                                                if _e1714 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1716 = global_10.member[_e1713];
                                                                phi_1707_ = _e1716;
                                                            } else {
                                                                phi_1707_ = 0u;
                                                            }
                                                            let _e1718 = phi_1707_;
                                                            let _e1744 = (_e1402 + 2u);
                                                            let _e1745 = (_e1744 < _e109);
                                                            if _e1745 {
                                                                if _e1745 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1747 = global_10.member[_e1744];
                                                                phi_1756_ = _e1747;
                                                            } else {
                                                                phi_1756_ = 0u;
                                                            }
                                                            let _e1749 = phi_1756_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | ((_e1681 >> bitcast<u32>(_e1683)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | ((_e1681 >> bitcast<u32>(_e1693)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | ((_e1681 >> bitcast<u32>(_e1703)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | ((_e1718 >> bitcast<u32>(_e1683)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | ((_e1718 >> bitcast<u32>(_e1693)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | ((_e1718 >> bitcast<u32>(_e1703)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | ((_e1749 >> bitcast<u32>(_e1683)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | ((_e1749 >> bitcast<u32>(_e1693)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | ((_e1749 >> bitcast<u32>(_e1703)) & 1023u))) - 8388608f) * _e165))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1491 = (_e1402 < _e109);
                                                            if _e1491 {
                                                                if _e1491 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1493 = global_10.member[_e1402];
                                                                phi_1805_ = _e1493;
                                                            } else {
                                                                phi_1805_ = 0u;
                                                            }
                                                            let _e1495 = phi_1805_;
                                                            let _e1496 = (_e1402 + 1u);
                                                            let _e1497 = (_e1496 < _e109);
                                                            if _e1497 {
                                                                if _e1497 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1499 = global_10.member[_e1496];
                                                                phi_1820_ = _e1499;
                                                            } else {
                                                                phi_1820_ = 0u;
                                                            }
                                                            let _e1501 = phi_1820_;
                                                            let _e1502 = (_e439 == 1u);
                                                            if _e1502 {
                                                                phi_1830_ = ((_e1495 >> bitcast<u32>(21i)) | (_e1501 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1830_ = (_e1501 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1511 = phi_1830_;
                                                            let _e1519 = (_e438 == 1u);
                                                            if _e1519 {
                                                                phi_1851_ = ((_e1495 >> bitcast<u32>(21i)) | (_e1501 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1851_ = (_e1501 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1528 = phi_1851_;
                                                            let _e1536 = (_e440 == 1u);
                                                            if _e1536 {
                                                                phi_1872_ = ((_e1495 >> bitcast<u32>(21i)) | (_e1501 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1872_ = (_e1501 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1545 = phi_1872_;
                                                            let _e1554 = (_e1402 + 2u);
                                                            let _e1555 = (_e1554 < _e109);
                                                            if _e1555 {
                                                                if _e1555 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1557 = global_10.member[_e1554];
                                                                phi_1902_ = _e1557;
                                                            } else {
                                                                phi_1902_ = 0u;
                                                            }
                                                            let _e1559 = phi_1902_;
                                                            let _e1560 = (_e1402 + 3u);
                                                            let _e1561 = (_e1560 < _e109);
                                                            if _e1561 {
                                                                if _e1561 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1563 = global_10.member[_e1560];
                                                                phi_1917_ = _e1563;
                                                            } else {
                                                                phi_1917_ = 0u;
                                                            }
                                                            let _e1565 = phi_1917_;
                                                            if _e1502 {
                                                                phi_1927_ = ((_e1559 >> bitcast<u32>(21i)) | (_e1565 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1927_ = (_e1565 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1574 = phi_1927_;
                                                            if _e1519 {
                                                                phi_1948_ = ((_e1559 >> bitcast<u32>(21i)) | (_e1565 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1948_ = (_e1565 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1590 = phi_1948_;
                                                            if _e1536 {
                                                                phi_1969_ = ((_e1559 >> bitcast<u32>(21i)) | (_e1565 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1969_ = (_e1565 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1606 = phi_1969_;
                                                            let _e1615 = (_e1402 + 4u);
                                                            let _e1616 = (_e1615 < _e109);
                                                            if _e1616 {
                                                                if _e1616 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1618 = global_10.member[_e1615];
                                                                phi_1999_ = _e1618;
                                                            } else {
                                                                phi_1999_ = 0u;
                                                            }
                                                            let _e1620 = phi_1999_;
                                                            let _e1621 = (_e1402 + 5u);
                                                            let _e1622 = (_e1621 < _e109);
                                                            if _e1622 {
                                                                if _e1622 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1624 = global_10.member[_e1621];
                                                                phi_2014_ = _e1624;
                                                            } else {
                                                                phi_2014_ = 0u;
                                                            }
                                                            let _e1626 = phi_2014_;
                                                            if _e1502 {
                                                                phi_2024_ = ((_e1620 >> bitcast<u32>(21i)) | (_e1626 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2024_ = (_e1626 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1635 = phi_2024_;
                                                            if _e1519 {
                                                                phi_2045_ = ((_e1620 >> bitcast<u32>(21i)) | (_e1626 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2045_ = (_e1626 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1651 = phi_2045_;
                                                            if _e1536 {
                                                                phi_2066_ = ((_e1620 >> bitcast<u32>(21i)) | (_e1626 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2066_ = (_e1626 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1667 = phi_2066_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1511, _e1495, _e463) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1528, _e1495, _e530) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1545, _e1495, _e596) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1574, _e1559, _e463) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1590, _e1559, _e530) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1606, _e1559, _e596) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1635, _e1620, _e463) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1651, _e1620, _e530) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1667, _e1620, _e596) & 2097151u))) - 8388608f) * _e165))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1404 = (_e1402 + _e439);
                                                            let _e1405 = (_e1404 < _e109);
                                                            if _e1405 {
                                                                if _e1405 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1407 = global_10.member[_e1404];
                                                                phi_2097_ = _e1407;
                                                            } else {
                                                                phi_2097_ = 0u;
                                                            }
                                                            let _e1409 = phi_2097_;
                                                            let _e1413 = (_e1402 + _e438);
                                                            let _e1414 = (_e1413 < _e109);
                                                            if _e1414 {
                                                                if _e1414 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1416 = global_10.member[_e1413];
                                                                phi_2115_ = _e1416;
                                                            } else {
                                                                phi_2115_ = 0u;
                                                            }
                                                            let _e1418 = phi_2115_;
                                                            let _e1422 = (_e1402 + _e440);
                                                            let _e1423 = (_e1422 < _e109);
                                                            if _e1423 {
                                                                if _e1423 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1425 = global_10.member[_e1422];
                                                                phi_2133_ = _e1425;
                                                            } else {
                                                                phi_2133_ = 0u;
                                                            }
                                                            let _e1427 = phi_2133_;
                                                            let _e1432 = (_e1402 + 3u);
                                                            let _e1433 = (_e1432 + _e439);
                                                            let _e1434 = (_e1433 < _e109);
                                                            if _e1434 {
                                                                if _e1434 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1436 = global_10.member[_e1433];
                                                                phi_2156_ = _e1436;
                                                            } else {
                                                                phi_2156_ = 0u;
                                                            }
                                                            let _e1438 = phi_2156_;
                                                            let _e1442 = (_e1432 + _e438);
                                                            let _e1443 = (_e1442 < _e109);
                                                            if _e1443 {
                                                                if _e1443 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1445 = global_10.member[_e1442];
                                                                phi_2174_ = _e1445;
                                                            } else {
                                                                phi_2174_ = 0u;
                                                            }
                                                            let _e1447 = phi_2174_;
                                                            let _e1451 = (_e1432 + _e440);
                                                            let _e1452 = (_e1451 < _e109);
                                                            if _e1452 {
                                                                if _e1452 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1454 = global_10.member[_e1451];
                                                                phi_2192_ = _e1454;
                                                            } else {
                                                                phi_2192_ = 0u;
                                                            }
                                                            let _e1456 = phi_2192_;
                                                            let _e1461 = (_e1402 + 6u);
                                                            let _e1462 = (_e1461 + _e439);
                                                            let _e1463 = (_e1462 < _e109);
                                                            if _e1463 {
                                                                if _e1463 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1465 = global_10.member[_e1462];
                                                                phi_2215_ = _e1465;
                                                            } else {
                                                                phi_2215_ = 0u;
                                                            }
                                                            let _e1467 = phi_2215_;
                                                            let _e1471 = (_e1461 + _e438);
                                                            let _e1472 = (_e1471 < _e109);
                                                            if _e1472 {
                                                                if _e1472 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1474 = global_10.member[_e1471];
                                                                phi_2233_ = _e1474;
                                                            } else {
                                                                phi_2233_ = 0u;
                                                            }
                                                            let _e1476 = phi_2233_;
                                                            let _e1480 = (_e1461 + _e440);
                                                            let _e1481 = (_e1480 < _e109);
                                                            if _e1481 {
                                                                if _e1481 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e1483 = global_10.member[_e1480];
                                                                phi_2251_ = _e1483;
                                                            } else {
                                                                phi_2251_ = 0u;
                                                            }
                                                            let _e1485 = phi_2251_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1409)) * _e165), (f32(bitcast<i32>(_e1418)) * _e165), (f32(bitcast<i32>(_e1427)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1438)) * _e165), (f32(bitcast<i32>(_e1447)) * _e165), (f32(bitcast<i32>(_e1456)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1467)) * _e165), (f32(bitcast<i32>(_e1476)) * _e165), (f32(bitcast<i32>(_e1485)) * _e165)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2257_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1777 = phi_2257_;
                                                    let _e1785 = (_e1777[0][2] - _e619);
                                                    let _e1788 = (((_e1777[0][0] - _e486) * _e658) - (_e1785 * _e526));
                                                    let _e1791 = (((_e1777[0][1] - _e553) * _e658) - (_e1785 * _e592));
                                                    let _e1798 = (_e1777[1][2] - _e619);
                                                    let _e1801 = (((_e1777[1][0] - _e486) * _e658) - (_e1798 * _e526));
                                                    let _e1804 = (((_e1777[1][1] - _e553) * _e658) - (_e1798 * _e592));
                                                    let _e1811 = (_e1777[2][2] - _e619);
                                                    let _e1814 = (((_e1777[2][0] - _e486) * _e658) - (_e1811 * _e526));
                                                    let _e1817 = (((_e1777[2][1] - _e553) * _e658) - (_e1811 * _e592));
                                                    let _e1818 = (_e1814 * _e1804);
                                                    let _e1819 = (_e1817 * _e1801);
                                                    let _e1820 = (_e1788 * _e1817);
                                                    let _e1821 = (_e1791 * _e1814);
                                                    let _e1822 = (_e1801 * _e1791);
                                                    let _e1823 = (_e1804 * _e1788);
                                                    let _e1828 = (((_e1818 >= _e1819) && (_e1820 >= _e1821)) && (_e1822 >= _e1823));
                                                    if (_e1828 || (((_e1818 <= _e1819) && (_e1820 <= _e1821)) && (_e1822 <= _e1823))) {
                                                        let _e1835 = select(-1f, 1f, _e1828);
                                                        let _e1837 = ((_e1818 - _e1819) * _e1835);
                                                        let _e1839 = select(0f, _e1837, (_e1837 > 0f));
                                                        let _e1841 = ((_e1820 - _e1821) * _e1835);
                                                        let _e1843 = select(0f, _e1841, (_e1841 > 0f));
                                                        let _e1845 = ((_e1822 - _e1823) * _e1835);
                                                        let _e1847 = select(0f, _e1845, (_e1845 > 0f));
                                                        let _e1849 = ((_e1839 + _e1843) + _e1847);
                                                        if (_e1849 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3141_ = type_25();
                                                            phi_3142_ = true;
                                                            phi_3143_ = false;
                                                        } else {
                                                            let _e1852 = select(_e1801, _e1788, (_e1788 < _e1801));
                                                            if (select(_e1814, _e1852, (_e1852 < _e1814)) > 0f) {
                                                                phi_2409_ = true;
                                                            } else {
                                                                let _e1857 = select(_e1801, _e1788, (_e1788 > _e1801));
                                                                phi_2409_ = (select(_e1814, _e1857, (_e1857 > _e1814)) < 0f);
                                                            }
                                                            let _e1862 = phi_2409_;
                                                            if _e1862 {
                                                                phi_3138_ = type_25();
                                                                phi_3139_ = true;
                                                                phi_3140_ = false;
                                                            } else {
                                                                let _e1864 = select(_e1804, _e1791, (_e1791 < _e1804));
                                                                if (select(_e1817, _e1864, (_e1864 < _e1817)) > 0f) {
                                                                    phi_2438_ = true;
                                                                } else {
                                                                    let _e1869 = select(_e1804, _e1791, (_e1791 > _e1804));
                                                                    phi_2438_ = (select(_e1817, _e1869, (_e1869 > _e1817)) < 0f);
                                                                }
                                                                let _e1874 = phi_2438_;
                                                                if _e1874 {
                                                                    phi_3136_ = type_25();
                                                                    phi_3137_ = false;
                                                                } else {
                                                                    let _e1876 = select(_e1777[1][0], _e1777[0][0], (_e1777[0][0] < _e1777[1][0]));
                                                                    let _e1880 = select(_e1777[1][0], _e1777[0][0], (_e1777[0][0] > _e1777[1][0]));
                                                                    let _e1884 = select(_e1777[1][1], _e1777[0][1], (_e1777[0][1] < _e1777[1][1]));
                                                                    let _e1888 = select(_e1777[1][1], _e1777[0][1], (_e1777[0][1] > _e1777[1][1]));
                                                                    let _e1892 = select(_e1777[1][2], _e1777[0][2], (_e1777[0][2] < _e1777[1][2]));
                                                                    let _e1896 = select(_e1777[1][2], _e1777[0][2], (_e1777[0][2] > _e1777[1][2]));
                                                                    let _e1901 = ((select(_e1777[2][0], _e1876, (_e1876 < _e1777[2][0])) - _e524) * _e529);
                                                                    let _e1902 = ((select(_e1777[2][0], _e1880, (_e1880 > _e1777[2][0])) - _e525) * _e529);
                                                                    let _e1905 = ((select(_e1777[2][1], _e1884, (_e1884 < _e1777[2][1])) - _e590) * _e595);
                                                                    let _e1906 = ((select(_e1777[2][1], _e1888, (_e1888 > _e1777[2][1])) - _e591) * _e595);
                                                                    let _e1909 = ((select(_e1777[2][2], _e1892, (_e1892 < _e1777[2][2])) - _e656) * _e661);
                                                                    let _e1910 = ((select(_e1777[2][2], _e1896, (_e1896 > _e1777[2][2])) - _e657) * _e661);
                                                                    let _e1912 = select(_e1910, _e1909, (_e1909 < _e1910));
                                                                    let _e1914 = select(_e1910, _e1909, (_e1909 > _e1910));
                                                                    let _e1916 = select(_e1902, _e1901, (_e1901 < _e1902));
                                                                    let _e1918 = select(_e1906, _e1905, (_e1905 < _e1906));
                                                                    let _e1920 = select(_e1918, _e1916, (_e1916 > _e1918));
                                                                    let _e1922 = select(_e1912, _e1920, (_e1920 > _e1912));
                                                                    let _e1924 = select(_e1902, _e1901, (_e1901 > _e1902));
                                                                    let _e1926 = select(_e1906, _e1905, (_e1905 > _e1906));
                                                                    let _e1928 = select(_e1926, _e1924, (_e1924 < _e1926));
                                                                    let _e1930 = select(_e1914, _e1928, (_e1928 < _e1914));
                                                                    let _e1931 = -(_e1912);
                                                                    let _e1937 = select(_e772, _e1922, (_e1922 > _e772));
                                                                    if (_e1937 > (_e1930 + (select(_e1931, _e1914, (_e1914 > _e1931)) * 0.0000019073523f))) {
                                                                        phi_3131_ = type_25();
                                                                        phi_3132_ = true;
                                                                    } else {
                                                                        let _e1939 = (_e1937 > _e1330.member);
                                                                        if _e1939 {
                                                                            phi_3130_ = type_25();
                                                                        } else {
                                                                            let _e1940 = vec3<f32>(_e1777[0][0], _e1777[0][1], _e1777[0][2]);
                                                                            let _e1941 = vec3<f32>(_e1777[1][0], _e1777[1][1], _e1777[1][2]);
                                                                            let _e1942 = vec3<f32>(_e1777[2][0], _e1777[2][1], _e1777[2][2]);
                                                                            let _e1943 = (_e1777[1][0] - _e1777[0][0]);
                                                                            let _e1944 = (_e1777[1][1] - _e1777[0][1]);
                                                                            let _e1945 = (_e1777[1][2] - _e1777[0][2]);
                                                                            let _e1946 = vec3<f32>(_e1943, _e1944, _e1945);
                                                                            let _e1947 = (_e1777[2][0] - _e1777[1][0]);
                                                                            let _e1948 = (_e1777[2][1] - _e1777[1][1]);
                                                                            let _e1949 = (_e1777[2][2] - _e1777[1][2]);
                                                                            let _e1950 = vec3<f32>(_e1947, _e1948, _e1949);
                                                                            let _e1951 = (_e1777[0][0] - _e1777[2][0]);
                                                                            let _e1952 = (_e1777[0][1] - _e1777[2][1]);
                                                                            let _e1953 = (_e1777[0][2] - _e1777[2][2]);
                                                                            let _e1954 = vec3<f32>(_e1951, _e1952, _e1953);
                                                                            let _e1957 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                                            let _e1960 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                                            let _e1962 = select(_e1960, _e1957, (_e1957 > _e1960));
                                                                            let _e1965 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                                            let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                                            let _e1970 = bitcast<f32>((bitcast<u32>(_e1947) & 2147483647u));
                                                                            let _e1973 = bitcast<f32>((bitcast<u32>(_e1948) & 2147483647u));
                                                                            let _e1975 = select(_e1973, _e1970, (_e1970 > _e1973));
                                                                            let _e1978 = bitcast<f32>((bitcast<u32>(_e1949) & 2147483647u));
                                                                            let _e1980 = select(_e1978, _e1975, (_e1975 > _e1978));
                                                                            let _e1983 = bitcast<f32>((bitcast<u32>(_e1951) & 2147483647u));
                                                                            let _e1986 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
                                                                            let _e1988 = select(_e1986, _e1983, (_e1983 > _e1986));
                                                                            let _e1991 = bitcast<f32>((bitcast<u32>(_e1953) & 2147483647u));
                                                                            let _e1993 = select(_e1991, _e1988, (_e1988 > _e1991));
                                                                            let _e1995 = select(_e1980, _e1967, (_e1967 > _e1980));
                                                                            let _e1997 = select(_e1993, _e1995, (_e1995 > _e1993));
                                                                            if (_e1967 == _e1997) {
                                                                                phi_2857_ = _e1804;
                                                                                phi_2858_ = _e1801;
                                                                                phi_2859_ = _e1791;
                                                                                phi_2860_ = _e1788;
                                                                                phi_2861_ = _e1940;
                                                                                phi_2862_ = _e1954;
                                                                                phi_2863_ = _e1950;
                                                                                phi_2864_ = _e1946;
                                                                            } else {
                                                                                let _e1999 = (_e1980 == _e1997);
                                                                                let _e2004 = vec3(_e1999);
                                                                                phi_2857_ = select(_e1791, _e1817, _e1999);
                                                                                phi_2858_ = select(_e1788, _e1814, _e1999);
                                                                                phi_2859_ = select(_e1817, _e1804, _e1999);
                                                                                phi_2860_ = select(_e1814, _e1801, _e1999);
                                                                                phi_2861_ = select(_e1942, _e1941, _e2004);
                                                                                phi_2862_ = select(_e1950, _e1946, _e2004);
                                                                                phi_2863_ = select(_e1946, _e1954, _e2004);
                                                                                phi_2864_ = select(_e1954, _e1950, _e2004);
                                                                            }
                                                                            let _e2010 = phi_2857_;
                                                                            let _e2012 = phi_2858_;
                                                                            let _e2014 = phi_2859_;
                                                                            let _e2016 = phi_2860_;
                                                                            let _e2018 = phi_2861_;
                                                                            let _e2020 = phi_2862_;
                                                                            let _e2022 = phi_2863_;
                                                                            let _e2024 = phi_2864_;
                                                                            let _e2031 = ((_e2022.y * _e2020.z) - (_e2020.y * _e2022.z));
                                                                            let _e2036 = ((_e2022.z * _e2020.x) - (_e2020.z * _e2022.x));
                                                                            let _e2039 = ((_e2022.x * _e2020.y) - (_e2020.x * _e2022.y));
                                                                            if (_e1839 >= _e1843) {
                                                                                phi_2901_ = select(true, false, (_e1839 >= _e1847));
                                                                            } else {
                                                                                phi_2901_ = true;
                                                                            }
                                                                            let _e2044 = phi_2901_;
                                                                            if _e2044 {
                                                                                phi_2910_ = select(_e1942, _e1941, vec3((_e1843 >= _e1847)));
                                                                            } else {
                                                                                phi_2910_ = _e1940;
                                                                            }
                                                                            let _e2049 = phi_2910_;
                                                                            let _e2060 = (((_e2031 * (_e2049.x - _e486)) + (_e2036 * (_e2049.y - _e553))) + (_e2039 * (_e2049.z - _e619)));
                                                                            let _e2065 = (((_e2031 * _e526) + (_e2036 * _e592)) + (_e2039 * _e658));
                                                                            let _e2066 = (_e2012 - _e2016);
                                                                            let _e2067 = (_e2010 - _e2014);
                                                                            let _e2075 = (-(((_e2016 * _e2066) + (_e2014 * _e2067))) / ((_e2066 * _e2066) + (_e2067 * _e2067)));
                                                                            let _e2077 = select(1f, _e2075, (_e2075 < 1f));
                                                                            let _e2079 = select(0f, _e2077, (_e2077 > 0f));
                                                                            let _e2092 = ((_e2018.x + (_e2024.x * _e2079)) - _e486);
                                                                            let _e2093 = ((_e2018.y + (_e2024.y * _e2079)) - _e553);
                                                                            let _e2094 = ((_e2018.z + (_e2024.z * _e2079)) - _e619);
                                                                            let _e2095 = (_e2094 / _e658);
                                                                            let _e2107 = bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u));
                                                                            let _e2110 = bitcast<f32>((bitcast<u32>(_e2093) & 2147483647u));
                                                                            let _e2112 = select(_e2110, _e2107, (_e2107 > _e2110));
                                                                            let _e2115 = bitcast<f32>((bitcast<u32>(_e2094) & 2147483647u));
                                                                            let _e2117 = select(_e2115, _e2112, (_e2112 > _e2115));
                                                                            let _e2123 = bitcast<f32>((bitcast<u32>(_e2031) & 2147483647u));
                                                                            let _e2126 = bitcast<f32>((bitcast<u32>(_e2036) & 2147483647u));
                                                                            let _e2128 = select(_e2126, _e2123, (_e2123 > _e2126));
                                                                            let _e2131 = bitcast<f32>((bitcast<u32>(_e2039) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e2031 * _e2092) + (_e2036 * _e2093)) + (_e2039 * _e2094)) - _e2060)) & 2147483647u)) <= ((0.0000009536743f * select(_e1997, _e2117, (_e2117 > _e1997))) * select(_e2131, _e2128, (_e2128 > _e2131)))) {
                                                                                let _e2141 = bitcast<f32>((bitcast<u32>(_e2022.x) & 2147483647u));
                                                                                let _e2144 = bitcast<f32>((bitcast<u32>(_e2022.y) & 2147483647u));
                                                                                let _e2146 = select(_e2144, _e2141, (_e2141 > _e2144));
                                                                                let _e2149 = bitcast<f32>((bitcast<u32>(_e2022.z) & 2147483647u));
                                                                                let _e2155 = bitcast<f32>((bitcast<u32>(_e2020.x) & 2147483647u));
                                                                                let _e2158 = bitcast<f32>((bitcast<u32>(_e2020.y) & 2147483647u));
                                                                                let _e2160 = select(_e2158, _e2155, (_e2155 > _e2158));
                                                                                let _e2163 = bitcast<f32>((bitcast<u32>(_e2020.z) & 2147483647u));
                                                                                let _e2167 = (bitcast<f32>((bitcast<u32>(_e2065) & 2147483647u)) > ((0.0000038146973f * select(_e2149, _e2146, (_e2146 > _e2149))) * select(_e2163, _e2160, (_e2160 > _e2163))));
                                                                                if _e2167 {
                                                                                    phi_3075_ = (_e2060 / _e2065);
                                                                                } else {
                                                                                    phi_3075_ = f32();
                                                                                }
                                                                                let _e2170 = phi_3075_;
                                                                                phi_3077_ = _e2170;
                                                                                phi_3078_ = select(true, false, _e2167);
                                                                            } else {
                                                                                phi_3077_ = f32();
                                                                                phi_3078_ = true;
                                                                            }
                                                                            let _e2173 = phi_3077_;
                                                                            let _e2175 = phi_3078_;
                                                                            if _e2175 {
                                                                                let _e2183 = (((_e2031 * (_e2092 - (_e526 * _e2095))) + (_e2036 * (_e2093 - (_e592 * _e2095)))) / _e2065);
                                                                                if (bitcast<f32>((bitcast<u32>(_e2183) & 2147483647u)) <= _e1997) {
                                                                                    phi_3098_ = (_e2095 + _e2183);
                                                                                } else {
                                                                                    phi_3098_ = _e2095;
                                                                                }
                                                                                let _e2190 = phi_3098_;
                                                                                phi_3099_ = _e2190;
                                                                            } else {
                                                                                phi_3099_ = _e2173;
                                                                            }
                                                                            let _e2192 = phi_3099_;
                                                                            let _e2194 = select(_e1930, _e2192, (_e2192 < _e1930));
                                                                            let _e2196 = select(_e1922, _e2194, (_e2194 > _e1922));
                                                                            if (_e2196 >= _e772) {
                                                                                let _e2198 = (_e2196 <= _e1330.member);
                                                                                if _e2198 {
                                                                                    let _e2199 = (1f / _e1849);
                                                                                    phi_3122_ = type_25(_e2196, (_e1843 * _e2199), (_e1847 * _e2199), _e1390);
                                                                                } else {
                                                                                    phi_3122_ = type_25();
                                                                                }
                                                                                let _e2204 = phi_3122_;
                                                                                phi_3124_ = _e2204;
                                                                                phi_3125_ = select(true, false, _e2198);
                                                                            } else {
                                                                                phi_3124_ = type_25();
                                                                                phi_3125_ = true;
                                                                            }
                                                                            let _e2207 = phi_3124_;
                                                                            let _e2209 = phi_3125_;
                                                                            if _e2209 {
                                                                                phi_3129_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_3129_ = _e2207;
                                                                            }
                                                                            let _e2211 = phi_3129_;
                                                                            phi_3130_ = _e2211;
                                                                        }
                                                                        let _e2213 = phi_3130_;
                                                                        phi_3131_ = _e2213;
                                                                        phi_3132_ = _e1939;
                                                                    }
                                                                    let _e2215 = phi_3131_;
                                                                    let _e2217 = phi_3132_;
                                                                    phi_3136_ = _e2215;
                                                                    phi_3137_ = _e2217;
                                                                }
                                                                let _e2219 = phi_3136_;
                                                                let _e2221 = phi_3137_;
                                                                phi_3138_ = _e2219;
                                                                phi_3139_ = _e1874;
                                                                phi_3140_ = _e2221;
                                                            }
                                                            let _e2223 = phi_3138_;
                                                            let _e2225 = phi_3139_;
                                                            let _e2227 = phi_3140_;
                                                            phi_3141_ = _e2223;
                                                            phi_3142_ = _e2225;
                                                            phi_3143_ = _e2227;
                                                        }
                                                        let _e2229 = phi_3141_;
                                                        let _e2231 = phi_3142_;
                                                        let _e2233 = phi_3143_;
                                                        phi_3151_ = _e2229;
                                                        phi_3152_ = select(_e2233, true, _e2231);
                                                    } else {
                                                        phi_3151_ = type_25();
                                                        phi_3152_ = true;
                                                    }
                                                    let _e2236 = phi_3151_;
                                                    let _e2238 = phi_3152_;
                                                    if _e2238 {
                                                        phi_3156_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3156_ = _e2236;
                                                    }
                                                    let _e2240 = phi_3156_;
                                                    if (_e2240.member_3 != 4294967295u) {
                                                        if (_e1390 == _e174) {
                                                            phi_3491_ = false;
                                                        } else {
                                                            let _e2244 = (_e1390 < arrayLength((&global_6.member)));
                                                            if _e2244 {
                                                                if _e2244 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e2246 = global_6.member[_e1390];
                                                                phi_3179_ = _e2246;
                                                            } else {
                                                                phi_3179_ = 4294967295u;
                                                            }
                                                            let _e2248 = phi_3179_;
                                                            let _e2249 = (_e2248 < arrayLength((&global_7.member)));
                                                            if _e2249 {
                                                                if _e2249 {
                                                                } else {
                                                                    phi_5036_ = true;
                                                                    break;
                                                                }
                                                                let _e2251 = global_7.member[_e2248];
                                                                phi_3193_ = _e2251;
                                                            } else {
                                                                phi_3193_ = 0i;
                                                            }
                                                            let _e2253 = phi_3193_;
                                                            let _e2254 = (_e2253 == 0i);
                                                            if _e2254 {
                                                                phi_3490_ = true;
                                                            } else {
                                                                if _e463 {
                                                                    phi_3216_ = vec3<f32>(_e1777[0][0], _e1777[0][1], _e1777[0][2]);
                                                                } else {
                                                                    if (_e439 == 1u) {
                                                                        phi_3215_ = vec3<f32>(_e1777[0][2], _e1777[0][0], _e1777[0][1]);
                                                                    } else {
                                                                        phi_3215_ = vec3<f32>(_e1777[0][1], _e1777[0][2], _e1777[0][0]);
                                                                    }
                                                                    let _e2259 = phi_3215_;
                                                                    phi_3216_ = _e2259;
                                                                }
                                                                let _e2262 = phi_3216_;
                                                                if _e463 {
                                                                    phi_3235_ = vec3<f32>(_e1777[1][0], _e1777[1][1], _e1777[1][2]);
                                                                } else {
                                                                    if (_e439 == 1u) {
                                                                        phi_3234_ = vec3<f32>(_e1777[1][2], _e1777[1][0], _e1777[1][1]);
                                                                    } else {
                                                                        phi_3234_ = vec3<f32>(_e1777[1][1], _e1777[1][2], _e1777[1][0]);
                                                                    }
                                                                    let _e2267 = phi_3234_;
                                                                    phi_3235_ = _e2267;
                                                                }
                                                                let _e2270 = phi_3235_;
                                                                if _e463 {
                                                                    phi_3254_ = vec3<f32>(_e1777[2][0], _e1777[2][1], _e1777[2][2]);
                                                                } else {
                                                                    if (_e439 == 1u) {
                                                                        phi_3253_ = vec3<f32>(_e1777[2][2], _e1777[2][0], _e1777[2][1]);
                                                                    } else {
                                                                        phi_3253_ = vec3<f32>(_e1777[2][1], _e1777[2][2], _e1777[2][0]);
                                                                    }
                                                                    let _e2275 = phi_3253_;
                                                                    phi_3254_ = _e2275;
                                                                }
                                                                let _e2278 = phi_3254_;
                                                                let _e2281 = (_e2270.x - _e2262.x);
                                                                let _e2284 = (_e2270.y - _e2262.y);
                                                                let _e2287 = (_e2270.z - _e2262.z);
                                                                let _e2289 = (_e2278.x - _e2262.x);
                                                                let _e2291 = (_e2278.y - _e2262.y);
                                                                let _e2293 = (_e2278.z - _e2262.z);
                                                                if (_e306.member_1 == 1u) {
                                                                    phi_3290_ = (vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]) - _e2262);
                                                                } else {
                                                                    phi_3290_ = vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]);
                                                                }
                                                                let _e2308 = phi_3290_;
                                                                let _e2314 = bitcast<f32>((bitcast<u32>((_e2281 * _e2291)) ^ _e306.member_3[0]));
                                                                let _e2318 = bitcast<f32>((bitcast<u32>((_e2284 * _e2289)) ^ _e306.member_3[0]));
                                                                let _e2322 = bitcast<f32>((bitcast<u32>((_e2284 * _e2293)) ^ _e306.member_3[0]));
                                                                let _e2326 = bitcast<f32>((bitcast<u32>((_e2287 * _e2291)) ^ _e306.member_3[0]));
                                                                let _e2330 = bitcast<f32>((bitcast<u32>((_e2287 * _e2289)) ^ _e306.member_3[0]));
                                                                let _e2334 = bitcast<f32>((bitcast<u32>((_e2281 * _e2293)) ^ _e306.member_3[0]));
                                                                let _e2335 = (_e2322 - _e2326);
                                                                let _e2336 = (_e2330 - _e2334);
                                                                let _e2337 = (_e2314 - _e2318);
                                                                let _e2361 = (bitcast<f32>((bitcast<u32>(_e2322) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2326) & 2147483647u)));
                                                                let _e2368 = (bitcast<f32>((bitcast<u32>(_e2330) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2334) & 2147483647u)));
                                                                let _e2375 = (bitcast<f32>((bitcast<u32>(_e2314) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2318) & 2147483647u)));
                                                                if (_e306.member_2 == 0f) {
                                                                    phi_3472_ = 0f;
                                                                } else {
                                                                    let _e2405 = bitcast<f32>((bitcast<u32>(_e2335) & 2147483647u));
                                                                    let _e2408 = bitcast<f32>((bitcast<u32>(_e2336) & 2147483647u));
                                                                    let _e2411 = bitcast<f32>((bitcast<u32>(_e2337) & 2147483647u));
                                                                    let _e2413 = select(_e2411, _e2408, (_e2408 > _e2411));
                                                                    let _e2417 = select(_e2411, _e2408, (_e2408 < _e2411));
                                                                    let _e2421 = select(_e2408, _e2405, (_e2405 < _e2408));
                                                                    let _e2423 = select(_e2408, _e2405, (_e2405 > _e2408));
                                                                    let _e2425 = select(_e2411, _e2423, (_e2423 < _e2411));
                                                                    phi_3472_ = bitcast<f32>((bitcast<u32>((_e306.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2413, _e2405, (_e2405 > _e2413)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2425, _e2421, (_e2421 > _e2425)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2417, _e2405, (_e2405 < _e2417)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2361 + _e2368) + _e2375))) ^ _e306.member_3[0]))) * 1.0000005f)) ^ _e306.member_3[0])))) ^ _e306.member_3[0]));
                                                                }
                                                                let _e2452 = phi_3472_;
                                                                phi_3490_ = (_e2254 || !(((((bitcast<f32>((bitcast<u32>((_e2308.x * _e2335)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2308.y * _e2336)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2308.z * _e2337)) ^ _e306.member_3[0]))) * f32(-(_e2253))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2308.x) & 2147483647u)) * _e2361)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2308.y) & 2147483647u)) * _e2368)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2308.z) & 2147483647u)) * _e2375)) ^ _e306.member_3[0]))))) ^ _e306.member_3[0])) + _e2452) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2466 = phi_3490_;
                                                            phi_3491_ = _e2466;
                                                        }
                                                        let _e2468 = phi_3491_;
                                                        if _e2468 {
                                                            phi_3496_ = type_46(_e1330.member, true);
                                                        } else {
                                                            phi_3496_ = _e1330;
                                                        }
                                                        let _e2473 = phi_3496_;
                                                        phi_3497_ = _e2473;
                                                    } else {
                                                        phi_3497_ = _e1330;
                                                    }
                                                    let _e2475 = phi_3497_;
                                                    phi_1494_ = _e2475;
                                                } else {
                                                    phi_1494_ = type_46();
                                                }
                                                let _e2477 = phi_1494_;
                                                continue;
                                                continuing {
                                                    phi_1493_ = _e2477;
                                                    phi_1496_ = _e1345;
                                                    phi_5036_ = _e814;
                                                    break if !(_e1351);
                                                }
                                            }
                                            let _e2480 = phi_5036_;
                                            phi_5275_ = _e2480;
                                            if _e2480 {
                                                break;
                                            }
                                            let _e2482 = local_10;
                                            phi_5279_ = _e2480;
                                            let _e2728 = local_12;
                                            phi_4770_ = _e2728;
                                            phi_4771_ = false;
                                            phi_4772_ = select(_e857, 0u, _e2482.member_1);
                                            phi_4773_ = _e859;
                                        } else {
                                            if (_e859.member_1 >= _e106) {
                                                phi_4305_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e859.member_1 < _e106) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e872 = ((1u + _e439) % 4u);
                                                if (_e872 < 4u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e877 = global_5.member[_e859.member_1][_e872];
                                                let _e879 = (_e877 >> bitcast<u32>(11u));
                                                let _e881 = ((1u + _e438) % 4u);
                                                if (_e881 < 4u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e886 = global_5.member[_e859.member_1][_e881];
                                                let _e888 = (_e886 >> bitcast<u32>(11u));
                                                let _e890 = ((1u + _e440) % 4u);
                                                if (_e890 < 4u) {
                                                } else {
                                                    phi_5275_ = true;
                                                    break;
                                                }
                                                let _e895 = global_5.member[_e859.member_1][_e890];
                                                let _e897 = (_e895 >> bitcast<u32>(11u));
                                                let _e920 = (bitcast<f32>((bitcast<u32>((_e859.member.member_1.x - _e859.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e921 = (bitcast<f32>((bitcast<u32>((_e859.member.member_1.y - _e859.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e922 = (bitcast<f32>((bitcast<u32>((_e859.member.member_1.z - _e859.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e924 = select(_e165, _e920, (_e920 > _e165));
                                                let _e926 = select(_e165, _e921, (_e921 > _e165));
                                                let _e928 = select(_e165, _e922, (_e922 > _e165));
                                                let _e959 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e877 & 1023u))) - 8388608f) * _e924));
                                                let _e964 = (bitcast<i32>((_e877 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e967 = bitcast<f32>((_e959 & bitcast<u32>(_e964)));
                                                let _e968 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e886 & 1023u))) - 8388608f) * _e926));
                                                let _e973 = (bitcast<i32>((_e886 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e976 = bitcast<f32>((_e968 & bitcast<u32>(_e973)));
                                                let _e977 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e895 & 1023u))) - 8388608f) * _e928));
                                                let _e982 = (bitcast<i32>((_e895 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e985 = bitcast<f32>((_e977 & bitcast<u32>(_e982)));
                                                let _e989 = bitcast<f32>((_e959 & bitcast<u32>(~(_e964))));
                                                let _e993 = bitcast<f32>((_e968 & bitcast<u32>(~(_e973))));
                                                let _e997 = bitcast<f32>((_e977 & bitcast<u32>(~(_e982))));
                                                let _e998 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e879 & 1023u))) - 8388608f) * _e924));
                                                let _e1003 = (bitcast<i32>((_e879 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1006 = bitcast<f32>((_e998 & bitcast<u32>(_e1003)));
                                                let _e1007 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e888 & 1023u))) - 8388608f) * _e926));
                                                let _e1012 = (bitcast<i32>((_e888 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1015 = bitcast<f32>((_e1007 & bitcast<u32>(_e1012)));
                                                let _e1016 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e897 & 1023u))) - 8388608f) * _e928));
                                                let _e1021 = (bitcast<i32>((_e897 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1024 = bitcast<f32>((_e1016 & bitcast<u32>(_e1021)));
                                                let _e1028 = bitcast<f32>((_e998 & bitcast<u32>(~(_e1003))));
                                                let _e1032 = bitcast<f32>((_e1007 & bitcast<u32>(~(_e1012))));
                                                let _e1036 = bitcast<f32>((_e1016 & bitcast<u32>(~(_e1021))));
                                                let _e1037 = (_e859.member.member.x + _e967);
                                                let _e1038 = (_e859.member.member.y + _e976);
                                                let _e1039 = (_e859.member.member.z + _e985);
                                                let _e1042 = (_e859.member.member_1.x - _e1006);
                                                let _e1043 = (_e859.member.member_1.y - _e1015);
                                                let _e1044 = (_e859.member.member_1.z - _e1024);
                                                let _e1063 = (_e1042 - _e1037);
                                                let _e1064 = (_e1043 - _e1038);
                                                let _e1065 = (_e1044 - _e1039);
                                                let _e1067 = select(_e1064, _e1063, (_e1063 > _e1064));
                                                let _e1069 = select(_e1065, _e1067, (_e1067 > _e1065));
                                                if (_e1069 < (1024f * _e165)) {
                                                    phi_4006_ = 0u;
                                                } else {
                                                    phi_4006_ = select(2u, 1u, (_e1069 < (2097152f * _e165)));
                                                }
                                                let _e1076 = phi_4006_;
                                                switch bitcast<i32>(_e1076) {
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
                                                let _e1079 = phi_4012_;
                                                let _e1085 = global_5.member[_e859.member_1][0u];
                                                let _e1089 = global_5.member[_e859.member_1][1u];
                                                let _e1093 = global_5.member[_e859.member_1][2u];
                                                let _e1097 = global_5.member[_e859.member_1][3u];
                                                let _e1109 = (((_e1089 >> bitcast<u32>(22i)) | ((_e1093 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1097 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1110 = (_e1085 & 268435455u);
                                                let _e1111 = (_e1109 & 268435455u);
                                                let _e1114 = ((_e1085 >> bitcast<u32>(28u)) & 7u);
                                                let _e1122 = ((_e1085 >> bitcast<u32>(31i)) | (((_e1109 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1123 = (_e1114 != 0u);
                                                if (_e1114 == 0u) {
                                                    phi_4267_ = _e1110;
                                                } else {
                                                    if (_e1114 == 7u) {
                                                        phi_4266_ = 2147483648u;
                                                    } else {
                                                        phi_4266_ = ((2147483648u | (_e1114 << bitcast<u32>(28u))) | (_e1111 & 268435455u));
                                                    }
                                                    let _e1132 = phi_4266_;
                                                    phi_4267_ = _e1132;
                                                }
                                                let _e1134 = phi_4267_;
                                                if _e1123 {
                                                    let _e1135 = (_e1114 != 7u);
                                                    if _e1135 {
                                                        phi_4277_ = (_e1111 + (_e1114 * ((3u * _e1079) + 1u)));
                                                    } else {
                                                        phi_4277_ = u32();
                                                    }
                                                    let _e1139 = phi_4277_;
                                                    phi_4279_ = _e1139;
                                                    phi_4280_ = select(true, false, _e1135);
                                                } else {
                                                    phi_4279_ = u32();
                                                    phi_4280_ = true;
                                                }
                                                let _e1142 = phi_4279_;
                                                let _e1144 = phi_4280_;
                                                if (_e1122 == 0u) {
                                                    phi_4301_ = (_e1110 + select(0u, 1u, !(_e1123)));
                                                } else {
                                                    if (_e1122 == 7u) {
                                                        phi_4300_ = 2147483648u;
                                                    } else {
                                                        phi_4300_ = ((2147483648u | (_e1122 << bitcast<u32>(28u))) | (select(_e1142, _e1111, _e1144) & 268435455u));
                                                    }
                                                    let _e1157 = phi_4300_;
                                                    phi_4301_ = _e1157;
                                                }
                                                let _e1159 = phi_4301_;
                                                phi_4305_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e1037, (_e859.member.member.x + _e989), _e1042, (_e859.member.member_1.x - _e1028)), vec4<f32>(_e1038, (_e859.member.member.y + _e993), _e1043, (_e859.member.member_1.y - _e1032)), vec4<f32>(_e1039, (_e859.member.member.z + _e997), _e1044, (_e859.member.member_1.z - _e1036))), type_58(type_34((_e859.member.member + vec4<f32>(_e967, _e976, _e985, 0f)), (_e859.member.member_1 - vec4<f32>(_e1006, _e1015, _e1024, 0f))), _e1134), type_58(type_34((_e859.member.member + vec4<f32>(_e989, _e993, _e997, 0f)), (_e859.member.member_1 - vec4<f32>(_e1028, _e1032, _e1036, 0f))), _e1159));
                                            }
                                            let _e1164 = phi_4305_;
                                            let _e1176 = ((_e1164.member[0].x - _e524) * _e529);
                                            let _e1177 = ((_e1164.member[0].y - _e524) * _e529);
                                            let _e1178 = ((_e1164.member[0].z - _e525) * _e529);
                                            let _e1179 = ((_e1164.member[0].w - _e525) * _e529);
                                            let _e1189 = ((_e1164.member[1].x - _e590) * _e595);
                                            let _e1190 = ((_e1164.member[1].y - _e590) * _e595);
                                            let _e1191 = ((_e1164.member[1].z - _e591) * _e595);
                                            let _e1192 = ((_e1164.member[1].w - _e591) * _e595);
                                            let _e1202 = ((_e1164.member[2].x - _e656) * _e661);
                                            let _e1203 = ((_e1164.member[2].y - _e656) * _e661);
                                            let _e1204 = ((_e1164.member[2].z - _e657) * _e661);
                                            let _e1205 = ((_e1164.member[2].w - _e657) * _e661);
                                            let _e1207 = select(_e1204, _e1202, (_e1202 < _e1204));
                                            let _e1209 = select(_e1205, _e1203, (_e1203 < _e1205));
                                            let _e1211 = select(_e1204, _e1202, (_e1202 > _e1204));
                                            let _e1213 = select(_e1205, _e1203, (_e1203 > _e1205));
                                            let _e1215 = select(_e1178, _e1176, (_e1176 < _e1178));
                                            let _e1217 = select(_e1179, _e1177, (_e1177 < _e1179));
                                            let _e1219 = select(_e1191, _e1189, (_e1189 < _e1191));
                                            let _e1221 = select(_e1192, _e1190, (_e1190 < _e1192));
                                            let _e1223 = select(_e1219, _e1215, (_e1215 > _e1219));
                                            let _e1225 = select(_e1221, _e1217, (_e1217 > _e1221));
                                            let _e1227 = select(_e1207, _e1223, (_e1223 > _e1207));
                                            let _e1229 = select(_e1209, _e1225, (_e1225 > _e1209));
                                            let _e1231 = select(_e1178, _e1176, (_e1176 > _e1178));
                                            let _e1233 = select(_e1179, _e1177, (_e1177 > _e1179));
                                            let _e1235 = select(_e1191, _e1189, (_e1189 > _e1191));
                                            let _e1237 = select(_e1192, _e1190, (_e1190 > _e1192));
                                            let _e1239 = select(_e1235, _e1231, (_e1231 < _e1235));
                                            let _e1241 = select(_e1237, _e1233, (_e1233 < _e1237));
                                            let _e1246 = -(_e1207);
                                            let _e1247 = -(_e1209);
                                            let _e1254 = (select(_e1211, _e1239, (_e1239 < _e1211)) + (select(_e1246, _e1211, (_e1211 > _e1246)) * 0.0000019073523f));
                                            let _e1255 = (select(_e1213, _e1241, (_e1241 < _e1213)) + (select(_e1247, _e1213, (_e1213 > _e1247)) * 0.0000019073523f));
                                            let _e1257 = select(_e772, _e1227, (_e1227 > _e772));
                                            let _e1259 = select(_e772, _e1229, (_e1229 > _e772));
                                            let _e1264 = (_e1257 <= select(_e816.member, _e1254, (_e1254 < _e816.member)));
                                            let _e1265 = (_e1259 <= select(_e816.member, _e1255, (_e1255 < _e816.member)));
                                            let _e1266 = (_e1257 <= _e1259);
                                            if _e1264 {
                                                if _e1265 {
                                                    if _e1266 {
                                                        phi_4667_ = _e1164.member_2;
                                                    } else {
                                                        phi_4667_ = _e1164.member_1;
                                                    }
                                                    let _e1270 = phi_4667_;
                                                    let _e1292 = (_e857 % 128u);
                                                    let _e1293 = (_e1292 < 128u);
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1292] = _e1270.member_1;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1292] = _e1270.member.member.x;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1292] = _e1270.member.member.y;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1292] = _e1270.member.member.z;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1292] = _e1270.member.member_1.x;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1292] = _e1270.member.member_1.y;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1292] = _e1270.member.member_1.z;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5275_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1292] = select(_e1259, _e1257, !(_e1266));
                                                    if _e1266 {
                                                        phi_4744_ = _e1164.member_1;
                                                    } else {
                                                        phi_4744_ = _e1164.member_2;
                                                    }
                                                    let _e1306 = phi_4744_;
                                                    phi_4745_ = (_e857 + 1u);
                                                    phi_4746_ = _e1306;
                                                } else {
                                                    phi_4745_ = u32();
                                                    phi_4746_ = type_58();
                                                }
                                                let _e1308 = phi_4745_;
                                                let _e1310 = phi_4746_;
                                                phi_4748_ = _e1308;
                                                phi_4749_ = _e1310;
                                                phi_4750_ = select(true, false, _e1265);
                                            } else {
                                                phi_4748_ = u32();
                                                phi_4749_ = type_58();
                                                phi_4750_ = true;
                                            }
                                            let _e1313 = phi_4748_;
                                            let _e1315 = phi_4749_;
                                            let _e1317 = phi_4750_;
                                            if _e1317 {
                                                if _e1264 {
                                                    phi_4759_ = _e1164.member_1;
                                                } else {
                                                    phi_4759_ = _e1164.member_2;
                                                }
                                                let _e1321 = phi_4759_;
                                                phi_4764_ = select(_e1265, true, _e1264);
                                                phi_4766_ = _e1321;
                                            } else {
                                                phi_4764_ = _e855;
                                                phi_4766_ = _e1315;
                                            }
                                            let _e1324 = phi_4764_;
                                            let _e1326 = phi_4766_;
                                            phi_5279_ = _e814;
                                            phi_4770_ = _e816;
                                            phi_4771_ = _e1324;
                                            phi_4772_ = select(_e1313, _e857, _e1317);
                                            phi_4773_ = _e1326;
                                        }
                                        let _e2486 = phi_5279_;
                                        let _e2488 = phi_4770_;
                                        let _e2490 = phi_4771_;
                                        let _e2492 = phi_4772_;
                                        let _e2494 = phi_4773_;
                                        phi_5278_ = _e2486;
                                        phi_4774_ = _e2488;
                                        phi_4775_ = _e2490;
                                        phi_4776_ = (_e820 - 1u);
                                        phi_4777_ = _e2492;
                                        phi_4778_ = _e2494;
                                    } else {
                                        phi_5278_ = _e814;
                                        phi_4774_ = _e816;
                                        phi_4775_ = _e855;
                                        phi_4776_ = _e820;
                                        phi_4777_ = _e857;
                                        phi_4778_ = _e859;
                                    }
                                    let _e2496 = phi_5278_;
                                    let _e2498 = phi_4774_;
                                    let _e2500 = phi_4775_;
                                    let _e2502 = phi_4776_;
                                    let _e2504 = phi_4777_;
                                    let _e2506 = phi_4778_;
                                    phi_5277_ = _e2496;
                                    phi_4779_ = _e2498;
                                    phi_4780_ = _e2500;
                                    phi_4781_ = _e2502;
                                    phi_4782_ = _e2504;
                                    phi_4783_ = _e2506;
                                } else {
                                    phi_5277_ = _e814;
                                    phi_4779_ = type_46();
                                    phi_4780_ = bool();
                                    phi_4781_ = u32();
                                    phi_4782_ = u32();
                                    phi_4783_ = type_58();
                                }
                                let _e2508 = phi_5277_;
                                let _e2510 = phi_4779_;
                                let _e2512 = phi_4780_;
                                let _e2514 = phi_4781_;
                                let _e2516 = phi_4782_;
                                let _e2518 = phi_4783_;
                                phi_5276_ = _e2508;
                                phi_1367_ = _e2510;
                                phi_1370_ = _e2512;
                                phi_1372_ = _e2514;
                                phi_1374_ = _e2516;
                                phi_1376_ = _e2518;
                                phi_4784_ = _e828;
                            } else {
                                phi_5276_ = _e814;
                                phi_1367_ = type_46();
                                phi_1370_ = bool();
                                phi_1372_ = u32();
                                phi_1374_ = u32();
                                phi_1376_ = type_58();
                                phi_4784_ = false;
                            }
                            let _e2520 = phi_5276_;
                            let _e2522 = phi_1367_;
                            let _e2524 = phi_1370_;
                            let _e2526 = phi_1372_;
                            let _e2528 = phi_1374_;
                            let _e2530 = phi_1376_;
                            let _e2532 = phi_4784_;
                            continue;
                            continuing {
                                phi_5042_ = _e2520;
                                phi_1366_ = _e2522;
                                phi_1369_ = _e2524;
                                phi_1371_ = _e2526;
                                phi_1373_ = _e2528;
                                phi_1375_ = _e2530;
                                phi_5275_ = _e2520;
                                break if !(_e2532);
                            }
                        }
                        let _e2535 = phi_5275_;
                        if _e2535 {
                            break;
                        }
                        let _e2537 = local_11;
                        if _e2537.member_1 {
                        } else {
                            if _e307 {
                            } else {
                                break;
                            }
                            let _e2541 = global_2.member[_e153];
                            if _e168 {
                            } else {
                                break;
                            }
                            let _e2545 = global_9.member[_e153].member_1;
                            if _e307 {
                            } else {
                                break;
                            }
                            global_2.member[_e153] = type_27(_e2541.member, _e2541.member_1, _e2541.member_2, array<f32, 3>((_e2541.member_3[0] + (_e2545[0] * _e2541.member_1[0])), (_e2541.member_3[1] + (_e2545[1] * _e2541.member_1[1])), (_e2541.member_3[2] + (_e2545[2] * _e2541.member_1[2]))), _e2541.member_4);
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
fn trace_shadows_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
