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

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_25,
    member_1: f32,
}

struct type_46 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_58 {
    member: type_37,
    member_1: u32,
}

struct type_59 {
    member: array<vec4<f32>, 3>,
    member_1: type_58,
    member_2: type_58,
}

struct type_64 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_48;
@group(0) @binding(2) 
var<uniform> global_3: type_48;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_51;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_64;
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
    var phi_449_: u32;
    var phi_493_: i32;
    var phi_633_: type_39;
    var phi_739_: i32;
    var phi_740_: i32;
    var phi_750_: bool;
    var phi_760_: u32;
    var phi_761_: u32;
    var phi_763_: bool;
    var phi_768_: u32;
    var phi_801_: i32;
    var phi_819_: f32;
    var phi_825_: f32;
    var phi_865_: f32;
    var phi_871_: f32;
    var phi_944_: f32;
    var phi_950_: f32;
    var phi_990_: f32;
    var phi_996_: f32;
    var phi_1069_: f32;
    var phi_1075_: f32;
    var phi_1115_: f32;
    var phi_1121_: f32;
    var phi_1240_: i32;
    var phi_1262_: u32;
    var phi_1263_: u32;
    var phi_1300_: i32;
    var phi_1322_: u32;
    var phi_1323_: u32;
    var phi_1331_: f32;
    var phi_1332_: f32;
    var phi_5306_: bool;
    var phi_1428_: type_43;
    var phi_1431_: bool;
    var phi_1433_: type_58;
    var phi_1435_: u32;
    var phi_1437_: u32;
    var phi_1448_: bool;
    var phi_1534_: bool;
    var phi_1535_: type_58;
    var phi_1536_: u32;
    var phi_3951_: u32;
    var phi_3957_: u32;
    var phi_4211_: u32;
    var phi_4212_: u32;
    var phi_4222_: u32;
    var phi_4224_: u32;
    var phi_4225_: bool;
    var phi_4245_: u32;
    var phi_4246_: u32;
    var phi_4250_: type_59;
    var phi_4612_: type_58;
    var phi_4688_: type_58;
    var phi_4689_: type_58;
    var phi_4690_: u32;
    var phi_4692_: type_58;
    var phi_4693_: u32;
    var phi_4694_: bool;
    var phi_4703_: type_58;
    var phi_4708_: bool;
    var phi_4709_: type_58;
    var phi_1555_: type_43;
    var phi_1558_: type_8;
    var phi_1559_: type_8;
    var phi_1581_: type_8;
    var phi_1622_: u32;
    var phi_1628_: u32;
    var phi_1638_: u32;
    var phi_1654_: u32;
    var phi_1687_: u32;
    var phi_1693_: u32;
    var phi_2159_: u32;
    var phi_2177_: u32;
    var phi_2195_: u32;
    var phi_2218_: u32;
    var phi_2236_: u32;
    var phi_2254_: u32;
    var phi_2277_: u32;
    var phi_2295_: u32;
    var phi_2313_: u32;
    var phi_1867_: u32;
    var phi_1882_: u32;
    var phi_1892_: u32;
    var phi_1913_: u32;
    var phi_1934_: u32;
    var phi_1964_: u32;
    var phi_1979_: u32;
    var phi_1989_: u32;
    var phi_2010_: u32;
    var phi_2031_: u32;
    var phi_2061_: u32;
    var phi_2076_: u32;
    var phi_2086_: u32;
    var phi_2107_: u32;
    var phi_2128_: u32;
    var phi_1720_: u32;
    var phi_1769_: u32;
    var phi_1818_: u32;
    var phi_2319_: array<array<f32, 3>, 3>;
    var phi_2849_: f32;
    var phi_2850_: f32;
    var phi_2851_: f32;
    var phi_2852_: f32;
    var phi_2853_: vec3<f32>;
    var phi_2854_: vec3<f32>;
    var phi_2855_: vec3<f32>;
    var phi_2856_: vec3<f32>;
    var phi_3047_: f32;
    var phi_3067_: type_46;
    var phi_3068_: type_46;
    var phi_3071_: type_46;
    var phi_3072_: type_46;
    var phi_3073_: bool;
    var phi_3077_: type_46;
    var phi_3086_: type_25;
    var phi_3109_: u32;
    var phi_3123_: i32;
    var phi_3145_: vec3<f32>;
    var phi_3146_: vec3<f32>;
    var phi_3164_: vec3<f32>;
    var phi_3165_: vec3<f32>;
    var phi_3183_: vec3<f32>;
    var phi_3184_: vec3<f32>;
    var phi_3220_: vec3<f32>;
    var phi_3402_: f32;
    var phi_3420_: bool;
    var phi_3421_: bool;
    var phi_3440_: bool;
    var phi_3441_: bool;
    var phi_3447_: type_43;
    var phi_3448_: type_43;
    var phi_3449_: type_43;
    var phi_1556_: type_43;
    var phi_5300_: bool;
    var local_10: type_43;
    var phi_5536_: bool;
    var phi_4711_: type_43;
    var phi_4712_: bool;
    var phi_4713_: type_58;
    var phi_4714_: u32;
    var phi_5535_: bool;
    var phi_4715_: type_43;
    var phi_4716_: bool;
    var phi_4717_: type_58;
    var phi_4718_: u32;
    var phi_4719_: u32;
    var phi_5534_: bool;
    var phi_4720_: type_43;
    var phi_4721_: bool;
    var phi_4722_: type_58;
    var phi_4723_: u32;
    var phi_4724_: u32;
    var phi_5533_: bool;
    var phi_1429_: type_43;
    var phi_1432_: bool;
    var phi_1434_: type_58;
    var phi_1436_: u32;
    var phi_1438_: u32;
    var phi_4725_: bool;
    var phi_5532_: bool;
    var local_11: type_43;
    var phi_4763_: f32;
    var phi_4765_: f32;
    var phi_4766_: bool;
    var phi_4767_: f32;
    var phi_4768_: bool;
    var phi_5208_: u32;
    var phi_5226_: bool;
    var phi_5229_: bool;
    var phi_5242_: f32;
    var phi_5243_: f32;
    var phi_5248_: f32;
    var phi_5249_: f32;
    var phi_5250_: bool;
    var phi_5258_: f32;
    var phi_4783_: f32;
    var phi_4784_: f32;
    var phi_4796_: f32;
    var phi_4801_: type_25;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e107 = global;
            let _e109 = arrayLength((&global_4.member));
            let _e112 = arrayLength((&global_10.member));
            let _e124 = arrayLength((&global_9.member));
            let _e128 = global_3.member[0u][0u];
            let _e132 = global_3.member[0u][1u];
            let _e136 = global_3.member[0u][2u];
            let _e140 = global_3.member[0u][3u];
            let _e144 = global_3.member[1u][0u];
            let _e148 = global_3.member[1u][1u];
            let _e152 = global_3.member[1u][2u];
            let _e156 = (_e107.x + (_e107.y * 2097152u));
            let _e168 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e140) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            local = array<i32, 3>(bitcast<i32>(_e144), bitcast<i32>(_e148), bitcast<i32>(_e152));
            let _e171 = (_e156 < arrayLength((&global_7.member)));
            if _e171 {
                if _e171 {
                } else {
                    break;
                }
                let _e175 = global_7.member[_e156].member_2;
                phi_449_ = _e175;
            } else {
                phi_449_ = 4294967295u;
            }
            let _e177 = phi_449_;
            let _e180 = global_1.member[0u];
            let _e184 = global_2.member[0u][0u];
            let _e188 = global_2.member[0u][1u];
            let _e192 = global_2.member[0u][2u];
            let _e196 = global_2.member[0u][3u];
            let _e200 = global_2.member[1u][0u];
            let _e204 = global_2.member[1u][1u];
            let _e208 = global_2.member[1u][2u];
            let _e212 = global_2.member[1u][3u];
            let _e213 = bitcast<f32>(_e184);
            let _e214 = bitcast<f32>(_e188);
            let _e215 = bitcast<f32>(_e192);
            let _e217 = bitcast<f32>(_e200);
            let _e218 = array<u32, 3>(_e204, _e208, _e212);
            let _e220 = bitcast<i32>(_e180);
            if (_e220 < -126i) {
                phi_493_ = -126i;
            } else {
                phi_493_ = select(_e220, 127i, (_e220 > 127i));
            }
            let _e225 = phi_493_;
            let _e230 = bitcast<f32>((bitcast<u32>((_e225 + 127i)) << bitcast<u32>(23i)));
            let _e236 = bitcast<f32>((bitcast<u32>(((_e220 - _e225) + 127i)) << bitcast<u32>(23i)));
            if (_e196 == 0u) {
                phi_633_ = type_39(array<f32, 3>(_e213, _e214, _e215), _e196, _e217, _e218);
            } else {
                let _e238 = bitcast<u32>(_e213);
                let _e240 = ((_e238 & 2139095040u) != 0u);
                let _e255 = bitcast<u32>(_e214);
                let _e257 = ((_e255 & 2139095040u) != 0u);
                let _e272 = bitcast<u32>(_e215);
                let _e274 = ((_e272 & 2139095040u) != 0u);
                let _e290 = bitcast<u32>(_e217);
                let _e292 = ((_e290 & 2139095040u) != 0u);
                phi_633_ = type_39(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e238 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e238 & 2147483648u))), _e213, _e240) * _e230) * select(0.00000011920929f, 1f, _e240)) * _e236), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e255 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e255 & 2147483648u))), _e214, _e257) * _e230) * select(0.00000011920929f, 1f, _e257)) * _e236), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e272 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e272 & 2147483648u))), _e215, _e274) * _e230) * select(0.00000011920929f, 1f, _e274)) * _e236)), _e196, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e290 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e290 & 2147483648u))), _e217, _e292) * _e230) * select(0.00000011920929f, 1f, _e292)) * _e236), _e218);
            }
            let _e309 = phi_633_;
            if _e171 {
                let _e310 = (_e156 < arrayLength((&global_8.member)));
                if _e310 {
                    if _e171 {
                    } else {
                        break;
                    }
                    let _e320 = global_7.member[_e156].member.member_2[0u];
                    let _e322 = (bitcast<u32>(_e320) & 2147483647u);
                    let _e328 = global_7.member[_e156].member.member_2[1u];
                    let _e330 = (bitcast<u32>(_e328) & 2147483647u);
                    let _e336 = global_7.member[_e156].member.member_2[2u];
                    let _e338 = (bitcast<u32>(_e336) & 2147483647u);
                    let _e344 = global_7.member[_e156].member.member[0u];
                    let _e346 = (bitcast<u32>(_e344) & 2147483647u);
                    let _e352 = global_7.member[_e156].member.member[1u];
                    let _e354 = (bitcast<u32>(_e352) & 2147483647u);
                    let _e360 = global_7.member[_e156].member.member[2u];
                    let _e362 = (bitcast<u32>(_e360) & 2147483647u);
                    let _e364 = select(_e330, _e322, (_e330 < _e322));
                    let _e366 = select(_e338, _e364, (_e338 < _e364));
                    let _e368 = select(_e346, _e366, (_e346 < _e366));
                    let _e370 = select(_e354, _e368, (_e354 < _e368));
                    let _e372 = select(_e362, _e370, (_e362 < _e370));
                    let _e377 = global_7.member[_e156].member.member_1;
                    let _e378 = bitcast<u32>(_e377);
                    let _e379 = (_e378 & 2147483647u);
                    let _e387 = global_7.member[_e156].member.member_3;
                    let _e388 = bitcast<u32>(_e387);
                    let _e389 = (_e388 & 2147483647u);
                    let _e393 = (((select(_e379, _e372, (_e379 < _e372)) < 2139095040u) && (_e389 <= 2139095040u)) && (_e366 > 0u));
                    if _e393 {
                        let _e396 = (bitcast<u32>(bitcast<f32>(_e366)) & 2147483647u);
                        if (_e396 >= 8388608u) {
                            phi_739_ = (bitcast<i32>((_e396 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_739_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e396)), 32u, (_e396 == 0u))));
                        }
                        let _e410 = phi_739_;
                        phi_740_ = _e410;
                    } else {
                        phi_740_ = 0i;
                    }
                    let _e412 = phi_740_;
                    let _e413 = (_e322 == _e366);
                    if _e413 {
                        phi_750_ = true;
                    } else {
                        phi_750_ = (_e330 == _e366);
                    }
                    let _e416 = phi_750_;
                    let _e417 = select(1u, 0u, _e413);
                    if _e416 {
                        let _e418 = (_e417 + 1u);
                        phi_760_ = _e418;
                        phi_761_ = _e418;
                        phi_763_ = select(true, false, (_e418 == 2u));
                    } else {
                        phi_760_ = u32();
                        phi_761_ = 0u;
                        phi_763_ = true;
                    }
                    let _e422 = phi_760_;
                    let _e424 = phi_761_;
                    let _e426 = phi_763_;
                    if _e426 {
                        phi_768_ = (_e424 + 1u);
                    } else {
                        phi_768_ = 0u;
                    }
                    let _e430 = phi_768_;
                    let _e431 = select(_e422, _e424, _e426);
                    let _e432 = select(_e417, select(2u, _e417, _e416), _e426);
                    let _e433 = -(_e412);
                    if (_e433 < -126i) {
                        phi_801_ = -126i;
                    } else {
                        phi_801_ = select(_e433, 127i, (_e433 > 127i));
                    }
                    let _e438 = phi_801_;
                    let _e443 = bitcast<f32>((bitcast<u32>((_e438 + 127i)) << bitcast<u32>(23i)));
                    let _e449 = bitcast<f32>((bitcast<u32>(((_e433 - _e438) + 127i)) << bitcast<u32>(23i)));
                    let _e454 = global_7.member[_e156].member.member;
                    let _e455 = (_e431 == 0u);
                    if _e455 {
                        phi_819_ = _e454[0];
                    } else {
                        phi_819_ = _e454[1];
                    }
                    let _e459 = phi_819_;
                    let _e460 = (_e431 == 2u);
                    if _e460 {
                        phi_825_ = _e454[2];
                    } else {
                        phi_825_ = _e459;
                    }
                    let _e463 = phi_825_;
                    let _e464 = bitcast<u32>(_e463);
                    let _e466 = ((_e464 & 2139095040u) != 0u);
                    let _e478 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e464 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e464 & 2147483648u))), _e463, _e466) * select(0.00000011920929f, 1f, _e466));
                    let _e479 = global_7.member[_e156].member.member_2;
                    if _e455 {
                        phi_865_ = _e479[0];
                    } else {
                        phi_865_ = _e479[1];
                    }
                    let _e483 = phi_865_;
                    if _e460 {
                        phi_871_ = _e479[2];
                    } else {
                        phi_871_ = _e483;
                    }
                    let _e486 = phi_871_;
                    let _e487 = bitcast<u32>(_e486);
                    let _e489 = ((_e487 & 2139095040u) != 0u);
                    let _e503 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e487 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e487 & 2147483648u))), _e486, _e489) * _e443) * select(0.00000011920929f, 1f, _e489)) * _e449);
                    let _e507 = (bitcast<f32>((bitcast<u32>(_e503) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e510 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
                    let _e511 = (_e510 * 0.00000011920929f);
                    let _e514 = select(select(0.00000000000011368684f, _e511, (_e511 > 0.00000000000011368684f)), 0f, _e507);
                    let _e515 = select(0f, _e503, _e507);
                    let _e516 = (_e478 + _e514);
                    let _e517 = (_e478 - _e514);
                    let _e519 = select(38685626000000000000000000f, (1f / _e503), _e507);
                    let _e520 = (_e430 == 0u);
                    if _e520 {
                        phi_944_ = _e454[0];
                    } else {
                        phi_944_ = _e454[1];
                    }
                    let _e524 = phi_944_;
                    let _e525 = (_e430 == 2u);
                    if _e525 {
                        phi_950_ = _e454[2];
                    } else {
                        phi_950_ = _e524;
                    }
                    let _e528 = phi_950_;
                    let _e529 = bitcast<u32>(_e528);
                    let _e531 = ((_e529 & 2139095040u) != 0u);
                    let _e543 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e529 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e529 & 2147483648u))), _e528, _e531) * select(0.00000011920929f, 1f, _e531));
                    if _e520 {
                        phi_990_ = _e479[0];
                    } else {
                        phi_990_ = _e479[1];
                    }
                    let _e547 = phi_990_;
                    if _e525 {
                        phi_996_ = _e479[2];
                    } else {
                        phi_996_ = _e547;
                    }
                    let _e550 = phi_996_;
                    let _e551 = bitcast<u32>(_e550);
                    let _e553 = ((_e551 & 2139095040u) != 0u);
                    let _e567 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e551 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e551 & 2147483648u))), _e550, _e553) * _e443) * select(0.00000011920929f, 1f, _e553)) * _e449);
                    let _e571 = (bitcast<f32>((bitcast<u32>(_e567) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e574 = bitcast<f32>((bitcast<u32>(_e543) & 2147483647u));
                    let _e575 = (_e574 * 0.00000011920929f);
                    let _e578 = select(select(0.00000000000011368684f, _e575, (_e575 > 0.00000000000011368684f)), 0f, _e571);
                    let _e579 = select(0f, _e567, _e571);
                    let _e580 = (_e543 + _e578);
                    let _e581 = (_e543 - _e578);
                    let _e583 = select(38685626000000000000000000f, (1f / _e567), _e571);
                    let _e584 = (_e432 == 0u);
                    if _e584 {
                        phi_1069_ = _e454[0];
                    } else {
                        phi_1069_ = _e454[1];
                    }
                    let _e588 = phi_1069_;
                    let _e589 = (_e432 == 2u);
                    if _e589 {
                        phi_1075_ = _e454[2];
                    } else {
                        phi_1075_ = _e588;
                    }
                    let _e592 = phi_1075_;
                    let _e593 = bitcast<u32>(_e592);
                    let _e595 = ((_e593 & 2139095040u) != 0u);
                    let _e607 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e593 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e593 & 2147483648u))), _e592, _e595) * select(0.00000011920929f, 1f, _e595));
                    if _e584 {
                        phi_1115_ = _e479[0];
                    } else {
                        phi_1115_ = _e479[1];
                    }
                    let _e611 = phi_1115_;
                    if _e589 {
                        phi_1121_ = _e479[2];
                    } else {
                        phi_1121_ = _e611;
                    }
                    let _e614 = phi_1121_;
                    let _e615 = bitcast<u32>(_e614);
                    let _e617 = ((_e615 & 2139095040u) != 0u);
                    let _e631 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e615 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e615 & 2147483648u))), _e614, _e617) * _e443) * select(0.00000011920929f, 1f, _e617)) * _e449);
                    let _e635 = (bitcast<f32>((bitcast<u32>(_e631) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e638 = bitcast<f32>((bitcast<u32>(_e607) & 2147483647u));
                    let _e639 = (_e638 * 0.00000011920929f);
                    let _e642 = select(select(0.00000000000011368684f, _e639, (_e639 > 0.00000000000011368684f)), 0f, _e635);
                    let _e643 = select(0f, _e631, _e635);
                    let _e644 = (_e607 + _e642);
                    let _e645 = (_e607 - _e642);
                    let _e647 = select(38685626000000000000000000f, (1f / _e631), _e635);
                    let _e649 = select(_e574, _e510, (_e510 > _e574));
                    if (_e393 && (select(_e638, _e649, (_e649 > _e638)) <= 1099511600000f)) {
                        let _e661 = ((_e379 & 8388607u) | (select(0u, 1u, ((_e379 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e664 = bitcast<i32>((_e379 >> bitcast<u32>(23i)));
                        let _e668 = (_e661 == 0u);
                        let _e671 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e661)), 32u, _e668)) - 8i);
                        if (_e664 == 255i) {
                            phi_1240_ = 255i;
                        } else {
                            phi_1240_ = (((_e664 + select(0i, 1i, (_e664 == 0i))) - _e671) + _e412);
                        }
                        let _e679 = phi_1240_;
                        let _e689 = (_e679 <= 0i);
                        if _e689 {
                            phi_1263_ = u32();
                        } else {
                            if _e668 {
                                phi_1262_ = u32();
                            } else {
                                phi_1262_ = select(((bitcast<u32>(_e679) << bitcast<u32>(23i)) | ((_e661 << bitcast<u32>(((_e671 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e679 >= 255i));
                            }
                            let _e693 = phi_1262_;
                            phi_1263_ = _e693;
                        }
                        let _e695 = phi_1263_;
                        let _e707 = ((_e389 & 8388607u) | (select(0u, 1u, ((_e389 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e710 = bitcast<i32>((_e389 >> bitcast<u32>(23i)));
                        let _e714 = (_e707 == 0u);
                        let _e717 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e707)), 32u, _e714)) - 8i);
                        if (_e710 == 255i) {
                            phi_1300_ = 255i;
                        } else {
                            phi_1300_ = (((_e710 + select(0i, 1i, (_e710 == 0i))) - _e717) + _e412);
                        }
                        let _e725 = phi_1300_;
                        let _e735 = (_e725 <= 0i);
                        if _e735 {
                            phi_1323_ = u32();
                        } else {
                            if _e714 {
                                phi_1322_ = u32();
                            } else {
                                phi_1322_ = select(((bitcast<u32>(_e725) << bitcast<u32>(23i)) | ((_e707 << bitcast<u32>(((_e717 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e725 >= 255i));
                            }
                            let _e739 = phi_1322_;
                            phi_1323_ = _e739;
                        }
                        let _e741 = phi_1323_;
                        phi_1331_ = bitcast<f32>(((_e388 & 2147483648u) | select(_e741, 0u, select(_e714, true, _e735))));
                        phi_1332_ = bitcast<f32>(((_e378 & 2147483648u) | select(_e695, 0u, select(_e668, true, _e689))));
                    } else {
                        phi_1331_ = 0f;
                        phi_1332_ = 1f;
                    }
                    let _e747 = phi_1331_;
                    let _e749 = phi_1332_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e755 = (_e431 % 3u);
                    let _e756 = (_e755 < 3u);
                    if _e756 {
                    } else {
                        break;
                    }
                    let _e758 = local_1[_e755];
                    let _e761 = (_e430 % 3u);
                    let _e762 = (_e761 < 3u);
                    if _e762 {
                    } else {
                        break;
                    }
                    let _e764 = local_1[_e761];
                    let _e767 = (_e432 % 3u);
                    let _e768 = (_e767 < 3u);
                    if _e768 {
                    } else {
                        break;
                    }
                    let _e770 = local_1[_e767];
                    if _e756 {
                    } else {
                        break;
                    }
                    let _e775 = local[_e755];
                    if _e762 {
                    } else {
                        break;
                    }
                    let _e779 = local[_e761];
                    if _e768 {
                    } else {
                        break;
                    }
                    let _e783 = local[_e767];
                    phi_5306_ = false;
                    phi_1428_ = type_43(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e747);
                    phi_1431_ = (_e749 <= _e747);
                    phi_1433_ = type_58(type_37(vec4<f32>((f32(_e758) * _e168), (f32(_e764) * _e168), (f32(_e770) * _e168), 0f), vec4<f32>((f32(_e775) * _e168), (f32(_e779) * _e168), (f32(_e783) * _e168), 0f)), select(0u, 2147483648u, (_e109 == 0u)));
                    phi_1435_ = 0u;
                    phi_1437_ = ((3u * _e109) + 1u);
                    loop {
                        let _e791 = phi_5306_;
                        let _e793 = phi_1428_;
                        let _e795 = phi_1431_;
                        let _e797 = phi_1433_;
                        let _e799 = phi_1435_;
                        let _e801 = phi_1437_;
                        local_11 = _e793;
                        if _e795 {
                            phi_1448_ = true;
                        } else {
                            phi_1448_ = (_e799 > 0u);
                        }
                        let _e804 = phi_1448_;
                        if _e804 {
                            let _e805 = (_e801 > 0u);
                            if _e805 {
                                if _e795 {
                                    phi_1534_ = _e795;
                                    phi_1535_ = _e797;
                                    phi_1536_ = _e799;
                                } else {
                                    let _e806 = (_e799 - 1u);
                                    let _e807 = (_e806 % 128u);
                                    let _e808 = (_e807 < 128u);
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e810 = local_7[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e812 = local_6[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e814 = local_5[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e816 = local_4[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e818 = local_3[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e820 = local_2[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e825 = local_8[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e828 = local_9[_e807];
                                    phi_1534_ = (_e828 <= _e793.member_1);
                                    phi_1535_ = type_58(type_37(vec4<f32>(_e810, _e812, _e814, 0f), vec4<f32>(_e816, _e818, _e820, 0f)), _e825);
                                    phi_1536_ = _e806;
                                }
                                let _e832 = phi_1534_;
                                let _e834 = phi_1535_;
                                let _e836 = phi_1536_;
                                if _e832 {
                                    let _e841 = (_e834.member_1 & 268435455u);
                                    if ((_e834.member_1 & 2147483648u) != 0u) {
                                        phi_1555_ = _e793;
                                        phi_1558_ = type_8(0u, ((_e834.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1306 = phi_1555_;
                                            let _e1308 = phi_1558_;
                                            local_10 = _e1306;
                                            local_12 = _e1306;
                                            if (_e1308.member < _e1308.member_1) {
                                                phi_1559_ = type_8((_e1308.member + 1u), _e1308.member_1);
                                                phi_1581_ = type_8(1u, _e1308.member);
                                            } else {
                                                phi_1559_ = _e1308;
                                                phi_1581_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1321 = phi_1559_;
                                            let _e1323 = phi_1581_;
                                            let _e1327 = (bitcast<i32>(_e1323.member) != 0i);
                                            if _e1327 {
                                                let _e1332 = (_e834.member.member_1.x - _e834.member.member.x);
                                                let _e1335 = (_e834.member.member_1.y - _e834.member.member.y);
                                                let _e1338 = (_e834.member.member_1.z - _e834.member.member.z);
                                                let _e1340 = select(_e1335, _e1332, (_e1332 > _e1335));
                                                let _e1342 = select(_e1338, _e1340, (_e1340 > _e1338));
                                                let _e1344 = (_e1342 < (1024f * _e168));
                                                if _e1344 {
                                                    phi_1622_ = 0u;
                                                } else {
                                                    phi_1622_ = select(2u, 1u, (_e1342 < (2097152f * _e168)));
                                                }
                                                let _e1349 = phi_1622_;
                                                switch bitcast<i32>(_e1349) {
                                                    case 0: {
                                                        phi_1628_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1628_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1628_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1628_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1352 = phi_1628_;
                                                switch bitcast<i32>(_e1349) {
                                                    case 0: {
                                                        phi_1638_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1638_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1638_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1638_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1359 = phi_1638_;
                                                let _e1361 = ((_e841 + (_e1323.member_1 * ((3u * _e1352) + 1u))) + (3u * _e1359));
                                                let _e1362 = (_e1361 < _e112);
                                                if _e1362 {
                                                    if _e1362 {
                                                    } else {
                                                        phi_5300_ = true;
                                                        break;
                                                    }
                                                    let _e1364 = global_10.member[_e1361];
                                                    phi_1654_ = _e1364;
                                                } else {
                                                    phi_1654_ = 4294967295u;
                                                }
                                                let _e1366 = phi_1654_;
                                                if _e1344 {
                                                    phi_1687_ = 0u;
                                                } else {
                                                    phi_1687_ = select(2u, 1u, (_e1342 < (2097152f * _e168)));
                                                }
                                                let _e1371 = phi_1687_;
                                                switch bitcast<i32>(_e1371) {
                                                    case 0: {
                                                        phi_1693_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1693_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1693_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1693_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1374 = phi_1693_;
                                                let _e1378 = (_e841 + (_e1323.member_1 * ((3u * _e1374) + 1u)));
                                                switch bitcast<i32>(_e1371) {
                                                    case 0: {
                                                        let _e1653 = (_e1378 < _e112);
                                                        if _e1653 {
                                                            if _e1653 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1655 = global_10.member[_e1378];
                                                            phi_1720_ = _e1655;
                                                        } else {
                                                            phi_1720_ = 0u;
                                                        }
                                                        let _e1657 = phi_1720_;
                                                        let _e1659 = ((10u * _e431) & 31u);
                                                        let _e1669 = ((10u * _e430) & 31u);
                                                        let _e1679 = ((10u * _e432) & 31u);
                                                        let _e1689 = (_e1378 + 1u);
                                                        let _e1690 = (_e1689 < _e112);
                                                        if _e1690 {
                                                            if _e1690 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1692 = global_10.member[_e1689];
                                                            phi_1769_ = _e1692;
                                                        } else {
                                                            phi_1769_ = 0u;
                                                        }
                                                        let _e1694 = phi_1769_;
                                                        let _e1720 = (_e1378 + 2u);
                                                        let _e1721 = (_e1720 < _e112);
                                                        if _e1721 {
                                                            if _e1721 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1723 = global_10.member[_e1720];
                                                            phi_1818_ = _e1723;
                                                        } else {
                                                            phi_1818_ = 0u;
                                                        }
                                                        let _e1725 = phi_1818_;
                                                        phi_2319_ = array<array<f32, 3>, 3>(array<f32, 3>((_e834.member.member.x + ((bitcast<f32>((1258291200u | ((_e1657 >> bitcast<u32>(_e1659)) & 1023u))) - 8388608f) * _e168)), (_e834.member.member.y + ((bitcast<f32>((1258291200u | ((_e1657 >> bitcast<u32>(_e1669)) & 1023u))) - 8388608f) * _e168)), (_e834.member.member.z + ((bitcast<f32>((1258291200u | ((_e1657 >> bitcast<u32>(_e1679)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e834.member.member.x + ((bitcast<f32>((1258291200u | ((_e1694 >> bitcast<u32>(_e1659)) & 1023u))) - 8388608f) * _e168)), (_e834.member.member.y + ((bitcast<f32>((1258291200u | ((_e1694 >> bitcast<u32>(_e1669)) & 1023u))) - 8388608f) * _e168)), (_e834.member.member.z + ((bitcast<f32>((1258291200u | ((_e1694 >> bitcast<u32>(_e1679)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e834.member.member.x + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1659)) & 1023u))) - 8388608f) * _e168)), (_e834.member.member.y + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1669)) & 1023u))) - 8388608f) * _e168)), (_e834.member.member.z + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1679)) & 1023u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1467 = (_e1378 < _e112);
                                                        if _e1467 {
                                                            if _e1467 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1469 = global_10.member[_e1378];
                                                            phi_1867_ = _e1469;
                                                        } else {
                                                            phi_1867_ = 0u;
                                                        }
                                                        let _e1471 = phi_1867_;
                                                        let _e1472 = (_e1378 + 1u);
                                                        let _e1473 = (_e1472 < _e112);
                                                        if _e1473 {
                                                            if _e1473 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1475 = global_10.member[_e1472];
                                                            phi_1882_ = _e1475;
                                                        } else {
                                                            phi_1882_ = 0u;
                                                        }
                                                        let _e1477 = phi_1882_;
                                                        let _e1478 = (_e431 == 1u);
                                                        if _e1478 {
                                                            phi_1892_ = ((_e1471 >> bitcast<u32>(21i)) | (_e1477 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1892_ = (_e1477 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1487 = phi_1892_;
                                                        let _e1495 = (_e430 == 1u);
                                                        if _e1495 {
                                                            phi_1913_ = ((_e1471 >> bitcast<u32>(21i)) | (_e1477 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1913_ = (_e1477 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1504 = phi_1913_;
                                                        let _e1512 = (_e432 == 1u);
                                                        if _e1512 {
                                                            phi_1934_ = ((_e1471 >> bitcast<u32>(21i)) | (_e1477 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1934_ = (_e1477 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1521 = phi_1934_;
                                                        let _e1530 = (_e1378 + 2u);
                                                        let _e1531 = (_e1530 < _e112);
                                                        if _e1531 {
                                                            if _e1531 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1533 = global_10.member[_e1530];
                                                            phi_1964_ = _e1533;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e1535 = phi_1964_;
                                                        let _e1536 = (_e1378 + 3u);
                                                        let _e1537 = (_e1536 < _e112);
                                                        if _e1537 {
                                                            if _e1537 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1539 = global_10.member[_e1536];
                                                            phi_1979_ = _e1539;
                                                        } else {
                                                            phi_1979_ = 0u;
                                                        }
                                                        let _e1541 = phi_1979_;
                                                        if _e1478 {
                                                            phi_1989_ = ((_e1535 >> bitcast<u32>(21i)) | (_e1541 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1989_ = (_e1541 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1550 = phi_1989_;
                                                        if _e1495 {
                                                            phi_2010_ = ((_e1535 >> bitcast<u32>(21i)) | (_e1541 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2010_ = (_e1541 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1566 = phi_2010_;
                                                        if _e1512 {
                                                            phi_2031_ = ((_e1535 >> bitcast<u32>(21i)) | (_e1541 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2031_ = (_e1541 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1582 = phi_2031_;
                                                        let _e1591 = (_e1378 + 4u);
                                                        let _e1592 = (_e1591 < _e112);
                                                        if _e1592 {
                                                            if _e1592 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1594 = global_10.member[_e1591];
                                                            phi_2061_ = _e1594;
                                                        } else {
                                                            phi_2061_ = 0u;
                                                        }
                                                        let _e1596 = phi_2061_;
                                                        let _e1597 = (_e1378 + 5u);
                                                        let _e1598 = (_e1597 < _e112);
                                                        if _e1598 {
                                                            if _e1598 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1600 = global_10.member[_e1597];
                                                            phi_2076_ = _e1600;
                                                        } else {
                                                            phi_2076_ = 0u;
                                                        }
                                                        let _e1602 = phi_2076_;
                                                        if _e1478 {
                                                            phi_2086_ = ((_e1596 >> bitcast<u32>(21i)) | (_e1602 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2086_ = (_e1602 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1611 = phi_2086_;
                                                        if _e1495 {
                                                            phi_2107_ = ((_e1596 >> bitcast<u32>(21i)) | (_e1602 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2107_ = (_e1602 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1627 = phi_2107_;
                                                        if _e1512 {
                                                            phi_2128_ = ((_e1596 >> bitcast<u32>(21i)) | (_e1602 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2128_ = (_e1602 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1643 = phi_2128_;
                                                        phi_2319_ = array<array<f32, 3>, 3>(array<f32, 3>((_e834.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1487, _e1471, _e455) & 2097151u))) - 8388608f) * _e168)), (_e834.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1504, _e1471, _e520) & 2097151u))) - 8388608f) * _e168)), (_e834.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1521, _e1471, _e584) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e834.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1550, _e1535, _e455) & 2097151u))) - 8388608f) * _e168)), (_e834.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1566, _e1535, _e520) & 2097151u))) - 8388608f) * _e168)), (_e834.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1582, _e1535, _e584) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e834.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1611, _e1596, _e455) & 2097151u))) - 8388608f) * _e168)), (_e834.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1627, _e1596, _e520) & 2097151u))) - 8388608f) * _e168)), (_e834.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1643, _e1596, _e584) & 2097151u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1380 = (_e1378 + _e431);
                                                        let _e1381 = (_e1380 < _e112);
                                                        if _e1381 {
                                                            if _e1381 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1383 = global_10.member[_e1380];
                                                            phi_2159_ = _e1383;
                                                        } else {
                                                            phi_2159_ = 0u;
                                                        }
                                                        let _e1385 = phi_2159_;
                                                        let _e1389 = (_e1378 + _e430);
                                                        let _e1390 = (_e1389 < _e112);
                                                        if _e1390 {
                                                            if _e1390 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1392 = global_10.member[_e1389];
                                                            phi_2177_ = _e1392;
                                                        } else {
                                                            phi_2177_ = 0u;
                                                        }
                                                        let _e1394 = phi_2177_;
                                                        let _e1398 = (_e1378 + _e432);
                                                        let _e1399 = (_e1398 < _e112);
                                                        if _e1399 {
                                                            if _e1399 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1401 = global_10.member[_e1398];
                                                            phi_2195_ = _e1401;
                                                        } else {
                                                            phi_2195_ = 0u;
                                                        }
                                                        let _e1403 = phi_2195_;
                                                        let _e1408 = (_e1378 + 3u);
                                                        let _e1409 = (_e1408 + _e431);
                                                        let _e1410 = (_e1409 < _e112);
                                                        if _e1410 {
                                                            if _e1410 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1412 = global_10.member[_e1409];
                                                            phi_2218_ = _e1412;
                                                        } else {
                                                            phi_2218_ = 0u;
                                                        }
                                                        let _e1414 = phi_2218_;
                                                        let _e1418 = (_e1408 + _e430);
                                                        let _e1419 = (_e1418 < _e112);
                                                        if _e1419 {
                                                            if _e1419 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1421 = global_10.member[_e1418];
                                                            phi_2236_ = _e1421;
                                                        } else {
                                                            phi_2236_ = 0u;
                                                        }
                                                        let _e1423 = phi_2236_;
                                                        let _e1427 = (_e1408 + _e432);
                                                        let _e1428 = (_e1427 < _e112);
                                                        if _e1428 {
                                                            if _e1428 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1430 = global_10.member[_e1427];
                                                            phi_2254_ = _e1430;
                                                        } else {
                                                            phi_2254_ = 0u;
                                                        }
                                                        let _e1432 = phi_2254_;
                                                        let _e1437 = (_e1378 + 6u);
                                                        let _e1438 = (_e1437 + _e431);
                                                        let _e1439 = (_e1438 < _e112);
                                                        if _e1439 {
                                                            if _e1439 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1441 = global_10.member[_e1438];
                                                            phi_2277_ = _e1441;
                                                        } else {
                                                            phi_2277_ = 0u;
                                                        }
                                                        let _e1443 = phi_2277_;
                                                        let _e1447 = (_e1437 + _e430);
                                                        let _e1448 = (_e1447 < _e112);
                                                        if _e1448 {
                                                            if _e1448 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1450 = global_10.member[_e1447];
                                                            phi_2295_ = _e1450;
                                                        } else {
                                                            phi_2295_ = 0u;
                                                        }
                                                        let _e1452 = phi_2295_;
                                                        let _e1456 = (_e1437 + _e432);
                                                        let _e1457 = (_e1456 < _e112);
                                                        if _e1457 {
                                                            if _e1457 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1459 = global_10.member[_e1456];
                                                            phi_2313_ = _e1459;
                                                        } else {
                                                            phi_2313_ = 0u;
                                                        }
                                                        let _e1461 = phi_2313_;
                                                        phi_2319_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1385)) * _e168), (f32(bitcast<i32>(_e1394)) * _e168), (f32(bitcast<i32>(_e1403)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e1414)) * _e168), (f32(bitcast<i32>(_e1423)) * _e168), (f32(bitcast<i32>(_e1432)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e1443)) * _e168), (f32(bitcast<i32>(_e1452)) * _e168), (f32(bitcast<i32>(_e1461)) * _e168)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2319_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1753 = phi_2319_;
                                                let _e1769 = (_e1753[0][2] - _e607);
                                                let _e1772 = (((_e1753[0][0] - _e478) * _e643) - (_e1769 * _e515));
                                                let _e1775 = (((_e1753[0][1] - _e543) * _e643) - (_e1769 * _e579));
                                                let _e1778 = (_e1753[1][2] - _e607);
                                                let _e1781 = (((_e1753[1][0] - _e478) * _e643) - (_e1778 * _e515));
                                                let _e1784 = (((_e1753[1][1] - _e543) * _e643) - (_e1778 * _e579));
                                                let _e1787 = (_e1753[2][2] - _e607);
                                                let _e1790 = (((_e1753[2][0] - _e478) * _e643) - (_e1787 * _e515));
                                                let _e1793 = (((_e1753[2][1] - _e543) * _e643) - (_e1787 * _e579));
                                                let _e1794 = (_e1790 * _e1784);
                                                let _e1795 = (_e1793 * _e1781);
                                                let _e1796 = (_e1772 * _e1793);
                                                let _e1797 = (_e1775 * _e1790);
                                                let _e1798 = (_e1781 * _e1775);
                                                let _e1799 = (_e1784 * _e1772);
                                                let _e1804 = (((_e1794 >= _e1795) && (_e1796 >= _e1797)) && (_e1798 >= _e1799));
                                                let _e1810 = (_e1804 || (((_e1794 <= _e1795) && (_e1796 <= _e1797)) && (_e1798 <= _e1799)));
                                                if _e1810 {
                                                    let _e1812 = select(-1f, 1f, _e1804);
                                                    let _e1814 = ((_e1794 - _e1795) * _e1812);
                                                    let _e1816 = select(0f, _e1814, (_e1814 > 0f));
                                                    let _e1818 = ((_e1796 - _e1797) * _e1812);
                                                    let _e1820 = select(0f, _e1818, (_e1818 > 0f));
                                                    let _e1822 = ((_e1798 - _e1799) * _e1812);
                                                    let _e1824 = select(0f, _e1822, (_e1822 > 0f));
                                                    let _e1826 = ((_e1816 + _e1820) + _e1824);
                                                    let _e1828 = select(_e1753[1][0], _e1753[0][0], (_e1753[0][0] < _e1753[1][0]));
                                                    let _e1832 = select(_e1753[1][0], _e1753[0][0], (_e1753[0][0] > _e1753[1][0]));
                                                    let _e1836 = select(_e1753[1][1], _e1753[0][1], (_e1753[0][1] < _e1753[1][1]));
                                                    let _e1840 = select(_e1753[1][1], _e1753[0][1], (_e1753[0][1] > _e1753[1][1]));
                                                    let _e1844 = select(_e1753[1][2], _e1753[0][2], (_e1753[0][2] < _e1753[1][2]));
                                                    let _e1848 = select(_e1753[1][2], _e1753[0][2], (_e1753[0][2] > _e1753[1][2]));
                                                    let _e1853 = ((select(_e1753[2][0], _e1828, (_e1828 < _e1753[2][0])) - _e516) * _e519);
                                                    let _e1854 = ((select(_e1753[2][0], _e1832, (_e1832 > _e1753[2][0])) - _e517) * _e519);
                                                    let _e1857 = ((select(_e1753[2][1], _e1836, (_e1836 < _e1753[2][1])) - _e580) * _e583);
                                                    let _e1858 = ((select(_e1753[2][1], _e1840, (_e1840 > _e1753[2][1])) - _e581) * _e583);
                                                    let _e1861 = ((select(_e1753[2][2], _e1844, (_e1844 < _e1753[2][2])) - _e644) * _e647);
                                                    let _e1862 = ((select(_e1753[2][2], _e1848, (_e1848 > _e1753[2][2])) - _e645) * _e647);
                                                    let _e1864 = select(_e1862, _e1861, (_e1861 < _e1862));
                                                    let _e1866 = select(_e1862, _e1861, (_e1861 > _e1862));
                                                    let _e1868 = select(_e1854, _e1853, (_e1853 < _e1854));
                                                    let _e1870 = select(_e1858, _e1857, (_e1857 < _e1858));
                                                    let _e1872 = select(_e1870, _e1868, (_e1868 > _e1870));
                                                    let _e1874 = select(_e1864, _e1872, (_e1872 > _e1864));
                                                    let _e1876 = select(_e1854, _e1853, (_e1853 > _e1854));
                                                    let _e1878 = select(_e1858, _e1857, (_e1857 > _e1858));
                                                    let _e1880 = select(_e1878, _e1876, (_e1876 < _e1878));
                                                    let _e1882 = select(_e1866, _e1880, (_e1880 < _e1866));
                                                    let _e1883 = -(_e1864);
                                                    let _e1889 = select(_e749, _e1874, (_e1874 > _e749));
                                                    let _e1893 = select(_e1781, _e1772, (_e1772 < _e1781));
                                                    let _e1898 = select(_e1781, _e1772, (_e1772 > _e1781));
                                                    let _e1905 = select(_e1784, _e1775, (_e1775 < _e1784));
                                                    let _e1910 = select(_e1784, _e1775, (_e1775 > _e1784));
                                                    let _e1919 = (((((_e1810 && (_e1826 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1790, _e1893, (_e1893 < _e1790)) <= 0f) && (select(_e1790, _e1898, (_e1898 > _e1790)) >= 0f))) && ((select(_e1793, _e1905, (_e1905 < _e1793)) <= 0f) && (select(_e1793, _e1910, (_e1910 > _e1793)) >= 0f))) && (_e1889 <= (_e1882 + (select(_e1883, _e1866, (_e1866 > _e1883)) * 0.0000019073523f)))) && (_e1889 <= _e1306.member_1));
                                                    if _e1919 {
                                                        let _e1924 = (_e1753[1][0] - _e1753[0][0]);
                                                        let _e1925 = (_e1753[1][1] - _e1753[0][1]);
                                                        let _e1926 = (_e1753[1][2] - _e1753[0][2]);
                                                        let _e1927 = vec3<f32>(_e1924, _e1925, _e1926);
                                                        let _e1928 = (_e1753[2][0] - _e1753[1][0]);
                                                        let _e1929 = (_e1753[2][1] - _e1753[1][1]);
                                                        let _e1930 = (_e1753[2][2] - _e1753[1][2]);
                                                        let _e1931 = vec3<f32>(_e1928, _e1929, _e1930);
                                                        let _e1932 = (_e1753[0][0] - _e1753[2][0]);
                                                        let _e1933 = (_e1753[0][1] - _e1753[2][1]);
                                                        let _e1934 = (_e1753[0][2] - _e1753[2][2]);
                                                        let _e1935 = vec3<f32>(_e1932, _e1933, _e1934);
                                                        let _e1938 = bitcast<f32>((bitcast<u32>(_e1924) & 2147483647u));
                                                        let _e1941 = bitcast<f32>((bitcast<u32>(_e1925) & 2147483647u));
                                                        let _e1943 = select(_e1941, _e1938, (_e1938 > _e1941));
                                                        let _e1946 = bitcast<f32>((bitcast<u32>(_e1926) & 2147483647u));
                                                        let _e1948 = select(_e1946, _e1943, (_e1943 > _e1946));
                                                        let _e1951 = bitcast<f32>((bitcast<u32>(_e1928) & 2147483647u));
                                                        let _e1954 = bitcast<f32>((bitcast<u32>(_e1929) & 2147483647u));
                                                        let _e1956 = select(_e1954, _e1951, (_e1951 > _e1954));
                                                        let _e1959 = bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u));
                                                        let _e1961 = select(_e1959, _e1956, (_e1956 > _e1959));
                                                        let _e1964 = bitcast<f32>((bitcast<u32>(_e1932) & 2147483647u));
                                                        let _e1967 = bitcast<f32>((bitcast<u32>(_e1933) & 2147483647u));
                                                        let _e1969 = select(_e1967, _e1964, (_e1964 > _e1967));
                                                        let _e1972 = bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u));
                                                        let _e1974 = select(_e1972, _e1969, (_e1969 > _e1972));
                                                        let _e1976 = select(_e1961, _e1948, (_e1948 > _e1961));
                                                        let _e1978 = select(_e1974, _e1976, (_e1976 > _e1974));
                                                        if (_e1948 == _e1978) {
                                                            phi_2849_ = _e1784;
                                                            phi_2850_ = _e1781;
                                                            phi_2851_ = _e1775;
                                                            phi_2852_ = _e1772;
                                                            phi_2853_ = vec3<f32>(_e1753[0][0], _e1753[0][1], _e1753[0][2]);
                                                            phi_2854_ = _e1935;
                                                            phi_2855_ = _e1931;
                                                            phi_2856_ = _e1927;
                                                        } else {
                                                            let _e1980 = (_e1961 == _e1978);
                                                            let _e1985 = vec3(_e1980);
                                                            phi_2849_ = select(_e1775, _e1793, _e1980);
                                                            phi_2850_ = select(_e1772, _e1790, _e1980);
                                                            phi_2851_ = select(_e1793, _e1784, _e1980);
                                                            phi_2852_ = select(_e1790, _e1781, _e1980);
                                                            phi_2853_ = select(vec3<f32>(_e1753[2][0], _e1753[2][1], _e1753[2][2]), vec3<f32>(_e1753[1][0], _e1753[1][1], _e1753[1][2]), _e1985);
                                                            phi_2854_ = select(_e1931, _e1927, _e1985);
                                                            phi_2855_ = select(_e1927, _e1935, _e1985);
                                                            phi_2856_ = select(_e1935, _e1931, _e1985);
                                                        }
                                                        let _e1991 = phi_2849_;
                                                        let _e1993 = phi_2850_;
                                                        let _e1995 = phi_2851_;
                                                        let _e1997 = phi_2852_;
                                                        let _e1999 = phi_2853_;
                                                        let _e2001 = phi_2854_;
                                                        let _e2003 = phi_2855_;
                                                        let _e2005 = phi_2856_;
                                                        let _e2012 = ((_e2003.y * _e2001.z) - (_e2001.y * _e2003.z));
                                                        let _e2017 = ((_e2003.z * _e2001.x) - (_e2001.z * _e2003.x));
                                                        let _e2020 = ((_e2003.x * _e2001.y) - (_e2001.x * _e2003.y));
                                                        let _e2023 = ((_e1816 >= _e1820) && (_e1816 >= _e1824));
                                                        let _e2024 = (_e1820 >= _e1824);
                                                        let _e2038 = (((_e2012 * (select(select(_e1753[2][0], _e1753[1][0], _e2024), _e1753[0][0], _e2023) - _e478)) + (_e2017 * (select(select(_e1753[2][1], _e1753[1][1], _e2024), _e1753[0][1], _e2023) - _e543))) + (_e2020 * (select(select(_e1753[2][2], _e1753[1][2], _e2024), _e1753[0][2], _e2023) - _e607)));
                                                        let _e2043 = (((_e2012 * _e515) + (_e2017 * _e579)) + (_e2020 * _e643));
                                                        let _e2044 = (_e1993 - _e1997);
                                                        let _e2045 = (_e1991 - _e1995);
                                                        let _e2048 = ((_e2044 * _e2044) + (_e2045 * _e2045));
                                                        let _e2055 = (-(((_e1997 * _e2044) + (_e1995 * _e2045))) / select(0.000000000000000000000000000000000000011754944f, _e2048, (_e2048 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e2057 = select(1f, _e2055, (_e2055 < 1f));
                                                        let _e2059 = select(0f, _e2057, (_e2057 > 0f));
                                                        let _e2068 = ((_e1999.x + (_e2005.x * _e2059)) - _e478);
                                                        let _e2071 = ((_e1999.y + (_e2005.y * _e2059)) - _e543);
                                                        let _e2074 = ((_e1999.z + (_e2005.z * _e2059)) - _e607);
                                                        let _e2077 = bitcast<f32>((bitcast<u32>(_e2068) & 2147483647u));
                                                        let _e2080 = bitcast<f32>((bitcast<u32>(_e2071) & 2147483647u));
                                                        let _e2082 = select(_e2080, _e2077, (_e2077 > _e2080));
                                                        let _e2085 = bitcast<f32>((bitcast<u32>(_e2074) & 2147483647u));
                                                        let _e2087 = select(_e2085, _e2082, (_e2082 > _e2085));
                                                        let _e2093 = bitcast<f32>((bitcast<u32>(_e2012) & 2147483647u));
                                                        let _e2096 = bitcast<f32>((bitcast<u32>(_e2017) & 2147483647u));
                                                        let _e2098 = select(_e2096, _e2093, (_e2093 > _e2096));
                                                        let _e2101 = bitcast<f32>((bitcast<u32>(_e2020) & 2147483647u));
                                                        let _e2120 = bitcast<f32>((bitcast<u32>(_e2003.x) & 2147483647u));
                                                        let _e2123 = bitcast<f32>((bitcast<u32>(_e2003.y) & 2147483647u));
                                                        let _e2125 = select(_e2123, _e2120, (_e2120 > _e2123));
                                                        let _e2128 = bitcast<f32>((bitcast<u32>(_e2003.z) & 2147483647u));
                                                        let _e2134 = bitcast<f32>((bitcast<u32>(_e2001.x) & 2147483647u));
                                                        let _e2137 = bitcast<f32>((bitcast<u32>(_e2001.y) & 2147483647u));
                                                        let _e2139 = select(_e2137, _e2134, (_e2134 > _e2137));
                                                        let _e2142 = bitcast<f32>((bitcast<u32>(_e2001.z) & 2147483647u));
                                                        let _e2148 = ((bitcast<f32>((bitcast<u32>(((((_e2012 * _e2068) + (_e2017 * _e2071)) + (_e2020 * _e2074)) - _e2038)) & 2147483647u)) <= ((0.0000009536743f * select(_e1978, _e2087, (_e2087 > _e1978))) * select(_e2101, _e2098, (_e2098 > _e2101)))) && !((bitcast<f32>((bitcast<u32>(_e2043) & 2147483647u)) <= ((0.0000038146973f * select(_e2128, _e2125, (_e2125 > _e2128))) * select(_e2142, _e2139, (_e2139 > _e2142))))));
                                                        let _e2149 = (_e2038 / _e2043);
                                                        if (_e1919 && !(_e2148)) {
                                                            let _e2152 = (_e2074 / _e643);
                                                            let _e2160 = (((_e2012 * (_e2068 - (_e515 * _e2152))) + (_e2017 * (_e2071 - (_e579 * _e2152)))) / _e2043);
                                                            phi_3047_ = select(select(_e2152, (_e2152 + _e2160), (bitcast<f32>((bitcast<u32>(_e2160) & 2147483647u)) <= _e1978)), _e2149, _e2148);
                                                        } else {
                                                            phi_3047_ = _e2149;
                                                        }
                                                        let _e2169 = phi_3047_;
                                                        let _e2171 = select(_e1882, _e2169, (_e2169 < _e1882));
                                                        let _e2173 = select(_e1874, _e2171, (_e2171 > _e1874));
                                                        let _e2174 = (1f / _e1826);
                                                        phi_3067_ = type_46(_e2173, (_e1820 * _e2174), (_e1824 * _e2174), ((_e1919 && (_e2173 >= _e749)) && (_e2173 <= _e1306.member_1)));
                                                        phi_3068_ = type_46();
                                                    } else {
                                                        phi_3067_ = type_46();
                                                        phi_3068_ = type_46(0f, 0f, 0f, _e1919);
                                                    }
                                                    let _e2183 = phi_3067_;
                                                    let _e2185 = phi_3068_;
                                                    phi_3071_ = _e2183;
                                                    phi_3072_ = _e2185;
                                                    phi_3073_ = select(true, false, _e1919);
                                                } else {
                                                    phi_3071_ = type_46();
                                                    phi_3072_ = type_46(0f, 0f, 0f, _e1810);
                                                    phi_3073_ = true;
                                                }
                                                let _e2188 = phi_3071_;
                                                let _e2190 = phi_3072_;
                                                let _e2192 = phi_3073_;
                                                if _e2192 {
                                                    phi_3077_ = _e2190;
                                                } else {
                                                    phi_3077_ = _e2188;
                                                }
                                                let _e2194 = phi_3077_;
                                                if _e2194.member_3 {
                                                    phi_3086_ = type_25(_e2194.member, _e2194.member_1, _e2194.member_2, _e1366);
                                                } else {
                                                    phi_3086_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2201 = phi_3086_;
                                                if (_e2201.member_3 != 4294967295u) {
                                                    if (_e1366 == _e177) {
                                                        phi_3421_ = false;
                                                    } else {
                                                        let _e2205 = (_e1366 < arrayLength((&global_5.member)));
                                                        if _e2205 {
                                                            if _e2205 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e2207 = global_5.member[_e1366];
                                                            phi_3109_ = _e2207;
                                                        } else {
                                                            phi_3109_ = 4294967295u;
                                                        }
                                                        let _e2209 = phi_3109_;
                                                        let _e2210 = (_e2209 < arrayLength((&global_6.member)));
                                                        if _e2210 {
                                                            if _e2210 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e2212 = global_6.member[_e2209];
                                                            phi_3123_ = _e2212;
                                                        } else {
                                                            phi_3123_ = 0i;
                                                        }
                                                        let _e2214 = phi_3123_;
                                                        let _e2215 = (_e2214 == 0i);
                                                        if _e2215 {
                                                            phi_3420_ = true;
                                                        } else {
                                                            if _e455 {
                                                                phi_3146_ = vec3<f32>(_e1753[0][0], _e1753[0][1], _e1753[0][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3145_ = vec3<f32>(_e1753[0][2], _e1753[0][0], _e1753[0][1]);
                                                                } else {
                                                                    phi_3145_ = vec3<f32>(_e1753[0][1], _e1753[0][2], _e1753[0][0]);
                                                                }
                                                                let _e2220 = phi_3145_;
                                                                phi_3146_ = _e2220;
                                                            }
                                                            let _e2223 = phi_3146_;
                                                            if _e455 {
                                                                phi_3165_ = vec3<f32>(_e1753[1][0], _e1753[1][1], _e1753[1][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3164_ = vec3<f32>(_e1753[1][2], _e1753[1][0], _e1753[1][1]);
                                                                } else {
                                                                    phi_3164_ = vec3<f32>(_e1753[1][1], _e1753[1][2], _e1753[1][0]);
                                                                }
                                                                let _e2228 = phi_3164_;
                                                                phi_3165_ = _e2228;
                                                            }
                                                            let _e2231 = phi_3165_;
                                                            if _e455 {
                                                                phi_3184_ = vec3<f32>(_e1753[2][0], _e1753[2][1], _e1753[2][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3183_ = vec3<f32>(_e1753[2][2], _e1753[2][0], _e1753[2][1]);
                                                                } else {
                                                                    phi_3183_ = vec3<f32>(_e1753[2][1], _e1753[2][2], _e1753[2][0]);
                                                                }
                                                                let _e2236 = phi_3183_;
                                                                phi_3184_ = _e2236;
                                                            }
                                                            let _e2239 = phi_3184_;
                                                            let _e2242 = (_e2231.x - _e2223.x);
                                                            let _e2245 = (_e2231.y - _e2223.y);
                                                            let _e2248 = (_e2231.z - _e2223.z);
                                                            let _e2250 = (_e2239.x - _e2223.x);
                                                            let _e2252 = (_e2239.y - _e2223.y);
                                                            let _e2254 = (_e2239.z - _e2223.z);
                                                            if (_e309.member_1 == 1u) {
                                                                phi_3220_ = (vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]) - _e2223);
                                                            } else {
                                                                phi_3220_ = vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]);
                                                            }
                                                            let _e2269 = phi_3220_;
                                                            let _e2275 = bitcast<f32>((bitcast<u32>((_e2242 * _e2252)) ^ _e309.member_3[0]));
                                                            let _e2279 = bitcast<f32>((bitcast<u32>((_e2245 * _e2250)) ^ _e309.member_3[0]));
                                                            let _e2283 = bitcast<f32>((bitcast<u32>((_e2245 * _e2254)) ^ _e309.member_3[0]));
                                                            let _e2287 = bitcast<f32>((bitcast<u32>((_e2248 * _e2252)) ^ _e309.member_3[0]));
                                                            let _e2291 = bitcast<f32>((bitcast<u32>((_e2248 * _e2250)) ^ _e309.member_3[0]));
                                                            let _e2295 = bitcast<f32>((bitcast<u32>((_e2242 * _e2254)) ^ _e309.member_3[0]));
                                                            let _e2296 = (_e2283 - _e2287);
                                                            let _e2297 = (_e2291 - _e2295);
                                                            let _e2298 = (_e2275 - _e2279);
                                                            let _e2322 = (bitcast<f32>((bitcast<u32>(_e2283) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2287) & 2147483647u)));
                                                            let _e2329 = (bitcast<f32>((bitcast<u32>(_e2291) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2295) & 2147483647u)));
                                                            let _e2336 = (bitcast<f32>((bitcast<u32>(_e2275) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2279) & 2147483647u)));
                                                            if (_e309.member_2 == 0f) {
                                                                phi_3402_ = 0f;
                                                            } else {
                                                                let _e2366 = bitcast<f32>((bitcast<u32>(_e2296) & 2147483647u));
                                                                let _e2369 = bitcast<f32>((bitcast<u32>(_e2297) & 2147483647u));
                                                                let _e2372 = bitcast<f32>((bitcast<u32>(_e2298) & 2147483647u));
                                                                let _e2374 = select(_e2372, _e2369, (_e2369 > _e2372));
                                                                let _e2378 = select(_e2372, _e2369, (_e2369 < _e2372));
                                                                let _e2382 = select(_e2369, _e2366, (_e2366 < _e2369));
                                                                let _e2384 = select(_e2369, _e2366, (_e2366 > _e2369));
                                                                let _e2386 = select(_e2372, _e2384, (_e2384 < _e2372));
                                                                phi_3402_ = bitcast<f32>((bitcast<u32>((_e309.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2374, _e2366, (_e2366 > _e2374)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2386, _e2382, (_e2382 > _e2386)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2378, _e2366, (_e2366 < _e2378)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2322 + _e2329) + _e2336))) ^ _e309.member_3[0]))) * 1.0000005f)) ^ _e309.member_3[0])))) ^ _e309.member_3[0]));
                                                            }
                                                            let _e2413 = phi_3402_;
                                                            phi_3420_ = (_e2215 || !(((((bitcast<f32>((bitcast<u32>((_e2269.x * _e2296)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2269.y * _e2297)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2269.z * _e2298)) ^ _e309.member_3[0]))) * f32(-(_e2214))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2269.x) & 2147483647u)) * _e2322)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2269.y) & 2147483647u)) * _e2329)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2269.z) & 2147483647u)) * _e2336)) ^ _e309.member_3[0]))))) ^ _e309.member_3[0])) + _e2413) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2427 = phi_3420_;
                                                        phi_3421_ = _e2427;
                                                    }
                                                    let _e2429 = phi_3421_;
                                                    if _e2429 {
                                                        if (_e2201.member < _e1306.member.member) {
                                                            phi_3441_ = true;
                                                        } else {
                                                            if (_e2201.member == _e1306.member.member) {
                                                                phi_3440_ = (_e2201.member_3 < _e1306.member.member_3);
                                                            } else {
                                                                phi_3440_ = false;
                                                            }
                                                            let _e2439 = phi_3440_;
                                                            phi_3441_ = _e2439;
                                                        }
                                                        let _e2441 = phi_3441_;
                                                        if _e2441 {
                                                            phi_3447_ = type_43(_e2201, _e2201.member);
                                                        } else {
                                                            phi_3447_ = _e1306;
                                                        }
                                                        let _e2444 = phi_3447_;
                                                        phi_3448_ = _e2444;
                                                    } else {
                                                        phi_3448_ = _e1306;
                                                    }
                                                    let _e2446 = phi_3448_;
                                                    phi_3449_ = _e2446;
                                                } else {
                                                    phi_3449_ = _e1306;
                                                }
                                                let _e2448 = phi_3449_;
                                                phi_1556_ = _e2448;
                                            } else {
                                                phi_1556_ = type_43();
                                            }
                                            let _e2450 = phi_1556_;
                                            continue;
                                            continuing {
                                                phi_1555_ = _e2450;
                                                phi_1558_ = _e1321;
                                                phi_5300_ = _e791;
                                                break if !(_e1327);
                                            }
                                        }
                                        let _e2453 = phi_5300_;
                                        phi_5532_ = _e2453;
                                        if _e2453 {
                                            break;
                                        }
                                        let _e2455 = local_10;
                                        phi_5536_ = _e2453;
                                        let _e2801 = local_12;
                                        phi_4711_ = _e2801;
                                        phi_4712_ = false;
                                        phi_4713_ = _e834;
                                        phi_4714_ = select(_e836, 0u, (_e749 > _e2455.member_1));
                                    } else {
                                        if (_e834.member_1 >= _e109) {
                                            phi_4250_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e834.member_1 < _e109) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e849 = ((1u + _e431) % 4u);
                                            if (_e849 < 4u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e854 = global_4.member[_e834.member_1][_e849];
                                            let _e856 = (_e854 >> bitcast<u32>(11u));
                                            let _e858 = ((1u + _e430) % 4u);
                                            if (_e858 < 4u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e863 = global_4.member[_e834.member_1][_e858];
                                            let _e865 = (_e863 >> bitcast<u32>(11u));
                                            let _e867 = ((1u + _e432) % 4u);
                                            if (_e867 < 4u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e872 = global_4.member[_e834.member_1][_e867];
                                            let _e874 = (_e872 >> bitcast<u32>(11u));
                                            let _e897 = (bitcast<f32>((bitcast<u32>((_e834.member.member_1.x - _e834.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e898 = (bitcast<f32>((bitcast<u32>((_e834.member.member_1.y - _e834.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e899 = (bitcast<f32>((bitcast<u32>((_e834.member.member_1.z - _e834.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e901 = select(_e168, _e897, (_e897 > _e168));
                                            let _e903 = select(_e168, _e898, (_e898 > _e168));
                                            let _e905 = select(_e168, _e899, (_e899 > _e168));
                                            let _e936 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e854 & 1023u))) - 8388608f) * _e901));
                                            let _e941 = (bitcast<i32>((_e854 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e944 = bitcast<f32>((_e936 & bitcast<u32>(_e941)));
                                            let _e945 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e863 & 1023u))) - 8388608f) * _e903));
                                            let _e950 = (bitcast<i32>((_e863 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e953 = bitcast<f32>((_e945 & bitcast<u32>(_e950)));
                                            let _e954 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e872 & 1023u))) - 8388608f) * _e905));
                                            let _e959 = (bitcast<i32>((_e872 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e962 = bitcast<f32>((_e954 & bitcast<u32>(_e959)));
                                            let _e966 = bitcast<f32>((_e936 & bitcast<u32>(~(_e941))));
                                            let _e970 = bitcast<f32>((_e945 & bitcast<u32>(~(_e950))));
                                            let _e974 = bitcast<f32>((_e954 & bitcast<u32>(~(_e959))));
                                            let _e975 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e856 & 1023u))) - 8388608f) * _e901));
                                            let _e980 = (bitcast<i32>((_e856 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e983 = bitcast<f32>((_e975 & bitcast<u32>(_e980)));
                                            let _e984 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e865 & 1023u))) - 8388608f) * _e903));
                                            let _e989 = (bitcast<i32>((_e865 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e992 = bitcast<f32>((_e984 & bitcast<u32>(_e989)));
                                            let _e993 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e874 & 1023u))) - 8388608f) * _e905));
                                            let _e998 = (bitcast<i32>((_e874 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1001 = bitcast<f32>((_e993 & bitcast<u32>(_e998)));
                                            let _e1005 = bitcast<f32>((_e975 & bitcast<u32>(~(_e980))));
                                            let _e1009 = bitcast<f32>((_e984 & bitcast<u32>(~(_e989))));
                                            let _e1013 = bitcast<f32>((_e993 & bitcast<u32>(~(_e998))));
                                            let _e1014 = (_e834.member.member.x + _e944);
                                            let _e1015 = (_e834.member.member.y + _e953);
                                            let _e1016 = (_e834.member.member.z + _e962);
                                            let _e1019 = (_e834.member.member_1.x - _e983);
                                            let _e1020 = (_e834.member.member_1.y - _e992);
                                            let _e1021 = (_e834.member.member_1.z - _e1001);
                                            let _e1040 = (_e1019 - _e1014);
                                            let _e1041 = (_e1020 - _e1015);
                                            let _e1042 = (_e1021 - _e1016);
                                            let _e1044 = select(_e1041, _e1040, (_e1040 > _e1041));
                                            let _e1046 = select(_e1042, _e1044, (_e1044 > _e1042));
                                            if (_e1046 < (1024f * _e168)) {
                                                phi_3951_ = 0u;
                                            } else {
                                                phi_3951_ = select(2u, 1u, (_e1046 < (2097152f * _e168)));
                                            }
                                            let _e1053 = phi_3951_;
                                            switch bitcast<i32>(_e1053) {
                                                case 0: {
                                                    phi_3957_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3957_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3957_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3957_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1056 = phi_3957_;
                                            let _e1062 = global_4.member[_e834.member_1][0u];
                                            let _e1066 = global_4.member[_e834.member_1][1u];
                                            let _e1070 = global_4.member[_e834.member_1][2u];
                                            let _e1074 = global_4.member[_e834.member_1][3u];
                                            let _e1086 = (((_e1066 >> bitcast<u32>(22i)) | ((_e1070 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1074 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1087 = (_e1062 & 268435455u);
                                            let _e1088 = (_e1086 & 268435455u);
                                            let _e1091 = ((_e1062 >> bitcast<u32>(28u)) & 7u);
                                            let _e1099 = ((_e1062 >> bitcast<u32>(31i)) | (((_e1086 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1100 = (_e1091 != 0u);
                                            if (_e1091 == 0u) {
                                                phi_4212_ = _e1087;
                                            } else {
                                                if (_e1091 == 7u) {
                                                    phi_4211_ = 2147483648u;
                                                } else {
                                                    phi_4211_ = ((2147483648u | (_e1091 << bitcast<u32>(28u))) | (_e1088 & 268435455u));
                                                }
                                                let _e1109 = phi_4211_;
                                                phi_4212_ = _e1109;
                                            }
                                            let _e1111 = phi_4212_;
                                            if _e1100 {
                                                let _e1112 = (_e1091 != 7u);
                                                if _e1112 {
                                                    phi_4222_ = (_e1088 + (_e1091 * ((3u * _e1056) + 1u)));
                                                } else {
                                                    phi_4222_ = u32();
                                                }
                                                let _e1116 = phi_4222_;
                                                phi_4224_ = _e1116;
                                                phi_4225_ = select(true, false, _e1112);
                                            } else {
                                                phi_4224_ = u32();
                                                phi_4225_ = true;
                                            }
                                            let _e1119 = phi_4224_;
                                            let _e1121 = phi_4225_;
                                            if (_e1099 == 0u) {
                                                phi_4246_ = (_e1087 + select(0u, 1u, !(_e1100)));
                                            } else {
                                                if (_e1099 == 7u) {
                                                    phi_4245_ = 2147483648u;
                                                } else {
                                                    phi_4245_ = ((2147483648u | (_e1099 << bitcast<u32>(28u))) | (select(_e1119, _e1088, _e1121) & 268435455u));
                                                }
                                                let _e1134 = phi_4245_;
                                                phi_4246_ = _e1134;
                                            }
                                            let _e1136 = phi_4246_;
                                            phi_4250_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e1014, (_e834.member.member.x + _e966), _e1019, (_e834.member.member_1.x - _e1005)), vec4<f32>(_e1015, (_e834.member.member.y + _e970), _e1020, (_e834.member.member_1.y - _e1009)), vec4<f32>(_e1016, (_e834.member.member.z + _e974), _e1021, (_e834.member.member_1.z - _e1013))), type_58(type_37((_e834.member.member + vec4<f32>(_e944, _e953, _e962, 0f)), (_e834.member.member_1 - vec4<f32>(_e983, _e992, _e1001, 0f))), _e1111), type_58(type_37((_e834.member.member + vec4<f32>(_e966, _e970, _e974, 0f)), (_e834.member.member_1 - vec4<f32>(_e1005, _e1009, _e1013, 0f))), _e1136));
                                        }
                                        let _e1141 = phi_4250_;
                                        let _e1153 = ((_e1141.member[0].x - _e516) * _e519);
                                        let _e1154 = ((_e1141.member[0].y - _e516) * _e519);
                                        let _e1155 = ((_e1141.member[0].z - _e517) * _e519);
                                        let _e1156 = ((_e1141.member[0].w - _e517) * _e519);
                                        let _e1166 = ((_e1141.member[1].x - _e580) * _e583);
                                        let _e1167 = ((_e1141.member[1].y - _e580) * _e583);
                                        let _e1168 = ((_e1141.member[1].z - _e581) * _e583);
                                        let _e1169 = ((_e1141.member[1].w - _e581) * _e583);
                                        let _e1179 = ((_e1141.member[2].x - _e644) * _e647);
                                        let _e1180 = ((_e1141.member[2].y - _e644) * _e647);
                                        let _e1181 = ((_e1141.member[2].z - _e645) * _e647);
                                        let _e1182 = ((_e1141.member[2].w - _e645) * _e647);
                                        let _e1184 = select(_e1181, _e1179, (_e1179 < _e1181));
                                        let _e1186 = select(_e1182, _e1180, (_e1180 < _e1182));
                                        let _e1188 = select(_e1181, _e1179, (_e1179 > _e1181));
                                        let _e1190 = select(_e1182, _e1180, (_e1180 > _e1182));
                                        let _e1192 = select(_e1155, _e1153, (_e1153 < _e1155));
                                        let _e1194 = select(_e1156, _e1154, (_e1154 < _e1156));
                                        let _e1196 = select(_e1168, _e1166, (_e1166 < _e1168));
                                        let _e1198 = select(_e1169, _e1167, (_e1167 < _e1169));
                                        let _e1200 = select(_e1196, _e1192, (_e1192 > _e1196));
                                        let _e1202 = select(_e1198, _e1194, (_e1194 > _e1198));
                                        let _e1204 = select(_e1184, _e1200, (_e1200 > _e1184));
                                        let _e1206 = select(_e1186, _e1202, (_e1202 > _e1186));
                                        let _e1208 = select(_e1155, _e1153, (_e1153 > _e1155));
                                        let _e1210 = select(_e1156, _e1154, (_e1154 > _e1156));
                                        let _e1212 = select(_e1168, _e1166, (_e1166 > _e1168));
                                        let _e1214 = select(_e1169, _e1167, (_e1167 > _e1169));
                                        let _e1216 = select(_e1212, _e1208, (_e1208 < _e1212));
                                        let _e1218 = select(_e1214, _e1210, (_e1210 < _e1214));
                                        let _e1223 = -(_e1184);
                                        let _e1224 = -(_e1186);
                                        let _e1231 = (select(_e1188, _e1216, (_e1216 < _e1188)) + (select(_e1223, _e1188, (_e1188 > _e1223)) * 0.0000019073523f));
                                        let _e1232 = (select(_e1190, _e1218, (_e1218 < _e1190)) + (select(_e1224, _e1190, (_e1190 > _e1224)) * 0.0000019073523f));
                                        let _e1234 = select(_e749, _e1204, (_e1204 > _e749));
                                        let _e1236 = select(_e749, _e1206, (_e1206 > _e749));
                                        let _e1241 = (_e1234 <= select(_e793.member_1, _e1231, (_e1231 < _e793.member_1)));
                                        let _e1242 = (_e1236 <= select(_e793.member_1, _e1232, (_e1232 < _e793.member_1)));
                                        let _e1243 = (_e1234 <= _e1236);
                                        if _e1241 {
                                            if _e1242 {
                                                if _e1243 {
                                                    phi_4612_ = _e1141.member_2;
                                                } else {
                                                    phi_4612_ = _e1141.member_1;
                                                }
                                                let _e1247 = phi_4612_;
                                                let _e1268 = (_e836 % 128u);
                                                let _e1269 = (_e1268 < 128u);
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_8[_e1268] = _e1247.member_1;
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_7[_e1268] = _e1247.member.member.x;
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_6[_e1268] = _e1247.member.member.y;
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_5[_e1268] = _e1247.member.member.z;
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_4[_e1268] = _e1247.member.member_1.x;
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_3[_e1268] = _e1247.member.member_1.y;
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_2[_e1268] = _e1247.member.member_1.z;
                                                if _e1269 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_9[_e1268] = select(_e1234, _e1236, _e1243);
                                                if _e1243 {
                                                    phi_4688_ = _e1141.member_1;
                                                } else {
                                                    phi_4688_ = _e1141.member_2;
                                                }
                                                let _e1282 = phi_4688_;
                                                phi_4689_ = _e1282;
                                                phi_4690_ = (_e836 + 1u);
                                            } else {
                                                phi_4689_ = type_58();
                                                phi_4690_ = u32();
                                            }
                                            let _e1284 = phi_4689_;
                                            let _e1286 = phi_4690_;
                                            phi_4692_ = _e1284;
                                            phi_4693_ = _e1286;
                                            phi_4694_ = select(true, false, _e1242);
                                        } else {
                                            phi_4692_ = type_58();
                                            phi_4693_ = u32();
                                            phi_4694_ = true;
                                        }
                                        let _e1289 = phi_4692_;
                                        let _e1291 = phi_4693_;
                                        let _e1293 = phi_4694_;
                                        if _e1293 {
                                            if _e1241 {
                                                phi_4703_ = _e1141.member_1;
                                            } else {
                                                phi_4703_ = _e1141.member_2;
                                            }
                                            let _e1297 = phi_4703_;
                                            phi_4708_ = select(_e1242, true, _e1241);
                                            phi_4709_ = _e1297;
                                        } else {
                                            phi_4708_ = _e832;
                                            phi_4709_ = _e1289;
                                        }
                                        let _e1300 = phi_4708_;
                                        let _e1302 = phi_4709_;
                                        phi_5536_ = _e791;
                                        phi_4711_ = _e793;
                                        phi_4712_ = _e1300;
                                        phi_4713_ = _e1302;
                                        phi_4714_ = select(_e1291, _e836, _e1293);
                                    }
                                    let _e2460 = phi_5536_;
                                    let _e2462 = phi_4711_;
                                    let _e2464 = phi_4712_;
                                    let _e2466 = phi_4713_;
                                    let _e2468 = phi_4714_;
                                    phi_5535_ = _e2460;
                                    phi_4715_ = _e2462;
                                    phi_4716_ = _e2464;
                                    phi_4717_ = _e2466;
                                    phi_4718_ = _e2468;
                                    phi_4719_ = (_e801 - 1u);
                                } else {
                                    phi_5535_ = _e791;
                                    phi_4715_ = _e793;
                                    phi_4716_ = _e832;
                                    phi_4717_ = _e834;
                                    phi_4718_ = _e836;
                                    phi_4719_ = _e801;
                                }
                                let _e2470 = phi_5535_;
                                let _e2472 = phi_4715_;
                                let _e2474 = phi_4716_;
                                let _e2476 = phi_4717_;
                                let _e2478 = phi_4718_;
                                let _e2480 = phi_4719_;
                                phi_5534_ = _e2470;
                                phi_4720_ = _e2472;
                                phi_4721_ = _e2474;
                                phi_4722_ = _e2476;
                                phi_4723_ = _e2478;
                                phi_4724_ = _e2480;
                            } else {
                                phi_5534_ = _e791;
                                phi_4720_ = type_43();
                                phi_4721_ = bool();
                                phi_4722_ = type_58();
                                phi_4723_ = u32();
                                phi_4724_ = u32();
                            }
                            let _e2482 = phi_5534_;
                            let _e2484 = phi_4720_;
                            let _e2486 = phi_4721_;
                            let _e2488 = phi_4722_;
                            let _e2490 = phi_4723_;
                            let _e2492 = phi_4724_;
                            phi_5533_ = _e2482;
                            phi_1429_ = _e2484;
                            phi_1432_ = _e2486;
                            phi_1434_ = _e2488;
                            phi_1436_ = _e2490;
                            phi_1438_ = _e2492;
                            phi_4725_ = _e805;
                        } else {
                            phi_5533_ = _e791;
                            phi_1429_ = type_43();
                            phi_1432_ = bool();
                            phi_1434_ = type_58();
                            phi_1436_ = u32();
                            phi_1438_ = u32();
                            phi_4725_ = false;
                        }
                        let _e2494 = phi_5533_;
                        let _e2496 = phi_1429_;
                        let _e2498 = phi_1432_;
                        let _e2500 = phi_1434_;
                        let _e2502 = phi_1436_;
                        let _e2504 = phi_1438_;
                        let _e2506 = phi_4725_;
                        continue;
                        continuing {
                            phi_5306_ = _e2494;
                            phi_1428_ = _e2496;
                            phi_1431_ = _e2498;
                            phi_1433_ = _e2500;
                            phi_1435_ = _e2502;
                            phi_1437_ = _e2504;
                            phi_5532_ = _e2494;
                            break if !(_e2506);
                        }
                    }
                    let _e2509 = phi_5532_;
                    if _e2509 {
                        break;
                    }
                    let _e2511 = local_11;
                    if (_e2511.member.member_3 != 4294967295u) {
                        let _e2516 = bitcast<u32>(_e2511.member.member);
                        let _e2520 = (bitcast<i32>((_e2516 >> bitcast<u32>(23i))) & 255i);
                        let _e2521 = (_e2520 + _e433);
                        if (_e2520 == 255i) {
                            phi_4784_ = _e2511.member.member;
                        } else {
                            if (_e2520 > 0i) {
                                if (_e2521 > 0i) {
                                    let _e2525 = (_e2521 < 255i);
                                    if _e2525 {
                                        phi_4763_ = bitcast<f32>((_e2516 + bitcast<u32>((_e433 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4763_ = f32();
                                    }
                                    let _e2532 = phi_4763_;
                                    phi_4765_ = _e2532;
                                    phi_4766_ = select(true, false, _e2525);
                                } else {
                                    phi_4765_ = f32();
                                    phi_4766_ = true;
                                }
                                let _e2535 = phi_4765_;
                                let _e2537 = phi_4766_;
                                phi_4767_ = _e2535;
                                phi_4768_ = _e2537;
                            } else {
                                phi_4767_ = f32();
                                phi_4768_ = true;
                            }
                            let _e2539 = phi_4767_;
                            let _e2541 = phi_4768_;
                            if _e2541 {
                                let _e2542 = (_e2516 & 2147483648u);
                                let _e2549 = ((_e2516 & 8388607u) | (select(0u, 1u, ((_e2516 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2553 = (_e2549 == 0u);
                                if _e2553 {
                                    phi_5258_ = bitcast<f32>(_e2542);
                                } else {
                                    let _e2558 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2549)), 32u, _e2553) - 8u);
                                    let _e2561 = (_e2549 << bitcast<u32>((_e2558 & 31u)));
                                    let _e2563 = ((_e2521 + select(0i, 1i, (_e2520 == 0i))) - bitcast<i32>(_e2558));
                                    if (_e2563 >= 255i) {
                                        phi_5248_ = bitcast<f32>((_e2542 | 2139095040u));
                                        phi_5249_ = f32();
                                        phi_5250_ = true;
                                    } else {
                                        let _e2565 = (_e2563 > 0i);
                                        if _e2565 {
                                            phi_5242_ = bitcast<f32>(((_e2542 | (bitcast<u32>(_e2563) << bitcast<u32>(23i))) | (_e2561 & 8388607u)));
                                            phi_5243_ = f32();
                                        } else {
                                            if (_e2563 < -24i) {
                                                phi_5208_ = 26u;
                                            } else {
                                                phi_5208_ = bitcast<u32>((1i - _e2563));
                                            }
                                            let _e2570 = phi_5208_;
                                            let _e2571 = (_e2570 & 31u);
                                            let _e2573 = (_e2561 >> bitcast<u32>(_e2571));
                                            let _e2577 = (_e2561 & ((1u << bitcast<u32>(_e2571)) - 1u));
                                            let _e2581 = (1u << bitcast<u32>(((_e2570 - 1u) & 31u)));
                                            if (_e2577 > _e2581) {
                                                phi_5229_ = true;
                                            } else {
                                                if (_e2577 == _e2581) {
                                                    phi_5226_ = ((_e2573 & 1u) == 1u);
                                                } else {
                                                    phi_5226_ = false;
                                                }
                                                let _e2587 = phi_5226_;
                                                phi_5229_ = _e2587;
                                            }
                                            let _e2589 = phi_5229_;
                                            phi_5242_ = f32();
                                            phi_5243_ = bitcast<f32>((_e2542 | (_e2573 + select(0u, 1u, _e2589))));
                                        }
                                        let _e2602 = phi_5242_;
                                        let _e2604 = phi_5243_;
                                        phi_5248_ = _e2602;
                                        phi_5249_ = _e2604;
                                        phi_5250_ = _e2565;
                                    }
                                    let _e2608 = phi_5248_;
                                    let _e2610 = phi_5249_;
                                    let _e2612 = phi_5250_;
                                    phi_5258_ = select(_e2610, _e2608, _e2612);
                                }
                                let _e2616 = phi_5258_;
                                phi_4783_ = _e2616;
                            } else {
                                phi_4783_ = _e2539;
                            }
                            let _e2618 = phi_4783_;
                            phi_4784_ = _e2618;
                        }
                        let _e2620 = phi_4784_;
                        let _e2621 = bitcast<u32>(_e2620);
                        if ((_e2621 & 2147483647u) >= 2139095040u) {
                            phi_4796_ = bitcast<f32>(((_e2621 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4796_ = _e2620;
                        }
                        let _e2628 = phi_4796_;
                        phi_4801_ = type_25(_e2628, _e2511.member.member_1, _e2511.member.member_2, _e2511.member.member_3);
                    } else {
                        phi_4801_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2633 = phi_4801_;
                    if _e310 {
                    } else {
                        break;
                    }
                    global_8.member[_e156] = _e2633;
                    if _e171 {
                    } else {
                        break;
                    }
                    let _e2637 = select(0u, 1u, (_e377 <= _e387));
                    if (_e2637 > 0u) {
                        let _e2639 = (1u < _e124);
                        if _e2639 {
                            if (0u < _e124) {
                            } else {
                                break;
                            }
                            let _e2643 = atomicAdd((&global_9.member[0u]), _e2637);
                            if ((_e2643 + _e2637) < _e2643) {
                                if _e2639 {
                                } else {
                                    break;
                                }
                                let _e2648 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2651 = select(0u, 1u, (_e2633.member_3 != 4294967295u));
                    if (_e2651 > 0u) {
                        let _e2653 = (3u < _e124);
                        if _e2653 {
                            if (2u < _e124) {
                            } else {
                                break;
                            }
                            let _e2657 = atomicAdd((&global_9.member[2u]), _e2651);
                            if ((_e2657 + _e2651) < _e2657) {
                                if _e2653 {
                                } else {
                                    break;
                                }
                                let _e2662 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
