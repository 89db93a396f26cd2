struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_34 {
    member: type_25,
    member_1: f32,
}

struct type_38 {
    member: array<type_26>,
}

struct type_40 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_29,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

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
    var phi_391_: i32;
    var phi_392_: i32;
    var phi_402_: bool;
    var phi_412_: u32;
    var phi_413_: u32;
    var phi_415_: bool;
    var phi_420_: u32;
    var phi_433_: i32;
    var phi_453_: i32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_517_: f32;
    var phi_523_: f32;
    var phi_575_: f32;
    var phi_587_: f32;
    var phi_596_: f32;
    var phi_602_: f32;
    var phi_642_: f32;
    var phi_648_: f32;
    var phi_700_: f32;
    var phi_712_: f32;
    var phi_721_: f32;
    var phi_727_: f32;
    var phi_767_: f32;
    var phi_773_: f32;
    var phi_825_: f32;
    var phi_837_: f32;
    var phi_892_: i32;
    var phi_914_: u32;
    var phi_915_: u32;
    var phi_952_: i32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_983_: f32;
    var phi_984_: f32;
    var phi_3757_: bool;
    var phi_1081_: type_40;
    var phi_1084_: bool;
    var phi_1086_: u32;
    var phi_1088_: u32;
    var phi_1090_: type_51;
    var phi_1101_: bool;
    var phi_1187_: bool;
    var phi_1188_: u32;
    var phi_1189_: type_51;
    var phi_3015_: u32;
    var phi_3016_: u32;
    var phi_3026_: u32;
    var phi_3028_: u32;
    var phi_3029_: bool;
    var phi_3049_: u32;
    var phi_3050_: u32;
    var phi_3054_: type_52;
    var phi_3419_: type_51;
    var phi_3496_: type_51;
    var phi_3497_: u32;
    var phi_3498_: type_51;
    var phi_3500_: u32;
    var phi_3501_: type_51;
    var phi_3502_: bool;
    var phi_3511_: type_51;
    var phi_3516_: bool;
    var phi_3518_: type_51;
    var phi_1207_: type_40;
    var phi_1210_: type_4;
    var phi_1211_: type_4;
    var phi_1233_: type_4;
    var phi_1257_: u32;
    var phi_1349_: array<array<f32, 3>, 3>;
    var phi_1501_: bool;
    var phi_1530_: bool;
    var phi_1949_: f32;
    var phi_1950_: f32;
    var phi_1951_: f32;
    var phi_1952_: f32;
    var phi_1953_: vec3<f32>;
    var phi_1954_: vec3<f32>;
    var phi_1955_: vec3<f32>;
    var phi_1956_: vec3<f32>;
    var phi_1993_: bool;
    var phi_2002_: vec3<f32>;
    var phi_2167_: f32;
    var phi_2169_: f32;
    var phi_2170_: bool;
    var phi_2190_: f32;
    var phi_2191_: f32;
    var phi_2214_: type_25;
    var phi_2216_: type_25;
    var phi_2217_: bool;
    var phi_2221_: type_25;
    var phi_2222_: type_25;
    var phi_2223_: type_25;
    var phi_2224_: bool;
    var phi_2228_: type_25;
    var phi_2229_: bool;
    var phi_2230_: type_25;
    var phi_2231_: bool;
    var phi_2232_: bool;
    var phi_2233_: type_25;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2243_: type_25;
    var phi_2244_: bool;
    var phi_2248_: type_25;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var phi_2281_: type_40;
    var phi_2282_: type_40;
    var phi_2283_: type_40;
    var phi_1208_: type_40;
    var phi_3751_: bool;
    var phi_3915_: bool;
    var phi_3523_: type_40;
    var phi_3524_: bool;
    var phi_3525_: u32;
    var phi_3526_: type_51;
    var phi_3914_: bool;
    var phi_3527_: type_40;
    var phi_3528_: bool;
    var phi_3529_: u32;
    var phi_3530_: u32;
    var phi_3531_: type_51;
    var phi_3913_: bool;
    var phi_3532_: type_40;
    var phi_3533_: bool;
    var phi_3534_: u32;
    var phi_3535_: u32;
    var phi_3536_: type_51;
    var phi_3912_: bool;
    var phi_1082_: type_40;
    var phi_1085_: bool;
    var phi_1087_: u32;
    var phi_1089_: u32;
    var phi_1091_: type_51;
    var phi_3537_: bool;
    var phi_3911_: bool;
    var local_10: type_40;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_5.member));
            let _e90 = arrayLength((&global_2.member));
            let _e98 = global_3.member[0u][0u];
            let _e102 = global_3.member[0u][1u];
            let _e106 = global_3.member[0u][2u];
            let _e110 = global_3.member[0u][3u];
            let _e114 = global_3.member[1u][0u];
            let _e118 = global_3.member[1u][1u];
            let _e122 = global_3.member[1u][2u];
            let _e125 = global_1.member[0u];
            let _e126 = bitcast<i32>(_e125);
            let _e138 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e110) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e98), bitcast<i32>(_e102), bitcast<i32>(_e106));
            local = array<i32, 3>(bitcast<i32>(_e114), bitcast<i32>(_e118), bitcast<i32>(_e122));
            let _e144 = (_e86.x + (_e86.y * 2097152u));
            let _e145 = (_e144 < arrayLength((&global_4.member)));
            if _e145 {
                let _e146 = (_e144 < arrayLength((&global_6.member)));
                if _e146 {
                    if _e145 {
                    } else {
                        break;
                    }
                    let _e154 = global_4.member[_e144].member_2[0u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_4.member[_e144].member_2[1u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_4.member[_e144].member_2[2u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_4.member[_e144].member[0u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_4.member[_e144].member[1u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_4.member[_e144].member[2u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e193 = select(_e163, _e156, (_e163 < _e156));
                    let _e195 = select(_e170, _e193, (_e170 < _e193));
                    let _e197 = select(_e177, _e195, (_e177 < _e195));
                    let _e199 = select(_e184, _e197, (_e184 < _e197));
                    let _e201 = select(_e191, _e199, (_e191 < _e199));
                    let _e205 = global_4.member[_e144].member_1;
                    let _e206 = bitcast<u32>(_e205);
                    let _e207 = (_e206 & 2147483647u);
                    let _e214 = global_4.member[_e144].member_3;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e220 = (((select(_e207, _e201, (_e207 < _e201)) < 2139095040u) && (_e216 <= 2139095040u)) && (_e195 > 0u));
                    if _e220 {
                        let _e223 = (bitcast<u32>(bitcast<f32>(_e195)) & 2147483647u);
                        if (_e223 >= 8388608u) {
                            phi_391_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_391_;
                        phi_392_ = _e237;
                    } else {
                        phi_392_ = 0i;
                    }
                    let _e239 = phi_392_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_402_ = true;
                    } else {
                        phi_402_ = (_e163 == _e195);
                    }
                    let _e243 = phi_402_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_412_ = _e245;
                        phi_413_ = _e245;
                        phi_415_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_412_ = u32();
                        phi_413_ = 0u;
                        phi_415_ = true;
                    }
                    let _e249 = phi_412_;
                    let _e251 = phi_413_;
                    let _e253 = phi_415_;
                    if _e253 {
                        phi_420_ = (_e251 + 1u);
                    } else {
                        phi_420_ = 0u;
                    }
                    let _e257 = phi_420_;
                    let _e258 = select(_e249, _e251, _e253);
                    let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                    if (_e126 < -126i) {
                        phi_433_ = -126i;
                    } else {
                        phi_433_ = select(_e126, 127i, (_e126 > 127i));
                    }
                    let _e264 = phi_433_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e126 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = -(_e239);
                    if (_e276 < -126i) {
                        phi_453_ = -126i;
                    } else {
                        phi_453_ = select(_e276, 127i, (_e276 > 127i));
                    }
                    let _e281 = phi_453_;
                    let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                    let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                    let _e296 = global_4.member[_e144].member;
                    let _e297 = (_e258 == 0u);
                    if _e297 {
                        phi_471_ = _e296[0];
                    } else {
                        phi_471_ = _e296[1];
                    }
                    let _e301 = phi_471_;
                    let _e302 = (_e258 == 2u);
                    if _e302 {
                        phi_477_ = _e296[2];
                    } else {
                        phi_477_ = _e301;
                    }
                    let _e305 = phi_477_;
                    let _e306 = bitcast<u32>(_e305);
                    let _e308 = ((_e306 & 2139095040u) != 0u);
                    let _e322 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e306 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e306 & 2147483648u))), _e305, _e308) * _e269) * select(0.00000011920929f, 1f, _e308)) * _e275);
                    let _e323 = global_4.member[_e144].member_2;
                    if _e297 {
                        phi_517_ = _e323[0];
                    } else {
                        phi_517_ = _e323[1];
                    }
                    let _e327 = phi_517_;
                    if _e302 {
                        phi_523_ = _e323[2];
                    } else {
                        phi_523_ = _e327;
                    }
                    let _e330 = phi_523_;
                    let _e331 = bitcast<u32>(_e330);
                    let _e333 = ((_e331 & 2139095040u) != 0u);
                    let _e347 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e331 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e331 & 2147483648u))), _e330, _e333) * _e286) * select(0.00000011920929f, 1f, _e333)) * _e292);
                    let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e351 {
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) * 0.00000011920929f);
                        phi_575_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                    } else {
                        phi_575_ = 0f;
                    }
                    let _e359 = phi_575_;
                    let _e360 = (_e322 + _e359);
                    let _e361 = (_e322 - _e359);
                    let _e362 = select(_e347, 0f, _e351);
                    if _e351 {
                        phi_587_ = 38685626000000000000000000f;
                    } else {
                        phi_587_ = (1f / _e347);
                    }
                    let _e365 = phi_587_;
                    let _e366 = (_e257 == 0u);
                    if _e366 {
                        phi_596_ = _e296[0];
                    } else {
                        phi_596_ = _e296[1];
                    }
                    let _e370 = phi_596_;
                    let _e371 = (_e257 == 2u);
                    if _e371 {
                        phi_602_ = _e296[2];
                    } else {
                        phi_602_ = _e370;
                    }
                    let _e374 = phi_602_;
                    let _e375 = bitcast<u32>(_e374);
                    let _e377 = ((_e375 & 2139095040u) != 0u);
                    let _e391 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e375 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e375 & 2147483648u))), _e374, _e377) * _e269) * select(0.00000011920929f, 1f, _e377)) * _e275);
                    if _e366 {
                        phi_642_ = _e323[0];
                    } else {
                        phi_642_ = _e323[1];
                    }
                    let _e395 = phi_642_;
                    if _e371 {
                        phi_648_ = _e323[2];
                    } else {
                        phi_648_ = _e395;
                    }
                    let _e398 = phi_648_;
                    let _e399 = bitcast<u32>(_e398);
                    let _e401 = ((_e399 & 2139095040u) != 0u);
                    let _e415 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e399 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e399 & 2147483648u))), _e398, _e401) * _e286) * select(0.00000011920929f, 1f, _e401)) * _e292);
                    let _e419 = (bitcast<f32>((bitcast<u32>(_e415) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e419 {
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) * 0.00000011920929f);
                        phi_700_ = select(0.00000000000011368684f, _e423, (_e423 > 0.00000000000011368684f));
                    } else {
                        phi_700_ = 0f;
                    }
                    let _e427 = phi_700_;
                    let _e428 = (_e391 + _e427);
                    let _e429 = (_e391 - _e427);
                    let _e430 = select(_e415, 0f, _e419);
                    if _e419 {
                        phi_712_ = 38685626000000000000000000f;
                    } else {
                        phi_712_ = (1f / _e415);
                    }
                    let _e433 = phi_712_;
                    let _e434 = (_e259 == 0u);
                    if _e434 {
                        phi_721_ = _e296[0];
                    } else {
                        phi_721_ = _e296[1];
                    }
                    let _e438 = phi_721_;
                    let _e439 = (_e259 == 2u);
                    if _e439 {
                        phi_727_ = _e296[2];
                    } else {
                        phi_727_ = _e438;
                    }
                    let _e442 = phi_727_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e459 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * _e269) * select(0.00000011920929f, 1f, _e445)) * _e275);
                    if _e434 {
                        phi_767_ = _e323[0];
                    } else {
                        phi_767_ = _e323[1];
                    }
                    let _e463 = phi_767_;
                    if _e439 {
                        phi_773_ = _e323[2];
                    } else {
                        phi_773_ = _e463;
                    }
                    let _e466 = phi_773_;
                    let _e467 = bitcast<u32>(_e466);
                    let _e469 = ((_e467 & 2139095040u) != 0u);
                    let _e483 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e467 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e467 & 2147483648u))), _e466, _e469) * _e286) * select(0.00000011920929f, 1f, _e469)) * _e292);
                    let _e487 = (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e487 {
                        let _e491 = (bitcast<f32>((bitcast<u32>(_e459) & 2147483647u)) * 0.00000011920929f);
                        phi_825_ = select(0.00000000000011368684f, _e491, (_e491 > 0.00000000000011368684f));
                    } else {
                        phi_825_ = 0f;
                    }
                    let _e495 = phi_825_;
                    let _e496 = (_e459 + _e495);
                    let _e497 = (_e459 - _e495);
                    let _e498 = select(_e483, 0f, _e487);
                    if _e487 {
                        phi_837_ = 38685626000000000000000000f;
                    } else {
                        phi_837_ = (1f / _e483);
                    }
                    let _e501 = phi_837_;
                    let _e504 = bitcast<f32>((bitcast<u32>(_e322) & 2147483647u));
                    let _e507 = bitcast<f32>((bitcast<u32>(_e391) & 2147483647u));
                    let _e509 = select(_e507, _e504, (_e504 > _e507));
                    let _e512 = bitcast<f32>((bitcast<u32>(_e459) & 2147483647u));
                    let _e515 = (_e126 + _e239);
                    if (_e220 && (select(_e512, _e509, (_e509 > _e512)) <= 1099511600000f)) {
                        let _e525 = ((_e207 & 8388607u) | (select(0u, 1u, ((_e207 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e528 = bitcast<i32>((_e207 >> bitcast<u32>(23i)));
                        let _e532 = (_e525 == 0u);
                        let _e535 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e525)), 32u, _e532)) - 8i);
                        if (_e528 == 255i) {
                            phi_892_ = 255i;
                        } else {
                            phi_892_ = (((_e528 + select(0i, 1i, (_e528 == 0i))) - _e535) + _e515);
                        }
                        let _e543 = phi_892_;
                        let _e553 = (_e543 <= 0i);
                        if _e553 {
                            phi_915_ = u32();
                        } else {
                            if _e532 {
                                phi_914_ = u32();
                            } else {
                                phi_914_ = select(((bitcast<u32>(_e543) << bitcast<u32>(23i)) | ((_e525 << bitcast<u32>(((_e535 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e543 >= 255i));
                            }
                            let _e557 = phi_914_;
                            phi_915_ = _e557;
                        }
                        let _e559 = phi_915_;
                        let _e571 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e574 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e578 = (_e571 == 0u);
                        let _e581 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e571)), 32u, _e578)) - 8i);
                        if (_e574 == 255i) {
                            phi_952_ = 255i;
                        } else {
                            phi_952_ = (((_e574 + select(0i, 1i, (_e574 == 0i))) - _e581) + _e515);
                        }
                        let _e589 = phi_952_;
                        let _e599 = (_e589 <= 0i);
                        if _e599 {
                            phi_975_ = u32();
                        } else {
                            if _e578 {
                                phi_974_ = u32();
                            } else {
                                phi_974_ = select(((bitcast<u32>(_e589) << bitcast<u32>(23i)) | ((_e571 << bitcast<u32>(((_e581 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e589 >= 255i));
                            }
                            let _e603 = phi_974_;
                            phi_975_ = _e603;
                        }
                        let _e605 = phi_975_;
                        phi_983_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e605, 0u, select(_e578, true, _e599))));
                        phi_984_ = bitcast<f32>(((_e206 & 2147483648u) | select(_e559, 0u, select(_e532, true, _e553))));
                    } else {
                        phi_983_ = 0f;
                        phi_984_ = 1f;
                    }
                    let _e611 = phi_983_;
                    let _e613 = phi_984_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e618 = (_e258 % 3u);
                    let _e619 = (_e618 < 3u);
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e621 = local_1[_e618];
                    let _e624 = (_e257 % 3u);
                    let _e625 = (_e624 < 3u);
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e627 = local_1[_e624];
                    let _e630 = (_e259 % 3u);
                    let _e631 = (_e630 < 3u);
                    if _e631 {
                    } else {
                        break;
                    }
                    let _e633 = local_1[_e630];
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e638 = local[_e618];
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e642 = local[_e624];
                    if _e631 {
                    } else {
                        break;
                    }
                    let _e646 = local[_e630];
                    phi_3757_ = false;
                    phi_1081_ = type_40(type_34(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e611), 0u, 0u);
                    phi_1084_ = (_e613 <= _e611);
                    phi_1086_ = ((3u * _e88) + 1u);
                    phi_1088_ = 0u;
                    phi_1090_ = type_51(type_29(vec4<f32>((f32(_e621) * _e138), (f32(_e627) * _e138), (f32(_e633) * _e138), 0f), vec4<f32>((f32(_e638) * _e138), (f32(_e642) * _e138), (f32(_e646) * _e138), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    loop {
                        let _e656 = phi_3757_;
                        let _e658 = phi_1081_;
                        let _e660 = phi_1084_;
                        let _e662 = phi_1086_;
                        let _e664 = phi_1088_;
                        let _e666 = phi_1090_;
                        local_10 = _e658;
                        local_11 = _e658;
                        if _e660 {
                            phi_1101_ = true;
                        } else {
                            phi_1101_ = (_e664 > 0u);
                        }
                        let _e669 = phi_1101_;
                        if _e669 {
                            let _e670 = (_e662 > 0u);
                            if _e670 {
                                if _e660 {
                                    phi_1187_ = _e660;
                                    phi_1188_ = _e664;
                                    phi_1189_ = _e666;
                                } else {
                                    let _e671 = (_e664 - 1u);
                                    let _e672 = (_e671 % 128u);
                                    let _e673 = (_e672 < 128u);
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e675 = local_7[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e677 = local_6[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e679 = local_5[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e681 = local_4[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e683 = local_3[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e685 = local_2[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e690 = local_8[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e693 = local_9[_e672];
                                    phi_1187_ = (_e693 <= _e658.member.member_1);
                                    phi_1188_ = _e671;
                                    phi_1189_ = type_51(type_29(vec4<f32>(_e675, _e677, _e679, 0f), vec4<f32>(_e681, _e683, _e685, 0f)), _e690);
                                }
                                let _e698 = phi_1187_;
                                let _e700 = phi_1188_;
                                let _e702 = phi_1189_;
                                if _e698 {
                                    if ((_e702.member_1 & 2147483648u) != 0u) {
                                        phi_1207_ = _e658;
                                        phi_1210_ = type_4(0u, ((_e702.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1177 = phi_1207_;
                                            let _e1179 = phi_1210_;
                                            local_12 = _e1177;
                                            if (_e1179.member < _e1179.member_1) {
                                                phi_1211_ = type_4((_e1179.member + 1u), _e1179.member_1);
                                                phi_1233_ = type_4(1u, _e1179.member);
                                            } else {
                                                phi_1211_ = _e1179;
                                                phi_1233_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1192 = phi_1211_;
                                            let _e1194 = phi_1233_;
                                            let _e1198 = (bitcast<i32>(_e1194.member) != 0i);
                                            if _e1198 {
                                                let _e1204 = type_40(_e1177.member, _e1177.member_1, (_e1177.member_2 + 1u));
                                                let _e1205 = ((_e702.member_1 & 268435455u) + _e1194.member_1);
                                                let _e1206 = (_e1205 < _e90);
                                                if _e1206 {
                                                    if _e1206 {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1210 = global_2.member[_e1205].member_1;
                                                    phi_1257_ = _e1210;
                                                } else {
                                                    phi_1257_ = 4294967295u;
                                                }
                                                let _e1212 = phi_1257_;
                                                if (_e1205 >= _e90) {
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1206 {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    if (_e618 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1219 = global_2.member[_e1205].member[_e618];
                                                    if (_e624 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1225 = global_2.member[_e1205].member[_e624];
                                                    if (_e630 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1231 = global_2.member[_e1205].member[_e630];
                                                    let _e1233 = (3u + _e618);
                                                    if (_e1233 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1239 = global_2.member[_e1205].member[_e1233];
                                                    let _e1240 = (3u + _e624);
                                                    if (_e1240 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1246 = global_2.member[_e1205].member[_e1240];
                                                    let _e1247 = (3u + _e630);
                                                    if (_e1247 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1253 = global_2.member[_e1205].member[_e1247];
                                                    let _e1255 = (6u + _e618);
                                                    if (_e1255 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1261 = global_2.member[_e1205].member[_e1255];
                                                    let _e1262 = (6u + _e624);
                                                    if (_e1262 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1268 = global_2.member[_e1205].member[_e1262];
                                                    let _e1269 = (6u + _e630);
                                                    if (_e1269 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1275 = global_2.member[_e1205].member[_e1269];
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1219, _e1225, _e1231), array<f32, 3>(_e1239, _e1246, _e1253), array<f32, 3>(_e1261, _e1268, _e1275));
                                                }
                                                let _e1279 = phi_1349_;
                                                let _e1288 = (_e1279[0][2] - _e459);
                                                let _e1291 = (((_e1279[0][0] - _e322) * _e498) - (_e1288 * _e362));
                                                let _e1294 = (((_e1279[0][1] - _e391) * _e498) - (_e1288 * _e430));
                                                let _e1301 = (_e1279[1][2] - _e459);
                                                let _e1304 = (((_e1279[1][0] - _e322) * _e498) - (_e1301 * _e362));
                                                let _e1307 = (((_e1279[1][1] - _e391) * _e498) - (_e1301 * _e430));
                                                let _e1314 = (_e1279[2][2] - _e459);
                                                let _e1317 = (((_e1279[2][0] - _e322) * _e498) - (_e1314 * _e362));
                                                let _e1320 = (((_e1279[2][1] - _e391) * _e498) - (_e1314 * _e430));
                                                let _e1321 = (_e1317 * _e1307);
                                                let _e1322 = (_e1320 * _e1304);
                                                let _e1323 = (_e1291 * _e1320);
                                                let _e1324 = (_e1294 * _e1317);
                                                let _e1325 = (_e1304 * _e1294);
                                                let _e1326 = (_e1307 * _e1291);
                                                let _e1331 = (((_e1321 >= _e1322) && (_e1323 >= _e1324)) && (_e1325 >= _e1326));
                                                if (_e1331 || (((_e1321 <= _e1322) && (_e1323 <= _e1324)) && (_e1325 <= _e1326))) {
                                                    let _e1338 = select(-1f, 1f, _e1331);
                                                    let _e1340 = ((_e1321 - _e1322) * _e1338);
                                                    let _e1342 = select(0f, _e1340, (_e1340 > 0f));
                                                    let _e1344 = ((_e1323 - _e1324) * _e1338);
                                                    let _e1346 = select(0f, _e1344, (_e1344 > 0f));
                                                    let _e1348 = ((_e1325 - _e1326) * _e1338);
                                                    let _e1350 = select(0f, _e1348, (_e1348 > 0f));
                                                    let _e1352 = ((_e1342 + _e1346) + _e1350);
                                                    if (_e1352 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2233_ = type_25();
                                                        phi_2234_ = true;
                                                        phi_2235_ = false;
                                                    } else {
                                                        let _e1355 = select(_e1304, _e1291, (_e1291 < _e1304));
                                                        if (select(_e1317, _e1355, (_e1355 < _e1317)) > 0f) {
                                                            phi_1501_ = true;
                                                        } else {
                                                            let _e1360 = select(_e1304, _e1291, (_e1291 > _e1304));
                                                            phi_1501_ = (select(_e1317, _e1360, (_e1360 > _e1317)) < 0f);
                                                        }
                                                        let _e1365 = phi_1501_;
                                                        if _e1365 {
                                                            phi_2230_ = type_25();
                                                            phi_2231_ = true;
                                                            phi_2232_ = false;
                                                        } else {
                                                            let _e1367 = select(_e1307, _e1294, (_e1294 < _e1307));
                                                            if (select(_e1320, _e1367, (_e1367 < _e1320)) > 0f) {
                                                                phi_1530_ = true;
                                                            } else {
                                                                let _e1372 = select(_e1307, _e1294, (_e1294 > _e1307));
                                                                phi_1530_ = (select(_e1320, _e1372, (_e1372 > _e1320)) < 0f);
                                                            }
                                                            let _e1377 = phi_1530_;
                                                            if _e1377 {
                                                                phi_2228_ = type_25();
                                                                phi_2229_ = false;
                                                            } else {
                                                                let _e1379 = select(_e1279[1][0], _e1279[0][0], (_e1279[0][0] < _e1279[1][0]));
                                                                let _e1383 = select(_e1279[1][0], _e1279[0][0], (_e1279[0][0] > _e1279[1][0]));
                                                                let _e1387 = select(_e1279[1][1], _e1279[0][1], (_e1279[0][1] < _e1279[1][1]));
                                                                let _e1391 = select(_e1279[1][1], _e1279[0][1], (_e1279[0][1] > _e1279[1][1]));
                                                                let _e1395 = select(_e1279[1][2], _e1279[0][2], (_e1279[0][2] < _e1279[1][2]));
                                                                let _e1399 = select(_e1279[1][2], _e1279[0][2], (_e1279[0][2] > _e1279[1][2]));
                                                                let _e1404 = ((select(_e1279[2][0], _e1379, (_e1379 < _e1279[2][0])) - _e360) * _e365);
                                                                let _e1405 = ((select(_e1279[2][0], _e1383, (_e1383 > _e1279[2][0])) - _e361) * _e365);
                                                                let _e1408 = ((select(_e1279[2][1], _e1387, (_e1387 < _e1279[2][1])) - _e428) * _e433);
                                                                let _e1409 = ((select(_e1279[2][1], _e1391, (_e1391 > _e1279[2][1])) - _e429) * _e433);
                                                                let _e1412 = ((select(_e1279[2][2], _e1395, (_e1395 < _e1279[2][2])) - _e496) * _e501);
                                                                let _e1413 = ((select(_e1279[2][2], _e1399, (_e1399 > _e1279[2][2])) - _e497) * _e501);
                                                                let _e1415 = select(_e1413, _e1412, (_e1412 < _e1413));
                                                                let _e1417 = select(_e1413, _e1412, (_e1412 > _e1413));
                                                                let _e1419 = select(_e1405, _e1404, (_e1404 < _e1405));
                                                                let _e1421 = select(_e1409, _e1408, (_e1408 < _e1409));
                                                                let _e1423 = select(_e1421, _e1419, (_e1419 > _e1421));
                                                                let _e1425 = select(_e1415, _e1423, (_e1423 > _e1415));
                                                                let _e1427 = select(_e1405, _e1404, (_e1404 > _e1405));
                                                                let _e1429 = select(_e1409, _e1408, (_e1408 > _e1409));
                                                                let _e1431 = select(_e1429, _e1427, (_e1427 < _e1429));
                                                                let _e1433 = select(_e1417, _e1431, (_e1431 < _e1417));
                                                                let _e1434 = -(_e1415);
                                                                let _e1440 = select(_e613, _e1425, (_e1425 > _e613));
                                                                if (_e1440 > (_e1433 + (select(_e1434, _e1417, (_e1417 > _e1434)) * 0.0000019073523f))) {
                                                                    phi_2223_ = type_25();
                                                                    phi_2224_ = true;
                                                                } else {
                                                                    let _e1442 = (_e1440 > _e1177.member.member_1);
                                                                    if _e1442 {
                                                                        phi_2222_ = type_25();
                                                                    } else {
                                                                        let _e1443 = vec3<f32>(_e1279[0][0], _e1279[0][1], _e1279[0][2]);
                                                                        let _e1444 = vec3<f32>(_e1279[1][0], _e1279[1][1], _e1279[1][2]);
                                                                        let _e1445 = vec3<f32>(_e1279[2][0], _e1279[2][1], _e1279[2][2]);
                                                                        let _e1446 = (_e1279[1][0] - _e1279[0][0]);
                                                                        let _e1447 = (_e1279[1][1] - _e1279[0][1]);
                                                                        let _e1448 = (_e1279[1][2] - _e1279[0][2]);
                                                                        let _e1449 = vec3<f32>(_e1446, _e1447, _e1448);
                                                                        let _e1450 = (_e1279[2][0] - _e1279[1][0]);
                                                                        let _e1451 = (_e1279[2][1] - _e1279[1][1]);
                                                                        let _e1452 = (_e1279[2][2] - _e1279[1][2]);
                                                                        let _e1453 = vec3<f32>(_e1450, _e1451, _e1452);
                                                                        let _e1454 = (_e1279[0][0] - _e1279[2][0]);
                                                                        let _e1455 = (_e1279[0][1] - _e1279[2][1]);
                                                                        let _e1456 = (_e1279[0][2] - _e1279[2][2]);
                                                                        let _e1457 = vec3<f32>(_e1454, _e1455, _e1456);
                                                                        let _e1460 = bitcast<f32>((bitcast<u32>(_e1446) & 2147483647u));
                                                                        let _e1463 = bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u));
                                                                        let _e1465 = select(_e1463, _e1460, (_e1460 > _e1463));
                                                                        let _e1468 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                        let _e1470 = select(_e1468, _e1465, (_e1465 > _e1468));
                                                                        let _e1473 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                                        let _e1476 = bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u));
                                                                        let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                                                                        let _e1481 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                                        let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                        let _e1486 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
                                                                        let _e1489 = bitcast<f32>((bitcast<u32>(_e1455) & 2147483647u));
                                                                        let _e1491 = select(_e1489, _e1486, (_e1486 > _e1489));
                                                                        let _e1494 = bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u));
                                                                        let _e1496 = select(_e1494, _e1491, (_e1491 > _e1494));
                                                                        let _e1498 = select(_e1483, _e1470, (_e1470 > _e1483));
                                                                        let _e1500 = select(_e1496, _e1498, (_e1498 > _e1496));
                                                                        if (_e1470 == _e1500) {
                                                                            phi_1949_ = _e1307;
                                                                            phi_1950_ = _e1304;
                                                                            phi_1951_ = _e1294;
                                                                            phi_1952_ = _e1291;
                                                                            phi_1953_ = _e1443;
                                                                            phi_1954_ = _e1457;
                                                                            phi_1955_ = _e1453;
                                                                            phi_1956_ = _e1449;
                                                                        } else {
                                                                            let _e1502 = (_e1483 == _e1500);
                                                                            let _e1507 = vec3(_e1502);
                                                                            phi_1949_ = select(_e1294, _e1320, _e1502);
                                                                            phi_1950_ = select(_e1291, _e1317, _e1502);
                                                                            phi_1951_ = select(_e1320, _e1307, _e1502);
                                                                            phi_1952_ = select(_e1317, _e1304, _e1502);
                                                                            phi_1953_ = select(_e1445, _e1444, _e1507);
                                                                            phi_1954_ = select(_e1453, _e1449, _e1507);
                                                                            phi_1955_ = select(_e1449, _e1457, _e1507);
                                                                            phi_1956_ = select(_e1457, _e1453, _e1507);
                                                                        }
                                                                        let _e1513 = phi_1949_;
                                                                        let _e1515 = phi_1950_;
                                                                        let _e1517 = phi_1951_;
                                                                        let _e1519 = phi_1952_;
                                                                        let _e1521 = phi_1953_;
                                                                        let _e1523 = phi_1954_;
                                                                        let _e1525 = phi_1955_;
                                                                        let _e1527 = phi_1956_;
                                                                        let _e1534 = ((_e1525.y * _e1523.z) - (_e1523.y * _e1525.z));
                                                                        let _e1539 = ((_e1525.z * _e1523.x) - (_e1523.z * _e1525.x));
                                                                        let _e1542 = ((_e1525.x * _e1523.y) - (_e1523.x * _e1525.y));
                                                                        if (_e1342 >= _e1346) {
                                                                            phi_1993_ = select(true, false, (_e1342 >= _e1350));
                                                                        } else {
                                                                            phi_1993_ = true;
                                                                        }
                                                                        let _e1547 = phi_1993_;
                                                                        if _e1547 {
                                                                            phi_2002_ = select(_e1445, _e1444, vec3((_e1346 >= _e1350)));
                                                                        } else {
                                                                            phi_2002_ = _e1443;
                                                                        }
                                                                        let _e1552 = phi_2002_;
                                                                        let _e1563 = (((_e1534 * (_e1552.x - _e322)) + (_e1539 * (_e1552.y - _e391))) + (_e1542 * (_e1552.z - _e459)));
                                                                        let _e1568 = (((_e1534 * _e362) + (_e1539 * _e430)) + (_e1542 * _e498));
                                                                        let _e1569 = (_e1515 - _e1519);
                                                                        let _e1570 = (_e1513 - _e1517);
                                                                        let _e1578 = (-(((_e1519 * _e1569) + (_e1517 * _e1570))) / ((_e1569 * _e1569) + (_e1570 * _e1570)));
                                                                        let _e1580 = select(1f, _e1578, (_e1578 < 1f));
                                                                        let _e1582 = select(0f, _e1580, (_e1580 > 0f));
                                                                        let _e1595 = ((_e1521.x + (_e1527.x * _e1582)) - _e322);
                                                                        let _e1596 = ((_e1521.y + (_e1527.y * _e1582)) - _e391);
                                                                        let _e1597 = ((_e1521.z + (_e1527.z * _e1582)) - _e459);
                                                                        let _e1598 = (_e1597 / _e498);
                                                                        let _e1610 = bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u));
                                                                        let _e1613 = bitcast<f32>((bitcast<u32>(_e1596) & 2147483647u));
                                                                        let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                                        let _e1618 = bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u));
                                                                        let _e1620 = select(_e1618, _e1615, (_e1615 > _e1618));
                                                                        let _e1626 = bitcast<f32>((bitcast<u32>(_e1534) & 2147483647u));
                                                                        let _e1629 = bitcast<f32>((bitcast<u32>(_e1539) & 2147483647u));
                                                                        let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                                        let _e1634 = bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1534 * _e1595) + (_e1539 * _e1596)) + (_e1542 * _e1597)) - _e1563)) & 2147483647u)) <= ((0.0000009536743f * select(_e1500, _e1620, (_e1620 > _e1500))) * select(_e1634, _e1631, (_e1631 > _e1634)))) {
                                                                            let _e1644 = bitcast<f32>((bitcast<u32>(_e1525.x) & 2147483647u));
                                                                            let _e1647 = bitcast<f32>((bitcast<u32>(_e1525.y) & 2147483647u));
                                                                            let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                                                            let _e1652 = bitcast<f32>((bitcast<u32>(_e1525.z) & 2147483647u));
                                                                            let _e1658 = bitcast<f32>((bitcast<u32>(_e1523.x) & 2147483647u));
                                                                            let _e1661 = bitcast<f32>((bitcast<u32>(_e1523.y) & 2147483647u));
                                                                            let _e1663 = select(_e1661, _e1658, (_e1658 > _e1661));
                                                                            let _e1666 = bitcast<f32>((bitcast<u32>(_e1523.z) & 2147483647u));
                                                                            let _e1670 = (bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u)) > ((0.0000038146973f * select(_e1652, _e1649, (_e1649 > _e1652))) * select(_e1666, _e1663, (_e1663 > _e1666))));
                                                                            if _e1670 {
                                                                                phi_2167_ = (_e1563 / _e1568);
                                                                            } else {
                                                                                phi_2167_ = f32();
                                                                            }
                                                                            let _e1673 = phi_2167_;
                                                                            phi_2169_ = _e1673;
                                                                            phi_2170_ = select(true, false, _e1670);
                                                                        } else {
                                                                            phi_2169_ = f32();
                                                                            phi_2170_ = true;
                                                                        }
                                                                        let _e1676 = phi_2169_;
                                                                        let _e1678 = phi_2170_;
                                                                        if _e1678 {
                                                                            let _e1686 = (((_e1534 * (_e1595 - (_e362 * _e1598))) + (_e1539 * (_e1596 - (_e430 * _e1598)))) / _e1568);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1686) & 2147483647u)) <= _e1500) {
                                                                                phi_2190_ = (_e1598 + _e1686);
                                                                            } else {
                                                                                phi_2190_ = _e1598;
                                                                            }
                                                                            let _e1693 = phi_2190_;
                                                                            phi_2191_ = _e1693;
                                                                        } else {
                                                                            phi_2191_ = _e1676;
                                                                        }
                                                                        let _e1695 = phi_2191_;
                                                                        let _e1697 = select(_e1433, _e1695, (_e1695 < _e1433));
                                                                        let _e1699 = select(_e1425, _e1697, (_e1697 > _e1425));
                                                                        if (_e1699 >= _e613) {
                                                                            let _e1701 = (_e1699 <= _e1177.member.member_1);
                                                                            if _e1701 {
                                                                                let _e1702 = (1f / _e1352);
                                                                                phi_2214_ = type_25(_e1699, (_e1346 * _e1702), (_e1350 * _e1702), _e1212);
                                                                            } else {
                                                                                phi_2214_ = type_25();
                                                                            }
                                                                            let _e1707 = phi_2214_;
                                                                            phi_2216_ = _e1707;
                                                                            phi_2217_ = select(true, false, _e1701);
                                                                        } else {
                                                                            phi_2216_ = type_25();
                                                                            phi_2217_ = true;
                                                                        }
                                                                        let _e1710 = phi_2216_;
                                                                        let _e1712 = phi_2217_;
                                                                        if _e1712 {
                                                                            phi_2221_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2221_ = _e1710;
                                                                        }
                                                                        let _e1714 = phi_2221_;
                                                                        phi_2222_ = _e1714;
                                                                    }
                                                                    let _e1716 = phi_2222_;
                                                                    phi_2223_ = _e1716;
                                                                    phi_2224_ = _e1442;
                                                                }
                                                                let _e1718 = phi_2223_;
                                                                let _e1720 = phi_2224_;
                                                                phi_2228_ = _e1718;
                                                                phi_2229_ = _e1720;
                                                            }
                                                            let _e1722 = phi_2228_;
                                                            let _e1724 = phi_2229_;
                                                            phi_2230_ = _e1722;
                                                            phi_2231_ = _e1377;
                                                            phi_2232_ = _e1724;
                                                        }
                                                        let _e1726 = phi_2230_;
                                                        let _e1728 = phi_2231_;
                                                        let _e1730 = phi_2232_;
                                                        phi_2233_ = _e1726;
                                                        phi_2234_ = _e1728;
                                                        phi_2235_ = _e1730;
                                                    }
                                                    let _e1732 = phi_2233_;
                                                    let _e1734 = phi_2234_;
                                                    let _e1736 = phi_2235_;
                                                    phi_2243_ = _e1732;
                                                    phi_2244_ = select(_e1736, true, _e1734);
                                                } else {
                                                    phi_2243_ = type_25();
                                                    phi_2244_ = true;
                                                }
                                                let _e1739 = phi_2243_;
                                                let _e1741 = phi_2244_;
                                                if _e1741 {
                                                    phi_2248_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2248_ = _e1739;
                                                }
                                                let _e1743 = phi_2248_;
                                                if (_e1743.member_3 != 4294967295u) {
                                                    if (_e1212 != 4294967295u) {
                                                        if (_e1743.member < _e1177.member.member.member) {
                                                            phi_2274_ = true;
                                                        } else {
                                                            if (_e1743.member == _e1177.member.member.member) {
                                                                phi_2273_ = (_e1743.member_3 < _e1177.member.member.member_3);
                                                            } else {
                                                                phi_2273_ = false;
                                                            }
                                                            let _e1758 = phi_2273_;
                                                            phi_2274_ = _e1758;
                                                        }
                                                        let _e1760 = phi_2274_;
                                                        if _e1760 {
                                                            phi_2281_ = type_40(type_34(_e1743, _e1743.member), _e1204.member_1, _e1204.member_2);
                                                        } else {
                                                            phi_2281_ = _e1204;
                                                        }
                                                        let _e1767 = phi_2281_;
                                                        phi_2282_ = _e1767;
                                                    } else {
                                                        phi_2282_ = _e1204;
                                                    }
                                                    let _e1769 = phi_2282_;
                                                    phi_2283_ = _e1769;
                                                } else {
                                                    phi_2283_ = _e1204;
                                                }
                                                let _e1771 = phi_2283_;
                                                phi_1208_ = _e1771;
                                            } else {
                                                phi_1208_ = type_40();
                                            }
                                            let _e1773 = phi_1208_;
                                            continue;
                                            continuing {
                                                phi_1207_ = _e1773;
                                                phi_1210_ = _e1192;
                                                phi_3751_ = _e656;
                                                break if !(_e1198);
                                            }
                                        }
                                        let _e1776 = phi_3751_;
                                        phi_3911_ = _e1776;
                                        if _e1776 {
                                            break;
                                        }
                                        phi_3915_ = _e1776;
                                        let _e1954 = local_12;
                                        phi_3523_ = _e1954;
                                        phi_3524_ = false;
                                        phi_3525_ = _e700;
                                        phi_3526_ = _e702;
                                    } else {
                                        if (_e702.member_1 >= _e88) {
                                            phi_3054_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e702.member_1 < _e88) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e713 = (_e258 * 2u);
                                            let _e715 = ((1u + _e713) % 7u);
                                            if (_e715 < 7u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e720 = global_5.member[_e702.member_1][_e715];
                                            let _e722 = ((_e713 + 2u) % 7u);
                                            if (_e722 < 7u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e727 = global_5.member[_e702.member_1][_e722];
                                            let _e728 = (_e257 * 2u);
                                            let _e730 = ((1u + _e728) % 7u);
                                            if (_e730 < 7u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e735 = global_5.member[_e702.member_1][_e730];
                                            let _e737 = ((_e728 + 2u) % 7u);
                                            if (_e737 < 7u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e742 = global_5.member[_e702.member_1][_e737];
                                            let _e743 = (_e259 * 2u);
                                            let _e745 = ((1u + _e743) % 7u);
                                            if (_e745 < 7u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e750 = global_5.member[_e702.member_1][_e745];
                                            let _e752 = ((_e743 + 2u) % 7u);
                                            if (_e752 < 7u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e757 = global_5.member[_e702.member_1][_e752];
                                            let _e780 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.x - _e702.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e781 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.y - _e702.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e782 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.z - _e702.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e784 = select(_e138, _e780, (_e780 > _e138));
                                            let _e786 = select(_e138, _e781, (_e781 > _e138));
                                            let _e788 = select(_e138, _e782, (_e782 > _e138));
                                            let _e819 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e720 & 2097151u))) - 8388608f) * _e784));
                                            let _e824 = (bitcast<i32>((_e720 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e827 = bitcast<f32>((_e819 & bitcast<u32>(_e824)));
                                            let _e828 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 2097151u))) - 8388608f) * _e786));
                                            let _e833 = (bitcast<i32>((_e735 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e836 = bitcast<f32>((_e828 & bitcast<u32>(_e833)));
                                            let _e837 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e750 & 2097151u))) - 8388608f) * _e788));
                                            let _e842 = (bitcast<i32>((_e750 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e845 = bitcast<f32>((_e837 & bitcast<u32>(_e842)));
                                            let _e849 = bitcast<f32>((_e819 & bitcast<u32>(~(_e824))));
                                            let _e853 = bitcast<f32>((_e828 & bitcast<u32>(~(_e833))));
                                            let _e857 = bitcast<f32>((_e837 & bitcast<u32>(~(_e842))));
                                            let _e858 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e727 & 2097151u))) - 8388608f) * _e784));
                                            let _e863 = (bitcast<i32>((_e727 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e866 = bitcast<f32>((_e858 & bitcast<u32>(_e863)));
                                            let _e867 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e742 & 2097151u))) - 8388608f) * _e786));
                                            let _e872 = (bitcast<i32>((_e742 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e875 = bitcast<f32>((_e867 & bitcast<u32>(_e872)));
                                            let _e876 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e757 & 2097151u))) - 8388608f) * _e788));
                                            let _e881 = (bitcast<i32>((_e757 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e884 = bitcast<f32>((_e876 & bitcast<u32>(_e881)));
                                            let _e888 = bitcast<f32>((_e858 & bitcast<u32>(~(_e863))));
                                            let _e892 = bitcast<f32>((_e867 & bitcast<u32>(~(_e872))));
                                            let _e896 = bitcast<f32>((_e876 & bitcast<u32>(~(_e881))));
                                            let _e926 = global_5.member[_e702.member_1][0u];
                                            let _e930 = global_5.member[_e702.member_1][2u];
                                            let _e934 = global_5.member[_e702.member_1][4u];
                                            let _e938 = global_5.member[_e702.member_1][6u];
                                            let _e950 = (((_e930 >> bitcast<u32>(22i)) | ((_e934 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e938 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e951 = (_e926 & 268435455u);
                                            let _e952 = (_e950 & 268435455u);
                                            let _e955 = ((_e926 >> bitcast<u32>(28u)) & 7u);
                                            let _e963 = ((_e926 >> bitcast<u32>(31i)) | (((_e950 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e964 = (_e955 != 0u);
                                            if (_e955 == 0u) {
                                                phi_3016_ = _e951;
                                            } else {
                                                if (_e955 == 7u) {
                                                    phi_3015_ = 2147483648u;
                                                } else {
                                                    phi_3015_ = ((2147483648u | (_e955 << bitcast<u32>(28u))) | (_e952 & 268435455u));
                                                }
                                                let _e973 = phi_3015_;
                                                phi_3016_ = _e973;
                                            }
                                            let _e975 = phi_3016_;
                                            if _e964 {
                                                let _e976 = (_e955 != 7u);
                                                if _e976 {
                                                    phi_3026_ = (_e952 + _e955);
                                                } else {
                                                    phi_3026_ = u32();
                                                }
                                                let _e979 = phi_3026_;
                                                phi_3028_ = _e979;
                                                phi_3029_ = select(true, false, _e976);
                                            } else {
                                                phi_3028_ = u32();
                                                phi_3029_ = true;
                                            }
                                            let _e982 = phi_3028_;
                                            let _e984 = phi_3029_;
                                            if (_e963 == 0u) {
                                                phi_3050_ = (_e951 + select(0u, 1u, !(_e964)));
                                            } else {
                                                if (_e963 == 7u) {
                                                    phi_3049_ = 2147483648u;
                                                } else {
                                                    phi_3049_ = ((2147483648u | (_e963 << bitcast<u32>(28u))) | (select(_e982, _e952, _e984) & 268435455u));
                                                }
                                                let _e997 = phi_3049_;
                                                phi_3050_ = _e997;
                                            }
                                            let _e999 = phi_3050_;
                                            phi_3054_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e702.member.member.x + _e827), (_e702.member.member.x + _e849), (_e702.member.member_1.x - _e866), (_e702.member.member_1.x - _e888)), vec4<f32>((_e702.member.member.y + _e836), (_e702.member.member.y + _e853), (_e702.member.member_1.y - _e875), (_e702.member.member_1.y - _e892)), vec4<f32>((_e702.member.member.z + _e845), (_e702.member.member.z + _e857), (_e702.member.member_1.z - _e884), (_e702.member.member_1.z - _e896))), type_51(type_29((_e702.member.member + vec4<f32>(_e827, _e836, _e845, 0f)), (_e702.member.member_1 - vec4<f32>(_e866, _e875, _e884, 0f))), _e975), type_51(type_29((_e702.member.member + vec4<f32>(_e849, _e853, _e857, 0f)), (_e702.member.member_1 - vec4<f32>(_e888, _e892, _e896, 0f))), _e999));
                                        }
                                        let _e1004 = phi_3054_;
                                        let _e1023 = ((_e1004.member[0].x - _e360) * _e365);
                                        let _e1024 = ((_e1004.member[0].y - _e360) * _e365);
                                        let _e1025 = ((_e1004.member[0].z - _e361) * _e365);
                                        let _e1026 = ((_e1004.member[0].w - _e361) * _e365);
                                        let _e1036 = ((_e1004.member[1].x - _e428) * _e433);
                                        let _e1037 = ((_e1004.member[1].y - _e428) * _e433);
                                        let _e1038 = ((_e1004.member[1].z - _e429) * _e433);
                                        let _e1039 = ((_e1004.member[1].w - _e429) * _e433);
                                        let _e1049 = ((_e1004.member[2].x - _e496) * _e501);
                                        let _e1050 = ((_e1004.member[2].y - _e496) * _e501);
                                        let _e1051 = ((_e1004.member[2].z - _e497) * _e501);
                                        let _e1052 = ((_e1004.member[2].w - _e497) * _e501);
                                        let _e1054 = select(_e1051, _e1049, (_e1049 < _e1051));
                                        let _e1056 = select(_e1052, _e1050, (_e1050 < _e1052));
                                        let _e1058 = select(_e1051, _e1049, (_e1049 > _e1051));
                                        let _e1060 = select(_e1052, _e1050, (_e1050 > _e1052));
                                        let _e1062 = select(_e1025, _e1023, (_e1023 < _e1025));
                                        let _e1064 = select(_e1026, _e1024, (_e1024 < _e1026));
                                        let _e1066 = select(_e1038, _e1036, (_e1036 < _e1038));
                                        let _e1068 = select(_e1039, _e1037, (_e1037 < _e1039));
                                        let _e1070 = select(_e1066, _e1062, (_e1062 > _e1066));
                                        let _e1072 = select(_e1068, _e1064, (_e1064 > _e1068));
                                        let _e1074 = select(_e1054, _e1070, (_e1070 > _e1054));
                                        let _e1076 = select(_e1056, _e1072, (_e1072 > _e1056));
                                        let _e1078 = select(_e1025, _e1023, (_e1023 > _e1025));
                                        let _e1080 = select(_e1026, _e1024, (_e1024 > _e1026));
                                        let _e1082 = select(_e1038, _e1036, (_e1036 > _e1038));
                                        let _e1084 = select(_e1039, _e1037, (_e1037 > _e1039));
                                        let _e1086 = select(_e1082, _e1078, (_e1078 < _e1082));
                                        let _e1088 = select(_e1084, _e1080, (_e1080 < _e1084));
                                        let _e1093 = -(_e1054);
                                        let _e1094 = -(_e1056);
                                        let _e1101 = (select(_e1058, _e1086, (_e1086 < _e1058)) + (select(_e1093, _e1058, (_e1058 > _e1093)) * 0.0000019073523f));
                                        let _e1102 = (select(_e1060, _e1088, (_e1088 < _e1060)) + (select(_e1094, _e1060, (_e1060 > _e1094)) * 0.0000019073523f));
                                        let _e1104 = select(_e613, _e1074, (_e1074 > _e613));
                                        let _e1106 = select(_e613, _e1076, (_e1076 > _e613));
                                        let _e1111 = (_e1104 <= select(_e658.member.member_1, _e1101, (_e1101 < _e658.member.member_1)));
                                        let _e1112 = (_e1106 <= select(_e658.member.member_1, _e1102, (_e1102 < _e658.member.member_1)));
                                        let _e1113 = (_e1104 <= _e1106);
                                        if _e1111 {
                                            if _e1112 {
                                                if _e1113 {
                                                    phi_3419_ = _e1004.member_2;
                                                } else {
                                                    phi_3419_ = _e1004.member_1;
                                                }
                                                let _e1117 = phi_3419_;
                                                let _e1139 = (_e700 % 128u);
                                                let _e1140 = (_e1139 < 128u);
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_8[_e1139] = _e1117.member_1;
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_7[_e1139] = _e1117.member.member.x;
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_6[_e1139] = _e1117.member.member.y;
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_5[_e1139] = _e1117.member.member.z;
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_4[_e1139] = _e1117.member.member_1.x;
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_3[_e1139] = _e1117.member.member_1.y;
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_2[_e1139] = _e1117.member.member_1.z;
                                                if _e1140 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_9[_e1139] = select(_e1106, _e1104, !(_e1113));
                                                if _e1113 {
                                                    phi_3496_ = _e1004.member_1;
                                                } else {
                                                    phi_3496_ = _e1004.member_2;
                                                }
                                                let _e1153 = phi_3496_;
                                                phi_3497_ = (_e700 + 1u);
                                                phi_3498_ = _e1153;
                                            } else {
                                                phi_3497_ = u32();
                                                phi_3498_ = type_51();
                                            }
                                            let _e1155 = phi_3497_;
                                            let _e1157 = phi_3498_;
                                            phi_3500_ = _e1155;
                                            phi_3501_ = _e1157;
                                            phi_3502_ = select(true, false, _e1112);
                                        } else {
                                            phi_3500_ = u32();
                                            phi_3501_ = type_51();
                                            phi_3502_ = true;
                                        }
                                        let _e1160 = phi_3500_;
                                        let _e1162 = phi_3501_;
                                        let _e1164 = phi_3502_;
                                        if _e1164 {
                                            if _e1111 {
                                                phi_3511_ = _e1004.member_1;
                                            } else {
                                                phi_3511_ = _e1004.member_2;
                                            }
                                            let _e1168 = phi_3511_;
                                            phi_3516_ = select(_e1112, true, _e1111);
                                            phi_3518_ = _e1168;
                                        } else {
                                            phi_3516_ = _e698;
                                            phi_3518_ = _e1162;
                                        }
                                        let _e1171 = phi_3516_;
                                        let _e1173 = phi_3518_;
                                        phi_3915_ = _e656;
                                        phi_3523_ = type_40(_e658.member, (_e658.member_1 + 1u), _e658.member_2);
                                        phi_3524_ = _e1171;
                                        phi_3525_ = select(_e1160, _e700, _e1164);
                                        phi_3526_ = _e1173;
                                    }
                                    let _e1778 = phi_3915_;
                                    let _e1780 = phi_3523_;
                                    let _e1782 = phi_3524_;
                                    let _e1784 = phi_3525_;
                                    let _e1786 = phi_3526_;
                                    phi_3914_ = _e1778;
                                    phi_3527_ = _e1780;
                                    phi_3528_ = _e1782;
                                    phi_3529_ = (_e662 - 1u);
                                    phi_3530_ = _e1784;
                                    phi_3531_ = _e1786;
                                } else {
                                    phi_3914_ = _e656;
                                    phi_3527_ = _e658;
                                    phi_3528_ = _e698;
                                    phi_3529_ = _e662;
                                    phi_3530_ = _e700;
                                    phi_3531_ = _e702;
                                }
                                let _e1788 = phi_3914_;
                                let _e1790 = phi_3527_;
                                let _e1792 = phi_3528_;
                                let _e1794 = phi_3529_;
                                let _e1796 = phi_3530_;
                                let _e1798 = phi_3531_;
                                phi_3913_ = _e1788;
                                phi_3532_ = _e1790;
                                phi_3533_ = _e1792;
                                phi_3534_ = _e1794;
                                phi_3535_ = _e1796;
                                phi_3536_ = _e1798;
                            } else {
                                phi_3913_ = _e656;
                                phi_3532_ = type_40();
                                phi_3533_ = bool();
                                phi_3534_ = u32();
                                phi_3535_ = u32();
                                phi_3536_ = type_51();
                            }
                            let _e1800 = phi_3913_;
                            let _e1802 = phi_3532_;
                            let _e1804 = phi_3533_;
                            let _e1806 = phi_3534_;
                            let _e1808 = phi_3535_;
                            let _e1810 = phi_3536_;
                            phi_3912_ = _e1800;
                            phi_1082_ = _e1802;
                            phi_1085_ = _e1804;
                            phi_1087_ = _e1806;
                            phi_1089_ = _e1808;
                            phi_1091_ = _e1810;
                            phi_3537_ = _e670;
                        } else {
                            phi_3912_ = _e656;
                            phi_1082_ = type_40();
                            phi_1085_ = bool();
                            phi_1087_ = u32();
                            phi_1089_ = u32();
                            phi_1091_ = type_51();
                            phi_3537_ = false;
                        }
                        let _e1812 = phi_3912_;
                        let _e1814 = phi_1082_;
                        let _e1816 = phi_1085_;
                        let _e1818 = phi_1087_;
                        let _e1820 = phi_1089_;
                        let _e1822 = phi_1091_;
                        let _e1824 = phi_3537_;
                        continue;
                        continuing {
                            phi_3757_ = _e1812;
                            phi_1081_ = _e1814;
                            phi_1084_ = _e1816;
                            phi_1086_ = _e1818;
                            phi_1088_ = _e1820;
                            phi_1090_ = _e1822;
                            phi_3911_ = _e1812;
                            break if !(_e1824);
                        }
                    }
                    let _e1827 = phi_3911_;
                    if _e1827 {
                        break;
                    }
                    let _e1829 = local_10;
                    let _e1832 = local_11;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_6.member[_e144][0u] = _e1829.member_1;
                    global_6.member[_e144][1u] = _e1832.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
