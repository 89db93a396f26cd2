struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
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

struct type_30 {
    member: array<type_22>,
}

struct type_32 {
    member: f32,
    member_1: bool,
}

struct type_34 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_43 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_49 {
    member: type_41,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_34;
@group(0) @binding(4) 
var<storage> global_3: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_38;
@group(0) @binding(3) 
var<storage> global_6: type_45;

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
    var phi_343_: i32;
    var phi_344_: i32;
    var phi_354_: bool;
    var phi_364_: u32;
    var phi_365_: u32;
    var phi_367_: bool;
    var phi_372_: u32;
    var phi_385_: i32;
    var phi_405_: i32;
    var phi_423_: f32;
    var phi_429_: f32;
    var phi_469_: f32;
    var phi_475_: f32;
    var phi_527_: f32;
    var phi_539_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_652_: f32;
    var phi_664_: f32;
    var phi_673_: f32;
    var phi_679_: f32;
    var phi_719_: f32;
    var phi_725_: f32;
    var phi_777_: f32;
    var phi_789_: f32;
    var phi_844_: i32;
    var phi_866_: u32;
    var phi_867_: u32;
    var phi_904_: i32;
    var phi_926_: u32;
    var phi_927_: u32;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_3473_: bool;
    var phi_1019_: type_32;
    var phi_1022_: bool;
    var phi_1024_: u32;
    var phi_1026_: u32;
    var phi_1028_: type_49;
    var phi_1039_: bool;
    var phi_1125_: bool;
    var phi_1126_: u32;
    var phi_1127_: type_49;
    var phi_2414_: type_36;
    var phi_3300_: type_49;
    var phi_3377_: type_49;
    var phi_3378_: u32;
    var phi_3379_: type_49;
    var phi_3381_: u32;
    var phi_3382_: type_49;
    var phi_3383_: bool;
    var phi_3390_: type_49;
    var phi_3395_: bool;
    var phi_3397_: type_49;
    var phi_1146_: type_32;
    var phi_1149_: type_7;
    var phi_1150_: type_7;
    var phi_1172_: type_7;
    var phi_1197_: u32;
    var phi_1213_: type_43;
    var phi_1651_: bool;
    var phi_1680_: bool;
    var phi_2075_: f32;
    var phi_2076_: f32;
    var phi_2077_: f32;
    var phi_2078_: f32;
    var phi_2079_: vec3<f32>;
    var phi_2080_: vec3<f32>;
    var phi_2081_: vec3<f32>;
    var phi_2082_: vec3<f32>;
    var phi_2119_: bool;
    var phi_2128_: vec3<f32>;
    var phi_2293_: f32;
    var phi_2295_: f32;
    var phi_2296_: bool;
    var phi_2316_: f32;
    var phi_2317_: f32;
    var phi_2340_: type_21;
    var phi_2342_: type_21;
    var phi_2343_: bool;
    var phi_2347_: type_21;
    var phi_2348_: type_21;
    var phi_2349_: type_21;
    var phi_2350_: bool;
    var phi_2354_: type_21;
    var phi_2355_: bool;
    var phi_2356_: type_21;
    var phi_2357_: bool;
    var phi_2358_: bool;
    var phi_2359_: type_21;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var phi_2369_: type_21;
    var phi_2370_: bool;
    var phi_2374_: type_21;
    var phi_2385_: type_32;
    var phi_2386_: type_32;
    var phi_1147_: type_32;
    var phi_3467_: bool;
    var local_10: type_32;
    var phi_3646_: bool;
    var phi_3401_: type_32;
    var phi_3402_: bool;
    var phi_3403_: u32;
    var phi_3404_: type_49;
    var phi_3645_: bool;
    var phi_3405_: type_32;
    var phi_3406_: bool;
    var phi_3407_: u32;
    var phi_3408_: u32;
    var phi_3409_: type_49;
    var phi_3644_: bool;
    var phi_3410_: type_32;
    var phi_3411_: bool;
    var phi_3412_: u32;
    var phi_3413_: u32;
    var phi_3414_: type_49;
    var phi_3643_: bool;
    var phi_1020_: type_32;
    var phi_1023_: bool;
    var phi_1025_: u32;
    var phi_1027_: u32;
    var phi_1029_: type_49;
    var phi_3415_: bool;
    var phi_3642_: bool;
    var local_11: type_32;
    var local_12: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e82 = arrayLength((&global_5.member));
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
                let _e133 = (_e131 < arrayLength((&global_4.member)));
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
                            phi_343_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_343_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_343_;
                        phi_344_ = _e224;
                    } else {
                        phi_344_ = 0i;
                    }
                    let _e226 = phi_344_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_354_ = true;
                    } else {
                        phi_354_ = (_e150 == _e182);
                    }
                    let _e230 = phi_354_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_364_ = _e232;
                        phi_365_ = _e232;
                        phi_367_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_364_ = u32();
                        phi_365_ = 0u;
                        phi_367_ = true;
                    }
                    let _e236 = phi_364_;
                    let _e238 = phi_365_;
                    let _e240 = phi_367_;
                    if _e240 {
                        phi_372_ = (_e238 + 1u);
                    } else {
                        phi_372_ = 0u;
                    }
                    let _e244 = phi_372_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_385_ = -126i;
                    } else {
                        phi_385_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_385_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_405_ = -126i;
                    } else {
                        phi_405_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_405_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_3.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_423_ = _e283[0];
                    } else {
                        phi_423_ = _e283[1];
                    }
                    let _e288 = phi_423_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_429_ = _e283[2];
                    } else {
                        phi_429_ = _e288;
                    }
                    let _e292 = phi_429_;
                    let _e293 = bitcast<u32>(_e292);
                    let _e295 = ((_e293 & 2139095040u) != 0u);
                    let _e309 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e293 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e293 & 2147483648u))), _e292, _e295) * _e256) * select(0.00000011920929f, 1f, _e295)) * _e262);
                    let _e310 = global_3.member[_e131].member_2;
                    if _e284 {
                        phi_469_ = _e310[0];
                    } else {
                        phi_469_ = _e310[1];
                    }
                    let _e314 = phi_469_;
                    if _e289 {
                        phi_475_ = _e310[2];
                    } else {
                        phi_475_ = _e314;
                    }
                    let _e317 = phi_475_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e273) * select(0.00000011920929f, 1f, _e320)) * _e279);
                    let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e338 {
                        let _e342 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_527_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                    } else {
                        phi_527_ = 0f;
                    }
                    let _e346 = phi_527_;
                    let _e347 = (_e309 + _e346);
                    let _e348 = (_e309 - _e346);
                    let _e349 = select(_e334, 0f, _e338);
                    if _e338 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e334);
                    }
                    let _e352 = phi_539_;
                    let _e353 = (_e244 == 0u);
                    if _e353 {
                        phi_548_ = _e283[0];
                    } else {
                        phi_548_ = _e283[1];
                    }
                    let _e357 = phi_548_;
                    let _e358 = (_e244 == 2u);
                    if _e358 {
                        phi_554_ = _e283[2];
                    } else {
                        phi_554_ = _e357;
                    }
                    let _e361 = phi_554_;
                    let _e362 = bitcast<u32>(_e361);
                    let _e364 = ((_e362 & 2139095040u) != 0u);
                    let _e378 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * _e256) * select(0.00000011920929f, 1f, _e364)) * _e262);
                    if _e353 {
                        phi_594_ = _e310[0];
                    } else {
                        phi_594_ = _e310[1];
                    }
                    let _e382 = phi_594_;
                    if _e358 {
                        phi_600_ = _e310[2];
                    } else {
                        phi_600_ = _e382;
                    }
                    let _e385 = phi_600_;
                    let _e386 = bitcast<u32>(_e385);
                    let _e388 = ((_e386 & 2139095040u) != 0u);
                    let _e402 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e385, _e388) * _e273) * select(0.00000011920929f, 1f, _e388)) * _e279);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e378) & 2147483647u)) * 0.00000011920929f);
                        phi_652_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_652_ = 0f;
                    }
                    let _e414 = phi_652_;
                    let _e415 = (_e378 + _e414);
                    let _e416 = (_e378 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_664_ = 38685626000000000000000000f;
                    } else {
                        phi_664_ = (1f / _e402);
                    }
                    let _e420 = phi_664_;
                    let _e421 = (_e246 == 0u);
                    if _e421 {
                        phi_673_ = _e283[0];
                    } else {
                        phi_673_ = _e283[1];
                    }
                    let _e425 = phi_673_;
                    let _e426 = (_e246 == 2u);
                    if _e426 {
                        phi_679_ = _e283[2];
                    } else {
                        phi_679_ = _e425;
                    }
                    let _e429 = phi_679_;
                    let _e430 = bitcast<u32>(_e429);
                    let _e432 = ((_e430 & 2139095040u) != 0u);
                    let _e446 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e430 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e430 & 2147483648u))), _e429, _e432) * _e256) * select(0.00000011920929f, 1f, _e432)) * _e262);
                    if _e421 {
                        phi_719_ = _e310[0];
                    } else {
                        phi_719_ = _e310[1];
                    }
                    let _e450 = phi_719_;
                    if _e426 {
                        phi_725_ = _e310[2];
                    } else {
                        phi_725_ = _e450;
                    }
                    let _e453 = phi_725_;
                    let _e454 = bitcast<u32>(_e453);
                    let _e456 = ((_e454 & 2139095040u) != 0u);
                    let _e470 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e454 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e454 & 2147483648u))), _e453, _e456) * _e273) * select(0.00000011920929f, 1f, _e456)) * _e279);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e474 {
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) * 0.00000011920929f);
                        phi_777_ = select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f));
                    } else {
                        phi_777_ = 0f;
                    }
                    let _e482 = phi_777_;
                    let _e483 = (_e446 + _e482);
                    let _e484 = (_e446 - _e482);
                    let _e485 = select(_e470, 0f, _e474);
                    if _e474 {
                        phi_789_ = 38685626000000000000000000f;
                    } else {
                        phi_789_ = (1f / _e470);
                    }
                    let _e488 = phi_789_;
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
                            phi_844_ = 255i;
                        } else {
                            phi_844_ = (((_e515 + select(0i, 1i, (_e515 == 0i))) - _e522) + _e502);
                        }
                        let _e530 = phi_844_;
                        let _e540 = (_e530 <= 0i);
                        if _e540 {
                            phi_867_ = u32();
                        } else {
                            if _e519 {
                                phi_866_ = u32();
                            } else {
                                phi_866_ = select(((bitcast<u32>(_e530) << bitcast<u32>(23i)) | ((_e512 << bitcast<u32>(((_e522 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e530 >= 255i));
                            }
                            let _e544 = phi_866_;
                            phi_867_ = _e544;
                        }
                        let _e546 = phi_867_;
                        let _e558 = ((_e203 & 8388607u) | (select(0u, 1u, ((_e203 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e561 = bitcast<i32>((_e203 >> bitcast<u32>(23i)));
                        let _e565 = (_e558 == 0u);
                        let _e568 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e558)), 32u, _e565)) - 8i);
                        if (_e561 == 255i) {
                            phi_904_ = 255i;
                        } else {
                            phi_904_ = (((_e561 + select(0i, 1i, (_e561 == 0i))) - _e568) + _e502);
                        }
                        let _e576 = phi_904_;
                        let _e586 = (_e576 <= 0i);
                        if _e586 {
                            phi_927_ = u32();
                        } else {
                            if _e565 {
                                phi_926_ = u32();
                            } else {
                                phi_926_ = select(((bitcast<u32>(_e576) << bitcast<u32>(23i)) | ((_e558 << bitcast<u32>(((_e568 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e576 >= 255i));
                            }
                            let _e590 = phi_926_;
                            phi_927_ = _e590;
                        }
                        let _e592 = phi_927_;
                        phi_935_ = bitcast<f32>(((_e202 & 2147483648u) | select(_e592, 0u, select(_e565, true, _e586))));
                        phi_936_ = bitcast<f32>(((_e193 & 2147483648u) | select(_e546, 0u, select(_e519, true, _e540))));
                    } else {
                        phi_935_ = 0f;
                        phi_936_ = 1f;
                    }
                    let _e598 = phi_935_;
                    let _e600 = phi_936_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                    let _e605 = (_e245 % 3u);
                    let _e606 = (_e605 < 3u);
                    if _e606 {
                    } else {
                        break;
                    }
                    let _e608 = local_9[_e605];
                    let _e609 = (_e244 % 3u);
                    let _e610 = (_e609 < 3u);
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e612 = local_9[_e609];
                    let _e613 = (_e246 % 3u);
                    let _e614 = (_e613 < 3u);
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e616 = local_9[_e613];
                    local_8 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
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
                    phi_3473_ = false;
                    phi_1019_ = type_32(_e598, false);
                    phi_1022_ = (_e600 <= _e598);
                    phi_1024_ = ((3u * _e82) + 1u);
                    phi_1026_ = 0u;
                    phi_1028_ = type_49(type_41(array<f32, 3>(_e608, _e612, _e616), array<f32, 3>(_e620, _e622, _e624)), select(0u, 2147483648u, (_e82 == 0u)));
                    loop {
                        let _e632 = phi_3473_;
                        let _e634 = phi_1019_;
                        let _e636 = phi_1022_;
                        let _e638 = phi_1024_;
                        let _e640 = phi_1026_;
                        let _e642 = phi_1028_;
                        local_11 = _e634;
                        if _e636 {
                            phi_1039_ = true;
                        } else {
                            phi_1039_ = (_e640 > 0u);
                        }
                        let _e645 = phi_1039_;
                        if _e645 {
                            let _e646 = (_e638 > 0u);
                            if _e646 {
                                if _e636 {
                                    phi_1125_ = _e636;
                                    phi_1126_ = _e640;
                                    phi_1127_ = _e642;
                                } else {
                                    let _e647 = (_e640 - 1u);
                                    let _e648 = (_e647 % 128u);
                                    let _e649 = (_e648 < 128u);
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e651 = local_6[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e653 = local_5[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e655 = local_4[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e657 = local_3[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e660 = local_2[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e662 = local_1[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e664 = local[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e669 = local_7[_e648];
                                    phi_1125_ = (_e669 <= _e634.member);
                                    phi_1126_ = _e647;
                                    phi_1127_ = type_49(type_41(array<f32, 3>(_e653, _e655, _e657), array<f32, 3>(_e660, _e662, _e664)), _e651);
                                }
                                let _e673 = phi_1125_;
                                let _e675 = phi_1126_;
                                let _e677 = phi_1127_;
                                if _e673 {
                                    if ((_e677.member_1 & 2147483648u) != 0u) {
                                        phi_1146_ = _e634;
                                        phi_1149_ = type_7(0u, ((_e677.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1054 = phi_1146_;
                                            let _e1056 = phi_1149_;
                                            local_10 = _e1054;
                                            local_12 = _e1054;
                                            if (_e1056.member < _e1056.member_1) {
                                                phi_1150_ = type_7((_e1056.member + 1u), _e1056.member_1);
                                                phi_1172_ = type_7(1u, _e1056.member);
                                            } else {
                                                phi_1150_ = _e1056;
                                                phi_1172_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1069 = phi_1150_;
                                            let _e1071 = phi_1172_;
                                            let _e1075 = (bitcast<i32>(_e1071.member) != 0i);
                                            if _e1075 {
                                                let _e1076 = ((_e677.member_1 & 268435455u) + _e1071.member_1);
                                                let _e1077 = (_e1076 < arrayLength((&global_6.member)));
                                                if _e1077 {
                                                    if _e1077 {
                                                    } else {
                                                        phi_3467_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_6.member[_e1076].member_1;
                                                    phi_1197_ = _e1080;
                                                } else {
                                                    phi_1197_ = 4294967295u;
                                                }
                                                let _e1082 = phi_1197_;
                                                if _e1077 {
                                                    if _e1077 {
                                                    } else {
                                                        phi_3467_ = true;
                                                        break;
                                                    }
                                                    let _e1084 = global_6.member[_e1076];
                                                    phi_1213_ = _e1084;
                                                } else {
                                                    phi_1213_ = type_43(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1086 = phi_1213_;
                                                let _e1098 = ((10u * _e245) & 31u);
                                                let _e1101 = ((_e1086.member[0] >> bitcast<u32>(_e1098)) & 1023u);
                                                let _e1109 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                let _e1114 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1101)) - 8388608f) * _e1109)) ^ _e117)));
                                                let _e1118 = select(select(_e677.member.member_1[0], _e1114, (_e1114 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1101 == 1023u));
                                                let _e1120 = ((10u * _e244) & 31u);
                                                let _e1123 = ((_e1086.member[0] >> bitcast<u32>(_e1120)) & 1023u);
                                                let _e1131 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                let _e1136 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1123)) - 8388608f) * _e1131)) ^ _e117)));
                                                let _e1140 = select(select(_e677.member.member_1[1], _e1136, (_e1136 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1123 == 1023u));
                                                let _e1142 = ((10u * _e246) & 31u);
                                                let _e1145 = ((_e1086.member[0] >> bitcast<u32>(_e1142)) & 1023u);
                                                let _e1153 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                let _e1158 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1145)) - 8388608f) * _e1153)) ^ _e117)));
                                                let _e1162 = select(select(_e677.member.member_1[2], _e1158, (_e1158 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1145 == 1023u));
                                                let _e1166 = ((_e1086.member[1] >> bitcast<u32>(_e1098)) & 1023u);
                                                let _e1174 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1166)) - 8388608f) * _e1109)) ^ _e117)));
                                                let _e1178 = select(select(_e677.member.member_1[0], _e1174, (_e1174 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1166 == 1023u));
                                                let _e1181 = ((_e1086.member[1] >> bitcast<u32>(_e1120)) & 1023u);
                                                let _e1189 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1181)) - 8388608f) * _e1131)) ^ _e117)));
                                                let _e1193 = select(select(_e677.member.member_1[1], _e1189, (_e1189 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1181 == 1023u));
                                                let _e1196 = ((_e1086.member[1] >> bitcast<u32>(_e1142)) & 1023u);
                                                let _e1204 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1196)) - 8388608f) * _e1153)) ^ _e117)));
                                                let _e1208 = select(select(_e677.member.member_1[2], _e1204, (_e1204 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1196 == 1023u));
                                                let _e1212 = ((_e1086.member[2] >> bitcast<u32>(_e1098)) & 1023u);
                                                let _e1220 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1212)) - 8388608f) * _e1109)) ^ _e117)));
                                                let _e1224 = select(select(_e677.member.member_1[0], _e1220, (_e1220 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1212 == 1023u));
                                                let _e1227 = ((_e1086.member[2] >> bitcast<u32>(_e1120)) & 1023u);
                                                let _e1235 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1227)) - 8388608f) * _e1131)) ^ _e117)));
                                                let _e1239 = select(select(_e677.member.member_1[1], _e1235, (_e1235 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1227 == 1023u));
                                                let _e1242 = ((_e1086.member[2] >> bitcast<u32>(_e1142)) & 1023u);
                                                let _e1250 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1242)) - 8388608f) * _e1153)) ^ _e117)));
                                                let _e1254 = select(select(_e677.member.member_1[2], _e1250, (_e1250 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1242 == 1023u));
                                                let _e1258 = (_e1162 - _e446);
                                                let _e1261 = (((_e1118 - _e309) * _e485) - (_e1258 * _e349));
                                                let _e1264 = (((_e1140 - _e378) * _e485) - (_e1258 * _e417));
                                                let _e1267 = (_e1208 - _e446);
                                                let _e1270 = (((_e1178 - _e309) * _e485) - (_e1267 * _e349));
                                                let _e1273 = (((_e1193 - _e378) * _e485) - (_e1267 * _e417));
                                                let _e1276 = (_e1254 - _e446);
                                                let _e1279 = (((_e1224 - _e309) * _e485) - (_e1276 * _e349));
                                                let _e1282 = (((_e1239 - _e378) * _e485) - (_e1276 * _e417));
                                                let _e1283 = (_e1279 * _e1273);
                                                let _e1284 = (_e1282 * _e1270);
                                                let _e1285 = (_e1261 * _e1282);
                                                let _e1286 = (_e1264 * _e1279);
                                                let _e1287 = (_e1270 * _e1264);
                                                let _e1288 = (_e1273 * _e1261);
                                                let _e1293 = (((_e1283 >= _e1284) && (_e1285 >= _e1286)) && (_e1287 >= _e1288));
                                                if (_e1293 || (((_e1283 <= _e1284) && (_e1285 <= _e1286)) && (_e1287 <= _e1288))) {
                                                    let _e1300 = select(-1f, 1f, _e1293);
                                                    let _e1302 = ((_e1283 - _e1284) * _e1300);
                                                    let _e1304 = select(0f, _e1302, (_e1302 > 0f));
                                                    let _e1306 = ((_e1285 - _e1286) * _e1300);
                                                    let _e1308 = select(0f, _e1306, (_e1306 > 0f));
                                                    let _e1310 = ((_e1287 - _e1288) * _e1300);
                                                    let _e1312 = select(0f, _e1310, (_e1310 > 0f));
                                                    let _e1314 = ((_e1304 + _e1308) + _e1312);
                                                    if (_e1314 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2359_ = type_21();
                                                        phi_2360_ = true;
                                                        phi_2361_ = false;
                                                    } else {
                                                        let _e1317 = select(_e1270, _e1261, (_e1261 < _e1270));
                                                        if (select(_e1279, _e1317, (_e1317 < _e1279)) > 0f) {
                                                            phi_1651_ = true;
                                                        } else {
                                                            let _e1322 = select(_e1270, _e1261, (_e1261 > _e1270));
                                                            phi_1651_ = (select(_e1279, _e1322, (_e1322 > _e1279)) < 0f);
                                                        }
                                                        let _e1327 = phi_1651_;
                                                        if _e1327 {
                                                            phi_2356_ = type_21();
                                                            phi_2357_ = true;
                                                            phi_2358_ = false;
                                                        } else {
                                                            let _e1329 = select(_e1273, _e1264, (_e1264 < _e1273));
                                                            if (select(_e1282, _e1329, (_e1329 < _e1282)) > 0f) {
                                                                phi_1680_ = true;
                                                            } else {
                                                                let _e1334 = select(_e1273, _e1264, (_e1264 > _e1273));
                                                                phi_1680_ = (select(_e1282, _e1334, (_e1334 > _e1282)) < 0f);
                                                            }
                                                            let _e1339 = phi_1680_;
                                                            if _e1339 {
                                                                phi_2354_ = type_21();
                                                                phi_2355_ = false;
                                                            } else {
                                                                let _e1341 = select(_e1178, _e1118, (_e1118 < _e1178));
                                                                let _e1345 = select(_e1178, _e1118, (_e1118 > _e1178));
                                                                let _e1349 = select(_e1193, _e1140, (_e1140 < _e1193));
                                                                let _e1353 = select(_e1193, _e1140, (_e1140 > _e1193));
                                                                let _e1357 = select(_e1208, _e1162, (_e1162 < _e1208));
                                                                let _e1361 = select(_e1208, _e1162, (_e1162 > _e1208));
                                                                let _e1366 = ((select(_e1224, _e1341, (_e1341 < _e1224)) - _e347) * _e352);
                                                                let _e1367 = ((select(_e1224, _e1345, (_e1345 > _e1224)) - _e348) * _e352);
                                                                let _e1370 = ((select(_e1239, _e1349, (_e1349 < _e1239)) - _e415) * _e420);
                                                                let _e1371 = ((select(_e1239, _e1353, (_e1353 > _e1239)) - _e416) * _e420);
                                                                let _e1374 = ((select(_e1254, _e1357, (_e1357 < _e1254)) - _e483) * _e488);
                                                                let _e1375 = ((select(_e1254, _e1361, (_e1361 > _e1254)) - _e484) * _e488);
                                                                let _e1377 = select(_e1375, _e1374, (_e1374 < _e1375));
                                                                let _e1379 = select(_e1375, _e1374, (_e1374 > _e1375));
                                                                let _e1381 = select(_e1367, _e1366, (_e1366 < _e1367));
                                                                let _e1383 = select(_e1371, _e1370, (_e1370 < _e1371));
                                                                let _e1385 = select(_e1383, _e1381, (_e1381 > _e1383));
                                                                let _e1387 = select(_e1377, _e1385, (_e1385 > _e1377));
                                                                let _e1389 = select(_e1367, _e1366, (_e1366 > _e1367));
                                                                let _e1391 = select(_e1371, _e1370, (_e1370 > _e1371));
                                                                let _e1393 = select(_e1391, _e1389, (_e1389 < _e1391));
                                                                let _e1395 = select(_e1379, _e1393, (_e1393 < _e1379));
                                                                let _e1396 = -(_e1377);
                                                                let _e1402 = select(_e600, _e1387, (_e1387 > _e600));
                                                                if (_e1402 > (_e1395 + (select(_e1396, _e1379, (_e1379 > _e1396)) * 0.0000019073523f))) {
                                                                    phi_2349_ = type_21();
                                                                    phi_2350_ = true;
                                                                } else {
                                                                    let _e1404 = (_e1402 > _e1054.member);
                                                                    if _e1404 {
                                                                        phi_2348_ = type_21();
                                                                    } else {
                                                                        let _e1405 = vec3<f32>(_e1118, _e1140, _e1162);
                                                                        let _e1406 = vec3<f32>(_e1178, _e1193, _e1208);
                                                                        let _e1407 = vec3<f32>(_e1224, _e1239, _e1254);
                                                                        let _e1408 = (_e1178 - _e1118);
                                                                        let _e1409 = (_e1193 - _e1140);
                                                                        let _e1410 = (_e1208 - _e1162);
                                                                        let _e1411 = vec3<f32>(_e1408, _e1409, _e1410);
                                                                        let _e1412 = (_e1224 - _e1178);
                                                                        let _e1413 = (_e1239 - _e1193);
                                                                        let _e1414 = (_e1254 - _e1208);
                                                                        let _e1415 = vec3<f32>(_e1412, _e1413, _e1414);
                                                                        let _e1416 = (_e1118 - _e1224);
                                                                        let _e1417 = (_e1140 - _e1239);
                                                                        let _e1418 = (_e1162 - _e1254);
                                                                        let _e1419 = vec3<f32>(_e1416, _e1417, _e1418);
                                                                        let _e1422 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                                        let _e1425 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                                        let _e1427 = select(_e1425, _e1422, (_e1422 > _e1425));
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                                        let _e1432 = select(_e1430, _e1427, (_e1427 > _e1430));
                                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                                        let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                        let _e1443 = bitcast<f32>((bitcast<u32>(_e1414) & 2147483647u));
                                                                        let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                        let _e1456 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                        let _e1458 = select(_e1456, _e1453, (_e1453 > _e1456));
                                                                        let _e1460 = select(_e1445, _e1432, (_e1432 > _e1445));
                                                                        let _e1462 = select(_e1458, _e1460, (_e1460 > _e1458));
                                                                        if (_e1432 == _e1462) {
                                                                            phi_2075_ = _e1273;
                                                                            phi_2076_ = _e1270;
                                                                            phi_2077_ = _e1264;
                                                                            phi_2078_ = _e1261;
                                                                            phi_2079_ = _e1405;
                                                                            phi_2080_ = _e1419;
                                                                            phi_2081_ = _e1415;
                                                                            phi_2082_ = _e1411;
                                                                        } else {
                                                                            let _e1464 = (_e1445 == _e1462);
                                                                            let _e1469 = vec3(_e1464);
                                                                            phi_2075_ = select(_e1264, _e1282, _e1464);
                                                                            phi_2076_ = select(_e1261, _e1279, _e1464);
                                                                            phi_2077_ = select(_e1282, _e1273, _e1464);
                                                                            phi_2078_ = select(_e1279, _e1270, _e1464);
                                                                            phi_2079_ = select(_e1407, _e1406, _e1469);
                                                                            phi_2080_ = select(_e1415, _e1411, _e1469);
                                                                            phi_2081_ = select(_e1411, _e1419, _e1469);
                                                                            phi_2082_ = select(_e1419, _e1415, _e1469);
                                                                        }
                                                                        let _e1475 = phi_2075_;
                                                                        let _e1477 = phi_2076_;
                                                                        let _e1479 = phi_2077_;
                                                                        let _e1481 = phi_2078_;
                                                                        let _e1483 = phi_2079_;
                                                                        let _e1485 = phi_2080_;
                                                                        let _e1487 = phi_2081_;
                                                                        let _e1489 = phi_2082_;
                                                                        let _e1496 = ((_e1487.y * _e1485.z) - (_e1485.y * _e1487.z));
                                                                        let _e1501 = ((_e1487.z * _e1485.x) - (_e1485.z * _e1487.x));
                                                                        let _e1504 = ((_e1487.x * _e1485.y) - (_e1485.x * _e1487.y));
                                                                        if (_e1304 >= _e1308) {
                                                                            phi_2119_ = select(true, false, (_e1304 >= _e1312));
                                                                        } else {
                                                                            phi_2119_ = true;
                                                                        }
                                                                        let _e1509 = phi_2119_;
                                                                        if _e1509 {
                                                                            phi_2128_ = select(_e1407, _e1406, vec3((_e1308 >= _e1312)));
                                                                        } else {
                                                                            phi_2128_ = _e1405;
                                                                        }
                                                                        let _e1514 = phi_2128_;
                                                                        let _e1525 = (((_e1496 * (_e1514.x - _e309)) + (_e1501 * (_e1514.y - _e378))) + (_e1504 * (_e1514.z - _e446)));
                                                                        let _e1530 = (((_e1496 * _e349) + (_e1501 * _e417)) + (_e1504 * _e485));
                                                                        let _e1531 = (_e1477 - _e1481);
                                                                        let _e1532 = (_e1475 - _e1479);
                                                                        let _e1540 = (-(((_e1481 * _e1531) + (_e1479 * _e1532))) / ((_e1531 * _e1531) + (_e1532 * _e1532)));
                                                                        let _e1542 = select(1f, _e1540, (_e1540 < 1f));
                                                                        let _e1544 = select(0f, _e1542, (_e1542 > 0f));
                                                                        let _e1557 = ((_e1483.x + (_e1489.x * _e1544)) - _e309);
                                                                        let _e1558 = ((_e1483.y + (_e1489.y * _e1544)) - _e378);
                                                                        let _e1559 = ((_e1483.z + (_e1489.z * _e1544)) - _e446);
                                                                        let _e1560 = (_e1559 / _e485);
                                                                        let _e1572 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                                        let _e1575 = bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u));
                                                                        let _e1577 = select(_e1575, _e1572, (_e1572 > _e1575));
                                                                        let _e1580 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                        let _e1582 = select(_e1580, _e1577, (_e1577 > _e1580));
                                                                        let _e1588 = bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u));
                                                                        let _e1591 = bitcast<f32>((bitcast<u32>(_e1501) & 2147483647u));
                                                                        let _e1593 = select(_e1591, _e1588, (_e1588 > _e1591));
                                                                        let _e1596 = bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1496 * _e1557) + (_e1501 * _e1558)) + (_e1504 * _e1559)) - _e1525)) & 2147483647u)) <= ((0.0000009536743f * select(_e1462, _e1582, (_e1582 > _e1462))) * select(_e1596, _e1593, (_e1593 > _e1596)))) {
                                                                            let _e1606 = bitcast<f32>((bitcast<u32>(_e1487.x) & 2147483647u));
                                                                            let _e1609 = bitcast<f32>((bitcast<u32>(_e1487.y) & 2147483647u));
                                                                            let _e1611 = select(_e1609, _e1606, (_e1606 > _e1609));
                                                                            let _e1614 = bitcast<f32>((bitcast<u32>(_e1487.z) & 2147483647u));
                                                                            let _e1620 = bitcast<f32>((bitcast<u32>(_e1485.x) & 2147483647u));
                                                                            let _e1623 = bitcast<f32>((bitcast<u32>(_e1485.y) & 2147483647u));
                                                                            let _e1625 = select(_e1623, _e1620, (_e1620 > _e1623));
                                                                            let _e1628 = bitcast<f32>((bitcast<u32>(_e1485.z) & 2147483647u));
                                                                            let _e1632 = (bitcast<f32>((bitcast<u32>(_e1530) & 2147483647u)) > ((0.0000038146973f * select(_e1614, _e1611, (_e1611 > _e1614))) * select(_e1628, _e1625, (_e1625 > _e1628))));
                                                                            if _e1632 {
                                                                                phi_2293_ = (_e1525 / _e1530);
                                                                            } else {
                                                                                phi_2293_ = f32();
                                                                            }
                                                                            let _e1635 = phi_2293_;
                                                                            phi_2295_ = _e1635;
                                                                            phi_2296_ = select(true, false, _e1632);
                                                                        } else {
                                                                            phi_2295_ = f32();
                                                                            phi_2296_ = true;
                                                                        }
                                                                        let _e1638 = phi_2295_;
                                                                        let _e1640 = phi_2296_;
                                                                        if _e1640 {
                                                                            let _e1648 = (((_e1496 * (_e1557 - (_e349 * _e1560))) + (_e1501 * (_e1558 - (_e417 * _e1560)))) / _e1530);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1648) & 2147483647u)) <= _e1462) {
                                                                                phi_2316_ = (_e1560 + _e1648);
                                                                            } else {
                                                                                phi_2316_ = _e1560;
                                                                            }
                                                                            let _e1655 = phi_2316_;
                                                                            phi_2317_ = _e1655;
                                                                        } else {
                                                                            phi_2317_ = _e1638;
                                                                        }
                                                                        let _e1657 = phi_2317_;
                                                                        let _e1659 = select(_e1395, _e1657, (_e1657 < _e1395));
                                                                        let _e1661 = select(_e1387, _e1659, (_e1659 > _e1387));
                                                                        if (_e1661 >= _e600) {
                                                                            let _e1663 = (_e1661 <= _e1054.member);
                                                                            if _e1663 {
                                                                                let _e1664 = (1f / _e1314);
                                                                                phi_2340_ = type_21(_e1661, (_e1308 * _e1664), (_e1312 * _e1664), _e1082);
                                                                            } else {
                                                                                phi_2340_ = type_21();
                                                                            }
                                                                            let _e1669 = phi_2340_;
                                                                            phi_2342_ = _e1669;
                                                                            phi_2343_ = select(true, false, _e1663);
                                                                        } else {
                                                                            phi_2342_ = type_21();
                                                                            phi_2343_ = true;
                                                                        }
                                                                        let _e1672 = phi_2342_;
                                                                        let _e1674 = phi_2343_;
                                                                        if _e1674 {
                                                                            phi_2347_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2347_ = _e1672;
                                                                        }
                                                                        let _e1676 = phi_2347_;
                                                                        phi_2348_ = _e1676;
                                                                    }
                                                                    let _e1678 = phi_2348_;
                                                                    phi_2349_ = _e1678;
                                                                    phi_2350_ = _e1404;
                                                                }
                                                                let _e1680 = phi_2349_;
                                                                let _e1682 = phi_2350_;
                                                                phi_2354_ = _e1680;
                                                                phi_2355_ = _e1682;
                                                            }
                                                            let _e1684 = phi_2354_;
                                                            let _e1686 = phi_2355_;
                                                            phi_2356_ = _e1684;
                                                            phi_2357_ = _e1339;
                                                            phi_2358_ = _e1686;
                                                        }
                                                        let _e1688 = phi_2356_;
                                                        let _e1690 = phi_2357_;
                                                        let _e1692 = phi_2358_;
                                                        phi_2359_ = _e1688;
                                                        phi_2360_ = _e1690;
                                                        phi_2361_ = _e1692;
                                                    }
                                                    let _e1694 = phi_2359_;
                                                    let _e1696 = phi_2360_;
                                                    let _e1698 = phi_2361_;
                                                    phi_2369_ = _e1694;
                                                    phi_2370_ = select(_e1698, true, _e1696);
                                                } else {
                                                    phi_2369_ = type_21();
                                                    phi_2370_ = true;
                                                }
                                                let _e1701 = phi_2369_;
                                                let _e1703 = phi_2370_;
                                                if _e1703 {
                                                    phi_2374_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2374_ = _e1701;
                                                }
                                                let _e1705 = phi_2374_;
                                                if (_e1705.member_3 != 4294967295u) {
                                                    if (_e1082 != 4294967295u) {
                                                        phi_2385_ = type_32(_e1054.member, true);
                                                    } else {
                                                        phi_2385_ = _e1054;
                                                    }
                                                    let _e1713 = phi_2385_;
                                                    phi_2386_ = _e1713;
                                                } else {
                                                    phi_2386_ = _e1054;
                                                }
                                                let _e1715 = phi_2386_;
                                                phi_1147_ = _e1715;
                                            } else {
                                                phi_1147_ = type_32();
                                            }
                                            let _e1717 = phi_1147_;
                                            continue;
                                            continuing {
                                                phi_1146_ = _e1717;
                                                phi_1149_ = _e1069;
                                                phi_3467_ = _e632;
                                                break if !(_e1075);
                                            }
                                        }
                                        let _e1720 = phi_3467_;
                                        phi_3642_ = _e1720;
                                        if _e1720 {
                                            break;
                                        }
                                        let _e1722 = local_10;
                                        phi_3646_ = _e1720;
                                        let _e1887 = local_12;
                                        phi_3401_ = _e1887;
                                        phi_3402_ = false;
                                        phi_3403_ = select(_e675, 0u, _e1722.member_1);
                                        phi_3404_ = _e677;
                                    } else {
                                        let _e687 = (_e677.member_1 < _e82);
                                        if _e687 {
                                            if _e687 {
                                            } else {
                                                phi_3642_ = true;
                                                break;
                                            }
                                            let _e689 = global_5.member[_e677.member_1];
                                            phi_2414_ = _e689;
                                        } else {
                                            phi_2414_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e691 = phi_2414_;
                                        let _e706 = ((10u * _e245) & 31u);
                                        let _e709 = ((_e691.member[0] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e717 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e722 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e709)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e726 = select(select(_e677.member.member_1[0], _e722, (_e722 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e709 == 1023u));
                                        let _e728 = ((10u * _e244) & 31u);
                                        let _e731 = ((_e691.member[0] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e739 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e744 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e731)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e748 = select(select(_e677.member.member_1[1], _e744, (_e744 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e731 == 1023u));
                                        let _e750 = ((10u * _e246) & 31u);
                                        let _e753 = ((_e691.member[0] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e761 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e766 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e753)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e770 = select(select(_e677.member.member_1[2], _e766, (_e766 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e753 == 1023u));
                                        let _e773 = ((_e691.member[1] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e781 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e773)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e785 = select(select(_e677.member.member_1[0], _e781, (_e781 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e773 == 1023u));
                                        let _e788 = ((_e691.member[1] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e796 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e800 = select(select(_e677.member.member_1[1], _e796, (_e796 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e788 == 1023u));
                                        let _e803 = ((_e691.member[1] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e811 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e803)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e815 = select(select(_e677.member.member_1[2], _e811, (_e811 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e803 == 1023u));
                                        let _e821 = ((_e691.member_1[0] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e829 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e821)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e833 = select(select(_e677.member.member_1[0], _e829, (_e829 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e821 == 1023u));
                                        let _e836 = ((_e691.member_1[0] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e844 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e836)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e848 = select(select(_e677.member.member_1[1], _e844, (_e844 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e836 == 1023u));
                                        let _e851 = ((_e691.member_1[0] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e859 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e851)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e863 = select(select(_e677.member.member_1[2], _e859, (_e859 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e851 == 1023u));
                                        let _e866 = ((_e691.member_1[1] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e874 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e866)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e878 = select(select(_e677.member.member_1[0], _e874, (_e874 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e866 == 1023u));
                                        let _e881 = ((_e691.member_1[1] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e889 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e893 = select(select(_e677.member.member_1[1], _e889, (_e889 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e881 == 1023u));
                                        let _e896 = ((_e691.member_1[1] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e904 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e908 = select(select(_e677.member.member_1[2], _e904, (_e904 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e896 == 1023u));
                                        let _e913 = type_49(type_41(array<f32, 3>(_e726, _e748, _e770), array<f32, 3>(_e785, _e800, _e815)), _e691.member_2);
                                        let _e918 = type_49(type_41(array<f32, 3>(_e833, _e848, _e863), array<f32, 3>(_e878, _e893, _e908)), _e691.member_3);
                                        let _e924 = ((_e726 - _e347) * _e352);
                                        let _e925 = ((_e833 - _e347) * _e352);
                                        let _e926 = ((_e785 - _e348) * _e352);
                                        let _e927 = ((_e878 - _e348) * _e352);
                                        let _e932 = ((_e748 - _e415) * _e420);
                                        let _e933 = ((_e848 - _e415) * _e420);
                                        let _e934 = ((_e800 - _e416) * _e420);
                                        let _e935 = ((_e893 - _e416) * _e420);
                                        let _e940 = ((_e770 - _e483) * _e488);
                                        let _e941 = ((_e863 - _e483) * _e488);
                                        let _e942 = ((_e815 - _e484) * _e488);
                                        let _e943 = ((_e908 - _e484) * _e488);
                                        let _e945 = select(_e942, _e940, (_e940 < _e942));
                                        let _e947 = select(_e943, _e941, (_e941 < _e943));
                                        let _e949 = select(_e942, _e940, (_e940 > _e942));
                                        let _e951 = select(_e943, _e941, (_e941 > _e943));
                                        let _e953 = select(_e926, _e924, (_e924 < _e926));
                                        let _e955 = select(_e927, _e925, (_e925 < _e927));
                                        let _e957 = select(_e934, _e932, (_e932 < _e934));
                                        let _e959 = select(_e935, _e933, (_e933 < _e935));
                                        let _e961 = select(_e957, _e953, (_e953 > _e957));
                                        let _e963 = select(_e959, _e955, (_e955 > _e959));
                                        let _e965 = select(_e945, _e961, (_e961 > _e945));
                                        let _e967 = select(_e947, _e963, (_e963 > _e947));
                                        let _e969 = select(_e926, _e924, (_e924 > _e926));
                                        let _e971 = select(_e927, _e925, (_e925 > _e927));
                                        let _e973 = select(_e934, _e932, (_e932 > _e934));
                                        let _e975 = select(_e935, _e933, (_e933 > _e935));
                                        let _e977 = select(_e973, _e969, (_e969 < _e973));
                                        let _e979 = select(_e975, _e971, (_e971 < _e975));
                                        let _e984 = -(_e945);
                                        let _e985 = -(_e947);
                                        let _e992 = (select(_e949, _e977, (_e977 < _e949)) + (select(_e984, _e949, (_e949 > _e984)) * 0.0000019073523f));
                                        let _e993 = (select(_e951, _e979, (_e979 < _e951)) + (select(_e985, _e951, (_e951 > _e985)) * 0.0000019073523f));
                                        let _e995 = select(_e600, _e965, (_e965 > _e600));
                                        let _e997 = select(_e600, _e967, (_e967 > _e600));
                                        let _e1002 = (_e995 <= select(_e634.member, _e992, (_e992 < _e634.member)));
                                        let _e1003 = (_e997 <= select(_e634.member, _e993, (_e993 < _e634.member)));
                                        let _e1004 = (_e995 <= _e997);
                                        if _e1002 {
                                            if _e1003 {
                                                if _e1004 {
                                                    phi_3300_ = _e918;
                                                } else {
                                                    phi_3300_ = _e913;
                                                }
                                                let _e1006 = phi_3300_;
                                                let _e1014 = (_e675 % 128u);
                                                let _e1015 = (_e1014 < 128u);
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local_6[_e1014] = _e1006.member_1;
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local_5[_e1014] = _e1006.member.member[0];
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local_4[_e1014] = _e1006.member.member[1];
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local_3[_e1014] = _e1006.member.member[2];
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local_2[_e1014] = _e1006.member.member_1[0];
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local_1[_e1014] = _e1006.member.member_1[1];
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local[_e1014] = _e1006.member.member_1[2];
                                                if _e1015 {
                                                } else {
                                                    phi_3642_ = true;
                                                    break;
                                                }
                                                local_7[_e1014] = select(_e997, _e995, !(_e1004));
                                                if _e1004 {
                                                    phi_3377_ = _e913;
                                                } else {
                                                    phi_3377_ = _e918;
                                                }
                                                let _e1032 = phi_3377_;
                                                phi_3378_ = (_e675 + 1u);
                                                phi_3379_ = _e1032;
                                            } else {
                                                phi_3378_ = u32();
                                                phi_3379_ = type_49();
                                            }
                                            let _e1034 = phi_3378_;
                                            let _e1036 = phi_3379_;
                                            phi_3381_ = _e1034;
                                            phi_3382_ = _e1036;
                                            phi_3383_ = select(true, false, _e1003);
                                        } else {
                                            phi_3381_ = u32();
                                            phi_3382_ = type_49();
                                            phi_3383_ = true;
                                        }
                                        let _e1039 = phi_3381_;
                                        let _e1041 = phi_3382_;
                                        let _e1043 = phi_3383_;
                                        if _e1043 {
                                            if _e1002 {
                                                phi_3390_ = _e913;
                                            } else {
                                                phi_3390_ = _e918;
                                            }
                                            let _e1045 = phi_3390_;
                                            phi_3395_ = select(_e1003, true, _e1002);
                                            phi_3397_ = _e1045;
                                        } else {
                                            phi_3395_ = _e673;
                                            phi_3397_ = _e1041;
                                        }
                                        let _e1048 = phi_3395_;
                                        let _e1050 = phi_3397_;
                                        phi_3646_ = _e632;
                                        phi_3401_ = _e634;
                                        phi_3402_ = _e1048;
                                        phi_3403_ = select(_e1039, _e675, _e1043);
                                        phi_3404_ = _e1050;
                                    }
                                    let _e1726 = phi_3646_;
                                    let _e1728 = phi_3401_;
                                    let _e1730 = phi_3402_;
                                    let _e1732 = phi_3403_;
                                    let _e1734 = phi_3404_;
                                    phi_3645_ = _e1726;
                                    phi_3405_ = _e1728;
                                    phi_3406_ = _e1730;
                                    phi_3407_ = (_e638 - 1u);
                                    phi_3408_ = _e1732;
                                    phi_3409_ = _e1734;
                                } else {
                                    phi_3645_ = _e632;
                                    phi_3405_ = _e634;
                                    phi_3406_ = _e673;
                                    phi_3407_ = _e638;
                                    phi_3408_ = _e675;
                                    phi_3409_ = _e677;
                                }
                                let _e1736 = phi_3645_;
                                let _e1738 = phi_3405_;
                                let _e1740 = phi_3406_;
                                let _e1742 = phi_3407_;
                                let _e1744 = phi_3408_;
                                let _e1746 = phi_3409_;
                                phi_3644_ = _e1736;
                                phi_3410_ = _e1738;
                                phi_3411_ = _e1740;
                                phi_3412_ = _e1742;
                                phi_3413_ = _e1744;
                                phi_3414_ = _e1746;
                            } else {
                                phi_3644_ = _e632;
                                phi_3410_ = type_32();
                                phi_3411_ = bool();
                                phi_3412_ = u32();
                                phi_3413_ = u32();
                                phi_3414_ = type_49();
                            }
                            let _e1748 = phi_3644_;
                            let _e1750 = phi_3410_;
                            let _e1752 = phi_3411_;
                            let _e1754 = phi_3412_;
                            let _e1756 = phi_3413_;
                            let _e1758 = phi_3414_;
                            phi_3643_ = _e1748;
                            phi_1020_ = _e1750;
                            phi_1023_ = _e1752;
                            phi_1025_ = _e1754;
                            phi_1027_ = _e1756;
                            phi_1029_ = _e1758;
                            phi_3415_ = _e646;
                        } else {
                            phi_3643_ = _e632;
                            phi_1020_ = type_32();
                            phi_1023_ = bool();
                            phi_1025_ = u32();
                            phi_1027_ = u32();
                            phi_1029_ = type_49();
                            phi_3415_ = false;
                        }
                        let _e1760 = phi_3643_;
                        let _e1762 = phi_1020_;
                        let _e1764 = phi_1023_;
                        let _e1766 = phi_1025_;
                        let _e1768 = phi_1027_;
                        let _e1770 = phi_1029_;
                        let _e1772 = phi_3415_;
                        continue;
                        continuing {
                            phi_3473_ = _e1760;
                            phi_1019_ = _e1762;
                            phi_1022_ = _e1764;
                            phi_1024_ = _e1766;
                            phi_1026_ = _e1768;
                            phi_1028_ = _e1770;
                            phi_3642_ = _e1760;
                            break if !(_e1772);
                        }
                    }
                    let _e1775 = phi_3642_;
                    if _e1775 {
                        break;
                    }
                    let _e1777 = local_11;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_4.member[_e131] = select(0u, 1u, _e1777.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
