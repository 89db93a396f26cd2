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
    var phi_3763_: bool;
    var phi_1081_: type_44;
    var phi_1084_: u32;
    var phi_1086_: bool;
    var phi_1088_: u32;
    var phi_1090_: type_51;
    var phi_1101_: bool;
    var phi_1187_: bool;
    var phi_1188_: u32;
    var phi_1189_: type_51;
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
    var phi_3757_: bool;
    var phi_4003_: bool;
    var phi_2284_: type_44;
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
    var phi_3518_: type_44;
    var phi_3519_: bool;
    var phi_3520_: u32;
    var phi_3521_: type_51;
    var phi_3529_: type_44;
    var phi_3532_: type_51;
    var phi_3920_: bool;
    var phi_3533_: type_44;
    var phi_3534_: u32;
    var phi_3535_: bool;
    var phi_3536_: u32;
    var phi_3537_: type_51;
    var phi_3919_: bool;
    var phi_3538_: type_44;
    var phi_3539_: u32;
    var phi_3540_: bool;
    var phi_3541_: u32;
    var phi_3542_: type_51;
    var phi_3918_: bool;
    var phi_1082_: type_44;
    var phi_1085_: u32;
    var phi_1087_: bool;
    var phi_1089_: u32;
    var phi_1091_: type_51;
    var phi_3543_: bool;
    var phi_3917_: bool;
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
                    phi_3763_ = false;
                    phi_1081_ = type_44(type_38(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e613), 0u, 0u);
                    phi_1084_ = ((3u * _e90) + 1u);
                    phi_1086_ = (_e615 <= _e613);
                    phi_1088_ = 0u;
                    phi_1090_ = type_51(type_33(vec4<f32>((f32(_e623) * _e140), (f32(_e629) * _e140), (f32(_e635) * _e140), 0f), vec4<f32>((f32(_e640) * _e140), (f32(_e644) * _e140), (f32(_e648) * _e140), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    loop {
                        let _e658 = phi_3763_;
                        let _e660 = phi_1081_;
                        let _e662 = phi_1084_;
                        let _e664 = phi_1086_;
                        let _e666 = phi_1088_;
                        let _e668 = phi_1090_;
                        local_10 = _e660;
                        local_11 = _e660;
                        if _e664 {
                            phi_1101_ = true;
                        } else {
                            phi_1101_ = (_e666 > 0u);
                        }
                        let _e671 = phi_1101_;
                        if _e671 {
                            let _e672 = (_e662 > 0u);
                            if _e672 {
                                if _e664 {
                                    phi_1187_ = _e664;
                                    phi_1188_ = _e666;
                                    phi_1189_ = _e668;
                                } else {
                                    let _e673 = (_e666 - 1u);
                                    let _e674 = (_e673 % 128u);
                                    let _e675 = (_e674 < 128u);
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e677 = local_7[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e679 = local_6[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e681 = local_5[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e683 = local_4[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e685 = local_3[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e687 = local_2[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e692 = local_8[_e674];
                                    if _e675 {
                                    } else {
                                        phi_3917_ = true;
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
                                    let _e708 = ((_e704.member_1 & 2147483648u) != 0u);
                                    if _e708 {
                                        phi_1207_ = _e660;
                                        phi_1210_ = type_4(0u, ((_e704.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e715 = phi_1207_;
                                            let _e717 = phi_1210_;
                                            local_12 = _e715;
                                            if (_e717.member < _e717.member_1) {
                                                phi_1211_ = type_4((_e717.member + 1u), _e717.member_1);
                                                phi_1233_ = type_4(1u, _e717.member);
                                            } else {
                                                phi_1211_ = _e717;
                                                phi_1233_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e730 = phi_1211_;
                                            let _e732 = phi_1233_;
                                            let _e736 = (bitcast<i32>(_e732.member) != 0i);
                                            if _e736 {
                                                let _e742 = type_44(_e715.member, _e715.member_1, (_e715.member_2 + 1u));
                                                let _e743 = ((_e704.member_1 & 268435455u) + _e732.member_1);
                                                let _e744 = (_e743 < _e92);
                                                if _e744 {
                                                    if _e744 {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e748 = global_2.member[_e743].member_1;
                                                    phi_1257_ = _e748;
                                                } else {
                                                    phi_1257_ = 4294967295u;
                                                }
                                                let _e750 = phi_1257_;
                                                if (_e743 >= _e92) {
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e744 {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    if (_e620 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e757 = global_2.member[_e743].member[_e620];
                                                    if (_e626 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e763 = global_2.member[_e743].member[_e626];
                                                    if (_e632 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_2.member[_e743].member[_e632];
                                                    let _e771 = (3u + _e620);
                                                    if (_e771 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e777 = global_2.member[_e743].member[_e771];
                                                    let _e778 = (3u + _e626);
                                                    if (_e778 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e784 = global_2.member[_e743].member[_e778];
                                                    let _e785 = (3u + _e632);
                                                    if (_e785 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e791 = global_2.member[_e743].member[_e785];
                                                    let _e793 = (6u + _e620);
                                                    if (_e793 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e799 = global_2.member[_e743].member[_e793];
                                                    let _e800 = (6u + _e626);
                                                    if (_e800 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e806 = global_2.member[_e743].member[_e800];
                                                    let _e807 = (6u + _e632);
                                                    if (_e807 < 9u) {
                                                    } else {
                                                        phi_3757_ = true;
                                                        break;
                                                    }
                                                    let _e813 = global_2.member[_e743].member[_e807];
                                                    phi_1349_ = array<array<f32, 3>, 3>(array<f32, 3>(_e757, _e763, _e769), array<f32, 3>(_e777, _e784, _e791), array<f32, 3>(_e799, _e806, _e813));
                                                }
                                                let _e817 = phi_1349_;
                                                let _e826 = (_e817[0][2] - _e461);
                                                let _e829 = (((_e817[0][0] - _e324) * _e500) - (_e826 * _e364));
                                                let _e832 = (((_e817[0][1] - _e393) * _e500) - (_e826 * _e432));
                                                let _e839 = (_e817[1][2] - _e461);
                                                let _e842 = (((_e817[1][0] - _e324) * _e500) - (_e839 * _e364));
                                                let _e845 = (((_e817[1][1] - _e393) * _e500) - (_e839 * _e432));
                                                let _e852 = (_e817[2][2] - _e461);
                                                let _e855 = (((_e817[2][0] - _e324) * _e500) - (_e852 * _e364));
                                                let _e858 = (((_e817[2][1] - _e393) * _e500) - (_e852 * _e432));
                                                let _e859 = (_e855 * _e845);
                                                let _e860 = (_e858 * _e842);
                                                let _e861 = (_e829 * _e858);
                                                let _e862 = (_e832 * _e855);
                                                let _e863 = (_e842 * _e832);
                                                let _e864 = (_e845 * _e829);
                                                let _e869 = (((_e859 >= _e860) && (_e861 >= _e862)) && (_e863 >= _e864));
                                                if (_e869 || (((_e859 <= _e860) && (_e861 <= _e862)) && (_e863 <= _e864))) {
                                                    let _e876 = select(-1f, 1f, _e869);
                                                    let _e878 = ((_e859 - _e860) * _e876);
                                                    let _e880 = select(0f, _e878, (_e878 > 0f));
                                                    let _e882 = ((_e861 - _e862) * _e876);
                                                    let _e884 = select(0f, _e882, (_e882 > 0f));
                                                    let _e886 = ((_e863 - _e864) * _e876);
                                                    let _e888 = select(0f, _e886, (_e886 > 0f));
                                                    let _e890 = ((_e880 + _e884) + _e888);
                                                    if (_e890 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2233_ = type_29();
                                                        phi_2234_ = true;
                                                        phi_2235_ = false;
                                                    } else {
                                                        let _e893 = select(_e842, _e829, (_e829 < _e842));
                                                        if (select(_e855, _e893, (_e893 < _e855)) > 0f) {
                                                            phi_1501_ = true;
                                                        } else {
                                                            let _e898 = select(_e842, _e829, (_e829 > _e842));
                                                            phi_1501_ = (select(_e855, _e898, (_e898 > _e855)) < 0f);
                                                        }
                                                        let _e903 = phi_1501_;
                                                        if _e903 {
                                                            phi_2230_ = type_29();
                                                            phi_2231_ = true;
                                                            phi_2232_ = false;
                                                        } else {
                                                            let _e905 = select(_e845, _e832, (_e832 < _e845));
                                                            if (select(_e858, _e905, (_e905 < _e858)) > 0f) {
                                                                phi_1530_ = true;
                                                            } else {
                                                                let _e910 = select(_e845, _e832, (_e832 > _e845));
                                                                phi_1530_ = (select(_e858, _e910, (_e910 > _e858)) < 0f);
                                                            }
                                                            let _e915 = phi_1530_;
                                                            if _e915 {
                                                                phi_2228_ = type_29();
                                                                phi_2229_ = false;
                                                            } else {
                                                                let _e917 = select(_e817[1][0], _e817[0][0], (_e817[0][0] < _e817[1][0]));
                                                                let _e921 = select(_e817[1][0], _e817[0][0], (_e817[0][0] > _e817[1][0]));
                                                                let _e925 = select(_e817[1][1], _e817[0][1], (_e817[0][1] < _e817[1][1]));
                                                                let _e929 = select(_e817[1][1], _e817[0][1], (_e817[0][1] > _e817[1][1]));
                                                                let _e933 = select(_e817[1][2], _e817[0][2], (_e817[0][2] < _e817[1][2]));
                                                                let _e937 = select(_e817[1][2], _e817[0][2], (_e817[0][2] > _e817[1][2]));
                                                                let _e942 = ((select(_e817[2][0], _e917, (_e917 < _e817[2][0])) - _e362) * _e367);
                                                                let _e943 = ((select(_e817[2][0], _e921, (_e921 > _e817[2][0])) - _e363) * _e367);
                                                                let _e946 = ((select(_e817[2][1], _e925, (_e925 < _e817[2][1])) - _e430) * _e435);
                                                                let _e947 = ((select(_e817[2][1], _e929, (_e929 > _e817[2][1])) - _e431) * _e435);
                                                                let _e950 = ((select(_e817[2][2], _e933, (_e933 < _e817[2][2])) - _e498) * _e503);
                                                                let _e951 = ((select(_e817[2][2], _e937, (_e937 > _e817[2][2])) - _e499) * _e503);
                                                                let _e953 = select(_e951, _e950, (_e950 < _e951));
                                                                let _e955 = select(_e951, _e950, (_e950 > _e951));
                                                                let _e957 = select(_e943, _e942, (_e942 < _e943));
                                                                let _e959 = select(_e947, _e946, (_e946 < _e947));
                                                                let _e961 = select(_e959, _e957, (_e957 > _e959));
                                                                let _e963 = select(_e953, _e961, (_e961 > _e953));
                                                                let _e965 = select(_e943, _e942, (_e942 > _e943));
                                                                let _e967 = select(_e947, _e946, (_e946 > _e947));
                                                                let _e969 = select(_e967, _e965, (_e965 < _e967));
                                                                let _e971 = select(_e955, _e969, (_e969 < _e955));
                                                                let _e972 = -(_e953);
                                                                let _e978 = select(_e615, _e963, (_e963 > _e615));
                                                                if (_e978 > (_e971 + (select(_e972, _e955, (_e955 > _e972)) * 0.0000019073523f))) {
                                                                    phi_2223_ = type_29();
                                                                    phi_2224_ = true;
                                                                } else {
                                                                    let _e980 = (_e978 > _e715.member.member_1);
                                                                    if _e980 {
                                                                        phi_2222_ = type_29();
                                                                    } else {
                                                                        let _e981 = vec3<f32>(_e817[0][0], _e817[0][1], _e817[0][2]);
                                                                        let _e982 = vec3<f32>(_e817[1][0], _e817[1][1], _e817[1][2]);
                                                                        let _e983 = vec3<f32>(_e817[2][0], _e817[2][1], _e817[2][2]);
                                                                        let _e984 = (_e817[1][0] - _e817[0][0]);
                                                                        let _e985 = (_e817[1][1] - _e817[0][1]);
                                                                        let _e986 = (_e817[1][2] - _e817[0][2]);
                                                                        let _e987 = vec3<f32>(_e984, _e985, _e986);
                                                                        let _e988 = (_e817[2][0] - _e817[1][0]);
                                                                        let _e989 = (_e817[2][1] - _e817[1][1]);
                                                                        let _e990 = (_e817[2][2] - _e817[1][2]);
                                                                        let _e991 = vec3<f32>(_e988, _e989, _e990);
                                                                        let _e992 = (_e817[0][0] - _e817[2][0]);
                                                                        let _e993 = (_e817[0][1] - _e817[2][1]);
                                                                        let _e994 = (_e817[0][2] - _e817[2][2]);
                                                                        let _e995 = vec3<f32>(_e992, _e993, _e994);
                                                                        let _e998 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1001 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1003 = select(_e1001, _e998, (_e998 > _e1001));
                                                                        let _e1006 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                        let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                                                                        let _e1011 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                        let _e1014 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                                        let _e1016 = select(_e1014, _e1011, (_e1011 > _e1014));
                                                                        let _e1019 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                        let _e1021 = select(_e1019, _e1016, (_e1016 > _e1019));
                                                                        let _e1024 = bitcast<f32>((bitcast<u32>(_e992) & 2147483647u));
                                                                        let _e1027 = bitcast<f32>((bitcast<u32>(_e993) & 2147483647u));
                                                                        let _e1029 = select(_e1027, _e1024, (_e1024 > _e1027));
                                                                        let _e1032 = bitcast<f32>((bitcast<u32>(_e994) & 2147483647u));
                                                                        let _e1034 = select(_e1032, _e1029, (_e1029 > _e1032));
                                                                        let _e1036 = select(_e1021, _e1008, (_e1008 > _e1021));
                                                                        let _e1038 = select(_e1034, _e1036, (_e1036 > _e1034));
                                                                        if (_e1008 == _e1038) {
                                                                            phi_1949_ = _e845;
                                                                            phi_1950_ = _e842;
                                                                            phi_1951_ = _e832;
                                                                            phi_1952_ = _e829;
                                                                            phi_1953_ = _e981;
                                                                            phi_1954_ = _e995;
                                                                            phi_1955_ = _e991;
                                                                            phi_1956_ = _e987;
                                                                        } else {
                                                                            let _e1040 = (_e1021 == _e1038);
                                                                            let _e1045 = vec3(_e1040);
                                                                            phi_1949_ = select(_e832, _e858, _e1040);
                                                                            phi_1950_ = select(_e829, _e855, _e1040);
                                                                            phi_1951_ = select(_e858, _e845, _e1040);
                                                                            phi_1952_ = select(_e855, _e842, _e1040);
                                                                            phi_1953_ = select(_e983, _e982, _e1045);
                                                                            phi_1954_ = select(_e991, _e987, _e1045);
                                                                            phi_1955_ = select(_e987, _e995, _e1045);
                                                                            phi_1956_ = select(_e995, _e991, _e1045);
                                                                        }
                                                                        let _e1051 = phi_1949_;
                                                                        let _e1053 = phi_1950_;
                                                                        let _e1055 = phi_1951_;
                                                                        let _e1057 = phi_1952_;
                                                                        let _e1059 = phi_1953_;
                                                                        let _e1061 = phi_1954_;
                                                                        let _e1063 = phi_1955_;
                                                                        let _e1065 = phi_1956_;
                                                                        let _e1072 = ((_e1063.y * _e1061.z) - (_e1061.y * _e1063.z));
                                                                        let _e1077 = ((_e1063.z * _e1061.x) - (_e1061.z * _e1063.x));
                                                                        let _e1080 = ((_e1063.x * _e1061.y) - (_e1061.x * _e1063.y));
                                                                        if (_e880 >= _e884) {
                                                                            phi_1993_ = select(true, false, (_e880 >= _e888));
                                                                        } else {
                                                                            phi_1993_ = true;
                                                                        }
                                                                        let _e1085 = phi_1993_;
                                                                        if _e1085 {
                                                                            phi_2002_ = select(_e983, _e982, vec3((_e884 >= _e888)));
                                                                        } else {
                                                                            phi_2002_ = _e981;
                                                                        }
                                                                        let _e1090 = phi_2002_;
                                                                        let _e1101 = (((_e1072 * (_e1090.x - _e324)) + (_e1077 * (_e1090.y - _e393))) + (_e1080 * (_e1090.z - _e461)));
                                                                        let _e1106 = (((_e1072 * _e364) + (_e1077 * _e432)) + (_e1080 * _e500));
                                                                        let _e1107 = (_e1053 - _e1057);
                                                                        let _e1108 = (_e1051 - _e1055);
                                                                        let _e1116 = (-(((_e1057 * _e1107) + (_e1055 * _e1108))) / ((_e1107 * _e1107) + (_e1108 * _e1108)));
                                                                        let _e1118 = select(1f, _e1116, (_e1116 < 1f));
                                                                        let _e1120 = select(0f, _e1118, (_e1118 > 0f));
                                                                        let _e1133 = ((_e1059.x + (_e1065.x * _e1120)) - _e324);
                                                                        let _e1134 = ((_e1059.y + (_e1065.y * _e1120)) - _e393);
                                                                        let _e1135 = ((_e1059.z + (_e1065.z * _e1120)) - _e461);
                                                                        let _e1136 = (_e1135 / _e500);
                                                                        let _e1148 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                                        let _e1151 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                        let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                                                                        let _e1156 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                        let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                                        let _e1164 = bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u));
                                                                        let _e1167 = bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u));
                                                                        let _e1169 = select(_e1167, _e1164, (_e1164 > _e1167));
                                                                        let _e1172 = bitcast<f32>((bitcast<u32>(_e1080) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1072 * _e1133) + (_e1077 * _e1134)) + (_e1080 * _e1135)) - _e1101)) & 2147483647u)) <= ((0.0000009536743f * select(_e1038, _e1158, (_e1158 > _e1038))) * select(_e1172, _e1169, (_e1169 > _e1172)))) {
                                                                            let _e1182 = bitcast<f32>((bitcast<u32>(_e1063.x) & 2147483647u));
                                                                            let _e1185 = bitcast<f32>((bitcast<u32>(_e1063.y) & 2147483647u));
                                                                            let _e1187 = select(_e1185, _e1182, (_e1182 > _e1185));
                                                                            let _e1190 = bitcast<f32>((bitcast<u32>(_e1063.z) & 2147483647u));
                                                                            let _e1196 = bitcast<f32>((bitcast<u32>(_e1061.x) & 2147483647u));
                                                                            let _e1199 = bitcast<f32>((bitcast<u32>(_e1061.y) & 2147483647u));
                                                                            let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                                                                            let _e1204 = bitcast<f32>((bitcast<u32>(_e1061.z) & 2147483647u));
                                                                            let _e1208 = (bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u)) > ((0.0000038146973f * select(_e1190, _e1187, (_e1187 > _e1190))) * select(_e1204, _e1201, (_e1201 > _e1204))));
                                                                            if _e1208 {
                                                                                phi_2167_ = (_e1101 / _e1106);
                                                                            } else {
                                                                                phi_2167_ = f32();
                                                                            }
                                                                            let _e1211 = phi_2167_;
                                                                            phi_2169_ = _e1211;
                                                                            phi_2170_ = select(true, false, _e1208);
                                                                        } else {
                                                                            phi_2169_ = f32();
                                                                            phi_2170_ = true;
                                                                        }
                                                                        let _e1214 = phi_2169_;
                                                                        let _e1216 = phi_2170_;
                                                                        if _e1216 {
                                                                            let _e1224 = (((_e1072 * (_e1133 - (_e364 * _e1136))) + (_e1077 * (_e1134 - (_e432 * _e1136)))) / _e1106);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u)) <= _e1038) {
                                                                                phi_2190_ = (_e1136 + _e1224);
                                                                            } else {
                                                                                phi_2190_ = _e1136;
                                                                            }
                                                                            let _e1231 = phi_2190_;
                                                                            phi_2191_ = _e1231;
                                                                        } else {
                                                                            phi_2191_ = _e1214;
                                                                        }
                                                                        let _e1233 = phi_2191_;
                                                                        let _e1235 = select(_e971, _e1233, (_e1233 < _e971));
                                                                        let _e1237 = select(_e963, _e1235, (_e1235 > _e963));
                                                                        if (_e1237 >= _e615) {
                                                                            let _e1239 = (_e1237 <= _e715.member.member_1);
                                                                            if _e1239 {
                                                                                let _e1240 = (1f / _e890);
                                                                                phi_2214_ = type_29(_e1237, (_e884 * _e1240), (_e888 * _e1240), _e750);
                                                                            } else {
                                                                                phi_2214_ = type_29();
                                                                            }
                                                                            let _e1245 = phi_2214_;
                                                                            phi_2216_ = _e1245;
                                                                            phi_2217_ = select(true, false, _e1239);
                                                                        } else {
                                                                            phi_2216_ = type_29();
                                                                            phi_2217_ = true;
                                                                        }
                                                                        let _e1248 = phi_2216_;
                                                                        let _e1250 = phi_2217_;
                                                                        if _e1250 {
                                                                            phi_2221_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2221_ = _e1248;
                                                                        }
                                                                        let _e1252 = phi_2221_;
                                                                        phi_2222_ = _e1252;
                                                                    }
                                                                    let _e1254 = phi_2222_;
                                                                    phi_2223_ = _e1254;
                                                                    phi_2224_ = _e980;
                                                                }
                                                                let _e1256 = phi_2223_;
                                                                let _e1258 = phi_2224_;
                                                                phi_2228_ = _e1256;
                                                                phi_2229_ = _e1258;
                                                            }
                                                            let _e1260 = phi_2228_;
                                                            let _e1262 = phi_2229_;
                                                            phi_2230_ = _e1260;
                                                            phi_2231_ = _e915;
                                                            phi_2232_ = _e1262;
                                                        }
                                                        let _e1264 = phi_2230_;
                                                        let _e1266 = phi_2231_;
                                                        let _e1268 = phi_2232_;
                                                        phi_2233_ = _e1264;
                                                        phi_2234_ = _e1266;
                                                        phi_2235_ = _e1268;
                                                    }
                                                    let _e1270 = phi_2233_;
                                                    let _e1272 = phi_2234_;
                                                    let _e1274 = phi_2235_;
                                                    phi_2243_ = _e1270;
                                                    phi_2244_ = select(_e1274, true, _e1272);
                                                } else {
                                                    phi_2243_ = type_29();
                                                    phi_2244_ = true;
                                                }
                                                let _e1277 = phi_2243_;
                                                let _e1279 = phi_2244_;
                                                if _e1279 {
                                                    phi_2248_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2248_ = _e1277;
                                                }
                                                let _e1281 = phi_2248_;
                                                if (_e1281.member_3 != 4294967295u) {
                                                    if (_e750 != 4294967295u) {
                                                        if (_e1281.member < _e715.member.member.member) {
                                                            phi_2274_ = true;
                                                        } else {
                                                            if (_e1281.member == _e715.member.member.member) {
                                                                phi_2273_ = (_e1281.member_3 < _e715.member.member.member_3);
                                                            } else {
                                                                phi_2273_ = false;
                                                            }
                                                            let _e1296 = phi_2273_;
                                                            phi_2274_ = _e1296;
                                                        }
                                                        let _e1298 = phi_2274_;
                                                        if _e1298 {
                                                            phi_2281_ = type_44(type_38(_e1281, _e1281.member), _e742.member_1, _e742.member_2);
                                                        } else {
                                                            phi_2281_ = _e742;
                                                        }
                                                        let _e1305 = phi_2281_;
                                                        phi_2282_ = _e1305;
                                                    } else {
                                                        phi_2282_ = _e742;
                                                    }
                                                    let _e1307 = phi_2282_;
                                                    phi_2283_ = _e1307;
                                                } else {
                                                    phi_2283_ = _e742;
                                                }
                                                let _e1309 = phi_2283_;
                                                phi_1208_ = _e1309;
                                            } else {
                                                phi_1208_ = type_44();
                                            }
                                            let _e1311 = phi_1208_;
                                            continue;
                                            continuing {
                                                phi_1207_ = _e1311;
                                                phi_1210_ = _e730;
                                                phi_3757_ = _e658;
                                                break if !(_e736);
                                            }
                                        }
                                        let _e1314 = phi_3757_;
                                        phi_3917_ = _e1314;
                                        if _e1314 {
                                            break;
                                        }
                                        phi_4003_ = _e1314;
                                        let _e1927 = local_12;
                                        phi_2284_ = _e1927;
                                    } else {
                                        phi_4003_ = _e658;
                                        phi_2284_ = _e660;
                                    }
                                    let _e1316 = phi_4003_;
                                    let _e1318 = phi_2284_;
                                    if _e708 {
                                        phi_3518_ = type_44();
                                        phi_3519_ = bool();
                                        phi_3520_ = u32();
                                        phi_3521_ = type_51();
                                    } else {
                                        if (_e704.member_1 >= _e90) {
                                            phi_3050_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e704.member_1 < _e90) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1322 = ((1u + _e260) % 4u);
                                            if (_e1322 < 4u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1327 = global_4.member[_e704.member_1][_e1322];
                                            let _e1329 = (_e1327 >> bitcast<u32>(11u));
                                            let _e1331 = ((1u + _e259) % 4u);
                                            if (_e1331 < 4u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1336 = global_4.member[_e704.member_1][_e1331];
                                            let _e1338 = (_e1336 >> bitcast<u32>(11u));
                                            let _e1340 = ((1u + _e261) % 4u);
                                            if (_e1340 < 4u) {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e1345 = global_4.member[_e704.member_1][_e1340];
                                            let _e1347 = (_e1345 >> bitcast<u32>(11u));
                                            let _e1370 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.x - _e704.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1371 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.y - _e704.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1372 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.z - _e704.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1374 = select(_e140, _e1370, (_e1370 > _e140));
                                            let _e1376 = select(_e140, _e1371, (_e1371 > _e140));
                                            let _e1378 = select(_e140, _e1372, (_e1372 > _e140));
                                            let _e1409 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1327 & 1023u))) - 8388608f) * _e1374));
                                            let _e1414 = (bitcast<i32>((_e1327 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1417 = bitcast<f32>((_e1409 & bitcast<u32>(_e1414)));
                                            let _e1418 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1336 & 1023u))) - 8388608f) * _e1376));
                                            let _e1423 = (bitcast<i32>((_e1336 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1426 = bitcast<f32>((_e1418 & bitcast<u32>(_e1423)));
                                            let _e1427 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1345 & 1023u))) - 8388608f) * _e1378));
                                            let _e1432 = (bitcast<i32>((_e1345 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1435 = bitcast<f32>((_e1427 & bitcast<u32>(_e1432)));
                                            let _e1439 = bitcast<f32>((_e1409 & bitcast<u32>(~(_e1414))));
                                            let _e1443 = bitcast<f32>((_e1418 & bitcast<u32>(~(_e1423))));
                                            let _e1447 = bitcast<f32>((_e1427 & bitcast<u32>(~(_e1432))));
                                            let _e1448 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1329 & 1023u))) - 8388608f) * _e1374));
                                            let _e1453 = (bitcast<i32>((_e1329 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1456 = bitcast<f32>((_e1448 & bitcast<u32>(_e1453)));
                                            let _e1457 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1338 & 1023u))) - 8388608f) * _e1376));
                                            let _e1462 = (bitcast<i32>((_e1338 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1465 = bitcast<f32>((_e1457 & bitcast<u32>(_e1462)));
                                            let _e1466 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1347 & 1023u))) - 8388608f) * _e1378));
                                            let _e1471 = (bitcast<i32>((_e1347 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1474 = bitcast<f32>((_e1466 & bitcast<u32>(_e1471)));
                                            let _e1478 = bitcast<f32>((_e1448 & bitcast<u32>(~(_e1453))));
                                            let _e1482 = bitcast<f32>((_e1457 & bitcast<u32>(~(_e1462))));
                                            let _e1486 = bitcast<f32>((_e1466 & bitcast<u32>(~(_e1471))));
                                            let _e1516 = global_4.member[_e704.member_1][0u];
                                            let _e1520 = global_4.member[_e704.member_1][1u];
                                            let _e1524 = global_4.member[_e704.member_1][2u];
                                            let _e1528 = global_4.member[_e704.member_1][3u];
                                            let _e1540 = (((_e1520 >> bitcast<u32>(22i)) | ((_e1524 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1528 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1541 = (_e1516 & 268435455u);
                                            let _e1542 = (_e1540 & 268435455u);
                                            let _e1545 = ((_e1516 >> bitcast<u32>(28u)) & 7u);
                                            let _e1553 = ((_e1516 >> bitcast<u32>(31i)) | (((_e1540 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1554 = (_e1545 != 0u);
                                            if (_e1545 == 0u) {
                                                phi_3012_ = _e1541;
                                            } else {
                                                if (_e1545 == 7u) {
                                                    phi_3011_ = 2147483648u;
                                                } else {
                                                    phi_3011_ = ((2147483648u | (_e1545 << bitcast<u32>(28u))) | (_e1542 & 268435455u));
                                                }
                                                let _e1563 = phi_3011_;
                                                phi_3012_ = _e1563;
                                            }
                                            let _e1565 = phi_3012_;
                                            if _e1554 {
                                                let _e1566 = (_e1545 != 7u);
                                                if _e1566 {
                                                    phi_3022_ = (_e1542 + _e1545);
                                                } else {
                                                    phi_3022_ = u32();
                                                }
                                                let _e1569 = phi_3022_;
                                                phi_3024_ = _e1569;
                                                phi_3025_ = select(true, false, _e1566);
                                            } else {
                                                phi_3024_ = u32();
                                                phi_3025_ = true;
                                            }
                                            let _e1572 = phi_3024_;
                                            let _e1574 = phi_3025_;
                                            if (_e1553 == 0u) {
                                                phi_3046_ = (_e1541 + select(0u, 1u, !(_e1554)));
                                            } else {
                                                if (_e1553 == 7u) {
                                                    phi_3045_ = 2147483648u;
                                                } else {
                                                    phi_3045_ = ((2147483648u | (_e1553 << bitcast<u32>(28u))) | (select(_e1572, _e1542, _e1574) & 268435455u));
                                                }
                                                let _e1587 = phi_3045_;
                                                phi_3046_ = _e1587;
                                            }
                                            let _e1589 = phi_3046_;
                                            phi_3050_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e704.member.member.x + _e1417), (_e704.member.member.x + _e1439), (_e704.member.member_1.x - _e1456), (_e704.member.member_1.x - _e1478)), vec4<f32>((_e704.member.member.y + _e1426), (_e704.member.member.y + _e1443), (_e704.member.member_1.y - _e1465), (_e704.member.member_1.y - _e1482)), vec4<f32>((_e704.member.member.z + _e1435), (_e704.member.member.z + _e1447), (_e704.member.member_1.z - _e1474), (_e704.member.member_1.z - _e1486))), type_51(type_33((_e704.member.member + vec4<f32>(_e1417, _e1426, _e1435, 0f)), (_e704.member.member_1 - vec4<f32>(_e1456, _e1465, _e1474, 0f))), _e1565), type_51(type_33((_e704.member.member + vec4<f32>(_e1439, _e1443, _e1447, 0f)), (_e704.member.member_1 - vec4<f32>(_e1478, _e1482, _e1486, 0f))), _e1589));
                                        }
                                        let _e1594 = phi_3050_;
                                        let _e1613 = ((_e1594.member[0].x - _e362) * _e367);
                                        let _e1614 = ((_e1594.member[0].y - _e362) * _e367);
                                        let _e1615 = ((_e1594.member[0].z - _e363) * _e367);
                                        let _e1616 = ((_e1594.member[0].w - _e363) * _e367);
                                        let _e1626 = ((_e1594.member[1].x - _e430) * _e435);
                                        let _e1627 = ((_e1594.member[1].y - _e430) * _e435);
                                        let _e1628 = ((_e1594.member[1].z - _e431) * _e435);
                                        let _e1629 = ((_e1594.member[1].w - _e431) * _e435);
                                        let _e1639 = ((_e1594.member[2].x - _e498) * _e503);
                                        let _e1640 = ((_e1594.member[2].y - _e498) * _e503);
                                        let _e1641 = ((_e1594.member[2].z - _e499) * _e503);
                                        let _e1642 = ((_e1594.member[2].w - _e499) * _e503);
                                        let _e1644 = select(_e1641, _e1639, (_e1639 < _e1641));
                                        let _e1646 = select(_e1642, _e1640, (_e1640 < _e1642));
                                        let _e1648 = select(_e1641, _e1639, (_e1639 > _e1641));
                                        let _e1650 = select(_e1642, _e1640, (_e1640 > _e1642));
                                        let _e1652 = select(_e1615, _e1613, (_e1613 < _e1615));
                                        let _e1654 = select(_e1616, _e1614, (_e1614 < _e1616));
                                        let _e1656 = select(_e1628, _e1626, (_e1626 < _e1628));
                                        let _e1658 = select(_e1629, _e1627, (_e1627 < _e1629));
                                        let _e1660 = select(_e1656, _e1652, (_e1652 > _e1656));
                                        let _e1662 = select(_e1658, _e1654, (_e1654 > _e1658));
                                        let _e1664 = select(_e1644, _e1660, (_e1660 > _e1644));
                                        let _e1666 = select(_e1646, _e1662, (_e1662 > _e1646));
                                        let _e1668 = select(_e1615, _e1613, (_e1613 > _e1615));
                                        let _e1670 = select(_e1616, _e1614, (_e1614 > _e1616));
                                        let _e1672 = select(_e1628, _e1626, (_e1626 > _e1628));
                                        let _e1674 = select(_e1629, _e1627, (_e1627 > _e1629));
                                        let _e1676 = select(_e1672, _e1668, (_e1668 < _e1672));
                                        let _e1678 = select(_e1674, _e1670, (_e1670 < _e1674));
                                        let _e1683 = -(_e1644);
                                        let _e1684 = -(_e1646);
                                        let _e1691 = (select(_e1648, _e1676, (_e1676 < _e1648)) + (select(_e1683, _e1648, (_e1648 > _e1683)) * 0.0000019073523f));
                                        let _e1692 = (select(_e1650, _e1678, (_e1678 < _e1650)) + (select(_e1684, _e1650, (_e1650 > _e1684)) * 0.0000019073523f));
                                        let _e1694 = select(_e615, _e1664, (_e1664 > _e615));
                                        let _e1696 = select(_e615, _e1666, (_e1666 > _e615));
                                        let _e1701 = (_e1694 <= select(_e1318.member.member_1, _e1691, (_e1691 < _e1318.member.member_1)));
                                        let _e1702 = (_e1696 <= select(_e1318.member.member_1, _e1692, (_e1692 < _e1318.member.member_1)));
                                        let _e1703 = (_e1694 <= _e1696);
                                        if _e1701 {
                                            if _e1702 {
                                                if _e1703 {
                                                    phi_3415_ = _e1594.member_2;
                                                } else {
                                                    phi_3415_ = _e1594.member_1;
                                                }
                                                let _e1707 = phi_3415_;
                                                let _e1728 = (_e702 % 128u);
                                                let _e1729 = (_e1728 < 128u);
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_8[_e1728] = _e1707.member_1;
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_7[_e1728] = _e1707.member.member.x;
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_6[_e1728] = _e1707.member.member.y;
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_5[_e1728] = _e1707.member.member.z;
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_4[_e1728] = _e1707.member.member_1.x;
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_3[_e1728] = _e1707.member.member_1.y;
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_2[_e1728] = _e1707.member.member_1.z;
                                                if _e1729 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_9[_e1728] = select(_e1694, _e1696, _e1703);
                                                if _e1703 {
                                                    phi_3491_ = _e1594.member_1;
                                                } else {
                                                    phi_3491_ = _e1594.member_2;
                                                }
                                                let _e1742 = phi_3491_;
                                                phi_3492_ = (_e702 + 1u);
                                                phi_3493_ = _e1742;
                                            } else {
                                                phi_3492_ = u32();
                                                phi_3493_ = type_51();
                                            }
                                            let _e1744 = phi_3492_;
                                            let _e1746 = phi_3493_;
                                            phi_3495_ = _e1744;
                                            phi_3496_ = _e1746;
                                            phi_3497_ = select(true, false, _e1702);
                                        } else {
                                            phi_3495_ = u32();
                                            phi_3496_ = type_51();
                                            phi_3497_ = true;
                                        }
                                        let _e1749 = phi_3495_;
                                        let _e1751 = phi_3496_;
                                        let _e1753 = phi_3497_;
                                        if _e1753 {
                                            if _e1701 {
                                                phi_3506_ = _e1594.member_1;
                                            } else {
                                                phi_3506_ = _e1594.member_2;
                                            }
                                            let _e1757 = phi_3506_;
                                            phi_3511_ = select(_e1702, true, _e1701);
                                            phi_3513_ = _e1757;
                                        } else {
                                            phi_3511_ = _e700;
                                            phi_3513_ = _e1751;
                                        }
                                        let _e1760 = phi_3511_;
                                        let _e1762 = phi_3513_;
                                        phi_3518_ = type_44(_e1318.member, (_e1318.member_1 + 1u), _e1318.member_2);
                                        phi_3519_ = _e1760;
                                        phi_3520_ = select(_e1749, _e702, _e1753);
                                        phi_3521_ = _e1762;
                                    }
                                    let _e1765 = phi_3518_;
                                    let _e1767 = phi_3519_;
                                    let _e1769 = phi_3520_;
                                    let _e1771 = phi_3521_;
                                    if _e708 {
                                        phi_3529_ = _e1318;
                                        phi_3532_ = _e704;
                                    } else {
                                        phi_3529_ = _e1765;
                                        phi_3532_ = _e1771;
                                    }
                                    let _e1773 = phi_3529_;
                                    let _e1775 = phi_3532_;
                                    phi_3920_ = _e1316;
                                    phi_3533_ = _e1773;
                                    phi_3534_ = (_e662 - 1u);
                                    phi_3535_ = select(_e1767, false, _e708);
                                    phi_3536_ = select(_e1769, _e702, _e708);
                                    phi_3537_ = _e1775;
                                } else {
                                    phi_3920_ = _e658;
                                    phi_3533_ = _e660;
                                    phi_3534_ = _e662;
                                    phi_3535_ = _e700;
                                    phi_3536_ = _e702;
                                    phi_3537_ = _e704;
                                }
                                let _e1779 = phi_3920_;
                                let _e1781 = phi_3533_;
                                let _e1783 = phi_3534_;
                                let _e1785 = phi_3535_;
                                let _e1787 = phi_3536_;
                                let _e1789 = phi_3537_;
                                phi_3919_ = _e1779;
                                phi_3538_ = _e1781;
                                phi_3539_ = _e1783;
                                phi_3540_ = _e1785;
                                phi_3541_ = _e1787;
                                phi_3542_ = _e1789;
                            } else {
                                phi_3919_ = _e658;
                                phi_3538_ = type_44();
                                phi_3539_ = u32();
                                phi_3540_ = bool();
                                phi_3541_ = u32();
                                phi_3542_ = type_51();
                            }
                            let _e1791 = phi_3919_;
                            let _e1793 = phi_3538_;
                            let _e1795 = phi_3539_;
                            let _e1797 = phi_3540_;
                            let _e1799 = phi_3541_;
                            let _e1801 = phi_3542_;
                            phi_3918_ = _e1791;
                            phi_1082_ = _e1793;
                            phi_1085_ = _e1795;
                            phi_1087_ = _e1797;
                            phi_1089_ = _e1799;
                            phi_1091_ = _e1801;
                            phi_3543_ = _e672;
                        } else {
                            phi_3918_ = _e658;
                            phi_1082_ = type_44();
                            phi_1085_ = u32();
                            phi_1087_ = bool();
                            phi_1089_ = u32();
                            phi_1091_ = type_51();
                            phi_3543_ = false;
                        }
                        let _e1803 = phi_3918_;
                        let _e1805 = phi_1082_;
                        let _e1807 = phi_1085_;
                        let _e1809 = phi_1087_;
                        let _e1811 = phi_1089_;
                        let _e1813 = phi_1091_;
                        let _e1815 = phi_3543_;
                        continue;
                        continuing {
                            phi_3763_ = _e1803;
                            phi_1081_ = _e1805;
                            phi_1084_ = _e1807;
                            phi_1086_ = _e1809;
                            phi_1088_ = _e1811;
                            phi_1090_ = _e1813;
                            phi_3917_ = _e1803;
                            break if !(_e1815);
                        }
                    }
                    let _e1818 = phi_3917_;
                    if _e1818 {
                        break;
                    }
                    let _e1820 = local_10;
                    let _e1823 = local_11;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146][0u] = _e1820.member_1;
                    global_6.member[_e146][1u] = _e1823.member_2;
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
