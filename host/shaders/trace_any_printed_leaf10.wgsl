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
    var phi_334_: i32;
    var phi_335_: i32;
    var phi_345_: bool;
    var phi_355_: u32;
    var phi_356_: u32;
    var phi_358_: bool;
    var phi_363_: u32;
    var phi_375_: i32;
    var phi_395_: i32;
    var phi_413_: f32;
    var phi_419_: f32;
    var phi_459_: f32;
    var phi_465_: f32;
    var phi_517_: f32;
    var phi_528_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_583_: f32;
    var phi_589_: f32;
    var phi_641_: f32;
    var phi_652_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_707_: f32;
    var phi_713_: f32;
    var phi_765_: f32;
    var phi_776_: f32;
    var phi_831_: i32;
    var phi_853_: u32;
    var phi_854_: u32;
    var phi_891_: i32;
    var phi_913_: u32;
    var phi_914_: u32;
    var phi_922_: f32;
    var phi_923_: f32;
    var phi_3341_: bool;
    var phi_996_: type_32;
    var phi_999_: type_49;
    var phi_1001_: u32;
    var phi_1003_: bool;
    var phi_1005_: u32;
    var phi_1016_: bool;
    var phi_1102_: type_49;
    var phi_1103_: bool;
    var phi_1104_: u32;
    var phi_2315_: type_36;
    var phi_3171_: type_49;
    var phi_3248_: type_49;
    var phi_3249_: type_49;
    var phi_3250_: u32;
    var phi_3252_: type_49;
    var phi_3253_: u32;
    var phi_3254_: bool;
    var phi_3261_: type_49;
    var phi_3266_: type_49;
    var phi_3267_: bool;
    var phi_1123_: type_32;
    var phi_1126_: type_7;
    var phi_1127_: type_7;
    var phi_1149_: type_7;
    var phi_1174_: u32;
    var phi_1190_: type_43;
    var phi_1584_: bool;
    var phi_1613_: bool;
    var phi_1990_: f32;
    var phi_1991_: f32;
    var phi_1992_: f32;
    var phi_1993_: f32;
    var phi_1994_: vec3<f32>;
    var phi_1995_: vec3<f32>;
    var phi_1996_: vec3<f32>;
    var phi_1997_: vec3<f32>;
    var phi_2028_: bool;
    var phi_2037_: vec3<f32>;
    var phi_2202_: f32;
    var phi_2204_: f32;
    var phi_2205_: bool;
    var phi_2225_: f32;
    var phi_2226_: f32;
    var phi_2249_: type_21;
    var phi_2251_: type_21;
    var phi_2252_: bool;
    var phi_2256_: type_21;
    var phi_2257_: type_21;
    var phi_2258_: type_21;
    var phi_2259_: bool;
    var phi_2263_: type_21;
    var phi_2264_: bool;
    var phi_2265_: type_21;
    var phi_2266_: bool;
    var phi_2267_: bool;
    var phi_2268_: type_21;
    var phi_2269_: bool;
    var phi_2270_: bool;
    var phi_2278_: type_21;
    var phi_2279_: bool;
    var phi_2283_: type_21;
    var phi_2294_: type_32;
    var phi_2295_: type_32;
    var phi_1124_: type_32;
    var phi_3335_: bool;
    var local_10: type_32;
    var phi_3514_: bool;
    var phi_3269_: type_32;
    var phi_3270_: type_49;
    var phi_3271_: bool;
    var phi_3272_: u32;
    var phi_3513_: bool;
    var phi_3273_: type_32;
    var phi_3274_: type_49;
    var phi_3275_: u32;
    var phi_3276_: bool;
    var phi_3277_: u32;
    var phi_3512_: bool;
    var phi_3278_: type_32;
    var phi_3279_: type_49;
    var phi_3280_: u32;
    var phi_3281_: bool;
    var phi_3282_: u32;
    var phi_3511_: bool;
    var phi_997_: type_32;
    var phi_1000_: type_49;
    var phi_1002_: u32;
    var phi_1004_: bool;
    var phi_1006_: u32;
    var phi_3283_: bool;
    var phi_3510_: bool;
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
                            phi_334_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_334_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_334_;
                        phi_335_ = _e224;
                    } else {
                        phi_335_ = 0i;
                    }
                    let _e226 = phi_335_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_345_ = true;
                    } else {
                        phi_345_ = (_e150 == _e182);
                    }
                    let _e230 = phi_345_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_355_ = _e232;
                        phi_356_ = _e232;
                        phi_358_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_355_ = u32();
                        phi_356_ = 0u;
                        phi_358_ = true;
                    }
                    let _e236 = phi_355_;
                    let _e238 = phi_356_;
                    let _e240 = phi_358_;
                    if _e240 {
                        phi_363_ = (_e238 + 1u);
                    } else {
                        phi_363_ = 0u;
                    }
                    let _e244 = phi_363_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_375_ = -126i;
                    } else {
                        phi_375_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_375_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_395_ = -126i;
                    } else {
                        phi_395_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_395_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_3.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_413_ = _e283[0];
                    } else {
                        phi_413_ = _e283[1];
                    }
                    let _e288 = phi_413_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_419_ = _e283[2];
                    } else {
                        phi_419_ = _e288;
                    }
                    let _e292 = phi_419_;
                    let _e293 = bitcast<u32>(_e292);
                    let _e295 = ((_e293 & 2139095040u) != 0u);
                    let _e309 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e293 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e293 & 2147483648u))), _e292, _e295) * _e256) * select(0.00000011920929f, 1f, _e295)) * _e262);
                    let _e310 = global_3.member[_e131].member_2;
                    if _e284 {
                        phi_459_ = _e310[0];
                    } else {
                        phi_459_ = _e310[1];
                    }
                    let _e314 = phi_459_;
                    if _e289 {
                        phi_465_ = _e310[2];
                    } else {
                        phi_465_ = _e314;
                    }
                    let _e317 = phi_465_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e273) * select(0.00000011920929f, 1f, _e320)) * _e279);
                    let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e338 {
                        let _e342 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_517_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                    } else {
                        phi_517_ = 0f;
                    }
                    let _e346 = phi_517_;
                    let _e347 = (_e309 + _e346);
                    let _e348 = (_e309 - _e346);
                    let _e349 = select(_e334, 0f, _e338);
                    if _e338 {
                        phi_528_ = 38685626000000000000000000f;
                    } else {
                        phi_528_ = (1f / _e334);
                    }
                    let _e352 = phi_528_;
                    let _e353 = (_e244 == 0u);
                    if _e353 {
                        phi_537_ = _e283[0];
                    } else {
                        phi_537_ = _e283[1];
                    }
                    let _e357 = phi_537_;
                    let _e358 = (_e244 == 2u);
                    if _e358 {
                        phi_543_ = _e283[2];
                    } else {
                        phi_543_ = _e357;
                    }
                    let _e361 = phi_543_;
                    let _e362 = bitcast<u32>(_e361);
                    let _e364 = ((_e362 & 2139095040u) != 0u);
                    let _e378 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * _e256) * select(0.00000011920929f, 1f, _e364)) * _e262);
                    if _e353 {
                        phi_583_ = _e310[0];
                    } else {
                        phi_583_ = _e310[1];
                    }
                    let _e382 = phi_583_;
                    if _e358 {
                        phi_589_ = _e310[2];
                    } else {
                        phi_589_ = _e382;
                    }
                    let _e385 = phi_589_;
                    let _e386 = bitcast<u32>(_e385);
                    let _e388 = ((_e386 & 2139095040u) != 0u);
                    let _e402 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e385, _e388) * _e273) * select(0.00000011920929f, 1f, _e388)) * _e279);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e378) & 2147483647u)) * 0.00000011920929f);
                        phi_641_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e414 = phi_641_;
                    let _e415 = (_e378 + _e414);
                    let _e416 = (_e378 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_652_ = 38685626000000000000000000f;
                    } else {
                        phi_652_ = (1f / _e402);
                    }
                    let _e420 = phi_652_;
                    let _e421 = (_e246 == 0u);
                    if _e421 {
                        phi_661_ = _e283[0];
                    } else {
                        phi_661_ = _e283[1];
                    }
                    let _e425 = phi_661_;
                    let _e426 = (_e246 == 2u);
                    if _e426 {
                        phi_667_ = _e283[2];
                    } else {
                        phi_667_ = _e425;
                    }
                    let _e429 = phi_667_;
                    let _e430 = bitcast<u32>(_e429);
                    let _e432 = ((_e430 & 2139095040u) != 0u);
                    let _e446 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e430 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e430 & 2147483648u))), _e429, _e432) * _e256) * select(0.00000011920929f, 1f, _e432)) * _e262);
                    if _e421 {
                        phi_707_ = _e310[0];
                    } else {
                        phi_707_ = _e310[1];
                    }
                    let _e450 = phi_707_;
                    if _e426 {
                        phi_713_ = _e310[2];
                    } else {
                        phi_713_ = _e450;
                    }
                    let _e453 = phi_713_;
                    let _e454 = bitcast<u32>(_e453);
                    let _e456 = ((_e454 & 2139095040u) != 0u);
                    let _e470 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e454 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e454 & 2147483648u))), _e453, _e456) * _e273) * select(0.00000011920929f, 1f, _e456)) * _e279);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e474 {
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) * 0.00000011920929f);
                        phi_765_ = select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f));
                    } else {
                        phi_765_ = 0f;
                    }
                    let _e482 = phi_765_;
                    let _e483 = (_e446 + _e482);
                    let _e484 = (_e446 - _e482);
                    let _e485 = select(_e470, 0f, _e474);
                    if _e474 {
                        phi_776_ = 38685626000000000000000000f;
                    } else {
                        phi_776_ = (1f / _e470);
                    }
                    let _e488 = phi_776_;
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
                            phi_831_ = 255i;
                        } else {
                            phi_831_ = (((_e515 + select(0i, 1i, (_e515 == 0i))) - _e522) + _e502);
                        }
                        let _e530 = phi_831_;
                        let _e540 = (_e530 <= 0i);
                        if _e540 {
                            phi_854_ = u32();
                        } else {
                            if _e519 {
                                phi_853_ = u32();
                            } else {
                                phi_853_ = select(((bitcast<u32>(_e530) << bitcast<u32>(23i)) | ((_e512 << bitcast<u32>(((_e522 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e530 >= 255i));
                            }
                            let _e544 = phi_853_;
                            phi_854_ = _e544;
                        }
                        let _e546 = phi_854_;
                        let _e558 = ((_e203 & 8388607u) | (select(0u, 1u, ((_e203 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e561 = bitcast<i32>((_e203 >> bitcast<u32>(23i)));
                        let _e565 = (_e558 == 0u);
                        let _e568 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e558)), 32u, _e565)) - 8i);
                        if (_e561 == 255i) {
                            phi_891_ = 255i;
                        } else {
                            phi_891_ = (((_e561 + select(0i, 1i, (_e561 == 0i))) - _e568) + _e502);
                        }
                        let _e576 = phi_891_;
                        let _e586 = (_e576 <= 0i);
                        if _e586 {
                            phi_914_ = u32();
                        } else {
                            if _e565 {
                                phi_913_ = u32();
                            } else {
                                phi_913_ = select(((bitcast<u32>(_e576) << bitcast<u32>(23i)) | ((_e558 << bitcast<u32>(((_e568 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e576 >= 255i));
                            }
                            let _e590 = phi_913_;
                            phi_914_ = _e590;
                        }
                        let _e592 = phi_914_;
                        phi_922_ = bitcast<f32>(((_e202 & 2147483648u) | select(_e592, 0u, select(_e565, true, _e586))));
                        phi_923_ = bitcast<f32>(((_e193 & 2147483648u) | select(_e546, 0u, select(_e519, true, _e540))));
                    } else {
                        phi_922_ = 0f;
                        phi_923_ = 1f;
                    }
                    let _e598 = phi_922_;
                    let _e600 = phi_923_;
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
                    phi_3341_ = false;
                    phi_996_ = type_32(_e598, false);
                    phi_999_ = type_49(type_41(array<f32, 3>(_e608, _e612, _e616), array<f32, 3>(_e620, _e622, _e624)), select(0u, 2147483648u, (_e82 == 0u)));
                    phi_1001_ = ((3u * _e82) + 1u);
                    phi_1003_ = (_e600 <= _e598);
                    phi_1005_ = 0u;
                    loop {
                        let _e632 = phi_3341_;
                        let _e634 = phi_996_;
                        let _e636 = phi_999_;
                        let _e638 = phi_1001_;
                        let _e640 = phi_1003_;
                        let _e642 = phi_1005_;
                        local_11 = _e634;
                        if _e640 {
                            phi_1016_ = true;
                        } else {
                            phi_1016_ = (_e642 > 0u);
                        }
                        let _e645 = phi_1016_;
                        if _e645 {
                            let _e646 = (_e638 > 0u);
                            if _e646 {
                                if _e640 {
                                    phi_1102_ = _e636;
                                    phi_1103_ = _e640;
                                    phi_1104_ = _e642;
                                } else {
                                    let _e647 = (_e642 - 1u);
                                    let _e648 = (_e647 % 128u);
                                    let _e649 = (_e648 < 128u);
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e651 = local_6[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e653 = local_5[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e655 = local_4[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e657 = local_3[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e660 = local_2[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e662 = local_1[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e664 = local[_e648];
                                    if _e649 {
                                    } else {
                                        phi_3510_ = true;
                                        break;
                                    }
                                    let _e669 = local_7[_e648];
                                    phi_1102_ = type_49(type_41(array<f32, 3>(_e653, _e655, _e657), array<f32, 3>(_e660, _e662, _e664)), _e651);
                                    phi_1103_ = (_e669 <= _e634.member);
                                    phi_1104_ = _e647;
                                }
                                let _e673 = phi_1102_;
                                let _e675 = phi_1103_;
                                let _e677 = phi_1104_;
                                if _e675 {
                                    if ((_e673.member_1 & 2147483648u) != 0u) {
                                        phi_1123_ = _e634;
                                        phi_1126_ = type_7(0u, ((_e673.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1054 = phi_1123_;
                                            let _e1056 = phi_1126_;
                                            local_10 = _e1054;
                                            local_12 = _e1054;
                                            if (_e1056.member < _e1056.member_1) {
                                                phi_1127_ = type_7((_e1056.member + 1u), _e1056.member_1);
                                                phi_1149_ = type_7(1u, _e1056.member);
                                            } else {
                                                phi_1127_ = _e1056;
                                                phi_1149_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1069 = phi_1127_;
                                            let _e1071 = phi_1149_;
                                            let _e1075 = (bitcast<i32>(_e1071.member) != 0i);
                                            if _e1075 {
                                                let _e1076 = ((_e673.member_1 & 268435455u) + _e1071.member_1);
                                                let _e1077 = (_e1076 < arrayLength((&global_6.member)));
                                                if _e1077 {
                                                    if _e1077 {
                                                    } else {
                                                        phi_3335_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_6.member[_e1076].member_1;
                                                    phi_1174_ = _e1080;
                                                } else {
                                                    phi_1174_ = 4294967295u;
                                                }
                                                let _e1082 = phi_1174_;
                                                if _e1077 {
                                                    if _e1077 {
                                                    } else {
                                                        phi_3335_ = true;
                                                        break;
                                                    }
                                                    let _e1084 = global_6.member[_e1076];
                                                    phi_1190_ = _e1084;
                                                } else {
                                                    phi_1190_ = type_43(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1086 = phi_1190_;
                                                let _e1098 = ((10u * _e245) & 31u);
                                                let _e1101 = ((_e1086.member[0] >> bitcast<u32>(_e1098)) & 1023u);
                                                let _e1109 = bitcast<f32>((bitcast<u32>(((_e673.member.member_1[0] - _e673.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                let _e1114 = (_e673.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1101)) - 8388608f) * _e1109)) ^ _e117)));
                                                let _e1118 = select(select(_e673.member.member_1[0], _e1114, (_e1114 < _e673.member.member_1[0])), _e673.member.member_1[0], (_e1101 == 1023u));
                                                let _e1120 = ((10u * _e244) & 31u);
                                                let _e1123 = ((_e1086.member[0] >> bitcast<u32>(_e1120)) & 1023u);
                                                let _e1131 = bitcast<f32>((bitcast<u32>(((_e673.member.member_1[1] - _e673.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                let _e1136 = (_e673.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1123)) - 8388608f) * _e1131)) ^ _e117)));
                                                let _e1140 = select(select(_e673.member.member_1[1], _e1136, (_e1136 < _e673.member.member_1[1])), _e673.member.member_1[1], (_e1123 == 1023u));
                                                let _e1142 = ((10u * _e246) & 31u);
                                                let _e1145 = ((_e1086.member[0] >> bitcast<u32>(_e1142)) & 1023u);
                                                let _e1153 = bitcast<f32>((bitcast<u32>(((_e673.member.member_1[2] - _e673.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                let _e1158 = (_e673.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1145)) - 8388608f) * _e1153)) ^ _e117)));
                                                let _e1162 = select(select(_e673.member.member_1[2], _e1158, (_e1158 < _e673.member.member_1[2])), _e673.member.member_1[2], (_e1145 == 1023u));
                                                let _e1166 = ((_e1086.member[1] >> bitcast<u32>(_e1098)) & 1023u);
                                                let _e1174 = (_e673.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1166)) - 8388608f) * _e1109)) ^ _e117)));
                                                let _e1178 = select(select(_e673.member.member_1[0], _e1174, (_e1174 < _e673.member.member_1[0])), _e673.member.member_1[0], (_e1166 == 1023u));
                                                let _e1181 = ((_e1086.member[1] >> bitcast<u32>(_e1120)) & 1023u);
                                                let _e1189 = (_e673.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1181)) - 8388608f) * _e1131)) ^ _e117)));
                                                let _e1193 = select(select(_e673.member.member_1[1], _e1189, (_e1189 < _e673.member.member_1[1])), _e673.member.member_1[1], (_e1181 == 1023u));
                                                let _e1196 = ((_e1086.member[1] >> bitcast<u32>(_e1142)) & 1023u);
                                                let _e1204 = (_e673.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1196)) - 8388608f) * _e1153)) ^ _e117)));
                                                let _e1208 = select(select(_e673.member.member_1[2], _e1204, (_e1204 < _e673.member.member_1[2])), _e673.member.member_1[2], (_e1196 == 1023u));
                                                let _e1212 = ((_e1086.member[2] >> bitcast<u32>(_e1098)) & 1023u);
                                                let _e1220 = (_e673.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1212)) - 8388608f) * _e1109)) ^ _e117)));
                                                let _e1224 = select(select(_e673.member.member_1[0], _e1220, (_e1220 < _e673.member.member_1[0])), _e673.member.member_1[0], (_e1212 == 1023u));
                                                let _e1227 = ((_e1086.member[2] >> bitcast<u32>(_e1120)) & 1023u);
                                                let _e1235 = (_e673.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1227)) - 8388608f) * _e1131)) ^ _e117)));
                                                let _e1239 = select(select(_e673.member.member_1[1], _e1235, (_e1235 < _e673.member.member_1[1])), _e673.member.member_1[1], (_e1227 == 1023u));
                                                let _e1242 = ((_e1086.member[2] >> bitcast<u32>(_e1142)) & 1023u);
                                                let _e1250 = (_e673.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1242)) - 8388608f) * _e1153)) ^ _e117)));
                                                let _e1254 = select(select(_e673.member.member_1[2], _e1250, (_e1250 < _e673.member.member_1[2])), _e673.member.member_1[2], (_e1242 == 1023u));
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
                                                        phi_2268_ = type_21();
                                                        phi_2269_ = true;
                                                        phi_2270_ = false;
                                                    } else {
                                                        let _e1317 = select(_e1270, _e1261, (_e1261 < _e1270));
                                                        if (select(_e1279, _e1317, (_e1317 < _e1279)) > 0f) {
                                                            phi_1584_ = true;
                                                        } else {
                                                            let _e1322 = select(_e1270, _e1261, (_e1261 > _e1270));
                                                            phi_1584_ = (select(_e1279, _e1322, (_e1322 > _e1279)) < 0f);
                                                        }
                                                        let _e1327 = phi_1584_;
                                                        if _e1327 {
                                                            phi_2265_ = type_21();
                                                            phi_2266_ = true;
                                                            phi_2267_ = false;
                                                        } else {
                                                            let _e1329 = select(_e1273, _e1264, (_e1264 < _e1273));
                                                            if (select(_e1282, _e1329, (_e1329 < _e1282)) > 0f) {
                                                                phi_1613_ = true;
                                                            } else {
                                                                let _e1334 = select(_e1273, _e1264, (_e1264 > _e1273));
                                                                phi_1613_ = (select(_e1282, _e1334, (_e1334 > _e1282)) < 0f);
                                                            }
                                                            let _e1339 = phi_1613_;
                                                            if _e1339 {
                                                                phi_2263_ = type_21();
                                                                phi_2264_ = false;
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
                                                                    phi_2258_ = type_21();
                                                                    phi_2259_ = true;
                                                                } else {
                                                                    let _e1404 = (_e1402 > _e1054.member);
                                                                    if _e1404 {
                                                                        phi_2257_ = type_21();
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
                                                                            phi_1990_ = _e1273;
                                                                            phi_1991_ = _e1270;
                                                                            phi_1992_ = _e1264;
                                                                            phi_1993_ = _e1261;
                                                                            phi_1994_ = _e1405;
                                                                            phi_1995_ = _e1419;
                                                                            phi_1996_ = _e1415;
                                                                            phi_1997_ = _e1411;
                                                                        } else {
                                                                            let _e1464 = (_e1445 == _e1462);
                                                                            let _e1469 = vec3(_e1464);
                                                                            phi_1990_ = select(_e1264, _e1282, _e1464);
                                                                            phi_1991_ = select(_e1261, _e1279, _e1464);
                                                                            phi_1992_ = select(_e1282, _e1273, _e1464);
                                                                            phi_1993_ = select(_e1279, _e1270, _e1464);
                                                                            phi_1994_ = select(_e1407, _e1406, _e1469);
                                                                            phi_1995_ = select(_e1415, _e1411, _e1469);
                                                                            phi_1996_ = select(_e1411, _e1419, _e1469);
                                                                            phi_1997_ = select(_e1419, _e1415, _e1469);
                                                                        }
                                                                        let _e1475 = phi_1990_;
                                                                        let _e1477 = phi_1991_;
                                                                        let _e1479 = phi_1992_;
                                                                        let _e1481 = phi_1993_;
                                                                        let _e1483 = phi_1994_;
                                                                        let _e1485 = phi_1995_;
                                                                        let _e1487 = phi_1996_;
                                                                        let _e1489 = phi_1997_;
                                                                        let _e1496 = ((_e1487.y * _e1485.z) - (_e1485.y * _e1487.z));
                                                                        let _e1501 = ((_e1487.z * _e1485.x) - (_e1485.z * _e1487.x));
                                                                        let _e1504 = ((_e1487.x * _e1485.y) - (_e1485.x * _e1487.y));
                                                                        if (_e1304 >= _e1308) {
                                                                            phi_2028_ = select(true, false, (_e1304 >= _e1312));
                                                                        } else {
                                                                            phi_2028_ = true;
                                                                        }
                                                                        let _e1509 = phi_2028_;
                                                                        if _e1509 {
                                                                            phi_2037_ = select(_e1407, _e1406, vec3((_e1308 >= _e1312)));
                                                                        } else {
                                                                            phi_2037_ = _e1405;
                                                                        }
                                                                        let _e1514 = phi_2037_;
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
                                                                                phi_2202_ = (_e1525 / _e1530);
                                                                            } else {
                                                                                phi_2202_ = f32();
                                                                            }
                                                                            let _e1635 = phi_2202_;
                                                                            phi_2204_ = _e1635;
                                                                            phi_2205_ = select(true, false, _e1632);
                                                                        } else {
                                                                            phi_2204_ = f32();
                                                                            phi_2205_ = true;
                                                                        }
                                                                        let _e1638 = phi_2204_;
                                                                        let _e1640 = phi_2205_;
                                                                        if _e1640 {
                                                                            let _e1648 = (((_e1496 * (_e1557 - (_e349 * _e1560))) + (_e1501 * (_e1558 - (_e417 * _e1560)))) / _e1530);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1648) & 2147483647u)) <= _e1462) {
                                                                                phi_2225_ = (_e1560 + _e1648);
                                                                            } else {
                                                                                phi_2225_ = _e1560;
                                                                            }
                                                                            let _e1655 = phi_2225_;
                                                                            phi_2226_ = _e1655;
                                                                        } else {
                                                                            phi_2226_ = _e1638;
                                                                        }
                                                                        let _e1657 = phi_2226_;
                                                                        let _e1659 = select(_e1395, _e1657, (_e1657 < _e1395));
                                                                        let _e1661 = select(_e1387, _e1659, (_e1659 > _e1387));
                                                                        if (_e1661 >= _e600) {
                                                                            let _e1663 = (_e1661 <= _e1054.member);
                                                                            if _e1663 {
                                                                                let _e1664 = (1f / _e1314);
                                                                                phi_2249_ = type_21(_e1661, (_e1308 * _e1664), (_e1312 * _e1664), _e1082);
                                                                            } else {
                                                                                phi_2249_ = type_21();
                                                                            }
                                                                            let _e1669 = phi_2249_;
                                                                            phi_2251_ = _e1669;
                                                                            phi_2252_ = select(true, false, _e1663);
                                                                        } else {
                                                                            phi_2251_ = type_21();
                                                                            phi_2252_ = true;
                                                                        }
                                                                        let _e1672 = phi_2251_;
                                                                        let _e1674 = phi_2252_;
                                                                        if _e1674 {
                                                                            phi_2256_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2256_ = _e1672;
                                                                        }
                                                                        let _e1676 = phi_2256_;
                                                                        phi_2257_ = _e1676;
                                                                    }
                                                                    let _e1678 = phi_2257_;
                                                                    phi_2258_ = _e1678;
                                                                    phi_2259_ = _e1404;
                                                                }
                                                                let _e1680 = phi_2258_;
                                                                let _e1682 = phi_2259_;
                                                                phi_2263_ = _e1680;
                                                                phi_2264_ = _e1682;
                                                            }
                                                            let _e1684 = phi_2263_;
                                                            let _e1686 = phi_2264_;
                                                            phi_2265_ = _e1684;
                                                            phi_2266_ = _e1339;
                                                            phi_2267_ = _e1686;
                                                        }
                                                        let _e1688 = phi_2265_;
                                                        let _e1690 = phi_2266_;
                                                        let _e1692 = phi_2267_;
                                                        phi_2268_ = _e1688;
                                                        phi_2269_ = _e1690;
                                                        phi_2270_ = _e1692;
                                                    }
                                                    let _e1694 = phi_2268_;
                                                    let _e1696 = phi_2269_;
                                                    let _e1698 = phi_2270_;
                                                    phi_2278_ = _e1694;
                                                    phi_2279_ = select(_e1698, true, _e1696);
                                                } else {
                                                    phi_2278_ = type_21();
                                                    phi_2279_ = true;
                                                }
                                                let _e1701 = phi_2278_;
                                                let _e1703 = phi_2279_;
                                                if _e1703 {
                                                    phi_2283_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2283_ = _e1701;
                                                }
                                                let _e1705 = phi_2283_;
                                                if (_e1705.member_3 != 4294967295u) {
                                                    if (_e1082 != 4294967295u) {
                                                        phi_2294_ = type_32(_e1054.member, true);
                                                    } else {
                                                        phi_2294_ = _e1054;
                                                    }
                                                    let _e1713 = phi_2294_;
                                                    phi_2295_ = _e1713;
                                                } else {
                                                    phi_2295_ = _e1054;
                                                }
                                                let _e1715 = phi_2295_;
                                                phi_1124_ = _e1715;
                                            } else {
                                                phi_1124_ = type_32();
                                            }
                                            let _e1717 = phi_1124_;
                                            continue;
                                            continuing {
                                                phi_1123_ = _e1717;
                                                phi_1126_ = _e1069;
                                                phi_3335_ = _e632;
                                                break if !(_e1075);
                                            }
                                        }
                                        let _e1720 = phi_3335_;
                                        phi_3510_ = _e1720;
                                        if _e1720 {
                                            break;
                                        }
                                        let _e1722 = local_10;
                                        phi_3514_ = _e1720;
                                        let _e1887 = local_12;
                                        phi_3269_ = _e1887;
                                        phi_3270_ = _e673;
                                        phi_3271_ = false;
                                        phi_3272_ = select(_e677, 0u, _e1722.member_1);
                                    } else {
                                        let _e687 = (_e673.member_1 < _e82);
                                        if _e687 {
                                            if _e687 {
                                            } else {
                                                phi_3510_ = true;
                                                break;
                                            }
                                            let _e689 = global_5.member[_e673.member_1];
                                            phi_2315_ = _e689;
                                        } else {
                                            phi_2315_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e691 = phi_2315_;
                                        let _e706 = ((10u * _e245) & 31u);
                                        let _e709 = ((_e691.member[0] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e717 = bitcast<f32>((bitcast<u32>(((_e673.member.member_1[0] - _e673.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e722 = (_e673.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e709)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e726 = select(select(_e673.member.member_1[0], _e722, (_e722 < _e673.member.member_1[0])), _e673.member.member_1[0], (_e709 == 1023u));
                                        let _e728 = ((10u * _e244) & 31u);
                                        let _e731 = ((_e691.member[0] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e739 = bitcast<f32>((bitcast<u32>(((_e673.member.member_1[1] - _e673.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e744 = (_e673.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e731)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e748 = select(select(_e673.member.member_1[1], _e744, (_e744 < _e673.member.member_1[1])), _e673.member.member_1[1], (_e731 == 1023u));
                                        let _e750 = ((10u * _e246) & 31u);
                                        let _e753 = ((_e691.member[0] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e761 = bitcast<f32>((bitcast<u32>(((_e673.member.member_1[2] - _e673.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e766 = (_e673.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e753)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e770 = select(select(_e673.member.member_1[2], _e766, (_e766 < _e673.member.member_1[2])), _e673.member.member_1[2], (_e753 == 1023u));
                                        let _e773 = ((_e691.member[1] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e781 = (_e673.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e773)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e785 = select(select(_e673.member.member_1[0], _e781, (_e781 < _e673.member.member_1[0])), _e673.member.member_1[0], (_e773 == 1023u));
                                        let _e788 = ((_e691.member[1] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e796 = (_e673.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e800 = select(select(_e673.member.member_1[1], _e796, (_e796 < _e673.member.member_1[1])), _e673.member.member_1[1], (_e788 == 1023u));
                                        let _e803 = ((_e691.member[1] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e811 = (_e673.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e803)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e815 = select(select(_e673.member.member_1[2], _e811, (_e811 < _e673.member.member_1[2])), _e673.member.member_1[2], (_e803 == 1023u));
                                        let _e821 = ((_e691.member_1[0] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e829 = (_e673.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e821)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e833 = select(select(_e673.member.member_1[0], _e829, (_e829 < _e673.member.member_1[0])), _e673.member.member_1[0], (_e821 == 1023u));
                                        let _e836 = ((_e691.member_1[0] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e844 = (_e673.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e836)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e848 = select(select(_e673.member.member_1[1], _e844, (_e844 < _e673.member.member_1[1])), _e673.member.member_1[1], (_e836 == 1023u));
                                        let _e851 = ((_e691.member_1[0] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e859 = (_e673.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e851)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e863 = select(select(_e673.member.member_1[2], _e859, (_e859 < _e673.member.member_1[2])), _e673.member.member_1[2], (_e851 == 1023u));
                                        let _e866 = ((_e691.member_1[1] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e874 = (_e673.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e866)) - 8388608f) * _e717)) ^ _e117)));
                                        let _e878 = select(select(_e673.member.member_1[0], _e874, (_e874 < _e673.member.member_1[0])), _e673.member.member_1[0], (_e866 == 1023u));
                                        let _e881 = ((_e691.member_1[1] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e889 = (_e673.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e739)) ^ _e117)));
                                        let _e893 = select(select(_e673.member.member_1[1], _e889, (_e889 < _e673.member.member_1[1])), _e673.member.member_1[1], (_e881 == 1023u));
                                        let _e896 = ((_e691.member_1[1] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e904 = (_e673.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e761)) ^ _e117)));
                                        let _e908 = select(select(_e673.member.member_1[2], _e904, (_e904 < _e673.member.member_1[2])), _e673.member.member_1[2], (_e896 == 1023u));
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
                                                    phi_3171_ = _e918;
                                                } else {
                                                    phi_3171_ = _e913;
                                                }
                                                let _e1006 = phi_3171_;
                                                let _e1014 = (_e677 % 128u);
                                                let _e1015 = (_e1014 < 128u);
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local_6[_e1014] = _e1006.member_1;
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local_5[_e1014] = _e1006.member.member[0];
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local_4[_e1014] = _e1006.member.member[1];
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local_3[_e1014] = _e1006.member.member[2];
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local_2[_e1014] = _e1006.member.member_1[0];
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local_1[_e1014] = _e1006.member.member_1[1];
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local[_e1014] = _e1006.member.member_1[2];
                                                if _e1015 {
                                                } else {
                                                    phi_3510_ = true;
                                                    break;
                                                }
                                                local_7[_e1014] = select(_e997, _e995, (_e995 > _e997));
                                                if _e1004 {
                                                    phi_3248_ = _e913;
                                                } else {
                                                    phi_3248_ = _e918;
                                                }
                                                let _e1032 = phi_3248_;
                                                phi_3249_ = _e1032;
                                                phi_3250_ = (_e677 + 1u);
                                            } else {
                                                phi_3249_ = type_49();
                                                phi_3250_ = u32();
                                            }
                                            let _e1034 = phi_3249_;
                                            let _e1036 = phi_3250_;
                                            phi_3252_ = _e1034;
                                            phi_3253_ = _e1036;
                                            phi_3254_ = select(true, false, _e1003);
                                        } else {
                                            phi_3252_ = type_49();
                                            phi_3253_ = u32();
                                            phi_3254_ = true;
                                        }
                                        let _e1039 = phi_3252_;
                                        let _e1041 = phi_3253_;
                                        let _e1043 = phi_3254_;
                                        if _e1043 {
                                            if _e1002 {
                                                phi_3261_ = _e913;
                                            } else {
                                                phi_3261_ = _e918;
                                            }
                                            let _e1045 = phi_3261_;
                                            phi_3266_ = _e1045;
                                            phi_3267_ = select(_e1003, true, _e1002);
                                        } else {
                                            phi_3266_ = _e1039;
                                            phi_3267_ = _e675;
                                        }
                                        let _e1048 = phi_3266_;
                                        let _e1050 = phi_3267_;
                                        phi_3514_ = _e632;
                                        phi_3269_ = _e634;
                                        phi_3270_ = _e1048;
                                        phi_3271_ = _e1050;
                                        phi_3272_ = select(_e1041, _e677, _e1043);
                                    }
                                    let _e1726 = phi_3514_;
                                    let _e1728 = phi_3269_;
                                    let _e1730 = phi_3270_;
                                    let _e1732 = phi_3271_;
                                    let _e1734 = phi_3272_;
                                    phi_3513_ = _e1726;
                                    phi_3273_ = _e1728;
                                    phi_3274_ = _e1730;
                                    phi_3275_ = (_e638 - 1u);
                                    phi_3276_ = _e1732;
                                    phi_3277_ = _e1734;
                                } else {
                                    phi_3513_ = _e632;
                                    phi_3273_ = _e634;
                                    phi_3274_ = _e673;
                                    phi_3275_ = _e638;
                                    phi_3276_ = _e675;
                                    phi_3277_ = _e677;
                                }
                                let _e1736 = phi_3513_;
                                let _e1738 = phi_3273_;
                                let _e1740 = phi_3274_;
                                let _e1742 = phi_3275_;
                                let _e1744 = phi_3276_;
                                let _e1746 = phi_3277_;
                                phi_3512_ = _e1736;
                                phi_3278_ = _e1738;
                                phi_3279_ = _e1740;
                                phi_3280_ = _e1742;
                                phi_3281_ = _e1744;
                                phi_3282_ = _e1746;
                            } else {
                                phi_3512_ = _e632;
                                phi_3278_ = type_32();
                                phi_3279_ = type_49();
                                phi_3280_ = u32();
                                phi_3281_ = bool();
                                phi_3282_ = u32();
                            }
                            let _e1748 = phi_3512_;
                            let _e1750 = phi_3278_;
                            let _e1752 = phi_3279_;
                            let _e1754 = phi_3280_;
                            let _e1756 = phi_3281_;
                            let _e1758 = phi_3282_;
                            phi_3511_ = _e1748;
                            phi_997_ = _e1750;
                            phi_1000_ = _e1752;
                            phi_1002_ = _e1754;
                            phi_1004_ = _e1756;
                            phi_1006_ = _e1758;
                            phi_3283_ = _e646;
                        } else {
                            phi_3511_ = _e632;
                            phi_997_ = type_32();
                            phi_1000_ = type_49();
                            phi_1002_ = u32();
                            phi_1004_ = bool();
                            phi_1006_ = u32();
                            phi_3283_ = false;
                        }
                        let _e1760 = phi_3511_;
                        let _e1762 = phi_997_;
                        let _e1764 = phi_1000_;
                        let _e1766 = phi_1002_;
                        let _e1768 = phi_1004_;
                        let _e1770 = phi_1006_;
                        let _e1772 = phi_3283_;
                        continue;
                        continuing {
                            phi_3341_ = _e1760;
                            phi_996_ = _e1762;
                            phi_999_ = _e1764;
                            phi_1001_ = _e1766;
                            phi_1003_ = _e1768;
                            phi_1005_ = _e1770;
                            phi_3510_ = _e1760;
                            break if !(_e1772);
                        }
                    }
                    let _e1775 = phi_3510_;
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
