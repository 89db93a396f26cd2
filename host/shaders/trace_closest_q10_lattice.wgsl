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

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: type_24,
    member_1: f32,
}

struct type_41 {
    member: array<type_28>,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_32,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_44;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_26;

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
    var phi_484_: i32;
    var phi_485_: i32;
    var phi_495_: bool;
    var phi_505_: u32;
    var phi_506_: u32;
    var phi_508_: bool;
    var phi_513_: u32;
    var phi_526_: i32;
    var phi_546_: i32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_610_: f32;
    var phi_616_: f32;
    var phi_668_: f32;
    var phi_680_: f32;
    var phi_689_: f32;
    var phi_695_: f32;
    var phi_735_: f32;
    var phi_741_: f32;
    var phi_793_: f32;
    var phi_805_: f32;
    var phi_814_: f32;
    var phi_820_: f32;
    var phi_860_: f32;
    var phi_866_: f32;
    var phi_918_: f32;
    var phi_930_: f32;
    var phi_985_: i32;
    var phi_1007_: u32;
    var phi_1008_: u32;
    var phi_1045_: i32;
    var phi_1067_: u32;
    var phi_1068_: u32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_4648_: bool;
    var phi_1173_: type_37;
    var phi_1176_: u32;
    var phi_1178_: bool;
    var phi_1180_: u32;
    var phi_1182_: type_49;
    var phi_1193_: bool;
    var phi_1279_: bool;
    var phi_1280_: u32;
    var phi_1281_: type_49;
    var phi_1300_: type_37;
    var phi_1303_: type_8;
    var phi_1304_: type_8;
    var phi_1326_: type_8;
    var phi_1367_: u32;
    var phi_1373_: u32;
    var phi_1383_: u32;
    var phi_1399_: u32;
    var phi_1432_: u32;
    var phi_1438_: u32;
    var phi_1904_: u32;
    var phi_1922_: u32;
    var phi_1940_: u32;
    var phi_1963_: u32;
    var phi_1981_: u32;
    var phi_1999_: u32;
    var phi_2022_: u32;
    var phi_2040_: u32;
    var phi_2058_: u32;
    var phi_1612_: u32;
    var phi_1627_: u32;
    var phi_1637_: u32;
    var phi_1658_: u32;
    var phi_1679_: u32;
    var phi_1709_: u32;
    var phi_1724_: u32;
    var phi_1734_: u32;
    var phi_1755_: u32;
    var phi_1776_: u32;
    var phi_1806_: u32;
    var phi_1821_: u32;
    var phi_1831_: u32;
    var phi_1852_: u32;
    var phi_1873_: u32;
    var phi_1465_: u32;
    var phi_1514_: u32;
    var phi_1563_: u32;
    var phi_2064_: array<array<f32, 3>, 3>;
    var phi_2216_: bool;
    var phi_2245_: bool;
    var phi_2664_: f32;
    var phi_2665_: f32;
    var phi_2666_: f32;
    var phi_2667_: f32;
    var phi_2668_: vec3<f32>;
    var phi_2669_: vec3<f32>;
    var phi_2670_: vec3<f32>;
    var phi_2671_: vec3<f32>;
    var phi_2708_: bool;
    var phi_2717_: vec3<f32>;
    var phi_2882_: f32;
    var phi_2884_: f32;
    var phi_2885_: bool;
    var phi_2905_: f32;
    var phi_2906_: f32;
    var phi_2929_: type_24;
    var phi_2931_: type_24;
    var phi_2932_: bool;
    var phi_2936_: type_24;
    var phi_2937_: type_24;
    var phi_2938_: type_24;
    var phi_2939_: bool;
    var phi_2943_: type_24;
    var phi_2944_: bool;
    var phi_2945_: type_24;
    var phi_2946_: bool;
    var phi_2947_: bool;
    var phi_2948_: type_24;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2958_: type_24;
    var phi_2959_: bool;
    var phi_2963_: type_24;
    var phi_2988_: bool;
    var phi_2989_: bool;
    var phi_2995_: type_37;
    var phi_2996_: type_37;
    var phi_2997_: type_37;
    var phi_1301_: type_37;
    var phi_4642_: bool;
    var phi_4940_: bool;
    var phi_2998_: type_37;
    var phi_3500_: u32;
    var phi_3506_: u32;
    var phi_3760_: u32;
    var phi_3761_: u32;
    var phi_3771_: u32;
    var phi_3773_: u32;
    var phi_3774_: bool;
    var phi_3794_: u32;
    var phi_3795_: u32;
    var phi_3799_: type_50;
    var phi_4161_: type_49;
    var phi_4237_: type_49;
    var phi_4238_: u32;
    var phi_4239_: type_49;
    var phi_4241_: u32;
    var phi_4242_: type_49;
    var phi_4243_: bool;
    var phi_4252_: type_49;
    var phi_4257_: bool;
    var phi_4259_: type_49;
    var phi_4263_: bool;
    var phi_4264_: u32;
    var phi_4265_: type_49;
    var phi_4275_: type_49;
    var phi_4852_: bool;
    var phi_4276_: type_37;
    var phi_4277_: u32;
    var phi_4278_: bool;
    var phi_4279_: u32;
    var phi_4280_: type_49;
    var phi_4851_: bool;
    var phi_4281_: type_37;
    var phi_4282_: u32;
    var phi_4283_: bool;
    var phi_4284_: u32;
    var phi_4285_: type_49;
    var phi_4850_: bool;
    var phi_1174_: type_37;
    var phi_1177_: u32;
    var phi_1179_: bool;
    var phi_1181_: u32;
    var phi_1183_: type_49;
    var phi_4286_: bool;
    var phi_4849_: bool;
    var local_10: type_37;
    var phi_4324_: f32;
    var phi_4326_: f32;
    var phi_4327_: bool;
    var phi_4328_: f32;
    var phi_4329_: bool;
    var phi_4550_: u32;
    var phi_4568_: bool;
    var phi_4571_: bool;
    var phi_4584_: f32;
    var phi_4585_: f32;
    var phi_4590_: f32;
    var phi_4591_: f32;
    var phi_4592_: bool;
    var phi_4600_: f32;
    var phi_4344_: f32;
    var phi_4345_: f32;
    var phi_4357_: f32;
    var phi_4362_: type_24;
    var local_11: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_3.member));
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
            let _e157 = (_e156 < arrayLength((&global_4.member)));
            if _e157 {
                let _e158 = (_e156 < arrayLength((&global_6.member)));
                if _e158 {
                    if _e157 {
                    } else {
                        break;
                    }
                    let _e166 = global_4.member[_e156].member_2[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e156].member_2[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e156].member_2[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_4.member[_e156].member[0u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_4.member[_e156].member[1u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e201 = global_4.member[_e156].member[2u];
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e205 = select(_e175, _e168, (_e175 < _e168));
                    let _e207 = select(_e182, _e205, (_e182 < _e205));
                    let _e209 = select(_e189, _e207, (_e189 < _e207));
                    let _e211 = select(_e196, _e209, (_e196 < _e209));
                    let _e213 = select(_e203, _e211, (_e203 < _e211));
                    let _e217 = global_4.member[_e156].member_1;
                    let _e218 = bitcast<u32>(_e217);
                    let _e219 = (_e218 & 2147483647u);
                    let _e226 = global_4.member[_e156].member_3;
                    let _e227 = bitcast<u32>(_e226);
                    let _e228 = (_e227 & 2147483647u);
                    let _e232 = (((select(_e219, _e213, (_e219 < _e213)) < 2139095040u) && (_e228 <= 2139095040u)) && (_e207 > 0u));
                    if _e232 {
                        let _e235 = (bitcast<u32>(bitcast<f32>(_e207)) & 2147483647u);
                        if (_e235 >= 8388608u) {
                            phi_484_ = (bitcast<i32>((_e235 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_484_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e235)), 32u, (_e235 == 0u))));
                        }
                        let _e249 = phi_484_;
                        phi_485_ = _e249;
                    } else {
                        phi_485_ = 0i;
                    }
                    let _e251 = phi_485_;
                    let _e252 = (_e168 == _e207);
                    if _e252 {
                        phi_495_ = true;
                    } else {
                        phi_495_ = (_e175 == _e207);
                    }
                    let _e255 = phi_495_;
                    let _e256 = select(1u, 0u, _e252);
                    if _e255 {
                        let _e257 = (_e256 + 1u);
                        phi_505_ = _e257;
                        phi_506_ = _e257;
                        phi_508_ = select(true, false, (_e257 == 2u));
                    } else {
                        phi_505_ = u32();
                        phi_506_ = 0u;
                        phi_508_ = true;
                    }
                    let _e261 = phi_505_;
                    let _e263 = phi_506_;
                    let _e265 = phi_508_;
                    if _e265 {
                        phi_513_ = (_e263 + 1u);
                    } else {
                        phi_513_ = 0u;
                    }
                    let _e269 = phi_513_;
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
                    let _e308 = global_4.member[_e156].member;
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
                    let _e335 = global_4.member[_e156].member_2;
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
                        phi_680_ = 38685626000000000000000000f;
                    } else {
                        phi_680_ = (1f / _e359);
                    }
                    let _e377 = phi_680_;
                    let _e378 = (_e269 == 0u);
                    if _e378 {
                        phi_689_ = _e308[0];
                    } else {
                        phi_689_ = _e308[1];
                    }
                    let _e382 = phi_689_;
                    let _e383 = (_e269 == 2u);
                    if _e383 {
                        phi_695_ = _e308[2];
                    } else {
                        phi_695_ = _e382;
                    }
                    let _e386 = phi_695_;
                    let _e387 = bitcast<u32>(_e386);
                    let _e389 = ((_e387 & 2139095040u) != 0u);
                    let _e403 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * _e281) * select(0.00000011920929f, 1f, _e389)) * _e287);
                    if _e378 {
                        phi_735_ = _e335[0];
                    } else {
                        phi_735_ = _e335[1];
                    }
                    let _e407 = phi_735_;
                    if _e383 {
                        phi_741_ = _e335[2];
                    } else {
                        phi_741_ = _e407;
                    }
                    let _e410 = phi_741_;
                    let _e411 = bitcast<u32>(_e410);
                    let _e413 = ((_e411 & 2139095040u) != 0u);
                    let _e427 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e411 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e411 & 2147483648u))), _e410, _e413) * _e298) * select(0.00000011920929f, 1f, _e413)) * _e304);
                    let _e431 = (bitcast<f32>((bitcast<u32>(_e427) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e431 {
                        let _e435 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) * 0.00000011920929f);
                        phi_793_ = select(0.00000000000011368684f, _e435, (_e435 > 0.00000000000011368684f));
                    } else {
                        phi_793_ = 0f;
                    }
                    let _e439 = phi_793_;
                    let _e440 = (_e403 + _e439);
                    let _e441 = (_e403 - _e439);
                    let _e442 = select(_e427, 0f, _e431);
                    if _e431 {
                        phi_805_ = 38685626000000000000000000f;
                    } else {
                        phi_805_ = (1f / _e427);
                    }
                    let _e445 = phi_805_;
                    let _e446 = (_e271 == 0u);
                    if _e446 {
                        phi_814_ = _e308[0];
                    } else {
                        phi_814_ = _e308[1];
                    }
                    let _e450 = phi_814_;
                    let _e451 = (_e271 == 2u);
                    if _e451 {
                        phi_820_ = _e308[2];
                    } else {
                        phi_820_ = _e450;
                    }
                    let _e454 = phi_820_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e281) * select(0.00000011920929f, 1f, _e457)) * _e287);
                    if _e446 {
                        phi_860_ = _e335[0];
                    } else {
                        phi_860_ = _e335[1];
                    }
                    let _e475 = phi_860_;
                    if _e451 {
                        phi_866_ = _e335[2];
                    } else {
                        phi_866_ = _e475;
                    }
                    let _e478 = phi_866_;
                    let _e479 = bitcast<u32>(_e478);
                    let _e481 = ((_e479 & 2139095040u) != 0u);
                    let _e495 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e479 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e479 & 2147483648u))), _e478, _e481) * _e298) * select(0.00000011920929f, 1f, _e481)) * _e304);
                    let _e499 = (bitcast<f32>((bitcast<u32>(_e495) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e499 {
                        let _e503 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                        phi_918_ = select(0.00000000000011368684f, _e503, (_e503 > 0.00000000000011368684f));
                    } else {
                        phi_918_ = 0f;
                    }
                    let _e507 = phi_918_;
                    let _e508 = (_e471 + _e507);
                    let _e509 = (_e471 - _e507);
                    let _e510 = select(_e495, 0f, _e499);
                    if _e499 {
                        phi_930_ = 38685626000000000000000000f;
                    } else {
                        phi_930_ = (1f / _e495);
                    }
                    let _e513 = phi_930_;
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
                            phi_985_ = 255i;
                        } else {
                            phi_985_ = (((_e540 + select(0i, 1i, (_e540 == 0i))) - _e547) + _e527);
                        }
                        let _e555 = phi_985_;
                        let _e565 = (_e555 <= 0i);
                        if _e565 {
                            phi_1008_ = u32();
                        } else {
                            if _e544 {
                                phi_1007_ = u32();
                            } else {
                                phi_1007_ = select(((bitcast<u32>(_e555) << bitcast<u32>(23i)) | ((_e537 << bitcast<u32>(((_e547 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e555 >= 255i));
                            }
                            let _e569 = phi_1007_;
                            phi_1008_ = _e569;
                        }
                        let _e571 = phi_1008_;
                        let _e583 = ((_e228 & 8388607u) | (select(0u, 1u, ((_e228 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e586 = bitcast<i32>((_e228 >> bitcast<u32>(23i)));
                        let _e590 = (_e583 == 0u);
                        let _e593 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e583)), 32u, _e590)) - 8i);
                        if (_e586 == 255i) {
                            phi_1045_ = 255i;
                        } else {
                            phi_1045_ = (((_e586 + select(0i, 1i, (_e586 == 0i))) - _e593) + _e527);
                        }
                        let _e601 = phi_1045_;
                        let _e611 = (_e601 <= 0i);
                        if _e611 {
                            phi_1068_ = u32();
                        } else {
                            if _e590 {
                                phi_1067_ = u32();
                            } else {
                                phi_1067_ = select(((bitcast<u32>(_e601) << bitcast<u32>(23i)) | ((_e583 << bitcast<u32>(((_e593 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e601 >= 255i));
                            }
                            let _e615 = phi_1067_;
                            phi_1068_ = _e615;
                        }
                        let _e617 = phi_1068_;
                        phi_1076_ = bitcast<f32>(((_e227 & 2147483648u) | select(_e617, 0u, select(_e590, true, _e611))));
                        phi_1077_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e571, 0u, select(_e544, true, _e565))));
                    } else {
                        phi_1076_ = 0f;
                        phi_1077_ = 1f;
                    }
                    let _e623 = phi_1076_;
                    let _e625 = phi_1077_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e629 = (_e270 % 3u);
                    let _e630 = (_e629 < 3u);
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e632 = local_1[_e629];
                    let _e635 = (_e269 % 3u);
                    let _e636 = (_e635 < 3u);
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e638 = local_1[_e635];
                    let _e641 = (_e271 % 3u);
                    let _e642 = (_e641 < 3u);
                    if _e642 {
                    } else {
                        break;
                    }
                    let _e644 = local_1[_e641];
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e649 = local[_e629];
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e653 = local[_e635];
                    if _e642 {
                    } else {
                        break;
                    }
                    let _e657 = local[_e641];
                    phi_4648_ = false;
                    phi_1173_ = type_37(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e623);
                    phi_1176_ = ((3u * _e99) + 1u);
                    phi_1178_ = (_e625 <= _e623);
                    phi_1180_ = 0u;
                    phi_1182_ = type_49(type_32(vec4<f32>((f32(_e632) * _e150), (f32(_e638) * _e150), (f32(_e644) * _e150), 0f), vec4<f32>((f32(_e649) * _e150), (f32(_e653) * _e150), (f32(_e657) * _e150), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    loop {
                        let _e667 = phi_4648_;
                        let _e669 = phi_1173_;
                        let _e671 = phi_1176_;
                        let _e673 = phi_1178_;
                        let _e675 = phi_1180_;
                        let _e677 = phi_1182_;
                        local_10 = _e669;
                        if _e673 {
                            phi_1193_ = true;
                        } else {
                            phi_1193_ = (_e675 > 0u);
                        }
                        let _e680 = phi_1193_;
                        if _e680 {
                            let _e681 = (_e671 > 0u);
                            if _e681 {
                                if _e673 {
                                    phi_1279_ = _e673;
                                    phi_1280_ = _e675;
                                    phi_1281_ = _e677;
                                } else {
                                    let _e682 = (_e675 - 1u);
                                    let _e683 = (_e682 % 128u);
                                    let _e684 = (_e683 < 128u);
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e686 = local_7[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e688 = local_6[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e690 = local_5[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e692 = local_4[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e694 = local_3[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e696 = local_2[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e701 = local_8[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e704 = local_9[_e683];
                                    phi_1279_ = (_e704 <= _e669.member_1);
                                    phi_1280_ = _e682;
                                    phi_1281_ = type_49(type_32(vec4<f32>(_e686, _e688, _e690, 0f), vec4<f32>(_e692, _e694, _e696, 0f)), _e701);
                                }
                                let _e708 = phi_1279_;
                                let _e710 = phi_1280_;
                                let _e712 = phi_1281_;
                                if _e708 {
                                    let _e716 = ((_e712.member_1 & 2147483648u) != 0u);
                                    let _e717 = (_e712.member_1 & 268435455u);
                                    if _e716 {
                                        phi_1300_ = _e669;
                                        phi_1303_ = type_8(0u, ((_e712.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e724 = phi_1300_;
                                            let _e726 = phi_1303_;
                                            local_11 = _e724;
                                            if (_e726.member < _e726.member_1) {
                                                phi_1304_ = type_8((_e726.member + 1u), _e726.member_1);
                                                phi_1326_ = type_8(1u, _e726.member);
                                            } else {
                                                phi_1304_ = _e726;
                                                phi_1326_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e739 = phi_1304_;
                                            let _e741 = phi_1326_;
                                            let _e745 = (bitcast<i32>(_e741.member) != 0i);
                                            if _e745 {
                                                let _e750 = (_e712.member.member_1.x - _e712.member.member.x);
                                                let _e753 = (_e712.member.member_1.y - _e712.member.member.y);
                                                let _e756 = (_e712.member.member_1.z - _e712.member.member.z);
                                                let _e758 = select(_e753, _e750, (_e750 > _e753));
                                                let _e760 = select(_e756, _e758, (_e758 > _e756));
                                                let _e762 = (_e760 < (1024f * _e150));
                                                if _e762 {
                                                    phi_1367_ = 0u;
                                                } else {
                                                    phi_1367_ = select(2u, 1u, (_e760 < (2097152f * _e150)));
                                                }
                                                let _e767 = phi_1367_;
                                                switch bitcast<i32>(_e767) {
                                                    case 0: {
                                                        phi_1373_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1373_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1373_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1373_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e770 = phi_1373_;
                                                switch bitcast<i32>(_e767) {
                                                    case 0: {
                                                        phi_1383_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1383_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1383_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1383_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e777 = phi_1383_;
                                                let _e779 = ((_e717 + (_e741.member_1 * ((3u * _e770) + 1u))) + (3u * _e777));
                                                let _e780 = (_e779 < _e102);
                                                if _e780 {
                                                    if _e780 {
                                                    } else {
                                                        phi_4642_ = true;
                                                        break;
                                                    }
                                                    let _e782 = global_5.member[_e779];
                                                    phi_1399_ = _e782;
                                                } else {
                                                    phi_1399_ = 4294967295u;
                                                }
                                                let _e784 = phi_1399_;
                                                if _e762 {
                                                    phi_1432_ = 0u;
                                                } else {
                                                    phi_1432_ = select(2u, 1u, (_e760 < (2097152f * _e150)));
                                                }
                                                let _e789 = phi_1432_;
                                                switch bitcast<i32>(_e789) {
                                                    case 0: {
                                                        phi_1438_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1438_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1438_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1438_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e792 = phi_1438_;
                                                let _e796 = (_e717 + (_e741.member_1 * ((3u * _e792) + 1u)));
                                                switch bitcast<i32>(_e789) {
                                                    case 0: {
                                                        let _e1071 = (_e796 < _e102);
                                                        if _e1071 {
                                                            if _e1071 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1073 = global_5.member[_e796];
                                                            phi_1465_ = _e1073;
                                                        } else {
                                                            phi_1465_ = 0u;
                                                        }
                                                        let _e1075 = phi_1465_;
                                                        let _e1077 = ((10u * _e270) & 31u);
                                                        let _e1087 = ((10u * _e269) & 31u);
                                                        let _e1097 = ((10u * _e271) & 31u);
                                                        let _e1107 = (_e796 + 1u);
                                                        let _e1108 = (_e1107 < _e102);
                                                        if _e1108 {
                                                            if _e1108 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1110 = global_5.member[_e1107];
                                                            phi_1514_ = _e1110;
                                                        } else {
                                                            phi_1514_ = 0u;
                                                        }
                                                        let _e1112 = phi_1514_;
                                                        let _e1138 = (_e796 + 2u);
                                                        let _e1139 = (_e1138 < _e102);
                                                        if _e1139 {
                                                            if _e1139 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1141 = global_5.member[_e1138];
                                                            phi_1563_ = _e1141;
                                                        } else {
                                                            phi_1563_ = 0u;
                                                        }
                                                        let _e1143 = phi_1563_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | ((_e1075 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | ((_e1075 >> bitcast<u32>(_e1087)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | ((_e1075 >> bitcast<u32>(_e1097)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | ((_e1112 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | ((_e1112 >> bitcast<u32>(_e1087)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | ((_e1112 >> bitcast<u32>(_e1097)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | ((_e1143 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | ((_e1143 >> bitcast<u32>(_e1087)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | ((_e1143 >> bitcast<u32>(_e1097)) & 1023u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e885 = (_e796 < _e102);
                                                        if _e885 {
                                                            if _e885 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e887 = global_5.member[_e796];
                                                            phi_1612_ = _e887;
                                                        } else {
                                                            phi_1612_ = 0u;
                                                        }
                                                        let _e889 = phi_1612_;
                                                        let _e890 = (_e796 + 1u);
                                                        let _e891 = (_e890 < _e102);
                                                        if _e891 {
                                                            if _e891 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e893 = global_5.member[_e890];
                                                            phi_1627_ = _e893;
                                                        } else {
                                                            phi_1627_ = 0u;
                                                        }
                                                        let _e895 = phi_1627_;
                                                        let _e896 = (_e270 == 1u);
                                                        if _e896 {
                                                            phi_1637_ = ((_e889 >> bitcast<u32>(21i)) | (_e895 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1637_ = (_e895 >> bitcast<u32>(10i));
                                                        }
                                                        let _e905 = phi_1637_;
                                                        let _e913 = (_e269 == 1u);
                                                        if _e913 {
                                                            phi_1658_ = ((_e889 >> bitcast<u32>(21i)) | (_e895 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e895 >> bitcast<u32>(10i));
                                                        }
                                                        let _e922 = phi_1658_;
                                                        let _e930 = (_e271 == 1u);
                                                        if _e930 {
                                                            phi_1679_ = ((_e889 >> bitcast<u32>(21i)) | (_e895 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e895 >> bitcast<u32>(10i));
                                                        }
                                                        let _e939 = phi_1679_;
                                                        let _e948 = (_e796 + 2u);
                                                        let _e949 = (_e948 < _e102);
                                                        if _e949 {
                                                            if _e949 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e951 = global_5.member[_e948];
                                                            phi_1709_ = _e951;
                                                        } else {
                                                            phi_1709_ = 0u;
                                                        }
                                                        let _e953 = phi_1709_;
                                                        let _e954 = (_e796 + 3u);
                                                        let _e955 = (_e954 < _e102);
                                                        if _e955 {
                                                            if _e955 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e957 = global_5.member[_e954];
                                                            phi_1724_ = _e957;
                                                        } else {
                                                            phi_1724_ = 0u;
                                                        }
                                                        let _e959 = phi_1724_;
                                                        if _e896 {
                                                            phi_1734_ = ((_e953 >> bitcast<u32>(21i)) | (_e959 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1734_ = (_e959 >> bitcast<u32>(10i));
                                                        }
                                                        let _e968 = phi_1734_;
                                                        if _e913 {
                                                            phi_1755_ = ((_e953 >> bitcast<u32>(21i)) | (_e959 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e959 >> bitcast<u32>(10i));
                                                        }
                                                        let _e984 = phi_1755_;
                                                        if _e930 {
                                                            phi_1776_ = ((_e953 >> bitcast<u32>(21i)) | (_e959 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e959 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1000 = phi_1776_;
                                                        let _e1009 = (_e796 + 4u);
                                                        let _e1010 = (_e1009 < _e102);
                                                        if _e1010 {
                                                            if _e1010 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1012 = global_5.member[_e1009];
                                                            phi_1806_ = _e1012;
                                                        } else {
                                                            phi_1806_ = 0u;
                                                        }
                                                        let _e1014 = phi_1806_;
                                                        let _e1015 = (_e796 + 5u);
                                                        let _e1016 = (_e1015 < _e102);
                                                        if _e1016 {
                                                            if _e1016 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1018 = global_5.member[_e1015];
                                                            phi_1821_ = _e1018;
                                                        } else {
                                                            phi_1821_ = 0u;
                                                        }
                                                        let _e1020 = phi_1821_;
                                                        if _e896 {
                                                            phi_1831_ = ((_e1014 >> bitcast<u32>(21i)) | (_e1020 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1831_ = (_e1020 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1029 = phi_1831_;
                                                        if _e913 {
                                                            phi_1852_ = ((_e1014 >> bitcast<u32>(21i)) | (_e1020 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1852_ = (_e1020 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1045 = phi_1852_;
                                                        if _e930 {
                                                            phi_1873_ = ((_e1014 >> bitcast<u32>(21i)) | (_e1020 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1873_ = (_e1020 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1061 = phi_1873_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | (select(_e905, _e889, _e309) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | (select(_e922, _e889, _e378) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | (select(_e939, _e889, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | (select(_e968, _e953, _e309) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | (select(_e984, _e953, _e378) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1000, _e953, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1029, _e1014, _e309) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1045, _e1014, _e378) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1061, _e1014, _e446) & 2097151u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e798 = (_e796 + _e270);
                                                        let _e799 = (_e798 < _e102);
                                                        if _e799 {
                                                            if _e799 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e801 = global_5.member[_e798];
                                                            phi_1904_ = _e801;
                                                        } else {
                                                            phi_1904_ = 0u;
                                                        }
                                                        let _e803 = phi_1904_;
                                                        let _e807 = (_e796 + _e269);
                                                        let _e808 = (_e807 < _e102);
                                                        if _e808 {
                                                            if _e808 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e810 = global_5.member[_e807];
                                                            phi_1922_ = _e810;
                                                        } else {
                                                            phi_1922_ = 0u;
                                                        }
                                                        let _e812 = phi_1922_;
                                                        let _e816 = (_e796 + _e271);
                                                        let _e817 = (_e816 < _e102);
                                                        if _e817 {
                                                            if _e817 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e819 = global_5.member[_e816];
                                                            phi_1940_ = _e819;
                                                        } else {
                                                            phi_1940_ = 0u;
                                                        }
                                                        let _e821 = phi_1940_;
                                                        let _e826 = (_e796 + 3u);
                                                        let _e827 = (_e826 + _e270);
                                                        let _e828 = (_e827 < _e102);
                                                        if _e828 {
                                                            if _e828 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e830 = global_5.member[_e827];
                                                            phi_1963_ = _e830;
                                                        } else {
                                                            phi_1963_ = 0u;
                                                        }
                                                        let _e832 = phi_1963_;
                                                        let _e836 = (_e826 + _e269);
                                                        let _e837 = (_e836 < _e102);
                                                        if _e837 {
                                                            if _e837 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e839 = global_5.member[_e836];
                                                            phi_1981_ = _e839;
                                                        } else {
                                                            phi_1981_ = 0u;
                                                        }
                                                        let _e841 = phi_1981_;
                                                        let _e845 = (_e826 + _e271);
                                                        let _e846 = (_e845 < _e102);
                                                        if _e846 {
                                                            if _e846 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e848 = global_5.member[_e845];
                                                            phi_1999_ = _e848;
                                                        } else {
                                                            phi_1999_ = 0u;
                                                        }
                                                        let _e850 = phi_1999_;
                                                        let _e855 = (_e796 + 6u);
                                                        let _e856 = (_e855 + _e270);
                                                        let _e857 = (_e856 < _e102);
                                                        if _e857 {
                                                            if _e857 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e859 = global_5.member[_e856];
                                                            phi_2022_ = _e859;
                                                        } else {
                                                            phi_2022_ = 0u;
                                                        }
                                                        let _e861 = phi_2022_;
                                                        let _e865 = (_e855 + _e269);
                                                        let _e866 = (_e865 < _e102);
                                                        if _e866 {
                                                            if _e866 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e868 = global_5.member[_e865];
                                                            phi_2040_ = _e868;
                                                        } else {
                                                            phi_2040_ = 0u;
                                                        }
                                                        let _e870 = phi_2040_;
                                                        let _e874 = (_e855 + _e271);
                                                        let _e875 = (_e874 < _e102);
                                                        if _e875 {
                                                            if _e875 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e877 = global_5.member[_e874];
                                                            phi_2058_ = _e877;
                                                        } else {
                                                            phi_2058_ = 0u;
                                                        }
                                                        let _e879 = phi_2058_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e803)) * _e150), (f32(bitcast<i32>(_e812)) * _e150), (f32(bitcast<i32>(_e821)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e832)) * _e150), (f32(bitcast<i32>(_e841)) * _e150), (f32(bitcast<i32>(_e850)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e861)) * _e150), (f32(bitcast<i32>(_e870)) * _e150), (f32(bitcast<i32>(_e879)) * _e150)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2064_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1171 = phi_2064_;
                                                let _e1179 = (_e1171[0][2] - _e471);
                                                let _e1182 = (((_e1171[0][0] - _e334) * _e510) - (_e1179 * _e374));
                                                let _e1185 = (((_e1171[0][1] - _e403) * _e510) - (_e1179 * _e442));
                                                let _e1192 = (_e1171[1][2] - _e471);
                                                let _e1195 = (((_e1171[1][0] - _e334) * _e510) - (_e1192 * _e374));
                                                let _e1198 = (((_e1171[1][1] - _e403) * _e510) - (_e1192 * _e442));
                                                let _e1205 = (_e1171[2][2] - _e471);
                                                let _e1208 = (((_e1171[2][0] - _e334) * _e510) - (_e1205 * _e374));
                                                let _e1211 = (((_e1171[2][1] - _e403) * _e510) - (_e1205 * _e442));
                                                let _e1212 = (_e1208 * _e1198);
                                                let _e1213 = (_e1211 * _e1195);
                                                let _e1214 = (_e1182 * _e1211);
                                                let _e1215 = (_e1185 * _e1208);
                                                let _e1216 = (_e1195 * _e1185);
                                                let _e1217 = (_e1198 * _e1182);
                                                let _e1222 = (((_e1212 >= _e1213) && (_e1214 >= _e1215)) && (_e1216 >= _e1217));
                                                if (_e1222 || (((_e1212 <= _e1213) && (_e1214 <= _e1215)) && (_e1216 <= _e1217))) {
                                                    let _e1229 = select(-1f, 1f, _e1222);
                                                    let _e1231 = ((_e1212 - _e1213) * _e1229);
                                                    let _e1233 = select(0f, _e1231, (_e1231 > 0f));
                                                    let _e1235 = ((_e1214 - _e1215) * _e1229);
                                                    let _e1237 = select(0f, _e1235, (_e1235 > 0f));
                                                    let _e1239 = ((_e1216 - _e1217) * _e1229);
                                                    let _e1241 = select(0f, _e1239, (_e1239 > 0f));
                                                    let _e1243 = ((_e1233 + _e1237) + _e1241);
                                                    if (_e1243 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2948_ = type_24();
                                                        phi_2949_ = true;
                                                        phi_2950_ = false;
                                                    } else {
                                                        let _e1246 = select(_e1195, _e1182, (_e1182 < _e1195));
                                                        if (select(_e1208, _e1246, (_e1246 < _e1208)) > 0f) {
                                                            phi_2216_ = true;
                                                        } else {
                                                            let _e1251 = select(_e1195, _e1182, (_e1182 > _e1195));
                                                            phi_2216_ = (select(_e1208, _e1251, (_e1251 > _e1208)) < 0f);
                                                        }
                                                        let _e1256 = phi_2216_;
                                                        if _e1256 {
                                                            phi_2945_ = type_24();
                                                            phi_2946_ = true;
                                                            phi_2947_ = false;
                                                        } else {
                                                            let _e1258 = select(_e1198, _e1185, (_e1185 < _e1198));
                                                            if (select(_e1211, _e1258, (_e1258 < _e1211)) > 0f) {
                                                                phi_2245_ = true;
                                                            } else {
                                                                let _e1263 = select(_e1198, _e1185, (_e1185 > _e1198));
                                                                phi_2245_ = (select(_e1211, _e1263, (_e1263 > _e1211)) < 0f);
                                                            }
                                                            let _e1268 = phi_2245_;
                                                            if _e1268 {
                                                                phi_2943_ = type_24();
                                                                phi_2944_ = false;
                                                            } else {
                                                                let _e1270 = select(_e1171[1][0], _e1171[0][0], (_e1171[0][0] < _e1171[1][0]));
                                                                let _e1274 = select(_e1171[1][0], _e1171[0][0], (_e1171[0][0] > _e1171[1][0]));
                                                                let _e1278 = select(_e1171[1][1], _e1171[0][1], (_e1171[0][1] < _e1171[1][1]));
                                                                let _e1282 = select(_e1171[1][1], _e1171[0][1], (_e1171[0][1] > _e1171[1][1]));
                                                                let _e1286 = select(_e1171[1][2], _e1171[0][2], (_e1171[0][2] < _e1171[1][2]));
                                                                let _e1290 = select(_e1171[1][2], _e1171[0][2], (_e1171[0][2] > _e1171[1][2]));
                                                                let _e1295 = ((select(_e1171[2][0], _e1270, (_e1270 < _e1171[2][0])) - _e372) * _e377);
                                                                let _e1296 = ((select(_e1171[2][0], _e1274, (_e1274 > _e1171[2][0])) - _e373) * _e377);
                                                                let _e1299 = ((select(_e1171[2][1], _e1278, (_e1278 < _e1171[2][1])) - _e440) * _e445);
                                                                let _e1300 = ((select(_e1171[2][1], _e1282, (_e1282 > _e1171[2][1])) - _e441) * _e445);
                                                                let _e1303 = ((select(_e1171[2][2], _e1286, (_e1286 < _e1171[2][2])) - _e508) * _e513);
                                                                let _e1304 = ((select(_e1171[2][2], _e1290, (_e1290 > _e1171[2][2])) - _e509) * _e513);
                                                                let _e1306 = select(_e1304, _e1303, (_e1303 < _e1304));
                                                                let _e1308 = select(_e1304, _e1303, (_e1303 > _e1304));
                                                                let _e1310 = select(_e1296, _e1295, (_e1295 < _e1296));
                                                                let _e1312 = select(_e1300, _e1299, (_e1299 < _e1300));
                                                                let _e1314 = select(_e1312, _e1310, (_e1310 > _e1312));
                                                                let _e1316 = select(_e1306, _e1314, (_e1314 > _e1306));
                                                                let _e1318 = select(_e1296, _e1295, (_e1295 > _e1296));
                                                                let _e1320 = select(_e1300, _e1299, (_e1299 > _e1300));
                                                                let _e1322 = select(_e1320, _e1318, (_e1318 < _e1320));
                                                                let _e1324 = select(_e1308, _e1322, (_e1322 < _e1308));
                                                                let _e1325 = -(_e1306);
                                                                let _e1331 = select(_e625, _e1316, (_e1316 > _e625));
                                                                if (_e1331 > (_e1324 + (select(_e1325, _e1308, (_e1308 > _e1325)) * 0.0000019073523f))) {
                                                                    phi_2938_ = type_24();
                                                                    phi_2939_ = true;
                                                                } else {
                                                                    let _e1333 = (_e1331 > _e724.member_1);
                                                                    if _e1333 {
                                                                        phi_2937_ = type_24();
                                                                    } else {
                                                                        let _e1334 = vec3<f32>(_e1171[0][0], _e1171[0][1], _e1171[0][2]);
                                                                        let _e1335 = vec3<f32>(_e1171[1][0], _e1171[1][1], _e1171[1][2]);
                                                                        let _e1336 = vec3<f32>(_e1171[2][0], _e1171[2][1], _e1171[2][2]);
                                                                        let _e1337 = (_e1171[1][0] - _e1171[0][0]);
                                                                        let _e1338 = (_e1171[1][1] - _e1171[0][1]);
                                                                        let _e1339 = (_e1171[1][2] - _e1171[0][2]);
                                                                        let _e1340 = vec3<f32>(_e1337, _e1338, _e1339);
                                                                        let _e1341 = (_e1171[2][0] - _e1171[1][0]);
                                                                        let _e1342 = (_e1171[2][1] - _e1171[1][1]);
                                                                        let _e1343 = (_e1171[2][2] - _e1171[1][2]);
                                                                        let _e1344 = vec3<f32>(_e1341, _e1342, _e1343);
                                                                        let _e1345 = (_e1171[0][0] - _e1171[2][0]);
                                                                        let _e1346 = (_e1171[0][1] - _e1171[2][1]);
                                                                        let _e1347 = (_e1171[0][2] - _e1171[2][2]);
                                                                        let _e1348 = vec3<f32>(_e1345, _e1346, _e1347);
                                                                        let _e1351 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                        let _e1354 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1356 = select(_e1354, _e1351, (_e1351 > _e1354));
                                                                        let _e1359 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                        let _e1361 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                                        let _e1364 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                        let _e1367 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                        let _e1369 = select(_e1367, _e1364, (_e1364 > _e1367));
                                                                        let _e1372 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                        let _e1374 = select(_e1372, _e1369, (_e1369 > _e1372));
                                                                        let _e1377 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                        let _e1380 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                        let _e1382 = select(_e1380, _e1377, (_e1377 > _e1380));
                                                                        let _e1385 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                        let _e1387 = select(_e1385, _e1382, (_e1382 > _e1385));
                                                                        let _e1389 = select(_e1374, _e1361, (_e1361 > _e1374));
                                                                        let _e1391 = select(_e1387, _e1389, (_e1389 > _e1387));
                                                                        if (_e1361 == _e1391) {
                                                                            phi_2664_ = _e1198;
                                                                            phi_2665_ = _e1195;
                                                                            phi_2666_ = _e1185;
                                                                            phi_2667_ = _e1182;
                                                                            phi_2668_ = _e1334;
                                                                            phi_2669_ = _e1348;
                                                                            phi_2670_ = _e1344;
                                                                            phi_2671_ = _e1340;
                                                                        } else {
                                                                            let _e1393 = (_e1374 == _e1391);
                                                                            let _e1398 = vec3(_e1393);
                                                                            phi_2664_ = select(_e1185, _e1211, _e1393);
                                                                            phi_2665_ = select(_e1182, _e1208, _e1393);
                                                                            phi_2666_ = select(_e1211, _e1198, _e1393);
                                                                            phi_2667_ = select(_e1208, _e1195, _e1393);
                                                                            phi_2668_ = select(_e1336, _e1335, _e1398);
                                                                            phi_2669_ = select(_e1344, _e1340, _e1398);
                                                                            phi_2670_ = select(_e1340, _e1348, _e1398);
                                                                            phi_2671_ = select(_e1348, _e1344, _e1398);
                                                                        }
                                                                        let _e1404 = phi_2664_;
                                                                        let _e1406 = phi_2665_;
                                                                        let _e1408 = phi_2666_;
                                                                        let _e1410 = phi_2667_;
                                                                        let _e1412 = phi_2668_;
                                                                        let _e1414 = phi_2669_;
                                                                        let _e1416 = phi_2670_;
                                                                        let _e1418 = phi_2671_;
                                                                        let _e1425 = ((_e1416.y * _e1414.z) - (_e1414.y * _e1416.z));
                                                                        let _e1430 = ((_e1416.z * _e1414.x) - (_e1414.z * _e1416.x));
                                                                        let _e1433 = ((_e1416.x * _e1414.y) - (_e1414.x * _e1416.y));
                                                                        if (_e1233 >= _e1237) {
                                                                            phi_2708_ = select(true, false, (_e1233 >= _e1241));
                                                                        } else {
                                                                            phi_2708_ = true;
                                                                        }
                                                                        let _e1438 = phi_2708_;
                                                                        if _e1438 {
                                                                            phi_2717_ = select(_e1336, _e1335, vec3((_e1237 >= _e1241)));
                                                                        } else {
                                                                            phi_2717_ = _e1334;
                                                                        }
                                                                        let _e1443 = phi_2717_;
                                                                        let _e1454 = (((_e1425 * (_e1443.x - _e334)) + (_e1430 * (_e1443.y - _e403))) + (_e1433 * (_e1443.z - _e471)));
                                                                        let _e1459 = (((_e1425 * _e374) + (_e1430 * _e442)) + (_e1433 * _e510));
                                                                        let _e1460 = (_e1406 - _e1410);
                                                                        let _e1461 = (_e1404 - _e1408);
                                                                        let _e1469 = (-(((_e1410 * _e1460) + (_e1408 * _e1461))) / ((_e1460 * _e1460) + (_e1461 * _e1461)));
                                                                        let _e1471 = select(1f, _e1469, (_e1469 < 1f));
                                                                        let _e1473 = select(0f, _e1471, (_e1471 > 0f));
                                                                        let _e1486 = ((_e1412.x + (_e1418.x * _e1473)) - _e334);
                                                                        let _e1487 = ((_e1412.y + (_e1418.y * _e1473)) - _e403);
                                                                        let _e1488 = ((_e1412.z + (_e1418.z * _e1473)) - _e471);
                                                                        let _e1489 = (_e1488 / _e510);
                                                                        let _e1501 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                                        let _e1504 = bitcast<f32>((bitcast<u32>(_e1487) & 2147483647u));
                                                                        let _e1506 = select(_e1504, _e1501, (_e1501 > _e1504));
                                                                        let _e1509 = bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u));
                                                                        let _e1511 = select(_e1509, _e1506, (_e1506 > _e1509));
                                                                        let _e1517 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                        let _e1520 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                        let _e1522 = select(_e1520, _e1517, (_e1517 > _e1520));
                                                                        let _e1525 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1425 * _e1486) + (_e1430 * _e1487)) + (_e1433 * _e1488)) - _e1454)) & 2147483647u)) <= ((0.0000009536743f * select(_e1391, _e1511, (_e1511 > _e1391))) * select(_e1525, _e1522, (_e1522 > _e1525)))) {
                                                                            let _e1535 = bitcast<f32>((bitcast<u32>(_e1416.x) & 2147483647u));
                                                                            let _e1538 = bitcast<f32>((bitcast<u32>(_e1416.y) & 2147483647u));
                                                                            let _e1540 = select(_e1538, _e1535, (_e1535 > _e1538));
                                                                            let _e1543 = bitcast<f32>((bitcast<u32>(_e1416.z) & 2147483647u));
                                                                            let _e1549 = bitcast<f32>((bitcast<u32>(_e1414.x) & 2147483647u));
                                                                            let _e1552 = bitcast<f32>((bitcast<u32>(_e1414.y) & 2147483647u));
                                                                            let _e1554 = select(_e1552, _e1549, (_e1549 > _e1552));
                                                                            let _e1557 = bitcast<f32>((bitcast<u32>(_e1414.z) & 2147483647u));
                                                                            let _e1561 = (bitcast<f32>((bitcast<u32>(_e1459) & 2147483647u)) > ((0.0000038146973f * select(_e1543, _e1540, (_e1540 > _e1543))) * select(_e1557, _e1554, (_e1554 > _e1557))));
                                                                            if _e1561 {
                                                                                phi_2882_ = (_e1454 / _e1459);
                                                                            } else {
                                                                                phi_2882_ = f32();
                                                                            }
                                                                            let _e1564 = phi_2882_;
                                                                            phi_2884_ = _e1564;
                                                                            phi_2885_ = select(true, false, _e1561);
                                                                        } else {
                                                                            phi_2884_ = f32();
                                                                            phi_2885_ = true;
                                                                        }
                                                                        let _e1567 = phi_2884_;
                                                                        let _e1569 = phi_2885_;
                                                                        if _e1569 {
                                                                            let _e1577 = (((_e1425 * (_e1486 - (_e374 * _e1489))) + (_e1430 * (_e1487 - (_e442 * _e1489)))) / _e1459);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)) <= _e1391) {
                                                                                phi_2905_ = (_e1489 + _e1577);
                                                                            } else {
                                                                                phi_2905_ = _e1489;
                                                                            }
                                                                            let _e1584 = phi_2905_;
                                                                            phi_2906_ = _e1584;
                                                                        } else {
                                                                            phi_2906_ = _e1567;
                                                                        }
                                                                        let _e1586 = phi_2906_;
                                                                        let _e1588 = select(_e1324, _e1586, (_e1586 < _e1324));
                                                                        let _e1590 = select(_e1316, _e1588, (_e1588 > _e1316));
                                                                        if (_e1590 >= _e625) {
                                                                            let _e1592 = (_e1590 <= _e724.member_1);
                                                                            if _e1592 {
                                                                                let _e1593 = (1f / _e1243);
                                                                                phi_2929_ = type_24(_e1590, (_e1237 * _e1593), (_e1241 * _e1593), _e784);
                                                                            } else {
                                                                                phi_2929_ = type_24();
                                                                            }
                                                                            let _e1598 = phi_2929_;
                                                                            phi_2931_ = _e1598;
                                                                            phi_2932_ = select(true, false, _e1592);
                                                                        } else {
                                                                            phi_2931_ = type_24();
                                                                            phi_2932_ = true;
                                                                        }
                                                                        let _e1601 = phi_2931_;
                                                                        let _e1603 = phi_2932_;
                                                                        if _e1603 {
                                                                            phi_2936_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2936_ = _e1601;
                                                                        }
                                                                        let _e1605 = phi_2936_;
                                                                        phi_2937_ = _e1605;
                                                                    }
                                                                    let _e1607 = phi_2937_;
                                                                    phi_2938_ = _e1607;
                                                                    phi_2939_ = _e1333;
                                                                }
                                                                let _e1609 = phi_2938_;
                                                                let _e1611 = phi_2939_;
                                                                phi_2943_ = _e1609;
                                                                phi_2944_ = _e1611;
                                                            }
                                                            let _e1613 = phi_2943_;
                                                            let _e1615 = phi_2944_;
                                                            phi_2945_ = _e1613;
                                                            phi_2946_ = _e1268;
                                                            phi_2947_ = _e1615;
                                                        }
                                                        let _e1617 = phi_2945_;
                                                        let _e1619 = phi_2946_;
                                                        let _e1621 = phi_2947_;
                                                        phi_2948_ = _e1617;
                                                        phi_2949_ = _e1619;
                                                        phi_2950_ = _e1621;
                                                    }
                                                    let _e1623 = phi_2948_;
                                                    let _e1625 = phi_2949_;
                                                    let _e1627 = phi_2950_;
                                                    phi_2958_ = _e1623;
                                                    phi_2959_ = select(_e1627, true, _e1625);
                                                } else {
                                                    phi_2958_ = type_24();
                                                    phi_2959_ = true;
                                                }
                                                let _e1630 = phi_2958_;
                                                let _e1632 = phi_2959_;
                                                if _e1632 {
                                                    phi_2963_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2963_ = _e1630;
                                                }
                                                let _e1634 = phi_2963_;
                                                if (_e1634.member_3 != 4294967295u) {
                                                    if (_e784 != 4294967295u) {
                                                        if (_e1634.member < _e724.member.member) {
                                                            phi_2989_ = true;
                                                        } else {
                                                            if (_e1634.member == _e724.member.member) {
                                                                phi_2988_ = (_e1634.member_3 < _e724.member.member_3);
                                                            } else {
                                                                phi_2988_ = false;
                                                            }
                                                            let _e1647 = phi_2988_;
                                                            phi_2989_ = _e1647;
                                                        }
                                                        let _e1649 = phi_2989_;
                                                        if _e1649 {
                                                            phi_2995_ = type_37(_e1634, _e1634.member);
                                                        } else {
                                                            phi_2995_ = _e724;
                                                        }
                                                        let _e1652 = phi_2995_;
                                                        phi_2996_ = _e1652;
                                                    } else {
                                                        phi_2996_ = _e724;
                                                    }
                                                    let _e1654 = phi_2996_;
                                                    phi_2997_ = _e1654;
                                                } else {
                                                    phi_2997_ = _e724;
                                                }
                                                let _e1656 = phi_2997_;
                                                phi_1301_ = _e1656;
                                            } else {
                                                phi_1301_ = type_37();
                                            }
                                            let _e1658 = phi_1301_;
                                            continue;
                                            continuing {
                                                phi_1300_ = _e1658;
                                                phi_1303_ = _e739;
                                                phi_4642_ = _e667;
                                                break if !(_e745);
                                            }
                                        }
                                        let _e1661 = phi_4642_;
                                        phi_4849_ = _e1661;
                                        if _e1661 {
                                            break;
                                        }
                                        phi_4940_ = _e1661;
                                        let _e2430 = local_11;
                                        phi_2998_ = _e2430;
                                    } else {
                                        phi_4940_ = _e667;
                                        phi_2998_ = _e669;
                                    }
                                    let _e1663 = phi_4940_;
                                    let _e1665 = phi_2998_;
                                    if _e716 {
                                        phi_4263_ = bool();
                                        phi_4264_ = u32();
                                        phi_4265_ = type_49();
                                    } else {
                                        if (_e712.member_1 >= _e99) {
                                            phi_3799_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e712.member_1 < _e99) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1669 = ((1u + _e270) % 4u);
                                            if (_e1669 < 4u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1674 = global_3.member[_e712.member_1][_e1669];
                                            let _e1676 = (_e1674 >> bitcast<u32>(11u));
                                            let _e1678 = ((1u + _e269) % 4u);
                                            if (_e1678 < 4u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1683 = global_3.member[_e712.member_1][_e1678];
                                            let _e1685 = (_e1683 >> bitcast<u32>(11u));
                                            let _e1687 = ((1u + _e271) % 4u);
                                            if (_e1687 < 4u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1692 = global_3.member[_e712.member_1][_e1687];
                                            let _e1694 = (_e1692 >> bitcast<u32>(11u));
                                            let _e1717 = (bitcast<f32>((bitcast<u32>((_e712.member.member_1.x - _e712.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1718 = (bitcast<f32>((bitcast<u32>((_e712.member.member_1.y - _e712.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1719 = (bitcast<f32>((bitcast<u32>((_e712.member.member_1.z - _e712.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1721 = select(_e150, _e1717, (_e1717 > _e150));
                                            let _e1723 = select(_e150, _e1718, (_e1718 > _e150));
                                            let _e1725 = select(_e150, _e1719, (_e1719 > _e150));
                                            let _e1756 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1674 & 1023u))) - 8388608f) * _e1721));
                                            let _e1761 = (bitcast<i32>((_e1674 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1764 = bitcast<f32>((_e1756 & bitcast<u32>(_e1761)));
                                            let _e1765 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1683 & 1023u))) - 8388608f) * _e1723));
                                            let _e1770 = (bitcast<i32>((_e1683 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1773 = bitcast<f32>((_e1765 & bitcast<u32>(_e1770)));
                                            let _e1774 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1692 & 1023u))) - 8388608f) * _e1725));
                                            let _e1779 = (bitcast<i32>((_e1692 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1782 = bitcast<f32>((_e1774 & bitcast<u32>(_e1779)));
                                            let _e1786 = bitcast<f32>((_e1756 & bitcast<u32>(~(_e1761))));
                                            let _e1790 = bitcast<f32>((_e1765 & bitcast<u32>(~(_e1770))));
                                            let _e1794 = bitcast<f32>((_e1774 & bitcast<u32>(~(_e1779))));
                                            let _e1795 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1676 & 1023u))) - 8388608f) * _e1721));
                                            let _e1800 = (bitcast<i32>((_e1676 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1803 = bitcast<f32>((_e1795 & bitcast<u32>(_e1800)));
                                            let _e1804 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1685 & 1023u))) - 8388608f) * _e1723));
                                            let _e1809 = (bitcast<i32>((_e1685 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1812 = bitcast<f32>((_e1804 & bitcast<u32>(_e1809)));
                                            let _e1813 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1694 & 1023u))) - 8388608f) * _e1725));
                                            let _e1818 = (bitcast<i32>((_e1694 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1821 = bitcast<f32>((_e1813 & bitcast<u32>(_e1818)));
                                            let _e1825 = bitcast<f32>((_e1795 & bitcast<u32>(~(_e1800))));
                                            let _e1829 = bitcast<f32>((_e1804 & bitcast<u32>(~(_e1809))));
                                            let _e1833 = bitcast<f32>((_e1813 & bitcast<u32>(~(_e1818))));
                                            let _e1834 = (_e712.member.member.x + _e1764);
                                            let _e1835 = (_e712.member.member.y + _e1773);
                                            let _e1836 = (_e712.member.member.z + _e1782);
                                            let _e1839 = (_e712.member.member_1.x - _e1803);
                                            let _e1840 = (_e712.member.member_1.y - _e1812);
                                            let _e1841 = (_e712.member.member_1.z - _e1821);
                                            let _e1860 = (_e1839 - _e1834);
                                            let _e1861 = (_e1840 - _e1835);
                                            let _e1862 = (_e1841 - _e1836);
                                            let _e1864 = select(_e1861, _e1860, (_e1860 > _e1861));
                                            let _e1866 = select(_e1862, _e1864, (_e1864 > _e1862));
                                            if (_e1866 < (1024f * _e150)) {
                                                phi_3500_ = 0u;
                                            } else {
                                                phi_3500_ = select(2u, 1u, (_e1866 < (2097152f * _e150)));
                                            }
                                            let _e1873 = phi_3500_;
                                            switch bitcast<i32>(_e1873) {
                                                case 0: {
                                                    phi_3506_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3506_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3506_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3506_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1876 = phi_3506_;
                                            let _e1882 = global_3.member[_e712.member_1][0u];
                                            let _e1886 = global_3.member[_e712.member_1][1u];
                                            let _e1890 = global_3.member[_e712.member_1][2u];
                                            let _e1894 = global_3.member[_e712.member_1][3u];
                                            let _e1906 = (((_e1886 >> bitcast<u32>(22i)) | ((_e1890 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1894 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1907 = (_e1882 & 268435455u);
                                            let _e1908 = (_e1906 & 268435455u);
                                            let _e1911 = ((_e1882 >> bitcast<u32>(28u)) & 7u);
                                            let _e1919 = ((_e1882 >> bitcast<u32>(31i)) | (((_e1906 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1920 = (_e1911 != 0u);
                                            if (_e1911 == 0u) {
                                                phi_3761_ = _e1907;
                                            } else {
                                                if (_e1911 == 7u) {
                                                    phi_3760_ = 2147483648u;
                                                } else {
                                                    phi_3760_ = ((2147483648u | (_e1911 << bitcast<u32>(28u))) | (_e1908 & 268435455u));
                                                }
                                                let _e1929 = phi_3760_;
                                                phi_3761_ = _e1929;
                                            }
                                            let _e1931 = phi_3761_;
                                            if _e1920 {
                                                let _e1932 = (_e1911 != 7u);
                                                if _e1932 {
                                                    phi_3771_ = (_e1908 + (_e1911 * ((3u * _e1876) + 1u)));
                                                } else {
                                                    phi_3771_ = u32();
                                                }
                                                let _e1936 = phi_3771_;
                                                phi_3773_ = _e1936;
                                                phi_3774_ = select(true, false, _e1932);
                                            } else {
                                                phi_3773_ = u32();
                                                phi_3774_ = true;
                                            }
                                            let _e1939 = phi_3773_;
                                            let _e1941 = phi_3774_;
                                            if (_e1919 == 0u) {
                                                phi_3795_ = (_e1907 + select(0u, 1u, !(_e1920)));
                                            } else {
                                                if (_e1919 == 7u) {
                                                    phi_3794_ = 2147483648u;
                                                } else {
                                                    phi_3794_ = ((2147483648u | (_e1919 << bitcast<u32>(28u))) | (select(_e1939, _e1908, _e1941) & 268435455u));
                                                }
                                                let _e1954 = phi_3794_;
                                                phi_3795_ = _e1954;
                                            }
                                            let _e1956 = phi_3795_;
                                            phi_3799_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e1834, (_e712.member.member.x + _e1786), _e1839, (_e712.member.member_1.x - _e1825)), vec4<f32>(_e1835, (_e712.member.member.y + _e1790), _e1840, (_e712.member.member_1.y - _e1829)), vec4<f32>(_e1836, (_e712.member.member.z + _e1794), _e1841, (_e712.member.member_1.z - _e1833))), type_49(type_32((_e712.member.member + vec4<f32>(_e1764, _e1773, _e1782, 0f)), (_e712.member.member_1 - vec4<f32>(_e1803, _e1812, _e1821, 0f))), _e1931), type_49(type_32((_e712.member.member + vec4<f32>(_e1786, _e1790, _e1794, 0f)), (_e712.member.member_1 - vec4<f32>(_e1825, _e1829, _e1833, 0f))), _e1956));
                                        }
                                        let _e1961 = phi_3799_;
                                        let _e1973 = ((_e1961.member[0].x - _e372) * _e377);
                                        let _e1974 = ((_e1961.member[0].y - _e372) * _e377);
                                        let _e1975 = ((_e1961.member[0].z - _e373) * _e377);
                                        let _e1976 = ((_e1961.member[0].w - _e373) * _e377);
                                        let _e1986 = ((_e1961.member[1].x - _e440) * _e445);
                                        let _e1987 = ((_e1961.member[1].y - _e440) * _e445);
                                        let _e1988 = ((_e1961.member[1].z - _e441) * _e445);
                                        let _e1989 = ((_e1961.member[1].w - _e441) * _e445);
                                        let _e1999 = ((_e1961.member[2].x - _e508) * _e513);
                                        let _e2000 = ((_e1961.member[2].y - _e508) * _e513);
                                        let _e2001 = ((_e1961.member[2].z - _e509) * _e513);
                                        let _e2002 = ((_e1961.member[2].w - _e509) * _e513);
                                        let _e2004 = select(_e2001, _e1999, (_e1999 < _e2001));
                                        let _e2006 = select(_e2002, _e2000, (_e2000 < _e2002));
                                        let _e2008 = select(_e2001, _e1999, (_e1999 > _e2001));
                                        let _e2010 = select(_e2002, _e2000, (_e2000 > _e2002));
                                        let _e2012 = select(_e1975, _e1973, (_e1973 < _e1975));
                                        let _e2014 = select(_e1976, _e1974, (_e1974 < _e1976));
                                        let _e2016 = select(_e1988, _e1986, (_e1986 < _e1988));
                                        let _e2018 = select(_e1989, _e1987, (_e1987 < _e1989));
                                        let _e2020 = select(_e2016, _e2012, (_e2012 > _e2016));
                                        let _e2022 = select(_e2018, _e2014, (_e2014 > _e2018));
                                        let _e2024 = select(_e2004, _e2020, (_e2020 > _e2004));
                                        let _e2026 = select(_e2006, _e2022, (_e2022 > _e2006));
                                        let _e2028 = select(_e1975, _e1973, (_e1973 > _e1975));
                                        let _e2030 = select(_e1976, _e1974, (_e1974 > _e1976));
                                        let _e2032 = select(_e1988, _e1986, (_e1986 > _e1988));
                                        let _e2034 = select(_e1989, _e1987, (_e1987 > _e1989));
                                        let _e2036 = select(_e2032, _e2028, (_e2028 < _e2032));
                                        let _e2038 = select(_e2034, _e2030, (_e2030 < _e2034));
                                        let _e2043 = -(_e2004);
                                        let _e2044 = -(_e2006);
                                        let _e2051 = (select(_e2008, _e2036, (_e2036 < _e2008)) + (select(_e2043, _e2008, (_e2008 > _e2043)) * 0.0000019073523f));
                                        let _e2052 = (select(_e2010, _e2038, (_e2038 < _e2010)) + (select(_e2044, _e2010, (_e2010 > _e2044)) * 0.0000019073523f));
                                        let _e2054 = select(_e625, _e2024, (_e2024 > _e625));
                                        let _e2056 = select(_e625, _e2026, (_e2026 > _e625));
                                        let _e2061 = (_e2054 <= select(_e1665.member_1, _e2051, (_e2051 < _e1665.member_1)));
                                        let _e2062 = (_e2056 <= select(_e1665.member_1, _e2052, (_e2052 < _e1665.member_1)));
                                        let _e2063 = (_e2054 <= _e2056);
                                        if _e2061 {
                                            if _e2062 {
                                                if _e2063 {
                                                    phi_4161_ = _e1961.member_2;
                                                } else {
                                                    phi_4161_ = _e1961.member_1;
                                                }
                                                let _e2067 = phi_4161_;
                                                let _e2088 = (_e710 % 128u);
                                                let _e2089 = (_e2088 < 128u);
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_8[_e2088] = _e2067.member_1;
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_7[_e2088] = _e2067.member.member.x;
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_6[_e2088] = _e2067.member.member.y;
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_5[_e2088] = _e2067.member.member.z;
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_4[_e2088] = _e2067.member.member_1.x;
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_3[_e2088] = _e2067.member.member_1.y;
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_2[_e2088] = _e2067.member.member_1.z;
                                                if _e2089 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_9[_e2088] = select(_e2054, _e2056, _e2063);
                                                if _e2063 {
                                                    phi_4237_ = _e1961.member_1;
                                                } else {
                                                    phi_4237_ = _e1961.member_2;
                                                }
                                                let _e2102 = phi_4237_;
                                                phi_4238_ = (_e710 + 1u);
                                                phi_4239_ = _e2102;
                                            } else {
                                                phi_4238_ = u32();
                                                phi_4239_ = type_49();
                                            }
                                            let _e2104 = phi_4238_;
                                            let _e2106 = phi_4239_;
                                            phi_4241_ = _e2104;
                                            phi_4242_ = _e2106;
                                            phi_4243_ = select(true, false, _e2062);
                                        } else {
                                            phi_4241_ = u32();
                                            phi_4242_ = type_49();
                                            phi_4243_ = true;
                                        }
                                        let _e2109 = phi_4241_;
                                        let _e2111 = phi_4242_;
                                        let _e2113 = phi_4243_;
                                        if _e2113 {
                                            if _e2061 {
                                                phi_4252_ = _e1961.member_1;
                                            } else {
                                                phi_4252_ = _e1961.member_2;
                                            }
                                            let _e2117 = phi_4252_;
                                            phi_4257_ = select(_e2062, true, _e2061);
                                            phi_4259_ = _e2117;
                                        } else {
                                            phi_4257_ = _e708;
                                            phi_4259_ = _e2111;
                                        }
                                        let _e2120 = phi_4257_;
                                        let _e2122 = phi_4259_;
                                        phi_4263_ = _e2120;
                                        phi_4264_ = select(_e2109, _e710, _e2113);
                                        phi_4265_ = _e2122;
                                    }
                                    let _e2125 = phi_4263_;
                                    let _e2127 = phi_4264_;
                                    let _e2129 = phi_4265_;
                                    if _e716 {
                                        phi_4275_ = _e712;
                                    } else {
                                        phi_4275_ = _e2129;
                                    }
                                    let _e2131 = phi_4275_;
                                    phi_4852_ = _e1663;
                                    phi_4276_ = _e1665;
                                    phi_4277_ = (_e671 - 1u);
                                    phi_4278_ = select(_e2125, false, _e716);
                                    phi_4279_ = select(_e2127, _e710, _e716);
                                    phi_4280_ = _e2131;
                                } else {
                                    phi_4852_ = _e667;
                                    phi_4276_ = _e669;
                                    phi_4277_ = _e671;
                                    phi_4278_ = _e708;
                                    phi_4279_ = _e710;
                                    phi_4280_ = _e712;
                                }
                                let _e2135 = phi_4852_;
                                let _e2137 = phi_4276_;
                                let _e2139 = phi_4277_;
                                let _e2141 = phi_4278_;
                                let _e2143 = phi_4279_;
                                let _e2145 = phi_4280_;
                                phi_4851_ = _e2135;
                                phi_4281_ = _e2137;
                                phi_4282_ = _e2139;
                                phi_4283_ = _e2141;
                                phi_4284_ = _e2143;
                                phi_4285_ = _e2145;
                            } else {
                                phi_4851_ = _e667;
                                phi_4281_ = type_37();
                                phi_4282_ = u32();
                                phi_4283_ = bool();
                                phi_4284_ = u32();
                                phi_4285_ = type_49();
                            }
                            let _e2147 = phi_4851_;
                            let _e2149 = phi_4281_;
                            let _e2151 = phi_4282_;
                            let _e2153 = phi_4283_;
                            let _e2155 = phi_4284_;
                            let _e2157 = phi_4285_;
                            phi_4850_ = _e2147;
                            phi_1174_ = _e2149;
                            phi_1177_ = _e2151;
                            phi_1179_ = _e2153;
                            phi_1181_ = _e2155;
                            phi_1183_ = _e2157;
                            phi_4286_ = _e681;
                        } else {
                            phi_4850_ = _e667;
                            phi_1174_ = type_37();
                            phi_1177_ = u32();
                            phi_1179_ = bool();
                            phi_1181_ = u32();
                            phi_1183_ = type_49();
                            phi_4286_ = false;
                        }
                        let _e2159 = phi_4850_;
                        let _e2161 = phi_1174_;
                        let _e2163 = phi_1177_;
                        let _e2165 = phi_1179_;
                        let _e2167 = phi_1181_;
                        let _e2169 = phi_1183_;
                        let _e2171 = phi_4286_;
                        continue;
                        continuing {
                            phi_4648_ = _e2159;
                            phi_1173_ = _e2161;
                            phi_1176_ = _e2163;
                            phi_1178_ = _e2165;
                            phi_1180_ = _e2167;
                            phi_1182_ = _e2169;
                            phi_4849_ = _e2159;
                            break if !(_e2171);
                        }
                    }
                    let _e2174 = phi_4849_;
                    if _e2174 {
                        break;
                    }
                    let _e2176 = local_10;
                    if (_e2176.member.member_3 != 4294967295u) {
                        let _e2181 = -(_e527);
                        let _e2182 = bitcast<u32>(_e2176.member.member);
                        let _e2186 = (bitcast<i32>((_e2182 >> bitcast<u32>(23i))) & 255i);
                        let _e2187 = (_e2186 + _e2181);
                        if (_e2186 == 255i) {
                            phi_4345_ = _e2176.member.member;
                        } else {
                            if (_e2186 > 0i) {
                                if (_e2187 > 0i) {
                                    let _e2191 = (_e2187 < 255i);
                                    if _e2191 {
                                        phi_4324_ = bitcast<f32>((_e2182 + bitcast<u32>((_e2181 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4324_ = f32();
                                    }
                                    let _e2198 = phi_4324_;
                                    phi_4326_ = _e2198;
                                    phi_4327_ = select(true, false, _e2191);
                                } else {
                                    phi_4326_ = f32();
                                    phi_4327_ = true;
                                }
                                let _e2201 = phi_4326_;
                                let _e2203 = phi_4327_;
                                phi_4328_ = _e2201;
                                phi_4329_ = _e2203;
                            } else {
                                phi_4328_ = f32();
                                phi_4329_ = true;
                            }
                            let _e2205 = phi_4328_;
                            let _e2207 = phi_4329_;
                            if _e2207 {
                                let _e2208 = (_e2182 & 2147483648u);
                                let _e2215 = ((_e2182 & 8388607u) | (select(0u, 1u, ((_e2182 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2219 = (_e2215 == 0u);
                                if _e2219 {
                                    phi_4600_ = bitcast<f32>(_e2208);
                                } else {
                                    let _e2224 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2215)), 32u, _e2219) - 8u);
                                    let _e2227 = (_e2215 << bitcast<u32>((_e2224 & 31u)));
                                    let _e2229 = ((_e2187 + select(0i, 1i, (_e2186 == 0i))) - bitcast<i32>(_e2224));
                                    if (_e2229 >= 255i) {
                                        phi_4590_ = bitcast<f32>((_e2208 | 2139095040u));
                                        phi_4591_ = f32();
                                        phi_4592_ = true;
                                    } else {
                                        let _e2231 = (_e2229 > 0i);
                                        if _e2231 {
                                            phi_4584_ = bitcast<f32>(((_e2208 | (bitcast<u32>(_e2229) << bitcast<u32>(23i))) | (_e2227 & 8388607u)));
                                            phi_4585_ = f32();
                                        } else {
                                            if (_e2229 < -24i) {
                                                phi_4550_ = 26u;
                                            } else {
                                                phi_4550_ = bitcast<u32>((1i - _e2229));
                                            }
                                            let _e2236 = phi_4550_;
                                            let _e2237 = (_e2236 & 31u);
                                            let _e2239 = (_e2227 >> bitcast<u32>(_e2237));
                                            let _e2243 = (_e2227 & ((1u << bitcast<u32>(_e2237)) - 1u));
                                            let _e2247 = (1u << bitcast<u32>(((_e2236 - 1u) & 31u)));
                                            if (_e2243 > _e2247) {
                                                phi_4571_ = true;
                                            } else {
                                                if (_e2243 == _e2247) {
                                                    phi_4568_ = ((_e2239 & 1u) == 1u);
                                                } else {
                                                    phi_4568_ = false;
                                                }
                                                let _e2253 = phi_4568_;
                                                phi_4571_ = _e2253;
                                            }
                                            let _e2255 = phi_4571_;
                                            phi_4584_ = f32();
                                            phi_4585_ = bitcast<f32>((_e2208 | (_e2239 + select(0u, 1u, _e2255))));
                                        }
                                        let _e2268 = phi_4584_;
                                        let _e2270 = phi_4585_;
                                        phi_4590_ = _e2268;
                                        phi_4591_ = _e2270;
                                        phi_4592_ = _e2231;
                                    }
                                    let _e2274 = phi_4590_;
                                    let _e2276 = phi_4591_;
                                    let _e2278 = phi_4592_;
                                    phi_4600_ = select(_e2276, _e2274, _e2278);
                                }
                                let _e2282 = phi_4600_;
                                phi_4344_ = _e2282;
                            } else {
                                phi_4344_ = _e2205;
                            }
                            let _e2284 = phi_4344_;
                            phi_4345_ = _e2284;
                        }
                        let _e2286 = phi_4345_;
                        let _e2287 = bitcast<u32>(_e2286);
                        if ((_e2287 & 2147483647u) >= 2139095040u) {
                            phi_4357_ = bitcast<f32>(((_e2287 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4357_ = _e2286;
                        }
                        let _e2294 = phi_4357_;
                        phi_4362_ = type_24(_e2294, _e2176.member.member_1, _e2176.member.member_2, _e2176.member.member_3);
                    } else {
                        phi_4362_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2299 = phi_4362_;
                    if _e158 {
                    } else {
                        break;
                    }
                    global_6.member[_e156] = _e2299;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
