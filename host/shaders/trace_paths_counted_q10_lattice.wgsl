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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_34,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

struct type_56 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_24;
@group(0) @binding(0) 
var<uniform> global_2: type_45;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_56;
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
    var phi_520_: i32;
    var phi_521_: i32;
    var phi_531_: bool;
    var phi_541_: u32;
    var phi_542_: u32;
    var phi_544_: bool;
    var phi_549_: u32;
    var phi_582_: i32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_725_: f32;
    var phi_731_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_850_: f32;
    var phi_856_: f32;
    var phi_896_: f32;
    var phi_902_: f32;
    var phi_1021_: i32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1081_: i32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_4812_: bool;
    var phi_1218_: type_43;
    var phi_1221_: bool;
    var phi_1223_: type_50;
    var phi_1225_: u32;
    var phi_1227_: u32;
    var phi_1238_: bool;
    var phi_1324_: bool;
    var phi_1325_: type_50;
    var phi_1326_: u32;
    var phi_3416_: u32;
    var phi_3422_: u32;
    var phi_3676_: u32;
    var phi_3677_: u32;
    var phi_3687_: u32;
    var phi_3689_: u32;
    var phi_3690_: bool;
    var phi_3710_: u32;
    var phi_3711_: u32;
    var phi_3715_: type_51;
    var phi_4080_: type_50;
    var phi_4156_: type_50;
    var phi_4157_: type_50;
    var phi_4158_: u32;
    var phi_4160_: type_50;
    var phi_4161_: u32;
    var phi_4162_: bool;
    var phi_4171_: type_50;
    var phi_4176_: bool;
    var phi_4177_: type_50;
    var phi_1345_: type_43;
    var phi_1348_: type_8;
    var phi_1349_: type_8;
    var phi_1371_: type_8;
    var phi_1415_: u32;
    var phi_1421_: u32;
    var phi_1431_: u32;
    var phi_1447_: u32;
    var phi_1480_: u32;
    var phi_1486_: u32;
    var phi_1952_: u32;
    var phi_1970_: u32;
    var phi_1988_: u32;
    var phi_2011_: u32;
    var phi_2029_: u32;
    var phi_2047_: u32;
    var phi_2070_: u32;
    var phi_2088_: u32;
    var phi_2106_: u32;
    var phi_1660_: u32;
    var phi_1675_: u32;
    var phi_1685_: u32;
    var phi_1706_: u32;
    var phi_1727_: u32;
    var phi_1757_: u32;
    var phi_1772_: u32;
    var phi_1782_: u32;
    var phi_1803_: u32;
    var phi_1824_: u32;
    var phi_1854_: u32;
    var phi_1869_: u32;
    var phi_1879_: u32;
    var phi_1900_: u32;
    var phi_1921_: u32;
    var phi_1513_: u32;
    var phi_1562_: u32;
    var phi_1611_: u32;
    var phi_2112_: array<array<f32, 3>, 3>;
    var phi_2642_: f32;
    var phi_2643_: f32;
    var phi_2644_: f32;
    var phi_2645_: f32;
    var phi_2646_: vec3<f32>;
    var phi_2647_: vec3<f32>;
    var phi_2648_: vec3<f32>;
    var phi_2649_: vec3<f32>;
    var phi_2840_: f32;
    var phi_2860_: type_42;
    var phi_2861_: type_42;
    var phi_2864_: type_42;
    var phi_2865_: type_42;
    var phi_2866_: bool;
    var phi_2870_: type_42;
    var phi_2879_: type_22;
    var phi_2904_: bool;
    var phi_2905_: bool;
    var phi_2912_: type_43;
    var phi_2913_: type_43;
    var phi_2914_: type_43;
    var phi_1346_: type_43;
    var phi_4806_: bool;
    var local_10: type_43;
    var phi_5010_: bool;
    var phi_4179_: type_43;
    var phi_4180_: bool;
    var phi_4181_: type_50;
    var phi_4182_: u32;
    var phi_5009_: bool;
    var phi_4183_: type_43;
    var phi_4184_: bool;
    var phi_4185_: type_50;
    var phi_4186_: u32;
    var phi_4187_: u32;
    var phi_5008_: bool;
    var phi_4188_: type_43;
    var phi_4189_: bool;
    var phi_4190_: type_50;
    var phi_4191_: u32;
    var phi_4192_: u32;
    var phi_5007_: bool;
    var phi_1219_: type_43;
    var phi_1222_: bool;
    var phi_1224_: type_50;
    var phi_1226_: u32;
    var phi_1228_: u32;
    var phi_4193_: bool;
    var phi_5006_: bool;
    var local_11: type_43;
    var phi_4231_: f32;
    var phi_4233_: f32;
    var phi_4234_: bool;
    var phi_4235_: f32;
    var phi_4236_: bool;
    var phi_4714_: u32;
    var phi_4732_: bool;
    var phi_4735_: bool;
    var phi_4748_: f32;
    var phi_4749_: f32;
    var phi_4754_: f32;
    var phi_4755_: f32;
    var phi_4756_: bool;
    var phi_4764_: f32;
    var phi_4251_: f32;
    var phi_4252_: f32;
    var phi_4264_: f32;
    var phi_4269_: type_22;
    var local_12: type_43;
    var local_13: type_43;

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
                                phi_520_ = (bitcast<i32>((_e246 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_520_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e246)), 32u, (_e246 == 0u))));
                            }
                            let _e260 = phi_520_;
                            phi_521_ = _e260;
                        } else {
                            phi_521_ = 0i;
                        }
                        let _e262 = phi_521_;
                        let _e263 = (_e172 == _e216);
                        if _e263 {
                            phi_531_ = true;
                        } else {
                            phi_531_ = (_e180 == _e216);
                        }
                        let _e266 = phi_531_;
                        let _e267 = select(1u, 0u, _e263);
                        if _e266 {
                            let _e268 = (_e267 + 1u);
                            phi_541_ = _e268;
                            phi_542_ = _e268;
                            phi_544_ = select(true, false, (_e268 == 2u));
                        } else {
                            phi_541_ = u32();
                            phi_542_ = 0u;
                            phi_544_ = true;
                        }
                        let _e272 = phi_541_;
                        let _e274 = phi_542_;
                        let _e276 = phi_544_;
                        if _e276 {
                            phi_549_ = (_e274 + 1u);
                        } else {
                            phi_549_ = 0u;
                        }
                        let _e280 = phi_549_;
                        let _e281 = select(_e272, _e274, _e276);
                        let _e282 = select(_e267, select(2u, _e267, _e266), _e276);
                        let _e283 = -(_e262);
                        if (_e283 < -126i) {
                            phi_582_ = -126i;
                        } else {
                            phi_582_ = select(_e283, 127i, (_e283 > 127i));
                        }
                        let _e288 = phi_582_;
                        let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                        let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                        let _e304 = global_4.member[_e143].member.member;
                        let _e305 = (_e281 == 0u);
                        if _e305 {
                            phi_600_ = _e304[0];
                        } else {
                            phi_600_ = _e304[1];
                        }
                        let _e309 = phi_600_;
                        let _e310 = (_e281 == 2u);
                        if _e310 {
                            phi_606_ = _e304[2];
                        } else {
                            phi_606_ = _e309;
                        }
                        let _e313 = phi_606_;
                        let _e314 = bitcast<u32>(_e313);
                        let _e316 = ((_e314 & 2139095040u) != 0u);
                        let _e328 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * select(0.00000011920929f, 1f, _e316));
                        let _e329 = global_4.member[_e143].member.member_2;
                        if _e305 {
                            phi_646_ = _e329[0];
                        } else {
                            phi_646_ = _e329[1];
                        }
                        let _e333 = phi_646_;
                        if _e310 {
                            phi_652_ = _e329[2];
                        } else {
                            phi_652_ = _e333;
                        }
                        let _e336 = phi_652_;
                        let _e337 = bitcast<u32>(_e336);
                        let _e339 = ((_e337 & 2139095040u) != 0u);
                        let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e293) * select(0.00000011920929f, 1f, _e339)) * _e299);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e360 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                        let _e361 = (_e360 * 0.00000011920929f);
                        let _e364 = select(select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f)), 0f, _e357);
                        let _e365 = select(0f, _e353, _e357);
                        let _e366 = (_e328 + _e364);
                        let _e367 = (_e328 - _e364);
                        let _e369 = select(38685626000000000000000000f, (1f / _e353), _e357);
                        let _e370 = (_e280 == 0u);
                        if _e370 {
                            phi_725_ = _e304[0];
                        } else {
                            phi_725_ = _e304[1];
                        }
                        let _e374 = phi_725_;
                        let _e375 = (_e280 == 2u);
                        if _e375 {
                            phi_731_ = _e304[2];
                        } else {
                            phi_731_ = _e374;
                        }
                        let _e378 = phi_731_;
                        let _e379 = bitcast<u32>(_e378);
                        let _e381 = ((_e379 & 2139095040u) != 0u);
                        let _e393 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * select(0.00000011920929f, 1f, _e381));
                        if _e370 {
                            phi_771_ = _e329[0];
                        } else {
                            phi_771_ = _e329[1];
                        }
                        let _e397 = phi_771_;
                        if _e375 {
                            phi_777_ = _e329[2];
                        } else {
                            phi_777_ = _e397;
                        }
                        let _e400 = phi_777_;
                        let _e401 = bitcast<u32>(_e400);
                        let _e403 = ((_e401 & 2139095040u) != 0u);
                        let _e417 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e400, _e403) * _e293) * select(0.00000011920929f, 1f, _e403)) * _e299);
                        let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e424 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                        let _e425 = (_e424 * 0.00000011920929f);
                        let _e428 = select(select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f)), 0f, _e421);
                        let _e429 = select(0f, _e417, _e421);
                        let _e430 = (_e393 + _e428);
                        let _e431 = (_e393 - _e428);
                        let _e433 = select(38685626000000000000000000f, (1f / _e417), _e421);
                        let _e434 = (_e282 == 0u);
                        if _e434 {
                            phi_850_ = _e304[0];
                        } else {
                            phi_850_ = _e304[1];
                        }
                        let _e438 = phi_850_;
                        let _e439 = (_e282 == 2u);
                        if _e439 {
                            phi_856_ = _e304[2];
                        } else {
                            phi_856_ = _e438;
                        }
                        let _e442 = phi_856_;
                        let _e443 = bitcast<u32>(_e442);
                        let _e445 = ((_e443 & 2139095040u) != 0u);
                        let _e457 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * select(0.00000011920929f, 1f, _e445));
                        if _e434 {
                            phi_896_ = _e329[0];
                        } else {
                            phi_896_ = _e329[1];
                        }
                        let _e461 = phi_896_;
                        if _e439 {
                            phi_902_ = _e329[2];
                        } else {
                            phi_902_ = _e461;
                        }
                        let _e464 = phi_902_;
                        let _e465 = bitcast<u32>(_e464);
                        let _e467 = ((_e465 & 2139095040u) != 0u);
                        let _e481 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e465 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e465 & 2147483648u))), _e464, _e467) * _e293) * select(0.00000011920929f, 1f, _e467)) * _e299);
                        let _e485 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e488 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                        let _e489 = (_e488 * 0.00000011920929f);
                        let _e492 = select(select(0.00000000000011368684f, _e489, (_e489 > 0.00000000000011368684f)), 0f, _e485);
                        let _e493 = select(0f, _e481, _e485);
                        let _e494 = (_e457 + _e492);
                        let _e495 = (_e457 - _e492);
                        let _e497 = select(38685626000000000000000000f, (1f / _e481), _e485);
                        let _e499 = select(_e424, _e360, (_e360 > _e424));
                        if (_e243 && (select(_e488, _e499, (_e499 > _e488)) <= 1099511600000f)) {
                            let _e511 = ((_e229 & 8388607u) | (select(0u, 1u, ((_e229 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e514 = bitcast<i32>((_e229 >> bitcast<u32>(23i)));
                            let _e518 = (_e511 == 0u);
                            let _e521 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, _e518)) - 8i);
                            if (_e514 == 255i) {
                                phi_1021_ = 255i;
                            } else {
                                phi_1021_ = (((_e514 + select(0i, 1i, (_e514 == 0i))) - _e521) + _e262);
                            }
                            let _e529 = phi_1021_;
                            let _e539 = (_e529 <= 0i);
                            if _e539 {
                                phi_1044_ = u32();
                            } else {
                                if _e518 {
                                    phi_1043_ = u32();
                                } else {
                                    phi_1043_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | ((_e511 << bitcast<u32>(((_e521 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e529 >= 255i));
                                }
                                let _e543 = phi_1043_;
                                phi_1044_ = _e543;
                            }
                            let _e545 = phi_1044_;
                            let _e557 = ((_e239 & 8388607u) | (select(0u, 1u, ((_e239 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e560 = bitcast<i32>((_e239 >> bitcast<u32>(23i)));
                            let _e564 = (_e557 == 0u);
                            let _e567 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e557)), 32u, _e564)) - 8i);
                            if (_e560 == 255i) {
                                phi_1081_ = 255i;
                            } else {
                                phi_1081_ = (((_e560 + select(0i, 1i, (_e560 == 0i))) - _e567) + _e262);
                            }
                            let _e575 = phi_1081_;
                            let _e585 = (_e575 <= 0i);
                            if _e585 {
                                phi_1104_ = u32();
                            } else {
                                if _e564 {
                                    phi_1103_ = u32();
                                } else {
                                    phi_1103_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | ((_e557 << bitcast<u32>(((_e567 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e575 >= 255i));
                                }
                                let _e589 = phi_1103_;
                                phi_1104_ = _e589;
                            }
                            let _e591 = phi_1104_;
                            phi_1112_ = bitcast<f32>(((_e238 & 2147483648u) | select(_e591, 0u, select(_e564, true, _e585))));
                            phi_1113_ = bitcast<f32>(((_e228 & 2147483648u) | select(_e545, 0u, select(_e518, true, _e539))));
                        } else {
                            phi_1112_ = 0f;
                            phi_1113_ = 1f;
                        }
                        let _e597 = phi_1112_;
                        let _e599 = phi_1113_;
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e605 = global_4.member[_e143].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e610 = (_e281 % 3u);
                        let _e611 = (_e610 < 3u);
                        if _e611 {
                        } else {
                            break;
                        }
                        let _e613 = local_1[_e610];
                        let _e616 = (_e280 % 3u);
                        let _e617 = (_e616 < 3u);
                        if _e617 {
                        } else {
                            break;
                        }
                        let _e619 = local_1[_e616];
                        let _e622 = (_e282 % 3u);
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
                        phi_4812_ = false;
                        phi_1218_ = type_43(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e597), 0u, 0u);
                        phi_1221_ = (_e599 <= _e597);
                        phi_1223_ = type_50(type_34(vec4<f32>((f32(_e613) * _e155), (f32(_e619) * _e155), (f32(_e625) * _e155), 0f), vec4<f32>((f32(_e630) * _e155), (f32(_e634) * _e155), (f32(_e638) * _e155), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        phi_1225_ = 0u;
                        phi_1227_ = ((3u * _e100) + 1u);
                        loop {
                            let _e646 = phi_4812_;
                            let _e648 = phi_1218_;
                            let _e650 = phi_1221_;
                            let _e652 = phi_1223_;
                            let _e654 = phi_1225_;
                            let _e656 = phi_1227_;
                            local_11 = _e648;
                            local_12 = _e648;
                            if _e650 {
                                phi_1238_ = true;
                            } else {
                                phi_1238_ = (_e654 > 0u);
                            }
                            let _e659 = phi_1238_;
                            if _e659 {
                                let _e660 = (_e656 > 0u);
                                if _e660 {
                                    if _e650 {
                                        phi_1324_ = _e650;
                                        phi_1325_ = _e652;
                                        phi_1326_ = _e654;
                                    } else {
                                        let _e661 = (_e654 - 1u);
                                        let _e662 = (_e661 % 128u);
                                        let _e663 = (_e662 < 128u);
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e665 = local_7[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e667 = local_6[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e669 = local_5[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e671 = local_4[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e673 = local_3[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e675 = local_2[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e680 = local_8[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5006_ = true;
                                            break;
                                        }
                                        let _e683 = local_9[_e662];
                                        phi_1324_ = (_e683 <= _e648.member.member_1);
                                        phi_1325_ = type_50(type_34(vec4<f32>(_e665, _e667, _e669, 0f), vec4<f32>(_e671, _e673, _e675, 0f)), _e680);
                                        phi_1326_ = _e661;
                                    }
                                    let _e688 = phi_1324_;
                                    let _e690 = phi_1325_;
                                    let _e692 = phi_1326_;
                                    if _e688 {
                                        let _e697 = (_e690.member_1 & 268435455u);
                                        if ((_e690.member_1 & 2147483648u) != 0u) {
                                            phi_1345_ = _e648;
                                            phi_1348_ = type_8(0u, ((_e690.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1169 = phi_1345_;
                                                let _e1171 = phi_1348_;
                                                local_10 = _e1169;
                                                local_13 = _e1169;
                                                if (_e1171.member < _e1171.member_1) {
                                                    phi_1349_ = type_8((_e1171.member + 1u), _e1171.member_1);
                                                    phi_1371_ = type_8(1u, _e1171.member);
                                                } else {
                                                    phi_1349_ = _e1171;
                                                    phi_1371_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1184 = phi_1349_;
                                                let _e1186 = phi_1371_;
                                                let _e1190 = (bitcast<i32>(_e1186.member) != 0i);
                                                if _e1190 {
                                                    let _e1196 = type_43(_e1169.member, _e1169.member_1, (_e1169.member_2 + 1u));
                                                    let _e1201 = (_e690.member.member_1.x - _e690.member.member.x);
                                                    let _e1204 = (_e690.member.member_1.y - _e690.member.member.y);
                                                    let _e1207 = (_e690.member.member_1.z - _e690.member.member.z);
                                                    let _e1209 = select(_e1204, _e1201, (_e1201 > _e1204));
                                                    let _e1211 = select(_e1207, _e1209, (_e1209 > _e1207));
                                                    let _e1213 = (_e1211 < (1024f * _e155));
                                                    if _e1213 {
                                                        phi_1415_ = 0u;
                                                    } else {
                                                        phi_1415_ = select(2u, 1u, (_e1211 < (2097152f * _e155)));
                                                    }
                                                    let _e1218 = phi_1415_;
                                                    switch bitcast<i32>(_e1218) {
                                                        case 0: {
                                                            phi_1421_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1421_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1421_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1421_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1221 = phi_1421_;
                                                    switch bitcast<i32>(_e1218) {
                                                        case 0: {
                                                            phi_1431_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1431_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1431_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1431_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1228 = phi_1431_;
                                                    let _e1230 = ((_e697 + (_e1186.member_1 * ((3u * _e1221) + 1u))) + (3u * _e1228));
                                                    let _e1231 = (_e1230 < _e103);
                                                    if _e1231 {
                                                        if _e1231 {
                                                        } else {
                                                            phi_4806_ = true;
                                                            break;
                                                        }
                                                        let _e1233 = global_7.member[_e1230];
                                                        phi_1447_ = _e1233;
                                                    } else {
                                                        phi_1447_ = 4294967295u;
                                                    }
                                                    let _e1235 = phi_1447_;
                                                    if _e1213 {
                                                        phi_1480_ = 0u;
                                                    } else {
                                                        phi_1480_ = select(2u, 1u, (_e1211 < (2097152f * _e155)));
                                                    }
                                                    let _e1240 = phi_1480_;
                                                    switch bitcast<i32>(_e1240) {
                                                        case 0: {
                                                            phi_1486_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1486_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1486_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1486_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1243 = phi_1486_;
                                                    let _e1247 = (_e697 + (_e1186.member_1 * ((3u * _e1243) + 1u)));
                                                    switch bitcast<i32>(_e1240) {
                                                        case 0: {
                                                            let _e1522 = (_e1247 < _e103);
                                                            if _e1522 {
                                                                if _e1522 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1524 = global_7.member[_e1247];
                                                                phi_1513_ = _e1524;
                                                            } else {
                                                                phi_1513_ = 0u;
                                                            }
                                                            let _e1526 = phi_1513_;
                                                            let _e1528 = ((10u * _e281) & 31u);
                                                            let _e1538 = ((10u * _e280) & 31u);
                                                            let _e1548 = ((10u * _e282) & 31u);
                                                            let _e1558 = (_e1247 + 1u);
                                                            let _e1559 = (_e1558 < _e103);
                                                            if _e1559 {
                                                                if _e1559 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1561 = global_7.member[_e1558];
                                                                phi_1562_ = _e1561;
                                                            } else {
                                                                phi_1562_ = 0u;
                                                            }
                                                            let _e1563 = phi_1562_;
                                                            let _e1589 = (_e1247 + 2u);
                                                            let _e1590 = (_e1589 < _e103);
                                                            if _e1590 {
                                                                if _e1590 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1592 = global_7.member[_e1589];
                                                                phi_1611_ = _e1592;
                                                            } else {
                                                                phi_1611_ = 0u;
                                                            }
                                                            let _e1594 = phi_1611_;
                                                            phi_2112_ = array<array<f32, 3>, 3>(array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1526 >> bitcast<u32>(_e1528)) & 1023u))) - 8388608f) * _e155)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1526 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e155)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1526 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1563 >> bitcast<u32>(_e1528)) & 1023u))) - 8388608f) * _e155)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1563 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e155)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1563 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1594 >> bitcast<u32>(_e1528)) & 1023u))) - 8388608f) * _e155)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1594 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e155)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1594 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1336 = (_e1247 < _e103);
                                                            if _e1336 {
                                                                if _e1336 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1338 = global_7.member[_e1247];
                                                                phi_1660_ = _e1338;
                                                            } else {
                                                                phi_1660_ = 0u;
                                                            }
                                                            let _e1340 = phi_1660_;
                                                            let _e1341 = (_e1247 + 1u);
                                                            let _e1342 = (_e1341 < _e103);
                                                            if _e1342 {
                                                                if _e1342 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1344 = global_7.member[_e1341];
                                                                phi_1675_ = _e1344;
                                                            } else {
                                                                phi_1675_ = 0u;
                                                            }
                                                            let _e1346 = phi_1675_;
                                                            let _e1347 = (_e281 == 1u);
                                                            if _e1347 {
                                                                phi_1685_ = ((_e1340 >> bitcast<u32>(21i)) | (_e1346 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1685_ = (_e1346 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1356 = phi_1685_;
                                                            let _e1364 = (_e280 == 1u);
                                                            if _e1364 {
                                                                phi_1706_ = ((_e1340 >> bitcast<u32>(21i)) | (_e1346 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1706_ = (_e1346 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1373 = phi_1706_;
                                                            let _e1381 = (_e282 == 1u);
                                                            if _e1381 {
                                                                phi_1727_ = ((_e1340 >> bitcast<u32>(21i)) | (_e1346 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1727_ = (_e1346 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1390 = phi_1727_;
                                                            let _e1399 = (_e1247 + 2u);
                                                            let _e1400 = (_e1399 < _e103);
                                                            if _e1400 {
                                                                if _e1400 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1402 = global_7.member[_e1399];
                                                                phi_1757_ = _e1402;
                                                            } else {
                                                                phi_1757_ = 0u;
                                                            }
                                                            let _e1404 = phi_1757_;
                                                            let _e1405 = (_e1247 + 3u);
                                                            let _e1406 = (_e1405 < _e103);
                                                            if _e1406 {
                                                                if _e1406 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1408 = global_7.member[_e1405];
                                                                phi_1772_ = _e1408;
                                                            } else {
                                                                phi_1772_ = 0u;
                                                            }
                                                            let _e1410 = phi_1772_;
                                                            if _e1347 {
                                                                phi_1782_ = ((_e1404 >> bitcast<u32>(21i)) | (_e1410 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1782_ = (_e1410 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1419 = phi_1782_;
                                                            if _e1364 {
                                                                phi_1803_ = ((_e1404 >> bitcast<u32>(21i)) | (_e1410 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1803_ = (_e1410 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1435 = phi_1803_;
                                                            if _e1381 {
                                                                phi_1824_ = ((_e1404 >> bitcast<u32>(21i)) | (_e1410 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1824_ = (_e1410 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1451 = phi_1824_;
                                                            let _e1460 = (_e1247 + 4u);
                                                            let _e1461 = (_e1460 < _e103);
                                                            if _e1461 {
                                                                if _e1461 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1463 = global_7.member[_e1460];
                                                                phi_1854_ = _e1463;
                                                            } else {
                                                                phi_1854_ = 0u;
                                                            }
                                                            let _e1465 = phi_1854_;
                                                            let _e1466 = (_e1247 + 5u);
                                                            let _e1467 = (_e1466 < _e103);
                                                            if _e1467 {
                                                                if _e1467 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1469 = global_7.member[_e1466];
                                                                phi_1869_ = _e1469;
                                                            } else {
                                                                phi_1869_ = 0u;
                                                            }
                                                            let _e1471 = phi_1869_;
                                                            if _e1347 {
                                                                phi_1879_ = ((_e1465 >> bitcast<u32>(21i)) | (_e1471 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1879_ = (_e1471 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1480 = phi_1879_;
                                                            if _e1364 {
                                                                phi_1900_ = ((_e1465 >> bitcast<u32>(21i)) | (_e1471 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1900_ = (_e1471 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1496 = phi_1900_;
                                                            if _e1381 {
                                                                phi_1921_ = ((_e1465 >> bitcast<u32>(21i)) | (_e1471 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1921_ = (_e1471 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1512 = phi_1921_;
                                                            phi_2112_ = array<array<f32, 3>, 3>(array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1356, _e1340, _e305) & 2097151u))) - 8388608f) * _e155)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1373, _e1340, _e370) & 2097151u))) - 8388608f) * _e155)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1390, _e1340, _e434) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1419, _e1404, _e305) & 2097151u))) - 8388608f) * _e155)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1435, _e1404, _e370) & 2097151u))) - 8388608f) * _e155)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1451, _e1404, _e434) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1480, _e1465, _e305) & 2097151u))) - 8388608f) * _e155)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1496, _e1465, _e370) & 2097151u))) - 8388608f) * _e155)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1512, _e1465, _e434) & 2097151u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1249 = (_e1247 + _e281);
                                                            let _e1250 = (_e1249 < _e103);
                                                            if _e1250 {
                                                                if _e1250 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1252 = global_7.member[_e1249];
                                                                phi_1952_ = _e1252;
                                                            } else {
                                                                phi_1952_ = 0u;
                                                            }
                                                            let _e1254 = phi_1952_;
                                                            let _e1258 = (_e1247 + _e280);
                                                            let _e1259 = (_e1258 < _e103);
                                                            if _e1259 {
                                                                if _e1259 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1261 = global_7.member[_e1258];
                                                                phi_1970_ = _e1261;
                                                            } else {
                                                                phi_1970_ = 0u;
                                                            }
                                                            let _e1263 = phi_1970_;
                                                            let _e1267 = (_e1247 + _e282);
                                                            let _e1268 = (_e1267 < _e103);
                                                            if _e1268 {
                                                                if _e1268 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1270 = global_7.member[_e1267];
                                                                phi_1988_ = _e1270;
                                                            } else {
                                                                phi_1988_ = 0u;
                                                            }
                                                            let _e1272 = phi_1988_;
                                                            let _e1277 = (_e1247 + 3u);
                                                            let _e1278 = (_e1277 + _e281);
                                                            let _e1279 = (_e1278 < _e103);
                                                            if _e1279 {
                                                                if _e1279 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1281 = global_7.member[_e1278];
                                                                phi_2011_ = _e1281;
                                                            } else {
                                                                phi_2011_ = 0u;
                                                            }
                                                            let _e1283 = phi_2011_;
                                                            let _e1287 = (_e1277 + _e280);
                                                            let _e1288 = (_e1287 < _e103);
                                                            if _e1288 {
                                                                if _e1288 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1290 = global_7.member[_e1287];
                                                                phi_2029_ = _e1290;
                                                            } else {
                                                                phi_2029_ = 0u;
                                                            }
                                                            let _e1292 = phi_2029_;
                                                            let _e1296 = (_e1277 + _e282);
                                                            let _e1297 = (_e1296 < _e103);
                                                            if _e1297 {
                                                                if _e1297 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1299 = global_7.member[_e1296];
                                                                phi_2047_ = _e1299;
                                                            } else {
                                                                phi_2047_ = 0u;
                                                            }
                                                            let _e1301 = phi_2047_;
                                                            let _e1306 = (_e1247 + 6u);
                                                            let _e1307 = (_e1306 + _e281);
                                                            let _e1308 = (_e1307 < _e103);
                                                            if _e1308 {
                                                                if _e1308 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1310 = global_7.member[_e1307];
                                                                phi_2070_ = _e1310;
                                                            } else {
                                                                phi_2070_ = 0u;
                                                            }
                                                            let _e1312 = phi_2070_;
                                                            let _e1316 = (_e1306 + _e280);
                                                            let _e1317 = (_e1316 < _e103);
                                                            if _e1317 {
                                                                if _e1317 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1319 = global_7.member[_e1316];
                                                                phi_2088_ = _e1319;
                                                            } else {
                                                                phi_2088_ = 0u;
                                                            }
                                                            let _e1321 = phi_2088_;
                                                            let _e1325 = (_e1306 + _e282);
                                                            let _e1326 = (_e1325 < _e103);
                                                            if _e1326 {
                                                                if _e1326 {
                                                                } else {
                                                                    phi_4806_ = true;
                                                                    break;
                                                                }
                                                                let _e1328 = global_7.member[_e1325];
                                                                phi_2106_ = _e1328;
                                                            } else {
                                                                phi_2106_ = 0u;
                                                            }
                                                            let _e1330 = phi_2106_;
                                                            phi_2112_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1254)) * _e155), (f32(bitcast<i32>(_e1263)) * _e155), (f32(bitcast<i32>(_e1272)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e1283)) * _e155), (f32(bitcast<i32>(_e1292)) * _e155), (f32(bitcast<i32>(_e1301)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e1312)) * _e155), (f32(bitcast<i32>(_e1321)) * _e155), (f32(bitcast<i32>(_e1330)) * _e155)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2112_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1622 = phi_2112_;
                                                    let _e1639 = (_e1622[0][2] - _e457);
                                                    let _e1642 = (((_e1622[0][0] - _e328) * _e493) - (_e1639 * _e365));
                                                    let _e1645 = (((_e1622[0][1] - _e393) * _e493) - (_e1639 * _e429));
                                                    let _e1648 = (_e1622[1][2] - _e457);
                                                    let _e1651 = (((_e1622[1][0] - _e328) * _e493) - (_e1648 * _e365));
                                                    let _e1654 = (((_e1622[1][1] - _e393) * _e493) - (_e1648 * _e429));
                                                    let _e1657 = (_e1622[2][2] - _e457);
                                                    let _e1660 = (((_e1622[2][0] - _e328) * _e493) - (_e1657 * _e365));
                                                    let _e1663 = (((_e1622[2][1] - _e393) * _e493) - (_e1657 * _e429));
                                                    let _e1664 = (_e1660 * _e1654);
                                                    let _e1665 = (_e1663 * _e1651);
                                                    let _e1666 = (_e1642 * _e1663);
                                                    let _e1667 = (_e1645 * _e1660);
                                                    let _e1668 = (_e1651 * _e1645);
                                                    let _e1669 = (_e1654 * _e1642);
                                                    let _e1674 = (((_e1664 >= _e1665) && (_e1666 >= _e1667)) && (_e1668 >= _e1669));
                                                    let _e1680 = (_e1674 || (((_e1664 <= _e1665) && (_e1666 <= _e1667)) && (_e1668 <= _e1669)));
                                                    if _e1680 {
                                                        let _e1682 = select(-1f, 1f, _e1674);
                                                        let _e1684 = ((_e1664 - _e1665) * _e1682);
                                                        let _e1686 = select(0f, _e1684, (_e1684 > 0f));
                                                        let _e1688 = ((_e1666 - _e1667) * _e1682);
                                                        let _e1690 = select(0f, _e1688, (_e1688 > 0f));
                                                        let _e1692 = ((_e1668 - _e1669) * _e1682);
                                                        let _e1694 = select(0f, _e1692, (_e1692 > 0f));
                                                        let _e1696 = ((_e1686 + _e1690) + _e1694);
                                                        let _e1698 = select(_e1622[1][0], _e1622[0][0], (_e1622[0][0] < _e1622[1][0]));
                                                        let _e1702 = select(_e1622[1][0], _e1622[0][0], (_e1622[0][0] > _e1622[1][0]));
                                                        let _e1706 = select(_e1622[1][1], _e1622[0][1], (_e1622[0][1] < _e1622[1][1]));
                                                        let _e1710 = select(_e1622[1][1], _e1622[0][1], (_e1622[0][1] > _e1622[1][1]));
                                                        let _e1714 = select(_e1622[1][2], _e1622[0][2], (_e1622[0][2] < _e1622[1][2]));
                                                        let _e1718 = select(_e1622[1][2], _e1622[0][2], (_e1622[0][2] > _e1622[1][2]));
                                                        let _e1723 = ((select(_e1622[2][0], _e1698, (_e1698 < _e1622[2][0])) - _e366) * _e369);
                                                        let _e1724 = ((select(_e1622[2][0], _e1702, (_e1702 > _e1622[2][0])) - _e367) * _e369);
                                                        let _e1727 = ((select(_e1622[2][1], _e1706, (_e1706 < _e1622[2][1])) - _e430) * _e433);
                                                        let _e1728 = ((select(_e1622[2][1], _e1710, (_e1710 > _e1622[2][1])) - _e431) * _e433);
                                                        let _e1731 = ((select(_e1622[2][2], _e1714, (_e1714 < _e1622[2][2])) - _e494) * _e497);
                                                        let _e1732 = ((select(_e1622[2][2], _e1718, (_e1718 > _e1622[2][2])) - _e495) * _e497);
                                                        let _e1734 = select(_e1732, _e1731, (_e1731 < _e1732));
                                                        let _e1736 = select(_e1732, _e1731, (_e1731 > _e1732));
                                                        let _e1738 = select(_e1724, _e1723, (_e1723 < _e1724));
                                                        let _e1740 = select(_e1728, _e1727, (_e1727 < _e1728));
                                                        let _e1742 = select(_e1740, _e1738, (_e1738 > _e1740));
                                                        let _e1744 = select(_e1734, _e1742, (_e1742 > _e1734));
                                                        let _e1746 = select(_e1724, _e1723, (_e1723 > _e1724));
                                                        let _e1748 = select(_e1728, _e1727, (_e1727 > _e1728));
                                                        let _e1750 = select(_e1748, _e1746, (_e1746 < _e1748));
                                                        let _e1752 = select(_e1736, _e1750, (_e1750 < _e1736));
                                                        let _e1753 = -(_e1734);
                                                        let _e1759 = select(_e599, _e1744, (_e1744 > _e599));
                                                        let _e1763 = select(_e1651, _e1642, (_e1642 < _e1651));
                                                        let _e1768 = select(_e1651, _e1642, (_e1642 > _e1651));
                                                        let _e1775 = select(_e1654, _e1645, (_e1645 < _e1654));
                                                        let _e1780 = select(_e1654, _e1645, (_e1645 > _e1654));
                                                        let _e1789 = (((((_e1680 && (_e1696 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1660, _e1763, (_e1763 < _e1660)) <= 0f) && (select(_e1660, _e1768, (_e1768 > _e1660)) >= 0f))) && ((select(_e1663, _e1775, (_e1775 < _e1663)) <= 0f) && (select(_e1663, _e1780, (_e1780 > _e1663)) >= 0f))) && (_e1759 <= (_e1752 + (select(_e1753, _e1736, (_e1736 > _e1753)) * 0.0000019073523f)))) && (_e1759 <= _e1169.member.member_1));
                                                        if _e1789 {
                                                            let _e1794 = (_e1622[1][0] - _e1622[0][0]);
                                                            let _e1795 = (_e1622[1][1] - _e1622[0][1]);
                                                            let _e1796 = (_e1622[1][2] - _e1622[0][2]);
                                                            let _e1797 = vec3<f32>(_e1794, _e1795, _e1796);
                                                            let _e1798 = (_e1622[2][0] - _e1622[1][0]);
                                                            let _e1799 = (_e1622[2][1] - _e1622[1][1]);
                                                            let _e1800 = (_e1622[2][2] - _e1622[1][2]);
                                                            let _e1801 = vec3<f32>(_e1798, _e1799, _e1800);
                                                            let _e1802 = (_e1622[0][0] - _e1622[2][0]);
                                                            let _e1803 = (_e1622[0][1] - _e1622[2][1]);
                                                            let _e1804 = (_e1622[0][2] - _e1622[2][2]);
                                                            let _e1805 = vec3<f32>(_e1802, _e1803, _e1804);
                                                            let _e1808 = bitcast<f32>((bitcast<u32>(_e1794) & 2147483647u));
                                                            let _e1811 = bitcast<f32>((bitcast<u32>(_e1795) & 2147483647u));
                                                            let _e1813 = select(_e1811, _e1808, (_e1808 > _e1811));
                                                            let _e1816 = bitcast<f32>((bitcast<u32>(_e1796) & 2147483647u));
                                                            let _e1818 = select(_e1816, _e1813, (_e1813 > _e1816));
                                                            let _e1821 = bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u));
                                                            let _e1824 = bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u));
                                                            let _e1826 = select(_e1824, _e1821, (_e1821 > _e1824));
                                                            let _e1829 = bitcast<f32>((bitcast<u32>(_e1800) & 2147483647u));
                                                            let _e1831 = select(_e1829, _e1826, (_e1826 > _e1829));
                                                            let _e1834 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                            let _e1837 = bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u));
                                                            let _e1839 = select(_e1837, _e1834, (_e1834 > _e1837));
                                                            let _e1842 = bitcast<f32>((bitcast<u32>(_e1804) & 2147483647u));
                                                            let _e1844 = select(_e1842, _e1839, (_e1839 > _e1842));
                                                            let _e1846 = select(_e1831, _e1818, (_e1818 > _e1831));
                                                            let _e1848 = select(_e1844, _e1846, (_e1846 > _e1844));
                                                            if (_e1818 == _e1848) {
                                                                phi_2642_ = _e1654;
                                                                phi_2643_ = _e1651;
                                                                phi_2644_ = _e1645;
                                                                phi_2645_ = _e1642;
                                                                phi_2646_ = vec3<f32>(_e1622[0][0], _e1622[0][1], _e1622[0][2]);
                                                                phi_2647_ = _e1805;
                                                                phi_2648_ = _e1801;
                                                                phi_2649_ = _e1797;
                                                            } else {
                                                                let _e1850 = (_e1831 == _e1848);
                                                                let _e1855 = vec3(_e1850);
                                                                phi_2642_ = select(_e1645, _e1663, _e1850);
                                                                phi_2643_ = select(_e1642, _e1660, _e1850);
                                                                phi_2644_ = select(_e1663, _e1654, _e1850);
                                                                phi_2645_ = select(_e1660, _e1651, _e1850);
                                                                phi_2646_ = select(vec3<f32>(_e1622[2][0], _e1622[2][1], _e1622[2][2]), vec3<f32>(_e1622[1][0], _e1622[1][1], _e1622[1][2]), _e1855);
                                                                phi_2647_ = select(_e1801, _e1797, _e1855);
                                                                phi_2648_ = select(_e1797, _e1805, _e1855);
                                                                phi_2649_ = select(_e1805, _e1801, _e1855);
                                                            }
                                                            let _e1861 = phi_2642_;
                                                            let _e1863 = phi_2643_;
                                                            let _e1865 = phi_2644_;
                                                            let _e1867 = phi_2645_;
                                                            let _e1869 = phi_2646_;
                                                            let _e1871 = phi_2647_;
                                                            let _e1873 = phi_2648_;
                                                            let _e1875 = phi_2649_;
                                                            let _e1882 = ((_e1873.y * _e1871.z) - (_e1871.y * _e1873.z));
                                                            let _e1887 = ((_e1873.z * _e1871.x) - (_e1871.z * _e1873.x));
                                                            let _e1890 = ((_e1873.x * _e1871.y) - (_e1871.x * _e1873.y));
                                                            let _e1893 = ((_e1686 >= _e1690) && (_e1686 >= _e1694));
                                                            let _e1894 = (_e1690 >= _e1694);
                                                            let _e1908 = (((_e1882 * (select(select(_e1622[2][0], _e1622[1][0], _e1894), _e1622[0][0], _e1893) - _e328)) + (_e1887 * (select(select(_e1622[2][1], _e1622[1][1], _e1894), _e1622[0][1], _e1893) - _e393))) + (_e1890 * (select(select(_e1622[2][2], _e1622[1][2], _e1894), _e1622[0][2], _e1893) - _e457)));
                                                            let _e1913 = (((_e1882 * _e365) + (_e1887 * _e429)) + (_e1890 * _e493));
                                                            let _e1914 = (_e1863 - _e1867);
                                                            let _e1915 = (_e1861 - _e1865);
                                                            let _e1918 = ((_e1914 * _e1914) + (_e1915 * _e1915));
                                                            let _e1925 = (-(((_e1867 * _e1914) + (_e1865 * _e1915))) / select(0.000000000000000000000000000000000000011754944f, _e1918, (_e1918 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1927 = select(1f, _e1925, (_e1925 < 1f));
                                                            let _e1929 = select(0f, _e1927, (_e1927 > 0f));
                                                            let _e1938 = ((_e1869.x + (_e1875.x * _e1929)) - _e328);
                                                            let _e1941 = ((_e1869.y + (_e1875.y * _e1929)) - _e393);
                                                            let _e1944 = ((_e1869.z + (_e1875.z * _e1929)) - _e457);
                                                            let _e1947 = bitcast<f32>((bitcast<u32>(_e1938) & 2147483647u));
                                                            let _e1950 = bitcast<f32>((bitcast<u32>(_e1941) & 2147483647u));
                                                            let _e1952 = select(_e1950, _e1947, (_e1947 > _e1950));
                                                            let _e1955 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                            let _e1957 = select(_e1955, _e1952, (_e1952 > _e1955));
                                                            let _e1963 = bitcast<f32>((bitcast<u32>(_e1882) & 2147483647u));
                                                            let _e1966 = bitcast<f32>((bitcast<u32>(_e1887) & 2147483647u));
                                                            let _e1968 = select(_e1966, _e1963, (_e1963 > _e1966));
                                                            let _e1971 = bitcast<f32>((bitcast<u32>(_e1890) & 2147483647u));
                                                            let _e1990 = bitcast<f32>((bitcast<u32>(_e1873.x) & 2147483647u));
                                                            let _e1993 = bitcast<f32>((bitcast<u32>(_e1873.y) & 2147483647u));
                                                            let _e1995 = select(_e1993, _e1990, (_e1990 > _e1993));
                                                            let _e1998 = bitcast<f32>((bitcast<u32>(_e1873.z) & 2147483647u));
                                                            let _e2004 = bitcast<f32>((bitcast<u32>(_e1871.x) & 2147483647u));
                                                            let _e2007 = bitcast<f32>((bitcast<u32>(_e1871.y) & 2147483647u));
                                                            let _e2009 = select(_e2007, _e2004, (_e2004 > _e2007));
                                                            let _e2012 = bitcast<f32>((bitcast<u32>(_e1871.z) & 2147483647u));
                                                            let _e2018 = ((bitcast<f32>((bitcast<u32>(((((_e1882 * _e1938) + (_e1887 * _e1941)) + (_e1890 * _e1944)) - _e1908)) & 2147483647u)) <= ((0.0000009536743f * select(_e1848, _e1957, (_e1957 > _e1848))) * select(_e1971, _e1968, (_e1968 > _e1971)))) && !((bitcast<f32>((bitcast<u32>(_e1913) & 2147483647u)) <= ((0.0000038146973f * select(_e1998, _e1995, (_e1995 > _e1998))) * select(_e2012, _e2009, (_e2009 > _e2012))))));
                                                            let _e2019 = (_e1908 / _e1913);
                                                            if (_e1789 && !(_e2018)) {
                                                                let _e2022 = (_e1944 / _e493);
                                                                let _e2030 = (((_e1882 * (_e1938 - (_e365 * _e2022))) + (_e1887 * (_e1941 - (_e429 * _e2022)))) / _e1913);
                                                                phi_2840_ = select(select(_e2022, (_e2022 + _e2030), (bitcast<f32>((bitcast<u32>(_e2030) & 2147483647u)) <= _e1848)), _e2019, _e2018);
                                                            } else {
                                                                phi_2840_ = _e2019;
                                                            }
                                                            let _e2039 = phi_2840_;
                                                            let _e2041 = select(_e1752, _e2039, (_e2039 < _e1752));
                                                            let _e2043 = select(_e1744, _e2041, (_e2041 > _e1744));
                                                            let _e2044 = (1f / _e1696);
                                                            phi_2860_ = type_42(_e2043, (_e1690 * _e2044), (_e1694 * _e2044), ((_e1789 && (_e2043 >= _e599)) && (_e2043 <= _e1169.member.member_1)));
                                                            phi_2861_ = type_42();
                                                        } else {
                                                            phi_2860_ = type_42();
                                                            phi_2861_ = type_42(0f, 0f, 0f, _e1789);
                                                        }
                                                        let _e2053 = phi_2860_;
                                                        let _e2055 = phi_2861_;
                                                        phi_2864_ = _e2053;
                                                        phi_2865_ = _e2055;
                                                        phi_2866_ = select(true, false, _e1789);
                                                    } else {
                                                        phi_2864_ = type_42();
                                                        phi_2865_ = type_42(0f, 0f, 0f, _e1680);
                                                        phi_2866_ = true;
                                                    }
                                                    let _e2058 = phi_2864_;
                                                    let _e2060 = phi_2865_;
                                                    let _e2062 = phi_2866_;
                                                    if _e2062 {
                                                        phi_2870_ = _e2060;
                                                    } else {
                                                        phi_2870_ = _e2058;
                                                    }
                                                    let _e2064 = phi_2870_;
                                                    if _e2064.member_3 {
                                                        phi_2879_ = type_22(_e2064.member, _e2064.member_1, _e2064.member_2, _e1235);
                                                    } else {
                                                        phi_2879_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e2071 = phi_2879_;
                                                    if (_e2071.member_3 != 4294967295u) {
                                                        if (_e1235 != _e605) {
                                                            if (_e2071.member < _e1169.member.member.member) {
                                                                phi_2905_ = true;
                                                            } else {
                                                                if (_e2071.member == _e1169.member.member.member) {
                                                                    phi_2904_ = (_e2071.member_3 < _e1169.member.member.member_3);
                                                                } else {
                                                                    phi_2904_ = false;
                                                                }
                                                                let _e2086 = phi_2904_;
                                                                phi_2905_ = _e2086;
                                                            }
                                                            let _e2088 = phi_2905_;
                                                            if _e2088 {
                                                                phi_2912_ = type_43(type_39(_e2071, _e2071.member), _e1196.member_1, _e1196.member_2);
                                                            } else {
                                                                phi_2912_ = _e1196;
                                                            }
                                                            let _e2095 = phi_2912_;
                                                            phi_2913_ = _e2095;
                                                        } else {
                                                            phi_2913_ = _e1196;
                                                        }
                                                        let _e2097 = phi_2913_;
                                                        phi_2914_ = _e2097;
                                                    } else {
                                                        phi_2914_ = _e1196;
                                                    }
                                                    let _e2099 = phi_2914_;
                                                    phi_1346_ = _e2099;
                                                } else {
                                                    phi_1346_ = type_43();
                                                }
                                                let _e2101 = phi_1346_;
                                                continue;
                                                continuing {
                                                    phi_1345_ = _e2101;
                                                    phi_1348_ = _e1184;
                                                    phi_4806_ = _e646;
                                                    break if !(_e1190);
                                                }
                                            }
                                            let _e2104 = phi_4806_;
                                            phi_5006_ = _e2104;
                                            if _e2104 {
                                                break;
                                            }
                                            let _e2106 = local_10;
                                            phi_5010_ = _e2104;
                                            let _e2455 = local_13;
                                            phi_4179_ = _e2455;
                                            phi_4180_ = false;
                                            phi_4181_ = _e690;
                                            phi_4182_ = select(_e692, 0u, (_e599 > _e2106.member.member_1));
                                        } else {
                                            if (_e690.member_1 >= _e100) {
                                                phi_3715_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e690.member_1 < _e100) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e705 = ((1u + _e281) % 4u);
                                                if (_e705 < 4u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e710 = global_3.member[_e690.member_1][_e705];
                                                let _e712 = (_e710 >> bitcast<u32>(11u));
                                                let _e714 = ((1u + _e280) % 4u);
                                                if (_e714 < 4u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e719 = global_3.member[_e690.member_1][_e714];
                                                let _e721 = (_e719 >> bitcast<u32>(11u));
                                                let _e723 = ((1u + _e282) % 4u);
                                                if (_e723 < 4u) {
                                                } else {
                                                    phi_5006_ = true;
                                                    break;
                                                }
                                                let _e728 = global_3.member[_e690.member_1][_e723];
                                                let _e730 = (_e728 >> bitcast<u32>(11u));
                                                let _e753 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.x - _e690.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e754 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.y - _e690.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e755 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.z - _e690.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e757 = select(_e155, _e753, (_e753 > _e155));
                                                let _e759 = select(_e155, _e754, (_e754 > _e155));
                                                let _e761 = select(_e155, _e755, (_e755 > _e155));
                                                let _e792 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e710 & 1023u))) - 8388608f) * _e757));
                                                let _e797 = (bitcast<i32>((_e710 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e800 = bitcast<f32>((_e792 & bitcast<u32>(_e797)));
                                                let _e801 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 1023u))) - 8388608f) * _e759));
                                                let _e806 = (bitcast<i32>((_e719 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e809 = bitcast<f32>((_e801 & bitcast<u32>(_e806)));
                                                let _e810 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 1023u))) - 8388608f) * _e761));
                                                let _e815 = (bitcast<i32>((_e728 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e818 = bitcast<f32>((_e810 & bitcast<u32>(_e815)));
                                                let _e822 = bitcast<f32>((_e792 & bitcast<u32>(~(_e797))));
                                                let _e826 = bitcast<f32>((_e801 & bitcast<u32>(~(_e806))));
                                                let _e830 = bitcast<f32>((_e810 & bitcast<u32>(~(_e815))));
                                                let _e831 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e712 & 1023u))) - 8388608f) * _e757));
                                                let _e836 = (bitcast<i32>((_e712 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e839 = bitcast<f32>((_e831 & bitcast<u32>(_e836)));
                                                let _e840 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e721 & 1023u))) - 8388608f) * _e759));
                                                let _e845 = (bitcast<i32>((_e721 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e848 = bitcast<f32>((_e840 & bitcast<u32>(_e845)));
                                                let _e849 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 1023u))) - 8388608f) * _e761));
                                                let _e854 = (bitcast<i32>((_e730 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e857 = bitcast<f32>((_e849 & bitcast<u32>(_e854)));
                                                let _e861 = bitcast<f32>((_e831 & bitcast<u32>(~(_e836))));
                                                let _e865 = bitcast<f32>((_e840 & bitcast<u32>(~(_e845))));
                                                let _e869 = bitcast<f32>((_e849 & bitcast<u32>(~(_e854))));
                                                let _e870 = (_e690.member.member.x + _e800);
                                                let _e871 = (_e690.member.member.y + _e809);
                                                let _e872 = (_e690.member.member.z + _e818);
                                                let _e875 = (_e690.member.member_1.x - _e839);
                                                let _e876 = (_e690.member.member_1.y - _e848);
                                                let _e877 = (_e690.member.member_1.z - _e857);
                                                let _e896 = (_e875 - _e870);
                                                let _e897 = (_e876 - _e871);
                                                let _e898 = (_e877 - _e872);
                                                let _e900 = select(_e897, _e896, (_e896 > _e897));
                                                let _e902 = select(_e898, _e900, (_e900 > _e898));
                                                if (_e902 < (1024f * _e155)) {
                                                    phi_3416_ = 0u;
                                                } else {
                                                    phi_3416_ = select(2u, 1u, (_e902 < (2097152f * _e155)));
                                                }
                                                let _e909 = phi_3416_;
                                                switch bitcast<i32>(_e909) {
                                                    case 0: {
                                                        phi_3422_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3422_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3422_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3422_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e912 = phi_3422_;
                                                let _e918 = global_3.member[_e690.member_1][0u];
                                                let _e922 = global_3.member[_e690.member_1][1u];
                                                let _e926 = global_3.member[_e690.member_1][2u];
                                                let _e930 = global_3.member[_e690.member_1][3u];
                                                let _e942 = (((_e922 >> bitcast<u32>(22i)) | ((_e926 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e930 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e943 = (_e918 & 268435455u);
                                                let _e944 = (_e942 & 268435455u);
                                                let _e947 = ((_e918 >> bitcast<u32>(28u)) & 7u);
                                                let _e955 = ((_e918 >> bitcast<u32>(31i)) | (((_e942 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e956 = (_e947 != 0u);
                                                if (_e947 == 0u) {
                                                    phi_3677_ = _e943;
                                                } else {
                                                    if (_e947 == 7u) {
                                                        phi_3676_ = 2147483648u;
                                                    } else {
                                                        phi_3676_ = ((2147483648u | (_e947 << bitcast<u32>(28u))) | (_e944 & 268435455u));
                                                    }
                                                    let _e965 = phi_3676_;
                                                    phi_3677_ = _e965;
                                                }
                                                let _e967 = phi_3677_;
                                                if _e956 {
                                                    let _e968 = (_e947 != 7u);
                                                    if _e968 {
                                                        phi_3687_ = (_e944 + (_e947 * ((3u * _e912) + 1u)));
                                                    } else {
                                                        phi_3687_ = u32();
                                                    }
                                                    let _e972 = phi_3687_;
                                                    phi_3689_ = _e972;
                                                    phi_3690_ = select(true, false, _e968);
                                                } else {
                                                    phi_3689_ = u32();
                                                    phi_3690_ = true;
                                                }
                                                let _e975 = phi_3689_;
                                                let _e977 = phi_3690_;
                                                if (_e955 == 0u) {
                                                    phi_3711_ = (_e943 + select(0u, 1u, !(_e956)));
                                                } else {
                                                    if (_e955 == 7u) {
                                                        phi_3710_ = 2147483648u;
                                                    } else {
                                                        phi_3710_ = ((2147483648u | (_e955 << bitcast<u32>(28u))) | (select(_e975, _e944, _e977) & 268435455u));
                                                    }
                                                    let _e990 = phi_3710_;
                                                    phi_3711_ = _e990;
                                                }
                                                let _e992 = phi_3711_;
                                                phi_3715_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e870, (_e690.member.member.x + _e822), _e875, (_e690.member.member_1.x - _e861)), vec4<f32>(_e871, (_e690.member.member.y + _e826), _e876, (_e690.member.member_1.y - _e865)), vec4<f32>(_e872, (_e690.member.member.z + _e830), _e877, (_e690.member.member_1.z - _e869))), type_50(type_34((_e690.member.member + vec4<f32>(_e800, _e809, _e818, 0f)), (_e690.member.member_1 - vec4<f32>(_e839, _e848, _e857, 0f))), _e967), type_50(type_34((_e690.member.member + vec4<f32>(_e822, _e826, _e830, 0f)), (_e690.member.member_1 - vec4<f32>(_e861, _e865, _e869, 0f))), _e992));
                                            }
                                            let _e997 = phi_3715_;
                                            let _e1016 = ((_e997.member[0].x - _e366) * _e369);
                                            let _e1017 = ((_e997.member[0].y - _e366) * _e369);
                                            let _e1018 = ((_e997.member[0].z - _e367) * _e369);
                                            let _e1019 = ((_e997.member[0].w - _e367) * _e369);
                                            let _e1029 = ((_e997.member[1].x - _e430) * _e433);
                                            let _e1030 = ((_e997.member[1].y - _e430) * _e433);
                                            let _e1031 = ((_e997.member[1].z - _e431) * _e433);
                                            let _e1032 = ((_e997.member[1].w - _e431) * _e433);
                                            let _e1042 = ((_e997.member[2].x - _e494) * _e497);
                                            let _e1043 = ((_e997.member[2].y - _e494) * _e497);
                                            let _e1044 = ((_e997.member[2].z - _e495) * _e497);
                                            let _e1045 = ((_e997.member[2].w - _e495) * _e497);
                                            let _e1047 = select(_e1044, _e1042, (_e1042 < _e1044));
                                            let _e1049 = select(_e1045, _e1043, (_e1043 < _e1045));
                                            let _e1051 = select(_e1044, _e1042, (_e1042 > _e1044));
                                            let _e1053 = select(_e1045, _e1043, (_e1043 > _e1045));
                                            let _e1055 = select(_e1018, _e1016, (_e1016 < _e1018));
                                            let _e1057 = select(_e1019, _e1017, (_e1017 < _e1019));
                                            let _e1059 = select(_e1031, _e1029, (_e1029 < _e1031));
                                            let _e1061 = select(_e1032, _e1030, (_e1030 < _e1032));
                                            let _e1063 = select(_e1059, _e1055, (_e1055 > _e1059));
                                            let _e1065 = select(_e1061, _e1057, (_e1057 > _e1061));
                                            let _e1067 = select(_e1047, _e1063, (_e1063 > _e1047));
                                            let _e1069 = select(_e1049, _e1065, (_e1065 > _e1049));
                                            let _e1071 = select(_e1018, _e1016, (_e1016 > _e1018));
                                            let _e1073 = select(_e1019, _e1017, (_e1017 > _e1019));
                                            let _e1075 = select(_e1031, _e1029, (_e1029 > _e1031));
                                            let _e1077 = select(_e1032, _e1030, (_e1030 > _e1032));
                                            let _e1079 = select(_e1075, _e1071, (_e1071 < _e1075));
                                            let _e1081 = select(_e1077, _e1073, (_e1073 < _e1077));
                                            let _e1086 = -(_e1047);
                                            let _e1087 = -(_e1049);
                                            let _e1094 = (select(_e1051, _e1079, (_e1079 < _e1051)) + (select(_e1086, _e1051, (_e1051 > _e1086)) * 0.0000019073523f));
                                            let _e1095 = (select(_e1053, _e1081, (_e1081 < _e1053)) + (select(_e1087, _e1053, (_e1053 > _e1087)) * 0.0000019073523f));
                                            let _e1097 = select(_e599, _e1067, (_e1067 > _e599));
                                            let _e1099 = select(_e599, _e1069, (_e1069 > _e599));
                                            let _e1104 = (_e1097 <= select(_e648.member.member_1, _e1094, (_e1094 < _e648.member.member_1)));
                                            let _e1105 = (_e1099 <= select(_e648.member.member_1, _e1095, (_e1095 < _e648.member.member_1)));
                                            let _e1106 = (_e1097 <= _e1099);
                                            if _e1104 {
                                                if _e1105 {
                                                    if _e1106 {
                                                        phi_4080_ = _e997.member_2;
                                                    } else {
                                                        phi_4080_ = _e997.member_1;
                                                    }
                                                    let _e1110 = phi_4080_;
                                                    let _e1131 = (_e692 % 128u);
                                                    let _e1132 = (_e1131 < 128u);
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1131] = _e1110.member_1;
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1131] = _e1110.member.member.x;
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1131] = _e1110.member.member.y;
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1131] = _e1110.member.member.z;
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1131] = _e1110.member.member_1.x;
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1131] = _e1110.member.member_1.y;
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1131] = _e1110.member.member_1.z;
                                                    if _e1132 {
                                                    } else {
                                                        phi_5006_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1131] = select(_e1097, _e1099, _e1106);
                                                    if _e1106 {
                                                        phi_4156_ = _e997.member_1;
                                                    } else {
                                                        phi_4156_ = _e997.member_2;
                                                    }
                                                    let _e1145 = phi_4156_;
                                                    phi_4157_ = _e1145;
                                                    phi_4158_ = (_e692 + 1u);
                                                } else {
                                                    phi_4157_ = type_50();
                                                    phi_4158_ = u32();
                                                }
                                                let _e1147 = phi_4157_;
                                                let _e1149 = phi_4158_;
                                                phi_4160_ = _e1147;
                                                phi_4161_ = _e1149;
                                                phi_4162_ = select(true, false, _e1105);
                                            } else {
                                                phi_4160_ = type_50();
                                                phi_4161_ = u32();
                                                phi_4162_ = true;
                                            }
                                            let _e1152 = phi_4160_;
                                            let _e1154 = phi_4161_;
                                            let _e1156 = phi_4162_;
                                            if _e1156 {
                                                if _e1104 {
                                                    phi_4171_ = _e997.member_1;
                                                } else {
                                                    phi_4171_ = _e997.member_2;
                                                }
                                                let _e1160 = phi_4171_;
                                                phi_4176_ = select(_e1105, true, _e1104);
                                                phi_4177_ = _e1160;
                                            } else {
                                                phi_4176_ = _e688;
                                                phi_4177_ = _e1152;
                                            }
                                            let _e1163 = phi_4176_;
                                            let _e1165 = phi_4177_;
                                            phi_5010_ = _e646;
                                            phi_4179_ = type_43(_e648.member, (_e648.member_1 + 1u), _e648.member_2);
                                            phi_4180_ = _e1163;
                                            phi_4181_ = _e1165;
                                            phi_4182_ = select(_e1154, _e692, _e1156);
                                        }
                                        let _e2112 = phi_5010_;
                                        let _e2114 = phi_4179_;
                                        let _e2116 = phi_4180_;
                                        let _e2118 = phi_4181_;
                                        let _e2120 = phi_4182_;
                                        phi_5009_ = _e2112;
                                        phi_4183_ = _e2114;
                                        phi_4184_ = _e2116;
                                        phi_4185_ = _e2118;
                                        phi_4186_ = _e2120;
                                        phi_4187_ = (_e656 - 1u);
                                    } else {
                                        phi_5009_ = _e646;
                                        phi_4183_ = _e648;
                                        phi_4184_ = _e688;
                                        phi_4185_ = _e690;
                                        phi_4186_ = _e692;
                                        phi_4187_ = _e656;
                                    }
                                    let _e2122 = phi_5009_;
                                    let _e2124 = phi_4183_;
                                    let _e2126 = phi_4184_;
                                    let _e2128 = phi_4185_;
                                    let _e2130 = phi_4186_;
                                    let _e2132 = phi_4187_;
                                    phi_5008_ = _e2122;
                                    phi_4188_ = _e2124;
                                    phi_4189_ = _e2126;
                                    phi_4190_ = _e2128;
                                    phi_4191_ = _e2130;
                                    phi_4192_ = _e2132;
                                } else {
                                    phi_5008_ = _e646;
                                    phi_4188_ = type_43();
                                    phi_4189_ = bool();
                                    phi_4190_ = type_50();
                                    phi_4191_ = u32();
                                    phi_4192_ = u32();
                                }
                                let _e2134 = phi_5008_;
                                let _e2136 = phi_4188_;
                                let _e2138 = phi_4189_;
                                let _e2140 = phi_4190_;
                                let _e2142 = phi_4191_;
                                let _e2144 = phi_4192_;
                                phi_5007_ = _e2134;
                                phi_1219_ = _e2136;
                                phi_1222_ = _e2138;
                                phi_1224_ = _e2140;
                                phi_1226_ = _e2142;
                                phi_1228_ = _e2144;
                                phi_4193_ = _e660;
                            } else {
                                phi_5007_ = _e646;
                                phi_1219_ = type_43();
                                phi_1222_ = bool();
                                phi_1224_ = type_50();
                                phi_1226_ = u32();
                                phi_1228_ = u32();
                                phi_4193_ = false;
                            }
                            let _e2146 = phi_5007_;
                            let _e2148 = phi_1219_;
                            let _e2150 = phi_1222_;
                            let _e2152 = phi_1224_;
                            let _e2154 = phi_1226_;
                            let _e2156 = phi_1228_;
                            let _e2158 = phi_4193_;
                            continue;
                            continuing {
                                phi_4812_ = _e2146;
                                phi_1218_ = _e2148;
                                phi_1221_ = _e2150;
                                phi_1223_ = _e2152;
                                phi_1225_ = _e2154;
                                phi_1227_ = _e2156;
                                phi_5006_ = _e2146;
                                break if !(_e2158);
                            }
                        }
                        let _e2161 = phi_5006_;
                        if _e2161 {
                            break;
                        }
                        let _e2163 = local_11;
                        if (_e2163.member.member.member_3 != 4294967295u) {
                            let _e2169 = bitcast<u32>(_e2163.member.member.member);
                            let _e2173 = (bitcast<i32>((_e2169 >> bitcast<u32>(23i))) & 255i);
                            let _e2174 = (_e2173 + _e283);
                            if (_e2173 == 255i) {
                                phi_4252_ = _e2163.member.member.member;
                            } else {
                                if (_e2173 > 0i) {
                                    if (_e2174 > 0i) {
                                        let _e2178 = (_e2174 < 255i);
                                        if _e2178 {
                                            phi_4231_ = bitcast<f32>((_e2169 + bitcast<u32>((_e283 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4231_ = f32();
                                        }
                                        let _e2185 = phi_4231_;
                                        phi_4233_ = _e2185;
                                        phi_4234_ = select(true, false, _e2178);
                                    } else {
                                        phi_4233_ = f32();
                                        phi_4234_ = true;
                                    }
                                    let _e2188 = phi_4233_;
                                    let _e2190 = phi_4234_;
                                    phi_4235_ = _e2188;
                                    phi_4236_ = _e2190;
                                } else {
                                    phi_4235_ = f32();
                                    phi_4236_ = true;
                                }
                                let _e2192 = phi_4235_;
                                let _e2194 = phi_4236_;
                                if _e2194 {
                                    let _e2195 = (_e2169 & 2147483648u);
                                    let _e2202 = ((_e2169 & 8388607u) | (select(0u, 1u, ((_e2169 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2206 = (_e2202 == 0u);
                                    if _e2206 {
                                        phi_4764_ = bitcast<f32>(_e2195);
                                    } else {
                                        let _e2211 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2202)), 32u, _e2206) - 8u);
                                        let _e2214 = (_e2202 << bitcast<u32>((_e2211 & 31u)));
                                        let _e2216 = ((_e2174 + select(0i, 1i, (_e2173 == 0i))) - bitcast<i32>(_e2211));
                                        if (_e2216 >= 255i) {
                                            phi_4754_ = bitcast<f32>((_e2195 | 2139095040u));
                                            phi_4755_ = f32();
                                            phi_4756_ = true;
                                        } else {
                                            let _e2218 = (_e2216 > 0i);
                                            if _e2218 {
                                                phi_4748_ = bitcast<f32>(((_e2195 | (bitcast<u32>(_e2216) << bitcast<u32>(23i))) | (_e2214 & 8388607u)));
                                                phi_4749_ = f32();
                                            } else {
                                                if (_e2216 < -24i) {
                                                    phi_4714_ = 26u;
                                                } else {
                                                    phi_4714_ = bitcast<u32>((1i - _e2216));
                                                }
                                                let _e2223 = phi_4714_;
                                                let _e2224 = (_e2223 & 31u);
                                                let _e2226 = (_e2214 >> bitcast<u32>(_e2224));
                                                let _e2230 = (_e2214 & ((1u << bitcast<u32>(_e2224)) - 1u));
                                                let _e2234 = (1u << bitcast<u32>(((_e2223 - 1u) & 31u)));
                                                if (_e2230 > _e2234) {
                                                    phi_4735_ = true;
                                                } else {
                                                    if (_e2230 == _e2234) {
                                                        phi_4732_ = ((_e2226 & 1u) == 1u);
                                                    } else {
                                                        phi_4732_ = false;
                                                    }
                                                    let _e2240 = phi_4732_;
                                                    phi_4735_ = _e2240;
                                                }
                                                let _e2242 = phi_4735_;
                                                phi_4748_ = f32();
                                                phi_4749_ = bitcast<f32>((_e2195 | (_e2226 + select(0u, 1u, _e2242))));
                                            }
                                            let _e2255 = phi_4748_;
                                            let _e2257 = phi_4749_;
                                            phi_4754_ = _e2255;
                                            phi_4755_ = _e2257;
                                            phi_4756_ = _e2218;
                                        }
                                        let _e2261 = phi_4754_;
                                        let _e2263 = phi_4755_;
                                        let _e2265 = phi_4756_;
                                        phi_4764_ = select(_e2263, _e2261, _e2265);
                                    }
                                    let _e2269 = phi_4764_;
                                    phi_4251_ = _e2269;
                                } else {
                                    phi_4251_ = _e2192;
                                }
                                let _e2271 = phi_4251_;
                                phi_4252_ = _e2271;
                            }
                            let _e2273 = phi_4252_;
                            let _e2274 = bitcast<u32>(_e2273);
                            if ((_e2274 & 2147483647u) >= 2139095040u) {
                                phi_4264_ = bitcast<f32>(((_e2274 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4264_ = _e2273;
                            }
                            let _e2281 = phi_4264_;
                            phi_4269_ = type_22(_e2281, _e2163.member.member.member_1, _e2163.member.member.member_2, _e2163.member.member.member_3);
                        } else {
                            phi_4269_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2286 = phi_4269_;
                        if _e159 {
                        } else {
                            break;
                        }
                        global_1.member[_e143] = _e2286;
                        let _e2290 = local_12;
                        if _e160 {
                        } else {
                            break;
                        }
                        global_5.member[_e143] = _e2290.member_1;
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e2295 = select(0u, 1u, (_e227 <= _e237));
                        if (_e2295 > 0u) {
                            let _e2297 = (1u < _e111);
                            if _e2297 {
                                if (0u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2301 = atomicAdd((&global_6.member[0u]), _e2295);
                                if ((_e2301 + _e2295) < _e2301) {
                                    if _e2297 {
                                    } else {
                                        break;
                                    }
                                    let _e2306 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2309 = select(0u, 1u, (_e2286.member_3 != 4294967295u));
                        if (_e2309 > 0u) {
                            let _e2311 = (3u < _e111);
                            if _e2311 {
                                if (2u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2315 = atomicAdd((&global_6.member[2u]), _e2309);
                                if ((_e2315 + _e2309) < _e2315) {
                                    if _e2311 {
                                    } else {
                                        break;
                                    }
                                    let _e2320 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2290.member_1 > 0u) {
                            let _e2322 = (5u < _e111);
                            if _e2322 {
                                if (4u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2326 = atomicAdd((&global_6.member[4u]), _e2290.member_1);
                                if ((_e2326 + _e2290.member_1) < _e2326) {
                                    if _e2322 {
                                    } else {
                                        break;
                                    }
                                    let _e2331 = atomicAdd((&global_6.member[5u]), 1u);
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
