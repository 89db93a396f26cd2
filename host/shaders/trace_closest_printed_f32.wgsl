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
    var phi_449_: i32;
    var phi_450_: i32;
    var phi_460_: bool;
    var phi_470_: u32;
    var phi_471_: u32;
    var phi_473_: bool;
    var phi_478_: u32;
    var phi_491_: i32;
    var phi_511_: i32;
    var phi_529_: f32;
    var phi_535_: f32;
    var phi_575_: f32;
    var phi_581_: f32;
    var phi_654_: f32;
    var phi_660_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_779_: f32;
    var phi_785_: f32;
    var phi_825_: f32;
    var phi_831_: f32;
    var phi_950_: i32;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_1010_: i32;
    var phi_1032_: u32;
    var phi_1033_: u32;
    var phi_1041_: f32;
    var phi_1042_: f32;
    var phi_3555_: bool;
    var phi_1125_: type_33;
    var phi_1128_: bool;
    var phi_1130_: type_50;
    var phi_1132_: u32;
    var phi_1134_: u32;
    var phi_1145_: bool;
    var phi_1231_: bool;
    var phi_1232_: type_50;
    var phi_1233_: u32;
    var phi_2212_: type_43;
    var phi_3098_: type_50;
    var phi_3174_: type_50;
    var phi_3175_: type_50;
    var phi_3176_: u32;
    var phi_3178_: type_50;
    var phi_3179_: u32;
    var phi_3180_: bool;
    var phi_3187_: type_50;
    var phi_3192_: bool;
    var phi_3193_: type_50;
    var phi_1251_: type_33;
    var phi_1254_: type_4;
    var phi_1255_: type_4;
    var phi_1277_: type_4;
    var phi_1298_: u32;
    var phi_1390_: array<array<f32, 3>, 3>;
    var phi_1920_: f32;
    var phi_1921_: f32;
    var phi_1922_: f32;
    var phi_1923_: f32;
    var phi_1924_: vec3<f32>;
    var phi_1925_: vec3<f32>;
    var phi_1926_: vec3<f32>;
    var phi_1927_: vec3<f32>;
    var phi_2118_: f32;
    var phi_2138_: type_36;
    var phi_2139_: type_36;
    var phi_2142_: type_36;
    var phi_2143_: type_36;
    var phi_2144_: bool;
    var phi_2148_: type_36;
    var phi_2157_: type_22;
    var phi_2182_: bool;
    var phi_2183_: bool;
    var phi_2189_: type_33;
    var phi_2190_: type_33;
    var phi_2191_: type_33;
    var phi_1252_: type_33;
    var phi_3549_: bool;
    var local_10: type_33;
    var phi_3706_: bool;
    var phi_3195_: type_33;
    var phi_3196_: bool;
    var phi_3197_: type_50;
    var phi_3198_: u32;
    var phi_3705_: bool;
    var phi_3199_: type_33;
    var phi_3200_: bool;
    var phi_3201_: type_50;
    var phi_3202_: u32;
    var phi_3203_: u32;
    var phi_3704_: bool;
    var phi_3204_: type_33;
    var phi_3205_: bool;
    var phi_3206_: type_50;
    var phi_3207_: u32;
    var phi_3208_: u32;
    var phi_3703_: bool;
    var phi_1126_: type_33;
    var phi_1129_: bool;
    var phi_1131_: type_50;
    var phi_1133_: u32;
    var phi_1135_: u32;
    var phi_3209_: bool;
    var phi_3702_: bool;
    var local_11: type_33;
    var phi_3247_: f32;
    var phi_3249_: f32;
    var phi_3250_: bool;
    var phi_3251_: f32;
    var phi_3252_: bool;
    var phi_3469_: u32;
    var phi_3487_: bool;
    var phi_3490_: bool;
    var phi_3503_: f32;
    var phi_3504_: f32;
    var phi_3509_: f32;
    var phi_3510_: f32;
    var phi_3511_: bool;
    var phi_3519_: f32;
    var phi_3267_: f32;
    var phi_3268_: f32;
    var phi_3280_: f32;
    var phi_3285_: type_22;
    var local_12: type_33;

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
                            phi_449_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_449_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_449_;
                        phi_450_ = _e228;
                    } else {
                        phi_450_ = 0i;
                    }
                    let _e230 = phi_450_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_460_ = true;
                    } else {
                        phi_460_ = (_e154 == _e186);
                    }
                    let _e234 = phi_460_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_470_ = _e236;
                        phi_471_ = _e236;
                        phi_473_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_470_ = u32();
                        phi_471_ = 0u;
                        phi_473_ = true;
                    }
                    let _e240 = phi_470_;
                    let _e242 = phi_471_;
                    let _e244 = phi_473_;
                    if _e244 {
                        phi_478_ = (_e242 + 1u);
                    } else {
                        phi_478_ = 0u;
                    }
                    let _e248 = phi_478_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_491_ = -126i;
                    } else {
                        phi_491_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_491_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_511_ = -126i;
                    } else {
                        phi_511_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_511_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_529_ = _e287[0];
                    } else {
                        phi_529_ = _e287[1];
                    }
                    let _e292 = phi_529_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_535_ = _e287[2];
                    } else {
                        phi_535_ = _e292;
                    }
                    let _e296 = phi_535_;
                    let _e297 = bitcast<u32>(_e296);
                    let _e299 = ((_e297 & 2139095040u) != 0u);
                    let _e313 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e297 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e297 & 2147483648u))), _e296, _e299) * _e260) * select(0.00000011920929f, 1f, _e299)) * _e266);
                    let _e314 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_575_ = _e314[0];
                    } else {
                        phi_575_ = _e314[1];
                    }
                    let _e318 = phi_575_;
                    if _e293 {
                        phi_581_ = _e314[2];
                    } else {
                        phi_581_ = _e318;
                    }
                    let _e321 = phi_581_;
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
                        phi_654_ = _e287[0];
                    } else {
                        phi_654_ = _e287[1];
                    }
                    let _e359 = phi_654_;
                    let _e360 = (_e248 == 2u);
                    if _e360 {
                        phi_660_ = _e287[2];
                    } else {
                        phi_660_ = _e359;
                    }
                    let _e363 = phi_660_;
                    let _e364 = bitcast<u32>(_e363);
                    let _e366 = ((_e364 & 2139095040u) != 0u);
                    let _e380 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e364 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e364 & 2147483648u))), _e363, _e366) * _e260) * select(0.00000011920929f, 1f, _e366)) * _e266);
                    if _e355 {
                        phi_700_ = _e314[0];
                    } else {
                        phi_700_ = _e314[1];
                    }
                    let _e384 = phi_700_;
                    if _e360 {
                        phi_706_ = _e314[2];
                    } else {
                        phi_706_ = _e384;
                    }
                    let _e387 = phi_706_;
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
                        phi_779_ = _e287[0];
                    } else {
                        phi_779_ = _e287[1];
                    }
                    let _e425 = phi_779_;
                    let _e426 = (_e250 == 2u);
                    if _e426 {
                        phi_785_ = _e287[2];
                    } else {
                        phi_785_ = _e425;
                    }
                    let _e429 = phi_785_;
                    let _e430 = bitcast<u32>(_e429);
                    let _e432 = ((_e430 & 2139095040u) != 0u);
                    let _e446 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e430 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e430 & 2147483648u))), _e429, _e432) * _e260) * select(0.00000011920929f, 1f, _e432)) * _e266);
                    if _e421 {
                        phi_825_ = _e314[0];
                    } else {
                        phi_825_ = _e314[1];
                    }
                    let _e450 = phi_825_;
                    if _e426 {
                        phi_831_ = _e314[2];
                    } else {
                        phi_831_ = _e450;
                    }
                    let _e453 = phi_831_;
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
                            phi_950_ = 255i;
                        } else {
                            phi_950_ = (((_e504 + select(0i, 1i, (_e504 == 0i))) - _e511) + _e491);
                        }
                        let _e519 = phi_950_;
                        let _e529 = (_e519 <= 0i);
                        if _e529 {
                            phi_973_ = u32();
                        } else {
                            if _e508 {
                                phi_972_ = u32();
                            } else {
                                phi_972_ = select(((bitcast<u32>(_e519) << bitcast<u32>(23i)) | ((_e501 << bitcast<u32>(((_e511 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e519 >= 255i));
                            }
                            let _e533 = phi_972_;
                            phi_973_ = _e533;
                        }
                        let _e535 = phi_973_;
                        let _e547 = ((_e207 & 8388607u) | (select(0u, 1u, ((_e207 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e550 = bitcast<i32>((_e207 >> bitcast<u32>(23i)));
                        let _e554 = (_e547 == 0u);
                        let _e557 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e547)), 32u, _e554)) - 8i);
                        if (_e550 == 255i) {
                            phi_1010_ = 255i;
                        } else {
                            phi_1010_ = (((_e550 + select(0i, 1i, (_e550 == 0i))) - _e557) + _e491);
                        }
                        let _e565 = phi_1010_;
                        let _e575 = (_e565 <= 0i);
                        if _e575 {
                            phi_1033_ = u32();
                        } else {
                            if _e554 {
                                phi_1032_ = u32();
                            } else {
                                phi_1032_ = select(((bitcast<u32>(_e565) << bitcast<u32>(23i)) | ((_e547 << bitcast<u32>(((_e557 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e565 >= 255i));
                            }
                            let _e579 = phi_1032_;
                            phi_1033_ = _e579;
                        }
                        let _e581 = phi_1033_;
                        phi_1041_ = bitcast<f32>(((_e206 & 2147483648u) | select(_e581, 0u, select(_e554, true, _e575))));
                        phi_1042_ = bitcast<f32>(((_e197 & 2147483648u) | select(_e535, 0u, select(_e508, true, _e529))));
                    } else {
                        phi_1041_ = 0f;
                        phi_1042_ = 1f;
                    }
                    let _e587 = phi_1041_;
                    let _e589 = phi_1042_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e596 = (_e249 % 3u);
                    let _e597 = (_e596 < 3u);
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e599 = local_9[_e596];
                    let _e600 = (_e248 % 3u);
                    let _e601 = (_e600 < 3u);
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e603 = local_9[_e600];
                    let _e604 = (_e250 % 3u);
                    let _e605 = (_e604 < 3u);
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e607 = local_9[_e604];
                    local_8 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e611 = local_8[_e596];
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e613 = local_8[_e600];
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e615 = local_8[_e604];
                    phi_3555_ = false;
                    phi_1125_ = type_33(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e587);
                    phi_1128_ = (_e589 <= _e587);
                    phi_1130_ = type_50(type_48(array<f32, 3>(_e599, _e603, _e607), array<f32, 3>(_e611, _e613, _e615)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_1132_ = 0u;
                    phi_1134_ = ((3u * _e87) + 1u);
                    loop {
                        let _e621 = phi_3555_;
                        let _e623 = phi_1125_;
                        let _e625 = phi_1128_;
                        let _e627 = phi_1130_;
                        let _e629 = phi_1132_;
                        let _e631 = phi_1134_;
                        local_11 = _e623;
                        if _e625 {
                            phi_1145_ = true;
                        } else {
                            phi_1145_ = (_e629 > 0u);
                        }
                        let _e634 = phi_1145_;
                        if _e634 {
                            let _e635 = (_e631 > 0u);
                            if _e635 {
                                if _e625 {
                                    phi_1231_ = _e625;
                                    phi_1232_ = _e627;
                                    phi_1233_ = _e629;
                                } else {
                                    let _e636 = (_e629 - 1u);
                                    let _e637 = (_e636 % 128u);
                                    let _e638 = (_e637 < 128u);
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e640 = local_6[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e642 = local_5[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e644 = local_4[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e646 = local_3[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e649 = local_2[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e651 = local_1[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e653 = local[_e637];
                                    if _e638 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e658 = local_7[_e637];
                                    phi_1231_ = (_e658 <= _e623.member_1);
                                    phi_1232_ = type_50(type_48(array<f32, 3>(_e642, _e644, _e646), array<f32, 3>(_e649, _e651, _e653)), _e640);
                                    phi_1233_ = _e636;
                                }
                                let _e662 = phi_1231_;
                                let _e664 = phi_1232_;
                                let _e666 = phi_1233_;
                                if _e662 {
                                    if ((_e664.member_1 & 2147483648u) != 0u) {
                                        phi_1251_ = _e623;
                                        phi_1254_ = type_4(0u, ((_e664.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1041 = phi_1251_;
                                            let _e1043 = phi_1254_;
                                            local_10 = _e1041;
                                            local_12 = _e1041;
                                            if (_e1043.member < _e1043.member_1) {
                                                phi_1255_ = type_4((_e1043.member + 1u), _e1043.member_1);
                                                phi_1277_ = type_4(1u, _e1043.member);
                                            } else {
                                                phi_1255_ = _e1043;
                                                phi_1277_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1056 = phi_1255_;
                                            let _e1058 = phi_1277_;
                                            let _e1062 = (bitcast<i32>(_e1058.member) != 0i);
                                            if _e1062 {
                                                let _e1063 = ((_e664.member_1 & 268435455u) + _e1058.member_1);
                                                let _e1064 = (_e1063 < _e89);
                                                if _e1064 {
                                                    if _e1064 {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1068 = global_2.member[_e1063].member_1;
                                                    phi_1298_ = _e1068;
                                                } else {
                                                    phi_1298_ = 4294967295u;
                                                }
                                                let _e1070 = phi_1298_;
                                                if (_e1063 >= _e89) {
                                                    phi_1390_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1064 {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    if (_e596 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1077 = global_2.member[_e1063].member[_e596];
                                                    if (_e600 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1083 = global_2.member[_e1063].member[_e600];
                                                    if (_e604 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_2.member[_e1063].member[_e604];
                                                    let _e1091 = (3u + _e596);
                                                    if (_e1091 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1097 = global_2.member[_e1063].member[_e1091];
                                                    let _e1098 = (3u + _e600);
                                                    if (_e1098 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1104 = global_2.member[_e1063].member[_e1098];
                                                    let _e1105 = (3u + _e604);
                                                    if (_e1105 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1111 = global_2.member[_e1063].member[_e1105];
                                                    let _e1113 = (6u + _e596);
                                                    if (_e1113 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1119 = global_2.member[_e1063].member[_e1113];
                                                    let _e1120 = (6u + _e600);
                                                    if (_e1120 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1126 = global_2.member[_e1063].member[_e1120];
                                                    let _e1127 = (6u + _e604);
                                                    if (_e1127 < 9u) {
                                                    } else {
                                                        phi_3549_ = true;
                                                        break;
                                                    }
                                                    let _e1133 = global_2.member[_e1063].member[_e1127];
                                                    phi_1390_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1077, _e1083, _e1089), array<f32, 3>(_e1097, _e1104, _e1111), array<f32, 3>(_e1119, _e1126, _e1133));
                                                }
                                                let _e1137 = phi_1390_;
                                                let _e1153 = (_e1137[0][2] - _e446);
                                                let _e1156 = (((_e1137[0][0] - _e313) * _e482) - (_e1153 * _e350));
                                                let _e1159 = (((_e1137[0][1] - _e380) * _e482) - (_e1153 * _e416));
                                                let _e1162 = (_e1137[1][2] - _e446);
                                                let _e1165 = (((_e1137[1][0] - _e313) * _e482) - (_e1162 * _e350));
                                                let _e1168 = (((_e1137[1][1] - _e380) * _e482) - (_e1162 * _e416));
                                                let _e1171 = (_e1137[2][2] - _e446);
                                                let _e1174 = (((_e1137[2][0] - _e313) * _e482) - (_e1171 * _e350));
                                                let _e1177 = (((_e1137[2][1] - _e380) * _e482) - (_e1171 * _e416));
                                                let _e1178 = (_e1174 * _e1168);
                                                let _e1179 = (_e1177 * _e1165);
                                                let _e1180 = (_e1156 * _e1177);
                                                let _e1181 = (_e1159 * _e1174);
                                                let _e1182 = (_e1165 * _e1159);
                                                let _e1183 = (_e1168 * _e1156);
                                                let _e1188 = (((_e1178 >= _e1179) && (_e1180 >= _e1181)) && (_e1182 >= _e1183));
                                                let _e1194 = (_e1188 || (((_e1178 <= _e1179) && (_e1180 <= _e1181)) && (_e1182 <= _e1183)));
                                                if _e1194 {
                                                    let _e1196 = select(-1f, 1f, _e1188);
                                                    let _e1198 = ((_e1178 - _e1179) * _e1196);
                                                    let _e1200 = select(0f, _e1198, (_e1198 > 0f));
                                                    let _e1202 = ((_e1180 - _e1181) * _e1196);
                                                    let _e1204 = select(0f, _e1202, (_e1202 > 0f));
                                                    let _e1206 = ((_e1182 - _e1183) * _e1196);
                                                    let _e1208 = select(0f, _e1206, (_e1206 > 0f));
                                                    let _e1210 = ((_e1200 + _e1204) + _e1208);
                                                    let _e1212 = select(_e1137[1][0], _e1137[0][0], (_e1137[0][0] < _e1137[1][0]));
                                                    let _e1216 = select(_e1137[1][0], _e1137[0][0], (_e1137[0][0] > _e1137[1][0]));
                                                    let _e1220 = select(_e1137[1][1], _e1137[0][1], (_e1137[0][1] < _e1137[1][1]));
                                                    let _e1224 = select(_e1137[1][1], _e1137[0][1], (_e1137[0][1] > _e1137[1][1]));
                                                    let _e1228 = select(_e1137[1][2], _e1137[0][2], (_e1137[0][2] < _e1137[1][2]));
                                                    let _e1232 = select(_e1137[1][2], _e1137[0][2], (_e1137[0][2] > _e1137[1][2]));
                                                    let _e1237 = ((select(_e1137[2][0], _e1212, (_e1212 < _e1137[2][0])) - _e351) * _e354);
                                                    let _e1238 = ((select(_e1137[2][0], _e1216, (_e1216 > _e1137[2][0])) - _e352) * _e354);
                                                    let _e1241 = ((select(_e1137[2][1], _e1220, (_e1220 < _e1137[2][1])) - _e417) * _e420);
                                                    let _e1242 = ((select(_e1137[2][1], _e1224, (_e1224 > _e1137[2][1])) - _e418) * _e420);
                                                    let _e1245 = ((select(_e1137[2][2], _e1228, (_e1228 < _e1137[2][2])) - _e483) * _e486);
                                                    let _e1246 = ((select(_e1137[2][2], _e1232, (_e1232 > _e1137[2][2])) - _e484) * _e486);
                                                    let _e1248 = select(_e1246, _e1245, (_e1245 < _e1246));
                                                    let _e1250 = select(_e1246, _e1245, (_e1245 > _e1246));
                                                    let _e1252 = select(_e1238, _e1237, (_e1237 < _e1238));
                                                    let _e1254 = select(_e1242, _e1241, (_e1241 < _e1242));
                                                    let _e1256 = select(_e1254, _e1252, (_e1252 > _e1254));
                                                    let _e1258 = select(_e1248, _e1256, (_e1256 > _e1248));
                                                    let _e1260 = select(_e1238, _e1237, (_e1237 > _e1238));
                                                    let _e1262 = select(_e1242, _e1241, (_e1241 > _e1242));
                                                    let _e1264 = select(_e1262, _e1260, (_e1260 < _e1262));
                                                    let _e1266 = select(_e1250, _e1264, (_e1264 < _e1250));
                                                    let _e1267 = -(_e1248);
                                                    let _e1273 = select(_e589, _e1258, (_e1258 > _e589));
                                                    let _e1277 = select(_e1165, _e1156, (_e1156 < _e1165));
                                                    let _e1282 = select(_e1165, _e1156, (_e1156 > _e1165));
                                                    let _e1289 = select(_e1168, _e1159, (_e1159 < _e1168));
                                                    let _e1294 = select(_e1168, _e1159, (_e1159 > _e1168));
                                                    let _e1303 = (((((_e1194 && (_e1210 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1174, _e1277, (_e1277 < _e1174)) <= 0f) && (select(_e1174, _e1282, (_e1282 > _e1174)) >= 0f))) && ((select(_e1177, _e1289, (_e1289 < _e1177)) <= 0f) && (select(_e1177, _e1294, (_e1294 > _e1177)) >= 0f))) && (_e1273 <= (_e1266 + (select(_e1267, _e1250, (_e1250 > _e1267)) * 0.0000019073523f)))) && (_e1273 <= _e1041.member_1));
                                                    if _e1303 {
                                                        let _e1308 = (_e1137[1][0] - _e1137[0][0]);
                                                        let _e1309 = (_e1137[1][1] - _e1137[0][1]);
                                                        let _e1310 = (_e1137[1][2] - _e1137[0][2]);
                                                        let _e1311 = vec3<f32>(_e1308, _e1309, _e1310);
                                                        let _e1312 = (_e1137[2][0] - _e1137[1][0]);
                                                        let _e1313 = (_e1137[2][1] - _e1137[1][1]);
                                                        let _e1314 = (_e1137[2][2] - _e1137[1][2]);
                                                        let _e1315 = vec3<f32>(_e1312, _e1313, _e1314);
                                                        let _e1316 = (_e1137[0][0] - _e1137[2][0]);
                                                        let _e1317 = (_e1137[0][1] - _e1137[2][1]);
                                                        let _e1318 = (_e1137[0][2] - _e1137[2][2]);
                                                        let _e1319 = vec3<f32>(_e1316, _e1317, _e1318);
                                                        let _e1322 = bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u));
                                                        let _e1325 = bitcast<f32>((bitcast<u32>(_e1309) & 2147483647u));
                                                        let _e1327 = select(_e1325, _e1322, (_e1322 > _e1325));
                                                        let _e1330 = bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u));
                                                        let _e1332 = select(_e1330, _e1327, (_e1327 > _e1330));
                                                        let _e1335 = bitcast<f32>((bitcast<u32>(_e1312) & 2147483647u));
                                                        let _e1338 = bitcast<f32>((bitcast<u32>(_e1313) & 2147483647u));
                                                        let _e1340 = select(_e1338, _e1335, (_e1335 > _e1338));
                                                        let _e1343 = bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u));
                                                        let _e1345 = select(_e1343, _e1340, (_e1340 > _e1343));
                                                        let _e1348 = bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u));
                                                        let _e1351 = bitcast<f32>((bitcast<u32>(_e1317) & 2147483647u));
                                                        let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                        let _e1356 = bitcast<f32>((bitcast<u32>(_e1318) & 2147483647u));
                                                        let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                                                        let _e1360 = select(_e1345, _e1332, (_e1332 > _e1345));
                                                        let _e1362 = select(_e1358, _e1360, (_e1360 > _e1358));
                                                        if (_e1332 == _e1362) {
                                                            phi_1920_ = _e1168;
                                                            phi_1921_ = _e1165;
                                                            phi_1922_ = _e1159;
                                                            phi_1923_ = _e1156;
                                                            phi_1924_ = vec3<f32>(_e1137[0][0], _e1137[0][1], _e1137[0][2]);
                                                            phi_1925_ = _e1319;
                                                            phi_1926_ = _e1315;
                                                            phi_1927_ = _e1311;
                                                        } else {
                                                            let _e1364 = (_e1345 == _e1362);
                                                            let _e1369 = vec3(_e1364);
                                                            phi_1920_ = select(_e1159, _e1177, _e1364);
                                                            phi_1921_ = select(_e1156, _e1174, _e1364);
                                                            phi_1922_ = select(_e1177, _e1168, _e1364);
                                                            phi_1923_ = select(_e1174, _e1165, _e1364);
                                                            phi_1924_ = select(vec3<f32>(_e1137[2][0], _e1137[2][1], _e1137[2][2]), vec3<f32>(_e1137[1][0], _e1137[1][1], _e1137[1][2]), _e1369);
                                                            phi_1925_ = select(_e1315, _e1311, _e1369);
                                                            phi_1926_ = select(_e1311, _e1319, _e1369);
                                                            phi_1927_ = select(_e1319, _e1315, _e1369);
                                                        }
                                                        let _e1375 = phi_1920_;
                                                        let _e1377 = phi_1921_;
                                                        let _e1379 = phi_1922_;
                                                        let _e1381 = phi_1923_;
                                                        let _e1383 = phi_1924_;
                                                        let _e1385 = phi_1925_;
                                                        let _e1387 = phi_1926_;
                                                        let _e1389 = phi_1927_;
                                                        let _e1396 = ((_e1387.y * _e1385.z) - (_e1385.y * _e1387.z));
                                                        let _e1401 = ((_e1387.z * _e1385.x) - (_e1385.z * _e1387.x));
                                                        let _e1404 = ((_e1387.x * _e1385.y) - (_e1385.x * _e1387.y));
                                                        let _e1407 = ((_e1200 >= _e1204) && (_e1200 >= _e1208));
                                                        let _e1408 = (_e1204 >= _e1208);
                                                        let _e1422 = (((_e1396 * (select(select(_e1137[2][0], _e1137[1][0], _e1408), _e1137[0][0], _e1407) - _e313)) + (_e1401 * (select(select(_e1137[2][1], _e1137[1][1], _e1408), _e1137[0][1], _e1407) - _e380))) + (_e1404 * (select(select(_e1137[2][2], _e1137[1][2], _e1408), _e1137[0][2], _e1407) - _e446)));
                                                        let _e1427 = (((_e1396 * _e350) + (_e1401 * _e416)) + (_e1404 * _e482));
                                                        let _e1428 = (_e1377 - _e1381);
                                                        let _e1429 = (_e1375 - _e1379);
                                                        let _e1432 = ((_e1428 * _e1428) + (_e1429 * _e1429));
                                                        let _e1439 = (-(((_e1381 * _e1428) + (_e1379 * _e1429))) / select(0.000000000000000000000000000000000000011754944f, _e1432, (_e1432 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1441 = select(1f, _e1439, (_e1439 < 1f));
                                                        let _e1443 = select(0f, _e1441, (_e1441 > 0f));
                                                        let _e1452 = ((_e1383.x + (_e1389.x * _e1443)) - _e313);
                                                        let _e1455 = ((_e1383.y + (_e1389.y * _e1443)) - _e380);
                                                        let _e1458 = ((_e1383.z + (_e1389.z * _e1443)) - _e446);
                                                        let _e1461 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                        let _e1464 = bitcast<f32>((bitcast<u32>(_e1455) & 2147483647u));
                                                        let _e1466 = select(_e1464, _e1461, (_e1461 > _e1464));
                                                        let _e1469 = bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u));
                                                        let _e1471 = select(_e1469, _e1466, (_e1466 > _e1469));
                                                        let _e1477 = bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u));
                                                        let _e1480 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                        let _e1482 = select(_e1480, _e1477, (_e1477 > _e1480));
                                                        let _e1485 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                        let _e1504 = bitcast<f32>((bitcast<u32>(_e1387.x) & 2147483647u));
                                                        let _e1507 = bitcast<f32>((bitcast<u32>(_e1387.y) & 2147483647u));
                                                        let _e1509 = select(_e1507, _e1504, (_e1504 > _e1507));
                                                        let _e1512 = bitcast<f32>((bitcast<u32>(_e1387.z) & 2147483647u));
                                                        let _e1518 = bitcast<f32>((bitcast<u32>(_e1385.x) & 2147483647u));
                                                        let _e1521 = bitcast<f32>((bitcast<u32>(_e1385.y) & 2147483647u));
                                                        let _e1523 = select(_e1521, _e1518, (_e1518 > _e1521));
                                                        let _e1526 = bitcast<f32>((bitcast<u32>(_e1385.z) & 2147483647u));
                                                        let _e1532 = ((bitcast<f32>((bitcast<u32>(((((_e1396 * _e1452) + (_e1401 * _e1455)) + (_e1404 * _e1458)) - _e1422)) & 2147483647u)) <= ((0.0000009536743f * select(_e1362, _e1471, (_e1471 > _e1362))) * select(_e1485, _e1482, (_e1482 > _e1485)))) && !((bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u)) <= ((0.0000038146973f * select(_e1512, _e1509, (_e1509 > _e1512))) * select(_e1526, _e1523, (_e1523 > _e1526))))));
                                                        let _e1533 = (_e1422 / _e1427);
                                                        if (_e1303 && !(_e1532)) {
                                                            let _e1536 = (_e1458 / _e482);
                                                            let _e1544 = (((_e1396 * (_e1452 - (_e350 * _e1536))) + (_e1401 * (_e1455 - (_e416 * _e1536)))) / _e1427);
                                                            phi_2118_ = select(select(_e1536, (_e1536 + _e1544), (bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u)) <= _e1362)), _e1533, _e1532);
                                                        } else {
                                                            phi_2118_ = _e1533;
                                                        }
                                                        let _e1553 = phi_2118_;
                                                        let _e1555 = select(_e1266, _e1553, (_e1553 < _e1266));
                                                        let _e1557 = select(_e1258, _e1555, (_e1555 > _e1258));
                                                        let _e1558 = (1f / _e1210);
                                                        phi_2138_ = type_36(_e1557, (_e1204 * _e1558), (_e1208 * _e1558), ((_e1303 && (_e1557 >= _e589)) && (_e1557 <= _e1041.member_1)));
                                                        phi_2139_ = type_36();
                                                    } else {
                                                        phi_2138_ = type_36();
                                                        phi_2139_ = type_36(0f, 0f, 0f, _e1303);
                                                    }
                                                    let _e1567 = phi_2138_;
                                                    let _e1569 = phi_2139_;
                                                    phi_2142_ = _e1567;
                                                    phi_2143_ = _e1569;
                                                    phi_2144_ = select(true, false, _e1303);
                                                } else {
                                                    phi_2142_ = type_36();
                                                    phi_2143_ = type_36(0f, 0f, 0f, _e1194);
                                                    phi_2144_ = true;
                                                }
                                                let _e1572 = phi_2142_;
                                                let _e1574 = phi_2143_;
                                                let _e1576 = phi_2144_;
                                                if _e1576 {
                                                    phi_2148_ = _e1574;
                                                } else {
                                                    phi_2148_ = _e1572;
                                                }
                                                let _e1578 = phi_2148_;
                                                if _e1578.member_3 {
                                                    phi_2157_ = type_22(_e1578.member, _e1578.member_1, _e1578.member_2, _e1070);
                                                } else {
                                                    phi_2157_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1585 = phi_2157_;
                                                if (_e1585.member_3 != 4294967295u) {
                                                    if (_e1070 != 4294967295u) {
                                                        if (_e1585.member < _e1041.member.member) {
                                                            phi_2183_ = true;
                                                        } else {
                                                            if (_e1585.member == _e1041.member.member) {
                                                                phi_2182_ = (_e1585.member_3 < _e1041.member.member_3);
                                                            } else {
                                                                phi_2182_ = false;
                                                            }
                                                            let _e1598 = phi_2182_;
                                                            phi_2183_ = _e1598;
                                                        }
                                                        let _e1600 = phi_2183_;
                                                        if _e1600 {
                                                            phi_2189_ = type_33(_e1585, _e1585.member);
                                                        } else {
                                                            phi_2189_ = _e1041;
                                                        }
                                                        let _e1603 = phi_2189_;
                                                        phi_2190_ = _e1603;
                                                    } else {
                                                        phi_2190_ = _e1041;
                                                    }
                                                    let _e1605 = phi_2190_;
                                                    phi_2191_ = _e1605;
                                                } else {
                                                    phi_2191_ = _e1041;
                                                }
                                                let _e1607 = phi_2191_;
                                                phi_1252_ = _e1607;
                                            } else {
                                                phi_1252_ = type_33();
                                            }
                                            let _e1609 = phi_1252_;
                                            continue;
                                            continuing {
                                                phi_1251_ = _e1609;
                                                phi_1254_ = _e1056;
                                                phi_3549_ = _e621;
                                                break if !(_e1062);
                                            }
                                        }
                                        let _e1612 = phi_3549_;
                                        phi_3702_ = _e1612;
                                        if _e1612 {
                                            break;
                                        }
                                        let _e1614 = local_10;
                                        phi_3706_ = _e1612;
                                        let _e1879 = local_12;
                                        phi_3195_ = _e1879;
                                        phi_3196_ = false;
                                        phi_3197_ = _e664;
                                        phi_3198_ = select(_e666, 0u, (_e589 > _e1614.member_1));
                                    } else {
                                        let _e675 = (_e664.member_1 < _e87);
                                        if _e675 {
                                            if _e675 {
                                            } else {
                                                phi_3702_ = true;
                                                break;
                                            }
                                            let _e677 = global_5.member[_e664.member_1];
                                            phi_2212_ = _e677;
                                        } else {
                                            phi_2212_ = type_43(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e679 = phi_2212_;
                                        let _e694 = ((10u * _e249) & 31u);
                                        let _e697 = ((_e679.member[0] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e705 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[0] - _e664.member.member[0]) * 0.0009775171f)) ^ _e121));
                                        let _e710 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e697)) - 8388608f) * _e705)) ^ _e121)));
                                        let _e714 = select(select(_e664.member.member_1[0], _e710, (_e710 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e697 == 1023u));
                                        let _e716 = ((10u * _e248) & 31u);
                                        let _e719 = ((_e679.member[0] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e727 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[1] - _e664.member.member[1]) * 0.0009775171f)) ^ _e121));
                                        let _e732 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e719)) - 8388608f) * _e727)) ^ _e121)));
                                        let _e736 = select(select(_e664.member.member_1[1], _e732, (_e732 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e719 == 1023u));
                                        let _e738 = ((10u * _e250) & 31u);
                                        let _e741 = ((_e679.member[0] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e749 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[2] - _e664.member.member[2]) * 0.0009775171f)) ^ _e121));
                                        let _e754 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e741)) - 8388608f) * _e749)) ^ _e121)));
                                        let _e758 = select(select(_e664.member.member_1[2], _e754, (_e754 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e741 == 1023u));
                                        let _e761 = ((_e679.member[1] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e769 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e761)) - 8388608f) * _e705)) ^ _e121)));
                                        let _e773 = select(select(_e664.member.member_1[0], _e769, (_e769 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e761 == 1023u));
                                        let _e776 = ((_e679.member[1] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e784 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e776)) - 8388608f) * _e727)) ^ _e121)));
                                        let _e788 = select(select(_e664.member.member_1[1], _e784, (_e784 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e776 == 1023u));
                                        let _e791 = ((_e679.member[1] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e799 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e791)) - 8388608f) * _e749)) ^ _e121)));
                                        let _e803 = select(select(_e664.member.member_1[2], _e799, (_e799 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e791 == 1023u));
                                        let _e809 = ((_e679.member_1[0] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e817 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e809)) - 8388608f) * _e705)) ^ _e121)));
                                        let _e821 = select(select(_e664.member.member_1[0], _e817, (_e817 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e809 == 1023u));
                                        let _e824 = ((_e679.member_1[0] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e832 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e824)) - 8388608f) * _e727)) ^ _e121)));
                                        let _e836 = select(select(_e664.member.member_1[1], _e832, (_e832 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e824 == 1023u));
                                        let _e839 = ((_e679.member_1[0] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e847 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e749)) ^ _e121)));
                                        let _e851 = select(select(_e664.member.member_1[2], _e847, (_e847 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e839 == 1023u));
                                        let _e854 = ((_e679.member_1[1] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e862 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e854)) - 8388608f) * _e705)) ^ _e121)));
                                        let _e866 = select(select(_e664.member.member_1[0], _e862, (_e862 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e854 == 1023u));
                                        let _e869 = ((_e679.member_1[1] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e877 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e869)) - 8388608f) * _e727)) ^ _e121)));
                                        let _e881 = select(select(_e664.member.member_1[1], _e877, (_e877 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e869 == 1023u));
                                        let _e884 = ((_e679.member_1[1] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e892 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e884)) - 8388608f) * _e749)) ^ _e121)));
                                        let _e896 = select(select(_e664.member.member_1[2], _e892, (_e892 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e884 == 1023u));
                                        let _e901 = type_50(type_48(array<f32, 3>(_e714, _e736, _e758), array<f32, 3>(_e773, _e788, _e803)), _e679.member_2);
                                        let _e906 = type_50(type_48(array<f32, 3>(_e821, _e836, _e851), array<f32, 3>(_e866, _e881, _e896)), _e679.member_3);
                                        let _e912 = ((_e714 - _e351) * _e354);
                                        let _e913 = ((_e821 - _e351) * _e354);
                                        let _e914 = ((_e773 - _e352) * _e354);
                                        let _e915 = ((_e866 - _e352) * _e354);
                                        let _e920 = ((_e736 - _e417) * _e420);
                                        let _e921 = ((_e836 - _e417) * _e420);
                                        let _e922 = ((_e788 - _e418) * _e420);
                                        let _e923 = ((_e881 - _e418) * _e420);
                                        let _e928 = ((_e758 - _e483) * _e486);
                                        let _e929 = ((_e851 - _e483) * _e486);
                                        let _e930 = ((_e803 - _e484) * _e486);
                                        let _e931 = ((_e896 - _e484) * _e486);
                                        let _e933 = select(_e930, _e928, (_e928 < _e930));
                                        let _e935 = select(_e931, _e929, (_e929 < _e931));
                                        let _e937 = select(_e930, _e928, (_e928 > _e930));
                                        let _e939 = select(_e931, _e929, (_e929 > _e931));
                                        let _e941 = select(_e914, _e912, (_e912 < _e914));
                                        let _e943 = select(_e915, _e913, (_e913 < _e915));
                                        let _e945 = select(_e922, _e920, (_e920 < _e922));
                                        let _e947 = select(_e923, _e921, (_e921 < _e923));
                                        let _e949 = select(_e945, _e941, (_e941 > _e945));
                                        let _e951 = select(_e947, _e943, (_e943 > _e947));
                                        let _e953 = select(_e933, _e949, (_e949 > _e933));
                                        let _e955 = select(_e935, _e951, (_e951 > _e935));
                                        let _e957 = select(_e914, _e912, (_e912 > _e914));
                                        let _e959 = select(_e915, _e913, (_e913 > _e915));
                                        let _e961 = select(_e922, _e920, (_e920 > _e922));
                                        let _e963 = select(_e923, _e921, (_e921 > _e923));
                                        let _e965 = select(_e961, _e957, (_e957 < _e961));
                                        let _e967 = select(_e963, _e959, (_e959 < _e963));
                                        let _e972 = -(_e933);
                                        let _e973 = -(_e935);
                                        let _e980 = (select(_e937, _e965, (_e965 < _e937)) + (select(_e972, _e937, (_e937 > _e972)) * 0.0000019073523f));
                                        let _e981 = (select(_e939, _e967, (_e967 < _e939)) + (select(_e973, _e939, (_e939 > _e973)) * 0.0000019073523f));
                                        let _e983 = select(_e589, _e953, (_e953 > _e589));
                                        let _e985 = select(_e589, _e955, (_e955 > _e589));
                                        let _e990 = (_e983 <= select(_e623.member_1, _e980, (_e980 < _e623.member_1)));
                                        let _e991 = (_e985 <= select(_e623.member_1, _e981, (_e981 < _e623.member_1)));
                                        let _e992 = (_e983 <= _e985);
                                        if _e990 {
                                            if _e991 {
                                                if _e992 {
                                                    phi_3098_ = _e906;
                                                } else {
                                                    phi_3098_ = _e901;
                                                }
                                                let _e994 = phi_3098_;
                                                let _e1001 = (_e666 % 128u);
                                                let _e1002 = (_e1001 < 128u);
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_6[_e1001] = _e994.member_1;
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_5[_e1001] = _e994.member.member[0];
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_4[_e1001] = _e994.member.member[1];
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_3[_e1001] = _e994.member.member[2];
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_2[_e1001] = _e994.member.member_1[0];
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_1[_e1001] = _e994.member.member_1[1];
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local[_e1001] = _e994.member.member_1[2];
                                                if _e1002 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_7[_e1001] = select(_e983, _e985, _e992);
                                                if _e992 {
                                                    phi_3174_ = _e901;
                                                } else {
                                                    phi_3174_ = _e906;
                                                }
                                                let _e1019 = phi_3174_;
                                                phi_3175_ = _e1019;
                                                phi_3176_ = (_e666 + 1u);
                                            } else {
                                                phi_3175_ = type_50();
                                                phi_3176_ = u32();
                                            }
                                            let _e1021 = phi_3175_;
                                            let _e1023 = phi_3176_;
                                            phi_3178_ = _e1021;
                                            phi_3179_ = _e1023;
                                            phi_3180_ = select(true, false, _e991);
                                        } else {
                                            phi_3178_ = type_50();
                                            phi_3179_ = u32();
                                            phi_3180_ = true;
                                        }
                                        let _e1026 = phi_3178_;
                                        let _e1028 = phi_3179_;
                                        let _e1030 = phi_3180_;
                                        if _e1030 {
                                            if _e990 {
                                                phi_3187_ = _e901;
                                            } else {
                                                phi_3187_ = _e906;
                                            }
                                            let _e1032 = phi_3187_;
                                            phi_3192_ = select(_e991, true, _e990);
                                            phi_3193_ = _e1032;
                                        } else {
                                            phi_3192_ = _e662;
                                            phi_3193_ = _e1026;
                                        }
                                        let _e1035 = phi_3192_;
                                        let _e1037 = phi_3193_;
                                        phi_3706_ = _e621;
                                        phi_3195_ = _e623;
                                        phi_3196_ = _e1035;
                                        phi_3197_ = _e1037;
                                        phi_3198_ = select(_e1028, _e666, _e1030);
                                    }
                                    let _e1619 = phi_3706_;
                                    let _e1621 = phi_3195_;
                                    let _e1623 = phi_3196_;
                                    let _e1625 = phi_3197_;
                                    let _e1627 = phi_3198_;
                                    phi_3705_ = _e1619;
                                    phi_3199_ = _e1621;
                                    phi_3200_ = _e1623;
                                    phi_3201_ = _e1625;
                                    phi_3202_ = _e1627;
                                    phi_3203_ = (_e631 - 1u);
                                } else {
                                    phi_3705_ = _e621;
                                    phi_3199_ = _e623;
                                    phi_3200_ = _e662;
                                    phi_3201_ = _e664;
                                    phi_3202_ = _e666;
                                    phi_3203_ = _e631;
                                }
                                let _e1629 = phi_3705_;
                                let _e1631 = phi_3199_;
                                let _e1633 = phi_3200_;
                                let _e1635 = phi_3201_;
                                let _e1637 = phi_3202_;
                                let _e1639 = phi_3203_;
                                phi_3704_ = _e1629;
                                phi_3204_ = _e1631;
                                phi_3205_ = _e1633;
                                phi_3206_ = _e1635;
                                phi_3207_ = _e1637;
                                phi_3208_ = _e1639;
                            } else {
                                phi_3704_ = _e621;
                                phi_3204_ = type_33();
                                phi_3205_ = bool();
                                phi_3206_ = type_50();
                                phi_3207_ = u32();
                                phi_3208_ = u32();
                            }
                            let _e1641 = phi_3704_;
                            let _e1643 = phi_3204_;
                            let _e1645 = phi_3205_;
                            let _e1647 = phi_3206_;
                            let _e1649 = phi_3207_;
                            let _e1651 = phi_3208_;
                            phi_3703_ = _e1641;
                            phi_1126_ = _e1643;
                            phi_1129_ = _e1645;
                            phi_1131_ = _e1647;
                            phi_1133_ = _e1649;
                            phi_1135_ = _e1651;
                            phi_3209_ = _e635;
                        } else {
                            phi_3703_ = _e621;
                            phi_1126_ = type_33();
                            phi_1129_ = bool();
                            phi_1131_ = type_50();
                            phi_1133_ = u32();
                            phi_1135_ = u32();
                            phi_3209_ = false;
                        }
                        let _e1653 = phi_3703_;
                        let _e1655 = phi_1126_;
                        let _e1657 = phi_1129_;
                        let _e1659 = phi_1131_;
                        let _e1661 = phi_1133_;
                        let _e1663 = phi_1135_;
                        let _e1665 = phi_3209_;
                        continue;
                        continuing {
                            phi_3555_ = _e1653;
                            phi_1125_ = _e1655;
                            phi_1128_ = _e1657;
                            phi_1130_ = _e1659;
                            phi_1132_ = _e1661;
                            phi_1134_ = _e1663;
                            phi_3702_ = _e1653;
                            break if !(_e1665);
                        }
                    }
                    let _e1668 = phi_3702_;
                    if _e1668 {
                        break;
                    }
                    let _e1670 = local_11;
                    if (_e1670.member.member_3 != 4294967295u) {
                        let _e1675 = -(_e491);
                        let _e1676 = bitcast<u32>(_e1670.member.member);
                        let _e1680 = (bitcast<i32>((_e1676 >> bitcast<u32>(23i))) & 255i);
                        let _e1681 = (_e1680 + _e1675);
                        if (_e1680 == 255i) {
                            phi_3268_ = _e1670.member.member;
                        } else {
                            if (_e1680 > 0i) {
                                if (_e1681 > 0i) {
                                    let _e1685 = (_e1681 < 255i);
                                    if _e1685 {
                                        phi_3247_ = bitcast<f32>((_e1676 + bitcast<u32>((_e1675 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3247_ = f32();
                                    }
                                    let _e1692 = phi_3247_;
                                    phi_3249_ = _e1692;
                                    phi_3250_ = select(true, false, _e1685);
                                } else {
                                    phi_3249_ = f32();
                                    phi_3250_ = true;
                                }
                                let _e1695 = phi_3249_;
                                let _e1697 = phi_3250_;
                                phi_3251_ = _e1695;
                                phi_3252_ = _e1697;
                            } else {
                                phi_3251_ = f32();
                                phi_3252_ = true;
                            }
                            let _e1699 = phi_3251_;
                            let _e1701 = phi_3252_;
                            if _e1701 {
                                let _e1702 = (_e1676 & 2147483648u);
                                let _e1709 = ((_e1676 & 8388607u) | (select(0u, 1u, ((_e1676 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1713 = (_e1709 == 0u);
                                if _e1713 {
                                    phi_3519_ = bitcast<f32>(_e1702);
                                } else {
                                    let _e1718 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1709)), 32u, _e1713) - 8u);
                                    let _e1721 = (_e1709 << bitcast<u32>((_e1718 & 31u)));
                                    let _e1723 = ((_e1681 + select(0i, 1i, (_e1680 == 0i))) - bitcast<i32>(_e1718));
                                    if (_e1723 >= 255i) {
                                        phi_3509_ = bitcast<f32>((_e1702 | 2139095040u));
                                        phi_3510_ = f32();
                                        phi_3511_ = true;
                                    } else {
                                        let _e1725 = (_e1723 > 0i);
                                        if _e1725 {
                                            phi_3503_ = bitcast<f32>(((_e1702 | (bitcast<u32>(_e1723) << bitcast<u32>(23i))) | (_e1721 & 8388607u)));
                                            phi_3504_ = f32();
                                        } else {
                                            if (_e1723 < -24i) {
                                                phi_3469_ = 26u;
                                            } else {
                                                phi_3469_ = bitcast<u32>((1i - _e1723));
                                            }
                                            let _e1730 = phi_3469_;
                                            let _e1731 = (_e1730 & 31u);
                                            let _e1733 = (_e1721 >> bitcast<u32>(_e1731));
                                            let _e1737 = (_e1721 & ((1u << bitcast<u32>(_e1731)) - 1u));
                                            let _e1741 = (1u << bitcast<u32>(((_e1730 - 1u) & 31u)));
                                            if (_e1737 > _e1741) {
                                                phi_3490_ = true;
                                            } else {
                                                if (_e1737 == _e1741) {
                                                    phi_3487_ = ((_e1733 & 1u) == 1u);
                                                } else {
                                                    phi_3487_ = false;
                                                }
                                                let _e1747 = phi_3487_;
                                                phi_3490_ = _e1747;
                                            }
                                            let _e1749 = phi_3490_;
                                            phi_3503_ = f32();
                                            phi_3504_ = bitcast<f32>((_e1702 | (_e1733 + select(0u, 1u, _e1749))));
                                        }
                                        let _e1762 = phi_3503_;
                                        let _e1764 = phi_3504_;
                                        phi_3509_ = _e1762;
                                        phi_3510_ = _e1764;
                                        phi_3511_ = _e1725;
                                    }
                                    let _e1768 = phi_3509_;
                                    let _e1770 = phi_3510_;
                                    let _e1772 = phi_3511_;
                                    phi_3519_ = select(_e1770, _e1768, _e1772);
                                }
                                let _e1776 = phi_3519_;
                                phi_3267_ = _e1776;
                            } else {
                                phi_3267_ = _e1699;
                            }
                            let _e1778 = phi_3267_;
                            phi_3268_ = _e1778;
                        }
                        let _e1780 = phi_3268_;
                        let _e1781 = bitcast<u32>(_e1780);
                        if ((_e1781 & 2147483647u) >= 2139095040u) {
                            phi_3280_ = bitcast<f32>(((_e1781 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3280_ = _e1780;
                        }
                        let _e1788 = phi_3280_;
                        phi_3285_ = type_22(_e1788, _e1670.member.member_1, _e1670.member.member_2, _e1670.member.member_3);
                    } else {
                        phi_3285_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1793 = phi_3285_;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135] = _e1793;
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
