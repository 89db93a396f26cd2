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
    var phi_3674_: bool;
    var phi_1120_: type_41;
    var phi_1123_: u32;
    var phi_1125_: bool;
    var phi_1127_: u32;
    var phi_1129_: type_52;
    var phi_1140_: bool;
    var phi_1226_: bool;
    var phi_1227_: u32;
    var phi_1228_: type_52;
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
    var phi_3668_: bool;
    var phi_3887_: bool;
    var phi_2323_: type_41;
    var phi_2344_: type_45;
    var phi_3233_: type_52;
    var phi_3309_: type_52;
    var phi_3310_: u32;
    var phi_3311_: type_52;
    var phi_3313_: u32;
    var phi_3314_: type_52;
    var phi_3315_: bool;
    var phi_3322_: type_52;
    var phi_3327_: bool;
    var phi_3329_: type_52;
    var phi_3334_: type_41;
    var phi_3335_: bool;
    var phi_3336_: u32;
    var phi_3337_: type_52;
    var phi_3345_: type_41;
    var phi_3348_: type_52;
    var phi_3831_: bool;
    var phi_3349_: type_41;
    var phi_3350_: u32;
    var phi_3351_: bool;
    var phi_3352_: u32;
    var phi_3353_: type_52;
    var phi_3830_: bool;
    var phi_3354_: type_41;
    var phi_3355_: u32;
    var phi_3356_: bool;
    var phi_3357_: u32;
    var phi_3358_: type_52;
    var phi_3829_: bool;
    var phi_1121_: type_41;
    var phi_1124_: u32;
    var phi_1126_: bool;
    var phi_1128_: u32;
    var phi_1130_: type_52;
    var phi_3359_: bool;
    var phi_3828_: bool;
    var local_10: type_41;
    var phi_3397_: f32;
    var phi_3399_: f32;
    var phi_3400_: bool;
    var phi_3401_: f32;
    var phi_3402_: bool;
    var phi_3588_: u32;
    var phi_3606_: bool;
    var phi_3609_: bool;
    var phi_3622_: f32;
    var phi_3623_: f32;
    var phi_3628_: f32;
    var phi_3629_: f32;
    var phi_3630_: bool;
    var phi_3638_: f32;
    var phi_3417_: f32;
    var phi_3418_: f32;
    var phi_3430_: f32;
    var phi_3435_: type_23;
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
                        phi_3674_ = false;
                        phi_1120_ = type_41(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e593), 0u, 0u);
                        phi_1123_ = ((3u * _e90) + 1u);
                        phi_1125_ = (_e595 <= _e593);
                        phi_1127_ = 0u;
                        phi_1129_ = type_52(type_50(array<f32, 3>(_e608, _e612, _e616), array<f32, 3>(_e620, _e622, _e624)), select(0u, 2147483648u, (_e90 == 0u)));
                        loop {
                            let _e632 = phi_3674_;
                            let _e634 = phi_1120_;
                            let _e636 = phi_1123_;
                            let _e638 = phi_1125_;
                            let _e640 = phi_1127_;
                            let _e642 = phi_1129_;
                            local_10 = _e634;
                            local_11 = _e634;
                            if _e638 {
                                phi_1140_ = true;
                            } else {
                                phi_1140_ = (_e640 > 0u);
                            }
                            let _e645 = phi_1140_;
                            if _e645 {
                                let _e646 = (_e636 > 0u);
                                if _e646 {
                                    if _e638 {
                                        phi_1226_ = _e638;
                                        phi_1227_ = _e640;
                                        phi_1228_ = _e642;
                                    } else {
                                        let _e647 = (_e640 - 1u);
                                        let _e648 = (_e647 % 128u);
                                        let _e649 = (_e648 < 128u);
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
                                            break;
                                        }
                                        let _e651 = local_6[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
                                            break;
                                        }
                                        let _e653 = local_5[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
                                            break;
                                        }
                                        let _e655 = local_4[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
                                            break;
                                        }
                                        let _e657 = local_3[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
                                            break;
                                        }
                                        let _e660 = local_2[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
                                            break;
                                        }
                                        let _e662 = local_1[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
                                            break;
                                        }
                                        let _e664 = local[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3828_ = true;
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
                                        let _e682 = ((_e678.member_1 & 2147483648u) != 0u);
                                        if _e682 {
                                            phi_1246_ = _e634;
                                            phi_1249_ = type_7(0u, ((_e678.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e689 = phi_1246_;
                                                let _e691 = phi_1249_;
                                                local_12 = _e689;
                                                if (_e691.member < _e691.member_1) {
                                                    phi_1250_ = type_7((_e691.member + 1u), _e691.member_1);
                                                    phi_1272_ = type_7(1u, _e691.member);
                                                } else {
                                                    phi_1250_ = _e691;
                                                    phi_1272_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e704 = phi_1250_;
                                                let _e706 = phi_1272_;
                                                let _e710 = (bitcast<i32>(_e706.member) != 0i);
                                                if _e710 {
                                                    let _e716 = type_41(_e689.member, _e689.member_1, (_e689.member_2 + 1u));
                                                    let _e717 = ((_e678.member_1 & 268435455u) + _e706.member_1);
                                                    let _e718 = (_e717 < _e92);
                                                    if _e718 {
                                                        if _e718 {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e722 = global_1.member[_e717].member_1;
                                                        phi_1296_ = _e722;
                                                    } else {
                                                        phi_1296_ = 4294967295u;
                                                    }
                                                    let _e724 = phi_1296_;
                                                    if (_e717 >= _e92) {
                                                        phi_1388_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e718 {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        if (_e605 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e731 = global_1.member[_e717].member[_e605];
                                                        if (_e609 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e737 = global_1.member[_e717].member[_e609];
                                                        if (_e613 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e743 = global_1.member[_e717].member[_e613];
                                                        let _e745 = (3u + _e605);
                                                        if (_e745 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e751 = global_1.member[_e717].member[_e745];
                                                        let _e752 = (3u + _e609);
                                                        if (_e752 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e758 = global_1.member[_e717].member[_e752];
                                                        let _e759 = (3u + _e613);
                                                        if (_e759 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e765 = global_1.member[_e717].member[_e759];
                                                        let _e767 = (6u + _e605);
                                                        if (_e767 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e773 = global_1.member[_e717].member[_e767];
                                                        let _e774 = (6u + _e609);
                                                        if (_e774 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e780 = global_1.member[_e717].member[_e774];
                                                        let _e781 = (6u + _e613);
                                                        if (_e781 < 9u) {
                                                        } else {
                                                            phi_3668_ = true;
                                                            break;
                                                        }
                                                        let _e787 = global_1.member[_e717].member[_e781];
                                                        phi_1388_ = array<array<f32, 3>, 3>(array<f32, 3>(_e731, _e737, _e743), array<f32, 3>(_e751, _e758, _e765), array<f32, 3>(_e773, _e780, _e787));
                                                    }
                                                    let _e791 = phi_1388_;
                                                    let _e800 = (_e791[0][2] - _e442);
                                                    let _e803 = (((_e791[0][0] - _e309) * _e481) - (_e800 * _e349));
                                                    let _e806 = (((_e791[0][1] - _e376) * _e481) - (_e800 * _e415));
                                                    let _e813 = (_e791[1][2] - _e442);
                                                    let _e816 = (((_e791[1][0] - _e309) * _e481) - (_e813 * _e349));
                                                    let _e819 = (((_e791[1][1] - _e376) * _e481) - (_e813 * _e415));
                                                    let _e826 = (_e791[2][2] - _e442);
                                                    let _e829 = (((_e791[2][0] - _e309) * _e481) - (_e826 * _e349));
                                                    let _e832 = (((_e791[2][1] - _e376) * _e481) - (_e826 * _e415));
                                                    let _e833 = (_e829 * _e819);
                                                    let _e834 = (_e832 * _e816);
                                                    let _e835 = (_e803 * _e832);
                                                    let _e836 = (_e806 * _e829);
                                                    let _e837 = (_e816 * _e806);
                                                    let _e838 = (_e819 * _e803);
                                                    let _e843 = (((_e833 >= _e834) && (_e835 >= _e836)) && (_e837 >= _e838));
                                                    if (_e843 || (((_e833 <= _e834) && (_e835 <= _e836)) && (_e837 <= _e838))) {
                                                        let _e850 = select(-1f, 1f, _e843);
                                                        let _e852 = ((_e833 - _e834) * _e850);
                                                        let _e854 = select(0f, _e852, (_e852 > 0f));
                                                        let _e856 = ((_e835 - _e836) * _e850);
                                                        let _e858 = select(0f, _e856, (_e856 > 0f));
                                                        let _e860 = ((_e837 - _e838) * _e850);
                                                        let _e862 = select(0f, _e860, (_e860 > 0f));
                                                        let _e864 = ((_e854 + _e858) + _e862);
                                                        if (_e864 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2272_ = type_23();
                                                            phi_2273_ = true;
                                                            phi_2274_ = false;
                                                        } else {
                                                            let _e867 = select(_e816, _e803, (_e803 < _e816));
                                                            if (select(_e829, _e867, (_e867 < _e829)) > 0f) {
                                                                phi_1540_ = true;
                                                            } else {
                                                                let _e872 = select(_e816, _e803, (_e803 > _e816));
                                                                phi_1540_ = (select(_e829, _e872, (_e872 > _e829)) < 0f);
                                                            }
                                                            let _e877 = phi_1540_;
                                                            if _e877 {
                                                                phi_2269_ = type_23();
                                                                phi_2270_ = true;
                                                                phi_2271_ = false;
                                                            } else {
                                                                let _e879 = select(_e819, _e806, (_e806 < _e819));
                                                                if (select(_e832, _e879, (_e879 < _e832)) > 0f) {
                                                                    phi_1569_ = true;
                                                                } else {
                                                                    let _e884 = select(_e819, _e806, (_e806 > _e819));
                                                                    phi_1569_ = (select(_e832, _e884, (_e884 > _e832)) < 0f);
                                                                }
                                                                let _e889 = phi_1569_;
                                                                if _e889 {
                                                                    phi_2267_ = type_23();
                                                                    phi_2268_ = false;
                                                                } else {
                                                                    let _e891 = select(_e791[1][0], _e791[0][0], (_e791[0][0] < _e791[1][0]));
                                                                    let _e895 = select(_e791[1][0], _e791[0][0], (_e791[0][0] > _e791[1][0]));
                                                                    let _e899 = select(_e791[1][1], _e791[0][1], (_e791[0][1] < _e791[1][1]));
                                                                    let _e903 = select(_e791[1][1], _e791[0][1], (_e791[0][1] > _e791[1][1]));
                                                                    let _e907 = select(_e791[1][2], _e791[0][2], (_e791[0][2] < _e791[1][2]));
                                                                    let _e911 = select(_e791[1][2], _e791[0][2], (_e791[0][2] > _e791[1][2]));
                                                                    let _e916 = ((select(_e791[2][0], _e891, (_e891 < _e791[2][0])) - _e347) * _e352);
                                                                    let _e917 = ((select(_e791[2][0], _e895, (_e895 > _e791[2][0])) - _e348) * _e352);
                                                                    let _e920 = ((select(_e791[2][1], _e899, (_e899 < _e791[2][1])) - _e413) * _e418);
                                                                    let _e921 = ((select(_e791[2][1], _e903, (_e903 > _e791[2][1])) - _e414) * _e418);
                                                                    let _e924 = ((select(_e791[2][2], _e907, (_e907 < _e791[2][2])) - _e479) * _e484);
                                                                    let _e925 = ((select(_e791[2][2], _e911, (_e911 > _e791[2][2])) - _e480) * _e484);
                                                                    let _e927 = select(_e925, _e924, (_e924 < _e925));
                                                                    let _e929 = select(_e925, _e924, (_e924 > _e925));
                                                                    let _e931 = select(_e917, _e916, (_e916 < _e917));
                                                                    let _e933 = select(_e921, _e920, (_e920 < _e921));
                                                                    let _e935 = select(_e933, _e931, (_e931 > _e933));
                                                                    let _e937 = select(_e927, _e935, (_e935 > _e927));
                                                                    let _e939 = select(_e917, _e916, (_e916 > _e917));
                                                                    let _e941 = select(_e921, _e920, (_e920 > _e921));
                                                                    let _e943 = select(_e941, _e939, (_e939 < _e941));
                                                                    let _e945 = select(_e929, _e943, (_e943 < _e929));
                                                                    let _e946 = -(_e927);
                                                                    let _e952 = select(_e595, _e937, (_e937 > _e595));
                                                                    if (_e952 > (_e945 + (select(_e946, _e929, (_e929 > _e946)) * 0.0000019073523f))) {
                                                                        phi_2262_ = type_23();
                                                                        phi_2263_ = true;
                                                                    } else {
                                                                        let _e954 = (_e952 > _e689.member.member_1);
                                                                        if _e954 {
                                                                            phi_2261_ = type_23();
                                                                        } else {
                                                                            let _e955 = vec3<f32>(_e791[0][0], _e791[0][1], _e791[0][2]);
                                                                            let _e956 = vec3<f32>(_e791[1][0], _e791[1][1], _e791[1][2]);
                                                                            let _e957 = vec3<f32>(_e791[2][0], _e791[2][1], _e791[2][2]);
                                                                            let _e958 = (_e791[1][0] - _e791[0][0]);
                                                                            let _e959 = (_e791[1][1] - _e791[0][1]);
                                                                            let _e960 = (_e791[1][2] - _e791[0][2]);
                                                                            let _e961 = vec3<f32>(_e958, _e959, _e960);
                                                                            let _e962 = (_e791[2][0] - _e791[1][0]);
                                                                            let _e963 = (_e791[2][1] - _e791[1][1]);
                                                                            let _e964 = (_e791[2][2] - _e791[1][2]);
                                                                            let _e965 = vec3<f32>(_e962, _e963, _e964);
                                                                            let _e966 = (_e791[0][0] - _e791[2][0]);
                                                                            let _e967 = (_e791[0][1] - _e791[2][1]);
                                                                            let _e968 = (_e791[0][2] - _e791[2][2]);
                                                                            let _e969 = vec3<f32>(_e966, _e967, _e968);
                                                                            let _e972 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                            let _e975 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                            let _e977 = select(_e975, _e972, (_e972 > _e975));
                                                                            let _e980 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                            let _e982 = select(_e980, _e977, (_e977 > _e980));
                                                                            let _e985 = bitcast<f32>((bitcast<u32>(_e962) & 2147483647u));
                                                                            let _e988 = bitcast<f32>((bitcast<u32>(_e963) & 2147483647u));
                                                                            let _e990 = select(_e988, _e985, (_e985 > _e988));
                                                                            let _e993 = bitcast<f32>((bitcast<u32>(_e964) & 2147483647u));
                                                                            let _e995 = select(_e993, _e990, (_e990 > _e993));
                                                                            let _e998 = bitcast<f32>((bitcast<u32>(_e966) & 2147483647u));
                                                                            let _e1001 = bitcast<f32>((bitcast<u32>(_e967) & 2147483647u));
                                                                            let _e1003 = select(_e1001, _e998, (_e998 > _e1001));
                                                                            let _e1006 = bitcast<f32>((bitcast<u32>(_e968) & 2147483647u));
                                                                            let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                                                                            let _e1010 = select(_e995, _e982, (_e982 > _e995));
                                                                            let _e1012 = select(_e1008, _e1010, (_e1010 > _e1008));
                                                                            if (_e982 == _e1012) {
                                                                                phi_1988_ = _e819;
                                                                                phi_1989_ = _e816;
                                                                                phi_1990_ = _e806;
                                                                                phi_1991_ = _e803;
                                                                                phi_1992_ = _e955;
                                                                                phi_1993_ = _e969;
                                                                                phi_1994_ = _e965;
                                                                                phi_1995_ = _e961;
                                                                            } else {
                                                                                let _e1014 = (_e995 == _e1012);
                                                                                let _e1019 = vec3(_e1014);
                                                                                phi_1988_ = select(_e806, _e832, _e1014);
                                                                                phi_1989_ = select(_e803, _e829, _e1014);
                                                                                phi_1990_ = select(_e832, _e819, _e1014);
                                                                                phi_1991_ = select(_e829, _e816, _e1014);
                                                                                phi_1992_ = select(_e957, _e956, _e1019);
                                                                                phi_1993_ = select(_e965, _e961, _e1019);
                                                                                phi_1994_ = select(_e961, _e969, _e1019);
                                                                                phi_1995_ = select(_e969, _e965, _e1019);
                                                                            }
                                                                            let _e1025 = phi_1988_;
                                                                            let _e1027 = phi_1989_;
                                                                            let _e1029 = phi_1990_;
                                                                            let _e1031 = phi_1991_;
                                                                            let _e1033 = phi_1992_;
                                                                            let _e1035 = phi_1993_;
                                                                            let _e1037 = phi_1994_;
                                                                            let _e1039 = phi_1995_;
                                                                            let _e1046 = ((_e1037.y * _e1035.z) - (_e1035.y * _e1037.z));
                                                                            let _e1051 = ((_e1037.z * _e1035.x) - (_e1035.z * _e1037.x));
                                                                            let _e1054 = ((_e1037.x * _e1035.y) - (_e1035.x * _e1037.y));
                                                                            if (_e854 >= _e858) {
                                                                                phi_2032_ = select(true, false, (_e854 >= _e862));
                                                                            } else {
                                                                                phi_2032_ = true;
                                                                            }
                                                                            let _e1059 = phi_2032_;
                                                                            if _e1059 {
                                                                                phi_2041_ = select(_e957, _e956, vec3((_e858 >= _e862)));
                                                                            } else {
                                                                                phi_2041_ = _e955;
                                                                            }
                                                                            let _e1064 = phi_2041_;
                                                                            let _e1075 = (((_e1046 * (_e1064.x - _e309)) + (_e1051 * (_e1064.y - _e376))) + (_e1054 * (_e1064.z - _e442)));
                                                                            let _e1080 = (((_e1046 * _e349) + (_e1051 * _e415)) + (_e1054 * _e481));
                                                                            let _e1081 = (_e1027 - _e1031);
                                                                            let _e1082 = (_e1025 - _e1029);
                                                                            let _e1090 = (-(((_e1031 * _e1081) + (_e1029 * _e1082))) / ((_e1081 * _e1081) + (_e1082 * _e1082)));
                                                                            let _e1092 = select(1f, _e1090, (_e1090 < 1f));
                                                                            let _e1094 = select(0f, _e1092, (_e1092 > 0f));
                                                                            let _e1107 = ((_e1033.x + (_e1039.x * _e1094)) - _e309);
                                                                            let _e1108 = ((_e1033.y + (_e1039.y * _e1094)) - _e376);
                                                                            let _e1109 = ((_e1033.z + (_e1039.z * _e1094)) - _e442);
                                                                            let _e1110 = (_e1109 / _e481);
                                                                            let _e1122 = bitcast<f32>((bitcast<u32>(_e1107) & 2147483647u));
                                                                            let _e1125 = bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u));
                                                                            let _e1127 = select(_e1125, _e1122, (_e1122 > _e1125));
                                                                            let _e1130 = bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u));
                                                                            let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                                                                            let _e1138 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                                                            let _e1141 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                                            let _e1143 = select(_e1141, _e1138, (_e1138 > _e1141));
                                                                            let _e1146 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1046 * _e1107) + (_e1051 * _e1108)) + (_e1054 * _e1109)) - _e1075)) & 2147483647u)) <= ((0.0000009536743f * select(_e1012, _e1132, (_e1132 > _e1012))) * select(_e1146, _e1143, (_e1143 > _e1146)))) {
                                                                                let _e1156 = bitcast<f32>((bitcast<u32>(_e1037.x) & 2147483647u));
                                                                                let _e1159 = bitcast<f32>((bitcast<u32>(_e1037.y) & 2147483647u));
                                                                                let _e1161 = select(_e1159, _e1156, (_e1156 > _e1159));
                                                                                let _e1164 = bitcast<f32>((bitcast<u32>(_e1037.z) & 2147483647u));
                                                                                let _e1170 = bitcast<f32>((bitcast<u32>(_e1035.x) & 2147483647u));
                                                                                let _e1173 = bitcast<f32>((bitcast<u32>(_e1035.y) & 2147483647u));
                                                                                let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                                                                                let _e1178 = bitcast<f32>((bitcast<u32>(_e1035.z) & 2147483647u));
                                                                                let _e1182 = (bitcast<f32>((bitcast<u32>(_e1080) & 2147483647u)) > ((0.0000038146973f * select(_e1164, _e1161, (_e1161 > _e1164))) * select(_e1178, _e1175, (_e1175 > _e1178))));
                                                                                if _e1182 {
                                                                                    phi_2206_ = (_e1075 / _e1080);
                                                                                } else {
                                                                                    phi_2206_ = f32();
                                                                                }
                                                                                let _e1185 = phi_2206_;
                                                                                phi_2208_ = _e1185;
                                                                                phi_2209_ = select(true, false, _e1182);
                                                                            } else {
                                                                                phi_2208_ = f32();
                                                                                phi_2209_ = true;
                                                                            }
                                                                            let _e1188 = phi_2208_;
                                                                            let _e1190 = phi_2209_;
                                                                            if _e1190 {
                                                                                let _e1198 = (((_e1046 * (_e1107 - (_e349 * _e1110))) + (_e1051 * (_e1108 - (_e415 * _e1110)))) / _e1080);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u)) <= _e1012) {
                                                                                    phi_2229_ = (_e1110 + _e1198);
                                                                                } else {
                                                                                    phi_2229_ = _e1110;
                                                                                }
                                                                                let _e1205 = phi_2229_;
                                                                                phi_2230_ = _e1205;
                                                                            } else {
                                                                                phi_2230_ = _e1188;
                                                                            }
                                                                            let _e1207 = phi_2230_;
                                                                            let _e1209 = select(_e945, _e1207, (_e1207 < _e945));
                                                                            let _e1211 = select(_e937, _e1209, (_e1209 > _e937));
                                                                            if (_e1211 >= _e595) {
                                                                                let _e1213 = (_e1211 <= _e689.member.member_1);
                                                                                if _e1213 {
                                                                                    let _e1214 = (1f / _e864);
                                                                                    phi_2253_ = type_23(_e1211, (_e858 * _e1214), (_e862 * _e1214), _e724);
                                                                                } else {
                                                                                    phi_2253_ = type_23();
                                                                                }
                                                                                let _e1219 = phi_2253_;
                                                                                phi_2255_ = _e1219;
                                                                                phi_2256_ = select(true, false, _e1213);
                                                                            } else {
                                                                                phi_2255_ = type_23();
                                                                                phi_2256_ = true;
                                                                            }
                                                                            let _e1222 = phi_2255_;
                                                                            let _e1224 = phi_2256_;
                                                                            if _e1224 {
                                                                                phi_2260_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2260_ = _e1222;
                                                                            }
                                                                            let _e1226 = phi_2260_;
                                                                            phi_2261_ = _e1226;
                                                                        }
                                                                        let _e1228 = phi_2261_;
                                                                        phi_2262_ = _e1228;
                                                                        phi_2263_ = _e954;
                                                                    }
                                                                    let _e1230 = phi_2262_;
                                                                    let _e1232 = phi_2263_;
                                                                    phi_2267_ = _e1230;
                                                                    phi_2268_ = _e1232;
                                                                }
                                                                let _e1234 = phi_2267_;
                                                                let _e1236 = phi_2268_;
                                                                phi_2269_ = _e1234;
                                                                phi_2270_ = _e889;
                                                                phi_2271_ = _e1236;
                                                            }
                                                            let _e1238 = phi_2269_;
                                                            let _e1240 = phi_2270_;
                                                            let _e1242 = phi_2271_;
                                                            phi_2272_ = _e1238;
                                                            phi_2273_ = _e1240;
                                                            phi_2274_ = _e1242;
                                                        }
                                                        let _e1244 = phi_2272_;
                                                        let _e1246 = phi_2273_;
                                                        let _e1248 = phi_2274_;
                                                        phi_2282_ = _e1244;
                                                        phi_2283_ = select(_e1248, true, _e1246);
                                                    } else {
                                                        phi_2282_ = type_23();
                                                        phi_2283_ = true;
                                                    }
                                                    let _e1251 = phi_2282_;
                                                    let _e1253 = phi_2283_;
                                                    if _e1253 {
                                                        phi_2287_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2287_ = _e1251;
                                                    }
                                                    let _e1255 = phi_2287_;
                                                    if (_e1255.member_3 != 4294967295u) {
                                                        if (_e724 != _e601) {
                                                            if (_e1255.member < _e689.member.member.member) {
                                                                phi_2313_ = true;
                                                            } else {
                                                                if (_e1255.member == _e689.member.member.member) {
                                                                    phi_2312_ = (_e1255.member_3 < _e689.member.member.member_3);
                                                                } else {
                                                                    phi_2312_ = false;
                                                                }
                                                                let _e1270 = phi_2312_;
                                                                phi_2313_ = _e1270;
                                                            }
                                                            let _e1272 = phi_2313_;
                                                            if _e1272 {
                                                                phi_2320_ = type_41(type_38(_e1255, _e1255.member), _e716.member_1, _e716.member_2);
                                                            } else {
                                                                phi_2320_ = _e716;
                                                            }
                                                            let _e1279 = phi_2320_;
                                                            phi_2321_ = _e1279;
                                                        } else {
                                                            phi_2321_ = _e716;
                                                        }
                                                        let _e1281 = phi_2321_;
                                                        phi_2322_ = _e1281;
                                                    } else {
                                                        phi_2322_ = _e716;
                                                    }
                                                    let _e1283 = phi_2322_;
                                                    phi_1247_ = _e1283;
                                                } else {
                                                    phi_1247_ = type_41();
                                                }
                                                let _e1285 = phi_1247_;
                                                continue;
                                                continuing {
                                                    phi_1246_ = _e1285;
                                                    phi_1249_ = _e704;
                                                    phi_3668_ = _e632;
                                                    break if !(_e710);
                                                }
                                            }
                                            let _e1288 = phi_3668_;
                                            phi_3828_ = _e1288;
                                            if _e1288 {
                                                break;
                                            }
                                            phi_3887_ = _e1288;
                                            let _e1984 = local_12;
                                            phi_2323_ = _e1984;
                                        } else {
                                            phi_3887_ = _e632;
                                            phi_2323_ = _e634;
                                        }
                                        let _e1290 = phi_3887_;
                                        let _e1292 = phi_2323_;
                                        if _e682 {
                                            phi_3334_ = type_41();
                                            phi_3335_ = bool();
                                            phi_3336_ = u32();
                                            phi_3337_ = type_52();
                                        } else {
                                            let _e1293 = (_e678.member_1 < _e90);
                                            if _e1293 {
                                                if _e1293 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                let _e1295 = global_7.member[_e678.member_1];
                                                phi_2344_ = _e1295;
                                            } else {
                                                phi_2344_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1297 = phi_2344_;
                                            let _e1312 = ((10u * _e262) & 31u);
                                            let _e1315 = ((_e1297.member[0] >> bitcast<u32>(_e1312)) & 1023u);
                                            let _e1323 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[0] - _e678.member.member[0]) * 0.0009775171f)) ^ _e128));
                                            let _e1328 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1315)) - 8388608f) * _e1323)) ^ _e128)));
                                            let _e1332 = select(select(_e678.member.member_1[0], _e1328, (_e1328 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1315 == 1023u));
                                            let _e1334 = ((10u * _e261) & 31u);
                                            let _e1337 = ((_e1297.member[0] >> bitcast<u32>(_e1334)) & 1023u);
                                            let _e1345 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[1] - _e678.member.member[1]) * 0.0009775171f)) ^ _e128));
                                            let _e1350 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1337)) - 8388608f) * _e1345)) ^ _e128)));
                                            let _e1354 = select(select(_e678.member.member_1[1], _e1350, (_e1350 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1337 == 1023u));
                                            let _e1356 = ((10u * _e263) & 31u);
                                            let _e1359 = ((_e1297.member[0] >> bitcast<u32>(_e1356)) & 1023u);
                                            let _e1367 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[2] - _e678.member.member[2]) * 0.0009775171f)) ^ _e128));
                                            let _e1372 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1359)) - 8388608f) * _e1367)) ^ _e128)));
                                            let _e1376 = select(select(_e678.member.member_1[2], _e1372, (_e1372 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1359 == 1023u));
                                            let _e1379 = ((_e1297.member[1] >> bitcast<u32>(_e1312)) & 1023u);
                                            let _e1387 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1379)) - 8388608f) * _e1323)) ^ _e128)));
                                            let _e1391 = select(select(_e678.member.member_1[0], _e1387, (_e1387 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1379 == 1023u));
                                            let _e1394 = ((_e1297.member[1] >> bitcast<u32>(_e1334)) & 1023u);
                                            let _e1402 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1394)) - 8388608f) * _e1345)) ^ _e128)));
                                            let _e1406 = select(select(_e678.member.member_1[1], _e1402, (_e1402 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1394 == 1023u));
                                            let _e1409 = ((_e1297.member[1] >> bitcast<u32>(_e1356)) & 1023u);
                                            let _e1417 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1409)) - 8388608f) * _e1367)) ^ _e128)));
                                            let _e1421 = select(select(_e678.member.member_1[2], _e1417, (_e1417 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1409 == 1023u));
                                            let _e1427 = ((_e1297.member_1[0] >> bitcast<u32>(_e1312)) & 1023u);
                                            let _e1435 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1427)) - 8388608f) * _e1323)) ^ _e128)));
                                            let _e1439 = select(select(_e678.member.member_1[0], _e1435, (_e1435 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1427 == 1023u));
                                            let _e1442 = ((_e1297.member_1[0] >> bitcast<u32>(_e1334)) & 1023u);
                                            let _e1450 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1442)) - 8388608f) * _e1345)) ^ _e128)));
                                            let _e1454 = select(select(_e678.member.member_1[1], _e1450, (_e1450 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1442 == 1023u));
                                            let _e1457 = ((_e1297.member_1[0] >> bitcast<u32>(_e1356)) & 1023u);
                                            let _e1465 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1457)) - 8388608f) * _e1367)) ^ _e128)));
                                            let _e1469 = select(select(_e678.member.member_1[2], _e1465, (_e1465 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1457 == 1023u));
                                            let _e1472 = ((_e1297.member_1[1] >> bitcast<u32>(_e1312)) & 1023u);
                                            let _e1480 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1472)) - 8388608f) * _e1323)) ^ _e128)));
                                            let _e1484 = select(select(_e678.member.member_1[0], _e1480, (_e1480 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1472 == 1023u));
                                            let _e1487 = ((_e1297.member_1[1] >> bitcast<u32>(_e1334)) & 1023u);
                                            let _e1495 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1487)) - 8388608f) * _e1345)) ^ _e128)));
                                            let _e1499 = select(select(_e678.member.member_1[1], _e1495, (_e1495 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1487 == 1023u));
                                            let _e1502 = ((_e1297.member_1[1] >> bitcast<u32>(_e1356)) & 1023u);
                                            let _e1510 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1502)) - 8388608f) * _e1367)) ^ _e128)));
                                            let _e1514 = select(select(_e678.member.member_1[2], _e1510, (_e1510 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1502 == 1023u));
                                            let _e1519 = type_52(type_50(array<f32, 3>(_e1332, _e1354, _e1376), array<f32, 3>(_e1391, _e1406, _e1421)), _e1297.member_2);
                                            let _e1524 = type_52(type_50(array<f32, 3>(_e1439, _e1454, _e1469), array<f32, 3>(_e1484, _e1499, _e1514)), _e1297.member_3);
                                            let _e1537 = ((_e1332 - _e347) * _e352);
                                            let _e1538 = ((_e1439 - _e347) * _e352);
                                            let _e1539 = ((_e1391 - _e348) * _e352);
                                            let _e1540 = ((_e1484 - _e348) * _e352);
                                            let _e1545 = ((_e1354 - _e413) * _e418);
                                            let _e1546 = ((_e1454 - _e413) * _e418);
                                            let _e1547 = ((_e1406 - _e414) * _e418);
                                            let _e1548 = ((_e1499 - _e414) * _e418);
                                            let _e1553 = ((_e1376 - _e479) * _e484);
                                            let _e1554 = ((_e1469 - _e479) * _e484);
                                            let _e1555 = ((_e1421 - _e480) * _e484);
                                            let _e1556 = ((_e1514 - _e480) * _e484);
                                            let _e1558 = select(_e1555, _e1553, (_e1553 < _e1555));
                                            let _e1560 = select(_e1556, _e1554, (_e1554 < _e1556));
                                            let _e1562 = select(_e1555, _e1553, (_e1553 > _e1555));
                                            let _e1564 = select(_e1556, _e1554, (_e1554 > _e1556));
                                            let _e1566 = select(_e1539, _e1537, (_e1537 < _e1539));
                                            let _e1568 = select(_e1540, _e1538, (_e1538 < _e1540));
                                            let _e1570 = select(_e1547, _e1545, (_e1545 < _e1547));
                                            let _e1572 = select(_e1548, _e1546, (_e1546 < _e1548));
                                            let _e1574 = select(_e1570, _e1566, (_e1566 > _e1570));
                                            let _e1576 = select(_e1572, _e1568, (_e1568 > _e1572));
                                            let _e1578 = select(_e1558, _e1574, (_e1574 > _e1558));
                                            let _e1580 = select(_e1560, _e1576, (_e1576 > _e1560));
                                            let _e1582 = select(_e1539, _e1537, (_e1537 > _e1539));
                                            let _e1584 = select(_e1540, _e1538, (_e1538 > _e1540));
                                            let _e1586 = select(_e1547, _e1545, (_e1545 > _e1547));
                                            let _e1588 = select(_e1548, _e1546, (_e1546 > _e1548));
                                            let _e1590 = select(_e1586, _e1582, (_e1582 < _e1586));
                                            let _e1592 = select(_e1588, _e1584, (_e1584 < _e1588));
                                            let _e1597 = -(_e1558);
                                            let _e1598 = -(_e1560);
                                            let _e1605 = (select(_e1562, _e1590, (_e1590 < _e1562)) + (select(_e1597, _e1562, (_e1562 > _e1597)) * 0.0000019073523f));
                                            let _e1606 = (select(_e1564, _e1592, (_e1592 < _e1564)) + (select(_e1598, _e1564, (_e1564 > _e1598)) * 0.0000019073523f));
                                            let _e1608 = select(_e595, _e1578, (_e1578 > _e595));
                                            let _e1610 = select(_e595, _e1580, (_e1580 > _e595));
                                            let _e1615 = (_e1608 <= select(_e1292.member.member_1, _e1605, (_e1605 < _e1292.member.member_1)));
                                            let _e1616 = (_e1610 <= select(_e1292.member.member_1, _e1606, (_e1606 < _e1292.member.member_1)));
                                            let _e1617 = (_e1608 <= _e1610);
                                            if _e1615 {
                                                if _e1616 {
                                                    if _e1617 {
                                                        phi_3233_ = _e1524;
                                                    } else {
                                                        phi_3233_ = _e1519;
                                                    }
                                                    let _e1619 = phi_3233_;
                                                    let _e1626 = (_e676 % 128u);
                                                    let _e1627 = (_e1626 < 128u);
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1626] = _e1619.member_1;
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1626] = _e1619.member.member[0];
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1626] = _e1619.member.member[1];
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1626] = _e1619.member.member[2];
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1626] = _e1619.member.member_1[0];
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1626] = _e1619.member.member_1[1];
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local[_e1626] = _e1619.member.member_1[2];
                                                    if _e1627 {
                                                    } else {
                                                        phi_3828_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1626] = select(_e1608, _e1610, _e1617);
                                                    if _e1617 {
                                                        phi_3309_ = _e1519;
                                                    } else {
                                                        phi_3309_ = _e1524;
                                                    }
                                                    let _e1644 = phi_3309_;
                                                    phi_3310_ = (_e676 + 1u);
                                                    phi_3311_ = _e1644;
                                                } else {
                                                    phi_3310_ = u32();
                                                    phi_3311_ = type_52();
                                                }
                                                let _e1646 = phi_3310_;
                                                let _e1648 = phi_3311_;
                                                phi_3313_ = _e1646;
                                                phi_3314_ = _e1648;
                                                phi_3315_ = select(true, false, _e1616);
                                            } else {
                                                phi_3313_ = u32();
                                                phi_3314_ = type_52();
                                                phi_3315_ = true;
                                            }
                                            let _e1651 = phi_3313_;
                                            let _e1653 = phi_3314_;
                                            let _e1655 = phi_3315_;
                                            if _e1655 {
                                                if _e1615 {
                                                    phi_3322_ = _e1519;
                                                } else {
                                                    phi_3322_ = _e1524;
                                                }
                                                let _e1657 = phi_3322_;
                                                phi_3327_ = select(_e1616, true, _e1615);
                                                phi_3329_ = _e1657;
                                            } else {
                                                phi_3327_ = _e674;
                                                phi_3329_ = _e1653;
                                            }
                                            let _e1660 = phi_3327_;
                                            let _e1662 = phi_3329_;
                                            phi_3334_ = type_41(_e1292.member, (_e1292.member_1 + 1u), _e1292.member_2);
                                            phi_3335_ = _e1660;
                                            phi_3336_ = select(_e1651, _e676, _e1655);
                                            phi_3337_ = _e1662;
                                        }
                                        let _e1665 = phi_3334_;
                                        let _e1667 = phi_3335_;
                                        let _e1669 = phi_3336_;
                                        let _e1671 = phi_3337_;
                                        if _e682 {
                                            phi_3345_ = _e1292;
                                            phi_3348_ = _e678;
                                        } else {
                                            phi_3345_ = _e1665;
                                            phi_3348_ = _e1671;
                                        }
                                        let _e1673 = phi_3345_;
                                        let _e1675 = phi_3348_;
                                        phi_3831_ = _e1290;
                                        phi_3349_ = _e1673;
                                        phi_3350_ = (_e636 - 1u);
                                        phi_3351_ = select(_e1667, false, _e682);
                                        phi_3352_ = select(_e1669, _e676, _e682);
                                        phi_3353_ = _e1675;
                                    } else {
                                        phi_3831_ = _e632;
                                        phi_3349_ = _e634;
                                        phi_3350_ = _e636;
                                        phi_3351_ = _e674;
                                        phi_3352_ = _e676;
                                        phi_3353_ = _e678;
                                    }
                                    let _e1679 = phi_3831_;
                                    let _e1681 = phi_3349_;
                                    let _e1683 = phi_3350_;
                                    let _e1685 = phi_3351_;
                                    let _e1687 = phi_3352_;
                                    let _e1689 = phi_3353_;
                                    phi_3830_ = _e1679;
                                    phi_3354_ = _e1681;
                                    phi_3355_ = _e1683;
                                    phi_3356_ = _e1685;
                                    phi_3357_ = _e1687;
                                    phi_3358_ = _e1689;
                                } else {
                                    phi_3830_ = _e632;
                                    phi_3354_ = type_41();
                                    phi_3355_ = u32();
                                    phi_3356_ = bool();
                                    phi_3357_ = u32();
                                    phi_3358_ = type_52();
                                }
                                let _e1691 = phi_3830_;
                                let _e1693 = phi_3354_;
                                let _e1695 = phi_3355_;
                                let _e1697 = phi_3356_;
                                let _e1699 = phi_3357_;
                                let _e1701 = phi_3358_;
                                phi_3829_ = _e1691;
                                phi_1121_ = _e1693;
                                phi_1124_ = _e1695;
                                phi_1126_ = _e1697;
                                phi_1128_ = _e1699;
                                phi_1130_ = _e1701;
                                phi_3359_ = _e646;
                            } else {
                                phi_3829_ = _e632;
                                phi_1121_ = type_41();
                                phi_1124_ = u32();
                                phi_1126_ = bool();
                                phi_1128_ = u32();
                                phi_1130_ = type_52();
                                phi_3359_ = false;
                            }
                            let _e1703 = phi_3829_;
                            let _e1705 = phi_1121_;
                            let _e1707 = phi_1124_;
                            let _e1709 = phi_1126_;
                            let _e1711 = phi_1128_;
                            let _e1713 = phi_1130_;
                            let _e1715 = phi_3359_;
                            continue;
                            continuing {
                                phi_3674_ = _e1703;
                                phi_1120_ = _e1705;
                                phi_1123_ = _e1707;
                                phi_1125_ = _e1709;
                                phi_1127_ = _e1711;
                                phi_1129_ = _e1713;
                                phi_3828_ = _e1703;
                                break if !(_e1715);
                            }
                        }
                        let _e1718 = phi_3828_;
                        if _e1718 {
                            break;
                        }
                        let _e1720 = local_10;
                        if (_e1720.member.member.member_3 != 4294967295u) {
                            let _e1726 = bitcast<u32>(_e1720.member.member.member);
                            let _e1730 = (bitcast<i32>((_e1726 >> bitcast<u32>(23i))) & 255i);
                            let _e1731 = (_e1730 + _e264);
                            if (_e1730 == 255i) {
                                phi_3418_ = _e1720.member.member.member;
                            } else {
                                if (_e1730 > 0i) {
                                    if (_e1731 > 0i) {
                                        let _e1735 = (_e1731 < 255i);
                                        if _e1735 {
                                            phi_3397_ = bitcast<f32>((_e1726 + bitcast<u32>((_e264 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3397_ = f32();
                                        }
                                        let _e1742 = phi_3397_;
                                        phi_3399_ = _e1742;
                                        phi_3400_ = select(true, false, _e1735);
                                    } else {
                                        phi_3399_ = f32();
                                        phi_3400_ = true;
                                    }
                                    let _e1745 = phi_3399_;
                                    let _e1747 = phi_3400_;
                                    phi_3401_ = _e1745;
                                    phi_3402_ = _e1747;
                                } else {
                                    phi_3401_ = f32();
                                    phi_3402_ = true;
                                }
                                let _e1749 = phi_3401_;
                                let _e1751 = phi_3402_;
                                if _e1751 {
                                    let _e1752 = (_e1726 & 2147483648u);
                                    let _e1759 = ((_e1726 & 8388607u) | (select(0u, 1u, ((_e1726 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1763 = (_e1759 == 0u);
                                    if _e1763 {
                                        phi_3638_ = bitcast<f32>(_e1752);
                                    } else {
                                        let _e1768 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1759)), 32u, _e1763) - 8u);
                                        let _e1771 = (_e1759 << bitcast<u32>((_e1768 & 31u)));
                                        let _e1773 = ((_e1731 + select(0i, 1i, (_e1730 == 0i))) - bitcast<i32>(_e1768));
                                        if (_e1773 >= 255i) {
                                            phi_3628_ = bitcast<f32>((_e1752 | 2139095040u));
                                            phi_3629_ = f32();
                                            phi_3630_ = true;
                                        } else {
                                            let _e1775 = (_e1773 > 0i);
                                            if _e1775 {
                                                phi_3622_ = bitcast<f32>(((_e1752 | (bitcast<u32>(_e1773) << bitcast<u32>(23i))) | (_e1771 & 8388607u)));
                                                phi_3623_ = f32();
                                            } else {
                                                if (_e1773 < -24i) {
                                                    phi_3588_ = 26u;
                                                } else {
                                                    phi_3588_ = bitcast<u32>((1i - _e1773));
                                                }
                                                let _e1780 = phi_3588_;
                                                let _e1781 = (_e1780 & 31u);
                                                let _e1783 = (_e1771 >> bitcast<u32>(_e1781));
                                                let _e1787 = (_e1771 & ((1u << bitcast<u32>(_e1781)) - 1u));
                                                let _e1791 = (1u << bitcast<u32>(((_e1780 - 1u) & 31u)));
                                                if (_e1787 > _e1791) {
                                                    phi_3609_ = true;
                                                } else {
                                                    if (_e1787 == _e1791) {
                                                        phi_3606_ = ((_e1783 & 1u) == 1u);
                                                    } else {
                                                        phi_3606_ = false;
                                                    }
                                                    let _e1797 = phi_3606_;
                                                    phi_3609_ = _e1797;
                                                }
                                                let _e1799 = phi_3609_;
                                                phi_3622_ = f32();
                                                phi_3623_ = bitcast<f32>((_e1752 | (_e1783 + select(0u, 1u, _e1799))));
                                            }
                                            let _e1812 = phi_3622_;
                                            let _e1814 = phi_3623_;
                                            phi_3628_ = _e1812;
                                            phi_3629_ = _e1814;
                                            phi_3630_ = _e1775;
                                        }
                                        let _e1818 = phi_3628_;
                                        let _e1820 = phi_3629_;
                                        let _e1822 = phi_3630_;
                                        phi_3638_ = select(_e1820, _e1818, _e1822);
                                    }
                                    let _e1826 = phi_3638_;
                                    phi_3417_ = _e1826;
                                } else {
                                    phi_3417_ = _e1749;
                                }
                                let _e1828 = phi_3417_;
                                phi_3418_ = _e1828;
                            }
                            let _e1830 = phi_3418_;
                            let _e1831 = bitcast<u32>(_e1830);
                            if ((_e1831 & 2147483647u) >= 2139095040u) {
                                phi_3430_ = bitcast<f32>(((_e1831 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3430_ = _e1830;
                            }
                            let _e1838 = phi_3430_;
                            phi_3435_ = type_23(_e1838, _e1720.member.member.member_1, _e1720.member.member.member_2, _e1720.member.member.member_3);
                        } else {
                            phi_3435_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1843 = phi_3435_;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_2.member[_e132] = _e1843;
                        let _e1847 = local_11;
                        if _e141 {
                        } else {
                            break;
                        }
                        global_5.member[_e132] = _e1847.member_1;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e1852 = select(0u, 1u, (_e208 <= _e218));
                        if (_e1852 > 0u) {
                            let _e1854 = (1u < _e100);
                            if _e1854 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1858 = atomicAdd((&global_6.member[0u]), _e1852);
                                if ((_e1858 + _e1852) < _e1858) {
                                    if _e1854 {
                                    } else {
                                        break;
                                    }
                                    let _e1863 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1866 = select(0u, 1u, (_e1843.member_3 != 4294967295u));
                        if (_e1866 > 0u) {
                            let _e1868 = (3u < _e100);
                            if _e1868 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1872 = atomicAdd((&global_6.member[2u]), _e1866);
                                if ((_e1872 + _e1866) < _e1872) {
                                    if _e1868 {
                                    } else {
                                        break;
                                    }
                                    let _e1877 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1847.member_1 > 0u) {
                            let _e1879 = (5u < _e100);
                            if _e1879 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1883 = atomicAdd((&global_6.member[4u]), _e1847.member_1);
                                if ((_e1883 + _e1847.member_1) < _e1883) {
                                    if _e1879 {
                                    } else {
                                        break;
                                    }
                                    let _e1888 = atomicAdd((&global_6.member[5u]), 1u);
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
