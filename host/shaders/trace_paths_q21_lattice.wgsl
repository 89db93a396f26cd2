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

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_39 {
    member: type_21,
    member_1: f32,
}

struct type_42 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<i32>,
}

struct type_53 {
    member: array<array<u32, 7>>,
}

struct type_58 {
    member: type_33,
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
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_44;
@group(0) @binding(2) 
var<uniform> global_3: type_44;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_47;
@group(0) @binding(7) 
var<storage> global_6: type_28;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_23;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_64;
@group(0) @binding(3) 
var<storage> global_9: type_53;
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
    var phi_633_: type_35;
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
    var phi_1428_: type_39;
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
    var phi_1555_: type_39;
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
    var phi_3067_: type_42;
    var phi_3068_: type_42;
    var phi_3071_: type_42;
    var phi_3072_: type_42;
    var phi_3073_: bool;
    var phi_3077_: type_42;
    var phi_3086_: type_21;
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
    var phi_3447_: type_39;
    var phi_3448_: type_39;
    var phi_3449_: type_39;
    var phi_1556_: type_39;
    var phi_5300_: bool;
    var local_10: type_39;
    var phi_5536_: bool;
    var phi_4711_: type_39;
    var phi_4712_: bool;
    var phi_4713_: type_58;
    var phi_4714_: u32;
    var phi_5535_: bool;
    var phi_4715_: type_39;
    var phi_4716_: bool;
    var phi_4717_: type_58;
    var phi_4718_: u32;
    var phi_4719_: u32;
    var phi_5534_: bool;
    var phi_4720_: type_39;
    var phi_4721_: bool;
    var phi_4722_: type_58;
    var phi_4723_: u32;
    var phi_4724_: u32;
    var phi_5533_: bool;
    var phi_1429_: type_39;
    var phi_1432_: bool;
    var phi_1434_: type_58;
    var phi_1436_: u32;
    var phi_1438_: u32;
    var phi_4725_: bool;
    var phi_5532_: bool;
    var local_11: type_39;
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
    var phi_4801_: type_21;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e104 = global;
            let _e106 = arrayLength((&global_9.member));
            let _e109 = arrayLength((&global_10.member));
            let _e121 = arrayLength((&global_8.member));
            let _e125 = global_3.member[0u][0u];
            let _e129 = global_3.member[0u][1u];
            let _e133 = global_3.member[0u][2u];
            let _e137 = global_3.member[0u][3u];
            let _e141 = global_3.member[1u][0u];
            let _e145 = global_3.member[1u][1u];
            let _e149 = global_3.member[1u][2u];
            let _e153 = (_e104.x + (_e104.y * 2097152u));
            let _e165 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e137) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e125), bitcast<i32>(_e129), bitcast<i32>(_e133));
            local = array<i32, 3>(bitcast<i32>(_e141), bitcast<i32>(_e145), bitcast<i32>(_e149));
            let _e168 = (_e153 < arrayLength((&global_6.member)));
            if _e168 {
                if _e168 {
                } else {
                    break;
                }
                let _e172 = global_6.member[_e153].member_2;
                phi_449_ = _e172;
            } else {
                phi_449_ = 4294967295u;
            }
            let _e174 = phi_449_;
            let _e177 = global_1.member[0u];
            let _e181 = global_2.member[0u][0u];
            let _e185 = global_2.member[0u][1u];
            let _e189 = global_2.member[0u][2u];
            let _e193 = global_2.member[0u][3u];
            let _e197 = global_2.member[1u][0u];
            let _e201 = global_2.member[1u][1u];
            let _e205 = global_2.member[1u][2u];
            let _e209 = global_2.member[1u][3u];
            let _e210 = bitcast<f32>(_e181);
            let _e211 = bitcast<f32>(_e185);
            let _e212 = bitcast<f32>(_e189);
            let _e214 = bitcast<f32>(_e197);
            let _e215 = array<u32, 3>(_e201, _e205, _e209);
            let _e217 = bitcast<i32>(_e177);
            if (_e217 < -126i) {
                phi_493_ = -126i;
            } else {
                phi_493_ = select(_e217, 127i, (_e217 > 127i));
            }
            let _e222 = phi_493_;
            let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
            let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
            if (_e193 == 0u) {
                phi_633_ = type_35(array<f32, 3>(_e210, _e211, _e212), _e193, _e214, _e215);
            } else {
                let _e235 = bitcast<u32>(_e210);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e211);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e212);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                let _e287 = bitcast<u32>(_e214);
                let _e289 = ((_e287 & 2139095040u) != 0u);
                phi_633_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e210, _e237) * _e227) * select(0.00000011920929f, 1f, _e237)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e211, _e254) * _e227) * select(0.00000011920929f, 1f, _e254)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e212, _e271) * _e227) * select(0.00000011920929f, 1f, _e271)) * _e233)), _e193, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e287 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e287 & 2147483648u))), _e214, _e289) * _e227) * select(0.00000011920929f, 1f, _e289)) * _e233), _e215);
            }
            let _e306 = phi_633_;
            if _e168 {
                let _e307 = (_e153 < arrayLength((&global_7.member)));
                if _e307 {
                    if _e168 {
                    } else {
                        break;
                    }
                    let _e317 = global_6.member[_e153].member.member_2[0u];
                    let _e319 = (bitcast<u32>(_e317) & 2147483647u);
                    let _e325 = global_6.member[_e153].member.member_2[1u];
                    let _e327 = (bitcast<u32>(_e325) & 2147483647u);
                    let _e333 = global_6.member[_e153].member.member_2[2u];
                    let _e335 = (bitcast<u32>(_e333) & 2147483647u);
                    let _e341 = global_6.member[_e153].member.member[0u];
                    let _e343 = (bitcast<u32>(_e341) & 2147483647u);
                    let _e349 = global_6.member[_e153].member.member[1u];
                    let _e351 = (bitcast<u32>(_e349) & 2147483647u);
                    let _e357 = global_6.member[_e153].member.member[2u];
                    let _e359 = (bitcast<u32>(_e357) & 2147483647u);
                    let _e361 = select(_e327, _e319, (_e327 < _e319));
                    let _e363 = select(_e335, _e361, (_e335 < _e361));
                    let _e365 = select(_e343, _e363, (_e343 < _e363));
                    let _e367 = select(_e351, _e365, (_e351 < _e365));
                    let _e369 = select(_e359, _e367, (_e359 < _e367));
                    let _e374 = global_6.member[_e153].member.member_1;
                    let _e375 = bitcast<u32>(_e374);
                    let _e376 = (_e375 & 2147483647u);
                    let _e384 = global_6.member[_e153].member.member_3;
                    let _e385 = bitcast<u32>(_e384);
                    let _e386 = (_e385 & 2147483647u);
                    let _e390 = (((select(_e376, _e369, (_e376 < _e369)) < 2139095040u) && (_e386 <= 2139095040u)) && (_e363 > 0u));
                    if _e390 {
                        let _e393 = (bitcast<u32>(bitcast<f32>(_e363)) & 2147483647u);
                        if (_e393 >= 8388608u) {
                            phi_739_ = (bitcast<i32>((_e393 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_739_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e393)), 32u, (_e393 == 0u))));
                        }
                        let _e407 = phi_739_;
                        phi_740_ = _e407;
                    } else {
                        phi_740_ = 0i;
                    }
                    let _e409 = phi_740_;
                    let _e410 = (_e319 == _e363);
                    if _e410 {
                        phi_750_ = true;
                    } else {
                        phi_750_ = (_e327 == _e363);
                    }
                    let _e413 = phi_750_;
                    let _e414 = select(1u, 0u, _e410);
                    if _e413 {
                        let _e415 = (_e414 + 1u);
                        phi_760_ = _e415;
                        phi_761_ = _e415;
                        phi_763_ = select(true, false, (_e415 == 2u));
                    } else {
                        phi_760_ = u32();
                        phi_761_ = 0u;
                        phi_763_ = true;
                    }
                    let _e419 = phi_760_;
                    let _e421 = phi_761_;
                    let _e423 = phi_763_;
                    if _e423 {
                        phi_768_ = (_e421 + 1u);
                    } else {
                        phi_768_ = 0u;
                    }
                    let _e427 = phi_768_;
                    let _e428 = select(_e419, _e421, _e423);
                    let _e429 = select(_e414, select(2u, _e414, _e413), _e423);
                    let _e430 = -(_e409);
                    if (_e430 < -126i) {
                        phi_801_ = -126i;
                    } else {
                        phi_801_ = select(_e430, 127i, (_e430 > 127i));
                    }
                    let _e435 = phi_801_;
                    let _e440 = bitcast<f32>((bitcast<u32>((_e435 + 127i)) << bitcast<u32>(23i)));
                    let _e446 = bitcast<f32>((bitcast<u32>(((_e430 - _e435) + 127i)) << bitcast<u32>(23i)));
                    let _e451 = global_6.member[_e153].member.member;
                    let _e452 = (_e428 == 0u);
                    if _e452 {
                        phi_819_ = _e451[0];
                    } else {
                        phi_819_ = _e451[1];
                    }
                    let _e456 = phi_819_;
                    let _e457 = (_e428 == 2u);
                    if _e457 {
                        phi_825_ = _e451[2];
                    } else {
                        phi_825_ = _e456;
                    }
                    let _e460 = phi_825_;
                    let _e461 = bitcast<u32>(_e460);
                    let _e463 = ((_e461 & 2139095040u) != 0u);
                    let _e475 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e461 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e461 & 2147483648u))), _e460, _e463) * select(0.00000011920929f, 1f, _e463));
                    let _e476 = global_6.member[_e153].member.member_2;
                    if _e452 {
                        phi_865_ = _e476[0];
                    } else {
                        phi_865_ = _e476[1];
                    }
                    let _e480 = phi_865_;
                    if _e457 {
                        phi_871_ = _e476[2];
                    } else {
                        phi_871_ = _e480;
                    }
                    let _e483 = phi_871_;
                    let _e484 = bitcast<u32>(_e483);
                    let _e486 = ((_e484 & 2139095040u) != 0u);
                    let _e500 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e484 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e484 & 2147483648u))), _e483, _e486) * _e440) * select(0.00000011920929f, 1f, _e486)) * _e446);
                    let _e504 = (bitcast<f32>((bitcast<u32>(_e500) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e507 = bitcast<f32>((bitcast<u32>(_e475) & 2147483647u));
                    let _e508 = (_e507 * 0.00000011920929f);
                    let _e511 = select(select(0.00000000000011368684f, _e508, (_e508 > 0.00000000000011368684f)), 0f, _e504);
                    let _e512 = select(0f, _e500, _e504);
                    let _e513 = (_e475 + _e511);
                    let _e514 = (_e475 - _e511);
                    let _e516 = select(38685626000000000000000000f, (1f / _e500), _e504);
                    let _e517 = (_e427 == 0u);
                    if _e517 {
                        phi_944_ = _e451[0];
                    } else {
                        phi_944_ = _e451[1];
                    }
                    let _e521 = phi_944_;
                    let _e522 = (_e427 == 2u);
                    if _e522 {
                        phi_950_ = _e451[2];
                    } else {
                        phi_950_ = _e521;
                    }
                    let _e525 = phi_950_;
                    let _e526 = bitcast<u32>(_e525);
                    let _e528 = ((_e526 & 2139095040u) != 0u);
                    let _e540 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e526 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e526 & 2147483648u))), _e525, _e528) * select(0.00000011920929f, 1f, _e528));
                    if _e517 {
                        phi_990_ = _e476[0];
                    } else {
                        phi_990_ = _e476[1];
                    }
                    let _e544 = phi_990_;
                    if _e522 {
                        phi_996_ = _e476[2];
                    } else {
                        phi_996_ = _e544;
                    }
                    let _e547 = phi_996_;
                    let _e548 = bitcast<u32>(_e547);
                    let _e550 = ((_e548 & 2139095040u) != 0u);
                    let _e564 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e548 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e548 & 2147483648u))), _e547, _e550) * _e440) * select(0.00000011920929f, 1f, _e550)) * _e446);
                    let _e568 = (bitcast<f32>((bitcast<u32>(_e564) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e571 = bitcast<f32>((bitcast<u32>(_e540) & 2147483647u));
                    let _e572 = (_e571 * 0.00000011920929f);
                    let _e575 = select(select(0.00000000000011368684f, _e572, (_e572 > 0.00000000000011368684f)), 0f, _e568);
                    let _e576 = select(0f, _e564, _e568);
                    let _e577 = (_e540 + _e575);
                    let _e578 = (_e540 - _e575);
                    let _e580 = select(38685626000000000000000000f, (1f / _e564), _e568);
                    let _e581 = (_e429 == 0u);
                    if _e581 {
                        phi_1069_ = _e451[0];
                    } else {
                        phi_1069_ = _e451[1];
                    }
                    let _e585 = phi_1069_;
                    let _e586 = (_e429 == 2u);
                    if _e586 {
                        phi_1075_ = _e451[2];
                    } else {
                        phi_1075_ = _e585;
                    }
                    let _e589 = phi_1075_;
                    let _e590 = bitcast<u32>(_e589);
                    let _e592 = ((_e590 & 2139095040u) != 0u);
                    let _e604 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e590 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e590 & 2147483648u))), _e589, _e592) * select(0.00000011920929f, 1f, _e592));
                    if _e581 {
                        phi_1115_ = _e476[0];
                    } else {
                        phi_1115_ = _e476[1];
                    }
                    let _e608 = phi_1115_;
                    if _e586 {
                        phi_1121_ = _e476[2];
                    } else {
                        phi_1121_ = _e608;
                    }
                    let _e611 = phi_1121_;
                    let _e612 = bitcast<u32>(_e611);
                    let _e614 = ((_e612 & 2139095040u) != 0u);
                    let _e628 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e612 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e612 & 2147483648u))), _e611, _e614) * _e440) * select(0.00000011920929f, 1f, _e614)) * _e446);
                    let _e632 = (bitcast<f32>((bitcast<u32>(_e628) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e635 = bitcast<f32>((bitcast<u32>(_e604) & 2147483647u));
                    let _e636 = (_e635 * 0.00000011920929f);
                    let _e639 = select(select(0.00000000000011368684f, _e636, (_e636 > 0.00000000000011368684f)), 0f, _e632);
                    let _e640 = select(0f, _e628, _e632);
                    let _e641 = (_e604 + _e639);
                    let _e642 = (_e604 - _e639);
                    let _e644 = select(38685626000000000000000000f, (1f / _e628), _e632);
                    let _e646 = select(_e571, _e507, (_e507 > _e571));
                    if (_e390 && (select(_e635, _e646, (_e646 > _e635)) <= 1099511600000f)) {
                        let _e658 = ((_e376 & 8388607u) | (select(0u, 1u, ((_e376 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e661 = bitcast<i32>((_e376 >> bitcast<u32>(23i)));
                        let _e665 = (_e658 == 0u);
                        let _e668 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e658)), 32u, _e665)) - 8i);
                        if (_e661 == 255i) {
                            phi_1240_ = 255i;
                        } else {
                            phi_1240_ = (((_e661 + select(0i, 1i, (_e661 == 0i))) - _e668) + _e409);
                        }
                        let _e676 = phi_1240_;
                        let _e686 = (_e676 <= 0i);
                        if _e686 {
                            phi_1263_ = u32();
                        } else {
                            if _e665 {
                                phi_1262_ = u32();
                            } else {
                                phi_1262_ = select(((bitcast<u32>(_e676) << bitcast<u32>(23i)) | ((_e658 << bitcast<u32>(((_e668 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e676 >= 255i));
                            }
                            let _e690 = phi_1262_;
                            phi_1263_ = _e690;
                        }
                        let _e692 = phi_1263_;
                        let _e704 = ((_e386 & 8388607u) | (select(0u, 1u, ((_e386 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e707 = bitcast<i32>((_e386 >> bitcast<u32>(23i)));
                        let _e711 = (_e704 == 0u);
                        let _e714 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e704)), 32u, _e711)) - 8i);
                        if (_e707 == 255i) {
                            phi_1300_ = 255i;
                        } else {
                            phi_1300_ = (((_e707 + select(0i, 1i, (_e707 == 0i))) - _e714) + _e409);
                        }
                        let _e722 = phi_1300_;
                        let _e732 = (_e722 <= 0i);
                        if _e732 {
                            phi_1323_ = u32();
                        } else {
                            if _e711 {
                                phi_1322_ = u32();
                            } else {
                                phi_1322_ = select(((bitcast<u32>(_e722) << bitcast<u32>(23i)) | ((_e704 << bitcast<u32>(((_e714 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e722 >= 255i));
                            }
                            let _e736 = phi_1322_;
                            phi_1323_ = _e736;
                        }
                        let _e738 = phi_1323_;
                        phi_1331_ = bitcast<f32>(((_e385 & 2147483648u) | select(_e738, 0u, select(_e711, true, _e732))));
                        phi_1332_ = bitcast<f32>(((_e375 & 2147483648u) | select(_e692, 0u, select(_e665, true, _e686))));
                    } else {
                        phi_1331_ = 0f;
                        phi_1332_ = 1f;
                    }
                    let _e744 = phi_1331_;
                    let _e746 = phi_1332_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e752 = (_e428 % 3u);
                    let _e753 = (_e752 < 3u);
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e755 = local_1[_e752];
                    let _e758 = (_e427 % 3u);
                    let _e759 = (_e758 < 3u);
                    if _e759 {
                    } else {
                        break;
                    }
                    let _e761 = local_1[_e758];
                    let _e764 = (_e429 % 3u);
                    let _e765 = (_e764 < 3u);
                    if _e765 {
                    } else {
                        break;
                    }
                    let _e767 = local_1[_e764];
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e772 = local[_e752];
                    if _e759 {
                    } else {
                        break;
                    }
                    let _e776 = local[_e758];
                    if _e765 {
                    } else {
                        break;
                    }
                    let _e780 = local[_e764];
                    phi_5306_ = false;
                    phi_1428_ = type_39(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e744);
                    phi_1431_ = (_e746 <= _e744);
                    phi_1433_ = type_58(type_33(vec4<f32>((f32(_e755) * _e165), (f32(_e761) * _e165), (f32(_e767) * _e165), 0f), vec4<f32>((f32(_e772) * _e165), (f32(_e776) * _e165), (f32(_e780) * _e165), 0f)), select(0u, 2147483648u, (_e106 == 0u)));
                    phi_1435_ = 0u;
                    phi_1437_ = ((3u * _e106) + 1u);
                    loop {
                        let _e788 = phi_5306_;
                        let _e790 = phi_1428_;
                        let _e792 = phi_1431_;
                        let _e794 = phi_1433_;
                        let _e796 = phi_1435_;
                        let _e798 = phi_1437_;
                        local_11 = _e790;
                        if _e792 {
                            phi_1448_ = true;
                        } else {
                            phi_1448_ = (_e796 > 0u);
                        }
                        let _e801 = phi_1448_;
                        if _e801 {
                            let _e802 = (_e798 > 0u);
                            if _e802 {
                                if _e792 {
                                    phi_1534_ = _e792;
                                    phi_1535_ = _e794;
                                    phi_1536_ = _e796;
                                } else {
                                    let _e803 = (_e796 - 1u);
                                    let _e804 = (_e803 % 128u);
                                    let _e805 = (_e804 < 128u);
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e807 = local_7[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e809 = local_6[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e811 = local_5[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e813 = local_4[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e815 = local_3[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e817 = local_2[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e822 = local_8[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5532_ = true;
                                        break;
                                    }
                                    let _e825 = local_9[_e804];
                                    phi_1534_ = (_e825 <= _e790.member_1);
                                    phi_1535_ = type_58(type_33(vec4<f32>(_e807, _e809, _e811, 0f), vec4<f32>(_e813, _e815, _e817, 0f)), _e822);
                                    phi_1536_ = _e803;
                                }
                                let _e829 = phi_1534_;
                                let _e831 = phi_1535_;
                                let _e833 = phi_1536_;
                                if _e829 {
                                    let _e838 = (_e831.member_1 & 268435455u);
                                    if ((_e831.member_1 & 2147483648u) != 0u) {
                                        phi_1555_ = _e790;
                                        phi_1558_ = type_8(0u, ((_e831.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1321 = phi_1555_;
                                            let _e1323 = phi_1558_;
                                            local_10 = _e1321;
                                            local_12 = _e1321;
                                            if (_e1323.member < _e1323.member_1) {
                                                phi_1559_ = type_8((_e1323.member + 1u), _e1323.member_1);
                                                phi_1581_ = type_8(1u, _e1323.member);
                                            } else {
                                                phi_1559_ = _e1323;
                                                phi_1581_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1336 = phi_1559_;
                                            let _e1338 = phi_1581_;
                                            let _e1342 = (bitcast<i32>(_e1338.member) != 0i);
                                            if _e1342 {
                                                let _e1347 = (_e831.member.member_1.x - _e831.member.member.x);
                                                let _e1350 = (_e831.member.member_1.y - _e831.member.member.y);
                                                let _e1353 = (_e831.member.member_1.z - _e831.member.member.z);
                                                let _e1355 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                let _e1357 = select(_e1353, _e1355, (_e1355 > _e1353));
                                                let _e1359 = (_e1357 < (1024f * _e165));
                                                if _e1359 {
                                                    phi_1622_ = 0u;
                                                } else {
                                                    phi_1622_ = select(2u, 1u, (_e1357 < (2097152f * _e165)));
                                                }
                                                let _e1364 = phi_1622_;
                                                switch bitcast<i32>(_e1364) {
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
                                                let _e1367 = phi_1628_;
                                                switch bitcast<i32>(_e1364) {
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
                                                let _e1374 = phi_1638_;
                                                let _e1376 = ((_e838 + (_e1338.member_1 * ((3u * _e1367) + 1u))) + (3u * _e1374));
                                                let _e1377 = (_e1376 < _e109);
                                                if _e1377 {
                                                    if _e1377 {
                                                    } else {
                                                        phi_5300_ = true;
                                                        break;
                                                    }
                                                    let _e1379 = global_10.member[_e1376];
                                                    phi_1654_ = _e1379;
                                                } else {
                                                    phi_1654_ = 4294967295u;
                                                }
                                                let _e1381 = phi_1654_;
                                                if _e1359 {
                                                    phi_1687_ = 0u;
                                                } else {
                                                    phi_1687_ = select(2u, 1u, (_e1357 < (2097152f * _e165)));
                                                }
                                                let _e1386 = phi_1687_;
                                                switch bitcast<i32>(_e1386) {
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
                                                let _e1389 = phi_1693_;
                                                let _e1393 = (_e838 + (_e1338.member_1 * ((3u * _e1389) + 1u)));
                                                switch bitcast<i32>(_e1386) {
                                                    case 0: {
                                                        let _e1668 = (_e1393 < _e109);
                                                        if _e1668 {
                                                            if _e1668 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1670 = global_10.member[_e1393];
                                                            phi_1720_ = _e1670;
                                                        } else {
                                                            phi_1720_ = 0u;
                                                        }
                                                        let _e1672 = phi_1720_;
                                                        let _e1674 = ((10u * _e428) & 31u);
                                                        let _e1684 = ((10u * _e427) & 31u);
                                                        let _e1694 = ((10u * _e429) & 31u);
                                                        let _e1704 = (_e1393 + 1u);
                                                        let _e1705 = (_e1704 < _e109);
                                                        if _e1705 {
                                                            if _e1705 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1707 = global_10.member[_e1704];
                                                            phi_1769_ = _e1707;
                                                        } else {
                                                            phi_1769_ = 0u;
                                                        }
                                                        let _e1709 = phi_1769_;
                                                        let _e1735 = (_e1393 + 2u);
                                                        let _e1736 = (_e1735 < _e109);
                                                        if _e1736 {
                                                            if _e1736 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1738 = global_10.member[_e1735];
                                                            phi_1818_ = _e1738;
                                                        } else {
                                                            phi_1818_ = 0u;
                                                        }
                                                        let _e1740 = phi_1818_;
                                                        phi_2319_ = array<array<f32, 3>, 3>(array<f32, 3>((_e831.member.member.x + ((bitcast<f32>((1258291200u | ((_e1672 >> bitcast<u32>(_e1674)) & 1023u))) - 8388608f) * _e165)), (_e831.member.member.y + ((bitcast<f32>((1258291200u | ((_e1672 >> bitcast<u32>(_e1684)) & 1023u))) - 8388608f) * _e165)), (_e831.member.member.z + ((bitcast<f32>((1258291200u | ((_e1672 >> bitcast<u32>(_e1694)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e831.member.member.x + ((bitcast<f32>((1258291200u | ((_e1709 >> bitcast<u32>(_e1674)) & 1023u))) - 8388608f) * _e165)), (_e831.member.member.y + ((bitcast<f32>((1258291200u | ((_e1709 >> bitcast<u32>(_e1684)) & 1023u))) - 8388608f) * _e165)), (_e831.member.member.z + ((bitcast<f32>((1258291200u | ((_e1709 >> bitcast<u32>(_e1694)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e831.member.member.x + ((bitcast<f32>((1258291200u | ((_e1740 >> bitcast<u32>(_e1674)) & 1023u))) - 8388608f) * _e165)), (_e831.member.member.y + ((bitcast<f32>((1258291200u | ((_e1740 >> bitcast<u32>(_e1684)) & 1023u))) - 8388608f) * _e165)), (_e831.member.member.z + ((bitcast<f32>((1258291200u | ((_e1740 >> bitcast<u32>(_e1694)) & 1023u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1482 = (_e1393 < _e109);
                                                        if _e1482 {
                                                            if _e1482 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1484 = global_10.member[_e1393];
                                                            phi_1867_ = _e1484;
                                                        } else {
                                                            phi_1867_ = 0u;
                                                        }
                                                        let _e1486 = phi_1867_;
                                                        let _e1487 = (_e1393 + 1u);
                                                        let _e1488 = (_e1487 < _e109);
                                                        if _e1488 {
                                                            if _e1488 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1490 = global_10.member[_e1487];
                                                            phi_1882_ = _e1490;
                                                        } else {
                                                            phi_1882_ = 0u;
                                                        }
                                                        let _e1492 = phi_1882_;
                                                        let _e1493 = (_e428 == 1u);
                                                        if _e1493 {
                                                            phi_1892_ = ((_e1486 >> bitcast<u32>(21i)) | (_e1492 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1892_ = (_e1492 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1502 = phi_1892_;
                                                        let _e1510 = (_e427 == 1u);
                                                        if _e1510 {
                                                            phi_1913_ = ((_e1486 >> bitcast<u32>(21i)) | (_e1492 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1913_ = (_e1492 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1519 = phi_1913_;
                                                        let _e1527 = (_e429 == 1u);
                                                        if _e1527 {
                                                            phi_1934_ = ((_e1486 >> bitcast<u32>(21i)) | (_e1492 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1934_ = (_e1492 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1536 = phi_1934_;
                                                        let _e1545 = (_e1393 + 2u);
                                                        let _e1546 = (_e1545 < _e109);
                                                        if _e1546 {
                                                            if _e1546 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1548 = global_10.member[_e1545];
                                                            phi_1964_ = _e1548;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e1550 = phi_1964_;
                                                        let _e1551 = (_e1393 + 3u);
                                                        let _e1552 = (_e1551 < _e109);
                                                        if _e1552 {
                                                            if _e1552 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1554 = global_10.member[_e1551];
                                                            phi_1979_ = _e1554;
                                                        } else {
                                                            phi_1979_ = 0u;
                                                        }
                                                        let _e1556 = phi_1979_;
                                                        if _e1493 {
                                                            phi_1989_ = ((_e1550 >> bitcast<u32>(21i)) | (_e1556 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1989_ = (_e1556 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1565 = phi_1989_;
                                                        if _e1510 {
                                                            phi_2010_ = ((_e1550 >> bitcast<u32>(21i)) | (_e1556 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2010_ = (_e1556 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1581 = phi_2010_;
                                                        if _e1527 {
                                                            phi_2031_ = ((_e1550 >> bitcast<u32>(21i)) | (_e1556 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2031_ = (_e1556 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1597 = phi_2031_;
                                                        let _e1606 = (_e1393 + 4u);
                                                        let _e1607 = (_e1606 < _e109);
                                                        if _e1607 {
                                                            if _e1607 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1609 = global_10.member[_e1606];
                                                            phi_2061_ = _e1609;
                                                        } else {
                                                            phi_2061_ = 0u;
                                                        }
                                                        let _e1611 = phi_2061_;
                                                        let _e1612 = (_e1393 + 5u);
                                                        let _e1613 = (_e1612 < _e109);
                                                        if _e1613 {
                                                            if _e1613 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1615 = global_10.member[_e1612];
                                                            phi_2076_ = _e1615;
                                                        } else {
                                                            phi_2076_ = 0u;
                                                        }
                                                        let _e1617 = phi_2076_;
                                                        if _e1493 {
                                                            phi_2086_ = ((_e1611 >> bitcast<u32>(21i)) | (_e1617 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2086_ = (_e1617 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1626 = phi_2086_;
                                                        if _e1510 {
                                                            phi_2107_ = ((_e1611 >> bitcast<u32>(21i)) | (_e1617 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2107_ = (_e1617 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1642 = phi_2107_;
                                                        if _e1527 {
                                                            phi_2128_ = ((_e1611 >> bitcast<u32>(21i)) | (_e1617 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2128_ = (_e1617 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1658 = phi_2128_;
                                                        phi_2319_ = array<array<f32, 3>, 3>(array<f32, 3>((_e831.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1502, _e1486, _e452) & 2097151u))) - 8388608f) * _e165)), (_e831.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1519, _e1486, _e517) & 2097151u))) - 8388608f) * _e165)), (_e831.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1536, _e1486, _e581) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e831.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1565, _e1550, _e452) & 2097151u))) - 8388608f) * _e165)), (_e831.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1581, _e1550, _e517) & 2097151u))) - 8388608f) * _e165)), (_e831.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1597, _e1550, _e581) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e831.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1626, _e1611, _e452) & 2097151u))) - 8388608f) * _e165)), (_e831.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1642, _e1611, _e517) & 2097151u))) - 8388608f) * _e165)), (_e831.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1658, _e1611, _e581) & 2097151u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1395 = (_e1393 + _e428);
                                                        let _e1396 = (_e1395 < _e109);
                                                        if _e1396 {
                                                            if _e1396 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1398 = global_10.member[_e1395];
                                                            phi_2159_ = _e1398;
                                                        } else {
                                                            phi_2159_ = 0u;
                                                        }
                                                        let _e1400 = phi_2159_;
                                                        let _e1404 = (_e1393 + _e427);
                                                        let _e1405 = (_e1404 < _e109);
                                                        if _e1405 {
                                                            if _e1405 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1407 = global_10.member[_e1404];
                                                            phi_2177_ = _e1407;
                                                        } else {
                                                            phi_2177_ = 0u;
                                                        }
                                                        let _e1409 = phi_2177_;
                                                        let _e1413 = (_e1393 + _e429);
                                                        let _e1414 = (_e1413 < _e109);
                                                        if _e1414 {
                                                            if _e1414 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1416 = global_10.member[_e1413];
                                                            phi_2195_ = _e1416;
                                                        } else {
                                                            phi_2195_ = 0u;
                                                        }
                                                        let _e1418 = phi_2195_;
                                                        let _e1423 = (_e1393 + 3u);
                                                        let _e1424 = (_e1423 + _e428);
                                                        let _e1425 = (_e1424 < _e109);
                                                        if _e1425 {
                                                            if _e1425 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1427 = global_10.member[_e1424];
                                                            phi_2218_ = _e1427;
                                                        } else {
                                                            phi_2218_ = 0u;
                                                        }
                                                        let _e1429 = phi_2218_;
                                                        let _e1433 = (_e1423 + _e427);
                                                        let _e1434 = (_e1433 < _e109);
                                                        if _e1434 {
                                                            if _e1434 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1436 = global_10.member[_e1433];
                                                            phi_2236_ = _e1436;
                                                        } else {
                                                            phi_2236_ = 0u;
                                                        }
                                                        let _e1438 = phi_2236_;
                                                        let _e1442 = (_e1423 + _e429);
                                                        let _e1443 = (_e1442 < _e109);
                                                        if _e1443 {
                                                            if _e1443 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1445 = global_10.member[_e1442];
                                                            phi_2254_ = _e1445;
                                                        } else {
                                                            phi_2254_ = 0u;
                                                        }
                                                        let _e1447 = phi_2254_;
                                                        let _e1452 = (_e1393 + 6u);
                                                        let _e1453 = (_e1452 + _e428);
                                                        let _e1454 = (_e1453 < _e109);
                                                        if _e1454 {
                                                            if _e1454 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1456 = global_10.member[_e1453];
                                                            phi_2277_ = _e1456;
                                                        } else {
                                                            phi_2277_ = 0u;
                                                        }
                                                        let _e1458 = phi_2277_;
                                                        let _e1462 = (_e1452 + _e427);
                                                        let _e1463 = (_e1462 < _e109);
                                                        if _e1463 {
                                                            if _e1463 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1465 = global_10.member[_e1462];
                                                            phi_2295_ = _e1465;
                                                        } else {
                                                            phi_2295_ = 0u;
                                                        }
                                                        let _e1467 = phi_2295_;
                                                        let _e1471 = (_e1452 + _e429);
                                                        let _e1472 = (_e1471 < _e109);
                                                        if _e1472 {
                                                            if _e1472 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e1474 = global_10.member[_e1471];
                                                            phi_2313_ = _e1474;
                                                        } else {
                                                            phi_2313_ = 0u;
                                                        }
                                                        let _e1476 = phi_2313_;
                                                        phi_2319_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1400)) * _e165), (f32(bitcast<i32>(_e1409)) * _e165), (f32(bitcast<i32>(_e1418)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1429)) * _e165), (f32(bitcast<i32>(_e1438)) * _e165), (f32(bitcast<i32>(_e1447)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1458)) * _e165), (f32(bitcast<i32>(_e1467)) * _e165), (f32(bitcast<i32>(_e1476)) * _e165)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2319_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1768 = phi_2319_;
                                                let _e1784 = (_e1768[0][2] - _e604);
                                                let _e1787 = (((_e1768[0][0] - _e475) * _e640) - (_e1784 * _e512));
                                                let _e1790 = (((_e1768[0][1] - _e540) * _e640) - (_e1784 * _e576));
                                                let _e1793 = (_e1768[1][2] - _e604);
                                                let _e1796 = (((_e1768[1][0] - _e475) * _e640) - (_e1793 * _e512));
                                                let _e1799 = (((_e1768[1][1] - _e540) * _e640) - (_e1793 * _e576));
                                                let _e1802 = (_e1768[2][2] - _e604);
                                                let _e1805 = (((_e1768[2][0] - _e475) * _e640) - (_e1802 * _e512));
                                                let _e1808 = (((_e1768[2][1] - _e540) * _e640) - (_e1802 * _e576));
                                                let _e1809 = (_e1805 * _e1799);
                                                let _e1810 = (_e1808 * _e1796);
                                                let _e1811 = (_e1787 * _e1808);
                                                let _e1812 = (_e1790 * _e1805);
                                                let _e1813 = (_e1796 * _e1790);
                                                let _e1814 = (_e1799 * _e1787);
                                                let _e1819 = (((_e1809 >= _e1810) && (_e1811 >= _e1812)) && (_e1813 >= _e1814));
                                                let _e1825 = (_e1819 || (((_e1809 <= _e1810) && (_e1811 <= _e1812)) && (_e1813 <= _e1814)));
                                                if _e1825 {
                                                    let _e1827 = select(-1f, 1f, _e1819);
                                                    let _e1829 = ((_e1809 - _e1810) * _e1827);
                                                    let _e1831 = select(0f, _e1829, (_e1829 > 0f));
                                                    let _e1833 = ((_e1811 - _e1812) * _e1827);
                                                    let _e1835 = select(0f, _e1833, (_e1833 > 0f));
                                                    let _e1837 = ((_e1813 - _e1814) * _e1827);
                                                    let _e1839 = select(0f, _e1837, (_e1837 > 0f));
                                                    let _e1841 = ((_e1831 + _e1835) + _e1839);
                                                    let _e1843 = select(_e1768[1][0], _e1768[0][0], (_e1768[0][0] < _e1768[1][0]));
                                                    let _e1847 = select(_e1768[1][0], _e1768[0][0], (_e1768[0][0] > _e1768[1][0]));
                                                    let _e1851 = select(_e1768[1][1], _e1768[0][1], (_e1768[0][1] < _e1768[1][1]));
                                                    let _e1855 = select(_e1768[1][1], _e1768[0][1], (_e1768[0][1] > _e1768[1][1]));
                                                    let _e1859 = select(_e1768[1][2], _e1768[0][2], (_e1768[0][2] < _e1768[1][2]));
                                                    let _e1863 = select(_e1768[1][2], _e1768[0][2], (_e1768[0][2] > _e1768[1][2]));
                                                    let _e1868 = ((select(_e1768[2][0], _e1843, (_e1843 < _e1768[2][0])) - _e513) * _e516);
                                                    let _e1869 = ((select(_e1768[2][0], _e1847, (_e1847 > _e1768[2][0])) - _e514) * _e516);
                                                    let _e1872 = ((select(_e1768[2][1], _e1851, (_e1851 < _e1768[2][1])) - _e577) * _e580);
                                                    let _e1873 = ((select(_e1768[2][1], _e1855, (_e1855 > _e1768[2][1])) - _e578) * _e580);
                                                    let _e1876 = ((select(_e1768[2][2], _e1859, (_e1859 < _e1768[2][2])) - _e641) * _e644);
                                                    let _e1877 = ((select(_e1768[2][2], _e1863, (_e1863 > _e1768[2][2])) - _e642) * _e644);
                                                    let _e1879 = select(_e1877, _e1876, (_e1876 < _e1877));
                                                    let _e1881 = select(_e1877, _e1876, (_e1876 > _e1877));
                                                    let _e1883 = select(_e1869, _e1868, (_e1868 < _e1869));
                                                    let _e1885 = select(_e1873, _e1872, (_e1872 < _e1873));
                                                    let _e1887 = select(_e1885, _e1883, (_e1883 > _e1885));
                                                    let _e1889 = select(_e1879, _e1887, (_e1887 > _e1879));
                                                    let _e1891 = select(_e1869, _e1868, (_e1868 > _e1869));
                                                    let _e1893 = select(_e1873, _e1872, (_e1872 > _e1873));
                                                    let _e1895 = select(_e1893, _e1891, (_e1891 < _e1893));
                                                    let _e1897 = select(_e1881, _e1895, (_e1895 < _e1881));
                                                    let _e1898 = -(_e1879);
                                                    let _e1904 = select(_e746, _e1889, (_e1889 > _e746));
                                                    let _e1908 = select(_e1796, _e1787, (_e1787 < _e1796));
                                                    let _e1913 = select(_e1796, _e1787, (_e1787 > _e1796));
                                                    let _e1920 = select(_e1799, _e1790, (_e1790 < _e1799));
                                                    let _e1925 = select(_e1799, _e1790, (_e1790 > _e1799));
                                                    let _e1934 = (((((_e1825 && (_e1841 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1805, _e1908, (_e1908 < _e1805)) <= 0f) && (select(_e1805, _e1913, (_e1913 > _e1805)) >= 0f))) && ((select(_e1808, _e1920, (_e1920 < _e1808)) <= 0f) && (select(_e1808, _e1925, (_e1925 > _e1808)) >= 0f))) && (_e1904 <= (_e1897 + (select(_e1898, _e1881, (_e1881 > _e1898)) * 0.0000019073523f)))) && (_e1904 <= _e1321.member_1));
                                                    if _e1934 {
                                                        let _e1939 = (_e1768[1][0] - _e1768[0][0]);
                                                        let _e1940 = (_e1768[1][1] - _e1768[0][1]);
                                                        let _e1941 = (_e1768[1][2] - _e1768[0][2]);
                                                        let _e1942 = vec3<f32>(_e1939, _e1940, _e1941);
                                                        let _e1943 = (_e1768[2][0] - _e1768[1][0]);
                                                        let _e1944 = (_e1768[2][1] - _e1768[1][1]);
                                                        let _e1945 = (_e1768[2][2] - _e1768[1][2]);
                                                        let _e1946 = vec3<f32>(_e1943, _e1944, _e1945);
                                                        let _e1947 = (_e1768[0][0] - _e1768[2][0]);
                                                        let _e1948 = (_e1768[0][1] - _e1768[2][1]);
                                                        let _e1949 = (_e1768[0][2] - _e1768[2][2]);
                                                        let _e1950 = vec3<f32>(_e1947, _e1948, _e1949);
                                                        let _e1953 = bitcast<f32>((bitcast<u32>(_e1939) & 2147483647u));
                                                        let _e1956 = bitcast<f32>((bitcast<u32>(_e1940) & 2147483647u));
                                                        let _e1958 = select(_e1956, _e1953, (_e1953 > _e1956));
                                                        let _e1961 = bitcast<f32>((bitcast<u32>(_e1941) & 2147483647u));
                                                        let _e1963 = select(_e1961, _e1958, (_e1958 > _e1961));
                                                        let _e1966 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                        let _e1969 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                        let _e1971 = select(_e1969, _e1966, (_e1966 > _e1969));
                                                        let _e1974 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                        let _e1976 = select(_e1974, _e1971, (_e1971 > _e1974));
                                                        let _e1979 = bitcast<f32>((bitcast<u32>(_e1947) & 2147483647u));
                                                        let _e1982 = bitcast<f32>((bitcast<u32>(_e1948) & 2147483647u));
                                                        let _e1984 = select(_e1982, _e1979, (_e1979 > _e1982));
                                                        let _e1987 = bitcast<f32>((bitcast<u32>(_e1949) & 2147483647u));
                                                        let _e1989 = select(_e1987, _e1984, (_e1984 > _e1987));
                                                        let _e1991 = select(_e1976, _e1963, (_e1963 > _e1976));
                                                        let _e1993 = select(_e1989, _e1991, (_e1991 > _e1989));
                                                        if (_e1963 == _e1993) {
                                                            phi_2849_ = _e1799;
                                                            phi_2850_ = _e1796;
                                                            phi_2851_ = _e1790;
                                                            phi_2852_ = _e1787;
                                                            phi_2853_ = vec3<f32>(_e1768[0][0], _e1768[0][1], _e1768[0][2]);
                                                            phi_2854_ = _e1950;
                                                            phi_2855_ = _e1946;
                                                            phi_2856_ = _e1942;
                                                        } else {
                                                            let _e1995 = (_e1976 == _e1993);
                                                            let _e2000 = vec3(_e1995);
                                                            phi_2849_ = select(_e1790, _e1808, _e1995);
                                                            phi_2850_ = select(_e1787, _e1805, _e1995);
                                                            phi_2851_ = select(_e1808, _e1799, _e1995);
                                                            phi_2852_ = select(_e1805, _e1796, _e1995);
                                                            phi_2853_ = select(vec3<f32>(_e1768[2][0], _e1768[2][1], _e1768[2][2]), vec3<f32>(_e1768[1][0], _e1768[1][1], _e1768[1][2]), _e2000);
                                                            phi_2854_ = select(_e1946, _e1942, _e2000);
                                                            phi_2855_ = select(_e1942, _e1950, _e2000);
                                                            phi_2856_ = select(_e1950, _e1946, _e2000);
                                                        }
                                                        let _e2006 = phi_2849_;
                                                        let _e2008 = phi_2850_;
                                                        let _e2010 = phi_2851_;
                                                        let _e2012 = phi_2852_;
                                                        let _e2014 = phi_2853_;
                                                        let _e2016 = phi_2854_;
                                                        let _e2018 = phi_2855_;
                                                        let _e2020 = phi_2856_;
                                                        let _e2027 = ((_e2018.y * _e2016.z) - (_e2016.y * _e2018.z));
                                                        let _e2032 = ((_e2018.z * _e2016.x) - (_e2016.z * _e2018.x));
                                                        let _e2035 = ((_e2018.x * _e2016.y) - (_e2016.x * _e2018.y));
                                                        let _e2038 = ((_e1831 >= _e1835) && (_e1831 >= _e1839));
                                                        let _e2039 = (_e1835 >= _e1839);
                                                        let _e2053 = (((_e2027 * (select(select(_e1768[2][0], _e1768[1][0], _e2039), _e1768[0][0], _e2038) - _e475)) + (_e2032 * (select(select(_e1768[2][1], _e1768[1][1], _e2039), _e1768[0][1], _e2038) - _e540))) + (_e2035 * (select(select(_e1768[2][2], _e1768[1][2], _e2039), _e1768[0][2], _e2038) - _e604)));
                                                        let _e2058 = (((_e2027 * _e512) + (_e2032 * _e576)) + (_e2035 * _e640));
                                                        let _e2059 = (_e2008 - _e2012);
                                                        let _e2060 = (_e2006 - _e2010);
                                                        let _e2063 = ((_e2059 * _e2059) + (_e2060 * _e2060));
                                                        let _e2070 = (-(((_e2012 * _e2059) + (_e2010 * _e2060))) / select(0.000000000000000000000000000000000000011754944f, _e2063, (_e2063 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e2072 = select(1f, _e2070, (_e2070 < 1f));
                                                        let _e2074 = select(0f, _e2072, (_e2072 > 0f));
                                                        let _e2083 = ((_e2014.x + (_e2020.x * _e2074)) - _e475);
                                                        let _e2086 = ((_e2014.y + (_e2020.y * _e2074)) - _e540);
                                                        let _e2089 = ((_e2014.z + (_e2020.z * _e2074)) - _e604);
                                                        let _e2092 = bitcast<f32>((bitcast<u32>(_e2083) & 2147483647u));
                                                        let _e2095 = bitcast<f32>((bitcast<u32>(_e2086) & 2147483647u));
                                                        let _e2097 = select(_e2095, _e2092, (_e2092 > _e2095));
                                                        let _e2100 = bitcast<f32>((bitcast<u32>(_e2089) & 2147483647u));
                                                        let _e2102 = select(_e2100, _e2097, (_e2097 > _e2100));
                                                        let _e2108 = bitcast<f32>((bitcast<u32>(_e2027) & 2147483647u));
                                                        let _e2111 = bitcast<f32>((bitcast<u32>(_e2032) & 2147483647u));
                                                        let _e2113 = select(_e2111, _e2108, (_e2108 > _e2111));
                                                        let _e2116 = bitcast<f32>((bitcast<u32>(_e2035) & 2147483647u));
                                                        let _e2135 = bitcast<f32>((bitcast<u32>(_e2018.x) & 2147483647u));
                                                        let _e2138 = bitcast<f32>((bitcast<u32>(_e2018.y) & 2147483647u));
                                                        let _e2140 = select(_e2138, _e2135, (_e2135 > _e2138));
                                                        let _e2143 = bitcast<f32>((bitcast<u32>(_e2018.z) & 2147483647u));
                                                        let _e2149 = bitcast<f32>((bitcast<u32>(_e2016.x) & 2147483647u));
                                                        let _e2152 = bitcast<f32>((bitcast<u32>(_e2016.y) & 2147483647u));
                                                        let _e2154 = select(_e2152, _e2149, (_e2149 > _e2152));
                                                        let _e2157 = bitcast<f32>((bitcast<u32>(_e2016.z) & 2147483647u));
                                                        let _e2163 = ((bitcast<f32>((bitcast<u32>(((((_e2027 * _e2083) + (_e2032 * _e2086)) + (_e2035 * _e2089)) - _e2053)) & 2147483647u)) <= ((0.0000009536743f * select(_e1993, _e2102, (_e2102 > _e1993))) * select(_e2116, _e2113, (_e2113 > _e2116)))) && !((bitcast<f32>((bitcast<u32>(_e2058) & 2147483647u)) <= ((0.0000038146973f * select(_e2143, _e2140, (_e2140 > _e2143))) * select(_e2157, _e2154, (_e2154 > _e2157))))));
                                                        let _e2164 = (_e2053 / _e2058);
                                                        if (_e1934 && !(_e2163)) {
                                                            let _e2167 = (_e2089 / _e640);
                                                            let _e2175 = (((_e2027 * (_e2083 - (_e512 * _e2167))) + (_e2032 * (_e2086 - (_e576 * _e2167)))) / _e2058);
                                                            phi_3047_ = select(select(_e2167, (_e2167 + _e2175), (bitcast<f32>((bitcast<u32>(_e2175) & 2147483647u)) <= _e1993)), _e2164, _e2163);
                                                        } else {
                                                            phi_3047_ = _e2164;
                                                        }
                                                        let _e2184 = phi_3047_;
                                                        let _e2186 = select(_e1897, _e2184, (_e2184 < _e1897));
                                                        let _e2188 = select(_e1889, _e2186, (_e2186 > _e1889));
                                                        let _e2189 = (1f / _e1841);
                                                        phi_3067_ = type_42(_e2188, (_e1835 * _e2189), (_e1839 * _e2189), ((_e1934 && (_e2188 >= _e746)) && (_e2188 <= _e1321.member_1)));
                                                        phi_3068_ = type_42();
                                                    } else {
                                                        phi_3067_ = type_42();
                                                        phi_3068_ = type_42(0f, 0f, 0f, _e1934);
                                                    }
                                                    let _e2198 = phi_3067_;
                                                    let _e2200 = phi_3068_;
                                                    phi_3071_ = _e2198;
                                                    phi_3072_ = _e2200;
                                                    phi_3073_ = select(true, false, _e1934);
                                                } else {
                                                    phi_3071_ = type_42();
                                                    phi_3072_ = type_42(0f, 0f, 0f, _e1825);
                                                    phi_3073_ = true;
                                                }
                                                let _e2203 = phi_3071_;
                                                let _e2205 = phi_3072_;
                                                let _e2207 = phi_3073_;
                                                if _e2207 {
                                                    phi_3077_ = _e2205;
                                                } else {
                                                    phi_3077_ = _e2203;
                                                }
                                                let _e2209 = phi_3077_;
                                                if _e2209.member_3 {
                                                    phi_3086_ = type_21(_e2209.member, _e2209.member_1, _e2209.member_2, _e1381);
                                                } else {
                                                    phi_3086_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2216 = phi_3086_;
                                                if (_e2216.member_3 != 4294967295u) {
                                                    if (_e1381 == _e174) {
                                                        phi_3421_ = false;
                                                    } else {
                                                        let _e2220 = (_e1381 < arrayLength((&global_4.member)));
                                                        if _e2220 {
                                                            if _e2220 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e2222 = global_4.member[_e1381];
                                                            phi_3109_ = _e2222;
                                                        } else {
                                                            phi_3109_ = 4294967295u;
                                                        }
                                                        let _e2224 = phi_3109_;
                                                        let _e2225 = (_e2224 < arrayLength((&global_5.member)));
                                                        if _e2225 {
                                                            if _e2225 {
                                                            } else {
                                                                phi_5300_ = true;
                                                                break;
                                                            }
                                                            let _e2227 = global_5.member[_e2224];
                                                            phi_3123_ = _e2227;
                                                        } else {
                                                            phi_3123_ = 0i;
                                                        }
                                                        let _e2229 = phi_3123_;
                                                        let _e2230 = (_e2229 == 0i);
                                                        if _e2230 {
                                                            phi_3420_ = true;
                                                        } else {
                                                            if _e452 {
                                                                phi_3146_ = vec3<f32>(_e1768[0][0], _e1768[0][1], _e1768[0][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3145_ = vec3<f32>(_e1768[0][2], _e1768[0][0], _e1768[0][1]);
                                                                } else {
                                                                    phi_3145_ = vec3<f32>(_e1768[0][1], _e1768[0][2], _e1768[0][0]);
                                                                }
                                                                let _e2235 = phi_3145_;
                                                                phi_3146_ = _e2235;
                                                            }
                                                            let _e2238 = phi_3146_;
                                                            if _e452 {
                                                                phi_3165_ = vec3<f32>(_e1768[1][0], _e1768[1][1], _e1768[1][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3164_ = vec3<f32>(_e1768[1][2], _e1768[1][0], _e1768[1][1]);
                                                                } else {
                                                                    phi_3164_ = vec3<f32>(_e1768[1][1], _e1768[1][2], _e1768[1][0]);
                                                                }
                                                                let _e2243 = phi_3164_;
                                                                phi_3165_ = _e2243;
                                                            }
                                                            let _e2246 = phi_3165_;
                                                            if _e452 {
                                                                phi_3184_ = vec3<f32>(_e1768[2][0], _e1768[2][1], _e1768[2][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3183_ = vec3<f32>(_e1768[2][2], _e1768[2][0], _e1768[2][1]);
                                                                } else {
                                                                    phi_3183_ = vec3<f32>(_e1768[2][1], _e1768[2][2], _e1768[2][0]);
                                                                }
                                                                let _e2251 = phi_3183_;
                                                                phi_3184_ = _e2251;
                                                            }
                                                            let _e2254 = phi_3184_;
                                                            let _e2257 = (_e2246.x - _e2238.x);
                                                            let _e2260 = (_e2246.y - _e2238.y);
                                                            let _e2263 = (_e2246.z - _e2238.z);
                                                            let _e2265 = (_e2254.x - _e2238.x);
                                                            let _e2267 = (_e2254.y - _e2238.y);
                                                            let _e2269 = (_e2254.z - _e2238.z);
                                                            if (_e306.member_1 == 1u) {
                                                                phi_3220_ = (vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]) - _e2238);
                                                            } else {
                                                                phi_3220_ = vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]);
                                                            }
                                                            let _e2284 = phi_3220_;
                                                            let _e2290 = bitcast<f32>((bitcast<u32>((_e2257 * _e2267)) ^ _e306.member_3[0]));
                                                            let _e2294 = bitcast<f32>((bitcast<u32>((_e2260 * _e2265)) ^ _e306.member_3[0]));
                                                            let _e2298 = bitcast<f32>((bitcast<u32>((_e2260 * _e2269)) ^ _e306.member_3[0]));
                                                            let _e2302 = bitcast<f32>((bitcast<u32>((_e2263 * _e2267)) ^ _e306.member_3[0]));
                                                            let _e2306 = bitcast<f32>((bitcast<u32>((_e2263 * _e2265)) ^ _e306.member_3[0]));
                                                            let _e2310 = bitcast<f32>((bitcast<u32>((_e2257 * _e2269)) ^ _e306.member_3[0]));
                                                            let _e2311 = (_e2298 - _e2302);
                                                            let _e2312 = (_e2306 - _e2310);
                                                            let _e2313 = (_e2290 - _e2294);
                                                            let _e2337 = (bitcast<f32>((bitcast<u32>(_e2298) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2302) & 2147483647u)));
                                                            let _e2344 = (bitcast<f32>((bitcast<u32>(_e2306) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2310) & 2147483647u)));
                                                            let _e2351 = (bitcast<f32>((bitcast<u32>(_e2290) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2294) & 2147483647u)));
                                                            if (_e306.member_2 == 0f) {
                                                                phi_3402_ = 0f;
                                                            } else {
                                                                let _e2381 = bitcast<f32>((bitcast<u32>(_e2311) & 2147483647u));
                                                                let _e2384 = bitcast<f32>((bitcast<u32>(_e2312) & 2147483647u));
                                                                let _e2387 = bitcast<f32>((bitcast<u32>(_e2313) & 2147483647u));
                                                                let _e2389 = select(_e2387, _e2384, (_e2384 > _e2387));
                                                                let _e2393 = select(_e2387, _e2384, (_e2384 < _e2387));
                                                                let _e2397 = select(_e2384, _e2381, (_e2381 < _e2384));
                                                                let _e2399 = select(_e2384, _e2381, (_e2381 > _e2384));
                                                                let _e2401 = select(_e2387, _e2399, (_e2399 < _e2387));
                                                                phi_3402_ = bitcast<f32>((bitcast<u32>((_e306.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2389, _e2381, (_e2381 > _e2389)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2401, _e2397, (_e2397 > _e2401)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2393, _e2381, (_e2381 < _e2393)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2337 + _e2344) + _e2351))) ^ _e306.member_3[0]))) * 1.0000005f)) ^ _e306.member_3[0])))) ^ _e306.member_3[0]));
                                                            }
                                                            let _e2428 = phi_3402_;
                                                            phi_3420_ = (_e2230 || !(((((bitcast<f32>((bitcast<u32>((_e2284.x * _e2311)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2284.y * _e2312)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2284.z * _e2313)) ^ _e306.member_3[0]))) * f32(-(_e2229))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2284.x) & 2147483647u)) * _e2337)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2284.y) & 2147483647u)) * _e2344)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2284.z) & 2147483647u)) * _e2351)) ^ _e306.member_3[0]))))) ^ _e306.member_3[0])) + _e2428) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2442 = phi_3420_;
                                                        phi_3421_ = _e2442;
                                                    }
                                                    let _e2444 = phi_3421_;
                                                    if _e2444 {
                                                        if (_e2216.member < _e1321.member.member) {
                                                            phi_3441_ = true;
                                                        } else {
                                                            if (_e2216.member == _e1321.member.member) {
                                                                phi_3440_ = (_e2216.member_3 < _e1321.member.member_3);
                                                            } else {
                                                                phi_3440_ = false;
                                                            }
                                                            let _e2454 = phi_3440_;
                                                            phi_3441_ = _e2454;
                                                        }
                                                        let _e2456 = phi_3441_;
                                                        if _e2456 {
                                                            phi_3447_ = type_39(_e2216, _e2216.member);
                                                        } else {
                                                            phi_3447_ = _e1321;
                                                        }
                                                        let _e2459 = phi_3447_;
                                                        phi_3448_ = _e2459;
                                                    } else {
                                                        phi_3448_ = _e1321;
                                                    }
                                                    let _e2461 = phi_3448_;
                                                    phi_3449_ = _e2461;
                                                } else {
                                                    phi_3449_ = _e1321;
                                                }
                                                let _e2463 = phi_3449_;
                                                phi_1556_ = _e2463;
                                            } else {
                                                phi_1556_ = type_39();
                                            }
                                            let _e2465 = phi_1556_;
                                            continue;
                                            continuing {
                                                phi_1555_ = _e2465;
                                                phi_1558_ = _e1336;
                                                phi_5300_ = _e788;
                                                break if !(_e1342);
                                            }
                                        }
                                        let _e2468 = phi_5300_;
                                        phi_5532_ = _e2468;
                                        if _e2468 {
                                            break;
                                        }
                                        let _e2470 = local_10;
                                        phi_5536_ = _e2468;
                                        let _e2816 = local_12;
                                        phi_4711_ = _e2816;
                                        phi_4712_ = false;
                                        phi_4713_ = _e831;
                                        phi_4714_ = select(_e833, 0u, (_e746 > _e2470.member_1));
                                    } else {
                                        if (_e831.member_1 >= _e106) {
                                            phi_4250_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e831.member_1 < _e106) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e845 = (_e428 * 2u);
                                            let _e847 = ((1u + _e845) % 7u);
                                            if (_e847 < 7u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e852 = global_9.member[_e831.member_1][_e847];
                                            let _e854 = ((_e845 + 2u) % 7u);
                                            if (_e854 < 7u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e859 = global_9.member[_e831.member_1][_e854];
                                            let _e860 = (_e427 * 2u);
                                            let _e862 = ((1u + _e860) % 7u);
                                            if (_e862 < 7u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e867 = global_9.member[_e831.member_1][_e862];
                                            let _e869 = ((_e860 + 2u) % 7u);
                                            if (_e869 < 7u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e874 = global_9.member[_e831.member_1][_e869];
                                            let _e875 = (_e429 * 2u);
                                            let _e877 = ((1u + _e875) % 7u);
                                            if (_e877 < 7u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e882 = global_9.member[_e831.member_1][_e877];
                                            let _e884 = ((_e875 + 2u) % 7u);
                                            if (_e884 < 7u) {
                                            } else {
                                                phi_5532_ = true;
                                                break;
                                            }
                                            let _e889 = global_9.member[_e831.member_1][_e884];
                                            let _e912 = (bitcast<f32>((bitcast<u32>((_e831.member.member_1.x - _e831.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e913 = (bitcast<f32>((bitcast<u32>((_e831.member.member_1.y - _e831.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e914 = (bitcast<f32>((bitcast<u32>((_e831.member.member_1.z - _e831.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e916 = select(_e165, _e912, (_e912 > _e165));
                                            let _e918 = select(_e165, _e913, (_e913 > _e165));
                                            let _e920 = select(_e165, _e914, (_e914 > _e165));
                                            let _e951 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e852 & 2097151u))) - 8388608f) * _e916));
                                            let _e956 = (bitcast<i32>((_e852 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e959 = bitcast<f32>((_e951 & bitcast<u32>(_e956)));
                                            let _e960 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e867 & 2097151u))) - 8388608f) * _e918));
                                            let _e965 = (bitcast<i32>((_e867 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e968 = bitcast<f32>((_e960 & bitcast<u32>(_e965)));
                                            let _e969 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e882 & 2097151u))) - 8388608f) * _e920));
                                            let _e974 = (bitcast<i32>((_e882 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e977 = bitcast<f32>((_e969 & bitcast<u32>(_e974)));
                                            let _e981 = bitcast<f32>((_e951 & bitcast<u32>(~(_e956))));
                                            let _e985 = bitcast<f32>((_e960 & bitcast<u32>(~(_e965))));
                                            let _e989 = bitcast<f32>((_e969 & bitcast<u32>(~(_e974))));
                                            let _e990 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e859 & 2097151u))) - 8388608f) * _e916));
                                            let _e995 = (bitcast<i32>((_e859 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e998 = bitcast<f32>((_e990 & bitcast<u32>(_e995)));
                                            let _e999 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e874 & 2097151u))) - 8388608f) * _e918));
                                            let _e1004 = (bitcast<i32>((_e874 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1007 = bitcast<f32>((_e999 & bitcast<u32>(_e1004)));
                                            let _e1008 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e889 & 2097151u))) - 8388608f) * _e920));
                                            let _e1013 = (bitcast<i32>((_e889 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1016 = bitcast<f32>((_e1008 & bitcast<u32>(_e1013)));
                                            let _e1020 = bitcast<f32>((_e990 & bitcast<u32>(~(_e995))));
                                            let _e1024 = bitcast<f32>((_e999 & bitcast<u32>(~(_e1004))));
                                            let _e1028 = bitcast<f32>((_e1008 & bitcast<u32>(~(_e1013))));
                                            let _e1029 = (_e831.member.member.x + _e959);
                                            let _e1030 = (_e831.member.member.y + _e968);
                                            let _e1031 = (_e831.member.member.z + _e977);
                                            let _e1034 = (_e831.member.member_1.x - _e998);
                                            let _e1035 = (_e831.member.member_1.y - _e1007);
                                            let _e1036 = (_e831.member.member_1.z - _e1016);
                                            let _e1055 = (_e1034 - _e1029);
                                            let _e1056 = (_e1035 - _e1030);
                                            let _e1057 = (_e1036 - _e1031);
                                            let _e1059 = select(_e1056, _e1055, (_e1055 > _e1056));
                                            let _e1061 = select(_e1057, _e1059, (_e1059 > _e1057));
                                            if (_e1061 < (1024f * _e165)) {
                                                phi_3951_ = 0u;
                                            } else {
                                                phi_3951_ = select(2u, 1u, (_e1061 < (2097152f * _e165)));
                                            }
                                            let _e1068 = phi_3951_;
                                            switch bitcast<i32>(_e1068) {
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
                                            let _e1071 = phi_3957_;
                                            let _e1077 = global_9.member[_e831.member_1][0u];
                                            let _e1081 = global_9.member[_e831.member_1][2u];
                                            let _e1085 = global_9.member[_e831.member_1][4u];
                                            let _e1089 = global_9.member[_e831.member_1][6u];
                                            let _e1101 = (((_e1081 >> bitcast<u32>(22i)) | ((_e1085 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1089 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1102 = (_e1077 & 268435455u);
                                            let _e1103 = (_e1101 & 268435455u);
                                            let _e1106 = ((_e1077 >> bitcast<u32>(28u)) & 7u);
                                            let _e1114 = ((_e1077 >> bitcast<u32>(31i)) | (((_e1101 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1115 = (_e1106 != 0u);
                                            if (_e1106 == 0u) {
                                                phi_4212_ = _e1102;
                                            } else {
                                                if (_e1106 == 7u) {
                                                    phi_4211_ = 2147483648u;
                                                } else {
                                                    phi_4211_ = ((2147483648u | (_e1106 << bitcast<u32>(28u))) | (_e1103 & 268435455u));
                                                }
                                                let _e1124 = phi_4211_;
                                                phi_4212_ = _e1124;
                                            }
                                            let _e1126 = phi_4212_;
                                            if _e1115 {
                                                let _e1127 = (_e1106 != 7u);
                                                if _e1127 {
                                                    phi_4222_ = (_e1103 + (_e1106 * ((3u * _e1071) + 1u)));
                                                } else {
                                                    phi_4222_ = u32();
                                                }
                                                let _e1131 = phi_4222_;
                                                phi_4224_ = _e1131;
                                                phi_4225_ = select(true, false, _e1127);
                                            } else {
                                                phi_4224_ = u32();
                                                phi_4225_ = true;
                                            }
                                            let _e1134 = phi_4224_;
                                            let _e1136 = phi_4225_;
                                            if (_e1114 == 0u) {
                                                phi_4246_ = (_e1102 + select(0u, 1u, !(_e1115)));
                                            } else {
                                                if (_e1114 == 7u) {
                                                    phi_4245_ = 2147483648u;
                                                } else {
                                                    phi_4245_ = ((2147483648u | (_e1114 << bitcast<u32>(28u))) | (select(_e1134, _e1103, _e1136) & 268435455u));
                                                }
                                                let _e1149 = phi_4245_;
                                                phi_4246_ = _e1149;
                                            }
                                            let _e1151 = phi_4246_;
                                            phi_4250_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e1029, (_e831.member.member.x + _e981), _e1034, (_e831.member.member_1.x - _e1020)), vec4<f32>(_e1030, (_e831.member.member.y + _e985), _e1035, (_e831.member.member_1.y - _e1024)), vec4<f32>(_e1031, (_e831.member.member.z + _e989), _e1036, (_e831.member.member_1.z - _e1028))), type_58(type_33((_e831.member.member + vec4<f32>(_e959, _e968, _e977, 0f)), (_e831.member.member_1 - vec4<f32>(_e998, _e1007, _e1016, 0f))), _e1126), type_58(type_33((_e831.member.member + vec4<f32>(_e981, _e985, _e989, 0f)), (_e831.member.member_1 - vec4<f32>(_e1020, _e1024, _e1028, 0f))), _e1151));
                                        }
                                        let _e1156 = phi_4250_;
                                        let _e1168 = ((_e1156.member[0].x - _e513) * _e516);
                                        let _e1169 = ((_e1156.member[0].y - _e513) * _e516);
                                        let _e1170 = ((_e1156.member[0].z - _e514) * _e516);
                                        let _e1171 = ((_e1156.member[0].w - _e514) * _e516);
                                        let _e1181 = ((_e1156.member[1].x - _e577) * _e580);
                                        let _e1182 = ((_e1156.member[1].y - _e577) * _e580);
                                        let _e1183 = ((_e1156.member[1].z - _e578) * _e580);
                                        let _e1184 = ((_e1156.member[1].w - _e578) * _e580);
                                        let _e1194 = ((_e1156.member[2].x - _e641) * _e644);
                                        let _e1195 = ((_e1156.member[2].y - _e641) * _e644);
                                        let _e1196 = ((_e1156.member[2].z - _e642) * _e644);
                                        let _e1197 = ((_e1156.member[2].w - _e642) * _e644);
                                        let _e1199 = select(_e1196, _e1194, (_e1194 < _e1196));
                                        let _e1201 = select(_e1197, _e1195, (_e1195 < _e1197));
                                        let _e1203 = select(_e1196, _e1194, (_e1194 > _e1196));
                                        let _e1205 = select(_e1197, _e1195, (_e1195 > _e1197));
                                        let _e1207 = select(_e1170, _e1168, (_e1168 < _e1170));
                                        let _e1209 = select(_e1171, _e1169, (_e1169 < _e1171));
                                        let _e1211 = select(_e1183, _e1181, (_e1181 < _e1183));
                                        let _e1213 = select(_e1184, _e1182, (_e1182 < _e1184));
                                        let _e1215 = select(_e1211, _e1207, (_e1207 > _e1211));
                                        let _e1217 = select(_e1213, _e1209, (_e1209 > _e1213));
                                        let _e1219 = select(_e1199, _e1215, (_e1215 > _e1199));
                                        let _e1221 = select(_e1201, _e1217, (_e1217 > _e1201));
                                        let _e1223 = select(_e1170, _e1168, (_e1168 > _e1170));
                                        let _e1225 = select(_e1171, _e1169, (_e1169 > _e1171));
                                        let _e1227 = select(_e1183, _e1181, (_e1181 > _e1183));
                                        let _e1229 = select(_e1184, _e1182, (_e1182 > _e1184));
                                        let _e1231 = select(_e1227, _e1223, (_e1223 < _e1227));
                                        let _e1233 = select(_e1229, _e1225, (_e1225 < _e1229));
                                        let _e1238 = -(_e1199);
                                        let _e1239 = -(_e1201);
                                        let _e1246 = (select(_e1203, _e1231, (_e1231 < _e1203)) + (select(_e1238, _e1203, (_e1203 > _e1238)) * 0.0000019073523f));
                                        let _e1247 = (select(_e1205, _e1233, (_e1233 < _e1205)) + (select(_e1239, _e1205, (_e1205 > _e1239)) * 0.0000019073523f));
                                        let _e1249 = select(_e746, _e1219, (_e1219 > _e746));
                                        let _e1251 = select(_e746, _e1221, (_e1221 > _e746));
                                        let _e1256 = (_e1249 <= select(_e790.member_1, _e1246, (_e1246 < _e790.member_1)));
                                        let _e1257 = (_e1251 <= select(_e790.member_1, _e1247, (_e1247 < _e790.member_1)));
                                        let _e1258 = (_e1249 <= _e1251);
                                        if _e1256 {
                                            if _e1257 {
                                                if _e1258 {
                                                    phi_4612_ = _e1156.member_2;
                                                } else {
                                                    phi_4612_ = _e1156.member_1;
                                                }
                                                let _e1262 = phi_4612_;
                                                let _e1283 = (_e833 % 128u);
                                                let _e1284 = (_e1283 < 128u);
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_8[_e1283] = _e1262.member_1;
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_7[_e1283] = _e1262.member.member.x;
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_6[_e1283] = _e1262.member.member.y;
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_5[_e1283] = _e1262.member.member.z;
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_4[_e1283] = _e1262.member.member_1.x;
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_3[_e1283] = _e1262.member.member_1.y;
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_2[_e1283] = _e1262.member.member_1.z;
                                                if _e1284 {
                                                } else {
                                                    phi_5532_ = true;
                                                    break;
                                                }
                                                local_9[_e1283] = select(_e1249, _e1251, _e1258);
                                                if _e1258 {
                                                    phi_4688_ = _e1156.member_1;
                                                } else {
                                                    phi_4688_ = _e1156.member_2;
                                                }
                                                let _e1297 = phi_4688_;
                                                phi_4689_ = _e1297;
                                                phi_4690_ = (_e833 + 1u);
                                            } else {
                                                phi_4689_ = type_58();
                                                phi_4690_ = u32();
                                            }
                                            let _e1299 = phi_4689_;
                                            let _e1301 = phi_4690_;
                                            phi_4692_ = _e1299;
                                            phi_4693_ = _e1301;
                                            phi_4694_ = select(true, false, _e1257);
                                        } else {
                                            phi_4692_ = type_58();
                                            phi_4693_ = u32();
                                            phi_4694_ = true;
                                        }
                                        let _e1304 = phi_4692_;
                                        let _e1306 = phi_4693_;
                                        let _e1308 = phi_4694_;
                                        if _e1308 {
                                            if _e1256 {
                                                phi_4703_ = _e1156.member_1;
                                            } else {
                                                phi_4703_ = _e1156.member_2;
                                            }
                                            let _e1312 = phi_4703_;
                                            phi_4708_ = select(_e1257, true, _e1256);
                                            phi_4709_ = _e1312;
                                        } else {
                                            phi_4708_ = _e829;
                                            phi_4709_ = _e1304;
                                        }
                                        let _e1315 = phi_4708_;
                                        let _e1317 = phi_4709_;
                                        phi_5536_ = _e788;
                                        phi_4711_ = _e790;
                                        phi_4712_ = _e1315;
                                        phi_4713_ = _e1317;
                                        phi_4714_ = select(_e1306, _e833, _e1308);
                                    }
                                    let _e2475 = phi_5536_;
                                    let _e2477 = phi_4711_;
                                    let _e2479 = phi_4712_;
                                    let _e2481 = phi_4713_;
                                    let _e2483 = phi_4714_;
                                    phi_5535_ = _e2475;
                                    phi_4715_ = _e2477;
                                    phi_4716_ = _e2479;
                                    phi_4717_ = _e2481;
                                    phi_4718_ = _e2483;
                                    phi_4719_ = (_e798 - 1u);
                                } else {
                                    phi_5535_ = _e788;
                                    phi_4715_ = _e790;
                                    phi_4716_ = _e829;
                                    phi_4717_ = _e831;
                                    phi_4718_ = _e833;
                                    phi_4719_ = _e798;
                                }
                                let _e2485 = phi_5535_;
                                let _e2487 = phi_4715_;
                                let _e2489 = phi_4716_;
                                let _e2491 = phi_4717_;
                                let _e2493 = phi_4718_;
                                let _e2495 = phi_4719_;
                                phi_5534_ = _e2485;
                                phi_4720_ = _e2487;
                                phi_4721_ = _e2489;
                                phi_4722_ = _e2491;
                                phi_4723_ = _e2493;
                                phi_4724_ = _e2495;
                            } else {
                                phi_5534_ = _e788;
                                phi_4720_ = type_39();
                                phi_4721_ = bool();
                                phi_4722_ = type_58();
                                phi_4723_ = u32();
                                phi_4724_ = u32();
                            }
                            let _e2497 = phi_5534_;
                            let _e2499 = phi_4720_;
                            let _e2501 = phi_4721_;
                            let _e2503 = phi_4722_;
                            let _e2505 = phi_4723_;
                            let _e2507 = phi_4724_;
                            phi_5533_ = _e2497;
                            phi_1429_ = _e2499;
                            phi_1432_ = _e2501;
                            phi_1434_ = _e2503;
                            phi_1436_ = _e2505;
                            phi_1438_ = _e2507;
                            phi_4725_ = _e802;
                        } else {
                            phi_5533_ = _e788;
                            phi_1429_ = type_39();
                            phi_1432_ = bool();
                            phi_1434_ = type_58();
                            phi_1436_ = u32();
                            phi_1438_ = u32();
                            phi_4725_ = false;
                        }
                        let _e2509 = phi_5533_;
                        let _e2511 = phi_1429_;
                        let _e2513 = phi_1432_;
                        let _e2515 = phi_1434_;
                        let _e2517 = phi_1436_;
                        let _e2519 = phi_1438_;
                        let _e2521 = phi_4725_;
                        continue;
                        continuing {
                            phi_5306_ = _e2509;
                            phi_1428_ = _e2511;
                            phi_1431_ = _e2513;
                            phi_1433_ = _e2515;
                            phi_1435_ = _e2517;
                            phi_1437_ = _e2519;
                            phi_5532_ = _e2509;
                            break if !(_e2521);
                        }
                    }
                    let _e2524 = phi_5532_;
                    if _e2524 {
                        break;
                    }
                    let _e2526 = local_11;
                    if (_e2526.member.member_3 != 4294967295u) {
                        let _e2531 = bitcast<u32>(_e2526.member.member);
                        let _e2535 = (bitcast<i32>((_e2531 >> bitcast<u32>(23i))) & 255i);
                        let _e2536 = (_e2535 + _e430);
                        if (_e2535 == 255i) {
                            phi_4784_ = _e2526.member.member;
                        } else {
                            if (_e2535 > 0i) {
                                if (_e2536 > 0i) {
                                    let _e2540 = (_e2536 < 255i);
                                    if _e2540 {
                                        phi_4763_ = bitcast<f32>((_e2531 + bitcast<u32>((_e430 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4763_ = f32();
                                    }
                                    let _e2547 = phi_4763_;
                                    phi_4765_ = _e2547;
                                    phi_4766_ = select(true, false, _e2540);
                                } else {
                                    phi_4765_ = f32();
                                    phi_4766_ = true;
                                }
                                let _e2550 = phi_4765_;
                                let _e2552 = phi_4766_;
                                phi_4767_ = _e2550;
                                phi_4768_ = _e2552;
                            } else {
                                phi_4767_ = f32();
                                phi_4768_ = true;
                            }
                            let _e2554 = phi_4767_;
                            let _e2556 = phi_4768_;
                            if _e2556 {
                                let _e2557 = (_e2531 & 2147483648u);
                                let _e2564 = ((_e2531 & 8388607u) | (select(0u, 1u, ((_e2531 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2568 = (_e2564 == 0u);
                                if _e2568 {
                                    phi_5258_ = bitcast<f32>(_e2557);
                                } else {
                                    let _e2573 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2564)), 32u, _e2568) - 8u);
                                    let _e2576 = (_e2564 << bitcast<u32>((_e2573 & 31u)));
                                    let _e2578 = ((_e2536 + select(0i, 1i, (_e2535 == 0i))) - bitcast<i32>(_e2573));
                                    if (_e2578 >= 255i) {
                                        phi_5248_ = bitcast<f32>((_e2557 | 2139095040u));
                                        phi_5249_ = f32();
                                        phi_5250_ = true;
                                    } else {
                                        let _e2580 = (_e2578 > 0i);
                                        if _e2580 {
                                            phi_5242_ = bitcast<f32>(((_e2557 | (bitcast<u32>(_e2578) << bitcast<u32>(23i))) | (_e2576 & 8388607u)));
                                            phi_5243_ = f32();
                                        } else {
                                            if (_e2578 < -24i) {
                                                phi_5208_ = 26u;
                                            } else {
                                                phi_5208_ = bitcast<u32>((1i - _e2578));
                                            }
                                            let _e2585 = phi_5208_;
                                            let _e2586 = (_e2585 & 31u);
                                            let _e2588 = (_e2576 >> bitcast<u32>(_e2586));
                                            let _e2592 = (_e2576 & ((1u << bitcast<u32>(_e2586)) - 1u));
                                            let _e2596 = (1u << bitcast<u32>(((_e2585 - 1u) & 31u)));
                                            if (_e2592 > _e2596) {
                                                phi_5229_ = true;
                                            } else {
                                                if (_e2592 == _e2596) {
                                                    phi_5226_ = ((_e2588 & 1u) == 1u);
                                                } else {
                                                    phi_5226_ = false;
                                                }
                                                let _e2602 = phi_5226_;
                                                phi_5229_ = _e2602;
                                            }
                                            let _e2604 = phi_5229_;
                                            phi_5242_ = f32();
                                            phi_5243_ = bitcast<f32>((_e2557 | (_e2588 + select(0u, 1u, _e2604))));
                                        }
                                        let _e2617 = phi_5242_;
                                        let _e2619 = phi_5243_;
                                        phi_5248_ = _e2617;
                                        phi_5249_ = _e2619;
                                        phi_5250_ = _e2580;
                                    }
                                    let _e2623 = phi_5248_;
                                    let _e2625 = phi_5249_;
                                    let _e2627 = phi_5250_;
                                    phi_5258_ = select(_e2625, _e2623, _e2627);
                                }
                                let _e2631 = phi_5258_;
                                phi_4783_ = _e2631;
                            } else {
                                phi_4783_ = _e2554;
                            }
                            let _e2633 = phi_4783_;
                            phi_4784_ = _e2633;
                        }
                        let _e2635 = phi_4784_;
                        let _e2636 = bitcast<u32>(_e2635);
                        if ((_e2636 & 2147483647u) >= 2139095040u) {
                            phi_4796_ = bitcast<f32>(((_e2636 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4796_ = _e2635;
                        }
                        let _e2643 = phi_4796_;
                        phi_4801_ = type_21(_e2643, _e2526.member.member_1, _e2526.member.member_2, _e2526.member.member_3);
                    } else {
                        phi_4801_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2648 = phi_4801_;
                    if _e307 {
                    } else {
                        break;
                    }
                    global_7.member[_e153] = _e2648;
                    if _e168 {
                    } else {
                        break;
                    }
                    let _e2652 = select(0u, 1u, (_e374 <= _e384));
                    if (_e2652 > 0u) {
                        let _e2654 = (1u < _e121);
                        if _e2654 {
                            if (0u < _e121) {
                            } else {
                                break;
                            }
                            let _e2658 = atomicAdd((&global_8.member[0u]), _e2652);
                            if ((_e2658 + _e2652) < _e2658) {
                                if _e2654 {
                                } else {
                                    break;
                                }
                                let _e2663 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2666 = select(0u, 1u, (_e2648.member_3 != 4294967295u));
                    if (_e2666 > 0u) {
                        let _e2668 = (3u < _e121);
                        if _e2668 {
                            if (2u < _e121) {
                            } else {
                                break;
                            }
                            let _e2672 = atomicAdd((&global_8.member[2u]), _e2666);
                            if ((_e2672 + _e2666) < _e2672) {
                                if _e2668 {
                                } else {
                                    break;
                                }
                                let _e2677 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
