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
    var phi_3727_: bool;
    var phi_1062_: type_38;
    var phi_1065_: u32;
    var phi_1067_: bool;
    var phi_1069_: u32;
    var phi_1071_: type_49;
    var phi_1082_: bool;
    var phi_1168_: bool;
    var phi_1169_: u32;
    var phi_1170_: type_49;
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
    var phi_3721_: bool;
    var phi_3964_: bool;
    var phi_2239_: type_38;
    var phi_2966_: u32;
    var phi_2967_: u32;
    var phi_2977_: u32;
    var phi_2979_: u32;
    var phi_2980_: bool;
    var phi_3000_: u32;
    var phi_3001_: u32;
    var phi_3005_: type_50;
    var phi_3367_: type_49;
    var phi_3443_: type_49;
    var phi_3444_: u32;
    var phi_3445_: type_49;
    var phi_3447_: u32;
    var phi_3448_: type_49;
    var phi_3449_: bool;
    var phi_3458_: type_49;
    var phi_3463_: bool;
    var phi_3465_: type_49;
    var phi_3469_: bool;
    var phi_3470_: u32;
    var phi_3471_: type_49;
    var phi_3481_: u32;
    var phi_3482_: type_49;
    var phi_3881_: bool;
    var phi_3483_: type_38;
    var phi_3484_: u32;
    var phi_3485_: bool;
    var phi_3486_: u32;
    var phi_3487_: type_49;
    var phi_3880_: bool;
    var phi_3488_: type_38;
    var phi_3489_: u32;
    var phi_3490_: bool;
    var phi_3491_: u32;
    var phi_3492_: type_49;
    var phi_3879_: bool;
    var phi_1063_: type_38;
    var phi_1066_: u32;
    var phi_1068_: bool;
    var phi_1070_: u32;
    var phi_1072_: type_49;
    var phi_3493_: bool;
    var phi_3878_: bool;
    var local_10: type_38;
    var local_11: type_38;

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
                    phi_3727_ = false;
                    phi_1062_ = type_38(_e611, false);
                    phi_1065_ = ((3u * _e88) + 1u);
                    phi_1067_ = (_e613 <= _e611);
                    phi_1069_ = 0u;
                    phi_1071_ = type_49(type_28(vec4<f32>((f32(_e620) * _e138), (f32(_e626) * _e138), (f32(_e632) * _e138), 0f), vec4<f32>((f32(_e637) * _e138), (f32(_e641) * _e138), (f32(_e645) * _e138), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    loop {
                        let _e655 = phi_3727_;
                        let _e657 = phi_1062_;
                        let _e659 = phi_1065_;
                        let _e661 = phi_1067_;
                        let _e663 = phi_1069_;
                        let _e665 = phi_1071_;
                        local_10 = _e657;
                        if _e661 {
                            phi_1082_ = true;
                        } else {
                            phi_1082_ = (_e663 > 0u);
                        }
                        let _e668 = phi_1082_;
                        if _e668 {
                            let _e669 = (_e659 > 0u);
                            if _e669 {
                                if _e661 {
                                    phi_1168_ = _e661;
                                    phi_1169_ = _e663;
                                    phi_1170_ = _e665;
                                } else {
                                    let _e670 = (_e663 - 1u);
                                    let _e671 = (_e670 % 128u);
                                    let _e672 = (_e671 < 128u);
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e674 = local_7[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e676 = local_6[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e678 = local_5[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e680 = local_4[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e682 = local_3[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e684 = local_2[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e689 = local_8[_e671];
                                    if _e672 {
                                    } else {
                                        phi_3878_ = true;
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
                                    let _e704 = ((_e700.member_1 & 2147483648u) != 0u);
                                    if _e704 {
                                        phi_1188_ = _e657;
                                        phi_1191_ = type_7(0u, ((_e700.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e711 = phi_1188_;
                                            let _e713 = phi_1191_;
                                            local_11 = _e711;
                                            if (_e713.member < _e713.member_1) {
                                                phi_1192_ = type_7((_e713.member + 1u), _e713.member_1);
                                                phi_1214_ = type_7(1u, _e713.member);
                                            } else {
                                                phi_1192_ = _e713;
                                                phi_1214_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e726 = phi_1192_;
                                            let _e728 = phi_1214_;
                                            let _e732 = (bitcast<i32>(_e728.member) != 0i);
                                            if _e732 {
                                                let _e733 = ((_e700.member_1 & 268435455u) + _e728.member_1);
                                                let _e734 = (_e733 < _e90);
                                                if _e734 {
                                                    if _e734 {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e738 = global_2.member[_e733].member_1;
                                                    phi_1235_ = _e738;
                                                } else {
                                                    phi_1235_ = 4294967295u;
                                                }
                                                let _e740 = phi_1235_;
                                                if (_e733 >= _e90) {
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e734 {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e747 = global_2.member[_e733].member[_e617];
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e753 = global_2.member[_e733].member[_e623];
                                                    if (_e629 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e759 = global_2.member[_e733].member[_e629];
                                                    let _e761 = (3u + _e617);
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_2.member[_e733].member[_e761];
                                                    let _e768 = (3u + _e623);
                                                    if (_e768 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e774 = global_2.member[_e733].member[_e768];
                                                    let _e775 = (3u + _e629);
                                                    if (_e775 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e781 = global_2.member[_e733].member[_e775];
                                                    let _e783 = (6u + _e617);
                                                    if (_e783 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e789 = global_2.member[_e733].member[_e783];
                                                    let _e790 = (6u + _e623);
                                                    if (_e790 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e796 = global_2.member[_e733].member[_e790];
                                                    let _e797 = (6u + _e629);
                                                    if (_e797 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e803 = global_2.member[_e733].member[_e797];
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(_e747, _e753, _e759), array<f32, 3>(_e767, _e774, _e781), array<f32, 3>(_e789, _e796, _e803));
                                                }
                                                let _e807 = phi_1327_;
                                                let _e815 = (_e807[0][2] - _e459);
                                                let _e818 = (((_e807[0][0] - _e322) * _e498) - (_e815 * _e362));
                                                let _e821 = (((_e807[0][1] - _e391) * _e498) - (_e815 * _e430));
                                                let _e828 = (_e807[1][2] - _e459);
                                                let _e831 = (((_e807[1][0] - _e322) * _e498) - (_e828 * _e362));
                                                let _e834 = (((_e807[1][1] - _e391) * _e498) - (_e828 * _e430));
                                                let _e841 = (_e807[2][2] - _e459);
                                                let _e844 = (((_e807[2][0] - _e322) * _e498) - (_e841 * _e362));
                                                let _e847 = (((_e807[2][1] - _e391) * _e498) - (_e841 * _e430));
                                                let _e848 = (_e844 * _e834);
                                                let _e849 = (_e847 * _e831);
                                                let _e850 = (_e818 * _e847);
                                                let _e851 = (_e821 * _e844);
                                                let _e852 = (_e831 * _e821);
                                                let _e853 = (_e834 * _e818);
                                                let _e858 = (((_e848 >= _e849) && (_e850 >= _e851)) && (_e852 >= _e853));
                                                if (_e858 || (((_e848 <= _e849) && (_e850 <= _e851)) && (_e852 <= _e853))) {
                                                    let _e865 = select(-1f, 1f, _e858);
                                                    let _e867 = ((_e848 - _e849) * _e865);
                                                    let _e869 = select(0f, _e867, (_e867 > 0f));
                                                    let _e871 = ((_e850 - _e851) * _e865);
                                                    let _e873 = select(0f, _e871, (_e871 > 0f));
                                                    let _e875 = ((_e852 - _e853) * _e865);
                                                    let _e877 = select(0f, _e875, (_e875 > 0f));
                                                    let _e879 = ((_e869 + _e873) + _e877);
                                                    if (_e879 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2211_ = type_24();
                                                        phi_2212_ = true;
                                                        phi_2213_ = false;
                                                    } else {
                                                        let _e882 = select(_e831, _e818, (_e818 < _e831));
                                                        if (select(_e844, _e882, (_e882 < _e844)) > 0f) {
                                                            phi_1479_ = true;
                                                        } else {
                                                            let _e887 = select(_e831, _e818, (_e818 > _e831));
                                                            phi_1479_ = (select(_e844, _e887, (_e887 > _e844)) < 0f);
                                                        }
                                                        let _e892 = phi_1479_;
                                                        if _e892 {
                                                            phi_2208_ = type_24();
                                                            phi_2209_ = true;
                                                            phi_2210_ = false;
                                                        } else {
                                                            let _e894 = select(_e834, _e821, (_e821 < _e834));
                                                            if (select(_e847, _e894, (_e894 < _e847)) > 0f) {
                                                                phi_1508_ = true;
                                                            } else {
                                                                let _e899 = select(_e834, _e821, (_e821 > _e834));
                                                                phi_1508_ = (select(_e847, _e899, (_e899 > _e847)) < 0f);
                                                            }
                                                            let _e904 = phi_1508_;
                                                            if _e904 {
                                                                phi_2206_ = type_24();
                                                                phi_2207_ = false;
                                                            } else {
                                                                let _e906 = select(_e807[1][0], _e807[0][0], (_e807[0][0] < _e807[1][0]));
                                                                let _e910 = select(_e807[1][0], _e807[0][0], (_e807[0][0] > _e807[1][0]));
                                                                let _e914 = select(_e807[1][1], _e807[0][1], (_e807[0][1] < _e807[1][1]));
                                                                let _e918 = select(_e807[1][1], _e807[0][1], (_e807[0][1] > _e807[1][1]));
                                                                let _e922 = select(_e807[1][2], _e807[0][2], (_e807[0][2] < _e807[1][2]));
                                                                let _e926 = select(_e807[1][2], _e807[0][2], (_e807[0][2] > _e807[1][2]));
                                                                let _e931 = ((select(_e807[2][0], _e906, (_e906 < _e807[2][0])) - _e360) * _e365);
                                                                let _e932 = ((select(_e807[2][0], _e910, (_e910 > _e807[2][0])) - _e361) * _e365);
                                                                let _e935 = ((select(_e807[2][1], _e914, (_e914 < _e807[2][1])) - _e428) * _e433);
                                                                let _e936 = ((select(_e807[2][1], _e918, (_e918 > _e807[2][1])) - _e429) * _e433);
                                                                let _e939 = ((select(_e807[2][2], _e922, (_e922 < _e807[2][2])) - _e496) * _e501);
                                                                let _e940 = ((select(_e807[2][2], _e926, (_e926 > _e807[2][2])) - _e497) * _e501);
                                                                let _e942 = select(_e940, _e939, (_e939 < _e940));
                                                                let _e944 = select(_e940, _e939, (_e939 > _e940));
                                                                let _e946 = select(_e932, _e931, (_e931 < _e932));
                                                                let _e948 = select(_e936, _e935, (_e935 < _e936));
                                                                let _e950 = select(_e948, _e946, (_e946 > _e948));
                                                                let _e952 = select(_e942, _e950, (_e950 > _e942));
                                                                let _e954 = select(_e932, _e931, (_e931 > _e932));
                                                                let _e956 = select(_e936, _e935, (_e935 > _e936));
                                                                let _e958 = select(_e956, _e954, (_e954 < _e956));
                                                                let _e960 = select(_e944, _e958, (_e958 < _e944));
                                                                let _e961 = -(_e942);
                                                                let _e967 = select(_e613, _e952, (_e952 > _e613));
                                                                if (_e967 > (_e960 + (select(_e961, _e944, (_e944 > _e961)) * 0.0000019073523f))) {
                                                                    phi_2201_ = type_24();
                                                                    phi_2202_ = true;
                                                                } else {
                                                                    let _e969 = (_e967 > _e711.member);
                                                                    if _e969 {
                                                                        phi_2200_ = type_24();
                                                                    } else {
                                                                        let _e970 = vec3<f32>(_e807[0][0], _e807[0][1], _e807[0][2]);
                                                                        let _e971 = vec3<f32>(_e807[1][0], _e807[1][1], _e807[1][2]);
                                                                        let _e972 = vec3<f32>(_e807[2][0], _e807[2][1], _e807[2][2]);
                                                                        let _e973 = (_e807[1][0] - _e807[0][0]);
                                                                        let _e974 = (_e807[1][1] - _e807[0][1]);
                                                                        let _e975 = (_e807[1][2] - _e807[0][2]);
                                                                        let _e976 = vec3<f32>(_e973, _e974, _e975);
                                                                        let _e977 = (_e807[2][0] - _e807[1][0]);
                                                                        let _e978 = (_e807[2][1] - _e807[1][1]);
                                                                        let _e979 = (_e807[2][2] - _e807[1][2]);
                                                                        let _e980 = vec3<f32>(_e977, _e978, _e979);
                                                                        let _e981 = (_e807[0][0] - _e807[2][0]);
                                                                        let _e982 = (_e807[0][1] - _e807[2][1]);
                                                                        let _e983 = (_e807[0][2] - _e807[2][2]);
                                                                        let _e984 = vec3<f32>(_e981, _e982, _e983);
                                                                        let _e987 = bitcast<f32>((bitcast<u32>(_e973) & 2147483647u));
                                                                        let _e990 = bitcast<f32>((bitcast<u32>(_e974) & 2147483647u));
                                                                        let _e992 = select(_e990, _e987, (_e987 > _e990));
                                                                        let _e995 = bitcast<f32>((bitcast<u32>(_e975) & 2147483647u));
                                                                        let _e997 = select(_e995, _e992, (_e992 > _e995));
                                                                        let _e1000 = bitcast<f32>((bitcast<u32>(_e977) & 2147483647u));
                                                                        let _e1003 = bitcast<f32>((bitcast<u32>(_e978) & 2147483647u));
                                                                        let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                                                                        let _e1008 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                                                                        let _e1013 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                        let _e1016 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                        let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                                                                        let _e1021 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                                                                        let _e1025 = select(_e1010, _e997, (_e997 > _e1010));
                                                                        let _e1027 = select(_e1023, _e1025, (_e1025 > _e1023));
                                                                        if (_e997 == _e1027) {
                                                                            phi_1927_ = _e834;
                                                                            phi_1928_ = _e831;
                                                                            phi_1929_ = _e821;
                                                                            phi_1930_ = _e818;
                                                                            phi_1931_ = _e970;
                                                                            phi_1932_ = _e984;
                                                                            phi_1933_ = _e980;
                                                                            phi_1934_ = _e976;
                                                                        } else {
                                                                            let _e1029 = (_e1010 == _e1027);
                                                                            let _e1034 = vec3(_e1029);
                                                                            phi_1927_ = select(_e821, _e847, _e1029);
                                                                            phi_1928_ = select(_e818, _e844, _e1029);
                                                                            phi_1929_ = select(_e847, _e834, _e1029);
                                                                            phi_1930_ = select(_e844, _e831, _e1029);
                                                                            phi_1931_ = select(_e972, _e971, _e1034);
                                                                            phi_1932_ = select(_e980, _e976, _e1034);
                                                                            phi_1933_ = select(_e976, _e984, _e1034);
                                                                            phi_1934_ = select(_e984, _e980, _e1034);
                                                                        }
                                                                        let _e1040 = phi_1927_;
                                                                        let _e1042 = phi_1928_;
                                                                        let _e1044 = phi_1929_;
                                                                        let _e1046 = phi_1930_;
                                                                        let _e1048 = phi_1931_;
                                                                        let _e1050 = phi_1932_;
                                                                        let _e1052 = phi_1933_;
                                                                        let _e1054 = phi_1934_;
                                                                        let _e1061 = ((_e1052.y * _e1050.z) - (_e1050.y * _e1052.z));
                                                                        let _e1066 = ((_e1052.z * _e1050.x) - (_e1050.z * _e1052.x));
                                                                        let _e1069 = ((_e1052.x * _e1050.y) - (_e1050.x * _e1052.y));
                                                                        if (_e869 >= _e873) {
                                                                            phi_1971_ = select(true, false, (_e869 >= _e877));
                                                                        } else {
                                                                            phi_1971_ = true;
                                                                        }
                                                                        let _e1074 = phi_1971_;
                                                                        if _e1074 {
                                                                            phi_1980_ = select(_e972, _e971, vec3((_e873 >= _e877)));
                                                                        } else {
                                                                            phi_1980_ = _e970;
                                                                        }
                                                                        let _e1079 = phi_1980_;
                                                                        let _e1090 = (((_e1061 * (_e1079.x - _e322)) + (_e1066 * (_e1079.y - _e391))) + (_e1069 * (_e1079.z - _e459)));
                                                                        let _e1095 = (((_e1061 * _e362) + (_e1066 * _e430)) + (_e1069 * _e498));
                                                                        let _e1096 = (_e1042 - _e1046);
                                                                        let _e1097 = (_e1040 - _e1044);
                                                                        let _e1105 = (-(((_e1046 * _e1096) + (_e1044 * _e1097))) / ((_e1096 * _e1096) + (_e1097 * _e1097)));
                                                                        let _e1107 = select(1f, _e1105, (_e1105 < 1f));
                                                                        let _e1109 = select(0f, _e1107, (_e1107 > 0f));
                                                                        let _e1122 = ((_e1048.x + (_e1054.x * _e1109)) - _e322);
                                                                        let _e1123 = ((_e1048.y + (_e1054.y * _e1109)) - _e391);
                                                                        let _e1124 = ((_e1048.z + (_e1054.z * _e1109)) - _e459);
                                                                        let _e1125 = (_e1124 / _e498);
                                                                        let _e1137 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                                        let _e1140 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                                        let _e1142 = select(_e1140, _e1137, (_e1137 > _e1140));
                                                                        let _e1145 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                                                        let _e1147 = select(_e1145, _e1142, (_e1142 > _e1145));
                                                                        let _e1153 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                                                        let _e1156 = bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u));
                                                                        let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                                        let _e1161 = bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1061 * _e1122) + (_e1066 * _e1123)) + (_e1069 * _e1124)) - _e1090)) & 2147483647u)) <= ((0.0000009536743f * select(_e1027, _e1147, (_e1147 > _e1027))) * select(_e1161, _e1158, (_e1158 > _e1161)))) {
                                                                            let _e1171 = bitcast<f32>((bitcast<u32>(_e1052.x) & 2147483647u));
                                                                            let _e1174 = bitcast<f32>((bitcast<u32>(_e1052.y) & 2147483647u));
                                                                            let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                                                                            let _e1179 = bitcast<f32>((bitcast<u32>(_e1052.z) & 2147483647u));
                                                                            let _e1185 = bitcast<f32>((bitcast<u32>(_e1050.x) & 2147483647u));
                                                                            let _e1188 = bitcast<f32>((bitcast<u32>(_e1050.y) & 2147483647u));
                                                                            let _e1190 = select(_e1188, _e1185, (_e1185 > _e1188));
                                                                            let _e1193 = bitcast<f32>((bitcast<u32>(_e1050.z) & 2147483647u));
                                                                            let _e1197 = (bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u)) > ((0.0000038146973f * select(_e1179, _e1176, (_e1176 > _e1179))) * select(_e1193, _e1190, (_e1190 > _e1193))));
                                                                            if _e1197 {
                                                                                phi_2145_ = (_e1090 / _e1095);
                                                                            } else {
                                                                                phi_2145_ = f32();
                                                                            }
                                                                            let _e1200 = phi_2145_;
                                                                            phi_2147_ = _e1200;
                                                                            phi_2148_ = select(true, false, _e1197);
                                                                        } else {
                                                                            phi_2147_ = f32();
                                                                            phi_2148_ = true;
                                                                        }
                                                                        let _e1203 = phi_2147_;
                                                                        let _e1205 = phi_2148_;
                                                                        if _e1205 {
                                                                            let _e1213 = (((_e1061 * (_e1122 - (_e362 * _e1125))) + (_e1066 * (_e1123 - (_e430 * _e1125)))) / _e1095);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u)) <= _e1027) {
                                                                                phi_2168_ = (_e1125 + _e1213);
                                                                            } else {
                                                                                phi_2168_ = _e1125;
                                                                            }
                                                                            let _e1220 = phi_2168_;
                                                                            phi_2169_ = _e1220;
                                                                        } else {
                                                                            phi_2169_ = _e1203;
                                                                        }
                                                                        let _e1222 = phi_2169_;
                                                                        let _e1224 = select(_e960, _e1222, (_e1222 < _e960));
                                                                        let _e1226 = select(_e952, _e1224, (_e1224 > _e952));
                                                                        if (_e1226 >= _e613) {
                                                                            let _e1228 = (_e1226 <= _e711.member);
                                                                            if _e1228 {
                                                                                let _e1229 = (1f / _e879);
                                                                                phi_2192_ = type_24(_e1226, (_e873 * _e1229), (_e877 * _e1229), _e740);
                                                                            } else {
                                                                                phi_2192_ = type_24();
                                                                            }
                                                                            let _e1234 = phi_2192_;
                                                                            phi_2194_ = _e1234;
                                                                            phi_2195_ = select(true, false, _e1228);
                                                                        } else {
                                                                            phi_2194_ = type_24();
                                                                            phi_2195_ = true;
                                                                        }
                                                                        let _e1237 = phi_2194_;
                                                                        let _e1239 = phi_2195_;
                                                                        if _e1239 {
                                                                            phi_2199_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2199_ = _e1237;
                                                                        }
                                                                        let _e1241 = phi_2199_;
                                                                        phi_2200_ = _e1241;
                                                                    }
                                                                    let _e1243 = phi_2200_;
                                                                    phi_2201_ = _e1243;
                                                                    phi_2202_ = _e969;
                                                                }
                                                                let _e1245 = phi_2201_;
                                                                let _e1247 = phi_2202_;
                                                                phi_2206_ = _e1245;
                                                                phi_2207_ = _e1247;
                                                            }
                                                            let _e1249 = phi_2206_;
                                                            let _e1251 = phi_2207_;
                                                            phi_2208_ = _e1249;
                                                            phi_2209_ = _e904;
                                                            phi_2210_ = _e1251;
                                                        }
                                                        let _e1253 = phi_2208_;
                                                        let _e1255 = phi_2209_;
                                                        let _e1257 = phi_2210_;
                                                        phi_2211_ = _e1253;
                                                        phi_2212_ = _e1255;
                                                        phi_2213_ = _e1257;
                                                    }
                                                    let _e1259 = phi_2211_;
                                                    let _e1261 = phi_2212_;
                                                    let _e1263 = phi_2213_;
                                                    phi_2221_ = _e1259;
                                                    phi_2222_ = select(_e1263, true, _e1261);
                                                } else {
                                                    phi_2221_ = type_24();
                                                    phi_2222_ = true;
                                                }
                                                let _e1266 = phi_2221_;
                                                let _e1268 = phi_2222_;
                                                if _e1268 {
                                                    phi_2226_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2226_ = _e1266;
                                                }
                                                let _e1270 = phi_2226_;
                                                if (_e1270.member_3 != 4294967295u) {
                                                    if (_e740 != 4294967295u) {
                                                        phi_2237_ = type_38(_e711.member, true);
                                                    } else {
                                                        phi_2237_ = _e711;
                                                    }
                                                    let _e1278 = phi_2237_;
                                                    phi_2238_ = _e1278;
                                                } else {
                                                    phi_2238_ = _e711;
                                                }
                                                let _e1280 = phi_2238_;
                                                phi_1189_ = _e1280;
                                            } else {
                                                phi_1189_ = type_38();
                                            }
                                            let _e1282 = phi_1189_;
                                            continue;
                                            continuing {
                                                phi_1188_ = _e1282;
                                                phi_1191_ = _e726;
                                                phi_3721_ = _e655;
                                                break if !(_e732);
                                            }
                                        }
                                        let _e1285 = phi_3721_;
                                        phi_3878_ = _e1285;
                                        if _e1285 {
                                            break;
                                        }
                                        phi_3964_ = _e1285;
                                        let _e1899 = local_11;
                                        phi_2239_ = _e1899;
                                    } else {
                                        phi_3964_ = _e655;
                                        phi_2239_ = _e657;
                                    }
                                    let _e1287 = phi_3964_;
                                    let _e1289 = phi_2239_;
                                    if _e704 {
                                        phi_3469_ = bool();
                                        phi_3470_ = u32();
                                        phi_3471_ = type_49();
                                    } else {
                                        if (_e700.member_1 >= _e88) {
                                            phi_3005_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e700.member_1 < _e88) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1292 = (_e258 * 2u);
                                            let _e1294 = ((1u + _e1292) % 7u);
                                            if (_e1294 < 7u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1299 = global_6.member[_e700.member_1][_e1294];
                                            let _e1301 = ((_e1292 + 2u) % 7u);
                                            if (_e1301 < 7u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1306 = global_6.member[_e700.member_1][_e1301];
                                            let _e1307 = (_e257 * 2u);
                                            let _e1309 = ((1u + _e1307) % 7u);
                                            if (_e1309 < 7u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1314 = global_6.member[_e700.member_1][_e1309];
                                            let _e1316 = ((_e1307 + 2u) % 7u);
                                            if (_e1316 < 7u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1321 = global_6.member[_e700.member_1][_e1316];
                                            let _e1322 = (_e259 * 2u);
                                            let _e1324 = ((1u + _e1322) % 7u);
                                            if (_e1324 < 7u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1329 = global_6.member[_e700.member_1][_e1324];
                                            let _e1331 = ((_e1322 + 2u) % 7u);
                                            if (_e1331 < 7u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1336 = global_6.member[_e700.member_1][_e1331];
                                            let _e1359 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.x - _e700.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1360 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.y - _e700.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1361 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.z - _e700.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1363 = select(_e138, _e1359, (_e1359 > _e138));
                                            let _e1365 = select(_e138, _e1360, (_e1360 > _e138));
                                            let _e1367 = select(_e138, _e1361, (_e1361 > _e138));
                                            let _e1398 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1299 & 2097151u))) - 8388608f) * _e1363));
                                            let _e1403 = (bitcast<i32>((_e1299 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1406 = bitcast<f32>((_e1398 & bitcast<u32>(_e1403)));
                                            let _e1407 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1314 & 2097151u))) - 8388608f) * _e1365));
                                            let _e1412 = (bitcast<i32>((_e1314 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1415 = bitcast<f32>((_e1407 & bitcast<u32>(_e1412)));
                                            let _e1416 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1329 & 2097151u))) - 8388608f) * _e1367));
                                            let _e1421 = (bitcast<i32>((_e1329 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1424 = bitcast<f32>((_e1416 & bitcast<u32>(_e1421)));
                                            let _e1428 = bitcast<f32>((_e1398 & bitcast<u32>(~(_e1403))));
                                            let _e1432 = bitcast<f32>((_e1407 & bitcast<u32>(~(_e1412))));
                                            let _e1436 = bitcast<f32>((_e1416 & bitcast<u32>(~(_e1421))));
                                            let _e1437 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1306 & 2097151u))) - 8388608f) * _e1363));
                                            let _e1442 = (bitcast<i32>((_e1306 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1445 = bitcast<f32>((_e1437 & bitcast<u32>(_e1442)));
                                            let _e1446 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1321 & 2097151u))) - 8388608f) * _e1365));
                                            let _e1451 = (bitcast<i32>((_e1321 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1454 = bitcast<f32>((_e1446 & bitcast<u32>(_e1451)));
                                            let _e1455 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1336 & 2097151u))) - 8388608f) * _e1367));
                                            let _e1460 = (bitcast<i32>((_e1336 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1463 = bitcast<f32>((_e1455 & bitcast<u32>(_e1460)));
                                            let _e1467 = bitcast<f32>((_e1437 & bitcast<u32>(~(_e1442))));
                                            let _e1471 = bitcast<f32>((_e1446 & bitcast<u32>(~(_e1451))));
                                            let _e1475 = bitcast<f32>((_e1455 & bitcast<u32>(~(_e1460))));
                                            let _e1505 = global_6.member[_e700.member_1][0u];
                                            let _e1509 = global_6.member[_e700.member_1][2u];
                                            let _e1513 = global_6.member[_e700.member_1][4u];
                                            let _e1517 = global_6.member[_e700.member_1][6u];
                                            let _e1529 = (((_e1509 >> bitcast<u32>(22i)) | ((_e1513 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1517 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1530 = (_e1505 & 268435455u);
                                            let _e1531 = (_e1529 & 268435455u);
                                            let _e1534 = ((_e1505 >> bitcast<u32>(28u)) & 7u);
                                            let _e1542 = ((_e1505 >> bitcast<u32>(31i)) | (((_e1529 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1543 = (_e1534 != 0u);
                                            if (_e1534 == 0u) {
                                                phi_2967_ = _e1530;
                                            } else {
                                                if (_e1534 == 7u) {
                                                    phi_2966_ = 2147483648u;
                                                } else {
                                                    phi_2966_ = ((2147483648u | (_e1534 << bitcast<u32>(28u))) | (_e1531 & 268435455u));
                                                }
                                                let _e1552 = phi_2966_;
                                                phi_2967_ = _e1552;
                                            }
                                            let _e1554 = phi_2967_;
                                            if _e1543 {
                                                let _e1555 = (_e1534 != 7u);
                                                if _e1555 {
                                                    phi_2977_ = (_e1531 + _e1534);
                                                } else {
                                                    phi_2977_ = u32();
                                                }
                                                let _e1558 = phi_2977_;
                                                phi_2979_ = _e1558;
                                                phi_2980_ = select(true, false, _e1555);
                                            } else {
                                                phi_2979_ = u32();
                                                phi_2980_ = true;
                                            }
                                            let _e1561 = phi_2979_;
                                            let _e1563 = phi_2980_;
                                            if (_e1542 == 0u) {
                                                phi_3001_ = (_e1530 + select(0u, 1u, !(_e1543)));
                                            } else {
                                                if (_e1542 == 7u) {
                                                    phi_3000_ = 2147483648u;
                                                } else {
                                                    phi_3000_ = ((2147483648u | (_e1542 << bitcast<u32>(28u))) | (select(_e1561, _e1531, _e1563) & 268435455u));
                                                }
                                                let _e1576 = phi_3000_;
                                                phi_3001_ = _e1576;
                                            }
                                            let _e1578 = phi_3001_;
                                            phi_3005_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e700.member.member.x + _e1406), (_e700.member.member.x + _e1428), (_e700.member.member_1.x - _e1445), (_e700.member.member_1.x - _e1467)), vec4<f32>((_e700.member.member.y + _e1415), (_e700.member.member.y + _e1432), (_e700.member.member_1.y - _e1454), (_e700.member.member_1.y - _e1471)), vec4<f32>((_e700.member.member.z + _e1424), (_e700.member.member.z + _e1436), (_e700.member.member_1.z - _e1463), (_e700.member.member_1.z - _e1475))), type_49(type_28((_e700.member.member + vec4<f32>(_e1406, _e1415, _e1424, 0f)), (_e700.member.member_1 - vec4<f32>(_e1445, _e1454, _e1463, 0f))), _e1554), type_49(type_28((_e700.member.member + vec4<f32>(_e1428, _e1432, _e1436, 0f)), (_e700.member.member_1 - vec4<f32>(_e1467, _e1471, _e1475, 0f))), _e1578));
                                        }
                                        let _e1583 = phi_3005_;
                                        let _e1595 = ((_e1583.member[0].x - _e360) * _e365);
                                        let _e1596 = ((_e1583.member[0].y - _e360) * _e365);
                                        let _e1597 = ((_e1583.member[0].z - _e361) * _e365);
                                        let _e1598 = ((_e1583.member[0].w - _e361) * _e365);
                                        let _e1608 = ((_e1583.member[1].x - _e428) * _e433);
                                        let _e1609 = ((_e1583.member[1].y - _e428) * _e433);
                                        let _e1610 = ((_e1583.member[1].z - _e429) * _e433);
                                        let _e1611 = ((_e1583.member[1].w - _e429) * _e433);
                                        let _e1621 = ((_e1583.member[2].x - _e496) * _e501);
                                        let _e1622 = ((_e1583.member[2].y - _e496) * _e501);
                                        let _e1623 = ((_e1583.member[2].z - _e497) * _e501);
                                        let _e1624 = ((_e1583.member[2].w - _e497) * _e501);
                                        let _e1626 = select(_e1623, _e1621, (_e1621 < _e1623));
                                        let _e1628 = select(_e1624, _e1622, (_e1622 < _e1624));
                                        let _e1630 = select(_e1623, _e1621, (_e1621 > _e1623));
                                        let _e1632 = select(_e1624, _e1622, (_e1622 > _e1624));
                                        let _e1634 = select(_e1597, _e1595, (_e1595 < _e1597));
                                        let _e1636 = select(_e1598, _e1596, (_e1596 < _e1598));
                                        let _e1638 = select(_e1610, _e1608, (_e1608 < _e1610));
                                        let _e1640 = select(_e1611, _e1609, (_e1609 < _e1611));
                                        let _e1642 = select(_e1638, _e1634, (_e1634 > _e1638));
                                        let _e1644 = select(_e1640, _e1636, (_e1636 > _e1640));
                                        let _e1646 = select(_e1626, _e1642, (_e1642 > _e1626));
                                        let _e1648 = select(_e1628, _e1644, (_e1644 > _e1628));
                                        let _e1650 = select(_e1597, _e1595, (_e1595 > _e1597));
                                        let _e1652 = select(_e1598, _e1596, (_e1596 > _e1598));
                                        let _e1654 = select(_e1610, _e1608, (_e1608 > _e1610));
                                        let _e1656 = select(_e1611, _e1609, (_e1609 > _e1611));
                                        let _e1658 = select(_e1654, _e1650, (_e1650 < _e1654));
                                        let _e1660 = select(_e1656, _e1652, (_e1652 < _e1656));
                                        let _e1665 = -(_e1626);
                                        let _e1666 = -(_e1628);
                                        let _e1673 = (select(_e1630, _e1658, (_e1658 < _e1630)) + (select(_e1665, _e1630, (_e1630 > _e1665)) * 0.0000019073523f));
                                        let _e1674 = (select(_e1632, _e1660, (_e1660 < _e1632)) + (select(_e1666, _e1632, (_e1632 > _e1666)) * 0.0000019073523f));
                                        let _e1676 = select(_e613, _e1646, (_e1646 > _e613));
                                        let _e1678 = select(_e613, _e1648, (_e1648 > _e613));
                                        let _e1683 = (_e1676 <= select(_e1289.member, _e1673, (_e1673 < _e1289.member)));
                                        let _e1684 = (_e1678 <= select(_e1289.member, _e1674, (_e1674 < _e1289.member)));
                                        let _e1685 = (_e1676 <= _e1678);
                                        if _e1683 {
                                            if _e1684 {
                                                if _e1685 {
                                                    phi_3367_ = _e1583.member_2;
                                                } else {
                                                    phi_3367_ = _e1583.member_1;
                                                }
                                                let _e1689 = phi_3367_;
                                                let _e1710 = (_e698 % 128u);
                                                let _e1711 = (_e1710 < 128u);
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_8[_e1710] = _e1689.member_1;
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_7[_e1710] = _e1689.member.member.x;
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_6[_e1710] = _e1689.member.member.y;
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_5[_e1710] = _e1689.member.member.z;
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_4[_e1710] = _e1689.member.member_1.x;
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_3[_e1710] = _e1689.member.member_1.y;
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_2[_e1710] = _e1689.member.member_1.z;
                                                if _e1711 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_9[_e1710] = select(_e1676, _e1678, _e1685);
                                                if _e1685 {
                                                    phi_3443_ = _e1583.member_1;
                                                } else {
                                                    phi_3443_ = _e1583.member_2;
                                                }
                                                let _e1724 = phi_3443_;
                                                phi_3444_ = (_e698 + 1u);
                                                phi_3445_ = _e1724;
                                            } else {
                                                phi_3444_ = u32();
                                                phi_3445_ = type_49();
                                            }
                                            let _e1726 = phi_3444_;
                                            let _e1728 = phi_3445_;
                                            phi_3447_ = _e1726;
                                            phi_3448_ = _e1728;
                                            phi_3449_ = select(true, false, _e1684);
                                        } else {
                                            phi_3447_ = u32();
                                            phi_3448_ = type_49();
                                            phi_3449_ = true;
                                        }
                                        let _e1731 = phi_3447_;
                                        let _e1733 = phi_3448_;
                                        let _e1735 = phi_3449_;
                                        if _e1735 {
                                            if _e1683 {
                                                phi_3458_ = _e1583.member_1;
                                            } else {
                                                phi_3458_ = _e1583.member_2;
                                            }
                                            let _e1739 = phi_3458_;
                                            phi_3463_ = select(_e1684, true, _e1683);
                                            phi_3465_ = _e1739;
                                        } else {
                                            phi_3463_ = _e696;
                                            phi_3465_ = _e1733;
                                        }
                                        let _e1742 = phi_3463_;
                                        let _e1744 = phi_3465_;
                                        phi_3469_ = _e1742;
                                        phi_3470_ = select(_e1731, _e698, _e1735);
                                        phi_3471_ = _e1744;
                                    }
                                    let _e1747 = phi_3469_;
                                    let _e1749 = phi_3470_;
                                    let _e1751 = phi_3471_;
                                    if _e704 {
                                        phi_3481_ = select(_e698, 0u, _e1289.member_1);
                                        phi_3482_ = _e700;
                                    } else {
                                        phi_3481_ = _e1749;
                                        phi_3482_ = _e1751;
                                    }
                                    let _e1755 = phi_3481_;
                                    let _e1757 = phi_3482_;
                                    phi_3881_ = _e1287;
                                    phi_3483_ = _e1289;
                                    phi_3484_ = (_e659 - 1u);
                                    phi_3485_ = select(_e1747, false, _e704);
                                    phi_3486_ = _e1755;
                                    phi_3487_ = _e1757;
                                } else {
                                    phi_3881_ = _e655;
                                    phi_3483_ = _e657;
                                    phi_3484_ = _e659;
                                    phi_3485_ = _e696;
                                    phi_3486_ = _e698;
                                    phi_3487_ = _e700;
                                }
                                let _e1760 = phi_3881_;
                                let _e1762 = phi_3483_;
                                let _e1764 = phi_3484_;
                                let _e1766 = phi_3485_;
                                let _e1768 = phi_3486_;
                                let _e1770 = phi_3487_;
                                phi_3880_ = _e1760;
                                phi_3488_ = _e1762;
                                phi_3489_ = _e1764;
                                phi_3490_ = _e1766;
                                phi_3491_ = _e1768;
                                phi_3492_ = _e1770;
                            } else {
                                phi_3880_ = _e655;
                                phi_3488_ = type_38();
                                phi_3489_ = u32();
                                phi_3490_ = bool();
                                phi_3491_ = u32();
                                phi_3492_ = type_49();
                            }
                            let _e1772 = phi_3880_;
                            let _e1774 = phi_3488_;
                            let _e1776 = phi_3489_;
                            let _e1778 = phi_3490_;
                            let _e1780 = phi_3491_;
                            let _e1782 = phi_3492_;
                            phi_3879_ = _e1772;
                            phi_1063_ = _e1774;
                            phi_1066_ = _e1776;
                            phi_1068_ = _e1778;
                            phi_1070_ = _e1780;
                            phi_1072_ = _e1782;
                            phi_3493_ = _e669;
                        } else {
                            phi_3879_ = _e655;
                            phi_1063_ = type_38();
                            phi_1066_ = u32();
                            phi_1068_ = bool();
                            phi_1070_ = u32();
                            phi_1072_ = type_49();
                            phi_3493_ = false;
                        }
                        let _e1784 = phi_3879_;
                        let _e1786 = phi_1063_;
                        let _e1788 = phi_1066_;
                        let _e1790 = phi_1068_;
                        let _e1792 = phi_1070_;
                        let _e1794 = phi_1072_;
                        let _e1796 = phi_3493_;
                        continue;
                        continuing {
                            phi_3727_ = _e1784;
                            phi_1062_ = _e1786;
                            phi_1065_ = _e1788;
                            phi_1067_ = _e1790;
                            phi_1069_ = _e1792;
                            phi_1071_ = _e1794;
                            phi_3878_ = _e1784;
                            break if !(_e1796);
                        }
                    }
                    let _e1799 = phi_3878_;
                    if _e1799 {
                        break;
                    }
                    let _e1801 = local_10;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_5.member[_e144] = select(0u, 1u, _e1801.member_1);
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
