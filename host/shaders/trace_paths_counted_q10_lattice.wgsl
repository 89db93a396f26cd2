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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_34,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

struct type_55 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_24;
@group(0) @binding(0) 
var<uniform> global_2: type_44;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_55;
@group(0) @binding(2) 
var<storage> global_7: type_4;

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
    var phi_493_: i32;
    var phi_494_: i32;
    var phi_504_: bool;
    var phi_514_: u32;
    var phi_515_: u32;
    var phi_517_: bool;
    var phi_522_: u32;
    var phi_555_: i32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_619_: f32;
    var phi_625_: f32;
    var phi_677_: f32;
    var phi_689_: f32;
    var phi_698_: f32;
    var phi_704_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_802_: f32;
    var phi_814_: f32;
    var phi_823_: f32;
    var phi_829_: f32;
    var phi_869_: f32;
    var phi_875_: f32;
    var phi_927_: f32;
    var phi_939_: f32;
    var phi_994_: i32;
    var phi_1016_: u32;
    var phi_1017_: u32;
    var phi_1054_: i32;
    var phi_1076_: u32;
    var phi_1077_: u32;
    var phi_1085_: f32;
    var phi_1086_: f32;
    var phi_4783_: bool;
    var phi_1191_: type_42;
    var phi_1194_: bool;
    var phi_1196_: u32;
    var phi_1198_: u32;
    var phi_1200_: type_49;
    var phi_1211_: bool;
    var phi_1297_: bool;
    var phi_1298_: u32;
    var phi_1299_: type_49;
    var phi_3526_: u32;
    var phi_3532_: u32;
    var phi_3786_: u32;
    var phi_3787_: u32;
    var phi_3797_: u32;
    var phi_3799_: u32;
    var phi_3800_: bool;
    var phi_3820_: u32;
    var phi_3821_: u32;
    var phi_3825_: type_50;
    var phi_4190_: type_49;
    var phi_4267_: type_49;
    var phi_4268_: u32;
    var phi_4269_: type_49;
    var phi_4271_: u32;
    var phi_4272_: type_49;
    var phi_4273_: bool;
    var phi_4282_: type_49;
    var phi_4287_: bool;
    var phi_4289_: type_49;
    var phi_1318_: type_42;
    var phi_1321_: type_8;
    var phi_1322_: type_8;
    var phi_1344_: type_8;
    var phi_1388_: u32;
    var phi_1394_: u32;
    var phi_1404_: u32;
    var phi_1420_: u32;
    var phi_1453_: u32;
    var phi_1459_: u32;
    var phi_1925_: u32;
    var phi_1943_: u32;
    var phi_1961_: u32;
    var phi_1984_: u32;
    var phi_2002_: u32;
    var phi_2020_: u32;
    var phi_2043_: u32;
    var phi_2061_: u32;
    var phi_2079_: u32;
    var phi_1633_: u32;
    var phi_1648_: u32;
    var phi_1658_: u32;
    var phi_1679_: u32;
    var phi_1700_: u32;
    var phi_1730_: u32;
    var phi_1745_: u32;
    var phi_1755_: u32;
    var phi_1776_: u32;
    var phi_1797_: u32;
    var phi_1827_: u32;
    var phi_1842_: u32;
    var phi_1852_: u32;
    var phi_1873_: u32;
    var phi_1894_: u32;
    var phi_1486_: u32;
    var phi_1535_: u32;
    var phi_1584_: u32;
    var phi_2085_: array<array<f32, 3>, 3>;
    var phi_2237_: bool;
    var phi_2266_: bool;
    var phi_2685_: f32;
    var phi_2686_: f32;
    var phi_2687_: f32;
    var phi_2688_: f32;
    var phi_2689_: vec3<f32>;
    var phi_2690_: vec3<f32>;
    var phi_2691_: vec3<f32>;
    var phi_2692_: vec3<f32>;
    var phi_2729_: bool;
    var phi_2738_: vec3<f32>;
    var phi_2903_: f32;
    var phi_2905_: f32;
    var phi_2906_: bool;
    var phi_2926_: f32;
    var phi_2927_: f32;
    var phi_2950_: type_22;
    var phi_2952_: type_22;
    var phi_2953_: bool;
    var phi_2957_: type_22;
    var phi_2958_: type_22;
    var phi_2959_: type_22;
    var phi_2960_: bool;
    var phi_2964_: type_22;
    var phi_2965_: bool;
    var phi_2966_: type_22;
    var phi_2967_: bool;
    var phi_2968_: bool;
    var phi_2969_: type_22;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2979_: type_22;
    var phi_2980_: bool;
    var phi_2984_: type_22;
    var phi_3009_: bool;
    var phi_3010_: bool;
    var phi_3017_: type_42;
    var phi_3018_: type_42;
    var phi_3019_: type_42;
    var phi_1319_: type_42;
    var phi_4777_: bool;
    var phi_4988_: bool;
    var phi_4294_: type_42;
    var phi_4295_: bool;
    var phi_4296_: u32;
    var phi_4297_: type_49;
    var phi_4987_: bool;
    var phi_4298_: type_42;
    var phi_4299_: bool;
    var phi_4300_: u32;
    var phi_4301_: u32;
    var phi_4302_: type_49;
    var phi_4986_: bool;
    var phi_4303_: type_42;
    var phi_4304_: bool;
    var phi_4305_: u32;
    var phi_4306_: u32;
    var phi_4307_: type_49;
    var phi_4985_: bool;
    var phi_1192_: type_42;
    var phi_1195_: bool;
    var phi_1197_: u32;
    var phi_1199_: u32;
    var phi_1201_: type_49;
    var phi_4308_: bool;
    var phi_4984_: bool;
    var local_10: type_42;
    var phi_4346_: f32;
    var phi_4348_: f32;
    var phi_4349_: bool;
    var phi_4350_: f32;
    var phi_4351_: bool;
    var phi_4685_: u32;
    var phi_4703_: bool;
    var phi_4706_: bool;
    var phi_4719_: f32;
    var phi_4720_: f32;
    var phi_4725_: f32;
    var phi_4726_: f32;
    var phi_4727_: bool;
    var phi_4735_: f32;
    var phi_4366_: f32;
    var phi_4367_: f32;
    var phi_4379_: f32;
    var phi_4384_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_3.member));
            let _e103 = arrayLength((&global_7.member));
            let _e111 = arrayLength((&global_6.member));
            let _e115 = global_2.member[0u][0u];
            let _e119 = global_2.member[0u][1u];
            let _e123 = global_2.member[0u][2u];
            let _e127 = global_2.member[0u][3u];
            let _e131 = global_2.member[1u][0u];
            let _e135 = global_2.member[1u][1u];
            let _e139 = global_2.member[1u][2u];
            let _e143 = (_e98.x + (_e98.y * 2097152u));
            let _e155 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e127) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            local = array<i32, 3>(bitcast<i32>(_e131), bitcast<i32>(_e135), bitcast<i32>(_e139));
            let _e158 = (_e143 < arrayLength((&global_4.member)));
            if _e158 {
                let _e159 = (_e143 < arrayLength((&global_1.member)));
                if _e159 {
                    let _e160 = (_e143 < arrayLength((&global_5.member)));
                    if _e160 {
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e170 = global_4.member[_e143].member.member_2[0u];
                        let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                        let _e178 = global_4.member[_e143].member.member_2[1u];
                        let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                        let _e186 = global_4.member[_e143].member.member_2[2u];
                        let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                        let _e194 = global_4.member[_e143].member.member[0u];
                        let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                        let _e202 = global_4.member[_e143].member.member[1u];
                        let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                        let _e210 = global_4.member[_e143].member.member[2u];
                        let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                        let _e214 = select(_e180, _e172, (_e180 < _e172));
                        let _e216 = select(_e188, _e214, (_e188 < _e214));
                        let _e218 = select(_e196, _e216, (_e196 < _e216));
                        let _e220 = select(_e204, _e218, (_e204 < _e218));
                        let _e222 = select(_e212, _e220, (_e212 < _e220));
                        let _e227 = global_4.member[_e143].member.member_1;
                        let _e228 = bitcast<u32>(_e227);
                        let _e229 = (_e228 & 2147483647u);
                        let _e237 = global_4.member[_e143].member.member_3;
                        let _e238 = bitcast<u32>(_e237);
                        let _e239 = (_e238 & 2147483647u);
                        let _e243 = (((select(_e229, _e222, (_e229 < _e222)) < 2139095040u) && (_e239 <= 2139095040u)) && (_e216 > 0u));
                        if _e243 {
                            let _e246 = (bitcast<u32>(bitcast<f32>(_e216)) & 2147483647u);
                            if (_e246 >= 8388608u) {
                                phi_493_ = (bitcast<i32>((_e246 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_493_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e246)), 32u, (_e246 == 0u))));
                            }
                            let _e260 = phi_493_;
                            phi_494_ = _e260;
                        } else {
                            phi_494_ = 0i;
                        }
                        let _e262 = phi_494_;
                        let _e263 = (_e172 == _e216);
                        if _e263 {
                            phi_504_ = true;
                        } else {
                            phi_504_ = (_e180 == _e216);
                        }
                        let _e266 = phi_504_;
                        let _e267 = select(1u, 0u, _e263);
                        if _e266 {
                            let _e268 = (_e267 + 1u);
                            phi_514_ = _e268;
                            phi_515_ = _e268;
                            phi_517_ = select(true, false, (_e268 == 2u));
                        } else {
                            phi_514_ = u32();
                            phi_515_ = 0u;
                            phi_517_ = true;
                        }
                        let _e272 = phi_514_;
                        let _e274 = phi_515_;
                        let _e276 = phi_517_;
                        if _e276 {
                            phi_522_ = (_e274 + 1u);
                        } else {
                            phi_522_ = 0u;
                        }
                        let _e280 = phi_522_;
                        let _e281 = select(_e272, _e274, _e276);
                        let _e282 = select(_e267, select(2u, _e267, _e266), _e276);
                        let _e283 = -(_e262);
                        if (_e283 < -126i) {
                            phi_555_ = -126i;
                        } else {
                            phi_555_ = select(_e283, 127i, (_e283 > 127i));
                        }
                        let _e288 = phi_555_;
                        let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                        let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                        let _e304 = global_4.member[_e143].member.member;
                        let _e305 = (_e281 == 0u);
                        if _e305 {
                            phi_573_ = _e304[0];
                        } else {
                            phi_573_ = _e304[1];
                        }
                        let _e309 = phi_573_;
                        let _e310 = (_e281 == 2u);
                        if _e310 {
                            phi_579_ = _e304[2];
                        } else {
                            phi_579_ = _e309;
                        }
                        let _e313 = phi_579_;
                        let _e314 = bitcast<u32>(_e313);
                        let _e316 = ((_e314 & 2139095040u) != 0u);
                        let _e328 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * select(0.00000011920929f, 1f, _e316));
                        let _e329 = global_4.member[_e143].member.member_2;
                        if _e305 {
                            phi_619_ = _e329[0];
                        } else {
                            phi_619_ = _e329[1];
                        }
                        let _e333 = phi_619_;
                        if _e310 {
                            phi_625_ = _e329[2];
                        } else {
                            phi_625_ = _e333;
                        }
                        let _e336 = phi_625_;
                        let _e337 = bitcast<u32>(_e336);
                        let _e339 = ((_e337 & 2139095040u) != 0u);
                        let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e293) * select(0.00000011920929f, 1f, _e339)) * _e299);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e357 {
                            let _e361 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                            phi_677_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                        } else {
                            phi_677_ = 0f;
                        }
                        let _e365 = phi_677_;
                        let _e366 = (_e328 + _e365);
                        let _e367 = (_e328 - _e365);
                        let _e368 = select(_e353, 0f, _e357);
                        if _e357 {
                            phi_689_ = 38685626000000000000000000f;
                        } else {
                            phi_689_ = (1f / _e353);
                        }
                        let _e371 = phi_689_;
                        let _e372 = (_e280 == 0u);
                        if _e372 {
                            phi_698_ = _e304[0];
                        } else {
                            phi_698_ = _e304[1];
                        }
                        let _e376 = phi_698_;
                        let _e377 = (_e280 == 2u);
                        if _e377 {
                            phi_704_ = _e304[2];
                        } else {
                            phi_704_ = _e376;
                        }
                        let _e380 = phi_704_;
                        let _e381 = bitcast<u32>(_e380);
                        let _e383 = ((_e381 & 2139095040u) != 0u);
                        let _e395 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * select(0.00000011920929f, 1f, _e383));
                        if _e372 {
                            phi_744_ = _e329[0];
                        } else {
                            phi_744_ = _e329[1];
                        }
                        let _e399 = phi_744_;
                        if _e377 {
                            phi_750_ = _e329[2];
                        } else {
                            phi_750_ = _e399;
                        }
                        let _e402 = phi_750_;
                        let _e403 = bitcast<u32>(_e402);
                        let _e405 = ((_e403 & 2139095040u) != 0u);
                        let _e419 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e402, _e405) * _e293) * select(0.00000011920929f, 1f, _e405)) * _e299);
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e423 {
                            let _e427 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) * 0.00000011920929f);
                            phi_802_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                        } else {
                            phi_802_ = 0f;
                        }
                        let _e431 = phi_802_;
                        let _e432 = (_e395 + _e431);
                        let _e433 = (_e395 - _e431);
                        let _e434 = select(_e419, 0f, _e423);
                        if _e423 {
                            phi_814_ = 38685626000000000000000000f;
                        } else {
                            phi_814_ = (1f / _e419);
                        }
                        let _e437 = phi_814_;
                        let _e438 = (_e282 == 0u);
                        if _e438 {
                            phi_823_ = _e304[0];
                        } else {
                            phi_823_ = _e304[1];
                        }
                        let _e442 = phi_823_;
                        let _e443 = (_e282 == 2u);
                        if _e443 {
                            phi_829_ = _e304[2];
                        } else {
                            phi_829_ = _e442;
                        }
                        let _e446 = phi_829_;
                        let _e447 = bitcast<u32>(_e446);
                        let _e449 = ((_e447 & 2139095040u) != 0u);
                        let _e461 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e447 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e447 & 2147483648u))), _e446, _e449) * select(0.00000011920929f, 1f, _e449));
                        if _e438 {
                            phi_869_ = _e329[0];
                        } else {
                            phi_869_ = _e329[1];
                        }
                        let _e465 = phi_869_;
                        if _e443 {
                            phi_875_ = _e329[2];
                        } else {
                            phi_875_ = _e465;
                        }
                        let _e468 = phi_875_;
                        let _e469 = bitcast<u32>(_e468);
                        let _e471 = ((_e469 & 2139095040u) != 0u);
                        let _e485 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e469 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e469 & 2147483648u))), _e468, _e471) * _e293) * select(0.00000011920929f, 1f, _e471)) * _e299);
                        let _e489 = (bitcast<f32>((bitcast<u32>(_e485) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e489 {
                            let _e493 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) * 0.00000011920929f);
                            phi_927_ = select(0.00000000000011368684f, _e493, (_e493 > 0.00000000000011368684f));
                        } else {
                            phi_927_ = 0f;
                        }
                        let _e497 = phi_927_;
                        let _e498 = (_e461 + _e497);
                        let _e499 = (_e461 - _e497);
                        let _e500 = select(_e485, 0f, _e489);
                        if _e489 {
                            phi_939_ = 38685626000000000000000000f;
                        } else {
                            phi_939_ = (1f / _e485);
                        }
                        let _e503 = phi_939_;
                        let _e506 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                        let _e509 = bitcast<f32>((bitcast<u32>(_e395) & 2147483647u));
                        let _e511 = select(_e509, _e506, (_e506 > _e509));
                        let _e514 = bitcast<f32>((bitcast<u32>(_e461) & 2147483647u));
                        if (_e243 && (select(_e514, _e511, (_e511 > _e514)) <= 1099511600000f)) {
                            let _e526 = ((_e229 & 8388607u) | (select(0u, 1u, ((_e229 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e529 = bitcast<i32>((_e229 >> bitcast<u32>(23i)));
                            let _e533 = (_e526 == 0u);
                            let _e536 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e526)), 32u, _e533)) - 8i);
                            if (_e529 == 255i) {
                                phi_994_ = 255i;
                            } else {
                                phi_994_ = (((_e529 + select(0i, 1i, (_e529 == 0i))) - _e536) + _e262);
                            }
                            let _e544 = phi_994_;
                            let _e554 = (_e544 <= 0i);
                            if _e554 {
                                phi_1017_ = u32();
                            } else {
                                if _e533 {
                                    phi_1016_ = u32();
                                } else {
                                    phi_1016_ = select(((bitcast<u32>(_e544) << bitcast<u32>(23i)) | ((_e526 << bitcast<u32>(((_e536 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e544 >= 255i));
                                }
                                let _e558 = phi_1016_;
                                phi_1017_ = _e558;
                            }
                            let _e560 = phi_1017_;
                            let _e572 = ((_e239 & 8388607u) | (select(0u, 1u, ((_e239 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e575 = bitcast<i32>((_e239 >> bitcast<u32>(23i)));
                            let _e579 = (_e572 == 0u);
                            let _e582 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e572)), 32u, _e579)) - 8i);
                            if (_e575 == 255i) {
                                phi_1054_ = 255i;
                            } else {
                                phi_1054_ = (((_e575 + select(0i, 1i, (_e575 == 0i))) - _e582) + _e262);
                            }
                            let _e590 = phi_1054_;
                            let _e600 = (_e590 <= 0i);
                            if _e600 {
                                phi_1077_ = u32();
                            } else {
                                if _e579 {
                                    phi_1076_ = u32();
                                } else {
                                    phi_1076_ = select(((bitcast<u32>(_e590) << bitcast<u32>(23i)) | ((_e572 << bitcast<u32>(((_e582 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e590 >= 255i));
                                }
                                let _e604 = phi_1076_;
                                phi_1077_ = _e604;
                            }
                            let _e606 = phi_1077_;
                            phi_1085_ = bitcast<f32>(((_e238 & 2147483648u) | select(_e606, 0u, select(_e579, true, _e600))));
                            phi_1086_ = bitcast<f32>(((_e228 & 2147483648u) | select(_e560, 0u, select(_e533, true, _e554))));
                        } else {
                            phi_1085_ = 0f;
                            phi_1086_ = 1f;
                        }
                        let _e612 = phi_1085_;
                        let _e614 = phi_1086_;
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e620 = global_4.member[_e143].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e623 = (_e281 % 3u);
                        let _e624 = (_e623 < 3u);
                        if _e624 {
                        } else {
                            break;
                        }
                        let _e626 = local_1[_e623];
                        let _e629 = (_e280 % 3u);
                        let _e630 = (_e629 < 3u);
                        if _e630 {
                        } else {
                            break;
                        }
                        let _e632 = local_1[_e629];
                        let _e635 = (_e282 % 3u);
                        let _e636 = (_e635 < 3u);
                        if _e636 {
                        } else {
                            break;
                        }
                        let _e638 = local_1[_e635];
                        if _e624 {
                        } else {
                            break;
                        }
                        let _e643 = local[_e623];
                        if _e630 {
                        } else {
                            break;
                        }
                        let _e647 = local[_e629];
                        if _e636 {
                        } else {
                            break;
                        }
                        let _e651 = local[_e635];
                        phi_4783_ = false;
                        phi_1191_ = type_42(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e612), 0u, 0u);
                        phi_1194_ = (_e614 <= _e612);
                        phi_1196_ = ((3u * _e100) + 1u);
                        phi_1198_ = 0u;
                        phi_1200_ = type_49(type_34(vec4<f32>((f32(_e626) * _e155), (f32(_e632) * _e155), (f32(_e638) * _e155), 0f), vec4<f32>((f32(_e643) * _e155), (f32(_e647) * _e155), (f32(_e651) * _e155), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        loop {
                            let _e661 = phi_4783_;
                            let _e663 = phi_1191_;
                            let _e665 = phi_1194_;
                            let _e667 = phi_1196_;
                            let _e669 = phi_1198_;
                            let _e671 = phi_1200_;
                            local_10 = _e663;
                            local_11 = _e663;
                            if _e665 {
                                phi_1211_ = true;
                            } else {
                                phi_1211_ = (_e669 > 0u);
                            }
                            let _e674 = phi_1211_;
                            if _e674 {
                                let _e675 = (_e667 > 0u);
                                if _e675 {
                                    if _e665 {
                                        phi_1297_ = _e665;
                                        phi_1298_ = _e669;
                                        phi_1299_ = _e671;
                                    } else {
                                        let _e676 = (_e669 - 1u);
                                        let _e677 = (_e676 % 128u);
                                        let _e678 = (_e677 < 128u);
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e680 = local_7[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e682 = local_6[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e684 = local_5[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e686 = local_4[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e688 = local_3[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e690 = local_2[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e695 = local_8[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e698 = local_9[_e677];
                                        phi_1297_ = (_e698 <= _e663.member.member_1);
                                        phi_1298_ = _e676;
                                        phi_1299_ = type_49(type_34(vec4<f32>(_e680, _e682, _e684, 0f), vec4<f32>(_e686, _e688, _e690, 0f)), _e695);
                                    }
                                    let _e703 = phi_1297_;
                                    let _e705 = phi_1298_;
                                    let _e707 = phi_1299_;
                                    if _e703 {
                                        let _e712 = (_e707.member_1 & 268435455u);
                                        if ((_e707.member_1 & 2147483648u) != 0u) {
                                            phi_1318_ = _e663;
                                            phi_1321_ = type_8(0u, ((_e707.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1185 = phi_1318_;
                                                let _e1187 = phi_1321_;
                                                local_12 = _e1185;
                                                if (_e1187.member < _e1187.member_1) {
                                                    phi_1322_ = type_8((_e1187.member + 1u), _e1187.member_1);
                                                    phi_1344_ = type_8(1u, _e1187.member);
                                                } else {
                                                    phi_1322_ = _e1187;
                                                    phi_1344_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1200 = phi_1322_;
                                                let _e1202 = phi_1344_;
                                                let _e1206 = (bitcast<i32>(_e1202.member) != 0i);
                                                if _e1206 {
                                                    let _e1212 = type_42(_e1185.member, _e1185.member_1, (_e1185.member_2 + 1u));
                                                    let _e1217 = (_e707.member.member_1.x - _e707.member.member.x);
                                                    let _e1220 = (_e707.member.member_1.y - _e707.member.member.y);
                                                    let _e1223 = (_e707.member.member_1.z - _e707.member.member.z);
                                                    let _e1225 = select(_e1220, _e1217, (_e1217 > _e1220));
                                                    let _e1227 = select(_e1223, _e1225, (_e1225 > _e1223));
                                                    let _e1229 = (_e1227 < (1024f * _e155));
                                                    if _e1229 {
                                                        phi_1388_ = 0u;
                                                    } else {
                                                        phi_1388_ = select(2u, 1u, (_e1227 < (2097152f * _e155)));
                                                    }
                                                    let _e1234 = phi_1388_;
                                                    switch bitcast<i32>(_e1234) {
                                                        case 0: {
                                                            phi_1394_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1394_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1394_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1394_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1237 = phi_1394_;
                                                    switch bitcast<i32>(_e1234) {
                                                        case 0: {
                                                            phi_1404_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1404_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1404_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1404_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1244 = phi_1404_;
                                                    let _e1246 = ((_e712 + (_e1202.member_1 * ((3u * _e1237) + 1u))) + (3u * _e1244));
                                                    let _e1247 = (_e1246 < _e103);
                                                    if _e1247 {
                                                        if _e1247 {
                                                        } else {
                                                            phi_4777_ = true;
                                                            break;
                                                        }
                                                        let _e1249 = global_7.member[_e1246];
                                                        phi_1420_ = _e1249;
                                                    } else {
                                                        phi_1420_ = 4294967295u;
                                                    }
                                                    let _e1251 = phi_1420_;
                                                    if _e1229 {
                                                        phi_1453_ = 0u;
                                                    } else {
                                                        phi_1453_ = select(2u, 1u, (_e1227 < (2097152f * _e155)));
                                                    }
                                                    let _e1256 = phi_1453_;
                                                    switch bitcast<i32>(_e1256) {
                                                        case 0: {
                                                            phi_1459_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1459_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1459_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1459_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1259 = phi_1459_;
                                                    let _e1263 = (_e712 + (_e1202.member_1 * ((3u * _e1259) + 1u)));
                                                    switch bitcast<i32>(_e1256) {
                                                        case 0: {
                                                            let _e1538 = (_e1263 < _e103);
                                                            if _e1538 {
                                                                if _e1538 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1540 = global_7.member[_e1263];
                                                                phi_1486_ = _e1540;
                                                            } else {
                                                                phi_1486_ = 0u;
                                                            }
                                                            let _e1542 = phi_1486_;
                                                            let _e1544 = ((10u * _e281) & 31u);
                                                            let _e1554 = ((10u * _e280) & 31u);
                                                            let _e1564 = ((10u * _e282) & 31u);
                                                            let _e1574 = (_e1263 + 1u);
                                                            let _e1575 = (_e1574 < _e103);
                                                            if _e1575 {
                                                                if _e1575 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1577 = global_7.member[_e1574];
                                                                phi_1535_ = _e1577;
                                                            } else {
                                                                phi_1535_ = 0u;
                                                            }
                                                            let _e1579 = phi_1535_;
                                                            let _e1605 = (_e1263 + 2u);
                                                            let _e1606 = (_e1605 < _e103);
                                                            if _e1606 {
                                                                if _e1606 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1608 = global_7.member[_e1605];
                                                                phi_1584_ = _e1608;
                                                            } else {
                                                                phi_1584_ = 0u;
                                                            }
                                                            let _e1610 = phi_1584_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1542 >> bitcast<u32>(_e1544)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1542 >> bitcast<u32>(_e1554)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1542 >> bitcast<u32>(_e1564)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1579 >> bitcast<u32>(_e1544)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1579 >> bitcast<u32>(_e1554)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1579 >> bitcast<u32>(_e1564)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1610 >> bitcast<u32>(_e1544)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1610 >> bitcast<u32>(_e1554)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1610 >> bitcast<u32>(_e1564)) & 1023u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1352 = (_e1263 < _e103);
                                                            if _e1352 {
                                                                if _e1352 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1354 = global_7.member[_e1263];
                                                                phi_1633_ = _e1354;
                                                            } else {
                                                                phi_1633_ = 0u;
                                                            }
                                                            let _e1356 = phi_1633_;
                                                            let _e1357 = (_e1263 + 1u);
                                                            let _e1358 = (_e1357 < _e103);
                                                            if _e1358 {
                                                                if _e1358 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1360 = global_7.member[_e1357];
                                                                phi_1648_ = _e1360;
                                                            } else {
                                                                phi_1648_ = 0u;
                                                            }
                                                            let _e1362 = phi_1648_;
                                                            let _e1363 = (_e281 == 1u);
                                                            if _e1363 {
                                                                phi_1658_ = ((_e1356 >> bitcast<u32>(21i)) | (_e1362 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1658_ = (_e1362 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1372 = phi_1658_;
                                                            let _e1380 = (_e280 == 1u);
                                                            if _e1380 {
                                                                phi_1679_ = ((_e1356 >> bitcast<u32>(21i)) | (_e1362 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1679_ = (_e1362 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1389 = phi_1679_;
                                                            let _e1397 = (_e282 == 1u);
                                                            if _e1397 {
                                                                phi_1700_ = ((_e1356 >> bitcast<u32>(21i)) | (_e1362 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1700_ = (_e1362 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1406 = phi_1700_;
                                                            let _e1415 = (_e1263 + 2u);
                                                            let _e1416 = (_e1415 < _e103);
                                                            if _e1416 {
                                                                if _e1416 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1418 = global_7.member[_e1415];
                                                                phi_1730_ = _e1418;
                                                            } else {
                                                                phi_1730_ = 0u;
                                                            }
                                                            let _e1420 = phi_1730_;
                                                            let _e1421 = (_e1263 + 3u);
                                                            let _e1422 = (_e1421 < _e103);
                                                            if _e1422 {
                                                                if _e1422 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1424 = global_7.member[_e1421];
                                                                phi_1745_ = _e1424;
                                                            } else {
                                                                phi_1745_ = 0u;
                                                            }
                                                            let _e1426 = phi_1745_;
                                                            if _e1363 {
                                                                phi_1755_ = ((_e1420 >> bitcast<u32>(21i)) | (_e1426 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1755_ = (_e1426 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1435 = phi_1755_;
                                                            if _e1380 {
                                                                phi_1776_ = ((_e1420 >> bitcast<u32>(21i)) | (_e1426 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1776_ = (_e1426 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1451 = phi_1776_;
                                                            if _e1397 {
                                                                phi_1797_ = ((_e1420 >> bitcast<u32>(21i)) | (_e1426 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1797_ = (_e1426 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1467 = phi_1797_;
                                                            let _e1476 = (_e1263 + 4u);
                                                            let _e1477 = (_e1476 < _e103);
                                                            if _e1477 {
                                                                if _e1477 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1479 = global_7.member[_e1476];
                                                                phi_1827_ = _e1479;
                                                            } else {
                                                                phi_1827_ = 0u;
                                                            }
                                                            let _e1481 = phi_1827_;
                                                            let _e1482 = (_e1263 + 5u);
                                                            let _e1483 = (_e1482 < _e103);
                                                            if _e1483 {
                                                                if _e1483 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1485 = global_7.member[_e1482];
                                                                phi_1842_ = _e1485;
                                                            } else {
                                                                phi_1842_ = 0u;
                                                            }
                                                            let _e1487 = phi_1842_;
                                                            if _e1363 {
                                                                phi_1852_ = ((_e1481 >> bitcast<u32>(21i)) | (_e1487 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1852_ = (_e1487 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1496 = phi_1852_;
                                                            if _e1380 {
                                                                phi_1873_ = ((_e1481 >> bitcast<u32>(21i)) | (_e1487 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1873_ = (_e1487 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1512 = phi_1873_;
                                                            if _e1397 {
                                                                phi_1894_ = ((_e1481 >> bitcast<u32>(21i)) | (_e1487 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1894_ = (_e1487 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1528 = phi_1894_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1372, _e1356, _e305) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1389, _e1356, _e372) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1406, _e1356, _e438) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1435, _e1420, _e305) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1451, _e1420, _e372) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1467, _e1420, _e438) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1496, _e1481, _e305) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1512, _e1481, _e372) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1528, _e1481, _e438) & 2097151u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1265 = (_e1263 + _e281);
                                                            let _e1266 = (_e1265 < _e103);
                                                            if _e1266 {
                                                                if _e1266 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1268 = global_7.member[_e1265];
                                                                phi_1925_ = _e1268;
                                                            } else {
                                                                phi_1925_ = 0u;
                                                            }
                                                            let _e1270 = phi_1925_;
                                                            let _e1274 = (_e1263 + _e280);
                                                            let _e1275 = (_e1274 < _e103);
                                                            if _e1275 {
                                                                if _e1275 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1277 = global_7.member[_e1274];
                                                                phi_1943_ = _e1277;
                                                            } else {
                                                                phi_1943_ = 0u;
                                                            }
                                                            let _e1279 = phi_1943_;
                                                            let _e1283 = (_e1263 + _e282);
                                                            let _e1284 = (_e1283 < _e103);
                                                            if _e1284 {
                                                                if _e1284 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1286 = global_7.member[_e1283];
                                                                phi_1961_ = _e1286;
                                                            } else {
                                                                phi_1961_ = 0u;
                                                            }
                                                            let _e1288 = phi_1961_;
                                                            let _e1293 = (_e1263 + 3u);
                                                            let _e1294 = (_e1293 + _e281);
                                                            let _e1295 = (_e1294 < _e103);
                                                            if _e1295 {
                                                                if _e1295 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1297 = global_7.member[_e1294];
                                                                phi_1984_ = _e1297;
                                                            } else {
                                                                phi_1984_ = 0u;
                                                            }
                                                            let _e1299 = phi_1984_;
                                                            let _e1303 = (_e1293 + _e280);
                                                            let _e1304 = (_e1303 < _e103);
                                                            if _e1304 {
                                                                if _e1304 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1306 = global_7.member[_e1303];
                                                                phi_2002_ = _e1306;
                                                            } else {
                                                                phi_2002_ = 0u;
                                                            }
                                                            let _e1308 = phi_2002_;
                                                            let _e1312 = (_e1293 + _e282);
                                                            let _e1313 = (_e1312 < _e103);
                                                            if _e1313 {
                                                                if _e1313 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1315 = global_7.member[_e1312];
                                                                phi_2020_ = _e1315;
                                                            } else {
                                                                phi_2020_ = 0u;
                                                            }
                                                            let _e1317 = phi_2020_;
                                                            let _e1322 = (_e1263 + 6u);
                                                            let _e1323 = (_e1322 + _e281);
                                                            let _e1324 = (_e1323 < _e103);
                                                            if _e1324 {
                                                                if _e1324 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1326 = global_7.member[_e1323];
                                                                phi_2043_ = _e1326;
                                                            } else {
                                                                phi_2043_ = 0u;
                                                            }
                                                            let _e1328 = phi_2043_;
                                                            let _e1332 = (_e1322 + _e280);
                                                            let _e1333 = (_e1332 < _e103);
                                                            if _e1333 {
                                                                if _e1333 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1335 = global_7.member[_e1332];
                                                                phi_2061_ = _e1335;
                                                            } else {
                                                                phi_2061_ = 0u;
                                                            }
                                                            let _e1337 = phi_2061_;
                                                            let _e1341 = (_e1322 + _e282);
                                                            let _e1342 = (_e1341 < _e103);
                                                            if _e1342 {
                                                                if _e1342 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1344 = global_7.member[_e1341];
                                                                phi_2079_ = _e1344;
                                                            } else {
                                                                phi_2079_ = 0u;
                                                            }
                                                            let _e1346 = phi_2079_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1270)) * _e155), (f32(bitcast<i32>(_e1279)) * _e155), (f32(bitcast<i32>(_e1288)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e1299)) * _e155), (f32(bitcast<i32>(_e1308)) * _e155), (f32(bitcast<i32>(_e1317)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e1328)) * _e155), (f32(bitcast<i32>(_e1337)) * _e155), (f32(bitcast<i32>(_e1346)) * _e155)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2085_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1638 = phi_2085_;
                                                    let _e1647 = (_e1638[0][2] - _e461);
                                                    let _e1650 = (((_e1638[0][0] - _e328) * _e500) - (_e1647 * _e368));
                                                    let _e1653 = (((_e1638[0][1] - _e395) * _e500) - (_e1647 * _e434));
                                                    let _e1660 = (_e1638[1][2] - _e461);
                                                    let _e1663 = (((_e1638[1][0] - _e328) * _e500) - (_e1660 * _e368));
                                                    let _e1666 = (((_e1638[1][1] - _e395) * _e500) - (_e1660 * _e434));
                                                    let _e1673 = (_e1638[2][2] - _e461);
                                                    let _e1676 = (((_e1638[2][0] - _e328) * _e500) - (_e1673 * _e368));
                                                    let _e1679 = (((_e1638[2][1] - _e395) * _e500) - (_e1673 * _e434));
                                                    let _e1680 = (_e1676 * _e1666);
                                                    let _e1681 = (_e1679 * _e1663);
                                                    let _e1682 = (_e1650 * _e1679);
                                                    let _e1683 = (_e1653 * _e1676);
                                                    let _e1684 = (_e1663 * _e1653);
                                                    let _e1685 = (_e1666 * _e1650);
                                                    let _e1690 = (((_e1680 >= _e1681) && (_e1682 >= _e1683)) && (_e1684 >= _e1685));
                                                    if (_e1690 || (((_e1680 <= _e1681) && (_e1682 <= _e1683)) && (_e1684 <= _e1685))) {
                                                        let _e1697 = select(-1f, 1f, _e1690);
                                                        let _e1699 = ((_e1680 - _e1681) * _e1697);
                                                        let _e1701 = select(0f, _e1699, (_e1699 > 0f));
                                                        let _e1703 = ((_e1682 - _e1683) * _e1697);
                                                        let _e1705 = select(0f, _e1703, (_e1703 > 0f));
                                                        let _e1707 = ((_e1684 - _e1685) * _e1697);
                                                        let _e1709 = select(0f, _e1707, (_e1707 > 0f));
                                                        let _e1711 = ((_e1701 + _e1705) + _e1709);
                                                        if (_e1711 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2969_ = type_22();
                                                            phi_2970_ = true;
                                                            phi_2971_ = false;
                                                        } else {
                                                            let _e1714 = select(_e1663, _e1650, (_e1650 < _e1663));
                                                            if (select(_e1676, _e1714, (_e1714 < _e1676)) > 0f) {
                                                                phi_2237_ = true;
                                                            } else {
                                                                let _e1719 = select(_e1663, _e1650, (_e1650 > _e1663));
                                                                phi_2237_ = (select(_e1676, _e1719, (_e1719 > _e1676)) < 0f);
                                                            }
                                                            let _e1724 = phi_2237_;
                                                            if _e1724 {
                                                                phi_2966_ = type_22();
                                                                phi_2967_ = true;
                                                                phi_2968_ = false;
                                                            } else {
                                                                let _e1726 = select(_e1666, _e1653, (_e1653 < _e1666));
                                                                if (select(_e1679, _e1726, (_e1726 < _e1679)) > 0f) {
                                                                    phi_2266_ = true;
                                                                } else {
                                                                    let _e1731 = select(_e1666, _e1653, (_e1653 > _e1666));
                                                                    phi_2266_ = (select(_e1679, _e1731, (_e1731 > _e1679)) < 0f);
                                                                }
                                                                let _e1736 = phi_2266_;
                                                                if _e1736 {
                                                                    phi_2964_ = type_22();
                                                                    phi_2965_ = false;
                                                                } else {
                                                                    let _e1738 = select(_e1638[1][0], _e1638[0][0], (_e1638[0][0] < _e1638[1][0]));
                                                                    let _e1742 = select(_e1638[1][0], _e1638[0][0], (_e1638[0][0] > _e1638[1][0]));
                                                                    let _e1746 = select(_e1638[1][1], _e1638[0][1], (_e1638[0][1] < _e1638[1][1]));
                                                                    let _e1750 = select(_e1638[1][1], _e1638[0][1], (_e1638[0][1] > _e1638[1][1]));
                                                                    let _e1754 = select(_e1638[1][2], _e1638[0][2], (_e1638[0][2] < _e1638[1][2]));
                                                                    let _e1758 = select(_e1638[1][2], _e1638[0][2], (_e1638[0][2] > _e1638[1][2]));
                                                                    let _e1763 = ((select(_e1638[2][0], _e1738, (_e1738 < _e1638[2][0])) - _e366) * _e371);
                                                                    let _e1764 = ((select(_e1638[2][0], _e1742, (_e1742 > _e1638[2][0])) - _e367) * _e371);
                                                                    let _e1767 = ((select(_e1638[2][1], _e1746, (_e1746 < _e1638[2][1])) - _e432) * _e437);
                                                                    let _e1768 = ((select(_e1638[2][1], _e1750, (_e1750 > _e1638[2][1])) - _e433) * _e437);
                                                                    let _e1771 = ((select(_e1638[2][2], _e1754, (_e1754 < _e1638[2][2])) - _e498) * _e503);
                                                                    let _e1772 = ((select(_e1638[2][2], _e1758, (_e1758 > _e1638[2][2])) - _e499) * _e503);
                                                                    let _e1774 = select(_e1772, _e1771, (_e1771 < _e1772));
                                                                    let _e1776 = select(_e1772, _e1771, (_e1771 > _e1772));
                                                                    let _e1778 = select(_e1764, _e1763, (_e1763 < _e1764));
                                                                    let _e1780 = select(_e1768, _e1767, (_e1767 < _e1768));
                                                                    let _e1782 = select(_e1780, _e1778, (_e1778 > _e1780));
                                                                    let _e1784 = select(_e1774, _e1782, (_e1782 > _e1774));
                                                                    let _e1786 = select(_e1764, _e1763, (_e1763 > _e1764));
                                                                    let _e1788 = select(_e1768, _e1767, (_e1767 > _e1768));
                                                                    let _e1790 = select(_e1788, _e1786, (_e1786 < _e1788));
                                                                    let _e1792 = select(_e1776, _e1790, (_e1790 < _e1776));
                                                                    let _e1793 = -(_e1774);
                                                                    let _e1799 = select(_e614, _e1784, (_e1784 > _e614));
                                                                    if (_e1799 > (_e1792 + (select(_e1793, _e1776, (_e1776 > _e1793)) * 0.0000019073523f))) {
                                                                        phi_2959_ = type_22();
                                                                        phi_2960_ = true;
                                                                    } else {
                                                                        let _e1801 = (_e1799 > _e1185.member.member_1);
                                                                        if _e1801 {
                                                                            phi_2958_ = type_22();
                                                                        } else {
                                                                            let _e1802 = vec3<f32>(_e1638[0][0], _e1638[0][1], _e1638[0][2]);
                                                                            let _e1803 = vec3<f32>(_e1638[1][0], _e1638[1][1], _e1638[1][2]);
                                                                            let _e1804 = vec3<f32>(_e1638[2][0], _e1638[2][1], _e1638[2][2]);
                                                                            let _e1805 = (_e1638[1][0] - _e1638[0][0]);
                                                                            let _e1806 = (_e1638[1][1] - _e1638[0][1]);
                                                                            let _e1807 = (_e1638[1][2] - _e1638[0][2]);
                                                                            let _e1808 = vec3<f32>(_e1805, _e1806, _e1807);
                                                                            let _e1809 = (_e1638[2][0] - _e1638[1][0]);
                                                                            let _e1810 = (_e1638[2][1] - _e1638[1][1]);
                                                                            let _e1811 = (_e1638[2][2] - _e1638[1][2]);
                                                                            let _e1812 = vec3<f32>(_e1809, _e1810, _e1811);
                                                                            let _e1813 = (_e1638[0][0] - _e1638[2][0]);
                                                                            let _e1814 = (_e1638[0][1] - _e1638[2][1]);
                                                                            let _e1815 = (_e1638[0][2] - _e1638[2][2]);
                                                                            let _e1816 = vec3<f32>(_e1813, _e1814, _e1815);
                                                                            let _e1819 = bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u));
                                                                            let _e1822 = bitcast<f32>((bitcast<u32>(_e1806) & 2147483647u));
                                                                            let _e1824 = select(_e1822, _e1819, (_e1819 > _e1822));
                                                                            let _e1827 = bitcast<f32>((bitcast<u32>(_e1807) & 2147483647u));
                                                                            let _e1829 = select(_e1827, _e1824, (_e1824 > _e1827));
                                                                            let _e1832 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
                                                                            let _e1835 = bitcast<f32>((bitcast<u32>(_e1810) & 2147483647u));
                                                                            let _e1837 = select(_e1835, _e1832, (_e1832 > _e1835));
                                                                            let _e1840 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                                            let _e1842 = select(_e1840, _e1837, (_e1837 > _e1840));
                                                                            let _e1845 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                                            let _e1848 = bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u));
                                                                            let _e1850 = select(_e1848, _e1845, (_e1845 > _e1848));
                                                                            let _e1853 = bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u));
                                                                            let _e1855 = select(_e1853, _e1850, (_e1850 > _e1853));
                                                                            let _e1857 = select(_e1842, _e1829, (_e1829 > _e1842));
                                                                            let _e1859 = select(_e1855, _e1857, (_e1857 > _e1855));
                                                                            if (_e1829 == _e1859) {
                                                                                phi_2685_ = _e1666;
                                                                                phi_2686_ = _e1663;
                                                                                phi_2687_ = _e1653;
                                                                                phi_2688_ = _e1650;
                                                                                phi_2689_ = _e1802;
                                                                                phi_2690_ = _e1816;
                                                                                phi_2691_ = _e1812;
                                                                                phi_2692_ = _e1808;
                                                                            } else {
                                                                                let _e1861 = (_e1842 == _e1859);
                                                                                let _e1866 = vec3(_e1861);
                                                                                phi_2685_ = select(_e1653, _e1679, _e1861);
                                                                                phi_2686_ = select(_e1650, _e1676, _e1861);
                                                                                phi_2687_ = select(_e1679, _e1666, _e1861);
                                                                                phi_2688_ = select(_e1676, _e1663, _e1861);
                                                                                phi_2689_ = select(_e1804, _e1803, _e1866);
                                                                                phi_2690_ = select(_e1812, _e1808, _e1866);
                                                                                phi_2691_ = select(_e1808, _e1816, _e1866);
                                                                                phi_2692_ = select(_e1816, _e1812, _e1866);
                                                                            }
                                                                            let _e1872 = phi_2685_;
                                                                            let _e1874 = phi_2686_;
                                                                            let _e1876 = phi_2687_;
                                                                            let _e1878 = phi_2688_;
                                                                            let _e1880 = phi_2689_;
                                                                            let _e1882 = phi_2690_;
                                                                            let _e1884 = phi_2691_;
                                                                            let _e1886 = phi_2692_;
                                                                            let _e1893 = ((_e1884.y * _e1882.z) - (_e1882.y * _e1884.z));
                                                                            let _e1898 = ((_e1884.z * _e1882.x) - (_e1882.z * _e1884.x));
                                                                            let _e1901 = ((_e1884.x * _e1882.y) - (_e1882.x * _e1884.y));
                                                                            if (_e1701 >= _e1705) {
                                                                                phi_2729_ = select(true, false, (_e1701 >= _e1709));
                                                                            } else {
                                                                                phi_2729_ = true;
                                                                            }
                                                                            let _e1906 = phi_2729_;
                                                                            if _e1906 {
                                                                                phi_2738_ = select(_e1804, _e1803, vec3((_e1705 >= _e1709)));
                                                                            } else {
                                                                                phi_2738_ = _e1802;
                                                                            }
                                                                            let _e1911 = phi_2738_;
                                                                            let _e1922 = (((_e1893 * (_e1911.x - _e328)) + (_e1898 * (_e1911.y - _e395))) + (_e1901 * (_e1911.z - _e461)));
                                                                            let _e1927 = (((_e1893 * _e368) + (_e1898 * _e434)) + (_e1901 * _e500));
                                                                            let _e1928 = (_e1874 - _e1878);
                                                                            let _e1929 = (_e1872 - _e1876);
                                                                            let _e1937 = (-(((_e1878 * _e1928) + (_e1876 * _e1929))) / ((_e1928 * _e1928) + (_e1929 * _e1929)));
                                                                            let _e1939 = select(1f, _e1937, (_e1937 < 1f));
                                                                            let _e1941 = select(0f, _e1939, (_e1939 > 0f));
                                                                            let _e1954 = ((_e1880.x + (_e1886.x * _e1941)) - _e328);
                                                                            let _e1955 = ((_e1880.y + (_e1886.y * _e1941)) - _e395);
                                                                            let _e1956 = ((_e1880.z + (_e1886.z * _e1941)) - _e461);
                                                                            let _e1957 = (_e1956 / _e500);
                                                                            let _e1969 = bitcast<f32>((bitcast<u32>(_e1954) & 2147483647u));
                                                                            let _e1972 = bitcast<f32>((bitcast<u32>(_e1955) & 2147483647u));
                                                                            let _e1974 = select(_e1972, _e1969, (_e1969 > _e1972));
                                                                            let _e1977 = bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u));
                                                                            let _e1979 = select(_e1977, _e1974, (_e1974 > _e1977));
                                                                            let _e1985 = bitcast<f32>((bitcast<u32>(_e1893) & 2147483647u));
                                                                            let _e1988 = bitcast<f32>((bitcast<u32>(_e1898) & 2147483647u));
                                                                            let _e1990 = select(_e1988, _e1985, (_e1985 > _e1988));
                                                                            let _e1993 = bitcast<f32>((bitcast<u32>(_e1901) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1893 * _e1954) + (_e1898 * _e1955)) + (_e1901 * _e1956)) - _e1922)) & 2147483647u)) <= ((0.0000009536743f * select(_e1859, _e1979, (_e1979 > _e1859))) * select(_e1993, _e1990, (_e1990 > _e1993)))) {
                                                                                let _e2003 = bitcast<f32>((bitcast<u32>(_e1884.x) & 2147483647u));
                                                                                let _e2006 = bitcast<f32>((bitcast<u32>(_e1884.y) & 2147483647u));
                                                                                let _e2008 = select(_e2006, _e2003, (_e2003 > _e2006));
                                                                                let _e2011 = bitcast<f32>((bitcast<u32>(_e1884.z) & 2147483647u));
                                                                                let _e2017 = bitcast<f32>((bitcast<u32>(_e1882.x) & 2147483647u));
                                                                                let _e2020 = bitcast<f32>((bitcast<u32>(_e1882.y) & 2147483647u));
                                                                                let _e2022 = select(_e2020, _e2017, (_e2017 > _e2020));
                                                                                let _e2025 = bitcast<f32>((bitcast<u32>(_e1882.z) & 2147483647u));
                                                                                let _e2029 = (bitcast<f32>((bitcast<u32>(_e1927) & 2147483647u)) > ((0.0000038146973f * select(_e2011, _e2008, (_e2008 > _e2011))) * select(_e2025, _e2022, (_e2022 > _e2025))));
                                                                                if _e2029 {
                                                                                    phi_2903_ = (_e1922 / _e1927);
                                                                                } else {
                                                                                    phi_2903_ = f32();
                                                                                }
                                                                                let _e2032 = phi_2903_;
                                                                                phi_2905_ = _e2032;
                                                                                phi_2906_ = select(true, false, _e2029);
                                                                            } else {
                                                                                phi_2905_ = f32();
                                                                                phi_2906_ = true;
                                                                            }
                                                                            let _e2035 = phi_2905_;
                                                                            let _e2037 = phi_2906_;
                                                                            if _e2037 {
                                                                                let _e2045 = (((_e1893 * (_e1954 - (_e368 * _e1957))) + (_e1898 * (_e1955 - (_e434 * _e1957)))) / _e1927);
                                                                                if (bitcast<f32>((bitcast<u32>(_e2045) & 2147483647u)) <= _e1859) {
                                                                                    phi_2926_ = (_e1957 + _e2045);
                                                                                } else {
                                                                                    phi_2926_ = _e1957;
                                                                                }
                                                                                let _e2052 = phi_2926_;
                                                                                phi_2927_ = _e2052;
                                                                            } else {
                                                                                phi_2927_ = _e2035;
                                                                            }
                                                                            let _e2054 = phi_2927_;
                                                                            let _e2056 = select(_e1792, _e2054, (_e2054 < _e1792));
                                                                            let _e2058 = select(_e1784, _e2056, (_e2056 > _e1784));
                                                                            if (_e2058 >= _e614) {
                                                                                let _e2060 = (_e2058 <= _e1185.member.member_1);
                                                                                if _e2060 {
                                                                                    let _e2061 = (1f / _e1711);
                                                                                    phi_2950_ = type_22(_e2058, (_e1705 * _e2061), (_e1709 * _e2061), _e1251);
                                                                                } else {
                                                                                    phi_2950_ = type_22();
                                                                                }
                                                                                let _e2066 = phi_2950_;
                                                                                phi_2952_ = _e2066;
                                                                                phi_2953_ = select(true, false, _e2060);
                                                                            } else {
                                                                                phi_2952_ = type_22();
                                                                                phi_2953_ = true;
                                                                            }
                                                                            let _e2069 = phi_2952_;
                                                                            let _e2071 = phi_2953_;
                                                                            if _e2071 {
                                                                                phi_2957_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2957_ = _e2069;
                                                                            }
                                                                            let _e2073 = phi_2957_;
                                                                            phi_2958_ = _e2073;
                                                                        }
                                                                        let _e2075 = phi_2958_;
                                                                        phi_2959_ = _e2075;
                                                                        phi_2960_ = _e1801;
                                                                    }
                                                                    let _e2077 = phi_2959_;
                                                                    let _e2079 = phi_2960_;
                                                                    phi_2964_ = _e2077;
                                                                    phi_2965_ = _e2079;
                                                                }
                                                                let _e2081 = phi_2964_;
                                                                let _e2083 = phi_2965_;
                                                                phi_2966_ = _e2081;
                                                                phi_2967_ = _e1736;
                                                                phi_2968_ = _e2083;
                                                            }
                                                            let _e2085 = phi_2966_;
                                                            let _e2087 = phi_2967_;
                                                            let _e2089 = phi_2968_;
                                                            phi_2969_ = _e2085;
                                                            phi_2970_ = _e2087;
                                                            phi_2971_ = _e2089;
                                                        }
                                                        let _e2091 = phi_2969_;
                                                        let _e2093 = phi_2970_;
                                                        let _e2095 = phi_2971_;
                                                        phi_2979_ = _e2091;
                                                        phi_2980_ = select(_e2095, true, _e2093);
                                                    } else {
                                                        phi_2979_ = type_22();
                                                        phi_2980_ = true;
                                                    }
                                                    let _e2098 = phi_2979_;
                                                    let _e2100 = phi_2980_;
                                                    if _e2100 {
                                                        phi_2984_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2984_ = _e2098;
                                                    }
                                                    let _e2102 = phi_2984_;
                                                    if (_e2102.member_3 != 4294967295u) {
                                                        if (_e1251 != _e620) {
                                                            if (_e2102.member < _e1185.member.member.member) {
                                                                phi_3010_ = true;
                                                            } else {
                                                                if (_e2102.member == _e1185.member.member.member) {
                                                                    phi_3009_ = (_e2102.member_3 < _e1185.member.member.member_3);
                                                                } else {
                                                                    phi_3009_ = false;
                                                                }
                                                                let _e2117 = phi_3009_;
                                                                phi_3010_ = _e2117;
                                                            }
                                                            let _e2119 = phi_3010_;
                                                            if _e2119 {
                                                                phi_3017_ = type_42(type_39(_e2102, _e2102.member), _e1212.member_1, _e1212.member_2);
                                                            } else {
                                                                phi_3017_ = _e1212;
                                                            }
                                                            let _e2126 = phi_3017_;
                                                            phi_3018_ = _e2126;
                                                        } else {
                                                            phi_3018_ = _e1212;
                                                        }
                                                        let _e2128 = phi_3018_;
                                                        phi_3019_ = _e2128;
                                                    } else {
                                                        phi_3019_ = _e1212;
                                                    }
                                                    let _e2130 = phi_3019_;
                                                    phi_1319_ = _e2130;
                                                } else {
                                                    phi_1319_ = type_42();
                                                }
                                                let _e2132 = phi_1319_;
                                                continue;
                                                continuing {
                                                    phi_1318_ = _e2132;
                                                    phi_1321_ = _e1200;
                                                    phi_4777_ = _e661;
                                                    break if !(_e1206);
                                                }
                                            }
                                            let _e2135 = phi_4777_;
                                            phi_4984_ = _e2135;
                                            if _e2135 {
                                                break;
                                            }
                                            phi_4988_ = _e2135;
                                            let _e2504 = local_12;
                                            phi_4294_ = _e2504;
                                            phi_4295_ = false;
                                            phi_4296_ = _e705;
                                            phi_4297_ = _e707;
                                        } else {
                                            if (_e707.member_1 >= _e100) {
                                                phi_3825_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e707.member_1 < _e100) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e720 = ((1u + _e281) % 4u);
                                                if (_e720 < 4u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e725 = global_3.member[_e707.member_1][_e720];
                                                let _e727 = (_e725 >> bitcast<u32>(11u));
                                                let _e729 = ((1u + _e280) % 4u);
                                                if (_e729 < 4u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e734 = global_3.member[_e707.member_1][_e729];
                                                let _e736 = (_e734 >> bitcast<u32>(11u));
                                                let _e738 = ((1u + _e282) % 4u);
                                                if (_e738 < 4u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e743 = global_3.member[_e707.member_1][_e738];
                                                let _e745 = (_e743 >> bitcast<u32>(11u));
                                                let _e768 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.x - _e707.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e769 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.y - _e707.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e770 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.z - _e707.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e772 = select(_e155, _e768, (_e768 > _e155));
                                                let _e774 = select(_e155, _e769, (_e769 > _e155));
                                                let _e776 = select(_e155, _e770, (_e770 > _e155));
                                                let _e807 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 1023u))) - 8388608f) * _e772));
                                                let _e812 = (bitcast<i32>((_e725 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e815 = bitcast<f32>((_e807 & bitcast<u32>(_e812)));
                                                let _e816 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e734 & 1023u))) - 8388608f) * _e774));
                                                let _e821 = (bitcast<i32>((_e734 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e824 = bitcast<f32>((_e816 & bitcast<u32>(_e821)));
                                                let _e825 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e743 & 1023u))) - 8388608f) * _e776));
                                                let _e830 = (bitcast<i32>((_e743 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e833 = bitcast<f32>((_e825 & bitcast<u32>(_e830)));
                                                let _e837 = bitcast<f32>((_e807 & bitcast<u32>(~(_e812))));
                                                let _e841 = bitcast<f32>((_e816 & bitcast<u32>(~(_e821))));
                                                let _e845 = bitcast<f32>((_e825 & bitcast<u32>(~(_e830))));
                                                let _e846 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e727 & 1023u))) - 8388608f) * _e772));
                                                let _e851 = (bitcast<i32>((_e727 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e854 = bitcast<f32>((_e846 & bitcast<u32>(_e851)));
                                                let _e855 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e736 & 1023u))) - 8388608f) * _e774));
                                                let _e860 = (bitcast<i32>((_e736 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e863 = bitcast<f32>((_e855 & bitcast<u32>(_e860)));
                                                let _e864 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e745 & 1023u))) - 8388608f) * _e776));
                                                let _e869 = (bitcast<i32>((_e745 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e872 = bitcast<f32>((_e864 & bitcast<u32>(_e869)));
                                                let _e876 = bitcast<f32>((_e846 & bitcast<u32>(~(_e851))));
                                                let _e880 = bitcast<f32>((_e855 & bitcast<u32>(~(_e860))));
                                                let _e884 = bitcast<f32>((_e864 & bitcast<u32>(~(_e869))));
                                                let _e885 = (_e707.member.member.x + _e815);
                                                let _e886 = (_e707.member.member.y + _e824);
                                                let _e887 = (_e707.member.member.z + _e833);
                                                let _e890 = (_e707.member.member_1.x - _e854);
                                                let _e891 = (_e707.member.member_1.y - _e863);
                                                let _e892 = (_e707.member.member_1.z - _e872);
                                                let _e911 = (_e890 - _e885);
                                                let _e912 = (_e891 - _e886);
                                                let _e913 = (_e892 - _e887);
                                                let _e915 = select(_e912, _e911, (_e911 > _e912));
                                                let _e917 = select(_e913, _e915, (_e915 > _e913));
                                                if (_e917 < (1024f * _e155)) {
                                                    phi_3526_ = 0u;
                                                } else {
                                                    phi_3526_ = select(2u, 1u, (_e917 < (2097152f * _e155)));
                                                }
                                                let _e924 = phi_3526_;
                                                switch bitcast<i32>(_e924) {
                                                    case 0: {
                                                        phi_3532_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3532_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3532_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3532_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e927 = phi_3532_;
                                                let _e933 = global_3.member[_e707.member_1][0u];
                                                let _e937 = global_3.member[_e707.member_1][1u];
                                                let _e941 = global_3.member[_e707.member_1][2u];
                                                let _e945 = global_3.member[_e707.member_1][3u];
                                                let _e957 = (((_e937 >> bitcast<u32>(22i)) | ((_e941 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e945 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e958 = (_e933 & 268435455u);
                                                let _e959 = (_e957 & 268435455u);
                                                let _e962 = ((_e933 >> bitcast<u32>(28u)) & 7u);
                                                let _e970 = ((_e933 >> bitcast<u32>(31i)) | (((_e957 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e971 = (_e962 != 0u);
                                                if (_e962 == 0u) {
                                                    phi_3787_ = _e958;
                                                } else {
                                                    if (_e962 == 7u) {
                                                        phi_3786_ = 2147483648u;
                                                    } else {
                                                        phi_3786_ = ((2147483648u | (_e962 << bitcast<u32>(28u))) | (_e959 & 268435455u));
                                                    }
                                                    let _e980 = phi_3786_;
                                                    phi_3787_ = _e980;
                                                }
                                                let _e982 = phi_3787_;
                                                if _e971 {
                                                    let _e983 = (_e962 != 7u);
                                                    if _e983 {
                                                        phi_3797_ = (_e959 + (_e962 * ((3u * _e927) + 1u)));
                                                    } else {
                                                        phi_3797_ = u32();
                                                    }
                                                    let _e987 = phi_3797_;
                                                    phi_3799_ = _e987;
                                                    phi_3800_ = select(true, false, _e983);
                                                } else {
                                                    phi_3799_ = u32();
                                                    phi_3800_ = true;
                                                }
                                                let _e990 = phi_3799_;
                                                let _e992 = phi_3800_;
                                                if (_e970 == 0u) {
                                                    phi_3821_ = (_e958 + select(0u, 1u, !(_e971)));
                                                } else {
                                                    if (_e970 == 7u) {
                                                        phi_3820_ = 2147483648u;
                                                    } else {
                                                        phi_3820_ = ((2147483648u | (_e970 << bitcast<u32>(28u))) | (select(_e990, _e959, _e992) & 268435455u));
                                                    }
                                                    let _e1005 = phi_3820_;
                                                    phi_3821_ = _e1005;
                                                }
                                                let _e1007 = phi_3821_;
                                                phi_3825_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e885, (_e707.member.member.x + _e837), _e890, (_e707.member.member_1.x - _e876)), vec4<f32>(_e886, (_e707.member.member.y + _e841), _e891, (_e707.member.member_1.y - _e880)), vec4<f32>(_e887, (_e707.member.member.z + _e845), _e892, (_e707.member.member_1.z - _e884))), type_49(type_34((_e707.member.member + vec4<f32>(_e815, _e824, _e833, 0f)), (_e707.member.member_1 - vec4<f32>(_e854, _e863, _e872, 0f))), _e982), type_49(type_34((_e707.member.member + vec4<f32>(_e837, _e841, _e845, 0f)), (_e707.member.member_1 - vec4<f32>(_e876, _e880, _e884, 0f))), _e1007));
                                            }
                                            let _e1012 = phi_3825_;
                                            let _e1031 = ((_e1012.member[0].x - _e366) * _e371);
                                            let _e1032 = ((_e1012.member[0].y - _e366) * _e371);
                                            let _e1033 = ((_e1012.member[0].z - _e367) * _e371);
                                            let _e1034 = ((_e1012.member[0].w - _e367) * _e371);
                                            let _e1044 = ((_e1012.member[1].x - _e432) * _e437);
                                            let _e1045 = ((_e1012.member[1].y - _e432) * _e437);
                                            let _e1046 = ((_e1012.member[1].z - _e433) * _e437);
                                            let _e1047 = ((_e1012.member[1].w - _e433) * _e437);
                                            let _e1057 = ((_e1012.member[2].x - _e498) * _e503);
                                            let _e1058 = ((_e1012.member[2].y - _e498) * _e503);
                                            let _e1059 = ((_e1012.member[2].z - _e499) * _e503);
                                            let _e1060 = ((_e1012.member[2].w - _e499) * _e503);
                                            let _e1062 = select(_e1059, _e1057, (_e1057 < _e1059));
                                            let _e1064 = select(_e1060, _e1058, (_e1058 < _e1060));
                                            let _e1066 = select(_e1059, _e1057, (_e1057 > _e1059));
                                            let _e1068 = select(_e1060, _e1058, (_e1058 > _e1060));
                                            let _e1070 = select(_e1033, _e1031, (_e1031 < _e1033));
                                            let _e1072 = select(_e1034, _e1032, (_e1032 < _e1034));
                                            let _e1074 = select(_e1046, _e1044, (_e1044 < _e1046));
                                            let _e1076 = select(_e1047, _e1045, (_e1045 < _e1047));
                                            let _e1078 = select(_e1074, _e1070, (_e1070 > _e1074));
                                            let _e1080 = select(_e1076, _e1072, (_e1072 > _e1076));
                                            let _e1082 = select(_e1062, _e1078, (_e1078 > _e1062));
                                            let _e1084 = select(_e1064, _e1080, (_e1080 > _e1064));
                                            let _e1086 = select(_e1033, _e1031, (_e1031 > _e1033));
                                            let _e1088 = select(_e1034, _e1032, (_e1032 > _e1034));
                                            let _e1090 = select(_e1046, _e1044, (_e1044 > _e1046));
                                            let _e1092 = select(_e1047, _e1045, (_e1045 > _e1047));
                                            let _e1094 = select(_e1090, _e1086, (_e1086 < _e1090));
                                            let _e1096 = select(_e1092, _e1088, (_e1088 < _e1092));
                                            let _e1101 = -(_e1062);
                                            let _e1102 = -(_e1064);
                                            let _e1109 = (select(_e1066, _e1094, (_e1094 < _e1066)) + (select(_e1101, _e1066, (_e1066 > _e1101)) * 0.0000019073523f));
                                            let _e1110 = (select(_e1068, _e1096, (_e1096 < _e1068)) + (select(_e1102, _e1068, (_e1068 > _e1102)) * 0.0000019073523f));
                                            let _e1112 = select(_e614, _e1082, (_e1082 > _e614));
                                            let _e1114 = select(_e614, _e1084, (_e1084 > _e614));
                                            let _e1119 = (_e1112 <= select(_e663.member.member_1, _e1109, (_e1109 < _e663.member.member_1)));
                                            let _e1120 = (_e1114 <= select(_e663.member.member_1, _e1110, (_e1110 < _e663.member.member_1)));
                                            let _e1121 = (_e1112 <= _e1114);
                                            if _e1119 {
                                                if _e1120 {
                                                    if _e1121 {
                                                        phi_4190_ = _e1012.member_2;
                                                    } else {
                                                        phi_4190_ = _e1012.member_1;
                                                    }
                                                    let _e1125 = phi_4190_;
                                                    let _e1147 = (_e705 % 128u);
                                                    let _e1148 = (_e1147 < 128u);
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1147] = _e1125.member_1;
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1147] = _e1125.member.member.x;
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1147] = _e1125.member.member.y;
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1147] = _e1125.member.member.z;
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1147] = _e1125.member.member_1.x;
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1147] = _e1125.member.member_1.y;
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1147] = _e1125.member.member_1.z;
                                                    if _e1148 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1147] = select(_e1114, _e1112, !(_e1121));
                                                    if _e1121 {
                                                        phi_4267_ = _e1012.member_1;
                                                    } else {
                                                        phi_4267_ = _e1012.member_2;
                                                    }
                                                    let _e1161 = phi_4267_;
                                                    phi_4268_ = (_e705 + 1u);
                                                    phi_4269_ = _e1161;
                                                } else {
                                                    phi_4268_ = u32();
                                                    phi_4269_ = type_49();
                                                }
                                                let _e1163 = phi_4268_;
                                                let _e1165 = phi_4269_;
                                                phi_4271_ = _e1163;
                                                phi_4272_ = _e1165;
                                                phi_4273_ = select(true, false, _e1120);
                                            } else {
                                                phi_4271_ = u32();
                                                phi_4272_ = type_49();
                                                phi_4273_ = true;
                                            }
                                            let _e1168 = phi_4271_;
                                            let _e1170 = phi_4272_;
                                            let _e1172 = phi_4273_;
                                            if _e1172 {
                                                if _e1119 {
                                                    phi_4282_ = _e1012.member_1;
                                                } else {
                                                    phi_4282_ = _e1012.member_2;
                                                }
                                                let _e1176 = phi_4282_;
                                                phi_4287_ = select(_e1120, true, _e1119);
                                                phi_4289_ = _e1176;
                                            } else {
                                                phi_4287_ = _e703;
                                                phi_4289_ = _e1170;
                                            }
                                            let _e1179 = phi_4287_;
                                            let _e1181 = phi_4289_;
                                            phi_4988_ = _e661;
                                            phi_4294_ = type_42(_e663.member, (_e663.member_1 + 1u), _e663.member_2);
                                            phi_4295_ = _e1179;
                                            phi_4296_ = select(_e1168, _e705, _e1172);
                                            phi_4297_ = _e1181;
                                        }
                                        let _e2137 = phi_4988_;
                                        let _e2139 = phi_4294_;
                                        let _e2141 = phi_4295_;
                                        let _e2143 = phi_4296_;
                                        let _e2145 = phi_4297_;
                                        phi_4987_ = _e2137;
                                        phi_4298_ = _e2139;
                                        phi_4299_ = _e2141;
                                        phi_4300_ = (_e667 - 1u);
                                        phi_4301_ = _e2143;
                                        phi_4302_ = _e2145;
                                    } else {
                                        phi_4987_ = _e661;
                                        phi_4298_ = _e663;
                                        phi_4299_ = _e703;
                                        phi_4300_ = _e667;
                                        phi_4301_ = _e705;
                                        phi_4302_ = _e707;
                                    }
                                    let _e2147 = phi_4987_;
                                    let _e2149 = phi_4298_;
                                    let _e2151 = phi_4299_;
                                    let _e2153 = phi_4300_;
                                    let _e2155 = phi_4301_;
                                    let _e2157 = phi_4302_;
                                    phi_4986_ = _e2147;
                                    phi_4303_ = _e2149;
                                    phi_4304_ = _e2151;
                                    phi_4305_ = _e2153;
                                    phi_4306_ = _e2155;
                                    phi_4307_ = _e2157;
                                } else {
                                    phi_4986_ = _e661;
                                    phi_4303_ = type_42();
                                    phi_4304_ = bool();
                                    phi_4305_ = u32();
                                    phi_4306_ = u32();
                                    phi_4307_ = type_49();
                                }
                                let _e2159 = phi_4986_;
                                let _e2161 = phi_4303_;
                                let _e2163 = phi_4304_;
                                let _e2165 = phi_4305_;
                                let _e2167 = phi_4306_;
                                let _e2169 = phi_4307_;
                                phi_4985_ = _e2159;
                                phi_1192_ = _e2161;
                                phi_1195_ = _e2163;
                                phi_1197_ = _e2165;
                                phi_1199_ = _e2167;
                                phi_1201_ = _e2169;
                                phi_4308_ = _e675;
                            } else {
                                phi_4985_ = _e661;
                                phi_1192_ = type_42();
                                phi_1195_ = bool();
                                phi_1197_ = u32();
                                phi_1199_ = u32();
                                phi_1201_ = type_49();
                                phi_4308_ = false;
                            }
                            let _e2171 = phi_4985_;
                            let _e2173 = phi_1192_;
                            let _e2175 = phi_1195_;
                            let _e2177 = phi_1197_;
                            let _e2179 = phi_1199_;
                            let _e2181 = phi_1201_;
                            let _e2183 = phi_4308_;
                            continue;
                            continuing {
                                phi_4783_ = _e2171;
                                phi_1191_ = _e2173;
                                phi_1194_ = _e2175;
                                phi_1196_ = _e2177;
                                phi_1198_ = _e2179;
                                phi_1200_ = _e2181;
                                phi_4984_ = _e2171;
                                break if !(_e2183);
                            }
                        }
                        let _e2186 = phi_4984_;
                        if _e2186 {
                            break;
                        }
                        let _e2188 = local_10;
                        if (_e2188.member.member.member_3 != 4294967295u) {
                            let _e2194 = bitcast<u32>(_e2188.member.member.member);
                            let _e2198 = (bitcast<i32>((_e2194 >> bitcast<u32>(23i))) & 255i);
                            let _e2199 = (_e2198 + _e283);
                            if (_e2198 == 255i) {
                                phi_4367_ = _e2188.member.member.member;
                            } else {
                                if (_e2198 > 0i) {
                                    if (_e2199 > 0i) {
                                        let _e2203 = (_e2199 < 255i);
                                        if _e2203 {
                                            phi_4346_ = bitcast<f32>((_e2194 + bitcast<u32>((_e283 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4346_ = f32();
                                        }
                                        let _e2210 = phi_4346_;
                                        phi_4348_ = _e2210;
                                        phi_4349_ = select(true, false, _e2203);
                                    } else {
                                        phi_4348_ = f32();
                                        phi_4349_ = true;
                                    }
                                    let _e2213 = phi_4348_;
                                    let _e2215 = phi_4349_;
                                    phi_4350_ = _e2213;
                                    phi_4351_ = _e2215;
                                } else {
                                    phi_4350_ = f32();
                                    phi_4351_ = true;
                                }
                                let _e2217 = phi_4350_;
                                let _e2219 = phi_4351_;
                                if _e2219 {
                                    let _e2220 = (_e2194 & 2147483648u);
                                    let _e2227 = ((_e2194 & 8388607u) | (select(0u, 1u, ((_e2194 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2231 = (_e2227 == 0u);
                                    if _e2231 {
                                        phi_4735_ = bitcast<f32>(_e2220);
                                    } else {
                                        let _e2236 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2227)), 32u, _e2231) - 8u);
                                        let _e2239 = (_e2227 << bitcast<u32>((_e2236 & 31u)));
                                        let _e2241 = ((_e2199 + select(0i, 1i, (_e2198 == 0i))) - bitcast<i32>(_e2236));
                                        if (_e2241 >= 255i) {
                                            phi_4725_ = bitcast<f32>((_e2220 | 2139095040u));
                                            phi_4726_ = f32();
                                            phi_4727_ = true;
                                        } else {
                                            let _e2243 = (_e2241 > 0i);
                                            if _e2243 {
                                                phi_4719_ = bitcast<f32>(((_e2220 | (bitcast<u32>(_e2241) << bitcast<u32>(23i))) | (_e2239 & 8388607u)));
                                                phi_4720_ = f32();
                                            } else {
                                                if (_e2241 < -24i) {
                                                    phi_4685_ = 26u;
                                                } else {
                                                    phi_4685_ = bitcast<u32>((1i - _e2241));
                                                }
                                                let _e2248 = phi_4685_;
                                                let _e2249 = (_e2248 & 31u);
                                                let _e2251 = (_e2239 >> bitcast<u32>(_e2249));
                                                let _e2255 = (_e2239 & ((1u << bitcast<u32>(_e2249)) - 1u));
                                                let _e2259 = (1u << bitcast<u32>(((_e2248 - 1u) & 31u)));
                                                if (_e2255 > _e2259) {
                                                    phi_4706_ = true;
                                                } else {
                                                    if (_e2255 == _e2259) {
                                                        phi_4703_ = ((_e2251 & 1u) == 1u);
                                                    } else {
                                                        phi_4703_ = false;
                                                    }
                                                    let _e2265 = phi_4703_;
                                                    phi_4706_ = _e2265;
                                                }
                                                let _e2267 = phi_4706_;
                                                phi_4719_ = f32();
                                                phi_4720_ = bitcast<f32>((_e2220 | (_e2251 + select(0u, 1u, _e2267))));
                                            }
                                            let _e2280 = phi_4719_;
                                            let _e2282 = phi_4720_;
                                            phi_4725_ = _e2280;
                                            phi_4726_ = _e2282;
                                            phi_4727_ = _e2243;
                                        }
                                        let _e2286 = phi_4725_;
                                        let _e2288 = phi_4726_;
                                        let _e2290 = phi_4727_;
                                        phi_4735_ = select(_e2288, _e2286, _e2290);
                                    }
                                    let _e2294 = phi_4735_;
                                    phi_4366_ = _e2294;
                                } else {
                                    phi_4366_ = _e2217;
                                }
                                let _e2296 = phi_4366_;
                                phi_4367_ = _e2296;
                            }
                            let _e2298 = phi_4367_;
                            let _e2299 = bitcast<u32>(_e2298);
                            if ((_e2299 & 2147483647u) >= 2139095040u) {
                                phi_4379_ = bitcast<f32>(((_e2299 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4379_ = _e2298;
                            }
                            let _e2306 = phi_4379_;
                            phi_4384_ = type_22(_e2306, _e2188.member.member.member_1, _e2188.member.member.member_2, _e2188.member.member.member_3);
                        } else {
                            phi_4384_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2311 = phi_4384_;
                        if _e159 {
                        } else {
                            break;
                        }
                        global_1.member[_e143] = _e2311;
                        let _e2315 = local_11;
                        if _e160 {
                        } else {
                            break;
                        }
                        global_5.member[_e143] = _e2315.member_1;
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e2320 = select(0u, 1u, (_e227 <= _e237));
                        if (_e2320 > 0u) {
                            let _e2322 = (1u < _e111);
                            if _e2322 {
                                if (0u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2326 = atomicAdd((&global_6.member[0u]), _e2320);
                                if ((_e2326 + _e2320) < _e2326) {
                                    if _e2322 {
                                    } else {
                                        break;
                                    }
                                    let _e2331 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2334 = select(0u, 1u, (_e2311.member_3 != 4294967295u));
                        if (_e2334 > 0u) {
                            let _e2336 = (3u < _e111);
                            if _e2336 {
                                if (2u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2340 = atomicAdd((&global_6.member[2u]), _e2334);
                                if ((_e2340 + _e2334) < _e2340) {
                                    if _e2336 {
                                    } else {
                                        break;
                                    }
                                    let _e2345 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2315.member_1 > 0u) {
                            let _e2347 = (5u < _e111);
                            if _e2347 {
                                if (4u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2351 = atomicAdd((&global_6.member[4u]), _e2315.member_1);
                                if ((_e2351 + _e2315.member_1) < _e2351) {
                                    if _e2347 {
                                    } else {
                                        break;
                                    }
                                    let _e2356 = atomicAdd((&global_6.member[5u]), 1u);
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
