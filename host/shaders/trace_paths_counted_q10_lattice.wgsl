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
    var phi_4789_: bool;
    var phi_1191_: type_42;
    var phi_1194_: u32;
    var phi_1196_: bool;
    var phi_1198_: u32;
    var phi_1200_: type_49;
    var phi_1211_: bool;
    var phi_1297_: bool;
    var phi_1298_: u32;
    var phi_1299_: type_49;
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
    var phi_4783_: bool;
    var phi_5081_: bool;
    var phi_3020_: type_42;
    var phi_3522_: u32;
    var phi_3528_: u32;
    var phi_3782_: u32;
    var phi_3783_: u32;
    var phi_3793_: u32;
    var phi_3795_: u32;
    var phi_3796_: bool;
    var phi_3816_: u32;
    var phi_3817_: u32;
    var phi_3821_: type_50;
    var phi_4186_: type_49;
    var phi_4262_: type_49;
    var phi_4263_: u32;
    var phi_4264_: type_49;
    var phi_4266_: u32;
    var phi_4267_: type_49;
    var phi_4268_: bool;
    var phi_4277_: type_49;
    var phi_4282_: bool;
    var phi_4284_: type_49;
    var phi_4289_: type_42;
    var phi_4290_: bool;
    var phi_4291_: u32;
    var phi_4292_: type_49;
    var phi_4300_: type_42;
    var phi_4303_: type_49;
    var phi_4993_: bool;
    var phi_4304_: type_42;
    var phi_4305_: u32;
    var phi_4306_: bool;
    var phi_4307_: u32;
    var phi_4308_: type_49;
    var phi_4992_: bool;
    var phi_4309_: type_42;
    var phi_4310_: u32;
    var phi_4311_: bool;
    var phi_4312_: u32;
    var phi_4313_: type_49;
    var phi_4991_: bool;
    var phi_1192_: type_42;
    var phi_1195_: u32;
    var phi_1197_: bool;
    var phi_1199_: u32;
    var phi_1201_: type_49;
    var phi_4314_: bool;
    var phi_4990_: bool;
    var local_10: type_42;
    var phi_4352_: f32;
    var phi_4354_: f32;
    var phi_4355_: bool;
    var phi_4356_: f32;
    var phi_4357_: bool;
    var phi_4691_: u32;
    var phi_4709_: bool;
    var phi_4712_: bool;
    var phi_4725_: f32;
    var phi_4726_: f32;
    var phi_4731_: f32;
    var phi_4732_: f32;
    var phi_4733_: bool;
    var phi_4741_: f32;
    var phi_4372_: f32;
    var phi_4373_: f32;
    var phi_4385_: f32;
    var phi_4390_: type_22;
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
                        phi_4789_ = false;
                        phi_1191_ = type_42(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e612), 0u, 0u);
                        phi_1194_ = ((3u * _e100) + 1u);
                        phi_1196_ = (_e614 <= _e612);
                        phi_1198_ = 0u;
                        phi_1200_ = type_49(type_34(vec4<f32>((f32(_e626) * _e155), (f32(_e632) * _e155), (f32(_e638) * _e155), 0f), vec4<f32>((f32(_e643) * _e155), (f32(_e647) * _e155), (f32(_e651) * _e155), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        loop {
                            let _e661 = phi_4789_;
                            let _e663 = phi_1191_;
                            let _e665 = phi_1194_;
                            let _e667 = phi_1196_;
                            let _e669 = phi_1198_;
                            let _e671 = phi_1200_;
                            local_10 = _e663;
                            local_11 = _e663;
                            if _e667 {
                                phi_1211_ = true;
                            } else {
                                phi_1211_ = (_e669 > 0u);
                            }
                            let _e674 = phi_1211_;
                            if _e674 {
                                let _e675 = (_e665 > 0u);
                                if _e675 {
                                    if _e667 {
                                        phi_1297_ = _e667;
                                        phi_1298_ = _e669;
                                        phi_1299_ = _e671;
                                    } else {
                                        let _e676 = (_e669 - 1u);
                                        let _e677 = (_e676 % 128u);
                                        let _e678 = (_e677 < 128u);
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e680 = local_7[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e682 = local_6[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e684 = local_5[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e686 = local_4[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e688 = local_3[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e690 = local_2[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e695 = local_8[_e677];
                                        if _e678 {
                                        } else {
                                            phi_4990_ = true;
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
                                        let _e711 = ((_e707.member_1 & 2147483648u) != 0u);
                                        let _e712 = (_e707.member_1 & 268435455u);
                                        if _e711 {
                                            phi_1318_ = _e663;
                                            phi_1321_ = type_8(0u, ((_e707.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e719 = phi_1318_;
                                                let _e721 = phi_1321_;
                                                local_12 = _e719;
                                                if (_e721.member < _e721.member_1) {
                                                    phi_1322_ = type_8((_e721.member + 1u), _e721.member_1);
                                                    phi_1344_ = type_8(1u, _e721.member);
                                                } else {
                                                    phi_1322_ = _e721;
                                                    phi_1344_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e734 = phi_1322_;
                                                let _e736 = phi_1344_;
                                                let _e740 = (bitcast<i32>(_e736.member) != 0i);
                                                if _e740 {
                                                    let _e746 = type_42(_e719.member, _e719.member_1, (_e719.member_2 + 1u));
                                                    let _e751 = (_e707.member.member_1.x - _e707.member.member.x);
                                                    let _e754 = (_e707.member.member_1.y - _e707.member.member.y);
                                                    let _e757 = (_e707.member.member_1.z - _e707.member.member.z);
                                                    let _e759 = select(_e754, _e751, (_e751 > _e754));
                                                    let _e761 = select(_e757, _e759, (_e759 > _e757));
                                                    let _e763 = (_e761 < (1024f * _e155));
                                                    if _e763 {
                                                        phi_1388_ = 0u;
                                                    } else {
                                                        phi_1388_ = select(2u, 1u, (_e761 < (2097152f * _e155)));
                                                    }
                                                    let _e768 = phi_1388_;
                                                    switch bitcast<i32>(_e768) {
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
                                                    let _e771 = phi_1394_;
                                                    switch bitcast<i32>(_e768) {
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
                                                    let _e778 = phi_1404_;
                                                    let _e780 = ((_e712 + (_e736.member_1 * ((3u * _e771) + 1u))) + (3u * _e778));
                                                    let _e781 = (_e780 < _e103);
                                                    if _e781 {
                                                        if _e781 {
                                                        } else {
                                                            phi_4783_ = true;
                                                            break;
                                                        }
                                                        let _e783 = global_7.member[_e780];
                                                        phi_1420_ = _e783;
                                                    } else {
                                                        phi_1420_ = 4294967295u;
                                                    }
                                                    let _e785 = phi_1420_;
                                                    if _e763 {
                                                        phi_1453_ = 0u;
                                                    } else {
                                                        phi_1453_ = select(2u, 1u, (_e761 < (2097152f * _e155)));
                                                    }
                                                    let _e790 = phi_1453_;
                                                    switch bitcast<i32>(_e790) {
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
                                                    let _e793 = phi_1459_;
                                                    let _e797 = (_e712 + (_e736.member_1 * ((3u * _e793) + 1u)));
                                                    switch bitcast<i32>(_e790) {
                                                        case 0: {
                                                            let _e1072 = (_e797 < _e103);
                                                            if _e1072 {
                                                                if _e1072 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1074 = global_7.member[_e797];
                                                                phi_1486_ = _e1074;
                                                            } else {
                                                                phi_1486_ = 0u;
                                                            }
                                                            let _e1076 = phi_1486_;
                                                            let _e1078 = ((10u * _e281) & 31u);
                                                            let _e1088 = ((10u * _e280) & 31u);
                                                            let _e1098 = ((10u * _e282) & 31u);
                                                            let _e1108 = (_e797 + 1u);
                                                            let _e1109 = (_e1108 < _e103);
                                                            if _e1109 {
                                                                if _e1109 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1111 = global_7.member[_e1108];
                                                                phi_1535_ = _e1111;
                                                            } else {
                                                                phi_1535_ = 0u;
                                                            }
                                                            let _e1113 = phi_1535_;
                                                            let _e1139 = (_e797 + 2u);
                                                            let _e1140 = (_e1139 < _e103);
                                                            if _e1140 {
                                                                if _e1140 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1142 = global_7.member[_e1139];
                                                                phi_1584_ = _e1142;
                                                            } else {
                                                                phi_1584_ = 0u;
                                                            }
                                                            let _e1144 = phi_1584_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1076 >> bitcast<u32>(_e1078)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1076 >> bitcast<u32>(_e1088)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1076 >> bitcast<u32>(_e1098)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1113 >> bitcast<u32>(_e1078)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1113 >> bitcast<u32>(_e1088)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1113 >> bitcast<u32>(_e1098)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | ((_e1144 >> bitcast<u32>(_e1078)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | ((_e1144 >> bitcast<u32>(_e1088)) & 1023u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | ((_e1144 >> bitcast<u32>(_e1098)) & 1023u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e886 = (_e797 < _e103);
                                                            if _e886 {
                                                                if _e886 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e888 = global_7.member[_e797];
                                                                phi_1633_ = _e888;
                                                            } else {
                                                                phi_1633_ = 0u;
                                                            }
                                                            let _e890 = phi_1633_;
                                                            let _e891 = (_e797 + 1u);
                                                            let _e892 = (_e891 < _e103);
                                                            if _e892 {
                                                                if _e892 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e894 = global_7.member[_e891];
                                                                phi_1648_ = _e894;
                                                            } else {
                                                                phi_1648_ = 0u;
                                                            }
                                                            let _e896 = phi_1648_;
                                                            let _e897 = (_e281 == 1u);
                                                            if _e897 {
                                                                phi_1658_ = ((_e890 >> bitcast<u32>(21i)) | (_e896 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1658_ = (_e896 >> bitcast<u32>(10i));
                                                            }
                                                            let _e906 = phi_1658_;
                                                            let _e914 = (_e280 == 1u);
                                                            if _e914 {
                                                                phi_1679_ = ((_e890 >> bitcast<u32>(21i)) | (_e896 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1679_ = (_e896 >> bitcast<u32>(10i));
                                                            }
                                                            let _e923 = phi_1679_;
                                                            let _e931 = (_e282 == 1u);
                                                            if _e931 {
                                                                phi_1700_ = ((_e890 >> bitcast<u32>(21i)) | (_e896 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1700_ = (_e896 >> bitcast<u32>(10i));
                                                            }
                                                            let _e940 = phi_1700_;
                                                            let _e949 = (_e797 + 2u);
                                                            let _e950 = (_e949 < _e103);
                                                            if _e950 {
                                                                if _e950 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e952 = global_7.member[_e949];
                                                                phi_1730_ = _e952;
                                                            } else {
                                                                phi_1730_ = 0u;
                                                            }
                                                            let _e954 = phi_1730_;
                                                            let _e955 = (_e797 + 3u);
                                                            let _e956 = (_e955 < _e103);
                                                            if _e956 {
                                                                if _e956 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e958 = global_7.member[_e955];
                                                                phi_1745_ = _e958;
                                                            } else {
                                                                phi_1745_ = 0u;
                                                            }
                                                            let _e960 = phi_1745_;
                                                            if _e897 {
                                                                phi_1755_ = ((_e954 >> bitcast<u32>(21i)) | (_e960 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1755_ = (_e960 >> bitcast<u32>(10i));
                                                            }
                                                            let _e969 = phi_1755_;
                                                            if _e914 {
                                                                phi_1776_ = ((_e954 >> bitcast<u32>(21i)) | (_e960 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1776_ = (_e960 >> bitcast<u32>(10i));
                                                            }
                                                            let _e985 = phi_1776_;
                                                            if _e931 {
                                                                phi_1797_ = ((_e954 >> bitcast<u32>(21i)) | (_e960 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1797_ = (_e960 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1001 = phi_1797_;
                                                            let _e1010 = (_e797 + 4u);
                                                            let _e1011 = (_e1010 < _e103);
                                                            if _e1011 {
                                                                if _e1011 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1013 = global_7.member[_e1010];
                                                                phi_1827_ = _e1013;
                                                            } else {
                                                                phi_1827_ = 0u;
                                                            }
                                                            let _e1015 = phi_1827_;
                                                            let _e1016 = (_e797 + 5u);
                                                            let _e1017 = (_e1016 < _e103);
                                                            if _e1017 {
                                                                if _e1017 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1019 = global_7.member[_e1016];
                                                                phi_1842_ = _e1019;
                                                            } else {
                                                                phi_1842_ = 0u;
                                                            }
                                                            let _e1021 = phi_1842_;
                                                            if _e897 {
                                                                phi_1852_ = ((_e1015 >> bitcast<u32>(21i)) | (_e1021 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1852_ = (_e1021 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1030 = phi_1852_;
                                                            if _e914 {
                                                                phi_1873_ = ((_e1015 >> bitcast<u32>(21i)) | (_e1021 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1873_ = (_e1021 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1046 = phi_1873_;
                                                            if _e931 {
                                                                phi_1894_ = ((_e1015 >> bitcast<u32>(21i)) | (_e1021 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1894_ = (_e1021 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1062 = phi_1894_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e906, _e890, _e305) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e923, _e890, _e372) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e940, _e890, _e438) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e969, _e954, _e305) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e985, _e954, _e372) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1001, _e954, _e438) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e707.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1030, _e1015, _e305) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1046, _e1015, _e372) & 2097151u))) - 8388608f) * _e155)), (_e707.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1062, _e1015, _e438) & 2097151u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e799 = (_e797 + _e281);
                                                            let _e800 = (_e799 < _e103);
                                                            if _e800 {
                                                                if _e800 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e802 = global_7.member[_e799];
                                                                phi_1925_ = _e802;
                                                            } else {
                                                                phi_1925_ = 0u;
                                                            }
                                                            let _e804 = phi_1925_;
                                                            let _e808 = (_e797 + _e280);
                                                            let _e809 = (_e808 < _e103);
                                                            if _e809 {
                                                                if _e809 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e811 = global_7.member[_e808];
                                                                phi_1943_ = _e811;
                                                            } else {
                                                                phi_1943_ = 0u;
                                                            }
                                                            let _e813 = phi_1943_;
                                                            let _e817 = (_e797 + _e282);
                                                            let _e818 = (_e817 < _e103);
                                                            if _e818 {
                                                                if _e818 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e820 = global_7.member[_e817];
                                                                phi_1961_ = _e820;
                                                            } else {
                                                                phi_1961_ = 0u;
                                                            }
                                                            let _e822 = phi_1961_;
                                                            let _e827 = (_e797 + 3u);
                                                            let _e828 = (_e827 + _e281);
                                                            let _e829 = (_e828 < _e103);
                                                            if _e829 {
                                                                if _e829 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e831 = global_7.member[_e828];
                                                                phi_1984_ = _e831;
                                                            } else {
                                                                phi_1984_ = 0u;
                                                            }
                                                            let _e833 = phi_1984_;
                                                            let _e837 = (_e827 + _e280);
                                                            let _e838 = (_e837 < _e103);
                                                            if _e838 {
                                                                if _e838 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e840 = global_7.member[_e837];
                                                                phi_2002_ = _e840;
                                                            } else {
                                                                phi_2002_ = 0u;
                                                            }
                                                            let _e842 = phi_2002_;
                                                            let _e846 = (_e827 + _e282);
                                                            let _e847 = (_e846 < _e103);
                                                            if _e847 {
                                                                if _e847 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e849 = global_7.member[_e846];
                                                                phi_2020_ = _e849;
                                                            } else {
                                                                phi_2020_ = 0u;
                                                            }
                                                            let _e851 = phi_2020_;
                                                            let _e856 = (_e797 + 6u);
                                                            let _e857 = (_e856 + _e281);
                                                            let _e858 = (_e857 < _e103);
                                                            if _e858 {
                                                                if _e858 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e860 = global_7.member[_e857];
                                                                phi_2043_ = _e860;
                                                            } else {
                                                                phi_2043_ = 0u;
                                                            }
                                                            let _e862 = phi_2043_;
                                                            let _e866 = (_e856 + _e280);
                                                            let _e867 = (_e866 < _e103);
                                                            if _e867 {
                                                                if _e867 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e869 = global_7.member[_e866];
                                                                phi_2061_ = _e869;
                                                            } else {
                                                                phi_2061_ = 0u;
                                                            }
                                                            let _e871 = phi_2061_;
                                                            let _e875 = (_e856 + _e282);
                                                            let _e876 = (_e875 < _e103);
                                                            if _e876 {
                                                                if _e876 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e878 = global_7.member[_e875];
                                                                phi_2079_ = _e878;
                                                            } else {
                                                                phi_2079_ = 0u;
                                                            }
                                                            let _e880 = phi_2079_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e804)) * _e155), (f32(bitcast<i32>(_e813)) * _e155), (f32(bitcast<i32>(_e822)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e833)) * _e155), (f32(bitcast<i32>(_e842)) * _e155), (f32(bitcast<i32>(_e851)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e862)) * _e155), (f32(bitcast<i32>(_e871)) * _e155), (f32(bitcast<i32>(_e880)) * _e155)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2085_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1172 = phi_2085_;
                                                    let _e1181 = (_e1172[0][2] - _e461);
                                                    let _e1184 = (((_e1172[0][0] - _e328) * _e500) - (_e1181 * _e368));
                                                    let _e1187 = (((_e1172[0][1] - _e395) * _e500) - (_e1181 * _e434));
                                                    let _e1194 = (_e1172[1][2] - _e461);
                                                    let _e1197 = (((_e1172[1][0] - _e328) * _e500) - (_e1194 * _e368));
                                                    let _e1200 = (((_e1172[1][1] - _e395) * _e500) - (_e1194 * _e434));
                                                    let _e1207 = (_e1172[2][2] - _e461);
                                                    let _e1210 = (((_e1172[2][0] - _e328) * _e500) - (_e1207 * _e368));
                                                    let _e1213 = (((_e1172[2][1] - _e395) * _e500) - (_e1207 * _e434));
                                                    let _e1214 = (_e1210 * _e1200);
                                                    let _e1215 = (_e1213 * _e1197);
                                                    let _e1216 = (_e1184 * _e1213);
                                                    let _e1217 = (_e1187 * _e1210);
                                                    let _e1218 = (_e1197 * _e1187);
                                                    let _e1219 = (_e1200 * _e1184);
                                                    let _e1224 = (((_e1214 >= _e1215) && (_e1216 >= _e1217)) && (_e1218 >= _e1219));
                                                    if (_e1224 || (((_e1214 <= _e1215) && (_e1216 <= _e1217)) && (_e1218 <= _e1219))) {
                                                        let _e1231 = select(-1f, 1f, _e1224);
                                                        let _e1233 = ((_e1214 - _e1215) * _e1231);
                                                        let _e1235 = select(0f, _e1233, (_e1233 > 0f));
                                                        let _e1237 = ((_e1216 - _e1217) * _e1231);
                                                        let _e1239 = select(0f, _e1237, (_e1237 > 0f));
                                                        let _e1241 = ((_e1218 - _e1219) * _e1231);
                                                        let _e1243 = select(0f, _e1241, (_e1241 > 0f));
                                                        let _e1245 = ((_e1235 + _e1239) + _e1243);
                                                        if (_e1245 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2969_ = type_22();
                                                            phi_2970_ = true;
                                                            phi_2971_ = false;
                                                        } else {
                                                            let _e1248 = select(_e1197, _e1184, (_e1184 < _e1197));
                                                            if (select(_e1210, _e1248, (_e1248 < _e1210)) > 0f) {
                                                                phi_2237_ = true;
                                                            } else {
                                                                let _e1253 = select(_e1197, _e1184, (_e1184 > _e1197));
                                                                phi_2237_ = (select(_e1210, _e1253, (_e1253 > _e1210)) < 0f);
                                                            }
                                                            let _e1258 = phi_2237_;
                                                            if _e1258 {
                                                                phi_2966_ = type_22();
                                                                phi_2967_ = true;
                                                                phi_2968_ = false;
                                                            } else {
                                                                let _e1260 = select(_e1200, _e1187, (_e1187 < _e1200));
                                                                if (select(_e1213, _e1260, (_e1260 < _e1213)) > 0f) {
                                                                    phi_2266_ = true;
                                                                } else {
                                                                    let _e1265 = select(_e1200, _e1187, (_e1187 > _e1200));
                                                                    phi_2266_ = (select(_e1213, _e1265, (_e1265 > _e1213)) < 0f);
                                                                }
                                                                let _e1270 = phi_2266_;
                                                                if _e1270 {
                                                                    phi_2964_ = type_22();
                                                                    phi_2965_ = false;
                                                                } else {
                                                                    let _e1272 = select(_e1172[1][0], _e1172[0][0], (_e1172[0][0] < _e1172[1][0]));
                                                                    let _e1276 = select(_e1172[1][0], _e1172[0][0], (_e1172[0][0] > _e1172[1][0]));
                                                                    let _e1280 = select(_e1172[1][1], _e1172[0][1], (_e1172[0][1] < _e1172[1][1]));
                                                                    let _e1284 = select(_e1172[1][1], _e1172[0][1], (_e1172[0][1] > _e1172[1][1]));
                                                                    let _e1288 = select(_e1172[1][2], _e1172[0][2], (_e1172[0][2] < _e1172[1][2]));
                                                                    let _e1292 = select(_e1172[1][2], _e1172[0][2], (_e1172[0][2] > _e1172[1][2]));
                                                                    let _e1297 = ((select(_e1172[2][0], _e1272, (_e1272 < _e1172[2][0])) - _e366) * _e371);
                                                                    let _e1298 = ((select(_e1172[2][0], _e1276, (_e1276 > _e1172[2][0])) - _e367) * _e371);
                                                                    let _e1301 = ((select(_e1172[2][1], _e1280, (_e1280 < _e1172[2][1])) - _e432) * _e437);
                                                                    let _e1302 = ((select(_e1172[2][1], _e1284, (_e1284 > _e1172[2][1])) - _e433) * _e437);
                                                                    let _e1305 = ((select(_e1172[2][2], _e1288, (_e1288 < _e1172[2][2])) - _e498) * _e503);
                                                                    let _e1306 = ((select(_e1172[2][2], _e1292, (_e1292 > _e1172[2][2])) - _e499) * _e503);
                                                                    let _e1308 = select(_e1306, _e1305, (_e1305 < _e1306));
                                                                    let _e1310 = select(_e1306, _e1305, (_e1305 > _e1306));
                                                                    let _e1312 = select(_e1298, _e1297, (_e1297 < _e1298));
                                                                    let _e1314 = select(_e1302, _e1301, (_e1301 < _e1302));
                                                                    let _e1316 = select(_e1314, _e1312, (_e1312 > _e1314));
                                                                    let _e1318 = select(_e1308, _e1316, (_e1316 > _e1308));
                                                                    let _e1320 = select(_e1298, _e1297, (_e1297 > _e1298));
                                                                    let _e1322 = select(_e1302, _e1301, (_e1301 > _e1302));
                                                                    let _e1324 = select(_e1322, _e1320, (_e1320 < _e1322));
                                                                    let _e1326 = select(_e1310, _e1324, (_e1324 < _e1310));
                                                                    let _e1327 = -(_e1308);
                                                                    let _e1333 = select(_e614, _e1318, (_e1318 > _e614));
                                                                    if (_e1333 > (_e1326 + (select(_e1327, _e1310, (_e1310 > _e1327)) * 0.0000019073523f))) {
                                                                        phi_2959_ = type_22();
                                                                        phi_2960_ = true;
                                                                    } else {
                                                                        let _e1335 = (_e1333 > _e719.member.member_1);
                                                                        if _e1335 {
                                                                            phi_2958_ = type_22();
                                                                        } else {
                                                                            let _e1336 = vec3<f32>(_e1172[0][0], _e1172[0][1], _e1172[0][2]);
                                                                            let _e1337 = vec3<f32>(_e1172[1][0], _e1172[1][1], _e1172[1][2]);
                                                                            let _e1338 = vec3<f32>(_e1172[2][0], _e1172[2][1], _e1172[2][2]);
                                                                            let _e1339 = (_e1172[1][0] - _e1172[0][0]);
                                                                            let _e1340 = (_e1172[1][1] - _e1172[0][1]);
                                                                            let _e1341 = (_e1172[1][2] - _e1172[0][2]);
                                                                            let _e1342 = vec3<f32>(_e1339, _e1340, _e1341);
                                                                            let _e1343 = (_e1172[2][0] - _e1172[1][0]);
                                                                            let _e1344 = (_e1172[2][1] - _e1172[1][1]);
                                                                            let _e1345 = (_e1172[2][2] - _e1172[1][2]);
                                                                            let _e1346 = vec3<f32>(_e1343, _e1344, _e1345);
                                                                            let _e1347 = (_e1172[0][0] - _e1172[2][0]);
                                                                            let _e1348 = (_e1172[0][1] - _e1172[2][1]);
                                                                            let _e1349 = (_e1172[0][2] - _e1172[2][2]);
                                                                            let _e1350 = vec3<f32>(_e1347, _e1348, _e1349);
                                                                            let _e1353 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                            let _e1356 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                            let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                                                                            let _e1361 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                            let _e1363 = select(_e1361, _e1358, (_e1358 > _e1361));
                                                                            let _e1366 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                            let _e1369 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                            let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                            let _e1374 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                            let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                            let _e1379 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                            let _e1382 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                            let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                            let _e1387 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                            let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                            let _e1391 = select(_e1376, _e1363, (_e1363 > _e1376));
                                                                            let _e1393 = select(_e1389, _e1391, (_e1391 > _e1389));
                                                                            if (_e1363 == _e1393) {
                                                                                phi_2685_ = _e1200;
                                                                                phi_2686_ = _e1197;
                                                                                phi_2687_ = _e1187;
                                                                                phi_2688_ = _e1184;
                                                                                phi_2689_ = _e1336;
                                                                                phi_2690_ = _e1350;
                                                                                phi_2691_ = _e1346;
                                                                                phi_2692_ = _e1342;
                                                                            } else {
                                                                                let _e1395 = (_e1376 == _e1393);
                                                                                let _e1400 = vec3(_e1395);
                                                                                phi_2685_ = select(_e1187, _e1213, _e1395);
                                                                                phi_2686_ = select(_e1184, _e1210, _e1395);
                                                                                phi_2687_ = select(_e1213, _e1200, _e1395);
                                                                                phi_2688_ = select(_e1210, _e1197, _e1395);
                                                                                phi_2689_ = select(_e1338, _e1337, _e1400);
                                                                                phi_2690_ = select(_e1346, _e1342, _e1400);
                                                                                phi_2691_ = select(_e1342, _e1350, _e1400);
                                                                                phi_2692_ = select(_e1350, _e1346, _e1400);
                                                                            }
                                                                            let _e1406 = phi_2685_;
                                                                            let _e1408 = phi_2686_;
                                                                            let _e1410 = phi_2687_;
                                                                            let _e1412 = phi_2688_;
                                                                            let _e1414 = phi_2689_;
                                                                            let _e1416 = phi_2690_;
                                                                            let _e1418 = phi_2691_;
                                                                            let _e1420 = phi_2692_;
                                                                            let _e1427 = ((_e1418.y * _e1416.z) - (_e1416.y * _e1418.z));
                                                                            let _e1432 = ((_e1418.z * _e1416.x) - (_e1416.z * _e1418.x));
                                                                            let _e1435 = ((_e1418.x * _e1416.y) - (_e1416.x * _e1418.y));
                                                                            if (_e1235 >= _e1239) {
                                                                                phi_2729_ = select(true, false, (_e1235 >= _e1243));
                                                                            } else {
                                                                                phi_2729_ = true;
                                                                            }
                                                                            let _e1440 = phi_2729_;
                                                                            if _e1440 {
                                                                                phi_2738_ = select(_e1338, _e1337, vec3((_e1239 >= _e1243)));
                                                                            } else {
                                                                                phi_2738_ = _e1336;
                                                                            }
                                                                            let _e1445 = phi_2738_;
                                                                            let _e1456 = (((_e1427 * (_e1445.x - _e328)) + (_e1432 * (_e1445.y - _e395))) + (_e1435 * (_e1445.z - _e461)));
                                                                            let _e1461 = (((_e1427 * _e368) + (_e1432 * _e434)) + (_e1435 * _e500));
                                                                            let _e1462 = (_e1408 - _e1412);
                                                                            let _e1463 = (_e1406 - _e1410);
                                                                            let _e1471 = (-(((_e1412 * _e1462) + (_e1410 * _e1463))) / ((_e1462 * _e1462) + (_e1463 * _e1463)));
                                                                            let _e1473 = select(1f, _e1471, (_e1471 < 1f));
                                                                            let _e1475 = select(0f, _e1473, (_e1473 > 0f));
                                                                            let _e1488 = ((_e1414.x + (_e1420.x * _e1475)) - _e328);
                                                                            let _e1489 = ((_e1414.y + (_e1420.y * _e1475)) - _e395);
                                                                            let _e1490 = ((_e1414.z + (_e1420.z * _e1475)) - _e461);
                                                                            let _e1491 = (_e1490 / _e500);
                                                                            let _e1503 = bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u));
                                                                            let _e1506 = bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u));
                                                                            let _e1508 = select(_e1506, _e1503, (_e1503 > _e1506));
                                                                            let _e1511 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                            let _e1513 = select(_e1511, _e1508, (_e1508 > _e1511));
                                                                            let _e1519 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                            let _e1522 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                            let _e1524 = select(_e1522, _e1519, (_e1519 > _e1522));
                                                                            let _e1527 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1427 * _e1488) + (_e1432 * _e1489)) + (_e1435 * _e1490)) - _e1456)) & 2147483647u)) <= ((0.0000009536743f * select(_e1393, _e1513, (_e1513 > _e1393))) * select(_e1527, _e1524, (_e1524 > _e1527)))) {
                                                                                let _e1537 = bitcast<f32>((bitcast<u32>(_e1418.x) & 2147483647u));
                                                                                let _e1540 = bitcast<f32>((bitcast<u32>(_e1418.y) & 2147483647u));
                                                                                let _e1542 = select(_e1540, _e1537, (_e1537 > _e1540));
                                                                                let _e1545 = bitcast<f32>((bitcast<u32>(_e1418.z) & 2147483647u));
                                                                                let _e1551 = bitcast<f32>((bitcast<u32>(_e1416.x) & 2147483647u));
                                                                                let _e1554 = bitcast<f32>((bitcast<u32>(_e1416.y) & 2147483647u));
                                                                                let _e1556 = select(_e1554, _e1551, (_e1551 > _e1554));
                                                                                let _e1559 = bitcast<f32>((bitcast<u32>(_e1416.z) & 2147483647u));
                                                                                let _e1563 = (bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u)) > ((0.0000038146973f * select(_e1545, _e1542, (_e1542 > _e1545))) * select(_e1559, _e1556, (_e1556 > _e1559))));
                                                                                if _e1563 {
                                                                                    phi_2903_ = (_e1456 / _e1461);
                                                                                } else {
                                                                                    phi_2903_ = f32();
                                                                                }
                                                                                let _e1566 = phi_2903_;
                                                                                phi_2905_ = _e1566;
                                                                                phi_2906_ = select(true, false, _e1563);
                                                                            } else {
                                                                                phi_2905_ = f32();
                                                                                phi_2906_ = true;
                                                                            }
                                                                            let _e1569 = phi_2905_;
                                                                            let _e1571 = phi_2906_;
                                                                            if _e1571 {
                                                                                let _e1579 = (((_e1427 * (_e1488 - (_e368 * _e1491))) + (_e1432 * (_e1489 - (_e434 * _e1491)))) / _e1461);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u)) <= _e1393) {
                                                                                    phi_2926_ = (_e1491 + _e1579);
                                                                                } else {
                                                                                    phi_2926_ = _e1491;
                                                                                }
                                                                                let _e1586 = phi_2926_;
                                                                                phi_2927_ = _e1586;
                                                                            } else {
                                                                                phi_2927_ = _e1569;
                                                                            }
                                                                            let _e1588 = phi_2927_;
                                                                            let _e1590 = select(_e1326, _e1588, (_e1588 < _e1326));
                                                                            let _e1592 = select(_e1318, _e1590, (_e1590 > _e1318));
                                                                            if (_e1592 >= _e614) {
                                                                                let _e1594 = (_e1592 <= _e719.member.member_1);
                                                                                if _e1594 {
                                                                                    let _e1595 = (1f / _e1245);
                                                                                    phi_2950_ = type_22(_e1592, (_e1239 * _e1595), (_e1243 * _e1595), _e785);
                                                                                } else {
                                                                                    phi_2950_ = type_22();
                                                                                }
                                                                                let _e1600 = phi_2950_;
                                                                                phi_2952_ = _e1600;
                                                                                phi_2953_ = select(true, false, _e1594);
                                                                            } else {
                                                                                phi_2952_ = type_22();
                                                                                phi_2953_ = true;
                                                                            }
                                                                            let _e1603 = phi_2952_;
                                                                            let _e1605 = phi_2953_;
                                                                            if _e1605 {
                                                                                phi_2957_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2957_ = _e1603;
                                                                            }
                                                                            let _e1607 = phi_2957_;
                                                                            phi_2958_ = _e1607;
                                                                        }
                                                                        let _e1609 = phi_2958_;
                                                                        phi_2959_ = _e1609;
                                                                        phi_2960_ = _e1335;
                                                                    }
                                                                    let _e1611 = phi_2959_;
                                                                    let _e1613 = phi_2960_;
                                                                    phi_2964_ = _e1611;
                                                                    phi_2965_ = _e1613;
                                                                }
                                                                let _e1615 = phi_2964_;
                                                                let _e1617 = phi_2965_;
                                                                phi_2966_ = _e1615;
                                                                phi_2967_ = _e1270;
                                                                phi_2968_ = _e1617;
                                                            }
                                                            let _e1619 = phi_2966_;
                                                            let _e1621 = phi_2967_;
                                                            let _e1623 = phi_2968_;
                                                            phi_2969_ = _e1619;
                                                            phi_2970_ = _e1621;
                                                            phi_2971_ = _e1623;
                                                        }
                                                        let _e1625 = phi_2969_;
                                                        let _e1627 = phi_2970_;
                                                        let _e1629 = phi_2971_;
                                                        phi_2979_ = _e1625;
                                                        phi_2980_ = select(_e1629, true, _e1627);
                                                    } else {
                                                        phi_2979_ = type_22();
                                                        phi_2980_ = true;
                                                    }
                                                    let _e1632 = phi_2979_;
                                                    let _e1634 = phi_2980_;
                                                    if _e1634 {
                                                        phi_2984_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2984_ = _e1632;
                                                    }
                                                    let _e1636 = phi_2984_;
                                                    if (_e1636.member_3 != 4294967295u) {
                                                        if (_e785 != _e620) {
                                                            if (_e1636.member < _e719.member.member.member) {
                                                                phi_3010_ = true;
                                                            } else {
                                                                if (_e1636.member == _e719.member.member.member) {
                                                                    phi_3009_ = (_e1636.member_3 < _e719.member.member.member_3);
                                                                } else {
                                                                    phi_3009_ = false;
                                                                }
                                                                let _e1651 = phi_3009_;
                                                                phi_3010_ = _e1651;
                                                            }
                                                            let _e1653 = phi_3010_;
                                                            if _e1653 {
                                                                phi_3017_ = type_42(type_39(_e1636, _e1636.member), _e746.member_1, _e746.member_2);
                                                            } else {
                                                                phi_3017_ = _e746;
                                                            }
                                                            let _e1660 = phi_3017_;
                                                            phi_3018_ = _e1660;
                                                        } else {
                                                            phi_3018_ = _e746;
                                                        }
                                                        let _e1662 = phi_3018_;
                                                        phi_3019_ = _e1662;
                                                    } else {
                                                        phi_3019_ = _e746;
                                                    }
                                                    let _e1664 = phi_3019_;
                                                    phi_1319_ = _e1664;
                                                } else {
                                                    phi_1319_ = type_42();
                                                }
                                                let _e1666 = phi_1319_;
                                                continue;
                                                continuing {
                                                    phi_1318_ = _e1666;
                                                    phi_1321_ = _e734;
                                                    phi_4783_ = _e661;
                                                    break if !(_e740);
                                                }
                                            }
                                            let _e1669 = phi_4783_;
                                            phi_4990_ = _e1669;
                                            if _e1669 {
                                                break;
                                            }
                                            phi_5081_ = _e1669;
                                            let _e2491 = local_12;
                                            phi_3020_ = _e2491;
                                        } else {
                                            phi_5081_ = _e661;
                                            phi_3020_ = _e663;
                                        }
                                        let _e1671 = phi_5081_;
                                        let _e1673 = phi_3020_;
                                        if _e711 {
                                            phi_4289_ = type_42();
                                            phi_4290_ = bool();
                                            phi_4291_ = u32();
                                            phi_4292_ = type_49();
                                        } else {
                                            if (_e707.member_1 >= _e100) {
                                                phi_3821_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e707.member_1 < _e100) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1677 = ((1u + _e281) % 4u);
                                                if (_e1677 < 4u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1682 = global_3.member[_e707.member_1][_e1677];
                                                let _e1684 = (_e1682 >> bitcast<u32>(11u));
                                                let _e1686 = ((1u + _e280) % 4u);
                                                if (_e1686 < 4u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1691 = global_3.member[_e707.member_1][_e1686];
                                                let _e1693 = (_e1691 >> bitcast<u32>(11u));
                                                let _e1695 = ((1u + _e282) % 4u);
                                                if (_e1695 < 4u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1700 = global_3.member[_e707.member_1][_e1695];
                                                let _e1702 = (_e1700 >> bitcast<u32>(11u));
                                                let _e1725 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.x - _e707.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e1726 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.y - _e707.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e1727 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.z - _e707.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e1729 = select(_e155, _e1725, (_e1725 > _e155));
                                                let _e1731 = select(_e155, _e1726, (_e1726 > _e155));
                                                let _e1733 = select(_e155, _e1727, (_e1727 > _e155));
                                                let _e1764 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1682 & 1023u))) - 8388608f) * _e1729));
                                                let _e1769 = (bitcast<i32>((_e1682 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1772 = bitcast<f32>((_e1764 & bitcast<u32>(_e1769)));
                                                let _e1773 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1691 & 1023u))) - 8388608f) * _e1731));
                                                let _e1778 = (bitcast<i32>((_e1691 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1781 = bitcast<f32>((_e1773 & bitcast<u32>(_e1778)));
                                                let _e1782 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1700 & 1023u))) - 8388608f) * _e1733));
                                                let _e1787 = (bitcast<i32>((_e1700 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1790 = bitcast<f32>((_e1782 & bitcast<u32>(_e1787)));
                                                let _e1794 = bitcast<f32>((_e1764 & bitcast<u32>(~(_e1769))));
                                                let _e1798 = bitcast<f32>((_e1773 & bitcast<u32>(~(_e1778))));
                                                let _e1802 = bitcast<f32>((_e1782 & bitcast<u32>(~(_e1787))));
                                                let _e1803 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1684 & 1023u))) - 8388608f) * _e1729));
                                                let _e1808 = (bitcast<i32>((_e1684 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1811 = bitcast<f32>((_e1803 & bitcast<u32>(_e1808)));
                                                let _e1812 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1693 & 1023u))) - 8388608f) * _e1731));
                                                let _e1817 = (bitcast<i32>((_e1693 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1820 = bitcast<f32>((_e1812 & bitcast<u32>(_e1817)));
                                                let _e1821 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1702 & 1023u))) - 8388608f) * _e1733));
                                                let _e1826 = (bitcast<i32>((_e1702 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1829 = bitcast<f32>((_e1821 & bitcast<u32>(_e1826)));
                                                let _e1833 = bitcast<f32>((_e1803 & bitcast<u32>(~(_e1808))));
                                                let _e1837 = bitcast<f32>((_e1812 & bitcast<u32>(~(_e1817))));
                                                let _e1841 = bitcast<f32>((_e1821 & bitcast<u32>(~(_e1826))));
                                                let _e1842 = (_e707.member.member.x + _e1772);
                                                let _e1843 = (_e707.member.member.y + _e1781);
                                                let _e1844 = (_e707.member.member.z + _e1790);
                                                let _e1847 = (_e707.member.member_1.x - _e1811);
                                                let _e1848 = (_e707.member.member_1.y - _e1820);
                                                let _e1849 = (_e707.member.member_1.z - _e1829);
                                                let _e1868 = (_e1847 - _e1842);
                                                let _e1869 = (_e1848 - _e1843);
                                                let _e1870 = (_e1849 - _e1844);
                                                let _e1872 = select(_e1869, _e1868, (_e1868 > _e1869));
                                                let _e1874 = select(_e1870, _e1872, (_e1872 > _e1870));
                                                if (_e1874 < (1024f * _e155)) {
                                                    phi_3522_ = 0u;
                                                } else {
                                                    phi_3522_ = select(2u, 1u, (_e1874 < (2097152f * _e155)));
                                                }
                                                let _e1881 = phi_3522_;
                                                switch bitcast<i32>(_e1881) {
                                                    case 0: {
                                                        phi_3528_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3528_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3528_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3528_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1884 = phi_3528_;
                                                let _e1890 = global_3.member[_e707.member_1][0u];
                                                let _e1894 = global_3.member[_e707.member_1][1u];
                                                let _e1898 = global_3.member[_e707.member_1][2u];
                                                let _e1902 = global_3.member[_e707.member_1][3u];
                                                let _e1914 = (((_e1894 >> bitcast<u32>(22i)) | ((_e1898 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1902 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1915 = (_e1890 & 268435455u);
                                                let _e1916 = (_e1914 & 268435455u);
                                                let _e1919 = ((_e1890 >> bitcast<u32>(28u)) & 7u);
                                                let _e1927 = ((_e1890 >> bitcast<u32>(31i)) | (((_e1914 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1928 = (_e1919 != 0u);
                                                if (_e1919 == 0u) {
                                                    phi_3783_ = _e1915;
                                                } else {
                                                    if (_e1919 == 7u) {
                                                        phi_3782_ = 2147483648u;
                                                    } else {
                                                        phi_3782_ = ((2147483648u | (_e1919 << bitcast<u32>(28u))) | (_e1916 & 268435455u));
                                                    }
                                                    let _e1937 = phi_3782_;
                                                    phi_3783_ = _e1937;
                                                }
                                                let _e1939 = phi_3783_;
                                                if _e1928 {
                                                    let _e1940 = (_e1919 != 7u);
                                                    if _e1940 {
                                                        phi_3793_ = (_e1916 + (_e1919 * ((3u * _e1884) + 1u)));
                                                    } else {
                                                        phi_3793_ = u32();
                                                    }
                                                    let _e1944 = phi_3793_;
                                                    phi_3795_ = _e1944;
                                                    phi_3796_ = select(true, false, _e1940);
                                                } else {
                                                    phi_3795_ = u32();
                                                    phi_3796_ = true;
                                                }
                                                let _e1947 = phi_3795_;
                                                let _e1949 = phi_3796_;
                                                if (_e1927 == 0u) {
                                                    phi_3817_ = (_e1915 + select(0u, 1u, !(_e1928)));
                                                } else {
                                                    if (_e1927 == 7u) {
                                                        phi_3816_ = 2147483648u;
                                                    } else {
                                                        phi_3816_ = ((2147483648u | (_e1927 << bitcast<u32>(28u))) | (select(_e1947, _e1916, _e1949) & 268435455u));
                                                    }
                                                    let _e1962 = phi_3816_;
                                                    phi_3817_ = _e1962;
                                                }
                                                let _e1964 = phi_3817_;
                                                phi_3821_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e1842, (_e707.member.member.x + _e1794), _e1847, (_e707.member.member_1.x - _e1833)), vec4<f32>(_e1843, (_e707.member.member.y + _e1798), _e1848, (_e707.member.member_1.y - _e1837)), vec4<f32>(_e1844, (_e707.member.member.z + _e1802), _e1849, (_e707.member.member_1.z - _e1841))), type_49(type_34((_e707.member.member + vec4<f32>(_e1772, _e1781, _e1790, 0f)), (_e707.member.member_1 - vec4<f32>(_e1811, _e1820, _e1829, 0f))), _e1939), type_49(type_34((_e707.member.member + vec4<f32>(_e1794, _e1798, _e1802, 0f)), (_e707.member.member_1 - vec4<f32>(_e1833, _e1837, _e1841, 0f))), _e1964));
                                            }
                                            let _e1969 = phi_3821_;
                                            let _e1988 = ((_e1969.member[0].x - _e366) * _e371);
                                            let _e1989 = ((_e1969.member[0].y - _e366) * _e371);
                                            let _e1990 = ((_e1969.member[0].z - _e367) * _e371);
                                            let _e1991 = ((_e1969.member[0].w - _e367) * _e371);
                                            let _e2001 = ((_e1969.member[1].x - _e432) * _e437);
                                            let _e2002 = ((_e1969.member[1].y - _e432) * _e437);
                                            let _e2003 = ((_e1969.member[1].z - _e433) * _e437);
                                            let _e2004 = ((_e1969.member[1].w - _e433) * _e437);
                                            let _e2014 = ((_e1969.member[2].x - _e498) * _e503);
                                            let _e2015 = ((_e1969.member[2].y - _e498) * _e503);
                                            let _e2016 = ((_e1969.member[2].z - _e499) * _e503);
                                            let _e2017 = ((_e1969.member[2].w - _e499) * _e503);
                                            let _e2019 = select(_e2016, _e2014, (_e2014 < _e2016));
                                            let _e2021 = select(_e2017, _e2015, (_e2015 < _e2017));
                                            let _e2023 = select(_e2016, _e2014, (_e2014 > _e2016));
                                            let _e2025 = select(_e2017, _e2015, (_e2015 > _e2017));
                                            let _e2027 = select(_e1990, _e1988, (_e1988 < _e1990));
                                            let _e2029 = select(_e1991, _e1989, (_e1989 < _e1991));
                                            let _e2031 = select(_e2003, _e2001, (_e2001 < _e2003));
                                            let _e2033 = select(_e2004, _e2002, (_e2002 < _e2004));
                                            let _e2035 = select(_e2031, _e2027, (_e2027 > _e2031));
                                            let _e2037 = select(_e2033, _e2029, (_e2029 > _e2033));
                                            let _e2039 = select(_e2019, _e2035, (_e2035 > _e2019));
                                            let _e2041 = select(_e2021, _e2037, (_e2037 > _e2021));
                                            let _e2043 = select(_e1990, _e1988, (_e1988 > _e1990));
                                            let _e2045 = select(_e1991, _e1989, (_e1989 > _e1991));
                                            let _e2047 = select(_e2003, _e2001, (_e2001 > _e2003));
                                            let _e2049 = select(_e2004, _e2002, (_e2002 > _e2004));
                                            let _e2051 = select(_e2047, _e2043, (_e2043 < _e2047));
                                            let _e2053 = select(_e2049, _e2045, (_e2045 < _e2049));
                                            let _e2058 = -(_e2019);
                                            let _e2059 = -(_e2021);
                                            let _e2066 = (select(_e2023, _e2051, (_e2051 < _e2023)) + (select(_e2058, _e2023, (_e2023 > _e2058)) * 0.0000019073523f));
                                            let _e2067 = (select(_e2025, _e2053, (_e2053 < _e2025)) + (select(_e2059, _e2025, (_e2025 > _e2059)) * 0.0000019073523f));
                                            let _e2069 = select(_e614, _e2039, (_e2039 > _e614));
                                            let _e2071 = select(_e614, _e2041, (_e2041 > _e614));
                                            let _e2076 = (_e2069 <= select(_e1673.member.member_1, _e2066, (_e2066 < _e1673.member.member_1)));
                                            let _e2077 = (_e2071 <= select(_e1673.member.member_1, _e2067, (_e2067 < _e1673.member.member_1)));
                                            let _e2078 = (_e2069 <= _e2071);
                                            if _e2076 {
                                                if _e2077 {
                                                    if _e2078 {
                                                        phi_4186_ = _e1969.member_2;
                                                    } else {
                                                        phi_4186_ = _e1969.member_1;
                                                    }
                                                    let _e2082 = phi_4186_;
                                                    let _e2103 = (_e705 % 128u);
                                                    let _e2104 = (_e2103 < 128u);
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2103] = _e2082.member_1;
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2103] = _e2082.member.member.x;
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2103] = _e2082.member.member.y;
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2103] = _e2082.member.member.z;
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2103] = _e2082.member.member_1.x;
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2103] = _e2082.member.member_1.y;
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2103] = _e2082.member.member_1.z;
                                                    if _e2104 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2103] = select(_e2069, _e2071, _e2078);
                                                    if _e2078 {
                                                        phi_4262_ = _e1969.member_1;
                                                    } else {
                                                        phi_4262_ = _e1969.member_2;
                                                    }
                                                    let _e2117 = phi_4262_;
                                                    phi_4263_ = (_e705 + 1u);
                                                    phi_4264_ = _e2117;
                                                } else {
                                                    phi_4263_ = u32();
                                                    phi_4264_ = type_49();
                                                }
                                                let _e2119 = phi_4263_;
                                                let _e2121 = phi_4264_;
                                                phi_4266_ = _e2119;
                                                phi_4267_ = _e2121;
                                                phi_4268_ = select(true, false, _e2077);
                                            } else {
                                                phi_4266_ = u32();
                                                phi_4267_ = type_49();
                                                phi_4268_ = true;
                                            }
                                            let _e2124 = phi_4266_;
                                            let _e2126 = phi_4267_;
                                            let _e2128 = phi_4268_;
                                            if _e2128 {
                                                if _e2076 {
                                                    phi_4277_ = _e1969.member_1;
                                                } else {
                                                    phi_4277_ = _e1969.member_2;
                                                }
                                                let _e2132 = phi_4277_;
                                                phi_4282_ = select(_e2077, true, _e2076);
                                                phi_4284_ = _e2132;
                                            } else {
                                                phi_4282_ = _e703;
                                                phi_4284_ = _e2126;
                                            }
                                            let _e2135 = phi_4282_;
                                            let _e2137 = phi_4284_;
                                            phi_4289_ = type_42(_e1673.member, (_e1673.member_1 + 1u), _e1673.member_2);
                                            phi_4290_ = _e2135;
                                            phi_4291_ = select(_e2124, _e705, _e2128);
                                            phi_4292_ = _e2137;
                                        }
                                        let _e2140 = phi_4289_;
                                        let _e2142 = phi_4290_;
                                        let _e2144 = phi_4291_;
                                        let _e2146 = phi_4292_;
                                        if _e711 {
                                            phi_4300_ = _e1673;
                                            phi_4303_ = _e707;
                                        } else {
                                            phi_4300_ = _e2140;
                                            phi_4303_ = _e2146;
                                        }
                                        let _e2148 = phi_4300_;
                                        let _e2150 = phi_4303_;
                                        phi_4993_ = _e1671;
                                        phi_4304_ = _e2148;
                                        phi_4305_ = (_e665 - 1u);
                                        phi_4306_ = select(_e2142, false, _e711);
                                        phi_4307_ = select(_e2144, _e705, _e711);
                                        phi_4308_ = _e2150;
                                    } else {
                                        phi_4993_ = _e661;
                                        phi_4304_ = _e663;
                                        phi_4305_ = _e665;
                                        phi_4306_ = _e703;
                                        phi_4307_ = _e705;
                                        phi_4308_ = _e707;
                                    }
                                    let _e2154 = phi_4993_;
                                    let _e2156 = phi_4304_;
                                    let _e2158 = phi_4305_;
                                    let _e2160 = phi_4306_;
                                    let _e2162 = phi_4307_;
                                    let _e2164 = phi_4308_;
                                    phi_4992_ = _e2154;
                                    phi_4309_ = _e2156;
                                    phi_4310_ = _e2158;
                                    phi_4311_ = _e2160;
                                    phi_4312_ = _e2162;
                                    phi_4313_ = _e2164;
                                } else {
                                    phi_4992_ = _e661;
                                    phi_4309_ = type_42();
                                    phi_4310_ = u32();
                                    phi_4311_ = bool();
                                    phi_4312_ = u32();
                                    phi_4313_ = type_49();
                                }
                                let _e2166 = phi_4992_;
                                let _e2168 = phi_4309_;
                                let _e2170 = phi_4310_;
                                let _e2172 = phi_4311_;
                                let _e2174 = phi_4312_;
                                let _e2176 = phi_4313_;
                                phi_4991_ = _e2166;
                                phi_1192_ = _e2168;
                                phi_1195_ = _e2170;
                                phi_1197_ = _e2172;
                                phi_1199_ = _e2174;
                                phi_1201_ = _e2176;
                                phi_4314_ = _e675;
                            } else {
                                phi_4991_ = _e661;
                                phi_1192_ = type_42();
                                phi_1195_ = u32();
                                phi_1197_ = bool();
                                phi_1199_ = u32();
                                phi_1201_ = type_49();
                                phi_4314_ = false;
                            }
                            let _e2178 = phi_4991_;
                            let _e2180 = phi_1192_;
                            let _e2182 = phi_1195_;
                            let _e2184 = phi_1197_;
                            let _e2186 = phi_1199_;
                            let _e2188 = phi_1201_;
                            let _e2190 = phi_4314_;
                            continue;
                            continuing {
                                phi_4789_ = _e2178;
                                phi_1191_ = _e2180;
                                phi_1194_ = _e2182;
                                phi_1196_ = _e2184;
                                phi_1198_ = _e2186;
                                phi_1200_ = _e2188;
                                phi_4990_ = _e2178;
                                break if !(_e2190);
                            }
                        }
                        let _e2193 = phi_4990_;
                        if _e2193 {
                            break;
                        }
                        let _e2195 = local_10;
                        if (_e2195.member.member.member_3 != 4294967295u) {
                            let _e2201 = bitcast<u32>(_e2195.member.member.member);
                            let _e2205 = (bitcast<i32>((_e2201 >> bitcast<u32>(23i))) & 255i);
                            let _e2206 = (_e2205 + _e283);
                            if (_e2205 == 255i) {
                                phi_4373_ = _e2195.member.member.member;
                            } else {
                                if (_e2205 > 0i) {
                                    if (_e2206 > 0i) {
                                        let _e2210 = (_e2206 < 255i);
                                        if _e2210 {
                                            phi_4352_ = bitcast<f32>((_e2201 + bitcast<u32>((_e283 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4352_ = f32();
                                        }
                                        let _e2217 = phi_4352_;
                                        phi_4354_ = _e2217;
                                        phi_4355_ = select(true, false, _e2210);
                                    } else {
                                        phi_4354_ = f32();
                                        phi_4355_ = true;
                                    }
                                    let _e2220 = phi_4354_;
                                    let _e2222 = phi_4355_;
                                    phi_4356_ = _e2220;
                                    phi_4357_ = _e2222;
                                } else {
                                    phi_4356_ = f32();
                                    phi_4357_ = true;
                                }
                                let _e2224 = phi_4356_;
                                let _e2226 = phi_4357_;
                                if _e2226 {
                                    let _e2227 = (_e2201 & 2147483648u);
                                    let _e2234 = ((_e2201 & 8388607u) | (select(0u, 1u, ((_e2201 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2238 = (_e2234 == 0u);
                                    if _e2238 {
                                        phi_4741_ = bitcast<f32>(_e2227);
                                    } else {
                                        let _e2243 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2234)), 32u, _e2238) - 8u);
                                        let _e2246 = (_e2234 << bitcast<u32>((_e2243 & 31u)));
                                        let _e2248 = ((_e2206 + select(0i, 1i, (_e2205 == 0i))) - bitcast<i32>(_e2243));
                                        if (_e2248 >= 255i) {
                                            phi_4731_ = bitcast<f32>((_e2227 | 2139095040u));
                                            phi_4732_ = f32();
                                            phi_4733_ = true;
                                        } else {
                                            let _e2250 = (_e2248 > 0i);
                                            if _e2250 {
                                                phi_4725_ = bitcast<f32>(((_e2227 | (bitcast<u32>(_e2248) << bitcast<u32>(23i))) | (_e2246 & 8388607u)));
                                                phi_4726_ = f32();
                                            } else {
                                                if (_e2248 < -24i) {
                                                    phi_4691_ = 26u;
                                                } else {
                                                    phi_4691_ = bitcast<u32>((1i - _e2248));
                                                }
                                                let _e2255 = phi_4691_;
                                                let _e2256 = (_e2255 & 31u);
                                                let _e2258 = (_e2246 >> bitcast<u32>(_e2256));
                                                let _e2262 = (_e2246 & ((1u << bitcast<u32>(_e2256)) - 1u));
                                                let _e2266 = (1u << bitcast<u32>(((_e2255 - 1u) & 31u)));
                                                if (_e2262 > _e2266) {
                                                    phi_4712_ = true;
                                                } else {
                                                    if (_e2262 == _e2266) {
                                                        phi_4709_ = ((_e2258 & 1u) == 1u);
                                                    } else {
                                                        phi_4709_ = false;
                                                    }
                                                    let _e2272 = phi_4709_;
                                                    phi_4712_ = _e2272;
                                                }
                                                let _e2274 = phi_4712_;
                                                phi_4725_ = f32();
                                                phi_4726_ = bitcast<f32>((_e2227 | (_e2258 + select(0u, 1u, _e2274))));
                                            }
                                            let _e2287 = phi_4725_;
                                            let _e2289 = phi_4726_;
                                            phi_4731_ = _e2287;
                                            phi_4732_ = _e2289;
                                            phi_4733_ = _e2250;
                                        }
                                        let _e2293 = phi_4731_;
                                        let _e2295 = phi_4732_;
                                        let _e2297 = phi_4733_;
                                        phi_4741_ = select(_e2295, _e2293, _e2297);
                                    }
                                    let _e2301 = phi_4741_;
                                    phi_4372_ = _e2301;
                                } else {
                                    phi_4372_ = _e2224;
                                }
                                let _e2303 = phi_4372_;
                                phi_4373_ = _e2303;
                            }
                            let _e2305 = phi_4373_;
                            let _e2306 = bitcast<u32>(_e2305);
                            if ((_e2306 & 2147483647u) >= 2139095040u) {
                                phi_4385_ = bitcast<f32>(((_e2306 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4385_ = _e2305;
                            }
                            let _e2313 = phi_4385_;
                            phi_4390_ = type_22(_e2313, _e2195.member.member.member_1, _e2195.member.member.member_2, _e2195.member.member.member_3);
                        } else {
                            phi_4390_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2318 = phi_4390_;
                        if _e159 {
                        } else {
                            break;
                        }
                        global_1.member[_e143] = _e2318;
                        let _e2322 = local_11;
                        if _e160 {
                        } else {
                            break;
                        }
                        global_5.member[_e143] = _e2322.member_1;
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e2327 = select(0u, 1u, (_e227 <= _e237));
                        if (_e2327 > 0u) {
                            let _e2329 = (1u < _e111);
                            if _e2329 {
                                if (0u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2333 = atomicAdd((&global_6.member[0u]), _e2327);
                                if ((_e2333 + _e2327) < _e2333) {
                                    if _e2329 {
                                    } else {
                                        break;
                                    }
                                    let _e2338 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2341 = select(0u, 1u, (_e2318.member_3 != 4294967295u));
                        if (_e2341 > 0u) {
                            let _e2343 = (3u < _e111);
                            if _e2343 {
                                if (2u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2347 = atomicAdd((&global_6.member[2u]), _e2341);
                                if ((_e2347 + _e2341) < _e2347) {
                                    if _e2343 {
                                    } else {
                                        break;
                                    }
                                    let _e2352 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2322.member_1 > 0u) {
                            let _e2354 = (5u < _e111);
                            if _e2354 {
                                if (4u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2358 = atomicAdd((&global_6.member[4u]), _e2322.member_1);
                                if ((_e2358 + _e2322.member_1) < _e2358) {
                                    if _e2354 {
                                    } else {
                                        break;
                                    }
                                    let _e2363 = atomicAdd((&global_6.member[5u]), 1u);
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
