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
    var phi_430_: i32;
    var phi_431_: i32;
    var phi_441_: bool;
    var phi_451_: u32;
    var phi_452_: u32;
    var phi_454_: bool;
    var phi_459_: u32;
    var phi_472_: i32;
    var phi_492_: i32;
    var phi_510_: f32;
    var phi_516_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_635_: f32;
    var phi_641_: f32;
    var phi_681_: f32;
    var phi_687_: f32;
    var phi_760_: f32;
    var phi_766_: f32;
    var phi_806_: f32;
    var phi_812_: f32;
    var phi_931_: i32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_991_: i32;
    var phi_1013_: u32;
    var phi_1014_: u32;
    var phi_1022_: f32;
    var phi_1023_: f32;
    var phi_4459_: bool;
    var phi_1120_: type_44;
    var phi_1123_: bool;
    var phi_1125_: type_51;
    var phi_1127_: u32;
    var phi_1129_: u32;
    var phi_1140_: bool;
    var phi_1226_: bool;
    var phi_1227_: type_51;
    var phi_1228_: u32;
    var phi_3318_: u32;
    var phi_3324_: u32;
    var phi_3578_: u32;
    var phi_3579_: u32;
    var phi_3589_: u32;
    var phi_3591_: u32;
    var phi_3592_: bool;
    var phi_3612_: u32;
    var phi_3613_: u32;
    var phi_3617_: type_52;
    var phi_3982_: type_51;
    var phi_4058_: type_51;
    var phi_4059_: type_51;
    var phi_4060_: u32;
    var phi_4062_: type_51;
    var phi_4063_: u32;
    var phi_4064_: bool;
    var phi_4073_: type_51;
    var phi_4078_: bool;
    var phi_4079_: type_51;
    var phi_1247_: type_44;
    var phi_1250_: type_8;
    var phi_1251_: type_8;
    var phi_1273_: type_8;
    var phi_1317_: u32;
    var phi_1323_: u32;
    var phi_1333_: u32;
    var phi_1349_: u32;
    var phi_1382_: u32;
    var phi_1388_: u32;
    var phi_1854_: u32;
    var phi_1872_: u32;
    var phi_1890_: u32;
    var phi_1913_: u32;
    var phi_1931_: u32;
    var phi_1949_: u32;
    var phi_1972_: u32;
    var phi_1990_: u32;
    var phi_2008_: u32;
    var phi_1562_: u32;
    var phi_1577_: u32;
    var phi_1587_: u32;
    var phi_1608_: u32;
    var phi_1629_: u32;
    var phi_1659_: u32;
    var phi_1674_: u32;
    var phi_1684_: u32;
    var phi_1705_: u32;
    var phi_1726_: u32;
    var phi_1756_: u32;
    var phi_1771_: u32;
    var phi_1781_: u32;
    var phi_1802_: u32;
    var phi_1823_: u32;
    var phi_1415_: u32;
    var phi_1464_: u32;
    var phi_1513_: u32;
    var phi_2014_: array<array<f32, 3>, 3>;
    var phi_2544_: f32;
    var phi_2545_: f32;
    var phi_2546_: f32;
    var phi_2547_: f32;
    var phi_2548_: vec3<f32>;
    var phi_2549_: vec3<f32>;
    var phi_2550_: vec3<f32>;
    var phi_2551_: vec3<f32>;
    var phi_2742_: f32;
    var phi_2762_: type_40;
    var phi_2763_: type_40;
    var phi_2766_: type_40;
    var phi_2767_: type_40;
    var phi_2768_: bool;
    var phi_2772_: type_40;
    var phi_2781_: type_28;
    var phi_2806_: bool;
    var phi_2807_: bool;
    var phi_2814_: type_44;
    var phi_2815_: type_44;
    var phi_2816_: type_44;
    var phi_1248_: type_44;
    var phi_4453_: bool;
    var local_10: type_44;
    var phi_4657_: bool;
    var phi_4081_: type_44;
    var phi_4082_: bool;
    var phi_4083_: type_51;
    var phi_4084_: u32;
    var phi_4656_: bool;
    var phi_4085_: type_44;
    var phi_4086_: bool;
    var phi_4087_: type_51;
    var phi_4088_: u32;
    var phi_4089_: u32;
    var phi_4655_: bool;
    var phi_4090_: type_44;
    var phi_4091_: bool;
    var phi_4092_: type_51;
    var phi_4093_: u32;
    var phi_4094_: u32;
    var phi_4654_: bool;
    var phi_1121_: type_44;
    var phi_1124_: bool;
    var phi_1126_: type_51;
    var phi_1128_: u32;
    var phi_1130_: u32;
    var phi_4095_: bool;
    var phi_4653_: bool;
    var local_11: type_44;
    var local_12: type_44;
    var local_13: type_44;

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
                            phi_430_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_430_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                        }
                        let _e245 = phi_430_;
                        phi_431_ = _e245;
                    } else {
                        phi_431_ = 0i;
                    }
                    let _e247 = phi_431_;
                    let _e248 = (_e164 == _e203);
                    if _e248 {
                        phi_441_ = true;
                    } else {
                        phi_441_ = (_e171 == _e203);
                    }
                    let _e251 = phi_441_;
                    let _e252 = select(1u, 0u, _e248);
                    if _e251 {
                        let _e253 = (_e252 + 1u);
                        phi_451_ = _e253;
                        phi_452_ = _e253;
                        phi_454_ = select(true, false, (_e253 == 2u));
                    } else {
                        phi_451_ = u32();
                        phi_452_ = 0u;
                        phi_454_ = true;
                    }
                    let _e257 = phi_451_;
                    let _e259 = phi_452_;
                    let _e261 = phi_454_;
                    if _e261 {
                        phi_459_ = (_e259 + 1u);
                    } else {
                        phi_459_ = 0u;
                    }
                    let _e265 = phi_459_;
                    let _e266 = select(_e257, _e259, _e261);
                    let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                    if (_e134 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e134, 127i, (_e134 > 127i));
                    }
                    let _e272 = phi_472_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e134 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = -(_e247);
                    if (_e284 < -126i) {
                        phi_492_ = -126i;
                    } else {
                        phi_492_ = select(_e284, 127i, (_e284 > 127i));
                    }
                    let _e289 = phi_492_;
                    let _e294 = bitcast<f32>((bitcast<u32>((_e289 + 127i)) << bitcast<u32>(23i)));
                    let _e300 = bitcast<f32>((bitcast<u32>(((_e284 - _e289) + 127i)) << bitcast<u32>(23i)));
                    let _e304 = global_4.member[_e152].member;
                    let _e305 = (_e266 == 0u);
                    if _e305 {
                        phi_510_ = _e304[0];
                    } else {
                        phi_510_ = _e304[1];
                    }
                    let _e309 = phi_510_;
                    let _e310 = (_e266 == 2u);
                    if _e310 {
                        phi_516_ = _e304[2];
                    } else {
                        phi_516_ = _e309;
                    }
                    let _e313 = phi_516_;
                    let _e314 = bitcast<u32>(_e313);
                    let _e316 = ((_e314 & 2139095040u) != 0u);
                    let _e330 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * _e277) * select(0.00000011920929f, 1f, _e316)) * _e283);
                    let _e331 = global_4.member[_e152].member_2;
                    if _e305 {
                        phi_556_ = _e331[0];
                    } else {
                        phi_556_ = _e331[1];
                    }
                    let _e335 = phi_556_;
                    if _e310 {
                        phi_562_ = _e331[2];
                    } else {
                        phi_562_ = _e335;
                    }
                    let _e338 = phi_562_;
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
                        phi_635_ = _e304[0];
                    } else {
                        phi_635_ = _e304[1];
                    }
                    let _e376 = phi_635_;
                    let _e377 = (_e265 == 2u);
                    if _e377 {
                        phi_641_ = _e304[2];
                    } else {
                        phi_641_ = _e376;
                    }
                    let _e380 = phi_641_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e277) * select(0.00000011920929f, 1f, _e383)) * _e283);
                    if _e372 {
                        phi_681_ = _e331[0];
                    } else {
                        phi_681_ = _e331[1];
                    }
                    let _e401 = phi_681_;
                    if _e377 {
                        phi_687_ = _e331[2];
                    } else {
                        phi_687_ = _e401;
                    }
                    let _e404 = phi_687_;
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
                        phi_760_ = _e304[0];
                    } else {
                        phi_760_ = _e304[1];
                    }
                    let _e442 = phi_760_;
                    let _e443 = (_e267 == 2u);
                    if _e443 {
                        phi_766_ = _e304[2];
                    } else {
                        phi_766_ = _e442;
                    }
                    let _e446 = phi_766_;
                    let _e447 = bitcast<u32>(_e446);
                    let _e449 = ((_e447 & 2139095040u) != 0u);
                    let _e463 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e447 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e447 & 2147483648u))), _e446, _e449) * _e277) * select(0.00000011920929f, 1f, _e449)) * _e283);
                    if _e438 {
                        phi_806_ = _e331[0];
                    } else {
                        phi_806_ = _e331[1];
                    }
                    let _e467 = phi_806_;
                    if _e443 {
                        phi_812_ = _e331[2];
                    } else {
                        phi_812_ = _e467;
                    }
                    let _e470 = phi_812_;
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
                            phi_931_ = 255i;
                        } else {
                            phi_931_ = (((_e521 + select(0i, 1i, (_e521 == 0i))) - _e528) + _e508);
                        }
                        let _e536 = phi_931_;
                        let _e546 = (_e536 <= 0i);
                        if _e546 {
                            phi_954_ = u32();
                        } else {
                            if _e525 {
                                phi_953_ = u32();
                            } else {
                                phi_953_ = select(((bitcast<u32>(_e536) << bitcast<u32>(23i)) | ((_e518 << bitcast<u32>(((_e528 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e536 >= 255i));
                            }
                            let _e550 = phi_953_;
                            phi_954_ = _e550;
                        }
                        let _e552 = phi_954_;
                        let _e564 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e567 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                        let _e571 = (_e564 == 0u);
                        let _e574 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e564)), 32u, _e571)) - 8i);
                        if (_e567 == 255i) {
                            phi_991_ = 255i;
                        } else {
                            phi_991_ = (((_e567 + select(0i, 1i, (_e567 == 0i))) - _e574) + _e508);
                        }
                        let _e582 = phi_991_;
                        let _e592 = (_e582 <= 0i);
                        if _e592 {
                            phi_1014_ = u32();
                        } else {
                            if _e571 {
                                phi_1013_ = u32();
                            } else {
                                phi_1013_ = select(((bitcast<u32>(_e582) << bitcast<u32>(23i)) | ((_e564 << bitcast<u32>(((_e574 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e582 >= 255i));
                            }
                            let _e596 = phi_1013_;
                            phi_1014_ = _e596;
                        }
                        let _e598 = phi_1014_;
                        phi_1022_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e598, 0u, select(_e571, true, _e592))));
                        phi_1023_ = bitcast<f32>(((_e214 & 2147483648u) | select(_e552, 0u, select(_e525, true, _e546))));
                    } else {
                        phi_1022_ = 0f;
                        phi_1023_ = 1f;
                    }
                    let _e604 = phi_1022_;
                    let _e606 = phi_1023_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e613 = (_e266 % 3u);
                    let _e614 = (_e613 < 3u);
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e616 = local_1[_e613];
                    let _e619 = (_e265 % 3u);
                    let _e620 = (_e619 < 3u);
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e622 = local_1[_e619];
                    let _e625 = (_e267 % 3u);
                    let _e626 = (_e625 < 3u);
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e628 = local_1[_e625];
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e633 = local[_e613];
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e637 = local[_e619];
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e641 = local[_e625];
                    phi_4459_ = false;
                    phi_1120_ = type_44(type_37(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e604), 0u, 0u);
                    phi_1123_ = (_e606 <= _e604);
                    phi_1125_ = type_51(type_32(vec4<f32>((f32(_e616) * _e146), (f32(_e622) * _e146), (f32(_e628) * _e146), 0f), vec4<f32>((f32(_e633) * _e146), (f32(_e637) * _e146), (f32(_e641) * _e146), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                    phi_1127_ = 0u;
                    phi_1129_ = ((3u * _e95) + 1u);
                    loop {
                        let _e649 = phi_4459_;
                        let _e651 = phi_1120_;
                        let _e653 = phi_1123_;
                        let _e655 = phi_1125_;
                        let _e657 = phi_1127_;
                        let _e659 = phi_1129_;
                        local_11 = _e651;
                        local_12 = _e651;
                        if _e653 {
                            phi_1140_ = true;
                        } else {
                            phi_1140_ = (_e657 > 0u);
                        }
                        let _e662 = phi_1140_;
                        if _e662 {
                            let _e663 = (_e659 > 0u);
                            if _e663 {
                                if _e653 {
                                    phi_1226_ = _e653;
                                    phi_1227_ = _e655;
                                    phi_1228_ = _e657;
                                } else {
                                    let _e664 = (_e657 - 1u);
                                    let _e665 = (_e664 % 128u);
                                    let _e666 = (_e665 < 128u);
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e668 = local_7[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e670 = local_6[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e672 = local_5[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e674 = local_4[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e676 = local_3[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e678 = local_2[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e683 = local_8[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e686 = local_9[_e665];
                                    phi_1226_ = (_e686 <= _e651.member.member_1);
                                    phi_1227_ = type_51(type_32(vec4<f32>(_e668, _e670, _e672, 0f), vec4<f32>(_e674, _e676, _e678, 0f)), _e683);
                                    phi_1228_ = _e664;
                                }
                                let _e691 = phi_1226_;
                                let _e693 = phi_1227_;
                                let _e695 = phi_1228_;
                                if _e691 {
                                    let _e700 = (_e693.member_1 & 268435455u);
                                    if ((_e693.member_1 & 2147483648u) != 0u) {
                                        phi_1247_ = _e651;
                                        phi_1250_ = type_8(0u, ((_e693.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1172 = phi_1247_;
                                            let _e1174 = phi_1250_;
                                            local_10 = _e1172;
                                            local_13 = _e1172;
                                            if (_e1174.member < _e1174.member_1) {
                                                phi_1251_ = type_8((_e1174.member + 1u), _e1174.member_1);
                                                phi_1273_ = type_8(1u, _e1174.member);
                                            } else {
                                                phi_1251_ = _e1174;
                                                phi_1273_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1187 = phi_1251_;
                                            let _e1189 = phi_1273_;
                                            let _e1193 = (bitcast<i32>(_e1189.member) != 0i);
                                            if _e1193 {
                                                let _e1199 = type_44(_e1172.member, _e1172.member_1, (_e1172.member_2 + 1u));
                                                let _e1204 = (_e693.member.member_1.x - _e693.member.member.x);
                                                let _e1207 = (_e693.member.member_1.y - _e693.member.member.y);
                                                let _e1210 = (_e693.member.member_1.z - _e693.member.member.z);
                                                let _e1212 = select(_e1207, _e1204, (_e1204 > _e1207));
                                                let _e1214 = select(_e1210, _e1212, (_e1212 > _e1210));
                                                let _e1216 = (_e1214 < (1024f * _e146));
                                                if _e1216 {
                                                    phi_1317_ = 0u;
                                                } else {
                                                    phi_1317_ = select(2u, 1u, (_e1214 < (2097152f * _e146)));
                                                }
                                                let _e1221 = phi_1317_;
                                                switch bitcast<i32>(_e1221) {
                                                    case 0: {
                                                        phi_1323_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1323_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1323_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1323_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1224 = phi_1323_;
                                                switch bitcast<i32>(_e1221) {
                                                    case 0: {
                                                        phi_1333_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1333_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1333_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1333_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1231 = phi_1333_;
                                                let _e1233 = ((_e700 + (_e1189.member_1 * ((3u * _e1224) + 1u))) + (3u * _e1231));
                                                let _e1234 = (_e1233 < _e98);
                                                if _e1234 {
                                                    if _e1234 {
                                                    } else {
                                                        phi_4453_ = true;
                                                        break;
                                                    }
                                                    let _e1236 = global_5.member[_e1233];
                                                    phi_1349_ = _e1236;
                                                } else {
                                                    phi_1349_ = 4294967295u;
                                                }
                                                let _e1238 = phi_1349_;
                                                if _e1216 {
                                                    phi_1382_ = 0u;
                                                } else {
                                                    phi_1382_ = select(2u, 1u, (_e1214 < (2097152f * _e146)));
                                                }
                                                let _e1243 = phi_1382_;
                                                switch bitcast<i32>(_e1243) {
                                                    case 0: {
                                                        phi_1388_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1388_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1388_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1388_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1246 = phi_1388_;
                                                let _e1250 = (_e700 + (_e1189.member_1 * ((3u * _e1246) + 1u)));
                                                switch bitcast<i32>(_e1243) {
                                                    case 0: {
                                                        let _e1525 = (_e1250 < _e98);
                                                        if _e1525 {
                                                            if _e1525 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1527 = global_5.member[_e1250];
                                                            phi_1415_ = _e1527;
                                                        } else {
                                                            phi_1415_ = 0u;
                                                        }
                                                        let _e1529 = phi_1415_;
                                                        let _e1531 = ((10u * _e266) & 31u);
                                                        let _e1541 = ((10u * _e265) & 31u);
                                                        let _e1551 = ((10u * _e267) & 31u);
                                                        let _e1561 = (_e1250 + 1u);
                                                        let _e1562 = (_e1561 < _e98);
                                                        if _e1562 {
                                                            if _e1562 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1564 = global_5.member[_e1561];
                                                            phi_1464_ = _e1564;
                                                        } else {
                                                            phi_1464_ = 0u;
                                                        }
                                                        let _e1566 = phi_1464_;
                                                        let _e1592 = (_e1250 + 2u);
                                                        let _e1593 = (_e1592 < _e98);
                                                        if _e1593 {
                                                            if _e1593 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1595 = global_5.member[_e1592];
                                                            phi_1513_ = _e1595;
                                                        } else {
                                                            phi_1513_ = 0u;
                                                        }
                                                        let _e1597 = phi_1513_;
                                                        phi_2014_ = array<array<f32, 3>, 3>(array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | ((_e1529 >> bitcast<u32>(_e1531)) & 1023u))) - 8388608f) * _e146)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | ((_e1529 >> bitcast<u32>(_e1541)) & 1023u))) - 8388608f) * _e146)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | ((_e1529 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e146))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | ((_e1566 >> bitcast<u32>(_e1531)) & 1023u))) - 8388608f) * _e146)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | ((_e1566 >> bitcast<u32>(_e1541)) & 1023u))) - 8388608f) * _e146)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | ((_e1566 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e146))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | ((_e1597 >> bitcast<u32>(_e1531)) & 1023u))) - 8388608f) * _e146)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | ((_e1597 >> bitcast<u32>(_e1541)) & 1023u))) - 8388608f) * _e146)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | ((_e1597 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e146))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1339 = (_e1250 < _e98);
                                                        if _e1339 {
                                                            if _e1339 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1341 = global_5.member[_e1250];
                                                            phi_1562_ = _e1341;
                                                        } else {
                                                            phi_1562_ = 0u;
                                                        }
                                                        let _e1343 = phi_1562_;
                                                        let _e1344 = (_e1250 + 1u);
                                                        let _e1345 = (_e1344 < _e98);
                                                        if _e1345 {
                                                            if _e1345 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1347 = global_5.member[_e1344];
                                                            phi_1577_ = _e1347;
                                                        } else {
                                                            phi_1577_ = 0u;
                                                        }
                                                        let _e1349 = phi_1577_;
                                                        let _e1350 = (_e266 == 1u);
                                                        if _e1350 {
                                                            phi_1587_ = ((_e1343 >> bitcast<u32>(21i)) | (_e1349 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1587_ = (_e1349 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1359 = phi_1587_;
                                                        let _e1367 = (_e265 == 1u);
                                                        if _e1367 {
                                                            phi_1608_ = ((_e1343 >> bitcast<u32>(21i)) | (_e1349 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1608_ = (_e1349 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1376 = phi_1608_;
                                                        let _e1384 = (_e267 == 1u);
                                                        if _e1384 {
                                                            phi_1629_ = ((_e1343 >> bitcast<u32>(21i)) | (_e1349 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1629_ = (_e1349 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1393 = phi_1629_;
                                                        let _e1402 = (_e1250 + 2u);
                                                        let _e1403 = (_e1402 < _e98);
                                                        if _e1403 {
                                                            if _e1403 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1405 = global_5.member[_e1402];
                                                            phi_1659_ = _e1405;
                                                        } else {
                                                            phi_1659_ = 0u;
                                                        }
                                                        let _e1407 = phi_1659_;
                                                        let _e1408 = (_e1250 + 3u);
                                                        let _e1409 = (_e1408 < _e98);
                                                        if _e1409 {
                                                            if _e1409 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1411 = global_5.member[_e1408];
                                                            phi_1674_ = _e1411;
                                                        } else {
                                                            phi_1674_ = 0u;
                                                        }
                                                        let _e1413 = phi_1674_;
                                                        if _e1350 {
                                                            phi_1684_ = ((_e1407 >> bitcast<u32>(21i)) | (_e1413 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1684_ = (_e1413 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1422 = phi_1684_;
                                                        if _e1367 {
                                                            phi_1705_ = ((_e1407 >> bitcast<u32>(21i)) | (_e1413 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1705_ = (_e1413 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1438 = phi_1705_;
                                                        if _e1384 {
                                                            phi_1726_ = ((_e1407 >> bitcast<u32>(21i)) | (_e1413 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1726_ = (_e1413 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1454 = phi_1726_;
                                                        let _e1463 = (_e1250 + 4u);
                                                        let _e1464 = (_e1463 < _e98);
                                                        if _e1464 {
                                                            if _e1464 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1466 = global_5.member[_e1463];
                                                            phi_1756_ = _e1466;
                                                        } else {
                                                            phi_1756_ = 0u;
                                                        }
                                                        let _e1468 = phi_1756_;
                                                        let _e1469 = (_e1250 + 5u);
                                                        let _e1470 = (_e1469 < _e98);
                                                        if _e1470 {
                                                            if _e1470 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1472 = global_5.member[_e1469];
                                                            phi_1771_ = _e1472;
                                                        } else {
                                                            phi_1771_ = 0u;
                                                        }
                                                        let _e1474 = phi_1771_;
                                                        if _e1350 {
                                                            phi_1781_ = ((_e1468 >> bitcast<u32>(21i)) | (_e1474 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1781_ = (_e1474 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1483 = phi_1781_;
                                                        if _e1367 {
                                                            phi_1802_ = ((_e1468 >> bitcast<u32>(21i)) | (_e1474 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1802_ = (_e1474 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1499 = phi_1802_;
                                                        if _e1384 {
                                                            phi_1823_ = ((_e1468 >> bitcast<u32>(21i)) | (_e1474 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1823_ = (_e1474 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1515 = phi_1823_;
                                                        phi_2014_ = array<array<f32, 3>, 3>(array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1359, _e1343, _e305) & 2097151u))) - 8388608f) * _e146)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1376, _e1343, _e372) & 2097151u))) - 8388608f) * _e146)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1393, _e1343, _e438) & 2097151u))) - 8388608f) * _e146))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1422, _e1407, _e305) & 2097151u))) - 8388608f) * _e146)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1438, _e1407, _e372) & 2097151u))) - 8388608f) * _e146)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1454, _e1407, _e438) & 2097151u))) - 8388608f) * _e146))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1483, _e1468, _e305) & 2097151u))) - 8388608f) * _e146)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1499, _e1468, _e372) & 2097151u))) - 8388608f) * _e146)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1515, _e1468, _e438) & 2097151u))) - 8388608f) * _e146))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1252 = (_e1250 + _e266);
                                                        let _e1253 = (_e1252 < _e98);
                                                        if _e1253 {
                                                            if _e1253 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1255 = global_5.member[_e1252];
                                                            phi_1854_ = _e1255;
                                                        } else {
                                                            phi_1854_ = 0u;
                                                        }
                                                        let _e1257 = phi_1854_;
                                                        let _e1261 = (_e1250 + _e265);
                                                        let _e1262 = (_e1261 < _e98);
                                                        if _e1262 {
                                                            if _e1262 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1264 = global_5.member[_e1261];
                                                            phi_1872_ = _e1264;
                                                        } else {
                                                            phi_1872_ = 0u;
                                                        }
                                                        let _e1266 = phi_1872_;
                                                        let _e1270 = (_e1250 + _e267);
                                                        let _e1271 = (_e1270 < _e98);
                                                        if _e1271 {
                                                            if _e1271 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1273 = global_5.member[_e1270];
                                                            phi_1890_ = _e1273;
                                                        } else {
                                                            phi_1890_ = 0u;
                                                        }
                                                        let _e1275 = phi_1890_;
                                                        let _e1280 = (_e1250 + 3u);
                                                        let _e1281 = (_e1280 + _e266);
                                                        let _e1282 = (_e1281 < _e98);
                                                        if _e1282 {
                                                            if _e1282 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1284 = global_5.member[_e1281];
                                                            phi_1913_ = _e1284;
                                                        } else {
                                                            phi_1913_ = 0u;
                                                        }
                                                        let _e1286 = phi_1913_;
                                                        let _e1290 = (_e1280 + _e265);
                                                        let _e1291 = (_e1290 < _e98);
                                                        if _e1291 {
                                                            if _e1291 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1293 = global_5.member[_e1290];
                                                            phi_1931_ = _e1293;
                                                        } else {
                                                            phi_1931_ = 0u;
                                                        }
                                                        let _e1295 = phi_1931_;
                                                        let _e1299 = (_e1280 + _e267);
                                                        let _e1300 = (_e1299 < _e98);
                                                        if _e1300 {
                                                            if _e1300 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1302 = global_5.member[_e1299];
                                                            phi_1949_ = _e1302;
                                                        } else {
                                                            phi_1949_ = 0u;
                                                        }
                                                        let _e1304 = phi_1949_;
                                                        let _e1309 = (_e1250 + 6u);
                                                        let _e1310 = (_e1309 + _e266);
                                                        let _e1311 = (_e1310 < _e98);
                                                        if _e1311 {
                                                            if _e1311 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1313 = global_5.member[_e1310];
                                                            phi_1972_ = _e1313;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e1315 = phi_1972_;
                                                        let _e1319 = (_e1309 + _e265);
                                                        let _e1320 = (_e1319 < _e98);
                                                        if _e1320 {
                                                            if _e1320 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1322 = global_5.member[_e1319];
                                                            phi_1990_ = _e1322;
                                                        } else {
                                                            phi_1990_ = 0u;
                                                        }
                                                        let _e1324 = phi_1990_;
                                                        let _e1328 = (_e1309 + _e267);
                                                        let _e1329 = (_e1328 < _e98);
                                                        if _e1329 {
                                                            if _e1329 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1331 = global_5.member[_e1328];
                                                            phi_2008_ = _e1331;
                                                        } else {
                                                            phi_2008_ = 0u;
                                                        }
                                                        let _e1333 = phi_2008_;
                                                        phi_2014_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1257)) * _e146), (f32(bitcast<i32>(_e1266)) * _e146), (f32(bitcast<i32>(_e1275)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e1286)) * _e146), (f32(bitcast<i32>(_e1295)) * _e146), (f32(bitcast<i32>(_e1304)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e1315)) * _e146), (f32(bitcast<i32>(_e1324)) * _e146), (f32(bitcast<i32>(_e1333)) * _e146)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2014_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1625 = phi_2014_;
                                                let _e1642 = (_e1625[0][2] - _e463);
                                                let _e1645 = (((_e1625[0][0] - _e330) * _e499) - (_e1642 * _e367));
                                                let _e1648 = (((_e1625[0][1] - _e397) * _e499) - (_e1642 * _e433));
                                                let _e1651 = (_e1625[1][2] - _e463);
                                                let _e1654 = (((_e1625[1][0] - _e330) * _e499) - (_e1651 * _e367));
                                                let _e1657 = (((_e1625[1][1] - _e397) * _e499) - (_e1651 * _e433));
                                                let _e1660 = (_e1625[2][2] - _e463);
                                                let _e1663 = (((_e1625[2][0] - _e330) * _e499) - (_e1660 * _e367));
                                                let _e1666 = (((_e1625[2][1] - _e397) * _e499) - (_e1660 * _e433));
                                                let _e1667 = (_e1663 * _e1657);
                                                let _e1668 = (_e1666 * _e1654);
                                                let _e1669 = (_e1645 * _e1666);
                                                let _e1670 = (_e1648 * _e1663);
                                                let _e1671 = (_e1654 * _e1648);
                                                let _e1672 = (_e1657 * _e1645);
                                                let _e1677 = (((_e1667 >= _e1668) && (_e1669 >= _e1670)) && (_e1671 >= _e1672));
                                                let _e1683 = (_e1677 || (((_e1667 <= _e1668) && (_e1669 <= _e1670)) && (_e1671 <= _e1672)));
                                                if _e1683 {
                                                    let _e1685 = select(-1f, 1f, _e1677);
                                                    let _e1687 = ((_e1667 - _e1668) * _e1685);
                                                    let _e1689 = select(0f, _e1687, (_e1687 > 0f));
                                                    let _e1691 = ((_e1669 - _e1670) * _e1685);
                                                    let _e1693 = select(0f, _e1691, (_e1691 > 0f));
                                                    let _e1695 = ((_e1671 - _e1672) * _e1685);
                                                    let _e1697 = select(0f, _e1695, (_e1695 > 0f));
                                                    let _e1699 = ((_e1689 + _e1693) + _e1697);
                                                    let _e1701 = select(_e1625[1][0], _e1625[0][0], (_e1625[0][0] < _e1625[1][0]));
                                                    let _e1705 = select(_e1625[1][0], _e1625[0][0], (_e1625[0][0] > _e1625[1][0]));
                                                    let _e1709 = select(_e1625[1][1], _e1625[0][1], (_e1625[0][1] < _e1625[1][1]));
                                                    let _e1713 = select(_e1625[1][1], _e1625[0][1], (_e1625[0][1] > _e1625[1][1]));
                                                    let _e1717 = select(_e1625[1][2], _e1625[0][2], (_e1625[0][2] < _e1625[1][2]));
                                                    let _e1721 = select(_e1625[1][2], _e1625[0][2], (_e1625[0][2] > _e1625[1][2]));
                                                    let _e1726 = ((select(_e1625[2][0], _e1701, (_e1701 < _e1625[2][0])) - _e368) * _e371);
                                                    let _e1727 = ((select(_e1625[2][0], _e1705, (_e1705 > _e1625[2][0])) - _e369) * _e371);
                                                    let _e1730 = ((select(_e1625[2][1], _e1709, (_e1709 < _e1625[2][1])) - _e434) * _e437);
                                                    let _e1731 = ((select(_e1625[2][1], _e1713, (_e1713 > _e1625[2][1])) - _e435) * _e437);
                                                    let _e1734 = ((select(_e1625[2][2], _e1717, (_e1717 < _e1625[2][2])) - _e500) * _e503);
                                                    let _e1735 = ((select(_e1625[2][2], _e1721, (_e1721 > _e1625[2][2])) - _e501) * _e503);
                                                    let _e1737 = select(_e1735, _e1734, (_e1734 < _e1735));
                                                    let _e1739 = select(_e1735, _e1734, (_e1734 > _e1735));
                                                    let _e1741 = select(_e1727, _e1726, (_e1726 < _e1727));
                                                    let _e1743 = select(_e1731, _e1730, (_e1730 < _e1731));
                                                    let _e1745 = select(_e1743, _e1741, (_e1741 > _e1743));
                                                    let _e1747 = select(_e1737, _e1745, (_e1745 > _e1737));
                                                    let _e1749 = select(_e1727, _e1726, (_e1726 > _e1727));
                                                    let _e1751 = select(_e1731, _e1730, (_e1730 > _e1731));
                                                    let _e1753 = select(_e1751, _e1749, (_e1749 < _e1751));
                                                    let _e1755 = select(_e1739, _e1753, (_e1753 < _e1739));
                                                    let _e1756 = -(_e1737);
                                                    let _e1762 = select(_e606, _e1747, (_e1747 > _e606));
                                                    let _e1766 = select(_e1654, _e1645, (_e1645 < _e1654));
                                                    let _e1771 = select(_e1654, _e1645, (_e1645 > _e1654));
                                                    let _e1778 = select(_e1657, _e1648, (_e1648 < _e1657));
                                                    let _e1783 = select(_e1657, _e1648, (_e1648 > _e1657));
                                                    let _e1792 = (((((_e1683 && (_e1699 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1663, _e1766, (_e1766 < _e1663)) <= 0f) && (select(_e1663, _e1771, (_e1771 > _e1663)) >= 0f))) && ((select(_e1666, _e1778, (_e1778 < _e1666)) <= 0f) && (select(_e1666, _e1783, (_e1783 > _e1666)) >= 0f))) && (_e1762 <= (_e1755 + (select(_e1756, _e1739, (_e1739 > _e1756)) * 0.0000019073523f)))) && (_e1762 <= _e1172.member.member_1));
                                                    if _e1792 {
                                                        let _e1797 = (_e1625[1][0] - _e1625[0][0]);
                                                        let _e1798 = (_e1625[1][1] - _e1625[0][1]);
                                                        let _e1799 = (_e1625[1][2] - _e1625[0][2]);
                                                        let _e1800 = vec3<f32>(_e1797, _e1798, _e1799);
                                                        let _e1801 = (_e1625[2][0] - _e1625[1][0]);
                                                        let _e1802 = (_e1625[2][1] - _e1625[1][1]);
                                                        let _e1803 = (_e1625[2][2] - _e1625[1][2]);
                                                        let _e1804 = vec3<f32>(_e1801, _e1802, _e1803);
                                                        let _e1805 = (_e1625[0][0] - _e1625[2][0]);
                                                        let _e1806 = (_e1625[0][1] - _e1625[2][1]);
                                                        let _e1807 = (_e1625[0][2] - _e1625[2][2]);
                                                        let _e1808 = vec3<f32>(_e1805, _e1806, _e1807);
                                                        let _e1811 = bitcast<f32>((bitcast<u32>(_e1797) & 2147483647u));
                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u));
                                                        let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                        let _e1819 = bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u));
                                                        let _e1821 = select(_e1819, _e1816, (_e1816 > _e1819));
                                                        let _e1824 = bitcast<f32>((bitcast<u32>(_e1801) & 2147483647u));
                                                        let _e1827 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                        let _e1829 = select(_e1827, _e1824, (_e1824 > _e1827));
                                                        let _e1832 = bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u));
                                                        let _e1834 = select(_e1832, _e1829, (_e1829 > _e1832));
                                                        let _e1837 = bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u));
                                                        let _e1840 = bitcast<f32>((bitcast<u32>(_e1806) & 2147483647u));
                                                        let _e1842 = select(_e1840, _e1837, (_e1837 > _e1840));
                                                        let _e1845 = bitcast<f32>((bitcast<u32>(_e1807) & 2147483647u));
                                                        let _e1847 = select(_e1845, _e1842, (_e1842 > _e1845));
                                                        let _e1849 = select(_e1834, _e1821, (_e1821 > _e1834));
                                                        let _e1851 = select(_e1847, _e1849, (_e1849 > _e1847));
                                                        if (_e1821 == _e1851) {
                                                            phi_2544_ = _e1657;
                                                            phi_2545_ = _e1654;
                                                            phi_2546_ = _e1648;
                                                            phi_2547_ = _e1645;
                                                            phi_2548_ = vec3<f32>(_e1625[0][0], _e1625[0][1], _e1625[0][2]);
                                                            phi_2549_ = _e1808;
                                                            phi_2550_ = _e1804;
                                                            phi_2551_ = _e1800;
                                                        } else {
                                                            let _e1853 = (_e1834 == _e1851);
                                                            let _e1858 = vec3(_e1853);
                                                            phi_2544_ = select(_e1648, _e1666, _e1853);
                                                            phi_2545_ = select(_e1645, _e1663, _e1853);
                                                            phi_2546_ = select(_e1666, _e1657, _e1853);
                                                            phi_2547_ = select(_e1663, _e1654, _e1853);
                                                            phi_2548_ = select(vec3<f32>(_e1625[2][0], _e1625[2][1], _e1625[2][2]), vec3<f32>(_e1625[1][0], _e1625[1][1], _e1625[1][2]), _e1858);
                                                            phi_2549_ = select(_e1804, _e1800, _e1858);
                                                            phi_2550_ = select(_e1800, _e1808, _e1858);
                                                            phi_2551_ = select(_e1808, _e1804, _e1858);
                                                        }
                                                        let _e1864 = phi_2544_;
                                                        let _e1866 = phi_2545_;
                                                        let _e1868 = phi_2546_;
                                                        let _e1870 = phi_2547_;
                                                        let _e1872 = phi_2548_;
                                                        let _e1874 = phi_2549_;
                                                        let _e1876 = phi_2550_;
                                                        let _e1878 = phi_2551_;
                                                        let _e1885 = ((_e1876.y * _e1874.z) - (_e1874.y * _e1876.z));
                                                        let _e1890 = ((_e1876.z * _e1874.x) - (_e1874.z * _e1876.x));
                                                        let _e1893 = ((_e1876.x * _e1874.y) - (_e1874.x * _e1876.y));
                                                        let _e1896 = ((_e1689 >= _e1693) && (_e1689 >= _e1697));
                                                        let _e1897 = (_e1693 >= _e1697);
                                                        let _e1911 = (((_e1885 * (select(select(_e1625[2][0], _e1625[1][0], _e1897), _e1625[0][0], _e1896) - _e330)) + (_e1890 * (select(select(_e1625[2][1], _e1625[1][1], _e1897), _e1625[0][1], _e1896) - _e397))) + (_e1893 * (select(select(_e1625[2][2], _e1625[1][2], _e1897), _e1625[0][2], _e1896) - _e463)));
                                                        let _e1916 = (((_e1885 * _e367) + (_e1890 * _e433)) + (_e1893 * _e499));
                                                        let _e1917 = (_e1866 - _e1870);
                                                        let _e1918 = (_e1864 - _e1868);
                                                        let _e1921 = ((_e1917 * _e1917) + (_e1918 * _e1918));
                                                        let _e1928 = (-(((_e1870 * _e1917) + (_e1868 * _e1918))) / select(0.000000000000000000000000000000000000011754944f, _e1921, (_e1921 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1930 = select(1f, _e1928, (_e1928 < 1f));
                                                        let _e1932 = select(0f, _e1930, (_e1930 > 0f));
                                                        let _e1941 = ((_e1872.x + (_e1878.x * _e1932)) - _e330);
                                                        let _e1944 = ((_e1872.y + (_e1878.y * _e1932)) - _e397);
                                                        let _e1947 = ((_e1872.z + (_e1878.z * _e1932)) - _e463);
                                                        let _e1950 = bitcast<f32>((bitcast<u32>(_e1941) & 2147483647u));
                                                        let _e1953 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                        let _e1955 = select(_e1953, _e1950, (_e1950 > _e1953));
                                                        let _e1958 = bitcast<f32>((bitcast<u32>(_e1947) & 2147483647u));
                                                        let _e1960 = select(_e1958, _e1955, (_e1955 > _e1958));
                                                        let _e1966 = bitcast<f32>((bitcast<u32>(_e1885) & 2147483647u));
                                                        let _e1969 = bitcast<f32>((bitcast<u32>(_e1890) & 2147483647u));
                                                        let _e1971 = select(_e1969, _e1966, (_e1966 > _e1969));
                                                        let _e1974 = bitcast<f32>((bitcast<u32>(_e1893) & 2147483647u));
                                                        let _e1993 = bitcast<f32>((bitcast<u32>(_e1876.x) & 2147483647u));
                                                        let _e1996 = bitcast<f32>((bitcast<u32>(_e1876.y) & 2147483647u));
                                                        let _e1998 = select(_e1996, _e1993, (_e1993 > _e1996));
                                                        let _e2001 = bitcast<f32>((bitcast<u32>(_e1876.z) & 2147483647u));
                                                        let _e2007 = bitcast<f32>((bitcast<u32>(_e1874.x) & 2147483647u));
                                                        let _e2010 = bitcast<f32>((bitcast<u32>(_e1874.y) & 2147483647u));
                                                        let _e2012 = select(_e2010, _e2007, (_e2007 > _e2010));
                                                        let _e2015 = bitcast<f32>((bitcast<u32>(_e1874.z) & 2147483647u));
                                                        let _e2021 = ((bitcast<f32>((bitcast<u32>(((((_e1885 * _e1941) + (_e1890 * _e1944)) + (_e1893 * _e1947)) - _e1911)) & 2147483647u)) <= ((0.0000009536743f * select(_e1851, _e1960, (_e1960 > _e1851))) * select(_e1974, _e1971, (_e1971 > _e1974)))) && !((bitcast<f32>((bitcast<u32>(_e1916) & 2147483647u)) <= ((0.0000038146973f * select(_e2001, _e1998, (_e1998 > _e2001))) * select(_e2015, _e2012, (_e2012 > _e2015))))));
                                                        let _e2022 = (_e1911 / _e1916);
                                                        if (_e1792 && !(_e2021)) {
                                                            let _e2025 = (_e1947 / _e499);
                                                            let _e2033 = (((_e1885 * (_e1941 - (_e367 * _e2025))) + (_e1890 * (_e1944 - (_e433 * _e2025)))) / _e1916);
                                                            phi_2742_ = select(select(_e2025, (_e2025 + _e2033), (bitcast<f32>((bitcast<u32>(_e2033) & 2147483647u)) <= _e1851)), _e2022, _e2021);
                                                        } else {
                                                            phi_2742_ = _e2022;
                                                        }
                                                        let _e2042 = phi_2742_;
                                                        let _e2044 = select(_e1755, _e2042, (_e2042 < _e1755));
                                                        let _e2046 = select(_e1747, _e2044, (_e2044 > _e1747));
                                                        let _e2047 = (1f / _e1699);
                                                        phi_2762_ = type_40(_e2046, (_e1693 * _e2047), (_e1697 * _e2047), ((_e1792 && (_e2046 >= _e606)) && (_e2046 <= _e1172.member.member_1)));
                                                        phi_2763_ = type_40();
                                                    } else {
                                                        phi_2762_ = type_40();
                                                        phi_2763_ = type_40(0f, 0f, 0f, _e1792);
                                                    }
                                                    let _e2056 = phi_2762_;
                                                    let _e2058 = phi_2763_;
                                                    phi_2766_ = _e2056;
                                                    phi_2767_ = _e2058;
                                                    phi_2768_ = select(true, false, _e1792);
                                                } else {
                                                    phi_2766_ = type_40();
                                                    phi_2767_ = type_40(0f, 0f, 0f, _e1683);
                                                    phi_2768_ = true;
                                                }
                                                let _e2061 = phi_2766_;
                                                let _e2063 = phi_2767_;
                                                let _e2065 = phi_2768_;
                                                if _e2065 {
                                                    phi_2772_ = _e2063;
                                                } else {
                                                    phi_2772_ = _e2061;
                                                }
                                                let _e2067 = phi_2772_;
                                                if _e2067.member_3 {
                                                    phi_2781_ = type_28(_e2067.member, _e2067.member_1, _e2067.member_2, _e1238);
                                                } else {
                                                    phi_2781_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2074 = phi_2781_;
                                                if (_e2074.member_3 != 4294967295u) {
                                                    if (_e1238 != 4294967295u) {
                                                        if (_e2074.member < _e1172.member.member.member) {
                                                            phi_2807_ = true;
                                                        } else {
                                                            if (_e2074.member == _e1172.member.member.member) {
                                                                phi_2806_ = (_e2074.member_3 < _e1172.member.member.member_3);
                                                            } else {
                                                                phi_2806_ = false;
                                                            }
                                                            let _e2089 = phi_2806_;
                                                            phi_2807_ = _e2089;
                                                        }
                                                        let _e2091 = phi_2807_;
                                                        if _e2091 {
                                                            phi_2814_ = type_44(type_37(_e2074, _e2074.member), _e1199.member_1, _e1199.member_2);
                                                        } else {
                                                            phi_2814_ = _e1199;
                                                        }
                                                        let _e2098 = phi_2814_;
                                                        phi_2815_ = _e2098;
                                                    } else {
                                                        phi_2815_ = _e1199;
                                                    }
                                                    let _e2100 = phi_2815_;
                                                    phi_2816_ = _e2100;
                                                } else {
                                                    phi_2816_ = _e1199;
                                                }
                                                let _e2102 = phi_2816_;
                                                phi_1248_ = _e2102;
                                            } else {
                                                phi_1248_ = type_44();
                                            }
                                            let _e2104 = phi_1248_;
                                            continue;
                                            continuing {
                                                phi_1247_ = _e2104;
                                                phi_1250_ = _e1187;
                                                phi_4453_ = _e649;
                                                break if !(_e1193);
                                            }
                                        }
                                        let _e2107 = phi_4453_;
                                        phi_4653_ = _e2107;
                                        if _e2107 {
                                            break;
                                        }
                                        let _e2109 = local_10;
                                        phi_4657_ = _e2107;
                                        let _e2301 = local_13;
                                        phi_4081_ = _e2301;
                                        phi_4082_ = false;
                                        phi_4083_ = _e693;
                                        phi_4084_ = select(_e695, 0u, (_e606 > _e2109.member.member_1));
                                    } else {
                                        if (_e693.member_1 >= _e95) {
                                            phi_3617_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e693.member_1 < _e95) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e708 = ((1u + _e266) % 4u);
                                            if (_e708 < 4u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e713 = global_3.member[_e693.member_1][_e708];
                                            let _e715 = (_e713 >> bitcast<u32>(11u));
                                            let _e717 = ((1u + _e265) % 4u);
                                            if (_e717 < 4u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e722 = global_3.member[_e693.member_1][_e717];
                                            let _e724 = (_e722 >> bitcast<u32>(11u));
                                            let _e726 = ((1u + _e267) % 4u);
                                            if (_e726 < 4u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e731 = global_3.member[_e693.member_1][_e726];
                                            let _e733 = (_e731 >> bitcast<u32>(11u));
                                            let _e756 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.x - _e693.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e757 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.y - _e693.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e758 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.z - _e693.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e760 = select(_e146, _e756, (_e756 > _e146));
                                            let _e762 = select(_e146, _e757, (_e757 > _e146));
                                            let _e764 = select(_e146, _e758, (_e758 > _e146));
                                            let _e795 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e713 & 1023u))) - 8388608f) * _e760));
                                            let _e800 = (bitcast<i32>((_e713 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e803 = bitcast<f32>((_e795 & bitcast<u32>(_e800)));
                                            let _e804 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e722 & 1023u))) - 8388608f) * _e762));
                                            let _e809 = (bitcast<i32>((_e722 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e812 = bitcast<f32>((_e804 & bitcast<u32>(_e809)));
                                            let _e813 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e731 & 1023u))) - 8388608f) * _e764));
                                            let _e818 = (bitcast<i32>((_e731 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e821 = bitcast<f32>((_e813 & bitcast<u32>(_e818)));
                                            let _e825 = bitcast<f32>((_e795 & bitcast<u32>(~(_e800))));
                                            let _e829 = bitcast<f32>((_e804 & bitcast<u32>(~(_e809))));
                                            let _e833 = bitcast<f32>((_e813 & bitcast<u32>(~(_e818))));
                                            let _e834 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e715 & 1023u))) - 8388608f) * _e760));
                                            let _e839 = (bitcast<i32>((_e715 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e842 = bitcast<f32>((_e834 & bitcast<u32>(_e839)));
                                            let _e843 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e724 & 1023u))) - 8388608f) * _e762));
                                            let _e848 = (bitcast<i32>((_e724 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e851 = bitcast<f32>((_e843 & bitcast<u32>(_e848)));
                                            let _e852 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 1023u))) - 8388608f) * _e764));
                                            let _e857 = (bitcast<i32>((_e733 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e860 = bitcast<f32>((_e852 & bitcast<u32>(_e857)));
                                            let _e864 = bitcast<f32>((_e834 & bitcast<u32>(~(_e839))));
                                            let _e868 = bitcast<f32>((_e843 & bitcast<u32>(~(_e848))));
                                            let _e872 = bitcast<f32>((_e852 & bitcast<u32>(~(_e857))));
                                            let _e873 = (_e693.member.member.x + _e803);
                                            let _e874 = (_e693.member.member.y + _e812);
                                            let _e875 = (_e693.member.member.z + _e821);
                                            let _e878 = (_e693.member.member_1.x - _e842);
                                            let _e879 = (_e693.member.member_1.y - _e851);
                                            let _e880 = (_e693.member.member_1.z - _e860);
                                            let _e899 = (_e878 - _e873);
                                            let _e900 = (_e879 - _e874);
                                            let _e901 = (_e880 - _e875);
                                            let _e903 = select(_e900, _e899, (_e899 > _e900));
                                            let _e905 = select(_e901, _e903, (_e903 > _e901));
                                            if (_e905 < (1024f * _e146)) {
                                                phi_3318_ = 0u;
                                            } else {
                                                phi_3318_ = select(2u, 1u, (_e905 < (2097152f * _e146)));
                                            }
                                            let _e912 = phi_3318_;
                                            switch bitcast<i32>(_e912) {
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
                                            let _e915 = phi_3324_;
                                            let _e921 = global_3.member[_e693.member_1][0u];
                                            let _e925 = global_3.member[_e693.member_1][1u];
                                            let _e929 = global_3.member[_e693.member_1][2u];
                                            let _e933 = global_3.member[_e693.member_1][3u];
                                            let _e945 = (((_e925 >> bitcast<u32>(22i)) | ((_e929 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e933 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e946 = (_e921 & 268435455u);
                                            let _e947 = (_e945 & 268435455u);
                                            let _e950 = ((_e921 >> bitcast<u32>(28u)) & 7u);
                                            let _e958 = ((_e921 >> bitcast<u32>(31i)) | (((_e945 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e959 = (_e950 != 0u);
                                            if (_e950 == 0u) {
                                                phi_3579_ = _e946;
                                            } else {
                                                if (_e950 == 7u) {
                                                    phi_3578_ = 2147483648u;
                                                } else {
                                                    phi_3578_ = ((2147483648u | (_e950 << bitcast<u32>(28u))) | (_e947 & 268435455u));
                                                }
                                                let _e968 = phi_3578_;
                                                phi_3579_ = _e968;
                                            }
                                            let _e970 = phi_3579_;
                                            if _e959 {
                                                let _e971 = (_e950 != 7u);
                                                if _e971 {
                                                    phi_3589_ = (_e947 + (_e950 * ((3u * _e915) + 1u)));
                                                } else {
                                                    phi_3589_ = u32();
                                                }
                                                let _e975 = phi_3589_;
                                                phi_3591_ = _e975;
                                                phi_3592_ = select(true, false, _e971);
                                            } else {
                                                phi_3591_ = u32();
                                                phi_3592_ = true;
                                            }
                                            let _e978 = phi_3591_;
                                            let _e980 = phi_3592_;
                                            if (_e958 == 0u) {
                                                phi_3613_ = (_e946 + select(0u, 1u, !(_e959)));
                                            } else {
                                                if (_e958 == 7u) {
                                                    phi_3612_ = 2147483648u;
                                                } else {
                                                    phi_3612_ = ((2147483648u | (_e958 << bitcast<u32>(28u))) | (select(_e978, _e947, _e980) & 268435455u));
                                                }
                                                let _e993 = phi_3612_;
                                                phi_3613_ = _e993;
                                            }
                                            let _e995 = phi_3613_;
                                            phi_3617_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e873, (_e693.member.member.x + _e825), _e878, (_e693.member.member_1.x - _e864)), vec4<f32>(_e874, (_e693.member.member.y + _e829), _e879, (_e693.member.member_1.y - _e868)), vec4<f32>(_e875, (_e693.member.member.z + _e833), _e880, (_e693.member.member_1.z - _e872))), type_51(type_32((_e693.member.member + vec4<f32>(_e803, _e812, _e821, 0f)), (_e693.member.member_1 - vec4<f32>(_e842, _e851, _e860, 0f))), _e970), type_51(type_32((_e693.member.member + vec4<f32>(_e825, _e829, _e833, 0f)), (_e693.member.member_1 - vec4<f32>(_e864, _e868, _e872, 0f))), _e995));
                                        }
                                        let _e1000 = phi_3617_;
                                        let _e1019 = ((_e1000.member[0].x - _e368) * _e371);
                                        let _e1020 = ((_e1000.member[0].y - _e368) * _e371);
                                        let _e1021 = ((_e1000.member[0].z - _e369) * _e371);
                                        let _e1022 = ((_e1000.member[0].w - _e369) * _e371);
                                        let _e1032 = ((_e1000.member[1].x - _e434) * _e437);
                                        let _e1033 = ((_e1000.member[1].y - _e434) * _e437);
                                        let _e1034 = ((_e1000.member[1].z - _e435) * _e437);
                                        let _e1035 = ((_e1000.member[1].w - _e435) * _e437);
                                        let _e1045 = ((_e1000.member[2].x - _e500) * _e503);
                                        let _e1046 = ((_e1000.member[2].y - _e500) * _e503);
                                        let _e1047 = ((_e1000.member[2].z - _e501) * _e503);
                                        let _e1048 = ((_e1000.member[2].w - _e501) * _e503);
                                        let _e1050 = select(_e1047, _e1045, (_e1045 < _e1047));
                                        let _e1052 = select(_e1048, _e1046, (_e1046 < _e1048));
                                        let _e1054 = select(_e1047, _e1045, (_e1045 > _e1047));
                                        let _e1056 = select(_e1048, _e1046, (_e1046 > _e1048));
                                        let _e1058 = select(_e1021, _e1019, (_e1019 < _e1021));
                                        let _e1060 = select(_e1022, _e1020, (_e1020 < _e1022));
                                        let _e1062 = select(_e1034, _e1032, (_e1032 < _e1034));
                                        let _e1064 = select(_e1035, _e1033, (_e1033 < _e1035));
                                        let _e1066 = select(_e1062, _e1058, (_e1058 > _e1062));
                                        let _e1068 = select(_e1064, _e1060, (_e1060 > _e1064));
                                        let _e1070 = select(_e1050, _e1066, (_e1066 > _e1050));
                                        let _e1072 = select(_e1052, _e1068, (_e1068 > _e1052));
                                        let _e1074 = select(_e1021, _e1019, (_e1019 > _e1021));
                                        let _e1076 = select(_e1022, _e1020, (_e1020 > _e1022));
                                        let _e1078 = select(_e1034, _e1032, (_e1032 > _e1034));
                                        let _e1080 = select(_e1035, _e1033, (_e1033 > _e1035));
                                        let _e1082 = select(_e1078, _e1074, (_e1074 < _e1078));
                                        let _e1084 = select(_e1080, _e1076, (_e1076 < _e1080));
                                        let _e1089 = -(_e1050);
                                        let _e1090 = -(_e1052);
                                        let _e1097 = (select(_e1054, _e1082, (_e1082 < _e1054)) + (select(_e1089, _e1054, (_e1054 > _e1089)) * 0.0000019073523f));
                                        let _e1098 = (select(_e1056, _e1084, (_e1084 < _e1056)) + (select(_e1090, _e1056, (_e1056 > _e1090)) * 0.0000019073523f));
                                        let _e1100 = select(_e606, _e1070, (_e1070 > _e606));
                                        let _e1102 = select(_e606, _e1072, (_e1072 > _e606));
                                        let _e1107 = (_e1100 <= select(_e651.member.member_1, _e1097, (_e1097 < _e651.member.member_1)));
                                        let _e1108 = (_e1102 <= select(_e651.member.member_1, _e1098, (_e1098 < _e651.member.member_1)));
                                        let _e1109 = (_e1100 <= _e1102);
                                        if _e1107 {
                                            if _e1108 {
                                                if _e1109 {
                                                    phi_3982_ = _e1000.member_2;
                                                } else {
                                                    phi_3982_ = _e1000.member_1;
                                                }
                                                let _e1113 = phi_3982_;
                                                let _e1134 = (_e695 % 128u);
                                                let _e1135 = (_e1134 < 128u);
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_8[_e1134] = _e1113.member_1;
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_7[_e1134] = _e1113.member.member.x;
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_6[_e1134] = _e1113.member.member.y;
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_5[_e1134] = _e1113.member.member.z;
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_4[_e1134] = _e1113.member.member_1.x;
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_3[_e1134] = _e1113.member.member_1.y;
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_2[_e1134] = _e1113.member.member_1.z;
                                                if _e1135 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_9[_e1134] = select(_e1100, _e1102, _e1109);
                                                if _e1109 {
                                                    phi_4058_ = _e1000.member_1;
                                                } else {
                                                    phi_4058_ = _e1000.member_2;
                                                }
                                                let _e1148 = phi_4058_;
                                                phi_4059_ = _e1148;
                                                phi_4060_ = (_e695 + 1u);
                                            } else {
                                                phi_4059_ = type_51();
                                                phi_4060_ = u32();
                                            }
                                            let _e1150 = phi_4059_;
                                            let _e1152 = phi_4060_;
                                            phi_4062_ = _e1150;
                                            phi_4063_ = _e1152;
                                            phi_4064_ = select(true, false, _e1108);
                                        } else {
                                            phi_4062_ = type_51();
                                            phi_4063_ = u32();
                                            phi_4064_ = true;
                                        }
                                        let _e1155 = phi_4062_;
                                        let _e1157 = phi_4063_;
                                        let _e1159 = phi_4064_;
                                        if _e1159 {
                                            if _e1107 {
                                                phi_4073_ = _e1000.member_1;
                                            } else {
                                                phi_4073_ = _e1000.member_2;
                                            }
                                            let _e1163 = phi_4073_;
                                            phi_4078_ = select(_e1108, true, _e1107);
                                            phi_4079_ = _e1163;
                                        } else {
                                            phi_4078_ = _e691;
                                            phi_4079_ = _e1155;
                                        }
                                        let _e1166 = phi_4078_;
                                        let _e1168 = phi_4079_;
                                        phi_4657_ = _e649;
                                        phi_4081_ = type_44(_e651.member, (_e651.member_1 + 1u), _e651.member_2);
                                        phi_4082_ = _e1166;
                                        phi_4083_ = _e1168;
                                        phi_4084_ = select(_e1157, _e695, _e1159);
                                    }
                                    let _e2115 = phi_4657_;
                                    let _e2117 = phi_4081_;
                                    let _e2119 = phi_4082_;
                                    let _e2121 = phi_4083_;
                                    let _e2123 = phi_4084_;
                                    phi_4656_ = _e2115;
                                    phi_4085_ = _e2117;
                                    phi_4086_ = _e2119;
                                    phi_4087_ = _e2121;
                                    phi_4088_ = _e2123;
                                    phi_4089_ = (_e659 - 1u);
                                } else {
                                    phi_4656_ = _e649;
                                    phi_4085_ = _e651;
                                    phi_4086_ = _e691;
                                    phi_4087_ = _e693;
                                    phi_4088_ = _e695;
                                    phi_4089_ = _e659;
                                }
                                let _e2125 = phi_4656_;
                                let _e2127 = phi_4085_;
                                let _e2129 = phi_4086_;
                                let _e2131 = phi_4087_;
                                let _e2133 = phi_4088_;
                                let _e2135 = phi_4089_;
                                phi_4655_ = _e2125;
                                phi_4090_ = _e2127;
                                phi_4091_ = _e2129;
                                phi_4092_ = _e2131;
                                phi_4093_ = _e2133;
                                phi_4094_ = _e2135;
                            } else {
                                phi_4655_ = _e649;
                                phi_4090_ = type_44();
                                phi_4091_ = bool();
                                phi_4092_ = type_51();
                                phi_4093_ = u32();
                                phi_4094_ = u32();
                            }
                            let _e2137 = phi_4655_;
                            let _e2139 = phi_4090_;
                            let _e2141 = phi_4091_;
                            let _e2143 = phi_4092_;
                            let _e2145 = phi_4093_;
                            let _e2147 = phi_4094_;
                            phi_4654_ = _e2137;
                            phi_1121_ = _e2139;
                            phi_1124_ = _e2141;
                            phi_1126_ = _e2143;
                            phi_1128_ = _e2145;
                            phi_1130_ = _e2147;
                            phi_4095_ = _e663;
                        } else {
                            phi_4654_ = _e649;
                            phi_1121_ = type_44();
                            phi_1124_ = bool();
                            phi_1126_ = type_51();
                            phi_1128_ = u32();
                            phi_1130_ = u32();
                            phi_4095_ = false;
                        }
                        let _e2149 = phi_4654_;
                        let _e2151 = phi_1121_;
                        let _e2153 = phi_1124_;
                        let _e2155 = phi_1126_;
                        let _e2157 = phi_1128_;
                        let _e2159 = phi_1130_;
                        let _e2161 = phi_4095_;
                        continue;
                        continuing {
                            phi_4459_ = _e2149;
                            phi_1120_ = _e2151;
                            phi_1123_ = _e2153;
                            phi_1125_ = _e2155;
                            phi_1127_ = _e2157;
                            phi_1129_ = _e2159;
                            phi_4653_ = _e2149;
                            break if !(_e2161);
                        }
                    }
                    let _e2164 = phi_4653_;
                    if _e2164 {
                        break;
                    }
                    let _e2166 = local_11;
                    let _e2169 = local_12;
                    if _e154 {
                    } else {
                        break;
                    }
                    global_6.member[_e152][0u] = _e2166.member_1;
                    global_6.member[_e152][1u] = _e2169.member_2;
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
