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

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_35 {
    member: type_34,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_42 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_48 {
    member: type_30,
    member_1: f32,
}

struct type_51 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_53 {
    member: array<vec4<u32>, 2>,
}

struct type_56 {
    member: array<i32>,
}

struct type_63 {
    member: type_42,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_53;
@group(0) @binding(2) 
var<uniform> global_3: type_53;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(4) 
var<storage> global_5: type_24;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_56;
@group(0) @binding(7) 
var<storage> global_8: type_37;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_32;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_69;

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
    var phi_443_: u32;
    var phi_487_: i32;
    var phi_627_: type_44;
    var phi_733_: i32;
    var phi_734_: i32;
    var phi_744_: bool;
    var phi_754_: u32;
    var phi_755_: u32;
    var phi_757_: bool;
    var phi_762_: u32;
    var phi_795_: i32;
    var phi_813_: f32;
    var phi_819_: f32;
    var phi_859_: f32;
    var phi_865_: f32;
    var phi_938_: f32;
    var phi_944_: f32;
    var phi_984_: f32;
    var phi_990_: f32;
    var phi_1063_: f32;
    var phi_1069_: f32;
    var phi_1109_: f32;
    var phi_1115_: f32;
    var phi_1234_: i32;
    var phi_1256_: u32;
    var phi_1257_: u32;
    var phi_1294_: i32;
    var phi_1316_: u32;
    var phi_1317_: u32;
    var phi_1325_: f32;
    var phi_1326_: f32;
    var phi_4639_: bool;
    var phi_1422_: type_48;
    var phi_1425_: bool;
    var phi_1427_: type_63;
    var phi_1429_: u32;
    var phi_1431_: u32;
    var phi_1442_: bool;
    var phi_1528_: bool;
    var phi_1529_: type_63;
    var phi_1530_: u32;
    var phi_3544_: u32;
    var phi_3545_: u32;
    var phi_3555_: u32;
    var phi_3557_: u32;
    var phi_3558_: bool;
    var phi_3578_: u32;
    var phi_3579_: u32;
    var phi_3583_: type_64;
    var phi_3945_: type_63;
    var phi_4021_: type_63;
    var phi_4022_: type_63;
    var phi_4023_: u32;
    var phi_4025_: type_63;
    var phi_4026_: u32;
    var phi_4027_: bool;
    var phi_4036_: type_63;
    var phi_4041_: bool;
    var phi_4042_: type_63;
    var phi_1548_: type_48;
    var phi_1551_: type_8;
    var phi_1552_: type_8;
    var phi_1574_: type_8;
    var phi_1595_: u32;
    var phi_1687_: array<array<f32, 3>, 3>;
    var phi_2217_: f32;
    var phi_2218_: f32;
    var phi_2219_: f32;
    var phi_2220_: f32;
    var phi_2221_: vec3<f32>;
    var phi_2222_: vec3<f32>;
    var phi_2223_: vec3<f32>;
    var phi_2224_: vec3<f32>;
    var phi_2415_: f32;
    var phi_2435_: type_51;
    var phi_2436_: type_51;
    var phi_2439_: type_51;
    var phi_2440_: type_51;
    var phi_2441_: bool;
    var phi_2445_: type_51;
    var phi_2454_: type_30;
    var phi_2477_: u32;
    var phi_2491_: i32;
    var phi_2513_: vec3<f32>;
    var phi_2514_: vec3<f32>;
    var phi_2532_: vec3<f32>;
    var phi_2533_: vec3<f32>;
    var phi_2551_: vec3<f32>;
    var phi_2552_: vec3<f32>;
    var phi_2588_: vec3<f32>;
    var phi_2770_: f32;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var phi_2815_: type_48;
    var phi_2816_: type_48;
    var phi_2817_: type_48;
    var phi_1549_: type_48;
    var phi_4633_: bool;
    var local_10: type_48;
    var phi_4822_: bool;
    var phi_4044_: type_48;
    var phi_4045_: bool;
    var phi_4046_: type_63;
    var phi_4047_: u32;
    var phi_4821_: bool;
    var phi_4048_: type_48;
    var phi_4049_: bool;
    var phi_4050_: type_63;
    var phi_4051_: u32;
    var phi_4052_: u32;
    var phi_4820_: bool;
    var phi_4053_: type_48;
    var phi_4054_: bool;
    var phi_4055_: type_63;
    var phi_4056_: u32;
    var phi_4057_: u32;
    var phi_4819_: bool;
    var phi_1423_: type_48;
    var phi_1426_: bool;
    var phi_1428_: type_63;
    var phi_1430_: u32;
    var phi_1432_: u32;
    var phi_4058_: bool;
    var phi_4818_: bool;
    var local_11: type_48;
    var phi_4096_: f32;
    var phi_4098_: f32;
    var phi_4099_: bool;
    var phi_4100_: f32;
    var phi_4101_: bool;
    var phi_4541_: u32;
    var phi_4559_: bool;
    var phi_4562_: bool;
    var phi_4575_: f32;
    var phi_4576_: f32;
    var phi_4581_: f32;
    var phi_4582_: f32;
    var phi_4583_: bool;
    var phi_4591_: f32;
    var phi_4116_: f32;
    var phi_4117_: f32;
    var phi_4129_: f32;
    var phi_4134_: type_30;
    var local_12: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e103 = global;
            let _e105 = arrayLength((&global_4.member));
            let _e107 = arrayLength((&global_5.member));
            let _e119 = arrayLength((&global_10.member));
            let _e123 = global_3.member[0u][0u];
            let _e127 = global_3.member[0u][1u];
            let _e131 = global_3.member[0u][2u];
            let _e135 = global_3.member[0u][3u];
            let _e139 = global_3.member[1u][0u];
            let _e143 = global_3.member[1u][1u];
            let _e147 = global_3.member[1u][2u];
            let _e151 = (_e103.x + (_e103.y * 2097152u));
            let _e163 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e135) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            local = array<i32, 3>(bitcast<i32>(_e139), bitcast<i32>(_e143), bitcast<i32>(_e147));
            let _e166 = (_e151 < arrayLength((&global_8.member)));
            if _e166 {
                if _e166 {
                } else {
                    break;
                }
                let _e170 = global_8.member[_e151].member_2;
                phi_443_ = _e170;
            } else {
                phi_443_ = 4294967295u;
            }
            let _e172 = phi_443_;
            let _e175 = global_1.member[0u];
            let _e179 = global_2.member[0u][0u];
            let _e183 = global_2.member[0u][1u];
            let _e187 = global_2.member[0u][2u];
            let _e191 = global_2.member[0u][3u];
            let _e195 = global_2.member[1u][0u];
            let _e199 = global_2.member[1u][1u];
            let _e203 = global_2.member[1u][2u];
            let _e207 = global_2.member[1u][3u];
            let _e208 = bitcast<f32>(_e179);
            let _e209 = bitcast<f32>(_e183);
            let _e210 = bitcast<f32>(_e187);
            let _e212 = bitcast<f32>(_e195);
            let _e213 = array<u32, 3>(_e199, _e203, _e207);
            let _e215 = bitcast<i32>(_e175);
            if (_e215 < -126i) {
                phi_487_ = -126i;
            } else {
                phi_487_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_487_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_627_ = type_44(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                let _e233 = bitcast<u32>(_e208);
                let _e235 = ((_e233 & 2139095040u) != 0u);
                let _e250 = bitcast<u32>(_e209);
                let _e252 = ((_e250 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e210);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                let _e285 = bitcast<u32>(_e212);
                let _e287 = ((_e285 & 2139095040u) != 0u);
                phi_627_ = type_44(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e233 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e233 & 2147483648u))), _e208, _e235) * _e225) * select(0.00000011920929f, 1f, _e235)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e209, _e252) * _e225) * select(0.00000011920929f, 1f, _e252)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e210, _e269) * _e225) * select(0.00000011920929f, 1f, _e269)) * _e231)), _e191, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e212, _e287) * _e225) * select(0.00000011920929f, 1f, _e287)) * _e231), _e213);
            }
            let _e304 = phi_627_;
            if _e166 {
                let _e305 = (_e151 < arrayLength((&global_9.member)));
                if _e305 {
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e315 = global_8.member[_e151].member.member_2[0u];
                    let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                    let _e323 = global_8.member[_e151].member.member_2[1u];
                    let _e325 = (bitcast<u32>(_e323) & 2147483647u);
                    let _e331 = global_8.member[_e151].member.member_2[2u];
                    let _e333 = (bitcast<u32>(_e331) & 2147483647u);
                    let _e339 = global_8.member[_e151].member.member[0u];
                    let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                    let _e347 = global_8.member[_e151].member.member[1u];
                    let _e349 = (bitcast<u32>(_e347) & 2147483647u);
                    let _e355 = global_8.member[_e151].member.member[2u];
                    let _e357 = (bitcast<u32>(_e355) & 2147483647u);
                    let _e359 = select(_e325, _e317, (_e325 < _e317));
                    let _e361 = select(_e333, _e359, (_e333 < _e359));
                    let _e363 = select(_e341, _e361, (_e341 < _e361));
                    let _e365 = select(_e349, _e363, (_e349 < _e363));
                    let _e367 = select(_e357, _e365, (_e357 < _e365));
                    let _e372 = global_8.member[_e151].member.member_1;
                    let _e373 = bitcast<u32>(_e372);
                    let _e374 = (_e373 & 2147483647u);
                    let _e382 = global_8.member[_e151].member.member_3;
                    let _e383 = bitcast<u32>(_e382);
                    let _e384 = (_e383 & 2147483647u);
                    let _e388 = (((select(_e374, _e367, (_e374 < _e367)) < 2139095040u) && (_e384 <= 2139095040u)) && (_e361 > 0u));
                    if _e388 {
                        let _e391 = (bitcast<u32>(bitcast<f32>(_e361)) & 2147483647u);
                        if (_e391 >= 8388608u) {
                            phi_733_ = (bitcast<i32>((_e391 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_733_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e391)), 32u, (_e391 == 0u))));
                        }
                        let _e405 = phi_733_;
                        phi_734_ = _e405;
                    } else {
                        phi_734_ = 0i;
                    }
                    let _e407 = phi_734_;
                    let _e408 = (_e317 == _e361);
                    if _e408 {
                        phi_744_ = true;
                    } else {
                        phi_744_ = (_e325 == _e361);
                    }
                    let _e411 = phi_744_;
                    let _e412 = select(1u, 0u, _e408);
                    if _e411 {
                        let _e413 = (_e412 + 1u);
                        phi_754_ = _e413;
                        phi_755_ = _e413;
                        phi_757_ = select(true, false, (_e413 == 2u));
                    } else {
                        phi_754_ = u32();
                        phi_755_ = 0u;
                        phi_757_ = true;
                    }
                    let _e417 = phi_754_;
                    let _e419 = phi_755_;
                    let _e421 = phi_757_;
                    if _e421 {
                        phi_762_ = (_e419 + 1u);
                    } else {
                        phi_762_ = 0u;
                    }
                    let _e425 = phi_762_;
                    let _e426 = select(_e417, _e419, _e421);
                    let _e427 = select(_e412, select(2u, _e412, _e411), _e421);
                    let _e428 = -(_e407);
                    if (_e428 < -126i) {
                        phi_795_ = -126i;
                    } else {
                        phi_795_ = select(_e428, 127i, (_e428 > 127i));
                    }
                    let _e433 = phi_795_;
                    let _e438 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                    let _e444 = bitcast<f32>((bitcast<u32>(((_e428 - _e433) + 127i)) << bitcast<u32>(23i)));
                    let _e449 = global_8.member[_e151].member.member;
                    let _e450 = (_e426 == 0u);
                    if _e450 {
                        phi_813_ = _e449[0];
                    } else {
                        phi_813_ = _e449[1];
                    }
                    let _e454 = phi_813_;
                    let _e455 = (_e426 == 2u);
                    if _e455 {
                        phi_819_ = _e449[2];
                    } else {
                        phi_819_ = _e454;
                    }
                    let _e458 = phi_819_;
                    let _e459 = bitcast<u32>(_e458);
                    let _e461 = ((_e459 & 2139095040u) != 0u);
                    let _e473 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e459 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e459 & 2147483648u))), _e458, _e461) * select(0.00000011920929f, 1f, _e461));
                    let _e474 = global_8.member[_e151].member.member_2;
                    if _e450 {
                        phi_859_ = _e474[0];
                    } else {
                        phi_859_ = _e474[1];
                    }
                    let _e478 = phi_859_;
                    if _e455 {
                        phi_865_ = _e474[2];
                    } else {
                        phi_865_ = _e478;
                    }
                    let _e481 = phi_865_;
                    let _e482 = bitcast<u32>(_e481);
                    let _e484 = ((_e482 & 2139095040u) != 0u);
                    let _e498 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e482 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e482 & 2147483648u))), _e481, _e484) * _e438) * select(0.00000011920929f, 1f, _e484)) * _e444);
                    let _e502 = (bitcast<f32>((bitcast<u32>(_e498) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e505 = bitcast<f32>((bitcast<u32>(_e473) & 2147483647u));
                    let _e506 = (_e505 * 0.00000011920929f);
                    let _e509 = select(select(0.00000000000011368684f, _e506, (_e506 > 0.00000000000011368684f)), 0f, _e502);
                    let _e510 = select(0f, _e498, _e502);
                    let _e511 = (_e473 + _e509);
                    let _e512 = (_e473 - _e509);
                    let _e514 = select(38685626000000000000000000f, (1f / _e498), _e502);
                    let _e515 = (_e425 == 0u);
                    if _e515 {
                        phi_938_ = _e449[0];
                    } else {
                        phi_938_ = _e449[1];
                    }
                    let _e519 = phi_938_;
                    let _e520 = (_e425 == 2u);
                    if _e520 {
                        phi_944_ = _e449[2];
                    } else {
                        phi_944_ = _e519;
                    }
                    let _e523 = phi_944_;
                    let _e524 = bitcast<u32>(_e523);
                    let _e526 = ((_e524 & 2139095040u) != 0u);
                    let _e538 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e524 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e524 & 2147483648u))), _e523, _e526) * select(0.00000011920929f, 1f, _e526));
                    if _e515 {
                        phi_984_ = _e474[0];
                    } else {
                        phi_984_ = _e474[1];
                    }
                    let _e542 = phi_984_;
                    if _e520 {
                        phi_990_ = _e474[2];
                    } else {
                        phi_990_ = _e542;
                    }
                    let _e545 = phi_990_;
                    let _e546 = bitcast<u32>(_e545);
                    let _e548 = ((_e546 & 2139095040u) != 0u);
                    let _e562 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e546 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e546 & 2147483648u))), _e545, _e548) * _e438) * select(0.00000011920929f, 1f, _e548)) * _e444);
                    let _e566 = (bitcast<f32>((bitcast<u32>(_e562) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e569 = bitcast<f32>((bitcast<u32>(_e538) & 2147483647u));
                    let _e570 = (_e569 * 0.00000011920929f);
                    let _e573 = select(select(0.00000000000011368684f, _e570, (_e570 > 0.00000000000011368684f)), 0f, _e566);
                    let _e574 = select(0f, _e562, _e566);
                    let _e575 = (_e538 + _e573);
                    let _e576 = (_e538 - _e573);
                    let _e578 = select(38685626000000000000000000f, (1f / _e562), _e566);
                    let _e579 = (_e427 == 0u);
                    if _e579 {
                        phi_1063_ = _e449[0];
                    } else {
                        phi_1063_ = _e449[1];
                    }
                    let _e583 = phi_1063_;
                    let _e584 = (_e427 == 2u);
                    if _e584 {
                        phi_1069_ = _e449[2];
                    } else {
                        phi_1069_ = _e583;
                    }
                    let _e587 = phi_1069_;
                    let _e588 = bitcast<u32>(_e587);
                    let _e590 = ((_e588 & 2139095040u) != 0u);
                    let _e602 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e588 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e588 & 2147483648u))), _e587, _e590) * select(0.00000011920929f, 1f, _e590));
                    if _e579 {
                        phi_1109_ = _e474[0];
                    } else {
                        phi_1109_ = _e474[1];
                    }
                    let _e606 = phi_1109_;
                    if _e584 {
                        phi_1115_ = _e474[2];
                    } else {
                        phi_1115_ = _e606;
                    }
                    let _e609 = phi_1115_;
                    let _e610 = bitcast<u32>(_e609);
                    let _e612 = ((_e610 & 2139095040u) != 0u);
                    let _e626 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e610 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e610 & 2147483648u))), _e609, _e612) * _e438) * select(0.00000011920929f, 1f, _e612)) * _e444);
                    let _e630 = (bitcast<f32>((bitcast<u32>(_e626) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e633 = bitcast<f32>((bitcast<u32>(_e602) & 2147483647u));
                    let _e634 = (_e633 * 0.00000011920929f);
                    let _e637 = select(select(0.00000000000011368684f, _e634, (_e634 > 0.00000000000011368684f)), 0f, _e630);
                    let _e638 = select(0f, _e626, _e630);
                    let _e639 = (_e602 + _e637);
                    let _e640 = (_e602 - _e637);
                    let _e642 = select(38685626000000000000000000f, (1f / _e626), _e630);
                    let _e644 = select(_e569, _e505, (_e505 > _e569));
                    if (_e388 && (select(_e633, _e644, (_e644 > _e633)) <= 1099511600000f)) {
                        let _e656 = ((_e374 & 8388607u) | (select(0u, 1u, ((_e374 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e659 = bitcast<i32>((_e374 >> bitcast<u32>(23i)));
                        let _e663 = (_e656 == 0u);
                        let _e666 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e656)), 32u, _e663)) - 8i);
                        if (_e659 == 255i) {
                            phi_1234_ = 255i;
                        } else {
                            phi_1234_ = (((_e659 + select(0i, 1i, (_e659 == 0i))) - _e666) + _e407);
                        }
                        let _e674 = phi_1234_;
                        let _e684 = (_e674 <= 0i);
                        if _e684 {
                            phi_1257_ = u32();
                        } else {
                            if _e663 {
                                phi_1256_ = u32();
                            } else {
                                phi_1256_ = select(((bitcast<u32>(_e674) << bitcast<u32>(23i)) | ((_e656 << bitcast<u32>(((_e666 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e674 >= 255i));
                            }
                            let _e688 = phi_1256_;
                            phi_1257_ = _e688;
                        }
                        let _e690 = phi_1257_;
                        let _e702 = ((_e384 & 8388607u) | (select(0u, 1u, ((_e384 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e705 = bitcast<i32>((_e384 >> bitcast<u32>(23i)));
                        let _e709 = (_e702 == 0u);
                        let _e712 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e702)), 32u, _e709)) - 8i);
                        if (_e705 == 255i) {
                            phi_1294_ = 255i;
                        } else {
                            phi_1294_ = (((_e705 + select(0i, 1i, (_e705 == 0i))) - _e712) + _e407);
                        }
                        let _e720 = phi_1294_;
                        let _e730 = (_e720 <= 0i);
                        if _e730 {
                            phi_1317_ = u32();
                        } else {
                            if _e709 {
                                phi_1316_ = u32();
                            } else {
                                phi_1316_ = select(((bitcast<u32>(_e720) << bitcast<u32>(23i)) | ((_e702 << bitcast<u32>(((_e712 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e720 >= 255i));
                            }
                            let _e734 = phi_1316_;
                            phi_1317_ = _e734;
                        }
                        let _e736 = phi_1317_;
                        phi_1325_ = bitcast<f32>(((_e383 & 2147483648u) | select(_e736, 0u, select(_e709, true, _e730))));
                        phi_1326_ = bitcast<f32>(((_e373 & 2147483648u) | select(_e690, 0u, select(_e663, true, _e684))));
                    } else {
                        phi_1325_ = 0f;
                        phi_1326_ = 1f;
                    }
                    let _e742 = phi_1325_;
                    let _e744 = phi_1326_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e750 = (_e426 % 3u);
                    let _e751 = (_e750 < 3u);
                    if _e751 {
                    } else {
                        break;
                    }
                    let _e753 = local_1[_e750];
                    let _e756 = (_e425 % 3u);
                    let _e757 = (_e756 < 3u);
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e759 = local_1[_e756];
                    let _e762 = (_e427 % 3u);
                    let _e763 = (_e762 < 3u);
                    if _e763 {
                    } else {
                        break;
                    }
                    let _e765 = local_1[_e762];
                    if _e751 {
                    } else {
                        break;
                    }
                    let _e770 = local[_e750];
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e774 = local[_e756];
                    if _e763 {
                    } else {
                        break;
                    }
                    let _e778 = local[_e762];
                    phi_4639_ = false;
                    phi_1422_ = type_48(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e742);
                    phi_1425_ = (_e744 <= _e742);
                    phi_1427_ = type_63(type_42(vec4<f32>((f32(_e753) * _e163), (f32(_e759) * _e163), (f32(_e765) * _e163), 0f), vec4<f32>((f32(_e770) * _e163), (f32(_e774) * _e163), (f32(_e778) * _e163), 0f)), select(0u, 2147483648u, (_e105 == 0u)));
                    phi_1429_ = 0u;
                    phi_1431_ = ((3u * _e105) + 1u);
                    loop {
                        let _e786 = phi_4639_;
                        let _e788 = phi_1422_;
                        let _e790 = phi_1425_;
                        let _e792 = phi_1427_;
                        let _e794 = phi_1429_;
                        let _e796 = phi_1431_;
                        local_11 = _e788;
                        if _e790 {
                            phi_1442_ = true;
                        } else {
                            phi_1442_ = (_e794 > 0u);
                        }
                        let _e799 = phi_1442_;
                        if _e799 {
                            let _e800 = (_e796 > 0u);
                            if _e800 {
                                if _e790 {
                                    phi_1528_ = _e790;
                                    phi_1529_ = _e792;
                                    phi_1530_ = _e794;
                                } else {
                                    let _e801 = (_e794 - 1u);
                                    let _e802 = (_e801 % 128u);
                                    let _e803 = (_e802 < 128u);
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e805 = local_7[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e807 = local_6[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e809 = local_5[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e811 = local_4[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e813 = local_3[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e815 = local_2[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e820 = local_8[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e823 = local_9[_e802];
                                    phi_1528_ = (_e823 <= _e788.member_1);
                                    phi_1529_ = type_63(type_42(vec4<f32>(_e805, _e807, _e809, 0f), vec4<f32>(_e811, _e813, _e815, 0f)), _e820);
                                    phi_1530_ = _e801;
                                }
                                let _e827 = phi_1528_;
                                let _e829 = phi_1529_;
                                let _e831 = phi_1530_;
                                if _e827 {
                                    if ((_e829.member_1 & 2147483648u) != 0u) {
                                        phi_1548_ = _e788;
                                        phi_1551_ = type_8(0u, ((_e829.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1280 = phi_1548_;
                                            let _e1282 = phi_1551_;
                                            local_10 = _e1280;
                                            local_12 = _e1280;
                                            if (_e1282.member < _e1282.member_1) {
                                                phi_1552_ = type_8((_e1282.member + 1u), _e1282.member_1);
                                                phi_1574_ = type_8(1u, _e1282.member);
                                            } else {
                                                phi_1552_ = _e1282;
                                                phi_1574_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1295 = phi_1552_;
                                            let _e1297 = phi_1574_;
                                            let _e1301 = (bitcast<i32>(_e1297.member) != 0i);
                                            if _e1301 {
                                                let _e1302 = ((_e829.member_1 & 268435455u) + _e1297.member_1);
                                                let _e1303 = (_e1302 < _e107);
                                                if _e1303 {
                                                    if _e1303 {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1307 = global_5.member[_e1302].member_1;
                                                    phi_1595_ = _e1307;
                                                } else {
                                                    phi_1595_ = 4294967295u;
                                                }
                                                let _e1309 = phi_1595_;
                                                if (_e1302 >= _e107) {
                                                    phi_1687_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1303 {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    if (_e750 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1316 = global_5.member[_e1302].member[_e750];
                                                    if (_e756 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1322 = global_5.member[_e1302].member[_e756];
                                                    if (_e762 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1328 = global_5.member[_e1302].member[_e762];
                                                    let _e1330 = (3u + _e750);
                                                    if (_e1330 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1336 = global_5.member[_e1302].member[_e1330];
                                                    let _e1337 = (3u + _e756);
                                                    if (_e1337 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1343 = global_5.member[_e1302].member[_e1337];
                                                    let _e1344 = (3u + _e762);
                                                    if (_e1344 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1350 = global_5.member[_e1302].member[_e1344];
                                                    let _e1352 = (6u + _e750);
                                                    if (_e1352 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1358 = global_5.member[_e1302].member[_e1352];
                                                    let _e1359 = (6u + _e756);
                                                    if (_e1359 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1365 = global_5.member[_e1302].member[_e1359];
                                                    let _e1366 = (6u + _e762);
                                                    if (_e1366 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1372 = global_5.member[_e1302].member[_e1366];
                                                    phi_1687_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1316, _e1322, _e1328), array<f32, 3>(_e1336, _e1343, _e1350), array<f32, 3>(_e1358, _e1365, _e1372));
                                                }
                                                let _e1376 = phi_1687_;
                                                let _e1392 = (_e1376[0][2] - _e602);
                                                let _e1395 = (((_e1376[0][0] - _e473) * _e638) - (_e1392 * _e510));
                                                let _e1398 = (((_e1376[0][1] - _e538) * _e638) - (_e1392 * _e574));
                                                let _e1401 = (_e1376[1][2] - _e602);
                                                let _e1404 = (((_e1376[1][0] - _e473) * _e638) - (_e1401 * _e510));
                                                let _e1407 = (((_e1376[1][1] - _e538) * _e638) - (_e1401 * _e574));
                                                let _e1410 = (_e1376[2][2] - _e602);
                                                let _e1413 = (((_e1376[2][0] - _e473) * _e638) - (_e1410 * _e510));
                                                let _e1416 = (((_e1376[2][1] - _e538) * _e638) - (_e1410 * _e574));
                                                let _e1417 = (_e1413 * _e1407);
                                                let _e1418 = (_e1416 * _e1404);
                                                let _e1419 = (_e1395 * _e1416);
                                                let _e1420 = (_e1398 * _e1413);
                                                let _e1421 = (_e1404 * _e1398);
                                                let _e1422 = (_e1407 * _e1395);
                                                let _e1427 = (((_e1417 >= _e1418) && (_e1419 >= _e1420)) && (_e1421 >= _e1422));
                                                let _e1433 = (_e1427 || (((_e1417 <= _e1418) && (_e1419 <= _e1420)) && (_e1421 <= _e1422)));
                                                if _e1433 {
                                                    let _e1435 = select(-1f, 1f, _e1427);
                                                    let _e1437 = ((_e1417 - _e1418) * _e1435);
                                                    let _e1439 = select(0f, _e1437, (_e1437 > 0f));
                                                    let _e1441 = ((_e1419 - _e1420) * _e1435);
                                                    let _e1443 = select(0f, _e1441, (_e1441 > 0f));
                                                    let _e1445 = ((_e1421 - _e1422) * _e1435);
                                                    let _e1447 = select(0f, _e1445, (_e1445 > 0f));
                                                    let _e1449 = ((_e1439 + _e1443) + _e1447);
                                                    let _e1451 = select(_e1376[1][0], _e1376[0][0], (_e1376[0][0] < _e1376[1][0]));
                                                    let _e1455 = select(_e1376[1][0], _e1376[0][0], (_e1376[0][0] > _e1376[1][0]));
                                                    let _e1459 = select(_e1376[1][1], _e1376[0][1], (_e1376[0][1] < _e1376[1][1]));
                                                    let _e1463 = select(_e1376[1][1], _e1376[0][1], (_e1376[0][1] > _e1376[1][1]));
                                                    let _e1467 = select(_e1376[1][2], _e1376[0][2], (_e1376[0][2] < _e1376[1][2]));
                                                    let _e1471 = select(_e1376[1][2], _e1376[0][2], (_e1376[0][2] > _e1376[1][2]));
                                                    let _e1476 = ((select(_e1376[2][0], _e1451, (_e1451 < _e1376[2][0])) - _e511) * _e514);
                                                    let _e1477 = ((select(_e1376[2][0], _e1455, (_e1455 > _e1376[2][0])) - _e512) * _e514);
                                                    let _e1480 = ((select(_e1376[2][1], _e1459, (_e1459 < _e1376[2][1])) - _e575) * _e578);
                                                    let _e1481 = ((select(_e1376[2][1], _e1463, (_e1463 > _e1376[2][1])) - _e576) * _e578);
                                                    let _e1484 = ((select(_e1376[2][2], _e1467, (_e1467 < _e1376[2][2])) - _e639) * _e642);
                                                    let _e1485 = ((select(_e1376[2][2], _e1471, (_e1471 > _e1376[2][2])) - _e640) * _e642);
                                                    let _e1487 = select(_e1485, _e1484, (_e1484 < _e1485));
                                                    let _e1489 = select(_e1485, _e1484, (_e1484 > _e1485));
                                                    let _e1491 = select(_e1477, _e1476, (_e1476 < _e1477));
                                                    let _e1493 = select(_e1481, _e1480, (_e1480 < _e1481));
                                                    let _e1495 = select(_e1493, _e1491, (_e1491 > _e1493));
                                                    let _e1497 = select(_e1487, _e1495, (_e1495 > _e1487));
                                                    let _e1499 = select(_e1477, _e1476, (_e1476 > _e1477));
                                                    let _e1501 = select(_e1481, _e1480, (_e1480 > _e1481));
                                                    let _e1503 = select(_e1501, _e1499, (_e1499 < _e1501));
                                                    let _e1505 = select(_e1489, _e1503, (_e1503 < _e1489));
                                                    let _e1506 = -(_e1487);
                                                    let _e1512 = select(_e744, _e1497, (_e1497 > _e744));
                                                    let _e1516 = select(_e1404, _e1395, (_e1395 < _e1404));
                                                    let _e1521 = select(_e1404, _e1395, (_e1395 > _e1404));
                                                    let _e1528 = select(_e1407, _e1398, (_e1398 < _e1407));
                                                    let _e1533 = select(_e1407, _e1398, (_e1398 > _e1407));
                                                    let _e1542 = (((((_e1433 && (_e1449 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1413, _e1516, (_e1516 < _e1413)) <= 0f) && (select(_e1413, _e1521, (_e1521 > _e1413)) >= 0f))) && ((select(_e1416, _e1528, (_e1528 < _e1416)) <= 0f) && (select(_e1416, _e1533, (_e1533 > _e1416)) >= 0f))) && (_e1512 <= (_e1505 + (select(_e1506, _e1489, (_e1489 > _e1506)) * 0.0000019073523f)))) && (_e1512 <= _e1280.member_1));
                                                    if _e1542 {
                                                        let _e1547 = (_e1376[1][0] - _e1376[0][0]);
                                                        let _e1548 = (_e1376[1][1] - _e1376[0][1]);
                                                        let _e1549 = (_e1376[1][2] - _e1376[0][2]);
                                                        let _e1550 = vec3<f32>(_e1547, _e1548, _e1549);
                                                        let _e1551 = (_e1376[2][0] - _e1376[1][0]);
                                                        let _e1552 = (_e1376[2][1] - _e1376[1][1]);
                                                        let _e1553 = (_e1376[2][2] - _e1376[1][2]);
                                                        let _e1554 = vec3<f32>(_e1551, _e1552, _e1553);
                                                        let _e1555 = (_e1376[0][0] - _e1376[2][0]);
                                                        let _e1556 = (_e1376[0][1] - _e1376[2][1]);
                                                        let _e1557 = (_e1376[0][2] - _e1376[2][2]);
                                                        let _e1558 = vec3<f32>(_e1555, _e1556, _e1557);
                                                        let _e1561 = bitcast<f32>((bitcast<u32>(_e1547) & 2147483647u));
                                                        let _e1564 = bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u));
                                                        let _e1566 = select(_e1564, _e1561, (_e1561 > _e1564));
                                                        let _e1569 = bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u));
                                                        let _e1571 = select(_e1569, _e1566, (_e1566 > _e1569));
                                                        let _e1574 = bitcast<f32>((bitcast<u32>(_e1551) & 2147483647u));
                                                        let _e1577 = bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u));
                                                        let _e1579 = select(_e1577, _e1574, (_e1574 > _e1577));
                                                        let _e1582 = bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u));
                                                        let _e1584 = select(_e1582, _e1579, (_e1579 > _e1582));
                                                        let _e1587 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                        let _e1590 = bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u));
                                                        let _e1592 = select(_e1590, _e1587, (_e1587 > _e1590));
                                                        let _e1595 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                        let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                        let _e1599 = select(_e1584, _e1571, (_e1571 > _e1584));
                                                        let _e1601 = select(_e1597, _e1599, (_e1599 > _e1597));
                                                        if (_e1571 == _e1601) {
                                                            phi_2217_ = _e1407;
                                                            phi_2218_ = _e1404;
                                                            phi_2219_ = _e1398;
                                                            phi_2220_ = _e1395;
                                                            phi_2221_ = vec3<f32>(_e1376[0][0], _e1376[0][1], _e1376[0][2]);
                                                            phi_2222_ = _e1558;
                                                            phi_2223_ = _e1554;
                                                            phi_2224_ = _e1550;
                                                        } else {
                                                            let _e1603 = (_e1584 == _e1601);
                                                            let _e1608 = vec3(_e1603);
                                                            phi_2217_ = select(_e1398, _e1416, _e1603);
                                                            phi_2218_ = select(_e1395, _e1413, _e1603);
                                                            phi_2219_ = select(_e1416, _e1407, _e1603);
                                                            phi_2220_ = select(_e1413, _e1404, _e1603);
                                                            phi_2221_ = select(vec3<f32>(_e1376[2][0], _e1376[2][1], _e1376[2][2]), vec3<f32>(_e1376[1][0], _e1376[1][1], _e1376[1][2]), _e1608);
                                                            phi_2222_ = select(_e1554, _e1550, _e1608);
                                                            phi_2223_ = select(_e1550, _e1558, _e1608);
                                                            phi_2224_ = select(_e1558, _e1554, _e1608);
                                                        }
                                                        let _e1614 = phi_2217_;
                                                        let _e1616 = phi_2218_;
                                                        let _e1618 = phi_2219_;
                                                        let _e1620 = phi_2220_;
                                                        let _e1622 = phi_2221_;
                                                        let _e1624 = phi_2222_;
                                                        let _e1626 = phi_2223_;
                                                        let _e1628 = phi_2224_;
                                                        let _e1635 = ((_e1626.y * _e1624.z) - (_e1624.y * _e1626.z));
                                                        let _e1640 = ((_e1626.z * _e1624.x) - (_e1624.z * _e1626.x));
                                                        let _e1643 = ((_e1626.x * _e1624.y) - (_e1624.x * _e1626.y));
                                                        let _e1646 = ((_e1439 >= _e1443) && (_e1439 >= _e1447));
                                                        let _e1647 = (_e1443 >= _e1447);
                                                        let _e1661 = (((_e1635 * (select(select(_e1376[2][0], _e1376[1][0], _e1647), _e1376[0][0], _e1646) - _e473)) + (_e1640 * (select(select(_e1376[2][1], _e1376[1][1], _e1647), _e1376[0][1], _e1646) - _e538))) + (_e1643 * (select(select(_e1376[2][2], _e1376[1][2], _e1647), _e1376[0][2], _e1646) - _e602)));
                                                        let _e1666 = (((_e1635 * _e510) + (_e1640 * _e574)) + (_e1643 * _e638));
                                                        let _e1667 = (_e1616 - _e1620);
                                                        let _e1668 = (_e1614 - _e1618);
                                                        let _e1671 = ((_e1667 * _e1667) + (_e1668 * _e1668));
                                                        let _e1678 = (-(((_e1620 * _e1667) + (_e1618 * _e1668))) / select(0.000000000000000000000000000000000000011754944f, _e1671, (_e1671 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1680 = select(1f, _e1678, (_e1678 < 1f));
                                                        let _e1682 = select(0f, _e1680, (_e1680 > 0f));
                                                        let _e1691 = ((_e1622.x + (_e1628.x * _e1682)) - _e473);
                                                        let _e1694 = ((_e1622.y + (_e1628.y * _e1682)) - _e538);
                                                        let _e1697 = ((_e1622.z + (_e1628.z * _e1682)) - _e602);
                                                        let _e1700 = bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u));
                                                        let _e1703 = bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u));
                                                        let _e1705 = select(_e1703, _e1700, (_e1700 > _e1703));
                                                        let _e1708 = bitcast<f32>((bitcast<u32>(_e1697) & 2147483647u));
                                                        let _e1710 = select(_e1708, _e1705, (_e1705 > _e1708));
                                                        let _e1716 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                        let _e1719 = bitcast<f32>((bitcast<u32>(_e1640) & 2147483647u));
                                                        let _e1721 = select(_e1719, _e1716, (_e1716 > _e1719));
                                                        let _e1724 = bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u));
                                                        let _e1743 = bitcast<f32>((bitcast<u32>(_e1626.x) & 2147483647u));
                                                        let _e1746 = bitcast<f32>((bitcast<u32>(_e1626.y) & 2147483647u));
                                                        let _e1748 = select(_e1746, _e1743, (_e1743 > _e1746));
                                                        let _e1751 = bitcast<f32>((bitcast<u32>(_e1626.z) & 2147483647u));
                                                        let _e1757 = bitcast<f32>((bitcast<u32>(_e1624.x) & 2147483647u));
                                                        let _e1760 = bitcast<f32>((bitcast<u32>(_e1624.y) & 2147483647u));
                                                        let _e1762 = select(_e1760, _e1757, (_e1757 > _e1760));
                                                        let _e1765 = bitcast<f32>((bitcast<u32>(_e1624.z) & 2147483647u));
                                                        let _e1771 = ((bitcast<f32>((bitcast<u32>(((((_e1635 * _e1691) + (_e1640 * _e1694)) + (_e1643 * _e1697)) - _e1661)) & 2147483647u)) <= ((0.0000009536743f * select(_e1601, _e1710, (_e1710 > _e1601))) * select(_e1724, _e1721, (_e1721 > _e1724)))) && !((bitcast<f32>((bitcast<u32>(_e1666) & 2147483647u)) <= ((0.0000038146973f * select(_e1751, _e1748, (_e1748 > _e1751))) * select(_e1765, _e1762, (_e1762 > _e1765))))));
                                                        let _e1772 = (_e1661 / _e1666);
                                                        if (_e1542 && !(_e1771)) {
                                                            let _e1775 = (_e1697 / _e638);
                                                            let _e1783 = (((_e1635 * (_e1691 - (_e510 * _e1775))) + (_e1640 * (_e1694 - (_e574 * _e1775)))) / _e1666);
                                                            phi_2415_ = select(select(_e1775, (_e1775 + _e1783), (bitcast<f32>((bitcast<u32>(_e1783) & 2147483647u)) <= _e1601)), _e1772, _e1771);
                                                        } else {
                                                            phi_2415_ = _e1772;
                                                        }
                                                        let _e1792 = phi_2415_;
                                                        let _e1794 = select(_e1505, _e1792, (_e1792 < _e1505));
                                                        let _e1796 = select(_e1497, _e1794, (_e1794 > _e1497));
                                                        let _e1797 = (1f / _e1449);
                                                        phi_2435_ = type_51(_e1796, (_e1443 * _e1797), (_e1447 * _e1797), ((_e1542 && (_e1796 >= _e744)) && (_e1796 <= _e1280.member_1)));
                                                        phi_2436_ = type_51();
                                                    } else {
                                                        phi_2435_ = type_51();
                                                        phi_2436_ = type_51(0f, 0f, 0f, _e1542);
                                                    }
                                                    let _e1806 = phi_2435_;
                                                    let _e1808 = phi_2436_;
                                                    phi_2439_ = _e1806;
                                                    phi_2440_ = _e1808;
                                                    phi_2441_ = select(true, false, _e1542);
                                                } else {
                                                    phi_2439_ = type_51();
                                                    phi_2440_ = type_51(0f, 0f, 0f, _e1433);
                                                    phi_2441_ = true;
                                                }
                                                let _e1811 = phi_2439_;
                                                let _e1813 = phi_2440_;
                                                let _e1815 = phi_2441_;
                                                if _e1815 {
                                                    phi_2445_ = _e1813;
                                                } else {
                                                    phi_2445_ = _e1811;
                                                }
                                                let _e1817 = phi_2445_;
                                                if _e1817.member_3 {
                                                    phi_2454_ = type_30(_e1817.member, _e1817.member_1, _e1817.member_2, _e1309);
                                                } else {
                                                    phi_2454_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1824 = phi_2454_;
                                                if (_e1824.member_3 != 4294967295u) {
                                                    if (_e1309 == _e172) {
                                                        phi_2789_ = false;
                                                    } else {
                                                        let _e1828 = (_e1309 < arrayLength((&global_6.member)));
                                                        if _e1828 {
                                                            if _e1828 {
                                                            } else {
                                                                phi_4633_ = true;
                                                                break;
                                                            }
                                                            let _e1830 = global_6.member[_e1309];
                                                            phi_2477_ = _e1830;
                                                        } else {
                                                            phi_2477_ = 4294967295u;
                                                        }
                                                        let _e1832 = phi_2477_;
                                                        let _e1833 = (_e1832 < arrayLength((&global_7.member)));
                                                        if _e1833 {
                                                            if _e1833 {
                                                            } else {
                                                                phi_4633_ = true;
                                                                break;
                                                            }
                                                            let _e1835 = global_7.member[_e1832];
                                                            phi_2491_ = _e1835;
                                                        } else {
                                                            phi_2491_ = 0i;
                                                        }
                                                        let _e1837 = phi_2491_;
                                                        let _e1838 = (_e1837 == 0i);
                                                        if _e1838 {
                                                            phi_2788_ = true;
                                                        } else {
                                                            if _e450 {
                                                                phi_2514_ = vec3<f32>(_e1376[0][0], _e1376[0][1], _e1376[0][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2513_ = vec3<f32>(_e1376[0][2], _e1376[0][0], _e1376[0][1]);
                                                                } else {
                                                                    phi_2513_ = vec3<f32>(_e1376[0][1], _e1376[0][2], _e1376[0][0]);
                                                                }
                                                                let _e1843 = phi_2513_;
                                                                phi_2514_ = _e1843;
                                                            }
                                                            let _e1846 = phi_2514_;
                                                            if _e450 {
                                                                phi_2533_ = vec3<f32>(_e1376[1][0], _e1376[1][1], _e1376[1][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2532_ = vec3<f32>(_e1376[1][2], _e1376[1][0], _e1376[1][1]);
                                                                } else {
                                                                    phi_2532_ = vec3<f32>(_e1376[1][1], _e1376[1][2], _e1376[1][0]);
                                                                }
                                                                let _e1851 = phi_2532_;
                                                                phi_2533_ = _e1851;
                                                            }
                                                            let _e1854 = phi_2533_;
                                                            if _e450 {
                                                                phi_2552_ = vec3<f32>(_e1376[2][0], _e1376[2][1], _e1376[2][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2551_ = vec3<f32>(_e1376[2][2], _e1376[2][0], _e1376[2][1]);
                                                                } else {
                                                                    phi_2551_ = vec3<f32>(_e1376[2][1], _e1376[2][2], _e1376[2][0]);
                                                                }
                                                                let _e1859 = phi_2551_;
                                                                phi_2552_ = _e1859;
                                                            }
                                                            let _e1862 = phi_2552_;
                                                            let _e1865 = (_e1854.x - _e1846.x);
                                                            let _e1868 = (_e1854.y - _e1846.y);
                                                            let _e1871 = (_e1854.z - _e1846.z);
                                                            let _e1873 = (_e1862.x - _e1846.x);
                                                            let _e1875 = (_e1862.y - _e1846.y);
                                                            let _e1877 = (_e1862.z - _e1846.z);
                                                            if (_e304.member_1 == 1u) {
                                                                phi_2588_ = (vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]) - _e1846);
                                                            } else {
                                                                phi_2588_ = vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]);
                                                            }
                                                            let _e1892 = phi_2588_;
                                                            let _e1898 = bitcast<f32>((bitcast<u32>((_e1865 * _e1875)) ^ _e304.member_3[0]));
                                                            let _e1902 = bitcast<f32>((bitcast<u32>((_e1868 * _e1873)) ^ _e304.member_3[0]));
                                                            let _e1906 = bitcast<f32>((bitcast<u32>((_e1868 * _e1877)) ^ _e304.member_3[0]));
                                                            let _e1910 = bitcast<f32>((bitcast<u32>((_e1871 * _e1875)) ^ _e304.member_3[0]));
                                                            let _e1914 = bitcast<f32>((bitcast<u32>((_e1871 * _e1873)) ^ _e304.member_3[0]));
                                                            let _e1918 = bitcast<f32>((bitcast<u32>((_e1865 * _e1877)) ^ _e304.member_3[0]));
                                                            let _e1919 = (_e1906 - _e1910);
                                                            let _e1920 = (_e1914 - _e1918);
                                                            let _e1921 = (_e1898 - _e1902);
                                                            let _e1945 = (bitcast<f32>((bitcast<u32>(_e1906) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1910) & 2147483647u)));
                                                            let _e1952 = (bitcast<f32>((bitcast<u32>(_e1914) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1918) & 2147483647u)));
                                                            let _e1959 = (bitcast<f32>((bitcast<u32>(_e1898) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1902) & 2147483647u)));
                                                            if (_e304.member_2 == 0f) {
                                                                phi_2770_ = 0f;
                                                            } else {
                                                                let _e1989 = bitcast<f32>((bitcast<u32>(_e1919) & 2147483647u));
                                                                let _e1992 = bitcast<f32>((bitcast<u32>(_e1920) & 2147483647u));
                                                                let _e1995 = bitcast<f32>((bitcast<u32>(_e1921) & 2147483647u));
                                                                let _e1997 = select(_e1995, _e1992, (_e1992 > _e1995));
                                                                let _e2001 = select(_e1995, _e1992, (_e1992 < _e1995));
                                                                let _e2005 = select(_e1992, _e1989, (_e1989 < _e1992));
                                                                let _e2007 = select(_e1992, _e1989, (_e1989 > _e1992));
                                                                let _e2009 = select(_e1995, _e2007, (_e2007 < _e1995));
                                                                phi_2770_ = bitcast<f32>((bitcast<u32>((_e304.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1997, _e1989, (_e1989 > _e1997)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2009, _e2005, (_e2005 > _e2009)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2001, _e1989, (_e1989 < _e2001)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1945 + _e1952) + _e1959))) ^ _e304.member_3[0]))) * 1.0000005f)) ^ _e304.member_3[0])))) ^ _e304.member_3[0]));
                                                            }
                                                            let _e2036 = phi_2770_;
                                                            phi_2788_ = (_e1838 || !(((((bitcast<f32>((bitcast<u32>((_e1892.x * _e1919)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1892.y * _e1920)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1892.z * _e1921)) ^ _e304.member_3[0]))) * f32(-(_e1837))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1892.x) & 2147483647u)) * _e1945)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1892.y) & 2147483647u)) * _e1952)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1892.z) & 2147483647u)) * _e1959)) ^ _e304.member_3[0]))))) ^ _e304.member_3[0])) + _e2036) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2050 = phi_2788_;
                                                        phi_2789_ = _e2050;
                                                    }
                                                    let _e2052 = phi_2789_;
                                                    if _e2052 {
                                                        if (_e1824.member < _e1280.member.member) {
                                                            phi_2809_ = true;
                                                        } else {
                                                            if (_e1824.member == _e1280.member.member) {
                                                                phi_2808_ = (_e1824.member_3 < _e1280.member.member_3);
                                                            } else {
                                                                phi_2808_ = false;
                                                            }
                                                            let _e2062 = phi_2808_;
                                                            phi_2809_ = _e2062;
                                                        }
                                                        let _e2064 = phi_2809_;
                                                        if _e2064 {
                                                            phi_2815_ = type_48(_e1824, _e1824.member);
                                                        } else {
                                                            phi_2815_ = _e1280;
                                                        }
                                                        let _e2067 = phi_2815_;
                                                        phi_2816_ = _e2067;
                                                    } else {
                                                        phi_2816_ = _e1280;
                                                    }
                                                    let _e2069 = phi_2816_;
                                                    phi_2817_ = _e2069;
                                                } else {
                                                    phi_2817_ = _e1280;
                                                }
                                                let _e2071 = phi_2817_;
                                                phi_1549_ = _e2071;
                                            } else {
                                                phi_1549_ = type_48();
                                            }
                                            let _e2073 = phi_1549_;
                                            continue;
                                            continuing {
                                                phi_1548_ = _e2073;
                                                phi_1551_ = _e1295;
                                                phi_4633_ = _e786;
                                                break if !(_e1301);
                                            }
                                        }
                                        let _e2076 = phi_4633_;
                                        phi_4818_ = _e2076;
                                        if _e2076 {
                                            break;
                                        }
                                        let _e2078 = local_10;
                                        phi_4822_ = _e2076;
                                        let _e2390 = local_12;
                                        phi_4044_ = _e2390;
                                        phi_4045_ = false;
                                        phi_4046_ = _e829;
                                        phi_4047_ = select(_e831, 0u, (_e744 > _e2078.member_1));
                                    } else {
                                        if (_e829.member_1 >= _e105) {
                                            phi_3583_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e829.member_1 < _e105) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e843 = ((1u + _e426) % 4u);
                                            if (_e843 < 4u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e848 = global_4.member[_e829.member_1][_e843];
                                            let _e850 = (_e848 >> bitcast<u32>(11u));
                                            let _e852 = ((1u + _e425) % 4u);
                                            if (_e852 < 4u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e857 = global_4.member[_e829.member_1][_e852];
                                            let _e859 = (_e857 >> bitcast<u32>(11u));
                                            let _e861 = ((1u + _e427) % 4u);
                                            if (_e861 < 4u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e866 = global_4.member[_e829.member_1][_e861];
                                            let _e868 = (_e866 >> bitcast<u32>(11u));
                                            let _e891 = (bitcast<f32>((bitcast<u32>((_e829.member.member_1.x - _e829.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e892 = (bitcast<f32>((bitcast<u32>((_e829.member.member_1.y - _e829.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e893 = (bitcast<f32>((bitcast<u32>((_e829.member.member_1.z - _e829.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e895 = select(_e163, _e891, (_e891 > _e163));
                                            let _e897 = select(_e163, _e892, (_e892 > _e163));
                                            let _e899 = select(_e163, _e893, (_e893 > _e163));
                                            let _e930 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e848 & 1023u))) - 8388608f) * _e895));
                                            let _e935 = (bitcast<i32>((_e848 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e938 = bitcast<f32>((_e930 & bitcast<u32>(_e935)));
                                            let _e939 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e857 & 1023u))) - 8388608f) * _e897));
                                            let _e944 = (bitcast<i32>((_e857 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e947 = bitcast<f32>((_e939 & bitcast<u32>(_e944)));
                                            let _e948 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e866 & 1023u))) - 8388608f) * _e899));
                                            let _e953 = (bitcast<i32>((_e866 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e956 = bitcast<f32>((_e948 & bitcast<u32>(_e953)));
                                            let _e960 = bitcast<f32>((_e930 & bitcast<u32>(~(_e935))));
                                            let _e964 = bitcast<f32>((_e939 & bitcast<u32>(~(_e944))));
                                            let _e968 = bitcast<f32>((_e948 & bitcast<u32>(~(_e953))));
                                            let _e969 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e850 & 1023u))) - 8388608f) * _e895));
                                            let _e974 = (bitcast<i32>((_e850 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e977 = bitcast<f32>((_e969 & bitcast<u32>(_e974)));
                                            let _e978 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e859 & 1023u))) - 8388608f) * _e897));
                                            let _e983 = (bitcast<i32>((_e859 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e986 = bitcast<f32>((_e978 & bitcast<u32>(_e983)));
                                            let _e987 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e868 & 1023u))) - 8388608f) * _e899));
                                            let _e992 = (bitcast<i32>((_e868 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e995 = bitcast<f32>((_e987 & bitcast<u32>(_e992)));
                                            let _e999 = bitcast<f32>((_e969 & bitcast<u32>(~(_e974))));
                                            let _e1003 = bitcast<f32>((_e978 & bitcast<u32>(~(_e983))));
                                            let _e1007 = bitcast<f32>((_e987 & bitcast<u32>(~(_e992))));
                                            let _e1037 = global_4.member[_e829.member_1][0u];
                                            let _e1041 = global_4.member[_e829.member_1][1u];
                                            let _e1045 = global_4.member[_e829.member_1][2u];
                                            let _e1049 = global_4.member[_e829.member_1][3u];
                                            let _e1061 = (((_e1041 >> bitcast<u32>(22i)) | ((_e1045 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1049 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1062 = (_e1037 & 268435455u);
                                            let _e1063 = (_e1061 & 268435455u);
                                            let _e1066 = ((_e1037 >> bitcast<u32>(28u)) & 7u);
                                            let _e1074 = ((_e1037 >> bitcast<u32>(31i)) | (((_e1061 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1075 = (_e1066 != 0u);
                                            if (_e1066 == 0u) {
                                                phi_3545_ = _e1062;
                                            } else {
                                                if (_e1066 == 7u) {
                                                    phi_3544_ = 2147483648u;
                                                } else {
                                                    phi_3544_ = ((2147483648u | (_e1066 << bitcast<u32>(28u))) | (_e1063 & 268435455u));
                                                }
                                                let _e1084 = phi_3544_;
                                                phi_3545_ = _e1084;
                                            }
                                            let _e1086 = phi_3545_;
                                            if _e1075 {
                                                let _e1087 = (_e1066 != 7u);
                                                if _e1087 {
                                                    phi_3555_ = (_e1063 + _e1066);
                                                } else {
                                                    phi_3555_ = u32();
                                                }
                                                let _e1090 = phi_3555_;
                                                phi_3557_ = _e1090;
                                                phi_3558_ = select(true, false, _e1087);
                                            } else {
                                                phi_3557_ = u32();
                                                phi_3558_ = true;
                                            }
                                            let _e1093 = phi_3557_;
                                            let _e1095 = phi_3558_;
                                            if (_e1074 == 0u) {
                                                phi_3579_ = (_e1062 + select(0u, 1u, !(_e1075)));
                                            } else {
                                                if (_e1074 == 7u) {
                                                    phi_3578_ = 2147483648u;
                                                } else {
                                                    phi_3578_ = ((2147483648u | (_e1074 << bitcast<u32>(28u))) | (select(_e1093, _e1063, _e1095) & 268435455u));
                                                }
                                                let _e1108 = phi_3578_;
                                                phi_3579_ = _e1108;
                                            }
                                            let _e1110 = phi_3579_;
                                            phi_3583_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e829.member.member.x + _e938), (_e829.member.member.x + _e960), (_e829.member.member_1.x - _e977), (_e829.member.member_1.x - _e999)), vec4<f32>((_e829.member.member.y + _e947), (_e829.member.member.y + _e964), (_e829.member.member_1.y - _e986), (_e829.member.member_1.y - _e1003)), vec4<f32>((_e829.member.member.z + _e956), (_e829.member.member.z + _e968), (_e829.member.member_1.z - _e995), (_e829.member.member_1.z - _e1007))), type_63(type_42((_e829.member.member + vec4<f32>(_e938, _e947, _e956, 0f)), (_e829.member.member_1 - vec4<f32>(_e977, _e986, _e995, 0f))), _e1086), type_63(type_42((_e829.member.member + vec4<f32>(_e960, _e964, _e968, 0f)), (_e829.member.member_1 - vec4<f32>(_e999, _e1003, _e1007, 0f))), _e1110));
                                        }
                                        let _e1115 = phi_3583_;
                                        let _e1127 = ((_e1115.member[0].x - _e511) * _e514);
                                        let _e1128 = ((_e1115.member[0].y - _e511) * _e514);
                                        let _e1129 = ((_e1115.member[0].z - _e512) * _e514);
                                        let _e1130 = ((_e1115.member[0].w - _e512) * _e514);
                                        let _e1140 = ((_e1115.member[1].x - _e575) * _e578);
                                        let _e1141 = ((_e1115.member[1].y - _e575) * _e578);
                                        let _e1142 = ((_e1115.member[1].z - _e576) * _e578);
                                        let _e1143 = ((_e1115.member[1].w - _e576) * _e578);
                                        let _e1153 = ((_e1115.member[2].x - _e639) * _e642);
                                        let _e1154 = ((_e1115.member[2].y - _e639) * _e642);
                                        let _e1155 = ((_e1115.member[2].z - _e640) * _e642);
                                        let _e1156 = ((_e1115.member[2].w - _e640) * _e642);
                                        let _e1158 = select(_e1155, _e1153, (_e1153 < _e1155));
                                        let _e1160 = select(_e1156, _e1154, (_e1154 < _e1156));
                                        let _e1162 = select(_e1155, _e1153, (_e1153 > _e1155));
                                        let _e1164 = select(_e1156, _e1154, (_e1154 > _e1156));
                                        let _e1166 = select(_e1129, _e1127, (_e1127 < _e1129));
                                        let _e1168 = select(_e1130, _e1128, (_e1128 < _e1130));
                                        let _e1170 = select(_e1142, _e1140, (_e1140 < _e1142));
                                        let _e1172 = select(_e1143, _e1141, (_e1141 < _e1143));
                                        let _e1174 = select(_e1170, _e1166, (_e1166 > _e1170));
                                        let _e1176 = select(_e1172, _e1168, (_e1168 > _e1172));
                                        let _e1178 = select(_e1158, _e1174, (_e1174 > _e1158));
                                        let _e1180 = select(_e1160, _e1176, (_e1176 > _e1160));
                                        let _e1182 = select(_e1129, _e1127, (_e1127 > _e1129));
                                        let _e1184 = select(_e1130, _e1128, (_e1128 > _e1130));
                                        let _e1186 = select(_e1142, _e1140, (_e1140 > _e1142));
                                        let _e1188 = select(_e1143, _e1141, (_e1141 > _e1143));
                                        let _e1190 = select(_e1186, _e1182, (_e1182 < _e1186));
                                        let _e1192 = select(_e1188, _e1184, (_e1184 < _e1188));
                                        let _e1197 = -(_e1158);
                                        let _e1198 = -(_e1160);
                                        let _e1205 = (select(_e1162, _e1190, (_e1190 < _e1162)) + (select(_e1197, _e1162, (_e1162 > _e1197)) * 0.0000019073523f));
                                        let _e1206 = (select(_e1164, _e1192, (_e1192 < _e1164)) + (select(_e1198, _e1164, (_e1164 > _e1198)) * 0.0000019073523f));
                                        let _e1208 = select(_e744, _e1178, (_e1178 > _e744));
                                        let _e1210 = select(_e744, _e1180, (_e1180 > _e744));
                                        let _e1215 = (_e1208 <= select(_e788.member_1, _e1205, (_e1205 < _e788.member_1)));
                                        let _e1216 = (_e1210 <= select(_e788.member_1, _e1206, (_e1206 < _e788.member_1)));
                                        let _e1217 = (_e1208 <= _e1210);
                                        if _e1215 {
                                            if _e1216 {
                                                if _e1217 {
                                                    phi_3945_ = _e1115.member_2;
                                                } else {
                                                    phi_3945_ = _e1115.member_1;
                                                }
                                                let _e1221 = phi_3945_;
                                                let _e1242 = (_e831 % 128u);
                                                let _e1243 = (_e1242 < 128u);
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_8[_e1242] = _e1221.member_1;
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_7[_e1242] = _e1221.member.member.x;
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_6[_e1242] = _e1221.member.member.y;
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_5[_e1242] = _e1221.member.member.z;
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_4[_e1242] = _e1221.member.member_1.x;
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_3[_e1242] = _e1221.member.member_1.y;
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_2[_e1242] = _e1221.member.member_1.z;
                                                if _e1243 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_9[_e1242] = select(_e1208, _e1210, _e1217);
                                                if _e1217 {
                                                    phi_4021_ = _e1115.member_1;
                                                } else {
                                                    phi_4021_ = _e1115.member_2;
                                                }
                                                let _e1256 = phi_4021_;
                                                phi_4022_ = _e1256;
                                                phi_4023_ = (_e831 + 1u);
                                            } else {
                                                phi_4022_ = type_63();
                                                phi_4023_ = u32();
                                            }
                                            let _e1258 = phi_4022_;
                                            let _e1260 = phi_4023_;
                                            phi_4025_ = _e1258;
                                            phi_4026_ = _e1260;
                                            phi_4027_ = select(true, false, _e1216);
                                        } else {
                                            phi_4025_ = type_63();
                                            phi_4026_ = u32();
                                            phi_4027_ = true;
                                        }
                                        let _e1263 = phi_4025_;
                                        let _e1265 = phi_4026_;
                                        let _e1267 = phi_4027_;
                                        if _e1267 {
                                            if _e1215 {
                                                phi_4036_ = _e1115.member_1;
                                            } else {
                                                phi_4036_ = _e1115.member_2;
                                            }
                                            let _e1271 = phi_4036_;
                                            phi_4041_ = select(_e1216, true, _e1215);
                                            phi_4042_ = _e1271;
                                        } else {
                                            phi_4041_ = _e827;
                                            phi_4042_ = _e1263;
                                        }
                                        let _e1274 = phi_4041_;
                                        let _e1276 = phi_4042_;
                                        phi_4822_ = _e786;
                                        phi_4044_ = _e788;
                                        phi_4045_ = _e1274;
                                        phi_4046_ = _e1276;
                                        phi_4047_ = select(_e1265, _e831, _e1267);
                                    }
                                    let _e2083 = phi_4822_;
                                    let _e2085 = phi_4044_;
                                    let _e2087 = phi_4045_;
                                    let _e2089 = phi_4046_;
                                    let _e2091 = phi_4047_;
                                    phi_4821_ = _e2083;
                                    phi_4048_ = _e2085;
                                    phi_4049_ = _e2087;
                                    phi_4050_ = _e2089;
                                    phi_4051_ = _e2091;
                                    phi_4052_ = (_e796 - 1u);
                                } else {
                                    phi_4821_ = _e786;
                                    phi_4048_ = _e788;
                                    phi_4049_ = _e827;
                                    phi_4050_ = _e829;
                                    phi_4051_ = _e831;
                                    phi_4052_ = _e796;
                                }
                                let _e2093 = phi_4821_;
                                let _e2095 = phi_4048_;
                                let _e2097 = phi_4049_;
                                let _e2099 = phi_4050_;
                                let _e2101 = phi_4051_;
                                let _e2103 = phi_4052_;
                                phi_4820_ = _e2093;
                                phi_4053_ = _e2095;
                                phi_4054_ = _e2097;
                                phi_4055_ = _e2099;
                                phi_4056_ = _e2101;
                                phi_4057_ = _e2103;
                            } else {
                                phi_4820_ = _e786;
                                phi_4053_ = type_48();
                                phi_4054_ = bool();
                                phi_4055_ = type_63();
                                phi_4056_ = u32();
                                phi_4057_ = u32();
                            }
                            let _e2105 = phi_4820_;
                            let _e2107 = phi_4053_;
                            let _e2109 = phi_4054_;
                            let _e2111 = phi_4055_;
                            let _e2113 = phi_4056_;
                            let _e2115 = phi_4057_;
                            phi_4819_ = _e2105;
                            phi_1423_ = _e2107;
                            phi_1426_ = _e2109;
                            phi_1428_ = _e2111;
                            phi_1430_ = _e2113;
                            phi_1432_ = _e2115;
                            phi_4058_ = _e800;
                        } else {
                            phi_4819_ = _e786;
                            phi_1423_ = type_48();
                            phi_1426_ = bool();
                            phi_1428_ = type_63();
                            phi_1430_ = u32();
                            phi_1432_ = u32();
                            phi_4058_ = false;
                        }
                        let _e2117 = phi_4819_;
                        let _e2119 = phi_1423_;
                        let _e2121 = phi_1426_;
                        let _e2123 = phi_1428_;
                        let _e2125 = phi_1430_;
                        let _e2127 = phi_1432_;
                        let _e2129 = phi_4058_;
                        continue;
                        continuing {
                            phi_4639_ = _e2117;
                            phi_1422_ = _e2119;
                            phi_1425_ = _e2121;
                            phi_1427_ = _e2123;
                            phi_1429_ = _e2125;
                            phi_1431_ = _e2127;
                            phi_4818_ = _e2117;
                            break if !(_e2129);
                        }
                    }
                    let _e2132 = phi_4818_;
                    if _e2132 {
                        break;
                    }
                    let _e2134 = local_11;
                    if (_e2134.member.member_3 != 4294967295u) {
                        let _e2139 = bitcast<u32>(_e2134.member.member);
                        let _e2143 = (bitcast<i32>((_e2139 >> bitcast<u32>(23i))) & 255i);
                        let _e2144 = (_e2143 + _e428);
                        if (_e2143 == 255i) {
                            phi_4117_ = _e2134.member.member;
                        } else {
                            if (_e2143 > 0i) {
                                if (_e2144 > 0i) {
                                    let _e2148 = (_e2144 < 255i);
                                    if _e2148 {
                                        phi_4096_ = bitcast<f32>((_e2139 + bitcast<u32>((_e428 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4096_ = f32();
                                    }
                                    let _e2155 = phi_4096_;
                                    phi_4098_ = _e2155;
                                    phi_4099_ = select(true, false, _e2148);
                                } else {
                                    phi_4098_ = f32();
                                    phi_4099_ = true;
                                }
                                let _e2158 = phi_4098_;
                                let _e2160 = phi_4099_;
                                phi_4100_ = _e2158;
                                phi_4101_ = _e2160;
                            } else {
                                phi_4100_ = f32();
                                phi_4101_ = true;
                            }
                            let _e2162 = phi_4100_;
                            let _e2164 = phi_4101_;
                            if _e2164 {
                                let _e2165 = (_e2139 & 2147483648u);
                                let _e2172 = ((_e2139 & 8388607u) | (select(0u, 1u, ((_e2139 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2176 = (_e2172 == 0u);
                                if _e2176 {
                                    phi_4591_ = bitcast<f32>(_e2165);
                                } else {
                                    let _e2181 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2172)), 32u, _e2176) - 8u);
                                    let _e2184 = (_e2172 << bitcast<u32>((_e2181 & 31u)));
                                    let _e2186 = ((_e2144 + select(0i, 1i, (_e2143 == 0i))) - bitcast<i32>(_e2181));
                                    if (_e2186 >= 255i) {
                                        phi_4581_ = bitcast<f32>((_e2165 | 2139095040u));
                                        phi_4582_ = f32();
                                        phi_4583_ = true;
                                    } else {
                                        let _e2188 = (_e2186 > 0i);
                                        if _e2188 {
                                            phi_4575_ = bitcast<f32>(((_e2165 | (bitcast<u32>(_e2186) << bitcast<u32>(23i))) | (_e2184 & 8388607u)));
                                            phi_4576_ = f32();
                                        } else {
                                            if (_e2186 < -24i) {
                                                phi_4541_ = 26u;
                                            } else {
                                                phi_4541_ = bitcast<u32>((1i - _e2186));
                                            }
                                            let _e2193 = phi_4541_;
                                            let _e2194 = (_e2193 & 31u);
                                            let _e2196 = (_e2184 >> bitcast<u32>(_e2194));
                                            let _e2200 = (_e2184 & ((1u << bitcast<u32>(_e2194)) - 1u));
                                            let _e2204 = (1u << bitcast<u32>(((_e2193 - 1u) & 31u)));
                                            if (_e2200 > _e2204) {
                                                phi_4562_ = true;
                                            } else {
                                                if (_e2200 == _e2204) {
                                                    phi_4559_ = ((_e2196 & 1u) == 1u);
                                                } else {
                                                    phi_4559_ = false;
                                                }
                                                let _e2210 = phi_4559_;
                                                phi_4562_ = _e2210;
                                            }
                                            let _e2212 = phi_4562_;
                                            phi_4575_ = f32();
                                            phi_4576_ = bitcast<f32>((_e2165 | (_e2196 + select(0u, 1u, _e2212))));
                                        }
                                        let _e2225 = phi_4575_;
                                        let _e2227 = phi_4576_;
                                        phi_4581_ = _e2225;
                                        phi_4582_ = _e2227;
                                        phi_4583_ = _e2188;
                                    }
                                    let _e2231 = phi_4581_;
                                    let _e2233 = phi_4582_;
                                    let _e2235 = phi_4583_;
                                    phi_4591_ = select(_e2233, _e2231, _e2235);
                                }
                                let _e2239 = phi_4591_;
                                phi_4116_ = _e2239;
                            } else {
                                phi_4116_ = _e2162;
                            }
                            let _e2241 = phi_4116_;
                            phi_4117_ = _e2241;
                        }
                        let _e2243 = phi_4117_;
                        let _e2244 = bitcast<u32>(_e2243);
                        if ((_e2244 & 2147483647u) >= 2139095040u) {
                            phi_4129_ = bitcast<f32>(((_e2244 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4129_ = _e2243;
                        }
                        let _e2251 = phi_4129_;
                        phi_4134_ = type_30(_e2251, _e2134.member.member_1, _e2134.member.member_2, _e2134.member.member_3);
                    } else {
                        phi_4134_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2256 = phi_4134_;
                    if _e305 {
                    } else {
                        break;
                    }
                    global_9.member[_e151] = _e2256;
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e2260 = select(0u, 1u, (_e372 <= _e382));
                    if (_e2260 > 0u) {
                        let _e2262 = (1u < _e119);
                        if _e2262 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e2266 = atomicAdd((&global_10.member[0u]), _e2260);
                            if ((_e2266 + _e2260) < _e2266) {
                                if _e2262 {
                                } else {
                                    break;
                                }
                                let _e2271 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2274 = select(0u, 1u, (_e2256.member_3 != 4294967295u));
                    if (_e2274 > 0u) {
                        let _e2276 = (3u < _e119);
                        if _e2276 {
                            if (2u < _e119) {
                            } else {
                                break;
                            }
                            let _e2280 = atomicAdd((&global_10.member[2u]), _e2274);
                            if ((_e2280 + _e2274) < _e2280) {
                                if _e2276 {
                                } else {
                                    break;
                                }
                                let _e2285 = atomicAdd((&global_10.member[3u]), 1u);
                            }
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
fn trace_paths_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
