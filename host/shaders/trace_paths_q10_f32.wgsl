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
    var phi_436_: u32;
    var phi_480_: i32;
    var phi_620_: type_44;
    var phi_726_: i32;
    var phi_727_: i32;
    var phi_737_: bool;
    var phi_747_: u32;
    var phi_748_: u32;
    var phi_750_: bool;
    var phi_755_: u32;
    var phi_788_: i32;
    var phi_806_: f32;
    var phi_812_: f32;
    var phi_852_: f32;
    var phi_858_: f32;
    var phi_931_: f32;
    var phi_937_: f32;
    var phi_977_: f32;
    var phi_983_: f32;
    var phi_1056_: f32;
    var phi_1062_: f32;
    var phi_1102_: f32;
    var phi_1108_: f32;
    var phi_1227_: i32;
    var phi_1249_: u32;
    var phi_1250_: u32;
    var phi_1287_: i32;
    var phi_1309_: u32;
    var phi_1310_: u32;
    var phi_1318_: f32;
    var phi_1319_: f32;
    var phi_4710_: bool;
    var phi_1415_: type_48;
    var phi_1418_: u32;
    var phi_1420_: bool;
    var phi_1422_: u32;
    var phi_1424_: type_63;
    var phi_1435_: bool;
    var phi_1521_: bool;
    var phi_1522_: u32;
    var phi_1523_: type_63;
    var phi_1541_: type_48;
    var phi_1544_: type_8;
    var phi_1545_: type_8;
    var phi_1567_: type_8;
    var phi_1588_: u32;
    var phi_1680_: array<array<f32, 3>, 3>;
    var phi_4271_: bool;
    var phi_4286_: bool;
    var phi_4301_: bool;
    var phi_4316_: bool;
    var phi_4331_: bool;
    var phi_4346_: bool;
    var phi_2222_: f32;
    var phi_2223_: f32;
    var phi_2224_: f32;
    var phi_2225_: f32;
    var phi_2226_: vec3<f32>;
    var phi_2227_: vec3<f32>;
    var phi_2228_: vec3<f32>;
    var phi_2229_: vec3<f32>;
    var phi_4361_: bool;
    var phi_4376_: bool;
    var phi_4391_: bool;
    var phi_4406_: bool;
    var phi_4421_: bool;
    var phi_4436_: bool;
    var phi_2437_: f32;
    var phi_2457_: type_51;
    var phi_2458_: type_51;
    var phi_2461_: type_51;
    var phi_2462_: type_51;
    var phi_2463_: bool;
    var phi_2467_: type_51;
    var phi_2476_: type_30;
    var phi_2499_: u32;
    var phi_2513_: i32;
    var phi_2535_: vec3<f32>;
    var phi_2536_: vec3<f32>;
    var phi_2554_: vec3<f32>;
    var phi_2555_: vec3<f32>;
    var phi_2573_: vec3<f32>;
    var phi_2574_: vec3<f32>;
    var phi_2610_: vec3<f32>;
    var phi_2792_: f32;
    var phi_2810_: bool;
    var phi_2811_: bool;
    var phi_2830_: bool;
    var phi_2831_: bool;
    var phi_2837_: type_48;
    var phi_2838_: type_48;
    var phi_2839_: type_48;
    var phi_1542_: type_48;
    var phi_4704_: bool;
    var phi_4987_: bool;
    var phi_2840_: type_48;
    var phi_3567_: u32;
    var phi_3568_: u32;
    var phi_3578_: u32;
    var phi_3580_: u32;
    var phi_3581_: bool;
    var phi_3601_: u32;
    var phi_3602_: u32;
    var phi_3606_: type_64;
    var phi_3968_: type_63;
    var phi_4044_: type_63;
    var phi_4045_: u32;
    var phi_4046_: type_63;
    var phi_4048_: u32;
    var phi_4049_: type_63;
    var phi_4050_: bool;
    var phi_4059_: type_63;
    var phi_4064_: bool;
    var phi_4066_: type_63;
    var phi_4070_: bool;
    var phi_4071_: u32;
    var phi_4072_: type_63;
    var phi_4082_: type_63;
    var phi_4904_: bool;
    var phi_4083_: type_48;
    var phi_4084_: u32;
    var phi_4085_: bool;
    var phi_4086_: u32;
    var phi_4087_: type_63;
    var phi_4903_: bool;
    var phi_4088_: type_48;
    var phi_4089_: u32;
    var phi_4090_: bool;
    var phi_4091_: u32;
    var phi_4092_: type_63;
    var phi_4902_: bool;
    var phi_1416_: type_48;
    var phi_1419_: u32;
    var phi_1421_: bool;
    var phi_1423_: u32;
    var phi_1425_: type_63;
    var phi_4093_: bool;
    var phi_4901_: bool;
    var local_10: type_48;
    var phi_4131_: f32;
    var phi_4133_: f32;
    var phi_4134_: bool;
    var phi_4135_: f32;
    var phi_4136_: bool;
    var phi_4612_: u32;
    var phi_4630_: bool;
    var phi_4633_: bool;
    var phi_4646_: f32;
    var phi_4647_: f32;
    var phi_4652_: f32;
    var phi_4653_: f32;
    var phi_4654_: bool;
    var phi_4662_: f32;
    var phi_4151_: f32;
    var phi_4152_: f32;
    var phi_4164_: f32;
    var phi_4169_: type_30;
    var local_11: type_48;

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
                phi_436_ = _e170;
            } else {
                phi_436_ = 4294967295u;
            }
            let _e172 = phi_436_;
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
                phi_480_ = -126i;
            } else {
                phi_480_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_480_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_620_ = type_44(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                let _e233 = bitcast<u32>(_e208);
                let _e235 = ((_e233 & 2139095040u) != 0u);
                let _e250 = bitcast<u32>(_e209);
                let _e252 = ((_e250 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e210);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                let _e285 = bitcast<u32>(_e212);
                let _e287 = ((_e285 & 2139095040u) != 0u);
                phi_620_ = type_44(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e233 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e233 & 2147483648u))), _e208, _e235) * _e225) * select(0.00000011920929f, 1f, _e235)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e209, _e252) * _e225) * select(0.00000011920929f, 1f, _e252)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e210, _e269) * _e225) * select(0.00000011920929f, 1f, _e269)) * _e231)), _e191, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e212, _e287) * _e225) * select(0.00000011920929f, 1f, _e287)) * _e231), _e213);
            }
            let _e304 = phi_620_;
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
                            phi_726_ = (bitcast<i32>((_e391 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_726_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e391)), 32u, (_e391 == 0u))));
                        }
                        let _e405 = phi_726_;
                        phi_727_ = _e405;
                    } else {
                        phi_727_ = 0i;
                    }
                    let _e407 = phi_727_;
                    let _e408 = (_e317 == _e361);
                    if _e408 {
                        phi_737_ = true;
                    } else {
                        phi_737_ = (_e325 == _e361);
                    }
                    let _e411 = phi_737_;
                    let _e412 = select(1u, 0u, _e408);
                    if _e411 {
                        let _e413 = (_e412 + 1u);
                        phi_747_ = _e413;
                        phi_748_ = _e413;
                        phi_750_ = select(true, false, (_e413 == 2u));
                    } else {
                        phi_747_ = u32();
                        phi_748_ = 0u;
                        phi_750_ = true;
                    }
                    let _e417 = phi_747_;
                    let _e419 = phi_748_;
                    let _e421 = phi_750_;
                    if _e421 {
                        phi_755_ = (_e419 + 1u);
                    } else {
                        phi_755_ = 0u;
                    }
                    let _e425 = phi_755_;
                    let _e426 = select(_e417, _e419, _e421);
                    let _e427 = select(_e412, select(2u, _e412, _e411), _e421);
                    let _e428 = -(_e407);
                    if (_e428 < -126i) {
                        phi_788_ = -126i;
                    } else {
                        phi_788_ = select(_e428, 127i, (_e428 > 127i));
                    }
                    let _e433 = phi_788_;
                    let _e438 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                    let _e444 = bitcast<f32>((bitcast<u32>(((_e428 - _e433) + 127i)) << bitcast<u32>(23i)));
                    let _e449 = global_8.member[_e151].member.member;
                    let _e450 = (_e426 == 0u);
                    if _e450 {
                        phi_806_ = _e449[0];
                    } else {
                        phi_806_ = _e449[1];
                    }
                    let _e454 = phi_806_;
                    let _e455 = (_e426 == 2u);
                    if _e455 {
                        phi_812_ = _e449[2];
                    } else {
                        phi_812_ = _e454;
                    }
                    let _e458 = phi_812_;
                    let _e459 = bitcast<u32>(_e458);
                    let _e461 = ((_e459 & 2139095040u) != 0u);
                    let _e473 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e459 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e459 & 2147483648u))), _e458, _e461) * select(0.00000011920929f, 1f, _e461));
                    let _e474 = global_8.member[_e151].member.member_2;
                    if _e450 {
                        phi_852_ = _e474[0];
                    } else {
                        phi_852_ = _e474[1];
                    }
                    let _e478 = phi_852_;
                    if _e455 {
                        phi_858_ = _e474[2];
                    } else {
                        phi_858_ = _e478;
                    }
                    let _e481 = phi_858_;
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
                        phi_931_ = _e449[0];
                    } else {
                        phi_931_ = _e449[1];
                    }
                    let _e519 = phi_931_;
                    let _e520 = (_e425 == 2u);
                    if _e520 {
                        phi_937_ = _e449[2];
                    } else {
                        phi_937_ = _e519;
                    }
                    let _e523 = phi_937_;
                    let _e524 = bitcast<u32>(_e523);
                    let _e526 = ((_e524 & 2139095040u) != 0u);
                    let _e538 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e524 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e524 & 2147483648u))), _e523, _e526) * select(0.00000011920929f, 1f, _e526));
                    if _e515 {
                        phi_977_ = _e474[0];
                    } else {
                        phi_977_ = _e474[1];
                    }
                    let _e542 = phi_977_;
                    if _e520 {
                        phi_983_ = _e474[2];
                    } else {
                        phi_983_ = _e542;
                    }
                    let _e545 = phi_983_;
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
                        phi_1056_ = _e449[0];
                    } else {
                        phi_1056_ = _e449[1];
                    }
                    let _e583 = phi_1056_;
                    let _e584 = (_e427 == 2u);
                    if _e584 {
                        phi_1062_ = _e449[2];
                    } else {
                        phi_1062_ = _e583;
                    }
                    let _e587 = phi_1062_;
                    let _e588 = bitcast<u32>(_e587);
                    let _e590 = ((_e588 & 2139095040u) != 0u);
                    let _e602 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e588 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e588 & 2147483648u))), _e587, _e590) * select(0.00000011920929f, 1f, _e590));
                    if _e579 {
                        phi_1102_ = _e474[0];
                    } else {
                        phi_1102_ = _e474[1];
                    }
                    let _e606 = phi_1102_;
                    if _e584 {
                        phi_1108_ = _e474[2];
                    } else {
                        phi_1108_ = _e606;
                    }
                    let _e609 = phi_1108_;
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
                            phi_1227_ = 255i;
                        } else {
                            phi_1227_ = (((_e659 + select(0i, 1i, (_e659 == 0i))) - _e666) + _e407);
                        }
                        let _e674 = phi_1227_;
                        let _e684 = (_e674 <= 0i);
                        if _e684 {
                            phi_1250_ = u32();
                        } else {
                            if _e663 {
                                phi_1249_ = u32();
                            } else {
                                phi_1249_ = select(((bitcast<u32>(_e674) << bitcast<u32>(23i)) | ((_e656 << bitcast<u32>(((_e666 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e674 >= 255i));
                            }
                            let _e688 = phi_1249_;
                            phi_1250_ = _e688;
                        }
                        let _e690 = phi_1250_;
                        let _e702 = ((_e384 & 8388607u) | (select(0u, 1u, ((_e384 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e705 = bitcast<i32>((_e384 >> bitcast<u32>(23i)));
                        let _e709 = (_e702 == 0u);
                        let _e712 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e702)), 32u, _e709)) - 8i);
                        if (_e705 == 255i) {
                            phi_1287_ = 255i;
                        } else {
                            phi_1287_ = (((_e705 + select(0i, 1i, (_e705 == 0i))) - _e712) + _e407);
                        }
                        let _e720 = phi_1287_;
                        let _e730 = (_e720 <= 0i);
                        if _e730 {
                            phi_1310_ = u32();
                        } else {
                            if _e709 {
                                phi_1309_ = u32();
                            } else {
                                phi_1309_ = select(((bitcast<u32>(_e720) << bitcast<u32>(23i)) | ((_e702 << bitcast<u32>(((_e712 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e720 >= 255i));
                            }
                            let _e734 = phi_1309_;
                            phi_1310_ = _e734;
                        }
                        let _e736 = phi_1310_;
                        phi_1318_ = bitcast<f32>(((_e383 & 2147483648u) | select(_e736, 0u, select(_e709, true, _e730))));
                        phi_1319_ = bitcast<f32>(((_e373 & 2147483648u) | select(_e690, 0u, select(_e663, true, _e684))));
                    } else {
                        phi_1318_ = 0f;
                        phi_1319_ = 1f;
                    }
                    let _e742 = phi_1318_;
                    let _e744 = phi_1319_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e748 = (_e426 % 3u);
                    let _e749 = (_e748 < 3u);
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e751 = local_1[_e748];
                    let _e754 = (_e425 % 3u);
                    let _e755 = (_e754 < 3u);
                    if _e755 {
                    } else {
                        break;
                    }
                    let _e757 = local_1[_e754];
                    let _e760 = (_e427 % 3u);
                    let _e761 = (_e760 < 3u);
                    if _e761 {
                    } else {
                        break;
                    }
                    let _e763 = local_1[_e760];
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e768 = local[_e748];
                    if _e755 {
                    } else {
                        break;
                    }
                    let _e772 = local[_e754];
                    if _e761 {
                    } else {
                        break;
                    }
                    let _e776 = local[_e760];
                    phi_4710_ = false;
                    phi_1415_ = type_48(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e742);
                    phi_1418_ = ((3u * _e105) + 1u);
                    phi_1420_ = (_e744 <= _e742);
                    phi_1422_ = 0u;
                    phi_1424_ = type_63(type_42(vec4<f32>((f32(_e751) * _e163), (f32(_e757) * _e163), (f32(_e763) * _e163), 0f), vec4<f32>((f32(_e768) * _e163), (f32(_e772) * _e163), (f32(_e776) * _e163), 0f)), select(0u, 2147483648u, (_e105 == 0u)));
                    loop {
                        let _e786 = phi_4710_;
                        let _e788 = phi_1415_;
                        let _e790 = phi_1418_;
                        let _e792 = phi_1420_;
                        let _e794 = phi_1422_;
                        let _e796 = phi_1424_;
                        local_10 = _e788;
                        if _e792 {
                            phi_1435_ = true;
                        } else {
                            phi_1435_ = (_e794 > 0u);
                        }
                        let _e799 = phi_1435_;
                        if _e799 {
                            let _e800 = (_e790 > 0u);
                            if _e800 {
                                if _e792 {
                                    phi_1521_ = _e792;
                                    phi_1522_ = _e794;
                                    phi_1523_ = _e796;
                                } else {
                                    let _e801 = (_e794 - 1u);
                                    let _e802 = (_e801 % 128u);
                                    let _e803 = (_e802 < 128u);
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e805 = local_7[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e807 = local_6[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e809 = local_5[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e811 = local_4[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e813 = local_3[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e815 = local_2[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e820 = local_8[_e802];
                                    if _e803 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e823 = local_9[_e802];
                                    phi_1521_ = (_e823 <= _e788.member_1);
                                    phi_1522_ = _e801;
                                    phi_1523_ = type_63(type_42(vec4<f32>(_e805, _e807, _e809, 0f), vec4<f32>(_e811, _e813, _e815, 0f)), _e820);
                                }
                                let _e827 = phi_1521_;
                                let _e829 = phi_1522_;
                                let _e831 = phi_1523_;
                                if _e827 {
                                    let _e835 = ((_e831.member_1 & 2147483648u) != 0u);
                                    if _e835 {
                                        phi_1541_ = _e788;
                                        phi_1544_ = type_8(0u, ((_e831.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e842 = phi_1541_;
                                            let _e844 = phi_1544_;
                                            local_11 = _e842;
                                            if (_e844.member < _e844.member_1) {
                                                phi_1545_ = type_8((_e844.member + 1u), _e844.member_1);
                                                phi_1567_ = type_8(1u, _e844.member);
                                            } else {
                                                phi_1545_ = _e844;
                                                phi_1567_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e857 = phi_1545_;
                                            let _e859 = phi_1567_;
                                            let _e863 = (bitcast<i32>(_e859.member) != 0i);
                                            if _e863 {
                                                let _e864 = ((_e831.member_1 & 268435455u) + _e859.member_1);
                                                let _e865 = (_e864 < _e107);
                                                if _e865 {
                                                    if _e865 {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e869 = global_5.member[_e864].member_1;
                                                    phi_1588_ = _e869;
                                                } else {
                                                    phi_1588_ = 4294967295u;
                                                }
                                                let _e871 = phi_1588_;
                                                if (_e864 >= _e107) {
                                                    phi_1680_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e865 {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    if (_e748 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e878 = global_5.member[_e864].member[_e748];
                                                    if (_e754 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_5.member[_e864].member[_e754];
                                                    if (_e760 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_5.member[_e864].member[_e760];
                                                    let _e892 = (3u + _e748);
                                                    if (_e892 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e898 = global_5.member[_e864].member[_e892];
                                                    let _e899 = (3u + _e754);
                                                    if (_e899 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e905 = global_5.member[_e864].member[_e899];
                                                    let _e906 = (3u + _e760);
                                                    if (_e906 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e912 = global_5.member[_e864].member[_e906];
                                                    let _e914 = (6u + _e748);
                                                    if (_e914 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e920 = global_5.member[_e864].member[_e914];
                                                    let _e921 = (6u + _e754);
                                                    if (_e921 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e927 = global_5.member[_e864].member[_e921];
                                                    let _e928 = (6u + _e760);
                                                    if (_e928 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e934 = global_5.member[_e864].member[_e928];
                                                    phi_1680_ = array<array<f32, 3>, 3>(array<f32, 3>(_e878, _e884, _e890), array<f32, 3>(_e898, _e905, _e912), array<f32, 3>(_e920, _e927, _e934));
                                                }
                                                let _e938 = phi_1680_;
                                                let _e954 = (_e938[0][2] - _e602);
                                                let _e957 = (((_e938[0][0] - _e473) * _e638) - (_e954 * _e510));
                                                let _e960 = (((_e938[0][1] - _e538) * _e638) - (_e954 * _e574));
                                                let _e963 = (_e938[1][2] - _e602);
                                                let _e966 = (((_e938[1][0] - _e473) * _e638) - (_e963 * _e510));
                                                let _e969 = (((_e938[1][1] - _e538) * _e638) - (_e963 * _e574));
                                                let _e972 = (_e938[2][2] - _e602);
                                                let _e975 = (((_e938[2][0] - _e473) * _e638) - (_e972 * _e510));
                                                let _e978 = (((_e938[2][1] - _e538) * _e638) - (_e972 * _e574));
                                                let _e979 = (_e975 * _e969);
                                                let _e980 = (_e978 * _e966);
                                                let _e981 = (_e957 * _e978);
                                                let _e982 = (_e960 * _e975);
                                                let _e983 = (_e966 * _e960);
                                                let _e984 = (_e969 * _e957);
                                                let _e989 = (((_e979 >= _e980) && (_e981 >= _e982)) && (_e983 >= _e984));
                                                let _e995 = (_e989 || (((_e979 <= _e980) && (_e981 <= _e982)) && (_e983 <= _e984)));
                                                if _e995 {
                                                    let _e997 = select(-1f, 1f, _e989);
                                                    let _e999 = ((_e979 - _e980) * _e997);
                                                    let _e1001 = select(0f, _e999, (_e999 > 0f));
                                                    let _e1003 = ((_e981 - _e982) * _e997);
                                                    let _e1005 = select(0f, _e1003, (_e1003 > 0f));
                                                    let _e1007 = ((_e983 - _e984) * _e997);
                                                    let _e1009 = select(0f, _e1007, (_e1007 > 0f));
                                                    let _e1011 = ((_e1001 + _e1005) + _e1009);
                                                    let _e1013 = select(_e938[1][0], _e938[0][0], (_e938[0][0] < _e938[1][0]));
                                                    let _e1017 = select(_e938[1][0], _e938[0][0], (_e938[0][0] > _e938[1][0]));
                                                    let _e1021 = select(_e938[1][1], _e938[0][1], (_e938[0][1] < _e938[1][1]));
                                                    let _e1025 = select(_e938[1][1], _e938[0][1], (_e938[0][1] > _e938[1][1]));
                                                    let _e1029 = select(_e938[1][2], _e938[0][2], (_e938[0][2] < _e938[1][2]));
                                                    let _e1033 = select(_e938[1][2], _e938[0][2], (_e938[0][2] > _e938[1][2]));
                                                    let _e1038 = ((select(_e938[2][0], _e1013, (_e1013 < _e938[2][0])) - _e511) * _e514);
                                                    let _e1039 = ((select(_e938[2][0], _e1017, (_e1017 > _e938[2][0])) - _e512) * _e514);
                                                    let _e1042 = ((select(_e938[2][1], _e1021, (_e1021 < _e938[2][1])) - _e575) * _e578);
                                                    let _e1043 = ((select(_e938[2][1], _e1025, (_e1025 > _e938[2][1])) - _e576) * _e578);
                                                    let _e1046 = ((select(_e938[2][2], _e1029, (_e1029 < _e938[2][2])) - _e639) * _e642);
                                                    let _e1047 = ((select(_e938[2][2], _e1033, (_e1033 > _e938[2][2])) - _e640) * _e642);
                                                    let _e1049 = select(_e1047, _e1046, (_e1046 < _e1047));
                                                    let _e1051 = select(_e1047, _e1046, (_e1046 > _e1047));
                                                    let _e1053 = select(_e1039, _e1038, (_e1038 < _e1039));
                                                    let _e1055 = select(_e1043, _e1042, (_e1042 < _e1043));
                                                    let _e1057 = select(_e1055, _e1053, (_e1053 > _e1055));
                                                    let _e1059 = select(_e1049, _e1057, (_e1057 > _e1049));
                                                    let _e1061 = select(_e1039, _e1038, (_e1038 > _e1039));
                                                    let _e1063 = select(_e1043, _e1042, (_e1042 > _e1043));
                                                    let _e1065 = select(_e1063, _e1061, (_e1061 < _e1063));
                                                    let _e1067 = select(_e1051, _e1065, (_e1065 < _e1051));
                                                    let _e1068 = -(_e1049);
                                                    let _e1074 = select(_e744, _e1059, (_e1059 > _e744));
                                                    let _e1078 = select(_e966, _e957, (_e957 < _e966));
                                                    let _e1083 = select(_e966, _e957, (_e957 > _e966));
                                                    let _e1090 = select(_e969, _e960, (_e960 < _e969));
                                                    let _e1095 = select(_e969, _e960, (_e960 > _e969));
                                                    let _e1104 = (((((_e995 && (_e1011 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e975, _e1078, (_e1078 < _e975)) <= 0f) && (select(_e975, _e1083, (_e1083 > _e975)) >= 0f))) && ((select(_e978, _e1090, (_e1090 < _e978)) <= 0f) && (select(_e978, _e1095, (_e1095 > _e978)) >= 0f))) && (_e1074 <= (_e1067 + (select(_e1068, _e1051, (_e1051 > _e1068)) * 0.0000019073523f)))) && (_e1074 <= _e842.member_1));
                                                    if _e1104 {
                                                        let _e1109 = (_e938[1][0] - _e938[0][0]);
                                                        let _e1110 = (_e938[1][1] - _e938[0][1]);
                                                        let _e1111 = (_e938[1][2] - _e938[0][2]);
                                                        let _e1112 = vec3<f32>(_e1109, _e1110, _e1111);
                                                        let _e1113 = (_e938[2][0] - _e938[1][0]);
                                                        let _e1114 = (_e938[2][1] - _e938[1][1]);
                                                        let _e1115 = (_e938[2][2] - _e938[1][2]);
                                                        let _e1116 = vec3<f32>(_e1113, _e1114, _e1115);
                                                        let _e1117 = (_e938[0][0] - _e938[2][0]);
                                                        let _e1118 = (_e938[0][1] - _e938[2][1]);
                                                        let _e1119 = (_e938[0][2] - _e938[2][2]);
                                                        let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                                        let _e1121 = abs(_e1109);
                                                        let _e1122 = abs(_e1110);
                                                        if (_e1121 != _e1121) {
                                                            phi_4271_ = true;
                                                        } else {
                                                            phi_4271_ = (_e1122 >= _e1121);
                                                        }
                                                        let _e1126 = phi_4271_;
                                                        let _e1127 = select(_e1121, _e1122, _e1126);
                                                        let _e1128 = abs(_e1111);
                                                        if (_e1127 != _e1127) {
                                                            phi_4286_ = true;
                                                        } else {
                                                            phi_4286_ = (_e1128 >= _e1127);
                                                        }
                                                        let _e1132 = phi_4286_;
                                                        let _e1133 = select(_e1127, _e1128, _e1132);
                                                        let _e1134 = abs(_e1113);
                                                        let _e1135 = abs(_e1114);
                                                        if (_e1134 != _e1134) {
                                                            phi_4301_ = true;
                                                        } else {
                                                            phi_4301_ = (_e1135 >= _e1134);
                                                        }
                                                        let _e1139 = phi_4301_;
                                                        let _e1140 = select(_e1134, _e1135, _e1139);
                                                        let _e1141 = abs(_e1115);
                                                        if (_e1140 != _e1140) {
                                                            phi_4316_ = true;
                                                        } else {
                                                            phi_4316_ = (_e1141 >= _e1140);
                                                        }
                                                        let _e1145 = phi_4316_;
                                                        let _e1146 = select(_e1140, _e1141, _e1145);
                                                        let _e1147 = abs(_e1117);
                                                        let _e1148 = abs(_e1118);
                                                        if (_e1147 != _e1147) {
                                                            phi_4331_ = true;
                                                        } else {
                                                            phi_4331_ = (_e1148 >= _e1147);
                                                        }
                                                        let _e1152 = phi_4331_;
                                                        let _e1153 = select(_e1147, _e1148, _e1152);
                                                        let _e1154 = abs(_e1119);
                                                        if (_e1153 != _e1153) {
                                                            phi_4346_ = true;
                                                        } else {
                                                            phi_4346_ = (_e1154 >= _e1153);
                                                        }
                                                        let _e1158 = phi_4346_;
                                                        let _e1159 = select(_e1153, _e1154, _e1158);
                                                        let _e1161 = select(_e1146, _e1133, (_e1133 > _e1146));
                                                        let _e1163 = select(_e1159, _e1161, (_e1161 > _e1159));
                                                        if (_e1133 == _e1163) {
                                                            phi_2222_ = _e969;
                                                            phi_2223_ = _e966;
                                                            phi_2224_ = _e960;
                                                            phi_2225_ = _e957;
                                                            phi_2226_ = vec3<f32>(_e938[0][0], _e938[0][1], _e938[0][2]);
                                                            phi_2227_ = _e1120;
                                                            phi_2228_ = _e1116;
                                                            phi_2229_ = _e1112;
                                                        } else {
                                                            let _e1165 = (_e1146 == _e1163);
                                                            let _e1170 = vec3(_e1165);
                                                            phi_2222_ = select(_e960, _e978, _e1165);
                                                            phi_2223_ = select(_e957, _e975, _e1165);
                                                            phi_2224_ = select(_e978, _e969, _e1165);
                                                            phi_2225_ = select(_e975, _e966, _e1165);
                                                            phi_2226_ = select(vec3<f32>(_e938[2][0], _e938[2][1], _e938[2][2]), vec3<f32>(_e938[1][0], _e938[1][1], _e938[1][2]), _e1170);
                                                            phi_2227_ = select(_e1116, _e1112, _e1170);
                                                            phi_2228_ = select(_e1112, _e1120, _e1170);
                                                            phi_2229_ = select(_e1120, _e1116, _e1170);
                                                        }
                                                        let _e1176 = phi_2222_;
                                                        let _e1178 = phi_2223_;
                                                        let _e1180 = phi_2224_;
                                                        let _e1182 = phi_2225_;
                                                        let _e1184 = phi_2226_;
                                                        let _e1186 = phi_2227_;
                                                        let _e1188 = phi_2228_;
                                                        let _e1190 = phi_2229_;
                                                        let _e1197 = ((_e1188.y * _e1186.z) - (_e1186.y * _e1188.z));
                                                        let _e1202 = ((_e1188.z * _e1186.x) - (_e1186.z * _e1188.x));
                                                        let _e1205 = ((_e1188.x * _e1186.y) - (_e1186.x * _e1188.y));
                                                        let _e1208 = ((_e1001 >= _e1005) && (_e1001 >= _e1009));
                                                        let _e1209 = (_e1005 >= _e1009);
                                                        let _e1223 = (((_e1197 * (select(select(_e938[2][0], _e938[1][0], _e1209), _e938[0][0], _e1208) - _e473)) + (_e1202 * (select(select(_e938[2][1], _e938[1][1], _e1209), _e938[0][1], _e1208) - _e538))) + (_e1205 * (select(select(_e938[2][2], _e938[1][2], _e1209), _e938[0][2], _e1208) - _e602)));
                                                        let _e1228 = (((_e1197 * _e510) + (_e1202 * _e574)) + (_e1205 * _e638));
                                                        let _e1229 = (_e1178 - _e1182);
                                                        let _e1230 = (_e1176 - _e1180);
                                                        let _e1233 = ((_e1229 * _e1229) + (_e1230 * _e1230));
                                                        let _e1240 = (-(((_e1182 * _e1229) + (_e1180 * _e1230))) / select(0.000000000000000000000000000000000000011754944f, _e1233, (_e1233 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1242 = select(1f, _e1240, (_e1240 < 1f));
                                                        let _e1244 = select(0f, _e1242, (_e1242 > 0f));
                                                        let _e1253 = ((_e1184.x + (_e1190.x * _e1244)) - _e473);
                                                        let _e1256 = ((_e1184.y + (_e1190.y * _e1244)) - _e538);
                                                        let _e1259 = ((_e1184.z + (_e1190.z * _e1244)) - _e602);
                                                        let _e1262 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                        let _e1265 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                        let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                        let _e1270 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                        let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                                                        let _e1276 = abs(_e1197);
                                                        let _e1277 = abs(_e1202);
                                                        if (_e1276 != _e1276) {
                                                            phi_4361_ = true;
                                                        } else {
                                                            phi_4361_ = (_e1277 >= _e1276);
                                                        }
                                                        let _e1281 = phi_4361_;
                                                        let _e1282 = select(_e1276, _e1277, _e1281);
                                                        let _e1283 = abs(_e1205);
                                                        if (_e1282 != _e1282) {
                                                            phi_4376_ = true;
                                                        } else {
                                                            phi_4376_ = (_e1283 >= _e1282);
                                                        }
                                                        let _e1287 = phi_4376_;
                                                        let _e1303 = abs(_e1188.x);
                                                        let _e1304 = abs(_e1188.y);
                                                        if (_e1303 != _e1303) {
                                                            phi_4391_ = true;
                                                        } else {
                                                            phi_4391_ = (_e1304 >= _e1303);
                                                        }
                                                        let _e1308 = phi_4391_;
                                                        let _e1309 = select(_e1303, _e1304, _e1308);
                                                        let _e1310 = abs(_e1188.z);
                                                        if (_e1309 != _e1309) {
                                                            phi_4406_ = true;
                                                        } else {
                                                            phi_4406_ = (_e1310 >= _e1309);
                                                        }
                                                        let _e1314 = phi_4406_;
                                                        let _e1317 = abs(_e1186.x);
                                                        let _e1318 = abs(_e1186.y);
                                                        if (_e1317 != _e1317) {
                                                            phi_4421_ = true;
                                                        } else {
                                                            phi_4421_ = (_e1318 >= _e1317);
                                                        }
                                                        let _e1322 = phi_4421_;
                                                        let _e1323 = select(_e1317, _e1318, _e1322);
                                                        let _e1324 = abs(_e1186.z);
                                                        if (_e1323 != _e1323) {
                                                            phi_4436_ = true;
                                                        } else {
                                                            phi_4436_ = (_e1324 >= _e1323);
                                                        }
                                                        let _e1328 = phi_4436_;
                                                        let _e1333 = ((bitcast<f32>((bitcast<u32>(((((_e1197 * _e1253) + (_e1202 * _e1256)) + (_e1205 * _e1259)) - _e1223)) & 2147483647u)) <= ((0.0000009536743f * select(_e1163, _e1272, (_e1272 > _e1163))) * select(_e1282, _e1283, _e1287))) && !((bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u)) <= ((0.0000038146973f * select(_e1309, _e1310, _e1314)) * select(_e1323, _e1324, _e1328)))));
                                                        let _e1334 = (_e1223 / _e1228);
                                                        if (_e1104 && !(_e1333)) {
                                                            let _e1337 = (_e1259 / _e638);
                                                            let _e1345 = (((_e1197 * (_e1253 - (_e510 * _e1337))) + (_e1202 * (_e1256 - (_e574 * _e1337)))) / _e1228);
                                                            phi_2437_ = select(select(_e1337, (_e1337 + _e1345), (bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u)) <= _e1163)), _e1334, _e1333);
                                                        } else {
                                                            phi_2437_ = _e1334;
                                                        }
                                                        let _e1354 = phi_2437_;
                                                        let _e1356 = select(_e1067, _e1354, (_e1354 < _e1067));
                                                        let _e1358 = select(_e1059, _e1356, (_e1356 > _e1059));
                                                        let _e1359 = (1f / _e1011);
                                                        phi_2457_ = type_51(_e1358, (_e1005 * _e1359), (_e1009 * _e1359), ((_e1104 && (_e1358 >= _e744)) && (_e1358 <= _e842.member_1)));
                                                        phi_2458_ = type_51();
                                                    } else {
                                                        phi_2457_ = type_51();
                                                        phi_2458_ = type_51(0f, 0f, 0f, _e1104);
                                                    }
                                                    let _e1368 = phi_2457_;
                                                    let _e1370 = phi_2458_;
                                                    phi_2461_ = _e1368;
                                                    phi_2462_ = _e1370;
                                                    phi_2463_ = select(true, false, _e1104);
                                                } else {
                                                    phi_2461_ = type_51();
                                                    phi_2462_ = type_51(0f, 0f, 0f, _e995);
                                                    phi_2463_ = true;
                                                }
                                                let _e1373 = phi_2461_;
                                                let _e1375 = phi_2462_;
                                                let _e1377 = phi_2463_;
                                                if _e1377 {
                                                    phi_2467_ = _e1375;
                                                } else {
                                                    phi_2467_ = _e1373;
                                                }
                                                let _e1379 = phi_2467_;
                                                if _e1379.member_3 {
                                                    phi_2476_ = type_30(_e1379.member, _e1379.member_1, _e1379.member_2, _e871);
                                                } else {
                                                    phi_2476_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1386 = phi_2476_;
                                                if (_e1386.member_3 != 4294967295u) {
                                                    if (_e871 == _e172) {
                                                        phi_2811_ = false;
                                                    } else {
                                                        let _e1390 = (_e871 < arrayLength((&global_6.member)));
                                                        if _e1390 {
                                                            if _e1390 {
                                                            } else {
                                                                phi_4704_ = true;
                                                                break;
                                                            }
                                                            let _e1392 = global_6.member[_e871];
                                                            phi_2499_ = _e1392;
                                                        } else {
                                                            phi_2499_ = 4294967295u;
                                                        }
                                                        let _e1394 = phi_2499_;
                                                        let _e1395 = (_e1394 < arrayLength((&global_7.member)));
                                                        if _e1395 {
                                                            if _e1395 {
                                                            } else {
                                                                phi_4704_ = true;
                                                                break;
                                                            }
                                                            let _e1397 = global_7.member[_e1394];
                                                            phi_2513_ = _e1397;
                                                        } else {
                                                            phi_2513_ = 0i;
                                                        }
                                                        let _e1399 = phi_2513_;
                                                        let _e1400 = (_e1399 == 0i);
                                                        if _e1400 {
                                                            phi_2810_ = true;
                                                        } else {
                                                            if _e450 {
                                                                phi_2536_ = vec3<f32>(_e938[0][0], _e938[0][1], _e938[0][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2535_ = vec3<f32>(_e938[0][2], _e938[0][0], _e938[0][1]);
                                                                } else {
                                                                    phi_2535_ = vec3<f32>(_e938[0][1], _e938[0][2], _e938[0][0]);
                                                                }
                                                                let _e1405 = phi_2535_;
                                                                phi_2536_ = _e1405;
                                                            }
                                                            let _e1408 = phi_2536_;
                                                            if _e450 {
                                                                phi_2555_ = vec3<f32>(_e938[1][0], _e938[1][1], _e938[1][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2554_ = vec3<f32>(_e938[1][2], _e938[1][0], _e938[1][1]);
                                                                } else {
                                                                    phi_2554_ = vec3<f32>(_e938[1][1], _e938[1][2], _e938[1][0]);
                                                                }
                                                                let _e1413 = phi_2554_;
                                                                phi_2555_ = _e1413;
                                                            }
                                                            let _e1416 = phi_2555_;
                                                            if _e450 {
                                                                phi_2574_ = vec3<f32>(_e938[2][0], _e938[2][1], _e938[2][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2573_ = vec3<f32>(_e938[2][2], _e938[2][0], _e938[2][1]);
                                                                } else {
                                                                    phi_2573_ = vec3<f32>(_e938[2][1], _e938[2][2], _e938[2][0]);
                                                                }
                                                                let _e1421 = phi_2573_;
                                                                phi_2574_ = _e1421;
                                                            }
                                                            let _e1424 = phi_2574_;
                                                            let _e1427 = (_e1416.x - _e1408.x);
                                                            let _e1430 = (_e1416.y - _e1408.y);
                                                            let _e1433 = (_e1416.z - _e1408.z);
                                                            let _e1435 = (_e1424.x - _e1408.x);
                                                            let _e1437 = (_e1424.y - _e1408.y);
                                                            let _e1439 = (_e1424.z - _e1408.z);
                                                            if (_e304.member_1 == 1u) {
                                                                phi_2610_ = (vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]) - _e1408);
                                                            } else {
                                                                phi_2610_ = vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]);
                                                            }
                                                            let _e1454 = phi_2610_;
                                                            let _e1460 = bitcast<f32>((bitcast<u32>((_e1427 * _e1437)) ^ _e304.member_3[0]));
                                                            let _e1464 = bitcast<f32>((bitcast<u32>((_e1430 * _e1435)) ^ _e304.member_3[0]));
                                                            let _e1468 = bitcast<f32>((bitcast<u32>((_e1430 * _e1439)) ^ _e304.member_3[0]));
                                                            let _e1472 = bitcast<f32>((bitcast<u32>((_e1433 * _e1437)) ^ _e304.member_3[0]));
                                                            let _e1476 = bitcast<f32>((bitcast<u32>((_e1433 * _e1435)) ^ _e304.member_3[0]));
                                                            let _e1480 = bitcast<f32>((bitcast<u32>((_e1427 * _e1439)) ^ _e304.member_3[0]));
                                                            let _e1481 = (_e1468 - _e1472);
                                                            let _e1482 = (_e1476 - _e1480);
                                                            let _e1483 = (_e1460 - _e1464);
                                                            let _e1507 = (bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u)));
                                                            let _e1514 = (bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u)));
                                                            let _e1521 = (bitcast<f32>((bitcast<u32>(_e1460) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u)));
                                                            if (_e304.member_2 == 0f) {
                                                                phi_2792_ = 0f;
                                                            } else {
                                                                let _e1551 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                let _e1554 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                                let _e1557 = bitcast<f32>((bitcast<u32>(_e1483) & 2147483647u));
                                                                let _e1559 = select(_e1557, _e1554, (_e1554 > _e1557));
                                                                let _e1563 = select(_e1557, _e1554, (_e1554 < _e1557));
                                                                let _e1567 = select(_e1554, _e1551, (_e1551 < _e1554));
                                                                let _e1569 = select(_e1554, _e1551, (_e1551 > _e1554));
                                                                let _e1571 = select(_e1557, _e1569, (_e1569 < _e1557));
                                                                phi_2792_ = bitcast<f32>((bitcast<u32>((_e304.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1559, _e1551, (_e1551 > _e1559)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1571, _e1567, (_e1567 > _e1571)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1563, _e1551, (_e1551 < _e1563)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1507 + _e1514) + _e1521))) ^ _e304.member_3[0]))) * 1.0000005f)) ^ _e304.member_3[0])))) ^ _e304.member_3[0]));
                                                            }
                                                            let _e1598 = phi_2792_;
                                                            phi_2810_ = (_e1400 || !(((((bitcast<f32>((bitcast<u32>((_e1454.x * _e1481)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1454.y * _e1482)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1454.z * _e1483)) ^ _e304.member_3[0]))) * f32(-(_e1399))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1454.x) & 2147483647u)) * _e1507)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1454.y) & 2147483647u)) * _e1514)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1454.z) & 2147483647u)) * _e1521)) ^ _e304.member_3[0]))))) ^ _e304.member_3[0])) + _e1598) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1612 = phi_2810_;
                                                        phi_2811_ = _e1612;
                                                    }
                                                    let _e1614 = phi_2811_;
                                                    if _e1614 {
                                                        if (_e1386.member < _e842.member.member) {
                                                            phi_2831_ = true;
                                                        } else {
                                                            if (_e1386.member == _e842.member.member) {
                                                                phi_2830_ = (_e1386.member_3 < _e842.member.member_3);
                                                            } else {
                                                                phi_2830_ = false;
                                                            }
                                                            let _e1624 = phi_2830_;
                                                            phi_2831_ = _e1624;
                                                        }
                                                        let _e1626 = phi_2831_;
                                                        if _e1626 {
                                                            phi_2837_ = type_48(_e1386, _e1386.member);
                                                        } else {
                                                            phi_2837_ = _e842;
                                                        }
                                                        let _e1629 = phi_2837_;
                                                        phi_2838_ = _e1629;
                                                    } else {
                                                        phi_2838_ = _e842;
                                                    }
                                                    let _e1631 = phi_2838_;
                                                    phi_2839_ = _e1631;
                                                } else {
                                                    phi_2839_ = _e842;
                                                }
                                                let _e1633 = phi_2839_;
                                                phi_1542_ = _e1633;
                                            } else {
                                                phi_1542_ = type_48();
                                            }
                                            let _e1635 = phi_1542_;
                                            continue;
                                            continuing {
                                                phi_1541_ = _e1635;
                                                phi_1544_ = _e857;
                                                phi_4704_ = _e786;
                                                break if !(_e863);
                                            }
                                        }
                                        let _e1638 = phi_4704_;
                                        phi_4901_ = _e1638;
                                        if _e1638 {
                                            break;
                                        }
                                        phi_4987_ = _e1638;
                                        let _e2382 = local_11;
                                        phi_2840_ = _e2382;
                                    } else {
                                        phi_4987_ = _e786;
                                        phi_2840_ = _e788;
                                    }
                                    let _e1640 = phi_4987_;
                                    let _e1642 = phi_2840_;
                                    if _e835 {
                                        phi_4070_ = bool();
                                        phi_4071_ = u32();
                                        phi_4072_ = type_63();
                                    } else {
                                        if (_e831.member_1 >= _e105) {
                                            phi_3606_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e831.member_1 < _e105) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1646 = ((1u + _e426) % 4u);
                                            if (_e1646 < 4u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1651 = global_4.member[_e831.member_1][_e1646];
                                            let _e1653 = (_e1651 >> bitcast<u32>(11u));
                                            let _e1655 = ((1u + _e425) % 4u);
                                            if (_e1655 < 4u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1660 = global_4.member[_e831.member_1][_e1655];
                                            let _e1662 = (_e1660 >> bitcast<u32>(11u));
                                            let _e1664 = ((1u + _e427) % 4u);
                                            if (_e1664 < 4u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1669 = global_4.member[_e831.member_1][_e1664];
                                            let _e1671 = (_e1669 >> bitcast<u32>(11u));
                                            let _e1694 = (bitcast<f32>((bitcast<u32>((_e831.member.member_1.x - _e831.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1695 = (bitcast<f32>((bitcast<u32>((_e831.member.member_1.y - _e831.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1696 = (bitcast<f32>((bitcast<u32>((_e831.member.member_1.z - _e831.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1698 = select(_e163, _e1694, (_e1694 > _e163));
                                            let _e1700 = select(_e163, _e1695, (_e1695 > _e163));
                                            let _e1702 = select(_e163, _e1696, (_e1696 > _e163));
                                            let _e1733 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1651 & 1023u))) - 8388608f) * _e1698));
                                            let _e1738 = (bitcast<i32>((_e1651 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1741 = bitcast<f32>((_e1733 & bitcast<u32>(_e1738)));
                                            let _e1742 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1660 & 1023u))) - 8388608f) * _e1700));
                                            let _e1747 = (bitcast<i32>((_e1660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1750 = bitcast<f32>((_e1742 & bitcast<u32>(_e1747)));
                                            let _e1751 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1669 & 1023u))) - 8388608f) * _e1702));
                                            let _e1756 = (bitcast<i32>((_e1669 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1759 = bitcast<f32>((_e1751 & bitcast<u32>(_e1756)));
                                            let _e1763 = bitcast<f32>((_e1733 & bitcast<u32>(~(_e1738))));
                                            let _e1767 = bitcast<f32>((_e1742 & bitcast<u32>(~(_e1747))));
                                            let _e1771 = bitcast<f32>((_e1751 & bitcast<u32>(~(_e1756))));
                                            let _e1772 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1653 & 1023u))) - 8388608f) * _e1698));
                                            let _e1777 = (bitcast<i32>((_e1653 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1780 = bitcast<f32>((_e1772 & bitcast<u32>(_e1777)));
                                            let _e1781 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1662 & 1023u))) - 8388608f) * _e1700));
                                            let _e1786 = (bitcast<i32>((_e1662 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1789 = bitcast<f32>((_e1781 & bitcast<u32>(_e1786)));
                                            let _e1790 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1671 & 1023u))) - 8388608f) * _e1702));
                                            let _e1795 = (bitcast<i32>((_e1671 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1798 = bitcast<f32>((_e1790 & bitcast<u32>(_e1795)));
                                            let _e1802 = bitcast<f32>((_e1772 & bitcast<u32>(~(_e1777))));
                                            let _e1806 = bitcast<f32>((_e1781 & bitcast<u32>(~(_e1786))));
                                            let _e1810 = bitcast<f32>((_e1790 & bitcast<u32>(~(_e1795))));
                                            let _e1840 = global_4.member[_e831.member_1][0u];
                                            let _e1844 = global_4.member[_e831.member_1][1u];
                                            let _e1848 = global_4.member[_e831.member_1][2u];
                                            let _e1852 = global_4.member[_e831.member_1][3u];
                                            let _e1864 = (((_e1844 >> bitcast<u32>(22i)) | ((_e1848 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1852 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1865 = (_e1840 & 268435455u);
                                            let _e1866 = (_e1864 & 268435455u);
                                            let _e1869 = ((_e1840 >> bitcast<u32>(28u)) & 7u);
                                            let _e1877 = ((_e1840 >> bitcast<u32>(31i)) | (((_e1864 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1878 = (_e1869 != 0u);
                                            if (_e1869 == 0u) {
                                                phi_3568_ = _e1865;
                                            } else {
                                                if (_e1869 == 7u) {
                                                    phi_3567_ = 2147483648u;
                                                } else {
                                                    phi_3567_ = ((2147483648u | (_e1869 << bitcast<u32>(28u))) | (_e1866 & 268435455u));
                                                }
                                                let _e1887 = phi_3567_;
                                                phi_3568_ = _e1887;
                                            }
                                            let _e1889 = phi_3568_;
                                            if _e1878 {
                                                let _e1890 = (_e1869 != 7u);
                                                if _e1890 {
                                                    phi_3578_ = (_e1866 + _e1869);
                                                } else {
                                                    phi_3578_ = u32();
                                                }
                                                let _e1893 = phi_3578_;
                                                phi_3580_ = _e1893;
                                                phi_3581_ = select(true, false, _e1890);
                                            } else {
                                                phi_3580_ = u32();
                                                phi_3581_ = true;
                                            }
                                            let _e1896 = phi_3580_;
                                            let _e1898 = phi_3581_;
                                            if (_e1877 == 0u) {
                                                phi_3602_ = (_e1865 + select(0u, 1u, !(_e1878)));
                                            } else {
                                                if (_e1877 == 7u) {
                                                    phi_3601_ = 2147483648u;
                                                } else {
                                                    phi_3601_ = ((2147483648u | (_e1877 << bitcast<u32>(28u))) | (select(_e1896, _e1866, _e1898) & 268435455u));
                                                }
                                                let _e1911 = phi_3601_;
                                                phi_3602_ = _e1911;
                                            }
                                            let _e1913 = phi_3602_;
                                            phi_3606_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e831.member.member.x + _e1741), (_e831.member.member.x + _e1763), (_e831.member.member_1.x - _e1780), (_e831.member.member_1.x - _e1802)), vec4<f32>((_e831.member.member.y + _e1750), (_e831.member.member.y + _e1767), (_e831.member.member_1.y - _e1789), (_e831.member.member_1.y - _e1806)), vec4<f32>((_e831.member.member.z + _e1759), (_e831.member.member.z + _e1771), (_e831.member.member_1.z - _e1798), (_e831.member.member_1.z - _e1810))), type_63(type_42((_e831.member.member + vec4<f32>(_e1741, _e1750, _e1759, 0f)), (_e831.member.member_1 - vec4<f32>(_e1780, _e1789, _e1798, 0f))), _e1889), type_63(type_42((_e831.member.member + vec4<f32>(_e1763, _e1767, _e1771, 0f)), (_e831.member.member_1 - vec4<f32>(_e1802, _e1806, _e1810, 0f))), _e1913));
                                        }
                                        let _e1918 = phi_3606_;
                                        let _e1930 = ((_e1918.member[0].x - _e511) * _e514);
                                        let _e1931 = ((_e1918.member[0].y - _e511) * _e514);
                                        let _e1932 = ((_e1918.member[0].z - _e512) * _e514);
                                        let _e1933 = ((_e1918.member[0].w - _e512) * _e514);
                                        let _e1943 = ((_e1918.member[1].x - _e575) * _e578);
                                        let _e1944 = ((_e1918.member[1].y - _e575) * _e578);
                                        let _e1945 = ((_e1918.member[1].z - _e576) * _e578);
                                        let _e1946 = ((_e1918.member[1].w - _e576) * _e578);
                                        let _e1956 = ((_e1918.member[2].x - _e639) * _e642);
                                        let _e1957 = ((_e1918.member[2].y - _e639) * _e642);
                                        let _e1958 = ((_e1918.member[2].z - _e640) * _e642);
                                        let _e1959 = ((_e1918.member[2].w - _e640) * _e642);
                                        let _e1961 = select(_e1958, _e1956, (_e1956 < _e1958));
                                        let _e1963 = select(_e1959, _e1957, (_e1957 < _e1959));
                                        let _e1965 = select(_e1958, _e1956, (_e1956 > _e1958));
                                        let _e1967 = select(_e1959, _e1957, (_e1957 > _e1959));
                                        let _e1969 = select(_e1932, _e1930, (_e1930 < _e1932));
                                        let _e1971 = select(_e1933, _e1931, (_e1931 < _e1933));
                                        let _e1973 = select(_e1945, _e1943, (_e1943 < _e1945));
                                        let _e1975 = select(_e1946, _e1944, (_e1944 < _e1946));
                                        let _e1977 = select(_e1973, _e1969, (_e1969 > _e1973));
                                        let _e1979 = select(_e1975, _e1971, (_e1971 > _e1975));
                                        let _e1981 = select(_e1961, _e1977, (_e1977 > _e1961));
                                        let _e1983 = select(_e1963, _e1979, (_e1979 > _e1963));
                                        let _e1985 = select(_e1932, _e1930, (_e1930 > _e1932));
                                        let _e1987 = select(_e1933, _e1931, (_e1931 > _e1933));
                                        let _e1989 = select(_e1945, _e1943, (_e1943 > _e1945));
                                        let _e1991 = select(_e1946, _e1944, (_e1944 > _e1946));
                                        let _e1993 = select(_e1989, _e1985, (_e1985 < _e1989));
                                        let _e1995 = select(_e1991, _e1987, (_e1987 < _e1991));
                                        let _e2000 = -(_e1961);
                                        let _e2001 = -(_e1963);
                                        let _e2008 = (select(_e1965, _e1993, (_e1993 < _e1965)) + (select(_e2000, _e1965, (_e1965 > _e2000)) * 0.0000019073523f));
                                        let _e2009 = (select(_e1967, _e1995, (_e1995 < _e1967)) + (select(_e2001, _e1967, (_e1967 > _e2001)) * 0.0000019073523f));
                                        let _e2011 = select(_e744, _e1981, (_e1981 > _e744));
                                        let _e2013 = select(_e744, _e1983, (_e1983 > _e744));
                                        let _e2018 = (_e2011 <= select(_e1642.member_1, _e2008, (_e2008 < _e1642.member_1)));
                                        let _e2019 = (_e2013 <= select(_e1642.member_1, _e2009, (_e2009 < _e1642.member_1)));
                                        let _e2020 = (_e2011 <= _e2013);
                                        if _e2018 {
                                            if _e2019 {
                                                if _e2020 {
                                                    phi_3968_ = _e1918.member_2;
                                                } else {
                                                    phi_3968_ = _e1918.member_1;
                                                }
                                                let _e2024 = phi_3968_;
                                                let _e2045 = (_e829 % 128u);
                                                let _e2046 = (_e2045 < 128u);
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_8[_e2045] = _e2024.member_1;
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_7[_e2045] = _e2024.member.member.x;
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_6[_e2045] = _e2024.member.member.y;
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_5[_e2045] = _e2024.member.member.z;
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_4[_e2045] = _e2024.member.member_1.x;
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_3[_e2045] = _e2024.member.member_1.y;
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_2[_e2045] = _e2024.member.member_1.z;
                                                if _e2046 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_9[_e2045] = select(_e2011, _e2013, _e2020);
                                                if _e2020 {
                                                    phi_4044_ = _e1918.member_1;
                                                } else {
                                                    phi_4044_ = _e1918.member_2;
                                                }
                                                let _e2059 = phi_4044_;
                                                phi_4045_ = (_e829 + 1u);
                                                phi_4046_ = _e2059;
                                            } else {
                                                phi_4045_ = u32();
                                                phi_4046_ = type_63();
                                            }
                                            let _e2061 = phi_4045_;
                                            let _e2063 = phi_4046_;
                                            phi_4048_ = _e2061;
                                            phi_4049_ = _e2063;
                                            phi_4050_ = select(true, false, _e2019);
                                        } else {
                                            phi_4048_ = u32();
                                            phi_4049_ = type_63();
                                            phi_4050_ = true;
                                        }
                                        let _e2066 = phi_4048_;
                                        let _e2068 = phi_4049_;
                                        let _e2070 = phi_4050_;
                                        if _e2070 {
                                            if _e2018 {
                                                phi_4059_ = _e1918.member_1;
                                            } else {
                                                phi_4059_ = _e1918.member_2;
                                            }
                                            let _e2074 = phi_4059_;
                                            phi_4064_ = select(_e2019, true, _e2018);
                                            phi_4066_ = _e2074;
                                        } else {
                                            phi_4064_ = _e827;
                                            phi_4066_ = _e2068;
                                        }
                                        let _e2077 = phi_4064_;
                                        let _e2079 = phi_4066_;
                                        phi_4070_ = _e2077;
                                        phi_4071_ = select(_e2066, _e829, _e2070);
                                        phi_4072_ = _e2079;
                                    }
                                    let _e2082 = phi_4070_;
                                    let _e2084 = phi_4071_;
                                    let _e2086 = phi_4072_;
                                    if _e835 {
                                        phi_4082_ = _e831;
                                    } else {
                                        phi_4082_ = _e2086;
                                    }
                                    let _e2088 = phi_4082_;
                                    phi_4904_ = _e1640;
                                    phi_4083_ = _e1642;
                                    phi_4084_ = (_e790 - 1u);
                                    phi_4085_ = select(_e2082, false, _e835);
                                    phi_4086_ = select(_e2084, _e829, _e835);
                                    phi_4087_ = _e2088;
                                } else {
                                    phi_4904_ = _e786;
                                    phi_4083_ = _e788;
                                    phi_4084_ = _e790;
                                    phi_4085_ = _e827;
                                    phi_4086_ = _e829;
                                    phi_4087_ = _e831;
                                }
                                let _e2092 = phi_4904_;
                                let _e2094 = phi_4083_;
                                let _e2096 = phi_4084_;
                                let _e2098 = phi_4085_;
                                let _e2100 = phi_4086_;
                                let _e2102 = phi_4087_;
                                phi_4903_ = _e2092;
                                phi_4088_ = _e2094;
                                phi_4089_ = _e2096;
                                phi_4090_ = _e2098;
                                phi_4091_ = _e2100;
                                phi_4092_ = _e2102;
                            } else {
                                phi_4903_ = _e786;
                                phi_4088_ = type_48();
                                phi_4089_ = u32();
                                phi_4090_ = bool();
                                phi_4091_ = u32();
                                phi_4092_ = type_63();
                            }
                            let _e2104 = phi_4903_;
                            let _e2106 = phi_4088_;
                            let _e2108 = phi_4089_;
                            let _e2110 = phi_4090_;
                            let _e2112 = phi_4091_;
                            let _e2114 = phi_4092_;
                            phi_4902_ = _e2104;
                            phi_1416_ = _e2106;
                            phi_1419_ = _e2108;
                            phi_1421_ = _e2110;
                            phi_1423_ = _e2112;
                            phi_1425_ = _e2114;
                            phi_4093_ = _e800;
                        } else {
                            phi_4902_ = _e786;
                            phi_1416_ = type_48();
                            phi_1419_ = u32();
                            phi_1421_ = bool();
                            phi_1423_ = u32();
                            phi_1425_ = type_63();
                            phi_4093_ = false;
                        }
                        let _e2116 = phi_4902_;
                        let _e2118 = phi_1416_;
                        let _e2120 = phi_1419_;
                        let _e2122 = phi_1421_;
                        let _e2124 = phi_1423_;
                        let _e2126 = phi_1425_;
                        let _e2128 = phi_4093_;
                        continue;
                        continuing {
                            phi_4710_ = _e2116;
                            phi_1415_ = _e2118;
                            phi_1418_ = _e2120;
                            phi_1420_ = _e2122;
                            phi_1422_ = _e2124;
                            phi_1424_ = _e2126;
                            phi_4901_ = _e2116;
                            break if !(_e2128);
                        }
                    }
                    let _e2131 = phi_4901_;
                    if _e2131 {
                        break;
                    }
                    let _e2133 = local_10;
                    if (_e2133.member.member_3 != 4294967295u) {
                        let _e2138 = bitcast<u32>(_e2133.member.member);
                        let _e2142 = (bitcast<i32>((_e2138 >> bitcast<u32>(23i))) & 255i);
                        let _e2143 = (_e2142 + _e428);
                        if (_e2142 == 255i) {
                            phi_4152_ = _e2133.member.member;
                        } else {
                            if (_e2142 > 0i) {
                                if (_e2143 > 0i) {
                                    let _e2147 = (_e2143 < 255i);
                                    if _e2147 {
                                        phi_4131_ = bitcast<f32>((_e2138 + bitcast<u32>((_e428 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4131_ = f32();
                                    }
                                    let _e2154 = phi_4131_;
                                    phi_4133_ = _e2154;
                                    phi_4134_ = select(true, false, _e2147);
                                } else {
                                    phi_4133_ = f32();
                                    phi_4134_ = true;
                                }
                                let _e2157 = phi_4133_;
                                let _e2159 = phi_4134_;
                                phi_4135_ = _e2157;
                                phi_4136_ = _e2159;
                            } else {
                                phi_4135_ = f32();
                                phi_4136_ = true;
                            }
                            let _e2161 = phi_4135_;
                            let _e2163 = phi_4136_;
                            if _e2163 {
                                let _e2164 = (_e2138 & 2147483648u);
                                let _e2171 = ((_e2138 & 8388607u) | (select(0u, 1u, ((_e2138 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2175 = (_e2171 == 0u);
                                if _e2175 {
                                    phi_4662_ = bitcast<f32>(_e2164);
                                } else {
                                    let _e2180 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2171)), 32u, _e2175) - 8u);
                                    let _e2183 = (_e2171 << bitcast<u32>((_e2180 & 31u)));
                                    let _e2185 = ((_e2143 + select(0i, 1i, (_e2142 == 0i))) - bitcast<i32>(_e2180));
                                    if (_e2185 >= 255i) {
                                        phi_4652_ = bitcast<f32>((_e2164 | 2139095040u));
                                        phi_4653_ = f32();
                                        phi_4654_ = true;
                                    } else {
                                        let _e2187 = (_e2185 > 0i);
                                        if _e2187 {
                                            phi_4646_ = bitcast<f32>(((_e2164 | (bitcast<u32>(_e2185) << bitcast<u32>(23i))) | (_e2183 & 8388607u)));
                                            phi_4647_ = f32();
                                        } else {
                                            if (_e2185 < -24i) {
                                                phi_4612_ = 26u;
                                            } else {
                                                phi_4612_ = bitcast<u32>((1i - _e2185));
                                            }
                                            let _e2192 = phi_4612_;
                                            let _e2193 = (_e2192 & 31u);
                                            let _e2195 = (_e2183 >> bitcast<u32>(_e2193));
                                            let _e2199 = (_e2183 & ((1u << bitcast<u32>(_e2193)) - 1u));
                                            let _e2203 = (1u << bitcast<u32>(((_e2192 - 1u) & 31u)));
                                            if (_e2199 > _e2203) {
                                                phi_4633_ = true;
                                            } else {
                                                if (_e2199 == _e2203) {
                                                    phi_4630_ = ((_e2195 & 1u) == 1u);
                                                } else {
                                                    phi_4630_ = false;
                                                }
                                                let _e2209 = phi_4630_;
                                                phi_4633_ = _e2209;
                                            }
                                            let _e2211 = phi_4633_;
                                            phi_4646_ = f32();
                                            phi_4647_ = bitcast<f32>((_e2164 | (_e2195 + select(0u, 1u, _e2211))));
                                        }
                                        let _e2224 = phi_4646_;
                                        let _e2226 = phi_4647_;
                                        phi_4652_ = _e2224;
                                        phi_4653_ = _e2226;
                                        phi_4654_ = _e2187;
                                    }
                                    let _e2230 = phi_4652_;
                                    let _e2232 = phi_4653_;
                                    let _e2234 = phi_4654_;
                                    phi_4662_ = select(_e2232, _e2230, _e2234);
                                }
                                let _e2238 = phi_4662_;
                                phi_4151_ = _e2238;
                            } else {
                                phi_4151_ = _e2161;
                            }
                            let _e2240 = phi_4151_;
                            phi_4152_ = _e2240;
                        }
                        let _e2242 = phi_4152_;
                        let _e2243 = bitcast<u32>(_e2242);
                        if ((_e2243 & 2147483647u) >= 2139095040u) {
                            phi_4164_ = bitcast<f32>(((_e2243 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4164_ = _e2242;
                        }
                        let _e2250 = phi_4164_;
                        phi_4169_ = type_30(_e2250, _e2133.member.member_1, _e2133.member.member_2, _e2133.member.member_3);
                    } else {
                        phi_4169_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2255 = phi_4169_;
                    if _e305 {
                    } else {
                        break;
                    }
                    global_9.member[_e151] = _e2255;
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e2259 = select(0u, 1u, (_e372 <= _e382));
                    if (_e2259 > 0u) {
                        let _e2261 = (1u < _e119);
                        if _e2261 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e2265 = atomicAdd((&global_10.member[0u]), _e2259);
                            if ((_e2265 + _e2259) < _e2265) {
                                if _e2261 {
                                } else {
                                    break;
                                }
                                let _e2270 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2273 = select(0u, 1u, (_e2255.member_3 != 4294967295u));
                    if (_e2273 > 0u) {
                        let _e2275 = (3u < _e119);
                        if _e2275 {
                            if (2u < _e119) {
                            } else {
                                break;
                            }
                            let _e2279 = atomicAdd((&global_10.member[2u]), _e2273);
                            if ((_e2279 + _e2273) < _e2279) {
                                if _e2275 {
                                } else {
                                    break;
                                }
                                let _e2284 = atomicAdd((&global_10.member[3u]), 1u);
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
