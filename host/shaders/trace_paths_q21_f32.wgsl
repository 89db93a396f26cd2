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

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_44 {
    member: type_26,
    member_1: f32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_57 {
    member: array<array<u32, 7>>,
}

struct type_62 {
    member: type_38,
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
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_48;
@group(0) @binding(2) 
var<uniform> global_3: type_48;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_51;
@group(0) @binding(7) 
var<storage> global_7: type_33;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_28;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
@group(0) @binding(3) 
var<storage> global_10: type_57;

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
    var phi_600_: type_40;
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
    var phi_1395_: type_44;
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
    var phi_1521_: type_44;
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
    var phi_2525_: type_26;
    var phi_2527_: type_26;
    var phi_2528_: bool;
    var phi_2532_: type_26;
    var phi_2533_: type_26;
    var phi_2534_: type_26;
    var phi_2535_: bool;
    var phi_2539_: type_26;
    var phi_2540_: bool;
    var phi_2541_: type_26;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: type_26;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2554_: type_26;
    var phi_2555_: bool;
    var phi_2559_: type_26;
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
    var phi_2920_: type_44;
    var phi_2921_: type_44;
    var phi_2922_: type_44;
    var phi_1522_: type_44;
    var phi_4603_: bool;
    var phi_4799_: bool;
    var phi_4158_: type_44;
    var phi_4159_: bool;
    var phi_4160_: u32;
    var phi_4161_: type_62;
    var phi_4798_: bool;
    var phi_4162_: type_44;
    var phi_4163_: bool;
    var phi_4164_: u32;
    var phi_4165_: u32;
    var phi_4166_: type_62;
    var phi_4797_: bool;
    var phi_4167_: type_44;
    var phi_4168_: bool;
    var phi_4169_: u32;
    var phi_4170_: u32;
    var phi_4171_: type_62;
    var phi_4796_: bool;
    var phi_1396_: type_44;
    var phi_1399_: bool;
    var phi_1401_: u32;
    var phi_1403_: u32;
    var phi_1405_: type_62;
    var phi_4172_: bool;
    var phi_4795_: bool;
    var local_10: type_44;
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
    var phi_4248_: type_26;
    var local_11: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_10.member));
            let _e105 = arrayLength((&global_4.member));
            let _e117 = arrayLength((&global_9.member));
            let _e121 = global_3.member[0u][0u];
            let _e125 = global_3.member[0u][1u];
            let _e129 = global_3.member[0u][2u];
            let _e133 = global_3.member[0u][3u];
            let _e137 = global_3.member[1u][0u];
            let _e141 = global_3.member[1u][1u];
            let _e145 = global_3.member[1u][2u];
            let _e149 = (_e101.x + (_e101.y * 2097152u));
            let _e161 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e133) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            local = array<i32, 3>(bitcast<i32>(_e137), bitcast<i32>(_e141), bitcast<i32>(_e145));
            let _e164 = (_e149 < arrayLength((&global_7.member)));
            if _e164 {
                if _e164 {
                } else {
                    break;
                }
                let _e168 = global_7.member[_e149].member_2;
                phi_416_ = _e168;
            } else {
                phi_416_ = 4294967295u;
            }
            let _e170 = phi_416_;
            let _e173 = global_1.member[0u];
            let _e177 = global_2.member[0u][0u];
            let _e181 = global_2.member[0u][1u];
            let _e185 = global_2.member[0u][2u];
            let _e189 = global_2.member[0u][3u];
            let _e193 = global_2.member[1u][0u];
            let _e197 = global_2.member[1u][1u];
            let _e201 = global_2.member[1u][2u];
            let _e205 = global_2.member[1u][3u];
            let _e206 = bitcast<f32>(_e177);
            let _e207 = bitcast<f32>(_e181);
            let _e208 = bitcast<f32>(_e185);
            let _e210 = bitcast<f32>(_e193);
            let _e211 = array<u32, 3>(_e197, _e201, _e205);
            let _e213 = bitcast<i32>(_e173);
            if (_e213 < -126i) {
                phi_460_ = -126i;
            } else {
                phi_460_ = select(_e213, 127i, (_e213 > 127i));
            }
            let _e218 = phi_460_;
            let _e223 = bitcast<f32>((bitcast<u32>((_e218 + 127i)) << bitcast<u32>(23i)));
            let _e229 = bitcast<f32>((bitcast<u32>(((_e213 - _e218) + 127i)) << bitcast<u32>(23i)));
            if (_e189 == 0u) {
                phi_600_ = type_40(array<f32, 3>(_e206, _e207, _e208), _e189, _e210, _e211);
            } else {
                let _e231 = bitcast<u32>(_e206);
                let _e233 = ((_e231 & 2139095040u) != 0u);
                let _e248 = bitcast<u32>(_e207);
                let _e250 = ((_e248 & 2139095040u) != 0u);
                let _e265 = bitcast<u32>(_e208);
                let _e267 = ((_e265 & 2139095040u) != 0u);
                let _e283 = bitcast<u32>(_e210);
                let _e285 = ((_e283 & 2139095040u) != 0u);
                phi_600_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e231 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e231 & 2147483648u))), _e206, _e233) * _e223) * select(0.00000011920929f, 1f, _e233)) * _e229), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e207, _e250) * _e223) * select(0.00000011920929f, 1f, _e250)) * _e229), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e265 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e265 & 2147483648u))), _e208, _e267) * _e223) * select(0.00000011920929f, 1f, _e267)) * _e229)), _e189, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e283 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e283 & 2147483648u))), _e210, _e285) * _e223) * select(0.00000011920929f, 1f, _e285)) * _e229), _e211);
            }
            let _e302 = phi_600_;
            if _e164 {
                let _e303 = (_e149 < arrayLength((&global_8.member)));
                if _e303 {
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e313 = global_7.member[_e149].member.member_2[0u];
                    let _e315 = (bitcast<u32>(_e313) & 2147483647u);
                    let _e321 = global_7.member[_e149].member.member_2[1u];
                    let _e323 = (bitcast<u32>(_e321) & 2147483647u);
                    let _e329 = global_7.member[_e149].member.member_2[2u];
                    let _e331 = (bitcast<u32>(_e329) & 2147483647u);
                    let _e337 = global_7.member[_e149].member.member[0u];
                    let _e339 = (bitcast<u32>(_e337) & 2147483647u);
                    let _e345 = global_7.member[_e149].member.member[1u];
                    let _e347 = (bitcast<u32>(_e345) & 2147483647u);
                    let _e353 = global_7.member[_e149].member.member[2u];
                    let _e355 = (bitcast<u32>(_e353) & 2147483647u);
                    let _e357 = select(_e323, _e315, (_e323 < _e315));
                    let _e359 = select(_e331, _e357, (_e331 < _e357));
                    let _e361 = select(_e339, _e359, (_e339 < _e359));
                    let _e363 = select(_e347, _e361, (_e347 < _e361));
                    let _e365 = select(_e355, _e363, (_e355 < _e363));
                    let _e370 = global_7.member[_e149].member.member_1;
                    let _e371 = bitcast<u32>(_e370);
                    let _e372 = (_e371 & 2147483647u);
                    let _e380 = global_7.member[_e149].member.member_3;
                    let _e381 = bitcast<u32>(_e380);
                    let _e382 = (_e381 & 2147483647u);
                    let _e386 = (((select(_e372, _e365, (_e372 < _e365)) < 2139095040u) && (_e382 <= 2139095040u)) && (_e359 > 0u));
                    if _e386 {
                        let _e389 = (bitcast<u32>(bitcast<f32>(_e359)) & 2147483647u);
                        if (_e389 >= 8388608u) {
                            phi_706_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_706_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                        }
                        let _e403 = phi_706_;
                        phi_707_ = _e403;
                    } else {
                        phi_707_ = 0i;
                    }
                    let _e405 = phi_707_;
                    let _e406 = (_e315 == _e359);
                    if _e406 {
                        phi_717_ = true;
                    } else {
                        phi_717_ = (_e323 == _e359);
                    }
                    let _e409 = phi_717_;
                    let _e410 = select(1u, 0u, _e406);
                    if _e409 {
                        let _e411 = (_e410 + 1u);
                        phi_727_ = _e411;
                        phi_728_ = _e411;
                        phi_730_ = select(true, false, (_e411 == 2u));
                    } else {
                        phi_727_ = u32();
                        phi_728_ = 0u;
                        phi_730_ = true;
                    }
                    let _e415 = phi_727_;
                    let _e417 = phi_728_;
                    let _e419 = phi_730_;
                    if _e419 {
                        phi_735_ = (_e417 + 1u);
                    } else {
                        phi_735_ = 0u;
                    }
                    let _e423 = phi_735_;
                    let _e424 = select(_e415, _e417, _e419);
                    let _e425 = select(_e410, select(2u, _e410, _e409), _e419);
                    let _e426 = -(_e405);
                    if (_e426 < -126i) {
                        phi_768_ = -126i;
                    } else {
                        phi_768_ = select(_e426, 127i, (_e426 > 127i));
                    }
                    let _e431 = phi_768_;
                    let _e436 = bitcast<f32>((bitcast<u32>((_e431 + 127i)) << bitcast<u32>(23i)));
                    let _e442 = bitcast<f32>((bitcast<u32>(((_e426 - _e431) + 127i)) << bitcast<u32>(23i)));
                    let _e447 = global_7.member[_e149].member.member;
                    let _e448 = (_e424 == 0u);
                    if _e448 {
                        phi_786_ = _e447[0];
                    } else {
                        phi_786_ = _e447[1];
                    }
                    let _e452 = phi_786_;
                    let _e453 = (_e424 == 2u);
                    if _e453 {
                        phi_792_ = _e447[2];
                    } else {
                        phi_792_ = _e452;
                    }
                    let _e456 = phi_792_;
                    let _e457 = bitcast<u32>(_e456);
                    let _e459 = ((_e457 & 2139095040u) != 0u);
                    let _e471 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e457 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e457 & 2147483648u))), _e456, _e459) * select(0.00000011920929f, 1f, _e459));
                    let _e472 = global_7.member[_e149].member.member_2;
                    if _e448 {
                        phi_832_ = _e472[0];
                    } else {
                        phi_832_ = _e472[1];
                    }
                    let _e476 = phi_832_;
                    if _e453 {
                        phi_838_ = _e472[2];
                    } else {
                        phi_838_ = _e476;
                    }
                    let _e479 = phi_838_;
                    let _e480 = bitcast<u32>(_e479);
                    let _e482 = ((_e480 & 2139095040u) != 0u);
                    let _e496 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e480 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e480 & 2147483648u))), _e479, _e482) * _e436) * select(0.00000011920929f, 1f, _e482)) * _e442);
                    let _e500 = (bitcast<f32>((bitcast<u32>(_e496) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e500 {
                        let _e504 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                        phi_890_ = select(0.00000000000011368684f, _e504, (_e504 > 0.00000000000011368684f));
                    } else {
                        phi_890_ = 0f;
                    }
                    let _e508 = phi_890_;
                    let _e509 = (_e471 + _e508);
                    let _e510 = (_e471 - _e508);
                    let _e511 = select(_e496, 0f, _e500);
                    if _e500 {
                        phi_902_ = 38685626000000000000000000f;
                    } else {
                        phi_902_ = (1f / _e496);
                    }
                    let _e514 = phi_902_;
                    let _e515 = (_e423 == 0u);
                    if _e515 {
                        phi_911_ = _e447[0];
                    } else {
                        phi_911_ = _e447[1];
                    }
                    let _e519 = phi_911_;
                    let _e520 = (_e423 == 2u);
                    if _e520 {
                        phi_917_ = _e447[2];
                    } else {
                        phi_917_ = _e519;
                    }
                    let _e523 = phi_917_;
                    let _e524 = bitcast<u32>(_e523);
                    let _e526 = ((_e524 & 2139095040u) != 0u);
                    let _e538 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e524 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e524 & 2147483648u))), _e523, _e526) * select(0.00000011920929f, 1f, _e526));
                    if _e515 {
                        phi_957_ = _e472[0];
                    } else {
                        phi_957_ = _e472[1];
                    }
                    let _e542 = phi_957_;
                    if _e520 {
                        phi_963_ = _e472[2];
                    } else {
                        phi_963_ = _e542;
                    }
                    let _e545 = phi_963_;
                    let _e546 = bitcast<u32>(_e545);
                    let _e548 = ((_e546 & 2139095040u) != 0u);
                    let _e562 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e546 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e546 & 2147483648u))), _e545, _e548) * _e436) * select(0.00000011920929f, 1f, _e548)) * _e442);
                    let _e566 = (bitcast<f32>((bitcast<u32>(_e562) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e566 {
                        let _e570 = (bitcast<f32>((bitcast<u32>(_e538) & 2147483647u)) * 0.00000011920929f);
                        phi_1015_ = select(0.00000000000011368684f, _e570, (_e570 > 0.00000000000011368684f));
                    } else {
                        phi_1015_ = 0f;
                    }
                    let _e574 = phi_1015_;
                    let _e575 = (_e538 + _e574);
                    let _e576 = (_e538 - _e574);
                    let _e577 = select(_e562, 0f, _e566);
                    if _e566 {
                        phi_1027_ = 38685626000000000000000000f;
                    } else {
                        phi_1027_ = (1f / _e562);
                    }
                    let _e580 = phi_1027_;
                    let _e581 = (_e425 == 0u);
                    if _e581 {
                        phi_1036_ = _e447[0];
                    } else {
                        phi_1036_ = _e447[1];
                    }
                    let _e585 = phi_1036_;
                    let _e586 = (_e425 == 2u);
                    if _e586 {
                        phi_1042_ = _e447[2];
                    } else {
                        phi_1042_ = _e585;
                    }
                    let _e589 = phi_1042_;
                    let _e590 = bitcast<u32>(_e589);
                    let _e592 = ((_e590 & 2139095040u) != 0u);
                    let _e604 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e590 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e590 & 2147483648u))), _e589, _e592) * select(0.00000011920929f, 1f, _e592));
                    if _e581 {
                        phi_1082_ = _e472[0];
                    } else {
                        phi_1082_ = _e472[1];
                    }
                    let _e608 = phi_1082_;
                    if _e586 {
                        phi_1088_ = _e472[2];
                    } else {
                        phi_1088_ = _e608;
                    }
                    let _e611 = phi_1088_;
                    let _e612 = bitcast<u32>(_e611);
                    let _e614 = ((_e612 & 2139095040u) != 0u);
                    let _e628 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e612 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e612 & 2147483648u))), _e611, _e614) * _e436) * select(0.00000011920929f, 1f, _e614)) * _e442);
                    let _e632 = (bitcast<f32>((bitcast<u32>(_e628) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e632 {
                        let _e636 = (bitcast<f32>((bitcast<u32>(_e604) & 2147483647u)) * 0.00000011920929f);
                        phi_1140_ = select(0.00000000000011368684f, _e636, (_e636 > 0.00000000000011368684f));
                    } else {
                        phi_1140_ = 0f;
                    }
                    let _e640 = phi_1140_;
                    let _e641 = (_e604 + _e640);
                    let _e642 = (_e604 - _e640);
                    let _e643 = select(_e628, 0f, _e632);
                    if _e632 {
                        phi_1152_ = 38685626000000000000000000f;
                    } else {
                        phi_1152_ = (1f / _e628);
                    }
                    let _e646 = phi_1152_;
                    let _e649 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                    let _e652 = bitcast<f32>((bitcast<u32>(_e538) & 2147483647u));
                    let _e654 = select(_e652, _e649, (_e649 > _e652));
                    let _e657 = bitcast<f32>((bitcast<u32>(_e604) & 2147483647u));
                    if (_e386 && (select(_e657, _e654, (_e654 > _e657)) <= 1099511600000f)) {
                        let _e669 = ((_e372 & 8388607u) | (select(0u, 1u, ((_e372 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e672 = bitcast<i32>((_e372 >> bitcast<u32>(23i)));
                        let _e676 = (_e669 == 0u);
                        let _e679 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e669)), 32u, _e676)) - 8i);
                        if (_e672 == 255i) {
                            phi_1207_ = 255i;
                        } else {
                            phi_1207_ = (((_e672 + select(0i, 1i, (_e672 == 0i))) - _e679) + _e405);
                        }
                        let _e687 = phi_1207_;
                        let _e697 = (_e687 <= 0i);
                        if _e697 {
                            phi_1230_ = u32();
                        } else {
                            if _e676 {
                                phi_1229_ = u32();
                            } else {
                                phi_1229_ = select(((bitcast<u32>(_e687) << bitcast<u32>(23i)) | ((_e669 << bitcast<u32>(((_e679 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e687 >= 255i));
                            }
                            let _e701 = phi_1229_;
                            phi_1230_ = _e701;
                        }
                        let _e703 = phi_1230_;
                        let _e715 = ((_e382 & 8388607u) | (select(0u, 1u, ((_e382 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e718 = bitcast<i32>((_e382 >> bitcast<u32>(23i)));
                        let _e722 = (_e715 == 0u);
                        let _e725 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e715)), 32u, _e722)) - 8i);
                        if (_e718 == 255i) {
                            phi_1267_ = 255i;
                        } else {
                            phi_1267_ = (((_e718 + select(0i, 1i, (_e718 == 0i))) - _e725) + _e405);
                        }
                        let _e733 = phi_1267_;
                        let _e743 = (_e733 <= 0i);
                        if _e743 {
                            phi_1290_ = u32();
                        } else {
                            if _e722 {
                                phi_1289_ = u32();
                            } else {
                                phi_1289_ = select(((bitcast<u32>(_e733) << bitcast<u32>(23i)) | ((_e715 << bitcast<u32>(((_e725 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e733 >= 255i));
                            }
                            let _e747 = phi_1289_;
                            phi_1290_ = _e747;
                        }
                        let _e749 = phi_1290_;
                        phi_1298_ = bitcast<f32>(((_e381 & 2147483648u) | select(_e749, 0u, select(_e722, true, _e743))));
                        phi_1299_ = bitcast<f32>(((_e371 & 2147483648u) | select(_e703, 0u, select(_e676, true, _e697))));
                    } else {
                        phi_1298_ = 0f;
                        phi_1299_ = 1f;
                    }
                    let _e755 = phi_1298_;
                    let _e757 = phi_1299_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e761 = (_e424 % 3u);
                    let _e762 = (_e761 < 3u);
                    if _e762 {
                    } else {
                        break;
                    }
                    let _e764 = local_1[_e761];
                    let _e767 = (_e423 % 3u);
                    let _e768 = (_e767 < 3u);
                    if _e768 {
                    } else {
                        break;
                    }
                    let _e770 = local_1[_e767];
                    let _e773 = (_e425 % 3u);
                    let _e774 = (_e773 < 3u);
                    if _e774 {
                    } else {
                        break;
                    }
                    let _e776 = local_1[_e773];
                    if _e762 {
                    } else {
                        break;
                    }
                    let _e781 = local[_e761];
                    if _e768 {
                    } else {
                        break;
                    }
                    let _e785 = local[_e767];
                    if _e774 {
                    } else {
                        break;
                    }
                    let _e789 = local[_e773];
                    phi_4609_ = false;
                    phi_1395_ = type_44(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e755);
                    phi_1398_ = (_e757 <= _e755);
                    phi_1400_ = ((3u * _e103) + 1u);
                    phi_1402_ = 0u;
                    phi_1404_ = type_62(type_38(vec4<f32>((f32(_e764) * _e161), (f32(_e770) * _e161), (f32(_e776) * _e161), 0f), vec4<f32>((f32(_e781) * _e161), (f32(_e785) * _e161), (f32(_e789) * _e161), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    loop {
                        let _e799 = phi_4609_;
                        let _e801 = phi_1395_;
                        let _e803 = phi_1398_;
                        let _e805 = phi_1400_;
                        let _e807 = phi_1402_;
                        let _e809 = phi_1404_;
                        local_10 = _e801;
                        if _e803 {
                            phi_1415_ = true;
                        } else {
                            phi_1415_ = (_e807 > 0u);
                        }
                        let _e812 = phi_1415_;
                        if _e812 {
                            let _e813 = (_e805 > 0u);
                            if _e813 {
                                if _e803 {
                                    phi_1501_ = _e803;
                                    phi_1502_ = _e807;
                                    phi_1503_ = _e809;
                                } else {
                                    let _e814 = (_e807 - 1u);
                                    let _e815 = (_e814 % 128u);
                                    let _e816 = (_e815 < 128u);
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e818 = local_7[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e820 = local_6[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e822 = local_5[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e824 = local_4[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e826 = local_3[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e828 = local_2[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e833 = local_8[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4795_ = true;
                                        break;
                                    }
                                    let _e836 = local_9[_e815];
                                    phi_1501_ = (_e836 <= _e801.member_1);
                                    phi_1502_ = _e814;
                                    phi_1503_ = type_62(type_38(vec4<f32>(_e818, _e820, _e822, 0f), vec4<f32>(_e824, _e826, _e828, 0f)), _e833);
                                }
                                let _e840 = phi_1501_;
                                let _e842 = phi_1502_;
                                let _e844 = phi_1503_;
                                if _e840 {
                                    if ((_e844.member_1 & 2147483648u) != 0u) {
                                        phi_1521_ = _e801;
                                        phi_1524_ = type_8(0u, ((_e844.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1312 = phi_1521_;
                                            let _e1314 = phi_1524_;
                                            local_11 = _e1312;
                                            if (_e1314.member < _e1314.member_1) {
                                                phi_1525_ = type_8((_e1314.member + 1u), _e1314.member_1);
                                                phi_1547_ = type_8(1u, _e1314.member);
                                            } else {
                                                phi_1525_ = _e1314;
                                                phi_1547_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1327 = phi_1525_;
                                            let _e1329 = phi_1547_;
                                            let _e1333 = (bitcast<i32>(_e1329.member) != 0i);
                                            if _e1333 {
                                                let _e1334 = ((_e844.member_1 & 268435455u) + _e1329.member_1);
                                                let _e1335 = (_e1334 < _e105);
                                                if _e1335 {
                                                    if _e1335 {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1339 = global_4.member[_e1334].member_1;
                                                    phi_1568_ = _e1339;
                                                } else {
                                                    phi_1568_ = 4294967295u;
                                                }
                                                let _e1341 = phi_1568_;
                                                if (_e1334 >= _e105) {
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1335 {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1348 = global_4.member[_e1334].member[_e761];
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1354 = global_4.member[_e1334].member[_e767];
                                                    if (_e773 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1360 = global_4.member[_e1334].member[_e773];
                                                    let _e1362 = (3u + _e761);
                                                    if (_e1362 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1368 = global_4.member[_e1334].member[_e1362];
                                                    let _e1369 = (3u + _e767);
                                                    if (_e1369 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1375 = global_4.member[_e1334].member[_e1369];
                                                    let _e1376 = (3u + _e773);
                                                    if (_e1376 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1382 = global_4.member[_e1334].member[_e1376];
                                                    let _e1384 = (6u + _e761);
                                                    if (_e1384 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1390 = global_4.member[_e1334].member[_e1384];
                                                    let _e1391 = (6u + _e767);
                                                    if (_e1391 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1397 = global_4.member[_e1334].member[_e1391];
                                                    let _e1398 = (6u + _e773);
                                                    if (_e1398 < 9u) {
                                                    } else {
                                                        phi_4603_ = true;
                                                        break;
                                                    }
                                                    let _e1404 = global_4.member[_e1334].member[_e1398];
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1348, _e1354, _e1360), array<f32, 3>(_e1368, _e1375, _e1382), array<f32, 3>(_e1390, _e1397, _e1404));
                                                }
                                                let _e1408 = phi_1660_;
                                                let _e1416 = (_e1408[0][2] - _e604);
                                                let _e1419 = (((_e1408[0][0] - _e471) * _e643) - (_e1416 * _e511));
                                                let _e1422 = (((_e1408[0][1] - _e538) * _e643) - (_e1416 * _e577));
                                                let _e1429 = (_e1408[1][2] - _e604);
                                                let _e1432 = (((_e1408[1][0] - _e471) * _e643) - (_e1429 * _e511));
                                                let _e1435 = (((_e1408[1][1] - _e538) * _e643) - (_e1429 * _e577));
                                                let _e1442 = (_e1408[2][2] - _e604);
                                                let _e1445 = (((_e1408[2][0] - _e471) * _e643) - (_e1442 * _e511));
                                                let _e1448 = (((_e1408[2][1] - _e538) * _e643) - (_e1442 * _e577));
                                                let _e1449 = (_e1445 * _e1435);
                                                let _e1450 = (_e1448 * _e1432);
                                                let _e1451 = (_e1419 * _e1448);
                                                let _e1452 = (_e1422 * _e1445);
                                                let _e1453 = (_e1432 * _e1422);
                                                let _e1454 = (_e1435 * _e1419);
                                                let _e1459 = (((_e1449 >= _e1450) && (_e1451 >= _e1452)) && (_e1453 >= _e1454));
                                                if (_e1459 || (((_e1449 <= _e1450) && (_e1451 <= _e1452)) && (_e1453 <= _e1454))) {
                                                    let _e1466 = select(-1f, 1f, _e1459);
                                                    let _e1468 = ((_e1449 - _e1450) * _e1466);
                                                    let _e1470 = select(0f, _e1468, (_e1468 > 0f));
                                                    let _e1472 = ((_e1451 - _e1452) * _e1466);
                                                    let _e1474 = select(0f, _e1472, (_e1472 > 0f));
                                                    let _e1476 = ((_e1453 - _e1454) * _e1466);
                                                    let _e1478 = select(0f, _e1476, (_e1476 > 0f));
                                                    let _e1480 = ((_e1470 + _e1474) + _e1478);
                                                    if (_e1480 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2544_ = type_26();
                                                        phi_2545_ = true;
                                                        phi_2546_ = false;
                                                    } else {
                                                        let _e1483 = select(_e1432, _e1419, (_e1419 < _e1432));
                                                        if (select(_e1445, _e1483, (_e1483 < _e1445)) > 0f) {
                                                            phi_1812_ = true;
                                                        } else {
                                                            let _e1488 = select(_e1432, _e1419, (_e1419 > _e1432));
                                                            phi_1812_ = (select(_e1445, _e1488, (_e1488 > _e1445)) < 0f);
                                                        }
                                                        let _e1493 = phi_1812_;
                                                        if _e1493 {
                                                            phi_2541_ = type_26();
                                                            phi_2542_ = true;
                                                            phi_2543_ = false;
                                                        } else {
                                                            let _e1495 = select(_e1435, _e1422, (_e1422 < _e1435));
                                                            if (select(_e1448, _e1495, (_e1495 < _e1448)) > 0f) {
                                                                phi_1841_ = true;
                                                            } else {
                                                                let _e1500 = select(_e1435, _e1422, (_e1422 > _e1435));
                                                                phi_1841_ = (select(_e1448, _e1500, (_e1500 > _e1448)) < 0f);
                                                            }
                                                            let _e1505 = phi_1841_;
                                                            if _e1505 {
                                                                phi_2539_ = type_26();
                                                                phi_2540_ = false;
                                                            } else {
                                                                let _e1507 = select(_e1408[1][0], _e1408[0][0], (_e1408[0][0] < _e1408[1][0]));
                                                                let _e1511 = select(_e1408[1][0], _e1408[0][0], (_e1408[0][0] > _e1408[1][0]));
                                                                let _e1515 = select(_e1408[1][1], _e1408[0][1], (_e1408[0][1] < _e1408[1][1]));
                                                                let _e1519 = select(_e1408[1][1], _e1408[0][1], (_e1408[0][1] > _e1408[1][1]));
                                                                let _e1523 = select(_e1408[1][2], _e1408[0][2], (_e1408[0][2] < _e1408[1][2]));
                                                                let _e1527 = select(_e1408[1][2], _e1408[0][2], (_e1408[0][2] > _e1408[1][2]));
                                                                let _e1532 = ((select(_e1408[2][0], _e1507, (_e1507 < _e1408[2][0])) - _e509) * _e514);
                                                                let _e1533 = ((select(_e1408[2][0], _e1511, (_e1511 > _e1408[2][0])) - _e510) * _e514);
                                                                let _e1536 = ((select(_e1408[2][1], _e1515, (_e1515 < _e1408[2][1])) - _e575) * _e580);
                                                                let _e1537 = ((select(_e1408[2][1], _e1519, (_e1519 > _e1408[2][1])) - _e576) * _e580);
                                                                let _e1540 = ((select(_e1408[2][2], _e1523, (_e1523 < _e1408[2][2])) - _e641) * _e646);
                                                                let _e1541 = ((select(_e1408[2][2], _e1527, (_e1527 > _e1408[2][2])) - _e642) * _e646);
                                                                let _e1543 = select(_e1541, _e1540, (_e1540 < _e1541));
                                                                let _e1545 = select(_e1541, _e1540, (_e1540 > _e1541));
                                                                let _e1547 = select(_e1533, _e1532, (_e1532 < _e1533));
                                                                let _e1549 = select(_e1537, _e1536, (_e1536 < _e1537));
                                                                let _e1551 = select(_e1549, _e1547, (_e1547 > _e1549));
                                                                let _e1553 = select(_e1543, _e1551, (_e1551 > _e1543));
                                                                let _e1555 = select(_e1533, _e1532, (_e1532 > _e1533));
                                                                let _e1557 = select(_e1537, _e1536, (_e1536 > _e1537));
                                                                let _e1559 = select(_e1557, _e1555, (_e1555 < _e1557));
                                                                let _e1561 = select(_e1545, _e1559, (_e1559 < _e1545));
                                                                let _e1562 = -(_e1543);
                                                                let _e1568 = select(_e757, _e1553, (_e1553 > _e757));
                                                                if (_e1568 > (_e1561 + (select(_e1562, _e1545, (_e1545 > _e1562)) * 0.0000019073523f))) {
                                                                    phi_2534_ = type_26();
                                                                    phi_2535_ = true;
                                                                } else {
                                                                    let _e1570 = (_e1568 > _e1312.member_1);
                                                                    if _e1570 {
                                                                        phi_2533_ = type_26();
                                                                    } else {
                                                                        let _e1571 = vec3<f32>(_e1408[0][0], _e1408[0][1], _e1408[0][2]);
                                                                        let _e1572 = vec3<f32>(_e1408[1][0], _e1408[1][1], _e1408[1][2]);
                                                                        let _e1573 = vec3<f32>(_e1408[2][0], _e1408[2][1], _e1408[2][2]);
                                                                        let _e1574 = (_e1408[1][0] - _e1408[0][0]);
                                                                        let _e1575 = (_e1408[1][1] - _e1408[0][1]);
                                                                        let _e1576 = (_e1408[1][2] - _e1408[0][2]);
                                                                        let _e1577 = vec3<f32>(_e1574, _e1575, _e1576);
                                                                        let _e1578 = (_e1408[2][0] - _e1408[1][0]);
                                                                        let _e1579 = (_e1408[2][1] - _e1408[1][1]);
                                                                        let _e1580 = (_e1408[2][2] - _e1408[1][2]);
                                                                        let _e1581 = vec3<f32>(_e1578, _e1579, _e1580);
                                                                        let _e1582 = (_e1408[0][0] - _e1408[2][0]);
                                                                        let _e1583 = (_e1408[0][1] - _e1408[2][1]);
                                                                        let _e1584 = (_e1408[0][2] - _e1408[2][2]);
                                                                        let _e1585 = vec3<f32>(_e1582, _e1583, _e1584);
                                                                        let _e1588 = bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u));
                                                                        let _e1591 = bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u));
                                                                        let _e1593 = select(_e1591, _e1588, (_e1588 > _e1591));
                                                                        let _e1596 = bitcast<f32>((bitcast<u32>(_e1576) & 2147483647u));
                                                                        let _e1598 = select(_e1596, _e1593, (_e1593 > _e1596));
                                                                        let _e1601 = bitcast<f32>((bitcast<u32>(_e1578) & 2147483647u));
                                                                        let _e1604 = bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u));
                                                                        let _e1606 = select(_e1604, _e1601, (_e1601 > _e1604));
                                                                        let _e1609 = bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u));
                                                                        let _e1611 = select(_e1609, _e1606, (_e1606 > _e1609));
                                                                        let _e1614 = bitcast<f32>((bitcast<u32>(_e1582) & 2147483647u));
                                                                        let _e1617 = bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u));
                                                                        let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u));
                                                                        let _e1624 = select(_e1622, _e1619, (_e1619 > _e1622));
                                                                        let _e1626 = select(_e1611, _e1598, (_e1598 > _e1611));
                                                                        let _e1628 = select(_e1624, _e1626, (_e1626 > _e1624));
                                                                        if (_e1598 == _e1628) {
                                                                            phi_2260_ = _e1435;
                                                                            phi_2261_ = _e1432;
                                                                            phi_2262_ = _e1422;
                                                                            phi_2263_ = _e1419;
                                                                            phi_2264_ = _e1571;
                                                                            phi_2265_ = _e1585;
                                                                            phi_2266_ = _e1581;
                                                                            phi_2267_ = _e1577;
                                                                        } else {
                                                                            let _e1630 = (_e1611 == _e1628);
                                                                            let _e1635 = vec3(_e1630);
                                                                            phi_2260_ = select(_e1422, _e1448, _e1630);
                                                                            phi_2261_ = select(_e1419, _e1445, _e1630);
                                                                            phi_2262_ = select(_e1448, _e1435, _e1630);
                                                                            phi_2263_ = select(_e1445, _e1432, _e1630);
                                                                            phi_2264_ = select(_e1573, _e1572, _e1635);
                                                                            phi_2265_ = select(_e1581, _e1577, _e1635);
                                                                            phi_2266_ = select(_e1577, _e1585, _e1635);
                                                                            phi_2267_ = select(_e1585, _e1581, _e1635);
                                                                        }
                                                                        let _e1641 = phi_2260_;
                                                                        let _e1643 = phi_2261_;
                                                                        let _e1645 = phi_2262_;
                                                                        let _e1647 = phi_2263_;
                                                                        let _e1649 = phi_2264_;
                                                                        let _e1651 = phi_2265_;
                                                                        let _e1653 = phi_2266_;
                                                                        let _e1655 = phi_2267_;
                                                                        let _e1662 = ((_e1653.y * _e1651.z) - (_e1651.y * _e1653.z));
                                                                        let _e1667 = ((_e1653.z * _e1651.x) - (_e1651.z * _e1653.x));
                                                                        let _e1670 = ((_e1653.x * _e1651.y) - (_e1651.x * _e1653.y));
                                                                        if (_e1470 >= _e1474) {
                                                                            phi_2304_ = select(true, false, (_e1470 >= _e1478));
                                                                        } else {
                                                                            phi_2304_ = true;
                                                                        }
                                                                        let _e1675 = phi_2304_;
                                                                        if _e1675 {
                                                                            phi_2313_ = select(_e1573, _e1572, vec3((_e1474 >= _e1478)));
                                                                        } else {
                                                                            phi_2313_ = _e1571;
                                                                        }
                                                                        let _e1680 = phi_2313_;
                                                                        let _e1691 = (((_e1662 * (_e1680.x - _e471)) + (_e1667 * (_e1680.y - _e538))) + (_e1670 * (_e1680.z - _e604)));
                                                                        let _e1696 = (((_e1662 * _e511) + (_e1667 * _e577)) + (_e1670 * _e643));
                                                                        let _e1697 = (_e1643 - _e1647);
                                                                        let _e1698 = (_e1641 - _e1645);
                                                                        let _e1706 = (-(((_e1647 * _e1697) + (_e1645 * _e1698))) / ((_e1697 * _e1697) + (_e1698 * _e1698)));
                                                                        let _e1708 = select(1f, _e1706, (_e1706 < 1f));
                                                                        let _e1710 = select(0f, _e1708, (_e1708 > 0f));
                                                                        let _e1723 = ((_e1649.x + (_e1655.x * _e1710)) - _e471);
                                                                        let _e1724 = ((_e1649.y + (_e1655.y * _e1710)) - _e538);
                                                                        let _e1725 = ((_e1649.z + (_e1655.z * _e1710)) - _e604);
                                                                        let _e1726 = (_e1725 / _e643);
                                                                        let _e1738 = bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u));
                                                                        let _e1741 = bitcast<f32>((bitcast<u32>(_e1724) & 2147483647u));
                                                                        let _e1743 = select(_e1741, _e1738, (_e1738 > _e1741));
                                                                        let _e1746 = bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u));
                                                                        let _e1748 = select(_e1746, _e1743, (_e1743 > _e1746));
                                                                        let _e1754 = bitcast<f32>((bitcast<u32>(_e1662) & 2147483647u));
                                                                        let _e1757 = bitcast<f32>((bitcast<u32>(_e1667) & 2147483647u));
                                                                        let _e1759 = select(_e1757, _e1754, (_e1754 > _e1757));
                                                                        let _e1762 = bitcast<f32>((bitcast<u32>(_e1670) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1662 * _e1723) + (_e1667 * _e1724)) + (_e1670 * _e1725)) - _e1691)) & 2147483647u)) <= ((0.0000009536743f * select(_e1628, _e1748, (_e1748 > _e1628))) * select(_e1762, _e1759, (_e1759 > _e1762)))) {
                                                                            let _e1772 = bitcast<f32>((bitcast<u32>(_e1653.x) & 2147483647u));
                                                                            let _e1775 = bitcast<f32>((bitcast<u32>(_e1653.y) & 2147483647u));
                                                                            let _e1777 = select(_e1775, _e1772, (_e1772 > _e1775));
                                                                            let _e1780 = bitcast<f32>((bitcast<u32>(_e1653.z) & 2147483647u));
                                                                            let _e1786 = bitcast<f32>((bitcast<u32>(_e1651.x) & 2147483647u));
                                                                            let _e1789 = bitcast<f32>((bitcast<u32>(_e1651.y) & 2147483647u));
                                                                            let _e1791 = select(_e1789, _e1786, (_e1786 > _e1789));
                                                                            let _e1794 = bitcast<f32>((bitcast<u32>(_e1651.z) & 2147483647u));
                                                                            let _e1798 = (bitcast<f32>((bitcast<u32>(_e1696) & 2147483647u)) > ((0.0000038146973f * select(_e1780, _e1777, (_e1777 > _e1780))) * select(_e1794, _e1791, (_e1791 > _e1794))));
                                                                            if _e1798 {
                                                                                phi_2478_ = (_e1691 / _e1696);
                                                                            } else {
                                                                                phi_2478_ = f32();
                                                                            }
                                                                            let _e1801 = phi_2478_;
                                                                            phi_2480_ = _e1801;
                                                                            phi_2481_ = select(true, false, _e1798);
                                                                        } else {
                                                                            phi_2480_ = f32();
                                                                            phi_2481_ = true;
                                                                        }
                                                                        let _e1804 = phi_2480_;
                                                                        let _e1806 = phi_2481_;
                                                                        if _e1806 {
                                                                            let _e1814 = (((_e1662 * (_e1723 - (_e511 * _e1726))) + (_e1667 * (_e1724 - (_e577 * _e1726)))) / _e1696);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u)) <= _e1628) {
                                                                                phi_2501_ = (_e1726 + _e1814);
                                                                            } else {
                                                                                phi_2501_ = _e1726;
                                                                            }
                                                                            let _e1821 = phi_2501_;
                                                                            phi_2502_ = _e1821;
                                                                        } else {
                                                                            phi_2502_ = _e1804;
                                                                        }
                                                                        let _e1823 = phi_2502_;
                                                                        let _e1825 = select(_e1561, _e1823, (_e1823 < _e1561));
                                                                        let _e1827 = select(_e1553, _e1825, (_e1825 > _e1553));
                                                                        if (_e1827 >= _e757) {
                                                                            let _e1829 = (_e1827 <= _e1312.member_1);
                                                                            if _e1829 {
                                                                                let _e1830 = (1f / _e1480);
                                                                                phi_2525_ = type_26(_e1827, (_e1474 * _e1830), (_e1478 * _e1830), _e1341);
                                                                            } else {
                                                                                phi_2525_ = type_26();
                                                                            }
                                                                            let _e1835 = phi_2525_;
                                                                            phi_2527_ = _e1835;
                                                                            phi_2528_ = select(true, false, _e1829);
                                                                        } else {
                                                                            phi_2527_ = type_26();
                                                                            phi_2528_ = true;
                                                                        }
                                                                        let _e1838 = phi_2527_;
                                                                        let _e1840 = phi_2528_;
                                                                        if _e1840 {
                                                                            phi_2532_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2532_ = _e1838;
                                                                        }
                                                                        let _e1842 = phi_2532_;
                                                                        phi_2533_ = _e1842;
                                                                    }
                                                                    let _e1844 = phi_2533_;
                                                                    phi_2534_ = _e1844;
                                                                    phi_2535_ = _e1570;
                                                                }
                                                                let _e1846 = phi_2534_;
                                                                let _e1848 = phi_2535_;
                                                                phi_2539_ = _e1846;
                                                                phi_2540_ = _e1848;
                                                            }
                                                            let _e1850 = phi_2539_;
                                                            let _e1852 = phi_2540_;
                                                            phi_2541_ = _e1850;
                                                            phi_2542_ = _e1505;
                                                            phi_2543_ = _e1852;
                                                        }
                                                        let _e1854 = phi_2541_;
                                                        let _e1856 = phi_2542_;
                                                        let _e1858 = phi_2543_;
                                                        phi_2544_ = _e1854;
                                                        phi_2545_ = _e1856;
                                                        phi_2546_ = _e1858;
                                                    }
                                                    let _e1860 = phi_2544_;
                                                    let _e1862 = phi_2545_;
                                                    let _e1864 = phi_2546_;
                                                    phi_2554_ = _e1860;
                                                    phi_2555_ = select(_e1864, true, _e1862);
                                                } else {
                                                    phi_2554_ = type_26();
                                                    phi_2555_ = true;
                                                }
                                                let _e1867 = phi_2554_;
                                                let _e1869 = phi_2555_;
                                                if _e1869 {
                                                    phi_2559_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2559_ = _e1867;
                                                }
                                                let _e1871 = phi_2559_;
                                                if (_e1871.member_3 != 4294967295u) {
                                                    if (_e1341 == _e170) {
                                                        phi_2894_ = false;
                                                    } else {
                                                        let _e1875 = (_e1341 < arrayLength((&global_5.member)));
                                                        if _e1875 {
                                                            if _e1875 {
                                                            } else {
                                                                phi_4603_ = true;
                                                                break;
                                                            }
                                                            let _e1877 = global_5.member[_e1341];
                                                            phi_2582_ = _e1877;
                                                        } else {
                                                            phi_2582_ = 4294967295u;
                                                        }
                                                        let _e1879 = phi_2582_;
                                                        let _e1880 = (_e1879 < arrayLength((&global_6.member)));
                                                        if _e1880 {
                                                            if _e1880 {
                                                            } else {
                                                                phi_4603_ = true;
                                                                break;
                                                            }
                                                            let _e1882 = global_6.member[_e1879];
                                                            phi_2596_ = _e1882;
                                                        } else {
                                                            phi_2596_ = 0i;
                                                        }
                                                        let _e1884 = phi_2596_;
                                                        let _e1885 = (_e1884 == 0i);
                                                        if _e1885 {
                                                            phi_2893_ = true;
                                                        } else {
                                                            if _e448 {
                                                                phi_2619_ = vec3<f32>(_e1408[0][0], _e1408[0][1], _e1408[0][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2618_ = vec3<f32>(_e1408[0][2], _e1408[0][0], _e1408[0][1]);
                                                                } else {
                                                                    phi_2618_ = vec3<f32>(_e1408[0][1], _e1408[0][2], _e1408[0][0]);
                                                                }
                                                                let _e1890 = phi_2618_;
                                                                phi_2619_ = _e1890;
                                                            }
                                                            let _e1893 = phi_2619_;
                                                            if _e448 {
                                                                phi_2638_ = vec3<f32>(_e1408[1][0], _e1408[1][1], _e1408[1][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2637_ = vec3<f32>(_e1408[1][2], _e1408[1][0], _e1408[1][1]);
                                                                } else {
                                                                    phi_2637_ = vec3<f32>(_e1408[1][1], _e1408[1][2], _e1408[1][0]);
                                                                }
                                                                let _e1898 = phi_2637_;
                                                                phi_2638_ = _e1898;
                                                            }
                                                            let _e1901 = phi_2638_;
                                                            if _e448 {
                                                                phi_2657_ = vec3<f32>(_e1408[2][0], _e1408[2][1], _e1408[2][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2656_ = vec3<f32>(_e1408[2][2], _e1408[2][0], _e1408[2][1]);
                                                                } else {
                                                                    phi_2656_ = vec3<f32>(_e1408[2][1], _e1408[2][2], _e1408[2][0]);
                                                                }
                                                                let _e1906 = phi_2656_;
                                                                phi_2657_ = _e1906;
                                                            }
                                                            let _e1909 = phi_2657_;
                                                            let _e1912 = (_e1901.x - _e1893.x);
                                                            let _e1915 = (_e1901.y - _e1893.y);
                                                            let _e1918 = (_e1901.z - _e1893.z);
                                                            let _e1920 = (_e1909.x - _e1893.x);
                                                            let _e1922 = (_e1909.y - _e1893.y);
                                                            let _e1924 = (_e1909.z - _e1893.z);
                                                            if (_e302.member_1 == 1u) {
                                                                phi_2693_ = (vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]) - _e1893);
                                                            } else {
                                                                phi_2693_ = vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]);
                                                            }
                                                            let _e1939 = phi_2693_;
                                                            let _e1945 = bitcast<f32>((bitcast<u32>((_e1912 * _e1922)) ^ _e302.member_3[0]));
                                                            let _e1949 = bitcast<f32>((bitcast<u32>((_e1915 * _e1920)) ^ _e302.member_3[0]));
                                                            let _e1953 = bitcast<f32>((bitcast<u32>((_e1915 * _e1924)) ^ _e302.member_3[0]));
                                                            let _e1957 = bitcast<f32>((bitcast<u32>((_e1918 * _e1922)) ^ _e302.member_3[0]));
                                                            let _e1961 = bitcast<f32>((bitcast<u32>((_e1918 * _e1920)) ^ _e302.member_3[0]));
                                                            let _e1965 = bitcast<f32>((bitcast<u32>((_e1912 * _e1924)) ^ _e302.member_3[0]));
                                                            let _e1966 = (_e1953 - _e1957);
                                                            let _e1967 = (_e1961 - _e1965);
                                                            let _e1968 = (_e1945 - _e1949);
                                                            let _e1992 = (bitcast<f32>((bitcast<u32>(_e1953) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1957) & 2147483647u)));
                                                            let _e1999 = (bitcast<f32>((bitcast<u32>(_e1961) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1965) & 2147483647u)));
                                                            let _e2006 = (bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1949) & 2147483647u)));
                                                            if (_e302.member_2 == 0f) {
                                                                phi_2875_ = 0f;
                                                            } else {
                                                                let _e2036 = bitcast<f32>((bitcast<u32>(_e1966) & 2147483647u));
                                                                let _e2039 = bitcast<f32>((bitcast<u32>(_e1967) & 2147483647u));
                                                                let _e2042 = bitcast<f32>((bitcast<u32>(_e1968) & 2147483647u));
                                                                let _e2044 = select(_e2042, _e2039, (_e2039 > _e2042));
                                                                let _e2048 = select(_e2042, _e2039, (_e2039 < _e2042));
                                                                let _e2052 = select(_e2039, _e2036, (_e2036 < _e2039));
                                                                let _e2054 = select(_e2039, _e2036, (_e2036 > _e2039));
                                                                let _e2056 = select(_e2042, _e2054, (_e2054 < _e2042));
                                                                phi_2875_ = bitcast<f32>((bitcast<u32>((_e302.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2044, _e2036, (_e2036 > _e2044)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2056, _e2052, (_e2052 > _e2056)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2048, _e2036, (_e2036 < _e2048)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1992 + _e1999) + _e2006))) ^ _e302.member_3[0]))) * 1.0000005f)) ^ _e302.member_3[0])))) ^ _e302.member_3[0]));
                                                            }
                                                            let _e2083 = phi_2875_;
                                                            phi_2893_ = (_e1885 || !(((((bitcast<f32>((bitcast<u32>((_e1939.x * _e1966)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1939.y * _e1967)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1939.z * _e1968)) ^ _e302.member_3[0]))) * f32(-(_e1884))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1939.x) & 2147483647u)) * _e1992)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1939.y) & 2147483647u)) * _e1999)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1939.z) & 2147483647u)) * _e2006)) ^ _e302.member_3[0]))))) ^ _e302.member_3[0])) + _e2083) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2097 = phi_2893_;
                                                        phi_2894_ = _e2097;
                                                    }
                                                    let _e2099 = phi_2894_;
                                                    if _e2099 {
                                                        if (_e1871.member < _e1312.member.member) {
                                                            phi_2914_ = true;
                                                        } else {
                                                            if (_e1871.member == _e1312.member.member) {
                                                                phi_2913_ = (_e1871.member_3 < _e1312.member.member_3);
                                                            } else {
                                                                phi_2913_ = false;
                                                            }
                                                            let _e2109 = phi_2913_;
                                                            phi_2914_ = _e2109;
                                                        }
                                                        let _e2111 = phi_2914_;
                                                        if _e2111 {
                                                            phi_2920_ = type_44(_e1871, _e1871.member);
                                                        } else {
                                                            phi_2920_ = _e1312;
                                                        }
                                                        let _e2114 = phi_2920_;
                                                        phi_2921_ = _e2114;
                                                    } else {
                                                        phi_2921_ = _e1312;
                                                    }
                                                    let _e2116 = phi_2921_;
                                                    phi_2922_ = _e2116;
                                                } else {
                                                    phi_2922_ = _e1312;
                                                }
                                                let _e2118 = phi_2922_;
                                                phi_1522_ = _e2118;
                                            } else {
                                                phi_1522_ = type_44();
                                            }
                                            let _e2120 = phi_1522_;
                                            continue;
                                            continuing {
                                                phi_1521_ = _e2120;
                                                phi_1524_ = _e1327;
                                                phi_4603_ = _e799;
                                                break if !(_e1333);
                                            }
                                        }
                                        let _e2123 = phi_4603_;
                                        phi_4795_ = _e2123;
                                        if _e2123 {
                                            break;
                                        }
                                        phi_4799_ = _e2123;
                                        let _e2456 = local_11;
                                        phi_4158_ = _e2456;
                                        phi_4159_ = false;
                                        phi_4160_ = _e842;
                                        phi_4161_ = _e844;
                                    } else {
                                        if (_e844.member_1 >= _e103) {
                                            phi_3693_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e844.member_1 < _e103) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e855 = (_e424 * 2u);
                                            let _e857 = ((1u + _e855) % 7u);
                                            if (_e857 < 7u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e862 = global_10.member[_e844.member_1][_e857];
                                            let _e864 = ((_e855 + 2u) % 7u);
                                            if (_e864 < 7u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e869 = global_10.member[_e844.member_1][_e864];
                                            let _e870 = (_e423 * 2u);
                                            let _e872 = ((1u + _e870) % 7u);
                                            if (_e872 < 7u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e877 = global_10.member[_e844.member_1][_e872];
                                            let _e879 = ((_e870 + 2u) % 7u);
                                            if (_e879 < 7u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e884 = global_10.member[_e844.member_1][_e879];
                                            let _e885 = (_e425 * 2u);
                                            let _e887 = ((1u + _e885) % 7u);
                                            if (_e887 < 7u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e892 = global_10.member[_e844.member_1][_e887];
                                            let _e894 = ((_e885 + 2u) % 7u);
                                            if (_e894 < 7u) {
                                            } else {
                                                phi_4795_ = true;
                                                break;
                                            }
                                            let _e899 = global_10.member[_e844.member_1][_e894];
                                            let _e922 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.x - _e844.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e923 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.y - _e844.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e924 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.z - _e844.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e926 = select(_e161, _e922, (_e922 > _e161));
                                            let _e928 = select(_e161, _e923, (_e923 > _e161));
                                            let _e930 = select(_e161, _e924, (_e924 > _e161));
                                            let _e961 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e862 & 2097151u))) - 8388608f) * _e926));
                                            let _e966 = (bitcast<i32>((_e862 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e969 = bitcast<f32>((_e961 & bitcast<u32>(_e966)));
                                            let _e970 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e877 & 2097151u))) - 8388608f) * _e928));
                                            let _e975 = (bitcast<i32>((_e877 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e978 = bitcast<f32>((_e970 & bitcast<u32>(_e975)));
                                            let _e979 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e892 & 2097151u))) - 8388608f) * _e930));
                                            let _e984 = (bitcast<i32>((_e892 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e987 = bitcast<f32>((_e979 & bitcast<u32>(_e984)));
                                            let _e991 = bitcast<f32>((_e961 & bitcast<u32>(~(_e966))));
                                            let _e995 = bitcast<f32>((_e970 & bitcast<u32>(~(_e975))));
                                            let _e999 = bitcast<f32>((_e979 & bitcast<u32>(~(_e984))));
                                            let _e1000 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e869 & 2097151u))) - 8388608f) * _e926));
                                            let _e1005 = (bitcast<i32>((_e869 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1008 = bitcast<f32>((_e1000 & bitcast<u32>(_e1005)));
                                            let _e1009 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e884 & 2097151u))) - 8388608f) * _e928));
                                            let _e1014 = (bitcast<i32>((_e884 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1017 = bitcast<f32>((_e1009 & bitcast<u32>(_e1014)));
                                            let _e1018 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e899 & 2097151u))) - 8388608f) * _e930));
                                            let _e1023 = (bitcast<i32>((_e899 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1026 = bitcast<f32>((_e1018 & bitcast<u32>(_e1023)));
                                            let _e1030 = bitcast<f32>((_e1000 & bitcast<u32>(~(_e1005))));
                                            let _e1034 = bitcast<f32>((_e1009 & bitcast<u32>(~(_e1014))));
                                            let _e1038 = bitcast<f32>((_e1018 & bitcast<u32>(~(_e1023))));
                                            let _e1068 = global_10.member[_e844.member_1][0u];
                                            let _e1072 = global_10.member[_e844.member_1][2u];
                                            let _e1076 = global_10.member[_e844.member_1][4u];
                                            let _e1080 = global_10.member[_e844.member_1][6u];
                                            let _e1092 = (((_e1072 >> bitcast<u32>(22i)) | ((_e1076 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1080 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1093 = (_e1068 & 268435455u);
                                            let _e1094 = (_e1092 & 268435455u);
                                            let _e1097 = ((_e1068 >> bitcast<u32>(28u)) & 7u);
                                            let _e1105 = ((_e1068 >> bitcast<u32>(31i)) | (((_e1092 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1106 = (_e1097 != 0u);
                                            if (_e1097 == 0u) {
                                                phi_3655_ = _e1093;
                                            } else {
                                                if (_e1097 == 7u) {
                                                    phi_3654_ = 2147483648u;
                                                } else {
                                                    phi_3654_ = ((2147483648u | (_e1097 << bitcast<u32>(28u))) | (_e1094 & 268435455u));
                                                }
                                                let _e1115 = phi_3654_;
                                                phi_3655_ = _e1115;
                                            }
                                            let _e1117 = phi_3655_;
                                            if _e1106 {
                                                let _e1118 = (_e1097 != 7u);
                                                if _e1118 {
                                                    phi_3665_ = (_e1094 + _e1097);
                                                } else {
                                                    phi_3665_ = u32();
                                                }
                                                let _e1121 = phi_3665_;
                                                phi_3667_ = _e1121;
                                                phi_3668_ = select(true, false, _e1118);
                                            } else {
                                                phi_3667_ = u32();
                                                phi_3668_ = true;
                                            }
                                            let _e1124 = phi_3667_;
                                            let _e1126 = phi_3668_;
                                            if (_e1105 == 0u) {
                                                phi_3689_ = (_e1093 + select(0u, 1u, !(_e1106)));
                                            } else {
                                                if (_e1105 == 7u) {
                                                    phi_3688_ = 2147483648u;
                                                } else {
                                                    phi_3688_ = ((2147483648u | (_e1105 << bitcast<u32>(28u))) | (select(_e1124, _e1094, _e1126) & 268435455u));
                                                }
                                                let _e1139 = phi_3688_;
                                                phi_3689_ = _e1139;
                                            }
                                            let _e1141 = phi_3689_;
                                            phi_3693_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e844.member.member.x + _e969), (_e844.member.member.x + _e991), (_e844.member.member_1.x - _e1008), (_e844.member.member_1.x - _e1030)), vec4<f32>((_e844.member.member.y + _e978), (_e844.member.member.y + _e995), (_e844.member.member_1.y - _e1017), (_e844.member.member_1.y - _e1034)), vec4<f32>((_e844.member.member.z + _e987), (_e844.member.member.z + _e999), (_e844.member.member_1.z - _e1026), (_e844.member.member_1.z - _e1038))), type_62(type_38((_e844.member.member + vec4<f32>(_e969, _e978, _e987, 0f)), (_e844.member.member_1 - vec4<f32>(_e1008, _e1017, _e1026, 0f))), _e1117), type_62(type_38((_e844.member.member + vec4<f32>(_e991, _e995, _e999, 0f)), (_e844.member.member_1 - vec4<f32>(_e1030, _e1034, _e1038, 0f))), _e1141));
                                        }
                                        let _e1146 = phi_3693_;
                                        let _e1158 = ((_e1146.member[0].x - _e509) * _e514);
                                        let _e1159 = ((_e1146.member[0].y - _e509) * _e514);
                                        let _e1160 = ((_e1146.member[0].z - _e510) * _e514);
                                        let _e1161 = ((_e1146.member[0].w - _e510) * _e514);
                                        let _e1171 = ((_e1146.member[1].x - _e575) * _e580);
                                        let _e1172 = ((_e1146.member[1].y - _e575) * _e580);
                                        let _e1173 = ((_e1146.member[1].z - _e576) * _e580);
                                        let _e1174 = ((_e1146.member[1].w - _e576) * _e580);
                                        let _e1184 = ((_e1146.member[2].x - _e641) * _e646);
                                        let _e1185 = ((_e1146.member[2].y - _e641) * _e646);
                                        let _e1186 = ((_e1146.member[2].z - _e642) * _e646);
                                        let _e1187 = ((_e1146.member[2].w - _e642) * _e646);
                                        let _e1189 = select(_e1186, _e1184, (_e1184 < _e1186));
                                        let _e1191 = select(_e1187, _e1185, (_e1185 < _e1187));
                                        let _e1193 = select(_e1186, _e1184, (_e1184 > _e1186));
                                        let _e1195 = select(_e1187, _e1185, (_e1185 > _e1187));
                                        let _e1197 = select(_e1160, _e1158, (_e1158 < _e1160));
                                        let _e1199 = select(_e1161, _e1159, (_e1159 < _e1161));
                                        let _e1201 = select(_e1173, _e1171, (_e1171 < _e1173));
                                        let _e1203 = select(_e1174, _e1172, (_e1172 < _e1174));
                                        let _e1205 = select(_e1201, _e1197, (_e1197 > _e1201));
                                        let _e1207 = select(_e1203, _e1199, (_e1199 > _e1203));
                                        let _e1209 = select(_e1189, _e1205, (_e1205 > _e1189));
                                        let _e1211 = select(_e1191, _e1207, (_e1207 > _e1191));
                                        let _e1213 = select(_e1160, _e1158, (_e1158 > _e1160));
                                        let _e1215 = select(_e1161, _e1159, (_e1159 > _e1161));
                                        let _e1217 = select(_e1173, _e1171, (_e1171 > _e1173));
                                        let _e1219 = select(_e1174, _e1172, (_e1172 > _e1174));
                                        let _e1221 = select(_e1217, _e1213, (_e1213 < _e1217));
                                        let _e1223 = select(_e1219, _e1215, (_e1215 < _e1219));
                                        let _e1228 = -(_e1189);
                                        let _e1229 = -(_e1191);
                                        let _e1236 = (select(_e1193, _e1221, (_e1221 < _e1193)) + (select(_e1228, _e1193, (_e1193 > _e1228)) * 0.0000019073523f));
                                        let _e1237 = (select(_e1195, _e1223, (_e1223 < _e1195)) + (select(_e1229, _e1195, (_e1195 > _e1229)) * 0.0000019073523f));
                                        let _e1239 = select(_e757, _e1209, (_e1209 > _e757));
                                        let _e1241 = select(_e757, _e1211, (_e1211 > _e757));
                                        let _e1246 = (_e1239 <= select(_e801.member_1, _e1236, (_e1236 < _e801.member_1)));
                                        let _e1247 = (_e1241 <= select(_e801.member_1, _e1237, (_e1237 < _e801.member_1)));
                                        let _e1248 = (_e1239 <= _e1241);
                                        if _e1246 {
                                            if _e1247 {
                                                if _e1248 {
                                                    phi_4055_ = _e1146.member_2;
                                                } else {
                                                    phi_4055_ = _e1146.member_1;
                                                }
                                                let _e1252 = phi_4055_;
                                                let _e1274 = (_e842 % 128u);
                                                let _e1275 = (_e1274 < 128u);
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_8[_e1274] = _e1252.member_1;
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_7[_e1274] = _e1252.member.member.x;
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_6[_e1274] = _e1252.member.member.y;
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_5[_e1274] = _e1252.member.member.z;
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_4[_e1274] = _e1252.member.member_1.x;
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_3[_e1274] = _e1252.member.member_1.y;
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_2[_e1274] = _e1252.member.member_1.z;
                                                if _e1275 {
                                                } else {
                                                    phi_4795_ = true;
                                                    break;
                                                }
                                                local_9[_e1274] = select(_e1241, _e1239, !(_e1248));
                                                if _e1248 {
                                                    phi_4132_ = _e1146.member_1;
                                                } else {
                                                    phi_4132_ = _e1146.member_2;
                                                }
                                                let _e1288 = phi_4132_;
                                                phi_4133_ = (_e842 + 1u);
                                                phi_4134_ = _e1288;
                                            } else {
                                                phi_4133_ = u32();
                                                phi_4134_ = type_62();
                                            }
                                            let _e1290 = phi_4133_;
                                            let _e1292 = phi_4134_;
                                            phi_4136_ = _e1290;
                                            phi_4137_ = _e1292;
                                            phi_4138_ = select(true, false, _e1247);
                                        } else {
                                            phi_4136_ = u32();
                                            phi_4137_ = type_62();
                                            phi_4138_ = true;
                                        }
                                        let _e1295 = phi_4136_;
                                        let _e1297 = phi_4137_;
                                        let _e1299 = phi_4138_;
                                        if _e1299 {
                                            if _e1246 {
                                                phi_4147_ = _e1146.member_1;
                                            } else {
                                                phi_4147_ = _e1146.member_2;
                                            }
                                            let _e1303 = phi_4147_;
                                            phi_4152_ = select(_e1247, true, _e1246);
                                            phi_4154_ = _e1303;
                                        } else {
                                            phi_4152_ = _e840;
                                            phi_4154_ = _e1297;
                                        }
                                        let _e1306 = phi_4152_;
                                        let _e1308 = phi_4154_;
                                        phi_4799_ = _e799;
                                        phi_4158_ = _e801;
                                        phi_4159_ = _e1306;
                                        phi_4160_ = select(_e1295, _e842, _e1299);
                                        phi_4161_ = _e1308;
                                    }
                                    let _e2125 = phi_4799_;
                                    let _e2127 = phi_4158_;
                                    let _e2129 = phi_4159_;
                                    let _e2131 = phi_4160_;
                                    let _e2133 = phi_4161_;
                                    phi_4798_ = _e2125;
                                    phi_4162_ = _e2127;
                                    phi_4163_ = _e2129;
                                    phi_4164_ = (_e805 - 1u);
                                    phi_4165_ = _e2131;
                                    phi_4166_ = _e2133;
                                } else {
                                    phi_4798_ = _e799;
                                    phi_4162_ = _e801;
                                    phi_4163_ = _e840;
                                    phi_4164_ = _e805;
                                    phi_4165_ = _e842;
                                    phi_4166_ = _e844;
                                }
                                let _e2135 = phi_4798_;
                                let _e2137 = phi_4162_;
                                let _e2139 = phi_4163_;
                                let _e2141 = phi_4164_;
                                let _e2143 = phi_4165_;
                                let _e2145 = phi_4166_;
                                phi_4797_ = _e2135;
                                phi_4167_ = _e2137;
                                phi_4168_ = _e2139;
                                phi_4169_ = _e2141;
                                phi_4170_ = _e2143;
                                phi_4171_ = _e2145;
                            } else {
                                phi_4797_ = _e799;
                                phi_4167_ = type_44();
                                phi_4168_ = bool();
                                phi_4169_ = u32();
                                phi_4170_ = u32();
                                phi_4171_ = type_62();
                            }
                            let _e2147 = phi_4797_;
                            let _e2149 = phi_4167_;
                            let _e2151 = phi_4168_;
                            let _e2153 = phi_4169_;
                            let _e2155 = phi_4170_;
                            let _e2157 = phi_4171_;
                            phi_4796_ = _e2147;
                            phi_1396_ = _e2149;
                            phi_1399_ = _e2151;
                            phi_1401_ = _e2153;
                            phi_1403_ = _e2155;
                            phi_1405_ = _e2157;
                            phi_4172_ = _e813;
                        } else {
                            phi_4796_ = _e799;
                            phi_1396_ = type_44();
                            phi_1399_ = bool();
                            phi_1401_ = u32();
                            phi_1403_ = u32();
                            phi_1405_ = type_62();
                            phi_4172_ = false;
                        }
                        let _e2159 = phi_4796_;
                        let _e2161 = phi_1396_;
                        let _e2163 = phi_1399_;
                        let _e2165 = phi_1401_;
                        let _e2167 = phi_1403_;
                        let _e2169 = phi_1405_;
                        let _e2171 = phi_4172_;
                        continue;
                        continuing {
                            phi_4609_ = _e2159;
                            phi_1395_ = _e2161;
                            phi_1398_ = _e2163;
                            phi_1400_ = _e2165;
                            phi_1402_ = _e2167;
                            phi_1404_ = _e2169;
                            phi_4795_ = _e2159;
                            break if !(_e2171);
                        }
                    }
                    let _e2174 = phi_4795_;
                    if _e2174 {
                        break;
                    }
                    let _e2176 = local_10;
                    if (_e2176.member.member_3 != 4294967295u) {
                        let _e2181 = bitcast<u32>(_e2176.member.member);
                        let _e2185 = (bitcast<i32>((_e2181 >> bitcast<u32>(23i))) & 255i);
                        let _e2186 = (_e2185 + _e426);
                        if (_e2185 == 255i) {
                            phi_4231_ = _e2176.member.member;
                        } else {
                            if (_e2185 > 0i) {
                                if (_e2186 > 0i) {
                                    let _e2190 = (_e2186 < 255i);
                                    if _e2190 {
                                        phi_4210_ = bitcast<f32>((_e2181 + bitcast<u32>((_e426 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4210_ = f32();
                                    }
                                    let _e2197 = phi_4210_;
                                    phi_4212_ = _e2197;
                                    phi_4213_ = select(true, false, _e2190);
                                } else {
                                    phi_4212_ = f32();
                                    phi_4213_ = true;
                                }
                                let _e2200 = phi_4212_;
                                let _e2202 = phi_4213_;
                                phi_4214_ = _e2200;
                                phi_4215_ = _e2202;
                            } else {
                                phi_4214_ = f32();
                                phi_4215_ = true;
                            }
                            let _e2204 = phi_4214_;
                            let _e2206 = phi_4215_;
                            if _e2206 {
                                let _e2207 = (_e2181 & 2147483648u);
                                let _e2214 = ((_e2181 & 8388607u) | (select(0u, 1u, ((_e2181 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2218 = (_e2214 == 0u);
                                if _e2218 {
                                    phi_4561_ = bitcast<f32>(_e2207);
                                } else {
                                    let _e2223 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2214)), 32u, _e2218) - 8u);
                                    let _e2226 = (_e2214 << bitcast<u32>((_e2223 & 31u)));
                                    let _e2228 = ((_e2186 + select(0i, 1i, (_e2185 == 0i))) - bitcast<i32>(_e2223));
                                    if (_e2228 >= 255i) {
                                        phi_4551_ = bitcast<f32>((_e2207 | 2139095040u));
                                        phi_4552_ = f32();
                                        phi_4553_ = true;
                                    } else {
                                        let _e2230 = (_e2228 > 0i);
                                        if _e2230 {
                                            phi_4545_ = bitcast<f32>(((_e2207 | (bitcast<u32>(_e2228) << bitcast<u32>(23i))) | (_e2226 & 8388607u)));
                                            phi_4546_ = f32();
                                        } else {
                                            if (_e2228 < -24i) {
                                                phi_4511_ = 26u;
                                            } else {
                                                phi_4511_ = bitcast<u32>((1i - _e2228));
                                            }
                                            let _e2235 = phi_4511_;
                                            let _e2236 = (_e2235 & 31u);
                                            let _e2238 = (_e2226 >> bitcast<u32>(_e2236));
                                            let _e2242 = (_e2226 & ((1u << bitcast<u32>(_e2236)) - 1u));
                                            let _e2246 = (1u << bitcast<u32>(((_e2235 - 1u) & 31u)));
                                            if (_e2242 > _e2246) {
                                                phi_4532_ = true;
                                            } else {
                                                if (_e2242 == _e2246) {
                                                    phi_4529_ = ((_e2238 & 1u) == 1u);
                                                } else {
                                                    phi_4529_ = false;
                                                }
                                                let _e2252 = phi_4529_;
                                                phi_4532_ = _e2252;
                                            }
                                            let _e2254 = phi_4532_;
                                            phi_4545_ = f32();
                                            phi_4546_ = bitcast<f32>((_e2207 | (_e2238 + select(0u, 1u, _e2254))));
                                        }
                                        let _e2267 = phi_4545_;
                                        let _e2269 = phi_4546_;
                                        phi_4551_ = _e2267;
                                        phi_4552_ = _e2269;
                                        phi_4553_ = _e2230;
                                    }
                                    let _e2273 = phi_4551_;
                                    let _e2275 = phi_4552_;
                                    let _e2277 = phi_4553_;
                                    phi_4561_ = select(_e2275, _e2273, _e2277);
                                }
                                let _e2281 = phi_4561_;
                                phi_4230_ = _e2281;
                            } else {
                                phi_4230_ = _e2204;
                            }
                            let _e2283 = phi_4230_;
                            phi_4231_ = _e2283;
                        }
                        let _e2285 = phi_4231_;
                        let _e2286 = bitcast<u32>(_e2285);
                        if ((_e2286 & 2147483647u) >= 2139095040u) {
                            phi_4243_ = bitcast<f32>(((_e2286 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4243_ = _e2285;
                        }
                        let _e2293 = phi_4243_;
                        phi_4248_ = type_26(_e2293, _e2176.member.member_1, _e2176.member.member_2, _e2176.member.member_3);
                    } else {
                        phi_4248_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2298 = phi_4248_;
                    if _e303 {
                    } else {
                        break;
                    }
                    global_8.member[_e149] = _e2298;
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e2302 = select(0u, 1u, (_e370 <= _e380));
                    if (_e2302 > 0u) {
                        let _e2304 = (1u < _e117);
                        if _e2304 {
                            if (0u < _e117) {
                            } else {
                                break;
                            }
                            let _e2308 = atomicAdd((&global_9.member[0u]), _e2302);
                            if ((_e2308 + _e2302) < _e2308) {
                                if _e2304 {
                                } else {
                                    break;
                                }
                                let _e2313 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2316 = select(0u, 1u, (_e2298.member_3 != 4294967295u));
                    if (_e2316 > 0u) {
                        let _e2318 = (3u < _e117);
                        if _e2318 {
                            if (2u < _e117) {
                            } else {
                                break;
                            }
                            let _e2322 = atomicAdd((&global_9.member[2u]), _e2316);
                            if ((_e2322 + _e2316) < _e2322) {
                                if _e2318 {
                                } else {
                                    break;
                                }
                                let _e2327 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
