struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_15 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
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

struct type_40 {
    member: array<type_29>,
}

struct type_42 {
    member: f32,
    member_1: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_32,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_15;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(4) 
var<storage> global_5: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

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
    var phi_1062_: type_42;
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
    var phi_1188_: type_42;
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
    var phi_2192_: type_28;
    var phi_2194_: type_28;
    var phi_2195_: bool;
    var phi_2199_: type_28;
    var phi_2200_: type_28;
    var phi_2201_: type_28;
    var phi_2202_: bool;
    var phi_2206_: type_28;
    var phi_2207_: bool;
    var phi_2208_: type_28;
    var phi_2209_: bool;
    var phi_2210_: bool;
    var phi_2211_: type_28;
    var phi_2212_: bool;
    var phi_2213_: bool;
    var phi_2221_: type_28;
    var phi_2222_: bool;
    var phi_2226_: type_28;
    var phi_2237_: type_42;
    var phi_2238_: type_42;
    var phi_1189_: type_42;
    var phi_3718_: bool;
    var local_10: type_42;
    var phi_3879_: bool;
    var phi_3476_: type_42;
    var phi_3477_: bool;
    var phi_3478_: u32;
    var phi_3479_: type_49;
    var phi_3878_: bool;
    var phi_3480_: type_42;
    var phi_3481_: bool;
    var phi_3482_: u32;
    var phi_3483_: u32;
    var phi_3484_: type_49;
    var phi_3877_: bool;
    var phi_3485_: type_42;
    var phi_3486_: bool;
    var phi_3487_: u32;
    var phi_3488_: u32;
    var phi_3489_: type_49;
    var phi_3876_: bool;
    var phi_1063_: type_42;
    var phi_1066_: bool;
    var phi_1068_: u32;
    var phi_1070_: u32;
    var phi_1072_: type_49;
    var phi_3490_: bool;
    var phi_3875_: bool;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_4.member));
            let _e92 = arrayLength((&global_2.member));
            let _e100 = global_3.member[0u][0u];
            let _e104 = global_3.member[0u][1u];
            let _e108 = global_3.member[0u][2u];
            let _e112 = global_3.member[0u][3u];
            let _e116 = global_3.member[1u][0u];
            let _e120 = global_3.member[1u][1u];
            let _e124 = global_3.member[1u][2u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e140 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e100), bitcast<i32>(_e104), bitcast<i32>(_e108));
            local = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            let _e146 = (_e88.x + (_e88.y * 2097152u));
            let _e147 = (_e146 < arrayLength((&global_5.member)));
            if _e147 {
                let _e148 = (_e146 < arrayLength((&global_6.member)));
                if _e148 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e156 = global_5.member[_e146].member_2[0u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_5.member[_e146].member_2[1u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_5.member[_e146].member_2[2u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_5.member[_e146].member[0u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_5.member[_e146].member[1u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_5.member[_e146].member[2u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e195 = select(_e165, _e158, (_e165 < _e158));
                    let _e197 = select(_e172, _e195, (_e172 < _e195));
                    let _e199 = select(_e179, _e197, (_e179 < _e197));
                    let _e201 = select(_e186, _e199, (_e186 < _e199));
                    let _e203 = select(_e193, _e201, (_e193 < _e201));
                    let _e207 = global_5.member[_e146].member_1;
                    let _e208 = bitcast<u32>(_e207);
                    let _e209 = (_e208 & 2147483647u);
                    let _e216 = global_5.member[_e146].member_3;
                    let _e217 = bitcast<u32>(_e216);
                    let _e218 = (_e217 & 2147483647u);
                    let _e222 = (((select(_e209, _e203, (_e209 < _e203)) < 2139095040u) && (_e218 <= 2139095040u)) && (_e197 > 0u));
                    if _e222 {
                        let _e225 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                        if (_e225 >= 8388608u) {
                            phi_373_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_373_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_373_;
                        phi_374_ = _e239;
                    } else {
                        phi_374_ = 0i;
                    }
                    let _e241 = phi_374_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_384_ = true;
                    } else {
                        phi_384_ = (_e165 == _e197);
                    }
                    let _e245 = phi_384_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_394_ = _e247;
                        phi_395_ = _e247;
                        phi_397_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_394_ = u32();
                        phi_395_ = 0u;
                        phi_397_ = true;
                    }
                    let _e251 = phi_394_;
                    let _e253 = phi_395_;
                    let _e255 = phi_397_;
                    if _e255 {
                        phi_402_ = (_e253 + 1u);
                    } else {
                        phi_402_ = 0u;
                    }
                    let _e259 = phi_402_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_415_ = -126i;
                    } else {
                        phi_415_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_415_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_435_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_5.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_453_ = _e298[0];
                    } else {
                        phi_453_ = _e298[1];
                    }
                    let _e303 = phi_453_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_459_ = _e298[2];
                    } else {
                        phi_459_ = _e303;
                    }
                    let _e307 = phi_459_;
                    let _e308 = bitcast<u32>(_e307);
                    let _e310 = ((_e308 & 2139095040u) != 0u);
                    let _e324 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e308 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e308 & 2147483648u))), _e307, _e310) * _e271) * select(0.00000011920929f, 1f, _e310)) * _e277);
                    let _e325 = global_5.member[_e146].member_2;
                    if _e299 {
                        phi_499_ = _e325[0];
                    } else {
                        phi_499_ = _e325[1];
                    }
                    let _e329 = phi_499_;
                    if _e304 {
                        phi_505_ = _e325[2];
                    } else {
                        phi_505_ = _e329;
                    }
                    let _e332 = phi_505_;
                    let _e333 = bitcast<u32>(_e332);
                    let _e335 = ((_e333 & 2139095040u) != 0u);
                    let _e349 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e333 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e333 & 2147483648u))), _e332, _e335) * _e288) * select(0.00000011920929f, 1f, _e335)) * _e294);
                    let _e353 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e353 {
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                        phi_557_ = select(0.00000000000011368684f, _e357, (_e357 > 0.00000000000011368684f));
                    } else {
                        phi_557_ = 0f;
                    }
                    let _e361 = phi_557_;
                    let _e362 = (_e324 + _e361);
                    let _e363 = (_e324 - _e361);
                    let _e364 = select(_e349, 0f, _e353);
                    if _e353 {
                        phi_569_ = 38685626000000000000000000f;
                    } else {
                        phi_569_ = (1f / _e349);
                    }
                    let _e367 = phi_569_;
                    let _e368 = (_e259 == 0u);
                    if _e368 {
                        phi_578_ = _e298[0];
                    } else {
                        phi_578_ = _e298[1];
                    }
                    let _e372 = phi_578_;
                    let _e373 = (_e259 == 2u);
                    if _e373 {
                        phi_584_ = _e298[2];
                    } else {
                        phi_584_ = _e372;
                    }
                    let _e376 = phi_584_;
                    let _e377 = bitcast<u32>(_e376);
                    let _e379 = ((_e377 & 2139095040u) != 0u);
                    let _e393 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e377 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e377 & 2147483648u))), _e376, _e379) * _e271) * select(0.00000011920929f, 1f, _e379)) * _e277);
                    if _e368 {
                        phi_624_ = _e325[0];
                    } else {
                        phi_624_ = _e325[1];
                    }
                    let _e397 = phi_624_;
                    if _e373 {
                        phi_630_ = _e325[2];
                    } else {
                        phi_630_ = _e397;
                    }
                    let _e400 = phi_630_;
                    let _e401 = bitcast<u32>(_e400);
                    let _e403 = ((_e401 & 2139095040u) != 0u);
                    let _e417 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e400, _e403) * _e288) * select(0.00000011920929f, 1f, _e403)) * _e294);
                    let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e421 {
                        let _e425 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) * 0.00000011920929f);
                        phi_682_ = select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f));
                    } else {
                        phi_682_ = 0f;
                    }
                    let _e429 = phi_682_;
                    let _e430 = (_e393 + _e429);
                    let _e431 = (_e393 - _e429);
                    let _e432 = select(_e417, 0f, _e421);
                    if _e421 {
                        phi_694_ = 38685626000000000000000000f;
                    } else {
                        phi_694_ = (1f / _e417);
                    }
                    let _e435 = phi_694_;
                    let _e436 = (_e261 == 0u);
                    if _e436 {
                        phi_703_ = _e298[0];
                    } else {
                        phi_703_ = _e298[1];
                    }
                    let _e440 = phi_703_;
                    let _e441 = (_e261 == 2u);
                    if _e441 {
                        phi_709_ = _e298[2];
                    } else {
                        phi_709_ = _e440;
                    }
                    let _e444 = phi_709_;
                    let _e445 = bitcast<u32>(_e444);
                    let _e447 = ((_e445 & 2139095040u) != 0u);
                    let _e461 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e445 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e445 & 2147483648u))), _e444, _e447) * _e271) * select(0.00000011920929f, 1f, _e447)) * _e277);
                    if _e436 {
                        phi_749_ = _e325[0];
                    } else {
                        phi_749_ = _e325[1];
                    }
                    let _e465 = phi_749_;
                    if _e441 {
                        phi_755_ = _e325[2];
                    } else {
                        phi_755_ = _e465;
                    }
                    let _e468 = phi_755_;
                    let _e469 = bitcast<u32>(_e468);
                    let _e471 = ((_e469 & 2139095040u) != 0u);
                    let _e485 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e469 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e469 & 2147483648u))), _e468, _e471) * _e288) * select(0.00000011920929f, 1f, _e471)) * _e294);
                    let _e489 = (bitcast<f32>((bitcast<u32>(_e485) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e489 {
                        let _e493 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) * 0.00000011920929f);
                        phi_807_ = select(0.00000000000011368684f, _e493, (_e493 > 0.00000000000011368684f));
                    } else {
                        phi_807_ = 0f;
                    }
                    let _e497 = phi_807_;
                    let _e498 = (_e461 + _e497);
                    let _e499 = (_e461 - _e497);
                    let _e500 = select(_e485, 0f, _e489);
                    if _e489 {
                        phi_819_ = 38685626000000000000000000f;
                    } else {
                        phi_819_ = (1f / _e485);
                    }
                    let _e503 = phi_819_;
                    let _e506 = bitcast<f32>((bitcast<u32>(_e324) & 2147483647u));
                    let _e509 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                    let _e511 = select(_e509, _e506, (_e506 > _e509));
                    let _e514 = bitcast<f32>((bitcast<u32>(_e461) & 2147483647u));
                    let _e517 = (_e128 + _e241);
                    if (_e222 && (select(_e514, _e511, (_e511 > _e514)) <= 1099511600000f)) {
                        let _e527 = ((_e209 & 8388607u) | (select(0u, 1u, ((_e209 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e530 = bitcast<i32>((_e209 >> bitcast<u32>(23i)));
                        let _e534 = (_e527 == 0u);
                        let _e537 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e527)), 32u, _e534)) - 8i);
                        if (_e530 == 255i) {
                            phi_874_ = 255i;
                        } else {
                            phi_874_ = (((_e530 + select(0i, 1i, (_e530 == 0i))) - _e537) + _e517);
                        }
                        let _e545 = phi_874_;
                        let _e555 = (_e545 <= 0i);
                        if _e555 {
                            phi_897_ = u32();
                        } else {
                            if _e534 {
                                phi_896_ = u32();
                            } else {
                                phi_896_ = select(((bitcast<u32>(_e545) << bitcast<u32>(23i)) | ((_e527 << bitcast<u32>(((_e537 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e545 >= 255i));
                            }
                            let _e559 = phi_896_;
                            phi_897_ = _e559;
                        }
                        let _e561 = phi_897_;
                        let _e573 = ((_e218 & 8388607u) | (select(0u, 1u, ((_e218 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e576 = bitcast<i32>((_e218 >> bitcast<u32>(23i)));
                        let _e580 = (_e573 == 0u);
                        let _e583 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e573)), 32u, _e580)) - 8i);
                        if (_e576 == 255i) {
                            phi_934_ = 255i;
                        } else {
                            phi_934_ = (((_e576 + select(0i, 1i, (_e576 == 0i))) - _e583) + _e517);
                        }
                        let _e591 = phi_934_;
                        let _e601 = (_e591 <= 0i);
                        if _e601 {
                            phi_957_ = u32();
                        } else {
                            if _e580 {
                                phi_956_ = u32();
                            } else {
                                phi_956_ = select(((bitcast<u32>(_e591) << bitcast<u32>(23i)) | ((_e573 << bitcast<u32>(((_e583 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e591 >= 255i));
                            }
                            let _e605 = phi_956_;
                            phi_957_ = _e605;
                        }
                        let _e607 = phi_957_;
                        phi_965_ = bitcast<f32>(((_e217 & 2147483648u) | select(_e607, 0u, select(_e580, true, _e601))));
                        phi_966_ = bitcast<f32>(((_e208 & 2147483648u) | select(_e561, 0u, select(_e534, true, _e555))));
                    } else {
                        phi_965_ = 0f;
                        phi_966_ = 1f;
                    }
                    let _e613 = phi_965_;
                    let _e615 = phi_966_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e619 = (_e260 % 3u);
                    let _e620 = (_e619 < 3u);
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e622 = local_1[_e619];
                    let _e625 = (_e259 % 3u);
                    let _e626 = (_e625 < 3u);
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e628 = local_1[_e625];
                    let _e631 = (_e261 % 3u);
                    let _e632 = (_e631 < 3u);
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e634 = local_1[_e631];
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e639 = local[_e619];
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e643 = local[_e625];
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e647 = local[_e631];
                    phi_3724_ = false;
                    phi_1062_ = type_42(_e613, false);
                    phi_1065_ = (_e615 <= _e613);
                    phi_1067_ = ((3u * _e90) + 1u);
                    phi_1069_ = 0u;
                    phi_1071_ = type_49(type_32(vec4<f32>((f32(_e622) * _e140), (f32(_e628) * _e140), (f32(_e634) * _e140), 0f), vec4<f32>((f32(_e639) * _e140), (f32(_e643) * _e140), (f32(_e647) * _e140), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    loop {
                        let _e657 = phi_3724_;
                        let _e659 = phi_1062_;
                        let _e661 = phi_1065_;
                        let _e663 = phi_1067_;
                        let _e665 = phi_1069_;
                        let _e667 = phi_1071_;
                        local_11 = _e659;
                        if _e661 {
                            phi_1082_ = true;
                        } else {
                            phi_1082_ = (_e665 > 0u);
                        }
                        let _e670 = phi_1082_;
                        if _e670 {
                            let _e671 = (_e663 > 0u);
                            if _e671 {
                                if _e661 {
                                    phi_1168_ = _e661;
                                    phi_1169_ = _e665;
                                    phi_1170_ = _e667;
                                } else {
                                    let _e672 = (_e665 - 1u);
                                    let _e673 = (_e672 % 128u);
                                    let _e674 = (_e673 < 128u);
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e676 = local_7[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e678 = local_6[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e680 = local_5[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e682 = local_4[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e684 = local_3[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e686 = local_2[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e691 = local_8[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3875_ = true;
                                        break;
                                    }
                                    let _e694 = local_9[_e673];
                                    phi_1168_ = (_e694 <= _e659.member);
                                    phi_1169_ = _e672;
                                    phi_1170_ = type_49(type_32(vec4<f32>(_e676, _e678, _e680, 0f), vec4<f32>(_e682, _e684, _e686, 0f)), _e691);
                                }
                                let _e698 = phi_1168_;
                                let _e700 = phi_1169_;
                                let _e702 = phi_1170_;
                                if _e698 {
                                    if ((_e702.member_1 & 2147483648u) != 0u) {
                                        phi_1188_ = _e659;
                                        phi_1191_ = type_7(0u, ((_e702.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1152 = phi_1188_;
                                            let _e1154 = phi_1191_;
                                            local_10 = _e1152;
                                            local_12 = _e1152;
                                            if (_e1154.member < _e1154.member_1) {
                                                phi_1192_ = type_7((_e1154.member + 1u), _e1154.member_1);
                                                phi_1214_ = type_7(1u, _e1154.member);
                                            } else {
                                                phi_1192_ = _e1154;
                                                phi_1214_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1167 = phi_1192_;
                                            let _e1169 = phi_1214_;
                                            let _e1173 = (bitcast<i32>(_e1169.member) != 0i);
                                            if _e1173 {
                                                let _e1174 = ((_e702.member_1 & 268435455u) + _e1169.member_1);
                                                let _e1175 = (_e1174 < _e92);
                                                if _e1175 {
                                                    if _e1175 {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1179 = global_2.member[_e1174].member_1;
                                                    phi_1235_ = _e1179;
                                                } else {
                                                    phi_1235_ = 4294967295u;
                                                }
                                                let _e1181 = phi_1235_;
                                                if (_e1174 >= _e92) {
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1175 {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    if (_e619 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1188 = global_2.member[_e1174].member[_e619];
                                                    if (_e625 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1194 = global_2.member[_e1174].member[_e625];
                                                    if (_e631 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1200 = global_2.member[_e1174].member[_e631];
                                                    let _e1202 = (3u + _e619);
                                                    if (_e1202 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1208 = global_2.member[_e1174].member[_e1202];
                                                    let _e1209 = (3u + _e625);
                                                    if (_e1209 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1215 = global_2.member[_e1174].member[_e1209];
                                                    let _e1216 = (3u + _e631);
                                                    if (_e1216 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1222 = global_2.member[_e1174].member[_e1216];
                                                    let _e1224 = (6u + _e619);
                                                    if (_e1224 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1230 = global_2.member[_e1174].member[_e1224];
                                                    let _e1231 = (6u + _e625);
                                                    if (_e1231 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1237 = global_2.member[_e1174].member[_e1231];
                                                    let _e1238 = (6u + _e631);
                                                    if (_e1238 < 9u) {
                                                    } else {
                                                        phi_3718_ = true;
                                                        break;
                                                    }
                                                    let _e1244 = global_2.member[_e1174].member[_e1238];
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1188, _e1194, _e1200), array<f32, 3>(_e1208, _e1215, _e1222), array<f32, 3>(_e1230, _e1237, _e1244));
                                                }
                                                let _e1248 = phi_1327_;
                                                let _e1256 = (_e1248[0][2] - _e461);
                                                let _e1259 = (((_e1248[0][0] - _e324) * _e500) - (_e1256 * _e364));
                                                let _e1262 = (((_e1248[0][1] - _e393) * _e500) - (_e1256 * _e432));
                                                let _e1269 = (_e1248[1][2] - _e461);
                                                let _e1272 = (((_e1248[1][0] - _e324) * _e500) - (_e1269 * _e364));
                                                let _e1275 = (((_e1248[1][1] - _e393) * _e500) - (_e1269 * _e432));
                                                let _e1282 = (_e1248[2][2] - _e461);
                                                let _e1285 = (((_e1248[2][0] - _e324) * _e500) - (_e1282 * _e364));
                                                let _e1288 = (((_e1248[2][1] - _e393) * _e500) - (_e1282 * _e432));
                                                let _e1289 = (_e1285 * _e1275);
                                                let _e1290 = (_e1288 * _e1272);
                                                let _e1291 = (_e1259 * _e1288);
                                                let _e1292 = (_e1262 * _e1285);
                                                let _e1293 = (_e1272 * _e1262);
                                                let _e1294 = (_e1275 * _e1259);
                                                let _e1299 = (((_e1289 >= _e1290) && (_e1291 >= _e1292)) && (_e1293 >= _e1294));
                                                if (_e1299 || (((_e1289 <= _e1290) && (_e1291 <= _e1292)) && (_e1293 <= _e1294))) {
                                                    let _e1306 = select(-1f, 1f, _e1299);
                                                    let _e1308 = ((_e1289 - _e1290) * _e1306);
                                                    let _e1310 = select(0f, _e1308, (_e1308 > 0f));
                                                    let _e1312 = ((_e1291 - _e1292) * _e1306);
                                                    let _e1314 = select(0f, _e1312, (_e1312 > 0f));
                                                    let _e1316 = ((_e1293 - _e1294) * _e1306);
                                                    let _e1318 = select(0f, _e1316, (_e1316 > 0f));
                                                    let _e1320 = ((_e1310 + _e1314) + _e1318);
                                                    if (_e1320 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2211_ = type_28();
                                                        phi_2212_ = true;
                                                        phi_2213_ = false;
                                                    } else {
                                                        let _e1323 = select(_e1272, _e1259, (_e1259 < _e1272));
                                                        if (select(_e1285, _e1323, (_e1323 < _e1285)) > 0f) {
                                                            phi_1479_ = true;
                                                        } else {
                                                            let _e1328 = select(_e1272, _e1259, (_e1259 > _e1272));
                                                            phi_1479_ = (select(_e1285, _e1328, (_e1328 > _e1285)) < 0f);
                                                        }
                                                        let _e1333 = phi_1479_;
                                                        if _e1333 {
                                                            phi_2208_ = type_28();
                                                            phi_2209_ = true;
                                                            phi_2210_ = false;
                                                        } else {
                                                            let _e1335 = select(_e1275, _e1262, (_e1262 < _e1275));
                                                            if (select(_e1288, _e1335, (_e1335 < _e1288)) > 0f) {
                                                                phi_1508_ = true;
                                                            } else {
                                                                let _e1340 = select(_e1275, _e1262, (_e1262 > _e1275));
                                                                phi_1508_ = (select(_e1288, _e1340, (_e1340 > _e1288)) < 0f);
                                                            }
                                                            let _e1345 = phi_1508_;
                                                            if _e1345 {
                                                                phi_2206_ = type_28();
                                                                phi_2207_ = false;
                                                            } else {
                                                                let _e1347 = select(_e1248[1][0], _e1248[0][0], (_e1248[0][0] < _e1248[1][0]));
                                                                let _e1351 = select(_e1248[1][0], _e1248[0][0], (_e1248[0][0] > _e1248[1][0]));
                                                                let _e1355 = select(_e1248[1][1], _e1248[0][1], (_e1248[0][1] < _e1248[1][1]));
                                                                let _e1359 = select(_e1248[1][1], _e1248[0][1], (_e1248[0][1] > _e1248[1][1]));
                                                                let _e1363 = select(_e1248[1][2], _e1248[0][2], (_e1248[0][2] < _e1248[1][2]));
                                                                let _e1367 = select(_e1248[1][2], _e1248[0][2], (_e1248[0][2] > _e1248[1][2]));
                                                                let _e1372 = ((select(_e1248[2][0], _e1347, (_e1347 < _e1248[2][0])) - _e362) * _e367);
                                                                let _e1373 = ((select(_e1248[2][0], _e1351, (_e1351 > _e1248[2][0])) - _e363) * _e367);
                                                                let _e1376 = ((select(_e1248[2][1], _e1355, (_e1355 < _e1248[2][1])) - _e430) * _e435);
                                                                let _e1377 = ((select(_e1248[2][1], _e1359, (_e1359 > _e1248[2][1])) - _e431) * _e435);
                                                                let _e1380 = ((select(_e1248[2][2], _e1363, (_e1363 < _e1248[2][2])) - _e498) * _e503);
                                                                let _e1381 = ((select(_e1248[2][2], _e1367, (_e1367 > _e1248[2][2])) - _e499) * _e503);
                                                                let _e1383 = select(_e1381, _e1380, (_e1380 < _e1381));
                                                                let _e1385 = select(_e1381, _e1380, (_e1380 > _e1381));
                                                                let _e1387 = select(_e1373, _e1372, (_e1372 < _e1373));
                                                                let _e1389 = select(_e1377, _e1376, (_e1376 < _e1377));
                                                                let _e1391 = select(_e1389, _e1387, (_e1387 > _e1389));
                                                                let _e1393 = select(_e1383, _e1391, (_e1391 > _e1383));
                                                                let _e1395 = select(_e1373, _e1372, (_e1372 > _e1373));
                                                                let _e1397 = select(_e1377, _e1376, (_e1376 > _e1377));
                                                                let _e1399 = select(_e1397, _e1395, (_e1395 < _e1397));
                                                                let _e1401 = select(_e1385, _e1399, (_e1399 < _e1385));
                                                                let _e1402 = -(_e1383);
                                                                let _e1408 = select(_e615, _e1393, (_e1393 > _e615));
                                                                if (_e1408 > (_e1401 + (select(_e1402, _e1385, (_e1385 > _e1402)) * 0.0000019073523f))) {
                                                                    phi_2201_ = type_28();
                                                                    phi_2202_ = true;
                                                                } else {
                                                                    let _e1410 = (_e1408 > _e1152.member);
                                                                    if _e1410 {
                                                                        phi_2200_ = type_28();
                                                                    } else {
                                                                        let _e1411 = vec3<f32>(_e1248[0][0], _e1248[0][1], _e1248[0][2]);
                                                                        let _e1412 = vec3<f32>(_e1248[1][0], _e1248[1][1], _e1248[1][2]);
                                                                        let _e1413 = vec3<f32>(_e1248[2][0], _e1248[2][1], _e1248[2][2]);
                                                                        let _e1414 = (_e1248[1][0] - _e1248[0][0]);
                                                                        let _e1415 = (_e1248[1][1] - _e1248[0][1]);
                                                                        let _e1416 = (_e1248[1][2] - _e1248[0][2]);
                                                                        let _e1417 = vec3<f32>(_e1414, _e1415, _e1416);
                                                                        let _e1418 = (_e1248[2][0] - _e1248[1][0]);
                                                                        let _e1419 = (_e1248[2][1] - _e1248[1][1]);
                                                                        let _e1420 = (_e1248[2][2] - _e1248[1][2]);
                                                                        let _e1421 = vec3<f32>(_e1418, _e1419, _e1420);
                                                                        let _e1422 = (_e1248[0][0] - _e1248[2][0]);
                                                                        let _e1423 = (_e1248[0][1] - _e1248[2][1]);
                                                                        let _e1424 = (_e1248[0][2] - _e1248[2][2]);
                                                                        let _e1425 = vec3<f32>(_e1422, _e1423, _e1424);
                                                                        let _e1428 = bitcast<f32>((bitcast<u32>(_e1414) & 2147483647u));
                                                                        let _e1431 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                        let _e1433 = select(_e1431, _e1428, (_e1428 > _e1431));
                                                                        let _e1436 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1438 = select(_e1436, _e1433, (_e1433 > _e1436));
                                                                        let _e1441 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                        let _e1444 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                        let _e1446 = select(_e1444, _e1441, (_e1441 > _e1444));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                        let _e1457 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                        let _e1459 = select(_e1457, _e1454, (_e1454 > _e1457));
                                                                        let _e1462 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                        let _e1464 = select(_e1462, _e1459, (_e1459 > _e1462));
                                                                        let _e1466 = select(_e1451, _e1438, (_e1438 > _e1451));
                                                                        let _e1468 = select(_e1464, _e1466, (_e1466 > _e1464));
                                                                        if (_e1438 == _e1468) {
                                                                            phi_1927_ = _e1275;
                                                                            phi_1928_ = _e1272;
                                                                            phi_1929_ = _e1262;
                                                                            phi_1930_ = _e1259;
                                                                            phi_1931_ = _e1411;
                                                                            phi_1932_ = _e1425;
                                                                            phi_1933_ = _e1421;
                                                                            phi_1934_ = _e1417;
                                                                        } else {
                                                                            let _e1470 = (_e1451 == _e1468);
                                                                            let _e1475 = vec3(_e1470);
                                                                            phi_1927_ = select(_e1262, _e1288, _e1470);
                                                                            phi_1928_ = select(_e1259, _e1285, _e1470);
                                                                            phi_1929_ = select(_e1288, _e1275, _e1470);
                                                                            phi_1930_ = select(_e1285, _e1272, _e1470);
                                                                            phi_1931_ = select(_e1413, _e1412, _e1475);
                                                                            phi_1932_ = select(_e1421, _e1417, _e1475);
                                                                            phi_1933_ = select(_e1417, _e1425, _e1475);
                                                                            phi_1934_ = select(_e1425, _e1421, _e1475);
                                                                        }
                                                                        let _e1481 = phi_1927_;
                                                                        let _e1483 = phi_1928_;
                                                                        let _e1485 = phi_1929_;
                                                                        let _e1487 = phi_1930_;
                                                                        let _e1489 = phi_1931_;
                                                                        let _e1491 = phi_1932_;
                                                                        let _e1493 = phi_1933_;
                                                                        let _e1495 = phi_1934_;
                                                                        let _e1502 = ((_e1493.y * _e1491.z) - (_e1491.y * _e1493.z));
                                                                        let _e1507 = ((_e1493.z * _e1491.x) - (_e1491.z * _e1493.x));
                                                                        let _e1510 = ((_e1493.x * _e1491.y) - (_e1491.x * _e1493.y));
                                                                        if (_e1310 >= _e1314) {
                                                                            phi_1971_ = select(true, false, (_e1310 >= _e1318));
                                                                        } else {
                                                                            phi_1971_ = true;
                                                                        }
                                                                        let _e1515 = phi_1971_;
                                                                        if _e1515 {
                                                                            phi_1980_ = select(_e1413, _e1412, vec3((_e1314 >= _e1318)));
                                                                        } else {
                                                                            phi_1980_ = _e1411;
                                                                        }
                                                                        let _e1520 = phi_1980_;
                                                                        let _e1531 = (((_e1502 * (_e1520.x - _e324)) + (_e1507 * (_e1520.y - _e393))) + (_e1510 * (_e1520.z - _e461)));
                                                                        let _e1536 = (((_e1502 * _e364) + (_e1507 * _e432)) + (_e1510 * _e500));
                                                                        let _e1537 = (_e1483 - _e1487);
                                                                        let _e1538 = (_e1481 - _e1485);
                                                                        let _e1546 = (-(((_e1487 * _e1537) + (_e1485 * _e1538))) / ((_e1537 * _e1537) + (_e1538 * _e1538)));
                                                                        let _e1548 = select(1f, _e1546, (_e1546 < 1f));
                                                                        let _e1550 = select(0f, _e1548, (_e1548 > 0f));
                                                                        let _e1563 = ((_e1489.x + (_e1495.x * _e1550)) - _e324);
                                                                        let _e1564 = ((_e1489.y + (_e1495.y * _e1550)) - _e393);
                                                                        let _e1565 = ((_e1489.z + (_e1495.z * _e1550)) - _e461);
                                                                        let _e1566 = (_e1565 / _e500);
                                                                        let _e1578 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                                        let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                                        let _e1586 = bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u));
                                                                        let _e1588 = select(_e1586, _e1583, (_e1583 > _e1586));
                                                                        let _e1594 = bitcast<f32>((bitcast<u32>(_e1502) & 2147483647u));
                                                                        let _e1597 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
                                                                        let _e1599 = select(_e1597, _e1594, (_e1594 > _e1597));
                                                                        let _e1602 = bitcast<f32>((bitcast<u32>(_e1510) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1502 * _e1563) + (_e1507 * _e1564)) + (_e1510 * _e1565)) - _e1531)) & 2147483647u)) <= ((0.0000009536743f * select(_e1468, _e1588, (_e1588 > _e1468))) * select(_e1602, _e1599, (_e1599 > _e1602)))) {
                                                                            let _e1612 = bitcast<f32>((bitcast<u32>(_e1493.x) & 2147483647u));
                                                                            let _e1615 = bitcast<f32>((bitcast<u32>(_e1493.y) & 2147483647u));
                                                                            let _e1617 = select(_e1615, _e1612, (_e1612 > _e1615));
                                                                            let _e1620 = bitcast<f32>((bitcast<u32>(_e1493.z) & 2147483647u));
                                                                            let _e1626 = bitcast<f32>((bitcast<u32>(_e1491.x) & 2147483647u));
                                                                            let _e1629 = bitcast<f32>((bitcast<u32>(_e1491.y) & 2147483647u));
                                                                            let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                                            let _e1634 = bitcast<f32>((bitcast<u32>(_e1491.z) & 2147483647u));
                                                                            let _e1638 = (bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u)) > ((0.0000038146973f * select(_e1620, _e1617, (_e1617 > _e1620))) * select(_e1634, _e1631, (_e1631 > _e1634))));
                                                                            if _e1638 {
                                                                                phi_2145_ = (_e1531 / _e1536);
                                                                            } else {
                                                                                phi_2145_ = f32();
                                                                            }
                                                                            let _e1641 = phi_2145_;
                                                                            phi_2147_ = _e1641;
                                                                            phi_2148_ = select(true, false, _e1638);
                                                                        } else {
                                                                            phi_2147_ = f32();
                                                                            phi_2148_ = true;
                                                                        }
                                                                        let _e1644 = phi_2147_;
                                                                        let _e1646 = phi_2148_;
                                                                        if _e1646 {
                                                                            let _e1654 = (((_e1502 * (_e1563 - (_e364 * _e1566))) + (_e1507 * (_e1564 - (_e432 * _e1566)))) / _e1536);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1654) & 2147483647u)) <= _e1468) {
                                                                                phi_2168_ = (_e1566 + _e1654);
                                                                            } else {
                                                                                phi_2168_ = _e1566;
                                                                            }
                                                                            let _e1661 = phi_2168_;
                                                                            phi_2169_ = _e1661;
                                                                        } else {
                                                                            phi_2169_ = _e1644;
                                                                        }
                                                                        let _e1663 = phi_2169_;
                                                                        let _e1665 = select(_e1401, _e1663, (_e1663 < _e1401));
                                                                        let _e1667 = select(_e1393, _e1665, (_e1665 > _e1393));
                                                                        if (_e1667 >= _e615) {
                                                                            let _e1669 = (_e1667 <= _e1152.member);
                                                                            if _e1669 {
                                                                                let _e1670 = (1f / _e1320);
                                                                                phi_2192_ = type_28(_e1667, (_e1314 * _e1670), (_e1318 * _e1670), _e1181);
                                                                            } else {
                                                                                phi_2192_ = type_28();
                                                                            }
                                                                            let _e1675 = phi_2192_;
                                                                            phi_2194_ = _e1675;
                                                                            phi_2195_ = select(true, false, _e1669);
                                                                        } else {
                                                                            phi_2194_ = type_28();
                                                                            phi_2195_ = true;
                                                                        }
                                                                        let _e1678 = phi_2194_;
                                                                        let _e1680 = phi_2195_;
                                                                        if _e1680 {
                                                                            phi_2199_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2199_ = _e1678;
                                                                        }
                                                                        let _e1682 = phi_2199_;
                                                                        phi_2200_ = _e1682;
                                                                    }
                                                                    let _e1684 = phi_2200_;
                                                                    phi_2201_ = _e1684;
                                                                    phi_2202_ = _e1410;
                                                                }
                                                                let _e1686 = phi_2201_;
                                                                let _e1688 = phi_2202_;
                                                                phi_2206_ = _e1686;
                                                                phi_2207_ = _e1688;
                                                            }
                                                            let _e1690 = phi_2206_;
                                                            let _e1692 = phi_2207_;
                                                            phi_2208_ = _e1690;
                                                            phi_2209_ = _e1345;
                                                            phi_2210_ = _e1692;
                                                        }
                                                        let _e1694 = phi_2208_;
                                                        let _e1696 = phi_2209_;
                                                        let _e1698 = phi_2210_;
                                                        phi_2211_ = _e1694;
                                                        phi_2212_ = _e1696;
                                                        phi_2213_ = _e1698;
                                                    }
                                                    let _e1700 = phi_2211_;
                                                    let _e1702 = phi_2212_;
                                                    let _e1704 = phi_2213_;
                                                    phi_2221_ = _e1700;
                                                    phi_2222_ = select(_e1704, true, _e1702);
                                                } else {
                                                    phi_2221_ = type_28();
                                                    phi_2222_ = true;
                                                }
                                                let _e1707 = phi_2221_;
                                                let _e1709 = phi_2222_;
                                                if _e1709 {
                                                    phi_2226_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2226_ = _e1707;
                                                }
                                                let _e1711 = phi_2226_;
                                                if (_e1711.member_3 != 4294967295u) {
                                                    if (_e1181 != 4294967295u) {
                                                        phi_2237_ = type_42(_e1152.member, true);
                                                    } else {
                                                        phi_2237_ = _e1152;
                                                    }
                                                    let _e1719 = phi_2237_;
                                                    phi_2238_ = _e1719;
                                                } else {
                                                    phi_2238_ = _e1152;
                                                }
                                                let _e1721 = phi_2238_;
                                                phi_1189_ = _e1721;
                                            } else {
                                                phi_1189_ = type_42();
                                            }
                                            let _e1723 = phi_1189_;
                                            continue;
                                            continuing {
                                                phi_1188_ = _e1723;
                                                phi_1191_ = _e1167;
                                                phi_3718_ = _e657;
                                                break if !(_e1173);
                                            }
                                        }
                                        let _e1726 = phi_3718_;
                                        phi_3875_ = _e1726;
                                        if _e1726 {
                                            break;
                                        }
                                        let _e1728 = local_10;
                                        phi_3879_ = _e1726;
                                        let _e1900 = local_12;
                                        phi_3476_ = _e1900;
                                        phi_3477_ = false;
                                        phi_3478_ = select(_e700, 0u, _e1728.member_1);
                                        phi_3479_ = _e702;
                                    } else {
                                        if (_e702.member_1 >= _e90) {
                                            phi_3011_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e702.member_1 < _e90) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e714 = ((1u + _e260) % 4u);
                                            if (_e714 < 4u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e719 = global_4.member[_e702.member_1][_e714];
                                            let _e721 = (_e719 >> bitcast<u32>(11u));
                                            let _e723 = ((1u + _e259) % 4u);
                                            if (_e723 < 4u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e728 = global_4.member[_e702.member_1][_e723];
                                            let _e730 = (_e728 >> bitcast<u32>(11u));
                                            let _e732 = ((1u + _e261) % 4u);
                                            if (_e732 < 4u) {
                                            } else {
                                                phi_3875_ = true;
                                                break;
                                            }
                                            let _e737 = global_4.member[_e702.member_1][_e732];
                                            let _e739 = (_e737 >> bitcast<u32>(11u));
                                            let _e762 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.x - _e702.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e763 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.y - _e702.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e764 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.z - _e702.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e766 = select(_e140, _e762, (_e762 > _e140));
                                            let _e768 = select(_e140, _e763, (_e763 > _e140));
                                            let _e770 = select(_e140, _e764, (_e764 > _e140));
                                            let _e801 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 1023u))) - 8388608f) * _e766));
                                            let _e806 = (bitcast<i32>((_e719 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e809 = bitcast<f32>((_e801 & bitcast<u32>(_e806)));
                                            let _e810 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 1023u))) - 8388608f) * _e768));
                                            let _e815 = (bitcast<i32>((_e728 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e818 = bitcast<f32>((_e810 & bitcast<u32>(_e815)));
                                            let _e819 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e737 & 1023u))) - 8388608f) * _e770));
                                            let _e824 = (bitcast<i32>((_e737 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e827 = bitcast<f32>((_e819 & bitcast<u32>(_e824)));
                                            let _e831 = bitcast<f32>((_e801 & bitcast<u32>(~(_e806))));
                                            let _e835 = bitcast<f32>((_e810 & bitcast<u32>(~(_e815))));
                                            let _e839 = bitcast<f32>((_e819 & bitcast<u32>(~(_e824))));
                                            let _e840 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e721 & 1023u))) - 8388608f) * _e766));
                                            let _e845 = (bitcast<i32>((_e721 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e848 = bitcast<f32>((_e840 & bitcast<u32>(_e845)));
                                            let _e849 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 1023u))) - 8388608f) * _e768));
                                            let _e854 = (bitcast<i32>((_e730 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e857 = bitcast<f32>((_e849 & bitcast<u32>(_e854)));
                                            let _e858 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e739 & 1023u))) - 8388608f) * _e770));
                                            let _e863 = (bitcast<i32>((_e739 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e866 = bitcast<f32>((_e858 & bitcast<u32>(_e863)));
                                            let _e870 = bitcast<f32>((_e840 & bitcast<u32>(~(_e845))));
                                            let _e874 = bitcast<f32>((_e849 & bitcast<u32>(~(_e854))));
                                            let _e878 = bitcast<f32>((_e858 & bitcast<u32>(~(_e863))));
                                            let _e908 = global_4.member[_e702.member_1][0u];
                                            let _e912 = global_4.member[_e702.member_1][1u];
                                            let _e916 = global_4.member[_e702.member_1][2u];
                                            let _e920 = global_4.member[_e702.member_1][3u];
                                            let _e932 = (((_e912 >> bitcast<u32>(22i)) | ((_e916 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e920 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e933 = (_e908 & 268435455u);
                                            let _e934 = (_e932 & 268435455u);
                                            let _e937 = ((_e908 >> bitcast<u32>(28u)) & 7u);
                                            let _e945 = ((_e908 >> bitcast<u32>(31i)) | (((_e932 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e946 = (_e937 != 0u);
                                            if (_e937 == 0u) {
                                                phi_2973_ = _e933;
                                            } else {
                                                if (_e937 == 7u) {
                                                    phi_2972_ = 2147483648u;
                                                } else {
                                                    phi_2972_ = ((2147483648u | (_e937 << bitcast<u32>(28u))) | (_e934 & 268435455u));
                                                }
                                                let _e955 = phi_2972_;
                                                phi_2973_ = _e955;
                                            }
                                            let _e957 = phi_2973_;
                                            if _e946 {
                                                let _e958 = (_e937 != 7u);
                                                if _e958 {
                                                    phi_2983_ = (_e934 + _e937);
                                                } else {
                                                    phi_2983_ = u32();
                                                }
                                                let _e961 = phi_2983_;
                                                phi_2985_ = _e961;
                                                phi_2986_ = select(true, false, _e958);
                                            } else {
                                                phi_2985_ = u32();
                                                phi_2986_ = true;
                                            }
                                            let _e964 = phi_2985_;
                                            let _e966 = phi_2986_;
                                            if (_e945 == 0u) {
                                                phi_3007_ = (_e933 + select(0u, 1u, !(_e946)));
                                            } else {
                                                if (_e945 == 7u) {
                                                    phi_3006_ = 2147483648u;
                                                } else {
                                                    phi_3006_ = ((2147483648u | (_e945 << bitcast<u32>(28u))) | (select(_e964, _e934, _e966) & 268435455u));
                                                }
                                                let _e979 = phi_3006_;
                                                phi_3007_ = _e979;
                                            }
                                            let _e981 = phi_3007_;
                                            phi_3011_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e702.member.member.x + _e809), (_e702.member.member.x + _e831), (_e702.member.member_1.x - _e848), (_e702.member.member_1.x - _e870)), vec4<f32>((_e702.member.member.y + _e818), (_e702.member.member.y + _e835), (_e702.member.member_1.y - _e857), (_e702.member.member_1.y - _e874)), vec4<f32>((_e702.member.member.z + _e827), (_e702.member.member.z + _e839), (_e702.member.member_1.z - _e866), (_e702.member.member_1.z - _e878))), type_49(type_32((_e702.member.member + vec4<f32>(_e809, _e818, _e827, 0f)), (_e702.member.member_1 - vec4<f32>(_e848, _e857, _e866, 0f))), _e957), type_49(type_32((_e702.member.member + vec4<f32>(_e831, _e835, _e839, 0f)), (_e702.member.member_1 - vec4<f32>(_e870, _e874, _e878, 0f))), _e981));
                                        }
                                        let _e986 = phi_3011_;
                                        let _e998 = ((_e986.member[0].x - _e362) * _e367);
                                        let _e999 = ((_e986.member[0].y - _e362) * _e367);
                                        let _e1000 = ((_e986.member[0].z - _e363) * _e367);
                                        let _e1001 = ((_e986.member[0].w - _e363) * _e367);
                                        let _e1011 = ((_e986.member[1].x - _e430) * _e435);
                                        let _e1012 = ((_e986.member[1].y - _e430) * _e435);
                                        let _e1013 = ((_e986.member[1].z - _e431) * _e435);
                                        let _e1014 = ((_e986.member[1].w - _e431) * _e435);
                                        let _e1024 = ((_e986.member[2].x - _e498) * _e503);
                                        let _e1025 = ((_e986.member[2].y - _e498) * _e503);
                                        let _e1026 = ((_e986.member[2].z - _e499) * _e503);
                                        let _e1027 = ((_e986.member[2].w - _e499) * _e503);
                                        let _e1029 = select(_e1026, _e1024, (_e1024 < _e1026));
                                        let _e1031 = select(_e1027, _e1025, (_e1025 < _e1027));
                                        let _e1033 = select(_e1026, _e1024, (_e1024 > _e1026));
                                        let _e1035 = select(_e1027, _e1025, (_e1025 > _e1027));
                                        let _e1037 = select(_e1000, _e998, (_e998 < _e1000));
                                        let _e1039 = select(_e1001, _e999, (_e999 < _e1001));
                                        let _e1041 = select(_e1013, _e1011, (_e1011 < _e1013));
                                        let _e1043 = select(_e1014, _e1012, (_e1012 < _e1014));
                                        let _e1045 = select(_e1041, _e1037, (_e1037 > _e1041));
                                        let _e1047 = select(_e1043, _e1039, (_e1039 > _e1043));
                                        let _e1049 = select(_e1029, _e1045, (_e1045 > _e1029));
                                        let _e1051 = select(_e1031, _e1047, (_e1047 > _e1031));
                                        let _e1053 = select(_e1000, _e998, (_e998 > _e1000));
                                        let _e1055 = select(_e1001, _e999, (_e999 > _e1001));
                                        let _e1057 = select(_e1013, _e1011, (_e1011 > _e1013));
                                        let _e1059 = select(_e1014, _e1012, (_e1012 > _e1014));
                                        let _e1061 = select(_e1057, _e1053, (_e1053 < _e1057));
                                        let _e1063 = select(_e1059, _e1055, (_e1055 < _e1059));
                                        let _e1068 = -(_e1029);
                                        let _e1069 = -(_e1031);
                                        let _e1076 = (select(_e1033, _e1061, (_e1061 < _e1033)) + (select(_e1068, _e1033, (_e1033 > _e1068)) * 0.0000019073523f));
                                        let _e1077 = (select(_e1035, _e1063, (_e1063 < _e1035)) + (select(_e1069, _e1035, (_e1035 > _e1069)) * 0.0000019073523f));
                                        let _e1079 = select(_e615, _e1049, (_e1049 > _e615));
                                        let _e1081 = select(_e615, _e1051, (_e1051 > _e615));
                                        let _e1086 = (_e1079 <= select(_e659.member, _e1076, (_e1076 < _e659.member)));
                                        let _e1087 = (_e1081 <= select(_e659.member, _e1077, (_e1077 < _e659.member)));
                                        let _e1088 = (_e1079 <= _e1081);
                                        if _e1086 {
                                            if _e1087 {
                                                if _e1088 {
                                                    phi_3373_ = _e986.member_2;
                                                } else {
                                                    phi_3373_ = _e986.member_1;
                                                }
                                                let _e1092 = phi_3373_;
                                                let _e1114 = (_e700 % 128u);
                                                let _e1115 = (_e1114 < 128u);
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_8[_e1114] = _e1092.member_1;
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_7[_e1114] = _e1092.member.member.x;
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_6[_e1114] = _e1092.member.member.y;
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_5[_e1114] = _e1092.member.member.z;
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_4[_e1114] = _e1092.member.member_1.x;
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_3[_e1114] = _e1092.member.member_1.y;
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_2[_e1114] = _e1092.member.member_1.z;
                                                if _e1115 {
                                                } else {
                                                    phi_3875_ = true;
                                                    break;
                                                }
                                                local_9[_e1114] = select(_e1081, _e1079, !(_e1088));
                                                if _e1088 {
                                                    phi_3450_ = _e986.member_1;
                                                } else {
                                                    phi_3450_ = _e986.member_2;
                                                }
                                                let _e1128 = phi_3450_;
                                                phi_3451_ = (_e700 + 1u);
                                                phi_3452_ = _e1128;
                                            } else {
                                                phi_3451_ = u32();
                                                phi_3452_ = type_49();
                                            }
                                            let _e1130 = phi_3451_;
                                            let _e1132 = phi_3452_;
                                            phi_3454_ = _e1130;
                                            phi_3455_ = _e1132;
                                            phi_3456_ = select(true, false, _e1087);
                                        } else {
                                            phi_3454_ = u32();
                                            phi_3455_ = type_49();
                                            phi_3456_ = true;
                                        }
                                        let _e1135 = phi_3454_;
                                        let _e1137 = phi_3455_;
                                        let _e1139 = phi_3456_;
                                        if _e1139 {
                                            if _e1086 {
                                                phi_3465_ = _e986.member_1;
                                            } else {
                                                phi_3465_ = _e986.member_2;
                                            }
                                            let _e1143 = phi_3465_;
                                            phi_3470_ = select(_e1087, true, _e1086);
                                            phi_3472_ = _e1143;
                                        } else {
                                            phi_3470_ = _e698;
                                            phi_3472_ = _e1137;
                                        }
                                        let _e1146 = phi_3470_;
                                        let _e1148 = phi_3472_;
                                        phi_3879_ = _e657;
                                        phi_3476_ = _e659;
                                        phi_3477_ = _e1146;
                                        phi_3478_ = select(_e1135, _e700, _e1139);
                                        phi_3479_ = _e1148;
                                    }
                                    let _e1732 = phi_3879_;
                                    let _e1734 = phi_3476_;
                                    let _e1736 = phi_3477_;
                                    let _e1738 = phi_3478_;
                                    let _e1740 = phi_3479_;
                                    phi_3878_ = _e1732;
                                    phi_3480_ = _e1734;
                                    phi_3481_ = _e1736;
                                    phi_3482_ = (_e663 - 1u);
                                    phi_3483_ = _e1738;
                                    phi_3484_ = _e1740;
                                } else {
                                    phi_3878_ = _e657;
                                    phi_3480_ = _e659;
                                    phi_3481_ = _e698;
                                    phi_3482_ = _e663;
                                    phi_3483_ = _e700;
                                    phi_3484_ = _e702;
                                }
                                let _e1742 = phi_3878_;
                                let _e1744 = phi_3480_;
                                let _e1746 = phi_3481_;
                                let _e1748 = phi_3482_;
                                let _e1750 = phi_3483_;
                                let _e1752 = phi_3484_;
                                phi_3877_ = _e1742;
                                phi_3485_ = _e1744;
                                phi_3486_ = _e1746;
                                phi_3487_ = _e1748;
                                phi_3488_ = _e1750;
                                phi_3489_ = _e1752;
                            } else {
                                phi_3877_ = _e657;
                                phi_3485_ = type_42();
                                phi_3486_ = bool();
                                phi_3487_ = u32();
                                phi_3488_ = u32();
                                phi_3489_ = type_49();
                            }
                            let _e1754 = phi_3877_;
                            let _e1756 = phi_3485_;
                            let _e1758 = phi_3486_;
                            let _e1760 = phi_3487_;
                            let _e1762 = phi_3488_;
                            let _e1764 = phi_3489_;
                            phi_3876_ = _e1754;
                            phi_1063_ = _e1756;
                            phi_1066_ = _e1758;
                            phi_1068_ = _e1760;
                            phi_1070_ = _e1762;
                            phi_1072_ = _e1764;
                            phi_3490_ = _e671;
                        } else {
                            phi_3876_ = _e657;
                            phi_1063_ = type_42();
                            phi_1066_ = bool();
                            phi_1068_ = u32();
                            phi_1070_ = u32();
                            phi_1072_ = type_49();
                            phi_3490_ = false;
                        }
                        let _e1766 = phi_3876_;
                        let _e1768 = phi_1063_;
                        let _e1770 = phi_1066_;
                        let _e1772 = phi_1068_;
                        let _e1774 = phi_1070_;
                        let _e1776 = phi_1072_;
                        let _e1778 = phi_3490_;
                        continue;
                        continuing {
                            phi_3724_ = _e1766;
                            phi_1062_ = _e1768;
                            phi_1065_ = _e1770;
                            phi_1067_ = _e1772;
                            phi_1069_ = _e1774;
                            phi_1071_ = _e1776;
                            phi_3875_ = _e1766;
                            break if !(_e1778);
                        }
                    }
                    let _e1781 = phi_3875_;
                    if _e1781 {
                        break;
                    }
                    let _e1783 = local_11;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146] = select(0u, 1u, _e1783.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
