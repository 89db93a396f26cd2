struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<array<u32, 2>>,
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

struct type_33 {
    member: type_24,
    member_1: f32,
}

struct type_36 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_38 {
    member: array<type_25>,
}

struct type_40 {
    member: type_33,
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
    member: type_28,
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
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(4) 
var<storage> global_3: type_38;
@group(0) @binding(2) 
var<storage> global_4: type_46;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;

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
    var phi_1120_: type_40;
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
    var phi_1247_: type_40;
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
    var phi_2762_: type_36;
    var phi_2763_: type_36;
    var phi_2766_: type_36;
    var phi_2767_: type_36;
    var phi_2768_: bool;
    var phi_2772_: type_36;
    var phi_2781_: type_24;
    var phi_2806_: bool;
    var phi_2807_: bool;
    var phi_2814_: type_40;
    var phi_2815_: type_40;
    var phi_2816_: type_40;
    var phi_1248_: type_40;
    var phi_4453_: bool;
    var local_10: type_40;
    var phi_4657_: bool;
    var phi_4081_: type_40;
    var phi_4082_: bool;
    var phi_4083_: type_51;
    var phi_4084_: u32;
    var phi_4656_: bool;
    var phi_4085_: type_40;
    var phi_4086_: bool;
    var phi_4087_: type_51;
    var phi_4088_: u32;
    var phi_4089_: u32;
    var phi_4655_: bool;
    var phi_4090_: type_40;
    var phi_4091_: bool;
    var phi_4092_: type_51;
    var phi_4093_: u32;
    var phi_4094_: u32;
    var phi_4654_: bool;
    var phi_1121_: type_40;
    var phi_1124_: bool;
    var phi_1126_: type_51;
    var phi_1128_: u32;
    var phi_1130_: u32;
    var phi_4095_: bool;
    var phi_4653_: bool;
    var local_11: type_40;
    var local_12: type_40;
    var local_13: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_4.member));
            let _e95 = arrayLength((&global_5.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[0u][3u];
            let _e119 = global_2.member[1u][0u];
            let _e123 = global_2.member[1u][1u];
            let _e127 = global_2.member[1u][2u];
            let _e130 = global_1.member[0u];
            let _e131 = bitcast<i32>(_e130);
            let _e143 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e115) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e103), bitcast<i32>(_e107), bitcast<i32>(_e111));
            local = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            let _e149 = (_e90.x + (_e90.y * 2097152u));
            let _e150 = (_e149 < arrayLength((&global_3.member)));
            if _e150 {
                let _e151 = (_e149 < arrayLength((&global_6.member)));
                if _e151 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e159 = global_3.member[_e149].member_2[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_3.member[_e149].member_2[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e149].member_2[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_3.member[_e149].member[0u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_3.member[_e149].member[1u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_3.member[_e149].member[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e198 = select(_e168, _e161, (_e168 < _e161));
                    let _e200 = select(_e175, _e198, (_e175 < _e198));
                    let _e202 = select(_e182, _e200, (_e182 < _e200));
                    let _e204 = select(_e189, _e202, (_e189 < _e202));
                    let _e206 = select(_e196, _e204, (_e196 < _e204));
                    let _e210 = global_3.member[_e149].member_1;
                    let _e211 = bitcast<u32>(_e210);
                    let _e212 = (_e211 & 2147483647u);
                    let _e219 = global_3.member[_e149].member_3;
                    let _e220 = bitcast<u32>(_e219);
                    let _e221 = (_e220 & 2147483647u);
                    let _e225 = (((select(_e212, _e206, (_e212 < _e206)) < 2139095040u) && (_e221 <= 2139095040u)) && (_e200 > 0u));
                    if _e225 {
                        let _e228 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                        if (_e228 >= 8388608u) {
                            phi_430_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_430_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_430_;
                        phi_431_ = _e242;
                    } else {
                        phi_431_ = 0i;
                    }
                    let _e244 = phi_431_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_441_ = true;
                    } else {
                        phi_441_ = (_e168 == _e200);
                    }
                    let _e248 = phi_441_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_451_ = _e250;
                        phi_452_ = _e250;
                        phi_454_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_451_ = u32();
                        phi_452_ = 0u;
                        phi_454_ = true;
                    }
                    let _e254 = phi_451_;
                    let _e256 = phi_452_;
                    let _e258 = phi_454_;
                    if _e258 {
                        phi_459_ = (_e256 + 1u);
                    } else {
                        phi_459_ = 0u;
                    }
                    let _e262 = phi_459_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_472_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_492_ = -126i;
                    } else {
                        phi_492_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_492_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_3.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_510_ = _e301[0];
                    } else {
                        phi_510_ = _e301[1];
                    }
                    let _e306 = phi_510_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_516_ = _e301[2];
                    } else {
                        phi_516_ = _e306;
                    }
                    let _e310 = phi_516_;
                    let _e311 = bitcast<u32>(_e310);
                    let _e313 = ((_e311 & 2139095040u) != 0u);
                    let _e327 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e311 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e311 & 2147483648u))), _e310, _e313) * _e274) * select(0.00000011920929f, 1f, _e313)) * _e280);
                    let _e328 = global_3.member[_e149].member_2;
                    if _e302 {
                        phi_556_ = _e328[0];
                    } else {
                        phi_556_ = _e328[1];
                    }
                    let _e332 = phi_556_;
                    if _e307 {
                        phi_562_ = _e328[2];
                    } else {
                        phi_562_ = _e332;
                    }
                    let _e335 = phi_562_;
                    let _e336 = bitcast<u32>(_e335);
                    let _e338 = ((_e336 & 2139095040u) != 0u);
                    let _e352 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e336 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e336 & 2147483648u))), _e335, _e338) * _e291) * select(0.00000011920929f, 1f, _e338)) * _e297);
                    let _e356 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e359 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                    let _e360 = (_e359 * 0.00000011920929f);
                    let _e363 = select(select(0.00000000000011368684f, _e360, (_e360 > 0.00000000000011368684f)), 0f, _e356);
                    let _e364 = select(0f, _e352, _e356);
                    let _e365 = (_e327 + _e363);
                    let _e366 = (_e327 - _e363);
                    let _e368 = select(38685626000000000000000000f, (1f / _e352), _e356);
                    let _e369 = (_e262 == 0u);
                    if _e369 {
                        phi_635_ = _e301[0];
                    } else {
                        phi_635_ = _e301[1];
                    }
                    let _e373 = phi_635_;
                    let _e374 = (_e262 == 2u);
                    if _e374 {
                        phi_641_ = _e301[2];
                    } else {
                        phi_641_ = _e373;
                    }
                    let _e377 = phi_641_;
                    let _e378 = bitcast<u32>(_e377);
                    let _e380 = ((_e378 & 2139095040u) != 0u);
                    let _e394 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e377, _e380) * _e274) * select(0.00000011920929f, 1f, _e380)) * _e280);
                    if _e369 {
                        phi_681_ = _e328[0];
                    } else {
                        phi_681_ = _e328[1];
                    }
                    let _e398 = phi_681_;
                    if _e374 {
                        phi_687_ = _e328[2];
                    } else {
                        phi_687_ = _e398;
                    }
                    let _e401 = phi_687_;
                    let _e402 = bitcast<u32>(_e401);
                    let _e404 = ((_e402 & 2139095040u) != 0u);
                    let _e418 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e402 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e402 & 2147483648u))), _e401, _e404) * _e291) * select(0.00000011920929f, 1f, _e404)) * _e297);
                    let _e422 = (bitcast<f32>((bitcast<u32>(_e418) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e425 = bitcast<f32>((bitcast<u32>(_e394) & 2147483647u));
                    let _e426 = (_e425 * 0.00000011920929f);
                    let _e429 = select(select(0.00000000000011368684f, _e426, (_e426 > 0.00000000000011368684f)), 0f, _e422);
                    let _e430 = select(0f, _e418, _e422);
                    let _e431 = (_e394 + _e429);
                    let _e432 = (_e394 - _e429);
                    let _e434 = select(38685626000000000000000000f, (1f / _e418), _e422);
                    let _e435 = (_e264 == 0u);
                    if _e435 {
                        phi_760_ = _e301[0];
                    } else {
                        phi_760_ = _e301[1];
                    }
                    let _e439 = phi_760_;
                    let _e440 = (_e264 == 2u);
                    if _e440 {
                        phi_766_ = _e301[2];
                    } else {
                        phi_766_ = _e439;
                    }
                    let _e443 = phi_766_;
                    let _e444 = bitcast<u32>(_e443);
                    let _e446 = ((_e444 & 2139095040u) != 0u);
                    let _e460 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e444 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e444 & 2147483648u))), _e443, _e446) * _e274) * select(0.00000011920929f, 1f, _e446)) * _e280);
                    if _e435 {
                        phi_806_ = _e328[0];
                    } else {
                        phi_806_ = _e328[1];
                    }
                    let _e464 = phi_806_;
                    if _e440 {
                        phi_812_ = _e328[2];
                    } else {
                        phi_812_ = _e464;
                    }
                    let _e467 = phi_812_;
                    let _e468 = bitcast<u32>(_e467);
                    let _e470 = ((_e468 & 2139095040u) != 0u);
                    let _e484 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e468 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e468 & 2147483648u))), _e467, _e470) * _e291) * select(0.00000011920929f, 1f, _e470)) * _e297);
                    let _e488 = (bitcast<f32>((bitcast<u32>(_e484) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e491 = bitcast<f32>((bitcast<u32>(_e460) & 2147483647u));
                    let _e492 = (_e491 * 0.00000011920929f);
                    let _e495 = select(select(0.00000000000011368684f, _e492, (_e492 > 0.00000000000011368684f)), 0f, _e488);
                    let _e496 = select(0f, _e484, _e488);
                    let _e497 = (_e460 + _e495);
                    let _e498 = (_e460 - _e495);
                    let _e500 = select(38685626000000000000000000f, (1f / _e484), _e488);
                    let _e502 = select(_e425, _e359, (_e359 > _e425));
                    let _e505 = (_e131 + _e244);
                    if (_e225 && (select(_e491, _e502, (_e502 > _e491)) <= 1099511600000f)) {
                        let _e515 = ((_e212 & 8388607u) | (select(0u, 1u, ((_e212 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e518 = bitcast<i32>((_e212 >> bitcast<u32>(23i)));
                        let _e522 = (_e515 == 0u);
                        let _e525 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e515)), 32u, _e522)) - 8i);
                        if (_e518 == 255i) {
                            phi_931_ = 255i;
                        } else {
                            phi_931_ = (((_e518 + select(0i, 1i, (_e518 == 0i))) - _e525) + _e505);
                        }
                        let _e533 = phi_931_;
                        let _e543 = (_e533 <= 0i);
                        if _e543 {
                            phi_954_ = u32();
                        } else {
                            if _e522 {
                                phi_953_ = u32();
                            } else {
                                phi_953_ = select(((bitcast<u32>(_e533) << bitcast<u32>(23i)) | ((_e515 << bitcast<u32>(((_e525 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e533 >= 255i));
                            }
                            let _e547 = phi_953_;
                            phi_954_ = _e547;
                        }
                        let _e549 = phi_954_;
                        let _e561 = ((_e221 & 8388607u) | (select(0u, 1u, ((_e221 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e564 = bitcast<i32>((_e221 >> bitcast<u32>(23i)));
                        let _e568 = (_e561 == 0u);
                        let _e571 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e561)), 32u, _e568)) - 8i);
                        if (_e564 == 255i) {
                            phi_991_ = 255i;
                        } else {
                            phi_991_ = (((_e564 + select(0i, 1i, (_e564 == 0i))) - _e571) + _e505);
                        }
                        let _e579 = phi_991_;
                        let _e589 = (_e579 <= 0i);
                        if _e589 {
                            phi_1014_ = u32();
                        } else {
                            if _e568 {
                                phi_1013_ = u32();
                            } else {
                                phi_1013_ = select(((bitcast<u32>(_e579) << bitcast<u32>(23i)) | ((_e561 << bitcast<u32>(((_e571 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e579 >= 255i));
                            }
                            let _e593 = phi_1013_;
                            phi_1014_ = _e593;
                        }
                        let _e595 = phi_1014_;
                        phi_1022_ = bitcast<f32>(((_e220 & 2147483648u) | select(_e595, 0u, select(_e568, true, _e589))));
                        phi_1023_ = bitcast<f32>(((_e211 & 2147483648u) | select(_e549, 0u, select(_e522, true, _e543))));
                    } else {
                        phi_1022_ = 0f;
                        phi_1023_ = 1f;
                    }
                    let _e601 = phi_1022_;
                    let _e603 = phi_1023_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e610 = (_e263 % 3u);
                    let _e611 = (_e610 < 3u);
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e613 = local_1[_e610];
                    let _e616 = (_e262 % 3u);
                    let _e617 = (_e616 < 3u);
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e619 = local_1[_e616];
                    let _e622 = (_e264 % 3u);
                    let _e623 = (_e622 < 3u);
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e625 = local_1[_e622];
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e630 = local[_e610];
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e634 = local[_e616];
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e638 = local[_e622];
                    phi_4459_ = false;
                    phi_1120_ = type_40(type_33(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e601), 0u, 0u);
                    phi_1123_ = (_e603 <= _e601);
                    phi_1125_ = type_51(type_28(vec4<f32>((f32(_e613) * _e143), (f32(_e619) * _e143), (f32(_e625) * _e143), 0f), vec4<f32>((f32(_e630) * _e143), (f32(_e634) * _e143), (f32(_e638) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_1127_ = 0u;
                    phi_1129_ = ((3u * _e92) + 1u);
                    loop {
                        let _e646 = phi_4459_;
                        let _e648 = phi_1120_;
                        let _e650 = phi_1123_;
                        let _e652 = phi_1125_;
                        let _e654 = phi_1127_;
                        let _e656 = phi_1129_;
                        local_11 = _e648;
                        local_12 = _e648;
                        if _e650 {
                            phi_1140_ = true;
                        } else {
                            phi_1140_ = (_e654 > 0u);
                        }
                        let _e659 = phi_1140_;
                        if _e659 {
                            let _e660 = (_e656 > 0u);
                            if _e660 {
                                if _e650 {
                                    phi_1226_ = _e650;
                                    phi_1227_ = _e652;
                                    phi_1228_ = _e654;
                                } else {
                                    let _e661 = (_e654 - 1u);
                                    let _e662 = (_e661 % 128u);
                                    let _e663 = (_e662 < 128u);
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e665 = local_7[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e667 = local_6[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e669 = local_5[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e671 = local_4[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e673 = local_3[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e675 = local_2[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e680 = local_8[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4653_ = true;
                                        break;
                                    }
                                    let _e683 = local_9[_e662];
                                    phi_1226_ = (_e683 <= _e648.member.member_1);
                                    phi_1227_ = type_51(type_28(vec4<f32>(_e665, _e667, _e669, 0f), vec4<f32>(_e671, _e673, _e675, 0f)), _e680);
                                    phi_1228_ = _e661;
                                }
                                let _e688 = phi_1226_;
                                let _e690 = phi_1227_;
                                let _e692 = phi_1228_;
                                if _e688 {
                                    let _e697 = (_e690.member_1 & 268435455u);
                                    if ((_e690.member_1 & 2147483648u) != 0u) {
                                        phi_1247_ = _e648;
                                        phi_1250_ = type_8(0u, ((_e690.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1187 = phi_1247_;
                                            let _e1189 = phi_1250_;
                                            local_10 = _e1187;
                                            local_13 = _e1187;
                                            if (_e1189.member < _e1189.member_1) {
                                                phi_1251_ = type_8((_e1189.member + 1u), _e1189.member_1);
                                                phi_1273_ = type_8(1u, _e1189.member);
                                            } else {
                                                phi_1251_ = _e1189;
                                                phi_1273_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1202 = phi_1251_;
                                            let _e1204 = phi_1273_;
                                            let _e1208 = (bitcast<i32>(_e1204.member) != 0i);
                                            if _e1208 {
                                                let _e1214 = type_40(_e1187.member, _e1187.member_1, (_e1187.member_2 + 1u));
                                                let _e1219 = (_e690.member.member_1.x - _e690.member.member.x);
                                                let _e1222 = (_e690.member.member_1.y - _e690.member.member.y);
                                                let _e1225 = (_e690.member.member_1.z - _e690.member.member.z);
                                                let _e1227 = select(_e1222, _e1219, (_e1219 > _e1222));
                                                let _e1229 = select(_e1225, _e1227, (_e1227 > _e1225));
                                                let _e1231 = (_e1229 < (1024f * _e143));
                                                if _e1231 {
                                                    phi_1317_ = 0u;
                                                } else {
                                                    phi_1317_ = select(2u, 1u, (_e1229 < (2097152f * _e143)));
                                                }
                                                let _e1236 = phi_1317_;
                                                switch bitcast<i32>(_e1236) {
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
                                                let _e1239 = phi_1323_;
                                                switch bitcast<i32>(_e1236) {
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
                                                let _e1246 = phi_1333_;
                                                let _e1248 = ((_e697 + (_e1204.member_1 * ((3u * _e1239) + 1u))) + (3u * _e1246));
                                                let _e1249 = (_e1248 < _e95);
                                                if _e1249 {
                                                    if _e1249 {
                                                    } else {
                                                        phi_4453_ = true;
                                                        break;
                                                    }
                                                    let _e1251 = global_5.member[_e1248];
                                                    phi_1349_ = _e1251;
                                                } else {
                                                    phi_1349_ = 4294967295u;
                                                }
                                                let _e1253 = phi_1349_;
                                                if _e1231 {
                                                    phi_1382_ = 0u;
                                                } else {
                                                    phi_1382_ = select(2u, 1u, (_e1229 < (2097152f * _e143)));
                                                }
                                                let _e1258 = phi_1382_;
                                                switch bitcast<i32>(_e1258) {
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
                                                let _e1261 = phi_1388_;
                                                let _e1265 = (_e697 + (_e1204.member_1 * ((3u * _e1261) + 1u)));
                                                switch bitcast<i32>(_e1258) {
                                                    case 0: {
                                                        let _e1540 = (_e1265 < _e95);
                                                        if _e1540 {
                                                            if _e1540 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1542 = global_5.member[_e1265];
                                                            phi_1415_ = _e1542;
                                                        } else {
                                                            phi_1415_ = 0u;
                                                        }
                                                        let _e1544 = phi_1415_;
                                                        let _e1546 = ((10u * _e263) & 31u);
                                                        let _e1556 = ((10u * _e262) & 31u);
                                                        let _e1566 = ((10u * _e264) & 31u);
                                                        let _e1576 = (_e1265 + 1u);
                                                        let _e1577 = (_e1576 < _e95);
                                                        if _e1577 {
                                                            if _e1577 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1579 = global_5.member[_e1576];
                                                            phi_1464_ = _e1579;
                                                        } else {
                                                            phi_1464_ = 0u;
                                                        }
                                                        let _e1581 = phi_1464_;
                                                        let _e1607 = (_e1265 + 2u);
                                                        let _e1608 = (_e1607 < _e95);
                                                        if _e1608 {
                                                            if _e1608 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1610 = global_5.member[_e1607];
                                                            phi_1513_ = _e1610;
                                                        } else {
                                                            phi_1513_ = 0u;
                                                        }
                                                        let _e1612 = phi_1513_;
                                                        phi_2014_ = array<array<f32, 3>, 3>(array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1544 >> bitcast<u32>(_e1546)) & 1023u))) - 8388608f) * _e143)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1544 >> bitcast<u32>(_e1556)) & 1023u))) - 8388608f) * _e143)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1544 >> bitcast<u32>(_e1566)) & 1023u))) - 8388608f) * _e143))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1581 >> bitcast<u32>(_e1546)) & 1023u))) - 8388608f) * _e143)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1581 >> bitcast<u32>(_e1556)) & 1023u))) - 8388608f) * _e143)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1581 >> bitcast<u32>(_e1566)) & 1023u))) - 8388608f) * _e143))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1612 >> bitcast<u32>(_e1546)) & 1023u))) - 8388608f) * _e143)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1612 >> bitcast<u32>(_e1556)) & 1023u))) - 8388608f) * _e143)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1612 >> bitcast<u32>(_e1566)) & 1023u))) - 8388608f) * _e143))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1354 = (_e1265 < _e95);
                                                        if _e1354 {
                                                            if _e1354 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1356 = global_5.member[_e1265];
                                                            phi_1562_ = _e1356;
                                                        } else {
                                                            phi_1562_ = 0u;
                                                        }
                                                        let _e1358 = phi_1562_;
                                                        let _e1359 = (_e1265 + 1u);
                                                        let _e1360 = (_e1359 < _e95);
                                                        if _e1360 {
                                                            if _e1360 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1362 = global_5.member[_e1359];
                                                            phi_1577_ = _e1362;
                                                        } else {
                                                            phi_1577_ = 0u;
                                                        }
                                                        let _e1364 = phi_1577_;
                                                        let _e1365 = (_e263 == 1u);
                                                        if _e1365 {
                                                            phi_1587_ = ((_e1358 >> bitcast<u32>(21i)) | (_e1364 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1587_ = (_e1364 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1374 = phi_1587_;
                                                        let _e1382 = (_e262 == 1u);
                                                        if _e1382 {
                                                            phi_1608_ = ((_e1358 >> bitcast<u32>(21i)) | (_e1364 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1608_ = (_e1364 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1391 = phi_1608_;
                                                        let _e1399 = (_e264 == 1u);
                                                        if _e1399 {
                                                            phi_1629_ = ((_e1358 >> bitcast<u32>(21i)) | (_e1364 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1629_ = (_e1364 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1408 = phi_1629_;
                                                        let _e1417 = (_e1265 + 2u);
                                                        let _e1418 = (_e1417 < _e95);
                                                        if _e1418 {
                                                            if _e1418 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1420 = global_5.member[_e1417];
                                                            phi_1659_ = _e1420;
                                                        } else {
                                                            phi_1659_ = 0u;
                                                        }
                                                        let _e1422 = phi_1659_;
                                                        let _e1423 = (_e1265 + 3u);
                                                        let _e1424 = (_e1423 < _e95);
                                                        if _e1424 {
                                                            if _e1424 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1426 = global_5.member[_e1423];
                                                            phi_1674_ = _e1426;
                                                        } else {
                                                            phi_1674_ = 0u;
                                                        }
                                                        let _e1428 = phi_1674_;
                                                        if _e1365 {
                                                            phi_1684_ = ((_e1422 >> bitcast<u32>(21i)) | (_e1428 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1684_ = (_e1428 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1437 = phi_1684_;
                                                        if _e1382 {
                                                            phi_1705_ = ((_e1422 >> bitcast<u32>(21i)) | (_e1428 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1705_ = (_e1428 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1453 = phi_1705_;
                                                        if _e1399 {
                                                            phi_1726_ = ((_e1422 >> bitcast<u32>(21i)) | (_e1428 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1726_ = (_e1428 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1469 = phi_1726_;
                                                        let _e1478 = (_e1265 + 4u);
                                                        let _e1479 = (_e1478 < _e95);
                                                        if _e1479 {
                                                            if _e1479 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1481 = global_5.member[_e1478];
                                                            phi_1756_ = _e1481;
                                                        } else {
                                                            phi_1756_ = 0u;
                                                        }
                                                        let _e1483 = phi_1756_;
                                                        let _e1484 = (_e1265 + 5u);
                                                        let _e1485 = (_e1484 < _e95);
                                                        if _e1485 {
                                                            if _e1485 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1487 = global_5.member[_e1484];
                                                            phi_1771_ = _e1487;
                                                        } else {
                                                            phi_1771_ = 0u;
                                                        }
                                                        let _e1489 = phi_1771_;
                                                        if _e1365 {
                                                            phi_1781_ = ((_e1483 >> bitcast<u32>(21i)) | (_e1489 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1781_ = (_e1489 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1498 = phi_1781_;
                                                        if _e1382 {
                                                            phi_1802_ = ((_e1483 >> bitcast<u32>(21i)) | (_e1489 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1802_ = (_e1489 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1514 = phi_1802_;
                                                        if _e1399 {
                                                            phi_1823_ = ((_e1483 >> bitcast<u32>(21i)) | (_e1489 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1823_ = (_e1489 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1530 = phi_1823_;
                                                        phi_2014_ = array<array<f32, 3>, 3>(array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1374, _e1358, _e302) & 2097151u))) - 8388608f) * _e143)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1391, _e1358, _e369) & 2097151u))) - 8388608f) * _e143)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1408, _e1358, _e435) & 2097151u))) - 8388608f) * _e143))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1437, _e1422, _e302) & 2097151u))) - 8388608f) * _e143)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1453, _e1422, _e369) & 2097151u))) - 8388608f) * _e143)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1469, _e1422, _e435) & 2097151u))) - 8388608f) * _e143))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1498, _e1483, _e302) & 2097151u))) - 8388608f) * _e143)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1514, _e1483, _e369) & 2097151u))) - 8388608f) * _e143)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1530, _e1483, _e435) & 2097151u))) - 8388608f) * _e143))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1267 = (_e1265 + _e263);
                                                        let _e1268 = (_e1267 < _e95);
                                                        if _e1268 {
                                                            if _e1268 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1270 = global_5.member[_e1267];
                                                            phi_1854_ = _e1270;
                                                        } else {
                                                            phi_1854_ = 0u;
                                                        }
                                                        let _e1272 = phi_1854_;
                                                        let _e1276 = (_e1265 + _e262);
                                                        let _e1277 = (_e1276 < _e95);
                                                        if _e1277 {
                                                            if _e1277 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1279 = global_5.member[_e1276];
                                                            phi_1872_ = _e1279;
                                                        } else {
                                                            phi_1872_ = 0u;
                                                        }
                                                        let _e1281 = phi_1872_;
                                                        let _e1285 = (_e1265 + _e264);
                                                        let _e1286 = (_e1285 < _e95);
                                                        if _e1286 {
                                                            if _e1286 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1288 = global_5.member[_e1285];
                                                            phi_1890_ = _e1288;
                                                        } else {
                                                            phi_1890_ = 0u;
                                                        }
                                                        let _e1290 = phi_1890_;
                                                        let _e1295 = (_e1265 + 3u);
                                                        let _e1296 = (_e1295 + _e263);
                                                        let _e1297 = (_e1296 < _e95);
                                                        if _e1297 {
                                                            if _e1297 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1299 = global_5.member[_e1296];
                                                            phi_1913_ = _e1299;
                                                        } else {
                                                            phi_1913_ = 0u;
                                                        }
                                                        let _e1301 = phi_1913_;
                                                        let _e1305 = (_e1295 + _e262);
                                                        let _e1306 = (_e1305 < _e95);
                                                        if _e1306 {
                                                            if _e1306 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1308 = global_5.member[_e1305];
                                                            phi_1931_ = _e1308;
                                                        } else {
                                                            phi_1931_ = 0u;
                                                        }
                                                        let _e1310 = phi_1931_;
                                                        let _e1314 = (_e1295 + _e264);
                                                        let _e1315 = (_e1314 < _e95);
                                                        if _e1315 {
                                                            if _e1315 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1317 = global_5.member[_e1314];
                                                            phi_1949_ = _e1317;
                                                        } else {
                                                            phi_1949_ = 0u;
                                                        }
                                                        let _e1319 = phi_1949_;
                                                        let _e1324 = (_e1265 + 6u);
                                                        let _e1325 = (_e1324 + _e263);
                                                        let _e1326 = (_e1325 < _e95);
                                                        if _e1326 {
                                                            if _e1326 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1328 = global_5.member[_e1325];
                                                            phi_1972_ = _e1328;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e1330 = phi_1972_;
                                                        let _e1334 = (_e1324 + _e262);
                                                        let _e1335 = (_e1334 < _e95);
                                                        if _e1335 {
                                                            if _e1335 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1337 = global_5.member[_e1334];
                                                            phi_1990_ = _e1337;
                                                        } else {
                                                            phi_1990_ = 0u;
                                                        }
                                                        let _e1339 = phi_1990_;
                                                        let _e1343 = (_e1324 + _e264);
                                                        let _e1344 = (_e1343 < _e95);
                                                        if _e1344 {
                                                            if _e1344 {
                                                            } else {
                                                                phi_4453_ = true;
                                                                break;
                                                            }
                                                            let _e1346 = global_5.member[_e1343];
                                                            phi_2008_ = _e1346;
                                                        } else {
                                                            phi_2008_ = 0u;
                                                        }
                                                        let _e1348 = phi_2008_;
                                                        phi_2014_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1272)) * _e143), (f32(bitcast<i32>(_e1281)) * _e143), (f32(bitcast<i32>(_e1290)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1301)) * _e143), (f32(bitcast<i32>(_e1310)) * _e143), (f32(bitcast<i32>(_e1319)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1330)) * _e143), (f32(bitcast<i32>(_e1339)) * _e143), (f32(bitcast<i32>(_e1348)) * _e143)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2014_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1640 = phi_2014_;
                                                let _e1657 = (_e1640[0][2] - _e460);
                                                let _e1660 = (((_e1640[0][0] - _e327) * _e496) - (_e1657 * _e364));
                                                let _e1663 = (((_e1640[0][1] - _e394) * _e496) - (_e1657 * _e430));
                                                let _e1666 = (_e1640[1][2] - _e460);
                                                let _e1669 = (((_e1640[1][0] - _e327) * _e496) - (_e1666 * _e364));
                                                let _e1672 = (((_e1640[1][1] - _e394) * _e496) - (_e1666 * _e430));
                                                let _e1675 = (_e1640[2][2] - _e460);
                                                let _e1678 = (((_e1640[2][0] - _e327) * _e496) - (_e1675 * _e364));
                                                let _e1681 = (((_e1640[2][1] - _e394) * _e496) - (_e1675 * _e430));
                                                let _e1682 = (_e1678 * _e1672);
                                                let _e1683 = (_e1681 * _e1669);
                                                let _e1684 = (_e1660 * _e1681);
                                                let _e1685 = (_e1663 * _e1678);
                                                let _e1686 = (_e1669 * _e1663);
                                                let _e1687 = (_e1672 * _e1660);
                                                let _e1692 = (((_e1682 >= _e1683) && (_e1684 >= _e1685)) && (_e1686 >= _e1687));
                                                let _e1698 = (_e1692 || (((_e1682 <= _e1683) && (_e1684 <= _e1685)) && (_e1686 <= _e1687)));
                                                if _e1698 {
                                                    let _e1700 = select(-1f, 1f, _e1692);
                                                    let _e1702 = ((_e1682 - _e1683) * _e1700);
                                                    let _e1704 = select(0f, _e1702, (_e1702 > 0f));
                                                    let _e1706 = ((_e1684 - _e1685) * _e1700);
                                                    let _e1708 = select(0f, _e1706, (_e1706 > 0f));
                                                    let _e1710 = ((_e1686 - _e1687) * _e1700);
                                                    let _e1712 = select(0f, _e1710, (_e1710 > 0f));
                                                    let _e1714 = ((_e1704 + _e1708) + _e1712);
                                                    let _e1716 = select(_e1640[1][0], _e1640[0][0], (_e1640[0][0] < _e1640[1][0]));
                                                    let _e1720 = select(_e1640[1][0], _e1640[0][0], (_e1640[0][0] > _e1640[1][0]));
                                                    let _e1724 = select(_e1640[1][1], _e1640[0][1], (_e1640[0][1] < _e1640[1][1]));
                                                    let _e1728 = select(_e1640[1][1], _e1640[0][1], (_e1640[0][1] > _e1640[1][1]));
                                                    let _e1732 = select(_e1640[1][2], _e1640[0][2], (_e1640[0][2] < _e1640[1][2]));
                                                    let _e1736 = select(_e1640[1][2], _e1640[0][2], (_e1640[0][2] > _e1640[1][2]));
                                                    let _e1741 = ((select(_e1640[2][0], _e1716, (_e1716 < _e1640[2][0])) - _e365) * _e368);
                                                    let _e1742 = ((select(_e1640[2][0], _e1720, (_e1720 > _e1640[2][0])) - _e366) * _e368);
                                                    let _e1745 = ((select(_e1640[2][1], _e1724, (_e1724 < _e1640[2][1])) - _e431) * _e434);
                                                    let _e1746 = ((select(_e1640[2][1], _e1728, (_e1728 > _e1640[2][1])) - _e432) * _e434);
                                                    let _e1749 = ((select(_e1640[2][2], _e1732, (_e1732 < _e1640[2][2])) - _e497) * _e500);
                                                    let _e1750 = ((select(_e1640[2][2], _e1736, (_e1736 > _e1640[2][2])) - _e498) * _e500);
                                                    let _e1752 = select(_e1750, _e1749, (_e1749 < _e1750));
                                                    let _e1754 = select(_e1750, _e1749, (_e1749 > _e1750));
                                                    let _e1756 = select(_e1742, _e1741, (_e1741 < _e1742));
                                                    let _e1758 = select(_e1746, _e1745, (_e1745 < _e1746));
                                                    let _e1760 = select(_e1758, _e1756, (_e1756 > _e1758));
                                                    let _e1762 = select(_e1752, _e1760, (_e1760 > _e1752));
                                                    let _e1764 = select(_e1742, _e1741, (_e1741 > _e1742));
                                                    let _e1766 = select(_e1746, _e1745, (_e1745 > _e1746));
                                                    let _e1768 = select(_e1766, _e1764, (_e1764 < _e1766));
                                                    let _e1770 = select(_e1754, _e1768, (_e1768 < _e1754));
                                                    let _e1771 = -(_e1752);
                                                    let _e1777 = select(_e603, _e1762, (_e1762 > _e603));
                                                    let _e1781 = select(_e1669, _e1660, (_e1660 < _e1669));
                                                    let _e1786 = select(_e1669, _e1660, (_e1660 > _e1669));
                                                    let _e1793 = select(_e1672, _e1663, (_e1663 < _e1672));
                                                    let _e1798 = select(_e1672, _e1663, (_e1663 > _e1672));
                                                    let _e1807 = (((((_e1698 && (_e1714 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1678, _e1781, (_e1781 < _e1678)) <= 0f) && (select(_e1678, _e1786, (_e1786 > _e1678)) >= 0f))) && ((select(_e1681, _e1793, (_e1793 < _e1681)) <= 0f) && (select(_e1681, _e1798, (_e1798 > _e1681)) >= 0f))) && (_e1777 <= (_e1770 + (select(_e1771, _e1754, (_e1754 > _e1771)) * 0.0000019073523f)))) && (_e1777 <= _e1187.member.member_1));
                                                    if _e1807 {
                                                        let _e1812 = (_e1640[1][0] - _e1640[0][0]);
                                                        let _e1813 = (_e1640[1][1] - _e1640[0][1]);
                                                        let _e1814 = (_e1640[1][2] - _e1640[0][2]);
                                                        let _e1815 = vec3<f32>(_e1812, _e1813, _e1814);
                                                        let _e1816 = (_e1640[2][0] - _e1640[1][0]);
                                                        let _e1817 = (_e1640[2][1] - _e1640[1][1]);
                                                        let _e1818 = (_e1640[2][2] - _e1640[1][2]);
                                                        let _e1819 = vec3<f32>(_e1816, _e1817, _e1818);
                                                        let _e1820 = (_e1640[0][0] - _e1640[2][0]);
                                                        let _e1821 = (_e1640[0][1] - _e1640[2][1]);
                                                        let _e1822 = (_e1640[0][2] - _e1640[2][2]);
                                                        let _e1823 = vec3<f32>(_e1820, _e1821, _e1822);
                                                        let _e1826 = bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u));
                                                        let _e1829 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                        let _e1831 = select(_e1829, _e1826, (_e1826 > _e1829));
                                                        let _e1834 = bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u));
                                                        let _e1836 = select(_e1834, _e1831, (_e1831 > _e1834));
                                                        let _e1839 = bitcast<f32>((bitcast<u32>(_e1816) & 2147483647u));
                                                        let _e1842 = bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u));
                                                        let _e1844 = select(_e1842, _e1839, (_e1839 > _e1842));
                                                        let _e1847 = bitcast<f32>((bitcast<u32>(_e1818) & 2147483647u));
                                                        let _e1849 = select(_e1847, _e1844, (_e1844 > _e1847));
                                                        let _e1852 = bitcast<f32>((bitcast<u32>(_e1820) & 2147483647u));
                                                        let _e1855 = bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u));
                                                        let _e1857 = select(_e1855, _e1852, (_e1852 > _e1855));
                                                        let _e1860 = bitcast<f32>((bitcast<u32>(_e1822) & 2147483647u));
                                                        let _e1862 = select(_e1860, _e1857, (_e1857 > _e1860));
                                                        let _e1864 = select(_e1849, _e1836, (_e1836 > _e1849));
                                                        let _e1866 = select(_e1862, _e1864, (_e1864 > _e1862));
                                                        if (_e1836 == _e1866) {
                                                            phi_2544_ = _e1672;
                                                            phi_2545_ = _e1669;
                                                            phi_2546_ = _e1663;
                                                            phi_2547_ = _e1660;
                                                            phi_2548_ = vec3<f32>(_e1640[0][0], _e1640[0][1], _e1640[0][2]);
                                                            phi_2549_ = _e1823;
                                                            phi_2550_ = _e1819;
                                                            phi_2551_ = _e1815;
                                                        } else {
                                                            let _e1868 = (_e1849 == _e1866);
                                                            let _e1873 = vec3(_e1868);
                                                            phi_2544_ = select(_e1663, _e1681, _e1868);
                                                            phi_2545_ = select(_e1660, _e1678, _e1868);
                                                            phi_2546_ = select(_e1681, _e1672, _e1868);
                                                            phi_2547_ = select(_e1678, _e1669, _e1868);
                                                            phi_2548_ = select(vec3<f32>(_e1640[2][0], _e1640[2][1], _e1640[2][2]), vec3<f32>(_e1640[1][0], _e1640[1][1], _e1640[1][2]), _e1873);
                                                            phi_2549_ = select(_e1819, _e1815, _e1873);
                                                            phi_2550_ = select(_e1815, _e1823, _e1873);
                                                            phi_2551_ = select(_e1823, _e1819, _e1873);
                                                        }
                                                        let _e1879 = phi_2544_;
                                                        let _e1881 = phi_2545_;
                                                        let _e1883 = phi_2546_;
                                                        let _e1885 = phi_2547_;
                                                        let _e1887 = phi_2548_;
                                                        let _e1889 = phi_2549_;
                                                        let _e1891 = phi_2550_;
                                                        let _e1893 = phi_2551_;
                                                        let _e1900 = ((_e1891.y * _e1889.z) - (_e1889.y * _e1891.z));
                                                        let _e1905 = ((_e1891.z * _e1889.x) - (_e1889.z * _e1891.x));
                                                        let _e1908 = ((_e1891.x * _e1889.y) - (_e1889.x * _e1891.y));
                                                        let _e1911 = ((_e1704 >= _e1708) && (_e1704 >= _e1712));
                                                        let _e1912 = (_e1708 >= _e1712);
                                                        let _e1926 = (((_e1900 * (select(select(_e1640[2][0], _e1640[1][0], _e1912), _e1640[0][0], _e1911) - _e327)) + (_e1905 * (select(select(_e1640[2][1], _e1640[1][1], _e1912), _e1640[0][1], _e1911) - _e394))) + (_e1908 * (select(select(_e1640[2][2], _e1640[1][2], _e1912), _e1640[0][2], _e1911) - _e460)));
                                                        let _e1931 = (((_e1900 * _e364) + (_e1905 * _e430)) + (_e1908 * _e496));
                                                        let _e1932 = (_e1881 - _e1885);
                                                        let _e1933 = (_e1879 - _e1883);
                                                        let _e1936 = ((_e1932 * _e1932) + (_e1933 * _e1933));
                                                        let _e1943 = (-(((_e1885 * _e1932) + (_e1883 * _e1933))) / select(0.000000000000000000000000000000000000011754944f, _e1936, (_e1936 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1945 = select(1f, _e1943, (_e1943 < 1f));
                                                        let _e1947 = select(0f, _e1945, (_e1945 > 0f));
                                                        let _e1956 = ((_e1887.x + (_e1893.x * _e1947)) - _e327);
                                                        let _e1959 = ((_e1887.y + (_e1893.y * _e1947)) - _e394);
                                                        let _e1962 = ((_e1887.z + (_e1893.z * _e1947)) - _e460);
                                                        let _e1965 = bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u));
                                                        let _e1968 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                        let _e1970 = select(_e1968, _e1965, (_e1965 > _e1968));
                                                        let _e1973 = bitcast<f32>((bitcast<u32>(_e1962) & 2147483647u));
                                                        let _e1975 = select(_e1973, _e1970, (_e1970 > _e1973));
                                                        let _e1981 = bitcast<f32>((bitcast<u32>(_e1900) & 2147483647u));
                                                        let _e1984 = bitcast<f32>((bitcast<u32>(_e1905) & 2147483647u));
                                                        let _e1986 = select(_e1984, _e1981, (_e1981 > _e1984));
                                                        let _e1989 = bitcast<f32>((bitcast<u32>(_e1908) & 2147483647u));
                                                        let _e2008 = bitcast<f32>((bitcast<u32>(_e1891.x) & 2147483647u));
                                                        let _e2011 = bitcast<f32>((bitcast<u32>(_e1891.y) & 2147483647u));
                                                        let _e2013 = select(_e2011, _e2008, (_e2008 > _e2011));
                                                        let _e2016 = bitcast<f32>((bitcast<u32>(_e1891.z) & 2147483647u));
                                                        let _e2022 = bitcast<f32>((bitcast<u32>(_e1889.x) & 2147483647u));
                                                        let _e2025 = bitcast<f32>((bitcast<u32>(_e1889.y) & 2147483647u));
                                                        let _e2027 = select(_e2025, _e2022, (_e2022 > _e2025));
                                                        let _e2030 = bitcast<f32>((bitcast<u32>(_e1889.z) & 2147483647u));
                                                        let _e2036 = ((bitcast<f32>((bitcast<u32>(((((_e1900 * _e1956) + (_e1905 * _e1959)) + (_e1908 * _e1962)) - _e1926)) & 2147483647u)) <= ((0.0000009536743f * select(_e1866, _e1975, (_e1975 > _e1866))) * select(_e1989, _e1986, (_e1986 > _e1989)))) && !((bitcast<f32>((bitcast<u32>(_e1931) & 2147483647u)) <= ((0.0000038146973f * select(_e2016, _e2013, (_e2013 > _e2016))) * select(_e2030, _e2027, (_e2027 > _e2030))))));
                                                        let _e2037 = (_e1926 / _e1931);
                                                        if (_e1807 && !(_e2036)) {
                                                            let _e2040 = (_e1962 / _e496);
                                                            let _e2048 = (((_e1900 * (_e1956 - (_e364 * _e2040))) + (_e1905 * (_e1959 - (_e430 * _e2040)))) / _e1931);
                                                            phi_2742_ = select(select(_e2040, (_e2040 + _e2048), (bitcast<f32>((bitcast<u32>(_e2048) & 2147483647u)) <= _e1866)), _e2037, _e2036);
                                                        } else {
                                                            phi_2742_ = _e2037;
                                                        }
                                                        let _e2057 = phi_2742_;
                                                        let _e2059 = select(_e1770, _e2057, (_e2057 < _e1770));
                                                        let _e2061 = select(_e1762, _e2059, (_e2059 > _e1762));
                                                        let _e2062 = (1f / _e1714);
                                                        phi_2762_ = type_36(_e2061, (_e1708 * _e2062), (_e1712 * _e2062), ((_e1807 && (_e2061 >= _e603)) && (_e2061 <= _e1187.member.member_1)));
                                                        phi_2763_ = type_36();
                                                    } else {
                                                        phi_2762_ = type_36();
                                                        phi_2763_ = type_36(0f, 0f, 0f, _e1807);
                                                    }
                                                    let _e2071 = phi_2762_;
                                                    let _e2073 = phi_2763_;
                                                    phi_2766_ = _e2071;
                                                    phi_2767_ = _e2073;
                                                    phi_2768_ = select(true, false, _e1807);
                                                } else {
                                                    phi_2766_ = type_36();
                                                    phi_2767_ = type_36(0f, 0f, 0f, _e1698);
                                                    phi_2768_ = true;
                                                }
                                                let _e2076 = phi_2766_;
                                                let _e2078 = phi_2767_;
                                                let _e2080 = phi_2768_;
                                                if _e2080 {
                                                    phi_2772_ = _e2078;
                                                } else {
                                                    phi_2772_ = _e2076;
                                                }
                                                let _e2082 = phi_2772_;
                                                if _e2082.member_3 {
                                                    phi_2781_ = type_24(_e2082.member, _e2082.member_1, _e2082.member_2, _e1253);
                                                } else {
                                                    phi_2781_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2089 = phi_2781_;
                                                if (_e2089.member_3 != 4294967295u) {
                                                    if (_e1253 != 4294967295u) {
                                                        if (_e2089.member < _e1187.member.member.member) {
                                                            phi_2807_ = true;
                                                        } else {
                                                            if (_e2089.member == _e1187.member.member.member) {
                                                                phi_2806_ = (_e2089.member_3 < _e1187.member.member.member_3);
                                                            } else {
                                                                phi_2806_ = false;
                                                            }
                                                            let _e2104 = phi_2806_;
                                                            phi_2807_ = _e2104;
                                                        }
                                                        let _e2106 = phi_2807_;
                                                        if _e2106 {
                                                            phi_2814_ = type_40(type_33(_e2089, _e2089.member), _e1214.member_1, _e1214.member_2);
                                                        } else {
                                                            phi_2814_ = _e1214;
                                                        }
                                                        let _e2113 = phi_2814_;
                                                        phi_2815_ = _e2113;
                                                    } else {
                                                        phi_2815_ = _e1214;
                                                    }
                                                    let _e2115 = phi_2815_;
                                                    phi_2816_ = _e2115;
                                                } else {
                                                    phi_2816_ = _e1214;
                                                }
                                                let _e2117 = phi_2816_;
                                                phi_1248_ = _e2117;
                                            } else {
                                                phi_1248_ = type_40();
                                            }
                                            let _e2119 = phi_1248_;
                                            continue;
                                            continuing {
                                                phi_1247_ = _e2119;
                                                phi_1250_ = _e1202;
                                                phi_4453_ = _e646;
                                                break if !(_e1208);
                                            }
                                        }
                                        let _e2122 = phi_4453_;
                                        phi_4653_ = _e2122;
                                        if _e2122 {
                                            break;
                                        }
                                        let _e2124 = local_10;
                                        phi_4657_ = _e2122;
                                        let _e2316 = local_13;
                                        phi_4081_ = _e2316;
                                        phi_4082_ = false;
                                        phi_4083_ = _e690;
                                        phi_4084_ = select(_e692, 0u, (_e603 > _e2124.member.member_1));
                                    } else {
                                        if (_e690.member_1 >= _e92) {
                                            phi_3617_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e690.member_1 < _e92) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e704 = (_e263 * 2u);
                                            let _e706 = ((1u + _e704) % 7u);
                                            if (_e706 < 7u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e711 = global_4.member[_e690.member_1][_e706];
                                            let _e713 = ((_e704 + 2u) % 7u);
                                            if (_e713 < 7u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e718 = global_4.member[_e690.member_1][_e713];
                                            let _e719 = (_e262 * 2u);
                                            let _e721 = ((1u + _e719) % 7u);
                                            if (_e721 < 7u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e726 = global_4.member[_e690.member_1][_e721];
                                            let _e728 = ((_e719 + 2u) % 7u);
                                            if (_e728 < 7u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e733 = global_4.member[_e690.member_1][_e728];
                                            let _e734 = (_e264 * 2u);
                                            let _e736 = ((1u + _e734) % 7u);
                                            if (_e736 < 7u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e741 = global_4.member[_e690.member_1][_e736];
                                            let _e743 = ((_e734 + 2u) % 7u);
                                            if (_e743 < 7u) {
                                            } else {
                                                phi_4653_ = true;
                                                break;
                                            }
                                            let _e748 = global_4.member[_e690.member_1][_e743];
                                            let _e771 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.x - _e690.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e772 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.y - _e690.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e773 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.z - _e690.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e775 = select(_e143, _e771, (_e771 > _e143));
                                            let _e777 = select(_e143, _e772, (_e772 > _e143));
                                            let _e779 = select(_e143, _e773, (_e773 > _e143));
                                            let _e810 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e711 & 2097151u))) - 8388608f) * _e775));
                                            let _e815 = (bitcast<i32>((_e711 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e818 = bitcast<f32>((_e810 & bitcast<u32>(_e815)));
                                            let _e819 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 2097151u))) - 8388608f) * _e777));
                                            let _e824 = (bitcast<i32>((_e726 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e827 = bitcast<f32>((_e819 & bitcast<u32>(_e824)));
                                            let _e828 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e741 & 2097151u))) - 8388608f) * _e779));
                                            let _e833 = (bitcast<i32>((_e741 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e836 = bitcast<f32>((_e828 & bitcast<u32>(_e833)));
                                            let _e840 = bitcast<f32>((_e810 & bitcast<u32>(~(_e815))));
                                            let _e844 = bitcast<f32>((_e819 & bitcast<u32>(~(_e824))));
                                            let _e848 = bitcast<f32>((_e828 & bitcast<u32>(~(_e833))));
                                            let _e849 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e718 & 2097151u))) - 8388608f) * _e775));
                                            let _e854 = (bitcast<i32>((_e718 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e857 = bitcast<f32>((_e849 & bitcast<u32>(_e854)));
                                            let _e858 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 2097151u))) - 8388608f) * _e777));
                                            let _e863 = (bitcast<i32>((_e733 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e866 = bitcast<f32>((_e858 & bitcast<u32>(_e863)));
                                            let _e867 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e748 & 2097151u))) - 8388608f) * _e779));
                                            let _e872 = (bitcast<i32>((_e748 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e875 = bitcast<f32>((_e867 & bitcast<u32>(_e872)));
                                            let _e879 = bitcast<f32>((_e849 & bitcast<u32>(~(_e854))));
                                            let _e883 = bitcast<f32>((_e858 & bitcast<u32>(~(_e863))));
                                            let _e887 = bitcast<f32>((_e867 & bitcast<u32>(~(_e872))));
                                            let _e888 = (_e690.member.member.x + _e818);
                                            let _e889 = (_e690.member.member.y + _e827);
                                            let _e890 = (_e690.member.member.z + _e836);
                                            let _e893 = (_e690.member.member_1.x - _e857);
                                            let _e894 = (_e690.member.member_1.y - _e866);
                                            let _e895 = (_e690.member.member_1.z - _e875);
                                            let _e914 = (_e893 - _e888);
                                            let _e915 = (_e894 - _e889);
                                            let _e916 = (_e895 - _e890);
                                            let _e918 = select(_e915, _e914, (_e914 > _e915));
                                            let _e920 = select(_e916, _e918, (_e918 > _e916));
                                            if (_e920 < (1024f * _e143)) {
                                                phi_3318_ = 0u;
                                            } else {
                                                phi_3318_ = select(2u, 1u, (_e920 < (2097152f * _e143)));
                                            }
                                            let _e927 = phi_3318_;
                                            switch bitcast<i32>(_e927) {
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
                                            let _e930 = phi_3324_;
                                            let _e936 = global_4.member[_e690.member_1][0u];
                                            let _e940 = global_4.member[_e690.member_1][2u];
                                            let _e944 = global_4.member[_e690.member_1][4u];
                                            let _e948 = global_4.member[_e690.member_1][6u];
                                            let _e960 = (((_e940 >> bitcast<u32>(22i)) | ((_e944 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e948 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e961 = (_e936 & 268435455u);
                                            let _e962 = (_e960 & 268435455u);
                                            let _e965 = ((_e936 >> bitcast<u32>(28u)) & 7u);
                                            let _e973 = ((_e936 >> bitcast<u32>(31i)) | (((_e960 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e974 = (_e965 != 0u);
                                            if (_e965 == 0u) {
                                                phi_3579_ = _e961;
                                            } else {
                                                if (_e965 == 7u) {
                                                    phi_3578_ = 2147483648u;
                                                } else {
                                                    phi_3578_ = ((2147483648u | (_e965 << bitcast<u32>(28u))) | (_e962 & 268435455u));
                                                }
                                                let _e983 = phi_3578_;
                                                phi_3579_ = _e983;
                                            }
                                            let _e985 = phi_3579_;
                                            if _e974 {
                                                let _e986 = (_e965 != 7u);
                                                if _e986 {
                                                    phi_3589_ = (_e962 + (_e965 * ((3u * _e930) + 1u)));
                                                } else {
                                                    phi_3589_ = u32();
                                                }
                                                let _e990 = phi_3589_;
                                                phi_3591_ = _e990;
                                                phi_3592_ = select(true, false, _e986);
                                            } else {
                                                phi_3591_ = u32();
                                                phi_3592_ = true;
                                            }
                                            let _e993 = phi_3591_;
                                            let _e995 = phi_3592_;
                                            if (_e973 == 0u) {
                                                phi_3613_ = (_e961 + select(0u, 1u, !(_e974)));
                                            } else {
                                                if (_e973 == 7u) {
                                                    phi_3612_ = 2147483648u;
                                                } else {
                                                    phi_3612_ = ((2147483648u | (_e973 << bitcast<u32>(28u))) | (select(_e993, _e962, _e995) & 268435455u));
                                                }
                                                let _e1008 = phi_3612_;
                                                phi_3613_ = _e1008;
                                            }
                                            let _e1010 = phi_3613_;
                                            phi_3617_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e888, (_e690.member.member.x + _e840), _e893, (_e690.member.member_1.x - _e879)), vec4<f32>(_e889, (_e690.member.member.y + _e844), _e894, (_e690.member.member_1.y - _e883)), vec4<f32>(_e890, (_e690.member.member.z + _e848), _e895, (_e690.member.member_1.z - _e887))), type_51(type_28((_e690.member.member + vec4<f32>(_e818, _e827, _e836, 0f)), (_e690.member.member_1 - vec4<f32>(_e857, _e866, _e875, 0f))), _e985), type_51(type_28((_e690.member.member + vec4<f32>(_e840, _e844, _e848, 0f)), (_e690.member.member_1 - vec4<f32>(_e879, _e883, _e887, 0f))), _e1010));
                                        }
                                        let _e1015 = phi_3617_;
                                        let _e1034 = ((_e1015.member[0].x - _e365) * _e368);
                                        let _e1035 = ((_e1015.member[0].y - _e365) * _e368);
                                        let _e1036 = ((_e1015.member[0].z - _e366) * _e368);
                                        let _e1037 = ((_e1015.member[0].w - _e366) * _e368);
                                        let _e1047 = ((_e1015.member[1].x - _e431) * _e434);
                                        let _e1048 = ((_e1015.member[1].y - _e431) * _e434);
                                        let _e1049 = ((_e1015.member[1].z - _e432) * _e434);
                                        let _e1050 = ((_e1015.member[1].w - _e432) * _e434);
                                        let _e1060 = ((_e1015.member[2].x - _e497) * _e500);
                                        let _e1061 = ((_e1015.member[2].y - _e497) * _e500);
                                        let _e1062 = ((_e1015.member[2].z - _e498) * _e500);
                                        let _e1063 = ((_e1015.member[2].w - _e498) * _e500);
                                        let _e1065 = select(_e1062, _e1060, (_e1060 < _e1062));
                                        let _e1067 = select(_e1063, _e1061, (_e1061 < _e1063));
                                        let _e1069 = select(_e1062, _e1060, (_e1060 > _e1062));
                                        let _e1071 = select(_e1063, _e1061, (_e1061 > _e1063));
                                        let _e1073 = select(_e1036, _e1034, (_e1034 < _e1036));
                                        let _e1075 = select(_e1037, _e1035, (_e1035 < _e1037));
                                        let _e1077 = select(_e1049, _e1047, (_e1047 < _e1049));
                                        let _e1079 = select(_e1050, _e1048, (_e1048 < _e1050));
                                        let _e1081 = select(_e1077, _e1073, (_e1073 > _e1077));
                                        let _e1083 = select(_e1079, _e1075, (_e1075 > _e1079));
                                        let _e1085 = select(_e1065, _e1081, (_e1081 > _e1065));
                                        let _e1087 = select(_e1067, _e1083, (_e1083 > _e1067));
                                        let _e1089 = select(_e1036, _e1034, (_e1034 > _e1036));
                                        let _e1091 = select(_e1037, _e1035, (_e1035 > _e1037));
                                        let _e1093 = select(_e1049, _e1047, (_e1047 > _e1049));
                                        let _e1095 = select(_e1050, _e1048, (_e1048 > _e1050));
                                        let _e1097 = select(_e1093, _e1089, (_e1089 < _e1093));
                                        let _e1099 = select(_e1095, _e1091, (_e1091 < _e1095));
                                        let _e1104 = -(_e1065);
                                        let _e1105 = -(_e1067);
                                        let _e1112 = (select(_e1069, _e1097, (_e1097 < _e1069)) + (select(_e1104, _e1069, (_e1069 > _e1104)) * 0.0000019073523f));
                                        let _e1113 = (select(_e1071, _e1099, (_e1099 < _e1071)) + (select(_e1105, _e1071, (_e1071 > _e1105)) * 0.0000019073523f));
                                        let _e1115 = select(_e603, _e1085, (_e1085 > _e603));
                                        let _e1117 = select(_e603, _e1087, (_e1087 > _e603));
                                        let _e1122 = (_e1115 <= select(_e648.member.member_1, _e1112, (_e1112 < _e648.member.member_1)));
                                        let _e1123 = (_e1117 <= select(_e648.member.member_1, _e1113, (_e1113 < _e648.member.member_1)));
                                        let _e1124 = (_e1115 <= _e1117);
                                        if _e1122 {
                                            if _e1123 {
                                                if _e1124 {
                                                    phi_3982_ = _e1015.member_2;
                                                } else {
                                                    phi_3982_ = _e1015.member_1;
                                                }
                                                let _e1128 = phi_3982_;
                                                let _e1149 = (_e692 % 128u);
                                                let _e1150 = (_e1149 < 128u);
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_8[_e1149] = _e1128.member_1;
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_7[_e1149] = _e1128.member.member.x;
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_6[_e1149] = _e1128.member.member.y;
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_5[_e1149] = _e1128.member.member.z;
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_4[_e1149] = _e1128.member.member_1.x;
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_3[_e1149] = _e1128.member.member_1.y;
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_2[_e1149] = _e1128.member.member_1.z;
                                                if _e1150 {
                                                } else {
                                                    phi_4653_ = true;
                                                    break;
                                                }
                                                local_9[_e1149] = select(_e1115, _e1117, _e1124);
                                                if _e1124 {
                                                    phi_4058_ = _e1015.member_1;
                                                } else {
                                                    phi_4058_ = _e1015.member_2;
                                                }
                                                let _e1163 = phi_4058_;
                                                phi_4059_ = _e1163;
                                                phi_4060_ = (_e692 + 1u);
                                            } else {
                                                phi_4059_ = type_51();
                                                phi_4060_ = u32();
                                            }
                                            let _e1165 = phi_4059_;
                                            let _e1167 = phi_4060_;
                                            phi_4062_ = _e1165;
                                            phi_4063_ = _e1167;
                                            phi_4064_ = select(true, false, _e1123);
                                        } else {
                                            phi_4062_ = type_51();
                                            phi_4063_ = u32();
                                            phi_4064_ = true;
                                        }
                                        let _e1170 = phi_4062_;
                                        let _e1172 = phi_4063_;
                                        let _e1174 = phi_4064_;
                                        if _e1174 {
                                            if _e1122 {
                                                phi_4073_ = _e1015.member_1;
                                            } else {
                                                phi_4073_ = _e1015.member_2;
                                            }
                                            let _e1178 = phi_4073_;
                                            phi_4078_ = select(_e1123, true, _e1122);
                                            phi_4079_ = _e1178;
                                        } else {
                                            phi_4078_ = _e688;
                                            phi_4079_ = _e1170;
                                        }
                                        let _e1181 = phi_4078_;
                                        let _e1183 = phi_4079_;
                                        phi_4657_ = _e646;
                                        phi_4081_ = type_40(_e648.member, (_e648.member_1 + 1u), _e648.member_2);
                                        phi_4082_ = _e1181;
                                        phi_4083_ = _e1183;
                                        phi_4084_ = select(_e1172, _e692, _e1174);
                                    }
                                    let _e2130 = phi_4657_;
                                    let _e2132 = phi_4081_;
                                    let _e2134 = phi_4082_;
                                    let _e2136 = phi_4083_;
                                    let _e2138 = phi_4084_;
                                    phi_4656_ = _e2130;
                                    phi_4085_ = _e2132;
                                    phi_4086_ = _e2134;
                                    phi_4087_ = _e2136;
                                    phi_4088_ = _e2138;
                                    phi_4089_ = (_e656 - 1u);
                                } else {
                                    phi_4656_ = _e646;
                                    phi_4085_ = _e648;
                                    phi_4086_ = _e688;
                                    phi_4087_ = _e690;
                                    phi_4088_ = _e692;
                                    phi_4089_ = _e656;
                                }
                                let _e2140 = phi_4656_;
                                let _e2142 = phi_4085_;
                                let _e2144 = phi_4086_;
                                let _e2146 = phi_4087_;
                                let _e2148 = phi_4088_;
                                let _e2150 = phi_4089_;
                                phi_4655_ = _e2140;
                                phi_4090_ = _e2142;
                                phi_4091_ = _e2144;
                                phi_4092_ = _e2146;
                                phi_4093_ = _e2148;
                                phi_4094_ = _e2150;
                            } else {
                                phi_4655_ = _e646;
                                phi_4090_ = type_40();
                                phi_4091_ = bool();
                                phi_4092_ = type_51();
                                phi_4093_ = u32();
                                phi_4094_ = u32();
                            }
                            let _e2152 = phi_4655_;
                            let _e2154 = phi_4090_;
                            let _e2156 = phi_4091_;
                            let _e2158 = phi_4092_;
                            let _e2160 = phi_4093_;
                            let _e2162 = phi_4094_;
                            phi_4654_ = _e2152;
                            phi_1121_ = _e2154;
                            phi_1124_ = _e2156;
                            phi_1126_ = _e2158;
                            phi_1128_ = _e2160;
                            phi_1130_ = _e2162;
                            phi_4095_ = _e660;
                        } else {
                            phi_4654_ = _e646;
                            phi_1121_ = type_40();
                            phi_1124_ = bool();
                            phi_1126_ = type_51();
                            phi_1128_ = u32();
                            phi_1130_ = u32();
                            phi_4095_ = false;
                        }
                        let _e2164 = phi_4654_;
                        let _e2166 = phi_1121_;
                        let _e2168 = phi_1124_;
                        let _e2170 = phi_1126_;
                        let _e2172 = phi_1128_;
                        let _e2174 = phi_1130_;
                        let _e2176 = phi_4095_;
                        continue;
                        continuing {
                            phi_4459_ = _e2164;
                            phi_1120_ = _e2166;
                            phi_1123_ = _e2168;
                            phi_1125_ = _e2170;
                            phi_1127_ = _e2172;
                            phi_1129_ = _e2174;
                            phi_4653_ = _e2164;
                            break if !(_e2176);
                        }
                    }
                    let _e2179 = phi_4653_;
                    if _e2179 {
                        break;
                    }
                    let _e2181 = local_11;
                    let _e2184 = local_12;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149][0u] = _e2181.member_1;
                    global_6.member[_e149][1u] = _e2184.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
