struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: array<array<u32, 2>>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: type_29,
    member_1: f32,
}

struct type_42 {
    member: array<type_30>,
}

struct type_44 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_33,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_46;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_25;

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
    var phi_1081_: type_44;
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
    var phi_1207_: type_44;
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
    var phi_2214_: type_29;
    var phi_2216_: type_29;
    var phi_2217_: bool;
    var phi_2221_: type_29;
    var phi_2222_: type_29;
    var phi_2223_: type_29;
    var phi_2224_: bool;
    var phi_2228_: type_29;
    var phi_2229_: bool;
    var phi_2230_: type_29;
    var phi_2231_: bool;
    var phi_2232_: bool;
    var phi_2233_: type_29;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2243_: type_29;
    var phi_2244_: bool;
    var phi_2248_: type_29;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var phi_2281_: type_44;
    var phi_2282_: type_44;
    var phi_2283_: type_44;
    var phi_1208_: type_44;
    var phi_3751_: bool;
    var phi_3915_: bool;
    var phi_3523_: type_44;
    var phi_3524_: bool;
    var phi_3525_: u32;
    var phi_3526_: type_51;
    var phi_3914_: bool;
    var phi_3527_: type_44;
    var phi_3528_: bool;
    var phi_3529_: u32;
    var phi_3530_: u32;
    var phi_3531_: type_51;
    var phi_3913_: bool;
    var phi_3532_: type_44;
    var phi_3533_: bool;
    var phi_3534_: u32;
    var phi_3535_: u32;
    var phi_3536_: type_51;
    var phi_3912_: bool;
    var phi_1082_: type_44;
    var phi_1085_: bool;
    var phi_1087_: u32;
    var phi_1089_: u32;
    var phi_1091_: type_51;
    var phi_3537_: bool;
    var phi_3911_: bool;
    var local_10: type_44;
    var local_11: type_44;
    var local_12: type_44;

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
                            phi_391_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_391_;
                        phi_392_ = _e239;
                    } else {
                        phi_392_ = 0i;
                    }
                    let _e241 = phi_392_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_402_ = true;
                    } else {
                        phi_402_ = (_e165 == _e197);
                    }
                    let _e245 = phi_402_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_412_ = _e247;
                        phi_413_ = _e247;
                        phi_415_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_412_ = u32();
                        phi_413_ = 0u;
                        phi_415_ = true;
                    }
                    let _e251 = phi_412_;
                    let _e253 = phi_413_;
                    let _e255 = phi_415_;
                    if _e255 {
                        phi_420_ = (_e253 + 1u);
                    } else {
                        phi_420_ = 0u;
                    }
                    let _e259 = phi_420_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_433_ = -126i;
                    } else {
                        phi_433_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_433_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_453_ = -126i;
                    } else {
                        phi_453_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_453_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_5.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_471_ = _e298[0];
                    } else {
                        phi_471_ = _e298[1];
                    }
                    let _e303 = phi_471_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_477_ = _e298[2];
                    } else {
                        phi_477_ = _e303;
                    }
                    let _e307 = phi_477_;
                    let _e308 = bitcast<u32>(_e307);
                    let _e310 = ((_e308 & 2139095040u) != 0u);
                    let _e324 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e308 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e308 & 2147483648u))), _e307, _e310) * _e271) * select(0.00000011920929f, 1f, _e310)) * _e277);
                    let _e325 = global_5.member[_e146].member_2;
                    if _e299 {
                        phi_517_ = _e325[0];
                    } else {
                        phi_517_ = _e325[1];
                    }
                    let _e329 = phi_517_;
                    if _e304 {
                        phi_523_ = _e325[2];
                    } else {
                        phi_523_ = _e329;
                    }
                    let _e332 = phi_523_;
                    let _e333 = bitcast<u32>(_e332);
                    let _e335 = ((_e333 & 2139095040u) != 0u);
                    let _e349 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e333 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e333 & 2147483648u))), _e332, _e335) * _e288) * select(0.00000011920929f, 1f, _e335)) * _e294);
                    let _e353 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e353 {
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                        phi_575_ = select(0.00000000000011368684f, _e357, (_e357 > 0.00000000000011368684f));
                    } else {
                        phi_575_ = 0f;
                    }
                    let _e361 = phi_575_;
                    let _e362 = (_e324 + _e361);
                    let _e363 = (_e324 - _e361);
                    let _e364 = select(_e349, 0f, _e353);
                    if _e353 {
                        phi_587_ = 38685626000000000000000000f;
                    } else {
                        phi_587_ = (1f / _e349);
                    }
                    let _e367 = phi_587_;
                    let _e368 = (_e259 == 0u);
                    if _e368 {
                        phi_596_ = _e298[0];
                    } else {
                        phi_596_ = _e298[1];
                    }
                    let _e372 = phi_596_;
                    let _e373 = (_e259 == 2u);
                    if _e373 {
                        phi_602_ = _e298[2];
                    } else {
                        phi_602_ = _e372;
                    }
                    let _e376 = phi_602_;
                    let _e377 = bitcast<u32>(_e376);
                    let _e379 = ((_e377 & 2139095040u) != 0u);
                    let _e393 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e377 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e377 & 2147483648u))), _e376, _e379) * _e271) * select(0.00000011920929f, 1f, _e379)) * _e277);
                    if _e368 {
                        phi_642_ = _e325[0];
                    } else {
                        phi_642_ = _e325[1];
                    }
                    let _e397 = phi_642_;
                    if _e373 {
                        phi_648_ = _e325[2];
                    } else {
                        phi_648_ = _e397;
                    }
                    let _e400 = phi_648_;
                    let _e401 = bitcast<u32>(_e400);
                    let _e403 = ((_e401 & 2139095040u) != 0u);
                    let _e417 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e400, _e403) * _e288) * select(0.00000011920929f, 1f, _e403)) * _e294);
                    let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e421 {
                        let _e425 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) * 0.00000011920929f);
                        phi_700_ = select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f));
                    } else {
                        phi_700_ = 0f;
                    }
                    let _e429 = phi_700_;
                    let _e430 = (_e393 + _e429);
                    let _e431 = (_e393 - _e429);
                    let _e432 = select(_e417, 0f, _e421);
                    if _e421 {
                        phi_712_ = 38685626000000000000000000f;
                    } else {
                        phi_712_ = (1f / _e417);
                    }
                    let _e435 = phi_712_;
                    let _e436 = (_e261 == 0u);
                    if _e436 {
                        phi_721_ = _e298[0];
                    } else {
                        phi_721_ = _e298[1];
                    }
                    let _e440 = phi_721_;
                    let _e441 = (_e261 == 2u);
                    if _e441 {
                        phi_727_ = _e298[2];
                    } else {
                        phi_727_ = _e440;
                    }
                    let _e444 = phi_727_;
                    let _e445 = bitcast<u32>(_e444);
                    let _e447 = ((_e445 & 2139095040u) != 0u);
                    let _e461 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e445 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e445 & 2147483648u))), _e444, _e447) * _e271) * select(0.00000011920929f, 1f, _e447)) * _e277);
                    if _e436 {
                        phi_767_ = _e325[0];
                    } else {
                        phi_767_ = _e325[1];
                    }
                    let _e465 = phi_767_;
                    if _e441 {
                        phi_773_ = _e325[2];
                    } else {
                        phi_773_ = _e465;
                    }
                    let _e468 = phi_773_;
                    let _e469 = bitcast<u32>(_e468);
                    let _e471 = ((_e469 & 2139095040u) != 0u);
                    let _e485 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e469 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e469 & 2147483648u))), _e468, _e471) * _e288) * select(0.00000011920929f, 1f, _e471)) * _e294);
                    let _e489 = (bitcast<f32>((bitcast<u32>(_e485) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e489 {
                        let _e493 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) * 0.00000011920929f);
                        phi_825_ = select(0.00000000000011368684f, _e493, (_e493 > 0.00000000000011368684f));
                    } else {
                        phi_825_ = 0f;
                    }
                    let _e497 = phi_825_;
                    let _e498 = (_e461 + _e497);
                    let _e499 = (_e461 - _e497);
                    let _e500 = select(_e485, 0f, _e489);
                    if _e489 {
                        phi_837_ = 38685626000000000000000000f;
                    } else {
                        phi_837_ = (1f / _e485);
                    }
                    let _e503 = phi_837_;
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
                            phi_892_ = 255i;
                        } else {
                            phi_892_ = (((_e530 + select(0i, 1i, (_e530 == 0i))) - _e537) + _e517);
                        }
                        let _e545 = phi_892_;
                        let _e555 = (_e545 <= 0i);
                        if _e555 {
                            phi_915_ = u32();
                        } else {
                            if _e534 {
                                phi_914_ = u32();
                            } else {
                                phi_914_ = select(((bitcast<u32>(_e545) << bitcast<u32>(23i)) | ((_e527 << bitcast<u32>(((_e537 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e545 >= 255i));
                            }
                            let _e559 = phi_914_;
                            phi_915_ = _e559;
                        }
                        let _e561 = phi_915_;
                        let _e573 = ((_e218 & 8388607u) | (select(0u, 1u, ((_e218 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e576 = bitcast<i32>((_e218 >> bitcast<u32>(23i)));
                        let _e580 = (_e573 == 0u);
                        let _e583 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e573)), 32u, _e580)) - 8i);
                        if (_e576 == 255i) {
                            phi_952_ = 255i;
                        } else {
                            phi_952_ = (((_e576 + select(0i, 1i, (_e576 == 0i))) - _e583) + _e517);
                        }
                        let _e591 = phi_952_;
                        let _e601 = (_e591 <= 0i);
                        if _e601 {
                            phi_975_ = u32();
                        } else {
                            if _e580 {
                                phi_974_ = u32();
                            } else {
                                phi_974_ = select(((bitcast<u32>(_e591) << bitcast<u32>(23i)) | ((_e573 << bitcast<u32>(((_e583 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e591 >= 255i));
                            }
                            let _e605 = phi_974_;
                            phi_975_ = _e605;
                        }
                        let _e607 = phi_975_;
                        phi_983_ = bitcast<f32>(((_e217 & 2147483648u) | select(_e607, 0u, select(_e580, true, _e601))));
                        phi_984_ = bitcast<f32>(((_e208 & 2147483648u) | select(_e561, 0u, select(_e534, true, _e555))));
                    } else {
                        phi_983_ = 0f;
                        phi_984_ = 1f;
                    }
                    let _e613 = phi_983_;
                    let _e615 = phi_984_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e620 = (_e260 % 3u);
                    let _e621 = (_e620 < 3u);
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e623 = local_1[_e620];
                    let _e626 = (_e259 % 3u);
                    let _e627 = (_e626 < 3u);
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e629 = local_1[_e626];
                    let _e632 = (_e261 % 3u);
                    let _e633 = (_e632 < 3u);
                    if _e633 {
                    } else {
                        break;
                    }
                    let _e635 = local_1[_e632];
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e640 = local[_e620];
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e644 = local[_e626];
                    if _e633 {
                    } else {
                        break;
                    }
                    let _e648 = local[_e632];
                    phi_3757_ = false;
                    phi_1081_ = type_44(type_38(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e613), 0u, 0u);
                    phi_1084_ = (_e615 <= _e613);
                    phi_1086_ = ((3u * _e90) + 1u);
                    phi_1088_ = 0u;
                    phi_1090_ = type_51(type_33(vec4<f32>((f32(_e623) * _e140), (f32(_e629) * _e140), (f32(_e635) * _e140), 0f), vec4<f32>((f32(_e640) * _e140), (f32(_e644) * _e140), (f32(_e648) * _e140), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    loop {
                        let _e658 = phi_3757_;
                        let _e660 = phi_1081_;
                        let _e662 = phi_1084_;
                        let _e664 = phi_1086_;
                        let _e666 = phi_1088_;
                        let _e668 = phi_1090_;
                        local_10 = _e660;
                        local_11 = _e660;
                        if _e662 {
                            phi_1101_ = true;
                        } else {
                            phi_1101_ = (_e666 > 0u);
                        }
                        let _e671 = phi_1101_;
                        if _e671 {
                            let _e672 = (_e664 > 0u);
                            if _e672 {
                                if _e662 {
                                    phi_1187_ = _e662;
                                    phi_1188_ = _e666;
                                    phi_1189_ = _e668;
                                } else {
                                    let _e673 = (_e666 - 1u);
                                    let _e674 = (_e673 % 128u);
                                    let _e675 = (_e674 < 128u);
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e677 = local_7[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e679 = local_6[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e681 = local_5[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e683 = local_4[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e685 = local_3[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e687 = local_2[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e692 = local_8[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3911_ = true;
                                        break;
                                    }
                                    let _e695 = local_9[_e674];
                                    phi_1187_ = (_e695 <= _e660.member.member_1);
                                    phi_1188_ = _e673;
                                    phi_1189_ = type_51(type_33(vec4<f32>(_e677, _e679, _e681, 0f), vec4<f32>(_e683, _e685, _e687, 0f)), _e692);
                                }
                                let _e700 = phi_1187_;
                                let _e702 = phi_1188_;
                                let _e704 = phi_1189_;
                                if _e700 {
                                    if ((_e704.member_1 & 2147483648u) != 0u) {
                                        phi_1207_ = _e660;
                                        phi_1210_ = type_4(0u, ((_e704.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1161 = phi_1207_;
                                            let _e1163 = phi_1210_;
                                            local_12 = _e1161;
                                            if (_e1163.member < _e1163.member_1) {
                                                phi_1211_ = type_4((_e1163.member + 1u), _e1163.member_1);
                                                phi_1233_ = type_4(1u, _e1163.member);
                                            } else {
                                                phi_1211_ = _e1163;
                                                phi_1233_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1176 = phi_1211_;
                                            let _e1178 = phi_1233_;
                                            let _e1182 = (bitcast<i32>(_e1178.member) != 0i);
                                            if _e1182 {
                                                let _e1188 = type_44(_e1161.member, _e1161.member_1, (_e1161.member_2 + 1u));
                                                let _e1189 = ((_e704.member_1 & 268435455u) + _e1178.member_1);
                                                let _e1190 = (_e1189 < _e92);
                                                if _e1190 {
                                                    if _e1190 {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1194 = global_2.member[_e1189].member_1;
                                                    phi_1257_ = _e1194;
                                                } else {
                                                    phi_1257_ = 4294967295u;
                                                }
                                                let _e1196 = phi_1257_;
                                                if (_e1189 >= _e92) {
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1190 {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    if (_e620 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1203 = global_2.member[_e1189].member[_e620];
                                                    if (_e626 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1209 = global_2.member[_e1189].member[_e626];
                                                    if (_e632 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1215 = global_2.member[_e1189].member[_e632];
                                                    let _e1217 = (3u + _e620);
                                                    if (_e1217 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1223 = global_2.member[_e1189].member[_e1217];
                                                    let _e1224 = (3u + _e626);
                                                    if (_e1224 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1230 = global_2.member[_e1189].member[_e1224];
                                                    let _e1231 = (3u + _e632);
                                                    if (_e1231 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1237 = global_2.member[_e1189].member[_e1231];
                                                    let _e1239 = (6u + _e620);
                                                    if (_e1239 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1245 = global_2.member[_e1189].member[_e1239];
                                                    let _e1246 = (6u + _e626);
                                                    if (_e1246 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1252 = global_2.member[_e1189].member[_e1246];
                                                    let _e1253 = (6u + _e632);
                                                    if (_e1253 < 9u) {
                                                    } else {
                                                        phi_3751_ = true;
                                                        break;
                                                    }
                                                    let _e1259 = global_2.member[_e1189].member[_e1253];
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1203, _e1209, _e1215), array<f32, 3>(_e1223, _e1230, _e1237), array<f32, 3>(_e1245, _e1252, _e1259));
                                                }
                                                let _e1263 = phi_1349_;
                                                let _e1272 = (_e1263[0][2] - _e461);
                                                let _e1275 = (((_e1263[0][0] - _e324) * _e500) - (_e1272 * _e364));
                                                let _e1278 = (((_e1263[0][1] - _e393) * _e500) - (_e1272 * _e432));
                                                let _e1285 = (_e1263[1][2] - _e461);
                                                let _e1288 = (((_e1263[1][0] - _e324) * _e500) - (_e1285 * _e364));
                                                let _e1291 = (((_e1263[1][1] - _e393) * _e500) - (_e1285 * _e432));
                                                let _e1298 = (_e1263[2][2] - _e461);
                                                let _e1301 = (((_e1263[2][0] - _e324) * _e500) - (_e1298 * _e364));
                                                let _e1304 = (((_e1263[2][1] - _e393) * _e500) - (_e1298 * _e432));
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
                                                        phi_2233_ = type_29();
                                                        phi_2234_ = true;
                                                        phi_2235_ = false;
                                                    } else {
                                                        let _e1339 = select(_e1288, _e1275, (_e1275 < _e1288));
                                                        if (select(_e1301, _e1339, (_e1339 < _e1301)) > 0f) {
                                                            phi_1501_ = true;
                                                        } else {
                                                            let _e1344 = select(_e1288, _e1275, (_e1275 > _e1288));
                                                            phi_1501_ = (select(_e1301, _e1344, (_e1344 > _e1301)) < 0f);
                                                        }
                                                        let _e1349 = phi_1501_;
                                                        if _e1349 {
                                                            phi_2230_ = type_29();
                                                            phi_2231_ = true;
                                                            phi_2232_ = false;
                                                        } else {
                                                            let _e1351 = select(_e1291, _e1278, (_e1278 < _e1291));
                                                            if (select(_e1304, _e1351, (_e1351 < _e1304)) > 0f) {
                                                                phi_1530_ = true;
                                                            } else {
                                                                let _e1356 = select(_e1291, _e1278, (_e1278 > _e1291));
                                                                phi_1530_ = (select(_e1304, _e1356, (_e1356 > _e1304)) < 0f);
                                                            }
                                                            let _e1361 = phi_1530_;
                                                            if _e1361 {
                                                                phi_2228_ = type_29();
                                                                phi_2229_ = false;
                                                            } else {
                                                                let _e1363 = select(_e1263[1][0], _e1263[0][0], (_e1263[0][0] < _e1263[1][0]));
                                                                let _e1367 = select(_e1263[1][0], _e1263[0][0], (_e1263[0][0] > _e1263[1][0]));
                                                                let _e1371 = select(_e1263[1][1], _e1263[0][1], (_e1263[0][1] < _e1263[1][1]));
                                                                let _e1375 = select(_e1263[1][1], _e1263[0][1], (_e1263[0][1] > _e1263[1][1]));
                                                                let _e1379 = select(_e1263[1][2], _e1263[0][2], (_e1263[0][2] < _e1263[1][2]));
                                                                let _e1383 = select(_e1263[1][2], _e1263[0][2], (_e1263[0][2] > _e1263[1][2]));
                                                                let _e1388 = ((select(_e1263[2][0], _e1363, (_e1363 < _e1263[2][0])) - _e362) * _e367);
                                                                let _e1389 = ((select(_e1263[2][0], _e1367, (_e1367 > _e1263[2][0])) - _e363) * _e367);
                                                                let _e1392 = ((select(_e1263[2][1], _e1371, (_e1371 < _e1263[2][1])) - _e430) * _e435);
                                                                let _e1393 = ((select(_e1263[2][1], _e1375, (_e1375 > _e1263[2][1])) - _e431) * _e435);
                                                                let _e1396 = ((select(_e1263[2][2], _e1379, (_e1379 < _e1263[2][2])) - _e498) * _e503);
                                                                let _e1397 = ((select(_e1263[2][2], _e1383, (_e1383 > _e1263[2][2])) - _e499) * _e503);
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
                                                                let _e1424 = select(_e615, _e1409, (_e1409 > _e615));
                                                                if (_e1424 > (_e1417 + (select(_e1418, _e1401, (_e1401 > _e1418)) * 0.0000019073523f))) {
                                                                    phi_2223_ = type_29();
                                                                    phi_2224_ = true;
                                                                } else {
                                                                    let _e1426 = (_e1424 > _e1161.member.member_1);
                                                                    if _e1426 {
                                                                        phi_2222_ = type_29();
                                                                    } else {
                                                                        let _e1427 = vec3<f32>(_e1263[0][0], _e1263[0][1], _e1263[0][2]);
                                                                        let _e1428 = vec3<f32>(_e1263[1][0], _e1263[1][1], _e1263[1][2]);
                                                                        let _e1429 = vec3<f32>(_e1263[2][0], _e1263[2][1], _e1263[2][2]);
                                                                        let _e1430 = (_e1263[1][0] - _e1263[0][0]);
                                                                        let _e1431 = (_e1263[1][1] - _e1263[0][1]);
                                                                        let _e1432 = (_e1263[1][2] - _e1263[0][2]);
                                                                        let _e1433 = vec3<f32>(_e1430, _e1431, _e1432);
                                                                        let _e1434 = (_e1263[2][0] - _e1263[1][0]);
                                                                        let _e1435 = (_e1263[2][1] - _e1263[1][1]);
                                                                        let _e1436 = (_e1263[2][2] - _e1263[1][2]);
                                                                        let _e1437 = vec3<f32>(_e1434, _e1435, _e1436);
                                                                        let _e1438 = (_e1263[0][0] - _e1263[2][0]);
                                                                        let _e1439 = (_e1263[0][1] - _e1263[2][1]);
                                                                        let _e1440 = (_e1263[0][2] - _e1263[2][2]);
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
                                                                            phi_1949_ = _e1291;
                                                                            phi_1950_ = _e1288;
                                                                            phi_1951_ = _e1278;
                                                                            phi_1952_ = _e1275;
                                                                            phi_1953_ = _e1427;
                                                                            phi_1954_ = _e1441;
                                                                            phi_1955_ = _e1437;
                                                                            phi_1956_ = _e1433;
                                                                        } else {
                                                                            let _e1486 = (_e1467 == _e1484);
                                                                            let _e1491 = vec3(_e1486);
                                                                            phi_1949_ = select(_e1278, _e1304, _e1486);
                                                                            phi_1950_ = select(_e1275, _e1301, _e1486);
                                                                            phi_1951_ = select(_e1304, _e1291, _e1486);
                                                                            phi_1952_ = select(_e1301, _e1288, _e1486);
                                                                            phi_1953_ = select(_e1429, _e1428, _e1491);
                                                                            phi_1954_ = select(_e1437, _e1433, _e1491);
                                                                            phi_1955_ = select(_e1433, _e1441, _e1491);
                                                                            phi_1956_ = select(_e1441, _e1437, _e1491);
                                                                        }
                                                                        let _e1497 = phi_1949_;
                                                                        let _e1499 = phi_1950_;
                                                                        let _e1501 = phi_1951_;
                                                                        let _e1503 = phi_1952_;
                                                                        let _e1505 = phi_1953_;
                                                                        let _e1507 = phi_1954_;
                                                                        let _e1509 = phi_1955_;
                                                                        let _e1511 = phi_1956_;
                                                                        let _e1518 = ((_e1509.y * _e1507.z) - (_e1507.y * _e1509.z));
                                                                        let _e1523 = ((_e1509.z * _e1507.x) - (_e1507.z * _e1509.x));
                                                                        let _e1526 = ((_e1509.x * _e1507.y) - (_e1507.x * _e1509.y));
                                                                        if (_e1326 >= _e1330) {
                                                                            phi_1993_ = select(true, false, (_e1326 >= _e1334));
                                                                        } else {
                                                                            phi_1993_ = true;
                                                                        }
                                                                        let _e1531 = phi_1993_;
                                                                        if _e1531 {
                                                                            phi_2002_ = select(_e1429, _e1428, vec3((_e1330 >= _e1334)));
                                                                        } else {
                                                                            phi_2002_ = _e1427;
                                                                        }
                                                                        let _e1536 = phi_2002_;
                                                                        let _e1547 = (((_e1518 * (_e1536.x - _e324)) + (_e1523 * (_e1536.y - _e393))) + (_e1526 * (_e1536.z - _e461)));
                                                                        let _e1552 = (((_e1518 * _e364) + (_e1523 * _e432)) + (_e1526 * _e500));
                                                                        let _e1553 = (_e1499 - _e1503);
                                                                        let _e1554 = (_e1497 - _e1501);
                                                                        let _e1562 = (-(((_e1503 * _e1553) + (_e1501 * _e1554))) / ((_e1553 * _e1553) + (_e1554 * _e1554)));
                                                                        let _e1564 = select(1f, _e1562, (_e1562 < 1f));
                                                                        let _e1566 = select(0f, _e1564, (_e1564 > 0f));
                                                                        let _e1579 = ((_e1505.x + (_e1511.x * _e1566)) - _e324);
                                                                        let _e1580 = ((_e1505.y + (_e1511.y * _e1566)) - _e393);
                                                                        let _e1581 = ((_e1505.z + (_e1511.z * _e1566)) - _e461);
                                                                        let _e1582 = (_e1581 / _e500);
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
                                                                                phi_2167_ = (_e1547 / _e1552);
                                                                            } else {
                                                                                phi_2167_ = f32();
                                                                            }
                                                                            let _e1657 = phi_2167_;
                                                                            phi_2169_ = _e1657;
                                                                            phi_2170_ = select(true, false, _e1654);
                                                                        } else {
                                                                            phi_2169_ = f32();
                                                                            phi_2170_ = true;
                                                                        }
                                                                        let _e1660 = phi_2169_;
                                                                        let _e1662 = phi_2170_;
                                                                        if _e1662 {
                                                                            let _e1670 = (((_e1518 * (_e1579 - (_e364 * _e1582))) + (_e1523 * (_e1580 - (_e432 * _e1582)))) / _e1552);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1670) & 2147483647u)) <= _e1484) {
                                                                                phi_2190_ = (_e1582 + _e1670);
                                                                            } else {
                                                                                phi_2190_ = _e1582;
                                                                            }
                                                                            let _e1677 = phi_2190_;
                                                                            phi_2191_ = _e1677;
                                                                        } else {
                                                                            phi_2191_ = _e1660;
                                                                        }
                                                                        let _e1679 = phi_2191_;
                                                                        let _e1681 = select(_e1417, _e1679, (_e1679 < _e1417));
                                                                        let _e1683 = select(_e1409, _e1681, (_e1681 > _e1409));
                                                                        if (_e1683 >= _e615) {
                                                                            let _e1685 = (_e1683 <= _e1161.member.member_1);
                                                                            if _e1685 {
                                                                                let _e1686 = (1f / _e1336);
                                                                                phi_2214_ = type_29(_e1683, (_e1330 * _e1686), (_e1334 * _e1686), _e1196);
                                                                            } else {
                                                                                phi_2214_ = type_29();
                                                                            }
                                                                            let _e1691 = phi_2214_;
                                                                            phi_2216_ = _e1691;
                                                                            phi_2217_ = select(true, false, _e1685);
                                                                        } else {
                                                                            phi_2216_ = type_29();
                                                                            phi_2217_ = true;
                                                                        }
                                                                        let _e1694 = phi_2216_;
                                                                        let _e1696 = phi_2217_;
                                                                        if _e1696 {
                                                                            phi_2221_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2221_ = _e1694;
                                                                        }
                                                                        let _e1698 = phi_2221_;
                                                                        phi_2222_ = _e1698;
                                                                    }
                                                                    let _e1700 = phi_2222_;
                                                                    phi_2223_ = _e1700;
                                                                    phi_2224_ = _e1426;
                                                                }
                                                                let _e1702 = phi_2223_;
                                                                let _e1704 = phi_2224_;
                                                                phi_2228_ = _e1702;
                                                                phi_2229_ = _e1704;
                                                            }
                                                            let _e1706 = phi_2228_;
                                                            let _e1708 = phi_2229_;
                                                            phi_2230_ = _e1706;
                                                            phi_2231_ = _e1361;
                                                            phi_2232_ = _e1708;
                                                        }
                                                        let _e1710 = phi_2230_;
                                                        let _e1712 = phi_2231_;
                                                        let _e1714 = phi_2232_;
                                                        phi_2233_ = _e1710;
                                                        phi_2234_ = _e1712;
                                                        phi_2235_ = _e1714;
                                                    }
                                                    let _e1716 = phi_2233_;
                                                    let _e1718 = phi_2234_;
                                                    let _e1720 = phi_2235_;
                                                    phi_2243_ = _e1716;
                                                    phi_2244_ = select(_e1720, true, _e1718);
                                                } else {
                                                    phi_2243_ = type_29();
                                                    phi_2244_ = true;
                                                }
                                                let _e1723 = phi_2243_;
                                                let _e1725 = phi_2244_;
                                                if _e1725 {
                                                    phi_2248_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2248_ = _e1723;
                                                }
                                                let _e1727 = phi_2248_;
                                                if (_e1727.member_3 != 4294967295u) {
                                                    if (_e1196 != 4294967295u) {
                                                        if (_e1727.member < _e1161.member.member.member) {
                                                            phi_2274_ = true;
                                                        } else {
                                                            if (_e1727.member == _e1161.member.member.member) {
                                                                phi_2273_ = (_e1727.member_3 < _e1161.member.member.member_3);
                                                            } else {
                                                                phi_2273_ = false;
                                                            }
                                                            let _e1742 = phi_2273_;
                                                            phi_2274_ = _e1742;
                                                        }
                                                        let _e1744 = phi_2274_;
                                                        if _e1744 {
                                                            phi_2281_ = type_44(type_38(_e1727, _e1727.member), _e1188.member_1, _e1188.member_2);
                                                        } else {
                                                            phi_2281_ = _e1188;
                                                        }
                                                        let _e1751 = phi_2281_;
                                                        phi_2282_ = _e1751;
                                                    } else {
                                                        phi_2282_ = _e1188;
                                                    }
                                                    let _e1753 = phi_2282_;
                                                    phi_2283_ = _e1753;
                                                } else {
                                                    phi_2283_ = _e1188;
                                                }
                                                let _e1755 = phi_2283_;
                                                phi_1208_ = _e1755;
                                            } else {
                                                phi_1208_ = type_44();
                                            }
                                            let _e1757 = phi_1208_;
                                            continue;
                                            continuing {
                                                phi_1207_ = _e1757;
                                                phi_1210_ = _e1176;
                                                phi_3751_ = _e658;
                                                break if !(_e1182);
                                            }
                                        }
                                        let _e1760 = phi_3751_;
                                        phi_3911_ = _e1760;
                                        if _e1760 {
                                            break;
                                        }
                                        phi_3915_ = _e1760;
                                        let _e1938 = local_12;
                                        phi_3523_ = _e1938;
                                        phi_3524_ = false;
                                        phi_3525_ = _e702;
                                        phi_3526_ = _e704;
                                    } else {
                                        if (_e704.member_1 >= _e90) {
                                            phi_3054_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e704.member_1 < _e90) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e716 = ((1u + _e260) % 4u);
                                            if (_e716 < 4u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e721 = global_4.member[_e704.member_1][_e716];
                                            let _e723 = (_e721 >> bitcast<u32>(11u));
                                            let _e725 = ((1u + _e259) % 4u);
                                            if (_e725 < 4u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e730 = global_4.member[_e704.member_1][_e725];
                                            let _e732 = (_e730 >> bitcast<u32>(11u));
                                            let _e734 = ((1u + _e261) % 4u);
                                            if (_e734 < 4u) {
                                            } else {
                                                phi_3911_ = true;
                                                break;
                                            }
                                            let _e739 = global_4.member[_e704.member_1][_e734];
                                            let _e741 = (_e739 >> bitcast<u32>(11u));
                                            let _e764 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.x - _e704.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e765 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.y - _e704.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e766 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.z - _e704.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e768 = select(_e140, _e764, (_e764 > _e140));
                                            let _e770 = select(_e140, _e765, (_e765 > _e140));
                                            let _e772 = select(_e140, _e766, (_e766 > _e140));
                                            let _e803 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e721 & 1023u))) - 8388608f) * _e768));
                                            let _e808 = (bitcast<i32>((_e721 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e811 = bitcast<f32>((_e803 & bitcast<u32>(_e808)));
                                            let _e812 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 1023u))) - 8388608f) * _e770));
                                            let _e817 = (bitcast<i32>((_e730 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e820 = bitcast<f32>((_e812 & bitcast<u32>(_e817)));
                                            let _e821 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e739 & 1023u))) - 8388608f) * _e772));
                                            let _e826 = (bitcast<i32>((_e739 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e829 = bitcast<f32>((_e821 & bitcast<u32>(_e826)));
                                            let _e833 = bitcast<f32>((_e803 & bitcast<u32>(~(_e808))));
                                            let _e837 = bitcast<f32>((_e812 & bitcast<u32>(~(_e817))));
                                            let _e841 = bitcast<f32>((_e821 & bitcast<u32>(~(_e826))));
                                            let _e842 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e723 & 1023u))) - 8388608f) * _e768));
                                            let _e847 = (bitcast<i32>((_e723 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e850 = bitcast<f32>((_e842 & bitcast<u32>(_e847)));
                                            let _e851 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e732 & 1023u))) - 8388608f) * _e770));
                                            let _e856 = (bitcast<i32>((_e732 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e859 = bitcast<f32>((_e851 & bitcast<u32>(_e856)));
                                            let _e860 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e741 & 1023u))) - 8388608f) * _e772));
                                            let _e865 = (bitcast<i32>((_e741 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e868 = bitcast<f32>((_e860 & bitcast<u32>(_e865)));
                                            let _e872 = bitcast<f32>((_e842 & bitcast<u32>(~(_e847))));
                                            let _e876 = bitcast<f32>((_e851 & bitcast<u32>(~(_e856))));
                                            let _e880 = bitcast<f32>((_e860 & bitcast<u32>(~(_e865))));
                                            let _e910 = global_4.member[_e704.member_1][0u];
                                            let _e914 = global_4.member[_e704.member_1][1u];
                                            let _e918 = global_4.member[_e704.member_1][2u];
                                            let _e922 = global_4.member[_e704.member_1][3u];
                                            let _e934 = (((_e914 >> bitcast<u32>(22i)) | ((_e918 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e922 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e935 = (_e910 & 268435455u);
                                            let _e936 = (_e934 & 268435455u);
                                            let _e939 = ((_e910 >> bitcast<u32>(28u)) & 7u);
                                            let _e947 = ((_e910 >> bitcast<u32>(31i)) | (((_e934 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e948 = (_e939 != 0u);
                                            if (_e939 == 0u) {
                                                phi_3016_ = _e935;
                                            } else {
                                                if (_e939 == 7u) {
                                                    phi_3015_ = 2147483648u;
                                                } else {
                                                    phi_3015_ = ((2147483648u | (_e939 << bitcast<u32>(28u))) | (_e936 & 268435455u));
                                                }
                                                let _e957 = phi_3015_;
                                                phi_3016_ = _e957;
                                            }
                                            let _e959 = phi_3016_;
                                            if _e948 {
                                                let _e960 = (_e939 != 7u);
                                                if _e960 {
                                                    phi_3026_ = (_e936 + _e939);
                                                } else {
                                                    phi_3026_ = u32();
                                                }
                                                let _e963 = phi_3026_;
                                                phi_3028_ = _e963;
                                                phi_3029_ = select(true, false, _e960);
                                            } else {
                                                phi_3028_ = u32();
                                                phi_3029_ = true;
                                            }
                                            let _e966 = phi_3028_;
                                            let _e968 = phi_3029_;
                                            if (_e947 == 0u) {
                                                phi_3050_ = (_e935 + select(0u, 1u, !(_e948)));
                                            } else {
                                                if (_e947 == 7u) {
                                                    phi_3049_ = 2147483648u;
                                                } else {
                                                    phi_3049_ = ((2147483648u | (_e947 << bitcast<u32>(28u))) | (select(_e966, _e936, _e968) & 268435455u));
                                                }
                                                let _e981 = phi_3049_;
                                                phi_3050_ = _e981;
                                            }
                                            let _e983 = phi_3050_;
                                            phi_3054_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e704.member.member.x + _e811), (_e704.member.member.x + _e833), (_e704.member.member_1.x - _e850), (_e704.member.member_1.x - _e872)), vec4<f32>((_e704.member.member.y + _e820), (_e704.member.member.y + _e837), (_e704.member.member_1.y - _e859), (_e704.member.member_1.y - _e876)), vec4<f32>((_e704.member.member.z + _e829), (_e704.member.member.z + _e841), (_e704.member.member_1.z - _e868), (_e704.member.member_1.z - _e880))), type_51(type_33((_e704.member.member + vec4<f32>(_e811, _e820, _e829, 0f)), (_e704.member.member_1 - vec4<f32>(_e850, _e859, _e868, 0f))), _e959), type_51(type_33((_e704.member.member + vec4<f32>(_e833, _e837, _e841, 0f)), (_e704.member.member_1 - vec4<f32>(_e872, _e876, _e880, 0f))), _e983));
                                        }
                                        let _e988 = phi_3054_;
                                        let _e1007 = ((_e988.member[0].x - _e362) * _e367);
                                        let _e1008 = ((_e988.member[0].y - _e362) * _e367);
                                        let _e1009 = ((_e988.member[0].z - _e363) * _e367);
                                        let _e1010 = ((_e988.member[0].w - _e363) * _e367);
                                        let _e1020 = ((_e988.member[1].x - _e430) * _e435);
                                        let _e1021 = ((_e988.member[1].y - _e430) * _e435);
                                        let _e1022 = ((_e988.member[1].z - _e431) * _e435);
                                        let _e1023 = ((_e988.member[1].w - _e431) * _e435);
                                        let _e1033 = ((_e988.member[2].x - _e498) * _e503);
                                        let _e1034 = ((_e988.member[2].y - _e498) * _e503);
                                        let _e1035 = ((_e988.member[2].z - _e499) * _e503);
                                        let _e1036 = ((_e988.member[2].w - _e499) * _e503);
                                        let _e1038 = select(_e1035, _e1033, (_e1033 < _e1035));
                                        let _e1040 = select(_e1036, _e1034, (_e1034 < _e1036));
                                        let _e1042 = select(_e1035, _e1033, (_e1033 > _e1035));
                                        let _e1044 = select(_e1036, _e1034, (_e1034 > _e1036));
                                        let _e1046 = select(_e1009, _e1007, (_e1007 < _e1009));
                                        let _e1048 = select(_e1010, _e1008, (_e1008 < _e1010));
                                        let _e1050 = select(_e1022, _e1020, (_e1020 < _e1022));
                                        let _e1052 = select(_e1023, _e1021, (_e1021 < _e1023));
                                        let _e1054 = select(_e1050, _e1046, (_e1046 > _e1050));
                                        let _e1056 = select(_e1052, _e1048, (_e1048 > _e1052));
                                        let _e1058 = select(_e1038, _e1054, (_e1054 > _e1038));
                                        let _e1060 = select(_e1040, _e1056, (_e1056 > _e1040));
                                        let _e1062 = select(_e1009, _e1007, (_e1007 > _e1009));
                                        let _e1064 = select(_e1010, _e1008, (_e1008 > _e1010));
                                        let _e1066 = select(_e1022, _e1020, (_e1020 > _e1022));
                                        let _e1068 = select(_e1023, _e1021, (_e1021 > _e1023));
                                        let _e1070 = select(_e1066, _e1062, (_e1062 < _e1066));
                                        let _e1072 = select(_e1068, _e1064, (_e1064 < _e1068));
                                        let _e1077 = -(_e1038);
                                        let _e1078 = -(_e1040);
                                        let _e1085 = (select(_e1042, _e1070, (_e1070 < _e1042)) + (select(_e1077, _e1042, (_e1042 > _e1077)) * 0.0000019073523f));
                                        let _e1086 = (select(_e1044, _e1072, (_e1072 < _e1044)) + (select(_e1078, _e1044, (_e1044 > _e1078)) * 0.0000019073523f));
                                        let _e1088 = select(_e615, _e1058, (_e1058 > _e615));
                                        let _e1090 = select(_e615, _e1060, (_e1060 > _e615));
                                        let _e1095 = (_e1088 <= select(_e660.member.member_1, _e1085, (_e1085 < _e660.member.member_1)));
                                        let _e1096 = (_e1090 <= select(_e660.member.member_1, _e1086, (_e1086 < _e660.member.member_1)));
                                        let _e1097 = (_e1088 <= _e1090);
                                        if _e1095 {
                                            if _e1096 {
                                                if _e1097 {
                                                    phi_3419_ = _e988.member_2;
                                                } else {
                                                    phi_3419_ = _e988.member_1;
                                                }
                                                let _e1101 = phi_3419_;
                                                let _e1123 = (_e702 % 128u);
                                                let _e1124 = (_e1123 < 128u);
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_8[_e1123] = _e1101.member_1;
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_7[_e1123] = _e1101.member.member.x;
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_6[_e1123] = _e1101.member.member.y;
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_5[_e1123] = _e1101.member.member.z;
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_4[_e1123] = _e1101.member.member_1.x;
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_3[_e1123] = _e1101.member.member_1.y;
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_2[_e1123] = _e1101.member.member_1.z;
                                                if _e1124 {
                                                } else {
                                                    phi_3911_ = true;
                                                    break;
                                                }
                                                local_9[_e1123] = select(_e1090, _e1088, !(_e1097));
                                                if _e1097 {
                                                    phi_3496_ = _e988.member_1;
                                                } else {
                                                    phi_3496_ = _e988.member_2;
                                                }
                                                let _e1137 = phi_3496_;
                                                phi_3497_ = (_e702 + 1u);
                                                phi_3498_ = _e1137;
                                            } else {
                                                phi_3497_ = u32();
                                                phi_3498_ = type_51();
                                            }
                                            let _e1139 = phi_3497_;
                                            let _e1141 = phi_3498_;
                                            phi_3500_ = _e1139;
                                            phi_3501_ = _e1141;
                                            phi_3502_ = select(true, false, _e1096);
                                        } else {
                                            phi_3500_ = u32();
                                            phi_3501_ = type_51();
                                            phi_3502_ = true;
                                        }
                                        let _e1144 = phi_3500_;
                                        let _e1146 = phi_3501_;
                                        let _e1148 = phi_3502_;
                                        if _e1148 {
                                            if _e1095 {
                                                phi_3511_ = _e988.member_1;
                                            } else {
                                                phi_3511_ = _e988.member_2;
                                            }
                                            let _e1152 = phi_3511_;
                                            phi_3516_ = select(_e1096, true, _e1095);
                                            phi_3518_ = _e1152;
                                        } else {
                                            phi_3516_ = _e700;
                                            phi_3518_ = _e1146;
                                        }
                                        let _e1155 = phi_3516_;
                                        let _e1157 = phi_3518_;
                                        phi_3915_ = _e658;
                                        phi_3523_ = type_44(_e660.member, (_e660.member_1 + 1u), _e660.member_2);
                                        phi_3524_ = _e1155;
                                        phi_3525_ = select(_e1144, _e702, _e1148);
                                        phi_3526_ = _e1157;
                                    }
                                    let _e1762 = phi_3915_;
                                    let _e1764 = phi_3523_;
                                    let _e1766 = phi_3524_;
                                    let _e1768 = phi_3525_;
                                    let _e1770 = phi_3526_;
                                    phi_3914_ = _e1762;
                                    phi_3527_ = _e1764;
                                    phi_3528_ = _e1766;
                                    phi_3529_ = (_e664 - 1u);
                                    phi_3530_ = _e1768;
                                    phi_3531_ = _e1770;
                                } else {
                                    phi_3914_ = _e658;
                                    phi_3527_ = _e660;
                                    phi_3528_ = _e700;
                                    phi_3529_ = _e664;
                                    phi_3530_ = _e702;
                                    phi_3531_ = _e704;
                                }
                                let _e1772 = phi_3914_;
                                let _e1774 = phi_3527_;
                                let _e1776 = phi_3528_;
                                let _e1778 = phi_3529_;
                                let _e1780 = phi_3530_;
                                let _e1782 = phi_3531_;
                                phi_3913_ = _e1772;
                                phi_3532_ = _e1774;
                                phi_3533_ = _e1776;
                                phi_3534_ = _e1778;
                                phi_3535_ = _e1780;
                                phi_3536_ = _e1782;
                            } else {
                                phi_3913_ = _e658;
                                phi_3532_ = type_44();
                                phi_3533_ = bool();
                                phi_3534_ = u32();
                                phi_3535_ = u32();
                                phi_3536_ = type_51();
                            }
                            let _e1784 = phi_3913_;
                            let _e1786 = phi_3532_;
                            let _e1788 = phi_3533_;
                            let _e1790 = phi_3534_;
                            let _e1792 = phi_3535_;
                            let _e1794 = phi_3536_;
                            phi_3912_ = _e1784;
                            phi_1082_ = _e1786;
                            phi_1085_ = _e1788;
                            phi_1087_ = _e1790;
                            phi_1089_ = _e1792;
                            phi_1091_ = _e1794;
                            phi_3537_ = _e672;
                        } else {
                            phi_3912_ = _e658;
                            phi_1082_ = type_44();
                            phi_1085_ = bool();
                            phi_1087_ = u32();
                            phi_1089_ = u32();
                            phi_1091_ = type_51();
                            phi_3537_ = false;
                        }
                        let _e1796 = phi_3912_;
                        let _e1798 = phi_1082_;
                        let _e1800 = phi_1085_;
                        let _e1802 = phi_1087_;
                        let _e1804 = phi_1089_;
                        let _e1806 = phi_1091_;
                        let _e1808 = phi_3537_;
                        continue;
                        continuing {
                            phi_3757_ = _e1796;
                            phi_1081_ = _e1798;
                            phi_1084_ = _e1800;
                            phi_1086_ = _e1802;
                            phi_1088_ = _e1804;
                            phi_1090_ = _e1806;
                            phi_3911_ = _e1796;
                            break if !(_e1808);
                        }
                    }
                    let _e1811 = phi_3911_;
                    if _e1811 {
                        break;
                    }
                    let _e1813 = local_10;
                    let _e1816 = local_11;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146][0u] = _e1813.member_1;
                    global_6.member[_e146][1u] = _e1816.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
