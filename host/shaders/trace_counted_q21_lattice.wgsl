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
    var phi_1113_: type_40;
    var phi_1116_: u32;
    var phi_1118_: bool;
    var phi_1120_: u32;
    var phi_1122_: type_51;
    var phi_1133_: bool;
    var phi_1219_: bool;
    var phi_1220_: u32;
    var phi_1221_: type_51;
    var phi_1240_: type_40;
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
    var phi_2784_: type_36;
    var phi_2785_: type_36;
    var phi_2788_: type_36;
    var phi_2789_: type_36;
    var phi_2790_: bool;
    var phi_2794_: type_36;
    var phi_2803_: type_24;
    var phi_2828_: bool;
    var phi_2829_: bool;
    var phi_2836_: type_40;
    var phi_2837_: type_40;
    var phi_2838_: type_40;
    var phi_1241_: type_40;
    var phi_4527_: bool;
    var phi_4830_: bool;
    var phi_2839_: type_40;
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
    var phi_4108_: type_40;
    var phi_4109_: bool;
    var phi_4110_: u32;
    var phi_4111_: type_51;
    var phi_4119_: type_40;
    var phi_4122_: type_51;
    var phi_4742_: bool;
    var phi_4123_: type_40;
    var phi_4124_: u32;
    var phi_4125_: bool;
    var phi_4126_: u32;
    var phi_4127_: type_51;
    var phi_4741_: bool;
    var phi_4128_: type_40;
    var phi_4129_: u32;
    var phi_4130_: bool;
    var phi_4131_: u32;
    var phi_4132_: type_51;
    var phi_4740_: bool;
    var phi_1114_: type_40;
    var phi_1117_: u32;
    var phi_1119_: bool;
    var phi_1121_: u32;
    var phi_1123_: type_51;
    var phi_4133_: bool;
    var phi_4739_: bool;
    var local_10: type_40;
    var local_11: type_40;
    var local_12: type_40;

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
                            phi_423_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_423_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_423_;
                        phi_424_ = _e242;
                    } else {
                        phi_424_ = 0i;
                    }
                    let _e244 = phi_424_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_434_ = true;
                    } else {
                        phi_434_ = (_e168 == _e200);
                    }
                    let _e248 = phi_434_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_444_ = _e250;
                        phi_445_ = _e250;
                        phi_447_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_444_ = u32();
                        phi_445_ = 0u;
                        phi_447_ = true;
                    }
                    let _e254 = phi_444_;
                    let _e256 = phi_445_;
                    let _e258 = phi_447_;
                    if _e258 {
                        phi_452_ = (_e256 + 1u);
                    } else {
                        phi_452_ = 0u;
                    }
                    let _e262 = phi_452_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_465_ = -126i;
                    } else {
                        phi_465_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_465_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_485_ = -126i;
                    } else {
                        phi_485_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_485_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_3.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_503_ = _e301[0];
                    } else {
                        phi_503_ = _e301[1];
                    }
                    let _e306 = phi_503_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_509_ = _e301[2];
                    } else {
                        phi_509_ = _e306;
                    }
                    let _e310 = phi_509_;
                    let _e311 = bitcast<u32>(_e310);
                    let _e313 = ((_e311 & 2139095040u) != 0u);
                    let _e327 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e311 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e311 & 2147483648u))), _e310, _e313) * _e274) * select(0.00000011920929f, 1f, _e313)) * _e280);
                    let _e328 = global_3.member[_e149].member_2;
                    if _e302 {
                        phi_549_ = _e328[0];
                    } else {
                        phi_549_ = _e328[1];
                    }
                    let _e332 = phi_549_;
                    if _e307 {
                        phi_555_ = _e328[2];
                    } else {
                        phi_555_ = _e332;
                    }
                    let _e335 = phi_555_;
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
                        phi_628_ = _e301[0];
                    } else {
                        phi_628_ = _e301[1];
                    }
                    let _e373 = phi_628_;
                    let _e374 = (_e262 == 2u);
                    if _e374 {
                        phi_634_ = _e301[2];
                    } else {
                        phi_634_ = _e373;
                    }
                    let _e377 = phi_634_;
                    let _e378 = bitcast<u32>(_e377);
                    let _e380 = ((_e378 & 2139095040u) != 0u);
                    let _e394 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e377, _e380) * _e274) * select(0.00000011920929f, 1f, _e380)) * _e280);
                    if _e369 {
                        phi_674_ = _e328[0];
                    } else {
                        phi_674_ = _e328[1];
                    }
                    let _e398 = phi_674_;
                    if _e374 {
                        phi_680_ = _e328[2];
                    } else {
                        phi_680_ = _e398;
                    }
                    let _e401 = phi_680_;
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
                        phi_753_ = _e301[0];
                    } else {
                        phi_753_ = _e301[1];
                    }
                    let _e439 = phi_753_;
                    let _e440 = (_e264 == 2u);
                    if _e440 {
                        phi_759_ = _e301[2];
                    } else {
                        phi_759_ = _e439;
                    }
                    let _e443 = phi_759_;
                    let _e444 = bitcast<u32>(_e443);
                    let _e446 = ((_e444 & 2139095040u) != 0u);
                    let _e460 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e444 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e444 & 2147483648u))), _e443, _e446) * _e274) * select(0.00000011920929f, 1f, _e446)) * _e280);
                    if _e435 {
                        phi_799_ = _e328[0];
                    } else {
                        phi_799_ = _e328[1];
                    }
                    let _e464 = phi_799_;
                    if _e440 {
                        phi_805_ = _e328[2];
                    } else {
                        phi_805_ = _e464;
                    }
                    let _e467 = phi_805_;
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
                            phi_924_ = 255i;
                        } else {
                            phi_924_ = (((_e518 + select(0i, 1i, (_e518 == 0i))) - _e525) + _e505);
                        }
                        let _e533 = phi_924_;
                        let _e543 = (_e533 <= 0i);
                        if _e543 {
                            phi_947_ = u32();
                        } else {
                            if _e522 {
                                phi_946_ = u32();
                            } else {
                                phi_946_ = select(((bitcast<u32>(_e533) << bitcast<u32>(23i)) | ((_e515 << bitcast<u32>(((_e525 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e533 >= 255i));
                            }
                            let _e547 = phi_946_;
                            phi_947_ = _e547;
                        }
                        let _e549 = phi_947_;
                        let _e561 = ((_e221 & 8388607u) | (select(0u, 1u, ((_e221 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e564 = bitcast<i32>((_e221 >> bitcast<u32>(23i)));
                        let _e568 = (_e561 == 0u);
                        let _e571 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e561)), 32u, _e568)) - 8i);
                        if (_e564 == 255i) {
                            phi_984_ = 255i;
                        } else {
                            phi_984_ = (((_e564 + select(0i, 1i, (_e564 == 0i))) - _e571) + _e505);
                        }
                        let _e579 = phi_984_;
                        let _e589 = (_e579 <= 0i);
                        if _e589 {
                            phi_1007_ = u32();
                        } else {
                            if _e568 {
                                phi_1006_ = u32();
                            } else {
                                phi_1006_ = select(((bitcast<u32>(_e579) << bitcast<u32>(23i)) | ((_e561 << bitcast<u32>(((_e571 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e579 >= 255i));
                            }
                            let _e593 = phi_1006_;
                            phi_1007_ = _e593;
                        }
                        let _e595 = phi_1007_;
                        phi_1015_ = bitcast<f32>(((_e220 & 2147483648u) | select(_e595, 0u, select(_e568, true, _e589))));
                        phi_1016_ = bitcast<f32>(((_e211 & 2147483648u) | select(_e549, 0u, select(_e522, true, _e543))));
                    } else {
                        phi_1015_ = 0f;
                        phi_1016_ = 1f;
                    }
                    let _e601 = phi_1015_;
                    let _e603 = phi_1016_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e608 = (_e263 % 3u);
                    let _e609 = (_e608 < 3u);
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e611 = local_1[_e608];
                    let _e614 = (_e262 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_1[_e614];
                    let _e620 = (_e264 % 3u);
                    let _e621 = (_e620 < 3u);
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e623 = local_1[_e620];
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e628 = local[_e608];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e632 = local[_e614];
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e636 = local[_e620];
                    phi_4533_ = false;
                    phi_1113_ = type_40(type_33(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e601), 0u, 0u);
                    phi_1116_ = ((3u * _e92) + 1u);
                    phi_1118_ = (_e603 <= _e601);
                    phi_1120_ = 0u;
                    phi_1122_ = type_51(type_28(vec4<f32>((f32(_e611) * _e143), (f32(_e617) * _e143), (f32(_e623) * _e143), 0f), vec4<f32>((f32(_e628) * _e143), (f32(_e632) * _e143), (f32(_e636) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    loop {
                        let _e646 = phi_4533_;
                        let _e648 = phi_1113_;
                        let _e650 = phi_1116_;
                        let _e652 = phi_1118_;
                        let _e654 = phi_1120_;
                        let _e656 = phi_1122_;
                        local_10 = _e648;
                        local_11 = _e648;
                        if _e652 {
                            phi_1133_ = true;
                        } else {
                            phi_1133_ = (_e654 > 0u);
                        }
                        let _e659 = phi_1133_;
                        if _e659 {
                            let _e660 = (_e650 > 0u);
                            if _e660 {
                                if _e652 {
                                    phi_1219_ = _e652;
                                    phi_1220_ = _e654;
                                    phi_1221_ = _e656;
                                } else {
                                    let _e661 = (_e654 - 1u);
                                    let _e662 = (_e661 % 128u);
                                    let _e663 = (_e662 < 128u);
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e665 = local_7[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e667 = local_6[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e669 = local_5[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e671 = local_4[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e673 = local_3[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e675 = local_2[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e680 = local_8[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4739_ = true;
                                        break;
                                    }
                                    let _e683 = local_9[_e662];
                                    phi_1219_ = (_e683 <= _e648.member.member_1);
                                    phi_1220_ = _e661;
                                    phi_1221_ = type_51(type_28(vec4<f32>(_e665, _e667, _e669, 0f), vec4<f32>(_e671, _e673, _e675, 0f)), _e680);
                                }
                                let _e688 = phi_1219_;
                                let _e690 = phi_1220_;
                                let _e692 = phi_1221_;
                                if _e688 {
                                    let _e696 = ((_e692.member_1 & 2147483648u) != 0u);
                                    let _e697 = (_e692.member_1 & 268435455u);
                                    if _e696 {
                                        phi_1240_ = _e648;
                                        phi_1243_ = type_8(0u, ((_e692.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e704 = phi_1240_;
                                            let _e706 = phi_1243_;
                                            local_12 = _e704;
                                            if (_e706.member < _e706.member_1) {
                                                phi_1244_ = type_8((_e706.member + 1u), _e706.member_1);
                                                phi_1266_ = type_8(1u, _e706.member);
                                            } else {
                                                phi_1244_ = _e706;
                                                phi_1266_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e719 = phi_1244_;
                                            let _e721 = phi_1266_;
                                            let _e725 = (bitcast<i32>(_e721.member) != 0i);
                                            if _e725 {
                                                let _e731 = type_40(_e704.member, _e704.member_1, (_e704.member_2 + 1u));
                                                let _e736 = (_e692.member.member_1.x - _e692.member.member.x);
                                                let _e739 = (_e692.member.member_1.y - _e692.member.member.y);
                                                let _e742 = (_e692.member.member_1.z - _e692.member.member.z);
                                                let _e744 = select(_e739, _e736, (_e736 > _e739));
                                                let _e746 = select(_e742, _e744, (_e744 > _e742));
                                                let _e748 = (_e746 < (1024f * _e143));
                                                if _e748 {
                                                    phi_1310_ = 0u;
                                                } else {
                                                    phi_1310_ = select(2u, 1u, (_e746 < (2097152f * _e143)));
                                                }
                                                let _e753 = phi_1310_;
                                                switch bitcast<i32>(_e753) {
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
                                                let _e756 = phi_1316_;
                                                switch bitcast<i32>(_e753) {
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
                                                let _e763 = phi_1326_;
                                                let _e765 = ((_e697 + (_e721.member_1 * ((3u * _e756) + 1u))) + (3u * _e763));
                                                let _e766 = (_e765 < _e95);
                                                if _e766 {
                                                    if _e766 {
                                                    } else {
                                                        phi_4527_ = true;
                                                        break;
                                                    }
                                                    let _e768 = global_5.member[_e765];
                                                    phi_1342_ = _e768;
                                                } else {
                                                    phi_1342_ = 4294967295u;
                                                }
                                                let _e770 = phi_1342_;
                                                if _e748 {
                                                    phi_1375_ = 0u;
                                                } else {
                                                    phi_1375_ = select(2u, 1u, (_e746 < (2097152f * _e143)));
                                                }
                                                let _e775 = phi_1375_;
                                                switch bitcast<i32>(_e775) {
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
                                                let _e778 = phi_1381_;
                                                let _e782 = (_e697 + (_e721.member_1 * ((3u * _e778) + 1u)));
                                                switch bitcast<i32>(_e775) {
                                                    case 0: {
                                                        let _e1057 = (_e782 < _e95);
                                                        if _e1057 {
                                                            if _e1057 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1059 = global_5.member[_e782];
                                                            phi_1408_ = _e1059;
                                                        } else {
                                                            phi_1408_ = 0u;
                                                        }
                                                        let _e1061 = phi_1408_;
                                                        let _e1063 = ((10u * _e263) & 31u);
                                                        let _e1073 = ((10u * _e262) & 31u);
                                                        let _e1083 = ((10u * _e264) & 31u);
                                                        let _e1093 = (_e782 + 1u);
                                                        let _e1094 = (_e1093 < _e95);
                                                        if _e1094 {
                                                            if _e1094 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1096 = global_5.member[_e1093];
                                                            phi_1457_ = _e1096;
                                                        } else {
                                                            phi_1457_ = 0u;
                                                        }
                                                        let _e1098 = phi_1457_;
                                                        let _e1124 = (_e782 + 2u);
                                                        let _e1125 = (_e1124 < _e95);
                                                        if _e1125 {
                                                            if _e1125 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1127 = global_5.member[_e1124];
                                                            phi_1506_ = _e1127;
                                                        } else {
                                                            phi_1506_ = 0u;
                                                        }
                                                        let _e1129 = phi_1506_;
                                                        phi_2007_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e143)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e143)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e143))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e143)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e143)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e143))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e143)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e143)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e143))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e871 = (_e782 < _e95);
                                                        if _e871 {
                                                            if _e871 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e873 = global_5.member[_e782];
                                                            phi_1555_ = _e873;
                                                        } else {
                                                            phi_1555_ = 0u;
                                                        }
                                                        let _e875 = phi_1555_;
                                                        let _e876 = (_e782 + 1u);
                                                        let _e877 = (_e876 < _e95);
                                                        if _e877 {
                                                            if _e877 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e879 = global_5.member[_e876];
                                                            phi_1570_ = _e879;
                                                        } else {
                                                            phi_1570_ = 0u;
                                                        }
                                                        let _e881 = phi_1570_;
                                                        let _e882 = (_e263 == 1u);
                                                        if _e882 {
                                                            phi_1580_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1580_ = (_e881 >> bitcast<u32>(10i));
                                                        }
                                                        let _e891 = phi_1580_;
                                                        let _e899 = (_e262 == 1u);
                                                        if _e899 {
                                                            phi_1601_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1601_ = (_e881 >> bitcast<u32>(10i));
                                                        }
                                                        let _e908 = phi_1601_;
                                                        let _e916 = (_e264 == 1u);
                                                        if _e916 {
                                                            phi_1622_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1622_ = (_e881 >> bitcast<u32>(10i));
                                                        }
                                                        let _e925 = phi_1622_;
                                                        let _e934 = (_e782 + 2u);
                                                        let _e935 = (_e934 < _e95);
                                                        if _e935 {
                                                            if _e935 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e937 = global_5.member[_e934];
                                                            phi_1652_ = _e937;
                                                        } else {
                                                            phi_1652_ = 0u;
                                                        }
                                                        let _e939 = phi_1652_;
                                                        let _e940 = (_e782 + 3u);
                                                        let _e941 = (_e940 < _e95);
                                                        if _e941 {
                                                            if _e941 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e943 = global_5.member[_e940];
                                                            phi_1667_ = _e943;
                                                        } else {
                                                            phi_1667_ = 0u;
                                                        }
                                                        let _e945 = phi_1667_;
                                                        if _e882 {
                                                            phi_1677_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1677_ = (_e945 >> bitcast<u32>(10i));
                                                        }
                                                        let _e954 = phi_1677_;
                                                        if _e899 {
                                                            phi_1698_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1698_ = (_e945 >> bitcast<u32>(10i));
                                                        }
                                                        let _e970 = phi_1698_;
                                                        if _e916 {
                                                            phi_1719_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1719_ = (_e945 >> bitcast<u32>(10i));
                                                        }
                                                        let _e986 = phi_1719_;
                                                        let _e995 = (_e782 + 4u);
                                                        let _e996 = (_e995 < _e95);
                                                        if _e996 {
                                                            if _e996 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e998 = global_5.member[_e995];
                                                            phi_1749_ = _e998;
                                                        } else {
                                                            phi_1749_ = 0u;
                                                        }
                                                        let _e1000 = phi_1749_;
                                                        let _e1001 = (_e782 + 5u);
                                                        let _e1002 = (_e1001 < _e95);
                                                        if _e1002 {
                                                            if _e1002 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e1004 = global_5.member[_e1001];
                                                            phi_1764_ = _e1004;
                                                        } else {
                                                            phi_1764_ = 0u;
                                                        }
                                                        let _e1006 = phi_1764_;
                                                        if _e882 {
                                                            phi_1774_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1774_ = (_e1006 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1015 = phi_1774_;
                                                        if _e899 {
                                                            phi_1795_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1795_ = (_e1006 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1031 = phi_1795_;
                                                        if _e916 {
                                                            phi_1816_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1816_ = (_e1006 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1047 = phi_1816_;
                                                        phi_2007_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e891, _e875, _e302) & 2097151u))) - 8388608f) * _e143)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e908, _e875, _e369) & 2097151u))) - 8388608f) * _e143)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e925, _e875, _e435) & 2097151u))) - 8388608f) * _e143))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e954, _e939, _e302) & 2097151u))) - 8388608f) * _e143)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e970, _e939, _e369) & 2097151u))) - 8388608f) * _e143)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e986, _e939, _e435) & 2097151u))) - 8388608f) * _e143))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1015, _e1000, _e302) & 2097151u))) - 8388608f) * _e143)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1031, _e1000, _e369) & 2097151u))) - 8388608f) * _e143)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1047, _e1000, _e435) & 2097151u))) - 8388608f) * _e143))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e784 = (_e782 + _e263);
                                                        let _e785 = (_e784 < _e95);
                                                        if _e785 {
                                                            if _e785 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e787 = global_5.member[_e784];
                                                            phi_1847_ = _e787;
                                                        } else {
                                                            phi_1847_ = 0u;
                                                        }
                                                        let _e789 = phi_1847_;
                                                        let _e793 = (_e782 + _e262);
                                                        let _e794 = (_e793 < _e95);
                                                        if _e794 {
                                                            if _e794 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e796 = global_5.member[_e793];
                                                            phi_1865_ = _e796;
                                                        } else {
                                                            phi_1865_ = 0u;
                                                        }
                                                        let _e798 = phi_1865_;
                                                        let _e802 = (_e782 + _e264);
                                                        let _e803 = (_e802 < _e95);
                                                        if _e803 {
                                                            if _e803 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e805 = global_5.member[_e802];
                                                            phi_1883_ = _e805;
                                                        } else {
                                                            phi_1883_ = 0u;
                                                        }
                                                        let _e807 = phi_1883_;
                                                        let _e812 = (_e782 + 3u);
                                                        let _e813 = (_e812 + _e263);
                                                        let _e814 = (_e813 < _e95);
                                                        if _e814 {
                                                            if _e814 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e816 = global_5.member[_e813];
                                                            phi_1906_ = _e816;
                                                        } else {
                                                            phi_1906_ = 0u;
                                                        }
                                                        let _e818 = phi_1906_;
                                                        let _e822 = (_e812 + _e262);
                                                        let _e823 = (_e822 < _e95);
                                                        if _e823 {
                                                            if _e823 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e825 = global_5.member[_e822];
                                                            phi_1924_ = _e825;
                                                        } else {
                                                            phi_1924_ = 0u;
                                                        }
                                                        let _e827 = phi_1924_;
                                                        let _e831 = (_e812 + _e264);
                                                        let _e832 = (_e831 < _e95);
                                                        if _e832 {
                                                            if _e832 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e834 = global_5.member[_e831];
                                                            phi_1942_ = _e834;
                                                        } else {
                                                            phi_1942_ = 0u;
                                                        }
                                                        let _e836 = phi_1942_;
                                                        let _e841 = (_e782 + 6u);
                                                        let _e842 = (_e841 + _e263);
                                                        let _e843 = (_e842 < _e95);
                                                        if _e843 {
                                                            if _e843 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e845 = global_5.member[_e842];
                                                            phi_1965_ = _e845;
                                                        } else {
                                                            phi_1965_ = 0u;
                                                        }
                                                        let _e847 = phi_1965_;
                                                        let _e851 = (_e841 + _e262);
                                                        let _e852 = (_e851 < _e95);
                                                        if _e852 {
                                                            if _e852 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e854 = global_5.member[_e851];
                                                            phi_1983_ = _e854;
                                                        } else {
                                                            phi_1983_ = 0u;
                                                        }
                                                        let _e856 = phi_1983_;
                                                        let _e860 = (_e841 + _e264);
                                                        let _e861 = (_e860 < _e95);
                                                        if _e861 {
                                                            if _e861 {
                                                            } else {
                                                                phi_4527_ = true;
                                                                break;
                                                            }
                                                            let _e863 = global_5.member[_e860];
                                                            phi_2001_ = _e863;
                                                        } else {
                                                            phi_2001_ = 0u;
                                                        }
                                                        let _e865 = phi_2001_;
                                                        phi_2007_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e789)) * _e143), (f32(bitcast<i32>(_e798)) * _e143), (f32(bitcast<i32>(_e807)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e818)) * _e143), (f32(bitcast<i32>(_e827)) * _e143), (f32(bitcast<i32>(_e836)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e847)) * _e143), (f32(bitcast<i32>(_e856)) * _e143), (f32(bitcast<i32>(_e865)) * _e143)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2007_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1157 = phi_2007_;
                                                let _e1174 = (_e1157[0][2] - _e460);
                                                let _e1177 = (((_e1157[0][0] - _e327) * _e496) - (_e1174 * _e364));
                                                let _e1180 = (((_e1157[0][1] - _e394) * _e496) - (_e1174 * _e430));
                                                let _e1183 = (_e1157[1][2] - _e460);
                                                let _e1186 = (((_e1157[1][0] - _e327) * _e496) - (_e1183 * _e364));
                                                let _e1189 = (((_e1157[1][1] - _e394) * _e496) - (_e1183 * _e430));
                                                let _e1192 = (_e1157[2][2] - _e460);
                                                let _e1195 = (((_e1157[2][0] - _e327) * _e496) - (_e1192 * _e364));
                                                let _e1198 = (((_e1157[2][1] - _e394) * _e496) - (_e1192 * _e430));
                                                let _e1199 = (_e1195 * _e1189);
                                                let _e1200 = (_e1198 * _e1186);
                                                let _e1201 = (_e1177 * _e1198);
                                                let _e1202 = (_e1180 * _e1195);
                                                let _e1203 = (_e1186 * _e1180);
                                                let _e1204 = (_e1189 * _e1177);
                                                let _e1209 = (((_e1199 >= _e1200) && (_e1201 >= _e1202)) && (_e1203 >= _e1204));
                                                let _e1215 = (_e1209 || (((_e1199 <= _e1200) && (_e1201 <= _e1202)) && (_e1203 <= _e1204)));
                                                if _e1215 {
                                                    let _e1217 = select(-1f, 1f, _e1209);
                                                    let _e1219 = ((_e1199 - _e1200) * _e1217);
                                                    let _e1221 = select(0f, _e1219, (_e1219 > 0f));
                                                    let _e1223 = ((_e1201 - _e1202) * _e1217);
                                                    let _e1225 = select(0f, _e1223, (_e1223 > 0f));
                                                    let _e1227 = ((_e1203 - _e1204) * _e1217);
                                                    let _e1229 = select(0f, _e1227, (_e1227 > 0f));
                                                    let _e1231 = ((_e1221 + _e1225) + _e1229);
                                                    let _e1233 = select(_e1157[1][0], _e1157[0][0], (_e1157[0][0] < _e1157[1][0]));
                                                    let _e1237 = select(_e1157[1][0], _e1157[0][0], (_e1157[0][0] > _e1157[1][0]));
                                                    let _e1241 = select(_e1157[1][1], _e1157[0][1], (_e1157[0][1] < _e1157[1][1]));
                                                    let _e1245 = select(_e1157[1][1], _e1157[0][1], (_e1157[0][1] > _e1157[1][1]));
                                                    let _e1249 = select(_e1157[1][2], _e1157[0][2], (_e1157[0][2] < _e1157[1][2]));
                                                    let _e1253 = select(_e1157[1][2], _e1157[0][2], (_e1157[0][2] > _e1157[1][2]));
                                                    let _e1258 = ((select(_e1157[2][0], _e1233, (_e1233 < _e1157[2][0])) - _e365) * _e368);
                                                    let _e1259 = ((select(_e1157[2][0], _e1237, (_e1237 > _e1157[2][0])) - _e366) * _e368);
                                                    let _e1262 = ((select(_e1157[2][1], _e1241, (_e1241 < _e1157[2][1])) - _e431) * _e434);
                                                    let _e1263 = ((select(_e1157[2][1], _e1245, (_e1245 > _e1157[2][1])) - _e432) * _e434);
                                                    let _e1266 = ((select(_e1157[2][2], _e1249, (_e1249 < _e1157[2][2])) - _e497) * _e500);
                                                    let _e1267 = ((select(_e1157[2][2], _e1253, (_e1253 > _e1157[2][2])) - _e498) * _e500);
                                                    let _e1269 = select(_e1267, _e1266, (_e1266 < _e1267));
                                                    let _e1271 = select(_e1267, _e1266, (_e1266 > _e1267));
                                                    let _e1273 = select(_e1259, _e1258, (_e1258 < _e1259));
                                                    let _e1275 = select(_e1263, _e1262, (_e1262 < _e1263));
                                                    let _e1277 = select(_e1275, _e1273, (_e1273 > _e1275));
                                                    let _e1279 = select(_e1269, _e1277, (_e1277 > _e1269));
                                                    let _e1281 = select(_e1259, _e1258, (_e1258 > _e1259));
                                                    let _e1283 = select(_e1263, _e1262, (_e1262 > _e1263));
                                                    let _e1285 = select(_e1283, _e1281, (_e1281 < _e1283));
                                                    let _e1287 = select(_e1271, _e1285, (_e1285 < _e1271));
                                                    let _e1288 = -(_e1269);
                                                    let _e1294 = select(_e603, _e1279, (_e1279 > _e603));
                                                    let _e1298 = select(_e1186, _e1177, (_e1177 < _e1186));
                                                    let _e1303 = select(_e1186, _e1177, (_e1177 > _e1186));
                                                    let _e1310 = select(_e1189, _e1180, (_e1180 < _e1189));
                                                    let _e1315 = select(_e1189, _e1180, (_e1180 > _e1189));
                                                    let _e1324 = (((((_e1215 && (_e1231 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1195, _e1298, (_e1298 < _e1195)) <= 0f) && (select(_e1195, _e1303, (_e1303 > _e1195)) >= 0f))) && ((select(_e1198, _e1310, (_e1310 < _e1198)) <= 0f) && (select(_e1198, _e1315, (_e1315 > _e1198)) >= 0f))) && (_e1294 <= (_e1287 + (select(_e1288, _e1271, (_e1271 > _e1288)) * 0.0000019073523f)))) && (_e1294 <= _e704.member.member_1));
                                                    if _e1324 {
                                                        let _e1329 = (_e1157[1][0] - _e1157[0][0]);
                                                        let _e1330 = (_e1157[1][1] - _e1157[0][1]);
                                                        let _e1331 = (_e1157[1][2] - _e1157[0][2]);
                                                        let _e1332 = vec3<f32>(_e1329, _e1330, _e1331);
                                                        let _e1333 = (_e1157[2][0] - _e1157[1][0]);
                                                        let _e1334 = (_e1157[2][1] - _e1157[1][1]);
                                                        let _e1335 = (_e1157[2][2] - _e1157[1][2]);
                                                        let _e1336 = vec3<f32>(_e1333, _e1334, _e1335);
                                                        let _e1337 = (_e1157[0][0] - _e1157[2][0]);
                                                        let _e1338 = (_e1157[0][1] - _e1157[2][1]);
                                                        let _e1339 = (_e1157[0][2] - _e1157[2][2]);
                                                        let _e1340 = vec3<f32>(_e1337, _e1338, _e1339);
                                                        let _e1341 = abs(_e1329);
                                                        let _e1342 = abs(_e1330);
                                                        if (_e1341 != _e1341) {
                                                            phi_4168_ = true;
                                                        } else {
                                                            phi_4168_ = (_e1342 >= _e1341);
                                                        }
                                                        let _e1346 = phi_4168_;
                                                        let _e1347 = select(_e1341, _e1342, _e1346);
                                                        let _e1348 = abs(_e1331);
                                                        if (_e1347 != _e1347) {
                                                            phi_4183_ = true;
                                                        } else {
                                                            phi_4183_ = (_e1348 >= _e1347);
                                                        }
                                                        let _e1352 = phi_4183_;
                                                        let _e1353 = select(_e1347, _e1348, _e1352);
                                                        let _e1354 = abs(_e1333);
                                                        let _e1355 = abs(_e1334);
                                                        if (_e1354 != _e1354) {
                                                            phi_4198_ = true;
                                                        } else {
                                                            phi_4198_ = (_e1355 >= _e1354);
                                                        }
                                                        let _e1359 = phi_4198_;
                                                        let _e1360 = select(_e1354, _e1355, _e1359);
                                                        let _e1361 = abs(_e1335);
                                                        if (_e1360 != _e1360) {
                                                            phi_4213_ = true;
                                                        } else {
                                                            phi_4213_ = (_e1361 >= _e1360);
                                                        }
                                                        let _e1365 = phi_4213_;
                                                        let _e1366 = select(_e1360, _e1361, _e1365);
                                                        let _e1367 = abs(_e1337);
                                                        let _e1368 = abs(_e1338);
                                                        if (_e1367 != _e1367) {
                                                            phi_4228_ = true;
                                                        } else {
                                                            phi_4228_ = (_e1368 >= _e1367);
                                                        }
                                                        let _e1372 = phi_4228_;
                                                        let _e1373 = select(_e1367, _e1368, _e1372);
                                                        let _e1374 = abs(_e1339);
                                                        if (_e1373 != _e1373) {
                                                            phi_4243_ = true;
                                                        } else {
                                                            phi_4243_ = (_e1374 >= _e1373);
                                                        }
                                                        let _e1378 = phi_4243_;
                                                        let _e1379 = select(_e1373, _e1374, _e1378);
                                                        let _e1381 = select(_e1366, _e1353, (_e1353 > _e1366));
                                                        let _e1383 = select(_e1379, _e1381, (_e1381 > _e1379));
                                                        if (_e1353 == _e1383) {
                                                            phi_2549_ = _e1189;
                                                            phi_2550_ = _e1186;
                                                            phi_2551_ = _e1180;
                                                            phi_2552_ = _e1177;
                                                            phi_2553_ = vec3<f32>(_e1157[0][0], _e1157[0][1], _e1157[0][2]);
                                                            phi_2554_ = _e1340;
                                                            phi_2555_ = _e1336;
                                                            phi_2556_ = _e1332;
                                                        } else {
                                                            let _e1385 = (_e1366 == _e1383);
                                                            let _e1390 = vec3(_e1385);
                                                            phi_2549_ = select(_e1180, _e1198, _e1385);
                                                            phi_2550_ = select(_e1177, _e1195, _e1385);
                                                            phi_2551_ = select(_e1198, _e1189, _e1385);
                                                            phi_2552_ = select(_e1195, _e1186, _e1385);
                                                            phi_2553_ = select(vec3<f32>(_e1157[2][0], _e1157[2][1], _e1157[2][2]), vec3<f32>(_e1157[1][0], _e1157[1][1], _e1157[1][2]), _e1390);
                                                            phi_2554_ = select(_e1336, _e1332, _e1390);
                                                            phi_2555_ = select(_e1332, _e1340, _e1390);
                                                            phi_2556_ = select(_e1340, _e1336, _e1390);
                                                        }
                                                        let _e1396 = phi_2549_;
                                                        let _e1398 = phi_2550_;
                                                        let _e1400 = phi_2551_;
                                                        let _e1402 = phi_2552_;
                                                        let _e1404 = phi_2553_;
                                                        let _e1406 = phi_2554_;
                                                        let _e1408 = phi_2555_;
                                                        let _e1410 = phi_2556_;
                                                        let _e1417 = ((_e1408.y * _e1406.z) - (_e1406.y * _e1408.z));
                                                        let _e1422 = ((_e1408.z * _e1406.x) - (_e1406.z * _e1408.x));
                                                        let _e1425 = ((_e1408.x * _e1406.y) - (_e1406.x * _e1408.y));
                                                        let _e1428 = ((_e1221 >= _e1225) && (_e1221 >= _e1229));
                                                        let _e1429 = (_e1225 >= _e1229);
                                                        let _e1443 = (((_e1417 * (select(select(_e1157[2][0], _e1157[1][0], _e1429), _e1157[0][0], _e1428) - _e327)) + (_e1422 * (select(select(_e1157[2][1], _e1157[1][1], _e1429), _e1157[0][1], _e1428) - _e394))) + (_e1425 * (select(select(_e1157[2][2], _e1157[1][2], _e1429), _e1157[0][2], _e1428) - _e460)));
                                                        let _e1448 = (((_e1417 * _e364) + (_e1422 * _e430)) + (_e1425 * _e496));
                                                        let _e1449 = (_e1398 - _e1402);
                                                        let _e1450 = (_e1396 - _e1400);
                                                        let _e1453 = ((_e1449 * _e1449) + (_e1450 * _e1450));
                                                        let _e1460 = (-(((_e1402 * _e1449) + (_e1400 * _e1450))) / select(0.000000000000000000000000000000000000011754944f, _e1453, (_e1453 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1462 = select(1f, _e1460, (_e1460 < 1f));
                                                        let _e1464 = select(0f, _e1462, (_e1462 > 0f));
                                                        let _e1473 = ((_e1404.x + (_e1410.x * _e1464)) - _e327);
                                                        let _e1476 = ((_e1404.y + (_e1410.y * _e1464)) - _e394);
                                                        let _e1479 = ((_e1404.z + (_e1410.z * _e1464)) - _e460);
                                                        let _e1482 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                        let _e1485 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                        let _e1487 = select(_e1485, _e1482, (_e1482 > _e1485));
                                                        let _e1490 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                        let _e1492 = select(_e1490, _e1487, (_e1487 > _e1490));
                                                        let _e1496 = abs(_e1417);
                                                        let _e1497 = abs(_e1422);
                                                        if (_e1496 != _e1496) {
                                                            phi_4258_ = true;
                                                        } else {
                                                            phi_4258_ = (_e1497 >= _e1496);
                                                        }
                                                        let _e1501 = phi_4258_;
                                                        let _e1502 = select(_e1496, _e1497, _e1501);
                                                        let _e1503 = abs(_e1425);
                                                        if (_e1502 != _e1502) {
                                                            phi_4273_ = true;
                                                        } else {
                                                            phi_4273_ = (_e1503 >= _e1502);
                                                        }
                                                        let _e1507 = phi_4273_;
                                                        let _e1523 = abs(_e1408.x);
                                                        let _e1524 = abs(_e1408.y);
                                                        if (_e1523 != _e1523) {
                                                            phi_4288_ = true;
                                                        } else {
                                                            phi_4288_ = (_e1524 >= _e1523);
                                                        }
                                                        let _e1528 = phi_4288_;
                                                        let _e1529 = select(_e1523, _e1524, _e1528);
                                                        let _e1530 = abs(_e1408.z);
                                                        if (_e1529 != _e1529) {
                                                            phi_4303_ = true;
                                                        } else {
                                                            phi_4303_ = (_e1530 >= _e1529);
                                                        }
                                                        let _e1534 = phi_4303_;
                                                        let _e1537 = abs(_e1406.x);
                                                        let _e1538 = abs(_e1406.y);
                                                        if (_e1537 != _e1537) {
                                                            phi_4318_ = true;
                                                        } else {
                                                            phi_4318_ = (_e1538 >= _e1537);
                                                        }
                                                        let _e1542 = phi_4318_;
                                                        let _e1543 = select(_e1537, _e1538, _e1542);
                                                        let _e1544 = abs(_e1406.z);
                                                        if (_e1543 != _e1543) {
                                                            phi_4333_ = true;
                                                        } else {
                                                            phi_4333_ = (_e1544 >= _e1543);
                                                        }
                                                        let _e1548 = phi_4333_;
                                                        let _e1553 = ((bitcast<f32>((bitcast<u32>(((((_e1417 * _e1473) + (_e1422 * _e1476)) + (_e1425 * _e1479)) - _e1443)) & 2147483647u)) <= ((0.0000009536743f * select(_e1383, _e1492, (_e1492 > _e1383))) * select(_e1502, _e1503, _e1507))) && !((bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u)) <= ((0.0000038146973f * select(_e1529, _e1530, _e1534)) * select(_e1543, _e1544, _e1548)))));
                                                        let _e1554 = (_e1443 / _e1448);
                                                        if (_e1324 && !(_e1553)) {
                                                            let _e1557 = (_e1479 / _e496);
                                                            let _e1565 = (((_e1417 * (_e1473 - (_e364 * _e1557))) + (_e1422 * (_e1476 - (_e430 * _e1557)))) / _e1448);
                                                            phi_2764_ = select(select(_e1557, (_e1557 + _e1565), (bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u)) <= _e1383)), _e1554, _e1553);
                                                        } else {
                                                            phi_2764_ = _e1554;
                                                        }
                                                        let _e1574 = phi_2764_;
                                                        let _e1576 = select(_e1287, _e1574, (_e1574 < _e1287));
                                                        let _e1578 = select(_e1279, _e1576, (_e1576 > _e1279));
                                                        let _e1579 = (1f / _e1231);
                                                        phi_2784_ = type_36(_e1578, (_e1225 * _e1579), (_e1229 * _e1579), ((_e1324 && (_e1578 >= _e603)) && (_e1578 <= _e704.member.member_1)));
                                                        phi_2785_ = type_36();
                                                    } else {
                                                        phi_2784_ = type_36();
                                                        phi_2785_ = type_36(0f, 0f, 0f, _e1324);
                                                    }
                                                    let _e1588 = phi_2784_;
                                                    let _e1590 = phi_2785_;
                                                    phi_2788_ = _e1588;
                                                    phi_2789_ = _e1590;
                                                    phi_2790_ = select(true, false, _e1324);
                                                } else {
                                                    phi_2788_ = type_36();
                                                    phi_2789_ = type_36(0f, 0f, 0f, _e1215);
                                                    phi_2790_ = true;
                                                }
                                                let _e1593 = phi_2788_;
                                                let _e1595 = phi_2789_;
                                                let _e1597 = phi_2790_;
                                                if _e1597 {
                                                    phi_2794_ = _e1595;
                                                } else {
                                                    phi_2794_ = _e1593;
                                                }
                                                let _e1599 = phi_2794_;
                                                if _e1599.member_3 {
                                                    phi_2803_ = type_24(_e1599.member, _e1599.member_1, _e1599.member_2, _e770);
                                                } else {
                                                    phi_2803_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1606 = phi_2803_;
                                                if (_e1606.member_3 != 4294967295u) {
                                                    if (_e770 != 4294967295u) {
                                                        if (_e1606.member < _e704.member.member.member) {
                                                            phi_2829_ = true;
                                                        } else {
                                                            if (_e1606.member == _e704.member.member.member) {
                                                                phi_2828_ = (_e1606.member_3 < _e704.member.member.member_3);
                                                            } else {
                                                                phi_2828_ = false;
                                                            }
                                                            let _e1621 = phi_2828_;
                                                            phi_2829_ = _e1621;
                                                        }
                                                        let _e1623 = phi_2829_;
                                                        if _e1623 {
                                                            phi_2836_ = type_40(type_33(_e1606, _e1606.member), _e731.member_1, _e731.member_2);
                                                        } else {
                                                            phi_2836_ = _e731;
                                                        }
                                                        let _e1630 = phi_2836_;
                                                        phi_2837_ = _e1630;
                                                    } else {
                                                        phi_2837_ = _e731;
                                                    }
                                                    let _e1632 = phi_2837_;
                                                    phi_2838_ = _e1632;
                                                } else {
                                                    phi_2838_ = _e731;
                                                }
                                                let _e1634 = phi_2838_;
                                                phi_1241_ = _e1634;
                                            } else {
                                                phi_1241_ = type_40();
                                            }
                                            let _e1636 = phi_1241_;
                                            continue;
                                            continuing {
                                                phi_1240_ = _e1636;
                                                phi_1243_ = _e719;
                                                phi_4527_ = _e646;
                                                break if !(_e725);
                                            }
                                        }
                                        let _e1639 = phi_4527_;
                                        phi_4739_ = _e1639;
                                        if _e1639 {
                                            break;
                                        }
                                        phi_4830_ = _e1639;
                                        let _e2309 = local_12;
                                        phi_2839_ = _e2309;
                                    } else {
                                        phi_4830_ = _e646;
                                        phi_2839_ = _e648;
                                    }
                                    let _e1641 = phi_4830_;
                                    let _e1643 = phi_2839_;
                                    if _e696 {
                                        phi_4108_ = type_40();
                                        phi_4109_ = bool();
                                        phi_4110_ = u32();
                                        phi_4111_ = type_51();
                                    } else {
                                        if (_e692.member_1 >= _e92) {
                                            phi_3640_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e692.member_1 < _e92) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1646 = (_e263 * 2u);
                                            let _e1648 = ((1u + _e1646) % 7u);
                                            if (_e1648 < 7u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1653 = global_4.member[_e692.member_1][_e1648];
                                            let _e1655 = ((_e1646 + 2u) % 7u);
                                            if (_e1655 < 7u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1660 = global_4.member[_e692.member_1][_e1655];
                                            let _e1661 = (_e262 * 2u);
                                            let _e1663 = ((1u + _e1661) % 7u);
                                            if (_e1663 < 7u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1668 = global_4.member[_e692.member_1][_e1663];
                                            let _e1670 = ((_e1661 + 2u) % 7u);
                                            if (_e1670 < 7u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1675 = global_4.member[_e692.member_1][_e1670];
                                            let _e1676 = (_e264 * 2u);
                                            let _e1678 = ((1u + _e1676) % 7u);
                                            if (_e1678 < 7u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1683 = global_4.member[_e692.member_1][_e1678];
                                            let _e1685 = ((_e1676 + 2u) % 7u);
                                            if (_e1685 < 7u) {
                                            } else {
                                                phi_4739_ = true;
                                                break;
                                            }
                                            let _e1690 = global_4.member[_e692.member_1][_e1685];
                                            let _e1713 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.x - _e692.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1714 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.y - _e692.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1715 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.z - _e692.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1717 = select(_e143, _e1713, (_e1713 > _e143));
                                            let _e1719 = select(_e143, _e1714, (_e1714 > _e143));
                                            let _e1721 = select(_e143, _e1715, (_e1715 > _e143));
                                            let _e1752 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1653 & 2097151u))) - 8388608f) * _e1717));
                                            let _e1757 = (bitcast<i32>((_e1653 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1760 = bitcast<f32>((_e1752 & bitcast<u32>(_e1757)));
                                            let _e1761 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1668 & 2097151u))) - 8388608f) * _e1719));
                                            let _e1766 = (bitcast<i32>((_e1668 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1769 = bitcast<f32>((_e1761 & bitcast<u32>(_e1766)));
                                            let _e1770 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1683 & 2097151u))) - 8388608f) * _e1721));
                                            let _e1775 = (bitcast<i32>((_e1683 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1778 = bitcast<f32>((_e1770 & bitcast<u32>(_e1775)));
                                            let _e1782 = bitcast<f32>((_e1752 & bitcast<u32>(~(_e1757))));
                                            let _e1786 = bitcast<f32>((_e1761 & bitcast<u32>(~(_e1766))));
                                            let _e1790 = bitcast<f32>((_e1770 & bitcast<u32>(~(_e1775))));
                                            let _e1791 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1660 & 2097151u))) - 8388608f) * _e1717));
                                            let _e1796 = (bitcast<i32>((_e1660 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1799 = bitcast<f32>((_e1791 & bitcast<u32>(_e1796)));
                                            let _e1800 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1675 & 2097151u))) - 8388608f) * _e1719));
                                            let _e1805 = (bitcast<i32>((_e1675 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1808 = bitcast<f32>((_e1800 & bitcast<u32>(_e1805)));
                                            let _e1809 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1690 & 2097151u))) - 8388608f) * _e1721));
                                            let _e1814 = (bitcast<i32>((_e1690 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1817 = bitcast<f32>((_e1809 & bitcast<u32>(_e1814)));
                                            let _e1821 = bitcast<f32>((_e1791 & bitcast<u32>(~(_e1796))));
                                            let _e1825 = bitcast<f32>((_e1800 & bitcast<u32>(~(_e1805))));
                                            let _e1829 = bitcast<f32>((_e1809 & bitcast<u32>(~(_e1814))));
                                            let _e1830 = (_e692.member.member.x + _e1760);
                                            let _e1831 = (_e692.member.member.y + _e1769);
                                            let _e1832 = (_e692.member.member.z + _e1778);
                                            let _e1835 = (_e692.member.member_1.x - _e1799);
                                            let _e1836 = (_e692.member.member_1.y - _e1808);
                                            let _e1837 = (_e692.member.member_1.z - _e1817);
                                            let _e1856 = (_e1835 - _e1830);
                                            let _e1857 = (_e1836 - _e1831);
                                            let _e1858 = (_e1837 - _e1832);
                                            let _e1860 = select(_e1857, _e1856, (_e1856 > _e1857));
                                            let _e1862 = select(_e1858, _e1860, (_e1860 > _e1858));
                                            if (_e1862 < (1024f * _e143)) {
                                                phi_3341_ = 0u;
                                            } else {
                                                phi_3341_ = select(2u, 1u, (_e1862 < (2097152f * _e143)));
                                            }
                                            let _e1869 = phi_3341_;
                                            switch bitcast<i32>(_e1869) {
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
                                            let _e1872 = phi_3347_;
                                            let _e1878 = global_4.member[_e692.member_1][0u];
                                            let _e1882 = global_4.member[_e692.member_1][2u];
                                            let _e1886 = global_4.member[_e692.member_1][4u];
                                            let _e1890 = global_4.member[_e692.member_1][6u];
                                            let _e1902 = (((_e1882 >> bitcast<u32>(22i)) | ((_e1886 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1890 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1903 = (_e1878 & 268435455u);
                                            let _e1904 = (_e1902 & 268435455u);
                                            let _e1907 = ((_e1878 >> bitcast<u32>(28u)) & 7u);
                                            let _e1915 = ((_e1878 >> bitcast<u32>(31i)) | (((_e1902 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1916 = (_e1907 != 0u);
                                            if (_e1907 == 0u) {
                                                phi_3602_ = _e1903;
                                            } else {
                                                if (_e1907 == 7u) {
                                                    phi_3601_ = 2147483648u;
                                                } else {
                                                    phi_3601_ = ((2147483648u | (_e1907 << bitcast<u32>(28u))) | (_e1904 & 268435455u));
                                                }
                                                let _e1925 = phi_3601_;
                                                phi_3602_ = _e1925;
                                            }
                                            let _e1927 = phi_3602_;
                                            if _e1916 {
                                                let _e1928 = (_e1907 != 7u);
                                                if _e1928 {
                                                    phi_3612_ = (_e1904 + (_e1907 * ((3u * _e1872) + 1u)));
                                                } else {
                                                    phi_3612_ = u32();
                                                }
                                                let _e1932 = phi_3612_;
                                                phi_3614_ = _e1932;
                                                phi_3615_ = select(true, false, _e1928);
                                            } else {
                                                phi_3614_ = u32();
                                                phi_3615_ = true;
                                            }
                                            let _e1935 = phi_3614_;
                                            let _e1937 = phi_3615_;
                                            if (_e1915 == 0u) {
                                                phi_3636_ = (_e1903 + select(0u, 1u, !(_e1916)));
                                            } else {
                                                if (_e1915 == 7u) {
                                                    phi_3635_ = 2147483648u;
                                                } else {
                                                    phi_3635_ = ((2147483648u | (_e1915 << bitcast<u32>(28u))) | (select(_e1935, _e1904, _e1937) & 268435455u));
                                                }
                                                let _e1950 = phi_3635_;
                                                phi_3636_ = _e1950;
                                            }
                                            let _e1952 = phi_3636_;
                                            phi_3640_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e1830, (_e692.member.member.x + _e1782), _e1835, (_e692.member.member_1.x - _e1821)), vec4<f32>(_e1831, (_e692.member.member.y + _e1786), _e1836, (_e692.member.member_1.y - _e1825)), vec4<f32>(_e1832, (_e692.member.member.z + _e1790), _e1837, (_e692.member.member_1.z - _e1829))), type_51(type_28((_e692.member.member + vec4<f32>(_e1760, _e1769, _e1778, 0f)), (_e692.member.member_1 - vec4<f32>(_e1799, _e1808, _e1817, 0f))), _e1927), type_51(type_28((_e692.member.member + vec4<f32>(_e1782, _e1786, _e1790, 0f)), (_e692.member.member_1 - vec4<f32>(_e1821, _e1825, _e1829, 0f))), _e1952));
                                        }
                                        let _e1957 = phi_3640_;
                                        let _e1976 = ((_e1957.member[0].x - _e365) * _e368);
                                        let _e1977 = ((_e1957.member[0].y - _e365) * _e368);
                                        let _e1978 = ((_e1957.member[0].z - _e366) * _e368);
                                        let _e1979 = ((_e1957.member[0].w - _e366) * _e368);
                                        let _e1989 = ((_e1957.member[1].x - _e431) * _e434);
                                        let _e1990 = ((_e1957.member[1].y - _e431) * _e434);
                                        let _e1991 = ((_e1957.member[1].z - _e432) * _e434);
                                        let _e1992 = ((_e1957.member[1].w - _e432) * _e434);
                                        let _e2002 = ((_e1957.member[2].x - _e497) * _e500);
                                        let _e2003 = ((_e1957.member[2].y - _e497) * _e500);
                                        let _e2004 = ((_e1957.member[2].z - _e498) * _e500);
                                        let _e2005 = ((_e1957.member[2].w - _e498) * _e500);
                                        let _e2007 = select(_e2004, _e2002, (_e2002 < _e2004));
                                        let _e2009 = select(_e2005, _e2003, (_e2003 < _e2005));
                                        let _e2011 = select(_e2004, _e2002, (_e2002 > _e2004));
                                        let _e2013 = select(_e2005, _e2003, (_e2003 > _e2005));
                                        let _e2015 = select(_e1978, _e1976, (_e1976 < _e1978));
                                        let _e2017 = select(_e1979, _e1977, (_e1977 < _e1979));
                                        let _e2019 = select(_e1991, _e1989, (_e1989 < _e1991));
                                        let _e2021 = select(_e1992, _e1990, (_e1990 < _e1992));
                                        let _e2023 = select(_e2019, _e2015, (_e2015 > _e2019));
                                        let _e2025 = select(_e2021, _e2017, (_e2017 > _e2021));
                                        let _e2027 = select(_e2007, _e2023, (_e2023 > _e2007));
                                        let _e2029 = select(_e2009, _e2025, (_e2025 > _e2009));
                                        let _e2031 = select(_e1978, _e1976, (_e1976 > _e1978));
                                        let _e2033 = select(_e1979, _e1977, (_e1977 > _e1979));
                                        let _e2035 = select(_e1991, _e1989, (_e1989 > _e1991));
                                        let _e2037 = select(_e1992, _e1990, (_e1990 > _e1992));
                                        let _e2039 = select(_e2035, _e2031, (_e2031 < _e2035));
                                        let _e2041 = select(_e2037, _e2033, (_e2033 < _e2037));
                                        let _e2046 = -(_e2007);
                                        let _e2047 = -(_e2009);
                                        let _e2054 = (select(_e2011, _e2039, (_e2039 < _e2011)) + (select(_e2046, _e2011, (_e2011 > _e2046)) * 0.0000019073523f));
                                        let _e2055 = (select(_e2013, _e2041, (_e2041 < _e2013)) + (select(_e2047, _e2013, (_e2013 > _e2047)) * 0.0000019073523f));
                                        let _e2057 = select(_e603, _e2027, (_e2027 > _e603));
                                        let _e2059 = select(_e603, _e2029, (_e2029 > _e603));
                                        let _e2064 = (_e2057 <= select(_e1643.member.member_1, _e2054, (_e2054 < _e1643.member.member_1)));
                                        let _e2065 = (_e2059 <= select(_e1643.member.member_1, _e2055, (_e2055 < _e1643.member.member_1)));
                                        let _e2066 = (_e2057 <= _e2059);
                                        if _e2064 {
                                            if _e2065 {
                                                if _e2066 {
                                                    phi_4005_ = _e1957.member_2;
                                                } else {
                                                    phi_4005_ = _e1957.member_1;
                                                }
                                                let _e2070 = phi_4005_;
                                                let _e2091 = (_e690 % 128u);
                                                let _e2092 = (_e2091 < 128u);
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_8[_e2091] = _e2070.member_1;
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_7[_e2091] = _e2070.member.member.x;
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_6[_e2091] = _e2070.member.member.y;
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_5[_e2091] = _e2070.member.member.z;
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_4[_e2091] = _e2070.member.member_1.x;
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_3[_e2091] = _e2070.member.member_1.y;
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_2[_e2091] = _e2070.member.member_1.z;
                                                if _e2092 {
                                                } else {
                                                    phi_4739_ = true;
                                                    break;
                                                }
                                                local_9[_e2091] = select(_e2057, _e2059, _e2066);
                                                if _e2066 {
                                                    phi_4081_ = _e1957.member_1;
                                                } else {
                                                    phi_4081_ = _e1957.member_2;
                                                }
                                                let _e2105 = phi_4081_;
                                                phi_4082_ = (_e690 + 1u);
                                                phi_4083_ = _e2105;
                                            } else {
                                                phi_4082_ = u32();
                                                phi_4083_ = type_51();
                                            }
                                            let _e2107 = phi_4082_;
                                            let _e2109 = phi_4083_;
                                            phi_4085_ = _e2107;
                                            phi_4086_ = _e2109;
                                            phi_4087_ = select(true, false, _e2065);
                                        } else {
                                            phi_4085_ = u32();
                                            phi_4086_ = type_51();
                                            phi_4087_ = true;
                                        }
                                        let _e2112 = phi_4085_;
                                        let _e2114 = phi_4086_;
                                        let _e2116 = phi_4087_;
                                        if _e2116 {
                                            if _e2064 {
                                                phi_4096_ = _e1957.member_1;
                                            } else {
                                                phi_4096_ = _e1957.member_2;
                                            }
                                            let _e2120 = phi_4096_;
                                            phi_4101_ = select(_e2065, true, _e2064);
                                            phi_4103_ = _e2120;
                                        } else {
                                            phi_4101_ = _e688;
                                            phi_4103_ = _e2114;
                                        }
                                        let _e2123 = phi_4101_;
                                        let _e2125 = phi_4103_;
                                        phi_4108_ = type_40(_e1643.member, (_e1643.member_1 + 1u), _e1643.member_2);
                                        phi_4109_ = _e2123;
                                        phi_4110_ = select(_e2112, _e690, _e2116);
                                        phi_4111_ = _e2125;
                                    }
                                    let _e2128 = phi_4108_;
                                    let _e2130 = phi_4109_;
                                    let _e2132 = phi_4110_;
                                    let _e2134 = phi_4111_;
                                    if _e696 {
                                        phi_4119_ = _e1643;
                                        phi_4122_ = _e692;
                                    } else {
                                        phi_4119_ = _e2128;
                                        phi_4122_ = _e2134;
                                    }
                                    let _e2136 = phi_4119_;
                                    let _e2138 = phi_4122_;
                                    phi_4742_ = _e1641;
                                    phi_4123_ = _e2136;
                                    phi_4124_ = (_e650 - 1u);
                                    phi_4125_ = select(_e2130, false, _e696);
                                    phi_4126_ = select(_e2132, _e690, _e696);
                                    phi_4127_ = _e2138;
                                } else {
                                    phi_4742_ = _e646;
                                    phi_4123_ = _e648;
                                    phi_4124_ = _e650;
                                    phi_4125_ = _e688;
                                    phi_4126_ = _e690;
                                    phi_4127_ = _e692;
                                }
                                let _e2142 = phi_4742_;
                                let _e2144 = phi_4123_;
                                let _e2146 = phi_4124_;
                                let _e2148 = phi_4125_;
                                let _e2150 = phi_4126_;
                                let _e2152 = phi_4127_;
                                phi_4741_ = _e2142;
                                phi_4128_ = _e2144;
                                phi_4129_ = _e2146;
                                phi_4130_ = _e2148;
                                phi_4131_ = _e2150;
                                phi_4132_ = _e2152;
                            } else {
                                phi_4741_ = _e646;
                                phi_4128_ = type_40();
                                phi_4129_ = u32();
                                phi_4130_ = bool();
                                phi_4131_ = u32();
                                phi_4132_ = type_51();
                            }
                            let _e2154 = phi_4741_;
                            let _e2156 = phi_4128_;
                            let _e2158 = phi_4129_;
                            let _e2160 = phi_4130_;
                            let _e2162 = phi_4131_;
                            let _e2164 = phi_4132_;
                            phi_4740_ = _e2154;
                            phi_1114_ = _e2156;
                            phi_1117_ = _e2158;
                            phi_1119_ = _e2160;
                            phi_1121_ = _e2162;
                            phi_1123_ = _e2164;
                            phi_4133_ = _e660;
                        } else {
                            phi_4740_ = _e646;
                            phi_1114_ = type_40();
                            phi_1117_ = u32();
                            phi_1119_ = bool();
                            phi_1121_ = u32();
                            phi_1123_ = type_51();
                            phi_4133_ = false;
                        }
                        let _e2166 = phi_4740_;
                        let _e2168 = phi_1114_;
                        let _e2170 = phi_1117_;
                        let _e2172 = phi_1119_;
                        let _e2174 = phi_1121_;
                        let _e2176 = phi_1123_;
                        let _e2178 = phi_4133_;
                        continue;
                        continuing {
                            phi_4533_ = _e2166;
                            phi_1113_ = _e2168;
                            phi_1116_ = _e2170;
                            phi_1118_ = _e2172;
                            phi_1120_ = _e2174;
                            phi_1122_ = _e2176;
                            phi_4739_ = _e2166;
                            break if !(_e2178);
                        }
                    }
                    let _e2181 = phi_4739_;
                    if _e2181 {
                        break;
                    }
                    let _e2183 = local_10;
                    let _e2186 = local_11;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149][0u] = _e2183.member_1;
                    global_6.member[_e149][1u] = _e2186.member_2;
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
