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
    var phi_520_: i32;
    var phi_521_: i32;
    var phi_531_: bool;
    var phi_541_: u32;
    var phi_542_: u32;
    var phi_544_: bool;
    var phi_549_: u32;
    var phi_582_: i32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_725_: f32;
    var phi_731_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_850_: f32;
    var phi_856_: f32;
    var phi_896_: f32;
    var phi_902_: f32;
    var phi_1021_: i32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1081_: i32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_4812_: bool;
    var phi_1218_: type_39;
    var phi_1221_: bool;
    var phi_1223_: type_50;
    var phi_1225_: u32;
    var phi_1227_: u32;
    var phi_1238_: bool;
    var phi_1324_: bool;
    var phi_1325_: type_50;
    var phi_1326_: u32;
    var phi_3416_: u32;
    var phi_3422_: u32;
    var phi_3676_: u32;
    var phi_3677_: u32;
    var phi_3687_: u32;
    var phi_3689_: u32;
    var phi_3690_: bool;
    var phi_3710_: u32;
    var phi_3711_: u32;
    var phi_3715_: type_51;
    var phi_4080_: type_50;
    var phi_4156_: type_50;
    var phi_4157_: type_50;
    var phi_4158_: u32;
    var phi_4160_: type_50;
    var phi_4161_: u32;
    var phi_4162_: bool;
    var phi_4171_: type_50;
    var phi_4176_: bool;
    var phi_4177_: type_50;
    var phi_1345_: type_39;
    var phi_1348_: type_8;
    var phi_1349_: type_8;
    var phi_1371_: type_8;
    var phi_1415_: u32;
    var phi_1421_: u32;
    var phi_1431_: u32;
    var phi_1447_: u32;
    var phi_1480_: u32;
    var phi_1486_: u32;
    var phi_1952_: u32;
    var phi_1970_: u32;
    var phi_1988_: u32;
    var phi_2011_: u32;
    var phi_2029_: u32;
    var phi_2047_: u32;
    var phi_2070_: u32;
    var phi_2088_: u32;
    var phi_2106_: u32;
    var phi_1660_: u32;
    var phi_1675_: u32;
    var phi_1685_: u32;
    var phi_1706_: u32;
    var phi_1727_: u32;
    var phi_1757_: u32;
    var phi_1772_: u32;
    var phi_1782_: u32;
    var phi_1803_: u32;
    var phi_1824_: u32;
    var phi_1854_: u32;
    var phi_1869_: u32;
    var phi_1879_: u32;
    var phi_1900_: u32;
    var phi_1921_: u32;
    var phi_1513_: u32;
    var phi_1562_: u32;
    var phi_1611_: u32;
    var phi_2112_: array<array<f32, 3>, 3>;
    var phi_2642_: f32;
    var phi_2643_: f32;
    var phi_2644_: f32;
    var phi_2645_: f32;
    var phi_2646_: vec3<f32>;
    var phi_2647_: vec3<f32>;
    var phi_2648_: vec3<f32>;
    var phi_2649_: vec3<f32>;
    var phi_2840_: f32;
    var phi_2860_: type_38;
    var phi_2861_: type_38;
    var phi_2864_: type_38;
    var phi_2865_: type_38;
    var phi_2866_: bool;
    var phi_2870_: type_38;
    var phi_2879_: type_18;
    var phi_2904_: bool;
    var phi_2905_: bool;
    var phi_2912_: type_39;
    var phi_2913_: type_39;
    var phi_2914_: type_39;
    var phi_1346_: type_39;
    var phi_4806_: bool;
    var local_10: type_39;
    var phi_5010_: bool;
    var phi_4179_: type_39;
    var phi_4180_: bool;
    var phi_4181_: type_50;
    var phi_4182_: u32;
    var phi_5009_: bool;
    var phi_4183_: type_39;
    var phi_4184_: bool;
    var phi_4185_: type_50;
    var phi_4186_: u32;
    var phi_4187_: u32;
    var phi_5008_: bool;
    var phi_4188_: type_39;
    var phi_4189_: bool;
    var phi_4190_: type_50;
    var phi_4191_: u32;
    var phi_4192_: u32;
    var phi_5007_: bool;
    var phi_1219_: type_39;
    var phi_1222_: bool;
    var phi_1224_: type_50;
    var phi_1226_: u32;
    var phi_1228_: u32;
    var phi_4193_: bool;
    var phi_5006_: bool;
    var local_11: type_39;
    var phi_4231_: f32;
    var phi_4233_: f32;
    var phi_4234_: bool;
    var phi_4235_: f32;
    var phi_4236_: bool;
    var phi_4714_: u32;
    var phi_4732_: bool;
    var phi_4735_: bool;
    var phi_4748_: f32;
    var phi_4749_: f32;
    var phi_4754_: f32;
    var phi_4755_: f32;
    var phi_4756_: bool;
    var phi_4764_: f32;
    var phi_4251_: f32;
    var phi_4252_: f32;
    var phi_4264_: f32;
    var phi_4269_: type_18;
    var local_12: type_39;
    var local_13: type_39;

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
                                phi_520_ = (bitcast<i32>((_e243 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_520_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e243)), 32u, (_e243 == 0u))));
                            }
                            let _e257 = phi_520_;
                            phi_521_ = _e257;
                        } else {
                            phi_521_ = 0i;
                        }
                        let _e259 = phi_521_;
                        let _e260 = (_e169 == _e213);
                        if _e260 {
                            phi_531_ = true;
                        } else {
                            phi_531_ = (_e177 == _e213);
                        }
                        let _e263 = phi_531_;
                        let _e264 = select(1u, 0u, _e260);
                        if _e263 {
                            let _e265 = (_e264 + 1u);
                            phi_541_ = _e265;
                            phi_542_ = _e265;
                            phi_544_ = select(true, false, (_e265 == 2u));
                        } else {
                            phi_541_ = u32();
                            phi_542_ = 0u;
                            phi_544_ = true;
                        }
                        let _e269 = phi_541_;
                        let _e271 = phi_542_;
                        let _e273 = phi_544_;
                        if _e273 {
                            phi_549_ = (_e271 + 1u);
                        } else {
                            phi_549_ = 0u;
                        }
                        let _e277 = phi_549_;
                        let _e278 = select(_e269, _e271, _e273);
                        let _e279 = select(_e264, select(2u, _e264, _e263), _e273);
                        let _e280 = -(_e259);
                        if (_e280 < -126i) {
                            phi_582_ = -126i;
                        } else {
                            phi_582_ = select(_e280, 127i, (_e280 > 127i));
                        }
                        let _e285 = phi_582_;
                        let _e290 = bitcast<f32>((bitcast<u32>((_e285 + 127i)) << bitcast<u32>(23i)));
                        let _e296 = bitcast<f32>((bitcast<u32>(((_e280 - _e285) + 127i)) << bitcast<u32>(23i)));
                        let _e301 = global_3.member[_e140].member.member;
                        let _e302 = (_e278 == 0u);
                        if _e302 {
                            phi_600_ = _e301[0];
                        } else {
                            phi_600_ = _e301[1];
                        }
                        let _e306 = phi_600_;
                        let _e307 = (_e278 == 2u);
                        if _e307 {
                            phi_606_ = _e301[2];
                        } else {
                            phi_606_ = _e306;
                        }
                        let _e310 = phi_606_;
                        let _e311 = bitcast<u32>(_e310);
                        let _e313 = ((_e311 & 2139095040u) != 0u);
                        let _e325 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e311 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e311 & 2147483648u))), _e310, _e313) * select(0.00000011920929f, 1f, _e313));
                        let _e326 = global_3.member[_e140].member.member_2;
                        if _e302 {
                            phi_646_ = _e326[0];
                        } else {
                            phi_646_ = _e326[1];
                        }
                        let _e330 = phi_646_;
                        if _e307 {
                            phi_652_ = _e326[2];
                        } else {
                            phi_652_ = _e330;
                        }
                        let _e333 = phi_652_;
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
                            phi_725_ = _e301[0];
                        } else {
                            phi_725_ = _e301[1];
                        }
                        let _e371 = phi_725_;
                        let _e372 = (_e277 == 2u);
                        if _e372 {
                            phi_731_ = _e301[2];
                        } else {
                            phi_731_ = _e371;
                        }
                        let _e375 = phi_731_;
                        let _e376 = bitcast<u32>(_e375);
                        let _e378 = ((_e376 & 2139095040u) != 0u);
                        let _e390 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e376 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e376 & 2147483648u))), _e375, _e378) * select(0.00000011920929f, 1f, _e378));
                        if _e367 {
                            phi_771_ = _e326[0];
                        } else {
                            phi_771_ = _e326[1];
                        }
                        let _e394 = phi_771_;
                        if _e372 {
                            phi_777_ = _e326[2];
                        } else {
                            phi_777_ = _e394;
                        }
                        let _e397 = phi_777_;
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
                            phi_850_ = _e301[0];
                        } else {
                            phi_850_ = _e301[1];
                        }
                        let _e435 = phi_850_;
                        let _e436 = (_e279 == 2u);
                        if _e436 {
                            phi_856_ = _e301[2];
                        } else {
                            phi_856_ = _e435;
                        }
                        let _e439 = phi_856_;
                        let _e440 = bitcast<u32>(_e439);
                        let _e442 = ((_e440 & 2139095040u) != 0u);
                        let _e454 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * select(0.00000011920929f, 1f, _e442));
                        if _e431 {
                            phi_896_ = _e326[0];
                        } else {
                            phi_896_ = _e326[1];
                        }
                        let _e458 = phi_896_;
                        if _e436 {
                            phi_902_ = _e326[2];
                        } else {
                            phi_902_ = _e458;
                        }
                        let _e461 = phi_902_;
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
                                phi_1021_ = 255i;
                            } else {
                                phi_1021_ = (((_e511 + select(0i, 1i, (_e511 == 0i))) - _e518) + _e259);
                            }
                            let _e526 = phi_1021_;
                            let _e536 = (_e526 <= 0i);
                            if _e536 {
                                phi_1044_ = u32();
                            } else {
                                if _e515 {
                                    phi_1043_ = u32();
                                } else {
                                    phi_1043_ = select(((bitcast<u32>(_e526) << bitcast<u32>(23i)) | ((_e508 << bitcast<u32>(((_e518 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e526 >= 255i));
                                }
                                let _e540 = phi_1043_;
                                phi_1044_ = _e540;
                            }
                            let _e542 = phi_1044_;
                            let _e554 = ((_e236 & 8388607u) | (select(0u, 1u, ((_e236 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e557 = bitcast<i32>((_e236 >> bitcast<u32>(23i)));
                            let _e561 = (_e554 == 0u);
                            let _e564 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e554)), 32u, _e561)) - 8i);
                            if (_e557 == 255i) {
                                phi_1081_ = 255i;
                            } else {
                                phi_1081_ = (((_e557 + select(0i, 1i, (_e557 == 0i))) - _e564) + _e259);
                            }
                            let _e572 = phi_1081_;
                            let _e582 = (_e572 <= 0i);
                            if _e582 {
                                phi_1104_ = u32();
                            } else {
                                if _e561 {
                                    phi_1103_ = u32();
                                } else {
                                    phi_1103_ = select(((bitcast<u32>(_e572) << bitcast<u32>(23i)) | ((_e554 << bitcast<u32>(((_e564 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e572 >= 255i));
                                }
                                let _e586 = phi_1103_;
                                phi_1104_ = _e586;
                            }
                            let _e588 = phi_1104_;
                            phi_1112_ = bitcast<f32>(((_e235 & 2147483648u) | select(_e588, 0u, select(_e561, true, _e582))));
                            phi_1113_ = bitcast<f32>(((_e225 & 2147483648u) | select(_e542, 0u, select(_e515, true, _e536))));
                        } else {
                            phi_1112_ = 0f;
                            phi_1113_ = 1f;
                        }
                        let _e594 = phi_1112_;
                        let _e596 = phi_1113_;
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
                        let _e607 = (_e278 % 3u);
                        let _e608 = (_e607 < 3u);
                        if _e608 {
                        } else {
                            break;
                        }
                        let _e610 = local_1[_e607];
                        let _e613 = (_e277 % 3u);
                        let _e614 = (_e613 < 3u);
                        if _e614 {
                        } else {
                            break;
                        }
                        let _e616 = local_1[_e613];
                        let _e619 = (_e279 % 3u);
                        let _e620 = (_e619 < 3u);
                        if _e620 {
                        } else {
                            break;
                        }
                        let _e622 = local_1[_e619];
                        if _e608 {
                        } else {
                            break;
                        }
                        let _e627 = local[_e607];
                        if _e614 {
                        } else {
                            break;
                        }
                        let _e631 = local[_e613];
                        if _e620 {
                        } else {
                            break;
                        }
                        let _e635 = local[_e619];
                        phi_4812_ = false;
                        phi_1218_ = type_39(type_35(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e594), 0u, 0u);
                        phi_1221_ = (_e596 <= _e594);
                        phi_1223_ = type_50(type_30(vec4<f32>((f32(_e610) * _e152), (f32(_e616) * _e152), (f32(_e622) * _e152), 0f), vec4<f32>((f32(_e627) * _e152), (f32(_e631) * _e152), (f32(_e635) * _e152), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                        phi_1225_ = 0u;
                        phi_1227_ = ((3u * _e97) + 1u);
                        loop {
                            let _e643 = phi_4812_;
                            let _e645 = phi_1218_;
                            let _e647 = phi_1221_;
                            let _e649 = phi_1223_;
                            let _e651 = phi_1225_;
                            let _e653 = phi_1227_;
                            local_11 = _e645;
                            local_12 = _e645;
                            if _e647 {
                                phi_1238_ = true;
                            } else {
                                phi_1238_ = (_e651 > 0u);
                            }
                            let _e656 = phi_1238_;
                            if _e656 {
                                let _e657 = (_e653 > 0u);
                                if _e657 {
                                    if _e647 {
                                        phi_1324_ = _e647;
                                        phi_1325_ = _e649;
                                        phi_1326_ = _e651;
                                    } else {
                                        let _e658 = (_e651 - 1u);
                                        let _e659 = (_e658 % 128u);
                                        let _e660 = (_e659 < 128u);
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e662 = local_7[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e664 = local_6[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e666 = local_5[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e668 = local_4[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e670 = local_3[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e672 = local_2[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e677 = local_8[_e659];
                                        if _e660 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e680 = local_9[_e659];
                                        phi_1324_ = (_e680 <= _e645.member.member_1);
                                        phi_1325_ = type_50(type_30(vec4<f32>(_e662, _e664, _e666, 0f), vec4<f32>(_e668, _e670, _e672, 0f)), _e677);
                                        phi_1326_ = _e658;
                                    }
                                    let _e685 = phi_1324_;
                                    let _e687 = phi_1325_;
                                    let _e689 = phi_1326_;
                                    if _e685 {
                                        let _e694 = (_e687.member_1 & 268435455u);
                                        if ((_e687.member_1 & 2147483648u) != 0u) {
                                            phi_1345_ = _e645;
                                            phi_1348_ = type_8(0u, ((_e687.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1184 = phi_1345_;
                                                let _e1186 = phi_1348_;
                                                local_10 = _e1184;
                                                local_13 = _e1184;
                                                if (_e1186.member < _e1186.member_1) {
                                                    phi_1349_ = type_8((_e1186.member + 1u), _e1186.member_1);
                                                    phi_1371_ = type_8(1u, _e1186.member);
                                                } else {
                                                    phi_1349_ = _e1186;
                                                    phi_1371_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1199 = phi_1349_;
                                                let _e1201 = phi_1371_;
                                                let _e1205 = (bitcast<i32>(_e1201.member) != 0i);
                                                if _e1205 {
                                                    let _e1211 = type_39(_e1184.member, _e1184.member_1, (_e1184.member_2 + 1u));
                                                    let _e1216 = (_e687.member.member_1.x - _e687.member.member.x);
                                                    let _e1219 = (_e687.member.member_1.y - _e687.member.member.y);
                                                    let _e1222 = (_e687.member.member_1.z - _e687.member.member.z);
                                                    let _e1224 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                    let _e1226 = select(_e1222, _e1224, (_e1224 > _e1222));
                                                    let _e1228 = (_e1226 < (1024f * _e152));
                                                    if _e1228 {
                                                        phi_1415_ = 0u;
                                                    } else {
                                                        phi_1415_ = select(2u, 1u, (_e1226 < (2097152f * _e152)));
                                                    }
                                                    let _e1233 = phi_1415_;
                                                    switch bitcast<i32>(_e1233) {
                                                        case 0: {
                                                            phi_1421_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1421_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1421_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1421_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1236 = phi_1421_;
                                                    switch bitcast<i32>(_e1233) {
                                                        case 0: {
                                                            phi_1431_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1431_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1431_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1431_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1243 = phi_1431_;
                                                    let _e1245 = ((_e694 + (_e1201.member_1 * ((3u * _e1236) + 1u))) + (3u * _e1243));
                                                    let _e1246 = (_e1245 < _e100);
                                                    if _e1246 {
                                                        if _e1246 {
                                                        } else {
                                                            phi_4806_ = true;
                                                            break;
                                                        }
                                                        let _e1248 = global_7.member[_e1245];
                                                        phi_1447_ = _e1248;
                                                    } else {
                                                        phi_1447_ = 4294967295u;
                                                    }
                                                    let _e1250 = phi_1447_;
                                                    if _e1228 {
                                                        phi_1480_ = 0u;
                                                    } else {
                                                        phi_1480_ = select(2u, 1u, (_e1226 < (2097152f * _e152)));
                                                    }
                                                    let _e1255 = phi_1480_;
                                                    switch bitcast<i32>(_e1255) {
                                                        case 0: {
                                                            phi_1486_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1486_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1486_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1486_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1258 = phi_1486_;
                                                    let _e1262 = (_e694 + (_e1201.member_1 * ((3u * _e1258) + 1u)));
                                                    switch bitcast<i32>(_e1255) {
                                                        case 0: {
                                                            let _e1537 = (_e1262 < _e100);
                                                            if _e1537 {
                                                                if _e1537 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1539 = global_7.member[_e1262];
                                                                phi_1513_ = _e1539;
                                                            } else {
                                                                phi_1513_ = 0u;
                                                            }
                                                            let _e1541 = phi_1513_;
                                                            let _e1543 = ((10u * _e278) & 31u);
                                                            let _e1553 = ((10u * _e277) & 31u);
                                                            let _e1563 = ((10u * _e279) & 31u);
                                                            let _e1573 = (_e1262 + 1u);
                                                            let _e1574 = (_e1573 < _e100);
                                                            if _e1574 {
                                                                if _e1574 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1576 = global_7.member[_e1573];
                                                                phi_1562_ = _e1576;
                                                            } else {
                                                                phi_1562_ = 0u;
                                                            }
                                                            let _e1578 = phi_1562_;
                                                            let _e1604 = (_e1262 + 2u);
                                                            let _e1605 = (_e1604 < _e100);
                                                            if _e1605 {
                                                                if _e1605 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1607 = global_7.member[_e1604];
                                                                phi_1611_ = _e1607;
                                                            } else {
                                                                phi_1611_ = 0u;
                                                            }
                                                            let _e1609 = phi_1611_;
                                                            phi_2112_ = array<array<f32, 3>, 3>(array<f32, 3>((_e687.member.member.x + ((bitcast<f32>((1258291200u | ((_e1541 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e152)), (_e687.member.member.y + ((bitcast<f32>((1258291200u | ((_e1541 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e152)), (_e687.member.member.z + ((bitcast<f32>((1258291200u | ((_e1541 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e687.member.member.x + ((bitcast<f32>((1258291200u | ((_e1578 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e152)), (_e687.member.member.y + ((bitcast<f32>((1258291200u | ((_e1578 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e152)), (_e687.member.member.z + ((bitcast<f32>((1258291200u | ((_e1578 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e687.member.member.x + ((bitcast<f32>((1258291200u | ((_e1609 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e152)), (_e687.member.member.y + ((bitcast<f32>((1258291200u | ((_e1609 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e152)), (_e687.member.member.z + ((bitcast<f32>((1258291200u | ((_e1609 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1351 = (_e1262 < _e100);
                                                            if _e1351 {
                                                                if _e1351 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1353 = global_7.member[_e1262];
                                                                phi_1660_ = _e1353;
                                                            } else {
                                                                phi_1660_ = 0u;
                                                            }
                                                            let _e1355 = phi_1660_;
                                                            let _e1356 = (_e1262 + 1u);
                                                            let _e1357 = (_e1356 < _e100);
                                                            if _e1357 {
                                                                if _e1357 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1359 = global_7.member[_e1356];
                                                                phi_1675_ = _e1359;
                                                            } else {
                                                                phi_1675_ = 0u;
                                                            }
                                                            let _e1361 = phi_1675_;
                                                            let _e1362 = (_e278 == 1u);
                                                            if _e1362 {
                                                                phi_1685_ = ((_e1355 >> bitcast<u32>(21i)) | (_e1361 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1685_ = (_e1361 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1371 = phi_1685_;
                                                            let _e1379 = (_e277 == 1u);
                                                            if _e1379 {
                                                                phi_1706_ = ((_e1355 >> bitcast<u32>(21i)) | (_e1361 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1706_ = (_e1361 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1388 = phi_1706_;
                                                            let _e1396 = (_e279 == 1u);
                                                            if _e1396 {
                                                                phi_1727_ = ((_e1355 >> bitcast<u32>(21i)) | (_e1361 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1727_ = (_e1361 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1405 = phi_1727_;
                                                            let _e1414 = (_e1262 + 2u);
                                                            let _e1415 = (_e1414 < _e100);
                                                            if _e1415 {
                                                                if _e1415 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1417 = global_7.member[_e1414];
                                                                phi_1757_ = _e1417;
                                                            } else {
                                                                phi_1757_ = 0u;
                                                            }
                                                            let _e1419 = phi_1757_;
                                                            let _e1420 = (_e1262 + 3u);
                                                            let _e1421 = (_e1420 < _e100);
                                                            if _e1421 {
                                                                if _e1421 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1423 = global_7.member[_e1420];
                                                                phi_1772_ = _e1423;
                                                            } else {
                                                                phi_1772_ = 0u;
                                                            }
                                                            let _e1425 = phi_1772_;
                                                            if _e1362 {
                                                                phi_1782_ = ((_e1419 >> bitcast<u32>(21i)) | (_e1425 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1782_ = (_e1425 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1434 = phi_1782_;
                                                            if _e1379 {
                                                                phi_1803_ = ((_e1419 >> bitcast<u32>(21i)) | (_e1425 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1803_ = (_e1425 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1450 = phi_1803_;
                                                            if _e1396 {
                                                                phi_1824_ = ((_e1419 >> bitcast<u32>(21i)) | (_e1425 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1824_ = (_e1425 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1466 = phi_1824_;
                                                            let _e1475 = (_e1262 + 4u);
                                                            let _e1476 = (_e1475 < _e100);
                                                            if _e1476 {
                                                                if _e1476 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1478 = global_7.member[_e1475];
                                                                phi_1854_ = _e1478;
                                                            } else {
                                                                phi_1854_ = 0u;
                                                            }
                                                            let _e1480 = phi_1854_;
                                                            let _e1481 = (_e1262 + 5u);
                                                            let _e1482 = (_e1481 < _e100);
                                                            if _e1482 {
                                                                if _e1482 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1484 = global_7.member[_e1481];
                                                                phi_1869_ = _e1484;
                                                            } else {
                                                                phi_1869_ = 0u;
                                                            }
                                                            let _e1486 = phi_1869_;
                                                            if _e1362 {
                                                                phi_1879_ = ((_e1480 >> bitcast<u32>(21i)) | (_e1486 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1879_ = (_e1486 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1495 = phi_1879_;
                                                            if _e1379 {
                                                                phi_1900_ = ((_e1480 >> bitcast<u32>(21i)) | (_e1486 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1900_ = (_e1486 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1511 = phi_1900_;
                                                            if _e1396 {
                                                                phi_1921_ = ((_e1480 >> bitcast<u32>(21i)) | (_e1486 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1921_ = (_e1486 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1527 = phi_1921_;
                                                            phi_2112_ = array<array<f32, 3>, 3>(array<f32, 3>((_e687.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1371, _e1355, _e302) & 2097151u))) - 8388608f) * _e152)), (_e687.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1388, _e1355, _e367) & 2097151u))) - 8388608f) * _e152)), (_e687.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1405, _e1355, _e431) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e687.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1434, _e1419, _e302) & 2097151u))) - 8388608f) * _e152)), (_e687.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1450, _e1419, _e367) & 2097151u))) - 8388608f) * _e152)), (_e687.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1466, _e1419, _e431) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e687.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1495, _e1480, _e302) & 2097151u))) - 8388608f) * _e152)), (_e687.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1511, _e1480, _e367) & 2097151u))) - 8388608f) * _e152)), (_e687.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1527, _e1480, _e431) & 2097151u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1264 = (_e1262 + _e278);
                                                            let _e1265 = (_e1264 < _e100);
                                                            if _e1265 {
                                                                if _e1265 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1267 = global_7.member[_e1264];
                                                                phi_1952_ = _e1267;
                                                            } else {
                                                                phi_1952_ = 0u;
                                                            }
                                                            let _e1269 = phi_1952_;
                                                            let _e1273 = (_e1262 + _e277);
                                                            let _e1274 = (_e1273 < _e100);
                                                            if _e1274 {
                                                                if _e1274 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1276 = global_7.member[_e1273];
                                                                phi_1970_ = _e1276;
                                                            } else {
                                                                phi_1970_ = 0u;
                                                            }
                                                            let _e1278 = phi_1970_;
                                                            let _e1282 = (_e1262 + _e279);
                                                            let _e1283 = (_e1282 < _e100);
                                                            if _e1283 {
                                                                if _e1283 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1285 = global_7.member[_e1282];
                                                                phi_1988_ = _e1285;
                                                            } else {
                                                                phi_1988_ = 0u;
                                                            }
                                                            let _e1287 = phi_1988_;
                                                            let _e1292 = (_e1262 + 3u);
                                                            let _e1293 = (_e1292 + _e278);
                                                            let _e1294 = (_e1293 < _e100);
                                                            if _e1294 {
                                                                if _e1294 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1296 = global_7.member[_e1293];
                                                                phi_2011_ = _e1296;
                                                            } else {
                                                                phi_2011_ = 0u;
                                                            }
                                                            let _e1298 = phi_2011_;
                                                            let _e1302 = (_e1292 + _e277);
                                                            let _e1303 = (_e1302 < _e100);
                                                            if _e1303 {
                                                                if _e1303 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1305 = global_7.member[_e1302];
                                                                phi_2029_ = _e1305;
                                                            } else {
                                                                phi_2029_ = 0u;
                                                            }
                                                            let _e1307 = phi_2029_;
                                                            let _e1311 = (_e1292 + _e279);
                                                            let _e1312 = (_e1311 < _e100);
                                                            if _e1312 {
                                                                if _e1312 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1314 = global_7.member[_e1311];
                                                                phi_2047_ = _e1314;
                                                            } else {
                                                                phi_2047_ = 0u;
                                                            }
                                                            let _e1316 = phi_2047_;
                                                            let _e1321 = (_e1262 + 6u);
                                                            let _e1322 = (_e1321 + _e278);
                                                            let _e1323 = (_e1322 < _e100);
                                                            if _e1323 {
                                                                if _e1323 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1325 = global_7.member[_e1322];
                                                                phi_2070_ = _e1325;
                                                            } else {
                                                                phi_2070_ = 0u;
                                                            }
                                                            let _e1327 = phi_2070_;
                                                            let _e1331 = (_e1321 + _e277);
                                                            let _e1332 = (_e1331 < _e100);
                                                            if _e1332 {
                                                                if _e1332 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1334 = global_7.member[_e1331];
                                                                phi_2088_ = _e1334;
                                                            } else {
                                                                phi_2088_ = 0u;
                                                            }
                                                            let _e1336 = phi_2088_;
                                                            let _e1340 = (_e1321 + _e279);
                                                            let _e1341 = (_e1340 < _e100);
                                                            if _e1341 {
                                                                if _e1341 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1343 = global_7.member[_e1340];
                                                                phi_2106_ = _e1343;
                                                            } else {
                                                                phi_2106_ = 0u;
                                                            }
                                                            let _e1345 = phi_2106_;
                                                            phi_2112_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1269)) * _e152), (f32(bitcast<i32>(_e1278)) * _e152), (f32(bitcast<i32>(_e1287)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e1298)) * _e152), (f32(bitcast<i32>(_e1307)) * _e152), (f32(bitcast<i32>(_e1316)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e1327)) * _e152), (f32(bitcast<i32>(_e1336)) * _e152), (f32(bitcast<i32>(_e1345)) * _e152)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2112_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1637 = phi_2112_;
                                                    let _e1654 = (_e1637[0][2] - _e454);
                                                    let _e1657 = (((_e1637[0][0] - _e325) * _e490) - (_e1654 * _e362));
                                                    let _e1660 = (((_e1637[0][1] - _e390) * _e490) - (_e1654 * _e426));
                                                    let _e1663 = (_e1637[1][2] - _e454);
                                                    let _e1666 = (((_e1637[1][0] - _e325) * _e490) - (_e1663 * _e362));
                                                    let _e1669 = (((_e1637[1][1] - _e390) * _e490) - (_e1663 * _e426));
                                                    let _e1672 = (_e1637[2][2] - _e454);
                                                    let _e1675 = (((_e1637[2][0] - _e325) * _e490) - (_e1672 * _e362));
                                                    let _e1678 = (((_e1637[2][1] - _e390) * _e490) - (_e1672 * _e426));
                                                    let _e1679 = (_e1675 * _e1669);
                                                    let _e1680 = (_e1678 * _e1666);
                                                    let _e1681 = (_e1657 * _e1678);
                                                    let _e1682 = (_e1660 * _e1675);
                                                    let _e1683 = (_e1666 * _e1660);
                                                    let _e1684 = (_e1669 * _e1657);
                                                    let _e1689 = (((_e1679 >= _e1680) && (_e1681 >= _e1682)) && (_e1683 >= _e1684));
                                                    let _e1695 = (_e1689 || (((_e1679 <= _e1680) && (_e1681 <= _e1682)) && (_e1683 <= _e1684)));
                                                    if _e1695 {
                                                        let _e1697 = select(-1f, 1f, _e1689);
                                                        let _e1699 = ((_e1679 - _e1680) * _e1697);
                                                        let _e1701 = select(0f, _e1699, (_e1699 > 0f));
                                                        let _e1703 = ((_e1681 - _e1682) * _e1697);
                                                        let _e1705 = select(0f, _e1703, (_e1703 > 0f));
                                                        let _e1707 = ((_e1683 - _e1684) * _e1697);
                                                        let _e1709 = select(0f, _e1707, (_e1707 > 0f));
                                                        let _e1711 = ((_e1701 + _e1705) + _e1709);
                                                        let _e1713 = select(_e1637[1][0], _e1637[0][0], (_e1637[0][0] < _e1637[1][0]));
                                                        let _e1717 = select(_e1637[1][0], _e1637[0][0], (_e1637[0][0] > _e1637[1][0]));
                                                        let _e1721 = select(_e1637[1][1], _e1637[0][1], (_e1637[0][1] < _e1637[1][1]));
                                                        let _e1725 = select(_e1637[1][1], _e1637[0][1], (_e1637[0][1] > _e1637[1][1]));
                                                        let _e1729 = select(_e1637[1][2], _e1637[0][2], (_e1637[0][2] < _e1637[1][2]));
                                                        let _e1733 = select(_e1637[1][2], _e1637[0][2], (_e1637[0][2] > _e1637[1][2]));
                                                        let _e1738 = ((select(_e1637[2][0], _e1713, (_e1713 < _e1637[2][0])) - _e363) * _e366);
                                                        let _e1739 = ((select(_e1637[2][0], _e1717, (_e1717 > _e1637[2][0])) - _e364) * _e366);
                                                        let _e1742 = ((select(_e1637[2][1], _e1721, (_e1721 < _e1637[2][1])) - _e427) * _e430);
                                                        let _e1743 = ((select(_e1637[2][1], _e1725, (_e1725 > _e1637[2][1])) - _e428) * _e430);
                                                        let _e1746 = ((select(_e1637[2][2], _e1729, (_e1729 < _e1637[2][2])) - _e491) * _e494);
                                                        let _e1747 = ((select(_e1637[2][2], _e1733, (_e1733 > _e1637[2][2])) - _e492) * _e494);
                                                        let _e1749 = select(_e1747, _e1746, (_e1746 < _e1747));
                                                        let _e1751 = select(_e1747, _e1746, (_e1746 > _e1747));
                                                        let _e1753 = select(_e1739, _e1738, (_e1738 < _e1739));
                                                        let _e1755 = select(_e1743, _e1742, (_e1742 < _e1743));
                                                        let _e1757 = select(_e1755, _e1753, (_e1753 > _e1755));
                                                        let _e1759 = select(_e1749, _e1757, (_e1757 > _e1749));
                                                        let _e1761 = select(_e1739, _e1738, (_e1738 > _e1739));
                                                        let _e1763 = select(_e1743, _e1742, (_e1742 > _e1743));
                                                        let _e1765 = select(_e1763, _e1761, (_e1761 < _e1763));
                                                        let _e1767 = select(_e1751, _e1765, (_e1765 < _e1751));
                                                        let _e1768 = -(_e1749);
                                                        let _e1774 = select(_e596, _e1759, (_e1759 > _e596));
                                                        let _e1778 = select(_e1666, _e1657, (_e1657 < _e1666));
                                                        let _e1783 = select(_e1666, _e1657, (_e1657 > _e1666));
                                                        let _e1790 = select(_e1669, _e1660, (_e1660 < _e1669));
                                                        let _e1795 = select(_e1669, _e1660, (_e1660 > _e1669));
                                                        let _e1804 = (((((_e1695 && (_e1711 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1675, _e1778, (_e1778 < _e1675)) <= 0f) && (select(_e1675, _e1783, (_e1783 > _e1675)) >= 0f))) && ((select(_e1678, _e1790, (_e1790 < _e1678)) <= 0f) && (select(_e1678, _e1795, (_e1795 > _e1678)) >= 0f))) && (_e1774 <= (_e1767 + (select(_e1768, _e1751, (_e1751 > _e1768)) * 0.0000019073523f)))) && (_e1774 <= _e1184.member.member_1));
                                                        if _e1804 {
                                                            let _e1809 = (_e1637[1][0] - _e1637[0][0]);
                                                            let _e1810 = (_e1637[1][1] - _e1637[0][1]);
                                                            let _e1811 = (_e1637[1][2] - _e1637[0][2]);
                                                            let _e1812 = vec3<f32>(_e1809, _e1810, _e1811);
                                                            let _e1813 = (_e1637[2][0] - _e1637[1][0]);
                                                            let _e1814 = (_e1637[2][1] - _e1637[1][1]);
                                                            let _e1815 = (_e1637[2][2] - _e1637[1][2]);
                                                            let _e1816 = vec3<f32>(_e1813, _e1814, _e1815);
                                                            let _e1817 = (_e1637[0][0] - _e1637[2][0]);
                                                            let _e1818 = (_e1637[0][1] - _e1637[2][1]);
                                                            let _e1819 = (_e1637[0][2] - _e1637[2][2]);
                                                            let _e1820 = vec3<f32>(_e1817, _e1818, _e1819);
                                                            let _e1823 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
                                                            let _e1826 = bitcast<f32>((bitcast<u32>(_e1810) & 2147483647u));
                                                            let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                            let _e1831 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                            let _e1833 = select(_e1831, _e1828, (_e1828 > _e1831));
                                                            let _e1836 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                            let _e1839 = bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u));
                                                            let _e1841 = select(_e1839, _e1836, (_e1836 > _e1839));
                                                            let _e1844 = bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u));
                                                            let _e1846 = select(_e1844, _e1841, (_e1841 > _e1844));
                                                            let _e1849 = bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u));
                                                            let _e1852 = bitcast<f32>((bitcast<u32>(_e1818) & 2147483647u));
                                                            let _e1854 = select(_e1852, _e1849, (_e1849 > _e1852));
                                                            let _e1857 = bitcast<f32>((bitcast<u32>(_e1819) & 2147483647u));
                                                            let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                            let _e1861 = select(_e1846, _e1833, (_e1833 > _e1846));
                                                            let _e1863 = select(_e1859, _e1861, (_e1861 > _e1859));
                                                            if (_e1833 == _e1863) {
                                                                phi_2642_ = _e1669;
                                                                phi_2643_ = _e1666;
                                                                phi_2644_ = _e1660;
                                                                phi_2645_ = _e1657;
                                                                phi_2646_ = vec3<f32>(_e1637[0][0], _e1637[0][1], _e1637[0][2]);
                                                                phi_2647_ = _e1820;
                                                                phi_2648_ = _e1816;
                                                                phi_2649_ = _e1812;
                                                            } else {
                                                                let _e1865 = (_e1846 == _e1863);
                                                                let _e1870 = vec3(_e1865);
                                                                phi_2642_ = select(_e1660, _e1678, _e1865);
                                                                phi_2643_ = select(_e1657, _e1675, _e1865);
                                                                phi_2644_ = select(_e1678, _e1669, _e1865);
                                                                phi_2645_ = select(_e1675, _e1666, _e1865);
                                                                phi_2646_ = select(vec3<f32>(_e1637[2][0], _e1637[2][1], _e1637[2][2]), vec3<f32>(_e1637[1][0], _e1637[1][1], _e1637[1][2]), _e1870);
                                                                phi_2647_ = select(_e1816, _e1812, _e1870);
                                                                phi_2648_ = select(_e1812, _e1820, _e1870);
                                                                phi_2649_ = select(_e1820, _e1816, _e1870);
                                                            }
                                                            let _e1876 = phi_2642_;
                                                            let _e1878 = phi_2643_;
                                                            let _e1880 = phi_2644_;
                                                            let _e1882 = phi_2645_;
                                                            let _e1884 = phi_2646_;
                                                            let _e1886 = phi_2647_;
                                                            let _e1888 = phi_2648_;
                                                            let _e1890 = phi_2649_;
                                                            let _e1897 = ((_e1888.y * _e1886.z) - (_e1886.y * _e1888.z));
                                                            let _e1902 = ((_e1888.z * _e1886.x) - (_e1886.z * _e1888.x));
                                                            let _e1905 = ((_e1888.x * _e1886.y) - (_e1886.x * _e1888.y));
                                                            let _e1908 = ((_e1701 >= _e1705) && (_e1701 >= _e1709));
                                                            let _e1909 = (_e1705 >= _e1709);
                                                            let _e1923 = (((_e1897 * (select(select(_e1637[2][0], _e1637[1][0], _e1909), _e1637[0][0], _e1908) - _e325)) + (_e1902 * (select(select(_e1637[2][1], _e1637[1][1], _e1909), _e1637[0][1], _e1908) - _e390))) + (_e1905 * (select(select(_e1637[2][2], _e1637[1][2], _e1909), _e1637[0][2], _e1908) - _e454)));
                                                            let _e1928 = (((_e1897 * _e362) + (_e1902 * _e426)) + (_e1905 * _e490));
                                                            let _e1929 = (_e1878 - _e1882);
                                                            let _e1930 = (_e1876 - _e1880);
                                                            let _e1933 = ((_e1929 * _e1929) + (_e1930 * _e1930));
                                                            let _e1940 = (-(((_e1882 * _e1929) + (_e1880 * _e1930))) / select(0.000000000000000000000000000000000000011754944f, _e1933, (_e1933 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1942 = select(1f, _e1940, (_e1940 < 1f));
                                                            let _e1944 = select(0f, _e1942, (_e1942 > 0f));
                                                            let _e1953 = ((_e1884.x + (_e1890.x * _e1944)) - _e325);
                                                            let _e1956 = ((_e1884.y + (_e1890.y * _e1944)) - _e390);
                                                            let _e1959 = ((_e1884.z + (_e1890.z * _e1944)) - _e454);
                                                            let _e1962 = bitcast<f32>((bitcast<u32>(_e1953) & 2147483647u));
                                                            let _e1965 = bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u));
                                                            let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                            let _e1970 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                            let _e1972 = select(_e1970, _e1967, (_e1967 > _e1970));
                                                            let _e1978 = bitcast<f32>((bitcast<u32>(_e1897) & 2147483647u));
                                                            let _e1981 = bitcast<f32>((bitcast<u32>(_e1902) & 2147483647u));
                                                            let _e1983 = select(_e1981, _e1978, (_e1978 > _e1981));
                                                            let _e1986 = bitcast<f32>((bitcast<u32>(_e1905) & 2147483647u));
                                                            let _e2005 = bitcast<f32>((bitcast<u32>(_e1888.x) & 2147483647u));
                                                            let _e2008 = bitcast<f32>((bitcast<u32>(_e1888.y) & 2147483647u));
                                                            let _e2010 = select(_e2008, _e2005, (_e2005 > _e2008));
                                                            let _e2013 = bitcast<f32>((bitcast<u32>(_e1888.z) & 2147483647u));
                                                            let _e2019 = bitcast<f32>((bitcast<u32>(_e1886.x) & 2147483647u));
                                                            let _e2022 = bitcast<f32>((bitcast<u32>(_e1886.y) & 2147483647u));
                                                            let _e2024 = select(_e2022, _e2019, (_e2019 > _e2022));
                                                            let _e2027 = bitcast<f32>((bitcast<u32>(_e1886.z) & 2147483647u));
                                                            let _e2033 = ((bitcast<f32>((bitcast<u32>(((((_e1897 * _e1953) + (_e1902 * _e1956)) + (_e1905 * _e1959)) - _e1923)) & 2147483647u)) <= ((0.0000009536743f * select(_e1863, _e1972, (_e1972 > _e1863))) * select(_e1986, _e1983, (_e1983 > _e1986)))) && !((bitcast<f32>((bitcast<u32>(_e1928) & 2147483647u)) <= ((0.0000038146973f * select(_e2013, _e2010, (_e2010 > _e2013))) * select(_e2027, _e2024, (_e2024 > _e2027))))));
                                                            let _e2034 = (_e1923 / _e1928);
                                                            if (_e1804 && !(_e2033)) {
                                                                let _e2037 = (_e1959 / _e490);
                                                                let _e2045 = (((_e1897 * (_e1953 - (_e362 * _e2037))) + (_e1902 * (_e1956 - (_e426 * _e2037)))) / _e1928);
                                                                phi_2840_ = select(select(_e2037, (_e2037 + _e2045), (bitcast<f32>((bitcast<u32>(_e2045) & 2147483647u)) <= _e1863)), _e2034, _e2033);
                                                            } else {
                                                                phi_2840_ = _e2034;
                                                            }
                                                            let _e2054 = phi_2840_;
                                                            let _e2056 = select(_e1767, _e2054, (_e2054 < _e1767));
                                                            let _e2058 = select(_e1759, _e2056, (_e2056 > _e1759));
                                                            let _e2059 = (1f / _e1711);
                                                            phi_2860_ = type_38(_e2058, (_e1705 * _e2059), (_e1709 * _e2059), ((_e1804 && (_e2058 >= _e596)) && (_e2058 <= _e1184.member.member_1)));
                                                            phi_2861_ = type_38();
                                                        } else {
                                                            phi_2860_ = type_38();
                                                            phi_2861_ = type_38(0f, 0f, 0f, _e1804);
                                                        }
                                                        let _e2068 = phi_2860_;
                                                        let _e2070 = phi_2861_;
                                                        phi_2864_ = _e2068;
                                                        phi_2865_ = _e2070;
                                                        phi_2866_ = select(true, false, _e1804);
                                                    } else {
                                                        phi_2864_ = type_38();
                                                        phi_2865_ = type_38(0f, 0f, 0f, _e1695);
                                                        phi_2866_ = true;
                                                    }
                                                    let _e2073 = phi_2864_;
                                                    let _e2075 = phi_2865_;
                                                    let _e2077 = phi_2866_;
                                                    if _e2077 {
                                                        phi_2870_ = _e2075;
                                                    } else {
                                                        phi_2870_ = _e2073;
                                                    }
                                                    let _e2079 = phi_2870_;
                                                    if _e2079.member_3 {
                                                        phi_2879_ = type_18(_e2079.member, _e2079.member_1, _e2079.member_2, _e1250);
                                                    } else {
                                                        phi_2879_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e2086 = phi_2879_;
                                                    if (_e2086.member_3 != 4294967295u) {
                                                        if (_e1250 != _e602) {
                                                            if (_e2086.member < _e1184.member.member.member) {
                                                                phi_2905_ = true;
                                                            } else {
                                                                if (_e2086.member == _e1184.member.member.member) {
                                                                    phi_2904_ = (_e2086.member_3 < _e1184.member.member.member_3);
                                                                } else {
                                                                    phi_2904_ = false;
                                                                }
                                                                let _e2101 = phi_2904_;
                                                                phi_2905_ = _e2101;
                                                            }
                                                            let _e2103 = phi_2905_;
                                                            if _e2103 {
                                                                phi_2912_ = type_39(type_35(_e2086, _e2086.member), _e1211.member_1, _e1211.member_2);
                                                            } else {
                                                                phi_2912_ = _e1211;
                                                            }
                                                            let _e2110 = phi_2912_;
                                                            phi_2913_ = _e2110;
                                                        } else {
                                                            phi_2913_ = _e1211;
                                                        }
                                                        let _e2112 = phi_2913_;
                                                        phi_2914_ = _e2112;
                                                    } else {
                                                        phi_2914_ = _e1211;
                                                    }
                                                    let _e2114 = phi_2914_;
                                                    phi_1346_ = _e2114;
                                                } else {
                                                    phi_1346_ = type_39();
                                                }
                                                let _e2116 = phi_1346_;
                                                continue;
                                                continuing {
                                                    phi_1345_ = _e2116;
                                                    phi_1348_ = _e1199;
                                                    phi_4806_ = _e643;
                                                    break if !(_e1205);
                                                }
                                            }
                                            let _e2119 = phi_4806_;
                                            phi_5006_ = _e2119;
                                            if _e2119 {
                                                break;
                                            }
                                            let _e2121 = local_10;
                                            phi_5010_ = _e2119;
                                            let _e2470 = local_13;
                                            phi_4179_ = _e2470;
                                            phi_4180_ = false;
                                            phi_4181_ = _e687;
                                            phi_4182_ = select(_e689, 0u, (_e596 > _e2121.member.member_1));
                                        } else {
                                            if (_e687.member_1 >= _e97) {
                                                phi_3715_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e687.member_1 < _e97) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e701 = (_e278 * 2u);
                                                let _e703 = ((1u + _e701) % 7u);
                                                if (_e703 < 7u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e708 = global_6.member[_e687.member_1][_e703];
                                                let _e710 = ((_e701 + 2u) % 7u);
                                                if (_e710 < 7u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e715 = global_6.member[_e687.member_1][_e710];
                                                let _e716 = (_e277 * 2u);
                                                let _e718 = ((1u + _e716) % 7u);
                                                if (_e718 < 7u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e723 = global_6.member[_e687.member_1][_e718];
                                                let _e725 = ((_e716 + 2u) % 7u);
                                                if (_e725 < 7u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e730 = global_6.member[_e687.member_1][_e725];
                                                let _e731 = (_e279 * 2u);
                                                let _e733 = ((1u + _e731) % 7u);
                                                if (_e733 < 7u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e738 = global_6.member[_e687.member_1][_e733];
                                                let _e740 = ((_e731 + 2u) % 7u);
                                                if (_e740 < 7u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e745 = global_6.member[_e687.member_1][_e740];
                                                let _e768 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.x - _e687.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e769 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.y - _e687.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e770 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.z - _e687.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e772 = select(_e152, _e768, (_e768 > _e152));
                                                let _e774 = select(_e152, _e769, (_e769 > _e152));
                                                let _e776 = select(_e152, _e770, (_e770 > _e152));
                                                let _e807 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e708 & 2097151u))) - 8388608f) * _e772));
                                                let _e812 = (bitcast<i32>((_e708 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e815 = bitcast<f32>((_e807 & bitcast<u32>(_e812)));
                                                let _e816 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e723 & 2097151u))) - 8388608f) * _e774));
                                                let _e821 = (bitcast<i32>((_e723 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e824 = bitcast<f32>((_e816 & bitcast<u32>(_e821)));
                                                let _e825 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e738 & 2097151u))) - 8388608f) * _e776));
                                                let _e830 = (bitcast<i32>((_e738 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e833 = bitcast<f32>((_e825 & bitcast<u32>(_e830)));
                                                let _e837 = bitcast<f32>((_e807 & bitcast<u32>(~(_e812))));
                                                let _e841 = bitcast<f32>((_e816 & bitcast<u32>(~(_e821))));
                                                let _e845 = bitcast<f32>((_e825 & bitcast<u32>(~(_e830))));
                                                let _e846 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e715 & 2097151u))) - 8388608f) * _e772));
                                                let _e851 = (bitcast<i32>((_e715 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e854 = bitcast<f32>((_e846 & bitcast<u32>(_e851)));
                                                let _e855 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 2097151u))) - 8388608f) * _e774));
                                                let _e860 = (bitcast<i32>((_e730 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e863 = bitcast<f32>((_e855 & bitcast<u32>(_e860)));
                                                let _e864 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e745 & 2097151u))) - 8388608f) * _e776));
                                                let _e869 = (bitcast<i32>((_e745 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e872 = bitcast<f32>((_e864 & bitcast<u32>(_e869)));
                                                let _e876 = bitcast<f32>((_e846 & bitcast<u32>(~(_e851))));
                                                let _e880 = bitcast<f32>((_e855 & bitcast<u32>(~(_e860))));
                                                let _e884 = bitcast<f32>((_e864 & bitcast<u32>(~(_e869))));
                                                let _e885 = (_e687.member.member.x + _e815);
                                                let _e886 = (_e687.member.member.y + _e824);
                                                let _e887 = (_e687.member.member.z + _e833);
                                                let _e890 = (_e687.member.member_1.x - _e854);
                                                let _e891 = (_e687.member.member_1.y - _e863);
                                                let _e892 = (_e687.member.member_1.z - _e872);
                                                let _e911 = (_e890 - _e885);
                                                let _e912 = (_e891 - _e886);
                                                let _e913 = (_e892 - _e887);
                                                let _e915 = select(_e912, _e911, (_e911 > _e912));
                                                let _e917 = select(_e913, _e915, (_e915 > _e913));
                                                if (_e917 < (1024f * _e152)) {
                                                    phi_3416_ = 0u;
                                                } else {
                                                    phi_3416_ = select(2u, 1u, (_e917 < (2097152f * _e152)));
                                                }
                                                let _e924 = phi_3416_;
                                                switch bitcast<i32>(_e924) {
                                                    case 0: {
                                                        phi_3422_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3422_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3422_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3422_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e927 = phi_3422_;
                                                let _e933 = global_6.member[_e687.member_1][0u];
                                                let _e937 = global_6.member[_e687.member_1][2u];
                                                let _e941 = global_6.member[_e687.member_1][4u];
                                                let _e945 = global_6.member[_e687.member_1][6u];
                                                let _e957 = (((_e937 >> bitcast<u32>(22i)) | ((_e941 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e945 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e958 = (_e933 & 268435455u);
                                                let _e959 = (_e957 & 268435455u);
                                                let _e962 = ((_e933 >> bitcast<u32>(28u)) & 7u);
                                                let _e970 = ((_e933 >> bitcast<u32>(31i)) | (((_e957 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e971 = (_e962 != 0u);
                                                if (_e962 == 0u) {
                                                    phi_3677_ = _e958;
                                                } else {
                                                    if (_e962 == 7u) {
                                                        phi_3676_ = 2147483648u;
                                                    } else {
                                                        phi_3676_ = ((2147483648u | (_e962 << bitcast<u32>(28u))) | (_e959 & 268435455u));
                                                    }
                                                    let _e980 = phi_3676_;
                                                    phi_3677_ = _e980;
                                                }
                                                let _e982 = phi_3677_;
                                                if _e971 {
                                                    let _e983 = (_e962 != 7u);
                                                    if _e983 {
                                                        phi_3687_ = (_e959 + (_e962 * ((3u * _e927) + 1u)));
                                                    } else {
                                                        phi_3687_ = u32();
                                                    }
                                                    let _e987 = phi_3687_;
                                                    phi_3689_ = _e987;
                                                    phi_3690_ = select(true, false, _e983);
                                                } else {
                                                    phi_3689_ = u32();
                                                    phi_3690_ = true;
                                                }
                                                let _e990 = phi_3689_;
                                                let _e992 = phi_3690_;
                                                if (_e970 == 0u) {
                                                    phi_3711_ = (_e958 + select(0u, 1u, !(_e971)));
                                                } else {
                                                    if (_e970 == 7u) {
                                                        phi_3710_ = 2147483648u;
                                                    } else {
                                                        phi_3710_ = ((2147483648u | (_e970 << bitcast<u32>(28u))) | (select(_e990, _e959, _e992) & 268435455u));
                                                    }
                                                    let _e1005 = phi_3710_;
                                                    phi_3711_ = _e1005;
                                                }
                                                let _e1007 = phi_3711_;
                                                phi_3715_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e885, (_e687.member.member.x + _e837), _e890, (_e687.member.member_1.x - _e876)), vec4<f32>(_e886, (_e687.member.member.y + _e841), _e891, (_e687.member.member_1.y - _e880)), vec4<f32>(_e887, (_e687.member.member.z + _e845), _e892, (_e687.member.member_1.z - _e884))), type_50(type_30((_e687.member.member + vec4<f32>(_e815, _e824, _e833, 0f)), (_e687.member.member_1 - vec4<f32>(_e854, _e863, _e872, 0f))), _e982), type_50(type_30((_e687.member.member + vec4<f32>(_e837, _e841, _e845, 0f)), (_e687.member.member_1 - vec4<f32>(_e876, _e880, _e884, 0f))), _e1007));
                                            }
                                            let _e1012 = phi_3715_;
                                            let _e1031 = ((_e1012.member[0].x - _e363) * _e366);
                                            let _e1032 = ((_e1012.member[0].y - _e363) * _e366);
                                            let _e1033 = ((_e1012.member[0].z - _e364) * _e366);
                                            let _e1034 = ((_e1012.member[0].w - _e364) * _e366);
                                            let _e1044 = ((_e1012.member[1].x - _e427) * _e430);
                                            let _e1045 = ((_e1012.member[1].y - _e427) * _e430);
                                            let _e1046 = ((_e1012.member[1].z - _e428) * _e430);
                                            let _e1047 = ((_e1012.member[1].w - _e428) * _e430);
                                            let _e1057 = ((_e1012.member[2].x - _e491) * _e494);
                                            let _e1058 = ((_e1012.member[2].y - _e491) * _e494);
                                            let _e1059 = ((_e1012.member[2].z - _e492) * _e494);
                                            let _e1060 = ((_e1012.member[2].w - _e492) * _e494);
                                            let _e1062 = select(_e1059, _e1057, (_e1057 < _e1059));
                                            let _e1064 = select(_e1060, _e1058, (_e1058 < _e1060));
                                            let _e1066 = select(_e1059, _e1057, (_e1057 > _e1059));
                                            let _e1068 = select(_e1060, _e1058, (_e1058 > _e1060));
                                            let _e1070 = select(_e1033, _e1031, (_e1031 < _e1033));
                                            let _e1072 = select(_e1034, _e1032, (_e1032 < _e1034));
                                            let _e1074 = select(_e1046, _e1044, (_e1044 < _e1046));
                                            let _e1076 = select(_e1047, _e1045, (_e1045 < _e1047));
                                            let _e1078 = select(_e1074, _e1070, (_e1070 > _e1074));
                                            let _e1080 = select(_e1076, _e1072, (_e1072 > _e1076));
                                            let _e1082 = select(_e1062, _e1078, (_e1078 > _e1062));
                                            let _e1084 = select(_e1064, _e1080, (_e1080 > _e1064));
                                            let _e1086 = select(_e1033, _e1031, (_e1031 > _e1033));
                                            let _e1088 = select(_e1034, _e1032, (_e1032 > _e1034));
                                            let _e1090 = select(_e1046, _e1044, (_e1044 > _e1046));
                                            let _e1092 = select(_e1047, _e1045, (_e1045 > _e1047));
                                            let _e1094 = select(_e1090, _e1086, (_e1086 < _e1090));
                                            let _e1096 = select(_e1092, _e1088, (_e1088 < _e1092));
                                            let _e1101 = -(_e1062);
                                            let _e1102 = -(_e1064);
                                            let _e1109 = (select(_e1066, _e1094, (_e1094 < _e1066)) + (select(_e1101, _e1066, (_e1066 > _e1101)) * 0.0000019073523f));
                                            let _e1110 = (select(_e1068, _e1096, (_e1096 < _e1068)) + (select(_e1102, _e1068, (_e1068 > _e1102)) * 0.0000019073523f));
                                            let _e1112 = select(_e596, _e1082, (_e1082 > _e596));
                                            let _e1114 = select(_e596, _e1084, (_e1084 > _e596));
                                            let _e1119 = (_e1112 <= select(_e645.member.member_1, _e1109, (_e1109 < _e645.member.member_1)));
                                            let _e1120 = (_e1114 <= select(_e645.member.member_1, _e1110, (_e1110 < _e645.member.member_1)));
                                            let _e1121 = (_e1112 <= _e1114);
                                            if _e1119 {
                                                if _e1120 {
                                                    if _e1121 {
                                                        phi_4080_ = _e1012.member_2;
                                                    } else {
                                                        phi_4080_ = _e1012.member_1;
                                                    }
                                                    let _e1125 = phi_4080_;
                                                    let _e1146 = (_e689 % 128u);
                                                    let _e1147 = (_e1146 < 128u);
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1146] = _e1125.member_1;
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1146] = _e1125.member.member.x;
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1146] = _e1125.member.member.y;
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1146] = _e1125.member.member.z;
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1146] = _e1125.member.member_1.x;
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1146] = _e1125.member.member_1.y;
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1146] = _e1125.member.member_1.z;
                                                    if _e1147 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1146] = select(_e1112, _e1114, _e1121);
                                                    if _e1121 {
                                                        phi_4156_ = _e1012.member_1;
                                                    } else {
                                                        phi_4156_ = _e1012.member_2;
                                                    }
                                                    let _e1160 = phi_4156_;
                                                    phi_4157_ = _e1160;
                                                    phi_4158_ = (_e689 + 1u);
                                                } else {
                                                    phi_4157_ = type_50();
                                                    phi_4158_ = u32();
                                                }
                                                let _e1162 = phi_4157_;
                                                let _e1164 = phi_4158_;
                                                phi_4160_ = _e1162;
                                                phi_4161_ = _e1164;
                                                phi_4162_ = select(true, false, _e1120);
                                            } else {
                                                phi_4160_ = type_50();
                                                phi_4161_ = u32();
                                                phi_4162_ = true;
                                            }
                                            let _e1167 = phi_4160_;
                                            let _e1169 = phi_4161_;
                                            let _e1171 = phi_4162_;
                                            if _e1171 {
                                                if _e1119 {
                                                    phi_4171_ = _e1012.member_1;
                                                } else {
                                                    phi_4171_ = _e1012.member_2;
                                                }
                                                let _e1175 = phi_4171_;
                                                phi_4176_ = select(_e1120, true, _e1119);
                                                phi_4177_ = _e1175;
                                            } else {
                                                phi_4176_ = _e685;
                                                phi_4177_ = _e1167;
                                            }
                                            let _e1178 = phi_4176_;
                                            let _e1180 = phi_4177_;
                                            phi_5010_ = _e643;
                                            phi_4179_ = type_39(_e645.member, (_e645.member_1 + 1u), _e645.member_2);
                                            phi_4180_ = _e1178;
                                            phi_4181_ = _e1180;
                                            phi_4182_ = select(_e1169, _e689, _e1171);
                                        }
                                        let _e2127 = phi_5010_;
                                        let _e2129 = phi_4179_;
                                        let _e2131 = phi_4180_;
                                        let _e2133 = phi_4181_;
                                        let _e2135 = phi_4182_;
                                        phi_5009_ = _e2127;
                                        phi_4183_ = _e2129;
                                        phi_4184_ = _e2131;
                                        phi_4185_ = _e2133;
                                        phi_4186_ = _e2135;
                                        phi_4187_ = (_e653 - 1u);
                                    } else {
                                        phi_5009_ = _e643;
                                        phi_4183_ = _e645;
                                        phi_4184_ = _e685;
                                        phi_4185_ = _e687;
                                        phi_4186_ = _e689;
                                        phi_4187_ = _e653;
                                    }
                                    let _e2137 = phi_5009_;
                                    let _e2139 = phi_4183_;
                                    let _e2141 = phi_4184_;
                                    let _e2143 = phi_4185_;
                                    let _e2145 = phi_4186_;
                                    let _e2147 = phi_4187_;
                                    phi_5008_ = _e2137;
                                    phi_4188_ = _e2139;
                                    phi_4189_ = _e2141;
                                    phi_4190_ = _e2143;
                                    phi_4191_ = _e2145;
                                    phi_4192_ = _e2147;
                                } else {
                                    phi_5008_ = _e643;
                                    phi_4188_ = type_39();
                                    phi_4189_ = bool();
                                    phi_4190_ = type_50();
                                    phi_4191_ = u32();
                                    phi_4192_ = u32();
                                }
                                let _e2149 = phi_5008_;
                                let _e2151 = phi_4188_;
                                let _e2153 = phi_4189_;
                                let _e2155 = phi_4190_;
                                let _e2157 = phi_4191_;
                                let _e2159 = phi_4192_;
                                phi_5007_ = _e2149;
                                phi_1219_ = _e2151;
                                phi_1222_ = _e2153;
                                phi_1224_ = _e2155;
                                phi_1226_ = _e2157;
                                phi_1228_ = _e2159;
                                phi_4193_ = _e657;
                            } else {
                                phi_5007_ = _e643;
                                phi_1219_ = type_39();
                                phi_1222_ = bool();
                                phi_1224_ = type_50();
                                phi_1226_ = u32();
                                phi_1228_ = u32();
                                phi_4193_ = false;
                            }
                            let _e2161 = phi_5007_;
                            let _e2163 = phi_1219_;
                            let _e2165 = phi_1222_;
                            let _e2167 = phi_1224_;
                            let _e2169 = phi_1226_;
                            let _e2171 = phi_1228_;
                            let _e2173 = phi_4193_;
                            continue;
                            continuing {
                                phi_4812_ = _e2161;
                                phi_1218_ = _e2163;
                                phi_1221_ = _e2165;
                                phi_1223_ = _e2167;
                                phi_1225_ = _e2169;
                                phi_1227_ = _e2171;
                                phi_5006_ = _e2161;
                                break if !(_e2173);
                            }
                        }
                        let _e2176 = phi_5006_;
                        if _e2176 {
                            break;
                        }
                        let _e2178 = local_11;
                        if (_e2178.member.member.member_3 != 4294967295u) {
                            let _e2184 = bitcast<u32>(_e2178.member.member.member);
                            let _e2188 = (bitcast<i32>((_e2184 >> bitcast<u32>(23i))) & 255i);
                            let _e2189 = (_e2188 + _e280);
                            if (_e2188 == 255i) {
                                phi_4252_ = _e2178.member.member.member;
                            } else {
                                if (_e2188 > 0i) {
                                    if (_e2189 > 0i) {
                                        let _e2193 = (_e2189 < 255i);
                                        if _e2193 {
                                            phi_4231_ = bitcast<f32>((_e2184 + bitcast<u32>((_e280 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4231_ = f32();
                                        }
                                        let _e2200 = phi_4231_;
                                        phi_4233_ = _e2200;
                                        phi_4234_ = select(true, false, _e2193);
                                    } else {
                                        phi_4233_ = f32();
                                        phi_4234_ = true;
                                    }
                                    let _e2203 = phi_4233_;
                                    let _e2205 = phi_4234_;
                                    phi_4235_ = _e2203;
                                    phi_4236_ = _e2205;
                                } else {
                                    phi_4235_ = f32();
                                    phi_4236_ = true;
                                }
                                let _e2207 = phi_4235_;
                                let _e2209 = phi_4236_;
                                if _e2209 {
                                    let _e2210 = (_e2184 & 2147483648u);
                                    let _e2217 = ((_e2184 & 8388607u) | (select(0u, 1u, ((_e2184 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2221 = (_e2217 == 0u);
                                    if _e2221 {
                                        phi_4764_ = bitcast<f32>(_e2210);
                                    } else {
                                        let _e2226 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2217)), 32u, _e2221) - 8u);
                                        let _e2229 = (_e2217 << bitcast<u32>((_e2226 & 31u)));
                                        let _e2231 = ((_e2189 + select(0i, 1i, (_e2188 == 0i))) - bitcast<i32>(_e2226));
                                        if (_e2231 >= 255i) {
                                            phi_4754_ = bitcast<f32>((_e2210 | 2139095040u));
                                            phi_4755_ = f32();
                                            phi_4756_ = true;
                                        } else {
                                            let _e2233 = (_e2231 > 0i);
                                            if _e2233 {
                                                phi_4748_ = bitcast<f32>(((_e2210 | (bitcast<u32>(_e2231) << bitcast<u32>(23i))) | (_e2229 & 8388607u)));
                                                phi_4749_ = f32();
                                            } else {
                                                if (_e2231 < -24i) {
                                                    phi_4714_ = 26u;
                                                } else {
                                                    phi_4714_ = bitcast<u32>((1i - _e2231));
                                                }
                                                let _e2238 = phi_4714_;
                                                let _e2239 = (_e2238 & 31u);
                                                let _e2241 = (_e2229 >> bitcast<u32>(_e2239));
                                                let _e2245 = (_e2229 & ((1u << bitcast<u32>(_e2239)) - 1u));
                                                let _e2249 = (1u << bitcast<u32>(((_e2238 - 1u) & 31u)));
                                                if (_e2245 > _e2249) {
                                                    phi_4735_ = true;
                                                } else {
                                                    if (_e2245 == _e2249) {
                                                        phi_4732_ = ((_e2241 & 1u) == 1u);
                                                    } else {
                                                        phi_4732_ = false;
                                                    }
                                                    let _e2255 = phi_4732_;
                                                    phi_4735_ = _e2255;
                                                }
                                                let _e2257 = phi_4735_;
                                                phi_4748_ = f32();
                                                phi_4749_ = bitcast<f32>((_e2210 | (_e2241 + select(0u, 1u, _e2257))));
                                            }
                                            let _e2270 = phi_4748_;
                                            let _e2272 = phi_4749_;
                                            phi_4754_ = _e2270;
                                            phi_4755_ = _e2272;
                                            phi_4756_ = _e2233;
                                        }
                                        let _e2276 = phi_4754_;
                                        let _e2278 = phi_4755_;
                                        let _e2280 = phi_4756_;
                                        phi_4764_ = select(_e2278, _e2276, _e2280);
                                    }
                                    let _e2284 = phi_4764_;
                                    phi_4251_ = _e2284;
                                } else {
                                    phi_4251_ = _e2207;
                                }
                                let _e2286 = phi_4251_;
                                phi_4252_ = _e2286;
                            }
                            let _e2288 = phi_4252_;
                            let _e2289 = bitcast<u32>(_e2288);
                            if ((_e2289 & 2147483647u) >= 2139095040u) {
                                phi_4264_ = bitcast<f32>(((_e2289 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4264_ = _e2288;
                            }
                            let _e2296 = phi_4264_;
                            phi_4269_ = type_18(_e2296, _e2178.member.member.member_1, _e2178.member.member.member_2, _e2178.member.member.member_3);
                        } else {
                            phi_4269_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2301 = phi_4269_;
                        if _e156 {
                        } else {
                            break;
                        }
                        global_1.member[_e140] = _e2301;
                        let _e2305 = local_12;
                        if _e157 {
                        } else {
                            break;
                        }
                        global_4.member[_e140] = _e2305.member_1;
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e2310 = select(0u, 1u, (_e224 <= _e234));
                        if (_e2310 > 0u) {
                            let _e2312 = (1u < _e108);
                            if _e2312 {
                                if (0u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2316 = atomicAdd((&global_5.member[0u]), _e2310);
                                if ((_e2316 + _e2310) < _e2316) {
                                    if _e2312 {
                                    } else {
                                        break;
                                    }
                                    let _e2321 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2324 = select(0u, 1u, (_e2301.member_3 != 4294967295u));
                        if (_e2324 > 0u) {
                            let _e2326 = (3u < _e108);
                            if _e2326 {
                                if (2u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2330 = atomicAdd((&global_5.member[2u]), _e2324);
                                if ((_e2330 + _e2324) < _e2330) {
                                    if _e2326 {
                                    } else {
                                        break;
                                    }
                                    let _e2335 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2305.member_1 > 0u) {
                            let _e2337 = (5u < _e108);
                            if _e2337 {
                                if (4u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2341 = atomicAdd((&global_5.member[4u]), _e2305.member_1);
                                if ((_e2341 + _e2305.member_1) < _e2341) {
                                    if _e2337 {
                                    } else {
                                        break;
                                    }
                                    let _e2346 = atomicAdd((&global_5.member[5u]), 1u);
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
