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

struct type_24 {
    member: array<array<u32, 2>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: type_28,
    member_1: f32,
}

struct type_41 {
    member: array<type_29>,
}

struct type_43 {
    member: type_36,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_32,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_45;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_397_: i32;
    var phi_398_: i32;
    var phi_408_: bool;
    var phi_418_: u32;
    var phi_419_: u32;
    var phi_421_: bool;
    var phi_426_: u32;
    var phi_438_: i32;
    var phi_458_: i32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_522_: f32;
    var phi_528_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_704_: f32;
    var phi_715_: f32;
    var phi_724_: f32;
    var phi_730_: f32;
    var phi_770_: f32;
    var phi_776_: f32;
    var phi_828_: f32;
    var phi_839_: f32;
    var phi_894_: i32;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_954_: i32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_4295_: bool;
    var phi_1076_: type_43;
    var phi_1079_: type_50;
    var phi_1081_: u32;
    var phi_1083_: bool;
    var phi_1085_: u32;
    var phi_1096_: bool;
    var phi_1182_: type_50;
    var phi_1183_: bool;
    var phi_1184_: u32;
    var phi_3318_: u32;
    var phi_3324_: u32;
    var phi_3578_: u32;
    var phi_3579_: u32;
    var phi_3589_: u32;
    var phi_3591_: u32;
    var phi_3592_: bool;
    var phi_3612_: u32;
    var phi_3613_: u32;
    var phi_3617_: type_51;
    var phi_3961_: type_50;
    var phi_4038_: type_50;
    var phi_4039_: type_50;
    var phi_4040_: u32;
    var phi_4042_: type_50;
    var phi_4043_: u32;
    var phi_4044_: bool;
    var phi_4053_: type_50;
    var phi_4058_: type_50;
    var phi_4059_: bool;
    var phi_1203_: type_43;
    var phi_1206_: type_8;
    var phi_1207_: type_8;
    var phi_1229_: type_8;
    var phi_1273_: u32;
    var phi_1279_: u32;
    var phi_1289_: u32;
    var phi_1305_: u32;
    var phi_1338_: u32;
    var phi_1344_: u32;
    var phi_1789_: u32;
    var phi_1807_: u32;
    var phi_1825_: u32;
    var phi_1845_: u32;
    var phi_1863_: u32;
    var phi_1881_: u32;
    var phi_1901_: u32;
    var phi_1919_: u32;
    var phi_1937_: u32;
    var phi_1506_: u32;
    var phi_1521_: u32;
    var phi_1531_: u32;
    var phi_1552_: u32;
    var phi_1573_: u32;
    var phi_1600_: u32;
    var phi_1615_: u32;
    var phi_1625_: u32;
    var phi_1646_: u32;
    var phi_1667_: u32;
    var phi_1694_: u32;
    var phi_1709_: u32;
    var phi_1719_: u32;
    var phi_1740_: u32;
    var phi_1761_: u32;
    var phi_1368_: u32;
    var phi_1414_: u32;
    var phi_1460_: u32;
    var phi_1943_: array<array<f32, 3>, 3>;
    var phi_2060_: bool;
    var phi_2089_: bool;
    var phi_2490_: f32;
    var phi_2491_: f32;
    var phi_2492_: f32;
    var phi_2493_: f32;
    var phi_2494_: vec3<f32>;
    var phi_2495_: vec3<f32>;
    var phi_2496_: vec3<f32>;
    var phi_2497_: vec3<f32>;
    var phi_2528_: bool;
    var phi_2537_: vec3<f32>;
    var phi_2702_: f32;
    var phi_2704_: f32;
    var phi_2705_: bool;
    var phi_2725_: f32;
    var phi_2726_: f32;
    var phi_2749_: type_28;
    var phi_2751_: type_28;
    var phi_2752_: bool;
    var phi_2756_: type_28;
    var phi_2757_: type_28;
    var phi_2758_: type_28;
    var phi_2759_: bool;
    var phi_2763_: type_28;
    var phi_2764_: bool;
    var phi_2765_: type_28;
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_2768_: type_28;
    var phi_2769_: bool;
    var phi_2770_: bool;
    var phi_2778_: type_28;
    var phi_2779_: bool;
    var phi_2783_: type_28;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var phi_2816_: type_43;
    var phi_2817_: type_43;
    var phi_2818_: type_43;
    var phi_1204_: type_43;
    var phi_4289_: bool;
    var phi_4500_: bool;
    var phi_4061_: type_43;
    var phi_4062_: type_50;
    var phi_4063_: bool;
    var phi_4064_: u32;
    var phi_4499_: bool;
    var phi_4065_: type_43;
    var phi_4066_: type_50;
    var phi_4067_: u32;
    var phi_4068_: bool;
    var phi_4069_: u32;
    var phi_4498_: bool;
    var phi_4070_: type_43;
    var phi_4071_: type_50;
    var phi_4072_: u32;
    var phi_4073_: bool;
    var phi_4074_: u32;
    var phi_4497_: bool;
    var phi_1077_: type_43;
    var phi_1080_: type_50;
    var phi_1082_: u32;
    var phi_1084_: bool;
    var phi_1086_: u32;
    var phi_4075_: bool;
    var phi_4496_: bool;
    var local_10: type_43;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_3.member));
            let _e99 = arrayLength((&global_5.member));
            let _e107 = global_2.member[0u][0u];
            let _e111 = global_2.member[0u][1u];
            let _e115 = global_2.member[0u][2u];
            let _e119 = global_2.member[0u][3u];
            let _e123 = global_2.member[1u][0u];
            let _e127 = global_2.member[1u][1u];
            let _e131 = global_2.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_4.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_4.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_4.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_4.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_4.member[_e153].member_1;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e223 = global_4.member[_e153].member_3;
                    let _e224 = bitcast<u32>(_e223);
                    let _e225 = (_e224 & 2147483647u);
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && (_e225 <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_397_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_397_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_397_;
                        phi_398_ = _e246;
                    } else {
                        phi_398_ = 0i;
                    }
                    let _e248 = phi_398_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_408_ = true;
                    } else {
                        phi_408_ = (_e172 == _e204);
                    }
                    let _e252 = phi_408_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_418_ = _e254;
                        phi_419_ = _e254;
                        phi_421_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_418_ = u32();
                        phi_419_ = 0u;
                        phi_421_ = true;
                    }
                    let _e258 = phi_418_;
                    let _e260 = phi_419_;
                    let _e262 = phi_421_;
                    if _e262 {
                        phi_426_ = (_e260 + 1u);
                    } else {
                        phi_426_ = 0u;
                    }
                    let _e266 = phi_426_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_438_ = -126i;
                    } else {
                        phi_438_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_438_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_458_ = -126i;
                    } else {
                        phi_458_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_458_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_4.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_476_ = _e305[0];
                    } else {
                        phi_476_ = _e305[1];
                    }
                    let _e310 = phi_476_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_482_ = _e305[2];
                    } else {
                        phi_482_ = _e310;
                    }
                    let _e314 = phi_482_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_4.member[_e153].member_2;
                    if _e306 {
                        phi_522_ = _e332[0];
                    } else {
                        phi_522_ = _e332[1];
                    }
                    let _e336 = phi_522_;
                    if _e311 {
                        phi_528_ = _e332[2];
                    } else {
                        phi_528_ = _e336;
                    }
                    let _e339 = phi_528_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_580_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e368 = phi_580_;
                    let _e369 = (_e331 + _e368);
                    let _e370 = (_e331 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_591_ = 38685626000000000000000000f;
                    } else {
                        phi_591_ = (1f / _e356);
                    }
                    let _e374 = phi_591_;
                    let _e375 = (_e266 == 0u);
                    if _e375 {
                        phi_600_ = _e305[0];
                    } else {
                        phi_600_ = _e305[1];
                    }
                    let _e379 = phi_600_;
                    let _e380 = (_e266 == 2u);
                    if _e380 {
                        phi_606_ = _e305[2];
                    } else {
                        phi_606_ = _e379;
                    }
                    let _e383 = phi_606_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e278) * select(0.00000011920929f, 1f, _e386)) * _e284);
                    if _e375 {
                        phi_646_ = _e332[0];
                    } else {
                        phi_646_ = _e332[1];
                    }
                    let _e404 = phi_646_;
                    if _e380 {
                        phi_652_ = _e332[2];
                    } else {
                        phi_652_ = _e404;
                    }
                    let _e407 = phi_652_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e295) * select(0.00000011920929f, 1f, _e410)) * _e301);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_704_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_704_ = 0f;
                    }
                    let _e436 = phi_704_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_715_ = 38685626000000000000000000f;
                    } else {
                        phi_715_ = (1f / _e424);
                    }
                    let _e442 = phi_715_;
                    let _e443 = (_e268 == 0u);
                    if _e443 {
                        phi_724_ = _e305[0];
                    } else {
                        phi_724_ = _e305[1];
                    }
                    let _e447 = phi_724_;
                    let _e448 = (_e268 == 2u);
                    if _e448 {
                        phi_730_ = _e305[2];
                    } else {
                        phi_730_ = _e447;
                    }
                    let _e451 = phi_730_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e278) * select(0.00000011920929f, 1f, _e454)) * _e284);
                    if _e443 {
                        phi_770_ = _e332[0];
                    } else {
                        phi_770_ = _e332[1];
                    }
                    let _e472 = phi_770_;
                    if _e448 {
                        phi_776_ = _e332[2];
                    } else {
                        phi_776_ = _e472;
                    }
                    let _e475 = phi_776_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e295) * select(0.00000011920929f, 1f, _e478)) * _e301);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e496 {
                        let _e500 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                        phi_828_ = select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f));
                    } else {
                        phi_828_ = 0f;
                    }
                    let _e504 = phi_828_;
                    let _e505 = (_e468 + _e504);
                    let _e506 = (_e468 - _e504);
                    let _e507 = select(_e492, 0f, _e496);
                    if _e496 {
                        phi_839_ = 38685626000000000000000000f;
                    } else {
                        phi_839_ = (1f / _e492);
                    }
                    let _e510 = phi_839_;
                    let _e513 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e516 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                    let _e518 = select(_e516, _e513, (_e513 > _e516));
                    let _e521 = bitcast<f32>((bitcast<u32>(_e468) & 2147483647u));
                    let _e524 = (_e135 + _e248);
                    if (_e229 && (select(_e521, _e518, (_e518 > _e521)) <= 1099511600000f)) {
                        let _e534 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e537 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e541 = (_e534 == 0u);
                        let _e544 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e534)), 32u, _e541)) - 8i);
                        if (_e537 == 255i) {
                            phi_894_ = 255i;
                        } else {
                            phi_894_ = (((_e537 + select(0i, 1i, (_e537 == 0i))) - _e544) + _e524);
                        }
                        let _e552 = phi_894_;
                        let _e562 = (_e552 <= 0i);
                        if _e562 {
                            phi_917_ = u32();
                        } else {
                            if _e541 {
                                phi_916_ = u32();
                            } else {
                                phi_916_ = select(((bitcast<u32>(_e552) << bitcast<u32>(23i)) | ((_e534 << bitcast<u32>(((_e544 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e552 >= 255i));
                            }
                            let _e566 = phi_916_;
                            phi_917_ = _e566;
                        }
                        let _e568 = phi_917_;
                        let _e580 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e583 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e587 = (_e580 == 0u);
                        let _e590 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e580)), 32u, _e587)) - 8i);
                        if (_e583 == 255i) {
                            phi_954_ = 255i;
                        } else {
                            phi_954_ = (((_e583 + select(0i, 1i, (_e583 == 0i))) - _e590) + _e524);
                        }
                        let _e598 = phi_954_;
                        let _e608 = (_e598 <= 0i);
                        if _e608 {
                            phi_977_ = u32();
                        } else {
                            if _e587 {
                                phi_976_ = u32();
                            } else {
                                phi_976_ = select(((bitcast<u32>(_e598) << bitcast<u32>(23i)) | ((_e580 << bitcast<u32>(((_e590 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e598 >= 255i));
                            }
                            let _e612 = phi_976_;
                            phi_977_ = _e612;
                        }
                        let _e614 = phi_977_;
                        phi_985_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e614, 0u, select(_e587, true, _e608))));
                        phi_986_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e568, 0u, select(_e541, true, _e562))));
                    } else {
                        phi_985_ = 0f;
                        phi_986_ = 1f;
                    }
                    let _e620 = phi_985_;
                    let _e622 = phi_986_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e627 = (_e267 % 3u);
                    let _e628 = (_e627 < 3u);
                    if _e628 {
                    } else {
                        break;
                    }
                    let _e630 = local_1[_e627];
                    let _e633 = (_e266 % 3u);
                    let _e634 = (_e633 < 3u);
                    if _e634 {
                    } else {
                        break;
                    }
                    let _e636 = local_1[_e633];
                    let _e639 = (_e268 % 3u);
                    let _e640 = (_e639 < 3u);
                    if _e640 {
                    } else {
                        break;
                    }
                    let _e642 = local_1[_e639];
                    if _e628 {
                    } else {
                        break;
                    }
                    let _e647 = local[_e627];
                    if _e634 {
                    } else {
                        break;
                    }
                    let _e651 = local[_e633];
                    if _e640 {
                    } else {
                        break;
                    }
                    let _e655 = local[_e639];
                    phi_4295_ = false;
                    phi_1076_ = type_43(type_36(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e620), 0u, 0u);
                    phi_1079_ = type_50(type_32(vec4<f32>((f32(_e630) * _e147), (f32(_e636) * _e147), (f32(_e642) * _e147), 0f), vec4<f32>((f32(_e647) * _e147), (f32(_e651) * _e147), (f32(_e655) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_1081_ = ((3u * _e96) + 1u);
                    phi_1083_ = (_e622 <= _e620);
                    phi_1085_ = 0u;
                    loop {
                        let _e665 = phi_4295_;
                        let _e667 = phi_1076_;
                        let _e669 = phi_1079_;
                        let _e671 = phi_1081_;
                        let _e673 = phi_1083_;
                        let _e675 = phi_1085_;
                        local_10 = _e667;
                        local_11 = _e667;
                        if _e673 {
                            phi_1096_ = true;
                        } else {
                            phi_1096_ = (_e675 > 0u);
                        }
                        let _e678 = phi_1096_;
                        if _e678 {
                            let _e679 = (_e671 > 0u);
                            if _e679 {
                                if _e673 {
                                    phi_1182_ = _e669;
                                    phi_1183_ = _e673;
                                    phi_1184_ = _e675;
                                } else {
                                    let _e680 = (_e675 - 1u);
                                    let _e681 = (_e680 % 128u);
                                    let _e682 = (_e681 < 128u);
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e684 = local_7[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e686 = local_6[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e688 = local_5[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e690 = local_4[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e692 = local_3[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e694 = local_2[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e699 = local_8[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e702 = local_9[_e681];
                                    phi_1182_ = type_50(type_32(vec4<f32>(_e684, _e686, _e688, 0f), vec4<f32>(_e690, _e692, _e694, 0f)), _e699);
                                    phi_1183_ = (_e702 <= _e667.member.member_1);
                                    phi_1184_ = _e680;
                                }
                                let _e707 = phi_1182_;
                                let _e709 = phi_1183_;
                                let _e711 = phi_1184_;
                                if _e709 {
                                    let _e716 = (_e707.member_1 & 268435455u);
                                    if ((_e707.member_1 & 2147483648u) != 0u) {
                                        phi_1203_ = _e667;
                                        phi_1206_ = type_8(0u, ((_e707.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1189 = phi_1203_;
                                            let _e1191 = phi_1206_;
                                            local_12 = _e1189;
                                            if (_e1191.member < _e1191.member_1) {
                                                phi_1207_ = type_8((_e1191.member + 1u), _e1191.member_1);
                                                phi_1229_ = type_8(1u, _e1191.member);
                                            } else {
                                                phi_1207_ = _e1191;
                                                phi_1229_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1204 = phi_1207_;
                                            let _e1206 = phi_1229_;
                                            let _e1210 = (bitcast<i32>(_e1206.member) != 0i);
                                            if _e1210 {
                                                let _e1216 = type_43(_e1189.member, _e1189.member_1, (_e1189.member_2 + 1u));
                                                let _e1221 = (_e707.member.member_1.x - _e707.member.member.x);
                                                let _e1224 = (_e707.member.member_1.y - _e707.member.member.y);
                                                let _e1227 = (_e707.member.member_1.z - _e707.member.member.z);
                                                let _e1229 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                let _e1231 = select(_e1227, _e1229, (_e1229 > _e1227));
                                                let _e1233 = (_e1231 < (1024f * _e147));
                                                if _e1233 {
                                                    phi_1273_ = 0u;
                                                } else {
                                                    phi_1273_ = select(2u, 1u, (_e1231 < (2097152f * _e147)));
                                                }
                                                let _e1238 = phi_1273_;
                                                switch bitcast<i32>(_e1238) {
                                                    case 0: {
                                                        phi_1279_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1279_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1279_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1279_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1241 = phi_1279_;
                                                switch bitcast<i32>(_e1238) {
                                                    case 0: {
                                                        phi_1289_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1289_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1289_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1289_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1248 = phi_1289_;
                                                let _e1250 = ((_e716 + (_e1206.member_1 * ((3u * _e1241) + 1u))) + (3u * _e1248));
                                                let _e1251 = (_e1250 < _e99);
                                                if _e1251 {
                                                    if _e1251 {
                                                    } else {
                                                        phi_4289_ = true;
                                                        break;
                                                    }
                                                    let _e1253 = global_5.member[_e1250];
                                                    phi_1305_ = _e1253;
                                                } else {
                                                    phi_1305_ = 4294967295u;
                                                }
                                                let _e1255 = phi_1305_;
                                                if _e1233 {
                                                    phi_1338_ = 0u;
                                                } else {
                                                    phi_1338_ = select(2u, 1u, (_e1231 < (2097152f * _e147)));
                                                }
                                                let _e1260 = phi_1338_;
                                                switch bitcast<i32>(_e1260) {
                                                    case 0: {
                                                        phi_1344_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1344_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1344_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1344_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1263 = phi_1344_;
                                                let _e1267 = (_e716 + (_e1206.member_1 * ((3u * _e1263) + 1u)));
                                                switch bitcast<i32>(_e1260) {
                                                    case 0: {
                                                        let _e1542 = (_e1267 < _e99);
                                                        if _e1542 {
                                                            if _e1542 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1544 = global_5.member[_e1267];
                                                            phi_1368_ = _e1544;
                                                        } else {
                                                            phi_1368_ = 0u;
                                                        }
                                                        let _e1546 = phi_1368_;
                                                        let _e1548 = ((10u * _e267) & 31u);
                                                        let _e1558 = ((10u * _e266) & 31u);
                                                        let _e1568 = ((10u * _e268) & 31u);
                                                        let _e1578 = (_e1267 + 1u);
                                                        let _e1579 = (_e1578 < _e99);
                                                        if _e1579 {
                                                            if _e1579 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1581 = global_5.member[_e1578];
                                                            phi_1414_ = _e1581;
                                                        } else {
                                                            phi_1414_ = 0u;
                                                        }
                                                        let _e1583 = phi_1414_;
                                                        let _e1609 = (_e1267 + 2u);
                                                        let _e1610 = (_e1609 < _e99);
                                                        if _e1610 {
                                                            if _e1610 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1612 = global_5.member[_e1609];
                                                            phi_1460_ = _e1612;
                                                        } else {
                                                            phi_1460_ = 0u;
                                                        }
                                                        let _e1614 = phi_1460_;
                                                        phi_1943_ = array<array<f32, 3>, 3>(array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e147)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e147)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e147)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e147)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e147)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e147)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1356 = (_e1267 < _e99);
                                                        if _e1356 {
                                                            if _e1356 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1358 = global_5.member[_e1267];
                                                            phi_1506_ = _e1358;
                                                        } else {
                                                            phi_1506_ = 0u;
                                                        }
                                                        let _e1360 = phi_1506_;
                                                        let _e1361 = (_e1267 + 1u);
                                                        let _e1362 = (_e1361 < _e99);
                                                        if _e1362 {
                                                            if _e1362 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1364 = global_5.member[_e1361];
                                                            phi_1521_ = _e1364;
                                                        } else {
                                                            phi_1521_ = 0u;
                                                        }
                                                        let _e1366 = phi_1521_;
                                                        let _e1367 = (_e267 == 1u);
                                                        if _e1367 {
                                                            phi_1531_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1531_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1376 = phi_1531_;
                                                        let _e1384 = (_e266 == 1u);
                                                        if _e1384 {
                                                            phi_1552_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1552_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1393 = phi_1552_;
                                                        let _e1401 = (_e268 == 1u);
                                                        if _e1401 {
                                                            phi_1573_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1573_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1410 = phi_1573_;
                                                        let _e1419 = (_e1267 + 2u);
                                                        let _e1420 = (_e1419 < _e99);
                                                        if _e1420 {
                                                            if _e1420 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1422 = global_5.member[_e1419];
                                                            phi_1600_ = _e1422;
                                                        } else {
                                                            phi_1600_ = 0u;
                                                        }
                                                        let _e1424 = phi_1600_;
                                                        let _e1425 = (_e1267 + 3u);
                                                        let _e1426 = (_e1425 < _e99);
                                                        if _e1426 {
                                                            if _e1426 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1428 = global_5.member[_e1425];
                                                            phi_1615_ = _e1428;
                                                        } else {
                                                            phi_1615_ = 0u;
                                                        }
                                                        let _e1430 = phi_1615_;
                                                        if _e1367 {
                                                            phi_1625_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1625_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1439 = phi_1625_;
                                                        if _e1384 {
                                                            phi_1646_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1646_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1455 = phi_1646_;
                                                        if _e1401 {
                                                            phi_1667_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1667_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1471 = phi_1667_;
                                                        let _e1480 = (_e1267 + 4u);
                                                        let _e1481 = (_e1480 < _e99);
                                                        if _e1481 {
                                                            if _e1481 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1483 = global_5.member[_e1480];
                                                            phi_1694_ = _e1483;
                                                        } else {
                                                            phi_1694_ = 0u;
                                                        }
                                                        let _e1485 = phi_1694_;
                                                        let _e1486 = (_e1267 + 5u);
                                                        let _e1487 = (_e1486 < _e99);
                                                        if _e1487 {
                                                            if _e1487 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1489 = global_5.member[_e1486];
                                                            phi_1709_ = _e1489;
                                                        } else {
                                                            phi_1709_ = 0u;
                                                        }
                                                        let _e1491 = phi_1709_;
                                                        if _e1367 {
                                                            phi_1719_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1719_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1500 = phi_1719_;
                                                        if _e1384 {
                                                            phi_1740_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1740_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1516 = phi_1740_;
                                                        if _e1401 {
                                                            phi_1761_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1761_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1532 = phi_1761_;
                                                        phi_1943_ = array<array<f32, 3>, 3>(array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1376, _e1360, _e306) & 2097151u))) - 8388608f) * _e147)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1393, _e1360, _e375) & 2097151u))) - 8388608f) * _e147)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1410, _e1360, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1439, _e1424, _e306) & 2097151u))) - 8388608f) * _e147)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1455, _e1424, _e375) & 2097151u))) - 8388608f) * _e147)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1471, _e1424, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1500, _e1485, _e306) & 2097151u))) - 8388608f) * _e147)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1516, _e1485, _e375) & 2097151u))) - 8388608f) * _e147)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1532, _e1485, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1269 = (_e1267 + _e267);
                                                        let _e1270 = (_e1269 < _e99);
                                                        if _e1270 {
                                                            if _e1270 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1272 = global_5.member[_e1269];
                                                            phi_1789_ = _e1272;
                                                        } else {
                                                            phi_1789_ = 0u;
                                                        }
                                                        let _e1274 = phi_1789_;
                                                        let _e1278 = (_e1267 + _e266);
                                                        let _e1279 = (_e1278 < _e99);
                                                        if _e1279 {
                                                            if _e1279 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1281 = global_5.member[_e1278];
                                                            phi_1807_ = _e1281;
                                                        } else {
                                                            phi_1807_ = 0u;
                                                        }
                                                        let _e1283 = phi_1807_;
                                                        let _e1287 = (_e1267 + _e268);
                                                        let _e1288 = (_e1287 < _e99);
                                                        if _e1288 {
                                                            if _e1288 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1290 = global_5.member[_e1287];
                                                            phi_1825_ = _e1290;
                                                        } else {
                                                            phi_1825_ = 0u;
                                                        }
                                                        let _e1292 = phi_1825_;
                                                        let _e1297 = (_e1267 + 3u);
                                                        let _e1298 = (_e1297 + _e267);
                                                        let _e1299 = (_e1298 < _e99);
                                                        if _e1299 {
                                                            if _e1299 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1301 = global_5.member[_e1298];
                                                            phi_1845_ = _e1301;
                                                        } else {
                                                            phi_1845_ = 0u;
                                                        }
                                                        let _e1303 = phi_1845_;
                                                        let _e1307 = (_e1297 + _e266);
                                                        let _e1308 = (_e1307 < _e99);
                                                        if _e1308 {
                                                            if _e1308 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1310 = global_5.member[_e1307];
                                                            phi_1863_ = _e1310;
                                                        } else {
                                                            phi_1863_ = 0u;
                                                        }
                                                        let _e1312 = phi_1863_;
                                                        let _e1316 = (_e1297 + _e268);
                                                        let _e1317 = (_e1316 < _e99);
                                                        if _e1317 {
                                                            if _e1317 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = global_5.member[_e1316];
                                                            phi_1881_ = _e1319;
                                                        } else {
                                                            phi_1881_ = 0u;
                                                        }
                                                        let _e1321 = phi_1881_;
                                                        let _e1326 = (_e1267 + 6u);
                                                        let _e1327 = (_e1326 + _e267);
                                                        let _e1328 = (_e1327 < _e99);
                                                        if _e1328 {
                                                            if _e1328 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1330 = global_5.member[_e1327];
                                                            phi_1901_ = _e1330;
                                                        } else {
                                                            phi_1901_ = 0u;
                                                        }
                                                        let _e1332 = phi_1901_;
                                                        let _e1336 = (_e1326 + _e266);
                                                        let _e1337 = (_e1336 < _e99);
                                                        if _e1337 {
                                                            if _e1337 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1339 = global_5.member[_e1336];
                                                            phi_1919_ = _e1339;
                                                        } else {
                                                            phi_1919_ = 0u;
                                                        }
                                                        let _e1341 = phi_1919_;
                                                        let _e1345 = (_e1326 + _e268);
                                                        let _e1346 = (_e1345 < _e99);
                                                        if _e1346 {
                                                            if _e1346 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1348 = global_5.member[_e1345];
                                                            phi_1937_ = _e1348;
                                                        } else {
                                                            phi_1937_ = 0u;
                                                        }
                                                        let _e1350 = phi_1937_;
                                                        phi_1943_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1274)) * _e147), (f32(bitcast<i32>(_e1283)) * _e147), (f32(bitcast<i32>(_e1292)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1303)) * _e147), (f32(bitcast<i32>(_e1312)) * _e147), (f32(bitcast<i32>(_e1321)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1332)) * _e147), (f32(bitcast<i32>(_e1341)) * _e147), (f32(bitcast<i32>(_e1350)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1943_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1642 = phi_1943_;
                                                let _e1651 = (_e1642[0][2] - _e468);
                                                let _e1654 = (((_e1642[0][0] - _e331) * _e507) - (_e1651 * _e371));
                                                let _e1657 = (((_e1642[0][1] - _e400) * _e507) - (_e1651 * _e439));
                                                let _e1664 = (_e1642[1][2] - _e468);
                                                let _e1667 = (((_e1642[1][0] - _e331) * _e507) - (_e1664 * _e371));
                                                let _e1670 = (((_e1642[1][1] - _e400) * _e507) - (_e1664 * _e439));
                                                let _e1677 = (_e1642[2][2] - _e468);
                                                let _e1680 = (((_e1642[2][0] - _e331) * _e507) - (_e1677 * _e371));
                                                let _e1683 = (((_e1642[2][1] - _e400) * _e507) - (_e1677 * _e439));
                                                let _e1684 = (_e1680 * _e1670);
                                                let _e1685 = (_e1683 * _e1667);
                                                let _e1686 = (_e1654 * _e1683);
                                                let _e1687 = (_e1657 * _e1680);
                                                let _e1688 = (_e1667 * _e1657);
                                                let _e1689 = (_e1670 * _e1654);
                                                let _e1694 = (((_e1684 >= _e1685) && (_e1686 >= _e1687)) && (_e1688 >= _e1689));
                                                if (_e1694 || (((_e1684 <= _e1685) && (_e1686 <= _e1687)) && (_e1688 <= _e1689))) {
                                                    let _e1701 = select(-1f, 1f, _e1694);
                                                    let _e1703 = ((_e1684 - _e1685) * _e1701);
                                                    let _e1705 = select(0f, _e1703, (_e1703 > 0f));
                                                    let _e1707 = ((_e1686 - _e1687) * _e1701);
                                                    let _e1709 = select(0f, _e1707, (_e1707 > 0f));
                                                    let _e1711 = ((_e1688 - _e1689) * _e1701);
                                                    let _e1713 = select(0f, _e1711, (_e1711 > 0f));
                                                    let _e1715 = ((_e1705 + _e1709) + _e1713);
                                                    if (_e1715 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2768_ = type_28();
                                                        phi_2769_ = true;
                                                        phi_2770_ = false;
                                                    } else {
                                                        let _e1718 = select(_e1667, _e1654, (_e1654 < _e1667));
                                                        if (select(_e1680, _e1718, (_e1718 < _e1680)) > 0f) {
                                                            phi_2060_ = true;
                                                        } else {
                                                            let _e1723 = select(_e1667, _e1654, (_e1654 > _e1667));
                                                            phi_2060_ = (select(_e1680, _e1723, (_e1723 > _e1680)) < 0f);
                                                        }
                                                        let _e1728 = phi_2060_;
                                                        if _e1728 {
                                                            phi_2765_ = type_28();
                                                            phi_2766_ = true;
                                                            phi_2767_ = false;
                                                        } else {
                                                            let _e1730 = select(_e1670, _e1657, (_e1657 < _e1670));
                                                            if (select(_e1683, _e1730, (_e1730 < _e1683)) > 0f) {
                                                                phi_2089_ = true;
                                                            } else {
                                                                let _e1735 = select(_e1670, _e1657, (_e1657 > _e1670));
                                                                phi_2089_ = (select(_e1683, _e1735, (_e1735 > _e1683)) < 0f);
                                                            }
                                                            let _e1740 = phi_2089_;
                                                            if _e1740 {
                                                                phi_2763_ = type_28();
                                                                phi_2764_ = false;
                                                            } else {
                                                                let _e1742 = select(_e1642[1][0], _e1642[0][0], (_e1642[0][0] < _e1642[1][0]));
                                                                let _e1746 = select(_e1642[1][0], _e1642[0][0], (_e1642[0][0] > _e1642[1][0]));
                                                                let _e1750 = select(_e1642[1][1], _e1642[0][1], (_e1642[0][1] < _e1642[1][1]));
                                                                let _e1754 = select(_e1642[1][1], _e1642[0][1], (_e1642[0][1] > _e1642[1][1]));
                                                                let _e1758 = select(_e1642[1][2], _e1642[0][2], (_e1642[0][2] < _e1642[1][2]));
                                                                let _e1762 = select(_e1642[1][2], _e1642[0][2], (_e1642[0][2] > _e1642[1][2]));
                                                                let _e1767 = ((select(_e1642[2][0], _e1742, (_e1742 < _e1642[2][0])) - _e369) * _e374);
                                                                let _e1768 = ((select(_e1642[2][0], _e1746, (_e1746 > _e1642[2][0])) - _e370) * _e374);
                                                                let _e1771 = ((select(_e1642[2][1], _e1750, (_e1750 < _e1642[2][1])) - _e437) * _e442);
                                                                let _e1772 = ((select(_e1642[2][1], _e1754, (_e1754 > _e1642[2][1])) - _e438) * _e442);
                                                                let _e1775 = ((select(_e1642[2][2], _e1758, (_e1758 < _e1642[2][2])) - _e505) * _e510);
                                                                let _e1776 = ((select(_e1642[2][2], _e1762, (_e1762 > _e1642[2][2])) - _e506) * _e510);
                                                                let _e1778 = select(_e1776, _e1775, (_e1775 < _e1776));
                                                                let _e1780 = select(_e1776, _e1775, (_e1775 > _e1776));
                                                                let _e1782 = select(_e1768, _e1767, (_e1767 < _e1768));
                                                                let _e1784 = select(_e1772, _e1771, (_e1771 < _e1772));
                                                                let _e1786 = select(_e1784, _e1782, (_e1782 > _e1784));
                                                                let _e1788 = select(_e1778, _e1786, (_e1786 > _e1778));
                                                                let _e1790 = select(_e1768, _e1767, (_e1767 > _e1768));
                                                                let _e1792 = select(_e1772, _e1771, (_e1771 > _e1772));
                                                                let _e1794 = select(_e1792, _e1790, (_e1790 < _e1792));
                                                                let _e1796 = select(_e1780, _e1794, (_e1794 < _e1780));
                                                                let _e1797 = -(_e1778);
                                                                let _e1803 = select(_e622, _e1788, (_e1788 > _e622));
                                                                if (_e1803 > (_e1796 + (select(_e1797, _e1780, (_e1780 > _e1797)) * 0.0000019073523f))) {
                                                                    phi_2758_ = type_28();
                                                                    phi_2759_ = true;
                                                                } else {
                                                                    let _e1805 = (_e1803 > _e1189.member.member_1);
                                                                    if _e1805 {
                                                                        phi_2757_ = type_28();
                                                                    } else {
                                                                        let _e1806 = vec3<f32>(_e1642[0][0], _e1642[0][1], _e1642[0][2]);
                                                                        let _e1807 = vec3<f32>(_e1642[1][0], _e1642[1][1], _e1642[1][2]);
                                                                        let _e1808 = vec3<f32>(_e1642[2][0], _e1642[2][1], _e1642[2][2]);
                                                                        let _e1809 = (_e1642[1][0] - _e1642[0][0]);
                                                                        let _e1810 = (_e1642[1][1] - _e1642[0][1]);
                                                                        let _e1811 = (_e1642[1][2] - _e1642[0][2]);
                                                                        let _e1812 = vec3<f32>(_e1809, _e1810, _e1811);
                                                                        let _e1813 = (_e1642[2][0] - _e1642[1][0]);
                                                                        let _e1814 = (_e1642[2][1] - _e1642[1][1]);
                                                                        let _e1815 = (_e1642[2][2] - _e1642[1][2]);
                                                                        let _e1816 = vec3<f32>(_e1813, _e1814, _e1815);
                                                                        let _e1817 = (_e1642[0][0] - _e1642[2][0]);
                                                                        let _e1818 = (_e1642[0][1] - _e1642[2][1]);
                                                                        let _e1819 = (_e1642[0][2] - _e1642[2][2]);
                                                                        let _e1820 = vec3<f32>(_e1817, _e1818, _e1819);
                                                                        let _e1823 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
                                                                        let _e1826 = bitcast<f32>((bitcast<u32>(_e1810) & 2147483647u));
                                                                        let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                                        let _e1831 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                                        let _e1833 = select(_e1831, _e1828, (_e1828 > _e1831));
                                                                        let _e1836 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                                        let _e1839 = bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u));
                                                                        let _e1841 = select(_e1839, _e1836, (_e1836 > _e1839));
                                                                        let _e1844 = bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u));
                                                                        let _e1846 = select(_e1844, _e1841, (_e1841 > _e1844));
                                                                        let _e1849 = bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u));
                                                                        let _e1852 = bitcast<f32>((bitcast<u32>(_e1818) & 2147483647u));
                                                                        let _e1854 = select(_e1852, _e1849, (_e1849 > _e1852));
                                                                        let _e1857 = bitcast<f32>((bitcast<u32>(_e1819) & 2147483647u));
                                                                        let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                                        let _e1861 = select(_e1846, _e1833, (_e1833 > _e1846));
                                                                        let _e1863 = select(_e1859, _e1861, (_e1861 > _e1859));
                                                                        if (_e1833 == _e1863) {
                                                                            phi_2490_ = _e1670;
                                                                            phi_2491_ = _e1667;
                                                                            phi_2492_ = _e1657;
                                                                            phi_2493_ = _e1654;
                                                                            phi_2494_ = _e1806;
                                                                            phi_2495_ = _e1820;
                                                                            phi_2496_ = _e1816;
                                                                            phi_2497_ = _e1812;
                                                                        } else {
                                                                            let _e1865 = (_e1846 == _e1863);
                                                                            let _e1870 = vec3(_e1865);
                                                                            phi_2490_ = select(_e1657, _e1683, _e1865);
                                                                            phi_2491_ = select(_e1654, _e1680, _e1865);
                                                                            phi_2492_ = select(_e1683, _e1670, _e1865);
                                                                            phi_2493_ = select(_e1680, _e1667, _e1865);
                                                                            phi_2494_ = select(_e1808, _e1807, _e1870);
                                                                            phi_2495_ = select(_e1816, _e1812, _e1870);
                                                                            phi_2496_ = select(_e1812, _e1820, _e1870);
                                                                            phi_2497_ = select(_e1820, _e1816, _e1870);
                                                                        }
                                                                        let _e1876 = phi_2490_;
                                                                        let _e1878 = phi_2491_;
                                                                        let _e1880 = phi_2492_;
                                                                        let _e1882 = phi_2493_;
                                                                        let _e1884 = phi_2494_;
                                                                        let _e1886 = phi_2495_;
                                                                        let _e1888 = phi_2496_;
                                                                        let _e1890 = phi_2497_;
                                                                        let _e1897 = ((_e1888.y * _e1886.z) - (_e1886.y * _e1888.z));
                                                                        let _e1902 = ((_e1888.z * _e1886.x) - (_e1886.z * _e1888.x));
                                                                        let _e1905 = ((_e1888.x * _e1886.y) - (_e1886.x * _e1888.y));
                                                                        if (_e1705 >= _e1709) {
                                                                            phi_2528_ = select(true, false, (_e1705 >= _e1713));
                                                                        } else {
                                                                            phi_2528_ = true;
                                                                        }
                                                                        let _e1910 = phi_2528_;
                                                                        if _e1910 {
                                                                            phi_2537_ = select(_e1808, _e1807, vec3((_e1709 >= _e1713)));
                                                                        } else {
                                                                            phi_2537_ = _e1806;
                                                                        }
                                                                        let _e1915 = phi_2537_;
                                                                        let _e1926 = (((_e1897 * (_e1915.x - _e331)) + (_e1902 * (_e1915.y - _e400))) + (_e1905 * (_e1915.z - _e468)));
                                                                        let _e1931 = (((_e1897 * _e371) + (_e1902 * _e439)) + (_e1905 * _e507));
                                                                        let _e1932 = (_e1878 - _e1882);
                                                                        let _e1933 = (_e1876 - _e1880);
                                                                        let _e1941 = (-(((_e1882 * _e1932) + (_e1880 * _e1933))) / ((_e1932 * _e1932) + (_e1933 * _e1933)));
                                                                        let _e1943 = select(1f, _e1941, (_e1941 < 1f));
                                                                        let _e1945 = select(0f, _e1943, (_e1943 > 0f));
                                                                        let _e1958 = ((_e1884.x + (_e1890.x * _e1945)) - _e331);
                                                                        let _e1959 = ((_e1884.y + (_e1890.y * _e1945)) - _e400);
                                                                        let _e1960 = ((_e1884.z + (_e1890.z * _e1945)) - _e468);
                                                                        let _e1961 = (_e1960 / _e507);
                                                                        let _e1973 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                                        let _e1976 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                                        let _e1978 = select(_e1976, _e1973, (_e1973 > _e1976));
                                                                        let _e1981 = bitcast<f32>((bitcast<u32>(_e1960) & 2147483647u));
                                                                        let _e1983 = select(_e1981, _e1978, (_e1978 > _e1981));
                                                                        let _e1989 = bitcast<f32>((bitcast<u32>(_e1897) & 2147483647u));
                                                                        let _e1992 = bitcast<f32>((bitcast<u32>(_e1902) & 2147483647u));
                                                                        let _e1994 = select(_e1992, _e1989, (_e1989 > _e1992));
                                                                        let _e1997 = bitcast<f32>((bitcast<u32>(_e1905) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1897 * _e1958) + (_e1902 * _e1959)) + (_e1905 * _e1960)) - _e1926)) & 2147483647u)) <= ((0.0000009536743f * select(_e1863, _e1983, (_e1983 > _e1863))) * select(_e1997, _e1994, (_e1994 > _e1997)))) {
                                                                            let _e2007 = bitcast<f32>((bitcast<u32>(_e1888.x) & 2147483647u));
                                                                            let _e2010 = bitcast<f32>((bitcast<u32>(_e1888.y) & 2147483647u));
                                                                            let _e2012 = select(_e2010, _e2007, (_e2007 > _e2010));
                                                                            let _e2015 = bitcast<f32>((bitcast<u32>(_e1888.z) & 2147483647u));
                                                                            let _e2021 = bitcast<f32>((bitcast<u32>(_e1886.x) & 2147483647u));
                                                                            let _e2024 = bitcast<f32>((bitcast<u32>(_e1886.y) & 2147483647u));
                                                                            let _e2026 = select(_e2024, _e2021, (_e2021 > _e2024));
                                                                            let _e2029 = bitcast<f32>((bitcast<u32>(_e1886.z) & 2147483647u));
                                                                            let _e2033 = (bitcast<f32>((bitcast<u32>(_e1931) & 2147483647u)) > ((0.0000038146973f * select(_e2015, _e2012, (_e2012 > _e2015))) * select(_e2029, _e2026, (_e2026 > _e2029))));
                                                                            if _e2033 {
                                                                                phi_2702_ = (_e1926 / _e1931);
                                                                            } else {
                                                                                phi_2702_ = f32();
                                                                            }
                                                                            let _e2036 = phi_2702_;
                                                                            phi_2704_ = _e2036;
                                                                            phi_2705_ = select(true, false, _e2033);
                                                                        } else {
                                                                            phi_2704_ = f32();
                                                                            phi_2705_ = true;
                                                                        }
                                                                        let _e2039 = phi_2704_;
                                                                        let _e2041 = phi_2705_;
                                                                        if _e2041 {
                                                                            let _e2049 = (((_e1897 * (_e1958 - (_e371 * _e1961))) + (_e1902 * (_e1959 - (_e439 * _e1961)))) / _e1931);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2049) & 2147483647u)) <= _e1863) {
                                                                                phi_2725_ = (_e1961 + _e2049);
                                                                            } else {
                                                                                phi_2725_ = _e1961;
                                                                            }
                                                                            let _e2056 = phi_2725_;
                                                                            phi_2726_ = _e2056;
                                                                        } else {
                                                                            phi_2726_ = _e2039;
                                                                        }
                                                                        let _e2058 = phi_2726_;
                                                                        let _e2060 = select(_e1796, _e2058, (_e2058 < _e1796));
                                                                        let _e2062 = select(_e1788, _e2060, (_e2060 > _e1788));
                                                                        if (_e2062 >= _e622) {
                                                                            let _e2064 = (_e2062 <= _e1189.member.member_1);
                                                                            if _e2064 {
                                                                                let _e2065 = (1f / _e1715);
                                                                                phi_2749_ = type_28(_e2062, (_e1709 * _e2065), (_e1713 * _e2065), _e1255);
                                                                            } else {
                                                                                phi_2749_ = type_28();
                                                                            }
                                                                            let _e2070 = phi_2749_;
                                                                            phi_2751_ = _e2070;
                                                                            phi_2752_ = select(true, false, _e2064);
                                                                        } else {
                                                                            phi_2751_ = type_28();
                                                                            phi_2752_ = true;
                                                                        }
                                                                        let _e2073 = phi_2751_;
                                                                        let _e2075 = phi_2752_;
                                                                        if _e2075 {
                                                                            phi_2756_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2756_ = _e2073;
                                                                        }
                                                                        let _e2077 = phi_2756_;
                                                                        phi_2757_ = _e2077;
                                                                    }
                                                                    let _e2079 = phi_2757_;
                                                                    phi_2758_ = _e2079;
                                                                    phi_2759_ = _e1805;
                                                                }
                                                                let _e2081 = phi_2758_;
                                                                let _e2083 = phi_2759_;
                                                                phi_2763_ = _e2081;
                                                                phi_2764_ = _e2083;
                                                            }
                                                            let _e2085 = phi_2763_;
                                                            let _e2087 = phi_2764_;
                                                            phi_2765_ = _e2085;
                                                            phi_2766_ = _e1740;
                                                            phi_2767_ = _e2087;
                                                        }
                                                        let _e2089 = phi_2765_;
                                                        let _e2091 = phi_2766_;
                                                        let _e2093 = phi_2767_;
                                                        phi_2768_ = _e2089;
                                                        phi_2769_ = _e2091;
                                                        phi_2770_ = _e2093;
                                                    }
                                                    let _e2095 = phi_2768_;
                                                    let _e2097 = phi_2769_;
                                                    let _e2099 = phi_2770_;
                                                    phi_2778_ = _e2095;
                                                    phi_2779_ = select(_e2099, true, _e2097);
                                                } else {
                                                    phi_2778_ = type_28();
                                                    phi_2779_ = true;
                                                }
                                                let _e2102 = phi_2778_;
                                                let _e2104 = phi_2779_;
                                                if _e2104 {
                                                    phi_2783_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2783_ = _e2102;
                                                }
                                                let _e2106 = phi_2783_;
                                                if (_e2106.member_3 != 4294967295u) {
                                                    if (_e1255 != 4294967295u) {
                                                        if (_e2106.member < _e1189.member.member.member) {
                                                            phi_2809_ = true;
                                                        } else {
                                                            if (_e2106.member == _e1189.member.member.member) {
                                                                phi_2808_ = (_e2106.member_3 < _e1189.member.member.member_3);
                                                            } else {
                                                                phi_2808_ = false;
                                                            }
                                                            let _e2121 = phi_2808_;
                                                            phi_2809_ = _e2121;
                                                        }
                                                        let _e2123 = phi_2809_;
                                                        if _e2123 {
                                                            phi_2816_ = type_43(type_36(_e2106, _e2106.member), _e1216.member_1, _e1216.member_2);
                                                        } else {
                                                            phi_2816_ = _e1216;
                                                        }
                                                        let _e2130 = phi_2816_;
                                                        phi_2817_ = _e2130;
                                                    } else {
                                                        phi_2817_ = _e1216;
                                                    }
                                                    let _e2132 = phi_2817_;
                                                    phi_2818_ = _e2132;
                                                } else {
                                                    phi_2818_ = _e1216;
                                                }
                                                let _e2134 = phi_2818_;
                                                phi_1204_ = _e2134;
                                            } else {
                                                phi_1204_ = type_43();
                                            }
                                            let _e2136 = phi_1204_;
                                            continue;
                                            continuing {
                                                phi_1203_ = _e2136;
                                                phi_1206_ = _e1204;
                                                phi_4289_ = _e665;
                                                break if !(_e1210);
                                            }
                                        }
                                        let _e2139 = phi_4289_;
                                        phi_4496_ = _e2139;
                                        if _e2139 {
                                            break;
                                        }
                                        phi_4500_ = _e2139;
                                        let _e2351 = local_12;
                                        phi_4061_ = _e2351;
                                        phi_4062_ = _e707;
                                        phi_4063_ = false;
                                        phi_4064_ = _e711;
                                    } else {
                                        if (_e707.member_1 >= _e96) {
                                            phi_3617_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e707.member_1 < _e96) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e730 = ((1u + _e267) % 4u);
                                            if (_e730 < 4u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e735 = global_3.member[_e707.member_1][_e730];
                                            let _e737 = (_e735 >> bitcast<u32>(11u));
                                            let _e739 = ((1u + _e266) % 4u);
                                            if (_e739 < 4u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e744 = global_3.member[_e707.member_1][_e739];
                                            let _e746 = (_e744 >> bitcast<u32>(11u));
                                            let _e748 = ((1u + _e268) % 4u);
                                            if (_e748 < 4u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e753 = global_3.member[_e707.member_1][_e748];
                                            let _e755 = (_e753 >> bitcast<u32>(11u));
                                            let _e778 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.x - _e707.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e779 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.y - _e707.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e780 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.z - _e707.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e782 = select(_e147, _e778, (_e778 > _e147));
                                            let _e784 = select(_e147, _e779, (_e779 > _e147));
                                            let _e786 = select(_e147, _e780, (_e780 > _e147));
                                            let _e817 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 1023u))) - 8388608f) * _e782));
                                            let _e822 = (bitcast<i32>((_e735 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e825 = bitcast<f32>((_e817 & bitcast<u32>(_e822)));
                                            let _e826 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e744 & 1023u))) - 8388608f) * _e784));
                                            let _e831 = (bitcast<i32>((_e744 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e834 = bitcast<f32>((_e826 & bitcast<u32>(_e831)));
                                            let _e835 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e753 & 1023u))) - 8388608f) * _e786));
                                            let _e840 = (bitcast<i32>((_e753 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e843 = bitcast<f32>((_e835 & bitcast<u32>(_e840)));
                                            let _e847 = bitcast<f32>((_e817 & bitcast<u32>(~(_e822))));
                                            let _e851 = bitcast<f32>((_e826 & bitcast<u32>(~(_e831))));
                                            let _e855 = bitcast<f32>((_e835 & bitcast<u32>(~(_e840))));
                                            let _e856 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e737 & 1023u))) - 8388608f) * _e782));
                                            let _e861 = (bitcast<i32>((_e737 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e864 = bitcast<f32>((_e856 & bitcast<u32>(_e861)));
                                            let _e865 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e746 & 1023u))) - 8388608f) * _e784));
                                            let _e870 = (bitcast<i32>((_e746 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e873 = bitcast<f32>((_e865 & bitcast<u32>(_e870)));
                                            let _e874 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e755 & 1023u))) - 8388608f) * _e786));
                                            let _e879 = (bitcast<i32>((_e755 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e882 = bitcast<f32>((_e874 & bitcast<u32>(_e879)));
                                            let _e886 = bitcast<f32>((_e856 & bitcast<u32>(~(_e861))));
                                            let _e890 = bitcast<f32>((_e865 & bitcast<u32>(~(_e870))));
                                            let _e894 = bitcast<f32>((_e874 & bitcast<u32>(~(_e879))));
                                            let _e895 = (_e707.member.member.x + _e825);
                                            let _e896 = (_e707.member.member.y + _e834);
                                            let _e897 = (_e707.member.member.z + _e843);
                                            let _e900 = (_e707.member.member_1.x - _e864);
                                            let _e901 = (_e707.member.member_1.y - _e873);
                                            let _e902 = (_e707.member.member_1.z - _e882);
                                            let _e921 = (_e900 - _e895);
                                            let _e922 = (_e901 - _e896);
                                            let _e923 = (_e902 - _e897);
                                            let _e925 = select(_e922, _e921, (_e921 > _e922));
                                            let _e927 = select(_e923, _e925, (_e925 > _e923));
                                            if (_e927 < (1024f * _e147)) {
                                                phi_3318_ = 0u;
                                            } else {
                                                phi_3318_ = select(2u, 1u, (_e927 < (2097152f * _e147)));
                                            }
                                            let _e934 = phi_3318_;
                                            switch bitcast<i32>(_e934) {
                                                case 0: {
                                                    phi_3324_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3324_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3324_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3324_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e937 = phi_3324_;
                                            let _e943 = global_3.member[_e707.member_1][0u];
                                            let _e947 = global_3.member[_e707.member_1][1u];
                                            let _e951 = global_3.member[_e707.member_1][2u];
                                            let _e955 = global_3.member[_e707.member_1][3u];
                                            let _e967 = (((_e947 >> bitcast<u32>(22i)) | ((_e951 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e955 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e968 = (_e943 & 268435455u);
                                            let _e969 = (_e967 & 268435455u);
                                            let _e972 = ((_e943 >> bitcast<u32>(28u)) & 7u);
                                            let _e980 = ((_e943 >> bitcast<u32>(31i)) | (((_e967 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e981 = (_e972 != 0u);
                                            if (_e972 == 0u) {
                                                phi_3579_ = _e968;
                                            } else {
                                                if (_e972 == 7u) {
                                                    phi_3578_ = 2147483648u;
                                                } else {
                                                    phi_3578_ = ((2147483648u | (_e972 << bitcast<u32>(28u))) | (_e969 & 268435455u));
                                                }
                                                let _e990 = phi_3578_;
                                                phi_3579_ = _e990;
                                            }
                                            let _e992 = phi_3579_;
                                            if _e981 {
                                                let _e993 = (_e972 != 7u);
                                                if _e993 {
                                                    phi_3589_ = (_e969 + (_e972 * ((3u * _e937) + 1u)));
                                                } else {
                                                    phi_3589_ = u32();
                                                }
                                                let _e997 = phi_3589_;
                                                phi_3591_ = _e997;
                                                phi_3592_ = select(true, false, _e993);
                                            } else {
                                                phi_3591_ = u32();
                                                phi_3592_ = true;
                                            }
                                            let _e1000 = phi_3591_;
                                            let _e1002 = phi_3592_;
                                            if (_e980 == 0u) {
                                                phi_3613_ = (_e968 + select(0u, 1u, !(_e981)));
                                            } else {
                                                if (_e980 == 7u) {
                                                    phi_3612_ = 2147483648u;
                                                } else {
                                                    phi_3612_ = ((2147483648u | (_e980 << bitcast<u32>(28u))) | (select(_e1000, _e969, _e1002) & 268435455u));
                                                }
                                                let _e1015 = phi_3612_;
                                                phi_3613_ = _e1015;
                                            }
                                            let _e1017 = phi_3613_;
                                            phi_3617_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e895, (_e707.member.member.x + _e847), _e900, (_e707.member.member_1.x - _e886)), vec4<f32>(_e896, (_e707.member.member.y + _e851), _e901, (_e707.member.member_1.y - _e890)), vec4<f32>(_e897, (_e707.member.member.z + _e855), _e902, (_e707.member.member_1.z - _e894))), type_50(type_32((_e707.member.member + vec4<f32>(_e825, _e834, _e843, 0f)), (_e707.member.member_1 - vec4<f32>(_e864, _e873, _e882, 0f))), _e992), type_50(type_32((_e707.member.member + vec4<f32>(_e847, _e851, _e855, 0f)), (_e707.member.member_1 - vec4<f32>(_e886, _e890, _e894, 0f))), _e1017));
                                        }
                                        let _e1022 = phi_3617_;
                                        let _e1035 = ((_e1022.member[0].x - _e369) * _e374);
                                        let _e1036 = ((_e1022.member[0].y - _e369) * _e374);
                                        let _e1037 = ((_e1022.member[0].z - _e370) * _e374);
                                        let _e1038 = ((_e1022.member[0].w - _e370) * _e374);
                                        let _e1048 = ((_e1022.member[1].x - _e437) * _e442);
                                        let _e1049 = ((_e1022.member[1].y - _e437) * _e442);
                                        let _e1050 = ((_e1022.member[1].z - _e438) * _e442);
                                        let _e1051 = ((_e1022.member[1].w - _e438) * _e442);
                                        let _e1061 = ((_e1022.member[2].x - _e505) * _e510);
                                        let _e1062 = ((_e1022.member[2].y - _e505) * _e510);
                                        let _e1063 = ((_e1022.member[2].z - _e506) * _e510);
                                        let _e1064 = ((_e1022.member[2].w - _e506) * _e510);
                                        let _e1066 = select(_e1063, _e1061, (_e1061 < _e1063));
                                        let _e1068 = select(_e1064, _e1062, (_e1062 < _e1064));
                                        let _e1070 = select(_e1063, _e1061, (_e1061 > _e1063));
                                        let _e1072 = select(_e1064, _e1062, (_e1062 > _e1064));
                                        let _e1074 = select(_e1037, _e1035, (_e1035 < _e1037));
                                        let _e1076 = select(_e1038, _e1036, (_e1036 < _e1038));
                                        let _e1078 = select(_e1050, _e1048, (_e1048 < _e1050));
                                        let _e1080 = select(_e1051, _e1049, (_e1049 < _e1051));
                                        let _e1082 = select(_e1078, _e1074, (_e1074 > _e1078));
                                        let _e1084 = select(_e1080, _e1076, (_e1076 > _e1080));
                                        let _e1086 = select(_e1066, _e1082, (_e1082 > _e1066));
                                        let _e1088 = select(_e1068, _e1084, (_e1084 > _e1068));
                                        let _e1090 = select(_e1037, _e1035, (_e1035 > _e1037));
                                        let _e1092 = select(_e1038, _e1036, (_e1036 > _e1038));
                                        let _e1094 = select(_e1050, _e1048, (_e1048 > _e1050));
                                        let _e1096 = select(_e1051, _e1049, (_e1049 > _e1051));
                                        let _e1098 = select(_e1094, _e1090, (_e1090 < _e1094));
                                        let _e1100 = select(_e1096, _e1092, (_e1092 < _e1096));
                                        let _e1105 = -(_e1066);
                                        let _e1106 = -(_e1068);
                                        let _e1113 = (select(_e1070, _e1098, (_e1098 < _e1070)) + (select(_e1105, _e1070, (_e1070 > _e1105)) * 0.0000019073523f));
                                        let _e1114 = (select(_e1072, _e1100, (_e1100 < _e1072)) + (select(_e1106, _e1072, (_e1072 > _e1106)) * 0.0000019073523f));
                                        let _e1116 = select(_e622, _e1086, (_e1086 > _e622));
                                        let _e1118 = select(_e622, _e1088, (_e1088 > _e622));
                                        let _e1123 = (_e1116 <= select(_e667.member.member_1, _e1113, (_e1113 < _e667.member.member_1)));
                                        let _e1124 = (_e1118 <= select(_e667.member.member_1, _e1114, (_e1114 < _e667.member.member_1)));
                                        let _e1125 = (_e1116 <= _e1118);
                                        if _e1123 {
                                            if _e1124 {
                                                if _e1125 {
                                                    phi_3961_ = _e1022.member_2;
                                                } else {
                                                    phi_3961_ = _e1022.member_1;
                                                }
                                                let _e1129 = phi_3961_;
                                                let _e1151 = (_e711 % 128u);
                                                let _e1152 = (_e1151 < 128u);
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_8[_e1151] = _e1129.member_1;
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_7[_e1151] = _e1129.member.member.x;
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_6[_e1151] = _e1129.member.member.y;
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_5[_e1151] = _e1129.member.member.z;
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_4[_e1151] = _e1129.member.member_1.x;
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_3[_e1151] = _e1129.member.member_1.y;
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_2[_e1151] = _e1129.member.member_1.z;
                                                if _e1152 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_9[_e1151] = select(_e1118, _e1116, (_e1116 > _e1118));
                                                if _e1125 {
                                                    phi_4038_ = _e1022.member_1;
                                                } else {
                                                    phi_4038_ = _e1022.member_2;
                                                }
                                                let _e1165 = phi_4038_;
                                                phi_4039_ = _e1165;
                                                phi_4040_ = (_e711 + 1u);
                                            } else {
                                                phi_4039_ = type_50();
                                                phi_4040_ = u32();
                                            }
                                            let _e1167 = phi_4039_;
                                            let _e1169 = phi_4040_;
                                            phi_4042_ = _e1167;
                                            phi_4043_ = _e1169;
                                            phi_4044_ = select(true, false, _e1124);
                                        } else {
                                            phi_4042_ = type_50();
                                            phi_4043_ = u32();
                                            phi_4044_ = true;
                                        }
                                        let _e1172 = phi_4042_;
                                        let _e1174 = phi_4043_;
                                        let _e1176 = phi_4044_;
                                        if _e1176 {
                                            if _e1123 {
                                                phi_4053_ = _e1022.member_1;
                                            } else {
                                                phi_4053_ = _e1022.member_2;
                                            }
                                            let _e1180 = phi_4053_;
                                            phi_4058_ = _e1180;
                                            phi_4059_ = select(_e1124, true, _e1123);
                                        } else {
                                            phi_4058_ = _e1172;
                                            phi_4059_ = _e709;
                                        }
                                        let _e1183 = phi_4058_;
                                        let _e1185 = phi_4059_;
                                        phi_4500_ = _e665;
                                        phi_4061_ = type_43(_e667.member, (_e667.member_1 + 1u), _e667.member_2);
                                        phi_4062_ = _e1183;
                                        phi_4063_ = _e1185;
                                        phi_4064_ = select(_e1174, _e711, _e1176);
                                    }
                                    let _e2141 = phi_4500_;
                                    let _e2143 = phi_4061_;
                                    let _e2145 = phi_4062_;
                                    let _e2147 = phi_4063_;
                                    let _e2149 = phi_4064_;
                                    phi_4499_ = _e2141;
                                    phi_4065_ = _e2143;
                                    phi_4066_ = _e2145;
                                    phi_4067_ = (_e671 - 1u);
                                    phi_4068_ = _e2147;
                                    phi_4069_ = _e2149;
                                } else {
                                    phi_4499_ = _e665;
                                    phi_4065_ = _e667;
                                    phi_4066_ = _e707;
                                    phi_4067_ = _e671;
                                    phi_4068_ = _e709;
                                    phi_4069_ = _e711;
                                }
                                let _e2151 = phi_4499_;
                                let _e2153 = phi_4065_;
                                let _e2155 = phi_4066_;
                                let _e2157 = phi_4067_;
                                let _e2159 = phi_4068_;
                                let _e2161 = phi_4069_;
                                phi_4498_ = _e2151;
                                phi_4070_ = _e2153;
                                phi_4071_ = _e2155;
                                phi_4072_ = _e2157;
                                phi_4073_ = _e2159;
                                phi_4074_ = _e2161;
                            } else {
                                phi_4498_ = _e665;
                                phi_4070_ = type_43();
                                phi_4071_ = type_50();
                                phi_4072_ = u32();
                                phi_4073_ = bool();
                                phi_4074_ = u32();
                            }
                            let _e2163 = phi_4498_;
                            let _e2165 = phi_4070_;
                            let _e2167 = phi_4071_;
                            let _e2169 = phi_4072_;
                            let _e2171 = phi_4073_;
                            let _e2173 = phi_4074_;
                            phi_4497_ = _e2163;
                            phi_1077_ = _e2165;
                            phi_1080_ = _e2167;
                            phi_1082_ = _e2169;
                            phi_1084_ = _e2171;
                            phi_1086_ = _e2173;
                            phi_4075_ = _e679;
                        } else {
                            phi_4497_ = _e665;
                            phi_1077_ = type_43();
                            phi_1080_ = type_50();
                            phi_1082_ = u32();
                            phi_1084_ = bool();
                            phi_1086_ = u32();
                            phi_4075_ = false;
                        }
                        let _e2175 = phi_4497_;
                        let _e2177 = phi_1077_;
                        let _e2179 = phi_1080_;
                        let _e2181 = phi_1082_;
                        let _e2183 = phi_1084_;
                        let _e2185 = phi_1086_;
                        let _e2187 = phi_4075_;
                        continue;
                        continuing {
                            phi_4295_ = _e2175;
                            phi_1076_ = _e2177;
                            phi_1079_ = _e2179;
                            phi_1081_ = _e2181;
                            phi_1083_ = _e2183;
                            phi_1085_ = _e2185;
                            phi_4496_ = _e2175;
                            break if !(_e2187);
                        }
                    }
                    let _e2190 = phi_4496_;
                    if _e2190 {
                        break;
                    }
                    let _e2192 = local_10;
                    let _e2195 = local_11;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153][0u] = _e2192.member_1;
                    global_6.member[_e153][1u] = _e2195.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
