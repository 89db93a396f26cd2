struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_21,
    member_1: f32,
}

struct type_31 {
    member: array<type_22>,
}

struct type_33 {
    member: type_28,
    member_1: u32,
    member_2: u32,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_37 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_44 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: type_42,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
@group(0) @binding(3) 
var<storage> global_6: type_46;

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
    var phi_336_: i32;
    var phi_337_: i32;
    var phi_347_: bool;
    var phi_357_: u32;
    var phi_358_: u32;
    var phi_360_: bool;
    var phi_365_: u32;
    var phi_377_: i32;
    var phi_397_: i32;
    var phi_415_: f32;
    var phi_421_: f32;
    var phi_461_: f32;
    var phi_467_: f32;
    var phi_519_: f32;
    var phi_530_: f32;
    var phi_539_: f32;
    var phi_545_: f32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_643_: f32;
    var phi_654_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_767_: f32;
    var phi_778_: f32;
    var phi_833_: i32;
    var phi_855_: u32;
    var phi_856_: u32;
    var phi_893_: i32;
    var phi_915_: u32;
    var phi_916_: u32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_3374_: bool;
    var phi_999_: type_33;
    var phi_1002_: type_50;
    var phi_1004_: u32;
    var phi_1006_: bool;
    var phi_1008_: u32;
    var phi_1019_: bool;
    var phi_1105_: type_50;
    var phi_1106_: bool;
    var phi_1107_: u32;
    var phi_2346_: type_37;
    var phi_3202_: type_50;
    var phi_3279_: type_50;
    var phi_3280_: type_50;
    var phi_3281_: u32;
    var phi_3283_: type_50;
    var phi_3284_: u32;
    var phi_3285_: bool;
    var phi_3292_: type_50;
    var phi_3297_: type_50;
    var phi_3298_: bool;
    var phi_1126_: type_33;
    var phi_1129_: type_4;
    var phi_1130_: type_4;
    var phi_1152_: type_4;
    var phi_1180_: u32;
    var phi_1196_: type_44;
    var phi_1590_: bool;
    var phi_1619_: bool;
    var phi_1996_: f32;
    var phi_1997_: f32;
    var phi_1998_: f32;
    var phi_1999_: f32;
    var phi_2000_: vec3<f32>;
    var phi_2001_: vec3<f32>;
    var phi_2002_: vec3<f32>;
    var phi_2003_: vec3<f32>;
    var phi_2034_: bool;
    var phi_2043_: vec3<f32>;
    var phi_2208_: f32;
    var phi_2210_: f32;
    var phi_2211_: bool;
    var phi_2231_: f32;
    var phi_2232_: f32;
    var phi_2255_: type_21;
    var phi_2257_: type_21;
    var phi_2258_: bool;
    var phi_2262_: type_21;
    var phi_2263_: type_21;
    var phi_2264_: type_21;
    var phi_2265_: bool;
    var phi_2269_: type_21;
    var phi_2270_: bool;
    var phi_2271_: type_21;
    var phi_2272_: bool;
    var phi_2273_: bool;
    var phi_2274_: type_21;
    var phi_2275_: bool;
    var phi_2276_: bool;
    var phi_2284_: type_21;
    var phi_2285_: bool;
    var phi_2289_: type_21;
    var phi_2314_: bool;
    var phi_2315_: bool;
    var phi_2322_: type_33;
    var phi_2323_: type_33;
    var phi_2324_: type_33;
    var phi_1127_: type_33;
    var phi_3368_: bool;
    var phi_3550_: bool;
    var phi_3300_: type_33;
    var phi_3301_: type_50;
    var phi_3302_: bool;
    var phi_3303_: u32;
    var phi_3549_: bool;
    var phi_3304_: type_33;
    var phi_3305_: type_50;
    var phi_3306_: u32;
    var phi_3307_: bool;
    var phi_3308_: u32;
    var phi_3548_: bool;
    var phi_3309_: type_33;
    var phi_3310_: type_50;
    var phi_3311_: u32;
    var phi_3312_: bool;
    var phi_3313_: u32;
    var phi_3547_: bool;
    var phi_1000_: type_33;
    var phi_1003_: type_50;
    var phi_1005_: u32;
    var phi_1007_: bool;
    var phi_1009_: u32;
    var phi_3314_: bool;
    var phi_3546_: bool;
    var local_10: type_33;
    var local_11: type_33;
    var local_12: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e82 = arrayLength((&global_4.member));
            let _e93 = global_2.member[0u][0u];
            let _e97 = global_2.member[0u][1u];
            let _e101 = global_2.member[0u][2u];
            let _e105 = global_2.member[1u][0u];
            let _e109 = global_2.member[1u][1u];
            let _e113 = global_2.member[1u][2u];
            let _e117 = global_2.member[1u][3u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e131 = (_e79.x + (_e79.y * 2097152u));
            let _e132 = (_e131 < arrayLength((&global_3.member)));
            if _e132 {
                let _e133 = (_e131 < arrayLength((&global_5.member)));
                if _e133 {
                    if _e132 {
                    } else {
                        break;
                    }
                    let _e141 = global_3.member[_e131].member_2[0u];
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e148 = global_3.member[_e131].member_2[1u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_3.member[_e131].member_2[2u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_3.member[_e131].member[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_3.member[_e131].member[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_3.member[_e131].member[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e180 = select(_e150, _e143, (_e150 < _e143));
                    let _e182 = select(_e157, _e180, (_e157 < _e180));
                    let _e184 = select(_e164, _e182, (_e164 < _e182));
                    let _e186 = select(_e171, _e184, (_e171 < _e184));
                    let _e188 = select(_e178, _e186, (_e178 < _e186));
                    let _e192 = global_3.member[_e131].member_1;
                    let _e193 = bitcast<u32>(_e192);
                    let _e194 = (_e193 & 2147483647u);
                    let _e201 = global_3.member[_e131].member_3;
                    let _e202 = bitcast<u32>(_e201);
                    let _e203 = (_e202 & 2147483647u);
                    let _e207 = (((select(_e194, _e188, (_e194 < _e188)) < 2139095040u) && (_e203 <= 2139095040u)) && (_e182 > 0u));
                    if _e207 {
                        let _e210 = (bitcast<u32>(bitcast<f32>(_e182)) & 2147483647u);
                        if (_e210 >= 8388608u) {
                            phi_336_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_336_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_336_;
                        phi_337_ = _e224;
                    } else {
                        phi_337_ = 0i;
                    }
                    let _e226 = phi_337_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_347_ = true;
                    } else {
                        phi_347_ = (_e150 == _e182);
                    }
                    let _e230 = phi_347_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_357_ = _e232;
                        phi_358_ = _e232;
                        phi_360_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_357_ = u32();
                        phi_358_ = 0u;
                        phi_360_ = true;
                    }
                    let _e236 = phi_357_;
                    let _e238 = phi_358_;
                    let _e240 = phi_360_;
                    if _e240 {
                        phi_365_ = (_e238 + 1u);
                    } else {
                        phi_365_ = 0u;
                    }
                    let _e244 = phi_365_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_377_ = -126i;
                    } else {
                        phi_377_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_377_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_397_ = -126i;
                    } else {
                        phi_397_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_397_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_3.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_415_ = _e283[0];
                    } else {
                        phi_415_ = _e283[1];
                    }
                    let _e288 = phi_415_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_421_ = _e283[2];
                    } else {
                        phi_421_ = _e288;
                    }
                    let _e292 = phi_421_;
                    let _e293 = bitcast<u32>(_e292);
                    let _e295 = ((_e293 & 2139095040u) != 0u);
                    let _e309 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e293 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e293 & 2147483648u))), _e292, _e295) * _e256) * select(0.00000011920929f, 1f, _e295)) * _e262);
                    let _e310 = global_3.member[_e131].member_2;
                    if _e284 {
                        phi_461_ = _e310[0];
                    } else {
                        phi_461_ = _e310[1];
                    }
                    let _e314 = phi_461_;
                    if _e289 {
                        phi_467_ = _e310[2];
                    } else {
                        phi_467_ = _e314;
                    }
                    let _e317 = phi_467_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e273) * select(0.00000011920929f, 1f, _e320)) * _e279);
                    let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e338 {
                        let _e342 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_519_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                    } else {
                        phi_519_ = 0f;
                    }
                    let _e346 = phi_519_;
                    let _e347 = (_e309 + _e346);
                    let _e348 = (_e309 - _e346);
                    let _e349 = select(_e334, 0f, _e338);
                    if _e338 {
                        phi_530_ = 38685626000000000000000000f;
                    } else {
                        phi_530_ = (1f / _e334);
                    }
                    let _e352 = phi_530_;
                    let _e353 = (_e244 == 0u);
                    if _e353 {
                        phi_539_ = _e283[0];
                    } else {
                        phi_539_ = _e283[1];
                    }
                    let _e357 = phi_539_;
                    let _e358 = (_e244 == 2u);
                    if _e358 {
                        phi_545_ = _e283[2];
                    } else {
                        phi_545_ = _e357;
                    }
                    let _e361 = phi_545_;
                    let _e362 = bitcast<u32>(_e361);
                    let _e364 = ((_e362 & 2139095040u) != 0u);
                    let _e378 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * _e256) * select(0.00000011920929f, 1f, _e364)) * _e262);
                    if _e353 {
                        phi_585_ = _e310[0];
                    } else {
                        phi_585_ = _e310[1];
                    }
                    let _e382 = phi_585_;
                    if _e358 {
                        phi_591_ = _e310[2];
                    } else {
                        phi_591_ = _e382;
                    }
                    let _e385 = phi_591_;
                    let _e386 = bitcast<u32>(_e385);
                    let _e388 = ((_e386 & 2139095040u) != 0u);
                    let _e402 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e385, _e388) * _e273) * select(0.00000011920929f, 1f, _e388)) * _e279);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e378) & 2147483647u)) * 0.00000011920929f);
                        phi_643_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_643_ = 0f;
                    }
                    let _e414 = phi_643_;
                    let _e415 = (_e378 + _e414);
                    let _e416 = (_e378 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_654_ = 38685626000000000000000000f;
                    } else {
                        phi_654_ = (1f / _e402);
                    }
                    let _e420 = phi_654_;
                    let _e421 = (_e246 == 0u);
                    if _e421 {
                        phi_663_ = _e283[0];
                    } else {
                        phi_663_ = _e283[1];
                    }
                    let _e425 = phi_663_;
                    let _e426 = (_e246 == 2u);
                    if _e426 {
                        phi_669_ = _e283[2];
                    } else {
                        phi_669_ = _e425;
                    }
                    let _e429 = phi_669_;
                    let _e430 = bitcast<u32>(_e429);
                    let _e432 = ((_e430 & 2139095040u) != 0u);
                    let _e446 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e430 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e430 & 2147483648u))), _e429, _e432) * _e256) * select(0.00000011920929f, 1f, _e432)) * _e262);
                    if _e421 {
                        phi_709_ = _e310[0];
                    } else {
                        phi_709_ = _e310[1];
                    }
                    let _e450 = phi_709_;
                    if _e426 {
                        phi_715_ = _e310[2];
                    } else {
                        phi_715_ = _e450;
                    }
                    let _e453 = phi_715_;
                    let _e454 = bitcast<u32>(_e453);
                    let _e456 = ((_e454 & 2139095040u) != 0u);
                    let _e470 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e454 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e454 & 2147483648u))), _e453, _e456) * _e273) * select(0.00000011920929f, 1f, _e456)) * _e279);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e474 {
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) * 0.00000011920929f);
                        phi_767_ = select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f));
                    } else {
                        phi_767_ = 0f;
                    }
                    let _e482 = phi_767_;
                    let _e483 = (_e446 + _e482);
                    let _e484 = (_e446 - _e482);
                    let _e485 = select(_e470, 0f, _e474);
                    if _e474 {
                        phi_778_ = 38685626000000000000000000f;
                    } else {
                        phi_778_ = (1f / _e470);
                    }
                    let _e488 = phi_778_;
                    let _e491 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                    let _e494 = bitcast<f32>((bitcast<u32>(_e378) & 2147483647u));
                    let _e496 = select(_e494, _e491, (_e491 > _e494));
                    let _e499 = bitcast<f32>((bitcast<u32>(_e446) & 2147483647u));
                    let _e502 = (_e121 + _e226);
                    if (_e207 && (select(_e499, _e496, (_e496 > _e499)) <= 1099511600000f)) {
                        let _e512 = ((_e194 & 8388607u) | (select(0u, 1u, ((_e194 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e515 = bitcast<i32>((_e194 >> bitcast<u32>(23i)));
                        let _e519 = (_e512 == 0u);
                        let _e522 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e512)), 32u, _e519)) - 8i);
                        if (_e515 == 255i) {
                            phi_833_ = 255i;
                        } else {
                            phi_833_ = (((_e515 + select(0i, 1i, (_e515 == 0i))) - _e522) + _e502);
                        }
                        let _e530 = phi_833_;
                        let _e540 = (_e530 <= 0i);
                        if _e540 {
                            phi_856_ = u32();
                        } else {
                            if _e519 {
                                phi_855_ = u32();
                            } else {
                                phi_855_ = select(((bitcast<u32>(_e530) << bitcast<u32>(23i)) | ((_e512 << bitcast<u32>(((_e522 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e530 >= 255i));
                            }
                            let _e544 = phi_855_;
                            phi_856_ = _e544;
                        }
                        let _e546 = phi_856_;
                        let _e558 = ((_e203 & 8388607u) | (select(0u, 1u, ((_e203 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e561 = bitcast<i32>((_e203 >> bitcast<u32>(23i)));
                        let _e565 = (_e558 == 0u);
                        let _e568 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e558)), 32u, _e565)) - 8i);
                        if (_e561 == 255i) {
                            phi_893_ = 255i;
                        } else {
                            phi_893_ = (((_e561 + select(0i, 1i, (_e561 == 0i))) - _e568) + _e502);
                        }
                        let _e576 = phi_893_;
                        let _e586 = (_e576 <= 0i);
                        if _e586 {
                            phi_916_ = u32();
                        } else {
                            if _e565 {
                                phi_915_ = u32();
                            } else {
                                phi_915_ = select(((bitcast<u32>(_e576) << bitcast<u32>(23i)) | ((_e558 << bitcast<u32>(((_e568 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e576 >= 255i));
                            }
                            let _e590 = phi_915_;
                            phi_916_ = _e590;
                        }
                        let _e592 = phi_916_;
                        phi_924_ = bitcast<f32>(((_e202 & 2147483648u) | select(_e592, 0u, select(_e565, true, _e586))));
                        phi_925_ = bitcast<f32>(((_e193 & 2147483648u) | select(_e546, 0u, select(_e519, true, _e540))));
                    } else {
                        phi_924_ = 0f;
                        phi_925_ = 1f;
                    }
                    let _e598 = phi_924_;
                    let _e600 = phi_925_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                    let _e606 = (_e245 % 3u);
                    let _e607 = (_e606 < 3u);
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e609 = local_9[_e606];
                    let _e610 = (_e244 % 3u);
                    let _e611 = (_e610 < 3u);
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e613 = local_9[_e610];
                    let _e614 = (_e246 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_9[_e614];
                    local_8 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e621 = local_8[_e606];
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e623 = local_8[_e610];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e625 = local_8[_e614];
                    phi_3374_ = false;
                    phi_999_ = type_33(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e598), 0u, 0u);
                    phi_1002_ = type_50(type_42(array<f32, 3>(_e609, _e613, _e617), array<f32, 3>(_e621, _e623, _e625)), select(0u, 2147483648u, (_e82 == 0u)));
                    phi_1004_ = ((3u * _e82) + 1u);
                    phi_1006_ = (_e600 <= _e598);
                    phi_1008_ = 0u;
                    loop {
                        let _e633 = phi_3374_;
                        let _e635 = phi_999_;
                        let _e637 = phi_1002_;
                        let _e639 = phi_1004_;
                        let _e641 = phi_1006_;
                        let _e643 = phi_1008_;
                        local_10 = _e635;
                        local_11 = _e635;
                        if _e641 {
                            phi_1019_ = true;
                        } else {
                            phi_1019_ = (_e643 > 0u);
                        }
                        let _e646 = phi_1019_;
                        if _e646 {
                            let _e647 = (_e639 > 0u);
                            if _e647 {
                                if _e641 {
                                    phi_1105_ = _e637;
                                    phi_1106_ = _e641;
                                    phi_1107_ = _e643;
                                } else {
                                    let _e648 = (_e643 - 1u);
                                    let _e649 = (_e648 % 128u);
                                    let _e650 = (_e649 < 128u);
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e652 = local_6[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e654 = local_5[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e656 = local_4[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e658 = local_3[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e661 = local_2[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e663 = local_1[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e665 = local[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e670 = local_7[_e649];
                                    phi_1105_ = type_50(type_42(array<f32, 3>(_e654, _e656, _e658), array<f32, 3>(_e661, _e663, _e665)), _e652);
                                    phi_1106_ = (_e670 <= _e635.member.member_1);
                                    phi_1107_ = _e648;
                                }
                                let _e675 = phi_1105_;
                                let _e677 = phi_1106_;
                                let _e679 = phi_1107_;
                                if _e677 {
                                    if ((_e675.member_1 & 2147483648u) != 0u) {
                                        phi_1126_ = _e635;
                                        phi_1129_ = type_4(0u, ((_e675.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1063 = phi_1126_;
                                            let _e1065 = phi_1129_;
                                            local_12 = _e1063;
                                            if (_e1065.member < _e1065.member_1) {
                                                phi_1130_ = type_4((_e1065.member + 1u), _e1065.member_1);
                                                phi_1152_ = type_4(1u, _e1065.member);
                                            } else {
                                                phi_1130_ = _e1065;
                                                phi_1152_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1078 = phi_1130_;
                                            let _e1080 = phi_1152_;
                                            let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                            if _e1084 {
                                                let _e1090 = type_33(_e1063.member, _e1063.member_1, (_e1063.member_2 + 1u));
                                                let _e1091 = ((_e675.member_1 & 268435455u) + _e1080.member_1);
                                                let _e1092 = (_e1091 < arrayLength((&global_6.member)));
                                                if _e1092 {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3368_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_6.member[_e1091].member_1;
                                                    phi_1180_ = _e1095;
                                                } else {
                                                    phi_1180_ = 4294967295u;
                                                }
                                                let _e1097 = phi_1180_;
                                                if _e1092 {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3368_ = true;
                                                        break;
                                                    }
                                                    let _e1099 = global_6.member[_e1091];
                                                    phi_1196_ = _e1099;
                                                } else {
                                                    phi_1196_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1101 = phi_1196_;
                                                let _e1113 = ((10u * _e245) & 31u);
                                                let _e1116 = ((_e1101.member[0] >> bitcast<u32>(_e1113)) & 1023u);
                                                let _e1124 = bitcast<f32>((bitcast<u32>(((_e675.member.member_1[0] - _e675.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                let _e1129 = (_e675.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1116)) - 8388608f) * _e1124)) ^ _e117)));
                                                let _e1133 = select(select(_e675.member.member_1[0], _e1129, (_e1129 < _e675.member.member_1[0])), _e675.member.member_1[0], (_e1116 == 1023u));
                                                let _e1135 = ((10u * _e244) & 31u);
                                                let _e1138 = ((_e1101.member[0] >> bitcast<u32>(_e1135)) & 1023u);
                                                let _e1146 = bitcast<f32>((bitcast<u32>(((_e675.member.member_1[1] - _e675.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                let _e1151 = (_e675.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1138)) - 8388608f) * _e1146)) ^ _e117)));
                                                let _e1155 = select(select(_e675.member.member_1[1], _e1151, (_e1151 < _e675.member.member_1[1])), _e675.member.member_1[1], (_e1138 == 1023u));
                                                let _e1157 = ((10u * _e246) & 31u);
                                                let _e1160 = ((_e1101.member[0] >> bitcast<u32>(_e1157)) & 1023u);
                                                let _e1168 = bitcast<f32>((bitcast<u32>(((_e675.member.member_1[2] - _e675.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                let _e1173 = (_e675.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1160)) - 8388608f) * _e1168)) ^ _e117)));
                                                let _e1177 = select(select(_e675.member.member_1[2], _e1173, (_e1173 < _e675.member.member_1[2])), _e675.member.member_1[2], (_e1160 == 1023u));
                                                let _e1181 = ((_e1101.member[1] >> bitcast<u32>(_e1113)) & 1023u);
                                                let _e1189 = (_e675.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1181)) - 8388608f) * _e1124)) ^ _e117)));
                                                let _e1193 = select(select(_e675.member.member_1[0], _e1189, (_e1189 < _e675.member.member_1[0])), _e675.member.member_1[0], (_e1181 == 1023u));
                                                let _e1196 = ((_e1101.member[1] >> bitcast<u32>(_e1135)) & 1023u);
                                                let _e1204 = (_e675.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1196)) - 8388608f) * _e1146)) ^ _e117)));
                                                let _e1208 = select(select(_e675.member.member_1[1], _e1204, (_e1204 < _e675.member.member_1[1])), _e675.member.member_1[1], (_e1196 == 1023u));
                                                let _e1211 = ((_e1101.member[1] >> bitcast<u32>(_e1157)) & 1023u);
                                                let _e1219 = (_e675.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1211)) - 8388608f) * _e1168)) ^ _e117)));
                                                let _e1223 = select(select(_e675.member.member_1[2], _e1219, (_e1219 < _e675.member.member_1[2])), _e675.member.member_1[2], (_e1211 == 1023u));
                                                let _e1227 = ((_e1101.member[2] >> bitcast<u32>(_e1113)) & 1023u);
                                                let _e1235 = (_e675.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1227)) - 8388608f) * _e1124)) ^ _e117)));
                                                let _e1239 = select(select(_e675.member.member_1[0], _e1235, (_e1235 < _e675.member.member_1[0])), _e675.member.member_1[0], (_e1227 == 1023u));
                                                let _e1242 = ((_e1101.member[2] >> bitcast<u32>(_e1135)) & 1023u);
                                                let _e1250 = (_e675.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1242)) - 8388608f) * _e1146)) ^ _e117)));
                                                let _e1254 = select(select(_e675.member.member_1[1], _e1250, (_e1250 < _e675.member.member_1[1])), _e675.member.member_1[1], (_e1242 == 1023u));
                                                let _e1257 = ((_e1101.member[2] >> bitcast<u32>(_e1157)) & 1023u);
                                                let _e1265 = (_e675.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1257)) - 8388608f) * _e1168)) ^ _e117)));
                                                let _e1269 = select(select(_e675.member.member_1[2], _e1265, (_e1265 < _e675.member.member_1[2])), _e675.member.member_1[2], (_e1257 == 1023u));
                                                let _e1274 = (_e1177 - _e446);
                                                let _e1277 = (((_e1133 - _e309) * _e485) - (_e1274 * _e349));
                                                let _e1280 = (((_e1155 - _e378) * _e485) - (_e1274 * _e417));
                                                let _e1283 = (_e1223 - _e446);
                                                let _e1286 = (((_e1193 - _e309) * _e485) - (_e1283 * _e349));
                                                let _e1289 = (((_e1208 - _e378) * _e485) - (_e1283 * _e417));
                                                let _e1292 = (_e1269 - _e446);
                                                let _e1295 = (((_e1239 - _e309) * _e485) - (_e1292 * _e349));
                                                let _e1298 = (((_e1254 - _e378) * _e485) - (_e1292 * _e417));
                                                let _e1299 = (_e1295 * _e1289);
                                                let _e1300 = (_e1298 * _e1286);
                                                let _e1301 = (_e1277 * _e1298);
                                                let _e1302 = (_e1280 * _e1295);
                                                let _e1303 = (_e1286 * _e1280);
                                                let _e1304 = (_e1289 * _e1277);
                                                let _e1309 = (((_e1299 >= _e1300) && (_e1301 >= _e1302)) && (_e1303 >= _e1304));
                                                if (_e1309 || (((_e1299 <= _e1300) && (_e1301 <= _e1302)) && (_e1303 <= _e1304))) {
                                                    let _e1316 = select(-1f, 1f, _e1309);
                                                    let _e1318 = ((_e1299 - _e1300) * _e1316);
                                                    let _e1320 = select(0f, _e1318, (_e1318 > 0f));
                                                    let _e1322 = ((_e1301 - _e1302) * _e1316);
                                                    let _e1324 = select(0f, _e1322, (_e1322 > 0f));
                                                    let _e1326 = ((_e1303 - _e1304) * _e1316);
                                                    let _e1328 = select(0f, _e1326, (_e1326 > 0f));
                                                    let _e1330 = ((_e1320 + _e1324) + _e1328);
                                                    if (_e1330 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2274_ = type_21();
                                                        phi_2275_ = true;
                                                        phi_2276_ = false;
                                                    } else {
                                                        let _e1333 = select(_e1286, _e1277, (_e1277 < _e1286));
                                                        if (select(_e1295, _e1333, (_e1333 < _e1295)) > 0f) {
                                                            phi_1590_ = true;
                                                        } else {
                                                            let _e1338 = select(_e1286, _e1277, (_e1277 > _e1286));
                                                            phi_1590_ = (select(_e1295, _e1338, (_e1338 > _e1295)) < 0f);
                                                        }
                                                        let _e1343 = phi_1590_;
                                                        if _e1343 {
                                                            phi_2271_ = type_21();
                                                            phi_2272_ = true;
                                                            phi_2273_ = false;
                                                        } else {
                                                            let _e1345 = select(_e1289, _e1280, (_e1280 < _e1289));
                                                            if (select(_e1298, _e1345, (_e1345 < _e1298)) > 0f) {
                                                                phi_1619_ = true;
                                                            } else {
                                                                let _e1350 = select(_e1289, _e1280, (_e1280 > _e1289));
                                                                phi_1619_ = (select(_e1298, _e1350, (_e1350 > _e1298)) < 0f);
                                                            }
                                                            let _e1355 = phi_1619_;
                                                            if _e1355 {
                                                                phi_2269_ = type_21();
                                                                phi_2270_ = false;
                                                            } else {
                                                                let _e1357 = select(_e1193, _e1133, (_e1133 < _e1193));
                                                                let _e1361 = select(_e1193, _e1133, (_e1133 > _e1193));
                                                                let _e1365 = select(_e1208, _e1155, (_e1155 < _e1208));
                                                                let _e1369 = select(_e1208, _e1155, (_e1155 > _e1208));
                                                                let _e1373 = select(_e1223, _e1177, (_e1177 < _e1223));
                                                                let _e1377 = select(_e1223, _e1177, (_e1177 > _e1223));
                                                                let _e1382 = ((select(_e1239, _e1357, (_e1357 < _e1239)) - _e347) * _e352);
                                                                let _e1383 = ((select(_e1239, _e1361, (_e1361 > _e1239)) - _e348) * _e352);
                                                                let _e1386 = ((select(_e1254, _e1365, (_e1365 < _e1254)) - _e415) * _e420);
                                                                let _e1387 = ((select(_e1254, _e1369, (_e1369 > _e1254)) - _e416) * _e420);
                                                                let _e1390 = ((select(_e1269, _e1373, (_e1373 < _e1269)) - _e483) * _e488);
                                                                let _e1391 = ((select(_e1269, _e1377, (_e1377 > _e1269)) - _e484) * _e488);
                                                                let _e1393 = select(_e1391, _e1390, (_e1390 < _e1391));
                                                                let _e1395 = select(_e1391, _e1390, (_e1390 > _e1391));
                                                                let _e1397 = select(_e1383, _e1382, (_e1382 < _e1383));
                                                                let _e1399 = select(_e1387, _e1386, (_e1386 < _e1387));
                                                                let _e1401 = select(_e1399, _e1397, (_e1397 > _e1399));
                                                                let _e1403 = select(_e1393, _e1401, (_e1401 > _e1393));
                                                                let _e1405 = select(_e1383, _e1382, (_e1382 > _e1383));
                                                                let _e1407 = select(_e1387, _e1386, (_e1386 > _e1387));
                                                                let _e1409 = select(_e1407, _e1405, (_e1405 < _e1407));
                                                                let _e1411 = select(_e1395, _e1409, (_e1409 < _e1395));
                                                                let _e1412 = -(_e1393);
                                                                let _e1418 = select(_e600, _e1403, (_e1403 > _e600));
                                                                if (_e1418 > (_e1411 + (select(_e1412, _e1395, (_e1395 > _e1412)) * 0.0000019073523f))) {
                                                                    phi_2264_ = type_21();
                                                                    phi_2265_ = true;
                                                                } else {
                                                                    let _e1420 = (_e1418 > _e1063.member.member_1);
                                                                    if _e1420 {
                                                                        phi_2263_ = type_21();
                                                                    } else {
                                                                        let _e1421 = vec3<f32>(_e1133, _e1155, _e1177);
                                                                        let _e1422 = vec3<f32>(_e1193, _e1208, _e1223);
                                                                        let _e1423 = vec3<f32>(_e1239, _e1254, _e1269);
                                                                        let _e1424 = (_e1193 - _e1133);
                                                                        let _e1425 = (_e1208 - _e1155);
                                                                        let _e1426 = (_e1223 - _e1177);
                                                                        let _e1427 = vec3<f32>(_e1424, _e1425, _e1426);
                                                                        let _e1428 = (_e1239 - _e1193);
                                                                        let _e1429 = (_e1254 - _e1208);
                                                                        let _e1430 = (_e1269 - _e1223);
                                                                        let _e1431 = vec3<f32>(_e1428, _e1429, _e1430);
                                                                        let _e1432 = (_e1133 - _e1239);
                                                                        let _e1433 = (_e1155 - _e1254);
                                                                        let _e1434 = (_e1177 - _e1269);
                                                                        let _e1435 = vec3<f32>(_e1432, _e1433, _e1434);
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                        let _e1441 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                        let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                        let _e1448 = select(_e1446, _e1443, (_e1443 > _e1446));
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                        let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                        let _e1459 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                        let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                        let _e1464 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                        let _e1467 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                        let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                        let _e1472 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                        let _e1474 = select(_e1472, _e1469, (_e1469 > _e1472));
                                                                        let _e1476 = select(_e1461, _e1448, (_e1448 > _e1461));
                                                                        let _e1478 = select(_e1474, _e1476, (_e1476 > _e1474));
                                                                        if (_e1448 == _e1478) {
                                                                            phi_1996_ = _e1289;
                                                                            phi_1997_ = _e1286;
                                                                            phi_1998_ = _e1280;
                                                                            phi_1999_ = _e1277;
                                                                            phi_2000_ = _e1421;
                                                                            phi_2001_ = _e1435;
                                                                            phi_2002_ = _e1431;
                                                                            phi_2003_ = _e1427;
                                                                        } else {
                                                                            let _e1480 = (_e1461 == _e1478);
                                                                            let _e1485 = vec3(_e1480);
                                                                            phi_1996_ = select(_e1280, _e1298, _e1480);
                                                                            phi_1997_ = select(_e1277, _e1295, _e1480);
                                                                            phi_1998_ = select(_e1298, _e1289, _e1480);
                                                                            phi_1999_ = select(_e1295, _e1286, _e1480);
                                                                            phi_2000_ = select(_e1423, _e1422, _e1485);
                                                                            phi_2001_ = select(_e1431, _e1427, _e1485);
                                                                            phi_2002_ = select(_e1427, _e1435, _e1485);
                                                                            phi_2003_ = select(_e1435, _e1431, _e1485);
                                                                        }
                                                                        let _e1491 = phi_1996_;
                                                                        let _e1493 = phi_1997_;
                                                                        let _e1495 = phi_1998_;
                                                                        let _e1497 = phi_1999_;
                                                                        let _e1499 = phi_2000_;
                                                                        let _e1501 = phi_2001_;
                                                                        let _e1503 = phi_2002_;
                                                                        let _e1505 = phi_2003_;
                                                                        let _e1512 = ((_e1503.y * _e1501.z) - (_e1501.y * _e1503.z));
                                                                        let _e1517 = ((_e1503.z * _e1501.x) - (_e1501.z * _e1503.x));
                                                                        let _e1520 = ((_e1503.x * _e1501.y) - (_e1501.x * _e1503.y));
                                                                        if (_e1320 >= _e1324) {
                                                                            phi_2034_ = select(true, false, (_e1320 >= _e1328));
                                                                        } else {
                                                                            phi_2034_ = true;
                                                                        }
                                                                        let _e1525 = phi_2034_;
                                                                        if _e1525 {
                                                                            phi_2043_ = select(_e1423, _e1422, vec3((_e1324 >= _e1328)));
                                                                        } else {
                                                                            phi_2043_ = _e1421;
                                                                        }
                                                                        let _e1530 = phi_2043_;
                                                                        let _e1541 = (((_e1512 * (_e1530.x - _e309)) + (_e1517 * (_e1530.y - _e378))) + (_e1520 * (_e1530.z - _e446)));
                                                                        let _e1546 = (((_e1512 * _e349) + (_e1517 * _e417)) + (_e1520 * _e485));
                                                                        let _e1547 = (_e1493 - _e1497);
                                                                        let _e1548 = (_e1491 - _e1495);
                                                                        let _e1556 = (-(((_e1497 * _e1547) + (_e1495 * _e1548))) / ((_e1547 * _e1547) + (_e1548 * _e1548)));
                                                                        let _e1558 = select(1f, _e1556, (_e1556 < 1f));
                                                                        let _e1560 = select(0f, _e1558, (_e1558 > 0f));
                                                                        let _e1573 = ((_e1499.x + (_e1505.x * _e1560)) - _e309);
                                                                        let _e1574 = ((_e1499.y + (_e1505.y * _e1560)) - _e378);
                                                                        let _e1575 = ((_e1499.z + (_e1505.z * _e1560)) - _e446);
                                                                        let _e1576 = (_e1575 / _e485);
                                                                        let _e1588 = bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u));
                                                                        let _e1591 = bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u));
                                                                        let _e1593 = select(_e1591, _e1588, (_e1588 > _e1591));
                                                                        let _e1596 = bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u));
                                                                        let _e1598 = select(_e1596, _e1593, (_e1593 > _e1596));
                                                                        let _e1604 = bitcast<f32>((bitcast<u32>(_e1512) & 2147483647u));
                                                                        let _e1607 = bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u));
                                                                        let _e1609 = select(_e1607, _e1604, (_e1604 > _e1607));
                                                                        let _e1612 = bitcast<f32>((bitcast<u32>(_e1520) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1512 * _e1573) + (_e1517 * _e1574)) + (_e1520 * _e1575)) - _e1541)) & 2147483647u)) <= ((0.0000009536743f * select(_e1478, _e1598, (_e1598 > _e1478))) * select(_e1612, _e1609, (_e1609 > _e1612)))) {
                                                                            let _e1622 = bitcast<f32>((bitcast<u32>(_e1503.x) & 2147483647u));
                                                                            let _e1625 = bitcast<f32>((bitcast<u32>(_e1503.y) & 2147483647u));
                                                                            let _e1627 = select(_e1625, _e1622, (_e1622 > _e1625));
                                                                            let _e1630 = bitcast<f32>((bitcast<u32>(_e1503.z) & 2147483647u));
                                                                            let _e1636 = bitcast<f32>((bitcast<u32>(_e1501.x) & 2147483647u));
                                                                            let _e1639 = bitcast<f32>((bitcast<u32>(_e1501.y) & 2147483647u));
                                                                            let _e1641 = select(_e1639, _e1636, (_e1636 > _e1639));
                                                                            let _e1644 = bitcast<f32>((bitcast<u32>(_e1501.z) & 2147483647u));
                                                                            let _e1648 = (bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u)) > ((0.0000038146973f * select(_e1630, _e1627, (_e1627 > _e1630))) * select(_e1644, _e1641, (_e1641 > _e1644))));
                                                                            if _e1648 {
                                                                                phi_2208_ = (_e1541 / _e1546);
                                                                            } else {
                                                                                phi_2208_ = f32();
                                                                            }
                                                                            let _e1651 = phi_2208_;
                                                                            phi_2210_ = _e1651;
                                                                            phi_2211_ = select(true, false, _e1648);
                                                                        } else {
                                                                            phi_2210_ = f32();
                                                                            phi_2211_ = true;
                                                                        }
                                                                        let _e1654 = phi_2210_;
                                                                        let _e1656 = phi_2211_;
                                                                        if _e1656 {
                                                                            let _e1664 = (((_e1512 * (_e1573 - (_e349 * _e1576))) + (_e1517 * (_e1574 - (_e417 * _e1576)))) / _e1546);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u)) <= _e1478) {
                                                                                phi_2231_ = (_e1576 + _e1664);
                                                                            } else {
                                                                                phi_2231_ = _e1576;
                                                                            }
                                                                            let _e1671 = phi_2231_;
                                                                            phi_2232_ = _e1671;
                                                                        } else {
                                                                            phi_2232_ = _e1654;
                                                                        }
                                                                        let _e1673 = phi_2232_;
                                                                        let _e1675 = select(_e1411, _e1673, (_e1673 < _e1411));
                                                                        let _e1677 = select(_e1403, _e1675, (_e1675 > _e1403));
                                                                        if (_e1677 >= _e600) {
                                                                            let _e1679 = (_e1677 <= _e1063.member.member_1);
                                                                            if _e1679 {
                                                                                let _e1680 = (1f / _e1330);
                                                                                phi_2255_ = type_21(_e1677, (_e1324 * _e1680), (_e1328 * _e1680), _e1097);
                                                                            } else {
                                                                                phi_2255_ = type_21();
                                                                            }
                                                                            let _e1685 = phi_2255_;
                                                                            phi_2257_ = _e1685;
                                                                            phi_2258_ = select(true, false, _e1679);
                                                                        } else {
                                                                            phi_2257_ = type_21();
                                                                            phi_2258_ = true;
                                                                        }
                                                                        let _e1688 = phi_2257_;
                                                                        let _e1690 = phi_2258_;
                                                                        if _e1690 {
                                                                            phi_2262_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2262_ = _e1688;
                                                                        }
                                                                        let _e1692 = phi_2262_;
                                                                        phi_2263_ = _e1692;
                                                                    }
                                                                    let _e1694 = phi_2263_;
                                                                    phi_2264_ = _e1694;
                                                                    phi_2265_ = _e1420;
                                                                }
                                                                let _e1696 = phi_2264_;
                                                                let _e1698 = phi_2265_;
                                                                phi_2269_ = _e1696;
                                                                phi_2270_ = _e1698;
                                                            }
                                                            let _e1700 = phi_2269_;
                                                            let _e1702 = phi_2270_;
                                                            phi_2271_ = _e1700;
                                                            phi_2272_ = _e1355;
                                                            phi_2273_ = _e1702;
                                                        }
                                                        let _e1704 = phi_2271_;
                                                        let _e1706 = phi_2272_;
                                                        let _e1708 = phi_2273_;
                                                        phi_2274_ = _e1704;
                                                        phi_2275_ = _e1706;
                                                        phi_2276_ = _e1708;
                                                    }
                                                    let _e1710 = phi_2274_;
                                                    let _e1712 = phi_2275_;
                                                    let _e1714 = phi_2276_;
                                                    phi_2284_ = _e1710;
                                                    phi_2285_ = select(_e1714, true, _e1712);
                                                } else {
                                                    phi_2284_ = type_21();
                                                    phi_2285_ = true;
                                                }
                                                let _e1717 = phi_2284_;
                                                let _e1719 = phi_2285_;
                                                if _e1719 {
                                                    phi_2289_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2289_ = _e1717;
                                                }
                                                let _e1721 = phi_2289_;
                                                if (_e1721.member_3 != 4294967295u) {
                                                    if (_e1097 != 4294967295u) {
                                                        if (_e1721.member < _e1063.member.member.member) {
                                                            phi_2315_ = true;
                                                        } else {
                                                            if (_e1721.member == _e1063.member.member.member) {
                                                                phi_2314_ = (_e1721.member_3 < _e1063.member.member.member_3);
                                                            } else {
                                                                phi_2314_ = false;
                                                            }
                                                            let _e1736 = phi_2314_;
                                                            phi_2315_ = _e1736;
                                                        }
                                                        let _e1738 = phi_2315_;
                                                        if _e1738 {
                                                            phi_2322_ = type_33(type_28(_e1721, _e1721.member), _e1090.member_1, _e1090.member_2);
                                                        } else {
                                                            phi_2322_ = _e1090;
                                                        }
                                                        let _e1745 = phi_2322_;
                                                        phi_2323_ = _e1745;
                                                    } else {
                                                        phi_2323_ = _e1090;
                                                    }
                                                    let _e1747 = phi_2323_;
                                                    phi_2324_ = _e1747;
                                                } else {
                                                    phi_2324_ = _e1090;
                                                }
                                                let _e1749 = phi_2324_;
                                                phi_1127_ = _e1749;
                                            } else {
                                                phi_1127_ = type_33();
                                            }
                                            let _e1751 = phi_1127_;
                                            continue;
                                            continuing {
                                                phi_1126_ = _e1751;
                                                phi_1129_ = _e1078;
                                                phi_3368_ = _e633;
                                                break if !(_e1084);
                                            }
                                        }
                                        let _e1754 = phi_3368_;
                                        phi_3546_ = _e1754;
                                        if _e1754 {
                                            break;
                                        }
                                        phi_3550_ = _e1754;
                                        let _e1925 = local_12;
                                        phi_3300_ = _e1925;
                                        phi_3301_ = _e675;
                                        phi_3302_ = false;
                                        phi_3303_ = _e679;
                                    } else {
                                        let _e695 = (_e675.member_1 < _e82);
                                        if _e695 {
                                            if _e695 {
                                            } else {
                                                phi_3546_ = true;
                                                break;
                                            }
                                            let _e697 = global_4.member[_e675.member_1];
                                            phi_2346_ = _e697;
                                        } else {
                                            phi_2346_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e699 = phi_2346_;
                                        let _e714 = ((10u * _e245) & 31u);
                                        let _e717 = ((_e699.member[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e725 = bitcast<f32>((bitcast<u32>(((_e675.member.member_1[0] - _e675.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e730 = (_e675.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e717)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e734 = select(select(_e675.member.member_1[0], _e730, (_e730 < _e675.member.member_1[0])), _e675.member.member_1[0], (_e717 == 1023u));
                                        let _e736 = ((10u * _e244) & 31u);
                                        let _e739 = ((_e699.member[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e747 = bitcast<f32>((bitcast<u32>(((_e675.member.member_1[1] - _e675.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e752 = (_e675.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e739)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e756 = select(select(_e675.member.member_1[1], _e752, (_e752 < _e675.member.member_1[1])), _e675.member.member_1[1], (_e739 == 1023u));
                                        let _e758 = ((10u * _e246) & 31u);
                                        let _e761 = ((_e699.member[0] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e769 = bitcast<f32>((bitcast<u32>(((_e675.member.member_1[2] - _e675.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e774 = (_e675.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e761)) - 8388608f) * _e769)) ^ _e117)));
                                        let _e778 = select(select(_e675.member.member_1[2], _e774, (_e774 < _e675.member.member_1[2])), _e675.member.member_1[2], (_e761 == 1023u));
                                        let _e781 = ((_e699.member[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e789 = (_e675.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e781)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e793 = select(select(_e675.member.member_1[0], _e789, (_e789 < _e675.member.member_1[0])), _e675.member.member_1[0], (_e781 == 1023u));
                                        let _e796 = ((_e699.member[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e804 = (_e675.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e796)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e808 = select(select(_e675.member.member_1[1], _e804, (_e804 < _e675.member.member_1[1])), _e675.member.member_1[1], (_e796 == 1023u));
                                        let _e811 = ((_e699.member[1] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e819 = (_e675.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e811)) - 8388608f) * _e769)) ^ _e117)));
                                        let _e823 = select(select(_e675.member.member_1[2], _e819, (_e819 < _e675.member.member_1[2])), _e675.member.member_1[2], (_e811 == 1023u));
                                        let _e829 = ((_e699.member_1[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e837 = (_e675.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e829)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e841 = select(select(_e675.member.member_1[0], _e837, (_e837 < _e675.member.member_1[0])), _e675.member.member_1[0], (_e829 == 1023u));
                                        let _e844 = ((_e699.member_1[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e852 = (_e675.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e844)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e856 = select(select(_e675.member.member_1[1], _e852, (_e852 < _e675.member.member_1[1])), _e675.member.member_1[1], (_e844 == 1023u));
                                        let _e859 = ((_e699.member_1[0] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e867 = (_e675.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e859)) - 8388608f) * _e769)) ^ _e117)));
                                        let _e871 = select(select(_e675.member.member_1[2], _e867, (_e867 < _e675.member.member_1[2])), _e675.member.member_1[2], (_e859 == 1023u));
                                        let _e874 = ((_e699.member_1[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e882 = (_e675.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e874)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e886 = select(select(_e675.member.member_1[0], _e882, (_e882 < _e675.member.member_1[0])), _e675.member.member_1[0], (_e874 == 1023u));
                                        let _e889 = ((_e699.member_1[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e897 = (_e675.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e889)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e901 = select(select(_e675.member.member_1[1], _e897, (_e897 < _e675.member.member_1[1])), _e675.member.member_1[1], (_e889 == 1023u));
                                        let _e904 = ((_e699.member_1[1] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e912 = (_e675.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e904)) - 8388608f) * _e769)) ^ _e117)));
                                        let _e916 = select(select(_e675.member.member_1[2], _e912, (_e912 < _e675.member.member_1[2])), _e675.member.member_1[2], (_e904 == 1023u));
                                        let _e921 = type_50(type_42(array<f32, 3>(_e734, _e756, _e778), array<f32, 3>(_e793, _e808, _e823)), _e699.member_2);
                                        let _e926 = type_50(type_42(array<f32, 3>(_e841, _e856, _e871), array<f32, 3>(_e886, _e901, _e916)), _e699.member_3);
                                        let _e933 = ((_e734 - _e347) * _e352);
                                        let _e934 = ((_e841 - _e347) * _e352);
                                        let _e935 = ((_e793 - _e348) * _e352);
                                        let _e936 = ((_e886 - _e348) * _e352);
                                        let _e941 = ((_e756 - _e415) * _e420);
                                        let _e942 = ((_e856 - _e415) * _e420);
                                        let _e943 = ((_e808 - _e416) * _e420);
                                        let _e944 = ((_e901 - _e416) * _e420);
                                        let _e949 = ((_e778 - _e483) * _e488);
                                        let _e950 = ((_e871 - _e483) * _e488);
                                        let _e951 = ((_e823 - _e484) * _e488);
                                        let _e952 = ((_e916 - _e484) * _e488);
                                        let _e954 = select(_e951, _e949, (_e949 < _e951));
                                        let _e956 = select(_e952, _e950, (_e950 < _e952));
                                        let _e958 = select(_e951, _e949, (_e949 > _e951));
                                        let _e960 = select(_e952, _e950, (_e950 > _e952));
                                        let _e962 = select(_e935, _e933, (_e933 < _e935));
                                        let _e964 = select(_e936, _e934, (_e934 < _e936));
                                        let _e966 = select(_e943, _e941, (_e941 < _e943));
                                        let _e968 = select(_e944, _e942, (_e942 < _e944));
                                        let _e970 = select(_e966, _e962, (_e962 > _e966));
                                        let _e972 = select(_e968, _e964, (_e964 > _e968));
                                        let _e974 = select(_e954, _e970, (_e970 > _e954));
                                        let _e976 = select(_e956, _e972, (_e972 > _e956));
                                        let _e978 = select(_e935, _e933, (_e933 > _e935));
                                        let _e980 = select(_e936, _e934, (_e934 > _e936));
                                        let _e982 = select(_e943, _e941, (_e941 > _e943));
                                        let _e984 = select(_e944, _e942, (_e942 > _e944));
                                        let _e986 = select(_e982, _e978, (_e978 < _e982));
                                        let _e988 = select(_e984, _e980, (_e980 < _e984));
                                        let _e993 = -(_e954);
                                        let _e994 = -(_e956);
                                        let _e1001 = (select(_e958, _e986, (_e986 < _e958)) + (select(_e993, _e958, (_e958 > _e993)) * 0.0000019073523f));
                                        let _e1002 = (select(_e960, _e988, (_e988 < _e960)) + (select(_e994, _e960, (_e960 > _e994)) * 0.0000019073523f));
                                        let _e1004 = select(_e600, _e974, (_e974 > _e600));
                                        let _e1006 = select(_e600, _e976, (_e976 > _e600));
                                        let _e1011 = (_e1004 <= select(_e635.member.member_1, _e1001, (_e1001 < _e635.member.member_1)));
                                        let _e1012 = (_e1006 <= select(_e635.member.member_1, _e1002, (_e1002 < _e635.member.member_1)));
                                        let _e1013 = (_e1004 <= _e1006);
                                        if _e1011 {
                                            if _e1012 {
                                                if _e1013 {
                                                    phi_3202_ = _e926;
                                                } else {
                                                    phi_3202_ = _e921;
                                                }
                                                let _e1015 = phi_3202_;
                                                let _e1023 = (_e679 % 128u);
                                                let _e1024 = (_e1023 < 128u);
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local_6[_e1023] = _e1015.member_1;
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local_5[_e1023] = _e1015.member.member[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local_4[_e1023] = _e1015.member.member[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local_3[_e1023] = _e1015.member.member[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local_2[_e1023] = _e1015.member.member_1[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local_1[_e1023] = _e1015.member.member_1[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local[_e1023] = _e1015.member.member_1[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3546_ = true;
                                                    break;
                                                }
                                                local_7[_e1023] = select(_e1006, _e1004, (_e1004 > _e1006));
                                                if _e1013 {
                                                    phi_3279_ = _e921;
                                                } else {
                                                    phi_3279_ = _e926;
                                                }
                                                let _e1041 = phi_3279_;
                                                phi_3280_ = _e1041;
                                                phi_3281_ = (_e679 + 1u);
                                            } else {
                                                phi_3280_ = type_50();
                                                phi_3281_ = u32();
                                            }
                                            let _e1043 = phi_3280_;
                                            let _e1045 = phi_3281_;
                                            phi_3283_ = _e1043;
                                            phi_3284_ = _e1045;
                                            phi_3285_ = select(true, false, _e1012);
                                        } else {
                                            phi_3283_ = type_50();
                                            phi_3284_ = u32();
                                            phi_3285_ = true;
                                        }
                                        let _e1048 = phi_3283_;
                                        let _e1050 = phi_3284_;
                                        let _e1052 = phi_3285_;
                                        if _e1052 {
                                            if _e1011 {
                                                phi_3292_ = _e921;
                                            } else {
                                                phi_3292_ = _e926;
                                            }
                                            let _e1054 = phi_3292_;
                                            phi_3297_ = _e1054;
                                            phi_3298_ = select(_e1012, true, _e1011);
                                        } else {
                                            phi_3297_ = _e1048;
                                            phi_3298_ = _e677;
                                        }
                                        let _e1057 = phi_3297_;
                                        let _e1059 = phi_3298_;
                                        phi_3550_ = _e633;
                                        phi_3300_ = type_33(_e635.member, (_e635.member_1 + 1u), _e635.member_2);
                                        phi_3301_ = _e1057;
                                        phi_3302_ = _e1059;
                                        phi_3303_ = select(_e1050, _e679, _e1052);
                                    }
                                    let _e1756 = phi_3550_;
                                    let _e1758 = phi_3300_;
                                    let _e1760 = phi_3301_;
                                    let _e1762 = phi_3302_;
                                    let _e1764 = phi_3303_;
                                    phi_3549_ = _e1756;
                                    phi_3304_ = _e1758;
                                    phi_3305_ = _e1760;
                                    phi_3306_ = (_e639 - 1u);
                                    phi_3307_ = _e1762;
                                    phi_3308_ = _e1764;
                                } else {
                                    phi_3549_ = _e633;
                                    phi_3304_ = _e635;
                                    phi_3305_ = _e675;
                                    phi_3306_ = _e639;
                                    phi_3307_ = _e677;
                                    phi_3308_ = _e679;
                                }
                                let _e1766 = phi_3549_;
                                let _e1768 = phi_3304_;
                                let _e1770 = phi_3305_;
                                let _e1772 = phi_3306_;
                                let _e1774 = phi_3307_;
                                let _e1776 = phi_3308_;
                                phi_3548_ = _e1766;
                                phi_3309_ = _e1768;
                                phi_3310_ = _e1770;
                                phi_3311_ = _e1772;
                                phi_3312_ = _e1774;
                                phi_3313_ = _e1776;
                            } else {
                                phi_3548_ = _e633;
                                phi_3309_ = type_33();
                                phi_3310_ = type_50();
                                phi_3311_ = u32();
                                phi_3312_ = bool();
                                phi_3313_ = u32();
                            }
                            let _e1778 = phi_3548_;
                            let _e1780 = phi_3309_;
                            let _e1782 = phi_3310_;
                            let _e1784 = phi_3311_;
                            let _e1786 = phi_3312_;
                            let _e1788 = phi_3313_;
                            phi_3547_ = _e1778;
                            phi_1000_ = _e1780;
                            phi_1003_ = _e1782;
                            phi_1005_ = _e1784;
                            phi_1007_ = _e1786;
                            phi_1009_ = _e1788;
                            phi_3314_ = _e647;
                        } else {
                            phi_3547_ = _e633;
                            phi_1000_ = type_33();
                            phi_1003_ = type_50();
                            phi_1005_ = u32();
                            phi_1007_ = bool();
                            phi_1009_ = u32();
                            phi_3314_ = false;
                        }
                        let _e1790 = phi_3547_;
                        let _e1792 = phi_1000_;
                        let _e1794 = phi_1003_;
                        let _e1796 = phi_1005_;
                        let _e1798 = phi_1007_;
                        let _e1800 = phi_1009_;
                        let _e1802 = phi_3314_;
                        continue;
                        continuing {
                            phi_3374_ = _e1790;
                            phi_999_ = _e1792;
                            phi_1002_ = _e1794;
                            phi_1004_ = _e1796;
                            phi_1006_ = _e1798;
                            phi_1008_ = _e1800;
                            phi_3546_ = _e1790;
                            break if !(_e1802);
                        }
                    }
                    let _e1805 = phi_3546_;
                    if _e1805 {
                        break;
                    }
                    let _e1807 = local_10;
                    let _e1810 = local_11;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_5.member[_e131][0u] = _e1807.member_1;
                    global_5.member[_e131][1u] = _e1810.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
