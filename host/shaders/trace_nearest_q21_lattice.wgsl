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
    var phi_492_: i32;
    var phi_493_: i32;
    var phi_503_: bool;
    var phi_513_: u32;
    var phi_514_: u32;
    var phi_516_: bool;
    var phi_521_: u32;
    var phi_534_: i32;
    var phi_554_: i32;
    var phi_572_: f32;
    var phi_578_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_676_: f32;
    var phi_688_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_801_: f32;
    var phi_813_: f32;
    var phi_822_: f32;
    var phi_828_: f32;
    var phi_868_: f32;
    var phi_874_: f32;
    var phi_926_: f32;
    var phi_938_: f32;
    var phi_993_: i32;
    var phi_1015_: u32;
    var phi_1016_: u32;
    var phi_1053_: i32;
    var phi_1075_: u32;
    var phi_1076_: u32;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_5032_: bool;
    var phi_4889_: f32;
    var phi_1236_: bool;
    var phi_1239_: u32;
    var phi_1241_: u32;
    var phi_1243_: type_51;
    var phi_1254_: bool;
    var phi_1341_: bool;
    var phi_1342_: u32;
    var phi_1343_: type_51;
    var phi_3634_: u32;
    var phi_3640_: u32;
    var phi_3894_: u32;
    var phi_3895_: u32;
    var phi_3905_: u32;
    var phi_3907_: u32;
    var phi_3908_: bool;
    var phi_3928_: u32;
    var phi_3929_: u32;
    var phi_3933_: type_52;
    var phi_4296_: type_51;
    var phi_4373_: type_51;
    var phi_4374_: u32;
    var phi_4375_: type_51;
    var phi_4377_: u32;
    var phi_4378_: type_51;
    var phi_4379_: bool;
    var phi_4388_: type_51;
    var phi_4393_: bool;
    var phi_4395_: type_51;
    var phi_5029_: bool;
    var phi_4972_: f32;
    var phi_1362_: type_8;
    var phi_1363_: type_8;
    var phi_1386_: type_8;
    var phi_1427_: u32;
    var phi_1433_: u32;
    var phi_1443_: u32;
    var phi_1459_: u32;
    var phi_1492_: u32;
    var phi_1498_: u32;
    var phi_1964_: u32;
    var phi_1982_: u32;
    var phi_2000_: u32;
    var phi_2023_: u32;
    var phi_2041_: u32;
    var phi_2059_: u32;
    var phi_2082_: u32;
    var phi_2100_: u32;
    var phi_2118_: u32;
    var phi_1672_: u32;
    var phi_1687_: u32;
    var phi_1697_: u32;
    var phi_1718_: u32;
    var phi_1739_: u32;
    var phi_1769_: u32;
    var phi_1784_: u32;
    var phi_1794_: u32;
    var phi_1815_: u32;
    var phi_1836_: u32;
    var phi_1866_: u32;
    var phi_1881_: u32;
    var phi_1891_: u32;
    var phi_1912_: u32;
    var phi_1933_: u32;
    var phi_1525_: u32;
    var phi_1574_: u32;
    var phi_1623_: u32;
    var phi_2124_: array<array<f32, 3>, 3>;
    var phi_2277_: bool;
    var phi_2306_: bool;
    var phi_2725_: f32;
    var phi_2726_: f32;
    var phi_2727_: f32;
    var phi_2728_: f32;
    var phi_2729_: vec3<f32>;
    var phi_2730_: vec3<f32>;
    var phi_2731_: vec3<f32>;
    var phi_2732_: vec3<f32>;
    var phi_2769_: bool;
    var phi_2778_: vec3<f32>;
    var phi_2943_: f32;
    var phi_2945_: f32;
    var phi_2946_: bool;
    var phi_2966_: f32;
    var phi_2967_: f32;
    var phi_2990_: type_20;
    var phi_2992_: type_20;
    var phi_2993_: bool;
    var phi_2997_: type_20;
    var phi_2998_: type_20;
    var phi_2999_: type_20;
    var phi_3000_: bool;
    var phi_3004_: type_20;
    var phi_3005_: bool;
    var phi_3006_: type_20;
    var phi_3007_: bool;
    var phi_3008_: bool;
    var phi_3009_: type_20;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3019_: type_20;
    var phi_3020_: bool;
    var phi_3024_: type_20;
    var phi_3036_: type_8;
    var phi_3039_: type_20;
    var phi_3037_: type_8;
    var phi_3062_: type_8;
    var phi_3094_: bool;
    var phi_3095_: bool;
    var phi_3116_: type_20;
    var phi_3040_: type_20;
    var phi_5000_: bool;
    var phi_5456_: f32;
    var phi_5455_: f32;
    var phi_5210_: bool;
    var phi_5454_: f32;
    var phi_5209_: bool;
    var phi_5453_: f32;
    var phi_5208_: bool;
    var phi_5365_: f32;
    var phi_5207_: bool;
    var phi_5330_: f32;
    var phi_5216_: bool;
    var phi_4399_: bool;
    var phi_4400_: u32;
    var phi_4401_: type_51;
    var phi_5329_: f32;
    var phi_5215_: bool;
    var phi_4402_: bool;
    var phi_4403_: u32;
    var phi_4404_: u32;
    var phi_4405_: type_51;
    var phi_5328_: f32;
    var phi_5214_: bool;
    var phi_4406_: bool;
    var phi_4407_: u32;
    var phi_4408_: u32;
    var phi_4409_: type_51;
    var phi_5327_: f32;
    var phi_5213_: bool;
    var phi_1237_: bool;
    var phi_1240_: u32;
    var phi_1242_: u32;
    var phi_1244_: type_51;
    var phi_4410_: bool;
    var phi_5212_: bool;
    var phi_4417_: type_8;
    var phi_4418_: type_8;
    var phi_4441_: type_8;
    var phi_4493_: f32;
    var phi_4495_: f32;
    var phi_4496_: bool;
    var phi_4497_: f32;
    var phi_4498_: bool;
    var phi_4785_: u32;
    var phi_4803_: bool;
    var phi_4806_: bool;
    var phi_4819_: f32;
    var phi_4820_: f32;
    var phi_4825_: f32;
    var phi_4826_: f32;
    var phi_4827_: bool;
    var phi_4835_: f32;
    var phi_4513_: f32;
    var phi_4514_: f32;
    var phi_4526_: f32;
    var phi_4531_: type_20;
    var phi_5309_: bool;

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
                            phi_492_ = (bitcast<i32>((_e235 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_492_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e235)), 32u, (_e235 == 0u))));
                        }
                        let _e249 = phi_492_;
                        phi_493_ = _e249;
                    } else {
                        phi_493_ = 0i;
                    }
                    let _e251 = phi_493_;
                    let _e252 = (_e168 == _e207);
                    if _e252 {
                        phi_503_ = true;
                    } else {
                        phi_503_ = (_e175 == _e207);
                    }
                    let _e255 = phi_503_;
                    let _e256 = select(1u, 0u, _e252);
                    if _e255 {
                        let _e257 = (_e256 + 1u);
                        phi_513_ = _e257;
                        phi_514_ = _e257;
                        phi_516_ = select(true, false, (_e257 == 2u));
                    } else {
                        phi_513_ = u32();
                        phi_514_ = 0u;
                        phi_516_ = true;
                    }
                    let _e261 = phi_513_;
                    let _e263 = phi_514_;
                    let _e265 = phi_516_;
                    if _e265 {
                        phi_521_ = (_e263 + 1u);
                    } else {
                        phi_521_ = 0u;
                    }
                    let _e269 = phi_521_;
                    let _e270 = select(_e261, _e263, _e265);
                    let _e271 = select(_e256, select(2u, _e256, _e255), _e265);
                    if (_e138 < -126i) {
                        phi_534_ = -126i;
                    } else {
                        phi_534_ = select(_e138, 127i, (_e138 > 127i));
                    }
                    let _e276 = phi_534_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e138 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = -(_e251);
                    if (_e288 < -126i) {
                        phi_554_ = -126i;
                    } else {
                        phi_554_ = select(_e288, 127i, (_e288 > 127i));
                    }
                    let _e293 = phi_554_;
                    let _e298 = bitcast<f32>((bitcast<u32>((_e293 + 127i)) << bitcast<u32>(23i)));
                    let _e304 = bitcast<f32>((bitcast<u32>(((_e288 - _e293) + 127i)) << bitcast<u32>(23i)));
                    let _e308 = global_3.member[_e156].member;
                    let _e309 = (_e270 == 0u);
                    if _e309 {
                        phi_572_ = _e308[0];
                    } else {
                        phi_572_ = _e308[1];
                    }
                    let _e313 = phi_572_;
                    let _e314 = (_e270 == 2u);
                    if _e314 {
                        phi_578_ = _e308[2];
                    } else {
                        phi_578_ = _e313;
                    }
                    let _e317 = phi_578_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e281) * select(0.00000011920929f, 1f, _e320)) * _e287);
                    let _e335 = global_3.member[_e156].member_2;
                    if _e309 {
                        phi_618_ = _e335[0];
                    } else {
                        phi_618_ = _e335[1];
                    }
                    let _e339 = phi_618_;
                    if _e314 {
                        phi_624_ = _e335[2];
                    } else {
                        phi_624_ = _e339;
                    }
                    let _e342 = phi_624_;
                    let _e343 = bitcast<u32>(_e342);
                    let _e345 = ((_e343 & 2139095040u) != 0u);
                    let _e359 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e343 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e343 & 2147483648u))), _e342, _e345) * _e298) * select(0.00000011920929f, 1f, _e345)) * _e304);
                    let _e363 = (bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e363 {
                        let _e367 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) * 0.00000011920929f);
                        phi_676_ = select(0.00000000000011368684f, _e367, (_e367 > 0.00000000000011368684f));
                    } else {
                        phi_676_ = 0f;
                    }
                    let _e371 = phi_676_;
                    let _e372 = (_e334 + _e371);
                    let _e373 = (_e334 - _e371);
                    let _e374 = select(_e359, 0f, _e363);
                    if _e363 {
                        phi_688_ = 38685626000000000000000000f;
                    } else {
                        phi_688_ = (1f / _e359);
                    }
                    let _e377 = phi_688_;
                    let _e378 = (_e269 == 0u);
                    if _e378 {
                        phi_697_ = _e308[0];
                    } else {
                        phi_697_ = _e308[1];
                    }
                    let _e382 = phi_697_;
                    let _e383 = (_e269 == 2u);
                    if _e383 {
                        phi_703_ = _e308[2];
                    } else {
                        phi_703_ = _e382;
                    }
                    let _e386 = phi_703_;
                    let _e387 = bitcast<u32>(_e386);
                    let _e389 = ((_e387 & 2139095040u) != 0u);
                    let _e403 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * _e281) * select(0.00000011920929f, 1f, _e389)) * _e287);
                    if _e378 {
                        phi_743_ = _e335[0];
                    } else {
                        phi_743_ = _e335[1];
                    }
                    let _e407 = phi_743_;
                    if _e383 {
                        phi_749_ = _e335[2];
                    } else {
                        phi_749_ = _e407;
                    }
                    let _e410 = phi_749_;
                    let _e411 = bitcast<u32>(_e410);
                    let _e413 = ((_e411 & 2139095040u) != 0u);
                    let _e427 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e411 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e411 & 2147483648u))), _e410, _e413) * _e298) * select(0.00000011920929f, 1f, _e413)) * _e304);
                    let _e431 = (bitcast<f32>((bitcast<u32>(_e427) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e431 {
                        let _e435 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) * 0.00000011920929f);
                        phi_801_ = select(0.00000000000011368684f, _e435, (_e435 > 0.00000000000011368684f));
                    } else {
                        phi_801_ = 0f;
                    }
                    let _e439 = phi_801_;
                    let _e440 = (_e403 + _e439);
                    let _e441 = (_e403 - _e439);
                    let _e442 = select(_e427, 0f, _e431);
                    if _e431 {
                        phi_813_ = 38685626000000000000000000f;
                    } else {
                        phi_813_ = (1f / _e427);
                    }
                    let _e445 = phi_813_;
                    let _e446 = (_e271 == 0u);
                    if _e446 {
                        phi_822_ = _e308[0];
                    } else {
                        phi_822_ = _e308[1];
                    }
                    let _e450 = phi_822_;
                    let _e451 = (_e271 == 2u);
                    if _e451 {
                        phi_828_ = _e308[2];
                    } else {
                        phi_828_ = _e450;
                    }
                    let _e454 = phi_828_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e281) * select(0.00000011920929f, 1f, _e457)) * _e287);
                    if _e446 {
                        phi_868_ = _e335[0];
                    } else {
                        phi_868_ = _e335[1];
                    }
                    let _e475 = phi_868_;
                    if _e451 {
                        phi_874_ = _e335[2];
                    } else {
                        phi_874_ = _e475;
                    }
                    let _e478 = phi_874_;
                    let _e479 = bitcast<u32>(_e478);
                    let _e481 = ((_e479 & 2139095040u) != 0u);
                    let _e495 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e479 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e479 & 2147483648u))), _e478, _e481) * _e298) * select(0.00000011920929f, 1f, _e481)) * _e304);
                    let _e499 = (bitcast<f32>((bitcast<u32>(_e495) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e499 {
                        let _e503 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                        phi_926_ = select(0.00000000000011368684f, _e503, (_e503 > 0.00000000000011368684f));
                    } else {
                        phi_926_ = 0f;
                    }
                    let _e507 = phi_926_;
                    let _e508 = (_e471 + _e507);
                    let _e509 = (_e471 - _e507);
                    let _e510 = select(_e495, 0f, _e499);
                    if _e499 {
                        phi_938_ = 38685626000000000000000000f;
                    } else {
                        phi_938_ = (1f / _e495);
                    }
                    let _e513 = phi_938_;
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
                            phi_993_ = 255i;
                        } else {
                            phi_993_ = (((_e540 + select(0i, 1i, (_e540 == 0i))) - _e547) + _e527);
                        }
                        let _e555 = phi_993_;
                        let _e565 = (_e555 <= 0i);
                        if _e565 {
                            phi_1016_ = u32();
                        } else {
                            if _e544 {
                                phi_1015_ = u32();
                            } else {
                                phi_1015_ = select(((bitcast<u32>(_e555) << bitcast<u32>(23i)) | ((_e537 << bitcast<u32>(((_e547 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e555 >= 255i));
                            }
                            let _e569 = phi_1015_;
                            phi_1016_ = _e569;
                        }
                        let _e571 = phi_1016_;
                        let _e583 = ((_e228 & 8388607u) | (select(0u, 1u, ((_e228 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e586 = bitcast<i32>((_e228 >> bitcast<u32>(23i)));
                        let _e590 = (_e583 == 0u);
                        let _e593 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e583)), 32u, _e590)) - 8i);
                        if (_e586 == 255i) {
                            phi_1053_ = 255i;
                        } else {
                            phi_1053_ = (((_e586 + select(0i, 1i, (_e586 == 0i))) - _e593) + _e527);
                        }
                        let _e601 = phi_1053_;
                        let _e611 = (_e601 <= 0i);
                        if _e611 {
                            phi_1076_ = u32();
                        } else {
                            if _e590 {
                                phi_1075_ = u32();
                            } else {
                                phi_1075_ = select(((bitcast<u32>(_e601) << bitcast<u32>(23i)) | ((_e583 << bitcast<u32>(((_e593 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e601 >= 255i));
                            }
                            let _e615 = phi_1075_;
                            phi_1076_ = _e615;
                        }
                        let _e617 = phi_1076_;
                        phi_1084_ = bitcast<f32>(((_e227 & 2147483648u) | select(_e617, 0u, select(_e590, true, _e611))));
                        phi_1085_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e571, 0u, select(_e544, true, _e565))));
                    } else {
                        phi_1084_ = 0f;
                        phi_1085_ = 1f;
                    }
                    let _e623 = phi_1084_;
                    let _e625 = phi_1085_;
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
                    phi_5032_ = false;
                    phi_4889_ = _e623;
                    phi_1236_ = (_e625 <= _e623);
                    phi_1239_ = ((3u * _e99) + 1u);
                    phi_1241_ = 0u;
                    phi_1243_ = type_51(type_24(vec4<f32>((f32(_e631) * _e150), (f32(_e637) * _e150), (f32(_e643) * _e150), 0f), vec4<f32>((f32(_e648) * _e150), (f32(_e652) * _e150), (f32(_e656) * _e150), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    loop {
                        let _e666 = phi_5032_;
                        let _e668 = phi_4889_;
                        let _e670 = phi_1236_;
                        let _e672 = phi_1239_;
                        let _e674 = phi_1241_;
                        let _e676 = phi_1243_;
                        if _e670 {
                            phi_1254_ = true;
                        } else {
                            phi_1254_ = (_e674 > 0u);
                        }
                        let _e679 = phi_1254_;
                        if _e679 {
                            let _e680 = (_e672 > 0u);
                            if _e680 {
                                if _e670 {
                                    phi_1341_ = _e670;
                                    phi_1342_ = _e674;
                                    phi_1343_ = _e676;
                                } else {
                                    let _e681 = (_e674 - 1u);
                                    let _e682 = (_e681 % 128u);
                                    let _e683 = (_e682 < 128u);
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e685 = local_7[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e687 = local_6[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e689 = local_5[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e691 = local_4[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e693 = local_3[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e695 = local_2[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e700 = local_8[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e703 = local_10[_e682];
                                    phi_1341_ = (_e703 <= _e668);
                                    phi_1342_ = _e681;
                                    phi_1343_ = type_51(type_24(vec4<f32>(_e685, _e687, _e689, 0f), vec4<f32>(_e691, _e693, _e695, 0f)), _e700);
                                }
                                let _e706 = phi_1341_;
                                let _e708 = phi_1342_;
                                let _e710 = phi_1343_;
                                if _e706 {
                                    let _e715 = (_e710.member_1 & 268435455u);
                                    if ((_e710.member_1 & 2147483648u) != 0u) {
                                        phi_5029_ = _e666;
                                        phi_4972_ = _e668;
                                        phi_1362_ = type_8(0u, ((_e710.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1198 = phi_5029_;
                                            let _e1200 = phi_4972_;
                                            let _e1202 = phi_1362_;
                                            if (_e1202.member < _e1202.member_1) {
                                                phi_1363_ = type_8((_e1202.member + 1u), _e1202.member_1);
                                                phi_1386_ = type_8(1u, _e1202.member);
                                            } else {
                                                phi_1363_ = _e1202;
                                                phi_1386_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1215 = phi_1363_;
                                            let _e1217 = phi_1386_;
                                            let _e1221 = (bitcast<i32>(_e1217.member) != 0i);
                                            if _e1221 {
                                                let _e1226 = (_e710.member.member_1.x - _e710.member.member.x);
                                                let _e1229 = (_e710.member.member_1.y - _e710.member.member.y);
                                                let _e1232 = (_e710.member.member_1.z - _e710.member.member.z);
                                                let _e1234 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                let _e1236 = select(_e1232, _e1234, (_e1234 > _e1232));
                                                let _e1238 = (_e1236 < (1024f * _e150));
                                                if _e1238 {
                                                    phi_1427_ = 0u;
                                                } else {
                                                    phi_1427_ = select(2u, 1u, (_e1236 < (2097152f * _e150)));
                                                }
                                                let _e1243 = phi_1427_;
                                                switch bitcast<i32>(_e1243) {
                                                    case 0: {
                                                        phi_1433_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1433_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1433_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1433_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1246 = phi_1433_;
                                                switch bitcast<i32>(_e1243) {
                                                    case 0: {
                                                        phi_1443_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1443_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1443_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1443_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1253 = phi_1443_;
                                                let _e1255 = ((_e715 + (_e1217.member_1 * ((3u * _e1246) + 1u))) + (3u * _e1253));
                                                let _e1256 = (_e1255 < _e102);
                                                if _e1256 {
                                                    if _e1256 {
                                                    } else {
                                                        phi_5365_ = _e1200;
                                                        phi_5207_ = true;
                                                        break;
                                                    }
                                                    let _e1258 = global_5.member[_e1255];
                                                    phi_1459_ = _e1258;
                                                } else {
                                                    phi_1459_ = 4294967295u;
                                                }
                                                let _e1260 = phi_1459_;
                                                if _e1238 {
                                                    phi_1492_ = 0u;
                                                } else {
                                                    phi_1492_ = select(2u, 1u, (_e1236 < (2097152f * _e150)));
                                                }
                                                let _e1265 = phi_1492_;
                                                switch bitcast<i32>(_e1265) {
                                                    case 0: {
                                                        phi_1498_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1498_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1498_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1498_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1268 = phi_1498_;
                                                let _e1272 = (_e715 + (_e1217.member_1 * ((3u * _e1268) + 1u)));
                                                switch bitcast<i32>(_e1265) {
                                                    case 0: {
                                                        let _e1547 = (_e1272 < _e102);
                                                        if _e1547 {
                                                            if _e1547 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1549 = global_5.member[_e1272];
                                                            phi_1525_ = _e1549;
                                                        } else {
                                                            phi_1525_ = 0u;
                                                        }
                                                        let _e1551 = phi_1525_;
                                                        let _e1553 = ((10u * _e270) & 31u);
                                                        let _e1563 = ((10u * _e269) & 31u);
                                                        let _e1573 = ((10u * _e271) & 31u);
                                                        let _e1583 = (_e1272 + 1u);
                                                        let _e1584 = (_e1583 < _e102);
                                                        if _e1584 {
                                                            if _e1584 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1586 = global_5.member[_e1583];
                                                            phi_1574_ = _e1586;
                                                        } else {
                                                            phi_1574_ = 0u;
                                                        }
                                                        let _e1588 = phi_1574_;
                                                        let _e1614 = (_e1272 + 2u);
                                                        let _e1615 = (_e1614 < _e102);
                                                        if _e1615 {
                                                            if _e1615 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1617 = global_5.member[_e1614];
                                                            phi_1623_ = _e1617;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e1619 = phi_1623_;
                                                        phi_2124_ = array<array<f32, 3>, 3>(array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | ((_e1551 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | ((_e1551 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | ((_e1551 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | ((_e1588 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | ((_e1588 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | ((_e1588 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | ((_e1619 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | ((_e1619 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | ((_e1619 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1361 = (_e1272 < _e102);
                                                        if _e1361 {
                                                            if _e1361 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1363 = global_5.member[_e1272];
                                                            phi_1672_ = _e1363;
                                                        } else {
                                                            phi_1672_ = 0u;
                                                        }
                                                        let _e1365 = phi_1672_;
                                                        let _e1366 = (_e1272 + 1u);
                                                        let _e1367 = (_e1366 < _e102);
                                                        if _e1367 {
                                                            if _e1367 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1369 = global_5.member[_e1366];
                                                            phi_1687_ = _e1369;
                                                        } else {
                                                            phi_1687_ = 0u;
                                                        }
                                                        let _e1371 = phi_1687_;
                                                        let _e1372 = (_e270 == 1u);
                                                        if _e1372 {
                                                            phi_1697_ = ((_e1365 >> bitcast<u32>(21i)) | (_e1371 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1697_ = (_e1371 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1381 = phi_1697_;
                                                        let _e1389 = (_e269 == 1u);
                                                        if _e1389 {
                                                            phi_1718_ = ((_e1365 >> bitcast<u32>(21i)) | (_e1371 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1718_ = (_e1371 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1398 = phi_1718_;
                                                        let _e1406 = (_e271 == 1u);
                                                        if _e1406 {
                                                            phi_1739_ = ((_e1365 >> bitcast<u32>(21i)) | (_e1371 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1739_ = (_e1371 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1415 = phi_1739_;
                                                        let _e1424 = (_e1272 + 2u);
                                                        let _e1425 = (_e1424 < _e102);
                                                        if _e1425 {
                                                            if _e1425 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1427 = global_5.member[_e1424];
                                                            phi_1769_ = _e1427;
                                                        } else {
                                                            phi_1769_ = 0u;
                                                        }
                                                        let _e1429 = phi_1769_;
                                                        let _e1430 = (_e1272 + 3u);
                                                        let _e1431 = (_e1430 < _e102);
                                                        if _e1431 {
                                                            if _e1431 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1433 = global_5.member[_e1430];
                                                            phi_1784_ = _e1433;
                                                        } else {
                                                            phi_1784_ = 0u;
                                                        }
                                                        let _e1435 = phi_1784_;
                                                        if _e1372 {
                                                            phi_1794_ = ((_e1429 >> bitcast<u32>(21i)) | (_e1435 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1794_ = (_e1435 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1444 = phi_1794_;
                                                        if _e1389 {
                                                            phi_1815_ = ((_e1429 >> bitcast<u32>(21i)) | (_e1435 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1815_ = (_e1435 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1460 = phi_1815_;
                                                        if _e1406 {
                                                            phi_1836_ = ((_e1429 >> bitcast<u32>(21i)) | (_e1435 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1836_ = (_e1435 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1476 = phi_1836_;
                                                        let _e1485 = (_e1272 + 4u);
                                                        let _e1486 = (_e1485 < _e102);
                                                        if _e1486 {
                                                            if _e1486 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1488 = global_5.member[_e1485];
                                                            phi_1866_ = _e1488;
                                                        } else {
                                                            phi_1866_ = 0u;
                                                        }
                                                        let _e1490 = phi_1866_;
                                                        let _e1491 = (_e1272 + 5u);
                                                        let _e1492 = (_e1491 < _e102);
                                                        if _e1492 {
                                                            if _e1492 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1494 = global_5.member[_e1491];
                                                            phi_1881_ = _e1494;
                                                        } else {
                                                            phi_1881_ = 0u;
                                                        }
                                                        let _e1496 = phi_1881_;
                                                        if _e1372 {
                                                            phi_1891_ = ((_e1490 >> bitcast<u32>(21i)) | (_e1496 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1891_ = (_e1496 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1505 = phi_1891_;
                                                        if _e1389 {
                                                            phi_1912_ = ((_e1490 >> bitcast<u32>(21i)) | (_e1496 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1912_ = (_e1496 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1521 = phi_1912_;
                                                        if _e1406 {
                                                            phi_1933_ = ((_e1490 >> bitcast<u32>(21i)) | (_e1496 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1933_ = (_e1496 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1537 = phi_1933_;
                                                        phi_2124_ = array<array<f32, 3>, 3>(array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1381, _e1365, _e309) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1398, _e1365, _e378) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1415, _e1365, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1444, _e1429, _e309) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1460, _e1429, _e378) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1476, _e1429, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1505, _e1490, _e309) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1521, _e1490, _e378) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1537, _e1490, _e446) & 2097151u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1274 = (_e1272 + _e270);
                                                        let _e1275 = (_e1274 < _e102);
                                                        if _e1275 {
                                                            if _e1275 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1277 = global_5.member[_e1274];
                                                            phi_1964_ = _e1277;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e1279 = phi_1964_;
                                                        let _e1283 = (_e1272 + _e269);
                                                        let _e1284 = (_e1283 < _e102);
                                                        if _e1284 {
                                                            if _e1284 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1286 = global_5.member[_e1283];
                                                            phi_1982_ = _e1286;
                                                        } else {
                                                            phi_1982_ = 0u;
                                                        }
                                                        let _e1288 = phi_1982_;
                                                        let _e1292 = (_e1272 + _e271);
                                                        let _e1293 = (_e1292 < _e102);
                                                        if _e1293 {
                                                            if _e1293 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1295 = global_5.member[_e1292];
                                                            phi_2000_ = _e1295;
                                                        } else {
                                                            phi_2000_ = 0u;
                                                        }
                                                        let _e1297 = phi_2000_;
                                                        let _e1302 = (_e1272 + 3u);
                                                        let _e1303 = (_e1302 + _e270);
                                                        let _e1304 = (_e1303 < _e102);
                                                        if _e1304 {
                                                            if _e1304 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1306 = global_5.member[_e1303];
                                                            phi_2023_ = _e1306;
                                                        } else {
                                                            phi_2023_ = 0u;
                                                        }
                                                        let _e1308 = phi_2023_;
                                                        let _e1312 = (_e1302 + _e269);
                                                        let _e1313 = (_e1312 < _e102);
                                                        if _e1313 {
                                                            if _e1313 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1315 = global_5.member[_e1312];
                                                            phi_2041_ = _e1315;
                                                        } else {
                                                            phi_2041_ = 0u;
                                                        }
                                                        let _e1317 = phi_2041_;
                                                        let _e1321 = (_e1302 + _e271);
                                                        let _e1322 = (_e1321 < _e102);
                                                        if _e1322 {
                                                            if _e1322 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1324 = global_5.member[_e1321];
                                                            phi_2059_ = _e1324;
                                                        } else {
                                                            phi_2059_ = 0u;
                                                        }
                                                        let _e1326 = phi_2059_;
                                                        let _e1331 = (_e1272 + 6u);
                                                        let _e1332 = (_e1331 + _e270);
                                                        let _e1333 = (_e1332 < _e102);
                                                        if _e1333 {
                                                            if _e1333 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1335 = global_5.member[_e1332];
                                                            phi_2082_ = _e1335;
                                                        } else {
                                                            phi_2082_ = 0u;
                                                        }
                                                        let _e1337 = phi_2082_;
                                                        let _e1341 = (_e1331 + _e269);
                                                        let _e1342 = (_e1341 < _e102);
                                                        if _e1342 {
                                                            if _e1342 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1344 = global_5.member[_e1341];
                                                            phi_2100_ = _e1344;
                                                        } else {
                                                            phi_2100_ = 0u;
                                                        }
                                                        let _e1346 = phi_2100_;
                                                        let _e1350 = (_e1331 + _e271);
                                                        let _e1351 = (_e1350 < _e102);
                                                        if _e1351 {
                                                            if _e1351 {
                                                            } else {
                                                                phi_5365_ = _e1200;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1353 = global_5.member[_e1350];
                                                            phi_2118_ = _e1353;
                                                        } else {
                                                            phi_2118_ = 0u;
                                                        }
                                                        let _e1355 = phi_2118_;
                                                        phi_2124_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1279)) * _e150), (f32(bitcast<i32>(_e1288)) * _e150), (f32(bitcast<i32>(_e1297)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1308)) * _e150), (f32(bitcast<i32>(_e1317)) * _e150), (f32(bitcast<i32>(_e1326)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1337)) * _e150), (f32(bitcast<i32>(_e1346)) * _e150), (f32(bitcast<i32>(_e1355)) * _e150)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2124_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1647 = phi_2124_;
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
                                                        phi_3009_ = type_20();
                                                        phi_3010_ = true;
                                                        phi_3011_ = false;
                                                    } else {
                                                        let _e1721 = select(_e1670, _e1657, (_e1657 < _e1670));
                                                        if (select(_e1683, _e1721, (_e1721 < _e1683)) > 0f) {
                                                            phi_2277_ = true;
                                                        } else {
                                                            let _e1726 = select(_e1670, _e1657, (_e1657 > _e1670));
                                                            phi_2277_ = (select(_e1683, _e1726, (_e1726 > _e1683)) < 0f);
                                                        }
                                                        let _e1731 = phi_2277_;
                                                        if _e1731 {
                                                            phi_3006_ = type_20();
                                                            phi_3007_ = true;
                                                            phi_3008_ = false;
                                                        } else {
                                                            let _e1733 = select(_e1673, _e1660, (_e1660 < _e1673));
                                                            if (select(_e1686, _e1733, (_e1733 < _e1686)) > 0f) {
                                                                phi_2306_ = true;
                                                            } else {
                                                                let _e1738 = select(_e1673, _e1660, (_e1660 > _e1673));
                                                                phi_2306_ = (select(_e1686, _e1738, (_e1738 > _e1686)) < 0f);
                                                            }
                                                            let _e1743 = phi_2306_;
                                                            if _e1743 {
                                                                phi_3004_ = type_20();
                                                                phi_3005_ = false;
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
                                                                    phi_2999_ = type_20();
                                                                    phi_3000_ = true;
                                                                } else {
                                                                    let _e1808 = (_e1806 > _e1200);
                                                                    if _e1808 {
                                                                        phi_2998_ = type_20();
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
                                                                            phi_2725_ = _e1673;
                                                                            phi_2726_ = _e1670;
                                                                            phi_2727_ = _e1660;
                                                                            phi_2728_ = _e1657;
                                                                            phi_2729_ = _e1809;
                                                                            phi_2730_ = _e1823;
                                                                            phi_2731_ = _e1819;
                                                                            phi_2732_ = _e1815;
                                                                        } else {
                                                                            let _e1868 = (_e1849 == _e1866);
                                                                            let _e1873 = vec3(_e1868);
                                                                            phi_2725_ = select(_e1660, _e1686, _e1868);
                                                                            phi_2726_ = select(_e1657, _e1683, _e1868);
                                                                            phi_2727_ = select(_e1686, _e1673, _e1868);
                                                                            phi_2728_ = select(_e1683, _e1670, _e1868);
                                                                            phi_2729_ = select(_e1811, _e1810, _e1873);
                                                                            phi_2730_ = select(_e1819, _e1815, _e1873);
                                                                            phi_2731_ = select(_e1815, _e1823, _e1873);
                                                                            phi_2732_ = select(_e1823, _e1819, _e1873);
                                                                        }
                                                                        let _e1879 = phi_2725_;
                                                                        let _e1881 = phi_2726_;
                                                                        let _e1883 = phi_2727_;
                                                                        let _e1885 = phi_2728_;
                                                                        let _e1887 = phi_2729_;
                                                                        let _e1889 = phi_2730_;
                                                                        let _e1891 = phi_2731_;
                                                                        let _e1893 = phi_2732_;
                                                                        let _e1900 = ((_e1891.y * _e1889.z) - (_e1889.y * _e1891.z));
                                                                        let _e1905 = ((_e1891.z * _e1889.x) - (_e1889.z * _e1891.x));
                                                                        let _e1908 = ((_e1891.x * _e1889.y) - (_e1889.x * _e1891.y));
                                                                        if (_e1708 >= _e1712) {
                                                                            phi_2769_ = select(true, false, (_e1708 >= _e1716));
                                                                        } else {
                                                                            phi_2769_ = true;
                                                                        }
                                                                        let _e1913 = phi_2769_;
                                                                        if _e1913 {
                                                                            phi_2778_ = select(_e1811, _e1810, vec3((_e1712 >= _e1716)));
                                                                        } else {
                                                                            phi_2778_ = _e1809;
                                                                        }
                                                                        let _e1918 = phi_2778_;
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
                                                                                phi_2943_ = (_e1929 / _e1934);
                                                                            } else {
                                                                                phi_2943_ = f32();
                                                                            }
                                                                            let _e2039 = phi_2943_;
                                                                            phi_2945_ = _e2039;
                                                                            phi_2946_ = select(true, false, _e2036);
                                                                        } else {
                                                                            phi_2945_ = f32();
                                                                            phi_2946_ = true;
                                                                        }
                                                                        let _e2042 = phi_2945_;
                                                                        let _e2044 = phi_2946_;
                                                                        if _e2044 {
                                                                            let _e2052 = (((_e1900 * (_e1961 - (_e374 * _e1964))) + (_e1905 * (_e1962 - (_e442 * _e1964)))) / _e1934);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2052) & 2147483647u)) <= _e1866) {
                                                                                phi_2966_ = (_e1964 + _e2052);
                                                                            } else {
                                                                                phi_2966_ = _e1964;
                                                                            }
                                                                            let _e2059 = phi_2966_;
                                                                            phi_2967_ = _e2059;
                                                                        } else {
                                                                            phi_2967_ = _e2042;
                                                                        }
                                                                        let _e2061 = phi_2967_;
                                                                        let _e2063 = select(_e1799, _e2061, (_e2061 < _e1799));
                                                                        let _e2065 = select(_e1791, _e2063, (_e2063 > _e1791));
                                                                        if (_e2065 >= _e625) {
                                                                            let _e2067 = (_e2065 <= _e1200);
                                                                            if _e2067 {
                                                                                let _e2068 = (1f / _e1718);
                                                                                phi_2990_ = type_20(_e2065, (_e1712 * _e2068), (_e1716 * _e2068), _e1260);
                                                                            } else {
                                                                                phi_2990_ = type_20();
                                                                            }
                                                                            let _e2073 = phi_2990_;
                                                                            phi_2992_ = _e2073;
                                                                            phi_2993_ = select(true, false, _e2067);
                                                                        } else {
                                                                            phi_2992_ = type_20();
                                                                            phi_2993_ = true;
                                                                        }
                                                                        let _e2076 = phi_2992_;
                                                                        let _e2078 = phi_2993_;
                                                                        if _e2078 {
                                                                            phi_2997_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2997_ = _e2076;
                                                                        }
                                                                        let _e2080 = phi_2997_;
                                                                        phi_2998_ = _e2080;
                                                                    }
                                                                    let _e2082 = phi_2998_;
                                                                    phi_2999_ = _e2082;
                                                                    phi_3000_ = _e1808;
                                                                }
                                                                let _e2084 = phi_2999_;
                                                                let _e2086 = phi_3000_;
                                                                phi_3004_ = _e2084;
                                                                phi_3005_ = _e2086;
                                                            }
                                                            let _e2088 = phi_3004_;
                                                            let _e2090 = phi_3005_;
                                                            phi_3006_ = _e2088;
                                                            phi_3007_ = _e1743;
                                                            phi_3008_ = _e2090;
                                                        }
                                                        let _e2092 = phi_3006_;
                                                        let _e2094 = phi_3007_;
                                                        let _e2096 = phi_3008_;
                                                        phi_3009_ = _e2092;
                                                        phi_3010_ = _e2094;
                                                        phi_3011_ = _e2096;
                                                    }
                                                    let _e2098 = phi_3009_;
                                                    let _e2100 = phi_3010_;
                                                    let _e2102 = phi_3011_;
                                                    phi_3019_ = _e2098;
                                                    phi_3020_ = select(_e2102, true, _e2100);
                                                } else {
                                                    phi_3019_ = type_20();
                                                    phi_3020_ = true;
                                                }
                                                let _e2105 = phi_3019_;
                                                let _e2107 = phi_3020_;
                                                if _e2107 {
                                                    phi_3024_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3024_ = _e2105;
                                                }
                                                let _e2109 = phi_3024_;
                                                if (_e2109.member_3 != 4294967295u) {
                                                    if (_e1260 != 4294967295u) {
                                                        phi_3036_ = type_8(0u, 8u);
                                                        phi_3039_ = _e2109;
                                                        loop {
                                                            let _e2114 = phi_3036_;
                                                            let _e2116 = phi_3039_;
                                                            if (_e2114.member < _e2114.member_1) {
                                                                phi_3037_ = type_8((_e2114.member + 1u), _e2114.member_1);
                                                                phi_3062_ = type_8(1u, _e2114.member);
                                                            } else {
                                                                phi_3037_ = _e2114;
                                                                phi_3062_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e2129 = phi_3037_;
                                                            let _e2131 = phi_3062_;
                                                            let _e2135 = (bitcast<i32>(_e2131.member) != 0i);
                                                            if _e2135 {
                                                                let _e2136 = (_e2131.member_1 < 8u);
                                                                if _e2136 {
                                                                } else {
                                                                    phi_5000_ = true;
                                                                    break;
                                                                }
                                                                let _e2141 = local_9[_e2131.member_1].member;
                                                                if (_e2116.member < _e2141) {
                                                                    phi_3095_ = true;
                                                                } else {
                                                                    let _e2143 = local_9[_e2131.member_1].member;
                                                                    if (_e2116.member == _e2143) {
                                                                        let _e2148 = local_9[_e2131.member_1].member_3;
                                                                        phi_3094_ = (_e2116.member_3 < _e2148);
                                                                    } else {
                                                                        phi_3094_ = false;
                                                                    }
                                                                    let _e2151 = phi_3094_;
                                                                    phi_3095_ = _e2151;
                                                                }
                                                                let _e2153 = phi_3095_;
                                                                if _e2153 {
                                                                    if _e2136 {
                                                                    } else {
                                                                        phi_5000_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2154 = local_9[_e2131.member_1];
                                                                    local_9[_e2131.member_1] = type_20(_e2116.member, _e2116.member_1, _e2116.member_2, _e2116.member_3);
                                                                    phi_3116_ = type_20(_e2154.member, _e2154.member_1, _e2154.member_2, _e2154.member_3);
                                                                } else {
                                                                    phi_3116_ = _e2116;
                                                                }
                                                                let _e2165 = phi_3116_;
                                                                phi_3040_ = _e2165;
                                                            } else {
                                                                phi_3040_ = type_20();
                                                            }
                                                            let _e2167 = phi_3040_;
                                                            continue;
                                                            continuing {
                                                                phi_3036_ = _e2129;
                                                                phi_3039_ = _e2167;
                                                                phi_5000_ = _e1198;
                                                                break if !(_e2135);
                                                            }
                                                        }
                                                        let _e2170 = phi_5000_;
                                                        phi_5365_ = _e1200;
                                                        phi_5207_ = _e2170;
                                                        if _e2170 {
                                                            break;
                                                        }
                                                        let _e2173 = local_9[7u].member_3;
                                                        if (_e2173 != 4294967295u) {
                                                            let _e2177 = local_9[7u].member;
                                                            phi_5456_ = _e2177;
                                                        } else {
                                                            phi_5456_ = _e1200;
                                                        }
                                                        let _e2179 = phi_5456_;
                                                        phi_5455_ = _e2179;
                                                        phi_5210_ = _e2170;
                                                    } else {
                                                        phi_5455_ = _e1200;
                                                        phi_5210_ = _e1198;
                                                    }
                                                    let _e2181 = phi_5455_;
                                                    let _e2183 = phi_5210_;
                                                    phi_5454_ = _e2181;
                                                    phi_5209_ = _e2183;
                                                } else {
                                                    phi_5454_ = _e1200;
                                                    phi_5209_ = _e1198;
                                                }
                                                let _e2185 = phi_5454_;
                                                let _e2187 = phi_5209_;
                                                phi_5453_ = _e2185;
                                                phi_5208_ = _e2187;
                                            } else {
                                                phi_5453_ = _e1200;
                                                phi_5208_ = _e1198;
                                            }
                                            let _e2189 = phi_5453_;
                                            let _e2191 = phi_5208_;
                                            continue;
                                            continuing {
                                                phi_5029_ = _e2191;
                                                phi_4972_ = _e2189;
                                                phi_1362_ = _e1215;
                                                phi_5365_ = _e2189;
                                                phi_5207_ = _e2191;
                                                break if !(_e1221);
                                            }
                                        }
                                        let _e2194 = phi_5365_;
                                        let _e2196 = phi_5207_;
                                        phi_5212_ = _e2196;
                                        if _e2196 {
                                            break;
                                        }
                                        phi_5330_ = _e2194;
                                        phi_5216_ = _e2196;
                                        phi_4399_ = false;
                                        phi_4400_ = _e708;
                                        phi_4401_ = _e710;
                                    } else {
                                        if (_e710.member_1 >= _e99) {
                                            phi_3933_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e710.member_1 < _e99) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e722 = (_e270 * 2u);
                                            let _e724 = ((1u + _e722) % 7u);
                                            if (_e724 < 7u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e729 = global_4.member[_e710.member_1][_e724];
                                            let _e731 = ((_e722 + 2u) % 7u);
                                            if (_e731 < 7u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e736 = global_4.member[_e710.member_1][_e731];
                                            let _e737 = (_e269 * 2u);
                                            let _e739 = ((1u + _e737) % 7u);
                                            if (_e739 < 7u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e744 = global_4.member[_e710.member_1][_e739];
                                            let _e746 = ((_e737 + 2u) % 7u);
                                            if (_e746 < 7u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e751 = global_4.member[_e710.member_1][_e746];
                                            let _e752 = (_e271 * 2u);
                                            let _e754 = ((1u + _e752) % 7u);
                                            if (_e754 < 7u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e759 = global_4.member[_e710.member_1][_e754];
                                            let _e761 = ((_e752 + 2u) % 7u);
                                            if (_e761 < 7u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e766 = global_4.member[_e710.member_1][_e761];
                                            let _e789 = (bitcast<f32>((bitcast<u32>((_e710.member.member_1.x - _e710.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e790 = (bitcast<f32>((bitcast<u32>((_e710.member.member_1.y - _e710.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e791 = (bitcast<f32>((bitcast<u32>((_e710.member.member_1.z - _e710.member.member.z)) & 2139095040u)) * 0.0000009536743f);
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
                                            let _e906 = (_e710.member.member.x + _e836);
                                            let _e907 = (_e710.member.member.y + _e845);
                                            let _e908 = (_e710.member.member.z + _e854);
                                            let _e911 = (_e710.member.member_1.x - _e875);
                                            let _e912 = (_e710.member.member_1.y - _e884);
                                            let _e913 = (_e710.member.member_1.z - _e893);
                                            let _e932 = (_e911 - _e906);
                                            let _e933 = (_e912 - _e907);
                                            let _e934 = (_e913 - _e908);
                                            let _e936 = select(_e933, _e932, (_e932 > _e933));
                                            let _e938 = select(_e934, _e936, (_e936 > _e934));
                                            if (_e938 < (1024f * _e150)) {
                                                phi_3634_ = 0u;
                                            } else {
                                                phi_3634_ = select(2u, 1u, (_e938 < (2097152f * _e150)));
                                            }
                                            let _e945 = phi_3634_;
                                            switch bitcast<i32>(_e945) {
                                                case 0: {
                                                    phi_3640_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3640_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3640_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3640_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e948 = phi_3640_;
                                            let _e954 = global_4.member[_e710.member_1][0u];
                                            let _e958 = global_4.member[_e710.member_1][2u];
                                            let _e962 = global_4.member[_e710.member_1][4u];
                                            let _e966 = global_4.member[_e710.member_1][6u];
                                            let _e978 = (((_e958 >> bitcast<u32>(22i)) | ((_e962 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e966 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e979 = (_e954 & 268435455u);
                                            let _e980 = (_e978 & 268435455u);
                                            let _e983 = ((_e954 >> bitcast<u32>(28u)) & 7u);
                                            let _e991 = ((_e954 >> bitcast<u32>(31i)) | (((_e978 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e992 = (_e983 != 0u);
                                            if (_e983 == 0u) {
                                                phi_3895_ = _e979;
                                            } else {
                                                if (_e983 == 7u) {
                                                    phi_3894_ = 2147483648u;
                                                } else {
                                                    phi_3894_ = ((2147483648u | (_e983 << bitcast<u32>(28u))) | (_e980 & 268435455u));
                                                }
                                                let _e1001 = phi_3894_;
                                                phi_3895_ = _e1001;
                                            }
                                            let _e1003 = phi_3895_;
                                            if _e992 {
                                                let _e1004 = (_e983 != 7u);
                                                if _e1004 {
                                                    phi_3905_ = (_e980 + (_e983 * ((3u * _e948) + 1u)));
                                                } else {
                                                    phi_3905_ = u32();
                                                }
                                                let _e1008 = phi_3905_;
                                                phi_3907_ = _e1008;
                                                phi_3908_ = select(true, false, _e1004);
                                            } else {
                                                phi_3907_ = u32();
                                                phi_3908_ = true;
                                            }
                                            let _e1011 = phi_3907_;
                                            let _e1013 = phi_3908_;
                                            if (_e991 == 0u) {
                                                phi_3929_ = (_e979 + select(0u, 1u, !(_e992)));
                                            } else {
                                                if (_e991 == 7u) {
                                                    phi_3928_ = 2147483648u;
                                                } else {
                                                    phi_3928_ = ((2147483648u | (_e991 << bitcast<u32>(28u))) | (select(_e1011, _e980, _e1013) & 268435455u));
                                                }
                                                let _e1026 = phi_3928_;
                                                phi_3929_ = _e1026;
                                            }
                                            let _e1028 = phi_3929_;
                                            phi_3933_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e906, (_e710.member.member.x + _e858), _e911, (_e710.member.member_1.x - _e897)), vec4<f32>(_e907, (_e710.member.member.y + _e862), _e912, (_e710.member.member_1.y - _e901)), vec4<f32>(_e908, (_e710.member.member.z + _e866), _e913, (_e710.member.member_1.z - _e905))), type_51(type_24((_e710.member.member + vec4<f32>(_e836, _e845, _e854, 0f)), (_e710.member.member_1 - vec4<f32>(_e875, _e884, _e893, 0f))), _e1003), type_51(type_24((_e710.member.member + vec4<f32>(_e858, _e862, _e866, 0f)), (_e710.member.member_1 - vec4<f32>(_e897, _e901, _e905, 0f))), _e1028));
                                        }
                                        let _e1033 = phi_3933_;
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
                                                    phi_4296_ = _e1033.member_2;
                                                } else {
                                                    phi_4296_ = _e1033.member_1;
                                                }
                                                let _e1138 = phi_4296_;
                                                let _e1160 = (_e708 % 128u);
                                                let _e1161 = (_e1160 < 128u);
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_8[_e1160] = _e1138.member_1;
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_7[_e1160] = _e1138.member.member.x;
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_6[_e1160] = _e1138.member.member.y;
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_5[_e1160] = _e1138.member.member.z;
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_4[_e1160] = _e1138.member.member_1.x;
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_3[_e1160] = _e1138.member.member_1.y;
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_2[_e1160] = _e1138.member.member_1.z;
                                                if _e1161 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_10[_e1160] = select(_e1127, _e1125, !(_e1134));
                                                if _e1134 {
                                                    phi_4373_ = _e1033.member_1;
                                                } else {
                                                    phi_4373_ = _e1033.member_2;
                                                }
                                                let _e1174 = phi_4373_;
                                                phi_4374_ = (_e708 + 1u);
                                                phi_4375_ = _e1174;
                                            } else {
                                                phi_4374_ = u32();
                                                phi_4375_ = type_51();
                                            }
                                            let _e1176 = phi_4374_;
                                            let _e1178 = phi_4375_;
                                            phi_4377_ = _e1176;
                                            phi_4378_ = _e1178;
                                            phi_4379_ = select(true, false, _e1133);
                                        } else {
                                            phi_4377_ = u32();
                                            phi_4378_ = type_51();
                                            phi_4379_ = true;
                                        }
                                        let _e1181 = phi_4377_;
                                        let _e1183 = phi_4378_;
                                        let _e1185 = phi_4379_;
                                        if _e1185 {
                                            if _e1132 {
                                                phi_4388_ = _e1033.member_1;
                                            } else {
                                                phi_4388_ = _e1033.member_2;
                                            }
                                            let _e1189 = phi_4388_;
                                            phi_4393_ = select(_e1133, true, _e1132);
                                            phi_4395_ = _e1189;
                                        } else {
                                            phi_4393_ = _e706;
                                            phi_4395_ = _e1183;
                                        }
                                        let _e1192 = phi_4393_;
                                        let _e1194 = phi_4395_;
                                        phi_5330_ = _e668;
                                        phi_5216_ = _e666;
                                        phi_4399_ = _e1192;
                                        phi_4400_ = select(_e1181, _e708, _e1185);
                                        phi_4401_ = _e1194;
                                    }
                                    let _e2198 = phi_5330_;
                                    let _e2200 = phi_5216_;
                                    let _e2202 = phi_4399_;
                                    let _e2204 = phi_4400_;
                                    let _e2206 = phi_4401_;
                                    phi_5329_ = _e2198;
                                    phi_5215_ = _e2200;
                                    phi_4402_ = _e2202;
                                    phi_4403_ = (_e672 - 1u);
                                    phi_4404_ = _e2204;
                                    phi_4405_ = _e2206;
                                } else {
                                    phi_5329_ = _e668;
                                    phi_5215_ = _e666;
                                    phi_4402_ = _e706;
                                    phi_4403_ = _e672;
                                    phi_4404_ = _e708;
                                    phi_4405_ = _e710;
                                }
                                let _e2208 = phi_5329_;
                                let _e2210 = phi_5215_;
                                let _e2212 = phi_4402_;
                                let _e2214 = phi_4403_;
                                let _e2216 = phi_4404_;
                                let _e2218 = phi_4405_;
                                phi_5328_ = _e2208;
                                phi_5214_ = _e2210;
                                phi_4406_ = _e2212;
                                phi_4407_ = _e2214;
                                phi_4408_ = _e2216;
                                phi_4409_ = _e2218;
                            } else {
                                phi_5328_ = _e668;
                                phi_5214_ = _e666;
                                phi_4406_ = bool();
                                phi_4407_ = u32();
                                phi_4408_ = u32();
                                phi_4409_ = type_51();
                            }
                            let _e2220 = phi_5328_;
                            let _e2222 = phi_5214_;
                            let _e2224 = phi_4406_;
                            let _e2226 = phi_4407_;
                            let _e2228 = phi_4408_;
                            let _e2230 = phi_4409_;
                            phi_5327_ = _e2220;
                            phi_5213_ = _e2222;
                            phi_1237_ = _e2224;
                            phi_1240_ = _e2226;
                            phi_1242_ = _e2228;
                            phi_1244_ = _e2230;
                            phi_4410_ = _e680;
                        } else {
                            phi_5327_ = _e668;
                            phi_5213_ = _e666;
                            phi_1237_ = bool();
                            phi_1240_ = u32();
                            phi_1242_ = u32();
                            phi_1244_ = type_51();
                            phi_4410_ = false;
                        }
                        let _e2232 = phi_5327_;
                        let _e2234 = phi_5213_;
                        let _e2236 = phi_1237_;
                        let _e2238 = phi_1240_;
                        let _e2240 = phi_1242_;
                        let _e2242 = phi_1244_;
                        let _e2244 = phi_4410_;
                        continue;
                        continuing {
                            phi_5032_ = _e2234;
                            phi_4889_ = _e2232;
                            phi_1236_ = _e2236;
                            phi_1239_ = _e2238;
                            phi_1241_ = _e2240;
                            phi_1243_ = _e2242;
                            phi_5212_ = _e2234;
                            break if !(_e2244);
                        }
                    }
                    let _e2247 = phi_5212_;
                    if _e2247 {
                        break;
                    }
                    phi_4417_ = type_8(0u, 8u);
                    loop {
                        let _e2249 = phi_4417_;
                        if (_e2249.member < _e2249.member_1) {
                            phi_4418_ = type_8((_e2249.member + 1u), _e2249.member_1);
                            phi_4441_ = type_8(1u, _e2249.member);
                        } else {
                            phi_4418_ = _e2249;
                            phi_4441_ = type_8(0u, type_8().member_1);
                        }
                        let _e2262 = phi_4418_;
                        let _e2264 = phi_4441_;
                        let _e2268 = (bitcast<i32>(_e2264.member) != 0i);
                        if _e2268 {
                            let _e2269 = (_e2264.member_1 < 8u);
                            if _e2269 {
                            } else {
                                phi_5309_ = true;
                                break;
                            }
                            let _e2271 = local_9[_e2264.member_1];
                            if (_e2271.member_3 != 4294967295u) {
                                let _e2277 = -(_e527);
                                let _e2278 = bitcast<u32>(_e2271.member);
                                let _e2282 = (bitcast<i32>((_e2278 >> bitcast<u32>(23i))) & 255i);
                                let _e2283 = (_e2282 + _e2277);
                                if (_e2282 == 255i) {
                                    phi_4514_ = _e2271.member;
                                } else {
                                    if (_e2282 > 0i) {
                                        if (_e2283 > 0i) {
                                            let _e2287 = (_e2283 < 255i);
                                            if _e2287 {
                                                phi_4493_ = bitcast<f32>((_e2278 + bitcast<u32>((_e2277 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4493_ = f32();
                                            }
                                            let _e2294 = phi_4493_;
                                            phi_4495_ = _e2294;
                                            phi_4496_ = select(true, false, _e2287);
                                        } else {
                                            phi_4495_ = f32();
                                            phi_4496_ = true;
                                        }
                                        let _e2297 = phi_4495_;
                                        let _e2299 = phi_4496_;
                                        phi_4497_ = _e2297;
                                        phi_4498_ = _e2299;
                                    } else {
                                        phi_4497_ = f32();
                                        phi_4498_ = true;
                                    }
                                    let _e2301 = phi_4497_;
                                    let _e2303 = phi_4498_;
                                    if _e2303 {
                                        let _e2304 = (_e2278 & 2147483648u);
                                        let _e2311 = ((_e2278 & 8388607u) | (select(0u, 1u, ((_e2278 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2315 = (_e2311 == 0u);
                                        if _e2315 {
                                            phi_4835_ = bitcast<f32>(_e2304);
                                        } else {
                                            let _e2320 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2311)), 32u, _e2315) - 8u);
                                            let _e2323 = (_e2311 << bitcast<u32>((_e2320 & 31u)));
                                            let _e2325 = ((_e2283 + select(0i, 1i, (_e2282 == 0i))) - bitcast<i32>(_e2320));
                                            if (_e2325 >= 255i) {
                                                phi_4825_ = bitcast<f32>((_e2304 | 2139095040u));
                                                phi_4826_ = f32();
                                                phi_4827_ = true;
                                            } else {
                                                let _e2327 = (_e2325 > 0i);
                                                if _e2327 {
                                                    phi_4819_ = bitcast<f32>(((_e2304 | (bitcast<u32>(_e2325) << bitcast<u32>(23i))) | (_e2323 & 8388607u)));
                                                    phi_4820_ = f32();
                                                } else {
                                                    if (_e2325 < -24i) {
                                                        phi_4785_ = 26u;
                                                    } else {
                                                        phi_4785_ = bitcast<u32>((1i - _e2325));
                                                    }
                                                    let _e2332 = phi_4785_;
                                                    let _e2333 = (_e2332 & 31u);
                                                    let _e2335 = (_e2323 >> bitcast<u32>(_e2333));
                                                    let _e2339 = (_e2323 & ((1u << bitcast<u32>(_e2333)) - 1u));
                                                    let _e2343 = (1u << bitcast<u32>(((_e2332 - 1u) & 31u)));
                                                    if (_e2339 > _e2343) {
                                                        phi_4806_ = true;
                                                    } else {
                                                        if (_e2339 == _e2343) {
                                                            phi_4803_ = ((_e2335 & 1u) == 1u);
                                                        } else {
                                                            phi_4803_ = false;
                                                        }
                                                        let _e2349 = phi_4803_;
                                                        phi_4806_ = _e2349;
                                                    }
                                                    let _e2351 = phi_4806_;
                                                    phi_4819_ = f32();
                                                    phi_4820_ = bitcast<f32>((_e2304 | (_e2335 + select(0u, 1u, _e2351))));
                                                }
                                                let _e2364 = phi_4819_;
                                                let _e2366 = phi_4820_;
                                                phi_4825_ = _e2364;
                                                phi_4826_ = _e2366;
                                                phi_4827_ = _e2327;
                                            }
                                            let _e2370 = phi_4825_;
                                            let _e2372 = phi_4826_;
                                            let _e2374 = phi_4827_;
                                            phi_4835_ = select(_e2372, _e2370, _e2374);
                                        }
                                        let _e2378 = phi_4835_;
                                        phi_4513_ = _e2378;
                                    } else {
                                        phi_4513_ = _e2301;
                                    }
                                    let _e2380 = phi_4513_;
                                    phi_4514_ = _e2380;
                                }
                                let _e2382 = phi_4514_;
                                let _e2383 = bitcast<u32>(_e2382);
                                if ((_e2383 & 2147483647u) >= 2139095040u) {
                                    phi_4526_ = bitcast<f32>(((_e2383 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4526_ = _e2382;
                                }
                                let _e2390 = phi_4526_;
                                phi_4531_ = type_20(_e2390, _e2271.member_1, _e2271.member_2, _e2271.member_3);
                            } else {
                                phi_4531_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2393 = phi_4531_;
                            if _e2269 {
                            } else {
                                phi_5309_ = true;
                                break;
                            }
                            local_9[_e2264.member_1] = type_20(_e2393.member, _e2393.member_1, _e2393.member_2, _e2393.member_3);
                        }
                        continue;
                        continuing {
                            phi_4417_ = _e2262;
                            phi_5309_ = _e2247;
                            break if !(_e2268);
                        }
                    }
                    let _e2401 = phi_5309_;
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
