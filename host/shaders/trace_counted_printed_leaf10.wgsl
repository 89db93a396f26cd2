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
    var phi_345_: i32;
    var phi_346_: i32;
    var phi_356_: bool;
    var phi_366_: u32;
    var phi_367_: u32;
    var phi_369_: bool;
    var phi_374_: u32;
    var phi_387_: i32;
    var phi_407_: i32;
    var phi_425_: f32;
    var phi_431_: f32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_529_: f32;
    var phi_541_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_596_: f32;
    var phi_602_: f32;
    var phi_654_: f32;
    var phi_666_: f32;
    var phi_675_: f32;
    var phi_681_: f32;
    var phi_721_: f32;
    var phi_727_: f32;
    var phi_779_: f32;
    var phi_791_: f32;
    var phi_846_: i32;
    var phi_868_: u32;
    var phi_869_: u32;
    var phi_906_: i32;
    var phi_928_: u32;
    var phi_929_: u32;
    var phi_937_: f32;
    var phi_938_: f32;
    var phi_3506_: bool;
    var phi_1022_: type_33;
    var phi_1025_: bool;
    var phi_1027_: u32;
    var phi_1029_: u32;
    var phi_1031_: type_50;
    var phi_1042_: bool;
    var phi_1128_: bool;
    var phi_1129_: u32;
    var phi_1130_: type_50;
    var phi_2441_: type_37;
    var phi_3330_: type_50;
    var phi_3407_: type_50;
    var phi_3408_: u32;
    var phi_3409_: type_50;
    var phi_3411_: u32;
    var phi_3412_: type_50;
    var phi_3413_: bool;
    var phi_3420_: type_50;
    var phi_3425_: bool;
    var phi_3427_: type_50;
    var phi_1149_: type_33;
    var phi_1152_: type_4;
    var phi_1153_: type_4;
    var phi_1175_: type_4;
    var phi_1203_: u32;
    var phi_1219_: type_44;
    var phi_1657_: bool;
    var phi_1686_: bool;
    var phi_2081_: f32;
    var phi_2082_: f32;
    var phi_2083_: f32;
    var phi_2084_: f32;
    var phi_2085_: vec3<f32>;
    var phi_2086_: vec3<f32>;
    var phi_2087_: vec3<f32>;
    var phi_2088_: vec3<f32>;
    var phi_2125_: bool;
    var phi_2134_: vec3<f32>;
    var phi_2299_: f32;
    var phi_2301_: f32;
    var phi_2302_: bool;
    var phi_2322_: f32;
    var phi_2323_: f32;
    var phi_2346_: type_21;
    var phi_2348_: type_21;
    var phi_2349_: bool;
    var phi_2353_: type_21;
    var phi_2354_: type_21;
    var phi_2355_: type_21;
    var phi_2356_: bool;
    var phi_2360_: type_21;
    var phi_2361_: bool;
    var phi_2362_: type_21;
    var phi_2363_: bool;
    var phi_2364_: bool;
    var phi_2365_: type_21;
    var phi_2366_: bool;
    var phi_2367_: bool;
    var phi_2375_: type_21;
    var phi_2376_: bool;
    var phi_2380_: type_21;
    var phi_2405_: bool;
    var phi_2406_: bool;
    var phi_2413_: type_33;
    var phi_2414_: type_33;
    var phi_2415_: type_33;
    var phi_1150_: type_33;
    var phi_3500_: bool;
    var phi_3682_: bool;
    var phi_3432_: type_33;
    var phi_3433_: bool;
    var phi_3434_: u32;
    var phi_3435_: type_50;
    var phi_3681_: bool;
    var phi_3436_: type_33;
    var phi_3437_: bool;
    var phi_3438_: u32;
    var phi_3439_: u32;
    var phi_3440_: type_50;
    var phi_3680_: bool;
    var phi_3441_: type_33;
    var phi_3442_: bool;
    var phi_3443_: u32;
    var phi_3444_: u32;
    var phi_3445_: type_50;
    var phi_3679_: bool;
    var phi_1023_: type_33;
    var phi_1026_: bool;
    var phi_1028_: u32;
    var phi_1030_: u32;
    var phi_1032_: type_50;
    var phi_3446_: bool;
    var phi_3678_: bool;
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
                            phi_345_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_345_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_345_;
                        phi_346_ = _e224;
                    } else {
                        phi_346_ = 0i;
                    }
                    let _e226 = phi_346_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_356_ = true;
                    } else {
                        phi_356_ = (_e150 == _e182);
                    }
                    let _e230 = phi_356_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_366_ = _e232;
                        phi_367_ = _e232;
                        phi_369_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_366_ = u32();
                        phi_367_ = 0u;
                        phi_369_ = true;
                    }
                    let _e236 = phi_366_;
                    let _e238 = phi_367_;
                    let _e240 = phi_369_;
                    if _e240 {
                        phi_374_ = (_e238 + 1u);
                    } else {
                        phi_374_ = 0u;
                    }
                    let _e244 = phi_374_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_387_ = -126i;
                    } else {
                        phi_387_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_387_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_407_ = -126i;
                    } else {
                        phi_407_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_407_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_3.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_425_ = _e283[0];
                    } else {
                        phi_425_ = _e283[1];
                    }
                    let _e288 = phi_425_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_431_ = _e283[2];
                    } else {
                        phi_431_ = _e288;
                    }
                    let _e292 = phi_431_;
                    let _e293 = bitcast<u32>(_e292);
                    let _e295 = ((_e293 & 2139095040u) != 0u);
                    let _e309 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e293 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e293 & 2147483648u))), _e292, _e295) * _e256) * select(0.00000011920929f, 1f, _e295)) * _e262);
                    let _e310 = global_3.member[_e131].member_2;
                    if _e284 {
                        phi_471_ = _e310[0];
                    } else {
                        phi_471_ = _e310[1];
                    }
                    let _e314 = phi_471_;
                    if _e289 {
                        phi_477_ = _e310[2];
                    } else {
                        phi_477_ = _e314;
                    }
                    let _e317 = phi_477_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e273) * select(0.00000011920929f, 1f, _e320)) * _e279);
                    let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e338 {
                        let _e342 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e346 = phi_529_;
                    let _e347 = (_e309 + _e346);
                    let _e348 = (_e309 - _e346);
                    let _e349 = select(_e334, 0f, _e338);
                    if _e338 {
                        phi_541_ = 38685626000000000000000000f;
                    } else {
                        phi_541_ = (1f / _e334);
                    }
                    let _e352 = phi_541_;
                    let _e353 = (_e244 == 0u);
                    if _e353 {
                        phi_550_ = _e283[0];
                    } else {
                        phi_550_ = _e283[1];
                    }
                    let _e357 = phi_550_;
                    let _e358 = (_e244 == 2u);
                    if _e358 {
                        phi_556_ = _e283[2];
                    } else {
                        phi_556_ = _e357;
                    }
                    let _e361 = phi_556_;
                    let _e362 = bitcast<u32>(_e361);
                    let _e364 = ((_e362 & 2139095040u) != 0u);
                    let _e378 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * _e256) * select(0.00000011920929f, 1f, _e364)) * _e262);
                    if _e353 {
                        phi_596_ = _e310[0];
                    } else {
                        phi_596_ = _e310[1];
                    }
                    let _e382 = phi_596_;
                    if _e358 {
                        phi_602_ = _e310[2];
                    } else {
                        phi_602_ = _e382;
                    }
                    let _e385 = phi_602_;
                    let _e386 = bitcast<u32>(_e385);
                    let _e388 = ((_e386 & 2139095040u) != 0u);
                    let _e402 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e385, _e388) * _e273) * select(0.00000011920929f, 1f, _e388)) * _e279);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e378) & 2147483647u)) * 0.00000011920929f);
                        phi_654_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_654_ = 0f;
                    }
                    let _e414 = phi_654_;
                    let _e415 = (_e378 + _e414);
                    let _e416 = (_e378 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_666_ = 38685626000000000000000000f;
                    } else {
                        phi_666_ = (1f / _e402);
                    }
                    let _e420 = phi_666_;
                    let _e421 = (_e246 == 0u);
                    if _e421 {
                        phi_675_ = _e283[0];
                    } else {
                        phi_675_ = _e283[1];
                    }
                    let _e425 = phi_675_;
                    let _e426 = (_e246 == 2u);
                    if _e426 {
                        phi_681_ = _e283[2];
                    } else {
                        phi_681_ = _e425;
                    }
                    let _e429 = phi_681_;
                    let _e430 = bitcast<u32>(_e429);
                    let _e432 = ((_e430 & 2139095040u) != 0u);
                    let _e446 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e430 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e430 & 2147483648u))), _e429, _e432) * _e256) * select(0.00000011920929f, 1f, _e432)) * _e262);
                    if _e421 {
                        phi_721_ = _e310[0];
                    } else {
                        phi_721_ = _e310[1];
                    }
                    let _e450 = phi_721_;
                    if _e426 {
                        phi_727_ = _e310[2];
                    } else {
                        phi_727_ = _e450;
                    }
                    let _e453 = phi_727_;
                    let _e454 = bitcast<u32>(_e453);
                    let _e456 = ((_e454 & 2139095040u) != 0u);
                    let _e470 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e454 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e454 & 2147483648u))), _e453, _e456) * _e273) * select(0.00000011920929f, 1f, _e456)) * _e279);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e474 {
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) * 0.00000011920929f);
                        phi_779_ = select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f));
                    } else {
                        phi_779_ = 0f;
                    }
                    let _e482 = phi_779_;
                    let _e483 = (_e446 + _e482);
                    let _e484 = (_e446 - _e482);
                    let _e485 = select(_e470, 0f, _e474);
                    if _e474 {
                        phi_791_ = 38685626000000000000000000f;
                    } else {
                        phi_791_ = (1f / _e470);
                    }
                    let _e488 = phi_791_;
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
                            phi_846_ = 255i;
                        } else {
                            phi_846_ = (((_e515 + select(0i, 1i, (_e515 == 0i))) - _e522) + _e502);
                        }
                        let _e530 = phi_846_;
                        let _e540 = (_e530 <= 0i);
                        if _e540 {
                            phi_869_ = u32();
                        } else {
                            if _e519 {
                                phi_868_ = u32();
                            } else {
                                phi_868_ = select(((bitcast<u32>(_e530) << bitcast<u32>(23i)) | ((_e512 << bitcast<u32>(((_e522 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e530 >= 255i));
                            }
                            let _e544 = phi_868_;
                            phi_869_ = _e544;
                        }
                        let _e546 = phi_869_;
                        let _e558 = ((_e203 & 8388607u) | (select(0u, 1u, ((_e203 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e561 = bitcast<i32>((_e203 >> bitcast<u32>(23i)));
                        let _e565 = (_e558 == 0u);
                        let _e568 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e558)), 32u, _e565)) - 8i);
                        if (_e561 == 255i) {
                            phi_906_ = 255i;
                        } else {
                            phi_906_ = (((_e561 + select(0i, 1i, (_e561 == 0i))) - _e568) + _e502);
                        }
                        let _e576 = phi_906_;
                        let _e586 = (_e576 <= 0i);
                        if _e586 {
                            phi_929_ = u32();
                        } else {
                            if _e565 {
                                phi_928_ = u32();
                            } else {
                                phi_928_ = select(((bitcast<u32>(_e576) << bitcast<u32>(23i)) | ((_e558 << bitcast<u32>(((_e568 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e576 >= 255i));
                            }
                            let _e590 = phi_928_;
                            phi_929_ = _e590;
                        }
                        let _e592 = phi_929_;
                        phi_937_ = bitcast<f32>(((_e202 & 2147483648u) | select(_e592, 0u, select(_e565, true, _e586))));
                        phi_938_ = bitcast<f32>(((_e193 & 2147483648u) | select(_e546, 0u, select(_e519, true, _e540))));
                    } else {
                        phi_937_ = 0f;
                        phi_938_ = 1f;
                    }
                    let _e598 = phi_937_;
                    let _e600 = phi_938_;
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
                    phi_3506_ = false;
                    phi_1022_ = type_33(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e598), 0u, 0u);
                    phi_1025_ = (_e600 <= _e598);
                    phi_1027_ = ((3u * _e82) + 1u);
                    phi_1029_ = 0u;
                    phi_1031_ = type_50(type_42(array<f32, 3>(_e609, _e613, _e617), array<f32, 3>(_e621, _e623, _e625)), select(0u, 2147483648u, (_e82 == 0u)));
                    loop {
                        let _e633 = phi_3506_;
                        let _e635 = phi_1022_;
                        let _e637 = phi_1025_;
                        let _e639 = phi_1027_;
                        let _e641 = phi_1029_;
                        let _e643 = phi_1031_;
                        local_10 = _e635;
                        local_11 = _e635;
                        if _e637 {
                            phi_1042_ = true;
                        } else {
                            phi_1042_ = (_e641 > 0u);
                        }
                        let _e646 = phi_1042_;
                        if _e646 {
                            let _e647 = (_e639 > 0u);
                            if _e647 {
                                if _e637 {
                                    phi_1128_ = _e637;
                                    phi_1129_ = _e641;
                                    phi_1130_ = _e643;
                                } else {
                                    let _e648 = (_e641 - 1u);
                                    let _e649 = (_e648 % 128u);
                                    let _e650 = (_e649 < 128u);
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e652 = local_6[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e654 = local_5[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e656 = local_4[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e658 = local_3[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e661 = local_2[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e663 = local_1[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e665 = local[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e670 = local_7[_e649];
                                    phi_1128_ = (_e670 <= _e635.member.member_1);
                                    phi_1129_ = _e648;
                                    phi_1130_ = type_50(type_42(array<f32, 3>(_e654, _e656, _e658), array<f32, 3>(_e661, _e663, _e665)), _e652);
                                }
                                let _e675 = phi_1128_;
                                let _e677 = phi_1129_;
                                let _e679 = phi_1130_;
                                if _e675 {
                                    if ((_e679.member_1 & 2147483648u) != 0u) {
                                        phi_1149_ = _e635;
                                        phi_1152_ = type_4(0u, ((_e679.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1063 = phi_1149_;
                                            let _e1065 = phi_1152_;
                                            local_12 = _e1063;
                                            if (_e1065.member < _e1065.member_1) {
                                                phi_1153_ = type_4((_e1065.member + 1u), _e1065.member_1);
                                                phi_1175_ = type_4(1u, _e1065.member);
                                            } else {
                                                phi_1153_ = _e1065;
                                                phi_1175_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1078 = phi_1153_;
                                            let _e1080 = phi_1175_;
                                            let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                            if _e1084 {
                                                let _e1090 = type_33(_e1063.member, _e1063.member_1, (_e1063.member_2 + 1u));
                                                let _e1091 = ((_e679.member_1 & 268435455u) + _e1080.member_1);
                                                let _e1092 = (_e1091 < arrayLength((&global_6.member)));
                                                if _e1092 {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3500_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_6.member[_e1091].member_1;
                                                    phi_1203_ = _e1095;
                                                } else {
                                                    phi_1203_ = 4294967295u;
                                                }
                                                let _e1097 = phi_1203_;
                                                if _e1092 {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3500_ = true;
                                                        break;
                                                    }
                                                    let _e1099 = global_6.member[_e1091];
                                                    phi_1219_ = _e1099;
                                                } else {
                                                    phi_1219_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1101 = phi_1219_;
                                                let _e1113 = ((10u * _e245) & 31u);
                                                let _e1116 = ((_e1101.member[0] >> bitcast<u32>(_e1113)) & 1023u);
                                                let _e1124 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[0] - _e679.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                let _e1129 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1116)) - 8388608f) * _e1124)) ^ _e117)));
                                                let _e1133 = select(select(_e679.member.member_1[0], _e1129, (_e1129 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e1116 == 1023u));
                                                let _e1135 = ((10u * _e244) & 31u);
                                                let _e1138 = ((_e1101.member[0] >> bitcast<u32>(_e1135)) & 1023u);
                                                let _e1146 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[1] - _e679.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                let _e1151 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1138)) - 8388608f) * _e1146)) ^ _e117)));
                                                let _e1155 = select(select(_e679.member.member_1[1], _e1151, (_e1151 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e1138 == 1023u));
                                                let _e1157 = ((10u * _e246) & 31u);
                                                let _e1160 = ((_e1101.member[0] >> bitcast<u32>(_e1157)) & 1023u);
                                                let _e1168 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[2] - _e679.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                let _e1173 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1160)) - 8388608f) * _e1168)) ^ _e117)));
                                                let _e1177 = select(select(_e679.member.member_1[2], _e1173, (_e1173 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e1160 == 1023u));
                                                let _e1181 = ((_e1101.member[1] >> bitcast<u32>(_e1113)) & 1023u);
                                                let _e1189 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1181)) - 8388608f) * _e1124)) ^ _e117)));
                                                let _e1193 = select(select(_e679.member.member_1[0], _e1189, (_e1189 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e1181 == 1023u));
                                                let _e1196 = ((_e1101.member[1] >> bitcast<u32>(_e1135)) & 1023u);
                                                let _e1204 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1196)) - 8388608f) * _e1146)) ^ _e117)));
                                                let _e1208 = select(select(_e679.member.member_1[1], _e1204, (_e1204 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e1196 == 1023u));
                                                let _e1211 = ((_e1101.member[1] >> bitcast<u32>(_e1157)) & 1023u);
                                                let _e1219 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1211)) - 8388608f) * _e1168)) ^ _e117)));
                                                let _e1223 = select(select(_e679.member.member_1[2], _e1219, (_e1219 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e1211 == 1023u));
                                                let _e1227 = ((_e1101.member[2] >> bitcast<u32>(_e1113)) & 1023u);
                                                let _e1235 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1227)) - 8388608f) * _e1124)) ^ _e117)));
                                                let _e1239 = select(select(_e679.member.member_1[0], _e1235, (_e1235 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e1227 == 1023u));
                                                let _e1242 = ((_e1101.member[2] >> bitcast<u32>(_e1135)) & 1023u);
                                                let _e1250 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1242)) - 8388608f) * _e1146)) ^ _e117)));
                                                let _e1254 = select(select(_e679.member.member_1[1], _e1250, (_e1250 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e1242 == 1023u));
                                                let _e1257 = ((_e1101.member[2] >> bitcast<u32>(_e1157)) & 1023u);
                                                let _e1265 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1257)) - 8388608f) * _e1168)) ^ _e117)));
                                                let _e1269 = select(select(_e679.member.member_1[2], _e1265, (_e1265 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e1257 == 1023u));
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
                                                        phi_2365_ = type_21();
                                                        phi_2366_ = true;
                                                        phi_2367_ = false;
                                                    } else {
                                                        let _e1333 = select(_e1286, _e1277, (_e1277 < _e1286));
                                                        if (select(_e1295, _e1333, (_e1333 < _e1295)) > 0f) {
                                                            phi_1657_ = true;
                                                        } else {
                                                            let _e1338 = select(_e1286, _e1277, (_e1277 > _e1286));
                                                            phi_1657_ = (select(_e1295, _e1338, (_e1338 > _e1295)) < 0f);
                                                        }
                                                        let _e1343 = phi_1657_;
                                                        if _e1343 {
                                                            phi_2362_ = type_21();
                                                            phi_2363_ = true;
                                                            phi_2364_ = false;
                                                        } else {
                                                            let _e1345 = select(_e1289, _e1280, (_e1280 < _e1289));
                                                            if (select(_e1298, _e1345, (_e1345 < _e1298)) > 0f) {
                                                                phi_1686_ = true;
                                                            } else {
                                                                let _e1350 = select(_e1289, _e1280, (_e1280 > _e1289));
                                                                phi_1686_ = (select(_e1298, _e1350, (_e1350 > _e1298)) < 0f);
                                                            }
                                                            let _e1355 = phi_1686_;
                                                            if _e1355 {
                                                                phi_2360_ = type_21();
                                                                phi_2361_ = false;
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
                                                                    phi_2355_ = type_21();
                                                                    phi_2356_ = true;
                                                                } else {
                                                                    let _e1420 = (_e1418 > _e1063.member.member_1);
                                                                    if _e1420 {
                                                                        phi_2354_ = type_21();
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
                                                                            phi_2081_ = _e1289;
                                                                            phi_2082_ = _e1286;
                                                                            phi_2083_ = _e1280;
                                                                            phi_2084_ = _e1277;
                                                                            phi_2085_ = _e1421;
                                                                            phi_2086_ = _e1435;
                                                                            phi_2087_ = _e1431;
                                                                            phi_2088_ = _e1427;
                                                                        } else {
                                                                            let _e1480 = (_e1461 == _e1478);
                                                                            let _e1485 = vec3(_e1480);
                                                                            phi_2081_ = select(_e1280, _e1298, _e1480);
                                                                            phi_2082_ = select(_e1277, _e1295, _e1480);
                                                                            phi_2083_ = select(_e1298, _e1289, _e1480);
                                                                            phi_2084_ = select(_e1295, _e1286, _e1480);
                                                                            phi_2085_ = select(_e1423, _e1422, _e1485);
                                                                            phi_2086_ = select(_e1431, _e1427, _e1485);
                                                                            phi_2087_ = select(_e1427, _e1435, _e1485);
                                                                            phi_2088_ = select(_e1435, _e1431, _e1485);
                                                                        }
                                                                        let _e1491 = phi_2081_;
                                                                        let _e1493 = phi_2082_;
                                                                        let _e1495 = phi_2083_;
                                                                        let _e1497 = phi_2084_;
                                                                        let _e1499 = phi_2085_;
                                                                        let _e1501 = phi_2086_;
                                                                        let _e1503 = phi_2087_;
                                                                        let _e1505 = phi_2088_;
                                                                        let _e1512 = ((_e1503.y * _e1501.z) - (_e1501.y * _e1503.z));
                                                                        let _e1517 = ((_e1503.z * _e1501.x) - (_e1501.z * _e1503.x));
                                                                        let _e1520 = ((_e1503.x * _e1501.y) - (_e1501.x * _e1503.y));
                                                                        if (_e1320 >= _e1324) {
                                                                            phi_2125_ = select(true, false, (_e1320 >= _e1328));
                                                                        } else {
                                                                            phi_2125_ = true;
                                                                        }
                                                                        let _e1525 = phi_2125_;
                                                                        if _e1525 {
                                                                            phi_2134_ = select(_e1423, _e1422, vec3((_e1324 >= _e1328)));
                                                                        } else {
                                                                            phi_2134_ = _e1421;
                                                                        }
                                                                        let _e1530 = phi_2134_;
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
                                                                                phi_2299_ = (_e1541 / _e1546);
                                                                            } else {
                                                                                phi_2299_ = f32();
                                                                            }
                                                                            let _e1651 = phi_2299_;
                                                                            phi_2301_ = _e1651;
                                                                            phi_2302_ = select(true, false, _e1648);
                                                                        } else {
                                                                            phi_2301_ = f32();
                                                                            phi_2302_ = true;
                                                                        }
                                                                        let _e1654 = phi_2301_;
                                                                        let _e1656 = phi_2302_;
                                                                        if _e1656 {
                                                                            let _e1664 = (((_e1512 * (_e1573 - (_e349 * _e1576))) + (_e1517 * (_e1574 - (_e417 * _e1576)))) / _e1546);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u)) <= _e1478) {
                                                                                phi_2322_ = (_e1576 + _e1664);
                                                                            } else {
                                                                                phi_2322_ = _e1576;
                                                                            }
                                                                            let _e1671 = phi_2322_;
                                                                            phi_2323_ = _e1671;
                                                                        } else {
                                                                            phi_2323_ = _e1654;
                                                                        }
                                                                        let _e1673 = phi_2323_;
                                                                        let _e1675 = select(_e1411, _e1673, (_e1673 < _e1411));
                                                                        let _e1677 = select(_e1403, _e1675, (_e1675 > _e1403));
                                                                        if (_e1677 >= _e600) {
                                                                            let _e1679 = (_e1677 <= _e1063.member.member_1);
                                                                            if _e1679 {
                                                                                let _e1680 = (1f / _e1330);
                                                                                phi_2346_ = type_21(_e1677, (_e1324 * _e1680), (_e1328 * _e1680), _e1097);
                                                                            } else {
                                                                                phi_2346_ = type_21();
                                                                            }
                                                                            let _e1685 = phi_2346_;
                                                                            phi_2348_ = _e1685;
                                                                            phi_2349_ = select(true, false, _e1679);
                                                                        } else {
                                                                            phi_2348_ = type_21();
                                                                            phi_2349_ = true;
                                                                        }
                                                                        let _e1688 = phi_2348_;
                                                                        let _e1690 = phi_2349_;
                                                                        if _e1690 {
                                                                            phi_2353_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2353_ = _e1688;
                                                                        }
                                                                        let _e1692 = phi_2353_;
                                                                        phi_2354_ = _e1692;
                                                                    }
                                                                    let _e1694 = phi_2354_;
                                                                    phi_2355_ = _e1694;
                                                                    phi_2356_ = _e1420;
                                                                }
                                                                let _e1696 = phi_2355_;
                                                                let _e1698 = phi_2356_;
                                                                phi_2360_ = _e1696;
                                                                phi_2361_ = _e1698;
                                                            }
                                                            let _e1700 = phi_2360_;
                                                            let _e1702 = phi_2361_;
                                                            phi_2362_ = _e1700;
                                                            phi_2363_ = _e1355;
                                                            phi_2364_ = _e1702;
                                                        }
                                                        let _e1704 = phi_2362_;
                                                        let _e1706 = phi_2363_;
                                                        let _e1708 = phi_2364_;
                                                        phi_2365_ = _e1704;
                                                        phi_2366_ = _e1706;
                                                        phi_2367_ = _e1708;
                                                    }
                                                    let _e1710 = phi_2365_;
                                                    let _e1712 = phi_2366_;
                                                    let _e1714 = phi_2367_;
                                                    phi_2375_ = _e1710;
                                                    phi_2376_ = select(_e1714, true, _e1712);
                                                } else {
                                                    phi_2375_ = type_21();
                                                    phi_2376_ = true;
                                                }
                                                let _e1717 = phi_2375_;
                                                let _e1719 = phi_2376_;
                                                if _e1719 {
                                                    phi_2380_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2380_ = _e1717;
                                                }
                                                let _e1721 = phi_2380_;
                                                if (_e1721.member_3 != 4294967295u) {
                                                    if (_e1097 != 4294967295u) {
                                                        if (_e1721.member < _e1063.member.member.member) {
                                                            phi_2406_ = true;
                                                        } else {
                                                            if (_e1721.member == _e1063.member.member.member) {
                                                                phi_2405_ = (_e1721.member_3 < _e1063.member.member.member_3);
                                                            } else {
                                                                phi_2405_ = false;
                                                            }
                                                            let _e1736 = phi_2405_;
                                                            phi_2406_ = _e1736;
                                                        }
                                                        let _e1738 = phi_2406_;
                                                        if _e1738 {
                                                            phi_2413_ = type_33(type_28(_e1721, _e1721.member), _e1090.member_1, _e1090.member_2);
                                                        } else {
                                                            phi_2413_ = _e1090;
                                                        }
                                                        let _e1745 = phi_2413_;
                                                        phi_2414_ = _e1745;
                                                    } else {
                                                        phi_2414_ = _e1090;
                                                    }
                                                    let _e1747 = phi_2414_;
                                                    phi_2415_ = _e1747;
                                                } else {
                                                    phi_2415_ = _e1090;
                                                }
                                                let _e1749 = phi_2415_;
                                                phi_1150_ = _e1749;
                                            } else {
                                                phi_1150_ = type_33();
                                            }
                                            let _e1751 = phi_1150_;
                                            continue;
                                            continuing {
                                                phi_1149_ = _e1751;
                                                phi_1152_ = _e1078;
                                                phi_3500_ = _e633;
                                                break if !(_e1084);
                                            }
                                        }
                                        let _e1754 = phi_3500_;
                                        phi_3678_ = _e1754;
                                        if _e1754 {
                                            break;
                                        }
                                        phi_3682_ = _e1754;
                                        let _e1925 = local_12;
                                        phi_3432_ = _e1925;
                                        phi_3433_ = false;
                                        phi_3434_ = _e677;
                                        phi_3435_ = _e679;
                                    } else {
                                        let _e689 = (_e679.member_1 < _e82);
                                        if _e689 {
                                            if _e689 {
                                            } else {
                                                phi_3678_ = true;
                                                break;
                                            }
                                            let _e691 = global_4.member[_e679.member_1];
                                            phi_2441_ = _e691;
                                        } else {
                                            phi_2441_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e693 = phi_2441_;
                                        let _e708 = ((10u * _e245) & 31u);
                                        let _e711 = ((_e693.member[0] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e719 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[0] - _e679.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e724 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e711)) - 8388608f) * _e719)) ^ _e117)));
                                        let _e728 = select(select(_e679.member.member_1[0], _e724, (_e724 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e711 == 1023u));
                                        let _e730 = ((10u * _e244) & 31u);
                                        let _e733 = ((_e693.member[0] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e741 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[1] - _e679.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e746 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e733)) - 8388608f) * _e741)) ^ _e117)));
                                        let _e750 = select(select(_e679.member.member_1[1], _e746, (_e746 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e733 == 1023u));
                                        let _e752 = ((10u * _e246) & 31u);
                                        let _e755 = ((_e693.member[0] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e763 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[2] - _e679.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e768 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e755)) - 8388608f) * _e763)) ^ _e117)));
                                        let _e772 = select(select(_e679.member.member_1[2], _e768, (_e768 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e755 == 1023u));
                                        let _e775 = ((_e693.member[1] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e783 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e775)) - 8388608f) * _e719)) ^ _e117)));
                                        let _e787 = select(select(_e679.member.member_1[0], _e783, (_e783 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e775 == 1023u));
                                        let _e790 = ((_e693.member[1] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e798 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e790)) - 8388608f) * _e741)) ^ _e117)));
                                        let _e802 = select(select(_e679.member.member_1[1], _e798, (_e798 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e790 == 1023u));
                                        let _e805 = ((_e693.member[1] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e813 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e805)) - 8388608f) * _e763)) ^ _e117)));
                                        let _e817 = select(select(_e679.member.member_1[2], _e813, (_e813 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e805 == 1023u));
                                        let _e823 = ((_e693.member_1[0] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e831 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e823)) - 8388608f) * _e719)) ^ _e117)));
                                        let _e835 = select(select(_e679.member.member_1[0], _e831, (_e831 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e823 == 1023u));
                                        let _e838 = ((_e693.member_1[0] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e846 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e838)) - 8388608f) * _e741)) ^ _e117)));
                                        let _e850 = select(select(_e679.member.member_1[1], _e846, (_e846 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e838 == 1023u));
                                        let _e853 = ((_e693.member_1[0] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e861 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e853)) - 8388608f) * _e763)) ^ _e117)));
                                        let _e865 = select(select(_e679.member.member_1[2], _e861, (_e861 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e853 == 1023u));
                                        let _e868 = ((_e693.member_1[1] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e876 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e868)) - 8388608f) * _e719)) ^ _e117)));
                                        let _e880 = select(select(_e679.member.member_1[0], _e876, (_e876 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e868 == 1023u));
                                        let _e883 = ((_e693.member_1[1] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e891 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e883)) - 8388608f) * _e741)) ^ _e117)));
                                        let _e895 = select(select(_e679.member.member_1[1], _e891, (_e891 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e883 == 1023u));
                                        let _e898 = ((_e693.member_1[1] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e906 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e898)) - 8388608f) * _e763)) ^ _e117)));
                                        let _e910 = select(select(_e679.member.member_1[2], _e906, (_e906 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e898 == 1023u));
                                        let _e915 = type_50(type_42(array<f32, 3>(_e728, _e750, _e772), array<f32, 3>(_e787, _e802, _e817)), _e693.member_2);
                                        let _e920 = type_50(type_42(array<f32, 3>(_e835, _e850, _e865), array<f32, 3>(_e880, _e895, _e910)), _e693.member_3);
                                        let _e933 = ((_e728 - _e347) * _e352);
                                        let _e934 = ((_e835 - _e347) * _e352);
                                        let _e935 = ((_e787 - _e348) * _e352);
                                        let _e936 = ((_e880 - _e348) * _e352);
                                        let _e941 = ((_e750 - _e415) * _e420);
                                        let _e942 = ((_e850 - _e415) * _e420);
                                        let _e943 = ((_e802 - _e416) * _e420);
                                        let _e944 = ((_e895 - _e416) * _e420);
                                        let _e949 = ((_e772 - _e483) * _e488);
                                        let _e950 = ((_e865 - _e483) * _e488);
                                        let _e951 = ((_e817 - _e484) * _e488);
                                        let _e952 = ((_e910 - _e484) * _e488);
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
                                                    phi_3330_ = _e920;
                                                } else {
                                                    phi_3330_ = _e915;
                                                }
                                                let _e1015 = phi_3330_;
                                                let _e1023 = (_e677 % 128u);
                                                let _e1024 = (_e1023 < 128u);
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local_6[_e1023] = _e1015.member_1;
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local_5[_e1023] = _e1015.member.member[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local_4[_e1023] = _e1015.member.member[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local_3[_e1023] = _e1015.member.member[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local_2[_e1023] = _e1015.member.member_1[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local_1[_e1023] = _e1015.member.member_1[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local[_e1023] = _e1015.member.member_1[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3678_ = true;
                                                    break;
                                                }
                                                local_7[_e1023] = select(_e1006, _e1004, !(_e1013));
                                                if _e1013 {
                                                    phi_3407_ = _e915;
                                                } else {
                                                    phi_3407_ = _e920;
                                                }
                                                let _e1041 = phi_3407_;
                                                phi_3408_ = (_e677 + 1u);
                                                phi_3409_ = _e1041;
                                            } else {
                                                phi_3408_ = u32();
                                                phi_3409_ = type_50();
                                            }
                                            let _e1043 = phi_3408_;
                                            let _e1045 = phi_3409_;
                                            phi_3411_ = _e1043;
                                            phi_3412_ = _e1045;
                                            phi_3413_ = select(true, false, _e1012);
                                        } else {
                                            phi_3411_ = u32();
                                            phi_3412_ = type_50();
                                            phi_3413_ = true;
                                        }
                                        let _e1048 = phi_3411_;
                                        let _e1050 = phi_3412_;
                                        let _e1052 = phi_3413_;
                                        if _e1052 {
                                            if _e1011 {
                                                phi_3420_ = _e915;
                                            } else {
                                                phi_3420_ = _e920;
                                            }
                                            let _e1054 = phi_3420_;
                                            phi_3425_ = select(_e1012, true, _e1011);
                                            phi_3427_ = _e1054;
                                        } else {
                                            phi_3425_ = _e675;
                                            phi_3427_ = _e1050;
                                        }
                                        let _e1057 = phi_3425_;
                                        let _e1059 = phi_3427_;
                                        phi_3682_ = _e633;
                                        phi_3432_ = type_33(_e635.member, (_e635.member_1 + 1u), _e635.member_2);
                                        phi_3433_ = _e1057;
                                        phi_3434_ = select(_e1048, _e677, _e1052);
                                        phi_3435_ = _e1059;
                                    }
                                    let _e1756 = phi_3682_;
                                    let _e1758 = phi_3432_;
                                    let _e1760 = phi_3433_;
                                    let _e1762 = phi_3434_;
                                    let _e1764 = phi_3435_;
                                    phi_3681_ = _e1756;
                                    phi_3436_ = _e1758;
                                    phi_3437_ = _e1760;
                                    phi_3438_ = (_e639 - 1u);
                                    phi_3439_ = _e1762;
                                    phi_3440_ = _e1764;
                                } else {
                                    phi_3681_ = _e633;
                                    phi_3436_ = _e635;
                                    phi_3437_ = _e675;
                                    phi_3438_ = _e639;
                                    phi_3439_ = _e677;
                                    phi_3440_ = _e679;
                                }
                                let _e1766 = phi_3681_;
                                let _e1768 = phi_3436_;
                                let _e1770 = phi_3437_;
                                let _e1772 = phi_3438_;
                                let _e1774 = phi_3439_;
                                let _e1776 = phi_3440_;
                                phi_3680_ = _e1766;
                                phi_3441_ = _e1768;
                                phi_3442_ = _e1770;
                                phi_3443_ = _e1772;
                                phi_3444_ = _e1774;
                                phi_3445_ = _e1776;
                            } else {
                                phi_3680_ = _e633;
                                phi_3441_ = type_33();
                                phi_3442_ = bool();
                                phi_3443_ = u32();
                                phi_3444_ = u32();
                                phi_3445_ = type_50();
                            }
                            let _e1778 = phi_3680_;
                            let _e1780 = phi_3441_;
                            let _e1782 = phi_3442_;
                            let _e1784 = phi_3443_;
                            let _e1786 = phi_3444_;
                            let _e1788 = phi_3445_;
                            phi_3679_ = _e1778;
                            phi_1023_ = _e1780;
                            phi_1026_ = _e1782;
                            phi_1028_ = _e1784;
                            phi_1030_ = _e1786;
                            phi_1032_ = _e1788;
                            phi_3446_ = _e647;
                        } else {
                            phi_3679_ = _e633;
                            phi_1023_ = type_33();
                            phi_1026_ = bool();
                            phi_1028_ = u32();
                            phi_1030_ = u32();
                            phi_1032_ = type_50();
                            phi_3446_ = false;
                        }
                        let _e1790 = phi_3679_;
                        let _e1792 = phi_1023_;
                        let _e1794 = phi_1026_;
                        let _e1796 = phi_1028_;
                        let _e1798 = phi_1030_;
                        let _e1800 = phi_1032_;
                        let _e1802 = phi_3446_;
                        continue;
                        continuing {
                            phi_3506_ = _e1790;
                            phi_1022_ = _e1792;
                            phi_1025_ = _e1794;
                            phi_1027_ = _e1796;
                            phi_1029_ = _e1798;
                            phi_1031_ = _e1800;
                            phi_3678_ = _e1790;
                            break if !(_e1802);
                        }
                    }
                    let _e1805 = phi_3678_;
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
