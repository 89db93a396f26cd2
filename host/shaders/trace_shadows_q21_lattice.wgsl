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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: f32,
    member_1: bool,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<i32>,
}

struct type_54 {
    member: array<array<u32, 7>>,
}

struct type_59 {
    member: type_30,
    member_1: u32,
}

struct type_60 {
    member: array<vec4<f32>, 3>,
    member_1: type_59,
    member_2: type_59,
}

struct type_65 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_45;
@group(0) @binding(2) 
var<uniform> global_4: type_45;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_48;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_65;
@group(0) @binding(3) 
var<storage> global_8: type_54;
@group(0) @binding(7) 
var<storage> global_9: type_33;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var phi_370_: u32;
    var phi_414_: i32;
    var phi_554_: type_36;
    var phi_704_: i32;
    var phi_705_: i32;
    var phi_715_: bool;
    var phi_725_: u32;
    var phi_726_: u32;
    var phi_728_: bool;
    var phi_733_: u32;
    var phi_766_: i32;
    var phi_784_: f32;
    var phi_790_: f32;
    var phi_830_: f32;
    var phi_836_: f32;
    var phi_909_: f32;
    var phi_915_: f32;
    var phi_955_: f32;
    var phi_961_: f32;
    var phi_1034_: f32;
    var phi_1040_: f32;
    var phi_1080_: f32;
    var phi_1086_: f32;
    var phi_1205_: i32;
    var phi_1227_: u32;
    var phi_1228_: u32;
    var phi_1265_: i32;
    var phi_1287_: u32;
    var phi_1288_: u32;
    var phi_1296_: f32;
    var phi_1297_: f32;
    var phi_5070_: bool;
    var phi_1393_: type_43;
    var phi_1396_: bool;
    var phi_1398_: type_59;
    var phi_1400_: u32;
    var phi_1402_: u32;
    var phi_1413_: bool;
    var phi_1499_: bool;
    var phi_1500_: type_59;
    var phi_1501_: u32;
    var phi_3894_: u32;
    var phi_3900_: u32;
    var phi_4154_: u32;
    var phi_4155_: u32;
    var phi_4165_: u32;
    var phi_4167_: u32;
    var phi_4168_: bool;
    var phi_4188_: u32;
    var phi_4189_: u32;
    var phi_4193_: type_60;
    var phi_4555_: type_59;
    var phi_4631_: type_59;
    var phi_4632_: type_59;
    var phi_4633_: u32;
    var phi_4635_: type_59;
    var phi_4636_: u32;
    var phi_4637_: bool;
    var phi_4646_: type_59;
    var phi_4651_: bool;
    var phi_4652_: type_59;
    var phi_1520_: type_43;
    var phi_1523_: type_8;
    var phi_1524_: type_8;
    var phi_1546_: type_8;
    var phi_1587_: u32;
    var phi_1593_: u32;
    var phi_1603_: u32;
    var phi_1619_: u32;
    var phi_1652_: u32;
    var phi_1658_: u32;
    var phi_2124_: u32;
    var phi_2142_: u32;
    var phi_2160_: u32;
    var phi_2183_: u32;
    var phi_2201_: u32;
    var phi_2219_: u32;
    var phi_2242_: u32;
    var phi_2260_: u32;
    var phi_2278_: u32;
    var phi_1832_: u32;
    var phi_1847_: u32;
    var phi_1857_: u32;
    var phi_1878_: u32;
    var phi_1899_: u32;
    var phi_1929_: u32;
    var phi_1944_: u32;
    var phi_1954_: u32;
    var phi_1975_: u32;
    var phi_1996_: u32;
    var phi_2026_: u32;
    var phi_2041_: u32;
    var phi_2051_: u32;
    var phi_2072_: u32;
    var phi_2093_: u32;
    var phi_1685_: u32;
    var phi_1734_: u32;
    var phi_1783_: u32;
    var phi_2284_: array<array<f32, 3>, 3>;
    var phi_2814_: f32;
    var phi_2815_: f32;
    var phi_2816_: f32;
    var phi_2817_: f32;
    var phi_2818_: vec3<f32>;
    var phi_2819_: vec3<f32>;
    var phi_2820_: vec3<f32>;
    var phi_2821_: vec3<f32>;
    var phi_3012_: f32;
    var phi_3032_: type_42;
    var phi_3033_: type_42;
    var phi_3036_: type_42;
    var phi_3037_: type_42;
    var phi_3038_: bool;
    var phi_3042_: type_42;
    var phi_3051_: type_21;
    var phi_3074_: u32;
    var phi_3088_: i32;
    var phi_3110_: vec3<f32>;
    var phi_3111_: vec3<f32>;
    var phi_3129_: vec3<f32>;
    var phi_3130_: vec3<f32>;
    var phi_3148_: vec3<f32>;
    var phi_3149_: vec3<f32>;
    var phi_3185_: vec3<f32>;
    var phi_3367_: f32;
    var phi_3385_: bool;
    var phi_3386_: bool;
    var phi_3391_: type_43;
    var phi_3392_: type_43;
    var phi_1521_: type_43;
    var phi_5064_: bool;
    var local_10: type_43;
    var phi_5300_: bool;
    var phi_4654_: type_43;
    var phi_4655_: bool;
    var phi_4656_: type_59;
    var phi_4657_: u32;
    var phi_5299_: bool;
    var phi_4658_: type_43;
    var phi_4659_: bool;
    var phi_4660_: type_59;
    var phi_4661_: u32;
    var phi_4662_: u32;
    var phi_5298_: bool;
    var phi_4663_: type_43;
    var phi_4664_: bool;
    var phi_4665_: type_59;
    var phi_4666_: u32;
    var phi_4667_: u32;
    var phi_5297_: bool;
    var phi_1394_: type_43;
    var phi_1397_: bool;
    var phi_1399_: type_59;
    var phi_1401_: u32;
    var phi_1403_: u32;
    var phi_4668_: bool;
    var phi_5296_: bool;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e102 = global;
            let _e104 = arrayLength((&global_8.member));
            let _e107 = arrayLength((&global_10.member));
            let _e119 = arrayLength((&global_7.member));
            let _e123 = global_4.member[0u][0u];
            let _e127 = global_4.member[0u][1u];
            let _e131 = global_4.member[0u][2u];
            let _e135 = global_4.member[0u][3u];
            let _e139 = global_4.member[1u][0u];
            let _e143 = global_4.member[1u][1u];
            let _e147 = global_4.member[1u][2u];
            let _e151 = (_e102.x + (_e102.y * 2097152u));
            let _e163 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e135) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            local = array<i32, 3>(bitcast<i32>(_e139), bitcast<i32>(_e143), bitcast<i32>(_e147));
            let _e166 = (_e151 < arrayLength((&global_9.member)));
            if _e166 {
                if _e166 {
                } else {
                    break;
                }
                let _e170 = global_9.member[_e151].member_2;
                phi_370_ = _e170;
            } else {
                phi_370_ = 4294967295u;
            }
            let _e172 = phi_370_;
            let _e175 = global_1.member[0u];
            let _e179 = global_3.member[0u][0u];
            let _e183 = global_3.member[0u][1u];
            let _e187 = global_3.member[0u][2u];
            let _e191 = global_3.member[0u][3u];
            let _e195 = global_3.member[1u][0u];
            let _e199 = global_3.member[1u][1u];
            let _e203 = global_3.member[1u][2u];
            let _e207 = global_3.member[1u][3u];
            let _e208 = bitcast<f32>(_e179);
            let _e209 = bitcast<f32>(_e183);
            let _e210 = bitcast<f32>(_e187);
            let _e212 = bitcast<f32>(_e195);
            let _e213 = array<u32, 3>(_e199, _e203, _e207);
            let _e215 = bitcast<i32>(_e175);
            if (_e215 < -126i) {
                phi_414_ = -126i;
            } else {
                phi_414_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_414_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_554_ = type_36(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                let _e233 = bitcast<u32>(_e208);
                let _e235 = ((_e233 & 2139095040u) != 0u);
                let _e250 = bitcast<u32>(_e209);
                let _e252 = ((_e250 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e210);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                let _e285 = bitcast<u32>(_e212);
                let _e287 = ((_e285 & 2139095040u) != 0u);
                phi_554_ = type_36(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e233 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e233 & 2147483648u))), _e208, _e235) * _e225) * select(0.00000011920929f, 1f, _e235)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e209, _e252) * _e225) * select(0.00000011920929f, 1f, _e252)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e210, _e269) * _e225) * select(0.00000011920929f, 1f, _e269)) * _e231)), _e191, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e212, _e287) * _e225) * select(0.00000011920929f, 1f, _e287)) * _e231), _e213);
            }
            let _e304 = phi_554_;
            if _e166 {
                let _e305 = (_e151 < arrayLength((&global_2.member)));
                if _e305 {
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e310 = global_9.member[_e151].member.member_1;
                    let _e315 = global_9.member[_e151].member.member_3;
                    if (_e310 <= _e315) {
                        let _e317 = (1u < _e119);
                        if _e317 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e321 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e321 + 1u) < _e321) {
                                if _e317 {
                                } else {
                                    break;
                                }
                                let _e326 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e166 {
                        } else {
                            break;
                        }
                        let _e336 = global_9.member[_e151].member.member_2[0u];
                        let _e338 = (bitcast<u32>(_e336) & 2147483647u);
                        let _e344 = global_9.member[_e151].member.member_2[1u];
                        let _e346 = (bitcast<u32>(_e344) & 2147483647u);
                        let _e352 = global_9.member[_e151].member.member_2[2u];
                        let _e354 = (bitcast<u32>(_e352) & 2147483647u);
                        let _e360 = global_9.member[_e151].member.member[0u];
                        let _e362 = (bitcast<u32>(_e360) & 2147483647u);
                        let _e368 = global_9.member[_e151].member.member[1u];
                        let _e370 = (bitcast<u32>(_e368) & 2147483647u);
                        let _e376 = global_9.member[_e151].member.member[2u];
                        let _e378 = (bitcast<u32>(_e376) & 2147483647u);
                        let _e380 = select(_e346, _e338, (_e346 < _e338));
                        let _e382 = select(_e354, _e380, (_e354 < _e380));
                        let _e384 = select(_e362, _e382, (_e362 < _e382));
                        let _e386 = select(_e370, _e384, (_e370 < _e384));
                        let _e388 = select(_e378, _e386, (_e378 < _e386));
                        let _e389 = bitcast<u32>(_e310);
                        let _e390 = (_e389 & 2147483647u);
                        let _e394 = bitcast<u32>(_e315);
                        let _e395 = (_e394 & 2147483647u);
                        let _e399 = (((select(_e390, _e388, (_e390 < _e388)) < 2139095040u) && (_e395 <= 2139095040u)) && (_e382 > 0u));
                        if _e399 {
                            let _e402 = (bitcast<u32>(bitcast<f32>(_e382)) & 2147483647u);
                            if (_e402 >= 8388608u) {
                                phi_704_ = (bitcast<i32>((_e402 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_704_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e402)), 32u, (_e402 == 0u))));
                            }
                            let _e416 = phi_704_;
                            phi_705_ = _e416;
                        } else {
                            phi_705_ = 0i;
                        }
                        let _e418 = phi_705_;
                        let _e419 = (_e338 == _e382);
                        if _e419 {
                            phi_715_ = true;
                        } else {
                            phi_715_ = (_e346 == _e382);
                        }
                        let _e422 = phi_715_;
                        let _e423 = select(1u, 0u, _e419);
                        if _e422 {
                            let _e424 = (_e423 + 1u);
                            phi_725_ = _e424;
                            phi_726_ = _e424;
                            phi_728_ = select(true, false, (_e424 == 2u));
                        } else {
                            phi_725_ = u32();
                            phi_726_ = 0u;
                            phi_728_ = true;
                        }
                        let _e428 = phi_725_;
                        let _e430 = phi_726_;
                        let _e432 = phi_728_;
                        if _e432 {
                            phi_733_ = (_e430 + 1u);
                        } else {
                            phi_733_ = 0u;
                        }
                        let _e436 = phi_733_;
                        let _e437 = select(_e428, _e430, _e432);
                        let _e438 = select(_e423, select(2u, _e423, _e422), _e432);
                        let _e439 = -(_e418);
                        if (_e439 < -126i) {
                            phi_766_ = -126i;
                        } else {
                            phi_766_ = select(_e439, 127i, (_e439 > 127i));
                        }
                        let _e444 = phi_766_;
                        let _e449 = bitcast<f32>((bitcast<u32>((_e444 + 127i)) << bitcast<u32>(23i)));
                        let _e455 = bitcast<f32>((bitcast<u32>(((_e439 - _e444) + 127i)) << bitcast<u32>(23i)));
                        let _e460 = global_9.member[_e151].member.member;
                        let _e461 = (_e437 == 0u);
                        if _e461 {
                            phi_784_ = _e460[0];
                        } else {
                            phi_784_ = _e460[1];
                        }
                        let _e465 = phi_784_;
                        let _e466 = (_e437 == 2u);
                        if _e466 {
                            phi_790_ = _e460[2];
                        } else {
                            phi_790_ = _e465;
                        }
                        let _e469 = phi_790_;
                        let _e470 = bitcast<u32>(_e469);
                        let _e472 = ((_e470 & 2139095040u) != 0u);
                        let _e484 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e470 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e470 & 2147483648u))), _e469, _e472) * select(0.00000011920929f, 1f, _e472));
                        let _e485 = global_9.member[_e151].member.member_2;
                        if _e461 {
                            phi_830_ = _e485[0];
                        } else {
                            phi_830_ = _e485[1];
                        }
                        let _e489 = phi_830_;
                        if _e466 {
                            phi_836_ = _e485[2];
                        } else {
                            phi_836_ = _e489;
                        }
                        let _e492 = phi_836_;
                        let _e493 = bitcast<u32>(_e492);
                        let _e495 = ((_e493 & 2139095040u) != 0u);
                        let _e509 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e493 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e493 & 2147483648u))), _e492, _e495) * _e449) * select(0.00000011920929f, 1f, _e495)) * _e455);
                        let _e513 = (bitcast<f32>((bitcast<u32>(_e509) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e516 = bitcast<f32>((bitcast<u32>(_e484) & 2147483647u));
                        let _e517 = (_e516 * 0.00000011920929f);
                        let _e520 = select(select(0.00000000000011368684f, _e517, (_e517 > 0.00000000000011368684f)), 0f, _e513);
                        let _e521 = select(0f, _e509, _e513);
                        let _e522 = (_e484 + _e520);
                        let _e523 = (_e484 - _e520);
                        let _e525 = select(38685626000000000000000000f, (1f / _e509), _e513);
                        let _e526 = (_e436 == 0u);
                        if _e526 {
                            phi_909_ = _e460[0];
                        } else {
                            phi_909_ = _e460[1];
                        }
                        let _e530 = phi_909_;
                        let _e531 = (_e436 == 2u);
                        if _e531 {
                            phi_915_ = _e460[2];
                        } else {
                            phi_915_ = _e530;
                        }
                        let _e534 = phi_915_;
                        let _e535 = bitcast<u32>(_e534);
                        let _e537 = ((_e535 & 2139095040u) != 0u);
                        let _e549 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e535 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e535 & 2147483648u))), _e534, _e537) * select(0.00000011920929f, 1f, _e537));
                        if _e526 {
                            phi_955_ = _e485[0];
                        } else {
                            phi_955_ = _e485[1];
                        }
                        let _e553 = phi_955_;
                        if _e531 {
                            phi_961_ = _e485[2];
                        } else {
                            phi_961_ = _e553;
                        }
                        let _e556 = phi_961_;
                        let _e557 = bitcast<u32>(_e556);
                        let _e559 = ((_e557 & 2139095040u) != 0u);
                        let _e573 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e557 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e557 & 2147483648u))), _e556, _e559) * _e449) * select(0.00000011920929f, 1f, _e559)) * _e455);
                        let _e577 = (bitcast<f32>((bitcast<u32>(_e573) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e580 = bitcast<f32>((bitcast<u32>(_e549) & 2147483647u));
                        let _e581 = (_e580 * 0.00000011920929f);
                        let _e584 = select(select(0.00000000000011368684f, _e581, (_e581 > 0.00000000000011368684f)), 0f, _e577);
                        let _e585 = select(0f, _e573, _e577);
                        let _e586 = (_e549 + _e584);
                        let _e587 = (_e549 - _e584);
                        let _e589 = select(38685626000000000000000000f, (1f / _e573), _e577);
                        let _e590 = (_e438 == 0u);
                        if _e590 {
                            phi_1034_ = _e460[0];
                        } else {
                            phi_1034_ = _e460[1];
                        }
                        let _e594 = phi_1034_;
                        let _e595 = (_e438 == 2u);
                        if _e595 {
                            phi_1040_ = _e460[2];
                        } else {
                            phi_1040_ = _e594;
                        }
                        let _e598 = phi_1040_;
                        let _e599 = bitcast<u32>(_e598);
                        let _e601 = ((_e599 & 2139095040u) != 0u);
                        let _e613 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e599 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e599 & 2147483648u))), _e598, _e601) * select(0.00000011920929f, 1f, _e601));
                        if _e590 {
                            phi_1080_ = _e485[0];
                        } else {
                            phi_1080_ = _e485[1];
                        }
                        let _e617 = phi_1080_;
                        if _e595 {
                            phi_1086_ = _e485[2];
                        } else {
                            phi_1086_ = _e617;
                        }
                        let _e620 = phi_1086_;
                        let _e621 = bitcast<u32>(_e620);
                        let _e623 = ((_e621 & 2139095040u) != 0u);
                        let _e637 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e621 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e621 & 2147483648u))), _e620, _e623) * _e449) * select(0.00000011920929f, 1f, _e623)) * _e455);
                        let _e641 = (bitcast<f32>((bitcast<u32>(_e637) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e644 = bitcast<f32>((bitcast<u32>(_e613) & 2147483647u));
                        let _e645 = (_e644 * 0.00000011920929f);
                        let _e648 = select(select(0.00000000000011368684f, _e645, (_e645 > 0.00000000000011368684f)), 0f, _e641);
                        let _e649 = select(0f, _e637, _e641);
                        let _e650 = (_e613 + _e648);
                        let _e651 = (_e613 - _e648);
                        let _e653 = select(38685626000000000000000000f, (1f / _e637), _e641);
                        let _e655 = select(_e580, _e516, (_e516 > _e580));
                        if (_e399 && (select(_e644, _e655, (_e655 > _e644)) <= 1099511600000f)) {
                            let _e667 = ((_e390 & 8388607u) | (select(0u, 1u, ((_e390 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e670 = bitcast<i32>((_e390 >> bitcast<u32>(23i)));
                            let _e674 = (_e667 == 0u);
                            let _e677 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e667)), 32u, _e674)) - 8i);
                            if (_e670 == 255i) {
                                phi_1205_ = 255i;
                            } else {
                                phi_1205_ = (((_e670 + select(0i, 1i, (_e670 == 0i))) - _e677) + _e418);
                            }
                            let _e685 = phi_1205_;
                            let _e695 = (_e685 <= 0i);
                            if _e695 {
                                phi_1228_ = u32();
                            } else {
                                if _e674 {
                                    phi_1227_ = u32();
                                } else {
                                    phi_1227_ = select(((bitcast<u32>(_e685) << bitcast<u32>(23i)) | ((_e667 << bitcast<u32>(((_e677 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e685 >= 255i));
                                }
                                let _e699 = phi_1227_;
                                phi_1228_ = _e699;
                            }
                            let _e701 = phi_1228_;
                            let _e713 = ((_e395 & 8388607u) | (select(0u, 1u, ((_e395 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e716 = bitcast<i32>((_e395 >> bitcast<u32>(23i)));
                            let _e720 = (_e713 == 0u);
                            let _e723 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e713)), 32u, _e720)) - 8i);
                            if (_e716 == 255i) {
                                phi_1265_ = 255i;
                            } else {
                                phi_1265_ = (((_e716 + select(0i, 1i, (_e716 == 0i))) - _e723) + _e418);
                            }
                            let _e731 = phi_1265_;
                            let _e741 = (_e731 <= 0i);
                            if _e741 {
                                phi_1288_ = u32();
                            } else {
                                if _e720 {
                                    phi_1287_ = u32();
                                } else {
                                    phi_1287_ = select(((bitcast<u32>(_e731) << bitcast<u32>(23i)) | ((_e713 << bitcast<u32>(((_e723 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e731 >= 255i));
                                }
                                let _e745 = phi_1287_;
                                phi_1288_ = _e745;
                            }
                            let _e747 = phi_1288_;
                            phi_1296_ = bitcast<f32>(((_e394 & 2147483648u) | select(_e747, 0u, select(_e720, true, _e741))));
                            phi_1297_ = bitcast<f32>(((_e389 & 2147483648u) | select(_e701, 0u, select(_e674, true, _e695))));
                        } else {
                            phi_1296_ = 0f;
                            phi_1297_ = 1f;
                        }
                        let _e753 = phi_1296_;
                        let _e755 = phi_1297_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e761 = (_e437 % 3u);
                        let _e762 = (_e761 < 3u);
                        if _e762 {
                        } else {
                            break;
                        }
                        let _e764 = local_1[_e761];
                        let _e767 = (_e436 % 3u);
                        let _e768 = (_e767 < 3u);
                        if _e768 {
                        } else {
                            break;
                        }
                        let _e770 = local_1[_e767];
                        let _e773 = (_e438 % 3u);
                        let _e774 = (_e773 < 3u);
                        if _e774 {
                        } else {
                            break;
                        }
                        let _e776 = local_1[_e773];
                        if _e762 {
                        } else {
                            break;
                        }
                        let _e781 = local[_e761];
                        if _e768 {
                        } else {
                            break;
                        }
                        let _e785 = local[_e767];
                        if _e774 {
                        } else {
                            break;
                        }
                        let _e789 = local[_e773];
                        phi_5070_ = false;
                        phi_1393_ = type_43(_e753, false);
                        phi_1396_ = (_e755 <= _e753);
                        phi_1398_ = type_59(type_30(vec4<f32>((f32(_e764) * _e163), (f32(_e770) * _e163), (f32(_e776) * _e163), 0f), vec4<f32>((f32(_e781) * _e163), (f32(_e785) * _e163), (f32(_e789) * _e163), 0f)), select(0u, 2147483648u, (_e104 == 0u)));
                        phi_1400_ = 0u;
                        phi_1402_ = ((3u * _e104) + 1u);
                        loop {
                            let _e797 = phi_5070_;
                            let _e799 = phi_1393_;
                            let _e801 = phi_1396_;
                            let _e803 = phi_1398_;
                            let _e805 = phi_1400_;
                            let _e807 = phi_1402_;
                            local_11 = _e799;
                            if _e801 {
                                phi_1413_ = true;
                            } else {
                                phi_1413_ = (_e805 > 0u);
                            }
                            let _e810 = phi_1413_;
                            if _e810 {
                                let _e811 = (_e807 > 0u);
                                if _e811 {
                                    if _e801 {
                                        phi_1499_ = _e801;
                                        phi_1500_ = _e803;
                                        phi_1501_ = _e805;
                                    } else {
                                        let _e812 = (_e805 - 1u);
                                        let _e813 = (_e812 % 128u);
                                        let _e814 = (_e813 < 128u);
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e816 = local_7[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e818 = local_6[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e820 = local_5[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e822 = local_4[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e824 = local_3[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e826 = local_2[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e831 = local_8[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e834 = local_9[_e813];
                                        phi_1499_ = (_e834 <= _e799.member);
                                        phi_1500_ = type_59(type_30(vec4<f32>(_e816, _e818, _e820, 0f), vec4<f32>(_e822, _e824, _e826, 0f)), _e831);
                                        phi_1501_ = _e812;
                                    }
                                    let _e838 = phi_1499_;
                                    let _e840 = phi_1500_;
                                    let _e842 = phi_1501_;
                                    if _e838 {
                                        let _e847 = (_e840.member_1 & 268435455u);
                                        if ((_e840.member_1 & 2147483648u) != 0u) {
                                            phi_1520_ = _e799;
                                            phi_1523_ = type_8(0u, ((_e840.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1330 = phi_1520_;
                                                let _e1332 = phi_1523_;
                                                local_10 = _e1330;
                                                local_12 = _e1330;
                                                if (_e1332.member < _e1332.member_1) {
                                                    phi_1524_ = type_8((_e1332.member + 1u), _e1332.member_1);
                                                    phi_1546_ = type_8(1u, _e1332.member);
                                                } else {
                                                    phi_1524_ = _e1332;
                                                    phi_1546_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1345 = phi_1524_;
                                                let _e1347 = phi_1546_;
                                                let _e1351 = (bitcast<i32>(_e1347.member) != 0i);
                                                if _e1351 {
                                                    let _e1356 = (_e840.member.member_1.x - _e840.member.member.x);
                                                    let _e1359 = (_e840.member.member_1.y - _e840.member.member.y);
                                                    let _e1362 = (_e840.member.member_1.z - _e840.member.member.z);
                                                    let _e1364 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                    let _e1366 = select(_e1362, _e1364, (_e1364 > _e1362));
                                                    let _e1368 = (_e1366 < (1024f * _e163));
                                                    if _e1368 {
                                                        phi_1587_ = 0u;
                                                    } else {
                                                        phi_1587_ = select(2u, 1u, (_e1366 < (2097152f * _e163)));
                                                    }
                                                    let _e1373 = phi_1587_;
                                                    switch bitcast<i32>(_e1373) {
                                                        case 0: {
                                                            phi_1593_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1593_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1593_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1593_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1376 = phi_1593_;
                                                    switch bitcast<i32>(_e1373) {
                                                        case 0: {
                                                            phi_1603_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1603_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1603_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1603_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1383 = phi_1603_;
                                                    let _e1385 = ((_e847 + (_e1347.member_1 * ((3u * _e1376) + 1u))) + (3u * _e1383));
                                                    let _e1386 = (_e1385 < _e107);
                                                    if _e1386 {
                                                        if _e1386 {
                                                        } else {
                                                            phi_5064_ = true;
                                                            break;
                                                        }
                                                        let _e1388 = global_10.member[_e1385];
                                                        phi_1619_ = _e1388;
                                                    } else {
                                                        phi_1619_ = 4294967295u;
                                                    }
                                                    let _e1390 = phi_1619_;
                                                    if _e1368 {
                                                        phi_1652_ = 0u;
                                                    } else {
                                                        phi_1652_ = select(2u, 1u, (_e1366 < (2097152f * _e163)));
                                                    }
                                                    let _e1395 = phi_1652_;
                                                    switch bitcast<i32>(_e1395) {
                                                        case 0: {
                                                            phi_1658_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1658_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1658_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1658_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1398 = phi_1658_;
                                                    let _e1402 = (_e847 + (_e1347.member_1 * ((3u * _e1398) + 1u)));
                                                    switch bitcast<i32>(_e1395) {
                                                        case 0: {
                                                            let _e1677 = (_e1402 < _e107);
                                                            if _e1677 {
                                                                if _e1677 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1679 = global_10.member[_e1402];
                                                                phi_1685_ = _e1679;
                                                            } else {
                                                                phi_1685_ = 0u;
                                                            }
                                                            let _e1681 = phi_1685_;
                                                            let _e1683 = ((10u * _e437) & 31u);
                                                            let _e1693 = ((10u * _e436) & 31u);
                                                            let _e1703 = ((10u * _e438) & 31u);
                                                            let _e1713 = (_e1402 + 1u);
                                                            let _e1714 = (_e1713 < _e107);
                                                            if _e1714 {
                                                                if _e1714 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1716 = global_10.member[_e1713];
                                                                phi_1734_ = _e1716;
                                                            } else {
                                                                phi_1734_ = 0u;
                                                            }
                                                            let _e1718 = phi_1734_;
                                                            let _e1744 = (_e1402 + 2u);
                                                            let _e1745 = (_e1744 < _e107);
                                                            if _e1745 {
                                                                if _e1745 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1747 = global_10.member[_e1744];
                                                                phi_1783_ = _e1747;
                                                            } else {
                                                                phi_1783_ = 0u;
                                                            }
                                                            let _e1749 = phi_1783_;
                                                            phi_2284_ = array<array<f32, 3>, 3>(array<f32, 3>((_e840.member.member.x + ((bitcast<f32>((1258291200u | ((_e1681 >> bitcast<u32>(_e1683)) & 1023u))) - 8388608f) * _e163)), (_e840.member.member.y + ((bitcast<f32>((1258291200u | ((_e1681 >> bitcast<u32>(_e1693)) & 1023u))) - 8388608f) * _e163)), (_e840.member.member.z + ((bitcast<f32>((1258291200u | ((_e1681 >> bitcast<u32>(_e1703)) & 1023u))) - 8388608f) * _e163))), array<f32, 3>((_e840.member.member.x + ((bitcast<f32>((1258291200u | ((_e1718 >> bitcast<u32>(_e1683)) & 1023u))) - 8388608f) * _e163)), (_e840.member.member.y + ((bitcast<f32>((1258291200u | ((_e1718 >> bitcast<u32>(_e1693)) & 1023u))) - 8388608f) * _e163)), (_e840.member.member.z + ((bitcast<f32>((1258291200u | ((_e1718 >> bitcast<u32>(_e1703)) & 1023u))) - 8388608f) * _e163))), array<f32, 3>((_e840.member.member.x + ((bitcast<f32>((1258291200u | ((_e1749 >> bitcast<u32>(_e1683)) & 1023u))) - 8388608f) * _e163)), (_e840.member.member.y + ((bitcast<f32>((1258291200u | ((_e1749 >> bitcast<u32>(_e1693)) & 1023u))) - 8388608f) * _e163)), (_e840.member.member.z + ((bitcast<f32>((1258291200u | ((_e1749 >> bitcast<u32>(_e1703)) & 1023u))) - 8388608f) * _e163))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1491 = (_e1402 < _e107);
                                                            if _e1491 {
                                                                if _e1491 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1493 = global_10.member[_e1402];
                                                                phi_1832_ = _e1493;
                                                            } else {
                                                                phi_1832_ = 0u;
                                                            }
                                                            let _e1495 = phi_1832_;
                                                            let _e1496 = (_e1402 + 1u);
                                                            let _e1497 = (_e1496 < _e107);
                                                            if _e1497 {
                                                                if _e1497 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1499 = global_10.member[_e1496];
                                                                phi_1847_ = _e1499;
                                                            } else {
                                                                phi_1847_ = 0u;
                                                            }
                                                            let _e1501 = phi_1847_;
                                                            let _e1502 = (_e437 == 1u);
                                                            if _e1502 {
                                                                phi_1857_ = ((_e1495 >> bitcast<u32>(21i)) | (_e1501 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1857_ = (_e1501 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1511 = phi_1857_;
                                                            let _e1519 = (_e436 == 1u);
                                                            if _e1519 {
                                                                phi_1878_ = ((_e1495 >> bitcast<u32>(21i)) | (_e1501 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1878_ = (_e1501 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1528 = phi_1878_;
                                                            let _e1536 = (_e438 == 1u);
                                                            if _e1536 {
                                                                phi_1899_ = ((_e1495 >> bitcast<u32>(21i)) | (_e1501 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1899_ = (_e1501 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1545 = phi_1899_;
                                                            let _e1554 = (_e1402 + 2u);
                                                            let _e1555 = (_e1554 < _e107);
                                                            if _e1555 {
                                                                if _e1555 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1557 = global_10.member[_e1554];
                                                                phi_1929_ = _e1557;
                                                            } else {
                                                                phi_1929_ = 0u;
                                                            }
                                                            let _e1559 = phi_1929_;
                                                            let _e1560 = (_e1402 + 3u);
                                                            let _e1561 = (_e1560 < _e107);
                                                            if _e1561 {
                                                                if _e1561 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1563 = global_10.member[_e1560];
                                                                phi_1944_ = _e1563;
                                                            } else {
                                                                phi_1944_ = 0u;
                                                            }
                                                            let _e1565 = phi_1944_;
                                                            if _e1502 {
                                                                phi_1954_ = ((_e1559 >> bitcast<u32>(21i)) | (_e1565 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1954_ = (_e1565 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1574 = phi_1954_;
                                                            if _e1519 {
                                                                phi_1975_ = ((_e1559 >> bitcast<u32>(21i)) | (_e1565 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1975_ = (_e1565 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1590 = phi_1975_;
                                                            if _e1536 {
                                                                phi_1996_ = ((_e1559 >> bitcast<u32>(21i)) | (_e1565 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1996_ = (_e1565 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1606 = phi_1996_;
                                                            let _e1615 = (_e1402 + 4u);
                                                            let _e1616 = (_e1615 < _e107);
                                                            if _e1616 {
                                                                if _e1616 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1618 = global_10.member[_e1615];
                                                                phi_2026_ = _e1618;
                                                            } else {
                                                                phi_2026_ = 0u;
                                                            }
                                                            let _e1620 = phi_2026_;
                                                            let _e1621 = (_e1402 + 5u);
                                                            let _e1622 = (_e1621 < _e107);
                                                            if _e1622 {
                                                                if _e1622 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1624 = global_10.member[_e1621];
                                                                phi_2041_ = _e1624;
                                                            } else {
                                                                phi_2041_ = 0u;
                                                            }
                                                            let _e1626 = phi_2041_;
                                                            if _e1502 {
                                                                phi_2051_ = ((_e1620 >> bitcast<u32>(21i)) | (_e1626 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2051_ = (_e1626 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1635 = phi_2051_;
                                                            if _e1519 {
                                                                phi_2072_ = ((_e1620 >> bitcast<u32>(21i)) | (_e1626 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2072_ = (_e1626 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1651 = phi_2072_;
                                                            if _e1536 {
                                                                phi_2093_ = ((_e1620 >> bitcast<u32>(21i)) | (_e1626 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2093_ = (_e1626 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1667 = phi_2093_;
                                                            phi_2284_ = array<array<f32, 3>, 3>(array<f32, 3>((_e840.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1511, _e1495, _e461) & 2097151u))) - 8388608f) * _e163)), (_e840.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1528, _e1495, _e526) & 2097151u))) - 8388608f) * _e163)), (_e840.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1545, _e1495, _e590) & 2097151u))) - 8388608f) * _e163))), array<f32, 3>((_e840.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1574, _e1559, _e461) & 2097151u))) - 8388608f) * _e163)), (_e840.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1590, _e1559, _e526) & 2097151u))) - 8388608f) * _e163)), (_e840.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1606, _e1559, _e590) & 2097151u))) - 8388608f) * _e163))), array<f32, 3>((_e840.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1635, _e1620, _e461) & 2097151u))) - 8388608f) * _e163)), (_e840.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1651, _e1620, _e526) & 2097151u))) - 8388608f) * _e163)), (_e840.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1667, _e1620, _e590) & 2097151u))) - 8388608f) * _e163))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1404 = (_e1402 + _e437);
                                                            let _e1405 = (_e1404 < _e107);
                                                            if _e1405 {
                                                                if _e1405 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1407 = global_10.member[_e1404];
                                                                phi_2124_ = _e1407;
                                                            } else {
                                                                phi_2124_ = 0u;
                                                            }
                                                            let _e1409 = phi_2124_;
                                                            let _e1413 = (_e1402 + _e436);
                                                            let _e1414 = (_e1413 < _e107);
                                                            if _e1414 {
                                                                if _e1414 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1416 = global_10.member[_e1413];
                                                                phi_2142_ = _e1416;
                                                            } else {
                                                                phi_2142_ = 0u;
                                                            }
                                                            let _e1418 = phi_2142_;
                                                            let _e1422 = (_e1402 + _e438);
                                                            let _e1423 = (_e1422 < _e107);
                                                            if _e1423 {
                                                                if _e1423 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1425 = global_10.member[_e1422];
                                                                phi_2160_ = _e1425;
                                                            } else {
                                                                phi_2160_ = 0u;
                                                            }
                                                            let _e1427 = phi_2160_;
                                                            let _e1432 = (_e1402 + 3u);
                                                            let _e1433 = (_e1432 + _e437);
                                                            let _e1434 = (_e1433 < _e107);
                                                            if _e1434 {
                                                                if _e1434 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1436 = global_10.member[_e1433];
                                                                phi_2183_ = _e1436;
                                                            } else {
                                                                phi_2183_ = 0u;
                                                            }
                                                            let _e1438 = phi_2183_;
                                                            let _e1442 = (_e1432 + _e436);
                                                            let _e1443 = (_e1442 < _e107);
                                                            if _e1443 {
                                                                if _e1443 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1445 = global_10.member[_e1442];
                                                                phi_2201_ = _e1445;
                                                            } else {
                                                                phi_2201_ = 0u;
                                                            }
                                                            let _e1447 = phi_2201_;
                                                            let _e1451 = (_e1432 + _e438);
                                                            let _e1452 = (_e1451 < _e107);
                                                            if _e1452 {
                                                                if _e1452 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1454 = global_10.member[_e1451];
                                                                phi_2219_ = _e1454;
                                                            } else {
                                                                phi_2219_ = 0u;
                                                            }
                                                            let _e1456 = phi_2219_;
                                                            let _e1461 = (_e1402 + 6u);
                                                            let _e1462 = (_e1461 + _e437);
                                                            let _e1463 = (_e1462 < _e107);
                                                            if _e1463 {
                                                                if _e1463 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1465 = global_10.member[_e1462];
                                                                phi_2242_ = _e1465;
                                                            } else {
                                                                phi_2242_ = 0u;
                                                            }
                                                            let _e1467 = phi_2242_;
                                                            let _e1471 = (_e1461 + _e436);
                                                            let _e1472 = (_e1471 < _e107);
                                                            if _e1472 {
                                                                if _e1472 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1474 = global_10.member[_e1471];
                                                                phi_2260_ = _e1474;
                                                            } else {
                                                                phi_2260_ = 0u;
                                                            }
                                                            let _e1476 = phi_2260_;
                                                            let _e1480 = (_e1461 + _e438);
                                                            let _e1481 = (_e1480 < _e107);
                                                            if _e1481 {
                                                                if _e1481 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1483 = global_10.member[_e1480];
                                                                phi_2278_ = _e1483;
                                                            } else {
                                                                phi_2278_ = 0u;
                                                            }
                                                            let _e1485 = phi_2278_;
                                                            phi_2284_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1409)) * _e163), (f32(bitcast<i32>(_e1418)) * _e163), (f32(bitcast<i32>(_e1427)) * _e163)), array<f32, 3>((f32(bitcast<i32>(_e1438)) * _e163), (f32(bitcast<i32>(_e1447)) * _e163), (f32(bitcast<i32>(_e1456)) * _e163)), array<f32, 3>((f32(bitcast<i32>(_e1467)) * _e163), (f32(bitcast<i32>(_e1476)) * _e163), (f32(bitcast<i32>(_e1485)) * _e163)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2284_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1777 = phi_2284_;
                                                    let _e1793 = (_e1777[0][2] - _e613);
                                                    let _e1796 = (((_e1777[0][0] - _e484) * _e649) - (_e1793 * _e521));
                                                    let _e1799 = (((_e1777[0][1] - _e549) * _e649) - (_e1793 * _e585));
                                                    let _e1802 = (_e1777[1][2] - _e613);
                                                    let _e1805 = (((_e1777[1][0] - _e484) * _e649) - (_e1802 * _e521));
                                                    let _e1808 = (((_e1777[1][1] - _e549) * _e649) - (_e1802 * _e585));
                                                    let _e1811 = (_e1777[2][2] - _e613);
                                                    let _e1814 = (((_e1777[2][0] - _e484) * _e649) - (_e1811 * _e521));
                                                    let _e1817 = (((_e1777[2][1] - _e549) * _e649) - (_e1811 * _e585));
                                                    let _e1818 = (_e1814 * _e1808);
                                                    let _e1819 = (_e1817 * _e1805);
                                                    let _e1820 = (_e1796 * _e1817);
                                                    let _e1821 = (_e1799 * _e1814);
                                                    let _e1822 = (_e1805 * _e1799);
                                                    let _e1823 = (_e1808 * _e1796);
                                                    let _e1828 = (((_e1818 >= _e1819) && (_e1820 >= _e1821)) && (_e1822 >= _e1823));
                                                    let _e1834 = (_e1828 || (((_e1818 <= _e1819) && (_e1820 <= _e1821)) && (_e1822 <= _e1823)));
                                                    if _e1834 {
                                                        let _e1836 = select(-1f, 1f, _e1828);
                                                        let _e1838 = ((_e1818 - _e1819) * _e1836);
                                                        let _e1840 = select(0f, _e1838, (_e1838 > 0f));
                                                        let _e1842 = ((_e1820 - _e1821) * _e1836);
                                                        let _e1844 = select(0f, _e1842, (_e1842 > 0f));
                                                        let _e1846 = ((_e1822 - _e1823) * _e1836);
                                                        let _e1848 = select(0f, _e1846, (_e1846 > 0f));
                                                        let _e1850 = ((_e1840 + _e1844) + _e1848);
                                                        let _e1852 = select(_e1777[1][0], _e1777[0][0], (_e1777[0][0] < _e1777[1][0]));
                                                        let _e1856 = select(_e1777[1][0], _e1777[0][0], (_e1777[0][0] > _e1777[1][0]));
                                                        let _e1860 = select(_e1777[1][1], _e1777[0][1], (_e1777[0][1] < _e1777[1][1]));
                                                        let _e1864 = select(_e1777[1][1], _e1777[0][1], (_e1777[0][1] > _e1777[1][1]));
                                                        let _e1868 = select(_e1777[1][2], _e1777[0][2], (_e1777[0][2] < _e1777[1][2]));
                                                        let _e1872 = select(_e1777[1][2], _e1777[0][2], (_e1777[0][2] > _e1777[1][2]));
                                                        let _e1877 = ((select(_e1777[2][0], _e1852, (_e1852 < _e1777[2][0])) - _e522) * _e525);
                                                        let _e1878 = ((select(_e1777[2][0], _e1856, (_e1856 > _e1777[2][0])) - _e523) * _e525);
                                                        let _e1881 = ((select(_e1777[2][1], _e1860, (_e1860 < _e1777[2][1])) - _e586) * _e589);
                                                        let _e1882 = ((select(_e1777[2][1], _e1864, (_e1864 > _e1777[2][1])) - _e587) * _e589);
                                                        let _e1885 = ((select(_e1777[2][2], _e1868, (_e1868 < _e1777[2][2])) - _e650) * _e653);
                                                        let _e1886 = ((select(_e1777[2][2], _e1872, (_e1872 > _e1777[2][2])) - _e651) * _e653);
                                                        let _e1888 = select(_e1886, _e1885, (_e1885 < _e1886));
                                                        let _e1890 = select(_e1886, _e1885, (_e1885 > _e1886));
                                                        let _e1892 = select(_e1878, _e1877, (_e1877 < _e1878));
                                                        let _e1894 = select(_e1882, _e1881, (_e1881 < _e1882));
                                                        let _e1896 = select(_e1894, _e1892, (_e1892 > _e1894));
                                                        let _e1898 = select(_e1888, _e1896, (_e1896 > _e1888));
                                                        let _e1900 = select(_e1878, _e1877, (_e1877 > _e1878));
                                                        let _e1902 = select(_e1882, _e1881, (_e1881 > _e1882));
                                                        let _e1904 = select(_e1902, _e1900, (_e1900 < _e1902));
                                                        let _e1906 = select(_e1890, _e1904, (_e1904 < _e1890));
                                                        let _e1907 = -(_e1888);
                                                        let _e1913 = select(_e755, _e1898, (_e1898 > _e755));
                                                        let _e1917 = select(_e1805, _e1796, (_e1796 < _e1805));
                                                        let _e1922 = select(_e1805, _e1796, (_e1796 > _e1805));
                                                        let _e1929 = select(_e1808, _e1799, (_e1799 < _e1808));
                                                        let _e1934 = select(_e1808, _e1799, (_e1799 > _e1808));
                                                        let _e1943 = (((((_e1834 && (_e1850 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1814, _e1917, (_e1917 < _e1814)) <= 0f) && (select(_e1814, _e1922, (_e1922 > _e1814)) >= 0f))) && ((select(_e1817, _e1929, (_e1929 < _e1817)) <= 0f) && (select(_e1817, _e1934, (_e1934 > _e1817)) >= 0f))) && (_e1913 <= (_e1906 + (select(_e1907, _e1890, (_e1890 > _e1907)) * 0.0000019073523f)))) && (_e1913 <= _e1330.member));
                                                        if _e1943 {
                                                            let _e1948 = (_e1777[1][0] - _e1777[0][0]);
                                                            let _e1949 = (_e1777[1][1] - _e1777[0][1]);
                                                            let _e1950 = (_e1777[1][2] - _e1777[0][2]);
                                                            let _e1951 = vec3<f32>(_e1948, _e1949, _e1950);
                                                            let _e1952 = (_e1777[2][0] - _e1777[1][0]);
                                                            let _e1953 = (_e1777[2][1] - _e1777[1][1]);
                                                            let _e1954 = (_e1777[2][2] - _e1777[1][2]);
                                                            let _e1955 = vec3<f32>(_e1952, _e1953, _e1954);
                                                            let _e1956 = (_e1777[0][0] - _e1777[2][0]);
                                                            let _e1957 = (_e1777[0][1] - _e1777[2][1]);
                                                            let _e1958 = (_e1777[0][2] - _e1777[2][2]);
                                                            let _e1959 = vec3<f32>(_e1956, _e1957, _e1958);
                                                            let _e1962 = bitcast<f32>((bitcast<u32>(_e1948) & 2147483647u));
                                                            let _e1965 = bitcast<f32>((bitcast<u32>(_e1949) & 2147483647u));
                                                            let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                            let _e1970 = bitcast<f32>((bitcast<u32>(_e1950) & 2147483647u));
                                                            let _e1972 = select(_e1970, _e1967, (_e1967 > _e1970));
                                                            let _e1975 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
                                                            let _e1978 = bitcast<f32>((bitcast<u32>(_e1953) & 2147483647u));
                                                            let _e1980 = select(_e1978, _e1975, (_e1975 > _e1978));
                                                            let _e1983 = bitcast<f32>((bitcast<u32>(_e1954) & 2147483647u));
                                                            let _e1985 = select(_e1983, _e1980, (_e1980 > _e1983));
                                                            let _e1988 = bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u));
                                                            let _e1991 = bitcast<f32>((bitcast<u32>(_e1957) & 2147483647u));
                                                            let _e1993 = select(_e1991, _e1988, (_e1988 > _e1991));
                                                            let _e1996 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                            let _e1998 = select(_e1996, _e1993, (_e1993 > _e1996));
                                                            let _e2000 = select(_e1985, _e1972, (_e1972 > _e1985));
                                                            let _e2002 = select(_e1998, _e2000, (_e2000 > _e1998));
                                                            if (_e1972 == _e2002) {
                                                                phi_2814_ = _e1808;
                                                                phi_2815_ = _e1805;
                                                                phi_2816_ = _e1799;
                                                                phi_2817_ = _e1796;
                                                                phi_2818_ = vec3<f32>(_e1777[0][0], _e1777[0][1], _e1777[0][2]);
                                                                phi_2819_ = _e1959;
                                                                phi_2820_ = _e1955;
                                                                phi_2821_ = _e1951;
                                                            } else {
                                                                let _e2004 = (_e1985 == _e2002);
                                                                let _e2009 = vec3(_e2004);
                                                                phi_2814_ = select(_e1799, _e1817, _e2004);
                                                                phi_2815_ = select(_e1796, _e1814, _e2004);
                                                                phi_2816_ = select(_e1817, _e1808, _e2004);
                                                                phi_2817_ = select(_e1814, _e1805, _e2004);
                                                                phi_2818_ = select(vec3<f32>(_e1777[2][0], _e1777[2][1], _e1777[2][2]), vec3<f32>(_e1777[1][0], _e1777[1][1], _e1777[1][2]), _e2009);
                                                                phi_2819_ = select(_e1955, _e1951, _e2009);
                                                                phi_2820_ = select(_e1951, _e1959, _e2009);
                                                                phi_2821_ = select(_e1959, _e1955, _e2009);
                                                            }
                                                            let _e2015 = phi_2814_;
                                                            let _e2017 = phi_2815_;
                                                            let _e2019 = phi_2816_;
                                                            let _e2021 = phi_2817_;
                                                            let _e2023 = phi_2818_;
                                                            let _e2025 = phi_2819_;
                                                            let _e2027 = phi_2820_;
                                                            let _e2029 = phi_2821_;
                                                            let _e2036 = ((_e2027.y * _e2025.z) - (_e2025.y * _e2027.z));
                                                            let _e2041 = ((_e2027.z * _e2025.x) - (_e2025.z * _e2027.x));
                                                            let _e2044 = ((_e2027.x * _e2025.y) - (_e2025.x * _e2027.y));
                                                            let _e2047 = ((_e1840 >= _e1844) && (_e1840 >= _e1848));
                                                            let _e2048 = (_e1844 >= _e1848);
                                                            let _e2062 = (((_e2036 * (select(select(_e1777[2][0], _e1777[1][0], _e2048), _e1777[0][0], _e2047) - _e484)) + (_e2041 * (select(select(_e1777[2][1], _e1777[1][1], _e2048), _e1777[0][1], _e2047) - _e549))) + (_e2044 * (select(select(_e1777[2][2], _e1777[1][2], _e2048), _e1777[0][2], _e2047) - _e613)));
                                                            let _e2067 = (((_e2036 * _e521) + (_e2041 * _e585)) + (_e2044 * _e649));
                                                            let _e2068 = (_e2017 - _e2021);
                                                            let _e2069 = (_e2015 - _e2019);
                                                            let _e2072 = ((_e2068 * _e2068) + (_e2069 * _e2069));
                                                            let _e2079 = (-(((_e2021 * _e2068) + (_e2019 * _e2069))) / select(0.000000000000000000000000000000000000011754944f, _e2072, (_e2072 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e2081 = select(1f, _e2079, (_e2079 < 1f));
                                                            let _e2083 = select(0f, _e2081, (_e2081 > 0f));
                                                            let _e2092 = ((_e2023.x + (_e2029.x * _e2083)) - _e484);
                                                            let _e2095 = ((_e2023.y + (_e2029.y * _e2083)) - _e549);
                                                            let _e2098 = ((_e2023.z + (_e2029.z * _e2083)) - _e613);
                                                            let _e2101 = bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u));
                                                            let _e2104 = bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u));
                                                            let _e2106 = select(_e2104, _e2101, (_e2101 > _e2104));
                                                            let _e2109 = bitcast<f32>((bitcast<u32>(_e2098) & 2147483647u));
                                                            let _e2111 = select(_e2109, _e2106, (_e2106 > _e2109));
                                                            let _e2117 = bitcast<f32>((bitcast<u32>(_e2036) & 2147483647u));
                                                            let _e2120 = bitcast<f32>((bitcast<u32>(_e2041) & 2147483647u));
                                                            let _e2122 = select(_e2120, _e2117, (_e2117 > _e2120));
                                                            let _e2125 = bitcast<f32>((bitcast<u32>(_e2044) & 2147483647u));
                                                            let _e2144 = bitcast<f32>((bitcast<u32>(_e2027.x) & 2147483647u));
                                                            let _e2147 = bitcast<f32>((bitcast<u32>(_e2027.y) & 2147483647u));
                                                            let _e2149 = select(_e2147, _e2144, (_e2144 > _e2147));
                                                            let _e2152 = bitcast<f32>((bitcast<u32>(_e2027.z) & 2147483647u));
                                                            let _e2158 = bitcast<f32>((bitcast<u32>(_e2025.x) & 2147483647u));
                                                            let _e2161 = bitcast<f32>((bitcast<u32>(_e2025.y) & 2147483647u));
                                                            let _e2163 = select(_e2161, _e2158, (_e2158 > _e2161));
                                                            let _e2166 = bitcast<f32>((bitcast<u32>(_e2025.z) & 2147483647u));
                                                            let _e2172 = ((bitcast<f32>((bitcast<u32>(((((_e2036 * _e2092) + (_e2041 * _e2095)) + (_e2044 * _e2098)) - _e2062)) & 2147483647u)) <= ((0.0000009536743f * select(_e2002, _e2111, (_e2111 > _e2002))) * select(_e2125, _e2122, (_e2122 > _e2125)))) && !((bitcast<f32>((bitcast<u32>(_e2067) & 2147483647u)) <= ((0.0000038146973f * select(_e2152, _e2149, (_e2149 > _e2152))) * select(_e2166, _e2163, (_e2163 > _e2166))))));
                                                            let _e2173 = (_e2062 / _e2067);
                                                            if (_e1943 && !(_e2172)) {
                                                                let _e2176 = (_e2098 / _e649);
                                                                let _e2184 = (((_e2036 * (_e2092 - (_e521 * _e2176))) + (_e2041 * (_e2095 - (_e585 * _e2176)))) / _e2067);
                                                                phi_3012_ = select(select(_e2176, (_e2176 + _e2184), (bitcast<f32>((bitcast<u32>(_e2184) & 2147483647u)) <= _e2002)), _e2173, _e2172);
                                                            } else {
                                                                phi_3012_ = _e2173;
                                                            }
                                                            let _e2193 = phi_3012_;
                                                            let _e2195 = select(_e1906, _e2193, (_e2193 < _e1906));
                                                            let _e2197 = select(_e1898, _e2195, (_e2195 > _e1898));
                                                            let _e2198 = (1f / _e1850);
                                                            phi_3032_ = type_42(_e2197, (_e1844 * _e2198), (_e1848 * _e2198), ((_e1943 && (_e2197 >= _e755)) && (_e2197 <= _e1330.member)));
                                                            phi_3033_ = type_42();
                                                        } else {
                                                            phi_3032_ = type_42();
                                                            phi_3033_ = type_42(0f, 0f, 0f, _e1943);
                                                        }
                                                        let _e2207 = phi_3032_;
                                                        let _e2209 = phi_3033_;
                                                        phi_3036_ = _e2207;
                                                        phi_3037_ = _e2209;
                                                        phi_3038_ = select(true, false, _e1943);
                                                    } else {
                                                        phi_3036_ = type_42();
                                                        phi_3037_ = type_42(0f, 0f, 0f, _e1834);
                                                        phi_3038_ = true;
                                                    }
                                                    let _e2212 = phi_3036_;
                                                    let _e2214 = phi_3037_;
                                                    let _e2216 = phi_3038_;
                                                    if _e2216 {
                                                        phi_3042_ = _e2214;
                                                    } else {
                                                        phi_3042_ = _e2212;
                                                    }
                                                    let _e2218 = phi_3042_;
                                                    if _e2218.member_3 {
                                                        phi_3051_ = type_21(_e2218.member, _e2218.member_1, _e2218.member_2, _e1390);
                                                    } else {
                                                        phi_3051_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e2225 = phi_3051_;
                                                    if (_e2225.member_3 != 4294967295u) {
                                                        if (_e1390 == _e172) {
                                                            phi_3386_ = false;
                                                        } else {
                                                            let _e2229 = (_e1390 < arrayLength((&global_5.member)));
                                                            if _e2229 {
                                                                if _e2229 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e2231 = global_5.member[_e1390];
                                                                phi_3074_ = _e2231;
                                                            } else {
                                                                phi_3074_ = 4294967295u;
                                                            }
                                                            let _e2233 = phi_3074_;
                                                            let _e2234 = (_e2233 < arrayLength((&global_6.member)));
                                                            if _e2234 {
                                                                if _e2234 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e2236 = global_6.member[_e2233];
                                                                phi_3088_ = _e2236;
                                                            } else {
                                                                phi_3088_ = 0i;
                                                            }
                                                            let _e2238 = phi_3088_;
                                                            let _e2239 = (_e2238 == 0i);
                                                            if _e2239 {
                                                                phi_3385_ = true;
                                                            } else {
                                                                if _e461 {
                                                                    phi_3111_ = vec3<f32>(_e1777[0][0], _e1777[0][1], _e1777[0][2]);
                                                                } else {
                                                                    if (_e437 == 1u) {
                                                                        phi_3110_ = vec3<f32>(_e1777[0][2], _e1777[0][0], _e1777[0][1]);
                                                                    } else {
                                                                        phi_3110_ = vec3<f32>(_e1777[0][1], _e1777[0][2], _e1777[0][0]);
                                                                    }
                                                                    let _e2244 = phi_3110_;
                                                                    phi_3111_ = _e2244;
                                                                }
                                                                let _e2247 = phi_3111_;
                                                                if _e461 {
                                                                    phi_3130_ = vec3<f32>(_e1777[1][0], _e1777[1][1], _e1777[1][2]);
                                                                } else {
                                                                    if (_e437 == 1u) {
                                                                        phi_3129_ = vec3<f32>(_e1777[1][2], _e1777[1][0], _e1777[1][1]);
                                                                    } else {
                                                                        phi_3129_ = vec3<f32>(_e1777[1][1], _e1777[1][2], _e1777[1][0]);
                                                                    }
                                                                    let _e2252 = phi_3129_;
                                                                    phi_3130_ = _e2252;
                                                                }
                                                                let _e2255 = phi_3130_;
                                                                if _e461 {
                                                                    phi_3149_ = vec3<f32>(_e1777[2][0], _e1777[2][1], _e1777[2][2]);
                                                                } else {
                                                                    if (_e437 == 1u) {
                                                                        phi_3148_ = vec3<f32>(_e1777[2][2], _e1777[2][0], _e1777[2][1]);
                                                                    } else {
                                                                        phi_3148_ = vec3<f32>(_e1777[2][1], _e1777[2][2], _e1777[2][0]);
                                                                    }
                                                                    let _e2260 = phi_3148_;
                                                                    phi_3149_ = _e2260;
                                                                }
                                                                let _e2263 = phi_3149_;
                                                                let _e2266 = (_e2255.x - _e2247.x);
                                                                let _e2269 = (_e2255.y - _e2247.y);
                                                                let _e2272 = (_e2255.z - _e2247.z);
                                                                let _e2274 = (_e2263.x - _e2247.x);
                                                                let _e2276 = (_e2263.y - _e2247.y);
                                                                let _e2278 = (_e2263.z - _e2247.z);
                                                                if (_e304.member_1 == 1u) {
                                                                    phi_3185_ = (vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]) - _e2247);
                                                                } else {
                                                                    phi_3185_ = vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]);
                                                                }
                                                                let _e2293 = phi_3185_;
                                                                let _e2299 = bitcast<f32>((bitcast<u32>((_e2266 * _e2276)) ^ _e304.member_3[0]));
                                                                let _e2303 = bitcast<f32>((bitcast<u32>((_e2269 * _e2274)) ^ _e304.member_3[0]));
                                                                let _e2307 = bitcast<f32>((bitcast<u32>((_e2269 * _e2278)) ^ _e304.member_3[0]));
                                                                let _e2311 = bitcast<f32>((bitcast<u32>((_e2272 * _e2276)) ^ _e304.member_3[0]));
                                                                let _e2315 = bitcast<f32>((bitcast<u32>((_e2272 * _e2274)) ^ _e304.member_3[0]));
                                                                let _e2319 = bitcast<f32>((bitcast<u32>((_e2266 * _e2278)) ^ _e304.member_3[0]));
                                                                let _e2320 = (_e2307 - _e2311);
                                                                let _e2321 = (_e2315 - _e2319);
                                                                let _e2322 = (_e2299 - _e2303);
                                                                let _e2346 = (bitcast<f32>((bitcast<u32>(_e2307) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2311) & 2147483647u)));
                                                                let _e2353 = (bitcast<f32>((bitcast<u32>(_e2315) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2319) & 2147483647u)));
                                                                let _e2360 = (bitcast<f32>((bitcast<u32>(_e2299) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2303) & 2147483647u)));
                                                                if (_e304.member_2 == 0f) {
                                                                    phi_3367_ = 0f;
                                                                } else {
                                                                    let _e2390 = bitcast<f32>((bitcast<u32>(_e2320) & 2147483647u));
                                                                    let _e2393 = bitcast<f32>((bitcast<u32>(_e2321) & 2147483647u));
                                                                    let _e2396 = bitcast<f32>((bitcast<u32>(_e2322) & 2147483647u));
                                                                    let _e2398 = select(_e2396, _e2393, (_e2393 > _e2396));
                                                                    let _e2402 = select(_e2396, _e2393, (_e2393 < _e2396));
                                                                    let _e2406 = select(_e2393, _e2390, (_e2390 < _e2393));
                                                                    let _e2408 = select(_e2393, _e2390, (_e2390 > _e2393));
                                                                    let _e2410 = select(_e2396, _e2408, (_e2408 < _e2396));
                                                                    phi_3367_ = bitcast<f32>((bitcast<u32>((_e304.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2398, _e2390, (_e2390 > _e2398)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2410, _e2406, (_e2406 > _e2410)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2402, _e2390, (_e2390 < _e2402)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2346 + _e2353) + _e2360))) ^ _e304.member_3[0]))) * 1.0000005f)) ^ _e304.member_3[0])))) ^ _e304.member_3[0]));
                                                                }
                                                                let _e2437 = phi_3367_;
                                                                phi_3385_ = (_e2239 || !(((((bitcast<f32>((bitcast<u32>((_e2293.x * _e2320)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2293.y * _e2321)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2293.z * _e2322)) ^ _e304.member_3[0]))) * f32(-(_e2238))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2293.x) & 2147483647u)) * _e2346)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2293.y) & 2147483647u)) * _e2353)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2293.z) & 2147483647u)) * _e2360)) ^ _e304.member_3[0]))))) ^ _e304.member_3[0])) + _e2437) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2451 = phi_3385_;
                                                            phi_3386_ = _e2451;
                                                        }
                                                        let _e2453 = phi_3386_;
                                                        if _e2453 {
                                                            phi_3391_ = type_43(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_3391_ = _e1330;
                                                        }
                                                        let _e2455 = phi_3391_;
                                                        phi_3392_ = _e2455;
                                                    } else {
                                                        phi_3392_ = _e1330;
                                                    }
                                                    let _e2457 = phi_3392_;
                                                    phi_1521_ = _e2457;
                                                } else {
                                                    phi_1521_ = type_43();
                                                }
                                                let _e2459 = phi_1521_;
                                                continue;
                                                continuing {
                                                    phi_1520_ = _e2459;
                                                    phi_1523_ = _e1345;
                                                    phi_5064_ = _e797;
                                                    break if !(_e1351);
                                                }
                                            }
                                            let _e2462 = phi_5064_;
                                            phi_5296_ = _e2462;
                                            if _e2462 {
                                                break;
                                            }
                                            let _e2464 = local_10;
                                            phi_5300_ = _e2462;
                                            let _e2686 = local_12;
                                            phi_4654_ = _e2686;
                                            phi_4655_ = false;
                                            phi_4656_ = _e840;
                                            phi_4657_ = select(_e842, 0u, (_e755 > _e2464.member));
                                        } else {
                                            if (_e840.member_1 >= _e104) {
                                                phi_4193_ = type_60(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e840.member_1 < _e104) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e854 = (_e437 * 2u);
                                                let _e856 = ((1u + _e854) % 7u);
                                                if (_e856 < 7u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e861 = global_8.member[_e840.member_1][_e856];
                                                let _e863 = ((_e854 + 2u) % 7u);
                                                if (_e863 < 7u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e868 = global_8.member[_e840.member_1][_e863];
                                                let _e869 = (_e436 * 2u);
                                                let _e871 = ((1u + _e869) % 7u);
                                                if (_e871 < 7u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e876 = global_8.member[_e840.member_1][_e871];
                                                let _e878 = ((_e869 + 2u) % 7u);
                                                if (_e878 < 7u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e883 = global_8.member[_e840.member_1][_e878];
                                                let _e884 = (_e438 * 2u);
                                                let _e886 = ((1u + _e884) % 7u);
                                                if (_e886 < 7u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e891 = global_8.member[_e840.member_1][_e886];
                                                let _e893 = ((_e884 + 2u) % 7u);
                                                if (_e893 < 7u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e898 = global_8.member[_e840.member_1][_e893];
                                                let _e921 = (bitcast<f32>((bitcast<u32>((_e840.member.member_1.x - _e840.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e922 = (bitcast<f32>((bitcast<u32>((_e840.member.member_1.y - _e840.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e923 = (bitcast<f32>((bitcast<u32>((_e840.member.member_1.z - _e840.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e925 = select(_e163, _e921, (_e921 > _e163));
                                                let _e927 = select(_e163, _e922, (_e922 > _e163));
                                                let _e929 = select(_e163, _e923, (_e923 > _e163));
                                                let _e960 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e861 & 2097151u))) - 8388608f) * _e925));
                                                let _e965 = (bitcast<i32>((_e861 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e968 = bitcast<f32>((_e960 & bitcast<u32>(_e965)));
                                                let _e969 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e876 & 2097151u))) - 8388608f) * _e927));
                                                let _e974 = (bitcast<i32>((_e876 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e977 = bitcast<f32>((_e969 & bitcast<u32>(_e974)));
                                                let _e978 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e891 & 2097151u))) - 8388608f) * _e929));
                                                let _e983 = (bitcast<i32>((_e891 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e986 = bitcast<f32>((_e978 & bitcast<u32>(_e983)));
                                                let _e990 = bitcast<f32>((_e960 & bitcast<u32>(~(_e965))));
                                                let _e994 = bitcast<f32>((_e969 & bitcast<u32>(~(_e974))));
                                                let _e998 = bitcast<f32>((_e978 & bitcast<u32>(~(_e983))));
                                                let _e999 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e868 & 2097151u))) - 8388608f) * _e925));
                                                let _e1004 = (bitcast<i32>((_e868 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1007 = bitcast<f32>((_e999 & bitcast<u32>(_e1004)));
                                                let _e1008 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e883 & 2097151u))) - 8388608f) * _e927));
                                                let _e1013 = (bitcast<i32>((_e883 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1016 = bitcast<f32>((_e1008 & bitcast<u32>(_e1013)));
                                                let _e1017 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e898 & 2097151u))) - 8388608f) * _e929));
                                                let _e1022 = (bitcast<i32>((_e898 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1025 = bitcast<f32>((_e1017 & bitcast<u32>(_e1022)));
                                                let _e1029 = bitcast<f32>((_e999 & bitcast<u32>(~(_e1004))));
                                                let _e1033 = bitcast<f32>((_e1008 & bitcast<u32>(~(_e1013))));
                                                let _e1037 = bitcast<f32>((_e1017 & bitcast<u32>(~(_e1022))));
                                                let _e1038 = (_e840.member.member.x + _e968);
                                                let _e1039 = (_e840.member.member.y + _e977);
                                                let _e1040 = (_e840.member.member.z + _e986);
                                                let _e1043 = (_e840.member.member_1.x - _e1007);
                                                let _e1044 = (_e840.member.member_1.y - _e1016);
                                                let _e1045 = (_e840.member.member_1.z - _e1025);
                                                let _e1064 = (_e1043 - _e1038);
                                                let _e1065 = (_e1044 - _e1039);
                                                let _e1066 = (_e1045 - _e1040);
                                                let _e1068 = select(_e1065, _e1064, (_e1064 > _e1065));
                                                let _e1070 = select(_e1066, _e1068, (_e1068 > _e1066));
                                                if (_e1070 < (1024f * _e163)) {
                                                    phi_3894_ = 0u;
                                                } else {
                                                    phi_3894_ = select(2u, 1u, (_e1070 < (2097152f * _e163)));
                                                }
                                                let _e1077 = phi_3894_;
                                                switch bitcast<i32>(_e1077) {
                                                    case 0: {
                                                        phi_3900_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3900_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3900_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3900_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1080 = phi_3900_;
                                                let _e1086 = global_8.member[_e840.member_1][0u];
                                                let _e1090 = global_8.member[_e840.member_1][2u];
                                                let _e1094 = global_8.member[_e840.member_1][4u];
                                                let _e1098 = global_8.member[_e840.member_1][6u];
                                                let _e1110 = (((_e1090 >> bitcast<u32>(22i)) | ((_e1094 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1098 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1111 = (_e1086 & 268435455u);
                                                let _e1112 = (_e1110 & 268435455u);
                                                let _e1115 = ((_e1086 >> bitcast<u32>(28u)) & 7u);
                                                let _e1123 = ((_e1086 >> bitcast<u32>(31i)) | (((_e1110 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1124 = (_e1115 != 0u);
                                                if (_e1115 == 0u) {
                                                    phi_4155_ = _e1111;
                                                } else {
                                                    if (_e1115 == 7u) {
                                                        phi_4154_ = 2147483648u;
                                                    } else {
                                                        phi_4154_ = ((2147483648u | (_e1115 << bitcast<u32>(28u))) | (_e1112 & 268435455u));
                                                    }
                                                    let _e1133 = phi_4154_;
                                                    phi_4155_ = _e1133;
                                                }
                                                let _e1135 = phi_4155_;
                                                if _e1124 {
                                                    let _e1136 = (_e1115 != 7u);
                                                    if _e1136 {
                                                        phi_4165_ = (_e1112 + (_e1115 * ((3u * _e1080) + 1u)));
                                                    } else {
                                                        phi_4165_ = u32();
                                                    }
                                                    let _e1140 = phi_4165_;
                                                    phi_4167_ = _e1140;
                                                    phi_4168_ = select(true, false, _e1136);
                                                } else {
                                                    phi_4167_ = u32();
                                                    phi_4168_ = true;
                                                }
                                                let _e1143 = phi_4167_;
                                                let _e1145 = phi_4168_;
                                                if (_e1123 == 0u) {
                                                    phi_4189_ = (_e1111 + select(0u, 1u, !(_e1124)));
                                                } else {
                                                    if (_e1123 == 7u) {
                                                        phi_4188_ = 2147483648u;
                                                    } else {
                                                        phi_4188_ = ((2147483648u | (_e1123 << bitcast<u32>(28u))) | (select(_e1143, _e1112, _e1145) & 268435455u));
                                                    }
                                                    let _e1158 = phi_4188_;
                                                    phi_4189_ = _e1158;
                                                }
                                                let _e1160 = phi_4189_;
                                                phi_4193_ = type_60(array<vec4<f32>, 3>(vec4<f32>(_e1038, (_e840.member.member.x + _e990), _e1043, (_e840.member.member_1.x - _e1029)), vec4<f32>(_e1039, (_e840.member.member.y + _e994), _e1044, (_e840.member.member_1.y - _e1033)), vec4<f32>(_e1040, (_e840.member.member.z + _e998), _e1045, (_e840.member.member_1.z - _e1037))), type_59(type_30((_e840.member.member + vec4<f32>(_e968, _e977, _e986, 0f)), (_e840.member.member_1 - vec4<f32>(_e1007, _e1016, _e1025, 0f))), _e1135), type_59(type_30((_e840.member.member + vec4<f32>(_e990, _e994, _e998, 0f)), (_e840.member.member_1 - vec4<f32>(_e1029, _e1033, _e1037, 0f))), _e1160));
                                            }
                                            let _e1165 = phi_4193_;
                                            let _e1177 = ((_e1165.member[0].x - _e522) * _e525);
                                            let _e1178 = ((_e1165.member[0].y - _e522) * _e525);
                                            let _e1179 = ((_e1165.member[0].z - _e523) * _e525);
                                            let _e1180 = ((_e1165.member[0].w - _e523) * _e525);
                                            let _e1190 = ((_e1165.member[1].x - _e586) * _e589);
                                            let _e1191 = ((_e1165.member[1].y - _e586) * _e589);
                                            let _e1192 = ((_e1165.member[1].z - _e587) * _e589);
                                            let _e1193 = ((_e1165.member[1].w - _e587) * _e589);
                                            let _e1203 = ((_e1165.member[2].x - _e650) * _e653);
                                            let _e1204 = ((_e1165.member[2].y - _e650) * _e653);
                                            let _e1205 = ((_e1165.member[2].z - _e651) * _e653);
                                            let _e1206 = ((_e1165.member[2].w - _e651) * _e653);
                                            let _e1208 = select(_e1205, _e1203, (_e1203 < _e1205));
                                            let _e1210 = select(_e1206, _e1204, (_e1204 < _e1206));
                                            let _e1212 = select(_e1205, _e1203, (_e1203 > _e1205));
                                            let _e1214 = select(_e1206, _e1204, (_e1204 > _e1206));
                                            let _e1216 = select(_e1179, _e1177, (_e1177 < _e1179));
                                            let _e1218 = select(_e1180, _e1178, (_e1178 < _e1180));
                                            let _e1220 = select(_e1192, _e1190, (_e1190 < _e1192));
                                            let _e1222 = select(_e1193, _e1191, (_e1191 < _e1193));
                                            let _e1224 = select(_e1220, _e1216, (_e1216 > _e1220));
                                            let _e1226 = select(_e1222, _e1218, (_e1218 > _e1222));
                                            let _e1228 = select(_e1208, _e1224, (_e1224 > _e1208));
                                            let _e1230 = select(_e1210, _e1226, (_e1226 > _e1210));
                                            let _e1232 = select(_e1179, _e1177, (_e1177 > _e1179));
                                            let _e1234 = select(_e1180, _e1178, (_e1178 > _e1180));
                                            let _e1236 = select(_e1192, _e1190, (_e1190 > _e1192));
                                            let _e1238 = select(_e1193, _e1191, (_e1191 > _e1193));
                                            let _e1240 = select(_e1236, _e1232, (_e1232 < _e1236));
                                            let _e1242 = select(_e1238, _e1234, (_e1234 < _e1238));
                                            let _e1247 = -(_e1208);
                                            let _e1248 = -(_e1210);
                                            let _e1255 = (select(_e1212, _e1240, (_e1240 < _e1212)) + (select(_e1247, _e1212, (_e1212 > _e1247)) * 0.0000019073523f));
                                            let _e1256 = (select(_e1214, _e1242, (_e1242 < _e1214)) + (select(_e1248, _e1214, (_e1214 > _e1248)) * 0.0000019073523f));
                                            let _e1258 = select(_e755, _e1228, (_e1228 > _e755));
                                            let _e1260 = select(_e755, _e1230, (_e1230 > _e755));
                                            let _e1265 = (_e1258 <= select(_e799.member, _e1255, (_e1255 < _e799.member)));
                                            let _e1266 = (_e1260 <= select(_e799.member, _e1256, (_e1256 < _e799.member)));
                                            let _e1267 = (_e1258 <= _e1260);
                                            if _e1265 {
                                                if _e1266 {
                                                    if _e1267 {
                                                        phi_4555_ = _e1165.member_2;
                                                    } else {
                                                        phi_4555_ = _e1165.member_1;
                                                    }
                                                    let _e1271 = phi_4555_;
                                                    let _e1292 = (_e842 % 128u);
                                                    let _e1293 = (_e1292 < 128u);
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1292] = _e1271.member_1;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1292] = _e1271.member.member.x;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1292] = _e1271.member.member.y;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1292] = _e1271.member.member.z;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1292] = _e1271.member.member_1.x;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1292] = _e1271.member.member_1.y;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1292] = _e1271.member.member_1.z;
                                                    if _e1293 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1292] = select(_e1258, _e1260, _e1267);
                                                    if _e1267 {
                                                        phi_4631_ = _e1165.member_1;
                                                    } else {
                                                        phi_4631_ = _e1165.member_2;
                                                    }
                                                    let _e1306 = phi_4631_;
                                                    phi_4632_ = _e1306;
                                                    phi_4633_ = (_e842 + 1u);
                                                } else {
                                                    phi_4632_ = type_59();
                                                    phi_4633_ = u32();
                                                }
                                                let _e1308 = phi_4632_;
                                                let _e1310 = phi_4633_;
                                                phi_4635_ = _e1308;
                                                phi_4636_ = _e1310;
                                                phi_4637_ = select(true, false, _e1266);
                                            } else {
                                                phi_4635_ = type_59();
                                                phi_4636_ = u32();
                                                phi_4637_ = true;
                                            }
                                            let _e1313 = phi_4635_;
                                            let _e1315 = phi_4636_;
                                            let _e1317 = phi_4637_;
                                            if _e1317 {
                                                if _e1265 {
                                                    phi_4646_ = _e1165.member_1;
                                                } else {
                                                    phi_4646_ = _e1165.member_2;
                                                }
                                                let _e1321 = phi_4646_;
                                                phi_4651_ = select(_e1266, true, _e1265);
                                                phi_4652_ = _e1321;
                                            } else {
                                                phi_4651_ = _e838;
                                                phi_4652_ = _e1313;
                                            }
                                            let _e1324 = phi_4651_;
                                            let _e1326 = phi_4652_;
                                            phi_5300_ = _e797;
                                            phi_4654_ = _e799;
                                            phi_4655_ = _e1324;
                                            phi_4656_ = _e1326;
                                            phi_4657_ = select(_e1315, _e842, _e1317);
                                        }
                                        let _e2469 = phi_5300_;
                                        let _e2471 = phi_4654_;
                                        let _e2473 = phi_4655_;
                                        let _e2475 = phi_4656_;
                                        let _e2477 = phi_4657_;
                                        phi_5299_ = _e2469;
                                        phi_4658_ = _e2471;
                                        phi_4659_ = _e2473;
                                        phi_4660_ = _e2475;
                                        phi_4661_ = _e2477;
                                        phi_4662_ = (_e807 - 1u);
                                    } else {
                                        phi_5299_ = _e797;
                                        phi_4658_ = _e799;
                                        phi_4659_ = _e838;
                                        phi_4660_ = _e840;
                                        phi_4661_ = _e842;
                                        phi_4662_ = _e807;
                                    }
                                    let _e2479 = phi_5299_;
                                    let _e2481 = phi_4658_;
                                    let _e2483 = phi_4659_;
                                    let _e2485 = phi_4660_;
                                    let _e2487 = phi_4661_;
                                    let _e2489 = phi_4662_;
                                    phi_5298_ = _e2479;
                                    phi_4663_ = _e2481;
                                    phi_4664_ = _e2483;
                                    phi_4665_ = _e2485;
                                    phi_4666_ = _e2487;
                                    phi_4667_ = _e2489;
                                } else {
                                    phi_5298_ = _e797;
                                    phi_4663_ = type_43();
                                    phi_4664_ = bool();
                                    phi_4665_ = type_59();
                                    phi_4666_ = u32();
                                    phi_4667_ = u32();
                                }
                                let _e2491 = phi_5298_;
                                let _e2493 = phi_4663_;
                                let _e2495 = phi_4664_;
                                let _e2497 = phi_4665_;
                                let _e2499 = phi_4666_;
                                let _e2501 = phi_4667_;
                                phi_5297_ = _e2491;
                                phi_1394_ = _e2493;
                                phi_1397_ = _e2495;
                                phi_1399_ = _e2497;
                                phi_1401_ = _e2499;
                                phi_1403_ = _e2501;
                                phi_4668_ = _e811;
                            } else {
                                phi_5297_ = _e797;
                                phi_1394_ = type_43();
                                phi_1397_ = bool();
                                phi_1399_ = type_59();
                                phi_1401_ = u32();
                                phi_1403_ = u32();
                                phi_4668_ = false;
                            }
                            let _e2503 = phi_5297_;
                            let _e2505 = phi_1394_;
                            let _e2507 = phi_1397_;
                            let _e2509 = phi_1399_;
                            let _e2511 = phi_1401_;
                            let _e2513 = phi_1403_;
                            let _e2515 = phi_4668_;
                            continue;
                            continuing {
                                phi_5070_ = _e2503;
                                phi_1393_ = _e2505;
                                phi_1396_ = _e2507;
                                phi_1398_ = _e2509;
                                phi_1400_ = _e2511;
                                phi_1402_ = _e2513;
                                phi_5296_ = _e2503;
                                break if !(_e2515);
                            }
                        }
                        let _e2518 = phi_5296_;
                        if _e2518 {
                            break;
                        }
                        let _e2520 = local_11;
                        if _e2520.member_1 {
                        } else {
                            if _e305 {
                            } else {
                                break;
                            }
                            let _e2524 = global_2.member[_e151];
                            if _e166 {
                            } else {
                                break;
                            }
                            let _e2528 = global_9.member[_e151].member_1;
                            if _e305 {
                            } else {
                                break;
                            }
                            global_2.member[_e151] = type_23(_e2524.member, _e2524.member_1, _e2524.member_2, array<f32, 3>((_e2524.member_3[0] + (_e2528[0] * _e2524.member_1[0])), (_e2524.member_3[1] + (_e2528[1] * _e2524.member_1[1])), (_e2524.member_3[2] + (_e2528[2] * _e2524.member_1[2]))), _e2524.member_4);
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
fn trace_shadows_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
