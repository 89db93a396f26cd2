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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
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

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_49 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_51 {
    member: array<type_49>,
}

struct type_54 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_56 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_58 {
    member: array<type_56>,
}

struct type_62 {
    member: type_54,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(2) 
var<uniform> global_3: type_42;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_45;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_67;
@group(0) @binding(3) 
var<storage> global_9: type_51;
@group(0) @binding(4) 
var<storage> global_10: type_58;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_387_: u32;
    var phi_431_: i32;
    var phi_571_: type_35;
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
    var phi_882_: f32;
    var phi_888_: f32;
    var phi_928_: f32;
    var phi_934_: f32;
    var phi_1007_: f32;
    var phi_1013_: f32;
    var phi_1053_: f32;
    var phi_1059_: f32;
    var phi_1178_: i32;
    var phi_1200_: u32;
    var phi_1201_: u32;
    var phi_1238_: i32;
    var phi_1260_: u32;
    var phi_1261_: u32;
    var phi_1269_: f32;
    var phi_1270_: f32;
    var phi_4447_: bool;
    var phi_1353_: type_38;
    var phi_1356_: u32;
    var phi_1358_: bool;
    var phi_1360_: u32;
    var phi_1362_: type_62;
    var phi_1373_: bool;
    var phi_1459_: bool;
    var phi_1460_: u32;
    var phi_1461_: type_62;
    var phi_1480_: type_38;
    var phi_1483_: type_8;
    var phi_1484_: type_8;
    var phi_1506_: type_8;
    var phi_1531_: u32;
    var phi_1547_: type_56;
    var phi_4168_: bool;
    var phi_4183_: bool;
    var phi_4198_: bool;
    var phi_4213_: bool;
    var phi_4228_: bool;
    var phi_4243_: bool;
    var phi_2354_: f32;
    var phi_2355_: f32;
    var phi_2356_: f32;
    var phi_2357_: f32;
    var phi_2358_: vec3<f32>;
    var phi_2359_: vec3<f32>;
    var phi_2360_: vec3<f32>;
    var phi_2361_: vec3<f32>;
    var phi_4258_: bool;
    var phi_4273_: bool;
    var phi_4288_: bool;
    var phi_4303_: bool;
    var phi_4318_: bool;
    var phi_4333_: bool;
    var phi_2569_: f32;
    var phi_2589_: type_40;
    var phi_2590_: type_40;
    var phi_2593_: type_40;
    var phi_2594_: type_40;
    var phi_2595_: bool;
    var phi_2599_: type_40;
    var phi_2608_: type_22;
    var phi_2631_: u32;
    var phi_2645_: i32;
    var phi_2663_: vec3<f32>;
    var phi_2664_: vec3<f32>;
    var phi_2678_: vec3<f32>;
    var phi_2679_: vec3<f32>;
    var phi_2693_: vec3<f32>;
    var phi_2694_: vec3<f32>;
    var phi_2730_: vec3<f32>;
    var phi_2912_: f32;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2957_: type_38;
    var phi_2958_: type_38;
    var phi_2959_: type_38;
    var phi_1481_: type_38;
    var phi_4441_: bool;
    var phi_4715_: bool;
    var phi_2960_: type_38;
    var phi_2981_: type_49;
    var phi_3867_: type_62;
    var phi_3943_: type_62;
    var phi_3944_: u32;
    var phi_3945_: type_62;
    var phi_3947_: u32;
    var phi_3948_: type_62;
    var phi_3949_: bool;
    var phi_3956_: type_62;
    var phi_3961_: bool;
    var phi_3963_: type_62;
    var phi_3967_: bool;
    var phi_3968_: u32;
    var phi_3969_: type_62;
    var phi_3979_: type_62;
    var phi_4659_: bool;
    var phi_3980_: type_38;
    var phi_3981_: u32;
    var phi_3982_: bool;
    var phi_3983_: u32;
    var phi_3984_: type_62;
    var phi_4658_: bool;
    var phi_3985_: type_38;
    var phi_3986_: u32;
    var phi_3987_: bool;
    var phi_3988_: u32;
    var phi_3989_: type_62;
    var phi_4657_: bool;
    var phi_1354_: type_38;
    var phi_1357_: u32;
    var phi_1359_: bool;
    var phi_1361_: u32;
    var phi_1363_: type_62;
    var phi_3990_: bool;
    var phi_4656_: bool;
    var local_10: type_38;
    var phi_4028_: f32;
    var phi_4030_: f32;
    var phi_4031_: bool;
    var phi_4032_: f32;
    var phi_4033_: bool;
    var phi_4361_: u32;
    var phi_4379_: bool;
    var phi_4382_: bool;
    var phi_4395_: f32;
    var phi_4396_: f32;
    var phi_4401_: f32;
    var phi_4402_: f32;
    var phi_4403_: bool;
    var phi_4411_: f32;
    var phi_4048_: f32;
    var phi_4049_: f32;
    var phi_4061_: f32;
    var phi_4066_: type_22;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e96 = arrayLength((&global_9.member));
            let _e111 = arrayLength((&global_8.member));
            let _e115 = global_3.member[0u][0u];
            let _e119 = global_3.member[0u][1u];
            let _e123 = global_3.member[0u][2u];
            let _e127 = global_3.member[1u][0u];
            let _e131 = global_3.member[1u][1u];
            let _e135 = global_3.member[1u][2u];
            let _e139 = global_3.member[1u][3u];
            let _e143 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = (_e143 < arrayLength((&global_6.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_6.member[_e143].member_2;
                phi_387_ = _e154;
            } else {
                phi_387_ = 4294967295u;
            }
            let _e156 = phi_387_;
            let _e159 = global_1.member[0u];
            let _e163 = global_2.member[0u][0u];
            let _e167 = global_2.member[0u][1u];
            let _e171 = global_2.member[0u][2u];
            let _e175 = global_2.member[0u][3u];
            let _e179 = global_2.member[1u][0u];
            let _e183 = global_2.member[1u][1u];
            let _e187 = global_2.member[1u][2u];
            let _e191 = global_2.member[1u][3u];
            let _e192 = bitcast<f32>(_e163);
            let _e193 = bitcast<f32>(_e167);
            let _e194 = bitcast<f32>(_e171);
            let _e196 = bitcast<f32>(_e179);
            let _e197 = array<u32, 3>(_e183, _e187, _e191);
            let _e199 = bitcast<i32>(_e159);
            if (_e199 < -126i) {
                phi_431_ = -126i;
            } else {
                phi_431_ = select(_e199, 127i, (_e199 > 127i));
            }
            let _e204 = phi_431_;
            let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
            let _e215 = bitcast<f32>((bitcast<u32>(((_e199 - _e204) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_571_ = type_35(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                let _e217 = bitcast<u32>(_e192);
                let _e219 = ((_e217 & 2139095040u) != 0u);
                let _e234 = bitcast<u32>(_e193);
                let _e236 = ((_e234 & 2139095040u) != 0u);
                let _e251 = bitcast<u32>(_e194);
                let _e253 = ((_e251 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e196);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                phi_571_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e217 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e217 & 2147483648u))), _e192, _e219) * _e209) * select(0.00000011920929f, 1f, _e219)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e234 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e234 & 2147483648u))), _e193, _e236) * _e209) * select(0.00000011920929f, 1f, _e236)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e194, _e253) * _e209) * select(0.00000011920929f, 1f, _e253)) * _e215)), _e175, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e196, _e271) * _e209) * select(0.00000011920929f, 1f, _e271)) * _e215), _e197);
            }
            let _e288 = phi_571_;
            if _e150 {
                let _e289 = (_e143 < arrayLength((&global_7.member)));
                if _e289 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e299 = global_6.member[_e143].member.member_2[0u];
                    let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                    let _e307 = global_6.member[_e143].member.member_2[1u];
                    let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                    let _e315 = global_6.member[_e143].member.member_2[2u];
                    let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                    let _e323 = global_6.member[_e143].member.member[0u];
                    let _e325 = (bitcast<u32>(_e323) & 2147483647u);
                    let _e331 = global_6.member[_e143].member.member[1u];
                    let _e333 = (bitcast<u32>(_e331) & 2147483647u);
                    let _e339 = global_6.member[_e143].member.member[2u];
                    let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                    let _e343 = select(_e309, _e301, (_e309 < _e301));
                    let _e345 = select(_e317, _e343, (_e317 < _e343));
                    let _e347 = select(_e325, _e345, (_e325 < _e345));
                    let _e349 = select(_e333, _e347, (_e333 < _e347));
                    let _e351 = select(_e341, _e349, (_e341 < _e349));
                    let _e356 = global_6.member[_e143].member.member_1;
                    let _e357 = bitcast<u32>(_e356);
                    let _e358 = (_e357 & 2147483647u);
                    let _e366 = global_6.member[_e143].member.member_3;
                    let _e367 = bitcast<u32>(_e366);
                    let _e368 = (_e367 & 2147483647u);
                    let _e372 = (((select(_e358, _e351, (_e358 < _e351)) < 2139095040u) && (_e368 <= 2139095040u)) && (_e345 > 0u));
                    if _e372 {
                        let _e375 = (bitcast<u32>(bitcast<f32>(_e345)) & 2147483647u);
                        if (_e375 >= 8388608u) {
                            phi_677_ = (bitcast<i32>((_e375 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_677_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e375)), 32u, (_e375 == 0u))));
                        }
                        let _e389 = phi_677_;
                        phi_678_ = _e389;
                    } else {
                        phi_678_ = 0i;
                    }
                    let _e391 = phi_678_;
                    let _e392 = (_e301 == _e345);
                    if _e392 {
                        phi_688_ = true;
                    } else {
                        phi_688_ = (_e309 == _e345);
                    }
                    let _e395 = phi_688_;
                    let _e396 = select(1u, 0u, _e392);
                    if _e395 {
                        let _e397 = (_e396 + 1u);
                        phi_698_ = _e397;
                        phi_699_ = _e397;
                        phi_701_ = select(true, false, (_e397 == 2u));
                    } else {
                        phi_698_ = u32();
                        phi_699_ = 0u;
                        phi_701_ = true;
                    }
                    let _e401 = phi_698_;
                    let _e403 = phi_699_;
                    let _e405 = phi_701_;
                    if _e405 {
                        phi_706_ = (_e403 + 1u);
                    } else {
                        phi_706_ = 0u;
                    }
                    let _e409 = phi_706_;
                    let _e410 = select(_e401, _e403, _e405);
                    let _e411 = select(_e396, select(2u, _e396, _e395), _e405);
                    let _e412 = -(_e391);
                    if (_e412 < -126i) {
                        phi_739_ = -126i;
                    } else {
                        phi_739_ = select(_e412, 127i, (_e412 > 127i));
                    }
                    let _e417 = phi_739_;
                    let _e422 = bitcast<f32>((bitcast<u32>((_e417 + 127i)) << bitcast<u32>(23i)));
                    let _e428 = bitcast<f32>((bitcast<u32>(((_e412 - _e417) + 127i)) << bitcast<u32>(23i)));
                    let _e433 = global_6.member[_e143].member.member;
                    let _e434 = (_e410 == 0u);
                    if _e434 {
                        phi_757_ = _e433[0];
                    } else {
                        phi_757_ = _e433[1];
                    }
                    let _e438 = phi_757_;
                    let _e439 = (_e410 == 2u);
                    if _e439 {
                        phi_763_ = _e433[2];
                    } else {
                        phi_763_ = _e438;
                    }
                    let _e442 = phi_763_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e457 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * select(0.00000011920929f, 1f, _e445));
                    let _e458 = global_6.member[_e143].member.member_2;
                    if _e434 {
                        phi_803_ = _e458[0];
                    } else {
                        phi_803_ = _e458[1];
                    }
                    let _e462 = phi_803_;
                    if _e439 {
                        phi_809_ = _e458[2];
                    } else {
                        phi_809_ = _e462;
                    }
                    let _e465 = phi_809_;
                    let _e466 = bitcast<u32>(_e465);
                    let _e468 = ((_e466 & 2139095040u) != 0u);
                    let _e482 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * _e422) * select(0.00000011920929f, 1f, _e468)) * _e428);
                    let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e489 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                    let _e490 = (_e489 * 0.00000011920929f);
                    let _e493 = select(select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f)), 0f, _e486);
                    let _e494 = select(0f, _e482, _e486);
                    let _e495 = (_e457 + _e493);
                    let _e496 = (_e457 - _e493);
                    let _e498 = select(38685626000000000000000000f, (1f / _e482), _e486);
                    let _e499 = (_e409 == 0u);
                    if _e499 {
                        phi_882_ = _e433[0];
                    } else {
                        phi_882_ = _e433[1];
                    }
                    let _e503 = phi_882_;
                    let _e504 = (_e409 == 2u);
                    if _e504 {
                        phi_888_ = _e433[2];
                    } else {
                        phi_888_ = _e503;
                    }
                    let _e507 = phi_888_;
                    let _e508 = bitcast<u32>(_e507);
                    let _e510 = ((_e508 & 2139095040u) != 0u);
                    let _e522 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e508 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e508 & 2147483648u))), _e507, _e510) * select(0.00000011920929f, 1f, _e510));
                    if _e499 {
                        phi_928_ = _e458[0];
                    } else {
                        phi_928_ = _e458[1];
                    }
                    let _e526 = phi_928_;
                    if _e504 {
                        phi_934_ = _e458[2];
                    } else {
                        phi_934_ = _e526;
                    }
                    let _e529 = phi_934_;
                    let _e530 = bitcast<u32>(_e529);
                    let _e532 = ((_e530 & 2139095040u) != 0u);
                    let _e546 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e530 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e530 & 2147483648u))), _e529, _e532) * _e422) * select(0.00000011920929f, 1f, _e532)) * _e428);
                    let _e550 = (bitcast<f32>((bitcast<u32>(_e546) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e553 = bitcast<f32>((bitcast<u32>(_e522) & 2147483647u));
                    let _e554 = (_e553 * 0.00000011920929f);
                    let _e557 = select(select(0.00000000000011368684f, _e554, (_e554 > 0.00000000000011368684f)), 0f, _e550);
                    let _e558 = select(0f, _e546, _e550);
                    let _e559 = (_e522 + _e557);
                    let _e560 = (_e522 - _e557);
                    let _e562 = select(38685626000000000000000000f, (1f / _e546), _e550);
                    let _e563 = (_e411 == 0u);
                    if _e563 {
                        phi_1007_ = _e433[0];
                    } else {
                        phi_1007_ = _e433[1];
                    }
                    let _e567 = phi_1007_;
                    let _e568 = (_e411 == 2u);
                    if _e568 {
                        phi_1013_ = _e433[2];
                    } else {
                        phi_1013_ = _e567;
                    }
                    let _e571 = phi_1013_;
                    let _e572 = bitcast<u32>(_e571);
                    let _e574 = ((_e572 & 2139095040u) != 0u);
                    let _e586 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e572 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e572 & 2147483648u))), _e571, _e574) * select(0.00000011920929f, 1f, _e574));
                    if _e563 {
                        phi_1053_ = _e458[0];
                    } else {
                        phi_1053_ = _e458[1];
                    }
                    let _e590 = phi_1053_;
                    if _e568 {
                        phi_1059_ = _e458[2];
                    } else {
                        phi_1059_ = _e590;
                    }
                    let _e593 = phi_1059_;
                    let _e594 = bitcast<u32>(_e593);
                    let _e596 = ((_e594 & 2139095040u) != 0u);
                    let _e610 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e594 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e594 & 2147483648u))), _e593, _e596) * _e422) * select(0.00000011920929f, 1f, _e596)) * _e428);
                    let _e614 = (bitcast<f32>((bitcast<u32>(_e610) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e617 = bitcast<f32>((bitcast<u32>(_e586) & 2147483647u));
                    let _e618 = (_e617 * 0.00000011920929f);
                    let _e621 = select(select(0.00000000000011368684f, _e618, (_e618 > 0.00000000000011368684f)), 0f, _e614);
                    let _e622 = select(0f, _e610, _e614);
                    let _e623 = (_e586 + _e621);
                    let _e624 = (_e586 - _e621);
                    let _e626 = select(38685626000000000000000000f, (1f / _e610), _e614);
                    let _e628 = select(_e553, _e489, (_e489 > _e553));
                    if (_e372 && (select(_e617, _e628, (_e628 > _e617)) <= 1099511600000f)) {
                        let _e640 = ((_e358 & 8388607u) | (select(0u, 1u, ((_e358 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e643 = bitcast<i32>((_e358 >> bitcast<u32>(23i)));
                        let _e647 = (_e640 == 0u);
                        let _e650 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e640)), 32u, _e647)) - 8i);
                        if (_e643 == 255i) {
                            phi_1178_ = 255i;
                        } else {
                            phi_1178_ = (((_e643 + select(0i, 1i, (_e643 == 0i))) - _e650) + _e391);
                        }
                        let _e658 = phi_1178_;
                        let _e668 = (_e658 <= 0i);
                        if _e668 {
                            phi_1201_ = u32();
                        } else {
                            if _e647 {
                                phi_1200_ = u32();
                            } else {
                                phi_1200_ = select(((bitcast<u32>(_e658) << bitcast<u32>(23i)) | ((_e640 << bitcast<u32>(((_e650 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e658 >= 255i));
                            }
                            let _e672 = phi_1200_;
                            phi_1201_ = _e672;
                        }
                        let _e674 = phi_1201_;
                        let _e686 = ((_e368 & 8388607u) | (select(0u, 1u, ((_e368 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e689 = bitcast<i32>((_e368 >> bitcast<u32>(23i)));
                        let _e693 = (_e686 == 0u);
                        let _e696 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e686)), 32u, _e693)) - 8i);
                        if (_e689 == 255i) {
                            phi_1238_ = 255i;
                        } else {
                            phi_1238_ = (((_e689 + select(0i, 1i, (_e689 == 0i))) - _e696) + _e391);
                        }
                        let _e704 = phi_1238_;
                        let _e714 = (_e704 <= 0i);
                        if _e714 {
                            phi_1261_ = u32();
                        } else {
                            if _e693 {
                                phi_1260_ = u32();
                            } else {
                                phi_1260_ = select(((bitcast<u32>(_e704) << bitcast<u32>(23i)) | ((_e686 << bitcast<u32>(((_e696 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e704 >= 255i));
                            }
                            let _e718 = phi_1260_;
                            phi_1261_ = _e718;
                        }
                        let _e720 = phi_1261_;
                        phi_1269_ = bitcast<f32>(((_e367 & 2147483648u) | select(_e720, 0u, select(_e693, true, _e714))));
                        phi_1270_ = bitcast<f32>(((_e357 & 2147483648u) | select(_e674, 0u, select(_e647, true, _e668))));
                    } else {
                        phi_1269_ = 0f;
                        phi_1270_ = 1f;
                    }
                    let _e726 = phi_1269_;
                    let _e728 = phi_1270_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                    let _e733 = (_e410 % 3u);
                    let _e734 = (_e733 < 3u);
                    if _e734 {
                    } else {
                        break;
                    }
                    let _e736 = local_9[_e733];
                    let _e737 = (_e409 % 3u);
                    let _e738 = (_e737 < 3u);
                    if _e738 {
                    } else {
                        break;
                    }
                    let _e740 = local_9[_e737];
                    let _e741 = (_e411 % 3u);
                    let _e742 = (_e741 < 3u);
                    if _e742 {
                    } else {
                        break;
                    }
                    let _e744 = local_9[_e741];
                    local_8 = array<f32, 3>(bitcast<f32>(_e127), bitcast<f32>(_e131), bitcast<f32>(_e135));
                    if _e734 {
                    } else {
                        break;
                    }
                    let _e748 = local_8[_e733];
                    if _e738 {
                    } else {
                        break;
                    }
                    let _e750 = local_8[_e737];
                    if _e742 {
                    } else {
                        break;
                    }
                    let _e752 = local_8[_e741];
                    phi_4447_ = false;
                    phi_1353_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e726);
                    phi_1356_ = ((3u * _e96) + 1u);
                    phi_1358_ = (_e728 <= _e726);
                    phi_1360_ = 0u;
                    phi_1362_ = type_62(type_54(array<f32, 3>(_e736, _e740, _e744), array<f32, 3>(_e748, _e750, _e752)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e760 = phi_4447_;
                        let _e762 = phi_1353_;
                        let _e764 = phi_1356_;
                        let _e766 = phi_1358_;
                        let _e768 = phi_1360_;
                        let _e770 = phi_1362_;
                        local_10 = _e762;
                        if _e766 {
                            phi_1373_ = true;
                        } else {
                            phi_1373_ = (_e768 > 0u);
                        }
                        let _e773 = phi_1373_;
                        if _e773 {
                            let _e774 = (_e764 > 0u);
                            if _e774 {
                                if _e766 {
                                    phi_1459_ = _e766;
                                    phi_1460_ = _e768;
                                    phi_1461_ = _e770;
                                } else {
                                    let _e775 = (_e768 - 1u);
                                    let _e776 = (_e775 % 128u);
                                    let _e777 = (_e776 < 128u);
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e779 = local_6[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e781 = local_5[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e783 = local_4[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e785 = local_3[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e788 = local_2[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e790 = local_1[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e792 = local[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4656_ = true;
                                        break;
                                    }
                                    let _e797 = local_7[_e776];
                                    phi_1459_ = (_e797 <= _e762.member_1);
                                    phi_1460_ = _e775;
                                    phi_1461_ = type_62(type_54(array<f32, 3>(_e781, _e783, _e785), array<f32, 3>(_e788, _e790, _e792)), _e779);
                                }
                                let _e801 = phi_1459_;
                                let _e803 = phi_1460_;
                                let _e805 = phi_1461_;
                                if _e801 {
                                    let _e809 = ((_e805.member_1 & 2147483648u) != 0u);
                                    if _e809 {
                                        phi_1480_ = _e762;
                                        phi_1483_ = type_8(0u, ((_e805.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e817 = phi_1480_;
                                            let _e819 = phi_1483_;
                                            local_11 = _e817;
                                            if (_e819.member < _e819.member_1) {
                                                phi_1484_ = type_8((_e819.member + 1u), _e819.member_1);
                                                phi_1506_ = type_8(1u, _e819.member);
                                            } else {
                                                phi_1484_ = _e819;
                                                phi_1506_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e832 = phi_1484_;
                                            let _e834 = phi_1506_;
                                            let _e838 = (bitcast<i32>(_e834.member) != 0i);
                                            if _e838 {
                                                let _e839 = ((_e805.member_1 & 268435455u) + _e834.member_1);
                                                let _e840 = (_e839 < arrayLength((&global_10.member)));
                                                if _e840 {
                                                    if _e840 {
                                                    } else {
                                                        phi_4441_ = true;
                                                        break;
                                                    }
                                                    let _e843 = global_10.member[_e839].member_1;
                                                    phi_1531_ = _e843;
                                                } else {
                                                    phi_1531_ = 4294967295u;
                                                }
                                                let _e845 = phi_1531_;
                                                if _e840 {
                                                    if _e840 {
                                                    } else {
                                                        phi_4441_ = true;
                                                        break;
                                                    }
                                                    let _e847 = global_10.member[_e839];
                                                    phi_1547_ = _e847;
                                                } else {
                                                    phi_1547_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e849 = phi_1547_;
                                                let _e861 = ((10u * _e410) & 31u);
                                                let _e864 = ((_e849.member[0] >> bitcast<u32>(_e861)) & 1023u);
                                                let _e872 = bitcast<f32>((bitcast<u32>(((_e805.member.member_1[0] - _e805.member.member[0]) * 0.0009775171f)) ^ _e139));
                                                let _e877 = (_e805.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e864)) - 8388608f) * _e872)) ^ _e139)));
                                                let _e881 = select(select(_e805.member.member_1[0], _e877, (_e877 < _e805.member.member_1[0])), _e805.member.member_1[0], (_e864 == 1023u));
                                                let _e883 = ((10u * _e409) & 31u);
                                                let _e886 = ((_e849.member[0] >> bitcast<u32>(_e883)) & 1023u);
                                                let _e894 = bitcast<f32>((bitcast<u32>(((_e805.member.member_1[1] - _e805.member.member[1]) * 0.0009775171f)) ^ _e139));
                                                let _e899 = (_e805.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e886)) - 8388608f) * _e894)) ^ _e139)));
                                                let _e903 = select(select(_e805.member.member_1[1], _e899, (_e899 < _e805.member.member_1[1])), _e805.member.member_1[1], (_e886 == 1023u));
                                                let _e905 = ((10u * _e411) & 31u);
                                                let _e908 = ((_e849.member[0] >> bitcast<u32>(_e905)) & 1023u);
                                                let _e916 = bitcast<f32>((bitcast<u32>(((_e805.member.member_1[2] - _e805.member.member[2]) * 0.0009775171f)) ^ _e139));
                                                let _e921 = (_e805.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e908)) - 8388608f) * _e916)) ^ _e139)));
                                                let _e925 = select(select(_e805.member.member_1[2], _e921, (_e921 < _e805.member.member_1[2])), _e805.member.member_1[2], (_e908 == 1023u));
                                                let _e929 = ((_e849.member[1] >> bitcast<u32>(_e861)) & 1023u);
                                                let _e937 = (_e805.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e929)) - 8388608f) * _e872)) ^ _e139)));
                                                let _e941 = select(select(_e805.member.member_1[0], _e937, (_e937 < _e805.member.member_1[0])), _e805.member.member_1[0], (_e929 == 1023u));
                                                let _e944 = ((_e849.member[1] >> bitcast<u32>(_e883)) & 1023u);
                                                let _e952 = (_e805.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e944)) - 8388608f) * _e894)) ^ _e139)));
                                                let _e956 = select(select(_e805.member.member_1[1], _e952, (_e952 < _e805.member.member_1[1])), _e805.member.member_1[1], (_e944 == 1023u));
                                                let _e959 = ((_e849.member[1] >> bitcast<u32>(_e905)) & 1023u);
                                                let _e967 = (_e805.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e959)) - 8388608f) * _e916)) ^ _e139)));
                                                let _e971 = select(select(_e805.member.member_1[2], _e967, (_e967 < _e805.member.member_1[2])), _e805.member.member_1[2], (_e959 == 1023u));
                                                let _e975 = ((_e849.member[2] >> bitcast<u32>(_e861)) & 1023u);
                                                let _e983 = (_e805.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e975)) - 8388608f) * _e872)) ^ _e139)));
                                                let _e987 = select(select(_e805.member.member_1[0], _e983, (_e983 < _e805.member.member_1[0])), _e805.member.member_1[0], (_e975 == 1023u));
                                                let _e990 = ((_e849.member[2] >> bitcast<u32>(_e883)) & 1023u);
                                                let _e998 = (_e805.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e990)) - 8388608f) * _e894)) ^ _e139)));
                                                let _e1002 = select(select(_e805.member.member_1[1], _e998, (_e998 < _e805.member.member_1[1])), _e805.member.member_1[1], (_e990 == 1023u));
                                                let _e1005 = ((_e849.member[2] >> bitcast<u32>(_e905)) & 1023u);
                                                let _e1013 = (_e805.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1005)) - 8388608f) * _e916)) ^ _e139)));
                                                let _e1017 = select(select(_e805.member.member_1[2], _e1013, (_e1013 < _e805.member.member_1[2])), _e805.member.member_1[2], (_e1005 == 1023u));
                                                let _e1021 = (_e925 - _e586);
                                                let _e1024 = (((_e881 - _e457) * _e622) - (_e1021 * _e494));
                                                let _e1027 = (((_e903 - _e522) * _e622) - (_e1021 * _e558));
                                                let _e1030 = (_e971 - _e586);
                                                let _e1033 = (((_e941 - _e457) * _e622) - (_e1030 * _e494));
                                                let _e1036 = (((_e956 - _e522) * _e622) - (_e1030 * _e558));
                                                let _e1039 = (_e1017 - _e586);
                                                let _e1042 = (((_e987 - _e457) * _e622) - (_e1039 * _e494));
                                                let _e1045 = (((_e1002 - _e522) * _e622) - (_e1039 * _e558));
                                                let _e1046 = (_e1042 * _e1036);
                                                let _e1047 = (_e1045 * _e1033);
                                                let _e1048 = (_e1024 * _e1045);
                                                let _e1049 = (_e1027 * _e1042);
                                                let _e1050 = (_e1033 * _e1027);
                                                let _e1051 = (_e1036 * _e1024);
                                                let _e1056 = (((_e1046 >= _e1047) && (_e1048 >= _e1049)) && (_e1050 >= _e1051));
                                                let _e1062 = (_e1056 || (((_e1046 <= _e1047) && (_e1048 <= _e1049)) && (_e1050 <= _e1051)));
                                                if _e1062 {
                                                    let _e1064 = select(-1f, 1f, _e1056);
                                                    let _e1066 = ((_e1046 - _e1047) * _e1064);
                                                    let _e1068 = select(0f, _e1066, (_e1066 > 0f));
                                                    let _e1070 = ((_e1048 - _e1049) * _e1064);
                                                    let _e1072 = select(0f, _e1070, (_e1070 > 0f));
                                                    let _e1074 = ((_e1050 - _e1051) * _e1064);
                                                    let _e1076 = select(0f, _e1074, (_e1074 > 0f));
                                                    let _e1078 = ((_e1068 + _e1072) + _e1076);
                                                    let _e1080 = select(_e941, _e881, (_e881 < _e941));
                                                    let _e1084 = select(_e941, _e881, (_e881 > _e941));
                                                    let _e1088 = select(_e956, _e903, (_e903 < _e956));
                                                    let _e1092 = select(_e956, _e903, (_e903 > _e956));
                                                    let _e1096 = select(_e971, _e925, (_e925 < _e971));
                                                    let _e1100 = select(_e971, _e925, (_e925 > _e971));
                                                    let _e1105 = ((select(_e987, _e1080, (_e1080 < _e987)) - _e495) * _e498);
                                                    let _e1106 = ((select(_e987, _e1084, (_e1084 > _e987)) - _e496) * _e498);
                                                    let _e1109 = ((select(_e1002, _e1088, (_e1088 < _e1002)) - _e559) * _e562);
                                                    let _e1110 = ((select(_e1002, _e1092, (_e1092 > _e1002)) - _e560) * _e562);
                                                    let _e1113 = ((select(_e1017, _e1096, (_e1096 < _e1017)) - _e623) * _e626);
                                                    let _e1114 = ((select(_e1017, _e1100, (_e1100 > _e1017)) - _e624) * _e626);
                                                    let _e1116 = select(_e1114, _e1113, (_e1113 < _e1114));
                                                    let _e1118 = select(_e1114, _e1113, (_e1113 > _e1114));
                                                    let _e1120 = select(_e1106, _e1105, (_e1105 < _e1106));
                                                    let _e1122 = select(_e1110, _e1109, (_e1109 < _e1110));
                                                    let _e1124 = select(_e1122, _e1120, (_e1120 > _e1122));
                                                    let _e1126 = select(_e1116, _e1124, (_e1124 > _e1116));
                                                    let _e1128 = select(_e1106, _e1105, (_e1105 > _e1106));
                                                    let _e1130 = select(_e1110, _e1109, (_e1109 > _e1110));
                                                    let _e1132 = select(_e1130, _e1128, (_e1128 < _e1130));
                                                    let _e1134 = select(_e1118, _e1132, (_e1132 < _e1118));
                                                    let _e1135 = -(_e1116);
                                                    let _e1141 = select(_e728, _e1126, (_e1126 > _e728));
                                                    let _e1145 = select(_e1033, _e1024, (_e1024 < _e1033));
                                                    let _e1150 = select(_e1033, _e1024, (_e1024 > _e1033));
                                                    let _e1157 = select(_e1036, _e1027, (_e1027 < _e1036));
                                                    let _e1162 = select(_e1036, _e1027, (_e1027 > _e1036));
                                                    let _e1171 = (((((_e1062 && (_e1078 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1042, _e1145, (_e1145 < _e1042)) <= 0f) && (select(_e1042, _e1150, (_e1150 > _e1042)) >= 0f))) && ((select(_e1045, _e1157, (_e1157 < _e1045)) <= 0f) && (select(_e1045, _e1162, (_e1162 > _e1045)) >= 0f))) && (_e1141 <= (_e1134 + (select(_e1135, _e1118, (_e1118 > _e1135)) * 0.0000019073523f)))) && (_e1141 <= _e817.member_1));
                                                    if _e1171 {
                                                        let _e1176 = (_e941 - _e881);
                                                        let _e1177 = (_e956 - _e903);
                                                        let _e1178 = (_e971 - _e925);
                                                        let _e1179 = vec3<f32>(_e1176, _e1177, _e1178);
                                                        let _e1180 = (_e987 - _e941);
                                                        let _e1181 = (_e1002 - _e956);
                                                        let _e1182 = (_e1017 - _e971);
                                                        let _e1183 = vec3<f32>(_e1180, _e1181, _e1182);
                                                        let _e1184 = (_e881 - _e987);
                                                        let _e1185 = (_e903 - _e1002);
                                                        let _e1186 = (_e925 - _e1017);
                                                        let _e1187 = vec3<f32>(_e1184, _e1185, _e1186);
                                                        let _e1188 = abs(_e1176);
                                                        let _e1189 = abs(_e1177);
                                                        if (_e1188 != _e1188) {
                                                            phi_4168_ = true;
                                                        } else {
                                                            phi_4168_ = (_e1189 >= _e1188);
                                                        }
                                                        let _e1193 = phi_4168_;
                                                        let _e1194 = select(_e1188, _e1189, _e1193);
                                                        let _e1195 = abs(_e1178);
                                                        if (_e1194 != _e1194) {
                                                            phi_4183_ = true;
                                                        } else {
                                                            phi_4183_ = (_e1195 >= _e1194);
                                                        }
                                                        let _e1199 = phi_4183_;
                                                        let _e1200 = select(_e1194, _e1195, _e1199);
                                                        let _e1201 = abs(_e1180);
                                                        let _e1202 = abs(_e1181);
                                                        if (_e1201 != _e1201) {
                                                            phi_4198_ = true;
                                                        } else {
                                                            phi_4198_ = (_e1202 >= _e1201);
                                                        }
                                                        let _e1206 = phi_4198_;
                                                        let _e1207 = select(_e1201, _e1202, _e1206);
                                                        let _e1208 = abs(_e1182);
                                                        if (_e1207 != _e1207) {
                                                            phi_4213_ = true;
                                                        } else {
                                                            phi_4213_ = (_e1208 >= _e1207);
                                                        }
                                                        let _e1212 = phi_4213_;
                                                        let _e1213 = select(_e1207, _e1208, _e1212);
                                                        let _e1214 = abs(_e1184);
                                                        let _e1215 = abs(_e1185);
                                                        if (_e1214 != _e1214) {
                                                            phi_4228_ = true;
                                                        } else {
                                                            phi_4228_ = (_e1215 >= _e1214);
                                                        }
                                                        let _e1219 = phi_4228_;
                                                        let _e1220 = select(_e1214, _e1215, _e1219);
                                                        let _e1221 = abs(_e1186);
                                                        if (_e1220 != _e1220) {
                                                            phi_4243_ = true;
                                                        } else {
                                                            phi_4243_ = (_e1221 >= _e1220);
                                                        }
                                                        let _e1225 = phi_4243_;
                                                        let _e1226 = select(_e1220, _e1221, _e1225);
                                                        let _e1228 = select(_e1213, _e1200, (_e1200 > _e1213));
                                                        let _e1230 = select(_e1226, _e1228, (_e1228 > _e1226));
                                                        if (_e1200 == _e1230) {
                                                            phi_2354_ = _e1036;
                                                            phi_2355_ = _e1033;
                                                            phi_2356_ = _e1027;
                                                            phi_2357_ = _e1024;
                                                            phi_2358_ = vec3<f32>(_e881, _e903, _e925);
                                                            phi_2359_ = _e1187;
                                                            phi_2360_ = _e1183;
                                                            phi_2361_ = _e1179;
                                                        } else {
                                                            let _e1232 = (_e1213 == _e1230);
                                                            let _e1237 = vec3(_e1232);
                                                            phi_2354_ = select(_e1027, _e1045, _e1232);
                                                            phi_2355_ = select(_e1024, _e1042, _e1232);
                                                            phi_2356_ = select(_e1045, _e1036, _e1232);
                                                            phi_2357_ = select(_e1042, _e1033, _e1232);
                                                            phi_2358_ = select(vec3<f32>(_e987, _e1002, _e1017), vec3<f32>(_e941, _e956, _e971), _e1237);
                                                            phi_2359_ = select(_e1183, _e1179, _e1237);
                                                            phi_2360_ = select(_e1179, _e1187, _e1237);
                                                            phi_2361_ = select(_e1187, _e1183, _e1237);
                                                        }
                                                        let _e1243 = phi_2354_;
                                                        let _e1245 = phi_2355_;
                                                        let _e1247 = phi_2356_;
                                                        let _e1249 = phi_2357_;
                                                        let _e1251 = phi_2358_;
                                                        let _e1253 = phi_2359_;
                                                        let _e1255 = phi_2360_;
                                                        let _e1257 = phi_2361_;
                                                        let _e1264 = ((_e1255.y * _e1253.z) - (_e1253.y * _e1255.z));
                                                        let _e1269 = ((_e1255.z * _e1253.x) - (_e1253.z * _e1255.x));
                                                        let _e1272 = ((_e1255.x * _e1253.y) - (_e1253.x * _e1255.y));
                                                        let _e1275 = ((_e1068 >= _e1072) && (_e1068 >= _e1076));
                                                        let _e1276 = (_e1072 >= _e1076);
                                                        let _e1290 = (((_e1264 * (select(select(_e987, _e941, _e1276), _e881, _e1275) - _e457)) + (_e1269 * (select(select(_e1002, _e956, _e1276), _e903, _e1275) - _e522))) + (_e1272 * (select(select(_e1017, _e971, _e1276), _e925, _e1275) - _e586)));
                                                        let _e1295 = (((_e1264 * _e494) + (_e1269 * _e558)) + (_e1272 * _e622));
                                                        let _e1296 = (_e1245 - _e1249);
                                                        let _e1297 = (_e1243 - _e1247);
                                                        let _e1300 = ((_e1296 * _e1296) + (_e1297 * _e1297));
                                                        let _e1307 = (-(((_e1249 * _e1296) + (_e1247 * _e1297))) / select(0.000000000000000000000000000000000000011754944f, _e1300, (_e1300 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1309 = select(1f, _e1307, (_e1307 < 1f));
                                                        let _e1311 = select(0f, _e1309, (_e1309 > 0f));
                                                        let _e1320 = ((_e1251.x + (_e1257.x * _e1311)) - _e457);
                                                        let _e1323 = ((_e1251.y + (_e1257.y * _e1311)) - _e522);
                                                        let _e1326 = ((_e1251.z + (_e1257.z * _e1311)) - _e586);
                                                        let _e1329 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                        let _e1332 = bitcast<f32>((bitcast<u32>(_e1323) & 2147483647u));
                                                        let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                                                        let _e1337 = bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u));
                                                        let _e1339 = select(_e1337, _e1334, (_e1334 > _e1337));
                                                        let _e1343 = abs(_e1264);
                                                        let _e1344 = abs(_e1269);
                                                        if (_e1343 != _e1343) {
                                                            phi_4258_ = true;
                                                        } else {
                                                            phi_4258_ = (_e1344 >= _e1343);
                                                        }
                                                        let _e1348 = phi_4258_;
                                                        let _e1349 = select(_e1343, _e1344, _e1348);
                                                        let _e1350 = abs(_e1272);
                                                        if (_e1349 != _e1349) {
                                                            phi_4273_ = true;
                                                        } else {
                                                            phi_4273_ = (_e1350 >= _e1349);
                                                        }
                                                        let _e1354 = phi_4273_;
                                                        let _e1370 = abs(_e1255.x);
                                                        let _e1371 = abs(_e1255.y);
                                                        if (_e1370 != _e1370) {
                                                            phi_4288_ = true;
                                                        } else {
                                                            phi_4288_ = (_e1371 >= _e1370);
                                                        }
                                                        let _e1375 = phi_4288_;
                                                        let _e1376 = select(_e1370, _e1371, _e1375);
                                                        let _e1377 = abs(_e1255.z);
                                                        if (_e1376 != _e1376) {
                                                            phi_4303_ = true;
                                                        } else {
                                                            phi_4303_ = (_e1377 >= _e1376);
                                                        }
                                                        let _e1381 = phi_4303_;
                                                        let _e1384 = abs(_e1253.x);
                                                        let _e1385 = abs(_e1253.y);
                                                        if (_e1384 != _e1384) {
                                                            phi_4318_ = true;
                                                        } else {
                                                            phi_4318_ = (_e1385 >= _e1384);
                                                        }
                                                        let _e1389 = phi_4318_;
                                                        let _e1390 = select(_e1384, _e1385, _e1389);
                                                        let _e1391 = abs(_e1253.z);
                                                        if (_e1390 != _e1390) {
                                                            phi_4333_ = true;
                                                        } else {
                                                            phi_4333_ = (_e1391 >= _e1390);
                                                        }
                                                        let _e1395 = phi_4333_;
                                                        let _e1400 = ((bitcast<f32>((bitcast<u32>(((((_e1264 * _e1320) + (_e1269 * _e1323)) + (_e1272 * _e1326)) - _e1290)) & 2147483647u)) <= ((0.0000009536743f * select(_e1230, _e1339, (_e1339 > _e1230))) * select(_e1349, _e1350, _e1354))) && !((bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u)) <= ((0.0000038146973f * select(_e1376, _e1377, _e1381)) * select(_e1390, _e1391, _e1395)))));
                                                        let _e1401 = (_e1290 / _e1295);
                                                        if (_e1171 && !(_e1400)) {
                                                            let _e1404 = (_e1326 / _e622);
                                                            let _e1412 = (((_e1264 * (_e1320 - (_e494 * _e1404))) + (_e1269 * (_e1323 - (_e558 * _e1404)))) / _e1295);
                                                            phi_2569_ = select(select(_e1404, (_e1404 + _e1412), (bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u)) <= _e1230)), _e1401, _e1400);
                                                        } else {
                                                            phi_2569_ = _e1401;
                                                        }
                                                        let _e1421 = phi_2569_;
                                                        let _e1423 = select(_e1134, _e1421, (_e1421 < _e1134));
                                                        let _e1425 = select(_e1126, _e1423, (_e1423 > _e1126));
                                                        let _e1426 = (1f / _e1078);
                                                        phi_2589_ = type_40(_e1425, (_e1072 * _e1426), (_e1076 * _e1426), ((_e1171 && (_e1425 >= _e728)) && (_e1425 <= _e817.member_1)));
                                                        phi_2590_ = type_40();
                                                    } else {
                                                        phi_2589_ = type_40();
                                                        phi_2590_ = type_40(0f, 0f, 0f, _e1171);
                                                    }
                                                    let _e1435 = phi_2589_;
                                                    let _e1437 = phi_2590_;
                                                    phi_2593_ = _e1435;
                                                    phi_2594_ = _e1437;
                                                    phi_2595_ = select(true, false, _e1171);
                                                } else {
                                                    phi_2593_ = type_40();
                                                    phi_2594_ = type_40(0f, 0f, 0f, _e1062);
                                                    phi_2595_ = true;
                                                }
                                                let _e1440 = phi_2593_;
                                                let _e1442 = phi_2594_;
                                                let _e1444 = phi_2595_;
                                                if _e1444 {
                                                    phi_2599_ = _e1442;
                                                } else {
                                                    phi_2599_ = _e1440;
                                                }
                                                let _e1446 = phi_2599_;
                                                if _e1446.member_3 {
                                                    phi_2608_ = type_22(_e1446.member, _e1446.member_1, _e1446.member_2, _e845);
                                                } else {
                                                    phi_2608_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1453 = phi_2608_;
                                                if (_e1453.member_3 != 4294967295u) {
                                                    if (_e845 == _e156) {
                                                        phi_2931_ = false;
                                                    } else {
                                                        let _e1457 = (_e845 < arrayLength((&global_4.member)));
                                                        if _e1457 {
                                                            if _e1457 {
                                                            } else {
                                                                phi_4441_ = true;
                                                                break;
                                                            }
                                                            let _e1459 = global_4.member[_e845];
                                                            phi_2631_ = _e1459;
                                                        } else {
                                                            phi_2631_ = 4294967295u;
                                                        }
                                                        let _e1461 = phi_2631_;
                                                        let _e1462 = (_e1461 < arrayLength((&global_5.member)));
                                                        if _e1462 {
                                                            if _e1462 {
                                                            } else {
                                                                phi_4441_ = true;
                                                                break;
                                                            }
                                                            let _e1464 = global_5.member[_e1461];
                                                            phi_2645_ = _e1464;
                                                        } else {
                                                            phi_2645_ = 0i;
                                                        }
                                                        let _e1466 = phi_2645_;
                                                        let _e1467 = (_e1466 == 0i);
                                                        if _e1467 {
                                                            phi_2930_ = true;
                                                        } else {
                                                            if _e434 {
                                                                phi_2664_ = vec3<f32>(_e881, _e903, _e925);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2663_ = vec3<f32>(_e925, _e881, _e903);
                                                                } else {
                                                                    phi_2663_ = vec3<f32>(_e903, _e925, _e881);
                                                                }
                                                                let _e1472 = phi_2663_;
                                                                phi_2664_ = _e1472;
                                                            }
                                                            let _e1475 = phi_2664_;
                                                            if _e434 {
                                                                phi_2679_ = vec3<f32>(_e941, _e956, _e971);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2678_ = vec3<f32>(_e971, _e941, _e956);
                                                                } else {
                                                                    phi_2678_ = vec3<f32>(_e956, _e971, _e941);
                                                                }
                                                                let _e1480 = phi_2678_;
                                                                phi_2679_ = _e1480;
                                                            }
                                                            let _e1483 = phi_2679_;
                                                            if _e434 {
                                                                phi_2694_ = vec3<f32>(_e987, _e1002, _e1017);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2693_ = vec3<f32>(_e1017, _e987, _e1002);
                                                                } else {
                                                                    phi_2693_ = vec3<f32>(_e1002, _e1017, _e987);
                                                                }
                                                                let _e1488 = phi_2693_;
                                                                phi_2694_ = _e1488;
                                                            }
                                                            let _e1491 = phi_2694_;
                                                            let _e1494 = (_e1483.x - _e1475.x);
                                                            let _e1497 = (_e1483.y - _e1475.y);
                                                            let _e1500 = (_e1483.z - _e1475.z);
                                                            let _e1502 = (_e1491.x - _e1475.x);
                                                            let _e1504 = (_e1491.y - _e1475.y);
                                                            let _e1506 = (_e1491.z - _e1475.z);
                                                            if (_e288.member_1 == 1u) {
                                                                phi_2730_ = (vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]) - _e1475);
                                                            } else {
                                                                phi_2730_ = vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]);
                                                            }
                                                            let _e1521 = phi_2730_;
                                                            let _e1527 = bitcast<f32>((bitcast<u32>((_e1494 * _e1504)) ^ _e288.member_3[0]));
                                                            let _e1531 = bitcast<f32>((bitcast<u32>((_e1497 * _e1502)) ^ _e288.member_3[0]));
                                                            let _e1535 = bitcast<f32>((bitcast<u32>((_e1497 * _e1506)) ^ _e288.member_3[0]));
                                                            let _e1539 = bitcast<f32>((bitcast<u32>((_e1500 * _e1504)) ^ _e288.member_3[0]));
                                                            let _e1543 = bitcast<f32>((bitcast<u32>((_e1500 * _e1502)) ^ _e288.member_3[0]));
                                                            let _e1547 = bitcast<f32>((bitcast<u32>((_e1494 * _e1506)) ^ _e288.member_3[0]));
                                                            let _e1548 = (_e1535 - _e1539);
                                                            let _e1549 = (_e1543 - _e1547);
                                                            let _e1550 = (_e1527 - _e1531);
                                                            let _e1574 = (bitcast<f32>((bitcast<u32>(_e1535) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1539) & 2147483647u)));
                                                            let _e1581 = (bitcast<f32>((bitcast<u32>(_e1543) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1547) & 2147483647u)));
                                                            let _e1588 = (bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1531) & 2147483647u)));
                                                            if (_e288.member_2 == 0f) {
                                                                phi_2912_ = 0f;
                                                            } else {
                                                                let _e1618 = bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u));
                                                                let _e1621 = bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u));
                                                                let _e1624 = bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u));
                                                                let _e1626 = select(_e1624, _e1621, (_e1621 > _e1624));
                                                                let _e1630 = select(_e1624, _e1621, (_e1621 < _e1624));
                                                                let _e1634 = select(_e1621, _e1618, (_e1618 < _e1621));
                                                                let _e1636 = select(_e1621, _e1618, (_e1618 > _e1621));
                                                                let _e1638 = select(_e1624, _e1636, (_e1636 < _e1624));
                                                                phi_2912_ = bitcast<f32>((bitcast<u32>((_e288.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1626, _e1618, (_e1618 > _e1626)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1638, _e1634, (_e1634 > _e1638)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1630, _e1618, (_e1618 < _e1630)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1574 + _e1581) + _e1588))) ^ _e288.member_3[0]))) * 1.0000005f)) ^ _e288.member_3[0])))) ^ _e288.member_3[0]));
                                                            }
                                                            let _e1665 = phi_2912_;
                                                            phi_2930_ = (_e1467 || !(((((bitcast<f32>((bitcast<u32>((_e1521.x * _e1548)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1521.y * _e1549)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1521.z * _e1550)) ^ _e288.member_3[0]))) * f32(-(_e1466))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1521.x) & 2147483647u)) * _e1574)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1521.y) & 2147483647u)) * _e1581)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1521.z) & 2147483647u)) * _e1588)) ^ _e288.member_3[0]))))) ^ _e288.member_3[0])) + _e1665) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1679 = phi_2930_;
                                                        phi_2931_ = _e1679;
                                                    }
                                                    let _e1681 = phi_2931_;
                                                    if _e1681 {
                                                        if (_e1453.member < _e817.member.member) {
                                                            phi_2951_ = true;
                                                        } else {
                                                            if (_e1453.member == _e817.member.member) {
                                                                phi_2950_ = (_e1453.member_3 < _e817.member.member_3);
                                                            } else {
                                                                phi_2950_ = false;
                                                            }
                                                            let _e1691 = phi_2950_;
                                                            phi_2951_ = _e1691;
                                                        }
                                                        let _e1693 = phi_2951_;
                                                        if _e1693 {
                                                            phi_2957_ = type_38(_e1453, _e1453.member);
                                                        } else {
                                                            phi_2957_ = _e817;
                                                        }
                                                        let _e1696 = phi_2957_;
                                                        phi_2958_ = _e1696;
                                                    } else {
                                                        phi_2958_ = _e817;
                                                    }
                                                    let _e1698 = phi_2958_;
                                                    phi_2959_ = _e1698;
                                                } else {
                                                    phi_2959_ = _e817;
                                                }
                                                let _e1700 = phi_2959_;
                                                phi_1481_ = _e1700;
                                            } else {
                                                phi_1481_ = type_38();
                                            }
                                            let _e1702 = phi_1481_;
                                            continue;
                                            continuing {
                                                phi_1480_ = _e1702;
                                                phi_1483_ = _e832;
                                                phi_4441_ = _e760;
                                                break if !(_e838);
                                            }
                                        }
                                        let _e1705 = phi_4441_;
                                        phi_4656_ = _e1705;
                                        if _e1705 {
                                            break;
                                        }
                                        phi_4715_ = _e1705;
                                        let _e2375 = local_11;
                                        phi_2960_ = _e2375;
                                    } else {
                                        phi_4715_ = _e760;
                                        phi_2960_ = _e762;
                                    }
                                    let _e1707 = phi_4715_;
                                    let _e1709 = phi_2960_;
                                    if _e809 {
                                        phi_3967_ = bool();
                                        phi_3968_ = u32();
                                        phi_3969_ = type_62();
                                    } else {
                                        let _e1710 = (_e805.member_1 < _e96);
                                        if _e1710 {
                                            if _e1710 {
                                            } else {
                                                phi_4656_ = true;
                                                break;
                                            }
                                            let _e1712 = global_9.member[_e805.member_1];
                                            phi_2981_ = _e1712;
                                        } else {
                                            phi_2981_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1714 = phi_2981_;
                                        let _e1729 = ((10u * _e410) & 31u);
                                        let _e1732 = ((_e1714.member[0] >> bitcast<u32>(_e1729)) & 1023u);
                                        let _e1740 = bitcast<f32>((bitcast<u32>(((_e805.member.member_1[0] - _e805.member.member[0]) * 0.0009775171f)) ^ _e139));
                                        let _e1745 = (_e805.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1732)) - 8388608f) * _e1740)) ^ _e139)));
                                        let _e1749 = select(select(_e805.member.member_1[0], _e1745, (_e1745 < _e805.member.member_1[0])), _e805.member.member_1[0], (_e1732 == 1023u));
                                        let _e1751 = ((10u * _e409) & 31u);
                                        let _e1754 = ((_e1714.member[0] >> bitcast<u32>(_e1751)) & 1023u);
                                        let _e1762 = bitcast<f32>((bitcast<u32>(((_e805.member.member_1[1] - _e805.member.member[1]) * 0.0009775171f)) ^ _e139));
                                        let _e1767 = (_e805.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1754)) - 8388608f) * _e1762)) ^ _e139)));
                                        let _e1771 = select(select(_e805.member.member_1[1], _e1767, (_e1767 < _e805.member.member_1[1])), _e805.member.member_1[1], (_e1754 == 1023u));
                                        let _e1773 = ((10u * _e411) & 31u);
                                        let _e1776 = ((_e1714.member[0] >> bitcast<u32>(_e1773)) & 1023u);
                                        let _e1784 = bitcast<f32>((bitcast<u32>(((_e805.member.member_1[2] - _e805.member.member[2]) * 0.0009775171f)) ^ _e139));
                                        let _e1789 = (_e805.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1776)) - 8388608f) * _e1784)) ^ _e139)));
                                        let _e1793 = select(select(_e805.member.member_1[2], _e1789, (_e1789 < _e805.member.member_1[2])), _e805.member.member_1[2], (_e1776 == 1023u));
                                        let _e1796 = ((_e1714.member[1] >> bitcast<u32>(_e1729)) & 1023u);
                                        let _e1804 = (_e805.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1796)) - 8388608f) * _e1740)) ^ _e139)));
                                        let _e1808 = select(select(_e805.member.member_1[0], _e1804, (_e1804 < _e805.member.member_1[0])), _e805.member.member_1[0], (_e1796 == 1023u));
                                        let _e1811 = ((_e1714.member[1] >> bitcast<u32>(_e1751)) & 1023u);
                                        let _e1819 = (_e805.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1811)) - 8388608f) * _e1762)) ^ _e139)));
                                        let _e1823 = select(select(_e805.member.member_1[1], _e1819, (_e1819 < _e805.member.member_1[1])), _e805.member.member_1[1], (_e1811 == 1023u));
                                        let _e1826 = ((_e1714.member[1] >> bitcast<u32>(_e1773)) & 1023u);
                                        let _e1834 = (_e805.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1826)) - 8388608f) * _e1784)) ^ _e139)));
                                        let _e1838 = select(select(_e805.member.member_1[2], _e1834, (_e1834 < _e805.member.member_1[2])), _e805.member.member_1[2], (_e1826 == 1023u));
                                        let _e1844 = ((_e1714.member_1[0] >> bitcast<u32>(_e1729)) & 1023u);
                                        let _e1852 = (_e805.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1844)) - 8388608f) * _e1740)) ^ _e139)));
                                        let _e1856 = select(select(_e805.member.member_1[0], _e1852, (_e1852 < _e805.member.member_1[0])), _e805.member.member_1[0], (_e1844 == 1023u));
                                        let _e1859 = ((_e1714.member_1[0] >> bitcast<u32>(_e1751)) & 1023u);
                                        let _e1867 = (_e805.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1859)) - 8388608f) * _e1762)) ^ _e139)));
                                        let _e1871 = select(select(_e805.member.member_1[1], _e1867, (_e1867 < _e805.member.member_1[1])), _e805.member.member_1[1], (_e1859 == 1023u));
                                        let _e1874 = ((_e1714.member_1[0] >> bitcast<u32>(_e1773)) & 1023u);
                                        let _e1882 = (_e805.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1874)) - 8388608f) * _e1784)) ^ _e139)));
                                        let _e1886 = select(select(_e805.member.member_1[2], _e1882, (_e1882 < _e805.member.member_1[2])), _e805.member.member_1[2], (_e1874 == 1023u));
                                        let _e1889 = ((_e1714.member_1[1] >> bitcast<u32>(_e1729)) & 1023u);
                                        let _e1897 = (_e805.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1889)) - 8388608f) * _e1740)) ^ _e139)));
                                        let _e1901 = select(select(_e805.member.member_1[0], _e1897, (_e1897 < _e805.member.member_1[0])), _e805.member.member_1[0], (_e1889 == 1023u));
                                        let _e1904 = ((_e1714.member_1[1] >> bitcast<u32>(_e1751)) & 1023u);
                                        let _e1912 = (_e805.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1904)) - 8388608f) * _e1762)) ^ _e139)));
                                        let _e1916 = select(select(_e805.member.member_1[1], _e1912, (_e1912 < _e805.member.member_1[1])), _e805.member.member_1[1], (_e1904 == 1023u));
                                        let _e1919 = ((_e1714.member_1[1] >> bitcast<u32>(_e1773)) & 1023u);
                                        let _e1927 = (_e805.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1919)) - 8388608f) * _e1784)) ^ _e139)));
                                        let _e1931 = select(select(_e805.member.member_1[2], _e1927, (_e1927 < _e805.member.member_1[2])), _e805.member.member_1[2], (_e1919 == 1023u));
                                        let _e1936 = type_62(type_54(array<f32, 3>(_e1749, _e1771, _e1793), array<f32, 3>(_e1808, _e1823, _e1838)), _e1714.member_2);
                                        let _e1941 = type_62(type_54(array<f32, 3>(_e1856, _e1871, _e1886), array<f32, 3>(_e1901, _e1916, _e1931)), _e1714.member_3);
                                        let _e1947 = ((_e1749 - _e495) * _e498);
                                        let _e1948 = ((_e1856 - _e495) * _e498);
                                        let _e1949 = ((_e1808 - _e496) * _e498);
                                        let _e1950 = ((_e1901 - _e496) * _e498);
                                        let _e1955 = ((_e1771 - _e559) * _e562);
                                        let _e1956 = ((_e1871 - _e559) * _e562);
                                        let _e1957 = ((_e1823 - _e560) * _e562);
                                        let _e1958 = ((_e1916 - _e560) * _e562);
                                        let _e1963 = ((_e1793 - _e623) * _e626);
                                        let _e1964 = ((_e1886 - _e623) * _e626);
                                        let _e1965 = ((_e1838 - _e624) * _e626);
                                        let _e1966 = ((_e1931 - _e624) * _e626);
                                        let _e1968 = select(_e1965, _e1963, (_e1963 < _e1965));
                                        let _e1970 = select(_e1966, _e1964, (_e1964 < _e1966));
                                        let _e1972 = select(_e1965, _e1963, (_e1963 > _e1965));
                                        let _e1974 = select(_e1966, _e1964, (_e1964 > _e1966));
                                        let _e1976 = select(_e1949, _e1947, (_e1947 < _e1949));
                                        let _e1978 = select(_e1950, _e1948, (_e1948 < _e1950));
                                        let _e1980 = select(_e1957, _e1955, (_e1955 < _e1957));
                                        let _e1982 = select(_e1958, _e1956, (_e1956 < _e1958));
                                        let _e1984 = select(_e1980, _e1976, (_e1976 > _e1980));
                                        let _e1986 = select(_e1982, _e1978, (_e1978 > _e1982));
                                        let _e1988 = select(_e1968, _e1984, (_e1984 > _e1968));
                                        let _e1990 = select(_e1970, _e1986, (_e1986 > _e1970));
                                        let _e1992 = select(_e1949, _e1947, (_e1947 > _e1949));
                                        let _e1994 = select(_e1950, _e1948, (_e1948 > _e1950));
                                        let _e1996 = select(_e1957, _e1955, (_e1955 > _e1957));
                                        let _e1998 = select(_e1958, _e1956, (_e1956 > _e1958));
                                        let _e2000 = select(_e1996, _e1992, (_e1992 < _e1996));
                                        let _e2002 = select(_e1998, _e1994, (_e1994 < _e1998));
                                        let _e2007 = -(_e1968);
                                        let _e2008 = -(_e1970);
                                        let _e2015 = (select(_e1972, _e2000, (_e2000 < _e1972)) + (select(_e2007, _e1972, (_e1972 > _e2007)) * 0.0000019073523f));
                                        let _e2016 = (select(_e1974, _e2002, (_e2002 < _e1974)) + (select(_e2008, _e1974, (_e1974 > _e2008)) * 0.0000019073523f));
                                        let _e2018 = select(_e728, _e1988, (_e1988 > _e728));
                                        let _e2020 = select(_e728, _e1990, (_e1990 > _e728));
                                        let _e2025 = (_e2018 <= select(_e1709.member_1, _e2015, (_e2015 < _e1709.member_1)));
                                        let _e2026 = (_e2020 <= select(_e1709.member_1, _e2016, (_e2016 < _e1709.member_1)));
                                        let _e2027 = (_e2018 <= _e2020);
                                        if _e2025 {
                                            if _e2026 {
                                                if _e2027 {
                                                    phi_3867_ = _e1941;
                                                } else {
                                                    phi_3867_ = _e1936;
                                                }
                                                let _e2029 = phi_3867_;
                                                let _e2036 = (_e803 % 128u);
                                                let _e2037 = (_e2036 < 128u);
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local_6[_e2036] = _e2029.member_1;
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local_5[_e2036] = _e2029.member.member[0];
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local_4[_e2036] = _e2029.member.member[1];
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local_3[_e2036] = _e2029.member.member[2];
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local_2[_e2036] = _e2029.member.member_1[0];
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local_1[_e2036] = _e2029.member.member_1[1];
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local[_e2036] = _e2029.member.member_1[2];
                                                if _e2037 {
                                                } else {
                                                    phi_4656_ = true;
                                                    break;
                                                }
                                                local_7[_e2036] = select(_e2018, _e2020, _e2027);
                                                if _e2027 {
                                                    phi_3943_ = _e1936;
                                                } else {
                                                    phi_3943_ = _e1941;
                                                }
                                                let _e2054 = phi_3943_;
                                                phi_3944_ = (_e803 + 1u);
                                                phi_3945_ = _e2054;
                                            } else {
                                                phi_3944_ = u32();
                                                phi_3945_ = type_62();
                                            }
                                            let _e2056 = phi_3944_;
                                            let _e2058 = phi_3945_;
                                            phi_3947_ = _e2056;
                                            phi_3948_ = _e2058;
                                            phi_3949_ = select(true, false, _e2026);
                                        } else {
                                            phi_3947_ = u32();
                                            phi_3948_ = type_62();
                                            phi_3949_ = true;
                                        }
                                        let _e2061 = phi_3947_;
                                        let _e2063 = phi_3948_;
                                        let _e2065 = phi_3949_;
                                        if _e2065 {
                                            if _e2025 {
                                                phi_3956_ = _e1936;
                                            } else {
                                                phi_3956_ = _e1941;
                                            }
                                            let _e2067 = phi_3956_;
                                            phi_3961_ = select(_e2026, true, _e2025);
                                            phi_3963_ = _e2067;
                                        } else {
                                            phi_3961_ = _e801;
                                            phi_3963_ = _e2063;
                                        }
                                        let _e2070 = phi_3961_;
                                        let _e2072 = phi_3963_;
                                        phi_3967_ = _e2070;
                                        phi_3968_ = select(_e2061, _e803, _e2065);
                                        phi_3969_ = _e2072;
                                    }
                                    let _e2075 = phi_3967_;
                                    let _e2077 = phi_3968_;
                                    let _e2079 = phi_3969_;
                                    if _e809 {
                                        phi_3979_ = _e805;
                                    } else {
                                        phi_3979_ = _e2079;
                                    }
                                    let _e2081 = phi_3979_;
                                    phi_4659_ = _e1707;
                                    phi_3980_ = _e1709;
                                    phi_3981_ = (_e764 - 1u);
                                    phi_3982_ = select(_e2075, false, _e809);
                                    phi_3983_ = select(_e2077, _e803, _e809);
                                    phi_3984_ = _e2081;
                                } else {
                                    phi_4659_ = _e760;
                                    phi_3980_ = _e762;
                                    phi_3981_ = _e764;
                                    phi_3982_ = _e801;
                                    phi_3983_ = _e803;
                                    phi_3984_ = _e805;
                                }
                                let _e2085 = phi_4659_;
                                let _e2087 = phi_3980_;
                                let _e2089 = phi_3981_;
                                let _e2091 = phi_3982_;
                                let _e2093 = phi_3983_;
                                let _e2095 = phi_3984_;
                                phi_4658_ = _e2085;
                                phi_3985_ = _e2087;
                                phi_3986_ = _e2089;
                                phi_3987_ = _e2091;
                                phi_3988_ = _e2093;
                                phi_3989_ = _e2095;
                            } else {
                                phi_4658_ = _e760;
                                phi_3985_ = type_38();
                                phi_3986_ = u32();
                                phi_3987_ = bool();
                                phi_3988_ = u32();
                                phi_3989_ = type_62();
                            }
                            let _e2097 = phi_4658_;
                            let _e2099 = phi_3985_;
                            let _e2101 = phi_3986_;
                            let _e2103 = phi_3987_;
                            let _e2105 = phi_3988_;
                            let _e2107 = phi_3989_;
                            phi_4657_ = _e2097;
                            phi_1354_ = _e2099;
                            phi_1357_ = _e2101;
                            phi_1359_ = _e2103;
                            phi_1361_ = _e2105;
                            phi_1363_ = _e2107;
                            phi_3990_ = _e774;
                        } else {
                            phi_4657_ = _e760;
                            phi_1354_ = type_38();
                            phi_1357_ = u32();
                            phi_1359_ = bool();
                            phi_1361_ = u32();
                            phi_1363_ = type_62();
                            phi_3990_ = false;
                        }
                        let _e2109 = phi_4657_;
                        let _e2111 = phi_1354_;
                        let _e2113 = phi_1357_;
                        let _e2115 = phi_1359_;
                        let _e2117 = phi_1361_;
                        let _e2119 = phi_1363_;
                        let _e2121 = phi_3990_;
                        continue;
                        continuing {
                            phi_4447_ = _e2109;
                            phi_1353_ = _e2111;
                            phi_1356_ = _e2113;
                            phi_1358_ = _e2115;
                            phi_1360_ = _e2117;
                            phi_1362_ = _e2119;
                            phi_4656_ = _e2109;
                            break if !(_e2121);
                        }
                    }
                    let _e2124 = phi_4656_;
                    if _e2124 {
                        break;
                    }
                    let _e2126 = local_10;
                    if (_e2126.member.member_3 != 4294967295u) {
                        let _e2131 = bitcast<u32>(_e2126.member.member);
                        let _e2135 = (bitcast<i32>((_e2131 >> bitcast<u32>(23i))) & 255i);
                        let _e2136 = (_e2135 + _e412);
                        if (_e2135 == 255i) {
                            phi_4049_ = _e2126.member.member;
                        } else {
                            if (_e2135 > 0i) {
                                if (_e2136 > 0i) {
                                    let _e2140 = (_e2136 < 255i);
                                    if _e2140 {
                                        phi_4028_ = bitcast<f32>((_e2131 + bitcast<u32>((_e412 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4028_ = f32();
                                    }
                                    let _e2147 = phi_4028_;
                                    phi_4030_ = _e2147;
                                    phi_4031_ = select(true, false, _e2140);
                                } else {
                                    phi_4030_ = f32();
                                    phi_4031_ = true;
                                }
                                let _e2150 = phi_4030_;
                                let _e2152 = phi_4031_;
                                phi_4032_ = _e2150;
                                phi_4033_ = _e2152;
                            } else {
                                phi_4032_ = f32();
                                phi_4033_ = true;
                            }
                            let _e2154 = phi_4032_;
                            let _e2156 = phi_4033_;
                            if _e2156 {
                                let _e2157 = (_e2131 & 2147483648u);
                                let _e2164 = ((_e2131 & 8388607u) | (select(0u, 1u, ((_e2131 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2168 = (_e2164 == 0u);
                                if _e2168 {
                                    phi_4411_ = bitcast<f32>(_e2157);
                                } else {
                                    let _e2173 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2164)), 32u, _e2168) - 8u);
                                    let _e2176 = (_e2164 << bitcast<u32>((_e2173 & 31u)));
                                    let _e2178 = ((_e2136 + select(0i, 1i, (_e2135 == 0i))) - bitcast<i32>(_e2173));
                                    if (_e2178 >= 255i) {
                                        phi_4401_ = bitcast<f32>((_e2157 | 2139095040u));
                                        phi_4402_ = f32();
                                        phi_4403_ = true;
                                    } else {
                                        let _e2180 = (_e2178 > 0i);
                                        if _e2180 {
                                            phi_4395_ = bitcast<f32>(((_e2157 | (bitcast<u32>(_e2178) << bitcast<u32>(23i))) | (_e2176 & 8388607u)));
                                            phi_4396_ = f32();
                                        } else {
                                            if (_e2178 < -24i) {
                                                phi_4361_ = 26u;
                                            } else {
                                                phi_4361_ = bitcast<u32>((1i - _e2178));
                                            }
                                            let _e2185 = phi_4361_;
                                            let _e2186 = (_e2185 & 31u);
                                            let _e2188 = (_e2176 >> bitcast<u32>(_e2186));
                                            let _e2192 = (_e2176 & ((1u << bitcast<u32>(_e2186)) - 1u));
                                            let _e2196 = (1u << bitcast<u32>(((_e2185 - 1u) & 31u)));
                                            if (_e2192 > _e2196) {
                                                phi_4382_ = true;
                                            } else {
                                                if (_e2192 == _e2196) {
                                                    phi_4379_ = ((_e2188 & 1u) == 1u);
                                                } else {
                                                    phi_4379_ = false;
                                                }
                                                let _e2202 = phi_4379_;
                                                phi_4382_ = _e2202;
                                            }
                                            let _e2204 = phi_4382_;
                                            phi_4395_ = f32();
                                            phi_4396_ = bitcast<f32>((_e2157 | (_e2188 + select(0u, 1u, _e2204))));
                                        }
                                        let _e2217 = phi_4395_;
                                        let _e2219 = phi_4396_;
                                        phi_4401_ = _e2217;
                                        phi_4402_ = _e2219;
                                        phi_4403_ = _e2180;
                                    }
                                    let _e2223 = phi_4401_;
                                    let _e2225 = phi_4402_;
                                    let _e2227 = phi_4403_;
                                    phi_4411_ = select(_e2225, _e2223, _e2227);
                                }
                                let _e2231 = phi_4411_;
                                phi_4048_ = _e2231;
                            } else {
                                phi_4048_ = _e2154;
                            }
                            let _e2233 = phi_4048_;
                            phi_4049_ = _e2233;
                        }
                        let _e2235 = phi_4049_;
                        let _e2236 = bitcast<u32>(_e2235);
                        if ((_e2236 & 2147483647u) >= 2139095040u) {
                            phi_4061_ = bitcast<f32>(((_e2236 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4061_ = _e2235;
                        }
                        let _e2243 = phi_4061_;
                        phi_4066_ = type_22(_e2243, _e2126.member.member_1, _e2126.member.member_2, _e2126.member.member_3);
                    } else {
                        phi_4066_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2248 = phi_4066_;
                    if _e289 {
                    } else {
                        break;
                    }
                    global_7.member[_e143] = _e2248;
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e2252 = select(0u, 1u, (_e356 <= _e366));
                    if (_e2252 > 0u) {
                        let _e2254 = (1u < _e111);
                        if _e2254 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e2258 = atomicAdd((&global_8.member[0u]), _e2252);
                            if ((_e2258 + _e2252) < _e2258) {
                                if _e2254 {
                                } else {
                                    break;
                                }
                                let _e2263 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2266 = select(0u, 1u, (_e2248.member_3 != 4294967295u));
                    if (_e2266 > 0u) {
                        let _e2268 = (3u < _e111);
                        if _e2268 {
                            if (2u < _e111) {
                            } else {
                                break;
                            }
                            let _e2272 = atomicAdd((&global_8.member[2u]), _e2266);
                            if ((_e2272 + _e2266) < _e2272) {
                                if _e2268 {
                                } else {
                                    break;
                                }
                                let _e2277 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
