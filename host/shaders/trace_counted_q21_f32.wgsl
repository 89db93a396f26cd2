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
    var phi_3763_: bool;
    var phi_1081_: type_40;
    var phi_1084_: u32;
    var phi_1086_: bool;
    var phi_1088_: u32;
    var phi_1090_: type_51;
    var phi_1101_: bool;
    var phi_1187_: bool;
    var phi_1188_: u32;
    var phi_1189_: type_51;
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
    var phi_3757_: bool;
    var phi_4003_: bool;
    var phi_2284_: type_40;
    var phi_3011_: u32;
    var phi_3012_: u32;
    var phi_3022_: u32;
    var phi_3024_: u32;
    var phi_3025_: bool;
    var phi_3045_: u32;
    var phi_3046_: u32;
    var phi_3050_: type_52;
    var phi_3415_: type_51;
    var phi_3491_: type_51;
    var phi_3492_: u32;
    var phi_3493_: type_51;
    var phi_3495_: u32;
    var phi_3496_: type_51;
    var phi_3497_: bool;
    var phi_3506_: type_51;
    var phi_3511_: bool;
    var phi_3513_: type_51;
    var phi_3518_: type_40;
    var phi_3519_: bool;
    var phi_3520_: u32;
    var phi_3521_: type_51;
    var phi_3529_: type_40;
    var phi_3532_: type_51;
    var phi_3920_: bool;
    var phi_3533_: type_40;
    var phi_3534_: u32;
    var phi_3535_: bool;
    var phi_3536_: u32;
    var phi_3537_: type_51;
    var phi_3919_: bool;
    var phi_3538_: type_40;
    var phi_3539_: u32;
    var phi_3540_: bool;
    var phi_3541_: u32;
    var phi_3542_: type_51;
    var phi_3918_: bool;
    var phi_1082_: type_40;
    var phi_1085_: u32;
    var phi_1087_: bool;
    var phi_1089_: u32;
    var phi_1091_: type_51;
    var phi_3543_: bool;
    var phi_3917_: bool;
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
                    phi_3763_ = false;
                    phi_1081_ = type_40(type_34(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e611), 0u, 0u);
                    phi_1084_ = ((3u * _e88) + 1u);
                    phi_1086_ = (_e613 <= _e611);
                    phi_1088_ = 0u;
                    phi_1090_ = type_51(type_29(vec4<f32>((f32(_e621) * _e138), (f32(_e627) * _e138), (f32(_e633) * _e138), 0f), vec4<f32>((f32(_e638) * _e138), (f32(_e642) * _e138), (f32(_e646) * _e138), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    loop {
                        let _e656 = phi_3763_;
                        let _e658 = phi_1081_;
                        let _e660 = phi_1084_;
                        let _e662 = phi_1086_;
                        let _e664 = phi_1088_;
                        let _e666 = phi_1090_;
                        local_10 = _e658;
                        local_11 = _e658;
                        if _e662 {
                            phi_1101_ = true;
                        } else {
                            phi_1101_ = (_e664 > 0u);
                        }
                        let _e669 = phi_1101_;
                        if _e669 {
                            let _e670 = (_e660 > 0u);
                            if _e670 {
                                if _e662 {
                                    phi_1187_ = _e662;
                                    phi_1188_ = _e664;
                                    phi_1189_ = _e666;
                                } else {
                                    let _e671 = (_e664 - 1u);
                                    let _e672 = (_e671 % 128u);
                                    let _e673 = (_e672 < 128u);
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e675 = local_7[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e677 = local_6[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e679 = local_5[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e681 = local_4[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e683 = local_3[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e685 = local_2[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e690 = local_8[_e672];
                                    if _e673 {
                                    } else {
                                        phi_3917_ = true;
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
                                    let _e706 = ((_e702.member_1 & 2147483648u) != 0u);
                                    if _e706 {
                                        phi_1207_ = _e658;
                                        phi_1210_ = type_4(0u, ((_e702.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e713 = phi_1207_;
                                            let _e715 = phi_1210_;
                                            local_12 = _e713;
                                            if (_e715.member < _e715.member_1) {
                                                phi_1211_ = type_4((_e715.member + 1u), _e715.member_1);
                                                phi_1233_ = type_4(1u, _e715.member);
                                            } else {
                                                phi_1211_ = _e715;
                                                phi_1233_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e728 = phi_1211_;
                                            let _e730 = phi_1233_;
                                            let _e734 = (bitcast<i32>(_e730.member) != 0i);
                                            if _e734 {
                                                let _e740 = type_40(_e713.member, _e713.member_1, (_e713.member_2 + 1u));
                                                let _e741 = ((_e702.member_1 & 268435455u) + _e730.member_1);
                                                let _e742 = (_e741 < _e90);
                                                if _e742 {
                                                    if _e742 {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e746 = global_2.member[_e741].member_1;
                                                    phi_1257_ = _e746;
                                                } else {
                                                    phi_1257_ = 4294967295u;
                                                }
                                                let _e748 = phi_1257_;
                                                if (_e741 >= _e90) {
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e742 {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    if (_e618 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e755 = global_2.member[_e741].member[_e618];
                                                    if (_e624 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e761 = global_2.member[_e741].member[_e624];
                                                    if (_e630 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_2.member[_e741].member[_e630];
                                                    let _e769 = (3u + _e618);
                                                    if (_e769 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e775 = global_2.member[_e741].member[_e769];
                                                    let _e776 = (3u + _e624);
                                                    if (_e776 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e782 = global_2.member[_e741].member[_e776];
                                                    let _e783 = (3u + _e630);
                                                    if (_e783 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e789 = global_2.member[_e741].member[_e783];
                                                    let _e791 = (6u + _e618);
                                                    if (_e791 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e797 = global_2.member[_e741].member[_e791];
                                                    let _e798 = (6u + _e624);
                                                    if (_e798 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e804 = global_2.member[_e741].member[_e798];
                                                    let _e805 = (6u + _e630);
                                                    if (_e805 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e811 = global_2.member[_e741].member[_e805];
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(_e755, _e761, _e767), array<f32, 3>(_e775, _e782, _e789), array<f32, 3>(_e797, _e804, _e811));
                                                }
                                                let _e815 = phi_1349_;
                                                let _e824 = (_e815[0][2] - _e459);
                                                let _e827 = (((_e815[0][0] - _e322) * _e498) - (_e824 * _e362));
                                                let _e830 = (((_e815[0][1] - _e391) * _e498) - (_e824 * _e430));
                                                let _e837 = (_e815[1][2] - _e459);
                                                let _e840 = (((_e815[1][0] - _e322) * _e498) - (_e837 * _e362));
                                                let _e843 = (((_e815[1][1] - _e391) * _e498) - (_e837 * _e430));
                                                let _e850 = (_e815[2][2] - _e459);
                                                let _e853 = (((_e815[2][0] - _e322) * _e498) - (_e850 * _e362));
                                                let _e856 = (((_e815[2][1] - _e391) * _e498) - (_e850 * _e430));
                                                let _e857 = (_e853 * _e843);
                                                let _e858 = (_e856 * _e840);
                                                let _e859 = (_e827 * _e856);
                                                let _e860 = (_e830 * _e853);
                                                let _e861 = (_e840 * _e830);
                                                let _e862 = (_e843 * _e827);
                                                let _e867 = (((_e857 >= _e858) && (_e859 >= _e860)) && (_e861 >= _e862));
                                                if (_e867 || (((_e857 <= _e858) && (_e859 <= _e860)) && (_e861 <= _e862))) {
                                                    let _e874 = select(-1f, 1f, _e867);
                                                    let _e876 = ((_e857 - _e858) * _e874);
                                                    let _e878 = select(0f, _e876, (_e876 > 0f));
                                                    let _e880 = ((_e859 - _e860) * _e874);
                                                    let _e882 = select(0f, _e880, (_e880 > 0f));
                                                    let _e884 = ((_e861 - _e862) * _e874);
                                                    let _e886 = select(0f, _e884, (_e884 > 0f));
                                                    let _e888 = ((_e878 + _e882) + _e886);
                                                    if (_e888 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2233_ = type_25();
                                                        phi_2234_ = true;
                                                        phi_2235_ = false;
                                                    } else {
                                                        let _e891 = select(_e840, _e827, (_e827 < _e840));
                                                        if (select(_e853, _e891, (_e891 < _e853)) > 0f) {
                                                            phi_1501_ = true;
                                                        } else {
                                                            let _e896 = select(_e840, _e827, (_e827 > _e840));
                                                            phi_1501_ = (select(_e853, _e896, (_e896 > _e853)) < 0f);
                                                        }
                                                        let _e901 = phi_1501_;
                                                        if _e901 {
                                                            phi_2230_ = type_25();
                                                            phi_2231_ = true;
                                                            phi_2232_ = false;
                                                        } else {
                                                            let _e903 = select(_e843, _e830, (_e830 < _e843));
                                                            if (select(_e856, _e903, (_e903 < _e856)) > 0f) {
                                                                phi_1530_ = true;
                                                            } else {
                                                                let _e908 = select(_e843, _e830, (_e830 > _e843));
                                                                phi_1530_ = (select(_e856, _e908, (_e908 > _e856)) < 0f);
                                                            }
                                                            let _e913 = phi_1530_;
                                                            if _e913 {
                                                                phi_2228_ = type_25();
                                                                phi_2229_ = false;
                                                            } else {
                                                                let _e915 = select(_e815[1][0], _e815[0][0], (_e815[0][0] < _e815[1][0]));
                                                                let _e919 = select(_e815[1][0], _e815[0][0], (_e815[0][0] > _e815[1][0]));
                                                                let _e923 = select(_e815[1][1], _e815[0][1], (_e815[0][1] < _e815[1][1]));
                                                                let _e927 = select(_e815[1][1], _e815[0][1], (_e815[0][1] > _e815[1][1]));
                                                                let _e931 = select(_e815[1][2], _e815[0][2], (_e815[0][2] < _e815[1][2]));
                                                                let _e935 = select(_e815[1][2], _e815[0][2], (_e815[0][2] > _e815[1][2]));
                                                                let _e940 = ((select(_e815[2][0], _e915, (_e915 < _e815[2][0])) - _e360) * _e365);
                                                                let _e941 = ((select(_e815[2][0], _e919, (_e919 > _e815[2][0])) - _e361) * _e365);
                                                                let _e944 = ((select(_e815[2][1], _e923, (_e923 < _e815[2][1])) - _e428) * _e433);
                                                                let _e945 = ((select(_e815[2][1], _e927, (_e927 > _e815[2][1])) - _e429) * _e433);
                                                                let _e948 = ((select(_e815[2][2], _e931, (_e931 < _e815[2][2])) - _e496) * _e501);
                                                                let _e949 = ((select(_e815[2][2], _e935, (_e935 > _e815[2][2])) - _e497) * _e501);
                                                                let _e951 = select(_e949, _e948, (_e948 < _e949));
                                                                let _e953 = select(_e949, _e948, (_e948 > _e949));
                                                                let _e955 = select(_e941, _e940, (_e940 < _e941));
                                                                let _e957 = select(_e945, _e944, (_e944 < _e945));
                                                                let _e959 = select(_e957, _e955, (_e955 > _e957));
                                                                let _e961 = select(_e951, _e959, (_e959 > _e951));
                                                                let _e963 = select(_e941, _e940, (_e940 > _e941));
                                                                let _e965 = select(_e945, _e944, (_e944 > _e945));
                                                                let _e967 = select(_e965, _e963, (_e963 < _e965));
                                                                let _e969 = select(_e953, _e967, (_e967 < _e953));
                                                                let _e970 = -(_e951);
                                                                let _e976 = select(_e613, _e961, (_e961 > _e613));
                                                                if (_e976 > (_e969 + (select(_e970, _e953, (_e953 > _e970)) * 0.0000019073523f))) {
                                                                    phi_2223_ = type_25();
                                                                    phi_2224_ = true;
                                                                } else {
                                                                    let _e978 = (_e976 > _e713.member.member_1);
                                                                    if _e978 {
                                                                        phi_2222_ = type_25();
                                                                    } else {
                                                                        let _e979 = vec3<f32>(_e815[0][0], _e815[0][1], _e815[0][2]);
                                                                        let _e980 = vec3<f32>(_e815[1][0], _e815[1][1], _e815[1][2]);
                                                                        let _e981 = vec3<f32>(_e815[2][0], _e815[2][1], _e815[2][2]);
                                                                        let _e982 = (_e815[1][0] - _e815[0][0]);
                                                                        let _e983 = (_e815[1][1] - _e815[0][1]);
                                                                        let _e984 = (_e815[1][2] - _e815[0][2]);
                                                                        let _e985 = vec3<f32>(_e982, _e983, _e984);
                                                                        let _e986 = (_e815[2][0] - _e815[1][0]);
                                                                        let _e987 = (_e815[2][1] - _e815[1][1]);
                                                                        let _e988 = (_e815[2][2] - _e815[1][2]);
                                                                        let _e989 = vec3<f32>(_e986, _e987, _e988);
                                                                        let _e990 = (_e815[0][0] - _e815[2][0]);
                                                                        let _e991 = (_e815[0][1] - _e815[2][1]);
                                                                        let _e992 = (_e815[0][2] - _e815[2][2]);
                                                                        let _e993 = vec3<f32>(_e990, _e991, _e992);
                                                                        let _e996 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                        let _e999 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1001 = select(_e999, _e996, (_e996 > _e999));
                                                                        let _e1004 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1006 = select(_e1004, _e1001, (_e1001 > _e1004));
                                                                        let _e1009 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                        let _e1012 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                        let _e1014 = select(_e1012, _e1009, (_e1009 > _e1012));
                                                                        let _e1017 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                        let _e1019 = select(_e1017, _e1014, (_e1014 > _e1017));
                                                                        let _e1022 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                        let _e1025 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                                        let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                                                                        let _e1030 = bitcast<f32>((bitcast<u32>(_e992) & 2147483647u));
                                                                        let _e1032 = select(_e1030, _e1027, (_e1027 > _e1030));
                                                                        let _e1034 = select(_e1019, _e1006, (_e1006 > _e1019));
                                                                        let _e1036 = select(_e1032, _e1034, (_e1034 > _e1032));
                                                                        if (_e1006 == _e1036) {
                                                                            phi_1949_ = _e843;
                                                                            phi_1950_ = _e840;
                                                                            phi_1951_ = _e830;
                                                                            phi_1952_ = _e827;
                                                                            phi_1953_ = _e979;
                                                                            phi_1954_ = _e993;
                                                                            phi_1955_ = _e989;
                                                                            phi_1956_ = _e985;
                                                                        } else {
                                                                            let _e1038 = (_e1019 == _e1036);
                                                                            let _e1043 = vec3(_e1038);
                                                                            phi_1949_ = select(_e830, _e856, _e1038);
                                                                            phi_1950_ = select(_e827, _e853, _e1038);
                                                                            phi_1951_ = select(_e856, _e843, _e1038);
                                                                            phi_1952_ = select(_e853, _e840, _e1038);
                                                                            phi_1953_ = select(_e981, _e980, _e1043);
                                                                            phi_1954_ = select(_e989, _e985, _e1043);
                                                                            phi_1955_ = select(_e985, _e993, _e1043);
                                                                            phi_1956_ = select(_e993, _e989, _e1043);
                                                                        }
                                                                        let _e1049 = phi_1949_;
                                                                        let _e1051 = phi_1950_;
                                                                        let _e1053 = phi_1951_;
                                                                        let _e1055 = phi_1952_;
                                                                        let _e1057 = phi_1953_;
                                                                        let _e1059 = phi_1954_;
                                                                        let _e1061 = phi_1955_;
                                                                        let _e1063 = phi_1956_;
                                                                        let _e1070 = ((_e1061.y * _e1059.z) - (_e1059.y * _e1061.z));
                                                                        let _e1075 = ((_e1061.z * _e1059.x) - (_e1059.z * _e1061.x));
                                                                        let _e1078 = ((_e1061.x * _e1059.y) - (_e1059.x * _e1061.y));
                                                                        if (_e878 >= _e882) {
                                                                            phi_1993_ = select(true, false, (_e878 >= _e886));
                                                                        } else {
                                                                            phi_1993_ = true;
                                                                        }
                                                                        let _e1083 = phi_1993_;
                                                                        if _e1083 {
                                                                            phi_2002_ = select(_e981, _e980, vec3((_e882 >= _e886)));
                                                                        } else {
                                                                            phi_2002_ = _e979;
                                                                        }
                                                                        let _e1088 = phi_2002_;
                                                                        let _e1099 = (((_e1070 * (_e1088.x - _e322)) + (_e1075 * (_e1088.y - _e391))) + (_e1078 * (_e1088.z - _e459)));
                                                                        let _e1104 = (((_e1070 * _e362) + (_e1075 * _e430)) + (_e1078 * _e498));
                                                                        let _e1105 = (_e1051 - _e1055);
                                                                        let _e1106 = (_e1049 - _e1053);
                                                                        let _e1114 = (-(((_e1055 * _e1105) + (_e1053 * _e1106))) / ((_e1105 * _e1105) + (_e1106 * _e1106)));
                                                                        let _e1116 = select(1f, _e1114, (_e1114 < 1f));
                                                                        let _e1118 = select(0f, _e1116, (_e1116 > 0f));
                                                                        let _e1131 = ((_e1057.x + (_e1063.x * _e1118)) - _e322);
                                                                        let _e1132 = ((_e1057.y + (_e1063.y * _e1118)) - _e391);
                                                                        let _e1133 = ((_e1057.z + (_e1063.z * _e1118)) - _e459);
                                                                        let _e1134 = (_e1133 / _e498);
                                                                        let _e1146 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                        let _e1149 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                        let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                                        let _e1154 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                                        let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                        let _e1162 = bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u));
                                                                        let _e1165 = bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u));
                                                                        let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                        let _e1170 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1070 * _e1131) + (_e1075 * _e1132)) + (_e1078 * _e1133)) - _e1099)) & 2147483647u)) <= ((0.0000009536743f * select(_e1036, _e1156, (_e1156 > _e1036))) * select(_e1170, _e1167, (_e1167 > _e1170)))) {
                                                                            let _e1180 = bitcast<f32>((bitcast<u32>(_e1061.x) & 2147483647u));
                                                                            let _e1183 = bitcast<f32>((bitcast<u32>(_e1061.y) & 2147483647u));
                                                                            let _e1185 = select(_e1183, _e1180, (_e1180 > _e1183));
                                                                            let _e1188 = bitcast<f32>((bitcast<u32>(_e1061.z) & 2147483647u));
                                                                            let _e1194 = bitcast<f32>((bitcast<u32>(_e1059.x) & 2147483647u));
                                                                            let _e1197 = bitcast<f32>((bitcast<u32>(_e1059.y) & 2147483647u));
                                                                            let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                                            let _e1202 = bitcast<f32>((bitcast<u32>(_e1059.z) & 2147483647u));
                                                                            let _e1206 = (bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u)) > ((0.0000038146973f * select(_e1188, _e1185, (_e1185 > _e1188))) * select(_e1202, _e1199, (_e1199 > _e1202))));
                                                                            if _e1206 {
                                                                                phi_2167_ = (_e1099 / _e1104);
                                                                            } else {
                                                                                phi_2167_ = f32();
                                                                            }
                                                                            let _e1209 = phi_2167_;
                                                                            phi_2169_ = _e1209;
                                                                            phi_2170_ = select(true, false, _e1206);
                                                                        } else {
                                                                            phi_2169_ = f32();
                                                                            phi_2170_ = true;
                                                                        }
                                                                        let _e1212 = phi_2169_;
                                                                        let _e1214 = phi_2170_;
                                                                        if _e1214 {
                                                                            let _e1222 = (((_e1070 * (_e1131 - (_e362 * _e1134))) + (_e1075 * (_e1132 - (_e430 * _e1134)))) / _e1104);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u)) <= _e1036) {
                                                                                phi_2190_ = (_e1134 + _e1222);
                                                                            } else {
                                                                                phi_2190_ = _e1134;
                                                                            }
                                                                            let _e1229 = phi_2190_;
                                                                            phi_2191_ = _e1229;
                                                                        } else {
                                                                            phi_2191_ = _e1212;
                                                                        }
                                                                        let _e1231 = phi_2191_;
                                                                        let _e1233 = select(_e969, _e1231, (_e1231 < _e969));
                                                                        let _e1235 = select(_e961, _e1233, (_e1233 > _e961));
                                                                        if (_e1235 >= _e613) {
                                                                            let _e1237 = (_e1235 <= _e713.member.member_1);
                                                                            if _e1237 {
                                                                                let _e1238 = (1f / _e888);
                                                                                phi_2214_ = type_25(_e1235, (_e882 * _e1238), (_e886 * _e1238), _e748);
                                                                            } else {
                                                                                phi_2214_ = type_25();
                                                                            }
                                                                            let _e1243 = phi_2214_;
                                                                            phi_2216_ = _e1243;
                                                                            phi_2217_ = select(true, false, _e1237);
                                                                        } else {
                                                                            phi_2216_ = type_25();
                                                                            phi_2217_ = true;
                                                                        }
                                                                        let _e1246 = phi_2216_;
                                                                        let _e1248 = phi_2217_;
                                                                        if _e1248 {
                                                                            phi_2221_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2221_ = _e1246;
                                                                        }
                                                                        let _e1250 = phi_2221_;
                                                                        phi_2222_ = _e1250;
                                                                    }
                                                                    let _e1252 = phi_2222_;
                                                                    phi_2223_ = _e1252;
                                                                    phi_2224_ = _e978;
                                                                }
                                                                let _e1254 = phi_2223_;
                                                                let _e1256 = phi_2224_;
                                                                phi_2228_ = _e1254;
                                                                phi_2229_ = _e1256;
                                                            }
                                                            let _e1258 = phi_2228_;
                                                            let _e1260 = phi_2229_;
                                                            phi_2230_ = _e1258;
                                                            phi_2231_ = _e913;
                                                            phi_2232_ = _e1260;
                                                        }
                                                        let _e1262 = phi_2230_;
                                                        let _e1264 = phi_2231_;
                                                        let _e1266 = phi_2232_;
                                                        phi_2233_ = _e1262;
                                                        phi_2234_ = _e1264;
                                                        phi_2235_ = _e1266;
                                                    }
                                                    let _e1268 = phi_2233_;
                                                    let _e1270 = phi_2234_;
                                                    let _e1272 = phi_2235_;
                                                    phi_2243_ = _e1268;
                                                    phi_2244_ = select(_e1272, true, _e1270);
                                                } else {
                                                    phi_2243_ = type_25();
                                                    phi_2244_ = true;
                                                }
                                                let _e1275 = phi_2243_;
                                                let _e1277 = phi_2244_;
                                                if _e1277 {
                                                    phi_2248_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2248_ = _e1275;
                                                }
                                                let _e1279 = phi_2248_;
                                                if (_e1279.member_3 != 4294967295u) {
                                                    if (_e748 != 4294967295u) {
                                                        if (_e1279.member < _e713.member.member.member) {
                                                            phi_2274_ = true;
                                                        } else {
                                                            if (_e1279.member == _e713.member.member.member) {
                                                                phi_2273_ = (_e1279.member_3 < _e713.member.member.member_3);
                                                            } else {
                                                                phi_2273_ = false;
                                                            }
                                                            let _e1294 = phi_2273_;
                                                            phi_2274_ = _e1294;
                                                        }
                                                        let _e1296 = phi_2274_;
                                                        if _e1296 {
                                                            phi_2281_ = type_40(type_34(_e1279, _e1279.member), _e740.member_1, _e740.member_2);
                                                        } else {
                                                            phi_2281_ = _e740;
                                                        }
                                                        let _e1303 = phi_2281_;
                                                        phi_2282_ = _e1303;
                                                    } else {
                                                        phi_2282_ = _e740;
                                                    }
                                                    let _e1305 = phi_2282_;
                                                    phi_2283_ = _e1305;
                                                } else {
                                                    phi_2283_ = _e740;
                                                }
                                                let _e1307 = phi_2283_;
                                                phi_1208_ = _e1307;
                                            } else {
                                                phi_1208_ = type_40();
                                            }
                                            let _e1309 = phi_1208_;
                                            continue;
                                            continuing {
                                                phi_1207_ = _e1309;
                                                phi_1210_ = _e728;
                                                phi_3757_ = _e656;
                                                break if !(_e734);
                                            }
                                        }
                                        let _e1312 = phi_3757_;
                                        phi_3917_ = _e1312;
                                        if _e1312 {
                                            break;
                                        }
                                        phi_4003_ = _e1312;
                                        let _e1943 = local_12;
                                        phi_2284_ = _e1943;
                                    } else {
                                        phi_4003_ = _e656;
                                        phi_2284_ = _e658;
                                    }
                                    let _e1314 = phi_4003_;
                                    let _e1316 = phi_2284_;
                                    if _e706 {
                                        phi_3518_ = type_40();
                                        phi_3519_ = bool();
                                        phi_3520_ = u32();
                                        phi_3521_ = type_51();
                                    } else {
                                        if (_e702.member_1 >= _e88) {
                                            phi_3050_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e702.member_1 < _e88) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1319 = (_e258 * 2u);
                                            let _e1321 = ((1u + _e1319) % 7u);
                                            if (_e1321 < 7u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1326 = global_5.member[_e702.member_1][_e1321];
                                            let _e1328 = ((_e1319 + 2u) % 7u);
                                            if (_e1328 < 7u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1333 = global_5.member[_e702.member_1][_e1328];
                                            let _e1334 = (_e257 * 2u);
                                            let _e1336 = ((1u + _e1334) % 7u);
                                            if (_e1336 < 7u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1341 = global_5.member[_e702.member_1][_e1336];
                                            let _e1343 = ((_e1334 + 2u) % 7u);
                                            if (_e1343 < 7u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1348 = global_5.member[_e702.member_1][_e1343];
                                            let _e1349 = (_e259 * 2u);
                                            let _e1351 = ((1u + _e1349) % 7u);
                                            if (_e1351 < 7u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1356 = global_5.member[_e702.member_1][_e1351];
                                            let _e1358 = ((_e1349 + 2u) % 7u);
                                            if (_e1358 < 7u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1363 = global_5.member[_e702.member_1][_e1358];
                                            let _e1386 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.x - _e702.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1387 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.y - _e702.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1388 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.z - _e702.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1390 = select(_e138, _e1386, (_e1386 > _e138));
                                            let _e1392 = select(_e138, _e1387, (_e1387 > _e138));
                                            let _e1394 = select(_e138, _e1388, (_e1388 > _e138));
                                            let _e1425 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1326 & 2097151u))) - 8388608f) * _e1390));
                                            let _e1430 = (bitcast<i32>((_e1326 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1433 = bitcast<f32>((_e1425 & bitcast<u32>(_e1430)));
                                            let _e1434 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1341 & 2097151u))) - 8388608f) * _e1392));
                                            let _e1439 = (bitcast<i32>((_e1341 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1442 = bitcast<f32>((_e1434 & bitcast<u32>(_e1439)));
                                            let _e1443 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1356 & 2097151u))) - 8388608f) * _e1394));
                                            let _e1448 = (bitcast<i32>((_e1356 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1451 = bitcast<f32>((_e1443 & bitcast<u32>(_e1448)));
                                            let _e1455 = bitcast<f32>((_e1425 & bitcast<u32>(~(_e1430))));
                                            let _e1459 = bitcast<f32>((_e1434 & bitcast<u32>(~(_e1439))));
                                            let _e1463 = bitcast<f32>((_e1443 & bitcast<u32>(~(_e1448))));
                                            let _e1464 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1333 & 2097151u))) - 8388608f) * _e1390));
                                            let _e1469 = (bitcast<i32>((_e1333 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1472 = bitcast<f32>((_e1464 & bitcast<u32>(_e1469)));
                                            let _e1473 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1348 & 2097151u))) - 8388608f) * _e1392));
                                            let _e1478 = (bitcast<i32>((_e1348 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1481 = bitcast<f32>((_e1473 & bitcast<u32>(_e1478)));
                                            let _e1482 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1363 & 2097151u))) - 8388608f) * _e1394));
                                            let _e1487 = (bitcast<i32>((_e1363 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1490 = bitcast<f32>((_e1482 & bitcast<u32>(_e1487)));
                                            let _e1494 = bitcast<f32>((_e1464 & bitcast<u32>(~(_e1469))));
                                            let _e1498 = bitcast<f32>((_e1473 & bitcast<u32>(~(_e1478))));
                                            let _e1502 = bitcast<f32>((_e1482 & bitcast<u32>(~(_e1487))));
                                            let _e1532 = global_5.member[_e702.member_1][0u];
                                            let _e1536 = global_5.member[_e702.member_1][2u];
                                            let _e1540 = global_5.member[_e702.member_1][4u];
                                            let _e1544 = global_5.member[_e702.member_1][6u];
                                            let _e1556 = (((_e1536 >> bitcast<u32>(22i)) | ((_e1540 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1544 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1557 = (_e1532 & 268435455u);
                                            let _e1558 = (_e1556 & 268435455u);
                                            let _e1561 = ((_e1532 >> bitcast<u32>(28u)) & 7u);
                                            let _e1569 = ((_e1532 >> bitcast<u32>(31i)) | (((_e1556 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1570 = (_e1561 != 0u);
                                            if (_e1561 == 0u) {
                                                phi_3012_ = _e1557;
                                            } else {
                                                if (_e1561 == 7u) {
                                                    phi_3011_ = 2147483648u;
                                                } else {
                                                    phi_3011_ = ((2147483648u | (_e1561 << bitcast<u32>(28u))) | (_e1558 & 268435455u));
                                                }
                                                let _e1579 = phi_3011_;
                                                phi_3012_ = _e1579;
                                            }
                                            let _e1581 = phi_3012_;
                                            if _e1570 {
                                                let _e1582 = (_e1561 != 7u);
                                                if _e1582 {
                                                    phi_3022_ = (_e1558 + _e1561);
                                                } else {
                                                    phi_3022_ = u32();
                                                }
                                                let _e1585 = phi_3022_;
                                                phi_3024_ = _e1585;
                                                phi_3025_ = select(true, false, _e1582);
                                            } else {
                                                phi_3024_ = u32();
                                                phi_3025_ = true;
                                            }
                                            let _e1588 = phi_3024_;
                                            let _e1590 = phi_3025_;
                                            if (_e1569 == 0u) {
                                                phi_3046_ = (_e1557 + select(0u, 1u, !(_e1570)));
                                            } else {
                                                if (_e1569 == 7u) {
                                                    phi_3045_ = 2147483648u;
                                                } else {
                                                    phi_3045_ = ((2147483648u | (_e1569 << bitcast<u32>(28u))) | (select(_e1588, _e1558, _e1590) & 268435455u));
                                                }
                                                let _e1603 = phi_3045_;
                                                phi_3046_ = _e1603;
                                            }
                                            let _e1605 = phi_3046_;
                                            phi_3050_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e702.member.member.x + _e1433), (_e702.member.member.x + _e1455), (_e702.member.member_1.x - _e1472), (_e702.member.member_1.x - _e1494)), vec4<f32>((_e702.member.member.y + _e1442), (_e702.member.member.y + _e1459), (_e702.member.member_1.y - _e1481), (_e702.member.member_1.y - _e1498)), vec4<f32>((_e702.member.member.z + _e1451), (_e702.member.member.z + _e1463), (_e702.member.member_1.z - _e1490), (_e702.member.member_1.z - _e1502))), type_51(type_29((_e702.member.member + vec4<f32>(_e1433, _e1442, _e1451, 0f)), (_e702.member.member_1 - vec4<f32>(_e1472, _e1481, _e1490, 0f))), _e1581), type_51(type_29((_e702.member.member + vec4<f32>(_e1455, _e1459, _e1463, 0f)), (_e702.member.member_1 - vec4<f32>(_e1494, _e1498, _e1502, 0f))), _e1605));
                                        }
                                        let _e1610 = phi_3050_;
                                        let _e1629 = ((_e1610.member[0].x - _e360) * _e365);
                                        let _e1630 = ((_e1610.member[0].y - _e360) * _e365);
                                        let _e1631 = ((_e1610.member[0].z - _e361) * _e365);
                                        let _e1632 = ((_e1610.member[0].w - _e361) * _e365);
                                        let _e1642 = ((_e1610.member[1].x - _e428) * _e433);
                                        let _e1643 = ((_e1610.member[1].y - _e428) * _e433);
                                        let _e1644 = ((_e1610.member[1].z - _e429) * _e433);
                                        let _e1645 = ((_e1610.member[1].w - _e429) * _e433);
                                        let _e1655 = ((_e1610.member[2].x - _e496) * _e501);
                                        let _e1656 = ((_e1610.member[2].y - _e496) * _e501);
                                        let _e1657 = ((_e1610.member[2].z - _e497) * _e501);
                                        let _e1658 = ((_e1610.member[2].w - _e497) * _e501);
                                        let _e1660 = select(_e1657, _e1655, (_e1655 < _e1657));
                                        let _e1662 = select(_e1658, _e1656, (_e1656 < _e1658));
                                        let _e1664 = select(_e1657, _e1655, (_e1655 > _e1657));
                                        let _e1666 = select(_e1658, _e1656, (_e1656 > _e1658));
                                        let _e1668 = select(_e1631, _e1629, (_e1629 < _e1631));
                                        let _e1670 = select(_e1632, _e1630, (_e1630 < _e1632));
                                        let _e1672 = select(_e1644, _e1642, (_e1642 < _e1644));
                                        let _e1674 = select(_e1645, _e1643, (_e1643 < _e1645));
                                        let _e1676 = select(_e1672, _e1668, (_e1668 > _e1672));
                                        let _e1678 = select(_e1674, _e1670, (_e1670 > _e1674));
                                        let _e1680 = select(_e1660, _e1676, (_e1676 > _e1660));
                                        let _e1682 = select(_e1662, _e1678, (_e1678 > _e1662));
                                        let _e1684 = select(_e1631, _e1629, (_e1629 > _e1631));
                                        let _e1686 = select(_e1632, _e1630, (_e1630 > _e1632));
                                        let _e1688 = select(_e1644, _e1642, (_e1642 > _e1644));
                                        let _e1690 = select(_e1645, _e1643, (_e1643 > _e1645));
                                        let _e1692 = select(_e1688, _e1684, (_e1684 < _e1688));
                                        let _e1694 = select(_e1690, _e1686, (_e1686 < _e1690));
                                        let _e1699 = -(_e1660);
                                        let _e1700 = -(_e1662);
                                        let _e1707 = (select(_e1664, _e1692, (_e1692 < _e1664)) + (select(_e1699, _e1664, (_e1664 > _e1699)) * 0.0000019073523f));
                                        let _e1708 = (select(_e1666, _e1694, (_e1694 < _e1666)) + (select(_e1700, _e1666, (_e1666 > _e1700)) * 0.0000019073523f));
                                        let _e1710 = select(_e613, _e1680, (_e1680 > _e613));
                                        let _e1712 = select(_e613, _e1682, (_e1682 > _e613));
                                        let _e1717 = (_e1710 <= select(_e1316.member.member_1, _e1707, (_e1707 < _e1316.member.member_1)));
                                        let _e1718 = (_e1712 <= select(_e1316.member.member_1, _e1708, (_e1708 < _e1316.member.member_1)));
                                        let _e1719 = (_e1710 <= _e1712);
                                        if _e1717 {
                                            if _e1718 {
                                                if _e1719 {
                                                    phi_3415_ = _e1610.member_2;
                                                } else {
                                                    phi_3415_ = _e1610.member_1;
                                                }
                                                let _e1723 = phi_3415_;
                                                let _e1744 = (_e700 % 128u);
                                                let _e1745 = (_e1744 < 128u);
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_8[_e1744] = _e1723.member_1;
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_7[_e1744] = _e1723.member.member.x;
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_6[_e1744] = _e1723.member.member.y;
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_5[_e1744] = _e1723.member.member.z;
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_4[_e1744] = _e1723.member.member_1.x;
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_3[_e1744] = _e1723.member.member_1.y;
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_2[_e1744] = _e1723.member.member_1.z;
                                                if _e1745 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_9[_e1744] = select(_e1710, _e1712, _e1719);
                                                if _e1719 {
                                                    phi_3491_ = _e1610.member_1;
                                                } else {
                                                    phi_3491_ = _e1610.member_2;
                                                }
                                                let _e1758 = phi_3491_;
                                                phi_3492_ = (_e700 + 1u);
                                                phi_3493_ = _e1758;
                                            } else {
                                                phi_3492_ = u32();
                                                phi_3493_ = type_51();
                                            }
                                            let _e1760 = phi_3492_;
                                            let _e1762 = phi_3493_;
                                            phi_3495_ = _e1760;
                                            phi_3496_ = _e1762;
                                            phi_3497_ = select(true, false, _e1718);
                                        } else {
                                            phi_3495_ = u32();
                                            phi_3496_ = type_51();
                                            phi_3497_ = true;
                                        }
                                        let _e1765 = phi_3495_;
                                        let _e1767 = phi_3496_;
                                        let _e1769 = phi_3497_;
                                        if _e1769 {
                                            if _e1717 {
                                                phi_3506_ = _e1610.member_1;
                                            } else {
                                                phi_3506_ = _e1610.member_2;
                                            }
                                            let _e1773 = phi_3506_;
                                            phi_3511_ = select(_e1718, true, _e1717);
                                            phi_3513_ = _e1773;
                                        } else {
                                            phi_3511_ = _e698;
                                            phi_3513_ = _e1767;
                                        }
                                        let _e1776 = phi_3511_;
                                        let _e1778 = phi_3513_;
                                        phi_3518_ = type_40(_e1316.member, (_e1316.member_1 + 1u), _e1316.member_2);
                                        phi_3519_ = _e1776;
                                        phi_3520_ = select(_e1765, _e700, _e1769);
                                        phi_3521_ = _e1778;
                                    }
                                    let _e1781 = phi_3518_;
                                    let _e1783 = phi_3519_;
                                    let _e1785 = phi_3520_;
                                    let _e1787 = phi_3521_;
                                    if _e706 {
                                        phi_3529_ = _e1316;
                                        phi_3532_ = _e702;
                                    } else {
                                        phi_3529_ = _e1781;
                                        phi_3532_ = _e1787;
                                    }
                                    let _e1789 = phi_3529_;
                                    let _e1791 = phi_3532_;
                                    phi_3920_ = _e1314;
                                    phi_3533_ = _e1789;
                                    phi_3534_ = (_e660 - 1u);
                                    phi_3535_ = select(_e1783, false, _e706);
                                    phi_3536_ = select(_e1785, _e700, _e706);
                                    phi_3537_ = _e1791;
                                } else {
                                    phi_3920_ = _e656;
                                    phi_3533_ = _e658;
                                    phi_3534_ = _e660;
                                    phi_3535_ = _e698;
                                    phi_3536_ = _e700;
                                    phi_3537_ = _e702;
                                }
                                let _e1795 = phi_3920_;
                                let _e1797 = phi_3533_;
                                let _e1799 = phi_3534_;
                                let _e1801 = phi_3535_;
                                let _e1803 = phi_3536_;
                                let _e1805 = phi_3537_;
                                phi_3919_ = _e1795;
                                phi_3538_ = _e1797;
                                phi_3539_ = _e1799;
                                phi_3540_ = _e1801;
                                phi_3541_ = _e1803;
                                phi_3542_ = _e1805;
                            } else {
                                phi_3919_ = _e656;
                                phi_3538_ = type_40();
                                phi_3539_ = u32();
                                phi_3540_ = bool();
                                phi_3541_ = u32();
                                phi_3542_ = type_51();
                            }
                            let _e1807 = phi_3919_;
                            let _e1809 = phi_3538_;
                            let _e1811 = phi_3539_;
                            let _e1813 = phi_3540_;
                            let _e1815 = phi_3541_;
                            let _e1817 = phi_3542_;
                            phi_3918_ = _e1807;
                            phi_1082_ = _e1809;
                            phi_1085_ = _e1811;
                            phi_1087_ = _e1813;
                            phi_1089_ = _e1815;
                            phi_1091_ = _e1817;
                            phi_3543_ = _e670;
                        } else {
                            phi_3918_ = _e656;
                            phi_1082_ = type_40();
                            phi_1085_ = u32();
                            phi_1087_ = bool();
                            phi_1089_ = u32();
                            phi_1091_ = type_51();
                            phi_3543_ = false;
                        }
                        let _e1819 = phi_3918_;
                        let _e1821 = phi_1082_;
                        let _e1823 = phi_1085_;
                        let _e1825 = phi_1087_;
                        let _e1827 = phi_1089_;
                        let _e1829 = phi_1091_;
                        let _e1831 = phi_3543_;
                        continue;
                        continuing {
                            phi_3763_ = _e1819;
                            phi_1081_ = _e1821;
                            phi_1084_ = _e1823;
                            phi_1086_ = _e1825;
                            phi_1088_ = _e1827;
                            phi_1090_ = _e1829;
                            phi_3917_ = _e1819;
                            break if !(_e1831);
                        }
                    }
                    let _e1834 = phi_3917_;
                    if _e1834 {
                        break;
                    }
                    let _e1836 = local_10;
                    let _e1839 = local_11;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_6.member[_e144][0u] = _e1836.member_1;
                    global_6.member[_e144][1u] = _e1839.member_2;
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
