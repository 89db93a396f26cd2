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
    var phi_443_: u32;
    var phi_487_: i32;
    var phi_627_: type_40;
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
    var phi_1422_: type_44;
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
    var phi_1548_: type_44;
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
    var phi_2435_: type_47;
    var phi_2436_: type_47;
    var phi_2439_: type_47;
    var phi_2440_: type_47;
    var phi_2441_: bool;
    var phi_2445_: type_47;
    var phi_2454_: type_26;
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
    var phi_2815_: type_44;
    var phi_2816_: type_44;
    var phi_2817_: type_44;
    var phi_1549_: type_44;
    var phi_4633_: bool;
    var local_10: type_44;
    var phi_4822_: bool;
    var phi_4044_: type_44;
    var phi_4045_: bool;
    var phi_4046_: type_63;
    var phi_4047_: u32;
    var phi_4821_: bool;
    var phi_4048_: type_44;
    var phi_4049_: bool;
    var phi_4050_: type_63;
    var phi_4051_: u32;
    var phi_4052_: u32;
    var phi_4820_: bool;
    var phi_4053_: type_44;
    var phi_4054_: bool;
    var phi_4055_: type_63;
    var phi_4056_: u32;
    var phi_4057_: u32;
    var phi_4819_: bool;
    var phi_1423_: type_44;
    var phi_1426_: bool;
    var phi_1428_: type_63;
    var phi_1430_: u32;
    var phi_1432_: u32;
    var phi_4058_: bool;
    var phi_4818_: bool;
    var local_11: type_44;
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
    var phi_4134_: type_26;
    var local_12: type_44;

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
                phi_443_ = _e168;
            } else {
                phi_443_ = 4294967295u;
            }
            let _e170 = phi_443_;
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
                phi_487_ = -126i;
            } else {
                phi_487_ = select(_e213, 127i, (_e213 > 127i));
            }
            let _e218 = phi_487_;
            let _e223 = bitcast<f32>((bitcast<u32>((_e218 + 127i)) << bitcast<u32>(23i)));
            let _e229 = bitcast<f32>((bitcast<u32>(((_e213 - _e218) + 127i)) << bitcast<u32>(23i)));
            if (_e189 == 0u) {
                phi_627_ = type_40(array<f32, 3>(_e206, _e207, _e208), _e189, _e210, _e211);
            } else {
                let _e231 = bitcast<u32>(_e206);
                let _e233 = ((_e231 & 2139095040u) != 0u);
                let _e248 = bitcast<u32>(_e207);
                let _e250 = ((_e248 & 2139095040u) != 0u);
                let _e265 = bitcast<u32>(_e208);
                let _e267 = ((_e265 & 2139095040u) != 0u);
                let _e283 = bitcast<u32>(_e210);
                let _e285 = ((_e283 & 2139095040u) != 0u);
                phi_627_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e231 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e231 & 2147483648u))), _e206, _e233) * _e223) * select(0.00000011920929f, 1f, _e233)) * _e229), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e207, _e250) * _e223) * select(0.00000011920929f, 1f, _e250)) * _e229), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e265 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e265 & 2147483648u))), _e208, _e267) * _e223) * select(0.00000011920929f, 1f, _e267)) * _e229)), _e189, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e283 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e283 & 2147483648u))), _e210, _e285) * _e223) * select(0.00000011920929f, 1f, _e285)) * _e229), _e211);
            }
            let _e302 = phi_627_;
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
                            phi_733_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_733_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                        }
                        let _e403 = phi_733_;
                        phi_734_ = _e403;
                    } else {
                        phi_734_ = 0i;
                    }
                    let _e405 = phi_734_;
                    let _e406 = (_e315 == _e359);
                    if _e406 {
                        phi_744_ = true;
                    } else {
                        phi_744_ = (_e323 == _e359);
                    }
                    let _e409 = phi_744_;
                    let _e410 = select(1u, 0u, _e406);
                    if _e409 {
                        let _e411 = (_e410 + 1u);
                        phi_754_ = _e411;
                        phi_755_ = _e411;
                        phi_757_ = select(true, false, (_e411 == 2u));
                    } else {
                        phi_754_ = u32();
                        phi_755_ = 0u;
                        phi_757_ = true;
                    }
                    let _e415 = phi_754_;
                    let _e417 = phi_755_;
                    let _e419 = phi_757_;
                    if _e419 {
                        phi_762_ = (_e417 + 1u);
                    } else {
                        phi_762_ = 0u;
                    }
                    let _e423 = phi_762_;
                    let _e424 = select(_e415, _e417, _e419);
                    let _e425 = select(_e410, select(2u, _e410, _e409), _e419);
                    let _e426 = -(_e405);
                    if (_e426 < -126i) {
                        phi_795_ = -126i;
                    } else {
                        phi_795_ = select(_e426, 127i, (_e426 > 127i));
                    }
                    let _e431 = phi_795_;
                    let _e436 = bitcast<f32>((bitcast<u32>((_e431 + 127i)) << bitcast<u32>(23i)));
                    let _e442 = bitcast<f32>((bitcast<u32>(((_e426 - _e431) + 127i)) << bitcast<u32>(23i)));
                    let _e447 = global_7.member[_e149].member.member;
                    let _e448 = (_e424 == 0u);
                    if _e448 {
                        phi_813_ = _e447[0];
                    } else {
                        phi_813_ = _e447[1];
                    }
                    let _e452 = phi_813_;
                    let _e453 = (_e424 == 2u);
                    if _e453 {
                        phi_819_ = _e447[2];
                    } else {
                        phi_819_ = _e452;
                    }
                    let _e456 = phi_819_;
                    let _e457 = bitcast<u32>(_e456);
                    let _e459 = ((_e457 & 2139095040u) != 0u);
                    let _e471 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e457 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e457 & 2147483648u))), _e456, _e459) * select(0.00000011920929f, 1f, _e459));
                    let _e472 = global_7.member[_e149].member.member_2;
                    if _e448 {
                        phi_859_ = _e472[0];
                    } else {
                        phi_859_ = _e472[1];
                    }
                    let _e476 = phi_859_;
                    if _e453 {
                        phi_865_ = _e472[2];
                    } else {
                        phi_865_ = _e476;
                    }
                    let _e479 = phi_865_;
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
                        phi_938_ = _e447[0];
                    } else {
                        phi_938_ = _e447[1];
                    }
                    let _e517 = phi_938_;
                    let _e518 = (_e423 == 2u);
                    if _e518 {
                        phi_944_ = _e447[2];
                    } else {
                        phi_944_ = _e517;
                    }
                    let _e521 = phi_944_;
                    let _e522 = bitcast<u32>(_e521);
                    let _e524 = ((_e522 & 2139095040u) != 0u);
                    let _e536 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e522 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e522 & 2147483648u))), _e521, _e524) * select(0.00000011920929f, 1f, _e524));
                    if _e513 {
                        phi_984_ = _e472[0];
                    } else {
                        phi_984_ = _e472[1];
                    }
                    let _e540 = phi_984_;
                    if _e518 {
                        phi_990_ = _e472[2];
                    } else {
                        phi_990_ = _e540;
                    }
                    let _e543 = phi_990_;
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
                        phi_1063_ = _e447[0];
                    } else {
                        phi_1063_ = _e447[1];
                    }
                    let _e581 = phi_1063_;
                    let _e582 = (_e425 == 2u);
                    if _e582 {
                        phi_1069_ = _e447[2];
                    } else {
                        phi_1069_ = _e581;
                    }
                    let _e585 = phi_1069_;
                    let _e586 = bitcast<u32>(_e585);
                    let _e588 = ((_e586 & 2139095040u) != 0u);
                    let _e600 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e586 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e586 & 2147483648u))), _e585, _e588) * select(0.00000011920929f, 1f, _e588));
                    if _e577 {
                        phi_1109_ = _e472[0];
                    } else {
                        phi_1109_ = _e472[1];
                    }
                    let _e604 = phi_1109_;
                    if _e582 {
                        phi_1115_ = _e472[2];
                    } else {
                        phi_1115_ = _e604;
                    }
                    let _e607 = phi_1115_;
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
                            phi_1234_ = 255i;
                        } else {
                            phi_1234_ = (((_e657 + select(0i, 1i, (_e657 == 0i))) - _e664) + _e405);
                        }
                        let _e672 = phi_1234_;
                        let _e682 = (_e672 <= 0i);
                        if _e682 {
                            phi_1257_ = u32();
                        } else {
                            if _e661 {
                                phi_1256_ = u32();
                            } else {
                                phi_1256_ = select(((bitcast<u32>(_e672) << bitcast<u32>(23i)) | ((_e654 << bitcast<u32>(((_e664 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e672 >= 255i));
                            }
                            let _e686 = phi_1256_;
                            phi_1257_ = _e686;
                        }
                        let _e688 = phi_1257_;
                        let _e700 = ((_e382 & 8388607u) | (select(0u, 1u, ((_e382 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e703 = bitcast<i32>((_e382 >> bitcast<u32>(23i)));
                        let _e707 = (_e700 == 0u);
                        let _e710 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e700)), 32u, _e707)) - 8i);
                        if (_e703 == 255i) {
                            phi_1294_ = 255i;
                        } else {
                            phi_1294_ = (((_e703 + select(0i, 1i, (_e703 == 0i))) - _e710) + _e405);
                        }
                        let _e718 = phi_1294_;
                        let _e728 = (_e718 <= 0i);
                        if _e728 {
                            phi_1317_ = u32();
                        } else {
                            if _e707 {
                                phi_1316_ = u32();
                            } else {
                                phi_1316_ = select(((bitcast<u32>(_e718) << bitcast<u32>(23i)) | ((_e700 << bitcast<u32>(((_e710 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e718 >= 255i));
                            }
                            let _e732 = phi_1316_;
                            phi_1317_ = _e732;
                        }
                        let _e734 = phi_1317_;
                        phi_1325_ = bitcast<f32>(((_e381 & 2147483648u) | select(_e734, 0u, select(_e707, true, _e728))));
                        phi_1326_ = bitcast<f32>(((_e371 & 2147483648u) | select(_e688, 0u, select(_e661, true, _e682))));
                    } else {
                        phi_1325_ = 0f;
                        phi_1326_ = 1f;
                    }
                    let _e740 = phi_1325_;
                    let _e742 = phi_1326_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e748 = (_e424 % 3u);
                    let _e749 = (_e748 < 3u);
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e751 = local_1[_e748];
                    let _e754 = (_e423 % 3u);
                    let _e755 = (_e754 < 3u);
                    if _e755 {
                    } else {
                        break;
                    }
                    let _e757 = local_1[_e754];
                    let _e760 = (_e425 % 3u);
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
                    phi_4639_ = false;
                    phi_1422_ = type_44(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e740);
                    phi_1425_ = (_e742 <= _e740);
                    phi_1427_ = type_63(type_38(vec4<f32>((f32(_e751) * _e161), (f32(_e757) * _e161), (f32(_e763) * _e161), 0f), vec4<f32>((f32(_e768) * _e161), (f32(_e772) * _e161), (f32(_e776) * _e161), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    phi_1429_ = 0u;
                    phi_1431_ = ((3u * _e103) + 1u);
                    loop {
                        let _e784 = phi_4639_;
                        let _e786 = phi_1422_;
                        let _e788 = phi_1425_;
                        let _e790 = phi_1427_;
                        let _e792 = phi_1429_;
                        let _e794 = phi_1431_;
                        local_11 = _e786;
                        if _e788 {
                            phi_1442_ = true;
                        } else {
                            phi_1442_ = (_e792 > 0u);
                        }
                        let _e797 = phi_1442_;
                        if _e797 {
                            let _e798 = (_e794 > 0u);
                            if _e798 {
                                if _e788 {
                                    phi_1528_ = _e788;
                                    phi_1529_ = _e790;
                                    phi_1530_ = _e792;
                                } else {
                                    let _e799 = (_e792 - 1u);
                                    let _e800 = (_e799 % 128u);
                                    let _e801 = (_e800 < 128u);
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e803 = local_7[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e805 = local_6[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e807 = local_5[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e809 = local_4[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e811 = local_3[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e813 = local_2[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e818 = local_8[_e800];
                                    if _e801 {
                                    } else {
                                        phi_4818_ = true;
                                        break;
                                    }
                                    let _e821 = local_9[_e800];
                                    phi_1528_ = (_e821 <= _e786.member_1);
                                    phi_1529_ = type_63(type_38(vec4<f32>(_e803, _e805, _e807, 0f), vec4<f32>(_e809, _e811, _e813, 0f)), _e818);
                                    phi_1530_ = _e799;
                                }
                                let _e825 = phi_1528_;
                                let _e827 = phi_1529_;
                                let _e829 = phi_1530_;
                                if _e825 {
                                    if ((_e827.member_1 & 2147483648u) != 0u) {
                                        phi_1548_ = _e786;
                                        phi_1551_ = type_8(0u, ((_e827.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1296 = phi_1548_;
                                            let _e1298 = phi_1551_;
                                            local_10 = _e1296;
                                            local_12 = _e1296;
                                            if (_e1298.member < _e1298.member_1) {
                                                phi_1552_ = type_8((_e1298.member + 1u), _e1298.member_1);
                                                phi_1574_ = type_8(1u, _e1298.member);
                                            } else {
                                                phi_1552_ = _e1298;
                                                phi_1574_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1311 = phi_1552_;
                                            let _e1313 = phi_1574_;
                                            let _e1317 = (bitcast<i32>(_e1313.member) != 0i);
                                            if _e1317 {
                                                let _e1318 = ((_e827.member_1 & 268435455u) + _e1313.member_1);
                                                let _e1319 = (_e1318 < _e105);
                                                if _e1319 {
                                                    if _e1319 {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1323 = global_4.member[_e1318].member_1;
                                                    phi_1595_ = _e1323;
                                                } else {
                                                    phi_1595_ = 4294967295u;
                                                }
                                                let _e1325 = phi_1595_;
                                                if (_e1318 >= _e105) {
                                                    phi_1687_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1319 {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    if (_e748 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1332 = global_4.member[_e1318].member[_e748];
                                                    if (_e754 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1338 = global_4.member[_e1318].member[_e754];
                                                    if (_e760 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1344 = global_4.member[_e1318].member[_e760];
                                                    let _e1346 = (3u + _e748);
                                                    if (_e1346 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1352 = global_4.member[_e1318].member[_e1346];
                                                    let _e1353 = (3u + _e754);
                                                    if (_e1353 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1359 = global_4.member[_e1318].member[_e1353];
                                                    let _e1360 = (3u + _e760);
                                                    if (_e1360 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1366 = global_4.member[_e1318].member[_e1360];
                                                    let _e1368 = (6u + _e748);
                                                    if (_e1368 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1374 = global_4.member[_e1318].member[_e1368];
                                                    let _e1375 = (6u + _e754);
                                                    if (_e1375 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1381 = global_4.member[_e1318].member[_e1375];
                                                    let _e1382 = (6u + _e760);
                                                    if (_e1382 < 9u) {
                                                    } else {
                                                        phi_4633_ = true;
                                                        break;
                                                    }
                                                    let _e1388 = global_4.member[_e1318].member[_e1382];
                                                    phi_1687_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1332, _e1338, _e1344), array<f32, 3>(_e1352, _e1359, _e1366), array<f32, 3>(_e1374, _e1381, _e1388));
                                                }
                                                let _e1392 = phi_1687_;
                                                let _e1408 = (_e1392[0][2] - _e600);
                                                let _e1411 = (((_e1392[0][0] - _e471) * _e636) - (_e1408 * _e508));
                                                let _e1414 = (((_e1392[0][1] - _e536) * _e636) - (_e1408 * _e572));
                                                let _e1417 = (_e1392[1][2] - _e600);
                                                let _e1420 = (((_e1392[1][0] - _e471) * _e636) - (_e1417 * _e508));
                                                let _e1423 = (((_e1392[1][1] - _e536) * _e636) - (_e1417 * _e572));
                                                let _e1426 = (_e1392[2][2] - _e600);
                                                let _e1429 = (((_e1392[2][0] - _e471) * _e636) - (_e1426 * _e508));
                                                let _e1432 = (((_e1392[2][1] - _e536) * _e636) - (_e1426 * _e572));
                                                let _e1433 = (_e1429 * _e1423);
                                                let _e1434 = (_e1432 * _e1420);
                                                let _e1435 = (_e1411 * _e1432);
                                                let _e1436 = (_e1414 * _e1429);
                                                let _e1437 = (_e1420 * _e1414);
                                                let _e1438 = (_e1423 * _e1411);
                                                let _e1443 = (((_e1433 >= _e1434) && (_e1435 >= _e1436)) && (_e1437 >= _e1438));
                                                let _e1449 = (_e1443 || (((_e1433 <= _e1434) && (_e1435 <= _e1436)) && (_e1437 <= _e1438)));
                                                if _e1449 {
                                                    let _e1451 = select(-1f, 1f, _e1443);
                                                    let _e1453 = ((_e1433 - _e1434) * _e1451);
                                                    let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                    let _e1457 = ((_e1435 - _e1436) * _e1451);
                                                    let _e1459 = select(0f, _e1457, (_e1457 > 0f));
                                                    let _e1461 = ((_e1437 - _e1438) * _e1451);
                                                    let _e1463 = select(0f, _e1461, (_e1461 > 0f));
                                                    let _e1465 = ((_e1455 + _e1459) + _e1463);
                                                    let _e1467 = select(_e1392[1][0], _e1392[0][0], (_e1392[0][0] < _e1392[1][0]));
                                                    let _e1471 = select(_e1392[1][0], _e1392[0][0], (_e1392[0][0] > _e1392[1][0]));
                                                    let _e1475 = select(_e1392[1][1], _e1392[0][1], (_e1392[0][1] < _e1392[1][1]));
                                                    let _e1479 = select(_e1392[1][1], _e1392[0][1], (_e1392[0][1] > _e1392[1][1]));
                                                    let _e1483 = select(_e1392[1][2], _e1392[0][2], (_e1392[0][2] < _e1392[1][2]));
                                                    let _e1487 = select(_e1392[1][2], _e1392[0][2], (_e1392[0][2] > _e1392[1][2]));
                                                    let _e1492 = ((select(_e1392[2][0], _e1467, (_e1467 < _e1392[2][0])) - _e509) * _e512);
                                                    let _e1493 = ((select(_e1392[2][0], _e1471, (_e1471 > _e1392[2][0])) - _e510) * _e512);
                                                    let _e1496 = ((select(_e1392[2][1], _e1475, (_e1475 < _e1392[2][1])) - _e573) * _e576);
                                                    let _e1497 = ((select(_e1392[2][1], _e1479, (_e1479 > _e1392[2][1])) - _e574) * _e576);
                                                    let _e1500 = ((select(_e1392[2][2], _e1483, (_e1483 < _e1392[2][2])) - _e637) * _e640);
                                                    let _e1501 = ((select(_e1392[2][2], _e1487, (_e1487 > _e1392[2][2])) - _e638) * _e640);
                                                    let _e1503 = select(_e1501, _e1500, (_e1500 < _e1501));
                                                    let _e1505 = select(_e1501, _e1500, (_e1500 > _e1501));
                                                    let _e1507 = select(_e1493, _e1492, (_e1492 < _e1493));
                                                    let _e1509 = select(_e1497, _e1496, (_e1496 < _e1497));
                                                    let _e1511 = select(_e1509, _e1507, (_e1507 > _e1509));
                                                    let _e1513 = select(_e1503, _e1511, (_e1511 > _e1503));
                                                    let _e1515 = select(_e1493, _e1492, (_e1492 > _e1493));
                                                    let _e1517 = select(_e1497, _e1496, (_e1496 > _e1497));
                                                    let _e1519 = select(_e1517, _e1515, (_e1515 < _e1517));
                                                    let _e1521 = select(_e1505, _e1519, (_e1519 < _e1505));
                                                    let _e1522 = -(_e1503);
                                                    let _e1528 = select(_e742, _e1513, (_e1513 > _e742));
                                                    let _e1532 = select(_e1420, _e1411, (_e1411 < _e1420));
                                                    let _e1537 = select(_e1420, _e1411, (_e1411 > _e1420));
                                                    let _e1544 = select(_e1423, _e1414, (_e1414 < _e1423));
                                                    let _e1549 = select(_e1423, _e1414, (_e1414 > _e1423));
                                                    let _e1558 = (((((_e1449 && (_e1465 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1429, _e1532, (_e1532 < _e1429)) <= 0f) && (select(_e1429, _e1537, (_e1537 > _e1429)) >= 0f))) && ((select(_e1432, _e1544, (_e1544 < _e1432)) <= 0f) && (select(_e1432, _e1549, (_e1549 > _e1432)) >= 0f))) && (_e1528 <= (_e1521 + (select(_e1522, _e1505, (_e1505 > _e1522)) * 0.0000019073523f)))) && (_e1528 <= _e1296.member_1));
                                                    if _e1558 {
                                                        let _e1563 = (_e1392[1][0] - _e1392[0][0]);
                                                        let _e1564 = (_e1392[1][1] - _e1392[0][1]);
                                                        let _e1565 = (_e1392[1][2] - _e1392[0][2]);
                                                        let _e1566 = vec3<f32>(_e1563, _e1564, _e1565);
                                                        let _e1567 = (_e1392[2][0] - _e1392[1][0]);
                                                        let _e1568 = (_e1392[2][1] - _e1392[1][1]);
                                                        let _e1569 = (_e1392[2][2] - _e1392[1][2]);
                                                        let _e1570 = vec3<f32>(_e1567, _e1568, _e1569);
                                                        let _e1571 = (_e1392[0][0] - _e1392[2][0]);
                                                        let _e1572 = (_e1392[0][1] - _e1392[2][1]);
                                                        let _e1573 = (_e1392[0][2] - _e1392[2][2]);
                                                        let _e1574 = vec3<f32>(_e1571, _e1572, _e1573);
                                                        let _e1577 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                        let _e1580 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                        let _e1582 = select(_e1580, _e1577, (_e1577 > _e1580));
                                                        let _e1585 = bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u));
                                                        let _e1587 = select(_e1585, _e1582, (_e1582 > _e1585));
                                                        let _e1590 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                        let _e1593 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                        let _e1595 = select(_e1593, _e1590, (_e1590 > _e1593));
                                                        let _e1598 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                        let _e1600 = select(_e1598, _e1595, (_e1595 > _e1598));
                                                        let _e1603 = bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u));
                                                        let _e1606 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
                                                        let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                        let _e1611 = bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u));
                                                        let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                        let _e1615 = select(_e1600, _e1587, (_e1587 > _e1600));
                                                        let _e1617 = select(_e1613, _e1615, (_e1615 > _e1613));
                                                        if (_e1587 == _e1617) {
                                                            phi_2217_ = _e1423;
                                                            phi_2218_ = _e1420;
                                                            phi_2219_ = _e1414;
                                                            phi_2220_ = _e1411;
                                                            phi_2221_ = vec3<f32>(_e1392[0][0], _e1392[0][1], _e1392[0][2]);
                                                            phi_2222_ = _e1574;
                                                            phi_2223_ = _e1570;
                                                            phi_2224_ = _e1566;
                                                        } else {
                                                            let _e1619 = (_e1600 == _e1617);
                                                            let _e1624 = vec3(_e1619);
                                                            phi_2217_ = select(_e1414, _e1432, _e1619);
                                                            phi_2218_ = select(_e1411, _e1429, _e1619);
                                                            phi_2219_ = select(_e1432, _e1423, _e1619);
                                                            phi_2220_ = select(_e1429, _e1420, _e1619);
                                                            phi_2221_ = select(vec3<f32>(_e1392[2][0], _e1392[2][1], _e1392[2][2]), vec3<f32>(_e1392[1][0], _e1392[1][1], _e1392[1][2]), _e1624);
                                                            phi_2222_ = select(_e1570, _e1566, _e1624);
                                                            phi_2223_ = select(_e1566, _e1574, _e1624);
                                                            phi_2224_ = select(_e1574, _e1570, _e1624);
                                                        }
                                                        let _e1630 = phi_2217_;
                                                        let _e1632 = phi_2218_;
                                                        let _e1634 = phi_2219_;
                                                        let _e1636 = phi_2220_;
                                                        let _e1638 = phi_2221_;
                                                        let _e1640 = phi_2222_;
                                                        let _e1642 = phi_2223_;
                                                        let _e1644 = phi_2224_;
                                                        let _e1651 = ((_e1642.y * _e1640.z) - (_e1640.y * _e1642.z));
                                                        let _e1656 = ((_e1642.z * _e1640.x) - (_e1640.z * _e1642.x));
                                                        let _e1659 = ((_e1642.x * _e1640.y) - (_e1640.x * _e1642.y));
                                                        let _e1662 = ((_e1455 >= _e1459) && (_e1455 >= _e1463));
                                                        let _e1663 = (_e1459 >= _e1463);
                                                        let _e1677 = (((_e1651 * (select(select(_e1392[2][0], _e1392[1][0], _e1663), _e1392[0][0], _e1662) - _e471)) + (_e1656 * (select(select(_e1392[2][1], _e1392[1][1], _e1663), _e1392[0][1], _e1662) - _e536))) + (_e1659 * (select(select(_e1392[2][2], _e1392[1][2], _e1663), _e1392[0][2], _e1662) - _e600)));
                                                        let _e1682 = (((_e1651 * _e508) + (_e1656 * _e572)) + (_e1659 * _e636));
                                                        let _e1683 = (_e1632 - _e1636);
                                                        let _e1684 = (_e1630 - _e1634);
                                                        let _e1687 = ((_e1683 * _e1683) + (_e1684 * _e1684));
                                                        let _e1694 = (-(((_e1636 * _e1683) + (_e1634 * _e1684))) / select(0.000000000000000000000000000000000000011754944f, _e1687, (_e1687 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1696 = select(1f, _e1694, (_e1694 < 1f));
                                                        let _e1698 = select(0f, _e1696, (_e1696 > 0f));
                                                        let _e1707 = ((_e1638.x + (_e1644.x * _e1698)) - _e471);
                                                        let _e1710 = ((_e1638.y + (_e1644.y * _e1698)) - _e536);
                                                        let _e1713 = ((_e1638.z + (_e1644.z * _e1698)) - _e600);
                                                        let _e1716 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                        let _e1719 = bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u));
                                                        let _e1721 = select(_e1719, _e1716, (_e1716 > _e1719));
                                                        let _e1724 = bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u));
                                                        let _e1726 = select(_e1724, _e1721, (_e1721 > _e1724));
                                                        let _e1732 = bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u));
                                                        let _e1735 = bitcast<f32>((bitcast<u32>(_e1656) & 2147483647u));
                                                        let _e1737 = select(_e1735, _e1732, (_e1732 > _e1735));
                                                        let _e1740 = bitcast<f32>((bitcast<u32>(_e1659) & 2147483647u));
                                                        let _e1759 = bitcast<f32>((bitcast<u32>(_e1642.x) & 2147483647u));
                                                        let _e1762 = bitcast<f32>((bitcast<u32>(_e1642.y) & 2147483647u));
                                                        let _e1764 = select(_e1762, _e1759, (_e1759 > _e1762));
                                                        let _e1767 = bitcast<f32>((bitcast<u32>(_e1642.z) & 2147483647u));
                                                        let _e1773 = bitcast<f32>((bitcast<u32>(_e1640.x) & 2147483647u));
                                                        let _e1776 = bitcast<f32>((bitcast<u32>(_e1640.y) & 2147483647u));
                                                        let _e1778 = select(_e1776, _e1773, (_e1773 > _e1776));
                                                        let _e1781 = bitcast<f32>((bitcast<u32>(_e1640.z) & 2147483647u));
                                                        let _e1787 = ((bitcast<f32>((bitcast<u32>(((((_e1651 * _e1707) + (_e1656 * _e1710)) + (_e1659 * _e1713)) - _e1677)) & 2147483647u)) <= ((0.0000009536743f * select(_e1617, _e1726, (_e1726 > _e1617))) * select(_e1740, _e1737, (_e1737 > _e1740)))) && !((bitcast<f32>((bitcast<u32>(_e1682) & 2147483647u)) <= ((0.0000038146973f * select(_e1767, _e1764, (_e1764 > _e1767))) * select(_e1781, _e1778, (_e1778 > _e1781))))));
                                                        let _e1788 = (_e1677 / _e1682);
                                                        if (_e1558 && !(_e1787)) {
                                                            let _e1791 = (_e1713 / _e636);
                                                            let _e1799 = (((_e1651 * (_e1707 - (_e508 * _e1791))) + (_e1656 * (_e1710 - (_e572 * _e1791)))) / _e1682);
                                                            phi_2415_ = select(select(_e1791, (_e1791 + _e1799), (bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u)) <= _e1617)), _e1788, _e1787);
                                                        } else {
                                                            phi_2415_ = _e1788;
                                                        }
                                                        let _e1808 = phi_2415_;
                                                        let _e1810 = select(_e1521, _e1808, (_e1808 < _e1521));
                                                        let _e1812 = select(_e1513, _e1810, (_e1810 > _e1513));
                                                        let _e1813 = (1f / _e1465);
                                                        phi_2435_ = type_47(_e1812, (_e1459 * _e1813), (_e1463 * _e1813), ((_e1558 && (_e1812 >= _e742)) && (_e1812 <= _e1296.member_1)));
                                                        phi_2436_ = type_47();
                                                    } else {
                                                        phi_2435_ = type_47();
                                                        phi_2436_ = type_47(0f, 0f, 0f, _e1558);
                                                    }
                                                    let _e1822 = phi_2435_;
                                                    let _e1824 = phi_2436_;
                                                    phi_2439_ = _e1822;
                                                    phi_2440_ = _e1824;
                                                    phi_2441_ = select(true, false, _e1558);
                                                } else {
                                                    phi_2439_ = type_47();
                                                    phi_2440_ = type_47(0f, 0f, 0f, _e1449);
                                                    phi_2441_ = true;
                                                }
                                                let _e1827 = phi_2439_;
                                                let _e1829 = phi_2440_;
                                                let _e1831 = phi_2441_;
                                                if _e1831 {
                                                    phi_2445_ = _e1829;
                                                } else {
                                                    phi_2445_ = _e1827;
                                                }
                                                let _e1833 = phi_2445_;
                                                if _e1833.member_3 {
                                                    phi_2454_ = type_26(_e1833.member, _e1833.member_1, _e1833.member_2, _e1325);
                                                } else {
                                                    phi_2454_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1840 = phi_2454_;
                                                if (_e1840.member_3 != 4294967295u) {
                                                    if (_e1325 == _e170) {
                                                        phi_2789_ = false;
                                                    } else {
                                                        let _e1844 = (_e1325 < arrayLength((&global_5.member)));
                                                        if _e1844 {
                                                            if _e1844 {
                                                            } else {
                                                                phi_4633_ = true;
                                                                break;
                                                            }
                                                            let _e1846 = global_5.member[_e1325];
                                                            phi_2477_ = _e1846;
                                                        } else {
                                                            phi_2477_ = 4294967295u;
                                                        }
                                                        let _e1848 = phi_2477_;
                                                        let _e1849 = (_e1848 < arrayLength((&global_6.member)));
                                                        if _e1849 {
                                                            if _e1849 {
                                                            } else {
                                                                phi_4633_ = true;
                                                                break;
                                                            }
                                                            let _e1851 = global_6.member[_e1848];
                                                            phi_2491_ = _e1851;
                                                        } else {
                                                            phi_2491_ = 0i;
                                                        }
                                                        let _e1853 = phi_2491_;
                                                        let _e1854 = (_e1853 == 0i);
                                                        if _e1854 {
                                                            phi_2788_ = true;
                                                        } else {
                                                            if _e448 {
                                                                phi_2514_ = vec3<f32>(_e1392[0][0], _e1392[0][1], _e1392[0][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2513_ = vec3<f32>(_e1392[0][2], _e1392[0][0], _e1392[0][1]);
                                                                } else {
                                                                    phi_2513_ = vec3<f32>(_e1392[0][1], _e1392[0][2], _e1392[0][0]);
                                                                }
                                                                let _e1859 = phi_2513_;
                                                                phi_2514_ = _e1859;
                                                            }
                                                            let _e1862 = phi_2514_;
                                                            if _e448 {
                                                                phi_2533_ = vec3<f32>(_e1392[1][0], _e1392[1][1], _e1392[1][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2532_ = vec3<f32>(_e1392[1][2], _e1392[1][0], _e1392[1][1]);
                                                                } else {
                                                                    phi_2532_ = vec3<f32>(_e1392[1][1], _e1392[1][2], _e1392[1][0]);
                                                                }
                                                                let _e1867 = phi_2532_;
                                                                phi_2533_ = _e1867;
                                                            }
                                                            let _e1870 = phi_2533_;
                                                            if _e448 {
                                                                phi_2552_ = vec3<f32>(_e1392[2][0], _e1392[2][1], _e1392[2][2]);
                                                            } else {
                                                                if (_e424 == 1u) {
                                                                    phi_2551_ = vec3<f32>(_e1392[2][2], _e1392[2][0], _e1392[2][1]);
                                                                } else {
                                                                    phi_2551_ = vec3<f32>(_e1392[2][1], _e1392[2][2], _e1392[2][0]);
                                                                }
                                                                let _e1875 = phi_2551_;
                                                                phi_2552_ = _e1875;
                                                            }
                                                            let _e1878 = phi_2552_;
                                                            let _e1881 = (_e1870.x - _e1862.x);
                                                            let _e1884 = (_e1870.y - _e1862.y);
                                                            let _e1887 = (_e1870.z - _e1862.z);
                                                            let _e1889 = (_e1878.x - _e1862.x);
                                                            let _e1891 = (_e1878.y - _e1862.y);
                                                            let _e1893 = (_e1878.z - _e1862.z);
                                                            if (_e302.member_1 == 1u) {
                                                                phi_2588_ = (vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]) - _e1862);
                                                            } else {
                                                                phi_2588_ = vec3<f32>(_e302.member[0], _e302.member[1], _e302.member[2]);
                                                            }
                                                            let _e1908 = phi_2588_;
                                                            let _e1914 = bitcast<f32>((bitcast<u32>((_e1881 * _e1891)) ^ _e302.member_3[0]));
                                                            let _e1918 = bitcast<f32>((bitcast<u32>((_e1884 * _e1889)) ^ _e302.member_3[0]));
                                                            let _e1922 = bitcast<f32>((bitcast<u32>((_e1884 * _e1893)) ^ _e302.member_3[0]));
                                                            let _e1926 = bitcast<f32>((bitcast<u32>((_e1887 * _e1891)) ^ _e302.member_3[0]));
                                                            let _e1930 = bitcast<f32>((bitcast<u32>((_e1887 * _e1889)) ^ _e302.member_3[0]));
                                                            let _e1934 = bitcast<f32>((bitcast<u32>((_e1881 * _e1893)) ^ _e302.member_3[0]));
                                                            let _e1935 = (_e1922 - _e1926);
                                                            let _e1936 = (_e1930 - _e1934);
                                                            let _e1937 = (_e1914 - _e1918);
                                                            let _e1961 = (bitcast<f32>((bitcast<u32>(_e1922) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1926) & 2147483647u)));
                                                            let _e1968 = (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u)));
                                                            let _e1975 = (bitcast<f32>((bitcast<u32>(_e1914) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1918) & 2147483647u)));
                                                            if (_e302.member_2 == 0f) {
                                                                phi_2770_ = 0f;
                                                            } else {
                                                                let _e2005 = bitcast<f32>((bitcast<u32>(_e1935) & 2147483647u));
                                                                let _e2008 = bitcast<f32>((bitcast<u32>(_e1936) & 2147483647u));
                                                                let _e2011 = bitcast<f32>((bitcast<u32>(_e1937) & 2147483647u));
                                                                let _e2013 = select(_e2011, _e2008, (_e2008 > _e2011));
                                                                let _e2017 = select(_e2011, _e2008, (_e2008 < _e2011));
                                                                let _e2021 = select(_e2008, _e2005, (_e2005 < _e2008));
                                                                let _e2023 = select(_e2008, _e2005, (_e2005 > _e2008));
                                                                let _e2025 = select(_e2011, _e2023, (_e2023 < _e2011));
                                                                phi_2770_ = bitcast<f32>((bitcast<u32>((_e302.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2013, _e2005, (_e2005 > _e2013)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2025, _e2021, (_e2021 > _e2025)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2017, _e2005, (_e2005 < _e2017)))) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1961 + _e1968) + _e1975))) ^ _e302.member_3[0]))) * 1.0000005f)) ^ _e302.member_3[0])))) ^ _e302.member_3[0]));
                                                            }
                                                            let _e2052 = phi_2770_;
                                                            phi_2788_ = (_e1854 || !(((((bitcast<f32>((bitcast<u32>((_e1908.x * _e1935)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1908.y * _e1936)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1908.z * _e1937)) ^ _e302.member_3[0]))) * f32(-(_e1853))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1908.x) & 2147483647u)) * _e1961)) ^ _e302.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1908.y) & 2147483647u)) * _e1968)) ^ _e302.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1908.z) & 2147483647u)) * _e1975)) ^ _e302.member_3[0]))))) ^ _e302.member_3[0])) + _e2052) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2066 = phi_2788_;
                                                        phi_2789_ = _e2066;
                                                    }
                                                    let _e2068 = phi_2789_;
                                                    if _e2068 {
                                                        if (_e1840.member < _e1296.member.member) {
                                                            phi_2809_ = true;
                                                        } else {
                                                            if (_e1840.member == _e1296.member.member) {
                                                                phi_2808_ = (_e1840.member_3 < _e1296.member.member_3);
                                                            } else {
                                                                phi_2808_ = false;
                                                            }
                                                            let _e2078 = phi_2808_;
                                                            phi_2809_ = _e2078;
                                                        }
                                                        let _e2080 = phi_2809_;
                                                        if _e2080 {
                                                            phi_2815_ = type_44(_e1840, _e1840.member);
                                                        } else {
                                                            phi_2815_ = _e1296;
                                                        }
                                                        let _e2083 = phi_2815_;
                                                        phi_2816_ = _e2083;
                                                    } else {
                                                        phi_2816_ = _e1296;
                                                    }
                                                    let _e2085 = phi_2816_;
                                                    phi_2817_ = _e2085;
                                                } else {
                                                    phi_2817_ = _e1296;
                                                }
                                                let _e2087 = phi_2817_;
                                                phi_1549_ = _e2087;
                                            } else {
                                                phi_1549_ = type_44();
                                            }
                                            let _e2089 = phi_1549_;
                                            continue;
                                            continuing {
                                                phi_1548_ = _e2089;
                                                phi_1551_ = _e1311;
                                                phi_4633_ = _e784;
                                                break if !(_e1317);
                                            }
                                        }
                                        let _e2092 = phi_4633_;
                                        phi_4818_ = _e2092;
                                        if _e2092 {
                                            break;
                                        }
                                        let _e2094 = local_10;
                                        phi_4822_ = _e2092;
                                        let _e2406 = local_12;
                                        phi_4044_ = _e2406;
                                        phi_4045_ = false;
                                        phi_4046_ = _e827;
                                        phi_4047_ = select(_e829, 0u, (_e742 > _e2094.member_1));
                                    } else {
                                        if (_e827.member_1 >= _e103) {
                                            phi_3583_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e827.member_1 < _e103) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e840 = (_e424 * 2u);
                                            let _e842 = ((1u + _e840) % 7u);
                                            if (_e842 < 7u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e847 = global_10.member[_e827.member_1][_e842];
                                            let _e849 = ((_e840 + 2u) % 7u);
                                            if (_e849 < 7u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e854 = global_10.member[_e827.member_1][_e849];
                                            let _e855 = (_e423 * 2u);
                                            let _e857 = ((1u + _e855) % 7u);
                                            if (_e857 < 7u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e862 = global_10.member[_e827.member_1][_e857];
                                            let _e864 = ((_e855 + 2u) % 7u);
                                            if (_e864 < 7u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e869 = global_10.member[_e827.member_1][_e864];
                                            let _e870 = (_e425 * 2u);
                                            let _e872 = ((1u + _e870) % 7u);
                                            if (_e872 < 7u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e877 = global_10.member[_e827.member_1][_e872];
                                            let _e879 = ((_e870 + 2u) % 7u);
                                            if (_e879 < 7u) {
                                            } else {
                                                phi_4818_ = true;
                                                break;
                                            }
                                            let _e884 = global_10.member[_e827.member_1][_e879];
                                            let _e907 = (bitcast<f32>((bitcast<u32>((_e827.member.member_1.x - _e827.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e908 = (bitcast<f32>((bitcast<u32>((_e827.member.member_1.y - _e827.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e909 = (bitcast<f32>((bitcast<u32>((_e827.member.member_1.z - _e827.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e911 = select(_e161, _e907, (_e907 > _e161));
                                            let _e913 = select(_e161, _e908, (_e908 > _e161));
                                            let _e915 = select(_e161, _e909, (_e909 > _e161));
                                            let _e946 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e847 & 2097151u))) - 8388608f) * _e911));
                                            let _e951 = (bitcast<i32>((_e847 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e954 = bitcast<f32>((_e946 & bitcast<u32>(_e951)));
                                            let _e955 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e862 & 2097151u))) - 8388608f) * _e913));
                                            let _e960 = (bitcast<i32>((_e862 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e963 = bitcast<f32>((_e955 & bitcast<u32>(_e960)));
                                            let _e964 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e877 & 2097151u))) - 8388608f) * _e915));
                                            let _e969 = (bitcast<i32>((_e877 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e972 = bitcast<f32>((_e964 & bitcast<u32>(_e969)));
                                            let _e976 = bitcast<f32>((_e946 & bitcast<u32>(~(_e951))));
                                            let _e980 = bitcast<f32>((_e955 & bitcast<u32>(~(_e960))));
                                            let _e984 = bitcast<f32>((_e964 & bitcast<u32>(~(_e969))));
                                            let _e985 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e854 & 2097151u))) - 8388608f) * _e911));
                                            let _e990 = (bitcast<i32>((_e854 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e993 = bitcast<f32>((_e985 & bitcast<u32>(_e990)));
                                            let _e994 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e869 & 2097151u))) - 8388608f) * _e913));
                                            let _e999 = (bitcast<i32>((_e869 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1002 = bitcast<f32>((_e994 & bitcast<u32>(_e999)));
                                            let _e1003 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e884 & 2097151u))) - 8388608f) * _e915));
                                            let _e1008 = (bitcast<i32>((_e884 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1011 = bitcast<f32>((_e1003 & bitcast<u32>(_e1008)));
                                            let _e1015 = bitcast<f32>((_e985 & bitcast<u32>(~(_e990))));
                                            let _e1019 = bitcast<f32>((_e994 & bitcast<u32>(~(_e999))));
                                            let _e1023 = bitcast<f32>((_e1003 & bitcast<u32>(~(_e1008))));
                                            let _e1053 = global_10.member[_e827.member_1][0u];
                                            let _e1057 = global_10.member[_e827.member_1][2u];
                                            let _e1061 = global_10.member[_e827.member_1][4u];
                                            let _e1065 = global_10.member[_e827.member_1][6u];
                                            let _e1077 = (((_e1057 >> bitcast<u32>(22i)) | ((_e1061 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1065 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1078 = (_e1053 & 268435455u);
                                            let _e1079 = (_e1077 & 268435455u);
                                            let _e1082 = ((_e1053 >> bitcast<u32>(28u)) & 7u);
                                            let _e1090 = ((_e1053 >> bitcast<u32>(31i)) | (((_e1077 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1091 = (_e1082 != 0u);
                                            if (_e1082 == 0u) {
                                                phi_3545_ = _e1078;
                                            } else {
                                                if (_e1082 == 7u) {
                                                    phi_3544_ = 2147483648u;
                                                } else {
                                                    phi_3544_ = ((2147483648u | (_e1082 << bitcast<u32>(28u))) | (_e1079 & 268435455u));
                                                }
                                                let _e1100 = phi_3544_;
                                                phi_3545_ = _e1100;
                                            }
                                            let _e1102 = phi_3545_;
                                            if _e1091 {
                                                let _e1103 = (_e1082 != 7u);
                                                if _e1103 {
                                                    phi_3555_ = (_e1079 + _e1082);
                                                } else {
                                                    phi_3555_ = u32();
                                                }
                                                let _e1106 = phi_3555_;
                                                phi_3557_ = _e1106;
                                                phi_3558_ = select(true, false, _e1103);
                                            } else {
                                                phi_3557_ = u32();
                                                phi_3558_ = true;
                                            }
                                            let _e1109 = phi_3557_;
                                            let _e1111 = phi_3558_;
                                            if (_e1090 == 0u) {
                                                phi_3579_ = (_e1078 + select(0u, 1u, !(_e1091)));
                                            } else {
                                                if (_e1090 == 7u) {
                                                    phi_3578_ = 2147483648u;
                                                } else {
                                                    phi_3578_ = ((2147483648u | (_e1090 << bitcast<u32>(28u))) | (select(_e1109, _e1079, _e1111) & 268435455u));
                                                }
                                                let _e1124 = phi_3578_;
                                                phi_3579_ = _e1124;
                                            }
                                            let _e1126 = phi_3579_;
                                            phi_3583_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e827.member.member.x + _e954), (_e827.member.member.x + _e976), (_e827.member.member_1.x - _e993), (_e827.member.member_1.x - _e1015)), vec4<f32>((_e827.member.member.y + _e963), (_e827.member.member.y + _e980), (_e827.member.member_1.y - _e1002), (_e827.member.member_1.y - _e1019)), vec4<f32>((_e827.member.member.z + _e972), (_e827.member.member.z + _e984), (_e827.member.member_1.z - _e1011), (_e827.member.member_1.z - _e1023))), type_63(type_38((_e827.member.member + vec4<f32>(_e954, _e963, _e972, 0f)), (_e827.member.member_1 - vec4<f32>(_e993, _e1002, _e1011, 0f))), _e1102), type_63(type_38((_e827.member.member + vec4<f32>(_e976, _e980, _e984, 0f)), (_e827.member.member_1 - vec4<f32>(_e1015, _e1019, _e1023, 0f))), _e1126));
                                        }
                                        let _e1131 = phi_3583_;
                                        let _e1143 = ((_e1131.member[0].x - _e509) * _e512);
                                        let _e1144 = ((_e1131.member[0].y - _e509) * _e512);
                                        let _e1145 = ((_e1131.member[0].z - _e510) * _e512);
                                        let _e1146 = ((_e1131.member[0].w - _e510) * _e512);
                                        let _e1156 = ((_e1131.member[1].x - _e573) * _e576);
                                        let _e1157 = ((_e1131.member[1].y - _e573) * _e576);
                                        let _e1158 = ((_e1131.member[1].z - _e574) * _e576);
                                        let _e1159 = ((_e1131.member[1].w - _e574) * _e576);
                                        let _e1169 = ((_e1131.member[2].x - _e637) * _e640);
                                        let _e1170 = ((_e1131.member[2].y - _e637) * _e640);
                                        let _e1171 = ((_e1131.member[2].z - _e638) * _e640);
                                        let _e1172 = ((_e1131.member[2].w - _e638) * _e640);
                                        let _e1174 = select(_e1171, _e1169, (_e1169 < _e1171));
                                        let _e1176 = select(_e1172, _e1170, (_e1170 < _e1172));
                                        let _e1178 = select(_e1171, _e1169, (_e1169 > _e1171));
                                        let _e1180 = select(_e1172, _e1170, (_e1170 > _e1172));
                                        let _e1182 = select(_e1145, _e1143, (_e1143 < _e1145));
                                        let _e1184 = select(_e1146, _e1144, (_e1144 < _e1146));
                                        let _e1186 = select(_e1158, _e1156, (_e1156 < _e1158));
                                        let _e1188 = select(_e1159, _e1157, (_e1157 < _e1159));
                                        let _e1190 = select(_e1186, _e1182, (_e1182 > _e1186));
                                        let _e1192 = select(_e1188, _e1184, (_e1184 > _e1188));
                                        let _e1194 = select(_e1174, _e1190, (_e1190 > _e1174));
                                        let _e1196 = select(_e1176, _e1192, (_e1192 > _e1176));
                                        let _e1198 = select(_e1145, _e1143, (_e1143 > _e1145));
                                        let _e1200 = select(_e1146, _e1144, (_e1144 > _e1146));
                                        let _e1202 = select(_e1158, _e1156, (_e1156 > _e1158));
                                        let _e1204 = select(_e1159, _e1157, (_e1157 > _e1159));
                                        let _e1206 = select(_e1202, _e1198, (_e1198 < _e1202));
                                        let _e1208 = select(_e1204, _e1200, (_e1200 < _e1204));
                                        let _e1213 = -(_e1174);
                                        let _e1214 = -(_e1176);
                                        let _e1221 = (select(_e1178, _e1206, (_e1206 < _e1178)) + (select(_e1213, _e1178, (_e1178 > _e1213)) * 0.0000019073523f));
                                        let _e1222 = (select(_e1180, _e1208, (_e1208 < _e1180)) + (select(_e1214, _e1180, (_e1180 > _e1214)) * 0.0000019073523f));
                                        let _e1224 = select(_e742, _e1194, (_e1194 > _e742));
                                        let _e1226 = select(_e742, _e1196, (_e1196 > _e742));
                                        let _e1231 = (_e1224 <= select(_e786.member_1, _e1221, (_e1221 < _e786.member_1)));
                                        let _e1232 = (_e1226 <= select(_e786.member_1, _e1222, (_e1222 < _e786.member_1)));
                                        let _e1233 = (_e1224 <= _e1226);
                                        if _e1231 {
                                            if _e1232 {
                                                if _e1233 {
                                                    phi_3945_ = _e1131.member_2;
                                                } else {
                                                    phi_3945_ = _e1131.member_1;
                                                }
                                                let _e1237 = phi_3945_;
                                                let _e1258 = (_e829 % 128u);
                                                let _e1259 = (_e1258 < 128u);
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_8[_e1258] = _e1237.member_1;
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_7[_e1258] = _e1237.member.member.x;
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_6[_e1258] = _e1237.member.member.y;
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_5[_e1258] = _e1237.member.member.z;
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_4[_e1258] = _e1237.member.member_1.x;
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_3[_e1258] = _e1237.member.member_1.y;
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_2[_e1258] = _e1237.member.member_1.z;
                                                if _e1259 {
                                                } else {
                                                    phi_4818_ = true;
                                                    break;
                                                }
                                                local_9[_e1258] = select(_e1224, _e1226, _e1233);
                                                if _e1233 {
                                                    phi_4021_ = _e1131.member_1;
                                                } else {
                                                    phi_4021_ = _e1131.member_2;
                                                }
                                                let _e1272 = phi_4021_;
                                                phi_4022_ = _e1272;
                                                phi_4023_ = (_e829 + 1u);
                                            } else {
                                                phi_4022_ = type_63();
                                                phi_4023_ = u32();
                                            }
                                            let _e1274 = phi_4022_;
                                            let _e1276 = phi_4023_;
                                            phi_4025_ = _e1274;
                                            phi_4026_ = _e1276;
                                            phi_4027_ = select(true, false, _e1232);
                                        } else {
                                            phi_4025_ = type_63();
                                            phi_4026_ = u32();
                                            phi_4027_ = true;
                                        }
                                        let _e1279 = phi_4025_;
                                        let _e1281 = phi_4026_;
                                        let _e1283 = phi_4027_;
                                        if _e1283 {
                                            if _e1231 {
                                                phi_4036_ = _e1131.member_1;
                                            } else {
                                                phi_4036_ = _e1131.member_2;
                                            }
                                            let _e1287 = phi_4036_;
                                            phi_4041_ = select(_e1232, true, _e1231);
                                            phi_4042_ = _e1287;
                                        } else {
                                            phi_4041_ = _e825;
                                            phi_4042_ = _e1279;
                                        }
                                        let _e1290 = phi_4041_;
                                        let _e1292 = phi_4042_;
                                        phi_4822_ = _e784;
                                        phi_4044_ = _e786;
                                        phi_4045_ = _e1290;
                                        phi_4046_ = _e1292;
                                        phi_4047_ = select(_e1281, _e829, _e1283);
                                    }
                                    let _e2099 = phi_4822_;
                                    let _e2101 = phi_4044_;
                                    let _e2103 = phi_4045_;
                                    let _e2105 = phi_4046_;
                                    let _e2107 = phi_4047_;
                                    phi_4821_ = _e2099;
                                    phi_4048_ = _e2101;
                                    phi_4049_ = _e2103;
                                    phi_4050_ = _e2105;
                                    phi_4051_ = _e2107;
                                    phi_4052_ = (_e794 - 1u);
                                } else {
                                    phi_4821_ = _e784;
                                    phi_4048_ = _e786;
                                    phi_4049_ = _e825;
                                    phi_4050_ = _e827;
                                    phi_4051_ = _e829;
                                    phi_4052_ = _e794;
                                }
                                let _e2109 = phi_4821_;
                                let _e2111 = phi_4048_;
                                let _e2113 = phi_4049_;
                                let _e2115 = phi_4050_;
                                let _e2117 = phi_4051_;
                                let _e2119 = phi_4052_;
                                phi_4820_ = _e2109;
                                phi_4053_ = _e2111;
                                phi_4054_ = _e2113;
                                phi_4055_ = _e2115;
                                phi_4056_ = _e2117;
                                phi_4057_ = _e2119;
                            } else {
                                phi_4820_ = _e784;
                                phi_4053_ = type_44();
                                phi_4054_ = bool();
                                phi_4055_ = type_63();
                                phi_4056_ = u32();
                                phi_4057_ = u32();
                            }
                            let _e2121 = phi_4820_;
                            let _e2123 = phi_4053_;
                            let _e2125 = phi_4054_;
                            let _e2127 = phi_4055_;
                            let _e2129 = phi_4056_;
                            let _e2131 = phi_4057_;
                            phi_4819_ = _e2121;
                            phi_1423_ = _e2123;
                            phi_1426_ = _e2125;
                            phi_1428_ = _e2127;
                            phi_1430_ = _e2129;
                            phi_1432_ = _e2131;
                            phi_4058_ = _e798;
                        } else {
                            phi_4819_ = _e784;
                            phi_1423_ = type_44();
                            phi_1426_ = bool();
                            phi_1428_ = type_63();
                            phi_1430_ = u32();
                            phi_1432_ = u32();
                            phi_4058_ = false;
                        }
                        let _e2133 = phi_4819_;
                        let _e2135 = phi_1423_;
                        let _e2137 = phi_1426_;
                        let _e2139 = phi_1428_;
                        let _e2141 = phi_1430_;
                        let _e2143 = phi_1432_;
                        let _e2145 = phi_4058_;
                        continue;
                        continuing {
                            phi_4639_ = _e2133;
                            phi_1422_ = _e2135;
                            phi_1425_ = _e2137;
                            phi_1427_ = _e2139;
                            phi_1429_ = _e2141;
                            phi_1431_ = _e2143;
                            phi_4818_ = _e2133;
                            break if !(_e2145);
                        }
                    }
                    let _e2148 = phi_4818_;
                    if _e2148 {
                        break;
                    }
                    let _e2150 = local_11;
                    if (_e2150.member.member_3 != 4294967295u) {
                        let _e2155 = bitcast<u32>(_e2150.member.member);
                        let _e2159 = (bitcast<i32>((_e2155 >> bitcast<u32>(23i))) & 255i);
                        let _e2160 = (_e2159 + _e426);
                        if (_e2159 == 255i) {
                            phi_4117_ = _e2150.member.member;
                        } else {
                            if (_e2159 > 0i) {
                                if (_e2160 > 0i) {
                                    let _e2164 = (_e2160 < 255i);
                                    if _e2164 {
                                        phi_4096_ = bitcast<f32>((_e2155 + bitcast<u32>((_e426 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4096_ = f32();
                                    }
                                    let _e2171 = phi_4096_;
                                    phi_4098_ = _e2171;
                                    phi_4099_ = select(true, false, _e2164);
                                } else {
                                    phi_4098_ = f32();
                                    phi_4099_ = true;
                                }
                                let _e2174 = phi_4098_;
                                let _e2176 = phi_4099_;
                                phi_4100_ = _e2174;
                                phi_4101_ = _e2176;
                            } else {
                                phi_4100_ = f32();
                                phi_4101_ = true;
                            }
                            let _e2178 = phi_4100_;
                            let _e2180 = phi_4101_;
                            if _e2180 {
                                let _e2181 = (_e2155 & 2147483648u);
                                let _e2188 = ((_e2155 & 8388607u) | (select(0u, 1u, ((_e2155 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2192 = (_e2188 == 0u);
                                if _e2192 {
                                    phi_4591_ = bitcast<f32>(_e2181);
                                } else {
                                    let _e2197 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2188)), 32u, _e2192) - 8u);
                                    let _e2200 = (_e2188 << bitcast<u32>((_e2197 & 31u)));
                                    let _e2202 = ((_e2160 + select(0i, 1i, (_e2159 == 0i))) - bitcast<i32>(_e2197));
                                    if (_e2202 >= 255i) {
                                        phi_4581_ = bitcast<f32>((_e2181 | 2139095040u));
                                        phi_4582_ = f32();
                                        phi_4583_ = true;
                                    } else {
                                        let _e2204 = (_e2202 > 0i);
                                        if _e2204 {
                                            phi_4575_ = bitcast<f32>(((_e2181 | (bitcast<u32>(_e2202) << bitcast<u32>(23i))) | (_e2200 & 8388607u)));
                                            phi_4576_ = f32();
                                        } else {
                                            if (_e2202 < -24i) {
                                                phi_4541_ = 26u;
                                            } else {
                                                phi_4541_ = bitcast<u32>((1i - _e2202));
                                            }
                                            let _e2209 = phi_4541_;
                                            let _e2210 = (_e2209 & 31u);
                                            let _e2212 = (_e2200 >> bitcast<u32>(_e2210));
                                            let _e2216 = (_e2200 & ((1u << bitcast<u32>(_e2210)) - 1u));
                                            let _e2220 = (1u << bitcast<u32>(((_e2209 - 1u) & 31u)));
                                            if (_e2216 > _e2220) {
                                                phi_4562_ = true;
                                            } else {
                                                if (_e2216 == _e2220) {
                                                    phi_4559_ = ((_e2212 & 1u) == 1u);
                                                } else {
                                                    phi_4559_ = false;
                                                }
                                                let _e2226 = phi_4559_;
                                                phi_4562_ = _e2226;
                                            }
                                            let _e2228 = phi_4562_;
                                            phi_4575_ = f32();
                                            phi_4576_ = bitcast<f32>((_e2181 | (_e2212 + select(0u, 1u, _e2228))));
                                        }
                                        let _e2241 = phi_4575_;
                                        let _e2243 = phi_4576_;
                                        phi_4581_ = _e2241;
                                        phi_4582_ = _e2243;
                                        phi_4583_ = _e2204;
                                    }
                                    let _e2247 = phi_4581_;
                                    let _e2249 = phi_4582_;
                                    let _e2251 = phi_4583_;
                                    phi_4591_ = select(_e2249, _e2247, _e2251);
                                }
                                let _e2255 = phi_4591_;
                                phi_4116_ = _e2255;
                            } else {
                                phi_4116_ = _e2178;
                            }
                            let _e2257 = phi_4116_;
                            phi_4117_ = _e2257;
                        }
                        let _e2259 = phi_4117_;
                        let _e2260 = bitcast<u32>(_e2259);
                        if ((_e2260 & 2147483647u) >= 2139095040u) {
                            phi_4129_ = bitcast<f32>(((_e2260 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4129_ = _e2259;
                        }
                        let _e2267 = phi_4129_;
                        phi_4134_ = type_26(_e2267, _e2150.member.member_1, _e2150.member.member_2, _e2150.member.member_3);
                    } else {
                        phi_4134_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2272 = phi_4134_;
                    if _e303 {
                    } else {
                        break;
                    }
                    global_8.member[_e149] = _e2272;
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e2276 = select(0u, 1u, (_e370 <= _e380));
                    if (_e2276 > 0u) {
                        let _e2278 = (1u < _e117);
                        if _e2278 {
                            if (0u < _e117) {
                            } else {
                                break;
                            }
                            let _e2282 = atomicAdd((&global_9.member[0u]), _e2276);
                            if ((_e2282 + _e2276) < _e2282) {
                                if _e2278 {
                                } else {
                                    break;
                                }
                                let _e2287 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2290 = select(0u, 1u, (_e2272.member_3 != 4294967295u));
                    if (_e2290 > 0u) {
                        let _e2292 = (3u < _e117);
                        if _e2292 {
                            if (2u < _e117) {
                            } else {
                                break;
                            }
                            let _e2296 = atomicAdd((&global_9.member[2u]), _e2290);
                            if ((_e2296 + _e2290) < _e2296) {
                                if _e2292 {
                                } else {
                                    break;
                                }
                                let _e2301 = atomicAdd((&global_9.member[3u]), 1u);
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
