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
    var phi_3525_: bool;
    var phi_1098_: type_33;
    var phi_1101_: bool;
    var phi_1103_: u32;
    var phi_1105_: u32;
    var phi_1107_: type_49;
    var phi_1118_: bool;
    var phi_1204_: bool;
    var phi_1205_: u32;
    var phi_1206_: type_49;
    var phi_2322_: type_42;
    var phi_3208_: type_49;
    var phi_3285_: type_49;
    var phi_3286_: u32;
    var phi_3287_: type_49;
    var phi_3289_: u32;
    var phi_3290_: type_49;
    var phi_3291_: bool;
    var phi_3298_: type_49;
    var phi_3303_: bool;
    var phi_3305_: type_49;
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
    var phi_3519_: bool;
    var phi_3683_: bool;
    var phi_3309_: type_33;
    var phi_3310_: bool;
    var phi_3311_: u32;
    var phi_3312_: type_49;
    var phi_3682_: bool;
    var phi_3313_: type_33;
    var phi_3314_: bool;
    var phi_3315_: u32;
    var phi_3316_: u32;
    var phi_3317_: type_49;
    var phi_3681_: bool;
    var phi_3318_: type_33;
    var phi_3319_: bool;
    var phi_3320_: u32;
    var phi_3321_: u32;
    var phi_3322_: type_49;
    var phi_3680_: bool;
    var phi_1099_: type_33;
    var phi_1102_: bool;
    var phi_1104_: u32;
    var phi_1106_: u32;
    var phi_1108_: type_49;
    var phi_3323_: bool;
    var phi_3679_: bool;
    var local_10: type_33;
    var phi_3361_: f32;
    var phi_3363_: f32;
    var phi_3364_: bool;
    var phi_3365_: f32;
    var phi_3366_: bool;
    var phi_3439_: u32;
    var phi_3457_: bool;
    var phi_3460_: bool;
    var phi_3473_: f32;
    var phi_3474_: f32;
    var phi_3479_: f32;
    var phi_3480_: f32;
    var phi_3481_: bool;
    var phi_3489_: f32;
    var phi_3381_: f32;
    var phi_3382_: f32;
    var phi_3394_: f32;
    var phi_3399_: type_22;
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
                    phi_3525_ = false;
                    phi_1098_ = type_33(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e602);
                    phi_1101_ = (_e604 <= _e602);
                    phi_1103_ = ((3u * _e87) + 1u);
                    phi_1105_ = 0u;
                    phi_1107_ = type_49(type_47(array<f32, 3>(_e612, _e616, _e620), array<f32, 3>(_e624, _e626, _e628)), select(0u, 2147483648u, (_e87 == 0u)));
                    loop {
                        let _e636 = phi_3525_;
                        let _e638 = phi_1098_;
                        let _e640 = phi_1101_;
                        let _e642 = phi_1103_;
                        let _e644 = phi_1105_;
                        let _e646 = phi_1107_;
                        local_10 = _e638;
                        if _e640 {
                            phi_1118_ = true;
                        } else {
                            phi_1118_ = (_e644 > 0u);
                        }
                        let _e649 = phi_1118_;
                        if _e649 {
                            let _e650 = (_e642 > 0u);
                            if _e650 {
                                if _e640 {
                                    phi_1204_ = _e640;
                                    phi_1205_ = _e644;
                                    phi_1206_ = _e646;
                                } else {
                                    let _e651 = (_e644 - 1u);
                                    let _e652 = (_e651 % 128u);
                                    let _e653 = (_e652 < 128u);
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
                                        break;
                                    }
                                    let _e655 = local_6[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
                                        break;
                                    }
                                    let _e657 = local_5[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
                                        break;
                                    }
                                    let _e659 = local_4[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
                                        break;
                                    }
                                    let _e661 = local_3[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
                                        break;
                                    }
                                    let _e664 = local_2[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
                                        break;
                                    }
                                    let _e666 = local_1[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
                                        break;
                                    }
                                    let _e668 = local[_e652];
                                    if _e653 {
                                    } else {
                                        phi_3679_ = true;
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
                                    if ((_e681.member_1 & 2147483648u) != 0u) {
                                        phi_1224_ = _e638;
                                        phi_1227_ = type_4(0u, ((_e681.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1057 = phi_1224_;
                                            let _e1059 = phi_1227_;
                                            local_11 = _e1057;
                                            if (_e1059.member < _e1059.member_1) {
                                                phi_1228_ = type_4((_e1059.member + 1u), _e1059.member_1);
                                                phi_1250_ = type_4(1u, _e1059.member);
                                            } else {
                                                phi_1228_ = _e1059;
                                                phi_1250_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1072 = phi_1228_;
                                            let _e1074 = phi_1250_;
                                            let _e1078 = (bitcast<i32>(_e1074.member) != 0i);
                                            if _e1078 {
                                                let _e1079 = ((_e681.member_1 & 268435455u) + _e1074.member_1);
                                                let _e1080 = (_e1079 < _e89);
                                                if _e1080 {
                                                    if _e1080 {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1084 = global_2.member[_e1079].member_1;
                                                    phi_1271_ = _e1084;
                                                } else {
                                                    phi_1271_ = 4294967295u;
                                                }
                                                let _e1086 = phi_1271_;
                                                if (_e1079 >= _e89) {
                                                    phi_1363_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1080 {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    if (_e609 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1093 = global_2.member[_e1079].member[_e609];
                                                    if (_e613 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1099 = global_2.member[_e1079].member[_e613];
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1105 = global_2.member[_e1079].member[_e617];
                                                    let _e1107 = (3u + _e609);
                                                    if (_e1107 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1113 = global_2.member[_e1079].member[_e1107];
                                                    let _e1114 = (3u + _e613);
                                                    if (_e1114 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1120 = global_2.member[_e1079].member[_e1114];
                                                    let _e1121 = (3u + _e617);
                                                    if (_e1121 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1127 = global_2.member[_e1079].member[_e1121];
                                                    let _e1129 = (6u + _e609);
                                                    if (_e1129 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1135 = global_2.member[_e1079].member[_e1129];
                                                    let _e1136 = (6u + _e613);
                                                    if (_e1136 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1142 = global_2.member[_e1079].member[_e1136];
                                                    let _e1143 = (6u + _e617);
                                                    if (_e1143 < 9u) {
                                                    } else {
                                                        phi_3519_ = true;
                                                        break;
                                                    }
                                                    let _e1149 = global_2.member[_e1079].member[_e1143];
                                                    phi_1363_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1093, _e1099, _e1105), array<f32, 3>(_e1113, _e1120, _e1127), array<f32, 3>(_e1135, _e1142, _e1149));
                                                }
                                                let _e1153 = phi_1363_;
                                                let _e1161 = (_e1153[0][2] - _e450);
                                                let _e1164 = (((_e1153[0][0] - _e313) * _e489) - (_e1161 * _e353));
                                                let _e1167 = (((_e1153[0][1] - _e382) * _e489) - (_e1161 * _e421));
                                                let _e1174 = (_e1153[1][2] - _e450);
                                                let _e1177 = (((_e1153[1][0] - _e313) * _e489) - (_e1174 * _e353));
                                                let _e1180 = (((_e1153[1][1] - _e382) * _e489) - (_e1174 * _e421));
                                                let _e1187 = (_e1153[2][2] - _e450);
                                                let _e1190 = (((_e1153[2][0] - _e313) * _e489) - (_e1187 * _e353));
                                                let _e1193 = (((_e1153[2][1] - _e382) * _e489) - (_e1187 * _e421));
                                                let _e1194 = (_e1190 * _e1180);
                                                let _e1195 = (_e1193 * _e1177);
                                                let _e1196 = (_e1164 * _e1193);
                                                let _e1197 = (_e1167 * _e1190);
                                                let _e1198 = (_e1177 * _e1167);
                                                let _e1199 = (_e1180 * _e1164);
                                                let _e1204 = (((_e1194 >= _e1195) && (_e1196 >= _e1197)) && (_e1198 >= _e1199));
                                                if (_e1204 || (((_e1194 <= _e1195) && (_e1196 <= _e1197)) && (_e1198 <= _e1199))) {
                                                    let _e1211 = select(-1f, 1f, _e1204);
                                                    let _e1213 = ((_e1194 - _e1195) * _e1211);
                                                    let _e1215 = select(0f, _e1213, (_e1213 > 0f));
                                                    let _e1217 = ((_e1196 - _e1197) * _e1211);
                                                    let _e1219 = select(0f, _e1217, (_e1217 > 0f));
                                                    let _e1221 = ((_e1198 - _e1199) * _e1211);
                                                    let _e1223 = select(0f, _e1221, (_e1221 > 0f));
                                                    let _e1225 = ((_e1215 + _e1219) + _e1223);
                                                    if (_e1225 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2247_ = type_22();
                                                        phi_2248_ = true;
                                                        phi_2249_ = false;
                                                    } else {
                                                        let _e1228 = select(_e1177, _e1164, (_e1164 < _e1177));
                                                        if (select(_e1190, _e1228, (_e1228 < _e1190)) > 0f) {
                                                            phi_1515_ = true;
                                                        } else {
                                                            let _e1233 = select(_e1177, _e1164, (_e1164 > _e1177));
                                                            phi_1515_ = (select(_e1190, _e1233, (_e1233 > _e1190)) < 0f);
                                                        }
                                                        let _e1238 = phi_1515_;
                                                        if _e1238 {
                                                            phi_2244_ = type_22();
                                                            phi_2245_ = true;
                                                            phi_2246_ = false;
                                                        } else {
                                                            let _e1240 = select(_e1180, _e1167, (_e1167 < _e1180));
                                                            if (select(_e1193, _e1240, (_e1240 < _e1193)) > 0f) {
                                                                phi_1544_ = true;
                                                            } else {
                                                                let _e1245 = select(_e1180, _e1167, (_e1167 > _e1180));
                                                                phi_1544_ = (select(_e1193, _e1245, (_e1245 > _e1193)) < 0f);
                                                            }
                                                            let _e1250 = phi_1544_;
                                                            if _e1250 {
                                                                phi_2242_ = type_22();
                                                                phi_2243_ = false;
                                                            } else {
                                                                let _e1252 = select(_e1153[1][0], _e1153[0][0], (_e1153[0][0] < _e1153[1][0]));
                                                                let _e1256 = select(_e1153[1][0], _e1153[0][0], (_e1153[0][0] > _e1153[1][0]));
                                                                let _e1260 = select(_e1153[1][1], _e1153[0][1], (_e1153[0][1] < _e1153[1][1]));
                                                                let _e1264 = select(_e1153[1][1], _e1153[0][1], (_e1153[0][1] > _e1153[1][1]));
                                                                let _e1268 = select(_e1153[1][2], _e1153[0][2], (_e1153[0][2] < _e1153[1][2]));
                                                                let _e1272 = select(_e1153[1][2], _e1153[0][2], (_e1153[0][2] > _e1153[1][2]));
                                                                let _e1277 = ((select(_e1153[2][0], _e1252, (_e1252 < _e1153[2][0])) - _e351) * _e356);
                                                                let _e1278 = ((select(_e1153[2][0], _e1256, (_e1256 > _e1153[2][0])) - _e352) * _e356);
                                                                let _e1281 = ((select(_e1153[2][1], _e1260, (_e1260 < _e1153[2][1])) - _e419) * _e424);
                                                                let _e1282 = ((select(_e1153[2][1], _e1264, (_e1264 > _e1153[2][1])) - _e420) * _e424);
                                                                let _e1285 = ((select(_e1153[2][2], _e1268, (_e1268 < _e1153[2][2])) - _e487) * _e492);
                                                                let _e1286 = ((select(_e1153[2][2], _e1272, (_e1272 > _e1153[2][2])) - _e488) * _e492);
                                                                let _e1288 = select(_e1286, _e1285, (_e1285 < _e1286));
                                                                let _e1290 = select(_e1286, _e1285, (_e1285 > _e1286));
                                                                let _e1292 = select(_e1278, _e1277, (_e1277 < _e1278));
                                                                let _e1294 = select(_e1282, _e1281, (_e1281 < _e1282));
                                                                let _e1296 = select(_e1294, _e1292, (_e1292 > _e1294));
                                                                let _e1298 = select(_e1288, _e1296, (_e1296 > _e1288));
                                                                let _e1300 = select(_e1278, _e1277, (_e1277 > _e1278));
                                                                let _e1302 = select(_e1282, _e1281, (_e1281 > _e1282));
                                                                let _e1304 = select(_e1302, _e1300, (_e1300 < _e1302));
                                                                let _e1306 = select(_e1290, _e1304, (_e1304 < _e1290));
                                                                let _e1307 = -(_e1288);
                                                                let _e1313 = select(_e604, _e1298, (_e1298 > _e604));
                                                                if (_e1313 > (_e1306 + (select(_e1307, _e1290, (_e1290 > _e1307)) * 0.0000019073523f))) {
                                                                    phi_2237_ = type_22();
                                                                    phi_2238_ = true;
                                                                } else {
                                                                    let _e1315 = (_e1313 > _e1057.member_1);
                                                                    if _e1315 {
                                                                        phi_2236_ = type_22();
                                                                    } else {
                                                                        let _e1316 = vec3<f32>(_e1153[0][0], _e1153[0][1], _e1153[0][2]);
                                                                        let _e1317 = vec3<f32>(_e1153[1][0], _e1153[1][1], _e1153[1][2]);
                                                                        let _e1318 = vec3<f32>(_e1153[2][0], _e1153[2][1], _e1153[2][2]);
                                                                        let _e1319 = (_e1153[1][0] - _e1153[0][0]);
                                                                        let _e1320 = (_e1153[1][1] - _e1153[0][1]);
                                                                        let _e1321 = (_e1153[1][2] - _e1153[0][2]);
                                                                        let _e1322 = vec3<f32>(_e1319, _e1320, _e1321);
                                                                        let _e1323 = (_e1153[2][0] - _e1153[1][0]);
                                                                        let _e1324 = (_e1153[2][1] - _e1153[1][1]);
                                                                        let _e1325 = (_e1153[2][2] - _e1153[1][2]);
                                                                        let _e1326 = vec3<f32>(_e1323, _e1324, _e1325);
                                                                        let _e1327 = (_e1153[0][0] - _e1153[2][0]);
                                                                        let _e1328 = (_e1153[0][1] - _e1153[2][1]);
                                                                        let _e1329 = (_e1153[0][2] - _e1153[2][2]);
                                                                        let _e1330 = vec3<f32>(_e1327, _e1328, _e1329);
                                                                        let _e1333 = bitcast<f32>((bitcast<u32>(_e1319) & 2147483647u));
                                                                        let _e1336 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                                        let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                                        let _e1341 = bitcast<f32>((bitcast<u32>(_e1321) & 2147483647u));
                                                                        let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                                        let _e1346 = bitcast<f32>((bitcast<u32>(_e1323) & 2147483647u));
                                                                        let _e1349 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                                        let _e1351 = select(_e1349, _e1346, (_e1346 > _e1349));
                                                                        let _e1354 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                                        let _e1356 = select(_e1354, _e1351, (_e1351 > _e1354));
                                                                        let _e1359 = bitcast<f32>((bitcast<u32>(_e1327) & 2147483647u));
                                                                        let _e1362 = bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u));
                                                                        let _e1364 = select(_e1362, _e1359, (_e1359 > _e1362));
                                                                        let _e1367 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                                        let _e1369 = select(_e1367, _e1364, (_e1364 > _e1367));
                                                                        let _e1371 = select(_e1356, _e1343, (_e1343 > _e1356));
                                                                        let _e1373 = select(_e1369, _e1371, (_e1371 > _e1369));
                                                                        if (_e1343 == _e1373) {
                                                                            phi_1963_ = _e1180;
                                                                            phi_1964_ = _e1177;
                                                                            phi_1965_ = _e1167;
                                                                            phi_1966_ = _e1164;
                                                                            phi_1967_ = _e1316;
                                                                            phi_1968_ = _e1330;
                                                                            phi_1969_ = _e1326;
                                                                            phi_1970_ = _e1322;
                                                                        } else {
                                                                            let _e1375 = (_e1356 == _e1373);
                                                                            let _e1380 = vec3(_e1375);
                                                                            phi_1963_ = select(_e1167, _e1193, _e1375);
                                                                            phi_1964_ = select(_e1164, _e1190, _e1375);
                                                                            phi_1965_ = select(_e1193, _e1180, _e1375);
                                                                            phi_1966_ = select(_e1190, _e1177, _e1375);
                                                                            phi_1967_ = select(_e1318, _e1317, _e1380);
                                                                            phi_1968_ = select(_e1326, _e1322, _e1380);
                                                                            phi_1969_ = select(_e1322, _e1330, _e1380);
                                                                            phi_1970_ = select(_e1330, _e1326, _e1380);
                                                                        }
                                                                        let _e1386 = phi_1963_;
                                                                        let _e1388 = phi_1964_;
                                                                        let _e1390 = phi_1965_;
                                                                        let _e1392 = phi_1966_;
                                                                        let _e1394 = phi_1967_;
                                                                        let _e1396 = phi_1968_;
                                                                        let _e1398 = phi_1969_;
                                                                        let _e1400 = phi_1970_;
                                                                        let _e1407 = ((_e1398.y * _e1396.z) - (_e1396.y * _e1398.z));
                                                                        let _e1412 = ((_e1398.z * _e1396.x) - (_e1396.z * _e1398.x));
                                                                        let _e1415 = ((_e1398.x * _e1396.y) - (_e1396.x * _e1398.y));
                                                                        if (_e1215 >= _e1219) {
                                                                            phi_2007_ = select(true, false, (_e1215 >= _e1223));
                                                                        } else {
                                                                            phi_2007_ = true;
                                                                        }
                                                                        let _e1420 = phi_2007_;
                                                                        if _e1420 {
                                                                            phi_2016_ = select(_e1318, _e1317, vec3((_e1219 >= _e1223)));
                                                                        } else {
                                                                            phi_2016_ = _e1316;
                                                                        }
                                                                        let _e1425 = phi_2016_;
                                                                        let _e1436 = (((_e1407 * (_e1425.x - _e313)) + (_e1412 * (_e1425.y - _e382))) + (_e1415 * (_e1425.z - _e450)));
                                                                        let _e1441 = (((_e1407 * _e353) + (_e1412 * _e421)) + (_e1415 * _e489));
                                                                        let _e1442 = (_e1388 - _e1392);
                                                                        let _e1443 = (_e1386 - _e1390);
                                                                        let _e1451 = (-(((_e1392 * _e1442) + (_e1390 * _e1443))) / ((_e1442 * _e1442) + (_e1443 * _e1443)));
                                                                        let _e1453 = select(1f, _e1451, (_e1451 < 1f));
                                                                        let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                                        let _e1468 = ((_e1394.x + (_e1400.x * _e1455)) - _e313);
                                                                        let _e1469 = ((_e1394.y + (_e1400.y * _e1455)) - _e382);
                                                                        let _e1470 = ((_e1394.z + (_e1400.z * _e1455)) - _e450);
                                                                        let _e1471 = (_e1470 / _e489);
                                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u));
                                                                        let _e1486 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                                        let _e1488 = select(_e1486, _e1483, (_e1483 > _e1486));
                                                                        let _e1491 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
                                                                        let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                                        let _e1499 = bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u));
                                                                        let _e1502 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                                        let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                        let _e1507 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1407 * _e1468) + (_e1412 * _e1469)) + (_e1415 * _e1470)) - _e1436)) & 2147483647u)) <= ((0.0000009536743f * select(_e1373, _e1493, (_e1493 > _e1373))) * select(_e1507, _e1504, (_e1504 > _e1507)))) {
                                                                            let _e1517 = bitcast<f32>((bitcast<u32>(_e1398.x) & 2147483647u));
                                                                            let _e1520 = bitcast<f32>((bitcast<u32>(_e1398.y) & 2147483647u));
                                                                            let _e1522 = select(_e1520, _e1517, (_e1517 > _e1520));
                                                                            let _e1525 = bitcast<f32>((bitcast<u32>(_e1398.z) & 2147483647u));
                                                                            let _e1531 = bitcast<f32>((bitcast<u32>(_e1396.x) & 2147483647u));
                                                                            let _e1534 = bitcast<f32>((bitcast<u32>(_e1396.y) & 2147483647u));
                                                                            let _e1536 = select(_e1534, _e1531, (_e1531 > _e1534));
                                                                            let _e1539 = bitcast<f32>((bitcast<u32>(_e1396.z) & 2147483647u));
                                                                            let _e1543 = (bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u)) > ((0.0000038146973f * select(_e1525, _e1522, (_e1522 > _e1525))) * select(_e1539, _e1536, (_e1536 > _e1539))));
                                                                            if _e1543 {
                                                                                phi_2181_ = (_e1436 / _e1441);
                                                                            } else {
                                                                                phi_2181_ = f32();
                                                                            }
                                                                            let _e1546 = phi_2181_;
                                                                            phi_2183_ = _e1546;
                                                                            phi_2184_ = select(true, false, _e1543);
                                                                        } else {
                                                                            phi_2183_ = f32();
                                                                            phi_2184_ = true;
                                                                        }
                                                                        let _e1549 = phi_2183_;
                                                                        let _e1551 = phi_2184_;
                                                                        if _e1551 {
                                                                            let _e1559 = (((_e1407 * (_e1468 - (_e353 * _e1471))) + (_e1412 * (_e1469 - (_e421 * _e1471)))) / _e1441);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u)) <= _e1373) {
                                                                                phi_2204_ = (_e1471 + _e1559);
                                                                            } else {
                                                                                phi_2204_ = _e1471;
                                                                            }
                                                                            let _e1566 = phi_2204_;
                                                                            phi_2205_ = _e1566;
                                                                        } else {
                                                                            phi_2205_ = _e1549;
                                                                        }
                                                                        let _e1568 = phi_2205_;
                                                                        let _e1570 = select(_e1306, _e1568, (_e1568 < _e1306));
                                                                        let _e1572 = select(_e1298, _e1570, (_e1570 > _e1298));
                                                                        if (_e1572 >= _e604) {
                                                                            let _e1574 = (_e1572 <= _e1057.member_1);
                                                                            if _e1574 {
                                                                                let _e1575 = (1f / _e1225);
                                                                                phi_2228_ = type_22(_e1572, (_e1219 * _e1575), (_e1223 * _e1575), _e1086);
                                                                            } else {
                                                                                phi_2228_ = type_22();
                                                                            }
                                                                            let _e1580 = phi_2228_;
                                                                            phi_2230_ = _e1580;
                                                                            phi_2231_ = select(true, false, _e1574);
                                                                        } else {
                                                                            phi_2230_ = type_22();
                                                                            phi_2231_ = true;
                                                                        }
                                                                        let _e1583 = phi_2230_;
                                                                        let _e1585 = phi_2231_;
                                                                        if _e1585 {
                                                                            phi_2235_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2235_ = _e1583;
                                                                        }
                                                                        let _e1587 = phi_2235_;
                                                                        phi_2236_ = _e1587;
                                                                    }
                                                                    let _e1589 = phi_2236_;
                                                                    phi_2237_ = _e1589;
                                                                    phi_2238_ = _e1315;
                                                                }
                                                                let _e1591 = phi_2237_;
                                                                let _e1593 = phi_2238_;
                                                                phi_2242_ = _e1591;
                                                                phi_2243_ = _e1593;
                                                            }
                                                            let _e1595 = phi_2242_;
                                                            let _e1597 = phi_2243_;
                                                            phi_2244_ = _e1595;
                                                            phi_2245_ = _e1250;
                                                            phi_2246_ = _e1597;
                                                        }
                                                        let _e1599 = phi_2244_;
                                                        let _e1601 = phi_2245_;
                                                        let _e1603 = phi_2246_;
                                                        phi_2247_ = _e1599;
                                                        phi_2248_ = _e1601;
                                                        phi_2249_ = _e1603;
                                                    }
                                                    let _e1605 = phi_2247_;
                                                    let _e1607 = phi_2248_;
                                                    let _e1609 = phi_2249_;
                                                    phi_2257_ = _e1605;
                                                    phi_2258_ = select(_e1609, true, _e1607);
                                                } else {
                                                    phi_2257_ = type_22();
                                                    phi_2258_ = true;
                                                }
                                                let _e1612 = phi_2257_;
                                                let _e1614 = phi_2258_;
                                                if _e1614 {
                                                    phi_2262_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2262_ = _e1612;
                                                }
                                                let _e1616 = phi_2262_;
                                                if (_e1616.member_3 != 4294967295u) {
                                                    if (_e1086 != 4294967295u) {
                                                        if (_e1616.member < _e1057.member.member) {
                                                            phi_2288_ = true;
                                                        } else {
                                                            if (_e1616.member == _e1057.member.member) {
                                                                phi_2287_ = (_e1616.member_3 < _e1057.member.member_3);
                                                            } else {
                                                                phi_2287_ = false;
                                                            }
                                                            let _e1629 = phi_2287_;
                                                            phi_2288_ = _e1629;
                                                        }
                                                        let _e1631 = phi_2288_;
                                                        if _e1631 {
                                                            phi_2294_ = type_33(_e1616, _e1616.member);
                                                        } else {
                                                            phi_2294_ = _e1057;
                                                        }
                                                        let _e1634 = phi_2294_;
                                                        phi_2295_ = _e1634;
                                                    } else {
                                                        phi_2295_ = _e1057;
                                                    }
                                                    let _e1636 = phi_2295_;
                                                    phi_2296_ = _e1636;
                                                } else {
                                                    phi_2296_ = _e1057;
                                                }
                                                let _e1638 = phi_2296_;
                                                phi_1225_ = _e1638;
                                            } else {
                                                phi_1225_ = type_33();
                                            }
                                            let _e1640 = phi_1225_;
                                            continue;
                                            continuing {
                                                phi_1224_ = _e1640;
                                                phi_1227_ = _e1072;
                                                phi_3519_ = _e636;
                                                break if !(_e1078);
                                            }
                                        }
                                        let _e1643 = phi_3519_;
                                        phi_3679_ = _e1643;
                                        if _e1643 {
                                            break;
                                        }
                                        phi_3683_ = _e1643;
                                        let _e1929 = local_11;
                                        phi_3309_ = _e1929;
                                        phi_3310_ = false;
                                        phi_3311_ = _e679;
                                        phi_3312_ = _e681;
                                    } else {
                                        let _e690 = (_e681.member_1 < _e87);
                                        if _e690 {
                                            if _e690 {
                                            } else {
                                                phi_3679_ = true;
                                                break;
                                            }
                                            let _e692 = global_5.member[_e681.member_1];
                                            phi_2322_ = _e692;
                                        } else {
                                            phi_2322_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e694 = phi_2322_;
                                        let _e709 = ((10u * _e249) & 31u);
                                        let _e712 = ((_e694.member[0] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e720 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[0] - _e681.member.member[0]) * 0.0009775171f)) ^ _e121));
                                        let _e725 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e712)) - 8388608f) * _e720)) ^ _e121)));
                                        let _e729 = select(select(_e681.member.member_1[0], _e725, (_e725 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e712 == 1023u));
                                        let _e731 = ((10u * _e248) & 31u);
                                        let _e734 = ((_e694.member[0] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e742 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[1] - _e681.member.member[1]) * 0.0009775171f)) ^ _e121));
                                        let _e747 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e734)) - 8388608f) * _e742)) ^ _e121)));
                                        let _e751 = select(select(_e681.member.member_1[1], _e747, (_e747 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e734 == 1023u));
                                        let _e753 = ((10u * _e250) & 31u);
                                        let _e756 = ((_e694.member[0] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e764 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[2] - _e681.member.member[2]) * 0.0009775171f)) ^ _e121));
                                        let _e769 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e756)) - 8388608f) * _e764)) ^ _e121)));
                                        let _e773 = select(select(_e681.member.member_1[2], _e769, (_e769 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e756 == 1023u));
                                        let _e776 = ((_e694.member[1] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e784 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e776)) - 8388608f) * _e720)) ^ _e121)));
                                        let _e788 = select(select(_e681.member.member_1[0], _e784, (_e784 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e776 == 1023u));
                                        let _e791 = ((_e694.member[1] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e799 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e791)) - 8388608f) * _e742)) ^ _e121)));
                                        let _e803 = select(select(_e681.member.member_1[1], _e799, (_e799 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e791 == 1023u));
                                        let _e806 = ((_e694.member[1] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e814 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e806)) - 8388608f) * _e764)) ^ _e121)));
                                        let _e818 = select(select(_e681.member.member_1[2], _e814, (_e814 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e806 == 1023u));
                                        let _e824 = ((_e694.member_1[0] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e832 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e824)) - 8388608f) * _e720)) ^ _e121)));
                                        let _e836 = select(select(_e681.member.member_1[0], _e832, (_e832 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e824 == 1023u));
                                        let _e839 = ((_e694.member_1[0] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e847 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e742)) ^ _e121)));
                                        let _e851 = select(select(_e681.member.member_1[1], _e847, (_e847 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e839 == 1023u));
                                        let _e854 = ((_e694.member_1[0] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e862 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e854)) - 8388608f) * _e764)) ^ _e121)));
                                        let _e866 = select(select(_e681.member.member_1[2], _e862, (_e862 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e854 == 1023u));
                                        let _e869 = ((_e694.member_1[1] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e877 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e869)) - 8388608f) * _e720)) ^ _e121)));
                                        let _e881 = select(select(_e681.member.member_1[0], _e877, (_e877 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e869 == 1023u));
                                        let _e884 = ((_e694.member_1[1] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e892 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e884)) - 8388608f) * _e742)) ^ _e121)));
                                        let _e896 = select(select(_e681.member.member_1[1], _e892, (_e892 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e884 == 1023u));
                                        let _e899 = ((_e694.member_1[1] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e907 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e899)) - 8388608f) * _e764)) ^ _e121)));
                                        let _e911 = select(select(_e681.member.member_1[2], _e907, (_e907 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e899 == 1023u));
                                        let _e916 = type_49(type_47(array<f32, 3>(_e729, _e751, _e773), array<f32, 3>(_e788, _e803, _e818)), _e694.member_2);
                                        let _e921 = type_49(type_47(array<f32, 3>(_e836, _e851, _e866), array<f32, 3>(_e881, _e896, _e911)), _e694.member_3);
                                        let _e927 = ((_e729 - _e351) * _e356);
                                        let _e928 = ((_e836 - _e351) * _e356);
                                        let _e929 = ((_e788 - _e352) * _e356);
                                        let _e930 = ((_e881 - _e352) * _e356);
                                        let _e935 = ((_e751 - _e419) * _e424);
                                        let _e936 = ((_e851 - _e419) * _e424);
                                        let _e937 = ((_e803 - _e420) * _e424);
                                        let _e938 = ((_e896 - _e420) * _e424);
                                        let _e943 = ((_e773 - _e487) * _e492);
                                        let _e944 = ((_e866 - _e487) * _e492);
                                        let _e945 = ((_e818 - _e488) * _e492);
                                        let _e946 = ((_e911 - _e488) * _e492);
                                        let _e948 = select(_e945, _e943, (_e943 < _e945));
                                        let _e950 = select(_e946, _e944, (_e944 < _e946));
                                        let _e952 = select(_e945, _e943, (_e943 > _e945));
                                        let _e954 = select(_e946, _e944, (_e944 > _e946));
                                        let _e956 = select(_e929, _e927, (_e927 < _e929));
                                        let _e958 = select(_e930, _e928, (_e928 < _e930));
                                        let _e960 = select(_e937, _e935, (_e935 < _e937));
                                        let _e962 = select(_e938, _e936, (_e936 < _e938));
                                        let _e964 = select(_e960, _e956, (_e956 > _e960));
                                        let _e966 = select(_e962, _e958, (_e958 > _e962));
                                        let _e968 = select(_e948, _e964, (_e964 > _e948));
                                        let _e970 = select(_e950, _e966, (_e966 > _e950));
                                        let _e972 = select(_e929, _e927, (_e927 > _e929));
                                        let _e974 = select(_e930, _e928, (_e928 > _e930));
                                        let _e976 = select(_e937, _e935, (_e935 > _e937));
                                        let _e978 = select(_e938, _e936, (_e936 > _e938));
                                        let _e980 = select(_e976, _e972, (_e972 < _e976));
                                        let _e982 = select(_e978, _e974, (_e974 < _e978));
                                        let _e987 = -(_e948);
                                        let _e988 = -(_e950);
                                        let _e995 = (select(_e952, _e980, (_e980 < _e952)) + (select(_e987, _e952, (_e952 > _e987)) * 0.0000019073523f));
                                        let _e996 = (select(_e954, _e982, (_e982 < _e954)) + (select(_e988, _e954, (_e954 > _e988)) * 0.0000019073523f));
                                        let _e998 = select(_e604, _e968, (_e968 > _e604));
                                        let _e1000 = select(_e604, _e970, (_e970 > _e604));
                                        let _e1005 = (_e998 <= select(_e638.member_1, _e995, (_e995 < _e638.member_1)));
                                        let _e1006 = (_e1000 <= select(_e638.member_1, _e996, (_e996 < _e638.member_1)));
                                        let _e1007 = (_e998 <= _e1000);
                                        if _e1005 {
                                            if _e1006 {
                                                if _e1007 {
                                                    phi_3208_ = _e921;
                                                } else {
                                                    phi_3208_ = _e916;
                                                }
                                                let _e1009 = phi_3208_;
                                                let _e1017 = (_e679 % 128u);
                                                let _e1018 = (_e1017 < 128u);
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local_6[_e1017] = _e1009.member_1;
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local_5[_e1017] = _e1009.member.member[0];
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local_4[_e1017] = _e1009.member.member[1];
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local_3[_e1017] = _e1009.member.member[2];
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local_2[_e1017] = _e1009.member.member_1[0];
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local_1[_e1017] = _e1009.member.member_1[1];
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local[_e1017] = _e1009.member.member_1[2];
                                                if _e1018 {
                                                } else {
                                                    phi_3679_ = true;
                                                    break;
                                                }
                                                local_7[_e1017] = select(_e1000, _e998, !(_e1007));
                                                if _e1007 {
                                                    phi_3285_ = _e916;
                                                } else {
                                                    phi_3285_ = _e921;
                                                }
                                                let _e1035 = phi_3285_;
                                                phi_3286_ = (_e679 + 1u);
                                                phi_3287_ = _e1035;
                                            } else {
                                                phi_3286_ = u32();
                                                phi_3287_ = type_49();
                                            }
                                            let _e1037 = phi_3286_;
                                            let _e1039 = phi_3287_;
                                            phi_3289_ = _e1037;
                                            phi_3290_ = _e1039;
                                            phi_3291_ = select(true, false, _e1006);
                                        } else {
                                            phi_3289_ = u32();
                                            phi_3290_ = type_49();
                                            phi_3291_ = true;
                                        }
                                        let _e1042 = phi_3289_;
                                        let _e1044 = phi_3290_;
                                        let _e1046 = phi_3291_;
                                        if _e1046 {
                                            if _e1005 {
                                                phi_3298_ = _e916;
                                            } else {
                                                phi_3298_ = _e921;
                                            }
                                            let _e1048 = phi_3298_;
                                            phi_3303_ = select(_e1006, true, _e1005);
                                            phi_3305_ = _e1048;
                                        } else {
                                            phi_3303_ = _e677;
                                            phi_3305_ = _e1044;
                                        }
                                        let _e1051 = phi_3303_;
                                        let _e1053 = phi_3305_;
                                        phi_3683_ = _e636;
                                        phi_3309_ = _e638;
                                        phi_3310_ = _e1051;
                                        phi_3311_ = select(_e1042, _e679, _e1046);
                                        phi_3312_ = _e1053;
                                    }
                                    let _e1645 = phi_3683_;
                                    let _e1647 = phi_3309_;
                                    let _e1649 = phi_3310_;
                                    let _e1651 = phi_3311_;
                                    let _e1653 = phi_3312_;
                                    phi_3682_ = _e1645;
                                    phi_3313_ = _e1647;
                                    phi_3314_ = _e1649;
                                    phi_3315_ = (_e642 - 1u);
                                    phi_3316_ = _e1651;
                                    phi_3317_ = _e1653;
                                } else {
                                    phi_3682_ = _e636;
                                    phi_3313_ = _e638;
                                    phi_3314_ = _e677;
                                    phi_3315_ = _e642;
                                    phi_3316_ = _e679;
                                    phi_3317_ = _e681;
                                }
                                let _e1655 = phi_3682_;
                                let _e1657 = phi_3313_;
                                let _e1659 = phi_3314_;
                                let _e1661 = phi_3315_;
                                let _e1663 = phi_3316_;
                                let _e1665 = phi_3317_;
                                phi_3681_ = _e1655;
                                phi_3318_ = _e1657;
                                phi_3319_ = _e1659;
                                phi_3320_ = _e1661;
                                phi_3321_ = _e1663;
                                phi_3322_ = _e1665;
                            } else {
                                phi_3681_ = _e636;
                                phi_3318_ = type_33();
                                phi_3319_ = bool();
                                phi_3320_ = u32();
                                phi_3321_ = u32();
                                phi_3322_ = type_49();
                            }
                            let _e1667 = phi_3681_;
                            let _e1669 = phi_3318_;
                            let _e1671 = phi_3319_;
                            let _e1673 = phi_3320_;
                            let _e1675 = phi_3321_;
                            let _e1677 = phi_3322_;
                            phi_3680_ = _e1667;
                            phi_1099_ = _e1669;
                            phi_1102_ = _e1671;
                            phi_1104_ = _e1673;
                            phi_1106_ = _e1675;
                            phi_1108_ = _e1677;
                            phi_3323_ = _e650;
                        } else {
                            phi_3680_ = _e636;
                            phi_1099_ = type_33();
                            phi_1102_ = bool();
                            phi_1104_ = u32();
                            phi_1106_ = u32();
                            phi_1108_ = type_49();
                            phi_3323_ = false;
                        }
                        let _e1679 = phi_3680_;
                        let _e1681 = phi_1099_;
                        let _e1683 = phi_1102_;
                        let _e1685 = phi_1104_;
                        let _e1687 = phi_1106_;
                        let _e1689 = phi_1108_;
                        let _e1691 = phi_3323_;
                        continue;
                        continuing {
                            phi_3525_ = _e1679;
                            phi_1098_ = _e1681;
                            phi_1101_ = _e1683;
                            phi_1103_ = _e1685;
                            phi_1105_ = _e1687;
                            phi_1107_ = _e1689;
                            phi_3679_ = _e1679;
                            break if !(_e1691);
                        }
                    }
                    let _e1694 = phi_3679_;
                    if _e1694 {
                        break;
                    }
                    let _e1696 = local_10;
                    if (_e1696.member.member_3 != 4294967295u) {
                        let _e1701 = -(_e506);
                        let _e1702 = bitcast<u32>(_e1696.member.member);
                        let _e1706 = (bitcast<i32>((_e1702 >> bitcast<u32>(23i))) & 255i);
                        let _e1707 = (_e1706 + _e1701);
                        if (_e1706 == 255i) {
                            phi_3382_ = _e1696.member.member;
                        } else {
                            if (_e1706 > 0i) {
                                if (_e1707 > 0i) {
                                    let _e1711 = (_e1707 < 255i);
                                    if _e1711 {
                                        phi_3361_ = bitcast<f32>((_e1702 + bitcast<u32>((_e1701 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3361_ = f32();
                                    }
                                    let _e1718 = phi_3361_;
                                    phi_3363_ = _e1718;
                                    phi_3364_ = select(true, false, _e1711);
                                } else {
                                    phi_3363_ = f32();
                                    phi_3364_ = true;
                                }
                                let _e1721 = phi_3363_;
                                let _e1723 = phi_3364_;
                                phi_3365_ = _e1721;
                                phi_3366_ = _e1723;
                            } else {
                                phi_3365_ = f32();
                                phi_3366_ = true;
                            }
                            let _e1725 = phi_3365_;
                            let _e1727 = phi_3366_;
                            if _e1727 {
                                let _e1728 = (_e1702 & 2147483648u);
                                let _e1735 = ((_e1702 & 8388607u) | (select(0u, 1u, ((_e1702 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1739 = (_e1735 == 0u);
                                if _e1739 {
                                    phi_3489_ = bitcast<f32>(_e1728);
                                } else {
                                    let _e1744 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1735)), 32u, _e1739) - 8u);
                                    let _e1747 = (_e1735 << bitcast<u32>((_e1744 & 31u)));
                                    let _e1749 = ((_e1707 + select(0i, 1i, (_e1706 == 0i))) - bitcast<i32>(_e1744));
                                    if (_e1749 >= 255i) {
                                        phi_3479_ = bitcast<f32>((_e1728 | 2139095040u));
                                        phi_3480_ = f32();
                                        phi_3481_ = true;
                                    } else {
                                        let _e1751 = (_e1749 > 0i);
                                        if _e1751 {
                                            phi_3473_ = bitcast<f32>(((_e1728 | (bitcast<u32>(_e1749) << bitcast<u32>(23i))) | (_e1747 & 8388607u)));
                                            phi_3474_ = f32();
                                        } else {
                                            if (_e1749 < -24i) {
                                                phi_3439_ = 26u;
                                            } else {
                                                phi_3439_ = bitcast<u32>((1i - _e1749));
                                            }
                                            let _e1756 = phi_3439_;
                                            let _e1757 = (_e1756 & 31u);
                                            let _e1759 = (_e1747 >> bitcast<u32>(_e1757));
                                            let _e1763 = (_e1747 & ((1u << bitcast<u32>(_e1757)) - 1u));
                                            let _e1767 = (1u << bitcast<u32>(((_e1756 - 1u) & 31u)));
                                            if (_e1763 > _e1767) {
                                                phi_3460_ = true;
                                            } else {
                                                if (_e1763 == _e1767) {
                                                    phi_3457_ = ((_e1759 & 1u) == 1u);
                                                } else {
                                                    phi_3457_ = false;
                                                }
                                                let _e1773 = phi_3457_;
                                                phi_3460_ = _e1773;
                                            }
                                            let _e1775 = phi_3460_;
                                            phi_3473_ = f32();
                                            phi_3474_ = bitcast<f32>((_e1728 | (_e1759 + select(0u, 1u, _e1775))));
                                        }
                                        let _e1788 = phi_3473_;
                                        let _e1790 = phi_3474_;
                                        phi_3479_ = _e1788;
                                        phi_3480_ = _e1790;
                                        phi_3481_ = _e1751;
                                    }
                                    let _e1794 = phi_3479_;
                                    let _e1796 = phi_3480_;
                                    let _e1798 = phi_3481_;
                                    phi_3489_ = select(_e1796, _e1794, _e1798);
                                }
                                let _e1802 = phi_3489_;
                                phi_3381_ = _e1802;
                            } else {
                                phi_3381_ = _e1725;
                            }
                            let _e1804 = phi_3381_;
                            phi_3382_ = _e1804;
                        }
                        let _e1806 = phi_3382_;
                        let _e1807 = bitcast<u32>(_e1806);
                        if ((_e1807 & 2147483647u) >= 2139095040u) {
                            phi_3394_ = bitcast<f32>(((_e1807 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3394_ = _e1806;
                        }
                        let _e1814 = phi_3394_;
                        phi_3399_ = type_22(_e1814, _e1696.member.member_1, _e1696.member.member_2, _e1696.member.member_3);
                    } else {
                        phi_3399_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1819 = phi_3399_;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135] = _e1819;
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
