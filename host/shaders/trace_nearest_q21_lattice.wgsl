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
    var phi_4976_: bool;
    var phi_4890_: f32;
    var phi_1234_: u32;
    var phi_1237_: bool;
    var phi_1239_: u32;
    var phi_1241_: type_51;
    var phi_1252_: bool;
    var phi_1339_: bool;
    var phi_1340_: u32;
    var phi_1341_: type_51;
    var phi_4973_: bool;
    var phi_4915_: f32;
    var phi_1360_: type_8;
    var phi_1361_: type_8;
    var phi_1384_: type_8;
    var phi_1425_: u32;
    var phi_1431_: u32;
    var phi_1441_: u32;
    var phi_1457_: u32;
    var phi_1490_: u32;
    var phi_1496_: u32;
    var phi_1962_: u32;
    var phi_1980_: u32;
    var phi_1998_: u32;
    var phi_2021_: u32;
    var phi_2039_: u32;
    var phi_2057_: u32;
    var phi_2080_: u32;
    var phi_2098_: u32;
    var phi_2116_: u32;
    var phi_1670_: u32;
    var phi_1685_: u32;
    var phi_1695_: u32;
    var phi_1716_: u32;
    var phi_1737_: u32;
    var phi_1767_: u32;
    var phi_1782_: u32;
    var phi_1792_: u32;
    var phi_1813_: u32;
    var phi_1834_: u32;
    var phi_1864_: u32;
    var phi_1879_: u32;
    var phi_1889_: u32;
    var phi_1910_: u32;
    var phi_1931_: u32;
    var phi_1523_: u32;
    var phi_1572_: u32;
    var phi_1621_: u32;
    var phi_2122_: array<array<f32, 3>, 3>;
    var phi_2275_: bool;
    var phi_2304_: bool;
    var phi_2723_: f32;
    var phi_2724_: f32;
    var phi_2725_: f32;
    var phi_2726_: f32;
    var phi_2727_: vec3<f32>;
    var phi_2728_: vec3<f32>;
    var phi_2729_: vec3<f32>;
    var phi_2730_: vec3<f32>;
    var phi_2767_: bool;
    var phi_2776_: vec3<f32>;
    var phi_2941_: f32;
    var phi_2943_: f32;
    var phi_2944_: bool;
    var phi_2964_: f32;
    var phi_2965_: f32;
    var phi_2988_: type_20;
    var phi_2990_: type_20;
    var phi_2991_: bool;
    var phi_2995_: type_20;
    var phi_2996_: type_20;
    var phi_2997_: type_20;
    var phi_2998_: bool;
    var phi_3002_: type_20;
    var phi_3003_: bool;
    var phi_3004_: type_20;
    var phi_3005_: bool;
    var phi_3006_: bool;
    var phi_3007_: type_20;
    var phi_3008_: bool;
    var phi_3009_: bool;
    var phi_3017_: type_20;
    var phi_3018_: bool;
    var phi_3022_: type_20;
    var phi_3034_: type_8;
    var phi_3037_: type_20;
    var phi_3035_: type_8;
    var phi_3060_: type_8;
    var phi_3092_: bool;
    var phi_3093_: bool;
    var phi_3114_: type_20;
    var phi_3038_: type_20;
    var phi_4944_: bool;
    var phi_5305_: f32;
    var phi_5304_: f32;
    var phi_5154_: bool;
    var phi_5303_: f32;
    var phi_5153_: bool;
    var phi_5302_: f32;
    var phi_5152_: bool;
    var phi_5214_: f32;
    var phi_5151_: bool;
    var phi_5398_: bool;
    var phi_5213_: f32;
    var phi_3627_: u32;
    var phi_3633_: u32;
    var phi_3887_: u32;
    var phi_3888_: u32;
    var phi_3898_: u32;
    var phi_3900_: u32;
    var phi_3901_: bool;
    var phi_3921_: u32;
    var phi_3922_: u32;
    var phi_3926_: type_52;
    var phi_4289_: type_51;
    var phi_4365_: type_51;
    var phi_4366_: u32;
    var phi_4367_: type_51;
    var phi_4369_: u32;
    var phi_4370_: type_51;
    var phi_4371_: bool;
    var phi_4380_: type_51;
    var phi_4385_: bool;
    var phi_4387_: type_51;
    var phi_4391_: bool;
    var phi_4392_: u32;
    var phi_4393_: type_51;
    var phi_4403_: type_51;
    var phi_5426_: f32;
    var phi_5310_: bool;
    var phi_4404_: u32;
    var phi_4405_: bool;
    var phi_4406_: u32;
    var phi_4407_: type_51;
    var phi_5425_: f32;
    var phi_5309_: bool;
    var phi_4408_: u32;
    var phi_4409_: bool;
    var phi_4410_: u32;
    var phi_4411_: type_51;
    var phi_5424_: f32;
    var phi_5308_: bool;
    var phi_1235_: u32;
    var phi_1238_: bool;
    var phi_1240_: u32;
    var phi_1242_: type_51;
    var phi_4412_: bool;
    var phi_5307_: bool;
    var phi_4419_: type_8;
    var phi_4420_: type_8;
    var phi_4443_: type_8;
    var phi_4495_: f32;
    var phi_4497_: f32;
    var phi_4498_: bool;
    var phi_4499_: f32;
    var phi_4500_: bool;
    var phi_4787_: u32;
    var phi_4805_: bool;
    var phi_4808_: bool;
    var phi_4821_: f32;
    var phi_4822_: f32;
    var phi_4827_: f32;
    var phi_4828_: f32;
    var phi_4829_: bool;
    var phi_4837_: f32;
    var phi_4515_: f32;
    var phi_4516_: f32;
    var phi_4528_: f32;
    var phi_4533_: type_20;
    var phi_5406_: bool;

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
                    phi_4976_ = false;
                    phi_4890_ = _e623;
                    phi_1234_ = ((3u * _e99) + 1u);
                    phi_1237_ = (_e625 <= _e623);
                    phi_1239_ = 0u;
                    phi_1241_ = type_51(type_24(vec4<f32>((f32(_e631) * _e150), (f32(_e637) * _e150), (f32(_e643) * _e150), 0f), vec4<f32>((f32(_e648) * _e150), (f32(_e652) * _e150), (f32(_e656) * _e150), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    loop {
                        let _e666 = phi_4976_;
                        let _e668 = phi_4890_;
                        let _e670 = phi_1234_;
                        let _e672 = phi_1237_;
                        let _e674 = phi_1239_;
                        let _e676 = phi_1241_;
                        if _e672 {
                            phi_1252_ = true;
                        } else {
                            phi_1252_ = (_e674 > 0u);
                        }
                        let _e679 = phi_1252_;
                        if _e679 {
                            let _e680 = (_e670 > 0u);
                            if _e680 {
                                if _e672 {
                                    phi_1339_ = _e672;
                                    phi_1340_ = _e674;
                                    phi_1341_ = _e676;
                                } else {
                                    let _e681 = (_e674 - 1u);
                                    let _e682 = (_e681 % 128u);
                                    let _e683 = (_e682 < 128u);
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e685 = local_7[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e687 = local_6[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e689 = local_5[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e691 = local_4[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e693 = local_3[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e695 = local_2[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e700 = local_8[_e682];
                                    if _e683 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e703 = local_10[_e682];
                                    phi_1339_ = (_e703 <= _e668);
                                    phi_1340_ = _e681;
                                    phi_1341_ = type_51(type_24(vec4<f32>(_e685, _e687, _e689, 0f), vec4<f32>(_e691, _e693, _e695, 0f)), _e700);
                                }
                                let _e706 = phi_1339_;
                                let _e708 = phi_1340_;
                                let _e710 = phi_1341_;
                                if _e706 {
                                    let _e714 = ((_e710.member_1 & 2147483648u) != 0u);
                                    let _e715 = (_e710.member_1 & 268435455u);
                                    if _e714 {
                                        phi_4973_ = _e666;
                                        phi_4915_ = _e668;
                                        phi_1360_ = type_8(0u, ((_e710.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e722 = phi_4973_;
                                            let _e724 = phi_4915_;
                                            let _e726 = phi_1360_;
                                            if (_e726.member < _e726.member_1) {
                                                phi_1361_ = type_8((_e726.member + 1u), _e726.member_1);
                                                phi_1384_ = type_8(1u, _e726.member);
                                            } else {
                                                phi_1361_ = _e726;
                                                phi_1384_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e739 = phi_1361_;
                                            let _e741 = phi_1384_;
                                            let _e745 = (bitcast<i32>(_e741.member) != 0i);
                                            if _e745 {
                                                let _e750 = (_e710.member.member_1.x - _e710.member.member.x);
                                                let _e753 = (_e710.member.member_1.y - _e710.member.member.y);
                                                let _e756 = (_e710.member.member_1.z - _e710.member.member.z);
                                                let _e758 = select(_e753, _e750, (_e750 > _e753));
                                                let _e760 = select(_e756, _e758, (_e758 > _e756));
                                                let _e762 = (_e760 < (1024f * _e150));
                                                if _e762 {
                                                    phi_1425_ = 0u;
                                                } else {
                                                    phi_1425_ = select(2u, 1u, (_e760 < (2097152f * _e150)));
                                                }
                                                let _e767 = phi_1425_;
                                                switch bitcast<i32>(_e767) {
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
                                                let _e770 = phi_1431_;
                                                switch bitcast<i32>(_e767) {
                                                    case 0: {
                                                        phi_1441_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1441_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1441_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1441_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e777 = phi_1441_;
                                                let _e779 = ((_e715 + (_e741.member_1 * ((3u * _e770) + 1u))) + (3u * _e777));
                                                let _e780 = (_e779 < _e102);
                                                if _e780 {
                                                    if _e780 {
                                                    } else {
                                                        phi_5214_ = _e724;
                                                        phi_5151_ = true;
                                                        break;
                                                    }
                                                    let _e782 = global_5.member[_e779];
                                                    phi_1457_ = _e782;
                                                } else {
                                                    phi_1457_ = 4294967295u;
                                                }
                                                let _e784 = phi_1457_;
                                                if _e762 {
                                                    phi_1490_ = 0u;
                                                } else {
                                                    phi_1490_ = select(2u, 1u, (_e760 < (2097152f * _e150)));
                                                }
                                                let _e789 = phi_1490_;
                                                switch bitcast<i32>(_e789) {
                                                    case 0: {
                                                        phi_1496_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1496_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1496_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1496_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e792 = phi_1496_;
                                                let _e796 = (_e715 + (_e741.member_1 * ((3u * _e792) + 1u)));
                                                switch bitcast<i32>(_e789) {
                                                    case 0: {
                                                        let _e1071 = (_e796 < _e102);
                                                        if _e1071 {
                                                            if _e1071 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1073 = global_5.member[_e796];
                                                            phi_1523_ = _e1073;
                                                        } else {
                                                            phi_1523_ = 0u;
                                                        }
                                                        let _e1075 = phi_1523_;
                                                        let _e1077 = ((10u * _e270) & 31u);
                                                        let _e1087 = ((10u * _e269) & 31u);
                                                        let _e1097 = ((10u * _e271) & 31u);
                                                        let _e1107 = (_e796 + 1u);
                                                        let _e1108 = (_e1107 < _e102);
                                                        if _e1108 {
                                                            if _e1108 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1110 = global_5.member[_e1107];
                                                            phi_1572_ = _e1110;
                                                        } else {
                                                            phi_1572_ = 0u;
                                                        }
                                                        let _e1112 = phi_1572_;
                                                        let _e1138 = (_e796 + 2u);
                                                        let _e1139 = (_e1138 < _e102);
                                                        if _e1139 {
                                                            if _e1139 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1141 = global_5.member[_e1138];
                                                            phi_1621_ = _e1141;
                                                        } else {
                                                            phi_1621_ = 0u;
                                                        }
                                                        let _e1143 = phi_1621_;
                                                        phi_2122_ = array<array<f32, 3>, 3>(array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | ((_e1075 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | ((_e1075 >> bitcast<u32>(_e1087)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | ((_e1075 >> bitcast<u32>(_e1097)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | ((_e1112 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | ((_e1112 >> bitcast<u32>(_e1087)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | ((_e1112 >> bitcast<u32>(_e1097)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | ((_e1143 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | ((_e1143 >> bitcast<u32>(_e1087)) & 1023u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | ((_e1143 >> bitcast<u32>(_e1097)) & 1023u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e885 = (_e796 < _e102);
                                                        if _e885 {
                                                            if _e885 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e887 = global_5.member[_e796];
                                                            phi_1670_ = _e887;
                                                        } else {
                                                            phi_1670_ = 0u;
                                                        }
                                                        let _e889 = phi_1670_;
                                                        let _e890 = (_e796 + 1u);
                                                        let _e891 = (_e890 < _e102);
                                                        if _e891 {
                                                            if _e891 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e893 = global_5.member[_e890];
                                                            phi_1685_ = _e893;
                                                        } else {
                                                            phi_1685_ = 0u;
                                                        }
                                                        let _e895 = phi_1685_;
                                                        let _e896 = (_e270 == 1u);
                                                        if _e896 {
                                                            phi_1695_ = ((_e889 >> bitcast<u32>(21i)) | (_e895 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1695_ = (_e895 >> bitcast<u32>(10i));
                                                        }
                                                        let _e905 = phi_1695_;
                                                        let _e913 = (_e269 == 1u);
                                                        if _e913 {
                                                            phi_1716_ = ((_e889 >> bitcast<u32>(21i)) | (_e895 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1716_ = (_e895 >> bitcast<u32>(10i));
                                                        }
                                                        let _e922 = phi_1716_;
                                                        let _e930 = (_e271 == 1u);
                                                        if _e930 {
                                                            phi_1737_ = ((_e889 >> bitcast<u32>(21i)) | (_e895 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1737_ = (_e895 >> bitcast<u32>(10i));
                                                        }
                                                        let _e939 = phi_1737_;
                                                        let _e948 = (_e796 + 2u);
                                                        let _e949 = (_e948 < _e102);
                                                        if _e949 {
                                                            if _e949 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e951 = global_5.member[_e948];
                                                            phi_1767_ = _e951;
                                                        } else {
                                                            phi_1767_ = 0u;
                                                        }
                                                        let _e953 = phi_1767_;
                                                        let _e954 = (_e796 + 3u);
                                                        let _e955 = (_e954 < _e102);
                                                        if _e955 {
                                                            if _e955 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e957 = global_5.member[_e954];
                                                            phi_1782_ = _e957;
                                                        } else {
                                                            phi_1782_ = 0u;
                                                        }
                                                        let _e959 = phi_1782_;
                                                        if _e896 {
                                                            phi_1792_ = ((_e953 >> bitcast<u32>(21i)) | (_e959 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1792_ = (_e959 >> bitcast<u32>(10i));
                                                        }
                                                        let _e968 = phi_1792_;
                                                        if _e913 {
                                                            phi_1813_ = ((_e953 >> bitcast<u32>(21i)) | (_e959 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1813_ = (_e959 >> bitcast<u32>(10i));
                                                        }
                                                        let _e984 = phi_1813_;
                                                        if _e930 {
                                                            phi_1834_ = ((_e953 >> bitcast<u32>(21i)) | (_e959 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1834_ = (_e959 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1000 = phi_1834_;
                                                        let _e1009 = (_e796 + 4u);
                                                        let _e1010 = (_e1009 < _e102);
                                                        if _e1010 {
                                                            if _e1010 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1012 = global_5.member[_e1009];
                                                            phi_1864_ = _e1012;
                                                        } else {
                                                            phi_1864_ = 0u;
                                                        }
                                                        let _e1014 = phi_1864_;
                                                        let _e1015 = (_e796 + 5u);
                                                        let _e1016 = (_e1015 < _e102);
                                                        if _e1016 {
                                                            if _e1016 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1018 = global_5.member[_e1015];
                                                            phi_1879_ = _e1018;
                                                        } else {
                                                            phi_1879_ = 0u;
                                                        }
                                                        let _e1020 = phi_1879_;
                                                        if _e896 {
                                                            phi_1889_ = ((_e1014 >> bitcast<u32>(21i)) | (_e1020 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1889_ = (_e1020 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1029 = phi_1889_;
                                                        if _e913 {
                                                            phi_1910_ = ((_e1014 >> bitcast<u32>(21i)) | (_e1020 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1910_ = (_e1020 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1045 = phi_1910_;
                                                        if _e930 {
                                                            phi_1931_ = ((_e1014 >> bitcast<u32>(21i)) | (_e1020 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1931_ = (_e1020 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1061 = phi_1931_;
                                                        phi_2122_ = array<array<f32, 3>, 3>(array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | (select(_e905, _e889, _e309) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | (select(_e922, _e889, _e378) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | (select(_e939, _e889, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | (select(_e968, _e953, _e309) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | (select(_e984, _e953, _e378) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1000, _e953, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e710.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1029, _e1014, _e309) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1045, _e1014, _e378) & 2097151u))) - 8388608f) * _e150)), (_e710.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1061, _e1014, _e446) & 2097151u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e798 = (_e796 + _e270);
                                                        let _e799 = (_e798 < _e102);
                                                        if _e799 {
                                                            if _e799 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e801 = global_5.member[_e798];
                                                            phi_1962_ = _e801;
                                                        } else {
                                                            phi_1962_ = 0u;
                                                        }
                                                        let _e803 = phi_1962_;
                                                        let _e807 = (_e796 + _e269);
                                                        let _e808 = (_e807 < _e102);
                                                        if _e808 {
                                                            if _e808 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e810 = global_5.member[_e807];
                                                            phi_1980_ = _e810;
                                                        } else {
                                                            phi_1980_ = 0u;
                                                        }
                                                        let _e812 = phi_1980_;
                                                        let _e816 = (_e796 + _e271);
                                                        let _e817 = (_e816 < _e102);
                                                        if _e817 {
                                                            if _e817 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e819 = global_5.member[_e816];
                                                            phi_1998_ = _e819;
                                                        } else {
                                                            phi_1998_ = 0u;
                                                        }
                                                        let _e821 = phi_1998_;
                                                        let _e826 = (_e796 + 3u);
                                                        let _e827 = (_e826 + _e270);
                                                        let _e828 = (_e827 < _e102);
                                                        if _e828 {
                                                            if _e828 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e830 = global_5.member[_e827];
                                                            phi_2021_ = _e830;
                                                        } else {
                                                            phi_2021_ = 0u;
                                                        }
                                                        let _e832 = phi_2021_;
                                                        let _e836 = (_e826 + _e269);
                                                        let _e837 = (_e836 < _e102);
                                                        if _e837 {
                                                            if _e837 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e839 = global_5.member[_e836];
                                                            phi_2039_ = _e839;
                                                        } else {
                                                            phi_2039_ = 0u;
                                                        }
                                                        let _e841 = phi_2039_;
                                                        let _e845 = (_e826 + _e271);
                                                        let _e846 = (_e845 < _e102);
                                                        if _e846 {
                                                            if _e846 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e848 = global_5.member[_e845];
                                                            phi_2057_ = _e848;
                                                        } else {
                                                            phi_2057_ = 0u;
                                                        }
                                                        let _e850 = phi_2057_;
                                                        let _e855 = (_e796 + 6u);
                                                        let _e856 = (_e855 + _e270);
                                                        let _e857 = (_e856 < _e102);
                                                        if _e857 {
                                                            if _e857 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e859 = global_5.member[_e856];
                                                            phi_2080_ = _e859;
                                                        } else {
                                                            phi_2080_ = 0u;
                                                        }
                                                        let _e861 = phi_2080_;
                                                        let _e865 = (_e855 + _e269);
                                                        let _e866 = (_e865 < _e102);
                                                        if _e866 {
                                                            if _e866 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e868 = global_5.member[_e865];
                                                            phi_2098_ = _e868;
                                                        } else {
                                                            phi_2098_ = 0u;
                                                        }
                                                        let _e870 = phi_2098_;
                                                        let _e874 = (_e855 + _e271);
                                                        let _e875 = (_e874 < _e102);
                                                        if _e875 {
                                                            if _e875 {
                                                            } else {
                                                                phi_5214_ = _e724;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e877 = global_5.member[_e874];
                                                            phi_2116_ = _e877;
                                                        } else {
                                                            phi_2116_ = 0u;
                                                        }
                                                        let _e879 = phi_2116_;
                                                        phi_2122_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e803)) * _e150), (f32(bitcast<i32>(_e812)) * _e150), (f32(bitcast<i32>(_e821)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e832)) * _e150), (f32(bitcast<i32>(_e841)) * _e150), (f32(bitcast<i32>(_e850)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e861)) * _e150), (f32(bitcast<i32>(_e870)) * _e150), (f32(bitcast<i32>(_e879)) * _e150)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2122_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1171 = phi_2122_;
                                                let _e1178 = (_e1171[0][2] - _e471);
                                                let _e1181 = (((_e1171[0][0] - _e334) * _e510) - (_e1178 * _e374));
                                                let _e1184 = (((_e1171[0][1] - _e403) * _e510) - (_e1178 * _e442));
                                                let _e1191 = (_e1171[1][2] - _e471);
                                                let _e1194 = (((_e1171[1][0] - _e334) * _e510) - (_e1191 * _e374));
                                                let _e1197 = (((_e1171[1][1] - _e403) * _e510) - (_e1191 * _e442));
                                                let _e1204 = (_e1171[2][2] - _e471);
                                                let _e1207 = (((_e1171[2][0] - _e334) * _e510) - (_e1204 * _e374));
                                                let _e1210 = (((_e1171[2][1] - _e403) * _e510) - (_e1204 * _e442));
                                                let _e1211 = (_e1207 * _e1197);
                                                let _e1212 = (_e1210 * _e1194);
                                                let _e1213 = (_e1181 * _e1210);
                                                let _e1214 = (_e1184 * _e1207);
                                                let _e1215 = (_e1194 * _e1184);
                                                let _e1216 = (_e1197 * _e1181);
                                                let _e1221 = (((_e1211 >= _e1212) && (_e1213 >= _e1214)) && (_e1215 >= _e1216));
                                                if (_e1221 || (((_e1211 <= _e1212) && (_e1213 <= _e1214)) && (_e1215 <= _e1216))) {
                                                    let _e1228 = select(-1f, 1f, _e1221);
                                                    let _e1230 = ((_e1211 - _e1212) * _e1228);
                                                    let _e1232 = select(0f, _e1230, (_e1230 > 0f));
                                                    let _e1234 = ((_e1213 - _e1214) * _e1228);
                                                    let _e1236 = select(0f, _e1234, (_e1234 > 0f));
                                                    let _e1238 = ((_e1215 - _e1216) * _e1228);
                                                    let _e1240 = select(0f, _e1238, (_e1238 > 0f));
                                                    let _e1242 = ((_e1232 + _e1236) + _e1240);
                                                    if (_e1242 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3007_ = type_20();
                                                        phi_3008_ = true;
                                                        phi_3009_ = false;
                                                    } else {
                                                        let _e1245 = select(_e1194, _e1181, (_e1181 < _e1194));
                                                        if (select(_e1207, _e1245, (_e1245 < _e1207)) > 0f) {
                                                            phi_2275_ = true;
                                                        } else {
                                                            let _e1250 = select(_e1194, _e1181, (_e1181 > _e1194));
                                                            phi_2275_ = (select(_e1207, _e1250, (_e1250 > _e1207)) < 0f);
                                                        }
                                                        let _e1255 = phi_2275_;
                                                        if _e1255 {
                                                            phi_3004_ = type_20();
                                                            phi_3005_ = true;
                                                            phi_3006_ = false;
                                                        } else {
                                                            let _e1257 = select(_e1197, _e1184, (_e1184 < _e1197));
                                                            if (select(_e1210, _e1257, (_e1257 < _e1210)) > 0f) {
                                                                phi_2304_ = true;
                                                            } else {
                                                                let _e1262 = select(_e1197, _e1184, (_e1184 > _e1197));
                                                                phi_2304_ = (select(_e1210, _e1262, (_e1262 > _e1210)) < 0f);
                                                            }
                                                            let _e1267 = phi_2304_;
                                                            if _e1267 {
                                                                phi_3002_ = type_20();
                                                                phi_3003_ = false;
                                                            } else {
                                                                let _e1269 = select(_e1171[1][0], _e1171[0][0], (_e1171[0][0] < _e1171[1][0]));
                                                                let _e1273 = select(_e1171[1][0], _e1171[0][0], (_e1171[0][0] > _e1171[1][0]));
                                                                let _e1277 = select(_e1171[1][1], _e1171[0][1], (_e1171[0][1] < _e1171[1][1]));
                                                                let _e1281 = select(_e1171[1][1], _e1171[0][1], (_e1171[0][1] > _e1171[1][1]));
                                                                let _e1285 = select(_e1171[1][2], _e1171[0][2], (_e1171[0][2] < _e1171[1][2]));
                                                                let _e1289 = select(_e1171[1][2], _e1171[0][2], (_e1171[0][2] > _e1171[1][2]));
                                                                let _e1294 = ((select(_e1171[2][0], _e1269, (_e1269 < _e1171[2][0])) - _e372) * _e377);
                                                                let _e1295 = ((select(_e1171[2][0], _e1273, (_e1273 > _e1171[2][0])) - _e373) * _e377);
                                                                let _e1298 = ((select(_e1171[2][1], _e1277, (_e1277 < _e1171[2][1])) - _e440) * _e445);
                                                                let _e1299 = ((select(_e1171[2][1], _e1281, (_e1281 > _e1171[2][1])) - _e441) * _e445);
                                                                let _e1302 = ((select(_e1171[2][2], _e1285, (_e1285 < _e1171[2][2])) - _e508) * _e513);
                                                                let _e1303 = ((select(_e1171[2][2], _e1289, (_e1289 > _e1171[2][2])) - _e509) * _e513);
                                                                let _e1305 = select(_e1303, _e1302, (_e1302 < _e1303));
                                                                let _e1307 = select(_e1303, _e1302, (_e1302 > _e1303));
                                                                let _e1309 = select(_e1295, _e1294, (_e1294 < _e1295));
                                                                let _e1311 = select(_e1299, _e1298, (_e1298 < _e1299));
                                                                let _e1313 = select(_e1311, _e1309, (_e1309 > _e1311));
                                                                let _e1315 = select(_e1305, _e1313, (_e1313 > _e1305));
                                                                let _e1317 = select(_e1295, _e1294, (_e1294 > _e1295));
                                                                let _e1319 = select(_e1299, _e1298, (_e1298 > _e1299));
                                                                let _e1321 = select(_e1319, _e1317, (_e1317 < _e1319));
                                                                let _e1323 = select(_e1307, _e1321, (_e1321 < _e1307));
                                                                let _e1324 = -(_e1305);
                                                                let _e1330 = select(_e625, _e1315, (_e1315 > _e625));
                                                                if (_e1330 > (_e1323 + (select(_e1324, _e1307, (_e1307 > _e1324)) * 0.0000019073523f))) {
                                                                    phi_2997_ = type_20();
                                                                    phi_2998_ = true;
                                                                } else {
                                                                    let _e1332 = (_e1330 > _e724);
                                                                    if _e1332 {
                                                                        phi_2996_ = type_20();
                                                                    } else {
                                                                        let _e1333 = vec3<f32>(_e1171[0][0], _e1171[0][1], _e1171[0][2]);
                                                                        let _e1334 = vec3<f32>(_e1171[1][0], _e1171[1][1], _e1171[1][2]);
                                                                        let _e1335 = vec3<f32>(_e1171[2][0], _e1171[2][1], _e1171[2][2]);
                                                                        let _e1336 = (_e1171[1][0] - _e1171[0][0]);
                                                                        let _e1337 = (_e1171[1][1] - _e1171[0][1]);
                                                                        let _e1338 = (_e1171[1][2] - _e1171[0][2]);
                                                                        let _e1339 = vec3<f32>(_e1336, _e1337, _e1338);
                                                                        let _e1340 = (_e1171[2][0] - _e1171[1][0]);
                                                                        let _e1341 = (_e1171[2][1] - _e1171[1][1]);
                                                                        let _e1342 = (_e1171[2][2] - _e1171[1][2]);
                                                                        let _e1343 = vec3<f32>(_e1340, _e1341, _e1342);
                                                                        let _e1344 = (_e1171[0][0] - _e1171[2][0]);
                                                                        let _e1345 = (_e1171[0][1] - _e1171[2][1]);
                                                                        let _e1346 = (_e1171[0][2] - _e1171[2][2]);
                                                                        let _e1347 = vec3<f32>(_e1344, _e1345, _e1346);
                                                                        let _e1350 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                        let _e1353 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                        let _e1355 = select(_e1353, _e1350, (_e1350 > _e1353));
                                                                        let _e1358 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1360 = select(_e1358, _e1355, (_e1355 > _e1358));
                                                                        let _e1363 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                        let _e1366 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                        let _e1368 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                                        let _e1371 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                        let _e1373 = select(_e1371, _e1368, (_e1368 > _e1371));
                                                                        let _e1376 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                        let _e1379 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                        let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                        let _e1384 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                        let _e1386 = select(_e1384, _e1381, (_e1381 > _e1384));
                                                                        let _e1388 = select(_e1373, _e1360, (_e1360 > _e1373));
                                                                        let _e1390 = select(_e1386, _e1388, (_e1388 > _e1386));
                                                                        if (_e1360 == _e1390) {
                                                                            phi_2723_ = _e1197;
                                                                            phi_2724_ = _e1194;
                                                                            phi_2725_ = _e1184;
                                                                            phi_2726_ = _e1181;
                                                                            phi_2727_ = _e1333;
                                                                            phi_2728_ = _e1347;
                                                                            phi_2729_ = _e1343;
                                                                            phi_2730_ = _e1339;
                                                                        } else {
                                                                            let _e1392 = (_e1373 == _e1390);
                                                                            let _e1397 = vec3(_e1392);
                                                                            phi_2723_ = select(_e1184, _e1210, _e1392);
                                                                            phi_2724_ = select(_e1181, _e1207, _e1392);
                                                                            phi_2725_ = select(_e1210, _e1197, _e1392);
                                                                            phi_2726_ = select(_e1207, _e1194, _e1392);
                                                                            phi_2727_ = select(_e1335, _e1334, _e1397);
                                                                            phi_2728_ = select(_e1343, _e1339, _e1397);
                                                                            phi_2729_ = select(_e1339, _e1347, _e1397);
                                                                            phi_2730_ = select(_e1347, _e1343, _e1397);
                                                                        }
                                                                        let _e1403 = phi_2723_;
                                                                        let _e1405 = phi_2724_;
                                                                        let _e1407 = phi_2725_;
                                                                        let _e1409 = phi_2726_;
                                                                        let _e1411 = phi_2727_;
                                                                        let _e1413 = phi_2728_;
                                                                        let _e1415 = phi_2729_;
                                                                        let _e1417 = phi_2730_;
                                                                        let _e1424 = ((_e1415.y * _e1413.z) - (_e1413.y * _e1415.z));
                                                                        let _e1429 = ((_e1415.z * _e1413.x) - (_e1413.z * _e1415.x));
                                                                        let _e1432 = ((_e1415.x * _e1413.y) - (_e1413.x * _e1415.y));
                                                                        if (_e1232 >= _e1236) {
                                                                            phi_2767_ = select(true, false, (_e1232 >= _e1240));
                                                                        } else {
                                                                            phi_2767_ = true;
                                                                        }
                                                                        let _e1437 = phi_2767_;
                                                                        if _e1437 {
                                                                            phi_2776_ = select(_e1335, _e1334, vec3((_e1236 >= _e1240)));
                                                                        } else {
                                                                            phi_2776_ = _e1333;
                                                                        }
                                                                        let _e1442 = phi_2776_;
                                                                        let _e1453 = (((_e1424 * (_e1442.x - _e334)) + (_e1429 * (_e1442.y - _e403))) + (_e1432 * (_e1442.z - _e471)));
                                                                        let _e1458 = (((_e1424 * _e374) + (_e1429 * _e442)) + (_e1432 * _e510));
                                                                        let _e1459 = (_e1405 - _e1409);
                                                                        let _e1460 = (_e1403 - _e1407);
                                                                        let _e1468 = (-(((_e1409 * _e1459) + (_e1407 * _e1460))) / ((_e1459 * _e1459) + (_e1460 * _e1460)));
                                                                        let _e1470 = select(1f, _e1468, (_e1468 < 1f));
                                                                        let _e1472 = select(0f, _e1470, (_e1470 > 0f));
                                                                        let _e1485 = ((_e1411.x + (_e1417.x * _e1472)) - _e334);
                                                                        let _e1486 = ((_e1411.y + (_e1417.y * _e1472)) - _e403);
                                                                        let _e1487 = ((_e1411.z + (_e1417.z * _e1472)) - _e471);
                                                                        let _e1488 = (_e1487 / _e510);
                                                                        let _e1500 = bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u));
                                                                        let _e1503 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                                        let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                        let _e1508 = bitcast<f32>((bitcast<u32>(_e1487) & 2147483647u));
                                                                        let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                        let _e1516 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                        let _e1519 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                        let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                                        let _e1524 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1424 * _e1485) + (_e1429 * _e1486)) + (_e1432 * _e1487)) - _e1453)) & 2147483647u)) <= ((0.0000009536743f * select(_e1390, _e1510, (_e1510 > _e1390))) * select(_e1524, _e1521, (_e1521 > _e1524)))) {
                                                                            let _e1534 = bitcast<f32>((bitcast<u32>(_e1415.x) & 2147483647u));
                                                                            let _e1537 = bitcast<f32>((bitcast<u32>(_e1415.y) & 2147483647u));
                                                                            let _e1539 = select(_e1537, _e1534, (_e1534 > _e1537));
                                                                            let _e1542 = bitcast<f32>((bitcast<u32>(_e1415.z) & 2147483647u));
                                                                            let _e1548 = bitcast<f32>((bitcast<u32>(_e1413.x) & 2147483647u));
                                                                            let _e1551 = bitcast<f32>((bitcast<u32>(_e1413.y) & 2147483647u));
                                                                            let _e1553 = select(_e1551, _e1548, (_e1548 > _e1551));
                                                                            let _e1556 = bitcast<f32>((bitcast<u32>(_e1413.z) & 2147483647u));
                                                                            let _e1560 = (bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u)) > ((0.0000038146973f * select(_e1542, _e1539, (_e1539 > _e1542))) * select(_e1556, _e1553, (_e1553 > _e1556))));
                                                                            if _e1560 {
                                                                                phi_2941_ = (_e1453 / _e1458);
                                                                            } else {
                                                                                phi_2941_ = f32();
                                                                            }
                                                                            let _e1563 = phi_2941_;
                                                                            phi_2943_ = _e1563;
                                                                            phi_2944_ = select(true, false, _e1560);
                                                                        } else {
                                                                            phi_2943_ = f32();
                                                                            phi_2944_ = true;
                                                                        }
                                                                        let _e1566 = phi_2943_;
                                                                        let _e1568 = phi_2944_;
                                                                        if _e1568 {
                                                                            let _e1576 = (((_e1424 * (_e1485 - (_e374 * _e1488))) + (_e1429 * (_e1486 - (_e442 * _e1488)))) / _e1458);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1576) & 2147483647u)) <= _e1390) {
                                                                                phi_2964_ = (_e1488 + _e1576);
                                                                            } else {
                                                                                phi_2964_ = _e1488;
                                                                            }
                                                                            let _e1583 = phi_2964_;
                                                                            phi_2965_ = _e1583;
                                                                        } else {
                                                                            phi_2965_ = _e1566;
                                                                        }
                                                                        let _e1585 = phi_2965_;
                                                                        let _e1587 = select(_e1323, _e1585, (_e1585 < _e1323));
                                                                        let _e1589 = select(_e1315, _e1587, (_e1587 > _e1315));
                                                                        if (_e1589 >= _e625) {
                                                                            let _e1591 = (_e1589 <= _e724);
                                                                            if _e1591 {
                                                                                let _e1592 = (1f / _e1242);
                                                                                phi_2988_ = type_20(_e1589, (_e1236 * _e1592), (_e1240 * _e1592), _e784);
                                                                            } else {
                                                                                phi_2988_ = type_20();
                                                                            }
                                                                            let _e1597 = phi_2988_;
                                                                            phi_2990_ = _e1597;
                                                                            phi_2991_ = select(true, false, _e1591);
                                                                        } else {
                                                                            phi_2990_ = type_20();
                                                                            phi_2991_ = true;
                                                                        }
                                                                        let _e1600 = phi_2990_;
                                                                        let _e1602 = phi_2991_;
                                                                        if _e1602 {
                                                                            phi_2995_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2995_ = _e1600;
                                                                        }
                                                                        let _e1604 = phi_2995_;
                                                                        phi_2996_ = _e1604;
                                                                    }
                                                                    let _e1606 = phi_2996_;
                                                                    phi_2997_ = _e1606;
                                                                    phi_2998_ = _e1332;
                                                                }
                                                                let _e1608 = phi_2997_;
                                                                let _e1610 = phi_2998_;
                                                                phi_3002_ = _e1608;
                                                                phi_3003_ = _e1610;
                                                            }
                                                            let _e1612 = phi_3002_;
                                                            let _e1614 = phi_3003_;
                                                            phi_3004_ = _e1612;
                                                            phi_3005_ = _e1267;
                                                            phi_3006_ = _e1614;
                                                        }
                                                        let _e1616 = phi_3004_;
                                                        let _e1618 = phi_3005_;
                                                        let _e1620 = phi_3006_;
                                                        phi_3007_ = _e1616;
                                                        phi_3008_ = _e1618;
                                                        phi_3009_ = _e1620;
                                                    }
                                                    let _e1622 = phi_3007_;
                                                    let _e1624 = phi_3008_;
                                                    let _e1626 = phi_3009_;
                                                    phi_3017_ = _e1622;
                                                    phi_3018_ = select(_e1626, true, _e1624);
                                                } else {
                                                    phi_3017_ = type_20();
                                                    phi_3018_ = true;
                                                }
                                                let _e1629 = phi_3017_;
                                                let _e1631 = phi_3018_;
                                                if _e1631 {
                                                    phi_3022_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3022_ = _e1629;
                                                }
                                                let _e1633 = phi_3022_;
                                                if (_e1633.member_3 != 4294967295u) {
                                                    if (_e784 != 4294967295u) {
                                                        phi_3034_ = type_8(0u, 8u);
                                                        phi_3037_ = _e1633;
                                                        loop {
                                                            let _e1638 = phi_3034_;
                                                            let _e1640 = phi_3037_;
                                                            if (_e1638.member < _e1638.member_1) {
                                                                phi_3035_ = type_8((_e1638.member + 1u), _e1638.member_1);
                                                                phi_3060_ = type_8(1u, _e1638.member);
                                                            } else {
                                                                phi_3035_ = _e1638;
                                                                phi_3060_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1653 = phi_3035_;
                                                            let _e1655 = phi_3060_;
                                                            let _e1659 = (bitcast<i32>(_e1655.member) != 0i);
                                                            if _e1659 {
                                                                let _e1660 = (_e1655.member_1 < 8u);
                                                                if _e1660 {
                                                                } else {
                                                                    phi_4944_ = true;
                                                                    break;
                                                                }
                                                                let _e1665 = local_9[_e1655.member_1].member;
                                                                if (_e1640.member < _e1665) {
                                                                    phi_3093_ = true;
                                                                } else {
                                                                    let _e1667 = local_9[_e1655.member_1].member;
                                                                    if (_e1640.member == _e1667) {
                                                                        let _e1672 = local_9[_e1655.member_1].member_3;
                                                                        phi_3092_ = (_e1640.member_3 < _e1672);
                                                                    } else {
                                                                        phi_3092_ = false;
                                                                    }
                                                                    let _e1675 = phi_3092_;
                                                                    phi_3093_ = _e1675;
                                                                }
                                                                let _e1677 = phi_3093_;
                                                                if _e1677 {
                                                                    if _e1660 {
                                                                    } else {
                                                                        phi_4944_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1678 = local_9[_e1655.member_1];
                                                                    local_9[_e1655.member_1] = type_20(_e1640.member, _e1640.member_1, _e1640.member_2, _e1640.member_3);
                                                                    phi_3114_ = type_20(_e1678.member, _e1678.member_1, _e1678.member_2, _e1678.member_3);
                                                                } else {
                                                                    phi_3114_ = _e1640;
                                                                }
                                                                let _e1689 = phi_3114_;
                                                                phi_3038_ = _e1689;
                                                            } else {
                                                                phi_3038_ = type_20();
                                                            }
                                                            let _e1691 = phi_3038_;
                                                            continue;
                                                            continuing {
                                                                phi_3034_ = _e1653;
                                                                phi_3037_ = _e1691;
                                                                phi_4944_ = _e722;
                                                                break if !(_e1659);
                                                            }
                                                        }
                                                        let _e1694 = phi_4944_;
                                                        phi_5214_ = _e724;
                                                        phi_5151_ = _e1694;
                                                        if _e1694 {
                                                            break;
                                                        }
                                                        let _e1697 = local_9[7u].member_3;
                                                        if (_e1697 != 4294967295u) {
                                                            let _e1701 = local_9[7u].member;
                                                            phi_5305_ = _e1701;
                                                        } else {
                                                            phi_5305_ = _e724;
                                                        }
                                                        let _e1703 = phi_5305_;
                                                        phi_5304_ = _e1703;
                                                        phi_5154_ = _e1694;
                                                    } else {
                                                        phi_5304_ = _e724;
                                                        phi_5154_ = _e722;
                                                    }
                                                    let _e1705 = phi_5304_;
                                                    let _e1707 = phi_5154_;
                                                    phi_5303_ = _e1705;
                                                    phi_5153_ = _e1707;
                                                } else {
                                                    phi_5303_ = _e724;
                                                    phi_5153_ = _e722;
                                                }
                                                let _e1709 = phi_5303_;
                                                let _e1711 = phi_5153_;
                                                phi_5302_ = _e1709;
                                                phi_5152_ = _e1711;
                                            } else {
                                                phi_5302_ = _e724;
                                                phi_5152_ = _e722;
                                            }
                                            let _e1713 = phi_5302_;
                                            let _e1715 = phi_5152_;
                                            continue;
                                            continuing {
                                                phi_4973_ = _e1715;
                                                phi_4915_ = _e1713;
                                                phi_1360_ = _e739;
                                                phi_5214_ = _e1713;
                                                phi_5151_ = _e1715;
                                                break if !(_e745);
                                            }
                                        }
                                        let _e1718 = phi_5214_;
                                        let _e1720 = phi_5151_;
                                        phi_5307_ = _e1720;
                                        if _e1720 {
                                            break;
                                        }
                                        phi_5398_ = _e1720;
                                        phi_5213_ = _e1718;
                                    } else {
                                        phi_5398_ = _e666;
                                        phi_5213_ = _e668;
                                    }
                                    let _e1722 = phi_5398_;
                                    let _e1724 = phi_5213_;
                                    if _e714 {
                                        phi_4391_ = bool();
                                        phi_4392_ = u32();
                                        phi_4393_ = type_51();
                                    } else {
                                        if (_e710.member_1 >= _e99) {
                                            phi_3926_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e710.member_1 < _e99) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1727 = (_e270 * 2u);
                                            let _e1729 = ((1u + _e1727) % 7u);
                                            if (_e1729 < 7u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1734 = global_4.member[_e710.member_1][_e1729];
                                            let _e1736 = ((_e1727 + 2u) % 7u);
                                            if (_e1736 < 7u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1741 = global_4.member[_e710.member_1][_e1736];
                                            let _e1742 = (_e269 * 2u);
                                            let _e1744 = ((1u + _e1742) % 7u);
                                            if (_e1744 < 7u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1749 = global_4.member[_e710.member_1][_e1744];
                                            let _e1751 = ((_e1742 + 2u) % 7u);
                                            if (_e1751 < 7u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1756 = global_4.member[_e710.member_1][_e1751];
                                            let _e1757 = (_e271 * 2u);
                                            let _e1759 = ((1u + _e1757) % 7u);
                                            if (_e1759 < 7u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1764 = global_4.member[_e710.member_1][_e1759];
                                            let _e1766 = ((_e1757 + 2u) % 7u);
                                            if (_e1766 < 7u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1771 = global_4.member[_e710.member_1][_e1766];
                                            let _e1794 = (bitcast<f32>((bitcast<u32>((_e710.member.member_1.x - _e710.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1795 = (bitcast<f32>((bitcast<u32>((_e710.member.member_1.y - _e710.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1796 = (bitcast<f32>((bitcast<u32>((_e710.member.member_1.z - _e710.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1798 = select(_e150, _e1794, (_e1794 > _e150));
                                            let _e1800 = select(_e150, _e1795, (_e1795 > _e150));
                                            let _e1802 = select(_e150, _e1796, (_e1796 > _e150));
                                            let _e1833 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1734 & 2097151u))) - 8388608f) * _e1798));
                                            let _e1838 = (bitcast<i32>((_e1734 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1841 = bitcast<f32>((_e1833 & bitcast<u32>(_e1838)));
                                            let _e1842 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1749 & 2097151u))) - 8388608f) * _e1800));
                                            let _e1847 = (bitcast<i32>((_e1749 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1850 = bitcast<f32>((_e1842 & bitcast<u32>(_e1847)));
                                            let _e1851 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1764 & 2097151u))) - 8388608f) * _e1802));
                                            let _e1856 = (bitcast<i32>((_e1764 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1859 = bitcast<f32>((_e1851 & bitcast<u32>(_e1856)));
                                            let _e1863 = bitcast<f32>((_e1833 & bitcast<u32>(~(_e1838))));
                                            let _e1867 = bitcast<f32>((_e1842 & bitcast<u32>(~(_e1847))));
                                            let _e1871 = bitcast<f32>((_e1851 & bitcast<u32>(~(_e1856))));
                                            let _e1872 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1741 & 2097151u))) - 8388608f) * _e1798));
                                            let _e1877 = (bitcast<i32>((_e1741 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1880 = bitcast<f32>((_e1872 & bitcast<u32>(_e1877)));
                                            let _e1881 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1756 & 2097151u))) - 8388608f) * _e1800));
                                            let _e1886 = (bitcast<i32>((_e1756 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1889 = bitcast<f32>((_e1881 & bitcast<u32>(_e1886)));
                                            let _e1890 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1771 & 2097151u))) - 8388608f) * _e1802));
                                            let _e1895 = (bitcast<i32>((_e1771 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1898 = bitcast<f32>((_e1890 & bitcast<u32>(_e1895)));
                                            let _e1902 = bitcast<f32>((_e1872 & bitcast<u32>(~(_e1877))));
                                            let _e1906 = bitcast<f32>((_e1881 & bitcast<u32>(~(_e1886))));
                                            let _e1910 = bitcast<f32>((_e1890 & bitcast<u32>(~(_e1895))));
                                            let _e1911 = (_e710.member.member.x + _e1841);
                                            let _e1912 = (_e710.member.member.y + _e1850);
                                            let _e1913 = (_e710.member.member.z + _e1859);
                                            let _e1916 = (_e710.member.member_1.x - _e1880);
                                            let _e1917 = (_e710.member.member_1.y - _e1889);
                                            let _e1918 = (_e710.member.member_1.z - _e1898);
                                            let _e1937 = (_e1916 - _e1911);
                                            let _e1938 = (_e1917 - _e1912);
                                            let _e1939 = (_e1918 - _e1913);
                                            let _e1941 = select(_e1938, _e1937, (_e1937 > _e1938));
                                            let _e1943 = select(_e1939, _e1941, (_e1941 > _e1939));
                                            if (_e1943 < (1024f * _e150)) {
                                                phi_3627_ = 0u;
                                            } else {
                                                phi_3627_ = select(2u, 1u, (_e1943 < (2097152f * _e150)));
                                            }
                                            let _e1950 = phi_3627_;
                                            switch bitcast<i32>(_e1950) {
                                                case 0: {
                                                    phi_3633_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3633_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3633_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3633_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1953 = phi_3633_;
                                            let _e1959 = global_4.member[_e710.member_1][0u];
                                            let _e1963 = global_4.member[_e710.member_1][2u];
                                            let _e1967 = global_4.member[_e710.member_1][4u];
                                            let _e1971 = global_4.member[_e710.member_1][6u];
                                            let _e1983 = (((_e1963 >> bitcast<u32>(22i)) | ((_e1967 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1971 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1984 = (_e1959 & 268435455u);
                                            let _e1985 = (_e1983 & 268435455u);
                                            let _e1988 = ((_e1959 >> bitcast<u32>(28u)) & 7u);
                                            let _e1996 = ((_e1959 >> bitcast<u32>(31i)) | (((_e1983 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1997 = (_e1988 != 0u);
                                            if (_e1988 == 0u) {
                                                phi_3888_ = _e1984;
                                            } else {
                                                if (_e1988 == 7u) {
                                                    phi_3887_ = 2147483648u;
                                                } else {
                                                    phi_3887_ = ((2147483648u | (_e1988 << bitcast<u32>(28u))) | (_e1985 & 268435455u));
                                                }
                                                let _e2006 = phi_3887_;
                                                phi_3888_ = _e2006;
                                            }
                                            let _e2008 = phi_3888_;
                                            if _e1997 {
                                                let _e2009 = (_e1988 != 7u);
                                                if _e2009 {
                                                    phi_3898_ = (_e1985 + (_e1988 * ((3u * _e1953) + 1u)));
                                                } else {
                                                    phi_3898_ = u32();
                                                }
                                                let _e2013 = phi_3898_;
                                                phi_3900_ = _e2013;
                                                phi_3901_ = select(true, false, _e2009);
                                            } else {
                                                phi_3900_ = u32();
                                                phi_3901_ = true;
                                            }
                                            let _e2016 = phi_3900_;
                                            let _e2018 = phi_3901_;
                                            if (_e1996 == 0u) {
                                                phi_3922_ = (_e1984 + select(0u, 1u, !(_e1997)));
                                            } else {
                                                if (_e1996 == 7u) {
                                                    phi_3921_ = 2147483648u;
                                                } else {
                                                    phi_3921_ = ((2147483648u | (_e1996 << bitcast<u32>(28u))) | (select(_e2016, _e1985, _e2018) & 268435455u));
                                                }
                                                let _e2031 = phi_3921_;
                                                phi_3922_ = _e2031;
                                            }
                                            let _e2033 = phi_3922_;
                                            phi_3926_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e1911, (_e710.member.member.x + _e1863), _e1916, (_e710.member.member_1.x - _e1902)), vec4<f32>(_e1912, (_e710.member.member.y + _e1867), _e1917, (_e710.member.member_1.y - _e1906)), vec4<f32>(_e1913, (_e710.member.member.z + _e1871), _e1918, (_e710.member.member_1.z - _e1910))), type_51(type_24((_e710.member.member + vec4<f32>(_e1841, _e1850, _e1859, 0f)), (_e710.member.member_1 - vec4<f32>(_e1880, _e1889, _e1898, 0f))), _e2008), type_51(type_24((_e710.member.member + vec4<f32>(_e1863, _e1867, _e1871, 0f)), (_e710.member.member_1 - vec4<f32>(_e1902, _e1906, _e1910, 0f))), _e2033));
                                        }
                                        let _e2038 = phi_3926_;
                                        let _e2049 = ((_e2038.member[0].x - _e372) * _e377);
                                        let _e2050 = ((_e2038.member[0].y - _e372) * _e377);
                                        let _e2051 = ((_e2038.member[0].z - _e373) * _e377);
                                        let _e2052 = ((_e2038.member[0].w - _e373) * _e377);
                                        let _e2062 = ((_e2038.member[1].x - _e440) * _e445);
                                        let _e2063 = ((_e2038.member[1].y - _e440) * _e445);
                                        let _e2064 = ((_e2038.member[1].z - _e441) * _e445);
                                        let _e2065 = ((_e2038.member[1].w - _e441) * _e445);
                                        let _e2075 = ((_e2038.member[2].x - _e508) * _e513);
                                        let _e2076 = ((_e2038.member[2].y - _e508) * _e513);
                                        let _e2077 = ((_e2038.member[2].z - _e509) * _e513);
                                        let _e2078 = ((_e2038.member[2].w - _e509) * _e513);
                                        let _e2080 = select(_e2077, _e2075, (_e2075 < _e2077));
                                        let _e2082 = select(_e2078, _e2076, (_e2076 < _e2078));
                                        let _e2084 = select(_e2077, _e2075, (_e2075 > _e2077));
                                        let _e2086 = select(_e2078, _e2076, (_e2076 > _e2078));
                                        let _e2088 = select(_e2051, _e2049, (_e2049 < _e2051));
                                        let _e2090 = select(_e2052, _e2050, (_e2050 < _e2052));
                                        let _e2092 = select(_e2064, _e2062, (_e2062 < _e2064));
                                        let _e2094 = select(_e2065, _e2063, (_e2063 < _e2065));
                                        let _e2096 = select(_e2092, _e2088, (_e2088 > _e2092));
                                        let _e2098 = select(_e2094, _e2090, (_e2090 > _e2094));
                                        let _e2100 = select(_e2080, _e2096, (_e2096 > _e2080));
                                        let _e2102 = select(_e2082, _e2098, (_e2098 > _e2082));
                                        let _e2104 = select(_e2051, _e2049, (_e2049 > _e2051));
                                        let _e2106 = select(_e2052, _e2050, (_e2050 > _e2052));
                                        let _e2108 = select(_e2064, _e2062, (_e2062 > _e2064));
                                        let _e2110 = select(_e2065, _e2063, (_e2063 > _e2065));
                                        let _e2112 = select(_e2108, _e2104, (_e2104 < _e2108));
                                        let _e2114 = select(_e2110, _e2106, (_e2106 < _e2110));
                                        let _e2119 = -(_e2080);
                                        let _e2120 = -(_e2082);
                                        let _e2127 = (select(_e2084, _e2112, (_e2112 < _e2084)) + (select(_e2119, _e2084, (_e2084 > _e2119)) * 0.0000019073523f));
                                        let _e2128 = (select(_e2086, _e2114, (_e2114 < _e2086)) + (select(_e2120, _e2086, (_e2086 > _e2120)) * 0.0000019073523f));
                                        let _e2130 = select(_e625, _e2100, (_e2100 > _e625));
                                        let _e2132 = select(_e625, _e2102, (_e2102 > _e625));
                                        let _e2137 = (_e2130 <= select(_e1724, _e2127, (_e2127 < _e1724)));
                                        let _e2138 = (_e2132 <= select(_e1724, _e2128, (_e2128 < _e1724)));
                                        let _e2139 = (_e2130 <= _e2132);
                                        if _e2137 {
                                            if _e2138 {
                                                if _e2139 {
                                                    phi_4289_ = _e2038.member_2;
                                                } else {
                                                    phi_4289_ = _e2038.member_1;
                                                }
                                                let _e2143 = phi_4289_;
                                                let _e2164 = (_e708 % 128u);
                                                let _e2165 = (_e2164 < 128u);
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_8[_e2164] = _e2143.member_1;
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_7[_e2164] = _e2143.member.member.x;
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_6[_e2164] = _e2143.member.member.y;
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_5[_e2164] = _e2143.member.member.z;
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_4[_e2164] = _e2143.member.member_1.x;
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_3[_e2164] = _e2143.member.member_1.y;
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_2[_e2164] = _e2143.member.member_1.z;
                                                if _e2165 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_10[_e2164] = select(_e2130, _e2132, _e2139);
                                                if _e2139 {
                                                    phi_4365_ = _e2038.member_1;
                                                } else {
                                                    phi_4365_ = _e2038.member_2;
                                                }
                                                let _e2178 = phi_4365_;
                                                phi_4366_ = (_e708 + 1u);
                                                phi_4367_ = _e2178;
                                            } else {
                                                phi_4366_ = u32();
                                                phi_4367_ = type_51();
                                            }
                                            let _e2180 = phi_4366_;
                                            let _e2182 = phi_4367_;
                                            phi_4369_ = _e2180;
                                            phi_4370_ = _e2182;
                                            phi_4371_ = select(true, false, _e2138);
                                        } else {
                                            phi_4369_ = u32();
                                            phi_4370_ = type_51();
                                            phi_4371_ = true;
                                        }
                                        let _e2185 = phi_4369_;
                                        let _e2187 = phi_4370_;
                                        let _e2189 = phi_4371_;
                                        if _e2189 {
                                            if _e2137 {
                                                phi_4380_ = _e2038.member_1;
                                            } else {
                                                phi_4380_ = _e2038.member_2;
                                            }
                                            let _e2193 = phi_4380_;
                                            phi_4385_ = select(_e2138, true, _e2137);
                                            phi_4387_ = _e2193;
                                        } else {
                                            phi_4385_ = _e706;
                                            phi_4387_ = _e2187;
                                        }
                                        let _e2196 = phi_4385_;
                                        let _e2198 = phi_4387_;
                                        phi_4391_ = _e2196;
                                        phi_4392_ = select(_e2185, _e708, _e2189);
                                        phi_4393_ = _e2198;
                                    }
                                    let _e2201 = phi_4391_;
                                    let _e2203 = phi_4392_;
                                    let _e2205 = phi_4393_;
                                    if _e714 {
                                        phi_4403_ = _e710;
                                    } else {
                                        phi_4403_ = _e2205;
                                    }
                                    let _e2207 = phi_4403_;
                                    phi_5426_ = _e1724;
                                    phi_5310_ = _e1722;
                                    phi_4404_ = (_e670 - 1u);
                                    phi_4405_ = select(_e2201, false, _e714);
                                    phi_4406_ = select(_e2203, _e708, _e714);
                                    phi_4407_ = _e2207;
                                } else {
                                    phi_5426_ = _e668;
                                    phi_5310_ = _e666;
                                    phi_4404_ = _e670;
                                    phi_4405_ = _e706;
                                    phi_4406_ = _e708;
                                    phi_4407_ = _e710;
                                }
                                let _e2211 = phi_5426_;
                                let _e2213 = phi_5310_;
                                let _e2215 = phi_4404_;
                                let _e2217 = phi_4405_;
                                let _e2219 = phi_4406_;
                                let _e2221 = phi_4407_;
                                phi_5425_ = _e2211;
                                phi_5309_ = _e2213;
                                phi_4408_ = _e2215;
                                phi_4409_ = _e2217;
                                phi_4410_ = _e2219;
                                phi_4411_ = _e2221;
                            } else {
                                phi_5425_ = _e668;
                                phi_5309_ = _e666;
                                phi_4408_ = u32();
                                phi_4409_ = bool();
                                phi_4410_ = u32();
                                phi_4411_ = type_51();
                            }
                            let _e2223 = phi_5425_;
                            let _e2225 = phi_5309_;
                            let _e2227 = phi_4408_;
                            let _e2229 = phi_4409_;
                            let _e2231 = phi_4410_;
                            let _e2233 = phi_4411_;
                            phi_5424_ = _e2223;
                            phi_5308_ = _e2225;
                            phi_1235_ = _e2227;
                            phi_1238_ = _e2229;
                            phi_1240_ = _e2231;
                            phi_1242_ = _e2233;
                            phi_4412_ = _e680;
                        } else {
                            phi_5424_ = _e668;
                            phi_5308_ = _e666;
                            phi_1235_ = u32();
                            phi_1238_ = bool();
                            phi_1240_ = u32();
                            phi_1242_ = type_51();
                            phi_4412_ = false;
                        }
                        let _e2235 = phi_5424_;
                        let _e2237 = phi_5308_;
                        let _e2239 = phi_1235_;
                        let _e2241 = phi_1238_;
                        let _e2243 = phi_1240_;
                        let _e2245 = phi_1242_;
                        let _e2247 = phi_4412_;
                        continue;
                        continuing {
                            phi_4976_ = _e2237;
                            phi_4890_ = _e2235;
                            phi_1234_ = _e2239;
                            phi_1237_ = _e2241;
                            phi_1239_ = _e2243;
                            phi_1241_ = _e2245;
                            phi_5307_ = _e2237;
                            break if !(_e2247);
                        }
                    }
                    let _e2250 = phi_5307_;
                    if _e2250 {
                        break;
                    }
                    phi_4419_ = type_8(0u, 8u);
                    loop {
                        let _e2252 = phi_4419_;
                        if (_e2252.member < _e2252.member_1) {
                            phi_4420_ = type_8((_e2252.member + 1u), _e2252.member_1);
                            phi_4443_ = type_8(1u, _e2252.member);
                        } else {
                            phi_4420_ = _e2252;
                            phi_4443_ = type_8(0u, type_8().member_1);
                        }
                        let _e2265 = phi_4420_;
                        let _e2267 = phi_4443_;
                        let _e2271 = (bitcast<i32>(_e2267.member) != 0i);
                        if _e2271 {
                            let _e2272 = (_e2267.member_1 < 8u);
                            if _e2272 {
                            } else {
                                phi_5406_ = true;
                                break;
                            }
                            let _e2274 = local_9[_e2267.member_1];
                            if (_e2274.member_3 != 4294967295u) {
                                let _e2280 = -(_e527);
                                let _e2281 = bitcast<u32>(_e2274.member);
                                let _e2285 = (bitcast<i32>((_e2281 >> bitcast<u32>(23i))) & 255i);
                                let _e2286 = (_e2285 + _e2280);
                                if (_e2285 == 255i) {
                                    phi_4516_ = _e2274.member;
                                } else {
                                    if (_e2285 > 0i) {
                                        if (_e2286 > 0i) {
                                            let _e2290 = (_e2286 < 255i);
                                            if _e2290 {
                                                phi_4495_ = bitcast<f32>((_e2281 + bitcast<u32>((_e2280 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4495_ = f32();
                                            }
                                            let _e2297 = phi_4495_;
                                            phi_4497_ = _e2297;
                                            phi_4498_ = select(true, false, _e2290);
                                        } else {
                                            phi_4497_ = f32();
                                            phi_4498_ = true;
                                        }
                                        let _e2300 = phi_4497_;
                                        let _e2302 = phi_4498_;
                                        phi_4499_ = _e2300;
                                        phi_4500_ = _e2302;
                                    } else {
                                        phi_4499_ = f32();
                                        phi_4500_ = true;
                                    }
                                    let _e2304 = phi_4499_;
                                    let _e2306 = phi_4500_;
                                    if _e2306 {
                                        let _e2307 = (_e2281 & 2147483648u);
                                        let _e2314 = ((_e2281 & 8388607u) | (select(0u, 1u, ((_e2281 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2318 = (_e2314 == 0u);
                                        if _e2318 {
                                            phi_4837_ = bitcast<f32>(_e2307);
                                        } else {
                                            let _e2323 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2314)), 32u, _e2318) - 8u);
                                            let _e2326 = (_e2314 << bitcast<u32>((_e2323 & 31u)));
                                            let _e2328 = ((_e2286 + select(0i, 1i, (_e2285 == 0i))) - bitcast<i32>(_e2323));
                                            if (_e2328 >= 255i) {
                                                phi_4827_ = bitcast<f32>((_e2307 | 2139095040u));
                                                phi_4828_ = f32();
                                                phi_4829_ = true;
                                            } else {
                                                let _e2330 = (_e2328 > 0i);
                                                if _e2330 {
                                                    phi_4821_ = bitcast<f32>(((_e2307 | (bitcast<u32>(_e2328) << bitcast<u32>(23i))) | (_e2326 & 8388607u)));
                                                    phi_4822_ = f32();
                                                } else {
                                                    if (_e2328 < -24i) {
                                                        phi_4787_ = 26u;
                                                    } else {
                                                        phi_4787_ = bitcast<u32>((1i - _e2328));
                                                    }
                                                    let _e2335 = phi_4787_;
                                                    let _e2336 = (_e2335 & 31u);
                                                    let _e2338 = (_e2326 >> bitcast<u32>(_e2336));
                                                    let _e2342 = (_e2326 & ((1u << bitcast<u32>(_e2336)) - 1u));
                                                    let _e2346 = (1u << bitcast<u32>(((_e2335 - 1u) & 31u)));
                                                    if (_e2342 > _e2346) {
                                                        phi_4808_ = true;
                                                    } else {
                                                        if (_e2342 == _e2346) {
                                                            phi_4805_ = ((_e2338 & 1u) == 1u);
                                                        } else {
                                                            phi_4805_ = false;
                                                        }
                                                        let _e2352 = phi_4805_;
                                                        phi_4808_ = _e2352;
                                                    }
                                                    let _e2354 = phi_4808_;
                                                    phi_4821_ = f32();
                                                    phi_4822_ = bitcast<f32>((_e2307 | (_e2338 + select(0u, 1u, _e2354))));
                                                }
                                                let _e2367 = phi_4821_;
                                                let _e2369 = phi_4822_;
                                                phi_4827_ = _e2367;
                                                phi_4828_ = _e2369;
                                                phi_4829_ = _e2330;
                                            }
                                            let _e2373 = phi_4827_;
                                            let _e2375 = phi_4828_;
                                            let _e2377 = phi_4829_;
                                            phi_4837_ = select(_e2375, _e2373, _e2377);
                                        }
                                        let _e2381 = phi_4837_;
                                        phi_4515_ = _e2381;
                                    } else {
                                        phi_4515_ = _e2304;
                                    }
                                    let _e2383 = phi_4515_;
                                    phi_4516_ = _e2383;
                                }
                                let _e2385 = phi_4516_;
                                let _e2386 = bitcast<u32>(_e2385);
                                if ((_e2386 & 2147483647u) >= 2139095040u) {
                                    phi_4528_ = bitcast<f32>(((_e2386 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4528_ = _e2385;
                                }
                                let _e2393 = phi_4528_;
                                phi_4533_ = type_20(_e2393, _e2274.member_1, _e2274.member_2, _e2274.member_3);
                            } else {
                                phi_4533_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2396 = phi_4533_;
                            if _e2272 {
                            } else {
                                phi_5406_ = true;
                                break;
                            }
                            local_9[_e2267.member_1] = type_20(_e2396.member, _e2396.member_1, _e2396.member_2, _e2396.member_3);
                        }
                        continue;
                        continuing {
                            phi_4419_ = _e2265;
                            phi_5406_ = _e2250;
                            break if !(_e2271);
                        }
                    }
                    let _e2404 = phi_5406_;
                    if _e2404 {
                        break;
                    }
                    let _e2405 = local_9;
                    if _e158 {
                    } else {
                        break;
                    }
                    global_6.member[_e156] = array<type_20, 8>(type_20(_e2405[0].member, _e2405[0].member_1, _e2405[0].member_2, _e2405[0].member_3), type_20(_e2405[1].member, _e2405[1].member_1, _e2405[1].member_2, _e2405[1].member_3), type_20(_e2405[2].member, _e2405[2].member_1, _e2405[2].member_2, _e2405[2].member_3), type_20(_e2405[3].member, _e2405[3].member_1, _e2405[3].member_2, _e2405[3].member_3), type_20(_e2405[4].member, _e2405[4].member_1, _e2405[4].member_2, _e2405[4].member_3), type_20(_e2405[5].member, _e2405[5].member_1, _e2405[5].member_2, _e2405[5].member_3), type_20(_e2405[6].member, _e2405[6].member_1, _e2405[6].member_2, _e2405[6].member_3), type_20(_e2405[7].member, _e2405[7].member_1, _e2405[7].member_2, _e2405[7].member_3));
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
