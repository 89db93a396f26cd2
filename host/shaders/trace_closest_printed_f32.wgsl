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

struct type_37 {
    member: array<type_26>,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_49 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_37;
@group(0) @binding(2) 
var<storage> global_5: type_44;
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
    var phi_422_: i32;
    var phi_423_: i32;
    var phi_433_: bool;
    var phi_443_: u32;
    var phi_444_: u32;
    var phi_446_: bool;
    var phi_451_: u32;
    var phi_464_: i32;
    var phi_484_: i32;
    var phi_502_: f32;
    var phi_508_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_606_: f32;
    var phi_618_: f32;
    var phi_627_: f32;
    var phi_633_: f32;
    var phi_673_: f32;
    var phi_679_: f32;
    var phi_731_: f32;
    var phi_743_: f32;
    var phi_752_: f32;
    var phi_758_: f32;
    var phi_798_: f32;
    var phi_804_: f32;
    var phi_856_: f32;
    var phi_868_: f32;
    var phi_923_: i32;
    var phi_945_: u32;
    var phi_946_: u32;
    var phi_983_: i32;
    var phi_1005_: u32;
    var phi_1006_: u32;
    var phi_1014_: f32;
    var phi_1015_: f32;
    var phi_3529_: bool;
    var phi_1098_: type_33;
    var phi_1101_: u32;
    var phi_1103_: bool;
    var phi_1105_: u32;
    var phi_1107_: type_49;
    var phi_1118_: bool;
    var phi_1204_: bool;
    var phi_1205_: u32;
    var phi_1206_: type_49;
    var phi_1224_: type_33;
    var phi_1227_: type_4;
    var phi_1228_: type_4;
    var phi_1250_: type_4;
    var phi_1271_: u32;
    var phi_1363_: array<array<f32, 3>, 3>;
    var phi_1515_: bool;
    var phi_1544_: bool;
    var phi_1963_: f32;
    var phi_1964_: f32;
    var phi_1965_: f32;
    var phi_1966_: f32;
    var phi_1967_: vec3<f32>;
    var phi_1968_: vec3<f32>;
    var phi_1969_: vec3<f32>;
    var phi_1970_: vec3<f32>;
    var phi_2007_: bool;
    var phi_2016_: vec3<f32>;
    var phi_2181_: f32;
    var phi_2183_: f32;
    var phi_2184_: bool;
    var phi_2204_: f32;
    var phi_2205_: f32;
    var phi_2228_: type_22;
    var phi_2230_: type_22;
    var phi_2231_: bool;
    var phi_2235_: type_22;
    var phi_2236_: type_22;
    var phi_2237_: type_22;
    var phi_2238_: bool;
    var phi_2242_: type_22;
    var phi_2243_: bool;
    var phi_2244_: type_22;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: type_22;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2257_: type_22;
    var phi_2258_: bool;
    var phi_2262_: type_22;
    var phi_2287_: bool;
    var phi_2288_: bool;
    var phi_2294_: type_33;
    var phi_2295_: type_33;
    var phi_2296_: type_33;
    var phi_1225_: type_33;
    var phi_3523_: bool;
    var phi_3742_: bool;
    var phi_2297_: type_33;
    var phi_2318_: type_42;
    var phi_3204_: type_49;
    var phi_3280_: type_49;
    var phi_3281_: u32;
    var phi_3282_: type_49;
    var phi_3284_: u32;
    var phi_3285_: type_49;
    var phi_3286_: bool;
    var phi_3293_: type_49;
    var phi_3298_: bool;
    var phi_3300_: type_49;
    var phi_3304_: bool;
    var phi_3305_: u32;
    var phi_3306_: type_49;
    var phi_3316_: type_49;
    var phi_3686_: bool;
    var phi_3317_: type_33;
    var phi_3318_: u32;
    var phi_3319_: bool;
    var phi_3320_: u32;
    var phi_3321_: type_49;
    var phi_3685_: bool;
    var phi_3322_: type_33;
    var phi_3323_: u32;
    var phi_3324_: bool;
    var phi_3325_: u32;
    var phi_3326_: type_49;
    var phi_3684_: bool;
    var phi_1099_: type_33;
    var phi_1102_: u32;
    var phi_1104_: bool;
    var phi_1106_: u32;
    var phi_1108_: type_49;
    var phi_3327_: bool;
    var phi_3683_: bool;
    var local_10: type_33;
    var phi_3365_: f32;
    var phi_3367_: f32;
    var phi_3368_: bool;
    var phi_3369_: f32;
    var phi_3370_: bool;
    var phi_3443_: u32;
    var phi_3461_: bool;
    var phi_3464_: bool;
    var phi_3477_: f32;
    var phi_3478_: f32;
    var phi_3483_: f32;
    var phi_3484_: f32;
    var phi_3485_: bool;
    var phi_3493_: f32;
    var phi_3385_: f32;
    var phi_3386_: f32;
    var phi_3398_: f32;
    var phi_3403_: type_22;
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
                            phi_422_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_422_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_422_;
                        phi_423_ = _e228;
                    } else {
                        phi_423_ = 0i;
                    }
                    let _e230 = phi_423_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_433_ = true;
                    } else {
                        phi_433_ = (_e154 == _e186);
                    }
                    let _e234 = phi_433_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_443_ = _e236;
                        phi_444_ = _e236;
                        phi_446_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_443_ = u32();
                        phi_444_ = 0u;
                        phi_446_ = true;
                    }
                    let _e240 = phi_443_;
                    let _e242 = phi_444_;
                    let _e244 = phi_446_;
                    if _e244 {
                        phi_451_ = (_e242 + 1u);
                    } else {
                        phi_451_ = 0u;
                    }
                    let _e248 = phi_451_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_464_ = -126i;
                    } else {
                        phi_464_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_464_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_484_ = -126i;
                    } else {
                        phi_484_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_484_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_502_ = _e287[0];
                    } else {
                        phi_502_ = _e287[1];
                    }
                    let _e292 = phi_502_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_508_ = _e287[2];
                    } else {
                        phi_508_ = _e292;
                    }
                    let _e296 = phi_508_;
                    let _e297 = bitcast<u32>(_e296);
                    let _e299 = ((_e297 & 2139095040u) != 0u);
                    let _e313 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e297 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e297 & 2147483648u))), _e296, _e299) * _e260) * select(0.00000011920929f, 1f, _e299)) * _e266);
                    let _e314 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_548_ = _e314[0];
                    } else {
                        phi_548_ = _e314[1];
                    }
                    let _e318 = phi_548_;
                    if _e293 {
                        phi_554_ = _e314[2];
                    } else {
                        phi_554_ = _e318;
                    }
                    let _e321 = phi_554_;
                    let _e322 = bitcast<u32>(_e321);
                    let _e324 = ((_e322 & 2139095040u) != 0u);
                    let _e338 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e322 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e322 & 2147483648u))), _e321, _e324) * _e277) * select(0.00000011920929f, 1f, _e324)) * _e283);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_606_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_606_ = 0f;
                    }
                    let _e350 = phi_606_;
                    let _e351 = (_e313 + _e350);
                    let _e352 = (_e313 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_618_ = 38685626000000000000000000f;
                    } else {
                        phi_618_ = (1f / _e338);
                    }
                    let _e356 = phi_618_;
                    let _e357 = (_e248 == 0u);
                    if _e357 {
                        phi_627_ = _e287[0];
                    } else {
                        phi_627_ = _e287[1];
                    }
                    let _e361 = phi_627_;
                    let _e362 = (_e248 == 2u);
                    if _e362 {
                        phi_633_ = _e287[2];
                    } else {
                        phi_633_ = _e361;
                    }
                    let _e365 = phi_633_;
                    let _e366 = bitcast<u32>(_e365);
                    let _e368 = ((_e366 & 2139095040u) != 0u);
                    let _e382 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e366 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e366 & 2147483648u))), _e365, _e368) * _e260) * select(0.00000011920929f, 1f, _e368)) * _e266);
                    if _e357 {
                        phi_673_ = _e314[0];
                    } else {
                        phi_673_ = _e314[1];
                    }
                    let _e386 = phi_673_;
                    if _e362 {
                        phi_679_ = _e314[2];
                    } else {
                        phi_679_ = _e386;
                    }
                    let _e389 = phi_679_;
                    let _e390 = bitcast<u32>(_e389);
                    let _e392 = ((_e390 & 2139095040u) != 0u);
                    let _e406 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e390 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e390 & 2147483648u))), _e389, _e392) * _e277) * select(0.00000011920929f, 1f, _e392)) * _e283);
                    let _e410 = (bitcast<f32>((bitcast<u32>(_e406) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e410 {
                        let _e414 = (bitcast<f32>((bitcast<u32>(_e382) & 2147483647u)) * 0.00000011920929f);
                        phi_731_ = select(0.00000000000011368684f, _e414, (_e414 > 0.00000000000011368684f));
                    } else {
                        phi_731_ = 0f;
                    }
                    let _e418 = phi_731_;
                    let _e419 = (_e382 + _e418);
                    let _e420 = (_e382 - _e418);
                    let _e421 = select(_e406, 0f, _e410);
                    if _e410 {
                        phi_743_ = 38685626000000000000000000f;
                    } else {
                        phi_743_ = (1f / _e406);
                    }
                    let _e424 = phi_743_;
                    let _e425 = (_e250 == 0u);
                    if _e425 {
                        phi_752_ = _e287[0];
                    } else {
                        phi_752_ = _e287[1];
                    }
                    let _e429 = phi_752_;
                    let _e430 = (_e250 == 2u);
                    if _e430 {
                        phi_758_ = _e287[2];
                    } else {
                        phi_758_ = _e429;
                    }
                    let _e433 = phi_758_;
                    let _e434 = bitcast<u32>(_e433);
                    let _e436 = ((_e434 & 2139095040u) != 0u);
                    let _e450 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e434 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e434 & 2147483648u))), _e433, _e436) * _e260) * select(0.00000011920929f, 1f, _e436)) * _e266);
                    if _e425 {
                        phi_798_ = _e314[0];
                    } else {
                        phi_798_ = _e314[1];
                    }
                    let _e454 = phi_798_;
                    if _e430 {
                        phi_804_ = _e314[2];
                    } else {
                        phi_804_ = _e454;
                    }
                    let _e457 = phi_804_;
                    let _e458 = bitcast<u32>(_e457);
                    let _e460 = ((_e458 & 2139095040u) != 0u);
                    let _e474 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e458 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e458 & 2147483648u))), _e457, _e460) * _e277) * select(0.00000011920929f, 1f, _e460)) * _e283);
                    let _e478 = (bitcast<f32>((bitcast<u32>(_e474) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e478 {
                        let _e482 = (bitcast<f32>((bitcast<u32>(_e450) & 2147483647u)) * 0.00000011920929f);
                        phi_856_ = select(0.00000000000011368684f, _e482, (_e482 > 0.00000000000011368684f));
                    } else {
                        phi_856_ = 0f;
                    }
                    let _e486 = phi_856_;
                    let _e487 = (_e450 + _e486);
                    let _e488 = (_e450 - _e486);
                    let _e489 = select(_e474, 0f, _e478);
                    if _e478 {
                        phi_868_ = 38685626000000000000000000f;
                    } else {
                        phi_868_ = (1f / _e474);
                    }
                    let _e492 = phi_868_;
                    let _e495 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                    let _e498 = bitcast<f32>((bitcast<u32>(_e382) & 2147483647u));
                    let _e500 = select(_e498, _e495, (_e495 > _e498));
                    let _e503 = bitcast<f32>((bitcast<u32>(_e450) & 2147483647u));
                    let _e506 = (_e125 + _e230);
                    if (_e211 && (select(_e503, _e500, (_e500 > _e503)) <= 1099511600000f)) {
                        let _e516 = ((_e198 & 8388607u) | (select(0u, 1u, ((_e198 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e519 = bitcast<i32>((_e198 >> bitcast<u32>(23i)));
                        let _e523 = (_e516 == 0u);
                        let _e526 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e516)), 32u, _e523)) - 8i);
                        if (_e519 == 255i) {
                            phi_923_ = 255i;
                        } else {
                            phi_923_ = (((_e519 + select(0i, 1i, (_e519 == 0i))) - _e526) + _e506);
                        }
                        let _e534 = phi_923_;
                        let _e544 = (_e534 <= 0i);
                        if _e544 {
                            phi_946_ = u32();
                        } else {
                            if _e523 {
                                phi_945_ = u32();
                            } else {
                                phi_945_ = select(((bitcast<u32>(_e534) << bitcast<u32>(23i)) | ((_e516 << bitcast<u32>(((_e526 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e534 >= 255i));
                            }
                            let _e548 = phi_945_;
                            phi_946_ = _e548;
                        }
                        let _e550 = phi_946_;
                        let _e562 = ((_e207 & 8388607u) | (select(0u, 1u, ((_e207 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e565 = bitcast<i32>((_e207 >> bitcast<u32>(23i)));
                        let _e569 = (_e562 == 0u);
                        let _e572 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e562)), 32u, _e569)) - 8i);
                        if (_e565 == 255i) {
                            phi_983_ = 255i;
                        } else {
                            phi_983_ = (((_e565 + select(0i, 1i, (_e565 == 0i))) - _e572) + _e506);
                        }
                        let _e580 = phi_983_;
                        let _e590 = (_e580 <= 0i);
                        if _e590 {
                            phi_1006_ = u32();
                        } else {
                            if _e569 {
                                phi_1005_ = u32();
                            } else {
                                phi_1005_ = select(((bitcast<u32>(_e580) << bitcast<u32>(23i)) | ((_e562 << bitcast<u32>(((_e572 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e580 >= 255i));
                            }
                            let _e594 = phi_1005_;
                            phi_1006_ = _e594;
                        }
                        let _e596 = phi_1006_;
                        phi_1014_ = bitcast<f32>(((_e206 & 2147483648u) | select(_e596, 0u, select(_e569, true, _e590))));
                        phi_1015_ = bitcast<f32>(((_e197 & 2147483648u) | select(_e550, 0u, select(_e523, true, _e544))));
                    } else {
                        phi_1014_ = 0f;
                        phi_1015_ = 1f;
                    }
                    let _e602 = phi_1014_;
                    let _e604 = phi_1015_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e609 = (_e249 % 3u);
                    let _e610 = (_e609 < 3u);
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e612 = local_9[_e609];
                    let _e613 = (_e248 % 3u);
                    let _e614 = (_e613 < 3u);
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e616 = local_9[_e613];
                    let _e617 = (_e250 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_9[_e617];
                    local_8 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e624 = local_8[_e609];
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e626 = local_8[_e613];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e628 = local_8[_e617];
                    phi_3529_ = false;
                    phi_1098_ = type_33(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e602);
                    phi_1101_ = ((3u * _e87) + 1u);
                    phi_1103_ = (_e604 <= _e602);
                    phi_1105_ = 0u;
                    phi_1107_ = type_49(type_47(array<f32, 3>(_e612, _e616, _e620), array<f32, 3>(_e624, _e626, _e628)), select(0u, 2147483648u, (_e87 == 0u)));
                    loop {
                        let _e636 = phi_3529_;
                        let _e638 = phi_1098_;
                        let _e640 = phi_1101_;
                        let _e642 = phi_1103_;
                        let _e644 = phi_1105_;
                        let _e646 = phi_1107_;
                        local_10 = _e638;
                        if _e642 {
                            phi_1118_ = true;
                        } else {
                            phi_1118_ = (_e644 > 0u);
                        }
                        let _e649 = phi_1118_;
                        if _e649 {
                            let _e650 = (_e640 > 0u);
                            if _e650 {
                                if _e642 {
                                    phi_1204_ = _e642;
                                    phi_1205_ = _e644;
                                    phi_1206_ = _e646;
                                } else {
                                    let _e651 = (_e644 - 1u);
                                    let _e652 = (_e651 % 128u);
                                    let _e653 = (_e652 < 128u);
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e655 = local_6[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e657 = local_5[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e659 = local_4[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e661 = local_3[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e664 = local_2[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e666 = local_1[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e668 = local[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3683_ = true;
                                        break;
                                    }
                                    let _e673 = local_7[_e652];
                                    phi_1204_ = (_e673 <= _e638.member_1);
                                    phi_1205_ = _e651;
                                    phi_1206_ = type_49(type_47(array<f32, 3>(_e657, _e659, _e661), array<f32, 3>(_e664, _e666, _e668)), _e655);
                                }
                                let _e677 = phi_1204_;
                                let _e679 = phi_1205_;
                                let _e681 = phi_1206_;
                                if _e677 {
                                    let _e685 = ((_e681.member_1 & 2147483648u) != 0u);
                                    if _e685 {
                                        phi_1224_ = _e638;
                                        phi_1227_ = type_4(0u, ((_e681.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e692 = phi_1224_;
                                            let _e694 = phi_1227_;
                                            local_11 = _e692;
                                            if (_e694.member < _e694.member_1) {
                                                phi_1228_ = type_4((_e694.member + 1u), _e694.member_1);
                                                phi_1250_ = type_4(1u, _e694.member);
                                            } else {
                                                phi_1228_ = _e694;
                                                phi_1250_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e707 = phi_1228_;
                                            let _e709 = phi_1250_;
                                            let _e713 = (bitcast<i32>(_e709.member) != 0i);
                                            if _e713 {
                                                let _e714 = ((_e681.member_1 & 268435455u) + _e709.member_1);
                                                let _e715 = (_e714 < _e89);
                                                if _e715 {
                                                    if _e715 {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e719 = global_2.member[_e714].member_1;
                                                    phi_1271_ = _e719;
                                                } else {
                                                    phi_1271_ = 4294967295u;
                                                }
                                                let _e721 = phi_1271_;
                                                if (_e714 >= _e89) {
                                                    phi_1363_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e715 {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    if (_e609 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e728 = global_2.member[_e714].member[_e609];
                                                    if (_e613 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e734 = global_2.member[_e714].member[_e613];
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e740 = global_2.member[_e714].member[_e617];
                                                    let _e742 = (3u + _e609);
                                                    if (_e742 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e748 = global_2.member[_e714].member[_e742];
                                                    let _e749 = (3u + _e613);
                                                    if (_e749 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e755 = global_2.member[_e714].member[_e749];
                                                    let _e756 = (3u + _e617);
                                                    if (_e756 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e762 = global_2.member[_e714].member[_e756];
                                                    let _e764 = (6u + _e609);
                                                    if (_e764 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e770 = global_2.member[_e714].member[_e764];
                                                    let _e771 = (6u + _e613);
                                                    if (_e771 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e777 = global_2.member[_e714].member[_e771];
                                                    let _e778 = (6u + _e617);
                                                    if (_e778 < 9u) {
                                                    } else {
                                                        phi_3523_ = true;
                                                        break;
                                                    }
                                                    let _e784 = global_2.member[_e714].member[_e778];
                                                    phi_1363_ = array<array<f32, 3>, 3>(array<f32, 3>(_e728, _e734, _e740), array<f32, 3>(_e748, _e755, _e762), array<f32, 3>(_e770, _e777, _e784));
                                                }
                                                let _e788 = phi_1363_;
                                                let _e796 = (_e788[0][2] - _e450);
                                                let _e799 = (((_e788[0][0] - _e313) * _e489) - (_e796 * _e353));
                                                let _e802 = (((_e788[0][1] - _e382) * _e489) - (_e796 * _e421));
                                                let _e809 = (_e788[1][2] - _e450);
                                                let _e812 = (((_e788[1][0] - _e313) * _e489) - (_e809 * _e353));
                                                let _e815 = (((_e788[1][1] - _e382) * _e489) - (_e809 * _e421));
                                                let _e822 = (_e788[2][2] - _e450);
                                                let _e825 = (((_e788[2][0] - _e313) * _e489) - (_e822 * _e353));
                                                let _e828 = (((_e788[2][1] - _e382) * _e489) - (_e822 * _e421));
                                                let _e829 = (_e825 * _e815);
                                                let _e830 = (_e828 * _e812);
                                                let _e831 = (_e799 * _e828);
                                                let _e832 = (_e802 * _e825);
                                                let _e833 = (_e812 * _e802);
                                                let _e834 = (_e815 * _e799);
                                                let _e839 = (((_e829 >= _e830) && (_e831 >= _e832)) && (_e833 >= _e834));
                                                if (_e839 || (((_e829 <= _e830) && (_e831 <= _e832)) && (_e833 <= _e834))) {
                                                    let _e846 = select(-1f, 1f, _e839);
                                                    let _e848 = ((_e829 - _e830) * _e846);
                                                    let _e850 = select(0f, _e848, (_e848 > 0f));
                                                    let _e852 = ((_e831 - _e832) * _e846);
                                                    let _e854 = select(0f, _e852, (_e852 > 0f));
                                                    let _e856 = ((_e833 - _e834) * _e846);
                                                    let _e858 = select(0f, _e856, (_e856 > 0f));
                                                    let _e860 = ((_e850 + _e854) + _e858);
                                                    if (_e860 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2247_ = type_22();
                                                        phi_2248_ = true;
                                                        phi_2249_ = false;
                                                    } else {
                                                        let _e863 = select(_e812, _e799, (_e799 < _e812));
                                                        if (select(_e825, _e863, (_e863 < _e825)) > 0f) {
                                                            phi_1515_ = true;
                                                        } else {
                                                            let _e868 = select(_e812, _e799, (_e799 > _e812));
                                                            phi_1515_ = (select(_e825, _e868, (_e868 > _e825)) < 0f);
                                                        }
                                                        let _e873 = phi_1515_;
                                                        if _e873 {
                                                            phi_2244_ = type_22();
                                                            phi_2245_ = true;
                                                            phi_2246_ = false;
                                                        } else {
                                                            let _e875 = select(_e815, _e802, (_e802 < _e815));
                                                            if (select(_e828, _e875, (_e875 < _e828)) > 0f) {
                                                                phi_1544_ = true;
                                                            } else {
                                                                let _e880 = select(_e815, _e802, (_e802 > _e815));
                                                                phi_1544_ = (select(_e828, _e880, (_e880 > _e828)) < 0f);
                                                            }
                                                            let _e885 = phi_1544_;
                                                            if _e885 {
                                                                phi_2242_ = type_22();
                                                                phi_2243_ = false;
                                                            } else {
                                                                let _e887 = select(_e788[1][0], _e788[0][0], (_e788[0][0] < _e788[1][0]));
                                                                let _e891 = select(_e788[1][0], _e788[0][0], (_e788[0][0] > _e788[1][0]));
                                                                let _e895 = select(_e788[1][1], _e788[0][1], (_e788[0][1] < _e788[1][1]));
                                                                let _e899 = select(_e788[1][1], _e788[0][1], (_e788[0][1] > _e788[1][1]));
                                                                let _e903 = select(_e788[1][2], _e788[0][2], (_e788[0][2] < _e788[1][2]));
                                                                let _e907 = select(_e788[1][2], _e788[0][2], (_e788[0][2] > _e788[1][2]));
                                                                let _e912 = ((select(_e788[2][0], _e887, (_e887 < _e788[2][0])) - _e351) * _e356);
                                                                let _e913 = ((select(_e788[2][0], _e891, (_e891 > _e788[2][0])) - _e352) * _e356);
                                                                let _e916 = ((select(_e788[2][1], _e895, (_e895 < _e788[2][1])) - _e419) * _e424);
                                                                let _e917 = ((select(_e788[2][1], _e899, (_e899 > _e788[2][1])) - _e420) * _e424);
                                                                let _e920 = ((select(_e788[2][2], _e903, (_e903 < _e788[2][2])) - _e487) * _e492);
                                                                let _e921 = ((select(_e788[2][2], _e907, (_e907 > _e788[2][2])) - _e488) * _e492);
                                                                let _e923 = select(_e921, _e920, (_e920 < _e921));
                                                                let _e925 = select(_e921, _e920, (_e920 > _e921));
                                                                let _e927 = select(_e913, _e912, (_e912 < _e913));
                                                                let _e929 = select(_e917, _e916, (_e916 < _e917));
                                                                let _e931 = select(_e929, _e927, (_e927 > _e929));
                                                                let _e933 = select(_e923, _e931, (_e931 > _e923));
                                                                let _e935 = select(_e913, _e912, (_e912 > _e913));
                                                                let _e937 = select(_e917, _e916, (_e916 > _e917));
                                                                let _e939 = select(_e937, _e935, (_e935 < _e937));
                                                                let _e941 = select(_e925, _e939, (_e939 < _e925));
                                                                let _e942 = -(_e923);
                                                                let _e948 = select(_e604, _e933, (_e933 > _e604));
                                                                if (_e948 > (_e941 + (select(_e942, _e925, (_e925 > _e942)) * 0.0000019073523f))) {
                                                                    phi_2237_ = type_22();
                                                                    phi_2238_ = true;
                                                                } else {
                                                                    let _e950 = (_e948 > _e692.member_1);
                                                                    if _e950 {
                                                                        phi_2236_ = type_22();
                                                                    } else {
                                                                        let _e951 = vec3<f32>(_e788[0][0], _e788[0][1], _e788[0][2]);
                                                                        let _e952 = vec3<f32>(_e788[1][0], _e788[1][1], _e788[1][2]);
                                                                        let _e953 = vec3<f32>(_e788[2][0], _e788[2][1], _e788[2][2]);
                                                                        let _e954 = (_e788[1][0] - _e788[0][0]);
                                                                        let _e955 = (_e788[1][1] - _e788[0][1]);
                                                                        let _e956 = (_e788[1][2] - _e788[0][2]);
                                                                        let _e957 = vec3<f32>(_e954, _e955, _e956);
                                                                        let _e958 = (_e788[2][0] - _e788[1][0]);
                                                                        let _e959 = (_e788[2][1] - _e788[1][1]);
                                                                        let _e960 = (_e788[2][2] - _e788[1][2]);
                                                                        let _e961 = vec3<f32>(_e958, _e959, _e960);
                                                                        let _e962 = (_e788[0][0] - _e788[2][0]);
                                                                        let _e963 = (_e788[0][1] - _e788[2][1]);
                                                                        let _e964 = (_e788[0][2] - _e788[2][2]);
                                                                        let _e965 = vec3<f32>(_e962, _e963, _e964);
                                                                        let _e968 = bitcast<f32>((bitcast<u32>(_e954) & 2147483647u));
                                                                        let _e971 = bitcast<f32>((bitcast<u32>(_e955) & 2147483647u));
                                                                        let _e973 = select(_e971, _e968, (_e968 > _e971));
                                                                        let _e976 = bitcast<f32>((bitcast<u32>(_e956) & 2147483647u));
                                                                        let _e978 = select(_e976, _e973, (_e973 > _e976));
                                                                        let _e981 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                        let _e984 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                        let _e986 = select(_e984, _e981, (_e981 > _e984));
                                                                        let _e989 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                        let _e991 = select(_e989, _e986, (_e986 > _e989));
                                                                        let _e994 = bitcast<f32>((bitcast<u32>(_e962) & 2147483647u));
                                                                        let _e997 = bitcast<f32>((bitcast<u32>(_e963) & 2147483647u));
                                                                        let _e999 = select(_e997, _e994, (_e994 > _e997));
                                                                        let _e1002 = bitcast<f32>((bitcast<u32>(_e964) & 2147483647u));
                                                                        let _e1004 = select(_e1002, _e999, (_e999 > _e1002));
                                                                        let _e1006 = select(_e991, _e978, (_e978 > _e991));
                                                                        let _e1008 = select(_e1004, _e1006, (_e1006 > _e1004));
                                                                        if (_e978 == _e1008) {
                                                                            phi_1963_ = _e815;
                                                                            phi_1964_ = _e812;
                                                                            phi_1965_ = _e802;
                                                                            phi_1966_ = _e799;
                                                                            phi_1967_ = _e951;
                                                                            phi_1968_ = _e965;
                                                                            phi_1969_ = _e961;
                                                                            phi_1970_ = _e957;
                                                                        } else {
                                                                            let _e1010 = (_e991 == _e1008);
                                                                            let _e1015 = vec3(_e1010);
                                                                            phi_1963_ = select(_e802, _e828, _e1010);
                                                                            phi_1964_ = select(_e799, _e825, _e1010);
                                                                            phi_1965_ = select(_e828, _e815, _e1010);
                                                                            phi_1966_ = select(_e825, _e812, _e1010);
                                                                            phi_1967_ = select(_e953, _e952, _e1015);
                                                                            phi_1968_ = select(_e961, _e957, _e1015);
                                                                            phi_1969_ = select(_e957, _e965, _e1015);
                                                                            phi_1970_ = select(_e965, _e961, _e1015);
                                                                        }
                                                                        let _e1021 = phi_1963_;
                                                                        let _e1023 = phi_1964_;
                                                                        let _e1025 = phi_1965_;
                                                                        let _e1027 = phi_1966_;
                                                                        let _e1029 = phi_1967_;
                                                                        let _e1031 = phi_1968_;
                                                                        let _e1033 = phi_1969_;
                                                                        let _e1035 = phi_1970_;
                                                                        let _e1042 = ((_e1033.y * _e1031.z) - (_e1031.y * _e1033.z));
                                                                        let _e1047 = ((_e1033.z * _e1031.x) - (_e1031.z * _e1033.x));
                                                                        let _e1050 = ((_e1033.x * _e1031.y) - (_e1031.x * _e1033.y));
                                                                        if (_e850 >= _e854) {
                                                                            phi_2007_ = select(true, false, (_e850 >= _e858));
                                                                        } else {
                                                                            phi_2007_ = true;
                                                                        }
                                                                        let _e1055 = phi_2007_;
                                                                        if _e1055 {
                                                                            phi_2016_ = select(_e953, _e952, vec3((_e854 >= _e858)));
                                                                        } else {
                                                                            phi_2016_ = _e951;
                                                                        }
                                                                        let _e1060 = phi_2016_;
                                                                        let _e1071 = (((_e1042 * (_e1060.x - _e313)) + (_e1047 * (_e1060.y - _e382))) + (_e1050 * (_e1060.z - _e450)));
                                                                        let _e1076 = (((_e1042 * _e353) + (_e1047 * _e421)) + (_e1050 * _e489));
                                                                        let _e1077 = (_e1023 - _e1027);
                                                                        let _e1078 = (_e1021 - _e1025);
                                                                        let _e1086 = (-(((_e1027 * _e1077) + (_e1025 * _e1078))) / ((_e1077 * _e1077) + (_e1078 * _e1078)));
                                                                        let _e1088 = select(1f, _e1086, (_e1086 < 1f));
                                                                        let _e1090 = select(0f, _e1088, (_e1088 > 0f));
                                                                        let _e1103 = ((_e1029.x + (_e1035.x * _e1090)) - _e313);
                                                                        let _e1104 = ((_e1029.y + (_e1035.y * _e1090)) - _e382);
                                                                        let _e1105 = ((_e1029.z + (_e1035.z * _e1090)) - _e450);
                                                                        let _e1106 = (_e1105 / _e489);
                                                                        let _e1118 = bitcast<f32>((bitcast<u32>(_e1103) & 2147483647u));
                                                                        let _e1121 = bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u));
                                                                        let _e1123 = select(_e1121, _e1118, (_e1118 > _e1121));
                                                                        let _e1126 = bitcast<f32>((bitcast<u32>(_e1105) & 2147483647u));
                                                                        let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                                        let _e1134 = bitcast<f32>((bitcast<u32>(_e1042) & 2147483647u));
                                                                        let _e1137 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                        let _e1139 = select(_e1137, _e1134, (_e1134 > _e1137));
                                                                        let _e1142 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1042 * _e1103) + (_e1047 * _e1104)) + (_e1050 * _e1105)) - _e1071)) & 2147483647u)) <= ((0.0000009536743f * select(_e1008, _e1128, (_e1128 > _e1008))) * select(_e1142, _e1139, (_e1139 > _e1142)))) {
                                                                            let _e1152 = bitcast<f32>((bitcast<u32>(_e1033.x) & 2147483647u));
                                                                            let _e1155 = bitcast<f32>((bitcast<u32>(_e1033.y) & 2147483647u));
                                                                            let _e1157 = select(_e1155, _e1152, (_e1152 > _e1155));
                                                                            let _e1160 = bitcast<f32>((bitcast<u32>(_e1033.z) & 2147483647u));
                                                                            let _e1166 = bitcast<f32>((bitcast<u32>(_e1031.x) & 2147483647u));
                                                                            let _e1169 = bitcast<f32>((bitcast<u32>(_e1031.y) & 2147483647u));
                                                                            let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                                            let _e1174 = bitcast<f32>((bitcast<u32>(_e1031.z) & 2147483647u));
                                                                            let _e1178 = (bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u)) > ((0.0000038146973f * select(_e1160, _e1157, (_e1157 > _e1160))) * select(_e1174, _e1171, (_e1171 > _e1174))));
                                                                            if _e1178 {
                                                                                phi_2181_ = (_e1071 / _e1076);
                                                                            } else {
                                                                                phi_2181_ = f32();
                                                                            }
                                                                            let _e1181 = phi_2181_;
                                                                            phi_2183_ = _e1181;
                                                                            phi_2184_ = select(true, false, _e1178);
                                                                        } else {
                                                                            phi_2183_ = f32();
                                                                            phi_2184_ = true;
                                                                        }
                                                                        let _e1184 = phi_2183_;
                                                                        let _e1186 = phi_2184_;
                                                                        if _e1186 {
                                                                            let _e1194 = (((_e1042 * (_e1103 - (_e353 * _e1106))) + (_e1047 * (_e1104 - (_e421 * _e1106)))) / _e1076);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u)) <= _e1008) {
                                                                                phi_2204_ = (_e1106 + _e1194);
                                                                            } else {
                                                                                phi_2204_ = _e1106;
                                                                            }
                                                                            let _e1201 = phi_2204_;
                                                                            phi_2205_ = _e1201;
                                                                        } else {
                                                                            phi_2205_ = _e1184;
                                                                        }
                                                                        let _e1203 = phi_2205_;
                                                                        let _e1205 = select(_e941, _e1203, (_e1203 < _e941));
                                                                        let _e1207 = select(_e933, _e1205, (_e1205 > _e933));
                                                                        if (_e1207 >= _e604) {
                                                                            let _e1209 = (_e1207 <= _e692.member_1);
                                                                            if _e1209 {
                                                                                let _e1210 = (1f / _e860);
                                                                                phi_2228_ = type_22(_e1207, (_e854 * _e1210), (_e858 * _e1210), _e721);
                                                                            } else {
                                                                                phi_2228_ = type_22();
                                                                            }
                                                                            let _e1215 = phi_2228_;
                                                                            phi_2230_ = _e1215;
                                                                            phi_2231_ = select(true, false, _e1209);
                                                                        } else {
                                                                            phi_2230_ = type_22();
                                                                            phi_2231_ = true;
                                                                        }
                                                                        let _e1218 = phi_2230_;
                                                                        let _e1220 = phi_2231_;
                                                                        if _e1220 {
                                                                            phi_2235_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2235_ = _e1218;
                                                                        }
                                                                        let _e1222 = phi_2235_;
                                                                        phi_2236_ = _e1222;
                                                                    }
                                                                    let _e1224 = phi_2236_;
                                                                    phi_2237_ = _e1224;
                                                                    phi_2238_ = _e950;
                                                                }
                                                                let _e1226 = phi_2237_;
                                                                let _e1228 = phi_2238_;
                                                                phi_2242_ = _e1226;
                                                                phi_2243_ = _e1228;
                                                            }
                                                            let _e1230 = phi_2242_;
                                                            let _e1232 = phi_2243_;
                                                            phi_2244_ = _e1230;
                                                            phi_2245_ = _e885;
                                                            phi_2246_ = _e1232;
                                                        }
                                                        let _e1234 = phi_2244_;
                                                        let _e1236 = phi_2245_;
                                                        let _e1238 = phi_2246_;
                                                        phi_2247_ = _e1234;
                                                        phi_2248_ = _e1236;
                                                        phi_2249_ = _e1238;
                                                    }
                                                    let _e1240 = phi_2247_;
                                                    let _e1242 = phi_2248_;
                                                    let _e1244 = phi_2249_;
                                                    phi_2257_ = _e1240;
                                                    phi_2258_ = select(_e1244, true, _e1242);
                                                } else {
                                                    phi_2257_ = type_22();
                                                    phi_2258_ = true;
                                                }
                                                let _e1247 = phi_2257_;
                                                let _e1249 = phi_2258_;
                                                if _e1249 {
                                                    phi_2262_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2262_ = _e1247;
                                                }
                                                let _e1251 = phi_2262_;
                                                if (_e1251.member_3 != 4294967295u) {
                                                    if (_e721 != 4294967295u) {
                                                        if (_e1251.member < _e692.member.member) {
                                                            phi_2288_ = true;
                                                        } else {
                                                            if (_e1251.member == _e692.member.member) {
                                                                phi_2287_ = (_e1251.member_3 < _e692.member.member_3);
                                                            } else {
                                                                phi_2287_ = false;
                                                            }
                                                            let _e1264 = phi_2287_;
                                                            phi_2288_ = _e1264;
                                                        }
                                                        let _e1266 = phi_2288_;
                                                        if _e1266 {
                                                            phi_2294_ = type_33(_e1251, _e1251.member);
                                                        } else {
                                                            phi_2294_ = _e692;
                                                        }
                                                        let _e1269 = phi_2294_;
                                                        phi_2295_ = _e1269;
                                                    } else {
                                                        phi_2295_ = _e692;
                                                    }
                                                    let _e1271 = phi_2295_;
                                                    phi_2296_ = _e1271;
                                                } else {
                                                    phi_2296_ = _e692;
                                                }
                                                let _e1273 = phi_2296_;
                                                phi_1225_ = _e1273;
                                            } else {
                                                phi_1225_ = type_33();
                                            }
                                            let _e1275 = phi_1225_;
                                            continue;
                                            continuing {
                                                phi_1224_ = _e1275;
                                                phi_1227_ = _e707;
                                                phi_3523_ = _e636;
                                                break if !(_e713);
                                            }
                                        }
                                        let _e1278 = phi_3523_;
                                        phi_3683_ = _e1278;
                                        if _e1278 {
                                            break;
                                        }
                                        phi_3742_ = _e1278;
                                        let _e1921 = local_11;
                                        phi_2297_ = _e1921;
                                    } else {
                                        phi_3742_ = _e636;
                                        phi_2297_ = _e638;
                                    }
                                    let _e1280 = phi_3742_;
                                    let _e1282 = phi_2297_;
                                    if _e685 {
                                        phi_3304_ = bool();
                                        phi_3305_ = u32();
                                        phi_3306_ = type_49();
                                    } else {
                                        let _e1283 = (_e681.member_1 < _e87);
                                        if _e1283 {
                                            if _e1283 {
                                            } else {
                                                phi_3683_ = true;
                                                break;
                                            }
                                            let _e1285 = global_5.member[_e681.member_1];
                                            phi_2318_ = _e1285;
                                        } else {
                                            phi_2318_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1287 = phi_2318_;
                                        let _e1302 = ((10u * _e249) & 31u);
                                        let _e1305 = ((_e1287.member[0] >> bitcast<u32>(_e1302)) & 1023u);
                                        let _e1313 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[0] - _e681.member.member[0]) * 0.0009775171f)) ^ _e121));
                                        let _e1318 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1305)) - 8388608f) * _e1313)) ^ _e121)));
                                        let _e1322 = select(select(_e681.member.member_1[0], _e1318, (_e1318 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1305 == 1023u));
                                        let _e1324 = ((10u * _e248) & 31u);
                                        let _e1327 = ((_e1287.member[0] >> bitcast<u32>(_e1324)) & 1023u);
                                        let _e1335 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[1] - _e681.member.member[1]) * 0.0009775171f)) ^ _e121));
                                        let _e1340 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1327)) - 8388608f) * _e1335)) ^ _e121)));
                                        let _e1344 = select(select(_e681.member.member_1[1], _e1340, (_e1340 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1327 == 1023u));
                                        let _e1346 = ((10u * _e250) & 31u);
                                        let _e1349 = ((_e1287.member[0] >> bitcast<u32>(_e1346)) & 1023u);
                                        let _e1357 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[2] - _e681.member.member[2]) * 0.0009775171f)) ^ _e121));
                                        let _e1362 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1349)) - 8388608f) * _e1357)) ^ _e121)));
                                        let _e1366 = select(select(_e681.member.member_1[2], _e1362, (_e1362 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1349 == 1023u));
                                        let _e1369 = ((_e1287.member[1] >> bitcast<u32>(_e1302)) & 1023u);
                                        let _e1377 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1369)) - 8388608f) * _e1313)) ^ _e121)));
                                        let _e1381 = select(select(_e681.member.member_1[0], _e1377, (_e1377 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1369 == 1023u));
                                        let _e1384 = ((_e1287.member[1] >> bitcast<u32>(_e1324)) & 1023u);
                                        let _e1392 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1384)) - 8388608f) * _e1335)) ^ _e121)));
                                        let _e1396 = select(select(_e681.member.member_1[1], _e1392, (_e1392 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1384 == 1023u));
                                        let _e1399 = ((_e1287.member[1] >> bitcast<u32>(_e1346)) & 1023u);
                                        let _e1407 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1399)) - 8388608f) * _e1357)) ^ _e121)));
                                        let _e1411 = select(select(_e681.member.member_1[2], _e1407, (_e1407 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1399 == 1023u));
                                        let _e1417 = ((_e1287.member_1[0] >> bitcast<u32>(_e1302)) & 1023u);
                                        let _e1425 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1417)) - 8388608f) * _e1313)) ^ _e121)));
                                        let _e1429 = select(select(_e681.member.member_1[0], _e1425, (_e1425 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1417 == 1023u));
                                        let _e1432 = ((_e1287.member_1[0] >> bitcast<u32>(_e1324)) & 1023u);
                                        let _e1440 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1432)) - 8388608f) * _e1335)) ^ _e121)));
                                        let _e1444 = select(select(_e681.member.member_1[1], _e1440, (_e1440 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1432 == 1023u));
                                        let _e1447 = ((_e1287.member_1[0] >> bitcast<u32>(_e1346)) & 1023u);
                                        let _e1455 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1447)) - 8388608f) * _e1357)) ^ _e121)));
                                        let _e1459 = select(select(_e681.member.member_1[2], _e1455, (_e1455 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1447 == 1023u));
                                        let _e1462 = ((_e1287.member_1[1] >> bitcast<u32>(_e1302)) & 1023u);
                                        let _e1470 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1462)) - 8388608f) * _e1313)) ^ _e121)));
                                        let _e1474 = select(select(_e681.member.member_1[0], _e1470, (_e1470 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1462 == 1023u));
                                        let _e1477 = ((_e1287.member_1[1] >> bitcast<u32>(_e1324)) & 1023u);
                                        let _e1485 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1477)) - 8388608f) * _e1335)) ^ _e121)));
                                        let _e1489 = select(select(_e681.member.member_1[1], _e1485, (_e1485 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1477 == 1023u));
                                        let _e1492 = ((_e1287.member_1[1] >> bitcast<u32>(_e1346)) & 1023u);
                                        let _e1500 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1492)) - 8388608f) * _e1357)) ^ _e121)));
                                        let _e1504 = select(select(_e681.member.member_1[2], _e1500, (_e1500 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1492 == 1023u));
                                        let _e1509 = type_49(type_47(array<f32, 3>(_e1322, _e1344, _e1366), array<f32, 3>(_e1381, _e1396, _e1411)), _e1287.member_2);
                                        let _e1514 = type_49(type_47(array<f32, 3>(_e1429, _e1444, _e1459), array<f32, 3>(_e1474, _e1489, _e1504)), _e1287.member_3);
                                        let _e1520 = ((_e1322 - _e351) * _e356);
                                        let _e1521 = ((_e1429 - _e351) * _e356);
                                        let _e1522 = ((_e1381 - _e352) * _e356);
                                        let _e1523 = ((_e1474 - _e352) * _e356);
                                        let _e1528 = ((_e1344 - _e419) * _e424);
                                        let _e1529 = ((_e1444 - _e419) * _e424);
                                        let _e1530 = ((_e1396 - _e420) * _e424);
                                        let _e1531 = ((_e1489 - _e420) * _e424);
                                        let _e1536 = ((_e1366 - _e487) * _e492);
                                        let _e1537 = ((_e1459 - _e487) * _e492);
                                        let _e1538 = ((_e1411 - _e488) * _e492);
                                        let _e1539 = ((_e1504 - _e488) * _e492);
                                        let _e1541 = select(_e1538, _e1536, (_e1536 < _e1538));
                                        let _e1543 = select(_e1539, _e1537, (_e1537 < _e1539));
                                        let _e1545 = select(_e1538, _e1536, (_e1536 > _e1538));
                                        let _e1547 = select(_e1539, _e1537, (_e1537 > _e1539));
                                        let _e1549 = select(_e1522, _e1520, (_e1520 < _e1522));
                                        let _e1551 = select(_e1523, _e1521, (_e1521 < _e1523));
                                        let _e1553 = select(_e1530, _e1528, (_e1528 < _e1530));
                                        let _e1555 = select(_e1531, _e1529, (_e1529 < _e1531));
                                        let _e1557 = select(_e1553, _e1549, (_e1549 > _e1553));
                                        let _e1559 = select(_e1555, _e1551, (_e1551 > _e1555));
                                        let _e1561 = select(_e1541, _e1557, (_e1557 > _e1541));
                                        let _e1563 = select(_e1543, _e1559, (_e1559 > _e1543));
                                        let _e1565 = select(_e1522, _e1520, (_e1520 > _e1522));
                                        let _e1567 = select(_e1523, _e1521, (_e1521 > _e1523));
                                        let _e1569 = select(_e1530, _e1528, (_e1528 > _e1530));
                                        let _e1571 = select(_e1531, _e1529, (_e1529 > _e1531));
                                        let _e1573 = select(_e1569, _e1565, (_e1565 < _e1569));
                                        let _e1575 = select(_e1571, _e1567, (_e1567 < _e1571));
                                        let _e1580 = -(_e1541);
                                        let _e1581 = -(_e1543);
                                        let _e1588 = (select(_e1545, _e1573, (_e1573 < _e1545)) + (select(_e1580, _e1545, (_e1545 > _e1580)) * 0.0000019073523f));
                                        let _e1589 = (select(_e1547, _e1575, (_e1575 < _e1547)) + (select(_e1581, _e1547, (_e1547 > _e1581)) * 0.0000019073523f));
                                        let _e1591 = select(_e604, _e1561, (_e1561 > _e604));
                                        let _e1593 = select(_e604, _e1563, (_e1563 > _e604));
                                        let _e1598 = (_e1591 <= select(_e1282.member_1, _e1588, (_e1588 < _e1282.member_1)));
                                        let _e1599 = (_e1593 <= select(_e1282.member_1, _e1589, (_e1589 < _e1282.member_1)));
                                        let _e1600 = (_e1591 <= _e1593);
                                        if _e1598 {
                                            if _e1599 {
                                                if _e1600 {
                                                    phi_3204_ = _e1514;
                                                } else {
                                                    phi_3204_ = _e1509;
                                                }
                                                let _e1602 = phi_3204_;
                                                let _e1609 = (_e679 % 128u);
                                                let _e1610 = (_e1609 < 128u);
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local_6[_e1609] = _e1602.member_1;
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local_5[_e1609] = _e1602.member.member[0];
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local_4[_e1609] = _e1602.member.member[1];
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local_3[_e1609] = _e1602.member.member[2];
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local_2[_e1609] = _e1602.member.member_1[0];
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local_1[_e1609] = _e1602.member.member_1[1];
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local[_e1609] = _e1602.member.member_1[2];
                                                if _e1610 {
                                                } else {
                                                    phi_3683_ = true;
                                                    break;
                                                }
                                                local_7[_e1609] = select(_e1591, _e1593, _e1600);
                                                if _e1600 {
                                                    phi_3280_ = _e1509;
                                                } else {
                                                    phi_3280_ = _e1514;
                                                }
                                                let _e1627 = phi_3280_;
                                                phi_3281_ = (_e679 + 1u);
                                                phi_3282_ = _e1627;
                                            } else {
                                                phi_3281_ = u32();
                                                phi_3282_ = type_49();
                                            }
                                            let _e1629 = phi_3281_;
                                            let _e1631 = phi_3282_;
                                            phi_3284_ = _e1629;
                                            phi_3285_ = _e1631;
                                            phi_3286_ = select(true, false, _e1599);
                                        } else {
                                            phi_3284_ = u32();
                                            phi_3285_ = type_49();
                                            phi_3286_ = true;
                                        }
                                        let _e1634 = phi_3284_;
                                        let _e1636 = phi_3285_;
                                        let _e1638 = phi_3286_;
                                        if _e1638 {
                                            if _e1598 {
                                                phi_3293_ = _e1509;
                                            } else {
                                                phi_3293_ = _e1514;
                                            }
                                            let _e1640 = phi_3293_;
                                            phi_3298_ = select(_e1599, true, _e1598);
                                            phi_3300_ = _e1640;
                                        } else {
                                            phi_3298_ = _e677;
                                            phi_3300_ = _e1636;
                                        }
                                        let _e1643 = phi_3298_;
                                        let _e1645 = phi_3300_;
                                        phi_3304_ = _e1643;
                                        phi_3305_ = select(_e1634, _e679, _e1638);
                                        phi_3306_ = _e1645;
                                    }
                                    let _e1648 = phi_3304_;
                                    let _e1650 = phi_3305_;
                                    let _e1652 = phi_3306_;
                                    if _e685 {
                                        phi_3316_ = _e681;
                                    } else {
                                        phi_3316_ = _e1652;
                                    }
                                    let _e1654 = phi_3316_;
                                    phi_3686_ = _e1280;
                                    phi_3317_ = _e1282;
                                    phi_3318_ = (_e640 - 1u);
                                    phi_3319_ = select(_e1648, false, _e685);
                                    phi_3320_ = select(_e1650, _e679, _e685);
                                    phi_3321_ = _e1654;
                                } else {
                                    phi_3686_ = _e636;
                                    phi_3317_ = _e638;
                                    phi_3318_ = _e640;
                                    phi_3319_ = _e677;
                                    phi_3320_ = _e679;
                                    phi_3321_ = _e681;
                                }
                                let _e1658 = phi_3686_;
                                let _e1660 = phi_3317_;
                                let _e1662 = phi_3318_;
                                let _e1664 = phi_3319_;
                                let _e1666 = phi_3320_;
                                let _e1668 = phi_3321_;
                                phi_3685_ = _e1658;
                                phi_3322_ = _e1660;
                                phi_3323_ = _e1662;
                                phi_3324_ = _e1664;
                                phi_3325_ = _e1666;
                                phi_3326_ = _e1668;
                            } else {
                                phi_3685_ = _e636;
                                phi_3322_ = type_33();
                                phi_3323_ = u32();
                                phi_3324_ = bool();
                                phi_3325_ = u32();
                                phi_3326_ = type_49();
                            }
                            let _e1670 = phi_3685_;
                            let _e1672 = phi_3322_;
                            let _e1674 = phi_3323_;
                            let _e1676 = phi_3324_;
                            let _e1678 = phi_3325_;
                            let _e1680 = phi_3326_;
                            phi_3684_ = _e1670;
                            phi_1099_ = _e1672;
                            phi_1102_ = _e1674;
                            phi_1104_ = _e1676;
                            phi_1106_ = _e1678;
                            phi_1108_ = _e1680;
                            phi_3327_ = _e650;
                        } else {
                            phi_3684_ = _e636;
                            phi_1099_ = type_33();
                            phi_1102_ = u32();
                            phi_1104_ = bool();
                            phi_1106_ = u32();
                            phi_1108_ = type_49();
                            phi_3327_ = false;
                        }
                        let _e1682 = phi_3684_;
                        let _e1684 = phi_1099_;
                        let _e1686 = phi_1102_;
                        let _e1688 = phi_1104_;
                        let _e1690 = phi_1106_;
                        let _e1692 = phi_1108_;
                        let _e1694 = phi_3327_;
                        continue;
                        continuing {
                            phi_3529_ = _e1682;
                            phi_1098_ = _e1684;
                            phi_1101_ = _e1686;
                            phi_1103_ = _e1688;
                            phi_1105_ = _e1690;
                            phi_1107_ = _e1692;
                            phi_3683_ = _e1682;
                            break if !(_e1694);
                        }
                    }
                    let _e1697 = phi_3683_;
                    if _e1697 {
                        break;
                    }
                    let _e1699 = local_10;
                    if (_e1699.member.member_3 != 4294967295u) {
                        let _e1704 = -(_e506);
                        let _e1705 = bitcast<u32>(_e1699.member.member);
                        let _e1709 = (bitcast<i32>((_e1705 >> bitcast<u32>(23i))) & 255i);
                        let _e1710 = (_e1709 + _e1704);
                        if (_e1709 == 255i) {
                            phi_3386_ = _e1699.member.member;
                        } else {
                            if (_e1709 > 0i) {
                                if (_e1710 > 0i) {
                                    let _e1714 = (_e1710 < 255i);
                                    if _e1714 {
                                        phi_3365_ = bitcast<f32>((_e1705 + bitcast<u32>((_e1704 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3365_ = f32();
                                    }
                                    let _e1721 = phi_3365_;
                                    phi_3367_ = _e1721;
                                    phi_3368_ = select(true, false, _e1714);
                                } else {
                                    phi_3367_ = f32();
                                    phi_3368_ = true;
                                }
                                let _e1724 = phi_3367_;
                                let _e1726 = phi_3368_;
                                phi_3369_ = _e1724;
                                phi_3370_ = _e1726;
                            } else {
                                phi_3369_ = f32();
                                phi_3370_ = true;
                            }
                            let _e1728 = phi_3369_;
                            let _e1730 = phi_3370_;
                            if _e1730 {
                                let _e1731 = (_e1705 & 2147483648u);
                                let _e1738 = ((_e1705 & 8388607u) | (select(0u, 1u, ((_e1705 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1742 = (_e1738 == 0u);
                                if _e1742 {
                                    phi_3493_ = bitcast<f32>(_e1731);
                                } else {
                                    let _e1747 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1738)), 32u, _e1742) - 8u);
                                    let _e1750 = (_e1738 << bitcast<u32>((_e1747 & 31u)));
                                    let _e1752 = ((_e1710 + select(0i, 1i, (_e1709 == 0i))) - bitcast<i32>(_e1747));
                                    if (_e1752 >= 255i) {
                                        phi_3483_ = bitcast<f32>((_e1731 | 2139095040u));
                                        phi_3484_ = f32();
                                        phi_3485_ = true;
                                    } else {
                                        let _e1754 = (_e1752 > 0i);
                                        if _e1754 {
                                            phi_3477_ = bitcast<f32>(((_e1731 | (bitcast<u32>(_e1752) << bitcast<u32>(23i))) | (_e1750 & 8388607u)));
                                            phi_3478_ = f32();
                                        } else {
                                            if (_e1752 < -24i) {
                                                phi_3443_ = 26u;
                                            } else {
                                                phi_3443_ = bitcast<u32>((1i - _e1752));
                                            }
                                            let _e1759 = phi_3443_;
                                            let _e1760 = (_e1759 & 31u);
                                            let _e1762 = (_e1750 >> bitcast<u32>(_e1760));
                                            let _e1766 = (_e1750 & ((1u << bitcast<u32>(_e1760)) - 1u));
                                            let _e1770 = (1u << bitcast<u32>(((_e1759 - 1u) & 31u)));
                                            if (_e1766 > _e1770) {
                                                phi_3464_ = true;
                                            } else {
                                                if (_e1766 == _e1770) {
                                                    phi_3461_ = ((_e1762 & 1u) == 1u);
                                                } else {
                                                    phi_3461_ = false;
                                                }
                                                let _e1776 = phi_3461_;
                                                phi_3464_ = _e1776;
                                            }
                                            let _e1778 = phi_3464_;
                                            phi_3477_ = f32();
                                            phi_3478_ = bitcast<f32>((_e1731 | (_e1762 + select(0u, 1u, _e1778))));
                                        }
                                        let _e1791 = phi_3477_;
                                        let _e1793 = phi_3478_;
                                        phi_3483_ = _e1791;
                                        phi_3484_ = _e1793;
                                        phi_3485_ = _e1754;
                                    }
                                    let _e1797 = phi_3483_;
                                    let _e1799 = phi_3484_;
                                    let _e1801 = phi_3485_;
                                    phi_3493_ = select(_e1799, _e1797, _e1801);
                                }
                                let _e1805 = phi_3493_;
                                phi_3385_ = _e1805;
                            } else {
                                phi_3385_ = _e1728;
                            }
                            let _e1807 = phi_3385_;
                            phi_3386_ = _e1807;
                        }
                        let _e1809 = phi_3386_;
                        let _e1810 = bitcast<u32>(_e1809);
                        if ((_e1810 & 2147483647u) >= 2139095040u) {
                            phi_3398_ = bitcast<f32>(((_e1810 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3398_ = _e1809;
                        }
                        let _e1817 = phi_3398_;
                        phi_3403_ = type_22(_e1817, _e1699.member.member_1, _e1699.member.member_2, _e1699.member.member_3);
                    } else {
                        phi_3403_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1822 = phi_3403_;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135] = _e1822;
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
