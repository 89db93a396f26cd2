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
    var phi_425_: i32;
    var phi_426_: i32;
    var phi_436_: bool;
    var phi_446_: u32;
    var phi_447_: u32;
    var phi_449_: bool;
    var phi_454_: u32;
    var phi_486_: i32;
    var phi_504_: f32;
    var phi_510_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_608_: f32;
    var phi_619_: f32;
    var phi_628_: f32;
    var phi_634_: f32;
    var phi_674_: f32;
    var phi_680_: f32;
    var phi_732_: f32;
    var phi_743_: f32;
    var phi_752_: f32;
    var phi_758_: f32;
    var phi_798_: f32;
    var phi_804_: f32;
    var phi_856_: f32;
    var phi_867_: f32;
    var phi_922_: i32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_982_: i32;
    var phi_1004_: u32;
    var phi_1005_: u32;
    var phi_1013_: f32;
    var phi_1014_: f32;
    var phi_3541_: bool;
    var phi_1096_: type_41;
    var phi_1099_: type_52;
    var phi_1101_: u32;
    var phi_1103_: bool;
    var phi_1105_: u32;
    var phi_1116_: bool;
    var phi_1202_: type_52;
    var phi_1203_: bool;
    var phi_1204_: u32;
    var phi_2258_: type_45;
    var phi_3114_: type_52;
    var phi_3191_: type_52;
    var phi_3192_: type_52;
    var phi_3193_: u32;
    var phi_3195_: type_52;
    var phi_3196_: u32;
    var phi_3197_: bool;
    var phi_3204_: type_52;
    var phi_3209_: type_52;
    var phi_3210_: bool;
    var phi_1222_: type_41;
    var phi_1225_: type_7;
    var phi_1226_: type_7;
    var phi_1248_: type_7;
    var phi_1272_: u32;
    var phi_1361_: array<array<f32, 3>, 3>;
    var phi_1478_: bool;
    var phi_1507_: bool;
    var phi_1908_: f32;
    var phi_1909_: f32;
    var phi_1910_: f32;
    var phi_1911_: f32;
    var phi_1912_: vec3<f32>;
    var phi_1913_: vec3<f32>;
    var phi_1914_: vec3<f32>;
    var phi_1915_: vec3<f32>;
    var phi_1946_: bool;
    var phi_1955_: vec3<f32>;
    var phi_2120_: f32;
    var phi_2122_: f32;
    var phi_2123_: bool;
    var phi_2143_: f32;
    var phi_2144_: f32;
    var phi_2167_: type_23;
    var phi_2169_: type_23;
    var phi_2170_: bool;
    var phi_2174_: type_23;
    var phi_2175_: type_23;
    var phi_2176_: type_23;
    var phi_2177_: bool;
    var phi_2181_: type_23;
    var phi_2182_: bool;
    var phi_2183_: type_23;
    var phi_2184_: bool;
    var phi_2185_: bool;
    var phi_2186_: type_23;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2196_: type_23;
    var phi_2197_: bool;
    var phi_2201_: type_23;
    var phi_2226_: bool;
    var phi_2227_: bool;
    var phi_2234_: type_41;
    var phi_2235_: type_41;
    var phi_2236_: type_41;
    var phi_1223_: type_41;
    var phi_3535_: bool;
    var phi_3699_: bool;
    var phi_3212_: type_41;
    var phi_3213_: type_52;
    var phi_3214_: bool;
    var phi_3215_: u32;
    var phi_3698_: bool;
    var phi_3216_: type_41;
    var phi_3217_: type_52;
    var phi_3218_: u32;
    var phi_3219_: bool;
    var phi_3220_: u32;
    var phi_3697_: bool;
    var phi_3221_: type_41;
    var phi_3222_: type_52;
    var phi_3223_: u32;
    var phi_3224_: bool;
    var phi_3225_: u32;
    var phi_3696_: bool;
    var phi_1097_: type_41;
    var phi_1100_: type_52;
    var phi_1102_: u32;
    var phi_1104_: bool;
    var phi_1106_: u32;
    var phi_3226_: bool;
    var phi_3695_: bool;
    var local_10: type_41;
    var phi_3264_: f32;
    var phi_3266_: f32;
    var phi_3267_: bool;
    var phi_3268_: f32;
    var phi_3269_: bool;
    var phi_3455_: u32;
    var phi_3473_: bool;
    var phi_3476_: bool;
    var phi_3489_: f32;
    var phi_3490_: f32;
    var phi_3495_: f32;
    var phi_3496_: f32;
    var phi_3497_: bool;
    var phi_3505_: f32;
    var phi_3284_: f32;
    var phi_3285_: f32;
    var phi_3297_: f32;
    var phi_3302_: type_23;
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
                                phi_425_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_425_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            }
                            let _e241 = phi_425_;
                            phi_426_ = _e241;
                        } else {
                            phi_426_ = 0i;
                        }
                        let _e243 = phi_426_;
                        let _e244 = (_e153 == _e197);
                        if _e244 {
                            phi_436_ = true;
                        } else {
                            phi_436_ = (_e161 == _e197);
                        }
                        let _e247 = phi_436_;
                        let _e248 = select(1u, 0u, _e244);
                        if _e247 {
                            let _e249 = (_e248 + 1u);
                            phi_446_ = _e249;
                            phi_447_ = _e249;
                            phi_449_ = select(true, false, (_e249 == 2u));
                        } else {
                            phi_446_ = u32();
                            phi_447_ = 0u;
                            phi_449_ = true;
                        }
                        let _e253 = phi_446_;
                        let _e255 = phi_447_;
                        let _e257 = phi_449_;
                        if _e257 {
                            phi_454_ = (_e255 + 1u);
                        } else {
                            phi_454_ = 0u;
                        }
                        let _e261 = phi_454_;
                        let _e262 = select(_e253, _e255, _e257);
                        let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                        let _e264 = -(_e243);
                        if (_e264 < -126i) {
                            phi_486_ = -126i;
                        } else {
                            phi_486_ = select(_e264, 127i, (_e264 > 127i));
                        }
                        let _e269 = phi_486_;
                        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                        let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                        let _e285 = global_4.member[_e132].member.member;
                        let _e286 = (_e262 == 0u);
                        if _e286 {
                            phi_504_ = _e285[0];
                        } else {
                            phi_504_ = _e285[1];
                        }
                        let _e290 = phi_504_;
                        let _e291 = (_e262 == 2u);
                        if _e291 {
                            phi_510_ = _e285[2];
                        } else {
                            phi_510_ = _e290;
                        }
                        let _e294 = phi_510_;
                        let _e295 = bitcast<u32>(_e294);
                        let _e297 = ((_e295 & 2139095040u) != 0u);
                        let _e309 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e294, _e297) * select(0.00000011920929f, 1f, _e297));
                        let _e310 = global_4.member[_e132].member.member_2;
                        if _e286 {
                            phi_550_ = _e310[0];
                        } else {
                            phi_550_ = _e310[1];
                        }
                        let _e314 = phi_550_;
                        if _e291 {
                            phi_556_ = _e310[2];
                        } else {
                            phi_556_ = _e314;
                        }
                        let _e317 = phi_556_;
                        let _e318 = bitcast<u32>(_e317);
                        let _e320 = ((_e318 & 2139095040u) != 0u);
                        let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e274) * select(0.00000011920929f, 1f, _e320)) * _e280);
                        let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e338 {
                            let _e342 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                            phi_608_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                        } else {
                            phi_608_ = 0f;
                        }
                        let _e346 = phi_608_;
                        let _e347 = (_e309 + _e346);
                        let _e348 = (_e309 - _e346);
                        let _e349 = select(_e334, 0f, _e338);
                        if _e338 {
                            phi_619_ = 38685626000000000000000000f;
                        } else {
                            phi_619_ = (1f / _e334);
                        }
                        let _e352 = phi_619_;
                        let _e353 = (_e261 == 0u);
                        if _e353 {
                            phi_628_ = _e285[0];
                        } else {
                            phi_628_ = _e285[1];
                        }
                        let _e357 = phi_628_;
                        let _e358 = (_e261 == 2u);
                        if _e358 {
                            phi_634_ = _e285[2];
                        } else {
                            phi_634_ = _e357;
                        }
                        let _e361 = phi_634_;
                        let _e362 = bitcast<u32>(_e361);
                        let _e364 = ((_e362 & 2139095040u) != 0u);
                        let _e376 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * select(0.00000011920929f, 1f, _e364));
                        if _e353 {
                            phi_674_ = _e310[0];
                        } else {
                            phi_674_ = _e310[1];
                        }
                        let _e380 = phi_674_;
                        if _e358 {
                            phi_680_ = _e310[2];
                        } else {
                            phi_680_ = _e380;
                        }
                        let _e383 = phi_680_;
                        let _e384 = bitcast<u32>(_e383);
                        let _e386 = ((_e384 & 2139095040u) != 0u);
                        let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e274) * select(0.00000011920929f, 1f, _e386)) * _e280);
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e404 {
                            let _e408 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                            phi_732_ = select(0.00000000000011368684f, _e408, (_e408 > 0.00000000000011368684f));
                        } else {
                            phi_732_ = 0f;
                        }
                        let _e412 = phi_732_;
                        let _e413 = (_e376 + _e412);
                        let _e414 = (_e376 - _e412);
                        let _e415 = select(_e400, 0f, _e404);
                        if _e404 {
                            phi_743_ = 38685626000000000000000000f;
                        } else {
                            phi_743_ = (1f / _e400);
                        }
                        let _e418 = phi_743_;
                        let _e419 = (_e263 == 0u);
                        if _e419 {
                            phi_752_ = _e285[0];
                        } else {
                            phi_752_ = _e285[1];
                        }
                        let _e423 = phi_752_;
                        let _e424 = (_e263 == 2u);
                        if _e424 {
                            phi_758_ = _e285[2];
                        } else {
                            phi_758_ = _e423;
                        }
                        let _e427 = phi_758_;
                        let _e428 = bitcast<u32>(_e427);
                        let _e430 = ((_e428 & 2139095040u) != 0u);
                        let _e442 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e428 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e428 & 2147483648u))), _e427, _e430) * select(0.00000011920929f, 1f, _e430));
                        if _e419 {
                            phi_798_ = _e310[0];
                        } else {
                            phi_798_ = _e310[1];
                        }
                        let _e446 = phi_798_;
                        if _e424 {
                            phi_804_ = _e310[2];
                        } else {
                            phi_804_ = _e446;
                        }
                        let _e449 = phi_804_;
                        let _e450 = bitcast<u32>(_e449);
                        let _e452 = ((_e450 & 2139095040u) != 0u);
                        let _e466 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e450 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e450 & 2147483648u))), _e449, _e452) * _e274) * select(0.00000011920929f, 1f, _e452)) * _e280);
                        let _e470 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e470 {
                            let _e474 = (bitcast<f32>((bitcast<u32>(_e442) & 2147483647u)) * 0.00000011920929f);
                            phi_856_ = select(0.00000000000011368684f, _e474, (_e474 > 0.00000000000011368684f));
                        } else {
                            phi_856_ = 0f;
                        }
                        let _e478 = phi_856_;
                        let _e479 = (_e442 + _e478);
                        let _e480 = (_e442 - _e478);
                        let _e481 = select(_e466, 0f, _e470);
                        if _e470 {
                            phi_867_ = 38685626000000000000000000f;
                        } else {
                            phi_867_ = (1f / _e466);
                        }
                        let _e484 = phi_867_;
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
                                phi_922_ = 255i;
                            } else {
                                phi_922_ = (((_e510 + select(0i, 1i, (_e510 == 0i))) - _e517) + _e243);
                            }
                            let _e525 = phi_922_;
                            let _e535 = (_e525 <= 0i);
                            if _e535 {
                                phi_945_ = u32();
                            } else {
                                if _e514 {
                                    phi_944_ = u32();
                                } else {
                                    phi_944_ = select(((bitcast<u32>(_e525) << bitcast<u32>(23i)) | ((_e507 << bitcast<u32>(((_e517 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e525 >= 255i));
                                }
                                let _e539 = phi_944_;
                                phi_945_ = _e539;
                            }
                            let _e541 = phi_945_;
                            let _e553 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e556 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                            let _e560 = (_e553 == 0u);
                            let _e563 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e553)), 32u, _e560)) - 8i);
                            if (_e556 == 255i) {
                                phi_982_ = 255i;
                            } else {
                                phi_982_ = (((_e556 + select(0i, 1i, (_e556 == 0i))) - _e563) + _e243);
                            }
                            let _e571 = phi_982_;
                            let _e581 = (_e571 <= 0i);
                            if _e581 {
                                phi_1005_ = u32();
                            } else {
                                if _e560 {
                                    phi_1004_ = u32();
                                } else {
                                    phi_1004_ = select(((bitcast<u32>(_e571) << bitcast<u32>(23i)) | ((_e553 << bitcast<u32>(((_e563 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e571 >= 255i));
                                }
                                let _e585 = phi_1004_;
                                phi_1005_ = _e585;
                            }
                            let _e587 = phi_1005_;
                            phi_1013_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e587, 0u, select(_e560, true, _e581))));
                            phi_1014_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e541, 0u, select(_e514, true, _e535))));
                        } else {
                            phi_1013_ = 0f;
                            phi_1014_ = 1f;
                        }
                        let _e593 = phi_1013_;
                        let _e595 = phi_1014_;
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
                        phi_3541_ = false;
                        phi_1096_ = type_41(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e593), 0u, 0u);
                        phi_1099_ = type_52(type_50(array<f32, 3>(_e608, _e612, _e616), array<f32, 3>(_e620, _e622, _e624)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_1101_ = ((3u * _e90) + 1u);
                        phi_1103_ = (_e595 <= _e593);
                        phi_1105_ = 0u;
                        loop {
                            let _e632 = phi_3541_;
                            let _e634 = phi_1096_;
                            let _e636 = phi_1099_;
                            let _e638 = phi_1101_;
                            let _e640 = phi_1103_;
                            let _e642 = phi_1105_;
                            local_10 = _e634;
                            local_11 = _e634;
                            if _e640 {
                                phi_1116_ = true;
                            } else {
                                phi_1116_ = (_e642 > 0u);
                            }
                            let _e645 = phi_1116_;
                            if _e645 {
                                let _e646 = (_e638 > 0u);
                                if _e646 {
                                    if _e640 {
                                        phi_1202_ = _e636;
                                        phi_1203_ = _e640;
                                        phi_1204_ = _e642;
                                    } else {
                                        let _e647 = (_e642 - 1u);
                                        let _e648 = (_e647 % 128u);
                                        let _e649 = (_e648 < 128u);
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e651 = local_6[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e653 = local_5[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e655 = local_4[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e657 = local_3[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e660 = local_2[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e662 = local_1[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e664 = local[_e648];
                                        if _e649 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e669 = local_7[_e648];
                                        phi_1202_ = type_52(type_50(array<f32, 3>(_e653, _e655, _e657), array<f32, 3>(_e660, _e662, _e664)), _e651);
                                        phi_1203_ = (_e669 <= _e634.member.member_1);
                                        phi_1204_ = _e647;
                                    }
                                    let _e674 = phi_1202_;
                                    let _e676 = phi_1203_;
                                    let _e678 = phi_1204_;
                                    if _e676 {
                                        if ((_e674.member_1 & 2147483648u) != 0u) {
                                            phi_1222_ = _e634;
                                            phi_1225_ = type_7(0u, ((_e674.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1061 = phi_1222_;
                                                let _e1063 = phi_1225_;
                                                local_12 = _e1061;
                                                if (_e1063.member < _e1063.member_1) {
                                                    phi_1226_ = type_7((_e1063.member + 1u), _e1063.member_1);
                                                    phi_1248_ = type_7(1u, _e1063.member);
                                                } else {
                                                    phi_1226_ = _e1063;
                                                    phi_1248_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1076 = phi_1226_;
                                                let _e1078 = phi_1248_;
                                                let _e1082 = (bitcast<i32>(_e1078.member) != 0i);
                                                if _e1082 {
                                                    let _e1088 = type_41(_e1061.member, _e1061.member_1, (_e1061.member_2 + 1u));
                                                    let _e1089 = ((_e674.member_1 & 268435455u) + _e1078.member_1);
                                                    let _e1090 = (_e1089 < _e92);
                                                    if _e1090 {
                                                        if _e1090 {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1094 = global_1.member[_e1089].member_1;
                                                        phi_1272_ = _e1094;
                                                    } else {
                                                        phi_1272_ = 4294967295u;
                                                    }
                                                    let _e1096 = phi_1272_;
                                                    if (_e1089 >= _e92) {
                                                        phi_1361_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1090 {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        if (_e605 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1103 = global_1.member[_e1089].member[_e605];
                                                        if (_e609 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1109 = global_1.member[_e1089].member[_e609];
                                                        if (_e613 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1115 = global_1.member[_e1089].member[_e613];
                                                        let _e1117 = (3u + _e605);
                                                        if (_e1117 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1123 = global_1.member[_e1089].member[_e1117];
                                                        let _e1124 = (3u + _e609);
                                                        if (_e1124 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1130 = global_1.member[_e1089].member[_e1124];
                                                        let _e1131 = (3u + _e613);
                                                        if (_e1131 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1137 = global_1.member[_e1089].member[_e1131];
                                                        let _e1139 = (6u + _e605);
                                                        if (_e1139 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1145 = global_1.member[_e1089].member[_e1139];
                                                        let _e1146 = (6u + _e609);
                                                        if (_e1146 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1152 = global_1.member[_e1089].member[_e1146];
                                                        let _e1153 = (6u + _e613);
                                                        if (_e1153 < 9u) {
                                                        } else {
                                                            phi_3535_ = true;
                                                            break;
                                                        }
                                                        let _e1159 = global_1.member[_e1089].member[_e1153];
                                                        phi_1361_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1103, _e1109, _e1115), array<f32, 3>(_e1123, _e1130, _e1137), array<f32, 3>(_e1145, _e1152, _e1159));
                                                    }
                                                    let _e1163 = phi_1361_;
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
                                                            phi_2186_ = type_23();
                                                            phi_2187_ = true;
                                                            phi_2188_ = false;
                                                        } else {
                                                            let _e1239 = select(_e1188, _e1175, (_e1175 < _e1188));
                                                            if (select(_e1201, _e1239, (_e1239 < _e1201)) > 0f) {
                                                                phi_1478_ = true;
                                                            } else {
                                                                let _e1244 = select(_e1188, _e1175, (_e1175 > _e1188));
                                                                phi_1478_ = (select(_e1201, _e1244, (_e1244 > _e1201)) < 0f);
                                                            }
                                                            let _e1249 = phi_1478_;
                                                            if _e1249 {
                                                                phi_2183_ = type_23();
                                                                phi_2184_ = true;
                                                                phi_2185_ = false;
                                                            } else {
                                                                let _e1251 = select(_e1191, _e1178, (_e1178 < _e1191));
                                                                if (select(_e1204, _e1251, (_e1251 < _e1204)) > 0f) {
                                                                    phi_1507_ = true;
                                                                } else {
                                                                    let _e1256 = select(_e1191, _e1178, (_e1178 > _e1191));
                                                                    phi_1507_ = (select(_e1204, _e1256, (_e1256 > _e1204)) < 0f);
                                                                }
                                                                let _e1261 = phi_1507_;
                                                                if _e1261 {
                                                                    phi_2181_ = type_23();
                                                                    phi_2182_ = false;
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
                                                                        phi_2176_ = type_23();
                                                                        phi_2177_ = true;
                                                                    } else {
                                                                        let _e1326 = (_e1324 > _e1061.member.member_1);
                                                                        if _e1326 {
                                                                            phi_2175_ = type_23();
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
                                                                                phi_1908_ = _e1191;
                                                                                phi_1909_ = _e1188;
                                                                                phi_1910_ = _e1178;
                                                                                phi_1911_ = _e1175;
                                                                                phi_1912_ = _e1327;
                                                                                phi_1913_ = _e1341;
                                                                                phi_1914_ = _e1337;
                                                                                phi_1915_ = _e1333;
                                                                            } else {
                                                                                let _e1386 = (_e1367 == _e1384);
                                                                                let _e1391 = vec3(_e1386);
                                                                                phi_1908_ = select(_e1178, _e1204, _e1386);
                                                                                phi_1909_ = select(_e1175, _e1201, _e1386);
                                                                                phi_1910_ = select(_e1204, _e1191, _e1386);
                                                                                phi_1911_ = select(_e1201, _e1188, _e1386);
                                                                                phi_1912_ = select(_e1329, _e1328, _e1391);
                                                                                phi_1913_ = select(_e1337, _e1333, _e1391);
                                                                                phi_1914_ = select(_e1333, _e1341, _e1391);
                                                                                phi_1915_ = select(_e1341, _e1337, _e1391);
                                                                            }
                                                                            let _e1397 = phi_1908_;
                                                                            let _e1399 = phi_1909_;
                                                                            let _e1401 = phi_1910_;
                                                                            let _e1403 = phi_1911_;
                                                                            let _e1405 = phi_1912_;
                                                                            let _e1407 = phi_1913_;
                                                                            let _e1409 = phi_1914_;
                                                                            let _e1411 = phi_1915_;
                                                                            let _e1418 = ((_e1409.y * _e1407.z) - (_e1407.y * _e1409.z));
                                                                            let _e1423 = ((_e1409.z * _e1407.x) - (_e1407.z * _e1409.x));
                                                                            let _e1426 = ((_e1409.x * _e1407.y) - (_e1407.x * _e1409.y));
                                                                            if (_e1226 >= _e1230) {
                                                                                phi_1946_ = select(true, false, (_e1226 >= _e1234));
                                                                            } else {
                                                                                phi_1946_ = true;
                                                                            }
                                                                            let _e1431 = phi_1946_;
                                                                            if _e1431 {
                                                                                phi_1955_ = select(_e1329, _e1328, vec3((_e1230 >= _e1234)));
                                                                            } else {
                                                                                phi_1955_ = _e1327;
                                                                            }
                                                                            let _e1436 = phi_1955_;
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
                                                                                    phi_2120_ = (_e1447 / _e1452);
                                                                                } else {
                                                                                    phi_2120_ = f32();
                                                                                }
                                                                                let _e1557 = phi_2120_;
                                                                                phi_2122_ = _e1557;
                                                                                phi_2123_ = select(true, false, _e1554);
                                                                            } else {
                                                                                phi_2122_ = f32();
                                                                                phi_2123_ = true;
                                                                            }
                                                                            let _e1560 = phi_2122_;
                                                                            let _e1562 = phi_2123_;
                                                                            if _e1562 {
                                                                                let _e1570 = (((_e1418 * (_e1479 - (_e349 * _e1482))) + (_e1423 * (_e1480 - (_e415 * _e1482)))) / _e1452);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u)) <= _e1384) {
                                                                                    phi_2143_ = (_e1482 + _e1570);
                                                                                } else {
                                                                                    phi_2143_ = _e1482;
                                                                                }
                                                                                let _e1577 = phi_2143_;
                                                                                phi_2144_ = _e1577;
                                                                            } else {
                                                                                phi_2144_ = _e1560;
                                                                            }
                                                                            let _e1579 = phi_2144_;
                                                                            let _e1581 = select(_e1317, _e1579, (_e1579 < _e1317));
                                                                            let _e1583 = select(_e1309, _e1581, (_e1581 > _e1309));
                                                                            if (_e1583 >= _e595) {
                                                                                let _e1585 = (_e1583 <= _e1061.member.member_1);
                                                                                if _e1585 {
                                                                                    let _e1586 = (1f / _e1236);
                                                                                    phi_2167_ = type_23(_e1583, (_e1230 * _e1586), (_e1234 * _e1586), _e1096);
                                                                                } else {
                                                                                    phi_2167_ = type_23();
                                                                                }
                                                                                let _e1591 = phi_2167_;
                                                                                phi_2169_ = _e1591;
                                                                                phi_2170_ = select(true, false, _e1585);
                                                                            } else {
                                                                                phi_2169_ = type_23();
                                                                                phi_2170_ = true;
                                                                            }
                                                                            let _e1594 = phi_2169_;
                                                                            let _e1596 = phi_2170_;
                                                                            if _e1596 {
                                                                                phi_2174_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2174_ = _e1594;
                                                                            }
                                                                            let _e1598 = phi_2174_;
                                                                            phi_2175_ = _e1598;
                                                                        }
                                                                        let _e1600 = phi_2175_;
                                                                        phi_2176_ = _e1600;
                                                                        phi_2177_ = _e1326;
                                                                    }
                                                                    let _e1602 = phi_2176_;
                                                                    let _e1604 = phi_2177_;
                                                                    phi_2181_ = _e1602;
                                                                    phi_2182_ = _e1604;
                                                                }
                                                                let _e1606 = phi_2181_;
                                                                let _e1608 = phi_2182_;
                                                                phi_2183_ = _e1606;
                                                                phi_2184_ = _e1261;
                                                                phi_2185_ = _e1608;
                                                            }
                                                            let _e1610 = phi_2183_;
                                                            let _e1612 = phi_2184_;
                                                            let _e1614 = phi_2185_;
                                                            phi_2186_ = _e1610;
                                                            phi_2187_ = _e1612;
                                                            phi_2188_ = _e1614;
                                                        }
                                                        let _e1616 = phi_2186_;
                                                        let _e1618 = phi_2187_;
                                                        let _e1620 = phi_2188_;
                                                        phi_2196_ = _e1616;
                                                        phi_2197_ = select(_e1620, true, _e1618);
                                                    } else {
                                                        phi_2196_ = type_23();
                                                        phi_2197_ = true;
                                                    }
                                                    let _e1623 = phi_2196_;
                                                    let _e1625 = phi_2197_;
                                                    if _e1625 {
                                                        phi_2201_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2201_ = _e1623;
                                                    }
                                                    let _e1627 = phi_2201_;
                                                    if (_e1627.member_3 != 4294967295u) {
                                                        if (_e1096 != _e601) {
                                                            if (_e1627.member < _e1061.member.member.member) {
                                                                phi_2227_ = true;
                                                            } else {
                                                                if (_e1627.member == _e1061.member.member.member) {
                                                                    phi_2226_ = (_e1627.member_3 < _e1061.member.member.member_3);
                                                                } else {
                                                                    phi_2226_ = false;
                                                                }
                                                                let _e1642 = phi_2226_;
                                                                phi_2227_ = _e1642;
                                                            }
                                                            let _e1644 = phi_2227_;
                                                            if _e1644 {
                                                                phi_2234_ = type_41(type_38(_e1627, _e1627.member), _e1088.member_1, _e1088.member_2);
                                                            } else {
                                                                phi_2234_ = _e1088;
                                                            }
                                                            let _e1651 = phi_2234_;
                                                            phi_2235_ = _e1651;
                                                        } else {
                                                            phi_2235_ = _e1088;
                                                        }
                                                        let _e1653 = phi_2235_;
                                                        phi_2236_ = _e1653;
                                                    } else {
                                                        phi_2236_ = _e1088;
                                                    }
                                                    let _e1655 = phi_2236_;
                                                    phi_1223_ = _e1655;
                                                } else {
                                                    phi_1223_ = type_41();
                                                }
                                                let _e1657 = phi_1223_;
                                                continue;
                                                continuing {
                                                    phi_1222_ = _e1657;
                                                    phi_1225_ = _e1076;
                                                    phi_3535_ = _e632;
                                                    break if !(_e1082);
                                                }
                                            }
                                            let _e1660 = phi_3535_;
                                            phi_3695_ = _e1660;
                                            if _e1660 {
                                                break;
                                            }
                                            phi_3699_ = _e1660;
                                            let _e1988 = local_12;
                                            phi_3212_ = _e1988;
                                            phi_3213_ = _e674;
                                            phi_3214_ = false;
                                            phi_3215_ = _e678;
                                        } else {
                                            let _e693 = (_e674.member_1 < _e90);
                                            if _e693 {
                                                if _e693 {
                                                } else {
                                                    phi_3695_ = true;
                                                    break;
                                                }
                                                let _e695 = global_7.member[_e674.member_1];
                                                phi_2258_ = _e695;
                                            } else {
                                                phi_2258_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e697 = phi_2258_;
                                            let _e712 = ((10u * _e262) & 31u);
                                            let _e715 = ((_e697.member[0] >> bitcast<u32>(_e712)) & 1023u);
                                            let _e723 = bitcast<f32>((bitcast<u32>(((_e674.member.member_1[0] - _e674.member.member[0]) * 0.0009775171f)) ^ _e128));
                                            let _e728 = (_e674.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e715)) - 8388608f) * _e723)) ^ _e128)));
                                            let _e732 = select(select(_e674.member.member_1[0], _e728, (_e728 < _e674.member.member_1[0])), _e674.member.member_1[0], (_e715 == 1023u));
                                            let _e734 = ((10u * _e261) & 31u);
                                            let _e737 = ((_e697.member[0] >> bitcast<u32>(_e734)) & 1023u);
                                            let _e745 = bitcast<f32>((bitcast<u32>(((_e674.member.member_1[1] - _e674.member.member[1]) * 0.0009775171f)) ^ _e128));
                                            let _e750 = (_e674.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e737)) - 8388608f) * _e745)) ^ _e128)));
                                            let _e754 = select(select(_e674.member.member_1[1], _e750, (_e750 < _e674.member.member_1[1])), _e674.member.member_1[1], (_e737 == 1023u));
                                            let _e756 = ((10u * _e263) & 31u);
                                            let _e759 = ((_e697.member[0] >> bitcast<u32>(_e756)) & 1023u);
                                            let _e767 = bitcast<f32>((bitcast<u32>(((_e674.member.member_1[2] - _e674.member.member[2]) * 0.0009775171f)) ^ _e128));
                                            let _e772 = (_e674.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e759)) - 8388608f) * _e767)) ^ _e128)));
                                            let _e776 = select(select(_e674.member.member_1[2], _e772, (_e772 < _e674.member.member_1[2])), _e674.member.member_1[2], (_e759 == 1023u));
                                            let _e779 = ((_e697.member[1] >> bitcast<u32>(_e712)) & 1023u);
                                            let _e787 = (_e674.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e779)) - 8388608f) * _e723)) ^ _e128)));
                                            let _e791 = select(select(_e674.member.member_1[0], _e787, (_e787 < _e674.member.member_1[0])), _e674.member.member_1[0], (_e779 == 1023u));
                                            let _e794 = ((_e697.member[1] >> bitcast<u32>(_e734)) & 1023u);
                                            let _e802 = (_e674.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e794)) - 8388608f) * _e745)) ^ _e128)));
                                            let _e806 = select(select(_e674.member.member_1[1], _e802, (_e802 < _e674.member.member_1[1])), _e674.member.member_1[1], (_e794 == 1023u));
                                            let _e809 = ((_e697.member[1] >> bitcast<u32>(_e756)) & 1023u);
                                            let _e817 = (_e674.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e809)) - 8388608f) * _e767)) ^ _e128)));
                                            let _e821 = select(select(_e674.member.member_1[2], _e817, (_e817 < _e674.member.member_1[2])), _e674.member.member_1[2], (_e809 == 1023u));
                                            let _e827 = ((_e697.member_1[0] >> bitcast<u32>(_e712)) & 1023u);
                                            let _e835 = (_e674.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e827)) - 8388608f) * _e723)) ^ _e128)));
                                            let _e839 = select(select(_e674.member.member_1[0], _e835, (_e835 < _e674.member.member_1[0])), _e674.member.member_1[0], (_e827 == 1023u));
                                            let _e842 = ((_e697.member_1[0] >> bitcast<u32>(_e734)) & 1023u);
                                            let _e850 = (_e674.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e842)) - 8388608f) * _e745)) ^ _e128)));
                                            let _e854 = select(select(_e674.member.member_1[1], _e850, (_e850 < _e674.member.member_1[1])), _e674.member.member_1[1], (_e842 == 1023u));
                                            let _e857 = ((_e697.member_1[0] >> bitcast<u32>(_e756)) & 1023u);
                                            let _e865 = (_e674.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e857)) - 8388608f) * _e767)) ^ _e128)));
                                            let _e869 = select(select(_e674.member.member_1[2], _e865, (_e865 < _e674.member.member_1[2])), _e674.member.member_1[2], (_e857 == 1023u));
                                            let _e872 = ((_e697.member_1[1] >> bitcast<u32>(_e712)) & 1023u);
                                            let _e880 = (_e674.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e872)) - 8388608f) * _e723)) ^ _e128)));
                                            let _e884 = select(select(_e674.member.member_1[0], _e880, (_e880 < _e674.member.member_1[0])), _e674.member.member_1[0], (_e872 == 1023u));
                                            let _e887 = ((_e697.member_1[1] >> bitcast<u32>(_e734)) & 1023u);
                                            let _e895 = (_e674.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e887)) - 8388608f) * _e745)) ^ _e128)));
                                            let _e899 = select(select(_e674.member.member_1[1], _e895, (_e895 < _e674.member.member_1[1])), _e674.member.member_1[1], (_e887 == 1023u));
                                            let _e902 = ((_e697.member_1[1] >> bitcast<u32>(_e756)) & 1023u);
                                            let _e910 = (_e674.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e902)) - 8388608f) * _e767)) ^ _e128)));
                                            let _e914 = select(select(_e674.member.member_1[2], _e910, (_e910 < _e674.member.member_1[2])), _e674.member.member_1[2], (_e902 == 1023u));
                                            let _e919 = type_52(type_50(array<f32, 3>(_e732, _e754, _e776), array<f32, 3>(_e791, _e806, _e821)), _e697.member_2);
                                            let _e924 = type_52(type_50(array<f32, 3>(_e839, _e854, _e869), array<f32, 3>(_e884, _e899, _e914)), _e697.member_3);
                                            let _e931 = ((_e732 - _e347) * _e352);
                                            let _e932 = ((_e839 - _e347) * _e352);
                                            let _e933 = ((_e791 - _e348) * _e352);
                                            let _e934 = ((_e884 - _e348) * _e352);
                                            let _e939 = ((_e754 - _e413) * _e418);
                                            let _e940 = ((_e854 - _e413) * _e418);
                                            let _e941 = ((_e806 - _e414) * _e418);
                                            let _e942 = ((_e899 - _e414) * _e418);
                                            let _e947 = ((_e776 - _e479) * _e484);
                                            let _e948 = ((_e869 - _e479) * _e484);
                                            let _e949 = ((_e821 - _e480) * _e484);
                                            let _e950 = ((_e914 - _e480) * _e484);
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
                                                        phi_3114_ = _e924;
                                                    } else {
                                                        phi_3114_ = _e919;
                                                    }
                                                    let _e1013 = phi_3114_;
                                                    let _e1021 = (_e678 % 128u);
                                                    let _e1022 = (_e1021 < 128u);
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1021] = _e1013.member_1;
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1021] = _e1013.member.member[0];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1021] = _e1013.member.member[1];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1021] = _e1013.member.member[2];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1021] = _e1013.member.member_1[0];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1021] = _e1013.member.member_1[1];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local[_e1021] = _e1013.member.member_1[2];
                                                    if _e1022 {
                                                    } else {
                                                        phi_3695_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1021] = select(_e1004, _e1002, (_e1002 > _e1004));
                                                    if _e1011 {
                                                        phi_3191_ = _e919;
                                                    } else {
                                                        phi_3191_ = _e924;
                                                    }
                                                    let _e1039 = phi_3191_;
                                                    phi_3192_ = _e1039;
                                                    phi_3193_ = (_e678 + 1u);
                                                } else {
                                                    phi_3192_ = type_52();
                                                    phi_3193_ = u32();
                                                }
                                                let _e1041 = phi_3192_;
                                                let _e1043 = phi_3193_;
                                                phi_3195_ = _e1041;
                                                phi_3196_ = _e1043;
                                                phi_3197_ = select(true, false, _e1010);
                                            } else {
                                                phi_3195_ = type_52();
                                                phi_3196_ = u32();
                                                phi_3197_ = true;
                                            }
                                            let _e1046 = phi_3195_;
                                            let _e1048 = phi_3196_;
                                            let _e1050 = phi_3197_;
                                            if _e1050 {
                                                if _e1009 {
                                                    phi_3204_ = _e919;
                                                } else {
                                                    phi_3204_ = _e924;
                                                }
                                                let _e1052 = phi_3204_;
                                                phi_3209_ = _e1052;
                                                phi_3210_ = select(_e1010, true, _e1009);
                                            } else {
                                                phi_3209_ = _e1046;
                                                phi_3210_ = _e676;
                                            }
                                            let _e1055 = phi_3209_;
                                            let _e1057 = phi_3210_;
                                            phi_3699_ = _e632;
                                            phi_3212_ = type_41(_e634.member, (_e634.member_1 + 1u), _e634.member_2);
                                            phi_3213_ = _e1055;
                                            phi_3214_ = _e1057;
                                            phi_3215_ = select(_e1048, _e678, _e1050);
                                        }
                                        let _e1662 = phi_3699_;
                                        let _e1664 = phi_3212_;
                                        let _e1666 = phi_3213_;
                                        let _e1668 = phi_3214_;
                                        let _e1670 = phi_3215_;
                                        phi_3698_ = _e1662;
                                        phi_3216_ = _e1664;
                                        phi_3217_ = _e1666;
                                        phi_3218_ = (_e638 - 1u);
                                        phi_3219_ = _e1668;
                                        phi_3220_ = _e1670;
                                    } else {
                                        phi_3698_ = _e632;
                                        phi_3216_ = _e634;
                                        phi_3217_ = _e674;
                                        phi_3218_ = _e638;
                                        phi_3219_ = _e676;
                                        phi_3220_ = _e678;
                                    }
                                    let _e1672 = phi_3698_;
                                    let _e1674 = phi_3216_;
                                    let _e1676 = phi_3217_;
                                    let _e1678 = phi_3218_;
                                    let _e1680 = phi_3219_;
                                    let _e1682 = phi_3220_;
                                    phi_3697_ = _e1672;
                                    phi_3221_ = _e1674;
                                    phi_3222_ = _e1676;
                                    phi_3223_ = _e1678;
                                    phi_3224_ = _e1680;
                                    phi_3225_ = _e1682;
                                } else {
                                    phi_3697_ = _e632;
                                    phi_3221_ = type_41();
                                    phi_3222_ = type_52();
                                    phi_3223_ = u32();
                                    phi_3224_ = bool();
                                    phi_3225_ = u32();
                                }
                                let _e1684 = phi_3697_;
                                let _e1686 = phi_3221_;
                                let _e1688 = phi_3222_;
                                let _e1690 = phi_3223_;
                                let _e1692 = phi_3224_;
                                let _e1694 = phi_3225_;
                                phi_3696_ = _e1684;
                                phi_1097_ = _e1686;
                                phi_1100_ = _e1688;
                                phi_1102_ = _e1690;
                                phi_1104_ = _e1692;
                                phi_1106_ = _e1694;
                                phi_3226_ = _e646;
                            } else {
                                phi_3696_ = _e632;
                                phi_1097_ = type_41();
                                phi_1100_ = type_52();
                                phi_1102_ = u32();
                                phi_1104_ = bool();
                                phi_1106_ = u32();
                                phi_3226_ = false;
                            }
                            let _e1696 = phi_3696_;
                            let _e1698 = phi_1097_;
                            let _e1700 = phi_1100_;
                            let _e1702 = phi_1102_;
                            let _e1704 = phi_1104_;
                            let _e1706 = phi_1106_;
                            let _e1708 = phi_3226_;
                            continue;
                            continuing {
                                phi_3541_ = _e1696;
                                phi_1096_ = _e1698;
                                phi_1099_ = _e1700;
                                phi_1101_ = _e1702;
                                phi_1103_ = _e1704;
                                phi_1105_ = _e1706;
                                phi_3695_ = _e1696;
                                break if !(_e1708);
                            }
                        }
                        let _e1711 = phi_3695_;
                        if _e1711 {
                            break;
                        }
                        let _e1713 = local_10;
                        if (_e1713.member.member.member_3 != 4294967295u) {
                            let _e1719 = bitcast<u32>(_e1713.member.member.member);
                            let _e1723 = (bitcast<i32>((_e1719 >> bitcast<u32>(23i))) & 255i);
                            let _e1724 = (_e1723 + _e264);
                            if (_e1723 == 255i) {
                                phi_3285_ = _e1713.member.member.member;
                            } else {
                                if (_e1723 > 0i) {
                                    if (_e1724 > 0i) {
                                        let _e1728 = (_e1724 < 255i);
                                        if _e1728 {
                                            phi_3264_ = bitcast<f32>((_e1719 + bitcast<u32>((_e264 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3264_ = f32();
                                        }
                                        let _e1735 = phi_3264_;
                                        phi_3266_ = _e1735;
                                        phi_3267_ = select(true, false, _e1728);
                                    } else {
                                        phi_3266_ = f32();
                                        phi_3267_ = true;
                                    }
                                    let _e1738 = phi_3266_;
                                    let _e1740 = phi_3267_;
                                    phi_3268_ = _e1738;
                                    phi_3269_ = _e1740;
                                } else {
                                    phi_3268_ = f32();
                                    phi_3269_ = true;
                                }
                                let _e1742 = phi_3268_;
                                let _e1744 = phi_3269_;
                                if _e1744 {
                                    let _e1745 = (_e1719 & 2147483648u);
                                    let _e1752 = ((_e1719 & 8388607u) | (select(0u, 1u, ((_e1719 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1756 = (_e1752 == 0u);
                                    if _e1756 {
                                        phi_3505_ = bitcast<f32>(_e1745);
                                    } else {
                                        let _e1761 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1752)), 32u, _e1756) - 8u);
                                        let _e1764 = (_e1752 << bitcast<u32>((_e1761 & 31u)));
                                        let _e1766 = ((_e1724 + select(0i, 1i, (_e1723 == 0i))) - bitcast<i32>(_e1761));
                                        if (_e1766 >= 255i) {
                                            phi_3495_ = bitcast<f32>((_e1745 | 2139095040u));
                                            phi_3496_ = f32();
                                            phi_3497_ = true;
                                        } else {
                                            let _e1768 = (_e1766 > 0i);
                                            if _e1768 {
                                                phi_3489_ = bitcast<f32>(((_e1745 | (bitcast<u32>(_e1766) << bitcast<u32>(23i))) | (_e1764 & 8388607u)));
                                                phi_3490_ = f32();
                                            } else {
                                                if (_e1766 < -24i) {
                                                    phi_3455_ = 26u;
                                                } else {
                                                    phi_3455_ = bitcast<u32>((1i - _e1766));
                                                }
                                                let _e1773 = phi_3455_;
                                                let _e1774 = (_e1773 & 31u);
                                                let _e1776 = (_e1764 >> bitcast<u32>(_e1774));
                                                let _e1780 = (_e1764 & ((1u << bitcast<u32>(_e1774)) - 1u));
                                                let _e1784 = (1u << bitcast<u32>(((_e1773 - 1u) & 31u)));
                                                if (_e1780 > _e1784) {
                                                    phi_3476_ = true;
                                                } else {
                                                    if (_e1780 == _e1784) {
                                                        phi_3473_ = ((_e1776 & 1u) == 1u);
                                                    } else {
                                                        phi_3473_ = false;
                                                    }
                                                    let _e1790 = phi_3473_;
                                                    phi_3476_ = _e1790;
                                                }
                                                let _e1792 = phi_3476_;
                                                phi_3489_ = f32();
                                                phi_3490_ = bitcast<f32>((_e1745 | (_e1776 + select(0u, 1u, _e1792))));
                                            }
                                            let _e1805 = phi_3489_;
                                            let _e1807 = phi_3490_;
                                            phi_3495_ = _e1805;
                                            phi_3496_ = _e1807;
                                            phi_3497_ = _e1768;
                                        }
                                        let _e1811 = phi_3495_;
                                        let _e1813 = phi_3496_;
                                        let _e1815 = phi_3497_;
                                        phi_3505_ = select(_e1813, _e1811, _e1815);
                                    }
                                    let _e1819 = phi_3505_;
                                    phi_3284_ = _e1819;
                                } else {
                                    phi_3284_ = _e1742;
                                }
                                let _e1821 = phi_3284_;
                                phi_3285_ = _e1821;
                            }
                            let _e1823 = phi_3285_;
                            let _e1824 = bitcast<u32>(_e1823);
                            if ((_e1824 & 2147483647u) >= 2139095040u) {
                                phi_3297_ = bitcast<f32>(((_e1824 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3297_ = _e1823;
                            }
                            let _e1831 = phi_3297_;
                            phi_3302_ = type_23(_e1831, _e1713.member.member.member_1, _e1713.member.member.member_2, _e1713.member.member.member_3);
                        } else {
                            phi_3302_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1836 = phi_3302_;
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
