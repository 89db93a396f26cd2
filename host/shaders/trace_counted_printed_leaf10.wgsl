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
    var phi_3512_: bool;
    var phi_1022_: type_33;
    var phi_1025_: u32;
    var phi_1027_: bool;
    var phi_1029_: u32;
    var phi_1031_: type_50;
    var phi_1042_: bool;
    var phi_1128_: bool;
    var phi_1129_: u32;
    var phi_1130_: type_50;
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
    var phi_3506_: bool;
    var phi_3743_: bool;
    var phi_2416_: type_33;
    var phi_2437_: type_37;
    var phi_3326_: type_50;
    var phi_3402_: type_50;
    var phi_3403_: u32;
    var phi_3404_: type_50;
    var phi_3406_: u32;
    var phi_3407_: type_50;
    var phi_3408_: bool;
    var phi_3415_: type_50;
    var phi_3420_: bool;
    var phi_3422_: type_50;
    var phi_3427_: type_33;
    var phi_3428_: bool;
    var phi_3429_: u32;
    var phi_3430_: type_50;
    var phi_3438_: type_33;
    var phi_3441_: type_50;
    var phi_3687_: bool;
    var phi_3442_: type_33;
    var phi_3443_: u32;
    var phi_3444_: bool;
    var phi_3445_: u32;
    var phi_3446_: type_50;
    var phi_3686_: bool;
    var phi_3447_: type_33;
    var phi_3448_: u32;
    var phi_3449_: bool;
    var phi_3450_: u32;
    var phi_3451_: type_50;
    var phi_3685_: bool;
    var phi_1023_: type_33;
    var phi_1026_: u32;
    var phi_1028_: bool;
    var phi_1030_: u32;
    var phi_1032_: type_50;
    var phi_3452_: bool;
    var phi_3684_: bool;
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
                    phi_3512_ = false;
                    phi_1022_ = type_33(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e598), 0u, 0u);
                    phi_1025_ = ((3u * _e82) + 1u);
                    phi_1027_ = (_e600 <= _e598);
                    phi_1029_ = 0u;
                    phi_1031_ = type_50(type_42(array<f32, 3>(_e609, _e613, _e617), array<f32, 3>(_e621, _e623, _e625)), select(0u, 2147483648u, (_e82 == 0u)));
                    loop {
                        let _e633 = phi_3512_;
                        let _e635 = phi_1022_;
                        let _e637 = phi_1025_;
                        let _e639 = phi_1027_;
                        let _e641 = phi_1029_;
                        let _e643 = phi_1031_;
                        local_10 = _e635;
                        local_11 = _e635;
                        if _e639 {
                            phi_1042_ = true;
                        } else {
                            phi_1042_ = (_e641 > 0u);
                        }
                        let _e646 = phi_1042_;
                        if _e646 {
                            let _e647 = (_e637 > 0u);
                            if _e647 {
                                if _e639 {
                                    phi_1128_ = _e639;
                                    phi_1129_ = _e641;
                                    phi_1130_ = _e643;
                                } else {
                                    let _e648 = (_e641 - 1u);
                                    let _e649 = (_e648 % 128u);
                                    let _e650 = (_e649 < 128u);
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
                                        break;
                                    }
                                    let _e652 = local_6[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
                                        break;
                                    }
                                    let _e654 = local_5[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
                                        break;
                                    }
                                    let _e656 = local_4[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
                                        break;
                                    }
                                    let _e658 = local_3[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
                                        break;
                                    }
                                    let _e661 = local_2[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
                                        break;
                                    }
                                    let _e663 = local_1[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
                                        break;
                                    }
                                    let _e665 = local[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3684_ = true;
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
                                    let _e683 = ((_e679.member_1 & 2147483648u) != 0u);
                                    if _e683 {
                                        phi_1149_ = _e635;
                                        phi_1152_ = type_4(0u, ((_e679.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e691 = phi_1149_;
                                            let _e693 = phi_1152_;
                                            local_12 = _e691;
                                            if (_e693.member < _e693.member_1) {
                                                phi_1153_ = type_4((_e693.member + 1u), _e693.member_1);
                                                phi_1175_ = type_4(1u, _e693.member);
                                            } else {
                                                phi_1153_ = _e693;
                                                phi_1175_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e706 = phi_1153_;
                                            let _e708 = phi_1175_;
                                            let _e712 = (bitcast<i32>(_e708.member) != 0i);
                                            if _e712 {
                                                let _e718 = type_33(_e691.member, _e691.member_1, (_e691.member_2 + 1u));
                                                let _e719 = ((_e679.member_1 & 268435455u) + _e708.member_1);
                                                let _e720 = (_e719 < arrayLength((&global_6.member)));
                                                if _e720 {
                                                    if _e720 {
                                                    } else {
                                                        phi_3506_ = true;
                                                        break;
                                                    }
                                                    let _e723 = global_6.member[_e719].member_1;
                                                    phi_1203_ = _e723;
                                                } else {
                                                    phi_1203_ = 4294967295u;
                                                }
                                                let _e725 = phi_1203_;
                                                if _e720 {
                                                    if _e720 {
                                                    } else {
                                                        phi_3506_ = true;
                                                        break;
                                                    }
                                                    let _e727 = global_6.member[_e719];
                                                    phi_1219_ = _e727;
                                                } else {
                                                    phi_1219_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e729 = phi_1219_;
                                                let _e741 = ((10u * _e245) & 31u);
                                                let _e744 = ((_e729.member[0] >> bitcast<u32>(_e741)) & 1023u);
                                                let _e752 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[0] - _e679.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                let _e757 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e744)) - 8388608f) * _e752)) ^ _e117)));
                                                let _e761 = select(select(_e679.member.member_1[0], _e757, (_e757 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e744 == 1023u));
                                                let _e763 = ((10u * _e244) & 31u);
                                                let _e766 = ((_e729.member[0] >> bitcast<u32>(_e763)) & 1023u);
                                                let _e774 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[1] - _e679.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                let _e779 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e766)) - 8388608f) * _e774)) ^ _e117)));
                                                let _e783 = select(select(_e679.member.member_1[1], _e779, (_e779 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e766 == 1023u));
                                                let _e785 = ((10u * _e246) & 31u);
                                                let _e788 = ((_e729.member[0] >> bitcast<u32>(_e785)) & 1023u);
                                                let _e796 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[2] - _e679.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                let _e801 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e796)) ^ _e117)));
                                                let _e805 = select(select(_e679.member.member_1[2], _e801, (_e801 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e788 == 1023u));
                                                let _e809 = ((_e729.member[1] >> bitcast<u32>(_e741)) & 1023u);
                                                let _e817 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e809)) - 8388608f) * _e752)) ^ _e117)));
                                                let _e821 = select(select(_e679.member.member_1[0], _e817, (_e817 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e809 == 1023u));
                                                let _e824 = ((_e729.member[1] >> bitcast<u32>(_e763)) & 1023u);
                                                let _e832 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e824)) - 8388608f) * _e774)) ^ _e117)));
                                                let _e836 = select(select(_e679.member.member_1[1], _e832, (_e832 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e824 == 1023u));
                                                let _e839 = ((_e729.member[1] >> bitcast<u32>(_e785)) & 1023u);
                                                let _e847 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e796)) ^ _e117)));
                                                let _e851 = select(select(_e679.member.member_1[2], _e847, (_e847 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e839 == 1023u));
                                                let _e855 = ((_e729.member[2] >> bitcast<u32>(_e741)) & 1023u);
                                                let _e863 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e855)) - 8388608f) * _e752)) ^ _e117)));
                                                let _e867 = select(select(_e679.member.member_1[0], _e863, (_e863 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e855 == 1023u));
                                                let _e870 = ((_e729.member[2] >> bitcast<u32>(_e763)) & 1023u);
                                                let _e878 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e870)) - 8388608f) * _e774)) ^ _e117)));
                                                let _e882 = select(select(_e679.member.member_1[1], _e878, (_e878 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e870 == 1023u));
                                                let _e885 = ((_e729.member[2] >> bitcast<u32>(_e785)) & 1023u);
                                                let _e893 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e885)) - 8388608f) * _e796)) ^ _e117)));
                                                let _e897 = select(select(_e679.member.member_1[2], _e893, (_e893 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e885 == 1023u));
                                                let _e902 = (_e805 - _e446);
                                                let _e905 = (((_e761 - _e309) * _e485) - (_e902 * _e349));
                                                let _e908 = (((_e783 - _e378) * _e485) - (_e902 * _e417));
                                                let _e911 = (_e851 - _e446);
                                                let _e914 = (((_e821 - _e309) * _e485) - (_e911 * _e349));
                                                let _e917 = (((_e836 - _e378) * _e485) - (_e911 * _e417));
                                                let _e920 = (_e897 - _e446);
                                                let _e923 = (((_e867 - _e309) * _e485) - (_e920 * _e349));
                                                let _e926 = (((_e882 - _e378) * _e485) - (_e920 * _e417));
                                                let _e927 = (_e923 * _e917);
                                                let _e928 = (_e926 * _e914);
                                                let _e929 = (_e905 * _e926);
                                                let _e930 = (_e908 * _e923);
                                                let _e931 = (_e914 * _e908);
                                                let _e932 = (_e917 * _e905);
                                                let _e937 = (((_e927 >= _e928) && (_e929 >= _e930)) && (_e931 >= _e932));
                                                if (_e937 || (((_e927 <= _e928) && (_e929 <= _e930)) && (_e931 <= _e932))) {
                                                    let _e944 = select(-1f, 1f, _e937);
                                                    let _e946 = ((_e927 - _e928) * _e944);
                                                    let _e948 = select(0f, _e946, (_e946 > 0f));
                                                    let _e950 = ((_e929 - _e930) * _e944);
                                                    let _e952 = select(0f, _e950, (_e950 > 0f));
                                                    let _e954 = ((_e931 - _e932) * _e944);
                                                    let _e956 = select(0f, _e954, (_e954 > 0f));
                                                    let _e958 = ((_e948 + _e952) + _e956);
                                                    if (_e958 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2365_ = type_21();
                                                        phi_2366_ = true;
                                                        phi_2367_ = false;
                                                    } else {
                                                        let _e961 = select(_e914, _e905, (_e905 < _e914));
                                                        if (select(_e923, _e961, (_e961 < _e923)) > 0f) {
                                                            phi_1657_ = true;
                                                        } else {
                                                            let _e966 = select(_e914, _e905, (_e905 > _e914));
                                                            phi_1657_ = (select(_e923, _e966, (_e966 > _e923)) < 0f);
                                                        }
                                                        let _e971 = phi_1657_;
                                                        if _e971 {
                                                            phi_2362_ = type_21();
                                                            phi_2363_ = true;
                                                            phi_2364_ = false;
                                                        } else {
                                                            let _e973 = select(_e917, _e908, (_e908 < _e917));
                                                            if (select(_e926, _e973, (_e973 < _e926)) > 0f) {
                                                                phi_1686_ = true;
                                                            } else {
                                                                let _e978 = select(_e917, _e908, (_e908 > _e917));
                                                                phi_1686_ = (select(_e926, _e978, (_e978 > _e926)) < 0f);
                                                            }
                                                            let _e983 = phi_1686_;
                                                            if _e983 {
                                                                phi_2360_ = type_21();
                                                                phi_2361_ = false;
                                                            } else {
                                                                let _e985 = select(_e821, _e761, (_e761 < _e821));
                                                                let _e989 = select(_e821, _e761, (_e761 > _e821));
                                                                let _e993 = select(_e836, _e783, (_e783 < _e836));
                                                                let _e997 = select(_e836, _e783, (_e783 > _e836));
                                                                let _e1001 = select(_e851, _e805, (_e805 < _e851));
                                                                let _e1005 = select(_e851, _e805, (_e805 > _e851));
                                                                let _e1010 = ((select(_e867, _e985, (_e985 < _e867)) - _e347) * _e352);
                                                                let _e1011 = ((select(_e867, _e989, (_e989 > _e867)) - _e348) * _e352);
                                                                let _e1014 = ((select(_e882, _e993, (_e993 < _e882)) - _e415) * _e420);
                                                                let _e1015 = ((select(_e882, _e997, (_e997 > _e882)) - _e416) * _e420);
                                                                let _e1018 = ((select(_e897, _e1001, (_e1001 < _e897)) - _e483) * _e488);
                                                                let _e1019 = ((select(_e897, _e1005, (_e1005 > _e897)) - _e484) * _e488);
                                                                let _e1021 = select(_e1019, _e1018, (_e1018 < _e1019));
                                                                let _e1023 = select(_e1019, _e1018, (_e1018 > _e1019));
                                                                let _e1025 = select(_e1011, _e1010, (_e1010 < _e1011));
                                                                let _e1027 = select(_e1015, _e1014, (_e1014 < _e1015));
                                                                let _e1029 = select(_e1027, _e1025, (_e1025 > _e1027));
                                                                let _e1031 = select(_e1021, _e1029, (_e1029 > _e1021));
                                                                let _e1033 = select(_e1011, _e1010, (_e1010 > _e1011));
                                                                let _e1035 = select(_e1015, _e1014, (_e1014 > _e1015));
                                                                let _e1037 = select(_e1035, _e1033, (_e1033 < _e1035));
                                                                let _e1039 = select(_e1023, _e1037, (_e1037 < _e1023));
                                                                let _e1040 = -(_e1021);
                                                                let _e1046 = select(_e600, _e1031, (_e1031 > _e600));
                                                                if (_e1046 > (_e1039 + (select(_e1040, _e1023, (_e1023 > _e1040)) * 0.0000019073523f))) {
                                                                    phi_2355_ = type_21();
                                                                    phi_2356_ = true;
                                                                } else {
                                                                    let _e1048 = (_e1046 > _e691.member.member_1);
                                                                    if _e1048 {
                                                                        phi_2354_ = type_21();
                                                                    } else {
                                                                        let _e1049 = vec3<f32>(_e761, _e783, _e805);
                                                                        let _e1050 = vec3<f32>(_e821, _e836, _e851);
                                                                        let _e1051 = vec3<f32>(_e867, _e882, _e897);
                                                                        let _e1052 = (_e821 - _e761);
                                                                        let _e1053 = (_e836 - _e783);
                                                                        let _e1054 = (_e851 - _e805);
                                                                        let _e1055 = vec3<f32>(_e1052, _e1053, _e1054);
                                                                        let _e1056 = (_e867 - _e821);
                                                                        let _e1057 = (_e882 - _e836);
                                                                        let _e1058 = (_e897 - _e851);
                                                                        let _e1059 = vec3<f32>(_e1056, _e1057, _e1058);
                                                                        let _e1060 = (_e761 - _e867);
                                                                        let _e1061 = (_e783 - _e882);
                                                                        let _e1062 = (_e805 - _e897);
                                                                        let _e1063 = vec3<f32>(_e1060, _e1061, _e1062);
                                                                        let _e1066 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                        let _e1069 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                                        let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                                                                        let _e1074 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                        let _e1076 = select(_e1074, _e1071, (_e1071 > _e1074));
                                                                        let _e1079 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                        let _e1082 = bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u));
                                                                        let _e1084 = select(_e1082, _e1079, (_e1079 > _e1082));
                                                                        let _e1087 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                        let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                                                                        let _e1092 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1095 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                                                        let _e1097 = select(_e1095, _e1092, (_e1092 > _e1095));
                                                                        let _e1100 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                                        let _e1102 = select(_e1100, _e1097, (_e1097 > _e1100));
                                                                        let _e1104 = select(_e1089, _e1076, (_e1076 > _e1089));
                                                                        let _e1106 = select(_e1102, _e1104, (_e1104 > _e1102));
                                                                        if (_e1076 == _e1106) {
                                                                            phi_2081_ = _e917;
                                                                            phi_2082_ = _e914;
                                                                            phi_2083_ = _e908;
                                                                            phi_2084_ = _e905;
                                                                            phi_2085_ = _e1049;
                                                                            phi_2086_ = _e1063;
                                                                            phi_2087_ = _e1059;
                                                                            phi_2088_ = _e1055;
                                                                        } else {
                                                                            let _e1108 = (_e1089 == _e1106);
                                                                            let _e1113 = vec3(_e1108);
                                                                            phi_2081_ = select(_e908, _e926, _e1108);
                                                                            phi_2082_ = select(_e905, _e923, _e1108);
                                                                            phi_2083_ = select(_e926, _e917, _e1108);
                                                                            phi_2084_ = select(_e923, _e914, _e1108);
                                                                            phi_2085_ = select(_e1051, _e1050, _e1113);
                                                                            phi_2086_ = select(_e1059, _e1055, _e1113);
                                                                            phi_2087_ = select(_e1055, _e1063, _e1113);
                                                                            phi_2088_ = select(_e1063, _e1059, _e1113);
                                                                        }
                                                                        let _e1119 = phi_2081_;
                                                                        let _e1121 = phi_2082_;
                                                                        let _e1123 = phi_2083_;
                                                                        let _e1125 = phi_2084_;
                                                                        let _e1127 = phi_2085_;
                                                                        let _e1129 = phi_2086_;
                                                                        let _e1131 = phi_2087_;
                                                                        let _e1133 = phi_2088_;
                                                                        let _e1140 = ((_e1131.y * _e1129.z) - (_e1129.y * _e1131.z));
                                                                        let _e1145 = ((_e1131.z * _e1129.x) - (_e1129.z * _e1131.x));
                                                                        let _e1148 = ((_e1131.x * _e1129.y) - (_e1129.x * _e1131.y));
                                                                        if (_e948 >= _e952) {
                                                                            phi_2125_ = select(true, false, (_e948 >= _e956));
                                                                        } else {
                                                                            phi_2125_ = true;
                                                                        }
                                                                        let _e1153 = phi_2125_;
                                                                        if _e1153 {
                                                                            phi_2134_ = select(_e1051, _e1050, vec3((_e952 >= _e956)));
                                                                        } else {
                                                                            phi_2134_ = _e1049;
                                                                        }
                                                                        let _e1158 = phi_2134_;
                                                                        let _e1169 = (((_e1140 * (_e1158.x - _e309)) + (_e1145 * (_e1158.y - _e378))) + (_e1148 * (_e1158.z - _e446)));
                                                                        let _e1174 = (((_e1140 * _e349) + (_e1145 * _e417)) + (_e1148 * _e485));
                                                                        let _e1175 = (_e1121 - _e1125);
                                                                        let _e1176 = (_e1119 - _e1123);
                                                                        let _e1184 = (-(((_e1125 * _e1175) + (_e1123 * _e1176))) / ((_e1175 * _e1175) + (_e1176 * _e1176)));
                                                                        let _e1186 = select(1f, _e1184, (_e1184 < 1f));
                                                                        let _e1188 = select(0f, _e1186, (_e1186 > 0f));
                                                                        let _e1201 = ((_e1127.x + (_e1133.x * _e1188)) - _e309);
                                                                        let _e1202 = ((_e1127.y + (_e1133.y * _e1188)) - _e378);
                                                                        let _e1203 = ((_e1127.z + (_e1133.z * _e1188)) - _e446);
                                                                        let _e1204 = (_e1203 / _e485);
                                                                        let _e1216 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                        let _e1219 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                        let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                                        let _e1224 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                        let _e1226 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                                        let _e1232 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                                        let _e1235 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                        let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                                        let _e1240 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1140 * _e1201) + (_e1145 * _e1202)) + (_e1148 * _e1203)) - _e1169)) & 2147483647u)) <= ((0.0000009536743f * select(_e1106, _e1226, (_e1226 > _e1106))) * select(_e1240, _e1237, (_e1237 > _e1240)))) {
                                                                            let _e1250 = bitcast<f32>((bitcast<u32>(_e1131.x) & 2147483647u));
                                                                            let _e1253 = bitcast<f32>((bitcast<u32>(_e1131.y) & 2147483647u));
                                                                            let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                            let _e1258 = bitcast<f32>((bitcast<u32>(_e1131.z) & 2147483647u));
                                                                            let _e1264 = bitcast<f32>((bitcast<u32>(_e1129.x) & 2147483647u));
                                                                            let _e1267 = bitcast<f32>((bitcast<u32>(_e1129.y) & 2147483647u));
                                                                            let _e1269 = select(_e1267, _e1264, (_e1264 > _e1267));
                                                                            let _e1272 = bitcast<f32>((bitcast<u32>(_e1129.z) & 2147483647u));
                                                                            let _e1276 = (bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u)) > ((0.0000038146973f * select(_e1258, _e1255, (_e1255 > _e1258))) * select(_e1272, _e1269, (_e1269 > _e1272))));
                                                                            if _e1276 {
                                                                                phi_2299_ = (_e1169 / _e1174);
                                                                            } else {
                                                                                phi_2299_ = f32();
                                                                            }
                                                                            let _e1279 = phi_2299_;
                                                                            phi_2301_ = _e1279;
                                                                            phi_2302_ = select(true, false, _e1276);
                                                                        } else {
                                                                            phi_2301_ = f32();
                                                                            phi_2302_ = true;
                                                                        }
                                                                        let _e1282 = phi_2301_;
                                                                        let _e1284 = phi_2302_;
                                                                        if _e1284 {
                                                                            let _e1292 = (((_e1140 * (_e1201 - (_e349 * _e1204))) + (_e1145 * (_e1202 - (_e417 * _e1204)))) / _e1174);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u)) <= _e1106) {
                                                                                phi_2322_ = (_e1204 + _e1292);
                                                                            } else {
                                                                                phi_2322_ = _e1204;
                                                                            }
                                                                            let _e1299 = phi_2322_;
                                                                            phi_2323_ = _e1299;
                                                                        } else {
                                                                            phi_2323_ = _e1282;
                                                                        }
                                                                        let _e1301 = phi_2323_;
                                                                        let _e1303 = select(_e1039, _e1301, (_e1301 < _e1039));
                                                                        let _e1305 = select(_e1031, _e1303, (_e1303 > _e1031));
                                                                        if (_e1305 >= _e600) {
                                                                            let _e1307 = (_e1305 <= _e691.member.member_1);
                                                                            if _e1307 {
                                                                                let _e1308 = (1f / _e958);
                                                                                phi_2346_ = type_21(_e1305, (_e952 * _e1308), (_e956 * _e1308), _e725);
                                                                            } else {
                                                                                phi_2346_ = type_21();
                                                                            }
                                                                            let _e1313 = phi_2346_;
                                                                            phi_2348_ = _e1313;
                                                                            phi_2349_ = select(true, false, _e1307);
                                                                        } else {
                                                                            phi_2348_ = type_21();
                                                                            phi_2349_ = true;
                                                                        }
                                                                        let _e1316 = phi_2348_;
                                                                        let _e1318 = phi_2349_;
                                                                        if _e1318 {
                                                                            phi_2353_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2353_ = _e1316;
                                                                        }
                                                                        let _e1320 = phi_2353_;
                                                                        phi_2354_ = _e1320;
                                                                    }
                                                                    let _e1322 = phi_2354_;
                                                                    phi_2355_ = _e1322;
                                                                    phi_2356_ = _e1048;
                                                                }
                                                                let _e1324 = phi_2355_;
                                                                let _e1326 = phi_2356_;
                                                                phi_2360_ = _e1324;
                                                                phi_2361_ = _e1326;
                                                            }
                                                            let _e1328 = phi_2360_;
                                                            let _e1330 = phi_2361_;
                                                            phi_2362_ = _e1328;
                                                            phi_2363_ = _e983;
                                                            phi_2364_ = _e1330;
                                                        }
                                                        let _e1332 = phi_2362_;
                                                        let _e1334 = phi_2363_;
                                                        let _e1336 = phi_2364_;
                                                        phi_2365_ = _e1332;
                                                        phi_2366_ = _e1334;
                                                        phi_2367_ = _e1336;
                                                    }
                                                    let _e1338 = phi_2365_;
                                                    let _e1340 = phi_2366_;
                                                    let _e1342 = phi_2367_;
                                                    phi_2375_ = _e1338;
                                                    phi_2376_ = select(_e1342, true, _e1340);
                                                } else {
                                                    phi_2375_ = type_21();
                                                    phi_2376_ = true;
                                                }
                                                let _e1345 = phi_2375_;
                                                let _e1347 = phi_2376_;
                                                if _e1347 {
                                                    phi_2380_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2380_ = _e1345;
                                                }
                                                let _e1349 = phi_2380_;
                                                if (_e1349.member_3 != 4294967295u) {
                                                    if (_e725 != 4294967295u) {
                                                        if (_e1349.member < _e691.member.member.member) {
                                                            phi_2406_ = true;
                                                        } else {
                                                            if (_e1349.member == _e691.member.member.member) {
                                                                phi_2405_ = (_e1349.member_3 < _e691.member.member.member_3);
                                                            } else {
                                                                phi_2405_ = false;
                                                            }
                                                            let _e1364 = phi_2405_;
                                                            phi_2406_ = _e1364;
                                                        }
                                                        let _e1366 = phi_2406_;
                                                        if _e1366 {
                                                            phi_2413_ = type_33(type_28(_e1349, _e1349.member), _e718.member_1, _e718.member_2);
                                                        } else {
                                                            phi_2413_ = _e718;
                                                        }
                                                        let _e1373 = phi_2413_;
                                                        phi_2414_ = _e1373;
                                                    } else {
                                                        phi_2414_ = _e718;
                                                    }
                                                    let _e1375 = phi_2414_;
                                                    phi_2415_ = _e1375;
                                                } else {
                                                    phi_2415_ = _e718;
                                                }
                                                let _e1377 = phi_2415_;
                                                phi_1150_ = _e1377;
                                            } else {
                                                phi_1150_ = type_33();
                                            }
                                            let _e1379 = phi_1150_;
                                            continue;
                                            continuing {
                                                phi_1149_ = _e1379;
                                                phi_1152_ = _e706;
                                                phi_3506_ = _e633;
                                                break if !(_e712);
                                            }
                                        }
                                        let _e1382 = phi_3506_;
                                        phi_3684_ = _e1382;
                                        if _e1382 {
                                            break;
                                        }
                                        phi_3743_ = _e1382;
                                        let _e1921 = local_12;
                                        phi_2416_ = _e1921;
                                    } else {
                                        phi_3743_ = _e633;
                                        phi_2416_ = _e635;
                                    }
                                    let _e1384 = phi_3743_;
                                    let _e1386 = phi_2416_;
                                    if _e683 {
                                        phi_3427_ = type_33();
                                        phi_3428_ = bool();
                                        phi_3429_ = u32();
                                        phi_3430_ = type_50();
                                    } else {
                                        let _e1387 = (_e679.member_1 < _e82);
                                        if _e1387 {
                                            if _e1387 {
                                            } else {
                                                phi_3684_ = true;
                                                break;
                                            }
                                            let _e1389 = global_4.member[_e679.member_1];
                                            phi_2437_ = _e1389;
                                        } else {
                                            phi_2437_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1391 = phi_2437_;
                                        let _e1406 = ((10u * _e245) & 31u);
                                        let _e1409 = ((_e1391.member[0] >> bitcast<u32>(_e1406)) & 1023u);
                                        let _e1417 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[0] - _e679.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e1422 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1409)) - 8388608f) * _e1417)) ^ _e117)));
                                        let _e1426 = select(select(_e679.member.member_1[0], _e1422, (_e1422 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e1409 == 1023u));
                                        let _e1428 = ((10u * _e244) & 31u);
                                        let _e1431 = ((_e1391.member[0] >> bitcast<u32>(_e1428)) & 1023u);
                                        let _e1439 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[1] - _e679.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e1444 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1431)) - 8388608f) * _e1439)) ^ _e117)));
                                        let _e1448 = select(select(_e679.member.member_1[1], _e1444, (_e1444 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e1431 == 1023u));
                                        let _e1450 = ((10u * _e246) & 31u);
                                        let _e1453 = ((_e1391.member[0] >> bitcast<u32>(_e1450)) & 1023u);
                                        let _e1461 = bitcast<f32>((bitcast<u32>(((_e679.member.member_1[2] - _e679.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e1466 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1453)) - 8388608f) * _e1461)) ^ _e117)));
                                        let _e1470 = select(select(_e679.member.member_1[2], _e1466, (_e1466 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e1453 == 1023u));
                                        let _e1473 = ((_e1391.member[1] >> bitcast<u32>(_e1406)) & 1023u);
                                        let _e1481 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1473)) - 8388608f) * _e1417)) ^ _e117)));
                                        let _e1485 = select(select(_e679.member.member_1[0], _e1481, (_e1481 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e1473 == 1023u));
                                        let _e1488 = ((_e1391.member[1] >> bitcast<u32>(_e1428)) & 1023u);
                                        let _e1496 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1488)) - 8388608f) * _e1439)) ^ _e117)));
                                        let _e1500 = select(select(_e679.member.member_1[1], _e1496, (_e1496 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e1488 == 1023u));
                                        let _e1503 = ((_e1391.member[1] >> bitcast<u32>(_e1450)) & 1023u);
                                        let _e1511 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1503)) - 8388608f) * _e1461)) ^ _e117)));
                                        let _e1515 = select(select(_e679.member.member_1[2], _e1511, (_e1511 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e1503 == 1023u));
                                        let _e1521 = ((_e1391.member_1[0] >> bitcast<u32>(_e1406)) & 1023u);
                                        let _e1529 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1521)) - 8388608f) * _e1417)) ^ _e117)));
                                        let _e1533 = select(select(_e679.member.member_1[0], _e1529, (_e1529 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e1521 == 1023u));
                                        let _e1536 = ((_e1391.member_1[0] >> bitcast<u32>(_e1428)) & 1023u);
                                        let _e1544 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1536)) - 8388608f) * _e1439)) ^ _e117)));
                                        let _e1548 = select(select(_e679.member.member_1[1], _e1544, (_e1544 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e1536 == 1023u));
                                        let _e1551 = ((_e1391.member_1[0] >> bitcast<u32>(_e1450)) & 1023u);
                                        let _e1559 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1551)) - 8388608f) * _e1461)) ^ _e117)));
                                        let _e1563 = select(select(_e679.member.member_1[2], _e1559, (_e1559 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e1551 == 1023u));
                                        let _e1566 = ((_e1391.member_1[1] >> bitcast<u32>(_e1406)) & 1023u);
                                        let _e1574 = (_e679.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1566)) - 8388608f) * _e1417)) ^ _e117)));
                                        let _e1578 = select(select(_e679.member.member_1[0], _e1574, (_e1574 < _e679.member.member_1[0])), _e679.member.member_1[0], (_e1566 == 1023u));
                                        let _e1581 = ((_e1391.member_1[1] >> bitcast<u32>(_e1428)) & 1023u);
                                        let _e1589 = (_e679.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1581)) - 8388608f) * _e1439)) ^ _e117)));
                                        let _e1593 = select(select(_e679.member.member_1[1], _e1589, (_e1589 < _e679.member.member_1[1])), _e679.member.member_1[1], (_e1581 == 1023u));
                                        let _e1596 = ((_e1391.member_1[1] >> bitcast<u32>(_e1450)) & 1023u);
                                        let _e1604 = (_e679.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1596)) - 8388608f) * _e1461)) ^ _e117)));
                                        let _e1608 = select(select(_e679.member.member_1[2], _e1604, (_e1604 < _e679.member.member_1[2])), _e679.member.member_1[2], (_e1596 == 1023u));
                                        let _e1613 = type_50(type_42(array<f32, 3>(_e1426, _e1448, _e1470), array<f32, 3>(_e1485, _e1500, _e1515)), _e1391.member_2);
                                        let _e1618 = type_50(type_42(array<f32, 3>(_e1533, _e1548, _e1563), array<f32, 3>(_e1578, _e1593, _e1608)), _e1391.member_3);
                                        let _e1631 = ((_e1426 - _e347) * _e352);
                                        let _e1632 = ((_e1533 - _e347) * _e352);
                                        let _e1633 = ((_e1485 - _e348) * _e352);
                                        let _e1634 = ((_e1578 - _e348) * _e352);
                                        let _e1639 = ((_e1448 - _e415) * _e420);
                                        let _e1640 = ((_e1548 - _e415) * _e420);
                                        let _e1641 = ((_e1500 - _e416) * _e420);
                                        let _e1642 = ((_e1593 - _e416) * _e420);
                                        let _e1647 = ((_e1470 - _e483) * _e488);
                                        let _e1648 = ((_e1563 - _e483) * _e488);
                                        let _e1649 = ((_e1515 - _e484) * _e488);
                                        let _e1650 = ((_e1608 - _e484) * _e488);
                                        let _e1652 = select(_e1649, _e1647, (_e1647 < _e1649));
                                        let _e1654 = select(_e1650, _e1648, (_e1648 < _e1650));
                                        let _e1656 = select(_e1649, _e1647, (_e1647 > _e1649));
                                        let _e1658 = select(_e1650, _e1648, (_e1648 > _e1650));
                                        let _e1660 = select(_e1633, _e1631, (_e1631 < _e1633));
                                        let _e1662 = select(_e1634, _e1632, (_e1632 < _e1634));
                                        let _e1664 = select(_e1641, _e1639, (_e1639 < _e1641));
                                        let _e1666 = select(_e1642, _e1640, (_e1640 < _e1642));
                                        let _e1668 = select(_e1664, _e1660, (_e1660 > _e1664));
                                        let _e1670 = select(_e1666, _e1662, (_e1662 > _e1666));
                                        let _e1672 = select(_e1652, _e1668, (_e1668 > _e1652));
                                        let _e1674 = select(_e1654, _e1670, (_e1670 > _e1654));
                                        let _e1676 = select(_e1633, _e1631, (_e1631 > _e1633));
                                        let _e1678 = select(_e1634, _e1632, (_e1632 > _e1634));
                                        let _e1680 = select(_e1641, _e1639, (_e1639 > _e1641));
                                        let _e1682 = select(_e1642, _e1640, (_e1640 > _e1642));
                                        let _e1684 = select(_e1680, _e1676, (_e1676 < _e1680));
                                        let _e1686 = select(_e1682, _e1678, (_e1678 < _e1682));
                                        let _e1691 = -(_e1652);
                                        let _e1692 = -(_e1654);
                                        let _e1699 = (select(_e1656, _e1684, (_e1684 < _e1656)) + (select(_e1691, _e1656, (_e1656 > _e1691)) * 0.0000019073523f));
                                        let _e1700 = (select(_e1658, _e1686, (_e1686 < _e1658)) + (select(_e1692, _e1658, (_e1658 > _e1692)) * 0.0000019073523f));
                                        let _e1702 = select(_e600, _e1672, (_e1672 > _e600));
                                        let _e1704 = select(_e600, _e1674, (_e1674 > _e600));
                                        let _e1709 = (_e1702 <= select(_e1386.member.member_1, _e1699, (_e1699 < _e1386.member.member_1)));
                                        let _e1710 = (_e1704 <= select(_e1386.member.member_1, _e1700, (_e1700 < _e1386.member.member_1)));
                                        let _e1711 = (_e1702 <= _e1704);
                                        if _e1709 {
                                            if _e1710 {
                                                if _e1711 {
                                                    phi_3326_ = _e1618;
                                                } else {
                                                    phi_3326_ = _e1613;
                                                }
                                                let _e1713 = phi_3326_;
                                                let _e1720 = (_e677 % 128u);
                                                let _e1721 = (_e1720 < 128u);
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local_6[_e1720] = _e1713.member_1;
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local_5[_e1720] = _e1713.member.member[0];
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local_4[_e1720] = _e1713.member.member[1];
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local_3[_e1720] = _e1713.member.member[2];
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local_2[_e1720] = _e1713.member.member_1[0];
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local_1[_e1720] = _e1713.member.member_1[1];
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local[_e1720] = _e1713.member.member_1[2];
                                                if _e1721 {
                                                } else {
                                                    phi_3684_ = true;
                                                    break;
                                                }
                                                local_7[_e1720] = select(_e1702, _e1704, _e1711);
                                                if _e1711 {
                                                    phi_3402_ = _e1613;
                                                } else {
                                                    phi_3402_ = _e1618;
                                                }
                                                let _e1738 = phi_3402_;
                                                phi_3403_ = (_e677 + 1u);
                                                phi_3404_ = _e1738;
                                            } else {
                                                phi_3403_ = u32();
                                                phi_3404_ = type_50();
                                            }
                                            let _e1740 = phi_3403_;
                                            let _e1742 = phi_3404_;
                                            phi_3406_ = _e1740;
                                            phi_3407_ = _e1742;
                                            phi_3408_ = select(true, false, _e1710);
                                        } else {
                                            phi_3406_ = u32();
                                            phi_3407_ = type_50();
                                            phi_3408_ = true;
                                        }
                                        let _e1745 = phi_3406_;
                                        let _e1747 = phi_3407_;
                                        let _e1749 = phi_3408_;
                                        if _e1749 {
                                            if _e1709 {
                                                phi_3415_ = _e1613;
                                            } else {
                                                phi_3415_ = _e1618;
                                            }
                                            let _e1751 = phi_3415_;
                                            phi_3420_ = select(_e1710, true, _e1709);
                                            phi_3422_ = _e1751;
                                        } else {
                                            phi_3420_ = _e675;
                                            phi_3422_ = _e1747;
                                        }
                                        let _e1754 = phi_3420_;
                                        let _e1756 = phi_3422_;
                                        phi_3427_ = type_33(_e1386.member, (_e1386.member_1 + 1u), _e1386.member_2);
                                        phi_3428_ = _e1754;
                                        phi_3429_ = select(_e1745, _e677, _e1749);
                                        phi_3430_ = _e1756;
                                    }
                                    let _e1759 = phi_3427_;
                                    let _e1761 = phi_3428_;
                                    let _e1763 = phi_3429_;
                                    let _e1765 = phi_3430_;
                                    if _e683 {
                                        phi_3438_ = _e1386;
                                        phi_3441_ = _e679;
                                    } else {
                                        phi_3438_ = _e1759;
                                        phi_3441_ = _e1765;
                                    }
                                    let _e1767 = phi_3438_;
                                    let _e1769 = phi_3441_;
                                    phi_3687_ = _e1384;
                                    phi_3442_ = _e1767;
                                    phi_3443_ = (_e637 - 1u);
                                    phi_3444_ = select(_e1761, false, _e683);
                                    phi_3445_ = select(_e1763, _e677, _e683);
                                    phi_3446_ = _e1769;
                                } else {
                                    phi_3687_ = _e633;
                                    phi_3442_ = _e635;
                                    phi_3443_ = _e637;
                                    phi_3444_ = _e675;
                                    phi_3445_ = _e677;
                                    phi_3446_ = _e679;
                                }
                                let _e1773 = phi_3687_;
                                let _e1775 = phi_3442_;
                                let _e1777 = phi_3443_;
                                let _e1779 = phi_3444_;
                                let _e1781 = phi_3445_;
                                let _e1783 = phi_3446_;
                                phi_3686_ = _e1773;
                                phi_3447_ = _e1775;
                                phi_3448_ = _e1777;
                                phi_3449_ = _e1779;
                                phi_3450_ = _e1781;
                                phi_3451_ = _e1783;
                            } else {
                                phi_3686_ = _e633;
                                phi_3447_ = type_33();
                                phi_3448_ = u32();
                                phi_3449_ = bool();
                                phi_3450_ = u32();
                                phi_3451_ = type_50();
                            }
                            let _e1785 = phi_3686_;
                            let _e1787 = phi_3447_;
                            let _e1789 = phi_3448_;
                            let _e1791 = phi_3449_;
                            let _e1793 = phi_3450_;
                            let _e1795 = phi_3451_;
                            phi_3685_ = _e1785;
                            phi_1023_ = _e1787;
                            phi_1026_ = _e1789;
                            phi_1028_ = _e1791;
                            phi_1030_ = _e1793;
                            phi_1032_ = _e1795;
                            phi_3452_ = _e647;
                        } else {
                            phi_3685_ = _e633;
                            phi_1023_ = type_33();
                            phi_1026_ = u32();
                            phi_1028_ = bool();
                            phi_1030_ = u32();
                            phi_1032_ = type_50();
                            phi_3452_ = false;
                        }
                        let _e1797 = phi_3685_;
                        let _e1799 = phi_1023_;
                        let _e1801 = phi_1026_;
                        let _e1803 = phi_1028_;
                        let _e1805 = phi_1030_;
                        let _e1807 = phi_1032_;
                        let _e1809 = phi_3452_;
                        continue;
                        continuing {
                            phi_3512_ = _e1797;
                            phi_1022_ = _e1799;
                            phi_1025_ = _e1801;
                            phi_1027_ = _e1803;
                            phi_1029_ = _e1805;
                            phi_1031_ = _e1807;
                            phi_3684_ = _e1797;
                            break if !(_e1809);
                        }
                    }
                    let _e1812 = phi_3684_;
                    if _e1812 {
                        break;
                    }
                    let _e1814 = local_10;
                    let _e1817 = local_11;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_5.member[_e131][0u] = _e1814.member_1;
                    global_5.member[_e131][1u] = _e1817.member_2;
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
