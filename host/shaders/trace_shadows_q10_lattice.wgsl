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

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
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

struct type_35 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_47 {
    member: f32,
    member_1: bool,
}

struct type_49 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: array<i32>,
}

struct type_59 {
    member: type_34,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_49;
@group(0) @binding(2) 
var<uniform> global_4: type_49;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_52;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_65;
@group(0) @binding(7) 
var<storage> global_9: type_37;
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
    var phi_554_: type_40;
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
    var phi_1393_: type_47;
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
    var phi_1520_: type_47;
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
    var phi_3032_: type_46;
    var phi_3033_: type_46;
    var phi_3036_: type_46;
    var phi_3037_: type_46;
    var phi_3038_: bool;
    var phi_3042_: type_46;
    var phi_3051_: type_25;
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
    var phi_3391_: type_47;
    var phi_3392_: type_47;
    var phi_1521_: type_47;
    var phi_5064_: bool;
    var local_10: type_47;
    var phi_5300_: bool;
    var phi_4654_: type_47;
    var phi_4655_: bool;
    var phi_4656_: type_59;
    var phi_4657_: u32;
    var phi_5299_: bool;
    var phi_4658_: type_47;
    var phi_4659_: bool;
    var phi_4660_: type_59;
    var phi_4661_: u32;
    var phi_4662_: u32;
    var phi_5298_: bool;
    var phi_4663_: type_47;
    var phi_4664_: bool;
    var phi_4665_: type_59;
    var phi_4666_: u32;
    var phi_4667_: u32;
    var phi_5297_: bool;
    var phi_1394_: type_47;
    var phi_1397_: bool;
    var phi_1399_: type_59;
    var phi_1401_: u32;
    var phi_1403_: u32;
    var phi_4668_: bool;
    var phi_5296_: bool;
    var local_11: type_47;
    var local_12: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e105 = global;
            let _e107 = arrayLength((&global_5.member));
            let _e110 = arrayLength((&global_10.member));
            let _e122 = arrayLength((&global_8.member));
            let _e126 = global_4.member[0u][0u];
            let _e130 = global_4.member[0u][1u];
            let _e134 = global_4.member[0u][2u];
            let _e138 = global_4.member[0u][3u];
            let _e142 = global_4.member[1u][0u];
            let _e146 = global_4.member[1u][1u];
            let _e150 = global_4.member[1u][2u];
            let _e154 = (_e105.x + (_e105.y * 2097152u));
            let _e166 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e138) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            local = array<i32, 3>(bitcast<i32>(_e142), bitcast<i32>(_e146), bitcast<i32>(_e150));
            let _e169 = (_e154 < arrayLength((&global_9.member)));
            if _e169 {
                if _e169 {
                } else {
                    break;
                }
                let _e173 = global_9.member[_e154].member_2;
                phi_370_ = _e173;
            } else {
                phi_370_ = 4294967295u;
            }
            let _e175 = phi_370_;
            let _e178 = global_1.member[0u];
            let _e182 = global_3.member[0u][0u];
            let _e186 = global_3.member[0u][1u];
            let _e190 = global_3.member[0u][2u];
            let _e194 = global_3.member[0u][3u];
            let _e198 = global_3.member[1u][0u];
            let _e202 = global_3.member[1u][1u];
            let _e206 = global_3.member[1u][2u];
            let _e210 = global_3.member[1u][3u];
            let _e211 = bitcast<f32>(_e182);
            let _e212 = bitcast<f32>(_e186);
            let _e213 = bitcast<f32>(_e190);
            let _e215 = bitcast<f32>(_e198);
            let _e216 = array<u32, 3>(_e202, _e206, _e210);
            let _e218 = bitcast<i32>(_e178);
            if (_e218 < -126i) {
                phi_414_ = -126i;
            } else {
                phi_414_ = select(_e218, 127i, (_e218 > 127i));
            }
            let _e223 = phi_414_;
            let _e228 = bitcast<f32>((bitcast<u32>((_e223 + 127i)) << bitcast<u32>(23i)));
            let _e234 = bitcast<f32>((bitcast<u32>(((_e218 - _e223) + 127i)) << bitcast<u32>(23i)));
            if (_e194 == 0u) {
                phi_554_ = type_40(array<f32, 3>(_e211, _e212, _e213), _e194, _e215, _e216);
            } else {
                let _e236 = bitcast<u32>(_e211);
                let _e238 = ((_e236 & 2139095040u) != 0u);
                let _e253 = bitcast<u32>(_e212);
                let _e255 = ((_e253 & 2139095040u) != 0u);
                let _e270 = bitcast<u32>(_e213);
                let _e272 = ((_e270 & 2139095040u) != 0u);
                let _e288 = bitcast<u32>(_e215);
                let _e290 = ((_e288 & 2139095040u) != 0u);
                phi_554_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e236 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e236 & 2147483648u))), _e211, _e238) * _e228) * select(0.00000011920929f, 1f, _e238)) * _e234), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e253 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e253 & 2147483648u))), _e212, _e255) * _e228) * select(0.00000011920929f, 1f, _e255)) * _e234), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e270 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e270 & 2147483648u))), _e213, _e272) * _e228) * select(0.00000011920929f, 1f, _e272)) * _e234)), _e194, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e288 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e288 & 2147483648u))), _e215, _e290) * _e228) * select(0.00000011920929f, 1f, _e290)) * _e234), _e216);
            }
            let _e307 = phi_554_;
            if _e169 {
                let _e308 = (_e154 < arrayLength((&global_2.member)));
                if _e308 {
                    if _e169 {
                    } else {
                        break;
                    }
                    let _e313 = global_9.member[_e154].member.member_1;
                    let _e318 = global_9.member[_e154].member.member_3;
                    if (_e313 <= _e318) {
                        let _e320 = (1u < _e122);
                        if _e320 {
                            if (0u < _e122) {
                            } else {
                                break;
                            }
                            let _e324 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e324 + 1u) < _e324) {
                                if _e320 {
                                } else {
                                    break;
                                }
                                let _e329 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e169 {
                        } else {
                            break;
                        }
                        let _e339 = global_9.member[_e154].member.member_2[0u];
                        let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                        let _e347 = global_9.member[_e154].member.member_2[1u];
                        let _e349 = (bitcast<u32>(_e347) & 2147483647u);
                        let _e355 = global_9.member[_e154].member.member_2[2u];
                        let _e357 = (bitcast<u32>(_e355) & 2147483647u);
                        let _e363 = global_9.member[_e154].member.member[0u];
                        let _e365 = (bitcast<u32>(_e363) & 2147483647u);
                        let _e371 = global_9.member[_e154].member.member[1u];
                        let _e373 = (bitcast<u32>(_e371) & 2147483647u);
                        let _e379 = global_9.member[_e154].member.member[2u];
                        let _e381 = (bitcast<u32>(_e379) & 2147483647u);
                        let _e383 = select(_e349, _e341, (_e349 < _e341));
                        let _e385 = select(_e357, _e383, (_e357 < _e383));
                        let _e387 = select(_e365, _e385, (_e365 < _e385));
                        let _e389 = select(_e373, _e387, (_e373 < _e387));
                        let _e391 = select(_e381, _e389, (_e381 < _e389));
                        let _e392 = bitcast<u32>(_e313);
                        let _e393 = (_e392 & 2147483647u);
                        let _e397 = bitcast<u32>(_e318);
                        let _e398 = (_e397 & 2147483647u);
                        let _e402 = (((select(_e393, _e391, (_e393 < _e391)) < 2139095040u) && (_e398 <= 2139095040u)) && (_e385 > 0u));
                        if _e402 {
                            let _e405 = (bitcast<u32>(bitcast<f32>(_e385)) & 2147483647u);
                            if (_e405 >= 8388608u) {
                                phi_704_ = (bitcast<i32>((_e405 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_704_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e405)), 32u, (_e405 == 0u))));
                            }
                            let _e419 = phi_704_;
                            phi_705_ = _e419;
                        } else {
                            phi_705_ = 0i;
                        }
                        let _e421 = phi_705_;
                        let _e422 = (_e341 == _e385);
                        if _e422 {
                            phi_715_ = true;
                        } else {
                            phi_715_ = (_e349 == _e385);
                        }
                        let _e425 = phi_715_;
                        let _e426 = select(1u, 0u, _e422);
                        if _e425 {
                            let _e427 = (_e426 + 1u);
                            phi_725_ = _e427;
                            phi_726_ = _e427;
                            phi_728_ = select(true, false, (_e427 == 2u));
                        } else {
                            phi_725_ = u32();
                            phi_726_ = 0u;
                            phi_728_ = true;
                        }
                        let _e431 = phi_725_;
                        let _e433 = phi_726_;
                        let _e435 = phi_728_;
                        if _e435 {
                            phi_733_ = (_e433 + 1u);
                        } else {
                            phi_733_ = 0u;
                        }
                        let _e439 = phi_733_;
                        let _e440 = select(_e431, _e433, _e435);
                        let _e441 = select(_e426, select(2u, _e426, _e425), _e435);
                        let _e442 = -(_e421);
                        if (_e442 < -126i) {
                            phi_766_ = -126i;
                        } else {
                            phi_766_ = select(_e442, 127i, (_e442 > 127i));
                        }
                        let _e447 = phi_766_;
                        let _e452 = bitcast<f32>((bitcast<u32>((_e447 + 127i)) << bitcast<u32>(23i)));
                        let _e458 = bitcast<f32>((bitcast<u32>(((_e442 - _e447) + 127i)) << bitcast<u32>(23i)));
                        let _e463 = global_9.member[_e154].member.member;
                        let _e464 = (_e440 == 0u);
                        if _e464 {
                            phi_784_ = _e463[0];
                        } else {
                            phi_784_ = _e463[1];
                        }
                        let _e468 = phi_784_;
                        let _e469 = (_e440 == 2u);
                        if _e469 {
                            phi_790_ = _e463[2];
                        } else {
                            phi_790_ = _e468;
                        }
                        let _e472 = phi_790_;
                        let _e473 = bitcast<u32>(_e472);
                        let _e475 = ((_e473 & 2139095040u) != 0u);
                        let _e487 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * select(0.00000011920929f, 1f, _e475));
                        let _e488 = global_9.member[_e154].member.member_2;
                        if _e464 {
                            phi_830_ = _e488[0];
                        } else {
                            phi_830_ = _e488[1];
                        }
                        let _e492 = phi_830_;
                        if _e469 {
                            phi_836_ = _e488[2];
                        } else {
                            phi_836_ = _e492;
                        }
                        let _e495 = phi_836_;
                        let _e496 = bitcast<u32>(_e495);
                        let _e498 = ((_e496 & 2139095040u) != 0u);
                        let _e512 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e496 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e496 & 2147483648u))), _e495, _e498) * _e452) * select(0.00000011920929f, 1f, _e498)) * _e458);
                        let _e516 = (bitcast<f32>((bitcast<u32>(_e512) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e519 = bitcast<f32>((bitcast<u32>(_e487) & 2147483647u));
                        let _e520 = (_e519 * 0.00000011920929f);
                        let _e523 = select(select(0.00000000000011368684f, _e520, (_e520 > 0.00000000000011368684f)), 0f, _e516);
                        let _e524 = select(0f, _e512, _e516);
                        let _e525 = (_e487 + _e523);
                        let _e526 = (_e487 - _e523);
                        let _e528 = select(38685626000000000000000000f, (1f / _e512), _e516);
                        let _e529 = (_e439 == 0u);
                        if _e529 {
                            phi_909_ = _e463[0];
                        } else {
                            phi_909_ = _e463[1];
                        }
                        let _e533 = phi_909_;
                        let _e534 = (_e439 == 2u);
                        if _e534 {
                            phi_915_ = _e463[2];
                        } else {
                            phi_915_ = _e533;
                        }
                        let _e537 = phi_915_;
                        let _e538 = bitcast<u32>(_e537);
                        let _e540 = ((_e538 & 2139095040u) != 0u);
                        let _e552 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e538 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e538 & 2147483648u))), _e537, _e540) * select(0.00000011920929f, 1f, _e540));
                        if _e529 {
                            phi_955_ = _e488[0];
                        } else {
                            phi_955_ = _e488[1];
                        }
                        let _e556 = phi_955_;
                        if _e534 {
                            phi_961_ = _e488[2];
                        } else {
                            phi_961_ = _e556;
                        }
                        let _e559 = phi_961_;
                        let _e560 = bitcast<u32>(_e559);
                        let _e562 = ((_e560 & 2139095040u) != 0u);
                        let _e576 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e560 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e560 & 2147483648u))), _e559, _e562) * _e452) * select(0.00000011920929f, 1f, _e562)) * _e458);
                        let _e580 = (bitcast<f32>((bitcast<u32>(_e576) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e583 = bitcast<f32>((bitcast<u32>(_e552) & 2147483647u));
                        let _e584 = (_e583 * 0.00000011920929f);
                        let _e587 = select(select(0.00000000000011368684f, _e584, (_e584 > 0.00000000000011368684f)), 0f, _e580);
                        let _e588 = select(0f, _e576, _e580);
                        let _e589 = (_e552 + _e587);
                        let _e590 = (_e552 - _e587);
                        let _e592 = select(38685626000000000000000000f, (1f / _e576), _e580);
                        let _e593 = (_e441 == 0u);
                        if _e593 {
                            phi_1034_ = _e463[0];
                        } else {
                            phi_1034_ = _e463[1];
                        }
                        let _e597 = phi_1034_;
                        let _e598 = (_e441 == 2u);
                        if _e598 {
                            phi_1040_ = _e463[2];
                        } else {
                            phi_1040_ = _e597;
                        }
                        let _e601 = phi_1040_;
                        let _e602 = bitcast<u32>(_e601);
                        let _e604 = ((_e602 & 2139095040u) != 0u);
                        let _e616 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e602 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e602 & 2147483648u))), _e601, _e604) * select(0.00000011920929f, 1f, _e604));
                        if _e593 {
                            phi_1080_ = _e488[0];
                        } else {
                            phi_1080_ = _e488[1];
                        }
                        let _e620 = phi_1080_;
                        if _e598 {
                            phi_1086_ = _e488[2];
                        } else {
                            phi_1086_ = _e620;
                        }
                        let _e623 = phi_1086_;
                        let _e624 = bitcast<u32>(_e623);
                        let _e626 = ((_e624 & 2139095040u) != 0u);
                        let _e640 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e624 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e624 & 2147483648u))), _e623, _e626) * _e452) * select(0.00000011920929f, 1f, _e626)) * _e458);
                        let _e644 = (bitcast<f32>((bitcast<u32>(_e640) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e647 = bitcast<f32>((bitcast<u32>(_e616) & 2147483647u));
                        let _e648 = (_e647 * 0.00000011920929f);
                        let _e651 = select(select(0.00000000000011368684f, _e648, (_e648 > 0.00000000000011368684f)), 0f, _e644);
                        let _e652 = select(0f, _e640, _e644);
                        let _e653 = (_e616 + _e651);
                        let _e654 = (_e616 - _e651);
                        let _e656 = select(38685626000000000000000000f, (1f / _e640), _e644);
                        let _e658 = select(_e583, _e519, (_e519 > _e583));
                        if (_e402 && (select(_e647, _e658, (_e658 > _e647)) <= 1099511600000f)) {
                            let _e670 = ((_e393 & 8388607u) | (select(0u, 1u, ((_e393 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e673 = bitcast<i32>((_e393 >> bitcast<u32>(23i)));
                            let _e677 = (_e670 == 0u);
                            let _e680 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e670)), 32u, _e677)) - 8i);
                            if (_e673 == 255i) {
                                phi_1205_ = 255i;
                            } else {
                                phi_1205_ = (((_e673 + select(0i, 1i, (_e673 == 0i))) - _e680) + _e421);
                            }
                            let _e688 = phi_1205_;
                            let _e698 = (_e688 <= 0i);
                            if _e698 {
                                phi_1228_ = u32();
                            } else {
                                if _e677 {
                                    phi_1227_ = u32();
                                } else {
                                    phi_1227_ = select(((bitcast<u32>(_e688) << bitcast<u32>(23i)) | ((_e670 << bitcast<u32>(((_e680 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e688 >= 255i));
                                }
                                let _e702 = phi_1227_;
                                phi_1228_ = _e702;
                            }
                            let _e704 = phi_1228_;
                            let _e716 = ((_e398 & 8388607u) | (select(0u, 1u, ((_e398 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e719 = bitcast<i32>((_e398 >> bitcast<u32>(23i)));
                            let _e723 = (_e716 == 0u);
                            let _e726 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e716)), 32u, _e723)) - 8i);
                            if (_e719 == 255i) {
                                phi_1265_ = 255i;
                            } else {
                                phi_1265_ = (((_e719 + select(0i, 1i, (_e719 == 0i))) - _e726) + _e421);
                            }
                            let _e734 = phi_1265_;
                            let _e744 = (_e734 <= 0i);
                            if _e744 {
                                phi_1288_ = u32();
                            } else {
                                if _e723 {
                                    phi_1287_ = u32();
                                } else {
                                    phi_1287_ = select(((bitcast<u32>(_e734) << bitcast<u32>(23i)) | ((_e716 << bitcast<u32>(((_e726 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e734 >= 255i));
                                }
                                let _e748 = phi_1287_;
                                phi_1288_ = _e748;
                            }
                            let _e750 = phi_1288_;
                            phi_1296_ = bitcast<f32>(((_e397 & 2147483648u) | select(_e750, 0u, select(_e723, true, _e744))));
                            phi_1297_ = bitcast<f32>(((_e392 & 2147483648u) | select(_e704, 0u, select(_e677, true, _e698))));
                        } else {
                            phi_1296_ = 0f;
                            phi_1297_ = 1f;
                        }
                        let _e756 = phi_1296_;
                        let _e758 = phi_1297_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e764 = (_e440 % 3u);
                        let _e765 = (_e764 < 3u);
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e767 = local_1[_e764];
                        let _e770 = (_e439 % 3u);
                        let _e771 = (_e770 < 3u);
                        if _e771 {
                        } else {
                            break;
                        }
                        let _e773 = local_1[_e770];
                        let _e776 = (_e441 % 3u);
                        let _e777 = (_e776 < 3u);
                        if _e777 {
                        } else {
                            break;
                        }
                        let _e779 = local_1[_e776];
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e784 = local[_e764];
                        if _e771 {
                        } else {
                            break;
                        }
                        let _e788 = local[_e770];
                        if _e777 {
                        } else {
                            break;
                        }
                        let _e792 = local[_e776];
                        phi_5070_ = false;
                        phi_1393_ = type_47(_e756, false);
                        phi_1396_ = (_e758 <= _e756);
                        phi_1398_ = type_59(type_34(vec4<f32>((f32(_e767) * _e166), (f32(_e773) * _e166), (f32(_e779) * _e166), 0f), vec4<f32>((f32(_e784) * _e166), (f32(_e788) * _e166), (f32(_e792) * _e166), 0f)), select(0u, 2147483648u, (_e107 == 0u)));
                        phi_1400_ = 0u;
                        phi_1402_ = ((3u * _e107) + 1u);
                        loop {
                            let _e800 = phi_5070_;
                            let _e802 = phi_1393_;
                            let _e804 = phi_1396_;
                            let _e806 = phi_1398_;
                            let _e808 = phi_1400_;
                            let _e810 = phi_1402_;
                            local_11 = _e802;
                            if _e804 {
                                phi_1413_ = true;
                            } else {
                                phi_1413_ = (_e808 > 0u);
                            }
                            let _e813 = phi_1413_;
                            if _e813 {
                                let _e814 = (_e810 > 0u);
                                if _e814 {
                                    if _e804 {
                                        phi_1499_ = _e804;
                                        phi_1500_ = _e806;
                                        phi_1501_ = _e808;
                                    } else {
                                        let _e815 = (_e808 - 1u);
                                        let _e816 = (_e815 % 128u);
                                        let _e817 = (_e816 < 128u);
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e819 = local_7[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e821 = local_6[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e823 = local_5[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e825 = local_4[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e827 = local_3[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e829 = local_2[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e834 = local_8[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5296_ = true;
                                            break;
                                        }
                                        let _e837 = local_9[_e816];
                                        phi_1499_ = (_e837 <= _e802.member);
                                        phi_1500_ = type_59(type_34(vec4<f32>(_e819, _e821, _e823, 0f), vec4<f32>(_e825, _e827, _e829, 0f)), _e834);
                                        phi_1501_ = _e815;
                                    }
                                    let _e841 = phi_1499_;
                                    let _e843 = phi_1500_;
                                    let _e845 = phi_1501_;
                                    if _e841 {
                                        let _e850 = (_e843.member_1 & 268435455u);
                                        if ((_e843.member_1 & 2147483648u) != 0u) {
                                            phi_1520_ = _e802;
                                            phi_1523_ = type_8(0u, ((_e843.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1315 = phi_1520_;
                                                let _e1317 = phi_1523_;
                                                local_10 = _e1315;
                                                local_12 = _e1315;
                                                if (_e1317.member < _e1317.member_1) {
                                                    phi_1524_ = type_8((_e1317.member + 1u), _e1317.member_1);
                                                    phi_1546_ = type_8(1u, _e1317.member);
                                                } else {
                                                    phi_1524_ = _e1317;
                                                    phi_1546_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1330 = phi_1524_;
                                                let _e1332 = phi_1546_;
                                                let _e1336 = (bitcast<i32>(_e1332.member) != 0i);
                                                if _e1336 {
                                                    let _e1341 = (_e843.member.member_1.x - _e843.member.member.x);
                                                    let _e1344 = (_e843.member.member_1.y - _e843.member.member.y);
                                                    let _e1347 = (_e843.member.member_1.z - _e843.member.member.z);
                                                    let _e1349 = select(_e1344, _e1341, (_e1341 > _e1344));
                                                    let _e1351 = select(_e1347, _e1349, (_e1349 > _e1347));
                                                    let _e1353 = (_e1351 < (1024f * _e166));
                                                    if _e1353 {
                                                        phi_1587_ = 0u;
                                                    } else {
                                                        phi_1587_ = select(2u, 1u, (_e1351 < (2097152f * _e166)));
                                                    }
                                                    let _e1358 = phi_1587_;
                                                    switch bitcast<i32>(_e1358) {
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
                                                    let _e1361 = phi_1593_;
                                                    switch bitcast<i32>(_e1358) {
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
                                                    let _e1368 = phi_1603_;
                                                    let _e1370 = ((_e850 + (_e1332.member_1 * ((3u * _e1361) + 1u))) + (3u * _e1368));
                                                    let _e1371 = (_e1370 < _e110);
                                                    if _e1371 {
                                                        if _e1371 {
                                                        } else {
                                                            phi_5064_ = true;
                                                            break;
                                                        }
                                                        let _e1373 = global_10.member[_e1370];
                                                        phi_1619_ = _e1373;
                                                    } else {
                                                        phi_1619_ = 4294967295u;
                                                    }
                                                    let _e1375 = phi_1619_;
                                                    if _e1353 {
                                                        phi_1652_ = 0u;
                                                    } else {
                                                        phi_1652_ = select(2u, 1u, (_e1351 < (2097152f * _e166)));
                                                    }
                                                    let _e1380 = phi_1652_;
                                                    switch bitcast<i32>(_e1380) {
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
                                                    let _e1383 = phi_1658_;
                                                    let _e1387 = (_e850 + (_e1332.member_1 * ((3u * _e1383) + 1u)));
                                                    switch bitcast<i32>(_e1380) {
                                                        case 0: {
                                                            let _e1662 = (_e1387 < _e110);
                                                            if _e1662 {
                                                                if _e1662 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1664 = global_10.member[_e1387];
                                                                phi_1685_ = _e1664;
                                                            } else {
                                                                phi_1685_ = 0u;
                                                            }
                                                            let _e1666 = phi_1685_;
                                                            let _e1668 = ((10u * _e440) & 31u);
                                                            let _e1678 = ((10u * _e439) & 31u);
                                                            let _e1688 = ((10u * _e441) & 31u);
                                                            let _e1698 = (_e1387 + 1u);
                                                            let _e1699 = (_e1698 < _e110);
                                                            if _e1699 {
                                                                if _e1699 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1701 = global_10.member[_e1698];
                                                                phi_1734_ = _e1701;
                                                            } else {
                                                                phi_1734_ = 0u;
                                                            }
                                                            let _e1703 = phi_1734_;
                                                            let _e1729 = (_e1387 + 2u);
                                                            let _e1730 = (_e1729 < _e110);
                                                            if _e1730 {
                                                                if _e1730 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1732 = global_10.member[_e1729];
                                                                phi_1783_ = _e1732;
                                                            } else {
                                                                phi_1783_ = 0u;
                                                            }
                                                            let _e1734 = phi_1783_;
                                                            phi_2284_ = array<array<f32, 3>, 3>(array<f32, 3>((_e843.member.member.x + ((bitcast<f32>((1258291200u | ((_e1666 >> bitcast<u32>(_e1668)) & 1023u))) - 8388608f) * _e166)), (_e843.member.member.y + ((bitcast<f32>((1258291200u | ((_e1666 >> bitcast<u32>(_e1678)) & 1023u))) - 8388608f) * _e166)), (_e843.member.member.z + ((bitcast<f32>((1258291200u | ((_e1666 >> bitcast<u32>(_e1688)) & 1023u))) - 8388608f) * _e166))), array<f32, 3>((_e843.member.member.x + ((bitcast<f32>((1258291200u | ((_e1703 >> bitcast<u32>(_e1668)) & 1023u))) - 8388608f) * _e166)), (_e843.member.member.y + ((bitcast<f32>((1258291200u | ((_e1703 >> bitcast<u32>(_e1678)) & 1023u))) - 8388608f) * _e166)), (_e843.member.member.z + ((bitcast<f32>((1258291200u | ((_e1703 >> bitcast<u32>(_e1688)) & 1023u))) - 8388608f) * _e166))), array<f32, 3>((_e843.member.member.x + ((bitcast<f32>((1258291200u | ((_e1734 >> bitcast<u32>(_e1668)) & 1023u))) - 8388608f) * _e166)), (_e843.member.member.y + ((bitcast<f32>((1258291200u | ((_e1734 >> bitcast<u32>(_e1678)) & 1023u))) - 8388608f) * _e166)), (_e843.member.member.z + ((bitcast<f32>((1258291200u | ((_e1734 >> bitcast<u32>(_e1688)) & 1023u))) - 8388608f) * _e166))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1476 = (_e1387 < _e110);
                                                            if _e1476 {
                                                                if _e1476 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1478 = global_10.member[_e1387];
                                                                phi_1832_ = _e1478;
                                                            } else {
                                                                phi_1832_ = 0u;
                                                            }
                                                            let _e1480 = phi_1832_;
                                                            let _e1481 = (_e1387 + 1u);
                                                            let _e1482 = (_e1481 < _e110);
                                                            if _e1482 {
                                                                if _e1482 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1484 = global_10.member[_e1481];
                                                                phi_1847_ = _e1484;
                                                            } else {
                                                                phi_1847_ = 0u;
                                                            }
                                                            let _e1486 = phi_1847_;
                                                            let _e1487 = (_e440 == 1u);
                                                            if _e1487 {
                                                                phi_1857_ = ((_e1480 >> bitcast<u32>(21i)) | (_e1486 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1857_ = (_e1486 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1496 = phi_1857_;
                                                            let _e1504 = (_e439 == 1u);
                                                            if _e1504 {
                                                                phi_1878_ = ((_e1480 >> bitcast<u32>(21i)) | (_e1486 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1878_ = (_e1486 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1513 = phi_1878_;
                                                            let _e1521 = (_e441 == 1u);
                                                            if _e1521 {
                                                                phi_1899_ = ((_e1480 >> bitcast<u32>(21i)) | (_e1486 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1899_ = (_e1486 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1530 = phi_1899_;
                                                            let _e1539 = (_e1387 + 2u);
                                                            let _e1540 = (_e1539 < _e110);
                                                            if _e1540 {
                                                                if _e1540 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1542 = global_10.member[_e1539];
                                                                phi_1929_ = _e1542;
                                                            } else {
                                                                phi_1929_ = 0u;
                                                            }
                                                            let _e1544 = phi_1929_;
                                                            let _e1545 = (_e1387 + 3u);
                                                            let _e1546 = (_e1545 < _e110);
                                                            if _e1546 {
                                                                if _e1546 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1548 = global_10.member[_e1545];
                                                                phi_1944_ = _e1548;
                                                            } else {
                                                                phi_1944_ = 0u;
                                                            }
                                                            let _e1550 = phi_1944_;
                                                            if _e1487 {
                                                                phi_1954_ = ((_e1544 >> bitcast<u32>(21i)) | (_e1550 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1954_ = (_e1550 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1559 = phi_1954_;
                                                            if _e1504 {
                                                                phi_1975_ = ((_e1544 >> bitcast<u32>(21i)) | (_e1550 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1975_ = (_e1550 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1575 = phi_1975_;
                                                            if _e1521 {
                                                                phi_1996_ = ((_e1544 >> bitcast<u32>(21i)) | (_e1550 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1996_ = (_e1550 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1591 = phi_1996_;
                                                            let _e1600 = (_e1387 + 4u);
                                                            let _e1601 = (_e1600 < _e110);
                                                            if _e1601 {
                                                                if _e1601 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1603 = global_10.member[_e1600];
                                                                phi_2026_ = _e1603;
                                                            } else {
                                                                phi_2026_ = 0u;
                                                            }
                                                            let _e1605 = phi_2026_;
                                                            let _e1606 = (_e1387 + 5u);
                                                            let _e1607 = (_e1606 < _e110);
                                                            if _e1607 {
                                                                if _e1607 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1609 = global_10.member[_e1606];
                                                                phi_2041_ = _e1609;
                                                            } else {
                                                                phi_2041_ = 0u;
                                                            }
                                                            let _e1611 = phi_2041_;
                                                            if _e1487 {
                                                                phi_2051_ = ((_e1605 >> bitcast<u32>(21i)) | (_e1611 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2051_ = (_e1611 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1620 = phi_2051_;
                                                            if _e1504 {
                                                                phi_2072_ = ((_e1605 >> bitcast<u32>(21i)) | (_e1611 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2072_ = (_e1611 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1636 = phi_2072_;
                                                            if _e1521 {
                                                                phi_2093_ = ((_e1605 >> bitcast<u32>(21i)) | (_e1611 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2093_ = (_e1611 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1652 = phi_2093_;
                                                            phi_2284_ = array<array<f32, 3>, 3>(array<f32, 3>((_e843.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1496, _e1480, _e464) & 2097151u))) - 8388608f) * _e166)), (_e843.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1513, _e1480, _e529) & 2097151u))) - 8388608f) * _e166)), (_e843.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1530, _e1480, _e593) & 2097151u))) - 8388608f) * _e166))), array<f32, 3>((_e843.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1559, _e1544, _e464) & 2097151u))) - 8388608f) * _e166)), (_e843.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1575, _e1544, _e529) & 2097151u))) - 8388608f) * _e166)), (_e843.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1591, _e1544, _e593) & 2097151u))) - 8388608f) * _e166))), array<f32, 3>((_e843.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1620, _e1605, _e464) & 2097151u))) - 8388608f) * _e166)), (_e843.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1636, _e1605, _e529) & 2097151u))) - 8388608f) * _e166)), (_e843.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1652, _e1605, _e593) & 2097151u))) - 8388608f) * _e166))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1389 = (_e1387 + _e440);
                                                            let _e1390 = (_e1389 < _e110);
                                                            if _e1390 {
                                                                if _e1390 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1392 = global_10.member[_e1389];
                                                                phi_2124_ = _e1392;
                                                            } else {
                                                                phi_2124_ = 0u;
                                                            }
                                                            let _e1394 = phi_2124_;
                                                            let _e1398 = (_e1387 + _e439);
                                                            let _e1399 = (_e1398 < _e110);
                                                            if _e1399 {
                                                                if _e1399 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1401 = global_10.member[_e1398];
                                                                phi_2142_ = _e1401;
                                                            } else {
                                                                phi_2142_ = 0u;
                                                            }
                                                            let _e1403 = phi_2142_;
                                                            let _e1407 = (_e1387 + _e441);
                                                            let _e1408 = (_e1407 < _e110);
                                                            if _e1408 {
                                                                if _e1408 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1410 = global_10.member[_e1407];
                                                                phi_2160_ = _e1410;
                                                            } else {
                                                                phi_2160_ = 0u;
                                                            }
                                                            let _e1412 = phi_2160_;
                                                            let _e1417 = (_e1387 + 3u);
                                                            let _e1418 = (_e1417 + _e440);
                                                            let _e1419 = (_e1418 < _e110);
                                                            if _e1419 {
                                                                if _e1419 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1421 = global_10.member[_e1418];
                                                                phi_2183_ = _e1421;
                                                            } else {
                                                                phi_2183_ = 0u;
                                                            }
                                                            let _e1423 = phi_2183_;
                                                            let _e1427 = (_e1417 + _e439);
                                                            let _e1428 = (_e1427 < _e110);
                                                            if _e1428 {
                                                                if _e1428 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1430 = global_10.member[_e1427];
                                                                phi_2201_ = _e1430;
                                                            } else {
                                                                phi_2201_ = 0u;
                                                            }
                                                            let _e1432 = phi_2201_;
                                                            let _e1436 = (_e1417 + _e441);
                                                            let _e1437 = (_e1436 < _e110);
                                                            if _e1437 {
                                                                if _e1437 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1439 = global_10.member[_e1436];
                                                                phi_2219_ = _e1439;
                                                            } else {
                                                                phi_2219_ = 0u;
                                                            }
                                                            let _e1441 = phi_2219_;
                                                            let _e1446 = (_e1387 + 6u);
                                                            let _e1447 = (_e1446 + _e440);
                                                            let _e1448 = (_e1447 < _e110);
                                                            if _e1448 {
                                                                if _e1448 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1450 = global_10.member[_e1447];
                                                                phi_2242_ = _e1450;
                                                            } else {
                                                                phi_2242_ = 0u;
                                                            }
                                                            let _e1452 = phi_2242_;
                                                            let _e1456 = (_e1446 + _e439);
                                                            let _e1457 = (_e1456 < _e110);
                                                            if _e1457 {
                                                                if _e1457 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1459 = global_10.member[_e1456];
                                                                phi_2260_ = _e1459;
                                                            } else {
                                                                phi_2260_ = 0u;
                                                            }
                                                            let _e1461 = phi_2260_;
                                                            let _e1465 = (_e1446 + _e441);
                                                            let _e1466 = (_e1465 < _e110);
                                                            if _e1466 {
                                                                if _e1466 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e1468 = global_10.member[_e1465];
                                                                phi_2278_ = _e1468;
                                                            } else {
                                                                phi_2278_ = 0u;
                                                            }
                                                            let _e1470 = phi_2278_;
                                                            phi_2284_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1394)) * _e166), (f32(bitcast<i32>(_e1403)) * _e166), (f32(bitcast<i32>(_e1412)) * _e166)), array<f32, 3>((f32(bitcast<i32>(_e1423)) * _e166), (f32(bitcast<i32>(_e1432)) * _e166), (f32(bitcast<i32>(_e1441)) * _e166)), array<f32, 3>((f32(bitcast<i32>(_e1452)) * _e166), (f32(bitcast<i32>(_e1461)) * _e166), (f32(bitcast<i32>(_e1470)) * _e166)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2284_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1762 = phi_2284_;
                                                    let _e1778 = (_e1762[0][2] - _e616);
                                                    let _e1781 = (((_e1762[0][0] - _e487) * _e652) - (_e1778 * _e524));
                                                    let _e1784 = (((_e1762[0][1] - _e552) * _e652) - (_e1778 * _e588));
                                                    let _e1787 = (_e1762[1][2] - _e616);
                                                    let _e1790 = (((_e1762[1][0] - _e487) * _e652) - (_e1787 * _e524));
                                                    let _e1793 = (((_e1762[1][1] - _e552) * _e652) - (_e1787 * _e588));
                                                    let _e1796 = (_e1762[2][2] - _e616);
                                                    let _e1799 = (((_e1762[2][0] - _e487) * _e652) - (_e1796 * _e524));
                                                    let _e1802 = (((_e1762[2][1] - _e552) * _e652) - (_e1796 * _e588));
                                                    let _e1803 = (_e1799 * _e1793);
                                                    let _e1804 = (_e1802 * _e1790);
                                                    let _e1805 = (_e1781 * _e1802);
                                                    let _e1806 = (_e1784 * _e1799);
                                                    let _e1807 = (_e1790 * _e1784);
                                                    let _e1808 = (_e1793 * _e1781);
                                                    let _e1813 = (((_e1803 >= _e1804) && (_e1805 >= _e1806)) && (_e1807 >= _e1808));
                                                    let _e1819 = (_e1813 || (((_e1803 <= _e1804) && (_e1805 <= _e1806)) && (_e1807 <= _e1808)));
                                                    if _e1819 {
                                                        let _e1821 = select(-1f, 1f, _e1813);
                                                        let _e1823 = ((_e1803 - _e1804) * _e1821);
                                                        let _e1825 = select(0f, _e1823, (_e1823 > 0f));
                                                        let _e1827 = ((_e1805 - _e1806) * _e1821);
                                                        let _e1829 = select(0f, _e1827, (_e1827 > 0f));
                                                        let _e1831 = ((_e1807 - _e1808) * _e1821);
                                                        let _e1833 = select(0f, _e1831, (_e1831 > 0f));
                                                        let _e1835 = ((_e1825 + _e1829) + _e1833);
                                                        let _e1837 = select(_e1762[1][0], _e1762[0][0], (_e1762[0][0] < _e1762[1][0]));
                                                        let _e1841 = select(_e1762[1][0], _e1762[0][0], (_e1762[0][0] > _e1762[1][0]));
                                                        let _e1845 = select(_e1762[1][1], _e1762[0][1], (_e1762[0][1] < _e1762[1][1]));
                                                        let _e1849 = select(_e1762[1][1], _e1762[0][1], (_e1762[0][1] > _e1762[1][1]));
                                                        let _e1853 = select(_e1762[1][2], _e1762[0][2], (_e1762[0][2] < _e1762[1][2]));
                                                        let _e1857 = select(_e1762[1][2], _e1762[0][2], (_e1762[0][2] > _e1762[1][2]));
                                                        let _e1862 = ((select(_e1762[2][0], _e1837, (_e1837 < _e1762[2][0])) - _e525) * _e528);
                                                        let _e1863 = ((select(_e1762[2][0], _e1841, (_e1841 > _e1762[2][0])) - _e526) * _e528);
                                                        let _e1866 = ((select(_e1762[2][1], _e1845, (_e1845 < _e1762[2][1])) - _e589) * _e592);
                                                        let _e1867 = ((select(_e1762[2][1], _e1849, (_e1849 > _e1762[2][1])) - _e590) * _e592);
                                                        let _e1870 = ((select(_e1762[2][2], _e1853, (_e1853 < _e1762[2][2])) - _e653) * _e656);
                                                        let _e1871 = ((select(_e1762[2][2], _e1857, (_e1857 > _e1762[2][2])) - _e654) * _e656);
                                                        let _e1873 = select(_e1871, _e1870, (_e1870 < _e1871));
                                                        let _e1875 = select(_e1871, _e1870, (_e1870 > _e1871));
                                                        let _e1877 = select(_e1863, _e1862, (_e1862 < _e1863));
                                                        let _e1879 = select(_e1867, _e1866, (_e1866 < _e1867));
                                                        let _e1881 = select(_e1879, _e1877, (_e1877 > _e1879));
                                                        let _e1883 = select(_e1873, _e1881, (_e1881 > _e1873));
                                                        let _e1885 = select(_e1863, _e1862, (_e1862 > _e1863));
                                                        let _e1887 = select(_e1867, _e1866, (_e1866 > _e1867));
                                                        let _e1889 = select(_e1887, _e1885, (_e1885 < _e1887));
                                                        let _e1891 = select(_e1875, _e1889, (_e1889 < _e1875));
                                                        let _e1892 = -(_e1873);
                                                        let _e1898 = select(_e758, _e1883, (_e1883 > _e758));
                                                        let _e1902 = select(_e1790, _e1781, (_e1781 < _e1790));
                                                        let _e1907 = select(_e1790, _e1781, (_e1781 > _e1790));
                                                        let _e1914 = select(_e1793, _e1784, (_e1784 < _e1793));
                                                        let _e1919 = select(_e1793, _e1784, (_e1784 > _e1793));
                                                        let _e1928 = (((((_e1819 && (_e1835 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1799, _e1902, (_e1902 < _e1799)) <= 0f) && (select(_e1799, _e1907, (_e1907 > _e1799)) >= 0f))) && ((select(_e1802, _e1914, (_e1914 < _e1802)) <= 0f) && (select(_e1802, _e1919, (_e1919 > _e1802)) >= 0f))) && (_e1898 <= (_e1891 + (select(_e1892, _e1875, (_e1875 > _e1892)) * 0.0000019073523f)))) && (_e1898 <= _e1315.member));
                                                        if _e1928 {
                                                            let _e1933 = (_e1762[1][0] - _e1762[0][0]);
                                                            let _e1934 = (_e1762[1][1] - _e1762[0][1]);
                                                            let _e1935 = (_e1762[1][2] - _e1762[0][2]);
                                                            let _e1936 = vec3<f32>(_e1933, _e1934, _e1935);
                                                            let _e1937 = (_e1762[2][0] - _e1762[1][0]);
                                                            let _e1938 = (_e1762[2][1] - _e1762[1][1]);
                                                            let _e1939 = (_e1762[2][2] - _e1762[1][2]);
                                                            let _e1940 = vec3<f32>(_e1937, _e1938, _e1939);
                                                            let _e1941 = (_e1762[0][0] - _e1762[2][0]);
                                                            let _e1942 = (_e1762[0][1] - _e1762[2][1]);
                                                            let _e1943 = (_e1762[0][2] - _e1762[2][2]);
                                                            let _e1944 = vec3<f32>(_e1941, _e1942, _e1943);
                                                            let _e1947 = bitcast<f32>((bitcast<u32>(_e1933) & 2147483647u));
                                                            let _e1950 = bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u));
                                                            let _e1952 = select(_e1950, _e1947, (_e1947 > _e1950));
                                                            let _e1955 = bitcast<f32>((bitcast<u32>(_e1935) & 2147483647u));
                                                            let _e1957 = select(_e1955, _e1952, (_e1952 > _e1955));
                                                            let _e1960 = bitcast<f32>((bitcast<u32>(_e1937) & 2147483647u));
                                                            let _e1963 = bitcast<f32>((bitcast<u32>(_e1938) & 2147483647u));
                                                            let _e1965 = select(_e1963, _e1960, (_e1960 > _e1963));
                                                            let _e1968 = bitcast<f32>((bitcast<u32>(_e1939) & 2147483647u));
                                                            let _e1970 = select(_e1968, _e1965, (_e1965 > _e1968));
                                                            let _e1973 = bitcast<f32>((bitcast<u32>(_e1941) & 2147483647u));
                                                            let _e1976 = bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u));
                                                            let _e1978 = select(_e1976, _e1973, (_e1973 > _e1976));
                                                            let _e1981 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                            let _e1983 = select(_e1981, _e1978, (_e1978 > _e1981));
                                                            let _e1985 = select(_e1970, _e1957, (_e1957 > _e1970));
                                                            let _e1987 = select(_e1983, _e1985, (_e1985 > _e1983));
                                                            if (_e1957 == _e1987) {
                                                                phi_2814_ = _e1793;
                                                                phi_2815_ = _e1790;
                                                                phi_2816_ = _e1784;
                                                                phi_2817_ = _e1781;
                                                                phi_2818_ = vec3<f32>(_e1762[0][0], _e1762[0][1], _e1762[0][2]);
                                                                phi_2819_ = _e1944;
                                                                phi_2820_ = _e1940;
                                                                phi_2821_ = _e1936;
                                                            } else {
                                                                let _e1989 = (_e1970 == _e1987);
                                                                let _e1994 = vec3(_e1989);
                                                                phi_2814_ = select(_e1784, _e1802, _e1989);
                                                                phi_2815_ = select(_e1781, _e1799, _e1989);
                                                                phi_2816_ = select(_e1802, _e1793, _e1989);
                                                                phi_2817_ = select(_e1799, _e1790, _e1989);
                                                                phi_2818_ = select(vec3<f32>(_e1762[2][0], _e1762[2][1], _e1762[2][2]), vec3<f32>(_e1762[1][0], _e1762[1][1], _e1762[1][2]), _e1994);
                                                                phi_2819_ = select(_e1940, _e1936, _e1994);
                                                                phi_2820_ = select(_e1936, _e1944, _e1994);
                                                                phi_2821_ = select(_e1944, _e1940, _e1994);
                                                            }
                                                            let _e2000 = phi_2814_;
                                                            let _e2002 = phi_2815_;
                                                            let _e2004 = phi_2816_;
                                                            let _e2006 = phi_2817_;
                                                            let _e2008 = phi_2818_;
                                                            let _e2010 = phi_2819_;
                                                            let _e2012 = phi_2820_;
                                                            let _e2014 = phi_2821_;
                                                            let _e2021 = ((_e2012.y * _e2010.z) - (_e2010.y * _e2012.z));
                                                            let _e2026 = ((_e2012.z * _e2010.x) - (_e2010.z * _e2012.x));
                                                            let _e2029 = ((_e2012.x * _e2010.y) - (_e2010.x * _e2012.y));
                                                            let _e2032 = ((_e1825 >= _e1829) && (_e1825 >= _e1833));
                                                            let _e2033 = (_e1829 >= _e1833);
                                                            let _e2047 = (((_e2021 * (select(select(_e1762[2][0], _e1762[1][0], _e2033), _e1762[0][0], _e2032) - _e487)) + (_e2026 * (select(select(_e1762[2][1], _e1762[1][1], _e2033), _e1762[0][1], _e2032) - _e552))) + (_e2029 * (select(select(_e1762[2][2], _e1762[1][2], _e2033), _e1762[0][2], _e2032) - _e616)));
                                                            let _e2052 = (((_e2021 * _e524) + (_e2026 * _e588)) + (_e2029 * _e652));
                                                            let _e2053 = (_e2002 - _e2006);
                                                            let _e2054 = (_e2000 - _e2004);
                                                            let _e2057 = ((_e2053 * _e2053) + (_e2054 * _e2054));
                                                            let _e2064 = (-(((_e2006 * _e2053) + (_e2004 * _e2054))) / select(0.000000000000000000000000000000000000011754944f, _e2057, (_e2057 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e2066 = select(1f, _e2064, (_e2064 < 1f));
                                                            let _e2068 = select(0f, _e2066, (_e2066 > 0f));
                                                            let _e2077 = ((_e2008.x + (_e2014.x * _e2068)) - _e487);
                                                            let _e2080 = ((_e2008.y + (_e2014.y * _e2068)) - _e552);
                                                            let _e2083 = ((_e2008.z + (_e2014.z * _e2068)) - _e616);
                                                            let _e2086 = bitcast<f32>((bitcast<u32>(_e2077) & 2147483647u));
                                                            let _e2089 = bitcast<f32>((bitcast<u32>(_e2080) & 2147483647u));
                                                            let _e2091 = select(_e2089, _e2086, (_e2086 > _e2089));
                                                            let _e2094 = bitcast<f32>((bitcast<u32>(_e2083) & 2147483647u));
                                                            let _e2096 = select(_e2094, _e2091, (_e2091 > _e2094));
                                                            let _e2102 = bitcast<f32>((bitcast<u32>(_e2021) & 2147483647u));
                                                            let _e2105 = bitcast<f32>((bitcast<u32>(_e2026) & 2147483647u));
                                                            let _e2107 = select(_e2105, _e2102, (_e2102 > _e2105));
                                                            let _e2110 = bitcast<f32>((bitcast<u32>(_e2029) & 2147483647u));
                                                            let _e2129 = bitcast<f32>((bitcast<u32>(_e2012.x) & 2147483647u));
                                                            let _e2132 = bitcast<f32>((bitcast<u32>(_e2012.y) & 2147483647u));
                                                            let _e2134 = select(_e2132, _e2129, (_e2129 > _e2132));
                                                            let _e2137 = bitcast<f32>((bitcast<u32>(_e2012.z) & 2147483647u));
                                                            let _e2143 = bitcast<f32>((bitcast<u32>(_e2010.x) & 2147483647u));
                                                            let _e2146 = bitcast<f32>((bitcast<u32>(_e2010.y) & 2147483647u));
                                                            let _e2148 = select(_e2146, _e2143, (_e2143 > _e2146));
                                                            let _e2151 = bitcast<f32>((bitcast<u32>(_e2010.z) & 2147483647u));
                                                            let _e2157 = ((bitcast<f32>((bitcast<u32>(((((_e2021 * _e2077) + (_e2026 * _e2080)) + (_e2029 * _e2083)) - _e2047)) & 2147483647u)) <= ((0.0000009536743f * select(_e1987, _e2096, (_e2096 > _e1987))) * select(_e2110, _e2107, (_e2107 > _e2110)))) && !((bitcast<f32>((bitcast<u32>(_e2052) & 2147483647u)) <= ((0.0000038146973f * select(_e2137, _e2134, (_e2134 > _e2137))) * select(_e2151, _e2148, (_e2148 > _e2151))))));
                                                            let _e2158 = (_e2047 / _e2052);
                                                            if (_e1928 && !(_e2157)) {
                                                                let _e2161 = (_e2083 / _e652);
                                                                let _e2169 = (((_e2021 * (_e2077 - (_e524 * _e2161))) + (_e2026 * (_e2080 - (_e588 * _e2161)))) / _e2052);
                                                                phi_3012_ = select(select(_e2161, (_e2161 + _e2169), (bitcast<f32>((bitcast<u32>(_e2169) & 2147483647u)) <= _e1987)), _e2158, _e2157);
                                                            } else {
                                                                phi_3012_ = _e2158;
                                                            }
                                                            let _e2178 = phi_3012_;
                                                            let _e2180 = select(_e1891, _e2178, (_e2178 < _e1891));
                                                            let _e2182 = select(_e1883, _e2180, (_e2180 > _e1883));
                                                            let _e2183 = (1f / _e1835);
                                                            phi_3032_ = type_46(_e2182, (_e1829 * _e2183), (_e1833 * _e2183), ((_e1928 && (_e2182 >= _e758)) && (_e2182 <= _e1315.member)));
                                                            phi_3033_ = type_46();
                                                        } else {
                                                            phi_3032_ = type_46();
                                                            phi_3033_ = type_46(0f, 0f, 0f, _e1928);
                                                        }
                                                        let _e2192 = phi_3032_;
                                                        let _e2194 = phi_3033_;
                                                        phi_3036_ = _e2192;
                                                        phi_3037_ = _e2194;
                                                        phi_3038_ = select(true, false, _e1928);
                                                    } else {
                                                        phi_3036_ = type_46();
                                                        phi_3037_ = type_46(0f, 0f, 0f, _e1819);
                                                        phi_3038_ = true;
                                                    }
                                                    let _e2197 = phi_3036_;
                                                    let _e2199 = phi_3037_;
                                                    let _e2201 = phi_3038_;
                                                    if _e2201 {
                                                        phi_3042_ = _e2199;
                                                    } else {
                                                        phi_3042_ = _e2197;
                                                    }
                                                    let _e2203 = phi_3042_;
                                                    if _e2203.member_3 {
                                                        phi_3051_ = type_25(_e2203.member, _e2203.member_1, _e2203.member_2, _e1375);
                                                    } else {
                                                        phi_3051_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e2210 = phi_3051_;
                                                    if (_e2210.member_3 != 4294967295u) {
                                                        if (_e1375 == _e175) {
                                                            phi_3386_ = false;
                                                        } else {
                                                            let _e2214 = (_e1375 < arrayLength((&global_6.member)));
                                                            if _e2214 {
                                                                if _e2214 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e2216 = global_6.member[_e1375];
                                                                phi_3074_ = _e2216;
                                                            } else {
                                                                phi_3074_ = 4294967295u;
                                                            }
                                                            let _e2218 = phi_3074_;
                                                            let _e2219 = (_e2218 < arrayLength((&global_7.member)));
                                                            if _e2219 {
                                                                if _e2219 {
                                                                } else {
                                                                    phi_5064_ = true;
                                                                    break;
                                                                }
                                                                let _e2221 = global_7.member[_e2218];
                                                                phi_3088_ = _e2221;
                                                            } else {
                                                                phi_3088_ = 0i;
                                                            }
                                                            let _e2223 = phi_3088_;
                                                            let _e2224 = (_e2223 == 0i);
                                                            if _e2224 {
                                                                phi_3385_ = true;
                                                            } else {
                                                                if _e464 {
                                                                    phi_3111_ = vec3<f32>(_e1762[0][0], _e1762[0][1], _e1762[0][2]);
                                                                } else {
                                                                    if (_e440 == 1u) {
                                                                        phi_3110_ = vec3<f32>(_e1762[0][2], _e1762[0][0], _e1762[0][1]);
                                                                    } else {
                                                                        phi_3110_ = vec3<f32>(_e1762[0][1], _e1762[0][2], _e1762[0][0]);
                                                                    }
                                                                    let _e2229 = phi_3110_;
                                                                    phi_3111_ = _e2229;
                                                                }
                                                                let _e2232 = phi_3111_;
                                                                if _e464 {
                                                                    phi_3130_ = vec3<f32>(_e1762[1][0], _e1762[1][1], _e1762[1][2]);
                                                                } else {
                                                                    if (_e440 == 1u) {
                                                                        phi_3129_ = vec3<f32>(_e1762[1][2], _e1762[1][0], _e1762[1][1]);
                                                                    } else {
                                                                        phi_3129_ = vec3<f32>(_e1762[1][1], _e1762[1][2], _e1762[1][0]);
                                                                    }
                                                                    let _e2237 = phi_3129_;
                                                                    phi_3130_ = _e2237;
                                                                }
                                                                let _e2240 = phi_3130_;
                                                                if _e464 {
                                                                    phi_3149_ = vec3<f32>(_e1762[2][0], _e1762[2][1], _e1762[2][2]);
                                                                } else {
                                                                    if (_e440 == 1u) {
                                                                        phi_3148_ = vec3<f32>(_e1762[2][2], _e1762[2][0], _e1762[2][1]);
                                                                    } else {
                                                                        phi_3148_ = vec3<f32>(_e1762[2][1], _e1762[2][2], _e1762[2][0]);
                                                                    }
                                                                    let _e2245 = phi_3148_;
                                                                    phi_3149_ = _e2245;
                                                                }
                                                                let _e2248 = phi_3149_;
                                                                let _e2251 = (_e2240.x - _e2232.x);
                                                                let _e2254 = (_e2240.y - _e2232.y);
                                                                let _e2257 = (_e2240.z - _e2232.z);
                                                                let _e2259 = (_e2248.x - _e2232.x);
                                                                let _e2261 = (_e2248.y - _e2232.y);
                                                                let _e2263 = (_e2248.z - _e2232.z);
                                                                if (_e307.member_1 == 1u) {
                                                                    phi_3185_ = (vec3<f32>(_e307.member[0], _e307.member[1], _e307.member[2]) - _e2232);
                                                                } else {
                                                                    phi_3185_ = vec3<f32>(_e307.member[0], _e307.member[1], _e307.member[2]);
                                                                }
                                                                let _e2278 = phi_3185_;
                                                                let _e2284 = bitcast<f32>((bitcast<u32>((_e2251 * _e2261)) ^ _e307.member_3[0]));
                                                                let _e2288 = bitcast<f32>((bitcast<u32>((_e2254 * _e2259)) ^ _e307.member_3[0]));
                                                                let _e2292 = bitcast<f32>((bitcast<u32>((_e2254 * _e2263)) ^ _e307.member_3[0]));
                                                                let _e2296 = bitcast<f32>((bitcast<u32>((_e2257 * _e2261)) ^ _e307.member_3[0]));
                                                                let _e2300 = bitcast<f32>((bitcast<u32>((_e2257 * _e2259)) ^ _e307.member_3[0]));
                                                                let _e2304 = bitcast<f32>((bitcast<u32>((_e2251 * _e2263)) ^ _e307.member_3[0]));
                                                                let _e2305 = (_e2292 - _e2296);
                                                                let _e2306 = (_e2300 - _e2304);
                                                                let _e2307 = (_e2284 - _e2288);
                                                                let _e2331 = (bitcast<f32>((bitcast<u32>(_e2292) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2296) & 2147483647u)));
                                                                let _e2338 = (bitcast<f32>((bitcast<u32>(_e2300) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2304) & 2147483647u)));
                                                                let _e2345 = (bitcast<f32>((bitcast<u32>(_e2284) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2288) & 2147483647u)));
                                                                if (_e307.member_2 == 0f) {
                                                                    phi_3367_ = 0f;
                                                                } else {
                                                                    let _e2375 = bitcast<f32>((bitcast<u32>(_e2305) & 2147483647u));
                                                                    let _e2378 = bitcast<f32>((bitcast<u32>(_e2306) & 2147483647u));
                                                                    let _e2381 = bitcast<f32>((bitcast<u32>(_e2307) & 2147483647u));
                                                                    let _e2383 = select(_e2381, _e2378, (_e2378 > _e2381));
                                                                    let _e2387 = select(_e2381, _e2378, (_e2378 < _e2381));
                                                                    let _e2391 = select(_e2378, _e2375, (_e2375 < _e2378));
                                                                    let _e2393 = select(_e2378, _e2375, (_e2375 > _e2378));
                                                                    let _e2395 = select(_e2381, _e2393, (_e2393 < _e2381));
                                                                    phi_3367_ = bitcast<f32>((bitcast<u32>((_e307.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2383, _e2375, (_e2375 > _e2383)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2395, _e2391, (_e2391 > _e2395)))) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2387, _e2375, (_e2375 < _e2387)))) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2331 + _e2338) + _e2345))) ^ _e307.member_3[0]))) * 1.0000005f)) ^ _e307.member_3[0])))) ^ _e307.member_3[0]));
                                                                }
                                                                let _e2422 = phi_3367_;
                                                                phi_3385_ = (_e2224 || !(((((bitcast<f32>((bitcast<u32>((_e2278.x * _e2305)) ^ _e307.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2278.y * _e2306)) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2278.z * _e2307)) ^ _e307.member_3[0]))) * f32(-(_e2223))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2278.x) & 2147483647u)) * _e2331)) ^ _e307.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2278.y) & 2147483647u)) * _e2338)) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2278.z) & 2147483647u)) * _e2345)) ^ _e307.member_3[0]))))) ^ _e307.member_3[0])) + _e2422) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2436 = phi_3385_;
                                                            phi_3386_ = _e2436;
                                                        }
                                                        let _e2438 = phi_3386_;
                                                        if _e2438 {
                                                            phi_3391_ = type_47(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_3391_ = _e1315;
                                                        }
                                                        let _e2440 = phi_3391_;
                                                        phi_3392_ = _e2440;
                                                    } else {
                                                        phi_3392_ = _e1315;
                                                    }
                                                    let _e2442 = phi_3392_;
                                                    phi_1521_ = _e2442;
                                                } else {
                                                    phi_1521_ = type_47();
                                                }
                                                let _e2444 = phi_1521_;
                                                continue;
                                                continuing {
                                                    phi_1520_ = _e2444;
                                                    phi_1523_ = _e1330;
                                                    phi_5064_ = _e800;
                                                    break if !(_e1336);
                                                }
                                            }
                                            let _e2447 = phi_5064_;
                                            phi_5296_ = _e2447;
                                            if _e2447 {
                                                break;
                                            }
                                            let _e2449 = local_10;
                                            phi_5300_ = _e2447;
                                            let _e2671 = local_12;
                                            phi_4654_ = _e2671;
                                            phi_4655_ = false;
                                            phi_4656_ = _e843;
                                            phi_4657_ = select(_e845, 0u, (_e758 > _e2449.member));
                                        } else {
                                            if (_e843.member_1 >= _e107) {
                                                phi_4193_ = type_60(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e843.member_1 < _e107) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e858 = ((1u + _e440) % 4u);
                                                if (_e858 < 4u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e863 = global_5.member[_e843.member_1][_e858];
                                                let _e865 = (_e863 >> bitcast<u32>(11u));
                                                let _e867 = ((1u + _e439) % 4u);
                                                if (_e867 < 4u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e872 = global_5.member[_e843.member_1][_e867];
                                                let _e874 = (_e872 >> bitcast<u32>(11u));
                                                let _e876 = ((1u + _e441) % 4u);
                                                if (_e876 < 4u) {
                                                } else {
                                                    phi_5296_ = true;
                                                    break;
                                                }
                                                let _e881 = global_5.member[_e843.member_1][_e876];
                                                let _e883 = (_e881 >> bitcast<u32>(11u));
                                                let _e906 = (bitcast<f32>((bitcast<u32>((_e843.member.member_1.x - _e843.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e907 = (bitcast<f32>((bitcast<u32>((_e843.member.member_1.y - _e843.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e908 = (bitcast<f32>((bitcast<u32>((_e843.member.member_1.z - _e843.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e910 = select(_e166, _e906, (_e906 > _e166));
                                                let _e912 = select(_e166, _e907, (_e907 > _e166));
                                                let _e914 = select(_e166, _e908, (_e908 > _e166));
                                                let _e945 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e863 & 1023u))) - 8388608f) * _e910));
                                                let _e950 = (bitcast<i32>((_e863 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e953 = bitcast<f32>((_e945 & bitcast<u32>(_e950)));
                                                let _e954 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e872 & 1023u))) - 8388608f) * _e912));
                                                let _e959 = (bitcast<i32>((_e872 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e962 = bitcast<f32>((_e954 & bitcast<u32>(_e959)));
                                                let _e963 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e881 & 1023u))) - 8388608f) * _e914));
                                                let _e968 = (bitcast<i32>((_e881 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e971 = bitcast<f32>((_e963 & bitcast<u32>(_e968)));
                                                let _e975 = bitcast<f32>((_e945 & bitcast<u32>(~(_e950))));
                                                let _e979 = bitcast<f32>((_e954 & bitcast<u32>(~(_e959))));
                                                let _e983 = bitcast<f32>((_e963 & bitcast<u32>(~(_e968))));
                                                let _e984 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e865 & 1023u))) - 8388608f) * _e910));
                                                let _e989 = (bitcast<i32>((_e865 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e992 = bitcast<f32>((_e984 & bitcast<u32>(_e989)));
                                                let _e993 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e874 & 1023u))) - 8388608f) * _e912));
                                                let _e998 = (bitcast<i32>((_e874 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1001 = bitcast<f32>((_e993 & bitcast<u32>(_e998)));
                                                let _e1002 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e883 & 1023u))) - 8388608f) * _e914));
                                                let _e1007 = (bitcast<i32>((_e883 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1010 = bitcast<f32>((_e1002 & bitcast<u32>(_e1007)));
                                                let _e1014 = bitcast<f32>((_e984 & bitcast<u32>(~(_e989))));
                                                let _e1018 = bitcast<f32>((_e993 & bitcast<u32>(~(_e998))));
                                                let _e1022 = bitcast<f32>((_e1002 & bitcast<u32>(~(_e1007))));
                                                let _e1023 = (_e843.member.member.x + _e953);
                                                let _e1024 = (_e843.member.member.y + _e962);
                                                let _e1025 = (_e843.member.member.z + _e971);
                                                let _e1028 = (_e843.member.member_1.x - _e992);
                                                let _e1029 = (_e843.member.member_1.y - _e1001);
                                                let _e1030 = (_e843.member.member_1.z - _e1010);
                                                let _e1049 = (_e1028 - _e1023);
                                                let _e1050 = (_e1029 - _e1024);
                                                let _e1051 = (_e1030 - _e1025);
                                                let _e1053 = select(_e1050, _e1049, (_e1049 > _e1050));
                                                let _e1055 = select(_e1051, _e1053, (_e1053 > _e1051));
                                                if (_e1055 < (1024f * _e166)) {
                                                    phi_3894_ = 0u;
                                                } else {
                                                    phi_3894_ = select(2u, 1u, (_e1055 < (2097152f * _e166)));
                                                }
                                                let _e1062 = phi_3894_;
                                                switch bitcast<i32>(_e1062) {
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
                                                let _e1065 = phi_3900_;
                                                let _e1071 = global_5.member[_e843.member_1][0u];
                                                let _e1075 = global_5.member[_e843.member_1][1u];
                                                let _e1079 = global_5.member[_e843.member_1][2u];
                                                let _e1083 = global_5.member[_e843.member_1][3u];
                                                let _e1095 = (((_e1075 >> bitcast<u32>(22i)) | ((_e1079 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1083 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1096 = (_e1071 & 268435455u);
                                                let _e1097 = (_e1095 & 268435455u);
                                                let _e1100 = ((_e1071 >> bitcast<u32>(28u)) & 7u);
                                                let _e1108 = ((_e1071 >> bitcast<u32>(31i)) | (((_e1095 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1109 = (_e1100 != 0u);
                                                if (_e1100 == 0u) {
                                                    phi_4155_ = _e1096;
                                                } else {
                                                    if (_e1100 == 7u) {
                                                        phi_4154_ = 2147483648u;
                                                    } else {
                                                        phi_4154_ = ((2147483648u | (_e1100 << bitcast<u32>(28u))) | (_e1097 & 268435455u));
                                                    }
                                                    let _e1118 = phi_4154_;
                                                    phi_4155_ = _e1118;
                                                }
                                                let _e1120 = phi_4155_;
                                                if _e1109 {
                                                    let _e1121 = (_e1100 != 7u);
                                                    if _e1121 {
                                                        phi_4165_ = (_e1097 + (_e1100 * ((3u * _e1065) + 1u)));
                                                    } else {
                                                        phi_4165_ = u32();
                                                    }
                                                    let _e1125 = phi_4165_;
                                                    phi_4167_ = _e1125;
                                                    phi_4168_ = select(true, false, _e1121);
                                                } else {
                                                    phi_4167_ = u32();
                                                    phi_4168_ = true;
                                                }
                                                let _e1128 = phi_4167_;
                                                let _e1130 = phi_4168_;
                                                if (_e1108 == 0u) {
                                                    phi_4189_ = (_e1096 + select(0u, 1u, !(_e1109)));
                                                } else {
                                                    if (_e1108 == 7u) {
                                                        phi_4188_ = 2147483648u;
                                                    } else {
                                                        phi_4188_ = ((2147483648u | (_e1108 << bitcast<u32>(28u))) | (select(_e1128, _e1097, _e1130) & 268435455u));
                                                    }
                                                    let _e1143 = phi_4188_;
                                                    phi_4189_ = _e1143;
                                                }
                                                let _e1145 = phi_4189_;
                                                phi_4193_ = type_60(array<vec4<f32>, 3>(vec4<f32>(_e1023, (_e843.member.member.x + _e975), _e1028, (_e843.member.member_1.x - _e1014)), vec4<f32>(_e1024, (_e843.member.member.y + _e979), _e1029, (_e843.member.member_1.y - _e1018)), vec4<f32>(_e1025, (_e843.member.member.z + _e983), _e1030, (_e843.member.member_1.z - _e1022))), type_59(type_34((_e843.member.member + vec4<f32>(_e953, _e962, _e971, 0f)), (_e843.member.member_1 - vec4<f32>(_e992, _e1001, _e1010, 0f))), _e1120), type_59(type_34((_e843.member.member + vec4<f32>(_e975, _e979, _e983, 0f)), (_e843.member.member_1 - vec4<f32>(_e1014, _e1018, _e1022, 0f))), _e1145));
                                            }
                                            let _e1150 = phi_4193_;
                                            let _e1162 = ((_e1150.member[0].x - _e525) * _e528);
                                            let _e1163 = ((_e1150.member[0].y - _e525) * _e528);
                                            let _e1164 = ((_e1150.member[0].z - _e526) * _e528);
                                            let _e1165 = ((_e1150.member[0].w - _e526) * _e528);
                                            let _e1175 = ((_e1150.member[1].x - _e589) * _e592);
                                            let _e1176 = ((_e1150.member[1].y - _e589) * _e592);
                                            let _e1177 = ((_e1150.member[1].z - _e590) * _e592);
                                            let _e1178 = ((_e1150.member[1].w - _e590) * _e592);
                                            let _e1188 = ((_e1150.member[2].x - _e653) * _e656);
                                            let _e1189 = ((_e1150.member[2].y - _e653) * _e656);
                                            let _e1190 = ((_e1150.member[2].z - _e654) * _e656);
                                            let _e1191 = ((_e1150.member[2].w - _e654) * _e656);
                                            let _e1193 = select(_e1190, _e1188, (_e1188 < _e1190));
                                            let _e1195 = select(_e1191, _e1189, (_e1189 < _e1191));
                                            let _e1197 = select(_e1190, _e1188, (_e1188 > _e1190));
                                            let _e1199 = select(_e1191, _e1189, (_e1189 > _e1191));
                                            let _e1201 = select(_e1164, _e1162, (_e1162 < _e1164));
                                            let _e1203 = select(_e1165, _e1163, (_e1163 < _e1165));
                                            let _e1205 = select(_e1177, _e1175, (_e1175 < _e1177));
                                            let _e1207 = select(_e1178, _e1176, (_e1176 < _e1178));
                                            let _e1209 = select(_e1205, _e1201, (_e1201 > _e1205));
                                            let _e1211 = select(_e1207, _e1203, (_e1203 > _e1207));
                                            let _e1213 = select(_e1193, _e1209, (_e1209 > _e1193));
                                            let _e1215 = select(_e1195, _e1211, (_e1211 > _e1195));
                                            let _e1217 = select(_e1164, _e1162, (_e1162 > _e1164));
                                            let _e1219 = select(_e1165, _e1163, (_e1163 > _e1165));
                                            let _e1221 = select(_e1177, _e1175, (_e1175 > _e1177));
                                            let _e1223 = select(_e1178, _e1176, (_e1176 > _e1178));
                                            let _e1225 = select(_e1221, _e1217, (_e1217 < _e1221));
                                            let _e1227 = select(_e1223, _e1219, (_e1219 < _e1223));
                                            let _e1232 = -(_e1193);
                                            let _e1233 = -(_e1195);
                                            let _e1240 = (select(_e1197, _e1225, (_e1225 < _e1197)) + (select(_e1232, _e1197, (_e1197 > _e1232)) * 0.0000019073523f));
                                            let _e1241 = (select(_e1199, _e1227, (_e1227 < _e1199)) + (select(_e1233, _e1199, (_e1199 > _e1233)) * 0.0000019073523f));
                                            let _e1243 = select(_e758, _e1213, (_e1213 > _e758));
                                            let _e1245 = select(_e758, _e1215, (_e1215 > _e758));
                                            let _e1250 = (_e1243 <= select(_e802.member, _e1240, (_e1240 < _e802.member)));
                                            let _e1251 = (_e1245 <= select(_e802.member, _e1241, (_e1241 < _e802.member)));
                                            let _e1252 = (_e1243 <= _e1245);
                                            if _e1250 {
                                                if _e1251 {
                                                    if _e1252 {
                                                        phi_4555_ = _e1150.member_2;
                                                    } else {
                                                        phi_4555_ = _e1150.member_1;
                                                    }
                                                    let _e1256 = phi_4555_;
                                                    let _e1277 = (_e845 % 128u);
                                                    let _e1278 = (_e1277 < 128u);
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1277] = _e1256.member_1;
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1277] = _e1256.member.member.x;
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1277] = _e1256.member.member.y;
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1277] = _e1256.member.member.z;
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1277] = _e1256.member.member_1.x;
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1277] = _e1256.member.member_1.y;
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1277] = _e1256.member.member_1.z;
                                                    if _e1278 {
                                                    } else {
                                                        phi_5296_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1277] = select(_e1243, _e1245, _e1252);
                                                    if _e1252 {
                                                        phi_4631_ = _e1150.member_1;
                                                    } else {
                                                        phi_4631_ = _e1150.member_2;
                                                    }
                                                    let _e1291 = phi_4631_;
                                                    phi_4632_ = _e1291;
                                                    phi_4633_ = (_e845 + 1u);
                                                } else {
                                                    phi_4632_ = type_59();
                                                    phi_4633_ = u32();
                                                }
                                                let _e1293 = phi_4632_;
                                                let _e1295 = phi_4633_;
                                                phi_4635_ = _e1293;
                                                phi_4636_ = _e1295;
                                                phi_4637_ = select(true, false, _e1251);
                                            } else {
                                                phi_4635_ = type_59();
                                                phi_4636_ = u32();
                                                phi_4637_ = true;
                                            }
                                            let _e1298 = phi_4635_;
                                            let _e1300 = phi_4636_;
                                            let _e1302 = phi_4637_;
                                            if _e1302 {
                                                if _e1250 {
                                                    phi_4646_ = _e1150.member_1;
                                                } else {
                                                    phi_4646_ = _e1150.member_2;
                                                }
                                                let _e1306 = phi_4646_;
                                                phi_4651_ = select(_e1251, true, _e1250);
                                                phi_4652_ = _e1306;
                                            } else {
                                                phi_4651_ = _e841;
                                                phi_4652_ = _e1298;
                                            }
                                            let _e1309 = phi_4651_;
                                            let _e1311 = phi_4652_;
                                            phi_5300_ = _e800;
                                            phi_4654_ = _e802;
                                            phi_4655_ = _e1309;
                                            phi_4656_ = _e1311;
                                            phi_4657_ = select(_e1300, _e845, _e1302);
                                        }
                                        let _e2454 = phi_5300_;
                                        let _e2456 = phi_4654_;
                                        let _e2458 = phi_4655_;
                                        let _e2460 = phi_4656_;
                                        let _e2462 = phi_4657_;
                                        phi_5299_ = _e2454;
                                        phi_4658_ = _e2456;
                                        phi_4659_ = _e2458;
                                        phi_4660_ = _e2460;
                                        phi_4661_ = _e2462;
                                        phi_4662_ = (_e810 - 1u);
                                    } else {
                                        phi_5299_ = _e800;
                                        phi_4658_ = _e802;
                                        phi_4659_ = _e841;
                                        phi_4660_ = _e843;
                                        phi_4661_ = _e845;
                                        phi_4662_ = _e810;
                                    }
                                    let _e2464 = phi_5299_;
                                    let _e2466 = phi_4658_;
                                    let _e2468 = phi_4659_;
                                    let _e2470 = phi_4660_;
                                    let _e2472 = phi_4661_;
                                    let _e2474 = phi_4662_;
                                    phi_5298_ = _e2464;
                                    phi_4663_ = _e2466;
                                    phi_4664_ = _e2468;
                                    phi_4665_ = _e2470;
                                    phi_4666_ = _e2472;
                                    phi_4667_ = _e2474;
                                } else {
                                    phi_5298_ = _e800;
                                    phi_4663_ = type_47();
                                    phi_4664_ = bool();
                                    phi_4665_ = type_59();
                                    phi_4666_ = u32();
                                    phi_4667_ = u32();
                                }
                                let _e2476 = phi_5298_;
                                let _e2478 = phi_4663_;
                                let _e2480 = phi_4664_;
                                let _e2482 = phi_4665_;
                                let _e2484 = phi_4666_;
                                let _e2486 = phi_4667_;
                                phi_5297_ = _e2476;
                                phi_1394_ = _e2478;
                                phi_1397_ = _e2480;
                                phi_1399_ = _e2482;
                                phi_1401_ = _e2484;
                                phi_1403_ = _e2486;
                                phi_4668_ = _e814;
                            } else {
                                phi_5297_ = _e800;
                                phi_1394_ = type_47();
                                phi_1397_ = bool();
                                phi_1399_ = type_59();
                                phi_1401_ = u32();
                                phi_1403_ = u32();
                                phi_4668_ = false;
                            }
                            let _e2488 = phi_5297_;
                            let _e2490 = phi_1394_;
                            let _e2492 = phi_1397_;
                            let _e2494 = phi_1399_;
                            let _e2496 = phi_1401_;
                            let _e2498 = phi_1403_;
                            let _e2500 = phi_4668_;
                            continue;
                            continuing {
                                phi_5070_ = _e2488;
                                phi_1393_ = _e2490;
                                phi_1396_ = _e2492;
                                phi_1398_ = _e2494;
                                phi_1400_ = _e2496;
                                phi_1402_ = _e2498;
                                phi_5296_ = _e2488;
                                break if !(_e2500);
                            }
                        }
                        let _e2503 = phi_5296_;
                        if _e2503 {
                            break;
                        }
                        let _e2505 = local_11;
                        if _e2505.member_1 {
                        } else {
                            if _e308 {
                            } else {
                                break;
                            }
                            let _e2509 = global_2.member[_e154];
                            if _e169 {
                            } else {
                                break;
                            }
                            let _e2513 = global_9.member[_e154].member_1;
                            if _e308 {
                            } else {
                                break;
                            }
                            global_2.member[_e154] = type_27(_e2509.member, _e2509.member_1, _e2509.member_2, array<f32, 3>((_e2509.member_3[0] + (_e2513[0] * _e2509.member_1[0])), (_e2509.member_3[1] + (_e2513[1] * _e2509.member_1[1])), (_e2509.member_3[2] + (_e2513[2] * _e2509.member_1[2]))), _e2509.member_4);
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
fn trace_shadows_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
