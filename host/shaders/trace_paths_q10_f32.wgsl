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

struct type_52 {
    member: array<vec4<u32>, 2>,
}

struct type_55 {
    member: array<i32>,
}

struct type_62 {
    member: type_42,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_62,
    member_2: type_62,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_52;
@group(0) @binding(2) 
var<uniform> global_3: type_52;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(4) 
var<storage> global_5: type_24;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_55;
@group(0) @binding(7) 
var<storage> global_8: type_37;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_32;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_68;

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
    var phi_416_: u32;
    var phi_460_: i32;
    var phi_600_: type_44;
    var phi_706_: i32;
    var phi_707_: i32;
    var phi_717_: bool;
    var phi_727_: u32;
    var phi_728_: u32;
    var phi_730_: bool;
    var phi_735_: u32;
    var phi_768_: i32;
    var phi_786_: f32;
    var phi_792_: f32;
    var phi_832_: f32;
    var phi_838_: f32;
    var phi_890_: f32;
    var phi_902_: f32;
    var phi_911_: f32;
    var phi_917_: f32;
    var phi_957_: f32;
    var phi_963_: f32;
    var phi_1015_: f32;
    var phi_1027_: f32;
    var phi_1036_: f32;
    var phi_1042_: f32;
    var phi_1082_: f32;
    var phi_1088_: f32;
    var phi_1140_: f32;
    var phi_1152_: f32;
    var phi_1207_: i32;
    var phi_1229_: u32;
    var phi_1230_: u32;
    var phi_1267_: i32;
    var phi_1289_: u32;
    var phi_1290_: u32;
    var phi_1298_: f32;
    var phi_1299_: f32;
    var phi_4609_: bool;
    var phi_1395_: type_48;
    var phi_1398_: bool;
    var phi_1400_: u32;
    var phi_1402_: u32;
    var phi_1404_: type_62;
    var phi_1415_: bool;
    var phi_1501_: bool;
    var phi_1502_: u32;
    var phi_1503_: type_62;
    var phi_3654_: u32;
    var phi_3655_: u32;
    var phi_3665_: u32;
    var phi_3667_: u32;
    var phi_3668_: bool;
    var phi_3688_: u32;
    var phi_3689_: u32;
    var phi_3693_: type_63;
    var phi_4055_: type_62;
    var phi_4132_: type_62;
    var phi_4133_: u32;
    var phi_4134_: type_62;
    var phi_4136_: u32;
    var phi_4137_: type_62;
    var phi_4138_: bool;
    var phi_4147_: type_62;
    var phi_4152_: bool;
    var phi_4154_: type_62;
    var phi_1521_: type_48;
    var phi_1524_: type_8;
    var phi_1525_: type_8;
    var phi_1547_: type_8;
    var phi_1568_: u32;
    var phi_1660_: array<array<f32, 3>, 3>;
    var phi_1812_: bool;
    var phi_1841_: bool;
    var phi_2260_: f32;
    var phi_2261_: f32;
    var phi_2262_: f32;
    var phi_2263_: f32;
    var phi_2264_: vec3<f32>;
    var phi_2265_: vec3<f32>;
    var phi_2266_: vec3<f32>;
    var phi_2267_: vec3<f32>;
    var phi_2304_: bool;
    var phi_2313_: vec3<f32>;
    var phi_2478_: f32;
    var phi_2480_: f32;
    var phi_2481_: bool;
    var phi_2501_: f32;
    var phi_2502_: f32;
    var phi_2525_: type_30;
    var phi_2527_: type_30;
    var phi_2528_: bool;
    var phi_2532_: type_30;
    var phi_2533_: type_30;
    var phi_2534_: type_30;
    var phi_2535_: bool;
    var phi_2539_: type_30;
    var phi_2540_: bool;
    var phi_2541_: type_30;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: type_30;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2554_: type_30;
    var phi_2555_: bool;
    var phi_2559_: type_30;
    var phi_2582_: u32;
    var phi_2596_: i32;
    var phi_2618_: vec3<f32>;
    var phi_2619_: vec3<f32>;
    var phi_2637_: vec3<f32>;
    var phi_2638_: vec3<f32>;
    var phi_2656_: vec3<f32>;
    var phi_2657_: vec3<f32>;
    var phi_2693_: vec3<f32>;
    var phi_2875_: f32;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2920_: type_48;
    var phi_2921_: type_48;
    var phi_2922_: type_48;
    var phi_1522_: type_48;
    var phi_4603_: bool;
    var phi_4799_: bool;
    var phi_4158_: type_48;
    var phi_4159_: bool;
    var phi_4160_: u32;
    var phi_4161_: type_62;
    var phi_4798_: bool;
    var phi_4162_: type_48;
    var phi_4163_: bool;
    var phi_4164_: u32;
    var phi_4165_: u32;
    var phi_4166_: type_62;
    var phi_4797_: bool;
    var phi_4167_: type_48;
    var phi_4168_: bool;
    var phi_4169_: u32;
    var phi_4170_: u32;
    var phi_4171_: type_62;
    var phi_4796_: bool;
    var phi_1396_: type_48;
    var phi_1399_: bool;
    var phi_1401_: u32;
    var phi_1403_: u32;
    var phi_1405_: type_62;
    var phi_4172_: bool;
    var phi_4795_: bool;
    var local_10: type_48;
    var phi_4210_: f32;
    var phi_4212_: f32;
    var phi_4213_: bool;
    var phi_4214_: f32;
    var phi_4215_: bool;
    var phi_4511_: u32;
    var phi_4529_: bool;
    var phi_4532_: bool;
    var phi_4545_: f32;
    var phi_4546_: f32;
    var phi_4551_: f32;
    var phi_4552_: f32;
    var phi_4553_: bool;
    var phi_4561_: f32;
    var phi_4230_: f32;
    var phi_4231_: f32;
    var phi_4243_: f32;
    var phi_4248_: type_30;
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
                phi_416_ = _e170;
            } else {
                phi_416_ = 4294967295u;
            }
            let _e172 = phi_416_;
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
                phi_460_ = -126i;
            } else {
                phi_460_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_460_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_600_ = type_44(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                let _e233 = bitcast<u32>(_e208);
                let _e235 = ((_e233 & 2139095040u) != 0u);
                let _e250 = bitcast<u32>(_e209);
                let _e252 = ((_e250 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e210);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                let _e285 = bitcast<u32>(_e212);
                let _e287 = ((_e285 & 2139095040u) != 0u);
                phi_600_ = type_44(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e233 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e233 & 2147483648u))), _e208, _e235) * _e225) * select(0.00000011920929f, 1f, _e235)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e209, _e252) * _e225) * select(0.00000011920929f, 1f, _e252)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e210, _e269) * _e225) * select(0.00000011920929f, 1f, _e269)) * _e231)), _e191, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e212, _e287) * _e225) * select(0.00000011920929f, 1f, _e287)) * _e231), _e213);
            }
            let _e304 = phi_600_;
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
                            phi_706_ = (bitcast<i32>((_e391 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_706_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e391)), 32u, (_e391 == 0u))));
                        }
                        let _e405 = phi_706_;
                        phi_707_ = _e405;
                    } else {
                        phi_707_ = 0i;
                    }
                    let _e407 = phi_707_;
                    let _e408 = (_e317 == _e361);
                    if _e408 {
                        phi_717_ = true;
                    } else {
                        phi_717_ = (_e325 == _e361);
                    }
                    let _e411 = phi_717_;
                    let _e412 = select(1u, 0u, _e408);
                    if _e411 {
                        let _e413 = (_e412 + 1u);
                        phi_727_ = _e413;
                        phi_728_ = _e413;
                        phi_730_ = select(true, false, (_e413 == 2u));
                    } else {
                        phi_727_ = u32();
                        phi_728_ = 0u;
                        phi_730_ = true;
                    }
                    let _e417 = phi_727_;
                    let _e419 = phi_728_;
                    let _e421 = phi_730_;
                    if _e421 {
                        phi_735_ = (_e419 + 1u);
                    } else {
                        phi_735_ = 0u;
                    }
                    let _e425 = phi_735_;
                    let _e426 = select(_e417, _e419, _e421);
                    let _e427 = select(_e412, select(2u, _e412, _e411), _e421);
                    let _e428 = -(_e407);
                    if (_e428 < -126i) {
                        phi_768_ = -126i;
                    } else {
                        phi_768_ = select(_e428, 127i, (_e428 > 127i));
                    }
                    let _e433 = phi_768_;
                    let _e438 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                    let _e444 = bitcast<f32>((bitcast<u32>(((_e428 - _e433) + 127i)) << bitcast<u32>(23i)));
                    let _e449 = global_8.member[_e151].member.member;
                    let _e450 = (_e426 == 0u);
                    if _e450 {
                        phi_786_ = _e449[0];
                    } else {
                        phi_786_ = _e449[1];
                    }
                    let _e454 = phi_786_;
                    let _e455 = (_e426 == 2u);
                    if _e455 {
                        phi_792_ = _e449[2];
                    } else {
                        phi_792_ = _e454;
                    }
                    let _e458 = phi_792_;
                    let _e459 = bitcast<u32>(_e458);
                    let _e461 = ((_e459 & 2139095040u) != 0u);
                    let _e473 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e459 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e459 & 2147483648u))), _e458, _e461) * select(0.00000011920929f, 1f, _e461));
                    let _e474 = global_8.member[_e151].member.member_2;
                    if _e450 {
                        phi_832_ = _e474[0];
                    } else {
                        phi_832_ = _e474[1];
                    }
                    let _e478 = phi_832_;
                    if _e455 {
                        phi_838_ = _e474[2];
                    } else {
                        phi_838_ = _e478;
                    }
                    let _e481 = phi_838_;
                    let _e482 = bitcast<u32>(_e481);
                    let _e484 = ((_e482 & 2139095040u) != 0u);
                    let _e498 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e482 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e482 & 2147483648u))), _e481, _e484) * _e438) * select(0.00000011920929f, 1f, _e484)) * _e444);
                    let _e502 = (bitcast<f32>((bitcast<u32>(_e498) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e502 {
                        let _e506 = (bitcast<f32>((bitcast<u32>(_e473) & 2147483647u)) * 0.00000011920929f);
                        phi_890_ = select(0.00000000000011368684f, _e506, (_e506 > 0.00000000000011368684f));
                    } else {
                        phi_890_ = 0f;
                    }
                    let _e510 = phi_890_;
                    let _e511 = (_e473 + _e510);
                    let _e512 = (_e473 - _e510);
                    let _e513 = select(_e498, 0f, _e502);
                    if _e502 {
                        phi_902_ = 38685626000000000000000000f;
                    } else {
                        phi_902_ = (1f / _e498);
                    }
                    let _e516 = phi_902_;
                    let _e517 = (_e425 == 0u);
                    if _e517 {
                        phi_911_ = _e449[0];
                    } else {
                        phi_911_ = _e449[1];
                    }
                    let _e521 = phi_911_;
                    let _e522 = (_e425 == 2u);
                    if _e522 {
                        phi_917_ = _e449[2];
                    } else {
                        phi_917_ = _e521;
                    }
                    let _e525 = phi_917_;
                    let _e526 = bitcast<u32>(_e525);
                    let _e528 = ((_e526 & 2139095040u) != 0u);
                    let _e540 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e526 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e526 & 2147483648u))), _e525, _e528) * select(0.00000011920929f, 1f, _e528));
                    if _e517 {
                        phi_957_ = _e474[0];
                    } else {
                        phi_957_ = _e474[1];
                    }
                    let _e544 = phi_957_;
                    if _e522 {
                        phi_963_ = _e474[2];
                    } else {
                        phi_963_ = _e544;
                    }
                    let _e547 = phi_963_;
                    let _e548 = bitcast<u32>(_e547);
                    let _e550 = ((_e548 & 2139095040u) != 0u);
                    let _e564 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e548 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e548 & 2147483648u))), _e547, _e550) * _e438) * select(0.00000011920929f, 1f, _e550)) * _e444);
                    let _e568 = (bitcast<f32>((bitcast<u32>(_e564) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e568 {
                        let _e572 = (bitcast<f32>((bitcast<u32>(_e540) & 2147483647u)) * 0.00000011920929f);
                        phi_1015_ = select(0.00000000000011368684f, _e572, (_e572 > 0.00000000000011368684f));
                    } else {
                        phi_1015_ = 0f;
                    }
                    let _e576 = phi_1015_;
                    let _e577 = (_e540 + _e576);
                    let _e578 = (_e540 - _e576);
                    let _e579 = select(_e564, 0f, _e568);
                    if _e568 {
                        phi_1027_ = 38685626000000000000000000f;
                    } else {
                        phi_1027_ = (1f / _e564);
                    }
                    let _e582 = phi_1027_;
                    let _e583 = (_e427 == 0u);
                    if _e583 {
                        phi_1036_ = _e449[0];
                    } else {
                        phi_1036_ = _e449[1];
                    }
                    let _e587 = phi_1036_;
                    let _e588 = (_e427 == 2u);
                    if _e588 {
                        phi_1042_ = _e449[2];
                    } else {
                        phi_1042_ = _e587;
                    }
                    let _e591 = phi_1042_;
                    let _e592 = bitcast<u32>(_e591);
                    let _e594 = ((_e592 & 2139095040u) != 0u);
                    let _e606 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e592 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e592 & 2147483648u))), _e591, _e594) * select(0.00000011920929f, 1f, _e594));
                    if _e583 {
                        phi_1082_ = _e474[0];
                    } else {
                        phi_1082_ = _e474[1];
                    }
                    let _e610 = phi_1082_;
                    if _e588 {
                        phi_1088_ = _e474[2];
                    } else {
                        phi_1088_ = _e610;
                    }
                    let _e613 = phi_1088_;
                    let _e614 = bitcast<u32>(_e613);
                    let _e616 = ((_e614 & 2139095040u) != 0u);
                    let _e630 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e614 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e614 & 2147483648u))), _e613, _e616) * _e438) * select(0.00000011920929f, 1f, _e616)) * _e444);
                    let _e634 = (bitcast<f32>((bitcast<u32>(_e630) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e634 {
                        let _e638 = (bitcast<f32>((bitcast<u32>(_e606) & 2147483647u)) * 0.00000011920929f);
                        phi_1140_ = select(0.00000000000011368684f, _e638, (_e638 > 0.00000000000011368684f));
                    } else {
                        phi_1140_ = 0f;
                    }
                    let _e642 = phi_1140_;
                    let _e643 = (_e606 + _e642);
                    let _e644 = (_e606 - _e642);
                    let _e645 = select(_e630, 0f, _e634);
                    if _e634 {
                        phi_1152_ = 38685626000000000000000000f;
                    } else {
                        phi_1152_ = (1f / _e630);
                    }
                    let _e648 = phi_1152_;
                    let _e651 = bitcast<f32>((bitcast<u32>(_e473) & 2147483647u));
                    let _e654 = bitcast<f32>((bitcast<u32>(_e540) & 2147483647u));
                    let _e656 = select(_e654, _e651, (_e651 > _e654));
                    let _e659 = bitcast<f32>((bitcast<u32>(_e606) & 2147483647u));
                    if (_e388 && (select(_e659, _e656, (_e656 > _e659)) <= 1099511600000f)) {
                        let _e671 = ((_e374 & 8388607u) | (select(0u, 1u, ((_e374 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e674 = bitcast<i32>((_e374 >> bitcast<u32>(23i)));
                        let _e678 = (_e671 == 0u);
                        let _e681 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e671)), 32u, _e678)) - 8i);
                        if (_e674 == 255i) {
                            phi_1207_ = 255i;
                        } else {
                            phi_1207_ = (((_e674 + select(0i, 1i, (_e674 == 0i))) - _e681) + _e407);
                        }
                        let _e689 = phi_1207_;
                        let _e699 = (_e689 <= 0i);
                        if _e699 {
                            phi_1230_ = u32();
                        } else {
                            if _e678 {
                                phi_1229_ = u32();
                            } else {
                                phi_1229_ = select(((bitcast<u32>(_e689) << bitcast<u32>(23i)) | ((_e671 << bitcast<u32>(((_e681 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e689 >= 255i));
                            }
                            let _e703 = phi_1229_;
                            phi_1230_ = _e703;
                        }
                        let _e705 = phi_1230_;
                        let _e717 = ((_e384 & 8388607u) | (select(0u, 1u, ((_e384 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e720 = bitcast<i32>((_e384 >> bitcast<u32>(23i)));
                        let _e724 = (_e717 == 0u);
                        let _e727 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e717)), 32u, _e724)) - 8i);
                        if (_e720 == 255i) {
                            phi_1267_ = 255i;
                        } else {
                            phi_1267_ = (((_e720 + select(0i, 1i, (_e720 == 0i))) - _e727) + _e407);
                        }
                        let _e735 = phi_1267_;
                        let _e745 = (_e735 <= 0i);
                        if _e745 {
                            phi_1290_ = u32();
                        } else {
                            if _e724 {
                                phi_1289_ = u32();
                            } else {
                                phi_1289_ = select(((bitcast<u32>(_e735) << bitcast<u32>(23i)) | ((_e717 << bitcast<u32>(((_e727 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e735 >= 255i));
                            }
                            let _e749 = phi_1289_;
                            phi_1290_ = _e749;
                        }
                        let _e751 = phi_1290_;
                        phi_1298_ = bitcast<f32>(((_e383 & 2147483648u) | select(_e751, 0u, select(_e724, true, _e745))));
                        phi_1299_ = bitcast<f32>(((_e373 & 2147483648u) | select(_e705, 0u, select(_e678, true, _e699))));
                    } else {
                        phi_1298_ = 0f;
                        phi_1299_ = 1f;
                    }
                    let _e757 = phi_1298_;
                    let _e759 = phi_1299_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e763 = (_e426 % 3u);
                    let _e764 = (_e763 < 3u);
                    if _e764 {
                    } else {
                        break;
                    }
                    let _e766 = local_1[_e763];
                    let _e769 = (_e425 % 3u);
                    let _e770 = (_e769 < 3u);
                    if _e770 {
                    } else {
                        break;
                    }
                    let _e772 = local_1[_e769];
                    let _e775 = (_e427 % 3u);
                    let _e776 = (_e775 < 3u);
                    if _e776 {
                    } else {
                        break;
                    }
                    let _e778 = local_1[_e775];
                    if _e764 {
                    } else {
                        break;
                    }
                    let _e783 = local[_e763];
                    if _e770 {
                    } else {
                        break;
                    }
                    let _e787 = local[_e769];
                    if _e776 {
                    } else {
                        break;
                    }
                    let _e791 = local[_e775];
                    phi_4609_ = false;
                    phi_1395_ = type_48(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e757);
                    phi_1398_ = (_e759 <= _e757);
                    phi_1400_ = ((3u * _e105) + 1u);
                    phi_1402_ = 0u;
                    phi_1404_ = type_62(type_42(vec4<f32>((f32(_e766) * _e163), (f32(_e772) * _e163), (f32(_e778) * _e163), 0f), vec4<f32>((f32(_e783) * _e163), (f32(_e787) * _e163), (f32(_e791) * _e163), 0f)), select(0u, 2147483648u, (_e105 == 0u)));
                    loop {
                        let _e801 = phi_4609_;
                        let _e803 = phi_1395_;
                        let _e805 = phi_1398_;
                        let _e807 = phi_1400_;
                        let _e809 = phi_1402_;
                        let _e811 = phi_1404_;
                        local_10 = _e803;
                        if _e805 {
                            phi_1415_ = true;
                        } else {
                            phi_1415_ = (_e809 > 0u);
                        }
                        let _e814 = phi_1415_;
                        if _e814 {
                            let _e815 = (_e807 > 0u);
                            if _e815 {
                                if _e805 {
                                    phi_1501_ = _e805;
                                    phi_1502_ = _e809;
                                    phi_1503_ = _e811;
                                } else {
                                    let _e816 = (_e809 - 1u);
                                    let _e817 = (_e816 % 128u);
                                    let _e818 = (_e817 < 128u);
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e820 = local_7[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e822 = local_6[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e824 = local_5[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e826 = local_4[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e828 = local_3[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e830 = local_2[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e835 = local_8[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e838 = local_9[_e817];
                                    phi_1501_ = (_e838 <= _e803.member_1);
                                    phi_1502_ = _e816;
                                    phi_1503_ = type_62(type_42(vec4<f32>(_e820, _e822, _e824, 0f), vec4<f32>(_e826, _e828, _e830, 0f)), _e835);
                                }
                                let _e842 = phi_1501_;
                                let _e844 = phi_1502_;
                                let _e846 = phi_1503_;
                                if _e842 {
                                    if ((_e846.member_1 & 2147483648u) != 0u) {
                                        phi_1521_ = _e803;
                                        phi_1524_ = type_8(0u, ((_e846.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1296 = phi_1521_;
                                            let _e1298 = phi_1524_;
                                            local_11 = _e1296;
                                            if (_e1298.member < _e1298.member_1) {
                                                phi_1525_ = type_8((_e1298.member + 1u), _e1298.member_1);
                                                phi_1547_ = type_8(1u, _e1298.member);
                                            } else {
                                                phi_1525_ = _e1298;
                                                phi_1547_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1311 = phi_1525_;
                                            let _e1313 = phi_1547_;
                                            let _e1317 = (bitcast<i32>(_e1313.member) != 0i);
                                            if _e1317 {
                                                let _e1318 = ((_e846.member_1 & 268435455u) + _e1313.member_1);
                                                let _e1319 = (_e1318 < _e107);
                                                if _e1319 {
                                                    if _e1319 {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1323 = global_5.member[_e1318].member_1;
                                                    phi_1568_ = _e1323;
                                                } else {
                                                    phi_1568_ = 4294967295u;
                                                }
                                                let _e1325 = phi_1568_;
                                                if (_e1318 >= _e107) {
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1319 {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1332 = global_5.member[_e1318].member[_e763];
                                                    if (_e769 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1338 = global_5.member[_e1318].member[_e769];
                                                    if (_e775 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1344 = global_5.member[_e1318].member[_e775];
                                                    let _e1346 = (3u + _e763);
                                                    if (_e1346 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1352 = global_5.member[_e1318].member[_e1346];
                                                    let _e1353 = (3u + _e769);
                                                    if (_e1353 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1359 = global_5.member[_e1318].member[_e1353];
                                                    let _e1360 = (3u + _e775);
                                                    if (_e1360 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1366 = global_5.member[_e1318].member[_e1360];
                                                    let _e1368 = (6u + _e763);
                                                    if (_e1368 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1374 = global_5.member[_e1318].member[_e1368];
                                                    let _e1375 = (6u + _e769);
                                                    if (_e1375 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1381 = global_5.member[_e1318].member[_e1375];
                                                    let _e1382 = (6u + _e775);
                                                    if (_e1382 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1388 = global_5.member[_e1318].member[_e1382];
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1332, _e1338, _e1344), array<f32, 3>(_e1352, _e1359, _e1366), array<f32, 3>(_e1374, _e1381, _e1388));
                                                }
                                                let _e1392 = phi_1660_;
                                                let _e1400 = (_e1392[0][2] - _e606);
                                                let _e1403 = (((_e1392[0][0] - _e473) * _e645) - (_e1400 * _e513));
                                                let _e1406 = (((_e1392[0][1] - _e540) * _e645) - (_e1400 * _e579));
                                                let _e1413 = (_e1392[1][2] - _e606);
                                                let _e1416 = (((_e1392[1][0] - _e473) * _e645) - (_e1413 * _e513));
                                                let _e1419 = (((_e1392[1][1] - _e540) * _e645) - (_e1413 * _e579));
                                                let _e1426 = (_e1392[2][2] - _e606);
                                                let _e1429 = (((_e1392[2][0] - _e473) * _e645) - (_e1426 * _e513));
                                                let _e1432 = (((_e1392[2][1] - _e540) * _e645) - (_e1426 * _e579));
                                                let _e1433 = (_e1429 * _e1419);
                                                let _e1434 = (_e1432 * _e1416);
                                                let _e1435 = (_e1403 * _e1432);
                                                let _e1436 = (_e1406 * _e1429);
                                                let _e1437 = (_e1416 * _e1406);
                                                let _e1438 = (_e1419 * _e1403);
                                                let _e1443 = (((_e1433 >= _e1434) && (_e1435 >= _e1436)) && (_e1437 >= _e1438));
                                                if (_e1443 || (((_e1433 <= _e1434) && (_e1435 <= _e1436)) && (_e1437 <= _e1438))) {
                                                    let _e1450 = select(-1f, 1f, _e1443);
                                                    let _e1452 = ((_e1433 - _e1434) * _e1450);
                                                    let _e1454 = select(0f, _e1452, (_e1452 > 0f));
                                                    let _e1456 = ((_e1435 - _e1436) * _e1450);
                                                    let _e1458 = select(0f, _e1456, (_e1456 > 0f));
                                                    let _e1460 = ((_e1437 - _e1438) * _e1450);
                                                    let _e1462 = select(0f, _e1460, (_e1460 > 0f));
                                                    let _e1464 = ((_e1454 + _e1458) + _e1462);
                                                    if (_e1464 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2544_ = type_30();
                                                        phi_2545_ = true;
                                                        phi_2546_ = false;
                                                    } else {
                                                        let _e1467 = select(_e1416, _e1403, (_e1403 < _e1416));
                                                        if (select(_e1429, _e1467, (_e1467 < _e1429)) > 0f) {
                                                            phi_1812_ = true;
                                                        } else {
                                                            let _e1472 = select(_e1416, _e1403, (_e1403 > _e1416));
                                                            phi_1812_ = (select(_e1429, _e1472, (_e1472 > _e1429)) < 0f);
                                                        }
                                                        let _e1477 = phi_1812_;
                                                        if _e1477 {
                                                            phi_2541_ = type_30();
                                                            phi_2542_ = true;
                                                            phi_2543_ = false;
                                                        } else {
                                                            let _e1479 = select(_e1419, _e1406, (_e1406 < _e1419));
                                                            if (select(_e1432, _e1479, (_e1479 < _e1432)) > 0f) {
                                                                phi_1841_ = true;
                                                            } else {
                                                                let _e1484 = select(_e1419, _e1406, (_e1406 > _e1419));
                                                                phi_1841_ = (select(_e1432, _e1484, (_e1484 > _e1432)) < 0f);
                                                            }
                                                            let _e1489 = phi_1841_;
                                                            if _e1489 {
                                                                phi_2539_ = type_30();
                                                                phi_2540_ = false;
                                                            } else {
                                                                let _e1491 = select(_e1392[1][0], _e1392[0][0], (_e1392[0][0] < _e1392[1][0]));
                                                                let _e1495 = select(_e1392[1][0], _e1392[0][0], (_e1392[0][0] > _e1392[1][0]));
                                                                let _e1499 = select(_e1392[1][1], _e1392[0][1], (_e1392[0][1] < _e1392[1][1]));
                                                                let _e1503 = select(_e1392[1][1], _e1392[0][1], (_e1392[0][1] > _e1392[1][1]));
                                                                let _e1507 = select(_e1392[1][2], _e1392[0][2], (_e1392[0][2] < _e1392[1][2]));
                                                                let _e1511 = select(_e1392[1][2], _e1392[0][2], (_e1392[0][2] > _e1392[1][2]));
                                                                let _e1516 = ((select(_e1392[2][0], _e1491, (_e1491 < _e1392[2][0])) - _e511) * _e516);
                                                                let _e1517 = ((select(_e1392[2][0], _e1495, (_e1495 > _e1392[2][0])) - _e512) * _e516);
                                                                let _e1520 = ((select(_e1392[2][1], _e1499, (_e1499 < _e1392[2][1])) - _e577) * _e582);
                                                                let _e1521 = ((select(_e1392[2][1], _e1503, (_e1503 > _e1392[2][1])) - _e578) * _e582);
                                                                let _e1524 = ((select(_e1392[2][2], _e1507, (_e1507 < _e1392[2][2])) - _e643) * _e648);
                                                                let _e1525 = ((select(_e1392[2][2], _e1511, (_e1511 > _e1392[2][2])) - _e644) * _e648);
                                                                let _e1527 = select(_e1525, _e1524, (_e1524 < _e1525));
                                                                let _e1529 = select(_e1525, _e1524, (_e1524 > _e1525));
                                                                let _e1531 = select(_e1517, _e1516, (_e1516 < _e1517));
                                                                let _e1533 = select(_e1521, _e1520, (_e1520 < _e1521));
                                                                let _e1535 = select(_e1533, _e1531, (_e1531 > _e1533));
                                                                let _e1537 = select(_e1527, _e1535, (_e1535 > _e1527));
                                                                let _e1539 = select(_e1517, _e1516, (_e1516 > _e1517));
                                                                let _e1541 = select(_e1521, _e1520, (_e1520 > _e1521));
                                                                let _e1543 = select(_e1541, _e1539, (_e1539 < _e1541));
                                                                let _e1545 = select(_e1529, _e1543, (_e1543 < _e1529));
                                                                let _e1546 = -(_e1527);
                                                                let _e1552 = select(_e759, _e1537, (_e1537 > _e759));
                                                                if (_e1552 > (_e1545 + (select(_e1546, _e1529, (_e1529 > _e1546)) * 0.0000019073523f))) {
                                                                    phi_2534_ = type_30();
                                                                    phi_2535_ = true;
                                                                } else {
                                                                    let _e1554 = (_e1552 > _e1296.member_1);
                                                                    if _e1554 {
                                                                        phi_2533_ = type_30();
                                                                    } else {
                                                                        let _e1555 = vec3<f32>(_e1392[0][0], _e1392[0][1], _e1392[0][2]);
                                                                        let _e1556 = vec3<f32>(_e1392[1][0], _e1392[1][1], _e1392[1][2]);
                                                                        let _e1557 = vec3<f32>(_e1392[2][0], _e1392[2][1], _e1392[2][2]);
                                                                        let _e1558 = (_e1392[1][0] - _e1392[0][0]);
                                                                        let _e1559 = (_e1392[1][1] - _e1392[0][1]);
                                                                        let _e1560 = (_e1392[1][2] - _e1392[0][2]);
                                                                        let _e1561 = vec3<f32>(_e1558, _e1559, _e1560);
                                                                        let _e1562 = (_e1392[2][0] - _e1392[1][0]);
                                                                        let _e1563 = (_e1392[2][1] - _e1392[1][1]);
                                                                        let _e1564 = (_e1392[2][2] - _e1392[1][2]);
                                                                        let _e1565 = vec3<f32>(_e1562, _e1563, _e1564);
                                                                        let _e1566 = (_e1392[0][0] - _e1392[2][0]);
                                                                        let _e1567 = (_e1392[0][1] - _e1392[2][1]);
                                                                        let _e1568 = (_e1392[0][2] - _e1392[2][2]);
                                                                        let _e1569 = vec3<f32>(_e1566, _e1567, _e1568);
                                                                        let _e1572 = bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u));
                                                                        let _e1575 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                        let _e1577 = select(_e1575, _e1572, (_e1572 > _e1575));
                                                                        let _e1580 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                        let _e1582 = select(_e1580, _e1577, (_e1577 > _e1580));
                                                                        let _e1585 = bitcast<f32>((bitcast<u32>(_e1562) & 2147483647u));
                                                                        let _e1588 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                                        let _e1590 = select(_e1588, _e1585, (_e1585 > _e1588));
                                                                        let _e1593 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                                        let _e1595 = select(_e1593, _e1590, (_e1590 > _e1593));
                                                                        let _e1598 = bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u));
                                                                        let _e1601 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                                        let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                                        let _e1606 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                                        let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                                        let _e1610 = select(_e1595, _e1582, (_e1582 > _e1595));
                                                                        let _e1612 = select(_e1608, _e1610, (_e1610 > _e1608));
                                                                        if (_e1582 == _e1612) {
                                                                            phi_2260_ = _e1419;
                                                                            phi_2261_ = _e1416;
                                                                            phi_2262_ = _e1406;
                                                                            phi_2263_ = _e1403;
                                                                            phi_2264_ = _e1555;
                                                                            phi_2265_ = _e1569;
                                                                            phi_2266_ = _e1565;
                                                                            phi_2267_ = _e1561;
                                                                        } else {
                                                                            let _e1614 = (_e1595 == _e1612);
                                                                            let _e1619 = vec3(_e1614);
                                                                            phi_2260_ = select(_e1406, _e1432, _e1614);
                                                                            phi_2261_ = select(_e1403, _e1429, _e1614);
                                                                            phi_2262_ = select(_e1432, _e1419, _e1614);
                                                                            phi_2263_ = select(_e1429, _e1416, _e1614);
                                                                            phi_2264_ = select(_e1557, _e1556, _e1619);
                                                                            phi_2265_ = select(_e1565, _e1561, _e1619);
                                                                            phi_2266_ = select(_e1561, _e1569, _e1619);
                                                                            phi_2267_ = select(_e1569, _e1565, _e1619);
                                                                        }
                                                                        let _e1625 = phi_2260_;
                                                                        let _e1627 = phi_2261_;
                                                                        let _e1629 = phi_2262_;
                                                                        let _e1631 = phi_2263_;
                                                                        let _e1633 = phi_2264_;
                                                                        let _e1635 = phi_2265_;
                                                                        let _e1637 = phi_2266_;
                                                                        let _e1639 = phi_2267_;
                                                                        let _e1646 = ((_e1637.y * _e1635.z) - (_e1635.y * _e1637.z));
                                                                        let _e1651 = ((_e1637.z * _e1635.x) - (_e1635.z * _e1637.x));
                                                                        let _e1654 = ((_e1637.x * _e1635.y) - (_e1635.x * _e1637.y));
                                                                        if (_e1454 >= _e1458) {
                                                                            phi_2304_ = select(true, false, (_e1454 >= _e1462));
                                                                        } else {
                                                                            phi_2304_ = true;
                                                                        }
                                                                        let _e1659 = phi_2304_;
                                                                        if _e1659 {
                                                                            phi_2313_ = select(_e1557, _e1556, vec3((_e1458 >= _e1462)));
                                                                        } else {
                                                                            phi_2313_ = _e1555;
                                                                        }
                                                                        let _e1664 = phi_2313_;
                                                                        let _e1675 = (((_e1646 * (_e1664.x - _e473)) + (_e1651 * (_e1664.y - _e540))) + (_e1654 * (_e1664.z - _e606)));
                                                                        let _e1680 = (((_e1646 * _e513) + (_e1651 * _e579)) + (_e1654 * _e645));
                                                                        let _e1681 = (_e1627 - _e1631);
                                                                        let _e1682 = (_e1625 - _e1629);
                                                                        let _e1690 = (-(((_e1631 * _e1681) + (_e1629 * _e1682))) / ((_e1681 * _e1681) + (_e1682 * _e1682)));
                                                                        let _e1692 = select(1f, _e1690, (_e1690 < 1f));
                                                                        let _e1694 = select(0f, _e1692, (_e1692 > 0f));
                                                                        let _e1707 = ((_e1633.x + (_e1639.x * _e1694)) - _e473);
                                                                        let _e1708 = ((_e1633.y + (_e1639.y * _e1694)) - _e540);
                                                                        let _e1709 = ((_e1633.z + (_e1639.z * _e1694)) - _e606);
                                                                        let _e1710 = (_e1709 / _e645);
                                                                        let _e1722 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                                        let _e1725 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                        let _e1727 = select(_e1725, _e1722, (_e1722 > _e1725));
                                                                        let _e1730 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                        let _e1732 = select(_e1730, _e1727, (_e1727 > _e1730));
                                                                        let _e1738 = bitcast<f32>((bitcast<u32>(_e1646) & 2147483647u));
                                                                        let _e1741 = bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u));
                                                                        let _e1743 = select(_e1741, _e1738, (_e1738 > _e1741));
                                                                        let _e1746 = bitcast<f32>((bitcast<u32>(_e1654) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1646 * _e1707) + (_e1651 * _e1708)) + (_e1654 * _e1709)) - _e1675)) & 2147483647u)) <= ((0.0000009536743f * select(_e1612, _e1732, (_e1732 > _e1612))) * select(_e1746, _e1743, (_e1743 > _e1746)))) {
                                                                            let _e1756 = bitcast<f32>((bitcast<u32>(_e1637.x) & 2147483647u));
                                                                            let _e1759 = bitcast<f32>((bitcast<u32>(_e1637.y) & 2147483647u));
                                                                            let _e1761 = select(_e1759, _e1756, (_e1756 > _e1759));
                                                                            let _e1764 = bitcast<f32>((bitcast<u32>(_e1637.z) & 2147483647u));
                                                                            let _e1770 = bitcast<f32>((bitcast<u32>(_e1635.x) & 2147483647u));
                                                                            let _e1773 = bitcast<f32>((bitcast<u32>(_e1635.y) & 2147483647u));
                                                                            let _e1775 = select(_e1773, _e1770, (_e1770 > _e1773));
                                                                            let _e1778 = bitcast<f32>((bitcast<u32>(_e1635.z) & 2147483647u));
                                                                            let _e1782 = (bitcast<f32>((bitcast<u32>(_e1680) & 2147483647u)) > ((0.0000038146973f * select(_e1764, _e1761, (_e1761 > _e1764))) * select(_e1778, _e1775, (_e1775 > _e1778))));
                                                                            if _e1782 {
                                                                                phi_2478_ = (_e1675 / _e1680);
                                                                            } else {
                                                                                phi_2478_ = f32();
                                                                            }
                                                                            let _e1785 = phi_2478_;
                                                                            phi_2480_ = _e1785;
                                                                            phi_2481_ = select(true, false, _e1782);
                                                                        } else {
                                                                            phi_2480_ = f32();
                                                                            phi_2481_ = true;
                                                                        }
                                                                        let _e1788 = phi_2480_;
                                                                        let _e1790 = phi_2481_;
                                                                        if _e1790 {
                                                                            let _e1798 = (((_e1646 * (_e1707 - (_e513 * _e1710))) + (_e1651 * (_e1708 - (_e579 * _e1710)))) / _e1680);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u)) <= _e1612) {
                                                                                phi_2501_ = (_e1710 + _e1798);
                                                                            } else {
                                                                                phi_2501_ = _e1710;
                                                                            }
                                                                            let _e1805 = phi_2501_;
                                                                            phi_2502_ = _e1805;
                                                                        } else {
                                                                            phi_2502_ = _e1788;
                                                                        }
                                                                        let _e1807 = phi_2502_;
                                                                        let _e1809 = select(_e1545, _e1807, (_e1807 < _e1545));
                                                                        let _e1811 = select(_e1537, _e1809, (_e1809 > _e1537));
                                                                        if (_e1811 >= _e759) {
                                                                            let _e1813 = (_e1811 <= _e1296.member_1);
                                                                            if _e1813 {
                                                                                let _e1814 = (1f / _e1464);
                                                                                phi_2525_ = type_30(_e1811, (_e1458 * _e1814), (_e1462 * _e1814), _e1325);
                                                                            } else {
                                                                                phi_2525_ = type_30();
                                                                            }
                                                                            let _e1819 = phi_2525_;
                                                                            phi_2527_ = _e1819;
                                                                            phi_2528_ = select(true, false, _e1813);
                                                                        } else {
                                                                            phi_2527_ = type_30();
                                                                            phi_2528_ = true;
                                                                        }
                                                                        let _e1822 = phi_2527_;
                                                                        let _e1824 = phi_2528_;
                                                                        if _e1824 {
                                                                            phi_2532_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2532_ = _e1822;
                                                                        }
                                                                        let _e1826 = phi_2532_;
                                                                        phi_2533_ = _e1826;
                                                                    }
                                                                    let _e1828 = phi_2533_;
                                                                    phi_2534_ = _e1828;
                                                                    phi_2535_ = _e1554;
                                                                }
                                                                let _e1830 = phi_2534_;
                                                                let _e1832 = phi_2535_;
                                                                phi_2539_ = _e1830;
                                                                phi_2540_ = _e1832;
                                                            }
                                                            let _e1834 = phi_2539_;
                                                            let _e1836 = phi_2540_;
                                                            phi_2541_ = _e1834;
                                                            phi_2542_ = _e1489;
                                                            phi_2543_ = _e1836;
                                                        }
                                                        let _e1838 = phi_2541_;
                                                        let _e1840 = phi_2542_;
                                                        let _e1842 = phi_2543_;
                                                        phi_2544_ = _e1838;
                                                        phi_2545_ = _e1840;
                                                        phi_2546_ = _e1842;
                                                    }
                                                    let _e1844 = phi_2544_;
                                                    let _e1846 = phi_2545_;
                                                    let _e1848 = phi_2546_;
                                                    phi_2554_ = _e1844;
                                                    phi_2555_ = select(_e1848, true, _e1846);
                                                } else {
                                                    phi_2554_ = type_30();
                                                    phi_2555_ = true;
                                                }
                                                let _e1851 = phi_2554_;
                                                let _e1853 = phi_2555_;
                                                if _e1853 {
                                                    phi_2559_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2559_ = _e1851;
                                                }
                                                let _e1855 = phi_2559_;
                                                if (_e1855.member_3 != 4294967295u) {
                                                    if (_e1325 == _e172) {
                                                        phi_2894_ = false;
                                                    } else {
                                                        let _e1859 = (_e1325 < arrayLength((&global_6.member)));
                                                        if _e1859 {
                                                            if _e1859 {
                                                            } else {
                                                                phi_4603_ = true;
                                                                break;
                                                            }
                                                            let _e1861 = global_6.member[_e1325];
                                                            phi_2582_ = _e1861;
                                                        } else {
                                                            phi_2582_ = 4294967295u;
                                                        }
                                                        let _e1863 = phi_2582_;
                                                        let _e1864 = (_e1863 < arrayLength((&global_7.member)));
                                                        if _e1864 {
                                                            if _e1864 {
                                                            } else {
                                                                phi_4603_ = true;
                                                                break;
                                                            }
                                                            let _e1866 = global_7.member[_e1863];
                                                            phi_2596_ = _e1866;
                                                        } else {
                                                            phi_2596_ = 0i;
                                                        }
                                                        let _e1868 = phi_2596_;
                                                        let _e1869 = (_e1868 == 0i);
                                                        if _e1869 {
                                                            phi_2893_ = true;
                                                        } else {
                                                            if _e450 {
                                                                phi_2619_ = vec3<f32>(_e1392[0][0], _e1392[0][1], _e1392[0][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2618_ = vec3<f32>(_e1392[0][2], _e1392[0][0], _e1392[0][1]);
                                                                } else {
                                                                    phi_2618_ = vec3<f32>(_e1392[0][1], _e1392[0][2], _e1392[0][0]);
                                                                }
                                                                let _e1874 = phi_2618_;
                                                                phi_2619_ = _e1874;
                                                            }
                                                            let _e1877 = phi_2619_;
                                                            if _e450 {
                                                                phi_2638_ = vec3<f32>(_e1392[1][0], _e1392[1][1], _e1392[1][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2637_ = vec3<f32>(_e1392[1][2], _e1392[1][0], _e1392[1][1]);
                                                                } else {
                                                                    phi_2637_ = vec3<f32>(_e1392[1][1], _e1392[1][2], _e1392[1][0]);
                                                                }
                                                                let _e1882 = phi_2637_;
                                                                phi_2638_ = _e1882;
                                                            }
                                                            let _e1885 = phi_2638_;
                                                            if _e450 {
                                                                phi_2657_ = vec3<f32>(_e1392[2][0], _e1392[2][1], _e1392[2][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2656_ = vec3<f32>(_e1392[2][2], _e1392[2][0], _e1392[2][1]);
                                                                } else {
                                                                    phi_2656_ = vec3<f32>(_e1392[2][1], _e1392[2][2], _e1392[2][0]);
                                                                }
                                                                let _e1890 = phi_2656_;
                                                                phi_2657_ = _e1890;
                                                            }
                                                            let _e1893 = phi_2657_;
                                                            let _e1896 = (_e1885.x - _e1877.x);
                                                            let _e1899 = (_e1885.y - _e1877.y);
                                                            let _e1902 = (_e1885.z - _e1877.z);
                                                            let _e1904 = (_e1893.x - _e1877.x);
                                                            let _e1906 = (_e1893.y - _e1877.y);
                                                            let _e1908 = (_e1893.z - _e1877.z);
                                                            if (_e304.member_1 == 1u) {
                                                                phi_2693_ = (vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]) - _e1877);
                                                            } else {
                                                                phi_2693_ = vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]);
                                                            }
                                                            let _e1923 = phi_2693_;
                                                            let _e1929 = bitcast<f32>((bitcast<u32>((_e1896 * _e1906)) ^ _e304.member_3[0]));
                                                            let _e1933 = bitcast<f32>((bitcast<u32>((_e1899 * _e1904)) ^ _e304.member_3[0]));
                                                            let _e1937 = bitcast<f32>((bitcast<u32>((_e1899 * _e1908)) ^ _e304.member_3[0]));
                                                            let _e1941 = bitcast<f32>((bitcast<u32>((_e1902 * _e1906)) ^ _e304.member_3[0]));
                                                            let _e1945 = bitcast<f32>((bitcast<u32>((_e1902 * _e1904)) ^ _e304.member_3[0]));
                                                            let _e1949 = bitcast<f32>((bitcast<u32>((_e1896 * _e1908)) ^ _e304.member_3[0]));
                                                            let _e1950 = (_e1937 - _e1941);
                                                            let _e1951 = (_e1945 - _e1949);
                                                            let _e1952 = (_e1929 - _e1933);
                                                            let _e1976 = (bitcast<f32>((bitcast<u32>(_e1937) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1941) & 2147483647u)));
                                                            let _e1983 = (bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1949) & 2147483647u)));
                                                            let _e1990 = (bitcast<f32>((bitcast<u32>(_e1929) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1933) & 2147483647u)));
                                                            if (_e304.member_2 == 0f) {
                                                                phi_2875_ = 0f;
                                                            } else {
                                                                let _e2020 = bitcast<f32>((bitcast<u32>(_e1950) & 2147483647u));
                                                                let _e2023 = bitcast<f32>((bitcast<u32>(_e1951) & 2147483647u));
                                                                let _e2026 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
                                                                let _e2028 = select(_e2026, _e2023, (_e2023 > _e2026));
                                                                let _e2032 = select(_e2026, _e2023, (_e2023 < _e2026));
                                                                let _e2036 = select(_e2023, _e2020, (_e2020 < _e2023));
                                                                let _e2038 = select(_e2023, _e2020, (_e2020 > _e2023));
                                                                let _e2040 = select(_e2026, _e2038, (_e2038 < _e2026));
                                                                phi_2875_ = bitcast<f32>((bitcast<u32>((_e304.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2028, _e2020, (_e2020 > _e2028)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2040, _e2036, (_e2036 > _e2040)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2032, _e2020, (_e2020 < _e2032)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1976 + _e1983) + _e1990))) ^ _e304.member_3[0]))) * 1.0000005f)) ^ _e304.member_3[0])))) ^ _e304.member_3[0]));
                                                            }
                                                            let _e2067 = phi_2875_;
                                                            phi_2893_ = (_e1869 || !(((((bitcast<f32>((bitcast<u32>((_e1923.x * _e1950)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1923.y * _e1951)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1923.z * _e1952)) ^ _e304.member_3[0]))) * f32(-(_e1868))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1923.x) & 2147483647u)) * _e1976)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1923.y) & 2147483647u)) * _e1983)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1923.z) & 2147483647u)) * _e1990)) ^ _e304.member_3[0]))))) ^ _e304.member_3[0])) + _e2067) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2081 = phi_2893_;
                                                        phi_2894_ = _e2081;
                                                    }
                                                    let _e2083 = phi_2894_;
                                                    if _e2083 {
                                                        if (_e1855.member < _e1296.member.member) {
                                                            phi_2914_ = true;
                                                        } else {
                                                            if (_e1855.member == _e1296.member.member) {
                                                                phi_2913_ = (_e1855.member_3 < _e1296.member.member_3);
                                                            } else {
                                                                phi_2913_ = false;
                                                            }
                                                            let _e2093 = phi_2913_;
                                                            phi_2914_ = _e2093;
                                                        }
                                                        let _e2095 = phi_2914_;
                                                        if _e2095 {
                                                            phi_2920_ = type_48(_e1855, _e1855.member);
                                                        } else {
                                                            phi_2920_ = _e1296;
                                                        }
                                                        let _e2098 = phi_2920_;
                                                        phi_2921_ = _e2098;
                                                    } else {
                                                        phi_2921_ = _e1296;
                                                    }
                                                    let _e2100 = phi_2921_;
                                                    phi_2922_ = _e2100;
                                                } else {
                                                    phi_2922_ = _e1296;
                                                }
                                                let _e2102 = phi_2922_;
                                                phi_1522_ = _e2102;
                                            } else {
                                                phi_1522_ = type_48();
                                            }
                                            let _e2104 = phi_1522_;
                                            continue;
                                            continuing {
                                                phi_1521_ = _e2104;
                                                phi_1524_ = _e1311;
                                                phi_4603_ = _e801;
                                                break if !(_e1317);
                                            }
                                        }
                                        let _e2107 = phi_4603_;
                                        phi_4795_ = _e2107;
                                        if _e2107 {
                                            break;
                                        }
                                        phi_4799_ = _e2107;
                                        let _e2440 = local_11;
                                        phi_4158_ = _e2440;
                                        phi_4159_ = false;
                                        phi_4160_ = _e844;
                                        phi_4161_ = _e846;
                                    } else {
                                        if (_e846.member_1 >= _e105) {
                                            phi_3693_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e846.member_1 < _e105) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e858 = ((1u + _e426) % 4u);
                                            if (_e858 < 4u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e863 = global_4.member[_e846.member_1][_e858];
                                            let _e865 = (_e863 >> bitcast<u32>(11u));
                                            let _e867 = ((1u + _e425) % 4u);
                                            if (_e867 < 4u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e872 = global_4.member[_e846.member_1][_e867];
                                            let _e874 = (_e872 >> bitcast<u32>(11u));
                                            let _e876 = ((1u + _e427) % 4u);
                                            if (_e876 < 4u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e881 = global_4.member[_e846.member_1][_e876];
                                            let _e883 = (_e881 >> bitcast<u32>(11u));
                                            let _e906 = (bitcast<f32>((bitcast<u32>((_e846.member.member_1.x - _e846.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e907 = (bitcast<f32>((bitcast<u32>((_e846.member.member_1.y - _e846.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e908 = (bitcast<f32>((bitcast<u32>((_e846.member.member_1.z - _e846.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e910 = select(_e163, _e906, (_e906 > _e163));
                                            let _e912 = select(_e163, _e907, (_e907 > _e163));
                                            let _e914 = select(_e163, _e908, (_e908 > _e163));
                                            let _e945 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e863 & 1023u))) - 8388608f) * _e910));
                                            let _e950 = (bitcast<i32>((_e863 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e953 = bitcast<f32>((_e945 & bitcast<u32>(_e950)));
                                            let _e954 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e872 & 1023u))) - 8388608f) * _e912));
                                            let _e959 = (bitcast<i32>((_e872 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e962 = bitcast<f32>((_e954 & bitcast<u32>(_e959)));
                                            let _e963 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e881 & 1023u))) - 8388608f) * _e914));
                                            let _e968 = (bitcast<i32>((_e881 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e971 = bitcast<f32>((_e963 & bitcast<u32>(_e968)));
                                            let _e975 = bitcast<f32>((_e945 & bitcast<u32>(~(_e950))));
                                            let _e979 = bitcast<f32>((_e954 & bitcast<u32>(~(_e959))));
                                            let _e983 = bitcast<f32>((_e963 & bitcast<u32>(~(_e968))));
                                            let _e984 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e865 & 1023u))) - 8388608f) * _e910));
                                            let _e989 = (bitcast<i32>((_e865 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e992 = bitcast<f32>((_e984 & bitcast<u32>(_e989)));
                                            let _e993 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e874 & 1023u))) - 8388608f) * _e912));
                                            let _e998 = (bitcast<i32>((_e874 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1001 = bitcast<f32>((_e993 & bitcast<u32>(_e998)));
                                            let _e1002 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e883 & 1023u))) - 8388608f) * _e914));
                                            let _e1007 = (bitcast<i32>((_e883 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1010 = bitcast<f32>((_e1002 & bitcast<u32>(_e1007)));
                                            let _e1014 = bitcast<f32>((_e984 & bitcast<u32>(~(_e989))));
                                            let _e1018 = bitcast<f32>((_e993 & bitcast<u32>(~(_e998))));
                                            let _e1022 = bitcast<f32>((_e1002 & bitcast<u32>(~(_e1007))));
                                            let _e1052 = global_4.member[_e846.member_1][0u];
                                            let _e1056 = global_4.member[_e846.member_1][1u];
                                            let _e1060 = global_4.member[_e846.member_1][2u];
                                            let _e1064 = global_4.member[_e846.member_1][3u];
                                            let _e1076 = (((_e1056 >> bitcast<u32>(22i)) | ((_e1060 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1064 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1077 = (_e1052 & 268435455u);
                                            let _e1078 = (_e1076 & 268435455u);
                                            let _e1081 = ((_e1052 >> bitcast<u32>(28u)) & 7u);
                                            let _e1089 = ((_e1052 >> bitcast<u32>(31i)) | (((_e1076 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1090 = (_e1081 != 0u);
                                            if (_e1081 == 0u) {
                                                phi_3655_ = _e1077;
                                            } else {
                                                if (_e1081 == 7u) {
                                                    phi_3654_ = 2147483648u;
                                                } else {
                                                    phi_3654_ = ((2147483648u | (_e1081 << bitcast<u32>(28u))) | (_e1078 & 268435455u));
                                                }
                                                let _e1099 = phi_3654_;
                                                phi_3655_ = _e1099;
                                            }
                                            let _e1101 = phi_3655_;
                                            if _e1090 {
                                                let _e1102 = (_e1081 != 7u);
                                                if _e1102 {
                                                    phi_3665_ = (_e1078 + _e1081);
                                                } else {
                                                    phi_3665_ = u32();
                                                }
                                                let _e1105 = phi_3665_;
                                                phi_3667_ = _e1105;
                                                phi_3668_ = select(true, false, _e1102);
                                            } else {
                                                phi_3667_ = u32();
                                                phi_3668_ = true;
                                            }
                                            let _e1108 = phi_3667_;
                                            let _e1110 = phi_3668_;
                                            if (_e1089 == 0u) {
                                                phi_3689_ = (_e1077 + select(0u, 1u, !(_e1090)));
                                            } else {
                                                if (_e1089 == 7u) {
                                                    phi_3688_ = 2147483648u;
                                                } else {
                                                    phi_3688_ = ((2147483648u | (_e1089 << bitcast<u32>(28u))) | (select(_e1108, _e1078, _e1110) & 268435455u));
                                                }
                                                let _e1123 = phi_3688_;
                                                phi_3689_ = _e1123;
                                            }
                                            let _e1125 = phi_3689_;
                                            phi_3693_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e846.member.member.x + _e953), (_e846.member.member.x + _e975), (_e846.member.member_1.x - _e992), (_e846.member.member_1.x - _e1014)), vec4<f32>((_e846.member.member.y + _e962), (_e846.member.member.y + _e979), (_e846.member.member_1.y - _e1001), (_e846.member.member_1.y - _e1018)), vec4<f32>((_e846.member.member.z + _e971), (_e846.member.member.z + _e983), (_e846.member.member_1.z - _e1010), (_e846.member.member_1.z - _e1022))), type_62(type_42((_e846.member.member + vec4<f32>(_e953, _e962, _e971, 0f)), (_e846.member.member_1 - vec4<f32>(_e992, _e1001, _e1010, 0f))), _e1101), type_62(type_42((_e846.member.member + vec4<f32>(_e975, _e979, _e983, 0f)), (_e846.member.member_1 - vec4<f32>(_e1014, _e1018, _e1022, 0f))), _e1125));
                                        }
                                        let _e1130 = phi_3693_;
                                        let _e1142 = ((_e1130.member[0].x - _e511) * _e516);
                                        let _e1143 = ((_e1130.member[0].y - _e511) * _e516);
                                        let _e1144 = ((_e1130.member[0].z - _e512) * _e516);
                                        let _e1145 = ((_e1130.member[0].w - _e512) * _e516);
                                        let _e1155 = ((_e1130.member[1].x - _e577) * _e582);
                                        let _e1156 = ((_e1130.member[1].y - _e577) * _e582);
                                        let _e1157 = ((_e1130.member[1].z - _e578) * _e582);
                                        let _e1158 = ((_e1130.member[1].w - _e578) * _e582);
                                        let _e1168 = ((_e1130.member[2].x - _e643) * _e648);
                                        let _e1169 = ((_e1130.member[2].y - _e643) * _e648);
                                        let _e1170 = ((_e1130.member[2].z - _e644) * _e648);
                                        let _e1171 = ((_e1130.member[2].w - _e644) * _e648);
                                        let _e1173 = select(_e1170, _e1168, (_e1168 < _e1170));
                                        let _e1175 = select(_e1171, _e1169, (_e1169 < _e1171));
                                        let _e1177 = select(_e1170, _e1168, (_e1168 > _e1170));
                                        let _e1179 = select(_e1171, _e1169, (_e1169 > _e1171));
                                        let _e1181 = select(_e1144, _e1142, (_e1142 < _e1144));
                                        let _e1183 = select(_e1145, _e1143, (_e1143 < _e1145));
                                        let _e1185 = select(_e1157, _e1155, (_e1155 < _e1157));
                                        let _e1187 = select(_e1158, _e1156, (_e1156 < _e1158));
                                        let _e1189 = select(_e1185, _e1181, (_e1181 > _e1185));
                                        let _e1191 = select(_e1187, _e1183, (_e1183 > _e1187));
                                        let _e1193 = select(_e1173, _e1189, (_e1189 > _e1173));
                                        let _e1195 = select(_e1175, _e1191, (_e1191 > _e1175));
                                        let _e1197 = select(_e1144, _e1142, (_e1142 > _e1144));
                                        let _e1199 = select(_e1145, _e1143, (_e1143 > _e1145));
                                        let _e1201 = select(_e1157, _e1155, (_e1155 > _e1157));
                                        let _e1203 = select(_e1158, _e1156, (_e1156 > _e1158));
                                        let _e1205 = select(_e1201, _e1197, (_e1197 < _e1201));
                                        let _e1207 = select(_e1203, _e1199, (_e1199 < _e1203));
                                        let _e1212 = -(_e1173);
                                        let _e1213 = -(_e1175);
                                        let _e1220 = (select(_e1177, _e1205, (_e1205 < _e1177)) + (select(_e1212, _e1177, (_e1177 > _e1212)) * 0.0000019073523f));
                                        let _e1221 = (select(_e1179, _e1207, (_e1207 < _e1179)) + (select(_e1213, _e1179, (_e1179 > _e1213)) * 0.0000019073523f));
                                        let _e1223 = select(_e759, _e1193, (_e1193 > _e759));
                                        let _e1225 = select(_e759, _e1195, (_e1195 > _e759));
                                        let _e1230 = (_e1223 <= select(_e803.member_1, _e1220, (_e1220 < _e803.member_1)));
                                        let _e1231 = (_e1225 <= select(_e803.member_1, _e1221, (_e1221 < _e803.member_1)));
                                        let _e1232 = (_e1223 <= _e1225);
                                        if _e1230 {
                                            if _e1231 {
                                                if _e1232 {
                                                    phi_4055_ = _e1130.member_2;
                                                } else {
                                                    phi_4055_ = _e1130.member_1;
                                                }
                                                let _e1236 = phi_4055_;
                                                let _e1258 = (_e844 % 128u);
                                                let _e1259 = (_e1258 < 128u);
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_8[_e1258] = _e1236.member_1;
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_7[_e1258] = _e1236.member.member.x;
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_6[_e1258] = _e1236.member.member.y;
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_5[_e1258] = _e1236.member.member.z;
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_4[_e1258] = _e1236.member.member_1.x;
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_3[_e1258] = _e1236.member.member_1.y;
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_2[_e1258] = _e1236.member.member_1.z;
                                                if _e1259 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_9[_e1258] = select(_e1225, _e1223, !(_e1232));
                                                if _e1232 {
                                                    phi_4132_ = _e1130.member_1;
                                                } else {
                                                    phi_4132_ = _e1130.member_2;
                                                }
                                                let _e1272 = phi_4132_;
                                                phi_4133_ = (_e844 + 1u);
                                                phi_4134_ = _e1272;
                                            } else {
                                                phi_4133_ = u32();
                                                phi_4134_ = type_62();
                                            }
                                            let _e1274 = phi_4133_;
                                            let _e1276 = phi_4134_;
                                            phi_4136_ = _e1274;
                                            phi_4137_ = _e1276;
                                            phi_4138_ = select(true, false, _e1231);
                                        } else {
                                            phi_4136_ = u32();
                                            phi_4137_ = type_62();
                                            phi_4138_ = true;
                                        }
                                        let _e1279 = phi_4136_;
                                        let _e1281 = phi_4137_;
                                        let _e1283 = phi_4138_;
                                        if _e1283 {
                                            if _e1230 {
                                                phi_4147_ = _e1130.member_1;
                                            } else {
                                                phi_4147_ = _e1130.member_2;
                                            }
                                            let _e1287 = phi_4147_;
                                            phi_4152_ = select(_e1231, true, _e1230);
                                            phi_4154_ = _e1287;
                                        } else {
                                            phi_4152_ = _e842;
                                            phi_4154_ = _e1281;
                                        }
                                        let _e1290 = phi_4152_;
                                        let _e1292 = phi_4154_;
                                        phi_4799_ = _e801;
                                        phi_4158_ = _e803;
                                        phi_4159_ = _e1290;
                                        phi_4160_ = select(_e1279, _e844, _e1283);
                                        phi_4161_ = _e1292;
                                    }
                                    let _e2109 = phi_4799_;
                                    let _e2111 = phi_4158_;
                                    let _e2113 = phi_4159_;
                                    let _e2115 = phi_4160_;
                                    let _e2117 = phi_4161_;
                                    phi_4798_ = _e2109;
                                    phi_4162_ = _e2111;
                                    phi_4163_ = _e2113;
                                    phi_4164_ = (_e807 - 1u);
                                    phi_4165_ = _e2115;
                                    phi_4166_ = _e2117;
                                } else {
                                    phi_4798_ = _e801;
                                    phi_4162_ = _e803;
                                    phi_4163_ = _e842;
                                    phi_4164_ = _e807;
                                    phi_4165_ = _e844;
                                    phi_4166_ = _e846;
                                }
                                let _e2119 = phi_4798_;
                                let _e2121 = phi_4162_;
                                let _e2123 = phi_4163_;
                                let _e2125 = phi_4164_;
                                let _e2127 = phi_4165_;
                                let _e2129 = phi_4166_;
                                phi_4797_ = _e2119;
                                phi_4167_ = _e2121;
                                phi_4168_ = _e2123;
                                phi_4169_ = _e2125;
                                phi_4170_ = _e2127;
                                phi_4171_ = _e2129;
                            } else {
                                phi_4797_ = _e801;
                                phi_4167_ = type_48();
                                phi_4168_ = bool();
                                phi_4169_ = u32();
                                phi_4170_ = u32();
                                phi_4171_ = type_62();
                            }
                            let _e2131 = phi_4797_;
                            let _e2133 = phi_4167_;
                            let _e2135 = phi_4168_;
                            let _e2137 = phi_4169_;
                            let _e2139 = phi_4170_;
                            let _e2141 = phi_4171_;
                            phi_4796_ = _e2131;
                            phi_1396_ = _e2133;
                            phi_1399_ = _e2135;
                            phi_1401_ = _e2137;
                            phi_1403_ = _e2139;
                            phi_1405_ = _e2141;
                            phi_4172_ = _e815;
                        } else {
                            phi_4796_ = _e801;
                            phi_1396_ = type_48();
                            phi_1399_ = bool();
                            phi_1401_ = u32();
                            phi_1403_ = u32();
                            phi_1405_ = type_62();
                            phi_4172_ = false;
                        }
                        let _e2143 = phi_4796_;
                        let _e2145 = phi_1396_;
                        let _e2147 = phi_1399_;
                        let _e2149 = phi_1401_;
                        let _e2151 = phi_1403_;
                        let _e2153 = phi_1405_;
                        let _e2155 = phi_4172_;
                        continue;
                        continuing {
                            phi_4609_ = _e2143;
                            phi_1395_ = _e2145;
                            phi_1398_ = _e2147;
                            phi_1400_ = _e2149;
                            phi_1402_ = _e2151;
                            phi_1404_ = _e2153;
                            phi_4795_ = _e2143;
                            break if !(_e2155);
                        }
                    }
                    let _e2158 = phi_4795_;
                    if _e2158 {
                        break;
                    }
                    let _e2160 = local_10;
                    if (_e2160.member.member_3 != 4294967295u) {
                        let _e2165 = bitcast<u32>(_e2160.member.member);
                        let _e2169 = (bitcast<i32>((_e2165 >> bitcast<u32>(23i))) & 255i);
                        let _e2170 = (_e2169 + _e428);
                        if (_e2169 == 255i) {
                            phi_4231_ = _e2160.member.member;
                        } else {
                            if (_e2169 > 0i) {
                                if (_e2170 > 0i) {
                                    let _e2174 = (_e2170 < 255i);
                                    if _e2174 {
                                        phi_4210_ = bitcast<f32>((_e2165 + bitcast<u32>((_e428 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4210_ = f32();
                                    }
                                    let _e2181 = phi_4210_;
                                    phi_4212_ = _e2181;
                                    phi_4213_ = select(true, false, _e2174);
                                } else {
                                    phi_4212_ = f32();
                                    phi_4213_ = true;
                                }
                                let _e2184 = phi_4212_;
                                let _e2186 = phi_4213_;
                                phi_4214_ = _e2184;
                                phi_4215_ = _e2186;
                            } else {
                                phi_4214_ = f32();
                                phi_4215_ = true;
                            }
                            let _e2188 = phi_4214_;
                            let _e2190 = phi_4215_;
                            if _e2190 {
                                let _e2191 = (_e2165 & 2147483648u);
                                let _e2198 = ((_e2165 & 8388607u) | (select(0u, 1u, ((_e2165 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2202 = (_e2198 == 0u);
                                if _e2202 {
                                    phi_4561_ = bitcast<f32>(_e2191);
                                } else {
                                    let _e2207 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2198)), 32u, _e2202) - 8u);
                                    let _e2210 = (_e2198 << bitcast<u32>((_e2207 & 31u)));
                                    let _e2212 = ((_e2170 + select(0i, 1i, (_e2169 == 0i))) - bitcast<i32>(_e2207));
                                    if (_e2212 >= 255i) {
                                        phi_4551_ = bitcast<f32>((_e2191 | 2139095040u));
                                        phi_4552_ = f32();
                                        phi_4553_ = true;
                                    } else {
                                        let _e2214 = (_e2212 > 0i);
                                        if _e2214 {
                                            phi_4545_ = bitcast<f32>(((_e2191 | (bitcast<u32>(_e2212) << bitcast<u32>(23i))) | (_e2210 & 8388607u)));
                                            phi_4546_ = f32();
                                        } else {
                                            if (_e2212 < -24i) {
                                                phi_4511_ = 26u;
                                            } else {
                                                phi_4511_ = bitcast<u32>((1i - _e2212));
                                            }
                                            let _e2219 = phi_4511_;
                                            let _e2220 = (_e2219 & 31u);
                                            let _e2222 = (_e2210 >> bitcast<u32>(_e2220));
                                            let _e2226 = (_e2210 & ((1u << bitcast<u32>(_e2220)) - 1u));
                                            let _e2230 = (1u << bitcast<u32>(((_e2219 - 1u) & 31u)));
                                            if (_e2226 > _e2230) {
                                                phi_4532_ = true;
                                            } else {
                                                if (_e2226 == _e2230) {
                                                    phi_4529_ = ((_e2222 & 1u) == 1u);
                                                } else {
                                                    phi_4529_ = false;
                                                }
                                                let _e2236 = phi_4529_;
                                                phi_4532_ = _e2236;
                                            }
                                            let _e2238 = phi_4532_;
                                            phi_4545_ = f32();
                                            phi_4546_ = bitcast<f32>((_e2191 | (_e2222 + select(0u, 1u, _e2238))));
                                        }
                                        let _e2251 = phi_4545_;
                                        let _e2253 = phi_4546_;
                                        phi_4551_ = _e2251;
                                        phi_4552_ = _e2253;
                                        phi_4553_ = _e2214;
                                    }
                                    let _e2257 = phi_4551_;
                                    let _e2259 = phi_4552_;
                                    let _e2261 = phi_4553_;
                                    phi_4561_ = select(_e2259, _e2257, _e2261);
                                }
                                let _e2265 = phi_4561_;
                                phi_4230_ = _e2265;
                            } else {
                                phi_4230_ = _e2188;
                            }
                            let _e2267 = phi_4230_;
                            phi_4231_ = _e2267;
                        }
                        let _e2269 = phi_4231_;
                        let _e2270 = bitcast<u32>(_e2269);
                        if ((_e2270 & 2147483647u) >= 2139095040u) {
                            phi_4243_ = bitcast<f32>(((_e2270 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4243_ = _e2269;
                        }
                        let _e2277 = phi_4243_;
                        phi_4248_ = type_30(_e2277, _e2160.member.member_1, _e2160.member.member_2, _e2160.member.member_3);
                    } else {
                        phi_4248_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2282 = phi_4248_;
                    if _e305 {
                    } else {
                        break;
                    }
                    global_9.member[_e151] = _e2282;
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e2286 = select(0u, 1u, (_e372 <= _e382));
                    if (_e2286 > 0u) {
                        let _e2288 = (1u < _e119);
                        if _e2288 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e2292 = atomicAdd((&global_10.member[0u]), _e2286);
                            if ((_e2292 + _e2286) < _e2292) {
                                if _e2288 {
                                } else {
                                    break;
                                }
                                let _e2297 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2300 = select(0u, 1u, (_e2282.member_3 != 4294967295u));
                    if (_e2300 > 0u) {
                        let _e2302 = (3u < _e119);
                        if _e2302 {
                            if (2u < _e119) {
                            } else {
                                break;
                            }
                            let _e2306 = atomicAdd((&global_10.member[2u]), _e2300);
                            if ((_e2306 + _e2300) < _e2306) {
                                if _e2302 {
                                } else {
                                    break;
                                }
                                let _e2311 = atomicAdd((&global_10.member[3u]), 1u);
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
