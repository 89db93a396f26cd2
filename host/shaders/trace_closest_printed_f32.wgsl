struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
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

struct type_33 {
    member: type_22,
    member_1: f32,
}

struct type_36 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_38 {
    member: array<type_26>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_43 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_48 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_50 {
    member: type_48,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_45;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_442_: i32;
    var phi_443_: i32;
    var phi_453_: bool;
    var phi_463_: u32;
    var phi_464_: u32;
    var phi_466_: bool;
    var phi_471_: u32;
    var phi_484_: i32;
    var phi_504_: i32;
    var phi_522_: f32;
    var phi_528_: f32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_647_: f32;
    var phi_653_: f32;
    var phi_693_: f32;
    var phi_699_: f32;
    var phi_772_: f32;
    var phi_778_: f32;
    var phi_818_: f32;
    var phi_824_: f32;
    var phi_943_: i32;
    var phi_965_: u32;
    var phi_966_: u32;
    var phi_1003_: i32;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_1034_: f32;
    var phi_1035_: f32;
    var phi_3626_: bool;
    var phi_1118_: type_33;
    var phi_1121_: u32;
    var phi_1123_: bool;
    var phi_1125_: u32;
    var phi_1127_: type_50;
    var phi_1138_: bool;
    var phi_1224_: bool;
    var phi_1225_: u32;
    var phi_1226_: type_50;
    var phi_1244_: type_33;
    var phi_1247_: type_4;
    var phi_1248_: type_4;
    var phi_1270_: type_4;
    var phi_1291_: u32;
    var phi_1383_: array<array<f32, 3>, 3>;
    var phi_3347_: bool;
    var phi_3362_: bool;
    var phi_3377_: bool;
    var phi_3392_: bool;
    var phi_3407_: bool;
    var phi_3422_: bool;
    var phi_1925_: f32;
    var phi_1926_: f32;
    var phi_1927_: f32;
    var phi_1928_: f32;
    var phi_1929_: vec3<f32>;
    var phi_1930_: vec3<f32>;
    var phi_1931_: vec3<f32>;
    var phi_1932_: vec3<f32>;
    var phi_3437_: bool;
    var phi_3452_: bool;
    var phi_3467_: bool;
    var phi_3482_: bool;
    var phi_3497_: bool;
    var phi_3512_: bool;
    var phi_2140_: f32;
    var phi_2160_: type_36;
    var phi_2161_: type_36;
    var phi_2164_: type_36;
    var phi_2165_: type_36;
    var phi_2166_: bool;
    var phi_2170_: type_36;
    var phi_2179_: type_22;
    var phi_2204_: bool;
    var phi_2205_: bool;
    var phi_2211_: type_33;
    var phi_2212_: type_33;
    var phi_2213_: type_33;
    var phi_1245_: type_33;
    var phi_3620_: bool;
    var phi_3844_: bool;
    var phi_2214_: type_33;
    var phi_2235_: type_43;
    var phi_3121_: type_50;
    var phi_3197_: type_50;
    var phi_3198_: u32;
    var phi_3199_: type_50;
    var phi_3201_: u32;
    var phi_3202_: type_50;
    var phi_3203_: bool;
    var phi_3210_: type_50;
    var phi_3215_: bool;
    var phi_3217_: type_50;
    var phi_3221_: bool;
    var phi_3222_: u32;
    var phi_3223_: type_50;
    var phi_3233_: type_50;
    var phi_3788_: bool;
    var phi_3234_: type_33;
    var phi_3235_: u32;
    var phi_3236_: bool;
    var phi_3237_: u32;
    var phi_3238_: type_50;
    var phi_3787_: bool;
    var phi_3239_: type_33;
    var phi_3240_: u32;
    var phi_3241_: bool;
    var phi_3242_: u32;
    var phi_3243_: type_50;
    var phi_3786_: bool;
    var phi_1119_: type_33;
    var phi_1122_: u32;
    var phi_1124_: bool;
    var phi_1126_: u32;
    var phi_1128_: type_50;
    var phi_3244_: bool;
    var phi_3785_: bool;
    var local_10: type_33;
    var phi_3282_: f32;
    var phi_3284_: f32;
    var phi_3285_: bool;
    var phi_3286_: f32;
    var phi_3287_: bool;
    var phi_3540_: u32;
    var phi_3558_: bool;
    var phi_3561_: bool;
    var phi_3574_: f32;
    var phi_3575_: f32;
    var phi_3580_: f32;
    var phi_3581_: f32;
    var phi_3582_: bool;
    var phi_3590_: f32;
    var phi_3302_: f32;
    var phi_3303_: f32;
    var phi_3315_: f32;
    var phi_3320_: type_22;
    var local_11: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e87 = arrayLength((&global_5.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e121 = global_3.member[1u][3u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e135 = (_e84.x + (_e84.y * 2097152u));
            let _e136 = (_e135 < arrayLength((&global_4.member)));
            if _e136 {
                let _e137 = (_e135 < arrayLength((&global_6.member)));
                if _e137 {
                    if _e136 {
                    } else {
                        break;
                    }
                    let _e145 = global_4.member[_e135].member_2[0u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_4.member[_e135].member_2[1u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_4.member[_e135].member_2[2u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_4.member[_e135].member[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e135].member[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e135].member[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e184 = select(_e154, _e147, (_e154 < _e147));
                    let _e186 = select(_e161, _e184, (_e161 < _e184));
                    let _e188 = select(_e168, _e186, (_e168 < _e186));
                    let _e190 = select(_e175, _e188, (_e175 < _e188));
                    let _e192 = select(_e182, _e190, (_e182 < _e190));
                    let _e196 = global_4.member[_e135].member_1;
                    let _e197 = bitcast<u32>(_e196);
                    let _e198 = (_e197 & 2147483647u);
                    let _e205 = global_4.member[_e135].member_3;
                    let _e206 = bitcast<u32>(_e205);
                    let _e207 = (_e206 & 2147483647u);
                    let _e211 = (((select(_e198, _e192, (_e198 < _e192)) < 2139095040u) && (_e207 <= 2139095040u)) && (_e186 > 0u));
                    if _e211 {
                        let _e214 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                        if (_e214 >= 8388608u) {
                            phi_442_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_442_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_442_;
                        phi_443_ = _e228;
                    } else {
                        phi_443_ = 0i;
                    }
                    let _e230 = phi_443_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_453_ = true;
                    } else {
                        phi_453_ = (_e154 == _e186);
                    }
                    let _e234 = phi_453_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_463_ = _e236;
                        phi_464_ = _e236;
                        phi_466_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_463_ = u32();
                        phi_464_ = 0u;
                        phi_466_ = true;
                    }
                    let _e240 = phi_463_;
                    let _e242 = phi_464_;
                    let _e244 = phi_466_;
                    if _e244 {
                        phi_471_ = (_e242 + 1u);
                    } else {
                        phi_471_ = 0u;
                    }
                    let _e248 = phi_471_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_484_ = -126i;
                    } else {
                        phi_484_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_484_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_504_ = -126i;
                    } else {
                        phi_504_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_504_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_522_ = _e287[0];
                    } else {
                        phi_522_ = _e287[1];
                    }
                    let _e292 = phi_522_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_528_ = _e287[2];
                    } else {
                        phi_528_ = _e292;
                    }
                    let _e296 = phi_528_;
                    let _e297 = bitcast<u32>(_e296);
                    let _e299 = ((_e297 & 2139095040u) != 0u);
                    let _e313 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e297 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e297 & 2147483648u))), _e296, _e299) * _e260) * select(0.00000011920929f, 1f, _e299)) * _e266);
                    let _e314 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_568_ = _e314[0];
                    } else {
                        phi_568_ = _e314[1];
                    }
                    let _e318 = phi_568_;
                    if _e293 {
                        phi_574_ = _e314[2];
                    } else {
                        phi_574_ = _e318;
                    }
                    let _e321 = phi_574_;
                    let _e322 = bitcast<u32>(_e321);
                    let _e324 = ((_e322 & 2139095040u) != 0u);
                    let _e338 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e322 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e322 & 2147483648u))), _e321, _e324) * _e277) * select(0.00000011920929f, 1f, _e324)) * _e283);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e345 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                    let _e346 = (_e345 * 0.00000011920929f);
                    let _e349 = select(select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f)), 0f, _e342);
                    let _e350 = select(0f, _e338, _e342);
                    let _e351 = (_e313 + _e349);
                    let _e352 = (_e313 - _e349);
                    let _e354 = select(38685626000000000000000000f, (1f / _e338), _e342);
                    let _e355 = (_e248 == 0u);
                    if _e355 {
                        phi_647_ = _e287[0];
                    } else {
                        phi_647_ = _e287[1];
                    }
                    let _e359 = phi_647_;
                    let _e360 = (_e248 == 2u);
                    if _e360 {
                        phi_653_ = _e287[2];
                    } else {
                        phi_653_ = _e359;
                    }
                    let _e363 = phi_653_;
                    let _e364 = bitcast<u32>(_e363);
                    let _e366 = ((_e364 & 2139095040u) != 0u);
                    let _e380 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e364 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e364 & 2147483648u))), _e363, _e366) * _e260) * select(0.00000011920929f, 1f, _e366)) * _e266);
                    if _e355 {
                        phi_693_ = _e314[0];
                    } else {
                        phi_693_ = _e314[1];
                    }
                    let _e384 = phi_693_;
                    if _e360 {
                        phi_699_ = _e314[2];
                    } else {
                        phi_699_ = _e384;
                    }
                    let _e387 = phi_699_;
                    let _e388 = bitcast<u32>(_e387);
                    let _e390 = ((_e388 & 2139095040u) != 0u);
                    let _e404 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e388 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e388 & 2147483648u))), _e387, _e390) * _e277) * select(0.00000011920929f, 1f, _e390)) * _e283);
                    let _e408 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e411 = bitcast<f32>((bitcast<u32>(_e380) & 2147483647u));
                    let _e412 = (_e411 * 0.00000011920929f);
                    let _e415 = select(select(0.00000000000011368684f, _e412, (_e412 > 0.00000000000011368684f)), 0f, _e408);
                    let _e416 = select(0f, _e404, _e408);
                    let _e417 = (_e380 + _e415);
                    let _e418 = (_e380 - _e415);
                    let _e420 = select(38685626000000000000000000f, (1f / _e404), _e408);
                    let _e421 = (_e250 == 0u);
                    if _e421 {
                        phi_772_ = _e287[0];
                    } else {
                        phi_772_ = _e287[1];
                    }
                    let _e425 = phi_772_;
                    let _e426 = (_e250 == 2u);
                    if _e426 {
                        phi_778_ = _e287[2];
                    } else {
                        phi_778_ = _e425;
                    }
                    let _e429 = phi_778_;
                    let _e430 = bitcast<u32>(_e429);
                    let _e432 = ((_e430 & 2139095040u) != 0u);
                    let _e446 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e430 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e430 & 2147483648u))), _e429, _e432) * _e260) * select(0.00000011920929f, 1f, _e432)) * _e266);
                    if _e421 {
                        phi_818_ = _e314[0];
                    } else {
                        phi_818_ = _e314[1];
                    }
                    let _e450 = phi_818_;
                    if _e426 {
                        phi_824_ = _e314[2];
                    } else {
                        phi_824_ = _e450;
                    }
                    let _e453 = phi_824_;
                    let _e454 = bitcast<u32>(_e453);
                    let _e456 = ((_e454 & 2139095040u) != 0u);
                    let _e470 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e454 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e454 & 2147483648u))), _e453, _e456) * _e277) * select(0.00000011920929f, 1f, _e456)) * _e283);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e477 = bitcast<f32>((bitcast<u32>(_e446) & 2147483647u));
                    let _e478 = (_e477 * 0.00000011920929f);
                    let _e481 = select(select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f)), 0f, _e474);
                    let _e482 = select(0f, _e470, _e474);
                    let _e483 = (_e446 + _e481);
                    let _e484 = (_e446 - _e481);
                    let _e486 = select(38685626000000000000000000f, (1f / _e470), _e474);
                    let _e488 = select(_e411, _e345, (_e345 > _e411));
                    let _e491 = (_e125 + _e230);
                    if (_e211 && (select(_e477, _e488, (_e488 > _e477)) <= 1099511600000f)) {
                        let _e501 = ((_e198 & 8388607u) | (select(0u, 1u, ((_e198 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e504 = bitcast<i32>((_e198 >> bitcast<u32>(23i)));
                        let _e508 = (_e501 == 0u);
                        let _e511 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, _e508)) - 8i);
                        if (_e504 == 255i) {
                            phi_943_ = 255i;
                        } else {
                            phi_943_ = (((_e504 + select(0i, 1i, (_e504 == 0i))) - _e511) + _e491);
                        }
                        let _e519 = phi_943_;
                        let _e529 = (_e519 <= 0i);
                        if _e529 {
                            phi_966_ = u32();
                        } else {
                            if _e508 {
                                phi_965_ = u32();
                            } else {
                                phi_965_ = select(((bitcast<u32>(_e519) << bitcast<u32>(23i)) | ((_e501 << bitcast<u32>(((_e511 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e519 >= 255i));
                            }
                            let _e533 = phi_965_;
                            phi_966_ = _e533;
                        }
                        let _e535 = phi_966_;
                        let _e547 = ((_e207 & 8388607u) | (select(0u, 1u, ((_e207 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e550 = bitcast<i32>((_e207 >> bitcast<u32>(23i)));
                        let _e554 = (_e547 == 0u);
                        let _e557 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e547)), 32u, _e554)) - 8i);
                        if (_e550 == 255i) {
                            phi_1003_ = 255i;
                        } else {
                            phi_1003_ = (((_e550 + select(0i, 1i, (_e550 == 0i))) - _e557) + _e491);
                        }
                        let _e565 = phi_1003_;
                        let _e575 = (_e565 <= 0i);
                        if _e575 {
                            phi_1026_ = u32();
                        } else {
                            if _e554 {
                                phi_1025_ = u32();
                            } else {
                                phi_1025_ = select(((bitcast<u32>(_e565) << bitcast<u32>(23i)) | ((_e547 << bitcast<u32>(((_e557 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e565 >= 255i));
                            }
                            let _e579 = phi_1025_;
                            phi_1026_ = _e579;
                        }
                        let _e581 = phi_1026_;
                        phi_1034_ = bitcast<f32>(((_e206 & 2147483648u) | select(_e581, 0u, select(_e554, true, _e575))));
                        phi_1035_ = bitcast<f32>(((_e197 & 2147483648u) | select(_e535, 0u, select(_e508, true, _e529))));
                    } else {
                        phi_1034_ = 0f;
                        phi_1035_ = 1f;
                    }
                    let _e587 = phi_1034_;
                    let _e589 = phi_1035_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e594 = (_e249 % 3u);
                    let _e595 = (_e594 < 3u);
                    if _e595 {
                    } else {
                        break;
                    }
                    let _e597 = local_9[_e594];
                    let _e598 = (_e248 % 3u);
                    let _e599 = (_e598 < 3u);
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e601 = local_9[_e598];
                    let _e602 = (_e250 % 3u);
                    let _e603 = (_e602 < 3u);
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e605 = local_9[_e602];
                    local_8 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e595 {
                    } else {
                        break;
                    }
                    let _e609 = local_8[_e594];
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e611 = local_8[_e598];
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e613 = local_8[_e602];
                    phi_3626_ = false;
                    phi_1118_ = type_33(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e587);
                    phi_1121_ = ((3u * _e87) + 1u);
                    phi_1123_ = (_e589 <= _e587);
                    phi_1125_ = 0u;
                    phi_1127_ = type_50(type_48(array<f32, 3>(_e597, _e601, _e605), array<f32, 3>(_e609, _e611, _e613)), select(0u, 2147483648u, (_e87 == 0u)));
                    loop {
                        let _e621 = phi_3626_;
                        let _e623 = phi_1118_;
                        let _e625 = phi_1121_;
                        let _e627 = phi_1123_;
                        let _e629 = phi_1125_;
                        let _e631 = phi_1127_;
                        local_10 = _e623;
                        if _e627 {
                            phi_1138_ = true;
                        } else {
                            phi_1138_ = (_e629 > 0u);
                        }
                        let _e634 = phi_1138_;
                        if _e634 {
                            let _e635 = (_e625 > 0u);
                            if _e635 {
                                if _e627 {
                                    phi_1224_ = _e627;
                                    phi_1225_ = _e629;
                                    phi_1226_ = _e631;
                                } else {
                                    let _e636 = (_e629 - 1u);
                                    let _e637 = (_e636 % 128u);
                                    let _e638 = (_e637 < 128u);
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e640 = local_6[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e642 = local_5[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e644 = local_4[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e646 = local_3[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e649 = local_2[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e651 = local_1[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e653 = local[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3785_ = true;
                                        break;
                                    }
                                    let _e658 = local_7[_e637];
                                    phi_1224_ = (_e658 <= _e623.member_1);
                                    phi_1225_ = _e636;
                                    phi_1226_ = type_50(type_48(array<f32, 3>(_e642, _e644, _e646), array<f32, 3>(_e649, _e651, _e653)), _e640);
                                }
                                let _e662 = phi_1224_;
                                let _e664 = phi_1225_;
                                let _e666 = phi_1226_;
                                if _e662 {
                                    let _e670 = ((_e666.member_1 & 2147483648u) != 0u);
                                    if _e670 {
                                        phi_1244_ = _e623;
                                        phi_1247_ = type_4(0u, ((_e666.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e677 = phi_1244_;
                                            let _e679 = phi_1247_;
                                            local_11 = _e677;
                                            if (_e679.member < _e679.member_1) {
                                                phi_1248_ = type_4((_e679.member + 1u), _e679.member_1);
                                                phi_1270_ = type_4(1u, _e679.member);
                                            } else {
                                                phi_1248_ = _e679;
                                                phi_1270_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e692 = phi_1248_;
                                            let _e694 = phi_1270_;
                                            let _e698 = (bitcast<i32>(_e694.member) != 0i);
                                            if _e698 {
                                                let _e699 = ((_e666.member_1 & 268435455u) + _e694.member_1);
                                                let _e700 = (_e699 < _e89);
                                                if _e700 {
                                                    if _e700 {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e704 = global_2.member[_e699].member_1;
                                                    phi_1291_ = _e704;
                                                } else {
                                                    phi_1291_ = 4294967295u;
                                                }
                                                let _e706 = phi_1291_;
                                                if (_e699 >= _e89) {
                                                    phi_1383_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e700 {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    if (_e594 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e713 = global_2.member[_e699].member[_e594];
                                                    if (_e598 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e719 = global_2.member[_e699].member[_e598];
                                                    if (_e602 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e725 = global_2.member[_e699].member[_e602];
                                                    let _e727 = (3u + _e594);
                                                    if (_e727 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e733 = global_2.member[_e699].member[_e727];
                                                    let _e734 = (3u + _e598);
                                                    if (_e734 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e740 = global_2.member[_e699].member[_e734];
                                                    let _e741 = (3u + _e602);
                                                    if (_e741 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e747 = global_2.member[_e699].member[_e741];
                                                    let _e749 = (6u + _e594);
                                                    if (_e749 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e755 = global_2.member[_e699].member[_e749];
                                                    let _e756 = (6u + _e598);
                                                    if (_e756 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e762 = global_2.member[_e699].member[_e756];
                                                    let _e763 = (6u + _e602);
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_3620_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_2.member[_e699].member[_e763];
                                                    phi_1383_ = array<array<f32, 3>, 3>(array<f32, 3>(_e713, _e719, _e725), array<f32, 3>(_e733, _e740, _e747), array<f32, 3>(_e755, _e762, _e769));
                                                }
                                                let _e773 = phi_1383_;
                                                let _e789 = (_e773[0][2] - _e446);
                                                let _e792 = (((_e773[0][0] - _e313) * _e482) - (_e789 * _e350));
                                                let _e795 = (((_e773[0][1] - _e380) * _e482) - (_e789 * _e416));
                                                let _e798 = (_e773[1][2] - _e446);
                                                let _e801 = (((_e773[1][0] - _e313) * _e482) - (_e798 * _e350));
                                                let _e804 = (((_e773[1][1] - _e380) * _e482) - (_e798 * _e416));
                                                let _e807 = (_e773[2][2] - _e446);
                                                let _e810 = (((_e773[2][0] - _e313) * _e482) - (_e807 * _e350));
                                                let _e813 = (((_e773[2][1] - _e380) * _e482) - (_e807 * _e416));
                                                let _e814 = (_e810 * _e804);
                                                let _e815 = (_e813 * _e801);
                                                let _e816 = (_e792 * _e813);
                                                let _e817 = (_e795 * _e810);
                                                let _e818 = (_e801 * _e795);
                                                let _e819 = (_e804 * _e792);
                                                let _e824 = (((_e814 >= _e815) && (_e816 >= _e817)) && (_e818 >= _e819));
                                                let _e830 = (_e824 || (((_e814 <= _e815) && (_e816 <= _e817)) && (_e818 <= _e819)));
                                                if _e830 {
                                                    let _e832 = select(-1f, 1f, _e824);
                                                    let _e834 = ((_e814 - _e815) * _e832);
                                                    let _e836 = select(0f, _e834, (_e834 > 0f));
                                                    let _e838 = ((_e816 - _e817) * _e832);
                                                    let _e840 = select(0f, _e838, (_e838 > 0f));
                                                    let _e842 = ((_e818 - _e819) * _e832);
                                                    let _e844 = select(0f, _e842, (_e842 > 0f));
                                                    let _e846 = ((_e836 + _e840) + _e844);
                                                    let _e848 = select(_e773[1][0], _e773[0][0], (_e773[0][0] < _e773[1][0]));
                                                    let _e852 = select(_e773[1][0], _e773[0][0], (_e773[0][0] > _e773[1][0]));
                                                    let _e856 = select(_e773[1][1], _e773[0][1], (_e773[0][1] < _e773[1][1]));
                                                    let _e860 = select(_e773[1][1], _e773[0][1], (_e773[0][1] > _e773[1][1]));
                                                    let _e864 = select(_e773[1][2], _e773[0][2], (_e773[0][2] < _e773[1][2]));
                                                    let _e868 = select(_e773[1][2], _e773[0][2], (_e773[0][2] > _e773[1][2]));
                                                    let _e873 = ((select(_e773[2][0], _e848, (_e848 < _e773[2][0])) - _e351) * _e354);
                                                    let _e874 = ((select(_e773[2][0], _e852, (_e852 > _e773[2][0])) - _e352) * _e354);
                                                    let _e877 = ((select(_e773[2][1], _e856, (_e856 < _e773[2][1])) - _e417) * _e420);
                                                    let _e878 = ((select(_e773[2][1], _e860, (_e860 > _e773[2][1])) - _e418) * _e420);
                                                    let _e881 = ((select(_e773[2][2], _e864, (_e864 < _e773[2][2])) - _e483) * _e486);
                                                    let _e882 = ((select(_e773[2][2], _e868, (_e868 > _e773[2][2])) - _e484) * _e486);
                                                    let _e884 = select(_e882, _e881, (_e881 < _e882));
                                                    let _e886 = select(_e882, _e881, (_e881 > _e882));
                                                    let _e888 = select(_e874, _e873, (_e873 < _e874));
                                                    let _e890 = select(_e878, _e877, (_e877 < _e878));
                                                    let _e892 = select(_e890, _e888, (_e888 > _e890));
                                                    let _e894 = select(_e884, _e892, (_e892 > _e884));
                                                    let _e896 = select(_e874, _e873, (_e873 > _e874));
                                                    let _e898 = select(_e878, _e877, (_e877 > _e878));
                                                    let _e900 = select(_e898, _e896, (_e896 < _e898));
                                                    let _e902 = select(_e886, _e900, (_e900 < _e886));
                                                    let _e903 = -(_e884);
                                                    let _e909 = select(_e589, _e894, (_e894 > _e589));
                                                    let _e913 = select(_e801, _e792, (_e792 < _e801));
                                                    let _e918 = select(_e801, _e792, (_e792 > _e801));
                                                    let _e925 = select(_e804, _e795, (_e795 < _e804));
                                                    let _e930 = select(_e804, _e795, (_e795 > _e804));
                                                    let _e939 = (((((_e830 && (_e846 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e810, _e913, (_e913 < _e810)) <= 0f) && (select(_e810, _e918, (_e918 > _e810)) >= 0f))) && ((select(_e813, _e925, (_e925 < _e813)) <= 0f) && (select(_e813, _e930, (_e930 > _e813)) >= 0f))) && (_e909 <= (_e902 + (select(_e903, _e886, (_e886 > _e903)) * 0.0000019073523f)))) && (_e909 <= _e677.member_1));
                                                    if _e939 {
                                                        let _e944 = (_e773[1][0] - _e773[0][0]);
                                                        let _e945 = (_e773[1][1] - _e773[0][1]);
                                                        let _e946 = (_e773[1][2] - _e773[0][2]);
                                                        let _e947 = vec3<f32>(_e944, _e945, _e946);
                                                        let _e948 = (_e773[2][0] - _e773[1][0]);
                                                        let _e949 = (_e773[2][1] - _e773[1][1]);
                                                        let _e950 = (_e773[2][2] - _e773[1][2]);
                                                        let _e951 = vec3<f32>(_e948, _e949, _e950);
                                                        let _e952 = (_e773[0][0] - _e773[2][0]);
                                                        let _e953 = (_e773[0][1] - _e773[2][1]);
                                                        let _e954 = (_e773[0][2] - _e773[2][2]);
                                                        let _e955 = vec3<f32>(_e952, _e953, _e954);
                                                        let _e956 = abs(_e944);
                                                        let _e957 = abs(_e945);
                                                        if (_e956 != _e956) {
                                                            phi_3347_ = true;
                                                        } else {
                                                            phi_3347_ = (_e957 >= _e956);
                                                        }
                                                        let _e961 = phi_3347_;
                                                        let _e962 = select(_e956, _e957, _e961);
                                                        let _e963 = abs(_e946);
                                                        if (_e962 != _e962) {
                                                            phi_3362_ = true;
                                                        } else {
                                                            phi_3362_ = (_e963 >= _e962);
                                                        }
                                                        let _e967 = phi_3362_;
                                                        let _e968 = select(_e962, _e963, _e967);
                                                        let _e969 = abs(_e948);
                                                        let _e970 = abs(_e949);
                                                        if (_e969 != _e969) {
                                                            phi_3377_ = true;
                                                        } else {
                                                            phi_3377_ = (_e970 >= _e969);
                                                        }
                                                        let _e974 = phi_3377_;
                                                        let _e975 = select(_e969, _e970, _e974);
                                                        let _e976 = abs(_e950);
                                                        if (_e975 != _e975) {
                                                            phi_3392_ = true;
                                                        } else {
                                                            phi_3392_ = (_e976 >= _e975);
                                                        }
                                                        let _e980 = phi_3392_;
                                                        let _e981 = select(_e975, _e976, _e980);
                                                        let _e982 = abs(_e952);
                                                        let _e983 = abs(_e953);
                                                        if (_e982 != _e982) {
                                                            phi_3407_ = true;
                                                        } else {
                                                            phi_3407_ = (_e983 >= _e982);
                                                        }
                                                        let _e987 = phi_3407_;
                                                        let _e988 = select(_e982, _e983, _e987);
                                                        let _e989 = abs(_e954);
                                                        if (_e988 != _e988) {
                                                            phi_3422_ = true;
                                                        } else {
                                                            phi_3422_ = (_e989 >= _e988);
                                                        }
                                                        let _e993 = phi_3422_;
                                                        let _e994 = select(_e988, _e989, _e993);
                                                        let _e996 = select(_e981, _e968, (_e968 > _e981));
                                                        let _e998 = select(_e994, _e996, (_e996 > _e994));
                                                        if (_e968 == _e998) {
                                                            phi_1925_ = _e804;
                                                            phi_1926_ = _e801;
                                                            phi_1927_ = _e795;
                                                            phi_1928_ = _e792;
                                                            phi_1929_ = vec3<f32>(_e773[0][0], _e773[0][1], _e773[0][2]);
                                                            phi_1930_ = _e955;
                                                            phi_1931_ = _e951;
                                                            phi_1932_ = _e947;
                                                        } else {
                                                            let _e1000 = (_e981 == _e998);
                                                            let _e1005 = vec3(_e1000);
                                                            phi_1925_ = select(_e795, _e813, _e1000);
                                                            phi_1926_ = select(_e792, _e810, _e1000);
                                                            phi_1927_ = select(_e813, _e804, _e1000);
                                                            phi_1928_ = select(_e810, _e801, _e1000);
                                                            phi_1929_ = select(vec3<f32>(_e773[2][0], _e773[2][1], _e773[2][2]), vec3<f32>(_e773[1][0], _e773[1][1], _e773[1][2]), _e1005);
                                                            phi_1930_ = select(_e951, _e947, _e1005);
                                                            phi_1931_ = select(_e947, _e955, _e1005);
                                                            phi_1932_ = select(_e955, _e951, _e1005);
                                                        }
                                                        let _e1011 = phi_1925_;
                                                        let _e1013 = phi_1926_;
                                                        let _e1015 = phi_1927_;
                                                        let _e1017 = phi_1928_;
                                                        let _e1019 = phi_1929_;
                                                        let _e1021 = phi_1930_;
                                                        let _e1023 = phi_1931_;
                                                        let _e1025 = phi_1932_;
                                                        let _e1032 = ((_e1023.y * _e1021.z) - (_e1021.y * _e1023.z));
                                                        let _e1037 = ((_e1023.z * _e1021.x) - (_e1021.z * _e1023.x));
                                                        let _e1040 = ((_e1023.x * _e1021.y) - (_e1021.x * _e1023.y));
                                                        let _e1043 = ((_e836 >= _e840) && (_e836 >= _e844));
                                                        let _e1044 = (_e840 >= _e844);
                                                        let _e1058 = (((_e1032 * (select(select(_e773[2][0], _e773[1][0], _e1044), _e773[0][0], _e1043) - _e313)) + (_e1037 * (select(select(_e773[2][1], _e773[1][1], _e1044), _e773[0][1], _e1043) - _e380))) + (_e1040 * (select(select(_e773[2][2], _e773[1][2], _e1044), _e773[0][2], _e1043) - _e446)));
                                                        let _e1063 = (((_e1032 * _e350) + (_e1037 * _e416)) + (_e1040 * _e482));
                                                        let _e1064 = (_e1013 - _e1017);
                                                        let _e1065 = (_e1011 - _e1015);
                                                        let _e1068 = ((_e1064 * _e1064) + (_e1065 * _e1065));
                                                        let _e1075 = (-(((_e1017 * _e1064) + (_e1015 * _e1065))) / select(0.000000000000000000000000000000000000011754944f, _e1068, (_e1068 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1077 = select(1f, _e1075, (_e1075 < 1f));
                                                        let _e1079 = select(0f, _e1077, (_e1077 > 0f));
                                                        let _e1088 = ((_e1019.x + (_e1025.x * _e1079)) - _e313);
                                                        let _e1091 = ((_e1019.y + (_e1025.y * _e1079)) - _e380);
                                                        let _e1094 = ((_e1019.z + (_e1025.z * _e1079)) - _e446);
                                                        let _e1097 = bitcast<f32>((bitcast<u32>(_e1088) & 2147483647u));
                                                        let _e1100 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                        let _e1102 = select(_e1100, _e1097, (_e1097 > _e1100));
                                                        let _e1105 = bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u));
                                                        let _e1107 = select(_e1105, _e1102, (_e1102 > _e1105));
                                                        let _e1111 = abs(_e1032);
                                                        let _e1112 = abs(_e1037);
                                                        if (_e1111 != _e1111) {
                                                            phi_3437_ = true;
                                                        } else {
                                                            phi_3437_ = (_e1112 >= _e1111);
                                                        }
                                                        let _e1116 = phi_3437_;
                                                        let _e1117 = select(_e1111, _e1112, _e1116);
                                                        let _e1118 = abs(_e1040);
                                                        if (_e1117 != _e1117) {
                                                            phi_3452_ = true;
                                                        } else {
                                                            phi_3452_ = (_e1118 >= _e1117);
                                                        }
                                                        let _e1122 = phi_3452_;
                                                        let _e1138 = abs(_e1023.x);
                                                        let _e1139 = abs(_e1023.y);
                                                        if (_e1138 != _e1138) {
                                                            phi_3467_ = true;
                                                        } else {
                                                            phi_3467_ = (_e1139 >= _e1138);
                                                        }
                                                        let _e1143 = phi_3467_;
                                                        let _e1144 = select(_e1138, _e1139, _e1143);
                                                        let _e1145 = abs(_e1023.z);
                                                        if (_e1144 != _e1144) {
                                                            phi_3482_ = true;
                                                        } else {
                                                            phi_3482_ = (_e1145 >= _e1144);
                                                        }
                                                        let _e1149 = phi_3482_;
                                                        let _e1152 = abs(_e1021.x);
                                                        let _e1153 = abs(_e1021.y);
                                                        if (_e1152 != _e1152) {
                                                            phi_3497_ = true;
                                                        } else {
                                                            phi_3497_ = (_e1153 >= _e1152);
                                                        }
                                                        let _e1157 = phi_3497_;
                                                        let _e1158 = select(_e1152, _e1153, _e1157);
                                                        let _e1159 = abs(_e1021.z);
                                                        if (_e1158 != _e1158) {
                                                            phi_3512_ = true;
                                                        } else {
                                                            phi_3512_ = (_e1159 >= _e1158);
                                                        }
                                                        let _e1163 = phi_3512_;
                                                        let _e1168 = ((bitcast<f32>((bitcast<u32>(((((_e1032 * _e1088) + (_e1037 * _e1091)) + (_e1040 * _e1094)) - _e1058)) & 2147483647u)) <= ((0.0000009536743f * select(_e998, _e1107, (_e1107 > _e998))) * select(_e1117, _e1118, _e1122))) && !((bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u)) <= ((0.0000038146973f * select(_e1144, _e1145, _e1149)) * select(_e1158, _e1159, _e1163)))));
                                                        let _e1169 = (_e1058 / _e1063);
                                                        if (_e939 && !(_e1168)) {
                                                            let _e1172 = (_e1094 / _e482);
                                                            let _e1180 = (((_e1032 * (_e1088 - (_e350 * _e1172))) + (_e1037 * (_e1091 - (_e416 * _e1172)))) / _e1063);
                                                            phi_2140_ = select(select(_e1172, (_e1172 + _e1180), (bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u)) <= _e998)), _e1169, _e1168);
                                                        } else {
                                                            phi_2140_ = _e1169;
                                                        }
                                                        let _e1189 = phi_2140_;
                                                        let _e1191 = select(_e902, _e1189, (_e1189 < _e902));
                                                        let _e1193 = select(_e894, _e1191, (_e1191 > _e894));
                                                        let _e1194 = (1f / _e846);
                                                        phi_2160_ = type_36(_e1193, (_e840 * _e1194), (_e844 * _e1194), ((_e939 && (_e1193 >= _e589)) && (_e1193 <= _e677.member_1)));
                                                        phi_2161_ = type_36();
                                                    } else {
                                                        phi_2160_ = type_36();
                                                        phi_2161_ = type_36(0f, 0f, 0f, _e939);
                                                    }
                                                    let _e1203 = phi_2160_;
                                                    let _e1205 = phi_2161_;
                                                    phi_2164_ = _e1203;
                                                    phi_2165_ = _e1205;
                                                    phi_2166_ = select(true, false, _e939);
                                                } else {
                                                    phi_2164_ = type_36();
                                                    phi_2165_ = type_36(0f, 0f, 0f, _e830);
                                                    phi_2166_ = true;
                                                }
                                                let _e1208 = phi_2164_;
                                                let _e1210 = phi_2165_;
                                                let _e1212 = phi_2166_;
                                                if _e1212 {
                                                    phi_2170_ = _e1210;
                                                } else {
                                                    phi_2170_ = _e1208;
                                                }
                                                let _e1214 = phi_2170_;
                                                if _e1214.member_3 {
                                                    phi_2179_ = type_22(_e1214.member, _e1214.member_1, _e1214.member_2, _e706);
                                                } else {
                                                    phi_2179_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1221 = phi_2179_;
                                                if (_e1221.member_3 != 4294967295u) {
                                                    if (_e706 != 4294967295u) {
                                                        if (_e1221.member < _e677.member.member) {
                                                            phi_2205_ = true;
                                                        } else {
                                                            if (_e1221.member == _e677.member.member) {
                                                                phi_2204_ = (_e1221.member_3 < _e677.member.member_3);
                                                            } else {
                                                                phi_2204_ = false;
                                                            }
                                                            let _e1234 = phi_2204_;
                                                            phi_2205_ = _e1234;
                                                        }
                                                        let _e1236 = phi_2205_;
                                                        if _e1236 {
                                                            phi_2211_ = type_33(_e1221, _e1221.member);
                                                        } else {
                                                            phi_2211_ = _e677;
                                                        }
                                                        let _e1239 = phi_2211_;
                                                        phi_2212_ = _e1239;
                                                    } else {
                                                        phi_2212_ = _e677;
                                                    }
                                                    let _e1241 = phi_2212_;
                                                    phi_2213_ = _e1241;
                                                } else {
                                                    phi_2213_ = _e677;
                                                }
                                                let _e1243 = phi_2213_;
                                                phi_1245_ = _e1243;
                                            } else {
                                                phi_1245_ = type_33();
                                            }
                                            let _e1245 = phi_1245_;
                                            continue;
                                            continuing {
                                                phi_1244_ = _e1245;
                                                phi_1247_ = _e692;
                                                phi_3620_ = _e621;
                                                break if !(_e698);
                                            }
                                        }
                                        let _e1248 = phi_3620_;
                                        phi_3785_ = _e1248;
                                        if _e1248 {
                                            break;
                                        }
                                        phi_3844_ = _e1248;
                                        let _e1878 = local_11;
                                        phi_2214_ = _e1878;
                                    } else {
                                        phi_3844_ = _e621;
                                        phi_2214_ = _e623;
                                    }
                                    let _e1250 = phi_3844_;
                                    let _e1252 = phi_2214_;
                                    if _e670 {
                                        phi_3221_ = bool();
                                        phi_3222_ = u32();
                                        phi_3223_ = type_50();
                                    } else {
                                        let _e1253 = (_e666.member_1 < _e87);
                                        if _e1253 {
                                            if _e1253 {
                                            } else {
                                                phi_3785_ = true;
                                                break;
                                            }
                                            let _e1255 = global_5.member[_e666.member_1];
                                            phi_2235_ = _e1255;
                                        } else {
                                            phi_2235_ = type_43(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1257 = phi_2235_;
                                        let _e1272 = ((10u * _e249) & 31u);
                                        let _e1275 = ((_e1257.member[0] >> bitcast<u32>(_e1272)) & 1023u);
                                        let _e1283 = bitcast<f32>((bitcast<u32>(((_e666.member.member_1[0] - _e666.member.member[0]) * 0.0009775171f)) ^ _e121));
                                        let _e1288 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1275)) - 8388608f) * _e1283)) ^ _e121)));
                                        let _e1292 = select(select(_e666.member.member_1[0], _e1288, (_e1288 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e1275 == 1023u));
                                        let _e1294 = ((10u * _e248) & 31u);
                                        let _e1297 = ((_e1257.member[0] >> bitcast<u32>(_e1294)) & 1023u);
                                        let _e1305 = bitcast<f32>((bitcast<u32>(((_e666.member.member_1[1] - _e666.member.member[1]) * 0.0009775171f)) ^ _e121));
                                        let _e1310 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1297)) - 8388608f) * _e1305)) ^ _e121)));
                                        let _e1314 = select(select(_e666.member.member_1[1], _e1310, (_e1310 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e1297 == 1023u));
                                        let _e1316 = ((10u * _e250) & 31u);
                                        let _e1319 = ((_e1257.member[0] >> bitcast<u32>(_e1316)) & 1023u);
                                        let _e1327 = bitcast<f32>((bitcast<u32>(((_e666.member.member_1[2] - _e666.member.member[2]) * 0.0009775171f)) ^ _e121));
                                        let _e1332 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1319)) - 8388608f) * _e1327)) ^ _e121)));
                                        let _e1336 = select(select(_e666.member.member_1[2], _e1332, (_e1332 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e1319 == 1023u));
                                        let _e1339 = ((_e1257.member[1] >> bitcast<u32>(_e1272)) & 1023u);
                                        let _e1347 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1339)) - 8388608f) * _e1283)) ^ _e121)));
                                        let _e1351 = select(select(_e666.member.member_1[0], _e1347, (_e1347 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e1339 == 1023u));
                                        let _e1354 = ((_e1257.member[1] >> bitcast<u32>(_e1294)) & 1023u);
                                        let _e1362 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1354)) - 8388608f) * _e1305)) ^ _e121)));
                                        let _e1366 = select(select(_e666.member.member_1[1], _e1362, (_e1362 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e1354 == 1023u));
                                        let _e1369 = ((_e1257.member[1] >> bitcast<u32>(_e1316)) & 1023u);
                                        let _e1377 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1369)) - 8388608f) * _e1327)) ^ _e121)));
                                        let _e1381 = select(select(_e666.member.member_1[2], _e1377, (_e1377 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e1369 == 1023u));
                                        let _e1387 = ((_e1257.member_1[0] >> bitcast<u32>(_e1272)) & 1023u);
                                        let _e1395 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1387)) - 8388608f) * _e1283)) ^ _e121)));
                                        let _e1399 = select(select(_e666.member.member_1[0], _e1395, (_e1395 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e1387 == 1023u));
                                        let _e1402 = ((_e1257.member_1[0] >> bitcast<u32>(_e1294)) & 1023u);
                                        let _e1410 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1402)) - 8388608f) * _e1305)) ^ _e121)));
                                        let _e1414 = select(select(_e666.member.member_1[1], _e1410, (_e1410 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e1402 == 1023u));
                                        let _e1417 = ((_e1257.member_1[0] >> bitcast<u32>(_e1316)) & 1023u);
                                        let _e1425 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1417)) - 8388608f) * _e1327)) ^ _e121)));
                                        let _e1429 = select(select(_e666.member.member_1[2], _e1425, (_e1425 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e1417 == 1023u));
                                        let _e1432 = ((_e1257.member_1[1] >> bitcast<u32>(_e1272)) & 1023u);
                                        let _e1440 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1432)) - 8388608f) * _e1283)) ^ _e121)));
                                        let _e1444 = select(select(_e666.member.member_1[0], _e1440, (_e1440 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e1432 == 1023u));
                                        let _e1447 = ((_e1257.member_1[1] >> bitcast<u32>(_e1294)) & 1023u);
                                        let _e1455 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1447)) - 8388608f) * _e1305)) ^ _e121)));
                                        let _e1459 = select(select(_e666.member.member_1[1], _e1455, (_e1455 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e1447 == 1023u));
                                        let _e1462 = ((_e1257.member_1[1] >> bitcast<u32>(_e1316)) & 1023u);
                                        let _e1470 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1462)) - 8388608f) * _e1327)) ^ _e121)));
                                        let _e1474 = select(select(_e666.member.member_1[2], _e1470, (_e1470 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e1462 == 1023u));
                                        let _e1479 = type_50(type_48(array<f32, 3>(_e1292, _e1314, _e1336), array<f32, 3>(_e1351, _e1366, _e1381)), _e1257.member_2);
                                        let _e1484 = type_50(type_48(array<f32, 3>(_e1399, _e1414, _e1429), array<f32, 3>(_e1444, _e1459, _e1474)), _e1257.member_3);
                                        let _e1490 = ((_e1292 - _e351) * _e354);
                                        let _e1491 = ((_e1399 - _e351) * _e354);
                                        let _e1492 = ((_e1351 - _e352) * _e354);
                                        let _e1493 = ((_e1444 - _e352) * _e354);
                                        let _e1498 = ((_e1314 - _e417) * _e420);
                                        let _e1499 = ((_e1414 - _e417) * _e420);
                                        let _e1500 = ((_e1366 - _e418) * _e420);
                                        let _e1501 = ((_e1459 - _e418) * _e420);
                                        let _e1506 = ((_e1336 - _e483) * _e486);
                                        let _e1507 = ((_e1429 - _e483) * _e486);
                                        let _e1508 = ((_e1381 - _e484) * _e486);
                                        let _e1509 = ((_e1474 - _e484) * _e486);
                                        let _e1511 = select(_e1508, _e1506, (_e1506 < _e1508));
                                        let _e1513 = select(_e1509, _e1507, (_e1507 < _e1509));
                                        let _e1515 = select(_e1508, _e1506, (_e1506 > _e1508));
                                        let _e1517 = select(_e1509, _e1507, (_e1507 > _e1509));
                                        let _e1519 = select(_e1492, _e1490, (_e1490 < _e1492));
                                        let _e1521 = select(_e1493, _e1491, (_e1491 < _e1493));
                                        let _e1523 = select(_e1500, _e1498, (_e1498 < _e1500));
                                        let _e1525 = select(_e1501, _e1499, (_e1499 < _e1501));
                                        let _e1527 = select(_e1523, _e1519, (_e1519 > _e1523));
                                        let _e1529 = select(_e1525, _e1521, (_e1521 > _e1525));
                                        let _e1531 = select(_e1511, _e1527, (_e1527 > _e1511));
                                        let _e1533 = select(_e1513, _e1529, (_e1529 > _e1513));
                                        let _e1535 = select(_e1492, _e1490, (_e1490 > _e1492));
                                        let _e1537 = select(_e1493, _e1491, (_e1491 > _e1493));
                                        let _e1539 = select(_e1500, _e1498, (_e1498 > _e1500));
                                        let _e1541 = select(_e1501, _e1499, (_e1499 > _e1501));
                                        let _e1543 = select(_e1539, _e1535, (_e1535 < _e1539));
                                        let _e1545 = select(_e1541, _e1537, (_e1537 < _e1541));
                                        let _e1550 = -(_e1511);
                                        let _e1551 = -(_e1513);
                                        let _e1558 = (select(_e1515, _e1543, (_e1543 < _e1515)) + (select(_e1550, _e1515, (_e1515 > _e1550)) * 0.0000019073523f));
                                        let _e1559 = (select(_e1517, _e1545, (_e1545 < _e1517)) + (select(_e1551, _e1517, (_e1517 > _e1551)) * 0.0000019073523f));
                                        let _e1561 = select(_e589, _e1531, (_e1531 > _e589));
                                        let _e1563 = select(_e589, _e1533, (_e1533 > _e589));
                                        let _e1568 = (_e1561 <= select(_e1252.member_1, _e1558, (_e1558 < _e1252.member_1)));
                                        let _e1569 = (_e1563 <= select(_e1252.member_1, _e1559, (_e1559 < _e1252.member_1)));
                                        let _e1570 = (_e1561 <= _e1563);
                                        if _e1568 {
                                            if _e1569 {
                                                if _e1570 {
                                                    phi_3121_ = _e1484;
                                                } else {
                                                    phi_3121_ = _e1479;
                                                }
                                                let _e1572 = phi_3121_;
                                                let _e1579 = (_e664 % 128u);
                                                let _e1580 = (_e1579 < 128u);
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_6[_e1579] = _e1572.member_1;
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_5[_e1579] = _e1572.member.member[0];
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_4[_e1579] = _e1572.member.member[1];
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_3[_e1579] = _e1572.member.member[2];
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_2[_e1579] = _e1572.member.member_1[0];
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_1[_e1579] = _e1572.member.member_1[1];
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local[_e1579] = _e1572.member.member_1[2];
                                                if _e1580 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_7[_e1579] = select(_e1561, _e1563, _e1570);
                                                if _e1570 {
                                                    phi_3197_ = _e1479;
                                                } else {
                                                    phi_3197_ = _e1484;
                                                }
                                                let _e1597 = phi_3197_;
                                                phi_3198_ = (_e664 + 1u);
                                                phi_3199_ = _e1597;
                                            } else {
                                                phi_3198_ = u32();
                                                phi_3199_ = type_50();
                                            }
                                            let _e1599 = phi_3198_;
                                            let _e1601 = phi_3199_;
                                            phi_3201_ = _e1599;
                                            phi_3202_ = _e1601;
                                            phi_3203_ = select(true, false, _e1569);
                                        } else {
                                            phi_3201_ = u32();
                                            phi_3202_ = type_50();
                                            phi_3203_ = true;
                                        }
                                        let _e1604 = phi_3201_;
                                        let _e1606 = phi_3202_;
                                        let _e1608 = phi_3203_;
                                        if _e1608 {
                                            if _e1568 {
                                                phi_3210_ = _e1479;
                                            } else {
                                                phi_3210_ = _e1484;
                                            }
                                            let _e1610 = phi_3210_;
                                            phi_3215_ = select(_e1569, true, _e1568);
                                            phi_3217_ = _e1610;
                                        } else {
                                            phi_3215_ = _e662;
                                            phi_3217_ = _e1606;
                                        }
                                        let _e1613 = phi_3215_;
                                        let _e1615 = phi_3217_;
                                        phi_3221_ = _e1613;
                                        phi_3222_ = select(_e1604, _e664, _e1608);
                                        phi_3223_ = _e1615;
                                    }
                                    let _e1618 = phi_3221_;
                                    let _e1620 = phi_3222_;
                                    let _e1622 = phi_3223_;
                                    if _e670 {
                                        phi_3233_ = _e666;
                                    } else {
                                        phi_3233_ = _e1622;
                                    }
                                    let _e1624 = phi_3233_;
                                    phi_3788_ = _e1250;
                                    phi_3234_ = _e1252;
                                    phi_3235_ = (_e625 - 1u);
                                    phi_3236_ = select(_e1618, false, _e670);
                                    phi_3237_ = select(_e1620, _e664, _e670);
                                    phi_3238_ = _e1624;
                                } else {
                                    phi_3788_ = _e621;
                                    phi_3234_ = _e623;
                                    phi_3235_ = _e625;
                                    phi_3236_ = _e662;
                                    phi_3237_ = _e664;
                                    phi_3238_ = _e666;
                                }
                                let _e1628 = phi_3788_;
                                let _e1630 = phi_3234_;
                                let _e1632 = phi_3235_;
                                let _e1634 = phi_3236_;
                                let _e1636 = phi_3237_;
                                let _e1638 = phi_3238_;
                                phi_3787_ = _e1628;
                                phi_3239_ = _e1630;
                                phi_3240_ = _e1632;
                                phi_3241_ = _e1634;
                                phi_3242_ = _e1636;
                                phi_3243_ = _e1638;
                            } else {
                                phi_3787_ = _e621;
                                phi_3239_ = type_33();
                                phi_3240_ = u32();
                                phi_3241_ = bool();
                                phi_3242_ = u32();
                                phi_3243_ = type_50();
                            }
                            let _e1640 = phi_3787_;
                            let _e1642 = phi_3239_;
                            let _e1644 = phi_3240_;
                            let _e1646 = phi_3241_;
                            let _e1648 = phi_3242_;
                            let _e1650 = phi_3243_;
                            phi_3786_ = _e1640;
                            phi_1119_ = _e1642;
                            phi_1122_ = _e1644;
                            phi_1124_ = _e1646;
                            phi_1126_ = _e1648;
                            phi_1128_ = _e1650;
                            phi_3244_ = _e635;
                        } else {
                            phi_3786_ = _e621;
                            phi_1119_ = type_33();
                            phi_1122_ = u32();
                            phi_1124_ = bool();
                            phi_1126_ = u32();
                            phi_1128_ = type_50();
                            phi_3244_ = false;
                        }
                        let _e1652 = phi_3786_;
                        let _e1654 = phi_1119_;
                        let _e1656 = phi_1122_;
                        let _e1658 = phi_1124_;
                        let _e1660 = phi_1126_;
                        let _e1662 = phi_1128_;
                        let _e1664 = phi_3244_;
                        continue;
                        continuing {
                            phi_3626_ = _e1652;
                            phi_1118_ = _e1654;
                            phi_1121_ = _e1656;
                            phi_1123_ = _e1658;
                            phi_1125_ = _e1660;
                            phi_1127_ = _e1662;
                            phi_3785_ = _e1652;
                            break if !(_e1664);
                        }
                    }
                    let _e1667 = phi_3785_;
                    if _e1667 {
                        break;
                    }
                    let _e1669 = local_10;
                    if (_e1669.member.member_3 != 4294967295u) {
                        let _e1674 = -(_e491);
                        let _e1675 = bitcast<u32>(_e1669.member.member);
                        let _e1679 = (bitcast<i32>((_e1675 >> bitcast<u32>(23i))) & 255i);
                        let _e1680 = (_e1679 + _e1674);
                        if (_e1679 == 255i) {
                            phi_3303_ = _e1669.member.member;
                        } else {
                            if (_e1679 > 0i) {
                                if (_e1680 > 0i) {
                                    let _e1684 = (_e1680 < 255i);
                                    if _e1684 {
                                        phi_3282_ = bitcast<f32>((_e1675 + bitcast<u32>((_e1674 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3282_ = f32();
                                    }
                                    let _e1691 = phi_3282_;
                                    phi_3284_ = _e1691;
                                    phi_3285_ = select(true, false, _e1684);
                                } else {
                                    phi_3284_ = f32();
                                    phi_3285_ = true;
                                }
                                let _e1694 = phi_3284_;
                                let _e1696 = phi_3285_;
                                phi_3286_ = _e1694;
                                phi_3287_ = _e1696;
                            } else {
                                phi_3286_ = f32();
                                phi_3287_ = true;
                            }
                            let _e1698 = phi_3286_;
                            let _e1700 = phi_3287_;
                            if _e1700 {
                                let _e1701 = (_e1675 & 2147483648u);
                                let _e1708 = ((_e1675 & 8388607u) | (select(0u, 1u, ((_e1675 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1712 = (_e1708 == 0u);
                                if _e1712 {
                                    phi_3590_ = bitcast<f32>(_e1701);
                                } else {
                                    let _e1717 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1708)), 32u, _e1712) - 8u);
                                    let _e1720 = (_e1708 << bitcast<u32>((_e1717 & 31u)));
                                    let _e1722 = ((_e1680 + select(0i, 1i, (_e1679 == 0i))) - bitcast<i32>(_e1717));
                                    if (_e1722 >= 255i) {
                                        phi_3580_ = bitcast<f32>((_e1701 | 2139095040u));
                                        phi_3581_ = f32();
                                        phi_3582_ = true;
                                    } else {
                                        let _e1724 = (_e1722 > 0i);
                                        if _e1724 {
                                            phi_3574_ = bitcast<f32>(((_e1701 | (bitcast<u32>(_e1722) << bitcast<u32>(23i))) | (_e1720 & 8388607u)));
                                            phi_3575_ = f32();
                                        } else {
                                            if (_e1722 < -24i) {
                                                phi_3540_ = 26u;
                                            } else {
                                                phi_3540_ = bitcast<u32>((1i - _e1722));
                                            }
                                            let _e1729 = phi_3540_;
                                            let _e1730 = (_e1729 & 31u);
                                            let _e1732 = (_e1720 >> bitcast<u32>(_e1730));
                                            let _e1736 = (_e1720 & ((1u << bitcast<u32>(_e1730)) - 1u));
                                            let _e1740 = (1u << bitcast<u32>(((_e1729 - 1u) & 31u)));
                                            if (_e1736 > _e1740) {
                                                phi_3561_ = true;
                                            } else {
                                                if (_e1736 == _e1740) {
                                                    phi_3558_ = ((_e1732 & 1u) == 1u);
                                                } else {
                                                    phi_3558_ = false;
                                                }
                                                let _e1746 = phi_3558_;
                                                phi_3561_ = _e1746;
                                            }
                                            let _e1748 = phi_3561_;
                                            phi_3574_ = f32();
                                            phi_3575_ = bitcast<f32>((_e1701 | (_e1732 + select(0u, 1u, _e1748))));
                                        }
                                        let _e1761 = phi_3574_;
                                        let _e1763 = phi_3575_;
                                        phi_3580_ = _e1761;
                                        phi_3581_ = _e1763;
                                        phi_3582_ = _e1724;
                                    }
                                    let _e1767 = phi_3580_;
                                    let _e1769 = phi_3581_;
                                    let _e1771 = phi_3582_;
                                    phi_3590_ = select(_e1769, _e1767, _e1771);
                                }
                                let _e1775 = phi_3590_;
                                phi_3302_ = _e1775;
                            } else {
                                phi_3302_ = _e1698;
                            }
                            let _e1777 = phi_3302_;
                            phi_3303_ = _e1777;
                        }
                        let _e1779 = phi_3303_;
                        let _e1780 = bitcast<u32>(_e1779);
                        if ((_e1780 & 2147483647u) >= 2139095040u) {
                            phi_3315_ = bitcast<f32>(((_e1780 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3315_ = _e1779;
                        }
                        let _e1787 = phi_3315_;
                        phi_3320_ = type_22(_e1787, _e1669.member.member_1, _e1669.member.member_2, _e1669.member.member_3);
                    } else {
                        phi_3320_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1792 = phi_3320_;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135] = _e1792;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
