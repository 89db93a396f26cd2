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
    var phi_3476_: bool;
    var phi_1019_: type_32;
    var phi_1022_: u32;
    var phi_1024_: bool;
    var phi_1026_: u32;
    var phi_1028_: type_49;
    var phi_1039_: bool;
    var phi_1125_: bool;
    var phi_1126_: u32;
    var phi_1127_: type_49;
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
    var phi_3470_: bool;
    var phi_3704_: bool;
    var phi_2387_: type_32;
    var phi_2408_: type_36;
    var phi_3294_: type_49;
    var phi_3370_: type_49;
    var phi_3371_: u32;
    var phi_3372_: type_49;
    var phi_3374_: u32;
    var phi_3375_: type_49;
    var phi_3376_: bool;
    var phi_3383_: type_49;
    var phi_3388_: bool;
    var phi_3390_: type_49;
    var phi_3394_: bool;
    var phi_3395_: u32;
    var phi_3396_: type_49;
    var phi_3406_: u32;
    var phi_3407_: type_49;
    var phi_3648_: bool;
    var phi_3408_: type_32;
    var phi_3409_: u32;
    var phi_3410_: bool;
    var phi_3411_: u32;
    var phi_3412_: type_49;
    var phi_3647_: bool;
    var phi_3413_: type_32;
    var phi_3414_: u32;
    var phi_3415_: bool;
    var phi_3416_: u32;
    var phi_3417_: type_49;
    var phi_3646_: bool;
    var phi_1020_: type_32;
    var phi_1023_: u32;
    var phi_1025_: bool;
    var phi_1027_: u32;
    var phi_1029_: type_49;
    var phi_3418_: bool;
    var phi_3645_: bool;
    var local_10: type_32;
    var local_11: type_32;

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
                    phi_3476_ = false;
                    phi_1019_ = type_32(_e598, false);
                    phi_1022_ = ((3u * _e82) + 1u);
                    phi_1024_ = (_e600 <= _e598);
                    phi_1026_ = 0u;
                    phi_1028_ = type_49(type_41(array<f32, 3>(_e608, _e612, _e616), array<f32, 3>(_e620, _e622, _e624)), select(0u, 2147483648u, (_e82 == 0u)));
                    loop {
                        let _e632 = phi_3476_;
                        let _e634 = phi_1019_;
                        let _e636 = phi_1022_;
                        let _e638 = phi_1024_;
                        let _e640 = phi_1026_;
                        let _e642 = phi_1028_;
                        local_10 = _e634;
                        if _e638 {
                            phi_1039_ = true;
                        } else {
                            phi_1039_ = (_e640 > 0u);
                        }
                        let _e645 = phi_1039_;
                        if _e645 {
                            let _e646 = (_e636 > 0u);
                            if _e646 {
                                if _e638 {
                                    phi_1125_ = _e638;
                                    phi_1126_ = _e640;
                                    phi_1127_ = _e642;
                                } else {
                                    let _e647 = (_e640 - 1u);
                                    let _e648 = (_e647 % 128u);
                                    let _e649 = (_e648 < 128u);
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
                                        break;
                                    }
                                    let _e651 = local_6[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
                                        break;
                                    }
                                    let _e653 = local_5[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
                                        break;
                                    }
                                    let _e655 = local_4[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
                                        break;
                                    }
                                    let _e657 = local_3[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
                                        break;
                                    }
                                    let _e660 = local_2[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
                                        break;
                                    }
                                    let _e662 = local_1[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
                                        break;
                                    }
                                    let _e664 = local[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3645_ = true;
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
                                    let _e681 = ((_e677.member_1 & 2147483648u) != 0u);
                                    if _e681 {
                                        phi_1146_ = _e634;
                                        phi_1149_ = type_7(0u, ((_e677.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e689 = phi_1146_;
                                            let _e691 = phi_1149_;
                                            local_11 = _e689;
                                            if (_e691.member < _e691.member_1) {
                                                phi_1150_ = type_7((_e691.member + 1u), _e691.member_1);
                                                phi_1172_ = type_7(1u, _e691.member);
                                            } else {
                                                phi_1150_ = _e691;
                                                phi_1172_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e704 = phi_1150_;
                                            let _e706 = phi_1172_;
                                            let _e710 = (bitcast<i32>(_e706.member) != 0i);
                                            if _e710 {
                                                let _e711 = ((_e677.member_1 & 268435455u) + _e706.member_1);
                                                let _e712 = (_e711 < arrayLength((&global_6.member)));
                                                if _e712 {
                                                    if _e712 {
                                                    } else {
                                                        phi_3470_ = true;
                                                        break;
                                                    }
                                                    let _e715 = global_6.member[_e711].member_1;
                                                    phi_1197_ = _e715;
                                                } else {
                                                    phi_1197_ = 4294967295u;
                                                }
                                                let _e717 = phi_1197_;
                                                if _e712 {
                                                    if _e712 {
                                                    } else {
                                                        phi_3470_ = true;
                                                        break;
                                                    }
                                                    let _e719 = global_6.member[_e711];
                                                    phi_1213_ = _e719;
                                                } else {
                                                    phi_1213_ = type_43(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e721 = phi_1213_;
                                                let _e733 = ((10u * _e245) & 31u);
                                                let _e736 = ((_e721.member[0] >> bitcast<u32>(_e733)) & 1023u);
                                                let _e744 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                let _e749 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e736)) - 8388608f) * _e744)) ^ _e117)));
                                                let _e753 = select(select(_e677.member.member_1[0], _e749, (_e749 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e736 == 1023u));
                                                let _e755 = ((10u * _e244) & 31u);
                                                let _e758 = ((_e721.member[0] >> bitcast<u32>(_e755)) & 1023u);
                                                let _e766 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                let _e771 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e758)) - 8388608f) * _e766)) ^ _e117)));
                                                let _e775 = select(select(_e677.member.member_1[1], _e771, (_e771 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e758 == 1023u));
                                                let _e777 = ((10u * _e246) & 31u);
                                                let _e780 = ((_e721.member[0] >> bitcast<u32>(_e777)) & 1023u);
                                                let _e788 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                let _e793 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e780)) - 8388608f) * _e788)) ^ _e117)));
                                                let _e797 = select(select(_e677.member.member_1[2], _e793, (_e793 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e780 == 1023u));
                                                let _e801 = ((_e721.member[1] >> bitcast<u32>(_e733)) & 1023u);
                                                let _e809 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e801)) - 8388608f) * _e744)) ^ _e117)));
                                                let _e813 = select(select(_e677.member.member_1[0], _e809, (_e809 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e801 == 1023u));
                                                let _e816 = ((_e721.member[1] >> bitcast<u32>(_e755)) & 1023u);
                                                let _e824 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e816)) - 8388608f) * _e766)) ^ _e117)));
                                                let _e828 = select(select(_e677.member.member_1[1], _e824, (_e824 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e816 == 1023u));
                                                let _e831 = ((_e721.member[1] >> bitcast<u32>(_e777)) & 1023u);
                                                let _e839 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e831)) - 8388608f) * _e788)) ^ _e117)));
                                                let _e843 = select(select(_e677.member.member_1[2], _e839, (_e839 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e831 == 1023u));
                                                let _e847 = ((_e721.member[2] >> bitcast<u32>(_e733)) & 1023u);
                                                let _e855 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e847)) - 8388608f) * _e744)) ^ _e117)));
                                                let _e859 = select(select(_e677.member.member_1[0], _e855, (_e855 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e847 == 1023u));
                                                let _e862 = ((_e721.member[2] >> bitcast<u32>(_e755)) & 1023u);
                                                let _e870 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e862)) - 8388608f) * _e766)) ^ _e117)));
                                                let _e874 = select(select(_e677.member.member_1[1], _e870, (_e870 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e862 == 1023u));
                                                let _e877 = ((_e721.member[2] >> bitcast<u32>(_e777)) & 1023u);
                                                let _e885 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e877)) - 8388608f) * _e788)) ^ _e117)));
                                                let _e889 = select(select(_e677.member.member_1[2], _e885, (_e885 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e877 == 1023u));
                                                let _e893 = (_e797 - _e446);
                                                let _e896 = (((_e753 - _e309) * _e485) - (_e893 * _e349));
                                                let _e899 = (((_e775 - _e378) * _e485) - (_e893 * _e417));
                                                let _e902 = (_e843 - _e446);
                                                let _e905 = (((_e813 - _e309) * _e485) - (_e902 * _e349));
                                                let _e908 = (((_e828 - _e378) * _e485) - (_e902 * _e417));
                                                let _e911 = (_e889 - _e446);
                                                let _e914 = (((_e859 - _e309) * _e485) - (_e911 * _e349));
                                                let _e917 = (((_e874 - _e378) * _e485) - (_e911 * _e417));
                                                let _e918 = (_e914 * _e908);
                                                let _e919 = (_e917 * _e905);
                                                let _e920 = (_e896 * _e917);
                                                let _e921 = (_e899 * _e914);
                                                let _e922 = (_e905 * _e899);
                                                let _e923 = (_e908 * _e896);
                                                let _e928 = (((_e918 >= _e919) && (_e920 >= _e921)) && (_e922 >= _e923));
                                                if (_e928 || (((_e918 <= _e919) && (_e920 <= _e921)) && (_e922 <= _e923))) {
                                                    let _e935 = select(-1f, 1f, _e928);
                                                    let _e937 = ((_e918 - _e919) * _e935);
                                                    let _e939 = select(0f, _e937, (_e937 > 0f));
                                                    let _e941 = ((_e920 - _e921) * _e935);
                                                    let _e943 = select(0f, _e941, (_e941 > 0f));
                                                    let _e945 = ((_e922 - _e923) * _e935);
                                                    let _e947 = select(0f, _e945, (_e945 > 0f));
                                                    let _e949 = ((_e939 + _e943) + _e947);
                                                    if (_e949 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2359_ = type_21();
                                                        phi_2360_ = true;
                                                        phi_2361_ = false;
                                                    } else {
                                                        let _e952 = select(_e905, _e896, (_e896 < _e905));
                                                        if (select(_e914, _e952, (_e952 < _e914)) > 0f) {
                                                            phi_1651_ = true;
                                                        } else {
                                                            let _e957 = select(_e905, _e896, (_e896 > _e905));
                                                            phi_1651_ = (select(_e914, _e957, (_e957 > _e914)) < 0f);
                                                        }
                                                        let _e962 = phi_1651_;
                                                        if _e962 {
                                                            phi_2356_ = type_21();
                                                            phi_2357_ = true;
                                                            phi_2358_ = false;
                                                        } else {
                                                            let _e964 = select(_e908, _e899, (_e899 < _e908));
                                                            if (select(_e917, _e964, (_e964 < _e917)) > 0f) {
                                                                phi_1680_ = true;
                                                            } else {
                                                                let _e969 = select(_e908, _e899, (_e899 > _e908));
                                                                phi_1680_ = (select(_e917, _e969, (_e969 > _e917)) < 0f);
                                                            }
                                                            let _e974 = phi_1680_;
                                                            if _e974 {
                                                                phi_2354_ = type_21();
                                                                phi_2355_ = false;
                                                            } else {
                                                                let _e976 = select(_e813, _e753, (_e753 < _e813));
                                                                let _e980 = select(_e813, _e753, (_e753 > _e813));
                                                                let _e984 = select(_e828, _e775, (_e775 < _e828));
                                                                let _e988 = select(_e828, _e775, (_e775 > _e828));
                                                                let _e992 = select(_e843, _e797, (_e797 < _e843));
                                                                let _e996 = select(_e843, _e797, (_e797 > _e843));
                                                                let _e1001 = ((select(_e859, _e976, (_e976 < _e859)) - _e347) * _e352);
                                                                let _e1002 = ((select(_e859, _e980, (_e980 > _e859)) - _e348) * _e352);
                                                                let _e1005 = ((select(_e874, _e984, (_e984 < _e874)) - _e415) * _e420);
                                                                let _e1006 = ((select(_e874, _e988, (_e988 > _e874)) - _e416) * _e420);
                                                                let _e1009 = ((select(_e889, _e992, (_e992 < _e889)) - _e483) * _e488);
                                                                let _e1010 = ((select(_e889, _e996, (_e996 > _e889)) - _e484) * _e488);
                                                                let _e1012 = select(_e1010, _e1009, (_e1009 < _e1010));
                                                                let _e1014 = select(_e1010, _e1009, (_e1009 > _e1010));
                                                                let _e1016 = select(_e1002, _e1001, (_e1001 < _e1002));
                                                                let _e1018 = select(_e1006, _e1005, (_e1005 < _e1006));
                                                                let _e1020 = select(_e1018, _e1016, (_e1016 > _e1018));
                                                                let _e1022 = select(_e1012, _e1020, (_e1020 > _e1012));
                                                                let _e1024 = select(_e1002, _e1001, (_e1001 > _e1002));
                                                                let _e1026 = select(_e1006, _e1005, (_e1005 > _e1006));
                                                                let _e1028 = select(_e1026, _e1024, (_e1024 < _e1026));
                                                                let _e1030 = select(_e1014, _e1028, (_e1028 < _e1014));
                                                                let _e1031 = -(_e1012);
                                                                let _e1037 = select(_e600, _e1022, (_e1022 > _e600));
                                                                if (_e1037 > (_e1030 + (select(_e1031, _e1014, (_e1014 > _e1031)) * 0.0000019073523f))) {
                                                                    phi_2349_ = type_21();
                                                                    phi_2350_ = true;
                                                                } else {
                                                                    let _e1039 = (_e1037 > _e689.member);
                                                                    if _e1039 {
                                                                        phi_2348_ = type_21();
                                                                    } else {
                                                                        let _e1040 = vec3<f32>(_e753, _e775, _e797);
                                                                        let _e1041 = vec3<f32>(_e813, _e828, _e843);
                                                                        let _e1042 = vec3<f32>(_e859, _e874, _e889);
                                                                        let _e1043 = (_e813 - _e753);
                                                                        let _e1044 = (_e828 - _e775);
                                                                        let _e1045 = (_e843 - _e797);
                                                                        let _e1046 = vec3<f32>(_e1043, _e1044, _e1045);
                                                                        let _e1047 = (_e859 - _e813);
                                                                        let _e1048 = (_e874 - _e828);
                                                                        let _e1049 = (_e889 - _e843);
                                                                        let _e1050 = vec3<f32>(_e1047, _e1048, _e1049);
                                                                        let _e1051 = (_e753 - _e859);
                                                                        let _e1052 = (_e775 - _e874);
                                                                        let _e1053 = (_e797 - _e889);
                                                                        let _e1054 = vec3<f32>(_e1051, _e1052, _e1053);
                                                                        let _e1057 = bitcast<f32>((bitcast<u32>(_e1043) & 2147483647u));
                                                                        let _e1060 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                                                        let _e1062 = select(_e1060, _e1057, (_e1057 > _e1060));
                                                                        let _e1065 = bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u));
                                                                        let _e1067 = select(_e1065, _e1062, (_e1062 > _e1065));
                                                                        let _e1070 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                        let _e1073 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                        let _e1075 = select(_e1073, _e1070, (_e1070 > _e1073));
                                                                        let _e1078 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                                        let _e1080 = select(_e1078, _e1075, (_e1075 > _e1078));
                                                                        let _e1083 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                                        let _e1086 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                        let _e1088 = select(_e1086, _e1083, (_e1083 > _e1086));
                                                                        let _e1091 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                                        let _e1093 = select(_e1091, _e1088, (_e1088 > _e1091));
                                                                        let _e1095 = select(_e1080, _e1067, (_e1067 > _e1080));
                                                                        let _e1097 = select(_e1093, _e1095, (_e1095 > _e1093));
                                                                        if (_e1067 == _e1097) {
                                                                            phi_2075_ = _e908;
                                                                            phi_2076_ = _e905;
                                                                            phi_2077_ = _e899;
                                                                            phi_2078_ = _e896;
                                                                            phi_2079_ = _e1040;
                                                                            phi_2080_ = _e1054;
                                                                            phi_2081_ = _e1050;
                                                                            phi_2082_ = _e1046;
                                                                        } else {
                                                                            let _e1099 = (_e1080 == _e1097);
                                                                            let _e1104 = vec3(_e1099);
                                                                            phi_2075_ = select(_e899, _e917, _e1099);
                                                                            phi_2076_ = select(_e896, _e914, _e1099);
                                                                            phi_2077_ = select(_e917, _e908, _e1099);
                                                                            phi_2078_ = select(_e914, _e905, _e1099);
                                                                            phi_2079_ = select(_e1042, _e1041, _e1104);
                                                                            phi_2080_ = select(_e1050, _e1046, _e1104);
                                                                            phi_2081_ = select(_e1046, _e1054, _e1104);
                                                                            phi_2082_ = select(_e1054, _e1050, _e1104);
                                                                        }
                                                                        let _e1110 = phi_2075_;
                                                                        let _e1112 = phi_2076_;
                                                                        let _e1114 = phi_2077_;
                                                                        let _e1116 = phi_2078_;
                                                                        let _e1118 = phi_2079_;
                                                                        let _e1120 = phi_2080_;
                                                                        let _e1122 = phi_2081_;
                                                                        let _e1124 = phi_2082_;
                                                                        let _e1131 = ((_e1122.y * _e1120.z) - (_e1120.y * _e1122.z));
                                                                        let _e1136 = ((_e1122.z * _e1120.x) - (_e1120.z * _e1122.x));
                                                                        let _e1139 = ((_e1122.x * _e1120.y) - (_e1120.x * _e1122.y));
                                                                        if (_e939 >= _e943) {
                                                                            phi_2119_ = select(true, false, (_e939 >= _e947));
                                                                        } else {
                                                                            phi_2119_ = true;
                                                                        }
                                                                        let _e1144 = phi_2119_;
                                                                        if _e1144 {
                                                                            phi_2128_ = select(_e1042, _e1041, vec3((_e943 >= _e947)));
                                                                        } else {
                                                                            phi_2128_ = _e1040;
                                                                        }
                                                                        let _e1149 = phi_2128_;
                                                                        let _e1160 = (((_e1131 * (_e1149.x - _e309)) + (_e1136 * (_e1149.y - _e378))) + (_e1139 * (_e1149.z - _e446)));
                                                                        let _e1165 = (((_e1131 * _e349) + (_e1136 * _e417)) + (_e1139 * _e485));
                                                                        let _e1166 = (_e1112 - _e1116);
                                                                        let _e1167 = (_e1110 - _e1114);
                                                                        let _e1175 = (-(((_e1116 * _e1166) + (_e1114 * _e1167))) / ((_e1166 * _e1166) + (_e1167 * _e1167)));
                                                                        let _e1177 = select(1f, _e1175, (_e1175 < 1f));
                                                                        let _e1179 = select(0f, _e1177, (_e1177 > 0f));
                                                                        let _e1192 = ((_e1118.x + (_e1124.x * _e1179)) - _e309);
                                                                        let _e1193 = ((_e1118.y + (_e1124.y * _e1179)) - _e378);
                                                                        let _e1194 = ((_e1118.z + (_e1124.z * _e1179)) - _e446);
                                                                        let _e1195 = (_e1194 / _e485);
                                                                        let _e1207 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
                                                                        let _e1210 = bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u));
                                                                        let _e1212 = select(_e1210, _e1207, (_e1207 > _e1210));
                                                                        let _e1215 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                                        let _e1217 = select(_e1215, _e1212, (_e1212 > _e1215));
                                                                        let _e1223 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                        let _e1228 = select(_e1226, _e1223, (_e1223 > _e1226));
                                                                        let _e1231 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1131 * _e1192) + (_e1136 * _e1193)) + (_e1139 * _e1194)) - _e1160)) & 2147483647u)) <= ((0.0000009536743f * select(_e1097, _e1217, (_e1217 > _e1097))) * select(_e1231, _e1228, (_e1228 > _e1231)))) {
                                                                            let _e1241 = bitcast<f32>((bitcast<u32>(_e1122.x) & 2147483647u));
                                                                            let _e1244 = bitcast<f32>((bitcast<u32>(_e1122.y) & 2147483647u));
                                                                            let _e1246 = select(_e1244, _e1241, (_e1241 > _e1244));
                                                                            let _e1249 = bitcast<f32>((bitcast<u32>(_e1122.z) & 2147483647u));
                                                                            let _e1255 = bitcast<f32>((bitcast<u32>(_e1120.x) & 2147483647u));
                                                                            let _e1258 = bitcast<f32>((bitcast<u32>(_e1120.y) & 2147483647u));
                                                                            let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                            let _e1263 = bitcast<f32>((bitcast<u32>(_e1120.z) & 2147483647u));
                                                                            let _e1267 = (bitcast<f32>((bitcast<u32>(_e1165) & 2147483647u)) > ((0.0000038146973f * select(_e1249, _e1246, (_e1246 > _e1249))) * select(_e1263, _e1260, (_e1260 > _e1263))));
                                                                            if _e1267 {
                                                                                phi_2293_ = (_e1160 / _e1165);
                                                                            } else {
                                                                                phi_2293_ = f32();
                                                                            }
                                                                            let _e1270 = phi_2293_;
                                                                            phi_2295_ = _e1270;
                                                                            phi_2296_ = select(true, false, _e1267);
                                                                        } else {
                                                                            phi_2295_ = f32();
                                                                            phi_2296_ = true;
                                                                        }
                                                                        let _e1273 = phi_2295_;
                                                                        let _e1275 = phi_2296_;
                                                                        if _e1275 {
                                                                            let _e1283 = (((_e1131 * (_e1192 - (_e349 * _e1195))) + (_e1136 * (_e1193 - (_e417 * _e1195)))) / _e1165);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u)) <= _e1097) {
                                                                                phi_2316_ = (_e1195 + _e1283);
                                                                            } else {
                                                                                phi_2316_ = _e1195;
                                                                            }
                                                                            let _e1290 = phi_2316_;
                                                                            phi_2317_ = _e1290;
                                                                        } else {
                                                                            phi_2317_ = _e1273;
                                                                        }
                                                                        let _e1292 = phi_2317_;
                                                                        let _e1294 = select(_e1030, _e1292, (_e1292 < _e1030));
                                                                        let _e1296 = select(_e1022, _e1294, (_e1294 > _e1022));
                                                                        if (_e1296 >= _e600) {
                                                                            let _e1298 = (_e1296 <= _e689.member);
                                                                            if _e1298 {
                                                                                let _e1299 = (1f / _e949);
                                                                                phi_2340_ = type_21(_e1296, (_e943 * _e1299), (_e947 * _e1299), _e717);
                                                                            } else {
                                                                                phi_2340_ = type_21();
                                                                            }
                                                                            let _e1304 = phi_2340_;
                                                                            phi_2342_ = _e1304;
                                                                            phi_2343_ = select(true, false, _e1298);
                                                                        } else {
                                                                            phi_2342_ = type_21();
                                                                            phi_2343_ = true;
                                                                        }
                                                                        let _e1307 = phi_2342_;
                                                                        let _e1309 = phi_2343_;
                                                                        if _e1309 {
                                                                            phi_2347_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2347_ = _e1307;
                                                                        }
                                                                        let _e1311 = phi_2347_;
                                                                        phi_2348_ = _e1311;
                                                                    }
                                                                    let _e1313 = phi_2348_;
                                                                    phi_2349_ = _e1313;
                                                                    phi_2350_ = _e1039;
                                                                }
                                                                let _e1315 = phi_2349_;
                                                                let _e1317 = phi_2350_;
                                                                phi_2354_ = _e1315;
                                                                phi_2355_ = _e1317;
                                                            }
                                                            let _e1319 = phi_2354_;
                                                            let _e1321 = phi_2355_;
                                                            phi_2356_ = _e1319;
                                                            phi_2357_ = _e974;
                                                            phi_2358_ = _e1321;
                                                        }
                                                        let _e1323 = phi_2356_;
                                                        let _e1325 = phi_2357_;
                                                        let _e1327 = phi_2358_;
                                                        phi_2359_ = _e1323;
                                                        phi_2360_ = _e1325;
                                                        phi_2361_ = _e1327;
                                                    }
                                                    let _e1329 = phi_2359_;
                                                    let _e1331 = phi_2360_;
                                                    let _e1333 = phi_2361_;
                                                    phi_2369_ = _e1329;
                                                    phi_2370_ = select(_e1333, true, _e1331);
                                                } else {
                                                    phi_2369_ = type_21();
                                                    phi_2370_ = true;
                                                }
                                                let _e1336 = phi_2369_;
                                                let _e1338 = phi_2370_;
                                                if _e1338 {
                                                    phi_2374_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2374_ = _e1336;
                                                }
                                                let _e1340 = phi_2374_;
                                                if (_e1340.member_3 != 4294967295u) {
                                                    if (_e717 != 4294967295u) {
                                                        phi_2385_ = type_32(_e689.member, true);
                                                    } else {
                                                        phi_2385_ = _e689;
                                                    }
                                                    let _e1348 = phi_2385_;
                                                    phi_2386_ = _e1348;
                                                } else {
                                                    phi_2386_ = _e689;
                                                }
                                                let _e1350 = phi_2386_;
                                                phi_1147_ = _e1350;
                                            } else {
                                                phi_1147_ = type_32();
                                            }
                                            let _e1352 = phi_1147_;
                                            continue;
                                            continuing {
                                                phi_1146_ = _e1352;
                                                phi_1149_ = _e704;
                                                phi_3470_ = _e632;
                                                break if !(_e710);
                                            }
                                        }
                                        let _e1355 = phi_3470_;
                                        phi_3645_ = _e1355;
                                        if _e1355 {
                                            break;
                                        }
                                        phi_3704_ = _e1355;
                                        let _e1877 = local_11;
                                        phi_2387_ = _e1877;
                                    } else {
                                        phi_3704_ = _e632;
                                        phi_2387_ = _e634;
                                    }
                                    let _e1357 = phi_3704_;
                                    let _e1359 = phi_2387_;
                                    if _e681 {
                                        phi_3394_ = bool();
                                        phi_3395_ = u32();
                                        phi_3396_ = type_49();
                                    } else {
                                        let _e1360 = (_e677.member_1 < _e82);
                                        if _e1360 {
                                            if _e1360 {
                                            } else {
                                                phi_3645_ = true;
                                                break;
                                            }
                                            let _e1362 = global_5.member[_e677.member_1];
                                            phi_2408_ = _e1362;
                                        } else {
                                            phi_2408_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1364 = phi_2408_;
                                        let _e1379 = ((10u * _e245) & 31u);
                                        let _e1382 = ((_e1364.member[0] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1390 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e1395 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1382)) - 8388608f) * _e1390)) ^ _e117)));
                                        let _e1399 = select(select(_e677.member.member_1[0], _e1395, (_e1395 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1382 == 1023u));
                                        let _e1401 = ((10u * _e244) & 31u);
                                        let _e1404 = ((_e1364.member[0] >> bitcast<u32>(_e1401)) & 1023u);
                                        let _e1412 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e1417 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1404)) - 8388608f) * _e1412)) ^ _e117)));
                                        let _e1421 = select(select(_e677.member.member_1[1], _e1417, (_e1417 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1404 == 1023u));
                                        let _e1423 = ((10u * _e246) & 31u);
                                        let _e1426 = ((_e1364.member[0] >> bitcast<u32>(_e1423)) & 1023u);
                                        let _e1434 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e1439 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1426)) - 8388608f) * _e1434)) ^ _e117)));
                                        let _e1443 = select(select(_e677.member.member_1[2], _e1439, (_e1439 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1426 == 1023u));
                                        let _e1446 = ((_e1364.member[1] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1454 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1446)) - 8388608f) * _e1390)) ^ _e117)));
                                        let _e1458 = select(select(_e677.member.member_1[0], _e1454, (_e1454 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1446 == 1023u));
                                        let _e1461 = ((_e1364.member[1] >> bitcast<u32>(_e1401)) & 1023u);
                                        let _e1469 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1461)) - 8388608f) * _e1412)) ^ _e117)));
                                        let _e1473 = select(select(_e677.member.member_1[1], _e1469, (_e1469 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1461 == 1023u));
                                        let _e1476 = ((_e1364.member[1] >> bitcast<u32>(_e1423)) & 1023u);
                                        let _e1484 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1476)) - 8388608f) * _e1434)) ^ _e117)));
                                        let _e1488 = select(select(_e677.member.member_1[2], _e1484, (_e1484 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1476 == 1023u));
                                        let _e1494 = ((_e1364.member_1[0] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1502 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1494)) - 8388608f) * _e1390)) ^ _e117)));
                                        let _e1506 = select(select(_e677.member.member_1[0], _e1502, (_e1502 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1494 == 1023u));
                                        let _e1509 = ((_e1364.member_1[0] >> bitcast<u32>(_e1401)) & 1023u);
                                        let _e1517 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1509)) - 8388608f) * _e1412)) ^ _e117)));
                                        let _e1521 = select(select(_e677.member.member_1[1], _e1517, (_e1517 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1509 == 1023u));
                                        let _e1524 = ((_e1364.member_1[0] >> bitcast<u32>(_e1423)) & 1023u);
                                        let _e1532 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1524)) - 8388608f) * _e1434)) ^ _e117)));
                                        let _e1536 = select(select(_e677.member.member_1[2], _e1532, (_e1532 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1524 == 1023u));
                                        let _e1539 = ((_e1364.member_1[1] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1547 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1539)) - 8388608f) * _e1390)) ^ _e117)));
                                        let _e1551 = select(select(_e677.member.member_1[0], _e1547, (_e1547 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1539 == 1023u));
                                        let _e1554 = ((_e1364.member_1[1] >> bitcast<u32>(_e1401)) & 1023u);
                                        let _e1562 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1554)) - 8388608f) * _e1412)) ^ _e117)));
                                        let _e1566 = select(select(_e677.member.member_1[1], _e1562, (_e1562 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1554 == 1023u));
                                        let _e1569 = ((_e1364.member_1[1] >> bitcast<u32>(_e1423)) & 1023u);
                                        let _e1577 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1569)) - 8388608f) * _e1434)) ^ _e117)));
                                        let _e1581 = select(select(_e677.member.member_1[2], _e1577, (_e1577 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1569 == 1023u));
                                        let _e1586 = type_49(type_41(array<f32, 3>(_e1399, _e1421, _e1443), array<f32, 3>(_e1458, _e1473, _e1488)), _e1364.member_2);
                                        let _e1591 = type_49(type_41(array<f32, 3>(_e1506, _e1521, _e1536), array<f32, 3>(_e1551, _e1566, _e1581)), _e1364.member_3);
                                        let _e1597 = ((_e1399 - _e347) * _e352);
                                        let _e1598 = ((_e1506 - _e347) * _e352);
                                        let _e1599 = ((_e1458 - _e348) * _e352);
                                        let _e1600 = ((_e1551 - _e348) * _e352);
                                        let _e1605 = ((_e1421 - _e415) * _e420);
                                        let _e1606 = ((_e1521 - _e415) * _e420);
                                        let _e1607 = ((_e1473 - _e416) * _e420);
                                        let _e1608 = ((_e1566 - _e416) * _e420);
                                        let _e1613 = ((_e1443 - _e483) * _e488);
                                        let _e1614 = ((_e1536 - _e483) * _e488);
                                        let _e1615 = ((_e1488 - _e484) * _e488);
                                        let _e1616 = ((_e1581 - _e484) * _e488);
                                        let _e1618 = select(_e1615, _e1613, (_e1613 < _e1615));
                                        let _e1620 = select(_e1616, _e1614, (_e1614 < _e1616));
                                        let _e1622 = select(_e1615, _e1613, (_e1613 > _e1615));
                                        let _e1624 = select(_e1616, _e1614, (_e1614 > _e1616));
                                        let _e1626 = select(_e1599, _e1597, (_e1597 < _e1599));
                                        let _e1628 = select(_e1600, _e1598, (_e1598 < _e1600));
                                        let _e1630 = select(_e1607, _e1605, (_e1605 < _e1607));
                                        let _e1632 = select(_e1608, _e1606, (_e1606 < _e1608));
                                        let _e1634 = select(_e1630, _e1626, (_e1626 > _e1630));
                                        let _e1636 = select(_e1632, _e1628, (_e1628 > _e1632));
                                        let _e1638 = select(_e1618, _e1634, (_e1634 > _e1618));
                                        let _e1640 = select(_e1620, _e1636, (_e1636 > _e1620));
                                        let _e1642 = select(_e1599, _e1597, (_e1597 > _e1599));
                                        let _e1644 = select(_e1600, _e1598, (_e1598 > _e1600));
                                        let _e1646 = select(_e1607, _e1605, (_e1605 > _e1607));
                                        let _e1648 = select(_e1608, _e1606, (_e1606 > _e1608));
                                        let _e1650 = select(_e1646, _e1642, (_e1642 < _e1646));
                                        let _e1652 = select(_e1648, _e1644, (_e1644 < _e1648));
                                        let _e1657 = -(_e1618);
                                        let _e1658 = -(_e1620);
                                        let _e1665 = (select(_e1622, _e1650, (_e1650 < _e1622)) + (select(_e1657, _e1622, (_e1622 > _e1657)) * 0.0000019073523f));
                                        let _e1666 = (select(_e1624, _e1652, (_e1652 < _e1624)) + (select(_e1658, _e1624, (_e1624 > _e1658)) * 0.0000019073523f));
                                        let _e1668 = select(_e600, _e1638, (_e1638 > _e600));
                                        let _e1670 = select(_e600, _e1640, (_e1640 > _e600));
                                        let _e1675 = (_e1668 <= select(_e1359.member, _e1665, (_e1665 < _e1359.member)));
                                        let _e1676 = (_e1670 <= select(_e1359.member, _e1666, (_e1666 < _e1359.member)));
                                        let _e1677 = (_e1668 <= _e1670);
                                        if _e1675 {
                                            if _e1676 {
                                                if _e1677 {
                                                    phi_3294_ = _e1591;
                                                } else {
                                                    phi_3294_ = _e1586;
                                                }
                                                let _e1679 = phi_3294_;
                                                let _e1686 = (_e675 % 128u);
                                                let _e1687 = (_e1686 < 128u);
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local_6[_e1686] = _e1679.member_1;
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local_5[_e1686] = _e1679.member.member[0];
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local_4[_e1686] = _e1679.member.member[1];
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local_3[_e1686] = _e1679.member.member[2];
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local_2[_e1686] = _e1679.member.member_1[0];
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local_1[_e1686] = _e1679.member.member_1[1];
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local[_e1686] = _e1679.member.member_1[2];
                                                if _e1687 {
                                                } else {
                                                    phi_3645_ = true;
                                                    break;
                                                }
                                                local_7[_e1686] = select(_e1668, _e1670, _e1677);
                                                if _e1677 {
                                                    phi_3370_ = _e1586;
                                                } else {
                                                    phi_3370_ = _e1591;
                                                }
                                                let _e1704 = phi_3370_;
                                                phi_3371_ = (_e675 + 1u);
                                                phi_3372_ = _e1704;
                                            } else {
                                                phi_3371_ = u32();
                                                phi_3372_ = type_49();
                                            }
                                            let _e1706 = phi_3371_;
                                            let _e1708 = phi_3372_;
                                            phi_3374_ = _e1706;
                                            phi_3375_ = _e1708;
                                            phi_3376_ = select(true, false, _e1676);
                                        } else {
                                            phi_3374_ = u32();
                                            phi_3375_ = type_49();
                                            phi_3376_ = true;
                                        }
                                        let _e1711 = phi_3374_;
                                        let _e1713 = phi_3375_;
                                        let _e1715 = phi_3376_;
                                        if _e1715 {
                                            if _e1675 {
                                                phi_3383_ = _e1586;
                                            } else {
                                                phi_3383_ = _e1591;
                                            }
                                            let _e1717 = phi_3383_;
                                            phi_3388_ = select(_e1676, true, _e1675);
                                            phi_3390_ = _e1717;
                                        } else {
                                            phi_3388_ = _e673;
                                            phi_3390_ = _e1713;
                                        }
                                        let _e1720 = phi_3388_;
                                        let _e1722 = phi_3390_;
                                        phi_3394_ = _e1720;
                                        phi_3395_ = select(_e1711, _e675, _e1715);
                                        phi_3396_ = _e1722;
                                    }
                                    let _e1725 = phi_3394_;
                                    let _e1727 = phi_3395_;
                                    let _e1729 = phi_3396_;
                                    if _e681 {
                                        phi_3406_ = select(_e675, 0u, _e1359.member_1);
                                        phi_3407_ = _e677;
                                    } else {
                                        phi_3406_ = _e1727;
                                        phi_3407_ = _e1729;
                                    }
                                    let _e1733 = phi_3406_;
                                    let _e1735 = phi_3407_;
                                    phi_3648_ = _e1357;
                                    phi_3408_ = _e1359;
                                    phi_3409_ = (_e636 - 1u);
                                    phi_3410_ = select(_e1725, false, _e681);
                                    phi_3411_ = _e1733;
                                    phi_3412_ = _e1735;
                                } else {
                                    phi_3648_ = _e632;
                                    phi_3408_ = _e634;
                                    phi_3409_ = _e636;
                                    phi_3410_ = _e673;
                                    phi_3411_ = _e675;
                                    phi_3412_ = _e677;
                                }
                                let _e1738 = phi_3648_;
                                let _e1740 = phi_3408_;
                                let _e1742 = phi_3409_;
                                let _e1744 = phi_3410_;
                                let _e1746 = phi_3411_;
                                let _e1748 = phi_3412_;
                                phi_3647_ = _e1738;
                                phi_3413_ = _e1740;
                                phi_3414_ = _e1742;
                                phi_3415_ = _e1744;
                                phi_3416_ = _e1746;
                                phi_3417_ = _e1748;
                            } else {
                                phi_3647_ = _e632;
                                phi_3413_ = type_32();
                                phi_3414_ = u32();
                                phi_3415_ = bool();
                                phi_3416_ = u32();
                                phi_3417_ = type_49();
                            }
                            let _e1750 = phi_3647_;
                            let _e1752 = phi_3413_;
                            let _e1754 = phi_3414_;
                            let _e1756 = phi_3415_;
                            let _e1758 = phi_3416_;
                            let _e1760 = phi_3417_;
                            phi_3646_ = _e1750;
                            phi_1020_ = _e1752;
                            phi_1023_ = _e1754;
                            phi_1025_ = _e1756;
                            phi_1027_ = _e1758;
                            phi_1029_ = _e1760;
                            phi_3418_ = _e646;
                        } else {
                            phi_3646_ = _e632;
                            phi_1020_ = type_32();
                            phi_1023_ = u32();
                            phi_1025_ = bool();
                            phi_1027_ = u32();
                            phi_1029_ = type_49();
                            phi_3418_ = false;
                        }
                        let _e1762 = phi_3646_;
                        let _e1764 = phi_1020_;
                        let _e1766 = phi_1023_;
                        let _e1768 = phi_1025_;
                        let _e1770 = phi_1027_;
                        let _e1772 = phi_1029_;
                        let _e1774 = phi_3418_;
                        continue;
                        continuing {
                            phi_3476_ = _e1762;
                            phi_1019_ = _e1764;
                            phi_1022_ = _e1766;
                            phi_1024_ = _e1768;
                            phi_1026_ = _e1770;
                            phi_1028_ = _e1772;
                            phi_3645_ = _e1762;
                            break if !(_e1774);
                        }
                    }
                    let _e1777 = phi_3645_;
                    if _e1777 {
                        break;
                    }
                    let _e1779 = local_10;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_4.member[_e131] = select(0u, 1u, _e1779.member_1);
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
