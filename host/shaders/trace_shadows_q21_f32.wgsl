struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_35 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_47 {
    member: f32,
    member_1: bool,
}

struct type_49 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: array<i32>,
}

struct type_61 {
    member: array<array<u32, 7>>,
}

struct type_63 {
    member: type_35,
    member_1: u32,
}

struct type_64 {
    member: array<vec4<f32>, 3>,
    member_1: type_63,
    member_2: type_63,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_30;
@group(0) @binding(1) 
var<uniform> global_3: type_49;
@group(0) @binding(2) 
var<uniform> global_4: type_49;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_52;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_69;
@group(0) @binding(3) 
var<storage> global_9: type_61;
@group(0) @binding(7) 
var<storage> global_10: type_38;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_324_: u32;
    var phi_368_: i32;
    var phi_392_: type_41;
    var phi_542_: i32;
    var phi_543_: i32;
    var phi_553_: bool;
    var phi_563_: u32;
    var phi_564_: u32;
    var phi_566_: bool;
    var phi_571_: u32;
    var phi_604_: i32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_688_: f32;
    var phi_694_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_734_: f32;
    var phi_745_: f32;
    var phi_754_: f32;
    var phi_760_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_800_: f32;
    var phi_811_: f32;
    var phi_911_: f32;
    var phi_912_: f32;
    var phi_3786_: bool;
    var phi_1001_: type_47;
    var phi_1004_: type_63;
    var phi_1006_: u32;
    var phi_1008_: bool;
    var phi_1010_: u32;
    var phi_1021_: bool;
    var phi_1107_: type_63;
    var phi_1108_: bool;
    var phi_1109_: u32;
    var phi_3039_: u32;
    var phi_3040_: u32;
    var phi_3050_: u32;
    var phi_3052_: u32;
    var phi_3053_: bool;
    var phi_3073_: u32;
    var phi_3074_: u32;
    var phi_3078_: type_64;
    var phi_3422_: type_63;
    var phi_3499_: type_63;
    var phi_3500_: type_63;
    var phi_3501_: u32;
    var phi_3503_: type_63;
    var phi_3504_: u32;
    var phi_3505_: bool;
    var phi_3514_: type_63;
    var phi_3519_: type_63;
    var phi_3520_: bool;
    var phi_1127_: type_47;
    var phi_1130_: type_8;
    var phi_1131_: type_8;
    var phi_1153_: type_8;
    var phi_1174_: u32;
    var phi_1263_: array<array<f32, 3>, 3>;
    var phi_1734_: vec3<f32>;
    var phi_1735_: vec3<f32>;
    var phi_1766_: bool;
    var phi_1775_: vec3<f32>;
    var phi_1815_: type_26;
    var phi_1817_: type_26;
    var phi_1818_: bool;
    var phi_1822_: type_26;
    var phi_1823_: type_26;
    var phi_1824_: type_26;
    var phi_1825_: bool;
    var phi_1829_: type_26;
    var phi_1830_: bool;
    var phi_1834_: type_26;
    var phi_1835_: bool;
    var phi_1839_: type_26;
    var phi_1862_: u32;
    var phi_1876_: i32;
    var phi_1896_: vec3<f32>;
    var phi_1897_: vec3<f32>;
    var phi_1913_: vec3<f32>;
    var phi_1914_: vec3<f32>;
    var phi_1930_: vec3<f32>;
    var phi_1931_: vec3<f32>;
    var phi_1967_: vec3<f32>;
    var phi_2149_: f32;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2173_: type_47;
    var phi_2174_: type_47;
    var phi_1128_: type_47;
    var phi_3780_: bool;
    var local_10: type_47;
    var phi_3922_: bool;
    var phi_3522_: type_47;
    var phi_3523_: type_63;
    var phi_3524_: bool;
    var phi_3525_: u32;
    var phi_3921_: bool;
    var phi_3526_: type_47;
    var phi_3527_: type_63;
    var phi_3528_: u32;
    var phi_3529_: bool;
    var phi_3530_: u32;
    var phi_3920_: bool;
    var phi_3531_: type_47;
    var phi_3532_: type_63;
    var phi_3533_: u32;
    var phi_3534_: bool;
    var phi_3535_: u32;
    var phi_3919_: bool;
    var phi_1002_: type_47;
    var phi_1005_: type_63;
    var phi_1007_: u32;
    var phi_1009_: bool;
    var phi_1011_: u32;
    var phi_3536_: bool;
    var phi_3918_: bool;
    var local_11: type_47;
    var local_12: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_9.member));
            let _e96 = arrayLength((&global_5.member));
            let _e108 = arrayLength((&global_8.member));
            let _e112 = global_4.member[0u][0u];
            let _e116 = global_4.member[0u][1u];
            let _e120 = global_4.member[0u][2u];
            let _e124 = global_4.member[0u][3u];
            let _e128 = global_4.member[1u][0u];
            let _e132 = global_4.member[1u][1u];
            let _e136 = global_4.member[1u][2u];
            let _e140 = (_e92.x + (_e92.y * 2097152u));
            let _e152 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e124) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            local = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            let _e155 = (_e140 < arrayLength((&global_10.member)));
            if _e155 {
                if _e155 {
                } else {
                    break;
                }
                let _e159 = global_10.member[_e140].member_2;
                phi_324_ = _e159;
            } else {
                phi_324_ = 4294967295u;
            }
            let _e161 = phi_324_;
            let _e164 = global_1.member[0u];
            let _e168 = global_3.member[0u][0u];
            let _e172 = global_3.member[0u][1u];
            let _e176 = global_3.member[0u][2u];
            let _e180 = global_3.member[0u][3u];
            let _e184 = global_3.member[1u][0u];
            let _e188 = global_3.member[1u][1u];
            let _e192 = global_3.member[1u][2u];
            let _e196 = global_3.member[1u][3u];
            let _e197 = bitcast<f32>(_e168);
            let _e198 = bitcast<f32>(_e172);
            let _e199 = bitcast<f32>(_e176);
            let _e201 = bitcast<f32>(_e184);
            let _e202 = array<u32, 3>(_e188, _e192, _e196);
            let _e204 = bitcast<i32>(_e164);
            if (_e204 < -126i) {
                phi_368_ = -126i;
            } else {
                phi_368_ = select(_e204, 127i, (_e204 > 127i));
            }
            let _e209 = phi_368_;
            let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
            let _e220 = bitcast<f32>((bitcast<u32>(((_e204 - _e209) + 127i)) << bitcast<u32>(23i)));
            if (_e180 == 0u) {
                phi_392_ = type_41(array<f32, 3>(_e197, _e198, _e199), _e180, _e201, _e202);
            } else {
                phi_392_ = type_41(array<f32, 3>(((_e197 * _e214) * _e220), ((_e198 * _e214) * _e220), ((_e199 * _e214) * _e220)), _e180, ((_e201 * _e214) * _e220), _e202);
            }
            let _e233 = phi_392_;
            if _e155 {
                let _e234 = (_e140 < arrayLength((&global_2.member)));
                if _e234 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e239 = global_10.member[_e140].member.member_1;
                    let _e244 = global_10.member[_e140].member.member_3;
                    if (_e239 <= _e244) {
                        let _e246 = (1u < _e108);
                        if _e246 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e250 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e250 + 1u) < _e250) {
                                if _e246 {
                                } else {
                                    break;
                                }
                                let _e255 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e265 = global_10.member[_e140].member.member_2[0u];
                        let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                        let _e273 = global_10.member[_e140].member.member_2[1u];
                        let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                        let _e281 = global_10.member[_e140].member.member_2[2u];
                        let _e283 = (bitcast<u32>(_e281) & 2147483647u);
                        let _e289 = global_10.member[_e140].member.member[0u];
                        let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                        let _e297 = global_10.member[_e140].member.member[1u];
                        let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                        let _e305 = global_10.member[_e140].member.member[2u];
                        let _e307 = (bitcast<u32>(_e305) & 2147483647u);
                        let _e309 = select(_e275, _e267, (_e275 < _e267));
                        let _e311 = select(_e283, _e309, (_e283 < _e309));
                        let _e313 = select(_e291, _e311, (_e291 < _e311));
                        let _e315 = select(_e299, _e313, (_e299 < _e313));
                        let _e317 = select(_e307, _e315, (_e307 < _e315));
                        let _e319 = (bitcast<u32>(_e239) & 2147483647u);
                        let _e328 = (((select(_e319, _e317, (_e319 < _e317)) < 2139095040u) && ((bitcast<u32>(_e244) & 2147483647u) <= 2139095040u)) && (_e311 > 0u));
                        if _e328 {
                            let _e331 = (bitcast<u32>(bitcast<f32>(_e311)) & 2147483647u);
                            if (_e331 >= 8388608u) {
                                phi_542_ = (bitcast<i32>((_e331 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_542_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e331)), 32u, (_e331 == 0u))));
                            }
                            let _e345 = phi_542_;
                            phi_543_ = _e345;
                        } else {
                            phi_543_ = 0i;
                        }
                        let _e347 = phi_543_;
                        let _e348 = (_e267 == _e311);
                        if _e348 {
                            phi_553_ = true;
                        } else {
                            phi_553_ = (_e275 == _e311);
                        }
                        let _e351 = phi_553_;
                        let _e352 = select(1u, 0u, _e348);
                        if _e351 {
                            let _e353 = (_e352 + 1u);
                            phi_563_ = _e353;
                            phi_564_ = _e353;
                            phi_566_ = select(true, false, (_e353 == 2u));
                        } else {
                            phi_563_ = u32();
                            phi_564_ = 0u;
                            phi_566_ = true;
                        }
                        let _e357 = phi_563_;
                        let _e359 = phi_564_;
                        let _e361 = phi_566_;
                        if _e361 {
                            phi_571_ = (_e359 + 1u);
                        } else {
                            phi_571_ = 0u;
                        }
                        let _e365 = phi_571_;
                        let _e366 = select(_e357, _e359, _e361);
                        let _e367 = select(_e352, select(2u, _e352, _e351), _e361);
                        let _e368 = -(_e347);
                        if (_e368 < -126i) {
                            phi_604_ = -126i;
                        } else {
                            phi_604_ = select(_e368, 127i, (_e368 > 127i));
                        }
                        let _e373 = phi_604_;
                        let _e378 = bitcast<f32>((bitcast<u32>((_e373 + 127i)) << bitcast<u32>(23i)));
                        let _e384 = bitcast<f32>((bitcast<u32>(((_e368 - _e373) + 127i)) << bitcast<u32>(23i)));
                        let _e389 = global_10.member[_e140].member.member;
                        let _e390 = (_e366 == 0u);
                        if _e390 {
                            phi_622_ = _e389[0];
                        } else {
                            phi_622_ = _e389[1];
                        }
                        let _e394 = phi_622_;
                        let _e395 = (_e366 == 2u);
                        if _e395 {
                            phi_628_ = _e389[2];
                        } else {
                            phi_628_ = _e394;
                        }
                        let _e398 = phi_628_;
                        let _e399 = global_10.member[_e140].member.member_2;
                        if _e390 {
                            phi_639_ = _e399[0];
                        } else {
                            phi_639_ = _e399[1];
                        }
                        let _e403 = phi_639_;
                        if _e395 {
                            phi_645_ = _e399[2];
                        } else {
                            phi_645_ = _e403;
                        }
                        let _e406 = phi_645_;
                        let _e408 = ((_e406 * _e378) * _e384);
                        let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e412 {
                            let _e416 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) * 0.00000011920929f);
                            phi_668_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                        } else {
                            phi_668_ = 0f;
                        }
                        let _e420 = phi_668_;
                        let _e421 = (_e398 + _e420);
                        let _e422 = (_e398 - _e420);
                        let _e423 = select(_e408, 0f, _e412);
                        if _e412 {
                            phi_679_ = 38685626000000000000000000f;
                        } else {
                            phi_679_ = (1f / _e408);
                        }
                        let _e426 = phi_679_;
                        let _e427 = (_e365 == 0u);
                        if _e427 {
                            phi_688_ = _e389[0];
                        } else {
                            phi_688_ = _e389[1];
                        }
                        let _e431 = phi_688_;
                        let _e432 = (_e365 == 2u);
                        if _e432 {
                            phi_694_ = _e389[2];
                        } else {
                            phi_694_ = _e431;
                        }
                        let _e435 = phi_694_;
                        if _e427 {
                            phi_705_ = _e399[0];
                        } else {
                            phi_705_ = _e399[1];
                        }
                        let _e439 = phi_705_;
                        if _e432 {
                            phi_711_ = _e399[2];
                        } else {
                            phi_711_ = _e439;
                        }
                        let _e442 = phi_711_;
                        let _e444 = ((_e442 * _e378) * _e384);
                        let _e448 = (bitcast<f32>((bitcast<u32>(_e444) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e448 {
                            let _e452 = (bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)) * 0.00000011920929f);
                            phi_734_ = select(0.00000000000011368684f, _e452, (_e452 > 0.00000000000011368684f));
                        } else {
                            phi_734_ = 0f;
                        }
                        let _e456 = phi_734_;
                        let _e457 = (_e435 + _e456);
                        let _e458 = (_e435 - _e456);
                        let _e459 = select(_e444, 0f, _e448);
                        if _e448 {
                            phi_745_ = 38685626000000000000000000f;
                        } else {
                            phi_745_ = (1f / _e444);
                        }
                        let _e462 = phi_745_;
                        let _e463 = (_e367 == 0u);
                        if _e463 {
                            phi_754_ = _e389[0];
                        } else {
                            phi_754_ = _e389[1];
                        }
                        let _e467 = phi_754_;
                        let _e468 = (_e367 == 2u);
                        if _e468 {
                            phi_760_ = _e389[2];
                        } else {
                            phi_760_ = _e467;
                        }
                        let _e471 = phi_760_;
                        if _e463 {
                            phi_771_ = _e399[0];
                        } else {
                            phi_771_ = _e399[1];
                        }
                        let _e475 = phi_771_;
                        if _e468 {
                            phi_777_ = _e399[2];
                        } else {
                            phi_777_ = _e475;
                        }
                        let _e478 = phi_777_;
                        let _e480 = ((_e478 * _e378) * _e384);
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e484 {
                            let _e488 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                            phi_800_ = select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f));
                        } else {
                            phi_800_ = 0f;
                        }
                        let _e492 = phi_800_;
                        let _e493 = (_e471 + _e492);
                        let _e494 = (_e471 - _e492);
                        let _e495 = select(_e480, 0f, _e484);
                        if _e484 {
                            phi_811_ = 38685626000000000000000000f;
                        } else {
                            phi_811_ = (1f / _e480);
                        }
                        let _e498 = phi_811_;
                        let _e501 = bitcast<f32>((bitcast<u32>(_e398) & 2147483647u));
                        let _e504 = bitcast<f32>((bitcast<u32>(_e435) & 2147483647u));
                        let _e506 = select(_e504, _e501, (_e501 > _e504));
                        let _e509 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                        if (_e328 && (select(_e509, _e506, (_e506 > _e509)) <= 1099511600000f)) {
                            let _e514 = (_e347 / 3i);
                            let _e521 = bitcast<f32>((bitcast<u32>((_e514 + 127i)) << bitcast<u32>(23i)));
                            let _e528 = bitcast<f32>((bitcast<u32>(((_e347 - (2i * _e514)) + 127i)) << bitcast<u32>(23i)));
                            let _e529 = (((_e239 * _e521) * _e521) * _e528);
                            let _e531 = select(340282350000000000000000000000000000000f, _e529, (_e529 < 340282350000000000000000000000000000000f));
                            let _e536 = (((_e244 * _e521) * _e521) * _e528);
                            let _e538 = select(340282350000000000000000000000000000000f, _e536, (_e536 < 340282350000000000000000000000000000000f));
                            phi_911_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                            phi_912_ = select(-340282350000000000000000000000000000000f, _e531, (_e531 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_911_ = 0f;
                            phi_912_ = 1f;
                        }
                        let _e542 = phi_911_;
                        let _e544 = phi_912_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e548 = (_e366 % 3u);
                        let _e549 = (_e548 < 3u);
                        if _e549 {
                        } else {
                            break;
                        }
                        let _e551 = local_1[_e548];
                        let _e554 = (_e365 % 3u);
                        let _e555 = (_e554 < 3u);
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e557 = local_1[_e554];
                        let _e560 = (_e367 % 3u);
                        let _e561 = (_e560 < 3u);
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e563 = local_1[_e560];
                        if _e549 {
                        } else {
                            break;
                        }
                        let _e568 = local[_e548];
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e572 = local[_e554];
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e576 = local[_e560];
                        phi_3786_ = false;
                        phi_1001_ = type_47(_e542, false);
                        phi_1004_ = type_63(type_35(vec4<f32>((f32(_e551) * _e152), (f32(_e557) * _e152), (f32(_e563) * _e152), 0f), vec4<f32>((f32(_e568) * _e152), (f32(_e572) * _e152), (f32(_e576) * _e152), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_1006_ = ((3u * _e94) + 1u);
                        phi_1008_ = (_e544 <= _e542);
                        phi_1010_ = 0u;
                        loop {
                            let _e586 = phi_3786_;
                            let _e588 = phi_1001_;
                            let _e590 = phi_1004_;
                            let _e592 = phi_1006_;
                            let _e594 = phi_1008_;
                            let _e596 = phi_1010_;
                            local_11 = _e588;
                            if _e594 {
                                phi_1021_ = true;
                            } else {
                                phi_1021_ = (_e596 > 0u);
                            }
                            let _e599 = phi_1021_;
                            if _e599 {
                                let _e600 = (_e592 > 0u);
                                if _e600 {
                                    if _e594 {
                                        phi_1107_ = _e590;
                                        phi_1108_ = _e594;
                                        phi_1109_ = _e596;
                                    } else {
                                        let _e601 = (_e596 - 1u);
                                        let _e602 = (_e601 % 128u);
                                        let _e603 = (_e602 < 128u);
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e605 = local_7[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e607 = local_6[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e609 = local_5[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e611 = local_4[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e613 = local_3[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e615 = local_2[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e620 = local_8[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e623 = local_9[_e602];
                                        phi_1107_ = type_63(type_35(vec4<f32>(_e605, _e607, _e609, 0f), vec4<f32>(_e611, _e613, _e615, 0f)), _e620);
                                        phi_1108_ = (_e623 <= _e588.member);
                                        phi_1109_ = _e601;
                                    }
                                    let _e627 = phi_1107_;
                                    let _e629 = phi_1108_;
                                    let _e631 = phi_1109_;
                                    if _e629 {
                                        if ((_e627.member_1 & 2147483648u) != 0u) {
                                            phi_1127_ = _e588;
                                            phi_1130_ = type_8(0u, ((_e627.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1096 = phi_1127_;
                                                let _e1098 = phi_1130_;
                                                local_10 = _e1096;
                                                local_12 = _e1096;
                                                if (_e1098.member < _e1098.member_1) {
                                                    phi_1131_ = type_8((_e1098.member + 1u), _e1098.member_1);
                                                    phi_1153_ = type_8(1u, _e1098.member);
                                                } else {
                                                    phi_1131_ = _e1098;
                                                    phi_1153_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1111 = phi_1131_;
                                                let _e1113 = phi_1153_;
                                                let _e1117 = (bitcast<i32>(_e1113.member) != 0i);
                                                if _e1117 {
                                                    let _e1118 = ((_e627.member_1 & 268435455u) + _e1113.member_1);
                                                    let _e1119 = (_e1118 < _e96);
                                                    if _e1119 {
                                                        if _e1119 {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1123 = global_5.member[_e1118].member_1;
                                                        phi_1174_ = _e1123;
                                                    } else {
                                                        phi_1174_ = 4294967295u;
                                                    }
                                                    let _e1125 = phi_1174_;
                                                    if (_e1118 >= _e96) {
                                                        phi_1263_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1119 {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        if (_e548 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1132 = global_5.member[_e1118].member[_e548];
                                                        if (_e554 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1138 = global_5.member[_e1118].member[_e554];
                                                        if (_e560 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1144 = global_5.member[_e1118].member[_e560];
                                                        let _e1146 = (3u + _e548);
                                                        if (_e1146 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1152 = global_5.member[_e1118].member[_e1146];
                                                        let _e1153 = (3u + _e554);
                                                        if (_e1153 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1159 = global_5.member[_e1118].member[_e1153];
                                                        let _e1160 = (3u + _e560);
                                                        if (_e1160 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1166 = global_5.member[_e1118].member[_e1160];
                                                        let _e1168 = (6u + _e548);
                                                        if (_e1168 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1174 = global_5.member[_e1118].member[_e1168];
                                                        let _e1175 = (6u + _e554);
                                                        if (_e1175 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1181 = global_5.member[_e1118].member[_e1175];
                                                        let _e1182 = (6u + _e560);
                                                        if (_e1182 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1188 = global_5.member[_e1118].member[_e1182];
                                                        phi_1263_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1132, _e1138, _e1144), array<f32, 3>(_e1152, _e1159, _e1166), array<f32, 3>(_e1174, _e1181, _e1188));
                                                    }
                                                    let _e1192 = phi_1263_;
                                                    let _e1200 = (_e1192[0][2] - _e471);
                                                    let _e1203 = (((_e1192[0][0] - _e398) * _e495) - (_e1200 * _e423));
                                                    let _e1206 = (((_e1192[0][1] - _e435) * _e495) - (_e1200 * _e459));
                                                    let _e1213 = (_e1192[1][2] - _e471);
                                                    let _e1216 = (((_e1192[1][0] - _e398) * _e495) - (_e1213 * _e423));
                                                    let _e1219 = (((_e1192[1][1] - _e435) * _e495) - (_e1213 * _e459));
                                                    let _e1226 = (_e1192[2][2] - _e471);
                                                    let _e1229 = (((_e1192[2][0] - _e398) * _e495) - (_e1226 * _e423));
                                                    let _e1232 = (((_e1192[2][1] - _e435) * _e495) - (_e1226 * _e459));
                                                    let _e1233 = (_e1229 * _e1219);
                                                    let _e1234 = (_e1232 * _e1216);
                                                    let _e1235 = (_e1203 * _e1232);
                                                    let _e1236 = (_e1206 * _e1229);
                                                    let _e1237 = (_e1216 * _e1206);
                                                    let _e1238 = (_e1219 * _e1203);
                                                    let _e1243 = (((_e1233 >= _e1234) && (_e1235 >= _e1236)) && (_e1237 >= _e1238));
                                                    if (_e1243 || (((_e1233 <= _e1234) && (_e1235 <= _e1236)) && (_e1237 <= _e1238))) {
                                                        let _e1250 = select(-1f, 1f, _e1243);
                                                        let _e1252 = ((_e1233 - _e1234) * _e1250);
                                                        let _e1254 = select(0f, _e1252, (_e1252 > 0f));
                                                        let _e1256 = ((_e1235 - _e1236) * _e1250);
                                                        let _e1258 = select(0f, _e1256, (_e1256 > 0f));
                                                        let _e1260 = ((_e1237 - _e1238) * _e1250);
                                                        let _e1262 = select(0f, _e1260, (_e1260 > 0f));
                                                        let _e1264 = ((_e1254 + _e1258) + _e1262);
                                                        if (_e1264 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1829_ = type_26();
                                                            phi_1830_ = true;
                                                        } else {
                                                            let _e1267 = select(_e1192[1][0], _e1192[0][0], (_e1192[0][0] < _e1192[1][0]));
                                                            let _e1271 = select(_e1192[1][0], _e1192[0][0], (_e1192[0][0] > _e1192[1][0]));
                                                            let _e1275 = select(_e1192[1][1], _e1192[0][1], (_e1192[0][1] < _e1192[1][1]));
                                                            let _e1279 = select(_e1192[1][1], _e1192[0][1], (_e1192[0][1] > _e1192[1][1]));
                                                            let _e1283 = select(_e1192[1][2], _e1192[0][2], (_e1192[0][2] < _e1192[1][2]));
                                                            let _e1287 = select(_e1192[1][2], _e1192[0][2], (_e1192[0][2] > _e1192[1][2]));
                                                            let _e1292 = ((select(_e1192[2][0], _e1267, (_e1267 < _e1192[2][0])) - _e421) * _e426);
                                                            let _e1293 = ((select(_e1192[2][0], _e1271, (_e1271 > _e1192[2][0])) - _e422) * _e426);
                                                            let _e1296 = ((select(_e1192[2][1], _e1275, (_e1275 < _e1192[2][1])) - _e457) * _e462);
                                                            let _e1297 = ((select(_e1192[2][1], _e1279, (_e1279 > _e1192[2][1])) - _e458) * _e462);
                                                            let _e1300 = ((select(_e1192[2][2], _e1283, (_e1283 < _e1192[2][2])) - _e493) * _e498);
                                                            let _e1301 = ((select(_e1192[2][2], _e1287, (_e1287 > _e1192[2][2])) - _e494) * _e498);
                                                            let _e1303 = select(_e1301, _e1300, (_e1300 < _e1301));
                                                            let _e1305 = select(_e1301, _e1300, (_e1300 > _e1301));
                                                            let _e1307 = select(_e1293, _e1292, (_e1292 < _e1293));
                                                            let _e1309 = select(_e1297, _e1296, (_e1296 < _e1297));
                                                            let _e1311 = select(_e1309, _e1307, (_e1307 > _e1309));
                                                            let _e1313 = select(_e1303, _e1311, (_e1311 > _e1303));
                                                            let _e1315 = select(_e1293, _e1292, (_e1292 > _e1293));
                                                            let _e1317 = select(_e1297, _e1296, (_e1296 > _e1297));
                                                            let _e1319 = select(_e1317, _e1315, (_e1315 < _e1317));
                                                            let _e1321 = select(_e1305, _e1319, (_e1319 < _e1305));
                                                            let _e1322 = -(_e1303);
                                                            let _e1328 = select(_e544, _e1313, (_e1313 > _e544));
                                                            if (_e1328 > (_e1321 + (select(_e1322, _e1305, (_e1305 > _e1322)) * 0.0000019073523f))) {
                                                                phi_1824_ = type_26();
                                                                phi_1825_ = true;
                                                            } else {
                                                                let _e1330 = (_e1328 > _e1096.member);
                                                                if _e1330 {
                                                                    phi_1823_ = type_26();
                                                                } else {
                                                                    let _e1334 = (_e1192[1][0] - _e1192[0][0]);
                                                                    let _e1335 = (_e1192[1][1] - _e1192[0][1]);
                                                                    let _e1336 = (_e1192[1][2] - _e1192[0][2]);
                                                                    let _e1337 = vec3<f32>(_e1334, _e1335, _e1336);
                                                                    let _e1338 = (_e1192[2][0] - _e1192[1][0]);
                                                                    let _e1339 = (_e1192[2][1] - _e1192[1][1]);
                                                                    let _e1340 = (_e1192[2][2] - _e1192[1][2]);
                                                                    let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                                    let _e1342 = (_e1192[0][0] - _e1192[2][0]);
                                                                    let _e1343 = (_e1192[0][1] - _e1192[2][1]);
                                                                    let _e1344 = (_e1192[0][2] - _e1192[2][2]);
                                                                    let _e1345 = vec3<f32>(_e1342, _e1343, _e1344);
                                                                    let _e1348 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                                    let _e1351 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                    let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                                    let _e1356 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                    let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                                                                    let _e1361 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                    let _e1364 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                    let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                    let _e1369 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                    let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                    let _e1374 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                    let _e1377 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                    let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                    let _e1382 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                    let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                    let _e1386 = select(_e1371, _e1358, (_e1358 > _e1371));
                                                                    let _e1388 = select(_e1384, _e1386, (_e1386 > _e1384));
                                                                    if (_e1358 == _e1388) {
                                                                        phi_1734_ = _e1341;
                                                                        phi_1735_ = _e1345;
                                                                    } else {
                                                                        let _e1391 = vec3((_e1371 == _e1388));
                                                                        phi_1734_ = select(_e1337, _e1345, _e1391);
                                                                        phi_1735_ = select(_e1341, _e1337, _e1391);
                                                                    }
                                                                    let _e1395 = phi_1734_;
                                                                    let _e1397 = phi_1735_;
                                                                    let _e1404 = ((_e1395.y * _e1397.z) - (_e1397.y * _e1395.z));
                                                                    let _e1409 = ((_e1395.z * _e1397.x) - (_e1397.z * _e1395.x));
                                                                    let _e1412 = ((_e1395.x * _e1397.y) - (_e1397.x * _e1395.y));
                                                                    if (_e1254 >= _e1258) {
                                                                        phi_1766_ = select(true, false, (_e1254 >= _e1262));
                                                                    } else {
                                                                        phi_1766_ = true;
                                                                    }
                                                                    let _e1417 = phi_1766_;
                                                                    if _e1417 {
                                                                        phi_1775_ = select(vec3<f32>(_e1192[2][0], _e1192[2][1], _e1192[2][2]), vec3<f32>(_e1192[1][0], _e1192[1][1], _e1192[1][2]), vec3((_e1258 >= _e1262)));
                                                                    } else {
                                                                        phi_1775_ = vec3<f32>(_e1192[0][0], _e1192[0][1], _e1192[0][2]);
                                                                    }
                                                                    let _e1422 = phi_1775_;
                                                                    let _e1439 = ((((_e1404 * (_e1422.x - _e398)) + (_e1409 * (_e1422.y - _e435))) + (_e1412 * (_e1422.z - _e471))) / (((_e1404 * _e423) + (_e1409 * _e459)) + (_e1412 * _e495)));
                                                                    let _e1441 = select(_e1321, _e1439, (_e1439 < _e1321));
                                                                    let _e1443 = select(_e1313, _e1441, (_e1441 > _e1313));
                                                                    if (_e1443 >= _e544) {
                                                                        let _e1445 = (_e1443 <= _e1096.member);
                                                                        if _e1445 {
                                                                            let _e1446 = (1f / _e1264);
                                                                            phi_1815_ = type_26(_e1443, (_e1258 * _e1446), (_e1262 * _e1446), _e1125);
                                                                        } else {
                                                                            phi_1815_ = type_26();
                                                                        }
                                                                        let _e1451 = phi_1815_;
                                                                        phi_1817_ = _e1451;
                                                                        phi_1818_ = select(true, false, _e1445);
                                                                    } else {
                                                                        phi_1817_ = type_26();
                                                                        phi_1818_ = true;
                                                                    }
                                                                    let _e1454 = phi_1817_;
                                                                    let _e1456 = phi_1818_;
                                                                    if _e1456 {
                                                                        phi_1822_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1822_ = _e1454;
                                                                    }
                                                                    let _e1458 = phi_1822_;
                                                                    phi_1823_ = _e1458;
                                                                }
                                                                let _e1460 = phi_1823_;
                                                                phi_1824_ = _e1460;
                                                                phi_1825_ = _e1330;
                                                            }
                                                            let _e1462 = phi_1824_;
                                                            let _e1464 = phi_1825_;
                                                            phi_1829_ = _e1462;
                                                            phi_1830_ = _e1464;
                                                        }
                                                        let _e1466 = phi_1829_;
                                                        let _e1468 = phi_1830_;
                                                        phi_1834_ = _e1466;
                                                        phi_1835_ = _e1468;
                                                    } else {
                                                        phi_1834_ = type_26();
                                                        phi_1835_ = true;
                                                    }
                                                    let _e1470 = phi_1834_;
                                                    let _e1472 = phi_1835_;
                                                    if _e1472 {
                                                        phi_1839_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1839_ = _e1470;
                                                    }
                                                    let _e1474 = phi_1839_;
                                                    if (_e1474.member_3 != 4294967295u) {
                                                        if (_e1125 == _e161) {
                                                            phi_2168_ = false;
                                                        } else {
                                                            let _e1478 = (_e1125 < arrayLength((&global_6.member)));
                                                            if _e1478 {
                                                                if _e1478 {
                                                                } else {
                                                                    phi_3780_ = true;
                                                                    break;
                                                                }
                                                                let _e1480 = global_6.member[_e1125];
                                                                phi_1862_ = _e1480;
                                                            } else {
                                                                phi_1862_ = 4294967295u;
                                                            }
                                                            let _e1482 = phi_1862_;
                                                            let _e1483 = (_e1482 < arrayLength((&global_7.member)));
                                                            if _e1483 {
                                                                if _e1483 {
                                                                } else {
                                                                    phi_3780_ = true;
                                                                    break;
                                                                }
                                                                let _e1485 = global_7.member[_e1482];
                                                                phi_1876_ = _e1485;
                                                            } else {
                                                                phi_1876_ = 0i;
                                                            }
                                                            let _e1487 = phi_1876_;
                                                            let _e1488 = (_e1487 == 0i);
                                                            if _e1488 {
                                                                phi_2167_ = true;
                                                            } else {
                                                                if _e390 {
                                                                    phi_1897_ = vec3<f32>(_e1192[0][0], _e1192[0][1], _e1192[0][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1896_ = vec3<f32>(_e1192[0][2], _e1192[0][0], _e1192[0][1]);
                                                                    } else {
                                                                        phi_1896_ = vec3<f32>(_e1192[0][1], _e1192[0][2], _e1192[0][0]);
                                                                    }
                                                                    let _e1493 = phi_1896_;
                                                                    phi_1897_ = _e1493;
                                                                }
                                                                let _e1496 = phi_1897_;
                                                                if _e390 {
                                                                    phi_1914_ = vec3<f32>(_e1192[1][0], _e1192[1][1], _e1192[1][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1913_ = vec3<f32>(_e1192[1][2], _e1192[1][0], _e1192[1][1]);
                                                                    } else {
                                                                        phi_1913_ = vec3<f32>(_e1192[1][1], _e1192[1][2], _e1192[1][0]);
                                                                    }
                                                                    let _e1501 = phi_1913_;
                                                                    phi_1914_ = _e1501;
                                                                }
                                                                let _e1504 = phi_1914_;
                                                                if _e390 {
                                                                    phi_1931_ = vec3<f32>(_e1192[2][0], _e1192[2][1], _e1192[2][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1930_ = vec3<f32>(_e1192[2][2], _e1192[2][0], _e1192[2][1]);
                                                                    } else {
                                                                        phi_1930_ = vec3<f32>(_e1192[2][1], _e1192[2][2], _e1192[2][0]);
                                                                    }
                                                                    let _e1509 = phi_1930_;
                                                                    phi_1931_ = _e1509;
                                                                }
                                                                let _e1512 = phi_1931_;
                                                                let _e1515 = (_e1504.x - _e1496.x);
                                                                let _e1518 = (_e1504.y - _e1496.y);
                                                                let _e1521 = (_e1504.z - _e1496.z);
                                                                let _e1523 = (_e1512.x - _e1496.x);
                                                                let _e1525 = (_e1512.y - _e1496.y);
                                                                let _e1527 = (_e1512.z - _e1496.z);
                                                                if (_e233.member_1 == 1u) {
                                                                    phi_1967_ = (vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]) - _e1496);
                                                                } else {
                                                                    phi_1967_ = vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]);
                                                                }
                                                                let _e1542 = phi_1967_;
                                                                let _e1548 = bitcast<f32>((bitcast<u32>((_e1515 * _e1525)) ^ _e233.member_3[0]));
                                                                let _e1552 = bitcast<f32>((bitcast<u32>((_e1518 * _e1523)) ^ _e233.member_3[0]));
                                                                let _e1556 = bitcast<f32>((bitcast<u32>((_e1518 * _e1527)) ^ _e233.member_3[0]));
                                                                let _e1560 = bitcast<f32>((bitcast<u32>((_e1521 * _e1525)) ^ _e233.member_3[0]));
                                                                let _e1564 = bitcast<f32>((bitcast<u32>((_e1521 * _e1523)) ^ _e233.member_3[0]));
                                                                let _e1568 = bitcast<f32>((bitcast<u32>((_e1515 * _e1527)) ^ _e233.member_3[0]));
                                                                let _e1569 = (_e1556 - _e1560);
                                                                let _e1570 = (_e1564 - _e1568);
                                                                let _e1571 = (_e1548 - _e1552);
                                                                let _e1595 = (bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u)));
                                                                let _e1602 = (bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u)));
                                                                let _e1609 = (bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u)));
                                                                if (_e233.member_2 == 0f) {
                                                                    phi_2149_ = 0f;
                                                                } else {
                                                                    let _e1639 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                    let _e1642 = bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u));
                                                                    let _e1645 = bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u));
                                                                    let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                    let _e1651 = select(_e1645, _e1642, (_e1642 < _e1645));
                                                                    let _e1655 = select(_e1642, _e1639, (_e1639 < _e1642));
                                                                    let _e1657 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                                    let _e1659 = select(_e1645, _e1657, (_e1657 < _e1645));
                                                                    phi_2149_ = bitcast<f32>((bitcast<u32>((_e233.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1647, _e1639, (_e1639 > _e1647)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1659, _e1655, (_e1655 > _e1659)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1651, _e1639, (_e1639 < _e1651)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1595 + _e1602) + _e1609))) ^ _e233.member_3[0]))) * 1.0000005f)) ^ _e233.member_3[0])))) ^ _e233.member_3[0]));
                                                                }
                                                                let _e1686 = phi_2149_;
                                                                phi_2167_ = (_e1488 || !(((((bitcast<f32>((bitcast<u32>((_e1542.x * _e1569)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1542.y * _e1570)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1542.z * _e1571)) ^ _e233.member_3[0]))) * f32(-(_e1487))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1542.x) & 2147483647u)) * _e1595)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1542.y) & 2147483647u)) * _e1602)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1542.z) & 2147483647u)) * _e1609)) ^ _e233.member_3[0]))))) ^ _e233.member_3[0])) + _e1686) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1700 = phi_2167_;
                                                            phi_2168_ = _e1700;
                                                        }
                                                        let _e1702 = phi_2168_;
                                                        if _e1702 {
                                                            phi_2173_ = type_47(_e1096.member, true);
                                                        } else {
                                                            phi_2173_ = _e1096;
                                                        }
                                                        let _e1707 = phi_2173_;
                                                        phi_2174_ = _e1707;
                                                    } else {
                                                        phi_2174_ = _e1096;
                                                    }
                                                    let _e1709 = phi_2174_;
                                                    phi_1128_ = _e1709;
                                                } else {
                                                    phi_1128_ = type_47();
                                                }
                                                let _e1711 = phi_1128_;
                                                continue;
                                                continuing {
                                                    phi_1127_ = _e1711;
                                                    phi_1130_ = _e1111;
                                                    phi_3780_ = _e586;
                                                    break if !(_e1117);
                                                }
                                            }
                                            let _e1714 = phi_3780_;
                                            phi_3918_ = _e1714;
                                            if _e1714 {
                                                break;
                                            }
                                            let _e1716 = local_10;
                                            phi_3922_ = _e1714;
                                            let _e1903 = local_12;
                                            phi_3522_ = _e1903;
                                            phi_3523_ = _e627;
                                            phi_3524_ = false;
                                            phi_3525_ = select(_e631, 0u, _e1716.member_1);
                                        } else {
                                            if (_e627.member_1 >= _e94) {
                                                phi_3078_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e627.member_1 < _e94) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e644 = ((1u + (_e366 * 2u)) % 7u);
                                                if (_e644 < 7u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e649 = global_9.member[_e627.member_1][_e644];
                                                let _e652 = ((1u + (_e365 * 2u)) % 7u);
                                                if (_e652 < 7u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e657 = global_9.member[_e627.member_1][_e652];
                                                let _e660 = ((1u + (_e367 * 2u)) % 7u);
                                                if (_e660 < 7u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e665 = global_9.member[_e627.member_1][_e660];
                                                let _e668 = (((_e366 + 1u) * 2u) % 7u);
                                                if (_e668 < 7u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e673 = global_9.member[_e627.member_1][_e668];
                                                let _e676 = (((_e365 + 1u) * 2u) % 7u);
                                                if (_e676 < 7u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e681 = global_9.member[_e627.member_1][_e676];
                                                let _e684 = (((_e367 + 1u) * 2u) % 7u);
                                                if (_e684 < 7u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e689 = global_9.member[_e627.member_1][_e684];
                                                let _e712 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.x - _e627.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e713 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.y - _e627.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e714 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.z - _e627.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e716 = select(_e152, _e712, (_e712 > _e152));
                                                let _e718 = select(_e152, _e713, (_e713 > _e152));
                                                let _e720 = select(_e152, _e714, (_e714 > _e152));
                                                let _e745 = bitcast<u32>((f32(bitcast<i32>((_e649 & 2097151u))) * _e716));
                                                let _e750 = (bitcast<i32>((_e649 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e753 = bitcast<f32>((_e745 & bitcast<u32>(_e750)));
                                                let _e754 = bitcast<u32>((f32(bitcast<i32>((_e657 & 2097151u))) * _e718));
                                                let _e759 = (bitcast<i32>((_e657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e762 = bitcast<f32>((_e754 & bitcast<u32>(_e759)));
                                                let _e763 = bitcast<u32>((f32(bitcast<i32>((_e665 & 2097151u))) * _e720));
                                                let _e768 = (bitcast<i32>((_e665 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e771 = bitcast<f32>((_e763 & bitcast<u32>(_e768)));
                                                let _e775 = bitcast<f32>((_e745 & bitcast<u32>(~(_e750))));
                                                let _e779 = bitcast<f32>((_e754 & bitcast<u32>(~(_e759))));
                                                let _e783 = bitcast<f32>((_e763 & bitcast<u32>(~(_e768))));
                                                let _e784 = bitcast<u32>((f32(bitcast<i32>((_e673 & 2097151u))) * _e716));
                                                let _e789 = (bitcast<i32>((_e673 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e792 = bitcast<f32>((_e784 & bitcast<u32>(_e789)));
                                                let _e793 = bitcast<u32>((f32(bitcast<i32>((_e681 & 2097151u))) * _e718));
                                                let _e798 = (bitcast<i32>((_e681 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e801 = bitcast<f32>((_e793 & bitcast<u32>(_e798)));
                                                let _e802 = bitcast<u32>((f32(bitcast<i32>((_e689 & 2097151u))) * _e720));
                                                let _e807 = (bitcast<i32>((_e689 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e810 = bitcast<f32>((_e802 & bitcast<u32>(_e807)));
                                                let _e814 = bitcast<f32>((_e784 & bitcast<u32>(~(_e789))));
                                                let _e818 = bitcast<f32>((_e793 & bitcast<u32>(~(_e798))));
                                                let _e822 = bitcast<f32>((_e802 & bitcast<u32>(~(_e807))));
                                                let _e852 = global_9.member[_e627.member_1][0u];
                                                let _e856 = global_9.member[_e627.member_1][2u];
                                                let _e860 = global_9.member[_e627.member_1][4u];
                                                let _e864 = global_9.member[_e627.member_1][6u];
                                                let _e876 = (((_e856 >> bitcast<u32>(22i)) | ((_e860 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e864 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e877 = (_e852 & 268435455u);
                                                let _e878 = (_e876 & 268435455u);
                                                let _e881 = ((_e852 >> bitcast<u32>(28u)) & 7u);
                                                let _e889 = ((_e852 >> bitcast<u32>(31i)) | (((_e876 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e890 = (_e881 != 0u);
                                                if (_e881 == 0u) {
                                                    phi_3040_ = _e877;
                                                } else {
                                                    if (_e881 == 7u) {
                                                        phi_3039_ = 2147483648u;
                                                    } else {
                                                        phi_3039_ = ((2147483648u | (_e881 << bitcast<u32>(28u))) | (_e878 & 268435455u));
                                                    }
                                                    let _e899 = phi_3039_;
                                                    phi_3040_ = _e899;
                                                }
                                                let _e901 = phi_3040_;
                                                if _e890 {
                                                    let _e902 = (_e881 != 7u);
                                                    if _e902 {
                                                        phi_3050_ = (_e878 + _e881);
                                                    } else {
                                                        phi_3050_ = u32();
                                                    }
                                                    let _e905 = phi_3050_;
                                                    phi_3052_ = _e905;
                                                    phi_3053_ = select(true, false, _e902);
                                                } else {
                                                    phi_3052_ = u32();
                                                    phi_3053_ = true;
                                                }
                                                let _e908 = phi_3052_;
                                                let _e910 = phi_3053_;
                                                if (_e889 == 0u) {
                                                    phi_3074_ = (_e877 + select(0u, 1u, !(_e890)));
                                                } else {
                                                    if (_e889 == 7u) {
                                                        phi_3073_ = 2147483648u;
                                                    } else {
                                                        phi_3073_ = ((2147483648u | (_e889 << bitcast<u32>(28u))) | (select(_e908, _e878, _e910) & 268435455u));
                                                    }
                                                    let _e923 = phi_3073_;
                                                    phi_3074_ = _e923;
                                                }
                                                let _e925 = phi_3074_;
                                                phi_3078_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e627.member.member.x + _e753), (_e627.member.member.x + _e775), (_e627.member.member_1.x - _e792), (_e627.member.member_1.x - _e814)), vec4<f32>((_e627.member.member.y + _e762), (_e627.member.member.y + _e779), (_e627.member.member_1.y - _e801), (_e627.member.member_1.y - _e818)), vec4<f32>((_e627.member.member.z + _e771), (_e627.member.member.z + _e783), (_e627.member.member_1.z - _e810), (_e627.member.member_1.z - _e822))), type_63(type_35((_e627.member.member + vec4<f32>(_e753, _e762, _e771, 0f)), (_e627.member.member_1 - vec4<f32>(_e792, _e801, _e810, 0f))), _e901), type_63(type_35((_e627.member.member + vec4<f32>(_e775, _e779, _e783, 0f)), (_e627.member.member_1 - vec4<f32>(_e814, _e818, _e822, 0f))), _e925));
                                            }
                                            let _e930 = phi_3078_;
                                            let _e942 = ((_e930.member[0].x - _e421) * _e426);
                                            let _e943 = ((_e930.member[0].y - _e421) * _e426);
                                            let _e944 = ((_e930.member[0].z - _e422) * _e426);
                                            let _e945 = ((_e930.member[0].w - _e422) * _e426);
                                            let _e955 = ((_e930.member[1].x - _e457) * _e462);
                                            let _e956 = ((_e930.member[1].y - _e457) * _e462);
                                            let _e957 = ((_e930.member[1].z - _e458) * _e462);
                                            let _e958 = ((_e930.member[1].w - _e458) * _e462);
                                            let _e968 = ((_e930.member[2].x - _e493) * _e498);
                                            let _e969 = ((_e930.member[2].y - _e493) * _e498);
                                            let _e970 = ((_e930.member[2].z - _e494) * _e498);
                                            let _e971 = ((_e930.member[2].w - _e494) * _e498);
                                            let _e973 = select(_e970, _e968, (_e968 < _e970));
                                            let _e975 = select(_e971, _e969, (_e969 < _e971));
                                            let _e977 = select(_e970, _e968, (_e968 > _e970));
                                            let _e979 = select(_e971, _e969, (_e969 > _e971));
                                            let _e981 = select(_e944, _e942, (_e942 < _e944));
                                            let _e983 = select(_e945, _e943, (_e943 < _e945));
                                            let _e985 = select(_e957, _e955, (_e955 < _e957));
                                            let _e987 = select(_e958, _e956, (_e956 < _e958));
                                            let _e989 = select(_e985, _e981, (_e981 > _e985));
                                            let _e991 = select(_e987, _e983, (_e983 > _e987));
                                            let _e993 = select(_e973, _e989, (_e989 > _e973));
                                            let _e995 = select(_e975, _e991, (_e991 > _e975));
                                            let _e997 = select(_e944, _e942, (_e942 > _e944));
                                            let _e999 = select(_e945, _e943, (_e943 > _e945));
                                            let _e1001 = select(_e957, _e955, (_e955 > _e957));
                                            let _e1003 = select(_e958, _e956, (_e956 > _e958));
                                            let _e1005 = select(_e1001, _e997, (_e997 < _e1001));
                                            let _e1007 = select(_e1003, _e999, (_e999 < _e1003));
                                            let _e1012 = -(_e973);
                                            let _e1013 = -(_e975);
                                            let _e1020 = (select(_e977, _e1005, (_e1005 < _e977)) + (select(_e1012, _e977, (_e977 > _e1012)) * 0.0000019073523f));
                                            let _e1021 = (select(_e979, _e1007, (_e1007 < _e979)) + (select(_e1013, _e979, (_e979 > _e1013)) * 0.0000019073523f));
                                            let _e1023 = select(_e544, _e993, (_e993 > _e544));
                                            let _e1025 = select(_e544, _e995, (_e995 > _e544));
                                            let _e1030 = (_e1023 <= select(_e588.member, _e1020, (_e1020 < _e588.member)));
                                            let _e1031 = (_e1025 <= select(_e588.member, _e1021, (_e1021 < _e588.member)));
                                            let _e1032 = (_e1023 <= _e1025);
                                            if _e1030 {
                                                if _e1031 {
                                                    if _e1032 {
                                                        phi_3422_ = _e930.member_2;
                                                    } else {
                                                        phi_3422_ = _e930.member_1;
                                                    }
                                                    let _e1036 = phi_3422_;
                                                    let _e1058 = (_e631 % 128u);
                                                    let _e1059 = (_e1058 < 128u);
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1058] = _e1036.member_1;
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1058] = _e1036.member.member.x;
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1058] = _e1036.member.member.y;
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1058] = _e1036.member.member.z;
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1058] = _e1036.member.member_1.x;
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1058] = _e1036.member.member_1.y;
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1058] = _e1036.member.member_1.z;
                                                    if _e1059 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1058] = select(_e1025, _e1023, (_e1023 > _e1025));
                                                    if _e1032 {
                                                        phi_3499_ = _e930.member_1;
                                                    } else {
                                                        phi_3499_ = _e930.member_2;
                                                    }
                                                    let _e1072 = phi_3499_;
                                                    phi_3500_ = _e1072;
                                                    phi_3501_ = (_e631 + 1u);
                                                } else {
                                                    phi_3500_ = type_63();
                                                    phi_3501_ = u32();
                                                }
                                                let _e1074 = phi_3500_;
                                                let _e1076 = phi_3501_;
                                                phi_3503_ = _e1074;
                                                phi_3504_ = _e1076;
                                                phi_3505_ = select(true, false, _e1031);
                                            } else {
                                                phi_3503_ = type_63();
                                                phi_3504_ = u32();
                                                phi_3505_ = true;
                                            }
                                            let _e1079 = phi_3503_;
                                            let _e1081 = phi_3504_;
                                            let _e1083 = phi_3505_;
                                            if _e1083 {
                                                if _e1030 {
                                                    phi_3514_ = _e930.member_1;
                                                } else {
                                                    phi_3514_ = _e930.member_2;
                                                }
                                                let _e1087 = phi_3514_;
                                                phi_3519_ = _e1087;
                                                phi_3520_ = select(_e1031, true, _e1030);
                                            } else {
                                                phi_3519_ = _e1079;
                                                phi_3520_ = _e629;
                                            }
                                            let _e1090 = phi_3519_;
                                            let _e1092 = phi_3520_;
                                            phi_3922_ = _e586;
                                            phi_3522_ = _e588;
                                            phi_3523_ = _e1090;
                                            phi_3524_ = _e1092;
                                            phi_3525_ = select(_e1081, _e631, _e1083);
                                        }
                                        let _e1720 = phi_3922_;
                                        let _e1722 = phi_3522_;
                                        let _e1724 = phi_3523_;
                                        let _e1726 = phi_3524_;
                                        let _e1728 = phi_3525_;
                                        phi_3921_ = _e1720;
                                        phi_3526_ = _e1722;
                                        phi_3527_ = _e1724;
                                        phi_3528_ = (_e592 - 1u);
                                        phi_3529_ = _e1726;
                                        phi_3530_ = _e1728;
                                    } else {
                                        phi_3921_ = _e586;
                                        phi_3526_ = _e588;
                                        phi_3527_ = _e627;
                                        phi_3528_ = _e592;
                                        phi_3529_ = _e629;
                                        phi_3530_ = _e631;
                                    }
                                    let _e1730 = phi_3921_;
                                    let _e1732 = phi_3526_;
                                    let _e1734 = phi_3527_;
                                    let _e1736 = phi_3528_;
                                    let _e1738 = phi_3529_;
                                    let _e1740 = phi_3530_;
                                    phi_3920_ = _e1730;
                                    phi_3531_ = _e1732;
                                    phi_3532_ = _e1734;
                                    phi_3533_ = _e1736;
                                    phi_3534_ = _e1738;
                                    phi_3535_ = _e1740;
                                } else {
                                    phi_3920_ = _e586;
                                    phi_3531_ = type_47();
                                    phi_3532_ = type_63();
                                    phi_3533_ = u32();
                                    phi_3534_ = bool();
                                    phi_3535_ = u32();
                                }
                                let _e1742 = phi_3920_;
                                let _e1744 = phi_3531_;
                                let _e1746 = phi_3532_;
                                let _e1748 = phi_3533_;
                                let _e1750 = phi_3534_;
                                let _e1752 = phi_3535_;
                                phi_3919_ = _e1742;
                                phi_1002_ = _e1744;
                                phi_1005_ = _e1746;
                                phi_1007_ = _e1748;
                                phi_1009_ = _e1750;
                                phi_1011_ = _e1752;
                                phi_3536_ = _e600;
                            } else {
                                phi_3919_ = _e586;
                                phi_1002_ = type_47();
                                phi_1005_ = type_63();
                                phi_1007_ = u32();
                                phi_1009_ = bool();
                                phi_1011_ = u32();
                                phi_3536_ = false;
                            }
                            let _e1754 = phi_3919_;
                            let _e1756 = phi_1002_;
                            let _e1758 = phi_1005_;
                            let _e1760 = phi_1007_;
                            let _e1762 = phi_1009_;
                            let _e1764 = phi_1011_;
                            let _e1766 = phi_3536_;
                            continue;
                            continuing {
                                phi_3786_ = _e1754;
                                phi_1001_ = _e1756;
                                phi_1004_ = _e1758;
                                phi_1006_ = _e1760;
                                phi_1008_ = _e1762;
                                phi_1010_ = _e1764;
                                phi_3918_ = _e1754;
                                break if !(_e1766);
                            }
                        }
                        let _e1769 = phi_3918_;
                        if _e1769 {
                            break;
                        }
                        let _e1771 = local_11;
                        if _e1771.member_1 {
                        } else {
                            if _e234 {
                            } else {
                                break;
                            }
                            let _e1775 = global_2.member[_e140];
                            if _e155 {
                            } else {
                                break;
                            }
                            let _e1779 = global_10.member[_e140].member_1;
                            if _e234 {
                            } else {
                                break;
                            }
                            global_2.member[_e140] = type_28(_e1775.member, _e1775.member_1, _e1775.member_2, array<f32, 3>((_e1775.member_3[0] + (_e1779[0] * _e1775.member_1[0])), (_e1775.member_3[1] + (_e1779[1] * _e1775.member_1[1])), (_e1775.member_3[2] + (_e1779[2] * _e1775.member_1[2]))), _e1775.member_4);
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_shadows_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
