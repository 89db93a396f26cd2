struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
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

struct type_35 {
    member: type_18,
    member_1: f32,
}

struct type_38 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_39 {
    member: type_35,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_30,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

struct type_56 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_20;
@group(0) @binding(0) 
var<uniform> global_2: type_41;
@group(0) @binding(3) 
var<storage> global_3: type_25;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_56;
@group(0) @binding(1) 
var<storage> global_6: type_45;
@group(0) @binding(2) 
var<storage> global_7: type_4;

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
    var phi_513_: i32;
    var phi_514_: i32;
    var phi_524_: bool;
    var phi_534_: u32;
    var phi_535_: u32;
    var phi_537_: bool;
    var phi_542_: u32;
    var phi_575_: i32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_718_: f32;
    var phi_724_: f32;
    var phi_764_: f32;
    var phi_770_: f32;
    var phi_843_: f32;
    var phi_849_: f32;
    var phi_889_: f32;
    var phi_895_: f32;
    var phi_1014_: i32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1074_: i32;
    var phi_1096_: u32;
    var phi_1097_: u32;
    var phi_1105_: f32;
    var phi_1106_: f32;
    var phi_4886_: bool;
    var phi_1211_: type_39;
    var phi_1214_: u32;
    var phi_1216_: bool;
    var phi_1218_: u32;
    var phi_1220_: type_50;
    var phi_1231_: bool;
    var phi_1317_: bool;
    var phi_1318_: u32;
    var phi_1319_: type_50;
    var phi_1338_: type_39;
    var phi_1341_: type_8;
    var phi_1342_: type_8;
    var phi_1364_: type_8;
    var phi_1408_: u32;
    var phi_1414_: u32;
    var phi_1424_: u32;
    var phi_1440_: u32;
    var phi_1473_: u32;
    var phi_1479_: u32;
    var phi_1945_: u32;
    var phi_1963_: u32;
    var phi_1981_: u32;
    var phi_2004_: u32;
    var phi_2022_: u32;
    var phi_2040_: u32;
    var phi_2063_: u32;
    var phi_2081_: u32;
    var phi_2099_: u32;
    var phi_1653_: u32;
    var phi_1668_: u32;
    var phi_1678_: u32;
    var phi_1699_: u32;
    var phi_1720_: u32;
    var phi_1750_: u32;
    var phi_1765_: u32;
    var phi_1775_: u32;
    var phi_1796_: u32;
    var phi_1817_: u32;
    var phi_1847_: u32;
    var phi_1862_: u32;
    var phi_1872_: u32;
    var phi_1893_: u32;
    var phi_1914_: u32;
    var phi_1506_: u32;
    var phi_1555_: u32;
    var phi_1604_: u32;
    var phi_2105_: array<array<f32, 3>, 3>;
    var phi_4447_: bool;
    var phi_4462_: bool;
    var phi_4477_: bool;
    var phi_4492_: bool;
    var phi_4507_: bool;
    var phi_4522_: bool;
    var phi_2647_: f32;
    var phi_2648_: f32;
    var phi_2649_: f32;
    var phi_2650_: f32;
    var phi_2651_: vec3<f32>;
    var phi_2652_: vec3<f32>;
    var phi_2653_: vec3<f32>;
    var phi_2654_: vec3<f32>;
    var phi_4537_: bool;
    var phi_4552_: bool;
    var phi_4567_: bool;
    var phi_4582_: bool;
    var phi_4597_: bool;
    var phi_4612_: bool;
    var phi_2862_: f32;
    var phi_2882_: type_38;
    var phi_2883_: type_38;
    var phi_2886_: type_38;
    var phi_2887_: type_38;
    var phi_2888_: bool;
    var phi_2892_: type_38;
    var phi_2901_: type_18;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2934_: type_39;
    var phi_2935_: type_39;
    var phi_2936_: type_39;
    var phi_1339_: type_39;
    var phi_4880_: bool;
    var phi_5183_: bool;
    var phi_2937_: type_39;
    var phi_3439_: u32;
    var phi_3445_: u32;
    var phi_3699_: u32;
    var phi_3700_: u32;
    var phi_3710_: u32;
    var phi_3712_: u32;
    var phi_3713_: bool;
    var phi_3733_: u32;
    var phi_3734_: u32;
    var phi_3738_: type_51;
    var phi_4103_: type_50;
    var phi_4179_: type_50;
    var phi_4180_: u32;
    var phi_4181_: type_50;
    var phi_4183_: u32;
    var phi_4184_: type_50;
    var phi_4185_: bool;
    var phi_4194_: type_50;
    var phi_4199_: bool;
    var phi_4201_: type_50;
    var phi_4206_: type_39;
    var phi_4207_: bool;
    var phi_4208_: u32;
    var phi_4209_: type_50;
    var phi_4217_: type_39;
    var phi_4220_: type_50;
    var phi_5095_: bool;
    var phi_4221_: type_39;
    var phi_4222_: u32;
    var phi_4223_: bool;
    var phi_4224_: u32;
    var phi_4225_: type_50;
    var phi_5094_: bool;
    var phi_4226_: type_39;
    var phi_4227_: u32;
    var phi_4228_: bool;
    var phi_4229_: u32;
    var phi_4230_: type_50;
    var phi_5093_: bool;
    var phi_1212_: type_39;
    var phi_1215_: u32;
    var phi_1217_: bool;
    var phi_1219_: u32;
    var phi_1221_: type_50;
    var phi_4231_: bool;
    var phi_5092_: bool;
    var local_10: type_39;
    var phi_4269_: f32;
    var phi_4271_: f32;
    var phi_4272_: bool;
    var phi_4273_: f32;
    var phi_4274_: bool;
    var phi_4788_: u32;
    var phi_4806_: bool;
    var phi_4809_: bool;
    var phi_4822_: f32;
    var phi_4823_: f32;
    var phi_4828_: f32;
    var phi_4829_: f32;
    var phi_4830_: bool;
    var phi_4838_: f32;
    var phi_4289_: f32;
    var phi_4290_: f32;
    var phi_4302_: f32;
    var phi_4307_: type_18;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_6.member));
            let _e100 = arrayLength((&global_7.member));
            let _e108 = arrayLength((&global_5.member));
            let _e112 = global_2.member[0u][0u];
            let _e116 = global_2.member[0u][1u];
            let _e120 = global_2.member[0u][2u];
            let _e124 = global_2.member[0u][3u];
            let _e128 = global_2.member[1u][0u];
            let _e132 = global_2.member[1u][1u];
            let _e136 = global_2.member[1u][2u];
            let _e140 = (_e95.x + (_e95.y * 2097152u));
            let _e152 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e124) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            local = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            let _e155 = (_e140 < arrayLength((&global_3.member)));
            if _e155 {
                let _e156 = (_e140 < arrayLength((&global_1.member)));
                if _e156 {
                    let _e157 = (_e140 < arrayLength((&global_4.member)));
                    if _e157 {
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e167 = global_3.member[_e140].member.member_2[0u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_3.member[_e140].member.member_2[1u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_3.member[_e140].member.member_2[2u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_3.member[_e140].member.member[0u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e199 = global_3.member[_e140].member.member[1u];
                        let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                        let _e207 = global_3.member[_e140].member.member[2u];
                        let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                        let _e211 = select(_e177, _e169, (_e177 < _e169));
                        let _e213 = select(_e185, _e211, (_e185 < _e211));
                        let _e215 = select(_e193, _e213, (_e193 < _e213));
                        let _e217 = select(_e201, _e215, (_e201 < _e215));
                        let _e219 = select(_e209, _e217, (_e209 < _e217));
                        let _e224 = global_3.member[_e140].member.member_1;
                        let _e225 = bitcast<u32>(_e224);
                        let _e226 = (_e225 & 2147483647u);
                        let _e234 = global_3.member[_e140].member.member_3;
                        let _e235 = bitcast<u32>(_e234);
                        let _e236 = (_e235 & 2147483647u);
                        let _e240 = (((select(_e226, _e219, (_e226 < _e219)) < 2139095040u) && (_e236 <= 2139095040u)) && (_e213 > 0u));
                        if _e240 {
                            let _e243 = (bitcast<u32>(bitcast<f32>(_e213)) & 2147483647u);
                            if (_e243 >= 8388608u) {
                                phi_513_ = (bitcast<i32>((_e243 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_513_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e243)), 32u, (_e243 == 0u))));
                            }
                            let _e257 = phi_513_;
                            phi_514_ = _e257;
                        } else {
                            phi_514_ = 0i;
                        }
                        let _e259 = phi_514_;
                        let _e260 = (_e169 == _e213);
                        if _e260 {
                            phi_524_ = true;
                        } else {
                            phi_524_ = (_e177 == _e213);
                        }
                        let _e263 = phi_524_;
                        let _e264 = select(1u, 0u, _e260);
                        if _e263 {
                            let _e265 = (_e264 + 1u);
                            phi_534_ = _e265;
                            phi_535_ = _e265;
                            phi_537_ = select(true, false, (_e265 == 2u));
                        } else {
                            phi_534_ = u32();
                            phi_535_ = 0u;
                            phi_537_ = true;
                        }
                        let _e269 = phi_534_;
                        let _e271 = phi_535_;
                        let _e273 = phi_537_;
                        if _e273 {
                            phi_542_ = (_e271 + 1u);
                        } else {
                            phi_542_ = 0u;
                        }
                        let _e277 = phi_542_;
                        let _e278 = select(_e269, _e271, _e273);
                        let _e279 = select(_e264, select(2u, _e264, _e263), _e273);
                        let _e280 = -(_e259);
                        if (_e280 < -126i) {
                            phi_575_ = -126i;
                        } else {
                            phi_575_ = select(_e280, 127i, (_e280 > 127i));
                        }
                        let _e285 = phi_575_;
                        let _e290 = bitcast<f32>((bitcast<u32>((_e285 + 127i)) << bitcast<u32>(23i)));
                        let _e296 = bitcast<f32>((bitcast<u32>(((_e280 - _e285) + 127i)) << bitcast<u32>(23i)));
                        let _e301 = global_3.member[_e140].member.member;
                        let _e302 = (_e278 == 0u);
                        if _e302 {
                            phi_593_ = _e301[0];
                        } else {
                            phi_593_ = _e301[1];
                        }
                        let _e306 = phi_593_;
                        let _e307 = (_e278 == 2u);
                        if _e307 {
                            phi_599_ = _e301[2];
                        } else {
                            phi_599_ = _e306;
                        }
                        let _e310 = phi_599_;
                        let _e311 = bitcast<u32>(_e310);
                        let _e313 = ((_e311 & 2139095040u) != 0u);
                        let _e325 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e311 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e311 & 2147483648u))), _e310, _e313) * select(0.00000011920929f, 1f, _e313));
                        let _e326 = global_3.member[_e140].member.member_2;
                        if _e302 {
                            phi_639_ = _e326[0];
                        } else {
                            phi_639_ = _e326[1];
                        }
                        let _e330 = phi_639_;
                        if _e307 {
                            phi_645_ = _e326[2];
                        } else {
                            phi_645_ = _e330;
                        }
                        let _e333 = phi_645_;
                        let _e334 = bitcast<u32>(_e333);
                        let _e336 = ((_e334 & 2139095040u) != 0u);
                        let _e350 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e334 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e334 & 2147483648u))), _e333, _e336) * _e290) * select(0.00000011920929f, 1f, _e336)) * _e296);
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e357 = bitcast<f32>((bitcast<u32>(_e325) & 2147483647u));
                        let _e358 = (_e357 * 0.00000011920929f);
                        let _e361 = select(select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f)), 0f, _e354);
                        let _e362 = select(0f, _e350, _e354);
                        let _e363 = (_e325 + _e361);
                        let _e364 = (_e325 - _e361);
                        let _e366 = select(38685626000000000000000000f, (1f / _e350), _e354);
                        let _e367 = (_e277 == 0u);
                        if _e367 {
                            phi_718_ = _e301[0];
                        } else {
                            phi_718_ = _e301[1];
                        }
                        let _e371 = phi_718_;
                        let _e372 = (_e277 == 2u);
                        if _e372 {
                            phi_724_ = _e301[2];
                        } else {
                            phi_724_ = _e371;
                        }
                        let _e375 = phi_724_;
                        let _e376 = bitcast<u32>(_e375);
                        let _e378 = ((_e376 & 2139095040u) != 0u);
                        let _e390 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e376 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e376 & 2147483648u))), _e375, _e378) * select(0.00000011920929f, 1f, _e378));
                        if _e367 {
                            phi_764_ = _e326[0];
                        } else {
                            phi_764_ = _e326[1];
                        }
                        let _e394 = phi_764_;
                        if _e372 {
                            phi_770_ = _e326[2];
                        } else {
                            phi_770_ = _e394;
                        }
                        let _e397 = phi_770_;
                        let _e398 = bitcast<u32>(_e397);
                        let _e400 = ((_e398 & 2139095040u) != 0u);
                        let _e414 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e397, _e400) * _e290) * select(0.00000011920929f, 1f, _e400)) * _e296);
                        let _e418 = (bitcast<f32>((bitcast<u32>(_e414) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e421 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                        let _e422 = (_e421 * 0.00000011920929f);
                        let _e425 = select(select(0.00000000000011368684f, _e422, (_e422 > 0.00000000000011368684f)), 0f, _e418);
                        let _e426 = select(0f, _e414, _e418);
                        let _e427 = (_e390 + _e425);
                        let _e428 = (_e390 - _e425);
                        let _e430 = select(38685626000000000000000000f, (1f / _e414), _e418);
                        let _e431 = (_e279 == 0u);
                        if _e431 {
                            phi_843_ = _e301[0];
                        } else {
                            phi_843_ = _e301[1];
                        }
                        let _e435 = phi_843_;
                        let _e436 = (_e279 == 2u);
                        if _e436 {
                            phi_849_ = _e301[2];
                        } else {
                            phi_849_ = _e435;
                        }
                        let _e439 = phi_849_;
                        let _e440 = bitcast<u32>(_e439);
                        let _e442 = ((_e440 & 2139095040u) != 0u);
                        let _e454 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * select(0.00000011920929f, 1f, _e442));
                        if _e431 {
                            phi_889_ = _e326[0];
                        } else {
                            phi_889_ = _e326[1];
                        }
                        let _e458 = phi_889_;
                        if _e436 {
                            phi_895_ = _e326[2];
                        } else {
                            phi_895_ = _e458;
                        }
                        let _e461 = phi_895_;
                        let _e462 = bitcast<u32>(_e461);
                        let _e464 = ((_e462 & 2139095040u) != 0u);
                        let _e478 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e462 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e462 & 2147483648u))), _e461, _e464) * _e290) * select(0.00000011920929f, 1f, _e464)) * _e296);
                        let _e482 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e485 = bitcast<f32>((bitcast<u32>(_e454) & 2147483647u));
                        let _e486 = (_e485 * 0.00000011920929f);
                        let _e489 = select(select(0.00000000000011368684f, _e486, (_e486 > 0.00000000000011368684f)), 0f, _e482);
                        let _e490 = select(0f, _e478, _e482);
                        let _e491 = (_e454 + _e489);
                        let _e492 = (_e454 - _e489);
                        let _e494 = select(38685626000000000000000000f, (1f / _e478), _e482);
                        let _e496 = select(_e421, _e357, (_e357 > _e421));
                        if (_e240 && (select(_e485, _e496, (_e496 > _e485)) <= 1099511600000f)) {
                            let _e508 = ((_e226 & 8388607u) | (select(0u, 1u, ((_e226 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e511 = bitcast<i32>((_e226 >> bitcast<u32>(23i)));
                            let _e515 = (_e508 == 0u);
                            let _e518 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e508)), 32u, _e515)) - 8i);
                            if (_e511 == 255i) {
                                phi_1014_ = 255i;
                            } else {
                                phi_1014_ = (((_e511 + select(0i, 1i, (_e511 == 0i))) - _e518) + _e259);
                            }
                            let _e526 = phi_1014_;
                            let _e536 = (_e526 <= 0i);
                            if _e536 {
                                phi_1037_ = u32();
                            } else {
                                if _e515 {
                                    phi_1036_ = u32();
                                } else {
                                    phi_1036_ = select(((bitcast<u32>(_e526) << bitcast<u32>(23i)) | ((_e508 << bitcast<u32>(((_e518 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e526 >= 255i));
                                }
                                let _e540 = phi_1036_;
                                phi_1037_ = _e540;
                            }
                            let _e542 = phi_1037_;
                            let _e554 = ((_e236 & 8388607u) | (select(0u, 1u, ((_e236 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e557 = bitcast<i32>((_e236 >> bitcast<u32>(23i)));
                            let _e561 = (_e554 == 0u);
                            let _e564 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e554)), 32u, _e561)) - 8i);
                            if (_e557 == 255i) {
                                phi_1074_ = 255i;
                            } else {
                                phi_1074_ = (((_e557 + select(0i, 1i, (_e557 == 0i))) - _e564) + _e259);
                            }
                            let _e572 = phi_1074_;
                            let _e582 = (_e572 <= 0i);
                            if _e582 {
                                phi_1097_ = u32();
                            } else {
                                if _e561 {
                                    phi_1096_ = u32();
                                } else {
                                    phi_1096_ = select(((bitcast<u32>(_e572) << bitcast<u32>(23i)) | ((_e554 << bitcast<u32>(((_e564 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e572 >= 255i));
                                }
                                let _e586 = phi_1096_;
                                phi_1097_ = _e586;
                            }
                            let _e588 = phi_1097_;
                            phi_1105_ = bitcast<f32>(((_e235 & 2147483648u) | select(_e588, 0u, select(_e561, true, _e582))));
                            phi_1106_ = bitcast<f32>(((_e225 & 2147483648u) | select(_e542, 0u, select(_e515, true, _e536))));
                        } else {
                            phi_1105_ = 0f;
                            phi_1106_ = 1f;
                        }
                        let _e594 = phi_1105_;
                        let _e596 = phi_1106_;
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e602 = global_3.member[_e140].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e605 = (_e278 % 3u);
                        let _e606 = (_e605 < 3u);
                        if _e606 {
                        } else {
                            break;
                        }
                        let _e608 = local_1[_e605];
                        let _e611 = (_e277 % 3u);
                        let _e612 = (_e611 < 3u);
                        if _e612 {
                        } else {
                            break;
                        }
                        let _e614 = local_1[_e611];
                        let _e617 = (_e279 % 3u);
                        let _e618 = (_e617 < 3u);
                        if _e618 {
                        } else {
                            break;
                        }
                        let _e620 = local_1[_e617];
                        if _e606 {
                        } else {
                            break;
                        }
                        let _e625 = local[_e605];
                        if _e612 {
                        } else {
                            break;
                        }
                        let _e629 = local[_e611];
                        if _e618 {
                        } else {
                            break;
                        }
                        let _e633 = local[_e617];
                        phi_4886_ = false;
                        phi_1211_ = type_39(type_35(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e594), 0u, 0u);
                        phi_1214_ = ((3u * _e97) + 1u);
                        phi_1216_ = (_e596 <= _e594);
                        phi_1218_ = 0u;
                        phi_1220_ = type_50(type_30(vec4<f32>((f32(_e608) * _e152), (f32(_e614) * _e152), (f32(_e620) * _e152), 0f), vec4<f32>((f32(_e625) * _e152), (f32(_e629) * _e152), (f32(_e633) * _e152), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                        loop {
                            let _e643 = phi_4886_;
                            let _e645 = phi_1211_;
                            let _e647 = phi_1214_;
                            let _e649 = phi_1216_;
                            let _e651 = phi_1218_;
                            let _e653 = phi_1220_;
                            local_10 = _e645;
                            local_11 = _e645;
                            if _e649 {
                                phi_1231_ = true;
                            } else {
                                phi_1231_ = (_e651 > 0u);
                            }
                            let _e656 = phi_1231_;
                            if _e656 {
                                let _e657 = (_e647 > 0u);
                                if _e657 {
                                    if _e649 {
                                        phi_1317_ = _e649;
                                        phi_1318_ = _e651;
                                        phi_1319_ = _e653;
                                    } else {
                                        let _e658 = (_e651 - 1u);
                                        let _e659 = (_e658 % 128u);
                                        let _e660 = (_e659 < 128u);
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e662 = local_7[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e664 = local_6[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e666 = local_5[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e668 = local_4[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e670 = local_3[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e672 = local_2[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e677 = local_8[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e680 = local_9[_e659];
                                        phi_1317_ = (_e680 <= _e645.member.member_1);
                                        phi_1318_ = _e658;
                                        phi_1319_ = type_50(type_30(vec4<f32>(_e662, _e664, _e666, 0f), vec4<f32>(_e668, _e670, _e672, 0f)), _e677);
                                    }
                                    let _e685 = phi_1317_;
                                    let _e687 = phi_1318_;
                                    let _e689 = phi_1319_;
                                    if _e685 {
                                        let _e693 = ((_e689.member_1 & 2147483648u) != 0u);
                                        let _e694 = (_e689.member_1 & 268435455u);
                                        if _e693 {
                                            phi_1338_ = _e645;
                                            phi_1341_ = type_8(0u, ((_e689.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e701 = phi_1338_;
                                                let _e703 = phi_1341_;
                                                local_12 = _e701;
                                                if (_e703.member < _e703.member_1) {
                                                    phi_1342_ = type_8((_e703.member + 1u), _e703.member_1);
                                                    phi_1364_ = type_8(1u, _e703.member);
                                                } else {
                                                    phi_1342_ = _e703;
                                                    phi_1364_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e716 = phi_1342_;
                                                let _e718 = phi_1364_;
                                                let _e722 = (bitcast<i32>(_e718.member) != 0i);
                                                if _e722 {
                                                    let _e728 = type_39(_e701.member, _e701.member_1, (_e701.member_2 + 1u));
                                                    let _e733 = (_e689.member.member_1.x - _e689.member.member.x);
                                                    let _e736 = (_e689.member.member_1.y - _e689.member.member.y);
                                                    let _e739 = (_e689.member.member_1.z - _e689.member.member.z);
                                                    let _e741 = select(_e736, _e733, (_e733 > _e736));
                                                    let _e743 = select(_e739, _e741, (_e741 > _e739));
                                                    let _e745 = (_e743 < (1024f * _e152));
                                                    if _e745 {
                                                        phi_1408_ = 0u;
                                                    } else {
                                                        phi_1408_ = select(2u, 1u, (_e743 < (2097152f * _e152)));
                                                    }
                                                    let _e750 = phi_1408_;
                                                    switch bitcast<i32>(_e750) {
                                                        case 0: {
                                                            phi_1414_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1414_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1414_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1414_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e753 = phi_1414_;
                                                    switch bitcast<i32>(_e750) {
                                                        case 0: {
                                                            phi_1424_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1424_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1424_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1424_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e760 = phi_1424_;
                                                    let _e762 = ((_e694 + (_e718.member_1 * ((3u * _e753) + 1u))) + (3u * _e760));
                                                    let _e763 = (_e762 < _e100);
                                                    if _e763 {
                                                        if _e763 {
                                                        } else {
                                                            phi_4880_ = true;
                                                            break;
                                                        }
                                                        let _e765 = global_7.member[_e762];
                                                        phi_1440_ = _e765;
                                                    } else {
                                                        phi_1440_ = 4294967295u;
                                                    }
                                                    let _e767 = phi_1440_;
                                                    if _e745 {
                                                        phi_1473_ = 0u;
                                                    } else {
                                                        phi_1473_ = select(2u, 1u, (_e743 < (2097152f * _e152)));
                                                    }
                                                    let _e772 = phi_1473_;
                                                    switch bitcast<i32>(_e772) {
                                                        case 0: {
                                                            phi_1479_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1479_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1479_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1479_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e775 = phi_1479_;
                                                    let _e779 = (_e694 + (_e718.member_1 * ((3u * _e775) + 1u)));
                                                    switch bitcast<i32>(_e772) {
                                                        case 0: {
                                                            let _e1054 = (_e779 < _e100);
                                                            if _e1054 {
                                                                if _e1054 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1056 = global_7.member[_e779];
                                                                phi_1506_ = _e1056;
                                                            } else {
                                                                phi_1506_ = 0u;
                                                            }
                                                            let _e1058 = phi_1506_;
                                                            let _e1060 = ((10u * _e278) & 31u);
                                                            let _e1070 = ((10u * _e277) & 31u);
                                                            let _e1080 = ((10u * _e279) & 31u);
                                                            let _e1090 = (_e779 + 1u);
                                                            let _e1091 = (_e1090 < _e100);
                                                            if _e1091 {
                                                                if _e1091 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1093 = global_7.member[_e1090];
                                                                phi_1555_ = _e1093;
                                                            } else {
                                                                phi_1555_ = 0u;
                                                            }
                                                            let _e1095 = phi_1555_;
                                                            let _e1121 = (_e779 + 2u);
                                                            let _e1122 = (_e1121 < _e100);
                                                            if _e1122 {
                                                                if _e1122 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1124 = global_7.member[_e1121];
                                                                phi_1604_ = _e1124;
                                                            } else {
                                                                phi_1604_ = 0u;
                                                            }
                                                            let _e1126 = phi_1604_;
                                                            phi_2105_ = array<array<f32, 3>, 3>(array<f32, 3>((_e689.member.member.x + ((bitcast<f32>((1258291200u | ((_e1058 >> bitcast<u32>(_e1060)) & 1023u))) - 8388608f) * _e152)), (_e689.member.member.y + ((bitcast<f32>((1258291200u | ((_e1058 >> bitcast<u32>(_e1070)) & 1023u))) - 8388608f) * _e152)), (_e689.member.member.z + ((bitcast<f32>((1258291200u | ((_e1058 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e689.member.member.x + ((bitcast<f32>((1258291200u | ((_e1095 >> bitcast<u32>(_e1060)) & 1023u))) - 8388608f) * _e152)), (_e689.member.member.y + ((bitcast<f32>((1258291200u | ((_e1095 >> bitcast<u32>(_e1070)) & 1023u))) - 8388608f) * _e152)), (_e689.member.member.z + ((bitcast<f32>((1258291200u | ((_e1095 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e689.member.member.x + ((bitcast<f32>((1258291200u | ((_e1126 >> bitcast<u32>(_e1060)) & 1023u))) - 8388608f) * _e152)), (_e689.member.member.y + ((bitcast<f32>((1258291200u | ((_e1126 >> bitcast<u32>(_e1070)) & 1023u))) - 8388608f) * _e152)), (_e689.member.member.z + ((bitcast<f32>((1258291200u | ((_e1126 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e868 = (_e779 < _e100);
                                                            if _e868 {
                                                                if _e868 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e870 = global_7.member[_e779];
                                                                phi_1653_ = _e870;
                                                            } else {
                                                                phi_1653_ = 0u;
                                                            }
                                                            let _e872 = phi_1653_;
                                                            let _e873 = (_e779 + 1u);
                                                            let _e874 = (_e873 < _e100);
                                                            if _e874 {
                                                                if _e874 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e876 = global_7.member[_e873];
                                                                phi_1668_ = _e876;
                                                            } else {
                                                                phi_1668_ = 0u;
                                                            }
                                                            let _e878 = phi_1668_;
                                                            let _e879 = (_e278 == 1u);
                                                            if _e879 {
                                                                phi_1678_ = ((_e872 >> bitcast<u32>(21i)) | (_e878 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1678_ = (_e878 >> bitcast<u32>(10i));
                                                            }
                                                            let _e888 = phi_1678_;
                                                            let _e896 = (_e277 == 1u);
                                                            if _e896 {
                                                                phi_1699_ = ((_e872 >> bitcast<u32>(21i)) | (_e878 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1699_ = (_e878 >> bitcast<u32>(10i));
                                                            }
                                                            let _e905 = phi_1699_;
                                                            let _e913 = (_e279 == 1u);
                                                            if _e913 {
                                                                phi_1720_ = ((_e872 >> bitcast<u32>(21i)) | (_e878 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1720_ = (_e878 >> bitcast<u32>(10i));
                                                            }
                                                            let _e922 = phi_1720_;
                                                            let _e931 = (_e779 + 2u);
                                                            let _e932 = (_e931 < _e100);
                                                            if _e932 {
                                                                if _e932 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e934 = global_7.member[_e931];
                                                                phi_1750_ = _e934;
                                                            } else {
                                                                phi_1750_ = 0u;
                                                            }
                                                            let _e936 = phi_1750_;
                                                            let _e937 = (_e779 + 3u);
                                                            let _e938 = (_e937 < _e100);
                                                            if _e938 {
                                                                if _e938 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e940 = global_7.member[_e937];
                                                                phi_1765_ = _e940;
                                                            } else {
                                                                phi_1765_ = 0u;
                                                            }
                                                            let _e942 = phi_1765_;
                                                            if _e879 {
                                                                phi_1775_ = ((_e936 >> bitcast<u32>(21i)) | (_e942 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1775_ = (_e942 >> bitcast<u32>(10i));
                                                            }
                                                            let _e951 = phi_1775_;
                                                            if _e896 {
                                                                phi_1796_ = ((_e936 >> bitcast<u32>(21i)) | (_e942 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1796_ = (_e942 >> bitcast<u32>(10i));
                                                            }
                                                            let _e967 = phi_1796_;
                                                            if _e913 {
                                                                phi_1817_ = ((_e936 >> bitcast<u32>(21i)) | (_e942 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1817_ = (_e942 >> bitcast<u32>(10i));
                                                            }
                                                            let _e983 = phi_1817_;
                                                            let _e992 = (_e779 + 4u);
                                                            let _e993 = (_e992 < _e100);
                                                            if _e993 {
                                                                if _e993 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e995 = global_7.member[_e992];
                                                                phi_1847_ = _e995;
                                                            } else {
                                                                phi_1847_ = 0u;
                                                            }
                                                            let _e997 = phi_1847_;
                                                            let _e998 = (_e779 + 5u);
                                                            let _e999 = (_e998 < _e100);
                                                            if _e999 {
                                                                if _e999 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1001 = global_7.member[_e998];
                                                                phi_1862_ = _e1001;
                                                            } else {
                                                                phi_1862_ = 0u;
                                                            }
                                                            let _e1003 = phi_1862_;
                                                            if _e879 {
                                                                phi_1872_ = ((_e997 >> bitcast<u32>(21i)) | (_e1003 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1872_ = (_e1003 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1012 = phi_1872_;
                                                            if _e896 {
                                                                phi_1893_ = ((_e997 >> bitcast<u32>(21i)) | (_e1003 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1893_ = (_e1003 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1028 = phi_1893_;
                                                            if _e913 {
                                                                phi_1914_ = ((_e997 >> bitcast<u32>(21i)) | (_e1003 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1914_ = (_e1003 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1044 = phi_1914_;
                                                            phi_2105_ = array<array<f32, 3>, 3>(array<f32, 3>((_e689.member.member.x + ((bitcast<f32>((1258291200u | (select(_e888, _e872, _e302) & 2097151u))) - 8388608f) * _e152)), (_e689.member.member.y + ((bitcast<f32>((1258291200u | (select(_e905, _e872, _e367) & 2097151u))) - 8388608f) * _e152)), (_e689.member.member.z + ((bitcast<f32>((1258291200u | (select(_e922, _e872, _e431) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e689.member.member.x + ((bitcast<f32>((1258291200u | (select(_e951, _e936, _e302) & 2097151u))) - 8388608f) * _e152)), (_e689.member.member.y + ((bitcast<f32>((1258291200u | (select(_e967, _e936, _e367) & 2097151u))) - 8388608f) * _e152)), (_e689.member.member.z + ((bitcast<f32>((1258291200u | (select(_e983, _e936, _e431) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e689.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1012, _e997, _e302) & 2097151u))) - 8388608f) * _e152)), (_e689.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1028, _e997, _e367) & 2097151u))) - 8388608f) * _e152)), (_e689.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1044, _e997, _e431) & 2097151u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e781 = (_e779 + _e278);
                                                            let _e782 = (_e781 < _e100);
                                                            if _e782 {
                                                                if _e782 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e784 = global_7.member[_e781];
                                                                phi_1945_ = _e784;
                                                            } else {
                                                                phi_1945_ = 0u;
                                                            }
                                                            let _e786 = phi_1945_;
                                                            let _e790 = (_e779 + _e277);
                                                            let _e791 = (_e790 < _e100);
                                                            if _e791 {
                                                                if _e791 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e793 = global_7.member[_e790];
                                                                phi_1963_ = _e793;
                                                            } else {
                                                                phi_1963_ = 0u;
                                                            }
                                                            let _e795 = phi_1963_;
                                                            let _e799 = (_e779 + _e279);
                                                            let _e800 = (_e799 < _e100);
                                                            if _e800 {
                                                                if _e800 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e802 = global_7.member[_e799];
                                                                phi_1981_ = _e802;
                                                            } else {
                                                                phi_1981_ = 0u;
                                                            }
                                                            let _e804 = phi_1981_;
                                                            let _e809 = (_e779 + 3u);
                                                            let _e810 = (_e809 + _e278);
                                                            let _e811 = (_e810 < _e100);
                                                            if _e811 {
                                                                if _e811 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e813 = global_7.member[_e810];
                                                                phi_2004_ = _e813;
                                                            } else {
                                                                phi_2004_ = 0u;
                                                            }
                                                            let _e815 = phi_2004_;
                                                            let _e819 = (_e809 + _e277);
                                                            let _e820 = (_e819 < _e100);
                                                            if _e820 {
                                                                if _e820 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e822 = global_7.member[_e819];
                                                                phi_2022_ = _e822;
                                                            } else {
                                                                phi_2022_ = 0u;
                                                            }
                                                            let _e824 = phi_2022_;
                                                            let _e828 = (_e809 + _e279);
                                                            let _e829 = (_e828 < _e100);
                                                            if _e829 {
                                                                if _e829 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e831 = global_7.member[_e828];
                                                                phi_2040_ = _e831;
                                                            } else {
                                                                phi_2040_ = 0u;
                                                            }
                                                            let _e833 = phi_2040_;
                                                            let _e838 = (_e779 + 6u);
                                                            let _e839 = (_e838 + _e278);
                                                            let _e840 = (_e839 < _e100);
                                                            if _e840 {
                                                                if _e840 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e842 = global_7.member[_e839];
                                                                phi_2063_ = _e842;
                                                            } else {
                                                                phi_2063_ = 0u;
                                                            }
                                                            let _e844 = phi_2063_;
                                                            let _e848 = (_e838 + _e277);
                                                            let _e849 = (_e848 < _e100);
                                                            if _e849 {
                                                                if _e849 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e851 = global_7.member[_e848];
                                                                phi_2081_ = _e851;
                                                            } else {
                                                                phi_2081_ = 0u;
                                                            }
                                                            let _e853 = phi_2081_;
                                                            let _e857 = (_e838 + _e279);
                                                            let _e858 = (_e857 < _e100);
                                                            if _e858 {
                                                                if _e858 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e860 = global_7.member[_e857];
                                                                phi_2099_ = _e860;
                                                            } else {
                                                                phi_2099_ = 0u;
                                                            }
                                                            let _e862 = phi_2099_;
                                                            phi_2105_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e786)) * _e152), (f32(bitcast<i32>(_e795)) * _e152), (f32(bitcast<i32>(_e804)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e815)) * _e152), (f32(bitcast<i32>(_e824)) * _e152), (f32(bitcast<i32>(_e833)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e844)) * _e152), (f32(bitcast<i32>(_e853)) * _e152), (f32(bitcast<i32>(_e862)) * _e152)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2105_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1154 = phi_2105_;
                                                    let _e1171 = (_e1154[0][2] - _e454);
                                                    let _e1174 = (((_e1154[0][0] - _e325) * _e490) - (_e1171 * _e362));
                                                    let _e1177 = (((_e1154[0][1] - _e390) * _e490) - (_e1171 * _e426));
                                                    let _e1180 = (_e1154[1][2] - _e454);
                                                    let _e1183 = (((_e1154[1][0] - _e325) * _e490) - (_e1180 * _e362));
                                                    let _e1186 = (((_e1154[1][1] - _e390) * _e490) - (_e1180 * _e426));
                                                    let _e1189 = (_e1154[2][2] - _e454);
                                                    let _e1192 = (((_e1154[2][0] - _e325) * _e490) - (_e1189 * _e362));
                                                    let _e1195 = (((_e1154[2][1] - _e390) * _e490) - (_e1189 * _e426));
                                                    let _e1196 = (_e1192 * _e1186);
                                                    let _e1197 = (_e1195 * _e1183);
                                                    let _e1198 = (_e1174 * _e1195);
                                                    let _e1199 = (_e1177 * _e1192);
                                                    let _e1200 = (_e1183 * _e1177);
                                                    let _e1201 = (_e1186 * _e1174);
                                                    let _e1206 = (((_e1196 >= _e1197) && (_e1198 >= _e1199)) && (_e1200 >= _e1201));
                                                    let _e1212 = (_e1206 || (((_e1196 <= _e1197) && (_e1198 <= _e1199)) && (_e1200 <= _e1201)));
                                                    if _e1212 {
                                                        let _e1214 = select(-1f, 1f, _e1206);
                                                        let _e1216 = ((_e1196 - _e1197) * _e1214);
                                                        let _e1218 = select(0f, _e1216, (_e1216 > 0f));
                                                        let _e1220 = ((_e1198 - _e1199) * _e1214);
                                                        let _e1222 = select(0f, _e1220, (_e1220 > 0f));
                                                        let _e1224 = ((_e1200 - _e1201) * _e1214);
                                                        let _e1226 = select(0f, _e1224, (_e1224 > 0f));
                                                        let _e1228 = ((_e1218 + _e1222) + _e1226);
                                                        let _e1230 = select(_e1154[1][0], _e1154[0][0], (_e1154[0][0] < _e1154[1][0]));
                                                        let _e1234 = select(_e1154[1][0], _e1154[0][0], (_e1154[0][0] > _e1154[1][0]));
                                                        let _e1238 = select(_e1154[1][1], _e1154[0][1], (_e1154[0][1] < _e1154[1][1]));
                                                        let _e1242 = select(_e1154[1][1], _e1154[0][1], (_e1154[0][1] > _e1154[1][1]));
                                                        let _e1246 = select(_e1154[1][2], _e1154[0][2], (_e1154[0][2] < _e1154[1][2]));
                                                        let _e1250 = select(_e1154[1][2], _e1154[0][2], (_e1154[0][2] > _e1154[1][2]));
                                                        let _e1255 = ((select(_e1154[2][0], _e1230, (_e1230 < _e1154[2][0])) - _e363) * _e366);
                                                        let _e1256 = ((select(_e1154[2][0], _e1234, (_e1234 > _e1154[2][0])) - _e364) * _e366);
                                                        let _e1259 = ((select(_e1154[2][1], _e1238, (_e1238 < _e1154[2][1])) - _e427) * _e430);
                                                        let _e1260 = ((select(_e1154[2][1], _e1242, (_e1242 > _e1154[2][1])) - _e428) * _e430);
                                                        let _e1263 = ((select(_e1154[2][2], _e1246, (_e1246 < _e1154[2][2])) - _e491) * _e494);
                                                        let _e1264 = ((select(_e1154[2][2], _e1250, (_e1250 > _e1154[2][2])) - _e492) * _e494);
                                                        let _e1266 = select(_e1264, _e1263, (_e1263 < _e1264));
                                                        let _e1268 = select(_e1264, _e1263, (_e1263 > _e1264));
                                                        let _e1270 = select(_e1256, _e1255, (_e1255 < _e1256));
                                                        let _e1272 = select(_e1260, _e1259, (_e1259 < _e1260));
                                                        let _e1274 = select(_e1272, _e1270, (_e1270 > _e1272));
                                                        let _e1276 = select(_e1266, _e1274, (_e1274 > _e1266));
                                                        let _e1278 = select(_e1256, _e1255, (_e1255 > _e1256));
                                                        let _e1280 = select(_e1260, _e1259, (_e1259 > _e1260));
                                                        let _e1282 = select(_e1280, _e1278, (_e1278 < _e1280));
                                                        let _e1284 = select(_e1268, _e1282, (_e1282 < _e1268));
                                                        let _e1285 = -(_e1266);
                                                        let _e1291 = select(_e596, _e1276, (_e1276 > _e596));
                                                        let _e1295 = select(_e1183, _e1174, (_e1174 < _e1183));
                                                        let _e1300 = select(_e1183, _e1174, (_e1174 > _e1183));
                                                        let _e1307 = select(_e1186, _e1177, (_e1177 < _e1186));
                                                        let _e1312 = select(_e1186, _e1177, (_e1177 > _e1186));
                                                        let _e1321 = (((((_e1212 && (_e1228 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1192, _e1295, (_e1295 < _e1192)) <= 0f) && (select(_e1192, _e1300, (_e1300 > _e1192)) >= 0f))) && ((select(_e1195, _e1307, (_e1307 < _e1195)) <= 0f) && (select(_e1195, _e1312, (_e1312 > _e1195)) >= 0f))) && (_e1291 <= (_e1284 + (select(_e1285, _e1268, (_e1268 > _e1285)) * 0.0000019073523f)))) && (_e1291 <= _e701.member.member_1));
                                                        if _e1321 {
                                                            let _e1326 = (_e1154[1][0] - _e1154[0][0]);
                                                            let _e1327 = (_e1154[1][1] - _e1154[0][1]);
                                                            let _e1328 = (_e1154[1][2] - _e1154[0][2]);
                                                            let _e1329 = vec3<f32>(_e1326, _e1327, _e1328);
                                                            let _e1330 = (_e1154[2][0] - _e1154[1][0]);
                                                            let _e1331 = (_e1154[2][1] - _e1154[1][1]);
                                                            let _e1332 = (_e1154[2][2] - _e1154[1][2]);
                                                            let _e1333 = vec3<f32>(_e1330, _e1331, _e1332);
                                                            let _e1334 = (_e1154[0][0] - _e1154[2][0]);
                                                            let _e1335 = (_e1154[0][1] - _e1154[2][1]);
                                                            let _e1336 = (_e1154[0][2] - _e1154[2][2]);
                                                            let _e1337 = vec3<f32>(_e1334, _e1335, _e1336);
                                                            let _e1338 = abs(_e1326);
                                                            let _e1339 = abs(_e1327);
                                                            if (_e1338 != _e1338) {
                                                                phi_4447_ = true;
                                                            } else {
                                                                phi_4447_ = (_e1339 >= _e1338);
                                                            }
                                                            let _e1343 = phi_4447_;
                                                            let _e1344 = select(_e1338, _e1339, _e1343);
                                                            let _e1345 = abs(_e1328);
                                                            if (_e1344 != _e1344) {
                                                                phi_4462_ = true;
                                                            } else {
                                                                phi_4462_ = (_e1345 >= _e1344);
                                                            }
                                                            let _e1349 = phi_4462_;
                                                            let _e1350 = select(_e1344, _e1345, _e1349);
                                                            let _e1351 = abs(_e1330);
                                                            let _e1352 = abs(_e1331);
                                                            if (_e1351 != _e1351) {
                                                                phi_4477_ = true;
                                                            } else {
                                                                phi_4477_ = (_e1352 >= _e1351);
                                                            }
                                                            let _e1356 = phi_4477_;
                                                            let _e1357 = select(_e1351, _e1352, _e1356);
                                                            let _e1358 = abs(_e1332);
                                                            if (_e1357 != _e1357) {
                                                                phi_4492_ = true;
                                                            } else {
                                                                phi_4492_ = (_e1358 >= _e1357);
                                                            }
                                                            let _e1362 = phi_4492_;
                                                            let _e1363 = select(_e1357, _e1358, _e1362);
                                                            let _e1364 = abs(_e1334);
                                                            let _e1365 = abs(_e1335);
                                                            if (_e1364 != _e1364) {
                                                                phi_4507_ = true;
                                                            } else {
                                                                phi_4507_ = (_e1365 >= _e1364);
                                                            }
                                                            let _e1369 = phi_4507_;
                                                            let _e1370 = select(_e1364, _e1365, _e1369);
                                                            let _e1371 = abs(_e1336);
                                                            if (_e1370 != _e1370) {
                                                                phi_4522_ = true;
                                                            } else {
                                                                phi_4522_ = (_e1371 >= _e1370);
                                                            }
                                                            let _e1375 = phi_4522_;
                                                            let _e1376 = select(_e1370, _e1371, _e1375);
                                                            let _e1378 = select(_e1363, _e1350, (_e1350 > _e1363));
                                                            let _e1380 = select(_e1376, _e1378, (_e1378 > _e1376));
                                                            if (_e1350 == _e1380) {
                                                                phi_2647_ = _e1186;
                                                                phi_2648_ = _e1183;
                                                                phi_2649_ = _e1177;
                                                                phi_2650_ = _e1174;
                                                                phi_2651_ = vec3<f32>(_e1154[0][0], _e1154[0][1], _e1154[0][2]);
                                                                phi_2652_ = _e1337;
                                                                phi_2653_ = _e1333;
                                                                phi_2654_ = _e1329;
                                                            } else {
                                                                let _e1382 = (_e1363 == _e1380);
                                                                let _e1387 = vec3(_e1382);
                                                                phi_2647_ = select(_e1177, _e1195, _e1382);
                                                                phi_2648_ = select(_e1174, _e1192, _e1382);
                                                                phi_2649_ = select(_e1195, _e1186, _e1382);
                                                                phi_2650_ = select(_e1192, _e1183, _e1382);
                                                                phi_2651_ = select(vec3<f32>(_e1154[2][0], _e1154[2][1], _e1154[2][2]), vec3<f32>(_e1154[1][0], _e1154[1][1], _e1154[1][2]), _e1387);
                                                                phi_2652_ = select(_e1333, _e1329, _e1387);
                                                                phi_2653_ = select(_e1329, _e1337, _e1387);
                                                                phi_2654_ = select(_e1337, _e1333, _e1387);
                                                            }
                                                            let _e1393 = phi_2647_;
                                                            let _e1395 = phi_2648_;
                                                            let _e1397 = phi_2649_;
                                                            let _e1399 = phi_2650_;
                                                            let _e1401 = phi_2651_;
                                                            let _e1403 = phi_2652_;
                                                            let _e1405 = phi_2653_;
                                                            let _e1407 = phi_2654_;
                                                            let _e1414 = ((_e1405.y * _e1403.z) - (_e1403.y * _e1405.z));
                                                            let _e1419 = ((_e1405.z * _e1403.x) - (_e1403.z * _e1405.x));
                                                            let _e1422 = ((_e1405.x * _e1403.y) - (_e1403.x * _e1405.y));
                                                            let _e1425 = ((_e1218 >= _e1222) && (_e1218 >= _e1226));
                                                            let _e1426 = (_e1222 >= _e1226);
                                                            let _e1440 = (((_e1414 * (select(select(_e1154[2][0], _e1154[1][0], _e1426), _e1154[0][0], _e1425) - _e325)) + (_e1419 * (select(select(_e1154[2][1], _e1154[1][1], _e1426), _e1154[0][1], _e1425) - _e390))) + (_e1422 * (select(select(_e1154[2][2], _e1154[1][2], _e1426), _e1154[0][2], _e1425) - _e454)));
                                                            let _e1445 = (((_e1414 * _e362) + (_e1419 * _e426)) + (_e1422 * _e490));
                                                            let _e1446 = (_e1395 - _e1399);
                                                            let _e1447 = (_e1393 - _e1397);
                                                            let _e1450 = ((_e1446 * _e1446) + (_e1447 * _e1447));
                                                            let _e1457 = (-(((_e1399 * _e1446) + (_e1397 * _e1447))) / select(0.000000000000000000000000000000000000011754944f, _e1450, (_e1450 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1459 = select(1f, _e1457, (_e1457 < 1f));
                                                            let _e1461 = select(0f, _e1459, (_e1459 > 0f));
                                                            let _e1470 = ((_e1401.x + (_e1407.x * _e1461)) - _e325);
                                                            let _e1473 = ((_e1401.y + (_e1407.y * _e1461)) - _e390);
                                                            let _e1476 = ((_e1401.z + (_e1407.z * _e1461)) - _e454);
                                                            let _e1479 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
                                                            let _e1482 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                            let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                            let _e1487 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                            let _e1489 = select(_e1487, _e1484, (_e1484 > _e1487));
                                                            let _e1493 = abs(_e1414);
                                                            let _e1494 = abs(_e1419);
                                                            if (_e1493 != _e1493) {
                                                                phi_4537_ = true;
                                                            } else {
                                                                phi_4537_ = (_e1494 >= _e1493);
                                                            }
                                                            let _e1498 = phi_4537_;
                                                            let _e1499 = select(_e1493, _e1494, _e1498);
                                                            let _e1500 = abs(_e1422);
                                                            if (_e1499 != _e1499) {
                                                                phi_4552_ = true;
                                                            } else {
                                                                phi_4552_ = (_e1500 >= _e1499);
                                                            }
                                                            let _e1504 = phi_4552_;
                                                            let _e1520 = abs(_e1405.x);
                                                            let _e1521 = abs(_e1405.y);
                                                            if (_e1520 != _e1520) {
                                                                phi_4567_ = true;
                                                            } else {
                                                                phi_4567_ = (_e1521 >= _e1520);
                                                            }
                                                            let _e1525 = phi_4567_;
                                                            let _e1526 = select(_e1520, _e1521, _e1525);
                                                            let _e1527 = abs(_e1405.z);
                                                            if (_e1526 != _e1526) {
                                                                phi_4582_ = true;
                                                            } else {
                                                                phi_4582_ = (_e1527 >= _e1526);
                                                            }
                                                            let _e1531 = phi_4582_;
                                                            let _e1534 = abs(_e1403.x);
                                                            let _e1535 = abs(_e1403.y);
                                                            if (_e1534 != _e1534) {
                                                                phi_4597_ = true;
                                                            } else {
                                                                phi_4597_ = (_e1535 >= _e1534);
                                                            }
                                                            let _e1539 = phi_4597_;
                                                            let _e1540 = select(_e1534, _e1535, _e1539);
                                                            let _e1541 = abs(_e1403.z);
                                                            if (_e1540 != _e1540) {
                                                                phi_4612_ = true;
                                                            } else {
                                                                phi_4612_ = (_e1541 >= _e1540);
                                                            }
                                                            let _e1545 = phi_4612_;
                                                            let _e1550 = ((bitcast<f32>((bitcast<u32>(((((_e1414 * _e1470) + (_e1419 * _e1473)) + (_e1422 * _e1476)) - _e1440)) & 2147483647u)) <= ((0.0000009536743f * select(_e1380, _e1489, (_e1489 > _e1380))) * select(_e1499, _e1500, _e1504))) && !((bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u)) <= ((0.0000038146973f * select(_e1526, _e1527, _e1531)) * select(_e1540, _e1541, _e1545)))));
                                                            let _e1551 = (_e1440 / _e1445);
                                                            if (_e1321 && !(_e1550)) {
                                                                let _e1554 = (_e1476 / _e490);
                                                                let _e1562 = (((_e1414 * (_e1470 - (_e362 * _e1554))) + (_e1419 * (_e1473 - (_e426 * _e1554)))) / _e1445);
                                                                phi_2862_ = select(select(_e1554, (_e1554 + _e1562), (bitcast<f32>((bitcast<u32>(_e1562) & 2147483647u)) <= _e1380)), _e1551, _e1550);
                                                            } else {
                                                                phi_2862_ = _e1551;
                                                            }
                                                            let _e1571 = phi_2862_;
                                                            let _e1573 = select(_e1284, _e1571, (_e1571 < _e1284));
                                                            let _e1575 = select(_e1276, _e1573, (_e1573 > _e1276));
                                                            let _e1576 = (1f / _e1228);
                                                            phi_2882_ = type_38(_e1575, (_e1222 * _e1576), (_e1226 * _e1576), ((_e1321 && (_e1575 >= _e596)) && (_e1575 <= _e701.member.member_1)));
                                                            phi_2883_ = type_38();
                                                        } else {
                                                            phi_2882_ = type_38();
                                                            phi_2883_ = type_38(0f, 0f, 0f, _e1321);
                                                        }
                                                        let _e1585 = phi_2882_;
                                                        let _e1587 = phi_2883_;
                                                        phi_2886_ = _e1585;
                                                        phi_2887_ = _e1587;
                                                        phi_2888_ = select(true, false, _e1321);
                                                    } else {
                                                        phi_2886_ = type_38();
                                                        phi_2887_ = type_38(0f, 0f, 0f, _e1212);
                                                        phi_2888_ = true;
                                                    }
                                                    let _e1590 = phi_2886_;
                                                    let _e1592 = phi_2887_;
                                                    let _e1594 = phi_2888_;
                                                    if _e1594 {
                                                        phi_2892_ = _e1592;
                                                    } else {
                                                        phi_2892_ = _e1590;
                                                    }
                                                    let _e1596 = phi_2892_;
                                                    if _e1596.member_3 {
                                                        phi_2901_ = type_18(_e1596.member, _e1596.member_1, _e1596.member_2, _e767);
                                                    } else {
                                                        phi_2901_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1603 = phi_2901_;
                                                    if (_e1603.member_3 != 4294967295u) {
                                                        if (_e767 != _e602) {
                                                            if (_e1603.member < _e701.member.member.member) {
                                                                phi_2927_ = true;
                                                            } else {
                                                                if (_e1603.member == _e701.member.member.member) {
                                                                    phi_2926_ = (_e1603.member_3 < _e701.member.member.member_3);
                                                                } else {
                                                                    phi_2926_ = false;
                                                                }
                                                                let _e1618 = phi_2926_;
                                                                phi_2927_ = _e1618;
                                                            }
                                                            let _e1620 = phi_2927_;
                                                            if _e1620 {
                                                                phi_2934_ = type_39(type_35(_e1603, _e1603.member), _e728.member_1, _e728.member_2);
                                                            } else {
                                                                phi_2934_ = _e728;
                                                            }
                                                            let _e1627 = phi_2934_;
                                                            phi_2935_ = _e1627;
                                                        } else {
                                                            phi_2935_ = _e728;
                                                        }
                                                        let _e1629 = phi_2935_;
                                                        phi_2936_ = _e1629;
                                                    } else {
                                                        phi_2936_ = _e728;
                                                    }
                                                    let _e1631 = phi_2936_;
                                                    phi_1339_ = _e1631;
                                                } else {
                                                    phi_1339_ = type_39();
                                                }
                                                let _e1633 = phi_1339_;
                                                continue;
                                                continuing {
                                                    phi_1338_ = _e1633;
                                                    phi_1341_ = _e716;
                                                    phi_4880_ = _e643;
                                                    break if !(_e722);
                                                }
                                            }
                                            let _e1636 = phi_4880_;
                                            phi_5092_ = _e1636;
                                            if _e1636 {
                                                break;
                                            }
                                            phi_5183_ = _e1636;
                                            let _e2463 = local_12;
                                            phi_2937_ = _e2463;
                                        } else {
                                            phi_5183_ = _e643;
                                            phi_2937_ = _e645;
                                        }
                                        let _e1638 = phi_5183_;
                                        let _e1640 = phi_2937_;
                                        if _e693 {
                                            phi_4206_ = type_39();
                                            phi_4207_ = bool();
                                            phi_4208_ = u32();
                                            phi_4209_ = type_50();
                                        } else {
                                            if (_e689.member_1 >= _e97) {
                                                phi_3738_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e689.member_1 < _e97) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1643 = (_e278 * 2u);
                                                let _e1645 = ((1u + _e1643) % 7u);
                                                if (_e1645 < 7u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1650 = global_6.member[_e689.member_1][_e1645];
                                                let _e1652 = ((_e1643 + 2u) % 7u);
                                                if (_e1652 < 7u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1657 = global_6.member[_e689.member_1][_e1652];
                                                let _e1658 = (_e277 * 2u);
                                                let _e1660 = ((1u + _e1658) % 7u);
                                                if (_e1660 < 7u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1665 = global_6.member[_e689.member_1][_e1660];
                                                let _e1667 = ((_e1658 + 2u) % 7u);
                                                if (_e1667 < 7u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1672 = global_6.member[_e689.member_1][_e1667];
                                                let _e1673 = (_e279 * 2u);
                                                let _e1675 = ((1u + _e1673) % 7u);
                                                if (_e1675 < 7u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1680 = global_6.member[_e689.member_1][_e1675];
                                                let _e1682 = ((_e1673 + 2u) % 7u);
                                                if (_e1682 < 7u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1687 = global_6.member[_e689.member_1][_e1682];
                                                let _e1710 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.x - _e689.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1711 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.y - _e689.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1712 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.z - _e689.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1714 = select(_e152, _e1710, (_e1710 > _e152));
                                                let _e1716 = select(_e152, _e1711, (_e1711 > _e152));
                                                let _e1718 = select(_e152, _e1712, (_e1712 > _e152));
                                                let _e1749 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1650 & 2097151u))) - 8388608f) * _e1714));
                                                let _e1754 = (bitcast<i32>((_e1650 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1757 = bitcast<f32>((_e1749 & bitcast<u32>(_e1754)));
                                                let _e1758 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1665 & 2097151u))) - 8388608f) * _e1716));
                                                let _e1763 = (bitcast<i32>((_e1665 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1766 = bitcast<f32>((_e1758 & bitcast<u32>(_e1763)));
                                                let _e1767 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1680 & 2097151u))) - 8388608f) * _e1718));
                                                let _e1772 = (bitcast<i32>((_e1680 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1775 = bitcast<f32>((_e1767 & bitcast<u32>(_e1772)));
                                                let _e1779 = bitcast<f32>((_e1749 & bitcast<u32>(~(_e1754))));
                                                let _e1783 = bitcast<f32>((_e1758 & bitcast<u32>(~(_e1763))));
                                                let _e1787 = bitcast<f32>((_e1767 & bitcast<u32>(~(_e1772))));
                                                let _e1788 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1657 & 2097151u))) - 8388608f) * _e1714));
                                                let _e1793 = (bitcast<i32>((_e1657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1796 = bitcast<f32>((_e1788 & bitcast<u32>(_e1793)));
                                                let _e1797 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1672 & 2097151u))) - 8388608f) * _e1716));
                                                let _e1802 = (bitcast<i32>((_e1672 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1805 = bitcast<f32>((_e1797 & bitcast<u32>(_e1802)));
                                                let _e1806 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1687 & 2097151u))) - 8388608f) * _e1718));
                                                let _e1811 = (bitcast<i32>((_e1687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1814 = bitcast<f32>((_e1806 & bitcast<u32>(_e1811)));
                                                let _e1818 = bitcast<f32>((_e1788 & bitcast<u32>(~(_e1793))));
                                                let _e1822 = bitcast<f32>((_e1797 & bitcast<u32>(~(_e1802))));
                                                let _e1826 = bitcast<f32>((_e1806 & bitcast<u32>(~(_e1811))));
                                                let _e1827 = (_e689.member.member.x + _e1757);
                                                let _e1828 = (_e689.member.member.y + _e1766);
                                                let _e1829 = (_e689.member.member.z + _e1775);
                                                let _e1832 = (_e689.member.member_1.x - _e1796);
                                                let _e1833 = (_e689.member.member_1.y - _e1805);
                                                let _e1834 = (_e689.member.member_1.z - _e1814);
                                                let _e1853 = (_e1832 - _e1827);
                                                let _e1854 = (_e1833 - _e1828);
                                                let _e1855 = (_e1834 - _e1829);
                                                let _e1857 = select(_e1854, _e1853, (_e1853 > _e1854));
                                                let _e1859 = select(_e1855, _e1857, (_e1857 > _e1855));
                                                if (_e1859 < (1024f * _e152)) {
                                                    phi_3439_ = 0u;
                                                } else {
                                                    phi_3439_ = select(2u, 1u, (_e1859 < (2097152f * _e152)));
                                                }
                                                let _e1866 = phi_3439_;
                                                switch bitcast<i32>(_e1866) {
                                                    case 0: {
                                                        phi_3445_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3445_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3445_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3445_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1869 = phi_3445_;
                                                let _e1875 = global_6.member[_e689.member_1][0u];
                                                let _e1879 = global_6.member[_e689.member_1][2u];
                                                let _e1883 = global_6.member[_e689.member_1][4u];
                                                let _e1887 = global_6.member[_e689.member_1][6u];
                                                let _e1899 = (((_e1879 >> bitcast<u32>(22i)) | ((_e1883 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1887 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1900 = (_e1875 & 268435455u);
                                                let _e1901 = (_e1899 & 268435455u);
                                                let _e1904 = ((_e1875 >> bitcast<u32>(28u)) & 7u);
                                                let _e1912 = ((_e1875 >> bitcast<u32>(31i)) | (((_e1899 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1913 = (_e1904 != 0u);
                                                if (_e1904 == 0u) {
                                                    phi_3700_ = _e1900;
                                                } else {
                                                    if (_e1904 == 7u) {
                                                        phi_3699_ = 2147483648u;
                                                    } else {
                                                        phi_3699_ = ((2147483648u | (_e1904 << bitcast<u32>(28u))) | (_e1901 & 268435455u));
                                                    }
                                                    let _e1922 = phi_3699_;
                                                    phi_3700_ = _e1922;
                                                }
                                                let _e1924 = phi_3700_;
                                                if _e1913 {
                                                    let _e1925 = (_e1904 != 7u);
                                                    if _e1925 {
                                                        phi_3710_ = (_e1901 + (_e1904 * ((3u * _e1869) + 1u)));
                                                    } else {
                                                        phi_3710_ = u32();
                                                    }
                                                    let _e1929 = phi_3710_;
                                                    phi_3712_ = _e1929;
                                                    phi_3713_ = select(true, false, _e1925);
                                                } else {
                                                    phi_3712_ = u32();
                                                    phi_3713_ = true;
                                                }
                                                let _e1932 = phi_3712_;
                                                let _e1934 = phi_3713_;
                                                if (_e1912 == 0u) {
                                                    phi_3734_ = (_e1900 + select(0u, 1u, !(_e1913)));
                                                } else {
                                                    if (_e1912 == 7u) {
                                                        phi_3733_ = 2147483648u;
                                                    } else {
                                                        phi_3733_ = ((2147483648u | (_e1912 << bitcast<u32>(28u))) | (select(_e1932, _e1901, _e1934) & 268435455u));
                                                    }
                                                    let _e1947 = phi_3733_;
                                                    phi_3734_ = _e1947;
                                                }
                                                let _e1949 = phi_3734_;
                                                phi_3738_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e1827, (_e689.member.member.x + _e1779), _e1832, (_e689.member.member_1.x - _e1818)), vec4<f32>(_e1828, (_e689.member.member.y + _e1783), _e1833, (_e689.member.member_1.y - _e1822)), vec4<f32>(_e1829, (_e689.member.member.z + _e1787), _e1834, (_e689.member.member_1.z - _e1826))), type_50(type_30((_e689.member.member + vec4<f32>(_e1757, _e1766, _e1775, 0f)), (_e689.member.member_1 - vec4<f32>(_e1796, _e1805, _e1814, 0f))), _e1924), type_50(type_30((_e689.member.member + vec4<f32>(_e1779, _e1783, _e1787, 0f)), (_e689.member.member_1 - vec4<f32>(_e1818, _e1822, _e1826, 0f))), _e1949));
                                            }
                                            let _e1954 = phi_3738_;
                                            let _e1973 = ((_e1954.member[0].x - _e363) * _e366);
                                            let _e1974 = ((_e1954.member[0].y - _e363) * _e366);
                                            let _e1975 = ((_e1954.member[0].z - _e364) * _e366);
                                            let _e1976 = ((_e1954.member[0].w - _e364) * _e366);
                                            let _e1986 = ((_e1954.member[1].x - _e427) * _e430);
                                            let _e1987 = ((_e1954.member[1].y - _e427) * _e430);
                                            let _e1988 = ((_e1954.member[1].z - _e428) * _e430);
                                            let _e1989 = ((_e1954.member[1].w - _e428) * _e430);
                                            let _e1999 = ((_e1954.member[2].x - _e491) * _e494);
                                            let _e2000 = ((_e1954.member[2].y - _e491) * _e494);
                                            let _e2001 = ((_e1954.member[2].z - _e492) * _e494);
                                            let _e2002 = ((_e1954.member[2].w - _e492) * _e494);
                                            let _e2004 = select(_e2001, _e1999, (_e1999 < _e2001));
                                            let _e2006 = select(_e2002, _e2000, (_e2000 < _e2002));
                                            let _e2008 = select(_e2001, _e1999, (_e1999 > _e2001));
                                            let _e2010 = select(_e2002, _e2000, (_e2000 > _e2002));
                                            let _e2012 = select(_e1975, _e1973, (_e1973 < _e1975));
                                            let _e2014 = select(_e1976, _e1974, (_e1974 < _e1976));
                                            let _e2016 = select(_e1988, _e1986, (_e1986 < _e1988));
                                            let _e2018 = select(_e1989, _e1987, (_e1987 < _e1989));
                                            let _e2020 = select(_e2016, _e2012, (_e2012 > _e2016));
                                            let _e2022 = select(_e2018, _e2014, (_e2014 > _e2018));
                                            let _e2024 = select(_e2004, _e2020, (_e2020 > _e2004));
                                            let _e2026 = select(_e2006, _e2022, (_e2022 > _e2006));
                                            let _e2028 = select(_e1975, _e1973, (_e1973 > _e1975));
                                            let _e2030 = select(_e1976, _e1974, (_e1974 > _e1976));
                                            let _e2032 = select(_e1988, _e1986, (_e1986 > _e1988));
                                            let _e2034 = select(_e1989, _e1987, (_e1987 > _e1989));
                                            let _e2036 = select(_e2032, _e2028, (_e2028 < _e2032));
                                            let _e2038 = select(_e2034, _e2030, (_e2030 < _e2034));
                                            let _e2043 = -(_e2004);
                                            let _e2044 = -(_e2006);
                                            let _e2051 = (select(_e2008, _e2036, (_e2036 < _e2008)) + (select(_e2043, _e2008, (_e2008 > _e2043)) * 0.0000019073523f));
                                            let _e2052 = (select(_e2010, _e2038, (_e2038 < _e2010)) + (select(_e2044, _e2010, (_e2010 > _e2044)) * 0.0000019073523f));
                                            let _e2054 = select(_e596, _e2024, (_e2024 > _e596));
                                            let _e2056 = select(_e596, _e2026, (_e2026 > _e596));
                                            let _e2061 = (_e2054 <= select(_e1640.member.member_1, _e2051, (_e2051 < _e1640.member.member_1)));
                                            let _e2062 = (_e2056 <= select(_e1640.member.member_1, _e2052, (_e2052 < _e1640.member.member_1)));
                                            let _e2063 = (_e2054 <= _e2056);
                                            if _e2061 {
                                                if _e2062 {
                                                    if _e2063 {
                                                        phi_4103_ = _e1954.member_2;
                                                    } else {
                                                        phi_4103_ = _e1954.member_1;
                                                    }
                                                    let _e2067 = phi_4103_;
                                                    let _e2088 = (_e687 % 128u);
                                                    let _e2089 = (_e2088 < 128u);
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2088] = _e2067.member_1;
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2088] = _e2067.member.member.x;
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2088] = _e2067.member.member.y;
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2088] = _e2067.member.member.z;
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2088] = _e2067.member.member_1.x;
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2088] = _e2067.member.member_1.y;
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2088] = _e2067.member.member_1.z;
                                                    if _e2089 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2088] = select(_e2054, _e2056, _e2063);
                                                    if _e2063 {
                                                        phi_4179_ = _e1954.member_1;
                                                    } else {
                                                        phi_4179_ = _e1954.member_2;
                                                    }
                                                    let _e2102 = phi_4179_;
                                                    phi_4180_ = (_e687 + 1u);
                                                    phi_4181_ = _e2102;
                                                } else {
                                                    phi_4180_ = u32();
                                                    phi_4181_ = type_50();
                                                }
                                                let _e2104 = phi_4180_;
                                                let _e2106 = phi_4181_;
                                                phi_4183_ = _e2104;
                                                phi_4184_ = _e2106;
                                                phi_4185_ = select(true, false, _e2062);
                                            } else {
                                                phi_4183_ = u32();
                                                phi_4184_ = type_50();
                                                phi_4185_ = true;
                                            }
                                            let _e2109 = phi_4183_;
                                            let _e2111 = phi_4184_;
                                            let _e2113 = phi_4185_;
                                            if _e2113 {
                                                if _e2061 {
                                                    phi_4194_ = _e1954.member_1;
                                                } else {
                                                    phi_4194_ = _e1954.member_2;
                                                }
                                                let _e2117 = phi_4194_;
                                                phi_4199_ = select(_e2062, true, _e2061);
                                                phi_4201_ = _e2117;
                                            } else {
                                                phi_4199_ = _e685;
                                                phi_4201_ = _e2111;
                                            }
                                            let _e2120 = phi_4199_;
                                            let _e2122 = phi_4201_;
                                            phi_4206_ = type_39(_e1640.member, (_e1640.member_1 + 1u), _e1640.member_2);
                                            phi_4207_ = _e2120;
                                            phi_4208_ = select(_e2109, _e687, _e2113);
                                            phi_4209_ = _e2122;
                                        }
                                        let _e2125 = phi_4206_;
                                        let _e2127 = phi_4207_;
                                        let _e2129 = phi_4208_;
                                        let _e2131 = phi_4209_;
                                        if _e693 {
                                            phi_4217_ = _e1640;
                                            phi_4220_ = _e689;
                                        } else {
                                            phi_4217_ = _e2125;
                                            phi_4220_ = _e2131;
                                        }
                                        let _e2133 = phi_4217_;
                                        let _e2135 = phi_4220_;
                                        phi_5095_ = _e1638;
                                        phi_4221_ = _e2133;
                                        phi_4222_ = (_e647 - 1u);
                                        phi_4223_ = select(_e2127, false, _e693);
                                        phi_4224_ = select(_e2129, _e687, _e693);
                                        phi_4225_ = _e2135;
                                    } else {
                                        phi_5095_ = _e643;
                                        phi_4221_ = _e645;
                                        phi_4222_ = _e647;
                                        phi_4223_ = _e685;
                                        phi_4224_ = _e687;
                                        phi_4225_ = _e689;
                                    }
                                    let _e2139 = phi_5095_;
                                    let _e2141 = phi_4221_;
                                    let _e2143 = phi_4222_;
                                    let _e2145 = phi_4223_;
                                    let _e2147 = phi_4224_;
                                    let _e2149 = phi_4225_;
                                    phi_5094_ = _e2139;
                                    phi_4226_ = _e2141;
                                    phi_4227_ = _e2143;
                                    phi_4228_ = _e2145;
                                    phi_4229_ = _e2147;
                                    phi_4230_ = _e2149;
                                } else {
                                    phi_5094_ = _e643;
                                    phi_4226_ = type_39();
                                    phi_4227_ = u32();
                                    phi_4228_ = bool();
                                    phi_4229_ = u32();
                                    phi_4230_ = type_50();
                                }
                                let _e2151 = phi_5094_;
                                let _e2153 = phi_4226_;
                                let _e2155 = phi_4227_;
                                let _e2157 = phi_4228_;
                                let _e2159 = phi_4229_;
                                let _e2161 = phi_4230_;
                                phi_5093_ = _e2151;
                                phi_1212_ = _e2153;
                                phi_1215_ = _e2155;
                                phi_1217_ = _e2157;
                                phi_1219_ = _e2159;
                                phi_1221_ = _e2161;
                                phi_4231_ = _e657;
                            } else {
                                phi_5093_ = _e643;
                                phi_1212_ = type_39();
                                phi_1215_ = u32();
                                phi_1217_ = bool();
                                phi_1219_ = u32();
                                phi_1221_ = type_50();
                                phi_4231_ = false;
                            }
                            let _e2163 = phi_5093_;
                            let _e2165 = phi_1212_;
                            let _e2167 = phi_1215_;
                            let _e2169 = phi_1217_;
                            let _e2171 = phi_1219_;
                            let _e2173 = phi_1221_;
                            let _e2175 = phi_4231_;
                            continue;
                            continuing {
                                phi_4886_ = _e2163;
                                phi_1211_ = _e2165;
                                phi_1214_ = _e2167;
                                phi_1216_ = _e2169;
                                phi_1218_ = _e2171;
                                phi_1220_ = _e2173;
                                phi_5092_ = _e2163;
                                break if !(_e2175);
                            }
                        }
                        let _e2178 = phi_5092_;
                        if _e2178 {
                            break;
                        }
                        let _e2180 = local_10;
                        if (_e2180.member.member.member_3 != 4294967295u) {
                            let _e2186 = bitcast<u32>(_e2180.member.member.member);
                            let _e2190 = (bitcast<i32>((_e2186 >> bitcast<u32>(23i))) & 255i);
                            let _e2191 = (_e2190 + _e280);
                            if (_e2190 == 255i) {
                                phi_4290_ = _e2180.member.member.member;
                            } else {
                                if (_e2190 > 0i) {
                                    if (_e2191 > 0i) {
                                        let _e2195 = (_e2191 < 255i);
                                        if _e2195 {
                                            phi_4269_ = bitcast<f32>((_e2186 + bitcast<u32>((_e280 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4269_ = f32();
                                        }
                                        let _e2202 = phi_4269_;
                                        phi_4271_ = _e2202;
                                        phi_4272_ = select(true, false, _e2195);
                                    } else {
                                        phi_4271_ = f32();
                                        phi_4272_ = true;
                                    }
                                    let _e2205 = phi_4271_;
                                    let _e2207 = phi_4272_;
                                    phi_4273_ = _e2205;
                                    phi_4274_ = _e2207;
                                } else {
                                    phi_4273_ = f32();
                                    phi_4274_ = true;
                                }
                                let _e2209 = phi_4273_;
                                let _e2211 = phi_4274_;
                                if _e2211 {
                                    let _e2212 = (_e2186 & 2147483648u);
                                    let _e2219 = ((_e2186 & 8388607u) | (select(0u, 1u, ((_e2186 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2223 = (_e2219 == 0u);
                                    if _e2223 {
                                        phi_4838_ = bitcast<f32>(_e2212);
                                    } else {
                                        let _e2228 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2219)), 32u, _e2223) - 8u);
                                        let _e2231 = (_e2219 << bitcast<u32>((_e2228 & 31u)));
                                        let _e2233 = ((_e2191 + select(0i, 1i, (_e2190 == 0i))) - bitcast<i32>(_e2228));
                                        if (_e2233 >= 255i) {
                                            phi_4828_ = bitcast<f32>((_e2212 | 2139095040u));
                                            phi_4829_ = f32();
                                            phi_4830_ = true;
                                        } else {
                                            let _e2235 = (_e2233 > 0i);
                                            if _e2235 {
                                                phi_4822_ = bitcast<f32>(((_e2212 | (bitcast<u32>(_e2233) << bitcast<u32>(23i))) | (_e2231 & 8388607u)));
                                                phi_4823_ = f32();
                                            } else {
                                                if (_e2233 < -24i) {
                                                    phi_4788_ = 26u;
                                                } else {
                                                    phi_4788_ = bitcast<u32>((1i - _e2233));
                                                }
                                                let _e2240 = phi_4788_;
                                                let _e2241 = (_e2240 & 31u);
                                                let _e2243 = (_e2231 >> bitcast<u32>(_e2241));
                                                let _e2247 = (_e2231 & ((1u << bitcast<u32>(_e2241)) - 1u));
                                                let _e2251 = (1u << bitcast<u32>(((_e2240 - 1u) & 31u)));
                                                if (_e2247 > _e2251) {
                                                    phi_4809_ = true;
                                                } else {
                                                    if (_e2247 == _e2251) {
                                                        phi_4806_ = ((_e2243 & 1u) == 1u);
                                                    } else {
                                                        phi_4806_ = false;
                                                    }
                                                    let _e2257 = phi_4806_;
                                                    phi_4809_ = _e2257;
                                                }
                                                let _e2259 = phi_4809_;
                                                phi_4822_ = f32();
                                                phi_4823_ = bitcast<f32>((_e2212 | (_e2243 + select(0u, 1u, _e2259))));
                                            }
                                            let _e2272 = phi_4822_;
                                            let _e2274 = phi_4823_;
                                            phi_4828_ = _e2272;
                                            phi_4829_ = _e2274;
                                            phi_4830_ = _e2235;
                                        }
                                        let _e2278 = phi_4828_;
                                        let _e2280 = phi_4829_;
                                        let _e2282 = phi_4830_;
                                        phi_4838_ = select(_e2280, _e2278, _e2282);
                                    }
                                    let _e2286 = phi_4838_;
                                    phi_4289_ = _e2286;
                                } else {
                                    phi_4289_ = _e2209;
                                }
                                let _e2288 = phi_4289_;
                                phi_4290_ = _e2288;
                            }
                            let _e2290 = phi_4290_;
                            let _e2291 = bitcast<u32>(_e2290);
                            if ((_e2291 & 2147483647u) >= 2139095040u) {
                                phi_4302_ = bitcast<f32>(((_e2291 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4302_ = _e2290;
                            }
                            let _e2298 = phi_4302_;
                            phi_4307_ = type_18(_e2298, _e2180.member.member.member_1, _e2180.member.member.member_2, _e2180.member.member.member_3);
                        } else {
                            phi_4307_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2303 = phi_4307_;
                        if _e156 {
                        } else {
                            break;
                        }
                        global_1.member[_e140] = _e2303;
                        let _e2307 = local_11;
                        if _e157 {
                        } else {
                            break;
                        }
                        global_4.member[_e140] = _e2307.member_1;
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e2312 = select(0u, 1u, (_e224 <= _e234));
                        if (_e2312 > 0u) {
                            let _e2314 = (1u < _e108);
                            if _e2314 {
                                if (0u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2318 = atomicAdd((&global_5.member[0u]), _e2312);
                                if ((_e2318 + _e2312) < _e2318) {
                                    if _e2314 {
                                    } else {
                                        break;
                                    }
                                    let _e2323 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2326 = select(0u, 1u, (_e2303.member_3 != 4294967295u));
                        if (_e2326 > 0u) {
                            let _e2328 = (3u < _e108);
                            if _e2328 {
                                if (2u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2332 = atomicAdd((&global_5.member[2u]), _e2326);
                                if ((_e2332 + _e2326) < _e2332) {
                                    if _e2328 {
                                    } else {
                                        break;
                                    }
                                    let _e2337 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2307.member_1 > 0u) {
                            let _e2339 = (5u < _e108);
                            if _e2339 {
                                if (4u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2343 = atomicAdd((&global_5.member[4u]), _e2307.member_1);
                                if ((_e2343 + _e2307.member_1) < _e2343) {
                                    if _e2339 {
                                    } else {
                                        break;
                                    }
                                    let _e2348 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
