struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_39 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_51 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_52 {
    member: f32,
    member_1: bool,
}

struct type_54 {
    member: array<vec4<u32>, 2>,
}

struct type_57 {
    member: array<i32>,
}

struct type_64 {
    member: type_39,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_34;
@group(0) @binding(1) 
var<uniform> global_3: type_54;
@group(0) @binding(2) 
var<uniform> global_4: type_54;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_57;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_70;
@group(0) @binding(7) 
var<storage> global_10: type_42;

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
    var phi_540_: type_45;
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
    var phi_1379_: type_52;
    var phi_1382_: u32;
    var phi_1384_: bool;
    var phi_1386_: u32;
    var phi_1388_: type_64;
    var phi_1399_: bool;
    var phi_1485_: bool;
    var phi_1486_: u32;
    var phi_1487_: type_64;
    var phi_1505_: type_52;
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
    var phi_2421_: type_51;
    var phi_2422_: type_51;
    var phi_2425_: type_51;
    var phi_2426_: type_51;
    var phi_2427_: bool;
    var phi_2431_: type_51;
    var phi_2440_: type_30;
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
    var phi_2780_: type_52;
    var phi_2781_: type_52;
    var phi_1506_: type_52;
    var phi_4468_: bool;
    var phi_4751_: bool;
    var phi_2782_: type_52;
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
    var phi_4026_: type_52;
    var phi_4027_: u32;
    var phi_4028_: bool;
    var phi_4029_: u32;
    var phi_4030_: type_64;
    var phi_4667_: bool;
    var phi_4031_: type_52;
    var phi_4032_: u32;
    var phi_4033_: bool;
    var phi_4034_: u32;
    var phi_4035_: type_64;
    var phi_4666_: bool;
    var phi_1380_: type_52;
    var phi_1383_: u32;
    var phi_1385_: bool;
    var phi_1387_: u32;
    var phi_1389_: type_64;
    var phi_4036_: bool;
    var phi_4665_: bool;
    var local_10: type_52;
    var local_11: type_52;

    switch bitcast<i32>(0u) {
        default: {
            let _e100 = global;
            let _e102 = arrayLength((&global_5.member));
            let _e104 = arrayLength((&global_6.member));
            let _e116 = arrayLength((&global_9.member));
            let _e120 = global_4.member[0u][0u];
            let _e124 = global_4.member[0u][1u];
            let _e128 = global_4.member[0u][2u];
            let _e132 = global_4.member[0u][3u];
            let _e136 = global_4.member[1u][0u];
            let _e140 = global_4.member[1u][1u];
            let _e144 = global_4.member[1u][2u];
            let _e148 = (_e100.x + (_e100.y * 2097152u));
            let _e160 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e132) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            local = array<i32, 3>(bitcast<i32>(_e136), bitcast<i32>(_e140), bitcast<i32>(_e144));
            let _e163 = (_e148 < arrayLength((&global_10.member)));
            if _e163 {
                if _e163 {
                } else {
                    break;
                }
                let _e167 = global_10.member[_e148].member_2;
                phi_356_ = _e167;
            } else {
                phi_356_ = 4294967295u;
            }
            let _e169 = phi_356_;
            let _e172 = global_1.member[0u];
            let _e176 = global_3.member[0u][0u];
            let _e180 = global_3.member[0u][1u];
            let _e184 = global_3.member[0u][2u];
            let _e188 = global_3.member[0u][3u];
            let _e192 = global_3.member[1u][0u];
            let _e196 = global_3.member[1u][1u];
            let _e200 = global_3.member[1u][2u];
            let _e204 = global_3.member[1u][3u];
            let _e205 = bitcast<f32>(_e176);
            let _e206 = bitcast<f32>(_e180);
            let _e207 = bitcast<f32>(_e184);
            let _e209 = bitcast<f32>(_e192);
            let _e210 = array<u32, 3>(_e196, _e200, _e204);
            let _e212 = bitcast<i32>(_e172);
            if (_e212 < -126i) {
                phi_400_ = -126i;
            } else {
                phi_400_ = select(_e212, 127i, (_e212 > 127i));
            }
            let _e217 = phi_400_;
            let _e222 = bitcast<f32>((bitcast<u32>((_e217 + 127i)) << bitcast<u32>(23i)));
            let _e228 = bitcast<f32>((bitcast<u32>(((_e212 - _e217) + 127i)) << bitcast<u32>(23i)));
            if (_e188 == 0u) {
                phi_540_ = type_45(array<f32, 3>(_e205, _e206, _e207), _e188, _e209, _e210);
            } else {
                let _e230 = bitcast<u32>(_e205);
                let _e232 = ((_e230 & 2139095040u) != 0u);
                let _e247 = bitcast<u32>(_e206);
                let _e249 = ((_e247 & 2139095040u) != 0u);
                let _e264 = bitcast<u32>(_e207);
                let _e266 = ((_e264 & 2139095040u) != 0u);
                let _e282 = bitcast<u32>(_e209);
                let _e284 = ((_e282 & 2139095040u) != 0u);
                phi_540_ = type_45(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e230 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e230 & 2147483648u))), _e205, _e232) * _e222) * select(0.00000011920929f, 1f, _e232)) * _e228), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e247 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e247 & 2147483648u))), _e206, _e249) * _e222) * select(0.00000011920929f, 1f, _e249)) * _e228), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e264 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e264 & 2147483648u))), _e207, _e266) * _e222) * select(0.00000011920929f, 1f, _e266)) * _e228)), _e188, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e282 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e282 & 2147483648u))), _e209, _e284) * _e222) * select(0.00000011920929f, 1f, _e284)) * _e228), _e210);
            }
            let _e301 = phi_540_;
            if _e163 {
                let _e302 = (_e148 < arrayLength((&global_2.member)));
                if _e302 {
                    if _e163 {
                    } else {
                        break;
                    }
                    let _e307 = global_10.member[_e148].member.member_1;
                    let _e312 = global_10.member[_e148].member.member_3;
                    if (_e307 <= _e312) {
                        let _e314 = (1u < _e116);
                        if _e314 {
                            if (0u < _e116) {
                            } else {
                                break;
                            }
                            let _e318 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e318 + 1u) < _e318) {
                                if _e314 {
                                } else {
                                    break;
                                }
                                let _e323 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e163 {
                        } else {
                            break;
                        }
                        let _e333 = global_10.member[_e148].member.member_2[0u];
                        let _e335 = (bitcast<u32>(_e333) & 2147483647u);
                        let _e341 = global_10.member[_e148].member.member_2[1u];
                        let _e343 = (bitcast<u32>(_e341) & 2147483647u);
                        let _e349 = global_10.member[_e148].member.member_2[2u];
                        let _e351 = (bitcast<u32>(_e349) & 2147483647u);
                        let _e357 = global_10.member[_e148].member.member[0u];
                        let _e359 = (bitcast<u32>(_e357) & 2147483647u);
                        let _e365 = global_10.member[_e148].member.member[1u];
                        let _e367 = (bitcast<u32>(_e365) & 2147483647u);
                        let _e373 = global_10.member[_e148].member.member[2u];
                        let _e375 = (bitcast<u32>(_e373) & 2147483647u);
                        let _e377 = select(_e343, _e335, (_e343 < _e335));
                        let _e379 = select(_e351, _e377, (_e351 < _e377));
                        let _e381 = select(_e359, _e379, (_e359 < _e379));
                        let _e383 = select(_e367, _e381, (_e367 < _e381));
                        let _e385 = select(_e375, _e383, (_e375 < _e383));
                        let _e386 = bitcast<u32>(_e307);
                        let _e387 = (_e386 & 2147483647u);
                        let _e391 = bitcast<u32>(_e312);
                        let _e392 = (_e391 & 2147483647u);
                        let _e396 = (((select(_e387, _e385, (_e387 < _e385)) < 2139095040u) && (_e392 <= 2139095040u)) && (_e379 > 0u));
                        if _e396 {
                            let _e399 = (bitcast<u32>(bitcast<f32>(_e379)) & 2147483647u);
                            if (_e399 >= 8388608u) {
                                phi_690_ = (bitcast<i32>((_e399 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_690_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e399)), 32u, (_e399 == 0u))));
                            }
                            let _e413 = phi_690_;
                            phi_691_ = _e413;
                        } else {
                            phi_691_ = 0i;
                        }
                        let _e415 = phi_691_;
                        let _e416 = (_e335 == _e379);
                        if _e416 {
                            phi_701_ = true;
                        } else {
                            phi_701_ = (_e343 == _e379);
                        }
                        let _e419 = phi_701_;
                        let _e420 = select(1u, 0u, _e416);
                        if _e419 {
                            let _e421 = (_e420 + 1u);
                            phi_711_ = _e421;
                            phi_712_ = _e421;
                            phi_714_ = select(true, false, (_e421 == 2u));
                        } else {
                            phi_711_ = u32();
                            phi_712_ = 0u;
                            phi_714_ = true;
                        }
                        let _e425 = phi_711_;
                        let _e427 = phi_712_;
                        let _e429 = phi_714_;
                        if _e429 {
                            phi_719_ = (_e427 + 1u);
                        } else {
                            phi_719_ = 0u;
                        }
                        let _e433 = phi_719_;
                        let _e434 = select(_e425, _e427, _e429);
                        let _e435 = select(_e420, select(2u, _e420, _e419), _e429);
                        let _e436 = -(_e415);
                        if (_e436 < -126i) {
                            phi_752_ = -126i;
                        } else {
                            phi_752_ = select(_e436, 127i, (_e436 > 127i));
                        }
                        let _e441 = phi_752_;
                        let _e446 = bitcast<f32>((bitcast<u32>((_e441 + 127i)) << bitcast<u32>(23i)));
                        let _e452 = bitcast<f32>((bitcast<u32>(((_e436 - _e441) + 127i)) << bitcast<u32>(23i)));
                        let _e457 = global_10.member[_e148].member.member;
                        let _e458 = (_e434 == 0u);
                        if _e458 {
                            phi_770_ = _e457[0];
                        } else {
                            phi_770_ = _e457[1];
                        }
                        let _e462 = phi_770_;
                        let _e463 = (_e434 == 2u);
                        if _e463 {
                            phi_776_ = _e457[2];
                        } else {
                            phi_776_ = _e462;
                        }
                        let _e466 = phi_776_;
                        let _e467 = bitcast<u32>(_e466);
                        let _e469 = ((_e467 & 2139095040u) != 0u);
                        let _e481 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e467 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e467 & 2147483648u))), _e466, _e469) * select(0.00000011920929f, 1f, _e469));
                        let _e482 = global_10.member[_e148].member.member_2;
                        if _e458 {
                            phi_816_ = _e482[0];
                        } else {
                            phi_816_ = _e482[1];
                        }
                        let _e486 = phi_816_;
                        if _e463 {
                            phi_822_ = _e482[2];
                        } else {
                            phi_822_ = _e486;
                        }
                        let _e489 = phi_822_;
                        let _e490 = bitcast<u32>(_e489);
                        let _e492 = ((_e490 & 2139095040u) != 0u);
                        let _e506 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e490 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e490 & 2147483648u))), _e489, _e492) * _e446) * select(0.00000011920929f, 1f, _e492)) * _e452);
                        let _e510 = (bitcast<f32>((bitcast<u32>(_e506) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e513 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
                        let _e514 = (_e513 * 0.00000011920929f);
                        let _e517 = select(select(0.00000000000011368684f, _e514, (_e514 > 0.00000000000011368684f)), 0f, _e510);
                        let _e518 = select(0f, _e506, _e510);
                        let _e519 = (_e481 + _e517);
                        let _e520 = (_e481 - _e517);
                        let _e522 = select(38685626000000000000000000f, (1f / _e506), _e510);
                        let _e523 = (_e433 == 0u);
                        if _e523 {
                            phi_895_ = _e457[0];
                        } else {
                            phi_895_ = _e457[1];
                        }
                        let _e527 = phi_895_;
                        let _e528 = (_e433 == 2u);
                        if _e528 {
                            phi_901_ = _e457[2];
                        } else {
                            phi_901_ = _e527;
                        }
                        let _e531 = phi_901_;
                        let _e532 = bitcast<u32>(_e531);
                        let _e534 = ((_e532 & 2139095040u) != 0u);
                        let _e546 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e532 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e532 & 2147483648u))), _e531, _e534) * select(0.00000011920929f, 1f, _e534));
                        if _e523 {
                            phi_941_ = _e482[0];
                        } else {
                            phi_941_ = _e482[1];
                        }
                        let _e550 = phi_941_;
                        if _e528 {
                            phi_947_ = _e482[2];
                        } else {
                            phi_947_ = _e550;
                        }
                        let _e553 = phi_947_;
                        let _e554 = bitcast<u32>(_e553);
                        let _e556 = ((_e554 & 2139095040u) != 0u);
                        let _e570 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e554 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e554 & 2147483648u))), _e553, _e556) * _e446) * select(0.00000011920929f, 1f, _e556)) * _e452);
                        let _e574 = (bitcast<f32>((bitcast<u32>(_e570) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e577 = bitcast<f32>((bitcast<u32>(_e546) & 2147483647u));
                        let _e578 = (_e577 * 0.00000011920929f);
                        let _e581 = select(select(0.00000000000011368684f, _e578, (_e578 > 0.00000000000011368684f)), 0f, _e574);
                        let _e582 = select(0f, _e570, _e574);
                        let _e583 = (_e546 + _e581);
                        let _e584 = (_e546 - _e581);
                        let _e586 = select(38685626000000000000000000f, (1f / _e570), _e574);
                        let _e587 = (_e435 == 0u);
                        if _e587 {
                            phi_1020_ = _e457[0];
                        } else {
                            phi_1020_ = _e457[1];
                        }
                        let _e591 = phi_1020_;
                        let _e592 = (_e435 == 2u);
                        if _e592 {
                            phi_1026_ = _e457[2];
                        } else {
                            phi_1026_ = _e591;
                        }
                        let _e595 = phi_1026_;
                        let _e596 = bitcast<u32>(_e595);
                        let _e598 = ((_e596 & 2139095040u) != 0u);
                        let _e610 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e596 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e596 & 2147483648u))), _e595, _e598) * select(0.00000011920929f, 1f, _e598));
                        if _e587 {
                            phi_1066_ = _e482[0];
                        } else {
                            phi_1066_ = _e482[1];
                        }
                        let _e614 = phi_1066_;
                        if _e592 {
                            phi_1072_ = _e482[2];
                        } else {
                            phi_1072_ = _e614;
                        }
                        let _e617 = phi_1072_;
                        let _e618 = bitcast<u32>(_e617);
                        let _e620 = ((_e618 & 2139095040u) != 0u);
                        let _e634 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e618 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e618 & 2147483648u))), _e617, _e620) * _e446) * select(0.00000011920929f, 1f, _e620)) * _e452);
                        let _e638 = (bitcast<f32>((bitcast<u32>(_e634) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e641 = bitcast<f32>((bitcast<u32>(_e610) & 2147483647u));
                        let _e642 = (_e641 * 0.00000011920929f);
                        let _e645 = select(select(0.00000000000011368684f, _e642, (_e642 > 0.00000000000011368684f)), 0f, _e638);
                        let _e646 = select(0f, _e634, _e638);
                        let _e647 = (_e610 + _e645);
                        let _e648 = (_e610 - _e645);
                        let _e650 = select(38685626000000000000000000f, (1f / _e634), _e638);
                        let _e652 = select(_e577, _e513, (_e513 > _e577));
                        if (_e396 && (select(_e641, _e652, (_e652 > _e641)) <= 1099511600000f)) {
                            let _e664 = ((_e387 & 8388607u) | (select(0u, 1u, ((_e387 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e667 = bitcast<i32>((_e387 >> bitcast<u32>(23i)));
                            let _e671 = (_e664 == 0u);
                            let _e674 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e664)), 32u, _e671)) - 8i);
                            if (_e667 == 255i) {
                                phi_1191_ = 255i;
                            } else {
                                phi_1191_ = (((_e667 + select(0i, 1i, (_e667 == 0i))) - _e674) + _e415);
                            }
                            let _e682 = phi_1191_;
                            let _e692 = (_e682 <= 0i);
                            if _e692 {
                                phi_1214_ = u32();
                            } else {
                                if _e671 {
                                    phi_1213_ = u32();
                                } else {
                                    phi_1213_ = select(((bitcast<u32>(_e682) << bitcast<u32>(23i)) | ((_e664 << bitcast<u32>(((_e674 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e682 >= 255i));
                                }
                                let _e696 = phi_1213_;
                                phi_1214_ = _e696;
                            }
                            let _e698 = phi_1214_;
                            let _e710 = ((_e392 & 8388607u) | (select(0u, 1u, ((_e392 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e713 = bitcast<i32>((_e392 >> bitcast<u32>(23i)));
                            let _e717 = (_e710 == 0u);
                            let _e720 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e710)), 32u, _e717)) - 8i);
                            if (_e713 == 255i) {
                                phi_1251_ = 255i;
                            } else {
                                phi_1251_ = (((_e713 + select(0i, 1i, (_e713 == 0i))) - _e720) + _e415);
                            }
                            let _e728 = phi_1251_;
                            let _e738 = (_e728 <= 0i);
                            if _e738 {
                                phi_1274_ = u32();
                            } else {
                                if _e717 {
                                    phi_1273_ = u32();
                                } else {
                                    phi_1273_ = select(((bitcast<u32>(_e728) << bitcast<u32>(23i)) | ((_e710 << bitcast<u32>(((_e720 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e728 >= 255i));
                                }
                                let _e742 = phi_1273_;
                                phi_1274_ = _e742;
                            }
                            let _e744 = phi_1274_;
                            phi_1282_ = bitcast<f32>(((_e391 & 2147483648u) | select(_e744, 0u, select(_e717, true, _e738))));
                            phi_1283_ = bitcast<f32>(((_e386 & 2147483648u) | select(_e698, 0u, select(_e671, true, _e692))));
                        } else {
                            phi_1282_ = 0f;
                            phi_1283_ = 1f;
                        }
                        let _e750 = phi_1282_;
                        let _e752 = phi_1283_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e756 = (_e434 % 3u);
                        let _e757 = (_e756 < 3u);
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e759 = local_1[_e756];
                        let _e762 = (_e433 % 3u);
                        let _e763 = (_e762 < 3u);
                        if _e763 {
                        } else {
                            break;
                        }
                        let _e765 = local_1[_e762];
                        let _e768 = (_e435 % 3u);
                        let _e769 = (_e768 < 3u);
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e771 = local_1[_e768];
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e776 = local[_e756];
                        if _e763 {
                        } else {
                            break;
                        }
                        let _e780 = local[_e762];
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e784 = local[_e768];
                        phi_4474_ = false;
                        phi_1379_ = type_52(_e750, false);
                        phi_1382_ = ((3u * _e102) + 1u);
                        phi_1384_ = (_e752 <= _e750);
                        phi_1386_ = 0u;
                        phi_1388_ = type_64(type_39(vec4<f32>((f32(_e759) * _e160), (f32(_e765) * _e160), (f32(_e771) * _e160), 0f), vec4<f32>((f32(_e776) * _e160), (f32(_e780) * _e160), (f32(_e784) * _e160), 0f)), select(0u, 2147483648u, (_e102 == 0u)));
                        loop {
                            let _e794 = phi_4474_;
                            let _e796 = phi_1379_;
                            let _e798 = phi_1382_;
                            let _e800 = phi_1384_;
                            let _e802 = phi_1386_;
                            let _e804 = phi_1388_;
                            local_10 = _e796;
                            if _e800 {
                                phi_1399_ = true;
                            } else {
                                phi_1399_ = (_e802 > 0u);
                            }
                            let _e807 = phi_1399_;
                            if _e807 {
                                let _e808 = (_e798 > 0u);
                                if _e808 {
                                    if _e800 {
                                        phi_1485_ = _e800;
                                        phi_1486_ = _e802;
                                        phi_1487_ = _e804;
                                    } else {
                                        let _e809 = (_e802 - 1u);
                                        let _e810 = (_e809 % 128u);
                                        let _e811 = (_e810 < 128u);
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e813 = local_7[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e815 = local_6[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e817 = local_5[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e819 = local_4[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e821 = local_3[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e823 = local_2[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e828 = local_8[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4665_ = true;
                                            break;
                                        }
                                        let _e831 = local_9[_e810];
                                        phi_1485_ = (_e831 <= _e796.member);
                                        phi_1486_ = _e809;
                                        phi_1487_ = type_64(type_39(vec4<f32>(_e813, _e815, _e817, 0f), vec4<f32>(_e819, _e821, _e823, 0f)), _e828);
                                    }
                                    let _e835 = phi_1485_;
                                    let _e837 = phi_1486_;
                                    let _e839 = phi_1487_;
                                    if _e835 {
                                        let _e843 = ((_e839.member_1 & 2147483648u) != 0u);
                                        if _e843 {
                                            phi_1505_ = _e796;
                                            phi_1508_ = type_8(0u, ((_e839.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e850 = phi_1505_;
                                                let _e852 = phi_1508_;
                                                local_11 = _e850;
                                                if (_e852.member < _e852.member_1) {
                                                    phi_1509_ = type_8((_e852.member + 1u), _e852.member_1);
                                                    phi_1531_ = type_8(1u, _e852.member);
                                                } else {
                                                    phi_1509_ = _e852;
                                                    phi_1531_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e865 = phi_1509_;
                                                let _e867 = phi_1531_;
                                                let _e871 = (bitcast<i32>(_e867.member) != 0i);
                                                if _e871 {
                                                    let _e872 = ((_e839.member_1 & 268435455u) + _e867.member_1);
                                                    let _e873 = (_e872 < _e104);
                                                    if _e873 {
                                                        if _e873 {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e877 = global_6.member[_e872].member_1;
                                                        phi_1552_ = _e877;
                                                    } else {
                                                        phi_1552_ = 4294967295u;
                                                    }
                                                    let _e879 = phi_1552_;
                                                    if (_e872 >= _e104) {
                                                        phi_1644_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e873 {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        if (_e756 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e886 = global_6.member[_e872].member[_e756];
                                                        if (_e762 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e892 = global_6.member[_e872].member[_e762];
                                                        if (_e768 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e898 = global_6.member[_e872].member[_e768];
                                                        let _e900 = (3u + _e756);
                                                        if (_e900 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e906 = global_6.member[_e872].member[_e900];
                                                        let _e907 = (3u + _e762);
                                                        if (_e907 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e913 = global_6.member[_e872].member[_e907];
                                                        let _e914 = (3u + _e768);
                                                        if (_e914 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e920 = global_6.member[_e872].member[_e914];
                                                        let _e922 = (6u + _e756);
                                                        if (_e922 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e928 = global_6.member[_e872].member[_e922];
                                                        let _e929 = (6u + _e762);
                                                        if (_e929 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e935 = global_6.member[_e872].member[_e929];
                                                        let _e936 = (6u + _e768);
                                                        if (_e936 < 9u) {
                                                        } else {
                                                            phi_4468_ = true;
                                                            break;
                                                        }
                                                        let _e942 = global_6.member[_e872].member[_e936];
                                                        phi_1644_ = array<array<f32, 3>, 3>(array<f32, 3>(_e886, _e892, _e898), array<f32, 3>(_e906, _e913, _e920), array<f32, 3>(_e928, _e935, _e942));
                                                    }
                                                    let _e946 = phi_1644_;
                                                    let _e962 = (_e946[0][2] - _e610);
                                                    let _e965 = (((_e946[0][0] - _e481) * _e646) - (_e962 * _e518));
                                                    let _e968 = (((_e946[0][1] - _e546) * _e646) - (_e962 * _e582));
                                                    let _e971 = (_e946[1][2] - _e610);
                                                    let _e974 = (((_e946[1][0] - _e481) * _e646) - (_e971 * _e518));
                                                    let _e977 = (((_e946[1][1] - _e546) * _e646) - (_e971 * _e582));
                                                    let _e980 = (_e946[2][2] - _e610);
                                                    let _e983 = (((_e946[2][0] - _e481) * _e646) - (_e980 * _e518));
                                                    let _e986 = (((_e946[2][1] - _e546) * _e646) - (_e980 * _e582));
                                                    let _e987 = (_e983 * _e977);
                                                    let _e988 = (_e986 * _e974);
                                                    let _e989 = (_e965 * _e986);
                                                    let _e990 = (_e968 * _e983);
                                                    let _e991 = (_e974 * _e968);
                                                    let _e992 = (_e977 * _e965);
                                                    let _e997 = (((_e987 >= _e988) && (_e989 >= _e990)) && (_e991 >= _e992));
                                                    let _e1003 = (_e997 || (((_e987 <= _e988) && (_e989 <= _e990)) && (_e991 <= _e992)));
                                                    if _e1003 {
                                                        let _e1005 = select(-1f, 1f, _e997);
                                                        let _e1007 = ((_e987 - _e988) * _e1005);
                                                        let _e1009 = select(0f, _e1007, (_e1007 > 0f));
                                                        let _e1011 = ((_e989 - _e990) * _e1005);
                                                        let _e1013 = select(0f, _e1011, (_e1011 > 0f));
                                                        let _e1015 = ((_e991 - _e992) * _e1005);
                                                        let _e1017 = select(0f, _e1015, (_e1015 > 0f));
                                                        let _e1019 = ((_e1009 + _e1013) + _e1017);
                                                        let _e1021 = select(_e946[1][0], _e946[0][0], (_e946[0][0] < _e946[1][0]));
                                                        let _e1025 = select(_e946[1][0], _e946[0][0], (_e946[0][0] > _e946[1][0]));
                                                        let _e1029 = select(_e946[1][1], _e946[0][1], (_e946[0][1] < _e946[1][1]));
                                                        let _e1033 = select(_e946[1][1], _e946[0][1], (_e946[0][1] > _e946[1][1]));
                                                        let _e1037 = select(_e946[1][2], _e946[0][2], (_e946[0][2] < _e946[1][2]));
                                                        let _e1041 = select(_e946[1][2], _e946[0][2], (_e946[0][2] > _e946[1][2]));
                                                        let _e1046 = ((select(_e946[2][0], _e1021, (_e1021 < _e946[2][0])) - _e519) * _e522);
                                                        let _e1047 = ((select(_e946[2][0], _e1025, (_e1025 > _e946[2][0])) - _e520) * _e522);
                                                        let _e1050 = ((select(_e946[2][1], _e1029, (_e1029 < _e946[2][1])) - _e583) * _e586);
                                                        let _e1051 = ((select(_e946[2][1], _e1033, (_e1033 > _e946[2][1])) - _e584) * _e586);
                                                        let _e1054 = ((select(_e946[2][2], _e1037, (_e1037 < _e946[2][2])) - _e647) * _e650);
                                                        let _e1055 = ((select(_e946[2][2], _e1041, (_e1041 > _e946[2][2])) - _e648) * _e650);
                                                        let _e1057 = select(_e1055, _e1054, (_e1054 < _e1055));
                                                        let _e1059 = select(_e1055, _e1054, (_e1054 > _e1055));
                                                        let _e1061 = select(_e1047, _e1046, (_e1046 < _e1047));
                                                        let _e1063 = select(_e1051, _e1050, (_e1050 < _e1051));
                                                        let _e1065 = select(_e1063, _e1061, (_e1061 > _e1063));
                                                        let _e1067 = select(_e1057, _e1065, (_e1065 > _e1057));
                                                        let _e1069 = select(_e1047, _e1046, (_e1046 > _e1047));
                                                        let _e1071 = select(_e1051, _e1050, (_e1050 > _e1051));
                                                        let _e1073 = select(_e1071, _e1069, (_e1069 < _e1071));
                                                        let _e1075 = select(_e1059, _e1073, (_e1073 < _e1059));
                                                        let _e1076 = -(_e1057);
                                                        let _e1082 = select(_e752, _e1067, (_e1067 > _e752));
                                                        let _e1086 = select(_e974, _e965, (_e965 < _e974));
                                                        let _e1091 = select(_e974, _e965, (_e965 > _e974));
                                                        let _e1098 = select(_e977, _e968, (_e968 < _e977));
                                                        let _e1103 = select(_e977, _e968, (_e968 > _e977));
                                                        let _e1112 = (((((_e1003 && (_e1019 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e983, _e1086, (_e1086 < _e983)) <= 0f) && (select(_e983, _e1091, (_e1091 > _e983)) >= 0f))) && ((select(_e986, _e1098, (_e1098 < _e986)) <= 0f) && (select(_e986, _e1103, (_e1103 > _e986)) >= 0f))) && (_e1082 <= (_e1075 + (select(_e1076, _e1059, (_e1059 > _e1076)) * 0.0000019073523f)))) && (_e1082 <= _e850.member));
                                                        if _e1112 {
                                                            let _e1117 = (_e946[1][0] - _e946[0][0]);
                                                            let _e1118 = (_e946[1][1] - _e946[0][1]);
                                                            let _e1119 = (_e946[1][2] - _e946[0][2]);
                                                            let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                                            let _e1121 = (_e946[2][0] - _e946[1][0]);
                                                            let _e1122 = (_e946[2][1] - _e946[1][1]);
                                                            let _e1123 = (_e946[2][2] - _e946[1][2]);
                                                            let _e1124 = vec3<f32>(_e1121, _e1122, _e1123);
                                                            let _e1125 = (_e946[0][0] - _e946[2][0]);
                                                            let _e1126 = (_e946[0][1] - _e946[2][1]);
                                                            let _e1127 = (_e946[0][2] - _e946[2][2]);
                                                            let _e1128 = vec3<f32>(_e1125, _e1126, _e1127);
                                                            let _e1129 = abs(_e1117);
                                                            let _e1130 = abs(_e1118);
                                                            if (_e1129 != _e1129) {
                                                                phi_4109_ = true;
                                                            } else {
                                                                phi_4109_ = (_e1130 >= _e1129);
                                                            }
                                                            let _e1134 = phi_4109_;
                                                            let _e1135 = select(_e1129, _e1130, _e1134);
                                                            let _e1136 = abs(_e1119);
                                                            if (_e1135 != _e1135) {
                                                                phi_4124_ = true;
                                                            } else {
                                                                phi_4124_ = (_e1136 >= _e1135);
                                                            }
                                                            let _e1140 = phi_4124_;
                                                            let _e1141 = select(_e1135, _e1136, _e1140);
                                                            let _e1142 = abs(_e1121);
                                                            let _e1143 = abs(_e1122);
                                                            if (_e1142 != _e1142) {
                                                                phi_4139_ = true;
                                                            } else {
                                                                phi_4139_ = (_e1143 >= _e1142);
                                                            }
                                                            let _e1147 = phi_4139_;
                                                            let _e1148 = select(_e1142, _e1143, _e1147);
                                                            let _e1149 = abs(_e1123);
                                                            if (_e1148 != _e1148) {
                                                                phi_4154_ = true;
                                                            } else {
                                                                phi_4154_ = (_e1149 >= _e1148);
                                                            }
                                                            let _e1153 = phi_4154_;
                                                            let _e1154 = select(_e1148, _e1149, _e1153);
                                                            let _e1155 = abs(_e1125);
                                                            let _e1156 = abs(_e1126);
                                                            if (_e1155 != _e1155) {
                                                                phi_4169_ = true;
                                                            } else {
                                                                phi_4169_ = (_e1156 >= _e1155);
                                                            }
                                                            let _e1160 = phi_4169_;
                                                            let _e1161 = select(_e1155, _e1156, _e1160);
                                                            let _e1162 = abs(_e1127);
                                                            if (_e1161 != _e1161) {
                                                                phi_4184_ = true;
                                                            } else {
                                                                phi_4184_ = (_e1162 >= _e1161);
                                                            }
                                                            let _e1166 = phi_4184_;
                                                            let _e1167 = select(_e1161, _e1162, _e1166);
                                                            let _e1169 = select(_e1154, _e1141, (_e1141 > _e1154));
                                                            let _e1171 = select(_e1167, _e1169, (_e1169 > _e1167));
                                                            if (_e1141 == _e1171) {
                                                                phi_2186_ = _e977;
                                                                phi_2187_ = _e974;
                                                                phi_2188_ = _e968;
                                                                phi_2189_ = _e965;
                                                                phi_2190_ = vec3<f32>(_e946[0][0], _e946[0][1], _e946[0][2]);
                                                                phi_2191_ = _e1128;
                                                                phi_2192_ = _e1124;
                                                                phi_2193_ = _e1120;
                                                            } else {
                                                                let _e1173 = (_e1154 == _e1171);
                                                                let _e1178 = vec3(_e1173);
                                                                phi_2186_ = select(_e968, _e986, _e1173);
                                                                phi_2187_ = select(_e965, _e983, _e1173);
                                                                phi_2188_ = select(_e986, _e977, _e1173);
                                                                phi_2189_ = select(_e983, _e974, _e1173);
                                                                phi_2190_ = select(vec3<f32>(_e946[2][0], _e946[2][1], _e946[2][2]), vec3<f32>(_e946[1][0], _e946[1][1], _e946[1][2]), _e1178);
                                                                phi_2191_ = select(_e1124, _e1120, _e1178);
                                                                phi_2192_ = select(_e1120, _e1128, _e1178);
                                                                phi_2193_ = select(_e1128, _e1124, _e1178);
                                                            }
                                                            let _e1184 = phi_2186_;
                                                            let _e1186 = phi_2187_;
                                                            let _e1188 = phi_2188_;
                                                            let _e1190 = phi_2189_;
                                                            let _e1192 = phi_2190_;
                                                            let _e1194 = phi_2191_;
                                                            let _e1196 = phi_2192_;
                                                            let _e1198 = phi_2193_;
                                                            let _e1205 = ((_e1196.y * _e1194.z) - (_e1194.y * _e1196.z));
                                                            let _e1210 = ((_e1196.z * _e1194.x) - (_e1194.z * _e1196.x));
                                                            let _e1213 = ((_e1196.x * _e1194.y) - (_e1194.x * _e1196.y));
                                                            let _e1216 = ((_e1009 >= _e1013) && (_e1009 >= _e1017));
                                                            let _e1217 = (_e1013 >= _e1017);
                                                            let _e1231 = (((_e1205 * (select(select(_e946[2][0], _e946[1][0], _e1217), _e946[0][0], _e1216) - _e481)) + (_e1210 * (select(select(_e946[2][1], _e946[1][1], _e1217), _e946[0][1], _e1216) - _e546))) + (_e1213 * (select(select(_e946[2][2], _e946[1][2], _e1217), _e946[0][2], _e1216) - _e610)));
                                                            let _e1236 = (((_e1205 * _e518) + (_e1210 * _e582)) + (_e1213 * _e646));
                                                            let _e1237 = (_e1186 - _e1190);
                                                            let _e1238 = (_e1184 - _e1188);
                                                            let _e1241 = ((_e1237 * _e1237) + (_e1238 * _e1238));
                                                            let _e1248 = (-(((_e1190 * _e1237) + (_e1188 * _e1238))) / select(0.000000000000000000000000000000000000011754944f, _e1241, (_e1241 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1250 = select(1f, _e1248, (_e1248 < 1f));
                                                            let _e1252 = select(0f, _e1250, (_e1250 > 0f));
                                                            let _e1261 = ((_e1192.x + (_e1198.x * _e1252)) - _e481);
                                                            let _e1264 = ((_e1192.y + (_e1198.y * _e1252)) - _e546);
                                                            let _e1267 = ((_e1192.z + (_e1198.z * _e1252)) - _e610);
                                                            let _e1270 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                            let _e1273 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                            let _e1275 = select(_e1273, _e1270, (_e1270 > _e1273));
                                                            let _e1278 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                            let _e1280 = select(_e1278, _e1275, (_e1275 > _e1278));
                                                            let _e1284 = abs(_e1205);
                                                            let _e1285 = abs(_e1210);
                                                            if (_e1284 != _e1284) {
                                                                phi_4199_ = true;
                                                            } else {
                                                                phi_4199_ = (_e1285 >= _e1284);
                                                            }
                                                            let _e1289 = phi_4199_;
                                                            let _e1290 = select(_e1284, _e1285, _e1289);
                                                            let _e1291 = abs(_e1213);
                                                            if (_e1290 != _e1290) {
                                                                phi_4214_ = true;
                                                            } else {
                                                                phi_4214_ = (_e1291 >= _e1290);
                                                            }
                                                            let _e1295 = phi_4214_;
                                                            let _e1311 = abs(_e1196.x);
                                                            let _e1312 = abs(_e1196.y);
                                                            if (_e1311 != _e1311) {
                                                                phi_4229_ = true;
                                                            } else {
                                                                phi_4229_ = (_e1312 >= _e1311);
                                                            }
                                                            let _e1316 = phi_4229_;
                                                            let _e1317 = select(_e1311, _e1312, _e1316);
                                                            let _e1318 = abs(_e1196.z);
                                                            if (_e1317 != _e1317) {
                                                                phi_4244_ = true;
                                                            } else {
                                                                phi_4244_ = (_e1318 >= _e1317);
                                                            }
                                                            let _e1322 = phi_4244_;
                                                            let _e1325 = abs(_e1194.x);
                                                            let _e1326 = abs(_e1194.y);
                                                            if (_e1325 != _e1325) {
                                                                phi_4259_ = true;
                                                            } else {
                                                                phi_4259_ = (_e1326 >= _e1325);
                                                            }
                                                            let _e1330 = phi_4259_;
                                                            let _e1331 = select(_e1325, _e1326, _e1330);
                                                            let _e1332 = abs(_e1194.z);
                                                            if (_e1331 != _e1331) {
                                                                phi_4274_ = true;
                                                            } else {
                                                                phi_4274_ = (_e1332 >= _e1331);
                                                            }
                                                            let _e1336 = phi_4274_;
                                                            let _e1341 = ((bitcast<f32>((bitcast<u32>(((((_e1205 * _e1261) + (_e1210 * _e1264)) + (_e1213 * _e1267)) - _e1231)) & 2147483647u)) <= ((0.0000009536743f * select(_e1171, _e1280, (_e1280 > _e1171))) * select(_e1290, _e1291, _e1295))) && !((bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u)) <= ((0.0000038146973f * select(_e1317, _e1318, _e1322)) * select(_e1331, _e1332, _e1336)))));
                                                            let _e1342 = (_e1231 / _e1236);
                                                            if (_e1112 && !(_e1341)) {
                                                                let _e1345 = (_e1267 / _e646);
                                                                let _e1353 = (((_e1205 * (_e1261 - (_e518 * _e1345))) + (_e1210 * (_e1264 - (_e582 * _e1345)))) / _e1236);
                                                                phi_2401_ = select(select(_e1345, (_e1345 + _e1353), (bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u)) <= _e1171)), _e1342, _e1341);
                                                            } else {
                                                                phi_2401_ = _e1342;
                                                            }
                                                            let _e1362 = phi_2401_;
                                                            let _e1364 = select(_e1075, _e1362, (_e1362 < _e1075));
                                                            let _e1366 = select(_e1067, _e1364, (_e1364 > _e1067));
                                                            let _e1367 = (1f / _e1019);
                                                            phi_2421_ = type_51(_e1366, (_e1013 * _e1367), (_e1017 * _e1367), ((_e1112 && (_e1366 >= _e752)) && (_e1366 <= _e850.member)));
                                                            phi_2422_ = type_51();
                                                        } else {
                                                            phi_2421_ = type_51();
                                                            phi_2422_ = type_51(0f, 0f, 0f, _e1112);
                                                        }
                                                        let _e1376 = phi_2421_;
                                                        let _e1378 = phi_2422_;
                                                        phi_2425_ = _e1376;
                                                        phi_2426_ = _e1378;
                                                        phi_2427_ = select(true, false, _e1112);
                                                    } else {
                                                        phi_2425_ = type_51();
                                                        phi_2426_ = type_51(0f, 0f, 0f, _e1003);
                                                        phi_2427_ = true;
                                                    }
                                                    let _e1381 = phi_2425_;
                                                    let _e1383 = phi_2426_;
                                                    let _e1385 = phi_2427_;
                                                    if _e1385 {
                                                        phi_2431_ = _e1383;
                                                    } else {
                                                        phi_2431_ = _e1381;
                                                    }
                                                    let _e1387 = phi_2431_;
                                                    if _e1387.member_3 {
                                                        phi_2440_ = type_30(_e1387.member, _e1387.member_1, _e1387.member_2, _e879);
                                                    } else {
                                                        phi_2440_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1394 = phi_2440_;
                                                    if (_e1394.member_3 != 4294967295u) {
                                                        if (_e879 == _e169) {
                                                            phi_2775_ = false;
                                                        } else {
                                                            let _e1398 = (_e879 < arrayLength((&global_7.member)));
                                                            if _e1398 {
                                                                if _e1398 {
                                                                } else {
                                                                    phi_4468_ = true;
                                                                    break;
                                                                }
                                                                let _e1400 = global_7.member[_e879];
                                                                phi_2463_ = _e1400;
                                                            } else {
                                                                phi_2463_ = 4294967295u;
                                                            }
                                                            let _e1402 = phi_2463_;
                                                            let _e1403 = (_e1402 < arrayLength((&global_8.member)));
                                                            if _e1403 {
                                                                if _e1403 {
                                                                } else {
                                                                    phi_4468_ = true;
                                                                    break;
                                                                }
                                                                let _e1405 = global_8.member[_e1402];
                                                                phi_2477_ = _e1405;
                                                            } else {
                                                                phi_2477_ = 0i;
                                                            }
                                                            let _e1407 = phi_2477_;
                                                            let _e1408 = (_e1407 == 0i);
                                                            if _e1408 {
                                                                phi_2774_ = true;
                                                            } else {
                                                                if _e458 {
                                                                    phi_2500_ = vec3<f32>(_e946[0][0], _e946[0][1], _e946[0][2]);
                                                                } else {
                                                                    if (_e434 == 1u) {
                                                                        phi_2499_ = vec3<f32>(_e946[0][2], _e946[0][0], _e946[0][1]);
                                                                    } else {
                                                                        phi_2499_ = vec3<f32>(_e946[0][1], _e946[0][2], _e946[0][0]);
                                                                    }
                                                                    let _e1413 = phi_2499_;
                                                                    phi_2500_ = _e1413;
                                                                }
                                                                let _e1416 = phi_2500_;
                                                                if _e458 {
                                                                    phi_2519_ = vec3<f32>(_e946[1][0], _e946[1][1], _e946[1][2]);
                                                                } else {
                                                                    if (_e434 == 1u) {
                                                                        phi_2518_ = vec3<f32>(_e946[1][2], _e946[1][0], _e946[1][1]);
                                                                    } else {
                                                                        phi_2518_ = vec3<f32>(_e946[1][1], _e946[1][2], _e946[1][0]);
                                                                    }
                                                                    let _e1421 = phi_2518_;
                                                                    phi_2519_ = _e1421;
                                                                }
                                                                let _e1424 = phi_2519_;
                                                                if _e458 {
                                                                    phi_2538_ = vec3<f32>(_e946[2][0], _e946[2][1], _e946[2][2]);
                                                                } else {
                                                                    if (_e434 == 1u) {
                                                                        phi_2537_ = vec3<f32>(_e946[2][2], _e946[2][0], _e946[2][1]);
                                                                    } else {
                                                                        phi_2537_ = vec3<f32>(_e946[2][1], _e946[2][2], _e946[2][0]);
                                                                    }
                                                                    let _e1429 = phi_2537_;
                                                                    phi_2538_ = _e1429;
                                                                }
                                                                let _e1432 = phi_2538_;
                                                                let _e1435 = (_e1424.x - _e1416.x);
                                                                let _e1438 = (_e1424.y - _e1416.y);
                                                                let _e1441 = (_e1424.z - _e1416.z);
                                                                let _e1443 = (_e1432.x - _e1416.x);
                                                                let _e1445 = (_e1432.y - _e1416.y);
                                                                let _e1447 = (_e1432.z - _e1416.z);
                                                                if (_e301.member_1 == 1u) {
                                                                    phi_2574_ = (vec3<f32>(_e301.member[0], _e301.member[1], _e301.member[2]) - _e1416);
                                                                } else {
                                                                    phi_2574_ = vec3<f32>(_e301.member[0], _e301.member[1], _e301.member[2]);
                                                                }
                                                                let _e1462 = phi_2574_;
                                                                let _e1468 = bitcast<f32>((bitcast<u32>((_e1435 * _e1445)) ^ _e301.member_3[0]));
                                                                let _e1472 = bitcast<f32>((bitcast<u32>((_e1438 * _e1443)) ^ _e301.member_3[0]));
                                                                let _e1476 = bitcast<f32>((bitcast<u32>((_e1438 * _e1447)) ^ _e301.member_3[0]));
                                                                let _e1480 = bitcast<f32>((bitcast<u32>((_e1441 * _e1445)) ^ _e301.member_3[0]));
                                                                let _e1484 = bitcast<f32>((bitcast<u32>((_e1441 * _e1443)) ^ _e301.member_3[0]));
                                                                let _e1488 = bitcast<f32>((bitcast<u32>((_e1435 * _e1447)) ^ _e301.member_3[0]));
                                                                let _e1489 = (_e1476 - _e1480);
                                                                let _e1490 = (_e1484 - _e1488);
                                                                let _e1491 = (_e1468 - _e1472);
                                                                let _e1515 = (bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u)));
                                                                let _e1522 = (bitcast<f32>((bitcast<u32>(_e1484) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u)));
                                                                let _e1529 = (bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u)));
                                                                if (_e301.member_2 == 0f) {
                                                                    phi_2756_ = 0f;
                                                                } else {
                                                                    let _e1559 = bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u));
                                                                    let _e1562 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                    let _e1565 = bitcast<f32>((bitcast<u32>(_e1491) & 2147483647u));
                                                                    let _e1567 = select(_e1565, _e1562, (_e1562 > _e1565));
                                                                    let _e1571 = select(_e1565, _e1562, (_e1562 < _e1565));
                                                                    let _e1575 = select(_e1562, _e1559, (_e1559 < _e1562));
                                                                    let _e1577 = select(_e1562, _e1559, (_e1559 > _e1562));
                                                                    let _e1579 = select(_e1565, _e1577, (_e1577 < _e1565));
                                                                    phi_2756_ = bitcast<f32>((bitcast<u32>((_e301.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1567, _e1559, (_e1559 > _e1567)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1579, _e1575, (_e1575 > _e1579)))) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1571, _e1559, (_e1559 < _e1571)))) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1515 + _e1522) + _e1529))) ^ _e301.member_3[0]))) * 1.0000005f)) ^ _e301.member_3[0])))) ^ _e301.member_3[0]));
                                                                }
                                                                let _e1606 = phi_2756_;
                                                                phi_2774_ = (_e1408 || !(((((bitcast<f32>((bitcast<u32>((_e1462.x * _e1489)) ^ _e301.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1462.y * _e1490)) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1462.z * _e1491)) ^ _e301.member_3[0]))) * f32(-(_e1407))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1462.x) & 2147483647u)) * _e1515)) ^ _e301.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1462.y) & 2147483647u)) * _e1522)) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1462.z) & 2147483647u)) * _e1529)) ^ _e301.member_3[0]))))) ^ _e301.member_3[0])) + _e1606) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1620 = phi_2774_;
                                                            phi_2775_ = _e1620;
                                                        }
                                                        let _e1622 = phi_2775_;
                                                        if _e1622 {
                                                            phi_2780_ = type_52(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2780_ = _e850;
                                                        }
                                                        let _e1624 = phi_2780_;
                                                        phi_2781_ = _e1624;
                                                    } else {
                                                        phi_2781_ = _e850;
                                                    }
                                                    let _e1626 = phi_2781_;
                                                    phi_1506_ = _e1626;
                                                } else {
                                                    phi_1506_ = type_52();
                                                }
                                                let _e1628 = phi_1506_;
                                                continue;
                                                continuing {
                                                    phi_1505_ = _e1628;
                                                    phi_1508_ = _e865;
                                                    phi_4468_ = _e794;
                                                    break if !(_e871);
                                                }
                                            }
                                            let _e1631 = phi_4468_;
                                            phi_4665_ = _e1631;
                                            if _e1631 {
                                                break;
                                            }
                                            phi_4751_ = _e1631;
                                            let _e2254 = local_11;
                                            phi_2782_ = _e2254;
                                        } else {
                                            phi_4751_ = _e794;
                                            phi_2782_ = _e796;
                                        }
                                        let _e1633 = phi_4751_;
                                        let _e1635 = phi_2782_;
                                        if _e843 {
                                            phi_4012_ = bool();
                                            phi_4013_ = u32();
                                            phi_4014_ = type_64();
                                        } else {
                                            if (_e839.member_1 >= _e102) {
                                                phi_3548_ = type_65(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_64(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_64(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e839.member_1 < _e102) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1639 = ((1u + _e434) % 4u);
                                                if (_e1639 < 4u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1644 = global_5.member[_e839.member_1][_e1639];
                                                let _e1646 = (_e1644 >> bitcast<u32>(11u));
                                                let _e1648 = ((1u + _e433) % 4u);
                                                if (_e1648 < 4u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1653 = global_5.member[_e839.member_1][_e1648];
                                                let _e1655 = (_e1653 >> bitcast<u32>(11u));
                                                let _e1657 = ((1u + _e435) % 4u);
                                                if (_e1657 < 4u) {
                                                } else {
                                                    phi_4665_ = true;
                                                    break;
                                                }
                                                let _e1662 = global_5.member[_e839.member_1][_e1657];
                                                let _e1664 = (_e1662 >> bitcast<u32>(11u));
                                                let _e1687 = (bitcast<f32>((bitcast<u32>((_e839.member.member_1.x - _e839.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e1688 = (bitcast<f32>((bitcast<u32>((_e839.member.member_1.y - _e839.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e1689 = (bitcast<f32>((bitcast<u32>((_e839.member.member_1.z - _e839.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e1691 = select(_e160, _e1687, (_e1687 > _e160));
                                                let _e1693 = select(_e160, _e1688, (_e1688 > _e160));
                                                let _e1695 = select(_e160, _e1689, (_e1689 > _e160));
                                                let _e1726 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1644 & 1023u))) - 8388608f) * _e1691));
                                                let _e1731 = (bitcast<i32>((_e1644 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1734 = bitcast<f32>((_e1726 & bitcast<u32>(_e1731)));
                                                let _e1735 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1653 & 1023u))) - 8388608f) * _e1693));
                                                let _e1740 = (bitcast<i32>((_e1653 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1743 = bitcast<f32>((_e1735 & bitcast<u32>(_e1740)));
                                                let _e1744 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1662 & 1023u))) - 8388608f) * _e1695));
                                                let _e1749 = (bitcast<i32>((_e1662 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1752 = bitcast<f32>((_e1744 & bitcast<u32>(_e1749)));
                                                let _e1756 = bitcast<f32>((_e1726 & bitcast<u32>(~(_e1731))));
                                                let _e1760 = bitcast<f32>((_e1735 & bitcast<u32>(~(_e1740))));
                                                let _e1764 = bitcast<f32>((_e1744 & bitcast<u32>(~(_e1749))));
                                                let _e1765 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1646 & 1023u))) - 8388608f) * _e1691));
                                                let _e1770 = (bitcast<i32>((_e1646 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1773 = bitcast<f32>((_e1765 & bitcast<u32>(_e1770)));
                                                let _e1774 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1655 & 1023u))) - 8388608f) * _e1693));
                                                let _e1779 = (bitcast<i32>((_e1655 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1782 = bitcast<f32>((_e1774 & bitcast<u32>(_e1779)));
                                                let _e1783 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1664 & 1023u))) - 8388608f) * _e1695));
                                                let _e1788 = (bitcast<i32>((_e1664 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1791 = bitcast<f32>((_e1783 & bitcast<u32>(_e1788)));
                                                let _e1795 = bitcast<f32>((_e1765 & bitcast<u32>(~(_e1770))));
                                                let _e1799 = bitcast<f32>((_e1774 & bitcast<u32>(~(_e1779))));
                                                let _e1803 = bitcast<f32>((_e1783 & bitcast<u32>(~(_e1788))));
                                                let _e1833 = global_5.member[_e839.member_1][0u];
                                                let _e1837 = global_5.member[_e839.member_1][1u];
                                                let _e1841 = global_5.member[_e839.member_1][2u];
                                                let _e1845 = global_5.member[_e839.member_1][3u];
                                                let _e1857 = (((_e1837 >> bitcast<u32>(22i)) | ((_e1841 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1845 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1858 = (_e1833 & 268435455u);
                                                let _e1859 = (_e1857 & 268435455u);
                                                let _e1862 = ((_e1833 >> bitcast<u32>(28u)) & 7u);
                                                let _e1870 = ((_e1833 >> bitcast<u32>(31i)) | (((_e1857 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1871 = (_e1862 != 0u);
                                                if (_e1862 == 0u) {
                                                    phi_3510_ = _e1858;
                                                } else {
                                                    if (_e1862 == 7u) {
                                                        phi_3509_ = 2147483648u;
                                                    } else {
                                                        phi_3509_ = ((2147483648u | (_e1862 << bitcast<u32>(28u))) | (_e1859 & 268435455u));
                                                    }
                                                    let _e1880 = phi_3509_;
                                                    phi_3510_ = _e1880;
                                                }
                                                let _e1882 = phi_3510_;
                                                if _e1871 {
                                                    let _e1883 = (_e1862 != 7u);
                                                    if _e1883 {
                                                        phi_3520_ = (_e1859 + _e1862);
                                                    } else {
                                                        phi_3520_ = u32();
                                                    }
                                                    let _e1886 = phi_3520_;
                                                    phi_3522_ = _e1886;
                                                    phi_3523_ = select(true, false, _e1883);
                                                } else {
                                                    phi_3522_ = u32();
                                                    phi_3523_ = true;
                                                }
                                                let _e1889 = phi_3522_;
                                                let _e1891 = phi_3523_;
                                                if (_e1870 == 0u) {
                                                    phi_3544_ = (_e1858 + select(0u, 1u, !(_e1871)));
                                                } else {
                                                    if (_e1870 == 7u) {
                                                        phi_3543_ = 2147483648u;
                                                    } else {
                                                        phi_3543_ = ((2147483648u | (_e1870 << bitcast<u32>(28u))) | (select(_e1889, _e1859, _e1891) & 268435455u));
                                                    }
                                                    let _e1904 = phi_3543_;
                                                    phi_3544_ = _e1904;
                                                }
                                                let _e1906 = phi_3544_;
                                                phi_3548_ = type_65(array<vec4<f32>, 3>(vec4<f32>((_e839.member.member.x + _e1734), (_e839.member.member.x + _e1756), (_e839.member.member_1.x - _e1773), (_e839.member.member_1.x - _e1795)), vec4<f32>((_e839.member.member.y + _e1743), (_e839.member.member.y + _e1760), (_e839.member.member_1.y - _e1782), (_e839.member.member_1.y - _e1799)), vec4<f32>((_e839.member.member.z + _e1752), (_e839.member.member.z + _e1764), (_e839.member.member_1.z - _e1791), (_e839.member.member_1.z - _e1803))), type_64(type_39((_e839.member.member + vec4<f32>(_e1734, _e1743, _e1752, 0f)), (_e839.member.member_1 - vec4<f32>(_e1773, _e1782, _e1791, 0f))), _e1882), type_64(type_39((_e839.member.member + vec4<f32>(_e1756, _e1760, _e1764, 0f)), (_e839.member.member_1 - vec4<f32>(_e1795, _e1799, _e1803, 0f))), _e1906));
                                            }
                                            let _e1911 = phi_3548_;
                                            let _e1923 = ((_e1911.member[0].x - _e519) * _e522);
                                            let _e1924 = ((_e1911.member[0].y - _e519) * _e522);
                                            let _e1925 = ((_e1911.member[0].z - _e520) * _e522);
                                            let _e1926 = ((_e1911.member[0].w - _e520) * _e522);
                                            let _e1936 = ((_e1911.member[1].x - _e583) * _e586);
                                            let _e1937 = ((_e1911.member[1].y - _e583) * _e586);
                                            let _e1938 = ((_e1911.member[1].z - _e584) * _e586);
                                            let _e1939 = ((_e1911.member[1].w - _e584) * _e586);
                                            let _e1949 = ((_e1911.member[2].x - _e647) * _e650);
                                            let _e1950 = ((_e1911.member[2].y - _e647) * _e650);
                                            let _e1951 = ((_e1911.member[2].z - _e648) * _e650);
                                            let _e1952 = ((_e1911.member[2].w - _e648) * _e650);
                                            let _e1954 = select(_e1951, _e1949, (_e1949 < _e1951));
                                            let _e1956 = select(_e1952, _e1950, (_e1950 < _e1952));
                                            let _e1958 = select(_e1951, _e1949, (_e1949 > _e1951));
                                            let _e1960 = select(_e1952, _e1950, (_e1950 > _e1952));
                                            let _e1962 = select(_e1925, _e1923, (_e1923 < _e1925));
                                            let _e1964 = select(_e1926, _e1924, (_e1924 < _e1926));
                                            let _e1966 = select(_e1938, _e1936, (_e1936 < _e1938));
                                            let _e1968 = select(_e1939, _e1937, (_e1937 < _e1939));
                                            let _e1970 = select(_e1966, _e1962, (_e1962 > _e1966));
                                            let _e1972 = select(_e1968, _e1964, (_e1964 > _e1968));
                                            let _e1974 = select(_e1954, _e1970, (_e1970 > _e1954));
                                            let _e1976 = select(_e1956, _e1972, (_e1972 > _e1956));
                                            let _e1978 = select(_e1925, _e1923, (_e1923 > _e1925));
                                            let _e1980 = select(_e1926, _e1924, (_e1924 > _e1926));
                                            let _e1982 = select(_e1938, _e1936, (_e1936 > _e1938));
                                            let _e1984 = select(_e1939, _e1937, (_e1937 > _e1939));
                                            let _e1986 = select(_e1982, _e1978, (_e1978 < _e1982));
                                            let _e1988 = select(_e1984, _e1980, (_e1980 < _e1984));
                                            let _e1993 = -(_e1954);
                                            let _e1994 = -(_e1956);
                                            let _e2001 = (select(_e1958, _e1986, (_e1986 < _e1958)) + (select(_e1993, _e1958, (_e1958 > _e1993)) * 0.0000019073523f));
                                            let _e2002 = (select(_e1960, _e1988, (_e1988 < _e1960)) + (select(_e1994, _e1960, (_e1960 > _e1994)) * 0.0000019073523f));
                                            let _e2004 = select(_e752, _e1974, (_e1974 > _e752));
                                            let _e2006 = select(_e752, _e1976, (_e1976 > _e752));
                                            let _e2011 = (_e2004 <= select(_e1635.member, _e2001, (_e2001 < _e1635.member)));
                                            let _e2012 = (_e2006 <= select(_e1635.member, _e2002, (_e2002 < _e1635.member)));
                                            let _e2013 = (_e2004 <= _e2006);
                                            if _e2011 {
                                                if _e2012 {
                                                    if _e2013 {
                                                        phi_3910_ = _e1911.member_2;
                                                    } else {
                                                        phi_3910_ = _e1911.member_1;
                                                    }
                                                    let _e2017 = phi_3910_;
                                                    let _e2038 = (_e837 % 128u);
                                                    let _e2039 = (_e2038 < 128u);
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2038] = _e2017.member_1;
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2038] = _e2017.member.member.x;
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2038] = _e2017.member.member.y;
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2038] = _e2017.member.member.z;
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2038] = _e2017.member.member_1.x;
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2038] = _e2017.member.member_1.y;
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2038] = _e2017.member.member_1.z;
                                                    if _e2039 {
                                                    } else {
                                                        phi_4665_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2038] = select(_e2004, _e2006, _e2013);
                                                    if _e2013 {
                                                        phi_3986_ = _e1911.member_1;
                                                    } else {
                                                        phi_3986_ = _e1911.member_2;
                                                    }
                                                    let _e2052 = phi_3986_;
                                                    phi_3987_ = (_e837 + 1u);
                                                    phi_3988_ = _e2052;
                                                } else {
                                                    phi_3987_ = u32();
                                                    phi_3988_ = type_64();
                                                }
                                                let _e2054 = phi_3987_;
                                                let _e2056 = phi_3988_;
                                                phi_3990_ = _e2054;
                                                phi_3991_ = _e2056;
                                                phi_3992_ = select(true, false, _e2012);
                                            } else {
                                                phi_3990_ = u32();
                                                phi_3991_ = type_64();
                                                phi_3992_ = true;
                                            }
                                            let _e2059 = phi_3990_;
                                            let _e2061 = phi_3991_;
                                            let _e2063 = phi_3992_;
                                            if _e2063 {
                                                if _e2011 {
                                                    phi_4001_ = _e1911.member_1;
                                                } else {
                                                    phi_4001_ = _e1911.member_2;
                                                }
                                                let _e2067 = phi_4001_;
                                                phi_4006_ = select(_e2012, true, _e2011);
                                                phi_4008_ = _e2067;
                                            } else {
                                                phi_4006_ = _e835;
                                                phi_4008_ = _e2061;
                                            }
                                            let _e2070 = phi_4006_;
                                            let _e2072 = phi_4008_;
                                            phi_4012_ = _e2070;
                                            phi_4013_ = select(_e2059, _e837, _e2063);
                                            phi_4014_ = _e2072;
                                        }
                                        let _e2075 = phi_4012_;
                                        let _e2077 = phi_4013_;
                                        let _e2079 = phi_4014_;
                                        if _e843 {
                                            phi_4024_ = select(_e837, 0u, _e1635.member_1);
                                            phi_4025_ = _e839;
                                        } else {
                                            phi_4024_ = _e2077;
                                            phi_4025_ = _e2079;
                                        }
                                        let _e2083 = phi_4024_;
                                        let _e2085 = phi_4025_;
                                        phi_4668_ = _e1633;
                                        phi_4026_ = _e1635;
                                        phi_4027_ = (_e798 - 1u);
                                        phi_4028_ = select(_e2075, false, _e843);
                                        phi_4029_ = _e2083;
                                        phi_4030_ = _e2085;
                                    } else {
                                        phi_4668_ = _e794;
                                        phi_4026_ = _e796;
                                        phi_4027_ = _e798;
                                        phi_4028_ = _e835;
                                        phi_4029_ = _e837;
                                        phi_4030_ = _e839;
                                    }
                                    let _e2088 = phi_4668_;
                                    let _e2090 = phi_4026_;
                                    let _e2092 = phi_4027_;
                                    let _e2094 = phi_4028_;
                                    let _e2096 = phi_4029_;
                                    let _e2098 = phi_4030_;
                                    phi_4667_ = _e2088;
                                    phi_4031_ = _e2090;
                                    phi_4032_ = _e2092;
                                    phi_4033_ = _e2094;
                                    phi_4034_ = _e2096;
                                    phi_4035_ = _e2098;
                                } else {
                                    phi_4667_ = _e794;
                                    phi_4031_ = type_52();
                                    phi_4032_ = u32();
                                    phi_4033_ = bool();
                                    phi_4034_ = u32();
                                    phi_4035_ = type_64();
                                }
                                let _e2100 = phi_4667_;
                                let _e2102 = phi_4031_;
                                let _e2104 = phi_4032_;
                                let _e2106 = phi_4033_;
                                let _e2108 = phi_4034_;
                                let _e2110 = phi_4035_;
                                phi_4666_ = _e2100;
                                phi_1380_ = _e2102;
                                phi_1383_ = _e2104;
                                phi_1385_ = _e2106;
                                phi_1387_ = _e2108;
                                phi_1389_ = _e2110;
                                phi_4036_ = _e808;
                            } else {
                                phi_4666_ = _e794;
                                phi_1380_ = type_52();
                                phi_1383_ = u32();
                                phi_1385_ = bool();
                                phi_1387_ = u32();
                                phi_1389_ = type_64();
                                phi_4036_ = false;
                            }
                            let _e2112 = phi_4666_;
                            let _e2114 = phi_1380_;
                            let _e2116 = phi_1383_;
                            let _e2118 = phi_1385_;
                            let _e2120 = phi_1387_;
                            let _e2122 = phi_1389_;
                            let _e2124 = phi_4036_;
                            continue;
                            continuing {
                                phi_4474_ = _e2112;
                                phi_1379_ = _e2114;
                                phi_1382_ = _e2116;
                                phi_1384_ = _e2118;
                                phi_1386_ = _e2120;
                                phi_1388_ = _e2122;
                                phi_4665_ = _e2112;
                                break if !(_e2124);
                            }
                        }
                        let _e2127 = phi_4665_;
                        if _e2127 {
                            break;
                        }
                        let _e2129 = local_10;
                        if _e2129.member_1 {
                        } else {
                            if _e302 {
                            } else {
                                break;
                            }
                            let _e2133 = global_2.member[_e148];
                            if _e163 {
                            } else {
                                break;
                            }
                            let _e2137 = global_10.member[_e148].member_1;
                            if _e302 {
                            } else {
                                break;
                            }
                            global_2.member[_e148] = type_32(_e2133.member, _e2133.member_1, _e2133.member_2, array<f32, 3>((_e2133.member_3[0] + (_e2137[0] * _e2133.member_1[0])), (_e2133.member_3[1] + (_e2137[1] * _e2133.member_1[1])), (_e2133.member_3[2] + (_e2137[2] * _e2133.member_1[2]))), _e2133.member_4);
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
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
