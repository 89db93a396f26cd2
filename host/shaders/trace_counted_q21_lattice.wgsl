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

struct type_20 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: type_24,
    member_1: f32,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_45;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;

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
    var phi_1076_: type_39;
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
    var phi_1203_: type_39;
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
    var phi_2749_: type_24;
    var phi_2751_: type_24;
    var phi_2752_: bool;
    var phi_2756_: type_24;
    var phi_2757_: type_24;
    var phi_2758_: type_24;
    var phi_2759_: bool;
    var phi_2763_: type_24;
    var phi_2764_: bool;
    var phi_2765_: type_24;
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_2768_: type_24;
    var phi_2769_: bool;
    var phi_2770_: bool;
    var phi_2778_: type_24;
    var phi_2779_: bool;
    var phi_2783_: type_24;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var phi_2816_: type_39;
    var phi_2817_: type_39;
    var phi_2818_: type_39;
    var phi_1204_: type_39;
    var phi_4289_: bool;
    var phi_4500_: bool;
    var phi_4061_: type_39;
    var phi_4062_: type_50;
    var phi_4063_: bool;
    var phi_4064_: u32;
    var phi_4499_: bool;
    var phi_4065_: type_39;
    var phi_4066_: type_50;
    var phi_4067_: u32;
    var phi_4068_: bool;
    var phi_4069_: u32;
    var phi_4498_: bool;
    var phi_4070_: type_39;
    var phi_4071_: type_50;
    var phi_4072_: u32;
    var phi_4073_: bool;
    var phi_4074_: u32;
    var phi_4497_: bool;
    var phi_1077_: type_39;
    var phi_1080_: type_50;
    var phi_1082_: u32;
    var phi_1084_: bool;
    var phi_1086_: u32;
    var phi_4075_: bool;
    var phi_4496_: bool;
    var local_10: type_39;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_4.member));
            let _e96 = arrayLength((&global_5.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[0u][3u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e131 = global_1.member[0u];
            let _e132 = bitcast<i32>(_e131);
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e150 = (_e91.x + (_e91.y * 2097152u));
            let _e151 = (_e150 < arrayLength((&global_3.member)));
            if _e151 {
                let _e152 = (_e150 < arrayLength((&global_6.member)));
                if _e152 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e160 = global_3.member[_e150].member_2[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_3.member[_e150].member_2[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_3.member[_e150].member_2[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_3.member[_e150].member[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_3.member[_e150].member[1u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_3.member[_e150].member[2u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e199 = select(_e169, _e162, (_e169 < _e162));
                    let _e201 = select(_e176, _e199, (_e176 < _e199));
                    let _e203 = select(_e183, _e201, (_e183 < _e201));
                    let _e205 = select(_e190, _e203, (_e190 < _e203));
                    let _e207 = select(_e197, _e205, (_e197 < _e205));
                    let _e211 = global_3.member[_e150].member_1;
                    let _e212 = bitcast<u32>(_e211);
                    let _e213 = (_e212 & 2147483647u);
                    let _e220 = global_3.member[_e150].member_3;
                    let _e221 = bitcast<u32>(_e220);
                    let _e222 = (_e221 & 2147483647u);
                    let _e226 = (((select(_e213, _e207, (_e213 < _e207)) < 2139095040u) && (_e222 <= 2139095040u)) && (_e201 > 0u));
                    if _e226 {
                        let _e229 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                        if (_e229 >= 8388608u) {
                            phi_397_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_397_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_397_;
                        phi_398_ = _e243;
                    } else {
                        phi_398_ = 0i;
                    }
                    let _e245 = phi_398_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_408_ = true;
                    } else {
                        phi_408_ = (_e169 == _e201);
                    }
                    let _e249 = phi_408_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_418_ = _e251;
                        phi_419_ = _e251;
                        phi_421_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_418_ = u32();
                        phi_419_ = 0u;
                        phi_421_ = true;
                    }
                    let _e255 = phi_418_;
                    let _e257 = phi_419_;
                    let _e259 = phi_421_;
                    if _e259 {
                        phi_426_ = (_e257 + 1u);
                    } else {
                        phi_426_ = 0u;
                    }
                    let _e263 = phi_426_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_438_ = -126i;
                    } else {
                        phi_438_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_438_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_458_ = -126i;
                    } else {
                        phi_458_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_458_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_3.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_476_ = _e302[0];
                    } else {
                        phi_476_ = _e302[1];
                    }
                    let _e307 = phi_476_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_482_ = _e302[2];
                    } else {
                        phi_482_ = _e307;
                    }
                    let _e311 = phi_482_;
                    let _e312 = bitcast<u32>(_e311);
                    let _e314 = ((_e312 & 2139095040u) != 0u);
                    let _e328 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e311, _e314) * _e275) * select(0.00000011920929f, 1f, _e314)) * _e281);
                    let _e329 = global_3.member[_e150].member_2;
                    if _e303 {
                        phi_522_ = _e329[0];
                    } else {
                        phi_522_ = _e329[1];
                    }
                    let _e333 = phi_522_;
                    if _e308 {
                        phi_528_ = _e329[2];
                    } else {
                        phi_528_ = _e333;
                    }
                    let _e336 = phi_528_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e292) * select(0.00000011920929f, 1f, _e339)) * _e298);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e357 {
                        let _e361 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_580_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e365 = phi_580_;
                    let _e366 = (_e328 + _e365);
                    let _e367 = (_e328 - _e365);
                    let _e368 = select(_e353, 0f, _e357);
                    if _e357 {
                        phi_591_ = 38685626000000000000000000f;
                    } else {
                        phi_591_ = (1f / _e353);
                    }
                    let _e371 = phi_591_;
                    let _e372 = (_e263 == 0u);
                    if _e372 {
                        phi_600_ = _e302[0];
                    } else {
                        phi_600_ = _e302[1];
                    }
                    let _e376 = phi_600_;
                    let _e377 = (_e263 == 2u);
                    if _e377 {
                        phi_606_ = _e302[2];
                    } else {
                        phi_606_ = _e376;
                    }
                    let _e380 = phi_606_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e275) * select(0.00000011920929f, 1f, _e383)) * _e281);
                    if _e372 {
                        phi_646_ = _e329[0];
                    } else {
                        phi_646_ = _e329[1];
                    }
                    let _e401 = phi_646_;
                    if _e377 {
                        phi_652_ = _e329[2];
                    } else {
                        phi_652_ = _e401;
                    }
                    let _e404 = phi_652_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e292) * select(0.00000011920929f, 1f, _e407)) * _e298);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_704_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_704_ = 0f;
                    }
                    let _e433 = phi_704_;
                    let _e434 = (_e397 + _e433);
                    let _e435 = (_e397 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_715_ = 38685626000000000000000000f;
                    } else {
                        phi_715_ = (1f / _e421);
                    }
                    let _e439 = phi_715_;
                    let _e440 = (_e265 == 0u);
                    if _e440 {
                        phi_724_ = _e302[0];
                    } else {
                        phi_724_ = _e302[1];
                    }
                    let _e444 = phi_724_;
                    let _e445 = (_e265 == 2u);
                    if _e445 {
                        phi_730_ = _e302[2];
                    } else {
                        phi_730_ = _e444;
                    }
                    let _e448 = phi_730_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e275) * select(0.00000011920929f, 1f, _e451)) * _e281);
                    if _e440 {
                        phi_770_ = _e329[0];
                    } else {
                        phi_770_ = _e329[1];
                    }
                    let _e469 = phi_770_;
                    if _e445 {
                        phi_776_ = _e329[2];
                    } else {
                        phi_776_ = _e469;
                    }
                    let _e472 = phi_776_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e292) * select(0.00000011920929f, 1f, _e475)) * _e298);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e493 {
                        let _e497 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                        phi_828_ = select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f));
                    } else {
                        phi_828_ = 0f;
                    }
                    let _e501 = phi_828_;
                    let _e502 = (_e465 + _e501);
                    let _e503 = (_e465 - _e501);
                    let _e504 = select(_e489, 0f, _e493);
                    if _e493 {
                        phi_839_ = 38685626000000000000000000f;
                    } else {
                        phi_839_ = (1f / _e489);
                    }
                    let _e507 = phi_839_;
                    let _e510 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e513 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e515 = select(_e513, _e510, (_e510 > _e513));
                    let _e518 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                    let _e521 = (_e132 + _e245);
                    if (_e226 && (select(_e518, _e515, (_e515 > _e518)) <= 1099511600000f)) {
                        let _e531 = ((_e213 & 8388607u) | (select(0u, 1u, ((_e213 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e534 = bitcast<i32>((_e213 >> bitcast<u32>(23i)));
                        let _e538 = (_e531 == 0u);
                        let _e541 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e531)), 32u, _e538)) - 8i);
                        if (_e534 == 255i) {
                            phi_894_ = 255i;
                        } else {
                            phi_894_ = (((_e534 + select(0i, 1i, (_e534 == 0i))) - _e541) + _e521);
                        }
                        let _e549 = phi_894_;
                        let _e559 = (_e549 <= 0i);
                        if _e559 {
                            phi_917_ = u32();
                        } else {
                            if _e538 {
                                phi_916_ = u32();
                            } else {
                                phi_916_ = select(((bitcast<u32>(_e549) << bitcast<u32>(23i)) | ((_e531 << bitcast<u32>(((_e541 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e549 >= 255i));
                            }
                            let _e563 = phi_916_;
                            phi_917_ = _e563;
                        }
                        let _e565 = phi_917_;
                        let _e577 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e580 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e584 = (_e577 == 0u);
                        let _e587 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e577)), 32u, _e584)) - 8i);
                        if (_e580 == 255i) {
                            phi_954_ = 255i;
                        } else {
                            phi_954_ = (((_e580 + select(0i, 1i, (_e580 == 0i))) - _e587) + _e521);
                        }
                        let _e595 = phi_954_;
                        let _e605 = (_e595 <= 0i);
                        if _e605 {
                            phi_977_ = u32();
                        } else {
                            if _e584 {
                                phi_976_ = u32();
                            } else {
                                phi_976_ = select(((bitcast<u32>(_e595) << bitcast<u32>(23i)) | ((_e577 << bitcast<u32>(((_e587 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e595 >= 255i));
                            }
                            let _e609 = phi_976_;
                            phi_977_ = _e609;
                        }
                        let _e611 = phi_977_;
                        phi_985_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e611, 0u, select(_e584, true, _e605))));
                        phi_986_ = bitcast<f32>(((_e212 & 2147483648u) | select(_e565, 0u, select(_e538, true, _e559))));
                    } else {
                        phi_985_ = 0f;
                        phi_986_ = 1f;
                    }
                    let _e617 = phi_985_;
                    let _e619 = phi_986_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e624 = (_e264 % 3u);
                    let _e625 = (_e624 < 3u);
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e627 = local_1[_e624];
                    let _e630 = (_e263 % 3u);
                    let _e631 = (_e630 < 3u);
                    if _e631 {
                    } else {
                        break;
                    }
                    let _e633 = local_1[_e630];
                    let _e636 = (_e265 % 3u);
                    let _e637 = (_e636 < 3u);
                    if _e637 {
                    } else {
                        break;
                    }
                    let _e639 = local_1[_e636];
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e644 = local[_e624];
                    if _e631 {
                    } else {
                        break;
                    }
                    let _e648 = local[_e630];
                    if _e637 {
                    } else {
                        break;
                    }
                    let _e652 = local[_e636];
                    phi_4295_ = false;
                    phi_1076_ = type_39(type_32(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e617), 0u, 0u);
                    phi_1079_ = type_50(type_28(vec4<f32>((f32(_e627) * _e144), (f32(_e633) * _e144), (f32(_e639) * _e144), 0f), vec4<f32>((f32(_e644) * _e144), (f32(_e648) * _e144), (f32(_e652) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_1081_ = ((3u * _e93) + 1u);
                    phi_1083_ = (_e619 <= _e617);
                    phi_1085_ = 0u;
                    loop {
                        let _e662 = phi_4295_;
                        let _e664 = phi_1076_;
                        let _e666 = phi_1079_;
                        let _e668 = phi_1081_;
                        let _e670 = phi_1083_;
                        let _e672 = phi_1085_;
                        local_10 = _e664;
                        local_11 = _e664;
                        if _e670 {
                            phi_1096_ = true;
                        } else {
                            phi_1096_ = (_e672 > 0u);
                        }
                        let _e675 = phi_1096_;
                        if _e675 {
                            let _e676 = (_e668 > 0u);
                            if _e676 {
                                if _e670 {
                                    phi_1182_ = _e666;
                                    phi_1183_ = _e670;
                                    phi_1184_ = _e672;
                                } else {
                                    let _e677 = (_e672 - 1u);
                                    let _e678 = (_e677 % 128u);
                                    let _e679 = (_e678 < 128u);
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e681 = local_7[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e683 = local_6[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e685 = local_5[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e687 = local_4[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e689 = local_3[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e691 = local_2[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e696 = local_8[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4496_ = true;
                                        break;
                                    }
                                    let _e699 = local_9[_e678];
                                    phi_1182_ = type_50(type_28(vec4<f32>(_e681, _e683, _e685, 0f), vec4<f32>(_e687, _e689, _e691, 0f)), _e696);
                                    phi_1183_ = (_e699 <= _e664.member.member_1);
                                    phi_1184_ = _e677;
                                }
                                let _e704 = phi_1182_;
                                let _e706 = phi_1183_;
                                let _e708 = phi_1184_;
                                if _e706 {
                                    let _e713 = (_e704.member_1 & 268435455u);
                                    if ((_e704.member_1 & 2147483648u) != 0u) {
                                        phi_1203_ = _e664;
                                        phi_1206_ = type_8(0u, ((_e704.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1204 = phi_1203_;
                                            let _e1206 = phi_1206_;
                                            local_12 = _e1204;
                                            if (_e1206.member < _e1206.member_1) {
                                                phi_1207_ = type_8((_e1206.member + 1u), _e1206.member_1);
                                                phi_1229_ = type_8(1u, _e1206.member);
                                            } else {
                                                phi_1207_ = _e1206;
                                                phi_1229_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1219 = phi_1207_;
                                            let _e1221 = phi_1229_;
                                            let _e1225 = (bitcast<i32>(_e1221.member) != 0i);
                                            if _e1225 {
                                                let _e1231 = type_39(_e1204.member, _e1204.member_1, (_e1204.member_2 + 1u));
                                                let _e1236 = (_e704.member.member_1.x - _e704.member.member.x);
                                                let _e1239 = (_e704.member.member_1.y - _e704.member.member.y);
                                                let _e1242 = (_e704.member.member_1.z - _e704.member.member.z);
                                                let _e1244 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                let _e1246 = select(_e1242, _e1244, (_e1244 > _e1242));
                                                let _e1248 = (_e1246 < (1024f * _e144));
                                                if _e1248 {
                                                    phi_1273_ = 0u;
                                                } else {
                                                    phi_1273_ = select(2u, 1u, (_e1246 < (2097152f * _e144)));
                                                }
                                                let _e1253 = phi_1273_;
                                                switch bitcast<i32>(_e1253) {
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
                                                let _e1256 = phi_1279_;
                                                switch bitcast<i32>(_e1253) {
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
                                                let _e1263 = phi_1289_;
                                                let _e1265 = ((_e713 + (_e1221.member_1 * ((3u * _e1256) + 1u))) + (3u * _e1263));
                                                let _e1266 = (_e1265 < _e96);
                                                if _e1266 {
                                                    if _e1266 {
                                                    } else {
                                                        phi_4289_ = true;
                                                        break;
                                                    }
                                                    let _e1268 = global_5.member[_e1265];
                                                    phi_1305_ = _e1268;
                                                } else {
                                                    phi_1305_ = 4294967295u;
                                                }
                                                let _e1270 = phi_1305_;
                                                if _e1248 {
                                                    phi_1338_ = 0u;
                                                } else {
                                                    phi_1338_ = select(2u, 1u, (_e1246 < (2097152f * _e144)));
                                                }
                                                let _e1275 = phi_1338_;
                                                switch bitcast<i32>(_e1275) {
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
                                                let _e1278 = phi_1344_;
                                                let _e1282 = (_e713 + (_e1221.member_1 * ((3u * _e1278) + 1u)));
                                                switch bitcast<i32>(_e1275) {
                                                    case 0: {
                                                        let _e1557 = (_e1282 < _e96);
                                                        if _e1557 {
                                                            if _e1557 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1559 = global_5.member[_e1282];
                                                            phi_1368_ = _e1559;
                                                        } else {
                                                            phi_1368_ = 0u;
                                                        }
                                                        let _e1561 = phi_1368_;
                                                        let _e1563 = ((10u * _e264) & 31u);
                                                        let _e1573 = ((10u * _e263) & 31u);
                                                        let _e1583 = ((10u * _e265) & 31u);
                                                        let _e1593 = (_e1282 + 1u);
                                                        let _e1594 = (_e1593 < _e96);
                                                        if _e1594 {
                                                            if _e1594 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1596 = global_5.member[_e1593];
                                                            phi_1414_ = _e1596;
                                                        } else {
                                                            phi_1414_ = 0u;
                                                        }
                                                        let _e1598 = phi_1414_;
                                                        let _e1624 = (_e1282 + 2u);
                                                        let _e1625 = (_e1624 < _e96);
                                                        if _e1625 {
                                                            if _e1625 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1627 = global_5.member[_e1624];
                                                            phi_1460_ = _e1627;
                                                        } else {
                                                            phi_1460_ = 0u;
                                                        }
                                                        let _e1629 = phi_1460_;
                                                        phi_1943_ = array<array<f32, 3>, 3>(array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1561 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e144)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1561 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e144)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1561 >> bitcast<u32>(_e1583)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1598 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e144)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1598 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e144)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1598 >> bitcast<u32>(_e1583)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1629 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e144)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1629 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e144)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1629 >> bitcast<u32>(_e1583)) & 1023u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1371 = (_e1282 < _e96);
                                                        if _e1371 {
                                                            if _e1371 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1373 = global_5.member[_e1282];
                                                            phi_1506_ = _e1373;
                                                        } else {
                                                            phi_1506_ = 0u;
                                                        }
                                                        let _e1375 = phi_1506_;
                                                        let _e1376 = (_e1282 + 1u);
                                                        let _e1377 = (_e1376 < _e96);
                                                        if _e1377 {
                                                            if _e1377 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1379 = global_5.member[_e1376];
                                                            phi_1521_ = _e1379;
                                                        } else {
                                                            phi_1521_ = 0u;
                                                        }
                                                        let _e1381 = phi_1521_;
                                                        let _e1382 = (_e264 == 1u);
                                                        if _e1382 {
                                                            phi_1531_ = ((_e1375 >> bitcast<u32>(21i)) | (_e1381 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1531_ = (_e1381 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1391 = phi_1531_;
                                                        let _e1399 = (_e263 == 1u);
                                                        if _e1399 {
                                                            phi_1552_ = ((_e1375 >> bitcast<u32>(21i)) | (_e1381 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1552_ = (_e1381 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1408 = phi_1552_;
                                                        let _e1416 = (_e265 == 1u);
                                                        if _e1416 {
                                                            phi_1573_ = ((_e1375 >> bitcast<u32>(21i)) | (_e1381 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1573_ = (_e1381 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1425 = phi_1573_;
                                                        let _e1434 = (_e1282 + 2u);
                                                        let _e1435 = (_e1434 < _e96);
                                                        if _e1435 {
                                                            if _e1435 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1437 = global_5.member[_e1434];
                                                            phi_1600_ = _e1437;
                                                        } else {
                                                            phi_1600_ = 0u;
                                                        }
                                                        let _e1439 = phi_1600_;
                                                        let _e1440 = (_e1282 + 3u);
                                                        let _e1441 = (_e1440 < _e96);
                                                        if _e1441 {
                                                            if _e1441 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1443 = global_5.member[_e1440];
                                                            phi_1615_ = _e1443;
                                                        } else {
                                                            phi_1615_ = 0u;
                                                        }
                                                        let _e1445 = phi_1615_;
                                                        if _e1382 {
                                                            phi_1625_ = ((_e1439 >> bitcast<u32>(21i)) | (_e1445 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1625_ = (_e1445 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1454 = phi_1625_;
                                                        if _e1399 {
                                                            phi_1646_ = ((_e1439 >> bitcast<u32>(21i)) | (_e1445 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1646_ = (_e1445 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1470 = phi_1646_;
                                                        if _e1416 {
                                                            phi_1667_ = ((_e1439 >> bitcast<u32>(21i)) | (_e1445 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1667_ = (_e1445 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1486 = phi_1667_;
                                                        let _e1495 = (_e1282 + 4u);
                                                        let _e1496 = (_e1495 < _e96);
                                                        if _e1496 {
                                                            if _e1496 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1498 = global_5.member[_e1495];
                                                            phi_1694_ = _e1498;
                                                        } else {
                                                            phi_1694_ = 0u;
                                                        }
                                                        let _e1500 = phi_1694_;
                                                        let _e1501 = (_e1282 + 5u);
                                                        let _e1502 = (_e1501 < _e96);
                                                        if _e1502 {
                                                            if _e1502 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1504 = global_5.member[_e1501];
                                                            phi_1709_ = _e1504;
                                                        } else {
                                                            phi_1709_ = 0u;
                                                        }
                                                        let _e1506 = phi_1709_;
                                                        if _e1382 {
                                                            phi_1719_ = ((_e1500 >> bitcast<u32>(21i)) | (_e1506 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1719_ = (_e1506 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1515 = phi_1719_;
                                                        if _e1399 {
                                                            phi_1740_ = ((_e1500 >> bitcast<u32>(21i)) | (_e1506 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1740_ = (_e1506 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1531 = phi_1740_;
                                                        if _e1416 {
                                                            phi_1761_ = ((_e1500 >> bitcast<u32>(21i)) | (_e1506 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1761_ = (_e1506 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1547 = phi_1761_;
                                                        phi_1943_ = array<array<f32, 3>, 3>(array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1391, _e1375, _e303) & 2097151u))) - 8388608f) * _e144)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1408, _e1375, _e372) & 2097151u))) - 8388608f) * _e144)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1425, _e1375, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1454, _e1439, _e303) & 2097151u))) - 8388608f) * _e144)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1470, _e1439, _e372) & 2097151u))) - 8388608f) * _e144)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1486, _e1439, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1515, _e1500, _e303) & 2097151u))) - 8388608f) * _e144)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1531, _e1500, _e372) & 2097151u))) - 8388608f) * _e144)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1547, _e1500, _e440) & 2097151u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1284 = (_e1282 + _e264);
                                                        let _e1285 = (_e1284 < _e96);
                                                        if _e1285 {
                                                            if _e1285 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1287 = global_5.member[_e1284];
                                                            phi_1789_ = _e1287;
                                                        } else {
                                                            phi_1789_ = 0u;
                                                        }
                                                        let _e1289 = phi_1789_;
                                                        let _e1293 = (_e1282 + _e263);
                                                        let _e1294 = (_e1293 < _e96);
                                                        if _e1294 {
                                                            if _e1294 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1296 = global_5.member[_e1293];
                                                            phi_1807_ = _e1296;
                                                        } else {
                                                            phi_1807_ = 0u;
                                                        }
                                                        let _e1298 = phi_1807_;
                                                        let _e1302 = (_e1282 + _e265);
                                                        let _e1303 = (_e1302 < _e96);
                                                        if _e1303 {
                                                            if _e1303 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1305 = global_5.member[_e1302];
                                                            phi_1825_ = _e1305;
                                                        } else {
                                                            phi_1825_ = 0u;
                                                        }
                                                        let _e1307 = phi_1825_;
                                                        let _e1312 = (_e1282 + 3u);
                                                        let _e1313 = (_e1312 + _e264);
                                                        let _e1314 = (_e1313 < _e96);
                                                        if _e1314 {
                                                            if _e1314 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1316 = global_5.member[_e1313];
                                                            phi_1845_ = _e1316;
                                                        } else {
                                                            phi_1845_ = 0u;
                                                        }
                                                        let _e1318 = phi_1845_;
                                                        let _e1322 = (_e1312 + _e263);
                                                        let _e1323 = (_e1322 < _e96);
                                                        if _e1323 {
                                                            if _e1323 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1325 = global_5.member[_e1322];
                                                            phi_1863_ = _e1325;
                                                        } else {
                                                            phi_1863_ = 0u;
                                                        }
                                                        let _e1327 = phi_1863_;
                                                        let _e1331 = (_e1312 + _e265);
                                                        let _e1332 = (_e1331 < _e96);
                                                        if _e1332 {
                                                            if _e1332 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1334 = global_5.member[_e1331];
                                                            phi_1881_ = _e1334;
                                                        } else {
                                                            phi_1881_ = 0u;
                                                        }
                                                        let _e1336 = phi_1881_;
                                                        let _e1341 = (_e1282 + 6u);
                                                        let _e1342 = (_e1341 + _e264);
                                                        let _e1343 = (_e1342 < _e96);
                                                        if _e1343 {
                                                            if _e1343 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1345 = global_5.member[_e1342];
                                                            phi_1901_ = _e1345;
                                                        } else {
                                                            phi_1901_ = 0u;
                                                        }
                                                        let _e1347 = phi_1901_;
                                                        let _e1351 = (_e1341 + _e263);
                                                        let _e1352 = (_e1351 < _e96);
                                                        if _e1352 {
                                                            if _e1352 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1354 = global_5.member[_e1351];
                                                            phi_1919_ = _e1354;
                                                        } else {
                                                            phi_1919_ = 0u;
                                                        }
                                                        let _e1356 = phi_1919_;
                                                        let _e1360 = (_e1341 + _e265);
                                                        let _e1361 = (_e1360 < _e96);
                                                        if _e1361 {
                                                            if _e1361 {
                                                            } else {
                                                                phi_4289_ = true;
                                                                break;
                                                            }
                                                            let _e1363 = global_5.member[_e1360];
                                                            phi_1937_ = _e1363;
                                                        } else {
                                                            phi_1937_ = 0u;
                                                        }
                                                        let _e1365 = phi_1937_;
                                                        phi_1943_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1289)) * _e144), (f32(bitcast<i32>(_e1298)) * _e144), (f32(bitcast<i32>(_e1307)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1318)) * _e144), (f32(bitcast<i32>(_e1327)) * _e144), (f32(bitcast<i32>(_e1336)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1347)) * _e144), (f32(bitcast<i32>(_e1356)) * _e144), (f32(bitcast<i32>(_e1365)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1943_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1657 = phi_1943_;
                                                let _e1666 = (_e1657[0][2] - _e465);
                                                let _e1669 = (((_e1657[0][0] - _e328) * _e504) - (_e1666 * _e368));
                                                let _e1672 = (((_e1657[0][1] - _e397) * _e504) - (_e1666 * _e436));
                                                let _e1679 = (_e1657[1][2] - _e465);
                                                let _e1682 = (((_e1657[1][0] - _e328) * _e504) - (_e1679 * _e368));
                                                let _e1685 = (((_e1657[1][1] - _e397) * _e504) - (_e1679 * _e436));
                                                let _e1692 = (_e1657[2][2] - _e465);
                                                let _e1695 = (((_e1657[2][0] - _e328) * _e504) - (_e1692 * _e368));
                                                let _e1698 = (((_e1657[2][1] - _e397) * _e504) - (_e1692 * _e436));
                                                let _e1699 = (_e1695 * _e1685);
                                                let _e1700 = (_e1698 * _e1682);
                                                let _e1701 = (_e1669 * _e1698);
                                                let _e1702 = (_e1672 * _e1695);
                                                let _e1703 = (_e1682 * _e1672);
                                                let _e1704 = (_e1685 * _e1669);
                                                let _e1709 = (((_e1699 >= _e1700) && (_e1701 >= _e1702)) && (_e1703 >= _e1704));
                                                if (_e1709 || (((_e1699 <= _e1700) && (_e1701 <= _e1702)) && (_e1703 <= _e1704))) {
                                                    let _e1716 = select(-1f, 1f, _e1709);
                                                    let _e1718 = ((_e1699 - _e1700) * _e1716);
                                                    let _e1720 = select(0f, _e1718, (_e1718 > 0f));
                                                    let _e1722 = ((_e1701 - _e1702) * _e1716);
                                                    let _e1724 = select(0f, _e1722, (_e1722 > 0f));
                                                    let _e1726 = ((_e1703 - _e1704) * _e1716);
                                                    let _e1728 = select(0f, _e1726, (_e1726 > 0f));
                                                    let _e1730 = ((_e1720 + _e1724) + _e1728);
                                                    if (_e1730 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2768_ = type_24();
                                                        phi_2769_ = true;
                                                        phi_2770_ = false;
                                                    } else {
                                                        let _e1733 = select(_e1682, _e1669, (_e1669 < _e1682));
                                                        if (select(_e1695, _e1733, (_e1733 < _e1695)) > 0f) {
                                                            phi_2060_ = true;
                                                        } else {
                                                            let _e1738 = select(_e1682, _e1669, (_e1669 > _e1682));
                                                            phi_2060_ = (select(_e1695, _e1738, (_e1738 > _e1695)) < 0f);
                                                        }
                                                        let _e1743 = phi_2060_;
                                                        if _e1743 {
                                                            phi_2765_ = type_24();
                                                            phi_2766_ = true;
                                                            phi_2767_ = false;
                                                        } else {
                                                            let _e1745 = select(_e1685, _e1672, (_e1672 < _e1685));
                                                            if (select(_e1698, _e1745, (_e1745 < _e1698)) > 0f) {
                                                                phi_2089_ = true;
                                                            } else {
                                                                let _e1750 = select(_e1685, _e1672, (_e1672 > _e1685));
                                                                phi_2089_ = (select(_e1698, _e1750, (_e1750 > _e1698)) < 0f);
                                                            }
                                                            let _e1755 = phi_2089_;
                                                            if _e1755 {
                                                                phi_2763_ = type_24();
                                                                phi_2764_ = false;
                                                            } else {
                                                                let _e1757 = select(_e1657[1][0], _e1657[0][0], (_e1657[0][0] < _e1657[1][0]));
                                                                let _e1761 = select(_e1657[1][0], _e1657[0][0], (_e1657[0][0] > _e1657[1][0]));
                                                                let _e1765 = select(_e1657[1][1], _e1657[0][1], (_e1657[0][1] < _e1657[1][1]));
                                                                let _e1769 = select(_e1657[1][1], _e1657[0][1], (_e1657[0][1] > _e1657[1][1]));
                                                                let _e1773 = select(_e1657[1][2], _e1657[0][2], (_e1657[0][2] < _e1657[1][2]));
                                                                let _e1777 = select(_e1657[1][2], _e1657[0][2], (_e1657[0][2] > _e1657[1][2]));
                                                                let _e1782 = ((select(_e1657[2][0], _e1757, (_e1757 < _e1657[2][0])) - _e366) * _e371);
                                                                let _e1783 = ((select(_e1657[2][0], _e1761, (_e1761 > _e1657[2][0])) - _e367) * _e371);
                                                                let _e1786 = ((select(_e1657[2][1], _e1765, (_e1765 < _e1657[2][1])) - _e434) * _e439);
                                                                let _e1787 = ((select(_e1657[2][1], _e1769, (_e1769 > _e1657[2][1])) - _e435) * _e439);
                                                                let _e1790 = ((select(_e1657[2][2], _e1773, (_e1773 < _e1657[2][2])) - _e502) * _e507);
                                                                let _e1791 = ((select(_e1657[2][2], _e1777, (_e1777 > _e1657[2][2])) - _e503) * _e507);
                                                                let _e1793 = select(_e1791, _e1790, (_e1790 < _e1791));
                                                                let _e1795 = select(_e1791, _e1790, (_e1790 > _e1791));
                                                                let _e1797 = select(_e1783, _e1782, (_e1782 < _e1783));
                                                                let _e1799 = select(_e1787, _e1786, (_e1786 < _e1787));
                                                                let _e1801 = select(_e1799, _e1797, (_e1797 > _e1799));
                                                                let _e1803 = select(_e1793, _e1801, (_e1801 > _e1793));
                                                                let _e1805 = select(_e1783, _e1782, (_e1782 > _e1783));
                                                                let _e1807 = select(_e1787, _e1786, (_e1786 > _e1787));
                                                                let _e1809 = select(_e1807, _e1805, (_e1805 < _e1807));
                                                                let _e1811 = select(_e1795, _e1809, (_e1809 < _e1795));
                                                                let _e1812 = -(_e1793);
                                                                let _e1818 = select(_e619, _e1803, (_e1803 > _e619));
                                                                if (_e1818 > (_e1811 + (select(_e1812, _e1795, (_e1795 > _e1812)) * 0.0000019073523f))) {
                                                                    phi_2758_ = type_24();
                                                                    phi_2759_ = true;
                                                                } else {
                                                                    let _e1820 = (_e1818 > _e1204.member.member_1);
                                                                    if _e1820 {
                                                                        phi_2757_ = type_24();
                                                                    } else {
                                                                        let _e1821 = vec3<f32>(_e1657[0][0], _e1657[0][1], _e1657[0][2]);
                                                                        let _e1822 = vec3<f32>(_e1657[1][0], _e1657[1][1], _e1657[1][2]);
                                                                        let _e1823 = vec3<f32>(_e1657[2][0], _e1657[2][1], _e1657[2][2]);
                                                                        let _e1824 = (_e1657[1][0] - _e1657[0][0]);
                                                                        let _e1825 = (_e1657[1][1] - _e1657[0][1]);
                                                                        let _e1826 = (_e1657[1][2] - _e1657[0][2]);
                                                                        let _e1827 = vec3<f32>(_e1824, _e1825, _e1826);
                                                                        let _e1828 = (_e1657[2][0] - _e1657[1][0]);
                                                                        let _e1829 = (_e1657[2][1] - _e1657[1][1]);
                                                                        let _e1830 = (_e1657[2][2] - _e1657[1][2]);
                                                                        let _e1831 = vec3<f32>(_e1828, _e1829, _e1830);
                                                                        let _e1832 = (_e1657[0][0] - _e1657[2][0]);
                                                                        let _e1833 = (_e1657[0][1] - _e1657[2][1]);
                                                                        let _e1834 = (_e1657[0][2] - _e1657[2][2]);
                                                                        let _e1835 = vec3<f32>(_e1832, _e1833, _e1834);
                                                                        let _e1838 = bitcast<f32>((bitcast<u32>(_e1824) & 2147483647u));
                                                                        let _e1841 = bitcast<f32>((bitcast<u32>(_e1825) & 2147483647u));
                                                                        let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                        let _e1846 = bitcast<f32>((bitcast<u32>(_e1826) & 2147483647u));
                                                                        let _e1848 = select(_e1846, _e1843, (_e1843 > _e1846));
                                                                        let _e1851 = bitcast<f32>((bitcast<u32>(_e1828) & 2147483647u));
                                                                        let _e1854 = bitcast<f32>((bitcast<u32>(_e1829) & 2147483647u));
                                                                        let _e1856 = select(_e1854, _e1851, (_e1851 > _e1854));
                                                                        let _e1859 = bitcast<f32>((bitcast<u32>(_e1830) & 2147483647u));
                                                                        let _e1861 = select(_e1859, _e1856, (_e1856 > _e1859));
                                                                        let _e1864 = bitcast<f32>((bitcast<u32>(_e1832) & 2147483647u));
                                                                        let _e1867 = bitcast<f32>((bitcast<u32>(_e1833) & 2147483647u));
                                                                        let _e1869 = select(_e1867, _e1864, (_e1864 > _e1867));
                                                                        let _e1872 = bitcast<f32>((bitcast<u32>(_e1834) & 2147483647u));
                                                                        let _e1874 = select(_e1872, _e1869, (_e1869 > _e1872));
                                                                        let _e1876 = select(_e1861, _e1848, (_e1848 > _e1861));
                                                                        let _e1878 = select(_e1874, _e1876, (_e1876 > _e1874));
                                                                        if (_e1848 == _e1878) {
                                                                            phi_2490_ = _e1685;
                                                                            phi_2491_ = _e1682;
                                                                            phi_2492_ = _e1672;
                                                                            phi_2493_ = _e1669;
                                                                            phi_2494_ = _e1821;
                                                                            phi_2495_ = _e1835;
                                                                            phi_2496_ = _e1831;
                                                                            phi_2497_ = _e1827;
                                                                        } else {
                                                                            let _e1880 = (_e1861 == _e1878);
                                                                            let _e1885 = vec3(_e1880);
                                                                            phi_2490_ = select(_e1672, _e1698, _e1880);
                                                                            phi_2491_ = select(_e1669, _e1695, _e1880);
                                                                            phi_2492_ = select(_e1698, _e1685, _e1880);
                                                                            phi_2493_ = select(_e1695, _e1682, _e1880);
                                                                            phi_2494_ = select(_e1823, _e1822, _e1885);
                                                                            phi_2495_ = select(_e1831, _e1827, _e1885);
                                                                            phi_2496_ = select(_e1827, _e1835, _e1885);
                                                                            phi_2497_ = select(_e1835, _e1831, _e1885);
                                                                        }
                                                                        let _e1891 = phi_2490_;
                                                                        let _e1893 = phi_2491_;
                                                                        let _e1895 = phi_2492_;
                                                                        let _e1897 = phi_2493_;
                                                                        let _e1899 = phi_2494_;
                                                                        let _e1901 = phi_2495_;
                                                                        let _e1903 = phi_2496_;
                                                                        let _e1905 = phi_2497_;
                                                                        let _e1912 = ((_e1903.y * _e1901.z) - (_e1901.y * _e1903.z));
                                                                        let _e1917 = ((_e1903.z * _e1901.x) - (_e1901.z * _e1903.x));
                                                                        let _e1920 = ((_e1903.x * _e1901.y) - (_e1901.x * _e1903.y));
                                                                        if (_e1720 >= _e1724) {
                                                                            phi_2528_ = select(true, false, (_e1720 >= _e1728));
                                                                        } else {
                                                                            phi_2528_ = true;
                                                                        }
                                                                        let _e1925 = phi_2528_;
                                                                        if _e1925 {
                                                                            phi_2537_ = select(_e1823, _e1822, vec3((_e1724 >= _e1728)));
                                                                        } else {
                                                                            phi_2537_ = _e1821;
                                                                        }
                                                                        let _e1930 = phi_2537_;
                                                                        let _e1941 = (((_e1912 * (_e1930.x - _e328)) + (_e1917 * (_e1930.y - _e397))) + (_e1920 * (_e1930.z - _e465)));
                                                                        let _e1946 = (((_e1912 * _e368) + (_e1917 * _e436)) + (_e1920 * _e504));
                                                                        let _e1947 = (_e1893 - _e1897);
                                                                        let _e1948 = (_e1891 - _e1895);
                                                                        let _e1956 = (-(((_e1897 * _e1947) + (_e1895 * _e1948))) / ((_e1947 * _e1947) + (_e1948 * _e1948)));
                                                                        let _e1958 = select(1f, _e1956, (_e1956 < 1f));
                                                                        let _e1960 = select(0f, _e1958, (_e1958 > 0f));
                                                                        let _e1973 = ((_e1899.x + (_e1905.x * _e1960)) - _e328);
                                                                        let _e1974 = ((_e1899.y + (_e1905.y * _e1960)) - _e397);
                                                                        let _e1975 = ((_e1899.z + (_e1905.z * _e1960)) - _e465);
                                                                        let _e1976 = (_e1975 / _e504);
                                                                        let _e1988 = bitcast<f32>((bitcast<u32>(_e1973) & 2147483647u));
                                                                        let _e1991 = bitcast<f32>((bitcast<u32>(_e1974) & 2147483647u));
                                                                        let _e1993 = select(_e1991, _e1988, (_e1988 > _e1991));
                                                                        let _e1996 = bitcast<f32>((bitcast<u32>(_e1975) & 2147483647u));
                                                                        let _e1998 = select(_e1996, _e1993, (_e1993 > _e1996));
                                                                        let _e2004 = bitcast<f32>((bitcast<u32>(_e1912) & 2147483647u));
                                                                        let _e2007 = bitcast<f32>((bitcast<u32>(_e1917) & 2147483647u));
                                                                        let _e2009 = select(_e2007, _e2004, (_e2004 > _e2007));
                                                                        let _e2012 = bitcast<f32>((bitcast<u32>(_e1920) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1912 * _e1973) + (_e1917 * _e1974)) + (_e1920 * _e1975)) - _e1941)) & 2147483647u)) <= ((0.0000009536743f * select(_e1878, _e1998, (_e1998 > _e1878))) * select(_e2012, _e2009, (_e2009 > _e2012)))) {
                                                                            let _e2022 = bitcast<f32>((bitcast<u32>(_e1903.x) & 2147483647u));
                                                                            let _e2025 = bitcast<f32>((bitcast<u32>(_e1903.y) & 2147483647u));
                                                                            let _e2027 = select(_e2025, _e2022, (_e2022 > _e2025));
                                                                            let _e2030 = bitcast<f32>((bitcast<u32>(_e1903.z) & 2147483647u));
                                                                            let _e2036 = bitcast<f32>((bitcast<u32>(_e1901.x) & 2147483647u));
                                                                            let _e2039 = bitcast<f32>((bitcast<u32>(_e1901.y) & 2147483647u));
                                                                            let _e2041 = select(_e2039, _e2036, (_e2036 > _e2039));
                                                                            let _e2044 = bitcast<f32>((bitcast<u32>(_e1901.z) & 2147483647u));
                                                                            let _e2048 = (bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u)) > ((0.0000038146973f * select(_e2030, _e2027, (_e2027 > _e2030))) * select(_e2044, _e2041, (_e2041 > _e2044))));
                                                                            if _e2048 {
                                                                                phi_2702_ = (_e1941 / _e1946);
                                                                            } else {
                                                                                phi_2702_ = f32();
                                                                            }
                                                                            let _e2051 = phi_2702_;
                                                                            phi_2704_ = _e2051;
                                                                            phi_2705_ = select(true, false, _e2048);
                                                                        } else {
                                                                            phi_2704_ = f32();
                                                                            phi_2705_ = true;
                                                                        }
                                                                        let _e2054 = phi_2704_;
                                                                        let _e2056 = phi_2705_;
                                                                        if _e2056 {
                                                                            let _e2064 = (((_e1912 * (_e1973 - (_e368 * _e1976))) + (_e1917 * (_e1974 - (_e436 * _e1976)))) / _e1946);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2064) & 2147483647u)) <= _e1878) {
                                                                                phi_2725_ = (_e1976 + _e2064);
                                                                            } else {
                                                                                phi_2725_ = _e1976;
                                                                            }
                                                                            let _e2071 = phi_2725_;
                                                                            phi_2726_ = _e2071;
                                                                        } else {
                                                                            phi_2726_ = _e2054;
                                                                        }
                                                                        let _e2073 = phi_2726_;
                                                                        let _e2075 = select(_e1811, _e2073, (_e2073 < _e1811));
                                                                        let _e2077 = select(_e1803, _e2075, (_e2075 > _e1803));
                                                                        if (_e2077 >= _e619) {
                                                                            let _e2079 = (_e2077 <= _e1204.member.member_1);
                                                                            if _e2079 {
                                                                                let _e2080 = (1f / _e1730);
                                                                                phi_2749_ = type_24(_e2077, (_e1724 * _e2080), (_e1728 * _e2080), _e1270);
                                                                            } else {
                                                                                phi_2749_ = type_24();
                                                                            }
                                                                            let _e2085 = phi_2749_;
                                                                            phi_2751_ = _e2085;
                                                                            phi_2752_ = select(true, false, _e2079);
                                                                        } else {
                                                                            phi_2751_ = type_24();
                                                                            phi_2752_ = true;
                                                                        }
                                                                        let _e2088 = phi_2751_;
                                                                        let _e2090 = phi_2752_;
                                                                        if _e2090 {
                                                                            phi_2756_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2756_ = _e2088;
                                                                        }
                                                                        let _e2092 = phi_2756_;
                                                                        phi_2757_ = _e2092;
                                                                    }
                                                                    let _e2094 = phi_2757_;
                                                                    phi_2758_ = _e2094;
                                                                    phi_2759_ = _e1820;
                                                                }
                                                                let _e2096 = phi_2758_;
                                                                let _e2098 = phi_2759_;
                                                                phi_2763_ = _e2096;
                                                                phi_2764_ = _e2098;
                                                            }
                                                            let _e2100 = phi_2763_;
                                                            let _e2102 = phi_2764_;
                                                            phi_2765_ = _e2100;
                                                            phi_2766_ = _e1755;
                                                            phi_2767_ = _e2102;
                                                        }
                                                        let _e2104 = phi_2765_;
                                                        let _e2106 = phi_2766_;
                                                        let _e2108 = phi_2767_;
                                                        phi_2768_ = _e2104;
                                                        phi_2769_ = _e2106;
                                                        phi_2770_ = _e2108;
                                                    }
                                                    let _e2110 = phi_2768_;
                                                    let _e2112 = phi_2769_;
                                                    let _e2114 = phi_2770_;
                                                    phi_2778_ = _e2110;
                                                    phi_2779_ = select(_e2114, true, _e2112);
                                                } else {
                                                    phi_2778_ = type_24();
                                                    phi_2779_ = true;
                                                }
                                                let _e2117 = phi_2778_;
                                                let _e2119 = phi_2779_;
                                                if _e2119 {
                                                    phi_2783_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2783_ = _e2117;
                                                }
                                                let _e2121 = phi_2783_;
                                                if (_e2121.member_3 != 4294967295u) {
                                                    if (_e1270 != 4294967295u) {
                                                        if (_e2121.member < _e1204.member.member.member) {
                                                            phi_2809_ = true;
                                                        } else {
                                                            if (_e2121.member == _e1204.member.member.member) {
                                                                phi_2808_ = (_e2121.member_3 < _e1204.member.member.member_3);
                                                            } else {
                                                                phi_2808_ = false;
                                                            }
                                                            let _e2136 = phi_2808_;
                                                            phi_2809_ = _e2136;
                                                        }
                                                        let _e2138 = phi_2809_;
                                                        if _e2138 {
                                                            phi_2816_ = type_39(type_32(_e2121, _e2121.member), _e1231.member_1, _e1231.member_2);
                                                        } else {
                                                            phi_2816_ = _e1231;
                                                        }
                                                        let _e2145 = phi_2816_;
                                                        phi_2817_ = _e2145;
                                                    } else {
                                                        phi_2817_ = _e1231;
                                                    }
                                                    let _e2147 = phi_2817_;
                                                    phi_2818_ = _e2147;
                                                } else {
                                                    phi_2818_ = _e1231;
                                                }
                                                let _e2149 = phi_2818_;
                                                phi_1204_ = _e2149;
                                            } else {
                                                phi_1204_ = type_39();
                                            }
                                            let _e2151 = phi_1204_;
                                            continue;
                                            continuing {
                                                phi_1203_ = _e2151;
                                                phi_1206_ = _e1219;
                                                phi_4289_ = _e662;
                                                break if !(_e1225);
                                            }
                                        }
                                        let _e2154 = phi_4289_;
                                        phi_4496_ = _e2154;
                                        if _e2154 {
                                            break;
                                        }
                                        phi_4500_ = _e2154;
                                        let _e2366 = local_12;
                                        phi_4061_ = _e2366;
                                        phi_4062_ = _e704;
                                        phi_4063_ = false;
                                        phi_4064_ = _e708;
                                    } else {
                                        if (_e704.member_1 >= _e93) {
                                            phi_3617_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e704.member_1 < _e93) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e726 = (_e264 * 2u);
                                            let _e728 = ((1u + _e726) % 7u);
                                            if (_e728 < 7u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e733 = global_4.member[_e704.member_1][_e728];
                                            let _e735 = ((_e726 + 2u) % 7u);
                                            if (_e735 < 7u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e740 = global_4.member[_e704.member_1][_e735];
                                            let _e741 = (_e263 * 2u);
                                            let _e743 = ((1u + _e741) % 7u);
                                            if (_e743 < 7u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e748 = global_4.member[_e704.member_1][_e743];
                                            let _e750 = ((_e741 + 2u) % 7u);
                                            if (_e750 < 7u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e755 = global_4.member[_e704.member_1][_e750];
                                            let _e756 = (_e265 * 2u);
                                            let _e758 = ((1u + _e756) % 7u);
                                            if (_e758 < 7u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e763 = global_4.member[_e704.member_1][_e758];
                                            let _e765 = ((_e756 + 2u) % 7u);
                                            if (_e765 < 7u) {
                                            } else {
                                                phi_4496_ = true;
                                                break;
                                            }
                                            let _e770 = global_4.member[_e704.member_1][_e765];
                                            let _e793 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.x - _e704.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e794 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.y - _e704.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e795 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.z - _e704.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e797 = select(_e144, _e793, (_e793 > _e144));
                                            let _e799 = select(_e144, _e794, (_e794 > _e144));
                                            let _e801 = select(_e144, _e795, (_e795 > _e144));
                                            let _e832 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 2097151u))) - 8388608f) * _e797));
                                            let _e837 = (bitcast<i32>((_e733 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e840 = bitcast<f32>((_e832 & bitcast<u32>(_e837)));
                                            let _e841 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e748 & 2097151u))) - 8388608f) * _e799));
                                            let _e846 = (bitcast<i32>((_e748 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e849 = bitcast<f32>((_e841 & bitcast<u32>(_e846)));
                                            let _e850 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e763 & 2097151u))) - 8388608f) * _e801));
                                            let _e855 = (bitcast<i32>((_e763 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e858 = bitcast<f32>((_e850 & bitcast<u32>(_e855)));
                                            let _e862 = bitcast<f32>((_e832 & bitcast<u32>(~(_e837))));
                                            let _e866 = bitcast<f32>((_e841 & bitcast<u32>(~(_e846))));
                                            let _e870 = bitcast<f32>((_e850 & bitcast<u32>(~(_e855))));
                                            let _e871 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e740 & 2097151u))) - 8388608f) * _e797));
                                            let _e876 = (bitcast<i32>((_e740 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e879 = bitcast<f32>((_e871 & bitcast<u32>(_e876)));
                                            let _e880 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e755 & 2097151u))) - 8388608f) * _e799));
                                            let _e885 = (bitcast<i32>((_e755 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e888 = bitcast<f32>((_e880 & bitcast<u32>(_e885)));
                                            let _e889 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e770 & 2097151u))) - 8388608f) * _e801));
                                            let _e894 = (bitcast<i32>((_e770 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e897 = bitcast<f32>((_e889 & bitcast<u32>(_e894)));
                                            let _e901 = bitcast<f32>((_e871 & bitcast<u32>(~(_e876))));
                                            let _e905 = bitcast<f32>((_e880 & bitcast<u32>(~(_e885))));
                                            let _e909 = bitcast<f32>((_e889 & bitcast<u32>(~(_e894))));
                                            let _e910 = (_e704.member.member.x + _e840);
                                            let _e911 = (_e704.member.member.y + _e849);
                                            let _e912 = (_e704.member.member.z + _e858);
                                            let _e915 = (_e704.member.member_1.x - _e879);
                                            let _e916 = (_e704.member.member_1.y - _e888);
                                            let _e917 = (_e704.member.member_1.z - _e897);
                                            let _e936 = (_e915 - _e910);
                                            let _e937 = (_e916 - _e911);
                                            let _e938 = (_e917 - _e912);
                                            let _e940 = select(_e937, _e936, (_e936 > _e937));
                                            let _e942 = select(_e938, _e940, (_e940 > _e938));
                                            if (_e942 < (1024f * _e144)) {
                                                phi_3318_ = 0u;
                                            } else {
                                                phi_3318_ = select(2u, 1u, (_e942 < (2097152f * _e144)));
                                            }
                                            let _e949 = phi_3318_;
                                            switch bitcast<i32>(_e949) {
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
                                            let _e952 = phi_3324_;
                                            let _e958 = global_4.member[_e704.member_1][0u];
                                            let _e962 = global_4.member[_e704.member_1][2u];
                                            let _e966 = global_4.member[_e704.member_1][4u];
                                            let _e970 = global_4.member[_e704.member_1][6u];
                                            let _e982 = (((_e962 >> bitcast<u32>(22i)) | ((_e966 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e970 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e983 = (_e958 & 268435455u);
                                            let _e984 = (_e982 & 268435455u);
                                            let _e987 = ((_e958 >> bitcast<u32>(28u)) & 7u);
                                            let _e995 = ((_e958 >> bitcast<u32>(31i)) | (((_e982 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e996 = (_e987 != 0u);
                                            if (_e987 == 0u) {
                                                phi_3579_ = _e983;
                                            } else {
                                                if (_e987 == 7u) {
                                                    phi_3578_ = 2147483648u;
                                                } else {
                                                    phi_3578_ = ((2147483648u | (_e987 << bitcast<u32>(28u))) | (_e984 & 268435455u));
                                                }
                                                let _e1005 = phi_3578_;
                                                phi_3579_ = _e1005;
                                            }
                                            let _e1007 = phi_3579_;
                                            if _e996 {
                                                let _e1008 = (_e987 != 7u);
                                                if _e1008 {
                                                    phi_3589_ = (_e984 + (_e987 * ((3u * _e952) + 1u)));
                                                } else {
                                                    phi_3589_ = u32();
                                                }
                                                let _e1012 = phi_3589_;
                                                phi_3591_ = _e1012;
                                                phi_3592_ = select(true, false, _e1008);
                                            } else {
                                                phi_3591_ = u32();
                                                phi_3592_ = true;
                                            }
                                            let _e1015 = phi_3591_;
                                            let _e1017 = phi_3592_;
                                            if (_e995 == 0u) {
                                                phi_3613_ = (_e983 + select(0u, 1u, !(_e996)));
                                            } else {
                                                if (_e995 == 7u) {
                                                    phi_3612_ = 2147483648u;
                                                } else {
                                                    phi_3612_ = ((2147483648u | (_e995 << bitcast<u32>(28u))) | (select(_e1015, _e984, _e1017) & 268435455u));
                                                }
                                                let _e1030 = phi_3612_;
                                                phi_3613_ = _e1030;
                                            }
                                            let _e1032 = phi_3613_;
                                            phi_3617_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e910, (_e704.member.member.x + _e862), _e915, (_e704.member.member_1.x - _e901)), vec4<f32>(_e911, (_e704.member.member.y + _e866), _e916, (_e704.member.member_1.y - _e905)), vec4<f32>(_e912, (_e704.member.member.z + _e870), _e917, (_e704.member.member_1.z - _e909))), type_50(type_28((_e704.member.member + vec4<f32>(_e840, _e849, _e858, 0f)), (_e704.member.member_1 - vec4<f32>(_e879, _e888, _e897, 0f))), _e1007), type_50(type_28((_e704.member.member + vec4<f32>(_e862, _e866, _e870, 0f)), (_e704.member.member_1 - vec4<f32>(_e901, _e905, _e909, 0f))), _e1032));
                                        }
                                        let _e1037 = phi_3617_;
                                        let _e1050 = ((_e1037.member[0].x - _e366) * _e371);
                                        let _e1051 = ((_e1037.member[0].y - _e366) * _e371);
                                        let _e1052 = ((_e1037.member[0].z - _e367) * _e371);
                                        let _e1053 = ((_e1037.member[0].w - _e367) * _e371);
                                        let _e1063 = ((_e1037.member[1].x - _e434) * _e439);
                                        let _e1064 = ((_e1037.member[1].y - _e434) * _e439);
                                        let _e1065 = ((_e1037.member[1].z - _e435) * _e439);
                                        let _e1066 = ((_e1037.member[1].w - _e435) * _e439);
                                        let _e1076 = ((_e1037.member[2].x - _e502) * _e507);
                                        let _e1077 = ((_e1037.member[2].y - _e502) * _e507);
                                        let _e1078 = ((_e1037.member[2].z - _e503) * _e507);
                                        let _e1079 = ((_e1037.member[2].w - _e503) * _e507);
                                        let _e1081 = select(_e1078, _e1076, (_e1076 < _e1078));
                                        let _e1083 = select(_e1079, _e1077, (_e1077 < _e1079));
                                        let _e1085 = select(_e1078, _e1076, (_e1076 > _e1078));
                                        let _e1087 = select(_e1079, _e1077, (_e1077 > _e1079));
                                        let _e1089 = select(_e1052, _e1050, (_e1050 < _e1052));
                                        let _e1091 = select(_e1053, _e1051, (_e1051 < _e1053));
                                        let _e1093 = select(_e1065, _e1063, (_e1063 < _e1065));
                                        let _e1095 = select(_e1066, _e1064, (_e1064 < _e1066));
                                        let _e1097 = select(_e1093, _e1089, (_e1089 > _e1093));
                                        let _e1099 = select(_e1095, _e1091, (_e1091 > _e1095));
                                        let _e1101 = select(_e1081, _e1097, (_e1097 > _e1081));
                                        let _e1103 = select(_e1083, _e1099, (_e1099 > _e1083));
                                        let _e1105 = select(_e1052, _e1050, (_e1050 > _e1052));
                                        let _e1107 = select(_e1053, _e1051, (_e1051 > _e1053));
                                        let _e1109 = select(_e1065, _e1063, (_e1063 > _e1065));
                                        let _e1111 = select(_e1066, _e1064, (_e1064 > _e1066));
                                        let _e1113 = select(_e1109, _e1105, (_e1105 < _e1109));
                                        let _e1115 = select(_e1111, _e1107, (_e1107 < _e1111));
                                        let _e1120 = -(_e1081);
                                        let _e1121 = -(_e1083);
                                        let _e1128 = (select(_e1085, _e1113, (_e1113 < _e1085)) + (select(_e1120, _e1085, (_e1085 > _e1120)) * 0.0000019073523f));
                                        let _e1129 = (select(_e1087, _e1115, (_e1115 < _e1087)) + (select(_e1121, _e1087, (_e1087 > _e1121)) * 0.0000019073523f));
                                        let _e1131 = select(_e619, _e1101, (_e1101 > _e619));
                                        let _e1133 = select(_e619, _e1103, (_e1103 > _e619));
                                        let _e1138 = (_e1131 <= select(_e664.member.member_1, _e1128, (_e1128 < _e664.member.member_1)));
                                        let _e1139 = (_e1133 <= select(_e664.member.member_1, _e1129, (_e1129 < _e664.member.member_1)));
                                        let _e1140 = (_e1131 <= _e1133);
                                        if _e1138 {
                                            if _e1139 {
                                                if _e1140 {
                                                    phi_3961_ = _e1037.member_2;
                                                } else {
                                                    phi_3961_ = _e1037.member_1;
                                                }
                                                let _e1144 = phi_3961_;
                                                let _e1166 = (_e708 % 128u);
                                                let _e1167 = (_e1166 < 128u);
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_8[_e1166] = _e1144.member_1;
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_7[_e1166] = _e1144.member.member.x;
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_6[_e1166] = _e1144.member.member.y;
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_5[_e1166] = _e1144.member.member.z;
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_4[_e1166] = _e1144.member.member_1.x;
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_3[_e1166] = _e1144.member.member_1.y;
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_2[_e1166] = _e1144.member.member_1.z;
                                                if _e1167 {
                                                } else {
                                                    phi_4496_ = true;
                                                    break;
                                                }
                                                local_9[_e1166] = select(_e1133, _e1131, (_e1131 > _e1133));
                                                if _e1140 {
                                                    phi_4038_ = _e1037.member_1;
                                                } else {
                                                    phi_4038_ = _e1037.member_2;
                                                }
                                                let _e1180 = phi_4038_;
                                                phi_4039_ = _e1180;
                                                phi_4040_ = (_e708 + 1u);
                                            } else {
                                                phi_4039_ = type_50();
                                                phi_4040_ = u32();
                                            }
                                            let _e1182 = phi_4039_;
                                            let _e1184 = phi_4040_;
                                            phi_4042_ = _e1182;
                                            phi_4043_ = _e1184;
                                            phi_4044_ = select(true, false, _e1139);
                                        } else {
                                            phi_4042_ = type_50();
                                            phi_4043_ = u32();
                                            phi_4044_ = true;
                                        }
                                        let _e1187 = phi_4042_;
                                        let _e1189 = phi_4043_;
                                        let _e1191 = phi_4044_;
                                        if _e1191 {
                                            if _e1138 {
                                                phi_4053_ = _e1037.member_1;
                                            } else {
                                                phi_4053_ = _e1037.member_2;
                                            }
                                            let _e1195 = phi_4053_;
                                            phi_4058_ = _e1195;
                                            phi_4059_ = select(_e1139, true, _e1138);
                                        } else {
                                            phi_4058_ = _e1187;
                                            phi_4059_ = _e706;
                                        }
                                        let _e1198 = phi_4058_;
                                        let _e1200 = phi_4059_;
                                        phi_4500_ = _e662;
                                        phi_4061_ = type_39(_e664.member, (_e664.member_1 + 1u), _e664.member_2);
                                        phi_4062_ = _e1198;
                                        phi_4063_ = _e1200;
                                        phi_4064_ = select(_e1189, _e708, _e1191);
                                    }
                                    let _e2156 = phi_4500_;
                                    let _e2158 = phi_4061_;
                                    let _e2160 = phi_4062_;
                                    let _e2162 = phi_4063_;
                                    let _e2164 = phi_4064_;
                                    phi_4499_ = _e2156;
                                    phi_4065_ = _e2158;
                                    phi_4066_ = _e2160;
                                    phi_4067_ = (_e668 - 1u);
                                    phi_4068_ = _e2162;
                                    phi_4069_ = _e2164;
                                } else {
                                    phi_4499_ = _e662;
                                    phi_4065_ = _e664;
                                    phi_4066_ = _e704;
                                    phi_4067_ = _e668;
                                    phi_4068_ = _e706;
                                    phi_4069_ = _e708;
                                }
                                let _e2166 = phi_4499_;
                                let _e2168 = phi_4065_;
                                let _e2170 = phi_4066_;
                                let _e2172 = phi_4067_;
                                let _e2174 = phi_4068_;
                                let _e2176 = phi_4069_;
                                phi_4498_ = _e2166;
                                phi_4070_ = _e2168;
                                phi_4071_ = _e2170;
                                phi_4072_ = _e2172;
                                phi_4073_ = _e2174;
                                phi_4074_ = _e2176;
                            } else {
                                phi_4498_ = _e662;
                                phi_4070_ = type_39();
                                phi_4071_ = type_50();
                                phi_4072_ = u32();
                                phi_4073_ = bool();
                                phi_4074_ = u32();
                            }
                            let _e2178 = phi_4498_;
                            let _e2180 = phi_4070_;
                            let _e2182 = phi_4071_;
                            let _e2184 = phi_4072_;
                            let _e2186 = phi_4073_;
                            let _e2188 = phi_4074_;
                            phi_4497_ = _e2178;
                            phi_1077_ = _e2180;
                            phi_1080_ = _e2182;
                            phi_1082_ = _e2184;
                            phi_1084_ = _e2186;
                            phi_1086_ = _e2188;
                            phi_4075_ = _e676;
                        } else {
                            phi_4497_ = _e662;
                            phi_1077_ = type_39();
                            phi_1080_ = type_50();
                            phi_1082_ = u32();
                            phi_1084_ = bool();
                            phi_1086_ = u32();
                            phi_4075_ = false;
                        }
                        let _e2190 = phi_4497_;
                        let _e2192 = phi_1077_;
                        let _e2194 = phi_1080_;
                        let _e2196 = phi_1082_;
                        let _e2198 = phi_1084_;
                        let _e2200 = phi_1086_;
                        let _e2202 = phi_4075_;
                        continue;
                        continuing {
                            phi_4295_ = _e2190;
                            phi_1076_ = _e2192;
                            phi_1079_ = _e2194;
                            phi_1081_ = _e2196;
                            phi_1083_ = _e2198;
                            phi_1085_ = _e2200;
                            phi_4496_ = _e2190;
                            break if !(_e2202);
                        }
                    }
                    let _e2205 = phi_4496_;
                    if _e2205 {
                        break;
                    }
                    let _e2207 = local_10;
                    let _e2210 = local_11;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150][0u] = _e2207.member_1;
                    global_6.member[_e150][1u] = _e2210.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
