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
    var phi_5045_: bool;
    var phi_1366_: type_46;
    var phi_1369_: u32;
    var phi_1371_: bool;
    var phi_1373_: u32;
    var phi_1375_: type_58;
    var phi_1386_: bool;
    var phi_1472_: bool;
    var phi_1473_: u32;
    var phi_1474_: type_58;
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
    var phi_5039_: bool;
    var phi_5369_: bool;
    var phi_3498_: type_46;
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
    var phi_4777_: type_46;
    var phi_4778_: u32;
    var phi_4779_: bool;
    var phi_4780_: u32;
    var phi_4781_: type_58;
    var phi_5280_: bool;
    var phi_4782_: type_46;
    var phi_4783_: u32;
    var phi_4784_: bool;
    var phi_4785_: u32;
    var phi_4786_: type_58;
    var phi_5279_: bool;
    var phi_1367_: type_46;
    var phi_1370_: u32;
    var phi_1372_: bool;
    var phi_1374_: u32;
    var phi_1376_: type_58;
    var phi_4787_: bool;
    var phi_5278_: bool;
    var local_10: type_46;
    var local_11: type_46;

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
                        phi_5045_ = false;
                        phi_1366_ = type_46(_e770, false);
                        phi_1369_ = ((3u * _e106) + 1u);
                        phi_1371_ = (_e772 <= _e770);
                        phi_1373_ = 0u;
                        phi_1375_ = type_58(type_34(vec4<f32>((f32(_e779) * _e165), (f32(_e785) * _e165), (f32(_e791) * _e165), 0f), vec4<f32>((f32(_e796) * _e165), (f32(_e800) * _e165), (f32(_e804) * _e165), 0f)), select(0u, 2147483648u, (_e106 == 0u)));
                        loop {
                            let _e814 = phi_5045_;
                            let _e816 = phi_1366_;
                            let _e818 = phi_1369_;
                            let _e820 = phi_1371_;
                            let _e822 = phi_1373_;
                            let _e824 = phi_1375_;
                            local_10 = _e816;
                            if _e820 {
                                phi_1386_ = true;
                            } else {
                                phi_1386_ = (_e822 > 0u);
                            }
                            let _e827 = phi_1386_;
                            if _e827 {
                                let _e828 = (_e818 > 0u);
                                if _e828 {
                                    if _e820 {
                                        phi_1472_ = _e820;
                                        phi_1473_ = _e822;
                                        phi_1474_ = _e824;
                                    } else {
                                        let _e829 = (_e822 - 1u);
                                        let _e830 = (_e829 % 128u);
                                        let _e831 = (_e830 < 128u);
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e833 = local_7[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e835 = local_6[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e837 = local_5[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e839 = local_4[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e841 = local_3[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e843 = local_2[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
                                            break;
                                        }
                                        let _e848 = local_8[_e830];
                                        if _e831 {
                                        } else {
                                            phi_5278_ = true;
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
                                        let _e863 = ((_e859.member_1 & 2147483648u) != 0u);
                                        let _e864 = (_e859.member_1 & 268435455u);
                                        if _e863 {
                                            phi_1493_ = _e816;
                                            phi_1496_ = type_8(0u, ((_e859.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e871 = phi_1493_;
                                                let _e873 = phi_1496_;
                                                local_11 = _e871;
                                                if (_e873.member < _e873.member_1) {
                                                    phi_1497_ = type_8((_e873.member + 1u), _e873.member_1);
                                                    phi_1519_ = type_8(1u, _e873.member);
                                                } else {
                                                    phi_1497_ = _e873;
                                                    phi_1519_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e886 = phi_1497_;
                                                let _e888 = phi_1519_;
                                                let _e892 = (bitcast<i32>(_e888.member) != 0i);
                                                if _e892 {
                                                    let _e897 = (_e859.member.member_1.x - _e859.member.member.x);
                                                    let _e900 = (_e859.member.member_1.y - _e859.member.member.y);
                                                    let _e903 = (_e859.member.member_1.z - _e859.member.member.z);
                                                    let _e905 = select(_e900, _e897, (_e897 > _e900));
                                                    let _e907 = select(_e903, _e905, (_e905 > _e903));
                                                    let _e909 = (_e907 < (1024f * _e165));
                                                    if _e909 {
                                                        phi_1560_ = 0u;
                                                    } else {
                                                        phi_1560_ = select(2u, 1u, (_e907 < (2097152f * _e165)));
                                                    }
                                                    let _e914 = phi_1560_;
                                                    switch bitcast<i32>(_e914) {
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
                                                    let _e917 = phi_1566_;
                                                    switch bitcast<i32>(_e914) {
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
                                                    let _e924 = phi_1576_;
                                                    let _e926 = ((_e864 + (_e888.member_1 * ((3u * _e917) + 1u))) + (3u * _e924));
                                                    let _e927 = (_e926 < _e109);
                                                    if _e927 {
                                                        if _e927 {
                                                        } else {
                                                            phi_5039_ = true;
                                                            break;
                                                        }
                                                        let _e929 = global_10.member[_e926];
                                                        phi_1592_ = _e929;
                                                    } else {
                                                        phi_1592_ = 4294967295u;
                                                    }
                                                    let _e931 = phi_1592_;
                                                    if _e909 {
                                                        phi_1625_ = 0u;
                                                    } else {
                                                        phi_1625_ = select(2u, 1u, (_e907 < (2097152f * _e165)));
                                                    }
                                                    let _e936 = phi_1625_;
                                                    switch bitcast<i32>(_e936) {
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
                                                    let _e939 = phi_1631_;
                                                    let _e943 = (_e864 + (_e888.member_1 * ((3u * _e939) + 1u)));
                                                    switch bitcast<i32>(_e936) {
                                                        case 0: {
                                                            let _e1218 = (_e943 < _e109);
                                                            if _e1218 {
                                                                if _e1218 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1220 = global_10.member[_e943];
                                                                phi_1658_ = _e1220;
                                                            } else {
                                                                phi_1658_ = 0u;
                                                            }
                                                            let _e1222 = phi_1658_;
                                                            let _e1224 = ((10u * _e439) & 31u);
                                                            let _e1234 = ((10u * _e438) & 31u);
                                                            let _e1244 = ((10u * _e440) & 31u);
                                                            let _e1254 = (_e943 + 1u);
                                                            let _e1255 = (_e1254 < _e109);
                                                            if _e1255 {
                                                                if _e1255 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1257 = global_10.member[_e1254];
                                                                phi_1707_ = _e1257;
                                                            } else {
                                                                phi_1707_ = 0u;
                                                            }
                                                            let _e1259 = phi_1707_;
                                                            let _e1285 = (_e943 + 2u);
                                                            let _e1286 = (_e1285 < _e109);
                                                            if _e1286 {
                                                                if _e1286 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1288 = global_10.member[_e1285];
                                                                phi_1756_ = _e1288;
                                                            } else {
                                                                phi_1756_ = 0u;
                                                            }
                                                            let _e1290 = phi_1756_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | ((_e1222 >> bitcast<u32>(_e1224)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | ((_e1222 >> bitcast<u32>(_e1234)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | ((_e1222 >> bitcast<u32>(_e1244)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | ((_e1259 >> bitcast<u32>(_e1224)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | ((_e1259 >> bitcast<u32>(_e1234)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | ((_e1259 >> bitcast<u32>(_e1244)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | ((_e1290 >> bitcast<u32>(_e1224)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | ((_e1290 >> bitcast<u32>(_e1234)) & 1023u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | ((_e1290 >> bitcast<u32>(_e1244)) & 1023u))) - 8388608f) * _e165))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1032 = (_e943 < _e109);
                                                            if _e1032 {
                                                                if _e1032 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1034 = global_10.member[_e943];
                                                                phi_1805_ = _e1034;
                                                            } else {
                                                                phi_1805_ = 0u;
                                                            }
                                                            let _e1036 = phi_1805_;
                                                            let _e1037 = (_e943 + 1u);
                                                            let _e1038 = (_e1037 < _e109);
                                                            if _e1038 {
                                                                if _e1038 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1040 = global_10.member[_e1037];
                                                                phi_1820_ = _e1040;
                                                            } else {
                                                                phi_1820_ = 0u;
                                                            }
                                                            let _e1042 = phi_1820_;
                                                            let _e1043 = (_e439 == 1u);
                                                            if _e1043 {
                                                                phi_1830_ = ((_e1036 >> bitcast<u32>(21i)) | (_e1042 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1830_ = (_e1042 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1052 = phi_1830_;
                                                            let _e1060 = (_e438 == 1u);
                                                            if _e1060 {
                                                                phi_1851_ = ((_e1036 >> bitcast<u32>(21i)) | (_e1042 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1851_ = (_e1042 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1069 = phi_1851_;
                                                            let _e1077 = (_e440 == 1u);
                                                            if _e1077 {
                                                                phi_1872_ = ((_e1036 >> bitcast<u32>(21i)) | (_e1042 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1872_ = (_e1042 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1086 = phi_1872_;
                                                            let _e1095 = (_e943 + 2u);
                                                            let _e1096 = (_e1095 < _e109);
                                                            if _e1096 {
                                                                if _e1096 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1098 = global_10.member[_e1095];
                                                                phi_1902_ = _e1098;
                                                            } else {
                                                                phi_1902_ = 0u;
                                                            }
                                                            let _e1100 = phi_1902_;
                                                            let _e1101 = (_e943 + 3u);
                                                            let _e1102 = (_e1101 < _e109);
                                                            if _e1102 {
                                                                if _e1102 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1104 = global_10.member[_e1101];
                                                                phi_1917_ = _e1104;
                                                            } else {
                                                                phi_1917_ = 0u;
                                                            }
                                                            let _e1106 = phi_1917_;
                                                            if _e1043 {
                                                                phi_1927_ = ((_e1100 >> bitcast<u32>(21i)) | (_e1106 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1927_ = (_e1106 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1115 = phi_1927_;
                                                            if _e1060 {
                                                                phi_1948_ = ((_e1100 >> bitcast<u32>(21i)) | (_e1106 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1948_ = (_e1106 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1131 = phi_1948_;
                                                            if _e1077 {
                                                                phi_1969_ = ((_e1100 >> bitcast<u32>(21i)) | (_e1106 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1969_ = (_e1106 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1147 = phi_1969_;
                                                            let _e1156 = (_e943 + 4u);
                                                            let _e1157 = (_e1156 < _e109);
                                                            if _e1157 {
                                                                if _e1157 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1159 = global_10.member[_e1156];
                                                                phi_1999_ = _e1159;
                                                            } else {
                                                                phi_1999_ = 0u;
                                                            }
                                                            let _e1161 = phi_1999_;
                                                            let _e1162 = (_e943 + 5u);
                                                            let _e1163 = (_e1162 < _e109);
                                                            if _e1163 {
                                                                if _e1163 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1165 = global_10.member[_e1162];
                                                                phi_2014_ = _e1165;
                                                            } else {
                                                                phi_2014_ = 0u;
                                                            }
                                                            let _e1167 = phi_2014_;
                                                            if _e1043 {
                                                                phi_2024_ = ((_e1161 >> bitcast<u32>(21i)) | (_e1167 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2024_ = (_e1167 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1176 = phi_2024_;
                                                            if _e1060 {
                                                                phi_2045_ = ((_e1161 >> bitcast<u32>(21i)) | (_e1167 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2045_ = (_e1167 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1192 = phi_2045_;
                                                            if _e1077 {
                                                                phi_2066_ = ((_e1161 >> bitcast<u32>(21i)) | (_e1167 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2066_ = (_e1167 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1208 = phi_2066_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1052, _e1036, _e463) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1069, _e1036, _e530) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1086, _e1036, _e596) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1115, _e1100, _e463) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1131, _e1100, _e530) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1147, _e1100, _e596) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e859.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1176, _e1161, _e463) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1192, _e1161, _e530) & 2097151u))) - 8388608f) * _e165)), (_e859.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1208, _e1161, _e596) & 2097151u))) - 8388608f) * _e165))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e945 = (_e943 + _e439);
                                                            let _e946 = (_e945 < _e109);
                                                            if _e946 {
                                                                if _e946 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e948 = global_10.member[_e945];
                                                                phi_2097_ = _e948;
                                                            } else {
                                                                phi_2097_ = 0u;
                                                            }
                                                            let _e950 = phi_2097_;
                                                            let _e954 = (_e943 + _e438);
                                                            let _e955 = (_e954 < _e109);
                                                            if _e955 {
                                                                if _e955 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e957 = global_10.member[_e954];
                                                                phi_2115_ = _e957;
                                                            } else {
                                                                phi_2115_ = 0u;
                                                            }
                                                            let _e959 = phi_2115_;
                                                            let _e963 = (_e943 + _e440);
                                                            let _e964 = (_e963 < _e109);
                                                            if _e964 {
                                                                if _e964 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e966 = global_10.member[_e963];
                                                                phi_2133_ = _e966;
                                                            } else {
                                                                phi_2133_ = 0u;
                                                            }
                                                            let _e968 = phi_2133_;
                                                            let _e973 = (_e943 + 3u);
                                                            let _e974 = (_e973 + _e439);
                                                            let _e975 = (_e974 < _e109);
                                                            if _e975 {
                                                                if _e975 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e977 = global_10.member[_e974];
                                                                phi_2156_ = _e977;
                                                            } else {
                                                                phi_2156_ = 0u;
                                                            }
                                                            let _e979 = phi_2156_;
                                                            let _e983 = (_e973 + _e438);
                                                            let _e984 = (_e983 < _e109);
                                                            if _e984 {
                                                                if _e984 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e986 = global_10.member[_e983];
                                                                phi_2174_ = _e986;
                                                            } else {
                                                                phi_2174_ = 0u;
                                                            }
                                                            let _e988 = phi_2174_;
                                                            let _e992 = (_e973 + _e440);
                                                            let _e993 = (_e992 < _e109);
                                                            if _e993 {
                                                                if _e993 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e995 = global_10.member[_e992];
                                                                phi_2192_ = _e995;
                                                            } else {
                                                                phi_2192_ = 0u;
                                                            }
                                                            let _e997 = phi_2192_;
                                                            let _e1002 = (_e943 + 6u);
                                                            let _e1003 = (_e1002 + _e439);
                                                            let _e1004 = (_e1003 < _e109);
                                                            if _e1004 {
                                                                if _e1004 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1006 = global_10.member[_e1003];
                                                                phi_2215_ = _e1006;
                                                            } else {
                                                                phi_2215_ = 0u;
                                                            }
                                                            let _e1008 = phi_2215_;
                                                            let _e1012 = (_e1002 + _e438);
                                                            let _e1013 = (_e1012 < _e109);
                                                            if _e1013 {
                                                                if _e1013 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1015 = global_10.member[_e1012];
                                                                phi_2233_ = _e1015;
                                                            } else {
                                                                phi_2233_ = 0u;
                                                            }
                                                            let _e1017 = phi_2233_;
                                                            let _e1021 = (_e1002 + _e440);
                                                            let _e1022 = (_e1021 < _e109);
                                                            if _e1022 {
                                                                if _e1022 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1024 = global_10.member[_e1021];
                                                                phi_2251_ = _e1024;
                                                            } else {
                                                                phi_2251_ = 0u;
                                                            }
                                                            let _e1026 = phi_2251_;
                                                            phi_2257_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e950)) * _e165), (f32(bitcast<i32>(_e959)) * _e165), (f32(bitcast<i32>(_e968)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e979)) * _e165), (f32(bitcast<i32>(_e988)) * _e165), (f32(bitcast<i32>(_e997)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1008)) * _e165), (f32(bitcast<i32>(_e1017)) * _e165), (f32(bitcast<i32>(_e1026)) * _e165)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2257_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1318 = phi_2257_;
                                                    let _e1326 = (_e1318[0][2] - _e619);
                                                    let _e1329 = (((_e1318[0][0] - _e486) * _e658) - (_e1326 * _e526));
                                                    let _e1332 = (((_e1318[0][1] - _e553) * _e658) - (_e1326 * _e592));
                                                    let _e1339 = (_e1318[1][2] - _e619);
                                                    let _e1342 = (((_e1318[1][0] - _e486) * _e658) - (_e1339 * _e526));
                                                    let _e1345 = (((_e1318[1][1] - _e553) * _e658) - (_e1339 * _e592));
                                                    let _e1352 = (_e1318[2][2] - _e619);
                                                    let _e1355 = (((_e1318[2][0] - _e486) * _e658) - (_e1352 * _e526));
                                                    let _e1358 = (((_e1318[2][1] - _e553) * _e658) - (_e1352 * _e592));
                                                    let _e1359 = (_e1355 * _e1345);
                                                    let _e1360 = (_e1358 * _e1342);
                                                    let _e1361 = (_e1329 * _e1358);
                                                    let _e1362 = (_e1332 * _e1355);
                                                    let _e1363 = (_e1342 * _e1332);
                                                    let _e1364 = (_e1345 * _e1329);
                                                    let _e1369 = (((_e1359 >= _e1360) && (_e1361 >= _e1362)) && (_e1363 >= _e1364));
                                                    if (_e1369 || (((_e1359 <= _e1360) && (_e1361 <= _e1362)) && (_e1363 <= _e1364))) {
                                                        let _e1376 = select(-1f, 1f, _e1369);
                                                        let _e1378 = ((_e1359 - _e1360) * _e1376);
                                                        let _e1380 = select(0f, _e1378, (_e1378 > 0f));
                                                        let _e1382 = ((_e1361 - _e1362) * _e1376);
                                                        let _e1384 = select(0f, _e1382, (_e1382 > 0f));
                                                        let _e1386 = ((_e1363 - _e1364) * _e1376);
                                                        let _e1388 = select(0f, _e1386, (_e1386 > 0f));
                                                        let _e1390 = ((_e1380 + _e1384) + _e1388);
                                                        if (_e1390 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3141_ = type_25();
                                                            phi_3142_ = true;
                                                            phi_3143_ = false;
                                                        } else {
                                                            let _e1393 = select(_e1342, _e1329, (_e1329 < _e1342));
                                                            if (select(_e1355, _e1393, (_e1393 < _e1355)) > 0f) {
                                                                phi_2409_ = true;
                                                            } else {
                                                                let _e1398 = select(_e1342, _e1329, (_e1329 > _e1342));
                                                                phi_2409_ = (select(_e1355, _e1398, (_e1398 > _e1355)) < 0f);
                                                            }
                                                            let _e1403 = phi_2409_;
                                                            if _e1403 {
                                                                phi_3138_ = type_25();
                                                                phi_3139_ = true;
                                                                phi_3140_ = false;
                                                            } else {
                                                                let _e1405 = select(_e1345, _e1332, (_e1332 < _e1345));
                                                                if (select(_e1358, _e1405, (_e1405 < _e1358)) > 0f) {
                                                                    phi_2438_ = true;
                                                                } else {
                                                                    let _e1410 = select(_e1345, _e1332, (_e1332 > _e1345));
                                                                    phi_2438_ = (select(_e1358, _e1410, (_e1410 > _e1358)) < 0f);
                                                                }
                                                                let _e1415 = phi_2438_;
                                                                if _e1415 {
                                                                    phi_3136_ = type_25();
                                                                    phi_3137_ = false;
                                                                } else {
                                                                    let _e1417 = select(_e1318[1][0], _e1318[0][0], (_e1318[0][0] < _e1318[1][0]));
                                                                    let _e1421 = select(_e1318[1][0], _e1318[0][0], (_e1318[0][0] > _e1318[1][0]));
                                                                    let _e1425 = select(_e1318[1][1], _e1318[0][1], (_e1318[0][1] < _e1318[1][1]));
                                                                    let _e1429 = select(_e1318[1][1], _e1318[0][1], (_e1318[0][1] > _e1318[1][1]));
                                                                    let _e1433 = select(_e1318[1][2], _e1318[0][2], (_e1318[0][2] < _e1318[1][2]));
                                                                    let _e1437 = select(_e1318[1][2], _e1318[0][2], (_e1318[0][2] > _e1318[1][2]));
                                                                    let _e1442 = ((select(_e1318[2][0], _e1417, (_e1417 < _e1318[2][0])) - _e524) * _e529);
                                                                    let _e1443 = ((select(_e1318[2][0], _e1421, (_e1421 > _e1318[2][0])) - _e525) * _e529);
                                                                    let _e1446 = ((select(_e1318[2][1], _e1425, (_e1425 < _e1318[2][1])) - _e590) * _e595);
                                                                    let _e1447 = ((select(_e1318[2][1], _e1429, (_e1429 > _e1318[2][1])) - _e591) * _e595);
                                                                    let _e1450 = ((select(_e1318[2][2], _e1433, (_e1433 < _e1318[2][2])) - _e656) * _e661);
                                                                    let _e1451 = ((select(_e1318[2][2], _e1437, (_e1437 > _e1318[2][2])) - _e657) * _e661);
                                                                    let _e1453 = select(_e1451, _e1450, (_e1450 < _e1451));
                                                                    let _e1455 = select(_e1451, _e1450, (_e1450 > _e1451));
                                                                    let _e1457 = select(_e1443, _e1442, (_e1442 < _e1443));
                                                                    let _e1459 = select(_e1447, _e1446, (_e1446 < _e1447));
                                                                    let _e1461 = select(_e1459, _e1457, (_e1457 > _e1459));
                                                                    let _e1463 = select(_e1453, _e1461, (_e1461 > _e1453));
                                                                    let _e1465 = select(_e1443, _e1442, (_e1442 > _e1443));
                                                                    let _e1467 = select(_e1447, _e1446, (_e1446 > _e1447));
                                                                    let _e1469 = select(_e1467, _e1465, (_e1465 < _e1467));
                                                                    let _e1471 = select(_e1455, _e1469, (_e1469 < _e1455));
                                                                    let _e1472 = -(_e1453);
                                                                    let _e1478 = select(_e772, _e1463, (_e1463 > _e772));
                                                                    if (_e1478 > (_e1471 + (select(_e1472, _e1455, (_e1455 > _e1472)) * 0.0000019073523f))) {
                                                                        phi_3131_ = type_25();
                                                                        phi_3132_ = true;
                                                                    } else {
                                                                        let _e1480 = (_e1478 > _e871.member);
                                                                        if _e1480 {
                                                                            phi_3130_ = type_25();
                                                                        } else {
                                                                            let _e1481 = vec3<f32>(_e1318[0][0], _e1318[0][1], _e1318[0][2]);
                                                                            let _e1482 = vec3<f32>(_e1318[1][0], _e1318[1][1], _e1318[1][2]);
                                                                            let _e1483 = vec3<f32>(_e1318[2][0], _e1318[2][1], _e1318[2][2]);
                                                                            let _e1484 = (_e1318[1][0] - _e1318[0][0]);
                                                                            let _e1485 = (_e1318[1][1] - _e1318[0][1]);
                                                                            let _e1486 = (_e1318[1][2] - _e1318[0][2]);
                                                                            let _e1487 = vec3<f32>(_e1484, _e1485, _e1486);
                                                                            let _e1488 = (_e1318[2][0] - _e1318[1][0]);
                                                                            let _e1489 = (_e1318[2][1] - _e1318[1][1]);
                                                                            let _e1490 = (_e1318[2][2] - _e1318[1][2]);
                                                                            let _e1491 = vec3<f32>(_e1488, _e1489, _e1490);
                                                                            let _e1492 = (_e1318[0][0] - _e1318[2][0]);
                                                                            let _e1493 = (_e1318[0][1] - _e1318[2][1]);
                                                                            let _e1494 = (_e1318[0][2] - _e1318[2][2]);
                                                                            let _e1495 = vec3<f32>(_e1492, _e1493, _e1494);
                                                                            let _e1498 = bitcast<f32>((bitcast<u32>(_e1484) & 2147483647u));
                                                                            let _e1501 = bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u));
                                                                            let _e1503 = select(_e1501, _e1498, (_e1498 > _e1501));
                                                                            let _e1506 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                                            let _e1508 = select(_e1506, _e1503, (_e1503 > _e1506));
                                                                            let _e1511 = bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u));
                                                                            let _e1514 = bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u));
                                                                            let _e1516 = select(_e1514, _e1511, (_e1511 > _e1514));
                                                                            let _e1519 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                            let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                                            let _e1524 = bitcast<f32>((bitcast<u32>(_e1492) & 2147483647u));
                                                                            let _e1527 = bitcast<f32>((bitcast<u32>(_e1493) & 2147483647u));
                                                                            let _e1529 = select(_e1527, _e1524, (_e1524 > _e1527));
                                                                            let _e1532 = bitcast<f32>((bitcast<u32>(_e1494) & 2147483647u));
                                                                            let _e1534 = select(_e1532, _e1529, (_e1529 > _e1532));
                                                                            let _e1536 = select(_e1521, _e1508, (_e1508 > _e1521));
                                                                            let _e1538 = select(_e1534, _e1536, (_e1536 > _e1534));
                                                                            if (_e1508 == _e1538) {
                                                                                phi_2857_ = _e1345;
                                                                                phi_2858_ = _e1342;
                                                                                phi_2859_ = _e1332;
                                                                                phi_2860_ = _e1329;
                                                                                phi_2861_ = _e1481;
                                                                                phi_2862_ = _e1495;
                                                                                phi_2863_ = _e1491;
                                                                                phi_2864_ = _e1487;
                                                                            } else {
                                                                                let _e1540 = (_e1521 == _e1538);
                                                                                let _e1545 = vec3(_e1540);
                                                                                phi_2857_ = select(_e1332, _e1358, _e1540);
                                                                                phi_2858_ = select(_e1329, _e1355, _e1540);
                                                                                phi_2859_ = select(_e1358, _e1345, _e1540);
                                                                                phi_2860_ = select(_e1355, _e1342, _e1540);
                                                                                phi_2861_ = select(_e1483, _e1482, _e1545);
                                                                                phi_2862_ = select(_e1491, _e1487, _e1545);
                                                                                phi_2863_ = select(_e1487, _e1495, _e1545);
                                                                                phi_2864_ = select(_e1495, _e1491, _e1545);
                                                                            }
                                                                            let _e1551 = phi_2857_;
                                                                            let _e1553 = phi_2858_;
                                                                            let _e1555 = phi_2859_;
                                                                            let _e1557 = phi_2860_;
                                                                            let _e1559 = phi_2861_;
                                                                            let _e1561 = phi_2862_;
                                                                            let _e1563 = phi_2863_;
                                                                            let _e1565 = phi_2864_;
                                                                            let _e1572 = ((_e1563.y * _e1561.z) - (_e1561.y * _e1563.z));
                                                                            let _e1577 = ((_e1563.z * _e1561.x) - (_e1561.z * _e1563.x));
                                                                            let _e1580 = ((_e1563.x * _e1561.y) - (_e1561.x * _e1563.y));
                                                                            if (_e1380 >= _e1384) {
                                                                                phi_2901_ = select(true, false, (_e1380 >= _e1388));
                                                                            } else {
                                                                                phi_2901_ = true;
                                                                            }
                                                                            let _e1585 = phi_2901_;
                                                                            if _e1585 {
                                                                                phi_2910_ = select(_e1483, _e1482, vec3((_e1384 >= _e1388)));
                                                                            } else {
                                                                                phi_2910_ = _e1481;
                                                                            }
                                                                            let _e1590 = phi_2910_;
                                                                            let _e1601 = (((_e1572 * (_e1590.x - _e486)) + (_e1577 * (_e1590.y - _e553))) + (_e1580 * (_e1590.z - _e619)));
                                                                            let _e1606 = (((_e1572 * _e526) + (_e1577 * _e592)) + (_e1580 * _e658));
                                                                            let _e1607 = (_e1553 - _e1557);
                                                                            let _e1608 = (_e1551 - _e1555);
                                                                            let _e1616 = (-(((_e1557 * _e1607) + (_e1555 * _e1608))) / ((_e1607 * _e1607) + (_e1608 * _e1608)));
                                                                            let _e1618 = select(1f, _e1616, (_e1616 < 1f));
                                                                            let _e1620 = select(0f, _e1618, (_e1618 > 0f));
                                                                            let _e1633 = ((_e1559.x + (_e1565.x * _e1620)) - _e486);
                                                                            let _e1634 = ((_e1559.y + (_e1565.y * _e1620)) - _e553);
                                                                            let _e1635 = ((_e1559.z + (_e1565.z * _e1620)) - _e619);
                                                                            let _e1636 = (_e1635 / _e658);
                                                                            let _e1648 = bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u));
                                                                            let _e1651 = bitcast<f32>((bitcast<u32>(_e1634) & 2147483647u));
                                                                            let _e1653 = select(_e1651, _e1648, (_e1648 > _e1651));
                                                                            let _e1656 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                            let _e1658 = select(_e1656, _e1653, (_e1653 > _e1656));
                                                                            let _e1664 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
                                                                            let _e1667 = bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u));
                                                                            let _e1669 = select(_e1667, _e1664, (_e1664 > _e1667));
                                                                            let _e1672 = bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1572 * _e1633) + (_e1577 * _e1634)) + (_e1580 * _e1635)) - _e1601)) & 2147483647u)) <= ((0.0000009536743f * select(_e1538, _e1658, (_e1658 > _e1538))) * select(_e1672, _e1669, (_e1669 > _e1672)))) {
                                                                                let _e1682 = bitcast<f32>((bitcast<u32>(_e1563.x) & 2147483647u));
                                                                                let _e1685 = bitcast<f32>((bitcast<u32>(_e1563.y) & 2147483647u));
                                                                                let _e1687 = select(_e1685, _e1682, (_e1682 > _e1685));
                                                                                let _e1690 = bitcast<f32>((bitcast<u32>(_e1563.z) & 2147483647u));
                                                                                let _e1696 = bitcast<f32>((bitcast<u32>(_e1561.x) & 2147483647u));
                                                                                let _e1699 = bitcast<f32>((bitcast<u32>(_e1561.y) & 2147483647u));
                                                                                let _e1701 = select(_e1699, _e1696, (_e1696 > _e1699));
                                                                                let _e1704 = bitcast<f32>((bitcast<u32>(_e1561.z) & 2147483647u));
                                                                                let _e1708 = (bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u)) > ((0.0000038146973f * select(_e1690, _e1687, (_e1687 > _e1690))) * select(_e1704, _e1701, (_e1701 > _e1704))));
                                                                                if _e1708 {
                                                                                    phi_3075_ = (_e1601 / _e1606);
                                                                                } else {
                                                                                    phi_3075_ = f32();
                                                                                }
                                                                                let _e1711 = phi_3075_;
                                                                                phi_3077_ = _e1711;
                                                                                phi_3078_ = select(true, false, _e1708);
                                                                            } else {
                                                                                phi_3077_ = f32();
                                                                                phi_3078_ = true;
                                                                            }
                                                                            let _e1714 = phi_3077_;
                                                                            let _e1716 = phi_3078_;
                                                                            if _e1716 {
                                                                                let _e1724 = (((_e1572 * (_e1633 - (_e526 * _e1636))) + (_e1577 * (_e1634 - (_e592 * _e1636)))) / _e1606);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1724) & 2147483647u)) <= _e1538) {
                                                                                    phi_3098_ = (_e1636 + _e1724);
                                                                                } else {
                                                                                    phi_3098_ = _e1636;
                                                                                }
                                                                                let _e1731 = phi_3098_;
                                                                                phi_3099_ = _e1731;
                                                                            } else {
                                                                                phi_3099_ = _e1714;
                                                                            }
                                                                            let _e1733 = phi_3099_;
                                                                            let _e1735 = select(_e1471, _e1733, (_e1733 < _e1471));
                                                                            let _e1737 = select(_e1463, _e1735, (_e1735 > _e1463));
                                                                            if (_e1737 >= _e772) {
                                                                                let _e1739 = (_e1737 <= _e871.member);
                                                                                if _e1739 {
                                                                                    let _e1740 = (1f / _e1390);
                                                                                    phi_3122_ = type_25(_e1737, (_e1384 * _e1740), (_e1388 * _e1740), _e931);
                                                                                } else {
                                                                                    phi_3122_ = type_25();
                                                                                }
                                                                                let _e1745 = phi_3122_;
                                                                                phi_3124_ = _e1745;
                                                                                phi_3125_ = select(true, false, _e1739);
                                                                            } else {
                                                                                phi_3124_ = type_25();
                                                                                phi_3125_ = true;
                                                                            }
                                                                            let _e1748 = phi_3124_;
                                                                            let _e1750 = phi_3125_;
                                                                            if _e1750 {
                                                                                phi_3129_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_3129_ = _e1748;
                                                                            }
                                                                            let _e1752 = phi_3129_;
                                                                            phi_3130_ = _e1752;
                                                                        }
                                                                        let _e1754 = phi_3130_;
                                                                        phi_3131_ = _e1754;
                                                                        phi_3132_ = _e1480;
                                                                    }
                                                                    let _e1756 = phi_3131_;
                                                                    let _e1758 = phi_3132_;
                                                                    phi_3136_ = _e1756;
                                                                    phi_3137_ = _e1758;
                                                                }
                                                                let _e1760 = phi_3136_;
                                                                let _e1762 = phi_3137_;
                                                                phi_3138_ = _e1760;
                                                                phi_3139_ = _e1415;
                                                                phi_3140_ = _e1762;
                                                            }
                                                            let _e1764 = phi_3138_;
                                                            let _e1766 = phi_3139_;
                                                            let _e1768 = phi_3140_;
                                                            phi_3141_ = _e1764;
                                                            phi_3142_ = _e1766;
                                                            phi_3143_ = _e1768;
                                                        }
                                                        let _e1770 = phi_3141_;
                                                        let _e1772 = phi_3142_;
                                                        let _e1774 = phi_3143_;
                                                        phi_3151_ = _e1770;
                                                        phi_3152_ = select(_e1774, true, _e1772);
                                                    } else {
                                                        phi_3151_ = type_25();
                                                        phi_3152_ = true;
                                                    }
                                                    let _e1777 = phi_3151_;
                                                    let _e1779 = phi_3152_;
                                                    if _e1779 {
                                                        phi_3156_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3156_ = _e1777;
                                                    }
                                                    let _e1781 = phi_3156_;
                                                    if (_e1781.member_3 != 4294967295u) {
                                                        if (_e931 == _e174) {
                                                            phi_3491_ = false;
                                                        } else {
                                                            let _e1785 = (_e931 < arrayLength((&global_6.member)));
                                                            if _e1785 {
                                                                if _e1785 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1787 = global_6.member[_e931];
                                                                phi_3179_ = _e1787;
                                                            } else {
                                                                phi_3179_ = 4294967295u;
                                                            }
                                                            let _e1789 = phi_3179_;
                                                            let _e1790 = (_e1789 < arrayLength((&global_7.member)));
                                                            if _e1790 {
                                                                if _e1790 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1792 = global_7.member[_e1789];
                                                                phi_3193_ = _e1792;
                                                            } else {
                                                                phi_3193_ = 0i;
                                                            }
                                                            let _e1794 = phi_3193_;
                                                            let _e1795 = (_e1794 == 0i);
                                                            if _e1795 {
                                                                phi_3490_ = true;
                                                            } else {
                                                                if _e463 {
                                                                    phi_3216_ = vec3<f32>(_e1318[0][0], _e1318[0][1], _e1318[0][2]);
                                                                } else {
                                                                    if (_e439 == 1u) {
                                                                        phi_3215_ = vec3<f32>(_e1318[0][2], _e1318[0][0], _e1318[0][1]);
                                                                    } else {
                                                                        phi_3215_ = vec3<f32>(_e1318[0][1], _e1318[0][2], _e1318[0][0]);
                                                                    }
                                                                    let _e1800 = phi_3215_;
                                                                    phi_3216_ = _e1800;
                                                                }
                                                                let _e1803 = phi_3216_;
                                                                if _e463 {
                                                                    phi_3235_ = vec3<f32>(_e1318[1][0], _e1318[1][1], _e1318[1][2]);
                                                                } else {
                                                                    if (_e439 == 1u) {
                                                                        phi_3234_ = vec3<f32>(_e1318[1][2], _e1318[1][0], _e1318[1][1]);
                                                                    } else {
                                                                        phi_3234_ = vec3<f32>(_e1318[1][1], _e1318[1][2], _e1318[1][0]);
                                                                    }
                                                                    let _e1808 = phi_3234_;
                                                                    phi_3235_ = _e1808;
                                                                }
                                                                let _e1811 = phi_3235_;
                                                                if _e463 {
                                                                    phi_3254_ = vec3<f32>(_e1318[2][0], _e1318[2][1], _e1318[2][2]);
                                                                } else {
                                                                    if (_e439 == 1u) {
                                                                        phi_3253_ = vec3<f32>(_e1318[2][2], _e1318[2][0], _e1318[2][1]);
                                                                    } else {
                                                                        phi_3253_ = vec3<f32>(_e1318[2][1], _e1318[2][2], _e1318[2][0]);
                                                                    }
                                                                    let _e1816 = phi_3253_;
                                                                    phi_3254_ = _e1816;
                                                                }
                                                                let _e1819 = phi_3254_;
                                                                let _e1822 = (_e1811.x - _e1803.x);
                                                                let _e1825 = (_e1811.y - _e1803.y);
                                                                let _e1828 = (_e1811.z - _e1803.z);
                                                                let _e1830 = (_e1819.x - _e1803.x);
                                                                let _e1832 = (_e1819.y - _e1803.y);
                                                                let _e1834 = (_e1819.z - _e1803.z);
                                                                if (_e306.member_1 == 1u) {
                                                                    phi_3290_ = (vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]) - _e1803);
                                                                } else {
                                                                    phi_3290_ = vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]);
                                                                }
                                                                let _e1849 = phi_3290_;
                                                                let _e1855 = bitcast<f32>((bitcast<u32>((_e1822 * _e1832)) ^ _e306.member_3[0]));
                                                                let _e1859 = bitcast<f32>((bitcast<u32>((_e1825 * _e1830)) ^ _e306.member_3[0]));
                                                                let _e1863 = bitcast<f32>((bitcast<u32>((_e1825 * _e1834)) ^ _e306.member_3[0]));
                                                                let _e1867 = bitcast<f32>((bitcast<u32>((_e1828 * _e1832)) ^ _e306.member_3[0]));
                                                                let _e1871 = bitcast<f32>((bitcast<u32>((_e1828 * _e1830)) ^ _e306.member_3[0]));
                                                                let _e1875 = bitcast<f32>((bitcast<u32>((_e1822 * _e1834)) ^ _e306.member_3[0]));
                                                                let _e1876 = (_e1863 - _e1867);
                                                                let _e1877 = (_e1871 - _e1875);
                                                                let _e1878 = (_e1855 - _e1859);
                                                                let _e1902 = (bitcast<f32>((bitcast<u32>(_e1863) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1867) & 2147483647u)));
                                                                let _e1909 = (bitcast<f32>((bitcast<u32>(_e1871) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1875) & 2147483647u)));
                                                                let _e1916 = (bitcast<f32>((bitcast<u32>(_e1855) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1859) & 2147483647u)));
                                                                if (_e306.member_2 == 0f) {
                                                                    phi_3472_ = 0f;
                                                                } else {
                                                                    let _e1946 = bitcast<f32>((bitcast<u32>(_e1876) & 2147483647u));
                                                                    let _e1949 = bitcast<f32>((bitcast<u32>(_e1877) & 2147483647u));
                                                                    let _e1952 = bitcast<f32>((bitcast<u32>(_e1878) & 2147483647u));
                                                                    let _e1954 = select(_e1952, _e1949, (_e1949 > _e1952));
                                                                    let _e1958 = select(_e1952, _e1949, (_e1949 < _e1952));
                                                                    let _e1962 = select(_e1949, _e1946, (_e1946 < _e1949));
                                                                    let _e1964 = select(_e1949, _e1946, (_e1946 > _e1949));
                                                                    let _e1966 = select(_e1952, _e1964, (_e1964 < _e1952));
                                                                    phi_3472_ = bitcast<f32>((bitcast<u32>((_e306.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1954, _e1946, (_e1946 > _e1954)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1966, _e1962, (_e1962 > _e1966)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1958, _e1946, (_e1946 < _e1958)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1902 + _e1909) + _e1916))) ^ _e306.member_3[0]))) * 1.0000005f)) ^ _e306.member_3[0])))) ^ _e306.member_3[0]));
                                                                }
                                                                let _e1993 = phi_3472_;
                                                                phi_3490_ = (_e1795 || !(((((bitcast<f32>((bitcast<u32>((_e1849.x * _e1876)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1849.y * _e1877)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1849.z * _e1878)) ^ _e306.member_3[0]))) * f32(-(_e1794))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1849.x) & 2147483647u)) * _e1902)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1849.y) & 2147483647u)) * _e1909)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1849.z) & 2147483647u)) * _e1916)) ^ _e306.member_3[0]))))) ^ _e306.member_3[0])) + _e1993) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2007 = phi_3490_;
                                                            phi_3491_ = _e2007;
                                                        }
                                                        let _e2009 = phi_3491_;
                                                        if _e2009 {
                                                            phi_3496_ = type_46(_e871.member, true);
                                                        } else {
                                                            phi_3496_ = _e871;
                                                        }
                                                        let _e2014 = phi_3496_;
                                                        phi_3497_ = _e2014;
                                                    } else {
                                                        phi_3497_ = _e871;
                                                    }
                                                    let _e2016 = phi_3497_;
                                                    phi_1494_ = _e2016;
                                                } else {
                                                    phi_1494_ = type_46();
                                                }
                                                let _e2018 = phi_1494_;
                                                continue;
                                                continuing {
                                                    phi_1493_ = _e2018;
                                                    phi_1496_ = _e886;
                                                    phi_5039_ = _e814;
                                                    break if !(_e892);
                                                }
                                            }
                                            let _e2021 = phi_5039_;
                                            phi_5278_ = _e2021;
                                            if _e2021 {
                                                break;
                                            }
                                            phi_5369_ = _e2021;
                                            let _e2709 = local_11;
                                            phi_3498_ = _e2709;
                                        } else {
                                            phi_5369_ = _e814;
                                            phi_3498_ = _e816;
                                        }
                                        let _e2023 = phi_5369_;
                                        let _e2025 = phi_3498_;
                                        if _e863 {
                                            phi_4763_ = bool();
                                            phi_4764_ = u32();
                                            phi_4765_ = type_58();
                                        } else {
                                            if (_e859.member_1 >= _e106) {
                                                phi_4299_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e859.member_1 < _e106) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2029 = ((1u + _e439) % 4u);
                                                if (_e2029 < 4u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2034 = global_5.member[_e859.member_1][_e2029];
                                                let _e2036 = (_e2034 >> bitcast<u32>(11u));
                                                let _e2038 = ((1u + _e438) % 4u);
                                                if (_e2038 < 4u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2043 = global_5.member[_e859.member_1][_e2038];
                                                let _e2045 = (_e2043 >> bitcast<u32>(11u));
                                                let _e2047 = ((1u + _e440) % 4u);
                                                if (_e2047 < 4u) {
                                                } else {
                                                    phi_5278_ = true;
                                                    break;
                                                }
                                                let _e2052 = global_5.member[_e859.member_1][_e2047];
                                                let _e2054 = (_e2052 >> bitcast<u32>(11u));
                                                let _e2077 = (bitcast<f32>((bitcast<u32>((_e859.member.member_1.x - _e859.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e2078 = (bitcast<f32>((bitcast<u32>((_e859.member.member_1.y - _e859.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e2079 = (bitcast<f32>((bitcast<u32>((_e859.member.member_1.z - _e859.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e2081 = select(_e165, _e2077, (_e2077 > _e165));
                                                let _e2083 = select(_e165, _e2078, (_e2078 > _e165));
                                                let _e2085 = select(_e165, _e2079, (_e2079 > _e165));
                                                let _e2116 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2034 & 1023u))) - 8388608f) * _e2081));
                                                let _e2121 = (bitcast<i32>((_e2034 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2124 = bitcast<f32>((_e2116 & bitcast<u32>(_e2121)));
                                                let _e2125 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2043 & 1023u))) - 8388608f) * _e2083));
                                                let _e2130 = (bitcast<i32>((_e2043 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2133 = bitcast<f32>((_e2125 & bitcast<u32>(_e2130)));
                                                let _e2134 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2052 & 1023u))) - 8388608f) * _e2085));
                                                let _e2139 = (bitcast<i32>((_e2052 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2142 = bitcast<f32>((_e2134 & bitcast<u32>(_e2139)));
                                                let _e2146 = bitcast<f32>((_e2116 & bitcast<u32>(~(_e2121))));
                                                let _e2150 = bitcast<f32>((_e2125 & bitcast<u32>(~(_e2130))));
                                                let _e2154 = bitcast<f32>((_e2134 & bitcast<u32>(~(_e2139))));
                                                let _e2155 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2036 & 1023u))) - 8388608f) * _e2081));
                                                let _e2160 = (bitcast<i32>((_e2036 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2163 = bitcast<f32>((_e2155 & bitcast<u32>(_e2160)));
                                                let _e2164 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2045 & 1023u))) - 8388608f) * _e2083));
                                                let _e2169 = (bitcast<i32>((_e2045 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2172 = bitcast<f32>((_e2164 & bitcast<u32>(_e2169)));
                                                let _e2173 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2054 & 1023u))) - 8388608f) * _e2085));
                                                let _e2178 = (bitcast<i32>((_e2054 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2181 = bitcast<f32>((_e2173 & bitcast<u32>(_e2178)));
                                                let _e2185 = bitcast<f32>((_e2155 & bitcast<u32>(~(_e2160))));
                                                let _e2189 = bitcast<f32>((_e2164 & bitcast<u32>(~(_e2169))));
                                                let _e2193 = bitcast<f32>((_e2173 & bitcast<u32>(~(_e2178))));
                                                let _e2194 = (_e859.member.member.x + _e2124);
                                                let _e2195 = (_e859.member.member.y + _e2133);
                                                let _e2196 = (_e859.member.member.z + _e2142);
                                                let _e2199 = (_e859.member.member_1.x - _e2163);
                                                let _e2200 = (_e859.member.member_1.y - _e2172);
                                                let _e2201 = (_e859.member.member_1.z - _e2181);
                                                let _e2220 = (_e2199 - _e2194);
                                                let _e2221 = (_e2200 - _e2195);
                                                let _e2222 = (_e2201 - _e2196);
                                                let _e2224 = select(_e2221, _e2220, (_e2220 > _e2221));
                                                let _e2226 = select(_e2222, _e2224, (_e2224 > _e2222));
                                                if (_e2226 < (1024f * _e165)) {
                                                    phi_4000_ = 0u;
                                                } else {
                                                    phi_4000_ = select(2u, 1u, (_e2226 < (2097152f * _e165)));
                                                }
                                                let _e2233 = phi_4000_;
                                                switch bitcast<i32>(_e2233) {
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
                                                let _e2236 = phi_4006_;
                                                let _e2242 = global_5.member[_e859.member_1][0u];
                                                let _e2246 = global_5.member[_e859.member_1][1u];
                                                let _e2250 = global_5.member[_e859.member_1][2u];
                                                let _e2254 = global_5.member[_e859.member_1][3u];
                                                let _e2266 = (((_e2246 >> bitcast<u32>(22i)) | ((_e2250 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2254 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e2267 = (_e2242 & 268435455u);
                                                let _e2268 = (_e2266 & 268435455u);
                                                let _e2271 = ((_e2242 >> bitcast<u32>(28u)) & 7u);
                                                let _e2279 = ((_e2242 >> bitcast<u32>(31i)) | (((_e2266 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e2280 = (_e2271 != 0u);
                                                if (_e2271 == 0u) {
                                                    phi_4261_ = _e2267;
                                                } else {
                                                    if (_e2271 == 7u) {
                                                        phi_4260_ = 2147483648u;
                                                    } else {
                                                        phi_4260_ = ((2147483648u | (_e2271 << bitcast<u32>(28u))) | (_e2268 & 268435455u));
                                                    }
                                                    let _e2289 = phi_4260_;
                                                    phi_4261_ = _e2289;
                                                }
                                                let _e2291 = phi_4261_;
                                                if _e2280 {
                                                    let _e2292 = (_e2271 != 7u);
                                                    if _e2292 {
                                                        phi_4271_ = (_e2268 + (_e2271 * ((3u * _e2236) + 1u)));
                                                    } else {
                                                        phi_4271_ = u32();
                                                    }
                                                    let _e2296 = phi_4271_;
                                                    phi_4273_ = _e2296;
                                                    phi_4274_ = select(true, false, _e2292);
                                                } else {
                                                    phi_4273_ = u32();
                                                    phi_4274_ = true;
                                                }
                                                let _e2299 = phi_4273_;
                                                let _e2301 = phi_4274_;
                                                if (_e2279 == 0u) {
                                                    phi_4295_ = (_e2267 + select(0u, 1u, !(_e2280)));
                                                } else {
                                                    if (_e2279 == 7u) {
                                                        phi_4294_ = 2147483648u;
                                                    } else {
                                                        phi_4294_ = ((2147483648u | (_e2279 << bitcast<u32>(28u))) | (select(_e2299, _e2268, _e2301) & 268435455u));
                                                    }
                                                    let _e2314 = phi_4294_;
                                                    phi_4295_ = _e2314;
                                                }
                                                let _e2316 = phi_4295_;
                                                phi_4299_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e2194, (_e859.member.member.x + _e2146), _e2199, (_e859.member.member_1.x - _e2185)), vec4<f32>(_e2195, (_e859.member.member.y + _e2150), _e2200, (_e859.member.member_1.y - _e2189)), vec4<f32>(_e2196, (_e859.member.member.z + _e2154), _e2201, (_e859.member.member_1.z - _e2193))), type_58(type_34((_e859.member.member + vec4<f32>(_e2124, _e2133, _e2142, 0f)), (_e859.member.member_1 - vec4<f32>(_e2163, _e2172, _e2181, 0f))), _e2291), type_58(type_34((_e859.member.member + vec4<f32>(_e2146, _e2150, _e2154, 0f)), (_e859.member.member_1 - vec4<f32>(_e2185, _e2189, _e2193, 0f))), _e2316));
                                            }
                                            let _e2321 = phi_4299_;
                                            let _e2333 = ((_e2321.member[0].x - _e524) * _e529);
                                            let _e2334 = ((_e2321.member[0].y - _e524) * _e529);
                                            let _e2335 = ((_e2321.member[0].z - _e525) * _e529);
                                            let _e2336 = ((_e2321.member[0].w - _e525) * _e529);
                                            let _e2346 = ((_e2321.member[1].x - _e590) * _e595);
                                            let _e2347 = ((_e2321.member[1].y - _e590) * _e595);
                                            let _e2348 = ((_e2321.member[1].z - _e591) * _e595);
                                            let _e2349 = ((_e2321.member[1].w - _e591) * _e595);
                                            let _e2359 = ((_e2321.member[2].x - _e656) * _e661);
                                            let _e2360 = ((_e2321.member[2].y - _e656) * _e661);
                                            let _e2361 = ((_e2321.member[2].z - _e657) * _e661);
                                            let _e2362 = ((_e2321.member[2].w - _e657) * _e661);
                                            let _e2364 = select(_e2361, _e2359, (_e2359 < _e2361));
                                            let _e2366 = select(_e2362, _e2360, (_e2360 < _e2362));
                                            let _e2368 = select(_e2361, _e2359, (_e2359 > _e2361));
                                            let _e2370 = select(_e2362, _e2360, (_e2360 > _e2362));
                                            let _e2372 = select(_e2335, _e2333, (_e2333 < _e2335));
                                            let _e2374 = select(_e2336, _e2334, (_e2334 < _e2336));
                                            let _e2376 = select(_e2348, _e2346, (_e2346 < _e2348));
                                            let _e2378 = select(_e2349, _e2347, (_e2347 < _e2349));
                                            let _e2380 = select(_e2376, _e2372, (_e2372 > _e2376));
                                            let _e2382 = select(_e2378, _e2374, (_e2374 > _e2378));
                                            let _e2384 = select(_e2364, _e2380, (_e2380 > _e2364));
                                            let _e2386 = select(_e2366, _e2382, (_e2382 > _e2366));
                                            let _e2388 = select(_e2335, _e2333, (_e2333 > _e2335));
                                            let _e2390 = select(_e2336, _e2334, (_e2334 > _e2336));
                                            let _e2392 = select(_e2348, _e2346, (_e2346 > _e2348));
                                            let _e2394 = select(_e2349, _e2347, (_e2347 > _e2349));
                                            let _e2396 = select(_e2392, _e2388, (_e2388 < _e2392));
                                            let _e2398 = select(_e2394, _e2390, (_e2390 < _e2394));
                                            let _e2403 = -(_e2364);
                                            let _e2404 = -(_e2366);
                                            let _e2411 = (select(_e2368, _e2396, (_e2396 < _e2368)) + (select(_e2403, _e2368, (_e2368 > _e2403)) * 0.0000019073523f));
                                            let _e2412 = (select(_e2370, _e2398, (_e2398 < _e2370)) + (select(_e2404, _e2370, (_e2370 > _e2404)) * 0.0000019073523f));
                                            let _e2414 = select(_e772, _e2384, (_e2384 > _e772));
                                            let _e2416 = select(_e772, _e2386, (_e2386 > _e772));
                                            let _e2421 = (_e2414 <= select(_e2025.member, _e2411, (_e2411 < _e2025.member)));
                                            let _e2422 = (_e2416 <= select(_e2025.member, _e2412, (_e2412 < _e2025.member)));
                                            let _e2423 = (_e2414 <= _e2416);
                                            if _e2421 {
                                                if _e2422 {
                                                    if _e2423 {
                                                        phi_4661_ = _e2321.member_2;
                                                    } else {
                                                        phi_4661_ = _e2321.member_1;
                                                    }
                                                    let _e2427 = phi_4661_;
                                                    let _e2448 = (_e857 % 128u);
                                                    let _e2449 = (_e2448 < 128u);
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2448] = _e2427.member_1;
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2448] = _e2427.member.member.x;
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2448] = _e2427.member.member.y;
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2448] = _e2427.member.member.z;
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2448] = _e2427.member.member_1.x;
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2448] = _e2427.member.member_1.y;
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2448] = _e2427.member.member_1.z;
                                                    if _e2449 {
                                                    } else {
                                                        phi_5278_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2448] = select(_e2414, _e2416, _e2423);
                                                    if _e2423 {
                                                        phi_4737_ = _e2321.member_1;
                                                    } else {
                                                        phi_4737_ = _e2321.member_2;
                                                    }
                                                    let _e2462 = phi_4737_;
                                                    phi_4738_ = (_e857 + 1u);
                                                    phi_4739_ = _e2462;
                                                } else {
                                                    phi_4738_ = u32();
                                                    phi_4739_ = type_58();
                                                }
                                                let _e2464 = phi_4738_;
                                                let _e2466 = phi_4739_;
                                                phi_4741_ = _e2464;
                                                phi_4742_ = _e2466;
                                                phi_4743_ = select(true, false, _e2422);
                                            } else {
                                                phi_4741_ = u32();
                                                phi_4742_ = type_58();
                                                phi_4743_ = true;
                                            }
                                            let _e2469 = phi_4741_;
                                            let _e2471 = phi_4742_;
                                            let _e2473 = phi_4743_;
                                            if _e2473 {
                                                if _e2421 {
                                                    phi_4752_ = _e2321.member_1;
                                                } else {
                                                    phi_4752_ = _e2321.member_2;
                                                }
                                                let _e2477 = phi_4752_;
                                                phi_4757_ = select(_e2422, true, _e2421);
                                                phi_4759_ = _e2477;
                                            } else {
                                                phi_4757_ = _e855;
                                                phi_4759_ = _e2471;
                                            }
                                            let _e2480 = phi_4757_;
                                            let _e2482 = phi_4759_;
                                            phi_4763_ = _e2480;
                                            phi_4764_ = select(_e2469, _e857, _e2473);
                                            phi_4765_ = _e2482;
                                        }
                                        let _e2485 = phi_4763_;
                                        let _e2487 = phi_4764_;
                                        let _e2489 = phi_4765_;
                                        if _e863 {
                                            phi_4775_ = select(_e857, 0u, _e2025.member_1);
                                            phi_4776_ = _e859;
                                        } else {
                                            phi_4775_ = _e2487;
                                            phi_4776_ = _e2489;
                                        }
                                        let _e2493 = phi_4775_;
                                        let _e2495 = phi_4776_;
                                        phi_5281_ = _e2023;
                                        phi_4777_ = _e2025;
                                        phi_4778_ = (_e818 - 1u);
                                        phi_4779_ = select(_e2485, false, _e863);
                                        phi_4780_ = _e2493;
                                        phi_4781_ = _e2495;
                                    } else {
                                        phi_5281_ = _e814;
                                        phi_4777_ = _e816;
                                        phi_4778_ = _e818;
                                        phi_4779_ = _e855;
                                        phi_4780_ = _e857;
                                        phi_4781_ = _e859;
                                    }
                                    let _e2498 = phi_5281_;
                                    let _e2500 = phi_4777_;
                                    let _e2502 = phi_4778_;
                                    let _e2504 = phi_4779_;
                                    let _e2506 = phi_4780_;
                                    let _e2508 = phi_4781_;
                                    phi_5280_ = _e2498;
                                    phi_4782_ = _e2500;
                                    phi_4783_ = _e2502;
                                    phi_4784_ = _e2504;
                                    phi_4785_ = _e2506;
                                    phi_4786_ = _e2508;
                                } else {
                                    phi_5280_ = _e814;
                                    phi_4782_ = type_46();
                                    phi_4783_ = u32();
                                    phi_4784_ = bool();
                                    phi_4785_ = u32();
                                    phi_4786_ = type_58();
                                }
                                let _e2510 = phi_5280_;
                                let _e2512 = phi_4782_;
                                let _e2514 = phi_4783_;
                                let _e2516 = phi_4784_;
                                let _e2518 = phi_4785_;
                                let _e2520 = phi_4786_;
                                phi_5279_ = _e2510;
                                phi_1367_ = _e2512;
                                phi_1370_ = _e2514;
                                phi_1372_ = _e2516;
                                phi_1374_ = _e2518;
                                phi_1376_ = _e2520;
                                phi_4787_ = _e828;
                            } else {
                                phi_5279_ = _e814;
                                phi_1367_ = type_46();
                                phi_1370_ = u32();
                                phi_1372_ = bool();
                                phi_1374_ = u32();
                                phi_1376_ = type_58();
                                phi_4787_ = false;
                            }
                            let _e2522 = phi_5279_;
                            let _e2524 = phi_1367_;
                            let _e2526 = phi_1370_;
                            let _e2528 = phi_1372_;
                            let _e2530 = phi_1374_;
                            let _e2532 = phi_1376_;
                            let _e2534 = phi_4787_;
                            continue;
                            continuing {
                                phi_5045_ = _e2522;
                                phi_1366_ = _e2524;
                                phi_1369_ = _e2526;
                                phi_1371_ = _e2528;
                                phi_1373_ = _e2530;
                                phi_1375_ = _e2532;
                                phi_5278_ = _e2522;
                                break if !(_e2534);
                            }
                        }
                        let _e2537 = phi_5278_;
                        if _e2537 {
                            break;
                        }
                        let _e2539 = local_10;
                        if _e2539.member_1 {
                        } else {
                            if _e307 {
                            } else {
                                break;
                            }
                            let _e2543 = global_2.member[_e153];
                            if _e168 {
                            } else {
                                break;
                            }
                            let _e2547 = global_9.member[_e153].member_1;
                            if _e307 {
                            } else {
                                break;
                            }
                            global_2.member[_e153] = type_27(_e2543.member, _e2543.member_1, _e2543.member_2, array<f32, 3>((_e2543.member_3[0] + (_e2547[0] * _e2543.member_1[0])), (_e2543.member_3[1] + (_e2547[1] * _e2543.member_1[1])), (_e2543.member_3[2] + (_e2547[2] * _e2543.member_1[2]))), _e2543.member_4);
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
