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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_21>,
}

struct type_36 {
    member: array<array<type_20, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_24,
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
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_46;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

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
    var local_9: array<type_20, 8>;
    var local_10: array<f32, 128>;
    var phi_485_: i32;
    var phi_486_: i32;
    var phi_496_: bool;
    var phi_506_: u32;
    var phi_507_: u32;
    var phi_509_: bool;
    var phi_514_: u32;
    var phi_526_: i32;
    var phi_546_: i32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_610_: f32;
    var phi_616_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_688_: f32;
    var phi_694_: f32;
    var phi_734_: f32;
    var phi_740_: f32;
    var phi_792_: f32;
    var phi_803_: f32;
    var phi_812_: f32;
    var phi_818_: f32;
    var phi_858_: f32;
    var phi_864_: f32;
    var phi_916_: f32;
    var phi_927_: f32;
    var phi_982_: i32;
    var phi_1004_: u32;
    var phi_1005_: u32;
    var phi_1042_: i32;
    var phi_1064_: u32;
    var phi_1065_: u32;
    var phi_1073_: f32;
    var phi_1074_: f32;
    var phi_4895_: bool;
    var phi_4751_: f32;
    var phi_1216_: type_51;
    var phi_1219_: u32;
    var phi_1221_: bool;
    var phi_1223_: u32;
    var phi_1234_: bool;
    var phi_1321_: type_51;
    var phi_1322_: bool;
    var phi_1323_: u32;
    var phi_3518_: u32;
    var phi_3524_: u32;
    var phi_3778_: u32;
    var phi_3779_: u32;
    var phi_3789_: u32;
    var phi_3791_: u32;
    var phi_3792_: bool;
    var phi_3812_: u32;
    var phi_3813_: u32;
    var phi_3817_: type_52;
    var phi_4162_: type_51;
    var phi_4239_: type_51;
    var phi_4240_: type_51;
    var phi_4241_: u32;
    var phi_4243_: type_51;
    var phi_4244_: u32;
    var phi_4245_: bool;
    var phi_4254_: type_51;
    var phi_4259_: type_51;
    var phi_4260_: bool;
    var phi_4892_: bool;
    var phi_4835_: f32;
    var phi_1342_: type_8;
    var phi_1343_: type_8;
    var phi_1366_: type_8;
    var phi_1407_: u32;
    var phi_1413_: u32;
    var phi_1423_: u32;
    var phi_1439_: u32;
    var phi_1472_: u32;
    var phi_1478_: u32;
    var phi_1923_: u32;
    var phi_1941_: u32;
    var phi_1959_: u32;
    var phi_1979_: u32;
    var phi_1997_: u32;
    var phi_2015_: u32;
    var phi_2035_: u32;
    var phi_2053_: u32;
    var phi_2071_: u32;
    var phi_1640_: u32;
    var phi_1655_: u32;
    var phi_1665_: u32;
    var phi_1686_: u32;
    var phi_1707_: u32;
    var phi_1734_: u32;
    var phi_1749_: u32;
    var phi_1759_: u32;
    var phi_1780_: u32;
    var phi_1801_: u32;
    var phi_1828_: u32;
    var phi_1843_: u32;
    var phi_1853_: u32;
    var phi_1874_: u32;
    var phi_1895_: u32;
    var phi_1502_: u32;
    var phi_1548_: u32;
    var phi_1594_: u32;
    var phi_2077_: array<array<f32, 3>, 3>;
    var phi_2195_: bool;
    var phi_2224_: bool;
    var phi_2625_: f32;
    var phi_2626_: f32;
    var phi_2627_: f32;
    var phi_2628_: f32;
    var phi_2629_: vec3<f32>;
    var phi_2630_: vec3<f32>;
    var phi_2631_: vec3<f32>;
    var phi_2632_: vec3<f32>;
    var phi_2663_: bool;
    var phi_2672_: vec3<f32>;
    var phi_2837_: f32;
    var phi_2839_: f32;
    var phi_2840_: bool;
    var phi_2860_: f32;
    var phi_2861_: f32;
    var phi_2884_: type_20;
    var phi_2886_: type_20;
    var phi_2887_: bool;
    var phi_2891_: type_20;
    var phi_2892_: type_20;
    var phi_2893_: type_20;
    var phi_2894_: bool;
    var phi_2898_: type_20;
    var phi_2899_: bool;
    var phi_2900_: type_20;
    var phi_2901_: bool;
    var phi_2902_: bool;
    var phi_2903_: type_20;
    var phi_2904_: bool;
    var phi_2905_: bool;
    var phi_2913_: type_20;
    var phi_2914_: bool;
    var phi_2918_: type_20;
    var phi_2930_: type_8;
    var phi_2933_: type_20;
    var phi_2931_: type_8;
    var phi_2956_: type_8;
    var phi_2988_: bool;
    var phi_2989_: bool;
    var phi_3010_: type_20;
    var phi_2934_: type_20;
    var phi_4863_: bool;
    var phi_5319_: f32;
    var phi_5318_: f32;
    var phi_5073_: bool;
    var phi_5317_: f32;
    var phi_5072_: bool;
    var phi_5316_: f32;
    var phi_5071_: bool;
    var phi_5228_: f32;
    var phi_5070_: bool;
    var phi_5193_: f32;
    var phi_5079_: bool;
    var phi_4262_: type_51;
    var phi_4263_: bool;
    var phi_4264_: u32;
    var phi_5192_: f32;
    var phi_5078_: bool;
    var phi_4265_: type_51;
    var phi_4266_: u32;
    var phi_4267_: bool;
    var phi_4268_: u32;
    var phi_5191_: f32;
    var phi_5077_: bool;
    var phi_4269_: type_51;
    var phi_4270_: u32;
    var phi_4271_: bool;
    var phi_4272_: u32;
    var phi_5190_: f32;
    var phi_5076_: bool;
    var phi_1217_: type_51;
    var phi_1220_: u32;
    var phi_1222_: bool;
    var phi_1224_: u32;
    var phi_4273_: bool;
    var phi_5075_: bool;
    var phi_4280_: type_8;
    var phi_4281_: type_8;
    var phi_4304_: type_8;
    var phi_4356_: f32;
    var phi_4358_: f32;
    var phi_4359_: bool;
    var phi_4360_: f32;
    var phi_4361_: bool;
    var phi_4648_: u32;
    var phi_4666_: bool;
    var phi_4669_: bool;
    var phi_4682_: f32;
    var phi_4683_: f32;
    var phi_4688_: f32;
    var phi_4689_: f32;
    var phi_4690_: bool;
    var phi_4698_: f32;
    var phi_4376_: f32;
    var phi_4377_: f32;
    var phi_4389_: f32;
    var phi_4394_: type_20;
    var phi_5172_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_4.member));
            let _e102 = arrayLength((&global_5.member));
            let _e110 = global_2.member[0u][0u];
            let _e114 = global_2.member[0u][1u];
            let _e118 = global_2.member[0u][2u];
            let _e122 = global_2.member[0u][3u];
            let _e126 = global_2.member[1u][0u];
            let _e130 = global_2.member[1u][1u];
            let _e134 = global_2.member[1u][2u];
            let _e137 = global_1.member[0u];
            let _e138 = bitcast<i32>(_e137);
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e156 = (_e97.x + (_e97.y * 2097152u));
            let _e157 = (_e156 < arrayLength((&global_3.member)));
            if _e157 {
                let _e158 = (_e156 < arrayLength((&global_6.member)));
                if _e158 {
                    if _e157 {
                    } else {
                        break;
                    }
                    let _e166 = global_3.member[_e156].member_2[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e156].member_2[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_3.member[_e156].member_2[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_3.member[_e156].member[0u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_3.member[_e156].member[1u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e201 = global_3.member[_e156].member[2u];
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e205 = select(_e175, _e168, (_e175 < _e168));
                    let _e207 = select(_e182, _e205, (_e182 < _e205));
                    let _e209 = select(_e189, _e207, (_e189 < _e207));
                    let _e211 = select(_e196, _e209, (_e196 < _e209));
                    let _e213 = select(_e203, _e211, (_e203 < _e211));
                    let _e217 = global_3.member[_e156].member_1;
                    let _e218 = bitcast<u32>(_e217);
                    let _e219 = (_e218 & 2147483647u);
                    let _e226 = global_3.member[_e156].member_3;
                    let _e227 = bitcast<u32>(_e226);
                    let _e228 = (_e227 & 2147483647u);
                    let _e232 = (((select(_e219, _e213, (_e219 < _e213)) < 2139095040u) && (_e228 <= 2139095040u)) && (_e207 > 0u));
                    if _e232 {
                        let _e235 = (bitcast<u32>(bitcast<f32>(_e207)) & 2147483647u);
                        if (_e235 >= 8388608u) {
                            phi_485_ = (bitcast<i32>((_e235 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_485_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e235)), 32u, (_e235 == 0u))));
                        }
                        let _e249 = phi_485_;
                        phi_486_ = _e249;
                    } else {
                        phi_486_ = 0i;
                    }
                    let _e251 = phi_486_;
                    let _e252 = (_e168 == _e207);
                    if _e252 {
                        phi_496_ = true;
                    } else {
                        phi_496_ = (_e175 == _e207);
                    }
                    let _e255 = phi_496_;
                    let _e256 = select(1u, 0u, _e252);
                    if _e255 {
                        let _e257 = (_e256 + 1u);
                        phi_506_ = _e257;
                        phi_507_ = _e257;
                        phi_509_ = select(true, false, (_e257 == 2u));
                    } else {
                        phi_506_ = u32();
                        phi_507_ = 0u;
                        phi_509_ = true;
                    }
                    let _e261 = phi_506_;
                    let _e263 = phi_507_;
                    let _e265 = phi_509_;
                    if _e265 {
                        phi_514_ = (_e263 + 1u);
                    } else {
                        phi_514_ = 0u;
                    }
                    let _e269 = phi_514_;
                    let _e270 = select(_e261, _e263, _e265);
                    let _e271 = select(_e256, select(2u, _e256, _e255), _e265);
                    if (_e138 < -126i) {
                        phi_526_ = -126i;
                    } else {
                        phi_526_ = select(_e138, 127i, (_e138 > 127i));
                    }
                    let _e276 = phi_526_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e138 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = -(_e251);
                    if (_e288 < -126i) {
                        phi_546_ = -126i;
                    } else {
                        phi_546_ = select(_e288, 127i, (_e288 > 127i));
                    }
                    let _e293 = phi_546_;
                    let _e298 = bitcast<f32>((bitcast<u32>((_e293 + 127i)) << bitcast<u32>(23i)));
                    let _e304 = bitcast<f32>((bitcast<u32>(((_e288 - _e293) + 127i)) << bitcast<u32>(23i)));
                    let _e308 = global_3.member[_e156].member;
                    let _e309 = (_e270 == 0u);
                    if _e309 {
                        phi_564_ = _e308[0];
                    } else {
                        phi_564_ = _e308[1];
                    }
                    let _e313 = phi_564_;
                    let _e314 = (_e270 == 2u);
                    if _e314 {
                        phi_570_ = _e308[2];
                    } else {
                        phi_570_ = _e313;
                    }
                    let _e317 = phi_570_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e281) * select(0.00000011920929f, 1f, _e320)) * _e287);
                    let _e335 = global_3.member[_e156].member_2;
                    if _e309 {
                        phi_610_ = _e335[0];
                    } else {
                        phi_610_ = _e335[1];
                    }
                    let _e339 = phi_610_;
                    if _e314 {
                        phi_616_ = _e335[2];
                    } else {
                        phi_616_ = _e339;
                    }
                    let _e342 = phi_616_;
                    let _e343 = bitcast<u32>(_e342);
                    let _e345 = ((_e343 & 2139095040u) != 0u);
                    let _e359 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e343 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e343 & 2147483648u))), _e342, _e345) * _e298) * select(0.00000011920929f, 1f, _e345)) * _e304);
                    let _e363 = (bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e363 {
                        let _e367 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) * 0.00000011920929f);
                        phi_668_ = select(0.00000000000011368684f, _e367, (_e367 > 0.00000000000011368684f));
                    } else {
                        phi_668_ = 0f;
                    }
                    let _e371 = phi_668_;
                    let _e372 = (_e334 + _e371);
                    let _e373 = (_e334 - _e371);
                    let _e374 = select(_e359, 0f, _e363);
                    if _e363 {
                        phi_679_ = 38685626000000000000000000f;
                    } else {
                        phi_679_ = (1f / _e359);
                    }
                    let _e377 = phi_679_;
                    let _e378 = (_e269 == 0u);
                    if _e378 {
                        phi_688_ = _e308[0];
                    } else {
                        phi_688_ = _e308[1];
                    }
                    let _e382 = phi_688_;
                    let _e383 = (_e269 == 2u);
                    if _e383 {
                        phi_694_ = _e308[2];
                    } else {
                        phi_694_ = _e382;
                    }
                    let _e386 = phi_694_;
                    let _e387 = bitcast<u32>(_e386);
                    let _e389 = ((_e387 & 2139095040u) != 0u);
                    let _e403 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * _e281) * select(0.00000011920929f, 1f, _e389)) * _e287);
                    if _e378 {
                        phi_734_ = _e335[0];
                    } else {
                        phi_734_ = _e335[1];
                    }
                    let _e407 = phi_734_;
                    if _e383 {
                        phi_740_ = _e335[2];
                    } else {
                        phi_740_ = _e407;
                    }
                    let _e410 = phi_740_;
                    let _e411 = bitcast<u32>(_e410);
                    let _e413 = ((_e411 & 2139095040u) != 0u);
                    let _e427 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e411 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e411 & 2147483648u))), _e410, _e413) * _e298) * select(0.00000011920929f, 1f, _e413)) * _e304);
                    let _e431 = (bitcast<f32>((bitcast<u32>(_e427) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e431 {
                        let _e435 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) * 0.00000011920929f);
                        phi_792_ = select(0.00000000000011368684f, _e435, (_e435 > 0.00000000000011368684f));
                    } else {
                        phi_792_ = 0f;
                    }
                    let _e439 = phi_792_;
                    let _e440 = (_e403 + _e439);
                    let _e441 = (_e403 - _e439);
                    let _e442 = select(_e427, 0f, _e431);
                    if _e431 {
                        phi_803_ = 38685626000000000000000000f;
                    } else {
                        phi_803_ = (1f / _e427);
                    }
                    let _e445 = phi_803_;
                    let _e446 = (_e271 == 0u);
                    if _e446 {
                        phi_812_ = _e308[0];
                    } else {
                        phi_812_ = _e308[1];
                    }
                    let _e450 = phi_812_;
                    let _e451 = (_e271 == 2u);
                    if _e451 {
                        phi_818_ = _e308[2];
                    } else {
                        phi_818_ = _e450;
                    }
                    let _e454 = phi_818_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e281) * select(0.00000011920929f, 1f, _e457)) * _e287);
                    if _e446 {
                        phi_858_ = _e335[0];
                    } else {
                        phi_858_ = _e335[1];
                    }
                    let _e475 = phi_858_;
                    if _e451 {
                        phi_864_ = _e335[2];
                    } else {
                        phi_864_ = _e475;
                    }
                    let _e478 = phi_864_;
                    let _e479 = bitcast<u32>(_e478);
                    let _e481 = ((_e479 & 2139095040u) != 0u);
                    let _e495 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e479 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e479 & 2147483648u))), _e478, _e481) * _e298) * select(0.00000011920929f, 1f, _e481)) * _e304);
                    let _e499 = (bitcast<f32>((bitcast<u32>(_e495) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e499 {
                        let _e503 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                        phi_916_ = select(0.00000000000011368684f, _e503, (_e503 > 0.00000000000011368684f));
                    } else {
                        phi_916_ = 0f;
                    }
                    let _e507 = phi_916_;
                    let _e508 = (_e471 + _e507);
                    let _e509 = (_e471 - _e507);
                    let _e510 = select(_e495, 0f, _e499);
                    if _e499 {
                        phi_927_ = 38685626000000000000000000f;
                    } else {
                        phi_927_ = (1f / _e495);
                    }
                    let _e513 = phi_927_;
                    let _e516 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
                    let _e519 = bitcast<f32>((bitcast<u32>(_e403) & 2147483647u));
                    let _e521 = select(_e519, _e516, (_e516 > _e519));
                    let _e524 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                    let _e527 = (_e138 + _e251);
                    if (_e232 && (select(_e524, _e521, (_e521 > _e524)) <= 1099511600000f)) {
                        let _e537 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e540 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                        let _e544 = (_e537 == 0u);
                        let _e547 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e537)), 32u, _e544)) - 8i);
                        if (_e540 == 255i) {
                            phi_982_ = 255i;
                        } else {
                            phi_982_ = (((_e540 + select(0i, 1i, (_e540 == 0i))) - _e547) + _e527);
                        }
                        let _e555 = phi_982_;
                        let _e565 = (_e555 <= 0i);
                        if _e565 {
                            phi_1005_ = u32();
                        } else {
                            if _e544 {
                                phi_1004_ = u32();
                            } else {
                                phi_1004_ = select(((bitcast<u32>(_e555) << bitcast<u32>(23i)) | ((_e537 << bitcast<u32>(((_e547 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e555 >= 255i));
                            }
                            let _e569 = phi_1004_;
                            phi_1005_ = _e569;
                        }
                        let _e571 = phi_1005_;
                        let _e583 = ((_e228 & 8388607u) | (select(0u, 1u, ((_e228 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e586 = bitcast<i32>((_e228 >> bitcast<u32>(23i)));
                        let _e590 = (_e583 == 0u);
                        let _e593 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e583)), 32u, _e590)) - 8i);
                        if (_e586 == 255i) {
                            phi_1042_ = 255i;
                        } else {
                            phi_1042_ = (((_e586 + select(0i, 1i, (_e586 == 0i))) - _e593) + _e527);
                        }
                        let _e601 = phi_1042_;
                        let _e611 = (_e601 <= 0i);
                        if _e611 {
                            phi_1065_ = u32();
                        } else {
                            if _e590 {
                                phi_1064_ = u32();
                            } else {
                                phi_1064_ = select(((bitcast<u32>(_e601) << bitcast<u32>(23i)) | ((_e583 << bitcast<u32>(((_e593 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e601 >= 255i));
                            }
                            let _e615 = phi_1064_;
                            phi_1065_ = _e615;
                        }
                        let _e617 = phi_1065_;
                        phi_1073_ = bitcast<f32>(((_e227 & 2147483648u) | select(_e617, 0u, select(_e590, true, _e611))));
                        phi_1074_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e571, 0u, select(_e544, true, _e565))));
                    } else {
                        phi_1073_ = 0f;
                        phi_1074_ = 1f;
                    }
                    let _e623 = phi_1073_;
                    let _e625 = phi_1074_;
                    local_9 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e628 = (_e270 % 3u);
                    let _e629 = (_e628 < 3u);
                    if _e629 {
                    } else {
                        break;
                    }
                    let _e631 = local_1[_e628];
                    let _e634 = (_e269 % 3u);
                    let _e635 = (_e634 < 3u);
                    if _e635 {
                    } else {
                        break;
                    }
                    let _e637 = local_1[_e634];
                    let _e640 = (_e271 % 3u);
                    let _e641 = (_e640 < 3u);
                    if _e641 {
                    } else {
                        break;
                    }
                    let _e643 = local_1[_e640];
                    if _e629 {
                    } else {
                        break;
                    }
                    let _e648 = local[_e628];
                    if _e635 {
                    } else {
                        break;
                    }
                    let _e652 = local[_e634];
                    if _e641 {
                    } else {
                        break;
                    }
                    let _e656 = local[_e640];
                    phi_4895_ = false;
                    phi_4751_ = _e623;
                    phi_1216_ = type_51(type_24(vec4<f32>((f32(_e631) * _e150), (f32(_e637) * _e150), (f32(_e643) * _e150), 0f), vec4<f32>((f32(_e648) * _e150), (f32(_e652) * _e150), (f32(_e656) * _e150), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    phi_1219_ = ((3u * _e99) + 1u);
                    phi_1221_ = (_e625 <= _e623);
                    phi_1223_ = 0u;
                    loop {
                        let _e666 = phi_4895_;
                        let _e668 = phi_4751_;
                        let _e670 = phi_1216_;
                        let _e672 = phi_1219_;
                        let _e674 = phi_1221_;
                        let _e676 = phi_1223_;
                        if _e674 {
                            phi_1234_ = true;
                        } else {
                            phi_1234_ = (_e676 > 0u);
                        }
                        let _e679 = phi_1234_;
                        if _e679 {
                            let _e680 = (_e672 > 0u);
                            if _e680 {
                                if _e674 {
                                    phi_1321_ = _e670;
                                    phi_1322_ = _e674;
                                    phi_1323_ = _e676;
                                } else {
                                    let _e681 = (_e676 - 1u);
                                    let _e682 = (_e681 % 128u);
                                    let _e683 = (_e682 < 128u);
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e685 = local_7[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e687 = local_6[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e689 = local_5[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e691 = local_4[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e693 = local_3[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e695 = local_2[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e700 = local_8[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5075_ = true;
                                        break;
                                    }
                                    let _e703 = local_10[_e682];
                                    phi_1321_ = type_51(type_24(vec4<f32>(_e685, _e687, _e689, 0f), vec4<f32>(_e691, _e693, _e695, 0f)), _e700);
                                    phi_1322_ = (_e703 <= _e668);
                                    phi_1323_ = _e681;
                                }
                                let _e706 = phi_1321_;
                                let _e708 = phi_1322_;
                                let _e710 = phi_1323_;
                                if _e708 {
                                    let _e715 = (_e706.member_1 & 268435455u);
                                    if ((_e706.member_1 & 2147483648u) != 0u) {
                                        phi_4892_ = _e666;
                                        phi_4835_ = _e668;
                                        phi_1342_ = type_8(0u, ((_e706.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1198 = phi_4892_;
                                            let _e1200 = phi_4835_;
                                            let _e1202 = phi_1342_;
                                            if (_e1202.member < _e1202.member_1) {
                                                phi_1343_ = type_8((_e1202.member + 1u), _e1202.member_1);
                                                phi_1366_ = type_8(1u, _e1202.member);
                                            } else {
                                                phi_1343_ = _e1202;
                                                phi_1366_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1215 = phi_1343_;
                                            let _e1217 = phi_1366_;
                                            let _e1221 = (bitcast<i32>(_e1217.member) != 0i);
                                            if _e1221 {
                                                let _e1226 = (_e706.member.member_1.x - _e706.member.member.x);
                                                let _e1229 = (_e706.member.member_1.y - _e706.member.member.y);
                                                let _e1232 = (_e706.member.member_1.z - _e706.member.member.z);
                                                let _e1234 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                let _e1236 = select(_e1232, _e1234, (_e1234 > _e1232));
                                                let _e1238 = (_e1236 < (1024f * _e150));
                                                if _e1238 {
                                                    phi_1407_ = 0u;
                                                } else {
                                                    phi_1407_ = select(2u, 1u, (_e1236 < (2097152f * _e150)));
                                                }
                                                let _e1243 = phi_1407_;
                                                switch bitcast<i32>(_e1243) {
                                                    case 0: {
                                                        phi_1413_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1413_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1413_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1413_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1246 = phi_1413_;
                                                switch bitcast<i32>(_e1243) {
                                                    case 0: {
                                                        phi_1423_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1423_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1423_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1423_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1253 = phi_1423_;
                                                let _e1255 = ((_e715 + (_e1217.member_1 * ((3u * _e1246) + 1u))) + (3u * _e1253));
                                                let _e1256 = (_e1255 < _e102);
                                                if _e1256 {
                                                    if _e1256 {
                                                    } else {
                                                        phi_5228_ = _e1200;
                                                        phi_5070_ = true;
                                                        break;
                                                    }
                                                    let _e1258 = global_5.member[_e1255];
                                                    phi_1439_ = _e1258;
                                                } else {
                                                    phi_1439_ = 4294967295u;
                                                }
                                                let _e1260 = phi_1439_;
                                                if _e1238 {
                                                    phi_1472_ = 0u;
                                                } else {
                                                    phi_1472_ = select(2u, 1u, (_e1236 < (2097152f * _e150)));
                                                }
                                                let _e1265 = phi_1472_;
                                                switch bitcast<i32>(_e1265) {
                                                    case 0: {
                                                        phi_1478_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1478_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1478_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1478_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1268 = phi_1478_;
                                                let _e1272 = (_e715 + (_e1217.member_1 * ((3u * _e1268) + 1u)));
                                                switch bitcast<i32>(_e1265) {
                                                    case 0: {
                                                        let _e1547 = (_e1272 < _e102);
                                                        if _e1547 {
                                                            if _e1547 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1549 = global_5.member[_e1272];
                                                            phi_1502_ = _e1549;
                                                        } else {
                                                            phi_1502_ = 0u;
                                                        }
                                                        let _e1551 = phi_1502_;
                                                        let _e1553 = ((10u * _e270) & 31u);
                                                        let _e1563 = ((10u * _e269) & 31u);
                                                        let _e1573 = ((10u * _e271) & 31u);
                                                        let _e1583 = (_e1272 + 1u);
                                                        let _e1584 = (_e1583 < _e102);
                                                        if _e1584 {
                                                            if _e1584 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1586 = global_5.member[_e1583];
                                                            phi_1548_ = _e1586;
                                                        } else {
                                                            phi_1548_ = 0u;
                                                        }
                                                        let _e1588 = phi_1548_;
                                                        let _e1614 = (_e1272 + 2u);
                                                        let _e1615 = (_e1614 < _e102);
                                                        if _e1615 {
                                                            if _e1615 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1617 = global_5.member[_e1614];
                                                            phi_1594_ = _e1617;
                                                        } else {
                                                            phi_1594_ = 0u;
                                                        }
                                                        let _e1619 = phi_1594_;
                                                        phi_2077_ = array<array<f32, 3>, 3>(array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1551 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e150)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1551 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e150)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1551 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1588 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e150)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1588 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e150)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1588 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1619 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e150)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1619 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e150)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1619 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1361 = (_e1272 < _e102);
                                                        if _e1361 {
                                                            if _e1361 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1363 = global_5.member[_e1272];
                                                            phi_1640_ = _e1363;
                                                        } else {
                                                            phi_1640_ = 0u;
                                                        }
                                                        let _e1365 = phi_1640_;
                                                        let _e1366 = (_e1272 + 1u);
                                                        let _e1367 = (_e1366 < _e102);
                                                        if _e1367 {
                                                            if _e1367 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1369 = global_5.member[_e1366];
                                                            phi_1655_ = _e1369;
                                                        } else {
                                                            phi_1655_ = 0u;
                                                        }
                                                        let _e1371 = phi_1655_;
                                                        let _e1372 = (_e270 == 1u);
                                                        if _e1372 {
                                                            phi_1665_ = ((_e1365 >> bitcast<u32>(21i)) | (_e1371 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1665_ = (_e1371 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1381 = phi_1665_;
                                                        let _e1389 = (_e269 == 1u);
                                                        if _e1389 {
                                                            phi_1686_ = ((_e1365 >> bitcast<u32>(21i)) | (_e1371 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1686_ = (_e1371 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1398 = phi_1686_;
                                                        let _e1406 = (_e271 == 1u);
                                                        if _e1406 {
                                                            phi_1707_ = ((_e1365 >> bitcast<u32>(21i)) | (_e1371 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1707_ = (_e1371 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1415 = phi_1707_;
                                                        let _e1424 = (_e1272 + 2u);
                                                        let _e1425 = (_e1424 < _e102);
                                                        if _e1425 {
                                                            if _e1425 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1427 = global_5.member[_e1424];
                                                            phi_1734_ = _e1427;
                                                        } else {
                                                            phi_1734_ = 0u;
                                                        }
                                                        let _e1429 = phi_1734_;
                                                        let _e1430 = (_e1272 + 3u);
                                                        let _e1431 = (_e1430 < _e102);
                                                        if _e1431 {
                                                            if _e1431 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1433 = global_5.member[_e1430];
                                                            phi_1749_ = _e1433;
                                                        } else {
                                                            phi_1749_ = 0u;
                                                        }
                                                        let _e1435 = phi_1749_;
                                                        if _e1372 {
                                                            phi_1759_ = ((_e1429 >> bitcast<u32>(21i)) | (_e1435 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1759_ = (_e1435 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1444 = phi_1759_;
                                                        if _e1389 {
                                                            phi_1780_ = ((_e1429 >> bitcast<u32>(21i)) | (_e1435 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1780_ = (_e1435 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1460 = phi_1780_;
                                                        if _e1406 {
                                                            phi_1801_ = ((_e1429 >> bitcast<u32>(21i)) | (_e1435 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1801_ = (_e1435 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1476 = phi_1801_;
                                                        let _e1485 = (_e1272 + 4u);
                                                        let _e1486 = (_e1485 < _e102);
                                                        if _e1486 {
                                                            if _e1486 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1488 = global_5.member[_e1485];
                                                            phi_1828_ = _e1488;
                                                        } else {
                                                            phi_1828_ = 0u;
                                                        }
                                                        let _e1490 = phi_1828_;
                                                        let _e1491 = (_e1272 + 5u);
                                                        let _e1492 = (_e1491 < _e102);
                                                        if _e1492 {
                                                            if _e1492 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1494 = global_5.member[_e1491];
                                                            phi_1843_ = _e1494;
                                                        } else {
                                                            phi_1843_ = 0u;
                                                        }
                                                        let _e1496 = phi_1843_;
                                                        if _e1372 {
                                                            phi_1853_ = ((_e1490 >> bitcast<u32>(21i)) | (_e1496 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1853_ = (_e1496 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1505 = phi_1853_;
                                                        if _e1389 {
                                                            phi_1874_ = ((_e1490 >> bitcast<u32>(21i)) | (_e1496 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1874_ = (_e1496 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1521 = phi_1874_;
                                                        if _e1406 {
                                                            phi_1895_ = ((_e1490 >> bitcast<u32>(21i)) | (_e1496 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1895_ = (_e1496 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1537 = phi_1895_;
                                                        phi_2077_ = array<array<f32, 3>, 3>(array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1381, _e1365, _e309) & 2097151u))) - 8388608f) * _e150)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1398, _e1365, _e378) & 2097151u))) - 8388608f) * _e150)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1415, _e1365, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1444, _e1429, _e309) & 2097151u))) - 8388608f) * _e150)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1460, _e1429, _e378) & 2097151u))) - 8388608f) * _e150)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1476, _e1429, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1505, _e1490, _e309) & 2097151u))) - 8388608f) * _e150)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1521, _e1490, _e378) & 2097151u))) - 8388608f) * _e150)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1537, _e1490, _e446) & 2097151u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1274 = (_e1272 + _e270);
                                                        let _e1275 = (_e1274 < _e102);
                                                        if _e1275 {
                                                            if _e1275 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1277 = global_5.member[_e1274];
                                                            phi_1923_ = _e1277;
                                                        } else {
                                                            phi_1923_ = 0u;
                                                        }
                                                        let _e1279 = phi_1923_;
                                                        let _e1283 = (_e1272 + _e269);
                                                        let _e1284 = (_e1283 < _e102);
                                                        if _e1284 {
                                                            if _e1284 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1286 = global_5.member[_e1283];
                                                            phi_1941_ = _e1286;
                                                        } else {
                                                            phi_1941_ = 0u;
                                                        }
                                                        let _e1288 = phi_1941_;
                                                        let _e1292 = (_e1272 + _e271);
                                                        let _e1293 = (_e1292 < _e102);
                                                        if _e1293 {
                                                            if _e1293 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1295 = global_5.member[_e1292];
                                                            phi_1959_ = _e1295;
                                                        } else {
                                                            phi_1959_ = 0u;
                                                        }
                                                        let _e1297 = phi_1959_;
                                                        let _e1302 = (_e1272 + 3u);
                                                        let _e1303 = (_e1302 + _e270);
                                                        let _e1304 = (_e1303 < _e102);
                                                        if _e1304 {
                                                            if _e1304 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1306 = global_5.member[_e1303];
                                                            phi_1979_ = _e1306;
                                                        } else {
                                                            phi_1979_ = 0u;
                                                        }
                                                        let _e1308 = phi_1979_;
                                                        let _e1312 = (_e1302 + _e269);
                                                        let _e1313 = (_e1312 < _e102);
                                                        if _e1313 {
                                                            if _e1313 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1315 = global_5.member[_e1312];
                                                            phi_1997_ = _e1315;
                                                        } else {
                                                            phi_1997_ = 0u;
                                                        }
                                                        let _e1317 = phi_1997_;
                                                        let _e1321 = (_e1302 + _e271);
                                                        let _e1322 = (_e1321 < _e102);
                                                        if _e1322 {
                                                            if _e1322 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1324 = global_5.member[_e1321];
                                                            phi_2015_ = _e1324;
                                                        } else {
                                                            phi_2015_ = 0u;
                                                        }
                                                        let _e1326 = phi_2015_;
                                                        let _e1331 = (_e1272 + 6u);
                                                        let _e1332 = (_e1331 + _e270);
                                                        let _e1333 = (_e1332 < _e102);
                                                        if _e1333 {
                                                            if _e1333 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1335 = global_5.member[_e1332];
                                                            phi_2035_ = _e1335;
                                                        } else {
                                                            phi_2035_ = 0u;
                                                        }
                                                        let _e1337 = phi_2035_;
                                                        let _e1341 = (_e1331 + _e269);
                                                        let _e1342 = (_e1341 < _e102);
                                                        if _e1342 {
                                                            if _e1342 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1344 = global_5.member[_e1341];
                                                            phi_2053_ = _e1344;
                                                        } else {
                                                            phi_2053_ = 0u;
                                                        }
                                                        let _e1346 = phi_2053_;
                                                        let _e1350 = (_e1331 + _e271);
                                                        let _e1351 = (_e1350 < _e102);
                                                        if _e1351 {
                                                            if _e1351 {
                                                            } else {
                                                                phi_5228_ = _e1200;
                                                                phi_5070_ = true;
                                                                break;
                                                            }
                                                            let _e1353 = global_5.member[_e1350];
                                                            phi_2071_ = _e1353;
                                                        } else {
                                                            phi_2071_ = 0u;
                                                        }
                                                        let _e1355 = phi_2071_;
                                                        phi_2077_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1279)) * _e150), (f32(bitcast<i32>(_e1288)) * _e150), (f32(bitcast<i32>(_e1297)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1308)) * _e150), (f32(bitcast<i32>(_e1317)) * _e150), (f32(bitcast<i32>(_e1326)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1337)) * _e150), (f32(bitcast<i32>(_e1346)) * _e150), (f32(bitcast<i32>(_e1355)) * _e150)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2077_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1647 = phi_2077_;
                                                let _e1654 = (_e1647[0][2] - _e471);
                                                let _e1657 = (((_e1647[0][0] - _e334) * _e510) - (_e1654 * _e374));
                                                let _e1660 = (((_e1647[0][1] - _e403) * _e510) - (_e1654 * _e442));
                                                let _e1667 = (_e1647[1][2] - _e471);
                                                let _e1670 = (((_e1647[1][0] - _e334) * _e510) - (_e1667 * _e374));
                                                let _e1673 = (((_e1647[1][1] - _e403) * _e510) - (_e1667 * _e442));
                                                let _e1680 = (_e1647[2][2] - _e471);
                                                let _e1683 = (((_e1647[2][0] - _e334) * _e510) - (_e1680 * _e374));
                                                let _e1686 = (((_e1647[2][1] - _e403) * _e510) - (_e1680 * _e442));
                                                let _e1687 = (_e1683 * _e1673);
                                                let _e1688 = (_e1686 * _e1670);
                                                let _e1689 = (_e1657 * _e1686);
                                                let _e1690 = (_e1660 * _e1683);
                                                let _e1691 = (_e1670 * _e1660);
                                                let _e1692 = (_e1673 * _e1657);
                                                let _e1697 = (((_e1687 >= _e1688) && (_e1689 >= _e1690)) && (_e1691 >= _e1692));
                                                if (_e1697 || (((_e1687 <= _e1688) && (_e1689 <= _e1690)) && (_e1691 <= _e1692))) {
                                                    let _e1704 = select(-1f, 1f, _e1697);
                                                    let _e1706 = ((_e1687 - _e1688) * _e1704);
                                                    let _e1708 = select(0f, _e1706, (_e1706 > 0f));
                                                    let _e1710 = ((_e1689 - _e1690) * _e1704);
                                                    let _e1712 = select(0f, _e1710, (_e1710 > 0f));
                                                    let _e1714 = ((_e1691 - _e1692) * _e1704);
                                                    let _e1716 = select(0f, _e1714, (_e1714 > 0f));
                                                    let _e1718 = ((_e1708 + _e1712) + _e1716);
                                                    if (_e1718 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2903_ = type_20();
                                                        phi_2904_ = true;
                                                        phi_2905_ = false;
                                                    } else {
                                                        let _e1721 = select(_e1670, _e1657, (_e1657 < _e1670));
                                                        if (select(_e1683, _e1721, (_e1721 < _e1683)) > 0f) {
                                                            phi_2195_ = true;
                                                        } else {
                                                            let _e1726 = select(_e1670, _e1657, (_e1657 > _e1670));
                                                            phi_2195_ = (select(_e1683, _e1726, (_e1726 > _e1683)) < 0f);
                                                        }
                                                        let _e1731 = phi_2195_;
                                                        if _e1731 {
                                                            phi_2900_ = type_20();
                                                            phi_2901_ = true;
                                                            phi_2902_ = false;
                                                        } else {
                                                            let _e1733 = select(_e1673, _e1660, (_e1660 < _e1673));
                                                            if (select(_e1686, _e1733, (_e1733 < _e1686)) > 0f) {
                                                                phi_2224_ = true;
                                                            } else {
                                                                let _e1738 = select(_e1673, _e1660, (_e1660 > _e1673));
                                                                phi_2224_ = (select(_e1686, _e1738, (_e1738 > _e1686)) < 0f);
                                                            }
                                                            let _e1743 = phi_2224_;
                                                            if _e1743 {
                                                                phi_2898_ = type_20();
                                                                phi_2899_ = false;
                                                            } else {
                                                                let _e1745 = select(_e1647[1][0], _e1647[0][0], (_e1647[0][0] < _e1647[1][0]));
                                                                let _e1749 = select(_e1647[1][0], _e1647[0][0], (_e1647[0][0] > _e1647[1][0]));
                                                                let _e1753 = select(_e1647[1][1], _e1647[0][1], (_e1647[0][1] < _e1647[1][1]));
                                                                let _e1757 = select(_e1647[1][1], _e1647[0][1], (_e1647[0][1] > _e1647[1][1]));
                                                                let _e1761 = select(_e1647[1][2], _e1647[0][2], (_e1647[0][2] < _e1647[1][2]));
                                                                let _e1765 = select(_e1647[1][2], _e1647[0][2], (_e1647[0][2] > _e1647[1][2]));
                                                                let _e1770 = ((select(_e1647[2][0], _e1745, (_e1745 < _e1647[2][0])) - _e372) * _e377);
                                                                let _e1771 = ((select(_e1647[2][0], _e1749, (_e1749 > _e1647[2][0])) - _e373) * _e377);
                                                                let _e1774 = ((select(_e1647[2][1], _e1753, (_e1753 < _e1647[2][1])) - _e440) * _e445);
                                                                let _e1775 = ((select(_e1647[2][1], _e1757, (_e1757 > _e1647[2][1])) - _e441) * _e445);
                                                                let _e1778 = ((select(_e1647[2][2], _e1761, (_e1761 < _e1647[2][2])) - _e508) * _e513);
                                                                let _e1779 = ((select(_e1647[2][2], _e1765, (_e1765 > _e1647[2][2])) - _e509) * _e513);
                                                                let _e1781 = select(_e1779, _e1778, (_e1778 < _e1779));
                                                                let _e1783 = select(_e1779, _e1778, (_e1778 > _e1779));
                                                                let _e1785 = select(_e1771, _e1770, (_e1770 < _e1771));
                                                                let _e1787 = select(_e1775, _e1774, (_e1774 < _e1775));
                                                                let _e1789 = select(_e1787, _e1785, (_e1785 > _e1787));
                                                                let _e1791 = select(_e1781, _e1789, (_e1789 > _e1781));
                                                                let _e1793 = select(_e1771, _e1770, (_e1770 > _e1771));
                                                                let _e1795 = select(_e1775, _e1774, (_e1774 > _e1775));
                                                                let _e1797 = select(_e1795, _e1793, (_e1793 < _e1795));
                                                                let _e1799 = select(_e1783, _e1797, (_e1797 < _e1783));
                                                                let _e1800 = -(_e1781);
                                                                let _e1806 = select(_e625, _e1791, (_e1791 > _e625));
                                                                if (_e1806 > (_e1799 + (select(_e1800, _e1783, (_e1783 > _e1800)) * 0.0000019073523f))) {
                                                                    phi_2893_ = type_20();
                                                                    phi_2894_ = true;
                                                                } else {
                                                                    let _e1808 = (_e1806 > _e1200);
                                                                    if _e1808 {
                                                                        phi_2892_ = type_20();
                                                                    } else {
                                                                        let _e1809 = vec3<f32>(_e1647[0][0], _e1647[0][1], _e1647[0][2]);
                                                                        let _e1810 = vec3<f32>(_e1647[1][0], _e1647[1][1], _e1647[1][2]);
                                                                        let _e1811 = vec3<f32>(_e1647[2][0], _e1647[2][1], _e1647[2][2]);
                                                                        let _e1812 = (_e1647[1][0] - _e1647[0][0]);
                                                                        let _e1813 = (_e1647[1][1] - _e1647[0][1]);
                                                                        let _e1814 = (_e1647[1][2] - _e1647[0][2]);
                                                                        let _e1815 = vec3<f32>(_e1812, _e1813, _e1814);
                                                                        let _e1816 = (_e1647[2][0] - _e1647[1][0]);
                                                                        let _e1817 = (_e1647[2][1] - _e1647[1][1]);
                                                                        let _e1818 = (_e1647[2][2] - _e1647[1][2]);
                                                                        let _e1819 = vec3<f32>(_e1816, _e1817, _e1818);
                                                                        let _e1820 = (_e1647[0][0] - _e1647[2][0]);
                                                                        let _e1821 = (_e1647[0][1] - _e1647[2][1]);
                                                                        let _e1822 = (_e1647[0][2] - _e1647[2][2]);
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
                                                                            phi_2625_ = _e1673;
                                                                            phi_2626_ = _e1670;
                                                                            phi_2627_ = _e1660;
                                                                            phi_2628_ = _e1657;
                                                                            phi_2629_ = _e1809;
                                                                            phi_2630_ = _e1823;
                                                                            phi_2631_ = _e1819;
                                                                            phi_2632_ = _e1815;
                                                                        } else {
                                                                            let _e1868 = (_e1849 == _e1866);
                                                                            let _e1873 = vec3(_e1868);
                                                                            phi_2625_ = select(_e1660, _e1686, _e1868);
                                                                            phi_2626_ = select(_e1657, _e1683, _e1868);
                                                                            phi_2627_ = select(_e1686, _e1673, _e1868);
                                                                            phi_2628_ = select(_e1683, _e1670, _e1868);
                                                                            phi_2629_ = select(_e1811, _e1810, _e1873);
                                                                            phi_2630_ = select(_e1819, _e1815, _e1873);
                                                                            phi_2631_ = select(_e1815, _e1823, _e1873);
                                                                            phi_2632_ = select(_e1823, _e1819, _e1873);
                                                                        }
                                                                        let _e1879 = phi_2625_;
                                                                        let _e1881 = phi_2626_;
                                                                        let _e1883 = phi_2627_;
                                                                        let _e1885 = phi_2628_;
                                                                        let _e1887 = phi_2629_;
                                                                        let _e1889 = phi_2630_;
                                                                        let _e1891 = phi_2631_;
                                                                        let _e1893 = phi_2632_;
                                                                        let _e1900 = ((_e1891.y * _e1889.z) - (_e1889.y * _e1891.z));
                                                                        let _e1905 = ((_e1891.z * _e1889.x) - (_e1889.z * _e1891.x));
                                                                        let _e1908 = ((_e1891.x * _e1889.y) - (_e1889.x * _e1891.y));
                                                                        if (_e1708 >= _e1712) {
                                                                            phi_2663_ = select(true, false, (_e1708 >= _e1716));
                                                                        } else {
                                                                            phi_2663_ = true;
                                                                        }
                                                                        let _e1913 = phi_2663_;
                                                                        if _e1913 {
                                                                            phi_2672_ = select(_e1811, _e1810, vec3((_e1712 >= _e1716)));
                                                                        } else {
                                                                            phi_2672_ = _e1809;
                                                                        }
                                                                        let _e1918 = phi_2672_;
                                                                        let _e1929 = (((_e1900 * (_e1918.x - _e334)) + (_e1905 * (_e1918.y - _e403))) + (_e1908 * (_e1918.z - _e471)));
                                                                        let _e1934 = (((_e1900 * _e374) + (_e1905 * _e442)) + (_e1908 * _e510));
                                                                        let _e1935 = (_e1881 - _e1885);
                                                                        let _e1936 = (_e1879 - _e1883);
                                                                        let _e1944 = (-(((_e1885 * _e1935) + (_e1883 * _e1936))) / ((_e1935 * _e1935) + (_e1936 * _e1936)));
                                                                        let _e1946 = select(1f, _e1944, (_e1944 < 1f));
                                                                        let _e1948 = select(0f, _e1946, (_e1946 > 0f));
                                                                        let _e1961 = ((_e1887.x + (_e1893.x * _e1948)) - _e334);
                                                                        let _e1962 = ((_e1887.y + (_e1893.y * _e1948)) - _e403);
                                                                        let _e1963 = ((_e1887.z + (_e1893.z * _e1948)) - _e471);
                                                                        let _e1964 = (_e1963 / _e510);
                                                                        let _e1976 = bitcast<f32>((bitcast<u32>(_e1961) & 2147483647u));
                                                                        let _e1979 = bitcast<f32>((bitcast<u32>(_e1962) & 2147483647u));
                                                                        let _e1981 = select(_e1979, _e1976, (_e1976 > _e1979));
                                                                        let _e1984 = bitcast<f32>((bitcast<u32>(_e1963) & 2147483647u));
                                                                        let _e1986 = select(_e1984, _e1981, (_e1981 > _e1984));
                                                                        let _e1992 = bitcast<f32>((bitcast<u32>(_e1900) & 2147483647u));
                                                                        let _e1995 = bitcast<f32>((bitcast<u32>(_e1905) & 2147483647u));
                                                                        let _e1997 = select(_e1995, _e1992, (_e1992 > _e1995));
                                                                        let _e2000 = bitcast<f32>((bitcast<u32>(_e1908) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1900 * _e1961) + (_e1905 * _e1962)) + (_e1908 * _e1963)) - _e1929)) & 2147483647u)) <= ((0.0000009536743f * select(_e1866, _e1986, (_e1986 > _e1866))) * select(_e2000, _e1997, (_e1997 > _e2000)))) {
                                                                            let _e2010 = bitcast<f32>((bitcast<u32>(_e1891.x) & 2147483647u));
                                                                            let _e2013 = bitcast<f32>((bitcast<u32>(_e1891.y) & 2147483647u));
                                                                            let _e2015 = select(_e2013, _e2010, (_e2010 > _e2013));
                                                                            let _e2018 = bitcast<f32>((bitcast<u32>(_e1891.z) & 2147483647u));
                                                                            let _e2024 = bitcast<f32>((bitcast<u32>(_e1889.x) & 2147483647u));
                                                                            let _e2027 = bitcast<f32>((bitcast<u32>(_e1889.y) & 2147483647u));
                                                                            let _e2029 = select(_e2027, _e2024, (_e2024 > _e2027));
                                                                            let _e2032 = bitcast<f32>((bitcast<u32>(_e1889.z) & 2147483647u));
                                                                            let _e2036 = (bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u)) > ((0.0000038146973f * select(_e2018, _e2015, (_e2015 > _e2018))) * select(_e2032, _e2029, (_e2029 > _e2032))));
                                                                            if _e2036 {
                                                                                phi_2837_ = (_e1929 / _e1934);
                                                                            } else {
                                                                                phi_2837_ = f32();
                                                                            }
                                                                            let _e2039 = phi_2837_;
                                                                            phi_2839_ = _e2039;
                                                                            phi_2840_ = select(true, false, _e2036);
                                                                        } else {
                                                                            phi_2839_ = f32();
                                                                            phi_2840_ = true;
                                                                        }
                                                                        let _e2042 = phi_2839_;
                                                                        let _e2044 = phi_2840_;
                                                                        if _e2044 {
                                                                            let _e2052 = (((_e1900 * (_e1961 - (_e374 * _e1964))) + (_e1905 * (_e1962 - (_e442 * _e1964)))) / _e1934);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2052) & 2147483647u)) <= _e1866) {
                                                                                phi_2860_ = (_e1964 + _e2052);
                                                                            } else {
                                                                                phi_2860_ = _e1964;
                                                                            }
                                                                            let _e2059 = phi_2860_;
                                                                            phi_2861_ = _e2059;
                                                                        } else {
                                                                            phi_2861_ = _e2042;
                                                                        }
                                                                        let _e2061 = phi_2861_;
                                                                        let _e2063 = select(_e1799, _e2061, (_e2061 < _e1799));
                                                                        let _e2065 = select(_e1791, _e2063, (_e2063 > _e1791));
                                                                        if (_e2065 >= _e625) {
                                                                            let _e2067 = (_e2065 <= _e1200);
                                                                            if _e2067 {
                                                                                let _e2068 = (1f / _e1718);
                                                                                phi_2884_ = type_20(_e2065, (_e1712 * _e2068), (_e1716 * _e2068), _e1260);
                                                                            } else {
                                                                                phi_2884_ = type_20();
                                                                            }
                                                                            let _e2073 = phi_2884_;
                                                                            phi_2886_ = _e2073;
                                                                            phi_2887_ = select(true, false, _e2067);
                                                                        } else {
                                                                            phi_2886_ = type_20();
                                                                            phi_2887_ = true;
                                                                        }
                                                                        let _e2076 = phi_2886_;
                                                                        let _e2078 = phi_2887_;
                                                                        if _e2078 {
                                                                            phi_2891_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2891_ = _e2076;
                                                                        }
                                                                        let _e2080 = phi_2891_;
                                                                        phi_2892_ = _e2080;
                                                                    }
                                                                    let _e2082 = phi_2892_;
                                                                    phi_2893_ = _e2082;
                                                                    phi_2894_ = _e1808;
                                                                }
                                                                let _e2084 = phi_2893_;
                                                                let _e2086 = phi_2894_;
                                                                phi_2898_ = _e2084;
                                                                phi_2899_ = _e2086;
                                                            }
                                                            let _e2088 = phi_2898_;
                                                            let _e2090 = phi_2899_;
                                                            phi_2900_ = _e2088;
                                                            phi_2901_ = _e1743;
                                                            phi_2902_ = _e2090;
                                                        }
                                                        let _e2092 = phi_2900_;
                                                        let _e2094 = phi_2901_;
                                                        let _e2096 = phi_2902_;
                                                        phi_2903_ = _e2092;
                                                        phi_2904_ = _e2094;
                                                        phi_2905_ = _e2096;
                                                    }
                                                    let _e2098 = phi_2903_;
                                                    let _e2100 = phi_2904_;
                                                    let _e2102 = phi_2905_;
                                                    phi_2913_ = _e2098;
                                                    phi_2914_ = select(_e2102, true, _e2100);
                                                } else {
                                                    phi_2913_ = type_20();
                                                    phi_2914_ = true;
                                                }
                                                let _e2105 = phi_2913_;
                                                let _e2107 = phi_2914_;
                                                if _e2107 {
                                                    phi_2918_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2918_ = _e2105;
                                                }
                                                let _e2109 = phi_2918_;
                                                if (_e2109.member_3 != 4294967295u) {
                                                    if (_e1260 != 4294967295u) {
                                                        phi_2930_ = type_8(0u, 8u);
                                                        phi_2933_ = _e2109;
                                                        loop {
                                                            let _e2114 = phi_2930_;
                                                            let _e2116 = phi_2933_;
                                                            if (_e2114.member < _e2114.member_1) {
                                                                phi_2931_ = type_8((_e2114.member + 1u), _e2114.member_1);
                                                                phi_2956_ = type_8(1u, _e2114.member);
                                                            } else {
                                                                phi_2931_ = _e2114;
                                                                phi_2956_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e2129 = phi_2931_;
                                                            let _e2131 = phi_2956_;
                                                            let _e2135 = (bitcast<i32>(_e2131.member) != 0i);
                                                            if _e2135 {
                                                                let _e2136 = (_e2131.member_1 < 8u);
                                                                if _e2136 {
                                                                } else {
                                                                    phi_4863_ = true;
                                                                    break;
                                                                }
                                                                let _e2141 = local_9[_e2131.member_1].member;
                                                                if (_e2116.member < _e2141) {
                                                                    phi_2989_ = true;
                                                                } else {
                                                                    let _e2143 = local_9[_e2131.member_1].member;
                                                                    if (_e2116.member == _e2143) {
                                                                        let _e2148 = local_9[_e2131.member_1].member_3;
                                                                        phi_2988_ = (_e2116.member_3 < _e2148);
                                                                    } else {
                                                                        phi_2988_ = false;
                                                                    }
                                                                    let _e2151 = phi_2988_;
                                                                    phi_2989_ = _e2151;
                                                                }
                                                                let _e2153 = phi_2989_;
                                                                if _e2153 {
                                                                    if _e2136 {
                                                                    } else {
                                                                        phi_4863_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2154 = local_9[_e2131.member_1];
                                                                    local_9[_e2131.member_1] = type_20(_e2116.member, _e2116.member_1, _e2116.member_2, _e2116.member_3);
                                                                    phi_3010_ = type_20(_e2154.member, _e2154.member_1, _e2154.member_2, _e2154.member_3);
                                                                } else {
                                                                    phi_3010_ = _e2116;
                                                                }
                                                                let _e2165 = phi_3010_;
                                                                phi_2934_ = _e2165;
                                                            } else {
                                                                phi_2934_ = type_20();
                                                            }
                                                            let _e2167 = phi_2934_;
                                                            continue;
                                                            continuing {
                                                                phi_2930_ = _e2129;
                                                                phi_2933_ = _e2167;
                                                                phi_4863_ = _e1198;
                                                                break if !(_e2135);
                                                            }
                                                        }
                                                        let _e2170 = phi_4863_;
                                                        phi_5228_ = _e1200;
                                                        phi_5070_ = _e2170;
                                                        if _e2170 {
                                                            break;
                                                        }
                                                        let _e2173 = local_9[7u].member_3;
                                                        if (_e2173 != 4294967295u) {
                                                            let _e2177 = local_9[7u].member;
                                                            phi_5319_ = _e2177;
                                                        } else {
                                                            phi_5319_ = _e1200;
                                                        }
                                                        let _e2179 = phi_5319_;
                                                        phi_5318_ = _e2179;
                                                        phi_5073_ = _e2170;
                                                    } else {
                                                        phi_5318_ = _e1200;
                                                        phi_5073_ = _e1198;
                                                    }
                                                    let _e2181 = phi_5318_;
                                                    let _e2183 = phi_5073_;
                                                    phi_5317_ = _e2181;
                                                    phi_5072_ = _e2183;
                                                } else {
                                                    phi_5317_ = _e1200;
                                                    phi_5072_ = _e1198;
                                                }
                                                let _e2185 = phi_5317_;
                                                let _e2187 = phi_5072_;
                                                phi_5316_ = _e2185;
                                                phi_5071_ = _e2187;
                                            } else {
                                                phi_5316_ = _e1200;
                                                phi_5071_ = _e1198;
                                            }
                                            let _e2189 = phi_5316_;
                                            let _e2191 = phi_5071_;
                                            continue;
                                            continuing {
                                                phi_4892_ = _e2191;
                                                phi_4835_ = _e2189;
                                                phi_1342_ = _e1215;
                                                phi_5228_ = _e2189;
                                                phi_5070_ = _e2191;
                                                break if !(_e1221);
                                            }
                                        }
                                        let _e2194 = phi_5228_;
                                        let _e2196 = phi_5070_;
                                        phi_5075_ = _e2196;
                                        if _e2196 {
                                            break;
                                        }
                                        phi_5193_ = _e2194;
                                        phi_5079_ = _e2196;
                                        phi_4262_ = _e706;
                                        phi_4263_ = false;
                                        phi_4264_ = _e710;
                                    } else {
                                        if (_e706.member_1 >= _e99) {
                                            phi_3817_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e706.member_1 < _e99) {
                                            } else {
                                                phi_5075_ = true;
                                                break;
                                            }
                                            let _e722 = (_e270 * 2u);
                                            let _e724 = ((1u + _e722) % 7u);
                                            if (_e724 < 7u) {
                                            } else {
                                                phi_5075_ = true;
                                                break;
                                            }
                                            let _e729 = global_4.member[_e706.member_1][_e724];
                                            let _e731 = ((_e722 + 2u) % 7u);
                                            if (_e731 < 7u) {
                                            } else {
                                                phi_5075_ = true;
                                                break;
                                            }
                                            let _e736 = global_4.member[_e706.member_1][_e731];
                                            let _e737 = (_e269 * 2u);
                                            let _e739 = ((1u + _e737) % 7u);
                                            if (_e739 < 7u) {
                                            } else {
                                                phi_5075_ = true;
                                                break;
                                            }
                                            let _e744 = global_4.member[_e706.member_1][_e739];
                                            let _e746 = ((_e737 + 2u) % 7u);
                                            if (_e746 < 7u) {
                                            } else {
                                                phi_5075_ = true;
                                                break;
                                            }
                                            let _e751 = global_4.member[_e706.member_1][_e746];
                                            let _e752 = (_e271 * 2u);
                                            let _e754 = ((1u + _e752) % 7u);
                                            if (_e754 < 7u) {
                                            } else {
                                                phi_5075_ = true;
                                                break;
                                            }
                                            let _e759 = global_4.member[_e706.member_1][_e754];
                                            let _e761 = ((_e752 + 2u) % 7u);
                                            if (_e761 < 7u) {
                                            } else {
                                                phi_5075_ = true;
                                                break;
                                            }
                                            let _e766 = global_4.member[_e706.member_1][_e761];
                                            let _e789 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.x - _e706.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e790 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.y - _e706.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e791 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.z - _e706.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e793 = select(_e150, _e789, (_e789 > _e150));
                                            let _e795 = select(_e150, _e790, (_e790 > _e150));
                                            let _e797 = select(_e150, _e791, (_e791 > _e150));
                                            let _e828 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e729 & 2097151u))) - 8388608f) * _e793));
                                            let _e833 = (bitcast<i32>((_e729 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e836 = bitcast<f32>((_e828 & bitcast<u32>(_e833)));
                                            let _e837 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e744 & 2097151u))) - 8388608f) * _e795));
                                            let _e842 = (bitcast<i32>((_e744 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e845 = bitcast<f32>((_e837 & bitcast<u32>(_e842)));
                                            let _e846 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e759 & 2097151u))) - 8388608f) * _e797));
                                            let _e851 = (bitcast<i32>((_e759 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e854 = bitcast<f32>((_e846 & bitcast<u32>(_e851)));
                                            let _e858 = bitcast<f32>((_e828 & bitcast<u32>(~(_e833))));
                                            let _e862 = bitcast<f32>((_e837 & bitcast<u32>(~(_e842))));
                                            let _e866 = bitcast<f32>((_e846 & bitcast<u32>(~(_e851))));
                                            let _e867 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e736 & 2097151u))) - 8388608f) * _e793));
                                            let _e872 = (bitcast<i32>((_e736 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e875 = bitcast<f32>((_e867 & bitcast<u32>(_e872)));
                                            let _e876 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e751 & 2097151u))) - 8388608f) * _e795));
                                            let _e881 = (bitcast<i32>((_e751 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e884 = bitcast<f32>((_e876 & bitcast<u32>(_e881)));
                                            let _e885 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e766 & 2097151u))) - 8388608f) * _e797));
                                            let _e890 = (bitcast<i32>((_e766 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e893 = bitcast<f32>((_e885 & bitcast<u32>(_e890)));
                                            let _e897 = bitcast<f32>((_e867 & bitcast<u32>(~(_e872))));
                                            let _e901 = bitcast<f32>((_e876 & bitcast<u32>(~(_e881))));
                                            let _e905 = bitcast<f32>((_e885 & bitcast<u32>(~(_e890))));
                                            let _e906 = (_e706.member.member.x + _e836);
                                            let _e907 = (_e706.member.member.y + _e845);
                                            let _e908 = (_e706.member.member.z + _e854);
                                            let _e911 = (_e706.member.member_1.x - _e875);
                                            let _e912 = (_e706.member.member_1.y - _e884);
                                            let _e913 = (_e706.member.member_1.z - _e893);
                                            let _e932 = (_e911 - _e906);
                                            let _e933 = (_e912 - _e907);
                                            let _e934 = (_e913 - _e908);
                                            let _e936 = select(_e933, _e932, (_e932 > _e933));
                                            let _e938 = select(_e934, _e936, (_e936 > _e934));
                                            if (_e938 < (1024f * _e150)) {
                                                phi_3518_ = 0u;
                                            } else {
                                                phi_3518_ = select(2u, 1u, (_e938 < (2097152f * _e150)));
                                            }
                                            let _e945 = phi_3518_;
                                            switch bitcast<i32>(_e945) {
                                                case 0: {
                                                    phi_3524_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3524_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3524_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3524_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e948 = phi_3524_;
                                            let _e954 = global_4.member[_e706.member_1][0u];
                                            let _e958 = global_4.member[_e706.member_1][2u];
                                            let _e962 = global_4.member[_e706.member_1][4u];
                                            let _e966 = global_4.member[_e706.member_1][6u];
                                            let _e978 = (((_e958 >> bitcast<u32>(22i)) | ((_e962 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e966 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e979 = (_e954 & 268435455u);
                                            let _e980 = (_e978 & 268435455u);
                                            let _e983 = ((_e954 >> bitcast<u32>(28u)) & 7u);
                                            let _e991 = ((_e954 >> bitcast<u32>(31i)) | (((_e978 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e992 = (_e983 != 0u);
                                            if (_e983 == 0u) {
                                                phi_3779_ = _e979;
                                            } else {
                                                if (_e983 == 7u) {
                                                    phi_3778_ = 2147483648u;
                                                } else {
                                                    phi_3778_ = ((2147483648u | (_e983 << bitcast<u32>(28u))) | (_e980 & 268435455u));
                                                }
                                                let _e1001 = phi_3778_;
                                                phi_3779_ = _e1001;
                                            }
                                            let _e1003 = phi_3779_;
                                            if _e992 {
                                                let _e1004 = (_e983 != 7u);
                                                if _e1004 {
                                                    phi_3789_ = (_e980 + (_e983 * ((3u * _e948) + 1u)));
                                                } else {
                                                    phi_3789_ = u32();
                                                }
                                                let _e1008 = phi_3789_;
                                                phi_3791_ = _e1008;
                                                phi_3792_ = select(true, false, _e1004);
                                            } else {
                                                phi_3791_ = u32();
                                                phi_3792_ = true;
                                            }
                                            let _e1011 = phi_3791_;
                                            let _e1013 = phi_3792_;
                                            if (_e991 == 0u) {
                                                phi_3813_ = (_e979 + select(0u, 1u, !(_e992)));
                                            } else {
                                                if (_e991 == 7u) {
                                                    phi_3812_ = 2147483648u;
                                                } else {
                                                    phi_3812_ = ((2147483648u | (_e991 << bitcast<u32>(28u))) | (select(_e1011, _e980, _e1013) & 268435455u));
                                                }
                                                let _e1026 = phi_3812_;
                                                phi_3813_ = _e1026;
                                            }
                                            let _e1028 = phi_3813_;
                                            phi_3817_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e906, (_e706.member.member.x + _e858), _e911, (_e706.member.member_1.x - _e897)), vec4<f32>(_e907, (_e706.member.member.y + _e862), _e912, (_e706.member.member_1.y - _e901)), vec4<f32>(_e908, (_e706.member.member.z + _e866), _e913, (_e706.member.member_1.z - _e905))), type_51(type_24((_e706.member.member + vec4<f32>(_e836, _e845, _e854, 0f)), (_e706.member.member_1 - vec4<f32>(_e875, _e884, _e893, 0f))), _e1003), type_51(type_24((_e706.member.member + vec4<f32>(_e858, _e862, _e866, 0f)), (_e706.member.member_1 - vec4<f32>(_e897, _e901, _e905, 0f))), _e1028));
                                        }
                                        let _e1033 = phi_3817_;
                                        let _e1044 = ((_e1033.member[0].x - _e372) * _e377);
                                        let _e1045 = ((_e1033.member[0].y - _e372) * _e377);
                                        let _e1046 = ((_e1033.member[0].z - _e373) * _e377);
                                        let _e1047 = ((_e1033.member[0].w - _e373) * _e377);
                                        let _e1057 = ((_e1033.member[1].x - _e440) * _e445);
                                        let _e1058 = ((_e1033.member[1].y - _e440) * _e445);
                                        let _e1059 = ((_e1033.member[1].z - _e441) * _e445);
                                        let _e1060 = ((_e1033.member[1].w - _e441) * _e445);
                                        let _e1070 = ((_e1033.member[2].x - _e508) * _e513);
                                        let _e1071 = ((_e1033.member[2].y - _e508) * _e513);
                                        let _e1072 = ((_e1033.member[2].z - _e509) * _e513);
                                        let _e1073 = ((_e1033.member[2].w - _e509) * _e513);
                                        let _e1075 = select(_e1072, _e1070, (_e1070 < _e1072));
                                        let _e1077 = select(_e1073, _e1071, (_e1071 < _e1073));
                                        let _e1079 = select(_e1072, _e1070, (_e1070 > _e1072));
                                        let _e1081 = select(_e1073, _e1071, (_e1071 > _e1073));
                                        let _e1083 = select(_e1046, _e1044, (_e1044 < _e1046));
                                        let _e1085 = select(_e1047, _e1045, (_e1045 < _e1047));
                                        let _e1087 = select(_e1059, _e1057, (_e1057 < _e1059));
                                        let _e1089 = select(_e1060, _e1058, (_e1058 < _e1060));
                                        let _e1091 = select(_e1087, _e1083, (_e1083 > _e1087));
                                        let _e1093 = select(_e1089, _e1085, (_e1085 > _e1089));
                                        let _e1095 = select(_e1075, _e1091, (_e1091 > _e1075));
                                        let _e1097 = select(_e1077, _e1093, (_e1093 > _e1077));
                                        let _e1099 = select(_e1046, _e1044, (_e1044 > _e1046));
                                        let _e1101 = select(_e1047, _e1045, (_e1045 > _e1047));
                                        let _e1103 = select(_e1059, _e1057, (_e1057 > _e1059));
                                        let _e1105 = select(_e1060, _e1058, (_e1058 > _e1060));
                                        let _e1107 = select(_e1103, _e1099, (_e1099 < _e1103));
                                        let _e1109 = select(_e1105, _e1101, (_e1101 < _e1105));
                                        let _e1114 = -(_e1075);
                                        let _e1115 = -(_e1077);
                                        let _e1122 = (select(_e1079, _e1107, (_e1107 < _e1079)) + (select(_e1114, _e1079, (_e1079 > _e1114)) * 0.0000019073523f));
                                        let _e1123 = (select(_e1081, _e1109, (_e1109 < _e1081)) + (select(_e1115, _e1081, (_e1081 > _e1115)) * 0.0000019073523f));
                                        let _e1125 = select(_e625, _e1095, (_e1095 > _e625));
                                        let _e1127 = select(_e625, _e1097, (_e1097 > _e625));
                                        let _e1132 = (_e1125 <= select(_e668, _e1122, (_e1122 < _e668)));
                                        let _e1133 = (_e1127 <= select(_e668, _e1123, (_e1123 < _e668)));
                                        let _e1134 = (_e1125 <= _e1127);
                                        if _e1132 {
                                            if _e1133 {
                                                if _e1134 {
                                                    phi_4162_ = _e1033.member_2;
                                                } else {
                                                    phi_4162_ = _e1033.member_1;
                                                }
                                                let _e1138 = phi_4162_;
                                                let _e1160 = (_e710 % 128u);
                                                let _e1161 = (_e1160 < 128u);
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_8[_e1160] = _e1138.member_1;
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_7[_e1160] = _e1138.member.member.x;
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_6[_e1160] = _e1138.member.member.y;
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_5[_e1160] = _e1138.member.member.z;
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_4[_e1160] = _e1138.member.member_1.x;
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_3[_e1160] = _e1138.member.member_1.y;
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_2[_e1160] = _e1138.member.member_1.z;
                                                if _e1161 {
                                                } else {
                                                    phi_5075_ = true;
                                                    break;
                                                }
                                                local_10[_e1160] = select(_e1127, _e1125, (_e1125 > _e1127));
                                                if _e1134 {
                                                    phi_4239_ = _e1033.member_1;
                                                } else {
                                                    phi_4239_ = _e1033.member_2;
                                                }
                                                let _e1174 = phi_4239_;
                                                phi_4240_ = _e1174;
                                                phi_4241_ = (_e710 + 1u);
                                            } else {
                                                phi_4240_ = type_51();
                                                phi_4241_ = u32();
                                            }
                                            let _e1176 = phi_4240_;
                                            let _e1178 = phi_4241_;
                                            phi_4243_ = _e1176;
                                            phi_4244_ = _e1178;
                                            phi_4245_ = select(true, false, _e1133);
                                        } else {
                                            phi_4243_ = type_51();
                                            phi_4244_ = u32();
                                            phi_4245_ = true;
                                        }
                                        let _e1181 = phi_4243_;
                                        let _e1183 = phi_4244_;
                                        let _e1185 = phi_4245_;
                                        if _e1185 {
                                            if _e1132 {
                                                phi_4254_ = _e1033.member_1;
                                            } else {
                                                phi_4254_ = _e1033.member_2;
                                            }
                                            let _e1189 = phi_4254_;
                                            phi_4259_ = _e1189;
                                            phi_4260_ = select(_e1133, true, _e1132);
                                        } else {
                                            phi_4259_ = _e1181;
                                            phi_4260_ = _e708;
                                        }
                                        let _e1192 = phi_4259_;
                                        let _e1194 = phi_4260_;
                                        phi_5193_ = _e668;
                                        phi_5079_ = _e666;
                                        phi_4262_ = _e1192;
                                        phi_4263_ = _e1194;
                                        phi_4264_ = select(_e1183, _e710, _e1185);
                                    }
                                    let _e2198 = phi_5193_;
                                    let _e2200 = phi_5079_;
                                    let _e2202 = phi_4262_;
                                    let _e2204 = phi_4263_;
                                    let _e2206 = phi_4264_;
                                    phi_5192_ = _e2198;
                                    phi_5078_ = _e2200;
                                    phi_4265_ = _e2202;
                                    phi_4266_ = (_e672 - 1u);
                                    phi_4267_ = _e2204;
                                    phi_4268_ = _e2206;
                                } else {
                                    phi_5192_ = _e668;
                                    phi_5078_ = _e666;
                                    phi_4265_ = _e706;
                                    phi_4266_ = _e672;
                                    phi_4267_ = _e708;
                                    phi_4268_ = _e710;
                                }
                                let _e2208 = phi_5192_;
                                let _e2210 = phi_5078_;
                                let _e2212 = phi_4265_;
                                let _e2214 = phi_4266_;
                                let _e2216 = phi_4267_;
                                let _e2218 = phi_4268_;
                                phi_5191_ = _e2208;
                                phi_5077_ = _e2210;
                                phi_4269_ = _e2212;
                                phi_4270_ = _e2214;
                                phi_4271_ = _e2216;
                                phi_4272_ = _e2218;
                            } else {
                                phi_5191_ = _e668;
                                phi_5077_ = _e666;
                                phi_4269_ = type_51();
                                phi_4270_ = u32();
                                phi_4271_ = bool();
                                phi_4272_ = u32();
                            }
                            let _e2220 = phi_5191_;
                            let _e2222 = phi_5077_;
                            let _e2224 = phi_4269_;
                            let _e2226 = phi_4270_;
                            let _e2228 = phi_4271_;
                            let _e2230 = phi_4272_;
                            phi_5190_ = _e2220;
                            phi_5076_ = _e2222;
                            phi_1217_ = _e2224;
                            phi_1220_ = _e2226;
                            phi_1222_ = _e2228;
                            phi_1224_ = _e2230;
                            phi_4273_ = _e680;
                        } else {
                            phi_5190_ = _e668;
                            phi_5076_ = _e666;
                            phi_1217_ = type_51();
                            phi_1220_ = u32();
                            phi_1222_ = bool();
                            phi_1224_ = u32();
                            phi_4273_ = false;
                        }
                        let _e2232 = phi_5190_;
                        let _e2234 = phi_5076_;
                        let _e2236 = phi_1217_;
                        let _e2238 = phi_1220_;
                        let _e2240 = phi_1222_;
                        let _e2242 = phi_1224_;
                        let _e2244 = phi_4273_;
                        continue;
                        continuing {
                            phi_4895_ = _e2234;
                            phi_4751_ = _e2232;
                            phi_1216_ = _e2236;
                            phi_1219_ = _e2238;
                            phi_1221_ = _e2240;
                            phi_1223_ = _e2242;
                            phi_5075_ = _e2234;
                            break if !(_e2244);
                        }
                    }
                    let _e2247 = phi_5075_;
                    if _e2247 {
                        break;
                    }
                    phi_4280_ = type_8(0u, 8u);
                    loop {
                        let _e2249 = phi_4280_;
                        if (_e2249.member < _e2249.member_1) {
                            phi_4281_ = type_8((_e2249.member + 1u), _e2249.member_1);
                            phi_4304_ = type_8(1u, _e2249.member);
                        } else {
                            phi_4281_ = _e2249;
                            phi_4304_ = type_8(0u, type_8().member_1);
                        }
                        let _e2262 = phi_4281_;
                        let _e2264 = phi_4304_;
                        let _e2268 = (bitcast<i32>(_e2264.member) != 0i);
                        if _e2268 {
                            let _e2269 = (_e2264.member_1 < 8u);
                            if _e2269 {
                            } else {
                                phi_5172_ = true;
                                break;
                            }
                            let _e2271 = local_9[_e2264.member_1];
                            if (_e2271.member_3 != 4294967295u) {
                                let _e2277 = -(_e527);
                                let _e2278 = bitcast<u32>(_e2271.member);
                                let _e2282 = (bitcast<i32>((_e2278 >> bitcast<u32>(23i))) & 255i);
                                let _e2283 = (_e2282 + _e2277);
                                if (_e2282 == 255i) {
                                    phi_4377_ = _e2271.member;
                                } else {
                                    if (_e2282 > 0i) {
                                        if (_e2283 > 0i) {
                                            let _e2287 = (_e2283 < 255i);
                                            if _e2287 {
                                                phi_4356_ = bitcast<f32>((_e2278 + bitcast<u32>((_e2277 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4356_ = f32();
                                            }
                                            let _e2294 = phi_4356_;
                                            phi_4358_ = _e2294;
                                            phi_4359_ = select(true, false, _e2287);
                                        } else {
                                            phi_4358_ = f32();
                                            phi_4359_ = true;
                                        }
                                        let _e2297 = phi_4358_;
                                        let _e2299 = phi_4359_;
                                        phi_4360_ = _e2297;
                                        phi_4361_ = _e2299;
                                    } else {
                                        phi_4360_ = f32();
                                        phi_4361_ = true;
                                    }
                                    let _e2301 = phi_4360_;
                                    let _e2303 = phi_4361_;
                                    if _e2303 {
                                        let _e2304 = (_e2278 & 2147483648u);
                                        let _e2311 = ((_e2278 & 8388607u) | (select(0u, 1u, ((_e2278 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2315 = (_e2311 == 0u);
                                        if _e2315 {
                                            phi_4698_ = bitcast<f32>(_e2304);
                                        } else {
                                            let _e2320 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2311)), 32u, _e2315) - 8u);
                                            let _e2323 = (_e2311 << bitcast<u32>((_e2320 & 31u)));
                                            let _e2325 = ((_e2283 + select(0i, 1i, (_e2282 == 0i))) - bitcast<i32>(_e2320));
                                            if (_e2325 >= 255i) {
                                                phi_4688_ = bitcast<f32>((_e2304 | 2139095040u));
                                                phi_4689_ = f32();
                                                phi_4690_ = true;
                                            } else {
                                                let _e2327 = (_e2325 > 0i);
                                                if _e2327 {
                                                    phi_4682_ = bitcast<f32>(((_e2304 | (bitcast<u32>(_e2325) << bitcast<u32>(23i))) | (_e2323 & 8388607u)));
                                                    phi_4683_ = f32();
                                                } else {
                                                    if (_e2325 < -24i) {
                                                        phi_4648_ = 26u;
                                                    } else {
                                                        phi_4648_ = bitcast<u32>((1i - _e2325));
                                                    }
                                                    let _e2332 = phi_4648_;
                                                    let _e2333 = (_e2332 & 31u);
                                                    let _e2335 = (_e2323 >> bitcast<u32>(_e2333));
                                                    let _e2339 = (_e2323 & ((1u << bitcast<u32>(_e2333)) - 1u));
                                                    let _e2343 = (1u << bitcast<u32>(((_e2332 - 1u) & 31u)));
                                                    if (_e2339 > _e2343) {
                                                        phi_4669_ = true;
                                                    } else {
                                                        if (_e2339 == _e2343) {
                                                            phi_4666_ = ((_e2335 & 1u) == 1u);
                                                        } else {
                                                            phi_4666_ = false;
                                                        }
                                                        let _e2349 = phi_4666_;
                                                        phi_4669_ = _e2349;
                                                    }
                                                    let _e2351 = phi_4669_;
                                                    phi_4682_ = f32();
                                                    phi_4683_ = bitcast<f32>((_e2304 | (_e2335 + select(0u, 1u, _e2351))));
                                                }
                                                let _e2364 = phi_4682_;
                                                let _e2366 = phi_4683_;
                                                phi_4688_ = _e2364;
                                                phi_4689_ = _e2366;
                                                phi_4690_ = _e2327;
                                            }
                                            let _e2370 = phi_4688_;
                                            let _e2372 = phi_4689_;
                                            let _e2374 = phi_4690_;
                                            phi_4698_ = select(_e2372, _e2370, _e2374);
                                        }
                                        let _e2378 = phi_4698_;
                                        phi_4376_ = _e2378;
                                    } else {
                                        phi_4376_ = _e2301;
                                    }
                                    let _e2380 = phi_4376_;
                                    phi_4377_ = _e2380;
                                }
                                let _e2382 = phi_4377_;
                                let _e2383 = bitcast<u32>(_e2382);
                                if ((_e2383 & 2147483647u) >= 2139095040u) {
                                    phi_4389_ = bitcast<f32>(((_e2383 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4389_ = _e2382;
                                }
                                let _e2390 = phi_4389_;
                                phi_4394_ = type_20(_e2390, _e2271.member_1, _e2271.member_2, _e2271.member_3);
                            } else {
                                phi_4394_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2393 = phi_4394_;
                            if _e2269 {
                            } else {
                                phi_5172_ = true;
                                break;
                            }
                            local_9[_e2264.member_1] = type_20(_e2393.member, _e2393.member_1, _e2393.member_2, _e2393.member_3);
                        }
                        continue;
                        continuing {
                            phi_4280_ = _e2262;
                            phi_5172_ = _e2247;
                            break if !(_e2268);
                        }
                    }
                    let _e2401 = phi_5172_;
                    if _e2401 {
                        break;
                    }
                    let _e2402 = local_9;
                    if _e158 {
                    } else {
                        break;
                    }
                    global_6.member[_e156] = array<type_20, 8>(type_20(_e2402[0].member, _e2402[0].member_1, _e2402[0].member_2, _e2402[0].member_3), type_20(_e2402[1].member, _e2402[1].member_1, _e2402[1].member_2, _e2402[1].member_3), type_20(_e2402[2].member, _e2402[2].member_1, _e2402[2].member_2, _e2402[2].member_3), type_20(_e2402[3].member, _e2402[3].member_1, _e2402[3].member_2, _e2402[3].member_3), type_20(_e2402[4].member, _e2402[4].member_1, _e2402[4].member_2, _e2402[4].member_3), type_20(_e2402[5].member, _e2402[5].member_1, _e2402[5].member_2, _e2402[5].member_3), type_20(_e2402[6].member, _e2402[6].member_1, _e2402[6].member_2, _e2402[6].member_3), type_20(_e2402[7].member, _e2402[7].member_1, _e2402[7].member_2, _e2402[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
