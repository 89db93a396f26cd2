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
    var phi_3727_: bool;
    var phi_1062_: type_42;
    var phi_1065_: u32;
    var phi_1067_: bool;
    var phi_1069_: u32;
    var phi_1071_: type_49;
    var phi_1082_: bool;
    var phi_1168_: bool;
    var phi_1169_: u32;
    var phi_1170_: type_49;
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
    var phi_3721_: bool;
    var phi_3964_: bool;
    var phi_2239_: type_42;
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
    var phi_3483_: type_42;
    var phi_3484_: u32;
    var phi_3485_: bool;
    var phi_3486_: u32;
    var phi_3487_: type_49;
    var phi_3880_: bool;
    var phi_3488_: type_42;
    var phi_3489_: u32;
    var phi_3490_: bool;
    var phi_3491_: u32;
    var phi_3492_: type_49;
    var phi_3879_: bool;
    var phi_1063_: type_42;
    var phi_1066_: u32;
    var phi_1068_: bool;
    var phi_1070_: u32;
    var phi_1072_: type_49;
    var phi_3493_: bool;
    var phi_3878_: bool;
    var local_10: type_42;
    var local_11: type_42;

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
                    phi_3727_ = false;
                    phi_1062_ = type_42(_e613, false);
                    phi_1065_ = ((3u * _e90) + 1u);
                    phi_1067_ = (_e615 <= _e613);
                    phi_1069_ = 0u;
                    phi_1071_ = type_49(type_32(vec4<f32>((f32(_e622) * _e140), (f32(_e628) * _e140), (f32(_e634) * _e140), 0f), vec4<f32>((f32(_e639) * _e140), (f32(_e643) * _e140), (f32(_e647) * _e140), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    loop {
                        let _e657 = phi_3727_;
                        let _e659 = phi_1062_;
                        let _e661 = phi_1065_;
                        let _e663 = phi_1067_;
                        let _e665 = phi_1069_;
                        let _e667 = phi_1071_;
                        local_10 = _e659;
                        if _e663 {
                            phi_1082_ = true;
                        } else {
                            phi_1082_ = (_e665 > 0u);
                        }
                        let _e670 = phi_1082_;
                        if _e670 {
                            let _e671 = (_e661 > 0u);
                            if _e671 {
                                if _e663 {
                                    phi_1168_ = _e663;
                                    phi_1169_ = _e665;
                                    phi_1170_ = _e667;
                                } else {
                                    let _e672 = (_e665 - 1u);
                                    let _e673 = (_e672 % 128u);
                                    let _e674 = (_e673 < 128u);
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e676 = local_7[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e678 = local_6[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e680 = local_5[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e682 = local_4[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e684 = local_3[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e686 = local_2[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e691 = local_8[_e673];
                                    if _e674 {
                                    } else {
                                        phi_3878_ = true;
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
                                    let _e706 = ((_e702.member_1 & 2147483648u) != 0u);
                                    if _e706 {
                                        phi_1188_ = _e659;
                                        phi_1191_ = type_7(0u, ((_e702.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e713 = phi_1188_;
                                            let _e715 = phi_1191_;
                                            local_11 = _e713;
                                            if (_e715.member < _e715.member_1) {
                                                phi_1192_ = type_7((_e715.member + 1u), _e715.member_1);
                                                phi_1214_ = type_7(1u, _e715.member);
                                            } else {
                                                phi_1192_ = _e715;
                                                phi_1214_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e728 = phi_1192_;
                                            let _e730 = phi_1214_;
                                            let _e734 = (bitcast<i32>(_e730.member) != 0i);
                                            if _e734 {
                                                let _e735 = ((_e702.member_1 & 268435455u) + _e730.member_1);
                                                let _e736 = (_e735 < _e92);
                                                if _e736 {
                                                    if _e736 {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e740 = global_2.member[_e735].member_1;
                                                    phi_1235_ = _e740;
                                                } else {
                                                    phi_1235_ = 4294967295u;
                                                }
                                                let _e742 = phi_1235_;
                                                if (_e735 >= _e92) {
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e736 {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    if (_e619 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e749 = global_2.member[_e735].member[_e619];
                                                    if (_e625 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e755 = global_2.member[_e735].member[_e625];
                                                    if (_e631 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e761 = global_2.member[_e735].member[_e631];
                                                    let _e763 = (3u + _e619);
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_2.member[_e735].member[_e763];
                                                    let _e770 = (3u + _e625);
                                                    if (_e770 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e776 = global_2.member[_e735].member[_e770];
                                                    let _e777 = (3u + _e631);
                                                    if (_e777 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e783 = global_2.member[_e735].member[_e777];
                                                    let _e785 = (6u + _e619);
                                                    if (_e785 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e791 = global_2.member[_e735].member[_e785];
                                                    let _e792 = (6u + _e625);
                                                    if (_e792 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e798 = global_2.member[_e735].member[_e792];
                                                    let _e799 = (6u + _e631);
                                                    if (_e799 < 9u) {
                                                    } else {
                                                        phi_3721_ = true;
                                                        break;
                                                    }
                                                    let _e805 = global_2.member[_e735].member[_e799];
                                                    phi_1327_ = array<array<f32, 3>, 3>(array<f32, 3>(_e749, _e755, _e761), array<f32, 3>(_e769, _e776, _e783), array<f32, 3>(_e791, _e798, _e805));
                                                }
                                                let _e809 = phi_1327_;
                                                let _e817 = (_e809[0][2] - _e461);
                                                let _e820 = (((_e809[0][0] - _e324) * _e500) - (_e817 * _e364));
                                                let _e823 = (((_e809[0][1] - _e393) * _e500) - (_e817 * _e432));
                                                let _e830 = (_e809[1][2] - _e461);
                                                let _e833 = (((_e809[1][0] - _e324) * _e500) - (_e830 * _e364));
                                                let _e836 = (((_e809[1][1] - _e393) * _e500) - (_e830 * _e432));
                                                let _e843 = (_e809[2][2] - _e461);
                                                let _e846 = (((_e809[2][0] - _e324) * _e500) - (_e843 * _e364));
                                                let _e849 = (((_e809[2][1] - _e393) * _e500) - (_e843 * _e432));
                                                let _e850 = (_e846 * _e836);
                                                let _e851 = (_e849 * _e833);
                                                let _e852 = (_e820 * _e849);
                                                let _e853 = (_e823 * _e846);
                                                let _e854 = (_e833 * _e823);
                                                let _e855 = (_e836 * _e820);
                                                let _e860 = (((_e850 >= _e851) && (_e852 >= _e853)) && (_e854 >= _e855));
                                                if (_e860 || (((_e850 <= _e851) && (_e852 <= _e853)) && (_e854 <= _e855))) {
                                                    let _e867 = select(-1f, 1f, _e860);
                                                    let _e869 = ((_e850 - _e851) * _e867);
                                                    let _e871 = select(0f, _e869, (_e869 > 0f));
                                                    let _e873 = ((_e852 - _e853) * _e867);
                                                    let _e875 = select(0f, _e873, (_e873 > 0f));
                                                    let _e877 = ((_e854 - _e855) * _e867);
                                                    let _e879 = select(0f, _e877, (_e877 > 0f));
                                                    let _e881 = ((_e871 + _e875) + _e879);
                                                    if (_e881 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2211_ = type_28();
                                                        phi_2212_ = true;
                                                        phi_2213_ = false;
                                                    } else {
                                                        let _e884 = select(_e833, _e820, (_e820 < _e833));
                                                        if (select(_e846, _e884, (_e884 < _e846)) > 0f) {
                                                            phi_1479_ = true;
                                                        } else {
                                                            let _e889 = select(_e833, _e820, (_e820 > _e833));
                                                            phi_1479_ = (select(_e846, _e889, (_e889 > _e846)) < 0f);
                                                        }
                                                        let _e894 = phi_1479_;
                                                        if _e894 {
                                                            phi_2208_ = type_28();
                                                            phi_2209_ = true;
                                                            phi_2210_ = false;
                                                        } else {
                                                            let _e896 = select(_e836, _e823, (_e823 < _e836));
                                                            if (select(_e849, _e896, (_e896 < _e849)) > 0f) {
                                                                phi_1508_ = true;
                                                            } else {
                                                                let _e901 = select(_e836, _e823, (_e823 > _e836));
                                                                phi_1508_ = (select(_e849, _e901, (_e901 > _e849)) < 0f);
                                                            }
                                                            let _e906 = phi_1508_;
                                                            if _e906 {
                                                                phi_2206_ = type_28();
                                                                phi_2207_ = false;
                                                            } else {
                                                                let _e908 = select(_e809[1][0], _e809[0][0], (_e809[0][0] < _e809[1][0]));
                                                                let _e912 = select(_e809[1][0], _e809[0][0], (_e809[0][0] > _e809[1][0]));
                                                                let _e916 = select(_e809[1][1], _e809[0][1], (_e809[0][1] < _e809[1][1]));
                                                                let _e920 = select(_e809[1][1], _e809[0][1], (_e809[0][1] > _e809[1][1]));
                                                                let _e924 = select(_e809[1][2], _e809[0][2], (_e809[0][2] < _e809[1][2]));
                                                                let _e928 = select(_e809[1][2], _e809[0][2], (_e809[0][2] > _e809[1][2]));
                                                                let _e933 = ((select(_e809[2][0], _e908, (_e908 < _e809[2][0])) - _e362) * _e367);
                                                                let _e934 = ((select(_e809[2][0], _e912, (_e912 > _e809[2][0])) - _e363) * _e367);
                                                                let _e937 = ((select(_e809[2][1], _e916, (_e916 < _e809[2][1])) - _e430) * _e435);
                                                                let _e938 = ((select(_e809[2][1], _e920, (_e920 > _e809[2][1])) - _e431) * _e435);
                                                                let _e941 = ((select(_e809[2][2], _e924, (_e924 < _e809[2][2])) - _e498) * _e503);
                                                                let _e942 = ((select(_e809[2][2], _e928, (_e928 > _e809[2][2])) - _e499) * _e503);
                                                                let _e944 = select(_e942, _e941, (_e941 < _e942));
                                                                let _e946 = select(_e942, _e941, (_e941 > _e942));
                                                                let _e948 = select(_e934, _e933, (_e933 < _e934));
                                                                let _e950 = select(_e938, _e937, (_e937 < _e938));
                                                                let _e952 = select(_e950, _e948, (_e948 > _e950));
                                                                let _e954 = select(_e944, _e952, (_e952 > _e944));
                                                                let _e956 = select(_e934, _e933, (_e933 > _e934));
                                                                let _e958 = select(_e938, _e937, (_e937 > _e938));
                                                                let _e960 = select(_e958, _e956, (_e956 < _e958));
                                                                let _e962 = select(_e946, _e960, (_e960 < _e946));
                                                                let _e963 = -(_e944);
                                                                let _e969 = select(_e615, _e954, (_e954 > _e615));
                                                                if (_e969 > (_e962 + (select(_e963, _e946, (_e946 > _e963)) * 0.0000019073523f))) {
                                                                    phi_2201_ = type_28();
                                                                    phi_2202_ = true;
                                                                } else {
                                                                    let _e971 = (_e969 > _e713.member);
                                                                    if _e971 {
                                                                        phi_2200_ = type_28();
                                                                    } else {
                                                                        let _e972 = vec3<f32>(_e809[0][0], _e809[0][1], _e809[0][2]);
                                                                        let _e973 = vec3<f32>(_e809[1][0], _e809[1][1], _e809[1][2]);
                                                                        let _e974 = vec3<f32>(_e809[2][0], _e809[2][1], _e809[2][2]);
                                                                        let _e975 = (_e809[1][0] - _e809[0][0]);
                                                                        let _e976 = (_e809[1][1] - _e809[0][1]);
                                                                        let _e977 = (_e809[1][2] - _e809[0][2]);
                                                                        let _e978 = vec3<f32>(_e975, _e976, _e977);
                                                                        let _e979 = (_e809[2][0] - _e809[1][0]);
                                                                        let _e980 = (_e809[2][1] - _e809[1][1]);
                                                                        let _e981 = (_e809[2][2] - _e809[1][2]);
                                                                        let _e982 = vec3<f32>(_e979, _e980, _e981);
                                                                        let _e983 = (_e809[0][0] - _e809[2][0]);
                                                                        let _e984 = (_e809[0][1] - _e809[2][1]);
                                                                        let _e985 = (_e809[0][2] - _e809[2][2]);
                                                                        let _e986 = vec3<f32>(_e983, _e984, _e985);
                                                                        let _e989 = bitcast<f32>((bitcast<u32>(_e975) & 2147483647u));
                                                                        let _e992 = bitcast<f32>((bitcast<u32>(_e976) & 2147483647u));
                                                                        let _e994 = select(_e992, _e989, (_e989 > _e992));
                                                                        let _e997 = bitcast<f32>((bitcast<u32>(_e977) & 2147483647u));
                                                                        let _e999 = select(_e997, _e994, (_e994 > _e997));
                                                                        let _e1002 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e1005 = bitcast<f32>((bitcast<u32>(_e980) & 2147483647u));
                                                                        let _e1007 = select(_e1005, _e1002, (_e1002 > _e1005));
                                                                        let _e1010 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                        let _e1012 = select(_e1010, _e1007, (_e1007 > _e1010));
                                                                        let _e1015 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1018 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1020 = select(_e1018, _e1015, (_e1015 > _e1018));
                                                                        let _e1023 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1025 = select(_e1023, _e1020, (_e1020 > _e1023));
                                                                        let _e1027 = select(_e1012, _e999, (_e999 > _e1012));
                                                                        let _e1029 = select(_e1025, _e1027, (_e1027 > _e1025));
                                                                        if (_e999 == _e1029) {
                                                                            phi_1927_ = _e836;
                                                                            phi_1928_ = _e833;
                                                                            phi_1929_ = _e823;
                                                                            phi_1930_ = _e820;
                                                                            phi_1931_ = _e972;
                                                                            phi_1932_ = _e986;
                                                                            phi_1933_ = _e982;
                                                                            phi_1934_ = _e978;
                                                                        } else {
                                                                            let _e1031 = (_e1012 == _e1029);
                                                                            let _e1036 = vec3(_e1031);
                                                                            phi_1927_ = select(_e823, _e849, _e1031);
                                                                            phi_1928_ = select(_e820, _e846, _e1031);
                                                                            phi_1929_ = select(_e849, _e836, _e1031);
                                                                            phi_1930_ = select(_e846, _e833, _e1031);
                                                                            phi_1931_ = select(_e974, _e973, _e1036);
                                                                            phi_1932_ = select(_e982, _e978, _e1036);
                                                                            phi_1933_ = select(_e978, _e986, _e1036);
                                                                            phi_1934_ = select(_e986, _e982, _e1036);
                                                                        }
                                                                        let _e1042 = phi_1927_;
                                                                        let _e1044 = phi_1928_;
                                                                        let _e1046 = phi_1929_;
                                                                        let _e1048 = phi_1930_;
                                                                        let _e1050 = phi_1931_;
                                                                        let _e1052 = phi_1932_;
                                                                        let _e1054 = phi_1933_;
                                                                        let _e1056 = phi_1934_;
                                                                        let _e1063 = ((_e1054.y * _e1052.z) - (_e1052.y * _e1054.z));
                                                                        let _e1068 = ((_e1054.z * _e1052.x) - (_e1052.z * _e1054.x));
                                                                        let _e1071 = ((_e1054.x * _e1052.y) - (_e1052.x * _e1054.y));
                                                                        if (_e871 >= _e875) {
                                                                            phi_1971_ = select(true, false, (_e871 >= _e879));
                                                                        } else {
                                                                            phi_1971_ = true;
                                                                        }
                                                                        let _e1076 = phi_1971_;
                                                                        if _e1076 {
                                                                            phi_1980_ = select(_e974, _e973, vec3((_e875 >= _e879)));
                                                                        } else {
                                                                            phi_1980_ = _e972;
                                                                        }
                                                                        let _e1081 = phi_1980_;
                                                                        let _e1092 = (((_e1063 * (_e1081.x - _e324)) + (_e1068 * (_e1081.y - _e393))) + (_e1071 * (_e1081.z - _e461)));
                                                                        let _e1097 = (((_e1063 * _e364) + (_e1068 * _e432)) + (_e1071 * _e500));
                                                                        let _e1098 = (_e1044 - _e1048);
                                                                        let _e1099 = (_e1042 - _e1046);
                                                                        let _e1107 = (-(((_e1048 * _e1098) + (_e1046 * _e1099))) / ((_e1098 * _e1098) + (_e1099 * _e1099)));
                                                                        let _e1109 = select(1f, _e1107, (_e1107 < 1f));
                                                                        let _e1111 = select(0f, _e1109, (_e1109 > 0f));
                                                                        let _e1124 = ((_e1050.x + (_e1056.x * _e1111)) - _e324);
                                                                        let _e1125 = ((_e1050.y + (_e1056.y * _e1111)) - _e393);
                                                                        let _e1126 = ((_e1050.z + (_e1056.z * _e1111)) - _e461);
                                                                        let _e1127 = (_e1126 / _e500);
                                                                        let _e1139 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                                                        let _e1142 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                        let _e1144 = select(_e1142, _e1139, (_e1139 > _e1142));
                                                                        let _e1147 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                        let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                        let _e1155 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                                        let _e1158 = bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u));
                                                                        let _e1160 = select(_e1158, _e1155, (_e1155 > _e1158));
                                                                        let _e1163 = bitcast<f32>((bitcast<u32>(_e1071) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1063 * _e1124) + (_e1068 * _e1125)) + (_e1071 * _e1126)) - _e1092)) & 2147483647u)) <= ((0.0000009536743f * select(_e1029, _e1149, (_e1149 > _e1029))) * select(_e1163, _e1160, (_e1160 > _e1163)))) {
                                                                            let _e1173 = bitcast<f32>((bitcast<u32>(_e1054.x) & 2147483647u));
                                                                            let _e1176 = bitcast<f32>((bitcast<u32>(_e1054.y) & 2147483647u));
                                                                            let _e1178 = select(_e1176, _e1173, (_e1173 > _e1176));
                                                                            let _e1181 = bitcast<f32>((bitcast<u32>(_e1054.z) & 2147483647u));
                                                                            let _e1187 = bitcast<f32>((bitcast<u32>(_e1052.x) & 2147483647u));
                                                                            let _e1190 = bitcast<f32>((bitcast<u32>(_e1052.y) & 2147483647u));
                                                                            let _e1192 = select(_e1190, _e1187, (_e1187 > _e1190));
                                                                            let _e1195 = bitcast<f32>((bitcast<u32>(_e1052.z) & 2147483647u));
                                                                            let _e1199 = (bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u)) > ((0.0000038146973f * select(_e1181, _e1178, (_e1178 > _e1181))) * select(_e1195, _e1192, (_e1192 > _e1195))));
                                                                            if _e1199 {
                                                                                phi_2145_ = (_e1092 / _e1097);
                                                                            } else {
                                                                                phi_2145_ = f32();
                                                                            }
                                                                            let _e1202 = phi_2145_;
                                                                            phi_2147_ = _e1202;
                                                                            phi_2148_ = select(true, false, _e1199);
                                                                        } else {
                                                                            phi_2147_ = f32();
                                                                            phi_2148_ = true;
                                                                        }
                                                                        let _e1205 = phi_2147_;
                                                                        let _e1207 = phi_2148_;
                                                                        if _e1207 {
                                                                            let _e1215 = (((_e1063 * (_e1124 - (_e364 * _e1127))) + (_e1068 * (_e1125 - (_e432 * _e1127)))) / _e1097);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u)) <= _e1029) {
                                                                                phi_2168_ = (_e1127 + _e1215);
                                                                            } else {
                                                                                phi_2168_ = _e1127;
                                                                            }
                                                                            let _e1222 = phi_2168_;
                                                                            phi_2169_ = _e1222;
                                                                        } else {
                                                                            phi_2169_ = _e1205;
                                                                        }
                                                                        let _e1224 = phi_2169_;
                                                                        let _e1226 = select(_e962, _e1224, (_e1224 < _e962));
                                                                        let _e1228 = select(_e954, _e1226, (_e1226 > _e954));
                                                                        if (_e1228 >= _e615) {
                                                                            let _e1230 = (_e1228 <= _e713.member);
                                                                            if _e1230 {
                                                                                let _e1231 = (1f / _e881);
                                                                                phi_2192_ = type_28(_e1228, (_e875 * _e1231), (_e879 * _e1231), _e742);
                                                                            } else {
                                                                                phi_2192_ = type_28();
                                                                            }
                                                                            let _e1236 = phi_2192_;
                                                                            phi_2194_ = _e1236;
                                                                            phi_2195_ = select(true, false, _e1230);
                                                                        } else {
                                                                            phi_2194_ = type_28();
                                                                            phi_2195_ = true;
                                                                        }
                                                                        let _e1239 = phi_2194_;
                                                                        let _e1241 = phi_2195_;
                                                                        if _e1241 {
                                                                            phi_2199_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2199_ = _e1239;
                                                                        }
                                                                        let _e1243 = phi_2199_;
                                                                        phi_2200_ = _e1243;
                                                                    }
                                                                    let _e1245 = phi_2200_;
                                                                    phi_2201_ = _e1245;
                                                                    phi_2202_ = _e971;
                                                                }
                                                                let _e1247 = phi_2201_;
                                                                let _e1249 = phi_2202_;
                                                                phi_2206_ = _e1247;
                                                                phi_2207_ = _e1249;
                                                            }
                                                            let _e1251 = phi_2206_;
                                                            let _e1253 = phi_2207_;
                                                            phi_2208_ = _e1251;
                                                            phi_2209_ = _e906;
                                                            phi_2210_ = _e1253;
                                                        }
                                                        let _e1255 = phi_2208_;
                                                        let _e1257 = phi_2209_;
                                                        let _e1259 = phi_2210_;
                                                        phi_2211_ = _e1255;
                                                        phi_2212_ = _e1257;
                                                        phi_2213_ = _e1259;
                                                    }
                                                    let _e1261 = phi_2211_;
                                                    let _e1263 = phi_2212_;
                                                    let _e1265 = phi_2213_;
                                                    phi_2221_ = _e1261;
                                                    phi_2222_ = select(_e1265, true, _e1263);
                                                } else {
                                                    phi_2221_ = type_28();
                                                    phi_2222_ = true;
                                                }
                                                let _e1268 = phi_2221_;
                                                let _e1270 = phi_2222_;
                                                if _e1270 {
                                                    phi_2226_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2226_ = _e1268;
                                                }
                                                let _e1272 = phi_2226_;
                                                if (_e1272.member_3 != 4294967295u) {
                                                    if (_e742 != 4294967295u) {
                                                        phi_2237_ = type_42(_e713.member, true);
                                                    } else {
                                                        phi_2237_ = _e713;
                                                    }
                                                    let _e1280 = phi_2237_;
                                                    phi_2238_ = _e1280;
                                                } else {
                                                    phi_2238_ = _e713;
                                                }
                                                let _e1282 = phi_2238_;
                                                phi_1189_ = _e1282;
                                            } else {
                                                phi_1189_ = type_42();
                                            }
                                            let _e1284 = phi_1189_;
                                            continue;
                                            continuing {
                                                phi_1188_ = _e1284;
                                                phi_1191_ = _e728;
                                                phi_3721_ = _e657;
                                                break if !(_e734);
                                            }
                                        }
                                        let _e1287 = phi_3721_;
                                        phi_3878_ = _e1287;
                                        if _e1287 {
                                            break;
                                        }
                                        phi_3964_ = _e1287;
                                        let _e1883 = local_11;
                                        phi_2239_ = _e1883;
                                    } else {
                                        phi_3964_ = _e657;
                                        phi_2239_ = _e659;
                                    }
                                    let _e1289 = phi_3964_;
                                    let _e1291 = phi_2239_;
                                    if _e706 {
                                        phi_3469_ = bool();
                                        phi_3470_ = u32();
                                        phi_3471_ = type_49();
                                    } else {
                                        if (_e702.member_1 >= _e90) {
                                            phi_3005_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e702.member_1 < _e90) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1295 = ((1u + _e260) % 4u);
                                            if (_e1295 < 4u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1300 = global_4.member[_e702.member_1][_e1295];
                                            let _e1302 = (_e1300 >> bitcast<u32>(11u));
                                            let _e1304 = ((1u + _e259) % 4u);
                                            if (_e1304 < 4u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1309 = global_4.member[_e702.member_1][_e1304];
                                            let _e1311 = (_e1309 >> bitcast<u32>(11u));
                                            let _e1313 = ((1u + _e261) % 4u);
                                            if (_e1313 < 4u) {
                                            } else {
                                                phi_3878_ = true;
                                                break;
                                            }
                                            let _e1318 = global_4.member[_e702.member_1][_e1313];
                                            let _e1320 = (_e1318 >> bitcast<u32>(11u));
                                            let _e1343 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.x - _e702.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1344 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.y - _e702.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1345 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.z - _e702.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1347 = select(_e140, _e1343, (_e1343 > _e140));
                                            let _e1349 = select(_e140, _e1344, (_e1344 > _e140));
                                            let _e1351 = select(_e140, _e1345, (_e1345 > _e140));
                                            let _e1382 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1300 & 1023u))) - 8388608f) * _e1347));
                                            let _e1387 = (bitcast<i32>((_e1300 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1390 = bitcast<f32>((_e1382 & bitcast<u32>(_e1387)));
                                            let _e1391 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1309 & 1023u))) - 8388608f) * _e1349));
                                            let _e1396 = (bitcast<i32>((_e1309 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1399 = bitcast<f32>((_e1391 & bitcast<u32>(_e1396)));
                                            let _e1400 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1318 & 1023u))) - 8388608f) * _e1351));
                                            let _e1405 = (bitcast<i32>((_e1318 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1408 = bitcast<f32>((_e1400 & bitcast<u32>(_e1405)));
                                            let _e1412 = bitcast<f32>((_e1382 & bitcast<u32>(~(_e1387))));
                                            let _e1416 = bitcast<f32>((_e1391 & bitcast<u32>(~(_e1396))));
                                            let _e1420 = bitcast<f32>((_e1400 & bitcast<u32>(~(_e1405))));
                                            let _e1421 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1302 & 1023u))) - 8388608f) * _e1347));
                                            let _e1426 = (bitcast<i32>((_e1302 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1429 = bitcast<f32>((_e1421 & bitcast<u32>(_e1426)));
                                            let _e1430 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1311 & 1023u))) - 8388608f) * _e1349));
                                            let _e1435 = (bitcast<i32>((_e1311 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1438 = bitcast<f32>((_e1430 & bitcast<u32>(_e1435)));
                                            let _e1439 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1320 & 1023u))) - 8388608f) * _e1351));
                                            let _e1444 = (bitcast<i32>((_e1320 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1447 = bitcast<f32>((_e1439 & bitcast<u32>(_e1444)));
                                            let _e1451 = bitcast<f32>((_e1421 & bitcast<u32>(~(_e1426))));
                                            let _e1455 = bitcast<f32>((_e1430 & bitcast<u32>(~(_e1435))));
                                            let _e1459 = bitcast<f32>((_e1439 & bitcast<u32>(~(_e1444))));
                                            let _e1489 = global_4.member[_e702.member_1][0u];
                                            let _e1493 = global_4.member[_e702.member_1][1u];
                                            let _e1497 = global_4.member[_e702.member_1][2u];
                                            let _e1501 = global_4.member[_e702.member_1][3u];
                                            let _e1513 = (((_e1493 >> bitcast<u32>(22i)) | ((_e1497 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1501 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1514 = (_e1489 & 268435455u);
                                            let _e1515 = (_e1513 & 268435455u);
                                            let _e1518 = ((_e1489 >> bitcast<u32>(28u)) & 7u);
                                            let _e1526 = ((_e1489 >> bitcast<u32>(31i)) | (((_e1513 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1527 = (_e1518 != 0u);
                                            if (_e1518 == 0u) {
                                                phi_2967_ = _e1514;
                                            } else {
                                                if (_e1518 == 7u) {
                                                    phi_2966_ = 2147483648u;
                                                } else {
                                                    phi_2966_ = ((2147483648u | (_e1518 << bitcast<u32>(28u))) | (_e1515 & 268435455u));
                                                }
                                                let _e1536 = phi_2966_;
                                                phi_2967_ = _e1536;
                                            }
                                            let _e1538 = phi_2967_;
                                            if _e1527 {
                                                let _e1539 = (_e1518 != 7u);
                                                if _e1539 {
                                                    phi_2977_ = (_e1515 + _e1518);
                                                } else {
                                                    phi_2977_ = u32();
                                                }
                                                let _e1542 = phi_2977_;
                                                phi_2979_ = _e1542;
                                                phi_2980_ = select(true, false, _e1539);
                                            } else {
                                                phi_2979_ = u32();
                                                phi_2980_ = true;
                                            }
                                            let _e1545 = phi_2979_;
                                            let _e1547 = phi_2980_;
                                            if (_e1526 == 0u) {
                                                phi_3001_ = (_e1514 + select(0u, 1u, !(_e1527)));
                                            } else {
                                                if (_e1526 == 7u) {
                                                    phi_3000_ = 2147483648u;
                                                } else {
                                                    phi_3000_ = ((2147483648u | (_e1526 << bitcast<u32>(28u))) | (select(_e1545, _e1515, _e1547) & 268435455u));
                                                }
                                                let _e1560 = phi_3000_;
                                                phi_3001_ = _e1560;
                                            }
                                            let _e1562 = phi_3001_;
                                            phi_3005_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e702.member.member.x + _e1390), (_e702.member.member.x + _e1412), (_e702.member.member_1.x - _e1429), (_e702.member.member_1.x - _e1451)), vec4<f32>((_e702.member.member.y + _e1399), (_e702.member.member.y + _e1416), (_e702.member.member_1.y - _e1438), (_e702.member.member_1.y - _e1455)), vec4<f32>((_e702.member.member.z + _e1408), (_e702.member.member.z + _e1420), (_e702.member.member_1.z - _e1447), (_e702.member.member_1.z - _e1459))), type_49(type_32((_e702.member.member + vec4<f32>(_e1390, _e1399, _e1408, 0f)), (_e702.member.member_1 - vec4<f32>(_e1429, _e1438, _e1447, 0f))), _e1538), type_49(type_32((_e702.member.member + vec4<f32>(_e1412, _e1416, _e1420, 0f)), (_e702.member.member_1 - vec4<f32>(_e1451, _e1455, _e1459, 0f))), _e1562));
                                        }
                                        let _e1567 = phi_3005_;
                                        let _e1579 = ((_e1567.member[0].x - _e362) * _e367);
                                        let _e1580 = ((_e1567.member[0].y - _e362) * _e367);
                                        let _e1581 = ((_e1567.member[0].z - _e363) * _e367);
                                        let _e1582 = ((_e1567.member[0].w - _e363) * _e367);
                                        let _e1592 = ((_e1567.member[1].x - _e430) * _e435);
                                        let _e1593 = ((_e1567.member[1].y - _e430) * _e435);
                                        let _e1594 = ((_e1567.member[1].z - _e431) * _e435);
                                        let _e1595 = ((_e1567.member[1].w - _e431) * _e435);
                                        let _e1605 = ((_e1567.member[2].x - _e498) * _e503);
                                        let _e1606 = ((_e1567.member[2].y - _e498) * _e503);
                                        let _e1607 = ((_e1567.member[2].z - _e499) * _e503);
                                        let _e1608 = ((_e1567.member[2].w - _e499) * _e503);
                                        let _e1610 = select(_e1607, _e1605, (_e1605 < _e1607));
                                        let _e1612 = select(_e1608, _e1606, (_e1606 < _e1608));
                                        let _e1614 = select(_e1607, _e1605, (_e1605 > _e1607));
                                        let _e1616 = select(_e1608, _e1606, (_e1606 > _e1608));
                                        let _e1618 = select(_e1581, _e1579, (_e1579 < _e1581));
                                        let _e1620 = select(_e1582, _e1580, (_e1580 < _e1582));
                                        let _e1622 = select(_e1594, _e1592, (_e1592 < _e1594));
                                        let _e1624 = select(_e1595, _e1593, (_e1593 < _e1595));
                                        let _e1626 = select(_e1622, _e1618, (_e1618 > _e1622));
                                        let _e1628 = select(_e1624, _e1620, (_e1620 > _e1624));
                                        let _e1630 = select(_e1610, _e1626, (_e1626 > _e1610));
                                        let _e1632 = select(_e1612, _e1628, (_e1628 > _e1612));
                                        let _e1634 = select(_e1581, _e1579, (_e1579 > _e1581));
                                        let _e1636 = select(_e1582, _e1580, (_e1580 > _e1582));
                                        let _e1638 = select(_e1594, _e1592, (_e1592 > _e1594));
                                        let _e1640 = select(_e1595, _e1593, (_e1593 > _e1595));
                                        let _e1642 = select(_e1638, _e1634, (_e1634 < _e1638));
                                        let _e1644 = select(_e1640, _e1636, (_e1636 < _e1640));
                                        let _e1649 = -(_e1610);
                                        let _e1650 = -(_e1612);
                                        let _e1657 = (select(_e1614, _e1642, (_e1642 < _e1614)) + (select(_e1649, _e1614, (_e1614 > _e1649)) * 0.0000019073523f));
                                        let _e1658 = (select(_e1616, _e1644, (_e1644 < _e1616)) + (select(_e1650, _e1616, (_e1616 > _e1650)) * 0.0000019073523f));
                                        let _e1660 = select(_e615, _e1630, (_e1630 > _e615));
                                        let _e1662 = select(_e615, _e1632, (_e1632 > _e615));
                                        let _e1667 = (_e1660 <= select(_e1291.member, _e1657, (_e1657 < _e1291.member)));
                                        let _e1668 = (_e1662 <= select(_e1291.member, _e1658, (_e1658 < _e1291.member)));
                                        let _e1669 = (_e1660 <= _e1662);
                                        if _e1667 {
                                            if _e1668 {
                                                if _e1669 {
                                                    phi_3367_ = _e1567.member_2;
                                                } else {
                                                    phi_3367_ = _e1567.member_1;
                                                }
                                                let _e1673 = phi_3367_;
                                                let _e1694 = (_e700 % 128u);
                                                let _e1695 = (_e1694 < 128u);
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_8[_e1694] = _e1673.member_1;
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_7[_e1694] = _e1673.member.member.x;
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_6[_e1694] = _e1673.member.member.y;
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_5[_e1694] = _e1673.member.member.z;
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_4[_e1694] = _e1673.member.member_1.x;
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_3[_e1694] = _e1673.member.member_1.y;
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_2[_e1694] = _e1673.member.member_1.z;
                                                if _e1695 {
                                                } else {
                                                    phi_3878_ = true;
                                                    break;
                                                }
                                                local_9[_e1694] = select(_e1660, _e1662, _e1669);
                                                if _e1669 {
                                                    phi_3443_ = _e1567.member_1;
                                                } else {
                                                    phi_3443_ = _e1567.member_2;
                                                }
                                                let _e1708 = phi_3443_;
                                                phi_3444_ = (_e700 + 1u);
                                                phi_3445_ = _e1708;
                                            } else {
                                                phi_3444_ = u32();
                                                phi_3445_ = type_49();
                                            }
                                            let _e1710 = phi_3444_;
                                            let _e1712 = phi_3445_;
                                            phi_3447_ = _e1710;
                                            phi_3448_ = _e1712;
                                            phi_3449_ = select(true, false, _e1668);
                                        } else {
                                            phi_3447_ = u32();
                                            phi_3448_ = type_49();
                                            phi_3449_ = true;
                                        }
                                        let _e1715 = phi_3447_;
                                        let _e1717 = phi_3448_;
                                        let _e1719 = phi_3449_;
                                        if _e1719 {
                                            if _e1667 {
                                                phi_3458_ = _e1567.member_1;
                                            } else {
                                                phi_3458_ = _e1567.member_2;
                                            }
                                            let _e1723 = phi_3458_;
                                            phi_3463_ = select(_e1668, true, _e1667);
                                            phi_3465_ = _e1723;
                                        } else {
                                            phi_3463_ = _e698;
                                            phi_3465_ = _e1717;
                                        }
                                        let _e1726 = phi_3463_;
                                        let _e1728 = phi_3465_;
                                        phi_3469_ = _e1726;
                                        phi_3470_ = select(_e1715, _e700, _e1719);
                                        phi_3471_ = _e1728;
                                    }
                                    let _e1731 = phi_3469_;
                                    let _e1733 = phi_3470_;
                                    let _e1735 = phi_3471_;
                                    if _e706 {
                                        phi_3481_ = select(_e700, 0u, _e1291.member_1);
                                        phi_3482_ = _e702;
                                    } else {
                                        phi_3481_ = _e1733;
                                        phi_3482_ = _e1735;
                                    }
                                    let _e1739 = phi_3481_;
                                    let _e1741 = phi_3482_;
                                    phi_3881_ = _e1289;
                                    phi_3483_ = _e1291;
                                    phi_3484_ = (_e661 - 1u);
                                    phi_3485_ = select(_e1731, false, _e706);
                                    phi_3486_ = _e1739;
                                    phi_3487_ = _e1741;
                                } else {
                                    phi_3881_ = _e657;
                                    phi_3483_ = _e659;
                                    phi_3484_ = _e661;
                                    phi_3485_ = _e698;
                                    phi_3486_ = _e700;
                                    phi_3487_ = _e702;
                                }
                                let _e1744 = phi_3881_;
                                let _e1746 = phi_3483_;
                                let _e1748 = phi_3484_;
                                let _e1750 = phi_3485_;
                                let _e1752 = phi_3486_;
                                let _e1754 = phi_3487_;
                                phi_3880_ = _e1744;
                                phi_3488_ = _e1746;
                                phi_3489_ = _e1748;
                                phi_3490_ = _e1750;
                                phi_3491_ = _e1752;
                                phi_3492_ = _e1754;
                            } else {
                                phi_3880_ = _e657;
                                phi_3488_ = type_42();
                                phi_3489_ = u32();
                                phi_3490_ = bool();
                                phi_3491_ = u32();
                                phi_3492_ = type_49();
                            }
                            let _e1756 = phi_3880_;
                            let _e1758 = phi_3488_;
                            let _e1760 = phi_3489_;
                            let _e1762 = phi_3490_;
                            let _e1764 = phi_3491_;
                            let _e1766 = phi_3492_;
                            phi_3879_ = _e1756;
                            phi_1063_ = _e1758;
                            phi_1066_ = _e1760;
                            phi_1068_ = _e1762;
                            phi_1070_ = _e1764;
                            phi_1072_ = _e1766;
                            phi_3493_ = _e671;
                        } else {
                            phi_3879_ = _e657;
                            phi_1063_ = type_42();
                            phi_1066_ = u32();
                            phi_1068_ = bool();
                            phi_1070_ = u32();
                            phi_1072_ = type_49();
                            phi_3493_ = false;
                        }
                        let _e1768 = phi_3879_;
                        let _e1770 = phi_1063_;
                        let _e1772 = phi_1066_;
                        let _e1774 = phi_1068_;
                        let _e1776 = phi_1070_;
                        let _e1778 = phi_1072_;
                        let _e1780 = phi_3493_;
                        continue;
                        continuing {
                            phi_3727_ = _e1768;
                            phi_1062_ = _e1770;
                            phi_1065_ = _e1772;
                            phi_1067_ = _e1774;
                            phi_1069_ = _e1776;
                            phi_1071_ = _e1778;
                            phi_3878_ = _e1768;
                            break if !(_e1780);
                        }
                    }
                    let _e1783 = phi_3878_;
                    if _e1783 {
                        break;
                    }
                    let _e1785 = local_10;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146] = select(0u, 1u, _e1785.member_1);
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
