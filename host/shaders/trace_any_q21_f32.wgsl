struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
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

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_44;

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
    var phi_373_: i32;
    var phi_374_: i32;
    var phi_384_: bool;
    var phi_394_: u32;
    var phi_395_: u32;
    var phi_397_: bool;
    var phi_402_: u32;
    var phi_415_: i32;
    var phi_435_: i32;
    var phi_453_: f32;
    var phi_459_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_557_: f32;
    var phi_569_: f32;
    var phi_578_: f32;
    var phi_584_: f32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_682_: f32;
    var phi_694_: f32;
    var phi_703_: f32;
    var phi_709_: f32;
    var phi_749_: f32;
    var phi_755_: f32;
    var phi_807_: f32;
    var phi_819_: f32;
    var phi_874_: i32;
    var phi_896_: u32;
    var phi_897_: u32;
    var phi_934_: i32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_965_: f32;
    var phi_966_: f32;
    var phi_3724_: bool;
    var phi_1062_: type_38;
    var phi_1065_: bool;
    var phi_1067_: u32;
    var phi_1069_: u32;
    var phi_1071_: type_49;
    var phi_1082_: bool;
    var phi_1168_: bool;
    var phi_1169_: u32;
    var phi_1170_: type_49;
    var phi_2972_: u32;
    var phi_2973_: u32;
    var phi_2983_: u32;
    var phi_2985_: u32;
    var phi_2986_: bool;
    var phi_3006_: u32;
    var phi_3007_: u32;
    var phi_3011_: type_50;
    var phi_3373_: type_49;
    var phi_3450_: type_49;
    var phi_3451_: u32;
    var phi_3452_: type_49;
    var phi_3454_: u32;
    var phi_3455_: type_49;
    var phi_3456_: bool;
    var phi_3465_: type_49;
    var phi_3470_: bool;
    var phi_3472_: type_49;
    var phi_1188_: type_38;
    var phi_1191_: type_7;
    var phi_1192_: type_7;
    var phi_1214_: type_7;
    var phi_1235_: u32;
    var phi_1327_: array<array<f32, 3>, 3>;
    var phi_1479_: bool;
    var phi_1508_: bool;
    var phi_1927_: f32;
    var phi_1928_: f32;
    var phi_1929_: f32;
    var phi_1930_: f32;
    var phi_1931_: vec3<f32>;
    var phi_1932_: vec3<f32>;
    var phi_1933_: vec3<f32>;
    var phi_1934_: vec3<f32>;
    var phi_1971_: bool;
    var phi_1980_: vec3<f32>;
    var phi_2145_: f32;
    var phi_2147_: f32;
    var phi_2148_: bool;
    var phi_2168_: f32;
    var phi_2169_: f32;
    var phi_2192_: type_24;
    var phi_2194_: type_24;
    var phi_2195_: bool;
    var phi_2199_: type_24;
    var phi_2200_: type_24;
    var phi_2201_: type_24;
    var phi_2202_: bool;
    var phi_2206_: type_24;
    var phi_2207_: bool;
    var phi_2208_: type_24;
    var phi_2209_: bool;
    var phi_2210_: bool;
    var phi_2211_: type_24;
    var phi_2212_: bool;
    var phi_2213_: bool;
    var phi_2221_: type_24;
    var phi_2222_: bool;
    var phi_2226_: type_24;
    var phi_2237_: type_38;
    var phi_2238_: type_38;
    var phi_1189_: type_38;
    var phi_3718_: bool;
    var local_10: type_38;
    var phi_3879_: bool;
    var phi_3476_: type_38;
    var phi_3477_: bool;
    var phi_3478_: u32;
    var phi_3479_: type_49;
    var phi_3878_: bool;
    var phi_3480_: type_38;
    var phi_3481_: bool;
    var phi_3482_: u32;
    var phi_3483_: u32;
    var phi_3484_: type_49;
    var phi_3877_: bool;
    var phi_3485_: type_38;
    var phi_3486_: bool;
    var phi_3487_: u32;
    var phi_3488_: u32;
    var phi_3489_: type_49;
    var phi_3876_: bool;
    var phi_1063_: type_38;
    var phi_1066_: bool;
    var phi_1068_: u32;
    var phi_1070_: u32;
    var phi_1072_: type_49;
    var phi_3490_: bool;
    var phi_3875_: bool;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_6.member));
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
                let _e146 = (_e144 < arrayLength((&global_5.member)));
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
                            phi_373_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_373_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_373_;
                        phi_374_ = _e237;
                    } else {
                        phi_374_ = 0i;
                    }
                    let _e239 = phi_374_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_384_ = true;
                    } else {
                        phi_384_ = (_e163 == _e195);
                    }
                    let _e243 = phi_384_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_394_ = _e245;
                        phi_395_ = _e245;
                        phi_397_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_394_ = u32();
                        phi_395_ = 0u;
                        phi_397_ = true;
                    }
                    let _e249 = phi_394_;
                    let _e251 = phi_395_;
                    let _e253 = phi_397_;
                    if _e253 {
                        phi_402_ = (_e251 + 1u);
                    } else {
                        phi_402_ = 0u;
                    }
                    let _e257 = phi_402_;
                    let _e258 = select(_e249, _e251, _e253);
                    let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                    if (_e126 < -126i) {
                        phi_415_ = -126i;
                    } else {
                        phi_415_ = select(_e126, 127i, (_e126 > 127i));
                    }
                    let _e264 = phi_415_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e126 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = -(_e239);
                    if (_e276 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e276, 127i, (_e276 > 127i));
                    }
                    let _e281 = phi_435_;
                    let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                    let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                    let _e296 = global_4.member[_e144].member;
                    let _e297 = (_e258 == 0u);
                    if _e297 {
                        phi_453_ = _e296[0];
                    } else {
                        phi_453_ = _e296[1];
                    }
                    let _e301 = phi_453_;
                    let _e302 = (_e258 == 2u);
                    if _e302 {
                        phi_459_ = _e296[2];
                    } else {
                        phi_459_ = _e301;
                    }
                    let _e305 = phi_459_;
                    let _e306 = bitcast<u32>(_e305);
                    let _e308 = ((_e306 & 2139095040u) != 0u);
                    let _e322 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e306 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e306 & 2147483648u))), _e305, _e308) * _e269) * select(0.00000011920929f, 1f, _e308)) * _e275);
                    let _e323 = global_4.member[_e144].member_2;
                    if _e297 {
                        phi_499_ = _e323[0];
                    } else {
                        phi_499_ = _e323[1];
                    }
                    let _e327 = phi_499_;
                    if _e302 {
                        phi_505_ = _e323[2];
                    } else {
                        phi_505_ = _e327;
                    }
                    let _e330 = phi_505_;
                    let _e331 = bitcast<u32>(_e330);
                    let _e333 = ((_e331 & 2139095040u) != 0u);
                    let _e347 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e331 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e331 & 2147483648u))), _e330, _e333) * _e286) * select(0.00000011920929f, 1f, _e333)) * _e292);
                    let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e351 {
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) * 0.00000011920929f);
                        phi_557_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                    } else {
                        phi_557_ = 0f;
                    }
                    let _e359 = phi_557_;
                    let _e360 = (_e322 + _e359);
                    let _e361 = (_e322 - _e359);
                    let _e362 = select(_e347, 0f, _e351);
                    if _e351 {
                        phi_569_ = 38685626000000000000000000f;
                    } else {
                        phi_569_ = (1f / _e347);
                    }
                    let _e365 = phi_569_;
                    let _e366 = (_e257 == 0u);
                    if _e366 {
                        phi_578_ = _e296[0];
                    } else {
                        phi_578_ = _e296[1];
                    }
                    let _e370 = phi_578_;
                    let _e371 = (_e257 == 2u);
                    if _e371 {
                        phi_584_ = _e296[2];
                    } else {
                        phi_584_ = _e370;
                    }
                    let _e374 = phi_584_;
                    let _e375 = bitcast<u32>(_e374);
                    let _e377 = ((_e375 & 2139095040u) != 0u);
                    let _e391 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e375 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e375 & 2147483648u))), _e374, _e377) * _e269) * select(0.00000011920929f, 1f, _e377)) * _e275);
                    if _e366 {
                        phi_624_ = _e323[0];
                    } else {
                        phi_624_ = _e323[1];
                    }
                    let _e395 = phi_624_;
                    if _e371 {
                        phi_630_ = _e323[2];
                    } else {
                        phi_630_ = _e395;
                    }
                    let _e398 = phi_630_;
                    let _e399 = bitcast<u32>(_e398);
                    let _e401 = ((_e399 & 2139095040u) != 0u);
                    let _e415 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e399 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e399 & 2147483648u))), _e398, _e401) * _e286) * select(0.00000011920929f, 1f, _e401)) * _e292);
                    let _e419 = (bitcast<f32>((bitcast<u32>(_e415) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e419 {
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) * 0.00000011920929f);
                        phi_682_ = select(0.00000000000011368684f, _e423, (_e423 > 0.00000000000011368684f));
                    } else {
                        phi_682_ = 0f;
                    }
                    let _e427 = phi_682_;
                    let _e428 = (_e391 + _e427);
                    let _e429 = (_e391 - _e427);
                    let _e430 = select(_e415, 0f, _e419);
                    if _e419 {
                        phi_694_ = 38685626000000000000000000f;
                    } else {
                        phi_694_ = (1f / _e415);
                    }
                    let _e433 = phi_694_;
                    let _e434 = (_e259 == 0u);
                    if _e434 {
                        phi_703_ = _e296[0];
                    } else {
                        phi_703_ = _e296[1];
                    }
                    let _e438 = phi_703_;
                    let _e439 = (_e259 == 2u);
                    if _e439 {
                        phi_709_ = _e296[2];
                    } else {
                        phi_709_ = _e438;
                    }
                    let _e442 = phi_709_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e459 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * _e269) * select(0.00000011920929f, 1f, _e445)) * _e275);
                    if _e434 {
                        phi_749_ = _e323[0];
                    } else {
                        phi_749_ = _e323[1];
                    }
                    let _e463 = phi_749_;
                    if _e439 {
                        phi_755_ = _e323[2];
                    } else {
                        phi_755_ = _e463;
                    }
                    let _e466 = phi_755_;
                    let _e467 = bitcast<u32>(_e466);
                    let _e469 = ((_e467 & 2139095040u) != 0u);
                    let _e483 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e467 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e467 & 2147483648u))), _e466, _e469) * _e286) * select(0.00000011920929f, 1f, _e469)) * _e292);
                    let _e487 = (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e487 {
                        let _e491 = (bitcast<f32>((bitcast<u32>(_e459) & 2147483647u)) * 0.00000011920929f);
                        phi_807_ = select(0.00000000000011368684f, _e491, (_e491 > 0.00000000000011368684f));
                    } else {
                        phi_807_ = 0f;
                    }
                    let _e495 = phi_807_;
                    let _e496 = (_e459 + _e495);
                    let _e497 = (_e459 - _e495);
                    let _e498 = select(_e483, 0f, _e487);
                    if _e487 {
                        phi_819_ = 38685626000000000000000000f;
                    } else {
                        phi_819_ = (1f / _e483);
                    }
                    let _e501 = phi_819_;
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
                            phi_874_ = 255i;
                        } else {
                            phi_874_ = (((_e528 + select(0i, 1i, (_e528 == 0i))) - _e535) + _e515);
                        }
                        let _e543 = phi_874_;
                        let _e553 = (_e543 <= 0i);
                        if _e553 {
                            phi_897_ = u32();
                        } else {
                            if _e532 {
                                phi_896_ = u32();
                            } else {
                                phi_896_ = select(((bitcast<u32>(_e543) << bitcast<u32>(23i)) | ((_e525 << bitcast<u32>(((_e535 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e543 >= 255i));
                            }
                            let _e557 = phi_896_;
                            phi_897_ = _e557;
                        }
                        let _e559 = phi_897_;
                        let _e571 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e574 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e578 = (_e571 == 0u);
                        let _e581 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e571)), 32u, _e578)) - 8i);
                        if (_e574 == 255i) {
                            phi_934_ = 255i;
                        } else {
                            phi_934_ = (((_e574 + select(0i, 1i, (_e574 == 0i))) - _e581) + _e515);
                        }
                        let _e589 = phi_934_;
                        let _e599 = (_e589 <= 0i);
                        if _e599 {
                            phi_957_ = u32();
                        } else {
                            if _e578 {
                                phi_956_ = u32();
                            } else {
                                phi_956_ = select(((bitcast<u32>(_e589) << bitcast<u32>(23i)) | ((_e571 << bitcast<u32>(((_e581 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e589 >= 255i));
                            }
                            let _e603 = phi_956_;
                            phi_957_ = _e603;
                        }
                        let _e605 = phi_957_;
                        phi_965_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e605, 0u, select(_e578, true, _e599))));
                        phi_966_ = bitcast<f32>(((_e206 & 2147483648u) | select(_e559, 0u, select(_e532, true, _e553))));
                    } else {
                        phi_965_ = 0f;
                        phi_966_ = 1f;
                    }
                    let _e611 = phi_965_;
                    let _e613 = phi_966_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e617 = (_e258 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    let _e623 = (_e257 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    let _e629 = (_e259 % 3u);
                    let _e630 = (_e629 < 3u);
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e632 = local_1[_e629];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e637 = local[_e617];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e641 = local[_e623];
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e645 = local[_e629];
                    phi_3724_ = false;
                    phi_1062_ = type_38(_e611, false);
                    phi_1065_ = (_e613 <= _e611);
                    phi_1067_ = ((3u * _e88) + 1u);
                    phi_1069_ = 0u;
                    phi_1071_ = type_49(type_28(vec4<f32>((f32(_e620) * _e138), (f32(_e626) * _e138), (f32(_e632) * _e138), 0f), vec4<f32>((f32(_e637) * _e138), (f32(_e641) * _e138), (f32(_e645) * _e138), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    loop {
                        let _e655 = phi_3724_;
                        let _e657 = phi_1062_;
                        let _e659 = phi_1065_;
                        let _e661 = phi_1067_;
                        let _e663 = phi_1069_;
                        let _e665 = phi_1071_;
                        local_11 = _e657;
                        if _e659 {
                            phi_1082_ = true;
                        } else {
                            phi_1082_ = (_e663 > 0u);
                        }
                        let _e668 = phi_1082_;
                        if _e668 {
                            let _e669 = (_e661 > 0u);
                            if _e669 {
                                if _e659 {
                                    phi_1168_ = _e659;
                                    phi_1169_ = _e663;
                                    phi_1170_ = _e665;
                                } else {
                                    let _e670 = (_e663 - 1u);
                                    let _e671 = (_e670 % 128u);
                                    let _e672 = (_e671 < 128u);
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e674 = local_7[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e676 = local_6[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e678 = local_5[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e680 = local_4[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e682 = local_3[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e684 = local_2[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e689 = local_8[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e692 = local_9[_e671];
                                    phi_1168_ = (_e692 <= _e657.member);
                                    phi_1169_ = _e670;
                                    phi_1170_ = type_49(type_28(vec4<f32>(_e674, _e676, _e678, 0f), vec4<f32>(_e680, _e682, _e684, 0f)), _e689);
                                }
                                let _e696 = phi_1168_;
                                let _e698 = phi_1169_;
                                let _e700 = phi_1170_;
                                if _e696 {
                                    if ((_e700.member_1 & 2147483648u) != 0u) {
                                        phi_1188_ = _e657;
                                        phi_1191_ = type_7(0u, ((_e700.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1168 = phi_1188_;
                                            let _e1170 = phi_1191_;
                                            local_10 = _e1168;
                                            local_12 = _e1168;
                                            if (_e1170.member < _e1170.member_1) {
                                                phi_1192_ = type_7((_e1170.member + 1u), _e1170.member_1);
                                                phi_1214_ = type_7(1u, _e1170.member);
                                            } else {
                                                phi_1192_ = _e1170;
                                                phi_1214_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1183 = phi_1192_;
                                            let _e1185 = phi_1214_;
                                            let _e1189 = (bitcast<i32>(_e1185.member) != 0i);
                                            if _e1189 {
                                                let _e1190 = ((_e700.member_1 & 268435455u) + _e1185.member_1);
                                                let _e1191 = (_e1190 < _e90);
                                                if _e1191 {
                                                    if _e1191 {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1195 = global_2.member[_e1190].member_1;
                                                    phi_1235_ = _e1195;
                                                } else {
                                                    phi_1235_ = 4294967295u;
                                                }
                                                let _e1197 = phi_1235_;
                                                if (_e1190 >= _e90) {
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1191 {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1204 = global_2.member[_e1190].member[_e617];
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1210 = global_2.member[_e1190].member[_e623];
                                                    if (_e629 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1216 = global_2.member[_e1190].member[_e629];
                                                    let _e1218 = (3u + _e617);
                                                    if (_e1218 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1224 = global_2.member[_e1190].member[_e1218];
                                                    let _e1225 = (3u + _e623);
                                                    if (_e1225 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1231 = global_2.member[_e1190].member[_e1225];
                                                    let _e1232 = (3u + _e629);
                                                    if (_e1232 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1238 = global_2.member[_e1190].member[_e1232];
                                                    let _e1240 = (6u + _e617);
                                                    if (_e1240 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1246 = global_2.member[_e1190].member[_e1240];
                                                    let _e1247 = (6u + _e623);
                                                    if (_e1247 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1253 = global_2.member[_e1190].member[_e1247];
                                                    let _e1254 = (6u + _e629);
                                                    if (_e1254 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1260 = global_2.member[_e1190].member[_e1254];
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1204, _e1210, _e1216), array<f32, 3>(_e1224, _e1231, _e1238), array<f32, 3>(_e1246, _e1253, _e1260));
                                                }
                                                let _e1264 = phi_1327_;
                                                let _e1272 = (_e1264[0][2] - _e459);
                                                let _e1275 = (((_e1264[0][0] - _e322) * _e498) - (_e1272 * _e362));
                                                let _e1278 = (((_e1264[0][1] - _e391) * _e498) - (_e1272 * _e430));
                                                let _e1285 = (_e1264[1][2] - _e459);
                                                let _e1288 = (((_e1264[1][0] - _e322) * _e498) - (_e1285 * _e362));
                                                let _e1291 = (((_e1264[1][1] - _e391) * _e498) - (_e1285 * _e430));
                                                let _e1298 = (_e1264[2][2] - _e459);
                                                let _e1301 = (((_e1264[2][0] - _e322) * _e498) - (_e1298 * _e362));
                                                let _e1304 = (((_e1264[2][1] - _e391) * _e498) - (_e1298 * _e430));
                                                let _e1305 = (_e1301 * _e1291);
                                                let _e1306 = (_e1304 * _e1288);
                                                let _e1307 = (_e1275 * _e1304);
                                                let _e1308 = (_e1278 * _e1301);
                                                let _e1309 = (_e1288 * _e1278);
                                                let _e1310 = (_e1291 * _e1275);
                                                let _e1315 = (((_e1305 >= _e1306) && (_e1307 >= _e1308)) && (_e1309 >= _e1310));
                                                if (_e1315 || (((_e1305 <= _e1306) && (_e1307 <= _e1308)) && (_e1309 <= _e1310))) {
                                                    let _e1322 = select(-1f, 1f, _e1315);
                                                    let _e1324 = ((_e1305 - _e1306) * _e1322);
                                                    let _e1326 = select(0f, _e1324, (_e1324 > 0f));
                                                    let _e1328 = ((_e1307 - _e1308) * _e1322);
                                                    let _e1330 = select(0f, _e1328, (_e1328 > 0f));
                                                    let _e1332 = ((_e1309 - _e1310) * _e1322);
                                                    let _e1334 = select(0f, _e1332, (_e1332 > 0f));
                                                    let _e1336 = ((_e1326 + _e1330) + _e1334);
                                                    if (_e1336 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2211_ = type_24();
                                                        phi_2212_ = true;
                                                        phi_2213_ = false;
                                                    } else {
                                                        let _e1339 = select(_e1288, _e1275, (_e1275 < _e1288));
                                                        if (select(_e1301, _e1339, (_e1339 < _e1301)) > 0f) {
                                                            phi_1479_ = true;
                                                        } else {
                                                            let _e1344 = select(_e1288, _e1275, (_e1275 > _e1288));
                                                            phi_1479_ = (select(_e1301, _e1344, (_e1344 > _e1301)) < 0f);
                                                        }
                                                        let _e1349 = phi_1479_;
                                                        if _e1349 {
                                                            phi_2208_ = type_24();
                                                            phi_2209_ = true;
                                                            phi_2210_ = false;
                                                        } else {
                                                            let _e1351 = select(_e1291, _e1278, (_e1278 < _e1291));
                                                            if (select(_e1304, _e1351, (_e1351 < _e1304)) > 0f) {
                                                                phi_1508_ = true;
                                                            } else {
                                                                let _e1356 = select(_e1291, _e1278, (_e1278 > _e1291));
                                                                phi_1508_ = (select(_e1304, _e1356, (_e1356 > _e1304)) < 0f);
                                                            }
                                                            let _e1361 = phi_1508_;
                                                            if _e1361 {
                                                                phi_2206_ = type_24();
                                                                phi_2207_ = false;
                                                            } else {
                                                                let _e1363 = select(_e1264[1][0], _e1264[0][0], (_e1264[0][0] < _e1264[1][0]));
                                                                let _e1367 = select(_e1264[1][0], _e1264[0][0], (_e1264[0][0] > _e1264[1][0]));
                                                                let _e1371 = select(_e1264[1][1], _e1264[0][1], (_e1264[0][1] < _e1264[1][1]));
                                                                let _e1375 = select(_e1264[1][1], _e1264[0][1], (_e1264[0][1] > _e1264[1][1]));
                                                                let _e1379 = select(_e1264[1][2], _e1264[0][2], (_e1264[0][2] < _e1264[1][2]));
                                                                let _e1383 = select(_e1264[1][2], _e1264[0][2], (_e1264[0][2] > _e1264[1][2]));
                                                                let _e1388 = ((select(_e1264[2][0], _e1363, (_e1363 < _e1264[2][0])) - _e360) * _e365);
                                                                let _e1389 = ((select(_e1264[2][0], _e1367, (_e1367 > _e1264[2][0])) - _e361) * _e365);
                                                                let _e1392 = ((select(_e1264[2][1], _e1371, (_e1371 < _e1264[2][1])) - _e428) * _e433);
                                                                let _e1393 = ((select(_e1264[2][1], _e1375, (_e1375 > _e1264[2][1])) - _e429) * _e433);
                                                                let _e1396 = ((select(_e1264[2][2], _e1379, (_e1379 < _e1264[2][2])) - _e496) * _e501);
                                                                let _e1397 = ((select(_e1264[2][2], _e1383, (_e1383 > _e1264[2][2])) - _e497) * _e501);
                                                                let _e1399 = select(_e1397, _e1396, (_e1396 < _e1397));
                                                                let _e1401 = select(_e1397, _e1396, (_e1396 > _e1397));
                                                                let _e1403 = select(_e1389, _e1388, (_e1388 < _e1389));
                                                                let _e1405 = select(_e1393, _e1392, (_e1392 < _e1393));
                                                                let _e1407 = select(_e1405, _e1403, (_e1403 > _e1405));
                                                                let _e1409 = select(_e1399, _e1407, (_e1407 > _e1399));
                                                                let _e1411 = select(_e1389, _e1388, (_e1388 > _e1389));
                                                                let _e1413 = select(_e1393, _e1392, (_e1392 > _e1393));
                                                                let _e1415 = select(_e1413, _e1411, (_e1411 < _e1413));
                                                                let _e1417 = select(_e1401, _e1415, (_e1415 < _e1401));
                                                                let _e1418 = -(_e1399);
                                                                let _e1424 = select(_e613, _e1409, (_e1409 > _e613));
                                                                if (_e1424 > (_e1417 + (select(_e1418, _e1401, (_e1401 > _e1418)) * 0.0000019073523f))) {
                                                                    phi_2201_ = type_24();
                                                                    phi_2202_ = true;
                                                                } else {
                                                                    let _e1426 = (_e1424 > _e1168.member);
                                                                    if _e1426 {
                                                                        phi_2200_ = type_24();
                                                                    } else {
                                                                        let _e1427 = vec3<f32>(_e1264[0][0], _e1264[0][1], _e1264[0][2]);
                                                                        let _e1428 = vec3<f32>(_e1264[1][0], _e1264[1][1], _e1264[1][2]);
                                                                        let _e1429 = vec3<f32>(_e1264[2][0], _e1264[2][1], _e1264[2][2]);
                                                                        let _e1430 = (_e1264[1][0] - _e1264[0][0]);
                                                                        let _e1431 = (_e1264[1][1] - _e1264[0][1]);
                                                                        let _e1432 = (_e1264[1][2] - _e1264[0][2]);
                                                                        let _e1433 = vec3<f32>(_e1430, _e1431, _e1432);
                                                                        let _e1434 = (_e1264[2][0] - _e1264[1][0]);
                                                                        let _e1435 = (_e1264[2][1] - _e1264[1][1]);
                                                                        let _e1436 = (_e1264[2][2] - _e1264[1][2]);
                                                                        let _e1437 = vec3<f32>(_e1434, _e1435, _e1436);
                                                                        let _e1438 = (_e1264[0][0] - _e1264[2][0]);
                                                                        let _e1439 = (_e1264[0][1] - _e1264[2][1]);
                                                                        let _e1440 = (_e1264[0][2] - _e1264[2][2]);
                                                                        let _e1441 = vec3<f32>(_e1438, _e1439, _e1440);
                                                                        let _e1444 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                        let _e1447 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                        let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                                                        let _e1452 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                        let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                                        let _e1457 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                        let _e1460 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                        let _e1462 = select(_e1460, _e1457, (_e1457 > _e1460));
                                                                        let _e1465 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                        let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                        let _e1470 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                        let _e1473 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                        let _e1475 = select(_e1473, _e1470, (_e1470 > _e1473));
                                                                        let _e1478 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                                        let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                                        let _e1482 = select(_e1467, _e1454, (_e1454 > _e1467));
                                                                        let _e1484 = select(_e1480, _e1482, (_e1482 > _e1480));
                                                                        if (_e1454 == _e1484) {
                                                                            phi_1927_ = _e1291;
                                                                            phi_1928_ = _e1288;
                                                                            phi_1929_ = _e1278;
                                                                            phi_1930_ = _e1275;
                                                                            phi_1931_ = _e1427;
                                                                            phi_1932_ = _e1441;
                                                                            phi_1933_ = _e1437;
                                                                            phi_1934_ = _e1433;
                                                                        } else {
                                                                            let _e1486 = (_e1467 == _e1484);
                                                                            let _e1491 = vec3(_e1486);
                                                                            phi_1927_ = select(_e1278, _e1304, _e1486);
                                                                            phi_1928_ = select(_e1275, _e1301, _e1486);
                                                                            phi_1929_ = select(_e1304, _e1291, _e1486);
                                                                            phi_1930_ = select(_e1301, _e1288, _e1486);
                                                                            phi_1931_ = select(_e1429, _e1428, _e1491);
                                                                            phi_1932_ = select(_e1437, _e1433, _e1491);
                                                                            phi_1933_ = select(_e1433, _e1441, _e1491);
                                                                            phi_1934_ = select(_e1441, _e1437, _e1491);
                                                                        }
                                                                        let _e1497 = phi_1927_;
                                                                        let _e1499 = phi_1928_;
                                                                        let _e1501 = phi_1929_;
                                                                        let _e1503 = phi_1930_;
                                                                        let _e1505 = phi_1931_;
                                                                        let _e1507 = phi_1932_;
                                                                        let _e1509 = phi_1933_;
                                                                        let _e1511 = phi_1934_;
                                                                        let _e1518 = ((_e1509.y * _e1507.z) - (_e1507.y * _e1509.z));
                                                                        let _e1523 = ((_e1509.z * _e1507.x) - (_e1507.z * _e1509.x));
                                                                        let _e1526 = ((_e1509.x * _e1507.y) - (_e1507.x * _e1509.y));
                                                                        if (_e1326 >= _e1330) {
                                                                            phi_1971_ = select(true, false, (_e1326 >= _e1334));
                                                                        } else {
                                                                            phi_1971_ = true;
                                                                        }
                                                                        let _e1531 = phi_1971_;
                                                                        if _e1531 {
                                                                            phi_1980_ = select(_e1429, _e1428, vec3((_e1330 >= _e1334)));
                                                                        } else {
                                                                            phi_1980_ = _e1427;
                                                                        }
                                                                        let _e1536 = phi_1980_;
                                                                        let _e1547 = (((_e1518 * (_e1536.x - _e322)) + (_e1523 * (_e1536.y - _e391))) + (_e1526 * (_e1536.z - _e459)));
                                                                        let _e1552 = (((_e1518 * _e362) + (_e1523 * _e430)) + (_e1526 * _e498));
                                                                        let _e1553 = (_e1499 - _e1503);
                                                                        let _e1554 = (_e1497 - _e1501);
                                                                        let _e1562 = (-(((_e1503 * _e1553) + (_e1501 * _e1554))) / ((_e1553 * _e1553) + (_e1554 * _e1554)));
                                                                        let _e1564 = select(1f, _e1562, (_e1562 < 1f));
                                                                        let _e1566 = select(0f, _e1564, (_e1564 > 0f));
                                                                        let _e1579 = ((_e1505.x + (_e1511.x * _e1566)) - _e322);
                                                                        let _e1580 = ((_e1505.y + (_e1511.y * _e1566)) - _e391);
                                                                        let _e1581 = ((_e1505.z + (_e1511.z * _e1566)) - _e459);
                                                                        let _e1582 = (_e1581 / _e498);
                                                                        let _e1594 = bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u));
                                                                        let _e1597 = bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u));
                                                                        let _e1599 = select(_e1597, _e1594, (_e1594 > _e1597));
                                                                        let _e1602 = bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u));
                                                                        let _e1604 = select(_e1602, _e1599, (_e1599 > _e1602));
                                                                        let _e1610 = bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u));
                                                                        let _e1613 = bitcast<f32>((bitcast<u32>(_e1523) & 2147483647u));
                                                                        let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                                        let _e1618 = bitcast<f32>((bitcast<u32>(_e1526) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1518 * _e1579) + (_e1523 * _e1580)) + (_e1526 * _e1581)) - _e1547)) & 2147483647u)) <= ((0.0000009536743f * select(_e1484, _e1604, (_e1604 > _e1484))) * select(_e1618, _e1615, (_e1615 > _e1618)))) {
                                                                            let _e1628 = bitcast<f32>((bitcast<u32>(_e1509.x) & 2147483647u));
                                                                            let _e1631 = bitcast<f32>((bitcast<u32>(_e1509.y) & 2147483647u));
                                                                            let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                                                            let _e1636 = bitcast<f32>((bitcast<u32>(_e1509.z) & 2147483647u));
                                                                            let _e1642 = bitcast<f32>((bitcast<u32>(_e1507.x) & 2147483647u));
                                                                            let _e1645 = bitcast<f32>((bitcast<u32>(_e1507.y) & 2147483647u));
                                                                            let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                            let _e1650 = bitcast<f32>((bitcast<u32>(_e1507.z) & 2147483647u));
                                                                            let _e1654 = (bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u)) > ((0.0000038146973f * select(_e1636, _e1633, (_e1633 > _e1636))) * select(_e1650, _e1647, (_e1647 > _e1650))));
                                                                            if _e1654 {
                                                                                phi_2145_ = (_e1547 / _e1552);
                                                                            } else {
                                                                                phi_2145_ = f32();
                                                                            }
                                                                            let _e1657 = phi_2145_;
                                                                            phi_2147_ = _e1657;
                                                                            phi_2148_ = select(true, false, _e1654);
                                                                        } else {
                                                                            phi_2147_ = f32();
                                                                            phi_2148_ = true;
                                                                        }
                                                                        let _e1660 = phi_2147_;
                                                                        let _e1662 = phi_2148_;
                                                                        if _e1662 {
                                                                            let _e1670 = (((_e1518 * (_e1579 - (_e362 * _e1582))) + (_e1523 * (_e1580 - (_e430 * _e1582)))) / _e1552);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1670) & 2147483647u)) <= _e1484) {
                                                                                phi_2168_ = (_e1582 + _e1670);
                                                                            } else {
                                                                                phi_2168_ = _e1582;
                                                                            }
                                                                            let _e1677 = phi_2168_;
                                                                            phi_2169_ = _e1677;
                                                                        } else {
                                                                            phi_2169_ = _e1660;
                                                                        }
                                                                        let _e1679 = phi_2169_;
                                                                        let _e1681 = select(_e1417, _e1679, (_e1679 < _e1417));
                                                                        let _e1683 = select(_e1409, _e1681, (_e1681 > _e1409));
                                                                        if (_e1683 >= _e613) {
                                                                            let _e1685 = (_e1683 <= _e1168.member);
                                                                            if _e1685 {
                                                                                let _e1686 = (1f / _e1336);
                                                                                phi_2192_ = type_24(_e1683, (_e1330 * _e1686), (_e1334 * _e1686), _e1197);
                                                                            } else {
                                                                                phi_2192_ = type_24();
                                                                            }
                                                                            let _e1691 = phi_2192_;
                                                                            phi_2194_ = _e1691;
                                                                            phi_2195_ = select(true, false, _e1685);
                                                                        } else {
                                                                            phi_2194_ = type_24();
                                                                            phi_2195_ = true;
                                                                        }
                                                                        let _e1694 = phi_2194_;
                                                                        let _e1696 = phi_2195_;
                                                                        if _e1696 {
                                                                            phi_2199_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2199_ = _e1694;
                                                                        }
                                                                        let _e1698 = phi_2199_;
                                                                        phi_2200_ = _e1698;
                                                                    }
                                                                    let _e1700 = phi_2200_;
                                                                    phi_2201_ = _e1700;
                                                                    phi_2202_ = _e1426;
                                                                }
                                                                let _e1702 = phi_2201_;
                                                                let _e1704 = phi_2202_;
                                                                phi_2206_ = _e1702;
                                                                phi_2207_ = _e1704;
                                                            }
                                                            let _e1706 = phi_2206_;
                                                            let _e1708 = phi_2207_;
                                                            phi_2208_ = _e1706;
                                                            phi_2209_ = _e1361;
                                                            phi_2210_ = _e1708;
                                                        }
                                                        let _e1710 = phi_2208_;
                                                        let _e1712 = phi_2209_;
                                                        let _e1714 = phi_2210_;
                                                        phi_2211_ = _e1710;
                                                        phi_2212_ = _e1712;
                                                        phi_2213_ = _e1714;
                                                    }
                                                    let _e1716 = phi_2211_;
                                                    let _e1718 = phi_2212_;
                                                    let _e1720 = phi_2213_;
                                                    phi_2221_ = _e1716;
                                                    phi_2222_ = select(_e1720, true, _e1718);
                                                } else {
                                                    phi_2221_ = type_24();
                                                    phi_2222_ = true;
                                                }
                                                let _e1723 = phi_2221_;
                                                let _e1725 = phi_2222_;
                                                if _e1725 {
                                                    phi_2226_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2226_ = _e1723;
                                                }
                                                let _e1727 = phi_2226_;
                                                if (_e1727.member_3 != 4294967295u) {
                                                    if (_e1197 != 4294967295u) {
                                                        phi_2237_ = type_38(_e1168.member, true);
                                                    } else {
                                                        phi_2237_ = _e1168;
                                                    }
                                                    let _e1735 = phi_2237_;
                                                    phi_2238_ = _e1735;
                                                } else {
                                                    phi_2238_ = _e1168;
                                                }
                                                let _e1737 = phi_2238_;
                                                phi_1189_ = _e1737;
                                            } else {
                                                phi_1189_ = type_38();
                                            }
                                            let _e1739 = phi_1189_;
                                            continue;
                                            continuing {
                                                phi_1188_ = _e1739;
                                                phi_1191_ = _e1183;
                                                phi_3718_ = _e655;
                                                break if !(_e1189);
                                            }
                                        }
                                        let _e1742 = phi_3718_;
                                        phi_3875_ = _e1742;
                                        if _e1742 {
                                            break;
                                        }
                                        let _e1744 = local_10;
                                        phi_3879_ = _e1742;
                                        let _e1916 = local_12;
                                        phi_3476_ = _e1916;
                                        phi_3477_ = false;
                                        phi_3478_ = select(_e698, 0u, _e1744.member_1);
                                        phi_3479_ = _e700;
                                    } else {
                                        if (_e700.member_1 >= _e88) {
                                            phi_3011_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e700.member_1 < _e88) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e711 = (_e258 * 2u);
                                            let _e713 = ((1u + _e711) % 7u);
                                            if (_e713 < 7u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e718 = global_6.member[_e700.member_1][_e713];
                                            let _e720 = ((_e711 + 2u) % 7u);
                                            if (_e720 < 7u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e725 = global_6.member[_e700.member_1][_e720];
                                            let _e726 = (_e257 * 2u);
                                            let _e728 = ((1u + _e726) % 7u);
                                            if (_e728 < 7u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e733 = global_6.member[_e700.member_1][_e728];
                                            let _e735 = ((_e726 + 2u) % 7u);
                                            if (_e735 < 7u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e740 = global_6.member[_e700.member_1][_e735];
                                            let _e741 = (_e259 * 2u);
                                            let _e743 = ((1u + _e741) % 7u);
                                            if (_e743 < 7u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e748 = global_6.member[_e700.member_1][_e743];
                                            let _e750 = ((_e741 + 2u) % 7u);
                                            if (_e750 < 7u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e755 = global_6.member[_e700.member_1][_e750];
                                            let _e778 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.x - _e700.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e779 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.y - _e700.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e780 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.z - _e700.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e782 = select(_e138, _e778, (_e778 > _e138));
                                            let _e784 = select(_e138, _e779, (_e779 > _e138));
                                            let _e786 = select(_e138, _e780, (_e780 > _e138));
                                            let _e817 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e718 & 2097151u))) - 8388608f) * _e782));
                                            let _e822 = (bitcast<i32>((_e718 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e825 = bitcast<f32>((_e817 & bitcast<u32>(_e822)));
                                            let _e826 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 2097151u))) - 8388608f) * _e784));
                                            let _e831 = (bitcast<i32>((_e733 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e834 = bitcast<f32>((_e826 & bitcast<u32>(_e831)));
                                            let _e835 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e748 & 2097151u))) - 8388608f) * _e786));
                                            let _e840 = (bitcast<i32>((_e748 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e843 = bitcast<f32>((_e835 & bitcast<u32>(_e840)));
                                            let _e847 = bitcast<f32>((_e817 & bitcast<u32>(~(_e822))));
                                            let _e851 = bitcast<f32>((_e826 & bitcast<u32>(~(_e831))));
                                            let _e855 = bitcast<f32>((_e835 & bitcast<u32>(~(_e840))));
                                            let _e856 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 2097151u))) - 8388608f) * _e782));
                                            let _e861 = (bitcast<i32>((_e725 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e864 = bitcast<f32>((_e856 & bitcast<u32>(_e861)));
                                            let _e865 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e740 & 2097151u))) - 8388608f) * _e784));
                                            let _e870 = (bitcast<i32>((_e740 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e873 = bitcast<f32>((_e865 & bitcast<u32>(_e870)));
                                            let _e874 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e755 & 2097151u))) - 8388608f) * _e786));
                                            let _e879 = (bitcast<i32>((_e755 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e882 = bitcast<f32>((_e874 & bitcast<u32>(_e879)));
                                            let _e886 = bitcast<f32>((_e856 & bitcast<u32>(~(_e861))));
                                            let _e890 = bitcast<f32>((_e865 & bitcast<u32>(~(_e870))));
                                            let _e894 = bitcast<f32>((_e874 & bitcast<u32>(~(_e879))));
                                            let _e924 = global_6.member[_e700.member_1][0u];
                                            let _e928 = global_6.member[_e700.member_1][2u];
                                            let _e932 = global_6.member[_e700.member_1][4u];
                                            let _e936 = global_6.member[_e700.member_1][6u];
                                            let _e948 = (((_e928 >> bitcast<u32>(22i)) | ((_e932 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e936 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e949 = (_e924 & 268435455u);
                                            let _e950 = (_e948 & 268435455u);
                                            let _e953 = ((_e924 >> bitcast<u32>(28u)) & 7u);
                                            let _e961 = ((_e924 >> bitcast<u32>(31i)) | (((_e948 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e962 = (_e953 != 0u);
                                            if (_e953 == 0u) {
                                                phi_2973_ = _e949;
                                            } else {
                                                if (_e953 == 7u) {
                                                    phi_2972_ = 2147483648u;
                                                } else {
                                                    phi_2972_ = ((2147483648u | (_e953 << bitcast<u32>(28u))) | (_e950 & 268435455u));
                                                }
                                                let _e971 = phi_2972_;
                                                phi_2973_ = _e971;
                                            }
                                            let _e973 = phi_2973_;
                                            if _e962 {
                                                let _e974 = (_e953 != 7u);
                                                if _e974 {
                                                    phi_2983_ = (_e950 + _e953);
                                                } else {
                                                    phi_2983_ = u32();
                                                }
                                                let _e977 = phi_2983_;
                                                phi_2985_ = _e977;
                                                phi_2986_ = select(true, false, _e974);
                                            } else {
                                                phi_2985_ = u32();
                                                phi_2986_ = true;
                                            }
                                            let _e980 = phi_2985_;
                                            let _e982 = phi_2986_;
                                            if (_e961 == 0u) {
                                                phi_3007_ = (_e949 + select(0u, 1u, !(_e962)));
                                            } else {
                                                if (_e961 == 7u) {
                                                    phi_3006_ = 2147483648u;
                                                } else {
                                                    phi_3006_ = ((2147483648u | (_e961 << bitcast<u32>(28u))) | (select(_e980, _e950, _e982) & 268435455u));
                                                }
                                                let _e995 = phi_3006_;
                                                phi_3007_ = _e995;
                                            }
                                            let _e997 = phi_3007_;
                                            phi_3011_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e700.member.member.x + _e825), (_e700.member.member.x + _e847), (_e700.member.member_1.x - _e864), (_e700.member.member_1.x - _e886)), vec4<f32>((_e700.member.member.y + _e834), (_e700.member.member.y + _e851), (_e700.member.member_1.y - _e873), (_e700.member.member_1.y - _e890)), vec4<f32>((_e700.member.member.z + _e843), (_e700.member.member.z + _e855), (_e700.member.member_1.z - _e882), (_e700.member.member_1.z - _e894))), type_49(type_28((_e700.member.member + vec4<f32>(_e825, _e834, _e843, 0f)), (_e700.member.member_1 - vec4<f32>(_e864, _e873, _e882, 0f))), _e973), type_49(type_28((_e700.member.member + vec4<f32>(_e847, _e851, _e855, 0f)), (_e700.member.member_1 - vec4<f32>(_e886, _e890, _e894, 0f))), _e997));
                                        }
                                        let _e1002 = phi_3011_;
                                        let _e1014 = ((_e1002.member[0].x - _e360) * _e365);
                                        let _e1015 = ((_e1002.member[0].y - _e360) * _e365);
                                        let _e1016 = ((_e1002.member[0].z - _e361) * _e365);
                                        let _e1017 = ((_e1002.member[0].w - _e361) * _e365);
                                        let _e1027 = ((_e1002.member[1].x - _e428) * _e433);
                                        let _e1028 = ((_e1002.member[1].y - _e428) * _e433);
                                        let _e1029 = ((_e1002.member[1].z - _e429) * _e433);
                                        let _e1030 = ((_e1002.member[1].w - _e429) * _e433);
                                        let _e1040 = ((_e1002.member[2].x - _e496) * _e501);
                                        let _e1041 = ((_e1002.member[2].y - _e496) * _e501);
                                        let _e1042 = ((_e1002.member[2].z - _e497) * _e501);
                                        let _e1043 = ((_e1002.member[2].w - _e497) * _e501);
                                        let _e1045 = select(_e1042, _e1040, (_e1040 < _e1042));
                                        let _e1047 = select(_e1043, _e1041, (_e1041 < _e1043));
                                        let _e1049 = select(_e1042, _e1040, (_e1040 > _e1042));
                                        let _e1051 = select(_e1043, _e1041, (_e1041 > _e1043));
                                        let _e1053 = select(_e1016, _e1014, (_e1014 < _e1016));
                                        let _e1055 = select(_e1017, _e1015, (_e1015 < _e1017));
                                        let _e1057 = select(_e1029, _e1027, (_e1027 < _e1029));
                                        let _e1059 = select(_e1030, _e1028, (_e1028 < _e1030));
                                        let _e1061 = select(_e1057, _e1053, (_e1053 > _e1057));
                                        let _e1063 = select(_e1059, _e1055, (_e1055 > _e1059));
                                        let _e1065 = select(_e1045, _e1061, (_e1061 > _e1045));
                                        let _e1067 = select(_e1047, _e1063, (_e1063 > _e1047));
                                        let _e1069 = select(_e1016, _e1014, (_e1014 > _e1016));
                                        let _e1071 = select(_e1017, _e1015, (_e1015 > _e1017));
                                        let _e1073 = select(_e1029, _e1027, (_e1027 > _e1029));
                                        let _e1075 = select(_e1030, _e1028, (_e1028 > _e1030));
                                        let _e1077 = select(_e1073, _e1069, (_e1069 < _e1073));
                                        let _e1079 = select(_e1075, _e1071, (_e1071 < _e1075));
                                        let _e1084 = -(_e1045);
                                        let _e1085 = -(_e1047);
                                        let _e1092 = (select(_e1049, _e1077, (_e1077 < _e1049)) + (select(_e1084, _e1049, (_e1049 > _e1084)) * 0.0000019073523f));
                                        let _e1093 = (select(_e1051, _e1079, (_e1079 < _e1051)) + (select(_e1085, _e1051, (_e1051 > _e1085)) * 0.0000019073523f));
                                        let _e1095 = select(_e613, _e1065, (_e1065 > _e613));
                                        let _e1097 = select(_e613, _e1067, (_e1067 > _e613));
                                        let _e1102 = (_e1095 <= select(_e657.member, _e1092, (_e1092 < _e657.member)));
                                        let _e1103 = (_e1097 <= select(_e657.member, _e1093, (_e1093 < _e657.member)));
                                        let _e1104 = (_e1095 <= _e1097);
                                        if _e1102 {
                                            if _e1103 {
                                                if _e1104 {
                                                    phi_3373_ = _e1002.member_2;
                                                } else {
                                                    phi_3373_ = _e1002.member_1;
                                                }
                                                let _e1108 = phi_3373_;
                                                let _e1130 = (_e698 % 128u);
                                                let _e1131 = (_e1130 < 128u);
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_8[_e1130] = _e1108.member_1;
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_7[_e1130] = _e1108.member.member.x;
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_6[_e1130] = _e1108.member.member.y;
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_5[_e1130] = _e1108.member.member.z;
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_4[_e1130] = _e1108.member.member_1.x;
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_3[_e1130] = _e1108.member.member_1.y;
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_2[_e1130] = _e1108.member.member_1.z;
                                                if _e1131 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_9[_e1130] = select(_e1097, _e1095, !(_e1104));
                                                if _e1104 {
                                                    phi_3450_ = _e1002.member_1;
                                                } else {
                                                    phi_3450_ = _e1002.member_2;
                                                }
                                                let _e1144 = phi_3450_;
                                                phi_3451_ = (_e698 + 1u);
                                                phi_3452_ = _e1144;
                                            } else {
                                                phi_3451_ = u32();
                                                phi_3452_ = type_49();
                                            }
                                            let _e1146 = phi_3451_;
                                            let _e1148 = phi_3452_;
                                            phi_3454_ = _e1146;
                                            phi_3455_ = _e1148;
                                            phi_3456_ = select(true, false, _e1103);
                                        } else {
                                            phi_3454_ = u32();
                                            phi_3455_ = type_49();
                                            phi_3456_ = true;
                                        }
                                        let _e1151 = phi_3454_;
                                        let _e1153 = phi_3455_;
                                        let _e1155 = phi_3456_;
                                        if _e1155 {
                                            if _e1102 {
                                                phi_3465_ = _e1002.member_1;
                                            } else {
                                                phi_3465_ = _e1002.member_2;
                                            }
                                            let _e1159 = phi_3465_;
                                            phi_3470_ = select(_e1103, true, _e1102);
                                            phi_3472_ = _e1159;
                                        } else {
                                            phi_3470_ = _e696;
                                            phi_3472_ = _e1153;
                                        }
                                        let _e1162 = phi_3470_;
                                        let _e1164 = phi_3472_;
                                        phi_3879_ = _e655;
                                        phi_3476_ = _e657;
                                        phi_3477_ = _e1162;
                                        phi_3478_ = select(_e1151, _e698, _e1155);
                                        phi_3479_ = _e1164;
                                    }
                                    let _e1748 = phi_3879_;
                                    let _e1750 = phi_3476_;
                                    let _e1752 = phi_3477_;
                                    let _e1754 = phi_3478_;
                                    let _e1756 = phi_3479_;
                                    phi_3878_ = _e1748;
                                    phi_3480_ = _e1750;
                                    phi_3481_ = _e1752;
                                    phi_3482_ = (_e661 - 1u);
                                    phi_3483_ = _e1754;
                                    phi_3484_ = _e1756;
                                } else {
                                    phi_3878_ = _e655;
                                    phi_3480_ = _e657;
                                    phi_3481_ = _e696;
                                    phi_3482_ = _e661;
                                    phi_3483_ = _e698;
                                    phi_3484_ = _e700;
                                }
                                let _e1758 = phi_3878_;
                                let _e1760 = phi_3480_;
                                let _e1762 = phi_3481_;
                                let _e1764 = phi_3482_;
                                let _e1766 = phi_3483_;
                                let _e1768 = phi_3484_;
                                phi_3877_ = _e1758;
                                phi_3485_ = _e1760;
                                phi_3486_ = _e1762;
                                phi_3487_ = _e1764;
                                phi_3488_ = _e1766;
                                phi_3489_ = _e1768;
                            } else {
                                phi_3877_ = _e655;
                                phi_3485_ = type_38();
                                phi_3486_ = bool();
                                phi_3487_ = u32();
                                phi_3488_ = u32();
                                phi_3489_ = type_49();
                            }
                            let _e1770 = phi_3877_;
                            let _e1772 = phi_3485_;
                            let _e1774 = phi_3486_;
                            let _e1776 = phi_3487_;
                            let _e1778 = phi_3488_;
                            let _e1780 = phi_3489_;
                            phi_3876_ = _e1770;
                            phi_1063_ = _e1772;
                            phi_1066_ = _e1774;
                            phi_1068_ = _e1776;
                            phi_1070_ = _e1778;
                            phi_1072_ = _e1780;
                            phi_3490_ = _e669;
                        } else {
                            phi_3876_ = _e655;
                            phi_1063_ = type_38();
                            phi_1066_ = bool();
                            phi_1068_ = u32();
                            phi_1070_ = u32();
                            phi_1072_ = type_49();
                            phi_3490_ = false;
                        }
                        let _e1782 = phi_3876_;
                        let _e1784 = phi_1063_;
                        let _e1786 = phi_1066_;
                        let _e1788 = phi_1068_;
                        let _e1790 = phi_1070_;
                        let _e1792 = phi_1072_;
                        let _e1794 = phi_3490_;
                        continue;
                        continuing {
                            phi_3724_ = _e1782;
                            phi_1062_ = _e1784;
                            phi_1065_ = _e1786;
                            phi_1067_ = _e1788;
                            phi_1069_ = _e1790;
                            phi_1071_ = _e1792;
                            phi_3875_ = _e1782;
                            break if !(_e1794);
                        }
                    }
                    let _e1797 = phi_3875_;
                    if _e1797 {
                        break;
                    }
                    let _e1799 = local_11;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_5.member[_e144] = select(0u, 1u, _e1799.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
