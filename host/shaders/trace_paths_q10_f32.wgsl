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
    var phi_4613_: bool;
    var phi_1395_: type_48;
    var phi_1398_: u32;
    var phi_1400_: bool;
    var phi_1402_: u32;
    var phi_1404_: type_62;
    var phi_1415_: bool;
    var phi_1501_: bool;
    var phi_1502_: u32;
    var phi_1503_: type_62;
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
    var phi_4607_: bool;
    var phi_4885_: bool;
    var phi_2923_: type_48;
    var phi_3650_: u32;
    var phi_3651_: u32;
    var phi_3661_: u32;
    var phi_3663_: u32;
    var phi_3664_: bool;
    var phi_3684_: u32;
    var phi_3685_: u32;
    var phi_3689_: type_63;
    var phi_4051_: type_62;
    var phi_4127_: type_62;
    var phi_4128_: u32;
    var phi_4129_: type_62;
    var phi_4131_: u32;
    var phi_4132_: type_62;
    var phi_4133_: bool;
    var phi_4142_: type_62;
    var phi_4147_: bool;
    var phi_4149_: type_62;
    var phi_4153_: bool;
    var phi_4154_: u32;
    var phi_4155_: type_62;
    var phi_4165_: type_62;
    var phi_4802_: bool;
    var phi_4166_: type_48;
    var phi_4167_: u32;
    var phi_4168_: bool;
    var phi_4169_: u32;
    var phi_4170_: type_62;
    var phi_4801_: bool;
    var phi_4171_: type_48;
    var phi_4172_: u32;
    var phi_4173_: bool;
    var phi_4174_: u32;
    var phi_4175_: type_62;
    var phi_4800_: bool;
    var phi_1396_: type_48;
    var phi_1399_: u32;
    var phi_1401_: bool;
    var phi_1403_: u32;
    var phi_1405_: type_62;
    var phi_4176_: bool;
    var phi_4799_: bool;
    var local_10: type_48;
    var phi_4214_: f32;
    var phi_4216_: f32;
    var phi_4217_: bool;
    var phi_4218_: f32;
    var phi_4219_: bool;
    var phi_4515_: u32;
    var phi_4533_: bool;
    var phi_4536_: bool;
    var phi_4549_: f32;
    var phi_4550_: f32;
    var phi_4555_: f32;
    var phi_4556_: f32;
    var phi_4557_: bool;
    var phi_4565_: f32;
    var phi_4234_: f32;
    var phi_4235_: f32;
    var phi_4247_: f32;
    var phi_4252_: type_30;
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
                    phi_4613_ = false;
                    phi_1395_ = type_48(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e757);
                    phi_1398_ = ((3u * _e105) + 1u);
                    phi_1400_ = (_e759 <= _e757);
                    phi_1402_ = 0u;
                    phi_1404_ = type_62(type_42(vec4<f32>((f32(_e766) * _e163), (f32(_e772) * _e163), (f32(_e778) * _e163), 0f), vec4<f32>((f32(_e783) * _e163), (f32(_e787) * _e163), (f32(_e791) * _e163), 0f)), select(0u, 2147483648u, (_e105 == 0u)));
                    loop {
                        let _e801 = phi_4613_;
                        let _e803 = phi_1395_;
                        let _e805 = phi_1398_;
                        let _e807 = phi_1400_;
                        let _e809 = phi_1402_;
                        let _e811 = phi_1404_;
                        local_10 = _e803;
                        if _e807 {
                            phi_1415_ = true;
                        } else {
                            phi_1415_ = (_e809 > 0u);
                        }
                        let _e814 = phi_1415_;
                        if _e814 {
                            let _e815 = (_e805 > 0u);
                            if _e815 {
                                if _e807 {
                                    phi_1501_ = _e807;
                                    phi_1502_ = _e809;
                                    phi_1503_ = _e811;
                                } else {
                                    let _e816 = (_e809 - 1u);
                                    let _e817 = (_e816 % 128u);
                                    let _e818 = (_e817 < 128u);
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e820 = local_7[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e822 = local_6[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e824 = local_5[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e826 = local_4[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e828 = local_3[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e830 = local_2[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e835 = local_8[_e817];
                                    if _e818 {
                                    } else {
                                        phi_4799_ = true;
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
                                    let _e850 = ((_e846.member_1 & 2147483648u) != 0u);
                                    if _e850 {
                                        phi_1521_ = _e803;
                                        phi_1524_ = type_8(0u, ((_e846.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e857 = phi_1521_;
                                            let _e859 = phi_1524_;
                                            local_11 = _e857;
                                            if (_e859.member < _e859.member_1) {
                                                phi_1525_ = type_8((_e859.member + 1u), _e859.member_1);
                                                phi_1547_ = type_8(1u, _e859.member);
                                            } else {
                                                phi_1525_ = _e859;
                                                phi_1547_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e872 = phi_1525_;
                                            let _e874 = phi_1547_;
                                            let _e878 = (bitcast<i32>(_e874.member) != 0i);
                                            if _e878 {
                                                let _e879 = ((_e846.member_1 & 268435455u) + _e874.member_1);
                                                let _e880 = (_e879 < _e107);
                                                if _e880 {
                                                    if _e880 {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_5.member[_e879].member_1;
                                                    phi_1568_ = _e884;
                                                } else {
                                                    phi_1568_ = 4294967295u;
                                                }
                                                let _e886 = phi_1568_;
                                                if (_e879 >= _e107) {
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e880 {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e893 = global_5.member[_e879].member[_e763];
                                                    if (_e769 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_5.member[_e879].member[_e769];
                                                    if (_e775 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e905 = global_5.member[_e879].member[_e775];
                                                    let _e907 = (3u + _e763);
                                                    if (_e907 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e913 = global_5.member[_e879].member[_e907];
                                                    let _e914 = (3u + _e769);
                                                    if (_e914 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e920 = global_5.member[_e879].member[_e914];
                                                    let _e921 = (3u + _e775);
                                                    if (_e921 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e927 = global_5.member[_e879].member[_e921];
                                                    let _e929 = (6u + _e763);
                                                    if (_e929 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e935 = global_5.member[_e879].member[_e929];
                                                    let _e936 = (6u + _e769);
                                                    if (_e936 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e942 = global_5.member[_e879].member[_e936];
                                                    let _e943 = (6u + _e775);
                                                    if (_e943 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e949 = global_5.member[_e879].member[_e943];
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(_e893, _e899, _e905), array<f32, 3>(_e913, _e920, _e927), array<f32, 3>(_e935, _e942, _e949));
                                                }
                                                let _e953 = phi_1660_;
                                                let _e961 = (_e953[0][2] - _e606);
                                                let _e964 = (((_e953[0][0] - _e473) * _e645) - (_e961 * _e513));
                                                let _e967 = (((_e953[0][1] - _e540) * _e645) - (_e961 * _e579));
                                                let _e974 = (_e953[1][2] - _e606);
                                                let _e977 = (((_e953[1][0] - _e473) * _e645) - (_e974 * _e513));
                                                let _e980 = (((_e953[1][1] - _e540) * _e645) - (_e974 * _e579));
                                                let _e987 = (_e953[2][2] - _e606);
                                                let _e990 = (((_e953[2][0] - _e473) * _e645) - (_e987 * _e513));
                                                let _e993 = (((_e953[2][1] - _e540) * _e645) - (_e987 * _e579));
                                                let _e994 = (_e990 * _e980);
                                                let _e995 = (_e993 * _e977);
                                                let _e996 = (_e964 * _e993);
                                                let _e997 = (_e967 * _e990);
                                                let _e998 = (_e977 * _e967);
                                                let _e999 = (_e980 * _e964);
                                                let _e1004 = (((_e994 >= _e995) && (_e996 >= _e997)) && (_e998 >= _e999));
                                                if (_e1004 || (((_e994 <= _e995) && (_e996 <= _e997)) && (_e998 <= _e999))) {
                                                    let _e1011 = select(-1f, 1f, _e1004);
                                                    let _e1013 = ((_e994 - _e995) * _e1011);
                                                    let _e1015 = select(0f, _e1013, (_e1013 > 0f));
                                                    let _e1017 = ((_e996 - _e997) * _e1011);
                                                    let _e1019 = select(0f, _e1017, (_e1017 > 0f));
                                                    let _e1021 = ((_e998 - _e999) * _e1011);
                                                    let _e1023 = select(0f, _e1021, (_e1021 > 0f));
                                                    let _e1025 = ((_e1015 + _e1019) + _e1023);
                                                    if (_e1025 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2544_ = type_30();
                                                        phi_2545_ = true;
                                                        phi_2546_ = false;
                                                    } else {
                                                        let _e1028 = select(_e977, _e964, (_e964 < _e977));
                                                        if (select(_e990, _e1028, (_e1028 < _e990)) > 0f) {
                                                            phi_1812_ = true;
                                                        } else {
                                                            let _e1033 = select(_e977, _e964, (_e964 > _e977));
                                                            phi_1812_ = (select(_e990, _e1033, (_e1033 > _e990)) < 0f);
                                                        }
                                                        let _e1038 = phi_1812_;
                                                        if _e1038 {
                                                            phi_2541_ = type_30();
                                                            phi_2542_ = true;
                                                            phi_2543_ = false;
                                                        } else {
                                                            let _e1040 = select(_e980, _e967, (_e967 < _e980));
                                                            if (select(_e993, _e1040, (_e1040 < _e993)) > 0f) {
                                                                phi_1841_ = true;
                                                            } else {
                                                                let _e1045 = select(_e980, _e967, (_e967 > _e980));
                                                                phi_1841_ = (select(_e993, _e1045, (_e1045 > _e993)) < 0f);
                                                            }
                                                            let _e1050 = phi_1841_;
                                                            if _e1050 {
                                                                phi_2539_ = type_30();
                                                                phi_2540_ = false;
                                                            } else {
                                                                let _e1052 = select(_e953[1][0], _e953[0][0], (_e953[0][0] < _e953[1][0]));
                                                                let _e1056 = select(_e953[1][0], _e953[0][0], (_e953[0][0] > _e953[1][0]));
                                                                let _e1060 = select(_e953[1][1], _e953[0][1], (_e953[0][1] < _e953[1][1]));
                                                                let _e1064 = select(_e953[1][1], _e953[0][1], (_e953[0][1] > _e953[1][1]));
                                                                let _e1068 = select(_e953[1][2], _e953[0][2], (_e953[0][2] < _e953[1][2]));
                                                                let _e1072 = select(_e953[1][2], _e953[0][2], (_e953[0][2] > _e953[1][2]));
                                                                let _e1077 = ((select(_e953[2][0], _e1052, (_e1052 < _e953[2][0])) - _e511) * _e516);
                                                                let _e1078 = ((select(_e953[2][0], _e1056, (_e1056 > _e953[2][0])) - _e512) * _e516);
                                                                let _e1081 = ((select(_e953[2][1], _e1060, (_e1060 < _e953[2][1])) - _e577) * _e582);
                                                                let _e1082 = ((select(_e953[2][1], _e1064, (_e1064 > _e953[2][1])) - _e578) * _e582);
                                                                let _e1085 = ((select(_e953[2][2], _e1068, (_e1068 < _e953[2][2])) - _e643) * _e648);
                                                                let _e1086 = ((select(_e953[2][2], _e1072, (_e1072 > _e953[2][2])) - _e644) * _e648);
                                                                let _e1088 = select(_e1086, _e1085, (_e1085 < _e1086));
                                                                let _e1090 = select(_e1086, _e1085, (_e1085 > _e1086));
                                                                let _e1092 = select(_e1078, _e1077, (_e1077 < _e1078));
                                                                let _e1094 = select(_e1082, _e1081, (_e1081 < _e1082));
                                                                let _e1096 = select(_e1094, _e1092, (_e1092 > _e1094));
                                                                let _e1098 = select(_e1088, _e1096, (_e1096 > _e1088));
                                                                let _e1100 = select(_e1078, _e1077, (_e1077 > _e1078));
                                                                let _e1102 = select(_e1082, _e1081, (_e1081 > _e1082));
                                                                let _e1104 = select(_e1102, _e1100, (_e1100 < _e1102));
                                                                let _e1106 = select(_e1090, _e1104, (_e1104 < _e1090));
                                                                let _e1107 = -(_e1088);
                                                                let _e1113 = select(_e759, _e1098, (_e1098 > _e759));
                                                                if (_e1113 > (_e1106 + (select(_e1107, _e1090, (_e1090 > _e1107)) * 0.0000019073523f))) {
                                                                    phi_2534_ = type_30();
                                                                    phi_2535_ = true;
                                                                } else {
                                                                    let _e1115 = (_e1113 > _e857.member_1);
                                                                    if _e1115 {
                                                                        phi_2533_ = type_30();
                                                                    } else {
                                                                        let _e1116 = vec3<f32>(_e953[0][0], _e953[0][1], _e953[0][2]);
                                                                        let _e1117 = vec3<f32>(_e953[1][0], _e953[1][1], _e953[1][2]);
                                                                        let _e1118 = vec3<f32>(_e953[2][0], _e953[2][1], _e953[2][2]);
                                                                        let _e1119 = (_e953[1][0] - _e953[0][0]);
                                                                        let _e1120 = (_e953[1][1] - _e953[0][1]);
                                                                        let _e1121 = (_e953[1][2] - _e953[0][2]);
                                                                        let _e1122 = vec3<f32>(_e1119, _e1120, _e1121);
                                                                        let _e1123 = (_e953[2][0] - _e953[1][0]);
                                                                        let _e1124 = (_e953[2][1] - _e953[1][1]);
                                                                        let _e1125 = (_e953[2][2] - _e953[1][2]);
                                                                        let _e1126 = vec3<f32>(_e1123, _e1124, _e1125);
                                                                        let _e1127 = (_e953[0][0] - _e953[2][0]);
                                                                        let _e1128 = (_e953[0][1] - _e953[2][1]);
                                                                        let _e1129 = (_e953[0][2] - _e953[2][2]);
                                                                        let _e1130 = vec3<f32>(_e1127, _e1128, _e1129);
                                                                        let _e1133 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                                        let _e1136 = bitcast<f32>((bitcast<u32>(_e1120) & 2147483647u));
                                                                        let _e1138 = select(_e1136, _e1133, (_e1133 > _e1136));
                                                                        let _e1141 = bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u));
                                                                        let _e1143 = select(_e1141, _e1138, (_e1138 > _e1141));
                                                                        let _e1146 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                                        let _e1149 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                                                        let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                                        let _e1154 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                        let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                        let _e1159 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                        let _e1162 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                        let _e1164 = select(_e1162, _e1159, (_e1159 > _e1162));
                                                                        let _e1167 = bitcast<f32>((bitcast<u32>(_e1129) & 2147483647u));
                                                                        let _e1169 = select(_e1167, _e1164, (_e1164 > _e1167));
                                                                        let _e1171 = select(_e1156, _e1143, (_e1143 > _e1156));
                                                                        let _e1173 = select(_e1169, _e1171, (_e1171 > _e1169));
                                                                        if (_e1143 == _e1173) {
                                                                            phi_2260_ = _e980;
                                                                            phi_2261_ = _e977;
                                                                            phi_2262_ = _e967;
                                                                            phi_2263_ = _e964;
                                                                            phi_2264_ = _e1116;
                                                                            phi_2265_ = _e1130;
                                                                            phi_2266_ = _e1126;
                                                                            phi_2267_ = _e1122;
                                                                        } else {
                                                                            let _e1175 = (_e1156 == _e1173);
                                                                            let _e1180 = vec3(_e1175);
                                                                            phi_2260_ = select(_e967, _e993, _e1175);
                                                                            phi_2261_ = select(_e964, _e990, _e1175);
                                                                            phi_2262_ = select(_e993, _e980, _e1175);
                                                                            phi_2263_ = select(_e990, _e977, _e1175);
                                                                            phi_2264_ = select(_e1118, _e1117, _e1180);
                                                                            phi_2265_ = select(_e1126, _e1122, _e1180);
                                                                            phi_2266_ = select(_e1122, _e1130, _e1180);
                                                                            phi_2267_ = select(_e1130, _e1126, _e1180);
                                                                        }
                                                                        let _e1186 = phi_2260_;
                                                                        let _e1188 = phi_2261_;
                                                                        let _e1190 = phi_2262_;
                                                                        let _e1192 = phi_2263_;
                                                                        let _e1194 = phi_2264_;
                                                                        let _e1196 = phi_2265_;
                                                                        let _e1198 = phi_2266_;
                                                                        let _e1200 = phi_2267_;
                                                                        let _e1207 = ((_e1198.y * _e1196.z) - (_e1196.y * _e1198.z));
                                                                        let _e1212 = ((_e1198.z * _e1196.x) - (_e1196.z * _e1198.x));
                                                                        let _e1215 = ((_e1198.x * _e1196.y) - (_e1196.x * _e1198.y));
                                                                        if (_e1015 >= _e1019) {
                                                                            phi_2304_ = select(true, false, (_e1015 >= _e1023));
                                                                        } else {
                                                                            phi_2304_ = true;
                                                                        }
                                                                        let _e1220 = phi_2304_;
                                                                        if _e1220 {
                                                                            phi_2313_ = select(_e1118, _e1117, vec3((_e1019 >= _e1023)));
                                                                        } else {
                                                                            phi_2313_ = _e1116;
                                                                        }
                                                                        let _e1225 = phi_2313_;
                                                                        let _e1236 = (((_e1207 * (_e1225.x - _e473)) + (_e1212 * (_e1225.y - _e540))) + (_e1215 * (_e1225.z - _e606)));
                                                                        let _e1241 = (((_e1207 * _e513) + (_e1212 * _e579)) + (_e1215 * _e645));
                                                                        let _e1242 = (_e1188 - _e1192);
                                                                        let _e1243 = (_e1186 - _e1190);
                                                                        let _e1251 = (-(((_e1192 * _e1242) + (_e1190 * _e1243))) / ((_e1242 * _e1242) + (_e1243 * _e1243)));
                                                                        let _e1253 = select(1f, _e1251, (_e1251 < 1f));
                                                                        let _e1255 = select(0f, _e1253, (_e1253 > 0f));
                                                                        let _e1268 = ((_e1194.x + (_e1200.x * _e1255)) - _e473);
                                                                        let _e1269 = ((_e1194.y + (_e1200.y * _e1255)) - _e540);
                                                                        let _e1270 = ((_e1194.z + (_e1200.z * _e1255)) - _e606);
                                                                        let _e1271 = (_e1270 / _e645);
                                                                        let _e1283 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                        let _e1286 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                        let _e1288 = select(_e1286, _e1283, (_e1283 > _e1286));
                                                                        let _e1291 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                        let _e1293 = select(_e1291, _e1288, (_e1288 > _e1291));
                                                                        let _e1299 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                        let _e1302 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                        let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                                                                        let _e1307 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1207 * _e1268) + (_e1212 * _e1269)) + (_e1215 * _e1270)) - _e1236)) & 2147483647u)) <= ((0.0000009536743f * select(_e1173, _e1293, (_e1293 > _e1173))) * select(_e1307, _e1304, (_e1304 > _e1307)))) {
                                                                            let _e1317 = bitcast<f32>((bitcast<u32>(_e1198.x) & 2147483647u));
                                                                            let _e1320 = bitcast<f32>((bitcast<u32>(_e1198.y) & 2147483647u));
                                                                            let _e1322 = select(_e1320, _e1317, (_e1317 > _e1320));
                                                                            let _e1325 = bitcast<f32>((bitcast<u32>(_e1198.z) & 2147483647u));
                                                                            let _e1331 = bitcast<f32>((bitcast<u32>(_e1196.x) & 2147483647u));
                                                                            let _e1334 = bitcast<f32>((bitcast<u32>(_e1196.y) & 2147483647u));
                                                                            let _e1336 = select(_e1334, _e1331, (_e1331 > _e1334));
                                                                            let _e1339 = bitcast<f32>((bitcast<u32>(_e1196.z) & 2147483647u));
                                                                            let _e1343 = (bitcast<f32>((bitcast<u32>(_e1241) & 2147483647u)) > ((0.0000038146973f * select(_e1325, _e1322, (_e1322 > _e1325))) * select(_e1339, _e1336, (_e1336 > _e1339))));
                                                                            if _e1343 {
                                                                                phi_2478_ = (_e1236 / _e1241);
                                                                            } else {
                                                                                phi_2478_ = f32();
                                                                            }
                                                                            let _e1346 = phi_2478_;
                                                                            phi_2480_ = _e1346;
                                                                            phi_2481_ = select(true, false, _e1343);
                                                                        } else {
                                                                            phi_2480_ = f32();
                                                                            phi_2481_ = true;
                                                                        }
                                                                        let _e1349 = phi_2480_;
                                                                        let _e1351 = phi_2481_;
                                                                        if _e1351 {
                                                                            let _e1359 = (((_e1207 * (_e1268 - (_e513 * _e1271))) + (_e1212 * (_e1269 - (_e579 * _e1271)))) / _e1241);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u)) <= _e1173) {
                                                                                phi_2501_ = (_e1271 + _e1359);
                                                                            } else {
                                                                                phi_2501_ = _e1271;
                                                                            }
                                                                            let _e1366 = phi_2501_;
                                                                            phi_2502_ = _e1366;
                                                                        } else {
                                                                            phi_2502_ = _e1349;
                                                                        }
                                                                        let _e1368 = phi_2502_;
                                                                        let _e1370 = select(_e1106, _e1368, (_e1368 < _e1106));
                                                                        let _e1372 = select(_e1098, _e1370, (_e1370 > _e1098));
                                                                        if (_e1372 >= _e759) {
                                                                            let _e1374 = (_e1372 <= _e857.member_1);
                                                                            if _e1374 {
                                                                                let _e1375 = (1f / _e1025);
                                                                                phi_2525_ = type_30(_e1372, (_e1019 * _e1375), (_e1023 * _e1375), _e886);
                                                                            } else {
                                                                                phi_2525_ = type_30();
                                                                            }
                                                                            let _e1380 = phi_2525_;
                                                                            phi_2527_ = _e1380;
                                                                            phi_2528_ = select(true, false, _e1374);
                                                                        } else {
                                                                            phi_2527_ = type_30();
                                                                            phi_2528_ = true;
                                                                        }
                                                                        let _e1383 = phi_2527_;
                                                                        let _e1385 = phi_2528_;
                                                                        if _e1385 {
                                                                            phi_2532_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2532_ = _e1383;
                                                                        }
                                                                        let _e1387 = phi_2532_;
                                                                        phi_2533_ = _e1387;
                                                                    }
                                                                    let _e1389 = phi_2533_;
                                                                    phi_2534_ = _e1389;
                                                                    phi_2535_ = _e1115;
                                                                }
                                                                let _e1391 = phi_2534_;
                                                                let _e1393 = phi_2535_;
                                                                phi_2539_ = _e1391;
                                                                phi_2540_ = _e1393;
                                                            }
                                                            let _e1395 = phi_2539_;
                                                            let _e1397 = phi_2540_;
                                                            phi_2541_ = _e1395;
                                                            phi_2542_ = _e1050;
                                                            phi_2543_ = _e1397;
                                                        }
                                                        let _e1399 = phi_2541_;
                                                        let _e1401 = phi_2542_;
                                                        let _e1403 = phi_2543_;
                                                        phi_2544_ = _e1399;
                                                        phi_2545_ = _e1401;
                                                        phi_2546_ = _e1403;
                                                    }
                                                    let _e1405 = phi_2544_;
                                                    let _e1407 = phi_2545_;
                                                    let _e1409 = phi_2546_;
                                                    phi_2554_ = _e1405;
                                                    phi_2555_ = select(_e1409, true, _e1407);
                                                } else {
                                                    phi_2554_ = type_30();
                                                    phi_2555_ = true;
                                                }
                                                let _e1412 = phi_2554_;
                                                let _e1414 = phi_2555_;
                                                if _e1414 {
                                                    phi_2559_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2559_ = _e1412;
                                                }
                                                let _e1416 = phi_2559_;
                                                if (_e1416.member_3 != 4294967295u) {
                                                    if (_e886 == _e172) {
                                                        phi_2894_ = false;
                                                    } else {
                                                        let _e1420 = (_e886 < arrayLength((&global_6.member)));
                                                        if _e1420 {
                                                            if _e1420 {
                                                            } else {
                                                                phi_4607_ = true;
                                                                break;
                                                            }
                                                            let _e1422 = global_6.member[_e886];
                                                            phi_2582_ = _e1422;
                                                        } else {
                                                            phi_2582_ = 4294967295u;
                                                        }
                                                        let _e1424 = phi_2582_;
                                                        let _e1425 = (_e1424 < arrayLength((&global_7.member)));
                                                        if _e1425 {
                                                            if _e1425 {
                                                            } else {
                                                                phi_4607_ = true;
                                                                break;
                                                            }
                                                            let _e1427 = global_7.member[_e1424];
                                                            phi_2596_ = _e1427;
                                                        } else {
                                                            phi_2596_ = 0i;
                                                        }
                                                        let _e1429 = phi_2596_;
                                                        let _e1430 = (_e1429 == 0i);
                                                        if _e1430 {
                                                            phi_2893_ = true;
                                                        } else {
                                                            if _e450 {
                                                                phi_2619_ = vec3<f32>(_e953[0][0], _e953[0][1], _e953[0][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2618_ = vec3<f32>(_e953[0][2], _e953[0][0], _e953[0][1]);
                                                                } else {
                                                                    phi_2618_ = vec3<f32>(_e953[0][1], _e953[0][2], _e953[0][0]);
                                                                }
                                                                let _e1435 = phi_2618_;
                                                                phi_2619_ = _e1435;
                                                            }
                                                            let _e1438 = phi_2619_;
                                                            if _e450 {
                                                                phi_2638_ = vec3<f32>(_e953[1][0], _e953[1][1], _e953[1][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2637_ = vec3<f32>(_e953[1][2], _e953[1][0], _e953[1][1]);
                                                                } else {
                                                                    phi_2637_ = vec3<f32>(_e953[1][1], _e953[1][2], _e953[1][0]);
                                                                }
                                                                let _e1443 = phi_2637_;
                                                                phi_2638_ = _e1443;
                                                            }
                                                            let _e1446 = phi_2638_;
                                                            if _e450 {
                                                                phi_2657_ = vec3<f32>(_e953[2][0], _e953[2][1], _e953[2][2]);
                                                            } else {
                                                                if (_e426 == 1u) {
                                                                    phi_2656_ = vec3<f32>(_e953[2][2], _e953[2][0], _e953[2][1]);
                                                                } else {
                                                                    phi_2656_ = vec3<f32>(_e953[2][1], _e953[2][2], _e953[2][0]);
                                                                }
                                                                let _e1451 = phi_2656_;
                                                                phi_2657_ = _e1451;
                                                            }
                                                            let _e1454 = phi_2657_;
                                                            let _e1457 = (_e1446.x - _e1438.x);
                                                            let _e1460 = (_e1446.y - _e1438.y);
                                                            let _e1463 = (_e1446.z - _e1438.z);
                                                            let _e1465 = (_e1454.x - _e1438.x);
                                                            let _e1467 = (_e1454.y - _e1438.y);
                                                            let _e1469 = (_e1454.z - _e1438.z);
                                                            if (_e304.member_1 == 1u) {
                                                                phi_2693_ = (vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]) - _e1438);
                                                            } else {
                                                                phi_2693_ = vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]);
                                                            }
                                                            let _e1484 = phi_2693_;
                                                            let _e1490 = bitcast<f32>((bitcast<u32>((_e1457 * _e1467)) ^ _e304.member_3[0]));
                                                            let _e1494 = bitcast<f32>((bitcast<u32>((_e1460 * _e1465)) ^ _e304.member_3[0]));
                                                            let _e1498 = bitcast<f32>((bitcast<u32>((_e1460 * _e1469)) ^ _e304.member_3[0]));
                                                            let _e1502 = bitcast<f32>((bitcast<u32>((_e1463 * _e1467)) ^ _e304.member_3[0]));
                                                            let _e1506 = bitcast<f32>((bitcast<u32>((_e1463 * _e1465)) ^ _e304.member_3[0]));
                                                            let _e1510 = bitcast<f32>((bitcast<u32>((_e1457 * _e1469)) ^ _e304.member_3[0]));
                                                            let _e1511 = (_e1498 - _e1502);
                                                            let _e1512 = (_e1506 - _e1510);
                                                            let _e1513 = (_e1490 - _e1494);
                                                            let _e1537 = (bitcast<f32>((bitcast<u32>(_e1498) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1502) & 2147483647u)));
                                                            let _e1544 = (bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1510) & 2147483647u)));
                                                            let _e1551 = (bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1494) & 2147483647u)));
                                                            if (_e304.member_2 == 0f) {
                                                                phi_2875_ = 0f;
                                                            } else {
                                                                let _e1581 = bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u));
                                                                let _e1584 = bitcast<f32>((bitcast<u32>(_e1512) & 2147483647u));
                                                                let _e1587 = bitcast<f32>((bitcast<u32>(_e1513) & 2147483647u));
                                                                let _e1589 = select(_e1587, _e1584, (_e1584 > _e1587));
                                                                let _e1593 = select(_e1587, _e1584, (_e1584 < _e1587));
                                                                let _e1597 = select(_e1584, _e1581, (_e1581 < _e1584));
                                                                let _e1599 = select(_e1584, _e1581, (_e1581 > _e1584));
                                                                let _e1601 = select(_e1587, _e1599, (_e1599 < _e1587));
                                                                phi_2875_ = bitcast<f32>((bitcast<u32>((_e304.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1589, _e1581, (_e1581 > _e1589)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1601, _e1597, (_e1597 > _e1601)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1593, _e1581, (_e1581 < _e1593)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1537 + _e1544) + _e1551))) ^ _e304.member_3[0]))) * 1.0000005f)) ^ _e304.member_3[0])))) ^ _e304.member_3[0]));
                                                            }
                                                            let _e1628 = phi_2875_;
                                                            phi_2893_ = (_e1430 || !(((((bitcast<f32>((bitcast<u32>((_e1484.x * _e1511)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1484.y * _e1512)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1484.z * _e1513)) ^ _e304.member_3[0]))) * f32(-(_e1429))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1484.x) & 2147483647u)) * _e1537)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1484.y) & 2147483647u)) * _e1544)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1484.z) & 2147483647u)) * _e1551)) ^ _e304.member_3[0]))))) ^ _e304.member_3[0])) + _e1628) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1642 = phi_2893_;
                                                        phi_2894_ = _e1642;
                                                    }
                                                    let _e1644 = phi_2894_;
                                                    if _e1644 {
                                                        if (_e1416.member < _e857.member.member) {
                                                            phi_2914_ = true;
                                                        } else {
                                                            if (_e1416.member == _e857.member.member) {
                                                                phi_2913_ = (_e1416.member_3 < _e857.member.member_3);
                                                            } else {
                                                                phi_2913_ = false;
                                                            }
                                                            let _e1654 = phi_2913_;
                                                            phi_2914_ = _e1654;
                                                        }
                                                        let _e1656 = phi_2914_;
                                                        if _e1656 {
                                                            phi_2920_ = type_48(_e1416, _e1416.member);
                                                        } else {
                                                            phi_2920_ = _e857;
                                                        }
                                                        let _e1659 = phi_2920_;
                                                        phi_2921_ = _e1659;
                                                    } else {
                                                        phi_2921_ = _e857;
                                                    }
                                                    let _e1661 = phi_2921_;
                                                    phi_2922_ = _e1661;
                                                } else {
                                                    phi_2922_ = _e857;
                                                }
                                                let _e1663 = phi_2922_;
                                                phi_1522_ = _e1663;
                                            } else {
                                                phi_1522_ = type_48();
                                            }
                                            let _e1665 = phi_1522_;
                                            continue;
                                            continuing {
                                                phi_1521_ = _e1665;
                                                phi_1524_ = _e872;
                                                phi_4607_ = _e801;
                                                break if !(_e878);
                                            }
                                        }
                                        let _e1668 = phi_4607_;
                                        phi_4799_ = _e1668;
                                        if _e1668 {
                                            break;
                                        }
                                        phi_4885_ = _e1668;
                                        let _e2425 = local_11;
                                        phi_2923_ = _e2425;
                                    } else {
                                        phi_4885_ = _e801;
                                        phi_2923_ = _e803;
                                    }
                                    let _e1670 = phi_4885_;
                                    let _e1672 = phi_2923_;
                                    if _e850 {
                                        phi_4153_ = bool();
                                        phi_4154_ = u32();
                                        phi_4155_ = type_62();
                                    } else {
                                        if (_e846.member_1 >= _e105) {
                                            phi_3689_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e846.member_1 < _e105) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1676 = ((1u + _e426) % 4u);
                                            if (_e1676 < 4u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1681 = global_4.member[_e846.member_1][_e1676];
                                            let _e1683 = (_e1681 >> bitcast<u32>(11u));
                                            let _e1685 = ((1u + _e425) % 4u);
                                            if (_e1685 < 4u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1690 = global_4.member[_e846.member_1][_e1685];
                                            let _e1692 = (_e1690 >> bitcast<u32>(11u));
                                            let _e1694 = ((1u + _e427) % 4u);
                                            if (_e1694 < 4u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1699 = global_4.member[_e846.member_1][_e1694];
                                            let _e1701 = (_e1699 >> bitcast<u32>(11u));
                                            let _e1724 = (bitcast<f32>((bitcast<u32>((_e846.member.member_1.x - _e846.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1725 = (bitcast<f32>((bitcast<u32>((_e846.member.member_1.y - _e846.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1726 = (bitcast<f32>((bitcast<u32>((_e846.member.member_1.z - _e846.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1728 = select(_e163, _e1724, (_e1724 > _e163));
                                            let _e1730 = select(_e163, _e1725, (_e1725 > _e163));
                                            let _e1732 = select(_e163, _e1726, (_e1726 > _e163));
                                            let _e1763 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1681 & 1023u))) - 8388608f) * _e1728));
                                            let _e1768 = (bitcast<i32>((_e1681 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1771 = bitcast<f32>((_e1763 & bitcast<u32>(_e1768)));
                                            let _e1772 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1690 & 1023u))) - 8388608f) * _e1730));
                                            let _e1777 = (bitcast<i32>((_e1690 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1780 = bitcast<f32>((_e1772 & bitcast<u32>(_e1777)));
                                            let _e1781 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1699 & 1023u))) - 8388608f) * _e1732));
                                            let _e1786 = (bitcast<i32>((_e1699 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1789 = bitcast<f32>((_e1781 & bitcast<u32>(_e1786)));
                                            let _e1793 = bitcast<f32>((_e1763 & bitcast<u32>(~(_e1768))));
                                            let _e1797 = bitcast<f32>((_e1772 & bitcast<u32>(~(_e1777))));
                                            let _e1801 = bitcast<f32>((_e1781 & bitcast<u32>(~(_e1786))));
                                            let _e1802 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1683 & 1023u))) - 8388608f) * _e1728));
                                            let _e1807 = (bitcast<i32>((_e1683 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1810 = bitcast<f32>((_e1802 & bitcast<u32>(_e1807)));
                                            let _e1811 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1692 & 1023u))) - 8388608f) * _e1730));
                                            let _e1816 = (bitcast<i32>((_e1692 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1819 = bitcast<f32>((_e1811 & bitcast<u32>(_e1816)));
                                            let _e1820 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1701 & 1023u))) - 8388608f) * _e1732));
                                            let _e1825 = (bitcast<i32>((_e1701 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1828 = bitcast<f32>((_e1820 & bitcast<u32>(_e1825)));
                                            let _e1832 = bitcast<f32>((_e1802 & bitcast<u32>(~(_e1807))));
                                            let _e1836 = bitcast<f32>((_e1811 & bitcast<u32>(~(_e1816))));
                                            let _e1840 = bitcast<f32>((_e1820 & bitcast<u32>(~(_e1825))));
                                            let _e1870 = global_4.member[_e846.member_1][0u];
                                            let _e1874 = global_4.member[_e846.member_1][1u];
                                            let _e1878 = global_4.member[_e846.member_1][2u];
                                            let _e1882 = global_4.member[_e846.member_1][3u];
                                            let _e1894 = (((_e1874 >> bitcast<u32>(22i)) | ((_e1878 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1882 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1895 = (_e1870 & 268435455u);
                                            let _e1896 = (_e1894 & 268435455u);
                                            let _e1899 = ((_e1870 >> bitcast<u32>(28u)) & 7u);
                                            let _e1907 = ((_e1870 >> bitcast<u32>(31i)) | (((_e1894 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1908 = (_e1899 != 0u);
                                            if (_e1899 == 0u) {
                                                phi_3651_ = _e1895;
                                            } else {
                                                if (_e1899 == 7u) {
                                                    phi_3650_ = 2147483648u;
                                                } else {
                                                    phi_3650_ = ((2147483648u | (_e1899 << bitcast<u32>(28u))) | (_e1896 & 268435455u));
                                                }
                                                let _e1917 = phi_3650_;
                                                phi_3651_ = _e1917;
                                            }
                                            let _e1919 = phi_3651_;
                                            if _e1908 {
                                                let _e1920 = (_e1899 != 7u);
                                                if _e1920 {
                                                    phi_3661_ = (_e1896 + _e1899);
                                                } else {
                                                    phi_3661_ = u32();
                                                }
                                                let _e1923 = phi_3661_;
                                                phi_3663_ = _e1923;
                                                phi_3664_ = select(true, false, _e1920);
                                            } else {
                                                phi_3663_ = u32();
                                                phi_3664_ = true;
                                            }
                                            let _e1926 = phi_3663_;
                                            let _e1928 = phi_3664_;
                                            if (_e1907 == 0u) {
                                                phi_3685_ = (_e1895 + select(0u, 1u, !(_e1908)));
                                            } else {
                                                if (_e1907 == 7u) {
                                                    phi_3684_ = 2147483648u;
                                                } else {
                                                    phi_3684_ = ((2147483648u | (_e1907 << bitcast<u32>(28u))) | (select(_e1926, _e1896, _e1928) & 268435455u));
                                                }
                                                let _e1941 = phi_3684_;
                                                phi_3685_ = _e1941;
                                            }
                                            let _e1943 = phi_3685_;
                                            phi_3689_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e846.member.member.x + _e1771), (_e846.member.member.x + _e1793), (_e846.member.member_1.x - _e1810), (_e846.member.member_1.x - _e1832)), vec4<f32>((_e846.member.member.y + _e1780), (_e846.member.member.y + _e1797), (_e846.member.member_1.y - _e1819), (_e846.member.member_1.y - _e1836)), vec4<f32>((_e846.member.member.z + _e1789), (_e846.member.member.z + _e1801), (_e846.member.member_1.z - _e1828), (_e846.member.member_1.z - _e1840))), type_62(type_42((_e846.member.member + vec4<f32>(_e1771, _e1780, _e1789, 0f)), (_e846.member.member_1 - vec4<f32>(_e1810, _e1819, _e1828, 0f))), _e1919), type_62(type_42((_e846.member.member + vec4<f32>(_e1793, _e1797, _e1801, 0f)), (_e846.member.member_1 - vec4<f32>(_e1832, _e1836, _e1840, 0f))), _e1943));
                                        }
                                        let _e1948 = phi_3689_;
                                        let _e1960 = ((_e1948.member[0].x - _e511) * _e516);
                                        let _e1961 = ((_e1948.member[0].y - _e511) * _e516);
                                        let _e1962 = ((_e1948.member[0].z - _e512) * _e516);
                                        let _e1963 = ((_e1948.member[0].w - _e512) * _e516);
                                        let _e1973 = ((_e1948.member[1].x - _e577) * _e582);
                                        let _e1974 = ((_e1948.member[1].y - _e577) * _e582);
                                        let _e1975 = ((_e1948.member[1].z - _e578) * _e582);
                                        let _e1976 = ((_e1948.member[1].w - _e578) * _e582);
                                        let _e1986 = ((_e1948.member[2].x - _e643) * _e648);
                                        let _e1987 = ((_e1948.member[2].y - _e643) * _e648);
                                        let _e1988 = ((_e1948.member[2].z - _e644) * _e648);
                                        let _e1989 = ((_e1948.member[2].w - _e644) * _e648);
                                        let _e1991 = select(_e1988, _e1986, (_e1986 < _e1988));
                                        let _e1993 = select(_e1989, _e1987, (_e1987 < _e1989));
                                        let _e1995 = select(_e1988, _e1986, (_e1986 > _e1988));
                                        let _e1997 = select(_e1989, _e1987, (_e1987 > _e1989));
                                        let _e1999 = select(_e1962, _e1960, (_e1960 < _e1962));
                                        let _e2001 = select(_e1963, _e1961, (_e1961 < _e1963));
                                        let _e2003 = select(_e1975, _e1973, (_e1973 < _e1975));
                                        let _e2005 = select(_e1976, _e1974, (_e1974 < _e1976));
                                        let _e2007 = select(_e2003, _e1999, (_e1999 > _e2003));
                                        let _e2009 = select(_e2005, _e2001, (_e2001 > _e2005));
                                        let _e2011 = select(_e1991, _e2007, (_e2007 > _e1991));
                                        let _e2013 = select(_e1993, _e2009, (_e2009 > _e1993));
                                        let _e2015 = select(_e1962, _e1960, (_e1960 > _e1962));
                                        let _e2017 = select(_e1963, _e1961, (_e1961 > _e1963));
                                        let _e2019 = select(_e1975, _e1973, (_e1973 > _e1975));
                                        let _e2021 = select(_e1976, _e1974, (_e1974 > _e1976));
                                        let _e2023 = select(_e2019, _e2015, (_e2015 < _e2019));
                                        let _e2025 = select(_e2021, _e2017, (_e2017 < _e2021));
                                        let _e2030 = -(_e1991);
                                        let _e2031 = -(_e1993);
                                        let _e2038 = (select(_e1995, _e2023, (_e2023 < _e1995)) + (select(_e2030, _e1995, (_e1995 > _e2030)) * 0.0000019073523f));
                                        let _e2039 = (select(_e1997, _e2025, (_e2025 < _e1997)) + (select(_e2031, _e1997, (_e1997 > _e2031)) * 0.0000019073523f));
                                        let _e2041 = select(_e759, _e2011, (_e2011 > _e759));
                                        let _e2043 = select(_e759, _e2013, (_e2013 > _e759));
                                        let _e2048 = (_e2041 <= select(_e1672.member_1, _e2038, (_e2038 < _e1672.member_1)));
                                        let _e2049 = (_e2043 <= select(_e1672.member_1, _e2039, (_e2039 < _e1672.member_1)));
                                        let _e2050 = (_e2041 <= _e2043);
                                        if _e2048 {
                                            if _e2049 {
                                                if _e2050 {
                                                    phi_4051_ = _e1948.member_2;
                                                } else {
                                                    phi_4051_ = _e1948.member_1;
                                                }
                                                let _e2054 = phi_4051_;
                                                let _e2075 = (_e844 % 128u);
                                                let _e2076 = (_e2075 < 128u);
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_8[_e2075] = _e2054.member_1;
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_7[_e2075] = _e2054.member.member.x;
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_6[_e2075] = _e2054.member.member.y;
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_5[_e2075] = _e2054.member.member.z;
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_4[_e2075] = _e2054.member.member_1.x;
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_3[_e2075] = _e2054.member.member_1.y;
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_2[_e2075] = _e2054.member.member_1.z;
                                                if _e2076 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_9[_e2075] = select(_e2041, _e2043, _e2050);
                                                if _e2050 {
                                                    phi_4127_ = _e1948.member_1;
                                                } else {
                                                    phi_4127_ = _e1948.member_2;
                                                }
                                                let _e2089 = phi_4127_;
                                                phi_4128_ = (_e844 + 1u);
                                                phi_4129_ = _e2089;
                                            } else {
                                                phi_4128_ = u32();
                                                phi_4129_ = type_62();
                                            }
                                            let _e2091 = phi_4128_;
                                            let _e2093 = phi_4129_;
                                            phi_4131_ = _e2091;
                                            phi_4132_ = _e2093;
                                            phi_4133_ = select(true, false, _e2049);
                                        } else {
                                            phi_4131_ = u32();
                                            phi_4132_ = type_62();
                                            phi_4133_ = true;
                                        }
                                        let _e2096 = phi_4131_;
                                        let _e2098 = phi_4132_;
                                        let _e2100 = phi_4133_;
                                        if _e2100 {
                                            if _e2048 {
                                                phi_4142_ = _e1948.member_1;
                                            } else {
                                                phi_4142_ = _e1948.member_2;
                                            }
                                            let _e2104 = phi_4142_;
                                            phi_4147_ = select(_e2049, true, _e2048);
                                            phi_4149_ = _e2104;
                                        } else {
                                            phi_4147_ = _e842;
                                            phi_4149_ = _e2098;
                                        }
                                        let _e2107 = phi_4147_;
                                        let _e2109 = phi_4149_;
                                        phi_4153_ = _e2107;
                                        phi_4154_ = select(_e2096, _e844, _e2100);
                                        phi_4155_ = _e2109;
                                    }
                                    let _e2112 = phi_4153_;
                                    let _e2114 = phi_4154_;
                                    let _e2116 = phi_4155_;
                                    if _e850 {
                                        phi_4165_ = _e846;
                                    } else {
                                        phi_4165_ = _e2116;
                                    }
                                    let _e2118 = phi_4165_;
                                    phi_4802_ = _e1670;
                                    phi_4166_ = _e1672;
                                    phi_4167_ = (_e805 - 1u);
                                    phi_4168_ = select(_e2112, false, _e850);
                                    phi_4169_ = select(_e2114, _e844, _e850);
                                    phi_4170_ = _e2118;
                                } else {
                                    phi_4802_ = _e801;
                                    phi_4166_ = _e803;
                                    phi_4167_ = _e805;
                                    phi_4168_ = _e842;
                                    phi_4169_ = _e844;
                                    phi_4170_ = _e846;
                                }
                                let _e2122 = phi_4802_;
                                let _e2124 = phi_4166_;
                                let _e2126 = phi_4167_;
                                let _e2128 = phi_4168_;
                                let _e2130 = phi_4169_;
                                let _e2132 = phi_4170_;
                                phi_4801_ = _e2122;
                                phi_4171_ = _e2124;
                                phi_4172_ = _e2126;
                                phi_4173_ = _e2128;
                                phi_4174_ = _e2130;
                                phi_4175_ = _e2132;
                            } else {
                                phi_4801_ = _e801;
                                phi_4171_ = type_48();
                                phi_4172_ = u32();
                                phi_4173_ = bool();
                                phi_4174_ = u32();
                                phi_4175_ = type_62();
                            }
                            let _e2134 = phi_4801_;
                            let _e2136 = phi_4171_;
                            let _e2138 = phi_4172_;
                            let _e2140 = phi_4173_;
                            let _e2142 = phi_4174_;
                            let _e2144 = phi_4175_;
                            phi_4800_ = _e2134;
                            phi_1396_ = _e2136;
                            phi_1399_ = _e2138;
                            phi_1401_ = _e2140;
                            phi_1403_ = _e2142;
                            phi_1405_ = _e2144;
                            phi_4176_ = _e815;
                        } else {
                            phi_4800_ = _e801;
                            phi_1396_ = type_48();
                            phi_1399_ = u32();
                            phi_1401_ = bool();
                            phi_1403_ = u32();
                            phi_1405_ = type_62();
                            phi_4176_ = false;
                        }
                        let _e2146 = phi_4800_;
                        let _e2148 = phi_1396_;
                        let _e2150 = phi_1399_;
                        let _e2152 = phi_1401_;
                        let _e2154 = phi_1403_;
                        let _e2156 = phi_1405_;
                        let _e2158 = phi_4176_;
                        continue;
                        continuing {
                            phi_4613_ = _e2146;
                            phi_1395_ = _e2148;
                            phi_1398_ = _e2150;
                            phi_1400_ = _e2152;
                            phi_1402_ = _e2154;
                            phi_1404_ = _e2156;
                            phi_4799_ = _e2146;
                            break if !(_e2158);
                        }
                    }
                    let _e2161 = phi_4799_;
                    if _e2161 {
                        break;
                    }
                    let _e2163 = local_10;
                    if (_e2163.member.member_3 != 4294967295u) {
                        let _e2168 = bitcast<u32>(_e2163.member.member);
                        let _e2172 = (bitcast<i32>((_e2168 >> bitcast<u32>(23i))) & 255i);
                        let _e2173 = (_e2172 + _e428);
                        if (_e2172 == 255i) {
                            phi_4235_ = _e2163.member.member;
                        } else {
                            if (_e2172 > 0i) {
                                if (_e2173 > 0i) {
                                    let _e2177 = (_e2173 < 255i);
                                    if _e2177 {
                                        phi_4214_ = bitcast<f32>((_e2168 + bitcast<u32>((_e428 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4214_ = f32();
                                    }
                                    let _e2184 = phi_4214_;
                                    phi_4216_ = _e2184;
                                    phi_4217_ = select(true, false, _e2177);
                                } else {
                                    phi_4216_ = f32();
                                    phi_4217_ = true;
                                }
                                let _e2187 = phi_4216_;
                                let _e2189 = phi_4217_;
                                phi_4218_ = _e2187;
                                phi_4219_ = _e2189;
                            } else {
                                phi_4218_ = f32();
                                phi_4219_ = true;
                            }
                            let _e2191 = phi_4218_;
                            let _e2193 = phi_4219_;
                            if _e2193 {
                                let _e2194 = (_e2168 & 2147483648u);
                                let _e2201 = ((_e2168 & 8388607u) | (select(0u, 1u, ((_e2168 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2205 = (_e2201 == 0u);
                                if _e2205 {
                                    phi_4565_ = bitcast<f32>(_e2194);
                                } else {
                                    let _e2210 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2201)), 32u, _e2205) - 8u);
                                    let _e2213 = (_e2201 << bitcast<u32>((_e2210 & 31u)));
                                    let _e2215 = ((_e2173 + select(0i, 1i, (_e2172 == 0i))) - bitcast<i32>(_e2210));
                                    if (_e2215 >= 255i) {
                                        phi_4555_ = bitcast<f32>((_e2194 | 2139095040u));
                                        phi_4556_ = f32();
                                        phi_4557_ = true;
                                    } else {
                                        let _e2217 = (_e2215 > 0i);
                                        if _e2217 {
                                            phi_4549_ = bitcast<f32>(((_e2194 | (bitcast<u32>(_e2215) << bitcast<u32>(23i))) | (_e2213 & 8388607u)));
                                            phi_4550_ = f32();
                                        } else {
                                            if (_e2215 < -24i) {
                                                phi_4515_ = 26u;
                                            } else {
                                                phi_4515_ = bitcast<u32>((1i - _e2215));
                                            }
                                            let _e2222 = phi_4515_;
                                            let _e2223 = (_e2222 & 31u);
                                            let _e2225 = (_e2213 >> bitcast<u32>(_e2223));
                                            let _e2229 = (_e2213 & ((1u << bitcast<u32>(_e2223)) - 1u));
                                            let _e2233 = (1u << bitcast<u32>(((_e2222 - 1u) & 31u)));
                                            if (_e2229 > _e2233) {
                                                phi_4536_ = true;
                                            } else {
                                                if (_e2229 == _e2233) {
                                                    phi_4533_ = ((_e2225 & 1u) == 1u);
                                                } else {
                                                    phi_4533_ = false;
                                                }
                                                let _e2239 = phi_4533_;
                                                phi_4536_ = _e2239;
                                            }
                                            let _e2241 = phi_4536_;
                                            phi_4549_ = f32();
                                            phi_4550_ = bitcast<f32>((_e2194 | (_e2225 + select(0u, 1u, _e2241))));
                                        }
                                        let _e2254 = phi_4549_;
                                        let _e2256 = phi_4550_;
                                        phi_4555_ = _e2254;
                                        phi_4556_ = _e2256;
                                        phi_4557_ = _e2217;
                                    }
                                    let _e2260 = phi_4555_;
                                    let _e2262 = phi_4556_;
                                    let _e2264 = phi_4557_;
                                    phi_4565_ = select(_e2262, _e2260, _e2264);
                                }
                                let _e2268 = phi_4565_;
                                phi_4234_ = _e2268;
                            } else {
                                phi_4234_ = _e2191;
                            }
                            let _e2270 = phi_4234_;
                            phi_4235_ = _e2270;
                        }
                        let _e2272 = phi_4235_;
                        let _e2273 = bitcast<u32>(_e2272);
                        if ((_e2273 & 2147483647u) >= 2139095040u) {
                            phi_4247_ = bitcast<f32>(((_e2273 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4247_ = _e2272;
                        }
                        let _e2280 = phi_4247_;
                        phi_4252_ = type_30(_e2280, _e2163.member.member_1, _e2163.member.member_2, _e2163.member.member_3);
                    } else {
                        phi_4252_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2285 = phi_4252_;
                    if _e305 {
                    } else {
                        break;
                    }
                    global_9.member[_e151] = _e2285;
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e2289 = select(0u, 1u, (_e372 <= _e382));
                    if (_e2289 > 0u) {
                        let _e2291 = (1u < _e119);
                        if _e2291 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e2295 = atomicAdd((&global_10.member[0u]), _e2289);
                            if ((_e2295 + _e2289) < _e2295) {
                                if _e2291 {
                                } else {
                                    break;
                                }
                                let _e2300 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2303 = select(0u, 1u, (_e2285.member_3 != 4294967295u));
                    if (_e2303 > 0u) {
                        let _e2305 = (3u < _e119);
                        if _e2305 {
                            if (2u < _e119) {
                            } else {
                                break;
                            }
                            let _e2309 = atomicAdd((&global_10.member[2u]), _e2303);
                            if ((_e2309 + _e2303) < _e2309) {
                                if _e2305 {
                                } else {
                                    break;
                                }
                                let _e2314 = atomicAdd((&global_10.member[3u]), 1u);
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
