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

struct type_37 {
    member: type_28,
    member_1: f32,
}

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_42 {
    member: array<type_29>,
}

struct type_44 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_32,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_42;
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
    var phi_423_: i32;
    var phi_424_: i32;
    var phi_434_: bool;
    var phi_444_: u32;
    var phi_445_: u32;
    var phi_447_: bool;
    var phi_452_: u32;
    var phi_465_: i32;
    var phi_485_: i32;
    var phi_503_: f32;
    var phi_509_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_628_: f32;
    var phi_634_: f32;
    var phi_674_: f32;
    var phi_680_: f32;
    var phi_753_: f32;
    var phi_759_: f32;
    var phi_799_: f32;
    var phi_805_: f32;
    var phi_924_: i32;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_984_: i32;
    var phi_1006_: u32;
    var phi_1007_: u32;
    var phi_1015_: f32;
    var phi_1016_: f32;
    var phi_4533_: bool;
    var phi_1113_: type_44;
    var phi_1116_: u32;
    var phi_1118_: bool;
    var phi_1120_: u32;
    var phi_1122_: type_51;
    var phi_1133_: bool;
    var phi_1219_: bool;
    var phi_1220_: u32;
    var phi_1221_: type_51;
    var phi_1240_: type_44;
    var phi_1243_: type_8;
    var phi_1244_: type_8;
    var phi_1266_: type_8;
    var phi_1310_: u32;
    var phi_1316_: u32;
    var phi_1326_: u32;
    var phi_1342_: u32;
    var phi_1375_: u32;
    var phi_1381_: u32;
    var phi_1847_: u32;
    var phi_1865_: u32;
    var phi_1883_: u32;
    var phi_1906_: u32;
    var phi_1924_: u32;
    var phi_1942_: u32;
    var phi_1965_: u32;
    var phi_1983_: u32;
    var phi_2001_: u32;
    var phi_1555_: u32;
    var phi_1570_: u32;
    var phi_1580_: u32;
    var phi_1601_: u32;
    var phi_1622_: u32;
    var phi_1652_: u32;
    var phi_1667_: u32;
    var phi_1677_: u32;
    var phi_1698_: u32;
    var phi_1719_: u32;
    var phi_1749_: u32;
    var phi_1764_: u32;
    var phi_1774_: u32;
    var phi_1795_: u32;
    var phi_1816_: u32;
    var phi_1408_: u32;
    var phi_1457_: u32;
    var phi_1506_: u32;
    var phi_2007_: array<array<f32, 3>, 3>;
    var phi_4168_: bool;
    var phi_4183_: bool;
    var phi_4198_: bool;
    var phi_4213_: bool;
    var phi_4228_: bool;
    var phi_4243_: bool;
    var phi_2549_: f32;
    var phi_2550_: f32;
    var phi_2551_: f32;
    var phi_2552_: f32;
    var phi_2553_: vec3<f32>;
    var phi_2554_: vec3<f32>;
    var phi_2555_: vec3<f32>;
    var phi_2556_: vec3<f32>;
    var phi_4258_: bool;
    var phi_4273_: bool;
    var phi_4288_: bool;
    var phi_4303_: bool;
    var phi_4318_: bool;
    var phi_4333_: bool;
    var phi_2764_: f32;
    var phi_2784_: type_40;
    var phi_2785_: type_40;
    var phi_2788_: type_40;
    var phi_2789_: type_40;
    var phi_2790_: bool;
    var phi_2794_: type_40;
    var phi_2803_: type_28;
    var phi_2828_: bool;
    var phi_2829_: bool;
    var phi_2836_: type_44;
    var phi_2837_: type_44;
    var phi_2838_: type_44;
    var phi_1241_: type_44;
    var phi_4527_: bool;
    var phi_4830_: bool;
    var phi_2839_: type_44;
    var phi_3341_: u32;
    var phi_3347_: u32;
    var phi_3601_: u32;
    var phi_3602_: u32;
    var phi_3612_: u32;
    var phi_3614_: u32;
    var phi_3615_: bool;
    var phi_3635_: u32;
    var phi_3636_: u32;
    var phi_3640_: type_52;
    var phi_4005_: type_51;
    var phi_4081_: type_51;
    var phi_4082_: u32;
    var phi_4083_: type_51;
    var phi_4085_: u32;
    var phi_4086_: type_51;
    var phi_4087_: bool;
    var phi_4096_: type_51;
    var phi_4101_: bool;
    var phi_4103_: type_51;
    var phi_4108_: type_44;
    var phi_4109_: bool;
    var phi_4110_: u32;
    var phi_4111_: type_51;
    var phi_4119_: type_44;
    var phi_4122_: type_51;
    var phi_4742_: bool;
    var phi_4123_: type_44;
    var phi_4124_: u32;
    var phi_4125_: bool;
    var phi_4126_: u32;
    var phi_4127_: type_51;
    var phi_4741_: bool;
    var phi_4128_: type_44;
    var phi_4129_: u32;
    var phi_4130_: bool;
    var phi_4131_: u32;
    var phi_4132_: type_51;
    var phi_4740_: bool;
    var phi_1114_: type_44;
    var phi_1117_: u32;
    var phi_1119_: bool;
    var phi_1121_: u32;
    var phi_1123_: type_51;
    var phi_4133_: bool;
    var phi_4739_: bool;
    var local_10: type_44;
    var local_11: type_44;
    var local_12: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_3.member));
            let _e98 = arrayLength((&global_5.member));
            let _e106 = global_2.member[0u][0u];
            let _e110 = global_2.member[0u][1u];
            let _e114 = global_2.member[0u][2u];
            let _e118 = global_2.member[0u][3u];
            let _e122 = global_2.member[1u][0u];
            let _e126 = global_2.member[1u][1u];
            let _e130 = global_2.member[1u][2u];
            let _e133 = global_1.member[0u];
            let _e134 = bitcast<i32>(_e133);
            let _e146 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e118) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e106), bitcast<i32>(_e110), bitcast<i32>(_e114));
            local = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            let _e152 = (_e93.x + (_e93.y * 2097152u));
            let _e153 = (_e152 < arrayLength((&global_4.member)));
            if _e153 {
                let _e154 = (_e152 < arrayLength((&global_6.member)));
                if _e154 {
                    if _e153 {
                    } else {
                        break;
                    }
                    let _e162 = global_4.member[_e152].member_2[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e152].member_2[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e152].member_2[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e152].member[0u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_4.member[_e152].member[1u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e197 = global_4.member[_e152].member[2u];
                    let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                    let _e201 = select(_e171, _e164, (_e171 < _e164));
                    let _e203 = select(_e178, _e201, (_e178 < _e201));
                    let _e205 = select(_e185, _e203, (_e185 < _e203));
                    let _e207 = select(_e192, _e205, (_e192 < _e205));
                    let _e209 = select(_e199, _e207, (_e199 < _e207));
                    let _e213 = global_4.member[_e152].member_1;
                    let _e214 = bitcast<u32>(_e213);
                    let _e215 = (_e214 & 2147483647u);
                    let _e222 = global_4.member[_e152].member_3;
                    let _e223 = bitcast<u32>(_e222);
                    let _e224 = (_e223 & 2147483647u);
                    let _e228 = (((select(_e215, _e209, (_e215 < _e209)) < 2139095040u) && (_e224 <= 2139095040u)) && (_e203 > 0u));
                    if _e228 {
                        let _e231 = (bitcast<u32>(bitcast<f32>(_e203)) & 2147483647u);
                        if (_e231 >= 8388608u) {
                            phi_423_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_423_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                        }
                        let _e245 = phi_423_;
                        phi_424_ = _e245;
                    } else {
                        phi_424_ = 0i;
                    }
                    let _e247 = phi_424_;
                    let _e248 = (_e164 == _e203);
                    if _e248 {
                        phi_434_ = true;
                    } else {
                        phi_434_ = (_e171 == _e203);
                    }
                    let _e251 = phi_434_;
                    let _e252 = select(1u, 0u, _e248);
                    if _e251 {
                        let _e253 = (_e252 + 1u);
                        phi_444_ = _e253;
                        phi_445_ = _e253;
                        phi_447_ = select(true, false, (_e253 == 2u));
                    } else {
                        phi_444_ = u32();
                        phi_445_ = 0u;
                        phi_447_ = true;
                    }
                    let _e257 = phi_444_;
                    let _e259 = phi_445_;
                    let _e261 = phi_447_;
                    if _e261 {
                        phi_452_ = (_e259 + 1u);
                    } else {
                        phi_452_ = 0u;
                    }
                    let _e265 = phi_452_;
                    let _e266 = select(_e257, _e259, _e261);
                    let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                    if (_e134 < -126i) {
                        phi_465_ = -126i;
                    } else {
                        phi_465_ = select(_e134, 127i, (_e134 > 127i));
                    }
                    let _e272 = phi_465_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e134 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = -(_e247);
                    if (_e284 < -126i) {
                        phi_485_ = -126i;
                    } else {
                        phi_485_ = select(_e284, 127i, (_e284 > 127i));
                    }
                    let _e289 = phi_485_;
                    let _e294 = bitcast<f32>((bitcast<u32>((_e289 + 127i)) << bitcast<u32>(23i)));
                    let _e300 = bitcast<f32>((bitcast<u32>(((_e284 - _e289) + 127i)) << bitcast<u32>(23i)));
                    let _e304 = global_4.member[_e152].member;
                    let _e305 = (_e266 == 0u);
                    if _e305 {
                        phi_503_ = _e304[0];
                    } else {
                        phi_503_ = _e304[1];
                    }
                    let _e309 = phi_503_;
                    let _e310 = (_e266 == 2u);
                    if _e310 {
                        phi_509_ = _e304[2];
                    } else {
                        phi_509_ = _e309;
                    }
                    let _e313 = phi_509_;
                    let _e314 = bitcast<u32>(_e313);
                    let _e316 = ((_e314 & 2139095040u) != 0u);
                    let _e330 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * _e277) * select(0.00000011920929f, 1f, _e316)) * _e283);
                    let _e331 = global_4.member[_e152].member_2;
                    if _e305 {
                        phi_549_ = _e331[0];
                    } else {
                        phi_549_ = _e331[1];
                    }
                    let _e335 = phi_549_;
                    if _e310 {
                        phi_555_ = _e331[2];
                    } else {
                        phi_555_ = _e335;
                    }
                    let _e338 = phi_555_;
                    let _e339 = bitcast<u32>(_e338);
                    let _e341 = ((_e339 & 2139095040u) != 0u);
                    let _e355 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e339 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e339 & 2147483648u))), _e338, _e341) * _e294) * select(0.00000011920929f, 1f, _e341)) * _e300);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e362 = bitcast<f32>((bitcast<u32>(_e330) & 2147483647u));
                    let _e363 = (_e362 * 0.00000011920929f);
                    let _e366 = select(select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f)), 0f, _e359);
                    let _e367 = select(0f, _e355, _e359);
                    let _e368 = (_e330 + _e366);
                    let _e369 = (_e330 - _e366);
                    let _e371 = select(38685626000000000000000000f, (1f / _e355), _e359);
                    let _e372 = (_e265 == 0u);
                    if _e372 {
                        phi_628_ = _e304[0];
                    } else {
                        phi_628_ = _e304[1];
                    }
                    let _e376 = phi_628_;
                    let _e377 = (_e265 == 2u);
                    if _e377 {
                        phi_634_ = _e304[2];
                    } else {
                        phi_634_ = _e376;
                    }
                    let _e380 = phi_634_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e277) * select(0.00000011920929f, 1f, _e383)) * _e283);
                    if _e372 {
                        phi_674_ = _e331[0];
                    } else {
                        phi_674_ = _e331[1];
                    }
                    let _e401 = phi_674_;
                    if _e377 {
                        phi_680_ = _e331[2];
                    } else {
                        phi_680_ = _e401;
                    }
                    let _e404 = phi_680_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e294) * select(0.00000011920929f, 1f, _e407)) * _e300);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e428 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e429 = (_e428 * 0.00000011920929f);
                    let _e432 = select(select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f)), 0f, _e425);
                    let _e433 = select(0f, _e421, _e425);
                    let _e434 = (_e397 + _e432);
                    let _e435 = (_e397 - _e432);
                    let _e437 = select(38685626000000000000000000f, (1f / _e421), _e425);
                    let _e438 = (_e267 == 0u);
                    if _e438 {
                        phi_753_ = _e304[0];
                    } else {
                        phi_753_ = _e304[1];
                    }
                    let _e442 = phi_753_;
                    let _e443 = (_e267 == 2u);
                    if _e443 {
                        phi_759_ = _e304[2];
                    } else {
                        phi_759_ = _e442;
                    }
                    let _e446 = phi_759_;
                    let _e447 = bitcast<u32>(_e446);
                    let _e449 = ((_e447 & 2139095040u) != 0u);
                    let _e463 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e447 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e447 & 2147483648u))), _e446, _e449) * _e277) * select(0.00000011920929f, 1f, _e449)) * _e283);
                    if _e438 {
                        phi_799_ = _e331[0];
                    } else {
                        phi_799_ = _e331[1];
                    }
                    let _e467 = phi_799_;
                    if _e443 {
                        phi_805_ = _e331[2];
                    } else {
                        phi_805_ = _e467;
                    }
                    let _e470 = phi_805_;
                    let _e471 = bitcast<u32>(_e470);
                    let _e473 = ((_e471 & 2139095040u) != 0u);
                    let _e487 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e471 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e471 & 2147483648u))), _e470, _e473) * _e294) * select(0.00000011920929f, 1f, _e473)) * _e300);
                    let _e491 = (bitcast<f32>((bitcast<u32>(_e487) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e494 = bitcast<f32>((bitcast<u32>(_e463) & 2147483647u));
                    let _e495 = (_e494 * 0.00000011920929f);
                    let _e498 = select(select(0.00000000000011368684f, _e495, (_e495 > 0.00000000000011368684f)), 0f, _e491);
                    let _e499 = select(0f, _e487, _e491);
                    let _e500 = (_e463 + _e498);
                    let _e501 = (_e463 - _e498);
                    let _e503 = select(38685626000000000000000000f, (1f / _e487), _e491);
                    let _e505 = select(_e428, _e362, (_e362 > _e428));
                    let _e508 = (_e134 + _e247);
                    if (_e228 && (select(_e494, _e505, (_e505 > _e494)) <= 1099511600000f)) {
                        let _e518 = ((_e215 & 8388607u) | (select(0u, 1u, ((_e215 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e521 = bitcast<i32>((_e215 >> bitcast<u32>(23i)));
                        let _e525 = (_e518 == 0u);
                        let _e528 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e518)), 32u, _e525)) - 8i);
                        if (_e521 == 255i) {
                            phi_924_ = 255i;
                        } else {
                            phi_924_ = (((_e521 + select(0i, 1i, (_e521 == 0i))) - _e528) + _e508);
                        }
                        let _e536 = phi_924_;
                        let _e546 = (_e536 <= 0i);
                        if _e546 {
                            phi_947_ = u32();
                        } else {
                            if _e525 {
                                phi_946_ = u32();
                            } else {
                                phi_946_ = select(((bitcast<u32>(_e536) << bitcast<u32>(23i)) | ((_e518 << bitcast<u32>(((_e528 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e536 >= 255i));
                            }
                            let _e550 = phi_946_;
                            phi_947_ = _e550;
                        }
                        let _e552 = phi_947_;
                        let _e564 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e567 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                        let _e571 = (_e564 == 0u);
                        let _e574 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e564)), 32u, _e571)) - 8i);
                        if (_e567 == 255i) {
                            phi_984_ = 255i;
                        } else {
                            phi_984_ = (((_e567 + select(0i, 1i, (_e567 == 0i))) - _e574) + _e508);
                        }
                        let _e582 = phi_984_;
                        let _e592 = (_e582 <= 0i);
                        if _e592 {
                            phi_1007_ = u32();
                        } else {
                            if _e571 {
                                phi_1006_ = u32();
                            } else {
                                phi_1006_ = select(((bitcast<u32>(_e582) << bitcast<u32>(23i)) | ((_e564 << bitcast<u32>(((_e574 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e582 >= 255i));
                            }
                            let _e596 = phi_1006_;
                            phi_1007_ = _e596;
                        }
                        let _e598 = phi_1007_;
                        phi_1015_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e598, 0u, select(_e571, true, _e592))));
                        phi_1016_ = bitcast<f32>(((_e214 & 2147483648u) | select(_e552, 0u, select(_e525, true, _e546))));
                    } else {
                        phi_1015_ = 0f;
                        phi_1016_ = 1f;
                    }
                    let _e604 = phi_1015_;
                    let _e606 = phi_1016_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e611 = (_e266 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_1[_e611];
                    let _e617 = (_e265 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    let _e623 = (_e267 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e631 = local[_e611];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e635 = local[_e617];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e639 = local[_e623];
                    phi_4533_ = false;
                    phi_1113_ = type_44(type_37(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e604), 0u, 0u);
                    phi_1116_ = ((3u * _e95) + 1u);
                    phi_1118_ = (_e606 <= _e604);
                    phi_1120_ = 0u;
                    phi_1122_ = type_51(type_32(vec4<f32>((f32(_e614) * _e146), (f32(_e620) * _e146), (f32(_e626) * _e146), 0f), vec4<f32>((f32(_e631) * _e146), (f32(_e635) * _e146), (f32(_e639) * _e146), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                    loop {
                        let _e649 = phi_4533_;
                        let _e651 = phi_1113_;
                        let _e653 = phi_1116_;
                        let _e655 = phi_1118_;
                        let _e657 = phi_1120_;
                        let _e659 = phi_1122_;
                        local_10 = _e651;
                        local_11 = _e651;
                        if _e655 {
                            phi_1133_ = true;
                        } else {
                            phi_1133_ = (_e657 > 0u);
                        }
                        let _e662 = phi_1133_;
                        if _e662 {
                            let _e663 = (_e653 > 0u);
                            if _e663 {
                                if _e655 {
                                    phi_1219_ = _e655;
                                    phi_1220_ = _e657;
                                    phi_1221_ = _e659;
                                } else {
                                    let _e664 = (_e657 - 1u);
                                    let _e665 = (_e664 % 128u);
                                    let _e666 = (_e665 < 128u);
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e668 = local_7[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e670 = local_6[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e672 = local_5[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e674 = local_4[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e676 = local_3[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e678 = local_2[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e683 = local_8[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e686 = local_9[_e665];
                                    phi_1219_ = (_e686 <= _e651.member.member_1);
                                    phi_1220_ = _e664;
                                    phi_1221_ = type_51(type_32(vec4<f32>(_e668, _e670, _e672, 0f), vec4<f32>(_e674, _e676, _e678, 0f)), _e683);
                                }
                                let _e691 = phi_1219_;
                                let _e693 = phi_1220_;
                                let _e695 = phi_1221_;
                                if _e691 {
                                    let _e699 = ((_e695.member_1 & 2147483648u) != 0u);
                                    let _e700 = (_e695.member_1 & 268435455u);
                                    if _e699 {
                                        phi_1240_ = _e651;
                                        phi_1243_ = type_8(0u, ((_e695.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e707 = phi_1240_;
                                            let _e709 = phi_1243_;
                                            local_12 = _e707;
                                            if (_e709.member < _e709.member_1) {
                                                phi_1244_ = type_8((_e709.member + 1u), _e709.member_1);
                                                phi_1266_ = type_8(1u, _e709.member);
                                            } else {
                                                phi_1244_ = _e709;
                                                phi_1266_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e722 = phi_1244_;
                                            let _e724 = phi_1266_;
                                            let _e728 = (bitcast<i32>(_e724.member) != 0i);
                                            if _e728 {
                                                let _e734 = type_44(_e707.member, _e707.member_1, (_e707.member_2 + 1u));
                                                let _e739 = (_e695.member.member_1.x - _e695.member.member.x);
                                                let _e742 = (_e695.member.member_1.y - _e695.member.member.y);
                                                let _e745 = (_e695.member.member_1.z - _e695.member.member.z);
                                                let _e747 = select(_e742, _e739, (_e739 > _e742));
                                                let _e749 = select(_e745, _e747, (_e747 > _e745));
                                                let _e751 = (_e749 < (1024f * _e146));
                                                if _e751 {
                                                    phi_1310_ = 0u;
                                                } else {
                                                    phi_1310_ = select(2u, 1u, (_e749 < (2097152f * _e146)));
                                                }
                                                let _e756 = phi_1310_;
                                                switch bitcast<i32>(_e756) {
                                                    case 0: {
                                                        phi_1316_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1316_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1316_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1316_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e759 = phi_1316_;
                                                switch bitcast<i32>(_e756) {
                                                    case 0: {
                                                        phi_1326_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1326_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1326_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1326_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e766 = phi_1326_;
                                                let _e768 = ((_e700 + (_e724.member_1 * ((3u * _e759) + 1u))) + (3u * _e766));
                                                let _e769 = (_e768 < _e98);
                                                if _e769 {
                                                    if _e769 {
                                                    } else {
                                                        phi_4527_ = true;
                                                        break;
                                                    }
                                                    let _e771 = global_5.member[_e768];
                                                    phi_1342_ = _e771;
                                                } else {
                                                    phi_1342_ = 4294967295u;
                                                }
                                                let _e773 = phi_1342_;
                                                if _e751 {
                                                    phi_1375_ = 0u;
                                                } else {
                                                    phi_1375_ = select(2u, 1u, (_e749 < (2097152f * _e146)));
                                                }
                                                let _e778 = phi_1375_;
                                                switch bitcast<i32>(_e778) {
                                                    case 0: {
                                                        phi_1381_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1381_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1381_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1381_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e781 = phi_1381_;
                                                let _e785 = (_e700 + (_e724.member_1 * ((3u * _e781) + 1u)));
                                                switch bitcast<i32>(_e778) {
                                                    case 0: {
                                                        let _e1060 = (_e785 < _e98);
                                                        if _e1060 {
                                                            if _e1060 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1062 = global_5.member[_e785];
                                                            phi_1408_ = _e1062;
                                                        } else {
                                                            phi_1408_ = 0u;
                                                        }
                                                        let _e1064 = phi_1408_;
                                                        let _e1066 = ((10u * _e266) & 31u);
                                                        let _e1076 = ((10u * _e265) & 31u);
                                                        let _e1086 = ((10u * _e267) & 31u);
                                                        let _e1096 = (_e785 + 1u);
                                                        let _e1097 = (_e1096 < _e98);
                                                        if _e1097 {
                                                            if _e1097 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1099 = global_5.member[_e1096];
                                                            phi_1457_ = _e1099;
                                                        } else {
                                                            phi_1457_ = 0u;
                                                        }
                                                        let _e1101 = phi_1457_;
                                                        let _e1127 = (_e785 + 2u);
                                                        let _e1128 = (_e1127 < _e98);
                                                        if _e1128 {
                                                            if _e1128 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1130 = global_5.member[_e1127];
                                                            phi_1506_ = _e1130;
                                                        } else {
                                                            phi_1506_ = 0u;
                                                        }
                                                        let _e1132 = phi_1506_;
                                                        phi_2007_ = array<array<f32, 3>, 3>(array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1064 >> bitcast<u32>(_e1066)) & 1023u))) - 8388608f) * _e146)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1064 >> bitcast<u32>(_e1076)) & 1023u))) - 8388608f) * _e146)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1064 >> bitcast<u32>(_e1086)) & 1023u))) - 8388608f) * _e146))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1101 >> bitcast<u32>(_e1066)) & 1023u))) - 8388608f) * _e146)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1101 >> bitcast<u32>(_e1076)) & 1023u))) - 8388608f) * _e146)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1101 >> bitcast<u32>(_e1086)) & 1023u))) - 8388608f) * _e146))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1132 >> bitcast<u32>(_e1066)) & 1023u))) - 8388608f) * _e146)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1132 >> bitcast<u32>(_e1076)) & 1023u))) - 8388608f) * _e146)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1132 >> bitcast<u32>(_e1086)) & 1023u))) - 8388608f) * _e146))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e874 = (_e785 < _e98);
                                                        if _e874 {
                                                            if _e874 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e876 = global_5.member[_e785];
                                                            phi_1555_ = _e876;
                                                        } else {
                                                            phi_1555_ = 0u;
                                                        }
                                                        let _e878 = phi_1555_;
                                                        let _e879 = (_e785 + 1u);
                                                        let _e880 = (_e879 < _e98);
                                                        if _e880 {
                                                            if _e880 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e882 = global_5.member[_e879];
                                                            phi_1570_ = _e882;
                                                        } else {
                                                            phi_1570_ = 0u;
                                                        }
                                                        let _e884 = phi_1570_;
                                                        let _e885 = (_e266 == 1u);
                                                        if _e885 {
                                                            phi_1580_ = ((_e878 >> bitcast<u32>(21i)) | (_e884 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1580_ = (_e884 >> bitcast<u32>(10i));
                                                        }
                                                        let _e894 = phi_1580_;
                                                        let _e902 = (_e265 == 1u);
                                                        if _e902 {
                                                            phi_1601_ = ((_e878 >> bitcast<u32>(21i)) | (_e884 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1601_ = (_e884 >> bitcast<u32>(10i));
                                                        }
                                                        let _e911 = phi_1601_;
                                                        let _e919 = (_e267 == 1u);
                                                        if _e919 {
                                                            phi_1622_ = ((_e878 >> bitcast<u32>(21i)) | (_e884 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1622_ = (_e884 >> bitcast<u32>(10i));
                                                        }
                                                        let _e928 = phi_1622_;
                                                        let _e937 = (_e785 + 2u);
                                                        let _e938 = (_e937 < _e98);
                                                        if _e938 {
                                                            if _e938 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e940 = global_5.member[_e937];
                                                            phi_1652_ = _e940;
                                                        } else {
                                                            phi_1652_ = 0u;
                                                        }
                                                        let _e942 = phi_1652_;
                                                        let _e943 = (_e785 + 3u);
                                                        let _e944 = (_e943 < _e98);
                                                        if _e944 {
                                                            if _e944 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e946 = global_5.member[_e943];
                                                            phi_1667_ = _e946;
                                                        } else {
                                                            phi_1667_ = 0u;
                                                        }
                                                        let _e948 = phi_1667_;
                                                        if _e885 {
                                                            phi_1677_ = ((_e942 >> bitcast<u32>(21i)) | (_e948 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1677_ = (_e948 >> bitcast<u32>(10i));
                                                        }
                                                        let _e957 = phi_1677_;
                                                        if _e902 {
                                                            phi_1698_ = ((_e942 >> bitcast<u32>(21i)) | (_e948 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1698_ = (_e948 >> bitcast<u32>(10i));
                                                        }
                                                        let _e973 = phi_1698_;
                                                        if _e919 {
                                                            phi_1719_ = ((_e942 >> bitcast<u32>(21i)) | (_e948 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1719_ = (_e948 >> bitcast<u32>(10i));
                                                        }
                                                        let _e989 = phi_1719_;
                                                        let _e998 = (_e785 + 4u);
                                                        let _e999 = (_e998 < _e98);
                                                        if _e999 {
                                                            if _e999 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1001 = global_5.member[_e998];
                                                            phi_1749_ = _e1001;
                                                        } else {
                                                            phi_1749_ = 0u;
                                                        }
                                                        let _e1003 = phi_1749_;
                                                        let _e1004 = (_e785 + 5u);
                                                        let _e1005 = (_e1004 < _e98);
                                                        if _e1005 {
                                                            if _e1005 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1007 = global_5.member[_e1004];
                                                            phi_1764_ = _e1007;
                                                        } else {
                                                            phi_1764_ = 0u;
                                                        }
                                                        let _e1009 = phi_1764_;
                                                        if _e885 {
                                                            phi_1774_ = ((_e1003 >> bitcast<u32>(21i)) | (_e1009 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1774_ = (_e1009 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1018 = phi_1774_;
                                                        if _e902 {
                                                            phi_1795_ = ((_e1003 >> bitcast<u32>(21i)) | (_e1009 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1795_ = (_e1009 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1034 = phi_1795_;
                                                        if _e919 {
                                                            phi_1816_ = ((_e1003 >> bitcast<u32>(21i)) | (_e1009 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1816_ = (_e1009 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1050 = phi_1816_;
                                                        phi_2007_ = array<array<f32, 3>, 3>(array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e894, _e878, _e305) & 2097151u))) - 8388608f) * _e146)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e911, _e878, _e372) & 2097151u))) - 8388608f) * _e146)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e928, _e878, _e438) & 2097151u))) - 8388608f) * _e146))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e957, _e942, _e305) & 2097151u))) - 8388608f) * _e146)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e973, _e942, _e372) & 2097151u))) - 8388608f) * _e146)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e989, _e942, _e438) & 2097151u))) - 8388608f) * _e146))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1018, _e1003, _e305) & 2097151u))) - 8388608f) * _e146)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1034, _e1003, _e372) & 2097151u))) - 8388608f) * _e146)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1050, _e1003, _e438) & 2097151u))) - 8388608f) * _e146))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e787 = (_e785 + _e266);
                                                        let _e788 = (_e787 < _e98);
                                                        if _e788 {
                                                            if _e788 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e790 = global_5.member[_e787];
                                                            phi_1847_ = _e790;
                                                        } else {
                                                            phi_1847_ = 0u;
                                                        }
                                                        let _e792 = phi_1847_;
                                                        let _e796 = (_e785 + _e265);
                                                        let _e797 = (_e796 < _e98);
                                                        if _e797 {
                                                            if _e797 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e799 = global_5.member[_e796];
                                                            phi_1865_ = _e799;
                                                        } else {
                                                            phi_1865_ = 0u;
                                                        }
                                                        let _e801 = phi_1865_;
                                                        let _e805 = (_e785 + _e267);
                                                        let _e806 = (_e805 < _e98);
                                                        if _e806 {
                                                            if _e806 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e808 = global_5.member[_e805];
                                                            phi_1883_ = _e808;
                                                        } else {
                                                            phi_1883_ = 0u;
                                                        }
                                                        let _e810 = phi_1883_;
                                                        let _e815 = (_e785 + 3u);
                                                        let _e816 = (_e815 + _e266);
                                                        let _e817 = (_e816 < _e98);
                                                        if _e817 {
                                                            if _e817 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e819 = global_5.member[_e816];
                                                            phi_1906_ = _e819;
                                                        } else {
                                                            phi_1906_ = 0u;
                                                        }
                                                        let _e821 = phi_1906_;
                                                        let _e825 = (_e815 + _e265);
                                                        let _e826 = (_e825 < _e98);
                                                        if _e826 {
                                                            if _e826 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e828 = global_5.member[_e825];
                                                            phi_1924_ = _e828;
                                                        } else {
                                                            phi_1924_ = 0u;
                                                        }
                                                        let _e830 = phi_1924_;
                                                        let _e834 = (_e815 + _e267);
                                                        let _e835 = (_e834 < _e98);
                                                        if _e835 {
                                                            if _e835 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e837 = global_5.member[_e834];
                                                            phi_1942_ = _e837;
                                                        } else {
                                                            phi_1942_ = 0u;
                                                        }
                                                        let _e839 = phi_1942_;
                                                        let _e844 = (_e785 + 6u);
                                                        let _e845 = (_e844 + _e266);
                                                        let _e846 = (_e845 < _e98);
                                                        if _e846 {
                                                            if _e846 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e848 = global_5.member[_e845];
                                                            phi_1965_ = _e848;
                                                        } else {
                                                            phi_1965_ = 0u;
                                                        }
                                                        let _e850 = phi_1965_;
                                                        let _e854 = (_e844 + _e265);
                                                        let _e855 = (_e854 < _e98);
                                                        if _e855 {
                                                            if _e855 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e857 = global_5.member[_e854];
                                                            phi_1983_ = _e857;
                                                        } else {
                                                            phi_1983_ = 0u;
                                                        }
                                                        let _e859 = phi_1983_;
                                                        let _e863 = (_e844 + _e267);
                                                        let _e864 = (_e863 < _e98);
                                                        if _e864 {
                                                            if _e864 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e866 = global_5.member[_e863];
                                                            phi_2001_ = _e866;
                                                        } else {
                                                            phi_2001_ = 0u;
                                                        }
                                                        let _e868 = phi_2001_;
                                                        phi_2007_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e792)) * _e146), (f32(bitcast<i32>(_e801)) * _e146), (f32(bitcast<i32>(_e810)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e821)) * _e146), (f32(bitcast<i32>(_e830)) * _e146), (f32(bitcast<i32>(_e839)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e850)) * _e146), (f32(bitcast<i32>(_e859)) * _e146), (f32(bitcast<i32>(_e868)) * _e146)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2007_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1160 = phi_2007_;
                                                let _e1177 = (_e1160[0][2] - _e463);
                                                let _e1180 = (((_e1160[0][0] - _e330) * _e499) - (_e1177 * _e367));
                                                let _e1183 = (((_e1160[0][1] - _e397) * _e499) - (_e1177 * _e433));
                                                let _e1186 = (_e1160[1][2] - _e463);
                                                let _e1189 = (((_e1160[1][0] - _e330) * _e499) - (_e1186 * _e367));
                                                let _e1192 = (((_e1160[1][1] - _e397) * _e499) - (_e1186 * _e433));
                                                let _e1195 = (_e1160[2][2] - _e463);
                                                let _e1198 = (((_e1160[2][0] - _e330) * _e499) - (_e1195 * _e367));
                                                let _e1201 = (((_e1160[2][1] - _e397) * _e499) - (_e1195 * _e433));
                                                let _e1202 = (_e1198 * _e1192);
                                                let _e1203 = (_e1201 * _e1189);
                                                let _e1204 = (_e1180 * _e1201);
                                                let _e1205 = (_e1183 * _e1198);
                                                let _e1206 = (_e1189 * _e1183);
                                                let _e1207 = (_e1192 * _e1180);
                                                let _e1212 = (((_e1202 >= _e1203) && (_e1204 >= _e1205)) && (_e1206 >= _e1207));
                                                let _e1218 = (_e1212 || (((_e1202 <= _e1203) && (_e1204 <= _e1205)) && (_e1206 <= _e1207)));
                                                if _e1218 {
                                                    let _e1220 = select(-1f, 1f, _e1212);
                                                    let _e1222 = ((_e1202 - _e1203) * _e1220);
                                                    let _e1224 = select(0f, _e1222, (_e1222 > 0f));
                                                    let _e1226 = ((_e1204 - _e1205) * _e1220);
                                                    let _e1228 = select(0f, _e1226, (_e1226 > 0f));
                                                    let _e1230 = ((_e1206 - _e1207) * _e1220);
                                                    let _e1232 = select(0f, _e1230, (_e1230 > 0f));
                                                    let _e1234 = ((_e1224 + _e1228) + _e1232);
                                                    let _e1236 = select(_e1160[1][0], _e1160[0][0], (_e1160[0][0] < _e1160[1][0]));
                                                    let _e1240 = select(_e1160[1][0], _e1160[0][0], (_e1160[0][0] > _e1160[1][0]));
                                                    let _e1244 = select(_e1160[1][1], _e1160[0][1], (_e1160[0][1] < _e1160[1][1]));
                                                    let _e1248 = select(_e1160[1][1], _e1160[0][1], (_e1160[0][1] > _e1160[1][1]));
                                                    let _e1252 = select(_e1160[1][2], _e1160[0][2], (_e1160[0][2] < _e1160[1][2]));
                                                    let _e1256 = select(_e1160[1][2], _e1160[0][2], (_e1160[0][2] > _e1160[1][2]));
                                                    let _e1261 = ((select(_e1160[2][0], _e1236, (_e1236 < _e1160[2][0])) - _e368) * _e371);
                                                    let _e1262 = ((select(_e1160[2][0], _e1240, (_e1240 > _e1160[2][0])) - _e369) * _e371);
                                                    let _e1265 = ((select(_e1160[2][1], _e1244, (_e1244 < _e1160[2][1])) - _e434) * _e437);
                                                    let _e1266 = ((select(_e1160[2][1], _e1248, (_e1248 > _e1160[2][1])) - _e435) * _e437);
                                                    let _e1269 = ((select(_e1160[2][2], _e1252, (_e1252 < _e1160[2][2])) - _e500) * _e503);
                                                    let _e1270 = ((select(_e1160[2][2], _e1256, (_e1256 > _e1160[2][2])) - _e501) * _e503);
                                                    let _e1272 = select(_e1270, _e1269, (_e1269 < _e1270));
                                                    let _e1274 = select(_e1270, _e1269, (_e1269 > _e1270));
                                                    let _e1276 = select(_e1262, _e1261, (_e1261 < _e1262));
                                                    let _e1278 = select(_e1266, _e1265, (_e1265 < _e1266));
                                                    let _e1280 = select(_e1278, _e1276, (_e1276 > _e1278));
                                                    let _e1282 = select(_e1272, _e1280, (_e1280 > _e1272));
                                                    let _e1284 = select(_e1262, _e1261, (_e1261 > _e1262));
                                                    let _e1286 = select(_e1266, _e1265, (_e1265 > _e1266));
                                                    let _e1288 = select(_e1286, _e1284, (_e1284 < _e1286));
                                                    let _e1290 = select(_e1274, _e1288, (_e1288 < _e1274));
                                                    let _e1291 = -(_e1272);
                                                    let _e1297 = select(_e606, _e1282, (_e1282 > _e606));
                                                    let _e1301 = select(_e1189, _e1180, (_e1180 < _e1189));
                                                    let _e1306 = select(_e1189, _e1180, (_e1180 > _e1189));
                                                    let _e1313 = select(_e1192, _e1183, (_e1183 < _e1192));
                                                    let _e1318 = select(_e1192, _e1183, (_e1183 > _e1192));
                                                    let _e1327 = (((((_e1218 && (_e1234 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1198, _e1301, (_e1301 < _e1198)) <= 0f) && (select(_e1198, _e1306, (_e1306 > _e1198)) >= 0f))) && ((select(_e1201, _e1313, (_e1313 < _e1201)) <= 0f) && (select(_e1201, _e1318, (_e1318 > _e1201)) >= 0f))) && (_e1297 <= (_e1290 + (select(_e1291, _e1274, (_e1274 > _e1291)) * 0.0000019073523f)))) && (_e1297 <= _e707.member.member_1));
                                                    if _e1327 {
                                                        let _e1332 = (_e1160[1][0] - _e1160[0][0]);
                                                        let _e1333 = (_e1160[1][1] - _e1160[0][1]);
                                                        let _e1334 = (_e1160[1][2] - _e1160[0][2]);
                                                        let _e1335 = vec3<f32>(_e1332, _e1333, _e1334);
                                                        let _e1336 = (_e1160[2][0] - _e1160[1][0]);
                                                        let _e1337 = (_e1160[2][1] - _e1160[1][1]);
                                                        let _e1338 = (_e1160[2][2] - _e1160[1][2]);
                                                        let _e1339 = vec3<f32>(_e1336, _e1337, _e1338);
                                                        let _e1340 = (_e1160[0][0] - _e1160[2][0]);
                                                        let _e1341 = (_e1160[0][1] - _e1160[2][1]);
                                                        let _e1342 = (_e1160[0][2] - _e1160[2][2]);
                                                        let _e1343 = vec3<f32>(_e1340, _e1341, _e1342);
                                                        let _e1344 = abs(_e1332);
                                                        let _e1345 = abs(_e1333);
                                                        if (_e1344 != _e1344) {
                                                            phi_4168_ = true;
                                                        } else {
                                                            phi_4168_ = (_e1345 >= _e1344);
                                                        }
                                                        let _e1349 = phi_4168_;
                                                        let _e1350 = select(_e1344, _e1345, _e1349);
                                                        let _e1351 = abs(_e1334);
                                                        if (_e1350 != _e1350) {
                                                            phi_4183_ = true;
                                                        } else {
                                                            phi_4183_ = (_e1351 >= _e1350);
                                                        }
                                                        let _e1355 = phi_4183_;
                                                        let _e1356 = select(_e1350, _e1351, _e1355);
                                                        let _e1357 = abs(_e1336);
                                                        let _e1358 = abs(_e1337);
                                                        if (_e1357 != _e1357) {
                                                            phi_4198_ = true;
                                                        } else {
                                                            phi_4198_ = (_e1358 >= _e1357);
                                                        }
                                                        let _e1362 = phi_4198_;
                                                        let _e1363 = select(_e1357, _e1358, _e1362);
                                                        let _e1364 = abs(_e1338);
                                                        if (_e1363 != _e1363) {
                                                            phi_4213_ = true;
                                                        } else {
                                                            phi_4213_ = (_e1364 >= _e1363);
                                                        }
                                                        let _e1368 = phi_4213_;
                                                        let _e1369 = select(_e1363, _e1364, _e1368);
                                                        let _e1370 = abs(_e1340);
                                                        let _e1371 = abs(_e1341);
                                                        if (_e1370 != _e1370) {
                                                            phi_4228_ = true;
                                                        } else {
                                                            phi_4228_ = (_e1371 >= _e1370);
                                                        }
                                                        let _e1375 = phi_4228_;
                                                        let _e1376 = select(_e1370, _e1371, _e1375);
                                                        let _e1377 = abs(_e1342);
                                                        if (_e1376 != _e1376) {
                                                            phi_4243_ = true;
                                                        } else {
                                                            phi_4243_ = (_e1377 >= _e1376);
                                                        }
                                                        let _e1381 = phi_4243_;
                                                        let _e1382 = select(_e1376, _e1377, _e1381);
                                                        let _e1384 = select(_e1369, _e1356, (_e1356 > _e1369));
                                                        let _e1386 = select(_e1382, _e1384, (_e1384 > _e1382));
                                                        if (_e1356 == _e1386) {
                                                            phi_2549_ = _e1192;
                                                            phi_2550_ = _e1189;
                                                            phi_2551_ = _e1183;
                                                            phi_2552_ = _e1180;
                                                            phi_2553_ = vec3<f32>(_e1160[0][0], _e1160[0][1], _e1160[0][2]);
                                                            phi_2554_ = _e1343;
                                                            phi_2555_ = _e1339;
                                                            phi_2556_ = _e1335;
                                                        } else {
                                                            let _e1388 = (_e1369 == _e1386);
                                                            let _e1393 = vec3(_e1388);
                                                            phi_2549_ = select(_e1183, _e1201, _e1388);
                                                            phi_2550_ = select(_e1180, _e1198, _e1388);
                                                            phi_2551_ = select(_e1201, _e1192, _e1388);
                                                            phi_2552_ = select(_e1198, _e1189, _e1388);
                                                            phi_2553_ = select(vec3<f32>(_e1160[2][0], _e1160[2][1], _e1160[2][2]), vec3<f32>(_e1160[1][0], _e1160[1][1], _e1160[1][2]), _e1393);
                                                            phi_2554_ = select(_e1339, _e1335, _e1393);
                                                            phi_2555_ = select(_e1335, _e1343, _e1393);
                                                            phi_2556_ = select(_e1343, _e1339, _e1393);
                                                        }
                                                        let _e1399 = phi_2549_;
                                                        let _e1401 = phi_2550_;
                                                        let _e1403 = phi_2551_;
                                                        let _e1405 = phi_2552_;
                                                        let _e1407 = phi_2553_;
                                                        let _e1409 = phi_2554_;
                                                        let _e1411 = phi_2555_;
                                                        let _e1413 = phi_2556_;
                                                        let _e1420 = ((_e1411.y * _e1409.z) - (_e1409.y * _e1411.z));
                                                        let _e1425 = ((_e1411.z * _e1409.x) - (_e1409.z * _e1411.x));
                                                        let _e1428 = ((_e1411.x * _e1409.y) - (_e1409.x * _e1411.y));
                                                        let _e1431 = ((_e1224 >= _e1228) && (_e1224 >= _e1232));
                                                        let _e1432 = (_e1228 >= _e1232);
                                                        let _e1446 = (((_e1420 * (select(select(_e1160[2][0], _e1160[1][0], _e1432), _e1160[0][0], _e1431) - _e330)) + (_e1425 * (select(select(_e1160[2][1], _e1160[1][1], _e1432), _e1160[0][1], _e1431) - _e397))) + (_e1428 * (select(select(_e1160[2][2], _e1160[1][2], _e1432), _e1160[0][2], _e1431) - _e463)));
                                                        let _e1451 = (((_e1420 * _e367) + (_e1425 * _e433)) + (_e1428 * _e499));
                                                        let _e1452 = (_e1401 - _e1405);
                                                        let _e1453 = (_e1399 - _e1403);
                                                        let _e1456 = ((_e1452 * _e1452) + (_e1453 * _e1453));
                                                        let _e1463 = (-(((_e1405 * _e1452) + (_e1403 * _e1453))) / select(0.000000000000000000000000000000000000011754944f, _e1456, (_e1456 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1465 = select(1f, _e1463, (_e1463 < 1f));
                                                        let _e1467 = select(0f, _e1465, (_e1465 > 0f));
                                                        let _e1476 = ((_e1407.x + (_e1413.x * _e1467)) - _e330);
                                                        let _e1479 = ((_e1407.y + (_e1413.y * _e1467)) - _e397);
                                                        let _e1482 = ((_e1407.z + (_e1413.z * _e1467)) - _e463);
                                                        let _e1485 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                        let _e1488 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                        let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                        let _e1493 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                        let _e1495 = select(_e1493, _e1490, (_e1490 > _e1493));
                                                        let _e1499 = abs(_e1420);
                                                        let _e1500 = abs(_e1425);
                                                        if (_e1499 != _e1499) {
                                                            phi_4258_ = true;
                                                        } else {
                                                            phi_4258_ = (_e1500 >= _e1499);
                                                        }
                                                        let _e1504 = phi_4258_;
                                                        let _e1505 = select(_e1499, _e1500, _e1504);
                                                        let _e1506 = abs(_e1428);
                                                        if (_e1505 != _e1505) {
                                                            phi_4273_ = true;
                                                        } else {
                                                            phi_4273_ = (_e1506 >= _e1505);
                                                        }
                                                        let _e1510 = phi_4273_;
                                                        let _e1526 = abs(_e1411.x);
                                                        let _e1527 = abs(_e1411.y);
                                                        if (_e1526 != _e1526) {
                                                            phi_4288_ = true;
                                                        } else {
                                                            phi_4288_ = (_e1527 >= _e1526);
                                                        }
                                                        let _e1531 = phi_4288_;
                                                        let _e1532 = select(_e1526, _e1527, _e1531);
                                                        let _e1533 = abs(_e1411.z);
                                                        if (_e1532 != _e1532) {
                                                            phi_4303_ = true;
                                                        } else {
                                                            phi_4303_ = (_e1533 >= _e1532);
                                                        }
                                                        let _e1537 = phi_4303_;
                                                        let _e1540 = abs(_e1409.x);
                                                        let _e1541 = abs(_e1409.y);
                                                        if (_e1540 != _e1540) {
                                                            phi_4318_ = true;
                                                        } else {
                                                            phi_4318_ = (_e1541 >= _e1540);
                                                        }
                                                        let _e1545 = phi_4318_;
                                                        let _e1546 = select(_e1540, _e1541, _e1545);
                                                        let _e1547 = abs(_e1409.z);
                                                        if (_e1546 != _e1546) {
                                                            phi_4333_ = true;
                                                        } else {
                                                            phi_4333_ = (_e1547 >= _e1546);
                                                        }
                                                        let _e1551 = phi_4333_;
                                                        let _e1556 = ((bitcast<f32>((bitcast<u32>(((((_e1420 * _e1476) + (_e1425 * _e1479)) + (_e1428 * _e1482)) - _e1446)) & 2147483647u)) <= ((0.0000009536743f * select(_e1386, _e1495, (_e1495 > _e1386))) * select(_e1505, _e1506, _e1510))) && !((bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u)) <= ((0.0000038146973f * select(_e1532, _e1533, _e1537)) * select(_e1546, _e1547, _e1551)))));
                                                        let _e1557 = (_e1446 / _e1451);
                                                        if (_e1327 && !(_e1556)) {
                                                            let _e1560 = (_e1482 / _e499);
                                                            let _e1568 = (((_e1420 * (_e1476 - (_e367 * _e1560))) + (_e1425 * (_e1479 - (_e433 * _e1560)))) / _e1451);
                                                            phi_2764_ = select(select(_e1560, (_e1560 + _e1568), (bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u)) <= _e1386)), _e1557, _e1556);
                                                        } else {
                                                            phi_2764_ = _e1557;
                                                        }
                                                        let _e1577 = phi_2764_;
                                                        let _e1579 = select(_e1290, _e1577, (_e1577 < _e1290));
                                                        let _e1581 = select(_e1282, _e1579, (_e1579 > _e1282));
                                                        let _e1582 = (1f / _e1234);
                                                        phi_2784_ = type_40(_e1581, (_e1228 * _e1582), (_e1232 * _e1582), ((_e1327 && (_e1581 >= _e606)) && (_e1581 <= _e707.member.member_1)));
                                                        phi_2785_ = type_40();
                                                    } else {
                                                        phi_2784_ = type_40();
                                                        phi_2785_ = type_40(0f, 0f, 0f, _e1327);
                                                    }
                                                    let _e1591 = phi_2784_;
                                                    let _e1593 = phi_2785_;
                                                    phi_2788_ = _e1591;
                                                    phi_2789_ = _e1593;
                                                    phi_2790_ = select(true, false, _e1327);
                                                } else {
                                                    phi_2788_ = type_40();
                                                    phi_2789_ = type_40(0f, 0f, 0f, _e1218);
                                                    phi_2790_ = true;
                                                }
                                                let _e1596 = phi_2788_;
                                                let _e1598 = phi_2789_;
                                                let _e1600 = phi_2790_;
                                                if _e1600 {
                                                    phi_2794_ = _e1598;
                                                } else {
                                                    phi_2794_ = _e1596;
                                                }
                                                let _e1602 = phi_2794_;
                                                if _e1602.member_3 {
                                                    phi_2803_ = type_28(_e1602.member, _e1602.member_1, _e1602.member_2, _e773);
                                                } else {
                                                    phi_2803_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1609 = phi_2803_;
                                                if (_e1609.member_3 != 4294967295u) {
                                                    if (_e773 != 4294967295u) {
                                                        if (_e1609.member < _e707.member.member.member) {
                                                            phi_2829_ = true;
                                                        } else {
                                                            if (_e1609.member == _e707.member.member.member) {
                                                                phi_2828_ = (_e1609.member_3 < _e707.member.member.member_3);
                                                            } else {
                                                                phi_2828_ = false;
                                                            }
                                                            let _e1624 = phi_2828_;
                                                            phi_2829_ = _e1624;
                                                        }
                                                        let _e1626 = phi_2829_;
                                                        if _e1626 {
                                                            phi_2836_ = type_44(type_37(_e1609, _e1609.member), _e734.member_1, _e734.member_2);
                                                        } else {
                                                            phi_2836_ = _e734;
                                                        }
                                                        let _e1633 = phi_2836_;
                                                        phi_2837_ = _e1633;
                                                    } else {
                                                        phi_2837_ = _e734;
                                                    }
                                                    let _e1635 = phi_2837_;
                                                    phi_2838_ = _e1635;
                                                } else {
                                                    phi_2838_ = _e734;
                                                }
                                                let _e1637 = phi_2838_;
                                                phi_1241_ = _e1637;
                                            } else {
                                                phi_1241_ = type_44();
                                            }
                                            let _e1639 = phi_1241_;
                                            continue;
                                            continuing {
                                                phi_1240_ = _e1639;
                                                phi_1243_ = _e722;
                                                phi_4527_ = _e649;
                                                break if !(_e728);
                                            }
                                        }
                                        let _e1642 = phi_4527_;
                                        phi_4739_ = _e1642;
                                        if _e1642 {
                                            break;
                                        }
                                        phi_4830_ = _e1642;
                                        let _e2294 = local_12;
                                        phi_2839_ = _e2294;
                                    } else {
                                        phi_4830_ = _e649;
                                        phi_2839_ = _e651;
                                    }
                                    let _e1644 = phi_4830_;
                                    let _e1646 = phi_2839_;
                                    if _e699 {
                                        phi_4108_ = type_44();
                                        phi_4109_ = bool();
                                        phi_4110_ = u32();
                                        phi_4111_ = type_51();
                                    } else {
                                        if (_e695.member_1 >= _e95) {
                                            phi_3640_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e695.member_1 < _e95) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1650 = ((1u + _e266) % 4u);
                                            if (_e1650 < 4u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1655 = global_3.member[_e695.member_1][_e1650];
                                            let _e1657 = (_e1655 >> bitcast<u32>(11u));
                                            let _e1659 = ((1u + _e265) % 4u);
                                            if (_e1659 < 4u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1664 = global_3.member[_e695.member_1][_e1659];
                                            let _e1666 = (_e1664 >> bitcast<u32>(11u));
                                            let _e1668 = ((1u + _e267) % 4u);
                                            if (_e1668 < 4u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1673 = global_3.member[_e695.member_1][_e1668];
                                            let _e1675 = (_e1673 >> bitcast<u32>(11u));
                                            let _e1698 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.x - _e695.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1699 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.y - _e695.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1700 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.z - _e695.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1702 = select(_e146, _e1698, (_e1698 > _e146));
                                            let _e1704 = select(_e146, _e1699, (_e1699 > _e146));
                                            let _e1706 = select(_e146, _e1700, (_e1700 > _e146));
                                            let _e1737 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1655 & 1023u))) - 8388608f) * _e1702));
                                            let _e1742 = (bitcast<i32>((_e1655 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1745 = bitcast<f32>((_e1737 & bitcast<u32>(_e1742)));
                                            let _e1746 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1664 & 1023u))) - 8388608f) * _e1704));
                                            let _e1751 = (bitcast<i32>((_e1664 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1754 = bitcast<f32>((_e1746 & bitcast<u32>(_e1751)));
                                            let _e1755 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1673 & 1023u))) - 8388608f) * _e1706));
                                            let _e1760 = (bitcast<i32>((_e1673 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1763 = bitcast<f32>((_e1755 & bitcast<u32>(_e1760)));
                                            let _e1767 = bitcast<f32>((_e1737 & bitcast<u32>(~(_e1742))));
                                            let _e1771 = bitcast<f32>((_e1746 & bitcast<u32>(~(_e1751))));
                                            let _e1775 = bitcast<f32>((_e1755 & bitcast<u32>(~(_e1760))));
                                            let _e1776 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1657 & 1023u))) - 8388608f) * _e1702));
                                            let _e1781 = (bitcast<i32>((_e1657 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1784 = bitcast<f32>((_e1776 & bitcast<u32>(_e1781)));
                                            let _e1785 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1666 & 1023u))) - 8388608f) * _e1704));
                                            let _e1790 = (bitcast<i32>((_e1666 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1793 = bitcast<f32>((_e1785 & bitcast<u32>(_e1790)));
                                            let _e1794 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1675 & 1023u))) - 8388608f) * _e1706));
                                            let _e1799 = (bitcast<i32>((_e1675 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1802 = bitcast<f32>((_e1794 & bitcast<u32>(_e1799)));
                                            let _e1806 = bitcast<f32>((_e1776 & bitcast<u32>(~(_e1781))));
                                            let _e1810 = bitcast<f32>((_e1785 & bitcast<u32>(~(_e1790))));
                                            let _e1814 = bitcast<f32>((_e1794 & bitcast<u32>(~(_e1799))));
                                            let _e1815 = (_e695.member.member.x + _e1745);
                                            let _e1816 = (_e695.member.member.y + _e1754);
                                            let _e1817 = (_e695.member.member.z + _e1763);
                                            let _e1820 = (_e695.member.member_1.x - _e1784);
                                            let _e1821 = (_e695.member.member_1.y - _e1793);
                                            let _e1822 = (_e695.member.member_1.z - _e1802);
                                            let _e1841 = (_e1820 - _e1815);
                                            let _e1842 = (_e1821 - _e1816);
                                            let _e1843 = (_e1822 - _e1817);
                                            let _e1845 = select(_e1842, _e1841, (_e1841 > _e1842));
                                            let _e1847 = select(_e1843, _e1845, (_e1845 > _e1843));
                                            if (_e1847 < (1024f * _e146)) {
                                                phi_3341_ = 0u;
                                            } else {
                                                phi_3341_ = select(2u, 1u, (_e1847 < (2097152f * _e146)));
                                            }
                                            let _e1854 = phi_3341_;
                                            switch bitcast<i32>(_e1854) {
                                                case 0: {
                                                    phi_3347_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3347_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3347_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3347_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1857 = phi_3347_;
                                            let _e1863 = global_3.member[_e695.member_1][0u];
                                            let _e1867 = global_3.member[_e695.member_1][1u];
                                            let _e1871 = global_3.member[_e695.member_1][2u];
                                            let _e1875 = global_3.member[_e695.member_1][3u];
                                            let _e1887 = (((_e1867 >> bitcast<u32>(22i)) | ((_e1871 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1875 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1888 = (_e1863 & 268435455u);
                                            let _e1889 = (_e1887 & 268435455u);
                                            let _e1892 = ((_e1863 >> bitcast<u32>(28u)) & 7u);
                                            let _e1900 = ((_e1863 >> bitcast<u32>(31i)) | (((_e1887 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1901 = (_e1892 != 0u);
                                            if (_e1892 == 0u) {
                                                phi_3602_ = _e1888;
                                            } else {
                                                if (_e1892 == 7u) {
                                                    phi_3601_ = 2147483648u;
                                                } else {
                                                    phi_3601_ = ((2147483648u | (_e1892 << bitcast<u32>(28u))) | (_e1889 & 268435455u));
                                                }
                                                let _e1910 = phi_3601_;
                                                phi_3602_ = _e1910;
                                            }
                                            let _e1912 = phi_3602_;
                                            if _e1901 {
                                                let _e1913 = (_e1892 != 7u);
                                                if _e1913 {
                                                    phi_3612_ = (_e1889 + (_e1892 * ((3u * _e1857) + 1u)));
                                                } else {
                                                    phi_3612_ = u32();
                                                }
                                                let _e1917 = phi_3612_;
                                                phi_3614_ = _e1917;
                                                phi_3615_ = select(true, false, _e1913);
                                            } else {
                                                phi_3614_ = u32();
                                                phi_3615_ = true;
                                            }
                                            let _e1920 = phi_3614_;
                                            let _e1922 = phi_3615_;
                                            if (_e1900 == 0u) {
                                                phi_3636_ = (_e1888 + select(0u, 1u, !(_e1901)));
                                            } else {
                                                if (_e1900 == 7u) {
                                                    phi_3635_ = 2147483648u;
                                                } else {
                                                    phi_3635_ = ((2147483648u | (_e1900 << bitcast<u32>(28u))) | (select(_e1920, _e1889, _e1922) & 268435455u));
                                                }
                                                let _e1935 = phi_3635_;
                                                phi_3636_ = _e1935;
                                            }
                                            let _e1937 = phi_3636_;
                                            phi_3640_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e1815, (_e695.member.member.x + _e1767), _e1820, (_e695.member.member_1.x - _e1806)), vec4<f32>(_e1816, (_e695.member.member.y + _e1771), _e1821, (_e695.member.member_1.y - _e1810)), vec4<f32>(_e1817, (_e695.member.member.z + _e1775), _e1822, (_e695.member.member_1.z - _e1814))), type_51(type_32((_e695.member.member + vec4<f32>(_e1745, _e1754, _e1763, 0f)), (_e695.member.member_1 - vec4<f32>(_e1784, _e1793, _e1802, 0f))), _e1912), type_51(type_32((_e695.member.member + vec4<f32>(_e1767, _e1771, _e1775, 0f)), (_e695.member.member_1 - vec4<f32>(_e1806, _e1810, _e1814, 0f))), _e1937));
                                        }
                                        let _e1942 = phi_3640_;
                                        let _e1961 = ((_e1942.member[0].x - _e368) * _e371);
                                        let _e1962 = ((_e1942.member[0].y - _e368) * _e371);
                                        let _e1963 = ((_e1942.member[0].z - _e369) * _e371);
                                        let _e1964 = ((_e1942.member[0].w - _e369) * _e371);
                                        let _e1974 = ((_e1942.member[1].x - _e434) * _e437);
                                        let _e1975 = ((_e1942.member[1].y - _e434) * _e437);
                                        let _e1976 = ((_e1942.member[1].z - _e435) * _e437);
                                        let _e1977 = ((_e1942.member[1].w - _e435) * _e437);
                                        let _e1987 = ((_e1942.member[2].x - _e500) * _e503);
                                        let _e1988 = ((_e1942.member[2].y - _e500) * _e503);
                                        let _e1989 = ((_e1942.member[2].z - _e501) * _e503);
                                        let _e1990 = ((_e1942.member[2].w - _e501) * _e503);
                                        let _e1992 = select(_e1989, _e1987, (_e1987 < _e1989));
                                        let _e1994 = select(_e1990, _e1988, (_e1988 < _e1990));
                                        let _e1996 = select(_e1989, _e1987, (_e1987 > _e1989));
                                        let _e1998 = select(_e1990, _e1988, (_e1988 > _e1990));
                                        let _e2000 = select(_e1963, _e1961, (_e1961 < _e1963));
                                        let _e2002 = select(_e1964, _e1962, (_e1962 < _e1964));
                                        let _e2004 = select(_e1976, _e1974, (_e1974 < _e1976));
                                        let _e2006 = select(_e1977, _e1975, (_e1975 < _e1977));
                                        let _e2008 = select(_e2004, _e2000, (_e2000 > _e2004));
                                        let _e2010 = select(_e2006, _e2002, (_e2002 > _e2006));
                                        let _e2012 = select(_e1992, _e2008, (_e2008 > _e1992));
                                        let _e2014 = select(_e1994, _e2010, (_e2010 > _e1994));
                                        let _e2016 = select(_e1963, _e1961, (_e1961 > _e1963));
                                        let _e2018 = select(_e1964, _e1962, (_e1962 > _e1964));
                                        let _e2020 = select(_e1976, _e1974, (_e1974 > _e1976));
                                        let _e2022 = select(_e1977, _e1975, (_e1975 > _e1977));
                                        let _e2024 = select(_e2020, _e2016, (_e2016 < _e2020));
                                        let _e2026 = select(_e2022, _e2018, (_e2018 < _e2022));
                                        let _e2031 = -(_e1992);
                                        let _e2032 = -(_e1994);
                                        let _e2039 = (select(_e1996, _e2024, (_e2024 < _e1996)) + (select(_e2031, _e1996, (_e1996 > _e2031)) * 0.0000019073523f));
                                        let _e2040 = (select(_e1998, _e2026, (_e2026 < _e1998)) + (select(_e2032, _e1998, (_e1998 > _e2032)) * 0.0000019073523f));
                                        let _e2042 = select(_e606, _e2012, (_e2012 > _e606));
                                        let _e2044 = select(_e606, _e2014, (_e2014 > _e606));
                                        let _e2049 = (_e2042 <= select(_e1646.member.member_1, _e2039, (_e2039 < _e1646.member.member_1)));
                                        let _e2050 = (_e2044 <= select(_e1646.member.member_1, _e2040, (_e2040 < _e1646.member.member_1)));
                                        let _e2051 = (_e2042 <= _e2044);
                                        if _e2049 {
                                            if _e2050 {
                                                if _e2051 {
                                                    phi_4005_ = _e1942.member_2;
                                                } else {
                                                    phi_4005_ = _e1942.member_1;
                                                }
                                                let _e2055 = phi_4005_;
                                                let _e2076 = (_e693 % 128u);
                                                let _e2077 = (_e2076 < 128u);
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_8[_e2076] = _e2055.member_1;
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_7[_e2076] = _e2055.member.member.x;
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_6[_e2076] = _e2055.member.member.y;
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_5[_e2076] = _e2055.member.member.z;
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_4[_e2076] = _e2055.member.member_1.x;
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_3[_e2076] = _e2055.member.member_1.y;
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_2[_e2076] = _e2055.member.member_1.z;
                                                if _e2077 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_9[_e2076] = select(_e2042, _e2044, _e2051);
                                                if _e2051 {
                                                    phi_4081_ = _e1942.member_1;
                                                } else {
                                                    phi_4081_ = _e1942.member_2;
                                                }
                                                let _e2090 = phi_4081_;
                                                phi_4082_ = (_e693 + 1u);
                                                phi_4083_ = _e2090;
                                            } else {
                                                phi_4082_ = u32();
                                                phi_4083_ = type_51();
                                            }
                                            let _e2092 = phi_4082_;
                                            let _e2094 = phi_4083_;
                                            phi_4085_ = _e2092;
                                            phi_4086_ = _e2094;
                                            phi_4087_ = select(true, false, _e2050);
                                        } else {
                                            phi_4085_ = u32();
                                            phi_4086_ = type_51();
                                            phi_4087_ = true;
                                        }
                                        let _e2097 = phi_4085_;
                                        let _e2099 = phi_4086_;
                                        let _e2101 = phi_4087_;
                                        if _e2101 {
                                            if _e2049 {
                                                phi_4096_ = _e1942.member_1;
                                            } else {
                                                phi_4096_ = _e1942.member_2;
                                            }
                                            let _e2105 = phi_4096_;
                                            phi_4101_ = select(_e2050, true, _e2049);
                                            phi_4103_ = _e2105;
                                        } else {
                                            phi_4101_ = _e691;
                                            phi_4103_ = _e2099;
                                        }
                                        let _e2108 = phi_4101_;
                                        let _e2110 = phi_4103_;
                                        phi_4108_ = type_44(_e1646.member, (_e1646.member_1 + 1u), _e1646.member_2);
                                        phi_4109_ = _e2108;
                                        phi_4110_ = select(_e2097, _e693, _e2101);
                                        phi_4111_ = _e2110;
                                    }
                                    let _e2113 = phi_4108_;
                                    let _e2115 = phi_4109_;
                                    let _e2117 = phi_4110_;
                                    let _e2119 = phi_4111_;
                                    if _e699 {
                                        phi_4119_ = _e1646;
                                        phi_4122_ = _e695;
                                    } else {
                                        phi_4119_ = _e2113;
                                        phi_4122_ = _e2119;
                                    }
                                    let _e2121 = phi_4119_;
                                    let _e2123 = phi_4122_;
                                    phi_4742_ = _e1644;
                                    phi_4123_ = _e2121;
                                    phi_4124_ = (_e653 - 1u);
                                    phi_4125_ = select(_e2115, false, _e699);
                                    phi_4126_ = select(_e2117, _e693, _e699);
                                    phi_4127_ = _e2123;
                                } else {
                                    phi_4742_ = _e649;
                                    phi_4123_ = _e651;
                                    phi_4124_ = _e653;
                                    phi_4125_ = _e691;
                                    phi_4126_ = _e693;
                                    phi_4127_ = _e695;
                                }
                                let _e2127 = phi_4742_;
                                let _e2129 = phi_4123_;
                                let _e2131 = phi_4124_;
                                let _e2133 = phi_4125_;
                                let _e2135 = phi_4126_;
                                let _e2137 = phi_4127_;
                                phi_4741_ = _e2127;
                                phi_4128_ = _e2129;
                                phi_4129_ = _e2131;
                                phi_4130_ = _e2133;
                                phi_4131_ = _e2135;
                                phi_4132_ = _e2137;
                            } else {
                                phi_4741_ = _e649;
                                phi_4128_ = type_44();
                                phi_4129_ = u32();
                                phi_4130_ = bool();
                                phi_4131_ = u32();
                                phi_4132_ = type_51();
                            }
                            let _e2139 = phi_4741_;
                            let _e2141 = phi_4128_;
                            let _e2143 = phi_4129_;
                            let _e2145 = phi_4130_;
                            let _e2147 = phi_4131_;
                            let _e2149 = phi_4132_;
                            phi_4740_ = _e2139;
                            phi_1114_ = _e2141;
                            phi_1117_ = _e2143;
                            phi_1119_ = _e2145;
                            phi_1121_ = _e2147;
                            phi_1123_ = _e2149;
                            phi_4133_ = _e663;
                        } else {
                            phi_4740_ = _e649;
                            phi_1114_ = type_44();
                            phi_1117_ = u32();
                            phi_1119_ = bool();
                            phi_1121_ = u32();
                            phi_1123_ = type_51();
                            phi_4133_ = false;
                        }
                        let _e2151 = phi_4740_;
                        let _e2153 = phi_1114_;
                        let _e2155 = phi_1117_;
                        let _e2157 = phi_1119_;
                        let _e2159 = phi_1121_;
                        let _e2161 = phi_1123_;
                        let _e2163 = phi_4133_;
                        continue;
                        continuing {
                            phi_4533_ = _e2151;
                            phi_1113_ = _e2153;
                            phi_1116_ = _e2155;
                            phi_1118_ = _e2157;
                            phi_1120_ = _e2159;
                            phi_1122_ = _e2161;
                            phi_4739_ = _e2151;
                            break if !(_e2163);
                        }
                    }
                    let _e2166 = phi_4739_;
                    if _e2166 {
                        break;
                    }
                    let _e2168 = local_10;
                    let _e2171 = local_11;
                    if _e154 {
                    } else {
                        break;
                    }
                    global_6.member[_e152][0u] = _e2168.member_1;
                    global_6.member[_e152][1u] = _e2171.member_2;
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
