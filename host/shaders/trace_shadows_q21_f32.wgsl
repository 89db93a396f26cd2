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
    var phi_4377_: bool;
    var phi_1359_: type_47;
    var phi_1362_: u32;
    var phi_1364_: bool;
    var phi_1366_: u32;
    var phi_1368_: type_63;
    var phi_1379_: bool;
    var phi_1465_: bool;
    var phi_1466_: u32;
    var phi_1467_: type_63;
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
    var phi_4371_: bool;
    var phi_4649_: bool;
    var phi_2865_: type_47;
    var phi_3592_: u32;
    var phi_3593_: u32;
    var phi_3603_: u32;
    var phi_3605_: u32;
    var phi_3606_: bool;
    var phi_3626_: u32;
    var phi_3627_: u32;
    var phi_3631_: type_64;
    var phi_3993_: type_63;
    var phi_4069_: type_63;
    var phi_4070_: u32;
    var phi_4071_: type_63;
    var phi_4073_: u32;
    var phi_4074_: type_63;
    var phi_4075_: bool;
    var phi_4084_: type_63;
    var phi_4089_: bool;
    var phi_4091_: type_63;
    var phi_4095_: bool;
    var phi_4096_: u32;
    var phi_4097_: type_63;
    var phi_4107_: u32;
    var phi_4108_: type_63;
    var phi_4566_: bool;
    var phi_4109_: type_47;
    var phi_4110_: u32;
    var phi_4111_: bool;
    var phi_4112_: u32;
    var phi_4113_: type_63;
    var phi_4565_: bool;
    var phi_4114_: type_47;
    var phi_4115_: u32;
    var phi_4116_: bool;
    var phi_4117_: u32;
    var phi_4118_: type_63;
    var phi_4564_: bool;
    var phi_1360_: type_47;
    var phi_1363_: u32;
    var phi_1365_: bool;
    var phi_1367_: u32;
    var phi_1369_: type_63;
    var phi_4119_: bool;
    var phi_4563_: bool;
    var local_10: type_47;
    var local_11: type_47;

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
                        phi_4377_ = false;
                        phi_1359_ = type_47(_e762, false);
                        phi_1362_ = ((3u * _e99) + 1u);
                        phi_1364_ = (_e764 <= _e762);
                        phi_1366_ = 0u;
                        phi_1368_ = type_63(type_35(vec4<f32>((f32(_e771) * _e157), (f32(_e777) * _e157), (f32(_e783) * _e157), 0f), vec4<f32>((f32(_e788) * _e157), (f32(_e792) * _e157), (f32(_e796) * _e157), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                        loop {
                            let _e806 = phi_4377_;
                            let _e808 = phi_1359_;
                            let _e810 = phi_1362_;
                            let _e812 = phi_1364_;
                            let _e814 = phi_1366_;
                            let _e816 = phi_1368_;
                            local_10 = _e808;
                            if _e812 {
                                phi_1379_ = true;
                            } else {
                                phi_1379_ = (_e814 > 0u);
                            }
                            let _e819 = phi_1379_;
                            if _e819 {
                                let _e820 = (_e810 > 0u);
                                if _e820 {
                                    if _e812 {
                                        phi_1465_ = _e812;
                                        phi_1466_ = _e814;
                                        phi_1467_ = _e816;
                                    } else {
                                        let _e821 = (_e814 - 1u);
                                        let _e822 = (_e821 % 128u);
                                        let _e823 = (_e822 < 128u);
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e825 = local_7[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e827 = local_6[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e829 = local_5[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e831 = local_4[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e833 = local_3[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e835 = local_2[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e840 = local_8[_e822];
                                        if _e823 {
                                        } else {
                                            phi_4563_ = true;
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
                                        let _e855 = ((_e851.member_1 & 2147483648u) != 0u);
                                        if _e855 {
                                            phi_1485_ = _e808;
                                            phi_1488_ = type_8(0u, ((_e851.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e862 = phi_1485_;
                                                let _e864 = phi_1488_;
                                                local_11 = _e862;
                                                if (_e864.member < _e864.member_1) {
                                                    phi_1489_ = type_8((_e864.member + 1u), _e864.member_1);
                                                    phi_1511_ = type_8(1u, _e864.member);
                                                } else {
                                                    phi_1489_ = _e864;
                                                    phi_1511_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e877 = phi_1489_;
                                                let _e879 = phi_1511_;
                                                let _e883 = (bitcast<i32>(_e879.member) != 0i);
                                                if _e883 {
                                                    let _e884 = ((_e851.member_1 & 268435455u) + _e879.member_1);
                                                    let _e885 = (_e884 < _e101);
                                                    if _e885 {
                                                        if _e885 {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e889 = global_5.member[_e884].member_1;
                                                        phi_1532_ = _e889;
                                                    } else {
                                                        phi_1532_ = 4294967295u;
                                                    }
                                                    let _e891 = phi_1532_;
                                                    if (_e884 >= _e101) {
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e885 {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        if (_e768 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e898 = global_5.member[_e884].member[_e768];
                                                        if (_e774 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e904 = global_5.member[_e884].member[_e774];
                                                        if (_e780 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e910 = global_5.member[_e884].member[_e780];
                                                        let _e912 = (3u + _e768);
                                                        if (_e912 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e918 = global_5.member[_e884].member[_e912];
                                                        let _e919 = (3u + _e774);
                                                        if (_e919 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e925 = global_5.member[_e884].member[_e919];
                                                        let _e926 = (3u + _e780);
                                                        if (_e926 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e932 = global_5.member[_e884].member[_e926];
                                                        let _e934 = (6u + _e768);
                                                        if (_e934 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e940 = global_5.member[_e884].member[_e934];
                                                        let _e941 = (6u + _e774);
                                                        if (_e941 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e947 = global_5.member[_e884].member[_e941];
                                                        let _e948 = (6u + _e780);
                                                        if (_e948 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e954 = global_5.member[_e884].member[_e948];
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(_e898, _e904, _e910), array<f32, 3>(_e918, _e925, _e932), array<f32, 3>(_e940, _e947, _e954));
                                                    }
                                                    let _e958 = phi_1624_;
                                                    let _e966 = (_e958[0][2] - _e611);
                                                    let _e969 = (((_e958[0][0] - _e478) * _e650) - (_e966 * _e518));
                                                    let _e972 = (((_e958[0][1] - _e545) * _e650) - (_e966 * _e584));
                                                    let _e979 = (_e958[1][2] - _e611);
                                                    let _e982 = (((_e958[1][0] - _e478) * _e650) - (_e979 * _e518));
                                                    let _e985 = (((_e958[1][1] - _e545) * _e650) - (_e979 * _e584));
                                                    let _e992 = (_e958[2][2] - _e611);
                                                    let _e995 = (((_e958[2][0] - _e478) * _e650) - (_e992 * _e518));
                                                    let _e998 = (((_e958[2][1] - _e545) * _e650) - (_e992 * _e584));
                                                    let _e999 = (_e995 * _e985);
                                                    let _e1000 = (_e998 * _e982);
                                                    let _e1001 = (_e969 * _e998);
                                                    let _e1002 = (_e972 * _e995);
                                                    let _e1003 = (_e982 * _e972);
                                                    let _e1004 = (_e985 * _e969);
                                                    let _e1009 = (((_e999 >= _e1000) && (_e1001 >= _e1002)) && (_e1003 >= _e1004));
                                                    if (_e1009 || (((_e999 <= _e1000) && (_e1001 <= _e1002)) && (_e1003 <= _e1004))) {
                                                        let _e1016 = select(-1f, 1f, _e1009);
                                                        let _e1018 = ((_e999 - _e1000) * _e1016);
                                                        let _e1020 = select(0f, _e1018, (_e1018 > 0f));
                                                        let _e1022 = ((_e1001 - _e1002) * _e1016);
                                                        let _e1024 = select(0f, _e1022, (_e1022 > 0f));
                                                        let _e1026 = ((_e1003 - _e1004) * _e1016);
                                                        let _e1028 = select(0f, _e1026, (_e1026 > 0f));
                                                        let _e1030 = ((_e1020 + _e1024) + _e1028);
                                                        if (_e1030 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2508_ = type_26();
                                                            phi_2509_ = true;
                                                            phi_2510_ = false;
                                                        } else {
                                                            let _e1033 = select(_e982, _e969, (_e969 < _e982));
                                                            if (select(_e995, _e1033, (_e1033 < _e995)) > 0f) {
                                                                phi_1776_ = true;
                                                            } else {
                                                                let _e1038 = select(_e982, _e969, (_e969 > _e982));
                                                                phi_1776_ = (select(_e995, _e1038, (_e1038 > _e995)) < 0f);
                                                            }
                                                            let _e1043 = phi_1776_;
                                                            if _e1043 {
                                                                phi_2505_ = type_26();
                                                                phi_2506_ = true;
                                                                phi_2507_ = false;
                                                            } else {
                                                                let _e1045 = select(_e985, _e972, (_e972 < _e985));
                                                                if (select(_e998, _e1045, (_e1045 < _e998)) > 0f) {
                                                                    phi_1805_ = true;
                                                                } else {
                                                                    let _e1050 = select(_e985, _e972, (_e972 > _e985));
                                                                    phi_1805_ = (select(_e998, _e1050, (_e1050 > _e998)) < 0f);
                                                                }
                                                                let _e1055 = phi_1805_;
                                                                if _e1055 {
                                                                    phi_2503_ = type_26();
                                                                    phi_2504_ = false;
                                                                } else {
                                                                    let _e1057 = select(_e958[1][0], _e958[0][0], (_e958[0][0] < _e958[1][0]));
                                                                    let _e1061 = select(_e958[1][0], _e958[0][0], (_e958[0][0] > _e958[1][0]));
                                                                    let _e1065 = select(_e958[1][1], _e958[0][1], (_e958[0][1] < _e958[1][1]));
                                                                    let _e1069 = select(_e958[1][1], _e958[0][1], (_e958[0][1] > _e958[1][1]));
                                                                    let _e1073 = select(_e958[1][2], _e958[0][2], (_e958[0][2] < _e958[1][2]));
                                                                    let _e1077 = select(_e958[1][2], _e958[0][2], (_e958[0][2] > _e958[1][2]));
                                                                    let _e1082 = ((select(_e958[2][0], _e1057, (_e1057 < _e958[2][0])) - _e516) * _e521);
                                                                    let _e1083 = ((select(_e958[2][0], _e1061, (_e1061 > _e958[2][0])) - _e517) * _e521);
                                                                    let _e1086 = ((select(_e958[2][1], _e1065, (_e1065 < _e958[2][1])) - _e582) * _e587);
                                                                    let _e1087 = ((select(_e958[2][1], _e1069, (_e1069 > _e958[2][1])) - _e583) * _e587);
                                                                    let _e1090 = ((select(_e958[2][2], _e1073, (_e1073 < _e958[2][2])) - _e648) * _e653);
                                                                    let _e1091 = ((select(_e958[2][2], _e1077, (_e1077 > _e958[2][2])) - _e649) * _e653);
                                                                    let _e1093 = select(_e1091, _e1090, (_e1090 < _e1091));
                                                                    let _e1095 = select(_e1091, _e1090, (_e1090 > _e1091));
                                                                    let _e1097 = select(_e1083, _e1082, (_e1082 < _e1083));
                                                                    let _e1099 = select(_e1087, _e1086, (_e1086 < _e1087));
                                                                    let _e1101 = select(_e1099, _e1097, (_e1097 > _e1099));
                                                                    let _e1103 = select(_e1093, _e1101, (_e1101 > _e1093));
                                                                    let _e1105 = select(_e1083, _e1082, (_e1082 > _e1083));
                                                                    let _e1107 = select(_e1087, _e1086, (_e1086 > _e1087));
                                                                    let _e1109 = select(_e1107, _e1105, (_e1105 < _e1107));
                                                                    let _e1111 = select(_e1095, _e1109, (_e1109 < _e1095));
                                                                    let _e1112 = -(_e1093);
                                                                    let _e1118 = select(_e764, _e1103, (_e1103 > _e764));
                                                                    if (_e1118 > (_e1111 + (select(_e1112, _e1095, (_e1095 > _e1112)) * 0.0000019073523f))) {
                                                                        phi_2498_ = type_26();
                                                                        phi_2499_ = true;
                                                                    } else {
                                                                        let _e1120 = (_e1118 > _e862.member);
                                                                        if _e1120 {
                                                                            phi_2497_ = type_26();
                                                                        } else {
                                                                            let _e1121 = vec3<f32>(_e958[0][0], _e958[0][1], _e958[0][2]);
                                                                            let _e1122 = vec3<f32>(_e958[1][0], _e958[1][1], _e958[1][2]);
                                                                            let _e1123 = vec3<f32>(_e958[2][0], _e958[2][1], _e958[2][2]);
                                                                            let _e1124 = (_e958[1][0] - _e958[0][0]);
                                                                            let _e1125 = (_e958[1][1] - _e958[0][1]);
                                                                            let _e1126 = (_e958[1][2] - _e958[0][2]);
                                                                            let _e1127 = vec3<f32>(_e1124, _e1125, _e1126);
                                                                            let _e1128 = (_e958[2][0] - _e958[1][0]);
                                                                            let _e1129 = (_e958[2][1] - _e958[1][1]);
                                                                            let _e1130 = (_e958[2][2] - _e958[1][2]);
                                                                            let _e1131 = vec3<f32>(_e1128, _e1129, _e1130);
                                                                            let _e1132 = (_e958[0][0] - _e958[2][0]);
                                                                            let _e1133 = (_e958[0][1] - _e958[2][1]);
                                                                            let _e1134 = (_e958[0][2] - _e958[2][2]);
                                                                            let _e1135 = vec3<f32>(_e1132, _e1133, _e1134);
                                                                            let _e1138 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                                                            let _e1141 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                            let _e1143 = select(_e1141, _e1138, (_e1138 > _e1141));
                                                                            let _e1146 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                            let _e1148 = select(_e1146, _e1143, (_e1143 > _e1146));
                                                                            let _e1151 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                            let _e1154 = bitcast<f32>((bitcast<u32>(_e1129) & 2147483647u));
                                                                            let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                            let _e1159 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                            let _e1161 = select(_e1159, _e1156, (_e1156 > _e1159));
                                                                            let _e1164 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                            let _e1167 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                                            let _e1169 = select(_e1167, _e1164, (_e1164 > _e1167));
                                                                            let _e1172 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                            let _e1174 = select(_e1172, _e1169, (_e1169 > _e1172));
                                                                            let _e1176 = select(_e1161, _e1148, (_e1148 > _e1161));
                                                                            let _e1178 = select(_e1174, _e1176, (_e1176 > _e1174));
                                                                            if (_e1148 == _e1178) {
                                                                                phi_2224_ = _e985;
                                                                                phi_2225_ = _e982;
                                                                                phi_2226_ = _e972;
                                                                                phi_2227_ = _e969;
                                                                                phi_2228_ = _e1121;
                                                                                phi_2229_ = _e1135;
                                                                                phi_2230_ = _e1131;
                                                                                phi_2231_ = _e1127;
                                                                            } else {
                                                                                let _e1180 = (_e1161 == _e1178);
                                                                                let _e1185 = vec3(_e1180);
                                                                                phi_2224_ = select(_e972, _e998, _e1180);
                                                                                phi_2225_ = select(_e969, _e995, _e1180);
                                                                                phi_2226_ = select(_e998, _e985, _e1180);
                                                                                phi_2227_ = select(_e995, _e982, _e1180);
                                                                                phi_2228_ = select(_e1123, _e1122, _e1185);
                                                                                phi_2229_ = select(_e1131, _e1127, _e1185);
                                                                                phi_2230_ = select(_e1127, _e1135, _e1185);
                                                                                phi_2231_ = select(_e1135, _e1131, _e1185);
                                                                            }
                                                                            let _e1191 = phi_2224_;
                                                                            let _e1193 = phi_2225_;
                                                                            let _e1195 = phi_2226_;
                                                                            let _e1197 = phi_2227_;
                                                                            let _e1199 = phi_2228_;
                                                                            let _e1201 = phi_2229_;
                                                                            let _e1203 = phi_2230_;
                                                                            let _e1205 = phi_2231_;
                                                                            let _e1212 = ((_e1203.y * _e1201.z) - (_e1201.y * _e1203.z));
                                                                            let _e1217 = ((_e1203.z * _e1201.x) - (_e1201.z * _e1203.x));
                                                                            let _e1220 = ((_e1203.x * _e1201.y) - (_e1201.x * _e1203.y));
                                                                            if (_e1020 >= _e1024) {
                                                                                phi_2268_ = select(true, false, (_e1020 >= _e1028));
                                                                            } else {
                                                                                phi_2268_ = true;
                                                                            }
                                                                            let _e1225 = phi_2268_;
                                                                            if _e1225 {
                                                                                phi_2277_ = select(_e1123, _e1122, vec3((_e1024 >= _e1028)));
                                                                            } else {
                                                                                phi_2277_ = _e1121;
                                                                            }
                                                                            let _e1230 = phi_2277_;
                                                                            let _e1241 = (((_e1212 * (_e1230.x - _e478)) + (_e1217 * (_e1230.y - _e545))) + (_e1220 * (_e1230.z - _e611)));
                                                                            let _e1246 = (((_e1212 * _e518) + (_e1217 * _e584)) + (_e1220 * _e650));
                                                                            let _e1247 = (_e1193 - _e1197);
                                                                            let _e1248 = (_e1191 - _e1195);
                                                                            let _e1256 = (-(((_e1197 * _e1247) + (_e1195 * _e1248))) / ((_e1247 * _e1247) + (_e1248 * _e1248)));
                                                                            let _e1258 = select(1f, _e1256, (_e1256 < 1f));
                                                                            let _e1260 = select(0f, _e1258, (_e1258 > 0f));
                                                                            let _e1273 = ((_e1199.x + (_e1205.x * _e1260)) - _e478);
                                                                            let _e1274 = ((_e1199.y + (_e1205.y * _e1260)) - _e545);
                                                                            let _e1275 = ((_e1199.z + (_e1205.z * _e1260)) - _e611);
                                                                            let _e1276 = (_e1275 / _e650);
                                                                            let _e1288 = bitcast<f32>((bitcast<u32>(_e1273) & 2147483647u));
                                                                            let _e1291 = bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u));
                                                                            let _e1293 = select(_e1291, _e1288, (_e1288 > _e1291));
                                                                            let _e1296 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                            let _e1298 = select(_e1296, _e1293, (_e1293 > _e1296));
                                                                            let _e1304 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                            let _e1307 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                            let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                                                                            let _e1312 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1212 * _e1273) + (_e1217 * _e1274)) + (_e1220 * _e1275)) - _e1241)) & 2147483647u)) <= ((0.0000009536743f * select(_e1178, _e1298, (_e1298 > _e1178))) * select(_e1312, _e1309, (_e1309 > _e1312)))) {
                                                                                let _e1322 = bitcast<f32>((bitcast<u32>(_e1203.x) & 2147483647u));
                                                                                let _e1325 = bitcast<f32>((bitcast<u32>(_e1203.y) & 2147483647u));
                                                                                let _e1327 = select(_e1325, _e1322, (_e1322 > _e1325));
                                                                                let _e1330 = bitcast<f32>((bitcast<u32>(_e1203.z) & 2147483647u));
                                                                                let _e1336 = bitcast<f32>((bitcast<u32>(_e1201.x) & 2147483647u));
                                                                                let _e1339 = bitcast<f32>((bitcast<u32>(_e1201.y) & 2147483647u));
                                                                                let _e1341 = select(_e1339, _e1336, (_e1336 > _e1339));
                                                                                let _e1344 = bitcast<f32>((bitcast<u32>(_e1201.z) & 2147483647u));
                                                                                let _e1348 = (bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u)) > ((0.0000038146973f * select(_e1330, _e1327, (_e1327 > _e1330))) * select(_e1344, _e1341, (_e1341 > _e1344))));
                                                                                if _e1348 {
                                                                                    phi_2442_ = (_e1241 / _e1246);
                                                                                } else {
                                                                                    phi_2442_ = f32();
                                                                                }
                                                                                let _e1351 = phi_2442_;
                                                                                phi_2444_ = _e1351;
                                                                                phi_2445_ = select(true, false, _e1348);
                                                                            } else {
                                                                                phi_2444_ = f32();
                                                                                phi_2445_ = true;
                                                                            }
                                                                            let _e1354 = phi_2444_;
                                                                            let _e1356 = phi_2445_;
                                                                            if _e1356 {
                                                                                let _e1364 = (((_e1212 * (_e1273 - (_e518 * _e1276))) + (_e1217 * (_e1274 - (_e584 * _e1276)))) / _e1246);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u)) <= _e1178) {
                                                                                    phi_2465_ = (_e1276 + _e1364);
                                                                                } else {
                                                                                    phi_2465_ = _e1276;
                                                                                }
                                                                                let _e1371 = phi_2465_;
                                                                                phi_2466_ = _e1371;
                                                                            } else {
                                                                                phi_2466_ = _e1354;
                                                                            }
                                                                            let _e1373 = phi_2466_;
                                                                            let _e1375 = select(_e1111, _e1373, (_e1373 < _e1111));
                                                                            let _e1377 = select(_e1103, _e1375, (_e1375 > _e1103));
                                                                            if (_e1377 >= _e764) {
                                                                                let _e1379 = (_e1377 <= _e862.member);
                                                                                if _e1379 {
                                                                                    let _e1380 = (1f / _e1030);
                                                                                    phi_2489_ = type_26(_e1377, (_e1024 * _e1380), (_e1028 * _e1380), _e891);
                                                                                } else {
                                                                                    phi_2489_ = type_26();
                                                                                }
                                                                                let _e1385 = phi_2489_;
                                                                                phi_2491_ = _e1385;
                                                                                phi_2492_ = select(true, false, _e1379);
                                                                            } else {
                                                                                phi_2491_ = type_26();
                                                                                phi_2492_ = true;
                                                                            }
                                                                            let _e1388 = phi_2491_;
                                                                            let _e1390 = phi_2492_;
                                                                            if _e1390 {
                                                                                phi_2496_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2496_ = _e1388;
                                                                            }
                                                                            let _e1392 = phi_2496_;
                                                                            phi_2497_ = _e1392;
                                                                        }
                                                                        let _e1394 = phi_2497_;
                                                                        phi_2498_ = _e1394;
                                                                        phi_2499_ = _e1120;
                                                                    }
                                                                    let _e1396 = phi_2498_;
                                                                    let _e1398 = phi_2499_;
                                                                    phi_2503_ = _e1396;
                                                                    phi_2504_ = _e1398;
                                                                }
                                                                let _e1400 = phi_2503_;
                                                                let _e1402 = phi_2504_;
                                                                phi_2505_ = _e1400;
                                                                phi_2506_ = _e1055;
                                                                phi_2507_ = _e1402;
                                                            }
                                                            let _e1404 = phi_2505_;
                                                            let _e1406 = phi_2506_;
                                                            let _e1408 = phi_2507_;
                                                            phi_2508_ = _e1404;
                                                            phi_2509_ = _e1406;
                                                            phi_2510_ = _e1408;
                                                        }
                                                        let _e1410 = phi_2508_;
                                                        let _e1412 = phi_2509_;
                                                        let _e1414 = phi_2510_;
                                                        phi_2518_ = _e1410;
                                                        phi_2519_ = select(_e1414, true, _e1412);
                                                    } else {
                                                        phi_2518_ = type_26();
                                                        phi_2519_ = true;
                                                    }
                                                    let _e1417 = phi_2518_;
                                                    let _e1419 = phi_2519_;
                                                    if _e1419 {
                                                        phi_2523_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2523_ = _e1417;
                                                    }
                                                    let _e1421 = phi_2523_;
                                                    if (_e1421.member_3 != 4294967295u) {
                                                        if (_e891 == _e166) {
                                                            phi_2858_ = false;
                                                        } else {
                                                            let _e1425 = (_e891 < arrayLength((&global_6.member)));
                                                            if _e1425 {
                                                                if _e1425 {
                                                                } else {
                                                                    phi_4371_ = true;
                                                                    break;
                                                                }
                                                                let _e1427 = global_6.member[_e891];
                                                                phi_2546_ = _e1427;
                                                            } else {
                                                                phi_2546_ = 4294967295u;
                                                            }
                                                            let _e1429 = phi_2546_;
                                                            let _e1430 = (_e1429 < arrayLength((&global_7.member)));
                                                            if _e1430 {
                                                                if _e1430 {
                                                                } else {
                                                                    phi_4371_ = true;
                                                                    break;
                                                                }
                                                                let _e1432 = global_7.member[_e1429];
                                                                phi_2560_ = _e1432;
                                                            } else {
                                                                phi_2560_ = 0i;
                                                            }
                                                            let _e1434 = phi_2560_;
                                                            let _e1435 = (_e1434 == 0i);
                                                            if _e1435 {
                                                                phi_2857_ = true;
                                                            } else {
                                                                if _e455 {
                                                                    phi_2583_ = vec3<f32>(_e958[0][0], _e958[0][1], _e958[0][2]);
                                                                } else {
                                                                    if (_e431 == 1u) {
                                                                        phi_2582_ = vec3<f32>(_e958[0][2], _e958[0][0], _e958[0][1]);
                                                                    } else {
                                                                        phi_2582_ = vec3<f32>(_e958[0][1], _e958[0][2], _e958[0][0]);
                                                                    }
                                                                    let _e1440 = phi_2582_;
                                                                    phi_2583_ = _e1440;
                                                                }
                                                                let _e1443 = phi_2583_;
                                                                if _e455 {
                                                                    phi_2602_ = vec3<f32>(_e958[1][0], _e958[1][1], _e958[1][2]);
                                                                } else {
                                                                    if (_e431 == 1u) {
                                                                        phi_2601_ = vec3<f32>(_e958[1][2], _e958[1][0], _e958[1][1]);
                                                                    } else {
                                                                        phi_2601_ = vec3<f32>(_e958[1][1], _e958[1][2], _e958[1][0]);
                                                                    }
                                                                    let _e1448 = phi_2601_;
                                                                    phi_2602_ = _e1448;
                                                                }
                                                                let _e1451 = phi_2602_;
                                                                if _e455 {
                                                                    phi_2621_ = vec3<f32>(_e958[2][0], _e958[2][1], _e958[2][2]);
                                                                } else {
                                                                    if (_e431 == 1u) {
                                                                        phi_2620_ = vec3<f32>(_e958[2][2], _e958[2][0], _e958[2][1]);
                                                                    } else {
                                                                        phi_2620_ = vec3<f32>(_e958[2][1], _e958[2][2], _e958[2][0]);
                                                                    }
                                                                    let _e1456 = phi_2620_;
                                                                    phi_2621_ = _e1456;
                                                                }
                                                                let _e1459 = phi_2621_;
                                                                let _e1462 = (_e1451.x - _e1443.x);
                                                                let _e1465 = (_e1451.y - _e1443.y);
                                                                let _e1468 = (_e1451.z - _e1443.z);
                                                                let _e1470 = (_e1459.x - _e1443.x);
                                                                let _e1472 = (_e1459.y - _e1443.y);
                                                                let _e1474 = (_e1459.z - _e1443.z);
                                                                if (_e298.member_1 == 1u) {
                                                                    phi_2657_ = (vec3<f32>(_e298.member[0], _e298.member[1], _e298.member[2]) - _e1443);
                                                                } else {
                                                                    phi_2657_ = vec3<f32>(_e298.member[0], _e298.member[1], _e298.member[2]);
                                                                }
                                                                let _e1489 = phi_2657_;
                                                                let _e1495 = bitcast<f32>((bitcast<u32>((_e1462 * _e1472)) ^ _e298.member_3[0]));
                                                                let _e1499 = bitcast<f32>((bitcast<u32>((_e1465 * _e1470)) ^ _e298.member_3[0]));
                                                                let _e1503 = bitcast<f32>((bitcast<u32>((_e1465 * _e1474)) ^ _e298.member_3[0]));
                                                                let _e1507 = bitcast<f32>((bitcast<u32>((_e1468 * _e1472)) ^ _e298.member_3[0]));
                                                                let _e1511 = bitcast<f32>((bitcast<u32>((_e1468 * _e1470)) ^ _e298.member_3[0]));
                                                                let _e1515 = bitcast<f32>((bitcast<u32>((_e1462 * _e1474)) ^ _e298.member_3[0]));
                                                                let _e1516 = (_e1503 - _e1507);
                                                                let _e1517 = (_e1511 - _e1515);
                                                                let _e1518 = (_e1495 - _e1499);
                                                                let _e1542 = (bitcast<f32>((bitcast<u32>(_e1503) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u)));
                                                                let _e1549 = (bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1515) & 2147483647u)));
                                                                let _e1556 = (bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1499) & 2147483647u)));
                                                                if (_e298.member_2 == 0f) {
                                                                    phi_2839_ = 0f;
                                                                } else {
                                                                    let _e1586 = bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u));
                                                                    let _e1589 = bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u));
                                                                    let _e1592 = bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u));
                                                                    let _e1594 = select(_e1592, _e1589, (_e1589 > _e1592));
                                                                    let _e1598 = select(_e1592, _e1589, (_e1589 < _e1592));
                                                                    let _e1602 = select(_e1589, _e1586, (_e1586 < _e1589));
                                                                    let _e1604 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                                    let _e1606 = select(_e1592, _e1604, (_e1604 < _e1592));
                                                                    phi_2839_ = bitcast<f32>((bitcast<u32>((_e298.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1594, _e1586, (_e1586 > _e1594)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1606, _e1602, (_e1602 > _e1606)))) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1598, _e1586, (_e1586 < _e1598)))) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1542 + _e1549) + _e1556))) ^ _e298.member_3[0]))) * 1.0000005f)) ^ _e298.member_3[0])))) ^ _e298.member_3[0]));
                                                                }
                                                                let _e1633 = phi_2839_;
                                                                phi_2857_ = (_e1435 || !(((((bitcast<f32>((bitcast<u32>((_e1489.x * _e1516)) ^ _e298.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1489.y * _e1517)) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1489.z * _e1518)) ^ _e298.member_3[0]))) * f32(-(_e1434))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1489.x) & 2147483647u)) * _e1542)) ^ _e298.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1489.y) & 2147483647u)) * _e1549)) ^ _e298.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1489.z) & 2147483647u)) * _e1556)) ^ _e298.member_3[0]))))) ^ _e298.member_3[0])) + _e1633) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1647 = phi_2857_;
                                                            phi_2858_ = _e1647;
                                                        }
                                                        let _e1649 = phi_2858_;
                                                        if _e1649 {
                                                            phi_2863_ = type_47(_e862.member, true);
                                                        } else {
                                                            phi_2863_ = _e862;
                                                        }
                                                        let _e1654 = phi_2863_;
                                                        phi_2864_ = _e1654;
                                                    } else {
                                                        phi_2864_ = _e862;
                                                    }
                                                    let _e1656 = phi_2864_;
                                                    phi_1486_ = _e1656;
                                                } else {
                                                    phi_1486_ = type_47();
                                                }
                                                let _e1658 = phi_1486_;
                                                continue;
                                                continuing {
                                                    phi_1485_ = _e1658;
                                                    phi_1488_ = _e877;
                                                    phi_4371_ = _e806;
                                                    break if !(_e883);
                                                }
                                            }
                                            let _e1661 = phi_4371_;
                                            phi_4563_ = _e1661;
                                            if _e1661 {
                                                break;
                                            }
                                            phi_4649_ = _e1661;
                                            let _e2315 = local_11;
                                            phi_2865_ = _e2315;
                                        } else {
                                            phi_4649_ = _e806;
                                            phi_2865_ = _e808;
                                        }
                                        let _e1663 = phi_4649_;
                                        let _e1665 = phi_2865_;
                                        if _e855 {
                                            phi_4095_ = bool();
                                            phi_4096_ = u32();
                                            phi_4097_ = type_63();
                                        } else {
                                            if (_e851.member_1 >= _e99) {
                                                phi_3631_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e851.member_1 < _e99) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1668 = (_e431 * 2u);
                                                let _e1670 = ((1u + _e1668) % 7u);
                                                if (_e1670 < 7u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1675 = global_9.member[_e851.member_1][_e1670];
                                                let _e1677 = ((_e1668 + 2u) % 7u);
                                                if (_e1677 < 7u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1682 = global_9.member[_e851.member_1][_e1677];
                                                let _e1683 = (_e430 * 2u);
                                                let _e1685 = ((1u + _e1683) % 7u);
                                                if (_e1685 < 7u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1690 = global_9.member[_e851.member_1][_e1685];
                                                let _e1692 = ((_e1683 + 2u) % 7u);
                                                if (_e1692 < 7u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1697 = global_9.member[_e851.member_1][_e1692];
                                                let _e1698 = (_e432 * 2u);
                                                let _e1700 = ((1u + _e1698) % 7u);
                                                if (_e1700 < 7u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1705 = global_9.member[_e851.member_1][_e1700];
                                                let _e1707 = ((_e1698 + 2u) % 7u);
                                                if (_e1707 < 7u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1712 = global_9.member[_e851.member_1][_e1707];
                                                let _e1735 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.x - _e851.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1736 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.y - _e851.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1737 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.z - _e851.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1739 = select(_e157, _e1735, (_e1735 > _e157));
                                                let _e1741 = select(_e157, _e1736, (_e1736 > _e157));
                                                let _e1743 = select(_e157, _e1737, (_e1737 > _e157));
                                                let _e1774 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1675 & 2097151u))) - 8388608f) * _e1739));
                                                let _e1779 = (bitcast<i32>((_e1675 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1782 = bitcast<f32>((_e1774 & bitcast<u32>(_e1779)));
                                                let _e1783 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1690 & 2097151u))) - 8388608f) * _e1741));
                                                let _e1788 = (bitcast<i32>((_e1690 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1791 = bitcast<f32>((_e1783 & bitcast<u32>(_e1788)));
                                                let _e1792 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1705 & 2097151u))) - 8388608f) * _e1743));
                                                let _e1797 = (bitcast<i32>((_e1705 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1800 = bitcast<f32>((_e1792 & bitcast<u32>(_e1797)));
                                                let _e1804 = bitcast<f32>((_e1774 & bitcast<u32>(~(_e1779))));
                                                let _e1808 = bitcast<f32>((_e1783 & bitcast<u32>(~(_e1788))));
                                                let _e1812 = bitcast<f32>((_e1792 & bitcast<u32>(~(_e1797))));
                                                let _e1813 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1682 & 2097151u))) - 8388608f) * _e1739));
                                                let _e1818 = (bitcast<i32>((_e1682 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1821 = bitcast<f32>((_e1813 & bitcast<u32>(_e1818)));
                                                let _e1822 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1697 & 2097151u))) - 8388608f) * _e1741));
                                                let _e1827 = (bitcast<i32>((_e1697 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1830 = bitcast<f32>((_e1822 & bitcast<u32>(_e1827)));
                                                let _e1831 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1712 & 2097151u))) - 8388608f) * _e1743));
                                                let _e1836 = (bitcast<i32>((_e1712 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1839 = bitcast<f32>((_e1831 & bitcast<u32>(_e1836)));
                                                let _e1843 = bitcast<f32>((_e1813 & bitcast<u32>(~(_e1818))));
                                                let _e1847 = bitcast<f32>((_e1822 & bitcast<u32>(~(_e1827))));
                                                let _e1851 = bitcast<f32>((_e1831 & bitcast<u32>(~(_e1836))));
                                                let _e1881 = global_9.member[_e851.member_1][0u];
                                                let _e1885 = global_9.member[_e851.member_1][2u];
                                                let _e1889 = global_9.member[_e851.member_1][4u];
                                                let _e1893 = global_9.member[_e851.member_1][6u];
                                                let _e1905 = (((_e1885 >> bitcast<u32>(22i)) | ((_e1889 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1893 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1906 = (_e1881 & 268435455u);
                                                let _e1907 = (_e1905 & 268435455u);
                                                let _e1910 = ((_e1881 >> bitcast<u32>(28u)) & 7u);
                                                let _e1918 = ((_e1881 >> bitcast<u32>(31i)) | (((_e1905 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1919 = (_e1910 != 0u);
                                                if (_e1910 == 0u) {
                                                    phi_3593_ = _e1906;
                                                } else {
                                                    if (_e1910 == 7u) {
                                                        phi_3592_ = 2147483648u;
                                                    } else {
                                                        phi_3592_ = ((2147483648u | (_e1910 << bitcast<u32>(28u))) | (_e1907 & 268435455u));
                                                    }
                                                    let _e1928 = phi_3592_;
                                                    phi_3593_ = _e1928;
                                                }
                                                let _e1930 = phi_3593_;
                                                if _e1919 {
                                                    let _e1931 = (_e1910 != 7u);
                                                    if _e1931 {
                                                        phi_3603_ = (_e1907 + _e1910);
                                                    } else {
                                                        phi_3603_ = u32();
                                                    }
                                                    let _e1934 = phi_3603_;
                                                    phi_3605_ = _e1934;
                                                    phi_3606_ = select(true, false, _e1931);
                                                } else {
                                                    phi_3605_ = u32();
                                                    phi_3606_ = true;
                                                }
                                                let _e1937 = phi_3605_;
                                                let _e1939 = phi_3606_;
                                                if (_e1918 == 0u) {
                                                    phi_3627_ = (_e1906 + select(0u, 1u, !(_e1919)));
                                                } else {
                                                    if (_e1918 == 7u) {
                                                        phi_3626_ = 2147483648u;
                                                    } else {
                                                        phi_3626_ = ((2147483648u | (_e1918 << bitcast<u32>(28u))) | (select(_e1937, _e1907, _e1939) & 268435455u));
                                                    }
                                                    let _e1952 = phi_3626_;
                                                    phi_3627_ = _e1952;
                                                }
                                                let _e1954 = phi_3627_;
                                                phi_3631_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e851.member.member.x + _e1782), (_e851.member.member.x + _e1804), (_e851.member.member_1.x - _e1821), (_e851.member.member_1.x - _e1843)), vec4<f32>((_e851.member.member.y + _e1791), (_e851.member.member.y + _e1808), (_e851.member.member_1.y - _e1830), (_e851.member.member_1.y - _e1847)), vec4<f32>((_e851.member.member.z + _e1800), (_e851.member.member.z + _e1812), (_e851.member.member_1.z - _e1839), (_e851.member.member_1.z - _e1851))), type_63(type_35((_e851.member.member + vec4<f32>(_e1782, _e1791, _e1800, 0f)), (_e851.member.member_1 - vec4<f32>(_e1821, _e1830, _e1839, 0f))), _e1930), type_63(type_35((_e851.member.member + vec4<f32>(_e1804, _e1808, _e1812, 0f)), (_e851.member.member_1 - vec4<f32>(_e1843, _e1847, _e1851, 0f))), _e1954));
                                            }
                                            let _e1959 = phi_3631_;
                                            let _e1971 = ((_e1959.member[0].x - _e516) * _e521);
                                            let _e1972 = ((_e1959.member[0].y - _e516) * _e521);
                                            let _e1973 = ((_e1959.member[0].z - _e517) * _e521);
                                            let _e1974 = ((_e1959.member[0].w - _e517) * _e521);
                                            let _e1984 = ((_e1959.member[1].x - _e582) * _e587);
                                            let _e1985 = ((_e1959.member[1].y - _e582) * _e587);
                                            let _e1986 = ((_e1959.member[1].z - _e583) * _e587);
                                            let _e1987 = ((_e1959.member[1].w - _e583) * _e587);
                                            let _e1997 = ((_e1959.member[2].x - _e648) * _e653);
                                            let _e1998 = ((_e1959.member[2].y - _e648) * _e653);
                                            let _e1999 = ((_e1959.member[2].z - _e649) * _e653);
                                            let _e2000 = ((_e1959.member[2].w - _e649) * _e653);
                                            let _e2002 = select(_e1999, _e1997, (_e1997 < _e1999));
                                            let _e2004 = select(_e2000, _e1998, (_e1998 < _e2000));
                                            let _e2006 = select(_e1999, _e1997, (_e1997 > _e1999));
                                            let _e2008 = select(_e2000, _e1998, (_e1998 > _e2000));
                                            let _e2010 = select(_e1973, _e1971, (_e1971 < _e1973));
                                            let _e2012 = select(_e1974, _e1972, (_e1972 < _e1974));
                                            let _e2014 = select(_e1986, _e1984, (_e1984 < _e1986));
                                            let _e2016 = select(_e1987, _e1985, (_e1985 < _e1987));
                                            let _e2018 = select(_e2014, _e2010, (_e2010 > _e2014));
                                            let _e2020 = select(_e2016, _e2012, (_e2012 > _e2016));
                                            let _e2022 = select(_e2002, _e2018, (_e2018 > _e2002));
                                            let _e2024 = select(_e2004, _e2020, (_e2020 > _e2004));
                                            let _e2026 = select(_e1973, _e1971, (_e1971 > _e1973));
                                            let _e2028 = select(_e1974, _e1972, (_e1972 > _e1974));
                                            let _e2030 = select(_e1986, _e1984, (_e1984 > _e1986));
                                            let _e2032 = select(_e1987, _e1985, (_e1985 > _e1987));
                                            let _e2034 = select(_e2030, _e2026, (_e2026 < _e2030));
                                            let _e2036 = select(_e2032, _e2028, (_e2028 < _e2032));
                                            let _e2041 = -(_e2002);
                                            let _e2042 = -(_e2004);
                                            let _e2049 = (select(_e2006, _e2034, (_e2034 < _e2006)) + (select(_e2041, _e2006, (_e2006 > _e2041)) * 0.0000019073523f));
                                            let _e2050 = (select(_e2008, _e2036, (_e2036 < _e2008)) + (select(_e2042, _e2008, (_e2008 > _e2042)) * 0.0000019073523f));
                                            let _e2052 = select(_e764, _e2022, (_e2022 > _e764));
                                            let _e2054 = select(_e764, _e2024, (_e2024 > _e764));
                                            let _e2059 = (_e2052 <= select(_e1665.member, _e2049, (_e2049 < _e1665.member)));
                                            let _e2060 = (_e2054 <= select(_e1665.member, _e2050, (_e2050 < _e1665.member)));
                                            let _e2061 = (_e2052 <= _e2054);
                                            if _e2059 {
                                                if _e2060 {
                                                    if _e2061 {
                                                        phi_3993_ = _e1959.member_2;
                                                    } else {
                                                        phi_3993_ = _e1959.member_1;
                                                    }
                                                    let _e2065 = phi_3993_;
                                                    let _e2086 = (_e849 % 128u);
                                                    let _e2087 = (_e2086 < 128u);
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2086] = _e2065.member_1;
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2086] = _e2065.member.member.x;
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2086] = _e2065.member.member.y;
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2086] = _e2065.member.member.z;
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2086] = _e2065.member.member_1.x;
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2086] = _e2065.member.member_1.y;
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2086] = _e2065.member.member_1.z;
                                                    if _e2087 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2086] = select(_e2052, _e2054, _e2061);
                                                    if _e2061 {
                                                        phi_4069_ = _e1959.member_1;
                                                    } else {
                                                        phi_4069_ = _e1959.member_2;
                                                    }
                                                    let _e2100 = phi_4069_;
                                                    phi_4070_ = (_e849 + 1u);
                                                    phi_4071_ = _e2100;
                                                } else {
                                                    phi_4070_ = u32();
                                                    phi_4071_ = type_63();
                                                }
                                                let _e2102 = phi_4070_;
                                                let _e2104 = phi_4071_;
                                                phi_4073_ = _e2102;
                                                phi_4074_ = _e2104;
                                                phi_4075_ = select(true, false, _e2060);
                                            } else {
                                                phi_4073_ = u32();
                                                phi_4074_ = type_63();
                                                phi_4075_ = true;
                                            }
                                            let _e2107 = phi_4073_;
                                            let _e2109 = phi_4074_;
                                            let _e2111 = phi_4075_;
                                            if _e2111 {
                                                if _e2059 {
                                                    phi_4084_ = _e1959.member_1;
                                                } else {
                                                    phi_4084_ = _e1959.member_2;
                                                }
                                                let _e2115 = phi_4084_;
                                                phi_4089_ = select(_e2060, true, _e2059);
                                                phi_4091_ = _e2115;
                                            } else {
                                                phi_4089_ = _e847;
                                                phi_4091_ = _e2109;
                                            }
                                            let _e2118 = phi_4089_;
                                            let _e2120 = phi_4091_;
                                            phi_4095_ = _e2118;
                                            phi_4096_ = select(_e2107, _e849, _e2111);
                                            phi_4097_ = _e2120;
                                        }
                                        let _e2123 = phi_4095_;
                                        let _e2125 = phi_4096_;
                                        let _e2127 = phi_4097_;
                                        if _e855 {
                                            phi_4107_ = select(_e849, 0u, _e1665.member_1);
                                            phi_4108_ = _e851;
                                        } else {
                                            phi_4107_ = _e2125;
                                            phi_4108_ = _e2127;
                                        }
                                        let _e2131 = phi_4107_;
                                        let _e2133 = phi_4108_;
                                        phi_4566_ = _e1663;
                                        phi_4109_ = _e1665;
                                        phi_4110_ = (_e810 - 1u);
                                        phi_4111_ = select(_e2123, false, _e855);
                                        phi_4112_ = _e2131;
                                        phi_4113_ = _e2133;
                                    } else {
                                        phi_4566_ = _e806;
                                        phi_4109_ = _e808;
                                        phi_4110_ = _e810;
                                        phi_4111_ = _e847;
                                        phi_4112_ = _e849;
                                        phi_4113_ = _e851;
                                    }
                                    let _e2136 = phi_4566_;
                                    let _e2138 = phi_4109_;
                                    let _e2140 = phi_4110_;
                                    let _e2142 = phi_4111_;
                                    let _e2144 = phi_4112_;
                                    let _e2146 = phi_4113_;
                                    phi_4565_ = _e2136;
                                    phi_4114_ = _e2138;
                                    phi_4115_ = _e2140;
                                    phi_4116_ = _e2142;
                                    phi_4117_ = _e2144;
                                    phi_4118_ = _e2146;
                                } else {
                                    phi_4565_ = _e806;
                                    phi_4114_ = type_47();
                                    phi_4115_ = u32();
                                    phi_4116_ = bool();
                                    phi_4117_ = u32();
                                    phi_4118_ = type_63();
                                }
                                let _e2148 = phi_4565_;
                                let _e2150 = phi_4114_;
                                let _e2152 = phi_4115_;
                                let _e2154 = phi_4116_;
                                let _e2156 = phi_4117_;
                                let _e2158 = phi_4118_;
                                phi_4564_ = _e2148;
                                phi_1360_ = _e2150;
                                phi_1363_ = _e2152;
                                phi_1365_ = _e2154;
                                phi_1367_ = _e2156;
                                phi_1369_ = _e2158;
                                phi_4119_ = _e820;
                            } else {
                                phi_4564_ = _e806;
                                phi_1360_ = type_47();
                                phi_1363_ = u32();
                                phi_1365_ = bool();
                                phi_1367_ = u32();
                                phi_1369_ = type_63();
                                phi_4119_ = false;
                            }
                            let _e2160 = phi_4564_;
                            let _e2162 = phi_1360_;
                            let _e2164 = phi_1363_;
                            let _e2166 = phi_1365_;
                            let _e2168 = phi_1367_;
                            let _e2170 = phi_1369_;
                            let _e2172 = phi_4119_;
                            continue;
                            continuing {
                                phi_4377_ = _e2160;
                                phi_1359_ = _e2162;
                                phi_1362_ = _e2164;
                                phi_1364_ = _e2166;
                                phi_1366_ = _e2168;
                                phi_1368_ = _e2170;
                                phi_4563_ = _e2160;
                                break if !(_e2172);
                            }
                        }
                        let _e2175 = phi_4563_;
                        if _e2175 {
                            break;
                        }
                        let _e2177 = local_10;
                        if _e2177.member_1 {
                        } else {
                            if _e299 {
                            } else {
                                break;
                            }
                            let _e2181 = global_2.member[_e145];
                            if _e160 {
                            } else {
                                break;
                            }
                            let _e2185 = global_10.member[_e145].member_1;
                            if _e299 {
                            } else {
                                break;
                            }
                            global_2.member[_e145] = type_28(_e2181.member, _e2181.member_1, _e2181.member_2, array<f32, 3>((_e2181.member_3[0] + (_e2185[0] * _e2181.member_1[0])), (_e2181.member_3[1] + (_e2185[1] * _e2181.member_1[1])), (_e2181.member_3[2] + (_e2185[2] * _e2181.member_1[2]))), _e2181.member_4);
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
