struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_38 {
    member: type_23,
    member_1: f32,
}

struct type_41 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_52 {
    member: type_50,
    member_1: u32,
}

struct type_57 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_43;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_57;
@group(0) @binding(1) 
var<storage> global_7: type_47;

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
    var phi_435_: i32;
    var phi_436_: i32;
    var phi_446_: bool;
    var phi_456_: u32;
    var phi_457_: u32;
    var phi_459_: bool;
    var phi_464_: u32;
    var phi_497_: i32;
    var phi_515_: f32;
    var phi_521_: f32;
    var phi_561_: f32;
    var phi_567_: f32;
    var phi_619_: f32;
    var phi_631_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_686_: f32;
    var phi_692_: f32;
    var phi_744_: f32;
    var phi_756_: f32;
    var phi_765_: f32;
    var phi_771_: f32;
    var phi_811_: f32;
    var phi_817_: f32;
    var phi_869_: f32;
    var phi_881_: f32;
    var phi_936_: i32;
    var phi_958_: u32;
    var phi_959_: u32;
    var phi_996_: i32;
    var phi_1018_: u32;
    var phi_1019_: u32;
    var phi_1027_: f32;
    var phi_1028_: f32;
    var phi_3668_: bool;
    var phi_1120_: type_41;
    var phi_1123_: bool;
    var phi_1125_: u32;
    var phi_1127_: u32;
    var phi_1129_: type_52;
    var phi_1140_: bool;
    var phi_1226_: bool;
    var phi_1227_: u32;
    var phi_1228_: type_52;
    var phi_2348_: type_45;
    var phi_3237_: type_52;
    var phi_3314_: type_52;
    var phi_3315_: u32;
    var phi_3316_: type_52;
    var phi_3318_: u32;
    var phi_3319_: type_52;
    var phi_3320_: bool;
    var phi_3327_: type_52;
    var phi_3332_: bool;
    var phi_3334_: type_52;
    var phi_1246_: type_41;
    var phi_1249_: type_7;
    var phi_1250_: type_7;
    var phi_1272_: type_7;
    var phi_1296_: u32;
    var phi_1388_: array<array<f32, 3>, 3>;
    var phi_1540_: bool;
    var phi_1569_: bool;
    var phi_1988_: f32;
    var phi_1989_: f32;
    var phi_1990_: f32;
    var phi_1991_: f32;
    var phi_1992_: vec3<f32>;
    var phi_1993_: vec3<f32>;
    var phi_1994_: vec3<f32>;
    var phi_1995_: vec3<f32>;
    var phi_2032_: bool;
    var phi_2041_: vec3<f32>;
    var phi_2206_: f32;
    var phi_2208_: f32;
    var phi_2209_: bool;
    var phi_2229_: f32;
    var phi_2230_: f32;
    var phi_2253_: type_23;
    var phi_2255_: type_23;
    var phi_2256_: bool;
    var phi_2260_: type_23;
    var phi_2261_: type_23;
    var phi_2262_: type_23;
    var phi_2263_: bool;
    var phi_2267_: type_23;
    var phi_2268_: bool;
    var phi_2269_: type_23;
    var phi_2270_: bool;
    var phi_2271_: bool;
    var phi_2272_: type_23;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var phi_2282_: type_23;
    var phi_2283_: bool;
    var phi_2287_: type_23;
    var phi_2312_: bool;
    var phi_2313_: bool;
    var phi_2320_: type_41;
    var phi_2321_: type_41;
    var phi_2322_: type_41;
    var phi_1247_: type_41;
    var phi_3662_: bool;
    var phi_3826_: bool;
    var phi_3339_: type_41;
    var phi_3340_: bool;
    var phi_3341_: u32;
    var phi_3342_: type_52;
    var phi_3825_: bool;
    var phi_3343_: type_41;
    var phi_3344_: bool;
    var phi_3345_: u32;
    var phi_3346_: u32;
    var phi_3347_: type_52;
    var phi_3824_: bool;
    var phi_3348_: type_41;
    var phi_3349_: bool;
    var phi_3350_: u32;
    var phi_3351_: u32;
    var phi_3352_: type_52;
    var phi_3823_: bool;
    var phi_1121_: type_41;
    var phi_1124_: bool;
    var phi_1126_: u32;
    var phi_1128_: u32;
    var phi_1130_: type_52;
    var phi_3353_: bool;
    var phi_3822_: bool;
    var local_10: type_41;
    var phi_3391_: f32;
    var phi_3393_: f32;
    var phi_3394_: bool;
    var phi_3395_: f32;
    var phi_3396_: bool;
    var phi_3582_: u32;
    var phi_3600_: bool;
    var phi_3603_: bool;
    var phi_3616_: f32;
    var phi_3617_: f32;
    var phi_3622_: f32;
    var phi_3623_: f32;
    var phi_3624_: bool;
    var phi_3632_: f32;
    var phi_3411_: f32;
    var phi_3412_: f32;
    var phi_3424_: f32;
    var phi_3429_: type_23;
    var local_11: type_41;
    var local_12: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_7.member));
            let _e92 = arrayLength((&global_1.member));
            let _e100 = arrayLength((&global_6.member));
            let _e104 = global_3.member[0u][0u];
            let _e108 = global_3.member[0u][1u];
            let _e112 = global_3.member[0u][2u];
            let _e116 = global_3.member[1u][0u];
            let _e120 = global_3.member[1u][1u];
            let _e124 = global_3.member[1u][2u];
            let _e128 = global_3.member[1u][3u];
            let _e132 = (_e87.x + (_e87.y * 2097152u));
            let _e139 = (_e132 < arrayLength((&global_4.member)));
            if _e139 {
                let _e140 = (_e132 < arrayLength((&global_2.member)));
                if _e140 {
                    let _e141 = (_e132 < arrayLength((&global_5.member)));
                    if _e141 {
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e151 = global_4.member[_e132].member.member_2[0u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_4.member[_e132].member.member_2[1u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_4.member[_e132].member.member_2[2u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_4.member[_e132].member.member[0u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_4.member[_e132].member.member[1u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_4.member[_e132].member.member[2u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e195 = select(_e161, _e153, (_e161 < _e153));
                        let _e197 = select(_e169, _e195, (_e169 < _e195));
                        let _e199 = select(_e177, _e197, (_e177 < _e197));
                        let _e201 = select(_e185, _e199, (_e185 < _e199));
                        let _e203 = select(_e193, _e201, (_e193 < _e201));
                        let _e208 = global_4.member[_e132].member.member_1;
                        let _e209 = bitcast<u32>(_e208);
                        let _e210 = (_e209 & 2147483647u);
                        let _e218 = global_4.member[_e132].member.member_3;
                        let _e219 = bitcast<u32>(_e218);
                        let _e220 = (_e219 & 2147483647u);
                        let _e224 = (((select(_e210, _e203, (_e210 < _e203)) < 2139095040u) && (_e220 <= 2139095040u)) && (_e197 > 0u));
                        if _e224 {
                            let _e227 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                            if (_e227 >= 8388608u) {
                                phi_435_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_435_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            }
                            let _e241 = phi_435_;
                            phi_436_ = _e241;
                        } else {
                            phi_436_ = 0i;
                        }
                        let _e243 = phi_436_;
                        let _e244 = (_e153 == _e197);
                        if _e244 {
                            phi_446_ = true;
                        } else {
                            phi_446_ = (_e161 == _e197);
                        }
                        let _e247 = phi_446_;
                        let _e248 = select(1u, 0u, _e244);
                        if _e247 {
                            let _e249 = (_e248 + 1u);
                            phi_456_ = _e249;
                            phi_457_ = _e249;
                            phi_459_ = select(true, false, (_e249 == 2u));
                        } else {
                            phi_456_ = u32();
                            phi_457_ = 0u;
                            phi_459_ = true;
                        }
                        let _e253 = phi_456_;
                        let _e255 = phi_457_;
                        let _e257 = phi_459_;
                        if _e257 {
                            phi_464_ = (_e255 + 1u);
                        } else {
                            phi_464_ = 0u;
                        }
                        let _e261 = phi_464_;
                        let _e262 = select(_e253, _e255, _e257);
                        let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                        let _e264 = -(_e243);
                        if (_e264 < -126i) {
                            phi_497_ = -126i;
                        } else {
                            phi_497_ = select(_e264, 127i, (_e264 > 127i));
                        }
                        let _e269 = phi_497_;
                        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                        let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                        let _e285 = global_4.member[_e132].member.member;
                        let _e286 = (_e262 == 0u);
                        if _e286 {
                            phi_515_ = _e285[0];
                        } else {
                            phi_515_ = _e285[1];
                        }
                        let _e290 = phi_515_;
                        let _e291 = (_e262 == 2u);
                        if _e291 {
                            phi_521_ = _e285[2];
                        } else {
                            phi_521_ = _e290;
                        }
                        let _e294 = phi_521_;
                        let _e295 = bitcast<u32>(_e294);
                        let _e297 = ((_e295 & 2139095040u) != 0u);
                        let _e309 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e294, _e297) * select(0.00000011920929f, 1f, _e297));
                        let _e310 = global_4.member[_e132].member.member_2;
                        if _e286 {
                            phi_561_ = _e310[0];
                        } else {
                            phi_561_ = _e310[1];
                        }
                        let _e314 = phi_561_;
                        if _e291 {
                            phi_567_ = _e310[2];
                        } else {
                            phi_567_ = _e314;
                        }
                        let _e317 = phi_567_;
                        let _e318 = bitcast<u32>(_e317);
                        let _e320 = ((_e318 & 2139095040u) != 0u);
                        let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e274) * select(0.00000011920929f, 1f, _e320)) * _e280);
                        let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e338 {
                            let _e342 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                            phi_619_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                        } else {
                            phi_619_ = 0f;
                        }
                        let _e346 = phi_619_;
                        let _e347 = (_e309 + _e346);
                        let _e348 = (_e309 - _e346);
                        let _e349 = select(_e334, 0f, _e338);
                        if _e338 {
                            phi_631_ = 38685626000000000000000000f;
                        } else {
                            phi_631_ = (1f / _e334);
                        }
                        let _e352 = phi_631_;
                        let _e353 = (_e261 == 0u);
                        if _e353 {
                            phi_640_ = _e285[0];
                        } else {
                            phi_640_ = _e285[1];
                        }
                        let _e357 = phi_640_;
                        let _e358 = (_e261 == 2u);
                        if _e358 {
                            phi_646_ = _e285[2];
                        } else {
                            phi_646_ = _e357;
                        }
                        let _e361 = phi_646_;
                        let _e362 = bitcast<u32>(_e361);
                        let _e364 = ((_e362 & 2139095040u) != 0u);
                        let _e376 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * select(0.00000011920929f, 1f, _e364));
                        if _e353 {
                            phi_686_ = _e310[0];
                        } else {
                            phi_686_ = _e310[1];
                        }
                        let _e380 = phi_686_;
                        if _e358 {
                            phi_692_ = _e310[2];
                        } else {
                            phi_692_ = _e380;
                        }
                        let _e383 = phi_692_;
                        let _e384 = bitcast<u32>(_e383);
                        let _e386 = ((_e384 & 2139095040u) != 0u);
                        let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e274) * select(0.00000011920929f, 1f, _e386)) * _e280);
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e404 {
                            let _e408 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                            phi_744_ = select(0.00000000000011368684f, _e408, (_e408 > 0.00000000000011368684f));
                        } else {
                            phi_744_ = 0f;
                        }
                        let _e412 = phi_744_;
                        let _e413 = (_e376 + _e412);
                        let _e414 = (_e376 - _e412);
                        let _e415 = select(_e400, 0f, _e404);
                        if _e404 {
                            phi_756_ = 38685626000000000000000000f;
                        } else {
                            phi_756_ = (1f / _e400);
                        }
                        let _e418 = phi_756_;
                        let _e419 = (_e263 == 0u);
                        if _e419 {
                            phi_765_ = _e285[0];
                        } else {
                            phi_765_ = _e285[1];
                        }
                        let _e423 = phi_765_;
                        let _e424 = (_e263 == 2u);
                        if _e424 {
                            phi_771_ = _e285[2];
                        } else {
                            phi_771_ = _e423;
                        }
                        let _e427 = phi_771_;
                        let _e428 = bitcast<u32>(_e427);
                        let _e430 = ((_e428 & 2139095040u) != 0u);
                        let _e442 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e428 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e428 & 2147483648u))), _e427, _e430) * select(0.00000011920929f, 1f, _e430));
                        if _e419 {
                            phi_811_ = _e310[0];
                        } else {
                            phi_811_ = _e310[1];
                        }
                        let _e446 = phi_811_;
                        if _e424 {
                            phi_817_ = _e310[2];
                        } else {
                            phi_817_ = _e446;
                        }
                        let _e449 = phi_817_;
                        let _e450 = bitcast<u32>(_e449);
                        let _e452 = ((_e450 & 2139095040u) != 0u);
                        let _e466 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e450 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e450 & 2147483648u))), _e449, _e452) * _e274) * select(0.00000011920929f, 1f, _e452)) * _e280);
                        let _e470 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e470 {
                            let _e474 = (bitcast<f32>((bitcast<u32>(_e442) & 2147483647u)) * 0.00000011920929f);
                            phi_869_ = select(0.00000000000011368684f, _e474, (_e474 > 0.00000000000011368684f));
                        } else {
                            phi_869_ = 0f;
                        }
                        let _e478 = phi_869_;
                        let _e479 = (_e442 + _e478);
                        let _e480 = (_e442 - _e478);
                        let _e481 = select(_e466, 0f, _e470);
                        if _e470 {
                            phi_881_ = 38685626000000000000000000f;
                        } else {
                            phi_881_ = (1f / _e466);
                        }
                        let _e484 = phi_881_;
                        let _e487 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                        let _e490 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                        let _e492 = select(_e490, _e487, (_e487 > _e490));
                        let _e495 = bitcast<f32>((bitcast<u32>(_e442) & 2147483647u));
                        if (_e224 && (select(_e495, _e492, (_e492 > _e495)) <= 1099511600000f)) {
                            let _e507 = ((_e210 & 8388607u) | (select(0u, 1u, ((_e210 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e510 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
                            let _e514 = (_e507 == 0u);
                            let _e517 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e507)), 32u, _e514)) - 8i);
                            if (_e510 == 255i) {
                                phi_936_ = 255i;
                            } else {
                                phi_936_ = (((_e510 + select(0i, 1i, (_e510 == 0i))) - _e517) + _e243);
                            }
                            let _e525 = phi_936_;
                            let _e535 = (_e525 <= 0i);
                            if _e535 {
                                phi_959_ = u32();
                            } else {
                                if _e514 {
                                    phi_958_ = u32();
                                } else {
                                    phi_958_ = select(((bitcast<u32>(_e525) << bitcast<u32>(23i)) | ((_e507 << bitcast<u32>(((_e517 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e525 >= 255i));
                                }
                                let _e539 = phi_958_;
                                phi_959_ = _e539;
                            }
                            let _e541 = phi_959_;
                            let _e553 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e556 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                            let _e560 = (_e553 == 0u);
                            let _e563 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e553)), 32u, _e560)) - 8i);
                            if (_e556 == 255i) {
                                phi_996_ = 255i;
                            } else {
                                phi_996_ = (((_e556 + select(0i, 1i, (_e556 == 0i))) - _e563) + _e243);
                            }
                            let _e571 = phi_996_;
                            let _e581 = (_e571 <= 0i);
                            if _e581 {
                                phi_1019_ = u32();
                            } else {
                                if _e560 {
                                    phi_1018_ = u32();
                                } else {
                                    phi_1018_ = select(((bitcast<u32>(_e571) << bitcast<u32>(23i)) | ((_e553 << bitcast<u32>(((_e563 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e571 >= 255i));
                                }
                                let _e585 = phi_1018_;
                                phi_1019_ = _e585;
                            }
                            let _e587 = phi_1019_;
                            phi_1027_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e587, 0u, select(_e560, true, _e581))));
                            phi_1028_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e541, 0u, select(_e514, true, _e535))));
                        } else {
                            phi_1027_ = 0f;
                            phi_1028_ = 1f;
                        }
                        let _e593 = phi_1027_;
                        let _e595 = phi_1028_;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e601 = global_4.member[_e132].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                        let _e605 = (_e262 % 3u);
                        let _e606 = (_e605 < 3u);
                        if _e606 {
                        } else {
                            break;
                        }
                        let _e608 = local_9[_e605];
                        let _e609 = (_e261 % 3u);
                        let _e610 = (_e609 < 3u);
                        if _e610 {
                        } else {
                            break;
                        }
                        let _e612 = local_9[_e609];
                        let _e613 = (_e263 % 3u);
                        let _e614 = (_e613 < 3u);
                        if _e614 {
                        } else {
                            break;
                        }
                        let _e616 = local_9[_e613];
                        local_8 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                        if _e606 {
                        } else {
                            break;
                        }
                        let _e620 = local_8[_e605];
                        if _e610 {
                        } else {
                            break;
                        }
                        let _e622 = local_8[_e609];
                        if _e614 {
                        } else {
                            break;
                        }
                        let _e624 = local_8[_e613];
                        phi_3668_ = false;
                        phi_1120_ = type_41(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e593), 0u, 0u);
                        phi_1123_ = (_e595 <= _e593);
                        phi_1125_ = ((3u * _e90) + 1u);
                        phi_1127_ = 0u;
                        phi_1129_ = type_52(type_50(array<f32, 3>(_e608, _e612, _e616), array<f32, 3>(_e620, _e622, _e624)), select(0u, 2147483648u, (_e90 == 0u)));
                        loop {
                            let _e632 = phi_3668_;
                            let _e634 = phi_1120_;
                            let _e636 = phi_1123_;
                            let _e638 = phi_1125_;
                            let _e640 = phi_1127_;
                            let _e642 = phi_1129_;
                            local_10 = _e634;
                            local_11 = _e634;
                            if _e636 {
                                phi_1140_ = true;
                            } else {
                                phi_1140_ = (_e640 > 0u);
                            }
                            let _e645 = phi_1140_;
                            if _e645 {
                                let _e646 = (_e638 > 0u);
                                if _e646 {
                                    if _e636 {
                                        phi_1226_ = _e636;
                                        phi_1227_ = _e640;
                                        phi_1228_ = _e642;
                                    } else {
                                        let _e647 = (_e640 - 1u);
                                        let _e648 = (_e647 % 128u);
                                        let _e649 = (_e648 < 128u);
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e651 = local_6[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e653 = local_5[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e655 = local_4[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e657 = local_3[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e660 = local_2[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e662 = local_1[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e664 = local[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3822_ = true;
                                            break;
                                        }
                                        let _e669 = local_7[_e648];
                                        phi_1226_ = (_e669 <= _e634.member.member_1);
                                        phi_1227_ = _e647;
                                        phi_1228_ = type_52(type_50(array<f32, 3>(_e653, _e655, _e657), array<f32, 3>(_e660, _e662, _e664)), _e651);
                                    }
                                    let _e674 = phi_1226_;
                                    let _e676 = phi_1227_;
                                    let _e678 = phi_1228_;
                                    if _e674 {
                                        if ((_e678.member_1 & 2147483648u) != 0u) {
                                            phi_1246_ = _e634;
                                            phi_1249_ = type_7(0u, ((_e678.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1061 = phi_1246_;
                                                let _e1063 = phi_1249_;
                                                local_12 = _e1061;
                                                if (_e1063.member < _e1063.member_1) {
                                                    phi_1250_ = type_7((_e1063.member + 1u), _e1063.member_1);
                                                    phi_1272_ = type_7(1u, _e1063.member);
                                                } else {
                                                    phi_1250_ = _e1063;
                                                    phi_1272_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1076 = phi_1250_;
                                                let _e1078 = phi_1272_;
                                                let _e1082 = (bitcast<i32>(_e1078.member) != 0i);
                                                if _e1082 {
                                                    let _e1088 = type_41(_e1061.member, _e1061.member_1, (_e1061.member_2 + 1u));
                                                    let _e1089 = ((_e678.member_1 & 268435455u) + _e1078.member_1);
                                                    let _e1090 = (_e1089 < _e92);
                                                    if _e1090 {
                                                        if _e1090 {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1094 = global_1.member[_e1089].member_1;
                                                        phi_1296_ = _e1094;
                                                    } else {
                                                        phi_1296_ = 4294967295u;
                                                    }
                                                    let _e1096 = phi_1296_;
                                                    if (_e1089 >= _e92) {
                                                        phi_1388_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1090 {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        if (_e605 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1103 = global_1.member[_e1089].member[_e605];
                                                        if (_e609 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1109 = global_1.member[_e1089].member[_e609];
                                                        if (_e613 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1115 = global_1.member[_e1089].member[_e613];
                                                        let _e1117 = (3u + _e605);
                                                        if (_e1117 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1123 = global_1.member[_e1089].member[_e1117];
                                                        let _e1124 = (3u + _e609);
                                                        if (_e1124 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1130 = global_1.member[_e1089].member[_e1124];
                                                        let _e1131 = (3u + _e613);
                                                        if (_e1131 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1137 = global_1.member[_e1089].member[_e1131];
                                                        let _e1139 = (6u + _e605);
                                                        if (_e1139 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1145 = global_1.member[_e1089].member[_e1139];
                                                        let _e1146 = (6u + _e609);
                                                        if (_e1146 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1152 = global_1.member[_e1089].member[_e1146];
                                                        let _e1153 = (6u + _e613);
                                                        if (_e1153 < 9u) {
                                                        } else {
                                                            phi_3662_ = true;
                                                            break;
                                                        }
                                                        let _e1159 = global_1.member[_e1089].member[_e1153];
                                                        phi_1388_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1103, _e1109, _e1115), array<f32, 3>(_e1123, _e1130, _e1137), array<f32, 3>(_e1145, _e1152, _e1159));
                                                    }
                                                    let _e1163 = phi_1388_;
                                                    let _e1172 = (_e1163[0][2] - _e442);
                                                    let _e1175 = (((_e1163[0][0] - _e309) * _e481) - (_e1172 * _e349));
                                                    let _e1178 = (((_e1163[0][1] - _e376) * _e481) - (_e1172 * _e415));
                                                    let _e1185 = (_e1163[1][2] - _e442);
                                                    let _e1188 = (((_e1163[1][0] - _e309) * _e481) - (_e1185 * _e349));
                                                    let _e1191 = (((_e1163[1][1] - _e376) * _e481) - (_e1185 * _e415));
                                                    let _e1198 = (_e1163[2][2] - _e442);
                                                    let _e1201 = (((_e1163[2][0] - _e309) * _e481) - (_e1198 * _e349));
                                                    let _e1204 = (((_e1163[2][1] - _e376) * _e481) - (_e1198 * _e415));
                                                    let _e1205 = (_e1201 * _e1191);
                                                    let _e1206 = (_e1204 * _e1188);
                                                    let _e1207 = (_e1175 * _e1204);
                                                    let _e1208 = (_e1178 * _e1201);
                                                    let _e1209 = (_e1188 * _e1178);
                                                    let _e1210 = (_e1191 * _e1175);
                                                    let _e1215 = (((_e1205 >= _e1206) && (_e1207 >= _e1208)) && (_e1209 >= _e1210));
                                                    if (_e1215 || (((_e1205 <= _e1206) && (_e1207 <= _e1208)) && (_e1209 <= _e1210))) {
                                                        let _e1222 = select(-1f, 1f, _e1215);
                                                        let _e1224 = ((_e1205 - _e1206) * _e1222);
                                                        let _e1226 = select(0f, _e1224, (_e1224 > 0f));
                                                        let _e1228 = ((_e1207 - _e1208) * _e1222);
                                                        let _e1230 = select(0f, _e1228, (_e1228 > 0f));
                                                        let _e1232 = ((_e1209 - _e1210) * _e1222);
                                                        let _e1234 = select(0f, _e1232, (_e1232 > 0f));
                                                        let _e1236 = ((_e1226 + _e1230) + _e1234);
                                                        if (_e1236 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2272_ = type_23();
                                                            phi_2273_ = true;
                                                            phi_2274_ = false;
                                                        } else {
                                                            let _e1239 = select(_e1188, _e1175, (_e1175 < _e1188));
                                                            if (select(_e1201, _e1239, (_e1239 < _e1201)) > 0f) {
                                                                phi_1540_ = true;
                                                            } else {
                                                                let _e1244 = select(_e1188, _e1175, (_e1175 > _e1188));
                                                                phi_1540_ = (select(_e1201, _e1244, (_e1244 > _e1201)) < 0f);
                                                            }
                                                            let _e1249 = phi_1540_;
                                                            if _e1249 {
                                                                phi_2269_ = type_23();
                                                                phi_2270_ = true;
                                                                phi_2271_ = false;
                                                            } else {
                                                                let _e1251 = select(_e1191, _e1178, (_e1178 < _e1191));
                                                                if (select(_e1204, _e1251, (_e1251 < _e1204)) > 0f) {
                                                                    phi_1569_ = true;
                                                                } else {
                                                                    let _e1256 = select(_e1191, _e1178, (_e1178 > _e1191));
                                                                    phi_1569_ = (select(_e1204, _e1256, (_e1256 > _e1204)) < 0f);
                                                                }
                                                                let _e1261 = phi_1569_;
                                                                if _e1261 {
                                                                    phi_2267_ = type_23();
                                                                    phi_2268_ = false;
                                                                } else {
                                                                    let _e1263 = select(_e1163[1][0], _e1163[0][0], (_e1163[0][0] < _e1163[1][0]));
                                                                    let _e1267 = select(_e1163[1][0], _e1163[0][0], (_e1163[0][0] > _e1163[1][0]));
                                                                    let _e1271 = select(_e1163[1][1], _e1163[0][1], (_e1163[0][1] < _e1163[1][1]));
                                                                    let _e1275 = select(_e1163[1][1], _e1163[0][1], (_e1163[0][1] > _e1163[1][1]));
                                                                    let _e1279 = select(_e1163[1][2], _e1163[0][2], (_e1163[0][2] < _e1163[1][2]));
                                                                    let _e1283 = select(_e1163[1][2], _e1163[0][2], (_e1163[0][2] > _e1163[1][2]));
                                                                    let _e1288 = ((select(_e1163[2][0], _e1263, (_e1263 < _e1163[2][0])) - _e347) * _e352);
                                                                    let _e1289 = ((select(_e1163[2][0], _e1267, (_e1267 > _e1163[2][0])) - _e348) * _e352);
                                                                    let _e1292 = ((select(_e1163[2][1], _e1271, (_e1271 < _e1163[2][1])) - _e413) * _e418);
                                                                    let _e1293 = ((select(_e1163[2][1], _e1275, (_e1275 > _e1163[2][1])) - _e414) * _e418);
                                                                    let _e1296 = ((select(_e1163[2][2], _e1279, (_e1279 < _e1163[2][2])) - _e479) * _e484);
                                                                    let _e1297 = ((select(_e1163[2][2], _e1283, (_e1283 > _e1163[2][2])) - _e480) * _e484);
                                                                    let _e1299 = select(_e1297, _e1296, (_e1296 < _e1297));
                                                                    let _e1301 = select(_e1297, _e1296, (_e1296 > _e1297));
                                                                    let _e1303 = select(_e1289, _e1288, (_e1288 < _e1289));
                                                                    let _e1305 = select(_e1293, _e1292, (_e1292 < _e1293));
                                                                    let _e1307 = select(_e1305, _e1303, (_e1303 > _e1305));
                                                                    let _e1309 = select(_e1299, _e1307, (_e1307 > _e1299));
                                                                    let _e1311 = select(_e1289, _e1288, (_e1288 > _e1289));
                                                                    let _e1313 = select(_e1293, _e1292, (_e1292 > _e1293));
                                                                    let _e1315 = select(_e1313, _e1311, (_e1311 < _e1313));
                                                                    let _e1317 = select(_e1301, _e1315, (_e1315 < _e1301));
                                                                    let _e1318 = -(_e1299);
                                                                    let _e1324 = select(_e595, _e1309, (_e1309 > _e595));
                                                                    if (_e1324 > (_e1317 + (select(_e1318, _e1301, (_e1301 > _e1318)) * 0.0000019073523f))) {
                                                                        phi_2262_ = type_23();
                                                                        phi_2263_ = true;
                                                                    } else {
                                                                        let _e1326 = (_e1324 > _e1061.member.member_1);
                                                                        if _e1326 {
                                                                            phi_2261_ = type_23();
                                                                        } else {
                                                                            let _e1327 = vec3<f32>(_e1163[0][0], _e1163[0][1], _e1163[0][2]);
                                                                            let _e1328 = vec3<f32>(_e1163[1][0], _e1163[1][1], _e1163[1][2]);
                                                                            let _e1329 = vec3<f32>(_e1163[2][0], _e1163[2][1], _e1163[2][2]);
                                                                            let _e1330 = (_e1163[1][0] - _e1163[0][0]);
                                                                            let _e1331 = (_e1163[1][1] - _e1163[0][1]);
                                                                            let _e1332 = (_e1163[1][2] - _e1163[0][2]);
                                                                            let _e1333 = vec3<f32>(_e1330, _e1331, _e1332);
                                                                            let _e1334 = (_e1163[2][0] - _e1163[1][0]);
                                                                            let _e1335 = (_e1163[2][1] - _e1163[1][1]);
                                                                            let _e1336 = (_e1163[2][2] - _e1163[1][2]);
                                                                            let _e1337 = vec3<f32>(_e1334, _e1335, _e1336);
                                                                            let _e1338 = (_e1163[0][0] - _e1163[2][0]);
                                                                            let _e1339 = (_e1163[0][1] - _e1163[2][1]);
                                                                            let _e1340 = (_e1163[0][2] - _e1163[2][2]);
                                                                            let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                                            let _e1344 = bitcast<f32>((bitcast<u32>(_e1330) & 2147483647u));
                                                                            let _e1347 = bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u));
                                                                            let _e1349 = select(_e1347, _e1344, (_e1344 > _e1347));
                                                                            let _e1352 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                                            let _e1354 = select(_e1352, _e1349, (_e1349 > _e1352));
                                                                            let _e1357 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                                            let _e1360 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                            let _e1362 = select(_e1360, _e1357, (_e1357 > _e1360));
                                                                            let _e1365 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                            let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
                                                                            let _e1370 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                            let _e1373 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                            let _e1375 = select(_e1373, _e1370, (_e1370 > _e1373));
                                                                            let _e1378 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                            let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                                                            let _e1382 = select(_e1367, _e1354, (_e1354 > _e1367));
                                                                            let _e1384 = select(_e1380, _e1382, (_e1382 > _e1380));
                                                                            if (_e1354 == _e1384) {
                                                                                phi_1988_ = _e1191;
                                                                                phi_1989_ = _e1188;
                                                                                phi_1990_ = _e1178;
                                                                                phi_1991_ = _e1175;
                                                                                phi_1992_ = _e1327;
                                                                                phi_1993_ = _e1341;
                                                                                phi_1994_ = _e1337;
                                                                                phi_1995_ = _e1333;
                                                                            } else {
                                                                                let _e1386 = (_e1367 == _e1384);
                                                                                let _e1391 = vec3(_e1386);
                                                                                phi_1988_ = select(_e1178, _e1204, _e1386);
                                                                                phi_1989_ = select(_e1175, _e1201, _e1386);
                                                                                phi_1990_ = select(_e1204, _e1191, _e1386);
                                                                                phi_1991_ = select(_e1201, _e1188, _e1386);
                                                                                phi_1992_ = select(_e1329, _e1328, _e1391);
                                                                                phi_1993_ = select(_e1337, _e1333, _e1391);
                                                                                phi_1994_ = select(_e1333, _e1341, _e1391);
                                                                                phi_1995_ = select(_e1341, _e1337, _e1391);
                                                                            }
                                                                            let _e1397 = phi_1988_;
                                                                            let _e1399 = phi_1989_;
                                                                            let _e1401 = phi_1990_;
                                                                            let _e1403 = phi_1991_;
                                                                            let _e1405 = phi_1992_;
                                                                            let _e1407 = phi_1993_;
                                                                            let _e1409 = phi_1994_;
                                                                            let _e1411 = phi_1995_;
                                                                            let _e1418 = ((_e1409.y * _e1407.z) - (_e1407.y * _e1409.z));
                                                                            let _e1423 = ((_e1409.z * _e1407.x) - (_e1407.z * _e1409.x));
                                                                            let _e1426 = ((_e1409.x * _e1407.y) - (_e1407.x * _e1409.y));
                                                                            if (_e1226 >= _e1230) {
                                                                                phi_2032_ = select(true, false, (_e1226 >= _e1234));
                                                                            } else {
                                                                                phi_2032_ = true;
                                                                            }
                                                                            let _e1431 = phi_2032_;
                                                                            if _e1431 {
                                                                                phi_2041_ = select(_e1329, _e1328, vec3((_e1230 >= _e1234)));
                                                                            } else {
                                                                                phi_2041_ = _e1327;
                                                                            }
                                                                            let _e1436 = phi_2041_;
                                                                            let _e1447 = (((_e1418 * (_e1436.x - _e309)) + (_e1423 * (_e1436.y - _e376))) + (_e1426 * (_e1436.z - _e442)));
                                                                            let _e1452 = (((_e1418 * _e349) + (_e1423 * _e415)) + (_e1426 * _e481));
                                                                            let _e1453 = (_e1399 - _e1403);
                                                                            let _e1454 = (_e1397 - _e1401);
                                                                            let _e1462 = (-(((_e1403 * _e1453) + (_e1401 * _e1454))) / ((_e1453 * _e1453) + (_e1454 * _e1454)));
                                                                            let _e1464 = select(1f, _e1462, (_e1462 < 1f));
                                                                            let _e1466 = select(0f, _e1464, (_e1464 > 0f));
                                                                            let _e1479 = ((_e1405.x + (_e1411.x * _e1466)) - _e309);
                                                                            let _e1480 = ((_e1405.y + (_e1411.y * _e1466)) - _e376);
                                                                            let _e1481 = ((_e1405.z + (_e1411.z * _e1466)) - _e442);
                                                                            let _e1482 = (_e1481 / _e481);
                                                                            let _e1494 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                                            let _e1497 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                            let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                                                            let _e1502 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                            let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                            let _e1510 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                            let _e1513 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                            let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                            let _e1518 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1418 * _e1479) + (_e1423 * _e1480)) + (_e1426 * _e1481)) - _e1447)) & 2147483647u)) <= ((0.0000009536743f * select(_e1384, _e1504, (_e1504 > _e1384))) * select(_e1518, _e1515, (_e1515 > _e1518)))) {
                                                                                let _e1528 = bitcast<f32>((bitcast<u32>(_e1409.x) & 2147483647u));
                                                                                let _e1531 = bitcast<f32>((bitcast<u32>(_e1409.y) & 2147483647u));
                                                                                let _e1533 = select(_e1531, _e1528, (_e1528 > _e1531));
                                                                                let _e1536 = bitcast<f32>((bitcast<u32>(_e1409.z) & 2147483647u));
                                                                                let _e1542 = bitcast<f32>((bitcast<u32>(_e1407.x) & 2147483647u));
                                                                                let _e1545 = bitcast<f32>((bitcast<u32>(_e1407.y) & 2147483647u));
                                                                                let _e1547 = select(_e1545, _e1542, (_e1542 > _e1545));
                                                                                let _e1550 = bitcast<f32>((bitcast<u32>(_e1407.z) & 2147483647u));
                                                                                let _e1554 = (bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u)) > ((0.0000038146973f * select(_e1536, _e1533, (_e1533 > _e1536))) * select(_e1550, _e1547, (_e1547 > _e1550))));
                                                                                if _e1554 {
                                                                                    phi_2206_ = (_e1447 / _e1452);
                                                                                } else {
                                                                                    phi_2206_ = f32();
                                                                                }
                                                                                let _e1557 = phi_2206_;
                                                                                phi_2208_ = _e1557;
                                                                                phi_2209_ = select(true, false, _e1554);
                                                                            } else {
                                                                                phi_2208_ = f32();
                                                                                phi_2209_ = true;
                                                                            }
                                                                            let _e1560 = phi_2208_;
                                                                            let _e1562 = phi_2209_;
                                                                            if _e1562 {
                                                                                let _e1570 = (((_e1418 * (_e1479 - (_e349 * _e1482))) + (_e1423 * (_e1480 - (_e415 * _e1482)))) / _e1452);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u)) <= _e1384) {
                                                                                    phi_2229_ = (_e1482 + _e1570);
                                                                                } else {
                                                                                    phi_2229_ = _e1482;
                                                                                }
                                                                                let _e1577 = phi_2229_;
                                                                                phi_2230_ = _e1577;
                                                                            } else {
                                                                                phi_2230_ = _e1560;
                                                                            }
                                                                            let _e1579 = phi_2230_;
                                                                            let _e1581 = select(_e1317, _e1579, (_e1579 < _e1317));
                                                                            let _e1583 = select(_e1309, _e1581, (_e1581 > _e1309));
                                                                            if (_e1583 >= _e595) {
                                                                                let _e1585 = (_e1583 <= _e1061.member.member_1);
                                                                                if _e1585 {
                                                                                    let _e1586 = (1f / _e1236);
                                                                                    phi_2253_ = type_23(_e1583, (_e1230 * _e1586), (_e1234 * _e1586), _e1096);
                                                                                } else {
                                                                                    phi_2253_ = type_23();
                                                                                }
                                                                                let _e1591 = phi_2253_;
                                                                                phi_2255_ = _e1591;
                                                                                phi_2256_ = select(true, false, _e1585);
                                                                            } else {
                                                                                phi_2255_ = type_23();
                                                                                phi_2256_ = true;
                                                                            }
                                                                            let _e1594 = phi_2255_;
                                                                            let _e1596 = phi_2256_;
                                                                            if _e1596 {
                                                                                phi_2260_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2260_ = _e1594;
                                                                            }
                                                                            let _e1598 = phi_2260_;
                                                                            phi_2261_ = _e1598;
                                                                        }
                                                                        let _e1600 = phi_2261_;
                                                                        phi_2262_ = _e1600;
                                                                        phi_2263_ = _e1326;
                                                                    }
                                                                    let _e1602 = phi_2262_;
                                                                    let _e1604 = phi_2263_;
                                                                    phi_2267_ = _e1602;
                                                                    phi_2268_ = _e1604;
                                                                }
                                                                let _e1606 = phi_2267_;
                                                                let _e1608 = phi_2268_;
                                                                phi_2269_ = _e1606;
                                                                phi_2270_ = _e1261;
                                                                phi_2271_ = _e1608;
                                                            }
                                                            let _e1610 = phi_2269_;
                                                            let _e1612 = phi_2270_;
                                                            let _e1614 = phi_2271_;
                                                            phi_2272_ = _e1610;
                                                            phi_2273_ = _e1612;
                                                            phi_2274_ = _e1614;
                                                        }
                                                        let _e1616 = phi_2272_;
                                                        let _e1618 = phi_2273_;
                                                        let _e1620 = phi_2274_;
                                                        phi_2282_ = _e1616;
                                                        phi_2283_ = select(_e1620, true, _e1618);
                                                    } else {
                                                        phi_2282_ = type_23();
                                                        phi_2283_ = true;
                                                    }
                                                    let _e1623 = phi_2282_;
                                                    let _e1625 = phi_2283_;
                                                    if _e1625 {
                                                        phi_2287_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2287_ = _e1623;
                                                    }
                                                    let _e1627 = phi_2287_;
                                                    if (_e1627.member_3 != 4294967295u) {
                                                        if (_e1096 != _e601) {
                                                            if (_e1627.member < _e1061.member.member.member) {
                                                                phi_2313_ = true;
                                                            } else {
                                                                if (_e1627.member == _e1061.member.member.member) {
                                                                    phi_2312_ = (_e1627.member_3 < _e1061.member.member.member_3);
                                                                } else {
                                                                    phi_2312_ = false;
                                                                }
                                                                let _e1642 = phi_2312_;
                                                                phi_2313_ = _e1642;
                                                            }
                                                            let _e1644 = phi_2313_;
                                                            if _e1644 {
                                                                phi_2320_ = type_41(type_38(_e1627, _e1627.member), _e1088.member_1, _e1088.member_2);
                                                            } else {
                                                                phi_2320_ = _e1088;
                                                            }
                                                            let _e1651 = phi_2320_;
                                                            phi_2321_ = _e1651;
                                                        } else {
                                                            phi_2321_ = _e1088;
                                                        }
                                                        let _e1653 = phi_2321_;
                                                        phi_2322_ = _e1653;
                                                    } else {
                                                        phi_2322_ = _e1088;
                                                    }
                                                    let _e1655 = phi_2322_;
                                                    phi_1247_ = _e1655;
                                                } else {
                                                    phi_1247_ = type_41();
                                                }
                                                let _e1657 = phi_1247_;
                                                continue;
                                                continuing {
                                                    phi_1246_ = _e1657;
                                                    phi_1249_ = _e1076;
                                                    phi_3662_ = _e632;
                                                    break if !(_e1082);
                                                }
                                            }
                                            let _e1660 = phi_3662_;
                                            phi_3822_ = _e1660;
                                            if _e1660 {
                                                break;
                                            }
                                            phi_3826_ = _e1660;
                                            let _e1988 = local_12;
                                            phi_3339_ = _e1988;
                                            phi_3340_ = false;
                                            phi_3341_ = _e676;
                                            phi_3342_ = _e678;
                                        } else {
                                            let _e687 = (_e678.member_1 < _e90);
                                            if _e687 {
                                                if _e687 {
                                                } else {
                                                    phi_3822_ = true;
                                                    break;
                                                }
                                                let _e689 = global_7.member[_e678.member_1];
                                                phi_2348_ = _e689;
                                            } else {
                                                phi_2348_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e691 = phi_2348_;
                                            let _e706 = ((10u * _e262) & 31u);
                                            let _e709 = ((_e691.member[0] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e717 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[0] - _e678.member.member[0]) * 0.0009775171f)) ^ _e128));
                                            let _e722 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e709)) - 8388608f) * _e717)) ^ _e128)));
                                            let _e726 = select(select(_e678.member.member_1[0], _e722, (_e722 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e709 == 1023u));
                                            let _e728 = ((10u * _e261) & 31u);
                                            let _e731 = ((_e691.member[0] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e739 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[1] - _e678.member.member[1]) * 0.0009775171f)) ^ _e128));
                                            let _e744 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e731)) - 8388608f) * _e739)) ^ _e128)));
                                            let _e748 = select(select(_e678.member.member_1[1], _e744, (_e744 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e731 == 1023u));
                                            let _e750 = ((10u * _e263) & 31u);
                                            let _e753 = ((_e691.member[0] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e761 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[2] - _e678.member.member[2]) * 0.0009775171f)) ^ _e128));
                                            let _e766 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e753)) - 8388608f) * _e761)) ^ _e128)));
                                            let _e770 = select(select(_e678.member.member_1[2], _e766, (_e766 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e753 == 1023u));
                                            let _e773 = ((_e691.member[1] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e781 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e773)) - 8388608f) * _e717)) ^ _e128)));
                                            let _e785 = select(select(_e678.member.member_1[0], _e781, (_e781 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e773 == 1023u));
                                            let _e788 = ((_e691.member[1] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e796 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e739)) ^ _e128)));
                                            let _e800 = select(select(_e678.member.member_1[1], _e796, (_e796 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e788 == 1023u));
                                            let _e803 = ((_e691.member[1] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e811 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e803)) - 8388608f) * _e761)) ^ _e128)));
                                            let _e815 = select(select(_e678.member.member_1[2], _e811, (_e811 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e803 == 1023u));
                                            let _e821 = ((_e691.member_1[0] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e829 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e821)) - 8388608f) * _e717)) ^ _e128)));
                                            let _e833 = select(select(_e678.member.member_1[0], _e829, (_e829 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e821 == 1023u));
                                            let _e836 = ((_e691.member_1[0] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e844 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e836)) - 8388608f) * _e739)) ^ _e128)));
                                            let _e848 = select(select(_e678.member.member_1[1], _e844, (_e844 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e836 == 1023u));
                                            let _e851 = ((_e691.member_1[0] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e859 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e851)) - 8388608f) * _e761)) ^ _e128)));
                                            let _e863 = select(select(_e678.member.member_1[2], _e859, (_e859 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e851 == 1023u));
                                            let _e866 = ((_e691.member_1[1] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e874 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e866)) - 8388608f) * _e717)) ^ _e128)));
                                            let _e878 = select(select(_e678.member.member_1[0], _e874, (_e874 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e866 == 1023u));
                                            let _e881 = ((_e691.member_1[1] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e889 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e739)) ^ _e128)));
                                            let _e893 = select(select(_e678.member.member_1[1], _e889, (_e889 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e881 == 1023u));
                                            let _e896 = ((_e691.member_1[1] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e904 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e761)) ^ _e128)));
                                            let _e908 = select(select(_e678.member.member_1[2], _e904, (_e904 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e896 == 1023u));
                                            let _e913 = type_52(type_50(array<f32, 3>(_e726, _e748, _e770), array<f32, 3>(_e785, _e800, _e815)), _e691.member_2);
                                            let _e918 = type_52(type_50(array<f32, 3>(_e833, _e848, _e863), array<f32, 3>(_e878, _e893, _e908)), _e691.member_3);
                                            let _e931 = ((_e726 - _e347) * _e352);
                                            let _e932 = ((_e833 - _e347) * _e352);
                                            let _e933 = ((_e785 - _e348) * _e352);
                                            let _e934 = ((_e878 - _e348) * _e352);
                                            let _e939 = ((_e748 - _e413) * _e418);
                                            let _e940 = ((_e848 - _e413) * _e418);
                                            let _e941 = ((_e800 - _e414) * _e418);
                                            let _e942 = ((_e893 - _e414) * _e418);
                                            let _e947 = ((_e770 - _e479) * _e484);
                                            let _e948 = ((_e863 - _e479) * _e484);
                                            let _e949 = ((_e815 - _e480) * _e484);
                                            let _e950 = ((_e908 - _e480) * _e484);
                                            let _e952 = select(_e949, _e947, (_e947 < _e949));
                                            let _e954 = select(_e950, _e948, (_e948 < _e950));
                                            let _e956 = select(_e949, _e947, (_e947 > _e949));
                                            let _e958 = select(_e950, _e948, (_e948 > _e950));
                                            let _e960 = select(_e933, _e931, (_e931 < _e933));
                                            let _e962 = select(_e934, _e932, (_e932 < _e934));
                                            let _e964 = select(_e941, _e939, (_e939 < _e941));
                                            let _e966 = select(_e942, _e940, (_e940 < _e942));
                                            let _e968 = select(_e964, _e960, (_e960 > _e964));
                                            let _e970 = select(_e966, _e962, (_e962 > _e966));
                                            let _e972 = select(_e952, _e968, (_e968 > _e952));
                                            let _e974 = select(_e954, _e970, (_e970 > _e954));
                                            let _e976 = select(_e933, _e931, (_e931 > _e933));
                                            let _e978 = select(_e934, _e932, (_e932 > _e934));
                                            let _e980 = select(_e941, _e939, (_e939 > _e941));
                                            let _e982 = select(_e942, _e940, (_e940 > _e942));
                                            let _e984 = select(_e980, _e976, (_e976 < _e980));
                                            let _e986 = select(_e982, _e978, (_e978 < _e982));
                                            let _e991 = -(_e952);
                                            let _e992 = -(_e954);
                                            let _e999 = (select(_e956, _e984, (_e984 < _e956)) + (select(_e991, _e956, (_e956 > _e991)) * 0.0000019073523f));
                                            let _e1000 = (select(_e958, _e986, (_e986 < _e958)) + (select(_e992, _e958, (_e958 > _e992)) * 0.0000019073523f));
                                            let _e1002 = select(_e595, _e972, (_e972 > _e595));
                                            let _e1004 = select(_e595, _e974, (_e974 > _e595));
                                            let _e1009 = (_e1002 <= select(_e634.member.member_1, _e999, (_e999 < _e634.member.member_1)));
                                            let _e1010 = (_e1004 <= select(_e634.member.member_1, _e1000, (_e1000 < _e634.member.member_1)));
                                            let _e1011 = (_e1002 <= _e1004);
                                            if _e1009 {
                                                if _e1010 {
                                                    if _e1011 {
                                                        phi_3237_ = _e918;
                                                    } else {
                                                        phi_3237_ = _e913;
                                                    }
                                                    let _e1013 = phi_3237_;
                                                    let _e1021 = (_e676 % 128u);
                                                    let _e1022 = (_e1021 < 128u);
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1021] = _e1013.member_1;
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1021] = _e1013.member.member[0];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1021] = _e1013.member.member[1];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1021] = _e1013.member.member[2];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1021] = _e1013.member.member_1[0];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1021] = _e1013.member.member_1[1];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local[_e1021] = _e1013.member.member_1[2];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3822_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1021] = select(_e1004, _e1002, !(_e1011));
                                                    if _e1011 {
                                                        phi_3314_ = _e913;
                                                    } else {
                                                        phi_3314_ = _e918;
                                                    }
                                                    let _e1039 = phi_3314_;
                                                    phi_3315_ = (_e676 + 1u);
                                                    phi_3316_ = _e1039;
                                                } else {
                                                    phi_3315_ = u32();
                                                    phi_3316_ = type_52();
                                                }
                                                let _e1041 = phi_3315_;
                                                let _e1043 = phi_3316_;
                                                phi_3318_ = _e1041;
                                                phi_3319_ = _e1043;
                                                phi_3320_ = select(true, false, _e1010);
                                            } else {
                                                phi_3318_ = u32();
                                                phi_3319_ = type_52();
                                                phi_3320_ = true;
                                            }
                                            let _e1046 = phi_3318_;
                                            let _e1048 = phi_3319_;
                                            let _e1050 = phi_3320_;
                                            if _e1050 {
                                                if _e1009 {
                                                    phi_3327_ = _e913;
                                                } else {
                                                    phi_3327_ = _e918;
                                                }
                                                let _e1052 = phi_3327_;
                                                phi_3332_ = select(_e1010, true, _e1009);
                                                phi_3334_ = _e1052;
                                            } else {
                                                phi_3332_ = _e674;
                                                phi_3334_ = _e1048;
                                            }
                                            let _e1055 = phi_3332_;
                                            let _e1057 = phi_3334_;
                                            phi_3826_ = _e632;
                                            phi_3339_ = type_41(_e634.member, (_e634.member_1 + 1u), _e634.member_2);
                                            phi_3340_ = _e1055;
                                            phi_3341_ = select(_e1046, _e676, _e1050);
                                            phi_3342_ = _e1057;
                                        }
                                        let _e1662 = phi_3826_;
                                        let _e1664 = phi_3339_;
                                        let _e1666 = phi_3340_;
                                        let _e1668 = phi_3341_;
                                        let _e1670 = phi_3342_;
                                        phi_3825_ = _e1662;
                                        phi_3343_ = _e1664;
                                        phi_3344_ = _e1666;
                                        phi_3345_ = (_e638 - 1u);
                                        phi_3346_ = _e1668;
                                        phi_3347_ = _e1670;
                                    } else {
                                        phi_3825_ = _e632;
                                        phi_3343_ = _e634;
                                        phi_3344_ = _e674;
                                        phi_3345_ = _e638;
                                        phi_3346_ = _e676;
                                        phi_3347_ = _e678;
                                    }
                                    let _e1672 = phi_3825_;
                                    let _e1674 = phi_3343_;
                                    let _e1676 = phi_3344_;
                                    let _e1678 = phi_3345_;
                                    let _e1680 = phi_3346_;
                                    let _e1682 = phi_3347_;
                                    phi_3824_ = _e1672;
                                    phi_3348_ = _e1674;
                                    phi_3349_ = _e1676;
                                    phi_3350_ = _e1678;
                                    phi_3351_ = _e1680;
                                    phi_3352_ = _e1682;
                                } else {
                                    phi_3824_ = _e632;
                                    phi_3348_ = type_41();
                                    phi_3349_ = bool();
                                    phi_3350_ = u32();
                                    phi_3351_ = u32();
                                    phi_3352_ = type_52();
                                }
                                let _e1684 = phi_3824_;
                                let _e1686 = phi_3348_;
                                let _e1688 = phi_3349_;
                                let _e1690 = phi_3350_;
                                let _e1692 = phi_3351_;
                                let _e1694 = phi_3352_;
                                phi_3823_ = _e1684;
                                phi_1121_ = _e1686;
                                phi_1124_ = _e1688;
                                phi_1126_ = _e1690;
                                phi_1128_ = _e1692;
                                phi_1130_ = _e1694;
                                phi_3353_ = _e646;
                            } else {
                                phi_3823_ = _e632;
                                phi_1121_ = type_41();
                                phi_1124_ = bool();
                                phi_1126_ = u32();
                                phi_1128_ = u32();
                                phi_1130_ = type_52();
                                phi_3353_ = false;
                            }
                            let _e1696 = phi_3823_;
                            let _e1698 = phi_1121_;
                            let _e1700 = phi_1124_;
                            let _e1702 = phi_1126_;
                            let _e1704 = phi_1128_;
                            let _e1706 = phi_1130_;
                            let _e1708 = phi_3353_;
                            continue;
                            continuing {
                                phi_3668_ = _e1696;
                                phi_1120_ = _e1698;
                                phi_1123_ = _e1700;
                                phi_1125_ = _e1702;
                                phi_1127_ = _e1704;
                                phi_1129_ = _e1706;
                                phi_3822_ = _e1696;
                                break if !(_e1708);
                            }
                        }
                        let _e1711 = phi_3822_;
                        if _e1711 {
                            break;
                        }
                        let _e1713 = local_10;
                        if (_e1713.member.member.member_3 != 4294967295u) {
                            let _e1719 = bitcast<u32>(_e1713.member.member.member);
                            let _e1723 = (bitcast<i32>((_e1719 >> bitcast<u32>(23i))) & 255i);
                            let _e1724 = (_e1723 + _e264);
                            if (_e1723 == 255i) {
                                phi_3412_ = _e1713.member.member.member;
                            } else {
                                if (_e1723 > 0i) {
                                    if (_e1724 > 0i) {
                                        let _e1728 = (_e1724 < 255i);
                                        if _e1728 {
                                            phi_3391_ = bitcast<f32>((_e1719 + bitcast<u32>((_e264 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3391_ = f32();
                                        }
                                        let _e1735 = phi_3391_;
                                        phi_3393_ = _e1735;
                                        phi_3394_ = select(true, false, _e1728);
                                    } else {
                                        phi_3393_ = f32();
                                        phi_3394_ = true;
                                    }
                                    let _e1738 = phi_3393_;
                                    let _e1740 = phi_3394_;
                                    phi_3395_ = _e1738;
                                    phi_3396_ = _e1740;
                                } else {
                                    phi_3395_ = f32();
                                    phi_3396_ = true;
                                }
                                let _e1742 = phi_3395_;
                                let _e1744 = phi_3396_;
                                if _e1744 {
                                    let _e1745 = (_e1719 & 2147483648u);
                                    let _e1752 = ((_e1719 & 8388607u) | (select(0u, 1u, ((_e1719 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1756 = (_e1752 == 0u);
                                    if _e1756 {
                                        phi_3632_ = bitcast<f32>(_e1745);
                                    } else {
                                        let _e1761 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1752)), 32u, _e1756) - 8u);
                                        let _e1764 = (_e1752 << bitcast<u32>((_e1761 & 31u)));
                                        let _e1766 = ((_e1724 + select(0i, 1i, (_e1723 == 0i))) - bitcast<i32>(_e1761));
                                        if (_e1766 >= 255i) {
                                            phi_3622_ = bitcast<f32>((_e1745 | 2139095040u));
                                            phi_3623_ = f32();
                                            phi_3624_ = true;
                                        } else {
                                            let _e1768 = (_e1766 > 0i);
                                            if _e1768 {
                                                phi_3616_ = bitcast<f32>(((_e1745 | (bitcast<u32>(_e1766) << bitcast<u32>(23i))) | (_e1764 & 8388607u)));
                                                phi_3617_ = f32();
                                            } else {
                                                if (_e1766 < -24i) {
                                                    phi_3582_ = 26u;
                                                } else {
                                                    phi_3582_ = bitcast<u32>((1i - _e1766));
                                                }
                                                let _e1773 = phi_3582_;
                                                let _e1774 = (_e1773 & 31u);
                                                let _e1776 = (_e1764 >> bitcast<u32>(_e1774));
                                                let _e1780 = (_e1764 & ((1u << bitcast<u32>(_e1774)) - 1u));
                                                let _e1784 = (1u << bitcast<u32>(((_e1773 - 1u) & 31u)));
                                                if (_e1780 > _e1784) {
                                                    phi_3603_ = true;
                                                } else {
                                                    if (_e1780 == _e1784) {
                                                        phi_3600_ = ((_e1776 & 1u) == 1u);
                                                    } else {
                                                        phi_3600_ = false;
                                                    }
                                                    let _e1790 = phi_3600_;
                                                    phi_3603_ = _e1790;
                                                }
                                                let _e1792 = phi_3603_;
                                                phi_3616_ = f32();
                                                phi_3617_ = bitcast<f32>((_e1745 | (_e1776 + select(0u, 1u, _e1792))));
                                            }
                                            let _e1805 = phi_3616_;
                                            let _e1807 = phi_3617_;
                                            phi_3622_ = _e1805;
                                            phi_3623_ = _e1807;
                                            phi_3624_ = _e1768;
                                        }
                                        let _e1811 = phi_3622_;
                                        let _e1813 = phi_3623_;
                                        let _e1815 = phi_3624_;
                                        phi_3632_ = select(_e1813, _e1811, _e1815);
                                    }
                                    let _e1819 = phi_3632_;
                                    phi_3411_ = _e1819;
                                } else {
                                    phi_3411_ = _e1742;
                                }
                                let _e1821 = phi_3411_;
                                phi_3412_ = _e1821;
                            }
                            let _e1823 = phi_3412_;
                            let _e1824 = bitcast<u32>(_e1823);
                            if ((_e1824 & 2147483647u) >= 2139095040u) {
                                phi_3424_ = bitcast<f32>(((_e1824 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3424_ = _e1823;
                            }
                            let _e1831 = phi_3424_;
                            phi_3429_ = type_23(_e1831, _e1713.member.member.member_1, _e1713.member.member.member_2, _e1713.member.member.member_3);
                        } else {
                            phi_3429_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1836 = phi_3429_;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_2.member[_e132] = _e1836;
                        let _e1840 = local_11;
                        if _e141 {
                        } else {
                            break;
                        }
                        global_5.member[_e132] = _e1840.member_1;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e1845 = select(0u, 1u, (_e208 <= _e218));
                        if (_e1845 > 0u) {
                            let _e1847 = (1u < _e100);
                            if _e1847 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1851 = atomicAdd((&global_6.member[0u]), _e1845);
                                if ((_e1851 + _e1845) < _e1851) {
                                    if _e1847 {
                                    } else {
                                        break;
                                    }
                                    let _e1856 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1859 = select(0u, 1u, (_e1836.member_3 != 4294967295u));
                        if (_e1859 > 0u) {
                            let _e1861 = (3u < _e100);
                            if _e1861 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1865 = atomicAdd((&global_6.member[2u]), _e1859);
                                if ((_e1865 + _e1859) < _e1865) {
                                    if _e1861 {
                                    } else {
                                        break;
                                    }
                                    let _e1870 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1840.member_1 > 0u) {
                            let _e1872 = (5u < _e100);
                            if _e1872 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1876 = atomicAdd((&global_6.member[4u]), _e1840.member_1);
                                if ((_e1876 + _e1840.member_1) < _e1876) {
                                    if _e1872 {
                                    } else {
                                        break;
                                    }
                                    let _e1881 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
