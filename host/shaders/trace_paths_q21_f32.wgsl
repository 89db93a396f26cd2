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
    var phi_4613_: bool;
    var phi_1395_: type_44;
    var phi_1398_: u32;
    var phi_1400_: bool;
    var phi_1402_: u32;
    var phi_1404_: type_62;
    var phi_1415_: bool;
    var phi_1501_: bool;
    var phi_1502_: u32;
    var phi_1503_: type_62;
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
    var phi_4607_: bool;
    var phi_4885_: bool;
    var phi_2923_: type_44;
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
    var phi_4166_: type_44;
    var phi_4167_: u32;
    var phi_4168_: bool;
    var phi_4169_: u32;
    var phi_4170_: type_62;
    var phi_4801_: bool;
    var phi_4171_: type_44;
    var phi_4172_: u32;
    var phi_4173_: bool;
    var phi_4174_: u32;
    var phi_4175_: type_62;
    var phi_4800_: bool;
    var phi_1396_: type_44;
    var phi_1399_: u32;
    var phi_1401_: bool;
    var phi_1403_: u32;
    var phi_1405_: type_62;
    var phi_4176_: bool;
    var phi_4799_: bool;
    var local_10: type_44;
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
    var phi_4252_: type_26;
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
                    phi_4613_ = false;
                    phi_1395_ = type_44(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e755);
                    phi_1398_ = ((3u * _e103) + 1u);
                    phi_1400_ = (_e757 <= _e755);
                    phi_1402_ = 0u;
                    phi_1404_ = type_62(type_38(vec4<f32>((f32(_e764) * _e161), (f32(_e770) * _e161), (f32(_e776) * _e161), 0f), vec4<f32>((f32(_e781) * _e161), (f32(_e785) * _e161), (f32(_e789) * _e161), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    loop {
                        let _e799 = phi_4613_;
                        let _e801 = phi_1395_;
                        let _e803 = phi_1398_;
                        let _e805 = phi_1400_;
                        let _e807 = phi_1402_;
                        let _e809 = phi_1404_;
                        local_10 = _e801;
                        if _e805 {
                            phi_1415_ = true;
                        } else {
                            phi_1415_ = (_e807 > 0u);
                        }
                        let _e812 = phi_1415_;
                        if _e812 {
                            let _e813 = (_e803 > 0u);
                            if _e813 {
                                if _e805 {
                                    phi_1501_ = _e805;
                                    phi_1502_ = _e807;
                                    phi_1503_ = _e809;
                                } else {
                                    let _e814 = (_e807 - 1u);
                                    let _e815 = (_e814 % 128u);
                                    let _e816 = (_e815 < 128u);
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e818 = local_7[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e820 = local_6[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e822 = local_5[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e824 = local_4[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e826 = local_3[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e828 = local_2[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
                                        break;
                                    }
                                    let _e833 = local_8[_e815];
                                    if _e816 {
                                    } else {
                                        phi_4799_ = true;
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
                                    let _e848 = ((_e844.member_1 & 2147483648u) != 0u);
                                    if _e848 {
                                        phi_1521_ = _e801;
                                        phi_1524_ = type_8(0u, ((_e844.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e855 = phi_1521_;
                                            let _e857 = phi_1524_;
                                            local_11 = _e855;
                                            if (_e857.member < _e857.member_1) {
                                                phi_1525_ = type_8((_e857.member + 1u), _e857.member_1);
                                                phi_1547_ = type_8(1u, _e857.member);
                                            } else {
                                                phi_1525_ = _e857;
                                                phi_1547_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e870 = phi_1525_;
                                            let _e872 = phi_1547_;
                                            let _e876 = (bitcast<i32>(_e872.member) != 0i);
                                            if _e876 {
                                                let _e877 = ((_e844.member_1 & 268435455u) + _e872.member_1);
                                                let _e878 = (_e877 < _e105);
                                                if _e878 {
                                                    if _e878 {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e882 = global_4.member[_e877].member_1;
                                                    phi_1568_ = _e882;
                                                } else {
                                                    phi_1568_ = 4294967295u;
                                                }
                                                let _e884 = phi_1568_;
                                                if (_e877 >= _e105) {
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e878 {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e891 = global_4.member[_e877].member[_e761];
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e897 = global_4.member[_e877].member[_e767];
                                                    if (_e773 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e903 = global_4.member[_e877].member[_e773];
                                                    let _e905 = (3u + _e761);
                                                    if (_e905 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e911 = global_4.member[_e877].member[_e905];
                                                    let _e912 = (3u + _e767);
                                                    if (_e912 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e918 = global_4.member[_e877].member[_e912];
                                                    let _e919 = (3u + _e773);
                                                    if (_e919 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e925 = global_4.member[_e877].member[_e919];
                                                    let _e927 = (6u + _e761);
                                                    if (_e927 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e933 = global_4.member[_e877].member[_e927];
                                                    let _e934 = (6u + _e767);
                                                    if (_e934 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e940 = global_4.member[_e877].member[_e934];
                                                    let _e941 = (6u + _e773);
                                                    if (_e941 < 9u) {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e947 = global_4.member[_e877].member[_e941];
                                                    phi_1660_ = array<array<f32, 3>, 3>(array<f32, 3>(_e891, _e897, _e903), array<f32, 3>(_e911, _e918, _e925), array<f32, 3>(_e933, _e940, _e947));
                                                }
                                                let _e951 = phi_1660_;
                                                let _e959 = (_e951[0][2] - _e604);
                                                let _e962 = (((_e951[0][0] - _e471) * _e643) - (_e959 * _e511));
                                                let _e965 = (((_e951[0][1] - _e538) * _e643) - (_e959 * _e577));
                                                let _e972 = (_e951[1][2] - _e604);
                                                let _e975 = (((_e951[1][0] - _e471) * _e643) - (_e972 * _e511));
                                                let _e978 = (((_e951[1][1] - _e538) * _e643) - (_e972 * _e577));
                                                let _e985 = (_e951[2][2] - _e604);
                                                let _e988 = (((_e951[2][0] - _e471) * _e643) - (_e985 * _e511));
                                                let _e991 = (((_e951[2][1] - _e538) * _e643) - (_e985 * _e577));
                                                let _e992 = (_e988 * _e978);
                                                let _e993 = (_e991 * _e975);
                                                let _e994 = (_e962 * _e991);
                                                let _e995 = (_e965 * _e988);
                                                let _e996 = (_e975 * _e965);
                                                let _e997 = (_e978 * _e962);
                                                let _e1002 = (((_e992 >= _e993) && (_e994 >= _e995)) && (_e996 >= _e997));
                                                if (_e1002 || (((_e992 <= _e993) && (_e994 <= _e995)) && (_e996 <= _e997))) {
                                                    let _e1009 = select(-1f, 1f, _e1002);
                                                    let _e1011 = ((_e992 - _e993) * _e1009);
                                                    let _e1013 = select(0f, _e1011, (_e1011 > 0f));
                                                    let _e1015 = ((_e994 - _e995) * _e1009);
                                                    let _e1017 = select(0f, _e1015, (_e1015 > 0f));
                                                    let _e1019 = ((_e996 - _e997) * _e1009);
                                                    let _e1021 = select(0f, _e1019, (_e1019 > 0f));
                                                    let _e1023 = ((_e1013 + _e1017) + _e1021);
                                                    if (_e1023 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2544_ = type_26();
                                                        phi_2545_ = true;
                                                        phi_2546_ = false;
                                                    } else {
                                                        let _e1026 = select(_e975, _e962, (_e962 < _e975));
                                                        if (select(_e988, _e1026, (_e1026 < _e988)) > 0f) {
                                                            phi_1812_ = true;
                                                        } else {
                                                            let _e1031 = select(_e975, _e962, (_e962 > _e975));
                                                            phi_1812_ = (select(_e988, _e1031, (_e1031 > _e988)) < 0f);
                                                        }
                                                        let _e1036 = phi_1812_;
                                                        if _e1036 {
                                                            phi_2541_ = type_26();
                                                            phi_2542_ = true;
                                                            phi_2543_ = false;
                                                        } else {
                                                            let _e1038 = select(_e978, _e965, (_e965 < _e978));
                                                            if (select(_e991, _e1038, (_e1038 < _e991)) > 0f) {
                                                                phi_1841_ = true;
                                                            } else {
                                                                let _e1043 = select(_e978, _e965, (_e965 > _e978));
                                                                phi_1841_ = (select(_e991, _e1043, (_e1043 > _e991)) < 0f);
                                                            }
                                                            let _e1048 = phi_1841_;
                                                            if _e1048 {
                                                                phi_2539_ = type_26();
                                                                phi_2540_ = false;
                                                            } else {
                                                                let _e1050 = select(_e951[1][0], _e951[0][0], (_e951[0][0] < _e951[1][0]));
                                                                let _e1054 = select(_e951[1][0], _e951[0][0], (_e951[0][0] > _e951[1][0]));
                                                                let _e1058 = select(_e951[1][1], _e951[0][1], (_e951[0][1] < _e951[1][1]));
                                                                let _e1062 = select(_e951[1][1], _e951[0][1], (_e951[0][1] > _e951[1][1]));
                                                                let _e1066 = select(_e951[1][2], _e951[0][2], (_e951[0][2] < _e951[1][2]));
                                                                let _e1070 = select(_e951[1][2], _e951[0][2], (_e951[0][2] > _e951[1][2]));
                                                                let _e1075 = ((select(_e951[2][0], _e1050, (_e1050 < _e951[2][0])) - _e509) * _e514);
                                                                let _e1076 = ((select(_e951[2][0], _e1054, (_e1054 > _e951[2][0])) - _e510) * _e514);
                                                                let _e1079 = ((select(_e951[2][1], _e1058, (_e1058 < _e951[2][1])) - _e575) * _e580);
                                                                let _e1080 = ((select(_e951[2][1], _e1062, (_e1062 > _e951[2][1])) - _e576) * _e580);
                                                                let _e1083 = ((select(_e951[2][2], _e1066, (_e1066 < _e951[2][2])) - _e641) * _e646);
                                                                let _e1084 = ((select(_e951[2][2], _e1070, (_e1070 > _e951[2][2])) - _e642) * _e646);
                                                                let _e1086 = select(_e1084, _e1083, (_e1083 < _e1084));
                                                                let _e1088 = select(_e1084, _e1083, (_e1083 > _e1084));
                                                                let _e1090 = select(_e1076, _e1075, (_e1075 < _e1076));
                                                                let _e1092 = select(_e1080, _e1079, (_e1079 < _e1080));
                                                                let _e1094 = select(_e1092, _e1090, (_e1090 > _e1092));
                                                                let _e1096 = select(_e1086, _e1094, (_e1094 > _e1086));
                                                                let _e1098 = select(_e1076, _e1075, (_e1075 > _e1076));
                                                                let _e1100 = select(_e1080, _e1079, (_e1079 > _e1080));
                                                                let _e1102 = select(_e1100, _e1098, (_e1098 < _e1100));
                                                                let _e1104 = select(_e1088, _e1102, (_e1102 < _e1088));
                                                                let _e1105 = -(_e1086);
                                                                let _e1111 = select(_e757, _e1096, (_e1096 > _e757));
                                                                if (_e1111 > (_e1104 + (select(_e1105, _e1088, (_e1088 > _e1105)) * 0.0000019073523f))) {
                                                                    phi_2534_ = type_26();
                                                                    phi_2535_ = true;
                                                                } else {
                                                                    let _e1113 = (_e1111 > _e855.member_1);
                                                                    if _e1113 {
                                                                        phi_2533_ = type_26();
                                                                    } else {
                                                                        let _e1114 = vec3<f32>(_e951[0][0], _e951[0][1], _e951[0][2]);
                                                                        let _e1115 = vec3<f32>(_e951[1][0], _e951[1][1], _e951[1][2]);
                                                                        let _e1116 = vec3<f32>(_e951[2][0], _e951[2][1], _e951[2][2]);
                                                                        let _e1117 = (_e951[1][0] - _e951[0][0]);
                                                                        let _e1118 = (_e951[1][1] - _e951[0][1]);
                                                                        let _e1119 = (_e951[1][2] - _e951[0][2]);
                                                                        let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                                                        let _e1121 = (_e951[2][0] - _e951[1][0]);
                                                                        let _e1122 = (_e951[2][1] - _e951[1][1]);
                                                                        let _e1123 = (_e951[2][2] - _e951[1][2]);
                                                                        let _e1124 = vec3<f32>(_e1121, _e1122, _e1123);
                                                                        let _e1125 = (_e951[0][0] - _e951[2][0]);
                                                                        let _e1126 = (_e951[0][1] - _e951[2][1]);
                                                                        let _e1127 = (_e951[0][2] - _e951[2][2]);
                                                                        let _e1128 = vec3<f32>(_e1125, _e1126, _e1127);
                                                                        let _e1131 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                                        let _e1134 = bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u));
                                                                        let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                        let _e1139 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                                        let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                        let _e1144 = bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u));
                                                                        let _e1147 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                                        let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                        let _e1152 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                                        let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                        let _e1157 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                        let _e1160 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                        let _e1162 = select(_e1160, _e1157, (_e1157 > _e1160));
                                                                        let _e1165 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                        let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                        let _e1169 = select(_e1154, _e1141, (_e1141 > _e1154));
                                                                        let _e1171 = select(_e1167, _e1169, (_e1169 > _e1167));
                                                                        if (_e1141 == _e1171) {
                                                                            phi_2260_ = _e978;
                                                                            phi_2261_ = _e975;
                                                                            phi_2262_ = _e965;
                                                                            phi_2263_ = _e962;
                                                                            phi_2264_ = _e1114;
                                                                            phi_2265_ = _e1128;
                                                                            phi_2266_ = _e1124;
                                                                            phi_2267_ = _e1120;
                                                                        } else {
                                                                            let _e1173 = (_e1154 == _e1171);
                                                                            let _e1178 = vec3(_e1173);
                                                                            phi_2260_ = select(_e965, _e991, _e1173);
                                                                            phi_2261_ = select(_e962, _e988, _e1173);
                                                                            phi_2262_ = select(_e991, _e978, _e1173);
                                                                            phi_2263_ = select(_e988, _e975, _e1173);
                                                                            phi_2264_ = select(_e1116, _e1115, _e1178);
                                                                            phi_2265_ = select(_e1124, _e1120, _e1178);
                                                                            phi_2266_ = select(_e1120, _e1128, _e1178);
                                                                            phi_2267_ = select(_e1128, _e1124, _e1178);
                                                                        }
                                                                        let _e1184 = phi_2260_;
                                                                        let _e1186 = phi_2261_;
                                                                        let _e1188 = phi_2262_;
                                                                        let _e1190 = phi_2263_;
                                                                        let _e1192 = phi_2264_;
                                                                        let _e1194 = phi_2265_;
                                                                        let _e1196 = phi_2266_;
                                                                        let _e1198 = phi_2267_;
                                                                        let _e1205 = ((_e1196.y * _e1194.z) - (_e1194.y * _e1196.z));
                                                                        let _e1210 = ((_e1196.z * _e1194.x) - (_e1194.z * _e1196.x));
                                                                        let _e1213 = ((_e1196.x * _e1194.y) - (_e1194.x * _e1196.y));
                                                                        if (_e1013 >= _e1017) {
                                                                            phi_2304_ = select(true, false, (_e1013 >= _e1021));
                                                                        } else {
                                                                            phi_2304_ = true;
                                                                        }
                                                                        let _e1218 = phi_2304_;
                                                                        if _e1218 {
                                                                            phi_2313_ = select(_e1116, _e1115, vec3((_e1017 >= _e1021)));
                                                                        } else {
                                                                            phi_2313_ = _e1114;
                                                                        }
                                                                        let _e1223 = phi_2313_;
                                                                        let _e1234 = (((_e1205 * (_e1223.x - _e471)) + (_e1210 * (_e1223.y - _e538))) + (_e1213 * (_e1223.z - _e604)));
                                                                        let _e1239 = (((_e1205 * _e511) + (_e1210 * _e577)) + (_e1213 * _e643));
                                                                        let _e1240 = (_e1186 - _e1190);
                                                                        let _e1241 = (_e1184 - _e1188);
                                                                        let _e1249 = (-(((_e1190 * _e1240) + (_e1188 * _e1241))) / ((_e1240 * _e1240) + (_e1241 * _e1241)));
                                                                        let _e1251 = select(1f, _e1249, (_e1249 < 1f));
                                                                        let _e1253 = select(0f, _e1251, (_e1251 > 0f));
                                                                        let _e1266 = ((_e1192.x + (_e1198.x * _e1253)) - _e471);
                                                                        let _e1267 = ((_e1192.y + (_e1198.y * _e1253)) - _e538);
                                                                        let _e1268 = ((_e1192.z + (_e1198.z * _e1253)) - _e604);
                                                                        let _e1269 = (_e1268 / _e643);
                                                                        let _e1281 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                        let _e1284 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                        let _e1286 = select(_e1284, _e1281, (_e1281 > _e1284));
                                                                        let _e1289 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                        let _e1291 = select(_e1289, _e1286, (_e1286 > _e1289));
                                                                        let _e1297 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                        let _e1300 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                        let _e1302 = select(_e1300, _e1297, (_e1297 > _e1300));
                                                                        let _e1305 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1205 * _e1266) + (_e1210 * _e1267)) + (_e1213 * _e1268)) - _e1234)) & 2147483647u)) <= ((0.0000009536743f * select(_e1171, _e1291, (_e1291 > _e1171))) * select(_e1305, _e1302, (_e1302 > _e1305)))) {
                                                                            let _e1315 = bitcast<f32>((bitcast<u32>(_e1196.x) & 2147483647u));
                                                                            let _e1318 = bitcast<f32>((bitcast<u32>(_e1196.y) & 2147483647u));
                                                                            let _e1320 = select(_e1318, _e1315, (_e1315 > _e1318));
                                                                            let _e1323 = bitcast<f32>((bitcast<u32>(_e1196.z) & 2147483647u));
                                                                            let _e1329 = bitcast<f32>((bitcast<u32>(_e1194.x) & 2147483647u));
                                                                            let _e1332 = bitcast<f32>((bitcast<u32>(_e1194.y) & 2147483647u));
                                                                            let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                                                                            let _e1337 = bitcast<f32>((bitcast<u32>(_e1194.z) & 2147483647u));
                                                                            let _e1341 = (bitcast<f32>((bitcast<u32>(_e1239) & 2147483647u)) > ((0.0000038146973f * select(_e1323, _e1320, (_e1320 > _e1323))) * select(_e1337, _e1334, (_e1334 > _e1337))));
                                                                            if _e1341 {
                                                                                phi_2478_ = (_e1234 / _e1239);
                                                                            } else {
                                                                                phi_2478_ = f32();
                                                                            }
                                                                            let _e1344 = phi_2478_;
                                                                            phi_2480_ = _e1344;
                                                                            phi_2481_ = select(true, false, _e1341);
                                                                        } else {
                                                                            phi_2480_ = f32();
                                                                            phi_2481_ = true;
                                                                        }
                                                                        let _e1347 = phi_2480_;
                                                                        let _e1349 = phi_2481_;
                                                                        if _e1349 {
                                                                            let _e1357 = (((_e1205 * (_e1266 - (_e511 * _e1269))) + (_e1210 * (_e1267 - (_e577 * _e1269)))) / _e1239);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u)) <= _e1171) {
                                                                                phi_2501_ = (_e1269 + _e1357);
                                                                            } else {
                                                                                phi_2501_ = _e1269;
                                                                            }
                                                                            let _e1364 = phi_2501_;
                                                                            phi_2502_ = _e1364;
                                                                        } else {
                                                                            phi_2502_ = _e1347;
                                                                        }
                                                                        let _e1366 = phi_2502_;
                                                                        let _e1368 = select(_e1104, _e1366, (_e1366 < _e1104));
                                                                        let _e1370 = select(_e1096, _e1368, (_e1368 > _e1096));
                                                                        if (_e1370 >= _e757) {
                                                                            let _e1372 = (_e1370 <= _e855.member_1);
                                                                            if _e1372 {
                                                                                let _e1373 = (1f / _e1023);
                                                                                phi_2525_ = type_26(_e1370, (_e1017 * _e1373), (_e1021 * _e1373), _e884);
                                                                            } else {
                                                                                phi_2525_ = type_26();
                                                                            }
                                                                            let _e1378 = phi_2525_;
                                                                            phi_2527_ = _e1378;
                                                                            phi_2528_ = select(true, false, _e1372);
                                                                        } else {
                                                                            phi_2527_ = type_26();
                                                                            phi_2528_ = true;
                                                                        }
                                                                        let _e1381 = phi_2527_;
                                                                        let _e1383 = phi_2528_;
                                                                        if _e1383 {
                                                                            phi_2532_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2532_ = _e1381;
                                                                        }
                                                                        let _e1385 = phi_2532_;
                                                                        phi_2533_ = _e1385;
                                                                    }
                                                                    let _e1387 = phi_2533_;
                                                                    phi_2534_ = _e1387;
                                                                    phi_2535_ = _e1113;
                                                                }
                                                                let _e1389 = phi_2534_;
                                                                let _e1391 = phi_2535_;
                                                                phi_2539_ = _e1389;
                                                                phi_2540_ = _e1391;
                                                            }
                                                            let _e1393 = phi_2539_;
                                                            let _e1395 = phi_2540_;
                                                            phi_2541_ = _e1393;
                                                            phi_2542_ = _e1048;
                                                            phi_2543_ = _e1395;
                                                        }
                                                        let _e1397 = phi_2541_;
                                                        let _e1399 = phi_2542_;
                                                        let _e1401 = phi_2543_;
                                                        phi_2544_ = _e1397;
                                                        phi_2545_ = _e1399;
                                                        phi_2546_ = _e1401;
                                                    }
                                                    let _e1403 = phi_2544_;
                                                    let _e1405 = phi_2545_;
                                                    let _e1407 = phi_2546_;
                                                    phi_2554_ = _e1403;
                                                    phi_2555_ = select(_e1407, true, _e1405);
                                                } else {
                                                    phi_2554_ = type_26();
                                                    phi_2555_ = true;
                                                }
                                                let _e1410 = phi_2554_;
                                                let _e1412 = phi_2555_;
                                                if _e1412 {
                                                    phi_2559_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2559_ = _e1410;
                                                }
                                                let _e1414 = phi_2559_;
                                                if (_e1414.member_3 != 4294967295u) {
                                                    if (_e884 == _e170) {
                                                        phi_2894_ = false;
                                                    } else {
                                                        let _e1418 = (_e884 < arrayLength((&global_5.member)));
                                                        if _e1418 {
                                                            if _e1418 {
                                                            } else {
                                                                phi_4607_ = true;
                                                                break;
                                                            }
                                                            let _e1420 = global_5.member[_e884];
                                                            phi_2582_ = _e1420;
                                                        } else {
                                                            phi_2582_ = 4294967295u;
                                                        }
                                                        let _e1422 = phi_2582_;
                                                        let _e1423 = (_e1422 < arrayLength((&global_6.member)));
                                                        if _e1423 {
                                                            if _e1423 {
                                                            } else {
                                                                phi_4607_ = true;
                                                                break;
                                                            }
                                                            let _e1425 = global_6.member[_e1422];
                                                            phi_2596_ = _e1425;
                                                        } else {
                                                            phi_2596_ = 0i;
                                                        }
                                                        let _e1427 = phi_2596_;
                                                        let _e1428 = (_e1427 == 0i);
                                                        if _e1428 {
                                                            phi_2893_ = true;
                                                        } else {
                                                            if _e448 {
                                                                phi_2619_ = vec3<f32>(_e951[0][0], _e951[0][1], _e951[0][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2618_ = vec3<f32>(_e951[0][2], _e951[0][0], _e951[0][1]);
                                                                } else {
                                                                    phi_2618_ = vec3<f32>(_e951[0][1], _e951[0][2], _e951[0][0]);
                                                                }
                                                                let _e1433 = phi_2618_;
                                                                phi_2619_ = _e1433;
                                                            }
                                                            let _e1436 = phi_2619_;
                                                            if _e448 {
                                                                phi_2638_ = vec3<f32>(_e951[1][0], _e951[1][1], _e951[1][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2637_ = vec3<f32>(_e951[1][2], _e951[1][0], _e951[1][1]);
                                                                } else {
                                                                    phi_2637_ = vec3<f32>(_e951[1][1], _e951[1][2], _e951[1][0]);
                                                                }
                                                                let _e1441 = phi_2637_;
                                                                phi_2638_ = _e1441;
                                                            }
                                                            let _e1444 = phi_2638_;
                                                            if _e448 {
                                                                phi_2657_ = vec3<f32>(_e951[2][0], _e951[2][1], _e951[2][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2656_ = vec3<f32>(_e951[2][2], _e951[2][0], _e951[2][1]);
                                                                } else {
                                                                    phi_2656_ = vec3<f32>(_e951[2][1], _e951[2][2], _e951[2][0]);
                                                                }
                                                                let _e1449 = phi_2656_;
                                                                phi_2657_ = _e1449;
                                                            }
                                                            let _e1452 = phi_2657_;
                                                            let _e1455 = (_e1444.x - _e1436.x);
                                                            let _e1458 = (_e1444.y - _e1436.y);
                                                            let _e1461 = (_e1444.z - _e1436.z);
                                                            let _e1463 = (_e1452.x - _e1436.x);
                                                            let _e1465 = (_e1452.y - _e1436.y);
                                                            let _e1467 = (_e1452.z - _e1436.z);
                                                            if (_e302.member_1 == 1u) {
                                                                phi_2693_ = (vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]) - _e1436);
                                                            } else {
                                                                phi_2693_ = vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]);
                                                            }
                                                            let _e1482 = phi_2693_;
                                                            let _e1488 = bitcast<f32>((bitcast<u32>((_e1455 * _e1465)) ^ _e302.member_3[0]));
                                                            let _e1492 = bitcast<f32>((bitcast<u32>((_e1458 * _e1463)) ^ _e302.member_3[0]));
                                                            let _e1496 = bitcast<f32>((bitcast<u32>((_e1458 * _e1467)) ^ _e302.member_3[0]));
                                                            let _e1500 = bitcast<f32>((bitcast<u32>((_e1461 * _e1465)) ^ _e302.member_3[0]));
                                                            let _e1504 = bitcast<f32>((bitcast<u32>((_e1461 * _e1463)) ^ _e302.member_3[0]));
                                                            let _e1508 = bitcast<f32>((bitcast<u32>((_e1455 * _e1467)) ^ _e302.member_3[0]));
                                                            let _e1509 = (_e1496 - _e1500);
                                                            let _e1510 = (_e1504 - _e1508);
                                                            let _e1511 = (_e1488 - _e1492);
                                                            let _e1535 = (bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u)));
                                                            let _e1542 = (bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u)));
                                                            let _e1549 = (bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1492) & 2147483647u)));
                                                            if (_e302.member_2 == 0f) {
                                                                phi_2875_ = 0f;
                                                            } else {
                                                                let _e1579 = bitcast<f32>((bitcast<u32>(_e1509) & 2147483647u));
                                                                let _e1582 = bitcast<f32>((bitcast<u32>(_e1510) & 2147483647u));
                                                                let _e1585 = bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u));
                                                                let _e1587 = select(_e1585, _e1582, (_e1582 > _e1585));
                                                                let _e1591 = select(_e1585, _e1582, (_e1582 < _e1585));
                                                                let _e1595 = select(_e1582, _e1579, (_e1579 < _e1582));
                                                                let _e1597 = select(_e1582, _e1579, (_e1579 > _e1582));
                                                                let _e1599 = select(_e1585, _e1597, (_e1597 < _e1585));
                                                                phi_2875_ = bitcast<f32>((bitcast<u32>((_e302.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1587, _e1579, (_e1579 > _e1587)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1599, _e1595, (_e1595 > _e1599)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1591, _e1579, (_e1579 < _e1591)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1535 + _e1542) + _e1549))) ^ _e302.member_3[0]))) * 1.0000005f)) ^ _e302.member_3[0])))) ^ _e302.member_3[0]));
                                                            }
                                                            let _e1626 = phi_2875_;
                                                            phi_2893_ = (_e1428 || !(((((bitcast<f32>((bitcast<u32>((_e1482.x * _e1509)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1482.y * _e1510)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1482.z * _e1511)) ^ _e302.member_3[0]))) * f32(-(_e1427))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1482.x) & 2147483647u)) * _e1535)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1482.y) & 2147483647u)) * _e1542)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1482.z) & 2147483647u)) * _e1549)) ^ _e302.member_3[0]))))) ^ _e302.member_3[0])) + _e1626) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1640 = phi_2893_;
                                                        phi_2894_ = _e1640;
                                                    }
                                                    let _e1642 = phi_2894_;
                                                    if _e1642 {
                                                        if (_e1414.member < _e855.member.member) {
                                                            phi_2914_ = true;
                                                        } else {
                                                            if (_e1414.member == _e855.member.member) {
                                                                phi_2913_ = (_e1414.member_3 < _e855.member.member_3);
                                                            } else {
                                                                phi_2913_ = false;
                                                            }
                                                            let _e1652 = phi_2913_;
                                                            phi_2914_ = _e1652;
                                                        }
                                                        let _e1654 = phi_2914_;
                                                        if _e1654 {
                                                            phi_2920_ = type_44(_e1414, _e1414.member);
                                                        } else {
                                                            phi_2920_ = _e855;
                                                        }
                                                        let _e1657 = phi_2920_;
                                                        phi_2921_ = _e1657;
                                                    } else {
                                                        phi_2921_ = _e855;
                                                    }
                                                    let _e1659 = phi_2921_;
                                                    phi_2922_ = _e1659;
                                                } else {
                                                    phi_2922_ = _e855;
                                                }
                                                let _e1661 = phi_2922_;
                                                phi_1522_ = _e1661;
                                            } else {
                                                phi_1522_ = type_44();
                                            }
                                            let _e1663 = phi_1522_;
                                            continue;
                                            continuing {
                                                phi_1521_ = _e1663;
                                                phi_1524_ = _e870;
                                                phi_4607_ = _e799;
                                                break if !(_e876);
                                            }
                                        }
                                        let _e1666 = phi_4607_;
                                        phi_4799_ = _e1666;
                                        if _e1666 {
                                            break;
                                        }
                                        phi_4885_ = _e1666;
                                        let _e2441 = local_11;
                                        phi_2923_ = _e2441;
                                    } else {
                                        phi_4885_ = _e799;
                                        phi_2923_ = _e801;
                                    }
                                    let _e1668 = phi_4885_;
                                    let _e1670 = phi_2923_;
                                    if _e848 {
                                        phi_4153_ = bool();
                                        phi_4154_ = u32();
                                        phi_4155_ = type_62();
                                    } else {
                                        if (_e844.member_1 >= _e103) {
                                            phi_3689_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e844.member_1 < _e103) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1673 = (_e424 * 2u);
                                            let _e1675 = ((1u + _e1673) % 7u);
                                            if (_e1675 < 7u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1680 = global_10.member[_e844.member_1][_e1675];
                                            let _e1682 = ((_e1673 + 2u) % 7u);
                                            if (_e1682 < 7u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1687 = global_10.member[_e844.member_1][_e1682];
                                            let _e1688 = (_e423 * 2u);
                                            let _e1690 = ((1u + _e1688) % 7u);
                                            if (_e1690 < 7u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1695 = global_10.member[_e844.member_1][_e1690];
                                            let _e1697 = ((_e1688 + 2u) % 7u);
                                            if (_e1697 < 7u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1702 = global_10.member[_e844.member_1][_e1697];
                                            let _e1703 = (_e425 * 2u);
                                            let _e1705 = ((1u + _e1703) % 7u);
                                            if (_e1705 < 7u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1710 = global_10.member[_e844.member_1][_e1705];
                                            let _e1712 = ((_e1703 + 2u) % 7u);
                                            if (_e1712 < 7u) {
                                            } else {
                                                phi_4799_ = true;
                                                break;
                                            }
                                            let _e1717 = global_10.member[_e844.member_1][_e1712];
                                            let _e1740 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.x - _e844.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1741 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.y - _e844.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1742 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.z - _e844.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1744 = select(_e161, _e1740, (_e1740 > _e161));
                                            let _e1746 = select(_e161, _e1741, (_e1741 > _e161));
                                            let _e1748 = select(_e161, _e1742, (_e1742 > _e161));
                                            let _e1779 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1680 & 2097151u))) - 8388608f) * _e1744));
                                            let _e1784 = (bitcast<i32>((_e1680 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1787 = bitcast<f32>((_e1779 & bitcast<u32>(_e1784)));
                                            let _e1788 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1695 & 2097151u))) - 8388608f) * _e1746));
                                            let _e1793 = (bitcast<i32>((_e1695 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1796 = bitcast<f32>((_e1788 & bitcast<u32>(_e1793)));
                                            let _e1797 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1710 & 2097151u))) - 8388608f) * _e1748));
                                            let _e1802 = (bitcast<i32>((_e1710 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1805 = bitcast<f32>((_e1797 & bitcast<u32>(_e1802)));
                                            let _e1809 = bitcast<f32>((_e1779 & bitcast<u32>(~(_e1784))));
                                            let _e1813 = bitcast<f32>((_e1788 & bitcast<u32>(~(_e1793))));
                                            let _e1817 = bitcast<f32>((_e1797 & bitcast<u32>(~(_e1802))));
                                            let _e1818 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1687 & 2097151u))) - 8388608f) * _e1744));
                                            let _e1823 = (bitcast<i32>((_e1687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1826 = bitcast<f32>((_e1818 & bitcast<u32>(_e1823)));
                                            let _e1827 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1702 & 2097151u))) - 8388608f) * _e1746));
                                            let _e1832 = (bitcast<i32>((_e1702 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1835 = bitcast<f32>((_e1827 & bitcast<u32>(_e1832)));
                                            let _e1836 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1717 & 2097151u))) - 8388608f) * _e1748));
                                            let _e1841 = (bitcast<i32>((_e1717 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1844 = bitcast<f32>((_e1836 & bitcast<u32>(_e1841)));
                                            let _e1848 = bitcast<f32>((_e1818 & bitcast<u32>(~(_e1823))));
                                            let _e1852 = bitcast<f32>((_e1827 & bitcast<u32>(~(_e1832))));
                                            let _e1856 = bitcast<f32>((_e1836 & bitcast<u32>(~(_e1841))));
                                            let _e1886 = global_10.member[_e844.member_1][0u];
                                            let _e1890 = global_10.member[_e844.member_1][2u];
                                            let _e1894 = global_10.member[_e844.member_1][4u];
                                            let _e1898 = global_10.member[_e844.member_1][6u];
                                            let _e1910 = (((_e1890 >> bitcast<u32>(22i)) | ((_e1894 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1898 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1911 = (_e1886 & 268435455u);
                                            let _e1912 = (_e1910 & 268435455u);
                                            let _e1915 = ((_e1886 >> bitcast<u32>(28u)) & 7u);
                                            let _e1923 = ((_e1886 >> bitcast<u32>(31i)) | (((_e1910 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1924 = (_e1915 != 0u);
                                            if (_e1915 == 0u) {
                                                phi_3651_ = _e1911;
                                            } else {
                                                if (_e1915 == 7u) {
                                                    phi_3650_ = 2147483648u;
                                                } else {
                                                    phi_3650_ = ((2147483648u | (_e1915 << bitcast<u32>(28u))) | (_e1912 & 268435455u));
                                                }
                                                let _e1933 = phi_3650_;
                                                phi_3651_ = _e1933;
                                            }
                                            let _e1935 = phi_3651_;
                                            if _e1924 {
                                                let _e1936 = (_e1915 != 7u);
                                                if _e1936 {
                                                    phi_3661_ = (_e1912 + _e1915);
                                                } else {
                                                    phi_3661_ = u32();
                                                }
                                                let _e1939 = phi_3661_;
                                                phi_3663_ = _e1939;
                                                phi_3664_ = select(true, false, _e1936);
                                            } else {
                                                phi_3663_ = u32();
                                                phi_3664_ = true;
                                            }
                                            let _e1942 = phi_3663_;
                                            let _e1944 = phi_3664_;
                                            if (_e1923 == 0u) {
                                                phi_3685_ = (_e1911 + select(0u, 1u, !(_e1924)));
                                            } else {
                                                if (_e1923 == 7u) {
                                                    phi_3684_ = 2147483648u;
                                                } else {
                                                    phi_3684_ = ((2147483648u | (_e1923 << bitcast<u32>(28u))) | (select(_e1942, _e1912, _e1944) & 268435455u));
                                                }
                                                let _e1957 = phi_3684_;
                                                phi_3685_ = _e1957;
                                            }
                                            let _e1959 = phi_3685_;
                                            phi_3689_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e844.member.member.x + _e1787), (_e844.member.member.x + _e1809), (_e844.member.member_1.x - _e1826), (_e844.member.member_1.x - _e1848)), vec4<f32>((_e844.member.member.y + _e1796), (_e844.member.member.y + _e1813), (_e844.member.member_1.y - _e1835), (_e844.member.member_1.y - _e1852)), vec4<f32>((_e844.member.member.z + _e1805), (_e844.member.member.z + _e1817), (_e844.member.member_1.z - _e1844), (_e844.member.member_1.z - _e1856))), type_62(type_38((_e844.member.member + vec4<f32>(_e1787, _e1796, _e1805, 0f)), (_e844.member.member_1 - vec4<f32>(_e1826, _e1835, _e1844, 0f))), _e1935), type_62(type_38((_e844.member.member + vec4<f32>(_e1809, _e1813, _e1817, 0f)), (_e844.member.member_1 - vec4<f32>(_e1848, _e1852, _e1856, 0f))), _e1959));
                                        }
                                        let _e1964 = phi_3689_;
                                        let _e1976 = ((_e1964.member[0].x - _e509) * _e514);
                                        let _e1977 = ((_e1964.member[0].y - _e509) * _e514);
                                        let _e1978 = ((_e1964.member[0].z - _e510) * _e514);
                                        let _e1979 = ((_e1964.member[0].w - _e510) * _e514);
                                        let _e1989 = ((_e1964.member[1].x - _e575) * _e580);
                                        let _e1990 = ((_e1964.member[1].y - _e575) * _e580);
                                        let _e1991 = ((_e1964.member[1].z - _e576) * _e580);
                                        let _e1992 = ((_e1964.member[1].w - _e576) * _e580);
                                        let _e2002 = ((_e1964.member[2].x - _e641) * _e646);
                                        let _e2003 = ((_e1964.member[2].y - _e641) * _e646);
                                        let _e2004 = ((_e1964.member[2].z - _e642) * _e646);
                                        let _e2005 = ((_e1964.member[2].w - _e642) * _e646);
                                        let _e2007 = select(_e2004, _e2002, (_e2002 < _e2004));
                                        let _e2009 = select(_e2005, _e2003, (_e2003 < _e2005));
                                        let _e2011 = select(_e2004, _e2002, (_e2002 > _e2004));
                                        let _e2013 = select(_e2005, _e2003, (_e2003 > _e2005));
                                        let _e2015 = select(_e1978, _e1976, (_e1976 < _e1978));
                                        let _e2017 = select(_e1979, _e1977, (_e1977 < _e1979));
                                        let _e2019 = select(_e1991, _e1989, (_e1989 < _e1991));
                                        let _e2021 = select(_e1992, _e1990, (_e1990 < _e1992));
                                        let _e2023 = select(_e2019, _e2015, (_e2015 > _e2019));
                                        let _e2025 = select(_e2021, _e2017, (_e2017 > _e2021));
                                        let _e2027 = select(_e2007, _e2023, (_e2023 > _e2007));
                                        let _e2029 = select(_e2009, _e2025, (_e2025 > _e2009));
                                        let _e2031 = select(_e1978, _e1976, (_e1976 > _e1978));
                                        let _e2033 = select(_e1979, _e1977, (_e1977 > _e1979));
                                        let _e2035 = select(_e1991, _e1989, (_e1989 > _e1991));
                                        let _e2037 = select(_e1992, _e1990, (_e1990 > _e1992));
                                        let _e2039 = select(_e2035, _e2031, (_e2031 < _e2035));
                                        let _e2041 = select(_e2037, _e2033, (_e2033 < _e2037));
                                        let _e2046 = -(_e2007);
                                        let _e2047 = -(_e2009);
                                        let _e2054 = (select(_e2011, _e2039, (_e2039 < _e2011)) + (select(_e2046, _e2011, (_e2011 > _e2046)) * 0.0000019073523f));
                                        let _e2055 = (select(_e2013, _e2041, (_e2041 < _e2013)) + (select(_e2047, _e2013, (_e2013 > _e2047)) * 0.0000019073523f));
                                        let _e2057 = select(_e757, _e2027, (_e2027 > _e757));
                                        let _e2059 = select(_e757, _e2029, (_e2029 > _e757));
                                        let _e2064 = (_e2057 <= select(_e1670.member_1, _e2054, (_e2054 < _e1670.member_1)));
                                        let _e2065 = (_e2059 <= select(_e1670.member_1, _e2055, (_e2055 < _e1670.member_1)));
                                        let _e2066 = (_e2057 <= _e2059);
                                        if _e2064 {
                                            if _e2065 {
                                                if _e2066 {
                                                    phi_4051_ = _e1964.member_2;
                                                } else {
                                                    phi_4051_ = _e1964.member_1;
                                                }
                                                let _e2070 = phi_4051_;
                                                let _e2091 = (_e842 % 128u);
                                                let _e2092 = (_e2091 < 128u);
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_8[_e2091] = _e2070.member_1;
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_7[_e2091] = _e2070.member.member.x;
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_6[_e2091] = _e2070.member.member.y;
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_5[_e2091] = _e2070.member.member.z;
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_4[_e2091] = _e2070.member.member_1.x;
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_3[_e2091] = _e2070.member.member_1.y;
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_2[_e2091] = _e2070.member.member_1.z;
                                                if _e2092 {
                                                } else {
                                                    phi_4799_ = true;
                                                    break;
                                                }
                                                local_9[_e2091] = select(_e2057, _e2059, _e2066);
                                                if _e2066 {
                                                    phi_4127_ = _e1964.member_1;
                                                } else {
                                                    phi_4127_ = _e1964.member_2;
                                                }
                                                let _e2105 = phi_4127_;
                                                phi_4128_ = (_e842 + 1u);
                                                phi_4129_ = _e2105;
                                            } else {
                                                phi_4128_ = u32();
                                                phi_4129_ = type_62();
                                            }
                                            let _e2107 = phi_4128_;
                                            let _e2109 = phi_4129_;
                                            phi_4131_ = _e2107;
                                            phi_4132_ = _e2109;
                                            phi_4133_ = select(true, false, _e2065);
                                        } else {
                                            phi_4131_ = u32();
                                            phi_4132_ = type_62();
                                            phi_4133_ = true;
                                        }
                                        let _e2112 = phi_4131_;
                                        let _e2114 = phi_4132_;
                                        let _e2116 = phi_4133_;
                                        if _e2116 {
                                            if _e2064 {
                                                phi_4142_ = _e1964.member_1;
                                            } else {
                                                phi_4142_ = _e1964.member_2;
                                            }
                                            let _e2120 = phi_4142_;
                                            phi_4147_ = select(_e2065, true, _e2064);
                                            phi_4149_ = _e2120;
                                        } else {
                                            phi_4147_ = _e840;
                                            phi_4149_ = _e2114;
                                        }
                                        let _e2123 = phi_4147_;
                                        let _e2125 = phi_4149_;
                                        phi_4153_ = _e2123;
                                        phi_4154_ = select(_e2112, _e842, _e2116);
                                        phi_4155_ = _e2125;
                                    }
                                    let _e2128 = phi_4153_;
                                    let _e2130 = phi_4154_;
                                    let _e2132 = phi_4155_;
                                    if _e848 {
                                        phi_4165_ = _e844;
                                    } else {
                                        phi_4165_ = _e2132;
                                    }
                                    let _e2134 = phi_4165_;
                                    phi_4802_ = _e1668;
                                    phi_4166_ = _e1670;
                                    phi_4167_ = (_e803 - 1u);
                                    phi_4168_ = select(_e2128, false, _e848);
                                    phi_4169_ = select(_e2130, _e842, _e848);
                                    phi_4170_ = _e2134;
                                } else {
                                    phi_4802_ = _e799;
                                    phi_4166_ = _e801;
                                    phi_4167_ = _e803;
                                    phi_4168_ = _e840;
                                    phi_4169_ = _e842;
                                    phi_4170_ = _e844;
                                }
                                let _e2138 = phi_4802_;
                                let _e2140 = phi_4166_;
                                let _e2142 = phi_4167_;
                                let _e2144 = phi_4168_;
                                let _e2146 = phi_4169_;
                                let _e2148 = phi_4170_;
                                phi_4801_ = _e2138;
                                phi_4171_ = _e2140;
                                phi_4172_ = _e2142;
                                phi_4173_ = _e2144;
                                phi_4174_ = _e2146;
                                phi_4175_ = _e2148;
                            } else {
                                phi_4801_ = _e799;
                                phi_4171_ = type_44();
                                phi_4172_ = u32();
                                phi_4173_ = bool();
                                phi_4174_ = u32();
                                phi_4175_ = type_62();
                            }
                            let _e2150 = phi_4801_;
                            let _e2152 = phi_4171_;
                            let _e2154 = phi_4172_;
                            let _e2156 = phi_4173_;
                            let _e2158 = phi_4174_;
                            let _e2160 = phi_4175_;
                            phi_4800_ = _e2150;
                            phi_1396_ = _e2152;
                            phi_1399_ = _e2154;
                            phi_1401_ = _e2156;
                            phi_1403_ = _e2158;
                            phi_1405_ = _e2160;
                            phi_4176_ = _e813;
                        } else {
                            phi_4800_ = _e799;
                            phi_1396_ = type_44();
                            phi_1399_ = u32();
                            phi_1401_ = bool();
                            phi_1403_ = u32();
                            phi_1405_ = type_62();
                            phi_4176_ = false;
                        }
                        let _e2162 = phi_4800_;
                        let _e2164 = phi_1396_;
                        let _e2166 = phi_1399_;
                        let _e2168 = phi_1401_;
                        let _e2170 = phi_1403_;
                        let _e2172 = phi_1405_;
                        let _e2174 = phi_4176_;
                        continue;
                        continuing {
                            phi_4613_ = _e2162;
                            phi_1395_ = _e2164;
                            phi_1398_ = _e2166;
                            phi_1400_ = _e2168;
                            phi_1402_ = _e2170;
                            phi_1404_ = _e2172;
                            phi_4799_ = _e2162;
                            break if !(_e2174);
                        }
                    }
                    let _e2177 = phi_4799_;
                    if _e2177 {
                        break;
                    }
                    let _e2179 = local_10;
                    if (_e2179.member.member_3 != 4294967295u) {
                        let _e2184 = bitcast<u32>(_e2179.member.member);
                        let _e2188 = (bitcast<i32>((_e2184 >> bitcast<u32>(23i))) & 255i);
                        let _e2189 = (_e2188 + _e426);
                        if (_e2188 == 255i) {
                            phi_4235_ = _e2179.member.member;
                        } else {
                            if (_e2188 > 0i) {
                                if (_e2189 > 0i) {
                                    let _e2193 = (_e2189 < 255i);
                                    if _e2193 {
                                        phi_4214_ = bitcast<f32>((_e2184 + bitcast<u32>((_e426 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4214_ = f32();
                                    }
                                    let _e2200 = phi_4214_;
                                    phi_4216_ = _e2200;
                                    phi_4217_ = select(true, false, _e2193);
                                } else {
                                    phi_4216_ = f32();
                                    phi_4217_ = true;
                                }
                                let _e2203 = phi_4216_;
                                let _e2205 = phi_4217_;
                                phi_4218_ = _e2203;
                                phi_4219_ = _e2205;
                            } else {
                                phi_4218_ = f32();
                                phi_4219_ = true;
                            }
                            let _e2207 = phi_4218_;
                            let _e2209 = phi_4219_;
                            if _e2209 {
                                let _e2210 = (_e2184 & 2147483648u);
                                let _e2217 = ((_e2184 & 8388607u) | (select(0u, 1u, ((_e2184 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2221 = (_e2217 == 0u);
                                if _e2221 {
                                    phi_4565_ = bitcast<f32>(_e2210);
                                } else {
                                    let _e2226 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2217)), 32u, _e2221) - 8u);
                                    let _e2229 = (_e2217 << bitcast<u32>((_e2226 & 31u)));
                                    let _e2231 = ((_e2189 + select(0i, 1i, (_e2188 == 0i))) - bitcast<i32>(_e2226));
                                    if (_e2231 >= 255i) {
                                        phi_4555_ = bitcast<f32>((_e2210 | 2139095040u));
                                        phi_4556_ = f32();
                                        phi_4557_ = true;
                                    } else {
                                        let _e2233 = (_e2231 > 0i);
                                        if _e2233 {
                                            phi_4549_ = bitcast<f32>(((_e2210 | (bitcast<u32>(_e2231) << bitcast<u32>(23i))) | (_e2229 & 8388607u)));
                                            phi_4550_ = f32();
                                        } else {
                                            if (_e2231 < -24i) {
                                                phi_4515_ = 26u;
                                            } else {
                                                phi_4515_ = bitcast<u32>((1i - _e2231));
                                            }
                                            let _e2238 = phi_4515_;
                                            let _e2239 = (_e2238 & 31u);
                                            let _e2241 = (_e2229 >> bitcast<u32>(_e2239));
                                            let _e2245 = (_e2229 & ((1u << bitcast<u32>(_e2239)) - 1u));
                                            let _e2249 = (1u << bitcast<u32>(((_e2238 - 1u) & 31u)));
                                            if (_e2245 > _e2249) {
                                                phi_4536_ = true;
                                            } else {
                                                if (_e2245 == _e2249) {
                                                    phi_4533_ = ((_e2241 & 1u) == 1u);
                                                } else {
                                                    phi_4533_ = false;
                                                }
                                                let _e2255 = phi_4533_;
                                                phi_4536_ = _e2255;
                                            }
                                            let _e2257 = phi_4536_;
                                            phi_4549_ = f32();
                                            phi_4550_ = bitcast<f32>((_e2210 | (_e2241 + select(0u, 1u, _e2257))));
                                        }
                                        let _e2270 = phi_4549_;
                                        let _e2272 = phi_4550_;
                                        phi_4555_ = _e2270;
                                        phi_4556_ = _e2272;
                                        phi_4557_ = _e2233;
                                    }
                                    let _e2276 = phi_4555_;
                                    let _e2278 = phi_4556_;
                                    let _e2280 = phi_4557_;
                                    phi_4565_ = select(_e2278, _e2276, _e2280);
                                }
                                let _e2284 = phi_4565_;
                                phi_4234_ = _e2284;
                            } else {
                                phi_4234_ = _e2207;
                            }
                            let _e2286 = phi_4234_;
                            phi_4235_ = _e2286;
                        }
                        let _e2288 = phi_4235_;
                        let _e2289 = bitcast<u32>(_e2288);
                        if ((_e2289 & 2147483647u) >= 2139095040u) {
                            phi_4247_ = bitcast<f32>(((_e2289 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4247_ = _e2288;
                        }
                        let _e2296 = phi_4247_;
                        phi_4252_ = type_26(_e2296, _e2179.member.member_1, _e2179.member.member_2, _e2179.member.member_3);
                    } else {
                        phi_4252_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2301 = phi_4252_;
                    if _e303 {
                    } else {
                        break;
                    }
                    global_8.member[_e149] = _e2301;
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e2305 = select(0u, 1u, (_e370 <= _e380));
                    if (_e2305 > 0u) {
                        let _e2307 = (1u < _e117);
                        if _e2307 {
                            if (0u < _e117) {
                            } else {
                                break;
                            }
                            let _e2311 = atomicAdd((&global_9.member[0u]), _e2305);
                            if ((_e2311 + _e2305) < _e2311) {
                                if _e2307 {
                                } else {
                                    break;
                                }
                                let _e2316 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2319 = select(0u, 1u, (_e2301.member_3 != 4294967295u));
                    if (_e2319 > 0u) {
                        let _e2321 = (3u < _e117);
                        if _e2321 {
                            if (2u < _e117) {
                            } else {
                                break;
                            }
                            let _e2325 = atomicAdd((&global_9.member[2u]), _e2319);
                            if ((_e2325 + _e2319) < _e2325) {
                                if _e2321 {
                                } else {
                                    break;
                                }
                                let _e2330 = atomicAdd((&global_9.member[3u]), 1u);
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
