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
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_48 {
    member: f32,
    member_1: bool,
}

struct type_50 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: array<i32>,
}

struct type_59 {
    member: array<array<u32, 7>>,
}

struct type_64 {
    member: type_35,
    member_1: u32,
}

struct type_65 {
    member: array<vec4<f32>, 3>,
    member_1: type_64,
    member_2: type_64,
}

struct type_70 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_30;
@group(0) @binding(1) 
var<uniform> global_3: type_50;
@group(0) @binding(2) 
var<uniform> global_4: type_50;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_53;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_70;
@group(0) @binding(3) 
var<storage> global_9: type_59;
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
    var phi_356_: u32;
    var phi_400_: i32;
    var phi_540_: type_41;
    var phi_690_: i32;
    var phi_691_: i32;
    var phi_701_: bool;
    var phi_711_: u32;
    var phi_712_: u32;
    var phi_714_: bool;
    var phi_719_: u32;
    var phi_752_: i32;
    var phi_770_: f32;
    var phi_776_: f32;
    var phi_816_: f32;
    var phi_822_: f32;
    var phi_895_: f32;
    var phi_901_: f32;
    var phi_941_: f32;
    var phi_947_: f32;
    var phi_1020_: f32;
    var phi_1026_: f32;
    var phi_1066_: f32;
    var phi_1072_: f32;
    var phi_1191_: i32;
    var phi_1213_: u32;
    var phi_1214_: u32;
    var phi_1251_: i32;
    var phi_1273_: u32;
    var phi_1274_: u32;
    var phi_1282_: f32;
    var phi_1283_: f32;
    var phi_4474_: bool;
    var phi_1379_: type_48;
    var phi_1382_: u32;
    var phi_1384_: bool;
    var phi_1386_: u32;
    var phi_1388_: type_64;
    var phi_1399_: bool;
    var phi_1485_: bool;
    var phi_1486_: u32;
    var phi_1487_: type_64;
    var phi_1505_: type_48;
    var phi_1508_: type_8;
    var phi_1509_: type_8;
    var phi_1531_: type_8;
    var phi_1552_: u32;
    var phi_1644_: array<array<f32, 3>, 3>;
    var phi_4109_: bool;
    var phi_4124_: bool;
    var phi_4139_: bool;
    var phi_4154_: bool;
    var phi_4169_: bool;
    var phi_4184_: bool;
    var phi_2186_: f32;
    var phi_2187_: f32;
    var phi_2188_: f32;
    var phi_2189_: f32;
    var phi_2190_: vec3<f32>;
    var phi_2191_: vec3<f32>;
    var phi_2192_: vec3<f32>;
    var phi_2193_: vec3<f32>;
    var phi_4199_: bool;
    var phi_4214_: bool;
    var phi_4229_: bool;
    var phi_4244_: bool;
    var phi_4259_: bool;
    var phi_4274_: bool;
    var phi_2401_: f32;
    var phi_2421_: type_47;
    var phi_2422_: type_47;
    var phi_2425_: type_47;
    var phi_2426_: type_47;
    var phi_2427_: bool;
    var phi_2431_: type_47;
    var phi_2440_: type_26;
    var phi_2463_: u32;
    var phi_2477_: i32;
    var phi_2499_: vec3<f32>;
    var phi_2500_: vec3<f32>;
    var phi_2518_: vec3<f32>;
    var phi_2519_: vec3<f32>;
    var phi_2537_: vec3<f32>;
    var phi_2538_: vec3<f32>;
    var phi_2574_: vec3<f32>;
    var phi_2756_: f32;
    var phi_2774_: bool;
    var phi_2775_: bool;
    var phi_2780_: type_48;
    var phi_2781_: type_48;
    var phi_1506_: type_48;
    var phi_4468_: bool;
    var phi_4751_: bool;
    var phi_2782_: type_48;
    var phi_3509_: u32;
    var phi_3510_: u32;
    var phi_3520_: u32;
    var phi_3522_: u32;
    var phi_3523_: bool;
    var phi_3543_: u32;
    var phi_3544_: u32;
    var phi_3548_: type_65;
    var phi_3910_: type_64;
    var phi_3986_: type_64;
    var phi_3987_: u32;
    var phi_3988_: type_64;
    var phi_3990_: u32;
    var phi_3991_: type_64;
    var phi_3992_: bool;
    var phi_4001_: type_64;
    var phi_4006_: bool;
    var phi_4008_: type_64;
    var phi_4012_: bool;
    var phi_4013_: u32;
    var phi_4014_: type_64;
    var phi_4024_: u32;
    var phi_4025_: type_64;
    var phi_4668_: bool;
    var phi_4026_: type_48;
    var phi_4027_: u32;
    var phi_4028_: bool;
    var phi_4029_: u32;
    var phi_4030_: type_64;
    var phi_4667_: bool;
    var phi_4031_: type_48;
    var phi_4032_: u32;
    var phi_4033_: bool;
    var phi_4034_: u32;
    var phi_4035_: type_64;
    var phi_4666_: bool;
    var phi_1380_: type_48;
    var phi_1383_: u32;
    var phi_1385_: bool;
    var phi_1387_: u32;
    var phi_1389_: type_64;
    var phi_4036_: bool;
    var phi_4665_: bool;
    var local_10: type_48;
    var local_11: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_9.member));
            let _e102 = arrayLength((&global_5.member));
            let _e114 = arrayLength((&global_8.member));
            let _e118 = global_4.member[0u][0u];
            let _e122 = global_4.member[0u][1u];
            let _e126 = global_4.member[0u][2u];
            let _e130 = global_4.member[0u][3u];
            let _e134 = global_4.member[1u][0u];
            let _e138 = global_4.member[1u][1u];
            let _e142 = global_4.member[1u][2u];
            let _e146 = (_e98.x + (_e98.y * 2097152u));
            let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e130) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            local = array<i32, 3>(bitcast<i32>(_e134), bitcast<i32>(_e138), bitcast<i32>(_e142));
            let _e161 = (_e146 < arrayLength((&global_10.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_10.member[_e146].member_2;
                phi_356_ = _e165;
            } else {
                phi_356_ = 4294967295u;
            }
            let _e167 = phi_356_;
            let _e170 = global_1.member[0u];
            let _e174 = global_3.member[0u][0u];
            let _e178 = global_3.member[0u][1u];
            let _e182 = global_3.member[0u][2u];
            let _e186 = global_3.member[0u][3u];
            let _e190 = global_3.member[1u][0u];
            let _e194 = global_3.member[1u][1u];
            let _e198 = global_3.member[1u][2u];
            let _e202 = global_3.member[1u][3u];
            let _e203 = bitcast<f32>(_e174);
            let _e204 = bitcast<f32>(_e178);
            let _e205 = bitcast<f32>(_e182);
            let _e207 = bitcast<f32>(_e190);
            let _e208 = array<u32, 3>(_e194, _e198, _e202);
            let _e210 = bitcast<i32>(_e170);
            if (_e210 < -126i) {
                phi_400_ = -126i;
            } else {
                phi_400_ = select(_e210, 127i, (_e210 > 127i));
            }
            let _e215 = phi_400_;
            let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
            let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_540_ = type_41(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                let _e228 = bitcast<u32>(_e203);
                let _e230 = ((_e228 & 2139095040u) != 0u);
                let _e245 = bitcast<u32>(_e204);
                let _e247 = ((_e245 & 2139095040u) != 0u);
                let _e262 = bitcast<u32>(_e205);
                let _e264 = ((_e262 & 2139095040u) != 0u);
                let _e280 = bitcast<u32>(_e207);
                let _e282 = ((_e280 & 2139095040u) != 0u);
                phi_540_ = type_41(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e228 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e228 & 2147483648u))), _e203, _e230) * _e220) * select(0.00000011920929f, 1f, _e230)) * _e226), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e204, _e247) * _e220) * select(0.00000011920929f, 1f, _e247)) * _e226), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e262 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e262 & 2147483648u))), _e205, _e264) * _e220) * select(0.00000011920929f, 1f, _e264)) * _e226)), _e186, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e280 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e280 & 2147483648u))), _e207, _e282) * _e220) * select(0.00000011920929f, 1f, _e282)) * _e226), _e208);
            }
            let _e299 = phi_540_;
            if _e161 {
                let _e300 = (_e146 < arrayLength((&global_2.member)));
                if _e300 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e305 = global_10.member[_e146].member.member_1;
                    let _e310 = global_10.member[_e146].member.member_3;
                    if (_e305 <= _e310) {
                        let _e312 = (1u < _e114);
                        if _e312 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e316 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e316 + 1u) < _e316) {
                                if _e312 {
                                } else {
                                    break;
                                }
                                let _e321 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e161 {
                        } else {
                            break;
                        }
                        let _e331 = global_10.member[_e146].member.member_2[0u];
                        let _e333 = (bitcast<u32>(_e331) & 2147483647u);
                        let _e339 = global_10.member[_e146].member.member_2[1u];
                        let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                        let _e347 = global_10.member[_e146].member.member_2[2u];
                        let _e349 = (bitcast<u32>(_e347) & 2147483647u);
                        let _e355 = global_10.member[_e146].member.member[0u];
                        let _e357 = (bitcast<u32>(_e355) & 2147483647u);
                        let _e363 = global_10.member[_e146].member.member[1u];
                        let _e365 = (bitcast<u32>(_e363) & 2147483647u);
                        let _e371 = global_10.member[_e146].member.member[2u];
                        let _e373 = (bitcast<u32>(_e371) & 2147483647u);
                        let _e375 = select(_e341, _e333, (_e341 < _e333));
                        let _e377 = select(_e349, _e375, (_e349 < _e375));
                        let _e379 = select(_e357, _e377, (_e357 < _e377));
                        let _e381 = select(_e365, _e379, (_e365 < _e379));
                        let _e383 = select(_e373, _e381, (_e373 < _e381));
                        let _e384 = bitcast<u32>(_e305);
                        let _e385 = (_e384 & 2147483647u);
                        let _e389 = bitcast<u32>(_e310);
                        let _e390 = (_e389 & 2147483647u);
                        let _e394 = (((select(_e385, _e383, (_e385 < _e383)) < 2139095040u) && (_e390 <= 2139095040u)) && (_e377 > 0u));
                        if _e394 {
                            let _e397 = (bitcast<u32>(bitcast<f32>(_e377)) & 2147483647u);
                            if (_e397 >= 8388608u) {
                                phi_690_ = (bitcast<i32>((_e397 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_690_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e397)), 32u, (_e397 == 0u))));
                            }
                            let _e411 = phi_690_;
                            phi_691_ = _e411;
                        } else {
                            phi_691_ = 0i;
                        }
                        let _e413 = phi_691_;
                        let _e414 = (_e333 == _e377);
                        if _e414 {
                            phi_701_ = true;
                        } else {
                            phi_701_ = (_e341 == _e377);
                        }
                        let _e417 = phi_701_;
                        let _e418 = select(1u, 0u, _e414);
                        if _e417 {
                            let _e419 = (_e418 + 1u);
                            phi_711_ = _e419;
                            phi_712_ = _e419;
                            phi_714_ = select(true, false, (_e419 == 2u));
                        } else {
                            phi_711_ = u32();
                            phi_712_ = 0u;
                            phi_714_ = true;
                        }
                        let _e423 = phi_711_;
                        let _e425 = phi_712_;
                        let _e427 = phi_714_;
                        if _e427 {
                            phi_719_ = (_e425 + 1u);
                        } else {
                            phi_719_ = 0u;
                        }
                        let _e431 = phi_719_;
                        let _e432 = select(_e423, _e425, _e427);
                        let _e433 = select(_e418, select(2u, _e418, _e417), _e427);
                        let _e434 = -(_e413);
                        if (_e434 < -126i) {
                            phi_752_ = -126i;
                        } else {
                            phi_752_ = select(_e434, 127i, (_e434 > 127i));
                        }
                        let _e439 = phi_752_;
                        let _e444 = bitcast<f32>((bitcast<u32>((_e439 + 127i)) << bitcast<u32>(23i)));
                        let _e450 = bitcast<f32>((bitcast<u32>(((_e434 - _e439) + 127i)) << bitcast<u32>(23i)));
                        let _e455 = global_10.member[_e146].member.member;
                        let _e456 = (_e432 == 0u);
                        if _e456 {
                            phi_770_ = _e455[0];
                        } else {
                            phi_770_ = _e455[1];
                        }
                        let _e460 = phi_770_;
                        let _e461 = (_e432 == 2u);
                        if _e461 {
                            phi_776_ = _e455[2];
                        } else {
                            phi_776_ = _e460;
                        }
                        let _e464 = phi_776_;
                        let _e465 = bitcast<u32>(_e464);
                        let _e467 = ((_e465 & 2139095040u) != 0u);
                        let _e479 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e465 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e465 & 2147483648u))), _e464, _e467) * select(0.00000011920929f, 1f, _e467));
                        let _e480 = global_10.member[_e146].member.member_2;
                        if _e456 {
                            phi_816_ = _e480[0];
                        } else {
                            phi_816_ = _e480[1];
                        }
                        let _e484 = phi_816_;
                        if _e461 {
                            phi_822_ = _e480[2];
                        } else {
                            phi_822_ = _e484;
                        }
                        let _e487 = phi_822_;
                        let _e488 = bitcast<u32>(_e487);
                        let _e490 = ((_e488 & 2139095040u) != 0u);
                        let _e504 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e488 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e488 & 2147483648u))), _e487, _e490) * _e444) * select(0.00000011920929f, 1f, _e490)) * _e450);
                        let _e508 = (bitcast<f32>((bitcast<u32>(_e504) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e511 = bitcast<f32>((bitcast<u32>(_e479) & 2147483647u));
                        let _e512 = (_e511 * 0.00000011920929f);
                        let _e515 = select(select(0.00000000000011368684f, _e512, (_e512 > 0.00000000000011368684f)), 0f, _e508);
                        let _e516 = select(0f, _e504, _e508);
                        let _e517 = (_e479 + _e515);
                        let _e518 = (_e479 - _e515);
                        let _e520 = select(38685626000000000000000000f, (1f / _e504), _e508);
                        let _e521 = (_e431 == 0u);
                        if _e521 {
                            phi_895_ = _e455[0];
                        } else {
                            phi_895_ = _e455[1];
                        }
                        let _e525 = phi_895_;
                        let _e526 = (_e431 == 2u);
                        if _e526 {
                            phi_901_ = _e455[2];
                        } else {
                            phi_901_ = _e525;
                        }
                        let _e529 = phi_901_;
                        let _e530 = bitcast<u32>(_e529);
                        let _e532 = ((_e530 & 2139095040u) != 0u);
                        let _e544 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e530 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e530 & 2147483648u))), _e529, _e532) * select(0.00000011920929f, 1f, _e532));
                        if _e521 {
                            phi_941_ = _e480[0];
                        } else {
                            phi_941_ = _e480[1];
                        }
                        let _e548 = phi_941_;
                        if _e526 {
                            phi_947_ = _e480[2];
                        } else {
                            phi_947_ = _e548;
                        }
                        let _e551 = phi_947_;
                        let _e552 = bitcast<u32>(_e551);
                        let _e554 = ((_e552 & 2139095040u) != 0u);
                        let _e568 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e552 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e552 & 2147483648u))), _e551, _e554) * _e444) * select(0.00000011920929f, 1f, _e554)) * _e450);
                        let _e572 = (bitcast<f32>((bitcast<u32>(_e568) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e575 = bitcast<f32>((bitcast<u32>(_e544) & 2147483647u));
                        let _e576 = (_e575 * 0.00000011920929f);
                        let _e579 = select(select(0.00000000000011368684f, _e576, (_e576 > 0.00000000000011368684f)), 0f, _e572);
                        let _e580 = select(0f, _e568, _e572);
                        let _e581 = (_e544 + _e579);
                        let _e582 = (_e544 - _e579);
                        let _e584 = select(38685626000000000000000000f, (1f / _e568), _e572);
                        let _e585 = (_e433 == 0u);
                        if _e585 {
                            phi_1020_ = _e455[0];
                        } else {
                            phi_1020_ = _e455[1];
                        }
                        let _e589 = phi_1020_;
                        let _e590 = (_e433 == 2u);
                        if _e590 {
                            phi_1026_ = _e455[2];
                        } else {
                            phi_1026_ = _e589;
                        }
                        let _e593 = phi_1026_;
                        let _e594 = bitcast<u32>(_e593);
                        let _e596 = ((_e594 & 2139095040u) != 0u);
                        let _e608 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e594 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e594 & 2147483648u))), _e593, _e596) * select(0.00000011920929f, 1f, _e596));
                        if _e585 {
                            phi_1066_ = _e480[0];
                        } else {
                            phi_1066_ = _e480[1];
                        }
                        let _e612 = phi_1066_;
                        if _e590 {
                            phi_1072_ = _e480[2];
                        } else {
                            phi_1072_ = _e612;
                        }
                        let _e615 = phi_1072_;
                        let _e616 = bitcast<u32>(_e615);
                        let _e618 = ((_e616 & 2139095040u) != 0u);
                        let _e632 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e616 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e616 & 2147483648u))), _e615, _e618) * _e444) * select(0.00000011920929f, 1f, _e618)) * _e450);
                        let _e636 = (bitcast<f32>((bitcast<u32>(_e632) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e639 = bitcast<f32>((bitcast<u32>(_e608) & 2147483647u));
                        let _e640 = (_e639 * 0.00000011920929f);
                        let _e643 = select(select(0.00000000000011368684f, _e640, (_e640 > 0.00000000000011368684f)), 0f, _e636);
                        let _e644 = select(0f, _e632, _e636);
                        let _e645 = (_e608 + _e643);
                        let _e646 = (_e608 - _e643);
                        let _e648 = select(38685626000000000000000000f, (1f / _e632), _e636);
                        let _e650 = select(_e575, _e511, (_e511 > _e575));
                        if (_e394 && (select(_e639, _e650, (_e650 > _e639)) <= 1099511600000f)) {
                            let _e662 = ((_e385 & 8388607u) | (select(0u, 1u, ((_e385 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e665 = bitcast<i32>((_e385 >> bitcast<u32>(23i)));
                            let _e669 = (_e662 == 0u);
                            let _e672 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e662)), 32u, _e669)) - 8i);
                            if (_e665 == 255i) {
                                phi_1191_ = 255i;
                            } else {
                                phi_1191_ = (((_e665 + select(0i, 1i, (_e665 == 0i))) - _e672) + _e413);
                            }
                            let _e680 = phi_1191_;
                            let _e690 = (_e680 <= 0i);
                            if _e690 {
                                phi_1214_ = u32();
                            } else {
                                if _e669 {
                                    phi_1213_ = u32();
                                } else {
                                    phi_1213_ = select(((bitcast<u32>(_e680) << bitcast<u32>(23i)) | ((_e662 << bitcast<u32>(((_e672 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e680 >= 255i));
                                }
                                let _e694 = phi_1213_;
                                phi_1214_ = _e694;
                            }
                            let _e696 = phi_1214_;
                            let _e708 = ((_e390 & 8388607u) | (select(0u, 1u, ((_e390 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e711 = bitcast<i32>((_e390 >> bitcast<u32>(23i)));
                            let _e715 = (_e708 == 0u);
                            let _e718 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e708)), 32u, _e715)) - 8i);
                            if (_e711 == 255i) {
                                phi_1251_ = 255i;
                            } else {
                                phi_1251_ = (((_e711 + select(0i, 1i, (_e711 == 0i))) - _e718) + _e413);
                            }
                            let _e726 = phi_1251_;
                            let _e736 = (_e726 <= 0i);
                            if _e736 {
                                phi_1274_ = u32();
                            } else {
                                if _e715 {
                                    phi_1273_ = u32();
                                } else {
                                    phi_1273_ = select(((bitcast<u32>(_e726) << bitcast<u32>(23i)) | ((_e708 << bitcast<u32>(((_e718 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e726 >= 255i));
                                }
                                let _e740 = phi_1273_;
                                phi_1274_ = _e740;
                            }
                            let _e742 = phi_1274_;
                            phi_1282_ = bitcast<f32>(((_e389 & 2147483648u) | select(_e742, 0u, select(_e715, true, _e736))));
                            phi_1283_ = bitcast<f32>(((_e384 & 2147483648u) | select(_e696, 0u, select(_e669, true, _e690))));
                        } else {
                            phi_1282_ = 0f;
                            phi_1283_ = 1f;
                        }
                        let _e748 = phi_1282_;
                        let _e750 = phi_1283_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e754 = (_e432 % 3u);
                        let _e755 = (_e754 < 3u);
                        if _e755 {
                        } else {
                            break;
                        }
                        let _e757 = local_1[_e754];
                        let _e760 = (_e431 % 3u);
                        let _e761 = (_e760 < 3u);
                        if _e761 {
                        } else {
                            break;
                        }
                        let _e763 = local_1[_e760];
                        let _e766 = (_e433 % 3u);
                        let _e767 = (_e766 < 3u);
                        if _e767 {
                        } else {
                            break;
                        }
                        let _e769 = local_1[_e766];
                        if _e755 {
                        } else {
                            break;
                        }
                        let _e774 = local[_e754];
                        if _e761 {
                        } else {
                            break;
                        }
                        let _e778 = local[_e760];
                        if _e767 {
                        } else {
                            break;
                        }
                        let _e782 = local[_e766];
                        phi_4474_ = false;
                        phi_1379_ = type_48(_e748, false);
                        phi_1382_ = ((3u * _e100) + 1u);
                        phi_1384_ = (_e750 <= _e748);
                        phi_1386_ = 0u;
                        phi_1388_ = type_64(type_35(vec4<f32>((f32(_e757) * _e158), (f32(_e763) * _e158), (f32(_e769) * _e158), 0f), vec4<f32>((f32(_e774) * _e158), (f32(_e778) * _e158), (f32(_e782) * _e158), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        loop {
                            let _e792 = phi_4474_;
                            let _e794 = phi_1379_;
                            let _e796 = phi_1382_;
                            let _e798 = phi_1384_;
                            let _e800 = phi_1386_;
                            let _e802 = phi_1388_;
                            local_10 = _e794;
                            if _e798 {
                                phi_1399_ = true;
                            } else {
                                phi_1399_ = (_e800 > 0u);
                            }
                            let _e805 = phi_1399_;
                            if _e805 {
                                let _e806 = (_e796 > 0u);
                                if _e806 {
                                    if _e798 {
                                        phi_1485_ = _e798;
                                        phi_1486_ = _e800;
                                        phi_1487_ = _e802;
                                    } else {
                                        let _e807 = (_e800 - 1u);
                                        let _e808 = (_e807 % 128u);
                                        let _e809 = (_e808 < 128u);
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e811 = local_7[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e813 = local_6[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e815 = local_5[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e817 = local_4[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e819 = local_3[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e821 = local_2[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e826 = local_8[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e829 = local_9[_e808];
                                        phi_1485_ = (_e829 <= _e794.member);
                                        phi_1486_ = _e807;
                                        phi_1487_ = type_64(type_35(vec4<f32>(_e811, _e813, _e815, 0f), vec4<f32>(_e817, _e819, _e821, 0f)), _e826);
                                    }
                                    let _e833 = phi_1485_;
                                    let _e835 = phi_1486_;
                                    let _e837 = phi_1487_;
                                    if _e833 {
                                        let _e841 = ((_e837.member_1 & 2147483648u) != 0u);
                                        if _e841 {
                                            phi_1505_ = _e794;
                                            phi_1508_ = type_8(0u, ((_e837.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e848 = phi_1505_;
                                                let _e850 = phi_1508_;
                                                local_11 = _e848;
                                                if (_e850.member < _e850.member_1) {
                                                    phi_1509_ = type_8((_e850.member + 1u), _e850.member_1);
                                                    phi_1531_ = type_8(1u, _e850.member);
                                                } else {
                                                    phi_1509_ = _e850;
                                                    phi_1531_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e863 = phi_1509_;
                                                let _e865 = phi_1531_;
                                                let _e869 = (bitcast<i32>(_e865.member) != 0i);
                                                if _e869 {
                                                    let _e870 = ((_e837.member_1 & 268435455u) + _e865.member_1);
                                                    let _e871 = (_e870 < _e102);
                                                    if _e871 {
                                                        if _e871 {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e875 = global_5.member[_e870].member_1;
                                                        phi_1552_ = _e875;
                                                    } else {
                                                        phi_1552_ = 4294967295u;
                                                    }
                                                    let _e877 = phi_1552_;
                                                    if (_e870 >= _e102) {
                                                        phi_1644_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e871 {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        if (_e754 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e884 = global_5.member[_e870].member[_e754];
                                                        if (_e760 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e890 = global_5.member[_e870].member[_e760];
                                                        if (_e766 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e896 = global_5.member[_e870].member[_e766];
                                                        let _e898 = (3u + _e754);
                                                        if (_e898 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e904 = global_5.member[_e870].member[_e898];
                                                        let _e905 = (3u + _e760);
                                                        if (_e905 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e911 = global_5.member[_e870].member[_e905];
                                                        let _e912 = (3u + _e766);
                                                        if (_e912 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e918 = global_5.member[_e870].member[_e912];
                                                        let _e920 = (6u + _e754);
                                                        if (_e920 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e926 = global_5.member[_e870].member[_e920];
                                                        let _e927 = (6u + _e760);
                                                        if (_e927 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e933 = global_5.member[_e870].member[_e927];
                                                        let _e934 = (6u + _e766);
                                                        if (_e934 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e940 = global_5.member[_e870].member[_e934];
                                                        phi_1644_ = array<array<f32, 3>, 3>(array<f32, 3>(_e884, _e890, _e896), array<f32, 3>(_e904, _e911, _e918), array<f32, 3>(_e926, _e933, _e940));
                                                    }
                                                    let _e944 = phi_1644_;
                                                    let _e960 = (_e944[0][2] - _e608);
                                                    let _e963 = (((_e944[0][0] - _e479) * _e644) - (_e960 * _e516));
                                                    let _e966 = (((_e944[0][1] - _e544) * _e644) - (_e960 * _e580));
                                                    let _e969 = (_e944[1][2] - _e608);
                                                    let _e972 = (((_e944[1][0] - _e479) * _e644) - (_e969 * _e516));
                                                    let _e975 = (((_e944[1][1] - _e544) * _e644) - (_e969 * _e580));
                                                    let _e978 = (_e944[2][2] - _e608);
                                                    let _e981 = (((_e944[2][0] - _e479) * _e644) - (_e978 * _e516));
                                                    let _e984 = (((_e944[2][1] - _e544) * _e644) - (_e978 * _e580));
                                                    let _e985 = (_e981 * _e975);
                                                    let _e986 = (_e984 * _e972);
                                                    let _e987 = (_e963 * _e984);
                                                    let _e988 = (_e966 * _e981);
                                                    let _e989 = (_e972 * _e966);
                                                    let _e990 = (_e975 * _e963);
                                                    let _e995 = (((_e985 >= _e986) && (_e987 >= _e988)) && (_e989 >= _e990));
                                                    let _e1001 = (_e995 || (((_e985 <= _e986) && (_e987 <= _e988)) && (_e989 <= _e990)));
                                                    if _e1001 {
                                                        let _e1003 = select(-1f, 1f, _e995);
                                                        let _e1005 = ((_e985 - _e986) * _e1003);
                                                        let _e1007 = select(0f, _e1005, (_e1005 > 0f));
                                                        let _e1009 = ((_e987 - _e988) * _e1003);
                                                        let _e1011 = select(0f, _e1009, (_e1009 > 0f));
                                                        let _e1013 = ((_e989 - _e990) * _e1003);
                                                        let _e1015 = select(0f, _e1013, (_e1013 > 0f));
                                                        let _e1017 = ((_e1007 + _e1011) + _e1015);
                                                        let _e1019 = select(_e944[1][0], _e944[0][0], (_e944[0][0] < _e944[1][0]));
                                                        let _e1023 = select(_e944[1][0], _e944[0][0], (_e944[0][0] > _e944[1][0]));
                                                        let _e1027 = select(_e944[1][1], _e944[0][1], (_e944[0][1] < _e944[1][1]));
                                                        let _e1031 = select(_e944[1][1], _e944[0][1], (_e944[0][1] > _e944[1][1]));
                                                        let _e1035 = select(_e944[1][2], _e944[0][2], (_e944[0][2] < _e944[1][2]));
                                                        let _e1039 = select(_e944[1][2], _e944[0][2], (_e944[0][2] > _e944[1][2]));
                                                        let _e1044 = ((select(_e944[2][0], _e1019, (_e1019 < _e944[2][0])) - _e517) * _e520);
                                                        let _e1045 = ((select(_e944[2][0], _e1023, (_e1023 > _e944[2][0])) - _e518) * _e520);
                                                        let _e1048 = ((select(_e944[2][1], _e1027, (_e1027 < _e944[2][1])) - _e581) * _e584);
                                                        let _e1049 = ((select(_e944[2][1], _e1031, (_e1031 > _e944[2][1])) - _e582) * _e584);
                                                        let _e1052 = ((select(_e944[2][2], _e1035, (_e1035 < _e944[2][2])) - _e645) * _e648);
                                                        let _e1053 = ((select(_e944[2][2], _e1039, (_e1039 > _e944[2][2])) - _e646) * _e648);
                                                        let _e1055 = select(_e1053, _e1052, (_e1052 < _e1053));
                                                        let _e1057 = select(_e1053, _e1052, (_e1052 > _e1053));
                                                        let _e1059 = select(_e1045, _e1044, (_e1044 < _e1045));
                                                        let _e1061 = select(_e1049, _e1048, (_e1048 < _e1049));
                                                        let _e1063 = select(_e1061, _e1059, (_e1059 > _e1061));
                                                        let _e1065 = select(_e1055, _e1063, (_e1063 > _e1055));
                                                        let _e1067 = select(_e1045, _e1044, (_e1044 > _e1045));
                                                        let _e1069 = select(_e1049, _e1048, (_e1048 > _e1049));
                                                        let _e1071 = select(_e1069, _e1067, (_e1067 < _e1069));
                                                        let _e1073 = select(_e1057, _e1071, (_e1071 < _e1057));
                                                        let _e1074 = -(_e1055);
                                                        let _e1080 = select(_e750, _e1065, (_e1065 > _e750));
                                                        let _e1084 = select(_e972, _e963, (_e963 < _e972));
                                                        let _e1089 = select(_e972, _e963, (_e963 > _e972));
                                                        let _e1096 = select(_e975, _e966, (_e966 < _e975));
                                                        let _e1101 = select(_e975, _e966, (_e966 > _e975));
                                                        let _e1110 = (((((_e1001 && (_e1017 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e981, _e1084, (_e1084 < _e981)) <= 0f) && (select(_e981, _e1089, (_e1089 > _e981)) >= 0f))) && ((select(_e984, _e1096, (_e1096 < _e984)) <= 0f) && (select(_e984, _e1101, (_e1101 > _e984)) >= 0f))) && (_e1080 <= (_e1073 + (select(_e1074, _e1057, (_e1057 > _e1074)) * 0.0000019073523f)))) && (_e1080 <= _e848.member));
                                                        if _e1110 {
                                                            let _e1115 = (_e944[1][0] - _e944[0][0]);
                                                            let _e1116 = (_e944[1][1] - _e944[0][1]);
                                                            let _e1117 = (_e944[1][2] - _e944[0][2]);
                                                            let _e1118 = vec3<f32>(_e1115, _e1116, _e1117);
                                                            let _e1119 = (_e944[2][0] - _e944[1][0]);
                                                            let _e1120 = (_e944[2][1] - _e944[1][1]);
                                                            let _e1121 = (_e944[2][2] - _e944[1][2]);
                                                            let _e1122 = vec3<f32>(_e1119, _e1120, _e1121);
                                                            let _e1123 = (_e944[0][0] - _e944[2][0]);
                                                            let _e1124 = (_e944[0][1] - _e944[2][1]);
                                                            let _e1125 = (_e944[0][2] - _e944[2][2]);
                                                            let _e1126 = vec3<f32>(_e1123, _e1124, _e1125);
                                                            let _e1127 = abs(_e1115);
                                                            let _e1128 = abs(_e1116);
                                                            if (_e1127 != _e1127) {
                                                                phi_4109_ = true;
                                                            } else {
                                                                phi_4109_ = (_e1128 >= _e1127);
                                                            }
                                                            let _e1132 = phi_4109_;
                                                            let _e1133 = select(_e1127, _e1128, _e1132);
                                                            let _e1134 = abs(_e1117);
                                                            if (_e1133 != _e1133) {
                                                                phi_4124_ = true;
                                                            } else {
                                                                phi_4124_ = (_e1134 >= _e1133);
                                                            }
                                                            let _e1138 = phi_4124_;
                                                            let _e1139 = select(_e1133, _e1134, _e1138);
                                                            let _e1140 = abs(_e1119);
                                                            let _e1141 = abs(_e1120);
                                                            if (_e1140 != _e1140) {
                                                                phi_4139_ = true;
                                                            } else {
                                                                phi_4139_ = (_e1141 >= _e1140);
                                                            }
                                                            let _e1145 = phi_4139_;
                                                            let _e1146 = select(_e1140, _e1141, _e1145);
                                                            let _e1147 = abs(_e1121);
                                                            if (_e1146 != _e1146) {
                                                                phi_4154_ = true;
                                                            } else {
                                                                phi_4154_ = (_e1147 >= _e1146);
                                                            }
                                                            let _e1151 = phi_4154_;
                                                            let _e1152 = select(_e1146, _e1147, _e1151);
                                                            let _e1153 = abs(_e1123);
                                                            let _e1154 = abs(_e1124);
                                                            if (_e1153 != _e1153) {
                                                                phi_4169_ = true;
                                                            } else {
                                                                phi_4169_ = (_e1154 >= _e1153);
                                                            }
                                                            let _e1158 = phi_4169_;
                                                            let _e1159 = select(_e1153, _e1154, _e1158);
                                                            let _e1160 = abs(_e1125);
                                                            if (_e1159 != _e1159) {
                                                                phi_4184_ = true;
                                                            } else {
                                                                phi_4184_ = (_e1160 >= _e1159);
                                                            }
                                                            let _e1164 = phi_4184_;
                                                            let _e1165 = select(_e1159, _e1160, _e1164);
                                                            let _e1167 = select(_e1152, _e1139, (_e1139 > _e1152));
                                                            let _e1169 = select(_e1165, _e1167, (_e1167 > _e1165));
                                                            if (_e1139 == _e1169) {
                                                                phi_2186_ = _e975;
                                                                phi_2187_ = _e972;
                                                                phi_2188_ = _e966;
                                                                phi_2189_ = _e963;
                                                                phi_2190_ = vec3<f32>(_e944[0][0], _e944[0][1], _e944[0][2]);
                                                                phi_2191_ = _e1126;
                                                                phi_2192_ = _e1122;
                                                                phi_2193_ = _e1118;
                                                            } else {
                                                                let _e1171 = (_e1152 == _e1169);
                                                                let _e1176 = vec3(_e1171);
                                                                phi_2186_ = select(_e966, _e984, _e1171);
                                                                phi_2187_ = select(_e963, _e981, _e1171);
                                                                phi_2188_ = select(_e984, _e975, _e1171);
                                                                phi_2189_ = select(_e981, _e972, _e1171);
                                                                phi_2190_ = select(vec3<f32>(_e944[2][0], _e944[2][1], _e944[2][2]), vec3<f32>(_e944[1][0], _e944[1][1], _e944[1][2]), _e1176);
                                                                phi_2191_ = select(_e1122, _e1118, _e1176);
                                                                phi_2192_ = select(_e1118, _e1126, _e1176);
                                                                phi_2193_ = select(_e1126, _e1122, _e1176);
                                                            }
                                                            let _e1182 = phi_2186_;
                                                            let _e1184 = phi_2187_;
                                                            let _e1186 = phi_2188_;
                                                            let _e1188 = phi_2189_;
                                                            let _e1190 = phi_2190_;
                                                            let _e1192 = phi_2191_;
                                                            let _e1194 = phi_2192_;
                                                            let _e1196 = phi_2193_;
                                                            let _e1203 = ((_e1194.y * _e1192.z) - (_e1192.y * _e1194.z));
                                                            let _e1208 = ((_e1194.z * _e1192.x) - (_e1192.z * _e1194.x));
                                                            let _e1211 = ((_e1194.x * _e1192.y) - (_e1192.x * _e1194.y));
                                                            let _e1214 = ((_e1007 >= _e1011) && (_e1007 >= _e1015));
                                                            let _e1215 = (_e1011 >= _e1015);
                                                            let _e1229 = (((_e1203 * (select(select(_e944[2][0], _e944[1][0], _e1215), _e944[0][0], _e1214) - _e479)) + (_e1208 * (select(select(_e944[2][1], _e944[1][1], _e1215), _e944[0][1], _e1214) - _e544))) + (_e1211 * (select(select(_e944[2][2], _e944[1][2], _e1215), _e944[0][2], _e1214) - _e608)));
                                                            let _e1234 = (((_e1203 * _e516) + (_e1208 * _e580)) + (_e1211 * _e644));
                                                            let _e1235 = (_e1184 - _e1188);
                                                            let _e1236 = (_e1182 - _e1186);
                                                            let _e1239 = ((_e1235 * _e1235) + (_e1236 * _e1236));
                                                            let _e1246 = (-(((_e1188 * _e1235) + (_e1186 * _e1236))) / select(0.000000000000000000000000000000000000011754944f, _e1239, (_e1239 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1248 = select(1f, _e1246, (_e1246 < 1f));
                                                            let _e1250 = select(0f, _e1248, (_e1248 > 0f));
                                                            let _e1259 = ((_e1190.x + (_e1196.x * _e1250)) - _e479);
                                                            let _e1262 = ((_e1190.y + (_e1196.y * _e1250)) - _e544);
                                                            let _e1265 = ((_e1190.z + (_e1196.z * _e1250)) - _e608);
                                                            let _e1268 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                            let _e1271 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                            let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                            let _e1276 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                            let _e1278 = select(_e1276, _e1273, (_e1273 > _e1276));
                                                            let _e1282 = abs(_e1203);
                                                            let _e1283 = abs(_e1208);
                                                            if (_e1282 != _e1282) {
                                                                phi_4199_ = true;
                                                            } else {
                                                                phi_4199_ = (_e1283 >= _e1282);
                                                            }
                                                            let _e1287 = phi_4199_;
                                                            let _e1288 = select(_e1282, _e1283, _e1287);
                                                            let _e1289 = abs(_e1211);
                                                            if (_e1288 != _e1288) {
                                                                phi_4214_ = true;
                                                            } else {
                                                                phi_4214_ = (_e1289 >= _e1288);
                                                            }
                                                            let _e1293 = phi_4214_;
                                                            let _e1309 = abs(_e1194.x);
                                                            let _e1310 = abs(_e1194.y);
                                                            if (_e1309 != _e1309) {
                                                                phi_4229_ = true;
                                                            } else {
                                                                phi_4229_ = (_e1310 >= _e1309);
                                                            }
                                                            let _e1314 = phi_4229_;
                                                            let _e1315 = select(_e1309, _e1310, _e1314);
                                                            let _e1316 = abs(_e1194.z);
                                                            if (_e1315 != _e1315) {
                                                                phi_4244_ = true;
                                                            } else {
                                                                phi_4244_ = (_e1316 >= _e1315);
                                                            }
                                                            let _e1320 = phi_4244_;
                                                            let _e1323 = abs(_e1192.x);
                                                            let _e1324 = abs(_e1192.y);
                                                            if (_e1323 != _e1323) {
                                                                phi_4259_ = true;
                                                            } else {
                                                                phi_4259_ = (_e1324 >= _e1323);
                                                            }
                                                            let _e1328 = phi_4259_;
                                                            let _e1329 = select(_e1323, _e1324, _e1328);
                                                            let _e1330 = abs(_e1192.z);
                                                            if (_e1329 != _e1329) {
                                                                phi_4274_ = true;
                                                            } else {
                                                                phi_4274_ = (_e1330 >= _e1329);
                                                            }
                                                            let _e1334 = phi_4274_;
                                                            let _e1339 = ((bitcast<f32>((bitcast<u32>(((((_e1203 * _e1259) + (_e1208 * _e1262)) + (_e1211 * _e1265)) - _e1229)) & 2147483647u)) <= ((0.0000009536743f * select(_e1169, _e1278, (_e1278 > _e1169))) * select(_e1288, _e1289, _e1293))) && !((bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u)) <= ((0.0000038146973f * select(_e1315, _e1316, _e1320)) * select(_e1329, _e1330, _e1334)))));
                                                            let _e1340 = (_e1229 / _e1234);
                                                            if (_e1110 && !(_e1339)) {
                                                                let _e1343 = (_e1265 / _e644);
                                                                let _e1351 = (((_e1203 * (_e1259 - (_e516 * _e1343))) + (_e1208 * (_e1262 - (_e580 * _e1343)))) / _e1234);
                                                                phi_2401_ = select(select(_e1343, (_e1343 + _e1351), (bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u)) <= _e1169)), _e1340, _e1339);
                                                            } else {
                                                                phi_2401_ = _e1340;
                                                            }
                                                            let _e1360 = phi_2401_;
                                                            let _e1362 = select(_e1073, _e1360, (_e1360 < _e1073));
                                                            let _e1364 = select(_e1065, _e1362, (_e1362 > _e1065));
                                                            let _e1365 = (1f / _e1017);
                                                            phi_2421_ = type_47(_e1364, (_e1011 * _e1365), (_e1015 * _e1365), ((_e1110 && (_e1364 >= _e750)) && (_e1364 <= _e848.member)));
                                                            phi_2422_ = type_47();
                                                        } else {
                                                            phi_2421_ = type_47();
                                                            phi_2422_ = type_47(0f, 0f, 0f, _e1110);
                                                        }
                                                        let _e1374 = phi_2421_;
                                                        let _e1376 = phi_2422_;
                                                        phi_2425_ = _e1374;
                                                        phi_2426_ = _e1376;
                                                        phi_2427_ = select(true, false, _e1110);
                                                    } else {
                                                        phi_2425_ = type_47();
                                                        phi_2426_ = type_47(0f, 0f, 0f, _e1001);
                                                        phi_2427_ = true;
                                                    }
                                                    let _e1379 = phi_2425_;
                                                    let _e1381 = phi_2426_;
                                                    let _e1383 = phi_2427_;
                                                    if _e1383 {
                                                        phi_2431_ = _e1381;
                                                    } else {
                                                        phi_2431_ = _e1379;
                                                    }
                                                    let _e1385 = phi_2431_;
                                                    if _e1385.member_3 {
                                                        phi_2440_ = type_26(_e1385.member, _e1385.member_1, _e1385.member_2, _e877);
                                                    } else {
                                                        phi_2440_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1392 = phi_2440_;
                                                    if (_e1392.member_3 != 4294967295u) {
                                                        if (_e877 == _e167) {
                                                            phi_2775_ = false;
                                                        } else {
                                                            let _e1396 = (_e877 < arrayLength((&global_6.member)));
                                                            if _e1396 {
                                                                if _e1396 {
                                                                } else {
                                                                    phi_4468_ = true;
                                                                    break;
                                                                }
                                                                let _e1398 = global_6.member[_e877];
                                                                phi_2463_ = _e1398;
                                                            } else {
                                                                phi_2463_ = 4294967295u;
                                                            }
                                                            let _e1400 = phi_2463_;
                                                            let _e1401 = (_e1400 < arrayLength((&global_7.member)));
                                                            if _e1401 {
                                                                if _e1401 {
                                                                } else {
                                                                    phi_4468_ = true;
                                                                    break;
                                                                }
                                                                let _e1403 = global_7.member[_e1400];
                                                                phi_2477_ = _e1403;
                                                            } else {
                                                                phi_2477_ = 0i;
                                                            }
                                                            let _e1405 = phi_2477_;
                                                            let _e1406 = (_e1405 == 0i);
                                                            if _e1406 {
                                                                phi_2774_ = true;
                                                            } else {
                                                                if _e456 {
                                                                    phi_2500_ = vec3<f32>(_e944[0][0], _e944[0][1], _e944[0][2]);
                                                                } else {
                                                                    if (_e432 == 1u) {
                                                                        phi_2499_ = vec3<f32>(_e944[0][2], _e944[0][0], _e944[0][1]);
                                                                    } else {
                                                                        phi_2499_ = vec3<f32>(_e944[0][1], _e944[0][2], _e944[0][0]);
                                                                    }
                                                                    let _e1411 = phi_2499_;
                                                                    phi_2500_ = _e1411;
                                                                }
                                                                let _e1414 = phi_2500_;
                                                                if _e456 {
                                                                    phi_2519_ = vec3<f32>(_e944[1][0], _e944[1][1], _e944[1][2]);
                                                                } else {
                                                                    if (_e432 == 1u) {
                                                                        phi_2518_ = vec3<f32>(_e944[1][2], _e944[1][0], _e944[1][1]);
                                                                    } else {
                                                                        phi_2518_ = vec3<f32>(_e944[1][1], _e944[1][2], _e944[1][0]);
                                                                    }
                                                                    let _e1419 = phi_2518_;
                                                                    phi_2519_ = _e1419;
                                                                }
                                                                let _e1422 = phi_2519_;
                                                                if _e456 {
                                                                    phi_2538_ = vec3<f32>(_e944[2][0], _e944[2][1], _e944[2][2]);
                                                                } else {
                                                                    if (_e432 == 1u) {
                                                                        phi_2537_ = vec3<f32>(_e944[2][2], _e944[2][0], _e944[2][1]);
                                                                    } else {
                                                                        phi_2537_ = vec3<f32>(_e944[2][1], _e944[2][2], _e944[2][0]);
                                                                    }
                                                                    let _e1427 = phi_2537_;
                                                                    phi_2538_ = _e1427;
                                                                }
                                                                let _e1430 = phi_2538_;
                                                                let _e1433 = (_e1422.x - _e1414.x);
                                                                let _e1436 = (_e1422.y - _e1414.y);
                                                                let _e1439 = (_e1422.z - _e1414.z);
                                                                let _e1441 = (_e1430.x - _e1414.x);
                                                                let _e1443 = (_e1430.y - _e1414.y);
                                                                let _e1445 = (_e1430.z - _e1414.z);
                                                                if (_e299.member_1 == 1u) {
                                                                    phi_2574_ = (vec3<f32>(_e299.member[0], _e299.member[1], _e299.member[2]) - _e1414);
                                                                } else {
                                                                    phi_2574_ = vec3<f32>(_e299.member[0], _e299.member[1], _e299.member[2]);
                                                                }
                                                                let _e1460 = phi_2574_;
                                                                let _e1466 = bitcast<f32>((bitcast<u32>((_e1433 * _e1443)) ^ _e299.member_3[0]));
                                                                let _e1470 = bitcast<f32>((bitcast<u32>((_e1436 * _e1441)) ^ _e299.member_3[0]));
                                                                let _e1474 = bitcast<f32>((bitcast<u32>((_e1436 * _e1445)) ^ _e299.member_3[0]));
                                                                let _e1478 = bitcast<f32>((bitcast<u32>((_e1439 * _e1443)) ^ _e299.member_3[0]));
                                                                let _e1482 = bitcast<f32>((bitcast<u32>((_e1439 * _e1441)) ^ _e299.member_3[0]));
                                                                let _e1486 = bitcast<f32>((bitcast<u32>((_e1433 * _e1445)) ^ _e299.member_3[0]));
                                                                let _e1487 = (_e1474 - _e1478);
                                                                let _e1488 = (_e1482 - _e1486);
                                                                let _e1489 = (_e1466 - _e1470);
                                                                let _e1513 = (bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u)));
                                                                let _e1520 = (bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u)));
                                                                let _e1527 = (bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u)));
                                                                if (_e299.member_2 == 0f) {
                                                                    phi_2756_ = 0f;
                                                                } else {
                                                                    let _e1557 = bitcast<f32>((bitcast<u32>(_e1487) & 2147483647u));
                                                                    let _e1560 = bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u));
                                                                    let _e1563 = bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u));
                                                                    let _e1565 = select(_e1563, _e1560, (_e1560 > _e1563));
                                                                    let _e1569 = select(_e1563, _e1560, (_e1560 < _e1563));
                                                                    let _e1573 = select(_e1560, _e1557, (_e1557 < _e1560));
                                                                    let _e1575 = select(_e1560, _e1557, (_e1557 > _e1560));
                                                                    let _e1577 = select(_e1563, _e1575, (_e1575 < _e1563));
                                                                    phi_2756_ = bitcast<f32>((bitcast<u32>((_e299.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1565, _e1557, (_e1557 > _e1565)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1577, _e1573, (_e1573 > _e1577)))) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1569, _e1557, (_e1557 < _e1569)))) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1513 + _e1520) + _e1527))) ^ _e299.member_3[0]))) * 1.0000005f)) ^ _e299.member_3[0])))) ^ _e299.member_3[0]));
                                                                }
                                                                let _e1604 = phi_2756_;
                                                                phi_2774_ = (_e1406 || !(((((bitcast<f32>((bitcast<u32>((_e1460.x * _e1487)) ^ _e299.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1460.y * _e1488)) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1460.z * _e1489)) ^ _e299.member_3[0]))) * f32(-(_e1405))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1460.x) & 2147483647u)) * _e1513)) ^ _e299.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1460.y) & 2147483647u)) * _e1520)) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1460.z) & 2147483647u)) * _e1527)) ^ _e299.member_3[0]))))) ^ _e299.member_3[0])) + _e1604) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1618 = phi_2774_;
                                                            phi_2775_ = _e1618;
                                                        }
                                                        let _e1620 = phi_2775_;
                                                        if _e1620 {
                                                            phi_2780_ = type_48(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2780_ = _e848;
                                                        }
                                                        let _e1622 = phi_2780_;
                                                        phi_2781_ = _e1622;
                                                    } else {
                                                        phi_2781_ = _e848;
                                                    }
                                                    let _e1624 = phi_2781_;
                                                    phi_1506_ = _e1624;
                                                } else {
                                                    phi_1506_ = type_48();
                                                }
                                                let _e1626 = phi_1506_;
                                                continue;
                                                continuing {
                                                    phi_1505_ = _e1626;
                                                    phi_1508_ = _e863;
                                                    phi_4468_ = _e792;
                                                    break if !(_e869);
                                                }
                                            }
                                            let _e1629 = phi_4468_;
                                            phi_4665_ = _e1629;
                                            if _e1629 {
                                                break;
                                            }
                                            phi_4751_ = _e1629;
                                            let _e2270 = local_11;
                                            phi_2782_ = _e2270;
                                        } else {
                                            phi_4751_ = _e792;
                                            phi_2782_ = _e794;
                                        }
                                        let _e1631 = phi_4751_;
                                        let _e1633 = phi_2782_;
                                        if _e841 {
                                            phi_4012_ = bool();
                                            phi_4013_ = u32();
                                            phi_4014_ = type_64();
                                        } else {
                                            if (_e837.member_1 >= _e100) {
                                                phi_3548_ = type_65(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_64(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_64(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e837.member_1 < _e100) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1636 = (_e432 * 2u);
                                                let _e1638 = ((1u + _e1636) % 7u);
                                                if (_e1638 < 7u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1643 = global_9.member[_e837.member_1][_e1638];
                                                let _e1645 = ((_e1636 + 2u) % 7u);
                                                if (_e1645 < 7u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1650 = global_9.member[_e837.member_1][_e1645];
                                                let _e1651 = (_e431 * 2u);
                                                let _e1653 = ((1u + _e1651) % 7u);
                                                if (_e1653 < 7u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1658 = global_9.member[_e837.member_1][_e1653];
                                                let _e1660 = ((_e1651 + 2u) % 7u);
                                                if (_e1660 < 7u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1665 = global_9.member[_e837.member_1][_e1660];
                                                let _e1666 = (_e433 * 2u);
                                                let _e1668 = ((1u + _e1666) % 7u);
                                                if (_e1668 < 7u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1673 = global_9.member[_e837.member_1][_e1668];
                                                let _e1675 = ((_e1666 + 2u) % 7u);
                                                if (_e1675 < 7u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1680 = global_9.member[_e837.member_1][_e1675];
                                                let _e1703 = (bitcast<f32>((bitcast<u32>((_e837.member.member_1.x - _e837.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1704 = (bitcast<f32>((bitcast<u32>((_e837.member.member_1.y - _e837.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1705 = (bitcast<f32>((bitcast<u32>((_e837.member.member_1.z - _e837.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1707 = select(_e158, _e1703, (_e1703 > _e158));
                                                let _e1709 = select(_e158, _e1704, (_e1704 > _e158));
                                                let _e1711 = select(_e158, _e1705, (_e1705 > _e158));
                                                let _e1742 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1643 & 2097151u))) - 8388608f) * _e1707));
                                                let _e1747 = (bitcast<i32>((_e1643 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1750 = bitcast<f32>((_e1742 & bitcast<u32>(_e1747)));
                                                let _e1751 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1658 & 2097151u))) - 8388608f) * _e1709));
                                                let _e1756 = (bitcast<i32>((_e1658 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1759 = bitcast<f32>((_e1751 & bitcast<u32>(_e1756)));
                                                let _e1760 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1673 & 2097151u))) - 8388608f) * _e1711));
                                                let _e1765 = (bitcast<i32>((_e1673 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1768 = bitcast<f32>((_e1760 & bitcast<u32>(_e1765)));
                                                let _e1772 = bitcast<f32>((_e1742 & bitcast<u32>(~(_e1747))));
                                                let _e1776 = bitcast<f32>((_e1751 & bitcast<u32>(~(_e1756))));
                                                let _e1780 = bitcast<f32>((_e1760 & bitcast<u32>(~(_e1765))));
                                                let _e1781 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1650 & 2097151u))) - 8388608f) * _e1707));
                                                let _e1786 = (bitcast<i32>((_e1650 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1789 = bitcast<f32>((_e1781 & bitcast<u32>(_e1786)));
                                                let _e1790 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1665 & 2097151u))) - 8388608f) * _e1709));
                                                let _e1795 = (bitcast<i32>((_e1665 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1798 = bitcast<f32>((_e1790 & bitcast<u32>(_e1795)));
                                                let _e1799 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1680 & 2097151u))) - 8388608f) * _e1711));
                                                let _e1804 = (bitcast<i32>((_e1680 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1807 = bitcast<f32>((_e1799 & bitcast<u32>(_e1804)));
                                                let _e1811 = bitcast<f32>((_e1781 & bitcast<u32>(~(_e1786))));
                                                let _e1815 = bitcast<f32>((_e1790 & bitcast<u32>(~(_e1795))));
                                                let _e1819 = bitcast<f32>((_e1799 & bitcast<u32>(~(_e1804))));
                                                let _e1849 = global_9.member[_e837.member_1][0u];
                                                let _e1853 = global_9.member[_e837.member_1][2u];
                                                let _e1857 = global_9.member[_e837.member_1][4u];
                                                let _e1861 = global_9.member[_e837.member_1][6u];
                                                let _e1873 = (((_e1853 >> bitcast<u32>(22i)) | ((_e1857 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1861 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1874 = (_e1849 & 268435455u);
                                                let _e1875 = (_e1873 & 268435455u);
                                                let _e1878 = ((_e1849 >> bitcast<u32>(28u)) & 7u);
                                                let _e1886 = ((_e1849 >> bitcast<u32>(31i)) | (((_e1873 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1887 = (_e1878 != 0u);
                                                if (_e1878 == 0u) {
                                                    phi_3510_ = _e1874;
                                                } else {
                                                    if (_e1878 == 7u) {
                                                        phi_3509_ = 2147483648u;
                                                    } else {
                                                        phi_3509_ = ((2147483648u | (_e1878 << bitcast<u32>(28u))) | (_e1875 & 268435455u));
                                                    }
                                                    let _e1896 = phi_3509_;
                                                    phi_3510_ = _e1896;
                                                }
                                                let _e1898 = phi_3510_;
                                                if _e1887 {
                                                    let _e1899 = (_e1878 != 7u);
                                                    if _e1899 {
                                                        phi_3520_ = (_e1875 + _e1878);
                                                    } else {
                                                        phi_3520_ = u32();
                                                    }
                                                    let _e1902 = phi_3520_;
                                                    phi_3522_ = _e1902;
                                                    phi_3523_ = select(true, false, _e1899);
                                                } else {
                                                    phi_3522_ = u32();
                                                    phi_3523_ = true;
                                                }
                                                let _e1905 = phi_3522_;
                                                let _e1907 = phi_3523_;
                                                if (_e1886 == 0u) {
                                                    phi_3544_ = (_e1874 + select(0u, 1u, !(_e1887)));
                                                } else {
                                                    if (_e1886 == 7u) {
                                                        phi_3543_ = 2147483648u;
                                                    } else {
                                                        phi_3543_ = ((2147483648u | (_e1886 << bitcast<u32>(28u))) | (select(_e1905, _e1875, _e1907) & 268435455u));
                                                    }
                                                    let _e1920 = phi_3543_;
                                                    phi_3544_ = _e1920;
                                                }
                                                let _e1922 = phi_3544_;
                                                phi_3548_ = type_65(array<vec4<f32>, 3>(vec4<f32>((_e837.member.member.x + _e1750), (_e837.member.member.x + _e1772), (_e837.member.member_1.x - _e1789), (_e837.member.member_1.x - _e1811)), vec4<f32>((_e837.member.member.y + _e1759), (_e837.member.member.y + _e1776), (_e837.member.member_1.y - _e1798), (_e837.member.member_1.y - _e1815)), vec4<f32>((_e837.member.member.z + _e1768), (_e837.member.member.z + _e1780), (_e837.member.member_1.z - _e1807), (_e837.member.member_1.z - _e1819))), type_64(type_35((_e837.member.member + vec4<f32>(_e1750, _e1759, _e1768, 0f)), (_e837.member.member_1 - vec4<f32>(_e1789, _e1798, _e1807, 0f))), _e1898), type_64(type_35((_e837.member.member + vec4<f32>(_e1772, _e1776, _e1780, 0f)), (_e837.member.member_1 - vec4<f32>(_e1811, _e1815, _e1819, 0f))), _e1922));
                                            }
                                            let _e1927 = phi_3548_;
                                            let _e1939 = ((_e1927.member[0].x - _e517) * _e520);
                                            let _e1940 = ((_e1927.member[0].y - _e517) * _e520);
                                            let _e1941 = ((_e1927.member[0].z - _e518) * _e520);
                                            let _e1942 = ((_e1927.member[0].w - _e518) * _e520);
                                            let _e1952 = ((_e1927.member[1].x - _e581) * _e584);
                                            let _e1953 = ((_e1927.member[1].y - _e581) * _e584);
                                            let _e1954 = ((_e1927.member[1].z - _e582) * _e584);
                                            let _e1955 = ((_e1927.member[1].w - _e582) * _e584);
                                            let _e1965 = ((_e1927.member[2].x - _e645) * _e648);
                                            let _e1966 = ((_e1927.member[2].y - _e645) * _e648);
                                            let _e1967 = ((_e1927.member[2].z - _e646) * _e648);
                                            let _e1968 = ((_e1927.member[2].w - _e646) * _e648);
                                            let _e1970 = select(_e1967, _e1965, (_e1965 < _e1967));
                                            let _e1972 = select(_e1968, _e1966, (_e1966 < _e1968));
                                            let _e1974 = select(_e1967, _e1965, (_e1965 > _e1967));
                                            let _e1976 = select(_e1968, _e1966, (_e1966 > _e1968));
                                            let _e1978 = select(_e1941, _e1939, (_e1939 < _e1941));
                                            let _e1980 = select(_e1942, _e1940, (_e1940 < _e1942));
                                            let _e1982 = select(_e1954, _e1952, (_e1952 < _e1954));
                                            let _e1984 = select(_e1955, _e1953, (_e1953 < _e1955));
                                            let _e1986 = select(_e1982, _e1978, (_e1978 > _e1982));
                                            let _e1988 = select(_e1984, _e1980, (_e1980 > _e1984));
                                            let _e1990 = select(_e1970, _e1986, (_e1986 > _e1970));
                                            let _e1992 = select(_e1972, _e1988, (_e1988 > _e1972));
                                            let _e1994 = select(_e1941, _e1939, (_e1939 > _e1941));
                                            let _e1996 = select(_e1942, _e1940, (_e1940 > _e1942));
                                            let _e1998 = select(_e1954, _e1952, (_e1952 > _e1954));
                                            let _e2000 = select(_e1955, _e1953, (_e1953 > _e1955));
                                            let _e2002 = select(_e1998, _e1994, (_e1994 < _e1998));
                                            let _e2004 = select(_e2000, _e1996, (_e1996 < _e2000));
                                            let _e2009 = -(_e1970);
                                            let _e2010 = -(_e1972);
                                            let _e2017 = (select(_e1974, _e2002, (_e2002 < _e1974)) + (select(_e2009, _e1974, (_e1974 > _e2009)) * 0.0000019073523f));
                                            let _e2018 = (select(_e1976, _e2004, (_e2004 < _e1976)) + (select(_e2010, _e1976, (_e1976 > _e2010)) * 0.0000019073523f));
                                            let _e2020 = select(_e750, _e1990, (_e1990 > _e750));
                                            let _e2022 = select(_e750, _e1992, (_e1992 > _e750));
                                            let _e2027 = (_e2020 <= select(_e1633.member, _e2017, (_e2017 < _e1633.member)));
                                            let _e2028 = (_e2022 <= select(_e1633.member, _e2018, (_e2018 < _e1633.member)));
                                            let _e2029 = (_e2020 <= _e2022);
                                            if _e2027 {
                                                if _e2028 {
                                                    if _e2029 {
                                                        phi_3910_ = _e1927.member_2;
                                                    } else {
                                                        phi_3910_ = _e1927.member_1;
                                                    }
                                                    let _e2033 = phi_3910_;
                                                    let _e2054 = (_e835 % 128u);
                                                    let _e2055 = (_e2054 < 128u);
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2054] = _e2033.member_1;
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2054] = _e2033.member.member.x;
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2054] = _e2033.member.member.y;
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2054] = _e2033.member.member.z;
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2054] = _e2033.member.member_1.x;
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2054] = _e2033.member.member_1.y;
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2054] = _e2033.member.member_1.z;
                                                    if _e2055 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2054] = select(_e2020, _e2022, _e2029);
                                                    if _e2029 {
                                                        phi_3986_ = _e1927.member_1;
                                                    } else {
                                                        phi_3986_ = _e1927.member_2;
                                                    }
                                                    let _e2068 = phi_3986_;
                                                    phi_3987_ = (_e835 + 1u);
                                                    phi_3988_ = _e2068;
                                                } else {
                                                    phi_3987_ = u32();
                                                    phi_3988_ = type_64();
                                                }
                                                let _e2070 = phi_3987_;
                                                let _e2072 = phi_3988_;
                                                phi_3990_ = _e2070;
                                                phi_3991_ = _e2072;
                                                phi_3992_ = select(true, false, _e2028);
                                            } else {
                                                phi_3990_ = u32();
                                                phi_3991_ = type_64();
                                                phi_3992_ = true;
                                            }
                                            let _e2075 = phi_3990_;
                                            let _e2077 = phi_3991_;
                                            let _e2079 = phi_3992_;
                                            if _e2079 {
                                                if _e2027 {
                                                    phi_4001_ = _e1927.member_1;
                                                } else {
                                                    phi_4001_ = _e1927.member_2;
                                                }
                                                let _e2083 = phi_4001_;
                                                phi_4006_ = select(_e2028, true, _e2027);
                                                phi_4008_ = _e2083;
                                            } else {
                                                phi_4006_ = _e833;
                                                phi_4008_ = _e2077;
                                            }
                                            let _e2086 = phi_4006_;
                                            let _e2088 = phi_4008_;
                                            phi_4012_ = _e2086;
                                            phi_4013_ = select(_e2075, _e835, _e2079);
                                            phi_4014_ = _e2088;
                                        }
                                        let _e2091 = phi_4012_;
                                        let _e2093 = phi_4013_;
                                        let _e2095 = phi_4014_;
                                        if _e841 {
                                            phi_4024_ = select(_e835, 0u, _e1633.member_1);
                                            phi_4025_ = _e837;
                                        } else {
                                            phi_4024_ = _e2093;
                                            phi_4025_ = _e2095;
                                        }
                                        let _e2099 = phi_4024_;
                                        let _e2101 = phi_4025_;
                                        phi_4668_ = _e1631;
                                        phi_4026_ = _e1633;
                                        phi_4027_ = (_e796 - 1u);
                                        phi_4028_ = select(_e2091, false, _e841);
                                        phi_4029_ = _e2099;
                                        phi_4030_ = _e2101;
                                    } else {
                                        phi_4668_ = _e792;
                                        phi_4026_ = _e794;
                                        phi_4027_ = _e796;
                                        phi_4028_ = _e833;
                                        phi_4029_ = _e835;
                                        phi_4030_ = _e837;
                                    }
                                    let _e2104 = phi_4668_;
                                    let _e2106 = phi_4026_;
                                    let _e2108 = phi_4027_;
                                    let _e2110 = phi_4028_;
                                    let _e2112 = phi_4029_;
                                    let _e2114 = phi_4030_;
                                    phi_4667_ = _e2104;
                                    phi_4031_ = _e2106;
                                    phi_4032_ = _e2108;
                                    phi_4033_ = _e2110;
                                    phi_4034_ = _e2112;
                                    phi_4035_ = _e2114;
                                } else {
                                    phi_4667_ = _e792;
                                    phi_4031_ = type_48();
                                    phi_4032_ = u32();
                                    phi_4033_ = bool();
                                    phi_4034_ = u32();
                                    phi_4035_ = type_64();
                                }
                                let _e2116 = phi_4667_;
                                let _e2118 = phi_4031_;
                                let _e2120 = phi_4032_;
                                let _e2122 = phi_4033_;
                                let _e2124 = phi_4034_;
                                let _e2126 = phi_4035_;
                                phi_4666_ = _e2116;
                                phi_1380_ = _e2118;
                                phi_1383_ = _e2120;
                                phi_1385_ = _e2122;
                                phi_1387_ = _e2124;
                                phi_1389_ = _e2126;
                                phi_4036_ = _e806;
                            } else {
                                phi_4666_ = _e792;
                                phi_1380_ = type_48();
                                phi_1383_ = u32();
                                phi_1385_ = bool();
                                phi_1387_ = u32();
                                phi_1389_ = type_64();
                                phi_4036_ = false;
                            }
                            let _e2128 = phi_4666_;
                            let _e2130 = phi_1380_;
                            let _e2132 = phi_1383_;
                            let _e2134 = phi_1385_;
                            let _e2136 = phi_1387_;
                            let _e2138 = phi_1389_;
                            let _e2140 = phi_4036_;
                            continue;
                            continuing {
                                phi_4474_ = _e2128;
                                phi_1379_ = _e2130;
                                phi_1382_ = _e2132;
                                phi_1384_ = _e2134;
                                phi_1386_ = _e2136;
                                phi_1388_ = _e2138;
                                phi_4665_ = _e2128;
                                break if !(_e2140);
                            }
                        }
                        let _e2143 = phi_4665_;
                        if _e2143 {
                            break;
                        }
                        let _e2145 = local_10;
                        if _e2145.member_1 {
                        } else {
                            if _e300 {
                            } else {
                                break;
                            }
                            let _e2149 = global_2.member[_e146];
                            if _e161 {
                            } else {
                                break;
                            }
                            let _e2153 = global_10.member[_e146].member_1;
                            if _e300 {
                            } else {
                                break;
                            }
                            global_2.member[_e146] = type_28(_e2149.member, _e2149.member_1, _e2149.member_2, array<f32, 3>((_e2149.member_3[0] + (_e2153[0] * _e2149.member_1[0])), (_e2149.member_3[1] + (_e2153[1] * _e2149.member_1[1])), (_e2149.member_3[2] + (_e2153[2] * _e2149.member_1[2]))), _e2149.member_4);
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
