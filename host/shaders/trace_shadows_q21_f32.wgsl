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

struct type_58 {
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
var<storage> global_9: type_58;
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
    var phi_336_: u32;
    var phi_380_: i32;
    var phi_520_: type_41;
    var phi_670_: i32;
    var phi_671_: i32;
    var phi_681_: bool;
    var phi_691_: u32;
    var phi_692_: u32;
    var phi_694_: bool;
    var phi_699_: u32;
    var phi_732_: i32;
    var phi_750_: f32;
    var phi_756_: f32;
    var phi_796_: f32;
    var phi_802_: f32;
    var phi_854_: f32;
    var phi_866_: f32;
    var phi_875_: f32;
    var phi_881_: f32;
    var phi_921_: f32;
    var phi_927_: f32;
    var phi_979_: f32;
    var phi_991_: f32;
    var phi_1000_: f32;
    var phi_1006_: f32;
    var phi_1046_: f32;
    var phi_1052_: f32;
    var phi_1104_: f32;
    var phi_1116_: f32;
    var phi_1171_: i32;
    var phi_1193_: u32;
    var phi_1194_: u32;
    var phi_1231_: i32;
    var phi_1253_: u32;
    var phi_1254_: u32;
    var phi_1262_: f32;
    var phi_1263_: f32;
    var phi_4374_: bool;
    var phi_1359_: type_47;
    var phi_1362_: bool;
    var phi_1364_: u32;
    var phi_1366_: u32;
    var phi_1368_: type_63;
    var phi_1379_: bool;
    var phi_1465_: bool;
    var phi_1466_: u32;
    var phi_1467_: type_63;
    var phi_3598_: u32;
    var phi_3599_: u32;
    var phi_3609_: u32;
    var phi_3611_: u32;
    var phi_3612_: bool;
    var phi_3632_: u32;
    var phi_3633_: u32;
    var phi_3637_: type_64;
    var phi_3999_: type_63;
    var phi_4076_: type_63;
    var phi_4077_: u32;
    var phi_4078_: type_63;
    var phi_4080_: u32;
    var phi_4081_: type_63;
    var phi_4082_: bool;
    var phi_4091_: type_63;
    var phi_4096_: bool;
    var phi_4098_: type_63;
    var phi_1485_: type_47;
    var phi_1488_: type_8;
    var phi_1489_: type_8;
    var phi_1511_: type_8;
    var phi_1532_: u32;
    var phi_1624_: array<array<f32, 3>, 3>;
    var phi_1776_: bool;
    var phi_1805_: bool;
    var phi_2224_: f32;
    var phi_2225_: f32;
    var phi_2226_: f32;
    var phi_2227_: f32;
    var phi_2228_: vec3<f32>;
    var phi_2229_: vec3<f32>;
    var phi_2230_: vec3<f32>;
    var phi_2231_: vec3<f32>;
    var phi_2268_: bool;
    var phi_2277_: vec3<f32>;
    var phi_2442_: f32;
    var phi_2444_: f32;
    var phi_2445_: bool;
    var phi_2465_: f32;
    var phi_2466_: f32;
    var phi_2489_: type_26;
    var phi_2491_: type_26;
    var phi_2492_: bool;
    var phi_2496_: type_26;
    var phi_2497_: type_26;
    var phi_2498_: type_26;
    var phi_2499_: bool;
    var phi_2503_: type_26;
    var phi_2504_: bool;
    var phi_2505_: type_26;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2508_: type_26;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2518_: type_26;
    var phi_2519_: bool;
    var phi_2523_: type_26;
    var phi_2546_: u32;
    var phi_2560_: i32;
    var phi_2582_: vec3<f32>;
    var phi_2583_: vec3<f32>;
    var phi_2601_: vec3<f32>;
    var phi_2602_: vec3<f32>;
    var phi_2620_: vec3<f32>;
    var phi_2621_: vec3<f32>;
    var phi_2657_: vec3<f32>;
    var phi_2839_: f32;
    var phi_2857_: bool;
    var phi_2858_: bool;
    var phi_2863_: type_47;
    var phi_2864_: type_47;
    var phi_1486_: type_47;
    var phi_4368_: bool;
    var local_10: type_47;
    var phi_4564_: bool;
    var phi_4102_: type_47;
    var phi_4103_: bool;
    var phi_4104_: u32;
    var phi_4105_: type_63;
    var phi_4563_: bool;
    var phi_4106_: type_47;
    var phi_4107_: bool;
    var phi_4108_: u32;
    var phi_4109_: u32;
    var phi_4110_: type_63;
    var phi_4562_: bool;
    var phi_4111_: type_47;
    var phi_4112_: bool;
    var phi_4113_: u32;
    var phi_4114_: u32;
    var phi_4115_: type_63;
    var phi_4561_: bool;
    var phi_1360_: type_47;
    var phi_1363_: bool;
    var phi_1365_: u32;
    var phi_1367_: u32;
    var phi_1369_: type_63;
    var phi_4116_: bool;
    var phi_4560_: bool;
    var local_11: type_47;
    var local_12: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_9.member));
            let _e101 = arrayLength((&global_5.member));
            let _e113 = arrayLength((&global_8.member));
            let _e117 = global_4.member[0u][0u];
            let _e121 = global_4.member[0u][1u];
            let _e125 = global_4.member[0u][2u];
            let _e129 = global_4.member[0u][3u];
            let _e133 = global_4.member[1u][0u];
            let _e137 = global_4.member[1u][1u];
            let _e141 = global_4.member[1u][2u];
            let _e145 = (_e97.x + (_e97.y * 2097152u));
            let _e157 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e129) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            local = array<i32, 3>(bitcast<i32>(_e133), bitcast<i32>(_e137), bitcast<i32>(_e141));
            let _e160 = (_e145 < arrayLength((&global_10.member)));
            if _e160 {
                if _e160 {
                } else {
                    break;
                }
                let _e164 = global_10.member[_e145].member_2;
                phi_336_ = _e164;
            } else {
                phi_336_ = 4294967295u;
            }
            let _e166 = phi_336_;
            let _e169 = global_1.member[0u];
            let _e173 = global_3.member[0u][0u];
            let _e177 = global_3.member[0u][1u];
            let _e181 = global_3.member[0u][2u];
            let _e185 = global_3.member[0u][3u];
            let _e189 = global_3.member[1u][0u];
            let _e193 = global_3.member[1u][1u];
            let _e197 = global_3.member[1u][2u];
            let _e201 = global_3.member[1u][3u];
            let _e202 = bitcast<f32>(_e173);
            let _e203 = bitcast<f32>(_e177);
            let _e204 = bitcast<f32>(_e181);
            let _e206 = bitcast<f32>(_e189);
            let _e207 = array<u32, 3>(_e193, _e197, _e201);
            let _e209 = bitcast<i32>(_e169);
            if (_e209 < -126i) {
                phi_380_ = -126i;
            } else {
                phi_380_ = select(_e209, 127i, (_e209 > 127i));
            }
            let _e214 = phi_380_;
            let _e219 = bitcast<f32>((bitcast<u32>((_e214 + 127i)) << bitcast<u32>(23i)));
            let _e225 = bitcast<f32>((bitcast<u32>(((_e209 - _e214) + 127i)) << bitcast<u32>(23i)));
            if (_e185 == 0u) {
                phi_520_ = type_41(array<f32, 3>(_e202, _e203, _e204), _e185, _e206, _e207);
            } else {
                let _e227 = bitcast<u32>(_e202);
                let _e229 = ((_e227 & 2139095040u) != 0u);
                let _e244 = bitcast<u32>(_e203);
                let _e246 = ((_e244 & 2139095040u) != 0u);
                let _e261 = bitcast<u32>(_e204);
                let _e263 = ((_e261 & 2139095040u) != 0u);
                let _e279 = bitcast<u32>(_e206);
                let _e281 = ((_e279 & 2139095040u) != 0u);
                phi_520_ = type_41(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e227 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e227 & 2147483648u))), _e202, _e229) * _e219) * select(0.00000011920929f, 1f, _e229)) * _e225), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e244 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e244 & 2147483648u))), _e203, _e246) * _e219) * select(0.00000011920929f, 1f, _e246)) * _e225), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e261 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e261 & 2147483648u))), _e204, _e263) * _e219) * select(0.00000011920929f, 1f, _e263)) * _e225)), _e185, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e279 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e279 & 2147483648u))), _e206, _e281) * _e219) * select(0.00000011920929f, 1f, _e281)) * _e225), _e207);
            }
            let _e298 = phi_520_;
            if _e160 {
                let _e299 = (_e145 < arrayLength((&global_2.member)));
                if _e299 {
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e304 = global_10.member[_e145].member.member_1;
                    let _e309 = global_10.member[_e145].member.member_3;
                    if (_e304 <= _e309) {
                        let _e311 = (1u < _e113);
                        if _e311 {
                            if (0u < _e113) {
                            } else {
                                break;
                            }
                            let _e315 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e315 + 1u) < _e315) {
                                if _e311 {
                                } else {
                                    break;
                                }
                                let _e320 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e160 {
                        } else {
                            break;
                        }
                        let _e330 = global_10.member[_e145].member.member_2[0u];
                        let _e332 = (bitcast<u32>(_e330) & 2147483647u);
                        let _e338 = global_10.member[_e145].member.member_2[1u];
                        let _e340 = (bitcast<u32>(_e338) & 2147483647u);
                        let _e346 = global_10.member[_e145].member.member_2[2u];
                        let _e348 = (bitcast<u32>(_e346) & 2147483647u);
                        let _e354 = global_10.member[_e145].member.member[0u];
                        let _e356 = (bitcast<u32>(_e354) & 2147483647u);
                        let _e362 = global_10.member[_e145].member.member[1u];
                        let _e364 = (bitcast<u32>(_e362) & 2147483647u);
                        let _e370 = global_10.member[_e145].member.member[2u];
                        let _e372 = (bitcast<u32>(_e370) & 2147483647u);
                        let _e374 = select(_e340, _e332, (_e340 < _e332));
                        let _e376 = select(_e348, _e374, (_e348 < _e374));
                        let _e378 = select(_e356, _e376, (_e356 < _e376));
                        let _e380 = select(_e364, _e378, (_e364 < _e378));
                        let _e382 = select(_e372, _e380, (_e372 < _e380));
                        let _e383 = bitcast<u32>(_e304);
                        let _e384 = (_e383 & 2147483647u);
                        let _e388 = bitcast<u32>(_e309);
                        let _e389 = (_e388 & 2147483647u);
                        let _e393 = (((select(_e384, _e382, (_e384 < _e382)) < 2139095040u) && (_e389 <= 2139095040u)) && (_e376 > 0u));
                        if _e393 {
                            let _e396 = (bitcast<u32>(bitcast<f32>(_e376)) & 2147483647u);
                            if (_e396 >= 8388608u) {
                                phi_670_ = (bitcast<i32>((_e396 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_670_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e396)), 32u, (_e396 == 0u))));
                            }
                            let _e410 = phi_670_;
                            phi_671_ = _e410;
                        } else {
                            phi_671_ = 0i;
                        }
                        let _e412 = phi_671_;
                        let _e413 = (_e332 == _e376);
                        if _e413 {
                            phi_681_ = true;
                        } else {
                            phi_681_ = (_e340 == _e376);
                        }
                        let _e416 = phi_681_;
                        let _e417 = select(1u, 0u, _e413);
                        if _e416 {
                            let _e418 = (_e417 + 1u);
                            phi_691_ = _e418;
                            phi_692_ = _e418;
                            phi_694_ = select(true, false, (_e418 == 2u));
                        } else {
                            phi_691_ = u32();
                            phi_692_ = 0u;
                            phi_694_ = true;
                        }
                        let _e422 = phi_691_;
                        let _e424 = phi_692_;
                        let _e426 = phi_694_;
                        if _e426 {
                            phi_699_ = (_e424 + 1u);
                        } else {
                            phi_699_ = 0u;
                        }
                        let _e430 = phi_699_;
                        let _e431 = select(_e422, _e424, _e426);
                        let _e432 = select(_e417, select(2u, _e417, _e416), _e426);
                        let _e433 = -(_e412);
                        if (_e433 < -126i) {
                            phi_732_ = -126i;
                        } else {
                            phi_732_ = select(_e433, 127i, (_e433 > 127i));
                        }
                        let _e438 = phi_732_;
                        let _e443 = bitcast<f32>((bitcast<u32>((_e438 + 127i)) << bitcast<u32>(23i)));
                        let _e449 = bitcast<f32>((bitcast<u32>(((_e433 - _e438) + 127i)) << bitcast<u32>(23i)));
                        let _e454 = global_10.member[_e145].member.member;
                        let _e455 = (_e431 == 0u);
                        if _e455 {
                            phi_750_ = _e454[0];
                        } else {
                            phi_750_ = _e454[1];
                        }
                        let _e459 = phi_750_;
                        let _e460 = (_e431 == 2u);
                        if _e460 {
                            phi_756_ = _e454[2];
                        } else {
                            phi_756_ = _e459;
                        }
                        let _e463 = phi_756_;
                        let _e464 = bitcast<u32>(_e463);
                        let _e466 = ((_e464 & 2139095040u) != 0u);
                        let _e478 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e464 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e464 & 2147483648u))), _e463, _e466) * select(0.00000011920929f, 1f, _e466));
                        let _e479 = global_10.member[_e145].member.member_2;
                        if _e455 {
                            phi_796_ = _e479[0];
                        } else {
                            phi_796_ = _e479[1];
                        }
                        let _e483 = phi_796_;
                        if _e460 {
                            phi_802_ = _e479[2];
                        } else {
                            phi_802_ = _e483;
                        }
                        let _e486 = phi_802_;
                        let _e487 = bitcast<u32>(_e486);
                        let _e489 = ((_e487 & 2139095040u) != 0u);
                        let _e503 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e487 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e487 & 2147483648u))), _e486, _e489) * _e443) * select(0.00000011920929f, 1f, _e489)) * _e449);
                        let _e507 = (bitcast<f32>((bitcast<u32>(_e503) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e507 {
                            let _e511 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) * 0.00000011920929f);
                            phi_854_ = select(0.00000000000011368684f, _e511, (_e511 > 0.00000000000011368684f));
                        } else {
                            phi_854_ = 0f;
                        }
                        let _e515 = phi_854_;
                        let _e516 = (_e478 + _e515);
                        let _e517 = (_e478 - _e515);
                        let _e518 = select(_e503, 0f, _e507);
                        if _e507 {
                            phi_866_ = 38685626000000000000000000f;
                        } else {
                            phi_866_ = (1f / _e503);
                        }
                        let _e521 = phi_866_;
                        let _e522 = (_e430 == 0u);
                        if _e522 {
                            phi_875_ = _e454[0];
                        } else {
                            phi_875_ = _e454[1];
                        }
                        let _e526 = phi_875_;
                        let _e527 = (_e430 == 2u);
                        if _e527 {
                            phi_881_ = _e454[2];
                        } else {
                            phi_881_ = _e526;
                        }
                        let _e530 = phi_881_;
                        let _e531 = bitcast<u32>(_e530);
                        let _e533 = ((_e531 & 2139095040u) != 0u);
                        let _e545 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e531 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e531 & 2147483648u))), _e530, _e533) * select(0.00000011920929f, 1f, _e533));
                        if _e522 {
                            phi_921_ = _e479[0];
                        } else {
                            phi_921_ = _e479[1];
                        }
                        let _e549 = phi_921_;
                        if _e527 {
                            phi_927_ = _e479[2];
                        } else {
                            phi_927_ = _e549;
                        }
                        let _e552 = phi_927_;
                        let _e553 = bitcast<u32>(_e552);
                        let _e555 = ((_e553 & 2139095040u) != 0u);
                        let _e569 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e553 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e553 & 2147483648u))), _e552, _e555) * _e443) * select(0.00000011920929f, 1f, _e555)) * _e449);
                        let _e573 = (bitcast<f32>((bitcast<u32>(_e569) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e573 {
                            let _e577 = (bitcast<f32>((bitcast<u32>(_e545) & 2147483647u)) * 0.00000011920929f);
                            phi_979_ = select(0.00000000000011368684f, _e577, (_e577 > 0.00000000000011368684f));
                        } else {
                            phi_979_ = 0f;
                        }
                        let _e581 = phi_979_;
                        let _e582 = (_e545 + _e581);
                        let _e583 = (_e545 - _e581);
                        let _e584 = select(_e569, 0f, _e573);
                        if _e573 {
                            phi_991_ = 38685626000000000000000000f;
                        } else {
                            phi_991_ = (1f / _e569);
                        }
                        let _e587 = phi_991_;
                        let _e588 = (_e432 == 0u);
                        if _e588 {
                            phi_1000_ = _e454[0];
                        } else {
                            phi_1000_ = _e454[1];
                        }
                        let _e592 = phi_1000_;
                        let _e593 = (_e432 == 2u);
                        if _e593 {
                            phi_1006_ = _e454[2];
                        } else {
                            phi_1006_ = _e592;
                        }
                        let _e596 = phi_1006_;
                        let _e597 = bitcast<u32>(_e596);
                        let _e599 = ((_e597 & 2139095040u) != 0u);
                        let _e611 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e597 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e597 & 2147483648u))), _e596, _e599) * select(0.00000011920929f, 1f, _e599));
                        if _e588 {
                            phi_1046_ = _e479[0];
                        } else {
                            phi_1046_ = _e479[1];
                        }
                        let _e615 = phi_1046_;
                        if _e593 {
                            phi_1052_ = _e479[2];
                        } else {
                            phi_1052_ = _e615;
                        }
                        let _e618 = phi_1052_;
                        let _e619 = bitcast<u32>(_e618);
                        let _e621 = ((_e619 & 2139095040u) != 0u);
                        let _e635 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e619 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e619 & 2147483648u))), _e618, _e621) * _e443) * select(0.00000011920929f, 1f, _e621)) * _e449);
                        let _e639 = (bitcast<f32>((bitcast<u32>(_e635) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e639 {
                            let _e643 = (bitcast<f32>((bitcast<u32>(_e611) & 2147483647u)) * 0.00000011920929f);
                            phi_1104_ = select(0.00000000000011368684f, _e643, (_e643 > 0.00000000000011368684f));
                        } else {
                            phi_1104_ = 0f;
                        }
                        let _e647 = phi_1104_;
                        let _e648 = (_e611 + _e647);
                        let _e649 = (_e611 - _e647);
                        let _e650 = select(_e635, 0f, _e639);
                        if _e639 {
                            phi_1116_ = 38685626000000000000000000f;
                        } else {
                            phi_1116_ = (1f / _e635);
                        }
                        let _e653 = phi_1116_;
                        let _e656 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
                        let _e659 = bitcast<f32>((bitcast<u32>(_e545) & 2147483647u));
                        let _e661 = select(_e659, _e656, (_e656 > _e659));
                        let _e664 = bitcast<f32>((bitcast<u32>(_e611) & 2147483647u));
                        if (_e393 && (select(_e664, _e661, (_e661 > _e664)) <= 1099511600000f)) {
                            let _e676 = ((_e384 & 8388607u) | (select(0u, 1u, ((_e384 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e679 = bitcast<i32>((_e384 >> bitcast<u32>(23i)));
                            let _e683 = (_e676 == 0u);
                            let _e686 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e676)), 32u, _e683)) - 8i);
                            if (_e679 == 255i) {
                                phi_1171_ = 255i;
                            } else {
                                phi_1171_ = (((_e679 + select(0i, 1i, (_e679 == 0i))) - _e686) + _e412);
                            }
                            let _e694 = phi_1171_;
                            let _e704 = (_e694 <= 0i);
                            if _e704 {
                                phi_1194_ = u32();
                            } else {
                                if _e683 {
                                    phi_1193_ = u32();
                                } else {
                                    phi_1193_ = select(((bitcast<u32>(_e694) << bitcast<u32>(23i)) | ((_e676 << bitcast<u32>(((_e686 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e694 >= 255i));
                                }
                                let _e708 = phi_1193_;
                                phi_1194_ = _e708;
                            }
                            let _e710 = phi_1194_;
                            let _e722 = ((_e389 & 8388607u) | (select(0u, 1u, ((_e389 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e725 = bitcast<i32>((_e389 >> bitcast<u32>(23i)));
                            let _e729 = (_e722 == 0u);
                            let _e732 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e722)), 32u, _e729)) - 8i);
                            if (_e725 == 255i) {
                                phi_1231_ = 255i;
                            } else {
                                phi_1231_ = (((_e725 + select(0i, 1i, (_e725 == 0i))) - _e732) + _e412);
                            }
                            let _e740 = phi_1231_;
                            let _e750 = (_e740 <= 0i);
                            if _e750 {
                                phi_1254_ = u32();
                            } else {
                                if _e729 {
                                    phi_1253_ = u32();
                                } else {
                                    phi_1253_ = select(((bitcast<u32>(_e740) << bitcast<u32>(23i)) | ((_e722 << bitcast<u32>(((_e732 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e740 >= 255i));
                                }
                                let _e754 = phi_1253_;
                                phi_1254_ = _e754;
                            }
                            let _e756 = phi_1254_;
                            phi_1262_ = bitcast<f32>(((_e388 & 2147483648u) | select(_e756, 0u, select(_e729, true, _e750))));
                            phi_1263_ = bitcast<f32>(((_e383 & 2147483648u) | select(_e710, 0u, select(_e683, true, _e704))));
                        } else {
                            phi_1262_ = 0f;
                            phi_1263_ = 1f;
                        }
                        let _e762 = phi_1262_;
                        let _e764 = phi_1263_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e768 = (_e431 % 3u);
                        let _e769 = (_e768 < 3u);
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e771 = local_1[_e768];
                        let _e774 = (_e430 % 3u);
                        let _e775 = (_e774 < 3u);
                        if _e775 {
                        } else {
                            break;
                        }
                        let _e777 = local_1[_e774];
                        let _e780 = (_e432 % 3u);
                        let _e781 = (_e780 < 3u);
                        if _e781 {
                        } else {
                            break;
                        }
                        let _e783 = local_1[_e780];
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e788 = local[_e768];
                        if _e775 {
                        } else {
                            break;
                        }
                        let _e792 = local[_e774];
                        if _e781 {
                        } else {
                            break;
                        }
                        let _e796 = local[_e780];
                        phi_4374_ = false;
                        phi_1359_ = type_47(_e762, false);
                        phi_1362_ = (_e764 <= _e762);
                        phi_1364_ = ((3u * _e99) + 1u);
                        phi_1366_ = 0u;
                        phi_1368_ = type_63(type_35(vec4<f32>((f32(_e771) * _e157), (f32(_e777) * _e157), (f32(_e783) * _e157), 0f), vec4<f32>((f32(_e788) * _e157), (f32(_e792) * _e157), (f32(_e796) * _e157), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                        loop {
                            let _e806 = phi_4374_;
                            let _e808 = phi_1359_;
                            let _e810 = phi_1362_;
                            let _e812 = phi_1364_;
                            let _e814 = phi_1366_;
                            let _e816 = phi_1368_;
                            local_11 = _e808;
                            if _e810 {
                                phi_1379_ = true;
                            } else {
                                phi_1379_ = (_e814 > 0u);
                            }
                            let _e819 = phi_1379_;
                            if _e819 {
                                let _e820 = (_e812 > 0u);
                                if _e820 {
                                    if _e810 {
                                        phi_1465_ = _e810;
                                        phi_1466_ = _e814;
                                        phi_1467_ = _e816;
                                    } else {
                                        let _e821 = (_e814 - 1u);
                                        let _e822 = (_e821 % 128u);
                                        let _e823 = (_e822 < 128u);
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e825 = local_7[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e827 = local_6[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e829 = local_5[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e831 = local_4[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e833 = local_3[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e835 = local_2[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e840 = local_8[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e843 = local_9[_e822];
                                        phi_1465_ = (_e843 <= _e808.member);
                                        phi_1466_ = _e821;
                                        phi_1467_ = type_63(type_35(vec4<f32>(_e825, _e827, _e829, 0f), vec4<f32>(_e831, _e833, _e835, 0f)), _e840);
                                    }
                                    let _e847 = phi_1465_;
                                    let _e849 = phi_1466_;
                                    let _e851 = phi_1467_;
                                    if _e847 {
                                        if ((_e851.member_1 & 2147483648u) != 0u) {
                                            phi_1485_ = _e808;
                                            phi_1488_ = type_8(0u, ((_e851.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1319 = phi_1485_;
                                                let _e1321 = phi_1488_;
                                                local_10 = _e1319;
                                                local_12 = _e1319;
                                                if (_e1321.member < _e1321.member_1) {
                                                    phi_1489_ = type_8((_e1321.member + 1u), _e1321.member_1);
                                                    phi_1511_ = type_8(1u, _e1321.member);
                                                } else {
                                                    phi_1489_ = _e1321;
                                                    phi_1511_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1334 = phi_1489_;
                                                let _e1336 = phi_1511_;
                                                let _e1340 = (bitcast<i32>(_e1336.member) != 0i);
                                                if _e1340 {
                                                    let _e1341 = ((_e851.member_1 & 268435455u) + _e1336.member_1);
                                                    let _e1342 = (_e1341 < _e101);
                                                    if _e1342 {
                                                        if _e1342 {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1346 = global_5.member[_e1341].member_1;
                                                        phi_1532_ = _e1346;
                                                    } else {
                                                        phi_1532_ = 4294967295u;
                                                    }
                                                    let _e1348 = phi_1532_;
                                                    if (_e1341 >= _e101) {
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1342 {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        if (_e768 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1355 = global_5.member[_e1341].member[_e768];
                                                        if (_e774 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1361 = global_5.member[_e1341].member[_e774];
                                                        if (_e780 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1367 = global_5.member[_e1341].member[_e780];
                                                        let _e1369 = (3u + _e768);
                                                        if (_e1369 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1375 = global_5.member[_e1341].member[_e1369];
                                                        let _e1376 = (3u + _e774);
                                                        if (_e1376 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1382 = global_5.member[_e1341].member[_e1376];
                                                        let _e1383 = (3u + _e780);
                                                        if (_e1383 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1389 = global_5.member[_e1341].member[_e1383];
                                                        let _e1391 = (6u + _e768);
                                                        if (_e1391 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1397 = global_5.member[_e1341].member[_e1391];
                                                        let _e1398 = (6u + _e774);
                                                        if (_e1398 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1404 = global_5.member[_e1341].member[_e1398];
                                                        let _e1405 = (6u + _e780);
                                                        if (_e1405 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1411 = global_5.member[_e1341].member[_e1405];
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1355, _e1361, _e1367), array<f32, 3>(_e1375, _e1382, _e1389), array<f32, 3>(_e1397, _e1404, _e1411));
                                                    }
                                                    let _e1415 = phi_1624_;
                                                    let _e1423 = (_e1415[0][2] - _e611);
                                                    let _e1426 = (((_e1415[0][0] - _e478) * _e650) - (_e1423 * _e518));
                                                    let _e1429 = (((_e1415[0][1] - _e545) * _e650) - (_e1423 * _e584));
                                                    let _e1436 = (_e1415[1][2] - _e611);
                                                    let _e1439 = (((_e1415[1][0] - _e478) * _e650) - (_e1436 * _e518));
                                                    let _e1442 = (((_e1415[1][1] - _e545) * _e650) - (_e1436 * _e584));
                                                    let _e1449 = (_e1415[2][2] - _e611);
                                                    let _e1452 = (((_e1415[2][0] - _e478) * _e650) - (_e1449 * _e518));
                                                    let _e1455 = (((_e1415[2][1] - _e545) * _e650) - (_e1449 * _e584));
                                                    let _e1456 = (_e1452 * _e1442);
                                                    let _e1457 = (_e1455 * _e1439);
                                                    let _e1458 = (_e1426 * _e1455);
                                                    let _e1459 = (_e1429 * _e1452);
                                                    let _e1460 = (_e1439 * _e1429);
                                                    let _e1461 = (_e1442 * _e1426);
                                                    let _e1466 = (((_e1456 >= _e1457) && (_e1458 >= _e1459)) && (_e1460 >= _e1461));
                                                    if (_e1466 || (((_e1456 <= _e1457) && (_e1458 <= _e1459)) && (_e1460 <= _e1461))) {
                                                        let _e1473 = select(-1f, 1f, _e1466);
                                                        let _e1475 = ((_e1456 - _e1457) * _e1473);
                                                        let _e1477 = select(0f, _e1475, (_e1475 > 0f));
                                                        let _e1479 = ((_e1458 - _e1459) * _e1473);
                                                        let _e1481 = select(0f, _e1479, (_e1479 > 0f));
                                                        let _e1483 = ((_e1460 - _e1461) * _e1473);
                                                        let _e1485 = select(0f, _e1483, (_e1483 > 0f));
                                                        let _e1487 = ((_e1477 + _e1481) + _e1485);
                                                        if (_e1487 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2508_ = type_26();
                                                            phi_2509_ = true;
                                                            phi_2510_ = false;
                                                        } else {
                                                            let _e1490 = select(_e1439, _e1426, (_e1426 < _e1439));
                                                            if (select(_e1452, _e1490, (_e1490 < _e1452)) > 0f) {
                                                                phi_1776_ = true;
                                                            } else {
                                                                let _e1495 = select(_e1439, _e1426, (_e1426 > _e1439));
                                                                phi_1776_ = (select(_e1452, _e1495, (_e1495 > _e1452)) < 0f);
                                                            }
                                                            let _e1500 = phi_1776_;
                                                            if _e1500 {
                                                                phi_2505_ = type_26();
                                                                phi_2506_ = true;
                                                                phi_2507_ = false;
                                                            } else {
                                                                let _e1502 = select(_e1442, _e1429, (_e1429 < _e1442));
                                                                if (select(_e1455, _e1502, (_e1502 < _e1455)) > 0f) {
                                                                    phi_1805_ = true;
                                                                } else {
                                                                    let _e1507 = select(_e1442, _e1429, (_e1429 > _e1442));
                                                                    phi_1805_ = (select(_e1455, _e1507, (_e1507 > _e1455)) < 0f);
                                                                }
                                                                let _e1512 = phi_1805_;
                                                                if _e1512 {
                                                                    phi_2503_ = type_26();
                                                                    phi_2504_ = false;
                                                                } else {
                                                                    let _e1514 = select(_e1415[1][0], _e1415[0][0], (_e1415[0][0] < _e1415[1][0]));
                                                                    let _e1518 = select(_e1415[1][0], _e1415[0][0], (_e1415[0][0] > _e1415[1][0]));
                                                                    let _e1522 = select(_e1415[1][1], _e1415[0][1], (_e1415[0][1] < _e1415[1][1]));
                                                                    let _e1526 = select(_e1415[1][1], _e1415[0][1], (_e1415[0][1] > _e1415[1][1]));
                                                                    let _e1530 = select(_e1415[1][2], _e1415[0][2], (_e1415[0][2] < _e1415[1][2]));
                                                                    let _e1534 = select(_e1415[1][2], _e1415[0][2], (_e1415[0][2] > _e1415[1][2]));
                                                                    let _e1539 = ((select(_e1415[2][0], _e1514, (_e1514 < _e1415[2][0])) - _e516) * _e521);
                                                                    let _e1540 = ((select(_e1415[2][0], _e1518, (_e1518 > _e1415[2][0])) - _e517) * _e521);
                                                                    let _e1543 = ((select(_e1415[2][1], _e1522, (_e1522 < _e1415[2][1])) - _e582) * _e587);
                                                                    let _e1544 = ((select(_e1415[2][1], _e1526, (_e1526 > _e1415[2][1])) - _e583) * _e587);
                                                                    let _e1547 = ((select(_e1415[2][2], _e1530, (_e1530 < _e1415[2][2])) - _e648) * _e653);
                                                                    let _e1548 = ((select(_e1415[2][2], _e1534, (_e1534 > _e1415[2][2])) - _e649) * _e653);
                                                                    let _e1550 = select(_e1548, _e1547, (_e1547 < _e1548));
                                                                    let _e1552 = select(_e1548, _e1547, (_e1547 > _e1548));
                                                                    let _e1554 = select(_e1540, _e1539, (_e1539 < _e1540));
                                                                    let _e1556 = select(_e1544, _e1543, (_e1543 < _e1544));
                                                                    let _e1558 = select(_e1556, _e1554, (_e1554 > _e1556));
                                                                    let _e1560 = select(_e1550, _e1558, (_e1558 > _e1550));
                                                                    let _e1562 = select(_e1540, _e1539, (_e1539 > _e1540));
                                                                    let _e1564 = select(_e1544, _e1543, (_e1543 > _e1544));
                                                                    let _e1566 = select(_e1564, _e1562, (_e1562 < _e1564));
                                                                    let _e1568 = select(_e1552, _e1566, (_e1566 < _e1552));
                                                                    let _e1569 = -(_e1550);
                                                                    let _e1575 = select(_e764, _e1560, (_e1560 > _e764));
                                                                    if (_e1575 > (_e1568 + (select(_e1569, _e1552, (_e1552 > _e1569)) * 0.0000019073523f))) {
                                                                        phi_2498_ = type_26();
                                                                        phi_2499_ = true;
                                                                    } else {
                                                                        let _e1577 = (_e1575 > _e1319.member);
                                                                        if _e1577 {
                                                                            phi_2497_ = type_26();
                                                                        } else {
                                                                            let _e1578 = vec3<f32>(_e1415[0][0], _e1415[0][1], _e1415[0][2]);
                                                                            let _e1579 = vec3<f32>(_e1415[1][0], _e1415[1][1], _e1415[1][2]);
                                                                            let _e1580 = vec3<f32>(_e1415[2][0], _e1415[2][1], _e1415[2][2]);
                                                                            let _e1581 = (_e1415[1][0] - _e1415[0][0]);
                                                                            let _e1582 = (_e1415[1][1] - _e1415[0][1]);
                                                                            let _e1583 = (_e1415[1][2] - _e1415[0][2]);
                                                                            let _e1584 = vec3<f32>(_e1581, _e1582, _e1583);
                                                                            let _e1585 = (_e1415[2][0] - _e1415[1][0]);
                                                                            let _e1586 = (_e1415[2][1] - _e1415[1][1]);
                                                                            let _e1587 = (_e1415[2][2] - _e1415[1][2]);
                                                                            let _e1588 = vec3<f32>(_e1585, _e1586, _e1587);
                                                                            let _e1589 = (_e1415[0][0] - _e1415[2][0]);
                                                                            let _e1590 = (_e1415[0][1] - _e1415[2][1]);
                                                                            let _e1591 = (_e1415[0][2] - _e1415[2][2]);
                                                                            let _e1592 = vec3<f32>(_e1589, _e1590, _e1591);
                                                                            let _e1595 = bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u));
                                                                            let _e1598 = bitcast<f32>((bitcast<u32>(_e1582) & 2147483647u));
                                                                            let _e1600 = select(_e1598, _e1595, (_e1595 > _e1598));
                                                                            let _e1603 = bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u));
                                                                            let _e1605 = select(_e1603, _e1600, (_e1600 > _e1603));
                                                                            let _e1608 = bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u));
                                                                            let _e1611 = bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u));
                                                                            let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                                            let _e1616 = bitcast<f32>((bitcast<u32>(_e1587) & 2147483647u));
                                                                            let _e1618 = select(_e1616, _e1613, (_e1613 > _e1616));
                                                                            let _e1621 = bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u));
                                                                            let _e1624 = bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u));
                                                                            let _e1626 = select(_e1624, _e1621, (_e1621 > _e1624));
                                                                            let _e1629 = bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u));
                                                                            let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                                            let _e1633 = select(_e1618, _e1605, (_e1605 > _e1618));
                                                                            let _e1635 = select(_e1631, _e1633, (_e1633 > _e1631));
                                                                            if (_e1605 == _e1635) {
                                                                                phi_2224_ = _e1442;
                                                                                phi_2225_ = _e1439;
                                                                                phi_2226_ = _e1429;
                                                                                phi_2227_ = _e1426;
                                                                                phi_2228_ = _e1578;
                                                                                phi_2229_ = _e1592;
                                                                                phi_2230_ = _e1588;
                                                                                phi_2231_ = _e1584;
                                                                            } else {
                                                                                let _e1637 = (_e1618 == _e1635);
                                                                                let _e1642 = vec3(_e1637);
                                                                                phi_2224_ = select(_e1429, _e1455, _e1637);
                                                                                phi_2225_ = select(_e1426, _e1452, _e1637);
                                                                                phi_2226_ = select(_e1455, _e1442, _e1637);
                                                                                phi_2227_ = select(_e1452, _e1439, _e1637);
                                                                                phi_2228_ = select(_e1580, _e1579, _e1642);
                                                                                phi_2229_ = select(_e1588, _e1584, _e1642);
                                                                                phi_2230_ = select(_e1584, _e1592, _e1642);
                                                                                phi_2231_ = select(_e1592, _e1588, _e1642);
                                                                            }
                                                                            let _e1648 = phi_2224_;
                                                                            let _e1650 = phi_2225_;
                                                                            let _e1652 = phi_2226_;
                                                                            let _e1654 = phi_2227_;
                                                                            let _e1656 = phi_2228_;
                                                                            let _e1658 = phi_2229_;
                                                                            let _e1660 = phi_2230_;
                                                                            let _e1662 = phi_2231_;
                                                                            let _e1669 = ((_e1660.y * _e1658.z) - (_e1658.y * _e1660.z));
                                                                            let _e1674 = ((_e1660.z * _e1658.x) - (_e1658.z * _e1660.x));
                                                                            let _e1677 = ((_e1660.x * _e1658.y) - (_e1658.x * _e1660.y));
                                                                            if (_e1477 >= _e1481) {
                                                                                phi_2268_ = select(true, false, (_e1477 >= _e1485));
                                                                            } else {
                                                                                phi_2268_ = true;
                                                                            }
                                                                            let _e1682 = phi_2268_;
                                                                            if _e1682 {
                                                                                phi_2277_ = select(_e1580, _e1579, vec3((_e1481 >= _e1485)));
                                                                            } else {
                                                                                phi_2277_ = _e1578;
                                                                            }
                                                                            let _e1687 = phi_2277_;
                                                                            let _e1698 = (((_e1669 * (_e1687.x - _e478)) + (_e1674 * (_e1687.y - _e545))) + (_e1677 * (_e1687.z - _e611)));
                                                                            let _e1703 = (((_e1669 * _e518) + (_e1674 * _e584)) + (_e1677 * _e650));
                                                                            let _e1704 = (_e1650 - _e1654);
                                                                            let _e1705 = (_e1648 - _e1652);
                                                                            let _e1713 = (-(((_e1654 * _e1704) + (_e1652 * _e1705))) / ((_e1704 * _e1704) + (_e1705 * _e1705)));
                                                                            let _e1715 = select(1f, _e1713, (_e1713 < 1f));
                                                                            let _e1717 = select(0f, _e1715, (_e1715 > 0f));
                                                                            let _e1730 = ((_e1656.x + (_e1662.x * _e1717)) - _e478);
                                                                            let _e1731 = ((_e1656.y + (_e1662.y * _e1717)) - _e545);
                                                                            let _e1732 = ((_e1656.z + (_e1662.z * _e1717)) - _e611);
                                                                            let _e1733 = (_e1732 / _e650);
                                                                            let _e1745 = bitcast<f32>((bitcast<u32>(_e1730) & 2147483647u));
                                                                            let _e1748 = bitcast<f32>((bitcast<u32>(_e1731) & 2147483647u));
                                                                            let _e1750 = select(_e1748, _e1745, (_e1745 > _e1748));
                                                                            let _e1753 = bitcast<f32>((bitcast<u32>(_e1732) & 2147483647u));
                                                                            let _e1755 = select(_e1753, _e1750, (_e1750 > _e1753));
                                                                            let _e1761 = bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u));
                                                                            let _e1764 = bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u));
                                                                            let _e1766 = select(_e1764, _e1761, (_e1761 > _e1764));
                                                                            let _e1769 = bitcast<f32>((bitcast<u32>(_e1677) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1669 * _e1730) + (_e1674 * _e1731)) + (_e1677 * _e1732)) - _e1698)) & 2147483647u)) <= ((0.0000009536743f * select(_e1635, _e1755, (_e1755 > _e1635))) * select(_e1769, _e1766, (_e1766 > _e1769)))) {
                                                                                let _e1779 = bitcast<f32>((bitcast<u32>(_e1660.x) & 2147483647u));
                                                                                let _e1782 = bitcast<f32>((bitcast<u32>(_e1660.y) & 2147483647u));
                                                                                let _e1784 = select(_e1782, _e1779, (_e1779 > _e1782));
                                                                                let _e1787 = bitcast<f32>((bitcast<u32>(_e1660.z) & 2147483647u));
                                                                                let _e1793 = bitcast<f32>((bitcast<u32>(_e1658.x) & 2147483647u));
                                                                                let _e1796 = bitcast<f32>((bitcast<u32>(_e1658.y) & 2147483647u));
                                                                                let _e1798 = select(_e1796, _e1793, (_e1793 > _e1796));
                                                                                let _e1801 = bitcast<f32>((bitcast<u32>(_e1658.z) & 2147483647u));
                                                                                let _e1805 = (bitcast<f32>((bitcast<u32>(_e1703) & 2147483647u)) > ((0.0000038146973f * select(_e1787, _e1784, (_e1784 > _e1787))) * select(_e1801, _e1798, (_e1798 > _e1801))));
                                                                                if _e1805 {
                                                                                    phi_2442_ = (_e1698 / _e1703);
                                                                                } else {
                                                                                    phi_2442_ = f32();
                                                                                }
                                                                                let _e1808 = phi_2442_;
                                                                                phi_2444_ = _e1808;
                                                                                phi_2445_ = select(true, false, _e1805);
                                                                            } else {
                                                                                phi_2444_ = f32();
                                                                                phi_2445_ = true;
                                                                            }
                                                                            let _e1811 = phi_2444_;
                                                                            let _e1813 = phi_2445_;
                                                                            if _e1813 {
                                                                                let _e1821 = (((_e1669 * (_e1730 - (_e518 * _e1733))) + (_e1674 * (_e1731 - (_e584 * _e1733)))) / _e1703);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u)) <= _e1635) {
                                                                                    phi_2465_ = (_e1733 + _e1821);
                                                                                } else {
                                                                                    phi_2465_ = _e1733;
                                                                                }
                                                                                let _e1828 = phi_2465_;
                                                                                phi_2466_ = _e1828;
                                                                            } else {
                                                                                phi_2466_ = _e1811;
                                                                            }
                                                                            let _e1830 = phi_2466_;
                                                                            let _e1832 = select(_e1568, _e1830, (_e1830 < _e1568));
                                                                            let _e1834 = select(_e1560, _e1832, (_e1832 > _e1560));
                                                                            if (_e1834 >= _e764) {
                                                                                let _e1836 = (_e1834 <= _e1319.member);
                                                                                if _e1836 {
                                                                                    let _e1837 = (1f / _e1487);
                                                                                    phi_2489_ = type_26(_e1834, (_e1481 * _e1837), (_e1485 * _e1837), _e1348);
                                                                                } else {
                                                                                    phi_2489_ = type_26();
                                                                                }
                                                                                let _e1842 = phi_2489_;
                                                                                phi_2491_ = _e1842;
                                                                                phi_2492_ = select(true, false, _e1836);
                                                                            } else {
                                                                                phi_2491_ = type_26();
                                                                                phi_2492_ = true;
                                                                            }
                                                                            let _e1845 = phi_2491_;
                                                                            let _e1847 = phi_2492_;
                                                                            if _e1847 {
                                                                                phi_2496_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2496_ = _e1845;
                                                                            }
                                                                            let _e1849 = phi_2496_;
                                                                            phi_2497_ = _e1849;
                                                                        }
                                                                        let _e1851 = phi_2497_;
                                                                        phi_2498_ = _e1851;
                                                                        phi_2499_ = _e1577;
                                                                    }
                                                                    let _e1853 = phi_2498_;
                                                                    let _e1855 = phi_2499_;
                                                                    phi_2503_ = _e1853;
                                                                    phi_2504_ = _e1855;
                                                                }
                                                                let _e1857 = phi_2503_;
                                                                let _e1859 = phi_2504_;
                                                                phi_2505_ = _e1857;
                                                                phi_2506_ = _e1512;
                                                                phi_2507_ = _e1859;
                                                            }
                                                            let _e1861 = phi_2505_;
                                                            let _e1863 = phi_2506_;
                                                            let _e1865 = phi_2507_;
                                                            phi_2508_ = _e1861;
                                                            phi_2509_ = _e1863;
                                                            phi_2510_ = _e1865;
                                                        }
                                                        let _e1867 = phi_2508_;
                                                        let _e1869 = phi_2509_;
                                                        let _e1871 = phi_2510_;
                                                        phi_2518_ = _e1867;
                                                        phi_2519_ = select(_e1871, true, _e1869);
                                                    } else {
                                                        phi_2518_ = type_26();
                                                        phi_2519_ = true;
                                                    }
                                                    let _e1874 = phi_2518_;
                                                    let _e1876 = phi_2519_;
                                                    if _e1876 {
                                                        phi_2523_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2523_ = _e1874;
                                                    }
                                                    let _e1878 = phi_2523_;
                                                    if (_e1878.member_3 != 4294967295u) {
                                                        if (_e1348 == _e166) {
                                                            phi_2858_ = false;
                                                        } else {
                                                            let _e1882 = (_e1348 < arrayLength((&global_6.member)));
                                                            if _e1882 {
                                                                if _e1882 {
                                                                } else {
                                                                    phi_4368_ = true;
                                                                    break;
                                                                }
                                                                let _e1884 = global_6.member[_e1348];
                                                                phi_2546_ = _e1884;
                                                            } else {
                                                                phi_2546_ = 4294967295u;
                                                            }
                                                            let _e1886 = phi_2546_;
                                                            let _e1887 = (_e1886 < arrayLength((&global_7.member)));
                                                            if _e1887 {
                                                                if _e1887 {
                                                                } else {
                                                                    phi_4368_ = true;
                                                                    break;
                                                                }
                                                                let _e1889 = global_7.member[_e1886];
                                                                phi_2560_ = _e1889;
                                                            } else {
                                                                phi_2560_ = 0i;
                                                            }
                                                            let _e1891 = phi_2560_;
                                                            let _e1892 = (_e1891 == 0i);
                                                            if _e1892 {
                                                                phi_2857_ = true;
                                                            } else {
                                                                if _e455 {
                                                                    phi_2583_ = vec3<f32>(_e1415[0][0], _e1415[0][1], _e1415[0][2]);
                                                                } else {
                                                                    if (_e431 == 1u) {
                                                                        phi_2582_ = vec3<f32>(_e1415[0][2], _e1415[0][0], _e1415[0][1]);
                                                                    } else {
                                                                        phi_2582_ = vec3<f32>(_e1415[0][1], _e1415[0][2], _e1415[0][0]);
                                                                    }
                                                                    let _e1897 = phi_2582_;
                                                                    phi_2583_ = _e1897;
                                                                }
                                                                let _e1900 = phi_2583_;
                                                                if _e455 {
                                                                    phi_2602_ = vec3<f32>(_e1415[1][0], _e1415[1][1], _e1415[1][2]);
                                                                } else {
                                                                    if (_e431 == 1u) {
                                                                        phi_2601_ = vec3<f32>(_e1415[1][2], _e1415[1][0], _e1415[1][1]);
                                                                    } else {
                                                                        phi_2601_ = vec3<f32>(_e1415[1][1], _e1415[1][2], _e1415[1][0]);
                                                                    }
                                                                    let _e1905 = phi_2601_;
                                                                    phi_2602_ = _e1905;
                                                                }
                                                                let _e1908 = phi_2602_;
                                                                if _e455 {
                                                                    phi_2621_ = vec3<f32>(_e1415[2][0], _e1415[2][1], _e1415[2][2]);
                                                                } else {
                                                                    if (_e431 == 1u) {
                                                                        phi_2620_ = vec3<f32>(_e1415[2][2], _e1415[2][0], _e1415[2][1]);
                                                                    } else {
                                                                        phi_2620_ = vec3<f32>(_e1415[2][1], _e1415[2][2], _e1415[2][0]);
                                                                    }
                                                                    let _e1913 = phi_2620_;
                                                                    phi_2621_ = _e1913;
                                                                }
                                                                let _e1916 = phi_2621_;
                                                                let _e1919 = (_e1908.x - _e1900.x);
                                                                let _e1922 = (_e1908.y - _e1900.y);
                                                                let _e1925 = (_e1908.z - _e1900.z);
                                                                let _e1927 = (_e1916.x - _e1900.x);
                                                                let _e1929 = (_e1916.y - _e1900.y);
                                                                let _e1931 = (_e1916.z - _e1900.z);
                                                                if (_e298.member_1 == 1u) {
                                                                    phi_2657_ = (vec3<f32>(_e298.member[0], _e298.member[1], _e298.member[2]) - _e1900);
                                                                } else {
                                                                    phi_2657_ = vec3<f32>(_e298.member[0], _e298.member[1], _e298.member[2]);
                                                                }
                                                                let _e1946 = phi_2657_;
                                                                let _e1952 = bitcast<f32>((bitcast<u32>((_e1919 * _e1929)) ^ _e298.member_3[0]));
                                                                let _e1956 = bitcast<f32>((bitcast<u32>((_e1922 * _e1927)) ^ _e298.member_3[0]));
                                                                let _e1960 = bitcast<f32>((bitcast<u32>((_e1922 * _e1931)) ^ _e298.member_3[0]));
                                                                let _e1964 = bitcast<f32>((bitcast<u32>((_e1925 * _e1929)) ^ _e298.member_3[0]));
                                                                let _e1968 = bitcast<f32>((bitcast<u32>((_e1925 * _e1927)) ^ _e298.member_3[0]));
                                                                let _e1972 = bitcast<f32>((bitcast<u32>((_e1919 * _e1931)) ^ _e298.member_3[0]));
                                                                let _e1973 = (_e1960 - _e1964);
                                                                let _e1974 = (_e1968 - _e1972);
                                                                let _e1975 = (_e1952 - _e1956);
                                                                let _e1999 = (bitcast<f32>((bitcast<u32>(_e1960) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1964) & 2147483647u)));
                                                                let _e2006 = (bitcast<f32>((bitcast<u32>(_e1968) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1972) & 2147483647u)));
                                                                let _e2013 = (bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u)));
                                                                if (_e298.member_2 == 0f) {
                                                                    phi_2839_ = 0f;
                                                                } else {
                                                                    let _e2043 = bitcast<f32>((bitcast<u32>(_e1973) & 2147483647u));
                                                                    let _e2046 = bitcast<f32>((bitcast<u32>(_e1974) & 2147483647u));
                                                                    let _e2049 = bitcast<f32>((bitcast<u32>(_e1975) & 2147483647u));
                                                                    let _e2051 = select(_e2049, _e2046, (_e2046 > _e2049));
                                                                    let _e2055 = select(_e2049, _e2046, (_e2046 < _e2049));
                                                                    let _e2059 = select(_e2046, _e2043, (_e2043 < _e2046));
                                                                    let _e2061 = select(_e2046, _e2043, (_e2043 > _e2046));
                                                                    let _e2063 = select(_e2049, _e2061, (_e2061 < _e2049));
                                                                    phi_2839_ = bitcast<f32>((bitcast<u32>((_e298.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2051, _e2043, (_e2043 > _e2051)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2063, _e2059, (_e2059 > _e2063)))) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2055, _e2043, (_e2043 < _e2055)))) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1999 + _e2006) + _e2013))) ^ _e298.member_3[0]))) * 1.0000005f)) ^ _e298.member_3[0])))) ^ _e298.member_3[0]));
                                                                }
                                                                let _e2090 = phi_2839_;
                                                                phi_2857_ = (_e1892 || !(((((bitcast<f32>((bitcast<u32>((_e1946.x * _e1973)) ^ _e298.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1946.y * _e1974)) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1946.z * _e1975)) ^ _e298.member_3[0]))) * f32(-(_e1891))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1946.x) & 2147483647u)) * _e1999)) ^ _e298.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1946.y) & 2147483647u)) * _e2006)) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1946.z) & 2147483647u)) * _e2013)) ^ _e298.member_3[0]))))) ^ _e298.member_3[0])) + _e2090) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2104 = phi_2857_;
                                                            phi_2858_ = _e2104;
                                                        }
                                                        let _e2106 = phi_2858_;
                                                        if _e2106 {
                                                            phi_2863_ = type_47(_e1319.member, true);
                                                        } else {
                                                            phi_2863_ = _e1319;
                                                        }
                                                        let _e2111 = phi_2863_;
                                                        phi_2864_ = _e2111;
                                                    } else {
                                                        phi_2864_ = _e1319;
                                                    }
                                                    let _e2113 = phi_2864_;
                                                    phi_1486_ = _e2113;
                                                } else {
                                                    phi_1486_ = type_47();
                                                }
                                                let _e2115 = phi_1486_;
                                                continue;
                                                continuing {
                                                    phi_1485_ = _e2115;
                                                    phi_1488_ = _e1334;
                                                    phi_4368_ = _e806;
                                                    break if !(_e1340);
                                                }
                                            }
                                            let _e2118 = phi_4368_;
                                            phi_4560_ = _e2118;
                                            if _e2118 {
                                                break;
                                            }
                                            let _e2120 = local_10;
                                            phi_4564_ = _e2118;
                                            let _e2332 = local_12;
                                            phi_4102_ = _e2332;
                                            phi_4103_ = false;
                                            phi_4104_ = select(_e849, 0u, _e2120.member_1);
                                            phi_4105_ = _e851;
                                        } else {
                                            if (_e851.member_1 >= _e99) {
                                                phi_3637_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e851.member_1 < _e99) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e862 = (_e431 * 2u);
                                                let _e864 = ((1u + _e862) % 7u);
                                                if (_e864 < 7u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e869 = global_9.member[_e851.member_1][_e864];
                                                let _e871 = ((_e862 + 2u) % 7u);
                                                if (_e871 < 7u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e876 = global_9.member[_e851.member_1][_e871];
                                                let _e877 = (_e430 * 2u);
                                                let _e879 = ((1u + _e877) % 7u);
                                                if (_e879 < 7u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e884 = global_9.member[_e851.member_1][_e879];
                                                let _e886 = ((_e877 + 2u) % 7u);
                                                if (_e886 < 7u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e891 = global_9.member[_e851.member_1][_e886];
                                                let _e892 = (_e432 * 2u);
                                                let _e894 = ((1u + _e892) % 7u);
                                                if (_e894 < 7u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e899 = global_9.member[_e851.member_1][_e894];
                                                let _e901 = ((_e892 + 2u) % 7u);
                                                if (_e901 < 7u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e906 = global_9.member[_e851.member_1][_e901];
                                                let _e929 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.x - _e851.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e930 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.y - _e851.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e931 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.z - _e851.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e933 = select(_e157, _e929, (_e929 > _e157));
                                                let _e935 = select(_e157, _e930, (_e930 > _e157));
                                                let _e937 = select(_e157, _e931, (_e931 > _e157));
                                                let _e968 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e869 & 2097151u))) - 8388608f) * _e933));
                                                let _e973 = (bitcast<i32>((_e869 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e976 = bitcast<f32>((_e968 & bitcast<u32>(_e973)));
                                                let _e977 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e884 & 2097151u))) - 8388608f) * _e935));
                                                let _e982 = (bitcast<i32>((_e884 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e985 = bitcast<f32>((_e977 & bitcast<u32>(_e982)));
                                                let _e986 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e899 & 2097151u))) - 8388608f) * _e937));
                                                let _e991 = (bitcast<i32>((_e899 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e994 = bitcast<f32>((_e986 & bitcast<u32>(_e991)));
                                                let _e998 = bitcast<f32>((_e968 & bitcast<u32>(~(_e973))));
                                                let _e1002 = bitcast<f32>((_e977 & bitcast<u32>(~(_e982))));
                                                let _e1006 = bitcast<f32>((_e986 & bitcast<u32>(~(_e991))));
                                                let _e1007 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e876 & 2097151u))) - 8388608f) * _e933));
                                                let _e1012 = (bitcast<i32>((_e876 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1015 = bitcast<f32>((_e1007 & bitcast<u32>(_e1012)));
                                                let _e1016 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e891 & 2097151u))) - 8388608f) * _e935));
                                                let _e1021 = (bitcast<i32>((_e891 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1024 = bitcast<f32>((_e1016 & bitcast<u32>(_e1021)));
                                                let _e1025 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e906 & 2097151u))) - 8388608f) * _e937));
                                                let _e1030 = (bitcast<i32>((_e906 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1033 = bitcast<f32>((_e1025 & bitcast<u32>(_e1030)));
                                                let _e1037 = bitcast<f32>((_e1007 & bitcast<u32>(~(_e1012))));
                                                let _e1041 = bitcast<f32>((_e1016 & bitcast<u32>(~(_e1021))));
                                                let _e1045 = bitcast<f32>((_e1025 & bitcast<u32>(~(_e1030))));
                                                let _e1075 = global_9.member[_e851.member_1][0u];
                                                let _e1079 = global_9.member[_e851.member_1][2u];
                                                let _e1083 = global_9.member[_e851.member_1][4u];
                                                let _e1087 = global_9.member[_e851.member_1][6u];
                                                let _e1099 = (((_e1079 >> bitcast<u32>(22i)) | ((_e1083 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1087 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1100 = (_e1075 & 268435455u);
                                                let _e1101 = (_e1099 & 268435455u);
                                                let _e1104 = ((_e1075 >> bitcast<u32>(28u)) & 7u);
                                                let _e1112 = ((_e1075 >> bitcast<u32>(31i)) | (((_e1099 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1113 = (_e1104 != 0u);
                                                if (_e1104 == 0u) {
                                                    phi_3599_ = _e1100;
                                                } else {
                                                    if (_e1104 == 7u) {
                                                        phi_3598_ = 2147483648u;
                                                    } else {
                                                        phi_3598_ = ((2147483648u | (_e1104 << bitcast<u32>(28u))) | (_e1101 & 268435455u));
                                                    }
                                                    let _e1122 = phi_3598_;
                                                    phi_3599_ = _e1122;
                                                }
                                                let _e1124 = phi_3599_;
                                                if _e1113 {
                                                    let _e1125 = (_e1104 != 7u);
                                                    if _e1125 {
                                                        phi_3609_ = (_e1101 + _e1104);
                                                    } else {
                                                        phi_3609_ = u32();
                                                    }
                                                    let _e1128 = phi_3609_;
                                                    phi_3611_ = _e1128;
                                                    phi_3612_ = select(true, false, _e1125);
                                                } else {
                                                    phi_3611_ = u32();
                                                    phi_3612_ = true;
                                                }
                                                let _e1131 = phi_3611_;
                                                let _e1133 = phi_3612_;
                                                if (_e1112 == 0u) {
                                                    phi_3633_ = (_e1100 + select(0u, 1u, !(_e1113)));
                                                } else {
                                                    if (_e1112 == 7u) {
                                                        phi_3632_ = 2147483648u;
                                                    } else {
                                                        phi_3632_ = ((2147483648u | (_e1112 << bitcast<u32>(28u))) | (select(_e1131, _e1101, _e1133) & 268435455u));
                                                    }
                                                    let _e1146 = phi_3632_;
                                                    phi_3633_ = _e1146;
                                                }
                                                let _e1148 = phi_3633_;
                                                phi_3637_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e851.member.member.x + _e976), (_e851.member.member.x + _e998), (_e851.member.member_1.x - _e1015), (_e851.member.member_1.x - _e1037)), vec4<f32>((_e851.member.member.y + _e985), (_e851.member.member.y + _e1002), (_e851.member.member_1.y - _e1024), (_e851.member.member_1.y - _e1041)), vec4<f32>((_e851.member.member.z + _e994), (_e851.member.member.z + _e1006), (_e851.member.member_1.z - _e1033), (_e851.member.member_1.z - _e1045))), type_63(type_35((_e851.member.member + vec4<f32>(_e976, _e985, _e994, 0f)), (_e851.member.member_1 - vec4<f32>(_e1015, _e1024, _e1033, 0f))), _e1124), type_63(type_35((_e851.member.member + vec4<f32>(_e998, _e1002, _e1006, 0f)), (_e851.member.member_1 - vec4<f32>(_e1037, _e1041, _e1045, 0f))), _e1148));
                                            }
                                            let _e1153 = phi_3637_;
                                            let _e1165 = ((_e1153.member[0].x - _e516) * _e521);
                                            let _e1166 = ((_e1153.member[0].y - _e516) * _e521);
                                            let _e1167 = ((_e1153.member[0].z - _e517) * _e521);
                                            let _e1168 = ((_e1153.member[0].w - _e517) * _e521);
                                            let _e1178 = ((_e1153.member[1].x - _e582) * _e587);
                                            let _e1179 = ((_e1153.member[1].y - _e582) * _e587);
                                            let _e1180 = ((_e1153.member[1].z - _e583) * _e587);
                                            let _e1181 = ((_e1153.member[1].w - _e583) * _e587);
                                            let _e1191 = ((_e1153.member[2].x - _e648) * _e653);
                                            let _e1192 = ((_e1153.member[2].y - _e648) * _e653);
                                            let _e1193 = ((_e1153.member[2].z - _e649) * _e653);
                                            let _e1194 = ((_e1153.member[2].w - _e649) * _e653);
                                            let _e1196 = select(_e1193, _e1191, (_e1191 < _e1193));
                                            let _e1198 = select(_e1194, _e1192, (_e1192 < _e1194));
                                            let _e1200 = select(_e1193, _e1191, (_e1191 > _e1193));
                                            let _e1202 = select(_e1194, _e1192, (_e1192 > _e1194));
                                            let _e1204 = select(_e1167, _e1165, (_e1165 < _e1167));
                                            let _e1206 = select(_e1168, _e1166, (_e1166 < _e1168));
                                            let _e1208 = select(_e1180, _e1178, (_e1178 < _e1180));
                                            let _e1210 = select(_e1181, _e1179, (_e1179 < _e1181));
                                            let _e1212 = select(_e1208, _e1204, (_e1204 > _e1208));
                                            let _e1214 = select(_e1210, _e1206, (_e1206 > _e1210));
                                            let _e1216 = select(_e1196, _e1212, (_e1212 > _e1196));
                                            let _e1218 = select(_e1198, _e1214, (_e1214 > _e1198));
                                            let _e1220 = select(_e1167, _e1165, (_e1165 > _e1167));
                                            let _e1222 = select(_e1168, _e1166, (_e1166 > _e1168));
                                            let _e1224 = select(_e1180, _e1178, (_e1178 > _e1180));
                                            let _e1226 = select(_e1181, _e1179, (_e1179 > _e1181));
                                            let _e1228 = select(_e1224, _e1220, (_e1220 < _e1224));
                                            let _e1230 = select(_e1226, _e1222, (_e1222 < _e1226));
                                            let _e1235 = -(_e1196);
                                            let _e1236 = -(_e1198);
                                            let _e1243 = (select(_e1200, _e1228, (_e1228 < _e1200)) + (select(_e1235, _e1200, (_e1200 > _e1235)) * 0.0000019073523f));
                                            let _e1244 = (select(_e1202, _e1230, (_e1230 < _e1202)) + (select(_e1236, _e1202, (_e1202 > _e1236)) * 0.0000019073523f));
                                            let _e1246 = select(_e764, _e1216, (_e1216 > _e764));
                                            let _e1248 = select(_e764, _e1218, (_e1218 > _e764));
                                            let _e1253 = (_e1246 <= select(_e808.member, _e1243, (_e1243 < _e808.member)));
                                            let _e1254 = (_e1248 <= select(_e808.member, _e1244, (_e1244 < _e808.member)));
                                            let _e1255 = (_e1246 <= _e1248);
                                            if _e1253 {
                                                if _e1254 {
                                                    if _e1255 {
                                                        phi_3999_ = _e1153.member_2;
                                                    } else {
                                                        phi_3999_ = _e1153.member_1;
                                                    }
                                                    let _e1259 = phi_3999_;
                                                    let _e1281 = (_e849 % 128u);
                                                    let _e1282 = (_e1281 < 128u);
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1281] = _e1259.member_1;
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1281] = _e1259.member.member.x;
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1281] = _e1259.member.member.y;
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1281] = _e1259.member.member.z;
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1281] = _e1259.member.member_1.x;
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1281] = _e1259.member.member_1.y;
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1281] = _e1259.member.member_1.z;
                                                    if _e1282 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1281] = select(_e1248, _e1246, !(_e1255));
                                                    if _e1255 {
                                                        phi_4076_ = _e1153.member_1;
                                                    } else {
                                                        phi_4076_ = _e1153.member_2;
                                                    }
                                                    let _e1295 = phi_4076_;
                                                    phi_4077_ = (_e849 + 1u);
                                                    phi_4078_ = _e1295;
                                                } else {
                                                    phi_4077_ = u32();
                                                    phi_4078_ = type_63();
                                                }
                                                let _e1297 = phi_4077_;
                                                let _e1299 = phi_4078_;
                                                phi_4080_ = _e1297;
                                                phi_4081_ = _e1299;
                                                phi_4082_ = select(true, false, _e1254);
                                            } else {
                                                phi_4080_ = u32();
                                                phi_4081_ = type_63();
                                                phi_4082_ = true;
                                            }
                                            let _e1302 = phi_4080_;
                                            let _e1304 = phi_4081_;
                                            let _e1306 = phi_4082_;
                                            if _e1306 {
                                                if _e1253 {
                                                    phi_4091_ = _e1153.member_1;
                                                } else {
                                                    phi_4091_ = _e1153.member_2;
                                                }
                                                let _e1310 = phi_4091_;
                                                phi_4096_ = select(_e1254, true, _e1253);
                                                phi_4098_ = _e1310;
                                            } else {
                                                phi_4096_ = _e847;
                                                phi_4098_ = _e1304;
                                            }
                                            let _e1313 = phi_4096_;
                                            let _e1315 = phi_4098_;
                                            phi_4564_ = _e806;
                                            phi_4102_ = _e808;
                                            phi_4103_ = _e1313;
                                            phi_4104_ = select(_e1302, _e849, _e1306);
                                            phi_4105_ = _e1315;
                                        }
                                        let _e2124 = phi_4564_;
                                        let _e2126 = phi_4102_;
                                        let _e2128 = phi_4103_;
                                        let _e2130 = phi_4104_;
                                        let _e2132 = phi_4105_;
                                        phi_4563_ = _e2124;
                                        phi_4106_ = _e2126;
                                        phi_4107_ = _e2128;
                                        phi_4108_ = (_e812 - 1u);
                                        phi_4109_ = _e2130;
                                        phi_4110_ = _e2132;
                                    } else {
                                        phi_4563_ = _e806;
                                        phi_4106_ = _e808;
                                        phi_4107_ = _e847;
                                        phi_4108_ = _e812;
                                        phi_4109_ = _e849;
                                        phi_4110_ = _e851;
                                    }
                                    let _e2134 = phi_4563_;
                                    let _e2136 = phi_4106_;
                                    let _e2138 = phi_4107_;
                                    let _e2140 = phi_4108_;
                                    let _e2142 = phi_4109_;
                                    let _e2144 = phi_4110_;
                                    phi_4562_ = _e2134;
                                    phi_4111_ = _e2136;
                                    phi_4112_ = _e2138;
                                    phi_4113_ = _e2140;
                                    phi_4114_ = _e2142;
                                    phi_4115_ = _e2144;
                                } else {
                                    phi_4562_ = _e806;
                                    phi_4111_ = type_47();
                                    phi_4112_ = bool();
                                    phi_4113_ = u32();
                                    phi_4114_ = u32();
                                    phi_4115_ = type_63();
                                }
                                let _e2146 = phi_4562_;
                                let _e2148 = phi_4111_;
                                let _e2150 = phi_4112_;
                                let _e2152 = phi_4113_;
                                let _e2154 = phi_4114_;
                                let _e2156 = phi_4115_;
                                phi_4561_ = _e2146;
                                phi_1360_ = _e2148;
                                phi_1363_ = _e2150;
                                phi_1365_ = _e2152;
                                phi_1367_ = _e2154;
                                phi_1369_ = _e2156;
                                phi_4116_ = _e820;
                            } else {
                                phi_4561_ = _e806;
                                phi_1360_ = type_47();
                                phi_1363_ = bool();
                                phi_1365_ = u32();
                                phi_1367_ = u32();
                                phi_1369_ = type_63();
                                phi_4116_ = false;
                            }
                            let _e2158 = phi_4561_;
                            let _e2160 = phi_1360_;
                            let _e2162 = phi_1363_;
                            let _e2164 = phi_1365_;
                            let _e2166 = phi_1367_;
                            let _e2168 = phi_1369_;
                            let _e2170 = phi_4116_;
                            continue;
                            continuing {
                                phi_4374_ = _e2158;
                                phi_1359_ = _e2160;
                                phi_1362_ = _e2162;
                                phi_1364_ = _e2164;
                                phi_1366_ = _e2166;
                                phi_1368_ = _e2168;
                                phi_4560_ = _e2158;
                                break if !(_e2170);
                            }
                        }
                        let _e2173 = phi_4560_;
                        if _e2173 {
                            break;
                        }
                        let _e2175 = local_11;
                        if _e2175.member_1 {
                        } else {
                            if _e299 {
                            } else {
                                break;
                            }
                            let _e2179 = global_2.member[_e145];
                            if _e160 {
                            } else {
                                break;
                            }
                            let _e2183 = global_10.member[_e145].member_1;
                            if _e299 {
                            } else {
                                break;
                            }
                            global_2.member[_e145] = type_28(_e2179.member, _e2179.member_1, _e2179.member_2, array<f32, 3>((_e2179.member_3[0] + (_e2183[0] * _e2179.member_1[0])), (_e2179.member_3[1] + (_e2183[1] * _e2179.member_1[1])), (_e2179.member_3[2] + (_e2183[2] * _e2179.member_1[2]))), _e2179.member_4);
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
