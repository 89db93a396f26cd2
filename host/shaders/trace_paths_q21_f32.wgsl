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

struct type_47 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
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
    member: type_38,
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
@group(0) @binding(1) 
var<uniform> global_2: type_49;
@group(0) @binding(2) 
var<uniform> global_3: type_49;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_52;
@group(0) @binding(7) 
var<storage> global_7: type_33;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_28;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(3) 
var<storage> global_10: type_58;

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
    var phi_620_: type_40;
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
    var phi_1415_: type_44;
    var phi_1418_: u32;
    var phi_1420_: bool;
    var phi_1422_: u32;
    var phi_1424_: type_63;
    var phi_1435_: bool;
    var phi_1521_: bool;
    var phi_1522_: u32;
    var phi_1523_: type_63;
    var phi_1541_: type_44;
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
    var phi_2457_: type_47;
    var phi_2458_: type_47;
    var phi_2461_: type_47;
    var phi_2462_: type_47;
    var phi_2463_: bool;
    var phi_2467_: type_47;
    var phi_2476_: type_26;
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
    var phi_2837_: type_44;
    var phi_2838_: type_44;
    var phi_2839_: type_44;
    var phi_1542_: type_44;
    var phi_4704_: bool;
    var phi_4987_: bool;
    var phi_2840_: type_44;
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
    var phi_4083_: type_44;
    var phi_4084_: u32;
    var phi_4085_: bool;
    var phi_4086_: u32;
    var phi_4087_: type_63;
    var phi_4903_: bool;
    var phi_4088_: type_44;
    var phi_4089_: u32;
    var phi_4090_: bool;
    var phi_4091_: u32;
    var phi_4092_: type_63;
    var phi_4902_: bool;
    var phi_1416_: type_44;
    var phi_1419_: u32;
    var phi_1421_: bool;
    var phi_1423_: u32;
    var phi_1425_: type_63;
    var phi_4093_: bool;
    var phi_4901_: bool;
    var local_10: type_44;
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
    var phi_4169_: type_26;
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
                phi_436_ = _e168;
            } else {
                phi_436_ = 4294967295u;
            }
            let _e170 = phi_436_;
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
                phi_480_ = -126i;
            } else {
                phi_480_ = select(_e213, 127i, (_e213 > 127i));
            }
            let _e218 = phi_480_;
            let _e223 = bitcast<f32>((bitcast<u32>((_e218 + 127i)) << bitcast<u32>(23i)));
            let _e229 = bitcast<f32>((bitcast<u32>(((_e213 - _e218) + 127i)) << bitcast<u32>(23i)));
            if (_e189 == 0u) {
                phi_620_ = type_40(array<f32, 3>(_e206, _e207, _e208), _e189, _e210, _e211);
            } else {
                let _e231 = bitcast<u32>(_e206);
                let _e233 = ((_e231 & 2139095040u) != 0u);
                let _e248 = bitcast<u32>(_e207);
                let _e250 = ((_e248 & 2139095040u) != 0u);
                let _e265 = bitcast<u32>(_e208);
                let _e267 = ((_e265 & 2139095040u) != 0u);
                let _e283 = bitcast<u32>(_e210);
                let _e285 = ((_e283 & 2139095040u) != 0u);
                phi_620_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e231 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e231 & 2147483648u))), _e206, _e233) * _e223) * select(0.00000011920929f, 1f, _e233)) * _e229), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e207, _e250) * _e223) * select(0.00000011920929f, 1f, _e250)) * _e229), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e265 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e265 & 2147483648u))), _e208, _e267) * _e223) * select(0.00000011920929f, 1f, _e267)) * _e229)), _e189, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e283 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e283 & 2147483648u))), _e210, _e285) * _e223) * select(0.00000011920929f, 1f, _e285)) * _e229), _e211);
            }
            let _e302 = phi_620_;
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
                            phi_726_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_726_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                        }
                        let _e403 = phi_726_;
                        phi_727_ = _e403;
                    } else {
                        phi_727_ = 0i;
                    }
                    let _e405 = phi_727_;
                    let _e406 = (_e315 == _e359);
                    if _e406 {
                        phi_737_ = true;
                    } else {
                        phi_737_ = (_e323 == _e359);
                    }
                    let _e409 = phi_737_;
                    let _e410 = select(1u, 0u, _e406);
                    if _e409 {
                        let _e411 = (_e410 + 1u);
                        phi_747_ = _e411;
                        phi_748_ = _e411;
                        phi_750_ = select(true, false, (_e411 == 2u));
                    } else {
                        phi_747_ = u32();
                        phi_748_ = 0u;
                        phi_750_ = true;
                    }
                    let _e415 = phi_747_;
                    let _e417 = phi_748_;
                    let _e419 = phi_750_;
                    if _e419 {
                        phi_755_ = (_e417 + 1u);
                    } else {
                        phi_755_ = 0u;
                    }
                    let _e423 = phi_755_;
                    let _e424 = select(_e415, _e417, _e419);
                    let _e425 = select(_e410, select(2u, _e410, _e409), _e419);
                    let _e426 = -(_e405);
                    if (_e426 < -126i) {
                        phi_788_ = -126i;
                    } else {
                        phi_788_ = select(_e426, 127i, (_e426 > 127i));
                    }
                    let _e431 = phi_788_;
                    let _e436 = bitcast<f32>((bitcast<u32>((_e431 + 127i)) << bitcast<u32>(23i)));
                    let _e442 = bitcast<f32>((bitcast<u32>(((_e426 - _e431) + 127i)) << bitcast<u32>(23i)));
                    let _e447 = global_7.member[_e149].member.member;
                    let _e448 = (_e424 == 0u);
                    if _e448 {
                        phi_806_ = _e447[0];
                    } else {
                        phi_806_ = _e447[1];
                    }
                    let _e452 = phi_806_;
                    let _e453 = (_e424 == 2u);
                    if _e453 {
                        phi_812_ = _e447[2];
                    } else {
                        phi_812_ = _e452;
                    }
                    let _e456 = phi_812_;
                    let _e457 = bitcast<u32>(_e456);
                    let _e459 = ((_e457 & 2139095040u) != 0u);
                    let _e471 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e457 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e457 & 2147483648u))), _e456, _e459) * select(0.00000011920929f, 1f, _e459));
                    let _e472 = global_7.member[_e149].member.member_2;
                    if _e448 {
                        phi_852_ = _e472[0];
                    } else {
                        phi_852_ = _e472[1];
                    }
                    let _e476 = phi_852_;
                    if _e453 {
                        phi_858_ = _e472[2];
                    } else {
                        phi_858_ = _e476;
                    }
                    let _e479 = phi_858_;
                    let _e480 = bitcast<u32>(_e479);
                    let _e482 = ((_e480 & 2139095040u) != 0u);
                    let _e496 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e480 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e480 & 2147483648u))), _e479, _e482) * _e436) * select(0.00000011920929f, 1f, _e482)) * _e442);
                    let _e500 = (bitcast<f32>((bitcast<u32>(_e496) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e503 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                    let _e504 = (_e503 * 0.00000011920929f);
                    let _e507 = select(select(0.00000000000011368684f, _e504, (_e504 > 0.00000000000011368684f)), 0f, _e500);
                    let _e508 = select(0f, _e496, _e500);
                    let _e509 = (_e471 + _e507);
                    let _e510 = (_e471 - _e507);
                    let _e512 = select(38685626000000000000000000f, (1f / _e496), _e500);
                    let _e513 = (_e423 == 0u);
                    if _e513 {
                        phi_931_ = _e447[0];
                    } else {
                        phi_931_ = _e447[1];
                    }
                    let _e517 = phi_931_;
                    let _e518 = (_e423 == 2u);
                    if _e518 {
                        phi_937_ = _e447[2];
                    } else {
                        phi_937_ = _e517;
                    }
                    let _e521 = phi_937_;
                    let _e522 = bitcast<u32>(_e521);
                    let _e524 = ((_e522 & 2139095040u) != 0u);
                    let _e536 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e522 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e522 & 2147483648u))), _e521, _e524) * select(0.00000011920929f, 1f, _e524));
                    if _e513 {
                        phi_977_ = _e472[0];
                    } else {
                        phi_977_ = _e472[1];
                    }
                    let _e540 = phi_977_;
                    if _e518 {
                        phi_983_ = _e472[2];
                    } else {
                        phi_983_ = _e540;
                    }
                    let _e543 = phi_983_;
                    let _e544 = bitcast<u32>(_e543);
                    let _e546 = ((_e544 & 2139095040u) != 0u);
                    let _e560 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e544 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e544 & 2147483648u))), _e543, _e546) * _e436) * select(0.00000011920929f, 1f, _e546)) * _e442);
                    let _e564 = (bitcast<f32>((bitcast<u32>(_e560) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e567 = bitcast<f32>((bitcast<u32>(_e536) & 2147483647u));
                    let _e568 = (_e567 * 0.00000011920929f);
                    let _e571 = select(select(0.00000000000011368684f, _e568, (_e568 > 0.00000000000011368684f)), 0f, _e564);
                    let _e572 = select(0f, _e560, _e564);
                    let _e573 = (_e536 + _e571);
                    let _e574 = (_e536 - _e571);
                    let _e576 = select(38685626000000000000000000f, (1f / _e560), _e564);
                    let _e577 = (_e425 == 0u);
                    if _e577 {
                        phi_1056_ = _e447[0];
                    } else {
                        phi_1056_ = _e447[1];
                    }
                    let _e581 = phi_1056_;
                    let _e582 = (_e425 == 2u);
                    if _e582 {
                        phi_1062_ = _e447[2];
                    } else {
                        phi_1062_ = _e581;
                    }
                    let _e585 = phi_1062_;
                    let _e586 = bitcast<u32>(_e585);
                    let _e588 = ((_e586 & 2139095040u) != 0u);
                    let _e600 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e586 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e586 & 2147483648u))), _e585, _e588) * select(0.00000011920929f, 1f, _e588));
                    if _e577 {
                        phi_1102_ = _e472[0];
                    } else {
                        phi_1102_ = _e472[1];
                    }
                    let _e604 = phi_1102_;
                    if _e582 {
                        phi_1108_ = _e472[2];
                    } else {
                        phi_1108_ = _e604;
                    }
                    let _e607 = phi_1108_;
                    let _e608 = bitcast<u32>(_e607);
                    let _e610 = ((_e608 & 2139095040u) != 0u);
                    let _e624 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e608 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e608 & 2147483648u))), _e607, _e610) * _e436) * select(0.00000011920929f, 1f, _e610)) * _e442);
                    let _e628 = (bitcast<f32>((bitcast<u32>(_e624) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e631 = bitcast<f32>((bitcast<u32>(_e600) & 2147483647u));
                    let _e632 = (_e631 * 0.00000011920929f);
                    let _e635 = select(select(0.00000000000011368684f, _e632, (_e632 > 0.00000000000011368684f)), 0f, _e628);
                    let _e636 = select(0f, _e624, _e628);
                    let _e637 = (_e600 + _e635);
                    let _e638 = (_e600 - _e635);
                    let _e640 = select(38685626000000000000000000f, (1f / _e624), _e628);
                    let _e642 = select(_e567, _e503, (_e503 > _e567));
                    if (_e386 && (select(_e631, _e642, (_e642 > _e631)) <= 1099511600000f)) {
                        let _e654 = ((_e372 & 8388607u) | (select(0u, 1u, ((_e372 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e657 = bitcast<i32>((_e372 >> bitcast<u32>(23i)));
                        let _e661 = (_e654 == 0u);
                        let _e664 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e654)), 32u, _e661)) - 8i);
                        if (_e657 == 255i) {
                            phi_1227_ = 255i;
                        } else {
                            phi_1227_ = (((_e657 + select(0i, 1i, (_e657 == 0i))) - _e664) + _e405);
                        }
                        let _e672 = phi_1227_;
                        let _e682 = (_e672 <= 0i);
                        if _e682 {
                            phi_1250_ = u32();
                        } else {
                            if _e661 {
                                phi_1249_ = u32();
                            } else {
                                phi_1249_ = select(((bitcast<u32>(_e672) << bitcast<u32>(23i)) | ((_e654 << bitcast<u32>(((_e664 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e672 >= 255i));
                            }
                            let _e686 = phi_1249_;
                            phi_1250_ = _e686;
                        }
                        let _e688 = phi_1250_;
                        let _e700 = ((_e382 & 8388607u) | (select(0u, 1u, ((_e382 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e703 = bitcast<i32>((_e382 >> bitcast<u32>(23i)));
                        let _e707 = (_e700 == 0u);
                        let _e710 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e700)), 32u, _e707)) - 8i);
                        if (_e703 == 255i) {
                            phi_1287_ = 255i;
                        } else {
                            phi_1287_ = (((_e703 + select(0i, 1i, (_e703 == 0i))) - _e710) + _e405);
                        }
                        let _e718 = phi_1287_;
                        let _e728 = (_e718 <= 0i);
                        if _e728 {
                            phi_1310_ = u32();
                        } else {
                            if _e707 {
                                phi_1309_ = u32();
                            } else {
                                phi_1309_ = select(((bitcast<u32>(_e718) << bitcast<u32>(23i)) | ((_e700 << bitcast<u32>(((_e710 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e718 >= 255i));
                            }
                            let _e732 = phi_1309_;
                            phi_1310_ = _e732;
                        }
                        let _e734 = phi_1310_;
                        phi_1318_ = bitcast<f32>(((_e381 & 2147483648u) | select(_e734, 0u, select(_e707, true, _e728))));
                        phi_1319_ = bitcast<f32>(((_e371 & 2147483648u) | select(_e688, 0u, select(_e661, true, _e682))));
                    } else {
                        phi_1318_ = 0f;
                        phi_1319_ = 1f;
                    }
                    let _e740 = phi_1318_;
                    let _e742 = phi_1319_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e746 = (_e424 % 3u);
                    let _e747 = (_e746 < 3u);
                    if _e747 {
                    } else {
                        break;
                    }
                    let _e749 = local_1[_e746];
                    let _e752 = (_e423 % 3u);
                    let _e753 = (_e752 < 3u);
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e755 = local_1[_e752];
                    let _e758 = (_e425 % 3u);
                    let _e759 = (_e758 < 3u);
                    if _e759 {
                    } else {
                        break;
                    }
                    let _e761 = local_1[_e758];
                    if _e747 {
                    } else {
                        break;
                    }
                    let _e766 = local[_e746];
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e770 = local[_e752];
                    if _e759 {
                    } else {
                        break;
                    }
                    let _e774 = local[_e758];
                    phi_4710_ = false;
                    phi_1415_ = type_44(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e740);
                    phi_1418_ = ((3u * _e103) + 1u);
                    phi_1420_ = (_e742 <= _e740);
                    phi_1422_ = 0u;
                    phi_1424_ = type_63(type_38(vec4<f32>((f32(_e749) * _e161), (f32(_e755) * _e161), (f32(_e761) * _e161), 0f), vec4<f32>((f32(_e766) * _e161), (f32(_e770) * _e161), (f32(_e774) * _e161), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    loop {
                        let _e784 = phi_4710_;
                        let _e786 = phi_1415_;
                        let _e788 = phi_1418_;
                        let _e790 = phi_1420_;
                        let _e792 = phi_1422_;
                        let _e794 = phi_1424_;
                        local_10 = _e786;
                        if _e790 {
                            phi_1435_ = true;
                        } else {
                            phi_1435_ = (_e792 > 0u);
                        }
                        let _e797 = phi_1435_;
                        if _e797 {
                            let _e798 = (_e788 > 0u);
                            if _e798 {
                                if _e790 {
                                    phi_1521_ = _e790;
                                    phi_1522_ = _e792;
                                    phi_1523_ = _e794;
                                } else {
                                    let _e799 = (_e792 - 1u);
                                    let _e800 = (_e799 % 128u);
                                    let _e801 = (_e800 < 128u);
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e803 = local_7[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e805 = local_6[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e807 = local_5[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e809 = local_4[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e811 = local_3[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e813 = local_2[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e818 = local_8[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4901_ = true;
                                        break;
                                    }
                                    let _e821 = local_9[_e800];
                                    phi_1521_ = (_e821 <= _e786.member_1);
                                    phi_1522_ = _e799;
                                    phi_1523_ = type_63(type_38(vec4<f32>(_e803, _e805, _e807, 0f), vec4<f32>(_e809, _e811, _e813, 0f)), _e818);
                                }
                                let _e825 = phi_1521_;
                                let _e827 = phi_1522_;
                                let _e829 = phi_1523_;
                                if _e825 {
                                    let _e833 = ((_e829.member_1 & 2147483648u) != 0u);
                                    if _e833 {
                                        phi_1541_ = _e786;
                                        phi_1544_ = type_8(0u, ((_e829.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e840 = phi_1541_;
                                            let _e842 = phi_1544_;
                                            local_11 = _e840;
                                            if (_e842.member < _e842.member_1) {
                                                phi_1545_ = type_8((_e842.member + 1u), _e842.member_1);
                                                phi_1567_ = type_8(1u, _e842.member);
                                            } else {
                                                phi_1545_ = _e842;
                                                phi_1567_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e855 = phi_1545_;
                                            let _e857 = phi_1567_;
                                            let _e861 = (bitcast<i32>(_e857.member) != 0i);
                                            if _e861 {
                                                let _e862 = ((_e829.member_1 & 268435455u) + _e857.member_1);
                                                let _e863 = (_e862 < _e105);
                                                if _e863 {
                                                    if _e863 {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e867 = global_4.member[_e862].member_1;
                                                    phi_1588_ = _e867;
                                                } else {
                                                    phi_1588_ = 4294967295u;
                                                }
                                                let _e869 = phi_1588_;
                                                if (_e862 >= _e105) {
                                                    phi_1680_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e863 {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    if (_e746 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e876 = global_4.member[_e862].member[_e746];
                                                    if (_e752 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e882 = global_4.member[_e862].member[_e752];
                                                    if (_e758 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e888 = global_4.member[_e862].member[_e758];
                                                    let _e890 = (3u + _e746);
                                                    if (_e890 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e896 = global_4.member[_e862].member[_e890];
                                                    let _e897 = (3u + _e752);
                                                    if (_e897 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e903 = global_4.member[_e862].member[_e897];
                                                    let _e904 = (3u + _e758);
                                                    if (_e904 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e910 = global_4.member[_e862].member[_e904];
                                                    let _e912 = (6u + _e746);
                                                    if (_e912 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e918 = global_4.member[_e862].member[_e912];
                                                    let _e919 = (6u + _e752);
                                                    if (_e919 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e925 = global_4.member[_e862].member[_e919];
                                                    let _e926 = (6u + _e758);
                                                    if (_e926 < 9u) {
                                                    } else {
                                                        phi_4704_ = true;
                                                        break;
                                                    }
                                                    let _e932 = global_4.member[_e862].member[_e926];
                                                    phi_1680_ = array<array<f32, 3>, 3>(array<f32, 3>(_e876, _e882, _e888), array<f32, 3>(_e896, _e903, _e910), array<f32, 3>(_e918, _e925, _e932));
                                                }
                                                let _e936 = phi_1680_;
                                                let _e952 = (_e936[0][2] - _e600);
                                                let _e955 = (((_e936[0][0] - _e471) * _e636) - (_e952 * _e508));
                                                let _e958 = (((_e936[0][1] - _e536) * _e636) - (_e952 * _e572));
                                                let _e961 = (_e936[1][2] - _e600);
                                                let _e964 = (((_e936[1][0] - _e471) * _e636) - (_e961 * _e508));
                                                let _e967 = (((_e936[1][1] - _e536) * _e636) - (_e961 * _e572));
                                                let _e970 = (_e936[2][2] - _e600);
                                                let _e973 = (((_e936[2][0] - _e471) * _e636) - (_e970 * _e508));
                                                let _e976 = (((_e936[2][1] - _e536) * _e636) - (_e970 * _e572));
                                                let _e977 = (_e973 * _e967);
                                                let _e978 = (_e976 * _e964);
                                                let _e979 = (_e955 * _e976);
                                                let _e980 = (_e958 * _e973);
                                                let _e981 = (_e964 * _e958);
                                                let _e982 = (_e967 * _e955);
                                                let _e987 = (((_e977 >= _e978) && (_e979 >= _e980)) && (_e981 >= _e982));
                                                let _e993 = (_e987 || (((_e977 <= _e978) && (_e979 <= _e980)) && (_e981 <= _e982)));
                                                if _e993 {
                                                    let _e995 = select(-1f, 1f, _e987);
                                                    let _e997 = ((_e977 - _e978) * _e995);
                                                    let _e999 = select(0f, _e997, (_e997 > 0f));
                                                    let _e1001 = ((_e979 - _e980) * _e995);
                                                    let _e1003 = select(0f, _e1001, (_e1001 > 0f));
                                                    let _e1005 = ((_e981 - _e982) * _e995);
                                                    let _e1007 = select(0f, _e1005, (_e1005 > 0f));
                                                    let _e1009 = ((_e999 + _e1003) + _e1007);
                                                    let _e1011 = select(_e936[1][0], _e936[0][0], (_e936[0][0] < _e936[1][0]));
                                                    let _e1015 = select(_e936[1][0], _e936[0][0], (_e936[0][0] > _e936[1][0]));
                                                    let _e1019 = select(_e936[1][1], _e936[0][1], (_e936[0][1] < _e936[1][1]));
                                                    let _e1023 = select(_e936[1][1], _e936[0][1], (_e936[0][1] > _e936[1][1]));
                                                    let _e1027 = select(_e936[1][2], _e936[0][2], (_e936[0][2] < _e936[1][2]));
                                                    let _e1031 = select(_e936[1][2], _e936[0][2], (_e936[0][2] > _e936[1][2]));
                                                    let _e1036 = ((select(_e936[2][0], _e1011, (_e1011 < _e936[2][0])) - _e509) * _e512);
                                                    let _e1037 = ((select(_e936[2][0], _e1015, (_e1015 > _e936[2][0])) - _e510) * _e512);
                                                    let _e1040 = ((select(_e936[2][1], _e1019, (_e1019 < _e936[2][1])) - _e573) * _e576);
                                                    let _e1041 = ((select(_e936[2][1], _e1023, (_e1023 > _e936[2][1])) - _e574) * _e576);
                                                    let _e1044 = ((select(_e936[2][2], _e1027, (_e1027 < _e936[2][2])) - _e637) * _e640);
                                                    let _e1045 = ((select(_e936[2][2], _e1031, (_e1031 > _e936[2][2])) - _e638) * _e640);
                                                    let _e1047 = select(_e1045, _e1044, (_e1044 < _e1045));
                                                    let _e1049 = select(_e1045, _e1044, (_e1044 > _e1045));
                                                    let _e1051 = select(_e1037, _e1036, (_e1036 < _e1037));
                                                    let _e1053 = select(_e1041, _e1040, (_e1040 < _e1041));
                                                    let _e1055 = select(_e1053, _e1051, (_e1051 > _e1053));
                                                    let _e1057 = select(_e1047, _e1055, (_e1055 > _e1047));
                                                    let _e1059 = select(_e1037, _e1036, (_e1036 > _e1037));
                                                    let _e1061 = select(_e1041, _e1040, (_e1040 > _e1041));
                                                    let _e1063 = select(_e1061, _e1059, (_e1059 < _e1061));
                                                    let _e1065 = select(_e1049, _e1063, (_e1063 < _e1049));
                                                    let _e1066 = -(_e1047);
                                                    let _e1072 = select(_e742, _e1057, (_e1057 > _e742));
                                                    let _e1076 = select(_e964, _e955, (_e955 < _e964));
                                                    let _e1081 = select(_e964, _e955, (_e955 > _e964));
                                                    let _e1088 = select(_e967, _e958, (_e958 < _e967));
                                                    let _e1093 = select(_e967, _e958, (_e958 > _e967));
                                                    let _e1102 = (((((_e993 && (_e1009 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e973, _e1076, (_e1076 < _e973)) <= 0f) && (select(_e973, _e1081, (_e1081 > _e973)) >= 0f))) && ((select(_e976, _e1088, (_e1088 < _e976)) <= 0f) && (select(_e976, _e1093, (_e1093 > _e976)) >= 0f))) && (_e1072 <= (_e1065 + (select(_e1066, _e1049, (_e1049 > _e1066)) * 0.0000019073523f)))) && (_e1072 <= _e840.member_1));
                                                    if _e1102 {
                                                        let _e1107 = (_e936[1][0] - _e936[0][0]);
                                                        let _e1108 = (_e936[1][1] - _e936[0][1]);
                                                        let _e1109 = (_e936[1][2] - _e936[0][2]);
                                                        let _e1110 = vec3<f32>(_e1107, _e1108, _e1109);
                                                        let _e1111 = (_e936[2][0] - _e936[1][0]);
                                                        let _e1112 = (_e936[2][1] - _e936[1][1]);
                                                        let _e1113 = (_e936[2][2] - _e936[1][2]);
                                                        let _e1114 = vec3<f32>(_e1111, _e1112, _e1113);
                                                        let _e1115 = (_e936[0][0] - _e936[2][0]);
                                                        let _e1116 = (_e936[0][1] - _e936[2][1]);
                                                        let _e1117 = (_e936[0][2] - _e936[2][2]);
                                                        let _e1118 = vec3<f32>(_e1115, _e1116, _e1117);
                                                        let _e1119 = abs(_e1107);
                                                        let _e1120 = abs(_e1108);
                                                        if (_e1119 != _e1119) {
                                                            phi_4271_ = true;
                                                        } else {
                                                            phi_4271_ = (_e1120 >= _e1119);
                                                        }
                                                        let _e1124 = phi_4271_;
                                                        let _e1125 = select(_e1119, _e1120, _e1124);
                                                        let _e1126 = abs(_e1109);
                                                        if (_e1125 != _e1125) {
                                                            phi_4286_ = true;
                                                        } else {
                                                            phi_4286_ = (_e1126 >= _e1125);
                                                        }
                                                        let _e1130 = phi_4286_;
                                                        let _e1131 = select(_e1125, _e1126, _e1130);
                                                        let _e1132 = abs(_e1111);
                                                        let _e1133 = abs(_e1112);
                                                        if (_e1132 != _e1132) {
                                                            phi_4301_ = true;
                                                        } else {
                                                            phi_4301_ = (_e1133 >= _e1132);
                                                        }
                                                        let _e1137 = phi_4301_;
                                                        let _e1138 = select(_e1132, _e1133, _e1137);
                                                        let _e1139 = abs(_e1113);
                                                        if (_e1138 != _e1138) {
                                                            phi_4316_ = true;
                                                        } else {
                                                            phi_4316_ = (_e1139 >= _e1138);
                                                        }
                                                        let _e1143 = phi_4316_;
                                                        let _e1144 = select(_e1138, _e1139, _e1143);
                                                        let _e1145 = abs(_e1115);
                                                        let _e1146 = abs(_e1116);
                                                        if (_e1145 != _e1145) {
                                                            phi_4331_ = true;
                                                        } else {
                                                            phi_4331_ = (_e1146 >= _e1145);
                                                        }
                                                        let _e1150 = phi_4331_;
                                                        let _e1151 = select(_e1145, _e1146, _e1150);
                                                        let _e1152 = abs(_e1117);
                                                        if (_e1151 != _e1151) {
                                                            phi_4346_ = true;
                                                        } else {
                                                            phi_4346_ = (_e1152 >= _e1151);
                                                        }
                                                        let _e1156 = phi_4346_;
                                                        let _e1157 = select(_e1151, _e1152, _e1156);
                                                        let _e1159 = select(_e1144, _e1131, (_e1131 > _e1144));
                                                        let _e1161 = select(_e1157, _e1159, (_e1159 > _e1157));
                                                        if (_e1131 == _e1161) {
                                                            phi_2222_ = _e967;
                                                            phi_2223_ = _e964;
                                                            phi_2224_ = _e958;
                                                            phi_2225_ = _e955;
                                                            phi_2226_ = vec3<f32>(_e936[0][0], _e936[0][1], _e936[0][2]);
                                                            phi_2227_ = _e1118;
                                                            phi_2228_ = _e1114;
                                                            phi_2229_ = _e1110;
                                                        } else {
                                                            let _e1163 = (_e1144 == _e1161);
                                                            let _e1168 = vec3(_e1163);
                                                            phi_2222_ = select(_e958, _e976, _e1163);
                                                            phi_2223_ = select(_e955, _e973, _e1163);
                                                            phi_2224_ = select(_e976, _e967, _e1163);
                                                            phi_2225_ = select(_e973, _e964, _e1163);
                                                            phi_2226_ = select(vec3<f32>(_e936[2][0], _e936[2][1], _e936[2][2]), vec3<f32>(_e936[1][0], _e936[1][1], _e936[1][2]), _e1168);
                                                            phi_2227_ = select(_e1114, _e1110, _e1168);
                                                            phi_2228_ = select(_e1110, _e1118, _e1168);
                                                            phi_2229_ = select(_e1118, _e1114, _e1168);
                                                        }
                                                        let _e1174 = phi_2222_;
                                                        let _e1176 = phi_2223_;
                                                        let _e1178 = phi_2224_;
                                                        let _e1180 = phi_2225_;
                                                        let _e1182 = phi_2226_;
                                                        let _e1184 = phi_2227_;
                                                        let _e1186 = phi_2228_;
                                                        let _e1188 = phi_2229_;
                                                        let _e1195 = ((_e1186.y * _e1184.z) - (_e1184.y * _e1186.z));
                                                        let _e1200 = ((_e1186.z * _e1184.x) - (_e1184.z * _e1186.x));
                                                        let _e1203 = ((_e1186.x * _e1184.y) - (_e1184.x * _e1186.y));
                                                        let _e1206 = ((_e999 >= _e1003) && (_e999 >= _e1007));
                                                        let _e1207 = (_e1003 >= _e1007);
                                                        let _e1221 = (((_e1195 * (select(select(_e936[2][0], _e936[1][0], _e1207), _e936[0][0], _e1206) - _e471)) + (_e1200 * (select(select(_e936[2][1], _e936[1][1], _e1207), _e936[0][1], _e1206) - _e536))) + (_e1203 * (select(select(_e936[2][2], _e936[1][2], _e1207), _e936[0][2], _e1206) - _e600)));
                                                        let _e1226 = (((_e1195 * _e508) + (_e1200 * _e572)) + (_e1203 * _e636));
                                                        let _e1227 = (_e1176 - _e1180);
                                                        let _e1228 = (_e1174 - _e1178);
                                                        let _e1231 = ((_e1227 * _e1227) + (_e1228 * _e1228));
                                                        let _e1238 = (-(((_e1180 * _e1227) + (_e1178 * _e1228))) / select(0.000000000000000000000000000000000000011754944f, _e1231, (_e1231 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1240 = select(1f, _e1238, (_e1238 < 1f));
                                                        let _e1242 = select(0f, _e1240, (_e1240 > 0f));
                                                        let _e1251 = ((_e1182.x + (_e1188.x * _e1242)) - _e471);
                                                        let _e1254 = ((_e1182.y + (_e1188.y * _e1242)) - _e536);
                                                        let _e1257 = ((_e1182.z + (_e1188.z * _e1242)) - _e600);
                                                        let _e1260 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                        let _e1263 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                        let _e1265 = select(_e1263, _e1260, (_e1260 > _e1263));
                                                        let _e1268 = bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u));
                                                        let _e1270 = select(_e1268, _e1265, (_e1265 > _e1268));
                                                        let _e1274 = abs(_e1195);
                                                        let _e1275 = abs(_e1200);
                                                        if (_e1274 != _e1274) {
                                                            phi_4361_ = true;
                                                        } else {
                                                            phi_4361_ = (_e1275 >= _e1274);
                                                        }
                                                        let _e1279 = phi_4361_;
                                                        let _e1280 = select(_e1274, _e1275, _e1279);
                                                        let _e1281 = abs(_e1203);
                                                        if (_e1280 != _e1280) {
                                                            phi_4376_ = true;
                                                        } else {
                                                            phi_4376_ = (_e1281 >= _e1280);
                                                        }
                                                        let _e1285 = phi_4376_;
                                                        let _e1301 = abs(_e1186.x);
                                                        let _e1302 = abs(_e1186.y);
                                                        if (_e1301 != _e1301) {
                                                            phi_4391_ = true;
                                                        } else {
                                                            phi_4391_ = (_e1302 >= _e1301);
                                                        }
                                                        let _e1306 = phi_4391_;
                                                        let _e1307 = select(_e1301, _e1302, _e1306);
                                                        let _e1308 = abs(_e1186.z);
                                                        if (_e1307 != _e1307) {
                                                            phi_4406_ = true;
                                                        } else {
                                                            phi_4406_ = (_e1308 >= _e1307);
                                                        }
                                                        let _e1312 = phi_4406_;
                                                        let _e1315 = abs(_e1184.x);
                                                        let _e1316 = abs(_e1184.y);
                                                        if (_e1315 != _e1315) {
                                                            phi_4421_ = true;
                                                        } else {
                                                            phi_4421_ = (_e1316 >= _e1315);
                                                        }
                                                        let _e1320 = phi_4421_;
                                                        let _e1321 = select(_e1315, _e1316, _e1320);
                                                        let _e1322 = abs(_e1184.z);
                                                        if (_e1321 != _e1321) {
                                                            phi_4436_ = true;
                                                        } else {
                                                            phi_4436_ = (_e1322 >= _e1321);
                                                        }
                                                        let _e1326 = phi_4436_;
                                                        let _e1331 = ((bitcast<f32>((bitcast<u32>(((((_e1195 * _e1251) + (_e1200 * _e1254)) + (_e1203 * _e1257)) - _e1221)) & 2147483647u)) <= ((0.0000009536743f * select(_e1161, _e1270, (_e1270 > _e1161))) * select(_e1280, _e1281, _e1285))) && !((bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u)) <= ((0.0000038146973f * select(_e1307, _e1308, _e1312)) * select(_e1321, _e1322, _e1326)))));
                                                        let _e1332 = (_e1221 / _e1226);
                                                        if (_e1102 && !(_e1331)) {
                                                            let _e1335 = (_e1257 / _e636);
                                                            let _e1343 = (((_e1195 * (_e1251 - (_e508 * _e1335))) + (_e1200 * (_e1254 - (_e572 * _e1335)))) / _e1226);
                                                            phi_2437_ = select(select(_e1335, (_e1335 + _e1343), (bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u)) <= _e1161)), _e1332, _e1331);
                                                        } else {
                                                            phi_2437_ = _e1332;
                                                        }
                                                        let _e1352 = phi_2437_;
                                                        let _e1354 = select(_e1065, _e1352, (_e1352 < _e1065));
                                                        let _e1356 = select(_e1057, _e1354, (_e1354 > _e1057));
                                                        let _e1357 = (1f / _e1009);
                                                        phi_2457_ = type_47(_e1356, (_e1003 * _e1357), (_e1007 * _e1357), ((_e1102 && (_e1356 >= _e742)) && (_e1356 <= _e840.member_1)));
                                                        phi_2458_ = type_47();
                                                    } else {
                                                        phi_2457_ = type_47();
                                                        phi_2458_ = type_47(0f, 0f, 0f, _e1102);
                                                    }
                                                    let _e1366 = phi_2457_;
                                                    let _e1368 = phi_2458_;
                                                    phi_2461_ = _e1366;
                                                    phi_2462_ = _e1368;
                                                    phi_2463_ = select(true, false, _e1102);
                                                } else {
                                                    phi_2461_ = type_47();
                                                    phi_2462_ = type_47(0f, 0f, 0f, _e993);
                                                    phi_2463_ = true;
                                                }
                                                let _e1371 = phi_2461_;
                                                let _e1373 = phi_2462_;
                                                let _e1375 = phi_2463_;
                                                if _e1375 {
                                                    phi_2467_ = _e1373;
                                                } else {
                                                    phi_2467_ = _e1371;
                                                }
                                                let _e1377 = phi_2467_;
                                                if _e1377.member_3 {
                                                    phi_2476_ = type_26(_e1377.member, _e1377.member_1, _e1377.member_2, _e869);
                                                } else {
                                                    phi_2476_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1384 = phi_2476_;
                                                if (_e1384.member_3 != 4294967295u) {
                                                    if (_e869 == _e170) {
                                                        phi_2811_ = false;
                                                    } else {
                                                        let _e1388 = (_e869 < arrayLength((&global_5.member)));
                                                        if _e1388 {
                                                            if _e1388 {
                                                            } else {
                                                                phi_4704_ = true;
                                                                break;
                                                            }
                                                            let _e1390 = global_5.member[_e869];
                                                            phi_2499_ = _e1390;
                                                        } else {
                                                            phi_2499_ = 4294967295u;
                                                        }
                                                        let _e1392 = phi_2499_;
                                                        let _e1393 = (_e1392 < arrayLength((&global_6.member)));
                                                        if _e1393 {
                                                            if _e1393 {
                                                            } else {
                                                                phi_4704_ = true;
                                                                break;
                                                            }
                                                            let _e1395 = global_6.member[_e1392];
                                                            phi_2513_ = _e1395;
                                                        } else {
                                                            phi_2513_ = 0i;
                                                        }
                                                        let _e1397 = phi_2513_;
                                                        let _e1398 = (_e1397 == 0i);
                                                        if _e1398 {
                                                            phi_2810_ = true;
                                                        } else {
                                                            if _e448 {
                                                                phi_2536_ = vec3<f32>(_e936[0][0], _e936[0][1], _e936[0][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2535_ = vec3<f32>(_e936[0][2], _e936[0][0], _e936[0][1]);
                                                                } else {
                                                                    phi_2535_ = vec3<f32>(_e936[0][1], _e936[0][2], _e936[0][0]);
                                                                }
                                                                let _e1403 = phi_2535_;
                                                                phi_2536_ = _e1403;
                                                            }
                                                            let _e1406 = phi_2536_;
                                                            if _e448 {
                                                                phi_2555_ = vec3<f32>(_e936[1][0], _e936[1][1], _e936[1][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2554_ = vec3<f32>(_e936[1][2], _e936[1][0], _e936[1][1]);
                                                                } else {
                                                                    phi_2554_ = vec3<f32>(_e936[1][1], _e936[1][2], _e936[1][0]);
                                                                }
                                                                let _e1411 = phi_2554_;
                                                                phi_2555_ = _e1411;
                                                            }
                                                            let _e1414 = phi_2555_;
                                                            if _e448 {
                                                                phi_2574_ = vec3<f32>(_e936[2][0], _e936[2][1], _e936[2][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2573_ = vec3<f32>(_e936[2][2], _e936[2][0], _e936[2][1]);
                                                                } else {
                                                                    phi_2573_ = vec3<f32>(_e936[2][1], _e936[2][2], _e936[2][0]);
                                                                }
                                                                let _e1419 = phi_2573_;
                                                                phi_2574_ = _e1419;
                                                            }
                                                            let _e1422 = phi_2574_;
                                                            let _e1425 = (_e1414.x - _e1406.x);
                                                            let _e1428 = (_e1414.y - _e1406.y);
                                                            let _e1431 = (_e1414.z - _e1406.z);
                                                            let _e1433 = (_e1422.x - _e1406.x);
                                                            let _e1435 = (_e1422.y - _e1406.y);
                                                            let _e1437 = (_e1422.z - _e1406.z);
                                                            if (_e302.member_1 == 1u) {
                                                                phi_2610_ = (vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]) - _e1406);
                                                            } else {
                                                                phi_2610_ = vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]);
                                                            }
                                                            let _e1452 = phi_2610_;
                                                            let _e1458 = bitcast<f32>((bitcast<u32>((_e1425 * _e1435)) ^ _e302.member_3[0]));
                                                            let _e1462 = bitcast<f32>((bitcast<u32>((_e1428 * _e1433)) ^ _e302.member_3[0]));
                                                            let _e1466 = bitcast<f32>((bitcast<u32>((_e1428 * _e1437)) ^ _e302.member_3[0]));
                                                            let _e1470 = bitcast<f32>((bitcast<u32>((_e1431 * _e1435)) ^ _e302.member_3[0]));
                                                            let _e1474 = bitcast<f32>((bitcast<u32>((_e1431 * _e1433)) ^ _e302.member_3[0]));
                                                            let _e1478 = bitcast<f32>((bitcast<u32>((_e1425 * _e1437)) ^ _e302.member_3[0]));
                                                            let _e1479 = (_e1466 - _e1470);
                                                            let _e1480 = (_e1474 - _e1478);
                                                            let _e1481 = (_e1458 - _e1462);
                                                            let _e1505 = (bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u)));
                                                            let _e1512 = (bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u)));
                                                            let _e1519 = (bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u)));
                                                            if (_e302.member_2 == 0f) {
                                                                phi_2792_ = 0f;
                                                            } else {
                                                                let _e1549 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                                let _e1552 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                let _e1555 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                let _e1557 = select(_e1555, _e1552, (_e1552 > _e1555));
                                                                let _e1561 = select(_e1555, _e1552, (_e1552 < _e1555));
                                                                let _e1565 = select(_e1552, _e1549, (_e1549 < _e1552));
                                                                let _e1567 = select(_e1552, _e1549, (_e1549 > _e1552));
                                                                let _e1569 = select(_e1555, _e1567, (_e1567 < _e1555));
                                                                phi_2792_ = bitcast<f32>((bitcast<u32>((_e302.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1557, _e1549, (_e1549 > _e1557)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1569, _e1565, (_e1565 > _e1569)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1561, _e1549, (_e1549 < _e1561)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1505 + _e1512) + _e1519))) ^ _e302.member_3[0]))) * 1.0000005f)) ^ _e302.member_3[0])))) ^ _e302.member_3[0]));
                                                            }
                                                            let _e1596 = phi_2792_;
                                                            phi_2810_ = (_e1398 || !(((((bitcast<f32>((bitcast<u32>((_e1452.x * _e1479)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1452.y * _e1480)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1452.z * _e1481)) ^ _e302.member_3[0]))) * f32(-(_e1397))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1452.x) & 2147483647u)) * _e1505)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1452.y) & 2147483647u)) * _e1512)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1452.z) & 2147483647u)) * _e1519)) ^ _e302.member_3[0]))))) ^ _e302.member_3[0])) + _e1596) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1610 = phi_2810_;
                                                        phi_2811_ = _e1610;
                                                    }
                                                    let _e1612 = phi_2811_;
                                                    if _e1612 {
                                                        if (_e1384.member < _e840.member.member) {
                                                            phi_2831_ = true;
                                                        } else {
                                                            if (_e1384.member == _e840.member.member) {
                                                                phi_2830_ = (_e1384.member_3 < _e840.member.member_3);
                                                            } else {
                                                                phi_2830_ = false;
                                                            }
                                                            let _e1622 = phi_2830_;
                                                            phi_2831_ = _e1622;
                                                        }
                                                        let _e1624 = phi_2831_;
                                                        if _e1624 {
                                                            phi_2837_ = type_44(_e1384, _e1384.member);
                                                        } else {
                                                            phi_2837_ = _e840;
                                                        }
                                                        let _e1627 = phi_2837_;
                                                        phi_2838_ = _e1627;
                                                    } else {
                                                        phi_2838_ = _e840;
                                                    }
                                                    let _e1629 = phi_2838_;
                                                    phi_2839_ = _e1629;
                                                } else {
                                                    phi_2839_ = _e840;
                                                }
                                                let _e1631 = phi_2839_;
                                                phi_1542_ = _e1631;
                                            } else {
                                                phi_1542_ = type_44();
                                            }
                                            let _e1633 = phi_1542_;
                                            continue;
                                            continuing {
                                                phi_1541_ = _e1633;
                                                phi_1544_ = _e855;
                                                phi_4704_ = _e784;
                                                break if !(_e861);
                                            }
                                        }
                                        let _e1636 = phi_4704_;
                                        phi_4901_ = _e1636;
                                        if _e1636 {
                                            break;
                                        }
                                        phi_4987_ = _e1636;
                                        let _e2398 = local_11;
                                        phi_2840_ = _e2398;
                                    } else {
                                        phi_4987_ = _e784;
                                        phi_2840_ = _e786;
                                    }
                                    let _e1638 = phi_4987_;
                                    let _e1640 = phi_2840_;
                                    if _e833 {
                                        phi_4070_ = bool();
                                        phi_4071_ = u32();
                                        phi_4072_ = type_63();
                                    } else {
                                        if (_e829.member_1 >= _e103) {
                                            phi_3606_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e829.member_1 < _e103) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1643 = (_e424 * 2u);
                                            let _e1645 = ((1u + _e1643) % 7u);
                                            if (_e1645 < 7u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1650 = global_10.member[_e829.member_1][_e1645];
                                            let _e1652 = ((_e1643 + 2u) % 7u);
                                            if (_e1652 < 7u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1657 = global_10.member[_e829.member_1][_e1652];
                                            let _e1658 = (_e423 * 2u);
                                            let _e1660 = ((1u + _e1658) % 7u);
                                            if (_e1660 < 7u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1665 = global_10.member[_e829.member_1][_e1660];
                                            let _e1667 = ((_e1658 + 2u) % 7u);
                                            if (_e1667 < 7u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1672 = global_10.member[_e829.member_1][_e1667];
                                            let _e1673 = (_e425 * 2u);
                                            let _e1675 = ((1u + _e1673) % 7u);
                                            if (_e1675 < 7u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1680 = global_10.member[_e829.member_1][_e1675];
                                            let _e1682 = ((_e1673 + 2u) % 7u);
                                            if (_e1682 < 7u) {
                                            } else {
                                                phi_4901_ = true;
                                                break;
                                            }
                                            let _e1687 = global_10.member[_e829.member_1][_e1682];
                                            let _e1710 = (bitcast<f32>((bitcast<u32>((_e829.member.member_1.x - _e829.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1711 = (bitcast<f32>((bitcast<u32>((_e829.member.member_1.y - _e829.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1712 = (bitcast<f32>((bitcast<u32>((_e829.member.member_1.z - _e829.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1714 = select(_e161, _e1710, (_e1710 > _e161));
                                            let _e1716 = select(_e161, _e1711, (_e1711 > _e161));
                                            let _e1718 = select(_e161, _e1712, (_e1712 > _e161));
                                            let _e1749 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1650 & 2097151u))) - 8388608f) * _e1714));
                                            let _e1754 = (bitcast<i32>((_e1650 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1757 = bitcast<f32>((_e1749 & bitcast<u32>(_e1754)));
                                            let _e1758 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1665 & 2097151u))) - 8388608f) * _e1716));
                                            let _e1763 = (bitcast<i32>((_e1665 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1766 = bitcast<f32>((_e1758 & bitcast<u32>(_e1763)));
                                            let _e1767 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1680 & 2097151u))) - 8388608f) * _e1718));
                                            let _e1772 = (bitcast<i32>((_e1680 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1775 = bitcast<f32>((_e1767 & bitcast<u32>(_e1772)));
                                            let _e1779 = bitcast<f32>((_e1749 & bitcast<u32>(~(_e1754))));
                                            let _e1783 = bitcast<f32>((_e1758 & bitcast<u32>(~(_e1763))));
                                            let _e1787 = bitcast<f32>((_e1767 & bitcast<u32>(~(_e1772))));
                                            let _e1788 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1657 & 2097151u))) - 8388608f) * _e1714));
                                            let _e1793 = (bitcast<i32>((_e1657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1796 = bitcast<f32>((_e1788 & bitcast<u32>(_e1793)));
                                            let _e1797 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1672 & 2097151u))) - 8388608f) * _e1716));
                                            let _e1802 = (bitcast<i32>((_e1672 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1805 = bitcast<f32>((_e1797 & bitcast<u32>(_e1802)));
                                            let _e1806 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1687 & 2097151u))) - 8388608f) * _e1718));
                                            let _e1811 = (bitcast<i32>((_e1687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1814 = bitcast<f32>((_e1806 & bitcast<u32>(_e1811)));
                                            let _e1818 = bitcast<f32>((_e1788 & bitcast<u32>(~(_e1793))));
                                            let _e1822 = bitcast<f32>((_e1797 & bitcast<u32>(~(_e1802))));
                                            let _e1826 = bitcast<f32>((_e1806 & bitcast<u32>(~(_e1811))));
                                            let _e1856 = global_10.member[_e829.member_1][0u];
                                            let _e1860 = global_10.member[_e829.member_1][2u];
                                            let _e1864 = global_10.member[_e829.member_1][4u];
                                            let _e1868 = global_10.member[_e829.member_1][6u];
                                            let _e1880 = (((_e1860 >> bitcast<u32>(22i)) | ((_e1864 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1868 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1881 = (_e1856 & 268435455u);
                                            let _e1882 = (_e1880 & 268435455u);
                                            let _e1885 = ((_e1856 >> bitcast<u32>(28u)) & 7u);
                                            let _e1893 = ((_e1856 >> bitcast<u32>(31i)) | (((_e1880 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1894 = (_e1885 != 0u);
                                            if (_e1885 == 0u) {
                                                phi_3568_ = _e1881;
                                            } else {
                                                if (_e1885 == 7u) {
                                                    phi_3567_ = 2147483648u;
                                                } else {
                                                    phi_3567_ = ((2147483648u | (_e1885 << bitcast<u32>(28u))) | (_e1882 & 268435455u));
                                                }
                                                let _e1903 = phi_3567_;
                                                phi_3568_ = _e1903;
                                            }
                                            let _e1905 = phi_3568_;
                                            if _e1894 {
                                                let _e1906 = (_e1885 != 7u);
                                                if _e1906 {
                                                    phi_3578_ = (_e1882 + _e1885);
                                                } else {
                                                    phi_3578_ = u32();
                                                }
                                                let _e1909 = phi_3578_;
                                                phi_3580_ = _e1909;
                                                phi_3581_ = select(true, false, _e1906);
                                            } else {
                                                phi_3580_ = u32();
                                                phi_3581_ = true;
                                            }
                                            let _e1912 = phi_3580_;
                                            let _e1914 = phi_3581_;
                                            if (_e1893 == 0u) {
                                                phi_3602_ = (_e1881 + select(0u, 1u, !(_e1894)));
                                            } else {
                                                if (_e1893 == 7u) {
                                                    phi_3601_ = 2147483648u;
                                                } else {
                                                    phi_3601_ = ((2147483648u | (_e1893 << bitcast<u32>(28u))) | (select(_e1912, _e1882, _e1914) & 268435455u));
                                                }
                                                let _e1927 = phi_3601_;
                                                phi_3602_ = _e1927;
                                            }
                                            let _e1929 = phi_3602_;
                                            phi_3606_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e829.member.member.x + _e1757), (_e829.member.member.x + _e1779), (_e829.member.member_1.x - _e1796), (_e829.member.member_1.x - _e1818)), vec4<f32>((_e829.member.member.y + _e1766), (_e829.member.member.y + _e1783), (_e829.member.member_1.y - _e1805), (_e829.member.member_1.y - _e1822)), vec4<f32>((_e829.member.member.z + _e1775), (_e829.member.member.z + _e1787), (_e829.member.member_1.z - _e1814), (_e829.member.member_1.z - _e1826))), type_63(type_38((_e829.member.member + vec4<f32>(_e1757, _e1766, _e1775, 0f)), (_e829.member.member_1 - vec4<f32>(_e1796, _e1805, _e1814, 0f))), _e1905), type_63(type_38((_e829.member.member + vec4<f32>(_e1779, _e1783, _e1787, 0f)), (_e829.member.member_1 - vec4<f32>(_e1818, _e1822, _e1826, 0f))), _e1929));
                                        }
                                        let _e1934 = phi_3606_;
                                        let _e1946 = ((_e1934.member[0].x - _e509) * _e512);
                                        let _e1947 = ((_e1934.member[0].y - _e509) * _e512);
                                        let _e1948 = ((_e1934.member[0].z - _e510) * _e512);
                                        let _e1949 = ((_e1934.member[0].w - _e510) * _e512);
                                        let _e1959 = ((_e1934.member[1].x - _e573) * _e576);
                                        let _e1960 = ((_e1934.member[1].y - _e573) * _e576);
                                        let _e1961 = ((_e1934.member[1].z - _e574) * _e576);
                                        let _e1962 = ((_e1934.member[1].w - _e574) * _e576);
                                        let _e1972 = ((_e1934.member[2].x - _e637) * _e640);
                                        let _e1973 = ((_e1934.member[2].y - _e637) * _e640);
                                        let _e1974 = ((_e1934.member[2].z - _e638) * _e640);
                                        let _e1975 = ((_e1934.member[2].w - _e638) * _e640);
                                        let _e1977 = select(_e1974, _e1972, (_e1972 < _e1974));
                                        let _e1979 = select(_e1975, _e1973, (_e1973 < _e1975));
                                        let _e1981 = select(_e1974, _e1972, (_e1972 > _e1974));
                                        let _e1983 = select(_e1975, _e1973, (_e1973 > _e1975));
                                        let _e1985 = select(_e1948, _e1946, (_e1946 < _e1948));
                                        let _e1987 = select(_e1949, _e1947, (_e1947 < _e1949));
                                        let _e1989 = select(_e1961, _e1959, (_e1959 < _e1961));
                                        let _e1991 = select(_e1962, _e1960, (_e1960 < _e1962));
                                        let _e1993 = select(_e1989, _e1985, (_e1985 > _e1989));
                                        let _e1995 = select(_e1991, _e1987, (_e1987 > _e1991));
                                        let _e1997 = select(_e1977, _e1993, (_e1993 > _e1977));
                                        let _e1999 = select(_e1979, _e1995, (_e1995 > _e1979));
                                        let _e2001 = select(_e1948, _e1946, (_e1946 > _e1948));
                                        let _e2003 = select(_e1949, _e1947, (_e1947 > _e1949));
                                        let _e2005 = select(_e1961, _e1959, (_e1959 > _e1961));
                                        let _e2007 = select(_e1962, _e1960, (_e1960 > _e1962));
                                        let _e2009 = select(_e2005, _e2001, (_e2001 < _e2005));
                                        let _e2011 = select(_e2007, _e2003, (_e2003 < _e2007));
                                        let _e2016 = -(_e1977);
                                        let _e2017 = -(_e1979);
                                        let _e2024 = (select(_e1981, _e2009, (_e2009 < _e1981)) + (select(_e2016, _e1981, (_e1981 > _e2016)) * 0.0000019073523f));
                                        let _e2025 = (select(_e1983, _e2011, (_e2011 < _e1983)) + (select(_e2017, _e1983, (_e1983 > _e2017)) * 0.0000019073523f));
                                        let _e2027 = select(_e742, _e1997, (_e1997 > _e742));
                                        let _e2029 = select(_e742, _e1999, (_e1999 > _e742));
                                        let _e2034 = (_e2027 <= select(_e1640.member_1, _e2024, (_e2024 < _e1640.member_1)));
                                        let _e2035 = (_e2029 <= select(_e1640.member_1, _e2025, (_e2025 < _e1640.member_1)));
                                        let _e2036 = (_e2027 <= _e2029);
                                        if _e2034 {
                                            if _e2035 {
                                                if _e2036 {
                                                    phi_3968_ = _e1934.member_2;
                                                } else {
                                                    phi_3968_ = _e1934.member_1;
                                                }
                                                let _e2040 = phi_3968_;
                                                let _e2061 = (_e827 % 128u);
                                                let _e2062 = (_e2061 < 128u);
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_8[_e2061] = _e2040.member_1;
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_7[_e2061] = _e2040.member.member.x;
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_6[_e2061] = _e2040.member.member.y;
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_5[_e2061] = _e2040.member.member.z;
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_4[_e2061] = _e2040.member.member_1.x;
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_3[_e2061] = _e2040.member.member_1.y;
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_2[_e2061] = _e2040.member.member_1.z;
                                                if _e2062 {
                                                } else {
                                                    phi_4901_ = true;
                                                    break;
                                                }
                                                local_9[_e2061] = select(_e2027, _e2029, _e2036);
                                                if _e2036 {
                                                    phi_4044_ = _e1934.member_1;
                                                } else {
                                                    phi_4044_ = _e1934.member_2;
                                                }
                                                let _e2075 = phi_4044_;
                                                phi_4045_ = (_e827 + 1u);
                                                phi_4046_ = _e2075;
                                            } else {
                                                phi_4045_ = u32();
                                                phi_4046_ = type_63();
                                            }
                                            let _e2077 = phi_4045_;
                                            let _e2079 = phi_4046_;
                                            phi_4048_ = _e2077;
                                            phi_4049_ = _e2079;
                                            phi_4050_ = select(true, false, _e2035);
                                        } else {
                                            phi_4048_ = u32();
                                            phi_4049_ = type_63();
                                            phi_4050_ = true;
                                        }
                                        let _e2082 = phi_4048_;
                                        let _e2084 = phi_4049_;
                                        let _e2086 = phi_4050_;
                                        if _e2086 {
                                            if _e2034 {
                                                phi_4059_ = _e1934.member_1;
                                            } else {
                                                phi_4059_ = _e1934.member_2;
                                            }
                                            let _e2090 = phi_4059_;
                                            phi_4064_ = select(_e2035, true, _e2034);
                                            phi_4066_ = _e2090;
                                        } else {
                                            phi_4064_ = _e825;
                                            phi_4066_ = _e2084;
                                        }
                                        let _e2093 = phi_4064_;
                                        let _e2095 = phi_4066_;
                                        phi_4070_ = _e2093;
                                        phi_4071_ = select(_e2082, _e827, _e2086);
                                        phi_4072_ = _e2095;
                                    }
                                    let _e2098 = phi_4070_;
                                    let _e2100 = phi_4071_;
                                    let _e2102 = phi_4072_;
                                    if _e833 {
                                        phi_4082_ = _e829;
                                    } else {
                                        phi_4082_ = _e2102;
                                    }
                                    let _e2104 = phi_4082_;
                                    phi_4904_ = _e1638;
                                    phi_4083_ = _e1640;
                                    phi_4084_ = (_e788 - 1u);
                                    phi_4085_ = select(_e2098, false, _e833);
                                    phi_4086_ = select(_e2100, _e827, _e833);
                                    phi_4087_ = _e2104;
                                } else {
                                    phi_4904_ = _e784;
                                    phi_4083_ = _e786;
                                    phi_4084_ = _e788;
                                    phi_4085_ = _e825;
                                    phi_4086_ = _e827;
                                    phi_4087_ = _e829;
                                }
                                let _e2108 = phi_4904_;
                                let _e2110 = phi_4083_;
                                let _e2112 = phi_4084_;
                                let _e2114 = phi_4085_;
                                let _e2116 = phi_4086_;
                                let _e2118 = phi_4087_;
                                phi_4903_ = _e2108;
                                phi_4088_ = _e2110;
                                phi_4089_ = _e2112;
                                phi_4090_ = _e2114;
                                phi_4091_ = _e2116;
                                phi_4092_ = _e2118;
                            } else {
                                phi_4903_ = _e784;
                                phi_4088_ = type_44();
                                phi_4089_ = u32();
                                phi_4090_ = bool();
                                phi_4091_ = u32();
                                phi_4092_ = type_63();
                            }
                            let _e2120 = phi_4903_;
                            let _e2122 = phi_4088_;
                            let _e2124 = phi_4089_;
                            let _e2126 = phi_4090_;
                            let _e2128 = phi_4091_;
                            let _e2130 = phi_4092_;
                            phi_4902_ = _e2120;
                            phi_1416_ = _e2122;
                            phi_1419_ = _e2124;
                            phi_1421_ = _e2126;
                            phi_1423_ = _e2128;
                            phi_1425_ = _e2130;
                            phi_4093_ = _e798;
                        } else {
                            phi_4902_ = _e784;
                            phi_1416_ = type_44();
                            phi_1419_ = u32();
                            phi_1421_ = bool();
                            phi_1423_ = u32();
                            phi_1425_ = type_63();
                            phi_4093_ = false;
                        }
                        let _e2132 = phi_4902_;
                        let _e2134 = phi_1416_;
                        let _e2136 = phi_1419_;
                        let _e2138 = phi_1421_;
                        let _e2140 = phi_1423_;
                        let _e2142 = phi_1425_;
                        let _e2144 = phi_4093_;
                        continue;
                        continuing {
                            phi_4710_ = _e2132;
                            phi_1415_ = _e2134;
                            phi_1418_ = _e2136;
                            phi_1420_ = _e2138;
                            phi_1422_ = _e2140;
                            phi_1424_ = _e2142;
                            phi_4901_ = _e2132;
                            break if !(_e2144);
                        }
                    }
                    let _e2147 = phi_4901_;
                    if _e2147 {
                        break;
                    }
                    let _e2149 = local_10;
                    if (_e2149.member.member_3 != 4294967295u) {
                        let _e2154 = bitcast<u32>(_e2149.member.member);
                        let _e2158 = (bitcast<i32>((_e2154 >> bitcast<u32>(23i))) & 255i);
                        let _e2159 = (_e2158 + _e426);
                        if (_e2158 == 255i) {
                            phi_4152_ = _e2149.member.member;
                        } else {
                            if (_e2158 > 0i) {
                                if (_e2159 > 0i) {
                                    let _e2163 = (_e2159 < 255i);
                                    if _e2163 {
                                        phi_4131_ = bitcast<f32>((_e2154 + bitcast<u32>((_e426 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4131_ = f32();
                                    }
                                    let _e2170 = phi_4131_;
                                    phi_4133_ = _e2170;
                                    phi_4134_ = select(true, false, _e2163);
                                } else {
                                    phi_4133_ = f32();
                                    phi_4134_ = true;
                                }
                                let _e2173 = phi_4133_;
                                let _e2175 = phi_4134_;
                                phi_4135_ = _e2173;
                                phi_4136_ = _e2175;
                            } else {
                                phi_4135_ = f32();
                                phi_4136_ = true;
                            }
                            let _e2177 = phi_4135_;
                            let _e2179 = phi_4136_;
                            if _e2179 {
                                let _e2180 = (_e2154 & 2147483648u);
                                let _e2187 = ((_e2154 & 8388607u) | (select(0u, 1u, ((_e2154 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2191 = (_e2187 == 0u);
                                if _e2191 {
                                    phi_4662_ = bitcast<f32>(_e2180);
                                } else {
                                    let _e2196 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2187)), 32u, _e2191) - 8u);
                                    let _e2199 = (_e2187 << bitcast<u32>((_e2196 & 31u)));
                                    let _e2201 = ((_e2159 + select(0i, 1i, (_e2158 == 0i))) - bitcast<i32>(_e2196));
                                    if (_e2201 >= 255i) {
                                        phi_4652_ = bitcast<f32>((_e2180 | 2139095040u));
                                        phi_4653_ = f32();
                                        phi_4654_ = true;
                                    } else {
                                        let _e2203 = (_e2201 > 0i);
                                        if _e2203 {
                                            phi_4646_ = bitcast<f32>(((_e2180 | (bitcast<u32>(_e2201) << bitcast<u32>(23i))) | (_e2199 & 8388607u)));
                                            phi_4647_ = f32();
                                        } else {
                                            if (_e2201 < -24i) {
                                                phi_4612_ = 26u;
                                            } else {
                                                phi_4612_ = bitcast<u32>((1i - _e2201));
                                            }
                                            let _e2208 = phi_4612_;
                                            let _e2209 = (_e2208 & 31u);
                                            let _e2211 = (_e2199 >> bitcast<u32>(_e2209));
                                            let _e2215 = (_e2199 & ((1u << bitcast<u32>(_e2209)) - 1u));
                                            let _e2219 = (1u << bitcast<u32>(((_e2208 - 1u) & 31u)));
                                            if (_e2215 > _e2219) {
                                                phi_4633_ = true;
                                            } else {
                                                if (_e2215 == _e2219) {
                                                    phi_4630_ = ((_e2211 & 1u) == 1u);
                                                } else {
                                                    phi_4630_ = false;
                                                }
                                                let _e2225 = phi_4630_;
                                                phi_4633_ = _e2225;
                                            }
                                            let _e2227 = phi_4633_;
                                            phi_4646_ = f32();
                                            phi_4647_ = bitcast<f32>((_e2180 | (_e2211 + select(0u, 1u, _e2227))));
                                        }
                                        let _e2240 = phi_4646_;
                                        let _e2242 = phi_4647_;
                                        phi_4652_ = _e2240;
                                        phi_4653_ = _e2242;
                                        phi_4654_ = _e2203;
                                    }
                                    let _e2246 = phi_4652_;
                                    let _e2248 = phi_4653_;
                                    let _e2250 = phi_4654_;
                                    phi_4662_ = select(_e2248, _e2246, _e2250);
                                }
                                let _e2254 = phi_4662_;
                                phi_4151_ = _e2254;
                            } else {
                                phi_4151_ = _e2177;
                            }
                            let _e2256 = phi_4151_;
                            phi_4152_ = _e2256;
                        }
                        let _e2258 = phi_4152_;
                        let _e2259 = bitcast<u32>(_e2258);
                        if ((_e2259 & 2147483647u) >= 2139095040u) {
                            phi_4164_ = bitcast<f32>(((_e2259 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4164_ = _e2258;
                        }
                        let _e2266 = phi_4164_;
                        phi_4169_ = type_26(_e2266, _e2149.member.member_1, _e2149.member.member_2, _e2149.member.member_3);
                    } else {
                        phi_4169_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2271 = phi_4169_;
                    if _e303 {
                    } else {
                        break;
                    }
                    global_8.member[_e149] = _e2271;
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e2275 = select(0u, 1u, (_e370 <= _e380));
                    if (_e2275 > 0u) {
                        let _e2277 = (1u < _e117);
                        if _e2277 {
                            if (0u < _e117) {
                            } else {
                                break;
                            }
                            let _e2281 = atomicAdd((&global_9.member[0u]), _e2275);
                            if ((_e2281 + _e2275) < _e2281) {
                                if _e2277 {
                                } else {
                                    break;
                                }
                                let _e2286 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2289 = select(0u, 1u, (_e2271.member_3 != 4294967295u));
                    if (_e2289 > 0u) {
                        let _e2291 = (3u < _e117);
                        if _e2291 {
                            if (2u < _e117) {
                            } else {
                                break;
                            }
                            let _e2295 = atomicAdd((&global_9.member[2u]), _e2289);
                            if ((_e2295 + _e2289) < _e2295) {
                                if _e2291 {
                                } else {
                                    break;
                                }
                                let _e2300 = atomicAdd((&global_9.member[3u]), 1u);
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
